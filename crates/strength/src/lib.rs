//! Strength of cylindrical gears by ISO 6336, load spectra, modified bearing life, losses of a mesh.
//!
//! # Contents
//!
//! | module | answers |
//! |---|---|
//! | [`rating`] | stresses, limits and safeties of a mesh under one load, and against an overload |
//! | [`mesh`] | a mesh, its load, how to calculate |
//! | [`planets`] | the loads of both meshes of a simple set |
//! | [`spectrum`] | damage, safety and life over a duty, by Miner's rule |
//! | [`factor`] | a factor with its symbol and where its value comes from; factors given |
//! | [`load`] | `K_γ`, `K_v`, `K_Fβ`, `K_Hα`, `K_Fα` |
//! | [`contact`] | factors of contact stress and its limit |
//! | [`root`] | the critical section of a root, factors of root stress and its limit |
//! | [`life`] | stress limits over the number of cycles |
//! | [`material`] | classes of materials, a small table |
//! | [`bearing`] | modified rating life by ISO 281 |
//! | [`bearing_rows`] | both rows of a planet's bearings under a tilting moment |
//! | [`plain_bearing`] | oil film of a planet's plain bearing |
//! | [`loss`] | loss of a mesh by sliding |
//! | [`masses`] | masses of flanges, brakes and clutches by rules |
//! | [`sizing`] | module, face width, planets, centre distance and bearing of a set that holds over a duty |
//! | [`series`] | the lightest stages in series for one ratio |
//! | [`arranged`] | an order of sets with planets of two gears, before they are sized |
//!
//! Method B, external and internal gears, spur and helical. Editions are named in every answer
//! ([`factor::Edition`]). Each factor names the clause or formula that it follows, or that it was given.
//! `K_A`, `K_Hβ` and material limits are given. A factor whose formula was not available is given too.
//! Without it the crate returns an error: no other value is put in its place.
//!
//! Geometry comes from [`epicyclic_gears::involute`]. Left out: scuffing, micropitting, flank fracture,
//! contact under load (`K_Hβ` from deformations), bevel gears, grinding notches.
//!
//! # Example
//!
//! See `examples/spur_pair.rs`.

pub mod arranged;
pub mod bearing;
pub mod bearing_rows;
mod bounded;
mod checks;
pub mod contact;
pub mod error;
pub mod factor;
pub mod life;
pub mod lightest;
pub mod load;
pub mod loss;
pub mod masses;
pub mod material;
pub mod mesh;
pub mod plain_bearing;
pub mod planets;
mod prepared;
pub mod rating;
pub mod root;
pub mod series;
pub mod sizing;
pub mod spectrum;
mod symbol;
mod tolerance;

pub use error::{Error, Quantity};
