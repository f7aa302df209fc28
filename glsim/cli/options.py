"""Conversion and checks of option values (argparse types), and the console that the commands print to."""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn, TypeVar

from glsim.names import LOBES, SHADING, did_you_mean

if TYPE_CHECKING:
    from glsim.radiosity.scene import View
    from glsim.scenes import Camera, Lamp

Value = TypeVar("Value")

FORMULA = re.compile(r"(\$\$?).+?\1", re.DOTALL)


class Parser(argparse.ArgumentParser):
    """Asks "did you mean" for a misspelt command or choice."""

    def error(self, message: str) -> NoReturn:
        found = re.search(r"invalid choice: '(.*?)' \(choose from (.*)\)", message)
        super().error(message + did_you_mean(found[1], re.findall(r"[\w-]+", found[2])) if found else message)


def shading(text: str) -> str:
    return _canonical(text, SHADING, "the shading")


def lobe(text: str) -> str:
    return _canonical(text, LOBES, "the lobe")


def _canonical(text: str, names: dict[str, str], kind: str) -> str:
    """The canonical name for ``text``: smooth -> gouraud.  Raises ArgumentTypeError for an unknown name."""
    if text not in names:
        raise argparse.ArgumentTypeError(f"{kind} is {', '.join(names)}, not {text!r}{did_you_mean(text, names)}")
    return names[text]


def count(text: str) -> int:
    if not text.isdigit() or not 1 <= int(text) <= 1_000_000:
        raise argparse.ArgumentTypeError(f"a number from 1 to 1000000 is needed, not {text!r}")
    return int(text)


def rectangle(text: str) -> tuple[int, int]:
    found = re.fullmatch(r"(\d+)x(\d+)", text)
    if not found or not all(1 <= int(n) <= 16384 for n in found.groups()):
        raise argparse.ArgumentTypeError(f"a size such as 640x480 is needed, not {text!r}")
    return int(found[1]), int(found[2])


def number(text: str) -> int:
    if not text.isdigit() or int(text) > 1_000_000:
        raise argparse.ArgumentTypeError(f"a number from 0 to 1000000 is needed, not {text!r}")
    return int(text)


def positive(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0.0 < value < 1e12:
        raise argparse.ArgumentTypeError(f"a number above 0 is needed, not {text!r}")
    return value


def size(text: str) -> int:
    if not text.isdigit() or not 16 <= int(text) <= 4096:
        raise argparse.ArgumentTypeError(f"a number of pixels from 16 to 4096 is needed, not {text!r}")
    return int(text)


def light(text: str) -> Lamp:
    from glsim.scenes.staging import lamp_of

    return _told(lamp_of, text)


def camera(text: str) -> Camera:
    from glsim.scenes.staging import camera_of

    return _told(camera_of, text)


def viewpoint(text: str) -> str | View | Camera:
    from glsim.radiosity.cameras import viewpoint as read

    return _told(read, text)


def exitance(text: str) -> tuple[str, tuple[float, float, float]]:
    """``lamp=20`` or ``lamp=20,18,12``: a material's name, and E for red, green and blue."""
    from glsim.scenes.staging import numbers

    name, equals, values = text.rpartition("=")
    if not equals or not name:
        raise argparse.ArgumentTypeError(
            f"a material's name and its exitance are needed, NAME=E or NAME=R,G,B, not {text!r}"
        )
    given = _told(lambda words: numbers(words, 1, 3), values)
    if len(given) == 2 or min(given) < 0.0:
        raise argparse.ArgumentTypeError(
            f"an exitance is one number from 0 on, or three (red, green, blue), not {values!r}"
        )
    r, g, b = given if len(given) == 3 else 3 * given
    return name, (r, g, b)


def _told(read: Callable[[str], Value], text: str) -> Value:
    """``read(text)``, with its ValueError as argparse shows it."""
    try:
        return read(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def check_picture_name(name: str) -> None:
    """Raises ValueError, before any work, if the ending of a file name is no picture format."""
    from PIL import Image

    if Path(name).suffix.lower() not in Image.registered_extensions():
        raise ValueError(f"{name}: the name must end in .png, .jpg or another picture format")


def markdown(text: str) -> Any:
    """Markdown for the console.  Formulas stay as they are written: their signs are none of Markdown's."""
    from rich.markdown import Markdown

    return Markdown(FORMULA.sub(lambda formula: re.sub(r"([\\_*])", r"\\\1", formula[0]), text))


def console() -> Any:
    from rich.console import Console

    console = Console()
    return console if console.is_terminal else Console(width=160)
