//! The units of each dimension, and how a unit is recognised however it is spelled.
//!
//! A spelling is brought to a *key* before it is looked up: `·`, `⋅`, `*` and a space between letters are one
//! product sign; superscripts and `^` are plain digits; both code points of `µ` are `u`; the Unicode minus is
//! `-`. Capitals count: `mN·m` is not `MN·m`.

use std::f64::consts::{PI, TAU};

use super::dimension::Dimension::{self, *};

/// A unit of measure.
#[derive(Debug, PartialEq)]
pub struct Unit {
    /// The dimension that it measures.
    pub dimension: Dimension,
    /// The name we write: `kg·m²`, `rpm`.
    pub symbol: &'static str,
    /// Value of the unit in SI units.
    pub factor: f64,
    /// Whether a number counts how many go into the quantity: 8 DP are 25.4 mm over 8.
    pub is_reciprocal: bool,
    keys: &'static [&'static str],
}

impl Unit {
    /// Value in SI units of a number of the unit, and the other way round.
    #[must_use]
    pub fn converted(&self, value: f64) -> f64 {
        if self.is_reciprocal { self.factor / value } else { self.factor * value }
    }

    /// The spellings understood, in their plain form; others that differ only in product signs, superscripts
    /// or `^` are understood too.
    #[must_use]
    pub const fn spellings(&self) -> &'static [&'static str] {
        self.keys
    }
}

const fn unit(
    dimension: Dimension,
    symbol: &'static str,
    factor: f64,
    keys: &'static [&'static str],
) -> Unit {
    Unit { dimension, symbol, factor, is_reciprocal: false, keys }
}

const GRAVITY: f64 = 9.806_65; // standard gravity, exact by definition
const METRIC_HP: f64 = 735.498_75; // 75 kgf·m/s, exact
const IMPERIAL_HP: f64 = 745.699_871_582_270_2; // 550 ft·lbf/s
const INCH: f64 = 0.0254; // exact
const FOOT: f64 = 0.3048; // exact
const POUND: f64 = 0.453_592_37; // exact
const POUND_FORCE: f64 = POUND * GRAVITY;

// The first unit of each table is the usual one: the one proposed for a bare number.

const DIMENSIONLESS: &[Unit] = &[
    unit(Dimensionless, "1", 1.0, &["1"]),
    unit(Dimensionless, "%", 1e-2, &["%"]),
    unit(Dimensionless, "‰", 1e-3, &["‰"]),
];

const LENGTH: &[Unit] = &[
    unit(Length, "mm", 1e-3, &["mm"]),
    unit(Length, "µm", 1e-6, &["um"]),
    unit(Length, "cm", 1e-2, &["cm"]),
    unit(Length, "dm", 1e-1, &["dm"]),
    unit(Length, "m", 1.0, &["m"]),
    unit(Length, "km", 1e3, &["km"]),
    unit(Length, "in", INCH, &["in", "inch"]),
    unit(Length, "ft", FOOT, &["ft"]),
];

// Besides those of a length. The diametral pitch counts teeth on an inch of diameter: a module of 25.4 mm
// over it.
const MODULE: &[Unit] =
    &[Unit { dimension: Module, symbol: "DP", factor: INCH, is_reciprocal: true, keys: &["DP"] }];

const AREA: &[Unit] = &[
    unit(Area, "mm²", 1e-6, &["mm2"]),
    unit(Area, "cm²", 1e-4, &["cm2"]),
    unit(Area, "m²", 1.0, &["m2"]),
    unit(Area, "in²", INCH * INCH, &["in2"]),
];

const VOLUME: &[Unit] = &[
    unit(Volume, "cm³", 1e-6, &["cm3", "cc", "ml", "mL"]),
    unit(Volume, "mm³", 1e-9, &["mm3"]),
    unit(Volume, "l", 1e-3, &["l", "L", "dm3"]),
    unit(Volume, "m³", 1.0, &["m3"]),
];

const VOLUME_RATE: &[Unit] = &[
    unit(VolumeRate, "l/min", 1e-3 / 60.0, &["l/min", "L/min", "dm3/min"]),
    unit(VolumeRate, "cm³/min", 1e-6 / 60.0, &["cm3/min", "ml/min"]),
    unit(VolumeRate, "cm³/s", 1e-6, &["cm3/s", "ml/s"]),
    unit(VolumeRate, "l/s", 1e-3, &["l/s", "L/s", "dm3/s"]),
    unit(VolumeRate, "m³/h", 1.0 / 3600.0, &["m3/h"]),
    unit(VolumeRate, "m³/s", 1.0, &["m3/s"]),
];

const MASS: &[Unit] = &[
    unit(Mass, "kg", 1.0, &["kg"]),
    unit(Mass, "g", 1e-3, &["g"]),
    unit(Mass, "t", 1e3, &["t"]),
    unit(Mass, "lb", POUND, &["lb", "lbm"]),
];

const DENSITY: &[Unit] = &[
    unit(Density, "kg/m³", 1.0, &["kg/m3", "kg·m-3"]),
    unit(Density, "g/cm³", 1e3, &["g/cm3", "g·cm-3", "kg/dm3", "t/m3"]),
];

const INERTIA: &[Unit] = &[
    unit(Inertia, "kg·m²", 1.0, &["kg·m2", "kgm2"]),
    unit(Inertia, "kg·cm²", 1e-4, &["kg·cm2", "kgcm2"]),
    unit(Inertia, "kg·mm²", 1e-6, &["kg·mm2", "kgmm2"]),
    unit(Inertia, "g·cm²", 1e-7, &["g·cm2", "gcm2"]),
    unit(Inertia, "lb·in²", POUND * INCH * INCH, &["lb·in2", "lb-in2"]),
    unit(Inertia, "lb·ft²", POUND * FOOT * FOOT, &["lb·ft2", "lb-ft2"]),
];

const SPEED: &[Unit] = &[
    unit(Speed, "m/s", 1.0, &["m/s", "m·s-1"]),
    unit(Speed, "mm/s", 1e-3, &["mm/s", "mm·s-1"]),
    unit(Speed, "m/min", 1.0 / 60.0, &["m/min", "m·min-1"]),
    unit(Speed, "km/h", 1.0 / 3.6, &["km/h"]),
    unit(Speed, "ft/s", FOOT, &["ft/s"]),
    unit(Speed, "ft/min", FOOT / 60.0, &["ft/min", "fpm"]),
];

const ANGULAR_SPEED: &[Unit] = &[
    unit(
        AngularSpeed,
        "rpm",
        PI / 30.0,
        &["rpm", "1/min", "min-1", "r/min", "rev/min", "rev·min-1", "RPM", "Rpm", "U/min", "tr/min"],
    ),
    unit(AngularSpeed, "rad/s", 1.0, &["rad/s", "rad·s-1"]),
    unit(AngularSpeed, "deg/s", PI / 180.0, &["deg/s", "°/s", "deg·s-1"]),
    unit(AngularSpeed, "rev/s", TAU, &["rev/s", "r/s", "rps"]),
];

const ANGULAR_ACCELERATION: &[Unit] = &[
    unit(AngularAcceleration, "rad/s²", 1.0, &["rad/s2", "rad·s-2"]),
    unit(AngularAcceleration, "deg/s²", PI / 180.0, &["deg/s2", "°/s2", "deg·s-2"]),
    unit(AngularAcceleration, "rpm/s", PI / 30.0, &["rpm/s"]),
];

const ANGLE: &[Unit] = &[
    unit(Angle, "deg", PI / 180.0, &["deg", "°"]),
    unit(Angle, "rad", 1.0, &["rad"]),
    unit(Angle, "mrad", 1e-3, &["mrad"]),
    unit(Angle, "arcmin", PI / 10_800.0, &["arcmin"]),
    unit(Angle, "rev", TAU, &["rev"]),
];

const FREQUENCY: &[Unit] = &[unit(Frequency, "Hz", 1.0, &["Hz"]), unit(Frequency, "kHz", 1e3, &["kHz"])];

const FORCE: &[Unit] = &[
    unit(Force, "N", 1.0, &["N"]),
    unit(Force, "kN", 1e3, &["kN"]),
    unit(Force, "MN", 1e6, &["MN"]),
    unit(Force, "kgf", GRAVITY, &["kgf"]),
    unit(Force, "lbf", POUND_FORCE, &["lbf"]),
];

const STIFFNESS: &[Unit] = &[
    unit(Stiffness, "N/µm", 1e6, &["N/um"]),
    unit(Stiffness, "N/m", 1.0, &["N/m", "N·m-1"]),
    unit(Stiffness, "N/mm", 1e3, &["N/mm"]),
    unit(Stiffness, "kN/mm", 1e6, &["kN/mm"]),
    unit(Stiffness, "MN/m", 1e6, &["MN/m"]),
];

const TORQUE: &[Unit] = &[
    unit(Torque, "N·m", 1.0, &["N·m", "Nm"]),
    unit(Torque, "mN·m", 1e-3, &["mN·m", "mNm"]),
    unit(Torque, "N·mm", 1e-3, &["N·mm", "Nmm"]),
    unit(Torque, "N·cm", 1e-2, &["N·cm", "Ncm"]),
    unit(Torque, "kN·m", 1e3, &["kN·m", "kNm"]),
    unit(Torque, "MN·m", 1e6, &["MN·m", "MNm"]),
    unit(Torque, "kgf·m", GRAVITY, &["kgf·m", "kgfm"]),
    unit(
        Torque,
        "lbf·ft",
        POUND_FORCE * FOOT,
        &["lbf·ft", "ft·lbf", "lbf-ft", "ft-lbf", "lb·ft", "ft·lb", "lb-ft", "ft-lb"],
    ),
    unit(
        Torque,
        "lbf·in",
        POUND_FORCE * INCH,
        &["lbf·in", "in·lbf", "lbf-in", "in-lbf", "lb·in", "in·lb", "lb-in", "in-lb"],
    ),
];

const TORSIONAL_STIFFNESS: &[Unit] = &[
    unit(TorsionalStiffness, "N·m/rad", 1.0, &["N·m/rad", "Nm/rad"]),
    unit(TorsionalStiffness, "kN·m/rad", 1e3, &["kN·m/rad", "kNm/rad"]),
    unit(TorsionalStiffness, "MN·m/rad", 1e6, &["MN·m/rad", "MNm/rad"]),
    unit(TorsionalStiffness, "N·m/deg", 180.0 / PI, &["N·m/deg", "Nm/deg", "N·m/°"]),
];

const POWER: &[Unit] = &[
    unit(Power, "kW", 1e3, &["kW"]),
    unit(Power, "mW", 1e-3, &["mW"]),
    unit(Power, "W", 1.0, &["W"]),
    unit(Power, "MW", 1e6, &["MW"]),
    unit(Power, "PS", METRIC_HP, &["PS", "hp(M)", "hp(metric)"]),
    // In English a horsepower is this one; the metric one is written PS.
    unit(Power, "hp(I)", IMPERIAL_HP, &["hp(I)", "hp", "HP", "hp(imperial)"]),
];

const PRESSURE: &[Unit] = &[
    unit(Pressure, "MPa", 1e6, &["MPa", "N/mm2"]),
    unit(Pressure, "Pa", 1.0, &["Pa", "N/m2"]),
    unit(Pressure, "kPa", 1e3, &["kPa"]),
    unit(Pressure, "GPa", 1e9, &["GPa", "kN/mm2"]),
    unit(Pressure, "bar", 1e5, &["bar"]),
    unit(Pressure, "kgf/cm²", GRAVITY * 1e4, &["kgf/cm2"]),
    unit(Pressure, "psi", POUND_FORCE / (INCH * INCH), &["psi", "lbf/in2"]),
    unit(Pressure, "ksi", 1e3 * POUND_FORCE / (INCH * INCH), &["ksi"]),
];

const VISCOSITY: &[Unit] = &[
    unit(Viscosity, "mm²/s", 1e-6, &["mm2/s", "mm2·s-1", "cSt"]),
    unit(Viscosity, "m²/s", 1.0, &["m2/s", "m2·s-1"]),
];

const DYNAMIC_VISCOSITY: &[Unit] = &[
    unit(DynamicViscosity, "mPa·s", 1e-3, &["mPa·s", "cP"]),
    unit(DynamicViscosity, "Pa·s", 1.0, &["Pa·s", "N·s/m2"]),
];

const ENERGY: &[Unit] = &[
    unit(Energy, "J", 1.0, &["J"]),
    unit(Energy, "mJ", 1e-3, &["mJ"]),
    unit(Energy, "kJ", 1e3, &["kJ"]),
    unit(Energy, "MJ", 1e6, &["MJ"]),
    unit(Energy, "kW·h", 3.6e6, &["kW·h", "kWh"]),
];

const TIME: &[Unit] = &[
    unit(Time, "s", 1.0, &["s"]),
    unit(Time, "ms", 1e-3, &["ms"]),
    unit(Time, "min", 60.0, &["min"]),
    unit(Time, "h", 3600.0, &["h"]),
];

const TEMPERATURE_DIFFERENCE: &[Unit] = &[unit(TemperatureDifference, "K", 1.0, &["K"])];

const THERMAL_EXPANSION: &[Unit] = &[
    unit(ThermalExpansion, "1/K", 1.0, &["1/K", "K-1", "/K"]),
    unit(ThermalExpansion, "µm/(m·K)", 1e-6, &["um/(m·K)"]),
];

const HEAT_CAPACITY: &[Unit] =
    &[unit(HeatCapacity, "kJ/K", 1e3, &["kJ/K"]), unit(HeatCapacity, "J/K", 1.0, &["J/K"])];

const THERMAL_CONDUCTANCE: &[Unit] =
    &[unit(ThermalConductance, "W/K", 1.0, &["W/K"]), unit(ThermalConductance, "kW/K", 1e3, &["kW/K"])];

const POWER_PER_AREA: &[Unit] = &[
    unit(PowerPerArea, "W/mm²", 1e6, &["W/mm2"]),
    unit(PowerPerArea, "W/cm²", 1e4, &["W/cm2"]),
    unit(PowerPerArea, "W/m²", 1.0, &["W/m2"]),
];

const ENERGY_PER_AREA: &[Unit] = &[
    unit(EnergyPerArea, "J/mm²", 1e6, &["J/mm2"]),
    unit(EnergyPerArea, "J/cm²", 1e4, &["J/cm2"]),
    unit(EnergyPerArea, "J/m²", 1.0, &["J/m2"]),
];

/// Spellings that engineers use for different things; a reader must not choose between them.
const AMBIGUOUS: &[(&str, &str)] = &[
    ("1/s", "rad/s for an angular speed, rev/s for turns, Hz for a frequency"),
    ("s-1", "rad/s for an angular speed, rev/s for turns, Hz for a frequency"),
];

impl Dimension {
    /// Units of this dimension alone; the usual one first. A module is also read in those of a length.
    #[must_use]
    pub const fn units(self) -> &'static [Unit] {
        match self {
            Dimensionless => DIMENSIONLESS,
            Length => LENGTH,
            Module => MODULE,
            Area => AREA,
            Volume => VOLUME,
            VolumeRate => VOLUME_RATE,
            Mass => MASS,
            Density => DENSITY,
            Inertia => INERTIA,
            Speed => SPEED,
            AngularSpeed => ANGULAR_SPEED,
            AngularAcceleration => ANGULAR_ACCELERATION,
            Angle => ANGLE,
            Frequency => FREQUENCY,
            Force => FORCE,
            Stiffness => STIFFNESS,
            Torque => TORQUE,
            TorsionalStiffness => TORSIONAL_STIFFNESS,
            Power => POWER,
            Pressure => PRESSURE,
            Viscosity => VISCOSITY,
            DynamicViscosity => DYNAMIC_VISCOSITY,
            Energy => ENERGY,
            Time => TIME,
            TemperatureDifference => TEMPERATURE_DIFFERENCE,
            ThermalExpansion => THERMAL_EXPANSION,
            HeatCapacity => HEAT_CAPACITY,
            ThermalConductance => THERMAL_CONDUCTANCE,
            PowerPerArea => POWER_PER_AREA,
            EnergyPerArea => ENERGY_PER_AREA,
        }
    }

    /// The unit an engineer would expect: `kW` for a power, `mm` for a length.
    #[must_use]
    pub const fn usual_unit(self) -> &'static Unit {
        &self.written_as().units()[0]
    }

    /// The dimension whose units are written: of a module, those of a length.
    pub(super) const fn written_as(self) -> Self {
        match self {
            Module => Length,
            own => own,
        }
    }

    /// Whether a quantity of the dimension may have a unit of `other`.
    pub(super) fn is_read_in(self, other: Self) -> bool {
        other == self || other == self.written_as()
    }

    /// Units in which a quantity of the dimension is read; the usual one first.
    fn read_units(self) -> impl Iterator<Item = &'static Unit> {
        let own: &[Unit] = if self.written_as() == self { &[] } else { self.units() };
        self.written_as().units().iter().chain(own)
    }

    /// SI unit: `W` for a power, `m` for a length.
    #[must_use]
    pub fn si_unit(self) -> &'static Unit {
        // Each has one; a test holds it.
        self.read_units().find(|unit| unit.factor == 1.0).unwrap_or(self.usual_unit())
    }

    /// The names of its units, for a message: `kW, mW, W, MW, PS, hp(I)`.
    #[must_use]
    pub fn unit_list(self) -> String {
        self.read_units().map(|unit| unit.symbol).collect::<Vec<_>>().join(", ")
    }
}

/// The unit spelled `text`, of whatever dimension. Spellings belong to one unit only.
#[must_use]
pub fn find_unit(text: &str) -> Option<&'static Unit> {
    let key = key(text);
    all_units().find(|unit| unit.keys.contains(&key.as_str()))
}

/// Possible meanings of an ambiguous spelling, if `text` is one.
pub(super) fn ambiguity(text: &str) -> Option<&'static str> {
    let key = key(text);
    AMBIGUOUS.iter().find(|(spelling, _)| *spelling == key).map(|(_, choices)| *choices)
}

/// Parts of units in Russian and Ukrainian, and ours.
const CYRILLIC: &[(&str, &str)] = &[
    ("мкм", "um"),
    ("мм", "mm"),
    ("см", "cm"),
    ("дм", "dm"),
    ("км", "km"),
    ("м", "m"),
    ("мс", "ms"),
    ("сек", "s"),
    ("с", "s"),
    ("мин", "min"),
    ("хв", "min"),
    ("ч", "h"),
    ("год", "h"),
    ("об", "1"),
    ("рад", "rad"),
    ("град", "deg"),
    ("мВт", "mW"),
    ("Вт", "W"),
    ("кВт", "kW"),
    ("МВт", "MW"),
    ("л.с.", "PS"),
    ("лс", "PS"),
    ("к.с.", "PS"),
    ("Н", "N"),
    ("кН", "kN"),
    ("МН", "MN"),
    ("Па", "Pa"),
    ("кПа", "kPa"),
    ("МПа", "MPa"),
    ("ГПа", "GPa"),
    ("бар", "bar"),
    ("г", "g"),
    ("кг", "kg"),
    ("т", "t"),
    ("Дж", "J"),
    ("кДж", "kJ"),
    ("л", "l"),
];

/// The unit that a text in Cyrillic letters means: `м/с`, `кН·м`, `об/мин`.
fn of_cyrillic(key: &str) -> Option<&'static Unit> {
    if !key.contains(|c: char| ('а'..='я').contains(&c) || ('А'..='Я').contains(&c)) {
        return None;
    }
    let in_latin = |part: &str| {
        let (word, power) =
            part.split_at(part.find(|c: char| c == '-' || c.is_ascii_digit()).unwrap_or(part.len()));
        let of = |same: fn(&str, &str) -> bool| CYRILLIC.iter().find(|(cyrillic, _)| same(cyrillic, word));
        let alike = |one: &str, other: &str| one.to_lowercase() == other.to_lowercase();
        of(|one, other| one == other).or_else(|| of(alike)).map(|(_, latin)| format!("{latin}{power}"))
    };
    // `Нм` without a sign between.
    let key = if key.ends_with("Нм") { key.replace("Нм", "Н·м") } else { key.to_owned() };
    let mut latin = String::new();
    for piece in key.split_inclusive(['·', '/']) {
        let sign = piece.chars().next_back().filter(|c| matches!(c, '·' | '/'));
        latin += &in_latin(piece.trim_end_matches(['·', '/']))?;
        latin.extend(sign);
    }
    find_unit(&latin)
}

/// The unit most like the unknown `text`, among those of `dimension` if it is known.
pub(super) fn nearest_unit(text: &str, dimension: Option<Dimension>) -> Option<&'static Unit> {
    let key = key(text);
    if let Some(unit) = of_cyrillic(&key) {
        return Some(unit);
    }
    let likeness = |unit: &Unit| {
        let of_spelling = |spelling: &&str| {
            if spelling.eq_ignore_ascii_case(&key) {
                1.0
            } else {
                strsim::normalized_damerau_levenshtein(&spelling.to_lowercase(), &key.to_lowercase())
            }
        };
        unit.keys.iter().map(of_spelling).fold(0.0, f64::max)
    };
    let candidates = dimension.map_or_else(|| all_units().collect::<Vec<_>>(), |d| d.read_units().collect());
    // `max_by` takes the last of equals; reversed, the usual unit wins.
    let best = candidates.into_iter().rev().max_by(|a, b| likeness(a).total_cmp(&likeness(b)))?;
    (likeness(best) >= 0.6).then_some(best)
}

fn all_units() -> impl Iterator<Item = &'static Unit> {
    Dimension::ALL.into_iter().flat_map(|dimension| dimension.units().iter())
}

/// The one plain form of a spelling.
fn key(text: &str) -> String {
    let mut key = String::with_capacity(text.len());
    let mut spaced = false;
    for c in text.trim().chars() {
        let plain = match c {
            '^' => continue,
            '·' | '⋅' | '∙' | '•' | '×' | '*' => '·',
            '⁰' => '0',
            '¹' => '1',
            '²' => '2',
            '³' => '3',
            '⁴'..='⁹' => char::from_digit(c as u32 - '⁰' as u32, 10).unwrap_or(c),
            '⁻' | '−' => '-',
            'µ' | 'μ' => 'u',
            'º' | '˚' => '°',
            c if c.is_whitespace() => {
                spaced = true;
                continue;
            }
            c => c,
        };
        let joins = |c: char| matches!(c, '·' | '/' | '(' | ')');
        if spaced && !joins(plain) && key.chars().next_back().is_some_and(|last| !joins(last)) {
            key.push('·');
        }
        spaced = false;
        key.push(plain);
    }
    key
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_symbol_finds_its_own_unit_and_no_spelling_has_two() {
        let mut seen = std::collections::HashMap::new();
        for dimension in Dimension::ALL {
            for unit in dimension.units() {
                assert_eq!(unit.dimension, dimension);
                assert!(unit.factor > 0.0 && unit.factor.is_finite());
                assert_eq!(dimension.si_unit().factor, 1.0);
                assert_eq!(find_unit(unit.symbol), Some(unit), "{}", unit.symbol);
                for spelling in unit.spellings() {
                    assert_eq!(key(spelling), *spelling, "not in plain form");
                    assert_eq!(ambiguity(spelling), None);
                    assert_eq!(seen.insert(*spelling, unit.symbol), None, "{spelling}");
                }
            }
        }
    }

    #[test]
    fn product_signs_superscripts_and_carets_are_alike() {
        for (spellings, symbol) in [
            (&["N·m", "N⋅m", "N*m", "N m", "N * m", "Nm", "N\u{a0}m"][..], "N·m"),
            (&["kg·m²", "kg*m^2", "kg·m2", "kgm2", "kg m²", "kg m^2"], "kg·m²"),
            (&["rad/s²", "rad/s^2", "rad/s2", "rad / s²", "rad·s⁻²", "rad s^-2"], "rad/s²"),
            (&["rpm", "1/min", "min^-1", "min⁻¹", "min−1", "r/min", "rev/min", "1 / min"], "rpm"),
            (&["µm", "μm", "um"], "µm"),
            (&["mm2", "mm²", "mm^2"], "mm²"),
            (&["deg", "°", "º"], "deg"),
        ] {
            for spelling in spellings {
                assert_eq!(find_unit(spelling).map(|u| u.symbol), Some(symbol), "{spelling}");
            }
        }
    }

    #[test]
    fn capitals_count() {
        assert_eq!(find_unit("MPa").unwrap().symbol, "MPa");
        assert_eq!(find_unit("mPa"), None);
        assert_eq!(find_unit("mN·m").unwrap().symbol, "mN·m");
        assert_eq!(find_unit("MN·m").unwrap().symbol, "MN·m");
    }

    #[test]
    fn the_nearest_unit_is_of_the_dimension_due() {
        assert_eq!(nearest_unit("KW", Some(Power)).unwrap().symbol, "kW");
        assert_eq!(nearest_unit("RPM", Some(AngularSpeed)).unwrap().symbol, "rpm");
        assert_eq!(nearest_unit("kNn", Some(Torque)).unwrap().symbol, "kN·m");
        assert_eq!(nearest_unit("furlong", Some(Length)), None);
    }
}
