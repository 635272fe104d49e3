"""Where the repository and the program are."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def root() -> Path:
    return ROOT


@pytest.fixture(scope="session")
def program() -> str:
    """The program of the command line, built from the same sources."""
    found = os.environ.get("EPICYCLIC_PROGRAM")
    if not found:
        pytest.fail("EPICYCLIC_PROGRAM does not name the program; run scripts/python")
    return found


@pytest.fixture
def in_root(monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(ROOT)
    return ROOT
