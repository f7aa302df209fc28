"""``export`` and ``show``: anything that draws as a live picture, in a page or in a notebook."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from glsim.files import write_text
from glsim.machine.frame import Frame
from glsim.play.frames import frame_of, frames_of_program
from glsim.study.live import CONTROLS, live_of
from glsim.study.shown import Shown
from glsim.study.sources import is_radiosity
from glsim.web import live as web
from glsim.web.live import Live

MOST_FRAMES = 240


def live(
    what: Any, *, modes: Sequence[str] | None = None, lobes: Sequence[str] | None = None,
    controls: str | Sequence[str] = CONTROLS, frames: int = 1, size: int | None = None, samples: int = 4,
    patches: int = 2000, view: int = 0, title: str | None = None, timeout: float | None = 60.0,
    progress: Callable[[str], object] | None = None,
) -> Live:  # fmt: skip
    """What is drawn, as a picture that a browser can turn, light and shade anew.

    what: a Frame, a list of Frames (an animation), a function that draws, a scene or its name, a mesh file, a program
        (.py); or a radiosity.Scene, its name, or a solution (radiosity.Radiosity), whose light is shown step by step.
    modes, lobes: "flat", "gouraud", "phong"; "blinn", "phong" (default: all).  controls: some of "mode", "lobe",
        "edges", "lights", "materials", "ambient" (default: all), or single values, such as "lights.position",
        "lights.spot", "lights.attenuation", "materials.shininess"; "camera": nothing but the camera.
    frames: how many pictures of a program, 1 to 240, for a scrubber.  size: pixels of the picture (default: 512, or as
        a program asks).  samples: multisampling, 0 for none.  patches, view: of radiosity, how many and which camera.
    title: a line (default: the name of what is drawn).  timeout: seconds that a program may run.
    progress: called with words about what is being done.

    Raises ValueError if nothing can be drawn or an option cannot be, FileNotFoundError for a program that is not there.
    """
    tell = progress or (lambda words: None)
    if not 1 <= frames <= MOST_FRAMES:
        raise ValueError(f"a live picture has 1 to {MOST_FRAMES} frames, not {frames}")
    solution = _solution(what, patches, tell)
    if solution is not None:
        from glsim.study.live_radiosity import radiosity_live

        return radiosity_live(solution, title, size=size or 512, view=view, samples=samples, progress=tell)
    tell("drawing")
    drawn = _frames(what, frames, size, timeout)
    if not drawn or not all(frame.packets for frame in drawn):
        raise ValueError(f"{_name(what)} draws nothing, so there is nothing to export")
    tell("recording")
    names = {f"picture {number}" if len(drawn) > 1 else "picture": frame for number, frame in enumerate(drawn)}
    made = live_of(names, title or _name(what), modes=modes, lobes=lobes, controls=controls, samples=samples)
    made.error = next((frame.error for frame in drawn if frame.error), "")
    if made.error:
        made.notes.insert(0, f"The program ended early: {made.error}")
    return made


def _solution(what: Any, patches: int, tell: Callable[[str], object]) -> Any:
    """A radiosity solution of what is one or has none yet; None for what is drawn otherwise."""
    if hasattr(what, "vertex_radiosity"):
        return what
    if not is_radiosity(what):
        return None
    from glsim.radiosity import solve

    return solve(what, patches, progress=lambda stage, done, of: tell(f"{stage}: {100 * done // max(of, 1)} %"))


def _frames(what: Any, count: int, size: int | None, timeout: float | None) -> list[Frame]:
    if isinstance(what, (list, tuple)) and all(isinstance(one, Frame) for one in what):
        return list(what)
    if isinstance(what, (str, Path)) and str(what).endswith(".py"):
        return frames_of_program(what, count, calls=True, timeout=timeout, size=size)
    if count != 1:
        raise ValueError(f"frames are pictures of a program, and {_name(what)} is none")
    return [frame_of(what, size=size, calls=True)]


def _name(what: Any) -> str:
    if isinstance(what, (str, Path)):
        return Path(what).stem if Path(what).suffix else str(what)
    return getattr(what, "name", None) or getattr(what, "__name__", None) or "picture"


def export(what: Any, path: str | os.PathLike[str], **options: Any) -> Live:
    """Write ``what`` as a page: one file, offline, for any browser with WebGL2.  Options: those of ``live``.

    Returns what is on the page.  Raises ValueError for another ending than .html.
    """
    if Path(path).suffix.lower() != ".html":
        raise ValueError(f"{path}: the name must end in .html")
    made = live(what, **options)
    write_text(path, web.page(made))
    return made


def show(what: Any, *, still: Any = None, point: tuple[int, int] | None = None, **options: Any) -> Shown:
    """A live picture as the last expression of a cell, in a notebook or a lesson.

    still: the picture that paper shows instead (default: the live picture as it is first seen).  point: pixel, from the
    upper left, at which the vectors N, L, V and R or H are shown first.  Other options: those of ``live``.

        glsim.show("teapot", modes=["phong"], controls="lights.position")
    """
    return Shown(replace(live(what, **options), point=point), still)
