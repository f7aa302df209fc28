"""Mistakes with the projection and the camera: their matrices and their order."""

from __future__ import annotations

import ast
import math
from collections.abc import Callable
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from glsim.files import read_regular
from glsim.machine.frame import Call, Where
from glsim.study.mistakes.rules import Findings, Rule, Seen, is_look_at, is_perspective, rule, via
from glsim.study.provenance import BEFORE, Step
from glsim.study.text import call_text

CALLBACKS = ("glutDisplayFunc", "glutReshapeFunc", "glutIdleFunc", "glutTimerFunc")


def is_flat(call: Call) -> bool:
    """Whether this gluLookAt made a matrix with a zero axis."""
    return is_look_at(call) and not np.asarray(call.arguments[0]).reshape(4, 4)[:3, :3].any(axis=0).all()


@rule
class UpAlongView(Rule):
    """Silent unless the matrix of gluLookAt flattens the scene."""

    kind, topic = "up-along-view", "camera"
    looks_at = "gluLookAt's up along the view"
    sentence = (
        "{camera}: up is parallel to the direction of view, or eye and centre are the same point, so nobody knows where"
        " right is, and nothing is seen: choose another up, such as (0, 0, -1) for a view from above"
    )
    commands = frozenset({"glMultMatrix"})

    def on_call(self, step: Step) -> Findings:
        if is_flat(step.call):
            yield step.number, {"camera": via(step.call)}


@rule
class CameraInProjection(Rule):
    """Also found where the camera was written with glTranslate, glRotate or a matrix: the projection's w then depends
    on more than z; that is said only with light or fog.  Silent if nothing is drawn with it, for parallel projections
    that are turned, for the shift of a stereo pair, and for two projections (see PerspectiveAgain)."""

    kind, topic = "camera-in-projection", "camera"
    looks_at = "a camera in GL_PROJECTION"
    sentence = (
        "{call} is in the projection matrix: lighting, fog, clip planes and generated texture coordinates do not know"
        " where the camera is, so highlights and fog are wrong; call glMatrixMode(GL_MODELVIEW) before it"
    )

    def on_draw(self, seen: Seen) -> Findings:
        named = self.calls_of(seen.projection_calls, is_look_at)
        x, y, z, w = seen.draw.matrices[1].get()[:, 3].tolist()  # clip w = (x, y, z, w) . eye coordinates
        moved = z != 0.0 and max(abs(x), abs(y), abs(w)) > 1e-6 * abs(z)
        own = [call for call in seen.projection_calls if call != BEFORE]
        twice = len(self.calls_of(own, is_perspective)) > 1
        if named:
            yield named[0], {"call": via(self.frame.calls[named[0]])}
        elif moved and own and not twice and (seen.lit or seen.state.fog.enabled):
            yield own[-1], {"call": call_text(self.frame.calls[own[-1]])}


@rule
class ProjectionInModelview(Rule):
    """Silent where the modelview holds such a matrix and nothing is drawn with it; for a projective matrix that is
    neither gluPerspective nor glFrustum (a planar shadow), and for glOrtho (pixel coordinates), also where lighting is
    off."""

    kind, topic = "projection-in-modelview", "camera"
    looks_at = "a projection in the modelview matrix"
    sentence = (
        "{call} is in the modelview matrix: lighting, fog and clip planes see positions and normals that {effect};"
        " call glMatrixMode(GL_PROJECTION) before it, and glMatrixMode(GL_MODELVIEW) after it"
    )

    def on_draw(self, seen: Seen) -> Findings:
        chain = [call for call in seen.modelview_calls if call != BEFORE]
        parallel = self.calls_of(chain, lambda call: call.name == "glOrtho") if seen.lit else []
        named = self.calls_of(chain, is_perspective) or parallel
        if named and (seen.bent or parallel):
            effect = "perspective has bent" if seen.bent else "it has scaled, and mirrored along z"
            yield (
                named[0],
                {"call": via(self.frame.calls[named[0]]) or self.frame.calls[named[0]].name, "effect": effect},
            )
        elif seen.lit and seen.bent:
            yield (
                (chain[-1] if chain else seen.call),
                {"call": "a perspective projection", "effect": "perspective has bent"},
            )


@rule
class RotationBeforeCamera(Rule):
    """Silent for a turn about z (the camera is tilted), and for glTranslate (a stereo pair)."""

    kind, topic = "rotation-before-camera", "camera"
    looks_at = "a rotation before gluLookAt"
    sentence = (
        "{call} comes before {camera}: it turns the world about the eye, as if the camera looked elsewhere; if the"
        " object shall turn, call it after gluLookAt"
    )

    def on_draw(self, seen: Seen) -> Findings:
        chain = seen.modelview_calls
        cameras = self.calls_of(chain, is_look_at)
        if len(cameras) != 1:  # several: see CameraAgain
            return
        for number in self.calls_of(chain[: chain.index(cameras[0])], lambda call: call.name.startswith("glRotate")):
            _, x, y, _ = self.frame.calls[number].arguments[:4]
            if x or y:
                camera = via(self.frame.calls[cameras[0]]) + self.line(cameras[0])
                yield number, {"call": call_text(self.frame.calls[number]), "camera": camera}


@rule
class CameraAgain(Rule):
    """gluLookAt on top of another, or in a function that GLUT calls again and again, without glLoadIdentity or
    glPushMatrix.  Silent if it is not known that the function is called again."""

    kind, topic = "camera-again", "camera"
    looks_at = "gluLookAt without glLoadIdentity"
    sentence = (
        "{camera} is multiplied to what the modelview matrix holds from the time before: call glLoadIdentity before it"
    )

    def on_draw(self, seen: Seen) -> Findings:
        yield from again(self, seen, "modelview", is_look_at, "camera")


@rule
class PerspectiveAgain(Rule):
    """gluPerspective or glFrustum on top of another, or in a function that GLUT calls again and again, without
    glLoadIdentity or glPushMatrix.  Silent if it is not known that the function is called again."""

    kind, topic = "perspective-again", "camera"
    looks_at = "gluPerspective without glLoadIdentity"
    sentence = (
        "{call} is multiplied to what the projection matrix holds from the time before, when the window gets another"
        " size or picture: call glLoadIdentity before it"
    )

    def on_draw(self, seen: Seen) -> Findings:
        yield from again(self, seen, "projection", is_perspective, "call")


def again(self: Rule, seen: Seen, stack: str, is_it: Callable[[Call], bool], word: str) -> Findings:
    """The last of the calls asked for in a product of matrices, if there are two of them, or if it is made again and
    again and nothing begins the product anew."""
    matrices = seen.provenance.chains[stack]
    named = self.calls_of(matrices[-1], is_it)
    if not named:
        return
    call, first = self.frame.calls[named[-1]], matrices[-1][0]
    start = None if first == BEFORE else self.frame.calls[first]
    loaded = start.where if start is not None and start.name.startswith("glLoad") else None
    known = start is not None and len(matrices) == 1 and (loaded is not None or not start.name.startswith("glLoad"))
    if len(named) > 1 or (known and repeated(call.where, loaded)):
        yield named[-1], {word: via(call) or call_text(call)}


def repeated(where: Where | None, loaded: Where | None) -> bool:
    """Whether a line of the program is in a function that GLUT calls each time, and no glLoadIdentity before it is.

    loaded: the line of the glLoadIdentity or glLoadMatrix before it, if any.  It does not help if it is in no function
    or in the reshape function, and the line is in the display function."""
    if where is None:
        return False
    try:
        functions = _functions(read_regular(where.file, 1 << 20))
    except (OSError, ValueError, SyntaxError, RecursionError, MemoryError):
        return False
    mine = _around(functions, where)
    if mine is None or not functions[mine]:
        return False
    if loaded is None:
        return True
    other = _around(functions, loaded) if loaded.file == where.file else mine
    return other != mine and (other is None or functions[other] == "glutReshapeFunc")


def _around(functions: dict[tuple[int, int], str], where: Where) -> tuple[int, int] | None:
    """The innermost function around a line."""
    around = [lines for lines in functions if lines[0] <= where.line <= lines[1]]
    return max(around, default=None)


@lru_cache(8)
def _functions(source: bytes) -> dict[tuple[int, int], str]:
    """(first line, last line) of each function of a program -> to which of CALLBACKS it is given, or ""."""
    tree = ast.parse(source)
    given: dict[str, str] = {}
    for node in ast.walk(tree):
        callback = ast.unparse(node.func).rpartition(".")[2] if isinstance(node, ast.Call) else ""
        if isinstance(node, ast.Call) and callback in CALLBACKS:
            given |= {ast.unparse(argument).rpartition(".")[2]: callback for argument in node.args}
    functions = [node for node in ast.walk(tree) if isinstance(node, (ast.FunctionDef, ast.Lambda))]
    return {(f.lineno, f.end_lineno or f.lineno): given.get(getattr(f, "name", ""), "") for f in functions}


@rule
class NearPlane(Rule):
    """Silent for near planes in front of the eye."""

    kind, topic = "near-plane", "camera"
    looks_at = "near <= 0"
    sentence = (
        "{call}: the near plane is at {near:g}; it must be in front of the eye, more than 0, or depth has no resolution"
    )
    commands = frozenset({"glFrustum", "glMultMatrix"})

    def on_call(self, step: Step) -> Findings:
        if not is_perspective(step.call):
            return
        near, _ = near_and_far(step.call)
        if near <= 0.0:
            yield step.number, {"call": via(step.call) or call_text(step.call), "near": near}


def near_and_far(call: Call) -> tuple[float, float]:
    """The near and the far plane of glFrustum or gluPerspective; NaN if it is neither."""
    if call.name == "glFrustum":
        return float(call.arguments[4]), float(call.arguments[5])
    if not call.name.startswith("glMultMatrix"):
        return math.nan, math.nan
    m = np.asarray(call.arguments[0], np.float64).reshape(4, 4)
    return planes(m)


def planes(m: NDArray[np.float64]) -> tuple[float, float]:
    """The near and the far plane of a projection matrix (4, 4), its columns as rows; NaN if it has none."""
    if m[2, 3] != -1.0 or m[2, 2] == 1.0:
        return math.nan, math.nan
    far = math.inf if m[2, 2] == -1.0 else float(m[3, 2] / (m[2, 2] + 1.0))
    return float(m[3, 2] / (m[2, 2] - 1.0)), far


@rule
class CoarseDepth(Rule):
    """What the depth buffer of 24 bits tells apart at a distance z is z^2 / (near 2^24).  Silent without a depth test,
    while that is below 1/2000 of z for the middle one of the vertices, and if far is below 100,000 times near."""

    kind, topic = "coarse-depth", "camera"
    looks_at = "near too close to the eye"
    sentence = (
        "near is {near:.3g} and far {far:.3g}: at distance {z:.3g}, where this is drawn, the depth buffer tells apart"
        " only what is {step:.2g} apart; move the near plane away from the eye, to {better:.1g} or so"
    )

    def on_draw(self, seen: Seen) -> Findings:
        if not seen.state.depth.test or not seen.areas or seen.bent:
            return
        own = [call for call in seen.projection_calls if call != BEFORE]
        named = self.calls_of(own, is_perspective)
        matrix = seen.draw.matrices[1].get().astype(np.float64)
        near, far = near_and_far(self.frame.calls[named[-1]]) if named else planes(matrix)
        z = -seen.surface.points[..., 2]
        z = z[z > near]
        if not len(z) or not 0.0 < near * 1e5 <= far:
            return
        middle = float(np.median(z))
        step = middle**2 / (near * 2**24)
        if step > middle / 2000:
            words = {"near": near, "far": far, "z": middle, "step": step, "better": middle / 100}
            yield (named or own or [seen.call])[-1], words
