"""The OpenGL utility library, GLU 1.3: a drop-in for ``OpenGL.GLU``."""

from __future__ import annotations

from typing import Any

from glsim.glu import constants, cylinder, disc, errors, images, nurbs, nurbsobject, quadric, sphere, tess, view
from glsim.glu.errors import GLUError as GLUError
from glsim.glu.errors import GLUWarning as GLUWarning
from glsim.machine.sentences import explained
from glsim.names import missing

GLUerror = GLUError  # PyOpenGL's names
GLUquadric = GLUQuadric = GLUquadricObj = quadric.Quadric
GLUtesselator = GLUtesselatorObj = GLUtriangulatorObj = tess.Tessellator
GLUnurbs = GLUnurbsObj = nurbsobject.Nurbs
globals().update(constants.NAMES)
GLU_TESS_MAX_COORD = constants.GLU_TESS_MAX_COORD
for _topic in (errors, images, nurbs, quadric, cylinder, disc, sphere, tess, view):
    globals().update(
        {
            name: explained(name, value)
            for name, value in vars(_topic).items()
            if name.startswith("glu") and name[3].isupper()
        }
    )

__all__ = [name for name in globals() if name.startswith("GLU") or (name[:3] == "glu" and name[3:4].isupper())]


def __getattr__(name: str) -> Any:
    raise missing(__name__, name, __all__)
