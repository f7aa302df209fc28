"""Which file of a submission is graded, whatever it is called and however it is packed; and what is never opened."""

from __future__ import annotations

import os
import stat
import struct
import zipfile
from pathlib import Path

import pytest

from glsim.course.exercise import Exercise, exercise, exercises
from glsim.course.grading.contents import MOST_BYTES, shown
from glsim.course.grading.submissions import Chosen, Submission, choose, submissions

KNOWN = exercises()
LAMBERT, SNELL, GLSL = exercise("lambert"), exercise("snell"), exercise("33")
TEXT = b"def lambert(N, L): return 1\n"


def entry(*paths: Path) -> Submission:
    return Submission(paths[0].name, paths)


def zipped(path: Path, members: dict[str, bytes], method: int = zipfile.ZIP_DEFLATED) -> Path:
    with zipfile.ZipFile(path, "w", method) as archive:
        for name, data in members.items():
            archive.writestr(name, data)
    return path


def chosen(paths: Path | tuple[Path, ...], *wanted: Exercise) -> list[Chosen | str]:
    return choose(entry(*(paths if isinstance(paths, tuple) else (paths,))), wanted or (LAMBERT,), KNOWN)


def folder_of(path: Path, *names: str) -> Path:
    for name in names:
        (path / name).parent.mkdir(parents=True, exist_ok=True)
        (path / name).write_bytes(name.encode())
    return path


@pytest.mark.parametrize(
    ("names", "place"),
    [
        (["03_lambert.py"], "03_lambert.py"),
        (["lambert (1).py"], "lambert (1).py"),
        (["jdoe_123_456_03_lambert-2.py", "jdoe_123_457_05_snell.py"], "jdoe_123_456_03_lambert-2.py"),
        (["me_1_assignsubmission_file_/03_lambert.py", "x.txt"], "me_1_assignsubmission_file_/03_lambert.py"),
        (["03_Lambert.PY", "05_snell.py"], "03_Lambert.PY"),
        (["03_lambert_jdoe.py", "05_snell.py"], "03_lambert_jdoe.py"),
        (["whatever.py", "readme.txt"], "whatever.py"),
        (["whatever.py", "05_snell.py"], "whatever.py"),
        (["a/b/c/03_lambert.py", "__MACOSX/a/03_lambert.py", "._03_lambert.py"], "a/b/c/03_lambert.py"),
        (["-rf 03_lambert.py"], "-rf 03_lambert.py"),
    ],
)  # fmt: skip
def test_one_file_fits(names: list[str], place: str, tmp_path: Path) -> None:
    assert chosen(folder_of(tmp_path / "student", *names)) == [Chosen(place, place.encode())]
    archive = zipped(tmp_path / "a.zip", {name: name.encode() for name in names})
    assert chosen(archive) == [Chosen(f"a.zip/{place}", place.encode())]


@pytest.mark.parametrize(
    ("names", "place"),
    [
        (["03_lambert.py", "03_lambert (1).py", "03_lambert (2).py"], "03_lambert (2).py"),
        (["03_lambert-9.py", "03_lambert-10.py"], "03_lambert-10.py"),
        (["03_lambert_v2.py", "03_lambert.py"], "03_lambert_v2.py"),
        (["old/03_lambert.py", "03_lambert.py"], "03_lambert.py"),
        (["lambert.py", "03_lambert.py"], "03_lambert.py"),
    ],
)
def test_of_several_the_last_version_is_graded_and_that_is_said(names: list[str], place: str, tmp_path: Path) -> None:
    one = chosen(folder_of(tmp_path / "student", *names))[0]
    assert isinstance(one, Chosen)
    assert one.place == place
    assert one.note.startswith(f"{len(names)} files fit; {place} is graded, not ")


@pytest.mark.parametrize("names", [[], ["notes.txt"], ["a.py", "b.py"], ["05_snell.py"], ["03_lambert.glsl"]])
def test_no_file_fits(names: list[str], tmp_path: Path) -> None:
    (tmp_path / "student").mkdir()
    one = chosen(folder_of(tmp_path / "student", *names))[0]
    assert isinstance(one, str)
    assert one.startswith("there is no file 03_lambert.py")


def test_with_several_exercises_a_file_without_a_name_is_not_guessed(tmp_path: Path) -> None:
    path = folder_of(tmp_path / "student", "work.py", "05_snell.py", "33_blinn_in_glsl.glsl")
    assert chosen(path, LAMBERT, SNELL, GLSL) == [
        "there is no file 03_lambert.py",
        Chosen("05_snell.py", b"05_snell.py"),
        Chosen("33_blinn_in_glsl.glsl", b"33_blinn_in_glsl.glsl"),
    ]


def test_a_name_belongs_to_the_exercise_that_it_names_best(tmp_path: Path) -> None:
    """33_blinn_in_glsl and 07_blinn_highlight share a word; a file of one is never graded as the other."""
    names = [one.filename for one in KNOWN]
    path = folder_of(tmp_path / "student", *(f"jdoe_12_34_{name}" for name in names))
    assert [one.data.decode() for one in chosen(path, *KNOWN) if isinstance(one, Chosen)] == [
        f"jdoe_12_34_{name}" for name in names
    ]


def test_an_archive_in_a_folder_is_opened(tmp_path: Path) -> None:
    zipped(folder_of(tmp_path / "student", "readme.txt") / "abgabe.ZIP", {"x/03_lambert.py": TEXT})
    assert chosen(tmp_path / "student") == [Chosen("abgabe.ZIP/x/03_lambert.py", TEXT)]


# ---------------------------------------------------------------- what is not to be trusted


def test_names_that_point_outside_write_nothing(tmp_path: Path) -> None:
    inside = tmp_path / "in"
    inside.mkdir()
    archive = zipped(inside / "a.zip", {"../../03_lambert.py": TEXT, "/etc/x.py": b"", "..\\y.py": b""})
    before = sorted(tmp_path.rglob("*"))
    assert chosen(archive) == [Chosen("a.zip/../../03_lambert.py", TEXT)]
    assert sorted(tmp_path.rglob("*")) == before


def test_links_are_not_followed(tmp_path: Path) -> None:
    secret = tmp_path / "solution.py"
    secret.write_bytes(TEXT)
    student = folder_of(tmp_path / "student", "readme.txt")
    (student / "03_lambert.py").symlink_to(secret)
    (student / "folder").symlink_to(tmp_path)
    info = zipfile.ZipInfo("03_lambert.py")
    info.external_attr = (stat.S_IFLNK | 0o777) << 16
    with zipfile.ZipFile(tmp_path / "a.zip", "w") as archive:
        archive.writestr(info, "/etc/passwd")
    (tmp_path / "link").symlink_to(secret)
    for path in (student, tmp_path / "a.zip", tmp_path / "link"):
        assert "is a link, and links are not followed" in str(chosen(path)[0])


@pytest.mark.slow
def test_no_more_of_a_bomb_is_unpacked_than_a_file_may_have(tmp_path: Path) -> None:
    bomb = zipped(tmp_path / "a.zip", {"03_lambert.py": bytes(100 << 20)})
    data = bytearray(bomb.read_bytes())
    assert len(data) < 1 << 20
    assert chosen(bomb) == ["a.zip/03_lambert.py has more than 1 MiB"]
    at = data.rindex(b"PK\x01\x02") + 24
    data[at : at + 4] = struct.pack("<I", 10)  # the archive says that it has 10 bytes
    bomb.write_bytes(data)
    assert "a.zip/03_lambert.py is damaged" in str(chosen(bomb)[0])
    assert chosen(zipped(tmp_path / "x.zip", {"03_lambert.py": b"x"}, zipfile.ZIP_LZMA)) == [
        "x.zip/03_lambert.py is compressed in an unusual way; use the usual one, deflate"
    ]
    many = zipped(tmp_path / "many.zip", {f"{n}.txt": b"" for n in range(6000)})
    assert "has 6000 files" in str(chosen(many)[0])


def test_archives_that_cannot_be_read_get_a_sentence(tmp_path: Path) -> None:
    good = zipped(tmp_path / "a.zip", {"03_lambert.py": os.urandom(5000)}).read_bytes()
    broken = {
        "cut": good[:3000],
        "text": b"no archive",
        "empty": b"",
        "flipped": good[:200] + bytes([good[200] ^ 255]) + good[201:],
        "encrypted": good.replace(b"PK\x01\x02\x14\x03\x14\x00\x00\x00", b"PK\x01\x02\x14\x03\x14\x00\x01\x00"),
    }
    assert broken["encrypted"] != good
    for name, data in broken.items():
        path = tmp_path / f"{name}.zip"
        path.write_bytes(data)
        assert name in str(chosen(path)[0])
        assert not isinstance(chosen(path)[0], Chosen)
    assert "encrypted.zip/03_lambert.py is encrypted" in str(chosen(tmp_path / "encrypted.zip")[0])
    (tmp_path / "student.tar.gz").write_bytes(b"")
    assert "student.tar.gz: of archives only zip is opened" in str(chosen(tmp_path / "student.tar.gz")[0])


def test_folders_without_end(tmp_path: Path) -> None:
    """A file is found in some of them; a thousand are not walked through."""
    path = tmp_path / "student"
    path.mkdir()
    folder = path
    for _ in range(60):
        folder = folder / "a"
        folder.mkdir()
    (folder / "03_lambert.py").write_bytes(TEXT)
    assert chosen(path) == ["there is no file 03_lambert.py"]
    (path / "a" / "a" / "a" / "03_lambert.py").write_bytes(TEXT)
    assert chosen(path) == [Chosen("a/a/a/03_lambert.py", TEXT)]


def test_a_file_that_is_none_or_too_large(tmp_path: Path) -> None:
    (tmp_path / "student").mkdir()
    os.mkfifo(tmp_path / "student" / "03_lambert.py")
    assert "is no ordinary file" in str(chosen(tmp_path / "student")[0])
    large = folder_of(tmp_path / "other", "03_lambert.py")
    (large / "03_lambert.py").write_bytes(bytes(MOST_BYTES + 1))
    assert "more than 1 MiB" in str(chosen(large)[0])


# ---------------------------------------------------------------- the entries of a folder

NAMES = [
    "a b",
    "new\nline",
    "🦊👩\u200d🎓",
    "-j 9",
    "..hidden",
    "x" * 250,
    "ü",
    "=1+1",
    "<b>&\"'",
    "\u202eevil",
    "$(id)",
    "\x1b[31m",
]


def test_submissions_may_be_called_anything(tmp_path: Path) -> None:
    folder = os.fsencode(tmp_path / "all")
    os.mkdir(folder)
    for name in [*map(os.fsencode, NAMES), b"\xff\xfe"]:
        os.mkdir(os.path.join(folder, name))
    for junk in ("__MACOSX", ".DS_Store", "marks"):
        os.mkdir(os.path.join(folder, junk.encode()))
    found = submissions(tmp_path / "all", besides=tmp_path / "all" / "marks")
    assert {one.raw_name for one in found} == {*NAMES, os.fsdecode(b"\xff\xfe")}
    assert len({one.slug for one in found}) == len(found)
    for one in found:
        assert one.name.encode("utf-8").decode() == one.name
        assert "\n" not in one.name
        assert "\x1b" not in one.name
        assert len(one.slug) <= 70
        assert one.slug.replace("-", "").replace("_", "").isalnum()
        assert one.slug.isascii()
        assert not one.slug.startswith("-")


def test_files_of_one_student_as_canvas_names_them_are_one_submission(tmp_path: Path) -> None:
    path = folder_of(
        tmp_path / "all",
        "doejohn_81_900_03_lambert-2.py",
        "doejohn_81_901_05_snell.py",
        "eve_LATE_82_902_03_lambert.py",
        "hw_2024_1001_lambert.py",
        "hw_2024_1002_lambert.py",
    )
    found = submissions(path)
    assert [one.name for one in found] == [
        "doejohn_81",
        "eve_LATE_82_902_03_lambert.py",
        "hw_2024_1001_lambert.py",
        "hw_2024_1002_lambert.py",
    ]
    assert [one.place for one in choose(found[0], [LAMBERT, SNELL], KNOWN) if isinstance(one, Chosen)] == [
        "doejohn_81_900_03_lambert-2.py",
        "doejohn_81_901_05_snell.py",
    ]


def test_a_folder_without_submissions(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="contains no submissions"):
        submissions(tmp_path)
    with pytest.raises(FileNotFoundError):
        submissions(tmp_path / "none")


def test_shown_text_is_one_harmless_line() -> None:
    assert shown("a\x1b[2Jb\r\n\udcff\ud800é👩\u200d🎓") == "a\\x1b[2Jb\\r\\n\\udcff\\ud800é👩\u200d🎓"
