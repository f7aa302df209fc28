"""The world from outside: what is drawn, the camera that sees it, its frustum, and the lights, in eye space."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from glsim import gl
from glsim.glu.view import gluLookAt, gluPerspective
from glsim.machine.frame import Draw, Frame, Packet
from glsim.machine.matrix import leaf
from glsim.machine.state import Depth, Light, Scissor, Stencil, Viewport
from glsim.play.frames import frame_of
from glsim.render.context import Offscreen, own_screen
from glsim.shading import normalize
from glsim.study.overlay import Overlay
from glsim.study.world import ANGLE, View, World, axis_ends, end_of_frustum, lamp_place, shown_points, view_of, world_of

if TYPE_CHECKING:
    from PIL import Image

Float = NDArray[np.float64]
BACKGROUND = (0.93, 0.93, 0.91)
CAMERA, NEAR, FAR, LIGHT, VIEW = (40, 40, 46), (0, 114, 178), (86, 150, 200), (214, 130, 0), (110, 114, 124)
AXES = {"x": (213, 94, 0), "y": (0, 150, 110), "z": (0, 114, 178)}


def outside(
    what: Any, *, width: int = 960, height: int = 640, azimuth: float | None = None, elevation: float | None = None,
    image: bool = True, axes: bool = True, labels: bool = True, **options: Any,
) -> Image.Image:  # fmt: skip
    """The world of ``what`` from outside: its surfaces as they are lit, the eye, the frustum with its near and far
    plane, the axes of eye space, and the lights: a star for a point, arrows for a direction, a cone for a spotlight.

    what: a Frame, a drawing function, a scene, a mesh file or a program: what glsim.probe takes, with its options.
    azimuth, elevation: where it is seen from, in degrees: azimuth 0 is behind the camera, 90 on its right; None: the
    direction in which the parts hide each other least.  image: the picture that the camera takes, on a plane between
    eye and surfaces.  axes: of eye space; labels: names of the parts.
    Of a frame with several cameras the one with the most vertices is shown.

    Raises ValueError if nothing is drawn, or its projection has no inverse.

    Example: ``glsim.outside("teapot", azimuth=60, elevation=20).save("outside.png")``
    """
    frame: Frame = frame_of(what, **options)
    world = world_of(frame)
    with own_screen(width, height, samples=4) as screen:
        view = view_of(world, (width, height), azimuth, elevation)
        _draw_world(screen, world, view)
        if image:
            _draw_picture(world)
        _draw_lines(world)
        overlay = Overlay(screen.image())
    _draw_over(overlay, world, view, axes, labels, image)
    return overlay.image()


# ---------------------------------------------------------------- drawing with the gl commands


def _draw_world(screen: Offscreen, world: World, view: View) -> None:
    """Clear, and draw the surfaces as the camera lights them, seen from outside; sets the matrices of the view."""
    width, height = view.size
    reach = max(view.distance(point) for point in shown_points(world))
    gl.glClearColor(*BACKGROUND, 1.0)
    gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
    gl.glMatrixMode(gl.GL_PROJECTION)
    gluPerspective(ANGLE, width / height, reach / 1000.0, 3.0 * reach)
    projection = screen.machine.projection[-1]
    gl.glMatrixMode(gl.GL_MODELVIEW)
    (x, y, z), (to_x, to_y, to_z) = view.eye.tolist(), view.target.tolist()
    gluLookAt(x, y, z, to_x, to_y, to_z, 0.0, 1.0, 0.0)
    gl.glFlush()
    moved: list[Packet] = []
    for draw in world.draws:
        modelview = leaf((draw.matrices[0].get().astype(float) @ view.matrix).astype(np.float32))
        copy = draw.with_state(_outside_state(draw, view))
        copy.matrices = (modelview, projection, *draw.matrices[2:])
        moved.append(copy)
    screen.execute(moved)


def _outside_state(draw: Draw, view: View) -> Any:
    """A Draw's state for the view from outside: lights, clip planes and generated coordinates stay where they are."""
    state, turn = draw.state, view.matrix
    back = np.linalg.inv(turn)

    def point(position: Sequence[float]) -> Any:
        return tuple((np.array(position, float) @ turn).tolist())

    def plane(equation: Sequence[float]) -> Any:
        return tuple((back @ np.array(equation, float)).tolist())

    lights = tuple(
        light._replace(position=point(light.position), spot_direction=point((*light.spot_direction, 0.0))[:3])
        for light in state.lighting.lights
    )
    units = tuple(
        unit._replace(generators=tuple(g._replace(eye_plane=plane(g.eye_plane)) for g in unit.generators))
        for unit in state.texture.units
    )
    planes = tuple(map(plane, state.transform.clip_planes))
    return state._replace(
        lighting=state.lighting._replace(lights=lights), transform=state.transform._replace(clip_planes=planes),
        texture=state.texture._replace(units=units), viewport=Viewport(0, 0, *view.size), scissor=Scissor(),
        stencil=Stencil(), depth=Depth(True, gl.GL_LEQUAL), fog=state.fog._replace(enabled=False),
        polygon=state.polygon._replace(cull=False), color_buffer=state.color_buffer._replace(draw_buffer=gl.GL_FRONT),
    )  # fmt: skip


def _draw_picture(world: World) -> None:
    """The camera's picture as a texture on its plane."""
    from PIL import Image

    rows = (
        Image.fromarray(np.ascontiguousarray(world.picture[..., :3]))
        .resize((512, 512))
        .transpose(Image.Transpose.FLIP_TOP_BOTTOM)
    )
    gl.glBindTexture(gl.GL_TEXTURE_2D, gl.glGenTextures(1))
    gl.glTexParameteri(gl.GL_TEXTURE_2D, gl.GL_TEXTURE_MIN_FILTER, gl.GL_LINEAR_MIPMAP_LINEAR)
    gl.glTexParameteri(gl.GL_TEXTURE_2D, gl.GL_GENERATE_MIPMAP, 1)
    gl.glTexImage2D(gl.GL_TEXTURE_2D, 0, gl.GL_RGB, 512, 512, 0, gl.GL_RGB, gl.GL_UNSIGNED_BYTE, rows.tobytes())
    gl.glTexEnvi(gl.GL_TEXTURE_ENV, gl.GL_TEXTURE_ENV_MODE, gl.GL_REPLACE)
    gl.glEnable(gl.GL_TEXTURE_2D)
    gl.glEnable(gl.GL_DEPTH_TEST)
    gl.glBegin(gl.GL_QUADS)
    for corner, (s, t) in zip(world.plane, ((0, 0), (1, 0), (1, 1), (0, 1)), strict=True):
        gl.glTexCoord2f(s, t)
        gl.glVertex3f(*corner)
    gl.glEnd()
    gl.glDisable(gl.GL_TEXTURE_2D)


def _draw_lines(world: World) -> None:
    """The frustum and the axis of view, hidden by what is in front of them."""
    gl.glEnable(gl.GL_DEPTH_TEST)
    gl.glEnable(gl.GL_LINE_SMOOTH)
    gl.glEnable(gl.GL_BLEND)
    gl.glBlendFunc(gl.GL_SRC_ALPHA, gl.GL_ONE_MINUS_SRC_ALPHA)
    near, end = world.corners[:4], end_of_frustum(world)
    for color, width, points in (
        (NEAR, 2.5, [*near, near[0]]), (VIEW, 2.0, [*world.plane, world.plane[0]]),
        *([(FAR, 2.5, [*end, end[0]])] if world.far_shown else []),
        *((FAR, 1.6, [a, b]) for a, b in zip(near, end, strict=True)),
        *((FAR, 1.6, [world.eye, a]) for a in (near if world.perspective else ())),
    ):  # fmt: skip
        gl.glColor3ub(*color)
        gl.glLineWidth(width)
        gl.glBegin(gl.GL_LINE_STRIP)
        for point in points:
            gl.glVertex3f(*point)
        gl.glEnd()
    gl.glEnable(gl.GL_LINE_STIPPLE)
    gl.glLineStipple(3, 0x7777)
    gl.glColor3ub(*VIEW)
    gl.glLineWidth(1.5)
    gl.glBegin(gl.GL_LINES)
    gl.glVertex3f(*world.eye)
    gl.glVertex3f(*end.mean(axis=0))
    gl.glEnd()


# ---------------------------------------------------------------- drawing over the picture


def _draw_over(overlay: Overlay, world: World, view: View, axes: bool, labels: bool, image: bool) -> None:
    """Camera, axes, lights and names."""
    eye = view.at(world.eye)
    if axes:
        for (name, color), end in zip(AXES.items(), axis_ends(world), strict=True):
            overlay.arrow(eye, view.at(end), color, 2.4)
            overlay.label(name, view.at(end), color, 19.0)
    overlay.disc(eye, 6.0, CAMERA)
    for number, light in world.lights.items():
        _draw_light(overlay, world, view, light)
        if labels:
            overlay.label(_light_name(world, number, light), view.at(lamp_place(world, light)), LIGHT, 18.0)
    if not labels:
        return
    overlay.label("eye" if world.perspective else "parallel projection", eye, CAMERA, 20.0)
    overlay.label("near plane", view.at(world.corners[3]), NEAR, 18.0)
    if world.far_shown:
        overlay.label("far plane", view.at(world.corners[7]), FAR, 18.0)
    else:
        overlay.label(_far_name(world), view.at(end_of_frustum(world)[3]), FAR, 18.0)
    if image and np.linalg.norm(world.plane[0] - world.corners[0]) > 1e-3 * world.radius:
        overlay.label("the picture", view.at(world.plane[2]), VIEW, 18.0)


def _far_name(world: World) -> str:
    """Where the far plane is, as far as the numbers of the projection matrix, of 24 bits, tell it."""
    near, far = float(world.corners[0, 2]), float(world.corners[4, 2])
    return f"far plane at z = {far:.3g}" if abs(far) < 1e4 * abs(near) else "far plane, far away"


def _light_name(world: World, number: int, light: Light) -> str:
    if light.position[3] == 0.0:
        return f"light {number}, a direction"
    place = np.array(light.position[:3]) / light.position[3]
    kind = "spotlight" if light.spot_cutoff != 180.0 else "light"
    return f"{kind} {number}" + ("" if np.allclose(place, lamp_place(world, light)) else ", farther away")


def _draw_light(overlay: Overlay, world: World, view: View, light: Light) -> None:
    lamp = lamp_place(world, light)
    towards = normalize(world.middle - lamp)
    if light.position[3] == 0.0:  # parallel arrows
        side = normalize(np.cross(towards, (0.3, 1.0, 0.2)))
        for offset in (-0.24, 0.0, 0.24):
            start = lamp + offset * world.radius * side
            overlay.arrow(view.at(start), view.at(start + 0.62 * world.radius * towards), LIGHT, 2.6)
        return
    at = np.array(view.at(lamp))
    for k in range(8):
        ray = np.array([np.cos(np.pi * k / 4), np.sin(np.pi * k / 4)])
        overlay.line([tuple(at + 8.0 * ray), tuple(at + 15.0 * ray)], LIGHT, 2.2)
    overlay.disc((float(at[0]), float(at[1])), 5.5, LIGHT)
    if light.spot_cutoff != 180.0:
        _draw_cone(overlay, view, lamp, normalize(light.spot_direction), light.spot_cutoff,
                   float(np.linalg.norm(world.middle - lamp)))  # fmt: skip


def _draw_cone(overlay: Overlay, view: View, lamp: Float, axis: Float, cutoff: float, length: float) -> None:
    """The cone of a spotlight; cutoff: degrees."""
    side = normalize(np.cross(axis, (0.31, 0.93, 0.17)))
    other = np.cross(axis, side)
    angle = np.radians(min(cutoff, 89.0))
    turns = np.linspace(0.0, 2.0 * np.pi, 49)
    ring = [
        lamp + length * (np.cos(angle) * axis + np.sin(angle) * (np.cos(t) * side + np.sin(t) * other)) for t in turns
    ]
    overlay.line([view.at(point) for point in ring], LIGHT, 1.6)
    for point in ring[:-1:6]:
        overlay.dashed(view.at(lamp), view.at(point), LIGHT, 1.4)
    overlay.arrow(view.at(lamp), view.at(lamp + 0.5 * length * axis), LIGHT, 2.2)
