//! The page of a gearbox: all gears, each gear in full, and what another `k` would change.

use super::paper::{PICTURE_MM, PLOT_MM};
use super::sheet::{Block, Section, Sheet};
use crate::figure::Figure;
use crate::report::{Part, Records, View};
use crate::tolerance::{CIRCULATES, LEVEL, RESTS};
use crate::{AsReport, Error, Report, drawability};
use epicyclic_answers::analyze::overview::Overview;
use epicyclic_answers::analyze::records::State;
use epicyclic_answers::report::gearbox::{GearOverK, GearboxReport, OverK, Shown};
use epicyclic_pictures::gearbox::scheme::{self, Show};
use epicyclic_pictures::gearbox::{ladder, levers, speeds};
use epicyclic_pictures::plot::{Curve, Plot};

/// Ratios and planet speeds from here on are left out of the curves: they would press all others flat.
const GREATEST: f64 = 20.0;
/// Efficiencies up to here are left out of the curves.
const LEAST_EFFICIENCY: f64 = 0.5;
/// Where the gearbox itself is further out, curves go on to so many times its own value.
const FURTHER: f64 = 1.25;

/// The gears and the scheme, then all gears, each gear in full, and what another `k` would change; `file` is the file as it was
/// written.
///
/// # Errors
/// [`Error::Picture`] for a gearbox that cannot be drawn.
pub fn sheet(report: &GearboxReport, shown: &Shown<'_>, file: String) -> Result<Sheet, Error> {
    let overview = &report.overview;
    let mut all = Report { warnings: None, ..overview.report() };
    let mut answer: Vec<Block> = gears_in_short(overview).into_iter().collect();
    answer.extend(scheme_of(shown)?);
    // What the page has said in short is not said again.
    all.title = None;
    let mut chapter = vec![Block::Answer(all)];
    if overview.gears.iter().any(|gear| gear.facts.ratio.is_some()) {
        let ladder = picture(ladder::bare(shown.gearbox, &shown.gears))?;
        chapter.push(Block::picture(ladder, "Ratios of all gears on a logarithmic scale, with their steps."));
    }
    chapter.push(Block::picture(
        picture(levers::bare(shown.gearbox, None))?,
        "Lever diagram: each set is a lever, the speeds of its links lie on a line across it. The numbers are distances along it; 1 is \
         from the carrier to the second central gear of its first set.",
    ));
    let mut sections = vec![Section::new("All gears", chapter).wide_last()];
    if let Some(shifts) = report.shifts.as_ref().filter(|shifts| !shifts.shifts.is_empty()) {
        let shifts = untold(shifts.report(), overview);
        sections.push(Section::new("Shifts", vec![Block::Answer(shifts)]).wide_last());
    }
    let mut gears: Vec<Report> = report.gears.iter().map(|gear| untold(gear.report(), overview)).collect();
    sections.push(notes_of(&mut gears));
    for (place, (gear, answer)) in report.gears.iter().zip(gears).enumerate() {
        let mut blocks = of_gear(shown, place)?;
        blocks.insert(blocks.len().min(1), Block::Answer(answer));
        sections.push(Section::new(format!("Gear {}", gear.gear.gear), blocks).wide_last());
    }
    if !report.over_k.is_empty() {
        sections.push(Section::new("Another k", over_k(&report.over_k)?));
    }
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
    let count = |count: usize, what: &str| format!("{count} {what}{}", if count == 1 { "" } else { "s" });
    Ok(Sheet {
        title: overview.gearbox.clone(),
        about: format!(
            "Planetary gearbox with {}, {} and {}",
            count(report.sets.len(), "set"),
            count(overview.shift_elements.len(), "shift element"),
            count(overview.gears.len(), "gear")
        ),
        answer,
        objections: objections(report),
        sections,
        input: file,
    })
}

/// The same without the warnings of a kind that the first page tells for all gears.
fn untold(mut report: Report, overview: &Overview) -> Report {
    let is_told = |name: &str| overview.warnings.iter().any(|told| told.name == name);
    if let Some(warnings) = &mut report.warnings {
        warnings.retain(|(name, _)| !is_told(name));
    }
    report
}

/// The gears in one table: engaged shift elements, ratios, steps, efficiencies, and what the output does.
fn gears_in_short(overview: &Overview) -> Option<Block> {
    let records = overview.report().parts.into_iter().find_map(|part| match part {
        Part::Records(records) if records.name == "gears" => Some(records),
        _ => None,
    })?;
    let at = &overview.operating_point;
    let is_loaded = at.torque_n_m.is_some() || at.power_w.is_some();
    let is_driven = overview.gears.iter().all(|gear| gear.facts.state == State::Driven);
    let columns = [
        ("gear", true),
        ("engaged", true),
        ("state", !is_driven),
        ("ratio", true),
        ("step", true),
        ("efficiency", overview.has_losses),
        ("output_speed", at.speed_rad_s.is_some()),
        ("output_torque", is_loaded),
    ];
    let columns: Vec<&'static str> =
        columns.into_iter().filter_map(|(name, is_shown)| is_shown.then_some(name)).collect();
    let mut note = String::from("i: input speed over output speed.");
    if is_loaded || at.speed_rad_s.is_some() {
        note += " rpm, N·m: of the output.";
    }
    let view = View { note, ..View::new("Gears", &columns) };
    let parts = vec![Part::Records(Records { views: vec![view], ..records })];
    Some(Block::Answer(Report { parts, ..Report::default() }))
}

/// What there is to object to: that it cannot be drawn, what the answers warn of, power that circulates.
fn objections(report: &GearboxReport) -> Vec<String> {
    let overview = &report.overview;
    let crossing = report.conflict.as_ref().map(|conflict| {
        let why = drawability::together(conflict);
        format!("it cannot be drawn without links that cross, and so not be built: {why}")
    });
    let mut all: Vec<String> = crossing.into_iter().collect();
    all.extend(overview.warnings.iter().map(|warning| warning.message.clone()));
    // Of each kind that the table of all gears has, it has those of every gear.
    let is_told = |name: &str| overview.warnings.iter().any(|told| told.name == name);
    for gear in &report.gears {
        let others = gear.warnings.iter().filter(|warning| !is_told(warning.name));
        all.extend(others.map(|warning| format!("gear {}: {}", gear.gear.gear, warning.message)));
    }
    let circulating = overview.gears.iter().filter_map(|gear| {
        // Where no planet turns on its pin the gearbox turns as a block, and no mesh passes the power on.
        let turns = gear.largest_planet_speed_of_input.is_none_or(|speed| speed > RESTS);
        let power = gear.circulating_of_entering.filter(|power| turns && *power > CIRCULATES)?;
        Some(format!("{} ({})", gear.facts.gear, Figure::Multiple(power).table()))
    });
    let circulating: Vec<String> = circulating.collect();
    if !circulating.is_empty() {
        let gears = if circulating.len() == 1 { "gear" } else { "gears" };
        all.push(format!("power circulates, over what enters, in {gears} {}", circulating.join(", ")));
    }
    all
}

/// What the drawings of a gear show.
const DRAWINGS: [&str; 2] = [
    "Drawings: a and b are the first and the second central gear of a set (its sun and ring), g and f its planets, H its carrier, each \
     with the number of the set.",
    "Speed diagram (Kutzbach): velocities over the radius, radii over that of the first central gear of the set; from a pole the rays \
     parallel to these lines, at their ends the speeds over the input's.",
];

/// What the drawings show, and the notes below the tables of all gears, each once; the tables keep none.
fn notes_of(gears: &mut [Report]) -> Section {
    let mut notes: Vec<String> = DRAWINGS.map(str::to_owned).to_vec();
    for (title, note) in gears.iter_mut().flat_map(Report::take_notes) {
        let note = format!("{title}: {note}");
        if !notes.contains(&note) {
            notes.push(note);
        }
    }
    Section::new("How to read drawings and tables of a gear", vec![Block::List(notes)])
}

/// The scheme.
fn scheme_of(shown: &Shown<'_>) -> Result<Option<Block>, Error> {
    let Some(layout) = shown.layout.as_deref() else { return Ok(None) };
    let scene = scheme::narrow(shown.gearbox, layout, Show::Structure, PICTURE_MM[0]);
    Ok(Some(Block::picture(picture(scene)?, "Kinematic scheme, the half above the axis.")))
}

/// Pictures of one gear, so far as its speeds and powers follow.
fn of_gear(shown: &Shown<'_>, place: usize) -> Result<Vec<Block>, Error> {
    let Some(gear) = shown.gears.get(place) else { return Ok(vec![]) };
    let (gearbox, [column_mm, page_mm]) = (shown.gearbox, PICTURE_MM);
    let drawn = shown.layout.as_deref().and_then(|layout| {
        let power = scheme::narrow(gearbox, layout, Show::Power(gear), column_mm);
        let power =
            power.map(|scene| (scene, "Power through links and meshes as width of lines, with losses."));
        let engaged = || {
            let scene = scheme::narrow(gearbox, layout, Show::Gear(gear), column_mm);
            scene.map(|scene| (scene, "Shift elements engaged, and links at rest."))
        };
        known(power).or_else(|| known(engaged()))
    });
    let plan = known(speeds::narrow(gearbox, gear, page_mm));
    let plan = plan.map(|scene| scene.map(|scene| (scene, "Speed diagram.")));
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
        let small = |value: f64, own: f64| value.abs() < GREATEST.max(FURTHER * own.abs());
        let ratios = curves(set, |gear| &gear.ratios, small);
        let efficiencies =
            curves(set, |gear| &gear.efficiencies, |value, own| value > LEAST_EFFICIENCY.min(own / FURTHER));
        let planets = curves(set, |gear| &gear.planet_speeds_of_input, small);
        let plots = [
            ("Ratio", "ratio i", ratios),
            ("Efficiency", "efficiency η", if set.has_losses { efficiencies } else { vec![] }),
            ("Planet", "planet relative to its carrier, × input", planets),
        ];
        for (title, up, curves) in plots.into_iter().filter(|(_, _, curves)| !curves.is_empty()) {
            let title = format!("{title} over k of set {}", set.set);
            let plot = Plot::new(&title, &across, up).sized(PLOT_MM);
            let plot = curves.into_iter().fold(plot, Plot::with).mark("this gearbox", set.own_k);
            let scene = plot.scene().map_err(epicyclic_pictures::Error::from)?;
            blocks.push(Block::picture(scene, format!("{title}.")));
        }
    }
    Ok(blocks)
}

/// A curve of each gear that changes with `k`, in the gear's colour; `is_shown` judges a value beside the gearbox's own.
fn curves(
    set: &OverK,
    values: fn(&GearOverK) -> &[Option<f64>],
    is_shown: impl Fn(f64, f64) -> bool,
) -> Vec<Curve> {
    let own = set.k.iter().position(|k| *k == set.own_k);
    let curve = |(place, gear): (usize, &GearOverK)| {
        let own = own.and_then(|own| values(gear)[own]).unwrap_or(0.0);
        let value = |value: &Option<f64>| value.filter(|value| is_shown(*value, own)).unwrap_or(f64::NAN);
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
