//! One gear at many speeds and torques of its links, as columns: a power split, a differential, or a gear
//! with one input at many operating points.
//!
//! One point is what [`analyze::inputs`](crate::analyze::answer::inputs) says of it.

use super::{PIECE, gears, pieces};
use crate::error::Error;
use crate::refusal::Given;
use epicyclic_train::inputs::MultiState;
use epicyclic_train::{self as train, Gearbox, InputsFault, LinkId};
use epicyclic_units::Physical;
use std::ops::ControlFlow;
use uom::si::f64::{AngularVelocity, Torque};

/// Speeds and torques to calculate: as many speeds as the gear keeps degrees of freedom, and torques at the
/// other terminals, or no torques.
#[derive(Debug, Clone, PartialEq)]
pub struct Request<'a> {
    /// The gear.
    pub gear: String,
    /// Speeds by link, rad/s, of every point.
    pub speeds_rad_s: Vec<(String, &'a [f64])>,
    /// Torques by link, N·m, of every point; none for the speeds alone.
    pub torques_n_m: Vec<(String, &'a [f64])>,
}

/// Columns over points; columns over several links list all links of a point before the next point.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Columns {
    /// How many points there are.
    pub points: usize,
    /// The links, the housing not among them.
    pub links: Vec<String>,
    /// Speeds of the links, rad/s; 0 if [`has_speed`](Self::has_speed) is false.
    pub speeds_rad_s: Vec<f64>,
    /// Whether the speed of a link follows: the same at every point.
    pub has_speed: Vec<bool>,
    /// Links at which torques act from outside; empty without torques.
    pub terminals: Vec<String>,
    /// Torques at the terminals, N·m; 0 if [`moves`](Self::moves) is false.
    pub torques_n_m: Vec<f64>,
    /// Powers that enter at the terminals, W.
    pub powers_w: Vec<f64>,
    /// Whether torques keep the gear moving this way; without torques none are asked for.
    pub moves: Vec<bool>,
    /// Power lost in the meshes, W.
    pub losses_w: Vec<f64>,
    /// Power that leaves over power that enters; 0 where [`has_efficiency`](Self::has_efficiency) says that
    /// none enters.
    pub efficiencies: Vec<f64>,
    /// Whether power enters.
    pub has_efficiency: Vec<bool>,
}

impl Request<'_> {
    /// Solves every point; `None` if `goes_on` ended it, which is called as in
    /// [`super::Request::answer`].
    ///
    /// ```
    /// use epicyclic_commands::sweep::points::Request;
    /// use epicyclic_train::{Gearbox, set::{SetKind, SetSpec}};
    /// use std::ops::ControlFlow;
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let gearbox = Gearbox::builder("split")
    ///     .links(["engine", "mg1", "ring"])
    ///     .set(SetSpec::teeth("PSD", SetKind::Simple, ["mg1", "ring", "engine"], 30, 78)?)
    ///     .input("engine")
    ///     .output("ring")
    ///     .gear("split", [""; 0])
    ///     .build()?;
    /// let speeds_rad_s = vec![("engine".into(), &[100.0, 100.0][..]), ("mg1".into(), &[0.0, 360.0][..])];
    /// let request = Request { gear: "split".into(), speeds_rad_s, torques_n_m: vec![] };
    /// let found = request.answer(&gearbox, &|_| ControlFlow::Continue(()))?.expect("nothing ends it");
    /// assert_eq!(found.links, ["engine", "mg1", "ring"]);
    /// // 108·ω_engine = 30·ω_mg1 + 78·ω_ring
    /// assert!((found.speeds_rad_s[2] - 10800.0 / 78.0).abs() < 1e-12 && found.speeds_rad_s[5].abs() < 1e-12);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// - [`Error::NoGear`], [`Error::NoLink`] for an unknown name.
    /// - [`Error::SweptLength`] unless all columns are equally long.
    /// - [`Error::Inputs`] if the speeds or torques are too few, too many or dependent.
    /// - [`Error::SweptVariant`] with the first point that has an infinite, undefined or too large number.
    pub fn answer(
        &self,
        gearbox: &Gearbox,
        goes_on: &(dyn Fn(usize) -> ControlFlow<()> + Sync),
    ) -> Result<Option<Columns>, Error> {
        let gear = gears(gearbox, std::slice::from_ref(&self.gear))?.remove(0);
        let speeds = links(gearbox, &self.speeds_rad_s, Given::Speeds)?;
        let torques = links(gearbox, &self.torques_n_m, Given::Torques)?;
        let mut all = self.speeds_rad_s.iter().chain(&self.torques_n_m);
        let (first, points) =
            all.next().map_or((String::new(), 1), |(link, values)| (link.clone(), values.len()));
        if let Some((name, values)) = all.find(|(_, values)| values.len() != points) {
            return Err(Error::SweptLength {
                name: name.clone(),
                given: values.len(),
                first,
                expected: points,
            });
        }
        let at = |variant: usize| -> Result<Option<MultiState>, Error> {
            let speeds: Vec<_> = speeds
                .iter()
                .map(|(link, values)| (*link, AngularVelocity::from_si(values[variant])))
                .collect();
            let torques: Vec<_> =
                torques.iter().map(|(link, values)| (*link, Torque::from_si(values[variant]))).collect();
            match gearbox.with_inputs(&gear, &speeds, &torques) {
                Ok(state) => Ok(Some(state)),
                Err(train::Error::Inputs(InputsFault::SelfLocking)) => {
                    // Its speeds follow all the same.
                    gearbox.with_inputs(&gear, &speeds, &[]).map(Some).map_err(Error::from)
                }
                Err(train::Error::Inputs(fault)) => {
                    let of_torques =
                        matches!(fault, InputsFault::Torques { .. } | InputsFault::DependentTorques { .. });
                    let given = if of_torques { Given::Torques } else { Given::Speeds };
                    Err(Error::Inputs { given, fault })
                }
                Err(why) => Err(Error::SweptVariant { variant, why }),
            }
        };
        let piece = |place: usize| {
            if goes_on(0).is_break() {
                return Ok(None);
            }
            let range = place * PIECE..points.min((place + 1) * PIECE);
            let count = range.len();
            let found = range.map(at).collect::<Result<Option<Vec<MultiState>>, Error>>()?;
            Ok(found.filter(|_| goes_on(count).is_continue()))
        };
        let links = gearbox.links().iter().skip(1).cloned().collect();
        let mut columns = Columns { points, links, ..Columns::default() };
        for piece in pieces(points.div_ceil(PIECE), &piece) {
            let Some(piece) = piece? else { return Ok(None) };
            for state in &piece {
                columns.push(gearbox, state);
            }
        }
        // A load that no point has leaves no terminals to tell of.
        let count = columns.terminals.len();
        if count > 0 && columns.torques_n_m.len() < points * count {
            columns.spread(count);
        }
        Ok(Some(columns))
    }
}

impl Columns {
    fn push(&mut self, gearbox: &Gearbox, state: &MultiState) {
        let speeds = &state.speeds[1..];
        if self.has_speed.is_empty() {
            self.has_speed = speeds.iter().map(Option::is_some).collect();
        }
        self.speeds_rad_s.extend(speeds.iter().map(|speed| speed.map_or(0.0, AngularVelocity::si)));
        let load = state.load.as_ref();
        self.moves.push(load.is_some());
        self.losses_w.push(load.map_or(0.0, |load| load.loss.si()));
        let efficiency = load.and_then(|load| load.efficiency);
        self.efficiencies.push(efficiency.unwrap_or(0.0));
        self.has_efficiency.push(efficiency.is_some());
        if let Some(load) = load {
            if self.terminals.is_empty() {
                let name = |end: &train::inputs::Terminal| gearbox.link_name(end.link).to_owned();
                self.terminals = load.terminals.iter().map(name).collect();
            }
            self.torques_n_m.extend(load.terminals.iter().map(|end| end.torque.si()));
            self.powers_w.extend(load.terminals.iter().map(|end| end.power.si()));
        }
    }

    /// Rows of 0 for the points that no torque keeps moving.
    fn spread(&mut self, count: usize) {
        for column in [&mut self.torques_n_m, &mut self.powers_w] {
            let mut rows = column.chunks(count);
            let row = |moves: &bool| if *moves { rows.next().unwrap_or_default() } else { &[] };
            let all: Vec<Vec<f64>> = self.moves.iter().map(row).map(<[f64]>::to_vec).collect();
            *column =
                all.into_iter().flat_map(|row| if row.is_empty() { vec![0.0; count] } else { row }).collect();
        }
    }
}

/// Links with their columns.
fn links<'a>(
    gearbox: &Gearbox,
    named: &[(String, &'a [f64])],
    given: Given,
) -> Result<Vec<(LinkId, &'a [f64])>, Error> {
    let names = || gearbox.links().iter().skip(1).cloned().collect();
    let find = |(name, values): &(String, &'a [f64])| match gearbox.link(name) {
        Some(link) => Ok((link, *values)),
        None => Err(Error::NoLink { given, name: name.clone(), links: names() }),
    };
    named.iter().map(find).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_gears::efficiency::MeshEfficiency;
    use epicyclic_train::set::{MeshLoss, SetKind, SetSpec};

    /// A double planet whose basic ratio is near 1: its losses hold it against a torque at the carrier one
    /// way.
    fn locking() -> Gearbox {
        let loss = MeshLoss::Set(MeshEfficiency::new(0.97).unwrap());
        Gearbox::builder("locking")
            .links(["sun", "carrier"])
            .set(SetSpec::new("1", SetKind::DoublePlanet, ["sun", "ground", "carrier"], 1.01).with_loss(loss))
            .input("sun")
            .output("carrier")
            .gear("1", [""; 0])
            .build()
            .unwrap()
    }

    #[test]
    fn points_are_what_one_point_alone_is() {
        let gearbox = locking();
        let (speeds, torques) = ([100.0, -50.0, 20.0, 20.0], [1.0, 2.0, -3.0, 4.0]);
        let request = Request {
            gear: "1".into(),
            speeds_rad_s: vec![("sun".into(), &speeds)],
            torques_n_m: vec![("carrier".into(), &torques)],
        };
        let found = request.answer(&gearbox, &|_| ControlFlow::Continue(())).unwrap().unwrap();
        assert_eq!(found.links, ["sun", "carrier"]);
        assert_eq!(found.terminals, ["sun", "carrier"]);
        let mut locked = 0;
        for (point, (&speed, &torque)) in speeds.iter().zip(&torques).enumerate() {
            let [sun, carrier] = ["sun", "carrier"].map(|link| gearbox.link(link).unwrap());
            let alone = gearbox.with_inputs(
                gearbox.gear("1").unwrap(),
                &[(sun, AngularVelocity::from_si(speed))],
                &[(carrier, Torque::from_si(torque))],
            );
            // ω_sun = (1 − i₀)·ω_carrier with i₀ = 1.01
            assert!((found.speeds_rad_s[2 * point + 1] + 100.0 * speed).abs() < 1e-9 * speed.abs() * 100.0);
            match alone {
                Ok(alone) => {
                    let load = alone.load.unwrap();
                    assert!(found.moves[point]);
                    assert_eq!(found.torques_n_m[2 * point], load.terminals[0].torque.si());
                    assert_eq!(found.powers_w[2 * point], load.terminals[0].power.si());
                    assert_eq!(found.losses_w[point], load.loss.si());
                }
                Err(_) => {
                    locked += 1;
                    assert!(!found.moves[point] && !found.has_efficiency[point]);
                    assert_eq!(found.torques_n_m[2 * point..2 * point + 2], [0.0, 0.0]);
                }
            }
        }
        assert!(locked > 0 && locked < 4, "{locked}");
    }

    #[test]
    fn what_does_not_settle_the_gear_is_refused() {
        let gearbox = locking();
        let refused = |gear: &str, speeds: Vec<(&str, &[f64])>, torques: Vec<(&str, &[f64])>| {
            let fixed = |all: Vec<(&str, &[f64])>| -> Vec<(String, Vec<f64>)> {
                all.into_iter().map(|(link, values)| (link.to_owned(), values.to_vec())).collect()
            };
            let (speeds, torques) = (fixed(speeds), fixed(torques));
            let request = Request {
                gear: gear.into(),
                speeds_rad_s: speeds.iter().map(|(link, values)| (link.clone(), values.as_slice())).collect(),
                torques_n_m: torques.iter().map(|(link, values)| (link.clone(), values.as_slice())).collect(),
            };
            request.answer(&gearbox, &|_| ControlFlow::Continue(())).unwrap_err().name()
        };
        assert_eq!(refused("9", vec![("sun", &[1.0])], vec![]), "no-gear");
        assert_eq!(refused("1", vec![("moon", &[1.0])], vec![]), "no-link");
        assert_eq!(refused("1", vec![], vec![]), "inputs");
        assert_eq!(refused("1", vec![("sun", &[1.0, 2.0])], vec![("sun", &[1.0])]), "swept-length");
        assert_eq!(refused("1", vec![("sun", &[1.0, f64::NAN])], vec![]), "operating-point");
    }
}
