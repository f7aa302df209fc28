"""The command ``glsim``: parses, calls, prints.

Exit codes: 0 success; 1 failure (the reason is printed), or trace --mistakes found some; 2 wrong command line; 130
interrupted by Ctrl-C; 128 + n ended by signal n.
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

from glsim.cli.options import Parser
from glsim.machine.errors import GLError


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

    Yields the list of the signals that came.
    """
    signals: list[int] = []

    def interrupt(number: int, frame: object) -> None:
        signals.append(number)
        raise KeyboardInterrupt

    numbers = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]
    if threading.current_thread() is not threading.main_thread():
        numbers = []
    before = {n: signal.signal(n, interrupt) for n in numbers if signal.getsignal(n) is signal.SIG_DFL}
    try:
        yield signals
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
    from glsim.cli import compare, doctor, exercise, export, grade, lesson, radiosity, run, snapshots, study, tape
    from glsim.version import __version__

    parser = Parser(prog="glsim", description="OpenGL's fixed-function pipeline, to teach and to learn.")
    parser.add_argument("--version", action="version", version=f"glsim {__version__}")
    commands = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")
    for command in (compare, run, study, export, tape, radiosity, lesson, exercise, grade, snapshots, doctor):
        command.add(commands)
    return parser
