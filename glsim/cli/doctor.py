"""``glsim doctor``."""

from __future__ import annotations

import argparse
import json
from typing import Any


def add(commands: Any) -> None:
    doctor = commands.add_parser("doctor", help="say what this machine can draw with, and what to install")
    doctor.add_argument("--json", action="store_true", help="print one JSON object")
    doctor.set_defaults(run=_doctor)


def _doctor(options: argparse.Namespace) -> int:
    from glsim.render.diagnose import diagnose

    diagnosis = diagnose()
    if options.json:
        print(json.dumps(diagnosis))
    else:
        _print_diagnosis(diagnosis)
    return 0 if diagnosis["works"] else 1


def _print_diagnosis(diagnosis: dict[str, Any]) -> None:
    from rich.console import Console
    from rich.table import Table

    console = Console()
    console.print(f"glsim {diagnosis['glsim']}, Python {diagnosis['python']}, {diagnosis['platform']}", highlight=False)
    console.print(", ".join(f"{name} {version}" for name, version in diagnosis["packages"].items()), highlight=False)
    table = Table("backend", "works", "what it is, or what it said", "what to do")
    for entry in diagnosis["backends"]:
        if entry["works"]:
            table.add_row(entry["backend"], "yes", f"{entry['renderer']}\n{entry['version']}", "")
        else:
            table.add_row(entry["backend"], "no", entry["said"], entry["fix"])
    console.print(table)
    for device in diagnosis["devices"]:
        console.print(f"EGL device {device['index']}: {device['renderer']}", highlight=False)
    native = diagnosis["native fixed function"]
    words = f"{native['renderer']} ({native['version']}) by {native['backend']}" if native["works"] else native["said"]
    console.print(f"native fixed function: {words}", highlight=False)
    verdict = "glsim can draw here." if diagnosis["works"] else "glsim cannot draw here: install what the table says."
    console.print(verdict)
