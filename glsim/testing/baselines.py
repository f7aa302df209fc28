"""Baselines: where they lie, how they are called, what is written in them.

    tests/test_ball.py                                        def test_phong(gl, gl_snapshot)
    tests/__gl_snapshots__/test_ball/test_phong.png           the first one that was approved
    tests/__gl_snapshots__/test_ball/test_phong.radeon.png    approved for another renderer
    tests/__gl_snapshots__/test_ball/test_phong.2.png         one more: any of them may match

pytest imports this file in each run, so NumPy and Pillow are imported where pictures are read.
"""

from __future__ import annotations

import os
import re
import zlib
from collections.abc import Iterator, Mapping
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from glsim.images import Pixels

FOLDER = "__gl_snapshots__"
LONGEST = 80  # characters of a file name before its hash and its ending
FACTS = ("renderer", "version", "size", "glsim", "probe")  # keys of the PNG's text chunks


class Baseline(NamedTuple):
    """An approved picture.  facts: the text chunks of its PNG, without renderer and version if nobody knows who drew
    it."""

    path: Path
    facts: Mapping[str, str]


def folder_of(test_file: Path) -> Path:
    """The folder of a test file's baselines."""
    return test_file.parent / FOLDER / test_file.stem


def base_name(test: str, name: str = "") -> str:
    """A file name, without its ending, for each snapshot: ``test_ball[red-2]-left`` for test_ball[red-2] and "left".

    test: the test's name as pytest has it, with its class and parameters: ``TestLight::test_ball[red-2]``.
    The result is a file name in every file system.  A name that is too long, that has signs which cannot be in a file
    name, or capitals, which some systems take for small letters, gets a hash of the original at its end, so that no two
    snapshots share a file.
    """
    base = _safe(test)
    if name:
        base += "-" + re.sub(r"[^\w-]", "-", name, flags=re.ASCII)
    original = test.replace("::", "+") + ("-" + name if name else "")
    if base == original.lower() and len(base) <= LONGEST and not re.fullmatch(r"(?i)con|prn|aux|nul|(com|lpt)\d", base):
        return base
    digest = sha256(f"{test}\0{name}".encode()).hexdigest()[:8]
    return (base if len(base) <= LONGEST else _cut(base)) + f"-{digest}"


def _safe(test: str) -> str:
    head, bracket, parameters = test.partition("[")
    base = re.sub(r"[^\w+]", "-", head.replace("::", "+"), flags=re.ASCII)
    if bracket:
        base += "[" + re.sub(r"[^\w.-]", "-", parameters.removesuffix("]"), flags=re.ASCII) + "]"
    return base


def _cut(base: str) -> str:
    return re.sub(r"[\[\].]", "-", base[:LONGEST])


def may_belong(file_name: str, test: str) -> bool:
    """Whether a file can be a baseline of a test, whatever the name of the snapshot."""
    base = _safe(test)
    heads = [head for head in (base, _cut(base)) if file_name.startswith(head)]
    return any(len(base) >= LONGEST or file_name[len(head)] in "-." for head in heads)


def belongs(file_name: str, base: str) -> bool:
    """Whether a file is a baseline of the snapshot ``base``: ``base[.renderer][.k].png``."""
    return file_name.startswith(base) and bool(re.fullmatch(r"(\.[a-z0-9-]+){0,2}\.png", file_name[len(base) :]))


def find(folder: Path, base: str) -> list[Baseline]:
    """The approved baselines of a snapshot, the first approved one first."""
    return [Baseline(path, facts(path)) for path in pictures(folder) if belongs(path.name, base)]


def pictures(folder: Path) -> list[Path]:
    """All baselines in a folder, short names first."""
    found = folder.glob("*.png") if folder.is_dir() else ()
    return sorted((path for path in found if not path.name.startswith(".")), key=lambda path: (len(path.name), path))


def same_renderer(a: Mapping[str, str], b: Mapping[str, str]) -> bool:
    """Whether one version of one renderer drew both pictures, or nobody knows who drew either.

    If both have the hash of the probe picture, the hashes must be equal too, because a software renderer rounds
    differently on different processors."""
    alike = all(a.get(key, "") == b.get(key, "") for key in ("renderer", "version"))
    return alike and len({facts["probe"] for facts in (a, b) if facts.get("probe")}) < 2


def target(folder: Path, base: str, made: Mapping[str, str], closest: str = "", add: bool = False) -> Path:
    """Where a picture is written when it is approved: over the baseline of its renderer, or beside those of others.

    made: the picture's facts.  closest: of several baselines of the renderer, the file name of the one to replace.
    add: replace none.
    """
    existing = find(folder, base)
    own = [baseline.path for baseline in existing if same_renderer(baseline.facts, made)]
    if own and not add:
        return next((path for path in own if path.name == closest), own[0])
    tag = re.sub(r"[^a-z0-9]+", "-", re.split(r"[(/]", made.get("renderer", "").lower())[0])[:32].strip("-")
    names = [base] if not existing else []
    names += [f"{base}.{tag}"] if tag else []
    names += [f"{names[-1] if names else base}.{k}" for k in range(2, 1000)]
    taken = {baseline.path.name for baseline in existing}
    return next(folder / f"{name}.png" for name in names if f"{name}.png" not in taken)


def read(path: Path) -> Pixels:
    """The pixels of a picture file, (height, width, 4) uint8.  Raises ValueError, OSError as ``images.rgba`` does."""
    from glsim.images import rgba

    return rgba(path)


def write(path: Path, pixels: Pixels, made: Mapping[str, str]) -> None:
    """Write RGBA (height, width, 4) with its facts as a PNG, as small as it can be without loss."""
    import numpy as np
    from PIL import Image
    from PIL.PngImagePlugin import PngInfo

    from glsim.files import write_atomically

    grey = not (np.ptp(pixels[..., :3], axis=2)).any()
    opaque = bool((pixels[..., 3] == 255).all())
    channels = {(True, True): [0], (True, False): [0, 3], (False, True): [0, 1, 2], (False, False): [0, 1, 2, 3]}
    values = np.ascontiguousarray(pixels[..., channels[grey, opaque]])
    text = PngInfo()
    for key in FACTS:
        if made.get(key):
            text.add_text(key, made[key])
    path.parent.mkdir(parents=True, exist_ok=True)
    image = Image.fromarray(values[..., 0] if values.shape[2] == 1 else values)
    write_atomically(path, lambda name: image.save(name, "PNG", pnginfo=text, optimize=True))


def facts(path: Path) -> dict[str, str]:
    """The text chunks of a PNG that stand before its pixels; {} for what is no PNG."""
    try:
        with path.open("rb") as file:
            return dict(_texts(file))
    except (OSError, ValueError, UnicodeError, zlib.error):
        return {}


def _texts(file: Any) -> Iterator[tuple[str, str]]:
    """Keys and values of the chunks tEXt and iTXt (PNG specification, section 11.3.4), up to IDAT."""
    if file.read(8) != b"\x89PNG\r\n\x1a\n":
        raise ValueError("no PNG")
    while len(head := file.read(8)) == 8:
        length, kind = int.from_bytes(head[:4], "big"), head[4:]
        if kind == b"IDAT":
            return
        if kind not in (b"tEXt", b"iTXt") or length > 1 << 16:
            file.seek(length + 4, os.SEEK_CUR)
            continue
        key, _, value = file.read(length).partition(b"\0")
        file.seek(4, os.SEEK_CUR)  # the checksum
        if kind == b"tEXt":
            yield key.decode("latin-1"), value.decode("latin-1")
        elif value[:1] == b"\0":  # not compressed
            yield key.decode("latin-1"), value[2:].split(b"\0", 2)[2].decode()
