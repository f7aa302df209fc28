"""Submissions: the entries of a folder, and which file of each belongs to an exercise, whatever it is called.

Learning platforms rename files.  Moodle makes a folder of each student; Canvas puts the student and two numbers in
front of the name ("jdoe_123_456_03_lambert-2.py"); browsers append numbers ("03_lambert (1).py").
"""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path, PurePosixPath

from glsim.course.exercise import Exercise
from glsim.course.grading.contents import Candidate, UnusableError, contents, is_junk, shown

CANVAS = re.compile(r"(?P<student>[^_]+(?:_LATE)?_\d+)_\d+_(?P<name>.+)", re.DOTALL)
VERSION = re.compile(
    r"(?P<core>.*?)(?:[ _-]*\((?P<copy>\d+)\)|-(?P<canvas>\d+)|[ _-]?v(?P<own>\d+))?", re.DOTALL | re.I
)


@dataclass(frozen=True)
class Submission:
    """What one student handed in: a file, a folder or a zip archive, or several files."""

    raw_name: str
    paths: tuple[Path, ...]

    @cached_property
    def name(self) -> str:
        """The name to show."""
        return shown(self.raw_name)

    @cached_property
    def slug(self) -> str:
        """A name for files: letters, digits, "_", "." and "-", with a part that is its own for each submission."""
        plain = re.sub(r"[^A-Za-z0-9_-]+", "_", self.name)[:60].strip("_-") or "submission"
        return f"{plain}-{hashlib.sha256(os.fsencode(self.raw_name)).hexdigest()[:8]}"


@dataclass(frozen=True)
class Chosen:
    """The file of an exercise in a submission.  note: what the teacher should know about the choice."""

    place: str
    data: bytes
    note: str = ""


def submissions(folder: Path, besides: Path | None = None) -> list[Submission]:
    """The submissions in a folder, in the order of their names.  besides: the entry that
    is no submission: the folder of results.

    Raises ValueError if there are none, FileNotFoundError or NotADirectoryError if there is no such folder."""
    entries = [Path(folder, name) for name in sorted(os.listdir(folder), key=os.fsencode) if not is_junk(name)]
    if besides and besides.exists():
        entries = [path for path in entries if not (path.exists() and path.samefile(besides))]
    groups: dict[str, list[Path]] = {}
    for path in entries:
        student = CANVAS.fullmatch(path.name) if path.is_file() else None
        groups.setdefault(student["student"] if student else path.name, []).append(path)
    found = [one for name, paths in groups.items() for one in _grouped(name, paths)]
    if not found:
        raise ValueError(f"{folder} contains no submissions: each entry is one, a file, a folder or a zip archive")
    return sorted(found, key=lambda one: os.fsencode(one.raw_name))


def _grouped(name: str, paths: Sequence[Path]) -> list[Submission]:
    """Files of one student as Canvas names them; if two have the same name, the numbers are no student's after all."""
    matches = [CANVAS.fullmatch(path.name) for path in paths]
    names = {match["name"] for match in matches if match}
    if len(paths) > 1 and len(names) < len(paths):
        return [Submission(path.name, (path,)) for path in paths]
    return [Submission(name if len(paths) > 1 else paths[0].name, tuple(paths))]


def choose(submission: Submission, wanted: Sequence[Exercise], known: Sequence[Exercise]) -> list[Chosen | str]:
    """For each wanted exercise the submission's file, or a sentence why there is none.  known: all exercises."""
    files, problems = contents(submission.paths)
    owners = [_owner(file.place, known) for file in files]
    return [_choose(one, files, owners, problems, len(wanted) == 1) for one in wanted]


Owner = tuple[str, int, int]  # name of an exercise, rank of the match (0 is best), version in the file's name


def _choose(
    one: Exercise, files: Sequence[Candidate], owners: Sequence[Owner | None], problems: Sequence[str], alone: bool
) -> Chosen | str:
    fitting = [
        (owner[1], -owner[2], file.place.count("/"), file.place, file)
        for file, owner in zip(files, owners, strict=True)
        if owner is not None and owner[0] == one.name
    ]
    ending = one.definition.ending
    unnamed = [
        file
        for file, owner in zip(files, owners, strict=True)
        if file.place.lower().endswith(ending) and (owner is None or owner[1] > 1)
    ]
    if fitting:
        order = [file for *_, file in sorted(fitting, key=lambda entry: entry[:-1])]
    elif alone and len(unnamed) == 1:
        order = unnamed
    else:
        several = f", and {len(unnamed)} other {ending} files" if alone and len(unnamed) > 1 else ""
        return "; ".join([f"there is no file {one.filename}{several}", *problems[:3]])
    note = ""
    if len(order) > 1:
        others = ", ".join(shown(file.place) for file in order[1:4]) + (", ..." if len(order) > 4 else "")
        note = f"{len(order)} files fit; {shown(order[0].place)} is graded, not {others}"
    try:
        return Chosen(shown(order[0].place), order[0].read(), note)
    except UnusableError as error:
        return str(error)


def _owner(place: str, known: Sequence[Exercise]) -> Owner | None:
    """The exercise that a file belongs to by its name, how well the name fits, and its version."""
    path = PurePosixPath(place)
    version = VERSION.fullmatch(path.stem)
    assert version is not None, "the pattern fits every text"
    number = next((int(text[:9]) for text in (version["copy"], version["canvas"], version["own"]) if text), 0)
    matches = []
    for one in known:
        rank = _rank(version["core"].lower(), one.name.lower())
        if rank is not None and path.suffix.lower() == one.definition.ending:
            matches.append((rank, -len(one.name), one.name))
    if not matches:
        return None
    rank, _, name = min(matches)
    return name, rank, number


def _rank(core: str, name: str) -> int | None:
    """How well a file's name fits an exercise: 0 its name, 1 something before it, 2 its topic, 3, 4 around these."""
    topic = name[3:]
    if core == name:
        return 0
    if re.search(rf"[^a-z0-9]{re.escape(name)}$", core):
        return 1
    if core == topic:
        return 2
    if re.search(rf"[^a-z0-9]{re.escape(topic)}$", core):
        return 3
    return 4 if re.search(rf"(?:^|[^a-z0-9]){re.escape(name)}(?![a-z0-9])", core) else None
