"""glDrawPixels, glCopyPixels and glBitmap as Draws: a rectangle whose fragments look up a picture.

Zooming and clipping to the framebuffer happen here, so that the picture has one element for each pixel it covers.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.machine import constants as gl
from glsim.machine.frame import ROW, Draw, Pixels, Vertices
from glsim.machine.matrix import identity
from glsim.machine.pixels import depths, stencils, transferred
from glsim.machine.state import (
    TEXTURE_UNITS,
    ColorBuffer,
    Depth,
    Fog,
    Lighting,
    Material,
    Polygon,
    RasterPosition,
    Snapshot,
    Stencil,
    Transform,
    Viewport,
)

Reader = Callable[[int, int, int, int, str], NDArray[Any]]


class Fragments(NamedTuple):
    """A Draw, and the picture that its fragments look up: kind as in key.PIXELS; origin: its lower left pixel."""

    kind: str
    image: NDArray[Any]
    origin: tuple[int, int]
    draw: Draw


def as_fragments(packet: Pixels, size: tuple[int, int], read: Reader) -> Iterator[Fragments]:
    """What draws the packet into a framebuffer of this size (width, height)."""
    image = _copied(packet, read) if packet.copied else packet.image
    assert image is not None
    zoom = packet.mode.zoom if packet.kind != "bitmap" else (1.0, 1.0)
    placed = _placed(image, packet.raster, zoom, size)
    if placed is None:
        return
    image, origin = placed
    state = plain_state(packet.state, size)
    if packet.kind != "stencil":
        draw = _rectangle(image.shape, origin, packet.raster, state, size)
        yield Fragments(packet.kind, image, origin, draw)
        return
    for state, bits in _stencil_planes(packet.state, image):  # shaders cannot write stencil values
        draw = _rectangle(image.shape, origin, packet.raster, plain_state(state, size, fragments=False), size)
        yield Fragments("bitmap", bits, origin, draw)


def plain_state(state: Snapshot, size: tuple[int, int], fragments: bool = True) -> Snapshot:
    """The state for a rectangle in window coordinates.  fragments: whether the per-fragment operations apply; else
    only scissor and masks do (and the stencil operation that ``state`` has)."""
    units = tuple(unit._replace(generated=(False,) * 4) for unit in state.texture.units)
    plain = state._replace(
        lighting=Lighting(shade_model=gl.GL_SMOOTH),
        transform=Transform(),
        viewport=Viewport(0, 0, *size),
        polygon=Polygon(),
        texture=state.texture._replace(units=units),
        fog=state.fog._replace(coordinate_source=gl.GL_FOG_COORDINATE, color_sum=_highlighted(state)),
    )
    if fragments:
        return plain
    off = tuple(unit._replace(enabled=(False,) * 4) for unit in units)
    buffers = ColorBuffer(mask=state.color_buffer.mask, draw_buffer=state.color_buffer.draw_buffer, dither=False)
    stencil = state.stencil if state.stencil.depth_fail == gl.GL_REPLACE else Stencil()
    return plain._replace(
        texture=state.texture._replace(units=off), fog=Fog(), color_buffer=buffers, depth=Depth(mask=False),
        stencil=stencil,
    )  # fmt: skip


def _highlighted(state: Snapshot) -> bool:
    """Whether the raster position's secondary colour is added after texturing."""
    return state.fog.color_sum or state.lighting.enabled


def _stencil_planes(state: Snapshot, values: NDArray[np.uint8]) -> Iterator[tuple[Snapshot, NDArray[np.uint8]]]:
    """First zeros everywhere, then each bit where it is 1; of the bits that glStencilMask lets through."""
    hidden = state.color_buffer._replace(mask=(False,) * 4)
    replace = Stencil(
        True, gl.GL_ALWAYS, 0, 255, state.stencil.write_mask & 255, gl.GL_REPLACE, gl.GL_REPLACE, gl.GL_REPLACE
    )
    yield state._replace(color_buffer=hidden, stencil=replace), np.ones_like(values)
    for bit in (1 << k for k in range(8)):
        if replace.write_mask & bit and (values & bit).any():
            one = replace._replace(reference=bit, write_mask=bit)
            yield state._replace(color_buffer=hidden, stencil=one), (values & bit != 0).astype(np.uint8)


def _copied(packet: Pixels, read: Reader) -> NDArray[Any]:
    """What glCopyPixels reads, after pixel transfer."""
    assert packet.copied is not None
    values = read(*packet.copied, packet.kind)
    if packet.kind == "color":
        return transferred(packet.mode, values)
    if packet.kind == "depth":
        return depths(packet.mode, values[..., None])
    return stencils(packet.mode, values[..., None])


def _columns(start: float, zoom: float, count: int, limit: int) -> tuple[int, NDArray[np.int64]]:
    """First pixel inside the framebuffer, and for each pixel from there on which of ``count`` elements it shows.

    A pixel shows element n if its centre is in [start + zoom n, start + zoom (n + 1)) (section 3.6.4).
    """
    if zoom == 0.0 or not np.isfinite(start + zoom * count):
        return 0, np.empty(0, np.int64)
    start = float(np.floor(start + 0.5)) if zoom in (1.0, -1.0) else start
    ends = sorted((start, start + zoom * count))
    first, end = (min(max(int(np.ceil(edge - 0.5)), 0), limit) for edge in ends)
    centres = np.arange(first, end) + 0.5
    shown = np.floor((centres - start) / zoom).astype(np.int64)
    return first, np.clip(shown, 0, count - 1)


def _placed(
    image: NDArray[Any], raster: RasterPosition, zoom: tuple[float, float], size: tuple[int, int]
) -> tuple[NDArray[Any], tuple[int, int]] | None:
    """The part of the picture that is inside the framebuffer, zoomed, and its lower left pixel."""
    height, width = image.shape[:2]
    x, columns = _columns(raster.x, zoom[0], width, size[0])
    y, rows = _columns(raster.y, zoom[1], height, size[1])
    if not len(columns) or not len(rows):
        return None
    if len(columns) == width and len(rows) == height and zoom == (1.0, 1.0):
        return image, (x, y)
    return np.ascontiguousarray(image[rows[:, None], columns]), (x, y)


def _rectangle(
    shape: tuple[int, ...], origin: tuple[int, int], raster: RasterPosition, state: Snapshot, size: tuple[int, int]
) -> Draw:
    """A Draw of the rectangle's pixels at the raster position's depth, with its colour and texture coordinates."""
    rows = np.zeros((4, ROW), np.float32)
    corners = np.array([(0, 0), (shape[1], 0), (shape[1], shape[0]), (0, shape[0])]) + origin
    rows[:, :2] = corners / np.array(size) * 2.0 - 1.0
    rows[:, 2] = 2.0 * raster.z - 1.0
    rows[:, 6:10] = raster.color
    columns = {f"texcoord{unit}": np.array([raster.texcoords[unit]], np.float32) for unit in range(TEXTURE_UNITS)}
    columns["fog_coord"] = np.array([[raster.distance]], np.float32)
    columns["secondary_color"] = np.array([raster.secondary_color], np.float32)
    return Draw(gl.GL_QUADS, 0, 4, None, (identity(),) * 3, Material(), state, Vertices(rows, columns, []))


# ---------------------------------------------------------------- many bitmaps: text


def merged_bitmaps(packets: Iterable[Pixels], size: tuple[int, int]) -> Iterator[Pixels]:
    """The same picture, of this size (width, height), with fewer packets: bitmaps that differ only in their place
    become one.

    Only where fragments do not depend on the framebuffer's content: without blending, logic op and stencil.
    """
    run: list[Pixels] = []
    for packet in packets:
        if run and not (_mergeable(packet) and _same(run[0], packet)):
            yield _union(run, size)
            run = []
        if not _mergeable(packet):
            yield packet
        else:
            run.append(packet)
    if run:
        yield _union(run, size)


def _mergeable(packet: Pixels) -> bool:
    state = packet.state
    free = not (state.color_buffer.blend or state.color_buffer.logic_op_enabled or state.stencil.test)
    near = abs(packet.raster.x) < 1e5 and abs(packet.raster.y) < 1e5
    return packet.kind == "bitmap" and free and near


def _same(a: Pixels, b: Pixels) -> bool:
    return a.state == b.state and a.raster[3:] == b.raster[3:]


def _union(run: list[Pixels], size: tuple[int, int]) -> Pixels:
    """One bitmap as large as what is inside of the framebuffer."""
    if len(run) == 1:
        return run[0]
    places = [(int(packet.raster.x), int(packet.raster.y), packet.image) for packet in run]
    left, bottom = max(min(x for x, _, _ in places), 0), max(min(y for _, y, _ in places), 0)
    right = min(max(x + image.shape[1] for x, _, image in places if image is not None), size[0])
    top = min(max(y + image.shape[0] for _, y, image in places if image is not None), size[1])
    whole = np.zeros((max(top - bottom, 0), max(right - left, 0), 1), np.uint8)
    for x, y, image in places:
        assert image is not None
        seen = image[max(bottom - y, 0) : max(top - y, 0), max(left - x, 0) : max(right - x, 0)]
        row, column = max(y - bottom, 0), max(x - left, 0)
        whole[row : row + seen.shape[0], column : column + seen.shape[1]] |= seen
    return run[0]._replace(image=whole, raster=run[0].raster._replace(x=float(left), y=float(bottom)))
