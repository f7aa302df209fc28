"""Pictures by pyrender: what a Frame draws, physically based.

A Frame holds triangles, materials, lights and cameras of whatever was drawn, a program, a scene or a mesh file, so a
Frame is what is converted (glsim.study.physical; the formulas with their sources: glsim.study.metallic).  ``pictures``
also draws a pyrender.Scene as it is, and ``scene_of`` makes a function of gl commands of one, for the other columns of
a comparison.

What agrees with OpenGL: geometry, camera, culling, two-sided materials, what is unlit, ambient and emitted light,
directional lights, diffuse light, the highlight's place, and its height seen along the normal.  What does not, and
cannot: the highlight has a narrower core and longer tails (GGX); at grazing angles Fresnel's law makes it brighter and
diffuse light darker; every surface reflects at least 4 %, also where k_s is 0; metals tint the highlight in their base
colour.  Shadows are off, as OpenGL has none.  What else differs for a given Frame is said in sentences (``note``).

Colours: OpenGL 1.x shows the numbers of its equation as they are.  pyrender computes the same kind of numbers and, as
the last step of its shader, raises them to the power 1 / 2.2 for the screen.  To compare one equation with the other,
and not a curve with its absence, that step is left out; ``encoded=True`` keeps it, and is what pyrender itself shows.

pyrender draws in a process of its own.  Its last release (0.1.45) uses np.infty, which NumPy 2 lacks, chooses its
platform by the environment variable PYOPENGL_PLATFORM when it is first imported, opens a window where that is not set,
and ends an EGL display that other libraries may share.  In a child process all of that can be mended or borne without
a trace in this one; the price is the start of Python and pyrender, for each call of ``pictures`` and not for each
picture.

Installing: pip install 'glsim[pyrender]'.  pyrender requires PyOpenGL 3.1.0 exactly.  glsim does not use PyOpenGL
itself, and a later one works too: pip install --upgrade PyOpenGL afterwards.
"""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
import tempfile
from collections.abc import Callable, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine.frame import Frame
from glsim.study.physical import physical
from glsim.study.pyrender_child import Job
from glsim.study.pyrender_scene import Drawing, drawing

Pixels = NDArray[np.uint8]


class NoPyrenderError(ImportError):
    """pyrender is not installed, or cannot draw here; the message says what to do."""


def picture(
    what: Any, width: int = 512, height: int = 512, *, samples: int = 0, encoded: bool = False,
    note: Callable[[str], object] | None = None,
) -> Pixels:  # fmt: skip
    """One picture by pyrender: (height, width, 3), top row first.  The arguments are those of ``pictures``."""
    return pictures([what], width, height, samples=samples, encoded=encoded, note=note)[0]


def pictures(
    what: Sequence[Any], width: int = 512, height: int = 512, *, samples: int = 0, encoded: bool = False,
    note: Callable[[str], object] | None = None, timeout: float | None = 300.0,
) -> list[Pixels]:  # fmt: skip
    """Pictures by pyrender, each (height, width, 3), top row first, all from one child process.

    what: Frames, which have their own size, or pyrender.Scenes, drawn width x height pixels large.
    samples: multisampling, 0 for none.  encoded: with pyrender's gamma of 1 / 2.2, see the top of this file.
    note: called with each sentence about what could not be converted.  timeout: seconds for all of them.

    Raises NoPyrenderError if pyrender is missing or cannot open a context, ValueError for what it cannot draw.
    """
    if find_spec("pyrender") is None:
        raise NoPyrenderError("pyrender is not installed: pip install 'glsim[pyrender]'")
    jobs, notes = [], dict[str, None]()
    for one in what:
        if isinstance(one, Frame):
            scene = physical(one)
            notes.update(dict.fromkeys(scene.notes))
            jobs.append(Job(scene, one.width, one.height, samples, encoded))
        elif is_scene(one):
            jobs.append(Job(_pickled(one), width, height, samples, encoded))
        else:
            raise TypeError(f"pyrender draws a Frame or a pyrender.Scene, not {one!r:.80}")
    if note is not None:
        for sentence in notes:
            note(sentence)
    return _drawn(jobs, timeout)


def is_scene(what: Any) -> bool:
    """Whether this is a pyrender.Scene; pyrender is not imported for that."""
    pyrender = sys.modules.get("pyrender")
    return pyrender is not None and isinstance(what, pyrender.Scene)


def scene_of(scene: Any) -> Drawing:
    """A function of gl commands, without arguments, that draws a pyrender.Scene as large as the viewport.

    Its ``notes`` are sentences about what could not be converted.  Raises ValueError if the scene has no camera.
    """
    if not is_scene(scene):
        raise TypeError(f"a pyrender.Scene is needed, not {scene!r:.80}")
    return drawing(scene)


def _pickled(scene: Any) -> bytes:
    try:
        return pickle.dumps(scene)
    except Exception as error:
        raise ValueError(f"this pyrender.Scene cannot be handed to another process: {error}") from None


def _drawn(jobs: list[Job], timeout: float | None) -> list[Pixels]:
    """Run the child for all jobs and read its pictures."""
    environment = dict(os.environ, PYTHONPATH=os.pathsep.join(filter(None, sys.path)))
    if sys.platform.startswith("linux"):
        environment.setdefault("PYOPENGL_PLATFORM", "egl")  # no window
    with tempfile.TemporaryDirectory(prefix="glsim-") as name:
        folder = Path(name)
        (folder / "job").write_bytes(pickle.dumps(jobs))
        command = [sys.executable, "-m", "glsim.study.pyrender_child", name]
        try:
            run = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=timeout, check=False)
        except subprocess.TimeoutExpired:
            raise TimeoutError(f"pyrender has not drawn {len(jobs)} pictures within {timeout:g} s") from None
        if run.returncode:
            failure = folder / "failure"
            said = failure.read_text(encoding="utf-8") if failure.exists() else run.stderr.strip().rpartition("\n")[2]
            if said.startswith("ValueError: "):
                raise ValueError(said.partition(": ")[2])
            raise NoPyrenderError(f"pyrender cannot draw here: {said or f'its process ended with {run.returncode}'}")
        return [np.load(folder / f"{number}.npy") for number in range(len(jobs))]
