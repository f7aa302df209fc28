"""Files: where glsim's own data lie, and writing without ever leaving half a file behind."""

from __future__ import annotations

import os
import stat
import tempfile
from collections.abc import Callable
from pathlib import Path


def data_folder(kind: str) -> Path:
    """The folder ``shaders`` or ``lessons``: inside the package when installed, beside it in a checkout."""
    package = Path(__file__).parent
    inside = package / kind
    return inside if inside.is_dir() else package.parent / kind


def check_folder(path: str | os.PathLike[str]) -> None:
    """Raises FileNotFoundError if the folder of a file that is to be written does not exist."""
    if not Path(path).parent.is_dir():
        raise FileNotFoundError(f"cannot write {path}: there is no folder {Path(path).parent}; make it first")


def write_atomically(path: str | os.PathLike[str], save: Callable[[str], object]) -> None:
    """Call ``save`` with a temporary name beside ``path`` and rename the result when it is whole.

    Raises FileNotFoundError if the folder does not exist.
    """
    check_folder(path)
    target = Path(path)
    handle, name = tempfile.mkstemp(suffix=target.suffix, prefix=f".{target.stem}-", dir=target.parent)
    os.close(handle)
    try:
        save(name)
        umask = os.umask(0)
        os.umask(umask)
        os.chmod(name, 0o666 & ~umask)
        os.replace(name, target)
    except BaseException:
        os.unlink(name)
        raise


def write_bytes(path: str | os.PathLike[str], data: bytes) -> None:
    write_atomically(path, lambda name: Path(name).write_bytes(data))


def write_text(path: str | os.PathLike[str], text: str) -> None:
    write_atomically(path, lambda name: Path(name).write_text(text, encoding="utf-8"))


def read_regular(path: str | os.PathLike[str], most: int) -> bytes:
    """The bytes of a regular file of at most ``most`` bytes; links are not followed, and a FIFO does not block.

    For files that an untrusted program wrote.  Raises ValueError for a file that is larger or not regular, OSError as
    ``open`` does.
    """
    flags = os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
    with open(os.open(path, flags), "rb") as file:
        facts = os.fstat(file.fileno())
        if not stat.S_ISREG(facts.st_mode):
            raise ValueError(f"{path} is no regular file")
        data = file.read(most + 1)
    if len(data) > most:
        raise ValueError(f"{path} has more than {most} bytes")
    return data
