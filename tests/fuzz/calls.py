"""Random calls: what is called, with which arguments, and what may be said about it.

Enumerants are learned: one that a command's argument accepted, or that a command's sentence names, is tried there more
often than others, so that calls reach deep into the state.
"""

from __future__ import annotations

import inspect
import re
import time
import warnings
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator
from random import Random
from typing import Any, NamedTuple

import numpy as np

from glsim import gl, glu, glut
from glsim.glut.api import settings
from glsim.glut.loop import loop
from glsim.machine.commands import COMMANDS
from glsim.machine.record import moment
from glsim.machine.sentences import is_a_sentence
from tests.fuzz.values import data, number, odd_data, odd_number

# Words of NumPy, ctypes, struct, Pillow and Python itself: a sentence that has one is not ours.
FOREIGN = """
could not convert|setting an array element|inhomogeneous|ufunc|broadcast|cannot reshape|dtype|array of size
only integer scalar|only length-1|only size-1|a number is required|required argument|buffer is too small|shape mismatch
cannot cast|out of bounds|invalid literal|must be real number|not supported between|object is not|has no attribute
unhashable|cannot convert float|to unpack|positional argument|argument after|bytes-like|int too large|int too big
index out of range|list indices|incompatible types|unsupported operand|cannot be interpreted
not iterable|not subscriptable|not callable|buffer size|can't|NoneType|new type|itemsize|ndarray is not
maximum supported
math domain|float division|divide by zero|negative shift|too many indices|C-contiguous|truth value|Unable to allocate
argument must be|Overflow|out of range for|unsized|underlying buffer|zero-dimensional|0-d|codec|format requires
"""
TELLTALES = re.compile("|".join(re.escape(p) for line in FOREIGN.split("\n") if line for p in line.split("|")), re.I)
GL_NAME = re.compile(r"\bGLU?T?_[A-Z0-9_]+\b")
# Not called: they run the main loop or end the program.
LEFT_OUT = {"glutMainLoop", "glutMainLoopEvent", "glutCheckLoop", "glutExit"}
ENUM_WORDS = {
    "target", "pname", "mode", "type", "format", "which", "face", "cap", "state", "draw", "normal", "orientation",
    "internalFormat", "typeIn", "typeOut", "property", "option", "displayMode",
}  # fmt: skip
PIECES = {"num_levels", "slices", "stacks", "loops", "nSides", "nRings"}  # large ones take a shape's time and memory
DATA_WORDS = {
    "v", "v1", "v2", "params", "pixels", "data", "m", "points", "array", "pointer", "indices", "dataIn", "dataOut",
    "model", "proj", "view", "perspective", "location", "viewport", "offset", "string", "lists", "knots",
}  # fmt: skip


class Callee(NamedTuple):
    """A function and its arguments: (name, kind); kinds are the command table's, and a few for objects."""

    name: str
    function: Callable[..., Any]
    arguments: tuple[tuple[str, str], ...]


def kind_of(name: str, word: str) -> str:
    """What a parameter of a function without a row in the table takes, by its name."""
    if word in ("quad", "nurb", "tess", "font"):
        return word
    if word in ("callback", "function", "CallBackFunc"):
        return "callback"
    if word in DATA_WORDS:
        return "data"
    return "enum" if word in ENUM_WORDS else ("i" if name.startswith("glut") else "f")


def callees() -> Iterator[Callee]:
    """Every function of the three libraries that can be called without a main loop."""
    for module in (gl, glu, glut):
        for name in module.__all__:
            function = getattr(module, name)
            if not callable(function) or not re.match(r"gl(u|ut)?[A-Z]", name) or name in LEFT_OUT:
                continue
            if name in COMMANDS:
                yield Callee(name, function, COMMANDS[name].arguments)
                continue
            parameters = inspect.signature(function).parameters.values()
            words = [p.name for p in parameters if p.kind is p.POSITIONAL_OR_KEYWORD]
            if any(p.kind is p.VAR_POSITIONAL for p in parameters):
                family = next((c for c in COMMANDS.values() if name in (c.family, c.name)), None)
                extra = family.arguments if family else tuple((f"a{k}", "any") for k in range(4))
                yield Callee(name, function, (*((word, kind_of(name, word)) for word in words), *extra))
            else:
                yield Callee(name, function, tuple((word, kind_of(name, word)) for word in words))


def accepted(name: str, error: BaseException) -> str:
    """Empty for an exception that a program may get, else what is wrong with it."""
    allowed = (gl.GLError, glu.GLUError, TypeError, ValueError, *((RuntimeError,) if name.startswith("glut") else ()))
    if not isinstance(error, allowed):
        return type(error).__name__
    sentence = str(error)
    names = "gl[A-Z]\\w+" if name.startswith("glCallList") else f"{name}v?"  # what is called; glGetFloat is glGetFloatv
    if not re.match(f"{names}: ", sentence):
        return "without the command's name"
    said = re.split(r", not |made of numbers|do not go together|not enough memory for", sentence)[
        0
    ]  # then come the program's own values
    return "foreign words" if TELLTALES.search(said) else ""


class Report:
    """What came of the calls: how many, exceptions by type, and what should not be with one example each."""

    def __init__(self) -> None:
        self.calls = 0
        self.raised: Counter[str] = Counter()
        self.wrong: Counter[str] = Counter()
        self.examples: dict[tuple[str, str], str] = {}
        self.tally: Counter[tuple[str, str]] = Counter()

    def note(self, what: str, place: str, example: str) -> None:
        self.wrong[what] += 1
        self.tally[what, place] += 1
        self.examples.setdefault((what, place), example)

    def __str__(self) -> str:
        lines = [f"{self.calls} calls; " + ", ".join(f"{n} {kind}" for kind, n in self.raised.most_common())]
        lines += [f"wrong: {count} {what}" for what, count in self.wrong.most_common()]
        for (what, place), count in self.tally.most_common():
            lines.append(f"{count:6} {what} at {place}: {self.examples[what, place]}")
        return "\n".join(lines)


class Fuzz:
    """Rounds of random calls in a window of GLUT without a screen.  The same seed makes the same calls."""

    LONG = 10.0  # seconds that no call may take

    def __init__(self, seed: int) -> None:
        self.random = Random(seed)
        self.open_window()
        self.report = Report()
        self.families: dict[str, list[Callee]] = defaultdict(list)
        for callee in callees():
            command = COMMANDS.get(callee.name)
            self.families[command.family if command else callee.name].append(callee)
        self.names = sorted(self.families)
        self.enums = sorted(
            {int(getattr(module, n)) for module in (gl, glu, glut) for n in module.__all__ if GL_NAME.match(n)
             and isinstance(getattr(module, n), int)}
        )  # fmt: skip
        self.known: dict[tuple[str, str], set[int]] = defaultdict(set)  # by family and argument
        self.objects = {
            "quad": glu.gluNewQuadric(), "nurb": glu.gluNewNurbsRenderer(), "tess": glu.gluNewTess(),
            "font": glut.GLUT_BITMAP_8_BY_13,
        }  # fmt: skip
        warnings.simplefilter("always")
        warnings.showwarning = self._warned
        self.expected = self.canonical()

    def open_window(self) -> None:
        settings.size, settings.place, settings.mode = (64, 64), (0, 0), 0
        self.window = loop.windows[glut.glutCreateWindow("fuzz")]

    def _warned(self, message: Any, category: Any, filename: str, lineno: int, *rest: Any) -> None:
        if not issubclass(category, glu.GLUWarning):
            self.report.note(
                f"warning {category.__name__}", f"{filename.partition('glsim/')[2]}:{lineno}", str(message)
            )

    # ------------------------------------------------------------ arguments

    def enum(self, family: str, argument: str) -> Any:
        known = self.known[family, argument]
        if known and self.random.random() < 0.85:
            return self.random.choice(sorted(known))
        return self.random.choice(self.enums) if self.random.random() < 0.9 else self.random.randint(0, 70000)

    def argument(self, family: str, name: str, kind: str, odd: bool) -> Any:
        random = self.random
        length = random.choice([1, 2, 3, 4, 4, 4, 8, 16, 16, 64, 1024])
        if kind == "any":
            kind = random.choice(["enum", "f", "i", "data"])
        if odd and name not in PIECES:
            return odd_data(random, length) if kind == "data" else odd_number(random, kind not in ("f", "d"))
        if kind == "enum":
            return self.enum(family, name)
        if kind == "data":
            return data(random, length)
        if name in PIECES:
            return random.randint(-1, 4) if name == "num_levels" else number(random, True)
        if kind == "callback":
            return random.choice([None, lambda *a: None])
        if kind == "bitfield":
            return random.randrange(1 << 20)
        return self.objects[kind] if kind in self.objects else number(random, kind not in ("f", "d"))

    # ------------------------------------------------------------ calls

    def call(self, callee: Callee, oddness: float) -> bool:
        """One call; whether it raised."""
        report, random, family = self.report, self.random, callee.name
        command = COMMANDS.get(callee.name)
        if command:
            family = command.family
        given = [self.argument(family, n, kind, random.random() < oddness) for n, kind in callee.arguments]
        report.calls += 1
        before = moment(self.machine, 0)[1:] if command else None
        start = time.perf_counter()
        try:
            callee.function(*given)
        except Exception as error:
            self.learn(family, callee, given, error)
            report.raised[type(error).__name__] += 1
            wrong = accepted(callee.name, error)
            if wrong:
                report.note(wrong, origin(error), f"{callee.name}{shown(given)}: {str(error)[:200]}")
            if (
                before is not None
                and family not in ("glCallList", "glCallLists")
                and moment(self.machine, 0)[1:] != before
            ):
                report.note("half-done", callee.name, f"{callee.name}{shown(given)}: {error}")
            return True
        else:
            for (argument, kind), value in zip(callee.arguments, given, strict=False):
                if kind == "enum" and type(value) is int:
                    self.known[family, argument].add(value)
            return False
        finally:
            if loop.current is None:
                self.open_window()
            if time.perf_counter() - start > self.LONG:
                report.note("slow", callee.name, f"{callee.name}{shown(given)}: {time.perf_counter() - start:.1f} s")

    def learn(self, family: str, callee: Callee, given: list[Any], error: Exception) -> None:
        """What comes before the argument that a sentence blames was accepted; the names in it would be."""
        sentence = str(error).partition(": ")[2]
        for argument, _ in callee.arguments:
            if sentence.startswith(argument + " "):
                names = (
                    getattr(gl, n, getattr(glu, n, None)) for n in GL_NAME.findall(sentence.partition(", not ")[0])
                )
                self.known[family, argument].update(int(n) for n in names if isinstance(n, int))
                for (before, its_kind), value in zip(callee.arguments, given, strict=False):
                    if before == argument:
                        break
                    if its_kind == "enum" and type(value) is int:
                        self.known[family, before].add(value)

    @property
    def machine(self) -> Any:
        return loop.current.screen.machine if loop.current else self.window.screen.machine

    def round(self, calls: int) -> None:
        """Some calls from the initial state, then the canonical picture if one of them raised."""
        self.window.screen.reset()
        oddness = self.random.choice([0.0, 0.02, 0.3])
        raised = [
            self.call(self.random.choice(self.families[self.random.choice(self.names)]), oddness) for _ in range(calls)
        ]
        try:
            self.tidy()
        except Exception as error:
            if not is_a_sentence(error):
                self.report.note("at the flush: " + type(error).__name__, origin(error), str(error)[:200])
        if any(raised):
            found = self.canonical()
            if not np.array_equal(found, self.expected):
                self.report.note(
                    "picture", f"round of call {self.report.calls}", f"{(found != self.expected).sum()} bytes"
                )

    def tidy(self) -> None:
        """Draw what is left, and go back to the one window."""
        machine = self.machine
        machine.inside = machine.compiling = None
        machine.record(None)
        try:
            loop.current.screen.pixels()
        finally:
            if self.window.ident not in loop.windows:
                self.open_window()
            for other in [number for number in loop.windows if number != self.window.ident]:
                loop.close(other)
            loop.choose(self.window)
            settings.size, settings.mode, self.window.asked = (64, 64), 0, (64, 64)

    # ------------------------------------------------------------ the canonical picture

    def canonical(self) -> Any:
        """A small scene with something of everything, from the initial state."""
        screen = self.window.screen
        screen.reset()
        screen.make_current()
        gl.glClearColor(0.1, 0.2, 0.3, 1.0)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT | gl.GL_STENCIL_BUFFER_BIT)
        gl.glEnable(gl.GL_DEPTH_TEST)
        gl.glPushAttrib(gl.GL_ALL_ATTRIB_BITS)
        gl.glEnable(gl.GL_LIGHTING)
        gl.glEnable(gl.GL_LIGHT0)
        gl.glMaterialfv(gl.GL_FRONT, gl.GL_SPECULAR, [0.5, 0.5, 0.5, 1.0])
        gl.glTranslatef(-0.4, 0.3, 0.0)
        glu.gluSphere(glu.gluNewQuadric(), 0.4, 12, 8)
        gl.glPopAttrib()
        texels = (np.arange(4 * 4 * 4) * 37 % 256).astype(np.uint8)
        gl.glTexImage2D(gl.GL_TEXTURE_2D, 0, gl.GL_RGBA, 4, 4, 0, gl.GL_RGBA, gl.GL_UNSIGNED_BYTE, texels)
        gl.glTexParameteri(gl.GL_TEXTURE_2D, gl.GL_TEXTURE_MIN_FILTER, gl.GL_NEAREST)
        gl.glEnable(gl.GL_TEXTURE_2D)
        gl.glBegin(gl.GL_TRIANGLE_STRIP)
        for s, t in ((0, 0), (1, 0), (0, 1), (1, 1)):
            gl.glTexCoord2f(s, t)
            gl.glVertex2f(0.5 + 0.8 * s, -1 + 0.9 * t)
        gl.glEnd()
        gl.glDisable(gl.GL_TEXTURE_2D)
        gl.glLineWidth(3)
        gl.glColor3f(1, 1, 0)
        gl.glBegin(gl.GL_LINES)
        gl.glVertex2f(-0.5, -0.9)
        gl.glVertex2f(0.3, 0.2)
        gl.glEnd()
        gl.glRasterPos2f(-0.4, -1.2)
        gl.glBitmap(8, 8, 0, 0, 0, 0, bytes([255, 129, 129, 153, 153, 129, 129, 255]))
        gl.glDrawPixels(2, 2, gl.GL_RGB, gl.GL_UNSIGNED_BYTE, bytes(range(0, 240, 20)) + bytes(4))
        return screen.pixels()


def shown(given: list[Any]) -> str:
    """Arguments as a line."""
    words = []
    for value in given:
        text = repr(value).replace("\n", " ")
        if isinstance(value, np.ndarray):
            text = f"<array {value.dtype} {value.shape} strides {value.strides}>"
        words.append(text if len(text) < 50 else text[:47] + "...")
    return f"({', '.join(words)})"


def origin(error: BaseException) -> str:
    """File, line and function where an exception came from, of glsim's the innermost; through its cause."""
    place, trace = "?", (error.__cause__ or error.__context__ or error).__traceback__
    while trace is not None:
        code = trace.tb_frame.f_code
        if "glsim/" in code.co_filename:
            place = f"{code.co_filename.rpartition('glsim/')[2]}:{trace.tb_lineno} {code.co_name}"
        trace = trace.tb_next
    return place
