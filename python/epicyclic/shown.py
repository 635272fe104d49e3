"""What a notebook shows of an answer: drawings and pages."""

from __future__ import annotations

from collections.abc import Callable
from html import escape
from os import PathLike
from pathlib import Path

from .records import Answer

__all__ = ["Drawing", "Page"]


class Drawing:
    """A drawing, shown in a notebook as it is."""

    def __init__(self, svg: str, answer: Answer, redraw: Callable[[str], bytes]) -> None:
        self.svg = svg
        """The drawing as SVG."""
        self.answer = answer
        """What it shows, as a record."""
        self._redraw = redraw

    def _repr_svg_(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"<Drawing, {len(self.svg)} characters of SVG>"

    def save(self, file: str | PathLike[str]) -> None:
        """Writes it as SVG, DXF, PDF or PNG, by the end of the name."""
        path = Path(file)
        is_this = path.suffix.lower() == ".svg"
        path.write_bytes(self.svg.encode() if is_this else self._redraw(path.name))


class Page:
    """A page to read and print, whole in itself."""

    def __init__(self, html: str, answer: Answer) -> None:
        self.html = html
        """The page as HTML."""
        self.answer = answer
        """The answers that it is made from, as a record."""

    def _repr_html_(self) -> str:
        # In a frame, so that its style and that of the notebook do not meet.
        return f'<iframe srcdoc="{escape(self.html)}" style="width: 100%; height: 40em; border: 0"></iframe>'

    def __repr__(self) -> str:
        return f"<Page, {len(self.html)} characters of HTML>"

    def save(self, file: str | PathLike[str]) -> None:
        """Writes it to a file."""
        Path(file).write_text(self.html, encoding="utf-8")
