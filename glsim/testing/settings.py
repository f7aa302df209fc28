"""What the options of pytest mean for snapshots."""

from __future__ import annotations

import os
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import pytest


@dataclass(frozen=True)
class Settings:
    """root: pytest's rootdir; paths are told from there.  folder: of the report.  update: write baselines.
    report_all: make a report whatever happens.  unused_fails: an unused baseline is a failure."""

    root: Path
    folder: Path
    update: bool
    report_all: bool
    unused_fails: bool


def settings_of(config: pytest.Config) -> Settings:
    wanted, worker = config.getoption("--gl-report"), getattr(config, "workerinput", None)
    if worker is not None:
        folder = Path(worker["gl_report"])
    elif wanted:
        folder = config.invocation_params.dir / wanted
    elif os.access(config.rootpath, os.W_OK) and not is_foreign(config.rootpath / "gl-report"):
        folder = config.rootpath / "gl-report"
    else:
        folder = Path(tempfile.gettempdir()) / f"gl-report-{os.getpid()}"
    return Settings(
        root=config.rootpath,
        folder=folder,
        update=config.getoption("--gl-update"),
        report_all=wanted is not None,
        unused_fails=config.getoption("--gl-unused") == "fail",
    )


def is_foreign(folder: Path) -> bool:
    """Whether a folder has files in it and is no report."""
    ours = (folder / "report.json").is_file() or (folder / "candidates").is_dir()
    return folder.is_dir() and any(folder.iterdir()) and not ours


def in_ci() -> bool:
    return os.environ.get("CI", "").lower() not in ("", "0", "false", "no")
