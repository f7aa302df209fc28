"""Where Mesa 22.3.6 contradicts the specification, glsim follows the specification (see gl/SUPPORT.md)."""

from __future__ import annotations

import numpy as np
import pytest

import glsim
from glsim.gl import *


def square(x: float = -1.0, backwards: bool = False) -> None:
    corners = ((x, -1), (x + 1, -1), (x + 1, 1), (x, 1))
    glNormal3f(0, 0, -1 if backwards else 1)
    glBegin(GL_QUADS)
    for corner in reversed(corners) if backwards else corners:
        glVertex2f(*corner)
    glEnd()


def lit() -> None:
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0, 0, 0, 1])


def test_enabling_color_material_takes_the_current_colour_at_once(screen: glsim.Offscreen) -> None:
    """Section 2.14.3; in Mesa a glMaterial that no vertex has used yet goes before."""
    lit()
    glColor3f(1, 0, 0)
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, [0, 1, 0, 1])
    glEnable(GL_COLOR_MATERIAL)
    square()
    assert screen.pixels()[64, 32, :3].tolist() == [255, 0, 0]


def test_popping_lighting_restores_the_material(screen: glsim.Offscreen) -> None:
    """Table 6.9: materials are in GL_LIGHTING_BIT; in Mesa one that no vertex has used yet stays."""
    lit()
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [1, 0, 0, 1])
    glPushAttrib(GL_LIGHTING_BIT)
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [0, 0, 1, 1])
    glPopAttrib()
    square()
    assert screen.pixels()[64, 32, :3].tolist() == [255, 0, 0]
    assert glGetMaterialfv(GL_FRONT, GL_DIFFUSE).tolist() == [1, 0, 0, 1]


def test_the_back_tracks_all_of_the_colour(screen: glsim.Offscreen) -> None:
    """In Mesa glColorMaterial(GL_BACK) loses green and blue when glColor changes between primitives."""
    lit()
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1)
    glColorMaterial(GL_BACK, GL_DIFFUSE)
    glEnable(GL_COLOR_MATERIAL)
    glColor3f(1, 0, 0)
    square(-1.0, backwards=True)
    glColor3f(0, 0.6, 1)
    glNormal3f(0, 0, -1)
    square(0.0, backwards=True)
    found = screen.pixels()[64, [32, 96], :3]
    assert found == pytest.approx(np.array([[255, 0, 0], [0, 153, 255]]), abs=1)


def test_smooth_points_are_discs(screen: glsim.Offscreen) -> None:
    """Section 3.3: the fragments of a smooth point are weighted by coverage; Mesa 22 draws hard discs."""
    glEnable(GL_POINT_SMOOTH)
    glEnable(GL_BLEND)
    glBlendFunc(GL_SRC_ALPHA, GL_ZERO)
    glPointSize(21.5)
    glBegin(GL_POINTS)
    glVertex2f(0.013, 0.021)
    glEnd()
    covered = screen.pixels()[..., 0] / 255.0
    assert covered.sum() == pytest.approx(np.pi * (21.5 / 2) ** 2, rel=0.01)
    assert 0.0 < covered[covered > 0].min() < 0.5


def test_a_shininess_of_0_is_a_highlight_wherever_there_is_light(screen: glsim.Offscreen) -> None:
    """Equation 2.5: max(N.H, 0)^0 is 1; in Mesa it is 0 where N.H < 0, and other numbers where light is attenuated."""
    lit()
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [0, 0, 0, 1])
    glMaterialfv(GL_FRONT, GL_SPECULAR, [0.2, 0.4, 0.6, 1])
    glLightfv(GL_LIGHT0, GL_POSITION, [0.8, 0, -0.6, 0])
    glNormal3f(0.1, 0, -1)  # N.L > 0 and N.H < 0
    glRectf(-1, -1, 1, 1)
    assert screen.pixels()[64, 64, :3].tolist() == [51, 102, 153]


# ---------------------------------------------------------------- display lists


def test_a_list_keeps_an_attribute_that_is_set_late(screen: glsim.Offscreen) -> None:
    """Section 5.4: as if the commands were given without a list; in Mesa the second triangle stays red."""
    glNewList(1, GL_COMPILE)
    glBegin(GL_TRIANGLES)
    for corner in ((0, 0), (1, 0), (1, 1), (-1, -1)):
        glVertex2f(*corner)
    glColor3f(0, 1, 0)
    glVertex2f(1, -1)
    glVertex2f(-1, 1)
    glEnd()
    glEndList()
    glColor3f(1, 0, 0)
    glCallList(1)
    red, green = screen.pixels()[100, 60, :2].tolist()
    assert red + green == 255
    assert 80 < green < 255


def test_what_is_compiled_and_executed_is_executed(screen: glsim.Offscreen) -> None:
    """Section 5.4; in Mesa the colour is green afterwards, and there is no error."""
    glNewList(1, GL_COMPILE_AND_EXECUTE)
    glBegin(GL_POINTS)
    glColor3f(0, 1, 0)
    glVertex2f(0, 0)
    with pytest.raises(GLError, match="glEnable: not allowed between glBegin and glEnd"):
        glEnable(GL_LIGHTING)
    glColor3f(0, 0, 1)
    glEnd()
    glEndList()
    assert glGetFloatv(GL_CURRENT_COLOR).tolist() == [0, 0, 1, 1]


# ---------------------------------------------------------------- fragments


def rectangle(colour: tuple[int, int, int]) -> None:
    glPixelZoom(20, 20)
    glDrawPixels(1, 1, GL_RGB, GL_UNSIGNED_BYTE, np.array(colour, np.uint8))


def foggy() -> None:
    """Half of the fog's blue."""
    glEnable(GL_FOG)
    glFogi(GL_FOG_MODE, GL_LINEAR)
    glFogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE)
    glFogfv(GL_FOG_COLOR, [0, 0, 1, 1])
    glFogCoordf(0.5)


def test_pixel_rectangles_are_fragments_like_others(screen: glsim.Offscreen) -> None:
    """Section 3.6.4 and chapter 3: texturing, colour sum and fog apply to every fragment; in Mesa fog and sum don't."""
    foggy()
    glWindowPos2i(0, 0)
    rectangle((255, 0, 0))
    glDisable(GL_FOG)
    glEnable(GL_COLOR_SUM)
    glSecondaryColor3f(0, 1, 0)
    glWindowPos2i(40, 0)
    rectangle((255, 0, 0))
    assert screen.pixels()[120, [10, 50], :3].tolist() == [[128, 0, 128], [255, 255, 0]]


def test_the_texture_matrix_holds_for_the_raster_position(screen: glsim.Offscreen) -> None:
    """Section 2.13: the raster position is a vertex; in Mesa the rectangle is white."""
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGB, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, bytes([255, 255, 255, 0, 255, 0]))
    for name in (GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER):
        glTexParameteri(GL_TEXTURE_1D, name, GL_NEAREST)
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE)
    glEnable(GL_TEXTURE_1D)
    glTexCoord1f(0.25)
    glMatrixMode(GL_TEXTURE)
    glTranslatef(0.5, 0, 0)
    glRasterPos2f(-1, -1)
    rectangle((255, 0, 0))
    assert screen.pixels()[120, 10, :3].tolist() == [0, 255, 0]


def test_the_colour_sum_is_clamped_before_fog(screen: glsim.Offscreen) -> None:
    """Section 3.9: the components of the sum are clamped to [0, 1]; in Mesa twice red in half fog is all red."""
    foggy()
    glEnable(GL_COLOR_SUM)
    glColor3f(1, 0, 0)
    glSecondaryColor3f(1, 0, 0)
    glRectf(-1, -1, 1, 1)
    assert screen.pixels()[64, 64, :3].tolist() == [128, 0, 128]


def test_an_incomplete_texture_is_no_texture(screen: glsim.Offscreen) -> None:
    """Sections 3.8.10 and 3.8.15: the 2D texture goes before, and switches texturing off; Mesa draws the 1D texture."""
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGB, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, bytes([0, 255, 0]))
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST)
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, bytes(12))  # without its mipmaps
    glEnable(GL_TEXTURE_1D)
    glEnable(GL_TEXTURE_2D)
    glRectf(-1, -1, 1, 1)
    assert screen.pixels()[64, 64].tolist() == [255, 255, 255, 255]


def test_each_bitmap_changes_the_stencil_buffer(screen: glsim.Offscreen) -> None:
    """Section 4.1.5: every fragment; Mesa draws the two at once."""
    glEnable(GL_STENCIL_TEST)
    glStencilFunc(GL_ALWAYS, 0, 255)
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR)
    for _ in range(2):
        glWindowPos2i(64, 64)
        glBitmap(8, 1, 0, 0, 0, 0, b"\xff" * 4)
    assert glReadPixels(66, 64, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE) == b"\2"


def test_half_of_an_accumulated_picture_is_half(screen: glsim.Offscreen) -> None:
    """Section 4.2.4; under GLX Mesa multiplies as if the numbers were those of sRGB: 92."""
    glClearColor(0.5, 0.25, 0, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glAccum(GL_LOAD, 1)
    glAccum(GL_RETURN, 0.5)
    assert screen.pixels()[64, 64, :3].tolist() == [64, 32, 0]


# ---------------------------------------------------------------- attribute groups


def test_groups_hold_every_switch(screen: glsim.Offscreen) -> None:
    """Tables 6.10 and 6.8: GL_COLOR_SUM is in GL_FOG_BIT, GL_LIGHTi in GL_ENABLE_BIT; in Mesa they are not."""
    for group, capability in ((GL_FOG_BIT, GL_COLOR_SUM), (GL_ENABLE_BIT, GL_LIGHT0), (GL_ENABLE_BIT, GL_LIGHT3)):
        glPushAttrib(group)
        glEnable(capability)
        glPopAttrib()
        assert not glIsEnabled(capability)


def test_a_flat_rectangle_is_lit_at_its_first_vertex(screen: glsim.Offscreen) -> None:
    def lit() -> None:
        glShadeModel(GL_FLAT)
        glEnable(GL_LIGHTING)
        glEnable(GL_LIGHT0)
        glLightfv(GL_LIGHT0, GL_POSITION, [-0.6, -0.5, 0.3, 1])

    lit()
    glRectf(-0.6, -0.5, 0.5, 0.7)
    rectangle = screen.pixels().copy()
    screen.reset()
    lit()
    glBegin(GL_POLYGON)
    for x, y in ((-0.6, -0.5), (0.5, -0.5), (0.5, 0.7), (-0.6, 0.7)):
        glVertex2f(x, y)
    glEnd()
    assert (rectangle == screen.pixels()).all()
    assert rectangle[64, 64, 0] > 200, "the light is above the first vertex; at the last one it is dark"


def test_a_loop_with_materials_is_closed(screen: glsim.Offscreen) -> None:
    glEnable(GL_LIGHTING)
    glBegin(GL_LINE_LOOP)
    for k, (x, y) in enumerate(((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))):
        glMaterialfv(GL_FRONT, GL_EMISSION, [0.2 + 0.2 * k, 0, 0, 1])
        glVertex2f(x, y)
    glEnd()
    assert screen.pixels()[40:90, 30:34, 0].any(axis=1).all(), "the line from the last vertex to the first"
