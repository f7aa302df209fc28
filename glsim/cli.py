"""The command ``glsim``: parses, calls, prints.

Exit codes: 0 done; 1 it could not be done (the reason is printed); 2 the command line is wrong; 130 interrupted.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from glsim.machine.errors import GLError

if TYPE_CHECKING:
    from glsim.machine.frame import Frame
    from glsim.scenes import Camera, Lamp


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command; returns its exit code."""
    words = _with_negative_numbers(sys.argv[1:] if arguments is None else arguments)
    split = words.index("--") if "--" in words else len(words)  # what follows is for the program that is run
    options = _parser().parse_args(words[:split])
    options.arguments = words[split + 1 :]
    try:
        return int(options.run(options))
    except KeyboardInterrupt:
        print("glsim: interrupted", file=sys.stderr)
        return 130
    except BrokenPipeError:  # as in: glsim explain ... | head
        sys.stdout = open(os.devnull, "w")  # noqa: SIM115
        return 0
    except (ValueError, OSError, RuntimeError, GLError) as error:
        if options.json:
            print(json.dumps({"status": "error", "error": str(error)}))
        else:
            print(f"glsim: {error}", file=sys.stderr)
        return 1


def _with_negative_numbers(words: Sequence[str]) -> list[str]:
    """ "--light", "-2,3,4" -> "--light=-2,3,4": argparse would take -2,3,4 for an option."""
    joined: list[str] = []
    for word in words:
        if joined and joined[-1] in ("--light", "--camera") and re.match(r"-\.?\d", word):
            joined[-1] += "=" + word
        else:
            joined.append(word)
    return joined


def _parser() -> argparse.ArgumentParser:
    from glsim import __version__

    parser = argparse.ArgumentParser(
        prog="glsim", description="OpenGL's fixed-function pipeline, to teach and to learn."
    )
    parser.add_argument("--version", action="version", version=f"glsim {__version__}")
    commands = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")
    _add_compare(commands)
    _add_run(commands)
    _add_probe(commands)
    _add_terms(commands)
    _add_explain(commands)
    _add_trace(commands)
    _add_radiosity(commands)
    doctor = commands.add_parser("doctor", help="say what this machine can draw with, and what to install")
    doctor.add_argument("--json", action="store_true", help="print one JSON object")
    doctor.set_defaults(run=_doctor)
    return parser


# ---------------------------------------------------------------- compare


def _add_compare(commands: Any) -> None:
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
    p.add_argument("--size", type=_size, default=512, metavar="N", help="pixels of each picture (default: %(default)s)")
    p.add_argument("--light", action="append", type=_light, metavar="X,Y,Z[,W[,BRIGHTNESS]]",
                   help="a light in eye space, W = 0 (default) for a direction; may be repeated")  # fmt: skip
    p.add_argument("--material", metavar="NAME", help="a named material such as brass (see --list)")
    p.add_argument("--camera", type=_camera, metavar="AZIMUTH,ELEVATION[,DISTANCE]",
                   help="degrees around and above the scene, and the distance in radii")  # fmt: skip
    p.add_argument("--patches", type=_count, default=2000, metavar="N", help="of radiosity (default: %(default)s)")
    p.add_argument(
        "--view", type=_number, default=0, metavar="N", help="which camera of a radiosity scene (default: 0)"
    )
    p.add_argument("--list", action="store_true", help="list the built-in scenes and materials")
    p.add_argument("--json", action="store_true", help="print the differences as one JSON object")
    p.set_defaults(run=_compare)


def _numbers(text: str, least: int, most: int) -> list[float]:
    try:
        values = [float(word) for word in text.split(",")]
    except ValueError:
        raise argparse.ArgumentTypeError(f"numbers separated by commas are needed, not {text!r}") from None
    if not least <= len(values) <= most or not all(-1e6 < value < 1e6 for value in values):
        raise argparse.ArgumentTypeError(f"{least} to {most} numbers are needed, not {text!r}")
    return values


def _size(text: str) -> int:
    if not text.isdigit() or not 16 <= int(text) <= 4096:
        raise argparse.ArgumentTypeError(f"a number of pixels from 16 to 4096 is needed, not {text!r}")
    return int(text)


def _light(text: str) -> Lamp:
    from glsim.scenes import Lamp

    x, y, z, *rest = _numbers(text, 3, 5)
    w, brightness = [*rest, 0.0, 1.0][:2] if len(rest) != 1 else (rest[0], 1.0)
    return Lamp((x, y, z, w), brightness)


def _camera(text: str) -> Camera:
    from glsim.scenes import Camera

    values = _numbers(text, 2, 3)
    if len(values) == 3 and values[2] <= 1.0:
        raise argparse.ArgumentTypeError(f"the distance must be more than 1 radius of the scene, not {values[2]:g}")
    return Camera(*values)


def _compare(options: argparse.Namespace) -> int:
    if options.list:
        return _list(options)
    if not options.scene:
        print("glsim compare: name a scene or a mesh file; --list shows the built-in scenes", file=sys.stderr)
        return 2
    from rich.console import Console

    from glsim.study.compare import compare

    _check_picture_name(options.output)

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


def _check_picture_name(name: str) -> None:
    """Before the work begins."""
    from PIL import Image

    if Path(name).suffix.lower() not in Image.registered_extensions():
        raise ValueError(f"{name}: the name must end in .png, .jpg or another picture format")


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


# ---------------------------------------------------------------- run


def _add_run(commands: Any) -> None:
    text = "run an unmodified PyOpenGL/GLUT program, headless or in a window"
    usage = "glsim run SCRIPT [options] [-- ARGS]"
    p = commands.add_parser("run", help=text, description=text[0].upper() + text[1:] + ".", usage=usage)
    p.add_argument("script", metavar="SCRIPT", help="a Python program that imports OpenGL")
    p.add_argument("--out", metavar="DIR", help="where frame_000.png and so on go (default: frames)")
    p.add_argument("--frames", type=_count, default=1, metavar="N", help="steps of the main loop (default: 1)")
    p.add_argument("--events", default="", metavar='"key a;mouse 0 0 10 20;..."',
                   help="one event for each step from the second on: key C, special N, mouse BUTTON STATE X Y, "
                   "motion X Y, passive X Y, menu VALUE, reshape W H, tick")  # fmt: skip
    p.add_argument("--keys", default="", metavar="abc", help="short for --events with a key for each letter")
    p.add_argument("--size", type=_rectangle, metavar="WxH", help="size of every window, whatever the program asks")
    p.add_argument("--shade", choices=("flat", "smooth", "phong"), help="shade everything like this")
    p.add_argument("--lobe", choices=("blinn", "phong"), help="the specular lobe: (N.H)^n or (R.V)^n")
    p.add_argument("--window", action="store_true", help="show real windows (needs the package glfw)")
    p.add_argument("--real-time", action="store_true", help="let the clock run, instead of 20 ms a step")
    p.add_argument("--timeout", type=float, default=None, metavar="SECONDS",
                   help="stop the program after this time (default: 60; with --window never)")  # fmt: skip
    p.add_argument("--gif", metavar="FILE", help="an animation of all steps")
    p.add_argument("--mp4", metavar="FILE", help="an animation of all steps (needs the package imageio-ffmpeg)")
    p.add_argument("--no-python2", action="store_true", help="do not convert programs of Python 2")
    p.add_argument("--json", action="store_true", help="print one line of JSON: status, frames, calls")
    p.set_defaults(run=_run)


def _count(text: str) -> int:
    if not text.isdigit() or not 1 <= int(text) <= 1_000_000:
        raise argparse.ArgumentTypeError(f"a number from 1 on is needed, not {text!r}")
    return int(text)


def _rectangle(text: str) -> tuple[int, int]:
    found = re.fullmatch(r"(\d+)x(\d+)", text)
    if not found or not all(1 <= int(n) <= 16384 for n in found.groups()):
        raise argparse.ArgumentTypeError(f"a size such as 640x480 is needed, not {text!r}")
    return int(found[1]), int(found[2])


def _run(options: argparse.Namespace) -> int:
    from glsim.study.play import Plan
    from glsim.study.run import animate, events_from, run

    out = options.out or (None if options.window else "frames")
    plan = Plan(
        options.script, options.arguments, out, options.frames, events_from(options.keys, options.events),
        options.size, options.shade, options.lobe, options.window, options.real_time or options.window, options.json,
        not options.no_python2,
    )  # fmt: skip
    timeout = options.timeout or (None if options.window else 60.0)
    record = run(plan, timeout)
    for target in filter(None, (options.gif, options.mp4)):
        first = [Path(out or ".") / name for name in record["pictures"] if "_w" not in name]
        animate(first, Path(target))
    if options.json:
        print(json.dumps(record))
    else:
        for note in record["notes"]:
            print(f"glsim run: {note}", file=sys.stderr)
        where = f", pictures in {out}" if record["pictures"] else ""
        print(f"{options.script}: {record['status']}, {record['frames']} frames{where}")
    return 0 if record["status"] == "ok" else 1


# ---------------------------------------------------------------- probe, terms, explain, trace

SUBJECT = "a GLUT program (.py), a built-in scene or a mesh file"


def _add_study(commands: Any, name: str, text: str) -> argparse.ArgumentParser:
    """A command that looks at the Frame of a program or scene."""
    p: argparse.ArgumentParser = commands.add_parser(name, help=text, description=text[0].upper() + text[1:] + ".")
    p.add_argument("what", metavar="SCRIPT|SCENE", help=SUBJECT)
    p.add_argument("--frame", type=_number, default=None, metavar="N",
                   help="which picture of a program (default: 0, or the one after all events)")  # fmt: skip
    p.add_argument("--events", default=None, metavar='"key a;..."', help="events of a program, as for glsim run")
    p.add_argument("--size", type=_size, default=None, metavar="N",
                   help="pixels of the picture (default: 512, or as a program asks)")  # fmt: skip
    p.add_argument("--timeout", type=float, default=None, metavar="SECONDS", help="for a program (default: 60)")
    p.add_argument("--json", action="store_true", help="print one JSON object")
    return p


def _number(text: str) -> int:
    if not text.isdigit() or int(text) > 1_000_000:
        raise argparse.ArgumentTypeError(f"a number from 0 on is needed, not {text!r}")
    return int(text)


def _frame_of(options: argparse.Namespace, calls: bool) -> Frame:
    from glsim.study.frames import frame_of
    from glsim.study.run import events_from

    given = [name for name in ("frame", "events", "timeout") if getattr(options, name) is not None]
    if given and not options.what.endswith(".py"):
        raise ValueError(f"--{given[0]} is for programs, and {options.what} is none")
    events = events_from("", options.events or "")
    step = len(events) if options.frame is None else options.frame
    timeout = 60.0 if options.timeout is None else options.timeout
    return frame_of(options.what, size=options.size, calls=calls, step=step, events=events, timeout=timeout)


def _tell(frame: Frame, options: argparse.Namespace, found: dict[str, Any]) -> int:
    """Print JSON if it was asked for, and say if the program ended with an error: then the exit code is 1."""
    if options.json:
        outcome = {"status": "error", "error": frame.error} if frame.error else {"status": "ok"}
        print(json.dumps({**outcome, **found}))
    elif frame.error:
        where = f" (line {frame.error_at.line})" if frame.error_at is not None else ""
        print(f"glsim: {options.what} ended early{where}: {frame.error}", file=sys.stderr)
    return 1 if frame.error else 0


def _console() -> Any:
    from rich.console import Console

    console = Console()
    return console if console.is_terminal else Console(width=160)


def _add_probe(commands: Any) -> None:
    p = _add_study(commands, "probe", "say why a pixel has its colour: every factor of every term")
    p.add_argument("x", type=_number, metavar="X", help="pixels from the left")
    p.add_argument("y", type=_number, metavar="Y", help="pixels from the top")
    p.add_argument("--latex", action="store_true", help="print the equation as LaTeX")
    p.set_defaults(run=_probe)


def _probe(options: argparse.Namespace) -> int:
    from glsim.study.probe import probe

    frame = _frame_of(options, calls=True)
    result = probe(frame, options.x, options.y)
    if options.latex and not options.json:
        print(result.latex())
    elif not options.json:
        _console().print(result)
    return _tell(frame, options, result.as_dict())


def _add_terms(commands: Any) -> None:
    p = _add_study(commands, "terms", "take the picture apart: the terms of each light, and their factors")
    p.add_argument("-o", "--output", metavar="FILE", default="terms.png", help="the sheet (default: terms.png)")
    p.set_defaults(run=_terms)


def _terms(options: argparse.Namespace) -> int:
    from glsim.study.terms import terms

    _check_picture_name(options.output)
    frame = _frame_of(options, calls=False)
    result = terms(frame)
    result.save(options.output)
    found = result.statistics()
    if not options.json:
        print(f"wrote {options.output}: {found['lit']} lit pixels, {found['clamped']} of them clamped")
    return _tell(frame, options, {"output": options.output, **found})


def _add_explain(commands: Any) -> None:
    p = _add_study(commands, "explain", "say which call set each constant and uniform of a draw")
    p.add_argument("--draw", type=_number, default=None, metavar="N", help="only this draw (default: all)")
    p.add_argument("--glsl", action="store_true", help="print the GLSL without the branches that are not taken")
    p.set_defaults(run=_explain)


def _explain(options: argparse.Namespace) -> int:
    from glsim.study.explain import explain

    frame = _frame_of(options, calls=True)
    found = explain(frame, options.draw)
    listed: list[Any] = []
    if options.json:
        listed = [{**entry.as_dict(), **({"glsl": entry.glsl} if options.glsl else {})} for entry in found]
    elif not found:
        print("Nothing is drawn: there is no glBegin, glDrawArrays, ... in this picture.")
    elif options.glsl:
        for program in dict.fromkeys(entry.program for entry in found):
            same = [entry for entry in found if entry.program == program]
            for stage, text in same[0].glsl.items():
                print(f"// ---- {stage} shader of draw {', '.join(str(entry.draw) for entry in same)}\n{text}")
    else:
        from glsim.study.report import explanations

        for table in explanations(found):
            _console().print(table)
    return _tell(frame, options, {"draws": listed})


def _add_trace(commands: Any) -> None:
    p = _add_study(commands, "trace", "print the calls with what each changed, and classic mistakes")
    p.add_argument("--mistakes", action="store_true", help="print the mistakes only; exit code 1 if there are any")
    p.set_defaults(run=_trace)


def _trace(options: argparse.Namespace) -> int:
    from glsim.study.report import calls_table, mistakes_list
    from glsim.study.trace import trace

    frame = _frame_of(options, calls=True)
    found = trace(frame)
    if not options.json:
        console = _console()
        if not options.mistakes:
            console.print(calls_table(found))
        console.print(mistakes_list(found))
    code = _tell(frame, options, found.as_dict())
    return 1 if options.mistakes and found.mistakes else code


# ---------------------------------------------------------------- radiosity


def _add_radiosity(commands: Any) -> None:
    text = "solve a scene's radiosity and bake it into vertex colours"
    p = commands.add_parser("radiosity", help=text, description=text[0].upper() + text[1:] + ".")
    p.add_argument(
        "what", nargs="?", metavar="SCENE|FILE|SCRIPT", help="a scene (--list), a mesh file or a program (.py)"
    )
    p.add_argument("-o", "--output", action="append", metavar="FILE",
                   help=".png, .glb, .ply or .npz; may be repeated (default: radiosity.png)")  # fmt: skip
    p.add_argument("--patches", type=_count, default=2000, metavar="N", help="about how many (default: %(default)s)")
    p.add_argument("--method", default="contour", metavar="NAME",
                   help="contour, analytic, point, disc, monte-carlo, hemicube or hierarchical")  # fmt: skip
    p.add_argument(
        "--solver", help="gauss-seidel, jacobi, sor, cg, shooting, lu (hierarchical, --scheduler: cg, jacobi)"
    )
    p.add_argument("--adaptive", action="store_true", help="smaller patches where the light changes fast")
    p.add_argument("--accuracy", type=_positive, default=5e-5, metavar="A",
                   help="of a link, in mean radiosities, for hierarchical (default: %(default)s)")  # fmt: skip
    p.add_argument("--vertices", default="gather", help="gather (at each vertex) or average (of the patches around)")
    p.add_argument("--tolerance", type=float, default=1e-6, help="of the residual (default: %(default)s)")
    p.add_argument("--size", type=_size, default=512, metavar="N", help="pixels of a picture (default: %(default)s)")
    p.add_argument("--view", type=_number, default=0, metavar="N", help="which camera of the scene (default: 0)")
    p.add_argument("--direct", metavar="FILE", help="a picture of direct illumination and radiosity side by side")
    p.add_argument(
        "--white", type=_positive, metavar="B", help="the radiosity that becomes white (default: by the scene)"
    )
    p.add_argument("--tone", choices=("linear", "reinhard"), default="linear", help="tone mapping (default: linear)")
    p.add_argument("--gamma", type=_positive, default=2.2, help="of the screen (default: 2.2)")
    p.add_argument("--flip", action="store_true", help="turn all fronts to the other side")
    p.add_argument("--close", action="store_true", help="scale form factors so that rows sum to 1: closed scenes")
    p.add_argument("--report", metavar="FILE", help="write the report as JSON")
    p.add_argument("--resume", metavar="FILE", help="where finished rows are kept when interrupted, and taken from")
    p.add_argument("--scheduler", metavar="ADDRESS",
                   help="use the workers of a Dask scheduler; --resume then takes a name, not a file")  # fmt: skip
    p.add_argument("--list", action="store_true", help="list the built-in scenes")
    p.add_argument("--json", action="store_true", help="print the report as one JSON object")
    p.set_defaults(run=_radiosity)


def _positive(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0.0 < value < 1e12:
        raise argparse.ArgumentTypeError(f"a number above 0 is needed, not {text!r}")
    return value


def _radiosity(options: argparse.Namespace) -> int:
    from glsim.radiosity.scenes import BUILT_IN

    if options.list:
        about = {name: entry.about for name, entry in BUILT_IN.items()}
        lines = [f"  {name:16} {words}" for name, words in about.items()]
        print(json.dumps({"scenes": about}) if options.json else "Scenes:\n" + "\n".join(lines))
        return 0
    if not options.what:
        print(
            "glsim radiosity: name a scene, a mesh file or a program; --list shows the built-in scenes", file=sys.stderr
        )
        return 2
    from glsim.files import write_atomically, write_text
    from glsim.radiosity.solution import solve

    outputs = options.output or ["radiosity.png"]
    for name in (*outputs, *([options.direct] if options.direct else [])):
        if Path(name).suffix.lower() not in (".glb", ".ply", ".npz") or name == options.direct:
            _check_picture_name(name)
    with _bars() as bars:
        stages: dict[str, Any] = {}

        def progress(stage: str, done: int, of: int) -> None:
            if stage not in stages:
                stages[stage] = bars.add_task(stage, total=of)
            bars.update(stages[stage], completed=done, total=of)

        task = bars.add_task("solving", total=None)
        result = solve(
            options.what, options.patches, method=options.method, solver=options.solver, tolerance=options.tolerance,
            vertices=options.vertices, adaptive=options.adaptive, accuracy=options.accuracy, flip=options.flip,
            close=options.close, checkpoint=options.resume, scheduler=options.scheduler,
            progress=progress,
            on_step=lambda step: bars.update(task, description=f"iteration {step.iteration}, {step.residual:.1e}"),
        )  # fmt: skip
    result = replace(result, white=options.white, tone=options.tone, gamma=options.gamma)
    for name in outputs:
        result.save(name, size=options.size, view=options.view)
    if options.direct:
        sheet = result.beside_direct(options.size, options.view)
        write_atomically(options.direct, lambda name: sheet.save(name))
        outputs = [*outputs, options.direct]
    report = {**result.report(), "outputs": outputs}
    if options.report:
        write_text(Path(options.report), json.dumps(report, indent=1) + "\n")
    if options.json:
        print(json.dumps({"status": "ok", **report}))
    else:
        _print_radiosity(report)
    return 0


def _bars() -> Any:
    from rich.console import Console
    from rich.progress import Progress

    return Progress(console=Console(stderr=True), transient=True)


def _print_radiosity(report: dict[str, Any]) -> None:
    from rich.table import Table

    table = Table(show_header=False, title=report["scene"], title_justify="left")
    mean, most, leak = (100.0 * report[name] for name in ("row_sum_error_mean", "row_sum_error_max", "leak"))
    sums = f"rows sum to 1 within {mean:.4f} % in the mean, {most:.2f} % at most; {leak:.3f} % escapes"
    solved = f"{report['iterations']} iterations, residual {report['residual']:.2g}"
    rows = [
        ("patches", f"{report['n']}, drawn as {report['triangles']} triangles"),
        ("form factors", f"{report['method']}; {sums}"),
        ("system", f"{report['solver']}, {solved}, energy balance {report['energy_balance']:.6f}"),
        ("seconds", ", ".join(f"{stage} {value:.2f}" for stage, value in report["seconds"].items())),
        *(("note", note) for note in report["notes"]),
        ("wrote", ", ".join(report["outputs"])),
    ]
    for row in rows:
        table.add_row(*row)
    _console().print(table)


# ---------------------------------------------------------------- doctor


def _doctor(options: argparse.Namespace) -> int:
    from glsim.render.diagnose import diagnose

    found = diagnose()
    if options.json:
        print(json.dumps(found))
    else:
        _print_diagnosis(found)
    return 0 if found["works"] else 1


def _print_diagnosis(found: dict[str, Any]) -> None:
    from rich.console import Console
    from rich.table import Table

    console = Console()
    console.print(f"glsim {found['glsim']}, Python {found['python']}, {found['platform']}", highlight=False)
    console.print(", ".join(f"{name} {version}" for name, version in found["packages"].items()), highlight=False)
    table = Table("backend", "works", "what it is, or what it said", "what to do")
    for entry in found["backends"]:
        if entry["works"]:
            table.add_row(entry["backend"], "yes", f"{entry['renderer']}\n{entry['version']}", "")
        else:
            table.add_row(entry["backend"], "no", entry["said"], entry["fix"])
    console.print(table)
    for device in found["devices"]:
        console.print(f"EGL device {device['index']}: {device['renderer']}", highlight=False)
    native = found["native fixed function"]
    words = f"{native['renderer']} ({native['version']}) by {native['backend']}" if native["works"] else native["said"]
    console.print(f"native fixed function: {words}", highlight=False)
    verdict = "glsim can draw here." if found["works"] else "glsim cannot draw here: install what the table says."
    console.print(verdict)


if __name__ == "__main__":
    sys.exit(main())
