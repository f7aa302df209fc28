"""State -> key -> GLSL, and drawing in batches."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import glsim
from glsim.files import data_folder
from glsim.gl import *
from glsim.play.capture import capture
from glsim.render import compile, programs
from glsim.render.batch import Plan, plans
from glsim.render.key import LightKind, ProgramKey, program_key


def key() -> ProgramKey:
    from glsim.machine.current import current_machine

    return program_key(current_machine().snapshot())


def test_what_does_not_matter_does_not_change_the_key(screen: glsim.Offscreen) -> None:
    before = key()
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1)
    glEnable(GL_LIGHT3)
    glEnable(GL_COLOR_MATERIAL)
    glLightf(GL_LIGHT3, GL_SPOT_CUTOFF, 30)
    glEnable(GL_NORMALIZE)
    assert key() == before  # lighting is off
    glEnable(GL_LIGHTING)
    lit = key()
    assert lit != before
    glLightfv(GL_LIGHT3, GL_DIFFUSE, [0.1, 0.2, 0.3, 1])  # a value
    glMaterialf(GL_FRONT, GL_SHININESS, 9)
    glLightf(GL_LIGHT5, GL_SPOT_CUTOFF, 30)  # a light that is off
    assert key() == lit
    glLightf(GL_LIGHT3, GL_LINEAR_ATTENUATION, 1)  # directional: attenuation does not matter
    assert key() == lit
    glLightfv(GL_LIGHT3, GL_POSITION, [0, 0, 1, 1])
    assert key().lights == (LightKind(3, True, True, True),)


def test_program_source_is_the_glsl_of_the_present_state(screen: glsim.Offscreen) -> None:
    plain = glsim.program_source("vertex")
    assert plain.startswith("#version 330 core\n")
    assert "const bool LIGHTING = false;" in plain
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT4)
    glShadeModel(GL_PHONG_WIN)
    source = glsim.program_source("fragment")
    assert "const bool PER_FRAGMENT = true;" in source
    assert "const int[1] LIGHT_NUMBER = int[1](4);" in source
    assert "R = (N.L) N + S" in source
    assert "vertex shader" in glsim.program_source()
    with pytest.raises(ValueError, match="stage must be"):
        glsim.program_source("geometry")


def test_every_line_of_the_sources_keeps_its_file_and_number() -> None:
    """Walking the expanded text with #line gives back each line of each file in shaders/."""
    for name in ("main.vert", "main.frag", "probe.frag"):
        text, files = programs.expand(name)
        number, line = 0, 0
        for row in text.splitlines():
            if row.startswith("#line"):
                number, line = divmod(int(row.split()[1]), 1000)
                continue
            original = (data_folder("shaders") / files[number]).read_text().splitlines()[line - 1]
            assert row == original or (not row and original.startswith("#include"))
            line += 1


def test_a_broken_shader_is_named_with_file_and_line(
    screen: glsim.Offscreen, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for source in data_folder("shaders").iterdir():
        (tmp_path / source.name).write_text(source.read_text())
    lines = (tmp_path / "specular.glsl").read_text().splitlines()
    at = next(k for k, line in enumerate(lines) if "vec3 H = " in line)
    lines[at] = "    vec3 H = normalize(L + W);"
    (tmp_path / "specular.glsl").write_text("\n".join(lines))
    monkeypatch.setattr(programs, "data_folder", lambda kind: tmp_path)
    programs.expand.cache_clear()
    try:
        with screen.ctx, pytest.raises(compile.ShaderError, match=rf"specular\.glsl:{at + 1}:"):
            compile.build(screen.ctx, key())
    finally:
        programs.expand.cache_clear()


# ---------------------------------------------------------------- batches


def planned(frame: glsim.Frame, limit: int = 256) -> list[Plan]:
    return plans(list(frame.draws), limit)[1]


def quad(x: float) -> None:
    glBegin(GL_QUADS)
    for dx, dy in ((0, 0), (0.1, 0), (0.1, 0.1), (0, 0.1)):
        glVertex2f(x + dx, dy)
    glEnd()


def test_neighbours_that_differ_in_values_become_one_draw(screen: glsim.Offscreen) -> None:
    glEnable(GL_LIGHTING)
    with capture() as frame:
        for k in range(20):
            glPushMatrix()
            glTranslatef(0.1 * k, 0, 0)
            glMaterialfv(GL_FRONT, GL_DIFFUSE, [k / 20, 0, 0, 1])
            quad(-0.9)
            glPopMatrix()
    assert len(frame.packets) == 20
    (todo,) = planned(frame)
    assert len(todo.batches) == 1
    assert todo.batches[0].objects == 20
    assert len(planned(frame, 8)[0].batches) == 3


def test_a_change_of_state_parts_the_batch_and_keeps_the_order(screen: glsim.Offscreen) -> None:
    with capture() as frame:
        for k in range(6):
            glShadeModel(GL_FLAT if k // 2 % 2 else GL_SMOOTH)
            glColor3f(k / 6, 1, 0)
            quad(0)  # each over the one before
    assert len(planned(frame)[0].batches) == 3
    assert screen.pixels()[60, 66, 0] == round(255 * 5 / 6)


def test_the_same_state_again_is_the_same_batch(screen: glsim.Offscreen) -> None:
    with capture() as frame:
        quad(0)
        glEnable(GL_CULL_FACE)
        glDisable(GL_CULL_FACE)
        quad(0.5)
    assert len(planned(frame)[0].batches) == 1


def test_a_frame_can_be_drawn_again_elsewhere(screen: glsim.Offscreen) -> None:
    with capture(calls=True) as frame:
        glClearColor(0.2, 0.2, 0.2, 1)
        glClear(GL_COLOR_BUFFER_BIT)
        quad(-0.5)
        glFlush()
        quad(0.2)
    first = screen.pixels()
    other = glsim.offscreen(128, 128)
    other.execute(frame.packets)
    assert np.array_equal(other.pixels(), first)
    other.release()
    assert [call.name for call in frame.calls][:3] == ["glClearColor", "glClear", "glBegin"]
    assert frame.calls[3].arguments == (-0.5, 0)


def test_a_large_frame_is_flushed_before_it_is_ended(screen: glsim.Offscreen, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("glsim.machine.machine.LARGE", 4000)
    for k in range(50):
        quad(0.02 * k - 0.9)
    assert 0 < len(screen.machine.packets) < 40
    assert screen.pixels().any()


def test_calls_of_a_list_become_instances_and_its_buffers_are_kept(screen: glsim.Offscreen) -> None:
    number = glGenLists(1)
    glNewList(number, GL_COMPILE)
    quad(0)
    quad(0.3)
    glEndList()
    for _ in range(2):
        with capture() as frame:
            for k in range(7):
                glColor3f(k / 7, 0, 1)
                glCallList(number)
                glTranslatef(0, -0.1, 0)
        (todo,) = planned(frame)
        assert todo.instances
        assert [batch.objects for batch in todo.batches] == [7]
        screen.pixels()
        assert len(screen._renderer.static) == 1
    glDeleteLists(number, 1)
    del frame, todo
    screen.reset()
    assert len(screen._renderer.static) == 0
