"""Contexts in several threads, in forked processes, and under signals that come at a bad moment."""

from __future__ import annotations

import gc
import os
import signal
import sys
import threading
from collections.abc import Callable

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.gl import immediate
from glsim.machine.current import current_machine, make_current
from glsim.machine.interrupts import uninterrupted
from tests.drawing import portions, python
from tests.machine.moments import interrupted


def in_a_thread(work: Callable[[], object]) -> list[object]:
    """What ``work`` returned, or the exception that it raised."""
    result: list[object] = []

    def run() -> None:
        try:
            result.append(work())
        except Exception as error:
            result.append(error)

    thread = threading.Thread(target=run)
    thread.start()
    thread.join(60)
    assert not thread.is_alive()
    return result


def lit_fan(turn: int) -> None:
    """Lights, materials, lists, arrays, textures, text: something of everything, another picture for each turn."""
    glClearColor(0.1 * turn, 0.2, 0.3, 1.0)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glLightfv(GL_LIGHT0, GL_POSITION, (0.3, turn * 0.1, 1.0, 0.0))
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (1.0, 0.3 * turn, 0.1, 1.0))
    glNewList(turn + 1, GL_COMPILE)
    glBegin(GL_TRIANGLE_FAN)
    for k in range(9):
        glNormal3f(0.1 * k, 0.0, 1.0)
        glVertex2f(np.cos(k + turn), np.sin(k + turn))
    glEnd()
    glEndList()
    glPushMatrix()
    glScalef(0.5, 0.5, 0.5)
    glCallList(turn + 1)
    glPopMatrix()
    glDisable(GL_LIGHTING)
    glVertexPointerf([(-1.0, -1.0), (1.0, -1.0), (0.0, -0.7)])
    glEnableClientState(GL_VERTEX_ARRAY)
    glColor3ub(20 * turn, 255, 0)
    glDrawArrays(GL_TRIANGLES, 0, 3)
    glWindowPos2i(turn, 3)
    glDrawPixels(2, 2, GL_RGB, GL_UNSIGNED_BYTE, bytes(range(turn, turn + 12)))


def test_each_thread_has_its_own_current_context(screen: glsim.Offscreen) -> None:
    expected = []
    for turn in range(4):
        screen.reset()
        lit_fan(turn)
        expected.append(screen.pixels())
    together = threading.Barrier(4)

    def draw(turn: int) -> None:
        with glsim.offscreen(screen.width, screen.height) as own:
            together.wait(30)
            for _ in range(15):
                own.reset()
                lit_fan(turn)
                if not np.array_equal(own.pixels(), expected[turn]):
                    wrong.append(turn)
            together.wait(30)

    wrong: list[int] = []
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-5)  # in the middle of everything
    threads = [threading.Thread(target=draw, args=(turn,)) for turn in range(4)]
    try:
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(60)
    finally:
        sys.setswitchinterval(interval)
    assert not together.broken
    assert wrong == []
    lit_fan(2)  # this thread's context is what it was
    assert np.array_equal(screen.pixels(), expected[2])


def test_one_thread_alone_reaches_its_machine_without_detour(screen: glsim.Offscreen) -> None:
    def other() -> object:
        with glsim.offscreen(8, 8) as own:
            assert current_machine() is own.machine
            return immediate.current is own.machine

    assert in_a_thread(other) == [False]
    assert immediate.current is screen.machine


def test_a_second_thread_between_begin_and_end(screen: glsim.Offscreen) -> None:
    """The first thread goes on where it was, without making its context current again."""

    def other() -> object:
        kept.append(glsim.offscreen(8, 8))
        glColor3f(0, 0, 1)
        with pytest.raises(GLError, match="there is no glBegin"):
            glEnd()
        glRectf(-1, -1, 1, 1)
        return kept[0].pixels()[4, 4, :3].tolist()

    kept: list[glsim.Offscreen] = []
    barrier = threading.Barrier(2)
    said: list[object] = []
    thread = threading.Thread(target=lambda: (said.append(other()), barrier.wait(30), barrier.wait(30)))
    glColor3f(1, 0, 0)
    glBegin(GL_TRIANGLES)
    glVertex2f(-1, -1)
    thread.start()
    barrier.wait(30)
    glVertex2f(3, -1)
    with pytest.raises(GLError, match="not allowed between glBegin and glEnd"):
        glClear(GL_COLOR_BUFFER_BIT)
    with pytest.raises(TypeError, match="glVertex3f: x must be a number, not 'a'"):
        glVertex3f("a", 0, 0)
    glVertex2f(-1, 3)
    glEnd()
    picture = screen.pixels()
    barrier.wait(30)
    thread.join(30)
    assert said == [[0, 0, 255]]
    assert (picture[..., :3] == (255, 0, 0)).all()


def test_recording_beside_another_thread(screen: glsim.Offscreen) -> None:
    def other() -> object:
        with glsim.offscreen(8, 8), glsim.capture(calls=True) as frame:
            glBegin(GL_POINTS)
            glVertex2f(0, 0)
            glEnd()
        return frame.calls

    (calls,) = in_a_thread(other)
    assert isinstance(calls, list)
    assert [call.name for call in calls] == ["glBegin", "glVertex2f", "glEnd"]
    assert all(call.where.file == __file__ for call in calls)


def test_a_thread_without_a_context_is_told(screen: glsim.Offscreen) -> None:
    assert "no context is current in this thread" in str(in_a_thread(lambda: glBegin(GL_POINTS))[0])
    assert "no context is current in this thread" in str(in_a_thread(lambda: glRectf(0, 0, 1, 1))[0])
    glColor3f(1, 0, 0)
    glRectf(-1, -1, 1, 1)
    for work in (glFlush, glFinish, screen.pixels, screen.release, screen.reset, screen.make_current, screen.finish):
        (error,) = in_a_thread(work)
        assert str(error).startswith("a context can only be drawn with in the thread that made it"), work
    (error,) = in_a_thread(lambda: glReadPixels(0, 0, 1, 1, GL_RGB, GL_UNSIGNED_BYTE))
    assert str(error).startswith("a context can only be drawn with in the thread that made it")
    (error,) = in_a_thread(lambda: make_current(screen.machine))
    assert "current in another thread" in str(error)
    assert (screen.pixels()[..., :3] == (255, 0, 0)).all()  # nothing was lost


def test_a_thread_without_a_context_beside_two_that_have_one(screen: glsim.Offscreen) -> None:
    def middle() -> object:
        with glsim.offscreen(8, 8):
            return in_a_thread(lambda: glColor3f(0, 0, 1)) + in_a_thread(lambda: glEnable(GL_FOG))

    (errors,) = in_a_thread(middle)
    assert [str(error).split(":")[0] for error in errors] == ["no context is current"] * 2  # type: ignore[attr-defined]


def test_contexts_of_threads_that_ended_are_released(screen: glsim.Offscreen) -> None:
    def work() -> object:
        own = glsim.offscreen(8, 8)
        glRectf(-1, -1, 1, 1)
        own.pixels()
        return own.ctx, own._driver.loader

    opened = [in_a_thread(work)[0] for _ in range(5)]
    gc.collect()
    screen.pixels()
    for ctx, loader in opened:  # type: ignore[attr-defined, misc]
        assert type(ctx.mglo).__name__ == "InvalidObject"
        assert not loader.context


def test_the_context_of_a_thread_that_ended_can_be_drawn_with(screen: glsim.Offscreen) -> None:
    def work() -> object:
        own = glsim.offscreen(8, 8)
        glColor3f(0, 1, 0)
        glRectf(-1, -1, 1, 1)
        return own

    (own,) = in_a_thread(work)
    assert isinstance(own, glsim.Offscreen)
    assert current_machine() is screen.machine
    assert (own.pixels()[..., :3] == (0, 255, 0)).all()
    with own:
        glColor3f(1, 0, 0)
        glRectf(-1, -1, 1, 1)
        assert (own.pixels()[..., :3] == (255, 0, 0)).all()
    assert "can only be drawn with" in str(in_a_thread(own.pixels)[0])  # it is this thread's now
    own.release()


FORK = """
import os, sys, glsim
from glsim.gl import *
glsim.offscreen(8, 8).release() if "released" in sys.argv else None
screen = glsim.offscreen(8, 8); glRectf(-1, -1, 1, 1); screen.pixels()
sys.stdout.flush()
child = os.fork()
if not child:
    other = lambda: glsim.offscreen(8, 8)
    for work in (other, lambda: glColor3f(1, 0, 0), glFlush, screen.pixels, screen.make_current):
        try: print(work())
        except RuntimeError as error: print(error)
    sys.exit()
print("child", os.waitpid(child, 0)[1], int(screen.pixels()[4, 4, 0]))
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this platform does not fork")
@pytest.mark.slow
def test_a_forked_process_is_told_to_spawn() -> None:
    for argument in ("", "released"):
        done = python("-c", FORK, argument)
        *child, parent = done.stdout.splitlines()
        assert len(child) == 5, done.stderr
        assert all(line.startswith("this process was forked") and '"spawn"' in line for line in child)
        assert parent == "child 0 255"


FORK_BEFORE = """
import multiprocessing, glsim
from glsim.gl import *
def job(k):
    with glsim.offscreen(8, 8) as screen:
        glRectf(-1, -1, 1, 1)
        return int(screen.pixels()[4, 4, 0])
pool = multiprocessing.get_context("fork").Pool(2)
screen = glsim.offscreen(8, 8)
print(pool.map_async(job, [1, 2, 3]).get(30), flush=True)
pool.terminate()
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this platform does not fork")
@pytest.mark.slow
def test_processes_forked_before_the_first_context_draw() -> None:
    done = python("-c", FORK_BEFORE)
    assert done.stdout == "[255, 255, 255]\n", done.stderr


# ---------------------------------------------------------------- signals


def test_a_signal_waits_until_the_section_has_ended() -> None:
    done: list[int] = []
    with pytest.raises(KeyboardInterrupt):  # noqa: PT012
        with uninterrupted():
            with uninterrupted():
                signal.raise_signal(signal.SIGINT)
                done.append(1)
            done.append(2)  # the inner section's end is not the end
        done.append(3)
    assert done == [1, 2]
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    with pytest.raises(KeyboardInterrupt):
        signal.raise_signal(signal.SIGINT)
    assert in_a_thread(lambda: uninterrupted().__enter__()) == [None]  # handlers never run there
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_what_is_ignored_stays_ignored() -> None:
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        with uninterrupted():
            signal.raise_signal(signal.SIGINT)
        assert signal.getsignal(signal.SIGINT) is signal.SIG_IGN
    finally:
        signal.signal(signal.SIGINT, before)


# Exceptions at any moment of a program that opens, draws, reads, resizes and releases contexts.
INTERRUPTED = """
import random, signal, glsim, numpy as np
from glsim.gl import *
from tests.machine.moments import interrupted
def handler(*a): raise KeyboardInterrupt
signal.signal(signal.SIGALRM, handler)
dice = random.Random(1); hits = 0
image = bytes(range(64)) * 4
def draw():
    glEnable(GL_LIGHTING); glRectf(-1, -1, 1, 1); glDisable(GL_LIGHTING)
    glEnable(GL_TEXTURE_2D)
    glBindTexture(GL_TEXTURE_2D, glGenTextures(1))
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST)
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, image)
    glRectf(-1, -1, 0, 0); glDisable(GL_TEXTURE_2D)
    glNewList(1, GL_COMPILE); glRectf(0, 0, 1, 1); glEndList(); glCallList(1)
    glWindowPos2i(2, 2); glDrawPixels(4, 4, GL_RGBA, GL_UNSIGNED_BYTE, image[:64])
    glBitmap(8, 8, 0, 0, 4, 0, image[:8])
def work():
    with glsim.offscreen(16, 16) as screen:
        draw(); screen.pixels(); screen.resize(17, 18); draw(); screen.depth()
    screen.release()
keep = glsim.offscreen(16, 16); draw(); right = keep.pixels()
work(); moments = interrupted(work)
for k in range(40):
    try: interrupted(work, dice.randrange(1, moments))
    except KeyboardInterrupt: hits += 1
    except GLError: pass
    keep.make_current(); keep.reset(); draw()
    assert np.array_equal(keep.pixels(), right), k
print(moments, hits)
"""


@pytest.mark.skipif(not hasattr(signal, "SIGALRM"), reason="this platform has no SIGALRM")
@pytest.mark.slow
def test_exceptions_from_signals_break_nothing() -> None:
    done = python("-c", INTERRUPTED)
    assert done.returncode == 0, (done.returncode, done.stderr)
    moments, hits = map(int, done.stdout.split())
    assert moments > 10_000
    assert hits > 35


@pytest.mark.skipif(not hasattr(signal, "SIGALRM"), reason="this platform has no SIGALRM")
@pytest.mark.parametrize("portion", portions(10))
def test_an_interrupted_list_leaves_the_calls_where_they_went(portion: int, screen: glsim.Offscreen) -> None:
    """A signal before each bytecode of three calls."""

    def handler(*arguments: object) -> None:
        raise KeyboardInterrupt

    def work() -> None:
        glNewList(1, GL_COMPILE)
        glRectf(0, 0, 1, 1)
        glEndList()

    work()
    screen.reset()
    gc.collect()
    gc.disable()  # what other tests left is not to be collected, and counted, here
    before = signal.signal(signal.SIGALRM, handler)
    try:
        for _ in range(2):  # the first time some caches are filled
            moments = interrupted(work)
            screen.reset()
        assert moments > 500
        tried = range(portion + 1, moments, 10)
        hits = 0
        for moment in tried:
            try:
                assert interrupted(work, moment) < moment, "the work was shorter this time"
            except KeyboardInterrupt:
                hits += 1
            assert immediate.current is current_machine() is screen.machine
            assert signal.getsignal(signal.SIGALRM) is handler
            screen.reset()
        assert hits > 0.9 * len(tried)
    finally:
        gc.enable()
        signal.signal(signal.SIGALRM, before)
