"""What ``glsim doctor`` finds out about this machine."""

from __future__ import annotations

import platform
import sys
from dataclasses import asdict
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from glsim.render.device import BACKENDS, FIXES, Attempt, one_line, order

PACKAGES = ("moderngl", "glcontext", "numpy", "pillow", "trimesh", "rich", "pyrender", "PyOpenGL")


def diagnose() -> dict[str, Any]:
    """Everything ``glsim doctor`` prints: versions, each backend tried, EGL devices, native fixed function.

    "works" is True if a default ``glsim.offscreen`` would open.
    """
    from glsim.version import __version__

    backends = [_try(name) for name in (*[name for name, _ in order("auto")], *_other_backends())]
    return {
        "glsim": __version__,
        "python": platform.python_version(),
        "platform": f"{platform.system()} {platform.release()} {platform.machine()}",
        "packages": {name: installed for name in PACKAGES if (installed := _version(name))},
        "backends": backends,
        "devices": _devices() if sys.platform.startswith("linux") else [],
        "native fixed function": _native(),
        "works": any(entry["works"] for entry in backends[: len(order("auto"))]),
    }


def _other_backends() -> list[str]:
    """Backends of this platform that the default order leaves out (because GLSIM_BACKEND names another)."""
    backends = ("egl", "osmesa", "x11") if sys.platform.startswith("linux") else ("native",)
    return [name for name in backends if name not in dict(order("auto"))]


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return ""


def _describe(backend: str, device: int | None = None) -> dict[str, str]:
    import moderngl

    loader = BACKENDS[backend](device)
    context = moderngl.create_context(context=loader, require=330)
    info = {"renderer": context.info["GL_RENDERER"], "version": context.info["GL_VERSION"]}
    context.release()
    return info


def _try(backend: str) -> dict[str, Any]:
    try:
        return {"backend": backend, "works": True, **_describe(backend)}
    except Exception as error:
        return {"works": False, **asdict(Attempt(backend, one_line(error), FIXES[backend]))}


def _devices() -> list[dict[str, Any]]:
    """The EGL devices, by the index that ``backend="egl:N"`` takes."""
    from glsim.render.egl import count_devices

    devices = []
    for index in range(count_devices()):
        try:
            devices.append({"index": index, **_describe("egl", index)})
        except Exception as error:
            devices.append({"index": index, "renderer": f"does not open: {one_line(error)}", "version": ""})
    return devices


def _native() -> dict[str, Any]:
    from glsim.render.native import Native, NoNativeError

    try:
        native = Native(16, 16)
    except NoNativeError as error:
        return {"works": False, "said": str(error)}
    native.release()
    return {"works": True, "backend": native.backend, "renderer": native.renderer, "version": native.version}
