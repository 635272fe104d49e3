"""Long work: other threads go on, progress is told, Ctrl-C ends it."""

from __future__ import annotations

import signal
import threading
import time
from collections.abc import Iterator

import numpy as np
import pytest
from test_sweeps import two_sets

import epicyclic


@pytest.fixture(autouse=True)
def _ctrl_c_is_heard() -> Iterator[None]:
    """A shell starts what runs in the background deaf to Ctrl-C, and Python leaves it so."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def test_other_threads_go_on() -> None:
    """A thread counts while a sweep runs; with Python's lock held it would stand."""
    k = np.full(300_000, 2.0)
    counts: list[int] = []
    ended = threading.Event()

    def count() -> None:
        number = 0
        while not ended.is_set():
            number += 1
            if number % 1000 == 0:
                time.sleep(0)
        counts.append(number)

    thread = threading.Thread(target=count)
    thread.start()
    try:
        two_sets().sweep({"1": k})
    finally:
        ended.set()
        thread.join()
    assert counts[0] > 1000


def test_a_sweep_tells_its_progress_and_ends_by_ctrl_c() -> None:
    told: list[str] = []
    k = np.full(20_000_000, 2.0)
    timer = threading.Timer(2.0, lambda: signal.raise_signal(signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        two_sets().sweep({"1": k}, progress=told.append)
    timer.cancel()
    assert told and all(line.endswith(" of 20000000") for line in told)
    # It has not come to its end.
    assert not told[-1].startswith("20000000")


def test_an_exception_of_the_progress_ends_the_work() -> None:
    def stop(line: str) -> None:
        raise RuntimeError(line)

    with pytest.raises(RuntimeError, match="of 20000000"):
        two_sets().sweep({"1": np.full(20_000_000, 2.0)}, progress=stop)


def test_a_search_tells_its_progress_and_ends_by_ctrl_c() -> None:
    told: list[str] = []
    timer = threading.Timer(3.0, lambda: signal.raise_signal(signal.SIGINT))
    begun = time.monotonic()
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        epicyclic.synthesize(
            ratios="4.171 2.340 1.521 1.143 0.867 0.691 -3.403",
            sets=3,
            elements=6,
            engaged=3,
            class_="all-sparse",
            progress=told.append,
        )
    timer.cancel()
    assert time.monotonic() - begun < 15
    assert told and told[0].startswith("searching")


def test_after_an_end_the_next_call_answers() -> None:
    assert epicyclic.teeth(ratio=6, planets=4, limit=1).tooth_numbers[0].exact_ratio.numerator == 6
