"""``capture``: the draws of a program as a Frame; ``program_source``: the GLSL of the current state."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np

from glsim.machine.constants import GL_TRIANGLES
from glsim.machine.current import current_machine
from glsim.machine.frame import ROW, Draw, Frame, Vertices
from glsim.machine.record import Recorder


@contextmanager
def capture(calls: bool = False) -> Iterator[Frame]:
    """Collect the packets drawn inside the ``with`` block in a Frame, and draw them as usual.

    Yields the Frame, which is complete when the block ends.  calls: record every call too (``frame.calls``).

        with glsim.capture() as frame:
            draw()
    """
    machine = current_machine()
    machine.flush()
    frame = Frame(machine.device.width, machine.device.height)
    before, recorder = machine.outlet.frame, machine.recorder
    machine.outlet.frame = frame
    if calls:
        machine.record(Recorder(machine, frame))
    try:
        yield frame
        machine.complete()
    finally:
        machine.record(recorder)
        machine.outlet.frame = before
        if before is not None:
            before.packets += frame.packets


def program_source(stage: str | None = None, *, es: bool = False) -> str:
    """The exact GLSL that the present state maps to, for filled triangles: the key as constants, then the sources of
    shaders/.

    stage: "vertex" or "fragment"; None gives both, each under a comment line.  es: the GLSL ES 3.00 that a browser
    compiles; it differs in its first lines, and GL_ES is defined.  Raises ValueError for another stage.
    """
    from glsim.render.key import draw_key
    from glsim.render.programs import sources

    machine = current_machine()
    nothing = Vertices(np.empty((0, ROW), np.float32), {}, [])
    triangles = Draw(GL_TRIANGLES, 0, 0, None, machine.matrices(), machine.material, machine.snapshot(), nothing)
    text = sources(draw_key(triangles), es)
    if stage is None:
        return "\n".join(f"// ---- {name} shader\n{source}" for name, source in text.items())
    if stage not in text:
        raise ValueError(f'program_source: stage must be "vertex" or "fragment", not {stage!r}')
    return text[stage]
