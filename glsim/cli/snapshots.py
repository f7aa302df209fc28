"""``glsim snapshots``: what a report of snapshot tests holds, approved or cleaned away."""

from __future__ import annotations

import argparse
import json
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Any


def add(commands: Any) -> None:
    snapshots = commands.add_parser(
        "snapshots", help="list and approve the pictures of snapshot tests, or remove unused baselines",
        description="Works on the report's folder of a test run (gl-report, or an artifact of CI).",
    )  # fmt: skip
    parts = snapshots.add_subparsers(title="commands", required=True, metavar="COMMAND")
    for name, run, says in (
        ("list", _list, "say what failed, and what has no baseline"),
        ("approve", _approve, "make pictures of the report baselines"),
        ("clean", _clean, "remove the baselines that no test used"),
    ):
        part = parts.add_parser(name, help=says)
        part.add_argument("folder", metavar="DIR", type=Path, nargs="?", default=Path("gl-report"),
                          help="the report's folder (default: %(default)s, here)")  # fmt: skip
        if name != "clean":
            part.add_argument("tests", metavar="TEST", nargs="*",
                              help="behind DIR: only these, such as 'test_ball.py::*'")  # fmt: skip
        if name != "list":
            part.add_argument("--root", type=Path, default=Path(), metavar="DIR", help="the project (default: here)")
        if name == "approve":
            part.add_argument("--add", action="store_true", help="keep the baseline that this renderer has")
        part.add_argument("--json", action="store_true", help="print one JSON object")
        part.set_defaults(run=run)


def _chosen(options: argparse.Namespace) -> list[dict[str, Any]]:
    """The snapshots of the report that can be approved, of the tests that are named."""
    from glsim.testing.report import load_report

    waiting = [e for e in load_report(options.folder)["snapshots"] if e["status"] in ("failed", "missing")]
    if not options.tests:
        return waiting
    for wanted in options.tests:
        if not any(_named(entry, wanted) for entry in waiting):
            raise ValueError(f"snapshots: no picture of the report belongs to {wanted!r}: see glsim snapshots list")
    return [entry for entry in waiting if any(_named(entry, wanted) for wanted in options.tests)]


def _named(entry: dict[str, Any], wanted: str) -> bool:
    """Whether a word means a snapshot: its test's id or the end of it, or the name of its baseline."""
    names = (entry["test"], entry["base"])
    return wanted in names or any(fnmatchcase(name, pattern) for name in names for pattern in (wanted, f"*/{wanted}"))


def _list(options: argparse.Namespace) -> int:
    from glsim.testing.report import load_report

    entries, unused = _chosen(options), load_report(options.folder)["unused"]
    if options.json:
        print(json.dumps({"status": "ok", "snapshots": entries, "unused": unused}))
        return 0
    for entry in entries:
        print(f"{entry['status']:8}{entry['test']}{', ' + entry['name'] if entry['name'] else ''}")
        print(f"        {entry['message']}")
    for path in unused:
        print(f"unused  {path}")
    if not entries and not unused:
        print("All pictures passed.")
    return 0


def _approve(options: argparse.Namespace) -> int:
    from glsim.testing.report import approve

    entries = [entry for entry in _chosen(options) if entry["candidate"]]
    paths = [str(approve(options.folder, options.root, entry, options.add)) for entry in entries]
    if options.json:
        print(json.dumps({"status": "ok", "approved": paths}))
        return 0
    for path in paths:
        print(f"approved {path}")
    if not paths:
        print("No picture waits for approval.")
    return 0


def _clean(options: argparse.Namespace) -> int:
    from glsim.testing.report import inside, load_report

    paths = [inside(options.root, relative) for relative in load_report(options.folder)["unused"]]
    for path in paths:
        path.unlink(missing_ok=True)
        if not any(path.parent.iterdir()):
            path.parent.rmdir()
    if options.json:
        print(json.dumps({"status": "ok", "removed": [str(path) for path in paths]}))
        return 0
    for path in paths:
        print(f"removed {path}")
    if not paths:
        print("No baseline is unused.")
    return 0
