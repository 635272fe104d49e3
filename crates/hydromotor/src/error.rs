//! Errors of this crate.

use crate::quantity::{ArcsFault, Choice, FamilyFault, OpenPair, PortSide, Quantity, WheelKind};

/// An input that describes no motor.
#[derive(Debug, Clone, PartialEq, thiserror::Error, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Error {
    /// A wheel without lobes.
    #[error("a {wheel} with 0 lobes: it has at least 1")]
    NoLobes {
        /// The wheel concerned.
        wheel: WheelKind,
    },
    /// A wheel without teeth.
    #[error("a {wheel} with 0 teeth: it has at least 1")]
    NoTeeth {
        /// The wheel concerned.
        wheel: WheelKind,
    },
    /// More teeth than the crate allows.
    #[error("a {wheel} with {teeth} teeth: at most {most}")]
    TooManyTeeth {
        /// The wheel concerned.
        wheel: WheelKind,
        /// The teeth given.
        teeth: u32,
        /// The greatest number allowed.
        most: u32,
    },
    /// A stator with no more lobes than the rotor: the centrodes would interfere.
    #[error(
        "{stator} stator lobes on {rotor} rotor lobes: the stator has from 1 to {most} more lobes than \
         the rotor, else the centrodes interfere"
    )]
    LobesNotMore {
        /// Lobes of the stator, N.
        stator: u32,
        /// Lobes of the rotor, n.
        rotor: u32,
        /// The greatest difference allowed.
        most: u32,
    },
    /// A stator with too many more lobes than the rotor, so that neighbouring satellites collide.
    #[error(
        "{stator} stator lobes on {rotor} rotor lobes: the stator has at most {most} more lobes than the \
         rotor, else the satellites are no neighbours that bound chambers"
    )]
    LobesTooDifferent {
        /// Lobes of the stator, N.
        stator: u32,
        /// Lobes of the rotor, n.
        rotor: u32,
        /// The greatest difference allowed.
        most: u32,
    },
    /// Teeth that are not evenly shared by the lobes.
    #[error(
        "{teeth} {wheel} teeth on {lobes} lobes: every lobe has a whole number of teeth, as {below} or \
         {above} teeth give"
    )]
    TeethPerLobe {
        /// The wheel concerned.
        wheel: WheelKind,
        /// Teeth of the wheel.
        teeth: u32,
        /// Lobes of the wheel.
        lobes: u32,
        /// The next smaller number allowed; at least one tooth a lobe.
        below: u32,
        /// The next greater number allowed.
        above: u32,
    },
    /// Lobes of stator and rotor with different numbers of teeth.
    #[error(
        "{rotor_teeth} rotor teeth: a rotor lobe has as many teeth as a stator lobe, Z_1/n = Z_3/N, which \
         needs {needed}"
    )]
    TeethPerLobeDiffer {
        /// Teeth of the rotor given.
        rotor_teeth: u32,
        /// Teeth of the rotor needed.
        needed: u32,
    },
    /// A satellite that fills the gap of round wheels, or more.
    #[error(
        "satellites of {teeth} teeth: Z_s lies below (Z_3 - Z_1)/2 = {limit}, else the wheels would be \
         round or not fit; at most {most}"
    )]
    SatelliteTooLarge {
        /// Teeth of a satellite given.
        teeth: u32,
        /// `(Z_3 − Z_1)/2`.
        limit: f64,
        /// The greatest number allowed.
        most: u32,
    },
    /// A range written the wrong way round.
    #[error("{what} from {from} to {to}: write the smaller first")]
    EmptyRange {
        /// Quantity of the range.
        what: Quantity,
        /// Lower end.
        from: u32,
        /// Upper end.
        to: u32,
    },
    /// A quantity that must be finite and above 0.
    #[error("{quantity} is {}; it must be finite and above 0", of_unit(*value, unit))]
    NotPositive {
        /// The quantity's name.
        quantity: Quantity,
        /// The value given, in `unit`.
        value: f64,
        /// Unit of `value`.
        unit: &'static str,
    },
    /// A quantity that must be finite.
    #[error("{quantity} is {}; it must be finite", of_unit(*value, unit))]
    NotFinite {
        /// The quantity's name.
        quantity: Quantity,
        /// The value given, in `unit`.
        value: f64,
        /// Unit of `value`.
        unit: &'static str,
    },
    /// A quantity outside its range.
    #[error("{quantity} is {}; it must lie between {low} and {}", of_unit(*value, unit), of_unit(*high, unit))]
    OutOfRange {
        /// The quantity's name.
        quantity: Quantity,
        /// The value given, in `unit`.
        value: f64,
        /// Lower bound, in `unit`.
        low: f64,
        /// Upper bound, in `unit`.
        high: f64,
        /// Unit of the three numbers.
        unit: &'static str,
    },
    /// Two parameters of system (1) that leave the others open.
    #[error("{first} and {second} do not determine the arcs: {why}")]
    PairUndetermined {
        /// The first parameter.
        first: Quantity,
        /// The second parameter.
        second: Quantity,
        /// Reason.
        why: OpenPair,
    },
    /// Two parameters of system (1) that no pair of arcs has.
    #[error("no pair of arcs has {first} and {second} of these values: {why}")]
    NoArcs {
        /// The first parameter.
        first: Quantity,
        /// The second parameter.
        second: Quantity,
        /// The condition that fails.
        why: ArcsFault,
    },
    /// A distance `l` at which no motor of these numbers closes.
    #[error("l = {l_mm} mm: a motor of these numbers closes for l {}", ranges(.intervals_mm))]
    OutsideFamily {
        /// The distance given, mm.
        l_mm: f64,
        /// The family's intervals, mm.
        intervals_mm: Vec<(f64, f64)>,
    },
    /// A distance `a` that no motor of these numbers has.
    #[error("a = {a_mm} mm: a motor of these numbers closes for a {}", ranges(.intervals_mm))]
    OutsideFamilyByCrest {
        /// The distance given, mm.
        a_mm: f64,
        /// The family's intervals of it, mm.
        intervals_mm: Vec<(f64, f64)>,
    },
    /// Numbers for which no pair of arcs closes.
    #[error("no motor of two arcs closes with these numbers: {why}; take more satellite teeth")]
    NoFamily {
        /// The condition that fails.
        why: FamilyFault,
    },
    /// A rotor that reaches into the stator as it turns.
    #[error(
        "the rotor reaches {:.4} mm into the stator: its crests lie {rotor_mm:.4} mm from the axis, the stator's troughs \
         {stator_mm:.4} mm; take more satellite teeth, which makes the lobes lower",
        .rotor_mm - .stator_mm
    )]
    RotorInStator {
        /// The rotor's greatest radius, mm.
        rotor_mm: f64,
        /// The stator's least radius, mm.
        stator_mm: f64,
    },
    /// A chamber that vanishes or is less than nothing.
    #[error(
        "the least area of a chamber is {area_mm2:.4} mm²; it must be above 0: take more satellite teeth, which makes the lobes \
         lower"
    )]
    NoChamber {
        /// The least area, mm².
        area_mm2: f64,
    },
    /// Numbers for which no cosine-law rotor closes.
    #[error(
        "no cosine-law rotor closes with these numbers: at the relative amplitude {cusp_amplitude:.6}, where \
         the stator gets cusps, its half-lobe still spans {excess_deg:.6}° too much; take more satellite teeth, or try a second harmonic"
    )]
    NoCosineRotor {
        /// The relative amplitude at which the stator gets cusps.
        cusp_amplitude: f64,
        /// Angle that the stator's half-lobe spans too much there, degrees.
        excess_deg: f64,
    },
    /// An amplitude of the second harmonic with which no rotor closes without cusps.
    #[error(
        "ε₂ = {second}: a second-harmonic rotor of these numbers closes without cusps for ε₂ between \
         {low:.6} and {high:.6}"
    )]
    OutsideHarmonic {
        /// The amplitude given.
        second: f64,
        /// The range's lower end.
        low: f64,
        /// The range's upper end.
        high: f64,
    },
    /// Numbers for which no second-harmonic rotor closes without cusps.
    #[error(
        "no second-harmonic rotor closes with these numbers without cusps: where the stator gets them, its \
         half-lobe still spans at least {excess_deg:.6}° too much; take more satellite teeth"
    )]
    NoSecondHarmonicRotor {
        /// Least angle that the stator's half-lobe spans too much there, degrees.
        excess_deg: f64,
    },
    /// A tooth whose flanks meet below its tip.
    #[error("a tooth of the {wheel} is pointed at an addendum of {addendum} modules: below {most:.4}")]
    PointedTip {
        /// The wheel or tool concerned.
        wheel: WheelKind,
        /// The addendum, modules.
        addendum: f64,
        /// Height at which the flanks meet, modules.
        most: f64,
    },
    /// A rounding for which the tip of the tool has no room.
    #[error("a fillet of {fillet} modules: the tip of the {tool} has room for at most {most:.4}")]
    FilletTooLarge {
        /// The tool that is rounded.
        tool: WheelKind,
        /// The radius given, modules.
        fillet: f64,
        /// The greatest radius, modules.
        most: f64,
    },
    /// A flank that ends before the tip.
    #[error("a flank of the {wheel} does not reach an addendum of {addendum} modules: it has a cusp before")]
    NoTip {
        /// The wheel concerned.
        wheel: WheelKind,
        /// The addendum, modules.
        addendum: f64,
    },
    /// Teeth whose flanks are cut away up to the tip.
    #[error(
        "the {wheel}'s flanks are cut away by its tool up to the tip: take a greater pressure angle or shift"
    )]
    NoFlank {
        /// The wheel concerned.
        wheel: WheelKind,
    },
    /// A satellite that the flanks cannot hold against the pressure.
    #[error(
        "the flanks cannot hold a satellite where the centrode slopes by {slope_deg:.4}° against its push: with this pressure angle \
         by less than {most_deg:.4}°"
    )]
    CannotHold {
        /// Slope `σ·μ`, degrees.
        slope_deg: f64,
        /// The slope at which the lines of action lie along the ray, `90° − α`, degrees.
        most_deg: f64,
    },
    /// A search without a module to choose from.
    #[error("no modules to choose from: give at least one, or a width, or a width over the diameter")]
    NoModules,
    /// Limits written the wrong way round, or below 0.
    #[error("{what} from {from} to {to}{}: write the smaller first, neither below 0", spaced(.unit))]
    EmptyLimits {
        /// Quantity that is limited.
        what: Quantity,
        /// Lower end.
        from: f64,
        /// Upper end.
        to: f64,
        /// Unit of both.
        unit: &'static str,
    },
    /// Steps that lead nowhere.
    #[error(
        "{quantity} from {from} to {to} in steps of {step}{}: write the smaller end first, and a step above 0 where they differ",
        spaced(.unit)
    )]
    EmptySteps {
        /// Quantity that is stepped.
        quantity: Quantity,
        /// First value.
        from: f64,
        /// Last value.
        to: f64,
        /// Step.
        step: f64,
        /// Unit of the three.
        unit: &'static str,
    },
    /// More tooth forms than a search allows.
    #[error("{forms} tooth forms within the steps: a search takes at most {most}; take greater steps")]
    TooManyForms {
        /// Forms within the steps.
        forms: u64,
        /// The greatest number allowed.
        most: u64,
    },
    /// A search without something to choose from.
    #[error("no {what} to choose from: give at least one")]
    NothingToChoose {
        /// Kind of thing that is missing.
        what: Choice,
    },
    /// Objectives of flanks under load without the inputs of their calculation.
    #[error("objectives of flanks under load without materials: give them, or other objectives")]
    NoFlankOrder,
    /// A limit of a stress without a pressure drop.
    #[error("a limit of the {quantity} without a pressure drop: give the pressure drop")]
    NoPressureDrop {
        /// The stress.
        quantity: Quantity,
    },
    /// A search that its observer ended.
    #[error("the search was cancelled")]
    Cancelled,
    /// More sets of numbers than a search allows.
    #[error("{sets} sets of numbers within the bounds: a search takes at most {most}; narrow the bounds")]
    TooManySets {
        /// Sets within the bounds.
        sets: u64,
        /// The greatest number allowed.
        most: u64,
    },
    /// A port where no chamber ever is.
    #[error(
        "the {side} port lies from {from_mm:.4} to {to_mm:.4} mm from the axis, where no chamber ever is: \
         chambers lie between {low_mm:.4} and {high_mm:.4} mm"
    )]
    PortOutside {
        /// Pressure of the port.
        side: PortSide,
        /// Least distance of the port from the axis, mm.
        from_mm: f64,
        /// Greatest distance of the port from the axis, mm.
        to_mm: f64,
        /// The rotor's least radius, mm.
        low_mm: f64,
        /// The stator's greatest radius, mm.
        high_mm: f64,
    },
    /// Ports of both pressures that share an area.
    #[error("a high-pressure and a low-pressure port overlap: move them apart, or make them smaller")]
    PortsOverlap,
    /// Centrodes too steep for ports.
    #[error(
        "ports of this motor: its centrodes slope by {slope_deg:.4}° against the circle about the axis, and ports need at most \
         {most_deg}°; take more satellite teeth, or leave the ports out"
    )]
    SteepCentrode {
        /// The greatest slope `|μ|`, degrees.
        slope_deg: f64,
        /// The greatest that is allowed, degrees.
        most_deg: f64,
    },
    /// A satellite that reaches across the ray through its neighbour's contacts.
    #[error(
        "ports of this motor: a satellite reaches {by_mm:.4} mm across the ray from the axis through its neighbour's contacts with the \
         rotor at {rotation_deg:.4}°, so that the ray does not part the chambers; take other numbers or another l, or leave the ports out"
    )]
    SatelliteAcrossRay {
        /// Greatest reach across the ray, mm.
        by_mm: f64,
        /// A rotation of the rotor at which it is so, degrees.
        rotation_deg: f64,
    },
    /// A satellite that cuts into a wheel away from its contact.
    #[error(
        "ports of this motor: the pitch circle of a satellite reaches {by_mm:.4} mm into the {wheel} beside its contact with the rotor at \
         {rotation_deg:.4}°; take more satellite teeth or another l, or leave the ports out"
    )]
    SatelliteInWheel {
        /// The wheel.
        wheel: WheelKind,
        /// Greatest reach into the wheel, mm.
        by_mm: f64,
        /// A rotation of the rotor at which it is so, degrees.
        rotation_deg: f64,
    },
    /// A port that stays covered.
    #[error(
        "the {side} ports never open: satellites, rotor or stator cover them at every angle; a port that opens \
         lies about {radius_mm:.4} mm from the axis at {angle_deg:.4}° from a crest"
    )]
    PortNeverOpens {
        /// Pressure of the ports.
        side: PortSide,
        /// Distance of the ideal port's centre from the axis, mm.
        radius_mm: f64,
        /// Polar angle of the ideal port from the crest, degrees.
        angle_deg: f64,
    },
    /// A port that a chamber always sees.
    #[error(
        "the {side} ports never close: every chamber is open to them at every angle; a hole closes up to a diameter \
         of {most_mm:.4} mm at {radius_mm:.4} mm from the axis and {angle_deg:.4}° from a crest"
    )]
    PortNeverCloses {
        /// Pressure of the ports.
        side: PortSide,
        /// The greatest diameter of a hole that closes, mm.
        most_mm: f64,
        /// Distance of the ideal port's centre from the axis, mm.
        radius_mm: f64,
        /// Polar angle of the ideal port from the crest, degrees.
        angle_deg: f64,
    },
    /// Ports that leave no opening at some angle.
    #[error(
        "all {side} ports are closed at a rotation of {rotation_deg:.4}°: a flow through them needs one open at every angle"
    )]
    NoOpening {
        /// Pressure of the ports.
        side: PortSide,
        /// A rotation of the rotor at which it is so, degrees.
        rotation_deg: f64,
    },
    /// Ports that were made for another motor.
    #[error("the ports are those of another motor: give ports of the same numbers, module and shape")]
    OtherMotor,
    /// A gap in which the flow is not laminar.
    #[error(
        "the Reynolds number in the gap of the {wheel} is {reynolds:.0}: the laminar law holds up to {most}, here up to a gap \
         of {gap_most_um:.2} µm; a turbulent law needs its factor and exponent"
    )]
    NotLaminar {
        /// The wheel at whose faces the gap is.
        wheel: WheelKind,
        /// The Reynolds number by the laminar law.
        reynolds: f64,
        /// The greatest of the laminar range.
        most: f64,
        /// The gap at which it is reached, µm.
        gap_most_um: f64,
    },
    /// A play that heat takes up.
    #[error(
        "an axial play of {play_um:.2} µm: the expansion takes up {closed_um:.2} µm; the play must be greater, or the satellite at most \
         {most_k:.2} K warmer than the housing"
    )]
    PlayClosed {
        /// The play when cold, µm.
        play_um: f64,
        /// Expansion by heat, µm.
        closed_um: f64,
        /// The difference of temperatures that takes up all, K.
        most_k: f64,
    },
}

impl Error {
    /// Name of the fault, which does not change with the message: `no-lobes`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.into()
    }
}

/// A number with its unit, without the rounding of binary fractions.
fn of_unit(value: f64, unit: &str) -> String {
    let value: f64 = format!("{value:.11e}").parse().unwrap_or(value);
    format!("{value}{}", spaced(unit))
}

/// A unit after its number, with a space except for degrees; empty for a plain number.
fn spaced(unit: &str) -> String {
    if unit.is_empty() || unit == "°" { unit.to_owned() } else { format!(" {unit}") }
}

fn ranges(intervals_mm: &[(f64, f64)]) -> String {
    let range = |&(low, high): &(f64, f64)| format!("from {low:.6} to {high:.6} mm");
    intervals_mm.iter().map(range).collect::<Vec<_>>().join(" or ")
}
