"""``glsim lesson``: the course, to list, read, run and export."""

from __future__ import annotations

import argparse
import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from glsim.cli.options import console, count, markdown

if TYPE_CHECKING:
    from glsim.course.cells import Lesson
    from glsim.course.site import Page


def add(commands: Any) -> None:
    text = "the lecture as lessons: list, read, run, and export as a site or as notebooks"
    p = commands.add_parser("lesson", help=text, description=text[0].upper() + text[1:] + ".")
    verbs = p.add_subparsers(title="commands", required=True, metavar="COMMAND")

    listed = verbs.add_parser("list", help="all lessons in the lecture's order")
    shown = verbs.add_parser("show", help="print a lesson; predict first, then see its answers with --answers")
    run = verbs.add_parser("run", help="run a lesson and write its figures")
    export = verbs.add_parser("export", help="run lessons and write them as pages or notebooks")
    for verb in (shown, run):
        verb.add_argument("lesson", metavar="N", help="a number, a name such as lambert, or a file")
    shown.add_argument("--answers", action="store_true",
                       help="print also what you should see and the answers to questions (--json has all)")  # fmt: skip
    export.add_argument("lessons", metavar="N", nargs="*", help="which lessons (default: all)")
    run.add_argument("-o", "--output", metavar="DIR", default="figures", help="for the figures (default: %(default)s)")
    export.add_argument("--html", metavar="DIR", help="write a site: index.html and a page for each lesson")
    export.add_argument("--ipynb", metavar="DIR", help="write notebooks with their outputs")
    export.add_argument("-j", "--jobs", type=count, metavar="N", default=os.cpu_count() or 1,
                        help="processes that run lessons (default: one for each core)")  # fmt: skip
    for verb, function in ((listed, _list), (shown, _show), (run, _run), (export, _export)):
        verb.add_argument("--json", action="store_true", help="print one JSON object")
        verb.set_defaults(run=function)


def _list(options: argparse.Namespace) -> int:
    from glsim.course.cells import lessons

    known = lessons()
    if options.json:
        entries = [{"number": one.number, "name": one.name, "title": one.title, "about": one.about} for one in known]
        print(json.dumps({"status": "ok", "lessons": entries}))
        return 0
    for one in known:
        print(f"{one.number:3}  {one.title}")
    return 0


def _show(options: argparse.Namespace) -> int:
    from glsim.course.cells import lesson, unanswered

    chosen = lesson(options.lesson)
    if options.json:
        cells = [{"kind": cell.kind, "title": cell.title, "source": cell.source} for cell in chosen.cells]
        print(json.dumps({"status": "ok", "lesson": chosen.name, "title": chosen.title, "cells": cells}))
        return 0
    from rich.syntax import Syntax

    out = console()
    for cell in chosen.cells:
        if cell.kind == "markdown":
            out.print(markdown(cell.source if options.answers else unanswered(cell.source)))
        else:
            out.print(Syntax(cell.source, "python", theme="ansi_dark"))
        out.print()
    if not options.answers:
        out.print(f"With the answers, and what you should see: glsim lesson show {options.lesson} --answers")
    return 0


def _run(options: argparse.Namespace) -> int:
    from glsim.course.cells import lesson
    from glsim.course.outputs import execute, write_figures

    chosen = lesson(options.lesson)
    outputs = execute(chosen)
    folder = Path(options.output)
    written = [str(path) for path in write_figures(folder, chosen, outputs)]
    if options.json:
        print(json.dumps({"status": "ok", "lesson": chosen.name, "figures": written}))
        return 0
    for output in outputs:
        print(output.printed, end="")
    print("\n".join(f"wrote {name}" for name in written) or "this lesson shows no figure")
    return 0


def _export(options: argparse.Namespace) -> int:
    from glsim.course.cells import lesson, lessons
    from glsim.course.notebook import notebook
    from glsim.course.site import write_site
    from glsim.files import write_text

    if not options.html and not options.ipynb:
        raise ValueError("glsim lesson export: say where to with --html DIR or --ipynb DIR")
    pages = _executed([lesson(name) for name in options.lessons] or lessons(), options.jobs)
    written = [str(path) for path in write_site(Path(options.html), pages)] if options.html else []
    if options.ipynb:
        folder = Path(options.ipynb)
        folder.mkdir(parents=True, exist_ok=True)
        for page in pages:
            path = folder / f"{page.lesson.name}.ipynb"
            write_text(path, notebook(page.lesson, page.outputs))
            written.append(str(path))
    if options.json:
        print(json.dumps({"status": "ok", "files": written}))
    else:
        print(f"wrote {len(written)} files; open {written[0]}")
    return 0


def _executed(chosen: list[Lesson], jobs: int) -> list[Page]:
    """Run lessons in several processes, with a progress bar on the terminal."""
    from concurrent.futures import ProcessPoolExecutor, as_completed
    from multiprocessing import get_context

    from rich.console import Console
    from rich.progress import Progress

    from glsim.course.outputs import execute
    from glsim.course.site import Page

    with Progress(console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task("running lessons", total=len(chosen))
        pool = ProcessPoolExecutor(min(jobs, len(chosen)), mp_context=get_context("spawn"))
        try:
            running = {pool.submit(execute, one): one for one in chosen}
            for done in as_completed(running):
                done.result()
                progress.update(task, advance=1, description=running[done].title)
            return [Page(one, future.result()) for future, one in running.items()]
        finally:
            pool.shutdown(wait=False, cancel_futures=True)
