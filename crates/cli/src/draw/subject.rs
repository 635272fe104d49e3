//! The gearbox that is drawn: a scheme of the catalogue, a structure of two sets, or one from a file.

use super::{Args, View};
use crate::analyze::{self, Choice};
use crate::failure::Failure;
use crate::input;
use crate::schemes::{SizeOptions, sized};
use epicyclic_answers::draw::{self as answers, Exchanged, Origin};
use epicyclic_formats::{self as formats, Document, Number};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_layout as drawability;
use epicyclic_layout::Verdict;
use epicyclic_schemes::Error as SchemeError;
use epicyclic_schemes::catalogue::Scheme;
use epicyclic_schemes::structures::{Renaming, Role, Structure};
use epicyclic_train::Gearbox;
use std::path::Path;

/// A gearbox, and whether its rows have known sizes.
pub(super) struct Subject {
    pub(super) gearbox: Gearbox,
    pub(super) gearing: bool,
    /// Its place in a file.
    pub(super) base: formats::Path,
    origin: Origin,
    /// What is named the other way round than in the gearbox of a structure.
    exchanged: Option<Exchanged>,
}

impl Subject {
    /// The gear of this name in the gearbox.
    pub(super) fn gear_name<'a>(&self, named: &'a str) -> &'a str {
        let is_exchanged = self.exchanged.is_some_and(|exchanged| exchanged.gears);
        match named {
            "1" if is_exchanged => "2",
            "2" if is_exchanged => "1",
            named => named,
        }
    }

    /// What an answer says of it.
    pub(super) fn record(&self) -> answers::Subject {
        answers::Subject::of_gearbox(&self.gearbox, self.origin, self.gearing, self.exchanged)
    }

    fn of_catalogue(gearbox: Gearbox, gearing: bool) -> Self {
        let (base, origin) = (formats::Path::root(), Origin::Catalogue);
        Self { gearbox, gearing, base, origin, exchanged: None }
    }
}

/// Ring-to-sun ratio of sets of which only the structure is drawn; it is not shown.
const ANY_K: f64 = 2.5;

/// Reads what is named.
pub(super) fn read(args: &Args, document: Option<&Document>) -> Result<Subject, Failure> {
    let file = Path::new(&args.gearbox);
    if let Some(document) = document {
        return from_file(args, file, document);
    }
    match (args.gearbox.parse::<Scheme>(), Structure::read(&args.gearbox)) {
        (Ok(scheme), _) => catalogue(args, scheme),
        (_, Ok((structure, renaming))) => of_two_sets(args, structure, renaming),
        // What looks like a name and is none: say which there are.
        (_, Err(unknown @ SchemeError::NotAStructure { .. })) => Err(unknown.into()),
        (_, Err(unknown)) if args.gearbox.contains('+') && !file.exists() => Err(unknown.into()),
        (Err(unknown), _) if file.extension().is_none() && file.components().count() == 1 => {
            Err(unknown.into())
        }
        _ => from_file(args, file, &input::document(file)?),
    }
}

fn catalogue(args: &Args, scheme: Scheme) -> Result<Subject, Failure> {
    let option = |option, message: String| Err(Failure::Option { option, message });
    if args.transmission.is_some() {
        return option("--transmission", "a scheme of the catalogue is one gearbox; leave it out".into());
    }
    let eta = match args.efficiency {
        Some(eta) => analyze::efficiency(eta)?,
        None => MeshEfficiency::IDEAL,
    };
    let sizes = SizeOptions { k1: args.k1, k2: args.k2, ratio1: args.ratio1, ratio2: args.ratio2 };
    if let Some(found) = sized(sizes, scheme, eta)? {
        return Ok(Subject::of_catalogue(found.gearbox, true));
    }
    if args.gear.is_some() || args.view.is_some_and(|view| view != View::Scheme) {
        let message = format!(
            "for speeds of {} give --k1 or --ratio1, and of two sets --k2 or --ratio2",
            scheme.name()
        );
        return option("--k1", message);
    }
    let any = |is_there: bool| is_there.then(|| Number::new(ANY_K).ok()).flatten();
    let sizes =
        SizeOptions { k1: any(true), k2: any(matches!(scheme, Scheme::Three(_))), ..SizeOptions::default() };
    match sized(sizes, scheme, eta)? {
        Some(found) => Ok(Subject::of_catalogue(found.gearbox, false)),
        None => option("--k1", "needed".into()),
    }
}

/// A structure by any of its names; the sizes are of the sets and gears as they are named.
fn of_two_sets(args: &Args, structure: Structure, renaming: Renaming) -> Result<Subject, Failure> {
    let option = |option, message: &str| Err(Failure::Option { option, message: message.to_owned() });
    if args.transmission.is_some() {
        return option("--transmission", "a structure is one gearbox; leave it out");
    }
    let number = |number: Option<Number>| number.map(Number::get);
    let exchanged = |pair: [Option<Number>; 2], exchanged: bool| {
        let [one, other] = pair.map(number);
        if exchanged { [other, one] } else { [one, other] }
    };
    let k = exchanged([args.k1, args.k2], renaming.sets);
    let ratios = exchanged([args.ratio1, args.ratio2], renaming.brakes);
    let k = match (k, ratios) {
        ([Some(k1), Some(k2)], _) => Some([k1, k2]),
        ([None, None], [Some(first), Some(second)]) => match structure.ring_to_sun_ratios([first, second]) {
            None => {
                return option(
                    "--ratio1",
                    "these ratios leave a set without relative motion: no k gives them",
                );
            }
            found => found,
        },
        ([None, None], [None, None]) => None,
        _ => return option("--k1", "a structure has two sets: give --k1 and --k2, or --ratio1 and --ratio2"),
    };
    if k.is_none() && (args.gear.is_some() || args.view.is_some_and(|view| view != View::Scheme)) {
        return option("--k1", "for speeds give --k1 and --k2, or --ratio1 and --ratio2");
    }
    let eta = args.efficiency.map_or(Ok(MeshEfficiency::IDEAL), analyze::efficiency)?;
    // The direct-drive clutch stands between the first two links that leave room for it, input and output before others.
    let roles = Role::ALL
        .iter()
        .flat_map(|&one| Role::ALL.map(|other| [one, other]))
        .filter(|[one, other]| one < other);
    let mut any = None;
    for pair in roles {
        let gearbox = structure.gearbox(k.unwrap_or([ANY_K; 2]), eta, pair)?;
        if matches!(drawability::draw(&gearbox, drawability::Options::default()), Verdict::Drawable(_)) {
            any = Some(gearbox);
            break;
        }
        any.get_or_insert(gearbox);
    }
    match any {
        Some(gearbox) => {
            let exchanged = Some(Exchanged { sets: renaming.sets, gears: renaming.brakes });
            let (base, origin) = (formats::Path::root(), Origin::Structure);
            Ok(Subject { gearbox, gearing: k.is_some(), base, origin, exchanged })
        }
        None => unreachable!("four roles have six pairs"),
    }
}

fn from_file(args: &Args, file: &Path, document: &Document) -> Result<Subject, Failure> {
    let sizes = [("--k1", args.k1), ("--k2", args.k2), ("--ratio1", args.ratio1), ("--ratio2", args.ratio2)];
    if let Some((option, _)) = sizes.into_iter().find(|(_, size)| size.is_some()) {
        let message = "it is for schemes of the catalogue; the file says how large its rows are".to_owned();
        return Err(Failure::Option { option, message });
    }
    let choice = Choice::new(file.to_owned(), args.transmission.clone(), args.efficiency);
    let epicyclic_answers::gearbox::Subject { gearbox, base, .. } = analyze::subject(&choice, document)?;
    Ok(Subject { gearbox, gearing: true, base, origin: Origin::GearboxFile, exchanged: None })
}
