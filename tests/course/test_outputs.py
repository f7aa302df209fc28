"""Running the cells of a lesson, and the files that are made of them."""

from __future__ import annotations

import base64
import io
import json
import os
import re
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import glsim
from glsim.course.cells import read
from glsim.course.markdown import FormulaError, html, mathml
from glsim.course.notebook import notebook
from glsim.course.outputs import LessonError, Output, execute, shown, write_figures
from glsim.course.site import Page, write_site

TEXT = """\
# %% [markdown]
# # 3. Red
# A red picture, $k_d = 1$.

# %% [markdown]
# ## Predict
# Which colour?
#
# - blue
# - red & nothing else

# %%
import glsim
from glsim.gl import *
screen = glsim.offscreen(8, 4)
glClearColor(1, 0, 0, 1)
glClear(GL_COLOR_BUFFER_BIT)
print("cleared <once>")

# %% Red, and *only* red
screen

# %%
screen.save("red.png")
x = None

# %%
x
"""


def lesson(folder: Path, text: str = TEXT, name: str = "03_red.py"):
    (folder / name).write_text(text, encoding="utf-8")
    return read(folder / name)


def test_cells_share_names_and_show_their_last_expression(tmp_path: Path, screen: glsim.Offscreen) -> None:
    before = os.getcwd()
    outputs = execute(lesson(tmp_path))
    assert [sorted(output.shown) for output in outputs[2:]] == [[], ["image/png", "text/plain"], [], []]
    assert outputs[2].printed == "cleared <once>\n"
    picture = np.asarray(Image.open(io.BytesIO(base64.b64decode(outputs[3].shown["image/png"]))))
    assert picture.shape == (4, 8, 3)
    assert (picture == (255, 0, 0)).all()
    assert os.getcwd() == before
    assert not list(tmp_path.glob("*.png")), "what a lesson saves does not stay"
    glsim.gl.glClearColor(0, 0, 1, 1)
    glsim.gl.glClear(glsim.gl.GL_COLOR_BUFFER_BIT)
    assert screen.pixels()[0, 0].tolist() == [0, 0, 255, 255], "the context of before is current again"
    assert [path.name for path in write_figures(tmp_path / "f", read(tmp_path / "03_red.py"), outputs)] == [
        "03_red-3.png"
    ]


@pytest.mark.parametrize(
    ("cell", "sentence"),
    [
        ("x = 1\n1 / 0", r"03_red.py, line 5: ZeroDivisionError"),
        ("def f():\n    1 / 0\nf()", r"03_red.py, line 5: ZeroDivisionError"),
        ("x = (", r"03_red.py, line \d: SyntaxError"),
    ],
)
def test_a_cell_that_fails_is_named(tmp_path: Path, cell: str, sentence: str) -> None:
    with pytest.raises(LessonError, match=sentence):
        execute(lesson(tmp_path, f"# %% [markdown]\n# # 3. T\n# %%\n{cell}\n"))


def test_what_jupyter_would_show() -> None:
    class Both:
        def _repr_html_(self) -> str:
            return "<p>"

        def _repr_png_(self) -> bytes:
            return b"png"

    assert shown(None) == {}
    assert list(shown(Both())) == ["text/html", "image/png", "text/plain"]
    assert shown(Both())["image/png"] == base64.b64encode(b"png").decode()
    assert list(shown(Both)) == ["text/plain"], "a class has no picture, its objects have"
    assert shown(3) == {"text/plain": "3"}


def test_formulas_become_mathml() -> None:
    assert "<msub><mi>k</mi><mi>d</mi></msub>" in html("with $k_d$")
    aligned = mathml(r"\begin{aligned} a &= b \\ c &= d \end{aligned}")
    assert aligned.count("<mtr>") == 2
    assert 'display="block"' in aligned
    assert "$5 and $6" in html("costs $5 and $6"), "money is no formula"
    with pytest.raises(FormulaError, match=r"the formula '\\\\foo': .*[Uu]nknown command"):
        html(r"$\foo$")


def test_a_page_of_the_site(tmp_path: Path) -> None:
    one = lesson(tmp_path)
    two = lesson(tmp_path, TEXT.replace("3. Red", "4. Again"), "04_again.py")
    pages = [Page(chosen, execute(chosen)) for chosen in (one, two)]
    files = write_site(tmp_path / "site", pages)
    assert [file.name for file in files] == ["index.html", "03_red.html", "04_again.html"]
    text = files[1].read_text(encoding="utf-8")
    assert '<img src="figures/03_red-3.png" alt="Red, and *only* red"' in text
    assert "<figcaption>Red, and <em>only</em> red</figcaption>" in text
    assert "cleared &lt;once&gt;" in text
    assert "red &amp; nothing else" in text
    hidden = re.findall(r'<details class="answer">.*?</details>', text, re.DOTALL)
    assert len(hidden) == 2, "what is printed and shown behind the question, up to the first figure, waits"
    assert "cleared &lt;once&gt;" in hidden[0]
    assert "03_red-3.png" in hidden[1]
    assert 'class="next" rel="next" href="04_again.html">Again<' in text
    assert 'class="prev"' not in text
    assert "03_red-3.png" not in files[0].read_text(encoding="utf-8"), "nor does the table of contents tell it"


def test_a_notebook_is_valid(tmp_path: Path) -> None:
    one = lesson(tmp_path)
    document = json.loads(notebook(one, execute(one)))
    assert document["nbformat"] == 4
    assert [cell["cell_type"] for cell in document["cells"]] == ["code", *(cell.kind for cell in one.cells)]
    assert "".join(document["cells"][1]["source"]) == one.cells[0].source
    stream, result = document["cells"][3]["outputs"], document["cells"][4]["outputs"]
    folded = [bool(cell["metadata"]) for cell in document["cells"]]
    assert folded == [False, False, False, True, True, False, False]
    assert stream[0]["text"] == "cleared <once>\n"
    assert "image/png" in result[0]["data"]
    assert json.loads(notebook(one))["cells"][3]["outputs"] == []
    nbformat = pytest.importorskip("nbformat", reason="nbformat is not installed; the structure was checked by hand")
    nbformat.validate(nbformat.from_dict(document))


def test_an_empty_output_is_no_figure() -> None:
    assert not Output().is_figure
    assert not Output(shown={"text/plain": "3"}).is_figure
    assert Output(shown={"image/png": ""}).is_figure
