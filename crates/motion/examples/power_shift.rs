//! A power shift of one set: a one-way brake holds the ring until the clutch between sun and ring has taken over.

use epicyclic_dynamics::gearbox::Masses;
use epicyclic_motion::{Course, Mechanism, Model, Start, State, TorqueLaw};
use epicyclic_train::{GROUND, Gearbox, set::SetSpec};
use uom::si::angular_velocity::radian_per_second;
use uom::si::f64::{AngularVelocity, MomentOfInertia, Time, Torque};
use uom::si::moment_of_inertia::kilogram_square_meter;
use uom::si::{time::second, torque::newton_meter};
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (n_m, s) = (Torque::new::<newton_meter>, Time::new::<second>);
    let kg_m2 = MomentOfInertia::new::<kilogram_square_meter>;
    let gearbox = Gearbox::builder("two speeds")
        .links(["sun", "ring", "carrier"])
        .set(SetSpec::simple("set", ["sun", "ring", "carrier"], 2.0))
        .one_way_clutch("brake", "ring", GROUND)
        .clutch("clutch", "sun", "ring")
        .input("sun")
        .output("carrier")
        .build()?;
    let links = vec![("sun".into(), kg_m2(0.2)), ("carrier".into(), kg_m2(8.0))];
    let mut model = Model::new(Mechanism::of(&gearbox, &[], &Masses { links, ..Masses::default() })?);
    model.torque("engine", "sun", TorqueLaw::constant(n_m(150.0))?)?;
    model.torque("load", "carrier", TorqueLaw::constant(n_m(-300.0))?)?;
    let ramp = Course::table(&[(s(0.0), n_m(0.0)), (s(0.4), n_m(200.0))])?;
    model.shift_element("clutch", ramp, 1.0)?;

    let omega = AngularVelocity::new::<radian_per_second>;
    let start = Start::speeds(&[("sun", omega(200.0)), ("ring", omega(0.0))]);
    let run = model.run(&start, s(1.0), None)?;
    let [released, closed] = run.events.as_slice() else { return Err("two events".into()) };
    assert!((released.after.time.get::<second>() - 0.2139534884).abs() < 1e-9);
    assert_eq!(closed.after.states, [State::Forward, State::Stuck]);
    assert!(run.audit.residual().abs() < 1e-9);
    Ok(())
}
