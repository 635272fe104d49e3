//! Options of `synthesize`: what a gearbox of use keeps, and the shares of time of the gears.

use crate::failure::Failure;
use crate::tolerance::SHARES;
use epicyclic_formats::WantedRatio;
use epicyclic_formats::wanted_ratio::Wanted as RatioOf;
use epicyclic_synthesis::usable::Usable;
use epicyclic_units::format::trimmed;
use epicyclic_units::{Number, Physical as _, Quantity};
use std::str::FromStr;
use uom::si::f64::Ratio;

/// What a gearbox of use keeps.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "When the search stops")]
pub struct UsableOptions {
    /// Least efficiency of a forward gear. While every gearbox found misses this or the next two limits, or
    /// cannot be drawn, larger classes are searched.
    #[arg(long, value_name = "SHARE", default_value = "0.9", allow_hyphen_values = true)]
    pub least_efficiency: Quantity<Ratio>,

    /// Least efficiency of a reverse gear.
    #[arg(long, value_name = "SHARE", default_value = "0.8", allow_hyphen_values = true)]
    pub least_reverse_efficiency: Quantity<Ratio>,

    /// Greatest circulating power of a forward gear over what enters.
    #[arg(long, value_name = "NUMBER", default_value = "1", allow_hyphen_values = true)]
    pub most_circulating: Number,

    /// End at the first class with gearboxes, whether they are of use or not.
    #[arg(long)]
    pub first_class: bool,
}

/// The share of time of a gear: `3:20%`.
#[derive(Debug, Clone, Copy)]
pub struct GearShare {
    gear: usize,
    share: f64,
}

impl FromStr for GearShare {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let expected = || format!("`{text}` is no gear and its share, such as 3:20% or 3:0.2");
        let (gear, share) = text.split_once(':').ok_or_else(expected)?;
        let gear = gear.trim().parse().map_err(|_| expected())?;
        let share: Quantity<Ratio> = share.trim().parse().map_err(|_| expected())?;
        Ok(Self { gear, share: share.0.si() })
    }
}

impl UsableOptions {
    pub(crate) fn wanted(&self) -> Result<Option<Usable>, Failure> {
        let share = |option, value: Quantity<Ratio>| match value.0.si() {
            share if (0.0..=1.0).contains(&share) => Ok(share),
            _ => Err(Failure::invalid(option, "from 0, which asks for nothing, to 100 %")),
        };
        let circulation = self.most_circulating.get();
        if circulation < 0.0 {
            let message = "at least 0: circulating power over what enters";
            return Err(Failure::invalid("--most-circulating", message));
        }
        let usable = Usable {
            forward: share("--least-efficiency", self.least_efficiency)?,
            reverse: share("--least-reverse-efficiency", self.least_reverse_efficiency)?,
            circulation,
        };
        Ok((!self.first_class).then_some(usable))
    }
}

/// The share of each gear of the list.
pub(crate) fn shares_of(given: &[GearShare], gears: &[WantedRatio]) -> Result<Vec<f64>, Failure> {
    let fault = |message: String| Err(Failure::invalid("--shares", message));
    let mut shares: Vec<Option<f64>> = vec![None; gears.len()];
    for GearShare { gear, share } in given {
        let Some(place) = gear.checked_sub(1).filter(|place| *place < gears.len()) else {
            return fault(format!("gear {gear}: --ratios has gears 1 to {}", gears.len()));
        };
        let is_reverse = match gears[place].wanted {
            RatioOf::Around { ratio, .. } => ratio < 0.0,
            RatioOf::Range { most, .. } => most < 0.0,
            RatioOf::Free => false,
        };
        if is_reverse {
            return fault(format!("gear {gear} is a reverse gear: shares are of forward gears"));
        }
        if !(0.0..=1.0).contains(share) {
            return fault(format!("gear {gear}: a share is from 0 to 100 %"));
        }
        if shares[place].replace(*share).is_some() {
            return fault(format!("gear {gear} is given twice"));
        }
    }
    let shares: Vec<f64> = shares.into_iter().map(Option::unwrap_or_default).collect();
    let sum: f64 = shares.iter().sum();
    if (sum - 1.0).abs() > SHARES {
        return fault(format!("the shares are {} % together: they must be 100 %", trimmed(100.0 * sum, 6)));
    }
    Ok(shares)
}
