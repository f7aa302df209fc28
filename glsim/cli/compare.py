"""``glsim compare``."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from glsim.cli.options import camera, check_picture_name, console, count, light, number, positive, size
from glsim.files import check_folder

if TYPE_CHECKING:
    from glsim.study.comparison import Comparison

EPILOG = """
lights (--light, and the values of --sweep light=...):
  X,Y,Z[,W[,BRIGHTNESS]][:NAME=VALUE...]    in eye space; W = 0 (default) for a direction, 1 for a place
    :cutoff=20          a spot: half the angle of its cone, in degrees
    :exponent=8         how much a spot fades towards its edge, 0 to 128
    :direction=0,-1,0   the axis of a spot (default: through the middle of the scene)
    :attenuation=0.2    k_2, or k_0,k_1,k_2: light at distance d is divided by k_0 + k_1 d + k_2 d^2
    :brightness=0.8     of I_d and I_s
  as in --light 0,2,3:cutoff=15:exponent=20 --light 4,1,3,0,0.3

axes (--sweep NAME=VALUES, the rows; with a second one the first is the columns):
  segments=8,16,32         how finely a built-in scene is cut
  shininess=1,4,16,64      n of all materials
  material=brass,jade      a named material (see --list)
  light=-3,4,5/0,4,5       the first light, each written as for --light
  brightness=0.5,1         I_d and I_s of the first light
  attenuation=0/0.1/1,1,0  of the first light, which must be at a place: k_2, or k_0,k_1,k_2
  cutoff=10,20,40          of the first light's cone; exponent=0,8,64 how much it fades
  ambient=0,0.3,1          I_a of the scene
  camera=0,20/45,20        AZIMUTH,ELEVATION[,DISTANCE]

examples:
  glsim compare teapot --segments 8,16,32 --html teapot.html
  glsim compare sphere --sweep shininess=1,4,16,64 --modes gouraud,phong
  glsim compare sphere --sweep shininess=4,16,64 --sweep light=-3,4,5/0,4,5/3,4,5 --modes phong
  glsim compare program.py --modes flat,gouraud,native --reference native
  glsim compare torus --modes phong:clamp,phong:flip,phong:two-sided --gif turn.gif
  glsim compare expected.png actual.png
"""


def add(commands: Any) -> None:
    text = "draw a scene flat, Gouraud and Phong shaded, with either specular lobe, side by side; or compare pictures"
    p = commands.add_parser(
        "compare", help=text, description=text[0].upper() + text[1:] + ".", epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )  # fmt: skip
    p.add_argument(
        "what", nargs="*", metavar="SCENE|PICTURE",
        help="a built-in scene (see --list), a mesh file (OBJ, PLY, STL, GLB, OFF, ...) or a program (.py);"
        " for radiosity also a scene of glsim radiosity --list; and pictures (PNG, ...), which become columns",
    )  # fmt: skip
    _add_axes(p)
    _add_scene(p)
    _add_output(p)
    p.set_defaults(run=_compare)


def _add_axes(p: argparse.ArgumentParser) -> None:
    p.add_argument("--modes", metavar="A,B,...",
                   help="columns: wireframe, hidden-line, unlit, flat, gouraud, phong, native, pyrender, direct,"
                   " radiosity (default: flat,gouraud,phong); flat, gouraud, phong and native with any of :blinn or"
                   " :phong and :clamp, :flip or :two-sided, as in phong:blinn:flip")  # fmt: skip
    p.add_argument("--lobe", metavar="A,B",
                   help="rows: blinn (N.H)^n, phong (R.V)^n (default: both; blinn beside native and"
                   " pyrender, which have one)")  # fmt: skip
    p.add_argument("--segments", metavar="N,N,...", help="rows: how finely a built-in scene is cut, as in 8,16,32")
    p.add_argument("--sweep", metavar="NAME=VALUES", action="append", default=[],
                   help="rows: what else changes, see below")  # fmt: skip
    p.add_argument("--columns", metavar="AXIS", help="the axis that is the columns (mode, lobe or a swept name)")
    p.add_argument(
        "--reference", metavar="MODE",
        help="the column that differences are taken from (default: the one that the others approximate:"
        " radiosity, direct, phong, native, gouraud, flat; of pictures and swept values the first)",
    )  # fmt: skip


def _add_scene(p: argparse.ArgumentParser) -> None:
    p.add_argument("--light", action="append", type=light, metavar="LIGHT",
                   help="a light instead of the scene's own, see below; may be repeated")  # fmt: skip
    p.add_argument("--material", metavar="NAME", help="a named material such as brass (see --list)")
    p.add_argument("--camera", type=camera, metavar="AZIMUTH,ELEVATION[,DISTANCE]",
                   help="degrees around and above the scene, and the distance in radii")  # fmt: skip
    p.add_argument("--size", type=size, metavar="N",
                   help="pixels of each picture (default: 512, or as a program asks)")  # fmt: skip
    p.add_argument("--samples", type=number, metavar="N",
                   help="multisampling, 0 for none (default: 4; 0 beside native or pictures)")  # fmt: skip
    p.add_argument("--patches", type=count, default=1000, metavar="N", help="of radiosity (default: %(default)s)")
    p.add_argument("--view", type=number, default=0, metavar="N", help="which camera of a radiosity scene (default: 0)")
    p.add_argument("--timeout", type=positive, default=60.0, metavar="SECONDS", help="for a program (default: 60)")


def _add_output(p: argparse.ArgumentParser) -> None:
    p.add_argument(
        "-o", "--output", metavar="FILE", help="the sheet (default: compare.png, or none beside the next two)"
    )
    p.add_argument("--html", metavar="FILE", help="a page: swap pictures in place, zoom, read pixels and equations")
    p.add_argument("--gif", metavar="FILE", help="an animation, see --animate")
    p.add_argument("--animate", metavar="turntable|light|NAME=VALUES",
                   help="what moves in it (default: turntable)")  # fmt: skip
    p.add_argument("--frames", type=count, default=36, metavar="N", help="pictures of the animation (default: 36)")
    p.add_argument("--layout", choices=("screen", "projector", "paper"), default="screen",
                   help="the sheet as large as its pictures, 16:9 or A4 (default: screen)")  # fmt: skip
    p.add_argument("--differences", default="auto", metavar="xN|off",
                   help="amplified N times (default: as often as the largest needs to become white)")  # fmt: skip
    p.add_argument("--title", metavar="TEXT", help="of the sheet")
    p.add_argument("--caption", metavar="NAME=TEXT", action="append", default=[],
                   help="words for a column or row, as in gouraud='as in 1971'; may be repeated")  # fmt: skip
    p.add_argument("--list", action="store_true", help="list the built-in scenes and materials")
    p.add_argument("--json", action="store_true", help="print the metrics as one JSON object")


def _compare(options: argparse.Namespace) -> int:
    if options.list:
        return _list(options)
    if not options.what:
        print("glsim compare: name a scene or a mesh file, a program or pictures; --list shows the built-in scenes",
              file=sys.stderr)  # fmt: skip
        return 2
    from rich.console import Console

    from glsim.study.compare import compare

    outputs = _outputs(options)
    what, pictures = _subjects(options.what)
    with Console(stderr=True).status("") as status:
        result = compare(
            what, pictures=pictures, modes=options.modes, lobes=options.lobe, segments=options.segments,
            sweep=_pairs("--sweep", options.sweep), columns=options.columns, reference=options.reference,
            differences=options.differences, layout=options.layout, title=options.title,
            captions=_pairs("--caption", options.caption), size=options.size, samples=options.samples,
            lights=options.light, material=options.material, camera=options.camera,
            animate=(options.animate or "turntable") if options.gif else None, frames=options.frames,
            patches=options.patches, view=options.view, timeout=options.timeout, progress=status.update,
        )  # fmt: skip
        for name in outputs:
            status.update(f"writing {name}")
            result.save(name, status.update)
    return _told(result, outputs, options.json)


def _outputs(options: argparse.Namespace) -> list[str]:
    """The files to write, in order.  Raises ValueError, before any work, for names that cannot be."""
    if options.animate and not options.gif:
        raise ValueError("--animate needs --gif FILE")
    for kind in ("html", "gif"):
        name = getattr(options, kind)
        if name and Path(name).suffix.lower() != f".{kind}":
            raise ValueError(f"--{kind} {name}: the name must end in .{kind}")
    sheet = options.output or (None if options.html or options.gif else "compare.png")
    if sheet:
        check_picture_name(sheet)
    outputs = [name for name in (sheet, options.gif, options.html) if name]
    for name in outputs:
        check_folder(name)
    if len(set(outputs)) < len(outputs):
        raise ValueError(f"{outputs[0]}: two outputs have this name")
    return outputs


def _subjects(words: list[str]) -> tuple[str | None, list[str]]:
    """The scene or program, if there is one, and the pictures."""
    from glsim.study.given import is_picture

    scenes, pictures = ([word for word in words if is_picture(word) is kind] for kind in (False, True))
    if len(scenes) > 1:
        raise ValueError(f"compare: one scene or program at a time, not {' and '.join(scenes)}")
    return (scenes[0] if scenes else None), pictures


def _pairs(option: str, words: list[str]) -> dict[str, str]:
    """NAME=VALUE words as a dictionary."""
    pairs: dict[str, str] = {}
    for word in words:
        name, equals, value = word.partition("=")
        if not equals or name in pairs:
            raise ValueError(f"{option} {word}: " + ("it is given twice" if equals else "NAME=... is needed"))
        pairs[name] = value
    return pairs


def _told(result: Comparison, outputs: list[str], as_json: bool) -> int:
    """Print the metrics; the exit code is 1 if a program ended early."""
    if as_json:
        outcome = {"status": "error", "error": result.note} if result.note else {"status": "ok"}
        print(json.dumps({**outcome, "scene": result.title, "output": outputs[0], "outputs": outputs,
                          "differences": result.statistics(), "metrics": result.metrics,
                          "notes": result.notes}))  # fmt: skip
        return 1 if result.note else 0
    from rich.table import Table
    from rich.text import Text

    rows = result.metrics
    several = {row["reference"] for row in rows} != {result.reference}  # in a row that has no picture of the reference
    table = Table(title=Text(f"{result.title}: difference from {result.reference}, in 1/255"))
    shown = [name for name in rows[0] if name != "reference" or several]
    words = (result.rows.name, result.columns.name, "reference")
    for heading in shown:
        table.add_column(heading, justify="left" if heading in words else "right")
    for row in rows:
        table.add_row(*(_shown(row[name]) for name in shown))
    console().print(table)
    print(f"wrote {', '.join(outputs)}")
    for note in result.notes:
        print(f"glsim compare: {note}", file=sys.stderr)
    return 1 if result.note else 0


def _shown(value: object) -> str:
    return "" if value is None else f"{value:.4g}" if isinstance(value, float) else str(value)


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
