"""The process in which a student's file runs: answers what is asked of the file, and knows nothing else.

    python -m glsim.course.answering REQUEST ANSWERS

REQUEST is a JSON file: {"file": path, "asks": [...]}; the answers go to the JSON file ANSWERS, one for each ask:
{"value": ...} or {"error": sentence, "line": number}.  Nothing that this process says is trusted: the other side checks
every answer, and neither the expected values nor the marks are here.
"""

from __future__ import annotations

import io
import json
import os
import sys
import traceback
import types
from collections.abc import Callable, Iterator
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any

import numpy as np

SHOWN = 500  # characters of the student's output that are kept


class Tail(io.TextIOBase):
    """Keeps the last SHOWN characters of what is written, so that endless printing fills no memory."""

    def __init__(self) -> None:
        self.text = ""

    def writable(self) -> bool:
        return True

    def write(self, text: str) -> int:
        self.text = (self.text + text[-SHOWN:])[-SHOWN:]
        return len(text)


def unpacked(value: Any) -> Any:
    """An argument as the request holds it: {"array": nested lists} is an array, everything else itself."""
    if isinstance(value, dict):
        return np.array(value["array"], dtype=value["dtype"])
    return [unpacked(one) for one in value] if isinstance(value, list) else value


def answer_call(module: types.ModuleType, ask: dict[str, Any]) -> list[Any]:
    """The values of a function, one for each tuple of arguments."""
    function = getattr(module, ask["function"], None)
    if not callable(function):
        raise NameError(f"the file defines no function {ask['function']}")
    return [plain(function(*map(unpacked, arguments)), ask["function"]) for arguments in ask["arguments"]]


def answer_value(module: types.ModuleType, ask: dict[str, Any]) -> list[Any]:
    """The constants that are asked for."""
    missing = [name for name in ask["names"] if not hasattr(module, name)]
    if missing:
        raise NameError(f"the file defines no {missing[0]}")
    return [plain(getattr(module, name), name) for name in ask["names"]]


def plain(value: Any, name: str) -> Any:
    """A number or nested lists of numbers.  Raises TypeError for anything else."""
    if value is None:
        raise TypeError(f"{name} is None: does the function return its result?")
    try:
        return np.asarray(value, dtype=np.float64).tolist()
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a number or an array of numbers, not {value!r:.60}") from None


def answer_shader(module: types.ModuleType, ask: dict[str, Any]) -> Any:
    """The picture of a Frame, (height, width, 3), drawn with the student's function in the real shader."""
    from glsim.course.shaders import drawn_with
    from glsim.machine import archive

    text = Path(ask["source"]).read_text(encoding="utf-8")
    return drawn_with(archive.load(ask["frame"]), ask["shader"], ask["function"], text)[..., :3].tolist()


ANSWERS = {"call": answer_call, "value": answer_value, "shader": answer_shader}


def loaded(path: str) -> types.ModuleType:
    """The student's file as a module.  A .glsl file gives an empty one."""
    module = types.ModuleType("student")
    module.__file__ = path
    if path.endswith(".py"):
        sys.modules["student"] = module
        sys.path.insert(0, os.path.dirname(path))
        with open(path, "rb") as file:
            exec(compile(file.read(), path, "exec"), module.__dict__)
    return module


def line_of(error: BaseException, path: str) -> int | None:
    """The line of the student's file in which an exception was raised."""
    if isinstance(error, SyntaxError) and error.filename == path:
        return error.lineno
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == path]
    return lines[-1] if lines else None


def failure(error: BaseException, path: str) -> dict[str, Any]:
    from glsim.names import hint_for

    hint = hint_for(error) if isinstance(error, Exception) else ""
    words = error.msg if isinstance(error, SyntaxError) else str(error)
    return {"error": f"{type(error).__name__}: {words}{hint}"[:SHOWN], "line": line_of(error, path)}


def answered(order: dict[str, Any], save: Callable[[dict[str, Any]], None] | None = None) -> dict[str, Any]:
    """The answers to a request: {"answers": one for each ask, "printed": the end of what was printed}.

    save: is called after each answer with those that are there, {} for the others."""
    tail = Tail()
    given: list[dict[str, Any]] = [{} for _ in order["asks"]]
    document: dict[str, Any] = {"answers": given}
    with redirect_stdout(tail), redirect_stderr(tail):
        for number, answer in enumerate(_given(order)):
            given[number] = answer
            document["printed"] = tail.text
            if save:
                save(document)
    return document


def _given(order: dict[str, Any]) -> Iterator[dict[str, Any]]:
    try:
        module = loaded(order["file"])
    except BaseException as error:  # SystemExit too: the file must be usable as a module
        yield from [failure(error, order["file"])] * len(order["asks"])
        return
    for ask in order["asks"]:
        try:
            answer = {"value": ANSWERS[ask["kind"]](module, ask)}
        except BaseException as error:
            answer = failure(error, order["file"])
        yield answer


def main(request: str, answers: str) -> None:
    """Answer a request file."""
    with open(request, encoding="utf-8") as file:
        order = json.load(file)
    sys.argv = [order["file"]]

    def save(document: dict[str, Any]) -> None:
        with open(f"{answers}.part", "w", encoding="utf-8") as file:
            json.dump(document, file)
        os.replace(f"{answers}.part", answers)

    answered(order, save)


if __name__ == "__main__":
    main(*sys.argv[1:])
