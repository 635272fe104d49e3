//! Data of a file for the gears and meshes of a set, in one form for all kinds of sets.

use super::compound::PlanetSized;
use super::per_gear::{Gears, PerGear};
use super::{
    AccuracyEntry, DataSheetEntry, FloatingEntry, GearboxFile, RollingEntry, StrengthEntry, ToolEntry,
    Vibrating, VibrationEntry,
};
use crate::Path;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::life::Rolling;
use epicyclic_train::PlanetSet;
use epicyclic_train::planet_set::{GearOf, Planet};
use epicyclic_units::{Number, Physical, Quantity};
use std::collections::BTreeMap;
use uom::si::f64::{Force, Length, Mass};

/// Data of a file for the gears of a set beyond their teeth. Lists of gears are in the order of
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
    /// Data for the vibration.
    pub vibration: Option<VibrationEntry>,
    /// Bodies and meshes by the names that keys know; central gears and planets in their order.
    pub vibrating: Vibrating,
    /// The planets, as far as the file describes them.
    pub planets: Vec<PlanetData>,
    /// For each mesh of two planets, whether the one described later is behind the other.
    pub is_behind: Vec<bool>,
}

/// Data of a file for the planets of one kind.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PlanetData {
    /// Mass.
    pub mass: Option<Mass>,
    /// Bore; `None` of a solid one.
    pub bore: Option<Length>,
    /// Radius of its centre.
    pub carrier_radius: Option<Length>,
    /// Basic dynamic load rating of its bearings together, and the kind of their rolling elements.
    pub bearing: Option<(Force, Rolling)>,
    /// Rolling elements of its bearings, as they are stated.
    pub rolling: RollingEntry,
    /// Mean diameter of its bearings.
    pub bearing_diameter: Option<Length>,
    /// Basic static load rating of its bearings together.
    pub static_load_rating: Option<Force>,
    /// Mesh load factor `K_γ` for its bearing.
    pub load_sharing: Option<f64>,
    /// Distance of the rows of its bearings.
    pub bearing_span: Option<Length>,
}

impl PlanetData {
    /// Whether its bearings are plain ones.
    #[must_use]
    pub fn is_on_plain_bearings(&self) -> bool {
        self.rolling == RollingEntry::Plain
    }
}

impl SetData<'_> {
    /// Place of a gear among the gears.
    #[must_use]
    pub fn place(&self, gear: GearOf) -> usize {
        self.of.iter().position(|one| *one == gear).unwrap_or_default()
    }

    /// Values of the gears, as far as they are given.
    #[must_use]
    pub fn of_gears<'v, T>(&self, values: &'v PerGear<T>) -> Vec<Option<&'v T>> {
        values.of_gears(&self.gears)
    }

    /// Whether the distance of the rows of all bearings with a load rating is given, and of any.
    #[must_use]
    pub fn has_bearing_spans(&self) -> bool {
        let mut rated = self.planets.iter().filter(|planet| planet.bearing.is_some()).peekable();
        rated.peek().is_some() && rated.all(|planet| planet.bearing_span.is_some())
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
    /// Data of the file for a set; `None` of a set that is not of this file.
    #[must_use]
    pub fn set_data(&self, set: &PlanetSet) -> Option<SetData<'_>> {
        let of = set.gears();
        let modules =
            self.stated_modules(set).into_iter().map(|module| module.map(Length::from_si)).collect();
        if let Some(place) = self.sets.iter().position(|entry| entry.id == set.id()) {
            let entry = &self.sets[place];
            let gears = Gears::of_kind(entry.kind.into());
            let of_kind = |(place, gear): (usize, &GearOf)| match gear {
                GearOf::Planet(..) => entry.planet_bore,
                GearOf::Central(_) if place == 0 => accuracy(entry.strength.as_ref())?.sun_bore,
                GearOf::Central(_) => None,
            };
            let of_kind = of.iter().enumerate().map(|gear| of_kind(gear).map(|bore| bore.0));
            return Some(SetData {
                path: Path::root().key("sets").index(place),
                face_widths: widths(entry.face_width, entry.face_widths.as_ref(), &gears),
                bores: bores(entry.strength.as_ref(), &gears, of_kind),
                gears,
                of,
                modules,
                tools: &entry.tools,
                strength: entry.strength.as_ref(),
                data_sheet: entry.data_sheet.as_ref(),
                floating: entry.floating,
                vibration: entry.vibration.clone(),
                vibrating: Vibrating::of_kind(entry.kind.into()),
                planets: vec![
                    PlanetData {
                        mass: entry.planet_mass.map(|mass| mass.0),
                        bore: entry.planet_bore.map(|bore| bore.0),
                        carrier_radius: entry.carrier_radius.map(|radius| radius.0),
                        bearing: entry.load_rating.map(|rating| (rating.0, entry.bearing_rolling.into())),
                        rolling: entry.bearing_rolling,
                        bearing_diameter: entry.bearing_diameter.map(|diameter| diameter.0),
                        static_load_rating: entry.static_load_rating.map(|rating| rating.0),
                        load_sharing: None,
                        bearing_span: entry.bearing_span.map(|span| span.0),
                    };
                    set.planets().len()
                ],
                is_behind: vec![false; set.meshes().len()],
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
        let of_kind = |gear: &GearOf| match gear {
            GearOf::Planet(..) => size(gear)?.1,
            GearOf::Central(_) if set.gear_kind(*gear) == Some(GearKind::External) => {
                accuracy(entry.strength.as_ref())?.sun_bore.map(|bore| bore.0)
            }
            GearOf::Central(_) => None,
        };
        let planet = |planet: &Planet| {
            let size = entry.planet_sizes.get(&planet.name);
            size.map_or_else(PlanetData::default, |size| PlanetData {
                mass: size.mass.map(|mass| mass.0),
                bore: size.bore.map(|bore| bore.0),
                carrier_radius: size.carrier_radius.map(|radius| radius.0),
                bearing: size.size().bearing,
                rolling: size.bearing_rolling,
                bearing_diameter: size.bearing_diameter.map(|diameter| diameter.0),
                static_load_rating: size.static_load_rating.map(|rating| rating.0),
                load_sharing: size.load_sharing.map(Number::get),
                bearing_span: size.bearing_span.map(|span| span.0),
            })
        };
        let stated = widths(entry.face_width, entry.face_widths.as_ref(), &gears);
        let widths = of.iter().zip(stated).map(|(gear, width)| {
            // A width of the planet's size is of the gear alone and goes before that of the set.
            size(gear).and_then(|size| size.0).or(width)
        });
        Some(SetData {
            path: Path::root().key("compound_sets").index(place),
            face_widths: widths.collect(),
            bores: bores(entry.strength.as_ref(), &gears, of.iter().map(of_kind)),
            gears,
            of,
            modules,
            tools: &entry.tools,
            strength: entry.strength.as_ref(),
            data_sheet: entry.data_sheet.as_ref(),
            floating: entry.floating,
            vibration: entry.vibration.clone().map(VibrationEntry::from),
            vibrating: entry.vibrating(),
            planets: set.planets().iter().map(planet).collect(),
            is_behind: entry.meshes.iter().map(|mesh| mesh.behind).collect(),
        })
    }
}

fn accuracy(strength: Option<&StrengthEntry>) -> Option<&AccuracyEntry> {
    strength?.accuracy.as_ref()
}

/// Bore of each gear: its own, otherwise that of its kind.
fn bores(
    strength: Option<&StrengthEntry>,
    gears: &Gears,
    of_kind: impl Iterator<Item = Option<Length>>,
) -> Vec<Option<Length>> {
    let own = |name| accuracy(strength)?.bores.get(name).map(|bore| bore.0);
    gears.names.iter().zip(of_kind).map(|(name, of_kind)| own(name).or(of_kind)).collect()
}

/// Face width of each gear.
fn widths(
    of_all: Option<Quantity<Length>>,
    own: Option<&PerGear<Quantity<Length>>>,
    gears: &Gears,
) -> Vec<Option<Length>> {
    let own = own.map_or_else(|| vec![None; gears.names.len()], |own| own.of_gears(gears));
    own.into_iter().map(|own| own.copied().or(of_all).map(|width| width.0)).collect()
}
