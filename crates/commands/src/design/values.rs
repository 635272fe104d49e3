//! Values of options of a design.

use crate::error::Error;
use crate::failure::Failure;
use epicyclic_gears::involute::Profile;
use epicyclic_selection::Mechanism;
use epicyclic_strength::load::{Floating, load_sharing};
use epicyclic_units::format::trimmed;
use epicyclic_units::{Number, Physical, Quantity, QuantityError};
use std::str::FromStr;
use uom::si::f64::{Angle, Ratio, Time};

/// Shares in proportion to these, in hundredths of a percent, that are together 1; of none, equal ones.
pub(super) fn whole(shares: &[f64], sum: f64) -> Vec<f64> {
    let of = |share: &f64| if sum > 0.0 { share / sum } else { 1.0 / shares.len() as f64 };
    let mut all: Vec<f64> = shares.iter().map(|share| (of(share) * 1e4).round() / 1e4).collect();
    let others: f64 = all.iter().skip(1).sum();
    all[0] = 1.0 - others;
    all
}

/// Required life; a number alone is most likely meant in hours.
pub(super) fn life(text: &str) -> Result<Quantity<Time>, String> {
    if let Ok(number) = text.parse::<Number>() {
        return Err(format!(
            "{text}: no unit; write '{} h', or another unit of time (s, min, h)",
            trimmed(number.get(), 12)
        ));
    }
    let life: Quantity<Time> = text.parse().map_err(|error: QuantityError| error.to_string())?;
    if life.0.si() > 0.0 {
        Ok(life)
    } else {
        Err(format!("{text}: a life is above 0; write such as '20000 h'"))
    }
}

/// Helix angle that teeth may have; below 0 of the other hand.
pub(super) fn helix_angle(text: &str) -> Result<Quantity<Angle>, String> {
    let angle: Quantity<Angle> = text.parse().map_err(|error: QuantityError| error.to_string())?;
    let profile = Profile { helix_angle: angle.0.abs(), ..Profile::default() };
    profile.check().map_err(|error| format!("{text}: {error}; a minus is the other hand"))?;
    Ok(angle)
}

/// `K_γ` with 2 to 8 planets, a floating member assumed as in the rating of the designs; of 8, which its
/// table does not have, that of 7.
pub(super) fn sharing() -> Result<[f64; 7], Failure> {
    let mut all = [1.0; 7];
    for (planets, of) in (2..).zip(&mut all) {
        *of = load_sharing(planets.min(7), Floating::Assumed).map_err(Error::from)?;
    }
    Ok(all)
}

/// A mechanism by its name.
pub(super) fn named(name: &str) -> Result<Mechanism, String> {
    Mechanism::named(name).ok_or_else(|| {
        "a scheme of the catalogue (I … III-3) or a structure by its links (D.T1.B+T2.B.T1, D.T1.B) is due"
            .to_owned()
    })
}

/// A factor from 1 on: the greatest of a quantity over that of the load.
pub(super) fn greatest(
    option: &'static str,
    factor: Option<Quantity<Ratio>>,
    quantity: &str,
    such_as: f64,
) -> Result<Option<f64>, Failure> {
    let factor = factor.map(|factor| factor.0.si());
    match factor {
        Some(factor) if !(factor.is_finite() && factor >= 1.0) => {
            let message = format!(
                "{}: the greatest {quantity} is not below that of the load; write 1 or more, such as {such_as}",
                trimmed(factor, 6)
            );
            Err(Failure::invalid(option, message))
        }
        _ => Ok(factor),
    }
}

/// A quantity above 0.
pub(super) fn positive<Q: Physical>(text: &str) -> Result<Quantity<Q>, String>
where
    Quantity<Q>: FromStr<Err = QuantityError>,
{
    let value: Quantity<Q> = text.parse().map_err(|error: QuantityError| error.to_string())?;
    if value.0.si() > 0.0 && value.0.si().is_finite() {
        Ok(value)
    } else {
        Err(format!("{text}: the value must be above 0"))
    }
}
