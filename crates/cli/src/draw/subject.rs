//! The gearbox that is drawn: a scheme of the catalogue, or one from a file.

use super::{Args, View};
use crate::analyze::{self, Choice};
use crate::failure::Failure;
use crate::schemes::{Scheme, Sizes, dimensioned};
use epicyclic_formats::Number;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_schemes::Gearbox;
use std::path::Path;

/// A gearbox, and whether its rows have known sizes.
pub(super) struct Subject {
    pub(super) gearbox: Gearbox,
    pub(super) gearing: bool,
}

/// Row parameter of rows of which only the structure is drawn; it shows nowhere.
const ANY_K: f64 = 2.5;

/// Reads what is named.
pub(super) fn read(args: &Args) -> Result<Subject, Failure> {
    let file = Path::new(&args.gearbox);
    match Scheme::named(&args.gearbox) {
        Ok(scheme) if !file.exists() => catalogue(args, scheme),
        // What looks like a name and is neither: say which schemes there are.
        Err(unknown) if !file.exists() && file.extension().is_none() && file.components().count() == 1 => {
            Err(unknown)
        }
        _ => from_file(args, file),
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
    let sizes = Sizes { k1: args.k1, k2: args.k2, ratio1: args.ratio1, ratio2: args.ratio2 };
    if let Some(found) = dimensioned(sizes, scheme, eta)? {
        return Ok(Subject { gearbox: found.gearbox, gearing: true });
    }
    if args.gear.is_some() || args.view != View::Scheme {
        let message = format!(
            "for speeds of {} give --k1 or --ratio1, and of two rows --k2 or --ratio2",
            scheme.name()
        );
        return option("--k1", message);
    }
    let any = |is_there: bool| is_there.then(|| Number::new(ANY_K).ok()).flatten();
    let sizes = Sizes { k1: any(true), k2: any(matches!(scheme, Scheme::Three(_))), ..Sizes::default() };
    match dimensioned(sizes, scheme, eta)? {
        Some(found) => Ok(Subject { gearbox: found.gearbox, gearing: false }),
        None => option("--k1", "needed".into()),
    }
}

fn from_file(args: &Args, file: &Path) -> Result<Subject, Failure> {
    let sizes = [("--k1", args.k1), ("--k2", args.k2), ("--ratio1", args.ratio1), ("--ratio2", args.ratio2)];
    if let Some((option, _)) = sizes.into_iter().find(|(_, size)| size.is_some()) {
        let message = "it is for schemes of the catalogue; the file says how large its rows are".to_owned();
        return Err(Failure::Option { option, message });
    }
    let choice = Choice::new(file.to_owned(), args.transmission.clone(), args.efficiency);
    Ok(Subject { gearbox: analyze::gearbox(&choice)?, gearing: true })
}
