//! Records of sizes: designs, numbers left out, keys kept from the file.

use super::layouts::Families;
use crate::analyze::answer::records::planet_name;
use crate::answer::Warning;
use crate::shared::tool::CuttingTool;
use crate::size::options::Request;
use crate::strength::answer::names::MeshName;
use crate::strength::answer::prepared::SetToSize;
use crate::strength::answer::records::{NotRated, Reason, Wear};
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::InvoluteGear;
use epicyclic_judge::Limits;
use epicyclic_strength::factor::Side;
use epicyclic_strength::sizing::{self, Design, DesignedPlanet, Found, Requirement};
use epicyclic_strength::spectrum::{GearDuty, Worn};
use epicyclic_units::Physical;
use schemars::JsonSchema;
use serde::Serialize;
use uom::si::f64::Length;

/// Search space of a set for which the file gives no values.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Sought {
    /// Modules in m.
    pub modules_m: Vec<f64>,
    /// Face widths in m.
    pub face_widths_m: Vec<f64>,
    /// Numbers of planets.
    pub planets: Vec<u32>,
    /// Step of the centre distances, in m.
    pub centre_distance_step_m: f64,
    /// Maximum distance of centre distances from the natural one, in modules.
    pub reach_in_modules: f64,
    /// Maximum face width over the reference diameter of the smallest sun or gear; null without limit.
    pub width_ratio: Option<f64>,
    /// Maximum outside diameter of a ring in m; null without limit.
    pub largest_ring_m: Option<f64>,
    /// Minimum normal tip thickness, in modules.
    pub least_tip_thickness_in_modules: f64,
    /// Minimum rim of the planets between root circle and bore, in modules.
    pub planet_rim_in_modules: f64,
    /// Rim of the ring outside its root circle, in modules.
    pub ring_rim_in_modules: f64,
    /// Number of planet bearings to choose from, including pairs.
    pub bearings: usize,
}

impl Sought {
    pub(super) fn of(request: &Request, limits: &Limits) -> Self {
        let space = request.space();
        let [planet_rim_in_modules, ring_rim_in_modules] = request.rims(limits);
        let si = |lengths: &[Length]| lengths.iter().map(|length| length.si()).collect();
        Self {
            modules_m: si(&space.modules),
            face_widths_m: si(&space.face_widths),
            planets: space.planets,
            centre_distance_step_m: space.centre_distance_step.si(),
            reach_in_modules: space.reach,
            width_ratio: space.width_ratio,
            largest_ring_m: space.largest_ring.map(Physical::si),
            least_tip_thickness_in_modules: request.tip_thickness.get(),
            planet_rim_in_modules,
            ring_rim_in_modules,
            bearings: space.bearings.len(),
        }
    }
}

/// Keys of a set in the file that the search keeps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum HeldKey {
    /// Module of the set.
    Module,
    /// Face width of the set.
    FaceWidth,
    /// Number of planets of the set.
    Planets,
    /// Profile shifts of the set, with the tip alterations.
    ProfileShifts,
    /// Load rating of the planet bearings.
    LoadRating,
    /// Bore of the planets; without a load rating no bearing is searched.
    PlanetBore,
    /// Rim of the planets, which the search takes as the minimum.
    PlanetRim,
    /// Rim of the ring.
    RingRim,
}

impl HeldKey {
    /// Name of the key in the file.
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Module => "module",
            Self::FaceWidth => "face_width",
            Self::Planets => "planets",
            Self::ProfileShifts => "profile_shifts",
            Self::LoadRating => "load_rating",
            Self::PlanetBore => "planet_bore",
            Self::PlanetRim => "planet_rim",
            Self::RingRim => "ring_rim",
        }
    }
}

/// Number of designs that each requirement left out. A design that fails several safeties counts for the one with
/// the least margin, and for bearings only where its teeth hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LeftOut {
    /// Designs whose planets cannot be equally spaced.
    pub spacing: u64,
    /// Designs whose planets touch.
    pub planets_touch: u64,
    /// Centre distances without valid profile shifts.
    pub geometry: u64,
    /// Designs whose gears or widths usual practice refuses: shifts beyond 1, faces wider than twice the
    /// smaller gear.
    pub practice: u64,
    /// Designs with face widths above the limit.
    pub width_ratio: u64,
    /// Designs with rings above the limit.
    pub ring: u64,
    /// Designs with planets to which no bearing leaves a rim.
    pub rim: u64,
    /// Designs with planets narrower than any bearing that leaves a rim.
    pub bearing_width: u64,
    /// Designs with teeth outside the range of the standard.
    pub not_calculable: u64,
    /// Designs with flanks below the required safety.
    pub flank: u64,
    /// Designs with roots below the required safety.
    pub root: u64,
    /// Designs with flanks or roots below the required safety against an overload.
    pub overload: u64,
    /// Designs with bearings below the required life.
    pub bearing_life: u64,
}

/// Requirement with the least reserve of torque in a design.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Governing {
    /// Name of the requirement.
    pub requirement: Requirement,
    /// Name of the mesh; null for a bearing.
    pub mesh: Option<MeshName>,
    /// Gear whose tooth or bearing governs.
    pub toothed_gear: String,
    /// Safety; for a bearing the load that it carries for the required life over its load.
    pub value: f64,
    /// Required value.
    pub required: f64,
}

impl Governing {
    /// Reserve of torque over the requirement: 1 and more is enough.
    #[must_use]
    pub fn reserve(&self) -> f64 {
        self.requirement.reserve(self.value, self.required)
    }

    fn of((set, families): Of<'_>, governing: &sizing::Governing) -> Self {
        Self {
            requirement: governing.requirement,
            mesh: governing.mesh.map(|mesh| mesh_name((set, families), mesh)),
            toothed_gear: gear_name(set, governing.gear),
            value: governing.value,
            required: governing.required,
        }
    }
}

/// A set with its families.
type Of<'a> = (&'a SetToSize<'a>, &'a Families);

fn gear_name(set: &SetToSize<'_>, gear: usize) -> String {
    set.set.gear_name(set.data.of[gear])
}

fn mesh_name((set, families): Of<'_>, mesh: usize) -> MeshName {
    MeshName::of(set.set, families.ends[mesh].map(|gear| set.data.of[gear]))
}

/// Bearing of a planet.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SizedBearing {
    /// Designation of the bearing; null if the file gives its load rating.
    pub designation: Option<String>,
    /// Rolling elements: balls, rollers, needles, `full_complement`.
    pub rolling: &'static str,
    /// Bore of the bearing (pin diameter) in m; null if the file gives its load rating.
    pub bore_m: Option<f64>,
    /// Outside diameter of the bearing (bore of the planet) in m; null for a solid planet.
    pub outside_diameter_m: Option<f64>,
    /// Width of the bearing in m; null if the file gives its load rating.
    pub width_m: Option<f64>,
    /// Basic dynamic load rating in N.
    pub load_rating_n: f64,
    /// Basic static load rating in N; null if unknown.
    pub static_load_rating_n: Option<f64>,
    /// Distance of the middles of both rows in m, with which the bearing of a helical planet is rated; null of
    /// others, and if the file gives the load rating alone.
    pub span_m: Option<f64>,
    /// Basic rating life over the duty in s; null if the bearing never turns under load.
    pub life_s: Option<f64>,
}

/// Gear of a mesh over the duty.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SizedGear {
    /// Name of the mesh.
    pub mesh: MeshName,
    /// Gear of the mesh.
    pub toothed_gear: String,
    /// Name of the gear's material.
    pub material: String,
    /// Damage and safety of the flank.
    pub flank: Wear,
    /// Damage and safety of the root.
    pub root: Wear,
}

impl SizedGear {
    fn both((set, families): Of<'_>, mesh: usize, rating: &[GearDuty<Worn>; 2]) -> [Self; 2] {
        Side::BOTH.map(|side| {
            let (gear, own) = (families.ends[mesh][side as usize], &rating[side as usize]);
            Self {
                mesh: mesh_name((set, families), mesh),
                toothed_gear: gear_name(set, gear),
                material: set.materials[gear].clone(),
                flank: Wear::of(&own.contact),
                root: Wear::of(&own.root),
            }
        })
    }
}

/// Gears that mesh with one another: they have one module and one face width.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SizedFamily {
    /// Names of the gears.
    pub toothed_gears: Vec<String>,
    /// Module in m.
    pub module_m: f64,
    /// Face width in m.
    pub face_width_m: f64,
    /// Face width over the reference diameter of the smallest sun, or of the smallest gear.
    pub face_width_over_diameter: f64,
    /// `K_Hβ` by the face width; null where it is given for every width.
    pub face_load_factor: Option<f64>,
}

/// Teeth of a gear beyond their number.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SizedTeeth {
    /// Name of the gear.
    pub toothed_gear: String,
    /// Name by which keys of the file know it.
    pub key: String,
    /// Tooth number.
    pub teeth: u32,
    /// Face width in m: that of the file, or of its family.
    pub face_width_m: f64,
    /// Profile shift coefficient.
    pub profile_shift: f64,
    /// Tip alteration, in modules.
    pub tip_alteration: f64,
    /// Rim under its teeth in m: of a ring outside its root circle, of a bored planet inside; null for
    /// others.
    pub rim_m: Option<f64>,
    /// Whether it is internal.
    pub is_internal: bool,
    /// Tool that cuts it.
    pub tool: CuttingTool,
}

/// Planets of a kind.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SizedPlanet {
    /// Name of the planet.
    pub planet: String,
    /// Name by which keys of the file know it; empty in a set with two central gears.
    pub key: String,
    /// Radius of its centre, in m.
    pub radius_m: f64,
    /// Bearing; null if none was searched.
    pub bearing: Option<SizedBearing>,
    /// Bore in m; null for a solid planet.
    pub bore_m: Option<f64>,
    /// Least rim between root circle and bore, in m; null for a solid planet.
    pub rim_m: Option<f64>,
}

/// Design of a set.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SizedDesign {
    /// Gears that mesh with one another, with module and face width.
    pub families: Vec<SizedFamily>,
    /// Number of planets of each kind; 1 for a pair.
    pub planets: u32,
    /// Centre distance of the first mesh in m.
    pub centre_distance_m: f64,
    /// The gears.
    pub gears: Vec<SizedTeeth>,
    /// Whether the aim of the profile shifts is met; otherwise it is met only as far as the limits allow.
    pub aim_met: bool,
    /// Rules of usual practice that gears, widths, speeds and bearings miss; 0 where it does not count.
    pub rules_missed: u32,
    /// Planets of each kind; none for a pair.
    pub planet_sizes: Vec<SizedPlanet>,
    /// Outside diameter of the largest ring in m, or of the circle that tips of planets reach to where that is
    /// larger; null for a set without a ring.
    pub ring_diameter_m: Option<f64>,
    /// Mass of all gears of the set, in kg.
    pub mass_kg: f64,
    /// Mass of carrier and housing in kg, by a rule.
    pub structure_kg: f64,
    /// Length along the axis in m, with the cheeks of the carrier and covers by a rule.
    pub length_m: f64,
    /// Damage and safety of each gear of each mesh that the duty loads.
    pub over_duty: Vec<SizedGear>,
    /// Requirement with the least margin against the overloads of the file; null if none loads the set.
    pub overload: Option<Governing>,
    /// Requirement with the least margin.
    pub governing: Governing,
}

impl SizedDesign {
    /// Mass with carrier and housing, in kg.
    #[must_use]
    pub fn with_structure_kg(&self) -> f64 {
        self.mass_kg + self.structure_kg
    }

    fn of((set, families): Of<'_>, design: &Design) -> Self {
        let layout = &design.layout;
        let own = |family: usize| (0..families.of.len()).filter(move |gear| families.of[*gear] == family);
        let family = |family: usize| SizedFamily {
            toothed_gears: own(family).map(|gear| gear_name(set, gear)).collect(),
            module_m: layout.modules[family].si(),
            face_width_m: design.face_widths[family].si(),
            face_width_over_diameter: design.width_ratios[family],
            face_load_factor: design.face_loads[family],
        };
        let teeth = |(gear, own): (usize, &InvoluteGear)| SizedTeeth {
            toothed_gear: gear_name(set, gear),
            key: set.data.gears.names[gear].clone(),
            teeth: own.teeth().get(),
            face_width_m: set.data.face_widths[gear].unwrap_or(design.face_widths[families.of[gear]]).si(),
            profile_shift: own.shift(),
            tip_alteration: own.tip_alteration(),
            rim_m: design.rims[gear].map(Physical::si),
            is_internal: own.kind() == GearKind::Internal,
            tool: CuttingTool::of(own),
        };
        // A bearing given only by its load rating has lengths of 0 in the search, which are unknown in fact.
        let positive = |length: Length| Some(length.si()).filter(|si| *si > 0.0);
        let bearing = |planet: &DesignedPlanet| {
            planet.bearing.as_ref().map(|bearing| SizedBearing {
                designation: Some(bearing.designation.clone()).filter(|name| !name.is_empty()),
                rolling: bearing.rolling.name(),
                bore_m: positive(bearing.bore),
                outside_diameter_m: positive(bearing.outside_diameter),
                width_m: positive(bearing.width),
                load_rating_n: bearing.load_rating.si(),
                static_load_rating_n: bearing.static_load_rating.map(Physical::si),
                span_m: planet.span.map(Physical::si),
                life_s: planet.life.map(Physical::si),
            })
        };
        let planet = |(place, planet): (usize, &DesignedPlanet)| SizedPlanet {
            planet: planet_name(set.set, place),
            key: set.set.planets()[place].name.clone(),
            radius_m: layout.radii[place].si(),
            bearing: bearing(planet),
            bore_m: planet.bore.map(Physical::si),
            rim_m: planet.rim.map(Physical::si),
        };
        let over_duty = design.meshes.iter().enumerate();
        let over_duty = over_duty.filter_map(|(mesh, rating)| {
            rating.as_ref().map(|rating| SizedGear::both((set, families), mesh, rating))
        });
        Self {
            families: (0..families.count).map(family).collect(),
            planets: layout.planets,
            centre_distance_m: layout.pairs[0].centre_distance() * layout.modules[families.of_mesh(0)].si(),
            gears: layout.gears.iter().enumerate().map(teeth).collect(),
            aim_met: layout.is_aim_met,
            planet_sizes: design.planets.iter().enumerate().map(planet).collect(),
            rules_missed: design.rules_missed,
            ring_diameter_m: design.ring_diameter.map(Physical::si),
            mass_kg: design.mass.si(),
            structure_kg: design.structure.si(),
            length_m: design.length.si(),
            over_duty: over_duty.flatten().collect(),
            overload: design.overload.as_ref().map(|one| Governing::of((set, families), one)),
            governing: Governing::of((set, families), &design.governing),
        }
    }
}

/// Set with its best designs.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct SizedSet {
    /// Name of the set.
    pub set: String,
    /// Keys of the file that were kept.
    pub held: Vec<HeldKey>,
    /// Number of designs in the search space.
    pub designs: u64,
    /// Number of layouts (modules, numbers of planets, centre distances) whose gears were calculated.
    pub centre_distances: u64,
    /// Number of meshes that were rated.
    pub rated: u64,
    /// Number of designs that each requirement left out.
    pub left_out: LeftOut,
    /// Number of designs that were not checked, because they are no better than the last one found.
    pub not_reached: u64,
    /// Best designs in order.
    pub found: Vec<SizedDesign>,
    /// Design that misses the requirements least, if none is found; null otherwise, or if no teeth could be
    /// rated.
    pub nearest_miss: Option<SizedDesign>,
}

impl SizedSet {
    pub(super) fn of(
        of: (&SetToSize<'_>, &Families),
        held: Vec<HeldKey>,
        found: &Found,
        most: usize,
    ) -> Self {
        let out = found.left_out;
        let design = |design: &Design| SizedDesign::of(of, design);
        Self {
            set: of.0.set.id().to_owned(),
            held,
            designs: found.space,
            centre_distances: found.geometries,
            rated: found.rated,
            left_out: LeftOut {
                spacing: out.spacing,
                planets_touch: out.planets_touch,
                geometry: out.geometry,
                practice: out.practice,
                width_ratio: out.width_ratio,
                ring: out.ring,
                rim: out.rim,
                bearing_width: out.bearing_width,
                not_calculable: out.not_calculable,
                flank: out.flank,
                root: out.root,
                overload: out.overload,
                bearing_life: out.bearing_life,
            },
            not_reached: found.not_reached,
            found: found.found.iter().take(most).map(design).collect(),
            nearest_miss: found.nearest_miss.as_ref().map(design),
        }
    }

    /// Warning that the set has no size, with remedies; `None` if it has one.
    pub(super) fn warning(&self, of: &Found) -> Option<Warning> {
        if !self.found.is_empty() {
            return None;
        }
        let stated = of.stated_limit.map(|(rule, designs)| {
            format!(
                "`{}` of `limits` in the file leaves out {designs} of {} designs; a wider range would help",
                rule.name(),
                self.designs
            )
        });
        // The remedy follows from the requirement that the closest design fails.
        let why = match (&self.nearest_miss, &stated) {
            (None, Some(_)) => String::new(),
            (None, None) => self.why_unrated(of.usual_fault.as_deref()),
            (Some(miss), _) => {
                let Governing { requirement, toothed_gear, value, required, .. } = &miss.governing;
                match requirement {
                    Requirement::BearingLife => format!(
                        "the bearing of the nearest carries {value:.3} of its load for the required life; bearings with a larger load rating, wider faces or more planets would help"
                    ),
                    teeth => {
                        let (symbol, place) = match teeth {
                            Requirement::Flank | Requirement::OverloadFlank => ("S_H", "flank"),
                            _ => ("S_F", "root"),
                        };
                        let against = if teeth.is_against_overload() { " against the overload" } else { "" };
                        // Larger modules would be beyond a bound of the ring.
                        let larger = if self.left_out.ring > 0 {
                            "wider faces, more planets, a larger --max-ring"
                        } else {
                            "larger modules, wider faces"
                        };
                        format!(
                            "the nearest misses {symbol} = {value:.3} of the {toothed_gear}'s {place}{against}, {required} required; {larger} or a stronger material would help"
                        )
                    }
                }
            }
        };
        let all: Vec<String> = stated.into_iter().chain([why]).filter(|why| !why.is_empty()).collect();
        Some(Warning {
            name: "no-size",
            message: format!("set {}: {}", self.set, all.join(". Of the others ")),
        })
    }

    /// Why no teeth of the space could be rated: what left out most designs, and a remedy.
    fn why_unrated(&self, usual_fault: Option<&str>) -> String {
        let out = &self.left_out;
        let gears = usual_fault.map_or_else(
            || "the gears cannot mesh at any of the centre distances".to_owned(),
            |fault| format!("no gears of the space run together; most often {fault}"),
        );
        let all = [
            (out.geometry, gears.as_str()),
            (out.planets_touch, "neighbouring planets touch, or nearly: fewer planets would help"),
            (
                out.width_ratio,
                "every face width is wider than allowed: narrower ones, or a larger --width-ratio would help",
            ),
            (
                out.rim,
                "no bearing leaves the least rim of the planets: larger modules, or smaller bearings would help",
            ),
            (
                out.bearing_width,
                "the planets are narrower than any bearing that leaves the least rim: wider faces would help",
            ),
            (out.ring, "every ring is larger than allowed: a larger --max-ring would help"),
            (out.practice, "usual practice refuses the gears: --beyond-practice would admit them"),
            (out.not_calculable, "the teeth are outside what ISO 6336 holds for"),
        ];
        let most = all.into_iter().max_by_key(|(count, _)| *count).filter(|(count, _)| *count > 0);
        // Other numbers of planets may leave out more: where some assemble, they are not in the way.
        let spacing =
            "the planets do not stand at equal angles: other numbers of planets or of teeth would help";
        most.map_or(spacing, |(_, why)| why).to_owned()
    }
}

/// Set that is not sized.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct NotSized {
    /// Name of the set.
    pub set: String,
    /// Reason why the set is not sized.
    pub reason: Reason,
    /// Keys, or the factor, that are missing.
    pub missing: Vec<String>,
    /// Data from which the factor would follow, or the value outside the standard; otherwise null.
    pub because: Option<String>,
}

impl NotSized {
    pub(super) fn of(row: NotRated) -> Self {
        Self { set: row.set, reason: row.reason, missing: row.missing, because: row.because }
    }

    /// Reason in words.
    #[must_use]
    pub fn why(&self) -> String {
        let Self { set, reason, missing, because } = self.clone();
        NotRated { missing, because, ..NotRated::new(&set, reason) }.why()
    }

    /// Set and reason in words: `set 1: oil missing`.
    pub(super) fn told(&self) -> String {
        format!("set {}: {}", self.set, self.why())
    }
}
