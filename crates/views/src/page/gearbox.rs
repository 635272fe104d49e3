//! The page of a gearbox: all gears, each gear in full, and what another `k` would change.

use super::sheet::{Block, Section, Sheet};
use crate::tolerance::LEVEL;
use crate::{Error, Report};
use epicyclic_layout as drawability;
use epicyclic_layout::{Layout, Verdict};
use epicyclic_pictures::gearbox::scheme::{self, Show};
use epicyclic_pictures::gearbox::{ladder, levers, speeds};
use epicyclic_pictures::plot::{Curve, Plot};
use epicyclic_train::set::{Gearing, SetKind, SetSpec};
use epicyclic_train::{Analysis, Gearbox};

/// Places in a range of `k`, at most and at least.
const PLACES: [u32; 2] = [60, 12];
/// Analyses of gears for all ranges of `k` together: beyond it the places are fewer, so that a page takes seconds.
const ANALYSES: usize = 6000;

/// A gearbox with the answers that its page shows.
#[derive(Debug)]
pub struct Pages<'a> {
    /// The gearbox.
    pub gearbox: &'a Gearbox,
    /// Where its figures come from, where its file says so.
    pub source: Option<String>,
    /// All gears.
    pub overview: Report,
    /// Each gear, in their order.
    pub gears: Vec<Report>,
}

/// All gears, each gear in full, and what another `k` would change; `text` is the file.
///
/// # Errors
/// [`Error::Gearbox`] for a gear that cannot be analysed, [`Error::Picture`] for a gearbox that cannot be drawn.
pub fn sheet(pages: Pages<'_>, text: String) -> Result<Sheet, Error> {
    let Pages { gearbox, source, overview, gears } = pages;
    let analyses = gearbox
        .gears()
        .iter()
        .map(|gear| gearbox.analyze(gear.name()))
        .collect::<Result<Vec<Analysis>, _>>()?;
    let layout = match drawability::draw(gearbox, drawability::Options::default()) {
        Verdict::Drawable(layout) => Ok(layout),
        Verdict::SelfCrossing(witness) => Err(witness.describe(gearbox)),
    };
    let input = Section::new("Input", vec![Block::File(text)]);
    let drawing = Section::new("Drawing", structure(gearbox, &layout)?);
    // A list of transmissions is long and mostly about others: it stands last.
    let (mut sections, last) = match &source {
        None => (vec![input, drawing], None),
        Some(_) => (vec![drawing], Some(input)),
    };
    let mut all = vec![Block::Answer(overview)];
    if analyses.iter().any(|gear| gear.ratio().is_some()) {
        let ladder = picture(ladder::scene(gearbox, &analyses, None))?;
        all.push(Block::picture(ladder, "Ratios of all gears on a logarithmic scale, with their steps."));
    }
    sections.push(Section::new("Gears", all));
    for (gear, report) in analyses.iter().zip(gears) {
        let mut blocks = of_gear(gearbox, gear, layout.as_deref().ok())?;
        blocks.push(Block::Answer(report));
        sections.push(Section::new(format!("Gear {}", gear.gear().name()), blocks));
    }
    sections.push(Section::new("Another k", over_k(gearbox)?));
    let left_out = [
        "Losses outside the meshes: bearings, seals, churning oil, drag of open clutches and brakes.",
        "Profile shift and strength of teeth; uneven load of the planets.",
        "What happens while it shifts.",
    ];
    sections.push(Section::new("What is left out", vec![Block::List(left_out.map(str::to_owned).to_vec())]));
    let theory = "Speeds by Willis' equation of each set, torques by their balance with the loss of each mesh on the side that \
                  its rolling power flows to; as in the document multispeed-gearboxes, chapters 1 and 2.";
    let sources = source.into_iter().chain([theory.to_owned()]).collect();
    sections.push(Section::new("Sources", vec![Block::List(sources)]));
    sections.extend(last);
    let count = |count: usize, what: &str| format!("{count} {what}{}", if count == 1 { "" } else { "s" });
    Ok(Sheet {
        title: gearbox.name().to_owned(),
        about: format!(
            "Planetary gearbox with {}, {} and {}",
            count(gearbox.sets().len(), "set"),
            count(gearbox.shift_elements().len(), "shift element"),
            count(gearbox.gears().len(), "gear")
        ),
        sections,
    })
}

/// The scheme and its levers.
fn structure(gearbox: &Gearbox, layout: &Result<Box<Layout>, String>) -> Result<Vec<Block>, Error> {
    let scheme = match layout {
        Ok(layout) => {
            let drawn = scheme::scene(gearbox, layout, Show::Structure, &scheme::Options::default());
            Block::picture(picture(drawn)?, "Kinematic scheme, the half above the axis.")
        }
        Err(why) => {
            Block::words(format!("It cannot be drawn without links that cross, and so not be built: {why}"))
        }
    };
    let levers = picture(levers::scene(gearbox, None, None))?;
    Ok(vec![
        scheme,
        Block::picture(
            levers,
            "Lever diagram: each set is a lever, the speed of each link a distance along its line.",
        ),
    ])
}

/// Pictures of one gear, so far as its speeds and powers follow.
fn of_gear(gearbox: &Gearbox, gear: &Analysis, layout: Option<&Layout>) -> Result<Vec<Block>, Error> {
    let options = scheme::Options::default();
    let drawn = layout.and_then(|layout| {
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
fn over_k(gearbox: &Gearbox) -> Result<Vec<Block>, Error> {
    let mut blocks = vec![Block::words(
        "What changes with the k of one set while the others stay as they are; gears that do not change are left out. Planet: speed of that set's planet relative to its carrier, \
         over the input's. The mark is this gearbox.",
    )];
    // A set with more than two central gears has no one k.
    let sets = gearbox.sets().iter().enumerate().filter(|(_, set)| !set.is_pair());
    for (place, set) in sets {
        let Some(kind) = set.kind() else { continue };
        let k = set.basic_ratio().get().abs();
        let studied = study(gearbox, place, range(kind, k));
        let across = format!("k of set {}", set.id());
        let has_losses = set.has_losses();
        let plots = [
            ("Ratio", "ratio i", Some(&studied.ratios)),
            ("Efficiency", "efficiency η", has_losses.then_some(&studied.efficiencies)),
            ("Planet", "planet relative to its carrier, × input", Some(&studied.planets)),
        ];
        for (title, up, curves) in plots {
            let Some(curves) = curves.filter(|curves| !curves.is_empty()) else { continue };
            let title = format!("{title} over k of set {}", set.id());
            let plot = curves
                .iter()
                .cloned()
                .fold(Plot::new(&title, &across, up), Plot::with)
                .mark("this gearbox", k);
            let scene = plot.scene().map_err(epicyclic_pictures::Error::from)?;
            blocks.push(Block::picture(scene, title));
        }
    }
    Ok(blocks)
}

/// The `k` to look at: those usual for a set with sun and ring, and its own.
fn range(kind: SetKind, k: f64) -> [f64; 2] {
    match kind {
        SetKind::Simple => [k.min(1.5), k.max(4.5)],
        _ => [0.6 * k, 1.6 * k],
    }
}

/// Curves of the gears that change with `k`.
struct Study {
    ratios: Vec<Curve>,
    efficiencies: Vec<Curve>,
    planets: Vec<Curve>,
}

fn study(gearbox: &Gearbox, set: usize, [low, high]: [f64; 2]) -> Study {
    // Each sample is analysed once for all its curves: ratio, efficiency and planet speed of each gear.
    type Sample = Vec<[Option<f64>; 3]>;
    let of_gear = |other: &Gearbox, gear: &str| -> Option<[Option<f64>; 3]> {
        let analysis = other.analyze(gear).ok()?;
        let planets = analysis.sets().get(set)?.planets.iter().flatten();
        let fastest = planets.map(|planet| planet.relative.abs()).reduce(f64::max);
        Some([
            analysis.ratio().filter(|ratio| ratio.abs() < 20.0),
            analysis.efficiency().filter(|efficiency| *efficiency > 0.5),
            fastest.filter(|speed| *speed < 20.0),
        ])
    };
    let sample = |k: f64| -> Sample {
        let other = with_k(gearbox, set, k);
        let of = |gear: &epicyclic_train::Gear| of_gear(other.as_ref()?, gear.name());
        gearbox.gears().iter().map(|gear| of(gear).unwrap_or_default()).collect()
    };
    let [most, fewest] = PLACES;
    let each = ANALYSES / (gearbox.sets().len() * gearbox.gears().len()).max(1);
    let places = u32::try_from(each).unwrap_or(most).clamp(fewest, most);
    let samples: Vec<(f64, Sample)> = (0..=places)
        .map(|i| low + (high - low) * f64::from(i) / f64::from(places))
        .map(|k| (k, sample(k)))
        .collect();
    let curves = |value: usize| {
        let curve = |(place, gear): (usize, &epicyclic_train::Gear)| {
            let at = |(k, gears): &(f64, Sample)| [*k, gears[place][value].unwrap_or(f64::NAN)];
            Curve::new(format!("gear {}", gear.name()), samples.iter().map(at).collect()).colored(place)
        };
        let all = gearbox.gears().iter().enumerate().map(curve);
        all.filter(changes).collect::<Vec<_>>()
    };
    Study { ratios: curves(0), efficiencies: curves(1), planets: curves(2) }
}

/// Whether a curve is more than a level line.
fn changes(curve: &Curve) -> bool {
    let values = || curve.points.iter().map(|point| point[1]).filter(|value| value.is_finite());
    let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
    high - low > LEVEL * high.abs().max(1.0)
}

/// The gearbox with another `k` of one set; `None` where that is no set.
fn with_k(gearbox: &Gearbox, set: usize, k: f64) -> Option<Gearbox> {
    let id = gearbox.sets()[set].id().to_owned();
    let change = |spec: SetSpec| {
        if spec.id == id {
            SetSpec { gearing: Gearing::BasicRatio(k), planet: None, second_planet: None, ..spec }
        } else {
            spec
        }
    };
    gearbox.to_builder().map_sets(change).build().ok()
}
