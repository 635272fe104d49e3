//! Faults of a specification, as far as neither the search for tooth numbers nor the sizes of the parts
//! decide them.

use super::spec::{CarrierSpec, DriveSpec, Given, TeethSpec};
use crate::Error;
use crate::equivalent_inertia::{Link, LinkName};
use epicyclic_gears::Quantity;
use epicyclic_gears::carrier::{Arm, Carrier, Hub};
use epicyclic_gears::quantity::SimpleGear;
use epicyclic_gears::rack::BasicRack;
use epicyclic_gears::synthesis::{MOST_PLANETS, MOST_TEETH, ToothNumbers, check_tolerance};
use epicyclic_units::Physical;
use std::ops::RangeInclusive;
use uom::si::f64::{Length, MassDensity, MomentOfInertia};

impl DriveSpec {
    /// All independent faults of the values, each by itself or with the values beside it; none for a
    /// drive that can be designed if teeth are found and its parts have room.
    #[must_use]
    pub fn faults(&self) -> Vec<Error> {
        let mut faults = vec![];
        let mut check = |checked: Result<(), Error>| faults.extend(checked.err());
        check(positive(Given::Power, self.power.kw(), "kW"));
        check(positive(Given::Speed, self.speed.rpm(), "rpm"));
        check(positive(Given::Ratio, self.ratio, ""));
        check(check_tolerance(self.ratio_tolerance).map_err(Error::Gear));
        if let Some(driving) = self.driving_torque {
            check(positive(Given::DrivingTorque, driving.si(), "N·m"));
        }
        if let Some(value) = self.load.map(Physical::si).filter(|value| !value.is_finite()) {
            check(Err(Error::LoadNotFinite { value }));
        }
        let set = &self.gear_set;
        check(above_0(Quantity::Module, set.module.mm(), "mm"));
        check(above_0(Quantity::FaceWidth, set.face_width.mm(), "mm"));
        check(above_0(Quantity::Density, set.density.si(), "kg/m³"));
        check(above_0(Quantity::AllowableStress, self.shafts.allowable_stress.mpa(), "MPa"));
        check(inertia(LinkName::Motor, self.motor_inertia));
        check(inertia(LinkName::Machine, self.machine_inertia));
        let of_rack = rack(set.rack);
        // The least teeth without undercut follow from the rack.
        if of_rack.is_empty() {
            faults.extend(teeth(&self.teeth));
        }
        faults.extend(of_rack);
        faults.extend(carrier(&self.carrier));
        faults
    }
}

fn positive(quantity: Given, value: f64, unit: &'static str) -> Result<(), Error> {
    if value > 0.0 && value.is_finite() { Ok(()) } else { Err(Error::NotPositive { quantity, value, unit }) }
}

fn above_0(quantity: Quantity, value: f64, unit: &'static str) -> Result<(), Error> {
    if value > 0.0 && value.is_finite() {
        Ok(())
    } else {
        Err(epicyclic_gears::Error::NotPositive { quantity, value, unit }.into())
    }
}

fn inertia(of: LinkName, given: MomentOfInertia) -> Result<(), Error> {
    Link::central(of, given, 1.0).equivalent_inertia().map(|_| ())
}

fn rack(rack: BasicRack) -> Vec<Error> {
    let BasicRack { addendum, clearance, pressure_angle } = rack;
    let usual = BasicRack::default();
    let checked = [
        above_0(Quantity::AddendumCoefficient, addendum, ""),
        BasicRack { clearance, ..usual }.check().map_err(Error::Gear),
        BasicRack { pressure_angle, ..usual }.check().map_err(Error::Gear),
    ];
    checked.into_iter().filter_map(Result::err).collect()
}

fn teeth(given: &TeethSpec) -> Vec<Error> {
    let one = |number: u32| number..=number;
    let (gears, planets, tip_gap) = match given {
        TeethSpec::Given { teeth, tip_gap, .. } => {
            ([teeth.sun, teeth.planet, teeth.ring].map(|gear| one(gear.get())), one(teeth.planets), *tip_gap)
        }
        TeethSpec::Within(bounds) => {
            let gears = [bounds.sun.clone(), bounds.planet.clone(), bounds.ring.clone()];
            (gears, bounds.planets.clone(), bounds.tip_gap)
        }
    };
    let mut faults: Vec<epicyclic_gears::Error> = vec![];
    let names = [SimpleGear::Sun, SimpleGear::Planet, SimpleGear::Ring];
    // In 64 bits, since any numbers may be given.
    let is_coaxial = |teeth: &ToothNumbers| {
        u64::from(teeth.ring.get()) == u64::from(teeth.sun.get()) + 2 * u64::from(teeth.planet.get())
    };
    let follows = matches!(given, TeethSpec::Given { teeth, .. } if is_coaxial(teeth));
    for (gear, range) in names.into_iter().zip(&gears) {
        // A ring that follows from sun and planet is too large because they are.
        if gear == SimpleGear::Ring && follows && !faults.is_empty() {
            break;
        }
        if *range.start() == 0 {
            faults.push(epicyclic_gears::Error::NoTeeth);
        } else if !within(range, 1, MOST_TEETH) {
            let (from, to) = (*range.start(), *range.end());
            faults.push(epicyclic_gears::Error::ToothRange { gear, from, to, most: MOST_TEETH });
        }
    }
    let fit = faults.is_empty();
    if !within(&planets, 2, MOST_PLANETS) {
        let (from, to) = (*planets.start(), *planets.end());
        faults.push(epicyclic_gears::Error::PlanetNumber { from, to, most: MOST_PLANETS });
    }
    if !(tip_gap >= 0.0 && tip_gap.is_finite()) {
        let (quantity, value, unit) = (Quantity::TipGap, tip_gap, "modules");
        faults.push(epicyclic_gears::Error::Negative { quantity, value, unit });
    }
    let mut faults: Vec<Error> = faults.into_iter().map(Error::Gear).collect();
    if let TeethSpec::Given { teeth, .. } = given
        && fit
        && !follows
    {
        let (sun, planet, ring) = (teeth.sun.get(), teeth.planet.get(), teeth.ring.get());
        faults.push(Error::UnequalCentreDistances { sun, planet, ring });
    }
    faults
}

fn within(range: &RangeInclusive<u32>, least: u32, most: u32) -> bool {
    !range.is_empty() && *range.start() >= least && *range.end() <= most
}

fn carrier(given: &CarrierSpec) -> Vec<Error> {
    let (arm, hub) = match *given {
        CarrierSpec::Neglected => return vec![],
        CarrierSpec::Inertia(given) => return inertia(LinkName::Carrier, given).err().into_iter().collect(),
        CarrierSpec::Shape { arm, hub } => (arm, hub),
    };
    let lengths = [
        (Quantity::ArmLength, Some(arm.length)),
        (Quantity::ArmWidth, Some(arm.width)),
        (Quantity::ArmThickness, Some(arm.thickness)),
        (Quantity::HoleRadius, arm.hole.map(|hole| hole.radius)),
        (Quantity::HubOutsideRadius, Some(hub.outer_radius)),
        (Quantity::Width, Some(hub.width)),
    ];
    let given = lengths.into_iter().filter_map(|(quantity, length)| Some((quantity, length?)));
    let faults: Vec<Error> =
        given.filter_map(|(quantity, length)| above_0(quantity, length.mm(), "mm").err()).collect();
    if !faults.is_empty() {
        return faults;
    }
    // Hole and bore are within other lengths. Two arms have room beside each other on any hub.
    let of = |arm, hub| Carrier::new(2, arm, hub, MassDensity::from_si(1.0)).err().map(Error::Gear);
    let hole = of(arm, Hub { inner_radius: Length::from_si(0.0), ..hub });
    let bore = of(Arm { hole: None, ..arm }, hub);
    hole.into_iter().chain(bore).collect()
}
