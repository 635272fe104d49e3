//! Judgement of a drive.

use super::Drive;
use crate::shared::judgement::answer::Judgement;
use crate::shared::judgement::whole::FoundRatio;
use epicyclic_dynamics::drive::DriveSpec;
use epicyclic_judge::Rule;
use epicyclic_units::Physical as _;

/// Name of the drive, and of its only gear.
const DRIVE: &str = "drive";

/// Rules with findings of the drive in their place: an overlap of planets, a ratio beyond its tolerance.
const OF_DRIVE: [Rule; 3] = [Rule::RatioDeviation, Rule::NeighbourGap, Rule::NeighbourGapLength];

/// Judges a drive, and adds the misses to its warnings.
pub(super) fn judge(drive: &mut Drive, spec: &DriveSpec) {
    drive.judgement = judgement(spec, drive);
    let overlaps = drive.tooth_numbers.tip_gap_m <= 0.0;
    let own = if overlaps { &OF_DRIVE[..] } else { &OF_DRIVE[..1] };
    drive.warnings.extend(drive.judgement.warnings_but(|check| check.is_of(own)));
}

/// Judges a drive by what the file of a gearbox would say of it, and its ratio by the one asked for.
fn judgement(spec: &DriveSpec, drive: &Drive) -> Judgement {
    let (numbers, set, rack) = (&drive.tooth_numbers, &drive.gear_set, spec.gear_set.rack);
    let tool = format!("{{ dedendum: {} }}", rack.addendum + rack.clearance);
    let text = format!(
        "gearbox: {DRIVE}
input: sun
output: carrier
sets:
  - id: gears
    sun: sun
    ring: ground
    carrier: carrier
    teeth: [{}, {}]
    planet_teeth: [{}]
    planets: {}
    spacing: {}
    module: {} m
    face_width: {} m
    planet_bore: {} m
    efficiency: {}
    tools: {{ sun: {tool}, planet: {tool}, ring: {tool} }}
addendum: {}
pressure_angle: {} rad
gears: [{{ name: {DRIVE} }}]
duty: [{{ gear: {DRIVE}, share: 1, torque: {} N·m, speed: {} rad/s }}]
",
        numbers.sun,
        numbers.ring,
        numbers.planet,
        numbers.planets,
        if numbers.equal_spacing { "equal" } else { "least_unequal" },
        set.module_m,
        set.face_width_m,
        drive.masses.planet.bore_m,
        drive.efficiencies.basic,
        rack.addendum,
        rack.pressure_angle.si(),
        drive.torques.sun_n_m,
        drive.speeds.sun_rad_s,
    );
    let ratio = FoundRatio {
        gear: DRIVE.to_owned(),
        wanted: spec.ratio,
        tolerance: spec.ratio_tolerance,
        found: numbers.ratio,
    };
    Judgement::of_written(DRIVE, Ok(text), &[ratio])
}
