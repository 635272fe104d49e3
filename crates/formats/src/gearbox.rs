//! Gearboxes as files: our own format, and a list of real transmissions with published ratios.
//!
//! # Our own format
//! Planet sets name the links of their members; shift elements and gears follow. The links are those of the
//! sets' members, and an input or output that a clutch or tie names; `links` adds what else touches no set. A
//! set with two central gears stands in `sets` by its kind, any other gear by gear in `compound_sets`.
//!
//! ```yaml
//! gearbox: II-3
//! input: D
//! output: B
//! sets:
//!   - { id: "1", sun: T1, ring: D, carrier: B, k: 2.15, efficiency: 0.97 }
//!   - { id: "2", sun: T1, ring: B, carrier: T2, teeth: [20, 47], planet_teeth: [13], meshes: [0.98, 0.99] }
//! brakes:
//!   - { id: K1, link: T1 }
//!   - { id: K2, link: T2 }
//! clutches:
//!   - { id: direct, links: [D, B] }
//! gears:
//!   - { name: "1", engaged: [K1] }
//!   - { name: "2", engaged: [K2] }
//!   - { name: "3", engaged: [direct] }
//! ```
//!
//! Efficiencies are parts of 1 or per cent. In their place a simple set with teeth may have `friction`, the
//! coefficients of friction of its meshes, and the gearbox one `friction` for all sets without losses of
//! their own; efficiencies then follow from the teeth. For the forces on planets a set may have `planets`,
//! `module` or `carrier_radius`, and `planet_mass` or `face_width` with `planet_bore`, and for the life of
//! their bearings `load_rating`; the gearbox `density` and `pressure_angle`.
//!
//! # Real transmissions
//! [`TransmissionsFile`]: a list `transmissions`, each with sets, links that join members, shift elements
//! that join links when engaged, and gears with what is published of them.
//!
//! ```
//! use epicyclic_formats::Document;
//! use epicyclic_formats::gearbox::GearboxFile;
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let text = b"gearbox: I\ninput: D\noutput: B\n\
//!     sets: [{ id: P, sun: D, ring: T1, carrier: B, k: 2.94 }]\n\
//!     brakes: [{ id: K1, link: T1 }]\n\
//!     gears: [{ name: slow, engaged: [K1] }]\n";
//! let file: GearboxFile = Document::parse_one("box.yaml", text)?.read()?;
//! let gearbox = file.gearbox()?;
//! assert!((gearbox.analyze("slow")?.ratio().unwrap() - 3.94).abs() < 1e-12);
//! # Ok(())
//! # }
//! ```

use crate::drive::Spacing;
use epicyclic_units::{Module, Number, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::BTreeMap;
use uom::si::f64::{Angle, AngularVelocity, Force, Length, Mass, MassDensity, Ratio, Time, Torque};

mod checks;
mod closing;
mod compound;
mod data_sheet;
mod described;
mod drag;
mod error;
mod kind;
mod limits;
mod losses;
mod per_gear;
mod place;
mod set;
mod set_data;
mod shape;
mod size;
mod spacing;
mod strength;
mod tools;
mod transmissions;
mod vibration;
mod written;
pub use compound::{CompoundEntry, ListedPlanetEntry, MeshEntry, Note, PlanetSizeEntry, PlanetSized};
pub use data_sheet::DataSheetEntry;
pub use drag::{BeyondEntry, DragCurveEntry, DragEntry};
pub use error::{DescriptionError, ToolMisfit};
pub use kind::{KindEntry, RollingEntry};
pub use limits::{StatedLimit, check_limits};
use losses::losses;
pub use per_gear::{Gears, PerGear};
pub use place::{gear_place, keys_of, part_place};
pub use set_data::{PlanetData, SetData};
use spacing::spaced;
pub use strength::{
    AccuracyEntry, DutyEntry, FloatingEntry, MaterialClass, MaterialEntry, OilEntry, OverloadEntry,
    RequiredEntry, ShaperEntry, StrengthEntry,
};
pub use tools::{CutterEntry, ProfileEntry, ToolEntry};
pub use transmissions::{Planet, PublishedGear, Rounding, Transmission, TransmissionSet, TransmissionsFile};
pub use vibration::{
    BodyEntry, CarrierEntry, CompoundVibrationEntry, PlanetEntry, RingEntry, ShaftEntry, Stiffness, SunEntry,
    Vibrating, VibrationEntry, VibrationOfGearbox,
};
pub use written::{NotWritable, WrittenSize, written, written_with_sizes};

/// A gearbox of any structure.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GearboxFile {
    /// Name of the gearbox.
    pub gearbox: String,
    /// Link where power enters, unless a gear says otherwise.
    pub input: String,
    /// Link where power leaves, unless a gear says otherwise.
    pub output: String,
    /// Links that are no member of a set, as a shaft between two clutches.
    #[serde(default)]
    pub links: Vec<String>,
    /// Planet sets with two central gears, and pairs on fixed axes.
    #[serde(default)]
    pub sets: Vec<SetEntry>,
    /// Planet sets of any other form, gear by gear.
    #[serde(default)]
    pub compound_sets: Vec<CompoundEntry>,
    /// Shift elements that hold a link to the housing.
    #[serde(default)]
    pub brakes: Vec<BrakeEntry>,
    /// Shift elements that join two links, one-way clutches among them.
    #[serde(default)]
    pub clutches: Vec<ClutchEntry>,
    /// Links held for ever. A set may also name `ground` itself.
    #[serde(default)]
    pub grounds: Vec<String>,
    /// Pairs of links joined for ever. Sets may also name one link.
    #[serde(default)]
    pub ties: Vec<[String; 2]>,
    /// The gears.
    #[serde(default)]
    pub gears: Vec<GearEntry>,
    /// Density of the gears, for their mass. Default 7850 kg/m³, steel.
    #[serde(default)]
    pub density: Option<Quantity<MassDensity>>,
    /// Pressure angle, for the radial forces on planets and the checks of teeth. Default 20 deg.
    #[serde(default)]
    pub pressure_angle: Option<Quantity<Angle>>,
    /// Addendum in modules, for the checks of teeth. Default 1.
    #[serde(default)]
    pub addendum: Option<Number>,
    /// Mean coefficient of friction of the teeth in every mesh without friction or efficiency of its own.
    /// Sets whose teeth do not suffice for it are named in a warning.
    #[serde(default)]
    pub friction: Option<Number>,
    /// Drag torques of seals, bearings and churning, for `epicyclic losses`.
    #[serde(default)]
    pub drags: Vec<DragEntry>,
    /// Materials of one's own, for the strength of teeth.
    #[serde(default)]
    pub materials: Vec<MaterialEntry>,
    /// The oil, for the strength of teeth.
    #[serde(default)]
    pub oil: Option<OilEntry>,
    /// Inertias of links and stiffness of shafts, for the vibration of the whole gearbox, and what excites
    /// it.
    #[serde(default)]
    pub vibration: Option<VibrationOfGearbox>,
    /// Required life, for the strength of teeth and bearings.
    #[serde(default)]
    pub life: Option<Quantity<Time>>,
    /// Part of the planet bearings that reach their life: 90, 95, 96, 97, 98 or 99 %. Default 90 %.
    #[serde(default)]
    pub bearing_reliability: Option<Quantity<Ratio>>,
    /// Duty of the gearbox: shares of the time in gears at loads.
    #[serde(default)]
    pub duty: Vec<DutyEntry>,
    /// The greatest torques in its life, for the static strength of teeth.
    #[serde(default)]
    pub overload: Vec<OverloadEntry>,
    /// Required safeties of teeth. Default 1 of flanks and roots.
    #[serde(default)]
    pub required: Option<RequiredEntry>,
    /// Ranges of values without a warning by rules of practice, in place of the usual ones; by names of
    /// rules, in their units.
    #[serde(default)]
    pub limits: BTreeMap<String, StatedLimit>,
    /// Remark, of any form.
    #[serde(default)]
    pub note: Option<Note>,
}

/// A planet set with two central gears, or a pair on fixed axes.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SetEntry {
    /// Name of the set.
    pub id: String,
    /// How its planets join the central wheels; `simple` unless given.
    #[serde(default)]
    pub kind: KindEntry,
    /// Link of the sun, or of the first central wheel.
    pub sun: String,
    /// Link of the ring, or of the second central wheel.
    pub ring: String,
    /// Link of the carrier; left out of a pair.
    #[serde(default)]
    pub carrier: Option<String>,
    /// Size of the basic ratio: `z_b/z_a` of a simple set.
    #[serde(default)]
    pub k: Option<Number>,
    /// Teeth of sun and ring, in place of `k`.
    #[serde(default)]
    pub teeth: Option<[u32; 2]>,
    /// Teeth of the planet; of two planets or two steps, first the one in mesh with the sun.
    #[serde(default)]
    pub planet_teeth: Option<Vec<u32>>,
    /// How many planets stand around the axis. Default: as many as `planet_angles`.
    #[serde(default)]
    pub planets: Option<u32>,
    /// Spacing of the planets. Default `equal`.
    #[serde(default)]
    pub spacing: Option<Spacing>,
    /// Angle of each planet on the carrier, in place of `spacing`. Only differences of angles matter.
    #[serde(default)]
    pub planet_angles: Option<Vec<Quantity<Angle>>>,
    /// Member that floats: it has no bearing of its own, or a flexible one, and shares the load among the
    /// planets. The mesh load factor `K_γ` follows from it where none is given. Default: a floating member is
    /// assumed.
    #[serde(default)]
    pub floating: Option<FloatingEntry>,
    /// Profile shift coefficients of its gears; one above 0 moves the tips of a ring inwards.
    #[serde(default)]
    pub profile_shifts: Option<PerGear<Number>>,
    /// With `profile_shifts`: how far the tips of its gears are moved, in modules; below 0 the teeth are
    /// shorter. Default: external gears as they come, rings shortened to stay out of the fillets of the
    /// planets.
    #[serde(default)]
    pub tip_alterations: Option<PerGear<Number>>,
    /// Tools that cut its gears, by gear.
    #[serde(default)]
    pub tools: BTreeMap<String, ToolEntry>,
    /// Helix angle of its teeth at the reference cylinders; above 0 the planets are right-handed, of a pair
    /// gear 1, below 0 left-handed. `module` is then the normal module, the pressure angle the normal one, as
    /// in ISO 21771. Default 0 deg, spur teeth.
    #[serde(default)]
    pub helix_angle: Option<Quantity<Angle>>,
    /// Helix angle of each mesh from sun to ring, in place of `helix_angle`; each with the hand of its gear
    /// of the planet.
    #[serde(default)]
    pub helix_angles: Option<Vec<Quantity<Angle>>>,
    /// Efficiency `η₀` under a resting carrier, 0.97 or 97 %; 1 unless given.
    #[serde(default)]
    pub efficiency: Option<Quantity<Ratio>>,
    /// Efficiency of each mesh from sun to ring, in place of `efficiency`.
    #[serde(default)]
    pub meshes: Option<Vec<Quantity<Ratio>>>,
    /// Mean coefficients of friction of the meshes from sun to ring, in place of efficiencies: of a set with
    /// teeth.
    #[serde(default)]
    pub friction: Option<Vec<Number>>,
    /// Module of the mesh with the sun, for forces on planets.
    #[serde(default, deserialize_with = "crate::module::optional")]
    #[schemars(with = "Option<Quantity<Module>>")]
    pub module: Option<Quantity<Length>>,
    /// Module of each mesh from sun to ring, in place of `module`: of stepped planets.
    #[serde(default, deserialize_with = "crate::module::list")]
    #[schemars(with = "Option<Vec<Quantity<Module>>>")]
    pub modules: Option<Vec<Quantity<Length>>>,
    /// Centre distance of its meshes with sun and ring, or of the pair, from which open profile shifts
    /// follow: `profile_shifts` then state those of some gears by name, and each mesh gives that of another.
    /// Needs `module`.
    #[serde(default)]
    pub centre_distance: Option<Quantity<Length>>,
    /// Radius of the planets' centres; goes before that of module and teeth.
    #[serde(default)]
    pub carrier_radius: Option<Quantity<Length>>,
    /// Face width of its gears, for the mass of a planet and the strength of teeth.
    #[serde(default)]
    pub face_width: Option<Quantity<Length>>,
    /// Face widths of single gears, which go before `face_width`.
    #[serde(default)]
    pub face_widths: Option<PerGear<Quantity<Length>>>,
    /// Bore of a planet. Default: a solid planet.
    #[serde(default)]
    pub planet_bore: Option<Quantity<Length>>,
    /// Mass of a planet with what turns about its pin; goes before that of its shape.
    #[serde(default)]
    pub planet_mass: Option<Quantity<Mass>>,
    /// Dynamic load rating of the bearings of one planet together, for their life.
    #[serde(default)]
    pub load_rating: Option<Quantity<Force>>,
    /// Rolling elements of these bearings. Default balls.
    #[serde(default)]
    pub bearing_rolling: RollingEntry,
    /// Static load rating of these bearings together, for their safety at rest.
    #[serde(default)]
    pub static_load_rating: Option<Quantity<Force>>,
    /// Fatigue load limit of these bearings together, for their modified life.
    #[serde(default)]
    pub fatigue_limit: Option<Quantity<Force>>,
    /// Mean diameter of these bearings, (d + D)/2, for their modified life.
    #[serde(default)]
    pub bearing_diameter: Option<Quantity<Length>>,
    /// Distance of the middles of the rows of these bearings, for their life under the moment of helical
    /// teeth.
    #[serde(default)]
    pub bearing_span: Option<Quantity<Length>>,
    /// For the strength of its teeth: materials, roughness, tools, given factors.
    #[serde(default)]
    pub strength: Option<StrengthEntry>,
    /// For its data sheet: measuring balls, allowances.
    #[serde(default)]
    pub data_sheet: Option<DataSheetEntry>,
    /// For its vibration: bodies, bearings, supports, stiffness of meshes.
    #[serde(default)]
    pub vibration: Option<VibrationEntry>,
    /// Remark, of any form.
    #[serde(default)]
    pub note: Option<Note>,
}

/// A brake.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BrakeEntry {
    /// Name of the brake.
    pub id: String,
    /// The link it holds.
    pub link: String,
    /// Drag torque while the element is not engaged, for `epicyclic losses` and `epicyclic simulate`.
    #[serde(default)]
    pub drag: Option<DragCurveEntry>,
}

/// A clutch.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ClutchEntry {
    /// Name of the clutch.
    pub id: String,
    /// The links it joins.
    #[serde(default)]
    pub links: Option<[String; 2]>,
    /// In place of `links`, of a one-way clutch: it keeps the first link from turning slower than the second.
    #[serde(default)]
    pub one_way: Option<[String; 2]>,
    /// Drag torque while the element is not engaged, for `epicyclic losses` and `epicyclic simulate`.
    #[serde(default)]
    pub drag: Option<DragCurveEntry>,
}

/// A gear.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GearEntry {
    /// Name of the gear.
    pub name: String,
    /// Engaged brakes and clutches.
    #[serde(default)]
    pub engaged: Vec<String>,
    /// Link where power enters in this gear, if another.
    #[serde(default)]
    pub input: Option<String>,
    /// Link where power leaves in this gear, if another.
    #[serde(default)]
    pub output: Option<String>,
    /// Speeds of links, as many as the gear keeps freedoms: of a power split or summing gear.
    #[serde(default)]
    pub speeds: BTreeMap<String, Quantity<AngularVelocity>>,
    /// Torques at links where power enters or leaves, with `speeds`.
    #[serde(default)]
    pub torques: BTreeMap<String, Quantity<Torque>>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Document;
    use epicyclic_gears::efficiency::MeshEfficiency;
    use epicyclic_train::set::MeshLoss;
    use epicyclic_train::{Gearbox, PlanetSet};

    fn read(text: &str) -> Result<Gearbox, String> {
        let document = Document::parse_one("box.yaml", text.as_bytes()).map_err(|e| e.to_string())?;
        let file: GearboxFile = document.read().map_err(|e| e.to_string())?;
        file.gearbox().map_err(|e| e.to_string())
    }

    const SCHEME: &str =
        "gearbox: I\ninput: D\noutput: B\nsets:\n  - { id: P, sun: D, ring: T1, carrier: B, ";

    #[test]
    fn a_row_is_known_in_one_way() {
        assert_eq!(
            read(&format!("{SCHEME}k: 3, teeth: [20, 60] }}\n")).unwrap_err(),
            "set `P`: give either `k` or `teeth`"
        );
        let exact = read(&format!("{SCHEME}teeth: [20, 60] }}\n")).unwrap();
        assert_eq!(exact.sets()[0].exact_ratio().unwrap().to_string(), "-3");
    }

    #[test]
    fn losses_are_of_the_row_or_of_its_meshes() {
        let loss = |text: &str| {
            read(&format!("{SCHEME}k: 3, {text} }}\n")).map(|g| g.sets()[0].short().unwrap().loss)
        };
        let eta = |value| MeshEfficiency::new(value).unwrap();
        assert_eq!(loss("efficiency: 0.97"), Ok(MeshLoss::Set(eta(0.97))));
        assert_eq!(loss("meshes: [0.98, 0.99]"), Ok(MeshLoss::sun_and_ring(eta(0.98), eta(0.99))));
        assert!(loss("meshes: [0.98]").unwrap_err().contains("with 2 efficiencies"));
        assert!(loss("efficiency: 1.2").unwrap_err().starts_with("set `P`"));
    }

    #[test]
    fn friction_gives_losses_by_geometry() {
        let stage = "teeth: [18, 93], planet_teeth: [36], profile_shifts: [0.389, 0.5039, 0.1171], tip_alterations: [-0.08333, -0.08333, 0]";
        let of = |set: &str, more: &str| {
            read(&format!("{SCHEME}{set} }}\n{more}")).map(|g| g.sets()[0].short().unwrap().loss)
        };
        let loss = |text: &str| of(&format!("{stage}, {text}"), "");
        // NREL reference wind gearbox: H_V 0.149 of the sun's mesh.
        let Ok(MeshLoss::Meshes { first, second, .. }) = loss("friction: [0.037, 0.029]") else { panic!() };
        assert!((first.loss() - 0.149 * 0.037).abs() < 5e-4 * 0.037, "{first}");
        assert!(second.loss() < first.loss());
        assert_eq!(loss("friction: [0.05, 0.05]"), of(stage, "friction: 0.05\n"));
        assert_eq!(
            loss("friction: [0, 0.03]").unwrap_err(),
            "set `P`: coefficient of friction is 0; it must be finite and above 0"
        );
        let beside = loss("friction: [0.05, 0.05], efficiency: 0.97").unwrap_err();
        assert!(beside.contains("give one of `efficiency`"), "{beside}");
        assert!(of("k: 3, friction: [0.05, 0.05]", "").unwrap_err().contains("`teeth` are missing"));
        // That of the gearbox is for sets whose teeth are known and that state no losses.
        assert_eq!(of("k: 3", "friction: 0.05\n"), Ok(MeshLoss::IDEAL));
        let eta = MeshEfficiency::new(0.97).unwrap();
        assert_eq!(of(&format!("{stage}, efficiency: 0.97"), "friction: 0.05\n"), Ok(MeshLoss::Set(eta)));
    }

    #[test]
    fn a_helix_angle_is_of_a_set_whose_teeth_are_known() {
        let of = |set: &str| read(&format!("{SCHEME}{set} }}\n"));
        let spec = |set: &str| of(set).map(|gearbox| gearbox.sets()[0].short().unwrap().clone());
        assert!(spec("teeth: [20, 60], helix_angle: 8 deg").unwrap().is_helical());
        assert_eq!(spec("teeth: [20, 60], helix_angle: 0 deg"), spec("teeth: [20, 60]"));
        assert_eq!(spec("k: 3, helix_angle: 0 deg"), spec("k: 3"));
        // Sizes pick the shifts that it needs.
        assert!(spec("teeth: [20, 60], planet_teeth: [21], helix_angle: 8 deg").unwrap().is_helical());
        for without in ["k: 3, helix_angle: 8 deg", "teeth: [20, 61], helix_angle: 8 deg"] {
            let error = of(without).unwrap_err();
            assert!(error.starts_with("set `P`: helical teeth need teeth in mesh"), "{error}");
        }
        let stepped = "kind: stepped_sun_ring, teeth: [20, 60], planet_teeth: [20, 10]";
        let angles =
            spec(&format!("{stepped}, helix_angles: [8 deg, 0 deg]")).unwrap().tooth_shape.helix_angles;
        assert_eq!(
            angles.iter().map(|angle| epicyclic_units::Physical::degrees(*angle)).collect::<Vec<_>>(),
            [8.0, 0.0]
        );
        assert!(
            of(&format!("{stepped}, helix_angles: [8 deg]")).unwrap_err().contains("has 1 values; 2 are")
        );
        // Below 0 the hands are reversed, and the teeth are otherwise the same.
        let [left, right] = ["-8 deg", "8 deg"]
            .map(|angle| spec(&format!("teeth: [20, 60], helix_angle: {angle}")).unwrap().tooth_shape);
        assert_eq!(left.helix_angle(1), right.helix_angle(1));
        assert_eq!(left.signed_helix_angle(1), -right.signed_helix_angle(1));
        for (angle, told) in [("-61 deg", "-61"), ("61 deg", "61")] {
            let error = of(&format!("teeth: [20, 60], helix_angle: {angle}")).unwrap_err();
            assert!(error.starts_with(&format!("set `P`: helix angle is {told}")), "{error}");
        }
    }

    #[test]
    fn a_slip_of_the_pen_in_a_control_is_not_a_new_link() {
        let wrong = format!("{SCHEME}k: 3 }}\nbrakes: [{{ id: K1, link: T2 }}]\n");
        assert_eq!(
            read(&wrong).unwrap_err(),
            "shift element `K1` names the link `T2`, which does not exist; did you mean `T1`?"
        );
        let wrong = format!("{SCHEME}k: 3, face: 2 }}\n");
        assert!(read(&wrong).unwrap_err().contains("face"));
    }

    #[test]
    fn a_pair_has_no_carrier_and_a_planetary_row_has() {
        let pair = "gearbox: P\ninput: x\noutput: y\nsets: [{ id: P, kind: external_pair, sun: x, ring: y, teeth: [20, 60], meshes: [0.98] }]\ngears: [{ name: only }]\n";
        let gearbox = read(pair).unwrap();
        assert_eq!(gearbox.analyze("only").unwrap().exact_ratio().unwrap().to_string(), "-3");
        assert!(read(&pair.replace("sun: x", "carrier: z, sun: x")).unwrap_err().contains("no `carrier`"));
        assert!(read(&pair.replace("external_pair", "simple")).unwrap_err().contains("`carrier` is missing"));
    }

    /// Shifts that are not stated follow from the centre distance: of the published twin-rotor stage, whose
    /// print has the ring's with the other sign, and of the helical stage of a wind gearbox.
    #[test]
    fn open_shifts_follow_from_the_centre_distance() {
        let shifts = |kind: &str, rest: &str| {
            let text = format!(
                "gearbox: P\ninput: x\noutput: y\nsets: [{{ id: P, kind: {kind}, sun: x, ring: y, {rest} }}]\ngears: [{{ name: only }}]\n"
            );
            let gearbox = read(&text)?;
            let of_set = gearbox.sets()[0].tooth_shape().shifts.clone();
            Ok::<_, String>(of_set.unwrap().profile)
        };
        for (kind, rest, wanted, within) in [
            (
                "external_pair",
                "teeth: [57, 54], module: 2.75 mm, centre_distance: 155 mm, profile_shifts: { gear 2: 0.45 }",
                [0.4618, 0.45],
                5e-5,
            ),
            (
                "internal_pair",
                "teeth: [18, 107], module: 3.5 mm, centre_distance: 155 mm, profile_shifts: { gear 1: 0.5038 }",
                [0.5038, -0.2935],
                5e-5,
            ),
            (
                "external_pair",
                "teeth: [24, 95], module: 14 mm, helix_angle: 10 deg, centre_distance: 861 mm, profile_shifts: { gear 1: 0.48 }",
                [0.48, 0.6691],
                5e-4,
            ),
        ] {
            let found = shifts(kind, rest).unwrap();
            assert!(found.iter().zip(wanted).all(|(one, other)| (one - other).abs() < within), "{found:?}");
        }
        let set = "carrier: h, teeth: [18, 93], planet_teeth: [36], module: 21 mm, centre_distance: 584 mm";
        let simple = |rest: &str| shifts("simple", &format!("{set}, profile_shifts: {rest}"));
        let [of_sun, of_planet, of_ring] = ["{ sun: 0.389 }", "{ planet: 0.503873 }", "{ ring: 0.117115 }"]
            .map(|rest| simple(rest).unwrap());
        for found in [of_sun, of_planet, of_ring] {
            let is_close = |(one, other): (&f64, f64)| (one - other).abs() < 1e-5;
            assert!(found.iter().zip([0.389, 0.503_873, 0.117_115]).all(is_close), "{found:?}");
        }
        let of_planet = |distance: &str| {
            format!(
                "gearbox: P\ninput: x\noutput: h\ncompound_sets: [{{ id: P, carrier: h, suns: {{ x: 18 }}, rings: {{ ground: 93 }}, planet_gears: {{ p: [36] }}, module: 21 mm, profile_shifts: {{ p: 0.503873 }}, meshes: [{{ gears: [x, p], centre_distance: 584 mm }}, {{ gears: [ground, p], centre_distance: {distance} }}] }}]\ngears: [{{ name: only }}]\n"
            )
        };
        let error = read(&of_planet("585 mm")).unwrap_err();
        assert!(error.contains("planet p has the centre distances 584 mm and 585 mm"), "{error}");
        let compound = read(&of_planet("584 mm"));
        let found = compound.unwrap().sets()[0].tooth_shape().shifts.clone().unwrap().profile;
        assert!((found[0] - 0.389).abs() < 1e-5 && (found[1] - 0.117_115).abs() < 1e-5, "{found:?}");
    }

    /// Values of gears are as many as the set has gears, in every kind of set, and those of meshes as many as
    /// it has meshes.
    #[test]
    fn values_of_gears_and_meshes_are_as_many_as_these() {
        let pair = |key: &str| {
            read(&format!(
                "gearbox: P\ninput: x\noutput: y\nsets: [{{ id: P, kind: external_pair, sun: x, ring: y, teeth: [20, 60], {key} }}]\ngears: [{{ name: only }}]\n"
            ))
        };
        let shifts = pair("profile_shifts: [0.2, 0.1]").unwrap().sets()[0].tooth_shape().shifts.clone();
        assert_eq!(shifts.unwrap().profile, [0.2, 0.1]);
        let shifts = pair("profile_shifts: { gear 2: 0.1 }").unwrap().sets()[0].tooth_shape().shifts.clone();
        assert_eq!(shifts.unwrap().profile, [0.0, 0.1]);
        assert!(pair("friction: [0.05]").unwrap().sets()[0].has_losses());
        for (key, message) in [
            ("profile_shifts: [0.2]", "`profile_shifts` has 1 values; 2 are required: gear 1, gear 2"),
            (
                "profile_shifts: { ring: 0.2 }",
                "`profile_shifts` has a value of `ring`, and its gears are gear 1, gear 2",
            ),
            ("tip_alterations: [0, 0]", "where all shifts are 0, write `profile_shifts: {}`"),
            ("friction: [0.2, 0.1]", "`friction` has 2 values; 1 are required"),
            ("tools: { sun: { dedendum: 1.25 } }", "`tools` has a value of `sun`"),
            ("module: 2 mm, modules: [2 mm]", "`module` and `modules` say the same"),
            ("face_widths: [2 mm]", "`face_widths` has 1 values"),
        ] {
            let error = pair(key).unwrap_err();
            assert!(error.contains(message), "{error}");
        }
        let set = |key: &str| read(&format!("{SCHEME}teeth: [20, 60], planet_teeth: [20], {key} }}\n"));
        assert_eq!(
            set("profile_shifts: [0.2, 0.1]").unwrap_err(),
            "set `P`: `profile_shifts` has 2 values; 3 are required: sun, planet, ring"
        );
        assert_eq!(
            set("friction: [0.05]").unwrap_err(),
            "set `P`: `friction` has 1 values; 2 are required: meshes from sun to ring"
        );
    }

    /// Names of gears are those of the solver, in its order, in every kind of set.
    #[test]
    fn gears_have_the_names_of_the_solver() {
        for (kind, planets) in [
            ("simple", "planet_teeth: [20], "),
            ("double_planet", "planet_teeth: [10, 10], "),
            ("stepped_sun_ring", "planet_teeth: [20, 10], "),
            ("stepped_suns", "planet_teeth: [20, 10], "),
            ("stepped_rings", "planet_teeth: [20, 10], "),
            ("meshing_suns", "planet_teeth: [20, 10], "),
            ("bevel", "planet_teeth: [10], "),
            ("external_pair", ""),
            ("internal_pair", ""),
        ] {
            let carrier = if planets.is_empty() { "" } else { "carrier: h, " };
            let text = format!(
                "gearbox: P\ninput: x\noutput: y\nsets: [{{ id: P, kind: {kind}, sun: x, ring: y, teeth: [20, 60], {planets}{carrier}}}]\ngears: [{{ name: only }}]\n"
            );
            let file: GearboxFile = Document::parse_one("p.yaml", text.as_bytes()).unwrap().read().unwrap();
            let built = file.gearbox().unwrap();
            let set = &built.sets()[0];
            let data = file.set_data(set).unwrap();
            let of_solver: Vec<_> =
                set.gears().iter().map(|gear| (set.gear_name(*gear), set.gear_kind(*gear))).collect();
            let names = data.gears.names.into_iter().zip(data.gears.kinds);
            // Bevel planets are bevel gears too, but have no other kind in the solver.
            let is_alike = |one: &(String, _), other: &(String, _)| one.0 == other.0 || kind == "bevel";
            assert!(
                names
                    .into_iter()
                    .zip(&of_solver)
                    .all(|(one, other)| is_alike(&one, other) && one.1 == other.1),
                "{kind}"
            );
            assert_eq!(set.meshes().len(), set.kind().unwrap().meshes());
        }
    }

    /// Angles and spacings of planets are read wherever a set has planets, and refused where they cannot be.
    #[test]
    fn planets_stand_where_the_file_says() {
        use epicyclic_train::spacing::Spacing;
        let set = |keys: &str| {
            read(&format!("{SCHEME}teeth: [26, 96], planet_teeth: [35], {keys} }}\n"))
                .map(|gearbox| gearbox.sets()[0].clone())
        };
        let degrees = |set: &PlanetSet| -> Vec<f64> {
            let angles = set.planet_angles().unwrap();
            angles.iter().map(uom::si::f64::Angle::get::<uom::si::angle::degree>).collect()
        };
        let near = |found: &[f64], expected: &[f64]| {
            found.len() == expected.len()
                && found.iter().zip(expected).all(|(one, other)| (one - other).abs() < 1e-9)
        };
        let step = 360.0 / 122.0;
        let placed = [0.0, 30.0 * step, 180.0, 91.0 * step];
        let least = set("planets: 4, spacing: least_unequal").unwrap();
        assert!(near(&degrees(&least), &placed), "{:?}", degrees(&least));
        // Rounded angles are those of the teeth, in either place, and give the number of planets.
        let given = set("planet_angles: [0 deg, 88.52 deg, 180 deg, 268.53 deg]").unwrap();
        assert_eq!(given.planet_count(), Some(4));
        assert!(near(&degrees(&given), &placed), "{:?}", degrees(&given));
        let old =
            "vibration: { planet_bearing: 400 N/µm, planet_angles: [0 deg, 88.52 deg, 180 deg, 268.53 deg] }";
        assert_eq!(set(old).unwrap().spacing(), given.spacing());
        assert_eq!(*set("planets: 4, spacing: equal").unwrap().spacing(), Spacing::default());
        for (keys, message) in [
            ("planets: 3, planet_angles: [0 deg, 90 deg]", "2 planet angles are given for 3 planets"),
            ("planet_angles: [0 deg, 360 deg]", "planets 1 and 2 have the same angle"),
            ("spacing: least_unequal", "the least unequal spacing needs the number of planets"),
            (
                "planets: 200, spacing: least_unequal",
                "200 planets need 200 assembly positions, and the teeth leave 122",
            ),
            ("spacing: equal, planet_angles: [0 deg, 90 deg]", "stated twice"),
            (&format!("spacing: equal, {old}"), "stated twice"),
        ] {
            let error = set(keys).unwrap_err();
            assert!(error.contains(message), "{error}");
        }
    }

    #[test]
    fn the_schema_describes_every_field() {
        let schema = serde_yaml::to_string(&schemars::schema_for!(GearboxFile)).unwrap();
        assert!(schema.contains("Teeth of sun and ring"));
    }
}
