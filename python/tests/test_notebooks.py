"""The notebooks run from the first cell to the last; what a cell claims, it asserts."""

from __future__ import annotations

from pathlib import Path

import nbformat
import pytest
from conftest import ROOT
from nbclient import NotebookClient

NOTEBOOKS = sorted((ROOT / "python" / "notebooks").glob("*.ipynb"))


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs(notebook: Path) -> None:
    content = nbformat.read(notebook, as_version=4)
    # Outputs change with every version of what shows them; the cells assert what they say, and outputs are not kept.
    assert not any(cell.get("outputs") for cell in content.cells)
    NotebookClient(content, timeout=300, kernel_name="python3", resources={"metadata": {"path": str(ROOT)}}).execute()
    shown = [output for cell in content.cells for output in cell.get("outputs", []) if "data" in output]
    assert any("image/svg+xml" in output["data"] for output in shown)
    assert any("text/html" in output["data"] for output in shown)


def test_there_are_notebooks() -> None:
    assert len(NOTEBOOKS) >= 2
