"""The live picture in a browser: after every control it is the picture that moderngl draws with those values."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.render.context import own_screen
from tests.browser import Browser
from tests.web.living import SIZE, drawn, frame_of, off, opened, pixels, seen

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def live(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Browser:
    with own_screen(SIZE, SIZE) as screen:
        frame = frame_of(screen, drawn)
    opened(browser, tmp_path_factory.mktemp("live") / "page.html", {"picture": frame})
    return browser


RESET = "live.reset(); "
CONTROLS: dict[str, tuple[str, dict[str, Any]]] = {
    "nothing": ("", {}),
    "position": ("live.set('light.0.position', [-3, 2, 1, 1])", {"position": [-3.0, 2.0, 1.0, 1.0]}),
    "headlight": ("live.set('light.1.position', [1, 1, 0, 0])", {"headlight": [1.0, 1.0, 0.0, 0.0]}),
    "colour": ("live.set('light.0.diffuse', [1, 0.2, 0, 1])", {"diffuse": [1.0, 0.2, 0.0, 1.0]}),
    "spot": ("live.set('light.0.spot_cutoff', 12); live.set('light.0.spot_exponent', 4)",
             {"cutoff": 12.0, "exponent": 4.0}),
    "attenuation": ("live.set('light.0.quadratic_attenuation', 0.05)", {"attenuation": [1.0, 0.0, 0.05]}),
    "shininess": ("for (const k of [0, 1]) live.set(`material.${k}.front.shininess`, 3)", {"shininess": 3.0}),
    "specular": ("for (const k of [0, 1]) live.set(`material.${k}.front.specular`, [1, 0, 1, 1])",
                 {"k_s": [1.0, 0.0, 1.0, 1.0]}),
    "diffuse": ("live.set('material.0.front.diffuse', [0.9, 0.1, 0.4, 1])", {"k_d": [0.9, 0.1, 0.4, 1.0]}),
    "ambient": ("live.set('ambient', [0.6, 0.1, 0.1, 1])", {"ambient": [0.6, 0.1, 0.1, 1.0]}),
    "phong": ("live.show({mode: 'phong'})", {"shade": GL_PHONG_WIN}),
    "flat, other lobe": ("live.show({mode: 'flat', lobe: 'phong'})", {"shade": GL_FLAT, "lobe": GL_PHONG_LOBE_GLSIM}),
    "several": ("live.show({mode: 'phong', lobe: 'phong'}); live.set('material.0.front.shininess', 60);"
                " live.set('light.0.position', [0, 4, 0, 1])",
                {"shade": GL_PHONG_WIN, "lobe": GL_PHONG_LOBE_GLSIM, "position": [0.0, 4.0, 0.0, 1.0]}),
}  # fmt: skip


@pytest.mark.parametrize("name", CONTROLS)
def test_after_a_control_the_picture_is_that_of_moderngl(name: str, live: Browser, screen: glsim.Offscreen) -> None:
    code, changes = CONTROLS[name]
    if name == "several":  # the second ball keeps its shininess
        code += "; live.set('material.1.front.shininess', 60)"
        changes = {**changes, "shininess": 60.0}
    # between facets of one colour each, two rasterizers may decide differently about single pixels
    most = 3e-3 if "flat" in name else 1e-3  # of 512 x 512 pixels it is less than 1e-3
    assert off(seen(live, RESET + code), pixels(screen, lambda: drawn(**changes))) <= most


@pytest.mark.parametrize(
    "orbit", [{"yaw": 40}, {"pitch": -25}, {"yaw": 160, "pitch": 30, "x": 0.3, "y": -0.2}, {"zoom": 2.0}]
)
def test_a_turned_camera_is_the_one_of_the_line_of_source(
    orbit: dict[str, float], live: Browser, screen: glsim.Offscreen
) -> None:
    shown = seen(live, f"live.reset(); live.orbit({orbit})")
    eye = tuple(live.js("return document.querySelector('glsim-live').scene.lookAt"))
    fovy = float(np.degrees(2 * np.arctan(np.tan(np.radians(20.0)) / orbit.get("zoom", 1.0))))
    changes: dict[str, Any] = {"fovy": fovy} if "zoom" in orbit else {"eye": eye}
    assert off(shown, pixels(screen, lambda: drawn(**changes))) <= 1e-3
    line = live.js("return document.querySelector('glsim-live').source.textContent")
    assert line.startswith("gluPerspective(" if "zoom" in orbit else "gluLookAt(")
