//! States at the edge of rank: ratios beyond 1e10, loops that close exactly or by a hair, against exact
//! arithmetic.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use crate::common;

use common::oracle::Dice;
use epicyclic_train::set::{Gearing, SetKind, SetSpec};
use epicyclic_train::{Error, Gearbox, GearboxBuilder, State};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

fn link(place: usize) -> String {
    if place == 0 { "ground".to_owned() } else { format!("n{place}") }
}

fn set(id: usize, kind: SetKind, members: [usize; 3], gearing: Gearing) -> SetSpec {
    let [a, b, h] = members.map(link);
    let spec = SetSpec::new(&format!("s{id}"), kind, [&a, &b, &h], 2.0);
    SetSpec { gearing, ..spec }
}

fn teeth(first: u32, second: u32) -> Gearing {
    let of = |z| epicyclic_gears::teeth::ToothCount::new(z).unwrap();
    Gearing::Teeth(of(first), of(second))
}

fn builder(links: usize, input: usize, output: usize) -> GearboxBuilder {
    Gearbox::builder("rank")
        .links((1..=links).map(link))
        .input(&link(input))
        .output(&link(output))
        .gear("g", [""; 0])
}

/// Sets in series, each from sun to carrier with its ring at rest.
fn chain(gearing: &[Gearing]) -> GearboxBuilder {
    let sets = gearing.len();
    gearing.iter().enumerate().fold(builder(sets + 1, 1, sets + 1), |builder, (place, gearing)| {
        builder.set(set(place, SetKind::Simple, [place + 1, 0, place + 2], *gearing))
    })
}

fn assert_driven(name: &str, builder: GearboxBuilder, ratio: f64) {
    let gearbox = builder.build().unwrap();
    let found = gearbox.analyze("g").unwrap();
    assert_eq!(*found.state(), State::Driven, "{name}");
    let own = found.ratio().unwrap();
    assert!((own / ratio - 1.0).abs() < 1e-12, "{name}: {own} {ratio}");
    for case in [found.ideal(), found.driving(), found.back_driving()] {
        let case = case.unwrap_or_else(|| panic!("{name}: no torques"));
        assert!((case.efficiency - 1.0).abs() < 1e-9, "{name}: {}", case.efficiency);
        assert!((case.output.abs() / ratio - 1.0).abs() < 1e-9, "{name}: {}", case.output);
    }
}

#[test]
fn ratios_beyond_ten_billion_are_driven() {
    let k = Gearing::BasicRatio;
    assert_driven("twelve of 6", chain(&[k(6.0); 12]), 7_f64.powi(12));
    assert_driven("three of 3000", chain(&[k(3000.0); 3]), 3001_f64.powi(3));
    assert_driven("twenty of 29 and 71", chain(&[teeth(29, 71); 20]), (100_f64 / 29.0).powi(20));
    assert_driven("four of 1e9", chain(&[k(1e9); 4]), (1.0 + 1e9_f64).powi(4));
    assert_driven("twenty of 1e9", chain(&[k(1e9); 20]), (1.0 + 1e9_f64).powi(20));
    // Numbers that nobody wrote: the last digits are rounding.
    let third = 1.0 / 3.0;
    assert_driven("twelve of 18/3", chain(&[k(18.0 * third * (1.0 + 2e-16)); 12]), 7_f64.powi(12));
    assert_driven("three of 3000 + 1/3", chain(&[k(3000.0 + third); 3]), (3001.0 + third).powi(3));
    let computed = 71.0 / 29.0;
    assert_driven("twenty of 71/29", chain(&[k(computed); 20]), (100_f64 / 29.0).powi(20));
    assert_driven("twenty of 1e9/3", chain(&[k(1e9 * third); 20]), (1.0 + 1e9 * third).powi(20));
}

#[test]
fn a_loop_that_contradicts_itself_blocks() {
    let k = Gearing::BasicRatio;
    // Two sets on the same three links, their rings held, beside one of a huge ratio.
    for great in [1e7, 1e8, 1e9, 1e9 / 3.0] {
        for held in [2, 3] {
            let sets =
                [2.0_f64, 2.01].map(|one| set((one * 1000.0) as usize, SetKind::Simple, [1, 2, 3], k(one)));
            let [one, two] = sets;
            let gearbox = builder(5, 1, 3 - usize::from(held == 3))
                .set(set(1, SetKind::Simple, [1, 4, 5], k(great)))
                .set(one)
                .set(two)
                .ground(&link(held))
                .build()
                .unwrap();
            let found = gearbox.analyze("g").unwrap();
            assert!(matches!(found.state(), State::InputBlocked { .. }), "{great} {held}: {}", found.state());
            let found = found.speeds();
            assert!(found.iter().flatten().all(|speed| speed.is_finite()));
        }
    }
    // Ten sets in series, and the last tied to the first by a pair of another ratio.
    for gearing in [k(6.0), teeth(20, 120), k(18.0 / 3.0 * (1.0 + 3e-16)), k(6.0 + 1.0 / 3.0)] {
        let gearbox = chain(&[gearing; 10])
            .set(set(77, SetKind::InternalPair, [1, 11, 0], teeth(30, 77)))
            .build()
            .unwrap();
        let found = gearbox.analyze("g").unwrap();
        assert!(matches!(found.state(), State::InputBlocked { .. }), "{gearing:?}: {}", found.state());
    }
}

/// Three pairs in a ring: `a·b = c` closes it and leaves it free to turn.
fn pairs(a: Gearing, b: Gearing, c: Gearing) -> State {
    let gearbox = builder(3, 1, 3)
        .set(set(1, SetKind::ExternalPair, [1, 2, 0], a))
        .set(set(2, SetKind::ExternalPair, [2, 3, 0], b))
        .set(set(3, SetKind::InternalPair, [1, 3, 0], c))
        .build()
        .unwrap();
    let found = gearbox.analyze("g").unwrap();
    found.state().clone()
}

#[test]
fn decimals_close_a_loop_exactly_or_not_at_all() {
    let k = Gearing::BasicRatio;
    for (a, b, c) in [
        (1.2, 2.0, 2.4),
        (1.1, 1.1, 1.21),
        (0.1, 0.3, 0.03),
        (1.4, 0.7, 0.98),
        (3.3, 1e-7, 3.3e-7),
        (1.000_000_1, 1.000_000_1, 1.000_000_200_000_01),
    ] {
        assert_eq!(pairs(k(a), k(b), k(c)).name(), "torques indeterminate", "{a} {b} {c}");
        let blocked = |c: f64| assert_eq!(pairs(k(a), k(b), k(c)).name(), "input blocked", "{a} {b} {c}");
        blocked(c * 1.01);
        // A decimal is what was written, however near.
        blocked(format!("{:.13e}", c * (1.0 + 2e-13)).parse().unwrap());
    }
    // A third that was computed closes with what was computed from it.
    let third = 1.0 / 3.0;
    for (a, b) in [(third, 1.3), (third, third), (7.0 * third, 11.0 / 7.0), (1.7_f64.sqrt(), 1.3_f64.sqrt())]
    {
        assert_eq!(pairs(k(a), k(b), k(a * b)).name(), "torques indeterminate", "{a} {b}");
        assert_eq!(pairs(k(a), k(b), k(a * b * (1.0 + 1e-13))).name(), "input blocked", "{a} {b}");
    }
    // 125/27 is the nearest number to 4.62962962962963, and no decimal for that.
    assert_eq!(pairs(k(125.0 / 27.0), k(0.216), k(1.0)).name(), "torques indeterminate");
    // Teeth against a decimal and a computed number.
    assert_eq!(pairs(teeth(20, 24), k(2.0), teeth(10, 24)).name(), "torques indeterminate");
    assert_eq!(
        pairs(teeth(29, 71), teeth(31, 67), k(71.0 / 29.0 * 67.0 / 31.0)).name(),
        "torques indeterminate"
    );
    assert_eq!(pairs(teeth(29, 71), teeth(31, 67), teeth(899, 4757)).name(), "torques indeterminate");
    assert_eq!(pairs(teeth(29, 71), teeth(31, 67), teeth(89_900, 475_701)).name(), "input blocked");
}

#[test]
fn a_basic_ratio_of_one_makes_two_members_turn_alike() {
    for gearing in [Gearing::BasicRatio(1.0), teeth(40, 40), Gearing::BasicRatio(3.0 * (1.0 / 3.0))] {
        let state = |input: usize, output: usize, held: &[usize]| {
            let held =
                held.iter().fold(builder(3, input, output), |builder, &one| builder.ground(&link(one)));
            let gearbox = held.set(set(1, SetKind::DoublePlanet, [1, 2, 3], gearing)).build().unwrap();
            gearbox.analyze("g").unwrap().state().name()
        };
        assert_eq!(state(1, 2, &[3]), "driven");
        assert_eq!(state(1, 2, &[]), "underdetermined");
        assert_eq!(state(1, 3, &[2]), "input blocked");
        assert_eq!(state(3, 1, &[2]), "output at rest");
        assert_eq!(state(3, 1, &[]), "output free");
    }
}

#[test]
fn brakes_on_the_far_side_make_the_output_rest() {
    for gearing in [Gearing::BasicRatio(6.0), teeth(29, 71), Gearing::BasicRatio(20.0 / 3.0)] {
        // The output's set has ring and sun held; the input spins what is before.
        let gearbox = chain(&[gearing; 6])
            .set(set(9, SetKind::Simple, [7, 0, 8], gearing))
            .links(["n8", "n9", "n10"])
            .set(set(10, SetKind::Simple, [9, 10, 1], gearing))
            .output("n9")
            .brake("hold", "n9")
            .gear("held", ["hold"])
            .build()
            .unwrap();
        let found = gearbox.analyze("held").unwrap();
        assert_eq!(found.state().name(), "output at rest");
        assert_eq!(found.state().links(), ["n9"]);
        assert_eq!(gearbox.analyze("g").unwrap().state().name(), "underdetermined");
    }
}

/// A set with its exact basic ratio.
#[derive(Debug, Clone)]
struct Exact {
    members: [usize; 3],
    ratio: BigRational,
}

fn rational(numer: i64, denom: i64) -> BigRational {
    BigRational::new(BigInt::from(numer), BigInt::from(denom))
}

/// Reduced echelon form, columns in this order; the pivots' columns.
fn reduce(rows: &mut Vec<Vec<BigRational>>, order: &[usize]) -> Vec<usize> {
    let mut pivots = vec![];
    for &column in order {
        let from = pivots.len();
        let Some(place) = (from..rows.len()).find(|&row| !rows[row][column].is_zero()) else { continue };
        rows.swap(from, place);
        let pivot = rows[from][column].clone();
        rows[from].iter_mut().for_each(|x| *x = &*x / &pivot);
        let own = rows[from].clone();
        for (at, row) in rows.iter_mut().enumerate() {
            if at != from && !row[column].is_zero() {
                let factor = row[column].clone();
                row.iter_mut().zip(&own).for_each(|(x, p)| *x = &*x - &(&factor * p));
            }
        }
        pivots.push(column);
    }
    rows.truncate(pivots.len());
    pivots
}

fn rows(sets: &[Exact], links: usize) -> Vec<Vec<BigRational>> {
    let row = |set: &Exact| {
        let mut row = vec![BigRational::zero(); links + 1];
        let one = BigRational::one();
        for (place, factor) in set.members.iter().zip([one.clone(), -set.ratio.clone(), &set.ratio - one]) {
            row[*place] += factor;
        }
        row[0] = BigRational::zero();
        row
    };
    sets.iter().map(row).collect()
}

/// Expected result from exact ranks: the state's name, if the ranks of the speeds settle it, and the ratio.
fn expected(
    sets: &[Exact],
    links: usize,
    input: usize,
    output: usize,
) -> (&'static str, Option<BigRational>) {
    let mut rows = rows(sets, links);
    let mut order: Vec<usize> = (1..=links).filter(|one| ![input, output].contains(one)).collect();
    order.extend([output, input]);
    let pivots = reduce(&mut rows, &order);
    if pivots.contains(&input) {
        return ("input blocked", None);
    }
    let Some(place) = pivots.iter().position(|pivot| *pivot == output) else { return ("open", None) };
    let factor = -rows[place][input].clone();
    if factor.is_zero() { ("output at rest", None) } else { ("follows", Some(factor.recip())) }
}

/// Form in which a description gives a ratio.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Written {
    Teeth,
    Number,
}

fn spec(id: usize, exact: &Exact, written: Written) -> SetSpec {
    let (numer, denom) = (exact.ratio.numer().abs(), exact.ratio.denom().clone());
    let kind = if exact.ratio.is_negative() { SetKind::MeshingSuns } else { SetKind::DoublePlanet };
    let gearing = match (numer.to_u32(), denom.to_u32(), written) {
        (Some(second), Some(first), Written::Teeth) => teeth(first, second),
        _ => Gearing::BasicRatio(exact.ratio.abs().to_f64().unwrap()),
    };
    set(id, kind, exact.members, gearing)
}

/// A random gearbox in which as many sets as wanted repeat what others say already.
struct Planted {
    links: usize,
    sets: Vec<Exact>,
    input: usize,
    output: usize,
}

fn planted(dice: &mut Dice) -> Option<Planted> {
    let links = 2 + dice.below(7);
    let mut sets = vec![];
    let members = |dice: &mut Dice| {
        let mut places: Vec<usize> = (0..=links).collect();
        dice.shuffle(&mut places);
        [places[0], places[1], places[2]]
    };
    for _ in 0..1 + dice.below(links) {
        let numer = i64::from(dice.between(15, 130)) * if dice.chance(40) { 1 } else { -1 };
        sets.push(Exact { members: members(dice), ratio: rational(numer, i64::from(dice.between(15, 130))) });
    }
    // Speeds of all links at random values of the free ones.
    let mut rows = rows(&sets, links);
    let order: Vec<usize> = (1..=links).collect();
    let pivots = reduce(&mut rows, &order);
    let mut speeds = vec![BigRational::zero(); links + 1];
    for free in (1..=links).filter(|link| !pivots.contains(link)) {
        speeds[free] = rational(i64::from(dice.between(1, 50)), i64::from(dice.between(1, 9)));
    }
    for (row, &pivot) in rows.iter().zip(&pivots) {
        speeds[pivot] = -(1..=links)
            .filter(|link| *link != pivot)
            .map(|link| &row[link] * &speeds[link])
            .fold(BigRational::zero(), |sum, one| sum + one);
    }
    for _ in 0..1 + dice.below(3) {
        let [a, b, h] = members(dice);
        let (one, two) = (&speeds[a] - &speeds[h], &speeds[b] - &speeds[h]);
        if one.is_zero() || two.is_zero() {
            continue;
        }
        let mut ratio = one / two;
        if dice.chance(30) {
            // By a hair beside it.
            ratio *= rational(1_000_000_001, 1_000_000_000);
        }
        if ratio.abs() > rational(10_000, 1) || ratio.abs() < rational(1, 10_000) {
            continue;
        }
        sets.push(Exact { members: [a, b, h], ratio });
    }
    dice.shuffle(&mut sets);
    let input = 1 + dice.below(links);
    let output = 1 + (input + dice.below(links - 1)) % links;
    Some(Planted { links, sets, input, output })
}

#[test]
fn planted_losses_of_rank_are_found_by_teeth_and_by_numbers() {
    let mut dice = Dice(0x5eed);
    let mut met = std::collections::BTreeMap::<&str, usize>::new();
    for round in 0..2000 {
        let Some(Planted { links, sets, input, output }) = planted(&mut dice) else { continue };
        let written = if round % 2 == 0 { Written::Teeth } else { Written::Number };
        let described = sets
            .iter()
            .enumerate()
            .fold(builder(links, input, output), |builder, (id, set)| builder.set(spec(id, set, written)));
        let gearbox = described.build().unwrap();
        let found = gearbox.analyze("g").unwrap();
        let (motion, ratio) = expected(&sets, links, input, output);
        let own = match found.kinematic_state() {
            State::InputBlocked { .. } => "input blocked",
            State::OutputAtRest { .. } => "output at rest",
            State::OutputFree { .. } => "open",
            State::Underdetermined { .. } if found.ratio().is_none() => "open",
            _ => "follows",
        };
        assert_eq!(own, motion, "round {round} {written:?}: {} {sets:#?}", found.state());
        if let Some(ratio) = ratio {
            let exact = ratio.to_f64().unwrap();
            let own = found.ratio().unwrap();
            // Computed numbers lose digits where a loop closes by a hair; teeth never do.
            let by_teeth = gearbox.sets().iter().all(|set| set.exact_ratio().is_some());
            let tolerance = if by_teeth { 1e-9 } else { 1e-3 };
            assert!((own / exact - 1.0).abs() < tolerance, "round {round}: {own} {exact}");
        }
        assert!(found.speeds().iter().flatten().all(|speed| speed.is_finite()));
        for case in [found.ideal(), found.driving(), found.back_driving()].into_iter().flatten() {
            assert!(case.members.iter().flatten().flatten().all(|torque| torque.is_finite()));
            assert!(case.efficiency.is_finite() && case.power.circulating.is_finite());
        }
        if *found.kinematic_state() == State::Driven {
            assert!(found.ideal().is_some(), "round {round}: a driven gear has torques");
        }
        *met.entry(found.state().name()).or_default() += 1;
    }
    println!("{met:?}");
    assert!(met.len() >= 5 && met.values().all(|count| *count > 30), "{met:?}");
}

/// Five sets, three of the same great ratio, one a hair above 1: all that turns turns as a block.
#[test]
fn sets_of_one_great_ratio_turn_as_a_block() {
    let great = Gearing::BasicRatio(41_161_143.241_611_086);
    let gearbox = builder(6, 4, 2)
        .set(set(0, SetKind::Simple, [1, 5, 6], great))
        .set(set(1, SetKind::Simple, [3, 2, 6], great))
        .set(set(2, SetKind::MeshingSuns, [2, 6, 1], great))
        .set(set(3, SetKind::DoublePlanet, [3, 4, 6], Gearing::BasicRatio(1.000_000_000_010_326_9)))
        .set(set(4, SetKind::Simple, [5, 1, 6], teeth(27, 155)))
        .build()
        .unwrap();
    let found = gearbox.analyze("g").unwrap();
    assert_eq!(*found.state(), State::Driven);
    assert!((found.ratio().unwrap() - 1.0).abs() < 1e-15);
}

/// A random gearbox of ratios whose `k − 1` is anything in 1e-9…1e9, often the same for several sets.
fn extreme(dice: &mut Dice) -> (Planted, Vec<SetSpec>) {
    let links = 2 + dice.below(6);
    let drawn: Vec<f64> = (0..1 + dice.below(3))
        .map(|_| 1.0 + libm::exp10(18.0 * (dice.below(1 << 30) as f64 / (1_u64 << 30) as f64) - 9.0))
        .filter(|k| *k <= 1e9)
        .collect();
    let (mut sets, mut specs) = (vec![], vec![]);
    for id in 0..(links + dice.below(4)).saturating_sub(3).max(1) {
        let mut places: Vec<usize> = (0..=links).collect();
        dice.shuffle(&mut places);
        let kind = [SetKind::Simple, SetKind::DoublePlanet, SetKind::MeshingSuns, SetKind::SteppedRings]
            [dice.below(4)];
        let members = [places[0], places[1], places[2]];
        // Steps are given by their whole ratio.
        let by_teeth = drawn.is_empty() || dice.chance(10) && !kind.is_stepped();
        let (gearing, size) = if by_teeth {
            let first = dice.between(15, 60);
            let second = first + dice.between(1, 140);
            (teeth(first, second), rational(i64::from(second), i64::from(first)))
        } else {
            let k = drawn[dice.below(drawn.len())];
            (Gearing::BasicRatio(k), BigRational::from_float(k).unwrap())
        };
        sets.push(Exact { members, ratio: if kind.sign() < 0.0 { -size } else { size } });
        specs.push(set(id, kind, members, gearing));
    }
    let input = 1 + dice.below(links);
    let output = 1 + (input + dice.below(links - 1)) % links;
    (Planted { links, sets, input, output }, specs)
}

/// Every state against ranks over fractions that share no code with the solver: the ratios are the rationals
/// that their numbers are.
#[test]
fn ratios_near_one_and_near_a_billion_have_the_exact_state() {
    let cases = common::cases(2000);
    let mut dice = Dice(0xd1ce);
    let mut met = std::collections::BTreeMap::<&str, u32>::new();
    let (mut wrong, mut worst, mut unbalanced) = (vec![], 0.0_f64, 0.0_f64);
    for case in 0..cases {
        let (Planted { links, sets, input, output }, specs) = extreme(&mut dice);
        let described =
            specs.iter().fold(builder(links, input, output), |builder, one| builder.set(one.clone()));
        let gearbox = described.build().unwrap();
        let found = gearbox.analyze("g").unwrap();
        let (motion, ratio) = expected(&sets, links, input, output);
        let own = match found.kinematic_state() {
            State::InputBlocked { .. } => "input blocked",
            State::OutputAtRest { .. } => "output at rest",
            State::OutputFree { .. } => "open",
            State::Underdetermined { .. } if found.ratio().is_none() => "open",
            _ => "follows",
        };
        // Independent equations that leave one freedom settle every torque, too.
        let mut reduced = rows(&sets, links);
        let order: Vec<usize> = (1..=links).collect();
        let is_square = reduce(&mut reduced, &order).len() == sets.len() && sets.len() + 1 == links;
        let is_driven = *found.kinematic_state() == State::Driven;
        let differs = ratio.as_ref().map_or(0.0, |ratio| {
            let own = found.ratio().unwrap_or(f64::NAN);
            (own / ratio.to_f64().unwrap() - 1.0).abs()
        });
        if own != motion
            || is_square && motion == "follows" && !is_driven
            || differs.is_nan()
            || differs >= 1e-9
        {
            wrong.push(format!(
                "{case}: {} for {motion} {ratio:?}, off by {differs}\n{specs:?}",
                found.state()
            ));
        }
        worst = worst.max(differs);
        if let Some(ideal) = found.ideal() {
            unbalanced = unbalanced.max((ideal.efficiency - 1.0).abs() / ideal.power.largest.max(1.0));
        }
        *met.entry(found.state().name()).or_default() += 1;
    }
    println!(
        "{cases} gearboxes, {} wrong, ratios to {worst:e}, powers to {unbalanced:e}: {met:?}",
        wrong.len()
    );
    assert!(wrong.is_empty(), "{} of {cases}: {}", wrong.len(), wrong[0]);
    assert!(met.len() >= 5, "{met:?}");
}

#[test]
fn ratios_beyond_all_numbers_are_refused() {
    for (sets, k) in [(40, 1e9), (64, 1e9), (64, 1e9 / 3.0), (64, 3000.0)] {
        let error = chain(&vec![Gearing::BasicRatio(k); sets]).build().unwrap_err();
        assert!(matches!(error, Error::Spread { exponent } if exponent > 200.0), "{error}");
    }
    assert_driven("64 of 5/3", chain(&[Gearing::BasicRatio(5.0 / 3.0); 64]), (8.0_f64 / 3.0).powi(64));
}
