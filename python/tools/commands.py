"""Writes ``epicyclic/commands.py`` from the commands of a library that is built: ``commands.py target/debug/lib_core.so``."""

from __future__ import annotations

import json
import keyword
import re
import sys
import textwrap
from importlib.machinery import ExtensionFileLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path
from typing import Any

TARGET = Path(__file__).resolve().parents[1] / "epicyclic" / "commands.py"

HEAD = '''"""Every command of the command line as a function, with its options as arguments.

Written by ``tools/commands.py`` from the options of the program; not by hand.

An option ``--planet-count`` is the argument ``planet_count``. A number is a number, and a quantity is a text with a unit, as
on the command line: ``torque="500 N·m"``. Several values are a list, values by name a mapping:
``speeds={"engine": "2000 rpm", "mg1": "3000 rpm"}``. What does not go together is refused in the words of the command line.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, TypedDict

from . import _call
from ._call import Path, Progress, Source, Values
from .records import Answer
from .shown import Drawing, Page

'''

# Written by the call itself.
OWN = {"format", "help", "version"}
# Those that a gearbox has as methods.
METHODS = {"analyze", "draw", "losses", "report", "sheet", "size", "strength", "vibrate"}
SOURCES = {"gearbox", "file", "files", "gearboxes"}


def name_of(words: str) -> str:
    name = words.replace("-", "_").replace(".", "_").lower()
    return f"{name}_" if keyword.iskeyword(name) else name


def python_words(text: str) -> str:
    """Options as arguments."""
    text = re.sub(r"(?<![\w-])--([a-z][a-z0-9-]*)", lambda found: f"``{name_of(found[1])}``", text)
    return text.replace("\\", "\\\\").strip()


def wrapped(text: str, indent: str) -> str:
    blocks = [textwrap.fill(block, 118, initial_indent=indent, subsequent_indent=indent) for block in text.split("\n\n")]
    return "\n\n".join(blocks)


def kind_of(argument: dict[str, Any]) -> str:
    if argument["is_flag"]:
        return "bool"
    if not argument["long"] and argument["id"] in SOURCES:
        return "Source"
    if argument["choices"]:
        choices = ", ".join(json.dumps(choice, ensure_ascii=False) for choice in argument["choices"])
        return f"Sequence[Literal[{choices}]] | Literal[{choices}]" if argument["is_many"] else f"Literal[{choices}]"
    return "Values"


def function(command: dict[str, Any]) -> str:
    ids = {argument["id"] for argument in command["arguments"]}
    arguments = [argument for argument in command["arguments"] if argument["id"] not in OWN]
    is_drawing = command["path"] == ["draw"]
    has_record = "format" in ids
    is_page = command["path"] == ["report"]
    if has_record or is_drawing:
        arguments = [argument for argument in arguments if argument["id"] != "output"]
    kind, returned = ("drawing", "Drawing") if is_drawing else ("page", "Page") if is_page else ("answer", "Answer") if has_record else ("text", "str")
    positional = [argument for argument in arguments if not argument["long"]]
    options = [argument for argument in arguments if argument["long"]]
    signature, described = [], []
    for argument in positional:
        if argument["is_many"]:
            signature.append(f"    *{name_of(argument['id'])}: {kind_of(argument)},")
            continue
        default = "" if argument["is_required"] else " | None = None"
        signature.append(f"    {name_of(argument['id'])}: {kind_of(argument)}{default},")
    if not any(argument["is_many"] for argument in positional):
        signature.append("    *,")
    for argument in sorted(options, key=lambda one: not one["is_required"]):
        own = kind_of(argument)
        default = " = False" if own == "bool" else "" if argument["is_required"] else " | None = None"
        signature.append(f"    {name_of(argument['long'])}: {own}{default},")
    if kind == "answer":
        signature.append("    output: Path | None = None,")
    signature.append("    progress: Progress | None = None,")
    for argument in [*positional, *options]:
        shown = name_of(argument["long"] or argument["id"])
        described.append(f"    {shown}\n{wrapped(python_words(argument['help']), ' ' * 8)}")
    if kind == "answer":
        described.append(
            "    output\n        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command\n"
            "        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages\n"
            "        show as many rows as on the command line"
        )
    described.append("    progress\n        Called with a line of text now and then while long work runs.")
    words = ", ".join(f"{'*' if argument['is_many'] else ''}{name_of(argument['id'])}" for argument in positional)
    given = ", ".join(f'"--{argument["long"]}": {name_of(argument["long"])}' for argument in options)
    many = {f"--{one['long']}": "repeated" for one in options if one["is_many"]}
    about, *rest = python_words(command["about"]).split("\n\n")
    returns = {
        "answer": "Answer\n        The record of ``--format json``.",
        "drawing": "Drawing\n        As SVG; its ``save`` writes SVG, DXF, PDF and PNG.",
        "page": "Page\n        Shown in a notebook; its ``save`` writes it.",
        "text": "str\n        What the command line writes to standard output.",
    }[kind]
    sentence = about if about.endswith(".") else f"{about}."
    more = "".join(f"\n{wrapped(block, '    ')}\n" for block in rest)
    first, *others = textwrap.wrap(sentence, 110)
    summary = "\n".join([first, *(f"    {line}" for line in others)])
    doc = (
        f'    """{summary}\n{more}\n    Parameters\n    ----------\n'
        + "\n".join(described)
        + f"\n\n    Returns\n    -------\n    {returns}\n"
        + "\n    Raises\n    ------\n    Refused\n        What is given cannot be; with the option or the place in the file.\n"
        + "    NothingFound\n        A sound question without an answer within its bounds.\n"
        + "    FileFailure\n        A file cannot be read or written.\n"
        + '    """'
    )
    path = json.dumps(command["path"])
    tail = f", many={many!r}".replace("'", '"') if many else ""
    tail += ", output=output" if kind == "answer" else ""
    body = f"    return _call.{kind}({path}, [{words}], {{{given}}}, progress{tail})"
    name = "_".join(name_of(part) for part in command["path"])
    return f"def {name}(\n" + "\n".join(signature) + f"\n) -> {returned}:\n{doc}\n{body}\n"


def options(command: dict[str, Any]) -> str:
    """The arguments by name of a command, for the method of a gearbox."""
    arguments = [argument for argument in command["arguments"] if argument["long"] and argument["id"] not in OWN]
    ids = {argument["id"] for argument in command["arguments"]}
    name = "".join(part.capitalize() for part in command["path"])
    lines = [f'class {name}Options(TypedDict, total=False):', f'    """Arguments of :func:`{command["path"][0]}`."""', ""]
    for argument in arguments:
        if argument["id"] == "output":
            continue
        own = kind_of(argument)
        lines.append(f"    {name_of(argument['long'])}: {own}" + ("" if own == "bool" else " | None"))
    if "format" in ids and command["path"] != ["report"]:
        lines.append("    output: Path | None")
    return "\n".join([*lines, "    progress: Progress | None", ""])


def module(library: str) -> str:
    # By its file: the package cannot be imported yet, since it imports what is written here.
    loader = ExtensionFileLoader("_core", library)
    spec = spec_from_loader("_core", loader)
    assert spec is not None
    core = module_from_spec(spec)
    loader.exec_module(core)
    commands = json.loads(core.commands())
    functions = [options(command) for command in commands if command["path"][0] in METHODS]
    functions += [function(command) for command in commands]
    names = ["_".join(name_of(part) for part in command["path"]) for command in commands]
    listed = "__all__ = [\n" + "".join(f"    {json.dumps(name)},\n" for name in sorted(names)) + "]\n\n\n"
    text = HEAD + listed + "\n\n".join(functions)
    return "\n".join(line.rstrip() for line in text.splitlines()) + "\n"


if __name__ == "__main__":
    TARGET.write_text(module(sys.argv[1]), encoding="utf-8")
