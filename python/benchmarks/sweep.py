"""States, ratios and efficiencies of a four-speed gearbox for 100 000 pairs of k: one call, and beside it numpy.

The way of numpy solves the speeds and torques of every gear with ``numpy.linalg.solve`` over all variants at once, with the signs
of the losses of the gear without losses; it proves no state. Both must agree before anything is timed.

    python benchmarks/sweep.py
"""

from __future__ import annotations

import sys
import time

import numpy as np

import epicyclic

ETA = {"1": 0.975, "2": 0.98}
# Sun, ring, carrier by set; links that are one node and those that rest, by gear.
SETS = {"1": ("S1", "A", "out"), "2": ("S2", "out", "A")}
GEARS = {
    "1": ({"S1": "in"}, {"A"}),
    "2": ({"S1": "in"}, {"S2"}),
    "3": ({"S1": "in", "A": "in"}, set()),
    "4": ({"A": "in"}, {"S2"}),
    "R": ({"S2": "in"}, {"A"}),
}


def gearbox() -> epicyclic.Gearbox:
    """Two simple sets, the ring of each with the carrier of the other."""
    sets = [
        {"id": name, "sun": sun, "ring": ring, "carrier": carrier, "k": 2.0, "efficiency": ETA[name]}
        for name, (sun, ring, carrier) in SETS.items()
    ]
    return epicyclic.Gearbox(
        "four speeds",
        input="in",
        output="out",
        sets=sets,
        brakes={"B1": "S2", "B2": "A"},
        clutches={"C1": ("in", "S1"), "C2": ("in", "A"), "C3": ("in", "S2")},
        gears={"1": ["C1", "B2"], "2": ["C1", "B1"], "3": ["C1", "C2"], "4": ["C2", "B1"], "R": ["C3", "B2"]},
    )


def by_numpy(k: dict[str, np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Ratios and efficiencies, by variant and gear."""
    count = len(k["1"])
    ratios, efficiencies = [], []
    for joined, resting in GEARS.values():
        node = {link: joined.get(link, link) for link in ("in", "S1", "S2", "A", "out")}
        nodes = ["in", *dict.fromkeys(node[link] for link in node if node[link] != "in" and link not in resting)]
        free = len(nodes) - 1

        def matrix(i: dict[str, np.ndarray]) -> np.ndarray:
            c = np.zeros((count, len(SETS), len(nodes)))
            for row, (name, links) in enumerate(SETS.items()):
                for link, factor in zip(links, (1.0, -i[name], i[name] - 1)):
                    if link not in resting:
                        c[:, row, nodes.index(node[link])] += factor
            return c

        basic = {name: -k[name] for name in SETS}
        c = matrix(basic)
        speeds = np.concatenate([np.ones((count, 1)), np.linalg.solve(c[:, :, 1:], -c[:, :, :1])[..., 0]], axis=1)
        output = nodes.index("out")
        ratios.append(1 / speeds[:, output])

        def torques(c: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
            # Cᵀ·t = T_in·e_in + T_out·e_out, unknown t of the sets and T_out
            a = np.zeros((count, free + 1, free + 1))
            a[:, :, : len(SETS)] = np.swapaxes(c, 1, 2)
            a[:, output, len(SETS)] = -1
            right = np.zeros((count, free + 1, 1))
            right[:, 0] = 1
            found = np.linalg.solve(a, right)[..., 0]
            return found[:, : len(SETS)], found[:, len(SETS)]

        def speed(link: str) -> np.ndarray | float:
            return 0.0 if link in resting else speeds[:, nodes.index(node[link])]

        ideal, _ = torques(c)
        lossy = {}
        for row, (name, (sun, _, carrier)) in enumerate(SETS.items()):
            power = ideal[:, row] * (speed(sun) - speed(carrier))
            lossy[name] = basic[name] * ETA[name] ** np.where(np.abs(power) < 1e-11, 0, np.sign(power))
        _, out = torques(matrix(lossy))
        efficiencies.append(-out * speeds[:, output])
    return np.stack(ratios, axis=1), np.stack(efficiencies, axis=1)


def least(call, times: int) -> float:
    taken = []
    for _ in range(times):
        begun = time.perf_counter()
        call()
        taken.append(time.perf_counter() - begun)
    return min(taken)


def main(count: int = 100_000, times: int = 7) -> None:
    box = gearbox()
    dice = np.random.default_rng(1)
    k = {name: dice.uniform(1.3, 4.0, count) for name in SETS}
    found = box.sweep(k)
    ratios, efficiencies = by_numpy(k)
    assert found.driven.all()
    np.testing.assert_allclose(found.ratio, ratios, rtol=1e-10)
    np.testing.assert_allclose(found.efficiency, efficiencies, rtol=1e-10)
    quick, plain = least(lambda: box.sweep(k), times), least(lambda: by_numpy(k), 3)
    print(f"{count} variants of {len(GEARS)} gears: one call {quick:.3f} s, numpy {plain:.3f} s, {plain / quick:.1f} times")


if __name__ == "__main__":
    main(*(int(word) for word in sys.argv[1:]))
