"""What glut gives.  Written by ``python -m glsim.gl.generate``; do not edit."""

from collections.abc import Callable
from typing import Any
from glsim.machine.constants import Enum
from glsim.glut.fonts import BitmapFont
from glsim.glut.fonts import StrokeFont
from glsim.glut.menus import glutAddMenuEntry as glutAddMenuEntry
from glsim.glut.menus import glutAddSubMenu as glutAddSubMenu
from glsim.glut.menus import glutAttachMenu as glutAttachMenu
from glsim.glut.fonts import glutBitmapCharacter as glutBitmapCharacter
from glsim.glut.fonts import glutBitmapHeight as glutBitmapHeight
from glsim.glut.fonts import glutBitmapLength as glutBitmapLength
from glsim.glut.fonts import glutBitmapString as glutBitmapString
from glsim.glut.fonts import glutBitmapWidth as glutBitmapWidth
from glsim.glut.menus import glutChangeToMenuEntry as glutChangeToMenuEntry
from glsim.glut.menus import glutChangeToSubMenu as glutChangeToSubMenu
from glsim.glut.api import glutMainLoopEvent as glutCheckLoop
from glsim.glut.state import glutCopyColormap as glutCopyColormap
from glsim.glut.menus import glutCreateMenu as glutCreateMenu
from glsim.glut.windows import glutCreateSubWindow as glutCreateSubWindow
from glsim.glut.windows import glutCreateWindow as glutCreateWindow
from glsim.glut.menus import glutDestroyMenu as glutDestroyMenu
from glsim.glut.windows import glutDestroyWindow as glutDestroyWindow
from glsim.glut.menus import glutDetachMenu as glutDetachMenu
from glsim.glut.state import glutDeviceGet as glutDeviceGet
from glsim.glut.state import glutEnterGameMode as glutEnterGameMode
from glsim.glut.state import glutEstablishOverlay as glutEstablishOverlay
from glsim.glut.api import glutExit as glutExit
from glsim.glut.state import glutExtensionSupported as glutExtensionSupported
from glsim.glut.state import glutForceJoystickFunc as glutForceJoystickFunc
from glsim.glut.windows import glutFullScreen as glutFullScreen
from glsim.glut.windows import glutFullScreenToggle as glutFullScreenToggle
from glsim.glut.state import glutGameModeGet as glutGameModeGet
from glsim.glut.state import glutGameModeString as glutGameModeString
from glsim.glut.state import glutGet as glutGet
from glsim.glut.state import glutGetColor as glutGetColor
from glsim.glut.menus import glutGetMenu as glutGetMenu
from glsim.glut.menus import glutGetMenuData as glutGetMenuData
from glsim.glut.state import glutGetModeValues as glutGetModeValues
from glsim.glut.state import glutGetModifiers as glutGetModifiers
from glsim.glut.state import glutGetProcAddress as glutGetProcAddress
from glsim.glut.windows import glutGetWindow as glutGetWindow
from glsim.glut.windows import glutGetWindowData as glutGetWindowData
from glsim.glut.state import glutRemoveOverlay as glutHideOverlay
from glsim.glut.windows import glutHideWindow as glutHideWindow
from glsim.glut.windows import glutHideWindow as glutIconifyWindow
from glsim.glut.callbacks import glutIdleFunc as glutIdleFunc
from glsim.glut.state import glutIgnoreKeyRepeat as glutIgnoreKeyRepeat
from glsim.glut.api import glutInit as glutInit
from glsim.glut.api import glutInitContextFlags as glutInitContextFlags
from glsim.glut.api import glutInitContextProfile as glutInitContextProfile
from glsim.glut.api import glutInitContextVersion as glutInitContextVersion
from glsim.glut.api import glutInitDisplayMode as glutInitDisplayMode
from glsim.glut.api import glutInitDisplayString as glutInitDisplayString
from glsim.glut.api import glutInitErrorFunc as glutInitErrorFunc
from glsim.glut.api import glutInitErrorFunc as glutInitWarningFunc
from glsim.glut.api import glutInitWindowPosition as glutInitWindowPosition
from glsim.glut.api import glutInitWindowSize as glutInitWindowSize
from glsim.glut.state import glutLayerGet as glutLayerGet
from glsim.glut.windows import glutLeaveFullScreen as glutLeaveFullScreen
from glsim.glut.state import glutLeaveGameMode as glutLeaveGameMode
from glsim.glut.api import glutLeaveMainLoop as glutLeaveMainLoop
from glsim.glut.api import glutMainLoop as glutMainLoop
from glsim.glut.api import glutMainLoopEvent as glutMainLoopEvent
from glsim.glut.callbacks import glutMenuStatusFunc as glutMenuDestroyFunc
from glsim.glut.callbacks import glutMenuStatusFunc as glutMenuStateFunc
from glsim.glut.callbacks import glutMenuStatusFunc as glutMenuStatusFunc
from glsim.glut.windows import glutPopWindow as glutPopWindow
from glsim.glut.windows import glutPositionWindow as glutPositionWindow
from glsim.glut.state import glutRemoveOverlay as glutPostOverlayRedisplay
from glsim.glut.windows import glutPostRedisplay as glutPostRedisplay
from glsim.glut.state import glutPostWindowOverlayRedisplay as glutPostWindowOverlayRedisplay
from glsim.glut.windows import glutPostWindowRedisplay as glutPostWindowRedisplay
from glsim.glut.windows import glutPopWindow as glutPushWindow
from glsim.glut.menus import glutRemoveMenuItem as glutRemoveMenuItem
from glsim.glut.state import glutRemoveOverlay as glutRemoveOverlay
from glsim.glut.state import glutReportErrors as glutReportErrors
from glsim.glut.windows import glutReshapeWindow as glutReshapeWindow
from glsim.glut.state import glutSetColor as glutSetColor
from glsim.glut.windows import glutSetCursor as glutSetCursor
from glsim.glut.windows import glutSetIconTitle as glutSetIconTitle
from glsim.glut.state import glutIgnoreKeyRepeat as glutSetKeyRepeat
from glsim.glut.menus import glutSetMenu as glutSetMenu
from glsim.glut.menus import glutSetMenuData as glutSetMenuData
from glsim.glut.api import glutSetOption as glutSetOption
from glsim.glut.windows import glutSetWindow as glutSetWindow
from glsim.glut.windows import glutSetWindowData as glutSetWindowData
from glsim.glut.windows import glutSetWindowTitle as glutSetWindowTitle
from glsim.glut.state import glutSetupVideoResizing as glutSetupVideoResizing
from glsim.glut.state import glutRemoveOverlay as glutShowOverlay
from glsim.glut.windows import glutShowWindow as glutShowWindow
from glsim.glut.revolved import glutSolidCone as glutSolidCone
from glsim.glut.polyhedra import glutSolidCube as glutSolidCube
from glsim.glut.revolved import glutSolidCylinder as glutSolidCylinder
from glsim.glut.polyhedra import glutSolidDodecahedron as glutSolidDodecahedron
from glsim.glut.polyhedra import glutSolidIcosahedron as glutSolidIcosahedron
from glsim.glut.polyhedra import glutSolidOctahedron as glutSolidOctahedron
from glsim.glut.polyhedra import glutSolidRhombicDodecahedron as glutSolidRhombicDodecahedron
from glsim.glut.polyhedra import glutSolidSierpinskiSponge as glutSolidSierpinskiSponge
from glsim.glut.revolved import glutSolidSphere as glutSolidSphere
from glsim.glut.teaset import glutSolidTeacup as glutSolidTeacup
from glsim.glut.teaset import glutSolidTeapot as glutSolidTeapot
from glsim.glut.teaset import glutSolidTeaspoon as glutSolidTeaspoon
from glsim.glut.polyhedra import glutSolidTetrahedron as glutSolidTetrahedron
from glsim.glut.revolved import glutSolidTorus as glutSolidTorus
from glsim.glut.state import glutSetupVideoResizing as glutStopVideoResizing
from glsim.glut.fonts import glutStrokeCharacter as glutStrokeCharacter
from glsim.glut.fonts import glutStrokeHeight as glutStrokeHeight
from glsim.glut.fonts import glutStrokeLength as glutStrokeLength
from glsim.glut.fonts import glutStrokeLengthf as glutStrokeLengthf
from glsim.glut.fonts import glutStrokeString as glutStrokeString
from glsim.glut.fonts import glutStrokeWidth as glutStrokeWidth
from glsim.glut.fonts import glutStrokeWidthf as glutStrokeWidthf
from glsim.glut.windows import glutSwapBuffers as glutSwapBuffers
from glsim.glut.callbacks import glutTimerFunc as glutTimerFunc
from glsim.glut.state import glutUseLayer as glutUseLayer
from glsim.glut.state import glutVideoResize as glutVideoPan
from glsim.glut.state import glutVideoResize as glutVideoResize
from glsim.glut.state import glutVideoResizeGet as glutVideoResizeGet
from glsim.glut.windows import glutWarpPointer as glutWarpPointer
from glsim.glut.revolved import glutWireCone as glutWireCone
from glsim.glut.polyhedra import glutWireCube as glutWireCube
from glsim.glut.revolved import glutWireCylinder as glutWireCylinder
from glsim.glut.polyhedra import glutWireDodecahedron as glutWireDodecahedron
from glsim.glut.polyhedra import glutWireIcosahedron as glutWireIcosahedron
from glsim.glut.polyhedra import glutWireOctahedron as glutWireOctahedron
from glsim.glut.polyhedra import glutWireRhombicDodecahedron as glutWireRhombicDodecahedron
from glsim.glut.polyhedra import glutWireSierpinskiSponge as glutWireSierpinskiSponge
from glsim.glut.revolved import glutWireSphere as glutWireSphere
from glsim.glut.teaset import glutWireTeacup as glutWireTeacup
from glsim.glut.teaset import glutWireTeapot as glutWireTeapot
from glsim.glut.teaset import glutWireTeaspoon as glutWireTeaspoon
from glsim.glut.polyhedra import glutWireTetrahedron as glutWireTetrahedron
from glsim.glut.revolved import glutWireTorus as glutWireTorus

__all__ = [
    "GLUT_3_2_CORE_PROFILE",
    "GLUT_ACCUM",
    "GLUT_ACTION_CONTINUE_EXECUTION",
    "GLUT_ACTION_EXIT",
    "GLUT_ACTION_GLUTMAINLOOP_RETURNS",
    "GLUT_ACTION_ON_WINDOW_CLOSE",
    "GLUT_ACTIVE_ALT",
    "GLUT_ACTIVE_CTRL",
    "GLUT_ACTIVE_SHIFT",
    "GLUT_ALLOW_DIRECT_CONTEXT",
    "GLUT_ALPHA",
    "GLUT_API_VERSION",
    "GLUT_AUX",
    "GLUT_AUX1",
    "GLUT_AUX2",
    "GLUT_AUX3",
    "GLUT_AUX4",
    "GLUT_BITMAP_8_BY_13",
    "GLUT_BITMAP_9_BY_15",
    "GLUT_BITMAP_HELVETICA_10",
    "GLUT_BITMAP_HELVETICA_12",
    "GLUT_BITMAP_HELVETICA_18",
    "GLUT_BITMAP_TIMES_ROMAN_10",
    "GLUT_BITMAP_TIMES_ROMAN_24",
    "GLUT_BLUE",
    "GLUT_BORDERLESS",
    "GLUT_CAPTIONLESS",
    "GLUT_COMPATIBILITY_PROFILE",
    "GLUT_CORE_PROFILE",
    "GLUT_CREATE_NEW_CONTEXT",
    "GLUT_CURSOR_BOTTOM_LEFT_CORNER",
    "GLUT_CURSOR_BOTTOM_RIGHT_CORNER",
    "GLUT_CURSOR_BOTTOM_SIDE",
    "GLUT_CURSOR_CROSSHAIR",
    "GLUT_CURSOR_CYCLE",
    "GLUT_CURSOR_DESTROY",
    "GLUT_CURSOR_FULL_CROSSHAIR",
    "GLUT_CURSOR_HELP",
    "GLUT_CURSOR_INFO",
    "GLUT_CURSOR_INHERIT",
    "GLUT_CURSOR_LEFT_ARROW",
    "GLUT_CURSOR_LEFT_RIGHT",
    "GLUT_CURSOR_LEFT_SIDE",
    "GLUT_CURSOR_NONE",
    "GLUT_CURSOR_RIGHT_ARROW",
    "GLUT_CURSOR_RIGHT_SIDE",
    "GLUT_CURSOR_SPRAY",
    "GLUT_CURSOR_TEXT",
    "GLUT_CURSOR_TOP_LEFT_CORNER",
    "GLUT_CURSOR_TOP_RIGHT_CORNER",
    "GLUT_CURSOR_TOP_SIDE",
    "GLUT_CURSOR_UP_DOWN",
    "GLUT_CURSOR_WAIT",
    "GLUT_DEBUG",
    "GLUT_DEPTH",
    "GLUT_DEVICE_IGNORE_KEY_REPEAT",
    "GLUT_DEVICE_KEY_REPEAT",
    "GLUT_DIRECT_RENDERING",
    "GLUT_DISPLAY_MODE_POSSIBLE",
    "GLUT_DOUBLE",
    "GLUT_DOWN",
    "GLUT_ELAPSED_TIME",
    "GLUT_ENTERED",
    "GLUT_FORCE_DIRECT_CONTEXT",
    "GLUT_FORCE_INDIRECT_CONTEXT",
    "GLUT_FORWARD_COMPATIBLE",
    "GLUT_FULLY_COVERED",
    "GLUT_FULLY_RETAINED",
    "GLUT_FULL_SCREEN",
    "GLUT_GAME_MODE_ACTIVE",
    "GLUT_GAME_MODE_DISPLAY_CHANGED",
    "GLUT_GAME_MODE_HEIGHT",
    "GLUT_GAME_MODE_PIXEL_DEPTH",
    "GLUT_GAME_MODE_POSSIBLE",
    "GLUT_GAME_MODE_REFRESH_RATE",
    "GLUT_GAME_MODE_WIDTH",
    "GLUT_GREEN",
    "GLUT_GUARD_CALLBACKS",
    "GLUT_HAS_DIAL_AND_BUTTON_BOX",
    "GLUT_HAS_JOYSTICK",
    "GLUT_HAS_KEYBOARD",
    "GLUT_HAS_MOUSE",
    "GLUT_HAS_OVERLAY",
    "GLUT_HAS_SPACEBALL",
    "GLUT_HAS_TABLET",
    "GLUT_HIDDEN",
    "GLUT_INDEX",
    "GLUT_INIT_DISPLAY_MODE",
    "GLUT_INIT_FLAGS",
    "GLUT_INIT_MAJOR_VERSION",
    "GLUT_INIT_MINOR_VERSION",
    "GLUT_INIT_PROFILE",
    "GLUT_INIT_STATE",
    "GLUT_INIT_WINDOW_HEIGHT",
    "GLUT_INIT_WINDOW_WIDTH",
    "GLUT_INIT_WINDOW_X",
    "GLUT_INIT_WINDOW_Y",
    "GLUT_JOYSTICK_AXES",
    "GLUT_JOYSTICK_BUTTONS",
    "GLUT_JOYSTICK_BUTTON_A",
    "GLUT_JOYSTICK_BUTTON_B",
    "GLUT_JOYSTICK_BUTTON_C",
    "GLUT_JOYSTICK_BUTTON_D",
    "GLUT_JOYSTICK_POLL_RATE",
    "GLUT_KEY_BEGIN",
    "GLUT_KEY_DELETE",
    "GLUT_KEY_DOWN",
    "GLUT_KEY_END",
    "GLUT_KEY_F1",
    "GLUT_KEY_F10",
    "GLUT_KEY_F11",
    "GLUT_KEY_F12",
    "GLUT_KEY_F2",
    "GLUT_KEY_F3",
    "GLUT_KEY_F4",
    "GLUT_KEY_F5",
    "GLUT_KEY_F6",
    "GLUT_KEY_F7",
    "GLUT_KEY_F8",
    "GLUT_KEY_F9",
    "GLUT_KEY_HOME",
    "GLUT_KEY_INSERT",
    "GLUT_KEY_LEFT",
    "GLUT_KEY_NUM_LOCK",
    "GLUT_KEY_PAGE_DOWN",
    "GLUT_KEY_PAGE_UP",
    "GLUT_KEY_REPEAT_DEFAULT",
    "GLUT_KEY_REPEAT_OFF",
    "GLUT_KEY_REPEAT_ON",
    "GLUT_KEY_RIGHT",
    "GLUT_KEY_UP",
    "GLUT_LAYER_IN_USE",
    "GLUT_LEFT",
    "GLUT_LEFT_BUTTON",
    "GLUT_LUMINANCE",
    "GLUT_MENU_IN_USE",
    "GLUT_MENU_NOT_IN_USE",
    "GLUT_MENU_NUM_ITEMS",
    "GLUT_MIDDLE_BUTTON",
    "GLUT_MULTISAMPLE",
    "GLUT_NORMAL",
    "GLUT_NORMAL_DAMAGED",
    "GLUT_NOT_VISIBLE",
    "GLUT_NO_RECOVERY",
    "GLUT_NUM_BUTTON_BOX_BUTTONS",
    "GLUT_NUM_DIALS",
    "GLUT_NUM_MOUSE_BUTTONS",
    "GLUT_NUM_SPACEBALL_BUTTONS",
    "GLUT_NUM_TABLET_BUTTONS",
    "GLUT_OVERLAY",
    "GLUT_OVERLAY_DAMAGED",
    "GLUT_OVERLAY_POSSIBLE",
    "GLUT_OWNS_JOYSTICK",
    "GLUT_PARTIALLY_RETAINED",
    "GLUT_RED",
    "GLUT_RENDERING_CONTEXT",
    "GLUT_RGB",
    "GLUT_RGBA",
    "GLUT_RIGHT_BUTTON",
    "GLUT_SCREEN_HEIGHT",
    "GLUT_SCREEN_HEIGHT_MM",
    "GLUT_SCREEN_WIDTH",
    "GLUT_SCREEN_WIDTH_MM",
    "GLUT_SINGLE",
    "GLUT_SRGB",
    "GLUT_STENCIL",
    "GLUT_STEREO",
    "GLUT_STROKE_MONO_ROMAN",
    "GLUT_STROKE_ROMAN",
    "GLUT_TRANSPARENT_INDEX",
    "GLUT_TRY_DIRECT_CONTEXT",
    "GLUT_UP",
    "GLUT_USE_CURRENT_CONTEXT",
    "GLUT_VIDEO_RESIZE_HEIGHT",
    "GLUT_VIDEO_RESIZE_HEIGHT_DELTA",
    "GLUT_VIDEO_RESIZE_IN_USE",
    "GLUT_VIDEO_RESIZE_POSSIBLE",
    "GLUT_VIDEO_RESIZE_WIDTH",
    "GLUT_VIDEO_RESIZE_WIDTH_DELTA",
    "GLUT_VIDEO_RESIZE_X",
    "GLUT_VIDEO_RESIZE_X_DELTA",
    "GLUT_VIDEO_RESIZE_Y",
    "GLUT_VIDEO_RESIZE_Y_DELTA",
    "GLUT_VISIBLE",
    "GLUT_WINDOW_ACCUM_ALPHA_SIZE",
    "GLUT_WINDOW_ACCUM_BLUE_SIZE",
    "GLUT_WINDOW_ACCUM_GREEN_SIZE",
    "GLUT_WINDOW_ACCUM_RED_SIZE",
    "GLUT_WINDOW_ALPHA_SIZE",
    "GLUT_WINDOW_BLUE_SIZE",
    "GLUT_WINDOW_BORDER_WIDTH",
    "GLUT_WINDOW_BUFFER_SIZE",
    "GLUT_WINDOW_COLORMAP_SIZE",
    "GLUT_WINDOW_CURSOR",
    "GLUT_WINDOW_DEPTH_SIZE",
    "GLUT_WINDOW_DOUBLEBUFFER",
    "GLUT_WINDOW_FORMAT_ID",
    "GLUT_WINDOW_GREEN_SIZE",
    "GLUT_WINDOW_HEADER_HEIGHT",
    "GLUT_WINDOW_HEIGHT",
    "GLUT_WINDOW_NUM_CHILDREN",
    "GLUT_WINDOW_NUM_SAMPLES",
    "GLUT_WINDOW_PARENT",
    "GLUT_WINDOW_RED_SIZE",
    "GLUT_WINDOW_RGBA",
    "GLUT_WINDOW_STENCIL_SIZE",
    "GLUT_WINDOW_STEREO",
    "GLUT_WINDOW_WIDTH",
    "GLUT_WINDOW_X",
    "GLUT_WINDOW_Y",
    "GLUT_XLIB_IMPLEMENTATION",
    "HAVE_FREEGLUT",
    "ctypes",
    "glutAddMenuEntry",
    "glutAddSubMenu",
    "glutAppStatusFunc",
    "glutAttachMenu",
    "glutBitmapCharacter",
    "glutBitmapHeight",
    "glutBitmapLength",
    "glutBitmapString",
    "glutBitmapWidth",
    "glutButtonBoxFunc",
    "glutChangeToMenuEntry",
    "glutChangeToSubMenu",
    "glutCheckLoop",
    "glutCloseFunc",
    "glutCopyColormap",
    "glutCreateMenu",
    "glutCreateSubWindow",
    "glutCreateWindow",
    "glutDestroyMenu",
    "glutDestroyWindow",
    "glutDetachMenu",
    "glutDeviceGet",
    "glutDialsFunc",
    "glutDisplayFunc",
    "glutEnterGameMode",
    "glutEntryFunc",
    "glutEstablishOverlay",
    "glutExit",
    "glutExtensionSupported",
    "glutForceJoystickFunc",
    "glutFullScreen",
    "glutFullScreenToggle",
    "glutGameModeGet",
    "glutGameModeString",
    "glutGet",
    "glutGetColor",
    "glutGetMenu",
    "glutGetMenuData",
    "glutGetModeValues",
    "glutGetModifiers",
    "glutGetProcAddress",
    "glutGetWindow",
    "glutGetWindowData",
    "glutHideOverlay",
    "glutHideWindow",
    "glutIconifyWindow",
    "glutIdleFunc",
    "glutIgnoreKeyRepeat",
    "glutInit",
    "glutInitContextFlags",
    "glutInitContextFunc",
    "glutInitContextProfile",
    "glutInitContextVersion",
    "glutInitDisplayMode",
    "glutInitDisplayString",
    "glutInitErrorFunc",
    "glutInitWarningFunc",
    "glutInitWindowPosition",
    "glutInitWindowSize",
    "glutJoystickFunc",
    "glutKeyboardFunc",
    "glutKeyboardUpFunc",
    "glutLayerGet",
    "glutLeaveFullScreen",
    "glutLeaveGameMode",
    "glutLeaveMainLoop",
    "glutMainLoop",
    "glutMainLoopEvent",
    "glutMenuDestroyFunc",
    "glutMenuStateFunc",
    "glutMenuStatusFunc",
    "glutMotionFunc",
    "glutMouseFunc",
    "glutMouseWheelFunc",
    "glutMultiButtonFunc",
    "glutMultiEntryFunc",
    "glutMultiMotionFunc",
    "glutMultiPassiveFunc",
    "glutOverlayDisplayFunc",
    "glutPassiveMotionFunc",
    "glutPopWindow",
    "glutPositionFunc",
    "glutPositionWindow",
    "glutPostOverlayRedisplay",
    "glutPostRedisplay",
    "glutPostWindowOverlayRedisplay",
    "glutPostWindowRedisplay",
    "glutPushWindow",
    "glutRemoveMenuItem",
    "glutRemoveOverlay",
    "glutReportErrors",
    "glutReshapeFunc",
    "glutReshapeWindow",
    "glutSetColor",
    "glutSetCursor",
    "glutSetIconTitle",
    "glutSetKeyRepeat",
    "glutSetMenu",
    "glutSetMenuData",
    "glutSetOption",
    "glutSetWindow",
    "glutSetWindowData",
    "glutSetWindowTitle",
    "glutSetupVideoResizing",
    "glutShowOverlay",
    "glutShowWindow",
    "glutSolidCone",
    "glutSolidCube",
    "glutSolidCylinder",
    "glutSolidDodecahedron",
    "glutSolidIcosahedron",
    "glutSolidOctahedron",
    "glutSolidRhombicDodecahedron",
    "glutSolidSierpinskiSponge",
    "glutSolidSphere",
    "glutSolidTeacup",
    "glutSolidTeapot",
    "glutSolidTeaspoon",
    "glutSolidTetrahedron",
    "glutSolidTorus",
    "glutSpaceballButtonFunc",
    "glutSpaceballMotionFunc",
    "glutSpaceballRotateFunc",
    "glutSpecialFunc",
    "glutSpecialUpFunc",
    "glutStopVideoResizing",
    "glutStrokeCharacter",
    "glutStrokeHeight",
    "glutStrokeLength",
    "glutStrokeLengthf",
    "glutStrokeString",
    "glutStrokeWidth",
    "glutStrokeWidthf",
    "glutSwapBuffers",
    "glutTabletButtonFunc",
    "glutTabletMotionFunc",
    "glutTimerFunc",
    "glutUseLayer",
    "glutVideoPan",
    "glutVideoResize",
    "glutVideoResizeGet",
    "glutVisibilityFunc",
    "glutWMCloseFunc",
    "glutWarpPointer",
    "glutWindowStatusFunc",
    "glutWireCone",
    "glutWireCube",
    "glutWireCylinder",
    "glutWireDodecahedron",
    "glutWireIcosahedron",
    "glutWireOctahedron",
    "glutWireRhombicDodecahedron",
    "glutWireSierpinskiSponge",
    "glutWireSphere",
    "glutWireTeacup",
    "glutWireTeapot",
    "glutWireTeaspoon",
    "glutWireTetrahedron",
    "glutWireTorus",
    "logging",
    "os",
    "sys",
    "traceback",
]

GLUT_3_2_CORE_PROFILE: Enum
GLUT_ACCUM: Enum
GLUT_ACTION_CONTINUE_EXECUTION: Enum
GLUT_ACTION_EXIT: Enum
GLUT_ACTION_GLUTMAINLOOP_RETURNS: Enum
GLUT_ACTION_ON_WINDOW_CLOSE: Enum
GLUT_ACTIVE_ALT: Enum
GLUT_ACTIVE_CTRL: Enum
GLUT_ACTIVE_SHIFT: Enum
GLUT_ALLOW_DIRECT_CONTEXT: Enum
GLUT_ALPHA: Enum
GLUT_API_VERSION: Enum
GLUT_AUX: Enum
GLUT_AUX1: Enum
GLUT_AUX2: Enum
GLUT_AUX3: Enum
GLUT_AUX4: Enum
GLUT_BITMAP_8_BY_13: BitmapFont
GLUT_BITMAP_9_BY_15: BitmapFont
GLUT_BITMAP_HELVETICA_10: BitmapFont
GLUT_BITMAP_HELVETICA_12: BitmapFont
GLUT_BITMAP_HELVETICA_18: BitmapFont
GLUT_BITMAP_TIMES_ROMAN_10: BitmapFont
GLUT_BITMAP_TIMES_ROMAN_24: BitmapFont
GLUT_BLUE: Enum
GLUT_BORDERLESS: Enum
GLUT_CAPTIONLESS: Enum
GLUT_COMPATIBILITY_PROFILE: Enum
GLUT_CORE_PROFILE: Enum
GLUT_CREATE_NEW_CONTEXT: Enum
GLUT_CURSOR_BOTTOM_LEFT_CORNER: Enum
GLUT_CURSOR_BOTTOM_RIGHT_CORNER: Enum
GLUT_CURSOR_BOTTOM_SIDE: Enum
GLUT_CURSOR_CROSSHAIR: Enum
GLUT_CURSOR_CYCLE: Enum
GLUT_CURSOR_DESTROY: Enum
GLUT_CURSOR_FULL_CROSSHAIR: Enum
GLUT_CURSOR_HELP: Enum
GLUT_CURSOR_INFO: Enum
GLUT_CURSOR_INHERIT: Enum
GLUT_CURSOR_LEFT_ARROW: Enum
GLUT_CURSOR_LEFT_RIGHT: Enum
GLUT_CURSOR_LEFT_SIDE: Enum
GLUT_CURSOR_NONE: Enum
GLUT_CURSOR_RIGHT_ARROW: Enum
GLUT_CURSOR_RIGHT_SIDE: Enum
GLUT_CURSOR_SPRAY: Enum
GLUT_CURSOR_TEXT: Enum
GLUT_CURSOR_TOP_LEFT_CORNER: Enum
GLUT_CURSOR_TOP_RIGHT_CORNER: Enum
GLUT_CURSOR_TOP_SIDE: Enum
GLUT_CURSOR_UP_DOWN: Enum
GLUT_CURSOR_WAIT: Enum
GLUT_DEBUG: Enum
GLUT_DEPTH: Enum
GLUT_DEVICE_IGNORE_KEY_REPEAT: Enum
GLUT_DEVICE_KEY_REPEAT: Enum
GLUT_DIRECT_RENDERING: Enum
GLUT_DISPLAY_MODE_POSSIBLE: Enum
GLUT_DOUBLE: Enum
GLUT_DOWN: Enum
GLUT_ELAPSED_TIME: Enum
GLUT_ENTERED: Enum
GLUT_FORCE_DIRECT_CONTEXT: Enum
GLUT_FORCE_INDIRECT_CONTEXT: Enum
GLUT_FORWARD_COMPATIBLE: Enum
GLUT_FULLY_COVERED: Enum
GLUT_FULLY_RETAINED: Enum
GLUT_FULL_SCREEN: Enum
GLUT_GAME_MODE_ACTIVE: Enum
GLUT_GAME_MODE_DISPLAY_CHANGED: Enum
GLUT_GAME_MODE_HEIGHT: Enum
GLUT_GAME_MODE_PIXEL_DEPTH: Enum
GLUT_GAME_MODE_POSSIBLE: Enum
GLUT_GAME_MODE_REFRESH_RATE: Enum
GLUT_GAME_MODE_WIDTH: Enum
GLUT_GREEN: Enum
GLUT_GUARD_CALLBACKS: Enum
GLUT_HAS_DIAL_AND_BUTTON_BOX: Enum
GLUT_HAS_JOYSTICK: Enum
GLUT_HAS_KEYBOARD: Enum
GLUT_HAS_MOUSE: Enum
GLUT_HAS_OVERLAY: Enum
GLUT_HAS_SPACEBALL: Enum
GLUT_HAS_TABLET: Enum
GLUT_HIDDEN: Enum
GLUT_INDEX: Enum
GLUT_INIT_DISPLAY_MODE: Enum
GLUT_INIT_FLAGS: Enum
GLUT_INIT_MAJOR_VERSION: Enum
GLUT_INIT_MINOR_VERSION: Enum
GLUT_INIT_PROFILE: Enum
GLUT_INIT_STATE: Enum
GLUT_INIT_WINDOW_HEIGHT: Enum
GLUT_INIT_WINDOW_WIDTH: Enum
GLUT_INIT_WINDOW_X: Enum
GLUT_INIT_WINDOW_Y: Enum
GLUT_JOYSTICK_AXES: Enum
GLUT_JOYSTICK_BUTTONS: Enum
GLUT_JOYSTICK_BUTTON_A: Enum
GLUT_JOYSTICK_BUTTON_B: Enum
GLUT_JOYSTICK_BUTTON_C: Enum
GLUT_JOYSTICK_BUTTON_D: Enum
GLUT_JOYSTICK_POLL_RATE: Enum
GLUT_KEY_BEGIN: Enum
GLUT_KEY_DELETE: Enum
GLUT_KEY_DOWN: Enum
GLUT_KEY_END: Enum
GLUT_KEY_F1: Enum
GLUT_KEY_F10: Enum
GLUT_KEY_F11: Enum
GLUT_KEY_F12: Enum
GLUT_KEY_F2: Enum
GLUT_KEY_F3: Enum
GLUT_KEY_F4: Enum
GLUT_KEY_F5: Enum
GLUT_KEY_F6: Enum
GLUT_KEY_F7: Enum
GLUT_KEY_F8: Enum
GLUT_KEY_F9: Enum
GLUT_KEY_HOME: Enum
GLUT_KEY_INSERT: Enum
GLUT_KEY_LEFT: Enum
GLUT_KEY_NUM_LOCK: Enum
GLUT_KEY_PAGE_DOWN: Enum
GLUT_KEY_PAGE_UP: Enum
GLUT_KEY_REPEAT_DEFAULT: Enum
GLUT_KEY_REPEAT_OFF: Enum
GLUT_KEY_REPEAT_ON: Enum
GLUT_KEY_RIGHT: Enum
GLUT_KEY_UP: Enum
GLUT_LAYER_IN_USE: Enum
GLUT_LEFT: Enum
GLUT_LEFT_BUTTON: Enum
GLUT_LUMINANCE: Enum
GLUT_MENU_IN_USE: Enum
GLUT_MENU_NOT_IN_USE: Enum
GLUT_MENU_NUM_ITEMS: Enum
GLUT_MIDDLE_BUTTON: Enum
GLUT_MULTISAMPLE: Enum
GLUT_NORMAL: Enum
GLUT_NORMAL_DAMAGED: Enum
GLUT_NOT_VISIBLE: Enum
GLUT_NO_RECOVERY: Enum
GLUT_NUM_BUTTON_BOX_BUTTONS: Enum
GLUT_NUM_DIALS: Enum
GLUT_NUM_MOUSE_BUTTONS: Enum
GLUT_NUM_SPACEBALL_BUTTONS: Enum
GLUT_NUM_TABLET_BUTTONS: Enum
GLUT_OVERLAY: Enum
GLUT_OVERLAY_DAMAGED: Enum
GLUT_OVERLAY_POSSIBLE: Enum
GLUT_OWNS_JOYSTICK: Enum
GLUT_PARTIALLY_RETAINED: Enum
GLUT_RED: Enum
GLUT_RENDERING_CONTEXT: Enum
GLUT_RGB: Enum
GLUT_RGBA: Enum
GLUT_RIGHT_BUTTON: Enum
GLUT_SCREEN_HEIGHT: Enum
GLUT_SCREEN_HEIGHT_MM: Enum
GLUT_SCREEN_WIDTH: Enum
GLUT_SCREEN_WIDTH_MM: Enum
GLUT_SINGLE: Enum
GLUT_SRGB: Enum
GLUT_STENCIL: Enum
GLUT_STEREO: Enum
GLUT_STROKE_MONO_ROMAN: StrokeFont
GLUT_STROKE_ROMAN: StrokeFont
GLUT_TRANSPARENT_INDEX: Enum
GLUT_TRY_DIRECT_CONTEXT: Enum
GLUT_UP: Enum
GLUT_USE_CURRENT_CONTEXT: Enum
GLUT_VIDEO_RESIZE_HEIGHT: Enum
GLUT_VIDEO_RESIZE_HEIGHT_DELTA: Enum
GLUT_VIDEO_RESIZE_IN_USE: Enum
GLUT_VIDEO_RESIZE_POSSIBLE: Enum
GLUT_VIDEO_RESIZE_WIDTH: Enum
GLUT_VIDEO_RESIZE_WIDTH_DELTA: Enum
GLUT_VIDEO_RESIZE_X: Enum
GLUT_VIDEO_RESIZE_X_DELTA: Enum
GLUT_VIDEO_RESIZE_Y: Enum
GLUT_VIDEO_RESIZE_Y_DELTA: Enum
GLUT_VISIBLE: Enum
GLUT_WINDOW_ACCUM_ALPHA_SIZE: Enum
GLUT_WINDOW_ACCUM_BLUE_SIZE: Enum
GLUT_WINDOW_ACCUM_GREEN_SIZE: Enum
GLUT_WINDOW_ACCUM_RED_SIZE: Enum
GLUT_WINDOW_ALPHA_SIZE: Enum
GLUT_WINDOW_BLUE_SIZE: Enum
GLUT_WINDOW_BORDER_WIDTH: Enum
GLUT_WINDOW_BUFFER_SIZE: Enum
GLUT_WINDOW_COLORMAP_SIZE: Enum
GLUT_WINDOW_CURSOR: Enum
GLUT_WINDOW_DEPTH_SIZE: Enum
GLUT_WINDOW_DOUBLEBUFFER: Enum
GLUT_WINDOW_FORMAT_ID: Enum
GLUT_WINDOW_GREEN_SIZE: Enum
GLUT_WINDOW_HEADER_HEIGHT: Enum
GLUT_WINDOW_HEIGHT: Enum
GLUT_WINDOW_NUM_CHILDREN: Enum
GLUT_WINDOW_NUM_SAMPLES: Enum
GLUT_WINDOW_PARENT: Enum
GLUT_WINDOW_RED_SIZE: Enum
GLUT_WINDOW_RGBA: Enum
GLUT_WINDOW_STENCIL_SIZE: Enum
GLUT_WINDOW_STEREO: Enum
GLUT_WINDOW_WIDTH: Enum
GLUT_WINDOW_X: Enum
GLUT_WINDOW_Y: Enum
GLUT_XLIB_IMPLEMENTATION: Enum
HAVE_FREEGLUT: bool
import ctypes as ctypes
import logging as logging
import os as os
import sys as sys
import traceback as traceback

def glutAppStatusFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Accepted without effect: there are no such events."""

def glutButtonBoxFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Accepted without effect: there are no such events."""

def glutCloseFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Call ``callback()`` of the current window when the window is closed; None: no longer."""

def glutDialsFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Accepted without effect: there are no such events."""

def glutDisplayFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Call ``callback()`` of the current window when the window must be drawn; None: no longer."""

def glutEntryFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Call ``callback(state)`` of the current window when the mouse comes (GLUT_ENTERED) or goes (GLUT_LEFT); None: no longer."""

def glutInitContextFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Accepted without effect: there are no such events."""

def glutJoystickFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Accepted without effect: there are no such events."""

def glutKeyboardFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Call ``callback(key, x, y)`` of the current window when a key is pressed; key: its letter as bytes; None: no longer."""

def glutKeyboardUpFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Call ``callback(key, x, y)`` of the current window when a key is released; None: no longer."""

def glutMotionFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Call ``callback(x, y)`` of the current window when the mouse moves with a button down; None: no longer."""

def glutMouseFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Call ``callback(button, state, x, y)`` of the current window when GLUT_LEFT_BUTTON, ... gets GLUT_DOWN or GLUT_UP; None: no longer."""

def glutMouseWheelFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Call ``callback(wheel, direction, x, y)`` of the current window when the wheel turns: direction 1 or -1; None: no longer."""

def glutMultiButtonFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Accepted without effect: there are no such events."""

def glutMultiEntryFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Accepted without effect: there are no such events."""

def glutMultiMotionFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Accepted without effect: there are no such events."""

def glutMultiPassiveFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Accepted without effect: there are no such events."""

def glutOverlayDisplayFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Accepted without effect: there are no such events."""

def glutPassiveMotionFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Call ``callback(x, y)`` of the current window when the mouse moves without a button; None: no longer."""

def glutPositionFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Accepted without effect: there are no such events."""

def glutReshapeFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Call ``callback(width, height)`` of the current window when the window gets a size, in pixels; None: no longer."""

def glutSpaceballButtonFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Accepted without effect: there are no such events."""

def glutSpaceballMotionFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Accepted without effect: there are no such events."""

def glutSpaceballRotateFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Accepted without effect: there are no such events."""

def glutSpecialFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Call ``callback(key, x, y)`` of the current window when GLUT_KEY_UP, GLUT_KEY_F1, ... is pressed; None: no longer."""

def glutSpecialUpFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Call ``callback(key, x, y)`` of the current window when GLUT_KEY_UP, GLUT_KEY_F1, ... is released; None: no longer."""

def glutTabletButtonFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Accepted without effect: there are no such events."""

def glutTabletMotionFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Accepted without effect: there are no such events."""

def glutVisibilityFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Call ``callback(state)`` of the current window when the window is shown (GLUT_VISIBLE) or hidden (GLUT_NOT_VISIBLE); None: no longer."""

def glutWMCloseFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Call ``callback()`` of the current window when the window is closed; None: no longer."""

def glutWindowStatusFunc(callback: Callable[..., Any] | None = None, *ignored: Any) -> None:
    """Call ``callback(state)`` of the current window when the window is shown or hidden; None: no longer."""

