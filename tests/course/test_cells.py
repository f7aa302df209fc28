"""Lessons as files: cells, numbers, names, and sentences about what is wrong."""

from __future__ import annotations

from pathlib import Path

import pytest

from glsim.course.cells import lesson, lessons, read
from glsim.course.source import source

TEXT = """\
# %% [markdown]
# # 3. A title
#
# The first paragraph
# in two lines.
#
#     indented

# %% A caption
x = 1
#%% is no marker, and neither is
y = "# %%"

# %%
x
"""


def written(folder: Path, text: str = TEXT, name: str = "03_topic.py") -> Path:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


def test_cells(tmp_path: Path) -> None:
    one = read(written(tmp_path))
    assert [cell.kind for cell in one.cells] == ["markdown", "code", "code"]
    assert (one.number, one.name, one.title) == (3, "03_topic", "A title")
    assert one.about == "The first paragraph in two lines."
    assert one.cells[0].source.endswith("\n\n    indented")
    assert one.cells[1].title == "A caption"
    for cell in one.cells[1:]:
        assert TEXT.splitlines()[cell.line - 1] == cell.source.splitlines()[0]


@pytest.mark.parametrize(
    ("name", "text", "sentence"),
    [
        ("3_topic.py", TEXT, "the name of a lesson is NN_topic.py"),
        ("03_topic.py", "x = 1\n", "a lesson has cells that begin with # %%"),
        ("03_topic.py", "# %% [markdown]\n# text\nx = 1\n", "line 3: lines of a Markdown cell begin with #"),
    ],
)
def test_what_is_no_lesson(tmp_path: Path, name: str, text: str, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        read(written(tmp_path, text, name))


def test_lessons_are_found_by_number_name_and_file(tmp_path: Path) -> None:
    path = written(tmp_path)
    written(tmp_path, TEXT, "10_other.py")
    written(tmp_path, "no lesson", "helper.py")
    assert [one.number for one in lessons(tmp_path)] == [3, 10]
    for name in ("3", "03", "topic", "03_topic", str(path)):
        assert lesson(name, tmp_path).path == path
    with pytest.raises(ValueError, match=r"numbers are 3 to 10.* did you mean '?topic"):
        lesson("topik", tmp_path)
    written(tmp_path, TEXT, "03_again.py")
    with pytest.raises(ValueError, match=r"03_topic.py: 03_again.py has the number 3 already"):
        lessons(tmp_path)


def test_source_lines_are_those_of_the_file() -> None:
    lines = source("shaders/specular.glsl", "float blinn_torrance", lines=3)
    assert lines.text.splitlines()[1] == "{"
    assert lines.text.splitlines()[2] == "    vec3 H = normalize(L + V);"
    assert source("shading/terms.py", "np.maximum(dot(N, L)").text.startswith("return")
    assert "language" not in repr(lines)
    assert f"shaders/specular.glsl, line {lines.line}" in lines._repr_html_()
    with pytest.raises(ValueError, match=r"did you mean '?shaders/light\.glsl"):
        source("shaders/lights.glsl", "x")
    with pytest.raises(ValueError, match=r"0 lines of shaders/light\.glsl contain 'no such words'"):
        source("shaders/light.glsl", "no such words")
