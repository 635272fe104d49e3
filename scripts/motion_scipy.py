#!/usr/bin/env python3
"""The power shift P2 by scipy's DOP853 with events, beside the benchmark `motion/shift/p2`.

One planetary set, ring-to-sun ratio 2, ring and planets without mass: a one-way brake holds the ring until the clutch
between sun and ring, on a ramp of 500 N·m/s, has taken its torque over; at 160 N·m the clutch then slips until it locks.
The same states as the library has: speeds of sun and carrier, work of engine and load, heat of the clutch. The same tolerance, 1e-11.

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


for event in (brake_free, slip):
    event.terminal = True


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


def main():
    release, lock, end = shift()
    for name, found, due in zip(("release", "lock"), (release, lock), closed_form()):
        print(f"{name:8} {found:.13f} s, off the closed form by {abs(found - due) / due:.1e}")
    stored = 0.5 * (J_SUN * end[0] ** 2 + J_CARRIER * end[1] ** 2 - J_SUN * START[0] ** 2 - J_CARRIER * START[1] ** 2)
    print(f"heat     {end[4]:.9f} J, energies balance to {abs(stored - end[2] - end[3] + end[4]) / abs(stored):.1e}")
    times = []
    for _ in range(RUNS):
        began = time.perf_counter()
        shift()
        times.append(time.perf_counter() - began)
    print(f"scipy    {np.median(times) * 1e3:.2f} ms, median of {RUNS}; least {min(times) * 1e3:.2f} ms")
    if "--bench" in sys.argv[1:]:
        library = benchmark()
        print(f"library  {library * 1e6:.1f} µs, mean of criterion")
        print(f"ratio    {np.median(times) / library:.0f}")


if __name__ == "__main__":
    main()
