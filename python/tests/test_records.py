"""Answers as objects and tables."""

from __future__ import annotations

import json
import pickle
from typing import Any

import pytest

import epicyclic
from epicyclic import Answer, Record, Records


@pytest.fixture(scope="module")
def answer() -> Answer:
    return epicyclic.analyze("II-3", k1=2.15, k2=2.354)


def test_keys_are_attributes_and_records_found_by_name(answer: Answer) -> None:
    assert answer.gearbox == answer["gearbox"] == "II-3"
    assert isinstance(answer.gears, Records) and isinstance(answer.gears["2"], Record)
    assert answer.gears["2"] == answer.gears[1]
    assert answer.gears["2"].shift_elements["K2"].engaged is True
    assert answer.shifts[0].from_ == answer.shifts[0]["from"]
    assert "gears" in dir(answer) and "from_" in dir(answer.shifts[0])


def test_a_wrong_key_says_which_there_are(answer: Answer) -> None:
    with pytest.raises(AttributeError, match="there are .*gears"):
        answer.gaers
    with pytest.raises(KeyError, match="there are 1, 2, direct"):
        answer.gears["3"]
    with pytest.raises(KeyError, match="gears.shift_elements"):
        answer.table("gaers")


def test_an_answer_does_not_change(answer: Answer) -> None:
    with pytest.raises(AttributeError):
        answer.gearbox = "other"
    with pytest.raises(TypeError):
        answer["gearbox"] = "other"  # type: ignore[index]


def test_an_answer_is_its_json(answer: Answer) -> None:
    again = json.loads(json.dumps(answer.to_dict()))
    assert Answer(again) == answer
    assert pickle.loads(pickle.dumps(answer)) == answer


def test_tables_have_flat_rows_with_the_same_keys(answer: Answer) -> None:
    for name in answer.tables():
        rows = answer.table(name)
        assert rows
        keys = [list(row) for row in rows]
        assert all(one == keys[0] for one in keys)
        for row in rows:
            assert not any(isinstance(value, dict) for value in row.values())
    assert answer.table("one_way_clutches") == []
    inner = answer.table("gears.shift_elements")
    assert {row["gear"] for row in inner} == {"1", "2", "direct"} and len(inner) == 9
    assert any(key.startswith("largest_torque_") for key in answer.table("shift_elements")[0])


def test_pandas_and_polars_take_tables(answer: Answer) -> None:
    pandas = pytest.importorskip("pandas")
    polars = pytest.importorskip("polars")
    for name in ("gears", "gears.shift_elements", "sets", "shifts"):
        rows = answer.table(name)
        frame, other = pandas.DataFrame(rows), polars.DataFrame(rows)
        assert len(frame) == len(other) == len(rows)
    gears = polars.DataFrame(answer.table("gears"))
    assert gears["ratio"].dtype == polars.Float64 and gears["ratio"][1] == answer.gears["2"].ratio
    assert pandas.DataFrame(answer.table("gears"))["ratio"][1] == answer.gears["2"].ratio


def test_samples_over_time_are_columns(in_root: Any) -> None:
    run = epicyclic.simulate("examples/power-shift.yaml")
    rows = run.table("samples")
    assert len(rows) == len(run.samples.times_s)
    assert rows[3]["times_s"] == run.samples.times_s[3]
    link = run.samples.links[0]
    assert rows[3][f"links.{link.link}.speeds_rad_s"] == link.speeds_rad_s[3]


def test_a_notebook_shows_tables(answer: Answer) -> None:
    shown = answer._repr_html_()
    assert "<h4>gears</h4>" in shown and "nan" not in shown.lower().replace("nance", "")
    assert "<td>II-3</td>" in shown
    assert answer.gears._repr_html_().count("<tr>") == 4


def test_fractions_are_shown_as_people_write_them() -> None:
    shown = epicyclic.teeth(ratio=4.3, planets=4, limit=3).tooth_numbers._repr_html_()
    assert "<td>43/10</td>" in shown and "numerator" not in shown


def test_what_is_shown_is_escaped() -> None:
    assert "<script>" not in Record({"name": "<script>"})._repr_html_()


def test_the_text_is_that_of_the_command_line(answer: Answer) -> None:
    assert "Gears" in answer.text()


def test_warnings_are_in_the_answer(answer: Answer) -> None:
    assert all(isinstance(one.message, str) for one in answer.warnings)


def test_a_name_as_the_attribute_of_a_list_tells_how_to_take_it() -> None:
    gears = epicyclic.analyze("II-3", k1=2.15, k2=2.354).gears
    with pytest.raises(AttributeError, match=r"'slow': its records are \[0\] or \['1'\] and so on"):
        _ = gears.slow


def test_a_name_that_several_records_have_is_refused_with_their_places() -> None:
    rows = Records([{"gear": "1", "set": "a"}, {"gear": "2", "set": "a"}, {"gear": "1", "set": "b"}])
    assert rows["2"] == rows[1]
    with pytest.raises(KeyError, match=r"'1' is the name of several records: take one by its place, \[0\] or \[2\]"):
        rows["1"]


def test_the_name_is_the_first_key_and_no_other() -> None:
    # The first text of a record may be anything: here a note of one record that reads like the number of another.
    rows = Records([{"mode": 2, "note": "1"}, {"mode": 1, "note": None}])
    for key in ("1", "2"):
        with pytest.raises(KeyError, match="no names, only places from 0 to 1"):
            rows[key]
    with pytest.raises(AttributeError, match=r"its records are \[0\] and so on"):
        rows.note
    half = Records([{"gear": "1"}, {"gear": None}])
    with pytest.raises(KeyError, match="no names"):
        half["1"]
    assert rows[-1].mode == 1 and [row.mode for row in rows[:1]] == [2]
