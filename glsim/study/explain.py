"""Calls -> state -> GLSL key -> uniforms: for each constant and uniform of a Draw the call that set it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from itertools import count, groupby
from typing import Any

from glsim.machine.constants import GL_COMBINE
from glsim.machine.frame import Draw, Frame, Trail, Where
from glsim.machine.matrix import multiply
from glsim.play.frames import frame_of
from glsim.render.batch import MOST_OBJECTS, plans
from glsim.render.key import ProgramKey, draw_key
from glsim.render.outline import prepare
from glsim.render.programs import sources
from glsim.render.specialise import specialised
from glsim.render.uniforms import ATTENUATION, FACE, INTENSITIES, cos_spot_cutoff
from glsim.study.provenance import BEFORE, History, Path, Provenance, value_at
from glsim.study.text import as_json, call_text, enum_name, matrix_text, value_text

LIGHTING = ("lighting",)


@dataclass(frozen=True)
class Origin:
    """A call that set state.  through: "in the list of glCallList(...)" for a call in a display list, else ""."""

    call: int
    text: str
    where: Where | None
    through: str = ""


@dataclass(frozen=True)
class Setting:
    """A constant or uniform.  origins: the calls that set it last, () for an initial value; note: a remark or ""."""

    name: str
    value: str
    origins: tuple[Origin, ...] = ()
    note: str = ""


@dataclass(frozen=True)
class Explanation:
    """One Draw: its constants (the key) and its uniforms.  glsl: by stage, the source with the key folded in."""

    draw: int
    what: str
    where: Where | None
    key: list[Setting]
    uniforms: list[Setting]
    program: ProgramKey = field(repr=False, default=ProgramKey())

    @property
    def glsl(self) -> dict[str, str]:
        return {stage: specialised(text) for stage, text in sources(self.program).items()}

    def as_dict(self) -> dict[str, Any]:
        return {
            "draw": self.draw, "what": self.what, "where": as_json(self.where), "key": as_json(self.key),
            "uniforms": as_json(self.uniforms),
        }  # fmt: skip


def explain(what: Any, draw: int | None = None, **options: Any) -> list[Explanation]:
    """What each Draw's constants and uniforms are, and who set them.

    what: a Frame captured with calls, or anything else that play.frames.frame_of takes, with its options.
    draw: number of the only Draw to explain; None for all.  Raises ValueError for a number that no Draw has, or a frame
    without recorded calls.
    """
    frame = frame_of(what, calls=True, **options)
    draws = list(frame.draws)
    if draw is not None and not 0 <= draw < len(draws):
        raise ValueError(f"explain: the frame has {len(draws)} draws, numbered from 0, and {draw} is not one of them")
    wanted: dict[tuple[int, Trail], list[int]] = {}
    for number, packet in enumerate(draws):
        if packet.call is None:
            raise ValueError("explain: the calls of this frame were not recorded: use capture(calls=True)")
        if draw is None or number == draw:
            wanted.setdefault((packet.call, packet.trail), []).append(number)
    explanations: dict[int, Explanation] = {}
    keys = program_keys(frame)
    for step in History(frame).walk():
        now = wanted.pop((step.number, step.trail), [])
        if not step.trail:  # Draws of a display list compiled before the recording: credit the glCallList
            now += [number for key in list(wanted) if key[0] == step.number for number in wanted.pop(key)]
        for number in now:
            explanations[number] = _Explainer(frame, draws[number], step.provenance).explanation(number, keys[number])
    return [explanations[number] for number in sorted(explanations)]


def program_keys(frame: Frame) -> list[ProgramKey]:
    """For each Draw of a frame the key of the program that draws it; of its first part, if it is drawn in several."""
    draws = list(frame.draws)
    keys: dict[int | None, ProgramKey] = {}
    numbers = count()
    for _, group in groupby(frame.packets, key=type):
        run = [packet.with_state(packet.state) for packet in group if isinstance(packet, Draw)]
        for draw in run:
            draw.call = next(numbers)  # a mark: the parts into which the renderer splits this Draw keep it
        for plan in plans(list(prepare(run)), MOST_OBJECTS)[1]:
            for batch in plan.batches:
                key = draw_key(batch.draws[0], MOST_OBJECTS if plan.several(batch) else 1)
                for part in batch.draws:
                    keys.setdefault(part.call, key)
    return [keys.get(number) or draw_key(draw) for number, draw in enumerate(draws)]


class _Explainer:
    def __init__(self, frame: Frame, draw: Draw, provenance: Provenance) -> None:
        self.frame, self.draw, self.provenance = frame, draw, provenance

    def explanation(self, number: int, key: ProgramKey) -> Explanation:
        draw = self.draw
        call = self.frame.calls[draw.call or 0]
        what = f"{draw.mode!r}, {draw.count} vertices"
        return Explanation(number, what, call.where, list(self._key(key)), list(self._uniforms(key)), key)

    # ------------------------------------------------------------ origins

    def _origin(self, call: int, through: int | None = None) -> Origin:
        if call == BEFORE:
            return Origin(call, "before the recording began", None)
        listed = f"in the list of {call_text(self.frame.calls[through])}" if through is not None else ""
        return Origin(call, call_text(self.frame.calls[call]), self.frame.calls[call].where, listed)

    def _origins(self, *paths: Path) -> tuple[Origin, ...]:
        """The calls that last set the state at or below these paths, each once, in the order of the program."""
        origins = {}
        for path in paths:
            for setter_path, call in self.provenance.setters.items():
                if setter_path[: len(path)] == path:
                    origins[call] = self._origin(call, self.provenance.through.get(setter_path))
        return tuple(origins[call] for call in sorted(origins))

    def _chain(self, calls: Iterable[int]) -> tuple[Origin, ...]:
        """The calls whose product a matrix is.  Calls that one GLU function made count as one, under its name."""
        result: list[Origin] = []
        for call in calls:
            origin = self._origin(call)
            via = origin.where.via if origin.where is not None else ""
            if not via or not result or result[-1].where != origin.where:
                result.append(replace(origin, text=via) if via else origin)
        return tuple(result)

    def _state(self, name: str, *path: str | int, note: str = "") -> Setting:
        value = value_at(self.draw.state, self.draw.material, path)
        return Setting(name, value_text(value), self._origins(path), note)

    # ------------------------------------------------------------ the key

    def _key(self, key: ProgramKey) -> Iterator[Setting]:
        """The constants of the GLSL program that apply to this Draw, in the order of shaders/."""
        lighting = self.draw.state.lighting
        shading = self._origins(("lighting", "shade_model"))
        yield Setting("SHADED", "flat" if key.flat else "smooth", shading)
        if key.affine:
            yield Setting("AFFINE", value_text(key.affine), self._origins(("hints", "perspective_correction")))
        yield Setting("LIGHTING", value_text(key.lighting), self._origins(("lighting", "enabled")))
        if key.lighting:
            yield Setting("PER_FRAGMENT", value_text(key.per_fragment), shading)
            for k, kind in enumerate(key.lights):
                light = ("lighting", "lights", kind.number)
                enabled = self._origins(("lighting", "light_enabled", kind.number))
                yield Setting(f"LIGHT_NUMBER[{k}]", str(kind.number), enabled)
                yield Setting(
                    f"LIGHT_IS_POSITIONAL[{k}]", value_text(kind.positional), self._origins((*light, "position"))
                )
                factors = [(*light, member) for member in ATTENUATION]
                yield Setting(f"LIGHT_IS_ATTENUATED[{k}]", value_text(kind.attenuated), self._origins(*factors))
                yield Setting(f"LIGHT_IS_SPOT[{k}]", value_text(kind.spot), self._origins((*light, "spot_cutoff")))
            for name, field_name in (
                ("LOBE_IS_PHONG", "lobe"), ("FLIP_NORMAL", "back_lighting"), ("LOCAL_VIEWER", "local_viewer"),
                ("TWO_SIDE", "two_side"), ("SEPARATE_SPECULAR", "color_control"),
            ):  # fmt: skip
                yield Setting(name, value_text(getattr(key, name.lower())), self._origins(("lighting", field_name)))
            if lighting.color_material:
                fields = ("color_material", "color_material_face", "color_material_mode")
                origins = self._origins(*(("lighting", name) for name in fields))
                for name in ("front_tracks", "back_tracks"):
                    yield Setting(name.upper(), _tracks(getattr(key, name)), origins)
        yield from self._rest_of_key(key)

    def _rest_of_key(self, key: ProgramKey) -> Iterator[Setting]:
        for name, path in (
            ("NORMALIZE", ("transform", "normalize")), ("RESCALE_NORMAL", ("transform", "rescale_normal")),
            ("COLOR_SUM", ("fog", "color_sum")), ("POLYGON_STIPPLE", ("polygon", "stipple")),
            ("LINE_STIPPLE", ("line", "stipple")), ("POINT_SMOOTH", ("point", "smooth")),
            ("WIDE_LINES", ("line", "width")), ("SMOOTH_LINES", ("line", "smooth")),
        ):  # fmt: skip
            if getattr(key, name.lower()) or (name == "NORMALIZE" and key.lighting):
                yield Setting(name, value_text(getattr(key, name.lower())), self._origins(path))
        for name, why in (
            ("HAS_W", "a vertex has a w that is not 1"),
            ("OBJECT_COLOR", "the list sets no colour: all its vertices have the one at glCallList"),
            ("DEPTH_OFFSET", "glPolygonOffset, for outlines: each vertex is moved in depth"),
            ("LIT_ELSEWHERE", "an outline is lit where the polygon's provoking vertex is"),
        ):
            if getattr(key, name.lower()):
                yield Setting(name, "true", (), why)
        if key.objects > 1:
            why = "drawn together with others, each with matrices and a material of its own"
            yield Setting("MANY_OBJECTS", "true", (), why)
        if key.fog:
            yield Setting("FOG", enum_name(int(key.fog)), self._origins(("fog", "enabled"), ("fog", "mode")))
        if self.draw.state.color_buffer.alpha_test:
            paths = (("color_buffer", "alpha_test"), ("color_buffer", "alpha_func"))
            yield Setting("ALPHA_FUNC", enum_name(int(key.alpha_func)), self._origins(*paths))
        for number, on in enumerate(key.clip_plane):
            if on:
                yield Setting(f"CLIP_PLANE[{number}]", "true", self._origins(("transform", "clip_enabled", number)))
        for unit in key.units:
            at: Path = ("texture", "units", unit.number)
            yield Setting(f"TEXTURE_{unit.number}", "1", self._origins((*at, "enabled"), (*at, "names")))
            environment = [
                (*at, "environment"),
                *([(*at, "combine")] if unit.environment == GL_COMBINE else []),
            ]
            yield Setting(f"TEXENV[{unit.number}]", enum_name(int(unit.environment)), self._origins(*environment))
            if any(unit.generated):
                modes = ", ".join(enum_name(int(mode)) if mode else "-" for mode in unit.generated)
                origins = self._origins((*at, "generated"), (*at, "generators"))
                yield Setting(f"TEXGEN of unit {unit.number}", modes, origins)

    # ------------------------------------------------------------ the uniforms

    def _uniforms(self, key: ProgramKey) -> Iterator[Setting]:
        yield from self._matrices(key)
        yield self._color(key)
        if key.lighting:
            yield from self._lighting(key)
        state = self.draw.state
        if key.fog:
            for name in ("color", "density", "start", "end"):
                yield self._state(f"fog_{name}", "fog", name)
        if key.points:
            yield self._state("point_size", "point", "size")
        if not key.areas and not key.points:
            yield self._state("line_width", "line", "width")
        if state.color_buffer.alpha_test:
            yield self._state("alpha_reference", "color_buffer", "alpha_reference")
        for number, on in enumerate(key.clip_plane):
            if on:
                path: Path = ("transform", "clip_planes", number)
                yield self._state(f"clip_planes[{number}]", *path, note=self._placed(path))
        for unit in key.units:
            yield self._state(f"units[{unit.number}].environment_color", "texture", "units", unit.number,
                              "environment_color")  # fmt: skip

    def _matrices(self, key: ProgramKey) -> Iterator[Setting]:
        """Each product, with the calls that were multiplied, in order."""
        modelview, projection, *textures = (matrix.get() for matrix in self.draw.matrices)
        yield self._product("transform.modelview", modelview, "modelview")
        note = f"GL_PROJECTION, {matrix_text(projection)}, times GL_MODELVIEW"
        product = multiply(projection[None], modelview[None])[0]
        yield self._product("transform.modelview_projection", product, "projection", "modelview", note=note)
        for unit in key.units:
            member = f"units[{unit.number}].matrix" if unit.number else "transform.texture"
            yield self._product(member, textures[min(unit.number, len(textures) - 1)], f"texture{unit.number}")

    def _product(self, name: str, matrix: Any, *stacks: str, note: str = "") -> Setting:
        chain = tuple(origin for stack in stacks for origin in self._chain(self.provenance.chains[stack][-1]))
        words = [note] if note else []
        words += ["the product of these calls, in order"] if len(chain) > 1 else []
        return Setting(name, matrix_text(matrix), chain, ": ".join(words))

    def _color(self, key: ProgramKey) -> Setting:
        """The setting "color": the vertices' common colour and the last glColor, or "one for each vertex"."""
        block = self.draw.block
        rows = block.rows[self.draw.first : self.draw.first + self.draw.count, 6:10]
        one = self.draw.color is not None or bool((rows == rows[:1]).all())
        value = (
            value_text(tuple(map(float, rows[0] if self.draw.color is None else self.draw.color))) if len(rows) else "-"
        )
        last = self.provenance.registers.get("glColor")
        origins = () if last is None or not one else (self._origin(last),)
        tracked = self.draw.state.lighting.color_material
        note = "has no effect: GL_LIGHTING is on and GL_COLOR_MATERIAL is off" if key.lighting and not tracked else ""
        return Setting("color", value if one else "one for each vertex", origins, note)

    def _lighting(self, key: ProgramKey) -> Iterator[Setting]:
        lighting = self.draw.state.lighting
        sides = ["front", *(["back"] if key.two_side else [])]
        for side in sides:
            for member, field_name in FACE.items():
                yield self._state(f"material.{side}.{member}", "material", side, field_name)
        yield self._state("I_a_scene", "lighting", "ambient")
        for kind in key.lights:
            light: Path = ("lighting", "lights", kind.number)
            path = (*light, "position")
            yield self._state(f"lights[{kind.number}].position", *path, note=self._placed(path))
            for member, field_name in INTENSITIES.items():
                yield self._state(f"lights[{kind.number}].{member}", *light, field_name)
            if kind.spot:
                path = (*light, "spot_direction")
                yield self._state(f"lights[{kind.number}].spot_direction", *path, note=self._placed(path))
                yield self._state(f"lights[{kind.number}].spot_exponent", *light, "spot_exponent")
                source = lighting.lights[kind.number]
                note = f"cosine of {value_text(source.spot_cutoff)} degrees"
                cosine, origins = cos_spot_cutoff(source), self._origins((*light, "spot_cutoff"))
                yield Setting(f"lights[{kind.number}].cos_spot_cutoff", value_text(cosine), origins, note)
            if kind.attenuated:
                for member in ATTENUATION:
                    yield self._state(f"lights[{kind.number}].{member}", *light, member)
        assert lighting.enabled

    def _placed(self, path: Path) -> str:
        """The note for a position: "in eye space", with the modelview at the call that set it, if that is known."""
        placed = self.provenance.placed.get(path)
        if placed is None:
            return "in eye space"
        made = " * ".join(origin.text for origin in self._chain(placed.chain))
        return f"in eye space; the modelview then was {matrix_text(placed.modelview)}" + (f" = {made}" if made else "")


def _tracks(flags: tuple[bool, ...]) -> str:
    names = ("ambient", "diffuse", "specular", "emission")
    return ", ".join(name for name, on in zip(names, flags, strict=True) if on) or "nothing"
