"""Lines of glsim's own source, to stand beside a formula: the GLSL of shaders/ and the NumPy of glsim/shading."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from glsim.files import data_folder
from glsim.names import did_you_mean


@dataclass(frozen=True)
class SourceLines:
    """Consecutive lines of a file.  file: as it was asked for.  line: number of the first, from 1."""

    file: str
    line: int
    text: str

    def __repr__(self) -> str:
        return f"{self.file}, line {self.line}:\n{self.text}"

    def _repr_html_(self) -> str:
        language = "python" if self.file.endswith(".py") else "glsl"
        return (
            f'<figure class="source"><figcaption>{self.file}, line {self.line}</figcaption>'
            f"{highlighted(self.text, language)}</figure>"
        )


def source(file: str, words: str, lines: int = 1) -> SourceLines:
    """The line of glsim's source that contains ``words``, and those that follow, ``lines`` in all.

    file: "shaders/light.glsl", or a file of the package, "shading/equation.py".
    Raises ValueError if there is no such file, or if not exactly one line of the file contains the words."""
    folder = data_folder("shaders").parent if file.startswith("shaders/") else Path(__file__).parents[1]
    path = folder / file
    if not path.is_file():
        known = [f"shaders/{p.name}" for p in data_folder("shaders").iterdir()]
        raise ValueError(f"source: glsim has no file {file!r}{did_you_mean(file, known)}")
    text = path.read_text(encoding="utf-8").splitlines()
    numbers = [number for number, line in enumerate(text) if words in line]
    if len(numbers) != 1:
        raise ValueError(f"source: {len(numbers)} lines of {file} contain {words!r}; name words of exactly one line")
    first = numbers[0]
    chosen = text[first : first + lines]
    margin = min((len(line) - len(line.lstrip()) for line in chosen if line.strip()), default=0)
    return SourceLines(file, first + 1, "\n".join(line[margin:] for line in chosen).rstrip())


def highlighted(text: str, language: str) -> str:
    """Source text as HTML, with Pygments' class names.  language: "python", "glsl" or "text"."""
    from pygments import highlight
    from pygments.formatters import HtmlFormatter
    from pygments.lexers import get_lexer_by_name

    return str(highlight(text, get_lexer_by_name(language), HtmlFormatter(cssclass=f"highlight {language}")))
