"""Many variants or operating points of a gearbox in one call, as arrays."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from .errors import Refused, of_record
from .records import parsed

__all__ = ["STATES", "PointSweep", "RatioSweep"]

STATES = (
    "driven",
    "torques indeterminate",
    "self-locking",
    "input blocked",
    "output at rest",
    "output free",
    "underdetermined",
)
"""Names of the codes in :attr:`RatioSweep.state`."""


class _Described(NamedTuple):
    """The description of a gearbox, as the compiled part takes it."""

    file_name: str
    file: bytes
    transmission: str | None
    efficiency: str | None


Masked = np.ma.MaskedArray[Any, np.dtype[np.float64]]


class RatioSweep:
    """What the gears of a gearbox do for arrays of ``k`` of its sets.

    ``S`` is the shape of the variants, ``G`` the number of gears; the last axis of every array is that of ``gears``.
    """

    gears: list[str]
    """The gears."""
    k: dict[str, NDArray[np.float64]]
    """``k`` of the sets, each of shape ``S``."""
    ratio: Masked
    """``i = ω_in/ω_out``, shape ``S + (G,)``; masked where the output's speed does not follow from the input's."""
    efficiency: Masked
    """Driven from the input, shape ``S + (G,)``; masked where none follows, or no torque moves the gear."""
    state: NDArray[np.uint8]
    """Places in :data:`STATES`, shape ``S + (G,)``."""

    def __init__(
        self, gears: list[str], k: dict[str, NDArray[np.float64]], ratio: Masked, efficiency: Masked, state: NDArray[np.uint8]
    ) -> None:
        self.gears, self.k, self.ratio, self.efficiency, self.state = gears, k, ratio, efficiency, state

    @property
    def states(self) -> NDArray[np.str_]:
        """The states by name, shape ``S + (G,)``."""
        return np.asarray(STATES)[self.state]

    @property
    def driven(self) -> NDArray[np.bool_]:
        """Where a gear is driven, shape ``S + (G,)``."""
        return np.asarray(self.state == 0)

    def gear(self, name: str) -> int:
        """Place of a gear on the last axis."""
        if name not in self.gears:
            raise KeyError(f"{name!r}: there are {', '.join(self.gears)}")
        return self.gears.index(name)

    def table(self) -> dict[str, Any]:
        """Columns of one row for each variant and gear: ``k_…`` of the sets, ``gear``, ``state``, ``ratio``, ``efficiency``.

        ``pandas.DataFrame`` and ``polars.DataFrame`` take it; ratios and efficiencies that do not exist are
        ``None`` there.
        """
        count = len(self.gears)
        variants = self.state.size // count if count else 0
        columns: dict[str, Any] = {f"k_{name}": np.repeat(values.ravel(), count) for name, values in self.k.items()}
        columns["gear"] = np.tile(np.asarray(self.gears), variants)
        columns["state"] = self.states.ravel()
        for name, values in (("ratio", self.ratio), ("efficiency", self.efficiency)):
            columns[name] = _column(values)
        return columns

    def __repr__(self) -> str:
        shape = self.state.shape[:-1]
        return f"<RatioSweep of {len(self.gears)} gears for {' × '.join(map(str, shape)) or '1'} variants>"


class PointSweep:
    """One gear at arrays of speeds and torques. ``S`` is the shape of the points."""

    links: list[str]
    """The links on the last axis of :attr:`speed_rad_s`."""
    speed_rad_s: Masked
    """Speeds of the links, shape ``S + (links,)``; masked where they do not follow."""
    terminals: list[str]
    """Links where torque acts from outside; none without torques."""
    torque_n_m: Masked
    """Torques there, shape ``S + (terminals,)``; masked where no torque keeps the gear moving."""
    power_w: Masked
    """Powers that enter there, negative where they leave; shape and mask as of the torques."""
    loss_w: Masked
    """What the meshes take, shape ``S``."""
    efficiency: Masked
    """Power that leaves over power that enters, shape ``S``; masked where none enters."""

    def __init__(self, **arrays: Any) -> None:
        self.__dict__.update(arrays)

    def speed(self, link: str) -> Masked:
        """Speeds of a link, rad/s, shape ``S``."""
        if link not in self.links:
            raise KeyError(f"{link!r}: there are {', '.join(self.links)}")
        return self.speed_rad_s[..., self.links.index(link)]

    def torque(self, terminal: str) -> Masked:
        """Torques at a terminal, N·m, shape ``S``."""
        if terminal not in self.terminals:
            raise KeyError(f"{terminal!r}: there are {', '.join(self.terminals) or 'none, since no torque was given'}")
        return self.torque_n_m[..., self.terminals.index(terminal)]

    def table(self) -> dict[str, Any]:
        """Columns of one row for each point; ``pandas.DataFrame`` and ``polars.DataFrame`` take it."""
        columns = {f"speed_{link}_rad_s": _column(self.speed(link)) for link in self.links}
        for place, link in enumerate(self.terminals):
            columns[f"torque_{link}_n_m"] = _column(self.torque_n_m[..., place])
            columns[f"power_{link}_w"] = _column(self.power_w[..., place])
        if self.terminals:
            columns |= {"loss_w": _column(self.loss_w), "efficiency": _column(self.efficiency)}
        return columns

    def __repr__(self) -> str:
        return f"<PointSweep of {self.loss_w.size} points>"


def _column(values: Masked) -> Any:
    """An array where all values exist; else a list with ``None``."""
    flat = values.ravel()
    if not np.ma.is_masked(flat):
        return np.asarray(flat)
    # A list: of an array of objects neither frame makes numbers.
    return flat.tolist()


def _columns(named: Mapping[str, ArrayLike], what: str) -> tuple[dict[str, NDArray[np.float64]], tuple[int, ...]]:
    if not isinstance(named, Mapping):
        raise TypeError("arrays by name are due: {'1': [2.0, 3.0]}")
    arrays = {}
    for name, values in named.items():
        if np.ma.is_masked(values):
            raise Refused(f"{what} {name!r}: masked values", name="masked")
        try:
            arrays[str(name)] = np.asarray(values, dtype=np.float64)
        except (TypeError, ValueError) as error:
            raise Refused(f"{what} {name!r}: numbers are due, {error}", name="not-a-number") from error
    try:
        shape = np.broadcast_shapes(*(values.shape for values in arrays.values()))
    except ValueError as error:
        shapes = ", ".join(f"{name} {values.shape}" for name, values in arrays.items())
        raise Refused(f"the shapes do not broadcast to one: {shapes}", name="swept-length") from error
    return {name: np.broadcast_to(values, shape) for name, values in arrays.items()}, shape


def _flat(columns: Mapping[str, NDArray[np.float64]]) -> list[tuple[str, NDArray[np.float64]]]:
    return [(name, np.ascontiguousarray(values).ravel()) for name, values in columns.items()]


def _refused(refusal: str) -> Exception:
    return of_record(parsed(refusal)["error"] if "error" in parsed(refusal) else parsed(refusal))


def _efficiency(options: Mapping[str, Any]) -> str | None:
    given = options.get("efficiency")
    return None if given is None else str(given)


def ratios(
    file: str,
    text: bytes,
    options: Mapping[str, Any],
    k: Mapping[str, ArrayLike],
    gears: Sequence[str] | None,
    progress: Callable[[str], Any] | None,
) -> RatioSweep:
    """:meth:`epicyclic.Gearbox.sweep`."""
    if isinstance(gears, str):
        gears = [gears]
    columns, shape = _columns(k, "k of set")
    described = _Described(file, text, options.get("transmission"), _efficiency(options))
    found, refusal = _core.sweep(described, [*(gears or [])], _flat(columns), progress)
    if found is None:
        raise _refused(refusal or "")
    names, (states, values, has_ratio, efficiencies, has_efficiency) = found
    whole = (*shape, len(names))
    return RatioSweep(
        names,
        columns,
        np.ma.masked_array(values.reshape(whole), ~has_ratio.reshape(whole)),
        np.ma.masked_array(efficiencies.reshape(whole), ~has_efficiency.reshape(whole)),
        states.reshape(whole),
    )


def points(
    file: str,
    text: bytes,
    options: Mapping[str, Any],
    gear: str,
    speeds_rad_s: Mapping[str, ArrayLike],
    torques_n_m: Mapping[str, ArrayLike],
    progress: Callable[[str], Any] | None,
) -> PointSweep:
    """:meth:`epicyclic.Gearbox.points`."""
    together = {("speed of", name): values for name, values in speeds_rad_s.items()}
    both, shape = _columns(
        {f"{kind}\0{name}": values for (kind, name), values in together.items()}
        | {f"torque at\0{name}": values for name, values in torques_n_m.items()},
        "column",
    )
    split: dict[str, dict[str, NDArray[np.float64]]] = {"speed of": {}, "torque at": {}}
    for key, values in both.items():
        kind, name = key.split("\0")
        split[kind][name] = values
    described = _Described(file, text, options.get("transmission"), _efficiency(options))
    found, refusal = _core.points(described, gear, _flat(split["speed of"]), _flat(split["torque at"]), progress)
    if found is None:
        raise _refused(refusal or "")
    links, terminals, columns = found
    speeds, has_speed, torques, powers, moves, losses, efficiencies, has_efficiency = columns
    by_link, by_terminal = (*shape, len(links)), (*shape, len(terminals))
    at_rest = np.repeat(~moves, len(terminals)).reshape(by_terminal)
    return PointSweep(
        links=links,
        terminals=terminals,
        speed_rad_s=np.ma.masked_array(speeds.reshape(by_link), np.broadcast_to(~has_speed, by_link)),
        torque_n_m=np.ma.masked_array(torques.reshape(by_terminal), at_rest),
        power_w=np.ma.masked_array(powers.reshape(by_terminal), at_rest),
        loss_w=np.ma.masked_array(losses.reshape(shape), ~moves.reshape(shape)),
        efficiency=np.ma.masked_array(efficiencies.reshape(shape), ~has_efficiency.reshape(shape)),
    )
