"""What a Frame's world holds, in eye space, and from where all of it is seen: for the view from outside."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from glsim.machine.frame import Draw, Frame
from glsim.machine.state import Light
from glsim.render.context import own_screen
from glsim.shading import normalize
from glsim.study.overlay import Place

Float = NDArray[np.float64]
ANGLE = 28.0  # degrees: angle of view from outside
DIRECTIONS = ((50.0, 22.0), (-50.0, 22.0), (68.0, 26.0), (-68.0, 26.0), (36.0, 30.0), (-36.0, 30.0))


@dataclass(frozen=True)
class World:
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


def world_of(frame: Frame) -> World:
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
    return World(draws, corners, perspective, low, high, lights, picture, plane, far_shown)


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
class View:
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


def view_of(world: World, size: tuple[int, int], azimuth: float | None, elevation: float | None) -> View:
    """The view from the given direction, or from the one where the parts are farthest from each other."""
    choices = [
        (a if azimuth is None else azimuth, e if elevation is None else min(max(elevation, -89.0), 89.0))
        for a, e in DIRECTIONS
    ]
    parts = [
        world.eye,
        world.middle,
        world.plane.mean(axis=0),
        *(lamp_place(world, light) for light in world.lights.values()),
    ]

    def apart(view: View) -> float:
        places = [np.array(view.at(part)) for part in parts]
        return min(float(np.linalg.norm(p - q)) for k, p in enumerate(places) for q in places[:k])

    return max((_fitted(world, size, a, e) for a, e in dict.fromkeys(choices)), key=apart)


def _fitted(world: World, size: tuple[int, int], azimuth: float, elevation: float) -> View:
    """The nearest view from a direction in which all that is shown has room."""
    points = shown_points(world)
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
    return View(eye, eye - back * (d - float(z.mean())), size)


def shown_points(world: World) -> Float:
    """What the view must have room for (n, 3)."""
    box = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    points = [world.low + box * (world.high - world.low), world.eye[None], world.corners[:4]]
    points += [np.array([lamp_place(world, light)]) for light in world.lights.values()]
    points += [axis_ends(world)]
    points += [end_of_frustum(world)]
    return np.concatenate(points)


def axis_ends(world: World) -> Float:
    return np.asarray(
        world.eye + 0.32 * max(world.radius, 0.15 * float(np.linalg.norm(world.middle - world.eye))) * np.eye(3)
    )


def lamp_place(world: World, light: Light) -> Float:
    """Where a light is drawn: at its position; near the surfaces if that is a direction or far away."""
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


def end_of_frustum(world: World) -> Float:
    """Where the frustum's edges end, (4, 3): at the far plane, or behind the surfaces if the far plane is too far
    away."""
    near, far = world.corners[:4], world.corners[4:]
    if world.far_shown:
        return far
    depth = world.low[2] - 0.1 * world.radius
    t = (depth - near[0, 2]) / (far[0, 2] - near[0, 2])
    return np.asarray(near + t * (far - near))
