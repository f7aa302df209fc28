"""Write what follows from the command table, into glsim/gl, glu and glut: ``python -m glsim.gl.generate``.

glVertex, glNormal, glColor and glTexCoord are called once a vertex, so their code is written out: each variant
does nothing but store.  A test checks that the files are what this program writes.
"""

from __future__ import annotations

from pathlib import Path

from glsim.gl.stubs import PYTHON_TYPE, gl_stubs, library_stubs
from glsim.machine.commands import FAMILIES, Command
from glsim.machine.frame import ROW_BYTES

GL = Path(__file__).parent.parent / "gl"
HOT = ("glVertex", "glNormal", "glColor", "glTexCoord")

# Integers as colours and normals map linearly onto [0, 1] or [-1, 1]: OpenGL 1.5, table 2.9.
SCALED = {
    "ub": "({0} & 255) / 255.0",
    "us": "({0} & 65535) / 65535.0",
    "ui": "({0} & 4294967295) / 4294967295.0",
    "b": "(2 * {0} + 1) / 255.0",
    "s": "(2 * {0} + 1) / 65535.0",
    "i": "(2 * {0} + 1) / 4294967295.0",
}

IMMEDIATE = '''\
"""The commands that are called once a vertex.  Written by ``python -m glsim.gl.generate``; do not edit.

A vertex is a row of ten numbers: its position beside the current normal and colour.
"""

from __future__ import annotations

from collections.abc import Sequence
from struct import Struct
from typing import Any

from glsim.gl.arguments import retry
from glsim.machine.current import attach
from glsim.machine.sentences import MISUSE as BAD

row = Struct("10f").pack
Numbers = Sequence[Any]
current: Any  # the machine; see glsim/machine/current.py
attach(globals())
'''


def store(command: Command, values: list[str]) -> list[str]:
    """The statements that execute one hot command on components given as expressions."""
    if command.family == "glVertex":
        x, y, z, *w = [*values, "0.0"][:3] + values[3:]
        lines = [f"m.write(row({x}, {y}, {z}, m.nx, m.ny, m.nz, m.red, m.green, m.blue, m.alpha))"]
        if w:
            lines.append(f"if {w[0]} != 1.0 and m.inside is not None:")
            lines.append(f'    m.columns.append(("w", m.stream.tell() // {ROW_BYTES} - 1, {w[0]}))')
        return lines
    if command.family == "glTexCoord":
        checked = [f"{value} + 0.0" for value in values]  # what is no number is refused here, not at the flush
        filled = ", ".join([*checked, *("0.0", "0.0", "0.0", "1.0")[len(values) :]])
        return [f"m.texcoord.append((m.stream.tell(), ({filled})))"]
    scale = SCALED.get(command.type, "{0}")
    if command.family == "glNormal":
        targets = ["m.nx", "m.ny", "m.nz"]
    else:
        targets = ["m.red", "m.green", "m.blue", "m.alpha"]
        if len(values) == 3:
            return [f"{t} = {scale.format(v)}" for t, v in zip(targets, values, strict=False)] + ["m.alpha = 1.0"]
    return [f"{t} = {scale.format(v)}" for t, v in zip(targets, values, strict=True)]


def hot_function(command: Command) -> str:
    parameters = command.parameters
    kinds = [PYTHON_TYPE.get(kind, "int") for _, kind in command.arguments]
    signature = ", ".join(f"{name}: {kind}" for name, kind in zip(parameters, kinds, strict=True))
    given = f"({', '.join(parameters)},)"
    given = given.replace(",)", ")") if len(parameters) > 1 else given
    components = FAMILIES[command.family][-2].parameters[: command.size]
    body = store(command, list(components))
    if command.vector:
        unpack = f"{', '.join(components)} = v" if command.size > 1 else f"{components[0]} = _first(v)"
        body.insert(0, unpack)
    lines = "\n".join(f"        {line}" for line in body)
    recorded = f"{given} if surplus is None else ({', '.join(parameters)}, surplus)"
    return (
        f"def {command.name}({signature}, surplus: Any = None) -> None:\n"
        f"    m = current\n"
        f"    if m.recorder:\n"
        f'        return m.recorder("{command.name}", {recorded})  # type: ignore[no-any-return]\n'
        f"    try:\n{lines}\n"
        f"    except BAD as error:\n"
        f'        retry(error, "{command.name}", {given})\n'
    )


def immediate() -> str:
    first = "def _first(v: Any) -> Any:\n    return v[0] if hasattr(v, '__getitem__') else v\n".replace("'", '"')
    functions = [hot_function(command) for family in HOT for command in FAMILIES[family]]
    return "\n\n".join([IMMEDIATE, first, *functions])


# command that glsim accepts but does not execute fully -> why
INDEX_MODE = "accepted without effect: colour-index mode is not emulated, every context is RGBA"
NO_FORMAT = "refused with GL_INVALID_ENUM: OpenGL 1.5 names no compressed format, and glsim offers none"
REMARKS = {
    "glGetStringi": "supported, though of OpenGL 3.0: programs ask for the extensions one by one",
    "glHint": "accepted without effect, but for GL_AFFINE_GLSIM: there is one way to draw everything",
    "glPrioritizeTextures": "accepted without effect: every texture is resident",
    "glIndex": INDEX_MODE, "glIndexPointer": INDEX_MODE, "glIndexMask": INDEX_MODE, "glClearIndex": INDEX_MODE,
    **{f"glCompressedTex{part}Image{d}D": NO_FORMAT for part in ("", "Sub") for d in (1, 2, 3)},
    "glGetCompressedTexImage": "refused with GL_INVALID_OPERATION: no texture is compressed",
}  # fmt: skip
NOTES = """\
Notes:

- Colour-index mode is refused: there is no way to ask for such a context, reading GL_COLOR_INDEX raises
  GL_INVALID_OPERATION. Drawing and textures from colour indices work, through the maps GL_PIXEL_MAP_I_TO_R to I_TO_A.
- Front and back are one picture; right buffers and auxiliary buffers raise GL_INVALID_OPERATION.
- The texels of a texture border are dropped, as drivers have done for decades.
- GL_POLYGON_SMOOTH is accepted and drawn without smoothing, as Mesa does; `glsim.offscreen(samples=4)` smooths all.
- Wide and stippled lines may differ from a driver's by a pixel at their ends and where a pattern changes.
- A GLUT window has a depth and a stencil buffer only if glutInitDisplayMode asks for them, as with freeglut and Mesa:
  else the tests have no effect, GL_DEPTH_BITS is 0, and `glsim run` and `glsim trace` say so. GLUT_STENCIL brings a
  depth buffer along; without glutInitDisplayMode there is a depth buffer. Alpha and the accumulation buffer are always
  there. Windows of pygame and glfw, and `glsim.offscreen`, have all buffers.
- Generic compressed formats (GL_COMPRESSED_RGB, ...) are stored uncompressed, as the specification allows.
- Internal formats of less or more than 8 bits are stored with 8; depth textures with 24.

Where Mesa 22.3.6 and the specification of OpenGL 1.5 disagree, glsim does what the specification says:

- A glMaterial that no vertex has used yet overrides the current colour when GL_COLOR_MATERIAL is enabled.
- glPopAttrib(GL_LIGHTING_BIT) leaves such a glMaterial in force.
- glColorMaterial(GL_BACK, ...) loses green and blue when glColor changes between primitives.
- Primitives after a glBegin/glEnd with less than two vertices are dropped.
- Normal arrays of GL_BYTE map by OpenGL 4.2's rule c / 127.
- Smooth points are hard discs; smooth lines get thinner with perspective; GL_LINE_RESET_TOKEN never comes.
- Bitmaps are not fogged, overlapping bitmaps blend once, and textured ones take the last raster position's coordinates.
- With gluPerspective in the modelview matrix, lighting takes eye coordinates without the division by w (2.14.1), and
  normals by a part of the inverse of the whole matrix, where 2.11.3 allows the inverse of its part or the plane's q.
- In a stippled strip each line counts up to the next whole pixel, instead of its fragments.
- A clipped quad or polygon in GL_POINT has points where its diagonals are cut.
- A shininess of 0 gives a highlight wherever there is light; Mesa drops it where N.H < 0 and for attenuated lights.
- glDrawPixels with GL_MAP_COLOR gets blue by none of the maps, and looks up other entries than the rounded ones;
  GL_INDEX_SHIFT has no effect on it.
- In a display list, an attribute that is set for the first time after the first triangle of a glBegin keeps, for the
  triangle it is set in, the value from before.
- After GL_COMPILE_AND_EXECUTE the current colour is not the one that glColor set between glBegin and glEnd after the
  last vertex, and a command that is illegal there raises no error.
- Pixel rectangles are not fogged, get no secondary colour, and the texture matrix of their glRasterPos has no effect.
- The sum of primary and secondary colour is not clamped to 1 before fog.
- glPopAttrib(GL_FOG_BIT) leaves GL_COLOR_SUM as it is, glPopAttrib(GL_ENABLE_BIT) the lights GL_LIGHTi.
- Where the 2D texture of a unit is incomplete, an enabled 1D texture is drawn in its place.
- Bitmaps that overlap pass the stencil test, and change the stencil buffer, once.
- glAccum under GLX goes through an sRGB view: GL_RETURN with 0.5 gives 92 where half of 128 is 64.
- glRect under GL_FLAT is lit at its last vertex, as a quad; by 2.10 it is a polygon, whose first vertex counts.
- A glMaterial between the vertices of a GL_LINE_LOOP loses the closing line.
- Where an edge of a zoomed column meets a pixel's centre, glDrawPixels takes the column before (3.6.4 counts it in).

Done as Mesa does, against section 2.11: edges that clipping by the view volume introduces are not boundary edges. They
would frame every picture of outlines, and Mesa draws none. What glClipPlane introduces is drawn in GL_LINE and
GL_POINT.

Not specified, and done as Mesa does: how a quad is cut into triangles; which pixels a point between pixels covers.
"""


def support() -> str:
    """glsim/gl/SUPPORT.md: every command of OpenGL 1.5 and whether it is there."""
    lines = [
        "# Commands of OpenGL 1.5",
        "",
        "Written by `python -m glsim.gl.generate` from the command table; do not edit.",
        "",
        "| command | variants | state |",
        "| --- | --- | --- |",
    ]
    counts = {"supported": 0, "accepted without effect": 0, "refused": 0}
    for family, commands in FAMILIES.items():
        state = REMARKS.get(family, "supported")
        counts[next(word for word in counts if state.startswith(word))] += len(commands)
        suffixes = " ".join(command.name.removeprefix(family) for command in commands)
        lines.append(f"| {family} | {suffixes} | {state} |")
    total = ", ".join(f"{count} {state}" for state, count in counts.items())
    return "\n".join([*lines, "", f"Of {sum(counts.values())} entry points: {total}.", "", NOTES])


def main() -> None:
    from glsim.files import write_text

    write_text(GL / "immediate.py", immediate())
    write_text(GL / "__init__.pyi", gl_stubs())
    for library in ("glu", "glut"):
        write_text(GL.parent / library / "__init__.pyi", library_stubs(library))
    write_text(GL / "SUPPORT.md", support())


if __name__ == "__main__":
    main()
