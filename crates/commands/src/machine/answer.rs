//! Speeds of mining machines: those in service, those required, and ratios that give them.

use crate::answer::Answer;
use crate::error::Error;
use crate::machine::options;
use crate::tolerance::SAME;
use epicyclic_schemes::cutting::{chain_speed, drum_speed, matching_feed, speed_at_force};
use epicyclic_schemes::machines::{self as tables, recommended_speeds};
use epicyclic_schemes::ratio_series::{PrintedSeries, RatioSeries, Regime, step};
use epicyclic_schemes::rotor::{
    discharge, greatest_speed, least_speed, optimal_speed, speed_range, standard_gravity,
};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{Angle, AngularVelocity, Force, Velocity};

/// Number of speeds recommended for a range of speeds.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SpeedRange {
    /// Range of speeds: greatest over least.
    pub range: f64,
    /// Number of speeds that the source recommends for a bucket wheel of this range; null if the range is not
    /// above 1.
    pub recommended: Option<u32>,
    /// Whether the source prints this number; otherwise the program chose it. Null if there is no
    /// recommendation.
    pub recommendation_is_printed: Option<bool>,
}

impl SpeedRange {
    fn of(range: f64) -> Self {
        let found = recommended_speeds(range).ok();
        Self {
            range,
            recommended: found.map(|found| found.speeds),
            recommendation_is_printed: found.map(|found| found.printed),
        }
    }
}

/// Machines in service, with the numbers of speeds recommended for their ranges.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Machines {
    /// Number of these machines that are bucket wheels with a known number of steps. The source recommends
    /// numbers of speeds only for these.
    pub bucket_wheels_with_steps: usize,
    /// Number of these bucket wheels that have the recommended number of speeds.
    pub as_recommended: usize,
    /// Machines in the order of the tables.
    pub machines: Vec<Machine>,
}

/// Machine in service.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Machine {
    /// Name of the machine as printed.
    pub machine: &'static str,
    /// Driven part of the machine as printed.
    pub kind: &'static str,
    /// Number of the source's table that lists the machine.
    pub table: &'static str,
    /// Range of speeds: the fastest over the slowest.
    pub range: f64,
    /// Number of speeds of the machine; null if the source prints none.
    pub speeds: Option<u32>,
    /// Number of speeds recommended for the range of a bucket wheel; null for other machines.
    pub recommended: Option<u32>,
    /// Whether the machine has the recommended number of speeds; null if the source prints no number of
    /// speeds or recommends none.
    pub as_recommended: Option<bool>,
    /// Whether the source prints the recommendation; otherwise the program chose it. Null if there is no
    /// recommendation.
    pub recommendation_is_printed: Option<bool>,
}

impl Answer for Machines {
    const NAME: &'static str = "machines";
}

/// Lists all machines, or the one with this name.
///
/// # Errors
/// [`Error::Design`] for a name that is not in the tables.
pub(super) fn list(name: Option<&str>) -> Result<Machines, Error> {
    let machines: Vec<Machine> = match name {
        Some(name) => vec![Machine::of(tables::machine(name)?)],
        None => tables::machines().iter().map(Machine::of).collect(),
    };
    // `as_recommended` is only known for bucket wheels with a number of steps, so both counts refer to these.
    let alike = || machines.iter().filter_map(|machine| machine.as_recommended);
    Ok(Machines {
        bucket_wheels_with_steps: alike().count(),
        as_recommended: alike().filter(|alike| *alike).count(),
        machines,
    })
}

impl Machine {
    fn of(machine: &tables::Machine) -> Self {
        let recommended = machine.recommended();
        Self {
            machine: machine.name,
            kind: machine.kind,
            table: machine.table.number(),
            range: machine.speed_range,
            speeds: machine.steps,
            recommended: recommended.map(|found| found.speeds),
            as_recommended: machine.is_as_recommended(),
            recommendation_is_printed: recommended.map(|found| found.printed),
        }
    }
}

/// Ratios of a gearbox for the required speeds of a machine.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MachineSpeeds {
    /// Required speeds.
    pub speeds: Speeds,
    /// Range of the required speeds.
    pub range: SpeedRange,
    /// Series of ratios, one for each place of direct drive.
    pub series: Vec<Series>,
}

/// Required speeds of a machine.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Speeds {
    /// Number of speeds.
    pub speeds: usize,
    /// Step from the second fastest to the fastest speed.
    pub first_step: f64,
    /// Step of a geometric series with this number of speeds over the same range.
    pub geometric_step: f64,
}

/// Ratios of a gearbox with direct drive at one of its speeds.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Series {
    /// Place of direct drive, from 1, the fastest speed.
    pub direct: usize,
    /// Regime of the gearbox: reduction, overdrive or both.
    pub regime: Regime,
    /// Ratios, the fastest speed first.
    pub ratios: Vec<f64>,
    /// Series that the source prints for this place; null if none exists.
    pub printed: Option<Printed>,
}

/// Series of ratios as the source prints it, for speeds in geometric progression.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Printed {
    /// Number of the series in the source.
    pub number: &'static str,
    /// Ratios of the series for the required speeds, the fastest speed first.
    pub ratios: Vec<f64>,
    /// Whether the series gives the required speeds.
    pub serves: bool,
}

impl Answer for MachineSpeeds {
    const NAME: &'static str = "machine-speeds";
}

/// Computes ratios for two to four speeds, the slowest first.
///
/// # Errors
/// [`Error::Design`] for speeds that form no series.
pub(super) fn speeds(speeds: &[Velocity]) -> Result<MachineSpeeds, Error> {
    // With direct drive as the fastest speed, the second ratio equals the first step of speeds.
    let fastest_direct = RatioSeries::of_speeds(speeds, 1)?;
    let (count, range) = (speeds.len(), fastest_direct.speed_range());
    let series = (1..=count)
        .map(|direct| Series::of(speeds, direct))
        .collect::<Result<_, epicyclic_schemes::Error>>()?;
    Ok(MachineSpeeds {
        speeds: Speeds {
            speeds: count,
            first_step: fastest_direct.ratios()[1],
            geometric_step: step(range, count)?,
        },
        range: SpeedRange::of(range),
        series,
    })
}

impl Series {
    fn of(speeds: &[Velocity], direct: usize) -> Result<Self, epicyclic_schemes::Error> {
        let series = RatioSeries::of_speeds(speeds, direct)?;
        let count = speeds.len();
        let (q, d) = ((speeds[count - 1] / speeds[count - 2]).value, series.speed_range());
        let printed = PrintedSeries::ALL
            .into_iter()
            .find(|printed| printed.count() == count && printed.direct() == direct)
            .map(|printed| {
                Ok::<_, epicyclic_schemes::Error>(Printed {
                    number: printed.number(),
                    ratios: printed.members(q, d),
                    serves: printed.serves(speeds, SAME)?,
                })
            });
        Ok(Self {
            direct,
            regime: series.regime(),
            ratios: series.ratios().to_vec(),
            printed: printed.transpose()?,
        })
    }
}

/// Mean cutting forces in the rock for which the feed is given, and in other rock.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Forces {
    /// Force in the rock for which the feed is given.
    pub here: Force,
    /// Forces in other rock.
    pub elsewhere: Vec<Force>,
}

/// Cutting speed of a chain cutter.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct ChainCutter {
    /// Cutting speed and feed in the rock for which the feed is given.
    pub cutting: Cutting,
    /// Speeds in this rock and in others at equal power and chip; empty if no forces are given.
    pub rocks: Vec<Rock>,
    /// Range of these speeds; null if they are all equal.
    pub range: Option<SpeedRange>,
}

/// Cutting speed of a drum or auger.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Drum {
    /// Cutting speed and feed in the rock for which the feed is given.
    pub cutting: Cutting,
    /// Speeds in this rock and in others at equal power and chip; empty if no forces are given.
    pub rocks: Vec<Rock>,
    /// Range of these speeds; null if they are all equal.
    pub range: Option<SpeedRange>,
}

/// Cutting speed and feed of a cutter.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Cutting {
    /// Cutting speed in m/s.
    pub speed_m_s: f64,
    /// Feed speed of the machine in m/s.
    pub feed_m_s: f64,
}

/// Force and speeds of a cutter in a rock.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Rock {
    /// Mean cutting force in N.
    pub force_n: f64,
    /// Cutting speed in m/s at the power of the first rock.
    pub speed_m_s: f64,
    /// Feed speed in m/s that keeps the chip thickness.
    pub feed_m_s: f64,
}

impl Answer for ChainCutter {
    const NAME: &'static str = "machine-chain-cutter";
}

impl Answer for Drum {
    const NAME: &'static str = "machine-drum";
}

/// Computes the cutting speed of a chain cutter.
///
/// # Errors
/// [`Error::Design`] for a quantity that is not above 0.
pub(super) fn chain_cutter(
    cutter: &options::ChainCutter,
    forces: Option<Forces>,
) -> Result<ChainCutter, Error> {
    let speed = chain_speed(cutter.pick_spacing.0, cutter.feed.0, cutter.chip.0)?;
    let (cutting, rocks, range) = in_rocks(speed, cutter.feed.0, forces)?;
    Ok(ChainCutter { cutting, rocks, range })
}

/// Computes the cutting speed of a drum.
///
/// # Errors
/// [`Error::Design`] for a quantity that is not above 0.
pub(super) fn drum(drum: &options::Drum, forces: Option<Forces>) -> Result<Drum, Error> {
    let speed = drum_speed(drum.diameter.0, drum.feed.0, drum.chip.0, drum.picks)?;
    let (cutting, rocks, range) = in_rocks(speed, drum.feed.0, forces)?;
    Ok(Drum { cutting, rocks, range })
}

type InRocks = (Cutting, Vec<Rock>, Option<SpeedRange>);

fn in_rocks(
    speed: Velocity,
    feed: Velocity,
    forces: Option<Forces>,
) -> Result<InRocks, epicyclic_schemes::Error> {
    let m_s = |speed: Velocity| speed.si();
    let rock =
        |force: Force, speed, feed| Rock { force_n: force.si(), speed_m_s: m_s(speed), feed_m_s: m_s(feed) };
    let mut rocks = vec![];
    if let Some(forces) = forces {
        rocks.push(rock(forces.here, speed, feed));
        for &force in &forces.elsewhere {
            let there = speed_at_force(speed, forces.here, force)?;
            rocks.push(rock(force, there, matching_feed(feed, speed, there)?));
        }
    }
    let least = rocks.iter().map(|rock| rock.speed_m_s).fold(f64::INFINITY, f64::min);
    let greatest = rocks.iter().map(|rock| rock.speed_m_s).fold(0.0, f64::max);
    let range = (least < greatest).then(|| SpeedRange::of(greatest / least));
    Ok((Cutting { speed_m_s: m_s(speed), feed_m_s: m_s(feed) }, rocks, range))
}

/// Data of a bucket wheel's throw onto its chute.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Throw {
    /// Discharge parameter `Ω = ω²R/g`.
    Discharge(f64),
    /// Flight of the material from the buckets to the edge of the chute.
    Flight {
        /// Angle at which a particle leaves its bucket.
        release: Angle,
        /// Angles of the chute's edge, such as with the boom raised and lowered; the smallest Ω governs.
        chutes: Vec<Angle>,
        /// Radius of the chute's edge over the radius of the wheel.
        radius_ratio: f64,
    },
}

/// Greatest and least speed of a bucket wheel.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Rotor {
    /// Optimal, greatest and least speed of the wheel.
    pub wheel: WheelSpeeds,
    /// Discharge parameters; the smallest governs.
    pub discharges: Vec<Discharge>,
    /// Range of speeds; not above 1 if throwing requires a higher speed than emptying allows.
    pub range: SpeedRange,
}

/// Speeds of a bucket wheel.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct WheelSpeeds {
    /// Optimal speed in rad/s: one bucket passes while the boom advances by one chip.
    pub optimal_rad_s: f64,
    /// Greatest speed at which the buckets empty, in rad/s.
    pub greatest_rad_s: f64,
    /// Least speed that throws onto the chute, in rad/s.
    pub least_rad_s: f64,
}

/// Discharge parameter `Ω = ω²R/g`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Discharge {
    /// Angle of the chute's edge from which the parameter follows, in rad; null if the parameter is given.
    pub chute_rad: Option<f64>,
    /// Value of the parameter.
    pub discharge: f64,
    /// Whether the parameter governs, because it is the smallest.
    pub counts: bool,
}

impl Answer for Rotor {
    const NAME: &'static str = "machine-rotor";
}

/// Computes the greatest and least speed of a bucket wheel.
///
/// # Errors
/// [`Error::Design`] for a quantity that is not above 0, and for a throw that does not reach the chute;
/// [`Error::NoChute`].
pub(super) fn rotor(wheel: &options::Rotor, throw: &Throw) -> Result<Rotor, Error> {
    let (slewing, angle) = (wheel.slewing.0, wheel.boom_angle.0);
    let optimal = optimal_speed(wheel.boom_radius.0, slewing, wheel.chip_width.0, wheel.buckets, angle)?;
    let greatest = greatest_speed(optimal)?;
    let found = discharges(throw)?;
    // Of the raised and the lowered boom, the source takes the smaller parameter.
    let smallest = found.iter().map(|(_, discharge)| *discharge).reduce(f64::min).ok_or(Error::NoChute)?;
    let least = least_speed(smallest, standard_gravity(), wheel.wheel_radius.0)?;
    let rad_s = |speed: AngularVelocity| speed.si();
    Ok(Rotor {
        wheel: WheelSpeeds {
            optimal_rad_s: rad_s(optimal),
            greatest_rad_s: rad_s(greatest),
            least_rad_s: rad_s(least),
        },
        discharges: found
            .into_iter()
            .map(|(chute, discharge)| Discharge {
                chute_rad: chute.map(Physical::si),
                discharge,
                counts: discharge == smallest,
            })
            .collect(),
        range: SpeedRange::of(speed_range(greatest, least)?),
    })
}

fn discharges(throw: &Throw) -> Result<Vec<(Option<Angle>, f64)>, epicyclic_schemes::Error> {
    match throw {
        Throw::Discharge(given) => Ok(vec![(None, *given)]),
        Throw::Flight { release, chutes, radius_ratio } => chutes
            .iter()
            .map(|&chute| Ok((Some(chute), discharge(*release, chute, *radius_ratio)?)))
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn speeds_of_a_wheel_have_a_series_for_each_place_of_direct_drive() {
        let found = speeds(&[0.76, 1.33, 1.95].map(Velocity::from_si)).unwrap();
        assert_eq!(found.series.len(), 3);
        assert_eq!(found.range.recommended, Some(4));
        let serves: Vec<_> = found.series.iter().map(|one| one.printed.as_ref().unwrap().serves).collect();
        assert_eq!(serves, [true, false, false]);
        assert_eq!(found.series[2].regime, Regime::Overdrive);
    }

    #[test]
    fn a_throw_without_a_chute_is_refused() {
        let wheel = options::Rotor {
            boom_radius: "20 m".parse().unwrap(),
            slewing: "0.02 rad/s".parse().unwrap(),
            chip_width: "0.3 m".parse().unwrap(),
            buckets: 8,
            boom_angle: "1 rad".parse().unwrap(),
            wheel_radius: "3 m".parse().unwrap(),
            discharge: None,
            release: None,
            chute: None,
            radius_ratio: None,
        };
        let throw = Throw::Flight { release: Angle::from_si(1.2), chutes: vec![], radius_ratio: 0.6 };
        assert!(matches!(rotor(&wheel, &throw), Err(Error::NoChute)));
        let given = rotor(&wheel, &Throw::Discharge(0.3)).unwrap();
        assert_eq!((given.discharges[0].chute_rad, given.discharges[0].counts), (None, true));
    }
}
