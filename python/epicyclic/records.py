"""Answers as objects: the records of ``--format json``, with their keys as attributes and their lists as tables.

Every number is in the SI unit that its key ends with: ``torque_n_m``, ``speed_rad_s``. A key that ends with
``_of_input`` or ``_of_entering`` is a multiple of the input's speed or torque, or of the power that enters; other keys
without a unit are pure numbers. What there is not is ``None``, never NaN.
"""

from __future__ import annotations

import html
import json
import keyword
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, overload

__all__ = ["Answer", "Record", "Records"]

_MOST_ROWS = 30
"""How many rows of a table a notebook shows."""


class Record(Mapping[str, Any]):
    """A record of an answer: a read-only mapping whose keys are attributes, too.

    A key that is a word of Python has an underscore behind it: ``shift.from_`` is ``shift["from"]``.
    """

    __slots__ = ("_keys",)

    def __init__(self, keys: Mapping[str, Any]) -> None:
        object.__setattr__(self, "_keys", {key: _wrapped(value) for key, value in keys.items()})

    def __getitem__(self, key: str) -> Any:
        try:
            return self._keys[key]
        except KeyError:
            raise KeyError(f"{key!r}: there are {', '.join(self._keys)}") from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._keys)

    def __len__(self) -> int:
        return len(self._keys)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__") or name == "_keys":
            raise AttributeError(name)
        key = name[:-1] if name.endswith("_") and keyword.iskeyword(name[:-1]) else name
        try:
            return self._keys[key]
        except KeyError:
            raise AttributeError(f"no key {key!r}: there are {', '.join(self._keys)}") from None

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError("an answer does not change")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *(f"{key}_" if keyword.iskeyword(key) else key for key in self._keys)]

    def __repr__(self) -> str:
        shown = ", ".join(f"{key}={_short(value)}" for key, value in self._keys.items())
        return f"{type(self).__name__}({shown})"

    def __eq__(self, other: object) -> bool:
        return bool(self.to_dict() == (other.to_dict() if isinstance(other, Record) else other))

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (self.to_dict(),))

    def to_dict(self) -> dict[str, Any]:
        """The record as dictionaries, lists, numbers and texts."""
        return {key: _plain(value) for key, value in self._keys.items()}

    def _repr_html_(self) -> str:
        return _html(self)


class Records(Sequence[Any]):
    """A list of records, found by their places and, where they have one, by their names: ``answer.gears["2"]``.

    The name of a record is its first key, where that is a text in every record of the list: of ``gears`` the ``gear``, of
    ``shift_elements`` the ``shift_element``. A name that several records have is refused; their places tell them apart.
    """

    __slots__ = ("_rows",)

    def __init__(self, rows: Sequence[Any]) -> None:
        self._rows = [_wrapped(row) for row in rows]

    @overload
    def __getitem__(self, key: int | str) -> Any: ...
    @overload
    def __getitem__(self, key: slice) -> Records: ...
    def __getitem__(self, key: int | str | slice) -> Any:
        if isinstance(key, slice):
            return Records(self._rows[key])
        if not isinstance(key, str):
            return self._rows[key]
        names = _names_of(self._rows)
        if names is None:
            raise KeyError(f"{key!r}: these records have no names, only places from 0 to {len(self._rows) - 1}")
        places = [place for place, name in enumerate(names) if name == key]
        if not places:
            raise KeyError(f"{key!r}: there are {', '.join(dict.fromkeys(names))}")
        if len(places) > 1:
            raise KeyError(f"{key!r} is the name of several records: take one by its place, {_listed(places)}")
        return self._rows[places[0]]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        names = _names_of(self._rows)
        records = f"[0] or [{names[0]!r}]" if names else "[0]"
        raise AttributeError(f"this is a list, without a key {name!r}: its records are {records} and so on")

    def __len__(self) -> int:
        return len(self._rows)

    def __repr__(self) -> str:
        return f"Records({self._rows!r})"

    def __eq__(self, other: object) -> bool:
        return bool(_plain(self) == (_plain(other) if isinstance(other, Records) else other))

    __hash__ = None  # type: ignore[assignment]

    def _repr_html_(self) -> str:
        return _table_html(_flat_rows([({}, _shown(_plain(row))) for row in self._rows]))


class Answer(Record):
    """An answer of a command.

    Its keys are those of ``--format json``; ``epicyclic.schema("answer-analyze")`` describes each. The first are
    ``schema_version``, which rises when a key goes or changes its meaning, and ``answer``, the name of the command.
    """

    __slots__ = ("_again",)

    def __init__(self, keys: Mapping[str, Any], again: Any = None) -> None:
        super().__init__(keys)
        object.__setattr__(self, "_again", again)

    def tables(self) -> list[str]:
        """Names that :meth:`table` takes: the lists of records, at any depth."""
        return [name for name, rows in _tables(self.to_dict(), "").items() if rows]

    def table(self, name: str) -> list[dict[str, Any]]:
        """A list of records as flat rows, all with the same keys.

        ``pandas.DataFrame(answer.table("gears"))`` and ``polars.DataFrame(answer.table("gears"))`` take it.

        Parameters
        ----------
        name
            Keys that lead to the list, joined by dots: ``"gears"``, ``"gears.shift_elements"``. Rows of an inner list
            begin with the names of what they stand in. Records inside a row are keys joined by an underscore; inner
            lists of records are tables of their own. A record of equally long lists of numbers, as the ``samples`` of
            ``simulate``, has one row for each place.

        Raises
        ------
        KeyError
            No such list; the message tells which there are.
        """
        rows: list[tuple[dict[str, Any], Any]] = [({}, self.to_dict())]
        for key in name.split("."):
            below: list[tuple[dict[str, Any], Any]] = []
            for outer, value in rows:
                if isinstance(value, dict) and key in value:
                    inner = value[key]
                    named = {**outer, **_identity(value, outer)}
                    below += [(named, row) for row in inner] if isinstance(inner, list) else [(named, inner)]
            rows = below if any(True for _ in below) else []
            if not rows and name not in _tables(self.to_dict(), ""):
                raise KeyError(f"{name!r}: there are {', '.join(self.tables())}")
        if len(rows) == 1 and isinstance(rows[0][1], dict) and (columns := _columns(rows[0][1])):
            return [dict(zip(columns, row)) for row in zip(*columns.values())]
        return _flat_rows(rows)

    def text(self) -> str:
        """The tables of the command line, in the units of drawings; the question is answered anew."""
        if self._again is None:
            raise ValueError("only what a command answered has a text")
        return str(self._again())

    def __reduce__(self) -> tuple[Any, ...]:
        return (Answer, (self.to_dict(),))


def _wrapped(value: Any) -> Any:
    if isinstance(value, (Record, Records)):
        return value
    if isinstance(value, dict):
        return Record(value)
    if isinstance(value, list) and value and isinstance(value[0], (dict, Record)):
        return Records(value)
    return value


def _plain(value: Any) -> Any:
    if isinstance(value, Record):
        return value.to_dict()
    if isinstance(value, (Records, list)):
        return [_plain(one) for one in value]
    return value


def _name_of(row: Any) -> str | None:
    """The first key of a record, where it is a text."""
    first = next(iter(row.values()), None) if isinstance(row, Mapping) else None
    return first if isinstance(first, str) else None


def _names_of(rows: Sequence[Any]) -> list[str] | None:
    """The names of the records of a list, where each has one."""
    names = [name for row in rows if (name := _name_of(row)) is not None]
    return names if len(names) == len(rows) else None


def _listed(places: Sequence[int]) -> str:
    return f"{', '.join(f'[{place}]' for place in places[:-1])} or [{places[-1]}]"


def _identity(record: Mapping[str, Any], outer: Mapping[str, Any]) -> dict[str, Any]:
    """The first key of a record of a list that names it; none of a whole answer."""
    if "schema_version" in record:
        return {}
    for key, value in record.items():
        if isinstance(value, (str, int)) and not isinstance(value, bool):
            return {} if key in outer else {key: value}
    return {}


def _tables(value: Any, path: str) -> dict[str, bool]:
    """Lists by the keys that lead to them, and whether they have rows."""
    found: dict[str, bool] = {}

    def add(names: dict[str, bool]) -> None:
        found.update({name: rows or found.get(name, False) for name, rows in names.items()})

    for key, inner in value.items():
        place = f"{path}.{key}" if path else key
        if isinstance(inner, dict):
            if _columns(inner):
                add({place: True})
            add(_tables(inner, place))
        elif isinstance(inner, list) and (not inner or isinstance(inner[0], dict)):
            add({place: bool(inner)})
            for row in inner:
                add(_tables(row, place))
    return found


def _flat(record: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    for key, value in record.items():
        if isinstance(value, Mapping):
            yield from _flat(value, f"{prefix}{key}_")
        elif isinstance(value, (list, Records)) and len(value) and isinstance(value[0], Mapping):
            continue
        else:
            yield f"{prefix}{key}", value


def _flat_rows(rows: Sequence[tuple[dict[str, Any], Any]]) -> list[dict[str, Any]]:
    flat = []
    for outer, row in rows:
        own = dict(_flat(row)) if isinstance(row, Mapping) else {"value": row}
        flat.append({**{key: value for key, value in outer.items() if key not in own}, **own})
    # A record that is absent in one row and present in another has its keys in both.
    keys = list(dict.fromkeys(key for row in flat for key in row))
    parents = {key for key in keys if any(other.startswith(f"{key}_") for other in keys)}
    absent = {key for key in parents if all(row.get(key) is None for row in flat)}
    # An empty list of records is no column.
    lists = {key for key in keys if all(row.get(key, []) == [] for row in flat) and any(key in row for row in flat)}
    return [{key: row.get(key) for key in keys if key not in absent | lists} for row in flat]


def _columns(record: Mapping[str, Any], prefix: str = "") -> dict[str, list[Any]] | None:
    """Lists of numbers of one length, by the names that lead to them; ``None`` where there are no such."""
    found: dict[str, list[Any]] = {}
    for key, value in record.items():
        if isinstance(value, list) and value and isinstance(value[0], (int, float)):
            found[f"{prefix}{key}"] = value
        elif isinstance(value, list) and value and isinstance(value[0], dict):
            for row in value:
                inner = _columns(row, f"{prefix}{key}.{_name_of(row)}.")
                if inner is None:
                    return None
                found.update(inner)
        elif isinstance(value, dict):
            return None
    is_table = len({len(column) for column in found.values()}) == 1
    return found if is_table and (prefix or len(found) > 1) else None


def _short(value: Any) -> str:
    if isinstance(value, Records):
        return f"[{len(value)} records]"
    if isinstance(value, Record):
        return "{…}"
    text = repr(value)
    return text if len(text) <= 60 else f"{text[:57]}…"


def _cell(value: Any) -> str:
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.5g}".replace("-", "−")
    if isinstance(value, (list, tuple)):
        return html.escape(", ".join(_cell(one) for one in value))
    return html.escape(str(value))


def _shown(value: Any) -> Any:
    """Fractions as people write them."""
    if isinstance(value, dict):
        if value.keys() == {"numerator", "denominator"}:
            whole = value["denominator"] == 1
            return str(value["numerator"]) if whole else f"{value['numerator']}/{value['denominator']}"
        return {key: _shown(inner) for key, inner in value.items()}
    return [_shown(inner) for inner in value] if isinstance(value, list) else value


def _table_html(rows: list[dict[str, Any]]) -> str:
    if not rows:
        return "<p>–</p>"
    keys = [key for key in rows[0] if any(row[key] is not None for row in rows)]
    head = "".join(f"<th>{html.escape(key)}</th>" for key in keys)
    body = "".join(
        "<tr>" + "".join(f"<td>{_cell(row[key])}</td>" for key in keys) + "</tr>" for row in rows[:_MOST_ROWS]
    )
    more = f"<p>… {len(rows) - _MOST_ROWS} more rows</p>" if len(rows) > _MOST_ROWS else ""
    return f"<div style='overflow-x: auto'><table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>{more}"


def _html(record: Record) -> str:
    plain = _shown(record.to_dict())
    warnings = plain.pop("warnings", [])
    facts = [(key, value) for key, value in _flat(plain) if value not in (None, []) and key != "schema_version"]
    parts = []
    for key, value in plain.items():
        if isinstance(value, list) and value and isinstance(value[0], dict):
            parts.append(f"<h4>{html.escape(key)}</h4>{_table_html(_flat_rows([({}, row) for row in value]))}")
    rows = "".join(f"<tr><th>{html.escape(key)}</th><td>{_cell(value)}</td></tr>" for key, value in facts)
    told = "".join(f"<p><strong>Warning:</strong> {html.escape(one['message'])}</p>" for one in warnings)
    return f"<table><tbody>{rows}</tbody></table>{told}{''.join(parts)}"


def parsed(text: bytes | str) -> dict[str, Any]:
    """JSON of an answer; ``NaN`` and ``Infinity`` are no JSON and refused."""

    def refuse(constant: str) -> Any:
        raise ValueError(f"{constant} in an answer; this is an error of epicyclic")

    found: dict[str, Any] = json.loads(text, parse_constant=refuse)
    return found
