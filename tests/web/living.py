"""What tests of live pictures share: a program with parameters, its page in a browser, and what is seen there."""

from __future__ import annotations

import base64
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import glsim
from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective
from glsim.glut import glutSolidSphere
from glsim.machine.frame import Frame
from glsim.study.live import live_of
from glsim.web.live import page
from tests.browser import Browser

SIZE = 128  # of the fixture screen
START: dict[str, Any] = {
    "position": [2.0, 3.0, 4.0, 1.0], "diffuse": [1.0, 0.9, 0.8, 1.0], "cutoff": 180.0, "exponent": 0.0,
    "attenuation": [1.0, 0.0, 0.0], "shininess": 20.0, "k_d": [0.2, 0.5, 0.8, 1.0], "k_s": [0.6, 0.6, 0.6, 1.0],
    "ambient": [0.2, 0.2, 0.2, 1.0], "eye": (1.0, 2.0, 6.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0), "fovy": 40.0,
    "shade": GL_SMOOTH, "lobe": GL_BLINN_TORRANCE_GLSIM, "headlight": [0.0, 0.0, 1.0, 0.0],
}  # fmt: skip


def drawn(**changes: Any) -> None:
    """Two balls on a floor, in a light of the world (0) and one at the viewer's head (1)."""
    v = {**START, **changes}
    glClearColor(0.1, 0.1, 0.15, 1.0)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    for capability in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0, GL_LIGHT1, GL_NORMALIZE):
        glEnable(capability)
    glShadeModel(v["shade"])
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, v["ambient"])
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1)
    glLightModeli(GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM, v["lobe"])
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(v["fovy"], 1.0, 1.0, 30.0)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    glLightfv(GL_LIGHT1, GL_POSITION, v["headlight"])
    glLightfv(GL_LIGHT1, GL_DIFFUSE, [0.2, 0.2, 0.2, 1.0])
    gluLookAt(*v["eye"])
    glLightfv(GL_LIGHT0, GL_POSITION, v["position"])
    glLightfv(GL_LIGHT0, GL_DIFFUSE, v["diffuse"])
    glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, [-2.0, -3.0, -4.0])
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, v["cutoff"])
    glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, v["exponent"])
    for name, k in zip(("CONSTANT", "LINEAR", "QUADRATIC"), v["attenuation"], strict=True):
        glLightf(GL_LIGHT0, globals()[f"GL_{name}_ATTENUATION"], k)
    glMaterialfv(GL_FRONT, GL_DIFFUSE, v["k_d"])
    glMaterialfv(GL_FRONT, GL_SPECULAR, v["k_s"])
    glMaterialf(GL_FRONT, GL_SHININESS, v["shininess"])
    glutSolidSphere(1.0, 24, 12)
    glPushMatrix()
    glTranslatef(1.6, 0.4, -1.0)
    glScalef(0.6, 0.9, 0.6)
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.8, 0.3, 0.2, 1.0])
    glutSolidSphere(1.0, 20, 10)
    glPopMatrix()
    glNormal3f(0.0, 1.0, 0.0)
    glBegin(GL_QUADS)
    for x in range(-4, 4):
        for z in range(-4, 4):
            for dx, dz in ((0, 0), (0, 1), (1, 1), (1, 0)):
                glVertex3f(x + dx, -1.0, z + dz)
    glEnd()


def pixels(screen: glsim.Offscreen, draw: Callable[[], None]) -> NDArray[np.uint8]:
    screen.reset()
    draw()
    return screen.pixels().copy()


def frame_of(screen: glsim.Offscreen, draw: Callable[[], None]) -> Frame:
    screen.reset()
    with glsim.capture(calls=True) as frame:
        draw()
    return frame


def opened(browser: Browser, path: Path, frames: dict[str, Frame], **options: Any) -> None:
    path.write_text(page(live_of(frames, "two balls", samples=0, **options)), encoding="utf-8")
    browser.open(path, 1280, 900)
    browser.until("return document.querySelector('glsim-live').dataset.state === 'ready'")


SEEN = """const done = arguments[0], live = document.querySelector('glsim-live');
live.change().then(() => {
  const bytes = live.player.pixels(); let text = "";
  for (let k = 0; k < bytes.length; k += 8192) text += String.fromCharCode(...bytes.subarray(k, k + 8192));
  done(btoa(text));
});"""


def seen(browser: Browser, code: str = "") -> NDArray[np.uint8]:
    """The picture after some code has run with ``live``: (height, width, 4), top row first."""
    browser.js(f"const live = document.querySelector('glsim-live'); {code}")
    data = base64.b64decode(browser.driver.execute_async_script(SEEN))
    return np.frombuffer(data, np.uint8).reshape(SIZE, SIZE, 4)[::-1]


def off(a: NDArray[np.uint8], b: NDArray[np.uint8]) -> float:
    """The share of pixels that differ by more than 2/255."""
    return float((np.abs(a.astype(int) - b).max(axis=2) > 2).mean())
