//! Numbers and quantities as text.

use crate::{conversion::Physical, dimension::Dimension, unit::Unit};

/// `value` to `digits` significant digits, trailing zeros kept, with an exponent only below 1e-5 or from 1e15
/// on.
///
/// ```
/// use epicyclic_units::format::significant;
///
/// assert_eq!(significant(521.837, 4), "521.8");
/// assert_eq!(significant(521_837.0, 3), "522000");
/// assert_eq!(significant(75.0, 4), "75.00");
/// assert_eq!(significant(1.5e-7, 2), "1.5e-7");
/// ```
#[must_use]
pub fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return format!("{:.*}", digits.saturating_sub(1), 0.0);
    }
    if !value.is_finite() {
        return value.to_string();
    }
    // More than 17 digits say nothing about a double.
    let decimals = digits.clamp(1, 17) - 1;
    let scientific = format!("{value:.decimals$e}");
    let exponent: i32 =
        scientific.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0);
    if !(-5..15).contains(&exponent) {
        return scientific;
    }
    let places = i32::try_from(decimals).unwrap_or(0) - exponent;
    match usize::try_from(places) {
        Ok(places) => format!("{value:.places$}"),
        // Rounded left of the point.
        Err(_) => format!("{:.0}", scientific.parse::<f64>().unwrap_or(value)),
    }
}

/// Like [`significant`], without trailing zeros: `75`, `521.8`.
#[must_use]
pub fn trimmed(value: f64, digits: usize) -> String {
    let text = significant(value, digits);
    let (mantissa, exponent) = match text.split_once('e') {
        Some((mantissa, exponent)) => (mantissa, format!("e{exponent}")),
        None => (text.as_str(), String::new()),
    };
    let mantissa =
        if mantissa.contains('.') { mantissa.trim_end_matches('0').trim_end_matches('.') } else { mantissa };
    format!("{mantissa}{exponent}")
}

/// A quantity in SI units as text in `unit`: `in_unit(1200.0, kilonewton_metre, 4)` is `1.2 kN·m`.
#[must_use]
pub fn in_unit(si: f64, unit: &Unit, digits: usize) -> String {
    let number = trimmed(if unit.is_reciprocal { unit.factor / si } else { si / unit.factor }, digits);
    if unit.symbol == "1" { number } else { format!("{number} {}", unit.symbol) }
}

/// A quantity in the unit an engineer would take for its size.
#[must_use]
pub fn quantity<T: Physical>(quantity: T, digits: usize) -> String {
    in_unit(quantity.si(), sensible_unit(T::DIMENSION, quantity.si()), digits)
}

/// The usual unit where it gives a number from 0.001 to 100 000, otherwise the largest of a few that gives at
/// least 1.
#[must_use]
pub fn sensible_unit(dimension: Dimension, si: f64) -> &'static Unit {
    let dimension = dimension.written_as();
    let usual = dimension.usual_unit();
    let size = si.abs();
    if size == 0.0 || (1e-3..1e5).contains(&(size / usual.factor)) {
        return usual;
    }
    let shown = scale(dimension);
    let units = || dimension.units().iter().filter(|unit| shown.contains(&unit.symbol));
    let by_factor = |a: &&Unit, b: &&Unit| a.factor.total_cmp(&b.factor);
    units()
        .filter(|unit| size >= unit.factor)
        .max_by(by_factor)
        .or_else(|| units().min_by(by_factor))
        .unwrap_or(usual)
}

/// The units worth showing when the usual one does not fit.
const fn scale(dimension: Dimension) -> &'static [&'static str] {
    match dimension {
        Dimension::Length => &["µm", "mm", "m", "km"],
        Dimension::Area => &["mm²", "m²"],
        Dimension::Volume => &["mm³", "cm³", "l", "m³"],
        Dimension::Mass => &["g", "kg", "t"],
        Dimension::Inertia => &["g·cm²", "kg·m²"],
        Dimension::Angle => &["rad"],
        Dimension::Force => &["N", "kN", "MN"],
        Dimension::Stiffness => &["N/m", "N/µm"],
        Dimension::Torque => &["mN·m", "N·m", "kN·m", "MN·m"],
        Dimension::TorsionalStiffness => &["N·m/rad", "kN·m/rad", "MN·m/rad"],
        Dimension::Power => &["mW", "W", "kW", "MW"],
        Dimension::Pressure => &["Pa", "kPa", "MPa", "GPa"],
        Dimension::Energy => &["mJ", "J", "kJ", "MJ"],
        Dimension::Time => &["ms", "s", "min", "h"],
        Dimension::Frequency => &["Hz", "kHz"],
        Dimension::HeatCapacity => &["J/K", "kJ/K"],
        Dimension::ThermalConductance => &["W/K", "kW/K"],
        _ => &[],
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::parse;

    #[test]
    fn digits_are_significant_ones() {
        for (value, digits, text) in [
            (0.0, 3, "0.00"),
            (-0.0, 1, "0"),
            (9.9999, 2, "10"),
            (0.515_464, 3, "0.515"),
            (-1234.5, 2, "-1200"),
            (1e15, 3, "1.00e15"),
            (0.000_012_34, 2, "0.000012"),
            (3.0, 0, "3"),
        ] {
            assert_eq!(significant(value, digits), text);
        }
        assert_eq!(trimmed(100.0, 6), "100");
        assert_eq!(trimmed(1.5e20, 6), "1.5e20");
        assert_eq!(significant(f64::NAN, 3), "NaN");
    }

    #[test]
    fn the_unit_fits_the_size() {
        use Dimension::{AngularSpeed, Length, Power, Torque};
        for (dimension, si, text) in [
            (Length, 0.008, "8 mm"),
            (Length, 250.0, "250 m"),
            (Length, 2e-7, "0.2 µm"),
            (Power, 106.5e3, "106.5 kW"),
            (Power, 0.25, "250 mW"),
            (Torque, 521.8, "521.8 N·m"),
            (Torque, 1.2e6, "1.2 MN·m"),
            (AngularSpeed, 0.0, "0 rpm"),
        ] {
            assert_eq!(in_unit(si, sensible_unit(dimension, si), 6), text);
        }
    }

    proptest! {
        #[test]
        fn what_is_written_is_read_back(
            value in prop::num::f64::NORMAL | prop::num::f64::ZERO,
            dimension in prop::sample::select(&Dimension::ALL[..]),
            pick in any::<prop::sample::Index>(),
        ) {
            let unit = &dimension.units()[pick.index(dimension.units().len())];
            let most = 0.999 * dimension.largest();
            let si = (value * unit.factor).clamp(-most, most);
            // A diametral pitch of 0 or beyond all numbers is none.
            prop_assume!(!unit.is_reciprocal || (1e-6..most).contains(&si.abs()));
            for unit in [unit, sensible_unit(dimension, si)] {
                let read = parse(&in_unit(si, unit, 17)).unwrap();
                prop_assert_eq!(read.unit, unit);
                // Dividing and multiplying by the factor may each cost half a unit in the last place.
                prop_assert!((read.si() - si).abs() <= 1e-15 * si.abs() + f64::MIN_POSITIVE * unit.factor.max(1.0));
            }
        }
    }
}
