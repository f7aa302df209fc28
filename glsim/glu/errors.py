"""GLU's errors, and its strings."""

from __future__ import annotations

from collections.abc import Iterable

from glsim.glu.constants import NAMES


class GLUError(Exception):
    """A GLU error.  Attributes: err, the code; description, the sentence."""

    def __init__(self, err: int, description: str) -> None:
        super().__init__(err, description)
        self.err, self.description = err, description

    def __str__(self) -> str:
        return f"{self.description} ({STRINGS.get(self.err, self.err)})"


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
}  # fmt: skip


def gluErrorString(error: int) -> bytes | None:
    """What an error code of GL or GLU means; None if it is none."""
    return STRINGS[error].encode() if error in STRINGS else None


def gluGetString(name: int) -> bytes:
    """GLU_VERSION or GLU_EXTENSIONS."""
    strings = {NAMES["GLU_VERSION"]: b"1.3", NAMES["GLU_EXTENSIONS"]: b"GLU_EXT_nurbs_tessellator GLU_EXT_object_space_tess "}
    if name not in strings:
        raise GLUError(NAMES["GLU_INVALID_ENUM"], f"gluGetString: name must be {one_of(strings)}, not {name!r}")
    return strings[name]  # type: ignore[index]


def gluCheckExtension(extName: str | bytes, extString: str | bytes) -> bool:
    """Whether a list of names, such as glGetString(GL_EXTENSIONS), has a name."""
    name, names = (text.encode() if isinstance(text, str) else bytes(text) for text in (extName, extString))
    return name in names.split()
