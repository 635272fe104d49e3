//! The page of a gearbox: all gears, each gear in full, and what another `k` would change.

use super::sheet::{Block, Section, Sheet};
use crate::analyze::{Choice, Everything, Load, everything};
use crate::failure::Failure;
use epicyclic_formats::Document;
use epicyclic_pictures::gearbox::scheme::{self, Show};
use epicyclic_pictures::gearbox::{ladder, levers, speeds};
use epicyclic_pictures::plot::{Curve, Plot};
use epicyclic_schemes::drawability::{self, Layout, Verdict};
use epicyclic_schemes::row::{Gearing, RowKind, RowSpec};
use epicyclic_schemes::{Analysis, Gearbox};

/// Places in a range of `k`.
const PLACES: u32 = 60;

pub(super) fn sheet(
    choice: &Choice,
    document: &Document,
    load: &Load,
    text: String,
) -> Result<Sheet, Failure> {
    let Everything { subject, overview, gears } = everything(choice, document, load)?;
    let gearbox = &subject.gearbox;
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
    let (mut sections, last) = match subject.source {
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
    let theory = "Speeds by Willis' equation of each row, torques by their balance with each row's loss on the side its relative \
                  power flows to; as in the document multispeed-gearboxes, chapters 1 and 2.";
    let sources = subject.source.iter().cloned().chain([theory.to_owned()]).collect();
    sections.push(Section::new("Sources", vec![Block::List(sources)]));
    sections.extend(last);
    let count = |count: usize, what: &str| format!("{count} {what}{}", if count == 1 { "" } else { "s" });
    Ok(Sheet {
        title: gearbox.name().to_owned(),
        about: format!(
            "Planetary gearbox with {}, {} and {}",
            count(gearbox.rows().len(), "row"),
            count(gearbox.controls().len(), "control"),
            count(gearbox.gears().len(), "gear")
        ),
        sections,
    })
}

/// The scheme and its levers.
fn structure(gearbox: &Gearbox, layout: &Result<Box<Layout>, String>) -> Result<Vec<Block>, Failure> {
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
        Block::picture(levers, "Rows as levers: the speed of each link is a distance along its line."),
    ])
}

/// Pictures of one gear, so far as its speeds and powers follow.
fn of_gear(gearbox: &Gearbox, gear: &Analysis, layout: Option<&Layout>) -> Result<Vec<Block>, Failure> {
    let options = scheme::Options::default();
    let drawn = layout.and_then(|layout| {
        let power = scheme::scene(gearbox, layout, Show::Power(gear), &options);
        let power =
            power.map(|scene| (scene, "Power through links and meshes as width of lines, with losses."));
        let engaged = || {
            let scene = scheme::scene(gearbox, layout, Show::Gear(gear), &options);
            scene.map(|scene| (scene, "What is engaged, and what rests."))
        };
        known(power).or_else(|| known(engaged()))
    });
    let plan = known(speeds::scene(gearbox, gear, None));
    let plan = plan.map(|scene| {
        scene.map(|scene| {
            (scene, "Speed plan: velocities over the radius, and the rays of the links' speeds.")
        })
    });
    let all = drawn.into_iter().chain(plan);
    all.map(|drawn| drawn.map(|(scene, caption)| Block::picture(scene, caption))).collect()
}

/// Nothing where a gear does not say what a picture needs; every other fault is one.
fn known<T>(drawn: Result<T, epicyclic_pictures::gearbox::Error>) -> Option<Result<T, Failure>> {
    use epicyclic_pictures::gearbox::Error;
    match drawn {
        Err(Error::SpeedsUnknown { .. } | Error::NoPower { .. }) => None,
        drawn => Some(picture(drawn)),
    }
}

fn picture<T>(drawn: Result<T, epicyclic_pictures::gearbox::Error>) -> Result<T, Failure> {
    drawn.map_err(Failure::from)
}

/// Efficiency, ratio and planet speed of each gear over the `k` of each row.
fn over_k(gearbox: &Gearbox) -> Result<Vec<Block>, Failure> {
    let mut blocks = vec![Block::words(
        "What changes with the k of one row while the others stay as they are; gears that do not change are left out. Planet: speed of that row's planet on its carrier, \
         over the input's. The mark is this gearbox.",
    )];
    let rows = gearbox.rows().iter().enumerate().filter(|(_, row)| !row.spec().kind.is_pair());
    for (place, row) in rows {
        let k = row.stationary_ratio().get().abs();
        let studied = study(gearbox, place, range(row.spec().kind, k));
        let across = format!("k of row {}", row.id());
        let has_losses = row.spec().loss.row_efficiency().get() < 1.0;
        let plots = [
            ("Ratio", "ratio i", Some(&studied.ratios)),
            ("Efficiency", "efficiency η", has_losses.then_some(&studied.efficiencies)),
            ("Planet", "planet on its carrier, × input", Some(&studied.planets)),
        ];
        for (title, up, curves) in plots {
            let Some(curves) = curves.filter(|curves| !curves.is_empty()) else { continue };
            let title = format!("{title} over k of row {}", row.id());
            let plot = curves
                .iter()
                .cloned()
                .fold(Plot::new(&title, &across, up), Plot::with)
                .mark("this gearbox", k);
            let scene = plot.scene().map_err(Failure::from)?;
            blocks.push(Block::picture(scene, title));
        }
    }
    Ok(blocks)
}

/// The `k` to look at: those usual for a row with sun and ring, and its own.
fn range(kind: RowKind, k: f64) -> [f64; 2] {
    match kind {
        RowKind::Simple => [k.min(1.5), k.max(4.5)],
        _ => [0.6 * k, 1.6 * k],
    }
}

/// Curves of the gears that change with `k`.
struct Study {
    ratios: Vec<Curve>,
    efficiencies: Vec<Curve>,
    planets: Vec<Curve>,
}

fn study(gearbox: &Gearbox, row: usize, [low, high]: [f64; 2]) -> Study {
    // Each sample is analysed once for all its curves.
    let analyses = |k: f64| -> Vec<Option<Analysis>> {
        let other = with_k(gearbox, row, k);
        let gears = gearbox.gears().iter();
        gears.map(|gear| other.as_ref()?.analyze(gear.name()).ok()).collect()
    };
    let samples: Vec<(f64, Vec<Option<Analysis>>)> = (0..=PLACES)
        .map(|i| low + (high - low) * f64::from(i) / f64::from(PLACES))
        .map(|k| (k, analyses(k)))
        .collect();
    let curves = |value: &dyn Fn(&Analysis) -> Option<f64>| {
        let curve = |(place, gear): (usize, &epicyclic_schemes::Gear)| {
            let at = |(k, gears): &(f64, Vec<Option<Analysis>>)| {
                [*k, gears[place].as_ref().and_then(value).unwrap_or(f64::NAN)]
            };
            Curve::new(format!("gear {}", gear.name()), samples.iter().map(at).collect()).colored(place)
        };
        let all = gearbox.gears().iter().enumerate().map(curve);
        all.filter(changes).collect::<Vec<_>>()
    };
    Study {
        ratios: curves(&|analysis| analysis.ratio().filter(|ratio| ratio.abs() < 20.0)),
        efficiencies: curves(&|analysis| analysis.efficiency().filter(|efficiency| *efficiency > 0.5)),
        planets: curves(&|analysis| {
            let planets = analysis.rows().get(row)?.planets.iter();
            planets.map(|planet| planet.relative.abs()).reduce(f64::max).filter(|speed| *speed < 20.0)
        }),
    }
}

/// Whether a curve is more than a level line.
fn changes(curve: &Curve) -> bool {
    let values = || curve.points.iter().map(|point| point[1]).filter(|value| value.is_finite());
    let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
    high - low > 1e-9 * high.abs().max(1.0)
}

/// The gearbox with another `k` of one row; `None` where that is no row.
fn with_k(gearbox: &Gearbox, row: usize, k: f64) -> Option<Gearbox> {
    let id = gearbox.rows()[row].id().to_owned();
    let change = |spec: RowSpec| {
        if spec.id == id {
            RowSpec { gearing: Gearing::Parameter(k), planet: None, second_planet: None, ..spec }
        } else {
            spec
        }
    };
    gearbox.to_builder().map_rows(change).build().ok()
}
