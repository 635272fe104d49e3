//! Layouts are whole and free of crossings, and the verdict is that of all embeddings tried in turn.

#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

#[path = "../../../train/tests/common/machines.rs"]
mod machines;

use epicyclic_layout as drawability;
use epicyclic_layout::layout::{Point, Segment};
use epicyclic_layout::{Element, Layout, Options, Verdict};
use epicyclic_schemes::structures::{Role, Structure};
use epicyclic_train::set::{SetKind, SetSpec};
use epicyclic_train::{GearSpec, Gearbox, LinkId};
use proptest::prelude::*;

const QUICK: Options = Options { same_side: false, attempts: 6 };

/// The first of all links joined with this one for ever.
fn piece(gearbox: &Gearbox, link: LinkId) -> LinkId {
    let mut same = vec![link];
    while let Some(&[a, b]) = gearbox.permanent().iter().find(|[a, b]| same.contains(a) != same.contains(b)) {
        same.push(if same.contains(&a) { b } else { a });
    }
    same.into_iter().min().unwrap()
}

fn touch(a: &Segment, b: &Segment) -> bool {
    a.from.x <= b.to.x && b.from.x <= a.to.x && a.from.y <= b.to.y && b.from.y <= a.to.y
}

/// Every link is one connected thing that has all its central gears, ends and shift elements; nothing
/// crosses.
fn whole(gearbox: &Gearbox, layout: &Layout, same_side: bool) {
    let name = gearbox.name();
    assert_eq!(layout.crossings(), [], "{name}");
    let at = |p: Point| Segment { from: p, to: p };
    let mut lines: Vec<(LinkId, Segment)> = vec![];
    for shape in &layout.links {
        lines.extend(shape.segments.iter().map(|s| (shape.link, *s)));
    }
    let drawn = lines.len();
    // Parts that must be connected with the lines.
    assert_eq!(layout.sets.len(), gearbox.drawn_sets().len(), "{name}");
    for (place, (stack, set)) in layout.sets.iter().zip(gearbox.drawn_sets()).enumerate() {
        assert_eq!(stack.set, place, "{name}");
        assert_eq!(stack.members, set.links.map(|link| piece(gearbox, link)), "{name}");
        let ys = [stack.sun, stack.sun_mesh, stack.planet, stack.ring_mesh, stack.ring];
        assert!(ys.windows(2).all(|pair| pair[0] < pair[1]), "{name} {ys:?}");
        let gear = |low: f64, high: f64| Segment {
            from: Point { x: stack.x, y: low },
            to: Point { x: stack.x, y: high },
        };
        let [a, b, h] = stack.members;
        lines.push((a, gear(stack.sun, stack.sun_mesh)));
        lines.push((b, gear(stack.ring_mesh, stack.ring)));
        lines.push((h, gear(stack.planet, stack.planet)));
    }
    let mut seen = vec![];
    for mark in &layout.clutches {
        seen.push((mark.shift_element, [mark.lower.0, mark.upper.0]));
        lines.extend([mark.lower, mark.upper].map(|(link, p)| (link, at(p))));
        assert!(mark.lower.1.x == mark.upper.1.x && mark.lower.1.y < mark.upper.1.y, "{name}");
    }
    for mark in &layout.brakes {
        seen.push((mark.shift_element, [mark.link, LinkId::GROUND]));
        lines.extend([(mark.link, at(mark.link_end)), (LinkId::GROUND, at(mark.housing))]);
    }
    for (shift_element, links) in
        gearbox.shift_elements().iter().map(epicyclic_train::ShiftElement::links).enumerate()
    {
        let mut links = links.map(|link| piece(gearbox, link));
        links.sort();
        let found = seen.iter().filter(|(other, found)| {
            let mut found = *found;
            found.sort();
            *other == shift_element && found == links
        });
        assert_eq!(found.count(), usize::from(links[0] != links[1]), "{name} {shift_element}");
    }
    for end in [layout.input, layout.output].iter().chain(&layout.take_offs) {
        lines.push((end.link, at(end.at)));
    }
    assert_eq!(layout.input.link, piece(gearbox, gearbox.input()), "{name}");
    assert_eq!(layout.output.link, piece(gearbox, gearbox.output()), "{name}");
    let left = layout.axis.from.x;
    assert_eq!(layout.input.at.x, left, "{name}");
    assert_eq!(layout.output.at.x, if same_side { left } else { layout.axis.to.x }, "{name}");
    assert!(lines[..drawn].iter().all(|(_, s)| s.from.x >= left && s.to.x <= layout.axis.to.x), "{name}");
    lines.push((LinkId::GROUND, layout.housing));

    let mut reached: Vec<bool> = vec![false; lines.len()];
    for start in 0..lines.len() {
        if lines[..start].iter().any(|(link, _)| *link == lines[start].0) {
            continue;
        }
        let mut stack = vec![start];
        reached[start] = true;
        while let Some(line) = stack.pop() {
            for other in 0..lines.len() {
                if !reached[other]
                    && lines[other].0 == lines[line].0
                    && touch(&lines[other].1, &lines[line].1)
                {
                    reached[other] = true;
                    stack.push(other);
                }
            }
        }
    }
    for (line, reached) in lines.iter().zip(reached) {
        assert!(reached, "{name}: link {} has a piece apart at {:?}", line.0.index(), line.1);
    }
}

/// Draws both ways, checks what comes back, and says whether it could be drawn.
fn check(gearbox: &Gearbox) -> bool {
    let verdict = drawability::is_drawable(gearbox);
    for same_side in [false, true] {
        match drawability::draw(gearbox, Options { same_side, ..QUICK }) {
            Verdict::Drawable(layout) => {
                assert!(verdict);
                whole(gearbox, &layout, same_side);
            }
            Verdict::SelfCrossing(witness) => {
                assert!(!verdict);
                // Clutches alone may cross; without sets they are no gearbox.
                if let Some(rest) = only(gearbox, &witness.elements) {
                    assert!(!drawability::is_drawable(&rest), "{witness:?}");
                }
            }
        }
    }
    verdict
}

/// The gearbox with the sets and shift elements of a witness alone.
fn only(gearbox: &Gearbox, elements: &[Element]) -> Option<Gearbox> {
    let name = |link: LinkId| gearbox.link_name(link);
    let mut builder = Gearbox::builder("witness").links(gearbox.links()[1..].iter().cloned());
    for element in elements {
        match *element {
            Element::Set(set) => builder = builder.set(gearbox.sets()[set].short()?.clone()),
            Element::ShiftElement(shift_element) => {
                let shift_element = &gearbox.shift_elements()[shift_element];
                let [a, b] = shift_element.links().map(name);
                builder = builder.clutch(shift_element.id(), a, b);
            }
            _ => {}
        }
    }
    for [a, b] in gearbox.permanent() {
        builder = builder.tie(name(*a), name(*b));
    }
    builder.input(name(gearbox.input())).output(name(gearbox.output())).build().ok()
}

fn scheme(sets: &[&str], direct_clutch: Option<[&str; 2]>) -> Gearbox {
    let mut builder = Gearbox::builder(&sets.join(" + ")).links(["D", "B", "T1", "T2"]).brake("K1", "T1");
    for (place, set) in sets.iter().enumerate() {
        let members: Vec<&str> = set.split_whitespace().collect();
        builder = builder.set(SetSpec::simple(&place.to_string(), members.try_into().unwrap(), 2.5));
    }
    if sets.len() > 1 {
        builder = builder.brake("K2", "T2");
    }
    if let Some([a, b]) = direct_clutch {
        builder = builder.clutch("direct", a, b);
    }
    builder.input("D").output("B").build().unwrap()
}

#[test]
fn the_fourteen_schemes_are_drawn_with_and_without_direct_drive() {
    for set in ["D T1 B", "T1 D B", "D B T1"] {
        assert!(check(&scheme(&[set], None)));
        assert!(check(&scheme(&[set], Some(["D", "B"]))));
    }
    for structure in Structure::catalogue() {
        let sets = structure.sets().map(|set| set.map(Role::symbol).join(" "));
        let sets = [sets[0].as_str(), sets[1].as_str()];
        assert!(check(&scheme(&sets, None)));
        assert!(check(&scheme(&sets, Some(["D", "B"]))), "{structure}");
    }
}

#[test]
fn all_two_set_structures_are_drawn_or_refused() {
    let drawn = Structure::all().into_iter().filter(|structure| {
        let sets = structure.sets().map(|set| set.map(Role::symbol).join(" "));
        check(&scheme(&[&sets[0], &sets[1]], None))
    });
    assert_eq!(drawn.count(), 106);
}

#[test]
fn transmissions_in_service_are_drawn() {
    for machine in machines::all() {
        assert!(check(&machine.gearbox), "{}", machine.gearbox.name());
    }
}

#[test]
fn a_second_carrier_between_the_same_shafts_is_shut_in() {
    let gearbox = scheme(&["D B T1", "D B T2"], None);
    assert!(!check(&gearbox));
    let Verdict::SelfCrossing(witness) = drawability::draw(&gearbox, QUICK) else {
        panic!("it cannot be drawn");
    };
    assert_eq!(
        witness.describe(&gearbox),
        "cannot be drawn together: set `0`, set `1`, brake `K1`, brake `K2`, the input at `D`, the output at \
         `B`, link `D`, link `B`, link `T1`, link `T2`"
    );
    // One brake less, and it can.
    assert!(check(&scheme(&["D B T1"], None)));
}

/// Three links each tied to three others by sets whose carriers they are.
#[test]
fn sets_that_tie_three_links_to_three_others_cross() {
    let links = ["a", "b", "c", "x", "y", "z"];
    let build = |sets: &[[&str; 3]], clutches: &[[&str; 2]]| {
        let mut builder = Gearbox::builder("K33").links(links).input("a").output("x");
        for (place, set) in sets.iter().enumerate() {
            builder = builder.set(SetSpec::simple(&place.to_string(), *set, 2.0));
        }
        for (place, [p, q]) in clutches.iter().enumerate() {
            builder = builder.clutch(&format!("C{place}"), p, q);
        }
        builder.build().unwrap()
    };
    let three = [["x", "y", "a"], ["x", "y", "b"], ["x", "y", "c"]];
    assert!(check(&build(&three, &[])));
    assert!(check(&build(&three, &[["a", "z"], ["b", "z"]])));
    assert!(!check(&build(&three, &[["a", "z"], ["b", "z"], ["c", "z"]])));
    let four = [["x", "y", "a"], ["x", "y", "b"], ["x", "y", "c"], ["a", "b", "z"]];
    assert!(check(&build(&four, &[])));
    assert!(!check(&build(&four, &[["c", "z"]])));
}

/// Carrier `h` carries both planets; the links of the central gears alternate around it if they must.
#[test]
fn sets_on_one_carrier_do_not_interleave() {
    let build = |clutches: &[[&str; 2]]| {
        let mut builder = Gearbox::builder("common carrier")
            .links(["a1", "b1", "a2", "b2", "h", "in", "out"])
            .set(SetSpec::simple("1", ["a1", "b1", "h"], 2.0))
            .set(SetSpec::simple("2", ["a2", "b2", "h"], 2.0))
            .input("in")
            .output("out");
        for (place, [p, q]) in clutches.iter().enumerate() {
            builder = builder.clutch(&format!("C{place}"), p, q);
        }
        builder.build().unwrap()
    };
    // A ring of clutches puts the four central gears around the carrier in its order: sun, sun, ring, ring
    // and sun, ring, ring, sun can be; sun 1, sun 2, ring 1, ring 2 cannot.
    assert!(check(&build(&[["a1", "a2"], ["a2", "b2"], ["b2", "b1"], ["b1", "a1"]])));
    assert!(check(&build(&[["a1", "b1"], ["b1", "a2"], ["a2", "b2"], ["b2", "a1"]])));
    assert!(!check(&build(&[["a1", "a2"], ["a2", "b1"], ["b1", "b2"], ["b2", "a1"]])));
}

#[test]
fn a_gearbox_of_pairs_on_a_layshaft_is_drawn() {
    let mut builder = Gearbox::builder("layshaft").links(["in", "lay", "out", "w1", "w2", "w3", "w4"]);
    builder = builder.set(SetSpec::new("0", SetKind::ExternalPair, ["in", "lay", "ground"], 1.5));
    for gear in ["w1", "w2", "w3", "w4"] {
        builder = builder
            .set(SetSpec::new(gear, SetKind::ExternalPair, ["lay", gear, "ground"], 1.2))
            .clutch(&format!("C{gear}"), gear, "out");
    }
    assert!(check(&builder.input("in").output("out").build().unwrap()));
}

/// Names the further clutch among the reasons if a scheme can be drawn without it and not with it.
#[test]
fn a_direct_drive_clutch_that_cannot_be_drawn_is_named() {
    let mut refused = 0;
    for structure in Structure::all() {
        let sets = structure.sets().map(|set| set.map(Role::symbol).join(" "));
        let gearbox = scheme(&[&sets[0], &sets[1]], None);
        if !drawability::is_drawable(&gearbox) {
            continue;
        }
        let options = drawability::direct_clutch_options(&gearbox);
        let moving: Vec<LinkId> = gearbox.link_ids().skip(1).collect();
        for (place, &a) in moving.iter().enumerate() {
            for &b in &moving[place + 1..] {
                let verdict = drawability::draw_with_direct_clutch(&gearbox, [a, b], QUICK);
                let Verdict::SelfCrossing(witness) = verdict else {
                    assert!(options.contains(&[a, b]), "{structure}");
                    continue;
                };
                assert!(!options.contains(&[a, b]), "{structure}");
                assert!(witness.elements.contains(&Element::ShiftElement(gearbox.shift_elements().len())));
                assert!(witness.describe(&gearbox).contains("the direct-drive clutch"));
                refused += 1;
            }
        }
    }
    assert!(refused > 20, "{refused}");
}

/// Power leaves at `T1` in one gear and enters there in another, and enters at `T2` and leaves at the input
/// in a third.
#[test]
fn links_where_power_enters_or_leaves_in_some_gear_only_reach_the_housing() {
    let gear = |name: &str, input: Option<&str>, output: Option<&str>| GearSpec {
        name: name.into(),
        engaged: vec!["K2".into()],
        input: input.map(Into::into),
        output: output.map(Into::into),
    };
    let builder = scheme(&["D T1 B", "T1 D T2"], None).to_builder();
    let plain = builder.clone().gear_spec(gear("1", None, None)).gear_spec(gear("2", Some("D"), Some("B")));
    let plain = plain.build().unwrap();
    let other = builder
        .gear_spec(gear("1", None, None))
        .gear_spec(gear("2", None, Some("T1")))
        .gear_spec(gear("3", Some("T1"), None))
        .gear_spec(gear("4", Some("T2"), Some("D")))
        .build()
        .unwrap();
    for (gearbox, expected) in [(plain, vec![]), (other, vec!["T1", "T2"])] {
        assert!(check(&gearbox));
        let Verdict::Drawable(layout) = drawability::draw(&gearbox, QUICK) else { panic!("it can be drawn") };
        let mut ways: Vec<&str> = layout.take_offs.iter().map(|way| gearbox.link_name(way.link)).collect();
        ways.sort_unstable();
        assert_eq!(ways, expected);
    }
}

/// A gearbox as numbers: links by index, 0 the housing.
#[derive(Debug, Clone)]
struct Plan {
    links: usize,
    sets: Vec<[usize; 3]>,
    permanent: Vec<[usize; 2]>,
    shift_elements: Vec<[usize; 2]>,
    terminals: [usize; 2],
}

fn plans(
    links: std::ops::Range<usize>,
    sets: std::ops::RangeInclusive<usize>,
    shift_elements: std::ops::RangeInclusive<usize>,
) -> impl Strategy<Value = Plan> {
    links.prop_flat_map(move |links| {
        let link = move || 0..=links;
        let members =
            Just((0..=links).collect::<Vec<_>>()).prop_shuffle().prop_map(|all| [all[0], all[1], all[2]]);
        (
            Just(links),
            prop::collection::vec(members, sets.clone()),
            prop::collection::vec([link(), link()], 0..2),
            prop::collection::vec([link(), link()], shift_elements.clone()),
            [1..=links, 1..=links],
            any::<bool>(),
        )
            .prop_map(|(links, mut sets, permanent, shift_elements, terminals, common)| {
                // Half of them with as many planets on one carrier as may be.
                let carrier = sets[0][2];
                for set in sets.iter_mut().filter(|set| common && !set.contains(&carrier)) {
                    set[2] = carrier;
                }
                Plan { links, sets, permanent, shift_elements, terminals }
            })
    })
}

/// One in ten is large: those take nearly all the time of the test.
fn plans_of_any_size() -> impl Strategy<Value = Plan> {
    prop_oneof![9 => plans(3..8, 1..=4, 0..=6), 1 => plans(3..9, 1..=5, 0..=7)]
}

/// Builds a plan without what makes it no gearbox.
fn build(plan: &Plan, order: &[usize], mirrored: bool) -> Option<Gearbox> {
    let name = |link: usize| if link == 0 { "ground".to_owned() } else { format!("n{link}") };
    let mut builder = Gearbox::builder("random").links(order.iter().map(|&link| name(link)));
    let turn = |count: usize| (0..count).map(move |place| if mirrored { count - 1 - place } else { place });
    for place in turn(plan.sets.len()) {
        let members = plan.sets[place].map(name);
        let members = [0, 1, 2].map(|member| members[member].as_str());
        builder = builder.set(SetSpec::simple(&place.to_string(), members, 2.5));
    }
    for place in turn(plan.shift_elements.len()) {
        let [a, b] = plan.shift_elements[place];
        if a != b {
            builder = builder.clutch(&format!("c{place}"), &name(a), &name(b));
        }
    }
    for [a, b] in &plan.permanent {
        builder = builder.tie(&name(*a), &name(*b));
    }
    let [input, output] = if mirrored { [plan.terminals[1], plan.terminals[0]] } else { plan.terminals };
    builder.input(&name(input)).output(&name(output)).build().ok()
}

/// Tries all embeddings of the graph, by Euler's formula. Vertices are border and links with their planets,
/// the border keeps its place, and chords on one carrier do not cross. `None` where there would be too many.
fn by_exhaustion(gearbox: &Gearbox) -> Option<bool> {
    let links = gearbox.links().len();
    let vertex = |link: LinkId| piece(gearbox, link).index();
    // Vertex 0 is the housing; axis, input and output follow the links.
    let (axis, input, output) = (links, links + 1, links + 2);
    let mut edges = vec![[axis, output], [output, 0], [0, input], [input, axis]];
    edges.push([input, vertex(gearbox.input())]);
    edges.push([output, vertex(gearbox.output())]);
    let mut chords: Vec<(usize, [usize; 2])> = vec![];
    for set in gearbox.drawn_sets() {
        let [a, b, h] = set.links.map(vertex);
        chords.push((h, [edges.len(), edges.len() + 1]));
        edges.extend([[h, a], [h, b]]);
    }
    for shift_element in gearbox.shift_elements() {
        let [a, b] = shift_element.links().map(vertex);
        if a != b {
            edges.push([a, b]);
        }
    }
    let mut around: Vec<Vec<usize>> = vec![vec![]; links + 3];
    for (edge, ends) in edges.iter().enumerate() {
        around[ends[0]].push(edge);
        around[ends[1]].push(edge);
    }
    // Clockwise; the housing's list runs between its two border edges.
    around[axis] = vec![3, 0];
    around[output] = vec![5, 1, 0];
    around[input] = vec![2, 4, 3];
    around[0].retain(|&edge| edge > 3);
    around[0].insert(0, 1);
    around[0].push(2);
    let free = |vertex: usize| match vertex {
        0 => 1..around[0].len() - 1,
        vertex if vertex < links && !around[vertex].is_empty() => 1..around[vertex].len(),
        _ => 0..0,
    };
    let count: f64 = (0..links).map(|v| (1..=free(v).len()).map(|n| n as f64).product::<f64>()).product();
    if count > 2e5 {
        return None;
    }
    let ranges: Vec<_> = (0..around.len()).map(free).collect();
    let parts = {
        let mut root: Vec<usize> = (0..around.len()).collect();
        for ends in &edges {
            let (from, to) = (root[ends[0]], root[ends[1]]);
            root.iter_mut().filter(|r| **r == from).for_each(|r| *r = to);
        }
        (0..around.len()).filter(|&v| root[v] == v && !around[v].is_empty()).count()
    };
    let used = around.iter().filter(|edges| !edges.is_empty()).count();
    let planar = |around: &[Vec<usize>]| {
        let mut next = vec![[0; 2]; edges.len()];
        for (vertex, list) in around.iter().enumerate() {
            for (place, &edge) in list.iter().enumerate() {
                next[edge][usize::from(edges[edge][1] == vertex)] = list[(place + 1) % list.len()];
            }
        }
        let mut seen = vec![[false; 2]; edges.len()];
        let mut faces = 0;
        for edge in 0..edges.len() {
            for end in 0..2 {
                let (mut edge, mut end) = (edge, end);
                faces += usize::from(!seen[edge][end]);
                while !std::mem::replace(&mut seen[edge][end], true) {
                    let vertex = edges[edge][1 - end];
                    edge = next[edge][1 - end];
                    end = usize::from(edges[edge][1] == vertex);
                }
            }
        }
        used + faces == edges.len() + 2 * parts
    };
    let straight = |around: &[Vec<usize>]| {
        let place = |vertex: usize, edge| around[vertex].iter().position(|&other| other == edge).unwrap();
        chords.iter().all(|&(h, ends)| {
            let [p, q] = ends.map(|edge| place(h, edge));
            chords.iter().filter(|&&(other, e)| other == h && e != ends).all(|&(_, e)| {
                let inside = e.map(|edge| (p.min(q)..p.max(q)).contains(&place(h, edge)));
                inside[0] == inside[1]
            })
        })
    };
    Some(any_order(&mut around.clone(), &ranges, 0, &|around| planar(around) && straight(around)))
}

fn any_order(
    around: &mut [Vec<usize>],
    ranges: &[std::ops::Range<usize>],
    vertex: usize,
    holds: &dyn Fn(&[Vec<usize>]) -> bool,
) -> bool {
    fn permute(
        around: &mut [Vec<usize>],
        ranges: &[std::ops::Range<usize>],
        vertex: usize,
        from: usize,
        holds: &dyn Fn(&[Vec<usize>]) -> bool,
    ) -> bool {
        if from >= ranges[vertex].end {
            return any_order(around, ranges, vertex + 1, holds);
        }
        (from..ranges[vertex].end).any(|other| {
            around[vertex].swap(from, other);
            let found = permute(around, ranges, vertex, from + 1, holds);
            around[vertex].swap(from, other);
            found
        })
    }
    if vertex == ranges.len() {
        holds(around)
    } else {
        permute(around, ranges, vertex, ranges[vertex].start, holds)
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(800))]

    #[test]
    fn any_gearbox_is_drawn_whole_or_refused_with_a_witness(plan in plans_of_any_size()) {
        let order: Vec<usize> = (1..=plan.links).collect();
        if let Some(gearbox) = build(&plan, &order, false) {
            check(&gearbox);
            prop_assert!(drawability::is_drawable(&gearbox) || drawability::direct_clutch_options(&gearbox).is_empty());
        }
    }

    #[test]
    fn the_verdict_is_that_of_all_embeddings(plan in plans(4..7, 2..=4, 2..=5)) {
        let order: Vec<usize> = (1..=plan.links).collect();
        if let Some(gearbox) = build(&plan, &order, false)
            && let Some(expected) = by_exhaustion(&gearbox)
        {
            prop_assert_eq!(drawability::is_drawable(&gearbox), expected);
        }
    }

    #[test]
    fn names_order_and_the_side_of_the_input_change_no_verdict(
        (plan, order) in plans(3..8, 1..=4, 0..=6).prop_flat_map(|plan| {
            let order = Just((1..=plan.links).collect::<Vec<_>>()).prop_shuffle();
            (Just(plan), order)
        })
    ) {
        let straight: Vec<usize> = (1..=plan.links).collect();
        if let Some(gearbox) = build(&plan, &straight, false) {
            let expected = drawability::is_drawable(&gearbox);
            for mirrored in [false, true] {
                let other = build(&plan, &order, mirrored).unwrap();
                prop_assert_eq!(drawability::is_drawable(&other), expected);
            }
        }
    }
}

/// Whether all sets of a gearbox are in one band; `None` if the gearbox cannot be drawn.
fn in_one_band(gearbox: &Gearbox) -> Option<bool> {
    match drawability::draw(gearbox, Options::default()) {
        Verdict::Drawable(layout) => Some(layout.cost(gearbox).bands == 1),
        Verdict::SelfCrossing(_) => None,
    }
}

#[test]
fn sets_stand_in_one_band() {
    let structures = |all: Vec<Structure>| {
        let gearboxes = all.into_iter().map(|structure| {
            let sets = structure.sets().map(|set| set.map(Role::symbol).join(" "));
            scheme(&[&sets[0], &sets[1]], None)
        });
        gearboxes.collect::<Vec<_>>()
    };
    let in_service = machines::all().into_iter().map(|machine| machine.gearbox).collect();
    let counts = [structures(Structure::catalogue().to_vec()), structures(Structure::all()), in_service].map(
        |gearboxes| {
            let verdicts: Vec<bool> = gearboxes.iter().filter_map(in_one_band).collect();
            [verdicts.iter().filter(|in_band| **in_band).count(), verdicts.len()]
        },
    );
    assert_eq!(counts, [[11, 11], [106, 106], [5, 5]]);
}
