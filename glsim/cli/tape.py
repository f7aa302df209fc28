"""``glsim tape`` and ``glsim draw``: what the GPU was told, written to a file, and drawn from it again."""

from __future__ import annotations

import argparse
from typing import Any

from glsim.cli.options import check_picture_name, number
from glsim.cli.study import add_study, frame_in, tell
from glsim.files import check_folder, write_atomically, write_bytes

SAMPLES = (0, 2, 4, 8, 16, 32)


def add(commands: Any) -> None:
    p = add_study(commands, "tape", "write down what the GPU is told to draw: for a browser, or as a bug report")
    p.add_argument("-o", "--output", metavar="FILE.glt", default="picture.glt", help="the tape (default: picture.glt)")
    p.add_argument("--samples", type=int, choices=SAMPLES, default=0, help="multisampling (default: 0, none)")
    p.set_defaults(run=_tape)
    text = "draw a picture from a tape"
    p = commands.add_parser("draw", help=text, description=text[0].upper() + text[1:] + ".")
    p.add_argument("tape", metavar="FILE.glt", help="what glsim tape wrote")
    p.add_argument("-o", "--output", metavar="FILE", default="picture.png", help="the picture (default: picture.png)")
    p.add_argument("--picture", type=number, default=0, metavar="N", help="which one of the tape, from 0 (default: 0)")
    p.add_argument("--json", action="store_true", help="print one JSON object")
    p.set_defaults(run=_draw)


def _tape(options: argparse.Namespace) -> int:
    from glsim.render.recorder import tape

    check_folder(options.output)
    frame = frame_in(options, calls=False)
    data = tape(frame, samples=options.samples)
    write_bytes(options.output, data)
    if not options.json:
        print(f"wrote {options.output}: {frame.width} x {frame.height} pixels, {len(data)} bytes")
    return tell(frame, options, {"output": options.output, "bytes": len(data)})


def _draw(options: argparse.Namespace) -> int:
    import json
    from pathlib import Path

    import numpy as np
    from PIL import Image

    from glsim.render.replay import replayed
    from glsim.render.tape import Tape, TapeError

    check_picture_name(options.output)
    check_folder(options.output)
    try:
        tape = Tape.from_bytes(Path(options.tape).read_bytes())
        pixels = replayed(tape, options.picture)
    except TapeError as error:
        raise TapeError(f"{options.tape}: {error}") from None
    image = Image.fromarray(np.ascontiguousarray(pixels[..., :3]))
    write_atomically(options.output, lambda name: image.save(name))
    found = {"output": options.output, "picture": tape.pictures[options.picture].name, "pictures": len(tape.pictures)}
    if options.json:
        print(json.dumps({"status": "ok", **found, "made_by": tape.made_by}))
    else:
        print(f"wrote {options.output}: picture {options.picture} of {len(tape.pictures)}, by {tape.made_by}")
    return 0
