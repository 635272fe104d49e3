//! Motion of any planetary gearbox with friction elements, elastic shafts and exact events.
//!
//! # Contents
//!
//! | module | answers |
//! |---|---|
//! | [`Mechanism`] | links, planets, sets, further bodies, as matrices; mass matrix, equivalent inertia |
//! | [`Model`] | torques, shift elements, one-way and dog clutches, resistances, shafts, converters |
//! | [`Course`], [`TorqueLaw`] | torques over time and speed |
//! | [`Shaft`] | elastic, damped shafts with backlash |
//! | [`Converter`] | torque converters by their characteristic |
//! | [`Model::drag`], [`Model::shift_drag`] | drags by the curves of a gearbox file, sticking at rest |
//! | [`Start`] | speeds and twists at the start |
//! | [`Run`] | result of [`Model::run`]: samples, [events](Event), energies ([`Audit`]) |
//!
//! Speeds and torques are positive along the common axis; a torque acts on a link from outside
//! ([sign convention](epicyclic_gears#sign-convention)).
//!
//! # Method
//! ```text
//! M·q̈ = Q + Σ λ_stuck     ω = B·q̇     M = Bᵀ·J·B
//! ```
//!
//! Shift elements are dry friction without smoothing: between events the elements that hold and slip are
//! fixed, and the right side is smooth. These are events:
//! - the end of a slip, a torque above the capacity, a capacity that leaves 0;
//! - the release of a one-way clutch;
//! - a reversal of the power through a lossy mesh;
//! - a kink of a table or of a drag's curve;
//! - the begin and end of contact in a shaft with backlash.
//!
//! An event is located in the step. The elements that hold and slip afterwards are found by trying every
//! combination. Mesh losses follow the sign of the power through each mesh; if they leave the motion open, it
//! is refused. Dog clutches engage by plastic impacts.
//!
//! Mesh friction at rest is assumed to hold as long as no rolling follows from the torques. With large losses
//! both can be consistent, a block that turns and sets that roll in it; a motion that then changes between
//! them without end is refused as [accumulating](Error::Accumulating). The split of a torque between mesh
//! friction and stuck elements is open, as it is between stuck elements; which of several holds longest may
//! then depend on their order.
//!
//! Neglected:
//! - elasticity and backlash except those of the given [`Shaft`]s, so that torques jump with the capacities
//!   if no shaft is between;
//! - losses of meshes in an impact;
//! - friction and drags over temperature, friction over pressure;
//! - the oil's inertia in a converter.
//!
//! # Example
//! A power shift of one set: a one-way brake holds the ring until the clutch between sun and ring has taken
//! over.
//!
//! ```
//! use epicyclic_dynamics::gearbox::Masses;
//! use epicyclic_motion::{Course, Mechanism, Model, Start, State, TorqueLaw};
//! use epicyclic_train::{GROUND, Gearbox, set::SetSpec};
//! use uom::si::f64::{AngularVelocity, MomentOfInertia, Time, Torque};
//! use uom::si::angular_velocity::radian_per_second;
//! use uom::si::moment_of_inertia::kilogram_square_meter;
//! use uom::si::{time::second, torque::newton_meter};
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let (n_m, s) = (Torque::new::<newton_meter>, Time::new::<second>);
//! let kg_m2 = MomentOfInertia::new::<kilogram_square_meter>;
//! let gearbox = Gearbox::builder("two speeds")
//!     .links(["sun", "ring", "carrier"])
//!     .set(SetSpec::simple("set", ["sun", "ring", "carrier"], 2.0))
//!     .one_way_clutch("brake", "ring", GROUND)
//!     .clutch("clutch", "sun", "ring")
//!     .input("sun")
//!     .output("carrier")
//!     .build()?;
//! let links = vec![("sun".into(), kg_m2(0.2)), ("carrier".into(), kg_m2(8.0))];
//! let mut model = Model::new(Mechanism::of(&gearbox, &[], &Masses { links, ..Masses::default() })?);
//! model.torque("engine", "sun", TorqueLaw::constant(n_m(150.0))?)?;
//! model.torque("load", "carrier", TorqueLaw::constant(n_m(-300.0))?)?;
//! let ramp = Course::table(&[(s(0.0), n_m(0.0)), (s(0.4), n_m(200.0))])?;
//! model.shift_element("clutch", ramp, 1.0)?;
//!
//! let omega = AngularVelocity::new::<radian_per_second>;
//! let start = Start::speeds(&[("sun", omega(200.0)), ("ring", omega(0.0))]);
//! let run = model.run(&start, s(1.0), None)?;
//! let [released, closed] = run.events.as_slice() else { panic!("two events") };
//! assert!((released.after.time.get::<second>() - 0.2139534884).abs() < 1e-9);
//! assert_eq!(closed.after.states, [State::Forward, State::Stuck]);
//! assert!(run.audit.residual().abs() < 1e-9);
//! # Ok(())
//! # }
//! ```

mod converter;
mod course;
mod decide;
mod drag;
mod error;
mod field;
mod mechanism;
mod model;
mod pattern;
mod record;
mod run;
mod shaft;
mod split;
mod start;
mod step;
mod table;
mod tolerance;
mod torque_law;

pub use converter::Converter;
pub use course::Course;
pub use error::Error;
pub use mechanism::Mechanism;
pub use model::Model;
pub use record::{Audit, Change, Event, Run, Sample, State};
pub use shaft::{Contact, Shaft};
pub use start::Start;
pub use torque_law::TorqueLaw;
