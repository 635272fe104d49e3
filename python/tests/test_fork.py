"""A process that is forked calculates, too, though none of the threads of its parent are in it."""

from __future__ import annotations

import multiprocessing
import os
import subprocess
import sys
import textwrap
from typing import Any

import numpy as np
import pytest
from test_sweeps import two_sets

import epicyclic

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="nothing forks here")
# Python warns of threads of its own kind, of numpy's for example; the tests run in one.
FORKED = pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
PATIENCE = 60
K = np.linspace(1.5, 4.0, 20_000)


def swept(shift: float) -> Any:
    return two_sets().sweep({"1": K + shift}).ratio.data


def synthesized(_: object) -> Any:
    found = epicyclic.synthesize(ratios="3.059, 1.625, 1, 0.696, -2.294", sets=2, elements=5, engaged=2, class_="all-sparse", limit=1)
    return found.to_dict()


def grandchild(_: object) -> Any:
    """A process that a forked one forks, after work of its own."""
    here = swept(0.0)
    with multiprocessing.get_context("fork").Pool(1) as pool:
        return here, pool.map_async(swept, [0.0]).get(PATIENCE)[0]


@FORKED
def test_sweeps_answer_in_a_pool_that_was_forked_after_a_sweep() -> None:
    expected = [swept(shift) for shift in (0.0, 0.1, 0.2)]
    with multiprocessing.get_context("fork").Pool(2) as pool:
        # Two rounds: each process answers more than once.
        for _ in range(2):
            found = pool.map_async(swept, (0.0, 0.1, 0.2)).get(PATIENCE)
            assert all(np.array_equal(one, other) for one, other in zip(expected, found))


@FORKED
def test_searches_answer_after_a_fork() -> None:
    expected = synthesized(None)
    with multiprocessing.get_context("fork").Pool(1) as pool:
        assert pool.map_async(synthesized, [None]).get(PATIENCE) == [expected]


# The processes of a pool cannot have children; those of an executor can.
@FORKED
def test_a_fork_of_a_fork_answers() -> None:
    from concurrent.futures import ProcessPoolExecutor

    expected = swept(0.0)
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("fork")) as pool:
        here, below = pool.submit(grandchild, None).result(2 * PATIENCE)
    assert np.array_equal(here, expected) and np.array_equal(below, expected)


def test_progress_and_ctrl_c_are_heard_after_a_fork() -> None:
    """In a process of its own: what it does not end would hold up the tests."""
    code = """
        import os, signal, sys
        import numpy as np
        from test_sweeps import two_sets
        two_sets().sweep({"1": np.full(100, 2.0)})
        child = os.fork()
        if child:
            sys.exit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
        signal.signal(signal.SIGINT, signal.default_int_handler)
        told = []
        def stop(line):
            told.append(line)
            signal.raise_signal(signal.SIGINT)
        try:
            two_sets().sweep({"1": np.full(20_000_000, 2.0)}, progress=stop)
        except KeyboardInterrupt:
            os._exit(7 if told else 8)
        os._exit(9)
    """
    here = os.path.dirname(__file__)
    done = subprocess.run([sys.executable, "-W", "ignore", "-c", textwrap.dedent(code)], cwd=here, timeout=PATIENCE)
    assert done.returncode == 7
