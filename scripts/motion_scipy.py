#!/usr/bin/env python3
"""The power shift P2 by scipy's DOP853 with events, beside the benchmark `motion/shift/p2`.

One planetary set, ring-to-sun ratio 2, ring and planets without mass: a one-way brake holds the ring until the clutch
between sun and ring, on a ramp of 500 N·m/s, has taken its torque over; at 160 N·m the clutch then slips until it locks.
The same states as the library has: speeds of sun and carrier, work of engine and load, heat of the clutch. The same
tolerance, 1e-11. Twice:

    reduced    each phase by its accelerations, derived by hand, with the one event that ends it
    assembled  each phase as the library has it: the balance of every body with the torques of the set and of what
               sticks, solved as a linear system at each evaluation, with an event for each bound: brake, clutch, slips

    python3 scripts/motion_scipy.py            time, events, and their distance from the closed form
    python3 scripts/motion_scipy.py --bench    the benchmark of the library too, and the ratio of both times

Needs numpy and scipy; with --bench cargo, in whose target directory the result of criterion is read.
"""

import json
import os
import subprocess
import sys
import time

import numpy as np
from scipy.integrate import solve_ivp

RHO, J_SUN, J_CARRIER, ENGINE, LOAD = 2.0, 0.2, 8.0, 150.0, 300.0
RAMP, FULL, END, TOLERANCE, RUNS = 500.0, 160.0, 0.6, 1e-11, 50
START = np.array([200.0, 200.0 / 3.0, 0.0, 0.0, 0.0])
# Scales of the absolute tolerance: the largest speed, and the kinetic energy.
SCALES = np.array([200.0, 200.0, 2.2e4, 2.2e4, 2.2e4])


def rates(y, sun, carrier, clutch):
    """Accelerations with the torque of the clutch on the ring, and the powers."""
    ring = carrier_to_ring(y)
    return [sun, carrier, ENGINE * y[0], -LOAD * y[1], clutch * (y[0] - ring)]


def carrier_to_ring(y):
    return ((1.0 + RHO) * y[1] - y[0]) / RHO


def torque_phase(t, y):
    # The ring stands: w_sun = 3·w_carrier. The sun of the set carries engine less clutch less inertia.
    clutch = RAMP * t
    ratio = 1.0 + RHO
    sun = (ENGINE - clutch - LOAD / ratio) / (J_SUN + J_CARRIER / ratio**2)
    return rates(y, sun, sun / ratio, clutch)


def brake_free(t, y):
    # Brake = rho·(torque on the set's sun) − clutch.
    sun = torque_phase(t, y)[0]
    return RHO * (ENGINE - RAMP * t - J_SUN * sun) - RAMP * t


def inertia_phase(_, y):
    # The clutch on the massless ring: the set's sun carries clutch/rho, its carrier (1 + rho)/rho·clutch.
    sun = (ENGINE - FULL - FULL / RHO) / J_SUN
    carrier = ((1.0 + RHO) / RHO * FULL - LOAD) / J_CARRIER
    return rates(y, sun, carrier, FULL)


def slip(_, y):
    return y[0] - carrier_to_ring(y)


def locked(_, y):
    both = (ENGINE - LOAD) / (J_SUN + J_CARRIER)
    return rates(y, both, both, 0.0)


def solved(y, clutch, sticks):
    """Accelerations of sun and carrier, torque of the set on its sun, torques of brake and clutch.

    `clutch` is its torque while it slips; `sticks` are the names of what does not.
    """
    # Unknowns: sun, carrier, set, brake, clutch. Rows: sun, ring, carrier, then brake and clutch.
    matrix = np.zeros((5, 5))
    right = np.array([ENGINE, 0.0, -LOAD, 0.0, clutch])
    matrix[0, [0, 2, 4]] = J_SUN, -1.0, 1.0
    matrix[1, [2, 3, 4]] = -RHO, -1.0, -1.0
    matrix[2, [1, 2]] = J_CARRIER, 1.0 + RHO
    if "brake" in sticks:
        matrix[3, [0, 1]] = -1.0, 1.0 + RHO
    else:
        matrix[3, 3] = 1.0
    if "clutch" in sticks:
        matrix[4, [0, 1]] = 1.0, -1.0
        right[4] = 0.0
    else:
        matrix[4, 4] = 1.0
    return np.linalg.solve(matrix, right)


def assembled(sticks, capacity):
    """Rates of a phase."""

    def field(t, y):
        sun, carrier, _, _, clutch = solved(y, capacity(t), sticks)
        return rates(y, sun, carrier, clutch)

    return field


def bound(sticks, capacity, place, sign, limit):
    """Where a solved torque comes to a limit."""

    def event(t, y):
        return limit - sign * solved(y, capacity(t), sticks)[place]

    event.terminal = True
    return event


def overrun(_, y):
    return carrier_to_ring(y) + 1e-9


def shift_assembled():
    """The shift by the assembled phases."""
    options = {"method": "DOP853", "rtol": TOLERANCE, "atol": TOLERANCE * SCALES}
    ramp, full = (lambda t: RAMP * t), (lambda t: FULL)
    brake = {"brake"}
    free = bound(brake, ramp, 3, -1.0, 0.0)
    first = solve_ivp(assembled(brake, ramp), (0.0, END), START, events=[free, slip], **options)
    second = solve_ivp(assembled(set(), full), (first.t[-1], END), first.y[:, -1], events=[slip, overrun], **options)
    clutch = {"clutch"}
    exceeds = [bound(clutch, full, 4, sign, FULL) for sign in (1.0, -1.0)]
    third = solve_ivp(
        assembled(clutch, full), (second.t[-1], END), second.y[:, -1], events=[*exceeds, overrun], **options
    )
    return first.t[-1], second.t[-1], third.y[:, -1]


for one in (brake_free, slip, overrun):
    one.terminal = True


def shift():
    """Times of release and lock, and the state at the end."""
    options = {"method": "DOP853", "rtol": TOLERANCE, "atol": TOLERANCE * SCALES}
    first = solve_ivp(torque_phase, (0.0, END), START, events=brake_free, **options)
    second = solve_ivp(inertia_phase, (first.t[-1], END), first.y[:, -1], events=slip, **options)
    third = solve_ivp(locked, (second.t[-1], END), second.y[:, -1], **options)
    return first.t[-1], second.t[-1], third.y[:, -1]


def closed_form():
    """The same from the equations of uniformly and linearly changing acceleration."""
    release = 46.0 / 215.0
    inertia = J_SUN + J_CARRIER / 9.0
    sun = 200.0 + (50.0 * release - 0.5 * RAMP * release**2) / inertia
    carrier = sun / 3.0
    slip_start = sun - carrier_to_ring([sun, carrier])
    accelerations = [(ENGINE - FULL - FULL / RHO) / J_SUN, (1.5 * FULL - LOAD) / J_CARRIER]
    slip_rate = accelerations[0] - (3.0 * accelerations[1] - accelerations[0]) / RHO
    return release, release - slip_start / slip_rate


def benchmark():
    """Mean time of the library in s, from criterion, run now."""
    subprocess.run(["cargo", "bench", "-p", "epicyclic-motion", "--", "motion/shift/p2"], check=True, stdout=sys.stderr)
    target = os.environ.get("CARGO_TARGET_DIR", "target")
    with open(os.path.join(target, "criterion", "motion_shift_p2", "new", "estimates.json"), encoding="utf-8") as file:
        return json.load(file)["mean"]["point_estimate"] * 1e-9


def timed(run):
    """Median time of a function in s."""
    times = []
    for _ in range(RUNS):
        began = time.perf_counter()
        run()
        times.append(time.perf_counter() - began)
    return np.median(times)


def main():
    taken = {}
    for title, run in (("reduced", shift), ("assembled", shift_assembled)):
        release, lock, end = run()
        for name, found, due in zip(("release", "lock"), (release, lock), closed_form()):
            print(f"{title:9} {name:7} {found:.13f} s, off the closed form by {abs(found - due) / due:.1e}")
        kinetic = 0.5 * (J_SUN * end[0] ** 2 + J_CARRIER * end[1] ** 2)
        stored = kinetic - 0.5 * (J_SUN * START[0] ** 2 + J_CARRIER * START[1] ** 2)
        off = abs(stored - end[2] - end[3] + end[4]) / abs(stored)
        print(f"{title:9} heat    {end[4]:.9f} J, energies balance to {off:.1e}")
        taken[title] = timed(run)
        print(f"{title:9} time    {taken[title] * 1e3:.3f} ms, median of {RUNS}")
    if "--bench" in sys.argv[1:]:
        library = benchmark()
        print(f"library   time    {library * 1e6:.1f} µs, mean of criterion")
        # Once more after it, for a machine that others use, too.
        for title, run in (("reduced", shift), ("assembled", shift_assembled)):
            least = min(taken[title], timed(run))
            print(f"{title:9} ratio   {least / library:.0f}, by the shorter of two medians, {least * 1e3:.3f} ms")


if __name__ == "__main__":
    main()
