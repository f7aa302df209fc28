"""GLU's errors, and its strings."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Iterable

from glsim.glu.constants import NAMES
from glsim.machine.sentences import PACKAGE


class GLUError(Exception):
    """A GLU error.  Attributes: err, the code; description, the sentence."""

    def __init__(self, err: int, description: str) -> None:
        super().__init__(err, description)
        self.err, self.description = err, description

    def __str__(self) -> str:
        return f"{self.description} ({STRINGS.get(self.err, self.err)})"


class GLUWarning(UserWarning):
    """An error that GLU keeps to itself where the program set no error callback."""


def warn(code: int, sentence: str) -> None:
    """Issue a GLUWarning for the program's line: the call has no effect, and the program continues."""
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and frame.f_code.co_filename.startswith(PACKAGE):
        level, frame = level + 1, frame.f_back
    sentence = f"{sentence} ({STRINGS.get(code, code)}); the call has no effect"
    warnings.warn(sentence, GLUWarning, stacklevel=level)


def one_of(choices: Iterable[int]) -> str:
    """Constants as a message names them: GLU_FLAT, GLU_SMOOTH or GLU_NONE."""
    *first, last = map(repr, choices)
    return f"{', '.join(first)} or {last}" if first else last


STRINGS = {
    0: "no error", 1280: "invalid enumerant", 1281: "invalid value", 1282: "invalid operation", 1283: "stack overflow",
    1284: "stack underflow", 1285: "out of memory", 100900: "invalid enumerant", 100901: "invalid value",
    100902: "out of memory", 100903: "incompatible gl version", 100904: "invalid operation",
    100151: "gluTessBeginPolygon() must precede a gluTessEndPolygon()",
    100152: "gluTessBeginContour() must precede a gluTessEndContour()",
    100153: "gluTessEndPolygon() must follow a gluTessBeginPolygon()",
    100154: "gluTessEndContour() must follow a gluTessBeginContour()", 100155: "a coordinate is too large",
    100156: "need combine callback", 1286: "invalid framebuffer operation",
    100251: "spline order un-supported",
    100252: "too few knots",
    100253: "valid knot range is empty",
    100254: "decreasing knot sequence knot",
    100255: "knot multiplicity greater than order of spline",
    100256: "gluEndCurve() must follow gluBeginCurve()",
    100257: "gluBeginCurve() must precede gluEndCurve()",
    100258: "missing or extra geometric data",
    100259: "can't draw piecewise linear trimming curves",
    100260: "missing or extra domain data",
    100261: "missing or extra domain data",
    100262: "gluEndTrim() must precede gluEndSurface()",
    100263: "gluBeginSurface() must precede gluEndSurface()",
    100264: "curve of improper type passed as trim curve",
    100265: "gluBeginSurface() must precede gluBeginTrim()",
    100266: "gluEndTrim() must follow gluBeginTrim()",
    100267: "gluBeginTrim() must precede gluEndTrim()",
    100268: "invalid or missing trim curve",
    100269: "gluBeginTrim() must precede gluPwlCurve()",
    100270: "piecewise linear trimming curve referenced twice",
    100271: "piecewise linear trimming curve and nurbs curve mixed",
    100272: "improper usage of trim data type",
    100273: "nurbs curve referenced twice",
    100274: "nurbs curve and piecewise linear trimming curve mixed",
    100275: "nurbs surface referenced twice",
    100276: "invalid property",
    100277: "gluEndSurface() must follow gluBeginSurface()",
    100278: "intersecting or misoriented trim curves",
    100279: "intersecting trim curves",
    100280: "UNUSED",
    100281: "unconnected trim curves",
    100282: "unknown knot error",
    100283: "negative vertex count encountered",
    100284: "negative byte-stride encounteed",
    100285: "unknown type descriptor",
    100286: "null control point reference",
    100287: "duplicate point on piecewise linear trimming curve",
}  # fmt: skip


def gluErrorString(error: int) -> bytes | None:
    """What an error code of GL or GLU means; None if it is none."""
    return STRINGS[error].encode() if error in STRINGS else None


def gluGetString(name: int) -> bytes:
    """GLU_VERSION or GLU_EXTENSIONS."""
    strings = {
        NAMES["GLU_VERSION"]: b"1.3",
        NAMES["GLU_EXTENSIONS"]: b"GLU_EXT_nurbs_tessellator GLU_EXT_object_space_tess ",
    }
    if name not in strings:
        raise GLUError(NAMES["GLU_INVALID_ENUM"], f"gluGetString: name must be {one_of(strings)}, not {name!r}")
    return strings[name]  # type: ignore[index]


def gluCheckExtension(extName: str | bytes, extString: str | bytes) -> bool:
    """Whether the name ``extName`` is in ``extString``, a list such as glGetString(GL_EXTENSIONS)."""
    name, names = (text.encode() if isinstance(text, str) else bytes(text) for text in (extName, extString))
    return name in names.split()
