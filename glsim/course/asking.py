"""Asks a student's file: runs it in a process of its own and reads what it answers."""

from __future__ import annotations

import json
import shutil
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from glsim.course.exercise import Call, Exercise, Part, Shader, Value
from glsim.course.isolation import Isolation
from glsim.files import read_regular
from glsim.machine import archive
from glsim.machine.frame import Frame

MOST_ANSWERS = 1 << 26  # bytes of the file of answers
SECONDS = 20.0  # that a student's file may take


@dataclass
class Answers:
    """What a student's file answered.

    values: for each part {"value": ...} or {"error": sentence, "line": number}; {} if no answer came.
    frame: what a program drew.  printed: the end of what the file printed, at most 500 characters.  note: how the
    process ended, if not in the usual way.
    """

    values: list[dict[str, Any]]
    frame: Frame | None = None
    printed: str = ""
    note: str = ""


def ask(exercise: Exercise, file: Path, isolation: Isolation, seconds: float = SECONDS) -> Answers:
    """Run a student's file and return its answers to all parts of an exercise.

    seconds: after which the process is stopped.  Raises FileNotFoundError if there is no such file."""
    if not file.is_file():
        raise FileNotFoundError(f"{file}: there is no such file")
    parts = exercise.definition.parts
    with tempfile.TemporaryDirectory(prefix="glsim-") as name:
        folder = Path(name)
        copy = folder / "work" / file.name
        copy.parent.mkdir()
        shutil.copyfile(file, copy)
        if exercise.definition.program:
            return _drawn(copy, folder, isolation, seconds, len(parts))
        return _answered(request_for(exercise, copy, folder), folder, isolation, seconds)


def request_for(exercise: Exercise, file: Path, folder: Path) -> dict[str, Any]:
    """What is asked of a file, as JSON.  folder: for the Frames that shaders are tried on."""
    asks = [_ask(part, number, folder, file) for number, part in enumerate(exercise.definition.parts)]
    return {"file": str(file), "asks": asks}


def _ask(part: Part, number: int, folder: Path, copy: Path) -> dict[str, Any]:
    """What is asked for a part, as JSON."""
    if isinstance(part, Call):
        arguments = [[packed(argument) for argument in arguments] for arguments in part.arguments]
        return {"kind": "call", "function": part.function, "arguments": arguments}
    if isinstance(part, Value):
        return {"kind": "value", "names": list(part.expected)}
    if isinstance(part, Shader):
        from glsim.course.shaders import frame_for

        frame = folder / f"frame-{number}"
        archive.save(frame_for(part), frame)
        return {"kind": "shader", "source": str(copy), "frame": str(frame), "shader": part.file,
                "function": part.function}  # fmt: skip
    raise TypeError(f"{type(part).__name__} is a part of programs that draw")


def packed(value: Any) -> Any:
    """An argument for JSON: arrays with their type, everything else as it is."""
    if isinstance(value, np.ndarray):
        return {"array": value.tolist(), "dtype": str(value.dtype)}
    if isinstance(value, np.generic):
        return value.item()
    return [packed(one) for one in value] if isinstance(value, (list, tuple)) else value


def _answered(request: dict[str, Any], folder: Path, isolation: Isolation, seconds: float) -> Answers:
    question, results = folder / "request.json", folder / "out" / "answers.json"
    results.parent.mkdir()
    question.write_text(json.dumps(request), encoding="utf-8")
    command = [sys.executable, "-P", "-m", "glsim.course.answering", str(question), str(results)]
    note = isolation.run(command, folder, seconds)
    count = len(request["asks"])
    try:
        document = json.loads(read_regular(results, MOST_ANSWERS))
        values, printed = document["answers"], str(document["printed"])[-500:]
        if not isinstance(values, list) or len(values) != count or not all(isinstance(v, dict) for v in values):
            raise ValueError("answers of another form")
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        values, printed = [{}] * count, ""
    if not all(values):
        note = note or "the file ended its process before it had answered (sys.exit, os._exit or a crash)"
    return Answers([value or {"error": note} for value in values], printed=printed, note=note)


def _drawn(copy: Path, folder: Path, isolation: Isolation, seconds: float, count: int) -> Answers:
    """Play a program that draws, and read the Frame of its first picture."""
    from dataclasses import asdict

    from glsim.play.plan import Plan
    from glsim.play.run import read_report

    out = folder / "out"
    out.mkdir()
    report, target = out / "report.json", out / "frame"
    plan = Plan(str(copy), result=str(report), capture=str(target), capture_calls=True, count=True)
    command = [sys.executable, "-P", "-m", "glsim.play.player", json.dumps(asdict(plan))]
    note = isolation.run(command, folder, seconds)
    record = read_report(str(report))
    errors = record["errors"]
    error = {"error": errors[0]["error"], "line": errors[0]["line"]} if errors else {"error": note}
    try:
        frame = archive.load(target)
    except (OSError, ValueError):
        error["error"] = error["error"] or "the program draws nothing: it opens no window and no glsim.offscreen"
        return Answers([error] * count, note=note)
    return Answers([error if errors else {}] * count, frame, note=note)
