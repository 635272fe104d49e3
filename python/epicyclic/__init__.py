"""Planetary gear mechanisms: gearboxes of several speeds, tooth numbers, strength, motion, vibration, hydromotors.

Every command of the command line is a function of the same name, with its options as arguments; the answer is its record,
with numbers in SI units that stand in the names:

>>> import epicyclic
>>> epicyclic.analyze("II-3", k1=2.15, k2=2.354).gears["2"].ratio
2.56

A :class:`Gearbox` is built in Python or read from YAML, draws itself in a notebook, and takes arrays:

>>> import numpy as np
>>> box = epicyclic.Gearbox(
...     "conveyor", input="D", output="B", brakes={"K1": "T1"}, gears={"slow": ["K1"]},
...     sets=[{"id": "P", "sun": "D", "ring": "T1", "carrier": "B", "k": 2.94}],
... )
>>> box.sweep({"P": np.array([2.0, 3.0])}).ratio[:, 0].tolist()
[3.0, 4.0]

What is refused is an exception with the message of the command line: :class:`Refused`, :class:`NothingFound`,
:class:`FileFailure`, each a kind of :class:`Error`.
"""

from ._core import __version__
from .commands import *
from .commands import __all__ as _commands
from .description import Description
from .errors import Error, Fault, FileFailure, NothingFound, Place, Refused
from .gearbox import Gearbox
from .records import Answer, Record, Records
from .shown import Drawing, Page
from .sweeps import STATES, PointSweep, RatioSweep

__all__ = [
    "STATES",
    "Answer",
    "Description",
    "Drawing",
    "Error",
    "Fault",
    "FileFailure",
    "Gearbox",
    "NothingFound",
    "Page",
    "Place",
    "PointSweep",
    "RatioSweep",
    "Record",
    "Records",
    "Refused",
    "__version__",
    *_commands,
]
