//! Losses of a gearbox at an operating point: load-dependent mesh losses, and drags that do not depend on the
//! load.
//!
//! Torques are external torques by the sign convention of the workspace. The torque on an output that
//! delivers power is therefore opposite to its speed.

mod heat;

use crate::analyze::answer::records::meshes;
use crate::analyze::answer::{Input, analysis, warnings};
use crate::answer::{Answer, Warning};
use crate::error::Error;
use crate::shared::fault::Fault;
use crate::shared::gearbox::Gearbox;
use crate::shared::judgement::answer::Judgement;
use crate::shared::places::Places;
use epicyclic_train::drag::{Load, WithDrags};
use epicyclic_train::{self as train, Analysis, Gear, InputLoad, InputsFault, OperatingFault};
use epicyclic_units::Physical;
pub use heat::{Cooling, GearHeat, Heat};
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::{AngularVelocity, Torque};

/// Speed and load at which the losses are asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Point {
    /// Speed of the input.
    pub(crate) speed: AngularVelocity,
    /// Load of the input or output.
    pub(crate) load: GivenLoad,
}

/// Load of the input or of the output.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GivenLoad {
    /// Load of the input.
    Input(InputLoad),
    /// Torque that a machine takes from the output; above 0 it acts against the output speed.
    Output(Torque),
}

/// Losses of a gearbox at a speed and a load.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Losses {
    /// Name of the gearbox.
    pub gearbox: String,
    /// Speed and load that were given.
    pub operating_point: LossPoint,
    /// Powers, torques and efficiency of the gears.
    pub gears: Vec<GearLosses>,
    /// Single losses of each gear, the largest of a gear first.
    pub losses: Vec<Loss>,
    /// Heat balance; null if no cooling is given.
    pub heat: Option<Heat>,
    /// Gears whose losses cannot be computed.
    pub not_calculated: Vec<NotCalculated>,
    /// Judgement of the gearbox by rules of practice.
    pub judgement: Judgement,
    /// Warnings about the gearbox.
    pub warnings: Vec<Warning>,
}

/// Losses of a gearbox as a chapter of a page, which shows the operating point elsewhere.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LossChapter {
    /// Powers, torques and efficiency of the gears.
    pub gears: Vec<GearLosses>,
    /// Single losses of each gear, the largest of a gear first.
    pub losses: Vec<Loss>,
    /// Gears whose losses cannot be computed.
    pub not_calculated: Vec<NotCalculated>,
}

/// Input speed and load that were asked for.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LossPoint {
    /// Input speed in rad/s.
    pub speed_rad_s: f64,
    /// Torque on the input in N·m; null if the load is given otherwise.
    pub torque_n_m: Option<f64>,
    /// Power into the input in W; null if the load is given otherwise.
    pub power_w: Option<f64>,
    /// Torque that a machine takes from the output, in N·m; null if the load is given otherwise.
    pub load_torque_n_m: Option<f64>,
}

/// Powers and torques of a gear with all its losses.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearLosses {
    /// Name of the gear.
    pub gear: String,
    /// Output speed in rad/s.
    pub output_speed_rad_s: f64,
    /// External torque on the input in N·m.
    pub input_torque_n_m: f64,
    /// External torque on the output in N·m.
    pub output_torque_n_m: f64,
    /// Power that enters at the input in W; negative if it leaves.
    pub input_power_w: f64,
    /// Power that enters at the output in W; negative if it leaves.
    pub output_power_w: f64,
    /// Power lost in the meshes, in W.
    pub mesh_loss_w: f64,
    /// Power lost by drags, in W.
    pub drag_loss_w: f64,
    /// Total power loss in W, which becomes heat.
    pub loss_w: f64,
    /// Efficiency: leaving power over entering power; null if all entering power is lost.
    pub efficiency: Option<f64>,
}

/// Single loss of a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Loss {
    /// Name of the gear.
    pub gear: String,
    /// Kind of the loss.
    pub kind: LossKind,
    /// Name of the set, the drag or the shift element that causes the loss.
    pub of: String,
    /// Names of the meshing gears, the driving one first, or of the links between which the drag acts.
    pub between: [String; 2],
    /// Relative speed of these links in rad/s; null for a mesh.
    pub slip_rad_s: Option<f64>,
    /// Drag torque in N·m; null for a mesh.
    pub torque_n_m: Option<f64>,
    /// Power lost in W; for a mesh over all planets.
    pub loss_w: f64,
    /// Part of the gear's total loss; null if the gear loses nothing.
    pub of_loss: Option<f64>,
}

/// Kinds of losses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LossKind {
    /// Mesh under load.
    Mesh,
    /// Drag of the gearbox.
    Drag,
    /// Brake or clutch that is not engaged.
    OpenElement,
}

/// Gear whose losses cannot be computed.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct NotCalculated {
    /// Name of the gear.
    pub gear: String,
    /// Stable name of the reason: `not-driven`, `drag`, `inputs`, `one-way-clutch`.
    pub reason: String,
    /// Reason in words.
    pub message: String,
}

/// Efficiency and losses of a gear over input speed and torque.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LossMap {
    /// Name of the gearbox.
    pub gearbox: String,
    /// Name of the gear.
    pub gear: String,
    /// Input speeds in rad/s.
    pub speeds_rad_s: Vec<f64>,
    /// Torques on the input in N·m.
    pub torques_n_m: Vec<f64>,
    /// Places of the map: all torques at the first speed, then at the next.
    pub map: Vec<MapPlace>,
    /// Judgement of the gearbox by rules of practice.
    pub judgement: Judgement,
    /// Warnings about the gearbox.
    pub warnings: Vec<Warning>,
}

/// Place of a map; its figures are null if losses hold the gear or a one-way clutch overruns.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MapPlace {
    /// Input speed in rad/s.
    pub speed_rad_s: f64,
    /// Torque on the input in N·m.
    pub torque_n_m: f64,
    /// Torque on the output in N·m; null if the gear cannot run at this place.
    pub output_torque_n_m: Option<f64>,
    /// Power lost in the meshes, in W; null if the gear cannot run at this place.
    pub mesh_loss_w: Option<f64>,
    /// Power lost by drags, in W; null if the gear cannot run at this place.
    pub drag_loss_w: Option<f64>,
    /// Total power loss in W; null if the gear cannot run at this place.
    pub loss_w: Option<f64>,
    /// Efficiency: leaving power over entering power. Null if the gear cannot run here, no power enters, or
    /// all of it is lost.
    pub efficiency: Option<f64>,
}

impl Answer for Losses {
    const NAME: &'static str = "losses";
}

impl Answer for LossMap {
    const NAME: &'static str = "losses-map";
}

/// Computes the losses of one gear, or of all, at a speed and a load.
///
/// # Errors
/// [`Error::NoGear`]; [`Error::Cooling`]. For a named gear also the reason why its losses cannot be computed:
/// [`Error::Gearbox`], or [`Error::Document`] with its place for a speed outside the curve of a drag.
pub(crate) fn answer(
    subject: &Gearbox,
    gear: Option<&str>,
    point: Point,
    cooling: Option<Cooling>,
) -> Result<Losses, Error> {
    if let Some(cooling) = &cooling {
        cooling.check()?;
    }
    let gearbox = &subject.train;
    let names: Vec<&str> = match gear {
        Some(name) => vec![name],
        None => gearbox.gears().iter().map(Gear::name).collect(),
    };
    let (mut gears, mut losses, mut not_calculated) = (vec![], vec![], vec![]);
    for name in names {
        let analysis = analysis(gearbox, name)?;
        match at(subject, &analysis, point) {
            Ok(found) => {
                let of_gear = GearLosses::of(name, &found);
                losses.extend(all_losses(subject, &of_gear, &found));
                gears.push(of_gear);
            }
            Err(held) if gear.is_some() => return Err(held.refused(subject, name)),
            Err(held) => not_calculated.push(held.told(name)),
        }
    }
    let heat = cooling.map(|cooling| heat::of(subject, point, &cooling, &gears)).transpose()?;
    Ok(Losses {
        gearbox: gearbox.name().to_owned(),
        operating_point: LossPoint::of(point),
        gears,
        losses,
        heat,
        not_calculated,
        judgement: Judgement::default(),
        warnings: warned(subject),
    })
}

/// Losses of all gears for a chapter of a page; `None` unless speed and load are given and some part has
/// losses.
///
/// # Errors
/// Those of [`Request::answer`](super::request::Request::answer).
pub fn chapter(subject: &Gearbox, input: Input) -> Result<Option<LossChapter>, Error> {
    let (Some(speed), Some(load)) = (input.speed, input.load) else { return Ok(None) };
    if is_lossless(subject) {
        return Ok(None);
    }
    let point = Point { speed, load: GivenLoad::Input(load) };
    let Losses { gears, losses, not_calculated, .. } = answer(subject, None, point, None)?;
    Ok(Some(LossChapter { gears, losses, not_calculated }))
}

/// Computes the losses of a gear over speeds and torques of its input.
///
/// # Errors
/// [`Error::NoGear`]; [`Error::Gearbox`] for a gear that is not driven; [`Error::Document`] for a speed
/// outside the curve of a drag.
pub(crate) fn map(
    subject: &Gearbox,
    gear: &str,
    speeds: &Places<AngularVelocity>,
    torques: &Places<Torque>,
) -> Result<LossMap, Error> {
    let analysis = analysis(&subject.train, gear)?;
    let mut map = Vec::with_capacity(speeds.count() * torques.count());
    for speed in speeds.values() {
        for torque in torques.values() {
            let load = GivenLoad::Input(InputLoad::Torque(torque));
            let found = match at(subject, &analysis, Point { speed, load }) {
                Ok(found) => Some(found),
                Err(held) if held.is_of_the_place() => None,
                Err(held) => return Err(held.refused(subject, gear)),
            };
            let watts =
                |of: fn(&WithDrags) -> uom::si::f64::Power| found.as_ref().map(|found| of(found).si());
            map.push(MapPlace {
                speed_rad_s: speed.si(),
                torque_n_m: torque.si(),
                output_torque_n_m: found.as_ref().map(|found| found.output.si()),
                mesh_loss_w: watts(WithDrags::mesh_loss),
                drag_loss_w: watts(WithDrags::drag_loss),
                loss_w: watts(|found| found.mesh_loss() + found.drag_loss()),
                efficiency: found.as_ref().and_then(WithDrags::efficiency),
            });
        }
    }
    let mut warnings = warned(subject);
    Ok(LossMap {
        judgement: Judgement::added_to(&mut warnings, subject),
        gearbox: subject.train.name().to_owned(),
        gear: gear.to_owned(),
        speeds_rad_s: speeds.values().map(Physical::si).collect(),
        torques_n_m: torques.values().map(Physical::si).collect(),
        map,
        warnings,
    })
}

/// Reasons why the losses of a gear cannot be computed.
enum Held {
    /// Error of the solver.
    Refused(Box<train::Error>),
    /// Name of a one-way clutch that overruns.
    Released(String),
}

impl Held {
    /// Whether the gear may run at other speeds and torques: the losses hold it, or a one-way clutch
    /// overruns.
    fn is_of_the_place(&self) -> bool {
        match self {
            Self::Released(_) => true,
            Self::Refused(error) => matches!(
                **error,
                train::Error::Inputs(InputsFault::SelfLocking)
                    | train::Error::OperatingPoint { why: OperatingFault::SelfLocking }
            ),
        }
    }

    /// Converts the reason into an error, with the place in the file for the fault of a drag.
    fn refused(self, subject: &Gearbox, gear: &str) -> Error {
        match self {
            Self::Released(clutch) => Error::Released { clutch, gear: gear.to_owned() },
            Self::Refused(error) => {
                let train::Error::Drag { drag, fault } = &*error else { return (*error).into() };
                let drag = subject.drags.iter().position(|one| one.name == *drag);
                let path = drag.map_or(subject.base.clone(), |drag| subject.drag_path(drag, fault));
                subject.document.error(&path, error.problem()).into()
            }
        }
    }

    fn told(self, gear: &str) -> NotCalculated {
        let (reason, message) = match self {
            Self::Refused(error) => (error.name().to_owned(), error.to_string()),
            Self::Released(clutch) => ("one-way-clutch".to_owned(), released(&clutch)),
        };
        NotCalculated { gear: gear.to_owned(), reason, message }
    }
}

fn released(clutch: &str) -> String {
    format!("one-way clutch {clutch} lets go at this load")
}

fn at(subject: &Gearbox, analysis: &Analysis<'_>, Point { speed, load }: Point) -> Result<WithDrags, Held> {
    let load = match load {
        GivenLoad::Input(InputLoad::Torque(torque)) => Load::Input(torque),
        GivenLoad::Input(InputLoad::Power(power)) => {
            let torque = power.si() / speed.si();
            if !torque.is_finite() {
                let why = OperatingFault::PowerAtRest;
                return Err(Held::Refused(Box::new(train::Error::OperatingPoint { why })));
            }
            Load::Input(Torque::from_si(torque))
        }
        GivenLoad::Output(taken) => {
            let output = analysis.speed(analysis.gear().output()).unwrap_or(1.0) * speed.si();
            Load::Output(taken * -output.signum())
        }
    };
    let found = analysis.with_drags(speed, load, &subject.drags);
    let found = found.map_err(|error| Held::Refused(Box::new(error)))?;
    match found.released.first() {
        None => Ok(found),
        Some(&place) => Err(Held::Released(subject.train.shift_elements()[place].id().to_owned())),
    }
}

fn is_lossless(subject: &Gearbox) -> bool {
    !subject.has_losses() && subject.drags.is_empty()
}

fn warned(subject: &Gearbox) -> Vec<Warning> {
    let mut all = warnings::of_gearbox(subject);
    if is_lossless(subject) {
        let message =
            "nothing loses power here: no efficiencies, friction or drags are stated that apply".to_owned();
        all.push(Warning { name: "no-losses", message });
    }
    all
}

impl LossPoint {
    fn of(point: Point) -> Self {
        let (mut torque, mut power, mut load) = (None, None, None);
        match point.load {
            GivenLoad::Input(InputLoad::Torque(given)) => torque = Some(given.si()),
            GivenLoad::Input(InputLoad::Power(given)) => power = Some(given.si()),
            GivenLoad::Output(given) => load = Some(given.si()),
        }
        Self { speed_rad_s: point.speed.si(), torque_n_m: torque, power_w: power, load_torque_n_m: load }
    }
}

impl GearLosses {
    fn of(gear: &str, found: &WithDrags) -> Self {
        let (mesh, drag) = (found.mesh_loss(), found.drag_loss());
        Self {
            gear: gear.to_owned(),
            output_speed_rad_s: found.output_speed.si(),
            input_torque_n_m: found.input.si(),
            output_torque_n_m: found.output.si(),
            input_power_w: found.input_power().si(),
            output_power_w: found.output_power().si(),
            mesh_loss_w: mesh.si(),
            drag_loss_w: drag.si(),
            loss_w: (mesh + drag).si(),
            efficiency: found.efficiency(),
        }
    }
}

/// Losses of a gear that are not 0, the largest first.
fn all_losses(subject: &Gearbox, gear: &GearLosses, found: &WithDrags) -> Vec<Loss> {
    let gearbox = &subject.train;
    let one = |kind, of: &str, between, slip, torque, loss_w: f64| Loss {
        gear: gear.gear.clone(),
        kind,
        of: of.to_owned(),
        between,
        slip_rad_s: slip,
        torque_n_m: torque,
        loss_w,
        of_loss: (gear.loss_w > 0.0).then(|| loss_w / gear.loss_w),
    };
    let through = meshes(gearbox, |set| found.meshes[set].clone()).into_iter();
    let of_mesh = |mesh: crate::analyze::answer::records::MeshFigures| {
        let loss = mesh.enters.unwrap_or(0.0) - mesh.leaves.unwrap_or(0.0);
        one(LossKind::Mesh, &mesh.set, [mesh.from, mesh.to], None, None, loss)
    };
    let mut all: Vec<Loss> = through.map(of_mesh).collect();
    for (drag, at) in subject.drags.iter().zip(&found.drags) {
        let kind = if drag.shift_element.is_some() { LossKind::OpenElement } else { LossKind::Drag };
        let between = drag.links.map(|link| gearbox.link_name(link).to_owned());
        all.push(one(kind, &drag.name, between, Some(at.slip.si()), Some(at.torque.si()), at.loss.si()));
    }
    all.retain(|loss| loss.loss_w != 0.0);
    all.sort_by(|one, other| other.loss_w.total_cmp(&one.loss_w));
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analyze::answer::gear;
    use crate::shared::gearbox::{Choice, one};
    use epicyclic_formats::Document;
    use uom::si::f64::{Power, TemperatureInterval, ThermalConductance};

    const BOX: &str = "\
gearbox: two speeds
input: D
output: B
sets: [{ id: P, sun: D, ring: T, carrier: B, k: 3, meshes: [0.98, 0.99] }]
brakes: [{ id: K1, link: T, drag: { speeds: [0 rpm, 2000 rpm], torques: [0.5 N·m, 1.5 N·m] } }]
clutches: [{ id: K2, links: [D, B], drag: { speeds: [0 rpm], torques: [3 N·m], beyond: constant } }]
drags: [{ id: seal, between: [D, ground], curve: { speeds: [0 rpm, 3000 rpm], torques: [1 N·m, 2.5 N·m] } }]
gears: [{ name: slow, engaged: [K1] }, { name: fast, engaged: [K2] }, { name: none, engaged: [] }]
";

    fn document(text: &str) -> Document {
        Document::parse_one("box.yaml", text.as_bytes()).unwrap()
    }

    fn rpm(speed: f64) -> AngularVelocity {
        AngularVelocity::from_si(speed * std::f64::consts::PI / 30.0)
    }

    fn point(speed: f64, load: GivenLoad) -> Point {
        Point { speed: rpm(speed), load }
    }

    fn on_input(torque: f64) -> GivenLoad {
        GivenLoad::Input(InputLoad::Torque(Torque::from_si(torque)))
    }

    /// By hand: seal and open clutch between D and B take from the input, and the meshes from the sun's
    /// torque.
    #[test]
    fn every_loss_of_a_gear_has_its_name() {
        let document = document(BOX);
        let subject = one(&document, &Choice::default()).unwrap();
        let found = answer(&subject, None, point(1000.0, on_input(100.0)), None).unwrap();
        let [slow, fast] = &found.gears[..] else { panic!("{:?}", found.gears) };
        let omega = rpm(1000.0).si();
        // 1.5 N·m in the seal; the clutch slips at 3/4 of the input speed and passes its 3 N·m on to the
        // output.
        let sun = 100.0 - 1.5 - 3.0;
        let output = sun * (1.0 + 3.0 * 0.98 * 0.99) + 3.0;
        assert!((slow.output_torque_n_m + output).abs() < 1e-10 && slow.efficiency.unwrap() > 0.9);
        let clutch = found.losses.iter().find(|loss| loss.of == "K2").unwrap();
        assert!((clutch.loss_w - 3.0 * 0.75 * omega).abs() < 1e-9 && clutch.kind == LossKind::OpenElement);
        let of_gear = |gear: &str| {
            found.losses.iter().filter(|loss| loss.gear == gear).map(|loss| loss.loss_w).sum::<f64>()
        };
        for gear in [slow, fast] {
            let left = gear.input_power_w + gear.output_power_w - of_gear(&gear.gear);
            assert!(left.abs() < 1e-9 * gear.input_power_w, "{gear:?}");
        }
        // In direct drive the set turns as a block, and the brake drags on all of it.
        assert!((fast.output_torque_n_m + 100.0 - 1.5 - 1.0).abs() < 1e-10 && fast.mesh_loss_w == 0.0);
        assert_eq!(found.not_calculated.len(), 1);
        assert_eq!(found.not_calculated[0].reason, "not-driven");
        // The reverse calculation: the input torque for the torque that the output delivers.
        let load = GivenLoad::Output(Torque::from_si(output));
        let back = answer(&subject, Some("slow"), point(1000.0, load), None).unwrap();
        assert!((back.gears[0].input_torque_n_m - 100.0).abs() < 1e-10);
    }

    #[test]
    fn without_drags_it_is_what_analyze_tells() {
        let document = document(BOX);
        let mut subject = one(&document, &Choice::default()).unwrap();
        subject.drags.clear();
        for torque in [100.0, -40.0] {
            let found = answer(&subject, Some("slow"), point(1450.0, on_input(torque)), None).unwrap();
            let load = Some(InputLoad::Torque(Torque::from_si(torque)));
            let analyzed = gear::answer(&subject, "slow", Input { speed: Some(rpm(1450.0)), load }).unwrap();
            let powers = analyzed.powers.unwrap().at_load.unwrap();
            assert!((found.gears[0].loss_w - powers.loss_w).abs() < 1e-10 * powers.entering_w);
            let efficiency = powers.leaving_w / powers.entering_w;
            assert!((found.gears[0].efficiency.unwrap() - efficiency).abs() < 1e-12);
        }
    }

    /// Housing and cooler together take the total loss; at the thermal limit the oil has the allowed
    /// temperature rise, whatever torque led there.
    #[test]
    fn heat_is_balanced_and_the_thermal_limit_has_the_allowed_rise() {
        let document = document(BOX);
        let subject = one(&document, &Choice::default()).unwrap();
        let with = |torque: f64, cooler: f64, rise: f64| {
            let cooling = Cooling {
                conductance: ThermalConductance::from_si(20.0),
                cooler: Power::from_si(cooler),
                allowed_rise: Some(TemperatureInterval::from_si(rise)),
            };
            answer(&subject, Some("slow"), point(1000.0, on_input(torque)), Some(cooling))
                .unwrap()
                .heat
                .unwrap()
                .gears
                .remove(0)
        };
        for (cooler, rise) in [(0.0, 50.0), (300.0, 40.0)] {
            let one = with(100.0, cooler, rise);
            assert!((one.rise_k * 20.0 + one.cooler_w - one.loss_w).abs() < 1e-9 * one.loss_w);
            let torque = one.thermal_torque_n_m.unwrap();
            let at_limit = with(torque, cooler, rise);
            assert!((at_limit.rise_k - rise).abs() < 1e-8 * rise, "{at_limit:?}");
            for other in [0.3 * torque, 7.0 * torque] {
                let same = with(other, cooler, rise).thermal_torque_n_m.unwrap();
                assert!((same - torque).abs() < 1e-8 * torque, "{same} {torque}");
            }
        }
        // By hand: seal 1.5 N·m, open clutch 3·3/4 N·m, meshes 3/4·(1 − 0.98·0.99) of the sun's torque.
        let omega = rpm(1000.0).si();
        let sun = (50.0 * 20.0 / omega - 1.5 - 3.0 * 0.75) / (0.75 * (1.0 - 0.98 * 0.99));
        assert!((with(100.0, 0.0, 50.0).thermal_torque_n_m.unwrap() - sun - 4.5).abs() < 1e-6);
        // A large cooler takes all heat; drags alone may be too much.
        assert_eq!(with(100.0, 1e6, 50.0).rise_k, 0.0);
        assert_eq!(with(100.0, 0.0, 1.0).thermal_torque_n_m, Some(0.0));
    }

    #[test]
    fn a_place_of_the_map_is_the_point() {
        let document = document(BOX);
        let subject = one(&document, &Choice::default()).unwrap();
        let speeds = Places::new(rpm(0.0), rpm(2000.0), 5).unwrap();
        let torques = Places::new(Torque::from_si(0.0), Torque::from_si(200.0), 5).unwrap();
        let found = map(&subject, "slow", &speeds, &torques).unwrap();
        assert_eq!(found.map.len(), 25);
        let place = &found.map[3 * 5 + 2];
        let point = answer(&subject, Some("slow"), point(1500.0, on_input(100.0)), None).unwrap();
        let point = &point.gears[0];
        assert!((place.efficiency.unwrap() - point.efficiency.unwrap()).abs() < 1e-12);
        assert!((place.loss_w.unwrap() - point.loss_w).abs() < 1e-12 * point.input_power_w);
        // At rest there is no power; without an input torque the output would have to help.
        assert!(found.map[2].efficiency.is_none() && found.map[15].efficiency.is_none());
        assert!(Places::<_>::new(rpm(0.0), rpm(1.0), 1).is_err());
    }

    #[test]
    fn a_speed_outside_a_curve_is_refused_at_its_place() {
        let document = document(BOX);
        let subject = one(&document, &Choice::default()).unwrap();
        let refused =
            answer(&subject, Some("slow"), point(4000.0, on_input(100.0)), None).unwrap_err().to_string();
        assert!(
            refused.starts_with("box.yaml:7:60: drags[0].curve.speeds: drag `seal`: its links turn 4000 rpm"),
            "{refused}"
        );
        let all = answer(&subject, None, point(4000.0, on_input(100.0)), None).unwrap();
        assert!(all.gears.is_empty() && all.not_calculated[0].reason == "drag");
    }
}
