"""Classic mistakes, each found in the calls and the Draws of a program and said in a sentence.  A file for each topic;
each mistake is one small class (rules.Rule), whose docstring says when it stays silent."""

from __future__ import annotations

from glsim.study.mistakes import calls, camera, colors, depth, light, normals, textures, winding
from glsim.study.mistakes.detector import Detector, checked
from glsim.study.mistakes.rules import RULES, TOPICS, Mistake

__all__ = [
    "RULES", "TOPICS", "Detector", "Mistake", "calls", "camera", "checked", "colors", "depth", "light", "normals",
    "textures", "winding",
]  # fmt: skip
