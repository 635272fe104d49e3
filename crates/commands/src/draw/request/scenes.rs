//! Scenes of the views of a gearbox.

use super::{Request, View};
use crate::draw::answer::Drawing;
use crate::failure::Failure;
use crate::losses::answer::map as losses_map;
use crate::losses::table::efficiency_map;
use crate::shared::drawability::answer::Conflict;
use crate::shared::gearbox::{Gearbox, Origin};
use crate::shared::gearbox_choice::{analysis, refuse};
use crate::shared::toothed::{AssumedRadius, WithoutTeeth, in_mesh};
use epicyclic_drawing::Scene;
use epicyclic_formats::Path;
use epicyclic_layout::{Layout, Options, Verdict, draw};
use epicyclic_pictures::gearbox::{ladder, levers, scheme, speeds};
use epicyclic_pictures::toothed_sets::{self, ToothedSet};
use epicyclic_train::in_mesh::Unplaced;
use epicyclic_train::planet_bearings::PlanetBearing;
use epicyclic_train::toothed::Untoothed;
use epicyclic_train::{self as train, Analysis, PlanetSet};
use epicyclic_units::Physical as _;
use uom::si::f64::Length;

/// Scene of a gearbox in the view of a checked request; sets without teeth go to those left out.
pub(super) fn of_gearbox(
    request: &Request,
    gearbox: &Gearbox,
    drawing: &mut Drawing,
) -> Result<Scene, Failure> {
    let title = request.title.as_deref();
    let train = &gearbox.train;
    let gear = request.gear.as_deref().map(|gear| analysis(train, gear)).transpose()?;
    Ok(match (request.view(), &gear) {
        (View::Map, _) => map(request, gearbox)?,
        (View::Scheme, gear) => kinematic(request, gearbox, gear.as_ref())?,
        (View::Speeds, Some(gear)) => speeds::scene(train, gear, title)?,
        (View::Teeth, _) => toothed(gearbox, title, (&mut drawing.left_out, &mut drawing.assumed_radii))?,
        (View::Levers, gear) => levers::scene(train, gear.as_ref(), title)?,
        // The check leaves the ladder alone.
        _ => ladder::scene(train, &all_gears(train)?, title)?,
    })
}

/// The efficiency of a gear over speed and torque.
fn map(request: &Request, gearbox: &Gearbox) -> Result<Scene, Failure> {
    if gearbox.origin != Origin::GearboxFile {
        let message = "a map is of a gearbox's file, which states its losses".to_owned();
        return Err(Failure::invalid("--view", message));
    }
    let (Some(gear), Some((speeds, torques))) = (request.gear.as_deref(), request.map.places()) else {
        return Err(Failure::missing("--gear", "a map is of one gear; name it"));
    };
    let found = losses_map(gearbox, gear, &speeds, &torques).map_err(refuse)?;
    let picture = efficiency_map(&found, request.title.as_deref());
    Ok(picture.scene().map_err(epicyclic_pictures::Error::from)?)
}

/// The sets whose teeth are known, in mesh; a millimetre for a module where the file has none. Those that are
/// left out go into the record.
fn toothed(
    gearbox: &Gearbox,
    title: Option<&str>,
    (left_out, assumed): (&mut Vec<WithoutTeeth>, &mut Vec<AssumedRadius>),
) -> Result<Scene, Failure> {
    let mut sets = vec![];
    for set in gearbox.train.sets() {
        match in_mesh(gearbox, set) {
            Ok(in_mesh) => {
                let has_module = gearbox.modules(set).iter().any(Option::is_some);
                let unit = has_module.then(|| Length::from_si(1.0));
                assumed.extend(in_mesh.assumed.iter().map(|(planet, radius)| AssumedRadius {
                    set: set.id().to_owned(),
                    planet: set.planets()[*planet].name.clone(),
                    radius_m: has_module.then_some(*radius),
                }));
                sets.push(ToothedSet { set, in_mesh, unit });
            }
            Err(Unplaced::Uncut(error) | Unplaced::Untoothed(Untoothed::Refused(error))) => {
                return Err(epicyclic_pictures::Error::from(error).into());
            }
            Err(why) => left_out.push(WithoutTeeth::new(set, &why)),
        }
    }
    if sets.is_empty() {
        let sets: Vec<String> =
            left_out.iter().map(|one| format!("set `{}`: {}", one.set, one.why)).collect();
        let message = format!(
            "no set has teeth in mesh ({}): give `teeth`, and `planet_teeth` with `profile_shifts` where it needs them",
            sets.join("; ")
        );
        return Err(Failure::invalid("--view", message));
    }
    Ok(toothed_sets::scene(title.unwrap_or(gearbox.train.name()), &sets)?)
}

/// The first set whose gears cannot be, or the gearbox.
pub(super) fn of_faulty_teeth(gearbox: &Gearbox) -> Path {
    let is_fault = |set: &&PlanetSet| {
        use Unplaced::{Uncut, Untoothed as Without};
        matches!(in_mesh(gearbox, set), Err(Uncut(_) | Without(Untoothed::Refused(_))))
    };
    let sets = gearbox.train.sets();
    let Some(faulty) = sets.iter().find(is_fault) else { return gearbox.base.clone() };
    // The order of each kind is that of the file.
    let key = if faulty.short().is_some() { "sets" } else { "compound_sets" };
    let alike = sets.iter().filter(|set| set.short().is_some() == faulty.short().is_some());
    let place = alike.take_while(|set| set.id() != faulty.id()).count();
    gearbox.base.clone().key(key).index(place)
}

fn all_gears(gearbox: &train::Gearbox) -> Result<Vec<Analysis<'_>>, Failure> {
    Ok(gearbox.gears().iter().map(|gear| gearbox.analyze_gear(gear)).collect::<Result<_, _>>()?)
}

/// A layout with gears at the heights of their pitch radii.
pub(crate) fn to_scale(
    gearbox: &train::Gearbox,
    layout: &Layout,
    bearings: &[PlanetBearing],
) -> Result<(Layout, scheme::Scale), Failure> {
    scheme::to_scale(gearbox, layout, bearings).map_err(|error| match error {
        epicyclic_pictures::Error::NoRadii { .. } | epicyclic_pictures::Error::NotToScale { .. } => {
            Failure::named("not-to-scale", "--to-scale", error.to_string())
        }
        error => error.into(),
    })
}

fn kinematic(request: &Request, gearbox: &Gearbox, gear: Option<&Analysis>) -> Result<Scene, Failure> {
    let train = &gearbox.train;
    let how = Options { same_side: request.same_side, ..Options::default() };
    let layout = match draw(train, how) {
        Verdict::Drawable(layout) => layout,
        Verdict::SelfCrossing(witness) => {
            return Err(Failure::SelfCrossing {
                gearbox: train.name().to_owned(),
                conflict: Box::new(Conflict::of(train, &witness)),
            });
        }
    };
    let shown = match gear {
        None => scheme::Show::Structure,
        Some(gear) if request.power => scheme::Show::Power(gear),
        Some(gear) => scheme::Show::Gear(gear),
    };
    let (layout, scale) = if request.to_scale {
        if !gearbox.is_sized {
            let message = "heights are radii, and these follow from k or teeth of every set: give --k1 and --k2, or --ratio1 and --ratio2";
            return Err(Failure::invalid("--to-scale", message));
        }
        let (layout, scale) = to_scale(train, &layout, &gearbox.planet_bearings)?;
        (Box::new(layout), Some(scale))
    } else {
        (layout, None)
    };
    let options = scheme::Options {
        title: request.title.clone(),
        whole: request.whole,
        gearing: gearbox.is_sized,
        scale,
        ..scheme::Options::default()
    };
    Ok(scheme::scene(train, &layout, shown, &options)?)
}
