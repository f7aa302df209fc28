"""The same scene under different shading, side by side."""

from __future__ import annotations

import io
import os
import tempfile
from bisect import bisect_right
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from glsim.files import write_atomically
from glsim.machine import constants as gl
from glsim.machine.frame import Frame
from glsim.names import LOBES as LOBE_NAMES
from glsim.names import SHADING, did_you_mean
from glsim.play.capture import capture
from glsim.play.frames import drawer, frame_of_program
from glsim.play.reshade import shaded
from glsim.scenes import Camera, Lamp

if TYPE_CHECKING:
    from PIL import Image

    from glsim.render.context import Offscreen

Pixels = NDArray[np.uint8]

MODES = {
    "wireframe": "Wireframe",
    "unlit": "Unlit",
    "flat": "Flat",
    "gouraud": "Gouraud",
    "phong": "Phong",
    "native": "Driver's fixed function",
    "direct": "Direct illumination",
    "radiosity": "Radiosity",
}
RADIOSITY_MODES = ("direct", "radiosity")
LOBES = {"blinn": "Blinn-Torrance  (N·H)^n", "phong": "Phong  (R·V)^n"}
ROWS = {**LOBES, "diffuse": "Diffuse"}
AMPLIFIED = 4


@dataclass(frozen=True)
class Comparison:
    """Pictures of one scene.

    images[lobe, mode]: (height, width, 3) uint8, top row first.  There is none for ("phong", "native"): the driver's
    fixed function has only the other lobe.
    """

    title: str
    modes: tuple[str, ...]
    lobes: tuple[str, ...]
    images: dict[tuple[str, str], Pixels]

    def __repr__(self) -> str:
        height, width = next(iter(self.images.values())).shape[:2]
        return f"<Comparison {self.title} {width} x {height}: {', '.join(self.modes)}; {', '.join(self.lobes)}>"

    def difference(self, lobe: str, mode: str) -> NDArray[np.int16]:
        """|picture - picture of the first mode| for a lobe, (height, width, 3) in 0..255."""
        first = next(name for name in self.modes if (lobe, name) in self.images)
        a, b = self.images[lobe, first], self.images[lobe, mode]
        return np.abs(a.astype(np.int16) - b.astype(np.int16))

    def statistics(self) -> list[dict[str, Any]]:
        """For each lobe and mode the largest and the mean difference from the first mode, in 1/255."""
        rows = []
        for lobe, mode in self.images:
            d = self.difference(lobe, mode)
            rows.append({"lobe": lobe, "mode": mode, "max": int(d.max()), "mean": round(float(d.mean()), 4)})
        return rows

    @property
    def sheet(self) -> Image.Image:
        """The labelled sheet: for each lobe a row of pictures and, under it, amplified differences from the first."""
        return draw_sheet(self)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the sheet; the file's ending says the format."""
        sheet = self.sheet
        write_atomically(path, lambda name: sheet.save(name))

    def _repr_png_(self) -> bytes:
        buffer = io.BytesIO()
        self.sheet.save(buffer, "PNG")
        return buffer.getvalue()


def draw_sheet(comparison: Comparison) -> Image.Image:
    """Columns: modes.  Rows: for each lobe the pictures, then their amplified differences from the first mode."""
    from PIL import Image, ImageDraw, ImageFont

    from glsim.pictures import FAINT, INK, PAPER, upright

    first = next(iter(comparison.images.values()))
    height, width = first.shape[:2]
    text = max(11, min(width, 512) // 22)
    gap, line = text // 2, round(text * 1.5)
    font, small = ImageFont.load_default(text), ImageFont.load_default(max(10, round(text * 0.8)))
    left, top = line + gap, 2 * line + gap
    columns, lobes = len(comparison.modes), comparison.lobes
    differences = columns > 1
    block = height + gap + (height + line + gap if differences else 0)
    size = (left + columns * (width + gap), top + len(lobes) * block)
    sheet = Image.new("RGB", size, PAPER)
    pen = ImageDraw.Draw(sheet)
    pen.text((left, gap // 2), comparison.title, INK, font)
    for column, mode in enumerate(comparison.modes):
        pen.text((left + column * (width + gap) + width // 2, line + gap // 2), MODES[mode], INK, font, anchor="ma")
    for row, lobe in enumerate(lobes):
        y = top + row * block
        upright(sheet, ROWS[lobe], font, INK, (gap // 2, y), height)
        for column, mode in enumerate(comparison.modes):
            x = left + column * (width + gap)
            if (lobe, mode) not in comparison.images:
                words = "fixed function has (N·H)^n only"
                pen.text((x + width // 2, y + height // 2), words, FAINT, small, anchor="mm")
                continue
            sheet.paste(Image.fromarray(comparison.images[lobe, mode]), (x, y))
            if differences:
                d = comparison.difference(lobe, mode)
                amplified = np.minimum(d * AMPLIFIED, 255).astype(np.uint8)
                sheet.paste(Image.fromarray(amplified), (x, y + height + gap))
                words = "reference" if column == 0 else f"max {d.max()}   mean {d.mean():.2f}"
                pen.text((x + width // 2, y + 2 * height + gap + gap // 3), words, FAINT, small, anchor="ma")
        if differences:
            words = f"difference, {AMPLIFIED} times amplified"
            upright(sheet, words, small, FAINT, (gap // 2, y + height + gap), height)
    return sheet


def compare(
    what: Any,
    *,
    modes: Sequence[str] = ("flat", "gouraud", "phong"),
    lobes: Sequence[str] = ("blinn", "phong"),
    size: int = 512,
    lights: Sequence[Lamp] | None = None,
    material: str | None = None,
    camera: Camera | None = None,
    patches: int = 2000,
    view: int = 0,
    backend: str = "auto",
    progress: Callable[[str], object] | None = None,
) -> Comparison:
    """Draw ``what`` once for each shading mode and specular lobe.

    what: a function that draws with the gl commands, a Scene, the name of a built-in scene, the path of a mesh file,
        a trimesh.Trimesh, or the path of a GLUT program (.py), whose first picture is taken at its own size.
    modes: of "flat", "gouraud" (or "smooth"), "phong", "wireframe", "unlit", "native" (the driver's own fixed
        function); also "direct" (direct illumination with soft shadows) and "radiosity" (with interreflection, solved
        with ``patches`` patches), where the light comes from the emitting surfaces of a radiosity.Scene, or of a scene
        that glsim.radiosity.solve takes, seen through its camera number ``view``.  The other modes then approximate the
        emitters by OpenGL lights (see radiosity.pointlights).
    lobes: "blinn" and/or "phong".  size: of each picture, in pixels.
    lights, material, camera: instead of the scene's own; not for a function, which sets its own.
    progress: called with what is being done, for work that takes long.

    Raises ValueError for an unknown mode, lobe or material, MeshError for a file that cannot be drawn, NoNativeError
    if "native" is asked for and the platform has none.
    """
    modes, lobes = (
        [names.get(name, name) for name in given] for names, given in ((SHADING, modes), (LOBE_NAMES, lobes))
    )
    for kind, given, known in (("mode", modes, MODES), ("lobe", lobes, LOBES)):
        unknown = [name for name in given if name not in known]
        if unknown or not given:
            hint = did_you_mean(unknown[0], known) if unknown else ""
            raise ValueError(f"compare: {kind}s are {', '.join(known)}, not {', '.join(unknown) or 'none'}{hint}")
    tell = progress or (lambda words: None)
    if _is_radiosity(what) or not set(RADIOSITY_MODES).isdisjoint(modes):
        if lights is not None or material is not None or camera is not None:
            raise ValueError("compare: with radiosity the scene has its own lamps, materials and cameras: use --view")
        return _compare_radiosity(what, tuple(modes), size, patches, view, tell)
    if isinstance(what, (str, Path)) and str(what).endswith(".py"):
        return _compare_program(Path(what), tuple(modes), tuple(lobes), tell)
    tell("reading the scene")
    title, draw = drawer(what, size, lights, material, camera)
    from glsim.render.context import own_screen

    with own_screen(size, size, backend=backend) as screen:
        with capture(calls="native" in modes) as frame:
            draw()
        if not frame.packets:
            raise ValueError(f"compare: {title} draws nothing here: does it open a context of its own?")
        images = {}
        for lobe in lobes:
            for mode in modes:
                if mode == "native" and lobe != "blinn":
                    continue  # fixed function has no other lobe
                tell(f"drawing {MODES[mode]}, {LOBES[lobe]}")
                images[lobe, mode] = _picture(screen, frame, mode, lobe)
    return Comparison(title, tuple(modes), tuple(lobes), images)


def _is_radiosity(what: Any) -> bool:
    """Whether ``what`` is a radiosity.Scene, or a name that only a built-in radiosity scene has."""
    from glsim import scenes
    from glsim.radiosity import scene
    from glsim.radiosity.scenes import BUILT_IN

    if isinstance(what, scene.Scene):
        return True
    return isinstance(what, str) and what in BUILT_IN and what not in scenes.BUILT_IN and not Path(what).exists()


def _compare_radiosity(
    what: Any, modes: tuple[str, ...], size: int, patches: int, view: int, tell: Callable[[str], object]
) -> Comparison:
    """Compare a radiosity scene: lit by OpenGL lights, by direct illumination with shadows, and by radiosity."""
    from glsim.radiosity import solve
    from glsim.radiosity.tone import toned
    from glsim.radiosity.view import draw_point_lights
    from glsim.render.context import own_screen

    result = solve(what, patches, progress=lambda stage, done, of: tell(f"{stage}: {100 * done // max(of, 1)} %"))
    screen_values = np.round(255.0 * toned(np.arange(256) / 255.0, 1.0)).astype(np.uint8)
    images = {}
    samples = 0 if "native" in modes else 4  # the driver's fixed function is drawn without
    with own_screen(size, size, samples=samples) as screen:
        with capture(calls="native" in modes) as frame:
            draw_point_lights(result, result.view(view), result.shown_white)
        for mode in modes:
            tell(f"drawing {MODES[mode]}")
            if mode in RADIOSITY_MODES:
                colors = result.colors(result.direct() if mode == "direct" else result.vertex_radiosity)
                images["diffuse", mode] = np.asarray(result.picture(size, view, colors=colors, samples=samples))
            else:
                images["diffuse", mode] = screen_values[_picture(screen, frame, mode, "blinn")]
    return Comparison(result.patches.scene.name, modes, ("diffuse",), images)


def _compare_program(
    script: Path, modes: tuple[str, ...], lobes: tuple[str, ...], tell: Callable[[str], object]
) -> Comparison:
    """The first picture of a program, run once for each mode and lobe; native replays the calls it made."""
    from PIL import Image

    from glsim.play.plan import Plan
    from glsim.play.run import run

    images = {}
    with tempfile.TemporaryDirectory(prefix="glsim-") as folder:
        for lobe in lobes:
            for mode in modes:
                if mode == "native" and lobe != "blinn":
                    continue  # fixed function has no other lobe
                tell(f"running {script.name}: {MODES[mode]}, {LOBES[lobe]}")
                if mode == "native":
                    images[lobe, mode] = _native(frame_of_program(script, calls=True))
                    continue
                record = run(Plan(str(script), out=folder, shade=mode, lobe=lobe))
                if not record["pictures"]:
                    reasons = [error["error"] for error in record["errors"]] + record["notes"]
                    raise ValueError(f"compare: {script} gives no picture: {(reasons or [record['status']])[0]}")
                images[lobe, mode] = np.asarray(Image.open(Path(folder) / record["pictures"][0]))
    return Comparison(script.name, modes, lobes, images)


def _picture(screen: Offscreen, frame: Frame, mode: str, lobe: str) -> Pixels:
    if mode == "native":
        return _native(frame)
    screen.reset()
    screen.execute(shaded(frame, mode, lobe).packets)
    return np.ascontiguousarray(screen.pixels()[..., :3])


def _native(frame: Frame) -> Pixels:
    """The calls of a Frame, replayed on the driver's fixed function."""
    from glsim.render.native import Native

    lacking = _tests_without_buffer(frame)
    calls = [call for call in frame.calls if call.name != "glEnable" or int(call.arguments[0]) not in lacking]
    native = Native(frame.width, frame.height)
    try:
        return np.ascontiguousarray(native.replay(calls)[..., :3])
    finally:
        native.release()


def _tests_without_buffer(frame: Frame) -> set[int]:
    """GL_DEPTH_TEST and GL_STENCIL_TEST, where the program enabled the test but its window has no such buffer: then the
    test is on in the program's state and off in the draws.  The driver's replay always has the buffers."""
    tests = {"depth": gl.GL_DEPTH_TEST, "stencil": gl.GL_STENCIL_TEST}
    numbers = [moment.call for moment in frame.history]
    lacking = set()
    for draw in frame.draws:
        state = frame.history[max(bisect_right(numbers, draw.call or 0) - 1, 0)].state
        lacking |= {int(test) for kind, test in tests.items()
                    if getattr(state, kind).test and not getattr(draw.state, kind).test}  # fmt: skip
    return lacking
