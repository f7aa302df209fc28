"""A Frame, a scene or a program as a picture that a browser can turn, light and shade anew: ``export`` and ``show``.

Here is decided what can be changed, and how each value is found in what is drawn; web/live.py writes the page, and its
JavaScript does the rest.
"""

from __future__ import annotations

import base64
from bisect import bisect_left
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.assembly import corners, outlines
from glsim.machine.frame import Call, Draw, Frame, Packet, Pixels
from glsim.machine.matrix import Matrix
from glsim.machine.state import TRACKED, Depth, Fog, Light, Lighting, Material, Polygon, Texturing
from glsim.names import did_you_mean
from glsim.play.reshade import LOBE, SHADE_MODEL, shaded
from glsim.render import uniforms
from glsim.render.batch import Object, assembled
from glsim.render.context import own_screen
from glsim.render.recorder import record
from glsim.scenes.materials import MATERIALS
from glsim.web.live import Live

MODES, LOBES = tuple(SHADE_MODEL), tuple(LOBE)
CONTROLS = ("mode", "lobe", "edges", "lights", "materials", "ambient")
CAMERA = "camera"  # the control that is always there
AS_DRAWN = "as drawn"  # the mode of what is not lit, or lit under several shade models
NEARER = 0.9999  # the far end of the depth range of edges: so they are seen on the surfaces they bound
FACE = ("ambient", "diffuse", "specular", "emission", "shininess")
LIGHT = (
    "ambient", "diffuse", "specular", "spot_exponent", "spot_cutoff", "constant_attenuation", "linear_attenuation",
    "quadratic_attenuation",
)  # fmt: skip
PACKAGE = Path(__file__).resolve().parents[1]
IDENTITY: NDArray[np.float64] = np.eye(4)


Shading = Callable[[Frame, str], Frame]  # a frame as it is shaded with a lobe


def live_of(
    frames: Mapping[str, Frame], title: str, *, modes: Sequence[str] | None = None, lobes: Sequence[str] | None = None,
    controls: str | Sequence[str] = CONTROLS, samples: int = 4,
) -> Live:  # fmt: skip
    """Frames of one size as a live picture; the first one is shown first.

    frames: by the words that the scrubber shows.  If their calls were recorded (``calls=True``), lights keep the values
    that the program gave them, and the camera is known.
    modes, lobes: "flat", "gouraud", "phong"; "blinn", "phong"; by default all, first the program's own.
    controls: as in ``controls_of``.  samples: multisampling, 0 for none.

    Raises ValueError for an unknown mode, lobe or control.
    """
    for kind, known, names in (("mode", MODES, modes), ("lobe", LOBES, lobes)):
        for name in names or ():
            if name not in known:
                raise ValueError(f"a live picture has the {kind}s {', '.join(known)}, not {name!r}")
    own = _looks(next(iter(frames.values())))
    chosen, rows = list(modes or MODES), list(lobes or LOBES)
    if not own:
        chosen, rows = [AS_DRAWN], rows[:1]
    elif len(own) > 1 and modes is None:
        chosen.insert(0, AS_DRAWN)
    mode, lobe = own[0] if len(own) == 1 else (AS_DRAWN, rows[0])
    first = mode if mode in chosen else chosen[0], lobe if lobe in rows else rows[0]
    wanted = controls_of(controls)
    shadings = {name: _shading(name) for name in (chosen if "mode" in wanted else first[:1])}
    return shaded_live(frames, title, shadings, rows if "lobe" in wanted else first[1:], first, wanted, samples)


def shaded_live(
    frames: Mapping[str, Frame], title: str, shadings: Mapping[str, Shading], lobes: Sequence[str],
    first: tuple[str, str], controls: Sequence[str], samples: int,
) -> Live:  # fmt: skip
    """Frames by name, each in all shadings with all lobes, as a live picture.

    first: the shading and lobe that are shown first."""
    general = {name: _general(frame) for name, frame in frames.items()}
    pictures: dict[str, Frame] = {}
    numbers: dict[str, int] = {}
    for number, frame in enumerate(general.values()):
        for mode, of in shadings.items():
            for lobe in lobes:
                name = f"{number} {mode} {lobes[0] if mode == AS_DRAWN else lobe}"  # which has its own
                pictures.setdefault(name, of(frame, lobe))
                numbers[f"{number} {mode} {lobe}"] = [*pictures].index(name)
        if "edges" in controls and (drawn := _edges(frame)).packets:
            numbers[f"{number} edges"] = len(pictures)
            pictures[f"{number} edges"] = drawn
    start = next(iter(general.values()))
    poster = _poster(shadings[first[0]](next(iter(frames.values())), first[1]), samples)
    return Live(
        title, record(pictures, samples), poster, numbers, [_moment(frame) for frame in general.values()],
        [*shadings], [*lobes], *first, list(frames), list(controls), _named() if "materials" in controls else [],
        _notes(start),
    )  # fmt: skip


def controls_of(given: str | Sequence[str]) -> list[str]:
    """Names of controls: some of CONTROLS; "camera", which is always there; or single values of lights and materials,
    such as "lights.position", "lights.spot", "lights.attenuation" or "materials.shininess".

    given: the names, or one text with commas.  Raises ValueError for an unknown one."""
    parts = {"lights": (*LIGHT, "position", "spot_direction"), "materials": FACE}
    names = [name.strip() for name in (given.split(",") if isinstance(given, str) else given)]
    for name in names:
        kind, _, part = name.partition(".")
        if name not in (*CONTROLS, CAMERA) and not (part and any(part in one for one in parts.get(kind, ()))):
            raise ValueError(
                f"controls of a live picture are {', '.join((*CONTROLS, CAMERA))}, or values such as lights.position"
                f" and materials.shininess, not {name!r}{did_you_mean(name, CONTROLS)}"
            )
    return [name for name in names if name != CAMERA]


def _shading(mode: str) -> Shading:
    return lambda frame, lobe: frame if mode == AS_DRAWN else shaded(frame, mode, lobe)


def _poster(frame: Frame, samples: int) -> NDArray[np.uint8]:
    """The still picture: (height, width, 3) uint8."""
    with own_screen(frame.width, frame.height, samples=samples) as screen:
        screen.execute(frame.packets)
        return np.ascontiguousarray(screen.pixels()[..., :3])


def _looks(frame: Frame) -> list[tuple[str, str]]:
    """The different shade models and lobes of lit draws, by name."""
    lit = (draw.state.lighting for draw in frame.draws if draw.state.lighting.enabled)
    own = dict.fromkeys((lighting.shade_model, lighting.lobe) for lighting in lit)
    names = ({int(value): name for name, value in known.items()} for known in (SHADE_MODEL, LOBE))
    modes, lobes = names
    return [(modes[shade_model], lobes[lobe]) for shade_model, lobe in own]


def _notes(frame: Frame) -> list[str]:
    """What stays as it was when the camera turns, because glsim computes it before the GPU does."""
    notes = []
    packets = frame.packets
    if any(isinstance(packet, Pixels) for packet in packets):
        notes.append("Turned: what glBitmap, glDrawPixels and glCopyPixels drew stays where it was.")
    states = [draw.state for draw in frame.draws]
    if any(state.line.stipple for state in states):
        notes.append("Turned: the dashes of glLineStipple keep the lengths that they had.")
    if any(mode != gl.GL_FILL for state in states for mode in (state.polygon.front_mode, state.polygon.back_mode)):
        notes.append("Turned: which side of a polygon glPolygonMode drew as edges or points stays as it was.")
    return notes


# ---------------------------------------------------------------- lights that can become spots


def _general(frame: Frame) -> Frame:
    """The same picture, by programs that compute attenuation and spot of each light at a place, so that both can be
    changed: constants differ from 1 and 180 by less than a float32 tells."""
    known: dict[int, Lighting] = {}

    def change(draw: Draw) -> Draw:
        lighting = draw.state.lighting
        if not lighting.enabled:
            return draw
        if id(lighting) not in known:
            known[id(lighting)] = lighting._replace(lights=tuple(map(_with_all, lighting.lights)))
        return draw.with_state(draw.state._replace(lighting=known[id(lighting)]))

    return frame.map_draws(change)


def _with_all(light: Light) -> Light:
    if light.position[3] == 0.0:
        return light
    constants = light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation
    if constants == (1.0, 0.0, 0.0):
        light = light._replace(constant_attenuation=float(np.nextafter(1.0, 2.0)))
    if light.spot_cutoff == 180.0:
        light = light._replace(spot_cutoff=float(np.nextafter(180.0, 0.0)), spot_exponent=0.0)
    return light


# ---------------------------------------------------------------- what a frame is drawn with


def _moment(frame: Frame) -> dict[str, Any]:
    """What live.js calls a Moment."""
    lit = [draw for draw in frame.draws if draw.state.lighting.enabled]
    lighting = lit[0].state.lighting if lit else Lighting()
    return {
        "lights": _lights(frame, lit),
        "materials": _materials(lit),
        "ambient": list(lighting.ambient),
        "localViewer": lighting.local_viewer,
        "camera": camera_of(frame),
    }


def _lights(frame: Frame, lit: Sequence[Draw]) -> list[dict[str, Any]]:
    found: dict[tuple[int, Light], Draw] = {}
    for draw in lit:
        lighting = draw.state.lighting
        for number, light in enumerate(lighting.lights):
            if lighting.light_enabled[number]:
                found.setdefault((number, light), draw)
    return [_light(frame, number, light, draw) for (number, light), draw in found.items()]


def _light(frame: Frame, number: int, light: Light, draw: Draw) -> dict[str, Any]:
    """What live.js calls a Light: values as the program gave them, and the modelview matrices when it did."""
    position, place, line = _given(frame, draw, number, gl.GL_POSITION, light.position)
    direction, turn, _ = _given(frame, draw, number, gl.GL_SPOT_DIRECTION, light.spot_direction)
    values: dict[str, Any] = {name: getattr(light, name) for name in LIGHT}
    values["spot_cutoff"] = 180.0 if light.spot_cutoff > 179.999 else light.spot_cutoff
    return {
        "number": number,
        "row": _base64(uniforms.light_row(light).tobytes()),
        "values": {**values, "position": position, "spot_direction": direction},
        "position": _numbers(place), "direction": _numbers(turn),
        "turnsPosition": not np.array_equal(place, IDENTITY), "turnsDirection": not np.array_equal(turn, IDENTITY),
        "line": line,
    }  # fmt: skip


def _given(
    frame: Frame, draw: Draw, number: int, parameter: int, value: tuple[float, ...]
) -> tuple[list[float], NDArray[np.float64], int | None]:
    """A vector of a light as the program gave it, the modelview matrix at that call, and the line of the program.

    value: in eye space.  Where no recorded call explains it, it is its own, under the identity.
    """
    for at in range(len(frame.calls[: draw.call]) - 1, -1, -1):
        call = frame.calls[at]
        if not _sets(call, number, parameter):
            continue
        given = [float(part) for part in np.ravel(call.arguments[2])][: len(value)]
        matrix = _modelview(frame, at)
        if len(given) == len(value):
            eye = np.array(given) @ matrix[: len(given), : len(given)]
            if np.allclose(eye, value, rtol=1e-4, atol=1e-5):
                return given, matrix, _line(call)
        break
    return list(value), IDENTITY, None


def _line(call: Call) -> int | None:
    """The line of the user's program that made a call; None for those that glsim's scenes make."""
    where = call.where
    return None if where is None or Path(where.file).is_relative_to(PACKAGE) else where.line


def _sets(call: Call, number: int, parameter: int) -> bool:
    return (
        call.name.startswith("glLight")
        and not call.name.startswith("glLightModel")
        and len(call.arguments) == 3
        and int(call.arguments[0]) == gl.GL_LIGHT0 + number
        and int(call.arguments[1]) == parameter
    )


def _modelview(frame: Frame, call: int) -> NDArray[np.float64]:
    """The modelview matrix just before a call, which is also that after it if the call does not change it."""
    at = bisect_left([moment.call for moment in frame.history], call) - 1
    return IDENTITY if at < 0 else np.asarray(frame.history[at].matrices[0].get(), np.float64)


def _materials(lit: Sequence[Draw]) -> list[dict[str, Any]]:
    found: dict[Material, Draw] = {}
    for draw in lit:
        for material in (draw.material, *(material for _, material in draw.material_changes())):
            found.setdefault(material, draw)
    return [_material(material, draw) for material, draw in found.items()]


def _material(material: Material, draw: Draw) -> dict[str, Any]:
    """What live.js calls a Material."""
    lighting = draw.state.lighting
    both = material.front == material.back or not lighting.two_side
    row = uniforms.materials([Object(draw.matrices, material, None)]).tobytes()
    return {
        "row": _base64(row[: 2 * uniforms.FACE_OF_MATERIAL.itemsize]),
        "front": {name: getattr(material.front, name) for name in FACE},
        "back": {name: getattr(material.back, name) for name in FACE},
        "both": both,
        "face": "GL_FRONT_AND_BACK" if both and lighting.two_side else "GL_FRONT",
        "tracked": list(TRACKED[lighting.color_material_mode]) if lighting.color_material else [],
        "line": None,
    }


# ---------------------------------------------------------------- the camera


def camera_of(frame: Frame) -> dict[str, Any]:
    """What live.js calls a Camera."""
    draws = list(frame.draws)
    projections: dict[Matrix, NDArray[np.float64]] = {
        draw.matrices[1]: np.asarray(draw.matrices[1].get()) for draw in draws
    }
    perspective = any(map(_is_perspective, projections.values()))
    distinct = {matrix.tobytes(): matrix for matrix in projections.values()}
    turning = [draw for draw in draws if not perspective or _is_perspective(projections[draw.matrices[1]])]
    points = np.concatenate([*map(_eye_positions, turning), np.empty((0, 3))])
    low, high = (points.min(axis=0), points.max(axis=0)) if len(points) else (np.zeros(3), np.zeros(3))
    view = _view(frame, turning)
    seen = IDENTITY if view is None else view
    return {
        "projections": [
            {"matrix": _numbers(matrix), "turns": not perspective or _is_perspective(matrix)}
            for matrix in distinct.values()
        ],
        "centre": ((low + high) / 2.0).tolist(),
        "radius": float(np.linalg.norm(high - low) / 2.0) or 1.0,
        "view": _numbers(seen),
        "up": (np.array([0.0, 1.0, 0.0]) @ seen[:3, :3]).tolist(),
        "hasView": view is not None,
    }


def _is_perspective(projection: NDArray[np.float64]) -> bool:
    """Whether what is farther away is smaller; what a HUD draws beside a scene is not."""
    return bool(projection[:3, 3].any())


def _eye_positions(draw: Draw) -> NDArray[np.float64]:
    used = np.unique(assembled(draw))
    homogeneous = np.insert(draw.block.rows[used, :3].astype(np.float64), 3, 1.0, axis=1)
    eye = homogeneous @ np.asarray(draw.matrices[0].get(), np.float64)
    return eye[np.isfinite(eye).all(axis=1)][:, :3]


def _view(frame: Frame, draws: Sequence[Draw]) -> NDArray[np.float64] | None:
    """The matrix that gluLookAt made, if the program called it while the modelview matrix was the identity."""
    last = draws[0].call if draws else None
    for at in range(len(frame.calls[:last]) - 1, -1, -1):
        where = frame.calls[at].where
        if where is not None and where.via.startswith("gluLookAt("):
            first = at
            while first > 0 and frame.calls[first - 1].where == where:
                first -= 1
            before, after = _modelview(frame, first), _modelview(frame, at + 1)
            return after if np.array_equal(before, IDENTITY) else None
    return None


# ---------------------------------------------------------------- edges


def _edges(frame: Frame) -> Frame:
    """The edges of all polygons as lines over the same vertices, a little nearer to the eye than what they bound."""
    drawn: list[Packet] = [line for draw in frame.draws if corners(draw.mode) == 3 for line in _edges_of(draw)]
    return replace(frame, packets=drawn)


def _edges_of(draw: Draw) -> list[Draw]:
    count = draw.count if draw.indices is None else len(draw.indices)
    rings, _ = outlines(draw.mode, count)
    if not len(rings):
        return []
    pairs = np.stack([rings, np.roll(rings, -1, axis=1)], axis=2).reshape(-1, 2)
    numbers = pairs if draw.indices is None else draw.indices[pairs]
    chosen = np.unique(np.sort(numbers, axis=1), axis=0).astype(np.uint32).ravel()
    state = draw.state._replace(
        lighting=Lighting(), texture=Texturing(), fog=Fog(), polygon=Polygon(),
        depth=Depth(test=draw.state.depth.test, func=gl.GL_LEQUAL, mask=False),
        viewport=draw.state.viewport._replace(far=NEARER * draw.state.viewport.far),
    )  # fmt: skip
    line = Draw(gl.GL_LINES, draw.first, draw.count, chosen, draw.matrices, draw.material, state, draw.vertices)
    line.color = (0.0, 0.0, 0.0, 1.0)
    return [line]


# ---------------------------------------------------------------- JSON


def _named() -> list[dict[str, Any]]:
    """The named materials of the literature."""
    names = [name for name in FACE if name != "emission"]
    return [
        {"label": label, "values": {name: getattr(face, name) for name in names}} for label, face in MATERIALS.items()
    ]


def _numbers(matrix: NDArray[np.float64]) -> list[float]:
    """A matrix as OpenGL has it: 16 numbers, column by column; JSON has no infinite ones."""
    return [float(value) for value in np.nan_to_num(np.ravel(matrix))]


def _base64(data: bytes) -> str:
    return base64.b64encode(data).decode("ascii")
