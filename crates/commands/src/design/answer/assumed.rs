//! Assumptions of designs beside the keys of the basis: sharing of the load, duty, space of the sizes,
//! standards.

use crate::error::Error;
use crate::shared::application::Application;
use crate::shared::basis::{Basis, BasisKey};
use crate::size::options::Request as SizeRequest;
use clap::ValueEnum;
use epicyclic_strength::factor::{Edition, Symbol};
use epicyclic_strength::load::{Floating, MOST_SHARING, load_sharing};
use epicyclic_strength::plain_bearing::{GREATEST_PRESSURE, USUAL_PRESSURE};
use epicyclic_units::Physical;
use epicyclic_units::format::trimmed;

/// Digits of assumed values.
const DIGITS: usize = 4;

/// Load that a design assumes where it is not asked for.
pub(super) struct AssumedLoad<'a> {
    /// Steps in each gear: share of its time, torque and speed over those of the load.
    pub(super) spectrum: &'a [[f64; 3]],
    /// Number of gears.
    pub(super) gears: usize,
    /// Shares of the time of the gears; empty for equal shares.
    pub(super) shares: &'a [f64],
    /// Greatest torque during the life over the nominal torque.
    pub(super) overload: Option<f64>,
}

/// Assumed values that are no keys of the basis.
///
/// # Errors
/// Those of [`load_sharing`].
pub(super) fn assumed(
    basis: &Basis,
    size: &SizeRequest,
    load: &AssumedLoad<'_>,
) -> Result<Vec<BasisKey>, Error> {
    let mut all = vec![];
    let mut assume = |key: &str, value: String| all.push(BasisKey { key: key.to_owned(), value });
    if let Some(named) = size.application.as_ref().and_then(ValueEnum::to_possible_value) {
        let brings = "usual K_A, life, safeties, planets, bearings where nothing else is asked for";
        assume("application", format!("{}: {brings}", named.get_name()));
    }
    if !basis.has_factor(Symbol::LoadSharing) {
        assume("K_γ", sharing(size)?);
    }
    if size.widens_face_load {
        assume("K_Hβ", "1 + 0.4·(b/d)² of the smaller gear where that is more".to_owned());
    }
    assume("duty", duty(load.spectrum));
    if !basis.has_factor(Symbol::MeanStress) {
        let both = "of one sign in each gear; where it reverses, Y_M is 0.7 of sun and ring as of planets";
        assume("torque", both.to_owned());
    }
    if load.gears > 1 {
        let percent = |share: &f64| format!("{} %", trimmed(100.0 * share, DIGITS));
        let shares = match load.shares {
            [] => "equal parts of the time".to_owned(),
            shares => shares.iter().map(percent).collect::<Vec<_>>().join(", "),
        };
        assume("shares of the gears", shares);
    }
    if load.overload.is_none() {
        assume("overload", "none: the torque is the greatest of the life".to_owned());
    }
    assume("helix angle", helix_angle(basis, size));
    let is_helical = basis.helix_angle.is_some_and(|angle| angle.0.si() != 0.0);
    of_application(size, is_helical, &mut assume);
    let plain = if size.has_plain_bearings() { ", plain ones ISO 7902" } else { "" };
    assume("standards", format!("{}, method B; bearings ISO 281 and ISO 76{plain}", Edition::default()));
    Ok(all)
}

/// Helix angle of all sets, and where it comes from.
fn helix_angle(basis: &Basis, size: &SizeRequest) -> String {
    match basis.helix_angle.filter(|angle| angle.0.si() != 0.0) {
        None => "0: spur teeth".to_owned(),
        Some(angle) if size.application.and_then(Application::helix_angle) == Some(angle) => {
            format!(
                "{angle} in all sets: usual of the application, without a source; --helix-angle changes it"
            )
        }
        Some(angle) => format!("{angle} in all sets, as asked for"),
    }
}

/// Values that the application brings where the space of sizes leaves them open.
fn of_application(size: &SizeRequest, is_helical: bool, assume: &mut impl FnMut(&str, String)) {
    let usual = size.application;
    if size.planets.is_none() {
        let counts = size.planet_counts();
        let ends = [counts.start(), counts.end()].map(u32::to_string);
        assume("planets", if ends[0] == ends[1] { ends[0].clone() } else { ends.join("..") });
    }
    if !size.no_bearings {
        if size.bearings.is_none() {
            let named = size.bearing_kinds().iter().filter_map(ValueEnum::to_possible_value);
            let named: Vec<String> = named.map(|kind| kind.get_name().to_owned()).collect();
            assume("bearings of the planets", named.join(", "));
        }
        let rows = if is_helical {
            "; with the moment that tilts a planet, on both bearing rows at its ends: bearing_span of the saved file"
        } else {
            ""
        };
        if size.has_plain_bearings() {
            assume(
                "plain bearings",
                format!(
                    "{} N/mm² at most, {} for a short time, clearance 0.8 ‰·v^¼ with the sliding speed v in m/s, oil of 70 °C; their heat is not calculated",
                    USUAL_PRESSURE / 1e6,
                    GREATEST_PRESSURE / 1e6
                ),
            );
        }
        assume("load of the bearings", format!("the torques of the duty with K_γ, without K_A{rows}"));
    }
    if let Some(modules) = usual.and_then(Application::modules).filter(|_| size.modules.is_none()) {
        let all: Vec<String> = modules.iter().map(|module| trimmed(module.mm(), DIGITS)).collect();
        assume("modules", format!("{} mm", all.join(", ")));
    }
    if let Some(widths) = usual.and_then(Application::face_widths).filter(|_| size.face_widths.is_none()) {
        let ends = [widths.first(), widths.last()].map(|of| of.map_or(0.0, |width| width.mm()));
        assume("face widths", format!("{}..{} mm", ends[0], ends[1]));
    }
}

/// `K_γ` of the numbers of planets that are allowed.
fn sharing(size: &SizeRequest) -> Result<String, Error> {
    let mut all = vec![];
    for planets in size.planet_counts().filter(|planets| (2..=MOST_SHARING).contains(planets)) {
        let factor = load_sharing(planets, Floating::Assumed)?;
        all.push(format!("{} with {planets} planets", trimmed(factor, DIGITS)));
    }
    Ok(match &all[..] {
        [] => "1 with one planet".to_owned(),
        all => format!("{}: one member of each set floats", all.join(", ")),
    })
}

/// Steps of the duty in words.
fn duty(spectrum: &[[f64; 3]]) -> String {
    let step = |[share, torque, speed]: &[f64; 3]| {
        let percent = |part: &f64| trimmed(100.0 * part, DIGITS);
        format!(
            "{} % of the time {} % of torque, {} % of speed",
            percent(share),
            percent(torque),
            percent(speed)
        )
    };
    let is_runaway = |step: &&[f64; 3]| step[..2] == [0.0; 2];
    let steps: Vec<[f64; 3]> = spectrum.iter().filter(|step| !is_runaway(step)).copied().collect();
    let mut all = match steps[..] {
        [[_, 1.0, 1.0]] => "full torque and speed for the whole life".to_owned(),
        ref steps => steps.iter().map(step).collect::<Vec<_>>().join("; "),
    };
    for [.., speed] in spectrum.iter().filter(is_runaway) {
        all.push_str(&format!("; at most {} % of speed, without load", trimmed(100.0 * speed, DIGITS)));
    }
    all
}
