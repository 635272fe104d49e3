//! Tables of shift elements and shifts over all gears, against the gears one by one, the balance of each link
//! and a calculation by hand.

#![allow(clippy::unwrap_used, reason = "helpers of tests, which clippy does not know for such")]

use epicyclic_commands::analyze::answer::gear;
use epicyclic_commands::analyze::answer::gear::OneGear;
use epicyclic_commands::analyze::answer::overview;
use epicyclic_commands::analyze::answer::overview::Overview;
use epicyclic_commands::analyze::answer::shifts;
use epicyclic_commands::analyze::answer::shifts::Transition;
use epicyclic_commands::analyze::answer::{Input, elements};
use epicyclic_commands::compare::Request;
use epicyclic_commands::compare::answer::{Candidate, FigureName, GearsBy};
use epicyclic_commands::shared::gearbox::{Choice, Gearbox, one};
use epicyclic_commands::shared::load::Load;
use epicyclic_formats::Document;
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_units::{Physical as _, Quantity};
use std::collections::BTreeMap;
use std::path::Path;
use uom::si::f64::{AngularVelocity, Torque};

fn document(name: &str) -> Document {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    Document::parse_one(name, &std::fs::read(file).unwrap()).unwrap()
}

/// A transmission of the list, with or without losses.
fn choice(transmission: &str, efficiency: Option<f64>) -> Choice {
    let efficiency = efficiency.map(|eta| MeshEfficiency::new(eta).unwrap());
    Choice { transmission: Some(transmission.to_owned()), efficiency }
}

/// Gearboxes of several gears, with losses.
fn each(check: impl Fn(&Gearbox, &Overview)) {
    let list = document("real-transmissions.yaml");
    let transmissions = ["8HP", "TH400", "AOD"].map(|name| (&list, choice(name, Some(0.97))));
    let files = ["scheme-ii-3.yaml", "ravigneaux.yaml", "sized-gearbox.yaml"].map(document);
    let files = files.iter().map(|document| (document, Choice::default()));
    for (document, choice) in transmissions.into_iter().chain(files) {
        let subject = one(document, &choice).unwrap();
        check(&subject, &overview::answer(&subject, Input::default(), None).unwrap());
    }
}

fn in_full(subject: &Gearbox, gear: &str, input: Input) -> OneGear {
    gear::answer(subject, gear, input).unwrap()
}

fn is_near(one: f64, other: f64) -> bool {
    (one - other).abs() < 1e-9 * one.abs().max(other.abs()).max(1.0)
}

#[test]
fn slips_are_differences_of_the_speeds_of_links() {
    each(|subject, overview| {
        for gear in &overview.gears {
            let links = in_full(subject, &gear.facts.gear, Input::default()).links;
            let speed = |name: &String| {
                if name == "ground" {
                    Some(0.0)
                } else {
                    links.iter().find(|link| link.link == *name)?.speed_of_input
                }
            };
            for (one, element) in gear.shift_elements.iter().zip(&overview.shift_elements) {
                let [first, second] = element.element.links.each_ref().map(speed);
                assert!(is_near(one.duty.slip_of_input.unwrap(), first.unwrap() - second.unwrap()));
                assert_eq!(one.duty.engaged, gear.facts.engaged.contains(&one.shift_element));
            }
        }
    });
}

/// On each link: input and output, shift elements, and the reactions of the sets' members.
#[test]
fn torques_of_shift_elements_balance_each_link() {
    each(|subject, overview| {
        for gear in &overview.gears {
            let full = in_full(subject, &gear.facts.gear, Input::default());
            let mut all: BTreeMap<String, f64> = BTreeMap::new();
            let mut on = |link: &str, torque: f64| *all.entry(link.to_owned()).or_default() += torque;
            let outside = full.torques.as_ref().unwrap().with_losses.as_ref().unwrap();
            on(&full.gear.input, outside.input);
            on(&full.gear.output, outside.output);
            for (one, element) in gear.shift_elements.iter().zip(&overview.shift_elements) {
                let torque = one.duty.torque_of_input.unwrap();
                on(&element.element.links[0], torque);
                on(&element.element.links[1], -torque);
            }
            for member in &full.members {
                on(&member.link, -member.torque_of_input.unwrap_or_default());
            }
            all.remove("ground");
            for (link, sum) in &all {
                assert!(sum.abs() < 1e-9, "{} {link} {sum}", gear.facts.gear);
            }
        }
    });
}

#[test]
fn maxima_are_those_of_the_gears_one_by_one() {
    each(|subject, overview| {
        let gears: Vec<OneGear> =
            overview.gears.iter().map(|gear| in_full(subject, &gear.facts.gear, Input::default())).collect();
        for (place, element) in overview.shift_elements.iter().enumerate() {
            let most = |of: fn(&gear::ShiftElement) -> Option<f64>| {
                gears
                    .iter()
                    .filter_map(|gear| of(&gear.shift_elements[place]))
                    .map(f64::abs)
                    .fold(0.0, f64::max)
            };
            let torque = element.largest_torque.as_ref().map_or(0.0, |torque| torque.torque_of_input.abs());
            let slip = element.largest_slip.as_ref().map_or(0.0, |slip| slip.slip_of_input.abs());
            assert!(is_near(torque, most(|element| element.does.torque_of_input)));
            assert!(is_near(slip, most(|element| element.does.slip_of_input)));
        }
        for planet in &overview.planets {
            let own = gears.iter().flat_map(|gear| &gear.planets);
            let own = own.filter(|one| one.set == planet.set && one.planet == planet.planet);
            let most = own.filter_map(|one| one.relative_speed_of_input).map(f64::abs).fold(0.0, f64::max);
            let told = planet.largest_speed.as_ref().map_or(0.0, |speed| speed.relative_speed_of_input.abs());
            assert!(is_near(told, most));
        }
    });
}

/// The TH400 is a Simpson set: both suns one link, k = 54/26 = 27/13 twice, without losses.
#[test]
fn a_simpson_set_by_hand() {
    let list = document("real-transmissions.yaml");
    let subject = one(&list, &choice("TH400", None)).unwrap();
    let found = overview::answer(&subject, Input::default(), None).unwrap();
    let k: f64 = 27.0 / 13.0;
    let of = |gear: &str, element: &str| {
        let gear = found.gears.iter().find(|one| one.facts.gear == gear).unwrap();
        let one = gear.shift_elements.iter().find(|one| one.shift_element == element).unwrap();
        (one.duty.torque_of_input.unwrap(), one.duty.slip_of_input.unwrap())
    };
    for (gear, element, torque, slip) in [
        // First: the input drives ring A, the brake holds carrier B. The suns take 1/k of the input, and ring
        // B with it 1.
        ("1", "FWD", -1.0, 0.0),
        ("1", "LR", 1.0 + 1.0 / k, 0.0),
        ("1", "INT", 0.0, -k / (2.0 + 1.0 / k)),
        ("1", "DIR", 0.0, 1.0 + k / (2.0 + 1.0 / k)),
        // Second: the brake holds the suns. Set B idles.
        ("2", "FWD", -1.0, 0.0),
        ("2", "INT", 1.0 / k, 0.0),
        ("2", "LR", 0.0, (k / (1.0 + k)).powi(2)),
        ("2", "DIR", 0.0, 1.0),
        // Third: ring and sun of set A share the input as k to 1.
        ("3", "FWD", -k / (1.0 + k), 0.0),
        ("3", "DIR", -1.0 / (1.0 + k), 0.0),
        ("3", "LR", 0.0, 1.0),
        ("3", "INT", 0.0, 1.0),
        // Reverse: the suns drive, carrier B is held. Ring A turns free.
        ("R", "DIR", -1.0, 0.0),
        ("R", "LR", -(1.0 + k), 0.0),
        ("R", "FWD", 0.0, 1.0 + (2.0 + 1.0 / k) / k),
    ] {
        let (found_torque, found_slip) = of(gear, element);
        assert!(
            is_near(found_torque, torque) && is_near(found_slip, slip),
            "{gear} {element} {found_torque} {found_slip}"
        );
    }
    let largest = |element: &str| -> (String, f64, String, f64) {
        let one = found.shift_elements.iter().find(|one| one.element.shift_element == element).unwrap();
        let elements::OverGears { largest_torque: Some(torque), largest_slip: Some(slip), .. } = one else {
            panic!("{element} carries torque and slips");
        };
        (torque.gear.clone(), torque.torque_of_input, slip.gear.clone(), slip.slip_of_input)
    };
    let (gear, torque, slips_in, slip) = largest("LR");
    assert!(gear == "R" && slips_in == "3" && is_near(torque, -40.0 / 13.0) && is_near(slip, 1.0));
    let (gear, torque, slips_in, slip) = largest("DIR");
    assert!(gear == "R" && slips_in == "1" && is_near(torque, -1.0) && is_near(slip, 1.0 + 729.0 / 871.0));
    // The shifts: one element is released and one applied.
    let due = [("1", "2", "LR", "INT"), ("2", "3", "INT", "DIR")];
    assert_eq!(found.shifts.len(), due.len());
    for (shift, (from, to, released, applied)) in found.shifts.iter().zip(due) {
        assert_eq!((&shift.from[..], &shift.to[..], shift.transition), (from, to, Transition::Single));
        assert_eq!(
            (&shift.released[..], &shift.applied[..]),
            (&[released.to_owned()][..], &[applied.to_owned()][..])
        );
    }
    // 67/27, 40/27 and 1: spread 67/27, steps 67/40 and 40/27, whose quotient is the progression factor.
    let [forward] = &found.progressions[..] else { panic!("one gear reverses") };
    assert!(is_near(forward.spread, 67.0 / 27.0) && forward.ratios == 3 && !forward.reverses);
    assert!(is_near(forward.progression_factor.unwrap(), 67.0 / 40.0 / (40.0 / 27.0)));
    let second = &found.gears[1];
    assert!(is_near(second.geometric_deviation.unwrap(), 40.0 / 27.0 / (67.0_f64 / 27.0).sqrt() - 1.0));
    assert!(second.progressive_deviation.unwrap().abs() < 1e-12);
}

/// At the output's unchanged speed the gear after is that of its own answer at the input's new speed.
#[test]
fn a_shift_leads_to_the_slips_of_the_next_gear_at_the_new_speed() {
    let speed = AngularVelocity::from_si(150.0);
    each(|subject, overview| {
        let all = shifts::answer(subject, Some(speed)).unwrap();
        assert!(!all.shifts.is_empty());
        for shift in &all.shifts {
            let input = |speed: f64| Input { speed: Some(AngularVelocity::from_si(speed)), load: None };
            let before = in_full(subject, &shift.from, input(150.0));
            let after = in_full(subject, &shift.to, input(shift.input_speed_after_rad_s.unwrap()));
            let output =
                |gear: &OneGear| gear.links.iter().find(|link| link.is_output).unwrap().speed_rad_s.unwrap();
            assert!(is_near(output(&before), output(&after)));
            for (place, one) in shift.shift_elements.iter().enumerate() {
                let slip = |gear: &OneGear| gear.shift_elements[place].does.slip_rad_s.unwrap();
                assert!(is_near(one.slip_before_rad_s.unwrap(), slip(&before)));
                assert!(is_near(one.slip_after_rad_s.unwrap(), slip(&after)));
            }
            // Released and applied take the engaged of one gear to those of the other.
            let engaged = |gear: &str| {
                let gear = overview.gears.iter().find(|one| one.facts.gear == gear).unwrap();
                gear.facts.engaged.clone()
            };
            let mut reached: Vec<String> = engaged(&shift.from)
                .into_iter()
                .filter(|one| !shift.released.contains(one) && !shift.one_way_released.contains(one))
                .chain(shift.applied.iter().chain(&shift.one_way_applied).cloned())
                .collect();
            let mut due = engaged(&shift.to);
            reached.sort();
            due.sort();
            assert_eq!(reached, due);
        }
        // The neighbours among them are those of the overview.
        let neighbours = all.shifts.iter().filter(|shift| shift.skipped_ratios == 0).count();
        assert_eq!(neighbours, overview.shifts.len());
    });
}

#[test]
fn the_eight_speed_has_single_transitions_between_neighbours_and_over_one_gear() {
    let list = document("real-transmissions.yaml");
    let subject = one(&list, &choice("8HP", None)).unwrap();
    let all = shifts::answer(&subject, None).unwrap().shifts;
    assert_eq!(all.len(), 8 * 7 / 2);
    for shift in &all {
        if shift.skipped_ratios < 2 {
            assert_eq!(shift.transition, Transition::Single, "{} {}", shift.from, shift.to);
        }
    }
    // 8-2: A E are kept, B and D change over.
    let kickdown = all.iter().find(|shift| shift.from == "2" && shift.to == "8").unwrap();
    assert_eq!(
        (&kickdown.released[..], &kickdown.applied[..]),
        (&["B".to_owned()][..], &["D".to_owned()][..])
    );
}

#[test]
fn a_one_way_clutch_acts_by_itself_in_a_shift() {
    let document = document("ravigneaux.yaml");
    let subject = one(&document, &Choice::default()).unwrap();
    let found = overview::answer(&subject, Input::default(), None).unwrap();
    let first = found.shifts.iter().find(|shift| shift.from == "1" && shift.to == "2").unwrap();
    assert!(first.released.is_empty() && first.one_way_released == ["F1"] && first.applied == ["B2"]);
    assert_eq!(first.transition, Transition::Single);
    // The same ratio with engine braking: a neighbour of the same gear.
    let low = found.shifts.iter().find(|shift| shift.from == "1 low" && shift.to == "2").unwrap();
    assert_eq!((&low.released[..], &low.applied[..]), (&["LR".to_owned()][..], &["B2".to_owned()][..]));
}

#[test]
fn a_gearbox_beside_itself_differs_in_nothing_and_others_are_laid_by_ratio() {
    let list = document("real-transmissions.yaml");
    let [eight, simpson] = ["8HP", "TH400"].map(|name| one(&list, &choice(name, Some(0.97))).unwrap());
    let candidate = |subject| Candidate { subject, from: "file".to_owned() };
    let same = Request::default().answer(&[candidate(&eight), candidate(&eight)]).unwrap();
    assert_eq!(same.gears_by, GearsBy::Name);
    let of_gears = same.gears.iter().flat_map(|gear| &gear.figures).map(|figure| figure.differs);
    let all = same.figures.iter().map(|figure| figure.differs).chain(of_gears);
    assert!(all.into_iter().all(|differs| differs.difference.is_none()));
    let both = Request::default().answer(&[candidate(&eight), candidate(&simpson)]).unwrap();
    assert_eq!(both.gears_by, GearsBy::Ratio);
    let figure = |name: FigureName| both.figures.iter().find(|figure| figure.figure == name).unwrap();
    let values = |name: FigureName| -> Vec<f64> {
        figure(name).values.iter().map(|value| value.as_ref().unwrap().value).collect()
    };
    assert_eq!(values(FigureName::Sets), [4.0, 2.0]);
    assert_eq!(values(FigureName::Brakes), [2.0, 2.0]);
    assert_eq!(values(FigureName::Clutches), [3.0, 2.0]);
    assert_eq!(figure(FigureName::Sets).differs.difference, Some(-2.0));
    let spreads = [33.0 / 7.0 / (2.0 / 3.0), 67.0 / 27.0];
    assert!(std::iter::zip(values(FigureName::Spread), spreads).all(|(one, other)| is_near(one, other)));
    let relative = figure(FigureName::Spread).differs.relative_difference.unwrap();
    assert!(is_near(relative, spreads[1] / spreads[0] - 1.0));
    // 1 beside 1, and what is alone stays alone.
    let direct = both.gears.iter().find(|gear| gear.gears[0].as_deref() == Some("6")).unwrap();
    assert_eq!(direct.gears[1].as_deref(), Some("3"));
    let first = both.gears.iter().find(|gear| gear.gears[0].as_deref() == Some("1")).unwrap();
    assert_eq!(first.gears[1], None);
}

/// At one power and speed the figures are those of the efficiencies and ratios.
#[test]
fn gearboxes_are_compared_at_an_operating_point() {
    let list = document("real-transmissions.yaml");
    let [eight, simpson] = ["8HP", "TH400"].map(|name| one(&list, &choice(name, Some(0.97))).unwrap());
    let candidate = |subject| Candidate { subject, from: "file".to_owned() };
    let (speed, torque) = (150.0, 400.0);
    let load = Load {
        speed: Some(Quantity(AngularVelocity::from_si(speed))),
        torque: Some(Quantity(Torque::from_si(torque))),
        power: None,
    };
    let both = Request { load }.answer(&[candidate(&eight), candidate(&simpson)]).unwrap();
    let mut told = 0;
    for gear in &both.gears {
        let values = |name| &gear.figures.iter().find(|figure| figure.figure == name).unwrap().values;
        for place in 0..2 {
            let of = |name| values(name)[place];
            let Some((ratio, efficiency)) = of(FigureName::Ratio).zip(of(FigureName::Efficiency)) else {
                continue;
            };
            let power = speed * torque;
            assert!(is_near(of(FigureName::OutputSpeedRadS).unwrap(), speed / ratio));
            assert!(is_near(of(FigureName::OutputTorqueNM).unwrap(), -torque * ratio * efficiency));
            let loss = of(FigureName::LossW).unwrap();
            assert!((loss - power * (1.0 - efficiency)).abs() < 1e-9 * power, "{loss}");
            told += 1;
        }
    }
    assert_eq!(told, 9 + 4);
    let brake = &both.gearboxes[0].shift_elements[0];
    assert!(is_near(brake.torque_n_m.unwrap(), torque * brake.torque_of_input.unwrap()));
    let alone = Request::default().answer(&[candidate(&eight), candidate(&simpson)]).unwrap();
    assert!(alone.gearboxes[0].shift_elements[0].torque_n_m.is_none());
}
