"""A question is answered once, whatever is made of its answer."""

from __future__ import annotations

import csv
import json
import pickle
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT

import epicyclic
from epicyclic import _call, _core

EXAMPLES = ROOT / "examples"


@pytest.fixture
def calls(monkeypatch: pytest.MonkeyPatch) -> list[list[str]]:
    """The words of every call that is made."""
    made: list[list[str]] = []

    def call(line: list[str], *rest: Any) -> Any:
        made.append(line)
        return _core.call(line, *rest)

    monkeypatch.setattr(_call, "_core", type("Counted", (), {"call": staticmethod(call)}))
    return made


QUESTIONS: dict[str, tuple[Any, ...]] = {
    "analyze": (epicyclic.analyze, "II-3", {"k1": 2.15, "k2": 2.354}),
    "a gear": (epicyclic.analyze, "II-3", {"k1": 2.15, "k2": 2.354, "gear": "2", "torque": "500 N·m"}),
    "compare": (epicyclic.compare, EXAMPLES / "simpson.yaml", {}),
    "select": (epicyclic.select, None, {"speeds": "0.8 m/s, 3.15 m/s", "limit": 3}),
    "select with teeth": (epicyclic.select, None, {"ratios": "3.94", "teeth": True, "limit": 4}),
    "synthesize": (epicyclic.synthesize, None, {"ratios": "3, 1, -2", "sets": 2, "elements": 4, "engaged": 2, "limit": 2}),
    "teeth": (epicyclic.teeth, None, {"ratio": 6, "planets": 4, "limit": 2}),
    "simulate": (epicyclic.simulate, EXAMPLES / "power-shift.yaml", {}),
    "motor": (epicyclic.motor, EXAMPLES / "motor-5x3.yaml", {}),
}


def asked(question: str, **more: Any) -> epicyclic.Answer:
    function, subject, options = QUESTIONS[question]
    words = [subject] if subject is not None else []
    words += [EXAMPLES / "ravigneaux.yaml"] if question == "compare" else []
    answer = function(*words, **options, **more)
    assert isinstance(answer, epicyclic.Answer)
    return answer


@pytest.mark.parametrize("end", ["json", "csv", "txt"])
@pytest.mark.parametrize("question", QUESTIONS)
def test_an_answer_that_is_written_to_a_file_is_the_same_and_asked_once(
    question: str, end: str, tmp_path: Path, calls: list[list[str]]
) -> None:
    file = tmp_path / f"answer.{end}"
    answer = asked(question, output=file)
    assert len(calls) == 1, calls
    assert answer == asked(question)
    text = file.read_text(encoding="utf-8")
    if end == "json":
        assert json.loads(text) == answer.to_dict()
    elif end == "csv":
        assert len(list(csv.reader(text.splitlines()))) > 1
    else:
        assert answer.text().split() == text.split()


@pytest.mark.parametrize(("question", "end"), [("compare", "html"), ("select", "html"), ("motor", "html"), ("simulate", "svg"), ("motor", "html")])
def test_a_page_or_a_drawing_of_an_answer_is_asked_once(question: str, end: str, tmp_path: Path, calls: list[list[str]]) -> None:
    file = tmp_path / f"answer.{end}"
    answer = asked(question, output=file)
    assert len(calls) == 1 and answer == asked(question)
    assert (b"<!DOCTYPE html>" if end == "html" else b"<svg") in file.read_bytes()[:200]


@pytest.mark.parametrize("file", ["scheme-ii-3.yaml", "power-shift.yaml", "motor-5x3.yaml"])
def test_a_page_is_made_once_with_the_record_of_the_command_line(file: str, calls: list[list[str]]) -> None:
    page = epicyclic.report(EXAMPLES / file)
    assert len(calls) == 1
    answer, _, _ = _call.run(["report", "--format=json", str(EXAMPLES / file)], {}, None)
    assert page.answer.to_dict() == json.loads(answer) and page.html.startswith("<!DOCTYPE html>")


def test_a_page_takes_the_options_of_pages() -> None:
    assert epicyclic.report(EXAMPLES / "scheme-ii-3.yaml", to_scale=True).answer.answer == "report"


def test_a_drawing_is_made_once_and_saved_as_it_is(tmp_path: Path, calls: list[list[str]]) -> None:
    drawing = epicyclic.draw("II-3", k1=2.15, k2=2.354)
    drawing.save(tmp_path / "drawing.svg")
    assert len(calls) == 1 and (tmp_path / "drawing.svg").read_text(encoding="utf-8") == drawing.svg


def test_a_refusal_is_the_same_with_a_file_and_nothing_is_written(tmp_path: Path) -> None:
    file = tmp_path / "answer.csv"
    for options in ({}, {"output": file}):
        with pytest.raises(epicyclic.Refused) as refused:
            epicyclic.analyze("II-3", k1=2.15, k2=2.354, gear="9", **options)
        error = refused.value
        assert (error.option, error.name) == ("--gear", "no-gear"), options
        with pytest.raises(epicyclic.Refused) as placed:
            box = epicyclic.Gearbox.from_yaml("gearbox: x\ninput: D\noutput: B\nsets: [{ id: 1 }]\n", file="x.yaml")
            box.analyze(**options)
        assert placed.value.place is not None and placed.value.place.line == 4
    assert not file.exists()


def test_a_refusal_has_all_faults_of_a_file() -> None:
    text = "gearbox: x\ninput: D\noutput: B\nsets: [{ id: 1, sun: D, ring: T, carrier: B, k: '3,5', modul: 4 mm }]\n"
    with pytest.raises(epicyclic.Refused) as refused:
        epicyclic.Gearbox.from_yaml(text, file="x.yaml").analyze()
    error = refused.value
    found = [(fault.name, fault.value, fault.remedy, fault.place and fault.place.path) for fault in error.faults]
    assert found == [
        ("wrong-type", "1", '"1"', "sets[0].id"),
        ("decimal-comma", "3,5", "3.5", "sets[0].k"),
        ("unknown-key", "modul", "module", "sets[0].modul"),
    ]
    assert pickle.loads(pickle.dumps(error)).faults == error.faults
    with pytest.raises(epicyclic.Refused) as option:
        epicyclic.analyze("II-3", k1=2.15, k2=2.354, gear="9")
    only = option.value
    assert only.faults == (epicyclic.Fault(only.name, only.message),)


def test_nothing_found_has_its_answer_with_a_file_too(tmp_path: Path) -> None:
    answers = []
    for options in ({}, {"output": tmp_path / "answer.csv"}):
        with pytest.raises(epicyclic.NothingFound) as nothing:
            epicyclic.select(speeds="0.8 m/s, 3.15 m/s", least_efficiency=0.9999, **options)
        answers.append(nothing.value.answer)
    assert answers[0] is not None and answers[0] == answers[1]
