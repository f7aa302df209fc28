"""The world from outside: what is drawn, the camera that sees it, its frustum, and the lights, in eye space."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from glsim import gl
from glsim.glu.view import gluLookAt, gluPerspective
from glsim.machine.frame import Draw, Frame, Packet
from glsim.machine.matrix import leaf
from glsim.machine.state import Depth, Light, Scissor, Stencil, Viewport
from glsim.play.frames import frame_of
from glsim.render.context import Offscreen, own_screen
from glsim.shading import normalize
from glsim.study.overlay import Overlay, Place

if TYPE_CHECKING:
    from PIL import Image

Float = NDArray[np.float64]
BACKGROUND = (0.93, 0.93, 0.91)
CAMERA, NEAR, FAR, LIGHT, VIEW = (40, 40, 46), (0, 114, 178), (86, 150, 200), (214, 130, 0), (110, 114, 124)
AXES = {"x": (213, 94, 0), "y": (0, 150, 110), "z": (0, 114, 178)}
ANGLE = 28.0  # degrees: angle of view from outside
DIRECTIONS = ((50.0, 22.0), (-50.0, 22.0), (68.0, 26.0), (-68.0, 26.0), (36.0, 30.0), (-36.0, 30.0))


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
    world = _world(frame)
    with own_screen(width, height, samples=4) as screen:
        view = _view(world, (width, height), azimuth, elevation)
        _draw_world(screen, world, view)
        if image:
            _draw_picture(world)
        _draw_lines(world)
        overlay = Overlay(screen.image())
    _draw_over(overlay, world, view, axes, labels, image)
    return overlay.image()


@dataclass(frozen=True)
class _World:
    """All in eye space.  draws: those of the camera; corners: of the frustum, near then far, (8, 3); low, high: of the
    surfaces (3,); lights: those that are on, by number; picture: what the camera takes, (h, w, 4), top row first;
    plane: of that picture, (4, 3); far_shown: whether the far plane is near enough to be shown."""

    draws: list[Draw]
    corners: Float
    perspective: bool
    low: Float
    high: Float
    lights: dict[int, Light]
    picture: NDArray[np.uint8]
    plane: Float
    far_shown: bool

    @property
    def middle(self) -> Float:
        return np.asarray((self.low + self.high) / 2.0)

    @property
    def radius(self) -> float:
        return float(np.linalg.norm(self.high - self.low)) / 2.0

    @property
    def eye(self) -> Float:
        """Where the eye is; of a parallel projection, the middle of the near plane."""
        return np.zeros(3) if self.perspective else np.asarray(self.corners[:4].mean(axis=0))


def _world(frame: Frame) -> _World:
    draws = [draw for draw in frame.draws if draw.count and any(draw.state.color_buffer.mask[:3])]
    if not draws:
        raise ValueError("outside: nothing is drawn, so there is no world to show")
    cameras: dict[bytes, list[Draw]] = {}
    for draw in draws:
        cameras.setdefault(draw.matrices[1].get().tobytes(), []).append(draw)
    draws = max(cameras.values(), key=lambda of: sum(draw.count for draw in of))
    projection = draws[0].matrices[1].get().astype(float)
    try:
        inverse = np.linalg.inv(projection)
    except np.linalg.LinAlgError:
        raise ValueError("outside: the projection matrix has no inverse, so there is no frustum to show") from None
    ndc = np.array([(x, y, z, 1.0) for z in (-1, 1) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))], float)
    corners = ndc @ inverse
    corners = corners[:, :3] / corners[:, 3:]
    with own_screen(frame.width, frame.height) as screen:
        screen.execute(frame.packets)
        picture, depth = screen.pixels(), screen.depth()
    low, high = _extent(draws, depth, inverse)
    lights: dict[int, Light] = {}
    for draw in draws:
        lighting = draw.state.lighting
        if lighting.enabled:
            lights |= {k: lighting.lights[k] for k, on in enumerate(lighting.light_enabled) if on}
    perspective = bool(abs(projection[2, 3]) > 1e-9)
    plane, far_shown = _planes(corners, low, high)
    return _World(draws, corners, perspective, low, high, lights, picture, plane, far_shown)


def _extent(draws: list[Draw], depth: NDArray[np.float32], inverse: Float) -> tuple[Float, Float]:
    """The box around the surfaces: of all vertices, but not much larger than what is seen."""
    points = []
    for draw in draws:
        rows = draw.block.rows[draw.first : draw.first + draw.count, :3].astype(float)
        points.append(np.column_stack([rows, np.ones(len(rows))]) @ draw.matrices[0].get().astype(float))
    eye = np.concatenate(points)
    eye = eye[np.isfinite(eye).all(axis=1)]
    low, high = eye[:, :3].min(axis=0), eye[:, :3].max(axis=0)
    rows, columns = np.nonzero(depth < 1.0)
    if len(rows):
        shape = depth.shape
        ndc = np.column_stack([2.0 * (columns + 0.5) / shape[1] - 1.0, 1.0 - 2.0 * (rows + 0.5) / shape[0],
                               2.0 * depth[rows, columns] - 1.0, np.ones(len(rows))])  # fmt: skip
        seen = ndc @ inverse
        seen = seen[:, :3] / seen[:, 3:]
        first, last = seen.min(axis=0), seen.max(axis=0)
        room = 0.75 * float(np.max(last - first))
        low, high = np.maximum(low, first - room), np.minimum(high, last + room)
    return low, np.maximum(high, low + 1e-6)


def _planes(corners: Float, low: Float, high: Float) -> tuple[Float, bool]:
    """The plane of the picture (4, 3), and whether the far plane is near enough to be shown.

    The picture is taken on the near plane; it is shown there, or if that is too near to the eye to be seen, between
    eye and surfaces, where the same rays give the same picture.
    """
    near, far = float(corners[0, 2]), float(corners[4, 2])
    front, back = float(high[2]), float(low[2])
    place = near - 0.4 * max(near - front, 0.0)
    t = (place - near) / (far - near)
    plane = corners[:4] + t * (corners[4:] - corners[:4])
    size = max(float(np.linalg.norm(high - low)), 1e-9)
    return plane, abs(far) <= abs(back) + 1.5 * size


# ---------------------------------------------------------------- where it is seen from


@dataclass(frozen=True)
class _View:
    """A camera outside: its eye and target in eye space, and the size of the picture."""

    eye: Float
    target: Float
    size: tuple[int, int]

    @property
    def matrix(self) -> Float:
        """From eye space to the outside camera's (4, 4), points as rows."""
        back = normalize(self.eye - self.target)
        right = normalize(np.cross((0.0, 1.0, 0.0), back))
        turn = np.eye(4)
        turn[:3, :3] = np.stack([right, np.cross(back, right), back], axis=1)
        turn[3, :3] = -self.eye @ turn[:3, :3]
        return turn

    def at(self, P: ArrayLike) -> Place:
        x, y, z = (np.append(np.asarray(P, float), 1.0) @ self.matrix)[:3]
        scale = 0.5 * self.size[1] / np.tan(np.radians(ANGLE / 2.0)) / max(-z, 1e-9)
        return float(self.size[0] / 2.0 + x * scale), float(self.size[1] / 2.0 - y * scale)

    def distance(self, P: ArrayLike) -> float:
        return float(np.linalg.norm(np.asarray(P, float) - self.eye))


def _view(world: _World, size: tuple[int, int], azimuth: float | None, elevation: float | None) -> _View:
    """The view from the given direction, or from the one where the parts are farthest from each other."""
    choices = [
        (a if azimuth is None else azimuth, e if elevation is None else min(max(elevation, -89.0), 89.0))
        for a, e in DIRECTIONS
    ]
    parts = [
        world.eye,
        world.middle,
        world.plane.mean(axis=0),
        *(_lamp(world, light) for light in world.lights.values()),
    ]

    def apart(view: _View) -> float:
        places = [np.array(view.at(part)) for part in parts]
        return min(float(np.linalg.norm(p - q)) for k, p in enumerate(places) for q in places[:k])

    return max((_fitted(world, size, a, e) for a, e in dict.fromkeys(choices)), key=apart)


def _fitted(world: _World, size: tuple[int, int], azimuth: float, elevation: float) -> _View:
    """The nearest view from a direction in which all that is shown has room."""
    points = _shown_points(world)
    a, e = np.radians(azimuth), np.radians(elevation)
    back = np.array([np.sin(a) * np.cos(e), np.sin(e), np.cos(a) * np.cos(e)])
    right = normalize(np.cross((0.0, 1.0, 0.0), back))
    up = np.cross(back, right)
    x, y, z = points @ right, points @ up, points @ back
    tangent_y = 0.86 * np.tan(np.radians(ANGLE / 2.0))
    tangent_x = tangent_y * size[0] / size[1]
    # the eye at (x_0, y_0, d) sees all if |x - x_0| <= (d - z) tangent: both bounds of each axis give x_0 and d
    spans = [
        ((v + t * z).max() + (t * z - v).max(), (v + t * z).max() - (t * z - v).max(), t)
        for v, t in ((x, tangent_x), (y, tangent_y))
    ]
    d = max(span / (2.0 * t) for span, _, t in spans)
    x_0, y_0 = (difference / 2.0 for _, difference, _ in spans)
    eye = x_0 * right + y_0 * up + d * back
    return _View(eye, eye - back * (d - float(z.mean())), size)


def _shown_points(world: _World) -> Float:
    """What the view must have room for (n, 3)."""
    box = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    points = [world.low + box * (world.high - world.low), world.eye[None], world.corners[:4]]
    points += [np.array([_lamp(world, light)]) for light in world.lights.values()]
    points += [_axis_ends(world)]
    points += [_end_of_frustum(world)]
    return np.concatenate(points)


def _axis_ends(world: _World) -> Float:
    return np.asarray(
        world.eye + 0.32 * max(world.radius, 0.15 * float(np.linalg.norm(world.middle - world.eye))) * np.eye(3)
    )


def _lamp(world: _World, light: Light) -> Float:
    """Where a light is drawn: at its position; a direction, or a position far away, near the surfaces."""
    position = np.array(light.position, float)
    reach = 1.7 * world.radius
    if position[3] == 0.0:
        return np.asarray(world.middle + reach * normalize(position[:3]))
    place = position[:3] / position[3]
    away = place - world.middle
    most = 4.0 * max(world.radius, 0.5 * float(np.linalg.norm(world.middle - world.eye)))
    if np.linalg.norm(away) > most:
        return np.asarray(world.middle + most * normalize(away))
    return np.asarray(place)


# ---------------------------------------------------------------- drawing with the gl commands


def _draw_world(screen: Offscreen, world: _World, view: _View) -> None:
    """Clear, and draw the surfaces as the camera lights them, seen from outside; sets the matrices of the view."""
    width, height = view.size
    reach = max(view.distance(point) for point in _shown_points(world))
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


def _outside_state(draw: Draw, view: _View) -> Any:
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


def _draw_picture(world: _World) -> None:
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


def _draw_lines(world: _World) -> None:
    """The frustum and the axis of view, hidden by what is in front of them."""
    gl.glEnable(gl.GL_DEPTH_TEST)
    gl.glEnable(gl.GL_LINE_SMOOTH)
    gl.glEnable(gl.GL_BLEND)
    gl.glBlendFunc(gl.GL_SRC_ALPHA, gl.GL_ONE_MINUS_SRC_ALPHA)
    near, end = world.corners[:4], _end_of_frustum(world)
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


def _end_of_frustum(world: _World) -> Float:
    """Where its edges end (4, 3): at the far plane, or behind the surfaces if that is too far away."""
    near, far = world.corners[:4], world.corners[4:]
    if world.far_shown:
        return far
    depth = world.low[2] - 0.1 * world.radius
    t = (depth - near[0, 2]) / (far[0, 2] - near[0, 2])
    return np.asarray(near + t * (far - near))


# ---------------------------------------------------------------- drawing over the picture


def _draw_over(overlay: Overlay, world: _World, view: _View, axes: bool, labels: bool, image: bool) -> None:
    """Camera, axes, lights and names."""
    eye = view.at(world.eye)
    if axes:
        for (name, color), end in zip(AXES.items(), _axis_ends(world), strict=True):
            overlay.arrow(eye, view.at(end), color, 2.4)
            overlay.label(name, view.at(end), color, 19.0)
    overlay.disc(eye, 6.0, CAMERA)
    for number, light in world.lights.items():
        _draw_light(overlay, world, view, light)
        if labels:
            overlay.label(_light_name(world, number, light), view.at(_lamp(world, light)), LIGHT, 18.0)
    if not labels:
        return
    overlay.label("eye" if world.perspective else "parallel projection", eye, CAMERA, 20.0)
    overlay.label("near plane", view.at(world.corners[3]), NEAR, 18.0)
    if world.far_shown:
        overlay.label("far plane", view.at(world.corners[7]), FAR, 18.0)
    else:
        overlay.label(_far_name(world), view.at(_end_of_frustum(world)[3]), FAR, 18.0)
    if image and np.linalg.norm(world.plane[0] - world.corners[0]) > 1e-3 * world.radius:
        overlay.label("the picture", view.at(world.plane[2]), VIEW, 18.0)


def _far_name(world: _World) -> str:
    """Where the far plane is, as far as the numbers of the projection matrix, of 24 bits, tell it."""
    near, far = float(world.corners[0, 2]), float(world.corners[4, 2])
    return f"far plane at z = {far:.3g}" if abs(far) < 1e4 * abs(near) else "far plane, far away"


def _light_name(world: _World, number: int, light: Light) -> str:
    if light.position[3] == 0.0:
        return f"light {number}, a direction"
    place = np.array(light.position[:3]) / light.position[3]
    kind = "spotlight" if light.spot_cutoff != 180.0 else "light"
    return f"{kind} {number}" + ("" if np.allclose(place, _lamp(world, light)) else ", farther away")


def _draw_light(overlay: Overlay, world: _World, view: _View, light: Light) -> None:
    lamp = _lamp(world, light)
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


def _draw_cone(overlay: Overlay, view: _View, lamp: Float, axis: Float, cutoff: float, length: float) -> None:
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
