"""Marks as Classroom 50's result.json (https://github.com/foundation50/classroom50/wiki/Advanced-Autograding).

Students can read it, so it holds marks and hints and nothing else.  The runner of Classroom 50 says in the environment
which classroom, assignment and submission this is; without it the submission's own name stands there.
"""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Mapping
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from glsim.course.grading.record import Total
from glsim.files import write_text

SCHEMA = "classroom50/result/v1"
MOST_BYTES = 10 << 20  # that Classroom 50 reads
TIME = "%Y-%m-%dT%H:%M:%SZ"


def write(folder: Path, total: Total) -> Path:
    """Write result.json for one submission into a folder.  Raises ValueError if it is larger than may be."""
    text = json.dumps(result(total, os.environ, submitted(os.environ)), indent=1) + "\n"
    if len(text) > MOST_BYTES:
        raise ValueError(
            f"result.json of {total.submission} has {len(text)} bytes, and Classroom 50 reads {MOST_BYTES}"
        )
    path = folder / "result.json"
    write_text(path, text)
    return path


def submitted(environment: Mapping[str, str]) -> str:
    """The instant of the commit that Classroom 50's runner grades in the current folder, in UTC; without a
    runner the present instant.

    Git runs in no other folder, because the configuration that lies in a student's folder can start programs."""
    if "SUBMISSION_TAG" in environment:
        safe = ["-c", "safe.directory=*", "-c", "log.showSignature=false", "-c", "core.fsmonitor=false"]
        command = ["git", *safe, "log", "-1", "--format=%ct"]
        try:
            seconds = int(subprocess.run(command, capture_output=True, check=True, timeout=60).stdout)
            return datetime.fromtimestamp(seconds, UTC).strftime(TIME)
        except (OSError, ValueError, subprocess.SubprocessError):
            pass  # no checkout, or no git
    return datetime.now(UTC).strftime(TIME)


def result(total: Total, environment: Mapping[str, str], instant: str) -> dict[str, Any]:
    """What result.json holds.  instant: of the commit, in UTC, as 2026-06-01T14:32:01Z."""

    def told(name: str, otherwise: str) -> str:
        return environment.get(name) or otherwise

    commit = told("COMMIT_URL", total.slug)
    tests = [
        {
            "test-name": f"{record.exercise}: {part.about}",
            "passed": part.right,
            "score": part.points,
            "max-score": part.most,
            "output": (part.hint or ("" if part.right else record.note))[:1000],
        }
        for record in total.records
        for part in record.parts
    ]
    return {
        "schema": SCHEMA,
        "classroom": told("CLASSROOM", "glsim"),
        "assignment": told("ASSIGNMENT", "-".join(record.exercise for record in total.records[:3])),
        "assignment_type": told("ASSIGNMENT_TYPE", "individual"),
        "owner": told("OWNER", told("USERNAME", total.slug)),
        "submission": told("SUBMISSION_TAG", f"submit/{total.slug}"),
        "commit": commit,
        "release": told("RELEASE_URL", commit),
        "review": told("REVIEW_URL", commit),
        "datetime": instant,
        "graded_at": datetime.now(UTC).strftime(TIME),
        "score": total.points,
        "max-score": total.most,
        "tests": tests,
    }
