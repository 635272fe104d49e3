"""A call of the command line: the same words, the same answer."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from os import PathLike, fspath
from typing import Any, Union

import numpy as np

from . import _core
from .description import Description
from .errors import Error, Refused, of_messages, of_record
from .records import Answer, parsed
from .shown import Drawing, Page

Value = Union[str, int, float, "np.number[Any]"]
"""A value of an option: a number, or a text as on the command line. A quantity is a text with a unit: ``"500 N·m"``."""

Values = Union[Value, Sequence[Value], Mapping[str, Value]]
"""One value or several; of an option that takes values by name (``{"engine": "2000 rpm"}``) a mapping."""

Source = Union[str, "PathLike[str]", Description]
"""What a command reads: a :class:`Gearbox` or another :class:`Description`, the name of a YAML file, or a scheme of the
catalogue by its name."""

Path = Union[str, "PathLike[str]"]
"""The name of a file."""

Progress = Callable[[str], Any]
"""Called with a line of text now and then while long work runs."""

NO_ANSWER = 130


def _word(value: Any, files: dict[str, bytes], option: str) -> str:
    if isinstance(value, Description):
        files.update(value._files)
        return value._file
    if isinstance(value, (bool, np.bool_)):
        raise Refused(f"{value}: a number or text is due", name="usage", option=option)
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float):
        return repr(value)
    if isinstance(value, int):
        return str(value)
    if isinstance(value, (str, PathLike)):
        return fspath(value)
    raise Refused(f"{value!r}: a number or text is due", name="usage", option=option)


def line(
    command: Sequence[str],
    words: Iterable[Any],
    options: Mapping[str, Any],
    many: Mapping[str, str] | None = None,
) -> tuple[list[str], dict[str, bytes]]:
    """The words of a call, and the files that stand in Python's memory."""
    files: dict[str, bytes] = {}
    found = list(command)
    for option, value in options.items():
        if value is None or value is False:
            continue
        if value is True:
            found.append(option)
            continue
        if isinstance(value, Mapping):
            value = [f"{name}={_word(inner, files, option)}" for name, inner in value.items()]
        if isinstance(value, (list, tuple, np.ndarray)):
            each = [_word(one, files, option) for one in value]
            texts = each if option in (many or {}) else [", ".join(each)]
        else:
            texts = [_word(value, files, option)]
        found += [f"{option}={text}" for text in texts]
    given = [word for word in words if word is not None]
    positional = []
    for word in given:
        several = isinstance(word, (list, tuple))
        positional += [_word(one, files, "") for one in word] if several else [_word(word, files, "")]
    # What looks like an option is a name where it stands behind this.
    if any(word.startswith("-") for word in positional):
        found.append("--")
    return found + positional, files


def run(
    words: Sequence[str], files: Mapping[str, bytes], progress: Progress | None, kept: Sequence[str] = ()
) -> tuple[bytes, bytes, dict[str, bytes]]:
    """The answer of the command line, its record as JSON, and the files it writes under the names in ``kept``.

    With ``--format=json`` the answer itself is the record, unless it goes to a file.

    Raises
    ------
    Error
        Of the kind that the exit code says.
    """
    code, answer, record, messages, written = _core.call([*words], dict(files), [*kept], progress)
    record = answer if record is None else record
    if code == 0:
        return answer, record, written
    if code == NO_ANSWER:
        raise KeyboardInterrupt
    raise _error(code, record, messages)


def _error(code: int, answer: bytes, messages: str) -> Error:
    if answer.startswith(b"{"):
        record = parsed(answer)
        if record.get("answer") == "error":
            return of_record(record)
        error = of_messages(code, messages)
        error.answer = Answer(record)
        return error
    return of_messages(code, messages)


def answer(
    command: Sequence[str],
    words: Iterable[Any],
    options: Mapping[str, Any],
    progress: Progress | None = None,
    many: Mapping[str, str] | None = None,
    output: Path | None = None,
) -> Answer:
    """The answer of a command as an object; written to a file, too, where one is named."""
    said, files = line(command, words, options, many)

    def again() -> str:
        return run(said, files, None)[0].decode()

    at = len(command)
    how = "--format=json" if output is None else f"--output={fspath(output)}"
    _, record, _ = run([*said[:at], how, *said[at:]], files, progress)
    return Answer(parsed(record), again)


def text(
    command: Sequence[str],
    words: Iterable[Any],
    options: Mapping[str, Any],
    progress: Progress | None = None,
    many: Mapping[str, str] | None = None,
) -> str:
    """What a command writes that has no record."""
    said, files = line(command, words, options, many)
    return run(said, files, progress)[0].decode()


def drawing(
    command: Sequence[str],
    words: Iterable[Any],
    options: Mapping[str, Any],
    progress: Progress | None = None,
    many: Mapping[str, str] | None = None,
) -> Drawing:
    """A drawing of a command."""
    said, files = line(command, words, options, many)

    def drawn(name: str) -> tuple[bytes, bytes]:
        at = len(command)
        out = ["--format=json", f"--output={name}"]
        _, record, written = run([*said[:at], *out, *said[at:]], files, progress, [name])
        return record, written[name]

    record, svg = drawn("drawing.svg")
    return Drawing(svg.decode(), Answer(parsed(record)), lambda name: drawn(name)[1])


def page(
    command: Sequence[str],
    words: Iterable[Any],
    options: Mapping[str, Any],
    progress: Progress | None = None,
    many: Mapping[str, str] | None = None,
) -> Page:
    """A page of a command."""
    said, files = line(command, words, options, many)
    at, name = len(command), "page.html"
    _, record, written = run([*said[:at], f"--output={name}", *said[at:]], files, progress, [name])
    return Page(written[name].decode(), Answer(parsed(record)))
