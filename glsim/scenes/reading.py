"""Mesh files are read with care: they come from strangers.

A file, and what it names beside it (buffers of glTF, materials of OBJ), must be a regular file; what it names must lie
in its own folder.  Size, memory and time are limited, so that no file can fill the machine or stop the program.
"""

from __future__ import annotations

import bz2
import gzip
import io
import os
import signal
import stat
import threading
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any
from urllib.parse import unquote

import trimesh

from glsim.scenes.mesh import MeshError
from glsim.scenes.plain import plain

SIZE = 512 << 20  # bytes: of a file, and of all that an archive contains
MEMORY = 4 << 30  # bytes that reading may take (Linux)
SECONDS = 120.0  # that reading may take (POSIX, in the main thread)
ARCHIVES = (".3mf", ".zae", ".3dxml")  # mesh formats that are ZIP archives


def read(path: Path) -> tuple[Any, list[Any]]:
    """A mesh file as a trimesh.Scene, and its triangle meshes placed in that scene: a list of trimesh.Trimesh.

    Raises MeshError, with one sentence that names the file, for what is no regular file, is too large, too slow or
    broken, names a necessary file outside of its folder, or has no triangles.  What is not necessary (materials,
    pictures) is left out; ``metadata["missing"]`` of the scene has the names.
    """
    folder = Folder(str(path))
    kind = trimesh.util.split_extension(path.name, special=["tar.gz", "tar.bz2"]).lower()
    try:
        with limits(), regular(path) as file:
            check_unpacked(file, kind)
            source = io.BytesIO(plain(file.read(), kind)) if kind in ("obj", "gltf", "glb") else file
            scene = trimesh.load_scene(source, file_type=kind, resolver=folder, process=False)
            meshes = [mesh for mesh in scene.dump() if isinstance(mesh, trimesh.Trimesh) and len(mesh.faces)]
    except MemoryError as error:
        raise MeshError(f"{path} cannot be read: it needs more than {MEMORY >> 30} GiB of memory") from error
    except ImportError as error:
        if error.name == "charset_normalizer":  # trimesh would guess how a text is encoded
            raise MeshError(f"{path} is no whole {kind.upper()} file: its size does not fit its header") from error
        raise MeshError(f"{path}: reading this kind of file needs a package more: pip install {error.name}") from error
    except Exception as error:  # whatever the reader of this format trips over
        reason = " ".join(str(error).split()) or type(error).__name__
        raise MeshError(f"{path} cannot be read as a {kind.upper() or 'mesh'} file: {reason}") from error
    if not meshes:
        raise MeshError(f"{path} has no triangles to draw")
    scene.metadata["missing"] = folder.missing
    return scene, meshes


def regular(path: Path) -> IO[bytes]:
    """The file, opened.  Raises ValueError for folders, pipes, sockets and devices, and for more than SIZE bytes."""
    info = path.stat()
    if not stat.S_ISREG(info.st_mode):
        kind = "folder" if stat.S_ISDIR(info.st_mode) else "pipe" if stat.S_ISFIFO(info.st_mode) else "device or socket"
        raise ValueError(f"{path.name} is a {kind}, no regular file")
    if info.st_size > SIZE:
        raise ValueError(f"{path.name} has {info.st_size >> 20} MiB, more than {SIZE >> 20}")
    without_waiting = getattr(os, "O_NONBLOCK", 0)  # should it have become a pipe by now
    return open(path, "rb", opener=lambda name, flags: os.open(name, flags | without_waiting))


class Folder(trimesh.resolvers.FilePathResolver):
    """Gives the files that a mesh file names: regular ones, in the mesh file's own folder and the folders in it.

    missing: names for which there is none.
    """

    def __init__(self, path: str) -> None:
        super().__init__(path)
        self.missing: list[str] = []

    def get(self, name: str) -> bytes:
        """The bytes of a file, named as in the mesh file, or percent-encoded, or with another machine's folders.

        Raises ValueError for a name that leads out of the folder (also by a link), to nothing, or to no regular file.
        """
        root = Path(self.parent).resolve()
        plain = unquote(name.strip())
        for candidate in (name.strip(), plain, plain.replace("\\", "/").rsplit("/", 1)[-1]):
            path = (root / candidate).resolve()
            if path.is_relative_to(root) and path.exists():
                with regular(path) as file:
                    return file.read(SIZE)
        self.missing.append(name.strip())
        raise ValueError(f"it names {name!r}, which is not in its folder; put that file beside it")

    def namespaced(self, namespace: str) -> Folder:
        raise NotImplementedError("no reader of trimesh looks into a folder of its own")


def check_unpacked(file: IO[bytes], kind: str) -> None:
    """Raises ValueError for an archive that contains more than SIZE bytes, or a mesh that is an archive again."""
    size = 0
    if f".{kind}" in (".zip", *ARCHIVES):
        entries = zipfile.ZipFile(file).infolist()  # a reader gets no more than an entry's declared size
        size = sum(entry.file_size for entry in entries)
        inner = [entry.filename for entry in entries if entry.filename.lower().endswith(ARCHIVES)]
        if inner and kind == "zip":
            raise ValueError(f"its {inner[0]} is an archive inside an archive; unpack it first")
    elif kind.endswith(("bz2", "gz")):
        with bz2.open(file) if kind.endswith("bz2") else gzip.open(file) as unpacked:
            while size <= SIZE and (block := unpacked.read(1 << 20)):
                size += len(block)
    file.seek(0)
    if size > SIZE:
        raise ValueError(f"it contains more than {SIZE >> 20} MiB when it is unpacked")


@contextmanager
def limits() -> Iterator[None]:
    """Bounds for what is done inside: MemoryError after MEMORY more bytes, TimeoutError after SECONDS."""
    with memory_limit(), time_limit():
        yield


@contextmanager
def memory_limit() -> Iterator[None]:
    """Raise MemoryError beyond MEMORY more bytes of address space; no limit where /proc is missing (not Linux)."""
    try:
        import resource

        mapped = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    except (ImportError, OSError):
        yield
        return
    before, most = resource.getrlimit(resource.RLIMIT_AS)
    allowed = [mapped + MEMORY, *(limit for limit in (before, most) if limit != resource.RLIM_INFINITY)]
    resource.setrlimit(resource.RLIMIT_AS, (min(allowed), most))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_AS, (before, most))


@contextmanager
def time_limit() -> Iterator[None]:
    """An alarm, repeated each second in case a reader swallows it.  Only the main thread can have one."""
    if not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        yield
        return

    def late(*_: object) -> None:
        raise TimeoutError(f"it takes longer than {SECONDS:g} s")

    handler = signal.signal(signal.SIGALRM, late)
    delay, interval = signal.setitimer(signal.ITIMER_REAL, SECONDS, 1.0)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, delay, interval)
        signal.signal(signal.SIGALRM, handler)
