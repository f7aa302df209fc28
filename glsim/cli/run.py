"""``glsim run``."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from glsim.cli.options import count, lobe, positive, rectangle, shading

if TYPE_CHECKING:
    from glsim.machine.frame import Frame

MOST_CALLS = 4_000  # of the first picture, that are recorded to look for mistakes


def add(commands: Any) -> None:
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
    plan.most_calls = MOST_CALLS
    plan.clicked = "glsim.cli.study:show_probe" if options.window else None
    found: list[dict[str, Any]] = []
    record = run(plan, timeout, look=lambda frame: found.extend(_mistakes(frame)))
    first = [Path(out or ".") / name for name in record["pictures"] if "_w" not in name]
    code = {"ok": 0, "interrupted": 130}.get(record["status"], 1)
    for kind, target in animations.items():
        try:
            animate(first, target)
        except (ValueError, OSError) as error:
            record["notes"].append(f"--{kind}: {error}")
            code = code or 1
    if options.json:
        print(json.dumps({**record, "mistakes": found}))
    else:
        for note in record["notes"]:
            print(f"glsim run: {note}", file=sys.stderr)
        where = f", pictures in {out}" if record["pictures"] else ""
        print(f"{options.script}: {record['status']}, {record['frames']} frames{where}")
        if found:
            print(_in_a_line(options.script, found))
    return code


def _mistakes(frame: Frame) -> list[dict[str, Any]]:
    """The classic mistakes in a Frame."""
    from glsim.study.trace import mistakes_of

    return [
        {"kind": one.kind, "what": one.looks_at, "line": one.where.line if one.where else None,
         "sentence": one.sentence} for one in mistakes_of(frame)
    ]  # fmt: skip


def _in_a_line(script: str, found: list[dict[str, Any]]) -> str:
    first, others = found[0], len(found) - 1
    line = f" (line {first['line']})" if first["line"] else ""
    return f"glsim trace --mistakes {script} explains: {first['what']}{line}" + (f"; {others} more" if others else "")
