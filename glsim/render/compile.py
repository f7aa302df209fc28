"""A key's GLSL compiled and linked; what the compiler says names the file in shaders/ and the line."""

from __future__ import annotations

import re

from glsim.machine.state import TEXTURE_UNITS
from glsim.render.gpu import GPU, Program
from glsim.render.key import ProgramKey
from glsim.render.programs import expand, root_files, sources

BINDINGS = {"Transforms": 0, "Materials": 1, "Lights": 2, "Raster": 3, "Texturing": 4}
RECTANGLE_UNIT = TEXTURE_UNITS  # the texture unit beyond those of the API, for pixel rectangles
SAMPLERS = {**{f"texture{number}": number for number in range(TEXTURE_UNITS)}, "rectangle": RECTANGLE_UNIT}


class ShaderError(Exception):
    """A GLSL source in shaders/ does not compile."""


def build(gpu: GPU, key: ProgramKey) -> Program:
    """Compile and link a key's GLSL.

    Raises ShaderError that names the file in shaders/ and the line.
    """
    text = sources(key)
    try:
        return link(gpu, text["vertex"], text["fragment"])
    except Exception as error:  # moderngl.Error; its text is the compiler's message
        raise ShaderError(_with_file_names(str(error), root_files(key))) from None


def link(gpu: GPU, vertex: str, fragment: str) -> Program:
    """A program of these texts; uniform blocks get BINDINGS, samplers SAMPLERS."""
    program: Program = gpu.program(vertex_shader=vertex, fragment_shader=fragment)
    for name, binding in BINDINGS.items():
        block = program.get(name, None)
        if block is not None:
            block.binding = binding
    for name, number in SAMPLERS.items():
        if name in program:
            program[name] = number
    return program


def _with_file_names(message: str, roots: dict[str, str]) -> str:
    """'0:2007(5): error' or '0(2007) : error' -> 'state.glsl:7: error': #line's numbers become files again."""
    is_fragment = "fragment_shader" in message or "fragment shader" in message.lower()
    files = expand(roots["fragment" if is_fragment else "vertex"])[1]

    def replace(found: re.Match[str]) -> str:
        number, line = divmod(int(found[1]), 1000)
        return f"{files[number]}:{line}:" if number < len(files) else found[0]

    return re.sub(r"^\d+[:(](\d+)(?:\(\d+\)|\))?\s*:", replace, message, flags=re.MULTILINE)
