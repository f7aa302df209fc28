"""GLUT's menus: lists of entries that a mouse button opens."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from glsim.glut.loop import loop
from glsim.glut.window import Window


@dataclass
class Menu:
    """A menu.  entries: (label, value, False) calls function(value); (label, number, True) opens menu ``number``."""

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
    """Make an empty menu, make it current and return its number.  ``callback(value)`` is called with what is chosen."""
    number = max(loop.menus, default=0) + 1
    loop.menus[number] = Menu(callback)
    loop.menu = number
    return number


def glutDestroyMenu(menu: int) -> None:
    """Forget the menu with this number."""
    loop.menus.pop(int(menu), None)
    loop.menu = 0 if loop.menu == menu else loop.menu


def glutGetMenu() -> int:
    """The number of the current menu; 0 if there is none."""
    return loop.menu


def glutSetMenu(menu: int) -> None:
    """Make the menu with this number current."""
    if int(menu) in loop.menus:
        loop.menu = int(menu)


def _menu(name: str) -> Menu:
    if loop.menu not in loop.menus:
        raise RuntimeError(f"{name}: there is no current menu: call glutCreateMenu first")
    menu: Menu = loop.menus[loop.menu]
    return menu


def glutAddMenuEntry(label: Any, value: int) -> None:
    """Add an entry at the end of the current menu; ``value`` is what the menu's callback gets."""
    _menu("glutAddMenuEntry").entries.append((text_of(label), int(value), False))


def glutAddSubMenu(label: Any, submenu: int) -> None:
    """Add an entry at the end of the current menu that opens the menu with the number ``submenu``."""
    _menu("glutAddSubMenu").entries.append((text_of(label), int(submenu), True))


def _entry(name: str, item: int, label: Any, value: int, submenu: bool) -> None:
    entries = _menu(name).entries
    if not 1 <= int(item) <= len(entries):
        raise ValueError(f"{name}: the menu has entries 1 to {len(entries)}, not {item}")
    entries[int(item) - 1] = (text_of(label), int(value), submenu)


def glutChangeToMenuEntry(item: int, label: Any, value: int) -> None:
    """Replace entry ``item`` of the current menu, counted from 1, by a plain one."""
    _entry("glutChangeToMenuEntry", item, label, value, False)


def glutChangeToSubMenu(item: int, label: Any, submenu: int) -> None:
    """Replace entry ``item`` of the current menu, counted from 1, by one that opens the menu ``submenu``."""
    _entry("glutChangeToSubMenu", item, label, submenu, True)


def glutRemoveMenuItem(item: int) -> None:
    """Remove entry ``item`` of the current menu, counted from 1."""
    entries = _menu("glutRemoveMenuItem").entries
    if not 1 <= int(item) <= len(entries):
        raise ValueError(f"glutRemoveMenuItem: the menu has entries 1 to {len(entries)}, not {item}")
    del entries[int(item) - 1]


def glutAttachMenu(button: int) -> None:
    """Let a mouse button, such as GLUT_RIGHT_BUTTON, open the current menu in the current window."""
    current_window("glutAttachMenu").menus[int(button)] = loop.menu


def glutDetachMenu(button: int) -> None:
    """Let a mouse button open no menu in the current window any more."""
    current_window("glutDetachMenu").menus.pop(int(button), None)


def glutGetMenuData() -> Any:
    """What glutSetMenuData attached to the current menu; None at first."""
    return _menu("glutGetMenuData").data


def glutSetMenuData(data: Any) -> None:
    """Attach any object to the current menu."""
    _menu("glutSetMenuData").data = data
