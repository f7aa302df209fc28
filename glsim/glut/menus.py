"""GLUT's menus: lists of entries that a mouse button opens."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from glsim.glut.loop import loop
from glsim.glut.window import Window


@dataclass
class Menu:
    """entries: (label, value) of a plain entry, (label, submenu number) with submenu True."""

    function: Callable[[int], Any]
    entries: list[tuple[str, int, bool]] = field(default_factory=list)
    data: Any = None


def current_window(name: str) -> Window:
    if loop.current is None:
        raise RuntimeError(f"{name}: there is no current window: call glutCreateWindow first")
    return loop.current


def text_of(title: Any) -> str:
    return title.decode("utf-8", "replace") if isinstance(title, bytes) else str(title)


def glutCreateMenu(callback: Callable[[int], Any]) -> int:
    number = max(loop.menus, default=0) + 1
    loop.menus[number] = Menu(callback)
    loop.menu = number
    return number


def glutDestroyMenu(menu: int) -> None:
    loop.menus.pop(int(menu), None)
    loop.menu = 0 if loop.menu == menu else loop.menu


def glutGetMenu() -> int:
    return loop.menu


def glutSetMenu(menu: int) -> None:
    if int(menu) in loop.menus:
        loop.menu = int(menu)


def _menu(name: str) -> Menu:
    if loop.menu not in loop.menus:
        raise RuntimeError(f"{name}: there is no current menu: call glutCreateMenu first")
    menu: Menu = loop.menus[loop.menu]
    return menu


def glutAddMenuEntry(label: Any, value: int) -> None:
    _menu("glutAddMenuEntry").entries.append((text_of(label), int(value), False))


def glutAddSubMenu(label: Any, submenu: int) -> None:
    _menu("glutAddSubMenu").entries.append((text_of(label), int(submenu), True))


def _entry(name: str, item: int, label: Any, value: int, submenu: bool) -> None:
    entries = _menu(name).entries
    if not 1 <= int(item) <= len(entries):
        raise ValueError(f"{name}: the menu has entries 1 to {len(entries)}, not {item}")
    entries[int(item) - 1] = (text_of(label), int(value), submenu)


def glutChangeToMenuEntry(item: int, label: Any, value: int) -> None:
    _entry("glutChangeToMenuEntry", item, label, value, False)


def glutChangeToSubMenu(item: int, label: Any, submenu: int) -> None:
    _entry("glutChangeToSubMenu", item, label, submenu, True)


def glutRemoveMenuItem(item: int) -> None:
    entries = _menu("glutRemoveMenuItem").entries
    if not 1 <= int(item) <= len(entries):
        raise ValueError(f"glutRemoveMenuItem: the menu has entries 1 to {len(entries)}, not {item}")
    del entries[int(item) - 1]


def glutAttachMenu(button: int) -> None:
    current_window("glutAttachMenu").menus[int(button)] = loop.menu


def glutDetachMenu(button: int) -> None:
    current_window("glutDetachMenu").menus.pop(int(button), None)


def glutGetMenuData() -> Any:
    return _menu("glutGetMenuData").data


def glutSetMenuData(data: Any) -> None:
    _menu("glutSetMenuData").data = data
