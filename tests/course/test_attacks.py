"""Hostile files in each isolation: ISOLATION.md says what is contained; others are judged as usual meanwhile."""

from __future__ import annotations

import json
import os
import re
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from pathlib import Path

import pytest
from PIL import Image

import glsim
from glsim.course import isolation as isolations
from glsim.course.answering import answered
from glsim.course.asking import request_for
from glsim.course.checking import Result, check
from glsim.course.exercise import Exercise, exercises, read
from glsim.course.isolation import Isolation, best, works
from glsim.course.isolation.bubblewrap import Bubblewrap
from glsim.course.isolation.landlock import abi
from glsim.course.isolation.limits import Landlock, Limits
from tests.course.attacks import ATTACKS, DRAWN, FORGERIES, PROBE, Attack
from tests.course.grading import solution_of

pytestmark = [pytest.mark.slow, pytest.mark.skipif(sys.platform != "linux", reason="isolation is for Linux")]
ONE = exercises()[0]
RIGHT = 3  # right files among the attacks
PROBED = {*re.findall(r'attempt\("(.+?)",', PROBE), "being root"}
ALL = {**ATTACKS, **FORGERIES, **DRAWN}
WAYS: tuple[Isolation, ...] = (Bubblewrap(), Landlock(), Limits())
EXERCISE = """\
"A picture"
from glsim.course.exercise import Definition, Picture
EXERCISE = Definition("picture", 1, "", [Picture("the picture", "picture.png", "differs")], program=True)
"""


@cache
def contained(name: str) -> dict[str, bool]:
    """What the table says of an isolation, for the user who runs the tests: attack -> whether it is contained."""
    text = Path(isolations.__file__).parents[1].joinpath("ISOLATION.md").read_text(encoding="utf-8")
    rows = [[cell.strip() for cell in line.strip("| ").split("|")] for line in text.splitlines() if line[:1] == "|"]
    column = rows[0].index(name)
    words = {"yes": True, "no": False, "for root": os.geteuid() == 0}
    return {row[0]: words[row[column]] for row in rows[2:]}


@pytest.fixture(scope="module", params=WAYS, ids=lambda way: way.name)
def way(request: pytest.FixtureRequest) -> Isolation:
    isolation: Isolation = request.param
    if not works(isolation) or (isolation.name == "Landlock" and abi() < 6):
        pytest.skip(f"{isolation.name} does not work here")
    return isolation


@pytest.fixture(scope="module")
def drawing(tmp_path_factory: pytest.TempPathFactory) -> Exercise:
    folder = tmp_path_factory.mktemp("exercise")
    (folder / "01_picture.py").write_text(EXERCISE)
    Image.new("RGB", (32, 32), (255, 128, 0)).save(folder / "picture.png")
    return read(folder / "01_picture.py")


@pytest.fixture(scope="module")
def results(way: Isolation, drawing: Exercise, tmp_path_factory: pytest.TempPathFactory) -> Iterator[dict[str, Result]]:
    """The results of all attacks, which run at the same time as right files (their names begin with "right")."""
    folder = tmp_path_factory.mktemp("attacks")
    secret = folder / "secret"
    good = folder / "good.py"
    good.write_text(solution_of(ONE))
    secret.write_text(json.dumps(answered(request_for(ONE, good, folder))))
    daemon = f"glsim-daemon-{os.getpid()}-{time.time_ns()}"
    attacks = ALL if way.name == best().name else dict(ATTACKS)
    if not contained(way.name)["killing all it can"]:
        attacks = {name: attacks[name] for name in attacks if name != "killing all it can"}  # it would kill the tests
    jobs = list(attacks)
    for k in range(RIGHT):
        jobs.insert(4 * k + 1, f"right {k}")

    def result(name: str) -> Result:
        attack = attacks.get(name, Attack("RIGHT"))
        path = folder / f"{jobs.index(name)}.py"
        text = attack.text.replace("RIGHT", solution_of(ONE)).replace("SECRET", str(secret)).replace("DAEMON", daemon)
        text = text.replace("PARTS", ", ".join(['{"value": [1.0]}'] * len(ONE.definition.parts)))
        path.write_text(text, encoding="utf-8", errors="surrogateescape")
        return check(drawing if name in DRAWN else ONE, path, way, attack.seconds)

    with ThreadPoolExecutor(3) as pool:
        yield dict(zip(jobs, pool.map(result, jobs), strict=True))
    processes = subprocess.run(["ps", "-eo", "args"], capture_output=True, text=True, check=True).stdout
    assert daemon not in processes
    assert not list(folder.glob("secret-*")), "something was unpickled"


@pytest.mark.parametrize("name", ALL)
def test_an_attack_gets_an_honest_mark(name: str, way: Isolation, results: dict[str, Result]) -> None:
    if name not in results:
        pytest.skip("the same in the best isolation, or not contained and not to be tried")
    result, attack = results[name], ALL[name]
    assert result.isolation == way.name
    if attack.hint and contained(way.name)[name]:
        assert result.points == 0
        assert result.first_failure is not None
        assert attack.hint in result.first_failure.hint
    else:  # the attack did not disturb its own marks
        assert (result.points, result.note) == (ONE.points, "")
    assert len(result.printed) <= 500


def test_right_files_at_the_same_time_get_all_points(results: dict[str, Result]) -> None:
    found = [(results[f"right {k}"].points, results[f"right {k}"].note) for k in range(RIGHT)]
    assert found == [(ONE.points, "")] * RIGHT


def test_only_what_the_table_says_is_reached(way: Isolation, tmp_path: Path) -> None:
    """Files, network and processes outside."""
    folder, home, secret = tmp_path / "run", tmp_path / "home", tmp_path / "secret"
    for path in (folder / "work", folder / "out"):
        path.mkdir(parents=True)
    for path in (home, secret):
        path.write_text("the teacher's")
        path.chmod(0o600)
    (folder / "work" / "probe.py").write_text(PROBE)
    result = folder / "out" / "result"
    facts = {"home": str(home), "secret": str(secret), "package": glsim.__file__, "pid": os.getpid(),
             "folder": str(folder / "out"), "result": str(result), "abstract": f"\0glsim-{os.getpid()}"}  # fmt: skip
    with (
        socket.create_server(("127.0.0.1", 0)) as tcp,
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as udp,
        socket.socket(socket.AF_UNIX) as abstract,
    ):
        udp.bind(("127.0.0.1", 0))
        udp.setblocking(False)
        abstract.bind(facts["abstract"])
        abstract.listen()
        facts.update(tcp=tcp.getsockname()[1], udp=udp.getsockname()[1])
        command = [sys.executable, str(folder / "work" / "probe.py"), json.dumps(facts)]
        assert way.run(command, folder, 20.0) == ""
        reached = set(json.loads(result.read_text()))
        try:
            udp.recv(1)
        except BlockingIOError:
            reached.discard("UDP")  # sent into a network of its own
    table = contained(way.name)
    expected = {name for name in PROBED if not table[name]}
    if not os.access(glsim.__file__, os.W_OK):  # glsim belongs to another user
        expected.discard("writing glsim's files")
    assert reached == expected


def test_a_timeout_keeps_what_was_written(way: Isolation, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    """And nothing comes to the terminal."""
    for name in ("work", "out"):
        (tmp_path / name).mkdir()
    written = tmp_path / "out" / "written"
    program = f"import sys\nopen({str(written)!r}, 'w').write('begun')\nsys.stderr.write('noise')\nwhile True: print(1)"
    assert way.run([sys.executable, "-c", program], tmp_path, 0.8).startswith("stopped after 0.8 seconds")
    assert written.read_text() == "begun"
    assert capfd.readouterr() == ("", "")


def test_the_table_has_all_attacks() -> None:
    assert set(contained("bubblewrap")) == {*ALL, *PROBED}


def test_the_best_that_works_is_taken() -> None:
    assert best() is best()
    assert best().name == next(way.name for way in WAYS if works(way))
