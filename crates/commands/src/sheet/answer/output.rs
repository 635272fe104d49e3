//! Backlash and torsional stiffness at the output in each gear while the input is held.
//!
//! ```text
//! φ = Σ N·|T_x|·φ_x        1/k = Σ N·(T_x/r_b,x)²/(c_γ·b)
//! ```
//!
//! `T_x` is the torque of a mesh on one of its gears over that on the output, `φ_x` the angle by which its
//! play lets this gear turn, `N` the number of planets, `c_γ·b` the stiffness of the mesh along its line of
//! action.

use super::records::{Allowed, AtOutput, Limits};
use crate::analyze::answer::analysis;
use crate::error::Error;
use crate::shared::gearbox::Gearbox;
use crate::tolerance::ROUNDED;
use epicyclic_gears::involute::play::Deviation;
use epicyclic_strength::load::mesh_stiffness;
use epicyclic_train::toothed::ToothedSet;
use epicyclic_train::{Analysis, Gear, PlanetSet};
use epicyclic_units::Physical;
use uom::si::f64::Length;

/// Set with known teeth.
pub(super) struct Known<'g> {
    /// Place of the set in the gearbox.
    pub(super) place: usize,
    pub(super) set: &'g PlanetSet,
    pub(super) toothed: ToothedSet,
    /// Place of each gear of each mesh among the gears.
    pub(super) gears: Vec<[usize; 2]>,
    /// Common face width of each mesh.
    pub(super) face_widths: Vec<Option<Length>>,
    pub(super) allowed: Option<Allowed>,
}

/// Results for every gear of a gearbox.
pub(super) fn of_gears(subject: &Gearbox, known: &[Known<'_>]) -> Result<Vec<AtOutput>, Error> {
    let gears = subject.train.gears().iter().map(Gear::name);
    gears.map(|name| of_gear(subject, known, name, &analysis(&subject.train, name)?)).collect()
}

fn of_gear(
    subject: &Gearbox,
    known: &[Known<'_>],
    name: &str,
    analysis: &Analysis<'_>,
) -> Result<AtOutput, Error> {
    let mut row =
        AtOutput { gear: name.to_owned(), backlash_rad: None, stiffness_n_m: None, missing: vec![] };
    let Some(case) = analysis.ideal().filter(|case| case.output != 0.0) else {
        row.missing.push("no torques follow".to_owned());
        return Ok(row);
    };
    let (mut backlash, mut compliance) = ([0.0; 2], Some(0.0));
    let mut is_whole = true;
    for (place, members) in case.members.iter().enumerate() {
        let torque = |of: &f64| of / case.output;
        let torques: Vec<f64> = members.iter().flatten().map(torque).collect();
        if torques.iter().all(|torque| torque.abs() < ROUNDED) {
            continue;
        }
        let id = subject.train.sets()[place].id();
        let one = known.iter().find(|one| one.place == place);
        let Some((one, torques)) = one.and_then(|one| Some((one, one.set.mesh_torques(&torques)?))) else {
            row.missing.push(format!("the teeth of set {id}"));
            is_whole = false;
            continue;
        };
        let own = one.backlash(&torques)?;
        backlash = [backlash[0] + own[0], backlash[1] + own[1]];
        let own = one.compliance(&torques)?;
        if own.is_none() {
            row.missing.push(format!("planets or face_width of set {id}, for the stiffness"));
        }
        compliance = compliance.zip(own).map(|(all, own)| all + own);
    }
    if is_whole {
        let [lower, upper] = backlash;
        // Gears that wedge have no play; a warning is of the mesh.
        row.backlash_rad = Some(Limits { lower: lower.max(0.0), upper: upper.max(0.0) });
        row.stiffness_n_m = compliance.filter(|all| *all > 0.0).map(f64::recip);
    }
    Ok(row)
}

impl Known<'_> {
    /// Angle by which the output turns while the play of these meshes is taken up, least and greatest.
    fn backlash(&self, torques: &[[f64; 2]]) -> Result<[f64; 2], Error> {
        let at = |limit: fn(&Deviation) -> f64, deviation_m: f64| -> Result<f64, Error> {
            let mut angle = 0.0;
            for ((mesh, torques), gears) in self.toothed.meshes.iter().zip(torques).zip(&self.gears) {
                let allowance =
                    |gear: usize| self.allowed.as_ref().map_or(0.0, |all| limit(&all.thickness[gear]));
                // By virtual work: what a mesh gives way, times the torque that it carries of one on the
                // output.
                let play = mesh.pair.deviating(gears.map(allowance), deviation_m / mesh.module)?.play();
                angle += torques[0].abs() * play.rotation_rad[0];
            }
            Ok(angle)
        };
        let [near, far] = self.allowed.as_ref().map_or([0.0; 2], |all| all.centre_distance_m);
        // Whether the sum of the plays rises or falls with the centre distance does not change with it.
        let (upper, lower) = (|it: &Deviation| it.upper, |it: &Deviation| it.lower);
        Ok([at(upper, near)?.min(at(upper, far)?), at(lower, near)?.max(at(lower, far)?)])
    }

    /// Angle of the output under a torque of 1 N·m on it; `None` without the planets or widths of a mesh that
    /// carries torque.
    fn compliance(&self, torques: &[[f64; 2]]) -> Result<Option<f64>, Error> {
        let planets = if self.set.is_pair() { Some(1) } else { self.set.planet_count() };
        let Some(planets) = planets.map(f64::from) else { return Ok(None) };
        let mut all = 0.0;
        for ((mesh, torques), width) in self.toothed.meshes.iter().zip(torques).zip(&self.face_widths) {
            if torques[0].abs() < ROUNDED {
                continue;
            }
            let Some(width) = width else { return Ok(None) };
            let force = torques[0] / planets / (mesh.pair.gears()[0].base_diameter() / 2.0 * mesh.module);
            all += planets * force * force / mesh_stiffness(&mesh.pair, *width)?.si();
        }
        Ok(Some(all))
    }
}
