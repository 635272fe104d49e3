//! Load spectra: damage and safety of a mesh over a duty, by Miner's rule.
//!
//! ```text
//! U = Σ N_i/N_f(σ_i)         N_i = share_i·n_i·L·contacts
//! S: U(S·σ_i) = 1            life = L/U(σ_i)
//! ```
//!
//! | symbol | argument | meaning | unit |
//! |---|---|---|---|
//! | `share_i`, `T_i`, `n_i` | [`Step`] | time share; torque of a mesh on gear 1; its speed | 1, N·m, rpm |
//! | `L` | `life` | required life | h |
//! | `N_f(σ)` | | cycles after which a stress does its whole damage, from the limit over the cycles | 1 |
//! | `U` | [`Worn::damage`] | damage; 1 is the end of life | 1 |
//! | `S` | [`Worn::safety`] | factor of all stresses with which the damage is 1 | 1 |
//!
//! Each step has its own load factors and its own `Z_v`. `K_A` is 1 where the duty contains the overloads,
//! and is given as always. A stress above the static limit ends the life at once. A stress below the limit at
//! 10¹⁰ cycles does no damage, nor does a step without torque or speed.
//!
//! Several meshes on one flank, each with its own stresses, limits and cycles, have one sum `U` over all of
//! them ([`Stresses::join`]), and its safety.
//!
//! # Source
//! ISO 6336-6:2006: Miner's rule, safety by iteration on the stresses.

use crate::checks::{not_negative, positive, whole};
use crate::factor::{Edition, Side};
use crate::life::Line;
use crate::load::LoadFactors;
use crate::mesh::{Mesh, Method};
use crate::prepared::{Prepared, part_of};
use crate::{Error, Quantity};
use epicyclic_units::Physical;
use uom::si::f64::{AngularVelocity, Time, Torque};

/// A step of a duty.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// Share of the time.
    pub share: f64,
    /// Torque of one mesh on the first gear, 0 or more.
    pub torque: Torque,
    /// Speed of the first gear relative to the carrier, 0 or more.
    pub speed: AngularVelocity,
}

/// Damage of a flank or root by a duty, with safety and life.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Worn {
    /// Damage `U` in the required life; ∞ where a stress is above the static limit.
    pub damage: f64,
    /// Safety `S`.
    pub safety: f64,
    /// Life; `None` where nothing does damage.
    pub life: Option<Time>,
}

/// A gear under a duty: what it does to flank and root, or why that cannot be calculated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GearDuty<W = Result<Worn, Error>> {
    /// The flank.
    pub contact: W,
    /// The root.
    pub root: W,
}

/// A mesh under a duty.
#[derive(Debug, Clone, PartialEq)]
pub struct DutyRating {
    /// Edition of the standard.
    pub edition: Edition,
    /// Ratings of both gears.
    pub gears: [GearDuty; 2],
}

impl DutyRating {
    /// Ratings of both gears if all flanks and roots are rated.
    ///
    /// # Errors
    /// The error of the first flank or root that is not rated.
    pub fn whole(self) -> Result<[GearDuty<Worn>; 2], Error> {
        let whole = |gear: GearDuty| Ok::<_, Error>(GearDuty { contact: gear.contact?, root: gear.root? });
        let [first, second] = self.gears;
        Ok([whole(first)?, whole(second)?])
    }
}

/// A stress, how often it comes, and the limit it is held against.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Cycle {
    stress: f64,
    cycles: f64,
    line: Line,
}

/// Stresses of a flank or root over a duty, with their cycles and limits.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Stresses(Vec<Cycle>);

impl Stresses {
    /// Adds the stresses of another mesh on the same flank or root in the same life: their damages add up.
    pub fn join(&mut self, other: Self) {
        self.0.extend(other.0);
    }

    /// Damage, safety and life in this required life.
    #[must_use]
    pub fn worn(&self, life: Time) -> Worn {
        worn(&self.0, life.hours())
    }
}

/// Stresses of one gear of a mesh in those steps of a duty that load a flank; in the others that flank rests.
/// `None` if none of them does anything.
///
/// # Errors
/// Those of [`stresses`], also of the flank or the root alone.
pub fn on_flank(
    (mesh, method): (&Mesh, &Method),
    duty: impl Iterator<Item = (Step, bool)>,
    life: Time,
    contacts: [f64; 2],
    side: usize,
) -> Result<Option<GearDuty<Stresses>>, Error> {
    let step = |(step, is_on): (Step, bool)| Step {
        torque: if is_on { step.torque } else { Torque::default() },
        ..step
    };
    let steps: Vec<Step> = duty.map(step).collect();
    match stresses(mesh, &steps, life, contacts, method) {
        Ok([first, second]) => {
            let own = if side == 0 { first } else { second };
            Ok(Some(GearDuty { contact: own.contact?, root: own.root? }))
        }
        Err(Error::IdleDuty) => Ok(None),
        Err(error) => Err(error),
    }
}

/// Refuses shares of a duty that are not the whole time.
///
/// # Errors
/// [`Error::Negative`] for a share below 0, [`Error::Shares`] where they do not sum to 1.
pub fn check_shares(shares: impl IntoIterator<Item = f64>) -> Result<(), Error> {
    let mut sum = 0.0;
    for share in shares {
        sum += not_negative(Quantity::Share, share, "")?;
    }
    whole(sum)
}

/// Damage, safety and life of both gears over a duty; `contacts` as in [`Load`](crate::mesh::Load). Given
/// `Z_NT` and `Y_NT` are of one number of cycles and not used here.
///
/// # Errors
/// [`Error::Shares`] where the shares do not sum to 1, [`Error::Negative`] for a share, torque or speed below
/// 0, [`Error::IdleDuty`] without a step that does anything; those of [`rate`](crate::rating::rate).
/// [`Error::MissingFactor`] for `Y_δrelT,stat` of a class whose formula is not known stays in the rating.
pub fn rate_duty(
    mesh: &Mesh,
    duty: &[Step],
    life: Time,
    contacts: [f64; 2],
    method: &Method,
) -> Result<DutyRating, Error> {
    let gears = stresses(mesh, duty, life, contacts, method)?;
    let worn = |stresses: Result<Stresses, Error>| stresses.map(|stresses| stresses.worn(life));
    let gears = gears.map(|gear| GearDuty { contact: worn(gear.contact), root: worn(gear.root) });
    Ok(DutyRating { edition: method.edition, gears })
}

/// Stresses of both gears over a duty, as [`rate_duty`] rates them.
///
/// # Errors
/// Those of [`rate_duty`].
pub fn stresses(
    mesh: &Mesh,
    duty: &[Step],
    life: Time,
    contacts: [f64; 2],
    method: &Method,
) -> Result<[GearDuty<Result<Stresses, Error>>; 2], Error> {
    check_duty(duty)?;
    stresses_of(&Prepared::new(mesh, method)?, duty, life, contacts)
}

/// Safeties of both flanks over each of several duties, with their `contacts`; infinite where a duty does
/// nothing.
///
/// # Errors
/// Those of [`rate_duty`] as far as they concern flanks.
pub(crate) fn flank_safeties<'a>(
    mesh: &Mesh,
    method: &Method,
    duties: impl Iterator<Item = (&'a [Step], [f64; 2])>,
    life: Time,
) -> Result<Vec<[f64; 2]>, Error> {
    let prepared = Prepared::new(mesh, method)?;
    let of = |(duty, contacts): (&[Step], [f64; 2])| {
        check_duty(duty)?;
        match stresses_of(&prepared, duty, life, contacts) {
            Ok([first, second]) => Ok([safety(&first.contact?.0), safety(&second.contact?.0)]),
            Err(Error::IdleDuty) => Ok([f64::INFINITY; 2]),
            Err(error) => Err(error),
        }
    };
    duties.map(of).collect()
}

fn check_duty(duty: &[Step]) -> Result<(), Error> {
    check_shares(duty.iter().map(|step| step.share))?;
    for step in duty {
        not_negative(Quantity::Torque, step.torque.si(), "N·m")?;
        not_negative(Quantity::Speed, step.speed.rpm(), "rpm")?;
    }
    Ok(())
}

fn stresses_of(
    prepared: &Prepared<'_>,
    duty: &[Step],
    life: Time,
    contacts: [f64; 2],
) -> Result<[GearDuty<Result<Stresses, Error>>; 2], Error> {
    let life_h = positive(Quantity::Life, life.hours(), "h")?;
    let method = prepared.method;
    let mut steps = vec![];
    for step in duty {
        let (torque, speed) = (step.torque.si(), step.speed.rpm());
        if step.share == 0.0 || torque == 0.0 || speed == 0.0 {
            continue;
        }
        let force = prepared.force(torque);
        let factors = prepared.load_factors(force, speed, method.given, method.dynamics.as_ref())?;
        steps.push((step.share, force, speed, factors));
    }
    if steps.is_empty() {
        return Err(Error::IdleDuty);
    }
    type StressAndLine<'a> = &'a dyn Fn(f64, f64, &LoadFactors) -> Result<(f64, Line), Error>;
    let stressed_by = |side: Side, stress_and_line: StressAndLine<'_>| {
        let cycle = |(share, force, speed, factors): &(f64, f64, f64, LoadFactors)| {
            let (stress, line) = stress_and_line(*force, *speed, factors)?;
            Ok(Cycle { stress, cycles: prepared.cycles(side, *speed, life_h * share, contacts)?, line })
        };
        part_of(steps.iter().map(cycle).collect::<Result<_, _>>().map(Stresses))
    };
    let gear = |side: Side| -> Result<GearDuty<Result<Stresses, Error>>, Error> {
        Ok(GearDuty {
            contact: stressed_by(side, &|force, speed, factors| {
                let limit = prepared.flank_limit(side, prepared.speed(speed))?;
                Ok((prepared.contact_stress(limit.flank, force, factors), limit.line()))
            })?,
            root: stressed_by(side, &|force, _, factors| {
                let root = prepared.gears[side as usize].root.as_ref().map_err(Clone::clone)?;
                Ok((prepared.root_stress(root, force, factors), root.limit_line()?))
            })?,
        })
    };
    Ok([gear(Side::First)?, gear(Side::Second)?])
}

/// `U` with all stresses times a factor.
fn damage(cycles: &[Cycle], factor: f64) -> f64 {
    cycles.iter().map(|cycle| cycle.cycles / cycle.line.cycles(cycle.stress * factor)).sum()
}

fn worn(cycles: &[Cycle], life_h: f64) -> Worn {
    let as_it_is = damage(cycles, 1.0);
    Worn {
        damage: as_it_is,
        safety: safety(cycles),
        life: (as_it_is > 0.0).then(|| Time::from_hours(life_h / as_it_is)),
    }
}

/// Halvings after which the bracket is as narrow as numbers are.
const HALVINGS: u32 = 60;

/// The greatest factor with a damage of at most 1. The damage never falls with the factor, so bisection finds
/// it.
fn safety(cycles: &[Cycle]) -> f64 {
    if let [one] = cycles {
        return one.line.at(one.cycles) / one.stress;
    }
    // With the factor at which the first stress reaches its static limit, the damage is ∞ just above.
    let factor_at = |limit: fn(&Line) -> f64| {
        cycles.iter().map(|cycle| limit(&cycle.line) / cycle.stress).fold(f64::INFINITY, f64::min)
    };
    let (mut low, mut high) = (factor_at(Line::last), factor_at(Line::first));
    if damage(cycles, high) <= 1.0 {
        return high;
    }
    for _ in 0..HALVINGS {
        let middle = (low * high).sqrt();
        if damage(cycles, middle) <= 1.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::life::{contact_line, root_line};
    use crate::material::Class;
    use proptest::prelude::*;

    fn line() -> Line {
        root_line(Class::CaseHardened, 0.85).times(900.0, 800.0)
    }

    /// The second way: time runs in short pieces, each with the stress of its place in a duty that is gone
    /// through again and again.
    fn life_by_running(cycles: &[Cycle], life_h: f64) -> f64 {
        let total: f64 = cycles.iter().map(|cycle| cycle.cycles).sum();
        let rounds = 20_000.0;
        let (mut used, mut hours) = (0.0, 0.0);
        for cycle in cycles.iter().cycle() {
            let pieces = 4;
            for _ in 0..pieces {
                used += cycle.cycles / rounds / f64::from(pieces) / cycle.line.cycles(cycle.stress);
                hours += life_h * cycle.cycles / total / rounds / f64::from(pieces);
                if used >= 1.0 {
                    return hours;
                }
            }
        }
        hours
    }

    #[test]
    fn the_life_is_the_time_after_which_a_running_duty_has_used_it_up() {
        let cycles: Vec<Cycle> = [(1500.0, 2e5), (1100.0, 1e6), (760.0, 8e7), (300.0, 1e9)]
            .map(|(stress, cycles)| Cycle { stress, cycles, line: line() })
            .to_vec();
        let life = worn(&cycles, 1000.0).life.unwrap().hours();
        assert!((life_by_running(&cycles, 1000.0) / life - 1.0).abs() < 1e-3);
    }

    #[test]
    fn one_step_has_the_safety_of_its_limit() {
        let cycle = Cycle { stress: 700.0, cycles: 4.2e6, line: line() };
        let worn = worn(&[cycle], 100.0);
        assert!((worn.safety - line().at(4.2e6) / 700.0).abs() < 1e-12);
    }

    #[test]
    fn a_stress_above_the_static_limit_ends_the_life_and_a_small_one_does_nothing() {
        let of = |stress| worn(&[Cycle { stress, cycles: 10.0, line: line() }], 100.0);
        assert_eq!(of(3000.0).damage, f64::INFINITY);
        assert_eq!(of(3000.0).life.map(Physical::hours), Some(0.0));
        assert_eq!((of(10.0).damage, of(10.0).life), (0.0, None));
        assert!((of(10.0).safety - 2250.0 / 10.0).abs() < 1e-9);
    }

    proptest! {
        /// Damage on one straight piece of the line equals that of the power mean of the stresses.
        #[test]
        fn on_one_piece_a_power_mean_stands_for_all(
            stresses in prop::collection::vec(700.0..1200.0_f64, 1..6), each in 1e5..1e6_f64,
        ) {
            let line = contact_line(Class::CaseHardened, false, 0.85).times(1400.0, 650.0);
            let cycles: Vec<Cycle> = stresses.iter().map(|&stress| Cycle { stress, cycles: each, line }).collect();
            let exponent = libm::log(5e7_f64 / 1e5) / libm::log(line.at(0.0) / line.at(5e7));
            let count = stresses.len() as f64;
            let mean = libm::pow(stresses.iter().map(|stress| libm::pow(*stress, exponent)).sum::<f64>() / count, 1.0 / exponent);
            let one = Cycle { stress: mean, cycles: each * count, line };
            prop_assert!((damage(&cycles, 1.0) / damage(&[one], 1.0) - 1.0).abs() < 1e-9);
        }

        #[test]
        fn the_safety_is_where_the_damage_is_1(
            stresses in prop::collection::vec(200.0..1500.0_f64, 1..6), each in 1e4..1e8_f64,
        ) {
            let cycles: Vec<Cycle> = stresses.iter().map(|&stress| Cycle { stress, cycles: each, line: line() }).collect();
            let safety = safety(&cycles);
            prop_assert!(damage(&cycles, safety * (1.0 - 1e-9)) <= 1.0 + 1e-6);
            prop_assert!(damage(&cycles, safety * (1.0 + 1e-6)) > 1.0);
        }
    }
}
