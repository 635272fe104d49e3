//! Answers, tables and pictures of a gearbox file and a gear.

use crate::reply::{Failure, json, object, refuse, refused, text, told};
use crate::{documents, layouts};
use epicyclic_commands::adjust::AdjustableNumber;
use epicyclic_commands::analyze::answer as analyze;
use epicyclic_commands::analyze::answer::Input;
use epicyclic_commands::analyze::request::{self, overview};
use epicyclic_commands::shared::drawability::table as drawability;
use epicyclic_commands::shared::gearbox::{Choice, Content, Gearbox, read};
use epicyclic_commands::shared::transmissions::answer as transmissions;
use epicyclic_commands::table::report::AsReport as _;
use epicyclic_commands::{adjust, front as from_the_front};
use epicyclic_drawing::{Scene, svg};
use epicyclic_formats::Position;
use epicyclic_formats::gearbox::written;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_layout::Verdict;
use epicyclic_pictures::gearbox::{ladder, levers, scheme as schemes, speeds};
use epicyclic_schemes::catalogue::Scheme;
use epicyclic_train::{self as train, Analysis, InputLoad};
use epicyclic_units::{Number, Physical, Quantity};
use serde::Deserialize;
use std::cmp::Reverse;
use uom::si::f64::Ratio;

/// Name of the file in messages.
const NAME: &str = "gearbox.yaml";

/// Question about a file, as the app sends it.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Question {
    /// One transmission of a list.
    transmission: Option<String>,
    /// One gear in full; the pictures are of it.
    gear: Option<String>,
    /// Speed of the input, as it was typed.
    speed: Option<String>,
    /// Torque on the input.
    torque: Option<String>,
    /// Efficiency of sets for which the file states no losses.
    efficiency: Option<String>,
    /// The pictures that are shown.
    #[serde(default)]
    pictures: Vec<Picture>,
    /// Whether tables are shown.
    #[serde(default)]
    tables: bool,
    /// Whether the transmissions of a list are named beside the one that is meant.
    #[serde(default)]
    list: bool,
    /// The gears in tables, too.
    #[serde(default)]
    gear_tables: bool,
}

/// A picture of a gearbox.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Picture {
    Scheme,
    Power,
    Speeds,
    Levers,
    Ladder,
}

impl Picture {
    const fn name(self) -> &'static str {
        match self {
            Self::Scheme => "scheme",
            Self::Power => "power",
            Self::Speeds => "speeds",
            Self::Levers => "levers",
            Self::Ladder => "ladder",
        }
    }
}

impl Question {
    fn read(question: &str) -> Result<Self, Failure> {
        serde_json::from_str(question).map_err(|error| refuse("question", error.to_string()))
    }

    fn choice(&self) -> Result<Choice, Failure> {
        let efficiency = typed::<Ratio>("efficiency", self.efficiency.as_deref())?
            .map(|efficiency| MeshEfficiency::new(efficiency.value));
        let efficiency = efficiency.transpose().map_err(|error| refuse("efficiency", error.to_string()))?;
        Ok(Choice { transmission: self.transmission.clone(), efficiency })
    }

    fn input(&self) -> Result<Input, Failure> {
        let load = typed("torque", self.torque.as_deref())?.map(InputLoad::Torque);
        Ok(Input { speed: typed("speed", self.speed.as_deref())?, load })
    }
}

/// A quantity as it was typed into a field; of what is none the refusal names the field.
fn typed<Q: Physical>(field: &str, text: Option<&str>) -> Result<Option<Q>, Failure> {
    let read = |text: &str| {
        let quantity: Result<Quantity<Q>, _> = text.parse();
        quantity.map(|quantity| quantity.0).map_err(|error| refuse(error.name(), format!("{field}: {error}")))
    };
    text.map(read).transpose()
}

/// Reads the selected gearbox of the file and answers with `done`, or a list of its transmissions with
/// `several`.
fn with<T>(
    file: &str,
    question: &Question,
    done: impl FnOnce(&Gearbox) -> Result<T, Failure>,
    several: impl FnOnce(&transmissions::Transmissions) -> Result<T, Failure>,
) -> Result<T, Failure> {
    let document = documents::of(NAME, file)?;
    match read(&document, &question.choice()?).map_err(refused)? {
        Content::One(subject) => done(&subject),
        Content::Several(all) => several(&transmissions::answer(&all)),
    }
}

/// Answers, tables and pictures.
pub(crate) fn look(file: &str, question: &str) -> Result<String, Failure> {
    let question = Question::read(question)?;
    let several = |all: &transmissions::Transmissions| Ok(object(&[("transmissions", json(all)?)]));
    with(file, &question, |subject| of_one(subject, &question), several)
}

fn of_one(subject: &Gearbox, question: &Question) -> Result<String, Failure> {
    let overview = overview(subject, question.input()?, None).map_err(refused)?;
    let mut parts = vec![("analyze", json(&overview)?), ("adjust", json(&adjust::answer(subject))?)];
    if question.list
        && let Content::Several(all) = all_of(subject)?
    {
        parts.push(("transmissions", json(&transmissions::answer(&all))?));
    }
    if question.tables {
        parts.push(("tables", text(&overview.report().html())));
    }
    if let Some(gear) = &question.gear {
        if subject.has_inputs(gear) {
            let wanted = analyze::inputs::Wanted::default();
            let answer = request::inputs(subject, gear, &wanted).map_err(refused)?;
            parts.push(("inputs", json(&answer)?));
            if question.gear_tables {
                parts.push(("gear_tables", text(&answer.report().html())));
            }
        } else {
            let answer = request::gear(subject, gear, question.input()?).map_err(refused)?;
            parts.push(("gear", json(&answer)?));
            if question.gear_tables {
                parts.push(("gear_tables", text(&answer.report().html())));
            }
        }
    }
    let gearbox = &subject.train;
    let gear =
        question.gear.as_deref().map(|gear| analyze::analysis(gearbox, gear)).transpose().map_err(refused)?;
    let pictures: Vec<(&str, String)> = question
        .pictures
        .iter()
        .map(|&picture| (picture.name(), drawn(picture, gearbox, gear.as_ref())))
        .collect();
    parts.push(("pictures", object(&pictures)));
    Ok(object(&parts))
}

/// The transmissions of a list; of another file the one gearbox.
fn all_of(subject: &Gearbox) -> Result<Content, Failure> {
    if subject.document.value().get("transmissions").is_none() {
        return Ok(Content::Several(vec![]));
    }
    read(&subject.document, &Choice::default()).map_err(refused)
}

/// Picture as SVG in JSON; where it cannot be drawn, the message that gives the reason.
fn drawn(picture: Picture, gearbox: &train::Gearbox, gear: Option<&Analysis<'_>>) -> String {
    let scene =
        scene(picture, gearbox, gear).and_then(|scene| svg::write(&scene).map_err(|error| error.to_string()));
    match scene {
        Ok(svg) => object(&[("svg", text(&svg))]),
        Err(message) => object(&[("message", text(&message))]),
    }
}

fn scene(picture: Picture, gearbox: &train::Gearbox, gear: Option<&Analysis<'_>>) -> Result<Scene, String> {
    let drawn = match picture {
        Picture::Scheme | Picture::Power => {
            let verdict = layouts::of(gearbox);
            let layout = match &*verdict {
                Verdict::Drawable(layout) => layout,
                Verdict::SelfCrossing(witness) => {
                    let conflict =
                        epicyclic_commands::shared::drawability::answer::Conflict::of(gearbox, witness);
                    return Err(format!(
                        "{} {}",
                        drawability::together(&conflict),
                        drawability::shut_in(&conflict)
                    ));
                }
            };
            let show = match gear {
                None => schemes::Show::Structure,
                Some(gear) if picture == Picture::Power => schemes::Show::Power(gear),
                Some(gear) => schemes::Show::Gear(gear),
            };
            let options = schemes::Options { gearing: true, ..schemes::Options::default() };
            schemes::scene(gearbox, layout, show, &options)
        }
        Picture::Speeds => match gear {
            Some(gear) => speeds::scene(gearbox, gear, None),
            None => return Err("A speed diagram shows one gear: choose one.".to_owned()),
        },
        Picture::Levers => levers::scene(gearbox, gear, None),
        Picture::Ladder => {
            let gears: Result<Vec<_>, _> =
                gearbox.gears().iter().map(|gear| gearbox.analyze_gear(gear)).collect();
            ladder::scene(gearbox, &gears.map_err(|error| error.to_string())?, None)
        }
    };
    drawn.map_err(|error| error.to_string())
}

/// The sets from the front.
pub(crate) fn front(file: &str, question: &str) -> Result<String, Failure> {
    let question = Question::read(question)?;
    let one = |subject: &Gearbox| {
        json(&from_the_front::answer(subject, question.gear.as_deref()).map_err(refused)?)
    };
    with(file, &question, one, |_| Err(several()))
}

/// Another number at one of the places that can be changed.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Change {
    /// Position of a number that `adjust` has named in this file.
    number: AdjustableNumber,
    to: String,
}

/// The file with other numbers, and what it looks like then: answers, or why there are none.
pub(crate) fn adjusted(file: &str, question: &str, changes: &str) -> Result<String, Failure> {
    let mut changes: Vec<Change> =
        serde_json::from_str(changes).map_err(|error| refuse("changes", error.to_string()))?;
    for Change { number: AdjustableNumber { set, of, .. }, to } in &mut changes {
        // Text that is no number would change how the file is read: `k: 2,94` is two entries.
        let read: Result<Number, _> = to.parse();
        read.map_err(|error| refuse(error.name(), format!("set {set}, {}: {error}", of.name())))?;
        *to = to.trim().to_owned();
    }
    // The last change of the file comes first, so that the others keep their positions.
    changes.sort_by_key(|Change { number, .. }| Reverse((number.line, number.column)));
    let mut new = file.to_owned();
    for Change { number, to } in &changes {
        new = adjust::changed(&new, number, to).ok_or_else(|| refuse("place", "it stands elsewhere"))?;
    }
    let place = |number: &AdjustableNumber| Position { line: number.line, column: number.column };
    let numbers: Vec<_> = changes.iter().map(|Change { number, to }| (place(number), &**to)).collect();
    documents::take_over(NAME, file, &new, &numbers);
    Ok(object(&[("file", text(&new)), ("look", told(look(&new, question)))]))
}

fn several() -> Failure {
    refuse("several-transmissions", "the file has several transmissions; choose one")
}

/// The file of a scheme of the catalogue.
pub(crate) fn scheme(name: &str, k1: f64, k2: f64) -> Result<String, Failure> {
    let scheme: Scheme =
        name.parse().map_err(|error: epicyclic_schemes::Error| refuse("scheme", error.to_string()))?;
    let k2 = matches!(scheme, Scheme::Three(_)).then_some(k2);
    let sizes = epicyclic_commands::schemes::answer::Sizes { k1: Some(k1), k2, ..Default::default() };
    let found =
        epicyclic_commands::schemes::answer::sized(scheme, sizes, MeshEfficiency::IDEAL).map_err(refused)?;
    let found = found.ok_or_else(|| refuse("scheme", "its sizes are missing"))?;
    let file = written(&found.gearbox, &[]).map_err(|error| refuse("scheme", error.to_string()))?;
    Ok(object(&[("file", text(&file))]))
}
