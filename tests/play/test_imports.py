"""glsim run: what programs import, Python 2, other window libraries."""

from __future__ import annotations

import os
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

from glsim.play.python2 import converted, is_python_3
from tests.drawing import ROOT, picture, play, program_file

pytestmark = pytest.mark.slow  # each test runs programs in processes of their own


def test_imports_of_all_kinds(tmp_path: Path) -> None:
    script = program_file(
        tmp_path,
        """
        import OpenGL
        OpenGL.ERROR_CHECKING = False
        from OpenGL import GL, GLU, GLUT
        import OpenGL.GL as gl
        from OpenGL.GL.ARB.multitexture import *
        from OpenGL.GL.EXT.fog_coord import glInitFogCoordEXT, glFogCoordfEXT
        from OpenGL.arrays import vbo
        from OpenGL.error import GLError, GLUError
        from OpenGL.constants import GLfloat
        import numpy
        assert gl.GL_LIGHT0 is GL.GL_LIGHT0 and glInitMultitextureARB() and glInitFogCoordEXT()
        assert GL_TEXTURE1_ARB == GL.GL_TEXTURE1
        corners = vbo.VBO(numpy.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0)], 'f'))
        def display():
            glClear(GL_COLOR_BUFFER_BIT)
            glActiveTextureARB(GL_TEXTURE0_ARB)
            corners.bind()
            glEnableClientState(GL_VERTEX_ARRAY)
            glVertexPointerf(corners)
            glDrawArrays(GL_TRIANGLES, 0, 3)
            try:
                glEnable(12345)
            except GLError as error:
                assert error.err == GL_INVALID_ENUM
            glutSwapBuffers()
        glutDisplayFunc(display)
        glutMainLoop()
        """,
    )
    record = play(tmp_path, script)
    assert record["status"] == "ok", record
    assert picture(tmp_path)[60, 100].tolist() == [255, 255, 255]


PYTHON_2 = b"import sys\nprint 'angle', 7/2\nif sys.maxint > 0 and {}.has_key(1):\n\tpass\nraise ValueError, 'no'\n"


def test_python_2_is_recognized_and_converted() -> None:
    assert not is_python_3(PYTHON_2, "old.py")
    assert is_python_3(b"print('new')", "new.py")
    text = converted(PYTHON_2, "old.py")
    assert "print('angle', 7/2)" in text
    assert "1 in {}" in text


def test_python_2_programs_run(tmp_path: Path) -> None:
    old = "print 'old'\ndef display():\n\tglClearColor(1, 0, 0, 1)\n\tglClear(GL_COLOR_BUFFER_BIT)\n"
    old += "\tglutSwapBuffers()\n"
    script = program_file(tmp_path, old + "glutDisplayFunc(display)\nglutMainLoop()\n")
    record = play(tmp_path, script)
    assert record["status"] == "ok"
    assert "converted from Python 2" in record["notes"][0]
    assert picture(tmp_path)[0, 0].tolist() == [255, 0, 0]
    assert play(tmp_path, script, python2=False)["status"] == "python-error"


def test_pygame_programs(tmp_path: Path) -> None:
    pytest.importorskip("pygame")
    script = program_file(
        tmp_path,
        """
        import pygame
        from OpenGL.GL import *
        pygame.init()
        pygame.display.set_mode((90, 60), pygame.DOUBLEBUF | pygame.OPENGL)
        clock, color = pygame.time.Clock(), (1, 0, 0)
        while True:
            for event in pygame.event.get():
                if event.type == pygame.KEYDOWN and event.unicode == "g":
                    color = (0, 1, 0)
            glClearColor(*color, pygame.time.get_ticks() / 255)
            glClear(GL_COLOR_BUFFER_BIT)
            pygame.display.flip()
            clock.tick(60)
        """,
        front="",
    )
    record = play(tmp_path, script, frames=3, events=["tick", "key g"])
    assert (record["status"], record["frames"]) == ("ok", 3)
    assert [picture(tmp_path, f"frame_00{k}.png")[5, 5].tolist() for k in (1, 2)] == [[255, 0, 0], [0, 255, 0]]
    assert picture(tmp_path).shape == (60, 90, 3)


def test_glfw_programs(tmp_path: Path) -> None:
    pytest.importorskip("glfw")
    script = program_file(
        tmp_path,
        """
        import glfw
        from OpenGL.GL import *
        glfw.init()
        window = glfw.create_window(90, 60, "test", None, None)
        glfw.make_context_current(window)
        keys = []
        glfw.set_key_callback(window, lambda w, key, scancode, action, mods: keys.append(key))
        while not glfw.window_should_close(window):
            glViewport(0, 0, *glfw.get_framebuffer_size(window))
            glClearColor(len(keys) / 2, glfw.get_time(), 0, 1)
            glClear(GL_COLOR_BUFFER_BIT)
            glfw.swap_buffers(window)
            glfw.poll_events()
        """,
        front="",
    )
    assert play(tmp_path, script, frames=3, events=["key g"])["status"] == "ok"
    assert [picture(tmp_path, f"frame_00{k}.png")[5, 5, 0] for k in range(3)] == [0, 255, 255]
    assert picture(tmp_path, "frame_002.png")[5, 5, 1] == 10


def test_without_a_display_a_program_is_told_what_to_do(tmp_path: Path) -> None:
    pytest.importorskip("glfw")
    text = "import glsim.glut as glut\nglut.glutInit()\nglut.glutCreateWindow('x')\nglut.glutMainLoop()\n"
    environment = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
    words = [sys.executable, "-c", text]
    said = subprocess.run(words, env=environment, capture_output=True, text=True, cwd=ROOT).stderr
    assert "glsim run SCRIPT needs none" in said


def test_python_2_programs_keep_their_keys_their_division_and_their_modules(tmp_path: Path) -> None:
    (tmp_path / "helper.py").write_text("print 'helper'\nhalf = 3 / 2\n")
    old = textwrap.dedent("""
        import string, Image, helper
        log = open("log.txt", "w")
        print >>log, 7 / 2, 7.0 / 2, -7 / 2, helper.half, string.join(["a", "b"]), Image.new("RGB", (2, 2)).size
        n = 9
        n /= 2
        print >>log, n
        def key(c, x, y):
            print >>log, c == 'a', c in 'abc'
            log.flush()
        glutKeyboardFunc(key)
        glutDisplayFunc(lambda: None)
        glutMainLoop()
        """)
    record = play(tmp_path, program_file(tmp_path, old), events=["key a"])
    assert record["status"] == "ok", record
    assert (tmp_path / "log.txt").read_text().splitlines() == ["3 3.5 -4 1 a b (2, 2)", "4", "True True"]


def test_modules_of_python_2_beside_a_program_of_python_3_are_converted(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "__init__.py").write_text("")
    (tmp_path / "parts" / "deep.py").write_text("import string\nprint 'deep'\nletters = string.join(['a', 'b'], '')\n")
    (tmp_path / "helper.py").write_text("print 'helper'\nhalf = 3 / 2\n")
    new = "import helper\nfrom parts import deep\nprint(helper.half, 3 / 2, deep.letters, file=open('log.txt', 'w'))\n"
    new += "glutDisplayFunc(lambda: None)\nglutMainLoop()\n"
    record = play(tmp_path, program_file(tmp_path, new))
    assert record["status"] == "ok", record
    assert (tmp_path / "log.txt").read_text() == "1 1.5 ab\n"
    assert play(tmp_path, program_file(tmp_path, new), python2=False)["status"] == "python-error"


def test_arrays_of_characters_are_pixels(tmp_path: Path) -> None:
    """Python 2's array("c"), filled by chr and drawn."""
    old = textwrap.dedent("""
        from array import array
        print 'old'
        pixels = array("c", "\\0" * 12)
        for k in range(4):
            pixels[3 * k] = chr(255)
        pixels[4:6] = array('c', 'ab')
        pixels.append('z')
        print pixels[1] == '\\0', len(pixels), pixels.tostring()[4:6], pixels[4:6] == array('c', 'ab')
        def display():
            glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
            glDrawPixels(2, 2, GL_RGB, GL_UNSIGNED_BYTE, pixels)
            glutSwapBuffers()
        glutDisplayFunc(display)
        glutMainLoop()
        """)
    record = play(tmp_path, program_file(tmp_path, old))
    assert record["status"] == "ok", record
    lit = picture(tmp_path)[..., 0].nonzero()
    assert len(lit[0]) == 4


def test_later_versions_can_be_asked_for(tmp_path: Path) -> None:
    script = program_file(
        tmp_path,
        """
        import numpy
        assert not bool(glCreateShader) and not glGenFramebuffers
        assert b"GL_ARB_multitexture" in glGetString(GL_EXTENSIONS) and glutExtensionSupported("GL_ARB_multitexture")
        glTexImage2Dub(GL_TEXTURE_2D, 0, GL_RGB, 0, GL_RGB, numpy.zeros((8, 4, 3), "u1"))
        assert glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH) == 8
        glWindowPos2i(0, 0)
        glDrawPixelsf(GL_LUMINANCE, numpy.ones((3, 3), "f"))
        assert glReadPixelsub(0, 0, 1, 1, GL_RGB) == b"\\xff" * 3
        glCreateShader(GL_VERTEX_SHADER)
        """,
    )
    record = play(tmp_path, script)
    assert record["errors"][0]["error"].startswith("RuntimeError: glCreateShader came with OpenGL 2.0")
