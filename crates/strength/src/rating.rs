//! The strength of a mesh under one load: stresses, limits, safeties, and every factor with where it comes from.
//!
//! ```text
//! F_t = 2·T/d_1
//! σ_H = Z_B·σ_H0·√(K_A·K_γ·K_v·K_Hβ·K_Hα)                        of the second gear Z_D
//! σ_HG = σ_Hlim·Z_NT·Z_L·Z_v·Z_R·Z_W·Z_X                          S_H = σ_HG/σ_H
//! σ_F0 = F_t/(b·m_n)·Y_F·Y_S·Y_β·Y_B·Y_DT                         σ_F = σ_F0·K_A·K_γ·K_v·K_Fβ·K_Fα
//! σ_FG = σ_Flim·Y_ST·Y_NT·Y_δrelT·Y_RrelT·Y_X·Y_M                 S_F = σ_FG/σ_F
//! N_L = n·L·contacts
//! ```
//!
//! | symbol | argument | meaning | unit |
//! |---|---|---|---|
//! | `T` | [`Load::torque`] | torque that one mesh exchanges, on the first gear | N·m |
//! | `n` | [`Load::speed`] | speed of the first gear relative to the carrier; the second's follows from the teeth | rpm |
//! | `L` | [`Load::life`] | required life | h |
//! | | [`Load::contacts`] | how often a flank is loaded in a revolution relative to the carrier: of a sun, as often as there are planets | 1 |
//!
//! Torque and speed are sizes, without sign: a mesh is calculated for one flank. Of the sun–planet meshes of `p` planets `T` is the sun's torque over `p`;
//! of a planet–ring mesh it is the planet's share, the ring's torque over `p` times `z_p/z_r`.
//!
//! Below the cycles of the endurance limit the limit falls from the static one in a straight line of double logarithmic scales. For static strength
//! `Z_L`, `Z_v`, `Z_R`, `Y_RrelT` and `Y_X` are 1, so is `Z_W` where it is not given (its static formula was not available; it is above 1), and `Y_M` is
//! that of endurance. The `Z_NT` and `Y_NT` told are then what is left of the limit over the other factors.
//!
//! # Source
//! ISO 6336-2:2006, clause 5; ISO 6336-3:2006, clause 5; the factors as in [`contact`](crate::contact), [`factors`](crate::root::factors),
//! [`load`](crate::load), [`life`](crate::life).

use crate::factor::{Edition, Factor, Side, Symbol};
use crate::load::LoadFactors;
use crate::mesh::{Load, Mesh, Method};
use crate::prepared::Prepared;
use crate::root::section::RootSection;
use crate::units::{self, n_m, positive, pressure, rpm};
use crate::{Error, Quantity};
use uom::si::f64::{Force, Pressure, Torque, Velocity};

/// Contact stress, limit and safety of a gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactRating {
    /// `Z_B` or `Z_D`.
    pub single_contact: Factor,
    /// `σ_H`.
    pub stress: Pressure,
    /// `Z_NT`, `Z_L`, `Z_v`, `Z_R`, `Z_W`, `Z_X`.
    pub limit_factors: [Factor; 6],
    /// `σ_HG`.
    pub limit: Pressure,
    /// `S_H`.
    pub safety: f64,
}

/// Root stress, limit and safety of a gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RootRating {
    /// The critical section; `None` where `Y_F`, `Y_S` and `Y_δrelT` are given.
    pub section: Option<RootSection>,
    /// `Y_F`, `Y_S`, `Y_β`, `Y_B`, `Y_DT`.
    pub stress_factors: [Factor; 5],
    /// `σ_F0`.
    pub nominal: Pressure,
    /// `σ_F`.
    pub stress: Pressure,
    /// `Y_ST`, `Y_NT`, `Y_δrelT`, `Y_RrelT`, `Y_X`, `Y_M`.
    pub limit_factors: [Factor; 6],
    /// `σ_FG`.
    pub limit: Pressure,
    /// `S_F`.
    pub safety: f64,
}

/// A gear of a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GearRating {
    /// Load cycles `N_L`.
    pub cycles: f64,
    /// The flank.
    pub contact: ContactRating,
    /// The root.
    pub root: RootRating,
}

/// The strength of a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshRating {
    /// Edition of the standard.
    pub edition: Edition,
    /// Tangential force at the reference circle `F_t`.
    pub tangential_force: Force,
    /// Speed at the reference circle `v`.
    pub speed: Velocity,
    /// Load factors.
    pub load_factors: LoadFactors,
    /// `Z_H`, `Z_E`, `Z_ε`, `Z_β`.
    pub contact_factors: [Factor; 4],
    /// `σ_H0`.
    pub nominal_contact: Pressure,
    /// Both gears.
    pub gears: [GearRating; 2],
}

impl MeshRating {
    /// The factors of the whole mesh and those of one gear, in the order of the calculation.
    pub fn chain(&self, side: Side) -> impl Iterator<Item = Factor> + '_ {
        let load = &self.load_factors;
        let gear = &self.gears[side as usize];
        [load.application, load.sharing, load.dynamic, load.face_contact, load.transverse_contact]
            .into_iter()
            .chain(self.contact_factors)
            .chain([gear.contact.single_contact])
            .chain(gear.contact.limit_factors)
            .chain([load.face_root, load.transverse_root])
            .chain(gear.root.stress_factors)
            .chain(gear.root.limit_factors)
    }
}

/// Which safety of a mesh governs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Governing {
    /// The gear.
    pub side: Side,
    /// Flank or root.
    pub place: Place,
    /// Its safety.
    pub safety: f64,
    /// The safety required of it.
    pub required: f64,
}

/// Where a tooth fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Place {
    /// The flank, by pitting.
    Flank,
    /// The root, by bending.
    Root,
}

impl Governing {
    /// Whether it is enough, and with it all others of the mesh.
    #[must_use]
    pub fn is_enough(&self) -> bool {
        self.safety >= self.required
    }
}

impl MeshRating {
    /// The safety that is least over what is required of it; of equal ones the first gear's, and the flank's.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a required safety.
    pub fn governing(&self, required_contact: f64, required_root: f64) -> Result<Governing, Error> {
        let contact = positive(Quantity::RequiredSafety, required_contact, "")?;
        let root = positive(Quantity::RequiredSafety, required_root, "")?;
        let of = |side: Side, place| {
            let gear = &self.gears[side as usize];
            match place {
                Place::Flank => Governing { side, place, safety: gear.contact.safety, required: contact },
                Place::Root => Governing { side, place, safety: gear.root.safety, required: root },
            }
        };
        let over = |governing: &Governing| governing.safety / governing.required;
        let first = of(Side::First, Place::Flank);
        let others =
            [of(Side::First, Place::Root), of(Side::Second, Place::Flank), of(Side::Second, Place::Root)];
        Ok(others.into_iter().fold(first, |least, one| if over(&one) < over(&least) { one } else { least }))
    }
}

/// The strength of a mesh under a load.
///
/// # Errors
/// [`Error::NotPositive`], [`Error::OutOfRange`] and the like for a quantity outside what the standard holds for;
/// [`Error::MissingFactor`] for a factor that is neither given nor can be calculated, [`Error::GivenFactor`] for one given that is no number above 0;
/// [`Error::NoRootSection`].
///
/// # Example
/// See `examples/spur_pair.rs`, and `tests/published.rs` for the stage of a wind gearbox.
pub fn rate(mesh: &Mesh, load: &Load, method: &Method) -> Result<MeshRating, Error> {
    let prepared = Prepared::new(mesh, method)?;
    let torque = positive(Quantity::Torque, n_m(load.torque), "N·m")?;
    let speed_rpm = positive(Quantity::Speed, rpm(load.speed), "rpm")?;
    let hours = positive(Quantity::Life, units::hours(load.life), "h")?;
    let force = prepared.force(torque);
    let load_factors = prepared.load_factors(force, speed_rpm, method.given, method.dynamics.as_ref())?;
    let speed = prepared.speed(speed_rpm);
    let limits = prepared.limits(speed)?;
    let nominal_contact = prepared.nominal_contact(force);
    let gear = |side: Side| -> Result<GearRating, Error> {
        let cycles = prepared.cycles(side, speed_rpm, hours, load.contacts)?;
        let own = &prepared.gears[side as usize];
        let limit = &limits[side as usize];
        let stress = own.single_contact.value * nominal_contact * load_factors.contact();
        let contact_limit = limit.contact_at(cycles, &method.given, side)?;
        let nominal = prepared.nominal_root(side, force);
        let root_stress = nominal * load_factors.root();
        let root_limit = limit.root_at(cycles, &method.given, side)?;
        Ok(GearRating {
            cycles,
            contact: ContactRating {
                single_contact: own.single_contact,
                stress: pressure(stress),
                limit_factors: [
                    contact_limit.life,
                    limit.lubricant,
                    limit.velocity,
                    limit.roughness,
                    limit.work_hardening,
                    own.size_contact,
                ],
                limit: pressure(contact_limit.stress),
                safety: contact_limit.stress / stress,
            },
            root: RootRating {
                section: own.section,
                stress_factors: own.root_stress,
                nominal: pressure(nominal),
                stress: pressure(root_stress),
                limit_factors: [
                    own.test_gear,
                    root_limit.life,
                    own.notch,
                    own.surface,
                    own.size_root,
                    own.mean_stress,
                ],
                limit: pressure(root_limit.stress),
                safety: root_limit.stress / root_stress,
            },
        })
    };
    Ok(MeshRating {
        edition: method.edition,
        tangential_force: units::force(force),
        speed: units::velocity(speed),
        load_factors,
        contact_factors: prepared.contact_factors,
        nominal_contact: pressure(nominal_contact),
        gears: [gear(Side::First)?, gear(Side::Second)?],
    })
}

/// Safeties of a gear against the greatest torque of its life.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overload {
    /// `S_H` for static strength.
    pub contact: f64,
    /// `S_F` for static strength.
    pub root: f64,
}

/// Safeties of a mesh against an overload.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OverloadRating {
    /// Edition of the standard.
    pub edition: Edition,
    /// Both gears.
    pub gears: [Overload; 2],
}

/// Safeties of both gears against the greatest torque of their life, static: `K_A` and `K_v` are 1, since the torque contains them. Given `Z_NT` and `Y_NT`
/// are of the duty's cycles and not used here.
///
/// # Errors
/// Those of [`rate`]; [`Error::MissingFactor`] for `Y_δrelT,stat` of a class whose formula is not known.
pub fn overload(mesh: &Mesh, torque: Torque, method: &Method) -> Result<OverloadRating, Error> {
    let prepared = Prepared::new(mesh, method)?;
    let force = prepared.force(positive(Quantity::Torque, n_m(torque), "N·m")?);
    let given = method.given.with(Symbol::Application, 1.0).with(Symbol::Dynamic, 1.0);
    let factors = prepared.load_factors(force, 0.0, given, method.dynamics.as_ref())?;
    let side = |side: Side| -> Result<Overload, Error> {
        let own = &prepared.gears[side as usize];
        let contact =
            own.contact_limit * own.contact_line.at(0.0) * own.work_hardening_static * own.size_contact.value;
        let contact_stress = own.single_contact.value * prepared.nominal_contact(force) * factors.contact();
        let root = own.static_root.clone()? * own.root_line.at(0.0);
        let root_stress = prepared.nominal_root(side, force) * factors.root();
        Ok(Overload { contact: contact / contact_stress, root: root / root_stress })
    };
    Ok(OverloadRating { edition: method.edition, gears: [side(Side::First)?, side(Side::Second)?] })
}
