"""Input files of the program, built in Python or read from YAML."""

from __future__ import annotations

import json
from collections.abc import Mapping
from os import PathLike, fspath
from pathlib import Path
from typing import Any, Self

import numpy as np

from .errors import of_messages

__all__ = ["Description"]

NAMED_BY = ("gearbox", "scenario", "title")
"""Keys whose text is the name of what a file describes."""


class Description:
    """A scenario, a drive or a hydromotor: a file that the program reads, built in Python or read.

    Every function takes it where the command takes a file. Nothing is checked before the first question is asked of it;
    a fault is then told with its place in the file, or in :attr:`yaml`.

    Parameters
    ----------
    **keys
        The keys of a file, as texts, numbers, lists and mappings. Quantities are texts with a unit: ``"30 mm"``. Names
        of other files count from the working directory. The ``gearbox_file`` of a scenario may be a
        :class:`~epicyclic.Gearbox`.

    Examples
    --------
    >>> import epicyclic
    >>> run_up = epicyclic.Description(
    ...     scenario="run up",
    ...     gearbox_file=epicyclic.Gearbox(
    ...         "conveyor", input="D", output="B", brakes={"K1": "T1"}, gears={"slow": ["K1"]},
    ...         sets=[{"id": "P", "sun": "D", "ring": "T1", "carrier": "B", "k": 3.0}],
    ...     ),
    ...     inertias={"B": "16 kg·m²"},
    ...     engaged=["K1"],
    ...     duration="1 s",
    ...     torques=[{"id": "motor", "link": "D", "constant": "10 N·m"}],
    ... )
    >>> round(epicyclic.simulate(run_up).end["B"].speed_rad_s, 9)  # 4 · 10 N·m on 16 kg·m² for 1 s
    2.5
    """

    _file: str
    _text: bytes
    _name: str
    _beside: dict[str, bytes]
    _options: dict[str, Any]

    def __init__(self, **keys: Any) -> None:
        described: dict[str, Any] = {}
        beside: dict[str, bytes] = {}
        for key, value in keys.items():
            if isinstance(value, Description):
                beside.update(value._files)
                described.update({option: own for option, own in value._options.items() if option not in keys})
                value = value._file
            described[key] = value
        name = next((keys[key] for key in NAMED_BY if isinstance(keys.get(key), str)), "description")
        self._keep(built(name), yaml_of(described).encode(), name, beside)

    def _keep(self, file: str, text: bytes, name: str, beside: Mapping[str, bytes] | None = None) -> None:
        self._file, self._text, self._name, self._beside, self._options = file, text, name, dict(beside or {}), {}

    @classmethod
    def read(cls, file: str | PathLike[str]) -> Self:
        """The description of a YAML file.

        Raises
        ------
        FileFailure
            The file cannot be read.
        """
        path = fspath(file)
        return cls.from_yaml(content_of(path), file=path)

    @classmethod
    def from_yaml(cls, text: str | bytes, *, file: str = "text") -> Self:
        """A description of a text in YAML; ``file`` is what messages call it, and names of other files count from its folder."""
        found = cls.__new__(cls)
        found._keep(file, text.encode() if isinstance(text, str) else bytes(text), Path(file).stem)
        return found

    @property
    def _files(self) -> dict[str, bytes]:
        """It and what it names, by the names of files."""
        return {**self._beside, self._file: self._text}

    @property
    def yaml(self) -> str:
        """It as a file that the command line reads."""
        return self._text.decode()

    def save(self, file: str | PathLike[str]) -> None:
        """Writes :attr:`yaml` to a file. A gearbox that it names has a ``save`` of its own."""
        Path(file).write_bytes(self._text)

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self._name!r}>"


def built(name: str) -> str:
    """The name of a file in memory; in no folder, so that it stands beside the others."""
    return f"{name.replace('/', '-')} (built in Python)"


def content_of(file: str) -> bytes:
    """A file; what prevents it is told as the command line tells it."""
    try:
        with open(file, "rb") as opened:
            return opened.read()
    except OSError as error:
        failure = of_messages(3, f"{file}: cannot be read: {error.strerror} (os error {error.errno})")
        failure.name = "cannot-be-read"
        raise failure from error


def yaml_of(described: Mapping[str, Any]) -> str:
    """YAML with one line for each entry of a list, so that a place in it tells something."""
    lines = []
    for key, value in described.items():
        value = _simple(value)
        if isinstance(value, list) and value and isinstance(value[0], (dict, list)):
            lines.append(f"{_text(key)}:")
            lines += [f"  - {json.dumps(entry, ensure_ascii=False, allow_nan=True)}" for entry in value]
        else:
            lines.append(f"{_text(key)}: {json.dumps(value, ensure_ascii=False, allow_nan=True)}")
    return "\n".join(lines) + "\n"


def _text(key: str) -> str:
    return key if key.isidentifier() else json.dumps(key, ensure_ascii=False)


def _simple(value: Any) -> Any:
    """Numpy's numbers and arrays, tuples and mappings as JSON has them."""
    if isinstance(value, Mapping):
        return {str(key): _simple(inner) for key, inner in value.items()}
    if isinstance(value, np.ndarray):
        return _simple(value.tolist())
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, (list, tuple)):
        return [_simple(inner) for inner in value]
    if isinstance(value, PathLike):
        return fspath(value)
    return value
