"""Gearboxes built in Python and read from files, and what is refused of them."""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import ROOT

import epicyclic
from epicyclic import Description, Gearbox

REAL = ROOT / "examples" / "real-transmissions.yaml"


def conveyor(**changes: Any) -> Gearbox:
    described: dict[str, Any] = {
        "input": "D",
        "output": "B",
        "sets": [{"id": "P", "sun": "D", "ring": "T1", "carrier": "B", "k": 2.94, "efficiency": 0.97}],
        "brakes": {"K1": "T1"},
        "clutches": {"K2": ("D", "B")},
        "gears": {"slow": ["K1"], "fast": ["K2"]},
    }
    return Gearbox("conveyor", **{**described, **changes})


def test_a_gearbox_is_built_in_python() -> None:
    slow = conveyor().analyze().gears["slow"]
    assert slow.ratio == pytest.approx(3.94, rel=1e-15)
    assert slow.efficiency == pytest.approx((1 + 0.97 * 2.94) / 3.94, rel=1e-15)
    assert conveyor().analyze(gear="slow", torque="500 N·m", speed="1475 rpm").operating_point.torque_n_m == 500.0


def test_a_built_gearbox_is_that_of_its_file(tmp_path: Path) -> None:
    file = tmp_path / "conveyor.yaml"
    conveyor().save(file)
    assert Gearbox.read(file).analyze() == conveyor().analyze()
    assert epicyclic.analyze(file) == conveyor().analyze()
    assert Gearbox.from_yaml(conveyor().yaml).analyze() == conveyor().analyze()


def test_numbers_of_numpy_describe_a_gearbox() -> None:
    teeth = np.array([18, 72])
    sets = [{"id": "P", "sun": "D", "ring": "T1", "carrier": "B", "teeth": teeth, "efficiency": np.float64(0.97)}]
    exact = conveyor(sets=sets).analyze().gears["slow"].exact_ratio
    assert (exact.numerator, exact.denominator) == (5, 1)


def test_other_keys_of_a_file_are_taken() -> None:
    drag = {"speeds": ["0 rpm", "500 rpm"], "torques": ["1 N·m", "2 N·m"], "beyond": "constant"}
    box = conveyor(
        sets=[{"id": "P", "sun": "D", "ring": "T1", "carrier": "B", "k": 2.94}],
        brakes=[{"id": "K1", "link": "T1", "drag": drag}],
        clutches={"K2": {"one_way": ("D", "B")}},
        gears={"slow": {"engaged": ["K1"], "output": "B"}},
        density="7800 kg/m3",
        note="a remark",
    )
    assert box.analyze().shift_elements["K2"].kind == "one_way_clutch"
    assert box.losses(speed="500 rpm", torque="10 N·m") is not None


def test_a_transmission_of_a_list_is_chosen() -> None:
    box = Gearbox.read(REAL, transmission="8HP", efficiency=0.97)
    gears = box.analyze().gears
    exact = gears["5"].exact_ratio
    assert (exact.numerator, exact.denominator) == (1171, 911)
    assert gears["1"].efficiency < 1
    assert box.sweep({"P1": 2.0}).gears[:2] == ["1", "2"]


def test_a_gearbox_draws_itself() -> None:
    svg = conveyor()._repr_svg_()
    assert svg is not None and svg.startswith("<svg") and "</svg>" in svg
    drawing = conveyor().draw(gear="slow", power=True)
    assert drawing._repr_svg_().startswith("<svg") and drawing.svg != svg


def test_a_drawing_is_saved_by_the_end_of_its_name(tmp_path: Path) -> None:
    drawing = conveyor().draw()
    for name, start in [("a.svg", b"<svg"), ("a.pdf", b"%PDF"), ("a.png", b"\x89PNG"), ("a.dxf", b"999\n")]:
        drawing.save(tmp_path / name)
        assert (tmp_path / name).read_bytes().lstrip(b" \n").startswith(start.lstrip(b" \n"))
    with pytest.raises(epicyclic.Refused):
        drawing.save(tmp_path / "a.bmp")
    assert not (tmp_path / "a.bmp").exists()


def test_a_gearbox_that_crosses_itself_has_no_picture_and_says_why() -> None:
    box = Gearbox.read(ROOT / "examples" / "self-crossing.yaml")
    assert box._repr_svg_() is None
    with pytest.raises(epicyclic.NothingFound, match="crosses itself"):
        box.draw()


def test_a_fault_of_a_file_has_its_place() -> None:
    with pytest.raises(epicyclic.Refused) as refused:
        Gearbox.from_yaml("gearbox: x\ninput: D\noutput: B\nsets:\n  - id: P\n    sun: D\n    rnig: T\n", file="x.yaml").analyze()
    place = refused.value.place
    assert place is not None and (place.file, place.line) == ("x.yaml", 7)
    assert "rnig" in str(refused.value)


@pytest.mark.parametrize(
    ("changes", "name", "path"),
    [
        ({"sets": [{"id": "P", "sun": "D", "ring": "T1", "carrier": "B", "k": 0.5}]}, "ring-to-sun-ratio", "sets[0]"),
        ({"gears": {"slow": ["K3"]}}, "unknown", "gears[0]"),
        ({"efficiency": 2}, "unknown-key", ""),
    ],
)
def test_a_fault_of_a_built_gearbox_has_its_place(changes: Any, name: str, path: str) -> None:
    with pytest.raises(epicyclic.Refused) as refused:
        conveyor(**changes).analyze()
    assert refused.value.name == name, refused.value
    place = refused.value.place
    assert place is not None and place.path.startswith(path)
    assert place.file == "conveyor (built in Python)"


def test_nan_is_no_number_of_a_gearbox() -> None:
    sets = [{"id": "P", "sun": "D", "ring": "T1", "carrier": "B", "k": float("nan")}]
    with pytest.raises(epicyclic.Refused):
        conveyor(sets=sets).analyze()


def test_an_error_names_the_option_and_is_pickled() -> None:
    with pytest.raises(epicyclic.Refused) as refused:
        conveyor().analyze(gear="slwo")
    again = pickle.loads(pickle.dumps(refused.value))
    assert (str(again), again.name, again.option, again.place) == (
        str(refused.value),
        refused.value.name,
        refused.value.option,
        refused.value.place,
    )
    assert isinstance(again, ValueError) and isinstance(again, epicyclic.Refused)


def test_a_bare_number_where_a_unit_is_due_is_refused_with_the_unit() -> None:
    with pytest.raises(epicyclic.Refused, match="write 500 N·m") as refused:
        conveyor().analyze(gear="slow", torque=500)
    assert refused.value.option == "--torque"


def test_nothing_found_and_a_file_that_is_not_there_are_errors_of_their_kind(tmp_path: Path) -> None:
    with pytest.raises(epicyclic.NothingFound) as nothing:
        epicyclic.teeth(ratio=20)
    assert nothing.value.exit_code == 1 and isinstance(nothing.value, LookupError)
    missing = tmp_path / "no.yaml"
    with pytest.raises(epicyclic.FileFailure, match="cannot be read") as failure:
        epicyclic.analyze(missing)
    assert isinstance(failure.value, OSError) and failure.value.exit_code == 3
    with pytest.raises(epicyclic.FileFailure) as read:
        Gearbox.read(missing)
    assert (read.value.name, str(read.value)) == (failure.value.name, str(failure.value))


def test_words_that_look_like_options_are_values() -> None:
    assert epicyclic.teeth(ratio=-4, mode="ab^H", limit=1).tooth_numbers[0].exact_ratio.numerator == -4
    assert epicyclic.schemes("III-1", ratio1=-2.56, ratio2=-1.465).answer == "scheme"


def test_several_gearboxes_are_compared() -> None:
    built = conveyor()
    answer = epicyclic.compare(built, Gearbox.read(ROOT / "examples" / "scheme-ii-3.yaml"))
    assert answer.answer == "compare" and len(answer.gearboxes) == 2


def test_a_page_is_written_where_it_is_wanted(tmp_path: Path) -> None:
    page = tmp_path / "box.html"
    made = conveyor().report(power="75 kW", speed="1475 rpm")
    made.save(page)
    assert "<iframe srcdoc=" in made._repr_html_() and "<script" not in made.html
    assert page.read_text(encoding="utf-8").startswith("<!DOCTYPE html>")


def test_a_schema_is_that_of_the_answers() -> None:
    import json

    assert "gears" in json.loads(epicyclic.schema("answer-analyze"))["properties"]


def test_an_answer_is_written_to_a_file_too(tmp_path: Path) -> None:
    import json

    for name in ("a.json", "a.csv", "a.txt"):
        answer = conveyor().analyze(output=tmp_path / name)
        text = (tmp_path / name).read_text(encoding="utf-8")
        assert answer.gearbox == "conveyor" and text, name
        if name == "a.json":
            assert json.loads(text) == answer.to_dict()
    with pytest.raises(epicyclic.Refused, match="svg"):
        conveyor().analyze(output=tmp_path / "a.svg")


def run_up(**changes: Any) -> Description:
    described: dict[str, Any] = {
        "scenario": "run up",
        "gearbox_file": conveyor(),
        "inertias": {"B": "16 kg·m²"},
        "engaged": ["K1"],
        "duration": "1 s",
        "torques": [{"id": "motor", "link": "D", "constant": "10 N·m"}],
    }
    return Description(**{**described, **changes})


def test_a_scenario_is_built_in_python() -> None:
    # Without losses the motor turns 16 kg·m² through 3.94.
    box = conveyor(sets=[{"id": "P", "sun": "D", "ring": "T1", "carrier": "B", "k": 2.94}])
    motion = epicyclic.simulate(run_up(gearbox_file=box))
    assert motion.end["B"].speed_rad_s == pytest.approx(10.0 * 3.94 / 16.0, rel=1e-9)


def test_a_built_scenario_is_that_of_its_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    conveyor().save("conveyor.yaml")
    scenario = run_up(gearbox_file="conveyor.yaml")
    scenario.save("run-up.yaml")
    of_file = epicyclic.simulate("run-up.yaml")
    assert of_file == epicyclic.simulate(scenario) == epicyclic.simulate(run_up())
    assert Description.read("run-up.yaml").yaml == scenario.yaml
    assert epicyclic.simulate(Description.from_yaml(scenario.yaml)) == of_file


def test_a_scenario_takes_what_its_gearbox_was_read_with() -> None:
    automatic = Gearbox.read(REAL, transmission="8HP", efficiency=0.97)
    keys: dict[str, Any] = {"inertias": {"n_in": "0.2 kg·m²", "n_out": "15 kg·m²"}, "engaged": ["A", "B", "C"]}
    torques = [{"id": "engine", "link": "n_in", "constant": "100 N·m"}]

    def yaml_of(**changes: Any) -> str:
        return run_up(gearbox_file=automatic, **{**keys, "torques": torques, **changes}).yaml

    assert 'transmission: "8HP"' in yaml_of() and "efficiency: 0.97" in yaml_of()
    assert "efficiency: 0.99" in yaml_of(efficiency=0.99) and "0.97" not in yaml_of(efficiency=0.99)
    motion = epicyclic.simulate(run_up(gearbox_file=automatic, **{**keys, "torques": torques}))
    assert motion.gearbox.startswith("ZF 8HP") and motion.energies.mesh_loss_j > 0.0


def test_what_is_wrong_in_a_built_scenario_has_its_place() -> None:
    with pytest.raises(epicyclic.Refused) as refused:
        epicyclic.simulate(run_up(engaged=["K9"]))
    assert refused.value.place is not None and refused.value.place.file == "run up (built in Python)"
    with pytest.raises(epicyclic.Refused):
        epicyclic.simulate(run_up(names="no key"))


def test_a_drive_and_a_hydromotor_are_built_in_python() -> None:
    drive = Description(
        title="a/b",
        power="100 kW",
        speed="1950 rpm",
        ratio=6,
        gear_set={"module": "8 mm", "face_width": "60 mm"},
        shafts={"allowable_stress": "20 MPa"},
    )
    assert epicyclic.drive(drive).title == "a/b"
    numbers: dict[str, Any] = {"stator": 5, "rotor": 3, "z3": 55, "zs": 10, "module": "2 mm", "l": "80 mm"}
    load = {"width": "40 mm", "pressure": "20 MPa", "speed": "100 rpm"}
    motor = Description(**numbers, **load)
    assert "<svg" in epicyclic.draw(motor).svg
    by_options = epicyclic.motor(**numbers, **load)
    assert epicyclic.motor(motor) == by_options != epicyclic.motor(motor, angle="30 deg")
