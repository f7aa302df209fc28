"""A live picture as the last expression of a cell: in a notebook an iframe, on a page of the course an element."""

from __future__ import annotations

import io
from dataclasses import replace
from typing import Any

import numpy as np

from glsim.images import on_paper, rgba
from glsim.web import live as web
from glsim.web.live import Live


class Shown:
    """A live picture, and the still picture that paper shows instead; no server and no network is needed.

    still: a picture of any size (default: the live picture as it is first seen): an image, a screen, a Comparison.
    """

    def __init__(self, live: Live, still: Any = None) -> None:
        self._still = getattr(still, "sheet", still)
        self.live = live if still is None else replace(live, poster=on_paper(rgba(self._still)))

    def _repr_html_(self) -> str:
        return web.frame(self.live)

    def _repr_live_(self) -> str:
        """The element, for a page that has its code."""
        return web.element(self.live, script=False)

    def _repr_png_(self) -> bytes:
        from PIL import Image

        if self._still is not None and (png := self._still._repr_png_()):
            return bytes(png)
        buffer = io.BytesIO()
        Image.fromarray(np.ascontiguousarray(self.live.poster)).save(buffer, "PNG")
        return buffer.getvalue()

    def __repr__(self) -> str:
        return f"<live picture of {self.live.title}: {len(self.live.tape.pictures)} pictures>"
