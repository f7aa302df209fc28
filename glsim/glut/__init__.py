"""The OpenGL utility toolkit with freeglut's additions: a drop-in for ``OpenGL.GLUT``.

Windows are pictures: ``glsim run`` takes them after each step of a main loop whose order never changes
(see loop.py), or shows them in real windows.
"""

from __future__ import annotations

import ctypes
import logging
import os
import sys
import traceback
from typing import Any

from glsim.glut import api, callbacks, constants, fonts, menus, polyhedra, revolved, state, teaset, windows
from glsim.machine.sentences import explained
from glsim.names import missing

HAVE_FREEGLUT = True
fgDeinitialize = None
globals().update(constants.NAMES)
for _topic in (api, windows, callbacks, state, menus, revolved, polyhedra, teaset, fonts):
    globals().update(
        {
            name: explained(name, value) if name.startswith("glut") else value
            for name, value in vars(_topic).items()
            if name.startswith(("glut", "GLUT_")) and not name.startswith("glut_")
        }
    )
__all__ = [name for name in globals() if name.startswith(("glut", "GLUT_"))] + ["HAVE_FREEGLUT"]
__all__ += [
    "ctypes",
    "logging",
    "os",
    "sys",
    "traceback",
]  # PyOpenGL's star import binds them, and programs call sys.exit


def __getattr__(name: str) -> Any:
    raise missing(__name__, name, __all__)
