//! What a file says of the gears and meshes of a set of any form, in one form.

use super::compound::PlanetSized;
use super::per_gear::{Gears, PerGear};
use super::{DataSheetEntry, FloatingEntry, GearboxFile, StrengthEntry, ToolEntry};
use crate::Path;
use epicyclic_gears::geometry::GearKind;
use epicyclic_train::PlanetSet;
use epicyclic_train::planet_set::GearOf;
use epicyclic_units::{Physical, Quantity};
use std::collections::BTreeMap;
use uom::si::f64::Length;

/// What a file says of the gears of a set beyond their teeth. Lists of gears are in the order of
/// [`PlanetSet::gears`].
#[derive(Debug, Clone)]
pub struct SetData<'f> {
    /// Path of the set.
    pub path: Path,
    /// Names of the gears by which keys know them.
    pub gears: Gears,
    /// The gears.
    pub of: Vec<GearOf>,
    /// Module of each mesh, as far as it is stated.
    pub modules: Vec<Option<Length>>,
    /// Face width of each gear.
    pub face_widths: Vec<Option<Length>>,
    /// Bore of each gear; `None` of solid ones.
    pub bores: Vec<Option<Length>>,
    /// Tools by gear.
    pub tools: &'f BTreeMap<String, ToolEntry>,
    /// Data for the strength.
    pub strength: Option<&'f StrengthEntry>,
    /// Data for the data sheet.
    pub data_sheet: Option<&'f DataSheetEntry>,
    /// Member that floats.
    pub floating: Option<FloatingEntry>,
}

impl SetData<'_> {
    /// Place of a gear among the gears.
    #[must_use]
    pub fn place(&self, gear: GearOf) -> usize {
        self.of.iter().position(|one| *one == gear).unwrap_or_default()
    }

    /// Common face width of two gears in mesh.
    #[must_use]
    pub fn common_width(&self, gears: [GearOf; 2]) -> Option<Length> {
        let [one, other] = gears.map(|gear| self.face_widths[self.place(gear)]);
        let (one, other) = (one?, other?);
        Some(if one.si() < other.si() { one } else { other })
    }
}

impl GearboxFile {
    /// What the file says of a set; `None` of a set that is not of this file.
    #[must_use]
    pub fn set_data(&self, set: &PlanetSet) -> Option<SetData<'_>> {
        let of = set.gears();
        let modules =
            self.stated_modules(set).into_iter().map(|module| module.map(Length::from_si)).collect();
        let is_planet = |gear: &GearOf| matches!(gear, GearOf::Planet(..));
        if let Some(place) = self.sets.iter().position(|entry| entry.id == set.id()) {
            let entry = &self.sets[place];
            let gears = Gears::of_kind(entry.kind.into());
            let accuracy = entry.strength.as_ref().and_then(|strength| strength.accuracy.as_ref());
            let bore = |(place, gear): (usize, &GearOf)| {
                let own = accuracy.and_then(|accuracy| accuracy.bores.get(&gears.names[place]).copied());
                own.or_else(|| match gear {
                    _ if is_planet(gear) => entry.planet_bore,
                    _ if place == 0 => accuracy?.sun_bore,
                    _ => None,
                })
            };
            let bores = of.iter().enumerate().map(|one| bore(one).map(|bore| bore.0)).collect();
            return Some(SetData {
                path: Path::root().key("sets").index(place),
                face_widths: widths(entry.face_width, entry.face_widths.as_ref(), &gears),
                bores,
                gears,
                of,
                modules,
                tools: &entry.tools,
                strength: entry.strength.as_ref(),
                data_sheet: entry.data_sheet.as_ref(),
                floating: entry.floating,
            });
        }
        let place = self.compound_sets.iter().position(|entry| entry.id == set.id())?;
        let entry = &self.compound_sets[place];
        let gears = entry.gears();
        let size = |gear: &GearOf| match gear {
            GearOf::Planet(planet, own) => {
                let size = entry.planet_sizes.get(&set.planets()[*planet].name)?.size();
                Some((size.face_widths.get(*own).copied().flatten(), size.bore))
            }
            GearOf::Central(_) => None,
        };
        let accuracy = entry.strength.as_ref().and_then(|strength| strength.accuracy.as_ref());
        let bore = |(gear, name): (&GearOf, &String)| {
            let own = accuracy.and_then(|accuracy| accuracy.bores.get(name).map(|bore| bore.0));
            let is_sun =
                matches!(gear, GearOf::Central(_)) && set.gear_kind(*gear) == Some(GearKind::External);
            let of_suns = accuracy.and_then(|accuracy| accuracy.sun_bore).filter(|_| is_sun);
            own.or_else(|| size(gear).and_then(|size| size.1)).or(of_suns.map(|bore| bore.0))
        };
        let stated = widths(entry.face_width, entry.face_widths.as_ref(), &gears);
        let widths = of.iter().zip(stated).map(|(gear, width)| {
            // A width of the planet's size is of the gear alone and goes before that of the set.
            size(gear).and_then(|size| size.0).or(width)
        });
        Some(SetData {
            path: Path::root().key("compound_sets").index(place),
            face_widths: widths.collect(),
            bores: of.iter().zip(&gears.names).map(bore).collect(),
            gears,
            of,
            modules,
            tools: &entry.tools,
            strength: entry.strength.as_ref(),
            data_sheet: entry.data_sheet.as_ref(),
            floating: entry.floating,
        })
    }
}

/// Face width of each gear; those of wrong names are refused where the set is read.
fn widths(
    of_all: Option<Quantity<Length>>,
    own: Option<&PerGear<Quantity<Length>>>,
    gears: &Gears,
) -> Vec<Option<Length>> {
    let own = own.and_then(|own| own.given("", "face_widths", gears).ok());
    let own = own.unwrap_or_else(|| vec![None; gears.names.len()]);
    own.into_iter().map(|own| own.copied().or(of_all).map(|width| width.0)).collect()
}
