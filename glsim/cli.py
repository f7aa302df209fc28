"""The command ``glsim``: parses, calls, prints.

Exit codes: 0 done; 1 it could not be done (the reason is printed); 2 the command line is wrong; 130 interrupted.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import signal
import sys
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from glsim.machine.errors import GLError
from glsim.options import (
    Parser,
    camera,
    check_picture_name,
    console,
    count,
    light,
    lobe,
    number,
    positive,
    rectangle,
    shading,
    size,
)

if TYPE_CHECKING:
    from glsim.machine.frame import Frame


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command; returns its exit code."""
    words = _with_negative_numbers(sys.argv[1:] if arguments is None else arguments)
    split = words.index("--") if "--" in words else len(words)  # what follows is for the program that is run
    options = _parser().parse_args(words[:split])
    options.arguments = words[split + 1 :]
    with _ending_on_signals() as signals:
        code = _do(options)
    return 128 + signals[0] if signals else code


def _do(options: argparse.Namespace) -> int:
    try:
        return int(options.run(options))
    except KeyboardInterrupt:
        print("glsim: interrupted", file=sys.stderr)
        return 130
    except BrokenPipeError:  # as in: glsim explain ... | head
        sys.stdout = open(os.devnull, "w")  # noqa: SIM115
        return 0
    except (ValueError, OSError, RuntimeError, GLError) as error:
        if options.json is True:
            print(json.dumps({"status": "error", "error": str(error)}))
        else:
            print(f"glsim: {error}", file=sys.stderr)
        return 1


@contextmanager
def _ending_on_signals() -> Iterator[list[int]]:
    """SIGTERM and SIGHUP end a command as Ctrl-C does, so that nothing is lost or half-done and no process stays.

    Yields the list of those that came.
    """
    came: list[int] = []

    def interrupt(number: int, frame: object) -> None:
        came.append(number)
        raise KeyboardInterrupt

    numbers = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]
    if threading.current_thread() is not threading.main_thread():
        numbers = []
    before = {n: signal.signal(n, interrupt) for n in numbers if signal.getsignal(n) is signal.SIG_DFL}
    try:
        yield came
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


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
    from glsim.radiosity import command
    from glsim.version import __version__

    parser = Parser(prog="glsim", description="OpenGL's fixed-function pipeline, to teach and to learn.")
    parser.add_argument("--version", action="version", version=f"glsim {__version__}")
    commands = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")
    _add_compare(commands)
    _add_run(commands)
    _add_probe(commands)
    _add_terms(commands)
    _add_explain(commands)
    _add_trace(commands)
    command.add(commands)
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


# ---------------------------------------------------------------- run


def _add_run(commands: Any) -> None:
    text = "run an unmodified PyOpenGL/GLUT program, headless or in a window"
    usage = "glsim run SCRIPT [options] [-- ARGS]"
    p = commands.add_parser("run", help=text, description=text[0].upper() + text[1:] + ".", usage=usage)
    p.add_argument("script", metavar="SCRIPT", help="a Python program that imports OpenGL")
    p.add_argument("--out", metavar="DIR", help="where frame_000.png and so on go (default: frames)")
    p.add_argument("--frames", type=count, default=1, metavar="N", help="steps of the main loop (default: 1)")
    p.add_argument("--events", default="", metavar='"key a;mouse 0 0 10 20;..."',
                   help="one event for each step from the second on: key C, special N, mouse BUTTON STATE X Y, "
                   "motion X Y, passive X Y, menu VALUE, reshape W H, tick")  # fmt: skip
    p.add_argument("--keys", default="", metavar="abc", help="short for --events with a key for each letter")
    p.add_argument("--size", type=rectangle, metavar="WxH", help="size of every window, whatever the program asks")
    p.add_argument("--shade", type=shading, metavar="flat|gouraud|phong", help="shade everything like this")
    p.add_argument("--lobe", type=lobe, metavar="blinn|phong", help="the specular lobe: (N.H)^n or (R.V)^n")
    p.add_argument("--window", action="store_true", help="show real windows (needs the package glfw)")
    p.add_argument("--real-time", action="store_true", help="let the clock run, instead of 20 ms a step")
    p.add_argument("--timeout", type=positive, default=None, metavar="SECONDS",
                   help="stop the program after this time (default: 60; with --window never)")  # fmt: skip
    p.add_argument("--gif", metavar="FILE", help="an animation of all steps")
    p.add_argument("--mp4", metavar="FILE", help="an animation of all steps (needs the package imageio-ffmpeg)")
    p.add_argument("--no-python2", action="store_true", help="do not convert programs of Python 2")
    p.add_argument("--json", action="store_true", help="print one line of JSON: status, frames, calls")
    p.set_defaults(run=_run)


def _run(options: argparse.Namespace) -> int:
    from glsim.play.plan import Plan
    from glsim.play.run import animate, check_animation, events_from, run

    animations = {kind: Path(name) for kind in ("gif", "mp4") if (name := getattr(options, kind)) is not None}
    for kind, target in animations.items():
        check_animation(kind, target)
    out = options.out or (None if options.window else "frames")
    plan = Plan(
        options.script, options.arguments, out, options.frames, events_from(options.keys, options.events),
        options.size, options.shade, options.lobe, options.window, options.real_time or options.window, options.json,
        not options.no_python2,
    )  # fmt: skip
    timeout = options.timeout or (None if options.window else 60.0)
    record = run(plan, timeout)
    first = [Path(out or ".") / name for name in record["pictures"] if "_w" not in name]
    code = {"ok": 0, "interrupted": 130}.get(record["status"], 1)
    for kind, target in animations.items():
        try:
            animate(first, target)
        except (ValueError, OSError) as error:
            record["notes"].append(f"--{kind}: {error}")
            code = code or 1
    if options.json:
        print(json.dumps(record))
    else:
        for note in record["notes"]:
            print(f"glsim run: {note}", file=sys.stderr)
        where = f", pictures in {out}" if record["pictures"] else ""
        print(f"{options.script}: {record['status']}, {record['frames']} frames{where}")
    return code


# ---------------------------------------------------------------- probe, terms, explain, trace

SUBJECT = "a GLUT program (.py), a built-in scene or a mesh file"


def _add_study(commands: Any, name: str, text: str) -> argparse.ArgumentParser:
    """A command that looks at the Frame of a program or scene."""
    p: argparse.ArgumentParser = commands.add_parser(name, help=text, description=text[0].upper() + text[1:] + ".")
    p.add_argument("what", metavar="SCRIPT|SCENE", help=SUBJECT)
    p.add_argument("--frame", type=number, default=None, metavar="N",
                   help="which picture of a program (default: 0, or the one after all events)")  # fmt: skip
    p.add_argument("--events", default=None, metavar='"key a;..."', help="events of a program, as for glsim run")
    p.add_argument("--size", type=size, default=None, metavar="N",
                   help="pixels of the picture (default: 512, or as a program asks)")  # fmt: skip
    p.add_argument("--timeout", type=positive, default=None, metavar="SECONDS", help="for a program (default: 60)")
    p.add_argument("--json", action="store_true", help="print one JSON object")
    return p


def _frame_of(options: argparse.Namespace, calls: bool) -> Frame:
    from glsim.play.frames import frame_of
    from glsim.play.run import events_from

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


def _add_probe(commands: Any) -> None:
    p = _add_study(commands, "probe", "say why a pixel has its colour: every factor of every term")
    p.add_argument("x", type=number, metavar="X", help="pixels from the left")
    p.add_argument("y", type=number, metavar="Y", help="pixels from the top")
    p.add_argument("--latex", action="store_true", help="print the equation as LaTeX")
    p.set_defaults(run=_probe)


def _probe(options: argparse.Namespace) -> int:
    from glsim.study.prober import probe

    frame = _frame_of(options, calls=True)
    result = probe(frame, options.x, options.y)
    if options.latex and not options.json:
        print(result.latex())
    elif not options.json:
        console().print(result)
    return _tell(frame, options, result.as_dict())


def _add_terms(commands: Any) -> None:
    p = _add_study(commands, "terms", "take the picture apart: the terms of each light, and their factors")
    p.add_argument("-o", "--output", metavar="FILE", default="terms.png", help="the sheet (default: terms.png)")
    p.set_defaults(run=_terms)


def _terms(options: argparse.Namespace) -> int:
    from glsim.study.terms import terms

    check_picture_name(options.output)
    frame = _frame_of(options, calls=False)
    result = terms(frame)
    result.save(options.output)
    found = result.statistics()
    if not options.json:
        print(f"wrote {options.output}: {found['lit']} lit pixels, {found['clamped']} of them clamped")
    return _tell(frame, options, {"output": options.output, **found})


def _add_explain(commands: Any) -> None:
    p = _add_study(commands, "explain", "say which call set each constant and uniform of a draw")
    p.add_argument("--draw", type=number, default=None, metavar="N", help="only this draw (default: all)")
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
        from glsim.study.tables import explanations

        for table in explanations(found):
            console().print(table)
    return _tell(frame, options, {"draws": listed})


def _add_trace(commands: Any) -> None:
    p = _add_study(commands, "trace", "print the calls with what each changed, and classic mistakes")
    p.add_argument("--mistakes", action="store_true", help="print the mistakes only; exit code 1 if there are any")
    p.set_defaults(run=_trace)


def _trace(options: argparse.Namespace) -> int:
    from glsim.study.tables import calls_table, mistakes_list
    from glsim.study.trace import trace

    frame = _frame_of(options, calls=True)
    found = trace(frame)
    if not options.json:
        if not options.mistakes:
            console().print(calls_table(found))
        console().print(mistakes_list(found))
    code = _tell(frame, options, found.as_dict())
    return 1 if options.mistakes and found.mistakes else code


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
