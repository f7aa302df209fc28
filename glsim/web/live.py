"""Pictures that can be turned, lit and shaded anew in a browser: a page, or an element for a lesson or a notebook.

An element is ``<glsim-live>`` (live.js).  Its children are the still picture, which a reader without JavaScript and a
printer get, a description of what can be changed, and the tape that the player draws.  Everything stands in the page,
which asks for nothing.
"""

from __future__ import annotations

import base64
import io
import json
import zlib
from dataclasses import dataclass, field
from functools import cache
from html import escape
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.render import uniforms
from glsim.render.tape import Tape
from glsim.web.modules import PLAYER, joined

MODULES = (
    *PLAYER, "matrix.js", "scene.js", "pick.js", "source.js", "overlay.js", "turning.js", "panel.js", "radiosity.js",
    "awake.js", "live.js",
)  # fmt: skip
POLICY = "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'"
NARROW = "max-width: 100%; height: auto"


@dataclass
class Live:
    """What an element shows.

    title: a line.  tape: the pictures.  poster: (height, width, 3) uint8, top row first: the still picture, of any
    size.
    pictures: "frame mode lobe" -> number on the tape, "frame edges" -> the picture of the polygons' edges.
    moments: for each frame what live.js calls a Moment.  mode, lobe: what is shown first.
    controls: which there are, of "mode", "lobe", "edges", "lights", "materials", "ambient", or only some values of
    lights and materials, such as "lights.position".
    named: materials by name.  error: why the program ended early.  notes: sentences under the picture; those that begin
    with "Turned: " are shown when the camera has been turned.  radiosity: what live.js calls Radiosity.
    point: pixel, from the upper left, at which the vectors are shown first.  apart: whether the frames are not an
    animation but pictures with a button each.
    """

    title: str
    tape: Tape
    poster: NDArray[np.uint8]
    pictures: dict[str, int]
    moments: list[dict[str, Any]]
    modes: list[str]
    lobes: list[str]
    mode: str
    lobe: str
    frames: list[str] = field(default_factory=lambda: ["picture"])
    controls: list[str] = field(default_factory=list)
    named: list[dict[str, Any]] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    error: str = ""
    radiosity: dict[str, Any] | None = None
    point: tuple[int, int] | None = None
    apart: bool = False

    def data(self) -> dict[str, Any]:
        """What live.js calls Data."""
        names = (
            "title", "pictures", "moments", "modes", "lobes", "mode", "lobe", "frames", "controls", "named", "notes",
            "radiosity", "point", "apart",
        )  # fmt: skip
        values = {name: getattr(self, name) for name in names}
        return {**values, "width": self.tape.width, "height": self.tape.height, "layout": layout()}


def element(live: Live, script: bool = True) -> str:
    """An HTML fragment that needs nothing else.  script: whether the code stands in it; once on a page is enough."""
    height, width = live.poster.shape[:2]
    packed = base64.b64encode(zlib.compress(live.tape.to_bytes(), 9)).decode("ascii")
    return f"""<glsim-live>
<figure><img width="{width}" height="{height}" style="{NARROW}" alt="{escape(live.title)}"
src="{_uri(live.poster)}"></figure>
<script type="application/json">{_json(live.data())}</script>
<script type="application/x-glsim-tape">{packed}</script>
</glsim-live>
{code() if script else ""}"""


def page(live: Live, about: str = "") -> str:
    """A whole HTML page for any browser with WebGL2, without a network.  about: text under the title."""
    text = f"<p>{escape(about)}</p>" if about else ""
    return f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{POLICY}">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
<title>{escape(live.title)}</title>
<style>
body {{ font: 16px/1.5 system-ui, sans-serif; max-width: 70rem; margin: 1rem auto; padding: 0 1rem; }}
h1 {{ font-size: 1.4rem; margin: 0 0 0.8rem; }}
figure {{ margin: 0; }}
</style>
</head>
<body>
<h1>{escape(live.title)}</h1>
{text}
{element(live)}
</body>
</html>
"""


def frame(live: Live) -> str:
    """The page in an iframe, for a notebook: nothing of it meets the notebook's own style or code."""
    height = min(live.tape.height, 720) + 60
    style = f"width: 100%; height: {height}px; border: 0"
    return f'<iframe title="{escape(live.title)}" style="{style}" srcdoc="{escape(page(live))}"></iframe>'


@cache
def program() -> str:
    """The element's code as a script, which defines it once however often it is run."""
    return f'"use strict";\n{{\n{_module(MODULES)}\n}}\n'


def code() -> str:
    """The element's code as a tag."""
    return f'<script type="module">\n{program()}</script>'


@cache
def widget_code() -> str:
    """The same as a module for anywidget."""
    return f"{_module((*MODULES, 'widget.js'))}\nexport default {{ render }};\n"


def _module(names: tuple[str, ...]) -> str:
    style = Path(__file__).with_name("live.css").read_text(encoding="utf-8")
    return f"const LIVE_CSS = {_json(style)};\n{joined(names)}"


@cache
def layout() -> dict[str, dict[str, int]]:
    """Where the members of the uniform blocks' structures lie: bytes by name, and "size" of the whole."""
    structures = {
        "Transform": uniforms.TRANSFORM, "Material": uniforms.MATERIAL, "Face": uniforms.FACE_OF_MATERIAL,
        "Light": uniforms.LIGHT, "Lights": uniforms.LIGHTS, "Raster": uniforms.RASTER, "Unit": uniforms.UNIT,
    }  # fmt: skip
    return {
        name: {**{member: place for member, (_, place, *_) in (dtype.fields or {}).items()}, "size": dtype.itemsize}
        for name, dtype in structures.items()
    }


def _uri(pixels: NDArray[np.uint8]) -> str:
    """A picture as a data URI."""
    from PIL import Image

    buffer = io.BytesIO()
    Image.fromarray(np.ascontiguousarray(pixels[..., :3])).save(buffer, "WEBP", quality=90, method=6)
    return "data:image/webp;base64," + base64.b64encode(buffer.getvalue()).decode("ascii")


def _json(data: object) -> str:
    """JSON that can stand in a script element: no end tag and no comment can begin in it."""
    return json.dumps(data, ensure_ascii=False, separators=(",", ":")).replace("<", "\\u003c")
