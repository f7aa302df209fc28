"""A lesson as a notebook file (.ipynb, nbformat 4.5), with its outputs: for Colab, which opens no .py."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

from glsim.course.cells import Cell, Lesson, folded
from glsim.course.outputs import LIVE, Output, awaited

LARGEST_PAGE = 1 << 20  # letters of a live figure; a larger one is a still picture in notebooks
INSTALL = Cell("code", "%pip install -q 'glsim[course]'", "", 0)


def notebook(lesson: Lesson, outputs: Sequence[Output] = ()) -> str:
    """The notebook's JSON.  outputs: of each cell, as ``outputs.execute`` returns them; none for an empty notebook.

    The outputs and the words that answer the prediction are folded."""
    cells = [_cell(INSTALL, Output(), 0)]
    filled = outputs or [Output()] * len(lesson.cells)
    cells += [_cell(cell, output, k) for k, (cell, output) in enumerate(zip(lesson.cells, filled, strict=True), 1)]
    for number in awaited(lesson, filled):
        cells[number + 1]["metadata"] = {"jupyter": {"outputs_hidden": True}}
    language = {"name": "python", "version": "3"}
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    document = {"cells": cells, "metadata": {"kernelspec": kernel, "language_info": language}}
    return json.dumps({**document, "nbformat": 4, "nbformat_minor": 5}, indent=1, ensure_ascii=False) + "\n"


def _cell(cell: Cell, output: Output, number: int) -> dict[str, Any]:
    source = folded(cell.source) if cell.kind == "markdown" else cell.source
    common = {"id": f"cell-{number}", "metadata": {}, "source": source.splitlines(keepends=True)}
    if cell.kind == "markdown":
        return {"cell_type": "markdown", **common}
    outputs: list[dict[str, Any]] = []
    if output.printed:
        outputs.append({"output_type": "stream", "name": "stdout", "text": output.printed})
    if output.shown:
        data = _data(output)
        outputs.append({"output_type": "execute_result", "data": data, "metadata": {}, "execution_count": None})
    return {"cell_type": "code", **common, "execution_count": None, "outputs": outputs}


def _data(output: Output) -> dict[str, str]:
    """What a notebook shows: of a live figure the page, in a frame, if it is not too large."""
    large = LIVE in output.shown and len(output.shown["text/html"]) > LARGEST_PAGE
    return {kind: text for kind, text in output.shown.items() if kind != LIVE and not (large and kind == "text/html")}
