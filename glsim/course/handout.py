"""What a student gets: the file to begin with, with the statement in front; and what the student has solved."""

from __future__ import annotations

import json
import os
import textwrap
from pathlib import Path

from glsim.course.checking import Result
from glsim.course.exercise import Exercise, Part
from glsim.files import write_text

WIDTH = 96  # columns of the statement


def starter(exercise: Exercise) -> str:
    """The text of the file that a student begins with: the statement as a comment, then the starter."""
    mark = "//" if exercise.definition.ending == ".glsl" else "#"
    lines = [exercise.heading, ""]
    for paragraph in exercise.statement.split("\n\n"):
        filled = textwrap.wrap(" ".join(paragraph.split()), WIDTH, break_long_words=False, break_on_hyphens=False)
        lines += [*(paragraph.split("\n") if paragraph.startswith(("-", "    ", "|")) else filled), ""]
    lines += [f"Check with: glsim exercise check {exercise.filename}"]
    return "\n".join(f"{mark} {line}".rstrip() for line in lines) + "\n\n" + exercise.definition.starter


def write_starter(exercise: Exercise, folder: Path) -> Path:
    """Write the starter into a folder, which is made if it does not exist; returns its path.

    Raises FileExistsError if the file is there already: a student's work is never overwritten."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / exercise.filename
    if path.exists():
        raise FileExistsError(f"{path} is there already: rename it, or name another folder")
    write_text(path, starter(exercise))
    return path


def solution(exercise: Exercise, folder: Path) -> str:
    """The text of a solution, from a teacher's folder.  Raises FileNotFoundError if it has none."""
    path = folder / exercise.filename
    if not path.is_file():
        raise FileNotFoundError(f"{folder} has no {path.name}: solutions come apart from glsim, from the teacher")
    return path.read_text(encoding="utf-8")


def hints(exercise: Exercise) -> list[str]:
    """A first hint for each part: what it asks for, and how.  No values, and not the solution."""

    def first(part: Part) -> str:
        hint = getattr(part, "hint", "")
        return f"{part.about}: {hint}" if hint else part.about

    return [first(part) for part in exercise.definition.parts]


# ---------------------------------------------------------------- progress


def progress_file() -> Path:
    """The file that says which exercises are solved: $XDG_STATE_HOME/glsim/exercises.json, or below ~/.local/state."""
    base = os.environ.get("XDG_STATE_HOME") or os.path.join(os.path.expanduser("~"), ".local", "state")
    return Path(base) / "glsim" / "exercises.json"


def progress() -> dict[str, int]:
    """The best points so far: name of the exercise -> points.  {} if nothing was checked, or the file is damaged."""
    try:
        known = json.loads(progress_file().read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return {str(name): points for name, points in known.items() if isinstance(points, int)}


def remember(result: Result) -> None:
    """Note the points of a file if they are the best so far.  A home folder that cannot be written to is no error."""
    known = progress()
    name = result.exercise.name
    if result.points > known.get(name, -1):
        try:
            progress_file().parent.mkdir(parents=True, exist_ok=True)
            write_text(progress_file(), json.dumps({**known, name: result.points}, indent=1, sort_keys=True) + "\n")
        except OSError:
            return
