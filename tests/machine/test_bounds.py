"""One cheap call asks for no more than bounded memory and time, or is refused with a sentence."""

from __future__ import annotations

import tracemalloc
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.glu import *
from glsim.glut import *
from glsim.machine import machine as machine_module
from glsim.machine.cache import cached, size_of


def peak(work: Callable[[], object]) -> float:
    """MiB that Python and NumPy took at most."""
    tracemalloc.start()
    try:
        work()
        return tracemalloc.get_traced_memory()[1] / 2**20
    finally:
        tracemalloc.stop()


HUGE = 10**6


@pytest.mark.parametrize(
    "call",
    [
        lambda: glutSolidSphere(1, HUGE, HUGE),
        lambda: glutWireSphere(1, HUGE, HUGE),
        lambda: glutSolidCone(1, 1, HUGE, HUGE),
        lambda: glutWireCylinder(1, 1, HUGE, HUGE),
        lambda: glutSolidTorus(1, 2, HUGE, HUGE),
        lambda: glutSolidSierpinskiSponge(30, (0, 0, 0), 1),
        lambda: glGenLists(2**31),
        lambda: glGenTextures(2**31),
        lambda: glGenBuffers(2**31),
        lambda: glGenQueries(2**31),
        lambda: glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 2**31, [0.0]),
        lambda: glEvalMesh1(GL_LINE, 0, 2**31),
        lambda: glEvalMesh2(GL_FILL, 0, 2**20, 0, 2**20),
        lambda: glBitmap(2**30, 2**30, 0, 0, 0, 0, b""),
        lambda: glDrawPixels(2**30, 2**30, GL_RGBA, GL_FLOAT, b""),
        lambda: glReadPixels(0, 0, 16000, 16000, GL_RGBA, GL_FLOAT),
        lambda: glCopyPixels(0, 0, 16000, 16000, GL_COLOR),
        lambda: glPolygonStipple(b"short"),
    ],
)
def test_what_is_too_large_is_refused(screen: glsim.Offscreen, call: Callable[[], Any]) -> None:
    def refused() -> None:
        with pytest.raises((GLError, ValueError), match=r"most|more|from 1 to|larger|needs"):
            call()

    assert peak(refused) < 32


def test_quadrics_of_too_many_pieces_are_not_drawn(screen: glsim.Offscreen) -> None:
    said: list[int] = []
    quad = gluNewQuadric()
    gluQuadricCallback(quad, GLU_ERROR, said.append)
    for call in (
        lambda: gluSphere(quad, 1, HUGE, HUGE),
        lambda: gluCylinder(quad, 1, 1, 1, HUGE, HUGE),
        lambda: gluDisk(quad, 0, 1, HUGE, HUGE),
    ):
        assert peak(call) < 1
    assert said == [GLU_OUT_OF_MEMORY] * 3


def test_nurbs_sampled_without_end_are_not_drawn(screen: glsim.Offscreen) -> None:
    said: list[int] = []
    nurb = gluNewNurbsRenderer()
    gluNurbsCallback(nurb, GLU_NURBS_ERROR, said.append)
    gluNurbsProperty(nurb, GLU_SAMPLING_METHOD, GLU_DOMAIN_DISTANCE)
    knots, points = [0, 0, 0, 0, 1, 1, 1, 1], np.zeros((4, 4, 3), np.float32)

    def surface() -> None:
        gluBeginSurface(nurb)
        gluNurbsSurface(nurb, knots, knots, points, GL_MAP2_VERTEX_3)
        gluEndSurface(nurb)

    def curve() -> None:
        gluBeginCurve(nurb)
        gluNurbsCurve(nurb, knots, points[0], GL_MAP1_VERTEX_3)
        gluEndCurve(nurb)

    for step in (1e5, 1e12, float("inf")):
        gluNurbsProperty(nurb, GLU_U_STEP, step)
        gluNurbsProperty(nurb, GLU_V_STEP, step)
        assert peak(surface) < 8
        said.clear() if step == 1e5 else None
    assert peak(curve) < 8
    assert said == [GLU_OUT_OF_MEMORY] * 3
    gluNurbsProperty(nurb, GLU_U_STEP, 10)
    gluNurbsProperty(nurb, GLU_V_STEP, 10)
    surface()
    assert said == [GLU_OUT_OF_MEMORY] * 3
    assert [len(draw.indices) for draw in screen.machine.packets] == [4 * 10 * 10]


def test_bitmaps_far_apart(screen: glsim.Offscreen) -> None:
    """They are merged into one picture, which is no larger than the framebuffer; what reaches into it is drawn."""
    places = [(-99999, -99999), (99999, 99999), (5, 7), (120, 124), (-3, -2), (125, -4), (60, 99990)]
    bits = np.packbits(np.random.default_rng(1).integers(0, 2, (8, 8)), axis=1).tobytes()

    def draw(together: bool) -> None:
        for place in places:
            glWindowPos2i(0, 0)
            glBitmap(0, 0, 0, 0, *place, b"")
            glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
            glBitmap(8, 8, 0, 0, 0, 0, bits)
            if not together:
                glFlush()

    draw(together=False)
    alone = screen.pixels()
    assert alone[..., 0].any()
    screen.reset()
    draw(together=True)
    assert peak(screen.pixels) < 8
    assert np.array_equal(screen.pixels(), alone)


def test_shapes_are_kept_up_to_a_number_of_bytes() -> None:
    calls: list[int] = []

    @cached(1_000_000)
    def shape(n: int) -> tuple[np.ndarray[Any, Any], ...]:
        calls.append(n)
        return np.zeros(n, np.uint8), np.zeros((n, 2), np.uint8)

    for n in (50_000, 60_000, 50_000, 300_000, 300_000):  # the largest is more than a quarter
        assert size_of(shape(n)) == 3 * n
    assert calls == [50_000, 60_000, 300_000, 300_000]
    for n in range(70_000, 80_000, 1000):
        shape(n)
    calls.clear()
    shape(79_000)
    shape(50_000)  # the oldest is gone
    assert calls == [50_000]


@pytest.mark.slow
def test_a_slider_over_slices_keeps_little(screen: glsim.Offscreen) -> None:
    def slide() -> None:
        for n in range(300, 330):
            glutSolidSphere(1, n, n)
            screen.machine.packets.clear()
            screen.machine.take_vertices()

    tracemalloc.start()
    slide()
    kept_now = tracemalloc.get_traced_memory()[0] / 2**20
    tracemalloc.stop()
    assert kept_now < 150  # two kinds of results, 64 MiB each; all of them take 230


@pytest.mark.slow
def test_a_program_that_never_flushes_stays_small(screen: glsim.Offscreen, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(machine_module, "MANY", 100)
    monkeypatch.setattr(machine_module, "LARGE", 100_000)
    image = bytes(64 * 64 * 4)
    glNewList(1, GL_COMPILE)
    glRectf(-1, -1, 1, 1)
    glEndList()
    buffer = glGenBuffers(1)
    glBindBuffer(GL_ARRAY_BUFFER, buffer)
    glBufferData(GL_ARRAY_BUFFER, np.zeros((3, 2), np.float32), GL_STATIC_DRAW)
    glEnableClientState(GL_VERTEX_ARRAY)
    for call in (
        lambda: glClear(GL_COLOR_BUFFER_BIT),
        lambda: glRectf(0, 0, 1, 1),
        lambda: glAccum(GL_ADD, 0.0),
        lambda: glCallList(1),
        lambda: glCallLists([1] * 50),
        lambda: (glBegin(GL_POINTS), glEnd()),
        lambda: (glVertexPointer(2, GL_FLOAT, 0, None), glDrawArrays(GL_TRIANGLES, 0, 3)),
        lambda: glDrawPixels(64, 64, GL_RGBA, GL_UNSIGNED_BYTE, image),
        lambda: glBitmap(8, 8, 0, 0, 0, 0, b"\xff" * 32),
    ):
        for _ in range(300):
            call()
            assert len(screen.machine.packets) <= 150
            assert screen.machine.waiting <= 200_000
    screen.reset()
    glDrawPixels(64, 64, GL_RGBA, GL_UNSIGNED_BYTE, image)
    glFlush()
    assert screen.machine.waiting == 0


def test_a_list_with_more_vertices_than_are_kept_at_once(
    screen: glsim.Offscreen, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(machine_module, "LARGE", 1000)
    glNewList(1, GL_COMPILE)
    glBegin(GL_QUADS)
    for x in range(16):
        for corner in ((0, 0), (1, 0), (1, 1), (0, 1)):
            glVertex2f((x + corner[0]) / 8 - 1, 2 * corner[1] - 1)
    glEnd()
    glEndList()
    glCallList(1)
    assert (screen.pixels()[..., :3] == 255).all()


@pytest.mark.parametrize(
    ("gen", "delete"),
    [(glGenTextures, glDeleteTextures), (glGenBuffers, glDeleteBuffers), (glGenQueries, glDeleteQueries)],
)
def test_names_are_given_without_looking_at_all_of_them(
    screen: glsim.Offscreen, monkeypatch: pytest.MonkeyPatch, gen: Any, delete: Any
) -> None:
    assert [int(gen(1)) for _ in range(3000)] == list(range(1, 3001))
    assert all(lowest in (1, 3001) for lowest in screen.machine.objects.lowest.values())  # where the search begins
    delete([7, 9])
    assert gen(3).tolist() == [7, 9, 3001]
    assert int(gen(1)) == 3002


def test_names_of_textures_that_were_only_bound_are_used(screen: glsim.Offscreen) -> None:
    glBindTexture(GL_TEXTURE_2D, 2)
    assert glGenTextures(2).tolist() == [1, 3]
    glDeleteTextures([2])
    assert int(glGenTextures(1)) == 2


def test_numbers_of_lists_are_given_in_a_row(screen: glsim.Offscreen) -> None:
    assert [glGenLists(1) for _ in range(1000)] == list(range(1, 1001))
    glDeleteLists(5, 3)
    assert [glGenLists(4), glGenLists(2), glGenLists(1), glGenLists(1)] == [1001, 5, 7, 1005]
    glDeleteLists(1, 2**31)
    assert glGenLists(3) == 1
    glNewList(5, GL_COMPILE)
    glEndList()
    assert [glGenLists(2), glGenLists(1)] == [6, 4]
