//! Masses and inertias of the parts of a drive.

use crate::shared::number::{maybe_si, si};
use epicyclic_dynamics::drive::{self as dynamics, DriveDesign};
use epicyclic_gears::carrier::Carrier;
use epicyclic_gears::geometry::ToothedGear;
use epicyclic_gears::mass::{FormulaEight, published_gear_inertia};
use schemars::JsonSchema;
use serde::Serialize;

/// Masses and inertias of the parts of a drive.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct Masses {
    /// Mass and inertia of the sun.
    pub sun: GearMass,
    /// Mass and inertia of one planet.
    pub planet: GearMass,
    /// Mass and inertia of the carrier without planets.
    pub carrier: CarrierMass,
}

/// Mass and inertia of a gear.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct GearMass {
    /// Diameter of the bore in m; 0 for none.
    pub bore_m: f64,
    /// Volume of the teeth in m³, half of the annulus between root and tip circle.
    pub teeth_volume_m3: f64,
    /// Volume of the body within the root circle minus its bore, in m³.
    pub body_volume_m3: f64,
    /// Mass of the gear in kg, as given or from its shape.
    pub mass_kg: f64,
    /// Inertia of the gear about its own axis in kg·m², as given or from its shape.
    pub inertia_kg_m2: f64,
    /// Mass from the shape, in kg.
    pub shape_mass_kg: f64,
    /// Inertia from the shape, in kg·m².
    pub shape_inertia_kg_m2: f64,
    /// Inertia by the source's formula, which subtracts the bore twice, in kg·m²; null if that formula has no
    /// value.
    pub source_inertia_kg_m2: Option<f64>,
}

/// Mass and inertia of the carrier.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct CarrierMass {
    /// Mass of the carrier in kg; null if neither the mass nor the shape is given.
    pub mass_kg: Option<f64>,
    /// Inertia of the carrier about the gearbox axis, in kg·m².
    pub inertia_kg_m2: f64,
    /// Steps of the calculation from the shape; null if no shape is given.
    pub shape: Option<CarrierShape>,
}

/// Area, volume, mass, centroid and inertia of a carrier of equal arms around a hub.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct CarrierShape {
    /// Area of an arm without its hole, in m².
    pub plate_area_m2: f64,
    /// Area of the hole in an arm, in m².
    pub hole_area_m2: f64,
    /// Volume of an arm in m³.
    pub arm_volume_m3: f64,
    /// Mass of an arm in kg.
    pub arm_mass_kg: f64,
    /// Distance of an arm's centroid from its outer end, in m.
    pub arm_centroid_from_outer_end_m: f64,
    /// Distance of an arm's centroid from the gearbox axis, in m.
    pub arm_centroid_radius_m: f64,
    /// Inertia of all arms about the gearbox axis, in kg·m².
    pub arms_inertia_kg_m2: f64,
    /// Volume of the hub in m³.
    pub hub_volume_m3: f64,
    /// Mass of the hub in kg.
    pub hub_mass_kg: f64,
    /// Inertia of the hub in kg·m².
    pub hub_inertia_kg_m2: f64,
    /// Mass of the carrier in kg.
    pub mass_kg: f64,
    /// Inertia of the carrier in kg·m².
    pub inertia_kg_m2: f64,
    /// Inertia of the carrier by the source's formula in kg·m²: arms as thin rods, the hub with ¼·(R² − r²).
    pub source_inertia_kg_m2: f64,
}

impl Masses {
    pub(super) fn of(design: &DriveDesign) -> Self {
        let masses = &design.masses;
        Self {
            sun: GearMass::of(&masses.sun, &design.gear_set.sun),
            planet: GearMass::of(&masses.planet, &design.gear_set.planet),
            carrier: CarrierMass {
                mass_kg: maybe_si(masses.carrier),
                inertia_kg_m2: si(masses.carrier_inertia),
                shape: masses.carrier_shape.as_ref().map(CarrierShape::of),
            },
        }
    }
}

impl GearMass {
    fn of(part: &dynamics::GearMass, gear: &ToothedGear) -> Self {
        let shape = part.body.total();
        let (tip, root) = (gear.tip_diameter(), gear.root_diameter());
        let source = published_gear_inertia(FormulaEight::Likely, shape.mass, tip, root, part.bore);
        Self {
            bore_m: si(part.bore),
            teeth_volume_m3: si(part.body.tooth_zone.volume),
            body_volume_m3: si(part.body.body.volume),
            mass_kg: si(part.mass),
            inertia_kg_m2: si(part.inertia),
            shape_mass_kg: si(shape.mass),
            shape_inertia_kg_m2: si(shape.polar_inertia),
            source_inertia_kg_m2: source.ok().map(si),
        }
    }
}

impl CarrierShape {
    fn of(carrier: &Carrier) -> Self {
        let ([plate, hole], arm, hub, whole) =
            (carrier.arm_areas(), carrier.arm(), carrier.hub(), carrier.total());
        Self {
            plate_area_m2: si(plate),
            hole_area_m2: si(hole),
            arm_volume_m3: si(arm.volume),
            arm_mass_kg: si(arm.mass),
            arm_centroid_from_outer_end_m: si(carrier.arm_centroid_from_outer_end()),
            arm_centroid_radius_m: si(carrier.arm_centroid_radius()),
            arms_inertia_kg_m2: si(carrier.arms().polar_inertia),
            hub_volume_m3: si(hub.volume),
            hub_mass_kg: si(hub.mass),
            hub_inertia_kg_m2: si(hub.polar_inertia),
            mass_kg: si(whole.mass),
            inertia_kg_m2: si(whole.polar_inertia),
            source_inertia_kg_m2: si(carrier.published_inertia().total()),
        }
    }
}
