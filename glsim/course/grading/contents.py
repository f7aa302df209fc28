"""What a submission contains: files, folders and zip archives, read without trusting them.

Nothing is unpacked to a name that an archive says: one chosen file is read into memory, up to a limit.
"""

from __future__ import annotations

import io
import os
import stat
import zipfile
import zlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from glsim.files import read_regular

MOST_BYTES = 1 << 20  # of a student's file
MOST_ARCHIVE = 1 << 26  # bytes of a zip archive
MOST_FILES = 5000  # of a submission that are looked at
DEEPEST = 40  # folders within folders
JUNK = {
    "__MACOSX",
    ".DS_Store",
    ".git",
    ".ipynb_checkpoints",
    ".venv",
    "__pycache__",
    "Thumbs.db",
    "desktop.ini",
    "venv",
}
OTHER_ARCHIVES = (".7z", ".gz", ".rar", ".tar", ".tgz", ".xz")


class UnusableError(ValueError):
    """A submission, or a file of it, cannot be read; the message is a sentence for the teacher and the student."""


@dataclass(frozen=True)
class Candidate:
    """A file of a submission.  place: its path, as "abgabe.zip/src/03_lambert.py".

    read: returns its bytes; raises UnusableError if they cannot be read, or are more than MOST_BYTES."""

    place: str
    read: Callable[[], bytes]


def shown(text: str) -> str:
    """Text of a stranger as one line that every terminal, page and XML file can show: other characters are escaped."""
    return "".join(c if c.isprintable() or c == "\u200d" else c.encode("unicode_escape").decode() for c in text)


def is_junk(name: str) -> bool:
    """Whether a name is one that operating systems and tools leave behind."""
    return name in JUNK or name.startswith("._")


def contents(paths: Sequence[Path]) -> tuple[list[Candidate], list[str]]:
    """The files of a submission, those of its zip archives too, and sentences about what could not be opened.

    Raises OSError if the teacher's own system refuses to read something."""
    files: list[Candidate] = []
    problems: list[str] = []
    for path, place in _walked(paths):
        if len(files) >= MOST_FILES:
            problems.append(f"there are more than {MOST_FILES} files; the others were not looked at")
            break
        try:
            if path.is_symlink():
                problems.append(f"{shown(place)} is a link, and links are not followed")
            elif path.suffix.lower() == ".zip":
                files += _members(path, place, problems)
            elif path.suffix.lower() in OTHER_ARCHIVES:
                problems.append(f"{shown(place)}: of archives only zip is opened")
            else:
                files.append(Candidate(place, partial(_read_file, path, place)))
        except UnusableError as error:
            problems.append(str(error))
    return files[:MOST_FILES], problems


def _walked(paths: Sequence[Path]) -> Iterator[tuple[Path, str]]:
    """All files below ``paths`` with their places, in the order of their names.  Links are not followed."""
    for top in paths:
        if not top.is_dir() or top.is_symlink():
            yield top, top.name
            continue
        for folder, folders, names in os.walk(top, onerror=_refuse):
            depth = len(Path(folder).relative_to(top).parts)
            folders[:] = sorted(name for name in folders if not is_junk(name)) if depth < DEEPEST else []
            for name in sorted(names):
                if not is_junk(name):
                    path = Path(folder, name)
                    yield path, path.relative_to(top).as_posix()


def _refuse(error: OSError) -> None:
    raise error


def _read_file(path: Path, place: str, most: int = MOST_BYTES) -> bytes:
    try:
        return read_regular(path, most)
    except ValueError:
        raise UnusableError(f"{shown(place)} is no ordinary file, or has more than {most >> 20} MiB") from None


def _members(path: Path, place: str, problems: list[str]) -> list[Candidate]:
    """The files of a zip archive.  Raises UnusableError if it is none."""
    data = _read_file(path, place, MOST_ARCHIVE)
    if data.count(b"PK\x01\x02") > 4 * MOST_FILES:  # before a list of millions of names is built
        raise UnusableError(f"{shown(place)} has too many files; at most {MOST_FILES} are looked at")
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            infos = archive.infolist()
    except (zipfile.BadZipFile, ValueError, NotImplementedError, OSError) as error:
        raise UnusableError(f"{shown(place)} is no zip archive that can be opened ({error})") from None
    if len(infos) > MOST_FILES:
        raise UnusableError(f"{shown(place)} has {len(infos)} files; at most {MOST_FILES} are looked at")
    members = []
    for info in infos:
        if info.is_dir() or any(is_junk(part) for part in info.filename.split("/")):
            continue
        inside = f"{place}/{info.filename}"
        if stat.S_ISLNK(info.external_attr >> 16):
            problems.append(f"{shown(inside)} is a link, and links are not followed")
            continue
        members.append(Candidate(inside, partial(_read_member, data, info, inside)))
    return members


def _read_member(data: bytes, info: zipfile.ZipInfo, place: str) -> bytes:
    """At most MOST_BYTES of a file in an archive are ever unpacked, whatever size the archive says it has."""
    if info.flag_bits & 0x1:
        raise UnusableError(f"{shown(place)} is encrypted")
    if info.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise UnusableError(f"{shown(place)} is compressed in an unusual way; use the usual one, deflate")
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive, archive.open(info) as file:
            read = file.read(MOST_BYTES + 1)
    except (zipfile.BadZipFile, zlib.error, EOFError, OSError, RuntimeError, ValueError) as error:
        raise UnusableError(f"{shown(place)} is damaged ({error})") from None
    if len(read) > MOST_BYTES:
        raise UnusableError(f"{shown(place)} has more than {MOST_BYTES >> 20} MiB")
    return read
