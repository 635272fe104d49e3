//! Synthesis of planetary gearboxes: from a list of ratios to every gearbox that has them.
//!
//! # Contents
//!
//! | module | answers |
//! |---|---|
//! | [`class`], [`structure`] | which structures are searched, and when two are equal |
//! | [`enumerate`], [`count`] | all of a class, each once, and how many by other ways |
//! | [`ternary`], [`exterior`], [`motion`] | the speeds of every gear of a structure as polynomials |
//! | [`ratio`] | ratios as formulas, factored |
//! | [`parts`] | parts of the range of the ring-to-sun ratios in which a ratio is possible |
//! | [`wish`] | requirements, and whether any gearbox of a class can fulfil them |
//! | [`search`], [`solve`] | all sets of shift elements of a structure with the wanted gears |
//! | [`equal`] | sets with equal `k` |
//! | [`rules`], [`shifts`] | further rules: brakes and clutches, single shifts, a direct gear |
//! | [`run`], [`work`] | a search through a class or a share, on several threads, with breaks |
//! | [`estimate`] | how long a search will take, from a sample |
//! | [`tally`], [`asked`] | the counts and the request of a search, as text, exactly |
//! | [`refine`], [`judge`] | the best ring-to-sun ratios of a solution, their ranges, shifts, efficiency |
//! | [`limits`] | limits of steps, slips and speeds for a solution |
//! | [`family`] | which solutions have equal functions |
//! | [`rank`] | ratings of a solution by the solver, the Pareto front and the best by an order |
//! | [`usable`] | limits of a usable gearbox, by which a search goes on to larger classes |
//! | [`teeth`] | all tooth numbers that keep the tolerances of a solution |
//! | [`sharing`] | sets that share planets, as the compound set that they are |
//! | [`gearbox`] | a solution as a gearbox of the solver |
//!
//! # What complete means
//! The search covers every structure of the class, at real ring-to-sun ratios within their range. It finds
//! every set of shift elements with which each wanted ratio is within its bounds. Sets in which some `k`
//! moves no wanted ratio are *reducible*: counted, not listed. Shift elements that lock the same are one. Of
//! solutions that an automorphism of the structure makes equal, one is listed. Bounds are widened by 10⁻⁹, so
//! that rounding loses nothing. A set that is neither found nor excluded is *undecided* and counted.
//!
//! # Source
//! multispeed-gearboxes tries a list of schemes of two sets; its 111 structures are class core of two sets
//! and four links.

pub mod asked;
mod choices;
pub mod class;
pub mod count;
pub mod enumerate;
pub mod equal;
mod error;
pub mod estimate;
pub mod exterior;
pub mod family;
pub mod gearbox;
pub mod judge;
mod kind;
mod library;
pub mod limits;
mod linear;
pub mod motion;
mod names;
pub mod parts;
mod permutation;
pub mod rank;
pub mod ratio;
pub mod refine;
mod region;
pub mod rules;
pub mod run;
pub mod search;
mod set_teeth;
pub mod sharing;
pub mod shifts;
pub mod solve;
pub mod structure;
mod table;
pub mod tally;
pub mod teeth;
pub mod ternary;
mod tolerance;
pub mod usable;
mod watch;
pub mod wish;
pub mod work;

pub use class::Class;
pub use error::Error;
pub use kind::Kind;
pub use structure::Structure;
