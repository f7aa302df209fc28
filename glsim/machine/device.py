"""What a Machine hands its packets to."""

from __future__ import annotations

from typing import Any, Protocol

from numpy.typing import NDArray

from glsim.machine.errors import out_of_memory
from glsim.machine.frame import Packet


class Device(Protocol):
    """What the machine needs of whatever draws its frames."""

    width: int
    height: int

    def check(self) -> None:
        """Raise an exception if it cannot draw now, in this thread; ``flush`` calls it before it takes the packets."""

    def execute(self, packets: list[Packet]) -> None: ...

    def finish(self) -> None: ...

    def read(self, x: int, y: int, width: int, height: int, what: str) -> NDArray[Any]: ...

    def describe(self) -> dict[str, Any]: ...


class NoDevice:
    """For a machine that only follows what calls do to its state: one pixel, and nothing can be drawn."""

    width = height = 1

    def check(self) -> None:
        """Refuse a flush: the machine makes one when its packets take much memory."""
        raise out_of_memory("more was drawn than fits into memory, and there is no device to draw it")

    def execute(self, packets: list[Packet]) -> None: ...

    def finish(self) -> None: ...

    def read(self, x: int, y: int, width: int, height: int, what: str) -> NDArray[Any]:
        raise NotImplementedError

    def describe(self) -> dict[str, Any]:
        return {}
