"""Which modules the program's own files import.

Own files are the program and the other files in its folder, except installed packages.  Two rules hold for their
imports only:

- the modules ``time`` and ``datetime`` follow the clock of the steps.  Libraries keep the real ones: pandas and
  threads break when time stands still or when ``datetime.datetime`` is another class;
- a module beside the program comes before a module of Python of the same name.  ``random.py`` or ``types.py`` in a
  student's folder is for the student's files; NumPy, Pillow and glsim go on with Python's own.
"""

from __future__ import annotations

import builtins
import os
import random
import sys
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from importlib.machinery import FileFinder, ModuleSpec, SourceFileLoader
from importlib.util import module_from_spec, spec_from_file_location
from types import ModuleType
from typing import Any

import numpy as np

LIBRARIES = {"PIL", "fissix", "glfw", "rich", "scipy", "trimesh"}  # that glsim loads when they are needed
PRIVATE = "_own_"  # prefix in sys.modules of own modules whose names Python or a library also uses
EPOCH = 1_000_000_000.0  # what time.time() says at the start, in seconds


class OwnImports:
    """The imports of the files in ``folder``.

    stand_ins: modules that own files get instead of those of the same name.  loader: what loads own modules.
    """

    def __init__(self, folder: str, stand_ins: dict[str, ModuleType], loader: type[SourceFileLoader]) -> None:
        self.folder, self.stand_ins, self.loader = folder, stand_ins, loader
        self.inside = os.path.join(folder, "")
        # Names of Python's and libraries' modules: in the folder only own files find modules of these names.
        self.hidden = sys.stdlib_module_names | LIBRARIES | {name.partition(".")[0] for name in sys.modules}
        self.own_files: dict[Any, bool] = {}
        self.python_import = builtins.__import__

    def install(self) -> None:
        sys.path.insert(0, self.folder)
        sys.path_hooks.insert(0, self._finder)
        sys.path_importer_cache.pop(self.folder, None)
        builtins.__import__ = self._import

    def _finder(self, path: str) -> Any:
        path = os.path.abspath(path)
        if not self._is_own(os.path.join(path, "")):
            raise ImportError
        return _Finder(path, (self.loader, [".py"]), hidden=self.hidden if path == self.folder else frozenset())

    def _import(
        self,
        name: str,
        globals: Mapping[str, Any] | None = None,
        locals: Mapping[str, Any] | None = None,
        fromlist: Sequence[str] | None = (),
        level: int = 0,
    ) -> Any:
        if level == 0 and isinstance(globals, dict) and self._is_own(globals.get("__file__")):
            top = name.partition(".")[0]
            if top in self.hidden and self._load_beside(top):
                name = PRIVATE + name
            elif name in self.stand_ins and (fromlist or "." not in name):
                return self.stand_ins[name]
        return self.python_import(name, globals, locals, fromlist or (), level)

    def _is_own(self, file: Any) -> bool:
        if file not in self.own_files:
            inside = isinstance(file, str) and os.path.join(os.path.abspath(file), "").startswith(self.inside)
            self.own_files[file] = inside and "site-packages" not in os.path.abspath(file)[len(self.inside) :]
        return self.own_files[file]

    def _load_beside(self, name: str) -> bool:
        """Whether the folder has a module of this name, which Python would import from elsewhere; loads it if so."""
        private = PRIVATE + name
        if private in sys.modules:
            return True
        stem = self.inside + name
        path = next((path for path in (f"{stem}/__init__.py", f"{stem}.py") if os.path.isfile(path)), None)
        if path is None or path == getattr(sys.modules["__main__"], "__file__", None):
            return False
        spec = spec_from_file_location(private, path, loader=self.loader(private, path))
        if spec is None or spec.loader is None:
            return False
        module = sys.modules[private] = module_from_spec(spec)
        try:
            spec.loader.exec_module(module)
        except BaseException:
            del sys.modules[private]
            raise
        return True


class _Finder(FileFinder):
    """Finds the modules of a folder but for some names."""

    def __init__(self, path: str, *loaders: Any, hidden: frozenset[str] | set[str]) -> None:
        super().__init__(path, *loaders)
        self.hidden = hidden

    def find_spec(self, fullname: str, target: ModuleType | None = None) -> ModuleSpec | None:
        return None if fullname in self.hidden else super().find_spec(fullname, target)


# ---------------------------------------------------------------- time and chance


def steady_time(seconds: Callable[[], float], advance: Callable[[float], None], python2: bool) -> dict[str, ModuleType]:
    """Stand-ins for the modules ``time`` and ``datetime`` that follow the clock of the steps.

    seconds: returns the seconds since the start.  advance(s): called by time.sleep(s).  python2: add time.clock.
    """
    return {"time": _time(seconds, advance, python2), "datetime": _datetime(seconds)}


def _copy(name: str) -> Any:
    module = ModuleType(name)
    original = sys.modules.get(name) or __import__(name)
    module.__dict__.update({key: value for key, value in vars(original).items() if key != "__spec__"})
    return module


def _time(seconds: Callable[[], float], advance: Callable[[float], None], python2: bool) -> ModuleType:
    import time as real

    module = _copy("time")
    module.time = lambda: EPOCH + seconds()
    for name in ("perf_counter", "monotonic", "process_time", "thread_time", *(["clock"] if python2 else ())):
        setattr(module, name, lambda: seconds())
    for name in ("time", "perf_counter", "monotonic", "process_time", "thread_time"):
        setattr(module, f"{name}_ns", partial(_nanoseconds, getattr(module, name)))
    module.sleep = lambda duration, /: advance(float(duration))
    module.gmtime = lambda s=None: real.gmtime(module.time() if s is None else s)
    module.localtime = lambda s=None: real.localtime(module.time() if s is None else s)
    module.ctime = lambda s=None: real.ctime(module.time() if s is None else s)
    module.strftime = lambda form, t=None: real.strftime(form, module.localtime() if t is None else t)
    module.asctime = lambda t=None: real.asctime(module.localtime() if t is None else t)
    return module  # type: ignore[no-any-return]


def _nanoseconds(function: Callable[[], float]) -> int:
    return round(function() * 1e9)


def _datetime(seconds: Callable[[], float]) -> ModuleType:
    import datetime as real

    class Like(type):
        """The class of a stand-in, which isinstance and issubclass take for the real class."""

        def __instancecheck__(cls, instance: object) -> bool:
            return isinstance(instance, cls.__mro__[1])

        def __subclasscheck__(cls, other: type) -> bool:
            return issubclass(other, cls.__mro__[1])

    class Datetime(real.datetime, metaclass=Like):
        @classmethod
        def now(cls, tz: Any = None) -> Any:
            return real.datetime.fromtimestamp(EPOCH + seconds(), tz)

        @classmethod
        def today(cls) -> Any:
            return cls.now()

        @classmethod
        def utcnow(cls) -> Any:
            return real.datetime.fromtimestamp(EPOCH + seconds(), real.UTC).replace(tzinfo=None)

    class Date(real.date, metaclass=Like):
        @classmethod
        def today(cls) -> Any:
            return real.date.fromtimestamp(EPOCH + seconds())

    module = _copy("datetime")
    for stand_in, original in ((Datetime, real.datetime), (Date, real.date)):
        stand_in.__name__ = stand_in.__qualname__ = original.__name__
        setattr(module, original.__name__, stand_in)
    return module  # type: ignore[no-any-return]


def repeatable_chance() -> None:
    """Random numbers are the same each time, also after ``random.seed()`` and from generators without a seed."""
    seed = random.Random.seed

    def seed_0(self: random.Random, a: Any = None, version: int = 2) -> None:
        seed(self, 0 if a is None else a, version)

    random.Random.seed = seed_0  # type: ignore[method-assign]
    random.seed = random._inst.seed
    random.seed(0)
    numpy_seed, numpy_generator = np.random.seed, np.random.default_rng
    np.random.seed = lambda seed=None: numpy_seed(0 if seed is None else seed)
    np.random.default_rng = lambda seed=None: numpy_generator(0 if seed is None else seed)
    np.random.seed(0)
