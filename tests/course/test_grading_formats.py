"""Reports of marks conform to the formats of the platforms that read them, whatever students' names and texts hold."""

from __future__ import annotations

import base64
import copy
import csv
import io
import json
import subprocess
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import jsonschema
import pytest
from PIL import Image

from glsim.course.grading import classroom50, gradescope, junit, tables
from glsim.course.grading.contents import shown
from glsim.course.grading.record import Part, Record, Store, Total, totals

SCHEMAS = Path(__file__).parent / "schemas"
EVIL = shown('=1+1|<script>alert("1")</script>&amp;]]>\u202e\x00\x1b[31m\ud800 🦊')
ENVIRONMENT = {
    "CLASSROOM": "cg-2026",
    "ASSIGNMENT": "lambert",
    "ASSIGNMENT_TYPE": "group",
    "OWNER": "alice",
    "SUBMISSION_TAG": "submit/2026-06-01T14-32-05Z-a1b2c3d",
    "COMMIT_URL": "https://github.com/o/r/commit/a1",
    "RELEASE_URL": "https://github.com/o/r/releases/tag/x",
    "REVIEW_URL": "",
}


def png() -> str:
    buffer = io.BytesIO()
    Image.new("RGB", (8, 4), "red").save(buffer, "PNG")
    return base64.b64encode(buffer.getvalue()).decode()


def record(student: str, exercise: str = "03_lambert", **fields: Any) -> Record:
    parts = (Part("right", 2, 2), Part(EVIL, 0, 1, EVIL, png()), Part("no hint", 0, 2))
    return Record(student, f"s-{len(student)}", exercise, f"Title {EVIL}", parts, "x.py", **fields)


def all_totals() -> list[Total]:
    return totals(
        [
            record(EVIL, printed=f"a\n{EVIL}", isolation="bubblewrap", seconds=0.5),
            record(EVIL, "05_snell", note="there is no file 05_snell.py"),
            record("bob", failure="the process that judges ended unexpectedly"),
        ]
    )


def schema(name: str) -> Any:
    document = json.loads((SCHEMAS / f"{name}.json").read_text())
    jsonschema.Draft202012Validator.check_schema(document)
    return jsonschema.Draft202012Validator(document)


class Tags(HTMLParser):
    """The tags of HTML, and what it shows."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.text = ""
        self.feed(html)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))

    def handle_data(self, data: str) -> None:
        self.text += data


def test_gradescope() -> None:
    total = all_totals()[0]
    document = json.loads(json.dumps(gradescope.results(total)))
    schema("gradescope").validate(document)
    assert document["score"] == sum(test["score"] for test in document["tests"]) == 4
    assert sum(test["max_score"] for test in document["tests"]) == 10
    assert [test["number"] for test in document["tests"]] == ["3.1", "3.2", "3.3", "5.1", "5.2", "5.3"]
    assert [test["status"] for test in document["tests"]][:3] == ["passed", "failed", "failed"]
    html = Tags(document["tests"][1]["output"])
    assert {tag for tag, _ in html.tags} == {"p", "img", "pre"}
    assert EVIL in html.text
    picture = next(attributes["src"] for tag, attributes in html.tags if tag == "img")
    assert picture
    assert Image.open(io.BytesIO(base64.b64decode(picture.partition("base64,")[2]))).size == (8, 4)
    assert "there is no file" in document["tests"][5]["output"]


WRONG = [
    (("score",), "4"),
    (("tests", 0, "status"), "ok"),
    (("visibility",), "yes"),
    (("max_score",), 1),
    (("tests", 0, "x"), 1),
]


@pytest.mark.parametrize(("path", "value"), WRONG)
def test_the_schema_of_gradescope_refuses(path: tuple[Any, ...], value: Any) -> None:
    document = copy.deepcopy(gradescope.results(all_totals()[0]))
    at: Any = document
    for key in path[:-1]:
        at = at[key]
    at[path[-1]] = value
    with pytest.raises(jsonschema.ValidationError):
        schema("gradescope").validate(document)


@pytest.mark.parametrize("environment", [ENVIRONMENT, {}])
def test_classroom50(environment: dict[str, str]) -> None:
    total = all_totals()[0]
    document = json.loads(json.dumps(classroom50.result(total, environment, "2026-06-01T14:32:01Z")))
    schema("classroom50").validate(document)
    assert document["datetime"] == "2026-06-01T14:32:01Z"
    for mark in (document, *document["tests"]):
        assert type(mark["score"]) is int
        assert mark["score"] <= mark["max-score"]
    assert document["score"] == sum(test["score"] for test in document["tests"])
    assert [test["passed"] for test in document["tests"]][:3] == [True, False, False]
    if environment:
        assert (document["owner"], document["assignment_type"]) == ("alice", "group")
        assert document["review"] == environment["COMMIT_URL"], "an empty variable is none"
    wrong = {**document, "max-score": 1.5}
    with pytest.raises(jsonschema.ValidationError):
        schema("classroom50").validate(wrong)


def test_the_instant_is_the_commits(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert classroom50.submitted(ENVIRONMENT) > "2026", "no checkout: now"
    for name, value in {"COMMITTER": "", "AUTHOR": ""}.items():
        monkeypatch.setenv(f"GIT_{name}_NAME", "a" + value)
        monkeypatch.setenv(f"GIT_{name}_EMAIL", "a@b")
    monkeypatch.setenv("GIT_COMMITTER_DATE", "2025-03-01T23:30:00-0200")
    subprocess.run(["git", "init", "-q"], check=True)
    subprocess.run(["git", "commit", "-q", "--allow-empty", "-m", "x"], check=True)
    assert classroom50.submitted(ENVIRONMENT) == "2025-03-02T01:30:00Z"
    assert classroom50.submitted({}) > "2026", "outside of the runner git does not run in a student's folder"


@pytest.mark.slow
def test_junit() -> None:
    xmlschema = pytest.importorskip("xmlschema")
    xml = junit.document(all_totals()).decode()
    validator = xmlschema.XMLSchema11(SCHEMAS / "junit.xsd")
    validator.validate(xml)
    root = ElementTree.fromstring(xml)
    assert [root.get(name) for name in ("tests", "failures", "errors")] == ["9", "4", "3"]
    assert len(root.findall(".//failure")) == 4
    assert len(root.findall(".//error")) == 3
    assert root[0].get("name") == EVIL
    assert root.findall(".//failure")[0].get("message") == EVIL
    assert [p.get("value") for p in root.iter("property")][:3] == ["4", "10", "bubblewrap"]
    for old, new in ((' tests="9"', ""), ("testcase", "test"), ("failure", "failed"), (' time="', ' time="x')):
        assert not validator.is_valid(xml.replace(old, new))


def test_csv_and_json(tmp_path: Path) -> None:
    graded = all_totals()
    rows = list(csv.reader(io.StringIO(tables.write_csv(tmp_path, graded).read_text(encoding="utf-8"))))
    assert rows[0] == ["submission", "03_lambert", "05_snell", "points", "of", "first hint"]
    assert rows[1][0] == "'" + EVIL, "a spreadsheet would take it for a formula"
    assert rows[1][1:5] == ["2", "2", "4", "10"]
    assert rows[2][:4] == ["bob", "", "", ""], "without a mark there is no sum"
    document = json.loads(tables.write_json(tmp_path, graded).read_text(encoding="utf-8"))
    assert document["submissions"][0]["submission"] == EVIL
    assert document["submissions"][1]["marks"][0]["points"] is None
    assert document["submissions"][0]["marks"][0]["parts"][0] == {"about": "right", "points": 2, "of": 2, "hint": ""}


def test_a_record_is_read_as_it_was_written(tmp_path: Path) -> None:
    store = Store(tmp_path / "records")
    one = record(EVIL, printed=EVIL, key="k")
    store.write(one)
    assert store.read(one.slug, one.exercise) == one
    assert store.read(one.slug, "05_snell") is None
    for damaged in ("", "{", "[]", "{}", '{"parts": 3}'):
        next(store.folder.iterdir()).write_text(damaged)
        assert store.read(one.slug, one.exercise) is None
