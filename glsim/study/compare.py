"""The same scene under different shading, side by side; or any other two things that change."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from glsim.names import SHADING, did_you_mean
from glsim.scenes.staging import Camera, Lamp, camera_of, lamp_of
from glsim.study.axes import animation
from glsim.study.comparison import Comparison as Comparison
from glsim.study.given import Given, are_given, pictures_of
from glsim.study.live import controls_of
from glsim.study.live_sheet import live_sheet
from glsim.study.looks import OUTLINES, RADIOSITY, truest
from glsim.study.plan import Plan, lobes_of, looks_of, planned
from glsim.study.sheet import LAYOUTS
from glsim.study.sources import Source, Wanted, is_radiosity, parameters_of, source_of
from glsim.study.studio import Studio

if TYPE_CHECKING:
    from PIL import Image

FILM_WIDTH = 960  # pixels of an animation, at most


def compare(
    what: Any = None,
    *,
    modes: str | Sequence[str] | None = None,
    lobes: str | Sequence[str] | None = None,
    pictures: Given = (),
    segments: int | str | Sequence[int] | None = None,
    sweep: Mapping[str, Any] | None = None,
    columns: str | None = None,
    reference: str | None = None,
    differences: str | int = "auto",
    layout: str = "screen",
    title: str | None = None,
    captions: Mapping[str, str] | None = None,
    size: int | None = None,
    samples: int | None = 0,
    lights: Sequence[Lamp | str] | None = None,
    material: str | None = None,
    camera: Camera | str | None = None,
    live: str | Sequence[str] | None = None,
    animate: str | None = None,
    frames: int = 36,
    patches: int = 1000,
    view: int = 0,
    timeout: float | None = 60.0,
    backend: str = "auto",
    progress: Callable[[str], object] | None = None,
) -> Comparison:
    """Draw ``what`` in columns and rows that differ in how, or in what, is drawn.

    what: a function that draws with the gl commands, a Scene, the name of a built-in scene, the path of a mesh file,
        a trimesh.Trimesh, a pyrender.Scene, a Frame, or the path of a program (.py), which is run once and whose first
        picture is shaded anew; a radiosity.Scene or its name; or given pictures, as ``pictures``.
    modes: columns: "wireframe", "hidden-line", "unlit", "flat", "gouraud" (or "smooth"), "phong", "native" (the
        driver's own fixed function), "pyrender" (physically based; needs that package), "direct" (direct illumination
        with soft shadows), "radiosity" (with interreflection, solved with ``patches`` patches).  The last two take the
        light from the emitting surfaces of a radiosity.Scene, or of a scene that glsim.radiosity.solve takes, seen
        through its camera number ``view``; the others then approximate the emitters by OpenGL lights (see
        radiosity.pointlights).
        flat, gouraud, phong and native can have options, as in "phong:blinn:two-sided": a lobe, and what happens where
        N.L < 0: "clamp", "flip" (N becomes -N) or "two-sided" (on back faces).
    lobes: rows: "blinn" and/or "phong"; columns too if there are other rows.
    pictures: further columns: paths, or a mapping of names to paths, arrays or PIL images.
    segments, sweep: rows: name of an axis -> its values, as axes.SWEEPABLE lists them: {"shininess": [1, 4, 16]}.  A
        drawing function is swept by its own parameters.  Two of them make the columns (the first) and the rows; then
        there is one mode.  segments=[8, 16] is short for sweep={"segments": [8, 16]}.
    columns: the name of the axis that is to be the columns, if the other way round is wanted.
    reference: the column that differences are taken from (default: the one that the others approximate: radiosity,
        direct, phong, native, gouraud, flat, whichever is there first; of pictures and swept values the first).
    differences: "x8": eight times amplified; "auto": as often as the largest needs to become white; or "off".
    layout: "screen", "projector" (16:9) or "paper" (A4).
    title, captions: words for the sheet, and for columns and rows by name.
    size: of each picture, in pixels (default 512, or as a program asks).
    samples: multisampling, 0 for none, None for what suits: 4, or 0 where exact pixels are compared.
    lights, material, camera: instead of the scene's own; not for programs and functions, which set their own.
    live: controls of a live picture, as in glsim.show: "camera", "lights.position, materials.shininess".  Then a
        browser shows one picture to turn, with modes, lobes and values to choose from; paper shows the sheet.
    animate: "turntable", "light" (once around the scene) or NAME=VALUES; ``frames`` pictures, for ``save("x.gif")``.
    timeout: seconds that a program may run.  progress: called with what is being done.

    Raises ValueError for an unknown name or a value that cannot be, MeshError for a file that cannot be drawn,
    NoNativeError if "native" is asked for and the platform has none.
    """
    tell = progress or (lambda words: None)
    if are_given(what):
        what, pictures = None, what
    given = pictures_of(pictures)
    if what is None and not given:
        raise ValueError("compare: nothing to compare: name a scene, a program, a function that draws, or pictures")
    sweeps = {**({} if segments is None else {"segments": segments}), **(sweep or {})}
    looks = looks_of(modes, what is None, len(sweeps))
    room = what is not None and (is_radiosity(what) or any(one.mode in RADIOSITY for one in looks.values()))
    plan = planned(looks, lobes_of(lobes), given, sweeps, room, parameters_of(what)).turned(columns)
    finish = _finish(plan, reference, differences, layout, captions or {})
    if animate is not None:
        animation(animate, frames, Camera())  # raises before any work
    controls = None if live is None else controls_of(live)
    native = any(one.mode == "native" for one in looks.values())
    wanted = Wanted(
        size, None if lights is None else [lamp_of(one) if isinstance(one, str) else one for one in lights],
        material, camera_of(camera) if isinstance(camera, str) else camera, patches, view, timeout,
        native or controls is not None,
    )  # fmt: skip
    source = Source() if what is None else source_of(what, wanted, room, tell)
    samples = (0 if native or given else 4) if samples is None else samples
    with Studio(source, given, samples, backend, native) as studio:
        cells = studio.cells(plan.rows, plan.columns, plan.start, tell)
        name = title or source.title or ", ".join(given)
        result = Comparison(name, plan.columns, plan.rows, cells, note=source.note, remarks=tuple(studio.remarks),
                            legend=plan.legend, **finish)  # fmt: skip
        if controls is not None:
            tell("recording")
            drawn = live_sheet(plan, source, name, controls, samples, backend, finish["captions"])
            result = replace(result, live=drawn)
        if animate is not None:
            result = replace(result, film=_film(result, plan, studio, animate, frames, tell))
    return result


# ---------------------------------------------------------------- how it is shown


def _finish(
    plan: Plan, reference: str | None, differences: str | int, layout: str, captions: Mapping[str, str]
) -> dict[str, Any]:
    """The fields of a Comparison that say how it is shown."""
    columns, known = plan.columns.names, [*plan.columns.names, *plan.rows.names]
    outlines = frozenset(name for name in known if name.partition(":")[0] in OUTLINES)
    if reference is None:
        reference = truest(columns)
    elif plan.columns.name == "mode" and reference not in columns:
        reference = SHADING.get(reference, reference)
    _check("the reference is a column, of", columns, reference)
    _check("layouts are", LAYOUTS, layout)
    for name in captions:
        _check("captions are for", known, name)
    return {"reference": reference, "outlines": outlines, "factor": _amplified(differences), "layout": layout,
            "captions": dict(captions)}  # fmt: skip


def _check(words: str, names: Iterable[str], name: str) -> None:
    if name not in names:
        raise ValueError(f"compare: {words} {', '.join(names)}, not {name!r}{did_you_mean(name, names)}")


def _amplified(differences: str | int) -> int | None:
    text = str(differences).removeprefix("x")
    if text in ("off", "auto"):
        return 0 if text == "off" else None
    if not text.isdigit() or not 1 <= int(text) <= 255:
        raise ValueError(f'compare: differences are "auto", "off" or amplified, "x1" to "x255", not {differences!r}')
    return int(text)


# ---------------------------------------------------------------- animations


def _film(
    result: Comparison, plan: Plan, studio: Studio, animate: str, frames: int, tell: Callable[[str], object]
) -> list[Image.Image]:
    """The sheet without differences for each value of a third axis."""
    from PIL import Image

    film: list[Image.Image] = []
    time = animation(animate, frames, studio.source.camera)
    for number, value in enumerate(time.values, 1):
        tell(f"picture {number} of {len(time.values)} of the animation")
        cells = studio.cells(plan.rows, plan.columns, value.change(plan.start), lambda words: None)
        sheet = replace(result, cells=cells, factor=0, layout="screen").sheet
        if sheet.width > FILM_WIDTH:
            size = FILM_WIDTH, round(sheet.height * FILM_WIDTH / sheet.width)
            sheet = sheet.resize(size, Image.Resampling.LANCZOS)
        film.append(sheet.quantize(256, Image.Quantize.MAXCOVERAGE))  # within 3/255 of highlights too
    return film
