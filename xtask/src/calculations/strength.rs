//! Calculations of the strength of teeth by ISO 6336, and of mesh losses.

use super::involute::PairGiven;
use super::{Calculation, Refusal, Results};
use epicyclic_formats::gearbox::{MaterialClass, MaterialEntry};
use epicyclic_gears::ToothCount;
use epicyclic_gears::involute::sliding::loss_factor;
use epicyclic_strength::Error;
use epicyclic_strength::factor::{Factor, Given, Side, Symbol};
use epicyclic_strength::load::{Arrangement, Dynamics};
use epicyclic_strength::loss::{ohlendorf_loss_factor, power_loss};
use epicyclic_strength::material::{self, Class, Material};
use epicyclic_strength::mesh::{Gear, Load, Mesh, Method};
use epicyclic_strength::planets::loads;
use epicyclic_strength::rating::{GearRating, rate};
use epicyclic_strength::root::factors::Bending;
use epicyclic_strength::root::section::Shaper;
use epicyclic_strength::spectrum::{Step, rate_duty};
use epicyclic_units::{Number, Physical, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use uom::si::f64::{Angle, AngularVelocity, KinematicViscosity, Length, Power, Ratio, Time, Torque};

pub(super) fn calculations() -> Vec<Calculation> {
    vec![
        Calculation::new(
            "strength.planet_loads",
            "torque, speed and contacts a revolution of both meshes of a planetary set",
            planet_loads,
        ),
        Calculation::new(
            "strength.mesh",
            "factors, stresses, limits and safeties of a mesh by ISO 6336",
            mesh_rating,
        ),
        Calculation::new("strength.duty", "damage, safety and life of a mesh over a load spectrum", duty),
        Calculation::new("strength.mesh_loss", "loss factor and power loss of a mesh by friction", mesh_loss),
    ]
}

/// A planetary set with the torque on its sun.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct PlanetLoadsGiven {
    /// Teeth of the sun.
    sun: u32,
    /// Teeth of a planet.
    planet: u32,
    /// Teeth of the ring, where the torques of ring and carrier are wanted.
    #[serde(default)]
    ring: Option<u32>,
    /// Number of planets.
    planets: u32,
    /// Torque on the sun.
    torque: Quantity<Torque>,
    /// Speed of the sun relative to the carrier.
    speed: Quantity<AngularVelocity>,
    /// Time of running.
    life: Quantity<Time>,
}

fn planet_loads(given: &PlanetLoadsGiven) -> Result<Results, Refusal> {
    let teeth = [ToothCount::new(given.sun)?, ToothCount::new(given.planet)?];
    let meshes = loads(given.torque.0, given.speed.0, given.planets, teeth, given.life.0)?;
    let mut results = Results::default();
    for (name, load) in ["sun_mesh", "ring_mesh"].into_iter().zip(meshes) {
        results
            .quantity(format!("{name}.torque"), load.torque)
            .quantity(format!("{name}.speed"), load.speed)
            .number(format!("{name}.contacts.first"), load.contacts[0])
            .number(format!("{name}.contacts.second"), load.contacts[1]);
    }
    if let Some(ring) = given.ring {
        let teeth_of_ring = ToothCount::new(ring)?.as_f64() / teeth[1].as_f64();
        let on_ring = meshes[1].torque * f64::from(given.planets) * teeth_of_ring;
        results
            .quantity("ring.torque", on_ring)
            .quantity("carrier.torque", on_ring + meshes[0].torque * f64::from(given.planets));
    }
    Ok(results)
}

/// How the teeth of a gear are bent.
#[derive(Debug, Clone, Copy, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum BendingGiven {
    /// To one side.
    #[default]
    OneWay,
    /// To both sides alike in each revolution, as those of a planet.
    Reversed,
}

/// A shaper.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct CutterGiven {
    /// Number of teeth.
    teeth: u32,
    /// Profile shift coefficient. Default 0.
    #[serde(default)]
    shift: Option<Number>,
}

/// Material, surface and loading of a gear, beyond its teeth.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RatedGiven {
    /// Material: a designation of the table, or a name of `materials`.
    material: String,
    /// Roughness `R_z` of the flanks.
    flank_roughness: Quantity<Length>,
    /// Roughness `R_z` of the roots.
    root_roughness: Quantity<Length>,
    /// Thickness of the rim under the teeth. Default: a solid gear.
    #[serde(default)]
    rim: Option<Quantity<Length>>,
    /// The shaper that cuts a ring.
    #[serde(default)]
    shaper: Option<CutterGiven>,
    /// How the teeth are bent. Default `one_way`.
    #[serde(default)]
    bending: BendingGiven,
    /// Factors given for this gear by their symbols.
    #[serde(default)]
    factors: BTreeMap<String, Number>,
}

/// Masses that swing in a mesh.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum ArrangementGiven {
    /// Two gears.
    Pair,
    /// A sun with its planets.
    SunAndPlanets,
    /// A planet in its ring.
    PlanetInRing,
}

/// Deviations and masses of the teeth, for the dynamic factor by method B.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct DynamicsGiven {
    /// Masses that swing.
    arrangement: ArrangementGiven,
    /// Number of planets, of `sun_and_planets`.
    #[serde(default)]
    planets: Option<u32>,
    /// Base pitch deviations of both gears.
    pitch_deviations: [Quantity<Length>; 2],
    /// Profile form deviations of both gears.
    profile_deviations: [Quantity<Length>; 2],
    /// Inside diameter of the first gear's rim. Default: a solid gear.
    #[serde(default)]
    first_rim: Option<Quantity<Length>>,
    /// Inside diameter of the second gear's rim, of a ring its outside diameter. Default: a solid gear.
    #[serde(default)]
    second_rim: Option<Quantity<Length>>,
    /// Tip relief. Default none.
    #[serde(default)]
    tip_relief: Option<Quantity<Length>>,
    /// Gear blank factor. Default 1.
    #[serde(default)]
    blank_factor: Option<Number>,
}

/// A mesh and how it is calculated, without its load.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RatedMeshGiven {
    /// The gears in mesh.
    pair: PairGiven,
    /// Face width.
    face_width: Quantity<Length>,
    /// Material, surface and loading of both gears, beyond their teeth.
    gears: [RatedGiven; 2],
    /// Materials beside those of the table.
    #[serde(default)]
    materials: Vec<MaterialEntry>,
    /// Kinematic viscosity of the oil at 40 °C.
    viscosity: Quantity<KinematicViscosity>,
    /// Factors given for the mesh by their symbols, Greek letters as such or spelled: `K_A`, `K_gamma`,
    /// `K_v`, `K_H_beta`.
    #[serde(default)]
    factors: BTreeMap<String, Number>,
    /// Deviations and masses, where the dynamic factor is not given.
    #[serde(default)]
    dynamics: Option<DynamicsGiven>,
    /// Whether some pitting is allowed. Default false.
    #[serde(default)]
    pitting_allowed: bool,
}

fn class(given: MaterialClass) -> Class {
    match given {
        MaterialClass::Structural => Class::Structural,
        MaterialClass::ThroughHardened => Class::ThroughHardened,
        MaterialClass::GreyIron => Class::GreyIron,
        MaterialClass::NodularPearlitic => Class::NodularPearlitic,
        MaterialClass::NodularFerritic => Class::NodularFerritic,
        MaterialClass::Malleable => Class::Malleable,
        MaterialClass::CaseHardened => Class::CaseHardened,
        MaterialClass::SurfaceHardened => Class::SurfaceHardened,
        MaterialClass::Nitrided => Class::Nitrided,
        MaterialClass::ThroughHardenedNitrided => Class::ThroughHardenedNitrided,
        MaterialClass::Nitrocarburized => Class::Nitrocarburized,
    }
}

fn symbol(name: &str) -> Result<Symbol, Refusal> {
    Symbol::named(name).ok_or_else(|| {
        let all: Vec<String> = Symbol::ALL.iter().map(ToString::to_string).collect();
        let message = format!("{name} is no factor: there are {}", all.join(", "));
        Refusal { name: "unknown-factor".into(), message }
    })
}

impl RatedMeshGiven {
    fn material(&self, name: &str) -> Result<Material, Refusal> {
        if let Some(own) = self.materials.iter().find(|own| own.name == name) {
            let steel = Material::steel(class(own.class), own.contact_limit.0, own.root_limit.0);
            return Ok(Material {
                hardness: own.hardness.map(Number::get),
                strength: own.strength.map(|strength| strength.0),
                youngs_modulus: own.youngs_modulus.map_or(steel.youngs_modulus, |modulus| modulus.0),
                ..steel
            });
        }
        let listed = material::listed(name).ok_or_else(|| {
            let known: Vec<&str> = material::all().iter().map(|listed| listed.designation).collect();
            let message = format!(
                "no material is called {name}: give it in materials, or take one of {}",
                known.join(", ")
            );
            Refusal { name: "unknown-material".into(), message }
        })?;
        Ok(listed.material)
    }

    fn mesh(&self) -> Result<Mesh, Refusal> {
        let gear = |given: &RatedGiven| -> Result<Gear, Refusal> {
            Ok(Gear {
                rim: given.rim.map(|rim| rim.0),
                shaper: given.shaper.map(|shaper| Shaper {
                    teeth: shaper.teeth,
                    shift: shaper.shift.map_or(0.0, Number::get),
                }),
                bending: match given.bending {
                    BendingGiven::OneWay => Bending::OneWay,
                    BendingGiven::Reversed => Bending::Reversed,
                },
                ..Gear::solid(
                    self.material(&given.material)?,
                    given.flank_roughness.0,
                    given.root_roughness.0,
                )
            })
        };
        Ok(Mesh {
            pair: self.pair.pair()?,
            module: self.pair.module.0,
            face_width: self.face_width.0,
            gears: [gear(&self.gears[0])?, gear(&self.gears[1])?],
            viscosity: self.viscosity.0,
        })
    }

    fn method(&self) -> Result<Method, Refusal> {
        let mut given = Given::default();
        for (name, value) in &self.factors {
            given = given.with(symbol(name)?, value.get());
        }
        for (side, gear) in Side::BOTH.into_iter().zip(&self.gears) {
            for (name, value) in &gear.factors {
                given = given.with_of(side, symbol(name)?, value.get());
            }
        }
        let dynamics = self.dynamics.map(|dynamics| {
            let arrangement = match (dynamics.arrangement, dynamics.planets) {
                (ArrangementGiven::Pair, _) => Arrangement::Pair,
                (ArrangementGiven::PlanetInRing, _) => Arrangement::PlanetInRing,
                (ArrangementGiven::SunAndPlanets, Some(planets)) => Arrangement::SunAndPlanets(planets),
                (ArrangementGiven::SunAndPlanets, None) => {
                    let message = "sun_and_planets: give planets, how many there are".to_owned();
                    return Err(Refusal { name: "planets-missing".into(), message });
                }
            };
            Ok(Dynamics {
                arrangement,
                pitch_deviations: dynamics.pitch_deviations.map(|deviation| deviation.0),
                profile_deviations: dynamics.profile_deviations.map(|deviation| deviation.0),
                tip_relief: dynamics.tip_relief.map(|relief| relief.0),
                rims: [dynamics.first_rim, dynamics.second_rim].map(|rim| rim.map(|rim| rim.0)),
                blank_factor: dynamics.blank_factor.map_or(1.0, Number::get),
            })
        });
        let dynamics = dynamics.transpose()?;
        Ok(Method { given, dynamics, pitting_allowed: self.pitting_allowed, ..Method::default() })
    }
}

/// A mesh under one load.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct RatingGiven {
    /// The mesh.
    mesh: RatedMeshGiven,
    /// Torque that this mesh takes from the first gear.
    torque: Quantity<Torque>,
    /// Speed of the first gear, of a planetary set relative to the carrier.
    speed: Quantity<AngularVelocity>,
    /// Time of running.
    life: Quantity<Time>,
    /// How often a tooth of the first and of the second gear meets another in one revolution of its own.
    /// Default once.
    #[serde(default)]
    contacts: Option<[Number; 2]>,
}

fn mesh_rating(given: &RatingGiven) -> Result<Results, Refusal> {
    let load = Load {
        torque: given.torque.0,
        speed: given.speed.0,
        life: given.life.0,
        contacts: given.contacts.map_or([1.0; 2], |contacts| contacts.map(Number::get)),
    };
    let rating = rate(&given.mesh.mesh()?, &load, &given.mesh.method()?)?;
    let mut results = Results::default();
    results
        .text("edition", rating.edition)
        .quantity("tangential_force", rating.tangential_force)
        .quantity("pitch_line_speed", rating.speed)
        .quantity("nominal_contact_stress", rating.nominal_contact);
    for (side, (name, gear)) in Side::BOTH.into_iter().zip(["first", "second"].into_iter().zip(&rating.gears))
    {
        for factor in rating.chain(side) {
            if !factor.symbol.is_of_mesh() {
                results.number(format!("{name}.{}", plain(factor, side)), factor.value);
            } else if side == Side::First {
                results.number(plain(factor, side), factor.value);
            }
        }
        results.number(format!("{name}.cycles"), gear.cycles);
        stresses(&mut results, name, gear);
    }
    Ok(results)
}

/// The symbol of a factor of a gear: of `Z_B, Z_D` the one that is the gear's.
fn plain(factor: Factor, side: Side) -> String {
    match (factor.symbol, side) {
        (Symbol::SingleContact, Side::First) => "Z_B".to_owned(),
        (Symbol::SingleContact, Side::Second) => "Z_D".to_owned(),
        (symbol, _) => symbol.to_string(),
    }
}

fn stresses(results: &mut Results, name: &str, gear: &GearRating) {
    match &gear.contact {
        Ok(contact) => {
            results
                .quantity(format!("{name}.contact.stress"), contact.stress)
                .quantity(format!("{name}.contact.limit"), contact.limit)
                .number(format!("{name}.contact.safety"), contact.safety);
        }
        Err(why) => {
            results.text(format!("{name}.contact.fault"), why.name());
        }
    }
    match &gear.root {
        Ok(root) => {
            results
                .quantity(format!("{name}.root.nominal_stress"), root.nominal)
                .quantity(format!("{name}.root.stress"), root.stress)
                .quantity(format!("{name}.root.limit"), root.limit)
                .number(format!("{name}.root.safety"), root.safety);
            if let Some(section) = root.section {
                // In modules, as the standard has them.
                results
                    .number(format!("{name}.root.thickness"), section.thickness)
                    .number(format!("{name}.root.arm"), section.arm)
                    .number(format!("{name}.root.fillet"), section.fillet)
                    .quantity(format!("{name}.root.load_angle"), Angle::from_si(section.load_angle_rad));
            }
        }
        Err(why) => {
            results.text(format!("{name}.root.fault"), why.name());
        }
    }
}

/// A part of the time at one load.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct StepGiven {
    /// Share of the time; those of all steps sum to 1.
    share: Quantity<Ratio>,
    /// Torque that this mesh takes from the first gear.
    torque: Quantity<Torque>,
    /// Speed of the first gear, of a planetary set relative to the carrier.
    speed: Quantity<AngularVelocity>,
}

/// A mesh under a load spectrum.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct DutyGiven {
    /// The mesh.
    mesh: RatedMeshGiven,
    /// The spectrum.
    steps: Vec<StepGiven>,
    /// Time of running.
    life: Quantity<Time>,
    /// How often a tooth of the first and of the second gear meets another in one revolution of its own.
    /// Default once.
    #[serde(default)]
    contacts: Option<[Number; 2]>,
}

fn duty(given: &DutyGiven) -> Result<Results, Refusal> {
    let steps: Vec<Step> = given
        .steps
        .iter()
        .map(|step| Step { share: step.share.0.value, torque: step.torque.0, speed: step.speed.0 })
        .collect();
    let contacts = given.contacts.map_or([1.0; 2], |contacts| contacts.map(Number::get));
    let rating = rate_duty(&given.mesh.mesh()?, &steps, given.life.0, contacts, &given.mesh.method()?)?;
    let mut results = Results::default();
    for (name, gear) in ["first", "second"].into_iter().zip(rating.gears) {
        for (place, worn) in [("contact", gear.contact), ("root", gear.root)] {
            match worn {
                Ok(worn) => {
                    results
                        .number(format!("{name}.{place}.damage"), worn.damage)
                        .number(format!("{name}.{place}.safety"), worn.safety);
                    if let Some(life) = worn.life {
                        results.quantity(format!("{name}.{place}.life"), life);
                    }
                }
                Err(why) => {
                    results.text(format!("{name}.{place}.fault"), Error::name(&why));
                }
            }
        }
    }
    Ok(results)
}

/// A mesh, its friction and the power that rolls through it.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct MeshLossGiven {
    /// The gears in mesh.
    pair: PairGiven,
    /// Power of this mesh, of a planetary set by the speeds relative to the carrier.
    power: Quantity<Power>,
    /// Coefficient of friction.
    friction: Number,
}

fn mesh_loss(given: &MeshLossGiven) -> Result<Results, Refusal> {
    let pair = given.pair.pair()?;
    let loss = power_loss(&pair, given.power.0, given.friction.get())?;
    let integral = loss_factor(&pair)?;
    let mut results = Results::default();
    results
        .number("loss_factor", ohlendorf_loss_factor(&pair))
        .number("loss_factor_by_integral", integral)
        .number("closed_form_over_integral", ohlendorf_loss_factor(&pair) / integral)
        .quantity("loss", loss)
        .number("efficiency", 1.0 - ohlendorf_loss_factor(&pair) * given.friction.get());
    Ok(results)
}
