"""The JavaScript modules of this folder as one text, for pages that are one file: a page that is opened from a disk may
not import other files."""

from __future__ import annotations

import re
from pathlib import Path

PLAYER = ("tape.js", "destination.js", "made.js", "player.js")  # each imports only those before it


def joined(names: tuple[str, ...] = PLAYER) -> str:
    """The modules, one after the other: each a function of its own, whose exports are constants that those behind it
    see.  Lines that are nothing but comment are left out, and indentation."""
    return "\n".join(_scoped(Path(__file__).with_name(name).read_text(encoding="utf-8")) for name in names)


def _scoped(text: str) -> str:
    exports = ", ".join(re.findall(r"^export (?:async )?(?:class|function\*?|const) (\w+)", text, re.MULTILINE))
    text = re.sub(r'^import \{[^}]*\} from "\./\w+\.js";\n', "", text, flags=re.MULTILINE)
    text = re.sub(r"^export (?=class|function|const|async)", "", text, flags=re.MULTILINE)
    text = re.sub(r"^\s*/\*\*.*?\*/ *\n?", "", text, flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"^ *(//.*)?\n|^ +", "", text, flags=re.MULTILINE)
    return f"const {{ {exports} }} = (() => {{\n{text}return {{ {exports} }};\n}})();"
