"""Mesh files in the plainest form that their format allows: what trimesh misreads or leaves out is written out."""

from __future__ import annotations

import json
import re
import struct
from typing import Any

RELATIVE = re.compile(rb"(?m)^f [^\n]*(?<![^ /])-\d")
STRENGTH = "KHR_materials_emissive_strength"


def plain(data: bytes, kind: str) -> bytes:
    """Return the bytes of a file in plain form; those of other formats as they are.

    OBJ: no tabs, no lines that go on in the next one, no numbers that count backwards.  glTF: emissive factors are
    multiplied by their strength.
    """
    if kind == "obj":
        return plain_obj(data)
    if kind in ("gltf", "glb") and STRENGTH.encode() in data:
        header = header_of(data, kind)
        for material in header.get("materials", ()):
            strength = material.get("extensions", {}).get(STRENGTH, {}).get("emissiveStrength", 1.0)
            material["emissiveFactor"] = [strength * value for value in material.get("emissiveFactor", (0, 0, 0))]
        return with_header(data, kind, header)
    return data


def plain_obj(data: bytes) -> bytes:
    """Return an OBJ file with spaces for tabs, whole lines, and numbers of vertices that count from the first."""
    data = data.replace(b"\r\n", b"\n").replace(b"\\\n", b" ").replace(b"\t", b" ")
    data = re.sub(rb"(?m)^ +", b"", data)
    if not RELATIVE.search(data):
        return data
    counts = {b"v": 0, b"vt": 0, b"vn": 0}
    lines = data.split(b"\n")
    for k, line in enumerate(lines):
        word, _, rest = line.partition(b" ")
        if word in counts:
            counts[word] += 1
        elif word == b"f" and b"-" in rest:
            lines[k] = b"f " + b" ".join(_absolute(corner, list(counts.values())) for corner in rest.split())
    return b"\n".join(lines)


def _absolute(corner: bytes, many: list[int]) -> bytes:
    """Return a corner of a face, v/vt/vn, with numbers from 1 on; many: how many of each there are up to here."""
    numbers = corner.split(b"/")
    for k, number in enumerate(numbers):
        if number.startswith(b"-"):
            numbers[k] = b"%d" % (many[k] + 1 + int(number))
    return b"/".join(numbers)


def header_of(data: bytes, kind: str) -> Any:
    """Return the JSON of a glTF file, text or binary (glTF 2.0, section 4.4).  Raises ValueError if there is none."""
    if kind == "gltf":
        return json.loads(data)
    magic, _, _, length, chunk = struct.unpack_from("<4sIII4s", data)
    if magic != b"glTF" or chunk != b"JSON":
        raise ValueError("it does not begin as a binary glTF file of version 2")
    return json.loads(data[20 : 20 + length])


def with_header(data: bytes, kind: str, header: Any) -> bytes:
    """Return a glTF file with another JSON."""
    text = json.dumps(header).encode()
    if kind == "gltf":
        return text
    text += b" " * (-len(text) % 4)
    (length,) = struct.unpack_from("<I", data, 12)
    rest = data[20 + length :]
    return struct.pack("<4sIII4s", b"glTF", 2, 20 + len(text) + len(rest), len(text), b"JSON") + text + rest
