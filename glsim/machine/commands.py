"""The one table: every command of OpenGL 1.0-1.5, once.

A row states a command's name, its arguments with their C types, its suffix variants, whether it is legal between
glBegin and glEnd and whether a display list records it.  From the table come the public functions of ``glsim.gl``,
the hot immediate-mode code (``glsim/gl/immediate.py``), the type stubs, the call recorder and the replay on the
platform's own fixed function (``glsim.render.native``).

Argument types are the letters of the specification's suffixes (Table 2.1 of OpenGL 1.5) and a few more:
``b s i f d ub us ui`` numbers, ``enum``, ``bitfield``, ``boolean``, ``sizei``, ``data`` (an array or a buffer).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from glsim.machine import constants

NUMBERS = ("b", "s", "i", "f", "d", "ub", "us", "ui")


class Command(NamedTuple):
    """One row of the table after its suffix variants were spelled out: one public function."""

    name: str  # as called: "glVertex3fv"
    family: str  # without suffix: "glVertex"
    arguments: tuple[tuple[str, str], ...]  # (name, type) in order; a vector is one argument of type "data"
    type: str = ""  # component type of a suffix variant: "f"
    size: int = 0  # number of components; 0: as many as the parameter named by pname has
    vector: bool = False  # the v suffix
    inside: bool = False  # legal between glBegin and glEnd
    listed: bool = True  # recorded by a display list
    result: str = ""  # type of what it returns, "" for nothing

    @property
    def parameters(self) -> tuple[str, ...]:
        return tuple(name for name, _ in self.arguments)


def _arguments(text: str) -> tuple[tuple[str, str], ...]:
    """'light:enum pname:enum' -> (("light", "enum"), ("pname", "enum")); the type of a bare name is float."""
    pairs = (word.partition(":") for word in text.split())
    return tuple((name, kind or "f") for name, _, kind in pairs)


def _command(name: str, arguments: str = "", **row: object) -> Iterator[Command]:
    yield Command(name, name, _arguments(arguments), **row)  # type: ignore[arg-type]


def _components(
    name: str, sizes: str, types: str, names: str, before: str = "", scalar: bool = True, **row: object
) -> Iterator[Command]:
    """glVertex{2,3,4}{s,i,f,d}[v]: as many numbers as the digit says, or one vector of them."""
    first = _arguments(before)
    for size in map(int, sizes.split()):
        digit = str(size) if len(sizes.split()) > 1 or name in _DIGIT_ALWAYS else ""
        for kind in types.split():
            numbers = tuple((argument, kind) for argument in names.split()[:size])
            if scalar:
                yield Command(f"{name}{digit}{kind}", name, first + numbers, kind, size, False, **row)  # type: ignore[arg-type]
            yield Command(f"{name}{digit}{kind}v", name, (*first, ("v", "data")), kind, size, True, **row)  # type: ignore[arg-type]


def _numbers(name: str, types: str, arguments: str, **row: object) -> Iterator[Command]:
    """glTranslate{f,d}: scalar variants only; ``arguments`` without a type are of the variant's type."""
    for kind in types.split():
        typed = tuple(
            (word, t if ":" in pair else kind)
            for pair, (word, t) in zip(arguments.split(), _arguments(arguments), strict=True)
        )
        yield Command(f"{name}{kind}", name, typed, kind, len(typed), **row)  # type: ignore[arg-type]


def _parameter(name: str, types: str, arguments: str, vector: str = "", **row: object) -> Iterator[Command]:
    """glLight{f,i}[v]: a named parameter, one number or as many as the parameter has."""
    first = _arguments(arguments)
    for kind in types.split():
        yield Command(f"{name}{kind}", name, (*first, ("param", kind)), kind, 1, False, **row)  # type: ignore[arg-type]
    for kind in (vector or types).split():
        yield Command(f"{name}{kind}v", name, (*first, ("params", "data")), kind, 0, True, **row)  # type: ignore[arg-type]


def _get(name: str, types: str, arguments: str) -> Iterator[Command]:
    """glGetLight{f,i}v: in Python the answer is returned."""
    for kind in types.split():
        yield Command(f"{name}{kind}v", name, _arguments(arguments), kind, 0, True, listed=False, result="data")


_DIGIT_ALWAYS = {"glNormal", "glSecondaryColor", "glEvalCoord"}
_ARRAY = "size:i type:enum stride:sizei pointer:data"
_IMAGE = "format:enum type:enum pixels:data"


def _vertices() -> Iterator[Iterator[Command]]:
    """Sections 2.6 and 2.7: Begin/End, vertex specification."""
    yield _command("glBegin", "mode:enum", inside=True)  # inside: it reports the nesting itself
    yield _command("glEnd", inside=True)
    yield _components("glVertex", "2 3 4", "s i f d", "x y z w", inside=True)
    yield _components("glNormal", "3", "b s i f d", "nx ny nz", inside=True)
    yield _components("glColor", "3 4", "b s i f d ub us ui", "red green blue alpha", inside=True)
    yield _components("glSecondaryColor", "3", "b s i f d ub us ui", "red green blue", inside=True)
    yield _components("glTexCoord", "1 2 3 4", "s i f d", "s t r q", inside=True)
    yield _components("glMultiTexCoord", "1 2 3 4", "s i f d", "s t r q", "target:enum", inside=True)
    yield _components("glFogCoord", "1", "f d", "coord", inside=True)
    yield _components("glIndex", "1", "s i f d ub", "c", inside=True)
    yield _command("glEdgeFlag", "flag:boolean", inside=True)
    yield _command("glEdgeFlagv", "flag:data", inside=True)


def _arrays() -> Iterator[Iterator[Command]]:
    """Sections 2.8 and 2.9: vertex arrays, buffer objects."""
    for array in ("glVertexPointer", "glColorPointer", "glTexCoordPointer", "glSecondaryColorPointer"):
        yield _command(array, _ARRAY, listed=False)
    for array in ("glNormalPointer", "glIndexPointer", "glFogCoordPointer"):
        yield _command(array, "type:enum stride:sizei pointer:data", listed=False)
    yield _command("glEdgeFlagPointer", "stride:sizei pointer:data", listed=False)
    yield _command("glEnableClientState", "array:enum", listed=False)
    yield _command("glDisableClientState", "array:enum", listed=False)
    yield _command("glClientActiveTexture", "texture:enum", listed=False)
    yield _command("glInterleavedArrays", "format:enum stride:sizei pointer:data", listed=False)
    yield _command("glArrayElement", "i:i", inside=True)
    yield _command("glDrawArrays", "mode:enum first:i count:sizei")
    yield _command("glMultiDrawArrays", "mode:enum first:data count:data primcount:sizei")
    yield _command("glDrawElements", "mode:enum count:sizei type:enum indices:data")
    yield _command("glMultiDrawElements", "mode:enum count:data type:enum indices:data primcount:sizei")
    yield _command("glDrawRangeElements", "mode:enum start:ui end:ui count:sizei type:enum indices:data")
    yield _command("glBindBuffer", "target:enum buffer:ui", listed=False)
    yield _command("glDeleteBuffers", "n:sizei buffers:data", listed=False)
    yield _command("glGenBuffers", "n:sizei", listed=False, result="ui")
    yield _command("glBufferData", "target:enum size:sizei data:data usage:enum", listed=False)
    yield _command("glBufferSubData", "target:enum offset:sizei size:sizei data:data", listed=False)
    yield _command("glGetBufferSubData", "target:enum offset:sizei size:sizei data:data", listed=False, result="data")
    yield _command("glMapBuffer", "target:enum access:enum", listed=False, result="data")
    yield _command("glUnmapBuffer", "target:enum", listed=False, result="boolean")
    yield _command("glIsBuffer", "buffer:ui", listed=False, result="boolean")
    yield _get("glGetBufferParameter", "i", "target:enum pname:enum")
    yield _command("glGetBufferPointerv", "target:enum pname:enum", listed=False, result="data")


def _transformations() -> Iterator[Iterator[Command]]:
    """Sections 2.10 to 2.13: rectangles, coordinate transformations, clipping, the current raster position."""
    yield _numbers("glRect", "s i f d", "x1 y1 x2 y2")
    for kind in ("s", "i", "f", "d"):
        yield iter((Command(f"glRect{kind}v", "glRect", (("v1", "data"), ("v2", "data")), kind, 2, True),))
    yield _command("glDepthRange", "zNear:d zFar:d")
    yield _command("glViewport", "x:i y:i width:sizei height:sizei")
    yield _command("glMatrixMode", "mode:enum")
    for kind in ("f", "d"):
        for matrix in ("glLoadMatrix", "glMultMatrix", "glLoadTransposeMatrix", "glMultTransposeMatrix"):
            yield iter((Command(matrix + kind, matrix, (("m", "data"),), kind, 16, True),))
    yield _command("glLoadIdentity")
    yield _numbers("glRotate", "f d", "angle x y z")
    yield _numbers("glTranslate", "f d", "x y z")
    yield _numbers("glScale", "f d", "x y z")
    yield _command("glFrustum", "left:d right:d bottom:d top:d zNear:d zFar:d")
    yield _command("glOrtho", "left:d right:d bottom:d top:d zNear:d zFar:d")
    yield _command("glActiveTexture", "texture:enum")
    yield _command("glPushMatrix")
    yield _command("glPopMatrix")
    yield _command("glEnable", "cap:enum")
    yield _command("glDisable", "cap:enum")
    yield _parameter("glTexGen", "i f d", "coord:enum pname:enum")
    yield _command("glClipPlane", "plane:enum equation:data", type="d", size=4)
    yield _components("glRasterPos", "2 3 4", "s i f d", "x y z w")
    yield _components("glWindowPos", "2 3", "s i f d", "x y z")


def _lighting() -> Iterator[Iterator[Command]]:
    """Section 2.14: colours and colouring."""
    yield _command("glFrontFace", "mode:enum")
    yield _parameter("glMaterial", "f i", "face:enum pname:enum", inside=True)
    yield _parameter("glLight", "f i", "light:enum pname:enum")
    yield _parameter("glLightModel", "f i", "pname:enum")
    yield _command("glColorMaterial", "face:enum mode:enum")
    yield _command("glShadeModel", "mode:enum")


def _rasterization() -> Iterator[Iterator[Command]]:
    """Sections 3.1 to 3.7: points, lines, polygons, pixel rectangles, bitmaps."""
    yield _command("glPointSize", "size")
    yield _parameter("glPointParameter", "f i", "pname:enum")
    yield _command("glLineWidth", "width")
    yield _command("glLineStipple", "factor:i pattern:us")
    yield _command("glCullFace", "mode:enum")
    yield _command("glPolygonStipple", "mask:data")
    yield _command("glPolygonMode", "face:enum mode:enum")
    yield _command("glPolygonOffset", "factor units")
    yield _parameter("glPixelStore", "f i", "pname:enum", " ", listed=False)
    yield _parameter("glPixelTransfer", "f i", "pname:enum", " ")
    for kind in ("f", "ui", "us"):
        yield iter(
            (Command(f"glPixelMap{kind}v", "glPixelMap", _arguments("map:enum size:sizei values:data"), kind, 0, True),)
        )
    yield _command("glDrawPixels", f"width:sizei height:sizei {_IMAGE}")
    yield _command("glPixelZoom", "zx zy")
    yield _command("glBitmap", "width:sizei height:sizei xbo ybo xbi ybi data:data")


def _textures() -> Iterator[Iterator[Command]]:
    """Sections 3.8 to 3.10: textures, fog."""
    yield _command("glTexImage1D", f"target:enum level:i internalformat:i width:sizei border:i {_IMAGE}")
    yield _command("glTexImage2D", f"target:enum level:i internalformat:i width:sizei height:sizei border:i {_IMAGE}")
    yield _command(
        "glTexImage3D", f"target:enum level:i internalformat:i width:sizei height:sizei depth:sizei border:i {_IMAGE}"
    )
    yield _command("glCopyTexImage1D", "target:enum level:i internalformat:enum x:i y:i width:sizei border:i")
    yield _command(
        "glCopyTexImage2D", "target:enum level:i internalformat:enum x:i y:i width:sizei height:sizei border:i"
    )
    yield _command("glTexSubImage1D", f"target:enum level:i xoffset:i width:sizei {_IMAGE}")
    yield _command("glTexSubImage2D", f"target:enum level:i xoffset:i yoffset:i width:sizei height:sizei {_IMAGE}")
    yield _command(
        "glTexSubImage3D",
        f"target:enum level:i xoffset:i yoffset:i zoffset:i width:sizei height:sizei depth:sizei {_IMAGE}",
    )
    yield _command("glCopyTexSubImage1D", "target:enum level:i xoffset:i x:i y:i width:sizei")
    yield _command("glCopyTexSubImage2D", "target:enum level:i xoffset:i yoffset:i x:i y:i width:sizei height:sizei")
    yield _command(
        "glCopyTexSubImage3D", "target:enum level:i xoffset:i yoffset:i zoffset:i x:i y:i width:sizei height:sizei"
    )
    for d, box in (
        ("1D", "width:sizei"),
        ("2D", "width:sizei height:sizei"),
        ("3D", "width:sizei height:sizei depth:sizei"),
    ):
        offset = " ".join(f"{axis}offset:i" for axis in "xyz"[: int(d[0])])
        tail = "imageSize:sizei data:data"
        yield _command(f"glCompressedTexImage{d}", f"target:enum level:i internalformat:enum {box} border:i {tail}")
        yield _command(f"glCompressedTexSubImage{d}", f"target:enum level:i {offset} {box} format:enum {tail}")
    yield _parameter("glTexParameter", "f i", "target:enum pname:enum")
    yield _command("glBindTexture", "target:enum texture:ui")
    yield _command("glDeleteTextures", "n:sizei textures:data", listed=False)
    yield _command("glGenTextures", "n:sizei", listed=False, result="ui")
    yield _command("glAreTexturesResident", "n:sizei textures:data", listed=False, result="boolean")
    yield _command("glPrioritizeTextures", "n:sizei textures:data priorities:data")
    yield _parameter("glTexEnv", "f i", "target:enum pname:enum")
    yield _parameter("glFog", "f i", "pname:enum")


def _framebuffer() -> Iterator[Iterator[Command]]:
    """Section 4: per-fragment operations and the framebuffer."""
    yield _command("glScissor", "x:i y:i width:sizei height:sizei")
    yield _command("glSampleCoverage", "value invert:boolean")
    yield _command("glAlphaFunc", "func:enum ref")
    yield _command("glStencilFunc", "func:enum ref:i mask:ui")
    yield _command("glStencilOp", "sfail:enum dpfail:enum dppass:enum")
    yield _command("glDepthFunc", "func:enum")
    yield _command("glBeginQuery", "target:enum id:ui")
    yield _command("glEndQuery", "target:enum")
    yield _command("glGenQueries", "n:sizei", listed=False, result="ui")
    yield _command("glDeleteQueries", "n:sizei ids:data", listed=False)
    yield _command("glBlendEquation", "mode:enum")
    yield _command("glBlendFunc", "sfactor:enum dfactor:enum")
    yield _command("glBlendFuncSeparate", "srcRGB:enum dstRGB:enum srcAlpha:enum dstAlpha:enum")
    yield _command("glBlendColor", "red green blue alpha")
    yield _command("glLogicOp", "op:enum")
    yield _command("glDrawBuffer", "buf:enum")
    yield _command("glIndexMask", "mask:ui")
    yield _command("glColorMask", "r:boolean g:boolean b:boolean a:boolean")
    yield _command("glDepthMask", "flag:boolean")
    yield _command("glStencilMask", "mask:ui")
    yield _command("glClear", "mask:bitfield")
    yield _command("glClearColor", "r g b a")
    yield _command("glClearIndex", "index")
    yield _command("glClearDepth", "d:d")
    yield _command("glClearStencil", "s:i")
    yield _command("glClearAccum", "r g b a")
    yield _command("glAccum", "op:enum value")
    yield _command("glReadPixels", f"x:i y:i width:sizei height:sizei {_IMAGE}", listed=False, result="data")
    yield _command("glReadBuffer", "src:enum")
    yield _command("glCopyPixels", "x:i y:i width:sizei height:sizei type:enum")


def _special() -> Iterator[Iterator[Command]]:
    """Section 5: evaluators, selection, feedback, display lists, flush, hints."""
    for kind in ("f", "d"):
        yield _command(f"glMap1{kind}", f"target:enum u1:{kind} u2:{kind} stride:i order:i points:data", type=kind)
        yield _command(
            f"glMap2{kind}",
            f"target:enum u1:{kind} u2:{kind} ustride:i uorder:i v1:{kind} v2:{kind} vstride:i vorder:i points:data",
            type=kind,
        )
        yield _command(f"glMapGrid1{kind}", f"un:i u1:{kind} u2:{kind}", type=kind)
        yield _command(f"glMapGrid2{kind}", f"un:i u1:{kind} u2:{kind} vn:i v1:{kind} v2:{kind}", type=kind)
    yield _components("glEvalCoord", "1 2", "f d", "u v", inside=True)
    yield _command("glEvalMesh1", "mode:enum p1:i p2:i")
    yield _command("glEvalMesh2", "mode:enum p1:i p2:i q1:i q2:i")
    yield _command("glEvalPoint1", "p:i", inside=True)
    yield _command("glEvalPoint2", "p:i q:i", inside=True)
    yield _command("glInitNames")
    yield _command("glPopName")
    yield _command("glPushName", "name:ui")
    yield _command("glLoadName", "name:ui")
    yield _command("glRenderMode", "mode:enum", listed=False, result="data")
    yield _command("glSelectBuffer", "n:sizei", listed=False, result="data")
    yield _command("glFeedbackBuffer", "n:sizei type:enum", listed=False, result="data")
    yield _command("glPassThrough", "token")
    yield _command("glNewList", "n:ui mode:enum", listed=False)
    yield _command("glEndList", listed=False)
    yield _command("glCallList", "n:ui", inside=True)
    yield _command("glCallLists", "n:sizei type:enum lists:data", inside=True)
    yield _command("glListBase", "base:ui")
    yield _command("glGenLists", "s:sizei", listed=False, result="ui")
    yield _command("glDeleteLists", "list:ui range:sizei", listed=False)
    yield _command("glFlush", listed=False)
    yield _command("glFinish", listed=False)
    yield _command("glHint", "target:enum hint:enum")


def _queries() -> Iterator[Iterator[Command]]:
    """Section 6: state and state requests."""
    for kind in ("Boolean", "Integer", "Float", "Double"):
        name = f"glGet{kind}"
        yield iter(
            (Command(f"{name}v", name, (("pname", "enum"),), kind[0].lower(), 0, True, listed=False, result="data"),)
        )
    yield _command("glIsEnabled", "cap:enum", listed=False, result="boolean")
    yield _command("glGetPointerv", "pname:enum", listed=False, result="data")
    yield _command("glGetString", "name:enum", listed=False, result="data")
    yield _command("glGetStringi", "name:enum index:ui", listed=False, result="data")  # OpenGL 3.0
    yield _command("glGetError", listed=False, result="enum", inside=True)
    yield _command("glGetClipPlane", "plane:enum", listed=False, result="data")
    yield _get("glGetLight", "i f", "light:enum pname:enum")
    yield _get("glGetMaterial", "i f", "face:enum pname:enum")
    yield _get("glGetTexEnv", "i f", "env:enum pname:enum")
    yield _get("glGetTexGen", "i f d", "coord:enum pname:enum")
    yield _get("glGetTexParameter", "i f", "target:enum pname:enum")
    yield _get("glGetTexLevelParameter", "i f", "target:enum level:i pname:enum")
    yield _get("glGetPixelMap", "f ui us", "map:enum")
    yield _get("glGetMap", "i f d", "map:enum value:enum")
    yield _get("glGetQuery", "i", "target:enum pname:enum")
    yield _get("glGetQueryObject", "i ui", "id:ui pname:enum")
    yield _command("glGetTexImage", "tex:enum lod:i format:enum type:enum", listed=False, result="data")
    yield _command("glGetCompressedTexImage", "target:enum lod:i", listed=False, result="data")
    yield _command("glGetPolygonStipple", listed=False, result="data")
    for name, argument in (("glIsTexture", "texture"), ("glIsList", "list"), ("glIsQuery", "id")):
        yield _command(name, f"{argument}:ui", listed=False, result="boolean")
    yield _command("glPushAttrib", "mask:bitfield")
    yield _command("glPopAttrib")
    yield _command("glPushClientAttrib", "mask:bitfield", listed=False)
    yield _command("glPopClientAttrib", listed=False)


_TOPICS = (
    _vertices, _arrays, _transformations, _lighting, _rasterization, _textures, _framebuffer, _special, _queries,
)  # fmt: skip
COMMANDS: dict[str, Command] = {command.name: command for topic in _TOPICS for row in topic() for command in row}
FAMILIES: dict[str, list[Command]] = {}
for _row in COMMANDS.values():
    FAMILIES.setdefault(_row.family, []).append(_row)

# ---------------------------------------------------------------- how many numbers an array argument has

# named parameters of more than one number
PARAMETER_SIZES: dict[int, int] = {int(getattr(constants, f"GL_{name}")): size for size, names in (
    (4, "AMBIENT DIFFUSE SPECULAR EMISSION AMBIENT_AND_DIFFUSE POSITION LIGHT_MODEL_AMBIENT FOG_COLOR TEXTURE_ENV_COLOR"
        " TEXTURE_BORDER_COLOR OBJECT_PLANE EYE_PLANE"),
    (3, "SPOT_DIRECTION COLOR_INDEXES POINT_DISTANCE_ATTENUATION"),
) for name in names.split()}  # fmt: skip
# arrays whose length another argument of the same call says
LENGTHS = {"textures": "n", "priorities": "n", "buffers": "n", "ids": "n", "lists": "n", "values": "size",
           "indices": "count"}  # fmt: skip


def numbers_wanted(command: Command, arguments: Sequence[object], place: int) -> int | None:
    """How many numbers a call reads from its argument ``place``, an array; None where the command does not say."""
    if command.size:
        return command.size
    if command.vector and command.parameters[place] == "params":
        named = arguments[place - 1]
        return PARAMETER_SIZES.get(named, 1) if isinstance(named, int) else None
    said = LENGTHS.get(command.parameters[place])
    length = arguments[command.parameters.index(said)] if said in command.parameters else None
    return length if isinstance(length, int) and length >= 0 else None
