"""glsim: how light becomes pixels, to teach and to learn.

    import glsim
    from glsim.gl import *

    screen = glsim.offscreen(512, 512)
    ...                     # glClear, glLightfv, glBegin, ... as in any textbook
    screen.save("picture.png")

Names are imported when they are first used, so that ``import glsim`` is quick.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from glsim.version import __version__ as __version__

if TYPE_CHECKING:
    from glsim.course.source import source as source
    from glsim.machine.frame import Frame as Frame
    from glsim.play.capture import capture as capture
    from glsim.play.capture import program_source as program_source
    from glsim.play.frames import frame_of as frame_of
    from glsim.render.context import Offscreen as Offscreen
    from glsim.render.context import offscreen as offscreen
    from glsim.render.device import NoDeviceError as NoDeviceError
    from glsim.render.recorder import tape as tape
    from glsim.study import plots as plots
    from glsim.study.compare import Comparison as Comparison
    from glsim.study.compare import compare as compare
    from glsim.study.explain import explain as explain
    from glsim.study.export import export as export
    from glsim.study.export import show as show
    from glsim.study.outside import outside as outside
    from glsim.study.probe import Probe as Probe
    from glsim.study.prober import probe as probe
    from glsim.study.terms import Terms as Terms
    from glsim.study.terms import terms as terms
    from glsim.study.trace import trace as trace
    from glsim.study.vectors import vectors as vectors
    from glsim.study.widget import Widget as Widget

_HOME = {
    "offscreen": "glsim.render.context",
    "Offscreen": "glsim.render.context",
    "NoDeviceError": "glsim.render.device",
    "Frame": "glsim.machine.frame",
    "capture": "glsim.play.capture",
    "program_source": "glsim.play.capture",
    "Comparison": "glsim.study.compare",
    "compare": "glsim.study.compare",
    "explain": "glsim.study.explain",
    "export": "glsim.study.export",
    "frame_of": "glsim.play.frames",
    "show": "glsim.study.export",
    "source": "glsim.course.source",
    "outside": "glsim.study.outside",
    "plots": "glsim.study.plots",  # a folder of functions
    "Probe": "glsim.study.probe",
    "probe": "glsim.study.prober",
    "Terms": "glsim.study.terms",
    "tape": "glsim.render.recorder",
    "terms": "glsim.study.terms",
    "trace": "glsim.study.trace",
    "vectors": "glsim.study.vectors",
    "Widget": "glsim.study.widget",
}
__all__ = ["__version__", *_HOME]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        home = import_module(_HOME[name])
        return home if name == "plots" else getattr(home, name)
    from glsim.names import missing

    raise missing(__name__, name, __all__)


def __dir__() -> list[str]:
    return sorted(__all__)
