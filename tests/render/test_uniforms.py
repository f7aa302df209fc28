"""The uniform blocks: NumPy's layout is the driver's, and what explain names is a member of them."""

from __future__ import annotations

import ctypes
import re
from collections.abc import Iterator

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.machine.state import Face, Material
from glsim.play.capture import capture
from glsim.render import uniforms
from glsim.render.batch import Object

GL_UNIFORM_OFFSET = 0x8A3B


def members(dtype: np.dtype, prefix: str = "", base: int = 0) -> Iterator[tuple[str, int]]:
    """GLSL names of the basic members, with their offsets in bytes."""
    for name, (field, offset, *_) in (dtype.fields or {}).items():
        element, shape = field.subdtype or (field, ())
        if element.names and shape:
            for k in range(shape[0]):
                yield from members(element, f"{prefix}{name}[{k}].", base + offset + k * element.itemsize)
        elif element.names:
            yield from members(element, f"{prefix}{name}.", base + offset)
        else:
            yield prefix + name, base + offset


def declared() -> dict[str, int]:
    """Every member of every block -> its offset."""
    found = dict(members(uniforms.TRANSFORM, "transforms[0]."))
    found |= dict(members(uniforms.MATERIAL, "materials[0]."))
    for block in (uniforms.LIGHTS, uniforms.RASTER, uniforms.TEXTURING):
        found |= dict(members(block))
    return found


def everything() -> None:
    """A state that uses most members: eight lights, textures, clip planes, fog."""
    glEnable(GL_LIGHTING)
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1)
    for k in range(8):
        glEnable(GL_LIGHT0 + k)
        glLightfv(GL_LIGHT0 + k, GL_POSITION, [1, 2, 3, 1])
        glLightf(GL_LIGHT0 + k, GL_SPOT_CUTOFF, 30)
        glLightf(GL_LIGHT0 + k, GL_LINEAR_ATTENUATION, 1)
    glClipPlane(GL_CLIP_PLANE3, [0, 0, 1, 9])
    glEnable(GL_CLIP_PLANE3)
    glEnable(GL_FOG)
    glEnable(GL_ALPHA_TEST)
    glAlphaFunc(GL_GREATER, 0.1)
    glEnable(GL_POLYGON_STIPPLE)
    for unit in range(4):
        glActiveTexture(GL_TEXTURE0 + unit)
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes(4))
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST)
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE)
        glEnable(GL_TEXTURE_2D)
    for primitive in (GL_TRIANGLES, GL_LINES, GL_POINTS):
        glLineWidth(4)
        glBegin(primitive)
        for x, y in ((-1, -1), (1, -1), (0, 1), (1, 1), (-1, 1), (0, 0)):
            glVertex2f(x, y)
        glEnd()


@pytest.mark.slow
def test_every_member_lies_where_the_driver_reads_it(screen: glsim.Offscreen) -> None:
    everything()
    screen.pixels()
    load, offsets = screen._driver.loader.load, declared()
    p = ctypes.c_void_p
    indices = ctypes.CFUNCTYPE(None, ctypes.c_uint, ctypes.c_int, p, p)(load("glGetUniformIndices"))
    parameters = ctypes.CFUNCTYPE(None, ctypes.c_uint, ctypes.c_int, p, ctypes.c_uint, p)(load("glGetActiveUniformsiv"))
    seen = set()
    with screen.ctx:
        for program in screen._renderer.programs.values():
            for name, offset in offsets.items():
                for spelling in (name, f"{name}[0]"):
                    text = ctypes.c_char_p(spelling.encode())
                    index, value = ctypes.c_uint(), ctypes.c_int()
                    indices(program.glo, 1, ctypes.byref(text), ctypes.byref(index))
                    if index.value != 0xFFFFFFFF:
                        parameters(program.glo, 1, ctypes.byref(index), GL_UNIFORM_OFFSET, ctypes.byref(value))
                        assert value.value == offset, name
                        seen.add(name)
    assert {"lights[7].cos_spot_cutoff", "fog_end", "line_width", "units[3].alpha_scale", "viewport_margin"} <= seen
    assert len(seen) > 100


def test_rows_are_as_long_as_blocks_may_begin() -> None:
    assert uniforms.TRANSFORM.itemsize == uniforms.MATERIAL.itemsize == uniforms.ROW_SIZE


def test_what_is_packed_is_what_was_set(screen: glsim.Offscreen) -> None:
    glLightfv(GL_LIGHT2, GL_POSITION, [0, 3, 4, 0])
    glLightf(GL_LIGHT2, GL_SPOT_CUTOFF, 60)
    glLightf(GL_LIGHT2, GL_SPOT_EXPONENT, 7)
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0.1, 0.2, 0.3, 1])
    glFogf(GL_FOG_END, 5)
    glLineStipple(3, 0xF0A5)
    state = screen.machine.snapshot()
    lights, raster = uniforms.lights(state.lighting), uniforms.raster(state, (7, 8), margin=2)
    light = lights["lights"][2]
    assert light["position"].tolist() == pytest.approx([0, 0.6, 0.8, 0])
    assert light["cos_spot_cutoff"] == pytest.approx(0.5)
    assert light["spot_exponent"] == 7
    assert lights["lights"][3]["cos_spot_cutoff"] == -1
    assert lights["I_a_scene"].tolist() == pytest.approx([0.1, 0.2, 0.3, 1])
    assert raster["fog_end"] == 5
    assert (raster["line_stipple_factor"], raster["line_stipple_pattern"]) == (3, 0xF0A5)
    assert raster["rectangle_origin"].tolist() == [7, 8]
    assert raster["viewport_margin"] == 2


def test_explain_names_members(screen: glsim.Offscreen) -> None:
    """Each uniform that explain tells is a member of a block, by the name that the GLSL gives it."""
    with capture(calls=True) as frame:
        everything()
    known = {re.sub(r"^(transform|material)s\[0\]", r"\1", name) for name in declared()} | {"color"}
    known |= {f"clip_planes[{k}]" for k in range(6)}
    explained = glsim.explain(frame)
    for explanation in explained:
        names = {entry.name for entry in explanation.uniforms}
        assert names <= known
        text = "".join(explanation.glsl.values())
        for name in names:
            assert name.rpartition(".")[2].partition("[")[0] in text, name
    everywhere = {entry.name for explanation in explained for entry in explanation.uniforms}
    assert {"point_size", "line_width", "fog_density", "lights[7].spot_direction", "units[2].matrix"} <= everywhere


def test_materials_by_the_lectures_names(screen: glsim.Offscreen) -> None:
    """Objects with the same material share what is packed, but each has its own colour."""
    sides = [Face(*((k + n / 8,) * 4 for n in range(4)), shininess=10.0 * k) for k in (1, 2)]
    material, matrices = Material(*sides), screen.machine.matrices()
    red, green = (1.0, 0.0, 0.0, 1.0), (0.0, 1.0, 0.0, 1.0)
    rows = uniforms.materials([Object(matrices, material, red), Object(matrices, material, green)])
    for member, field in uniforms.FACE.items():
        for side, face in (("front", sides[0]), ("back", sides[1])):
            assert (rows[side][member] == getattr(face, field)).all(), (side, member)
    assert rows["color"].tolist() == [list(red), list(green)]
