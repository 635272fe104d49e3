//! Practical limits for a hydromotor. A value beyond them leads to a warning, never to a refusal.
//!
//! - pressure drop: the value that the material's limits allow, if they are given, for the contact and root
//!   stress of the teeth
//! - pressure drop: 25 MPa, usual with oil
//! - contact stress without a given limit: 1600 MPa, case-hardened steel
//! - ripple of flow and torque: 10 %, which the drive feels
//! - change of the pressure in a closed chamber without a given limit: the pressure drop, more than the ports
//!   ever apply
//! - gap at an end face: 5 to 15 µm; below it jams, above it leaks
//! - volumetric efficiency: 0.85; below it too much oil leaks
//!
//! The values are those of practice, without a source of their own.

use super::made::Made;
use super::made::ports::MadePorts;
use super::{AllowedPressure, ContactStresses, Flanks, GoverningLimit, Losses};
use crate::answer::Warning;
use crate::tolerance::SAME_GAP;
use epicyclic_units::Physical as _;
use epicyclic_units::format;
use uom::si::f64::{Length, Pressure};

const PRESSURE_PA: f64 = 25e6;
const CONTACT_PA: f64 = 1600e6;
const RIPPLE: f64 = 0.1;
const GAP_M: [f64; 2] = [5e-6, 15e-6];
const VOLUMETRIC: f64 = 0.85;

fn pressure(pa: f64) -> String {
    format::quantity(Pressure::from_si(pa), 4)
}

fn warning(name: &'static str, message: String) -> Warning {
    Warning { name, message }
}

/// Warnings about a pressure drop above the allowed or the usual value.
pub(crate) fn of_pressure(drop_pa: Option<f64>, flanks: Option<&Flanks>) -> Vec<Warning> {
    let Some(drop) = drop_pa else { return vec![] };
    let mut found = vec![];
    let allowed = flanks.and_then(|flanks| flanks.allowed.as_ref());
    match (allowed, flanks) {
        (Some(AllowedPressure { pressure_pa, governing, .. }), _) if drop > *pressure_pa => {
            let by = match governing {
                GoverningLimit::Contact => "the contact stress",
                GoverningLimit::StatorRoot => "the stress at the stator's roots",
                GoverningLimit::RotorRoot => "the stress at the rotor's roots",
                GoverningLimit::SatelliteRoot => "the stress at the satellites' roots",
            };
            let [drop, allowed] = [drop, *pressure_pa].map(pressure);
            found.push(warning(
                "pressure-above-allowed",
                format!("pressure drop {drop} exceeds the {allowed} that {by} allows"),
            ));
        }
        (None, Some(flanks)) => {
            if let Some(stress) = greatest_contact(&flanks.contact).filter(|stress| *stress > CONTACT_PA) {
                found.push(of_contact(stress));
            }
        }
        _ => {}
    }
    if drop > PRESSURE_PA {
        let [drop, usual] = [drop, PRESSURE_PA].map(pressure);
        let message = format!("pressure drop {drop} exceeds {usual}, the usual limit with oil");
        found.push(warning("pressure-above-usual", message));
    }
    found
}

fn of_contact(stress: f64) -> Warning {
    let [stress, usual] = [stress, CONTACT_PA].map(pressure);
    let message = format!("contact stress {stress} exceeds {usual}, the limit of case-hardened steel");
    warning("contact-stress-above-usual", message)
}

/// Greatest contact stress in Pa while a single pair of flanks carries; at the pitch point if there are
/// always two.
pub(crate) fn greatest_contact(stresses: &[ContactStresses]) -> Option<f64> {
    stresses.iter().map(|one| one.alone_pa.unwrap_or(one.at_pitch_point_pa)).reduce(f64::max)
}

/// Warnings about ripple, gaps, trapped pressure and efficiency.
pub(crate) fn of_work(drop_pa: Option<f64>, ripple: f64, made: &Made) -> Vec<Warning> {
    let percent = |share: f64| format!("{:.1} %", 100.0 * share);
    let mut found = vec![];
    if ripple > RIPPLE {
        let message =
            format!("ripple of flow and torque {} exceeds the usual {}", percent(ripple), percent(RIPPLE));
        found.push(warning("ripple-above-usual", message));
    }
    if let (Some(drop), None) = (drop_pa, made.most_trapped) {
        let change = made.port_figures.as_ref().and_then(MadePorts::greatest_change);
        if let Some(change) = change.filter(|change| *change > drop) {
            let [change, drop] = [change, drop].map(pressure);
            let message = format!(
                "the pressure in a closed chamber changes by {change}, more than the pressure drop {drop}: open the ports earlier"
            );
            found.push(warning("trapped-pressure-above-drop", message));
        }
    }
    let Some(Losses { leakage, at_point, .. }) = &made.losses else { return found };
    let gaps =
        leakage.as_ref().map(|leaks| [("satellite", leaks.satellite_gap_m), ("rotor", leaks.rotor_gap_m)]);
    // A rounding error of the unit must not put a gap beyond the limit.
    let is_usual = |gap: f64| (GAP_M[0] * (1.0 - SAME_GAP)..=GAP_M[1] * (1.0 + SAME_GAP)).contains(&gap);
    for (wheel, gap) in gaps.into_iter().flatten().filter(|(_, gap)| *gap > 0.0 && !is_usual(*gap)) {
        let [gap, least, most] =
            [gap, GAP_M[0], GAP_M[1]].map(|gap| format::quantity(Length::from_si(gap), 4));
        let message = format!("gap of {gap} at a face of the {wheel}: usual are {least} to {most}");
        found.push(warning("gap-unusual", message));
    }
    if let Some(at) = at_point.as_ref().filter(|at| at.volumetric < VOLUMETRIC) {
        let message = format!("volumetric efficiency {:.3} is below the usual {VOLUMETRIC}", at.volumetric);
        found.push(warning("volumetric-efficiency-low", message));
    }
    found
}

/// Load capacity of a design in a search.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Borne {
    /// Pressure drop in Pa that the limits of the material allow.
    Allowed(f64),
    /// Greatest contact stress in Pa, without such limits.
    Contact(f64),
}

/// Warnings about a pressure drop above what the designs of a search can bear, or above the usual value.
pub(crate) fn of_designs(drop_pa: Option<f64>, designs: &[Borne]) -> Vec<Warning> {
    let Some(drop) = drop_pa else { return vec![] };
    let count = |is_beyond: &dyn Fn(&Borne) -> bool| designs.iter().filter(|one| is_beyond(one)).count();
    let above_allowed = count(&|one| matches!(one, Borne::Allowed(allowed) if drop > *allowed));
    let above_usual = count(&|one| matches!(one, Borne::Contact(stress) if *stress > CONTACT_PA));
    let (all, at) = (designs.len(), pressure(drop));
    let mut found = vec![];
    if above_allowed > 0 {
        let message =
            format!("pressure drop {at} exceeds what {above_allowed} of the {all} designs shown allow");
        found.push(warning("pressure-above-allowed", message));
    }
    if above_usual > 0 {
        let limit = pressure(CONTACT_PA);
        let message = format!(
            "at {at} the contact stress of {above_usual} of the {all} designs shown exceeds {limit}, the limit of case-hardened steel"
        );
        found.push(warning("contact-stress-above-usual", message));
    }
    found.extend(of_pressure(drop_pa, None));
    found
}
