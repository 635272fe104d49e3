from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .sweeps import _Described

__version__: str

_Numbers = NDArray[np.float64]
_Flags = NDArray[np.bool_]
_Columns = list[tuple[str, _Numbers]]
_Progress = Callable[[str], Any] | None

def call(
    line: list[str], files: dict[str, bytes], kept: list[str], progress: _Progress = None
) -> tuple[int, bytes, bytes | None, str, dict[str, bytes]]: ...
def commands() -> str: ...
def sweep(
    description: _Described, gears: list[str], k: _Columns, progress: _Progress = None
) -> tuple[
    tuple[list[str], tuple[NDArray[np.uint8], _Numbers, _Flags, _Numbers, _Flags]] | None,
    str | None,
]: ...
def points(
    description: _Described, gear: str, speeds_rad_s: _Columns, torques_n_m: _Columns, progress: _Progress = None
) -> tuple[
    tuple[
        list[str],
        list[str],
        tuple[_Numbers, _Flags, _Numbers, _Numbers, _Flags, _Numbers, _Numbers, _Flags],
    ]
    | None,
    str | None,
]: ...
