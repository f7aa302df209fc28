"""``glsim exercise``: hand out, check, help."""

from __future__ import annotations

import argparse
import json
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

from glsim.cli.options import console, markdown, positive

if TYPE_CHECKING:
    from glsim.course.checking import Result
    from glsim.course.exercise import Exercise

POLL = 0.3  # seconds between two looks at a watched file


def add(commands: Any) -> None:
    text = "exercises of the lecture: list, show, begin, check and watch"
    p = commands.add_parser("exercise", help=text, description=text[0].upper() + text[1:] + ".")
    verbs = p.add_subparsers(title="commands", required=True, metavar="COMMAND")

    listed = verbs.add_parser("list", help="all exercises, and which are solved")
    shown = verbs.add_parser("show", help="print a statement")
    new = verbs.add_parser("new", help="write the file to begin with")
    check = verbs.add_parser("check", help="say the first thing that is wrong")
    watch = verbs.add_parser("watch", help="check again each time the file is saved, until Ctrl-C")
    hint = verbs.add_parser("hint", help="print hints for the parts of an exercise")
    solution = verbs.add_parser("solution", help="print a solution from a teacher's folder")
    for verb in (shown, new, solution):
        verb.add_argument("exercise", metavar="N", help="a number, or a name such as lambert")
    new.add_argument("folder", nargs="?", default=".", metavar="DIR", help="for the file (default: here)")
    for verb in (check, watch, hint):
        verb.add_argument("file", metavar="FILE", help="the file that glsim exercise new wrote")
        verb.add_argument("--exercise", metavar="N", help="which exercise (default: as the file's name says)")
    for verb in (check, watch):
        verb.add_argument("--timeout", type=positive, default=20.0, metavar="SECONDS",
                          help="that the file may run (default: %(default)g)")  # fmt: skip
        verb.add_argument("-o", "--output", metavar="FILE.png",
                          help="for the expected picture, yours and the difference (default: beside FILE)")  # fmt: skip
    solution.add_argument("--solutions", metavar="DIR", required=True, help="the teacher's folder of solutions")
    for verb, function in ((listed, _list), (shown, _show), (new, _new), (check, _check), (watch, _watch),
                           (hint, _hint), (solution, _solution)):  # fmt: skip
        verb.add_argument("--json", action="store_true", help="print one JSON object")
        verb.set_defaults(run=function)


def _list(options: argparse.Namespace) -> int:
    from glsim.course.exercise import exercises
    from glsim.course.handout import progress

    known, solved = exercises(), progress()
    if options.json:
        entries = [
            {"number": one.number, "name": one.name, "title": one.title, "lesson": one.definition.lesson,
             "points": one.points, "reached": solved.get(one.name)}
            for one in known
        ]  # fmt: skip
        print(json.dumps({"status": "ok", "exercises": entries}))
        return 0
    for one in known:
        reached = solved.get(one.name)
        state = "solved" if reached == one.points else f"{reached} of {one.points}" if reached is not None else ""
        name = f"{one.title} (lesson {one.definition.lesson})"
        print(f"{one.number:3}  {name:60} {state}".rstrip())
    return 0


def _show(options: argparse.Namespace) -> int:
    from glsim.course.exercise import exercise

    one = exercise(options.exercise)
    if options.json:
        print(json.dumps({"status": "ok", "exercise": one.name, "title": one.title, "statement": one.statement}))
        return 0
    console().print(markdown(f"# {one.heading}\n\n{one.statement}"))
    return 0


def _new(options: argparse.Namespace) -> int:
    from glsim.course.exercise import exercise
    from glsim.course.handout import write_starter

    one = exercise(options.exercise)
    path = write_starter(one, Path(options.folder))
    if options.json:
        print(json.dumps({"status": "ok", "file": str(path)}))
    else:
        print(f"wrote {path}; change it, then: glsim exercise check {path}")
    return 0


def _exercise_of(options: argparse.Namespace) -> Exercise:
    from glsim.course.exercise import exercise, exercise_of

    return exercise(options.exercise) if options.exercise else exercise_of(Path(options.file))


def _check(options: argparse.Namespace) -> int:
    from glsim.course.checking import check
    from glsim.course.handout import remember

    result = check(_exercise_of(options), Path(options.file), seconds=options.timeout)
    remember(result)
    picture = _save_pictures(result, options)
    if options.json:
        marks = [{"about": m.about, "points": m.points, "of": m.most, "hint": m.hint} for m in result.marks]
        print(
            json.dumps(
                {"status": "ok" if result.first_failure is None else "wrong", "exercise": result.exercise.name,
                 "points": result.points, "of": result.exercise.points, "marks": marks, "printed": result.printed,
                 "picture": picture}
            )
        )  # fmt: skip
    else:
        _tell(result, picture)
    return 0 if result.first_failure is None else 1


def _tell(result: Result, picture: str | None) -> None:
    """The parts that are right, the first that is wrong with its hint, and the end of what the file printed."""
    from rich.text import Text

    out = console()
    for mark in result.marks:
        if not mark.right:
            out.print(Text(f"✗ {mark.about}", "bold red"))
            out.print(Text(f"  {mark.hint}"))
            break
        out.print(Text(f"✓ {mark.about}", "green"))
    if picture:
        out.print(Text(f"  the expected picture, yours and the difference: {picture}"))
    if result.printed.strip():
        out.print(Text("Your file printed:", "dim"))
        out.print(Text(result.printed.rstrip(), "dim"))
    solved = result.first_failure is None
    out.print(Text(f"{result.points} of {result.exercise.points} points" + ("; solved" if solved else "")))


def _save_pictures(result: Result, options: argparse.Namespace) -> str | None:
    """Write expected picture, actual one and their difference side by side, if the first failure has pictures."""
    mark = result.first_failure
    if mark is None or mark.expected is None or mark.actual is None:
        return None
    from glsim.course.checking import side_by_side
    from glsim.files import write_atomically

    name = options.output or str(Path(options.file).with_suffix(".png"))
    sheet = side_by_side(mark.expected, mark.actual)
    write_atomically(name, lambda target: sheet.save(target))
    return name


def _watch(options: argparse.Namespace) -> int:
    """Check at once and after each change of the file; Ctrl-C ends."""
    path = Path(options.file)
    seen: tuple[int, int] | None = None
    solved = 1
    try:
        while True:
            try:
                facts = path.stat()
                now = facts.st_mtime_ns, facts.st_size
            except FileNotFoundError:  # an editor may replace the file
                now = seen or (0, 0)
                if seen is None:
                    raise FileNotFoundError(f"{path}: there is no such file") from None
            if now != seen:
                seen = now
                if not options.json:
                    console().rule(time.strftime("%H:%M:%S"))
                solved = _check(options)
            time.sleep(POLL)
    except KeyboardInterrupt:
        return solved


def _hint(options: argparse.Namespace) -> int:
    from glsim.course.handout import hints

    one = _exercise_of(options)
    if options.json:
        print(json.dumps({"status": "ok", "exercise": one.name, "hints": hints(one)}))
    else:
        print("\n".join(f"{number}. {hint}" for number, hint in enumerate(hints(one), 1)))
    return 0


def _solution(options: argparse.Namespace) -> int:
    from glsim.course.exercise import exercise
    from glsim.course.handout import solution

    text = solution(exercise(options.exercise), Path(options.solutions))
    if options.json:
        print(json.dumps({"status": "ok", "solution": text}))
    else:
        print(text, end="")
    return 0
