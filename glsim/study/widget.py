"""``glsim.Widget``: a live picture in a notebook that Python keeps changing."""

from __future__ import annotations

import json
from typing import Any

try:
    import anywidget
    import traitlets
except ModuleNotFoundError as error:
    raise ModuleNotFoundError("glsim.Widget needs anywidget: pip install 'glsim[notebook]'") from error

from glsim.study.export import live
from glsim.web.live import widget_code


class Widget(anywidget.AnyWidget):
    """A live picture (see ``glsim.export``) whose content can be replaced while it is shown; the camera stays.

        widget = glsim.Widget(frame)
        widget                      # the last expression of a cell
        widget.update(other_frame)  # in any later cell

    what, options: those of ``glsim.show``.
    """

    _esm = widget_code()
    data = traitlets.Unicode().tag(sync=True)
    tape = traitlets.Bytes().tag(sync=True)

    def __init__(self, what: Any, **options: Any) -> None:
        super().__init__()
        self._options = options
        self.update(what)

    def update(self, what: Any) -> None:
        """Show something else, with the same options."""
        made = live(what, **self._options)
        with self.hold_sync():
            self.data = json.dumps(made.data())
            self.tape = made.tape.to_bytes()
