//! Judgement of hydromotors by rules of practice. No motor is refused for them.
//!
//! Limits of the material, where they are stated, allow a pressure drop, and the contact stress alone does
//! not count. Checks of centrodes and limits of teeth are part of the judgement.

use super::made::Made;
use super::{Check, GoverningLimit, Motor, ToothLimit, Verdict, greatest_contact};
use crate::shared::judgement::answer::{GEOMETRY, Judged, Judgement};
use crate::shared::judgement::judge::Judge;
use crate::shared::number::si;
use epicyclic_hydromotor::profile::limits::LimitKind;
use epicyclic_judge::{Rule, Severity};
use epicyclic_units::Dimension::{Angle, Length};
use uom::si::f64::Pressure;

/// Name of the motor as a whole in its judgement.
const MOTOR: &str = "motor";

const MPA: f64 = 1e6;
const MM: f64 = 1e-3;
const MM2: f64 = MM * MM;
const MICROMETRE: f64 = MM / 1e3;

/// Judges a motor by its results; the pressure drop counts without a width, too.
pub(crate) fn judgement(motor: &Motor, made: &Made, drop: Option<Pressure>) -> Judgement {
    let mut judge = Judge::default();
    for check in &motor.checks {
        judge.take_geometry(of_centrodes(check));
    }
    for limit in motor.tooth_limits.iter().flatten() {
        judge.take_geometry(of_teeth(limit));
    }
    let no_teeth = || vec!["no teeth of this form".to_owned()];
    match &motor.clearances {
        Some(clearances) => {
            for one in clearances {
                judge.see(Rule::Overlap, &[one.between.words()], one.clearance_in_modules);
            }
        }
        None => judge.lacks(MOTOR, &[Rule::Overlap], no_teeth()),
    }
    judge.see(Rule::ChamberArea, &[MOTOR], motor.work.least_chamber_m2 / MM2);
    let flanks = motor.flanks.as_ref();
    let no_flanks = || match (flanks, &motor.clearances) {
        (Some(_), _) => vec!["pressure".to_owned()],
        (None, Some(_)) => vec!["the flanks hold no satellite".to_owned()],
        (None, None) => no_teeth(),
    };
    let borne = flanks.zip(drop).and_then(|(flanks, _)| {
        let allowed = flanks
            .allowed
            .as_ref()
            .map(|allowed| Borne::Allowed { pressure_pa: allowed.pressure_pa, governing: allowed.governing });
        allowed.or_else(|| greatest_contact(&flanks.contact).map(Borne::Contact))
    });
    pressure(&mut judge, drop.map(si));
    match borne {
        Some(borne) => borne.judge(&mut judge, MOTOR, drop.map(si)),
        None => judge.lacks(MOTOR, &[Rule::AllowedPressure, Rule::ContactStress], no_flanks()),
    }
    trapped(&mut judge, motor, made, drop);
    gaps(&mut judge, motor, made);
    judge.see(Rule::Ripple, &[MOTOR], flanks.map_or(motor.work.ripple, |flanks| flanks.ripple));
    judge.judgement()
}

/// Judges the pressure drop by the usual limit with oil.
fn pressure(judge: &mut Judge, drop_pa: Option<f64>) {
    match drop_pa {
        Some(drop) => judge.see(Rule::MotorPressure, &[MOTOR], drop / MPA),
        None => judge.lacks(MOTOR, &[Rule::MotorPressure], vec!["pressure".to_owned()]),
    }
}

/// Load capacity of a motor.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Borne {
    /// Pressure drop that the limits of the material allow, and the limit that governs it.
    Allowed { pressure_pa: f64, governing: GoverningLimit },
    /// Greatest contact stress in Pa, without such limits.
    Contact(f64),
}

impl Borne {
    fn judge(self, judge: &mut Judge, name: &str, drop_pa: Option<f64>) {
        match (self, drop_pa) {
            (Self::Allowed { pressure_pa, governing }, Some(drop)) => {
                let by = match governing {
                    GoverningLimit::Contact => "contact stress",
                    GoverningLimit::StatorRoot => "roots of the stator",
                    GoverningLimit::RotorRoot => "roots of the rotor",
                    GoverningLimit::SatelliteRoot => "roots of the satellites",
                };
                judge.see_most(Rule::AllowedPressure, &[name, by], pressure_pa / MPA, drop / MPA);
            }
            (Self::Allowed { .. }, None) => {}
            (Self::Contact(stress), _) => {
                judge.see(Rule::ContactStress, &[name], stress / MPA);
                let keys = ["material.contact_limit", "material.root_limit"].map(str::to_owned);
                judge.lacks(MOTOR, &[Rule::AllowedPressure], keys.to_vec());
            }
        }
    }
}

/// Judges the pressure in closed chambers by the limit that is given, otherwise by the pressure drop: more
/// than the ports ever apply.
fn trapped(judge: &mut Judge, motor: &Motor, made: &Made, drop: Option<Pressure>) {
    let most = made.most_trapped.or(drop).map(si);
    let missing = [
        ("ports", made.ports.is_none()),
        ("oil.bulk_modulus", made.bulk_modulus.is_none()),
        ("pressure", most.is_none()),
    ];
    let missing: Vec<String> =
        missing.into_iter().filter(|(_, lacks)| *lacks).map(|(key, _)| key.to_owned()).collect();
    let (Some(ports), Some(most), true) = (&motor.made_ports, most, missing.is_empty()) else {
        return judge.lacks(MOTOR, &[Rule::TrappedPressure], missing);
    };
    for one in &ports.closed {
        let [from, to] = [one.from_rad, one.to_rad].map(|rad| crate::table::quantities::words(Angle, rad, 4));
        let of = format!("chamber closed from {from} to {to}");
        let change = one.change_pa.unwrap_or_default().abs();
        judge.see_most(Rule::TrappedPressure, &[&of], most / MPA, change / MPA);
    }
}

/// Judges gaps, and the oil that leaks through them. A face without a gap seals.
fn gaps(judge: &mut Judge, motor: &Motor, made: &Made) {
    let Some(gaps) = made.gaps else {
        return judge.lacks(MOTOR, &[Rule::AxialGap, Rule::VolumetricEfficiency], vec!["gaps".to_owned()]);
    };
    for (wheel, gap) in [("faces of a satellite", gaps.satellite), ("faces of the rotor", gaps.rotor)] {
        if gap > uom::si::f64::Length::default() {
            judge.see(Rule::AxialGap, &[wheel], si(gap) / MICROMETRE);
        }
    }
    let Some(losses) = &motor.losses else { return };
    match &losses.at_point {
        Some(at) => judge.see(Rule::VolumetricEfficiency, &[MOTOR], at.volumetric),
        None => judge.lacks(MOTOR, &[Rule::VolumetricEfficiency], losses.missing.clone()),
    }
}

impl Check {
    /// Message about a check that fails.
    pub(crate) fn miss(&self) -> Option<String> {
        let [value, limit] =
            [self.value_m, self.limit_m].map(|m| crate::table::quantities::words(Length, m, 4));
        let words = self.check.words();
        (self.verdict == Verdict::Fails).then(|| format!("{words}: {value}, and it must exceed {limit}"))
    }
}

fn of_centrodes(check: &Check) -> Judged {
    let message = check.miss();
    Judged {
        name: check.check.name(),
        of: vec!["centrodes".to_owned()],
        value: Some(check.value_m / MM),
        limit: check.limit_m / MM,
        unit: "mm",
        severity: Severity::Error,
        holds: message.is_none(),
        source: GEOMETRY,
        remedy: message.is_some().then_some("smaller teeth, or another place in the family"),
        message,
    }
}

impl ToothLimit {
    /// Message about a limit that the teeth exceed.
    pub(crate) fn miss(&self) -> Option<String> {
        let [value, bound] =
            [self.value_m, self.bound_m].map(|m| crate::table::quantities::words(Length, m, 4));
        let (wheel, kind, side) = (self.wheel.words(), self.limit.words(), self.side.words());
        (self.verdict == Verdict::Fails)
            .then(|| format!("teeth of the {wheel}: {kind}: {value}, allowed {side} {bound}"))
    }
}

fn of_teeth(limit: &ToothLimit) -> Judged {
    let message = limit.miss();
    Judged {
        name: limit.limit.name(),
        of: vec![format!("teeth of the {}", limit.wheel.words())],
        value: Some(limit.value_m / MM),
        limit: limit.bound_m / MM,
        unit: "mm",
        severity: match limit.limit {
            // Such teeth are weak, and turn all the same.
            LimitKind::Undercut | LimitKind::TipThickness => Severity::Warning,
            _ => Severity::Error,
        },
        holds: message.is_none(),
        source: GEOMETRY,
        remedy: message.is_some().then_some("another tooth form, or other tooth numbers"),
        message,
    }
}

/// Design of a search as far as its judgement goes.
pub(crate) struct Searched {
    /// Name of the design.
    pub(crate) name: String,
    /// Least area of a chamber; `None` if the search does not keep it.
    pub(crate) least_chamber_m2: Option<f64>,
    pub(crate) ripple: f64,
    pub(crate) borne: Option<Borne>,
}

/// Judges the listed designs of a search, which has no ports, gaps and oil.
pub(crate) fn of_designs(drop_pa: Option<f64>, designs: &[Searched]) -> Judgement {
    let mut judge = Judge::default();
    if designs.is_empty() {
        return judge.judgement();
    }
    pressure(&mut judge, drop_pa);
    for Searched { name, least_chamber_m2, ripple, borne } in designs {
        if let Some(area) = least_chamber_m2 {
            judge.see(Rule::ChamberArea, &[name], area / MM2);
        }
        match borne {
            Some(borne) => borne.judge(&mut judge, name, drop_pa),
            None => {
                let why = if drop_pa.is_none() { "pressure" } else { "no load on the flanks follows" };
                judge.lacks(name, &[Rule::AllowedPressure, Rule::ContactStress], vec![why.to_owned()]);
            }
        }
        judge.see(Rule::Ripple, &[name], *ripple);
    }
    let has_chambers = designs.iter().all(|one| one.least_chamber_m2.is_some());
    let later = [Rule::TrappedPressure, Rule::AxialGap, Rule::VolumetricEfficiency, Rule::Overlap];
    let later: Vec<Rule> = later.into_iter().chain((!has_chambers).then_some(Rule::ChamberArea)).collect();
    judge.lacks(
        "designs",
        &later,
        vec!["`motor` judges one design with its teeth, ports and gaps".to_owned()],
    );
    judge.judgement()
}
