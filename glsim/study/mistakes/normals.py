"""Mistakes with the lengths of normals, and highlights that are lost between them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.assembly import corners
from glsim.machine.stage import illumination, vertex_stage, window
from glsim.shading import normalize
from glsim.study.mistakes.camera import is_flat
from glsim.study.mistakes.rules import Findings, Rule, Seen, rule

Float = NDArray[np.float64]
MAX_PRIMITIVES = 3000  # primitives of a Draw that are looked at
LARGE = 100  # number of the largest triangles, which are sampled at steps of 1/8 instead of 1/3
TOPIC = "normals and winding"


def lit_with_normals(seen: Seen) -> bool:
    return seen.lit and not seen.bent and not without_normals(seen)


def without_normals(seen: Seen) -> bool:
    """Whether all normals are the initial (0, 0, 1) without a glNormal, though some triangle faces elsewhere."""
    draw, chosen = seen.draw, seen.chosen
    rows = draw.block.rows[np.unique(chosen), 3:6]
    if corners(draw.mode) != 3 or "glNormal" in seen.provenance.registers or not (rows == (0.0, 0.0, 1.0)).all():
        return False
    triangles = draw.block.rows[chosen.reshape(-1, 3)[:MAX_PRIMITIVES], :3].astype(np.float64)
    faces = normalize(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]))
    return bool(((np.abs(faces[:, 2]) < 0.99) & faces.any(axis=1)).any())


@rule
class WithoutNormals(Rule):
    """Silent for surfaces that face along z, whose normal is the initial one."""

    kind, topic = "lighting-without-normals", TOPIC
    looks_at = "GL_LIGHTING without any glNormal"
    sentence = (
        "GL_LIGHTING is on, but no normal was ever set: every vertex has (0, 0, 1), so the light does not depend on the"
        " surface; call glNormal before glVertex"
    )

    def on_draw(self, seen: Seen) -> Findings:
        if seen.lit and not seen.bent and without_normals(seen):
            yield seen.call, {}


def lengths(seen: Seen) -> tuple[str, dict[str, Any]] | None:
    """The kind of mistake with normals in eye space that are not of unit length, and the words for it."""
    if "lengths" not in seen.memo:
        seen.memo["lengths"] = _lengths(seen) if lit_with_normals(seen) else None
    found: tuple[str, dict[str, Any]] | None = seen.memo["lengths"]
    return found


def _lengths(seen: Seen) -> tuple[str, dict[str, Any]] | None:
    draw = seen.draw
    numbers = np.unique(seen.chosen[: 3 * MAX_PRIMITIVES])
    normals = vertex_stage(draw, numbers, 0, colors=False).normal
    length = np.linalg.norm(normals, axis=1)
    wrong = np.abs(length - 1.0) > 0.02
    if wrong.mean() < 0.1:
        return None
    all_given = np.linalg.norm(draw.block.rows[numbers, 3:6].astype(float), axis=1)
    given = float(np.median(all_given))
    if not length[wrong].any():
        matrix = "the modelview matrix flattens the scene, as glScale by 0 does"
        return "normals-zero", {"cause": matrix if given else "glNormal got (0, 0, 0)"}
    kind = "normals-scaled" if abs(given - 1.0) <= 0.02 else "normals-not-unit"
    return kind, {"length": _span(length[wrong]), "given": _span(all_given[wrong])}


def _span(values: Float) -> str:
    """ "2" if the values (n,) agree within 2 %, else "2 to 3"."""
    low, high = float(values.min()), float(values.max())
    return f"{high:.3g}" if high - low <= 0.02 * high else f"{low:.3g} to {high:.3g}"


class _Length(Rule):
    topic = TOPIC

    def on_draw(self, seen: Seen) -> Findings:
        found = lengths(seen)
        if found is not None and found[0] == self.kind:
            yield seen.call, found[1]


@rule
class NormalsScaled(_Length):
    """Silent with GL_NORMALIZE, and if fewer than a tenth of the normals are wrong."""

    kind = "normals-scaled"
    looks_at = "normals that the modelview matrix scales"
    sentence = "normals have length {length} in eye space, because the modelview matrix scales: glEnable(GL_NORMALIZE)"


@rule
class NormalsNotUnit(_Length):
    """Silent with GL_NORMALIZE, and if fewer than a tenth of the normals are wrong."""

    kind = "normals-not-unit"
    looks_at = "normals of other lengths than 1"
    sentence = "normals have length {length} in eye space (glNormal got {given}): glEnable(GL_NORMALIZE)"


@rule
class NormalsZero(_Length):
    """Silent where a gluLookAt flattens the scene, which is said already."""

    kind = "normals-zero"
    looks_at = "normals without a direction"
    sentence = "normals have length 0 in eye space: {cause}; without a direction there is no light"

    def on_draw(self, seen: Seen) -> Findings:
        if not self.calls_of(seen.modelview_calls, is_flat):
            yield from super().on_draw(seen)


@rule
class HighlightLost(Rule):
    """Inside a triangle of more than 100 pixels the specular term at the interpolated normal exceeds the interpolated
    specular terms of the vertices by at least 0.25.  Silent below that, and without GL_SMOOTH."""

    kind, topic = "highlight-lost", TOPIC
    looks_at = "highlights lost between vertices"
    sentence = (
        "the highlight is lost between the vertices: inside a triangle it would be {inside:.2f}, interpolated it is"
        " {interpolated:.2f}; use more vertices, or glShadeModel(GL_PHONG_WIN)"
    )

    def on_draw(self, seen: Seen) -> Findings:
        face = seen.draw.material.front
        shiny = max(face.specular[:3]) > 0.0 and face.shininess >= 2.0
        smooth = seen.state.lighting.shade_model == gl.GL_SMOOTH
        if shiny and smooth and corners(seen.draw.mode) == 3 and lit_with_normals(seen):
            inside, interpolated = lost_highlight(seen)
            if inside - interpolated >= 0.25:
                yield seen.call, {"inside": inside, "interpolated": interpolated}


def lost_highlight(seen: Seen) -> tuple[float, float]:
    """The largest specular term inside a triangle against the interpolated one, where they differ most."""
    draw, lighting = seen.draw, seen.state.lighting
    triangles = seen.chosen.reshape(-1, 3)
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
    return worst


def _inside(steps: int) -> list[Float]:
    """Weights of the corners for points that are evenly spread in a triangle and on its edges."""
    numbers = range(steps)
    return [np.array([i, j, k]) / steps for i in numbers for j in numbers if (k := steps - i - j) in numbers]


def _areas(at: Float) -> Float:
    """Areas of triangles (n, 3, 2)."""
    one, two = at[:, 1] - at[:, 0], at[:, 2] - at[:, 0]
    return np.asarray(np.abs(one[:, 0] * two[:, 1] - one[:, 1] * two[:, 0]) / 2.0)
