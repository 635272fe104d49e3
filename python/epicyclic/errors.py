"""What is refused, with the names, messages and places of the command line."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Mapping

if TYPE_CHECKING:
    from .records import Answer

__all__ = ["Error", "Fault", "FileFailure", "NothingFound", "Place", "Refused"]


@dataclass(frozen=True)
class Place:
    """Where in a file a fault is."""

    file: str
    """The file as it was named; of a gearbox built in Python its name."""
    line: int
    """From 1."""
    column: int
    """From 1, in characters."""
    path: str
    """Keys and places of lists that lead there, ``sets[0].k``; empty for the whole document."""


@dataclass(frozen=True)
class Fault:
    """One of the faults of an :class:`Error`."""

    name: str
    """Kind of the fault, ``missing-unit``; it stays the same whatever the message says."""
    message: str
    value: str | None = None
    """Text of the wrong value or key as it stands in the file or in the call."""
    remedy: str | None = None
    """Text to write in its place, where one is known."""
    place: Place | None = None


class Error(Exception):
    """A call without an answer.

    ``str(error)`` is the message of the command line: what is wrong and what is allowed.
    """

    name: str
    """Kind of the fault, ``ring-to-sun-ratio``; it stays the same whatever the message says."""
    message: str
    option: str | None
    """The option of the command line that it is about, ``--torque``; the argument has its name without the dashes."""
    place: Place | None
    faults: tuple[Fault, ...]
    """All faults, at least one: of a file each value that is wrong."""
    exit_code: int
    """Exit code of the command line."""
    answer: Answer | None = None
    """Of :class:`NothingFound` the answer that tells why, where there is one: all candidates with what keeps them out."""

    def __init__(
        self,
        message: str,
        *,
        name: str = "usage",
        option: str | None = None,
        place: Place | None = None,
        faults: tuple[Fault, ...] = (),
        exit_code: int = 2,
    ) -> None:
        super().__init__(message)
        self.message, self.name, self.option, self.place, self.exit_code = message, name, option, place, exit_code
        self.faults = faults or (Fault(name, message, place=place),)

    def __reduce__(self) -> tuple[Any, ...]:
        return (_again, (type(self), self.message, self.name, self.option, self.place, self.faults, self.exit_code))


class Refused(Error, ValueError):
    """An input that cannot be."""


class NothingFound(Error, LookupError):
    """A sound question without an answer within its bounds."""


class FileFailure(Error, OSError):
    """A file that cannot be read or written."""


_KINDS: dict[int, type[Error]] = {1: NothingFound, 2: Refused, 3: FileFailure}


def _again(
    kind: type[Error],
    message: str,
    name: str,
    option: str | None,
    place: Place | None,
    faults: tuple[Fault, ...],
    code: int,
) -> Error:
    return kind(message, name=name, option=option, place=place, faults=faults, exit_code=code)


def _place(record: Mapping[str, Any] | None) -> Place | None:
    return Place(**record) if record else None


def of_record(record: Mapping[str, Any]) -> Error:
    """The exception of a record that stands in place of an answer."""
    faults = (Fault(**{**fault, "place": _place(fault["place"])}) for fault in record.get("faults", []))
    code = int(record.get("exit_code", 2))
    return _KINDS.get(code, Refused)(
        str(record["message"]),
        name=str(record["name"]),
        option=record.get("option"),
        place=_place(record.get("place")),
        faults=tuple(faults),
        exit_code=code,
    )


def of_messages(code: int, messages: str) -> Error:
    """The exception of what was said beside an answer that is no JSON."""
    lines = messages.splitlines()
    starts = [at for at, line in enumerate(lines) if line.startswith("error: ")]
    # All faults of a file are said, a line each, one below the other.
    first = starts[-1] if starts else 0
    while first - 1 in starts:
        first -= 1
    text = "\n".join(line.removeprefix("error: ") for line in lines[first:])
    text = text.split("\n\nUsage: ")[0].split("\n\nFor more information")[0].strip()
    named = re.match(r"invalid value .*? for '(--[a-z0-9-]+)", text, re.S)
    return _KINDS.get(code, Refused)(text, option=named[1] if named else None, exit_code=code)
