"""A click into a real window: what the handlers of glfw's events make of it, without a display."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import glsim
from glsim.cli.study import show_probe
from glsim.gl import *
from glsim.glut.display import Shown
from glsim.play.capture import capture


@pytest.fixture
def window() -> SimpleNamespace:
    """A window of 100 x 50 points that shows a picture of 200 x 100 pixels."""
    return SimpleNamespace(ident=1, shown=np.zeros((100, 200, 3), np.uint8), menus={}, callbacks={})


@pytest.fixture
def clicks() -> list[tuple[int, int]]:
    return []


@pytest.fixture
def shown(window: SimpleNamespace, clicks: list[tuple[int, int]]) -> Any:
    one = object.__new__(Shown)
    one.glfw = SimpleNamespace(
        MOUSE_BUTTON_LEFT=0, MOUSE_BUTTON_MIDDLE=2, MOUSE_BUTTON_RIGHT=1, PRESS=1, RELEASE=0,
        get_cursor_pos=lambda handle: (0.0, 0.0), get_window_size=lambda handle: (100, 50),
    )  # fmt: skip
    one.window, one.handle, one.popup, one.buttons, one.pressed, one.pointer = window, None, None, set(), None, (0, 0)
    one.loop = SimpleNamespace(windows={1: window}, fire=lambda *arguments: True)
    one.display = SimpleNamespace(on_click=lambda _, x, y: clicks.append((x, y)))
    return one


def test_a_click_names_the_pixel_of_the_picture(shown: Any, clicks: list[tuple[int, int]]) -> None:
    shown._moved(None, 30.4, 20.9)
    shown._button(None, 0, 1, 0)
    assert clicks == []
    shown._button(None, 0, 0, 0)
    assert clicks == [(60, 40)]


def test_a_drag_and_other_buttons_are_no_clicks(shown: Any, clicks: list[tuple[int, int]]) -> None:
    shown._moved(None, 30, 20)
    shown._button(None, 0, 1, 0)
    shown._moved(None, 60, 20)
    shown._button(None, 0, 0, 0)
    for action in (1, 0):
        shown._button(None, 1, action, 0)
    shown._button(None, 0, 0, 0)  # pressed outside of the window
    assert clicks == []


def test_a_click_after_which_the_window_is_gone(shown: Any, clicks: list[tuple[int, int]]) -> None:
    shown._button(None, 0, 1, 0)
    shown.loop.windows.clear()
    shown._button(None, 0, 0, 0)
    assert clicks == []


def test_the_probe_of_a_click_is_printed(screen: glsim.Offscreen, capsys: pytest.CaptureFixture[str]) -> None:
    with capture() as frame:
        glColor3f(1, 0, 0)
        glRectf(-1, -1, 1, 1)
    show_probe(frame, 5, 7)
    assert "Pixel (5, 7)" in capsys.readouterr().out
    show_probe(frame, 500, 7)
    assert "128 x 128 pixels" in capsys.readouterr().out
