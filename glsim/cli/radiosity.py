"""The command ``glsim radiosity``."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from glsim.cli.options import check_picture_name, console, count, exitance, positive, size, viewpoint
from glsim.files import check_folder, write_atomically, write_text

if TYPE_CHECKING:
    from glsim.radiosity.result import Radiosity

DATA = (".glb", ".ply", ".npz")  # what is no picture


def add(commands: Any) -> None:
    """Add the command's parser to those of ``glsim``."""
    text = "solve a scene's radiosity and bake it into vertex colours"
    p = commands.add_parser("radiosity", help=text, description=text[0].upper() + text[1:] + ".")
    p.add_argument(
        "what", nargs="?", metavar="SCENE|FILE|SCRIPT", help="a scene (--list), a mesh file or a program (.py)"
    )
    p.add_argument("-o", "--output", action="append", metavar="FILE",
                   help=".png, .glb, .ply or .npz; may be repeated (default: radiosity.png)")  # fmt: skip
    p.add_argument("--list", action="store_true", help="list the built-in scenes")
    p.add_argument("--json", nargs="?", const=True, default=False, metavar="FILE.json",
                   help="print the report as one JSON object, or write it to a file")  # fmt: skip
    _add_solution(p.add_argument_group("how it is solved"))
    _add_picture(p.add_argument_group("what is drawn"))
    p.set_defaults(run=_radiosity)


def _add_solution(p: Any) -> None:
    p.add_argument("--patches", type=count, default=1000, metavar="N", help="about how many (default: %(default)s)")
    p.add_argument("--adaptive", action="store_true", help="smaller patches where the light changes fast")
    p.add_argument("--method", metavar="NAME",
                   help="of form factors: contour (default), analytic, point, disc, monte-carlo, hemicube; or"
                   " hierarchical (default above 3000 patches): links instead of a matrix")  # fmt: skip
    p.add_argument("--accuracy", type=positive, default=5e-5, metavar="A",
                   help="of a link, in mean radiosities, for hierarchical (default: %(default)s)")  # fmt: skip
    p.add_argument("--solver", metavar="NAME",
                   help="gauss-seidel (default), jacobi, sor, cg, shooting, lu; where there is no matrix, for"
                   " hierarchical and --scheduler: cg (default), jacobi")  # fmt: skip
    p.add_argument("--tolerance", type=positive, default=1e-6, help="of the residual (default: %(default)s)")
    p.add_argument("--vertices", default="gather", metavar="NAME",
                   help="gather (at each vertex, default) or average (of the patches around)")  # fmt: skip
    p.add_argument("--drawn", type=_drawn, metavar="N",
                   help="about how many vertices, more where the light changes fast (default: five for each patch);"
                   " 0: the corners of the patches, as textbooks draw them")  # fmt: skip
    p.add_argument("--flip", action="store_true", help="turn all fronts to the other side")
    p.add_argument("--two-sided", action="store_true", help="sheets reflect on both sides")
    p.add_argument("--emit", type=exitance, action="append", default=[], metavar="NAME=E",
                   help="exitance of a material, one number or R,G,B; may be repeated")  # fmt: skip
    p.add_argument("--close", action="store_true", help="scale form factors so that rows sum to 1: closed scenes")
    p.add_argument("--scheduler", metavar="ADDRESS", help="use the workers of a Dask scheduler, tcp://HOST:8786")
    p.add_argument("--resume", metavar="FILE",
                   help="where form factors (contour, analytic) or links that are done are kept at Ctrl-C, and looked"
                   " for (default: beside the first output); with --scheduler a name there")  # fmt: skip


def _add_picture(p: Any) -> None:
    p.add_argument("--size", type=size, default=512, metavar="N", help="pixels of a picture (default: %(default)s)")
    p.add_argument("--views", type=_views, default=[0], metavar="N,...|all",
                   help="which cameras; of several, pictures get the number in their names (default: 0)")  # fmt: skip
    p.add_argument("--camera", type=viewpoint, metavar="CAMERA",
                   help="instead: one of the scene, by name (--list); X,Y,Z/X,Y,Z[/DEGREES]: the eye, where it looks,"
                   " the angle from bottom to top; AZIMUTH,ELEVATION[,DISTANCE]: around the scene, in degrees from its"
                   " front, and radii (4)")  # fmt: skip
    p.add_argument("--direct", metavar="FILE", help="a picture of direct illumination and radiosity side by side")
    p.add_argument("--final-gather", metavar="FILE",
                   help="a sheet: patches, meshes, and light gathered at every pixel, with their errors (slow: try"
                   " --size 200 first)")  # fmt: skip
    p.add_argument("--steps", metavar="FILE",
                   help="the picture after some of the solver's iterations, on a sheet or, if the name ends in .gif,"
                   " moving; --solver jacobi shows bounces, --solver shooting shots")  # fmt: skip
    p.add_argument(
        "--white", type=positive, metavar="B", help="the radiosity that becomes white (default: by the scene)"
    )
    p.add_argument("--tone", choices=("linear", "reinhard"), help="tone mapping (default: by the scene)")
    p.add_argument("--gamma", type=positive, default=2.2, help="of the screen (default: 2.2)")


def _drawn(text: str) -> int:
    """Return the number of vertices in an option's text."""
    if not text.isdigit() or int(text) > 10_000_000:
        raise argparse.ArgumentTypeError(f"a whole number from 0 to 10000000 is needed, not {text!r}")
    return int(text)


def _views(text: str) -> list[int] | None:
    """Return the numbers of cameras in an option's text; None: all."""
    words = text.split(",")
    if text != "all" and not all(word.isdigit() and int(word) < 1000 for word in words):
        raise argparse.ArgumentTypeError(f"numbers of cameras from 0 on, or all, are needed, not {text!r}")
    return None if text == "all" else [int(word) for word in words]


def _radiosity(options: argparse.Namespace) -> int:
    """Run the command; return its exit status."""
    if isinstance(options.json, str) and not options.json.endswith(".json"):
        if options.what:
            raise ValueError(f"--json {options.json}: the report's name must end in .json")
        options.what, options.json = options.json, True  # glsim radiosity --json SCENE
    if options.list:
        return _list(options)
    if not options.what:
        print(
            "glsim radiosity: name a scene, a mesh file or a program; --list shows the built-in scenes", file=sys.stderr
        )
        return 2
    options.output = options.output or ["radiosity.png"]
    for name in options.output:
        if Path(name).suffix.lower() not in DATA:
            check_picture_name(name)
    for name in filter(None, (options.direct, options.final_gather, options.steps)):
        check_picture_name(name)
    for name in (
        *options.output,
        options.direct,
        options.final_gather,
        options.steps,
        options.json,
        None if options.scheduler else options.resume,
    ):
        if isinstance(name, str):
            check_folder(name)
    result = _solved(options)
    report = {**result.report(), "outputs": _written(result, options)}
    if isinstance(options.json, str):
        report["outputs"].append(options.json)
        write_text(Path(options.json), json.dumps({"status": "ok", **report}, indent=1) + "\n")
    if options.json is True:
        print(json.dumps({"status": "ok", **report}))
    else:
        _print(report)
    return 0


def _list(options: argparse.Namespace) -> int:
    """Print the built-in scenes, as lines or as JSON."""
    from glsim.radiosity.scenes import BUILT_IN

    about = {name: entry.about for name, entry in BUILT_IN.items()}
    cameras = {name: [view.name for view in entry.make().views if view.name] for name, entry in BUILT_IN.items()}
    lines = [
        f"  {name:16} {words}" + (f"; cameras: {', '.join(cameras[name])}" if cameras[name] else "")
        for name, words in about.items()
    ]
    print(json.dumps({"scenes": about, "cameras": cameras}) if options.json else "Scenes:\n" + "\n".join(lines))
    return 0


def _solved(options: argparse.Namespace) -> Radiosity:
    """Solve with these options, under progress bars."""
    from glsim.radiosity.cameras import named
    from glsim.radiosity.load import scene_from
    from glsim.radiosity.solution import solve

    checkpoint = options.resume
    if not checkpoint and not options.scheduler:
        checkpoint = str(Path(options.output[0]).with_suffix(".unfinished.npz"))
    with _bars() as (bars, progress):
        task = bars.add_task("solving", total=None)
        try:
            scene = scene_from(options.what, emit=dict(options.emit), two_sided=options.two_sided)
            if isinstance(options.camera, str):
                named(scene, options.camera)  # raises before anything is solved
            result = solve(
                scene, options.patches, method=options.method, solver=options.solver,
                tolerance=options.tolerance, vertices=options.vertices, drawn=options.drawn, adaptive=options.adaptive,
                accuracy=options.accuracy, flip=options.flip, close=options.close, checkpoint=checkpoint,
                scheduler=options.scheduler, progress=progress,
                on_step=lambda step: bars.update(task, description=f"iteration {step.iteration}, {step.residual:.1e}"),
            )  # fmt: skip
        except KeyboardInterrupt:
            if checkpoint and Path(checkpoint).exists():
                print(f"glsim: what is done is in {checkpoint}; the same command goes on with it", file=sys.stderr)
            raise
    return replace(result, white=options.white, tone=options.tone, gamma=options.gamma)


def _written(result: Radiosity, options: argparse.Namespace) -> list[str]:
    """Write all that was asked for, and return the names of the files."""
    from glsim.radiosity.watch import save_steps

    views: list[Any] = list(range(len(result.patches.scene.views))) if options.views is None else options.views
    if options.camera is not None:
        views = [options.camera]
    for view in views:
        result.view(view)  # before anything is written
    names = []
    for name in options.output:
        for view in views[:1] if Path(name).suffix.lower() in DATA else views:
            names.append(_numbered(name, view, views))
            result.save(names[-1], size=options.size, view=view)
    for view in views if options.direct else []:
        names.append(_numbered(options.direct, view, views))
        write_atomically(names[-1], result.beside_direct(options.size, view).save)
    for view in views if options.final_gather else []:
        names.append(_numbered(options.final_gather, view, views))
        with _bars() as (_, progress):
            sheet = result.final_gather(options.size, view, progress)
        write_atomically(names[-1], sheet.save)
    for view in views if options.steps else []:
        names.append(_numbered(options.steps, view, views))
        save_steps(result, names[-1], size=options.size, view=view)
    return names


@contextmanager
def _bars() -> Iterator[tuple[Any, Any]]:
    """Show progress bars on stderr; yields rich's object and a function that is a radiosity.progress.Progress."""
    from rich.console import Console
    from rich.progress import Progress

    stages: dict[str, Any] = {}
    with Progress(console=Console(stderr=True), transient=True) as bars:

        def progress(stage: str, done: int, of: int) -> None:
            if stage not in stages:
                stages[stage] = bars.add_task(stage, total=of)
            bars.update(stages[stage], completed=done, total=of)

        yield bars, progress


def _numbered(name: str, view: Any, views: list[Any]) -> str:
    """Return a file's name, with the camera's number if it is a picture and there are several."""
    path = Path(name)
    numbered = len(views) > 1 and path.suffix.lower() not in DATA
    return str(path.with_name(f"{path.stem}-{view}{path.suffix}")) if numbered else name


def _print(report: dict[str, Any]) -> None:
    """Print a report as a table."""
    from rich.table import Table

    from glsim.radiosity.result import summary

    table = Table(show_header=False, title=report["scene"], title_justify="left")
    for row in (*summary(report), ("wrote", ", ".join(report["outputs"]))):
        table.add_row(*row)
    console().print(table)
