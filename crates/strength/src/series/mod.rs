//! Stages in series: the lightest train of simple sets for one ratio, with tooth numbers and sizes chosen
//! together.
//!
//! Each stage is a set whose ring is held, whose sun is driven and whose carrier drives the next sun:
//!
//! ```text
//! i_j = 1 + z_r/z_s        i = Π i_j        T_j = T·i_1·…·i_(j−1)        n_j = n/(i_1·…·i_(j−1))
//! ```
//!
//! `T`, `n` are torque and speed of the input; torques are without losses.
//!
//! If the rings turn with the output ([`Order::rings_turn`]), as the housings of travel and wheel drives do, the
//! last carrier is held and the output turns against the input. Seen from the rings, everything turns as with
//! held rings, so torques are the same and speeds relative to a carrier grow:
//!
//! ```text
//! i = 1 − Π i_j        n_j = n·(1 + 1/|i|)/(i_1·…·i_(j−1))
//! ```
//!
//! A pair of gears on fixed axes may be the first stage ([`Order::first_pair`]), where the fast shaft is parallel
//! to the slow one. The input drives its first gear:
//!
//! ```text
//! i_1 = z_2/z_1        by amount: the pair turns the direction around
//! ```
//!
//! # Space
//! Every train of [`Order::stages`] sets whose teeth lie within [`Teeth`] and whose ratio lies within
//! [`Order::ratio`]; each set with every module, face width, number of planets, centre distance and bearing of
//! the [sizing](crate::sizing).
//!
//! # Objective
//! First the number of stages with warnings by usual practice, then the mass, a quarter more for each warning:
//! of the gears, or by [`Objective::Whole`](crate::sizing::Objective::Whole) of gears, carriers and housing.
//! Both are sums over the stages. Between numbers of stages [`STAGE_PRICE`] counts too.
//!
//! # Lengths
//! A price of the length ([`Space::length_price`](crate::sizing::Space::length_price), λ in kg/m) counts beside the
//! mass: a sum over the stages as well, so the search stays exact. The best train at a price, of length `L`, is
//! the best of all that are no longer, and bounds the price `P` of every train within another length:
//!
//! ```text
//! P ≥ min(P + λ·L) − λ·L_max        for every train with L ≤ L_max and as many stages beyond usual practice
//! ```
//!
//! # How the best train is found
//! Each set is tried at every centre distance. Its flanks there give the volume of teeth that a torque needs, its
//! planets the bearings that fit: together a bound below the mass of a stage, whatever its module and its speed
//! within a band. All trains are put in the order of the sums of these bounds. The first train gets one of its stages sized, first for the
//! least load of a range, then for its own, and goes back into the queue with the mass in place of the bound.
//! A train that comes first with all stages sized is the best: no other has a lower bound.
//!
//! A part of the bound is no proof, such as a little room for teeth that more planets make otherwise: every train
//! of small spaces is sized in the tests, and the best is the same.

mod search;
mod stage;

use crate::sizing::{STEEL, SetTeeth, Sizing};
use epicyclic_units::Physical;
pub use search::{KnownSets, search};
use std::f64::consts::{FRAC_PI_4, PI};
use std::ops::RangeInclusive;
use uom::si::f64::{AngularVelocity, Mass, Torque};

/// Factor of a train's price for each of its stages, by this program: what a stage fewer may cost. One more
/// has to be made, with its bearings, and makes the gearbox longer.
pub const STAGE_PRICE: f64 = 1.15;

/// Torsional stress of a slow shaft in N/m², under the torque of the duty and under the greatest one.
const TORSION: [f64; 2] = [40e6, 80e6];

/// Length of a slow shaft in its diameters: two between its bearings, the others for seals, the carrier and
/// what is driven.
const SHAFT_LENGTH: f64 = 5.0;

/// Mass of bearings and seals over that of their shaft.
const SHAFT_BEARINGS: f64 = 0.5;

/// Mass of the slow shaft with its bearings and seals, by the torque of the duty and the factor of the
/// greatest one over it.
///
/// ```text
/// d³ = 16/π·max(T/40 MPa, f·T/80 MPa)        M = 1.5·ρ·π/4·d²·5·d
/// ```
///
/// The shaft is solid and of steel; its bearings and seals weigh half as much again.
#[must_use]
pub fn slow_shaft(torque: Torque, overload: Option<f64>) -> Mass {
    let [usual, most] = TORSION;
    let cube = 16.0 / PI * torque.si() * (1.0 / usual).max(overload.unwrap_or(1.0) / most);
    Mass::from_si((1.0 + SHAFT_BEARINGS) * STEEL * FRAC_PI_4 * SHAFT_LENGTH * cube)
}

/// Tooth numbers of the sets to choose from.
#[derive(Debug, Clone, PartialEq)]
pub struct Teeth {
    /// Teeth of the suns.
    pub suns: RangeInclusive<u32>,
    /// Teeth of the planets.
    pub planets: RangeInclusive<u32>,
    /// Teeth of the rings.
    pub rings: RangeInclusive<u32>,
    /// Teeth of a ring less those of its sun and twice those of a planet.
    pub ring_offsets: RangeInclusive<i32>,
    /// Ring over sun.
    pub ring_to_sun_ratio: RangeInclusive<f64>,
    /// Whether gears in mesh have no common divisor.
    pub is_hunting: bool,
}

/// A step of the duty at the input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InputStep {
    /// Share of the time.
    pub share: f64,
    /// Torque on the input.
    pub torque: Torque,
    /// Speed of the input.
    pub speed: AngularVelocity,
}

/// Order for trains.
#[derive(Debug, Clone, PartialEq)]
pub struct Order {
    /// Numbers of stages.
    pub stages: RangeInclusive<usize>,
    /// Products of the stages' ratios that are allowed: speed of the input over that of the output, both
    /// relative to the rings.
    pub ratio: RangeInclusive<f64>,
    /// Whether the rings turn with the output and the last carrier is held, in place of the rings.
    pub rings_turn: bool,
    /// A pair as the first stage, in place of a set; `None` for trains of sets alone. Behind a pair the rings are
    /// held.
    pub first_pair: Option<FirstPair>,
    /// Tooth numbers.
    pub teeth: Teeth,
    /// Stages beyond usual practice at most; `None` for any number.
    pub most_unusual: Option<u32>,
    /// The duty.
    pub duty: Vec<InputStep>,
    /// A set with materials, factors, requirements and space. Its teeth, duty and overloads are not used;
    /// its overloads are those of the input.
    pub of_stage: Sizing,
}

/// Pairs of external gears on fixed axes to choose the first stage from.
#[derive(Debug, Clone, PartialEq)]
pub struct FirstPair {
    /// Teeth of the smaller gear, which is on the input.
    pub pinions: RangeInclusive<u32>,
    /// Teeth of the larger gear.
    pub wheels: RangeInclusive<u32>,
    /// Larger over smaller gear.
    pub ratio: RangeInclusive<f64>,
    /// A pair with materials, factors, requirements and space, as [`Order::of_stage`].
    pub of_pair: Sizing,
}

/// A train with its stages.
#[derive(Debug, Clone, PartialEq)]
pub struct Train {
    /// Teeth of sun, planets and ring of each stage, from the input on.
    pub stages: Vec<SetTeeth>,
    /// Product of the stages' ratios: speed of the input over that of the output, both relative to the rings.
    pub ratio: f64,
    /// Stages beyond usual practice.
    pub unusual_stages: u32,
    /// Rules of usual practice that the stages miss.
    pub rules_missed: u32,
    /// Mass in kg that the objective counts: of the gears, or of the whole.
    pub mass_kg: f64,
    /// Mass with a quarter more for each rule missed, in kg.
    pub price_kg: f64,
    /// Length of the stages along the axis, in m.
    pub length_m: f64,
}

/// Result of a search for trains.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// Sets within the bounds of tooth numbers whose teeth have room for one another.
    pub sets: usize,
    /// The trains of each number of stages.
    pub all: Vec<Trains>,
}

/// Trains of one number of stages.
#[derive(Debug, Clone, PartialEq)]
pub struct Trains {
    /// Number of stages.
    pub stages: usize,
    /// Trains within the allowed ratios.
    pub trains: u64,
    /// Stages that were sized.
    pub sized: u64,
    /// Whether no other train can be better; false if the search ended early for its length.
    pub is_complete: bool,
    /// The best, in order.
    pub found: Vec<Train>,
}
