"""``glsim export``: a picture that a browser can turn, light and shade anew, as one offline page."""

from __future__ import annotations

import argparse
import json
import sys
from typing import Any

from glsim.cli.options import count, lobe, number, positive, shading, size
from glsim.files import check_folder

EPILOG = """
examples:
  glsim export teapot -o teapot.html
  glsim export program.py -o program.html --frames 24
  glsim export sphere -o lobes.html --modes phong --controls lobe,materials
  glsim export cornell -o cornell.html --patches 1000
"""


def add(commands: Any) -> None:
    text = "write a page with a picture that can be turned, lit and shaded anew in the browser"
    p = commands.add_parser(
        "export", help=text, description=text[0].upper() + text[1:] + ".", epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )  # fmt: skip
    p.add_argument("what", metavar="SCRIPT|SCENE|MESH", help="a program (.py), a built-in scene, a mesh file, or a"
                   " scene of glsim radiosity --list")  # fmt: skip
    p.add_argument("-o", "--output", metavar="FILE.html", default="live.html", help="the page (default: live.html)")
    p.add_argument("--modes", metavar="A,B,...", help="of flat, gouraud, phong (default: all)")
    p.add_argument("--lobe", metavar="A,B", help="of blinn, phong (default: both)")
    p.add_argument("--controls", metavar="A,B,...",
                   help="of mode, lobe, edges, lights, materials, ambient (default: all)")  # fmt: skip
    p.add_argument("--frames", type=count, default=1, metavar="N", help="pictures of a program (default: 1)")
    p.add_argument("--size", type=size, metavar="N", help="pixels of the picture (default: 512, or as a program asks)")
    p.add_argument("--samples", type=number, default=4, metavar="N", help="multisampling, 0 for none (default: 4)")
    p.add_argument("--patches", type=count, default=2000, metavar="N", help="of radiosity (default: %(default)s)")
    p.add_argument("--view", type=number, default=0, metavar="N", help="which camera of a radiosity scene (default: 0)")
    p.add_argument("--title", metavar="TEXT", help="of the page")
    p.add_argument("--timeout", type=positive, default=60.0, metavar="SECONDS", help="for a program (default: 60)")
    p.add_argument("--json", action="store_true", help="print one JSON object")
    p.set_defaults(run=_export)


def _export(options: argparse.Namespace) -> int:
    from rich.console import Console

    from glsim.study.export import export
    from glsim.study.live import CONTROLS

    check_folder(options.output)
    with Console(stderr=True).status("") as status:
        made = export(
            options.what, options.output, modes=_names(options.modes, shading), lobes=_names(options.lobe, lobe),
            controls=_names(options.controls, str) or CONTROLS, frames=options.frames, size=options.size,
            samples=options.samples, patches=options.patches, view=options.view, title=options.title,
            timeout=options.timeout, progress=status.update,
        )  # fmt: skip
    found = {
        "output": options.output,
        "title": made.title,
        "modes": made.modes,
        "lobes": made.lobes,
        "frames": made.frames,
    }
    if options.json:
        outcome = {"status": "error", "error": made.error} if made.error else {"status": "ok"}
        print(json.dumps({**outcome, **found}))
    else:
        print(f"wrote {options.output}: open it in a browser; it needs no network")
        if made.error:
            print(f"glsim: {options.what} ended early: {made.error}", file=sys.stderr)
    return 1 if made.error else 0


def _names(text: str | None, check: Any) -> list[str] | None:
    """A list in an option.  Raises ValueError for an unknown name."""
    if text is None:
        return None
    try:
        return [check(name.strip()) for name in text.split(",")]
    except argparse.ArgumentTypeError as error:
        raise ValueError(str(error)) from None
