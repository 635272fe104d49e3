"""Sweeps: one call over arrays is many calls over numbers."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from conftest import ROOT

import epicyclic
from epicyclic import STATES, Gearbox


def two_sets(k1: float = 2.15, k2: float = 2.354, efficiency: float = 0.97) -> Gearbox:
    return Gearbox(
        "II-3",
        input="D",
        output="B",
        sets=[
            {"id": "1", "sun": "T1", "ring": "D", "carrier": "B", "k": k1, "efficiency": efficiency},
            {"id": "2", "sun": "T1", "ring": "B", "carrier": "T2", "k": k2, "efficiency": efficiency},
        ],
        brakes={"K1": "T1", "K2": "T2"},
        clutches={"L": ("D", "B")},
        gears={"1": ["K1"], "2": ["K2"], "direct": ["L"], "neutral": []},
    )


def test_a_grid_is_every_analysis_of_it() -> None:
    k1, k2 = np.linspace(1.4, 4.0, 5), np.linspace(1.2, 3.0, 4)
    found = two_sets().sweep({"1": k1[:, None], "2": k2})
    assert found.ratio.shape == found.efficiency.shape == found.state.shape == (5, 4, 4)
    assert found.gears == ["1", "2", "direct", "neutral"]
    for i, one in enumerate(k1):
        for j, other in enumerate(k2):
            gears = two_sets(float(one), float(other)).analyze().gears
            for place, gear in enumerate(gears):
                assert STATES[found.state[i, j, place]].replace(" ", "_").replace("-", "_") == gear.state
                for mine, its in [(found.ratio, gear.ratio), (found.efficiency, gear.efficiency)]:
                    if its is None:
                        assert mine.mask[i, j, place]
                    else:
                        assert mine[i, j, place] == pytest.approx(its, rel=1e-12)


def test_what_does_not_exist_is_masked_and_never_nan() -> None:
    found = two_sets().sweep({"1": np.full(3, 2.0)})
    neutral = found.gear("neutral")
    assert found.ratio.mask[:, neutral].all() and not found.ratio.mask[:, :neutral].any()
    assert not np.isnan(found.ratio.data).any() and not np.isnan(found.efficiency.data).any()
    assert (found.states[:, neutral] == "underdetermined").all()
    assert found.driven[:, :3].all() and not found.driven[:, 3].any()


def test_gears_are_chosen_and_scalars_are_one_variant() -> None:
    found = two_sets().sweep({"2": 3.0}, gears=["2"])
    assert found.ratio.shape == (1,) and found.ratio[0] == pytest.approx((1 + 2.15 + 3.0) / 2.15)
    assert two_sets().sweep({}).ratio.shape == (4,)


def test_tables_of_sweeps_go_into_frames() -> None:
    pandas, polars = pytest.importorskip("pandas"), pytest.importorskip("polars")
    found = two_sets().sweep({"1": np.array([2.0, 3.0])})
    table = found.table()
    assert list(table) == ["k_1", "gear", "state", "ratio", "efficiency"]
    frame, other = pandas.DataFrame(table), polars.DataFrame(table)
    assert len(frame) == len(other) == 8
    assert other["ratio"].dtype == polars.Float64
    assert other["ratio"].null_count() == 2 and frame["ratio"].isna().sum() == 2


@pytest.mark.parametrize(
    ("k", "gears", "name", "told"),
    [
        ({"1": [2.0, 0.5]}, None, "ring-to-sun-ratio", "variant 1: k = 0.5 of set `1`"),
        ({"1": [2.0, np.nan]}, None, "ring-to-sun-ratio", "variant 1: k = NaN"),
        ({"9": [2.0]}, None, "unknown", "9"),
        ({"1": [2.0]}, ["9"], "no-gear", "9"),
        ({"1": [2.0, 3.0], "2": [2.0, 3.0, 4.0]}, None, "swept-length", "broadcast"),
        ({"1": ["two"]}, None, "not-a-number", "two"),
        ({"1": np.ma.masked_array([2.0], [True])}, None, "masked", "masked"),
    ],
)
def test_what_cannot_vary_is_refused(k: Any, gears: Any, name: str, told: str) -> None:
    with pytest.raises(epicyclic.Refused) as refused:
        two_sets().sweep(k, gears=gears)
    assert refused.value.name == name and told in str(refused.value), refused.value


def test_an_array_without_a_name_is_refused() -> None:
    with pytest.raises(TypeError, match="by name"):
        two_sets().sweep(np.array([2.0]))  # type: ignore[arg-type]


def test_a_file_that_is_none_is_refused_with_its_place() -> None:
    with pytest.raises(epicyclic.Refused) as refused:
        two_sets(k1=0.5).sweep({"2": 2.0})
    assert refused.value.place is not None and refused.value.place.path.startswith("sets[0]")


def test_points_are_those_of_the_command_line() -> None:
    box = Gearbox.read(ROOT / "examples" / "power-split.yaml")
    engine, ring = np.array([150.0, 200.0, 250.0]), np.array([200.0, 100.0, 50.0])
    torque = np.array([-60.0, -80.0, 40.0])
    found = box.points("drive", {"engine": engine, "ring": ring}, {"ring": torque})
    for at in range(3):
        one = box.analyze(
            gear="drive",
            speeds={"engine": f"{engine[at]} rad/s", "ring": f"{ring[at]} rad/s"},
            torques={"ring": f"{torque[at]} N·m"},
        )
        for link in one.links:
            assert found.speed(link.link)[at] == pytest.approx(link.speed_rad_s, rel=1e-12, abs=1e-12)
        for terminal in one.terminals:
            assert found.torque(terminal.link)[at] == pytest.approx(terminal.torque_n_m, rel=1e-12)
    assert len(found.table()["loss_w"]) == 3


def test_points_without_torques_are_speeds() -> None:
    box = Gearbox.read(ROOT / "examples" / "power-split.yaml")
    found = box.points("drive", {"engine": np.ones((2, 3)), "ring": 0.0})
    assert found.speed_rad_s.shape == (2, 3, len(found.links)) and found.terminals == []
    with pytest.raises(epicyclic.Refused) as refused:
        box.points("drive", {"engine": 1.0})
    assert refused.value.name == "inputs"
    with pytest.raises(KeyError, match="no torque was given"):
        found.torque("ring")


def test_numpy_says_the_same_of_a_four_speed_gearbox(capsys: pytest.CaptureFixture[str]) -> None:
    import runpy

    runpy.run_path(str(ROOT / "python" / "benchmarks" / "sweep.py"))["main"](2000, 1)
    assert "2000 variants of 5 gears" in capsys.readouterr().out
