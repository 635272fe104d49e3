//! The solver of planetary gearboxes: planet sets tied by links and shift elements.
//!
//! # Contents
//!
//! | module | answers |
//! |---|---|
//! | [`gearbox`], [`builder`] | what a gearbox is, and whether a description is one |
//! | [`planet_set`] | a set with its gears and meshes, whatever its form |
//! | [`set`], [`compound`] | descriptions of sets: in short by kind, or gear by gear |
//! | [`state`] | what a gear does: driven, blocked, free… from rank |
//! | [`analysis`] | everything about one gear |
//! | [`speeds`] | links, planets, slip of open shift elements |
//! | [`torques`] | members, shift elements and terminals, with and without losses |
//! | [`power_flow`] | power through sets, meshes and links, circulating power |
//! | [`one_way`] | whether one-way clutches hold or overrun, on drive and on coast |
//! | [`inputs`] | gears with several inputs |
//! | [`formula`] | the ratio as a formula in the basic ratios, and the way to it |
//! | [`kreines`] | efficiency from the ratio alone, as a check |
//! | [`efficiency`] | self-consistent sign patterns |
//! | [`operating`] | the same as quantities at a speed and load |
//! | [`drag`] | losses that do not depend on the load, beside those of the meshes |
//! | [`planet_bearings`] | forces on the bearings of the planets |
//! | [`tooth_checks`] | centre distances, clearance, assembly and undercut of the sets |
//! | [`combinations`] | every set of shift elements |
//! | [`solution`] | what solving a gear finds |
//! | [`compiled`] | a gear compiled once, solved often |
//! | [`sweep`] | states, ratios and efficiencies for many basic ratios |
//! | [`tolerance`] | what counts as nothing, and how much is solved |
//! | [`mobility`] | Chebyshev's count |
//! | [`groups`], [`names`] | links that turn as one, names that may be mistyped |
//! | [`drawn`] | sets as drawings take them |
//!
//! Speeds and torques follow the [sign convention](epicyclic_gears#sign-convention) of the workspace. Losses
//! are those of the meshes; those of bearings, churning, seals and open shift elements are given curves
//! ([`drag`]).
//!
//! # Example
//!
//! ```
//! use epicyclic_train::{Gearbox, set::{MeshLoss, SetSpec}};
//! use epicyclic_gears::efficiency::MeshEfficiency;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! // Scheme II-3: set 1 alone in the first gear, both sets in the second.
//! let loss = MeshLoss::Set(MeshEfficiency::new(0.97)?);
//! let gearbox = Gearbox::builder("II-3")
//!     .links(["D", "B", "T1", "T2"])
//!     .set(SetSpec::simple("1", ["T1", "D", "B"], 2.15).with_loss(loss))
//!     .set(SetSpec::simple("2", ["T1", "B", "T2"], 2.354).with_loss(loss))
//!     .brake("K1", "T1")
//!     .brake("K2", "T2")
//!     .clutch("direct", "D", "B")
//!     .input("D")
//!     .output("B")
//!     .gear("1", ["K1"])
//!     .gear("2", ["K2"])
//!     .gear("3", ["direct"])
//!     .build()?;
//! let second = gearbox.analyze("2")?;
//! assert!((second.ratio().unwrap() - 2.56).abs() < 1e-3);
//! assert!((second.efficiency().unwrap() - 0.969).abs() < 1e-3);
//! # Ok(())
//! # }
//! ```

pub mod analysis;
pub mod axial_forces;
mod branch;
pub mod builder;
pub mod combinations;
pub mod compiled;
pub mod compound;
mod compound_fault;
pub mod drag;
mod drag_fault;
pub mod drawn;
mod drawn_set;
pub mod efficiency;
mod elimination;
pub mod error;
pub mod formula;
pub mod gearbox;
pub mod groups;
pub mod in_mesh;
pub mod inputs;
mod kernel;
pub mod kreines;
mod link;
pub mod mesh_loads;
pub mod mobility;
pub mod names;
mod network;
pub mod one_way;
pub mod operating;
mod operating_fault;
pub mod planet_angles;
pub mod planet_bearings;
mod planet_places;
pub mod planet_set;
pub mod power_flow;
pub mod set;
mod set_fault;
mod set_kind;
pub mod site;
pub mod solution;
pub mod spacing;
pub mod speeds;
pub mod state;
mod step_couple;
pub mod sweep;
pub mod tolerance;
pub mod tooth_checks;
mod tooth_shape;
pub mod toothed;
mod topology;
pub mod torques;

pub use analysis::Analysis;
pub use builder::{GearSpec, GearboxBuilder};
pub use compiled::{CompiledGear, Values};
pub use error::{
    CompoundFault, DragFault, Error, InputsFault, LinkFault, MeshFault, Named, OperatingFault, Place,
    SetValue, SpacingFault, Terminal, Warning,
};
pub use gearbox::{Gear, Gearbox, ShiftElement};
pub use link::{GROUND, LinkId};
pub use operating::{InputLoad, Operation};
pub use planet_set::PlanetSet;
pub use site::{GearPart, Located, SetPart, Site};
pub use solution::{Direction, Solution};
pub use state::State;
pub use torques::LoadCase;
