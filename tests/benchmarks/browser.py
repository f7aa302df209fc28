"""Live pictures in headless Chromium: python -m tests.benchmarks.browser [--json]

Prints for balls of about 1,000, 20,000 and 100,000 triangles, the teapot, and a radiosity solution: the weight of the
page, the time from opening the file to the first picture, and milliseconds for a picture after dragging the light,
turning the camera and (of the solution) changing the exposure: medians of 15, each until the GPU has finished
(readPixels).
Chromium without a graphics card draws with SwiftShader, on the CPU.
"""

from __future__ import annotations

import argparse
import json
import statistics
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from glsim.study.export import export
from tests.browser import Browser

TIMES = 15
DRAGGED = "live.set('light.0.position', [Math.sin({k}), 1, 2, 0])"
TURNED = "live.orbit({{yaw: 5 * {k}}})"
EXPOSED = "live.show({{exposure: 1 + {k} / 10}})"
MEASURE = """const done = arguments[0], live = document.querySelector('glsim-live');
const begin = performance.now();
%s;
cancelAnimationFrame(0);
live.waiting = null;
live.draw();
live.player.pixels();
done(performance.now() - begin);"""


def balls() -> dict[str, Callable[[Path], Any]]:
    """By name, what writes a page."""
    from glsim.gl import (
        GL_COLOR_BUFFER_BIT,
        GL_DEPTH_BUFFER_BIT,
        GL_DEPTH_TEST,
        GL_LIGHT0,
        GL_LIGHTING,
        GL_MODELVIEW,
        GL_PROJECTION,
        glClear,
        glEnable,
        glLoadIdentity,
        glMatrixMode,
        glTranslatef,
    )
    from glsim.glu import gluPerspective
    from glsim.glut import glutSolidSphere

    def ball(slices: int) -> Callable[[], None]:
        def draw() -> None:
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
            for capability in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0):
                glEnable(capability)
            glMatrixMode(GL_PROJECTION)
            glLoadIdentity()
            gluPerspective(40, 1, 1, 10)
            glMatrixMode(GL_MODELVIEW)
            glLoadIdentity()
            glTranslatef(0, 0, -3.5)
            glutSolidSphere(1.0, 2 * slices, slices)

        return draw

    pages: dict[str, Callable[[Path], Any]] = {
        f"ball of {count:,}": lambda path, slices=slices: export(ball(slices), path, modes=["gouraud"], lobes=["blinn"])
        for count, slices in ((1_000, 16), (20_000, 71), (100_000, 158))
    }
    pages["teapot"] = lambda path: export("teapot", path)
    pages["cornell, 1,000 patches"] = lambda path: export("cornell", path, patches=1000)
    return pages


def measured(browser: Browser, path: Path) -> dict[str, float]:
    begin = time.perf_counter()
    browser.open(path)
    browser.until("return document.querySelector('glsim-live')?.dataset.state === 'ready'")
    row = {"kB": path.stat().st_size / 1000, "first picture, ms": 1000 * (time.perf_counter() - begin)}
    lit = browser.js("return document.querySelector('glsim-live').data.controls.includes('lights')")
    for name, code in (("dragged, ms", DRAGGED), ("turned, ms", TURNED), ("exposed, ms", EXPOSED)):
        if (code == DRAGGED and not lit) or (code == EXPOSED and lit):
            continue
        times = [browser.driver.execute_async_script(MEASURE % code.format(k=k)) for k in range(1, TIMES + 1)]
        row[name] = statistics.median(times)
    return row


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    browser, rows = Browser(), {}
    with tempfile.TemporaryDirectory() as folder:
        for name, write in balls().items():
            path = Path(folder) / "page.html"
            write(path)
            rows[name] = measured(browser, path)
            print(name, {key: round(value, 1) for key, value in rows[name].items()}, file=sys.stderr)
    browser.quit()
    if options.json:
        print(json.dumps(rows))
        return
    columns = ["kB", "first picture, ms", "dragged, ms", "turned, ms", "exposed, ms"]
    print(f"{'':26}" + "".join(f"{column:>20}" for column in columns))
    for name, row in rows.items():
        print(f"{name:26}" + "".join(f"{row[column]:20.1f}" if column in row else f"{'':20}" for column in columns))


if __name__ == "__main__":
    main()
