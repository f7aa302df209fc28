"""Mesh files from strangers: nothing outside of their folder is opened, and nothing hangs or fills the machine."""

from __future__ import annotations

import bz2
import gzip
import json
import os
import signal
import struct
import threading
import zipfile
from pathlib import Path

import numpy as np
import pytest
import trimesh

from glsim.radiosity.load import scene_from
from glsim.radiosity.scene import SceneError
from glsim.scenes import MeshError, load, open_scene, reading

TRIANGLE = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], np.float32).tobytes() + np.array([0, 1, 2], np.uint32).tobytes()
OBJ = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl paint\nf 1 2 3\n"
RED, GREEN = (f"newmtl paint\nKd {color}\n" for color in ("1 0 0", "0 1 0"))

posix = pytest.mark.skipif(os.name == "nt", reason="needs pipes and links")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """The mesh's own folder; outside of it lie files that nobody may open."""
    inside = tmp_path / "mesh"
    (inside / "parts").mkdir(parents=True)
    for at, material in ((tmp_path / "secret", RED), (inside / "own", GREEN), (inside / "parts" / "own", GREEN)):
        at.with_suffix(".bin").write_bytes(TRIANGLE)
        at.with_suffix(".mtl").write_text(material)
    if os.name != "nt":
        for suffix in ("bin", "mtl"):
            os.mkfifo(inside / f"pipe.{suffix}")
            (inside / f"out.{suffix}").symlink_to(f"../secret.{suffix}")
            (inside / f"in.{suffix}").symlink_to(f"own.{suffix}")
    return inside


def gltf(folder: Path, uri: str, count: int = 3) -> Path:
    views = [{"buffer": 0, "byteOffset": at, "byteLength": length} for at, length in ((0, 36), (36, 12))]
    position: dict[str, object] = {"componentType": 5126, "count": count, "type": "VEC3"}
    if count == 3:
        position["bufferView"] = 0
    index = {"bufferView": 1, "componentType": 5125, "count": 3, "type": "SCALAR"}
    path = folder / "mesh.gltf"
    path.write_text(json.dumps({
        "asset": {"version": "2.0"}, "buffers": [{"uri": uri, "byteLength": 48}], "bufferViews": views,
        "accessors": [position, index], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "scene": 0,
    }))  # fmt: skip
    return path


def refused(path: Path, sentence: str) -> None:
    """By both readers, with the file's name and in one line."""
    for what, kind in ((lambda: load(path), MeshError), (lambda: scene_from(path), SceneError)):
        with pytest.raises(kind, match=sentence) as caught:
            what()
        assert path.name in str(caught.value)
        assert "\n" not in str(caught.value)


@posix
@pytest.mark.parametrize(
    "uri", ["own.bin", "parts/own.bin", "parts/../own.bin", "in.bin", "%6fwn.bin", "C:\\x\\own.bin"]
)
def test_buffers_in_the_folder_are_read(folder: Path, uri: str) -> None:
    assert len(load(gltf(folder, uri))[0].triangles) == 1


@posix
@pytest.mark.parametrize(
    "uri", ["../secret.bin", "{}/secret.bin", "file://{}/secret.bin", "%2e%2e/secret.bin", "parts/../../secret.bin",
            "out.bin", "/etc/passwd", "/dev/zero", "~/secret.bin", "http://localhost:1/secret.bin", "nowhere.bin"],
)  # fmt: skip
def test_buffers_elsewhere_are_refused(folder: Path, uri: str) -> None:
    refused(gltf(folder, uri.format(folder.parent)), "which is not in its folder; put that file beside it")


@posix
@pytest.mark.parametrize(("uri", "kind"), [("pipe.bin", "pipe"), ("parts", "folder")])
def test_buffers_must_be_regular_files(folder: Path, uri: str, kind: str) -> None:
    refused(gltf(folder, uri), f"{uri} is a {kind}, no regular file")


@posix
@pytest.mark.parametrize(
    ("name", "green"),
    [("own.mtl", True), ("in.mtl", True), ("../secret.mtl", False), ("{}/secret.mtl", False), ("out.mtl", False),
     ("pipe.mtl", False), ("/dev/zero", False), ("nowhere.mtl", False)],
)  # fmt: skip
def test_materials_come_from_the_folder_or_not_at_all(folder: Path, name: str, green: bool) -> None:
    path = folder / "mesh.obj"
    path.write_text(f"mtllib {name.format(folder.parent)}\n" + OBJ)
    (mesh,) = load(path)
    assert (mesh.material.diffuse if mesh.material else None) == ((0, 1, 0, 1) if green else None)


@posix
def test_a_mesh_file_is_a_regular_file(folder: Path) -> None:
    os.mkfifo(folder / "mesh.obj")
    refused(folder / "mesh.obj", "mesh.obj is a pipe, no regular file")
    refused(Path("/dev/zero"), "zero is a device or socket, no regular file")
    (folder / "mesh.ply").mkdir()
    with pytest.raises(MeshError, match=r"mesh.ply is a folder"):
        open_scene(folder / "mesh.ply")
    (folder / "link.gltf").symlink_to(gltf(folder, "own.bin"))
    assert len(load(folder / "link.gltf")) == 1  # the user named the link


def test_large_files_and_archives(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reading, "SIZE", 1 << 20)
    (folder / "large.obj").write_text(OBJ + "#" * (1 << 20))
    refused(folder / "large.obj", "large.obj has 1 MiB, more than 1")
    for kind, inner in (("zip", "mesh.obj"), ("3mf", "3D/3dmodel.model"), ("zae", "mesh.dae"), ("3dxml", "a.xml")):
        with zipfile.ZipFile(folder / f"bomb.{kind}", "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr(inner, bytes(2 << 20))
        refused(folder / f"bomb.{kind}", "contains more than 1 MiB when it is unpacked")
    for kind in ("bz2", "tar.bz2", "tar.gz"):
        (folder / f"bomb.obj.{kind}").write_bytes(
            gzip.compress(bytes(2 << 20)) if kind.endswith("gz") else bz2.compress(bytes(2 << 20))
        )
        refused(folder / f"bomb.obj.{kind}", "contains more than 1 MiB when it is unpacked")
    with zipfile.ZipFile(folder / "nested.zip", "w") as archive:
        archive.write(folder / "bomb.3mf", "inner.3mf")
    refused(folder / "nested.zip", r"its inner.3mf is an archive inside an archive; unpack it first")
    with zipfile.ZipFile(folder / "whole.zip", "w") as archive:
        archive.writestr("mesh.obj", "mtllib ../secret.mtl\n" + OBJ)
    assert len(load(folder / "whole.zip")[0].triangles) == 1


PLY = "ply\nformat {} 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
PLY += "property list {} int vertex_indices\nend_header\n"


@pytest.mark.parametrize(
    ("name", "data"),
    [
        ("vertices.ply", PLY.format("binary_little_endian", 4 * 10**9, "uchar").encode() + TRIANGLE),
        ("vertices-as-text.ply", PLY.format("ascii", 4 * 10**11, "uchar").encode() + b"0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
        ("list.ply", PLY.format("binary_little_endian", 3, "uint").encode() + TRIANGLE[:36] + b"\xff" * 16),
        ("triangles.stl", bytes(80) + struct.pack("<I", 2**32 - 1) + bytes(50)),
        ("vertices.off", b"OFF\n999999999999 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
        ("index.off", b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 4000000000\n"),
    ],
)
def test_gigantic_counts(tmp_path: Path, name: str, data: bytes) -> None:
    (tmp_path / name).write_bytes(data)
    refused(tmp_path / name, name.replace(".", r"\."))


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="the system does not tell what is mapped")
def test_memory_is_limited_and_given_back(folder: Path) -> None:
    import resource

    before = resource.getrlimit(resource.RLIMIT_AS)
    refused(gltf(folder, "own.bin", count=3 * 10**9), "it needs more than 4 GiB of memory")
    assert resource.getrlimit(resource.RLIMIT_AS) == before


@posix
def test_time_is_limited_and_the_alarm_is_put_back(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "slow.tar.gz").write_bytes(gzip.compress(bytes(100 << 20), 1))
    monkeypatch.setattr(reading, "SECONDS", 0.01)
    handler = signal.getsignal(signal.SIGALRM)
    refused(tmp_path / "slow.tar.gz", r"it takes longer than 0.01 s")
    assert signal.getsignal(signal.SIGALRM) is handler
    assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)
    (tmp_path / "quick.obj").write_text(OBJ)
    found = []
    thread = threading.Thread(target=lambda: found.extend(load(tmp_path / "quick.obj")))  # no alarm in threads
    thread.start()
    thread.join()
    assert len(found) == 1


@posix
def test_the_required_trimesh_refuses_by_itself_what_leads_out_of_the_folder(folder: Path) -> None:
    """Before 5.0 its own resolver opened any path."""
    for name in ("../secret.bin", "out.bin", "/etc/passwd"):
        with pytest.raises(ValueError, match="escapes"):
            trimesh.resolvers.FilePathResolver(str(folder / "mesh.gltf")).get(name)
    assert '"trimesh>=5.0"' in (Path(__file__).parents[2] / "pyproject.toml").read_text()
