"""A long run: ``prlimit --as=6000000000 python -m tests.fuzz --calls 1000000 --seed 0``."""

from __future__ import annotations

import argparse
import faulthandler
import resource
import time

from tests.fuzz.calls import Fuzz

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--calls", type=int, default=100_000)
parser.add_argument("--seed", type=int, default=0)
options = parser.parse_args()
faulthandler.enable()
fuzz, start, said = Fuzz(options.seed), time.time(), 0
while fuzz.report.calls < options.calls:
    faulthandler.dump_traceback_later(120, exit=True)
    fuzz.round(60)
    if fuzz.report.calls // 50_000 > said:
        said = fuzz.report.calls // 50_000
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
        print(f"{fuzz.report.calls} calls, {time.time() - start:.0f} s, {peak} MiB, {fuzz.report.wrong}", flush=True)
faulthandler.cancel_dump_traceback_later()
print(fuzz.report)
