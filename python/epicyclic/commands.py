"""Every command of the command line as a function, with its options as arguments.

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

__all__ = [
    "analyze",
    "atlas",
    "compare",
    "design",
    "draw",
    "drive",
    "losses",
    "machine_chain_cutter",
    "machine_drum",
    "machine_list",
    "machine_rotor",
    "machine_speeds",
    "motor",
    "motor_forms",
    "motor_search",
    "report",
    "schema",
    "schemes",
    "select",
    "sheet",
    "simulate",
    "size",
    "strength",
    "synthesize",
    "teeth",
    "vibrate",
]


class AnalyzeOptions(TypedDict, total=False):
    """Arguments of :func:`analyze`."""

    k1: Values | None
    k2: Values | None
    ratio1: Values | None
    ratio2: Values | None
    transmission: Values | None
    efficiency: Values | None
    gear: Values | None
    all_combinations: bool
    formula: bool
    steps: bool
    shifts: bool
    progression: Values | None
    speeds: Values | None
    torques: Values | None
    map: Values | None
    torque: Values | None
    power: Values | None
    speed: Values | None
    output: Path | None
    progress: Progress | None


class StrengthOptions(TypedDict, total=False):
    """Arguments of :func:`strength`."""

    gear: Values | None
    factors: bool
    torque: Values | None
    power: Values | None
    speed: Values | None
    output: Path | None
    progress: Progress | None


class SheetOptions(TypedDict, total=False):
    """Arguments of :func:`sheet`."""

    set: Values | None
    output: Path | None
    progress: Progress | None


class SizeOptions(TypedDict, total=False):
    """Arguments of :func:`size`."""

    modules: Values | None
    face_widths: Values | None
    planets: Values | None
    centre_distance_step: Values | None
    width_ratio: Values | None
    aim: Literal["sliding", "tip-alteration"] | None
    tip_thickness: Values | None
    planet_rim: Values | None
    ring_rim: Values | None
    bearings: Values | None
    bearing_type: Literal["balls", "rollers", "any"] | None
    bearing_rows: Values | None
    no_bearings: bool
    minimise: Literal["mass", "ring"] | None
    most: Values | None
    save: Values | None
    output: Path | None
    progress: Progress | None


class LossesOptions(TypedDict, total=False):
    """Arguments of :func:`losses`."""

    k1: Values | None
    k2: Values | None
    ratio1: Values | None
    ratio2: Values | None
    transmission: Values | None
    efficiency: Values | None
    gear: Values | None
    speed: Values | None
    torque: Values | None
    power: Values | None
    load_torque: Values | None
    conductance: Values | None
    cooler: Values | None
    allowed_rise: Values | None
    speeds: Values | None
    torques: Values | None
    output: Path | None
    progress: Progress | None


class VibrateOptions(TypedDict, total=False):
    """Arguments of :func:`vibrate`."""

    gear: Values | None
    set: Values | None
    speeds: Values | None
    harmonics: Values | None
    transmission_error: Values | None
    ring_transmission_error: Values | None
    damping: Values | None
    without_gyroscopic: bool
    coupled: bool
    response: Values | None
    campbell: Values | None
    torsional_campbell: Values | None
    shapes: Values | None
    output: Path | None
    progress: Progress | None


class DrawOptions(TypedDict, total=False):
    """Arguments of :func:`draw`."""

    view: Literal["scheme", "speeds", "levers", "ladder", "map", "centrodes", "construction", "teeth", "motor", "chambers", "dimensions", "forces", "ports", "pressure", "stress", "efficiency"] | None
    transmission: Values | None
    gear: Values | None
    power: bool
    whole: bool
    same_side: bool
    to_scale: bool
    speeds: Values | None
    torques: Values | None
    k1: Values | None
    k2: Values | None
    ratio1: Values | None
    ratio2: Values | None
    efficiency: Values | None
    title: Values | None
    dpi: Values | None
    svg: Values | None
    dxf: Values | None
    output: Path | None
    progress: Progress | None


class ReportOptions(TypedDict, total=False):
    """Arguments of :func:`report`."""

    k1: Values | None
    k2: Values | None
    ratio1: Values | None
    ratio2: Values | None
    transmission: Values | None
    efficiency: Values | None
    torque: Values | None
    power: Values | None
    speed: Values | None
    to_scale: bool
    speeds: Values | None
    harmonics: Values | None
    transmission_error: Values | None
    ring_transmission_error: Values | None
    damping: Values | None
    without_gyroscopic: bool
    coupled: bool
    project: Values | None
    customer: Values | None
    author: Values | None
    date: Values | None
    paper: Literal["a4", "letter"] | None
    progress: Progress | None


def teeth(
    *,
    ratio: Values,
    mode: Values | None = None,
    tolerance: Values | None = None,
    double_planet: bool = False,
    ring_offset: Values | None = None,
    aim: Literal["sliding", "tip-alteration"] | None = None,
    tip_thickness: Values | None = None,
    planets: Values | None = None,
    sun: Values | None = None,
    planet: Values | None = None,
    ring: Values | None = None,
    k: Values | None = None,
    spacing: Literal["equal", "least-unequal"] | None = None,
    tip_gap: Values | None = None,
    addendum: Values | None = None,
    pressure_angle: Values | None = None,
    no_undercut: bool = False,
    limit: Values | None = None,
    save: Values | None = None,
    nth: Values | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """Every set of tooth numbers of a simple or double-planet gear set for a ratio.

    The tooth numbers of a set fit together: sun, planets and ring share one centre distance, the planets clear each
    other and assemble. Of a double-planet set the ratio leaves the planets open: each pair of sun and ring stands
    once, with one choice of planets. With ``ring_offset`` the ring may depart from the rule of equal centre
    distances, and profile shifts make up for it. The most exact come first. Ranges include both ends and may be open:
    12..40, 17.., ..=200, 20.

    Parameters
    ----------
    ratio
        Wanted ratio, input speed over output speed; negative for opposite directions of rotation
    mode
        Input, output and fixed member: ab^H, aH^b, bH^a, ba^H, Ha^b or Hb^a, with sun a, ring b and carrier H
    tolerance
        Greatest error of the ratio, below 100%: 1%, or 0.01
    double_planet
        Double-planet sets: pairs of planets in mesh with each other, one with the sun, the other with the ring
    ring_offset
        Simple sets with profile shift: teeth of the ring less those of the sun and twice those of a planet, a range
        from -9 to 9. Without it sets have no profile shift
    aim
        With ``ring_offset``: what picks the shifts, of which the sums are fixed
    tip_thickness
        With ``ring_offset``: least thickness of the tips, in modules; 0.4 is usual of case-hardened teeth
    planets
        Number of planets, or of pairs of planets, from 2 to 8
    sun
        Teeth of the sun
    planet
        Teeth of a planet, of a double-planet set of each of the two
    ring
        Teeth of the ring
    k
        Ring-to-sun ratio k
    spacing
        Spacing of the planets
    tip_gap
        Least gap between the tips of neighbouring planets, in modules
    addendum
        Addendum coefficient of the basic rack: tips of planets, and undercut
    pressure_angle
        Pressure angle of the basic rack: undercut
    no_undercut
        Leave out sets in which the rack would undercut sun or planet
    limit
        Show at most this many sets. Default: 20 in a table, otherwise all, up to 100000
    save
        Write the most exact set as a gearbox file without losses that analyze, draw and report read
    nth
        With ``save``: the set with this number in place of the most exact; the checks told are of its teeth
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["teeth"], [], {"--ratio": ratio, "--mode": mode, "--tolerance": tolerance, "--double-planet": double_planet, "--ring-offset": ring_offset, "--aim": aim, "--tip-thickness": tip_thickness, "--planets": planets, "--sun": sun, "--planet": planet, "--ring": ring, "--k": k, "--spacing": spacing, "--tip-gap": tip_gap, "--addendum": addendum, "--pressure-angle": pressure_angle, "--no-undercut": no_undercut, "--limit": limit, "--save": save, "--nth": nth}, progress, output=output)


def drive(
    file: Source,
    *,
    project: Values | None = None,
    customer: Values | None = None,
    author: Values | None = None,
    date: Values | None = None,
    paper: Literal["a4", "letter"] | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """A planetary drive from power, speed and ratio to its starting time.

    Chooses the teeth (or takes those given), then calculates speeds, torques, diameters, shafts with their bearings,
    masses, inertias, forces, the equivalent inertia referred to the sun's shaft, and how the drive starts. The sun
    drives, the ring is fixed, the load is on the carrier. Warnings are part of the answer; with ``output`` they are
    shown here too. In a file whose name ends in .html the answer is a page, with drawing and plots.

    Parameters
    ----------
    file
        The file that describes the drive, in YAML; - for standard input
    project
        What it is for, below the title and at the foot of each sheet
    customer
        For whom it is
    author
        Who made it
    date
        Its date, as it is to be read
    paper
        Paper to print it on. Default: the printer's
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["drive"], [file], {"--project": project, "--customer": customer, "--author": author, "--date": date, "--paper": paper}, progress, output=output)


def analyze(
    gearbox: Source,
    *,
    k1: Values | None = None,
    k2: Values | None = None,
    ratio1: Values | None = None,
    ratio2: Values | None = None,
    transmission: Values | None = None,
    efficiency: Values | None = None,
    gear: Values | None = None,
    all_combinations: bool = False,
    formula: bool = False,
    steps: bool = False,
    shifts: bool = False,
    progression: Values | None = None,
    speeds: Values | None = None,
    torques: Values | None = None,
    map: Values | None = None,
    torque: Values | None = None,
    power: Values | None = None,
    speed: Values | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """A planetary gearbox from a file, or a scheme by its name: ratios, speeds, torques, powers and losses of its
    gears.

    Without ``gear`` all gears: engagement table, ratios with their steps and progression, losses, torque and slip of
    the shift elements, shifts, planets; with ``gear`` everything about one. Speeds are multiples of the input's
    speed, torques of the input's torque and powers of what enters, unless ``speed``, ``torque`` or ``power`` say
    more. A negative torque or power brakes the machine: power then runs from the output to the input. A gear that
    keeps freedoms, such as a power split, takes ``speeds`` of several links and ``torques`` at some.

    Parameters
    ----------
    gearbox
        The file, in YAML, or - for standard input; or a scheme of the catalogue (I … III-3) or a structure
        (D.T1.B+T2.B.T1) by its name
    k1
        Ring-to-sun ratio k of set 1, of a scheme or structure by its name
    k2
        Ring-to-sun ratio k of set 2
    ratio1
        Ratio of gear 1, in place of ``k1``
    ratio2
        Ratio of gear 2, in place of ``k2``
    transmission
        One transmission of a list: its name, or a part that no other name has
    efficiency
        Efficiency with the carrier fixed of each set for which the file states no losses: 0.97 or 97%. Of a compound
        set each mesh takes its square root
    gear
        One gear, in full
    all_combinations
        Every combination of shift elements, with its state
    formula
        Ratios as formulas in the basic ratios of the sets: of all gears, or of one with ``gear``
    steps
        The formulas and the way to them: equations with their numbers, conditions, substitutions, torques
    shifts
        All shifts between gears, also those that pass gears over: what is released and applied, and how the input and
        each shift element change their speeds
    progression
        Progression factor of the ideal progression: each of its steps over the next. Default: the factor that fits
        the ratios best
    speeds
        Speeds of links of a gear that keeps freedoms, as many as it keeps: engine=2000rpm, mg1=3000rpm
    torques
        Torques at links where power enters or leaves; those of the other ends follow: engine=100N·m
    map
        The state over ranges of two speeds, a line a place: engine=800rpm..4000rpm/9, mg1=-5000rpm..5000rpm/11
    torque
        Torque on the input: 500 N·m
    power
        Power into the input: 75 kW; needs ``speed``
    speed
        Speed of the input: 1475 rpm
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["analyze"], [gearbox], {"--k1": k1, "--k2": k2, "--ratio1": ratio1, "--ratio2": ratio2, "--transmission": transmission, "--efficiency": efficiency, "--gear": gear, "--all-combinations": all_combinations, "--formula": formula, "--steps": steps, "--shifts": shifts, "--progression": progression, "--speeds": speeds, "--torques": torques, "--map": map, "--torque": torque, "--power": power, "--speed": speed}, progress, output=output)


def strength(
    file: Source,
    *,
    gear: Values | None = None,
    factors: bool = False,
    torque: Values | None = None,
    power: Values | None = None,
    speed: Values | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """Strength of the teeth of simple sets by ISO 6336, method B: safeties of flanks and roots.

    With ``torque`` or ``power`` and ``speed`` the stresses, limits and safeties in each gear at this load for the
    required life; without them damage, safety and life over the duty of the file, by Miner's rule. Torques are those
    without losses; their direction does not matter. Sets that are not simple or lack data are named with what is
    missing.

    Parameters
    ----------
    file
        The file, in YAML, or - for standard input
    gear
        One gear at the load; all without
    factors
        The factors of each mesh, with where each comes from; over a duty the least and greatest of its steps
    torque
        Torque on the input: 500 N·m
    power
        Power into the input: 75 kW; needs ``speed``
    speed
        Speed of the input: 1475 rpm
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["strength"], [file], {"--gear": gear, "--factors": factors, "--torque": torque, "--power": power, "--speed": speed}, progress, output=output)


def sheet(
    file: Source,
    *,
    set: Values | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """Data sheets of the gears of simple sets: circles, tooth thickness, measures, meshes.

    Names and signs are those of ISO 21771. A set needs its teeth and its module; profile shifts, allowances and what
    else the file states are used. Sets that are not simple or lack data are named with what is missing.

    Parameters
    ----------
    file
        The file, in YAML, or - for standard input
    set
        One set; all without
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["sheet"], [file], {"--set": set}, progress, output=output)


def size(
    file: Source,
    *,
    modules: Values | None = None,
    face_widths: Values | None = None,
    planets: Values | None = None,
    centre_distance_step: Values | None = None,
    width_ratio: Values | None = None,
    aim: Literal["sliding", "tip-alteration"] | None = None,
    tip_thickness: Values | None = None,
    planet_rim: Values | None = None,
    ring_rim: Values | None = None,
    bearings: Values | None = None,
    bearing_type: Literal["balls", "rollers", "any"] | None = None,
    bearing_rows: Values | None = None,
    no_bearings: bool = False,
    minimise: Literal["mass", "ring"] | None = None,
    most: Values | None = None,
    save: Values | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """Sizes of the simple sets of a gearbox that hold over the duty of its file, with the least mass or ring.

    Complete over the stated modules, face widths, numbers of planets, centre distances and bearings; shifts follow
    from the centre distance and the aim. Each design must have faultless gears, the required safeties of flanks and
    roots by ISO 6336 and bearings that live as long as required. What the file gives of a set is held: module,
    face_width, planets, profile_shifts, planet_bore, load_rating, ring_rim.

    Parameters
    ----------
    file
        The file, in YAML, or - for standard input: what strength reads, but sizes may be missing in its sets
    modules
        Modules. Default: series I of ISO 54 to 20 mm
    face_widths
        Face widths. Default: 10 to 80 mm in steps of 5 mm
    planets
        Numbers of planets, from 1 to 8
    centre_distance_step
        Step of the centre distances, which are its multiples within one module of the natural one
    width_ratio
        The greatest face width over the sun's reference diameter. Default: no bound
    aim
        What picks the shifts, of which the sums are fixed
    tip_thickness
        Least thickness of the tips, in modules; 0.4 is usual of case-hardened teeth
    planet_rim
        Least rim of the planets between root circle and bearing, in modules
    ring_rim
        Rim of the ring outside its root circle, in modules
    bearings
        Bearings of the planets, as CSV with the columns designation, rolling (balls or rollers), d_mm, D_mm, B_mm,
        C_kN, C0_kN. Default: a table, by ``bearing_type``
    bearing_type
        Which bearings of the tables are taken: deep groove ball bearings, cylindrical roller bearings, or both
    bearing_rows
        Bearings side by side in a planet, at most: 1 or 2; a pair is rated by ISO 281 as one double-row bearing
    no_bearings
        Seek no bearings: the planets are solid
    minimise
        What is least: the mass of the gears, or the outside diameter of the rings
    most
        How many designs of each set are shown
    save
        Write the file with the best design of each set, which strength, analyze, draw and report read
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["size"], [file], {"--modules": modules, "--face-widths": face_widths, "--planets": planets, "--centre-distance-step": centre_distance_step, "--width-ratio": width_ratio, "--aim": aim, "--tip-thickness": tip_thickness, "--planet-rim": planet_rim, "--ring-rim": ring_rim, "--bearings": bearings, "--bearing-type": bearing_type, "--bearing-rows": bearing_rows, "--no-bearings": no_bearings, "--minimise": minimise, "--most": most, "--save": save}, progress, output=output)


def design(
    *,
    input: Values,
    speeds: Values | None = None,
    ratios: Values | None = None,
    all_structures: bool = False,
    power: Values | None = None,
    torque: Values | None = None,
    shares: Values | None = None,
    overload: Values | None = None,
    scheme: Values | None = None,
    order: Values | None = None,
    tries: Values | None = None,
    tooth_design: Values | None = None,
    sun: Values | None = None,
    planet: Values | None = None,
    ring: Values | None = None,
    ring_offset: Values | None = None,
    basis: Values | None = None,
    factors: Values | None = None,
    life: Values | None = None,
    save: Values | None = None,
    tolerance: Values | None = None,
    brakes: Literal["either", "as-given"] | None = None,
    signs: Literal["alike", "any", "as-given"] | None = None,
    k: Values | None = None,
    prefer: Values | None = None,
    efficiency: Values | None = None,
    least_efficiency: Values | None = None,
    link_speed: Values | None = None,
    planet_speed: Values | None = None,
    clutch_slip: Values | None = None,
    circulation: Values | None = None,
    allow_crossing: bool = False,
    may_reverse: bool = False,
    modules: Values | None = None,
    face_widths: Values | None = None,
    planets: Values | None = None,
    centre_distance_step: Values | None = None,
    width_ratio: Values | None = None,
    aim: Literal["sliding", "tip-alteration"] | None = None,
    tip_thickness: Values | None = None,
    planet_rim: Values | None = None,
    ring_rim: Values | None = None,
    bearings: Values | None = None,
    bearing_type: Literal["balls", "rollers", "any"] | None = None,
    bearing_rows: Values | None = None,
    no_bearings: bool = False,
    minimise: Literal["mass", "ring"] | None = None,
    most: Values | None = None,
    project: Values | None = None,
    customer: Values | None = None,
    author: Values | None = None,
    date: Values | None = None,
    paper: Literal["a4", "letter"] | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """A gearbox for two or three speeds from power to sizes that hold: scheme, tooth numbers, sizes, strength, in
    steps.

    The answer begins with the speeds asked for and reached. The scheme is what select chooses. Of its tooth numbers
    those with the least class of deviation and the smallest rings at one load of the teeth get the sizes that size
    finds over a duty with the load in every gear, and the lightest is taken. Every step tells what it took, among how
    many, what came next, and the option to choose otherwise. Assumed values, such as materials and load factors, are
    listed; ``basis`` and ``factors`` change them. Where nothing is left, the limits that would have to give are
    listed, each with its option and the gearbox found with it.

    Parameters
    ----------
    speeds
        Speeds of the machine, the slowest first
    ratios
        Ratios of the braked gears, in place of speeds: one or two. 2.5,1.5 or 2,5; 1,5
    all_structures
        All 111 structures of two sets (or the 6 of one), and not only the source's
    input
        Speed of the input
    power
        Power into the input in every gear
    torque
        Torque on the input in every gear, in place of ``power``
    shares
        Shares of the time of the gears, the slowest first, then reverse gears. Default: equal
    overload
        The greatest torque of the life over that of the load, in every gear: teeth are held against it statically
    scheme
        This scheme or structure in place of the best: II-3, D.T1.B+T2.B.T1
    order
        The objective that decides first among schemes, then the next for equal values
    tries
        Number of tooth designs that get sizes, those with the smallest ring at one load of the teeth; the lightest is
        taken. They are taken within a tenth of ``tolerance``; only where none holds within a third of it, then within
        all of it
    tooth_design
        The tooth design with this number in place of the lightest. It counts the designs of ``tries``
    sun
        Teeth of the suns
    planet
        Teeth of the planets
    ring
        Teeth of the rings
    ring_offset
        Simple sets with profile shift: teeth of the ring less those of the sun and twice those of a planet, a range
        from -9 to 9; ``aim`` and ``tip_thickness`` decide which close. Without it only sets that need no shift get
        sizes
    basis
        A gearbox file whose strength, materials, oil, life and required safeties are taken; what it lacks is as
        without it
    factors
        Factors of both meshes by their symbols, 'K_A 1.5, K_v 1.1', in place of those of ``basis``; each once
    life
        Required life
    save
        Write the gearbox with its sizes, its duty and what no speed tells; size, strength, analyze, draw and report
        read it
    tolerance
        Greatest deviation of a ratio, and of a speed, from the one asked for: 3%, or 0.03
    brakes
        Which brake gives which ratio
    signs
        Which signs the ratios may have; direct drive is positive. Default: as-given where a ratio has a minus,
        otherwise alike
    k
        Ring-to-sun ratios allowed
    prefer
        Ring-to-sun ratios preferred
    efficiency
        Efficiency of each set with its carrier fixed, 0.97 or 97%
    least_efficiency
        Least efficiency of a gear
    link_speed
        Greatest speed of a link over the input's
    planet_speed
        Greatest speed of a planet relative to its carrier over the input's
    clutch_slip
        Greatest slip of the open direct-drive clutch over the input's speed
    circulation
        Greatest circulating power of a gear over what enters, 0.5 or 50%. Not given: more than half is an objection
    allow_crossing
        Accept schemes that are not drawable: a link would cross another
    may_reverse
        Allow schemes whose output turns forward in some gears and backward in others; they are taken where no other
        is left. Default: refused, unless a ratio is given with a minus
    modules
        Modules. Default: series I of ISO 54 to 20 mm
    face_widths
        Face widths. Default: 10 to 80 mm in steps of 5 mm
    planets
        Numbers of planets, from 1 to 8
    centre_distance_step
        Step of the centre distances, which are its multiples within one module of the natural one
    width_ratio
        The greatest face width over the sun's reference diameter. Default: no bound
    aim
        What picks the shifts, of which the sums are fixed
    tip_thickness
        Least thickness of the tips, in modules; 0.4 is usual of case-hardened teeth
    planet_rim
        Least rim of the planets between root circle and bearing, in modules
    ring_rim
        Rim of the ring outside its root circle, in modules
    bearings
        Bearings of the planets, as CSV with the columns designation, rolling (balls or rollers), d_mm, D_mm, B_mm,
        C_kN, C0_kN. Default: a table, by ``bearing_type``
    bearing_type
        Which bearings of the tables are taken: deep groove ball bearings, cylindrical roller bearings, or both
    bearing_rows
        Bearings side by side in a planet, at most: 1 or 2; a pair is rated by ISO 281 as one double-row bearing
    no_bearings
        Seek no bearings: the planets are solid
    minimise
        What is least: the mass of the gears, or the outside diameter of the rings
    most
        How many designs of each set are shown
    project
        What it is for, below the title and at the foot of each sheet
    customer
        For whom it is
    author
        Who made it
    date
        Its date, as it is to be read
    paper
        Paper to print it on. Default: the printer's
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["design"], [], {"--speeds": speeds, "--ratios": ratios, "--all-structures": all_structures, "--input": input, "--power": power, "--torque": torque, "--shares": shares, "--overload": overload, "--scheme": scheme, "--order": order, "--tries": tries, "--tooth-design": tooth_design, "--sun": sun, "--planet": planet, "--ring": ring, "--ring-offset": ring_offset, "--basis": basis, "--factors": factors, "--life": life, "--save": save, "--tolerance": tolerance, "--brakes": brakes, "--signs": signs, "--k": k, "--prefer": prefer, "--efficiency": efficiency, "--least-efficiency": least_efficiency, "--link-speed": link_speed, "--planet-speed": planet_speed, "--clutch-slip": clutch_slip, "--circulation": circulation, "--allow-crossing": allow_crossing, "--may-reverse": may_reverse, "--modules": modules, "--face-widths": face_widths, "--planets": planets, "--centre-distance-step": centre_distance_step, "--width-ratio": width_ratio, "--aim": aim, "--tip-thickness": tip_thickness, "--planet-rim": planet_rim, "--ring-rim": ring_rim, "--bearings": bearings, "--bearing-type": bearing_type, "--bearing-rows": bearing_rows, "--no-bearings": no_bearings, "--minimise": minimise, "--most": most, "--project": project, "--customer": customer, "--author": author, "--date": date, "--paper": paper}, progress, output=output)


def losses(
    gearbox: Source,
    *,
    k1: Values | None = None,
    k2: Values | None = None,
    ratio1: Values | None = None,
    ratio2: Values | None = None,
    transmission: Values | None = None,
    efficiency: Values | None = None,
    gear: Values | None = None,
    speed: Values | None = None,
    torque: Values | None = None,
    power: Values | None = None,
    load_torque: Values | None = None,
    conductance: Values | None = None,
    cooler: Values | None = None,
    allowed_rise: Values | None = None,
    speeds: Values | None = None,
    torques: Values | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """Losses of a gearbox at work: of its meshes under load, and drags of seals, bearings, oil and open shift
    elements.

    At a ``speed`` and a load each loss of each gear by its name, and the balance of powers; with ``speeds`` and
    ``torques`` the efficiency of one gear over both. With ``conductance`` how warm the oil becomes, and what torque
    it bears. Meshes lose by their efficiencies or by friction, drags by the curves of the file.

    Parameters
    ----------
    gearbox
        The file, in YAML, or - for standard input; or a scheme of the catalogue (I … III-3) or a structure
        (D.T1.B+T2.B.T1) by its name
    k1
        Ring-to-sun ratio k of set 1, of a scheme or structure by its name
    k2
        Ring-to-sun ratio k of set 2
    ratio1
        Ratio of gear 1, in place of ``k1``
    ratio2
        Ratio of gear 2, in place of ``k2``
    transmission
        One transmission of a list: its name, or a part that no other name has
    efficiency
        Efficiency with the carrier fixed of each set for which the file states no losses: 0.97 or 97%. Of a compound
        set each mesh takes its square root
    gear
        One gear; all without
    speed
        Speed of the input: 1475 rpm
    torque
        Torque on the input: 500 N·m; below 0 the machine brakes it
    power
        Power into the input: 75 kW
    load_torque
        Torque that the driven machine takes from the output; the input's follows
    conductance
        Conductance of the housing to the air, area times coefficient: 25 W/K. Tells how warm the oil becomes
    cooler
        What a cooler takes at most: 2 kW. Default: none
    allowed_rise
        By how much the oil may be warmer than the air: 60 K. Tells the greatest torque on the input
    speeds
        A map of one gear over these speeds of the input: 500rpm..3000rpm/6, both ends and how many places; with
        ``torques``
    torques
        Torques on the input of the map: 10N·m..100N·m/10
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["losses"], [gearbox], {"--k1": k1, "--k2": k2, "--ratio1": ratio1, "--ratio2": ratio2, "--transmission": transmission, "--efficiency": efficiency, "--gear": gear, "--speed": speed, "--torque": torque, "--power": power, "--load-torque": load_torque, "--conductance": conductance, "--cooler": cooler, "--allowed-rise": allowed_rise, "--speeds": speeds, "--torques": torques}, progress, output=output)


def simulate(
    file: Source,
    *,
    csv: Values | None = None,
    sweep: Values | None = None,
    steps: Values | None = None,
    view: Literal["speeds", "torques", "capacities", "temperatures"] | None = None,
    dpi: Values | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """A gearbox in motion by a scenario: how it shifts, how hot its clutches get, whether the drive starts.

    A scenario names a gearbox, inertias, torques on links, capacities of shift elements and shifts. Shift elements
    are dry friction without smoothing, so that slip, lock and release are exact events. With a file that ends in
    .svg, .pdf, .png or .dxf ``output`` draws a plot over time.

    Parameters
    ----------
    file
        The file of the scenario, in YAML; - for standard input
    csv
        File for speeds and torques over time as comma-separated values
    sweep
        Other values of one key, a run for each: shifts[0].overlap=0ms..300ms, elements[C].holding='300 N·m..600 N·m'
    steps
        How many values, 2 to 1000. Default: 11
    view
        What a drawing shows, with ``output``. Default: speeds
    dpi
        Pixels to an inch of a PNG image, 20 to 2400. Default: 300
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["simulate"], [file], {"--csv": csv, "--sweep": sweep, "--steps": steps, "--view": view, "--dpi": dpi}, progress, output=output)


def vibrate(
    file: Source,
    *,
    gear: Values | None = None,
    set: Values | None = None,
    speeds: Values | None = None,
    harmonics: Values | None = None,
    transmission_error: Values | None = None,
    ring_transmission_error: Values | None = None,
    damping: Values | None = None,
    without_gyroscopic: bool = False,
    coupled: bool = False,
    response: Values | None = None,
    campbell: Values | None = None,
    torsional_campbell: Values | None = None,
    shapes: Values | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """Natural frequencies and modes of simple sets, and the speeds at which they resonate.

    Each set is a planar model of Lin and Parker: sun, ring, carrier and planets on springs. With ``speeds`` also what
    excites it in each gear, which modes the phases of the planets let it excite, and the speeds of the input at which
    it meets them; with ``transmission_error`` the forces in the meshes. Torsional modes are of the whole gearbox, and
    with ``coupled`` also its modes in the plane.

    Parameters
    ----------
    file
        The file, in YAML, or - for standard input
    gear
        One gear; all without
    set
        One set; all without
    speeds
        Resonances and frequencies over these speeds of the input: 500rpm..3000rpm/11, both ends and how many places
    harmonics
        How many harmonics of the meshes. Default: 3
    transmission_error
        Transmission error of the meshes, harmonics from the first: 3um,1um. Tells the forces that it makes
    ring_transmission_error
        The same of the ring's meshes, where it is another
    damping
        Damping ratio of every mode, such as 0.03 or 3%
    without_gyroscopic
        These forces without the gyroscopic effect of the carrier's speed
    coupled
        Modes of the whole gearbox in the plane, with all sets on common links
    response
        File for a picture of the forces by the transmission error of one set in one gear over the speed, as for
        ``campbell``
    campbell
        File for a Campbell diagram of one set in one gear, by the end of its name: .dxf, .pdf, .png, otherwise SVG
    torsional_campbell
        File for a Campbell diagram of the torsional modes of one gear, as for ``campbell``
    shapes
        File for pictures of all modes of one set, seen along its axis, as for ``campbell``
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["vibrate"], [file], {"--gear": gear, "--set": set, "--speeds": speeds, "--harmonics": harmonics, "--transmission-error": transmission_error, "--ring-transmission-error": ring_transmission_error, "--damping": damping, "--without-gyroscopic": without_gyroscopic, "--coupled": coupled, "--response": response, "--campbell": campbell, "--torsional-campbell": torsional_campbell, "--shapes": shapes}, progress, many={"--transmission-error": "repeated", "--ring-transmission-error": "repeated"}, output=output)


def compare(
    *gearboxes: Source,
    k1: Values | None = None,
    k2: Values | None = None,
    ratio1: Values | None = None,
    ratio2: Values | None = None,
    transmission: Values | None = None,
    efficiency: Values | None = None,
    torque: Values | None = None,
    power: Values | None = None,
    speed: Values | None = None,
    project: Values | None = None,
    customer: Values | None = None,
    author: Values | None = None,
    date: Values | None = None,
    paper: Literal["a4", "letter"] | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """Gearboxes side by side: ratios, steps, spread, efficiency, torques and slips of shift elements, speeds,
    circulating power, parts.

    Differences are counted from the first. Gears stand beside each other by their names where these are the same in
    all gearboxes, with their ratios in the same order; else by their ratios. With a speed and a load of the input
    they are compared at it, too. Of a list of transmissions those are compared that ``transmission`` names. Schemes
    and structures by their names take the sizes that are given, all the same. With ``output`` and a name that ends in
    .html the answer is a page with the schemes.

    Parameters
    ----------
    gearboxes
        Files in YAML, - for standard input, and schemes (I … III-3) or structures (D.T1.B+T2.B.T1) by their names
    k1
        Ring-to-sun ratio k of set 1, of a scheme or structure by its name
    k2
        Ring-to-sun ratio k of set 2
    ratio1
        Ratio of gear 1, in place of ``k1``
    ratio2
        Ratio of gear 2, in place of ``k2``
    transmission
        A transmission of the lists among the files: its name, or a part that no other name has; again for each
        further one
    efficiency
        Efficiency with the carrier fixed of each set for which the file states no losses: 0.97 or 97%. Of a compound
        set each mesh takes its square root
    torque
        Torque on the input: 500 N·m
    power
        Power into the input: 75 kW; needs ``speed``
    speed
        Speed of the input: 1475 rpm
    project
        What it is for, below the title and at the foot of each sheet
    customer
        For whom it is
    author
        Who made it
    date
        Its date, as it is to be read
    paper
        Paper to print it on. Default: the printer's
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["compare"], [*gearboxes], {"--k1": k1, "--k2": k2, "--ratio1": ratio1, "--ratio2": ratio2, "--transmission": transmission, "--efficiency": efficiency, "--torque": torque, "--power": power, "--speed": speed, "--project": project, "--customer": customer, "--author": author, "--date": date, "--paper": paper}, progress, many={"--transmission": "repeated"}, output=output)


def select(
    *,
    speeds: Values | None = None,
    ratios: Values | None = None,
    all_structures: bool = False,
    teeth: bool = False,
    limit: Values | None = None,
    order: Values | None = None,
    save: Values | None = None,
    nth: Values | None = None,
    tolerance: Values | None = None,
    brakes: Literal["either", "as-given"] | None = None,
    signs: Literal["alike", "any", "as-given"] | None = None,
    k: Values | None = None,
    prefer: Values | None = None,
    efficiency: Values | None = None,
    least_efficiency: Values | None = None,
    link_speed: Values | None = None,
    planet_speed: Values | None = None,
    clutch_slip: Values | None = None,
    circulation: Values | None = None,
    allow_crossing: bool = False,
    same_direction: bool = False,
    input: Values | None = None,
    power: Values | None = None,
    torque: Values | None = None,
    load_factor: Values | None = None,
    face_width_ratio: Values | None = None,
    planets: Values | None = None,
    mesh_load_factors: Values | None = None,
    ring_diameter: Values | None = None,
    least_module: Values | None = None,
    greatest_module: Values | None = None,
    sun: Values | None = None,
    planet: Values | None = None,
    ring: Values | None = None,
    planet_count: Values | None = None,
    ring_offset: Values | None = None,
    aim: Literal["sliding", "tip-alteration"] | None = None,
    tip_thickness: Values | None = None,
    project: Values | None = None,
    customer: Values | None = None,
    author: Values | None = None,
    date: Values | None = None,
    paper: Literal["a4", "letter"] | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """The planetary gearbox for two or three speeds: every scheme measured, judged and compared.

    The fastest speed is direct drive; the others give the ratios wanted of one or two braked gears. Each mechanism is
    tried with both orders of the ratios and both signs, its ring-to-sun ratios follow, and every required criterion
    is stated with what it found. There are no weights: of the designs that meet the criteria, the order of objectives
    chooses the first. The non-dominated designs are those that no other beats in everything.

    Parameters
    ----------
    speeds
        Speeds of the machine, the slowest first
    ratios
        Ratios of the braked gears, in place of speeds: one or two. 2.5,1.5 or 2,5; 1,5
    all_structures
        All 111 structures of two sets (or the 6 of one), and not only the source's
    teeth
        Tooth numbers of the one set or of both: all combinations
    limit
        Show at most this many designs. Default: 10 in a table, otherwise all; of tooth numbers 10, in a table up to
        10000
    order
        The objective that decides first, then the next for equal values: size, efficiency. Default: efficiency,
        speed, k, error, size; with ``teeth`` error, efficiency, speed, k, size
    save
        Write the best design as a gearbox file that analyze, draw and report read
    nth
        The design that is shown in full and saved, by its number
    tolerance
        How far a ratio may be off: 10%, or 0.1
    brakes
        Which brake gives which ratio
    signs
        Which signs the ratios may have; direct drive is positive. Default: as-given where a ratio has a minus,
        otherwise alike
    k
        Ring-to-sun ratios allowed
    prefer
        Ring-to-sun ratios preferred
    efficiency
        Efficiency of each set with its carrier fixed, 0.97 or 97%
    least_efficiency
        Least efficiency of a gear
    link_speed
        Greatest speed of a link over the input's
    planet_speed
        Greatest speed of a planet relative to its carrier over the input's
    clutch_slip
        Greatest slip of the open direct-drive clutch over the input's speed
    circulation
        Greatest circulating power of a gear over what enters, 0.5 or 50%. Not given: more than half is an objection
    allow_crossing
        Accept schemes that are not drawable: a link would cross another
    same_direction
        Refuse mixed directions of rotation: the output turns one way in a braked gear and the other way in direct
        drive. Default: such schemes are marked and ranked last
    input
        Speed of the input, 1475 rpm: gives the speed of the output in each gear
    power
        Power into the input, 75 kW; needs ``input``. Gives torques and losses in each gear
    torque
        Torque on the input, 500 N·m, in place of ``power``
    load_factor
        Load factor K of the sun's teeth, 2 MPa: with ``torque`` or ``power`` sizes are lengths
    face_width_ratio
        Face width over the pitch diameter of the smaller of sun and planet; with ``load_factor``
    planets
        Planets of each set, without ``teeth``
    mesh_load_factors
        Mesh load factors K_γ with 2, 3, … 8 planets: seven numbers; how much more than its share the most loaded mesh
        carries
    ring_diameter
        Greatest pitch diameter of a ring; with ``teeth``
    least_module
        Least module that a set may need; with ``teeth``
    greatest_module
        Greatest module that a set may need; with ``teeth``
    sun
        Teeth of the suns
    planet
        Teeth of the planets
    ring
        Teeth of the rings
    planet_count
        Number of planets of a set, from 2 to 8
    ring_offset
        Simple sets with profile shift: teeth of the ring less those of the sun and twice those of a planet, a range
        from -9 to 9. Without it sets have no profile shift
    aim
        With ``ring_offset``: what picks the shifts, of which the sums are fixed
    tip_thickness
        With ``ring_offset``: least thickness of the tips, in modules; 0.4 is usual of case-hardened teeth
    project
        What it is for, below the title and at the foot of each sheet
    customer
        For whom it is
    author
        Who made it
    date
        Its date, as it is to be read
    paper
        Paper to print it on. Default: the printer's
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["select"], [], {"--speeds": speeds, "--ratios": ratios, "--all-structures": all_structures, "--teeth": teeth, "--limit": limit, "--order": order, "--save": save, "--nth": nth, "--tolerance": tolerance, "--brakes": brakes, "--signs": signs, "--k": k, "--prefer": prefer, "--efficiency": efficiency, "--least-efficiency": least_efficiency, "--link-speed": link_speed, "--planet-speed": planet_speed, "--clutch-slip": clutch_slip, "--circulation": circulation, "--allow-crossing": allow_crossing, "--same-direction": same_direction, "--input": input, "--power": power, "--torque": torque, "--load-factor": load_factor, "--face-width-ratio": face_width_ratio, "--planets": planets, "--mesh-load-factors": mesh_load_factors, "--ring-diameter": ring_diameter, "--least-module": least_module, "--greatest-module": greatest_module, "--sun": sun, "--planet": planet, "--ring": ring, "--planet-count": planet_count, "--ring-offset": ring_offset, "--aim": aim, "--tip-thickness": tip_thickness, "--project": project, "--customer": customer, "--author": author, "--date": date, "--paper": paper}, progress, output=output)


def synthesize(
    *,
    ratios: Values,
    tolerance: Values | None = None,
    class_: Literal["core", "all-sparse"] | None = None,
    sets: Values | None = None,
    elements: Values | None = None,
    engaged: Values | None = None,
    links: Values | None = None,
    open: Values | None = None,
    k: Values | None = None,
    brakes: Values | None = None,
    clutches: Values | None = None,
    shifts: Literal["any", "single"] | None = None,
    skip_shifts: Literal["any", "single"] | None = None,
    direct: bool = False,
    step: Values | None = None,
    falling_steps: bool = False,
    slip: Values | None = None,
    link_speed: Values | None = None,
    planet_speed: Values | None = None,
    drawable: bool = False,
    double_planets: Values | None = None,
    k_double: Values | None = None,
    equal_k: Values | None = None,
    efficiency: Values | None = None,
    shares: Values | None = None,
    least_efficiency: Values | None = None,
    least_reverse_efficiency: Values | None = None,
    most_circulating: Values | None = None,
    first_class: bool = False,
    limit: Values | None = None,
    all_gearboxes: bool = False,
    shard: Values | None = None,
    longest: Values | None = None,
    merge: Values | None = None,
    order: Values | None = None,
    objectives: Values | None = None,
    teeth: bool = False,
    sun: Values | None = None,
    planet: Values | None = None,
    ring: Values | None = None,
    planet_count: Values | None = None,
    equal_rings: Values | None = None,
    equal_suns: Values | None = None,
    equal_sets: Values | None = None,
    teeth_aim: Literal["deviation", "fewest"] | None = None,
    teeth_limit: Values | None = None,
    ring_offset: Values | None = None,
    aim: Literal["sliding", "tip-alteration"] | None = None,
    tip_thickness: Values | None = None,
    save: Values | None = None,
    nth: Values | None = None,
    explain: Values | None = None,
    transmission: Values | None = None,
    project: Values | None = None,
    customer: Values | None = None,
    author: Values | None = None,
    date: Values | None = None,
    paper: Literal["a4", "letter"] | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """Every gearbox of simple planet sets, brakes and clutches that has a list of ratios.

    All structures of so many sets are searched, over all ring-to-sun ratios k in the range, not a grid of them.
    Numbers of sets and shift elements that are a range are tried from the smallest up, until one has a gearbox of
    use: one that can be drawn and keeps ``least_efficiency``, ``least_reverse_efficiency`` and ``most_circulating``.

    Parameters
    ----------
    ratios
        Wanted ratios, input speed over output speed; negative for reverse. Commas, semicolons or spaces part them. Of
        a gear 4.714, 4.714±0.5%, 4.714±0.02, 4.5..4.9, ? (any between its neighbours), or in brackets where it may be
        missing: (-3.295)
    tolerance
        How far a ratio may be off that has no tolerance of its own: 1%, or 0.01
    class_
        Which structures are searched
    sets
        Number of planet sets, at most 6
    elements
        Number of shift elements, at most 8
    engaged
        Shift elements that a gear engages, at most 4. Default: 1..3; with ``links`` or ``open`` 1..4
    links
        Number of moving links: sets, engaged elements and one more; at most 11
    open
        Shift elements that are open in a gear: those not engaged
    k
        Ring-to-sun ratio k of every simple set
    brakes
        Number of brakes among the shift elements
    clutches
        Number of clutches among the shift elements
    shifts
        Shifts between neighbouring forward gears: single ones open one element and engage one
    skip_shifts
        Shifts that skip a gear: 1–3, 2–4 and so on
    direct
        A gear is direct: it turns the gearbox as one block
    step
        Ratio steps between neighbouring forward gears
    falling_steps
        Ratio steps fall from the first gear on: none is larger than the one before it
    slip
        Greatest slip of an open shift element over the input's speed
    link_speed
        Greatest speed of a link over the input's
    planet_speed
        Greatest speed of a planet relative to its carrier over the input's; of a double-planet set the speed that its
        planets exceed with any teeth
    drawable
        Only gearboxes that can be drawn: no link across another, each brake reached from the housing
    double_planets
        How many of the sets are double-planet sets, with two planets in mesh between sun and ring; each number is
        searched
    k_double
        Ring-to-sun ratio k of every double-planet set
    equal_k
        At least so many sets of one kind have equal k
    efficiency
        Efficiency of the two meshes of a simple set: 0.97, or 97%; each of the three of a double-planet set loses as
        much
    shares
        Shares of time of forward gears, by their numbers in ``ratios``: '1:5%, 2:10%, 3:85%'; other gears have none.
        Gearboxes are ordered by the mean efficiency of the forward gears by these shares, in place of the least
    least_efficiency
        Least efficiency of a forward gear. While every gearbox found misses this or the next two limits, or cannot be
        drawn, larger classes are searched
    least_reverse_efficiency
        Least efficiency of a reverse gear
    most_circulating
        Greatest circulating power of a forward gear over what enters
    first_class
        End at the first class with gearboxes, whether they are of use or not
    limit
        Show at most this many gearboxes, of each family the best. Default: 20 in a table, otherwise all, up to 10000
    all_gearboxes
        Show every gearbox, not the best of each family alone. Gearboxes of a family have equal formulas for all
        gears, up to an exchange of sets of one kind
    shard
        Search a share of the structures, the first of eight: 1/8. What it finds is a part, a Parquet table, in the
        file of ``output``. If it is ended, the same command goes on from ``output`` with .progress at its end
    longest
        Begin a search only if it is estimated to take at most this long. Default: 1 h, and at most 4 GB
    merge
        Take what was found from these parts of a search, all of its shares, instead of searching
    order
        The objectives that decide first which gearbox is the best; the others follow
    objectives
        The objectives of the Pareto front. Default: all
    teeth
        Find all tooth numbers of each gearbox shown that keep the tolerances
    sun
        Teeth of the suns
    planet
        Teeth of the planets; of a double-planet set of either planet
    ring
        Teeth of the rings
    planet_count
        Number of planets of a set, of a double-planet set of its pairs of planets, from 2 to 8
    equal_rings
        At least so many sets have rings of equal teeth
    equal_suns
        At least so many sets have suns of equal teeth
    equal_sets
        At least so many sets are equal
    teeth_aim
        Which tooth numbers are the best
    teeth_limit
        Choices of tooth numbers shown of each gearbox
    ring_offset
        Simple sets with profile shift: teeth of the ring less those of the sun and twice those of a planet, a range
        from -9 to 9. Without it sets have no profile shift
    aim
        With ``ring_offset``: what picks the shifts, of which the sums are fixed
    tip_thickness
        With ``ring_offset``: least thickness of the tips, in modules; 0.4 is usual of case-hardened teeth
    save
        Write the best gearbox as a file that analyze, draw and report read, with its tooth numbers where ``teeth``
        found any
    nth
        With ``save``: the gearbox with this number, of all found, in place of the best
    explain
        A gearbox to be placed beside the search: which ratio it misses, its number among those found, or why it is
        not found
    transmission
        With ``explain``: one transmission of a list, its name or a part that no other name has
    project
        What it is for, below the title and at the foot of each sheet
    customer
        For whom it is
    author
        Who made it
    date
        Its date, as it is to be read
    paper
        Paper to print it on. Default: the printer's
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["synthesize"], [], {"--ratios": ratios, "--tolerance": tolerance, "--class": class_, "--sets": sets, "--elements": elements, "--engaged": engaged, "--links": links, "--open": open, "--k": k, "--brakes": brakes, "--clutches": clutches, "--shifts": shifts, "--skip-shifts": skip_shifts, "--direct": direct, "--step": step, "--falling-steps": falling_steps, "--slip": slip, "--link-speed": link_speed, "--planet-speed": planet_speed, "--drawable": drawable, "--double-planets": double_planets, "--k-double": k_double, "--equal-k": equal_k, "--efficiency": efficiency, "--shares": shares, "--least-efficiency": least_efficiency, "--least-reverse-efficiency": least_reverse_efficiency, "--most-circulating": most_circulating, "--first-class": first_class, "--limit": limit, "--all-gearboxes": all_gearboxes, "--shard": shard, "--longest": longest, "--merge": merge, "--order": order, "--objectives": objectives, "--teeth": teeth, "--sun": sun, "--planet": planet, "--ring": ring, "--planet-count": planet_count, "--equal-rings": equal_rings, "--equal-suns": equal_suns, "--equal-sets": equal_sets, "--teeth-aim": teeth_aim, "--teeth-limit": teeth_limit, "--ring-offset": ring_offset, "--aim": aim, "--tip-thickness": tip_thickness, "--save": save, "--nth": nth, "--explain": explain, "--transmission": transmission, "--project": project, "--customer": customer, "--author": author, "--date": date, "--paper": paper}, progress, many={"--merge": "repeated"}, output=output)


def atlas(
    *,
    output: Values,
    progress: Progress | None = None,
) -> str:
    """All gearboxes of two and three simple planet sets as Parquet tables: structures, gears, and ratios as
    functions.

    No ratios are asked for: every structure is there, with every set of engaged shift elements that drives the
    output. Two sets with four and five links, and three sets with five, of class all sparse; three sets with six and
    seven links of class core.

    Parameters
    ----------
    output
        Folder for the tables, made if it is not there. Each is written whole, all of them or none
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    str
        What the command line writes to standard output.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.text(["atlas"], [], {"--output": output}, progress)


def schemes(
    scheme: Values | None = None,
    *,
    k1: Values | None = None,
    k2: Values | None = None,
    ratio1: Values | None = None,
    ratio2: Values | None = None,
    efficiency: Values | None = None,
    k: Values | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """The catalogue of two- and three-speed schemes of planetary gearboxes.

    Three of two speeds (I, II, III: one set, one brake, direct drive) and eleven of three (I-1 to III-3: two sets,
    two brakes, direct drive). Without a name all of them; with one its links, formulas and ranges, and for given k or
    ratios its numbers. D is the driving shaft, B the driven one, T1 and T2 are braked in gears 1 and 2; k is the
    ring's teeth over the sun's.

    Parameters
    ----------
    scheme
        I, II, III, I-1 … I-4, II-1 … II-4 or III-1 … III-3
    k1
        Ring-to-sun ratio of set 1
    k2
        Ring-to-sun ratio of set 2
    ratio1
        Ratio of gear 1, in place of ``k1``
    ratio2
        Ratio of gear 2, in place of ``k2``
    efficiency
        Efficiency of each set with its carrier fixed, 0.97 or 97%; of a scheme with numbers
    k
        Ring-to-sun ratios over which ranges of ratios are taken
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["schemes"], [scheme], {"--k1": k1, "--k2": k2, "--ratio1": ratio1, "--ratio2": ratio2, "--efficiency": efficiency, "--k": k}, progress, output=output)


def machine_list(
    name: Values | None = None,
    *,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """Machines in service with their numbers of speeds, beside the number recommended for their ranges.

    Parameters
    ----------
    name
        One machine
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["machine", "list"], [name], {}, progress, output=output)


def machine_speeds(
    speeds: Values,
    *,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """Ratios of a gearbox for some speeds, and how many speeds are recommended for their range.

    Direct drive may serve the fastest speed (the gearbox then only slows down), the slowest, or one between. Ratios
    are listed the fastest speed first.

    Parameters
    ----------
    speeds
        The speeds, the slowest first: '0.76 m/s, 1.33 m/s, 1.95 m/s'
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["machine", "speeds"], [speeds], {}, progress, output=output)


def machine_chain_cutter(
    *,
    pick_spacing: Values,
    feed: Values,
    chip: Values,
    force: Values | None = None,
    other_forces: Values | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """Cutting speed of a chain cutter, and of the same cutter in other rock.

    Parameters
    ----------
    pick_spacing
        Mean spacing of the picks in a cutting line
    feed
        Feed of the machine
    chip
        Mean thickness of the chip
    force
        Mean cutting force in this rock
    other_forces
        Mean cutting forces in other rock, for the speeds needed there: '5 kN, 6.5 kN'
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["machine", "chain-cutter"], [], {"--pick-spacing": pick_spacing, "--feed": feed, "--chip": chip, "--force": force, "--other-forces": other_forces}, progress, output=output)


def machine_drum(
    *,
    diameter: Values,
    feed: Values,
    chip: Values,
    picks: Values,
    force: Values | None = None,
    other_forces: Values | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """Cutting speed of a drum or auger, and of the same in other rock.

    Parameters
    ----------
    diameter
        Diameter over the picks
    feed
        Feed of the machine
    chip
        Greatest thickness of the chip
    picks
        Picks in a cutting line
    force
        Mean cutting force in this rock
    other_forces
        Mean cutting forces in other rock, for the speeds needed there: '5 kN, 6.5 kN'
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["machine", "drum"], [], {"--diameter": diameter, "--feed": feed, "--chip": chip, "--picks": picks, "--force": force, "--other-forces": other_forces}, progress, output=output)


def machine_rotor(
    *,
    boom_radius: Values,
    slewing: Values,
    chip_width: Values,
    buckets: Values,
    boom_angle: Values,
    wheel_radius: Values,
    discharge: Values | None = None,
    release: Values | None = None,
    chute: Values | None = None,
    radius_ratio: Values | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """Greatest and least speed of a bucket wheel, and how many speeds their range asks for.

    The greatest still empties the buckets when the boom slews at its side, the least still throws onto the chute.
    Angles are about the wheel's axis from the horizontal, in the sense of rotation.

    Parameters
    ----------
    boom_radius
        Cutting radius of the boom
    slewing
        Slewing speed with the boom in the machine's axis, the least
    chip_width
        Width of the chip
    buckets
        Number of buckets
    boom_angle
        Slewing angle of the boom from the machine's axis
    wheel_radius
        Radius of the wheel
    discharge
        Discharge parameter Ω = ω²R/g, where it is known; otherwise ``release``, ``chute`` and ``radius_ratio``
    release
        Angle at which a particle leaves its bucket
    chute
        Angles of the chute's edge with the boom raised and lowered; the smaller Ω counts
    radius_ratio
        Radius of the chute's edge over that of the wheel
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["machine", "rotor"], [], {"--boom-radius": boom_radius, "--slewing": slewing, "--chip-width": chip_width, "--buckets": buckets, "--boom-angle": boom_angle, "--wheel-radius": wheel_radius, "--discharge": discharge, "--release": release, "--chute": chute, "--radius-ratio": radius_ratio}, progress, output=output)


def motor(
    file: Source | None = None,
    *,
    stator: Values | None = None,
    rotor: Values | None = None,
    z3: Values | None = None,
    z1: Values | None = None,
    zs: Values | None = None,
    module: Values | None = None,
    l: Values | None = None,
    a: Values | None = None,
    part: Values | None = None,
    cosine: bool = False,
    second_harmonic: Values | None = None,
    construction: bool = False,
    width: Values | None = None,
    pressure: Values | None = None,
    speed: Values | None = None,
    angle: Values | None = None,
    pressure_angle: Values | None = None,
    addendum: Values | None = None,
    clearance: Values | None = None,
    shift: Values | None = None,
    backlash: Values | None = None,
    fillet: Values | None = None,
    crest: Values | None = None,
    material: Values | None = None,
    oil: Values | None = None,
    gaps: Values | None = None,
    friction: Values | None = None,
    ports: Values | None = None,
    view: Literal["centrodes", "construction", "teeth", "motor", "chambers", "dimensions", "forces", "ports", "pressure", "stress", "efficiency"] | None = None,
    dpi: Values | None = None,
    svg: Values | None = None,
    dxf: Values | None = None,
    csv: Values | None = None,
    points: Values | None = None,
    project: Values | None = None,
    customer: Values | None = None,
    author: Values | None = None,
    date: Values | None = None,
    paper: Literal["a4", "letter"] | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """A hydromotor with non-circular wheels and floating satellites: geometry that closes, working data, teeth,
    drawings.

    A ring with N arches (the stator) and a sun with n lobes (the rotor), N + n round satellites between them that
    roll on both. Without ``zs`` the satellites that the other numbers admit are listed. The numbers leave one
    distance free: ``l``, ``a`` or ``part`` choose it. With both ``l`` and ``a`` the rotor need not close; the answer
    is then the construction of the arcs. Torque and flow are theoretical; ``oil``, ``gaps`` and ``friction`` add
    losses, ``ports`` the ports as they are made. Module: 0.001 to 1000 mm; width: 0.001 to 10 000 mm; l: at most 100
    times the stator's nominal radius m·Z₃/2. A rotor that reaches into the stator is refused.

    Parameters
    ----------
    file
        File of a motor in YAML, in place of the options that describe one; - for standard input
    stator
        Lobes of the stator, N
    rotor
        Lobes of the rotor, n: 1 to 3 fewer
    z3
        Teeth of the stator, Z₃: a whole number for each lobe
    z1
        Teeth of the rotor, Z₁; they follow from the others and are checked where given
    zs
        Teeth of a satellite, Z_s: fewer than (Z₃ − Z₁)/2. Without them all satellites are listed, each with a motor
    module
        Module of the teeth
    l
        Distance l of the centres of the stator's arcs at the troughs from the axis. Default: the middle of the family
    a
        Instead of ``l`` the distance a of the centres of the arcs at the crests. Together with ``l``:
        ``construction`` of arcs that need not close
    part
        Instead of ``l`` the part of the family, from 0 (arcs at the troughs vanish) to 1, even in 1/l
    cosine
        A rotor by the cosine law, and the stator conjugate to it: one motor, no family
    second_harmonic
        Relative amplitude ε₂ of a second harmonic of the cosine law
    construction
        The construction of the arcs in place of the motor: system (1), how far the rotor is from closing, and
        formulas (2)-(8). Drawings show it
    width
        Width of the wheels, for displacement, torque and forces
    pressure
        Pressure drop, high less low, for torque and forces
    speed
        Speed of the rotor, for flow and power
    angle
        Angle of the rotor from where one of its crests faces one of the stator's, for chambers, satellites and
        drawings. Default: that of the file, else 0 deg
    pressure_angle
        Pressure angle of the satellites
    addendum
        Addendum h_a*
    clearance
        Clearance c* of tips over roots
    shift
        Profile shift x of the satellites; the wheels have −x
    backlash
        Backlash j* along the pitch curves
    fillet
        Radius ρ* of the rounded tips of the cutters
    crest
        What lies in the middle of the stator's crests: space, tooth
    material
        Material of the teeth: youngs_modulus, poissons_ratio, contact_limit, root_limit. Default: steel without
        limits
    oil
        The fluid: viscosity or dynamic_viscosity, density, bulk_modulus, turbulence. 'viscosity: 46 mm²/s, density:
        870 kg/m³'
    gaps
        Gaps at each end face: satellites, rotor, rotor_bore, expansion, temperature_rise. 'satellites: 10 µm'
    friction
        Coefficient of friction of the flanks, one or from the least to the greatest
    ports
        Ports as made: part, or high and low; dead_volume, discharge, most_trapped. 'part: 0.95'
    view
        What is drawn into ``svg``, ``dxf``, or an ``output`` that ends in .svg, .dxf, .pdf or .png. Default: the
        whole motor
    dpi
        Pixels to an inch of a PNG image, 20 to 2400; an image has at most 100 million pixels. Default: 300
    svg
        File for the drawing as an SVG image, one unit a millimetre
    dxf
        File for the drawing as DXF in millimetres, for CAD
    csv
        File for points of the centrodes with direction and curvature, in millimetres and degrees
    points
        Points of each half-lobe in that file
    project
        What it is for, below the title and at the foot of each sheet
    customer
        For whom it is
    author
        Who made it
    date
        Its date, as it is to be read
    paper
        Paper to print it on. Default: the printer's
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["motor"], [file], {"--stator": stator, "--rotor": rotor, "--z3": z3, "--z1": z1, "--zs": zs, "--module": module, "--l": l, "--a": a, "--part": part, "--cosine": cosine, "--second-harmonic": second_harmonic, "--construction": construction, "--width": width, "--pressure": pressure, "--speed": speed, "--angle": angle, "--pressure-angle": pressure_angle, "--addendum": addendum, "--clearance": clearance, "--shift": shift, "--backlash": backlash, "--fillet": fillet, "--crest": crest, "--material": material, "--oil": oil, "--gaps": gaps, "--friction": friction, "--ports": ports, "--view": view, "--dpi": dpi, "--svg": svg, "--dxf": dxf, "--csv": csv, "--points": points, "--project": project, "--customer": customer, "--author": author, "--date": date, "--paper": paper}, progress, output=output)


def motor_search(
    *,
    displacement: Values | None = None,
    torque: Values | None = None,
    pressure: Values | None = None,
    speed: Values | None = None,
    module: Values | None = None,
    width: Values | None = None,
    tolerance: Values | None = None,
    width_over_diameter: Values | None = None,
    outer_diameter: Values | None = None,
    ripple: Values | None = None,
    stator: Values | None = None,
    rotor: Values | None = None,
    z3: Values | None = None,
    zs: Values | None = None,
    divisor: Literal["any", "one", "common"] | None = None,
    any_teeth: bool = False,
    objectives: Values | None = None,
    by: Values | None = None,
    places: Values | None = None,
    resolution: Values | None = None,
    every: bool = False,
    limit: Values | None = None,
    design: Values | None = None,
    save: Values | None = None,
    angle: Values | None = None,
    view: Literal["centrodes", "construction", "teeth", "motor", "chambers", "dimensions", "forces", "ports", "pressure", "stress", "efficiency"] | None = None,
    dpi: Values | None = None,
    svg: Values | None = None,
    dxf: Values | None = None,
    csv: Values | None = None,
    points: Values | None = None,
    pressure_angle: Values | None = None,
    addendum: Values | None = None,
    clearance: Values | None = None,
    shift: Values | None = None,
    backlash: Values | None = None,
    fillet: Values | None = None,
    crest: Values | None = None,
    flank_ripple: Values | None = None,
    least_torque: Values | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """Non-dominated motors for a displacement or torque.

    Every set of lobes and teeth is tried at places along its whole family; of those that pass the checks and limits,
    the motors remain that no other surpasses in all objectives together. The module is chosen from a list and the
    width follows, or the other way round. Between the places tried a motor may be better: by how much is estimated
    and said. The teeth are of one form, as `motor` has it; every motor listed keeps its limits and can have ideal
    ports. Module: 0.001 to 1000 mm; width: 0.001 to 10 000 mm; l: at most 100 times the stator's nominal radius
    m·Z₃/2. Ranges include both ends and may be open: 3..6, ..90.

    Parameters
    ----------
    displacement
        Displacement wanted: '250 cm3/rev'
    torque
        Mean torque wanted, without losses
    pressure
        Pressure drop, high less low
    speed
        Speed of the rotor, for flow and power
    module
        Modules to choose from: '2 mm, 2.5 mm'. Default: the first series of ISO 54, unless the width is given
    width
        Width; alone it gives the module, with ``module`` the displacement
    tolerance
        How far the displacement may lie from the wanted one, where module and width are given: 2%, or 0.02
    width_over_diameter
        Width over the stator's diameter, which then gives both module and width
    outer_diameter
        Greatest diameter of the stator's centrode
    ripple
        Greatest ripple of flow and torque, satellites sealing at the pitch points: 8%, or 0.08
    stator
        Lobes of the stator
    rotor
        Lobes of the rotor
    z3
        Teeth of the stator
    zs
        Teeth of a satellite
    divisor
        Common divisor of N and n: above 1 the wheels' bearings are unloaded, 1 makes for little ripple at the pitch
        points
    any_teeth
        Do not judge teeth and ports: list motors too whose teeth break their limits, or that can have no ideal ports
        (default: such motors are left out)
    objectives
        What the designs are held against each other by: see below
    by
        What the designs are ordered by, an objective; the first is the one that is drawn
    places
        Places along each interval of a family, before refinement
    resolution
        Difference in the objectives below which motors of one set count as one
    every
        Show every design in the table, not only the first of each set of lobes and teeth
    limit
        Show at most this many designs. Default: 12 in a table, otherwise all
    design
        Number of the design that is drawn, saved, or whose centrodes are written. Default: 1
    save
        File for the design as a motor, which `motor FILE`, `report` and `serve` read
    angle
        Angle of the rotor in the drawing. Default: 0
    view
        What is drawn into ``svg``, ``dxf``, or an ``output`` that ends in .svg, .dxf, .pdf or .png. Default: the
        whole motor
    dpi
        Pixels to an inch of a PNG image, 20 to 2400; an image has at most 100 million pixels. Default: 300
    svg
        File for the drawing as an SVG image, one unit a millimetre
    dxf
        File for the drawing as DXF in millimetres, for CAD
    csv
        File for points of the centrodes with direction and curvature, in millimetres and degrees
    points
        Points of each half-lobe in that file
    pressure_angle
        Pressure angle of the satellites
    addendum
        Addendum h_a*
    clearance
        Clearance c* of tips over roots
    shift
        Profile shift x of the satellites; the wheels have −x
    backlash
        Backlash j* along the pitch curves
    fillet
        Radius ρ* of the rounded tips of the cutters
    crest
        What lies in the middle of the stator's crests: space, tooth
    flank_ripple
        Greatest ripple of flow and torque, satellites sealing at the flanks: 8%, or 0.08
    least_torque
        Least torque over the mean, satellites sealing at the flanks: 94%, or 0.94
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["motor", "search"], [], {"--displacement": displacement, "--torque": torque, "--pressure": pressure, "--speed": speed, "--module": module, "--width": width, "--tolerance": tolerance, "--width-over-diameter": width_over_diameter, "--outer-diameter": outer_diameter, "--ripple": ripple, "--stator": stator, "--rotor": rotor, "--z3": z3, "--zs": zs, "--divisor": divisor, "--any-teeth": any_teeth, "--objectives": objectives, "--by": by, "--places": places, "--resolution": resolution, "--every": every, "--limit": limit, "--design": design, "--save": save, "--angle": angle, "--view": view, "--dpi": dpi, "--svg": svg, "--dxf": dxf, "--csv": csv, "--points": points, "--pressure-angle": pressure_angle, "--addendum": addendum, "--clearance": clearance, "--shift": shift, "--backlash": backlash, "--fillet": fillet, "--crest": crest, "--flank-ripple": flank_ripple, "--least-torque": least_torque}, progress, output=output)


def motor_forms(
    *,
    displacement: Values | None = None,
    torque: Values | None = None,
    pressure: Values | None = None,
    speed: Values | None = None,
    module: Values | None = None,
    width: Values | None = None,
    tolerance: Values | None = None,
    width_over_diameter: Values | None = None,
    outer_diameter: Values | None = None,
    ripple: Values | None = None,
    stator: Values | None = None,
    rotor: Values | None = None,
    z3: Values | None = None,
    zs: Values | None = None,
    divisor: Literal["any", "one", "common"] | None = None,
    families: Values | None = None,
    places: Values | None = None,
    pressure_angle: Values | None = None,
    addendum: Values | None = None,
    shift: Values | None = None,
    clearance: Values | None = None,
    fillet: Values | None = None,
    backlash: Values | None = None,
    crests: Values | None = None,
    contact_ratio: Values | None = None,
    contact_limit: Values | None = None,
    root_limit: Values | None = None,
    youngs_modulus: Values | None = None,
    poissons_ratio: Values | None = None,
    flank_ripple: Values | None = None,
    least_torque: Values | None = None,
    contact_stress: Values | None = None,
    root_stress: Values | None = None,
    allowed_pressure: Values | None = None,
    objectives: Values | None = None,
    resolution: Values | None = None,
    exact: bool = False,
    by: Values | None = None,
    every: bool = False,
    limit: Values | None = None,
    design: Values | None = None,
    save: Values | None = None,
    angle: Values | None = None,
    view: Literal["centrodes", "construction", "teeth", "motor", "chambers", "dimensions", "forces", "ports", "pressure", "stress", "efficiency"] | None = None,
    dpi: Values | None = None,
    svg: Values | None = None,
    dxf: Values | None = None,
    csv: Values | None = None,
    points: Values | None = None,
    output: Path | None = None,
    progress: Progress | None = None,
) -> Answer:
    """Non-dominated motors with their tooth forms for a displacement or torque.

    Every set of lobes and teeth is tried at places of its families with every tooth form within the steps; of the
    points that keep all checks, limits of the teeth and bounds, those remain that no other surpasses in all
    objectives together. What cannot be better than a design by more than the resolution is left out, and counted.
    Steps have both ends and how many values: 20deg..30deg/5. Other ranges include both ends and may be open: 3..6,
    ..90.

    Parameters
    ----------
    displacement
        Displacement wanted: '250 cm3/rev'
    torque
        Mean torque wanted, without losses
    pressure
        Pressure drop, high less low
    speed
        Speed of the rotor, for flow and power
    module
        Modules to choose from: '2 mm, 2.5 mm'. Default: the first series of ISO 54, unless the width is given
    width
        Width; alone it gives the module, with ``module`` the displacement
    tolerance
        How far the displacement may lie from the wanted one, where module and width are given: 2%, or 0.02
    width_over_diameter
        Width over the stator's diameter, which then gives both module and width
    outer_diameter
        Greatest diameter of the stator's centrode
    ripple
        Greatest ripple of flow and torque, satellites sealing at the pitch points: 8%, or 0.08
    stator
        Lobes of the stator
    rotor
        Lobes of the rotor
    z3
        Teeth of the stator
    zs
        Teeth of a satellite
    divisor
        Common divisor of N and n: above 1 the wheels' bearings are unloaded, 1 makes for little ripple at the pitch
        points
    families
        Families of motors: arcs, cosine, second-harmonic
    places
        Places along each interval of a family
    pressure_angle
        Pressure angle of the satellites
    addendum
        Addendum h_a*
    shift
        Profile shift x of the satellites; the wheels have −x
    clearance
        Clearance c* of tips over roots
    fillet
        Radius ρ* of the rounded tips of the cutters
    backlash
        Backlash j* along the pitch curves, one value
    crests
        What lies in the middle of the stator's crests: space (as of `motor`), tooth
    contact_ratio
        Least contact ratio: the shortest path of contact of any flank over the base pitch
    contact_limit
        Contact stress that the material bears; with ``root_limit`` the allowed pressure follows
    root_limit
        Stress that the roots of the teeth bear
    youngs_modulus
        Young's modulus of the material
    poissons_ratio
        Poisson's ratio of the material
    flank_ripple
        Greatest ripple of flow and torque, satellites sealing at the flanks: 8%, or 0.08
    least_torque
        Least torque over the mean, satellites sealing at the flanks: 94%, or 0.94
    contact_stress
        Greatest contact stress at ``pressure``
    root_stress
        Greatest bending stress at a root at ``pressure``
    allowed_pressure
        Least pressure drop that the material must allow
    objectives
        What the designs are held against each other by: see below
    resolution
        Difference in the objectives up to which a design is as good as another
    exact
        The exact front, without a resolution
    by
        What the designs are ordered by, an objective; the first is the one that is drawn
    every
        Show every design in the table, not only the first of each set of lobes and teeth
    limit
        Show at most this many designs. Default: 12 in a table, otherwise all
    design
        Number of the design that is drawn, saved, or whose centrodes are written. Default: 1
    save
        File for the design as a motor, which `motor FILE`, `report` and `serve` read
    angle
        Angle of the rotor in the drawing. Default: 0
    view
        What is drawn into ``svg``, ``dxf``, or an ``output`` that ends in .svg, .dxf, .pdf or .png. Default: the
        whole motor
    dpi
        Pixels to an inch of a PNG image, 20 to 2400; an image has at most 100 million pixels. Default: 300
    svg
        File for the drawing as an SVG image, one unit a millimetre
    dxf
        File for the drawing as DXF in millimetres, for CAD
    csv
        File for points of the centrodes with direction and curvature, in millimetres and degrees
    points
        Points of each half-lobe in that file
    output
        File for the answer too, by the end of its name: .json, .csv, tables in .txt, and where the command
        line writes them a page in .html or a drawing. The answer lists what the file does: tables and pages
        show as many rows as on the command line
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Answer
        The record of ``--format json``.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.answer(["motor", "forms"], [], {"--displacement": displacement, "--torque": torque, "--pressure": pressure, "--speed": speed, "--module": module, "--width": width, "--tolerance": tolerance, "--width-over-diameter": width_over_diameter, "--outer-diameter": outer_diameter, "--ripple": ripple, "--stator": stator, "--rotor": rotor, "--z3": z3, "--zs": zs, "--divisor": divisor, "--families": families, "--places": places, "--pressure-angle": pressure_angle, "--addendum": addendum, "--shift": shift, "--clearance": clearance, "--fillet": fillet, "--backlash": backlash, "--crests": crests, "--contact-ratio": contact_ratio, "--contact-limit": contact_limit, "--root-limit": root_limit, "--youngs-modulus": youngs_modulus, "--poissons-ratio": poissons_ratio, "--flank-ripple": flank_ripple, "--least-torque": least_torque, "--contact-stress": contact_stress, "--root-stress": root_stress, "--allowed-pressure": allowed_pressure, "--objectives": objectives, "--resolution": resolution, "--exact": exact, "--by": by, "--every": every, "--limit": limit, "--design": design, "--save": save, "--angle": angle, "--view": view, "--dpi": dpi, "--svg": svg, "--dxf": dxf, "--csv": csv, "--points": points}, progress, output=output)


def draw(
    gearbox: Source,
    *,
    view: Literal["scheme", "speeds", "levers", "ladder", "map", "centrodes", "construction", "teeth", "motor", "chambers", "dimensions", "forces", "ports", "pressure", "stress", "efficiency"] | None = None,
    transmission: Values | None = None,
    gear: Values | None = None,
    power: bool = False,
    whole: bool = False,
    same_side: bool = False,
    to_scale: bool = False,
    speeds: Values | None = None,
    torques: Values | None = None,
    k1: Values | None = None,
    k2: Values | None = None,
    ratio1: Values | None = None,
    ratio2: Values | None = None,
    efficiency: Values | None = None,
    title: Values | None = None,
    dpi: Values | None = None,
    svg: Values | None = None,
    dxf: Values | None = None,
    progress: Progress | None = None,
) -> Drawing:
    """A gearbox as a drawing: its scheme, speed diagram, lever diagram or ratio ladder; a hydromotor from its file.

    The gearbox is a scheme of the catalogue (I … III-3) unless a file has that name, or comes from a file as for
    `analyze`. The scheme is the section by the half-plane above the axis with the usual symbols. No link crosses
    another in it; a gearbox for which this is impossible is refused, and the parts in conflict are named. Drawings
    are in millimetres.

    Parameters
    ----------
    gearbox
        A scheme of the catalogue, a structure as `select` names it (D.T1.B+T2.B.T1), or the file of a gearbox or
        motor in YAML; - for standard input
    view
        What is drawn.

        Default: the scheme of a gearbox, the whole motor of a motor's file.
    transmission
        One transmission of a list: its name, or a part that no other name has
    gear
        One gear: engaged shift elements are filled, links at rest are grey
    power
        The width of each line of the scheme shows the power through it
    whole
        Both halves of the scheme, the lower a mirror image
    same_side
        Input and output of the scheme on the left
    to_scale
        Gears and planet axes of the scheme at heights in proportion to their pitch radii; needs k or teeth.

        Sets with module and teeth are in one scale, which the picture names with a scale bar; without modules all are
        taken as equal. Widths along the axis are not to scale, and shafts and drums stand where there is room.
    speeds
        A map of one gear over these speeds of the input: 500rpm..3000rpm/6, both ends and how many places; with
        ``torques``
    torques
        Torques on the input of the map: 10N·m..100N·m/10
    k1
        Ring-to-sun ratio k of set 1, of a scheme or structure by its name
    k2
        Ring-to-sun ratio k of set 2
    ratio1
        Ratio of gear 1, in place of ``k1``
    ratio2
        Ratio of gear 2, in place of ``k2``
    efficiency
        With ``power``: efficiency with the carrier fixed of each set for which no losses are stated. Default: no
        losses
    title
        Title in place of the gearbox's name and gear
    dpi
        Pixels to an inch of a PNG image, 20 to 2400; an image has at most 100 million pixels. Default: 300
    svg
        File for the drawing as SVG
    dxf
        File for the drawing as DXF, for CAD
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Drawing
        As SVG; its ``save`` writes SVG, DXF, PDF and PNG.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.drawing(["draw"], [gearbox], {"--view": view, "--transmission": transmission, "--gear": gear, "--power": power, "--whole": whole, "--same-side": same_side, "--to-scale": to_scale, "--speeds": speeds, "--torques": torques, "--k1": k1, "--k2": k2, "--ratio1": ratio1, "--ratio2": ratio2, "--efficiency": efficiency, "--title": title, "--dpi": dpi, "--svg": svg, "--dxf": dxf}, progress)


def report(
    gearbox: Source,
    *,
    k1: Values | None = None,
    k2: Values | None = None,
    ratio1: Values | None = None,
    ratio2: Values | None = None,
    transmission: Values | None = None,
    efficiency: Values | None = None,
    torque: Values | None = None,
    power: Values | None = None,
    speed: Values | None = None,
    to_scale: bool = False,
    speeds: Values | None = None,
    harmonics: Values | None = None,
    transmission_error: Values | None = None,
    ring_transmission_error: Values | None = None,
    damping: Values | None = None,
    without_gyroscopic: bool = False,
    coupled: bool = False,
    project: Values | None = None,
    customer: Values | None = None,
    author: Values | None = None,
    date: Values | None = None,
    paper: Literal["a4", "letter"] | None = None,
    progress: Progress | None = None,
) -> Page:
    """A page about a gearbox, a drive, a motor or a scenario: the answer, then tables, drawings, plots, checks,
    sources, the input.

    One HTML file that needs no network, to be read in a browser and printed. What the file describes shows in its
    keys: power and ratio a drive; gearbox, or a list of transmissions, gearboxes; stator and rotor a motor; scenario
    a gearbox in motion.

    Parameters
    ----------
    gearbox
        The file, in YAML, or - for standard input; or a scheme of the catalogue (I … III-3) or a structure
        (D.T1.B+T2.B.T1) by its name
    k1
        Ring-to-sun ratio k of set 1, of a scheme or structure by its name
    k2
        Ring-to-sun ratio k of set 2
    ratio1
        Ratio of gear 1, in place of ``k1``
    ratio2
        Ratio of gear 2, in place of ``k2``
    transmission
        One transmission of a list: its name, or a part that no other name has
    efficiency
        Efficiency with the carrier fixed of each set for which the file states no losses: 0.97 or 97%. Of a compound
        set each mesh takes its square root
    torque
        Torque on the input: 500 N·m
    power
        Power into the input: 75 kW; needs ``speed``
    speed
        Speed of the input: 1475 rpm
    to_scale
        Schemes with gears at the heights of their pitch radii, as `draw ``to_scale``` draws them
    speeds
        Resonances and frequencies over these speeds of the input: 500rpm..3000rpm/11, both ends and how many places
    harmonics
        How many harmonics of the meshes. Default: 3
    transmission_error
        Transmission error of the meshes, harmonics from the first: 3um,1um. Tells the forces that it makes
    ring_transmission_error
        The same of the ring's meshes, where it is another
    damping
        Damping ratio of every mode, such as 0.03 or 3%
    without_gyroscopic
        These forces without the gyroscopic effect of the carrier's speed
    coupled
        Modes of the whole gearbox in the plane, with all sets on common links
    project
        What it is for, below the title and at the foot of each sheet
    customer
        For whom it is
    author
        Who made it
    date
        Its date, as it is to be read
    paper
        Paper to print it on. Default: the printer's
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    Page
        Shown in a notebook; its ``save`` writes it.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.page(["report"], [gearbox], {"--k1": k1, "--k2": k2, "--ratio1": ratio1, "--ratio2": ratio2, "--transmission": transmission, "--efficiency": efficiency, "--torque": torque, "--power": power, "--speed": speed, "--to-scale": to_scale, "--speeds": speeds, "--harmonics": harmonics, "--transmission-error": transmission_error, "--ring-transmission-error": ring_transmission_error, "--damping": damping, "--without-gyroscopic": without_gyroscopic, "--coupled": coupled, "--project": project, "--customer": customer, "--author": author, "--date": date, "--paper": paper}, progress, many={"--transmission-error": "repeated", "--ring-transmission-error": "repeated"})


def schema(
    of: Literal["drive", "gearbox", "transmissions", "motor", "scenario", "answer-analyze", "answer-analyze-gear", "answer-analyze-inputs", "answer-analyze-map", "answer-analyze-combinations", "answer-analyze-shifts", "answer-analyze-formulas", "answer-transmissions", "answer-compare", "answer-drive", "answer-motor", "answer-motor-satellites", "answer-motor-construction", "answer-motor-search", "answer-motor-forms", "answer-teeth", "answer-teeth-double-planet", "answer-teeth-shifted", "answer-select", "answer-select-teeth", "answer-strength", "answer-sheet", "answer-size", "answer-design", "answer-losses", "answer-losses-map", "answer-simulate", "answer-simulate-sweep", "answer-vibrate", "answer-synthesize", "answer-schemes", "answer-scheme", "answer-machines", "answer-machine-speeds", "answer-machine-chain-cutter", "answer-machine-drum", "answer-machine-rotor", "answer-draw", "answer-report", "answer-error"],
    *,
    output: Values | None = None,
    progress: Progress | None = None,
) -> str:
    """The JSON Schema of a file that the program reads, or of an answer in JSON.

    Parameters
    ----------
    of
        Which file or answer
    output
        File for the answer, written whole or not at all. Default: standard output
    progress
        Called with a line of text now and then while long work runs.

    Returns
    -------
    str
        What the command line writes to standard output.

    Raises
    ------
    Refused
        What is given cannot be; with the option or the place in the file.
    NothingFound
        A sound question without an answer within its bounds.
    FileFailure
        A file cannot be read or written.
    """
    return _call.text(["schema"], [of], {"--output": output}, progress)
