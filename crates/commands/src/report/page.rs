//! Page of a gearbox: all gears, each gear in full, and the effect of another `k`.

use super::side_by_side;
use crate::analyze::answer::gear::OneGear;
use crate::analyze::answer::overview::Overview;
use crate::analyze::answer::records::{Kind, State};
use crate::analyze::answer::warnings::state_in_words;
use crate::analyze::table::{overview, sets};
use crate::losses::answer::LossKind;
use crate::losses::table as losses;
use crate::page::paper::{PICTURE_MM, SMALL_PLOT_MM};
use crate::page::sheet::{Arrangement, Block, Section, Sheet};
use crate::report::answer::gearbox::{GearOverK, GearboxReport, OverK, Shown};
use crate::report::table::{asked_duty, sizes};
use crate::shared::drawability::table as drawability;
use crate::shared::judgement::table as judgement;
use crate::sheet::table as sheet;
use crate::strength::page as strength;
use crate::table::figure::Figure;
use crate::table::report::{AsReport, Report};
use crate::table::report::{Part, Records};
use crate::table::text::Error;
use crate::tolerance::{CIRCULATES, LEVEL, RESTS, SAME_RATIO};
use crate::vibrate::page as vibration;
use epicyclic_judge::Rule;
use epicyclic_pictures::gearbox::scheme::{self, Scale, Show};
use epicyclic_pictures::gearbox::{ladder, levers, speeds};
use epicyclic_pictures::plot::{Curve, Plot};
use epicyclic_units::Dimension;
use std::collections::BTreeSet;

/// Lower limit of ratios and planet speeds that are left out of the curves, because they would flatten all
/// others.
const GREATEST: f64 = 20.0;
/// Upper limit of efficiencies that are left out of the curves.
const LEAST_EFFICIENCY: f64 = 0.5;
/// Factor by which curves extend beyond the gearbox's own value if it lies outside these limits.
const FURTHER: f64 = 1.25;

/// Builds the page of a gearbox: gears and scheme, all gears, each gear in full, and the effect of another
/// `k`. The argument `scale` is that of a layout to scale, `file` the text of the file.
///
/// # Errors
/// [`Error::Picture`] for a gearbox that cannot be drawn.
pub fn sheet(
    report: &GearboxReport,
    shown: &Shown<'_>,
    scale: Option<&Scale>,
    file: String,
) -> Result<Sheet, Error> {
    let overview = &report.overview;
    let mut answer = vec![Block::Answer(of_records(overview::in_short(overview)))];
    if let Some(duty) = &report.duty {
        answer.push(Block::Answer(of_records(asked_duty(duty))));
    }
    answer.extend(scheme_of(shown, scale)?);
    answer.push(Block::Answer(of_records(sets::records(&overview.sets))));
    if !report.sizes.is_empty() {
        answer.push(Block::Answer(of_records(sizes(&report.sizes))));
    }
    answer.push(Block::words(operating_point(overview, report.duty.is_some())));
    answer.extend(strength::enough(&report.strength).map(Block::Words));
    answer.extend(report.vibration.as_ref().and_then(vibration::in_short).map(Block::Words));
    let has_shifts = report.shifts.as_ref().is_some_and(|shifts| !shifts.shifts.is_empty());
    let parts = overview::chapter(overview, !has_shifts);
    let mut chapter = vec![Block::Answer(Report { parts, ..Report::default() })];
    // A diagram of ratios needs at least two.
    if overview.gears.iter().filter(|gear| gear.facts.ratio.is_some()).count() > 1 {
        let ladder = picture(ladder::bare(shown.gearbox, &shown.gears))?;
        chapter.push(Block::picture(ladder, "Ratios of all gears on a logarithmic scale, with their steps."));
    }
    let mut sections = vec![Section::new("All gears", chapter).arranged(Arrangement::WideLast)];
    if let Some(shifts) = report.shifts.as_ref().filter(|_| has_shifts) {
        let shifts = Block::Answer(untold(shifts.report(), overview));
        sections.push(Section::new("Shifts", vec![shifts]).arranged(Arrangement::Rows));
    }
    let mut figures = vec![Block::Answer(side_by_side::report(&report.gears))];
    figures.extend(report.gears.iter().filter_map(patterns));
    sections.push(Section::new("Figures of every gear", figures).arranged(Arrangement::Rows));
    sections.extend(strength::sections(&report.strength));
    let judged = judgement::parts(&report.overview.judgement);
    if !judged.is_empty() {
        let review = Block::Answer(Report { parts: judged, ..Report::default() });
        sections.push(Section::new("Review by rules of practice", vec![review]).arranged(Arrangement::Rows));
    }
    if let Some(of_page) = &report.losses {
        let blocks = vec![Block::Answer(losses::for_page(of_page))];
        sections.push(Section::new("Losses at the operating point", blocks).arranged(Arrangement::Rows));
    }
    if let Some(sheets) = &report.sheets {
        let blocks = sheet::for_page(sheets).into_iter().map(Block::Answer).collect();
        sections.push(Section::new("Data sheets of the gears", blocks).arranged(Arrangement::Rows));
    }
    if let Some(of_sets) = &report.vibration {
        sections.extend(vibration::sections(of_sets)?);
    }
    sections.extend(drawings(report, shown, scale)?);
    if !report.over_k.is_empty() {
        let plots = over_k(&report.over_k)?;
        sections.push(Section::new("Another k", plots).arranged(Arrangement::Rows));
    }
    let is_rated = report.strength.iter().any(|one| one.governing.is_some());
    let mut left_out = vec![
        if report
            .losses
            .as_ref()
            .is_some_and(|losses| losses.losses.iter().any(|one| one.kind != LossKind::Mesh))
        {
            "Losses outside the meshes but for the drags that the file states."
        } else {
            "Losses outside the meshes: bearings, seals, churning oil, drag of open clutches and brakes."
        },
        if is_rated {
            strength::LEFT_OUT
        } else {
            "Profile shift and strength of teeth; uneven load of the planets."
        },
        "What happens while it shifts.",
    ];
    left_out.extend(report.vibration.as_ref().map(|_| vibration::LEFT_OUT));
    sections.push(Section::new(
        "What is left out",
        vec![Block::List(left_out.into_iter().map(str::to_owned).collect())],
    ));
    let theory = "Speeds by Willis' equation of each set, torques by their balance with the loss of each mesh on the side that \
                  its rolling power flows to; as in the document multispeed-gearboxes, chapters 1 and 2.";
    let strength =
        report.strength.first().map(|one| format!("Strength of teeth: {}, method B.", one.edition));
    let sources = overview.source.clone().into_iter().chain([theory.to_owned()]).chain(strength).collect();
    sections.push(Section::new("Sources", vec![Block::List(sources)]));
    Ok(Sheet {
        title: overview.gearbox.clone(),
        about: about(overview),
        answer,
        arrangement: Arrangement::Rows,
        objections: objections(report),
        sections,
        input: file,
    })
}

/// Describes the gearbox: `Planetary gearbox: 4 ratios and 1 reversed, 2 planet sets, 5 shift elements`.
fn about(overview: &Overview) -> String {
    let count = |count: usize, what: &str| format!("{count} {what}{}", if count == 1 { "" } else { "s" });
    let mut ratios: Vec<f64> = overview.gears.iter().filter_map(|gear| gear.facts.ratio).collect();
    ratios.sort_by(f64::total_cmp);
    ratios.dedup_by(|one, other| (*one - *other).abs() <= SAME_RATIO * other.abs());
    let reversed = ratios.iter().filter(|ratio| **ratio < 0.0).count();
    let ratios = match (ratios.len() - reversed, reversed) {
        (0, 0) => count(overview.gears.len(), "gear"),
        (0, reversed) => format!("{}, the output against the input", count(reversed, "ratio")),
        (ahead, 0) => count(ahead, "ratio"),
        (ahead, reversed) => format!("{} and {reversed} reversed", count(ahead, "ratio")),
    };
    let sets = match &overview.sets[..] {
        [only] if only.kind == Kind::Compound => "one compound planet set".to_owned(),
        sets => {
            let pairs = sets.iter().filter(|set| set.kind.is_pair()).count();
            let all = [(sets.len() - pairs, "planet set"), (pairs, "pair")];
            let all = all.into_iter().filter(|(of, _)| *of > 0).map(|(of, what)| count(of, what));
            all.collect::<Vec<_>>().join(", ")
        }
    };
    let elements = match overview.shift_elements.len() {
        0 => "no shift elements".to_owned(),
        elements => count(elements, "shift element"),
    };
    format!("Planetary gearbox: {ratios}, {sets}, {elements}")
}

/// Describes the given speed and load of the input.
fn operating_point(overview: &Overview, has_duty: bool) -> String {
    let at = &overview.operating_point;
    let of = |si: Option<f64>, dimension| Some(Figure::Quantity { si: si?, dimension }.table());
    let known = [
        of(at.speed_rad_s, Dimension::AngularSpeed),
        of(at.torque_n_m, Dimension::Torque),
        of(at.power_w, Dimension::Power),
    ];
    let known: Vec<String> = known.into_iter().flatten().collect();
    match (known.is_empty(), has_duty) {
        (true, true) => {
            "Other speeds, torques and powers of this page are over the input's; --input with --power or --torque gives them at one load."
                .to_owned()
        }
        (true, false) => {
            "No speed or load of the input is given: speeds, torques and powers are over the input's.".to_owned()
        }
        (false, _) => format!("At the input: {}.", known.join(", ")),
    }
}

/// Describes a gear in a line: `Gear 2: B2, FWD; i = 1.4667 = 22/15, η = 0.9774`.
fn in_words(gear: &OneGear) -> String {
    let facts = &gear.gear;
    let engaged = match &facts.engaged[..] {
        [] => String::new(),
        engaged => format!("{}; ", engaged.join(", ")),
    };
    let mut all = vec![];
    if let Some(ratio) = facts.ratio {
        let exact = facts.exact_ratio.map_or_else(String::new, |exact| format!(" = {exact}"));
        all.push(format!("i = {}{exact}", Figure::Multiple(ratio).table()));
    }
    if let Some(efficiency) = facts.efficiency.filter(|_| gear.has_losses) {
        all.push(format!("η = {}", Figure::Multiple(efficiency).table()));
    }
    if facts.state != State::Driven {
        all.push(state_in_words(facts));
    }
    format!("Gear {}: {engaged}{}", facts.gear, all.join(", "))
}

/// Table of sign patterns for a gear with several; otherwise `None`.
fn patterns(gear: &OneGear) -> Option<Block> {
    let parts = gear.report().parts.into_iter();
    let mut found = parts.filter_map(|part| match part {
        Part::Records(records) if records.name == "patterns" => Some(records),
        _ => None,
    });
    let mut records = found.next_back()?;
    for view in &mut records.views {
        view.title = format!("Gear {}: {}", gear.gear.gear, view.title);
    }
    Some(Block::Answer(of_records(records)))
}

fn of_records(records: Records) -> Report {
    Report { parts: vec![Part::Records(records)], ..Report::default() }
}

/// Removes warnings of the kinds that the first page already lists for all gears.
fn untold(mut report: Report, overview: &Overview) -> Report {
    let is_told = |name: &str| overview.warnings.iter().any(|told| told.name == name);
    if let Some(warnings) = &mut report.warnings {
        warnings.retain(|(name, _)| !is_told(name));
    }
    report
}

/// Objections to the gearbox: reasons why it cannot be drawn, warnings of the answers, circulating power.
fn objections(report: &GearboxReport) -> Vec<String> {
    let overview = &report.overview;
    let crossing = report.conflict.as_ref().map(|conflict| {
        let why = drawability::together(conflict);
        format!("it cannot be drawn without links that cross, and so not be built: {why}")
    });
    let mut all: Vec<String> = crossing.into_iter().collect();
    all.extend(overview.warnings.iter().map(|warning| warning.message.clone()));
    // A kind of warning in the table of all gears already covers every gear.
    let is_told = |name: &str| overview.warnings.iter().any(|told| told.name == name);
    for gear in &report.gears {
        let others = gear.warnings.iter().filter(|warning| !is_told(warning.name));
        all.extend(others.map(|warning| format!("gear {}: {}", gear.gear.gear, warning.message)));
    }
    let of_sheets = report.sheets.iter().flat_map(|sheets| &sheets.warnings);
    all.extend(of_sheets.filter(|warning| !is_told(warning.name)).map(|warning| warning.message.clone()));
    all.extend(strength::objections(&report.strength));
    // Safeties and lives have objections of their own.
    let own = [Rule::FlankSafety, Rule::RootSafety, Rule::BearingLife, Rule::CirculatingPower];
    all.extend(report.overview.judgement.warnings(&own).map(|warning| warning.message));
    if let Some(of_sets) = &report.vibration {
        all.extend(vibration::objections(of_sets, &report.gears));
    }
    let circulating = overview.gears.iter().filter_map(|gear| {
        // If no planet turns on its pin, the gearbox turns as a block and no mesh transmits power.
        let turns = gear.largest_planet_speed_of_input.is_none_or(|speed| speed > RESTS);
        let power = gear.circulating_of_entering.filter(|power| turns && *power > CIRCULATES)?;
        Some(format!("{} ({})", gear.facts.gear, Figure::Multiple(power).table()))
    });
    let circulating: Vec<String> = circulating.collect();
    if !circulating.is_empty() {
        let gears = if circulating.len() == 1 { "gear" } else { "gears" };
        all.push(format!("power circulates, over what enters, in {gears} {}", circulating.join(", ")));
    }
    // Data sheets and the review find the same faults of teeth.
    let mut told = BTreeSet::new();
    all.retain(|objection| told.insert(objection.clone()));
    all
}

/// Caption of the schemes of the gears.
const SCHEMES: &str = "Red: engaged. Grey: at rest. Blue: power as width of lines, with losses, the input's being that of the input shaft; orange: what \
                       of it circulates. a and b are the first and the second central gear of a set (its sun and ring), g and f its planets, H its \
                       carrier, each with the number of the set.";

/// Caption of the speed diagrams.
const DIAGRAMS: &str = "Speed diagrams (Kutzbach): velocities over the radius, radii over that of the first central gear of the set; from a pole the rays \
                        parallel to these lines, at their ends the speeds over the input's.";

/// Picture of the scheme; `None` if the gearbox cannot be drawn.
fn scheme_of(shown: &Shown<'_>, scale: Option<&Scale>) -> Result<Option<Block>, Error> {
    let Some(layout) = shown.layout.as_deref() else { return Ok(None) };
    let scene = scheme::narrow(shown.gearbox, layout, Show::Structure, scale, PICTURE_MM[0]);
    let words = match scale {
        None => "Kinematic scheme, the half above the axis.",
        Some(_) => {
            "Kinematic scheme, the half above the axis: gears at the heights of their pitch radii, lengths along the axis not to scale."
        }
    };
    Ok(Some(Block::picture(picture(scene)?, words)))
}

/// Schemes and speed diagrams of the gears with known speeds and powers.
fn drawings(report: &GearboxReport, shown: &Shown<'_>, scale: Option<&Scale>) -> Result<Vec<Section>, Error> {
    let (gearbox, [column_mm, page_mm]) = (shown.gearbox, PICTURE_MM);
    let (mut schemes, mut diagrams) = (vec![], vec![]);
    diagrams.push(Block::picture(
        picture(levers::bare(gearbox, None))?,
        "Lever diagram: each set is a lever, the speeds of its links lie on a line across it. The numbers are distances along it; 1 is \
         from the carrier to the second central gear of its first set.",
    ));
    for (gear, words) in shown.gears.iter().zip(report.gears.iter().map(in_words)) {
        let scheme = shown.layout.as_deref().and_then(|layout| {
            let drawn = |show| known(scheme::narrow(gearbox, layout, show, scale, column_mm));
            drawn(Show::Power(gear)).or_else(|| drawn(Show::Gear(gear)))
        });
        if let Some(scheme) = scheme {
            schemes.push(Block::picture(scheme?, words.clone()));
        }
        if let Some(diagram) = known(speeds::narrow(gearbox, gear, page_mm)) {
            diagrams.push(Block::picture(diagram?, words));
        }
    }
    let section = |heading, words, mut blocks: Vec<Block>| {
        blocks.insert(0, Block::words(words));
        Section::new(heading, blocks).arranged(Arrangement::Rows)
    };
    let all = [("Power flow of the gears", SCHEMES, schemes), ("Speeds of the gears", DIAGRAMS, diagrams)];
    let drawn = all.into_iter().filter(|(_, _, blocks)| !blocks.is_empty());
    Ok(drawn.map(|(heading, words, blocks)| section(heading, words, blocks)).collect())
}

/// Converts a drawing fault to `None` if the gear lacks data for the picture; other faults remain errors.
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

/// Plots of efficiency, ratio and planet speed of each gear over the `k` of each set.
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
            ("Planet", "planet, × input", planets),
        ];
        for (title, up, curves) in plots.into_iter().filter(|(_, _, curves)| !curves.is_empty()) {
            let title = format!("{title} over k of set {}", set.set);
            let plot = Plot::new(&title, &across, up).sized(SMALL_PLOT_MM).untitled();
            let plot = curves.into_iter().fold(plot, Plot::with).mark("this gearbox", set.own_k);
            let scene = plot.scene().map_err(epicyclic_pictures::Error::from)?;
            blocks.push(Block::picture(scene, format!("{title}.")));
        }
    }
    Ok(blocks)
}

/// Curves of the gears that change with `k`, in their colours; `is_shown` decides about a value by comparison
/// with the gearbox's own.
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

/// Whether a curve is not level.
fn changes(curve: &Curve) -> bool {
    let values = || curve.points.iter().map(|point| point[1]).filter(|value| value.is_finite());
    let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
    high - low > LEVEL * high.abs().max(1.0)
}
