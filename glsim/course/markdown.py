"""A lesson's Markdown as HTML, with formulas as MathML."""

from __future__ import annotations

from functools import cache
from html import escape
from typing import TYPE_CHECKING, Any

from glsim.course.source import highlighted

if TYPE_CHECKING:
    from markdown_it import MarkdownIt


class MissingPackageError(RuntimeError):
    """A package of the extra ``course`` is not installed."""


class FormulaError(ValueError):
    """A formula is no LaTeX that can be converted."""


@cache
def _parser() -> MarkdownIt:
    try:
        from markdown_it import MarkdownIt
        from mdit_py_plugins.dollarmath import dollarmath_plugin
    except ImportError as error:
        raise MissingPackageError(f"pages of lessons need {error.name}: pip install 'glsim[course]'") from None

    parser = MarkdownIt("commonmark", {"html": True, "highlight": lambda code, language, _: _code(code, language)})
    parser.enable(["table"])
    return parser.use(dollarmath_plugin, renderer=_formula, allow_digits=False)


def html(text: str) -> str:
    """Markdown as HTML.  Formulas stand between $ or $$; HTML such as <details> passes.

    Raises MissingPackageError without the extra ``course``, FormulaError for LaTeX that is none."""
    return str(_parser().render(text))


def mathml(latex: str, display: bool = True) -> str:
    """A formula as MathML.  display: in a line of its own.  Raises FormulaError, MissingPackageError."""
    try:
        from math_core import LatexError, LatexToMathML
    except ImportError as error:
        raise MissingPackageError(f"formulas need {error.name}: pip install 'glsim[course]'") from None
    try:
        converted = LatexToMathML(fancy_error=False).convert_with_local_state(latex, displaystyle=display)
    except LatexError as error:
        raise FormulaError(f"the formula {latex!r}: {' '.join(str(error).split())}") from None
    label = escape(" ".join(latex.split()), quote=True)
    return str(converted).replace("<math", f'<math alttext="{label}"', 1)


def _formula(latex: str, options: dict[str, Any]) -> str:
    return mathml(latex, display=bool(options["display_mode"]))


def _code(code: str, language: str) -> str:
    return highlighted(code, language if language in ("python", "glsl") else "text").replace("<div", "<pre", 1)
