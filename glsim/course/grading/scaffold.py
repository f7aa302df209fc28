"""The folder that a learning platform wants as its autograder."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from glsim.course.exercise import Exercise
from glsim.files import write_text
from glsim.version import __version__

TEMPLATES = Path(__file__).with_name("scaffolds")
PLATFORMS = ("classroom50", "gradescope")


def scaffold(platform: str, folder: Path, wanted: Sequence[Exercise]) -> list[Path]:
    """Write the files of an autograder for exercises into a folder, which is made if it does not exist.

    platform: one of PLATFORMS.  Raises FileExistsError, before anything is written, if one of the files is there."""
    words = {
        "@EXERCISES@": ",".join(one.name for one in wanted),
        "@POINTS@": str(sum(one.points for one in wanted)),
        "@VERSION@": __version__,
    }
    templates = sorted(path for path in (TEMPLATES / platform).iterdir() if path.is_file())
    targets = [folder / path.name.removesuffix(".txt") for path in templates]
    for target in targets:
        if target.exists():
            raise FileExistsError(f"{target} is there already: name another folder")
    folder.mkdir(parents=True, exist_ok=True)
    for template, target in zip(templates, targets, strict=True):
        text = template.read_text(encoding="utf-8")
        for name, word in words.items():
            text = text.replace(name, word)
        write_text(target, text)
        if text.startswith("#!"):
            target.chmod(0o755)
    return targets
