//! Sets of an arrangement of gears for a ratio, as tables.

use super::shifted::{aim, limited};
use super::{count, left_out, parts, percent, undercut};
use crate::table::columns::Table;
use crate::table::report::AsReport;
use crate::table::report::{Records, Report};
use crate::teeth::answer::arranged::{ArrangedGear, ArrangedNumbers, ArrangedSets};
use epicyclic_units::Dimension;
use epicyclic_units::format::trimmed;

impl AsReport for ArrangedSets {
    fn report(&self) -> Report {
        let words = |name: &str| name.replace('_', " ");
        let motion = &self.mode;
        let title = format!(
            "Ratio {} ({}: {} to {}, {} at rest), within {} %, {}",
            self.ratio,
            motion.letters,
            words(motion.input),
            words(motion.output),
            words(motion.fixed),
            trimmed(100.0 * self.tolerance, 6),
            self.arrangement
        );
        let count = count(self.found, self.shown) + &left_out(self.left_out.as_ref());
        Report {
            title: Some(title),
            parts: parts(sets(self), &self.tooth_checks, &self.judgement, count),
            warnings: None,
        }
    }
}

fn sets(answer: &ArrangedSets) -> Records {
    let places = answer.arrangement.gears();
    let is_pair = answer.arrangement.is_pair();
    let sets = &answer.tooth_numbers;
    let has_shifts = sets.iter().any(|set| set.gears.iter().any(|gear| gear.profile_shift != 0.0));
    let has_modules = sets.iter().any(|set| set.module_ratio != 1.0);
    let gears: Vec<&'static str> = places.iter().map(|gear| gear.name).collect();
    let named: Vec<&'static str> = gears.iter().copied().chain((!is_pair).then_some("planets")).collect();
    let with = |keys: &[&'static str]| [&named, keys].concat();
    let mut main = with(&["ratio", "exact_ratio", "error", "size_in_modules"]);
    main.extend(has_modules.then_some("module_ratio"));
    main.extend((!is_pair).then_some("planet_gap_in_modules"));
    main.extend(["common_divisors", "undercut"]);
    let mut table = Table::new("tooth_numbers", sets)
        .each(places.iter().enumerate(), |table, (place, gear)| {
            table.number(gear.name, &gear.to_string(), move |set: &&ArrangedNumbers| set.gears[place].teeth)
        })
        .number("planets", "planets", |set| set.planets)
        .number("ratio", "ratio", |set| set.ratio)
        .number("exact_ratio", "exact", |set| set.exact_ratio.to_string())
        .number("ratio_error", "error", |set| set.ratio_error)
        .number("error", "error, %", |set| percent(set.ratio_error))
        .for_people()
        .number("module_ratio", "m2/m1", |set| set.module_ratio)
        .printed("size_in_modules", "size", 1, |set| set.size_in_modules)
        .number("assembly_positions", "positions", |set| set.assembly_positions.map(|all| all as f64))
        .printed("planet_gap_in_modules", "gap", 3, |set| set.planet_gap_in_modules)
        .words("common_divisors", "divisors", |set| listed(&set.common_divisors))
        .words("undercut", "undercut", |set| {
            let names: Vec<(bool, String)> =
                set.gears.iter().map(|gear| (gear.undercut, gear.gear.replace('_', " "))).collect();
            let names: Vec<(bool, &str)> = names.iter().map(|(is, name)| (*is, name.as_str())).collect();
            undercut(&names)
        })
        .words("profile_shifts", "profile shifts", |set| {
            let shift = |gear: &ArrangedGear| trimmed(gear.profile_shift, 5);
            set.gears.iter().map(shift).collect::<Vec<_>>().join(" ")
        })
        .words("tip_alterations", "tip alterations", |set| {
            let tip = |gear: &ArrangedGear| trimmed(gear.tip_alteration, 5);
            set.gears.iter().map(tip).collect::<Vec<_>>().join(" ")
        })
        .each(places.iter().enumerate(), |table, (place, gear)| {
            let [shift, tip] = shift_keys(gear.name);
            table
                .printed(shift, &format!("x {gear}"), 4, move |set| set.gears[place].profile_shift)
                .for_people()
                .printed(tip, &format!("k {gear}"), 4, move |set| set.gears[place].tip_alteration)
                .for_people()
        })
        .words("aim_met", "aim met", |set| set.aim_met)
        .words("equal_spacing", "equal", |set| set.equal_spacing)
        .list("planet_angles", "", Dimension::Angle, |set| set.planet_angles_rad.clone())
        .number("imbalance", "imbalance", |set| set.imbalance)
        .view_of("Tooth numbers", &main)
        .note(note(is_pair));
    if let Some(wanted) = answer.aim.filter(|_| has_shifts) {
        let has_tips = sets.iter().any(|set| set.gears.iter().any(|gear| gear.tip_alteration != 0.0));
        let shifts = places.iter().map(|gear| shift_keys(gear.name)[0]);
        let tips = places.iter().map(|gear| shift_keys(gear.name)[1]).filter(|_| has_tips);
        let shown: Vec<&'static str> = shifts.chain(tips).chain(["aim_met"]).collect();
        let (aim, limited) = (aim(wanted), limited(sets.iter().all(|set| set.aim_met != Some(false))));
        let what = "x: profile shift, of a ring above 0 inwards; k: tip alteration, in modules";
        table = table.view_of("Profile shifts", &with(&shown)).note(format!("{what}. Aim: {aim}{limited}."));
    }
    if sets.iter().any(|set| !set.equal_spacing) {
        table = table.view_of(
            "Angles of the planets in degrees, and imbalance",
            &with(&["planet_angles", "imbalance"]),
        );
    }
    table.the_answer().records()
}

/// Keys of the profile shift and the tip alteration of a gear.
fn shift_keys(gear: &str) -> [&'static str; 2] {
    macro_rules! keys {
        ($($name:literal)*) => {
            match gear {
                $($name => [concat!("profile_shift_", $name), concat!("tip_alteration_", $name)],)*
                _ => ["profile_shift", "tip_alteration"],
            }
        };
    }
    keys!("sun" "first_step" "second_step" "ring" "first_sun" "second_sun" "first_ring" "second_ring"
        "small_sun" "short_planet" "long_planet" "large_sun")
}

const fn note(is_pair: bool) -> &'static str {
    if is_pair {
        "Size: teeth of both gears, of an internal pair those of the ring. Divisors: greatest common divisor of the teeth in \
         mesh; 1 makes every tooth meet every other."
    } else {
        "Size: diameter of the reference circles, in modules; gap: between gears that do not mesh. Divisors: greatest common \
         divisor of the teeth in each mesh; 1 makes every tooth meet every other."
    }
}

fn listed(numbers: &[u32]) -> String {
    numbers.iter().map(u32::to_string).collect::<Vec<_>>().join(" ")
}
