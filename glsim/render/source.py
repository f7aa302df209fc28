"""Vertices on the GPU: buffers with the columns that programs read, and the vertex arrays over them."""

from __future__ import annotations

import weakref
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine.frame import Vertices
from glsim.machine.state import TEXTURE_UNITS
from glsim.render.gpu import GPU, Buffer, Program, VertexArray
from glsim.render.key import ProgramKey

# Inputs of main.vert beside position, normal and color: how they lie in a buffer, and the column they come from.
INPUTS = {
    **{f"texcoord{unit}": ("4f", f"texcoord{unit}") for unit in range(TEXTURE_UNITS)},
    "depth_offset": ("1f", "depth_offset"),
    "position_w": ("1f", "w"),
    "lit_position": ("4f", "lit_position"),
    "secondary_color": ("4f", "secondary_color"),
    "fog_coord": ("1f", "fog_coord"),
    "other_end": ("4f", "other_end"),
    "line_corner": ("2f", "line_corner"),
    "line_begin": ("1f", "line_begin"),
}


class Source:
    """Buffers with vertices and indices, and the vertex arrays over them.

    The renderer has one that every plan overwrites, and one for each block of vertices of a display list, kept as
    long as the list.
    """

    def __init__(self, gpu: GPU) -> None:
        self.gpu = gpu
        self.buffers: dict[str, Buffer] = {}
        self.vertex_arrays: dict[ProgramKey, VertexArray] = {}
        self.indices: weakref.ref[Any] | None = None  # what the index buffer holds, if it is kept
        self.columns: set[str] = set()  # which columns the buffers hold

    def write(self, name: str, data: NDArray[Any], busy: bool) -> None:
        """Replace a buffer's content.  While the GPU may still read the old one it gets new memory."""
        data = np.ascontiguousarray(data)
        buffer = self.buffers.get(name)
        if buffer is None:
            buffer = self.buffers[name] = self.gpu.buffer(reserve=max(data.nbytes, 1024), dynamic=True)
        elif busy or buffer.size < data.nbytes:
            buffer.orphan(max(buffer.size, data.nbytes))
        if data.nbytes:
            buffer.write(data)

    def fill(self, vertices: Vertices, inputs: Sequence[str], busy: bool) -> None:
        """Write the columns that a program with these inputs reads and that the buffers do not hold yet."""
        for name in inputs:
            column = INPUTS[name][1]
            if column not in self.columns:
                self.write(name, vertices.column(column), busy)
                self.columns.add(column)

    def vertex_array(self, key: ProgramKey, program: Program, per: str) -> VertexArray:
        """per: "/v" if objects are numbered per vertex, "/i" if per instance."""
        if key not in self.vertex_arrays:
            inputs = [("3f", "position"), ("3f", "normal"), ("4f", "color")]
            layout = " ".join(form if name in program else f"{4 * int(form[0])}x" for form, name in inputs)
            content: list[Any] = [(self.buffers["rows"], layout, *(name for _, name in inputs if name in program))]
            content += [(self.buffers[name], form, name) for name, (form, _) in INPUTS.items() if name in program]
            if "object" in program:
                content.append((self.buffers["object"], "1u4" + per, "object"))
            indices = self.buffers["indices"]
            self.vertex_arrays[key] = self.gpu.vertex_array(program, content, index_buffer=indices)
        return self.vertex_arrays[key]
