"""``from OpenGL.GL import *`` and its like bind what PyOpenGL 3.1.10 binds, name by name."""

from __future__ import annotations

import json
import subprocess
import sys
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

import pytest

REFERENCE = Path(__file__).parents[1] / "reference"
THEIRS: dict[str, dict[str, int | str]] = json.loads((REFERENCE / "star_imports.json").read_text())

# Each name that PyOpenGL binds and glsim does not, with its reason.
MISSING = {
    "GL": {},
    "GLU": {},
    "GLUT": {
        **dict.fromkeys(("PLATFORM", "GLUT"), "the loaded C library, which glsim does not have"),
        **dict.fromkeys(
            ("GLUTCallback", "GLUTTimerCallback", "GLUTMenuCallback"), "PyOpenGL's ctypes wrappers of C callbacks"
        ),
    },
}
# Each name that glsim binds and PyOpenGL does not, with its reason.
ADDED = {
    "GL": {
        **dict.fromkeys(
            (
                "GL_PHONG_WIN", "GL_PHONG_HINT_WIN", "GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM", "GL_BLINN_TORRANCE_GLSIM",
                "GL_PHONG_LOBE_GLSIM", "GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM", "GL_CLAMP_NORMAL_GLSIM",
                "GL_FLIP_NORMAL_GLSIM", "GL_AFFINE_GLSIM",
            ),
            "glsim's extensions",
        ),
        "GL_ALL_CLIENT_ATTRIB_BITS": "OpenGL 1.1's header has it",
        **dict.fromkeys(("GLfloat_16", "GLdouble_16"), "for matrices, beside GLfloat_4"),
    },
    "GLU": {"GLUWarning": "an error that no callback took"},
    "GLUT": {},
}  # fmt: skip


def ours() -> dict[str, dict[str, Any]]:
    """What a program gets, in a process of its own."""
    code = (
        "import json, sys; from glsim.play import pyopengl; pyopengl.install()\n"
        f"sys.path.insert(0, {str(REFERENCE)!r}); from pyopengl_names import bound; print(json.dumps(bound()))"
    )
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return json.loads(ended.stdout)  # type: ignore[no-any-return]


@pytest.fixture(scope="module")
def names() -> dict[str, dict[str, Any]]:
    return ours()


@pytest.mark.parametrize("library", ["GL", "GLU", "GLUT"])
def test_every_name_of_pyopengl_is_there(library: str, names: dict[str, dict[str, Any]]) -> None:
    missing = sorted(set(THEIRS[library]) - set(names[library]))
    assert missing == sorted(MISSING[library])
    added = {n for n in set(names[library]) - set(THEIRS[library]) if not (n[:2] == "gl" and n[2:3].isupper())}
    assert {n for n in added if not n.startswith("glut")} == set(ADDED[library])


@pytest.mark.parametrize("library", ["GL", "GLU", "GLUT"])
def test_names_mean_the_same(library: str, names: dict[str, dict[str, Any]]) -> None:
    """Constants have the same numbers, and modules, classes and functions are of their kind."""
    for name, theirs in THEIRS[library].items():
        if name in names[library] and (isinstance(theirs, int) or theirs == "module"):
            assert names[library][name] == theirs, name
        elif name in names[library] and theirs == "function":
            assert names[library][name] in ("function", "class"), name


def test_the_list_is_pyopengls() -> None:
    """With PyOpenGL 3.1.10 at hand, the list of names is made again and compared."""
    try:
        installed = version("PyOpenGL")
    except PackageNotFoundError:
        pytest.skip("PyOpenGL is not installed; the list of its names is that of 3.1.10")
    if installed != "3.1.10":
        pytest.skip(f"PyOpenGL {installed} is installed; the list of names is that of 3.1.10")
    ended = subprocess.run(
        [sys.executable, "-c", "import json; from pyopengl_names import bound; print(json.dumps(bound()))"],
        cwd=REFERENCE, capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert json.loads(ended.stdout) == THEIRS


def test_what_came_later_says_so() -> None:
    from glsim.play.starnames import later_names

    content = later_names()
    assert not content["glCreateShader"]
    with pytest.raises(RuntimeError, match=r"glCreateShader came with OpenGL 2\.0; glsim emulates"):
        content["glCreateShader"](35633)
    with pytest.raises(RuntimeError, match="glColorTable is of an extension"):
        content["glColorTable"]()
    assert content["glInitGl15VERSION"]()
    assert not content["glInitGl20VERSION"]()
    assert content["GL_VERTEX_SHADER"] == 35633
    assert repr(content["GL_VERTEX_SHADER"]) == "GL_VERTEX_SHADER"
