"""Names that people type: one vocabulary for shading in all commands, and a suggestion for what is misspelt."""

from __future__ import annotations

from collections.abc import Iterable

SHADING = {"flat": "flat", "gouraud": "gouraud", "smooth": "gouraud", "phong": "phong"}  # name -> canonical name
LOBES = {"blinn": "blinn", "blinn-torrance": "blinn", "phong": "phong"}


def did_you_mean(name: str, names: Iterable[str]) -> str:
    """ "; did you mean 'teapot'?" for the entry of ``names`` closest to the misspelt ``name``; "" if none is close.

    A gl command that lacks its suffix is completed, with f first: glVertex3 -> glVertex3f.
    """
    from difflib import get_close_matches

    known = {known.lower(): known for known in names}
    close = [name + suffix for suffix in ("f", "fv", "i") if name.lower() + suffix in known and name.startswith("gl")]
    close = close or get_close_matches(name.lower(), known, 1, 0.7)
    return f"; did you mean {known[close[0].lower()]!r}?" if close else ""


def missing(module: str, name: str, names: Iterable[str]) -> AttributeError:
    """What a module's __getattr__ raises."""
    hint = "" if name.startswith("_") else did_you_mean(name, names)
    return AttributeError(f"module {module!r} has no attribute {name!r}{hint}")


def hint_for(error: BaseException) -> str:
    """The suggestion for an error that ended a program: of a NameError among the names that were visible where it was
    raised, of an AttributeError among the object's, of an ImportError among the module's; "" for other errors."""
    import builtins
    import sys

    if isinstance(error, NameError) and error.name:
        traceback = error.__traceback__
        while traceback is not None and traceback.tb_next is not None:
            traceback = traceback.tb_next
        frame = traceback.tb_frame if traceback is not None else None
        visible = {*frame.f_locals, *frame.f_globals} if frame is not None else set()
        return did_you_mean(error.name, sorted(visible)) or did_you_mean(error.name, dir(builtins))
    if isinstance(error, AttributeError) and error.name and "did you mean" not in str(error):
        return did_you_mean(error.name, dir(error.obj))
    if isinstance(error, ImportError) and error.name in sys.modules and "import name '" in str(error):
        return did_you_mean(str(error).split("'")[1], dir(sys.modules[error.name]))
    return ""
