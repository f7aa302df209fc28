"""What to play, and what happened: what ``glsim run`` and the process of the program tell each other."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

PICTURE = r"frame_\d{3,}(_w\d+)?\.png"  # names of the pictures
MADE_BY = "glsim run"  # what their PNG chunk "Software" says


@dataclass
class Plan:
    """One run of a program: options of ``glsim run``, and the files for its results.

    out: folder for pictures, None for none.  frames: number of steps.  events: one for each step from the second on.
    real_time: the real clock; else time stands still in a step.  count: count the calls of each command.
    python2: convert programs of Python 2.  capture_calls: record the calls in the captured Frame.  capture_each: the
    Frames of all steps, in files whose names end in -0, -1, ...  most_calls: if given, the Frame of the first picture
    is captured instead of the last, if it takes no more calls than these.  clicked: "module:function", called with
    (Frame, x, y) when a pixel of a real window is clicked."""

    script: str
    arguments: list[str] = field(default_factory=list)
    out: str | None = None
    frames: int = 1
    events: list[str] = field(default_factory=list)
    size: tuple[int, int] | None = None
    shade: str | None = None
    lobe: str | None = None
    window: bool = False
    real_time: bool = False
    count: bool = False
    python2: bool = True
    result: str | None = None  # a file for the Record
    stack: str | None = None  # a file for the program's Python stack at the time limit
    capture: str | None = None  # a file for the last picture's Frame
    capture_calls: bool = False
    capture_each: bool = False
    most_calls: int | None = None
    clicked: str | None = None


@dataclass
class Record:
    """What happened: the line of JSON that ``glsim run --json`` prints."""

    status: str = "running"
    frames: int = 0
    pictures: list[str] = field(default_factory=list)
    errors: list[dict[str, Any]] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    calls: dict[str, int] = field(default_factory=dict)
