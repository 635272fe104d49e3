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
/// the planet. Widths of gears are in m.
pub(super) fn bearing_duty(
    own: &Layout,
    planet: usize,
    (planet_kg, sharing): (f64, f64),
    (rolling, span): (Rolling, Option<Length>),
    width: impl Fn(usize) -> f64,
) -> Vec<PinStep> {
    let steps = own.bearing_loads[planet].iter().map(|step| {
        let centrifugal = planet_kg * own.radii[planet].si() * step.carrier_speed.si().powi(2);
        let radial = sharing * step.radial.si() + centrifugal;
        let along = sharing * step.tangential.si();
        let force = Force::from_si(libm::hypot(along, radial));
        let (load, at_rest) = span.map_or((force, force), |span| {
            let of_widths =
                |axis: usize| step.of_widths.iter().map(|(gear, own)| width(*gear) * own[axis]).sum::<f64>();
            let moment =
                [0, 1].map(|axis| Torque::from_si(sharing * (step.moment[axis].si() + of_widths(axis))));
            let rows = row_forces([radial, along].map(Force::from_si), moment, span);
            let rows = rows.map(|[out, along]| Force::from_si(libm::hypot(out.si(), along.si())));
            (equivalent_load(rolling, rows), 2.0 * rows[0].max(rows[1]))
        });
        let step = BearingStep { share: step.share, load, speed: step.speed, modification: 1.0 };
        PinStep { step, force, at_rest }
    });
    steps.collect()
}

/// Life of a bearing, and the load that it bears for the required life over its own.
#[derive(Debug, Clone, Copy)]
pub(super) struct Borne {
    /// `None` of plain bearings, and of those that never turn under load.
    pub(super) life: Option<Time>,
    /// `None` without load.
    pub(super) ratio: Option<f64>,
}

/// Lives of a bearing and the loads that it bears, for each kind of planets.
pub(super) fn borne(
    duties: &[(usize, Vec<PinStep>)],
    bearing: &Bearing,
    required: Time,
) -> Result<Vec<Borne>, Error> {
    let of = |(_, duty): &(usize, Vec<PinStep>)| {
        let Some(exponent) = bearing.rolling.exponent() else {
            let loads = duty.iter().filter(|pin| pin.step.share > 0.0).map(|pin| pin.step.load.si());
            let greatest = loads.fold(0.0, f64::max);
            let ratio = (greatest > 0.0).then(|| bearing.load_rating.si() / greatest);
            return Ok(Borne { life: None, ratio });
        };
        let steps: Vec<BearingStep> = duty.iter().map(|pin| pin.step).collect();
        let life = life_over_duty(bearing.rolling, bearing.load_rating, &steps, Reliability::Percent90)?;
        let ratio = life.map(|life| libm::pow(life.hours() / required.hours(), 1.0 / exponent));
        Ok(Borne { life, ratio })
    };
    duties.iter().map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::super::task::PlanetStep;
    use super::*;
    use uom::si::f64::AngularVelocity;

    /// 1000 N along the orbit, 400 N outwards with the orbit, 60 N·m on rows 0.1 m apart.
    #[test]
    fn the_row_with_more_load_counts_at_rest() {
        let [newtons, torque] = [1000.0, 60.0];
        let turning = AngularVelocity::from_si(10.0);
        let step = PlanetStep {
            share: 1.0,
            tangential: Force::from_si(newtons / 1.25),
            moment: [Torque::default(), Torque::from_si(torque / 1.25)],
            carrier_speed: turning,
            speed: turning,
            ..PlanetStep::default()
        };
        let own = Layout {
            planets: 3,
            modules: vec![],
            gears: [].into(),
            pairs: [].into(),
            radii: vec![Length::from_si(0.2)],
            is_aim_met: true,
            loads: [].into(),
            sharing: 1.25,
            bearing_loads: vec![vec![step.clone()]],
        };
        let of = |span: Option<f64>| {
            let rows = (Rolling::Rollers, span.map(Length::from_si));
            bearing_duty(&own, 0, (20.0, own.sharing), rows, |_| 0.0)[0]
        };
        // Forces outwards of 200 N with and against 600 N.
        let [more, less] = [libm::hypot(500.0, 800.0), libm::hypot(500.0, 400.0)];
        let near =
            |one: Force, other: f64| assert!((one.si() / other - 1.0).abs() < 1e-12, "{one:?} {other}");
        let tilted = of(Some(0.1));
        near(tilted.force, libm::hypot(1000.0, 400.0));
        near(tilted.at_rest, 2.0 * more);
        let mean = f64::midpoint(libm::pow(more, 4.5), libm::pow(less, 4.5));
        near(tilted.step.load, 2.0 * libm::pow(mean, 1.0 / 4.5));
        // Half of the moment by the widths of two gears.
        let by_widths = PlanetStep {
            moment: [Torque::default(), Torque::from_si(torque / 2.5)],
            of_widths: vec![(3, [0.0, 800.0]), (5, [0.0, -80.0])],
            ..step
        };
        let own = Layout { bearing_loads: vec![vec![by_widths]], ..own.clone() };
        let rows = (Rolling::Rollers, Some(Length::from_si(0.1)));
        let widths = |gear: usize| if gear == 3 { 0.04 } else { 0.1 };
        near(bearing_duty(&own, 0, (20.0, own.sharing), rows, widths)[0].at_rest, 2.0 * more);
        let without = of(None);
        assert_eq!((without.step.load, without.at_rest), (without.force, without.force));
        near(without.force, libm::hypot(1000.0, 400.0));
    }
}
