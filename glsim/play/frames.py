"""The Frame of anything: a scene, a mesh file, a function that draws, or a PyOpenGL/GLUT program."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from glsim.machine import archive
from glsim.machine.frame import Frame, Where
from glsim.play.capture import capture
from glsim.scenes import Scene, open_scene
from glsim.scenes.load import from_trimesh


def frame_of(
    what: Any, *, size: int | None = None, calls: bool = False, step: int = 0, events: Sequence[str] = (),
    timeout: float | None = 60.0,
) -> Frame:  # fmt: skip
    """What ``what`` draws, as a Frame.

    what: a Frame (returned as it is), a function that draws with the gl commands, a Scene, the name of a built-in
        scene, the path of a mesh file, a trimesh.Trimesh, or the path of a program (.py), run as ``glsim run`` does.
    size: pixels of the picture (default: 512, or as the program asks).  calls: record every call.
    step: number of the program's picture, from 0.  events: delivered to the program, one for each step from 1 on.
    timeout: seconds that the program may run; None for no limit.

    Raises ValueError if nothing can be drawn, FileNotFoundError for a program that does not exist.
    """
    if isinstance(what, Frame):
        return what
    if isinstance(what, (str, Path)) and str(what).endswith(".py"):
        return frame_of_program(what, calls=calls, step=step, events=events, timeout=timeout, size=size)
    if isinstance(what, (str, Path)) and Path(what).is_dir():
        raise ValueError(f"{what}: is a folder; name a program, a built-in scene or a mesh file")
    size = 512 if size is None else size
    title, draw = drawer(what, size)
    from glsim.render.context import own_screen

    with own_screen(size, size), capture(calls=calls) as frame:
        draw()
    if not frame.packets:
        raise ValueError(f"{title} draws nothing here: does it open a context of its own?")
    return frame


def frame_of_program(
    script: str | Path, *, calls: bool = False, step: int = 0, events: Sequence[str] = (), timeout: float | None = 60.0,
    size: int | None = None,
) -> Frame:  # fmt: skip
    """The picture number ``step`` (from 0) of a program's first window, as a Frame.

    If an error ends the program earlier, the Frame holds the packets up to it, and ``frame.error`` the message.  Raises
    ValueError if the program gives no picture.
    """
    return _played(script, step + 1, calls, events, timeout, size, each=False)[0]


def frames_of_program(
    script: str | Path, count: int, *, calls: bool = False, events: Sequence[str] = (), timeout: float | None = 60.0,
    size: int | None = None,
) -> list[Frame]:  # fmt: skip
    """The first ``count`` pictures of a program's first window, fewer if it ends earlier; otherwise as
    ``frame_of_program``."""
    return _played(script, count, calls, events, timeout, size, each=True)


def _played(
    script: str | Path,
    count: int,
    calls: bool,
    events: Sequence[str],
    timeout: float | None,
    size: int | None,
    each: bool,
) -> list[Frame]:
    """Play a program for ``count`` steps.  The Frame of its last picture, or those of all if ``each``."""
    from glsim.play.plan import Plan
    from glsim.play.run import run

    with tempfile.TemporaryDirectory(prefix="glsim-") as folder:
        target = os.path.join(folder, "frame")
        plan = Plan(str(script), frames=count, events=list(events)[: count - 1], capture=target, capture_calls=calls,
                    capture_each=each, count=True, size=(size, size) if size is not None else None)  # fmt: skip
        record = run(plan, timeout)
        errors = record["errors"]
        if record["status"] == "interrupted":
            raise KeyboardInterrupt
        paths = [f"{target}-{step}" for step in range(count)] if each else []
        found = [path for path in paths if os.path.exists(path)] or [path for path in [target] if os.path.exists(path)]
        if not found:
            reasons = [error["error"] for error in errors] or record["notes"]
            reason = "it opens no window" if record["status"] == "no-window" else (reasons or [record["status"]])[0]
            raise ValueError(f"{script} gives no picture: {reason}")
        frames = [archive.load(path) for path in found]
    if errors:
        frames[-1].error = errors[0]["error"]
        frames[-1].error_at = Where(str(Path(script).resolve()), errors[0]["line"]) if errors[0]["line"] else None
    elif record["status"] != "ok":
        frames[-1].error = (record["notes"] or [record["status"]])[-1]
    return frames


def drawer(what: Any, size: int) -> tuple[str, Callable[[], object]]:
    """The title of a drawing function or of what ``scene_from`` takes, and a function () that draws it at size x size
    pixels."""
    if callable(what) and not isinstance(what, Scene):
        return getattr(what, "__name__", "drawing"), what
    scene = scene_from(what)
    return scene.name, lambda: scene.draw(size, size)


def scene_from(what: Any) -> Scene:
    """A Scene (returned as it is), a built-in scene by name, a mesh file by path, or a trimesh.Trimesh as a Scene."""
    if isinstance(what, Scene):
        return what
    if isinstance(what, (str, Path)):
        return open_scene(what)
    if hasattr(what, "vertices") and hasattr(what, "faces"):
        return Scene("mesh", from_trimesh([what], "the mesh"), two_sided=True)
    raise TypeError(f"a scene name, a file, a Scene, a mesh or a drawing function is needed, not {what!r}")
