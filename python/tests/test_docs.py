"""The code in the book's chapter and in the docstrings runs."""

from __future__ import annotations

import doctest
import importlib
import re

import numpy as np
import pytest
from conftest import ROOT

import epicyclic

CHAPTER = ROOT / "docs" / "src" / "python.md"
BLOCKS = re.findall(r"^```python\n(.*?)^```$", CHAPTER.read_text(encoding="utf-8"), re.M | re.S)


def test_the_chapter_runs_from_top_to_bottom(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    assert len(BLOCKS) >= 5
    names: dict[str, object] = {}
    for number, block in enumerate(BLOCKS, 1):
        exec(compile(block, f"{CHAPTER.name}, block {number}", "exec"), names)


@pytest.mark.parametrize("page", ["README.md", "python/README.md"])
def test_the_readme_runs(page: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    blocks = re.findall(r"^```python\n(.*?)^```$", (ROOT / page).read_text(encoding="utf-8"), re.M | re.S)
    assert blocks
    names: dict[str, object] = {"epicyclic": epicyclic, "np": np}
    for block in blocks:
        exec(compile(block, page, "exec"), names)


@pytest.mark.parametrize("module", ["epicyclic", "epicyclic.description", "epicyclic.gearbox", "epicyclic.records", "epicyclic.sweeps"])
def test_docstrings_run(module: str) -> None:
    failed, tried = doctest.testmod(importlib.import_module(module))
    assert failed == 0
