//! The balance of heat of a gearbox at work: what it loses, a cooler and the housing take.
//!
//! ```text
//! P_V = P_K + G·Δθ
//! ```
//!
//! `P_V` is the loss, `P_K` what a cooler takes, `G` the conductance of the housing to the air about it, its
//! area times a coefficient of heat transfer, and `Δθ` by how much the oil is warmer than the air once
//! nothing changes any more. `G` and `P_K` are given: measured, or by a maker's catalogue. Of a cooler that
//! could take more than is lost the rest is left.
//!
//! With an allowed `Δθ` the greatest torque on the input follows, at the same speed and in the same
//! direction: the thermal limit.

use super::{GearLosses, GivenLoad, Wanted, at};
use crate::analyze::answer as analyze;
use crate::error::Error;
use crate::shared::gearbox::Subject;
use crate::shared::number::plain;
use crate::tolerance::THERMAL;
use epicyclic_numerics::roots::bisected_while;
use epicyclic_train::InputLoad;
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{Power, TemperatureInterval, ThermalConductance, Torque};

/// Doublings and halvings of a torque on the way to its limit: from any torque to none, or to what no gear
/// bears.
const DOUBLINGS: u32 = 60;

/// What takes the heat.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cooling {
    /// Conductance of the housing to the air.
    pub conductance: ThermalConductance,
    /// What a cooler takes at most.
    pub cooler: Power,
    /// By how much the oil may be warmer than the air.
    pub allowed_rise: Option<TemperatureInterval>,
}

impl Cooling {
    /// Checks the numbers.
    pub(super) fn check(&self) -> Result<(), Error> {
        let refused = |quantity, given: f64, unit, allowed| {
            Err(Error::Cooling { quantity, given: crate::shared::number::short(given), unit, allowed })
        };
        let is_above = |value: f64| value > 0.0 && value.is_finite();
        if !is_above(self.conductance.si()) {
            return refused("conductance", self.conductance.si(), "W/K", "above 0");
        }
        if !(0.0..f64::INFINITY).contains(&self.cooler.si()) {
            return refused("cooler", self.cooler.si(), "W", "0 or above");
        }
        match self.allowed_rise {
            Some(rise) if !is_above(rise.si()) => refused("allowed-rise", rise.si(), "K", "above 0"),
            _ => Ok(()),
        }
    }

    /// What the cooler and the housing take of a loss, and by how much the oil is warmer.
    fn balance(&self, loss_w: f64) -> [f64; 3] {
        let cooler = loss_w.min(self.cooler.si());
        let housing = loss_w - cooler;
        [cooler, housing, housing / self.conductance.si()]
    }
}

/// The balance of heat.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Heat {
    /// Conductance of the housing to the air.
    pub conductance_w_k: f64,
    /// What the cooler takes at most.
    pub cooler_w: f64,
    /// By how much the oil may be warmer than the air; `null` where it is not asked.
    pub allowed_rise_k: Option<f64>,
    /// The gears.
    pub gears: Vec<GearHeat>,
}

/// The balance of heat of a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearHeat {
    /// The gear.
    pub gear: String,
    /// What is lost.
    pub loss_w: f64,
    /// What the cooler takes.
    pub cooler_w: f64,
    /// What the housing gives to the air.
    pub housing_w: f64,
    /// By how much the oil is warmer than the air once nothing changes any more.
    pub rise_k: f64,
    /// The greatest torque on the input with the allowed rise, at this speed; 0 where drags alone heat more,
    /// `null` where none is asked or no torque heats so much.
    pub thermal_torque_n_m: Option<f64>,
}

/// The balance of the gears that are calculated.
pub(super) fn of(
    subject: &Subject<'_>,
    wanted: &Wanted,
    cooling: &Cooling,
    gears: &[GearLosses],
) -> Result<Heat, Error> {
    let balanced = |gear: &GearLosses| -> Result<GearHeat, Error> {
        let [cooler_w, housing_w, rise_k] = cooling.balance(gear.loss_w);
        let thermal = cooling.allowed_rise.map(|rise| thermal_torque(subject, wanted, cooling, gear, rise));
        Ok(GearHeat {
            gear: gear.gear.clone(),
            loss_w: gear.loss_w,
            cooler_w,
            housing_w,
            rise_k,
            thermal_torque_n_m: thermal.transpose()?.flatten(),
        })
    };
    Ok(Heat {
        conductance_w_k: cooling.conductance.si(),
        cooler_w: cooling.cooler.si(),
        allowed_rise_k: cooling.allowed_rise.map(Physical::si),
        gears: gears.iter().map(balanced).collect::<Result<_, _>>()?,
    })
}

/// The torque on the input at which the gear loses what cooler and housing take at the allowed rise. What is
/// lost grows with it.
fn thermal_torque(
    subject: &Subject<'_>,
    wanted: &Wanted,
    cooling: &Cooling,
    gear: &GearLosses,
    rise: TemperatureInterval,
) -> Result<Option<f64>, Error> {
    let analysis = analyze::analysis(&subject.gearbox, &gear.gear)?;
    let limit = cooling.cooler.si() + cooling.conductance.si() * rise.si();
    // Where drags hold the gear it is driven from both sides, and loses less than any drive does.
    let is_cool = |torque: f64| {
        let load = GivenLoad::Input(InputLoad::Torque(Torque::from_si(torque)));
        at(subject, &analysis, wanted.speed, load)
            .map_or(true, |found| (found.mesh_loss() + found.drag_loss()).si() <= limit)
    };
    let given = gear.input_torque_n_m;
    if given == 0.0 {
        return Ok(None);
    }
    let (mut cool, mut hot) = (given, given);
    let mut steps = 0..DOUBLINGS;
    if is_cool(given) {
        while is_cool(hot) {
            (cool, hot) = (hot, 2.0 * hot);
            if steps.next().is_none() {
                return Ok(None);
            }
        }
    } else {
        while !is_cool(cool) {
            (hot, cool) = (cool, cool / 2.0);
            if steps.next().is_none() {
                return Ok(Some(0.0));
            }
        }
    }
    let is_wide = |_, [cool, hot]: [f64; 2]| (hot - cool).abs() > THERMAL * hot.abs();
    let [cool, _] = bisected_while([cool, hot], is_wide, is_cool);
    Ok(Some(plain(cool)))
}
