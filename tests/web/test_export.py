"""Pages with a live picture: what ``glsim export`` writes, seen and used in a browser."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import glsim
from glsim.cli import main
from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective
from glsim.glut import glutSolidCube
from glsim.machine.frame import Frame
from glsim.render.context import drawn as picture_of
from glsim.study.export import export, live, show
from glsim.web import live as web
from tests.browser import Browser
from tests.web.living import SIZE, drawn, frame_of, off, opened, pixels, seen

pytestmark = pytest.mark.slow
TEAPOT = 150_000  # bytes that the page of a teapot may have

ANIMATION = """
from OpenGL.GL import *
from OpenGL.GLUT import *
angle = 0
def display():
    glClear(GL_COLOR_BUFFER_BIT)
    glLoadIdentity()
    glRotatef(angle, 0, 0, 1)
    glBegin(GL_TRIANGLES)
    for x, y in ((-0.5, -0.5), (0.5, -0.5), (0.0, 0.7)):
        glVertex2f(x, y)
    glEnd()
    glutSwapBuffers()
def idle():
    global angle
    angle += 20
    glutPostRedisplay()
glutInit()
glutInitDisplayMode(GLUT_RGB | GLUT_DOUBLE)
glutInitWindowSize(128, 128)
glutCreateWindow(b"turning")
glutDisplayFunc(display)
glutIdleFunc(idle)
glutMainLoop()
"""


def live_in(browser: Browser, code: str) -> Any:
    return browser.js(f"const live = document.querySelector('glsim-live'); {code}")


def shown(browser: Browser, path: Path) -> None:
    browser.open(path)
    browser.until("return document.querySelector('glsim-live').dataset.state === 'ready'")


def test_the_page_of_a_teapot_is_light_offline_and_silent(browser: Browser, tmp_path: Path) -> None:
    assert main(["export", "teapot", "-o", str(tmp_path / "teapot.html")]) == 0
    page = tmp_path / "teapot.html"
    assert page.stat().st_size < TEAPOT
    shown(browser, page)
    assert [url for url in browser.requests() if not url.startswith("file:")] == []
    assert [words for words in browser.messages() if not re.search("software WebGL|ReadPixels", words)] == []
    assert live_in(browser, "return [...live.player.gaps]") == []


def test_what_cannot_be_exported_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for words, sentence in (
        (["teapot", "-o", str(tmp_path / "a.htm")], "must end in .html"),
        (["teapot", "-o", str(tmp_path / "a.html"), "--modes", "toon"], "not 'toon'"),
        (["teapot", "-o", str(tmp_path / "a.html"), "--controls", "sound"], "not 'sound'"),
        (["teapot", "-o", str(tmp_path / "a.html"), "--frames", "3"], "pictures of a program"),
        (["no.py", "-o", str(tmp_path / "a.html")], "no such file"),
        (["teapot", "-o", str(tmp_path / "nowhere" / "a.html")], "no folder"),
    ):
        assert main(["export", *words]) == 1
        assert sentence in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []
    assert main(["export", "teapot", "--json", "-o", str(tmp_path / "t.html")]) == 0
    assert json.loads(capsys.readouterr().out)["modes"] == ["flat", "gouraud", "phong"]


def test_frames_of_an_animation_are_a_scrubber(browser: Browser, tmp_path: Path) -> None:
    (tmp_path / "turning.py").write_text(ANIMATION, encoding="utf-8")
    made = export(tmp_path / "turning.py", tmp_path / "page.html", frames=4, samples=0)
    assert made.frames == ["picture 0", "picture 1", "picture 2", "picture 3"]
    shown(browser, tmp_path / "page.html")
    put = ("const s = live.shadowRoot.querySelector('input[type=range]'); s.value = NUMBER;"
           " s.dispatchEvent(new Event('input'));")  # fmt: skip
    pictures = [seen(browser, put.replace("NUMBER", str(k))) for k in (0, 1, 2, 3, 0)]
    assert all(off(pictures[k], pictures[k + 1]) > 0.05 for k in range(3))
    assert off(pictures[0], pictures[4]) == 0


def test_a_link_brings_the_changes_back(browser: Browser, screen: glsim.Offscreen, tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    opened(browser, path, {"picture": frame_of(screen, drawn)})
    changed = seen(
        browser, "live.show({mode: 'phong'}); live.set('material.0.front.shininess', 4); live.orbit({yaw: 30})"
    )
    link = live_in(browser, "return live.link()")
    browser.driver.get("about:blank")
    browser.driver.get(link)
    browser.until("return document.querySelector('glsim-live').dataset.state === 'ready'")
    assert off(changed, seen(browser)) == 0
    assert live_in(browser, "return live.source.textContent").startswith("glShadeModel(GL_PHONG_WIN)\ngluLookAt(")


def test_mouse_and_keys_turn_move_and_ask(browser: Browser, screen: glsim.Offscreen, tmp_path: Path) -> None:
    opened(browser, tmp_path / "page.html", {"picture": frame_of(screen, drawn)})
    stage = live_in(browser, "return live.stage")
    browser.act().move_to_element_with_offset(stage, 20, 50).click_and_hold().move_by_offset(40, 0).release().perform()
    assert live_in(browser, "return live.scene.orbit.yaw") == pytest.approx(180 * 40 / SIZE, abs=3)
    live_in(browser, "live.reset()")
    live_in(browser, "live.stage.focus()")
    browser.act().send_keys("\ue014").perform()  # the right arrow
    assert live_in(browser, "return live.scene.orbit.yaw") > 0
    browser.act().send_keys("0").perform()
    assert live_in(browser, "return live.scene.orbit.yaw") == 0
    browser.act().move_to_element(stage).click().perform()  # the middle of the first ball
    point = live_in(browser, "return live.point")
    assert np.linalg.norm(np.array(point["P"]) - (0.0, 0.0, -np.sqrt(41.0))) == pytest.approx(1.0, abs=0.03)
    outwards = np.array(point["P"]) - (0.0, 0.0, -np.sqrt(41.0))
    assert np.dot(outwards, point["N"]) == pytest.approx(1.0, abs=0.03)


def test_a_light_is_dragged_in_the_picture(browser: Browser, screen: glsim.Offscreen, tmp_path: Path) -> None:
    opened(browser, tmp_path / "page.html", {"picture": frame_of(screen, lambda: drawn(position=[1.0, 1.5, 2.0, 1.0]))})
    handle = live_in(browser, "return live.overlay.handles(live.scene)[0]")
    stage = live_in(browser, "return live.stage")
    wide = live_in(browser, "return live.stage.clientWidth") / SIZE
    start = [(handle["x"] - SIZE / 2) * wide, (handle["y"] - SIZE / 2) * wide]
    browser.act().move_to_element_with_offset(stage, *map(round, start)).click_and_hold().move_by_offset(
        -30, 20
    ).release().perform()
    position = live_in(browser, "return live.scene.value('light.0.position')")
    assert position != [1.0, 1.5, 2.0, 1.0]
    line = live_in(browser, "return live.source.textContent")
    written = re.fullmatch(r"glLightfv\(GL_LIGHT0, GL_POSITION, (\[.*\])\)  # line \d+", line)
    assert written is not None
    assert json.loads(written[1]) == pytest.approx(position)
    assert off(seen(browser), pixels(screen, lambda: drawn(position=position))) <= 1e-3


def hud() -> None:
    """A turning triangle, and a bar over it that stays."""
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(40, 1, 1, 20)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0)
    glColor3f(1, 0, 0)
    glBegin(GL_TRIANGLES)
    for x, y in ((-1, -1), (1, -1), (0, 1)):
        glVertex2f(x, y)
    glEnd()
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    glOrtho(0, 1, 0, 1, -1, 1)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    glColor3f(0, 1, 0)
    glRectf(0.1, 0.9, 0.9, 0.95)


def test_what_a_head_up_display_draws_does_not_turn(browser: Browser, screen: glsim.Offscreen, tmp_path: Path) -> None:
    opened(browser, tmp_path / "page.html", {"picture": frame_of(screen, hud)})
    before, after = seen(browser), seen(browser, "live.orbit({yaw: 60})")
    green = [picture[..., 1] > 200 for picture in (before, after)]
    assert green[0].any()
    assert (green[0] == green[1]).all()
    assert (before[..., 0] > 200).sum() > 1.5 * (after[..., 0] > 200).sum() > 0


def camera_in_the_projection(*turned: float) -> None:
    """A classic mistake: gluLookAt multiplies GL_PROJECTION.  turned: for a gluLookAt where it belongs."""
    drawn()
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    gluLookAt(1, 2, 6, 0, 0, 0, 0, 1, 0)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    if turned:
        gluLookAt(*turned)
    glDisable(GL_LIGHTING)  # whose lights drawn() has put into another eye space
    for color, size in (((1.0, 0.0, 0.0), 1.5), ((0.0, 1.0, 0.0), 0.8)):
        glColor3f(*color)
        glutSolidCube(size)
        glTranslatef(1.0, 0.5, 0.3)


def test_a_camera_in_the_projection_turns_too(browser: Browser, screen: glsim.Offscreen, tmp_path: Path) -> None:
    frame = frame_of(screen, camera_in_the_projection)
    frame.packets = frame.packets[-3:]  # from the second glClear on
    opened(browser, tmp_path / "page.html", {"picture": frame})
    turned = seen(browser, "live.orbit({yaw: 35, pitch: 10})")
    eye = live_in(browser, "return live.scene.lookAt")
    assert off(turned, pixels(screen, lambda: camera_in_the_projection(*eye))) <= 1e-3
    seen(browser, "live.orbit({yaw: 0, pitch: 0, zoom: 2})")
    assert live_in(browser, "return live.source.textContent").startswith("glLoadMatrixf([")


def test_a_program_that_ends_early_is_exported_and_told(
    browser: Browser, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    broken = ANIMATION.replace("    glutSwapBuffers()", "    glutSwapBuffers()\n    glEnable(1)")
    (tmp_path / "broken.py").write_text(broken, encoding="utf-8")
    page = tmp_path / "page.html"
    assert main(["export", str(tmp_path / "broken.py"), "-o", str(page), "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["status"] == "error"
    shown(browser, page)
    assert "ended early" in live_in(browser, "return live.gaps.textContent")


def cut() -> None:
    """A ball that a plane of the world cuts."""
    drawn()
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glClipPlane(GL_CLIP_PLANE0, [1.0, 0.0, 0.0, 0.0])
    glEnable(GL_CLIP_PLANE0)
    glBegin(GL_QUADS)
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        glVertex3f(x, y, 0)
    glEnd()
    glDisable(GL_CLIP_PLANE0)


def test_planes_that_clip_turn_with_the_scene(browser: Browser, screen: glsim.Offscreen, tmp_path: Path) -> None:
    opened(browser, tmp_path / "page.html", {"picture": frame_of(screen, cut)})
    turned = seen(browser, "live.orbit({yaw: -50})")
    eye = tuple(live_in(browser, "return live.scene.lookAt"))

    def again() -> None:
        drawn(eye=eye)
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
        glClipPlane(GL_CLIP_PLANE0, [1.0, 0.0, 0.0, 0.0])
        glEnable(GL_CLIP_PLANE0)
        glBegin(GL_QUADS)
        for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            glVertex3f(x, y, 0)
        glEnd()
        glDisable(GL_CLIP_PLANE0)

    assert off(turned, pixels(screen, again)) <= 1e-3


def test_radiosity_is_shown_step_by_step_and_exposed(browser: Browser, tmp_path: Path) -> None:
    from glsim import radiosity

    result = radiosity.solve("cornell", 120)
    made = export(result, tmp_path / "page.html", size=SIZE, samples=0)
    names = [stage["name"] for stage in made.radiosity["stages"]]  # type: ignore[index]
    assert names[:3] == ["lamps alone", "direct", "2 bounces"]
    assert names[-2:] == ["radiosity", "direct + ambient"]
    shown(browser, tmp_path / "page.html")
    for name, values in (("radiosity", result.vertex_radiosity), ("direct", result.direct())):
        expected = np.asarray(result.picture(SIZE, colors=result.colors(values), samples=0))
        assert off(seen(browser, f"live.show({{stage: {names.index(name)}}})")[..., :3], expected) <= 2e-3
    brighter = np.asarray(result.picture(SIZE, colors=result.colors(2.0 * result.vertex_radiosity), samples=0))
    code = f"live.show({{stage: {names.index('radiosity')}, exposure: 2}})"
    assert off(seen(browser, code)[..., :3], brighter) <= 2e-3


def test_a_notebook_gets_the_page_in_an_iframe(browser: Browser, tmp_path: Path) -> None:
    html = show("sphere", size=128)._repr_html_()
    assert html.startswith("<iframe ")
    (tmp_path / "cell.html").write_text(f"<!doctype html><body>{html}</body>", encoding="utf-8")
    browser.open(tmp_path / "cell.html")
    browser.until(
        "const live = document.querySelector('iframe').contentDocument?.querySelector('glsim-live');"
        " return live?.dataset.state === 'ready'"
    )


def test_a_widget_shows_what_python_last_sent(browser: Browser, screen: glsim.Offscreen, tmp_path: Path) -> None:
    from base64 import b64encode

    widget = glsim.Widget(frame_of(screen, drawn), samples=0)
    sent = [(widget.data, widget.tape)]
    widget.update(frame_of(screen, lambda: drawn(shininess=90.0)))
    sent.append((widget.data, widget.tape))
    states = json.dumps([[data, b64encode(tape).decode()] for data, tape in sent]).replace("<", "\\u003c")
    code = web.widget_code().replace("export default { render };", "window.render = render;")
    (tmp_path / "w.html").write_text(f"""<!doctype html><div id=el></div><script type=module>{code}
const states = {states}, heard = [];
const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
window.put = (k) => {{ window.now = k; heard.forEach((act) => act()); }};
window.now = 0;
const model = {{ get: (name) => name === "tape" ? new DataView(bytes(states[now][1]).buffer) : states[now][0],
  on: (event, act) => heard.push(act), off: () => {{}} }};
render({{ model, el: document.getElementById("el") }});
</script>""", encoding="utf-8")  # fmt: skip
    shown(browser, tmp_path / "w.html")
    assert off(seen(browser), pixels(screen, drawn)) <= 1e-3
    browser.js("put(1)")
    browser.until("return document.querySelector('glsim-live').dataset.state === 'ready'")
    assert off(seen(browser), pixels(screen, lambda: drawn(shininess=90.0))) <= 1e-3


def test_without_webgl2_the_still_picture_stays_with_a_sentence(browser: Browser, tmp_path: Path) -> None:
    text = web.page(live("sphere", size=64))
    blind = "<script>HTMLCanvasElement.prototype.getContext = () => null;</script>"
    (tmp_path / "page.html").write_text(text.replace("<body>", f"<body>{blind}"), encoding="utf-8")
    browser.open(tmp_path / "page.html")
    browser.until("return document.querySelector('glsim-live').dataset.state === 'failed'")
    assert "has no WebGL2" in browser.find(".live-note").text
    assert browser.find("glsim-live img").is_displayed()


def test_the_still_picture_is_the_one_that_moderngl_draws(screen: glsim.Offscreen) -> None:
    frame: Frame = frame_of(screen, drawn)
    assert np.array_equal(live(frame, samples=0).poster, picture_of(frame)[..., :3])


def test_two_fingers_bring_the_picture_nearer_and_move_it(
    browser: Browser, screen: glsim.Offscreen, tmp_path: Path
) -> None:
    opened(browser, tmp_path / "page.html", {"picture": frame_of(screen, drawn)})
    box = live_in(browser, "const b = live.stage.getBoundingClientRect(); return [b.left, b.top]")

    def touch(kind: str, *points: tuple[float, float]) -> None:
        at = [{"x": box[0] + x, "y": box[1] + y, "id": number} for number, (x, y) in enumerate(points)]
        browser.driver.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": at})

    touch("touchStart", (50, 60), (70, 60))
    touch("touchMove", (40, 60), (80, 60))  # twice as far apart
    touch("touchEnd")
    orbit = live_in(browser, "return live.scene.orbit")
    assert orbit["zoom"] == pytest.approx(2.0, rel=0.1)
    touch("touchStart", (50, 60), (70, 60))
    touch("touchMove", (60, 60), (80, 60))
    touch("touchEnd")
    assert live_in(browser, "return live.scene.orbit.x") > orbit["x"]
    assert live_in(browser, "return live.scene.orbit.yaw") == 0
