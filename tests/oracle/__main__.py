"""Print the parity table: ``python -m tests.oracle``."""

from __future__ import annotations

import glsim
from glsim.play.capture import capture
from glsim.render.native import Native
from tests.oracle import PROGRAMS
from tests.oracle.measure import measure

screen, native = glsim.offscreen(128, 128), Native(128, 128)
print(f"{native.renderer}, {native.version}")
print(f"{'program':45} coverage  worst    mean  within 1/255")
rows = []
for name, draw in PROGRAMS.items():
    screen.reset()
    with capture(calls=True) as frame:
        draw()
    found = measure(screen.pixels(), native.replay(frame.calls))
    rows.append(found)
    print(f"{name:45} {found.coverage:8} {found.worst:6} {found.mean:7.4f} {100 * found.within_1:9.3f} %")
print(
    f"{len(rows)} programs: {sum(r.coverage for r in rows)} pixels covered by one only,"
    f" worst {max(r.worst for r in rows)},"
    f" mean {sum(r.mean for r in rows) / len(rows):.5f}, {sum(r.worst == 0 for r in rows)} identical"
)
