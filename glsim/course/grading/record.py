"""What grading found out about one submission and one exercise, and the folder in which it is kept."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from glsim.files import write_text


@dataclass(frozen=True)
class Part:
    """The judgement of a part of an exercise.

    hint: what is wrong, "" if nothing is.  picture: a PNG in base64, the expected picture beside the student's, "" if
    the part has none."""

    about: str
    points: int
    most: int
    hint: str = ""
    picture: str = ""

    @property
    def right(self) -> bool:
        return self.points == self.most


@dataclass(frozen=True)
class Record:
    """The marks of one submission for one exercise.

    submission: its name, to show.  slug: a name for files.  exercise: such as "03_lambert".  file: the student's file
    that was graded, "" if there is none; then ``note`` says why.  printed: the end of what the file printed.
    isolation: in what the file ran.  seconds: that grading took.  key: of file and exercise together; an equal key
    means an equal mark.  failure: why there is no mark, "" if there is one; a failure is never the student's fault."""

    submission: str
    slug: str
    exercise: str
    title: str
    parts: tuple[Part, ...]
    file: str = ""
    note: str = ""
    printed: str = ""
    isolation: str = ""
    seconds: float = 0.0
    key: str = ""
    failure: str = ""

    @property
    def points(self) -> int:
        return sum(part.points for part in self.parts)

    @property
    def most(self) -> int:
        return sum(part.most for part in self.parts)


class Store:
    """A folder with a file for each Record, written whole at once, so that a run that was stopped can go on."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def write(self, record: Record) -> None:
        """Write a Record in place of an older one."""
        self.folder.mkdir(parents=True, exist_ok=True)
        write_text(self._path(record.slug, record.exercise), json.dumps(asdict(record), indent=1) + "\n")

    def read(self, slug: str, exercise: str) -> Record | None:
        """The Record that was written, None if there is none or its file is damaged."""
        try:
            fields = json.loads(self._path(slug, exercise).read_text(encoding="utf-8"))
            fields["parts"] = tuple(Part(**part) for part in fields["parts"])
            return Record(**fields)
        except (OSError, ValueError, TypeError, KeyError):
            return None

    def _path(self, slug: str, exercise: str) -> Path:
        return self.folder / f"{slug}.{exercise}.json"


@dataclass(frozen=True)
class Total:
    """All Records of one submission."""

    submission: str
    slug: str
    records: tuple[Record, ...]

    @property
    def points(self) -> int:
        return sum(record.points for record in self.records)

    @property
    def most(self) -> int:
        return sum(record.most for record in self.records)


def totals(records: Sequence[Record]) -> list[Total]:
    """The Records of each submission together, in the order in which submissions first appear."""
    groups: dict[str, list[Record]] = {}
    for record in records:
        groups.setdefault(record.slug, []).append(record)
    return [Total(group[0].submission, slug, tuple(group)) for slug, group in groups.items()]
