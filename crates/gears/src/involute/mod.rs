//! Cylindrical gears with profile shift: circles, tooth thickness, the mesh of a pair, measures,
//! interference.
//!
//! Names and signs are those of ISO 21771. All lengths are in normal modules `m_n`; multiply by the module
//! for millimetres. Diameters and centre distances are given as positive numbers, also for internal gears. In
//! formulas the teeth `z` of an internal gear, its diameters, and the centre distance of its mesh are
//! negative.
//!
//! ```text
//! tan α_t = tan α_n/cos β                d = z/cos β                     d_b = d·cos α_t
//! d_a = d + 2·(h_aP* + x + k)            d_f = d − 2·(h_fP* − x)        by a hob
//! inv α_wt = inv α_t + 2·tan α_n·(x_1 + x_2)/(z_1 + z_2)                 inv α = tan α − α
//! a = a_d·cos α_t/cos α_wt               a_d = (z_1 + z_2)/(2·cos β)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `z` | teeth, negative of an internal gear | 1 |
//! | `α_n`, `α_t`, `α_wt` | pressure angle: normal, transverse, working transverse | rad |
//! | `β`, `β_b` | helix angle at the reference and at the base cylinder | rad |
//! | `x` | profile shift coefficient; above 0 it moves the tips outwards, of a ring inwards | modules |
//! | `k` | tip alteration; below 0 it shortens the tooth | modules |
//! | `h_aP*`, `c_P*`, `ρ_fP*` | [`Profile`] | modules |
//! | `d`, `d_b`, `d_a`, `d_f`, `d_w` | diameters: reference, base, tip, root, working | modules |
//! | `a`, `a_d` | centre distance: of the mesh, and of the reference circles | modules |
//!
//! Root circles, fillets and the ends of involutes are those that the [`tool`] of each gear leaves. Left out:
//! deviations, tip chamfers, deflection.
//!
//! | file | answers |
//! |---|---|
//! | [`function`] | the involute function and its inverse |
//! | [`gear`] | one gear: circles, thickness, undercut, span and ball measures |
//! | [`pair`] | two gears in mesh: working angle, centre distance, contact ratio, sliding, backlash |
//! | [`profile`] | basic rack, helix and tool of a gear |
//! | [`tool`] | hob, shaper, form tool: what cuts a gear |
//! | [`fault`] | why a shift gives no gear, and why a tool cuts none |
//! | [`check`] | what is checked of a set: rule, value, limit, severity, remedy |
//! | [`checks`] | the checks of a gear and of a mesh, and their limits |
//! | [`left_out`] | how many sets of a ratio a check leaves out |
//! | [`interference`] | whether an internal pair turns, and can be put together |
//! | [`set`] | sun, planets and ring on one centre distance, and all that keeps them from running |
//! | [`shifts`] | shifts that follow from stated centre distances |
//! | [`family`] | all shifts of a set at a centre distance, and the one that an aim picks |
//! | [`tree`] | shifts of gears of any tree of meshes at their centre distances, and the choice by an aim |
//! | [`closing`] | which tooth numbers near `z_r = z_s + 2·z_p` make a set |
//! | [`search`] | every such set for a ratio |
//! | [`plain`] | which tooth numbers without profile shift cannot be cut or turned together |
//! | [`curve`] | the exact outline of a tooth: involute and the fillet by a hob or a shaper |
//! | [`outline`] | the same as polylines, of a tooth and of a whole gear |
//! | [`contour`] | the outline of a gear as arcs and cubic curves |
//! | [`sliding`] | losses of a mesh by friction |
//! | [`play`] | backlash of a mesh by tooth-thickness allowances |
//!
//! # Source
//! ISO 21771:2007 for names and signs; formulas derived from the involute. Tested against the gears of the
//! NREL reference wind gearbox (Nejad, Guo, Gao, Moan 2016) and the tables of SDP/SI D785.

pub mod check;
pub mod checks;
pub mod closing;
pub mod contour;
pub mod curve;
mod cut;
pub mod family;
pub mod fault;
mod fillet;
mod flank;
pub mod function;
pub mod gear;
pub mod interference;
pub mod left_out;
pub mod outline;
pub mod pair;
pub mod plain;
pub mod play;
pub mod practice;
pub mod profile;
#[cfg(test)]
mod published;
pub mod search;
pub mod set;
pub mod shifts;
pub mod sliding;
mod tips;
pub mod tool;
pub mod tree;

pub use gear::InvoluteGear;
pub use pair::Pair;
pub use profile::Profile;
pub use set::PlanetSet;
