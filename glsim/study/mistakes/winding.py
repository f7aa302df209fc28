"""Mistakes with the order of corners and with normals that point the wrong way.

Neighbouring Draws with the same modelview matrix and state are looked at as one object: a cube whose faces are six
Draws is closed like one that is drawn at once.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.study.mistakes.normals import TOPIC
from glsim.study.mistakes.rules import Findings, Rule, Seen, rule
from glsim.study.mistakes.surfaces import MAX_TRIANGLES, Surface, joined

SHARE = 0.05  # of the triangles of an object that must be wrong
DISTINCT = 0.3  # the cosine below which normal and winding are not called opposed: coarse meshes are forgiven


@dataclass
class Thing:
    """Some Draws, their triangles, and how many triangles belong to each Draw."""

    draws: list[Seen]
    surface: Surface
    counts: list[int]

    @property
    def lit(self) -> bool:
        """Whether its normals are used, and were given."""
        lighting = self.draws[0].state.lighting
        flips = lighting.back_lighting == gl.GL_FLIP_NORMAL_GLSIM
        return lighting.enabled and any(lighting.light_enabled) and not flips and self.draws[0].normals_given

    @property
    def culled(self) -> bool:
        """Whether back faces are left out."""
        polygon = self.draws[0].state.polygon
        return polygon.cull and polygon.cull_face == gl.GL_BACK

    @cached_property
    def front(self) -> NDArray[np.bool_]:
        """Which triangles show their front on the screen."""
        return self.surface.front(self.draws[0].state.polygon.front_face)

    @cached_property
    def opposed(self) -> NDArray[np.bool_]:
        """Which triangles have normals on the side that the order of the corners calls the back."""
        sign = 1.0 if self.draws[0].state.polygon.front_face == gl.GL_CCW else -1.0
        return np.asarray(sign * self.surface.cosine < -DISTINCT)

    @cached_property
    def guilty(self) -> str:
        """Where normals and order are opposed: whether the "winding" or the "normals" are wrong; "" if nobody knows.

        Of a closed thing the normals point outside.  Else what is seen tells: normals that point to the eye are right.
        """
        opposed, surface = self.opposed, self.surface
        if not opposed.any():
            return ""
        seen = float(self.front[opposed].mean())  # normals away from the eye, front seen
        outward = float(np.sign(np.round(surface.outward[opposed], 1)).mean())
        if not surface.closed and not 0.1 < seen < 0.9:
            return "normals" if seen > 0.5 else "winding"
        if abs(outward) > 0.5 and surface.solid and (surface.closed or self.culled):
            return "winding" if outward > 0.0 else "normals"
        return ""

    @property
    def mirrored(self) -> bool:
        return bool(np.linalg.det(self.draws[0].draw.matrices[0].get()[:3, :3].astype(np.float64)) < 0.0)

    def draw_of(self, wrong: NDArray[np.bool_]) -> Seen:
        """The Draw of the first of some triangles."""
        return self.draws[int(np.searchsorted(np.cumsum(self.counts), int(np.argmax(wrong)), side="right"))]


def things(draws: list[Seen]) -> list[Thing]:
    """The objects that are made of filled triangles, without blending (its passes have their own rules)."""
    if not draws:
        return []
    if "things" not in draws[0].memo:
        draws[0].memo["things"] = _things(draws)
    found: list[Thing] = draws[0].memo["things"]
    return found


def _things(draws: list[Seen]) -> list[Thing]:

    def key(seen: Seen) -> tuple[object, ...]:
        state = seen.state
        return (seen.draw.matrices[0].get().tobytes(), seen.draw.matrices[1].get().tobytes(), state.polygon,
                state.lighting)  # fmt: skip

    result = []
    usable = [seen for seen in draws if seen.areas and not seen.bent and not seen.state.color_buffer.blend]
    for _, group in groupby(usable, key):
        some, total = [], 0
        for seen in group:
            if total < MAX_TRIANGLES:
                some.append(seen)
                total += len(seen.surface)
        result.append(Thing(some, joined([seen.surface for seen in some]), [len(seen.surface) for seen in some]))
    return result


def count(wrong: NDArray[np.bool_]) -> str:
    some, total = int(wrong.sum()), len(wrong)
    return (
        f"all {total} triangles"
        if some == total > 1
        else "the triangle"
        if total == 1
        else f"{some} of {total} triangles"
    )


@rule
class CulledFront(Rule):
    """GL_CULL_FACE leaves out the side that is meant to be seen: the one that normals of a lit object point to, or the
    outside of a closed one; or all that there is.  Silent with glCullFace(GL_FRONT), for rooms (the eye is inside),
    and for open things without normals, which may show their back."""

    kind, topic = "culled-front", TOPIC
    looks_at = "GL_CULL_FACE with clockwise corners"
    sentence = (
        "GL_CULL_FACE leaves out the side that should be seen: the corners of {count} run the other way round{cause};"
        " give them counterclockwise as seen from outside, or call glFrontFace({other})"
    )

    def at_end(self, draws: list[Seen]) -> Findings:
        found = False
        everything = things(draws)
        for one in everything:
            wrong = self._wrong(one)
            if wrong.sum() > SHARE * len(wrong):
                found = True
                yield one.draw_of(wrong).call, self._words(one, wrong)
        areas = [seen for seen in draws if len(seen.chosen)]
        whole = everything and not found and sum(len(one.draws) for one in everything) == len(areas)
        if whole and all(one.culled and not one.front.any() for one in everything):
            one = everything[0]
            yield one.draws[0].call, self._words(one, np.ones(len(one.surface), bool))

    def _words(self, one: Thing, wrong: NDArray[np.bool_]) -> dict[str, object]:
        front_face = one.draws[0].state.polygon.front_face
        cause = ", because a negative factor of glScale mirrors it" if one.mirrored else ""
        return {"count": count(wrong), "cause": cause, "other": "GL_CW" if front_face == gl.GL_CCW else "GL_CCW"}

    def _wrong(self, one: Thing) -> NDArray[np.bool_]:
        """Which triangles are left out although they should be seen, (n,)."""
        nothing = np.zeros(len(one.surface), bool)
        if not one.culled or one.surface.eye_inside:
            return nothing
        if one.lit:
            return one.opposed if one.guilty == "winding" else nothing
        sign = 1.0 if one.draws[0].state.polygon.front_face == gl.GL_CCW else -1.0
        if one.surface.closed and sign * one.surface.volume < 0.0:
            return ~nothing
        return nothing


@rule
class NormalsAway(Rule):
    """Lit surfaces that show the side from which their normals point away, so they are dark: the order of the corners
    says front and the normals say back, or the normals of a closed object point inside and the eye is outside.  Silent
    for surfaces that are seen from behind (normal and order agree); for rooms; for wrong order with right normals,
    which without GL_CULL_FACE and two-sided lighting changes nothing."""

    kind, topic = "normals-away", TOPIC
    looks_at = "normals that face away"
    sentence = (
        "the normals of {count} point to the back{where_to}, so the side that is seen gets no light: turn the normals"
        " round"
    )

    def at_end(self, draws: list[Seen]) -> Findings:
        for one in things(draws):
            polygon, lighting = one.draws[0].state.polygon, one.draws[0].state.lighting
            if not one.lit or lighting.two_side or (polygon.cull and not one.culled):
                continue
            wrong, inside = one.opposed, False
            if one.guilty != "normals":
                inside = not polygon.cull and not wrong.any() and inside_out(one.surface)
                wrong = np.full(len(wrong), inside)
            if wrong.sum() > SHARE * len(wrong):
                where_to = ", to the inside" if inside else ""
                yield one.draw_of(wrong).call, {"count": count(wrong), "where_to": where_to}


def inside_out(surface: Surface) -> bool:
    """Whether the eye is outside of something closed whose normals point to the inside."""
    return surface.closed and not surface.eye_inside and surface.solid and bool((surface.outward < 0.05).mean() > 0.95)


@rule
class NormalsOpposed(Rule):
    """Two-sided lighting chooses the side by the order of the corners.  Silent where order and normals agree, and
    without two-sided lighting."""

    kind, topic = "normals-opposed", TOPIC
    looks_at = "two-sided lighting with normals against the winding"
    sentence = (
        "the corners of {count} run clockwise as seen from where the normals point, so two-sided lighting takes the"
        " front for the back and turns the normals the wrong way: turn the order round, or glFrontFace({other})"
    )

    def at_end(self, draws: list[Seen]) -> Findings:
        for one in things(draws):
            wrong, state = one.opposed, one.draws[0].state
            said = one.culled and one.guilty == "winding"
            if one.lit and state.lighting.two_side and not said and wrong.sum() > SHARE * len(wrong):
                other = "GL_CW" if state.polygon.front_face == gl.GL_CCW else "GL_CCW"
                yield one.draw_of(wrong).call, {"count": count(wrong), "other": other}
