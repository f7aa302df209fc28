"""Pictures in the terminal, where it can show them and the package textual-image is installed."""

from __future__ import annotations

import sys
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from glsim.testing.settings import in_ci

WIDTH = 80  # columns


def show(config: Any, reporter: Any, paths: list[Path]) -> None:
    """Show pictures below pytest's summary; in terminals without graphics nothing is shown."""
    if not paths or in_ci() or not reporter.isatty or not find_spec("textual_image"):
        return
    capture = config.pluginmanager.getplugin("capturemanager")
    if capture is not None:
        capture.suspend_global_capture(in_=True)  # the terminal answers on standard input
    if not (sys.__stdout__ and sys.__stdout__.isatty() and sys.__stdin__ and sys.__stdin__.isatty()):
        return
    from rich.console import Console

    renderable: Any = __import__("textual_image.renderable", fromlist=["renderable"])  # asks the terminal
    if renderable.Image not in (renderable.SixelImage, renderable.TGPImage):
        return
    console = Console(file=sys.__stdout__)
    for path in paths:
        console.print(str(path), markup=False, highlight=False)
        console.print(renderable.Image(path, width=min(WIDTH, console.width)))
