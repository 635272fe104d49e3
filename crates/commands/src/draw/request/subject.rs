//! The gearbox that is drawn: a scheme of the catalogue, a structure of two sets, or one from a file.

use super::{Args, View};
use crate::desk::Call;
use crate::draw::answer::{self as answers, Origin};
use crate::failure::Failure;
use crate::input;
use crate::shared::gearbox_choice::{self as analyze, Choice};
use crate::shared::named_gearbox as named;
use crate::shared::options;
use crate::shared::tooth_checks::answer::ToothChecks;
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_formats::{self as formats, Document};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::rack::BasicRack;
use epicyclic_train::Gearbox;
use epicyclic_train::planet_bearings::PlanetBearing;
use epicyclic_train::planet_set::PlanetSet;
use std::collections::BTreeMap;
use std::path::Path;
use uom::si::f64::Length;

/// A gearbox, and whether its rows have known sizes.
pub(super) struct Subject {
    pub(super) gearbox: Gearbox,
    pub(super) gearing: bool,
    /// Planet bearings and sizes of planets that the file states.
    pub(super) planet_bearings: Vec<PlanetBearing>,
    /// The basic rack of its teeth, and the modules of its sets where the file has them.
    pub(super) rack: BasicRack,
    pub(super) modules: BTreeMap<String, Length>,
    /// The checks of its teeth.
    pub(super) tooth_checks: Option<ToothChecks>,
    /// Place of the gearbox in its file.
    pub(super) base: formats::Path,
    origin: Origin,
}

impl Subject {
    /// Returns the place that an error refers to: for the view of teeth, the first set whose gears are
    /// invalid; otherwise the gearbox.
    pub(super) fn of_fault(self, view: Option<View>) -> formats::Path {
        let is_fault = |set: &PlanetSet| {
            set.short().and_then(|spec| spec.toothed_set(&self.rack)).is_some_and(|set| set.is_err())
        };
        // Sets with two central gears come first, in the order of the file.
        match self.gearbox.sets().iter().position(is_fault).filter(|_| view == Some(View::Teeth)) {
            Some(place) => self.base.key("sets").index(place),
            None => self.base,
        }
    }

    /// Record of the gearbox for the answer.
    pub(super) fn record(&self) -> answers::Subject {
        answers::Subject::of_gearbox(&self.gearbox, self.origin, self.gearing)
    }
}

/// Reads what is named.
pub(super) fn read(call: &Call<'_>, args: &Args, document: Option<&Document>) -> Result<Subject, Failure> {
    let named = match document {
        Some(_) => None,
        None => named::read(call, &args.gearbox)?,
    };
    let Some(named) = named else {
        let file = Path::new(&args.gearbox);
        return match document {
            Some(document) => from_file(args, file, document),
            None => from_file(args, file, &input::document(call, file)?),
        };
    };
    if args.transmission.is_some() {
        return Err(named.no_transmission());
    }
    let eta = args.efficiency.map_or(Ok(MeshEfficiency::IDEAL), options::efficiency)?;
    let origin = named.origin();
    if let Some(gearbox) = named.sized(args.sizes, eta)? {
        return Ok(Subject { gearing: true, ..of_name(gearbox, origin) });
    }
    if args.gear.is_some() || args.view.is_some_and(|view| view != View::Scheme) {
        return Err(named.needs_sizes("for speeds"));
    }
    Ok(of_name(named.of_any_size()?, origin))
}

/// A gearbox that no file describes.
fn of_name(gearbox: Gearbox, origin: Origin) -> Subject {
    let (base, rack) = (formats::Path::root(), BasicRack::default());
    let (planet_bearings, modules) = (vec![], BTreeMap::new());
    Subject { gearbox, gearing: false, planet_bearings, rack, modules, tooth_checks: None, base, origin }
}

fn from_file(args: &Args, file: &Path, document: &Document) -> Result<Subject, Failure> {
    args.sizes.none_with_a_file()?;
    let choice = Choice::new(file.display().to_string(), args.transmission.clone(), args.efficiency);
    let read = analyze::subject(&choice, document)?;
    let tooth_checks = Some(ToothChecks::of(read.tooth_checks(), |_| true));
    let crate::shared::gearbox::Gearbox { train: gearbox, planet_bearings, base, rack, .. } = read;
    // A list of transmissions has no modules.
    let sets = document.read().map(|file: GearboxFile| file.sets).unwrap_or_default();
    let modules = sets.into_iter().filter_map(|set| Some((set.id, set.module?.0))).collect();
    let origin = Origin::GearboxFile;
    Ok(Subject { gearbox, gearing: true, planet_bearings, rack, modules, tooth_checks, base, origin })
}
