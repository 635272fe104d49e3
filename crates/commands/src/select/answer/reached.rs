//! Speeds required and reached, gear by gear.

use super::candidate::BrakedGear;
use epicyclic_schemes::catalogue::SchemeGear;
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{AngularVelocity, Velocity};

/// Output speed in a gear, required and reached.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ReachedSpeed {
    /// Name of the gear.
    pub gear: SchemeGear,
    /// Required speed of the machine in m/s; null if ratios are required.
    pub asked_speed_m_s: Option<f64>,
    /// Speed of the machine in m/s, negative for backward; null if ratios are required.
    pub speed_m_s: Option<f64>,
    /// Relative deviation of the reached from the required speed, without signs.
    pub speed_deviation: f64,
    /// Required ratio, input speed over output speed.
    pub asked_ratio: f64,
    /// Reached ratio, input speed over output speed.
    pub ratio: f64,
    /// Relative deviation of the reached from the required ratio, without signs.
    pub ratio_deviation: f64,
    /// Required output speed in rad/s; null without the input speed.
    pub asked_output_speed_rad_s: Option<f64>,
    /// Reached output speed in rad/s; null without the input speed.
    pub output_speed_rad_s: Option<f64>,
    /// Whether the output turns against the required direction.
    pub reversed: bool,
}

/// Required speeds or ratios of the output.
#[derive(Debug, Clone)]
pub(crate) struct Asked<'a> {
    /// Speeds of the machine; empty if ratios are required.
    pub(crate) speeds: &'a [Velocity],
    /// Ratios of the braked gears with the given signs.
    pub(crate) ratios: Vec<f64>,
    /// Speed of the input.
    pub(crate) input: Option<AngularVelocity>,
}

impl Asked<'_> {
    /// Speeds in all gears, the slowest required speed first.
    pub(crate) fn reached_by(&self, gears: &[BrakedGear]) -> Vec<ReachedSpeed> {
        self.reached(gears.iter().map(|gear| (gear.gear, gear.wanted_ratio, gear.ratio)))
    }

    /// Speeds in direct drive and in braked gears with the required and reached ratios, the slowest required
    /// speed first.
    pub(crate) fn reached(&self, braked: impl Iterator<Item = (SchemeGear, f64, f64)>) -> Vec<ReachedSpeed> {
        // A scheme may be tried with signs other than those given.
        let asked = |wanted: f64| nearest(&self.ratios, wanted).unwrap_or(wanted);
        let mut found: Vec<ReachedSpeed> = braked
            .map(|(gear, wanted, ratio)| (gear, asked(wanted), ratio))
            .chain([(SchemeGear::Direct, 1.0, 1.0)])
            .map(|(gear, asked, ratio)| self.of(gear, asked, ratio))
            .collect();
        found.sort_by(|one, other| other.asked_ratio.abs().total_cmp(&one.asked_ratio.abs()));
        found
    }

    fn of(&self, gear: SchemeGear, asked_ratio: f64, ratio: f64) -> ReachedSpeed {
        // The greatest speed belongs to direct drive.
        let speeds: Vec<f64> = self.speeds.iter().map(|speed| speed.si()).collect();
        let direct = speeds.last().copied();
        let input = self.input.map(Physical::si);
        ReachedSpeed {
            gear,
            asked_speed_m_s: direct.and_then(|direct| nearest(&speeds, direct / asked_ratio)),
            speed_m_s: direct.map(|direct| direct / ratio),
            speed_deviation: (asked_ratio / ratio).abs() - 1.0,
            asked_ratio,
            ratio,
            ratio_deviation: (ratio / asked_ratio).abs() - 1.0,
            asked_output_speed_rad_s: input.map(|input| input / asked_ratio),
            output_speed_rad_s: input.map(|input| input / ratio),
            reversed: asked_ratio * ratio < 0.0,
        }
    }
}

/// Finds the entry whose absolute value is closest to that of a value. Given figures differ from it only by
/// rounding.
fn nearest(all: &[f64], value: f64) -> Option<f64> {
    let off = |one: &f64| (one.abs() - value.abs()).abs();
    all.iter().copied().min_by(|one, other| off(one).total_cmp(&off(other)))
}

/// Largest relative deviation of a speed or ratio, without sign.
#[must_use]
pub fn largest_deviation(speeds: &[ReachedSpeed]) -> f64 {
    speeds.iter().map(|one| one.speed_deviation.abs().max(one.ratio_deviation.abs())).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use uom::si::angular_velocity::revolution_per_minute;
    use uom::si::velocity::meter_per_second;

    fn gear(gear: SchemeGear, wanted_ratio: f64, ratio: f64) -> BrakedGear {
        BrakedGear {
            gear,
            wanted_ratio,
            ratio,
            efficiency: None,
            circulating_of_entering: None,
            brake_torque_of_input: None,
            sets: vec![],
        }
    }

    /// By hand: 1.6 m/s over 2.5 and over −1.6, required 0.63 and 1.0 m/s.
    #[test]
    fn speeds_are_those_asked_for_and_what_the_ratios_give() {
        let speeds = [0.63, 1.0, 1.6].map(Velocity::new::<meter_per_second>);
        let ratios = [1.6, 1.6 / 0.63];
        let input = Some(AngularVelocity::new::<revolution_per_minute>(1500.0));
        let asked = Asked { speeds: &speeds, ratios: ratios.to_vec(), input };
        let gears = [gear(SchemeGear::First, -1.6, -1.6), gear(SchemeGear::Second, 1.6 / 0.63, 2.5)];
        let found = asked.reached_by(&gears);
        let asked: Vec<f64> = found.iter().filter_map(|one| one.asked_speed_m_s).collect();
        assert_eq!(asked, [0.63, 1.0, 1.6]);
        let reached: Vec<f64> = found.iter().filter_map(|one| one.speed_m_s).collect();
        assert_eq!(reached, [0.64, -1.0, 1.6]);
        assert!((found[0].speed_deviation - (0.64 / 0.63 - 1.0)).abs() < 1e-12);
        assert!((found[0].ratio_deviation - (0.63 / 0.64 - 1.0)).abs() < 1e-12);
        assert_eq!(found.iter().map(|one| one.reversed).collect::<Vec<_>>(), [false, true, false]);
        assert!((largest_deviation(&found) - (0.64 / 0.63 - 1.0)).abs() < 1e-12);
        let rpm = 60.0 / std::f64::consts::TAU;
        assert!((found[0].output_speed_rad_s.unwrap() * rpm - 600.0).abs() < 1e-9);
    }
}
