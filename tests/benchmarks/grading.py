"""How long ``glsim grade`` takes:  python -m tests.benchmarks.grading [SUBMISSIONS] [PROCESSES] [EXERCISES]

The submissions are the right and wrong variants of tests/course, in a fixed random order.
"""

from __future__ import annotations

import random
import sys
import tempfile
import time
from pathlib import Path

from glsim.course.exercise import exercise
from glsim.course.grading.run import grade
from glsim.course.grading.submissions import submissions
from tests.course.grading import changed, solution_of, variants_of


def main(count: int = 200, jobs: int = 2, names: str = "3") -> None:
    """Print seconds, and the distribution of points."""
    chance = random.Random(7)
    wanted = [exercise(name) for name in names.split(",")]
    with tempfile.TemporaryDirectory() as name:
        for number in range(count):
            folder = Path(name) / f"student {number}"
            folder.mkdir()
            for one in wanted:
                variants = variants_of(one.name)
                texts = [
                    solution_of(one),
                    *variants.RIGHT.values(),
                    *(changed(one, c) for c, _ in variants.WRONG.values()),
                ]
                (folder / one.filename).write_text(chance.choice(texts), encoding="utf-8")
        began = time.perf_counter()
        records = list(grade(submissions(Path(name)), wanted, jobs=jobs, seconds=20.0))
        seconds = time.perf_counter() - began
    full = sum(record.points == record.most for record in records)
    isolation = ", ".join({record.isolation for record in records})
    print(f"{count} submissions of {names}, {jobs} processes, {isolation}: {seconds:.1f} s; {full} have all points")


if __name__ == "__main__":
    words = sys.argv[1:]
    main(*(int(word) for word in words[:2]), *words[2:])
