"""The command line and Python agree: every call of the README, the book and the help, with the same words."""

from __future__ import annotations

import dataclasses
import json
import keyword
import math
import os
import re
import shlex
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT

import epicyclic
from epicyclic import _core

COMMANDS: dict[tuple[str, ...], dict[str, Any]] = {tuple(one["path"]): one for one in json.loads(_core.commands())}
NUMBERS = 1e-12


def lines() -> list[str]:
    pages = [ROOT / "README.md", *sorted((ROOT / "docs" / "src").rglob("*.md"))]
    found = [
        match[1]
        for page in pages
        for match in re.finditer(r"^\$ cargo run -q -p epicyclic -- (.*)$", page.read_text(encoding="utf-8"), re.M)
    ]
    for command in COMMANDS.values():
        found += re.findall(r"^  epicyclic (.*)$", command["after_help"].replace("\\\n", " "), re.M)
    # Files that the help writes by the shell are not there.
    return sorted({line for line in found if "box.yaml" not in line and "|" not in line and ">" not in line})


def understood(line: str) -> tuple[tuple[str, ...], list[str], dict[str, Any]] | None:
    """A line as a function's name and arguments; nothing where its answer has no record."""
    words = shlex.split(line)
    path = max((path for path in COMMANDS if tuple(words[: len(path)]) == path), key=len, default=None)
    if path is None:
        return None
    command = COMMANDS[path]
    known = {f"--{one['long']}": one for one in command["arguments"] if one["long"]}
    if "--format" not in known:
        return None
    positional: list[str] = []
    options: dict[str, Any] = {}
    rest = words[len(path) :]
    while rest:
        word = rest.pop(0)
        if word == "-o":
            rest.pop(0)
            continue
        if not word.startswith("--"):
            positional.append(word)
            continue
        name, _, value = word.partition("=")
        option = known.get(name)
        if option is None:
            return None
        if option["is_flag"]:
            given: Any = True
        else:
            given = value or rest.pop(0)
        if name in {"--format", "--output"}:
            continue
        key = option["long"].replace("-", "_")
        key += "_" if keyword.iskeyword(key) else ""
        if option["is_many"]:
            options.setdefault(key, []).append(given)
        else:
            options[key] = given
    return path, positional, options


LINES = [line for line in lines() if understood(line)]


def differences(cli: Any, python: Any, place: str = "") -> list[str]:
    """Integers, fractions and words exactly, other numbers relatively."""
    if isinstance(cli, dict) and isinstance(python, dict):
        keys = [] if cli.keys() == python.keys() else [f"{place}: keys {set(cli) ^ set(python)}"]
        return keys + [one for key in cli.keys() & python.keys() for one in differences(cli[key], python[key], f"{place}.{key}")]
    if isinstance(cli, list) and isinstance(python, list):
        length = [] if len(cli) == len(python) else [f"{place}: {len(cli)} and {len(python)}"]
        return length + [one for at, pair in enumerate(zip(cli, python)) for one in differences(*pair, f"{place}[{at}]")]
    if isinstance(cli, float) and isinstance(python, float):
        return [] if math.isclose(cli, python, rel_tol=NUMBERS, abs_tol=0.0) else [f"{place}: {cli} and {python}"]
    return [] if type(cli) is type(python) and cli == python else [f"{place}: {cli!r} and {python!r}"]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the examples, where files may be written."""
    folder = tmp_path_factory.mktemp("agreement")
    (folder / "examples").symlink_to(ROOT / "examples")
    (folder / "docs").symlink_to(ROOT / "docs")
    return folder


def test_there_are_many_examples_of_every_command_with_a_record() -> None:
    commands = {understood(line)[0][0] for line in LINES}  # type: ignore[index]
    assert len(LINES) > 100
    assert commands >= {"analyze", "select", "synthesize", "size", "simulate", "vibrate", "motor", "strength", "teeth"}


@pytest.mark.parametrize("line", LINES)
def test_python_answers_as_the_command_line(line: str, folder: Path, program: str, monkeypatch: Any) -> None:
    monkeypatch.chdir(folder)
    path, positional, options = understood(line)  # type: ignore[misc]
    words = shlex.split(line)
    for option in ("-o", "--output", "--format"):
        while option in words:
            at = words.index(option)
            del words[at : at + 2]
    words = [word for word in words if not word.startswith(("--format=", "--output="))]
    if path == ("report",):
        # Of a page alone; JSON is refused with them.
        words = [word for word in words if word != "--to-scale"]
        for option in ("--project", "--customer", "--author", "--date", "--paper"):
            while option in words:
                at = words.index(option)
                del words[at : at + 2]
    if path == ("draw",):
        words += ["--output", "drawing.svg"]
    # Both at a time: what is called from Python does not hold its lock.
    started = ThreadPoolExecutor(1).submit(
        subprocess.run,
        [program, *words, "--format", "json"],
        capture_output=True,
        cwd=folder,
        env={**os.environ, "COLUMNS": "80"},
    )
    function = getattr(epicyclic, "_".join(part.replace("-", "_") for part in path))
    try:
        answer = function(*positional, **options)
    except epicyclic.Error as error:
        called = started.result()
        assert called.returncode == error.exit_code, called.stderr.decode()
        if called.stdout:
            record = json.loads(called.stdout)
            if record["answer"] != "error":
                # The reasons are the answer.
                assert error.exit_code == 1 and differences(record, error.answer.to_dict()) == []
                assert error.message in called.stderr.decode()
                return
            assert (record["name"], record["message"]) == (error.name, error.message)
            assert record["option"] == error.option
            place = record["place"]
            assert place == (error.place and vars(error.place)), line
            assert record["faults"] == [dataclasses.asdict(fault) for fault in error.faults], line
        else:
            assert error.message in called.stderr.decode()
        return
    called = started.result()
    assert called.returncode == 0, called.stderr.decode()
    record = answer if isinstance(answer, epicyclic.Answer) else answer.answer
    assert differences(json.loads(called.stdout), record.to_dict()) == []
