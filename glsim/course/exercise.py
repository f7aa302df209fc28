"""What an exercise is: a statement, a starter, and parts that are asked of the student's file and judged.

The student's file runs in a process of its own (``answering``), which only answers: a function's values, constants,
a Frame.  What is expected, the marks and the hints stay in this process.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.files import data_folder
from glsim.machine.frame import Frame
from glsim.names import did_you_mean

NAME = re.compile(r"(?P<number>\d\d)_(?P<topic>\w+)\.py")


@dataclass(frozen=True)
class Mistake:
    """A typical wrong formula and what to tell a student who used it.

    answer: a function of the same arguments as the right one, which returns what the mistake gives."""

    answer: Callable[..., Any]
    hint: str


@dataclass(frozen=True)
class Call:
    """A part: a function of the student's file is called with each of ``arguments`` and compared with ``expected``.

    about: what the part asks, as in "the cosine of the angle".  arguments: tuples, many of them random, so that no list
    of results passes.  expected: the right function.  tolerance: the largest error that passes, as a share of the
    largest expected number, or of 1 if that is larger.  hint: when the values are wrong and no mistake is
    recognised."""

    about: str
    function: str
    arguments: Sequence[tuple[Any, ...]]
    expected: Callable[..., Any]
    hint: str
    mistakes: Sequence[Mistake] = ()
    points: int = 1
    tolerance: float = 1e-6


@dataclass(frozen=True)
class Value:
    """A part: constants of the student's file.  expected: name -> number or array.

    wrong: name -> a list of (typical wrong value, hint)."""

    about: str
    expected: dict[str, Any]
    hint: str
    wrong: dict[str, Sequence[tuple[Any, str]]] = field(default_factory=dict)
    points: int = 1
    tolerance: float = 1e-6


@dataclass(frozen=True)
class Drawn:
    """A part of a program that draws: ``judge`` looks at the Frame that it recorded, with all calls, and returns a hint
    if something is wrong, None if it is right."""

    about: str
    judge: Callable[[Frame], str | None]
    points: int = 1


@dataclass(frozen=True)
class Picture:
    """A part of a program that draws: its picture, redrawn from its Frame (redrawing.py), must be that of the
    file ``name`` beside the exercise.  hint: when it differs."""

    about: str
    name: str
    hint: str
    points: int = 1


@dataclass(frozen=True, eq=False)  # a part is itself alone: pictures are remembered for it
class Shader:
    """A part in GLSL: a function of shaders/ whose body the student writes; the real shader is compiled with it.

    file: of shaders/, in which ``function`` is replaced.  draw: draws a test picture with the gl commands.  size: of
    the picture.  mistakes: wrong GLSL functions of the same name, as text, with their hints."""

    about: str
    file: str
    function: str
    draw: Callable[[], None]
    hint: str
    size: tuple[int, int] = (128, 128)
    mistakes: Sequence[tuple[str, str]] = ()
    points: int = 1


Part = Call | Value | Drawn | Picture | Shader


@dataclass(frozen=True)
class Definition:
    """What the file of an exercise defines as EXERCISE.

    lesson: its number.  starter: the file that a student begins with; its parts must not all be right.
    ending: of the student's file, ".py" or ".glsl".  program: whether the file is a program that draws."""

    title: str
    lesson: int
    starter: str
    parts: Sequence[Part]
    ending: str = ".py"
    program: bool = False


@dataclass(frozen=True)
class Exercise:
    """An exercise: its file in lessons/exercises, its number, its statement (Markdown) and its definition."""

    path: Path
    number: int
    statement: str
    definition: Definition

    @property
    def name(self) -> str:
        return self.path.stem

    @property
    def title(self) -> str:
        return self.definition.title

    @property
    def heading(self) -> str:
        """What the exercise is called wherever it is named: exercises and lessons have numbers of their own."""
        return f"Exercise {self.number} (lesson {self.definition.lesson}): {self.title}"

    @cached_property
    def points(self) -> int:
        return sum(part.points for part in self.definition.parts)

    @property
    def filename(self) -> str:
        """The name of the student's file."""
        return self.name + self.definition.ending


def read(path: Path) -> Exercise:
    """The exercise in a file.  Raises ValueError for a name that is not NN_topic.py or a file without EXERCISE."""
    name = NAME.fullmatch(path.name)
    if not name:
        raise ValueError(f"{path}: the name of an exercise is NN_topic.py, such as 03_lambert.py")
    spec = spec_from_file_location(f"glsim_exercise_{path.stem}", path)
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    definition = getattr(module, "EXERCISE", None)
    if not isinstance(definition, Definition) or not module.__doc__:
        raise ValueError(f"{path}: an exercise has a docstring, its statement, and a Definition named EXERCISE")
    return Exercise(path, int(name["number"]), module.__doc__.strip(), definition)


def paths(folder: Path | None = None) -> list[Path]:
    """The files of all exercises, in the order of their numbers."""
    folder = folder or data_folder("lessons") / "exercises"
    return [path for path in sorted(folder.glob("*.py")) if NAME.fullmatch(path.name)]


def exercises(folder: Path | None = None) -> list[Exercise]:
    """All exercises of a folder (glsim's own without one), in the order of their numbers."""
    return [read(path) for path in paths(folder)]


def exercise(which: str, folder: Path | None = None) -> Exercise:
    """The exercise with a number ("3") or a name ("lambert", "03_lambert").  Raises ValueError for an unknown one."""
    known = paths(folder)
    for path in known:
        if which in (str(int(path.stem[:2])), path.stem[:2], path.stem, path.stem[3:]):
            return read(path)
    hint = did_you_mean(which, [path.stem[3:] for path in known])
    raise ValueError(f"no exercise {which!r}: glsim exercise list shows all{hint}")


def exercise_of(file: Path, folder: Path | None = None) -> Exercise:
    """The exercise that a student's file belongs to, by its name, which begins with NN_topic.

    Raises ValueError if the name says none."""
    found = [path for path in paths(folder) if file.stem.startswith(path.stem)]
    if not found:
        raise ValueError(
            f"{file.name}: the name says no exercise: keep that of glsim exercise new, or use --exercise N"
        )
    return read(max(found, key=lambda path: len(path.stem)))


def unit_vectors(count: int, seed: int) -> NDArray[np.float64]:
    """Random unit vectors, (count, 3), the same for one seed: arguments for parts."""
    v = np.random.default_rng(seed).normal(size=(count, 3))
    return np.asarray(v / np.linalg.norm(v, axis=1, keepdims=True))


def closed_room(n: int, seed: int) -> tuple[NDArray[np.float64], ...]:
    """A random closed room of ``n`` plane patches, the same for one seed: arguments for parts.

    Returns the form factors F (n, n), whose rows sum to 1 and obey reciprocity, the areas (n,), the reflectances
    (n, 3) and the emitted radiosities (n, 3), of which at least the first patch's is not 0."""
    rng = np.random.default_rng(seed)
    areas = rng.uniform(0.5, 3.0, n)
    upper = np.triu(rng.uniform(0.1, 1.0, (n, n)), 1)
    symmetric = upper + upper.T
    for _ in range(200):
        symmetric *= np.sqrt(np.outer(areas / symmetric.sum(axis=1), areas / symmetric.sum(axis=0)))
    rho = rng.uniform(0.1, 0.9, (n, 3))
    emitted = rng.uniform(0.0, 2.0, (n, 3)) * (rng.random((n, 1)) < 0.4)
    emitted[0] = (1.0, 0.8, 0.5)
    return symmetric / areas[:, None], areas, rho, emitted
