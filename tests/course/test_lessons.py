"""Every lesson runs, has all parts of a lesson, and every topic of the lecture has one."""

from __future__ import annotations

import base64
import io
import re
import subprocess
import sys
from pathlib import Path

import pytest
from PIL import Image

from glsim.cli import main
from glsim.course.cells import Lesson, lesson, lessons
from glsim.testing.snapshot import Snapshot
from tests.course.executed import outputs_of

LESSONS = lessons()
PNG, SVG = "image/png", "image/svg+xml"

# The lecture's topics in its order: the number of the lesson, and words that it must speak of.
TOPICS = {
    1: ("the pipeline", "modelview", "viewport"),
    2: ("rendering styles", "wireframe", "hidden"),
    3: ("object appearance", "reflected", "absorbed"),
    4: ("light sources", "isotropic", "directional", "spot", "superposition"),
    5: ("Snell", "law of reflection", "Fresnel"),
    6: ("diffuse", "specular", "glossy"),
    7: ("Lambert", "proof", "cosine"),
    8: ("Phong", "shininess", "highlight"),
    9: ("R =", "unit"),
    10: ("Blinn", "halfway", "orthographic"),
    11: ("ambient", "glow"),
    12: ("red light", "green", "highlight"),
    13: ("clamp", "flip", "many lights"),
    14: ("GL_FLAT", "provoking"),
    15: ("Gouraud", "highlight", "vertices"),
    16: ("GL_PHONG_WIN", "normal", "Phong model"),
    17: ("probe", "emission"),
    18: ("orientation", "silhouette"),
    19: ("hyperbolic", "affine"),
    20: ("T-vert",),
    21: ("area", "angle", "crease"),
    22: ("planar", "stencil", "shadow map"),
    23: ("attenuation", "square"),
    24: ("transparen", "blend", "order"),
    25: ("texture", "GL_MODULATE"),
    26: ("area light", "soft shadow"),
    27: ("BRDF", "reciproc", "energy"),
    28: ("ray tracing", "mirror"),
    29: ("patch", "form factor"),
    30: ("energy balance", "reciprocity", "radiosity"),
    31: ("linear system", "matrix"),
    32: ("Jacobi", "Gauss-Seidel", "shooting"),
    33: ("direct illumination", "radiosity"),
    34: ("soft shadow", "adaptive"),
    35: ("factory", "museum", "vertex colours"),
}


def text_of(one: Lesson) -> str:
    return "\n".join(cell.source for cell in one.cells)


def test_every_topic_has_its_lesson() -> None:
    by_number = {one.number: text_of(one).lower() for one in LESSONS}
    assert sorted(by_number) == sorted(TOPICS)
    missing = {n: [w for w in words if w.lower() not in by_number[n]] for n, words in TOPICS.items()}
    assert not {n: words for n, words in missing.items() if words}


@pytest.mark.parametrize("one", LESSONS, ids=lambda one: one.name)
def test_a_lesson_has_its_parts(one: Lesson) -> None:
    prose = "\n\n".join(cell.source for cell in one.cells if cell.kind == "markdown")
    assert re.match(rf"# {one.number}\. \S", prose), "the title has the lesson's number"
    headings = re.findall(r"^## (.+)$", prose, re.MULTILINE)
    parts = ["Predict", "What you should see", "The formula", "Try this", "Questions", "Exercise"]
    missing = [part for part in parts if not any(heading.startswith(part) for heading in headings)]
    assert not missing, f"parts that are missing: {missing}"
    assert headings[0].startswith("Predict"), "a lesson begins with a prediction"
    changes = re.search(r"^## Try this\n+(.*?)(?=\n## |\Z)", prose, re.MULTILINE | re.DOTALL)
    assert changes is not None
    assert len(re.findall(r"^\d\. ", changes[1], re.MULTILINE)) >= 3, "at least three changes to try"
    assert prose.count("<details><summary>Answer</summary>") >= 1
    assert prose.count("<details>") == prose.count("</details>")
    assert re.search(r"^Exercises? \d+", prose, re.MULTILINE), "the number of the exercise"
    assert any(cell.source.startswith("glsim.source(") for cell in one.cells), "a line of source beside the formula"
    question = next(k for k, cell in enumerate(one.cells) if cell.source.startswith("## Predict"))
    assert one.cells[question + 1].kind == "code", "the figure follows its question"
    too_long = [line for line in one.path.read_text(encoding="utf-8").splitlines() if len(line) > 88]
    assert not [line for line in too_long if not line.startswith("#")], "code that does not fit the page"


@pytest.mark.slow
@pytest.mark.parametrize("one", LESSONS, ids=lambda one: one.name)
def test_a_lesson_runs_and_shows_its_figures(one: Lesson, gl_snapshot: Snapshot) -> None:
    """Figures are held against approved ones, small: what they show must stay; letters and rounding may differ."""
    outputs = outputs_of(one.name)
    question = next(k for k, cell in enumerate(one.cells) if cell.source.startswith("## Predict"))
    shown_after = [output.is_figure for output in outputs[question + 1 :]]
    assert any(shown_after), "the prediction's figure"
    assert any("image/png" in output.shown or "image/svg+xml" in output.shown for output in outputs)
    for cell, output in zip(one.cells, outputs, strict=True):
        if "image/png" in output.shown or "image/svg+xml" in output.shown:
            assert cell.title, f"line {cell.line}: a figure needs a caption behind # %%"
    drawn = [output.shown["image/png"] for output in outputs if SVG not in output.shown and PNG in output.shown]
    for number, picture in enumerate(drawn):
        image = Image.open(io.BytesIO(base64.b64decode(picture))).convert("RGB")
        image.thumbnail((128, 128), Image.Resampling.BOX)
        gl_snapshot(image, name=str(number), mean=(0, 1.5), max=(0, 120))
    if not drawn:
        gl_snapshot(Image.new("L", (1, 1)), name="plots only")


@pytest.mark.slow
def test_a_lesson_is_a_program(tmp_path: Path) -> None:
    path = lesson("lambert").path
    done = subprocess.run([sys.executable, str(path)], cwd=tmp_path, capture_output=True, text=True, timeout=120)
    assert (done.returncode, done.stderr) == (0, "")


def test_a_shown_lesson_keeps_the_signs_of_its_formulas(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["lesson", "show", "lambert"]) == 0
    shown = capsys.readouterr().out
    formulas = re.findall(r"\$[^$]*\\,[^$]*\$", text_of(lesson("lambert")))
    assert formulas, "the lesson has a formula with a space, which Markdown would take for a comma"
    assert r"I_L\, k_d" in shown


def test_a_shown_lesson_keeps_its_answers_until_they_are_asked_for(capsys: pytest.CaptureFixture[str]) -> None:
    answers = "The second square is half as bright", "The cosine is flat at its top"
    assert main(["lesson", "show", "lambert"]) == 0
    shown = capsys.readouterr().out
    assert not [words for words in answers if words in shown]
    assert "show lambert --answers" in shown
    assert main(["lesson", "show", "lambert", "--answers"]) == 0
    shown = capsys.readouterr().out
    assert all(words in shown for words in answers)
