"""Gearboxes, built in Python or read from YAML."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from inspect import signature
from os import PathLike, fspath
from typing import Any, Self, TypeVar, Unpack

import numpy as np
from numpy.typing import ArrayLike

from . import commands
from ._call import Progress
from .description import Description, built, content_of, yaml_of
from .errors import NothingFound, Refused
from .records import Answer
from .shown import Drawing, Page
from .sweeps import PointSweep, RatioSweep, points, ratios

__all__ = ["Gearbox"]

Asked = TypeVar("Asked")


class Gearbox(Description):
    """A planetary gearbox: planet sets, the links that tie them, brakes, clutches and gears.

    Nothing is checked before the first question is asked of it; a fault is then told with its place in the file, or in
    :attr:`yaml`.

    Parameters
    ----------
    name
        Its name.
    input, output
        Links where power enters and leaves. A link is what turns as one piece, ``"ground"`` is the housing.
    sets
        Planet sets, each a mapping with the keys of a file: ``id``, the links ``sun``, ``ring`` and ``carrier``, and
        ``k`` (the ring-to-sun ratio of a simple set) or ``teeth=[sun, ring]``; optionally ``kind``, ``efficiency`` and
        others. Two members that name one link are one piece.
    brakes
        Links that are held, by the names of the brakes: ``{"K1": "T1"}``.
    clutches
        Pairs of links that are joined: ``{"L": ("D", "B")}``. A one-way clutch is ``{"F": {"one_way": ("a", "b")}}``:
        ``a`` cannot turn slower than ``b``.
    gears
        Engaged elements by the names of the gears: ``{"1": ["K1"]}``. A mapping says more:
        ``{"R": {"engaged": ["K2"], "output": "x"}}``.
    **keys
        Other keys of a file: ``compound_sets``, ``links``, ``grounds``, ``duty`` and so on, as lists and mappings.
        Quantities are texts with a unit: ``"30 mm"``.

    Examples
    --------
    >>> box = Gearbox(
    ...     "conveyor",
    ...     input="D",
    ...     output="B",
    ...     sets=[{"id": "P", "sun": "D", "ring": "T1", "carrier": "B", "k": 2.94, "efficiency": 0.97}],
    ...     brakes={"K1": "T1"},
    ...     clutches={"K2": ("D", "B")},
    ...     gears={"slow": ["K1"], "fast": ["K2"]},
    ... )
    >>> round(box.analyze().gears["slow"].ratio, 9)
    3.94
    """

    def __init__(
        self,
        name: str,
        *,
        input: str,
        output: str,
        sets: Iterable[Mapping[str, Any]] = (),
        brakes: Mapping[str, str] | Iterable[Mapping[str, Any]] = (),
        clutches: Mapping[str, Any] | Iterable[Mapping[str, Any]] = (),
        gears: Mapping[str, Any] | Iterable[Mapping[str, Any]] = (),
        **keys: Any,
    ) -> None:
        described: dict[str, Any] = {"gearbox": name, "input": input, "output": output, "sets": [*sets]}
        described["brakes"] = _entries(brakes, "id", lambda link: {"link": link})
        described["clutches"] = _entries(clutches, "id", lambda links: {"links": links})
        described["gears"] = _entries(gears, "name", lambda engaged: {"engaged": engaged})
        described.update(keys)
        text = yaml_of({key: value for key, value in described.items() if not _is_empty(value)})
        self._keep(built(name), text.encode(), name)

    @classmethod
    def read(
        cls, file: str | PathLike[str], *, transmission: str | None = None, efficiency: float | str | None = None
    ) -> Self:
        """The gearbox of a YAML file.

        Parameters
        ----------
        file
            Its name.
        transmission
            Of a list of transmissions, the one that has this in its name.
        efficiency
            With the carrier fixed, of each set for which the file states no losses: 0.97 or ``"97 %"``.

        Raises
        ------
        FileFailure
            The file cannot be read.
        """
        path = fspath(file)
        return cls.from_yaml(content_of(path), file=path, transmission=transmission, efficiency=efficiency)

    @classmethod
    def from_yaml(
        cls,
        text: str | bytes,
        *,
        file: str = "text",
        transmission: str | None = None,
        efficiency: float | str | None = None,
    ) -> Self:
        """A gearbox of a text in YAML; ``file`` is what messages call it. The rest is as for :meth:`read`."""
        box = super().from_yaml(text, file=file)
        options = {"transmission": transmission, "efficiency": efficiency}
        box._options = {key: value for key, value in options.items() if value is not None}
        box._name = transmission or box._name
        return box

    def _asked(self, function: Callable[..., Asked], options: Mapping[str, Any]) -> Asked:
        """What a command answers; of what the gearbox was read with it gets what it takes."""
        takes = signature(function).parameters
        return function(self, **{**{key: value for key, value in self._options.items() if key in takes}, **options})

    def analyze(self, **options: Unpack[commands.AnalyzeOptions]) -> Answer:
        """States, ratios, speeds, torques, powers and losses of its gears; options as of :func:`epicyclic.analyze`.

        >>> box.analyze(gear="1", torque="500 N·m").gear.efficiency  # doctest: +SKIP
        """
        return self._asked(commands.analyze, options)

    def report(self, **options: Unpack[commands.ReportOptions]) -> Page:
        """A page about it; options as of :func:`epicyclic.report`."""
        return self._asked(commands.report, options)

    def losses(self, **options: Unpack[commands.LossesOptions]) -> Answer:
        """What heats it at work; options as of :func:`epicyclic.losses`."""
        return self._asked(commands.losses, options)

    def strength(self, **options: Unpack[commands.StrengthOptions]) -> Answer:
        """Safeties of its teeth by ISO 6336; options as of :func:`epicyclic.strength`."""
        return self._asked(commands.strength, options)

    def sheet(self, **options: Unpack[commands.SheetOptions]) -> Answer:
        """Data sheets of its gears; options as of :func:`epicyclic.sheet`."""
        return self._asked(commands.sheet, options)

    def size(self, **options: Unpack[commands.SizeOptions]) -> Answer:
        """Sizes of its sets that hold over the duty of its description; options as of :func:`epicyclic.size`."""
        return self._asked(commands.size, options)

    def vibrate(self, **options: Unpack[commands.VibrateOptions]) -> Answer:
        """Natural frequencies, modes and resonances of its sets; options as of :func:`epicyclic.vibrate`."""
        return self._asked(commands.vibrate, options)

    def draw(self, **options: Unpack[commands.DrawOptions]) -> Drawing:
        """A drawing; options as of :func:`epicyclic.draw`.

        >>> box.draw(gear="2", power=True)  # doctest: +SKIP
        """
        # Losses change nothing but the flow of power.
        own = self._options if options.get("power") else {**self._options, "efficiency": None}
        return commands.draw(self, **{**{key: value for key, value in own.items() if value is not None}, **options})

    def sweep(
        self,
        k: Mapping[str, ArrayLike],
        *,
        gears: Sequence[str] | None = None,
        progress: Progress | None = None,
    ) -> RatioSweep:
        """States, ratios and efficiencies of its gears for arrays of ``k`` of its sets, in one call.

        Parameters
        ----------
        k
            ``|i₀|`` by the name of the set, of a simple set the ring-to-sun ratio. Arrays of shapes that broadcast to
            one shape ``S``: ``{"1": k1[:, None], "2": k2}`` is a grid. Sets that are not named keep their ratio.
        gears
            Names of ``G`` gears; all unless given.
        progress
            Called with a line of text now and then.

        Returns
        -------
        RatioSweep
            Arrays of shape ``S + (G,)``. Where there is no ratio or efficiency the array is masked, and ``state`` says
            why; nothing is ever NaN.

        Raises
        ------
        Refused
            A ``k`` that its kind of set cannot have (with the place of the variant), a set or gear that does not exist,
            a set described gear by gear; :attr:`name` tells them apart.

        Notes
        -----
        Losses are those of the description and do not change with ``k``. The lock of Python is released, all cores
        work, and Ctrl-C ends it.
        """
        return ratios(self._file, self._text, self._options, k, gears, progress)

    def points(
        self,
        gear: str,
        speeds_rad_s: Mapping[str, ArrayLike],
        torques_n_m: Mapping[str, ArrayLike] | None = None,
        *,
        progress: Progress | None = None,
    ) -> PointSweep:
        """One gear at arrays of speeds and torques of its links, in one call.

        Parameters
        ----------
        gear
            The gear.
        speeds_rad_s
            Speeds by link, rad/s, positive along the axis: as many links as the gear keeps freedoms, one of a gear
            with one input. Arrays that broadcast to one shape ``S``.
        torques_n_m
            Torques from outside by link, N·m: as many as settle the others. Without them the speeds alone.
        progress
            Called with a line of text now and then.

        Returns
        -------
        PointSweep
            Arrays of shape ``S``, and ``S + (links,)`` or ``S + (terminals,)``.

        Raises
        ------
        Refused
            Speeds or torques that are too few, too many or dependent; a link or gear that does not exist.
        """
        return points(self._file, self._text, self._options, gear, speeds_rad_s, torques_n_m or {}, progress)

    def _repr_svg_(self) -> str | None:
        try:
            return self.draw().svg
        except (NothingFound, Refused):
            # It crosses itself, or cannot be read: its other form says that it is a gearbox, an analysis says why.
            return None


def _entries(given: Any, name: str, of: Callable[[Any], dict[str, Any]]) -> list[Any]:
    if not isinstance(given, Mapping):
        return [*given]
    return [{name: key, **(value if isinstance(value, Mapping) else of(value))} for key, value in given.items()]


def _is_empty(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and not value
