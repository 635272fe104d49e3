//! The drawing of a gearbox: that of the cheapest sweep, or where none is found the cheapest of some made by
//! chance.

use super::grid::Grid;
use super::layout::{BrakeMark, ClutchMark, GAP, Layout, PLANET, Point, Segment, SetStack, ShaftEnd, shapes};
use super::map::Map;
use super::order::{self, Dice};
use super::planar::{AXIS, HOUSING, INPUT, OUTPUT};
use super::scheme::{Kind, Scheme};
use super::stacks::{Part, Upward};
use super::sweep::Task;
use super::{bands, carriers, search};
use epicyclic_train::{Gearbox, LinkId};

/// Embeddings that are tried where no sweep is found.
const VARIANTS: usize = 4;

/// States of the search for the first sweep, and its haste: with the second it nearly always ends soon.
const FIRST: [(u32, usize); 2] = [(30, 20_000), (80, 20_000)];
/// Haste of the searches for cheaper sweeps.
const CALMER: [u32; 4] = [20, 15, 12, 10];
/// Largest number of sets for which drawings by chance are made in addition to the search.
const SMALL: usize = 2;
/// States for each attempt that [`Options`](super::Options) allow.
const STATES: usize = 40;

/// Cheapest of several drawings; `None` if the scheme cannot be drawn.
pub(super) fn draw(scheme: &Scheme<'_>, gearbox: &Gearbox, options: super::Options) -> Option<Layout> {
    let graph = scheme.graph(&[]);
    carriers::arrange(&graph, 0)?;
    let task = Task::new(scheme, gearbox, options.same_side);
    let swept = task.and_then(|mut task| {
        let together = swept(&task, gearbox, options.attempts);
        if together.is_some() || !std::mem::take(&mut task.keeps_together) {
            return together;
        }
        swept(&task, gearbox, options.attempts)
    });
    let Some(swept) = swept else { return thrown(scheme, gearbox, options) };
    let drawn = gearbox.drawn_sets();
    let is_whole = drawn.windows(2).all(|pair| pair[0].set != pair[1].set);
    // For few sets chance draws nearly every layout. A cheaper one that the search missed is taken.
    let by_chance = (is_whole && drawn.len() <= SMALL).then(|| thrown(scheme, gearbox, options)).flatten();
    let cost = |layout: &Layout| layout.cost(gearbox).total();
    std::iter::once(swept).chain(by_chance).min_by(|a, b| cost(a).total_cmp(&cost(b)))
}

/// The cheapest of some drawings with all sets in one band.
fn swept(task: &Task, gearbox: &Gearbox, attempts: u32) -> Option<Layout> {
    let first = FIRST.iter().find_map(|&(haste, most)| search::sweep(task, haste, most).steps)?;
    let mut found = vec![first];
    let mut left = usize::try_from(attempts).unwrap_or(usize::MAX).saturating_mul(STATES);
    for haste in CALMER {
        let sweep = search::sweep(task, haste, left);
        left = left.saturating_sub(sweep.states);
        let Some(steps) = sweep.steps else { break };
        if !found.contains(&steps) {
            found.push(steps);
        }
    }
    let layouts = found.iter().filter_map(|steps| bands::layout(task, steps));
    layouts.min_by(|a, b| a.cost(gearbox).total().total_cmp(&b.cost(gearbox).total()))
}

/// The cheapest of some drawings with the sets at any heights.
fn thrown(scheme: &Scheme<'_>, gearbox: &Gearbox, options: super::Options) -> Option<Layout> {
    let graph = scheme.graph(&[]);
    let maps = (0..VARIANTS).map(|variant| Map::new(&graph, variant)).collect::<Option<Vec<_>>>()?;
    let candidates = (0..options.attempts.max(1)).zip(maps.iter().cycle());
    let layouts = candidates.map(|(seed, map)| throw(scheme, gearbox, map, seed, options.same_side));
    layouts.min_by(|a, b| a.cost(gearbox).total().total_cmp(&b.cost(gearbox).total()))
}

fn throw(scheme: &Scheme<'_>, gearbox: &Gearbox, map: &Map, seed: u32, same_side: bool) -> Layout {
    let ranks = order::ranks(map, &mut Dice::new(u64::from(seed)));
    let [below, above] = order::sides(map, &ranks);
    let upward = Upward::new(map, &ranks, below, above);
    let grid = Grid::new(&upward, same_side);
    Drawing { scheme, gearbox, map: &upward, grid: &grid }.layout(same_side)
}

struct Drawing<'a> {
    scheme: &'a Scheme<'a>,
    gearbox: &'a Gearbox,
    map: &'a Upward,
    grid: &'a Grid,
}

impl Drawing<'_> {
    fn x(&self, edge: usize) -> f64 {
        f64::from(self.grid.place[edge])
    }

    fn y(&self, vertex: usize) -> f64 {
        f64::from(self.grid.height[vertex])
    }

    fn set_piece(&self, set: usize, member: usize) -> LinkId {
        self.scheme.piece(self.gearbox.drawn_sets()[set].links[member])
    }

    /// The piece a vertex is drawn as part of.
    fn piece(&self, vertex: usize) -> Option<LinkId> {
        match self.map.parts[vertex] {
            Part::Bar(INPUT) => Some(self.scheme.piece(self.gearbox.input())),
            Part::Bar(OUTPUT) => Some(self.scheme.piece(self.gearbox.output())),
            Part::Bar(owner) => self.scheme.piece_at(owner),
            Part::Sun(set) => Some(self.set_piece(set, 0)),
            Part::Ring(set) => Some(self.set_piece(set, 1)),
            Part::Planet(set) => Some(self.set_piece(set, 2)),
        }
    }

    fn layout(&self, same_side: bool) -> Layout {
        let map = self.map;
        let seen: Vec<usize> = map.above.iter().flatten().copied().filter(|&edge| map.seen(edge)).collect();
        let border = |low: usize, high: usize| {
            map.above[low].iter().find(|&&e| map.ends[e] == [low, high]).map_or(0.0, |&e| self.x(e))
        };
        let left = border(AXIS, INPUT);
        let right = map.above.iter().flatten().map(|&edge| self.x(edge)).fold(left, f64::max);
        let wall = self.y(HOUSING);

        let mut pieces: Vec<(LinkId, Segment)> = vec![];
        let line = |x0: f64, y0: f64, x1: f64, y1: f64| Segment {
            from: Point { x: x0.min(x1), y: y0.min(y1) },
            to: Point { x: x0.max(x1), y: y0.max(y1) },
        };
        let (mut clutches, mut brakes, mut take_offs) = (vec![], vec![], vec![]);

        // Bars.
        for vertex in (0..map.parts.len()).filter(|&vertex| vertex != HOUSING && vertex != AXIS) {
            let Some(piece) = self.piece(vertex) else { continue };
            let at = map.below[vertex].iter().chain(&map.above[vertex]);
            let mut xs: Vec<f64> = at.filter(|&&edge| map.seen(edge)).map(|&edge| self.x(edge)).collect();
            match map.parts[vertex] {
                Part::Bar(INPUT) if !xs.is_empty() => xs.push(left),
                Part::Bar(OUTPUT) if !xs.is_empty() => xs.push(right),
                _ => {}
            }
            let low = xs.iter().copied().fold(f64::INFINITY, f64::min);
            let high = xs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            if low < high {
                pieces.push((piece, line(low, self.y(vertex), high, self.y(vertex))));
            }
        }
        // Lines between them.
        for edge in seen.into_iter().filter(|&edge| !map.mesh[edge]) {
            let [low, high] = map.ends[edge];
            let (x, y0, y1) = (self.x(edge), self.y(low), self.y(high));
            let ends = [self.piece(low), self.piece(high)];
            let [Some(lower), Some(upper)] = ends else { continue };
            let grounded = ends.map(|piece| piece == Some(LinkId::GROUND));
            let point = |y| Point { x, y };
            match map.kinds[edge] {
                Kind::ShiftElement(shift_element) if grounded == [false; 2] => {
                    let middle = f64::midpoint(y0, y1);
                    pieces.push((lower, line(x, y0, x, middle - GAP)));
                    pieces.push((upper, line(x, middle + GAP, x, y1)));
                    clutches.push(ClutchMark {
                        shift_element,
                        lower: (lower, point(middle - GAP)),
                        upper: (upper, point(middle + GAP)),
                    });
                }
                kind @ (Kind::ShiftElement(_) | Kind::TakeOff(_)) => {
                    let (link, from, to, wall) =
                        if grounded[1] { (lower, y0, y1 - GAP, y1) } else { (upper, y1, y0 + GAP, y0) };
                    pieces.push((link, line(x, from, x, to)));
                    match kind {
                        Kind::ShiftElement(shift_element) => brakes.push(BrakeMark {
                            shift_element,
                            link,
                            link_end: point(to),
                            housing: point(wall),
                        }),
                        _ => take_offs.push(ShaftEnd { link, at: point(to) }),
                    }
                }
                _ if y0 < y1 => pieces.push((upper, line(x, y0, x, y1))),
                _ => {}
            }
        }
        // Input and output: along the border down to the axis.
        let input = self.scheme.piece(self.gearbox.input());
        let output = self.scheme.piece(self.gearbox.output());
        let outer = left - 1.0;
        let input_y = if same_side { self.y(INPUT) } else { 0.0 };
        pieces.push((output, line(right, 0.0, right, self.y(OUTPUT))));
        if same_side {
            pieces.push((output, line(outer, 0.0, right, 0.0)));
        } else {
            pieces.push((input, line(left, 0.0, left, self.y(INPUT))));
            pieces.push((output, line(right, 0.0, right + 1.0, 0.0)));
        }
        pieces.push((input, line(outer, input_y, left, input_y)));
        let output_x = if same_side { outer } else { right + 1.0 };

        clutches.sort_by_key(|mark| mark.shift_element);
        brakes.sort_by_key(|mark| mark.shift_element);
        Layout {
            sets: self.stacks(),
            links: shapes(pieces.into_iter().filter(|(_, s)| s.from != s.to).collect()),
            clutches,
            brakes,
            take_offs,
            input: ShaftEnd { link: input, at: Point { x: outer, y: input_y } },
            output: ShaftEnd { link: output, at: Point { x: output_x, y: 0.0 } },
            axis: line(outer, 0.0, right + 1.0, 0.0),
            housing: line(outer, wall, right + 1.0, wall),
        }
    }

    fn stacks(&self) -> Vec<SetStack> {
        let map = self.map;
        let mut sets: Vec<SetStack> = vec![];
        for (vertex, part) in map.parts.iter().enumerate() {
            let &Part::Planet(set) = part else { continue };
            let gear = |wanted: Part| map.parts.iter().position(|&part| part == wanted).unwrap_or(vertex);
            let mesh = map.above[vertex].iter().find(|&&edge| map.mesh[edge]);
            let planet = self.y(vertex);
            sets.push(SetStack {
                set,
                members: [0, 1, 2].map(|member| self.set_piece(set, member)),
                x: mesh.map_or(0.0, |&edge| self.x(edge)),
                sun: self.y(gear(Part::Sun(set))),
                sun_mesh: planet - PLANET,
                planet,
                ring_mesh: planet + PLANET,
                ring: self.y(gear(Part::Ring(set))),
            });
        }
        sets.sort_by_key(|stack| stack.set);
        sets
    }
}

#[cfg(test)]
mod tests {
    use super::super::Options;
    use super::*;
    use epicyclic_train::set::SetSpec;

    fn two_sets(name: &str, sets: [[&str; 3]; 2]) -> Gearbox {
        let mut builder = Gearbox::builder(name).links(["D", "B", "T1", "T2"]);
        for (place, set) in sets.into_iter().enumerate() {
            builder = builder.set(SetSpec::simple(&place.to_string(), set, 2.5));
        }
        let builder = builder.brake("K1", "T1").brake("K2", "T2").clutch("L", "D", "B");
        builder.input("D").output("B").build().unwrap()
    }

    fn gearboxes() -> Vec<Gearbox> {
        vec![
            two_sets("III-1", [["D", "B", "T1"], ["D", "T1", "T2"]]),
            two_sets("II-3", [["T1", "D", "B"], ["T1", "B", "T2"]]),
            two_sets("two suns at the output", [["B", "T1", "D"], ["B", "D", "T2"]]),
        ]
    }

    #[test]
    fn the_cost_of_a_drawing_by_hand() {
        let gearbox = crate::samples::scheme_one();
        let layout = *draw(&Scheme::new(&gearbox, &[]), &gearbox, Options::default()).map(Box::new).unwrap();
        // Input 1 to the sun; carrier 1 to the right and 1 down to the axis, output 1; brake from 2 to 3 less
        // its gap.
        let lengths = [1.0, 1.0, 1.0, 1.0, 1.0 - GAP];
        assert_eq!(layout.links.iter().map(|shape| shape.segments.len()).sum::<usize>(), lengths.len());
        let cost = layout.cost(&gearbox);
        // Corners: under the sun, at the end of the carrier's arm and at the foot of its web.
        assert_eq!((cost.bands, cost.bends, cost.walls, cost.backwards), (1, 3, 0, 0), "{layout:?}");
        assert!((cost.length - lengths.iter().sum::<f64>()).abs() < 1e-12, "{cost:?} {layout:?}");
        assert!((cost.total() - (18.0 + cost.length)).abs() < 1e-12);
    }

    #[test]
    fn more_attempts_cost_no_more_than_fewer_or_than_drawings_of_chance() {
        for gearbox in gearboxes() {
            let scheme = Scheme::new(&gearbox, &[]);
            let cost = |layout: Layout| layout.cost(&gearbox).total();
            let drawn =
                |attempts| cost(draw(&scheme, &gearbox, Options { attempts, same_side: false }).unwrap());
            let costs = [1, 10, 120].map(drawn);
            assert!(costs.windows(2).all(|pair| pair[1] <= pair[0]), "{} {costs:?}", gearbox.name());
            let thrown = cost(thrown(&scheme, &gearbox, Options::default()).unwrap());
            assert!(costs[2] <= thrown, "{} {costs:?} {thrown}", gearbox.name());
        }
    }

    /// Counts drawings in one band of the 106 drawable structures of two sets: by chance 51, by the search
    /// all.
    #[test]
    fn structures_of_two_sets_stand_in_one_band_and_cost_no_more_than_drawings_of_chance() {
        use epicyclic_schemes::structures::{Role, Structure};
        let (mut drawn, mut by_chance, mut dearer) = (0, 0, vec![]);
        for structure in Structure::all() {
            let mut builder = Gearbox::builder("two sets").links(["D", "B", "T1", "T2"]);
            for (place, set) in structure.sets().iter().enumerate() {
                builder = builder.set(SetSpec::simple(&place.to_string(), set.map(Role::symbol), 2.5));
            }
            let gearbox = builder.brake("K1", "T1").brake("K2", "T2").input("D").output("B").build().unwrap();
            let scheme = Scheme::new(&gearbox, &[]);
            let Some(ours) = draw(&scheme, &gearbox, Options::default()) else { continue };
            let (ours, chance) =
                (ours.cost(&gearbox), thrown(&scheme, &gearbox, Options::default()).unwrap().cost(&gearbox));
            assert_eq!(ours.bands, 1, "{structure}");
            drawn += 1;
            by_chance += usize::from(chance.bands == 1);
            if ours.total() > chance.total() {
                dearer.push((structure.to_string(), ours, chance));
            }
        }
        assert_eq!((drawn, by_chance, dearer.len()), (106, 51, 0), "{dearer:?}");
    }
}
