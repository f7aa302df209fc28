"""Grades submissions in several processes.  A mark depends on the file and the exercise alone, not on their order."""

from __future__ import annotations

import base64
import hashlib
import io
import multiprocessing
import os
import shutil
import signal
import tempfile
import threading
import time
from collections.abc import Generator, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

from glsim.course.checking import Result, check, side_by_side
from glsim.course.exercise import Definition, Exercise, Picture, Value, exercises, read
from glsim.course.grading.contents import shown
from glsim.course.grading.record import Part, Record, Store
from glsim.course.grading.submissions import Chosen, Submission, choose
from glsim.course.isolation import best
from glsim.course.judging import Mark
from glsim.version import __version__

WIDEST = 720  # pixels of a picture in a report


class GradingError(RuntimeError):
    """Nothing can be graded on this machine."""


@dataclass(frozen=True)
class Task:
    """A file to be graded.  blank: its Record without marks.  path: the exercise's file."""

    blank: Record
    path: Path
    data: bytes
    seconds: float


def grade(
    submissions: Sequence[Submission],
    wanted: Sequence[Exercise],
    *,
    jobs: int,
    seconds: float,
    store: Store | None = None,
    resume: bool = False,
) -> Generator[Record]:
    """Grade submissions; yields each Record as soon as it is there, in any order, after it was written to ``store``.

    jobs: processes.  seconds: that a student's file may run.  resume: take Records from ``store`` where neither file
    nor exercise have changed.  Raises GradingError, before anything is graded, if no file can be run on this machine.
    Whatever ends the loop over the Records ends the processes too."""
    known = exercises(wanted[0].path.parent)
    tasks: list[Task] = []
    for submission in submissions:
        for one, chosen in zip(wanted, _chosen(submission, wanted, known), strict=True):
            task = _task(submission, one, chosen, seconds)
            old = store.read(submission.slug, one.name) if store and resume else None
            if old is not None and old.key == task.blank.key and not old.failure:
                yield old
            elif not isinstance(chosen, Chosen):
                yield _kept(store, task.blank)
            else:
                tasks.append(task)
    if tasks:
        _check_machine()
        for record in _all(tasks, jobs):
            yield _kept(store, record)


def _chosen(
    submission: Submission, wanted: Sequence[Exercise], known: Sequence[Exercise]
) -> Sequence[Chosen | str | Exception]:
    """As ``choose``; the exception for each exercise if the submission cannot be read, which is no student's fault."""
    try:
        return choose(submission, wanted, known)
    except Exception as error:  # whatever one submission does, the others are graded
        return [error] * len(wanted)


def _kept(store: Store | None, record: Record) -> Record:
    if store:
        store.write(record)
    return record


def _task(submission: Submission, one: Exercise, chosen: Chosen | str | Exception, seconds: float) -> Task:
    data = chosen.data if isinstance(chosen, Chosen) else b""
    about = (chosen.place, chosen.note) if isinstance(chosen, Chosen) else (str(chosen),)
    key = hashlib.sha256(repr((__version__, seconds, _fingerprint(one), about)).encode() + data)
    blank = Record(
        submission.name,
        submission.slug,
        one.name,
        one.heading,
        tuple(Part(part.about, 0, part.points) for part in one.definition.parts),
        file=chosen.place if isinstance(chosen, Chosen) else "",
        note=chosen.note if isinstance(chosen, Chosen) else chosen if isinstance(chosen, str) else "",
        key=key.hexdigest(),
        failure=_failure(chosen) if isinstance(chosen, Exception) else "",
    )
    return Task(blank, one.path, data, seconds)


def _fingerprint(one: Exercise) -> str:
    """A hash of an exercise: its file and its pictures."""
    pictures = [one.path.parent / part.name for part in one.definition.parts if isinstance(part, Picture)]
    return hashlib.sha256(b"".join(path.read_bytes() for path in [one.path, *pictures])).hexdigest()


def _check_machine() -> None:
    """Raises GradingError if not even a file of one line can be run and judged."""
    part = Value("a number", {"x": 1}, "")
    with tempfile.TemporaryDirectory(prefix="glsim-") as folder:
        path = Path(folder) / "00_trial.py"
        path.write_text("x = 1\n", encoding="utf-8")
        result = check(Exercise(path, 0, "", Definition("trial", 0, "", [part])), path, best())
    if result.first_failure:
        raise GradingError(f"nothing can be graded here ({best().name}): {result.first_failure.hint}")


# ---------------------------------------------------------------- processes


def _all(tasks: Sequence[Task], jobs: int) -> Iterator[Record]:
    """The Records of tasks.  A task that ends its process, as a driver's crash does, fails alone."""
    waiting = list(tasks)
    while waiting:
        failed: list[Task] = []
        yield from _in_pool(waiting, jobs, failed)
        suspects, waiting = failed[: 2 * jobs + 1], failed[2 * jobs + 1 :]  # those that ran when the process ended
        for task in suspects:
            crashed: list[Task] = []
            yield from _in_pool([task], 1, crashed)
            if crashed:
                yield replace(task.blank, failure="the process that judges ended unexpectedly")


def _in_pool(tasks: Sequence[Task], jobs: int, failed: list[Task]) -> Iterator[Record]:
    """The Records of tasks; appends to ``failed``, in their order, the tasks that have none since a process ended."""
    with tempfile.TemporaryDirectory(prefix="glsim-") as scratch:
        pool = ProcessPoolExecutor(
            min(jobs, len(tasks)), multiprocessing.get_context("spawn"), initializer=_begin, initargs=(scratch,)
        )
        try:
            running = {pool.submit(graded, task): task for task in tasks}
            broken = set()
            for future in as_completed(running):
                try:
                    yield future.result()
                except BrokenProcessPool:
                    broken.add(id(running[future]))
            failed += [task for task in tasks if id(task) in broken]
        except BaseException:
            for child in multiprocessing.active_children():
                child.terminate()  # the supervisor of a student's process ends it
            raise
        finally:
            pool.shutdown(wait=True, cancel_futures=True)


def _begin(scratch: str) -> None:
    """Begin a process of the pool: its temporary files are removed by its parent, and it ends when its parent ends.

    Ctrl-C is the parent's; a terminal sends it to all processes."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    tempfile.tempdir = scratch
    parent = multiprocessing.parent_process()
    assert parent is not None

    def watch() -> None:
        parent.join()
        shutil.rmtree(scratch, ignore_errors=True)
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


_read = cache(read)


def graded(task: Task) -> Record:
    """The Record of one task."""
    began = time.monotonic()
    one = _read(task.path)
    try:
        with tempfile.TemporaryDirectory(prefix="glsim-") as folder:
            path = Path(folder) / one.filename
            path.write_bytes(task.data)
            result = check(one, path, best(), task.seconds)
    except Exception as error:  # whatever it is, it is no mark
        return replace(task.blank, failure=_failure(error), seconds=time.monotonic() - began)
    return _record(task.blank, result, time.monotonic() - began)


def _failure(error: Exception) -> str:
    return shown(f"{type(error).__name__}: {error}")[:500]


def _record(blank: Record, result: Result, seconds: float) -> Record:
    note = "; ".join(filter(None, (blank.note, shown(result.note))))
    parts = tuple(Part(m.about, m.points, m.most, shown(m.hint), _picture(m)) for m in result.marks)
    printed = "\n".join(shown(line.expandtabs()) for line in result.printed.splitlines())
    return replace(
        blank, parts=parts, note=note, printed=printed, isolation=result.isolation, seconds=round(seconds, 3)
    )


def _picture(mark: Mark) -> str:
    """Expected picture, the student's and their difference as a PNG in base64, "" if the mark has no pictures."""
    if mark.expected is None or mark.actual is None:
        return ""
    sheet = side_by_side(mark.expected, mark.actual)
    sheet.thumbnail((WIDEST, WIDEST))
    buffer = io.BytesIO()
    sheet.save(buffer, "PNG", optimize=True)
    return base64.b64encode(buffer.getvalue()).decode("ascii")
