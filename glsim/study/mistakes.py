"""Classic mistakes, each found in the calls and the Draws of a program and said in a sentence."""

from __future__ import annotations

import inspect
import math
from collections.abc import Iterator, Sequence
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.assembly import corners
from glsim.machine.commands import COMMANDS, FAMILIES
from glsim.machine.frame import Call, Draw, Frame, Moment, Where
from glsim.machine.record import implementations
from glsim.machine.stage import illumination, vertex_stage, window
from glsim.render.batch import assembled
from glsim.shading import normalize
from glsim.study.provenance import BEFORE, Path, Provenance
from glsim.study.text import call_text

Float = NDArray[np.float64]
MAX_PRIMITIVES = 3000  # primitives of a Draw that are looked at
LARGE = 100  # number of the largest triangles, which are sampled at steps of 1/8 instead of 1/3

# kind -> what is said
DIAGNOSES = {
    "normals-scaled": "normals have length {length} in eye space, because the modelview matrix scales:"
    " glEnable(GL_NORMALIZE)",
    "normals-not-unit": "normals have length {length} in eye space (glNormal got {given}): glEnable(GL_NORMALIZE)",
    "normals-zero": "normals have length 0 in eye space: {cause}; without a direction there is no light",
    "up-along-view": "{camera}: up is parallel to the direction of view, or eye and centre are the same point, so"
    " nobody knows where right is, and nothing is seen: choose another up, such as (0, 0, -1) for a view from above",
    "position-of-three": "GL_POSITION of GL_LIGHT{light} has three numbers; the missing w counts as 0, a direction, and"
    " in C it would be whatever lies behind the array: add 1.0 for a lamp at that point, 0.0 for a direction",
    "light-before-camera": "the position of GL_LIGHT{light} was set before {camera}: it is fixed to the camera;"
    " if it shall stay in the world, set GL_POSITION after gluLookAt",
    "lighting-without-normals": "GL_LIGHTING is on, but no normal was ever set: every vertex has (0, 0, 1), so the"
    " light does not depend on the surface; call glNormal before glVertex",
    "color-material-order": "glEnable(GL_COLOR_MATERIAL){line} came before this glColorMaterial: in between the current"
    " colour went into ambient and diffuse of both sides; call glColorMaterial first",
    "highlight-lost": "the highlight is lost between the vertices: inside a triangle it would be {inside:.2f},"
    " interpolated it is {interpolated:.2f}; use more vertices, or glShadeModel(GL_PHONG_WIN)",
    "near-plane": "{call}: the near plane is at {near:g}; it must be in front of the eye, more than 0, or depth has no"
    " resolution",
    "radians": "{call} turns by {angle:.4g} degrees; if {degrees:.6g} degrees were meant, leave out the conversion:"
    " glRotate takes degrees",
    "matrix-stack": "this glPushMatrix has no glPopMatrix: if that is so in each frame, the stack overflows",
    "depth-not-cleared": "GL_DEPTH_TEST is on, but this glClear leaves the depth buffer as it is: the next frame is"
    " hidden behind this one; add GL_DEPTH_BUFFER_BIT",
    "surplus": "{call}: {name} takes {count} ({names}) and ignores what comes after{other}",
    "projection-in-modelview": "{call} is in the modelview matrix: lighting, fog and clip planes see positions and"
    " normals that perspective has bent; call glMatrixMode(GL_PROJECTION) before it, and glMatrixMode(GL_MODELVIEW)"
    " after it",
    "missing-buffer": "{test} has no effect, because the window has no {buffer} buffer: add {flag} to"
    " glutInitDisplayMode",
    "error": "{error}",
}


# kind -> what was looked at, also where nothing was found
CHECKED = {
    "normals-scaled": "normals that the modelview matrix makes longer or shorter, without GL_NORMALIZE",
    "normals-not-unit": "glNormal with lengths other than 1, without GL_NORMALIZE",
    "normals-zero": "normals without a direction",
    "up-along-view": "gluLookAt whose up points where the camera looks",
    "position-of-three": "a GL_POSITION of three numbers",
    "light-before-camera": "lights that are placed before gluLookAt",
    "lighting-without-normals": "GL_LIGHTING without any glNormal",
    "color-material-order": "GL_COLOR_MATERIAL enabled before glColorMaterial",
    "highlight-lost": "highlights that GL_SMOOTH loses between the vertices",
    "near-plane": "a near plane at or behind the eye",
    "radians": "glRotate with radians",
    "matrix-stack": "glPushMatrix without glPopMatrix",
    "depth-not-cleared": "GL_DEPTH_TEST with a depth buffer that is never cleared",
    "surplus": "arguments that a command ignores",
    "projection-in-modelview": "a projection in the modelview matrix, where lighting, fog or clip planes are on",
    "missing-buffer": "a depth or stencil test without its buffer",
    "error": "an error that ends the program",
}


class Mistake(NamedTuple):
    """kind: of DIAGNOSES; call: its number."""

    kind: str
    sentence: str
    call: int
    where: Where | None


class Detector:
    """Is told each call and each Draw in order, and says what is wrong."""

    def __init__(self, frame: Frame) -> None:
        self.frame = frame
        self.color_material_on: int | None = None  # glEnable(GL_COLOR_MATERIAL) that came before any glColorMaterial
        self.color_material_said = False
        self.pushes: dict[int, list[int]] = {}  # by matrix mode
        self.clear: int | None = None  # the last glClear of the colour buffer
        self.depth_clear: int | None = None
        self.flat_view = False  # whether the last gluLookAt made a matrix with a zero axis
        self.stale: int | None = None  # a glClear without the depth buffer, before a Draw with the depth test

    def _mistake(self, kind: str, number: int, **words: Any) -> Mistake:
        where = self.frame.calls[number].where if 0 <= number < len(self.frame.calls) else None
        return Mistake(kind, DIAGNOSES[kind].format(**words), number, where)

    def _line(self, call: int) -> str:
        where = self.frame.calls[call].where
        return f" (line {where.line})" if where is not None else ""

    # ------------------------------------------------------------ calls

    def call(self, number: int, call: Call, before: Moment, after: Moment) -> Iterator[Mistake]:
        name, arguments = call.name, call.arguments
        yield from self._surplus(number, call)
        if name in ("glEnable", "glDisable") and arguments[0] == gl.GL_COLOR_MATERIAL:
            self.color_material_on = number if name == "glEnable" and not self.color_material_said else None
        elif name == "glColorMaterial":
            yield from self._color_material(number, before, after)
        elif name.startswith("glRotate") and _is_radians(float(arguments[0])):
            angle = float(arguments[0])
            yield self._mistake("radians", number, call=call_text(call), angle=angle, degrees=math.degrees(angle))
        elif name.startswith("glMultMatrix") and _via(call).startswith("gluLookAt"):
            self.flat_view = not np.asarray(arguments[0]).reshape(4, 4)[:3, :3].any(axis=0).all()
            if self.flat_view:
                yield self._mistake("up-along-view", number, camera=_via(call))
        elif name.startswith("glLight") and arguments[1:2] == (gl.GL_POSITION,) and np.size(arguments[2]) == 3:
            yield self._mistake("position-of-three", number, light=int(arguments[0]) - gl.GL_LIGHT0)
        elif name == "glFrustum" or _via(call).startswith("gluPerspective"):
            near = _near(call)
            if near is not None and near <= 0.0:
                yield self._mistake("near-plane", number, call=_via(call) or call_text(call), near=near)
        elif name == "glPushMatrix" and after is not before:
            self.pushes.setdefault(before.state.transform.matrix_mode, []).append(number)
        elif name == "glPopMatrix" and self.pushes.get(before.state.transform.matrix_mode) and after is not before:
            self.pushes[before.state.transform.matrix_mode].pop()
        elif name == "glClear":
            if int(arguments[0]) & gl.GL_COLOR_BUFFER_BIT:
                self.clear = number
            if int(arguments[0]) & gl.GL_DEPTH_BUFFER_BIT:
                self.depth_clear = number

    def _surplus(self, number: int, call: Call) -> Iterator[Mistake]:
        names = _parameters(call.name)
        if len(call.arguments) <= len(names):
            return
        one = COMMANDS[call.name]
        wider = [
            c.name for c in FAMILIES[one.family] if len(c.parameters) == len(call.arguments) and c.type == one.type
        ]
        other = f": {wider[0]} takes {len(call.arguments)}" if wider else ""
        count = f"{len(names)} argument{'s' * (len(names) != 1)}"
        words = {"call": call_text(call), "name": call.name, "count": count, "names": ", ".join(names), "other": other}
        yield self._mistake("surplus", number, **words)

    def _color_material(self, number: int, before: Moment, after: Moment) -> Iterator[Mistake]:
        old, new = before.state.lighting, after.state.lighting
        same = old.color_material_face == new.color_material_face and old.color_material_mode == new.color_material_mode
        if self.color_material_on is not None and not same:
            yield self._mistake("color-material-order", number, line=self._line(self.color_material_on))
        self.color_material_said, self.color_material_on = True, None

    # ------------------------------------------------------------ draws

    def draw(self, draw: Draw, provenance: Provenance, after: Moment) -> Iterator[Mistake]:
        """Check one Draw.  after: the state that the program set; in ``draw.state`` the depth and stencil tests are off
        where the window has no such buffer."""
        state, call = draw.state, draw.call or 0
        for kind in ("depth", "stencil"):
            if getattr(after.state, kind).test and not getattr(state, kind).test:
                test, flag = f"GL_{kind.upper()}_TEST", f"GLUT_{kind.upper()}"
                setter = provenance.setters.get((kind, "test"), call)
                yield self._mistake("missing-buffer", setter, test=test, buffer=kind, flag=flag)
        if (
            state.depth.test
            and state.depth.func != gl.GL_ALWAYS
            and self.clear is not None
            and not self._cleared_together()
        ):
            self.stale = self.clear
        chosen = assembled(draw)
        if not state.lighting.enabled or not len(chosen):
            return
        if np.any(draw.matrices[0].get()[:, 3] != (0.0, 0.0, 0.0, 1.0)):
            yield from self._perspective(call, provenance)
            return  # what else is strange about the lighting comes of it
        if self._without_normals(draw, chosen, provenance):
            yield self._mistake("lighting-without-normals", call)
        else:
            for kind, numbers in (*_lengths(draw, chosen), *_lost_highlight(draw, chosen)):
                if kind != "normals-zero" or not self.flat_view:
                    yield self._mistake(kind, call, **numbers)
        yield from self._lights(draw, provenance)

    def _cleared_together(self) -> bool:
        """Whether the depth buffer was cleared with, or a few lines from, the last glClear of colours."""
        if self.clear is None or self.depth_clear is None:
            return False
        one, two = (self.frame.calls[number].where for number in (self.clear, self.depth_clear))
        near = one is not None and two is not None and one.file == two.file and abs(one.line - two.line) <= 15
        return self.depth_clear >= self.clear or near

    def _without_normals(self, draw: Draw, chosen: NDArray[np.uint32], provenance: Provenance) -> bool:
        """Whether all normals are the initial (0, 0, 1) without a glNormal, though some triangle faces elsewhere."""
        rows = draw.block.rows[np.unique(chosen), 3:6]
        if corners(draw.mode) != 3 or "glNormal" in provenance.registers or not (rows == (0.0, 0.0, 1.0)).all():
            return False
        triangles = draw.block.rows[chosen.reshape(-1, 3)[:MAX_PRIMITIVES], :3].astype(np.float64)
        faces = normalize(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]))
        return bool(((np.abs(faces[:, 2]) < 0.99) & faces.any(axis=1)).any())

    def _perspective(self, draw: int, provenance: Provenance) -> Iterator[Mistake]:
        """The modelview is projective (w is not 1): name its first gluPerspective or glFrustum, else its last call."""
        chain = [call for call in provenance.chains["modelview"][-1] if call != BEFORE]
        named = [(_via(self.frame.calls[call]) or self.frame.calls[call].name, call) for call in chain]
        guilty = [(name, call) for name, call in named if name.startswith(("gluPerspective", "glFrustum"))]
        name, call = guilty[0] if guilty else ("a perspective projection", chain[-1] if chain else draw)
        yield self._mistake("projection-in-modelview", call, call=name)

    def _lights(self, draw: Draw, provenance: Provenance) -> Iterator[Mistake]:
        cameras = self._look_ats(provenance.chains["modelview"][-1])
        if not cameras:
            return
        lighting = draw.state.lighting
        for k, enabled in enumerate(lighting.light_enabled):
            path: Path = ("lighting", "lights", k, "position")
            setter, placed = provenance.setters.get(path, BEFORE), provenance.placed.get(path)
            if not enabled or placed is None or setter == BEFORE or setter > cameras[0] or self._look_ats(placed.chain):
                continue
            x, y, z, w = lighting.lights[k].position
            if x == y == 0.0 and (z == 0.0 or w == 0.0):  # a headlight, at the eye or along the view axis
                continue
            camera = _via(self.frame.calls[cameras[0]]) + self._line(cameras[0])
            yield self._mistake("light-before-camera", setter, light=k, camera=camera)

    def _look_ats(self, chain: Sequence[int]) -> list[int]:
        """The calls of gluLookAt among those that make a matrix."""
        return [call for call in chain if call != BEFORE and _via(self.frame.calls[call]).startswith("gluLookAt")]

    # ------------------------------------------------------------ the end

    def end(self) -> Iterator[Mistake]:
        for push in sorted(push for pushes in self.pushes.values() for push in pushes):
            yield self._mistake("matrix-stack", push)
        if self.stale is not None:
            yield self._mistake("depth-not-cleared", self.stale)
        if self.frame.error:
            last = len(self.frame.calls) - 1
            yield self._mistake("error", last, error=self.frame.error)._replace(where=self.frame.error_at)


@cache
def _parameters(name: str) -> tuple[str, ...]:
    return tuple(inspect.signature(implementations[name]).parameters)


def _via(call: Call) -> str:
    return call.where.via if call.where is not None else ""


def _is_radians(angle: float) -> bool:
    """Whether an angle for glRotate looks like degrees converted to radians: exactly a whole or half number of degrees,
    or 30, 45, 60, 90, ... degrees in a few digits."""
    if angle == 0.0 or abs(angle) > 2.0 * math.pi + 1e-6 or angle.is_integer():
        return False
    degrees = abs(math.degrees(angle))
    exact = abs(2.0 * degrees - round(2.0 * degrees)) < 1e-6 and degrees > 0.5
    return exact or any(abs(degrees - usual) < 2e-3 * usual for usual in (30, 45, 60, 90, 120, 135, 150, 180, 270, 360))


def _near(call: Call) -> float | None:
    """The near plane of a perspective projection."""
    if call.name == "glFrustum":
        return float(call.arguments[4])
    if not call.name.startswith("glMultMatrix"):
        return None
    m = np.asarray(call.arguments[0], float).reshape(4, 4)
    return float(m[3, 2] / (m[2, 2] - 1.0)) if m[2, 2] != 1.0 else None


Findings = Iterator[tuple[str, dict[str, Any]]]


def _lengths(draw: Draw, chosen: NDArray[np.uint32]) -> Findings:
    """Normals in eye space that are not of unit length."""
    numbers = np.unique(chosen[: 3 * MAX_PRIMITIVES])
    normals = vertex_stage(draw, numbers, 0, colors=False).normal
    lengths = np.linalg.norm(normals, axis=1)
    wrong = np.abs(lengths - 1.0) > 0.02
    if wrong.mean() < 0.1:
        return
    all_given = np.linalg.norm(draw.block.rows[numbers, 3:6].astype(float), axis=1)
    given = float(np.median(all_given))
    if not lengths[wrong].any():
        matrix = "the modelview matrix flattens the scene, as glScale by 0 does"
        yield "normals-zero", {"cause": matrix if given else "glNormal got (0, 0, 0)"}
        return
    kind = "normals-scaled" if abs(given - 1.0) <= 0.02 else "normals-not-unit"
    yield kind, {"length": _span(lengths[wrong]), "given": _span(all_given[wrong])}


def _span(values: NDArray[np.float64]) -> str:
    """ "2" if the values (n,) agree within 2 %, else "2 to 3"."""
    low, high = float(values.min()), float(values.max())
    return f"{high:.3g}" if high - low <= 0.02 * high else f"{low:.3g} to {high:.3g}"


def _lost_highlight(draw: Draw, chosen: NDArray[np.uint32]) -> Findings:
    """Highlights that Gouraud shading loses: inside a triangle of more than 100 pixels the specular term at the
    interpolated normal exceeds the interpolated specular terms of the vertices by at least 0.25."""
    lighting, face = draw.state.lighting, draw.material.front
    shiny = max(face.specular[:3]) > 0.0 and face.shininess >= 2.0
    if lighting.shade_model != gl.GL_SMOOTH or corners(draw.mode) != 3 or not shiny:
        return
    triangles = chosen.reshape(-1, 3)
    numbers, places = np.unique(triangles[:: max(1, len(triangles) // MAX_PRIMITIVES)], return_inverse=True)
    stage = vertex_stage(draw, numbers, 0, colors=False)
    places = places.reshape(-1, 3)
    places = places[(stage.clip[places, 3] > 0.0).all(axis=1)]
    areas = _areas(window(stage.clip, draw.state.viewport)[places, :2])
    places = places[np.argsort(-areas)][: (areas > 100.0).sum()]  # the largest first
    point = stage.eye[:, :3] / stage.eye[:, 3:]

    def highlight(N: Float, P: Float) -> Float:
        terms, _ = illumination(lighting, gl.GL_FRONT, [draw.material] * len(P), N, P, np.ones((len(P), 4)))
        return np.asarray(np.clip(terms.highlight, 0.0, 1.0).max(axis=1))

    vertices = highlight(stage.normal, point)
    worst = (0.0, 0.0)
    for some, steps in ((places[:LARGE], 8), (places[LARGE:], 3)):  # a small highlight hides in a large triangle
        for weights in _inside(steps) if len(some) else ():
            N = normalize(np.einsum("k,nkc->nc", weights, stage.normal[some]))
            inside = highlight(N, np.einsum("k,nkc->nc", weights, point[some]))
            interpolated = vertices[some] @ weights
            k = int(np.argmax(inside - interpolated))
            worst = max(worst, (float(inside[k]), float(interpolated[k])), key=lambda pair: pair[0] - pair[1])
    if worst[0] - worst[1] >= 0.25:
        yield "highlight-lost", {"inside": worst[0], "interpolated": worst[1]}


def _inside(steps: int) -> list[Float]:
    """Weights of the corners for points that are evenly spread in a triangle and on its edges."""
    numbers = range(steps)
    return [np.array([i, j, k]) / steps for i in numbers for j in numbers if (k := steps - i - j) in numbers]


def _areas(at: Float) -> Float:
    """Areas of triangles (n, 3, 2)."""
    one, two = at[:, 1] - at[:, 0], at[:, 2] - at[:, 0]
    return np.asarray(np.abs(one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0]) / 2.0)
