"""``glsim compare``."""

from __future__ import annotations

import argparse
import json
import sys
from typing import Any

from glsim.cli.options import camera, check_picture_name, count, light, number, size


def add(commands: Any) -> None:
    text = "draw a scene flat, Gouraud and Phong shaded, with either specular lobe, side by side"
    p = commands.add_parser("compare", help=text, description=text[0].upper() + text[1:] + ".")
    p.add_argument(
        "scene",
        nargs="?",
        help="a built-in scene (see --list), a mesh file (OBJ, PLY, STL, GLB, OFF, ...) or a GLUT program (.py);"
        " for radiosity also a scene of glsim radiosity --list",
    )
    p.add_argument("-o", "--output", metavar="FILE", help="the sheet (default: compare.png)", default="compare.png")
    p.add_argument("--modes", default="flat,gouraud,phong", metavar="A,B,...",
                   help="columns: flat, gouraud, phong, wireframe, unlit, native, direct, radiosity"
                   " (default: %(default)s)")  # fmt: skip
    p.add_argument("--lobe", default="blinn,phong", metavar="A,B",
                   help="rows: blinn (N.H)^n, phong (R.V)^n (default: %(default)s)")  # fmt: skip
    p.add_argument("--size", type=size, default=512, metavar="N", help="pixels of each picture (default: %(default)s)")
    p.add_argument("--light", action="append", type=light, metavar="X,Y,Z[,W[,BRIGHTNESS]]",
                   help="a light in eye space, W = 0 (default) for a direction; may be repeated")  # fmt: skip
    p.add_argument("--material", metavar="NAME", help="a named material such as brass (see --list)")
    p.add_argument("--camera", type=camera, metavar="AZIMUTH,ELEVATION[,DISTANCE]",
                   help="degrees around and above the scene, and the distance in radii")  # fmt: skip
    p.add_argument("--patches", type=count, default=2000, metavar="N", help="of radiosity (default: %(default)s)")
    p.add_argument("--view", type=number, default=0, metavar="N", help="which camera of a radiosity scene (default: 0)")
    p.add_argument("--list", action="store_true", help="list the built-in scenes and materials")
    p.add_argument("--json", action="store_true", help="print the differences as one JSON object")
    p.set_defaults(run=_compare)


def _compare(options: argparse.Namespace) -> int:
    if options.list:
        return _list(options)
    if not options.scene:
        print("glsim compare: name a scene or a mesh file; --list shows the built-in scenes", file=sys.stderr)
        return 2
    from rich.console import Console

    from glsim.study.compare import compare

    check_picture_name(options.output)

    with Console(stderr=True).status("") as status:
        result = compare(
            options.scene,
            modes=options.modes.split(","),
            lobes=options.lobe.split(","),
            size=options.size,
            lights=options.light,
            material=options.material,
            camera=options.camera,
            patches=options.patches,
            view=options.view,
            progress=status.update,
        )
    result.save(options.output)
    rows = result.statistics()
    if options.json:
        print(json.dumps({"status": "ok", "scene": result.title, "output": options.output, "differences": rows}))
        return 0
    from rich.table import Table
    from rich.text import Text

    table = Table(title=Text(f"{result.title}: difference from {result.modes[0]}, in 1/255"))
    for heading in ("lobe", "mode", "max", "mean"):
        table.add_column(heading, justify="right" if heading in ("max", "mean") else "left")
    for row in rows:
        table.add_row(row["lobe"], row["mode"], str(row["max"]), f"{row['mean']:.2f}")
    console = Console()
    console.print(table)
    print(f"wrote {options.output}")
    return 0


def _list(options: argparse.Namespace) -> int:
    from glsim.scenes import BUILT_IN, MATERIALS

    if options.json:
        print(
            json.dumps(
                {"scenes": {name: entry.about for name, entry in BUILT_IN.items()}, "materials": list(MATERIALS)}
            )
        )
        return 0
    print("Scenes (NAME or NAME:SLICES):")
    for name, entry in BUILT_IN.items():
        print(f"  {name:12} {entry.about}")
    print("Materials:")
    print("  " + ", ".join(MATERIALS))
    return 0
