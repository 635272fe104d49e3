//! Loads of planet bearings over the duty, and their lives.

use super::bearing::Bearing;
use super::task::Layout;
use crate::Error;
use crate::bearing::{BearingStep, Reliability, life_over_duty};
use crate::bearing_rows::{equivalent_load, row_forces};
use epicyclic_gears::life::Rolling;
use epicyclic_units::Physical;
use uom::si::f64::{Force, Length, Time, Torque};

/// Load of a planet's bearing in a step of the duty.
#[derive(Debug, Clone, Copy)]
pub(super) struct PinStep {
    /// Step with the load for the life: that of both rows as a unit.
    pub(super) step: BearingStep,
    /// Radial force.
    pub(super) force: Force,
    /// Load for the static safety: twice that of the row with more load, since the static load rating is that
    /// of two equal rows.
    pub(super) at_rest: Force,
}

/// Loads and speeds of a planet's bearing over the duty; with the distance of its rows, where a moment tilts
/// the planet.
pub(super) fn bearing_duty(
    own: &Layout,
    planet: usize,
    (planet_kg, sharing): (f64, f64),
    (rolling, span): (Rolling, Option<Length>),
) -> Vec<PinStep> {
    let steps = own.bearing_loads[planet].iter().map(|step| {
        let centrifugal = planet_kg * own.radii[planet].si() * step.carrier_speed.si().powi(2);
        let radial = sharing * step.radial.si() + centrifugal;
        let along = sharing * step.tangential.si();
        let force = Force::from_si(libm::hypot(along, radial));
        let (load, at_rest) = span.map_or((force, force), |span| {
            let moment = step.moment.map(|part| Torque::from_si(sharing * part.si()));
            let rows = row_forces([radial, along].map(Force::from_si), moment, span);
            let rows = rows.map(|[out, along]| Force::from_si(libm::hypot(out.si(), along.si())));
            (equivalent_load(rolling, rows), 2.0 * rows[0].max(rows[1]))
        });
        let step = BearingStep { share: step.share, load, speed: step.speed, modification: 1.0 };
        PinStep { step, force, at_rest }
    });
    steps.collect()
}

/// Lives of a bearing under the loads of each kind of planets.
pub(super) fn lives(duties: &[(usize, Vec<PinStep>)], bearing: &Bearing) -> Result<Vec<Option<Time>>, Error> {
    let life = |(_, duty): &(usize, Vec<PinStep>)| {
        let steps: Vec<BearingStep> = duty.iter().map(|pin| pin.step).collect();
        life_over_duty(bearing.rolling, bearing.load_rating, &steps, Reliability::Percent90)
    };
    duties.iter().map(life).collect()
}
