"""The report of a run: a folder with report.json, an offline page, the pictures that failed, and how they differ.

gl-report/index.html                                                        the page
gl-report/candidates/tests/__gl_snapshots__/test_ball/test_phong.png        what was drawn; can be approved
gl-report/differences/tests/__gl_snapshots__/test_ball/test_phong.png       expected, actual, difference x 16
gl-report/report.json                                                       what ``glsim snapshots`` reads
"""

from __future__ import annotations

import json
import os
import re
from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from glsim.files import write_atomically, write_text
from glsim.images import Pixels, on_paper
from glsim.metrics import amplified, difference
from glsim.pictures import tiles
from glsim.testing import baselines
from glsim.testing.settings import Settings
from glsim.version import __version__

FORMAT = 1
AMPLIFIED = 16
MOST = 100  # strips on the page
TEXTS = ("test", "name", "base", "folder", "status", "message", "closest", "candidate", "difference")
PICTURES = ("candidates", "differences")
ORDER = ("failed", "missing", "close", "updated", "passed")
SAID = {
    "failed": "failed",
    "missing": "without a baseline",
    "close": "passed without being equal",
    "updated": "written as baselines",
    "passed": "equal to a baseline",
}


def write_difference(path: Path, expected: Pixels, actual: Pixels) -> None:
    """Expected, actual, and the difference x 16 as one PNG.  Pictures of different sizes share the larger frame."""
    height, width = np.maximum(expected.shape[:2], actual.shape[:2])
    padded = []
    for picture in (expected, actual):
        frame = np.zeros((height, width, 4), np.uint8)
        frame[: picture.shape[0], : picture.shape[1]] = picture
        padded.append(frame)
    d = np.abs(difference(*padded))
    shown = np.maximum(d[..., :3], d[..., 3:])  # alpha is white
    row = [
        (f"expected, {expected.shape[1]} x {expected.shape[0]}", on_paper(padded[0])),
        (f"actual, {actual.shape[1]} x {actual.shape[0]}", on_paper(padded[1])),
        (f"difference x {AMPLIFIED}", amplified(shown, AMPLIFIED)),
    ]
    sheet = tiles(path.stem, [row], max(256, min(1024, int(height), int(width))))
    path.parent.mkdir(parents=True, exist_ok=True)
    write_atomically(path, lambda name: sheet.save(name, "PNG"))


def update_report(
    settings: Settings,
    entries: Sequence[dict[str, Any]],
    unused: Sequence[str],
    header: Sequence[str],
    is_old: Callable[[str], bool],
) -> tuple[bool, int]:
    """Replace what the report says of the tests that ran; what an earlier run said of others stays, with its pictures.

    is_old: whether what was said of a test, or of the baselines of a test file, no longer holds.
    Returns whether there is a report, and how many snapshots of an earlier run are in it.  If nothing failed and
    ``report_all`` is not set, there is none."""
    kept, still = _earlier(settings, is_old)
    all_unused = sorted({*unused, *still})
    said = [*entries, *kept]
    there = settings.report_all or all_unused or any(entry["status"] in ("failed", "missing") for entry in said)
    _remove_pictures(settings.folder, said if there else ())
    if there:
        write_report(settings, said, all_unused, header)
        return True, len(kept)
    for name in ("index.html", "report.json", ".gitignore"):
        (settings.folder / name).unlink(missing_ok=True)
    return False, 0


def _earlier(settings: Settings, is_old: Callable[[str], bool]) -> tuple[list[dict[str, Any]], list[str]]:
    """The snapshots and the unused baselines of an earlier run's report that still hold."""
    try:
        report = load_report(settings.folder)
    except (OSError, ValueError):
        return [], []
    kept = [entry for entry in report["snapshots"] if not is_old(entry["test"]) and _is_whole(settings, entry)]
    unused = [path for path in report["unused"] if (settings.root / path).is_file() and not is_old(_tests_of(path))]
    return kept, unused


def _is_whole(settings: Settings, entry: dict[str, Any]) -> bool:
    """Whether the pictures that an entry names are there, and where pictures of this project lie."""
    try:
        inside(settings.root, f"{entry['folder']}/{entry['closest'] or 'none.png'}")
        return not entry["candidate"] or inside(settings.folder, entry["candidate"]).is_file()
    except ValueError:
        return False


def _tests_of(baseline: str) -> str:
    """The test file that a baseline belongs to: tests/__gl_snapshots__/test_ball/x.png -> tests/test_ball.py."""
    folder = Path(baseline).parent
    return (folder.parent.parent / f"{folder.name}.py").as_posix()


def _remove_pictures(folder: Path, said: Sequence[dict[str, Any]]) -> None:
    """Remove the pictures that no entry names, so that nothing of an earlier run is approved by mistake."""
    named = {str(folder / entry[kind]) for entry in said for kind in ("candidate", "difference") if entry[kind]}
    for part in PICTURES:
        if (folder / part).is_symlink():
            (folder / part).unlink()
        for inner, _, files in os.walk(folder / part, topdown=False):
            for file in files:
                if os.path.join(inner, file) not in named:
                    os.unlink(os.path.join(inner, file))
            if not os.listdir(inner):
                os.rmdir(inner)


def write_report(
    settings: Settings, entries: Sequence[dict[str, Any]], unused: Sequence[str], header: Sequence[str]
) -> None:
    """index.html and report.json, into the report's folder."""
    from glsim.web.page import page

    folder = settings.folder
    folder.mkdir(parents=True, exist_ok=True)
    write_text(folder / ".gitignore", "*\n")
    ordered = sorted(entries, key=lambda entry: ORDER.index(entry["status"]))
    counted = Counter(entry["status"] for entry in ordered)
    shown = [entry for entry in ordered if entry["candidate"]]
    strips = [_strip(settings, entry) for entry in shown[:MOST]]
    about = [", ".join(f"{counted[s]} {SAID[s]}" for s in ORDER if counted[s]) + "."]
    about += [f"The first {MOST} of {len(shown)} pictures are shown."] if len(shown) > MOST else []
    about += [f"Unused baselines: {', '.join(unused)}."] if unused else []
    about += header
    write_text(folder / "index.html", page("Pictures of a test run", strips, "\n\n".join(about)))
    report = {"format": FORMAT, "glsim": __version__, "snapshots": ordered, "unused": list(unused)}
    write_text(folder / "report.json", json.dumps(report, indent=1) + "\n")


def _strip(settings: Settings, entry: dict[str, Any]) -> Any:
    from glsim.web.page import Picture, Strip

    actual = baselines.read(settings.folder / entry["candidate"])
    pictures = [Picture("actual", actual)]
    path = settings.root / entry["folder"] / entry["closest"]
    if entry["closest"] and path.is_file():
        pictures.insert(0, Picture("expected", baselines.read(path), entry["closest"]))
    status = "passed" if entry["status"] == "close" else "failed"
    title = entry["test"] + (f", {entry['name']}" if entry["name"] else "")
    return Strip(title, pictures, 0, status, [entry["message"]])


def load_report(folder: Path) -> dict[str, Any]:
    """What report.json says, checked.  Raises ValueError, OSError for a folder that is no report."""
    from glsim.files import read_regular

    try:
        report = json.loads(read_regular(folder / "report.json", 1 << 26))
        entries, unused = report["snapshots"], report["unused"]
        sound = report["format"] == FORMAT and all(isinstance(path, str) for path in unused)
        for entry in entries:
            sound = sound and all(isinstance(entry[key], str) for key in TEXTS) and entry["status"] in ORDER
    except FileNotFoundError:
        raise FileNotFoundError(
            f"{folder} is no report of snapshots: there is no report.json in it (a run"
            " in which all pictures pass leaves none)"
        ) from None
    except (ValueError, KeyError, TypeError) as error:
        raise ValueError(f"{folder}/report.json is no report of this glsim: {error}") from None
    if not sound:
        raise ValueError(f"{folder}/report.json is no report of this glsim")
    return {"snapshots": entries, "unused": unused}


def inside(root: Path, relative: str) -> Path:
    """root / relative, if that is a baseline's place inside of root.

    A report may come from a stranger's pull request: raises ValueError for every other place."""
    path = (root / relative).resolve()
    shape = (
        list(Path(relative).parts[-3:-2]) == [baselines.FOLDER] and relative.endswith(".png") and "\\" not in relative
    )
    if not shape or not path.is_relative_to(root.resolve()):
        raise ValueError(f"the report names a place that is none of baselines: {relative!r}")
    return path


def approve(report: Path, root: Path, entry: dict[str, Any], add: bool = False) -> Path:
    """Make a candidate of a report a baseline under ``root``; returns where it lies.

    add: beside the baseline of its renderer instead of in its place."""
    source = inside(report, entry["candidate"])
    if not re.fullmatch(r"[\w+-][\w+.\[\]-]*", entry["base"]):
        raise ValueError(f"the report names no baseline: {entry['base']!r}")
    folder = inside(root, f"{entry['folder']}/{entry['base']}.png").parent
    if not folder.parent.parent.is_dir():
        raise FileNotFoundError(
            f"there is no folder {folder.parent.parent}: run this in the project's folder, or name it with --root"
        )
    with Image.open(source) as image:
        image.verify()
    path = baselines.target(folder, entry["base"], baselines.facts(source), entry["closest"], add)
    baselines.write(path, baselines.read(source), baselines.facts(source))
    return path
