//! Strength of a mesh under one load: stresses, limits, safeties, and every factor with its origin.
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
//! | `n` | [`Load::speed`] | speed of the first gear relative to the carrier | rpm |
//! | `L` | [`Load::life`] | required life | h |
//! | | [`Load::contacts`] | loads of a flank in a revolution relative to the carrier | 1 |
//!
//! Torque and speed are magnitudes, without sign: a mesh is calculated for one flank. The speed of the second
//! gear follows from the teeth. A flank of a sun is loaded as often per revolution as there are planets.
//!
//! In the sun–planet mesh of a set with `p` planets, `T` is the sun's torque over `p`. In a planet–ring mesh
//! it is the planet's share: the ring's torque over `p` times `z_p/z_r`.
//!
//! Below the cycles of the endurance limit the limit falls from the static one in a straight line of double
//! logarithmic scales. For static strength `Z_L`, `Z_v`, `Z_R`, `Y_RrelT` and `Y_X` are 1, and `Y_M` is that
//! of endurance. `Z_W` is 1, too, where it is not given: its static formula was not available; it is above 1.
//! The reported `Z_NT` and `Y_NT` are then the limit divided by the other factors.
//!
//! # Source
//! ISO 6336-2:2006, clause 5; ISO 6336-3:2006, clause 5; the factors as in [`contact`](crate::contact),
//! [`factors`](crate::root::factors), [`load`](crate::load), [`life`](crate::life).

use crate::checks::positive;
use crate::factor::{Edition, Factor, Side, Symbol};
use crate::load::LoadFactors;
use crate::mesh::{Load, Mesh, Method};
use crate::prepared::{Prepared, part_of};
use crate::root::section::RootSection;
use crate::{Error, Quantity};
use epicyclic_units::Physical;
use std::iter;
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
#[derive(Debug, Clone, PartialEq)]
pub struct GearRating {
    /// Load cycles `N_L`.
    pub cycles: f64,
    /// The flank, or why it cannot be rated: outside what the standard holds for, or without a factor.
    pub contact: Result<ContactRating, Error>,
    /// The root, likewise.
    pub root: Result<RootRating, Error>,
}

/// The strength of a mesh.
#[derive(Debug, Clone, PartialEq)]
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
    /// Ratings of both gears.
    pub gears: [GearRating; 2],
}

impl MeshRating {
    /// The factors of the whole mesh and those of one gear, in the order of the calculation; of a flank or
    /// root that is not rated none.
    pub fn chain(&self, side: Side) -> impl Iterator<Item = Factor> + '_ {
        let load = &self.load_factors;
        let gear = &self.gears[side as usize];
        let contact =
            gear.contact.iter().flat_map(|flank| iter::once(flank.single_contact).chain(flank.limit_factors));
        let root =
            gear.root.iter().flat_map(|root| root.stress_factors.into_iter().chain(root.limit_factors));
        [load.application, load.sharing, load.dynamic, load.face_contact, load.transverse_contact]
            .into_iter()
            .chain(self.contact_factors)
            .chain(contact)
            .chain([load.face_root, load.transverse_root])
            .chain(root)
    }
}

/// Safety that governs a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Governing {
    /// The gear.
    pub side: Side,
    /// Flank or root.
    pub place: Place,
    /// Safety calculated.
    pub safety: f64,
    /// The safety required of it.
    pub required: f64,
}

/// Place where a tooth fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "names", derive(serde::Serialize, schemars::JsonSchema))]
#[cfg_attr(feature = "names", serde(rename_all = "snake_case"), schemars(rename = "Place"))]
pub enum Place {
    /// The flank, by pitting.
    Flank,
    /// The root, by bending.
    Root,
}

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(match self {
            Self::Flank => "flank",
            Self::Root => "root",
        })
    }
}

impl Governing {
    /// Whether the safety is enough, and with it all others of the mesh.
    #[must_use]
    pub fn is_enough(&self) -> bool {
        self.safety >= self.required
    }
}

impl MeshRating {
    /// The safety that is least over what is required of it, of those that could be rated; of equal ones the
    /// first gear's, and the flank's. `None` where nothing could be rated.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a required safety.
    pub fn governing(&self, required_contact: f64, required_root: f64) -> Result<Option<Governing>, Error> {
        let contact = positive(Quantity::RequiredSafety, required_contact, "")?;
        let root = positive(Quantity::RequiredSafety, required_root, "")?;
        let of = |side: Side| {
            let gear = &self.gears[side as usize];
            let flank = gear.contact.iter().map(move |rated| Governing {
                side,
                place: Place::Flank,
                safety: rated.safety,
                required: contact,
            });
            let root = gear.root.iter().map(move |rated| Governing {
                side,
                place: Place::Root,
                safety: rated.safety,
                required: root,
            });
            flank.chain(root)
        };
        let over = |governing: &Governing| governing.safety / governing.required;
        let all = Side::BOTH.into_iter().flat_map(of);
        Ok(all.reduce(|least, one| if over(&one) < over(&least) { one } else { least }))
    }
}

/// The strength of a mesh under a load.
///
/// A flank or root that the standard does not hold for, or that lacks a factor, keeps its [`Error`] in the
/// rating; the others are rated.
///
/// # Errors
/// [`Error::NotPositive`] and the like for an invalid quantity; [`Error::OutOfRange`] for a mesh outside the
/// range of the standard. [`Error::MissingFactor`] for a factor of the mesh that is neither given nor can be
/// calculated, [`Error::GivenFactor`] for a given one that is not a number above 0.
///
/// # Example
/// See `examples/spur_pair.rs`, and `spec-cases/wind-gearbox` for the stage of a wind gearbox.
pub fn rate(mesh: &Mesh, load: &Load, method: &Method) -> Result<MeshRating, Error> {
    let prepared = Prepared::new(mesh, method)?;
    let torque = positive(Quantity::Torque, load.torque.si(), "N·m")?;
    let speed_rpm = positive(Quantity::Speed, load.speed.rpm(), "rpm")?;
    let hours = positive(Quantity::Life, load.life.hours(), "h")?;
    let force = prepared.force(torque);
    let load_factors = prepared.load_factors(force, speed_rpm, method.given, method.dynamics.as_ref())?;
    let speed = prepared.speed(speed_rpm);
    let nominal_contact = prepared.nominal_contact(force);
    let contact = |side: Side, cycles: f64| -> Result<ContactRating, Error> {
        let limit = prepared.flank_limit(side, speed)?;
        let flank = limit.flank;
        let at = limit.at(cycles, &method.given, side)?;
        let stress = prepared.contact_stress(flank, force, &load_factors);
        Ok(ContactRating {
            single_contact: flank.single_contact,
            stress: Pressure::from_mpa(stress),
            limit_factors: [
                at.life,
                limit.lubricant,
                limit.velocity,
                limit.roughness,
                limit.work_hardening,
                flank.size,
            ],
            limit: Pressure::from_mpa(at.stress),
            safety: at.stress / stress,
        })
    };
    let root = |side: Side, cycles: f64| -> Result<RootRating, Error> {
        let root = prepared.gears[side as usize].root.as_ref().map_err(Clone::clone)?;
        let at = root.limit_at(cycles, &method.given, side)?;
        let stress = prepared.root_stress(root, force, &load_factors);
        Ok(RootRating {
            section: root.section,
            stress_factors: root.stress,
            nominal: Pressure::from_mpa(prepared.nominal_root(root, force)),
            stress: Pressure::from_mpa(stress),
            limit_factors: [root.test_gear, at.life, root.notch, root.surface, root.size, root.mean_stress],
            limit: Pressure::from_mpa(at.stress),
            safety: at.stress / stress,
        })
    };
    // A flank or root that cannot be rated must not hide the results of the others, so its error is kept.
    let gear = |side: Side| -> Result<GearRating, Error> {
        let cycles = prepared.cycles(side, speed_rpm, hours, load.contacts)?;
        Ok(GearRating {
            cycles,
            contact: part_of(contact(side, cycles))?,
            root: part_of(root(side, cycles))?,
        })
    };
    Ok(MeshRating {
        edition: method.edition,
        tangential_force: Force::from_si(force),
        speed: Velocity::from_si(speed),
        load_factors,
        contact_factors: prepared.contact_factors,
        nominal_contact: Pressure::from_mpa(nominal_contact),
        gears: [gear(Side::First)?, gear(Side::Second)?],
    })
}

/// Safeties of a gear against the greatest torque of its life.
#[derive(Debug, Clone, PartialEq)]
pub struct Overload {
    /// `S_H` for static strength, or why it cannot be calculated.
    pub contact: Result<f64, Error>,
    /// `S_F` for static strength, or why it cannot be calculated.
    pub root: Result<f64, Error>,
}

/// Safeties of a mesh against an overload.
#[derive(Debug, Clone, PartialEq)]
pub struct OverloadRating {
    /// Edition of the standard.
    pub edition: Edition,
    /// Safeties of both gears.
    pub gears: [Overload; 2],
}

/// Safeties of both gears against the greatest torque of their life, static: `K_A` and `K_v` are 1, since the
/// torque contains them. Given `Z_NT` and `Y_NT` are of the duty's cycles and not used here.
///
/// # Errors
/// Those of [`rate`]. [`Error::MissingFactor`] for `Y_δrelT,stat` of a class whose formula is not known stays
/// in the rating.
pub fn overload(mesh: &Mesh, torque: Torque, method: &Method) -> Result<OverloadRating, Error> {
    let prepared = Prepared::new(mesh, method)?;
    let force = prepared.force(positive(Quantity::Torque, torque.si(), "N·m")?);
    // The greatest torque contains overload and dynamic load; `K_A` and `K_v` would count them twice.
    let given = method.given.with(Symbol::Application, 1.0).with(Symbol::Dynamic, 1.0);
    let factors = prepared.load_factors(force, 0.0, given, method.dynamics.as_ref())?;
    let gears = prepared.gears.each_ref().map(|own| Overload {
        contact: own
            .contact
            .as_ref()
            .map_err(Clone::clone)
            .map(|flank| flank.static_limit() / prepared.contact_stress(flank, force, &factors)),
        root: own
            .root
            .as_ref()
            .map_err(Clone::clone)
            .and_then(|root| Ok(root.static_limit()? / prepared.root_stress(root, force, &factors))),
    });
    Ok(OverloadRating { edition: method.edition, gears })
}
