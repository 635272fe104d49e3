//! The page of a gearbox: all gears, each gear in full, and what another `k` would change.

use super::sheet::{Block, Section, Sheet};
use crate::tolerance::LEVEL;
use crate::{AsReport as _, Error, drawability};
use epicyclic_answers::report::gearbox::{GearOverK, GearboxReport, OverK, Shown};
use epicyclic_pictures::gearbox::scheme::{self, Show};
use epicyclic_pictures::gearbox::{ladder, levers, speeds};
use epicyclic_pictures::plot::{Curve, Plot};

/// Ratios and planet speeds from here on are left out of the curves: they would press all others flat.
const GREATEST: f64 = 20.0;
/// Efficiencies up to here are left out of the curves.
const LEAST_EFFICIENCY: f64 = 0.5;

/// All gears, each gear in full, and what another `k` would change; `file` is the file as it was written.
///
/// # Errors
/// [`Error::Picture`] for a gearbox that cannot be drawn.
pub fn sheet(report: &GearboxReport, shown: &Shown<'_>, file: String) -> Result<Sheet, Error> {
    let overview = &report.overview;
    let input = Section::new("Input", vec![Block::File(file)]);
    let drawing = Section::new("Drawing", structure(report, shown)?);
    // A list of transmissions is long and mostly about others: it stands last.
    let (mut sections, last) = match &overview.source {
        None => (vec![input, drawing], None),
        Some(_) => (vec![drawing], Some(input)),
    };
    let mut all = vec![Block::Answer(overview.report())];
    if overview.gears.iter().any(|gear| gear.facts.ratio.is_some()) {
        let ladder = picture(ladder::scene(shown.gearbox, &shown.gears, None))?;
        all.push(Block::picture(ladder, "Ratios of all gears on a logarithmic scale, with their steps."));
    }
    sections.push(Section::new("Gears", all));
    if let Some(shifts) = report.shifts.as_ref().filter(|shifts| !shifts.shifts.is_empty()) {
        sections.push(Section::new("Shifts", vec![Block::Answer(shifts.report())]));
    }
    for (place, gear) in report.gears.iter().enumerate() {
        let mut blocks = of_gear(shown, place)?;
        blocks.push(Block::Answer(gear.report()));
        sections.push(Section::new(format!("Gear {}", gear.gear.gear), blocks));
    }
    sections.push(Section::new("Another k", over_k(&report.over_k)?));
    let left_out = [
        "Losses outside the meshes: bearings, seals, churning oil, drag of open clutches and brakes.",
        "Profile shift and strength of teeth; uneven load of the planets.",
        "What happens while it shifts.",
    ];
    sections.push(Section::new("What is left out", vec![Block::List(left_out.map(str::to_owned).to_vec())]));
    let theory = "Speeds by Willis' equation of each set, torques by their balance with the loss of each mesh on the side that \
                  its rolling power flows to; as in the document multispeed-gearboxes, chapters 1 and 2.";
    let sources = overview.source.clone().into_iter().chain([theory.to_owned()]).collect();
    sections.push(Section::new("Sources", vec![Block::List(sources)]));
    sections.extend(last);
    let count = |count: usize, what: &str| format!("{count} {what}{}", if count == 1 { "" } else { "s" });
    Ok(Sheet {
        title: overview.gearbox.clone(),
        about: format!(
            "Planetary gearbox with {}, {} and {}",
            count(report.sets.len(), "set"),
            count(overview.shift_elements.len(), "shift element"),
            count(overview.gears.len(), "gear")
        ),
        sections,
    })
}

/// The scheme and its levers.
fn structure(report: &GearboxReport, shown: &Shown<'_>) -> Result<Vec<Block>, Error> {
    let scheme = shown.layout.as_deref().map(|layout| {
        let drawn = scheme::scene(shown.gearbox, layout, Show::Structure, &scheme::Options::default());
        Ok::<_, Error>(Block::picture(picture(drawn)?, "Kinematic scheme, the half above the axis."))
    });
    let conflict = report.conflict.as_ref().map(|conflict| {
        let why = drawability::together(conflict);
        Block::words(format!("It cannot be drawn without links that cross, and so not be built: {why}"))
    });
    let levers = Block::picture(
        picture(levers::scene(shown.gearbox, None, None))?,
        "Lever diagram: each set is a lever, the speed of each link a distance along its line.",
    );
    Ok(scheme.transpose()?.into_iter().chain(conflict).chain([levers]).collect())
}

/// Pictures of one gear, so far as its speeds and powers follow.
fn of_gear(shown: &Shown<'_>, place: usize) -> Result<Vec<Block>, Error> {
    let Some(gear) = shown.gears.get(place) else { return Ok(vec![]) };
    let (gearbox, options) = (shown.gearbox, scheme::Options::default());
    let drawn = shown.layout.as_deref().and_then(|layout| {
        let power = scheme::scene(gearbox, layout, Show::Power(gear), &options);
        let power =
            power.map(|scene| (scene, "Power through links and meshes as width of lines, with losses."));
        let engaged = || {
            let scene = scheme::scene(gearbox, layout, Show::Gear(gear), &options);
            scene.map(|scene| (scene, "Shift elements engaged, and links at rest."))
        };
        known(power).or_else(|| known(engaged()))
    });
    let plan = known(speeds::scene(gearbox, gear, None));
    let plan = plan.map(|scene| {
        scene.map(|scene| {
            (
                scene,
                "Speed diagram (Kutzbach): velocities over the radius, and the rays of the links' speeds.",
            )
        })
    });
    let all = drawn.into_iter().chain(plan);
    all.map(|drawn| drawn.map(|(scene, caption)| Block::picture(scene, caption))).collect()
}

/// Nothing where a gear does not say what a picture needs; every other fault is one.
fn known<T>(drawn: Result<T, epicyclic_pictures::gearbox::Error>) -> Option<Result<T, Error>> {
    use epicyclic_pictures::gearbox::Error;
    match drawn {
        Err(Error::SpeedsUnknown { .. } | Error::NoPower { .. }) => None,
        drawn => Some(picture(drawn)),
    }
}

fn picture<T>(drawn: Result<T, epicyclic_pictures::gearbox::Error>) -> Result<T, Error> {
    drawn.map_err(Error::Picture)
}

/// Efficiency, ratio and planet speed of each gear over the `k` of each set.
fn over_k(sets: &[OverK]) -> Result<Vec<Block>, Error> {
    let mut blocks = vec![Block::words(
        "What changes with the k of one set while the others stay as they are; gears that do not change are left out. Planet: speed of that set's planet relative to its carrier, \
         over the input's. The mark is this gearbox.",
    )];
    for set in sets {
        let across = format!("k of set {}", set.set);
        let ratios = curves(set, |gear| &gear.ratios, |ratio| ratio.abs() < GREATEST);
        let efficiencies = curves(set, |gear| &gear.efficiencies, |efficiency| efficiency > LEAST_EFFICIENCY);
        let planets = curves(set, |gear| &gear.planet_speeds_of_input, |speed| speed < GREATEST);
        let plots = [
            ("Ratio", "ratio i", ratios),
            ("Efficiency", "efficiency η", if set.has_losses { efficiencies } else { vec![] }),
            ("Planet", "planet relative to its carrier, × input", planets),
        ];
        for (title, up, curves) in plots.into_iter().filter(|(_, _, curves)| !curves.is_empty()) {
            let title = format!("{title} over k of set {}", set.set);
            let plot = Plot::new(&title, &across, up);
            let plot = curves.into_iter().fold(plot, Plot::with).mark("this gearbox", set.own_k);
            let scene = plot.scene().map_err(epicyclic_pictures::Error::from)?;
            blocks.push(Block::picture(scene, title));
        }
    }
    Ok(blocks)
}

/// A curve of each gear that changes with `k`, in the gear's colour.
fn curves(
    set: &OverK,
    values: fn(&GearOverK) -> &[Option<f64>],
    is_shown: impl Fn(f64) -> bool,
) -> Vec<Curve> {
    let curve = |(place, gear): (usize, &GearOverK)| {
        let value = |value: &Option<f64>| value.filter(|value| is_shown(*value)).unwrap_or(f64::NAN);
        let points = set.k.iter().zip(values(gear)).map(|(k, of)| [*k, value(of)]);
        Curve::new(format!("gear {}", gear.gear), points.collect()).colored(place)
    };
    set.gears.iter().enumerate().map(curve).filter(changes).collect()
}

/// Whether a curve is more than a level line.
fn changes(curve: &Curve) -> bool {
    let values = || curve.points.iter().map(|point| point[1]).filter(|value| value.is_finite());
    let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
    high - low > LEVEL * high.abs().max(1.0)
}
