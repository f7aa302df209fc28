"""Marks as JUnit XML, as Jenkins, GitLab and others read it: a suite for each submission, a case for each part."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from xml.etree import ElementTree

from glsim.course.grading.record import Part, Record, Total
from glsim.files import write_bytes


def write(folder: Path, totals: Sequence[Total]) -> Path:
    """Write junit.xml into a folder."""
    path = folder / "junit.xml"
    write_bytes(path, document(totals))
    return path


def document(totals: Sequence[Total]) -> bytes:
    """The XML: a part that is wrong is a failure; one that could not be graded is an error."""
    root = ElementTree.Element("testsuites", name="glsim grade")
    for total in totals:
        suite = ElementTree.SubElement(root, "testsuite", name=total.submission)
        _count(suite, total.records)
        properties = ElementTree.SubElement(suite, "properties")
        for name, value in (("points", total.points), ("of", total.most)):
            ElementTree.SubElement(properties, "property", name=name, value=str(value))
        for record in total.records:
            ElementTree.SubElement(
                properties, "property", name=f"isolation of {record.exercise}", value=record.isolation or "not run"
            )
            for part in record.parts:
                _case(suite, record, part)
    _count(root, [record for total in totals for record in total.records])
    ElementTree.indent(root)
    return bytes(ElementTree.tostring(root, encoding="utf-8", xml_declaration=True)) + b"\n"


def _count(element: ElementTree.Element, records: Sequence[Record]) -> None:
    cases = [(record, part) for record in records for part in record.parts]
    errors = sum(bool(record.failure) for record, _ in cases)
    wrong = sum(not part.right and not record.failure for record, part in cases)
    seconds = sum(record.seconds for record in records)
    for name, value in (("tests", len(cases)), ("failures", wrong), ("errors", errors), ("time", f"{seconds:.3f}")):
        element.set(name, str(value))


def _case(suite: ElementTree.Element, record: Record, part: Part) -> None:
    seconds = f"{record.seconds / len(record.parts):.3f}"
    case = ElementTree.SubElement(suite, "testcase", classname=record.exercise, name=part.about, time=seconds)
    if record.failure:
        ElementTree.SubElement(case, "error", type="not graded", message=record.failure)
    elif not part.right:
        lost = f"{part.points} of {part.most} points"
        ElementTree.SubElement(case, "failure", type="wrong", message=part.hint or record.note).text = lost
    if record.printed and not part.right:
        ElementTree.SubElement(case, "system-out").text = record.printed
