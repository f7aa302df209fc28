"""``glsim probe``, ``terms``, ``explain`` and ``trace``."""

from __future__ import annotations

import argparse
import json
import sys
from typing import TYPE_CHECKING, Any

from glsim.cli.options import check_picture_name, console, number, positive, size

if TYPE_CHECKING:
    from glsim.machine.frame import Frame


def add(commands: Any) -> None:
    _add_probe(commands)
    _add_terms(commands)
    _add_explain(commands)
    _add_trace(commands)


SUBJECT = "a program (.py), a built-in scene or a mesh file"


def add_study(commands: Any, name: str, text: str) -> argparse.ArgumentParser:
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


def frame_in(options: argparse.Namespace, calls: bool) -> Frame:
    from glsim.play.frames import frame_of
    from glsim.play.run import events_from

    given = [name for name in ("frame", "events", "timeout") if getattr(options, name) is not None]
    if given and not options.what.endswith(".py"):
        raise ValueError(f"--{given[0]} is for programs, and {options.what} is none")
    events = events_from("", options.events or "")
    step = len(events) if options.frame is None else options.frame
    timeout = 60.0 if options.timeout is None else options.timeout
    return frame_of(options.what, size=options.size, calls=calls, step=step, events=events, timeout=timeout)


def tell(frame: Frame, options: argparse.Namespace, found: dict[str, Any]) -> int:
    """Print JSON if it was asked for, and say if the program ended with an error: then the exit code is 1."""
    if options.json:
        outcome = {"status": "error", "error": frame.error} if frame.error else {"status": "ok"}
        print(json.dumps({**outcome, **found}))
    elif frame.error:
        where = f" (line {frame.error_at.line})" if frame.error_at is not None else ""
        print(f"glsim: {options.what} ended early{where}: {frame.error}", file=sys.stderr)
    return 1 if frame.error else 0


def _add_probe(commands: Any) -> None:
    p = add_study(commands, "probe", "say why a pixel has its colour: every factor of every term")
    p.add_argument("x", type=number, metavar="X", help="pixels from the left")
    p.add_argument("y", type=number, metavar="Y", help="pixels from the top")
    p.add_argument("--latex", action="store_true", help="print the equation as LaTeX")
    p.set_defaults(run=_probe)


def _probe(options: argparse.Namespace) -> int:
    from glsim.study.prober import probe

    frame = frame_in(options, calls=True)
    result = probe(frame, options.x, options.y)
    if options.latex and not options.json:
        print(result.latex())
    elif not options.json:
        console().print(result)
    return tell(frame, options, result.as_dict())


def show_probe(frame: Frame, x: int, y: int) -> None:
    """Print the probe of a pixel that was clicked in a window of ``glsim run --window``."""
    from glsim.study.prober import probe

    try:
        console().print(probe(frame, x, y))
    except ValueError as error:
        print(f"glsim run: {error}")


def _add_terms(commands: Any) -> None:
    p = add_study(commands, "terms", "take the picture apart: the terms of each light, and their factors")
    p.add_argument("-o", "--output", metavar="FILE", default="terms.png", help="the sheet (default: terms.png)")
    p.set_defaults(run=_terms)


def _terms(options: argparse.Namespace) -> int:
    from glsim.study.terms import terms

    check_picture_name(options.output)
    frame = frame_in(options, calls=False)
    result = terms(frame)
    result.save(options.output)
    found = result.statistics()
    if not options.json:
        print(f"wrote {options.output}: {found['lit']} lit pixels, {found['clamped']} of them clamped")
    return tell(frame, options, {"output": options.output, **found})


def _add_explain(commands: Any) -> None:
    p = add_study(commands, "explain", "say which call set each constant and uniform of a draw")
    p.add_argument("--draw", type=number, default=None, metavar="N", help="only this draw (default: all)")
    p.add_argument("--glsl", action="store_true", help="print the GLSL without the branches that are not taken")
    p.set_defaults(run=_explain)


def _explain(options: argparse.Namespace) -> int:
    from glsim.study.explain import explain

    frame = frame_in(options, calls=True)
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
    return tell(frame, options, {"draws": listed})


def _add_trace(commands: Any) -> None:
    p = add_study(commands, "trace", "print the calls with what each changed, and classic mistakes")
    p.add_argument("--mistakes", action="store_true", help="print the mistakes only; exit code 1 if there are any")
    p.set_defaults(run=_trace)


def _trace(options: argparse.Namespace) -> int:
    from glsim.study.tables import calls_table, mistakes_list
    from glsim.study.trace import trace

    frame = frame_in(options, calls=True)
    found = trace(frame)
    if not options.json:
        if not options.mistakes:
            console().print(calls_table(found))
        console().print(mistakes_list(found))
    code = tell(frame, options, found.as_dict())
    return 1 if options.mistakes and found.mistakes else code
