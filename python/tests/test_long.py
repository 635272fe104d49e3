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


class CtrlC:
    """Ctrl-C soon after the first progress; never after the work has ended."""

    def __init__(self) -> None:
        self.told: list[str] = []
        self._begun = threading.Event()
        self._ended = threading.Event()

    def progress(self, line: str) -> None:
        self.told.append(line)
        self._begun.set()

    def _press(self) -> None:
        if self._begun.wait(60) and not self._ended.wait(0.3):
            signal.raise_signal(signal.SIGINT)

    def __enter__(self) -> CtrlC:
        self._thread = threading.Thread(target=self._press)
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ended.set()
        self._thread.join()


def test_a_sweep_tells_its_progress_and_ends_by_ctrl_c() -> None:
    k = np.full(20_000_000, 2.0)
    with CtrlC() as ctrl_c, pytest.raises(KeyboardInterrupt):
        two_sets().sweep({"1": k}, progress=ctrl_c.progress)
    told = ctrl_c.told
    assert told and all(line.endswith(" of 20000000") for line in told)
    # It has not come to its end.
    assert not told[-1].startswith("20000000")


def test_an_exception_of_the_progress_ends_the_work() -> None:
    def stop(line: str) -> None:
        raise RuntimeError(line)

    with pytest.raises(RuntimeError, match="of 20000000"):
        two_sets().sweep({"1": np.full(20_000_000, 2.0)}, progress=stop)


def test_a_search_tells_its_progress_and_ends_by_ctrl_c() -> None:
    begun = time.monotonic()
    with CtrlC() as ctrl_c, pytest.raises(KeyboardInterrupt):
        epicyclic.synthesize(
            ratios="4.7143 3.1429 2.1064 1.6667 1.2854 1 0.8387 0.6667 -3.2952",
            sets=4,
            elements=5,
            engaged=3,
            progress=ctrl_c.progress,
        )
    assert time.monotonic() - begun < 15
    assert ctrl_c.told[0].startswith("searching")


def test_after_an_end_the_next_call_answers() -> None:
    assert epicyclic.teeth(ratio=6, planets=4, limit=1).tooth_numbers[0].exact_ratio.numerator == 6
