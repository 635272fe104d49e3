//! Heat balance of a gearbox at an operating point: the loss equals the heat taken by the cooler and the
//! housing.
//!
//! ```text
//! P_V = P_K + G·Δθ
//! ```
//!
//! `P_V` is the loss, `P_K` the heat flow to the cooler and `Δθ` the steady temperature rise of the oil above
//! ambient. `G` is the conductance from the housing to the ambient air: its area times a heat transfer
//! coefficient. `G` and the capacity of the cooler are given, from measurement or a maker's catalogue. A
//! cooler with more capacity than the loss takes only the loss.
//!
//! With an allowed `Δθ` the thermal limit follows: the largest input torque at the same speed and in the same
//! direction.

use super::{GearLosses, GivenLoad, Point, at};
use crate::analyze::answer as analyze;
use crate::error::Error;
use crate::shared::gearbox::Gearbox;
use crate::shared::number::plain;
use crate::tolerance::THERMAL;
use epicyclic_numerics::roots::bisected_while;
use epicyclic_train::InputLoad;
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{Power, TemperatureInterval, ThermalConductance, Torque};

/// Maximum number of doublings or halvings of a torque to bracket its limit: enough to get from any torque to
/// zero, or to more than any gear can bear.
const DOUBLINGS: u32 = 60;

/// Heat transfer of housing and cooler.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cooling {
    /// Conductance from the housing to the ambient air.
    pub conductance: ThermalConductance,
    /// Maximum heat flow that the cooler takes.
    pub cooler: Power,
    /// Allowed oil temperature above ambient.
    pub allowed_rise: Option<TemperatureInterval>,
}

impl Cooling {
    /// Checks that the conductance and the allowed rise are positive, and the cooler is not negative.
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

    /// Heat flows in W to the cooler and from the housing, and the oil temperature rise in K, for a loss.
    fn balance(&self, loss_w: f64) -> [f64; 3] {
        let cooler = loss_w.min(self.cooler.si());
        let housing = loss_w - cooler;
        [cooler, housing, housing / self.conductance.si()]
    }
}

/// Heat balance of a gearbox.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Heat {
    /// Conductance from the housing to the ambient air, in W/K.
    pub conductance_w_k: f64,
    /// Maximum heat flow that the cooler takes, in W.
    pub cooler_w: f64,
    /// Allowed oil temperature above ambient, in K; null if none is given.
    pub allowed_rise_k: Option<f64>,
    /// Heat balances of the gears.
    pub gears: Vec<GearHeat>,
}

/// Heat balance of a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearHeat {
    /// Name of the gear.
    pub gear: String,
    /// Total power loss of the gear, in W.
    pub loss_w: f64,
    /// Heat flow to the cooler in W.
    pub cooler_w: f64,
    /// Heat flow from the housing to the ambient air, in W.
    pub housing_w: f64,
    /// Steady oil temperature above ambient, in K.
    pub rise_k: f64,
    /// Largest input torque for the allowed temperature rise at this speed, in N·m; 0 if drags alone heat the
    /// oil more. Null if no rise is given or no torque heats the oil so much.
    pub thermal_torque_n_m: Option<f64>,
}

/// Computes the heat balances of the gears with known losses.
pub(super) fn of(
    subject: &Gearbox,
    point: Point,
    cooling: &Cooling,
    gears: &[GearLosses],
) -> Result<Heat, Error> {
    let balanced = |gear: &GearLosses| -> Result<GearHeat, Error> {
        let [cooler_w, housing_w, rise_k] = cooling.balance(gear.loss_w);
        let thermal = cooling.allowed_rise.map(|rise| thermal_torque(subject, point, cooling, gear, rise));
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

/// Input torque in N·m at which the loss equals the heat that cooler and housing take at the allowed rise.
/// The bisection relies on a loss that grows with the torque.
fn thermal_torque(
    subject: &Gearbox,
    point: Point,
    cooling: &Cooling,
    gear: &GearLosses,
    rise: TemperatureInterval,
) -> Result<Option<f64>, Error> {
    let analysis = analyze::analysis(&subject.train, &gear.gear)?;
    let limit = cooling.cooler.si() + cooling.conductance.si() * rise.si();
    // If drags hold the gear, it is driven from both sides and loses less than in any drive, so it counts as
    // cool.
    let is_cool = |torque: f64| {
        let load = GivenLoad::Input(InputLoad::Torque(Torque::from_si(torque)));
        at(subject, &analysis, Point { load, ..point })
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
