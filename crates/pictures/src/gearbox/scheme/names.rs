//! Names: shift elements, members, links.

use super::signs::{BESIDE_MM, MESH_MM, PLANET_PIN_MM, RIM_MM};
use super::{SHAFT_MM, Sheet, UP_MM, WEB_MM};
use crate::gearbox::place::{Places, beside};
use epicyclic_drawing::{Bounds, Point, Shape};
use epicyclic_layout::layout::{LinkShape, Point as Place, SetStack};
use epicyclic_train::LinkId;

/// Distance from a shaft to the middle of its name.
const OFF_MM: f64 = 2.6;

impl Sheet<'_> {
    /// Writes all names: first those with the fewest possible places.
    pub(super) fn names(&mut self) {
        let mut places = Places::around(&self.scene);
        self.keep_signs_clear(&mut places);
        self.shift_element_names(&mut places);
        self.member_names(&mut places);
        self.link_names(&mut places);
    }

    /// Gaps of clutches and brakes, rims in mesh, webs and planet pins: no leader runs through them, nor
    /// through their mirror images.
    fn keep_signs_clear(&self, places: &mut Places) {
        let clutches = self.layout.clutches.iter().map(|mark| [mark.lower.1, mark.upper.1]);
        let brakes = self.layout.brakes.iter().map(|mark| [mark.link_end, mark.housing]);
        for plates in clutches.chain(brakes) {
            let gap = Bounds::of(plates.map(|plate| self.at(plate)));
            let gap =
                Bounds { left: gap.left - RIM_MM, right: gap.right + RIM_MM, ..gap }.grown(0.5 * SHAFT_MM);
            places.keep_clear(gap);
            places.keep_clear(Bounds { bottom: -gap.top, top: -gap.bottom, ..gap });
        }
        for item in self.scene.items().iter().filter(|item| item.layer == self.layers.toothed_gears) {
            if let Shape::Line { from, to } = &item.shape {
                // Boxes of rims in mesh overlap, so that no leader slips between them.
                let margin = if from.y == to.y { 1.2 * MESH_MM } else { 0.5 * WEB_MM };
                places.keep_clear(item.shape.bounds().grown(margin));
            }
        }
    }

    fn put(&mut self, places: &mut Places, words: &str, points: &[Point], wishes: &[Point]) {
        places.put(&mut self.scene, self.layers.labels, words, points, wishes);
    }

    fn shift_element_names(&mut self, places: &mut Places) {
        let clutches =
            self.layout.clutches.iter().map(|mark| (mark.shift_element, mark.lower.1, mark.upper.1));
        let brakes = self.layout.brakes.iter().map(|mark| (mark.shift_element, mark.link_end, mark.housing));
        let marks: Vec<_> = clutches.chain(brakes).collect();
        for (shift_element, one, other) in marks {
            let name = self
                .gearbox
                .shift_elements()
                .get(shift_element)
                .map_or("direct", |shift_element| shift_element.id())
                .to_owned();
            let (one, other) = (self.at(one), self.at(other));
            let middle = Point::new(one.x, f64::midpoint(one.y, other.y));
            let mut wishes = vec![];
            for dy in [0.0, -1.5, 1.5, -3.0, 3.0] {
                wishes.extend(beside(Point::new(middle.x, middle.y + dy), &name, 2.9));
            }
            for dy in [-3.5, 3.5, -5.0, 5.0] {
                wishes.extend(beside(Point::new(middle.x, middle.y + dy), &name, 0.5));
            }
            let edges = [1.0, -1.0]
                .map(|side| Point::new(middle.x + side * (RIM_MM + 0.5 * SHAFT_MM + 0.1), middle.y));
            self.put(places, &name, &edges, &wishes);
        }
    }

    fn member_names(&mut self, places: &mut Places) {
        for stack in self.layout.sets.clone() {
            let number = stack.set + 1;
            let kind = self.gearbox.drawn_sets()[stack.set].kind;
            let (sun_rim, ring_rim) =
                if kind.is_pair() { (stack.planet, stack.planet) } else { (stack.sun_mesh, stack.ring_mesh) };
            let x = self.at(Place { x: stack.x, y: 0.0 }).x;
            let up = |y: f64| UP_MM * y;
            let web = |from: f64, to: f64| {
                [0.5, 0.35, 0.65, 0.2, 0.8].map(|part| Point::new(x, up(from) + part * (up(to) - up(from))))
            };
            // Of planets side by side the first is on the left.
            let planet_x = match self.beside(&stack) {
                Some(_) if self.pair_of(stack.set).is_none() => x - BESIDE_MM,
                _ => x,
            };
            let mut members = vec![("a", web(stack.sun, sun_rim)), ("b", web(stack.ring, ring_rim))];
            if !kind.is_pair() {
                let pin = self.beside(&stack).map_or(stack.planet, |[first, _]| first.pin);
                members.push(("g", web(stack.sun_mesh, pin).map(|at| Point::new(planet_x, at.y))));
            }
            let hidden = |letter: &str| {
                let member = usize::from(letter == "b");
                letter != "g" && self.pair_of(stack.set).is_some_and(|pair| pair.hides(stack.set, member))
            };
            members.retain(|(letter, _)| !hidden(letter));
            for (letter, along) in members {
                let name = format!("{letter}{number}");
                let gap = 0.1 + self.web_half(&stack, letter);
                let mut wishes: Vec<Point> = along.iter().flat_map(|at| beside(*at, &name, gap)).collect();
                if letter == "g" {
                    let planet_pin = Point::new(x, up(stack.planet));
                    wishes.splice(0..0, beside(planet_pin, &name, 3.3));
                    let above = web(stack.planet, stack.ring_mesh);
                    wishes.extend(above.iter().flat_map(|at| beside(*at, &name, gap)));
                }
                wishes.extend(along.iter().flat_map(|at| beside(*at, &name, 2.7)));
                // A leader starts at the web, or at an end of the rim.
                let rims = match letter {
                    "a" => vec![up(sun_rim) - MESH_MM],
                    "b" => vec![up(ring_rim) + MESH_MM],
                    _ if self.beside(&stack).is_some() => vec![],
                    _ => vec![up(stack.sun_mesh) + MESH_MM, up(stack.ring_mesh) - MESH_MM],
                };
                let end = RIM_MM + MESH_MM + 0.05;
                let ends = rims.iter().flat_map(|y| [end, -end].map(|dx| Point::new(x + dx, *y)));
                let points: Vec<Point> = along.into_iter().chain(ends).collect();
                self.put(places, &name, &points, &wishes);
            }
            if kind.is_pair() || stack.members[2] == LinkId::GROUND {
                continue;
            }
            let name = format!("H{number}");
            let planet_pin = Point::new(x, up(stack.planet));
            let mut wishes = vec![];
            for dx in [4.5, 6.0, 7.5] {
                for dy in [OFF_MM, -OFF_MM, 1.6, -1.6] {
                    wishes.extend([-dx, dx].map(|dx| Point::new(planet_pin.x + dx, planet_pin.y + dy)));
                }
            }
            wishes.splice(0..0, beside(planet_pin, &name, 3.3));
            let ends = [4.2, -4.2, 6.0, -6.0].map(|dx| Point::new(planet_pin.x + dx, planet_pin.y));
            self.put(places, &name, &ends, &wishes);
        }
    }

    /// Half the width of a central gear's web.
    fn web_half(&self, stack: &SetStack, letter: &str) -> f64 {
        let member = usize::from(letter == "b");
        let (power, circulating) = self.member(stack.set, member);
        0.5 * self.look(stack.members[member], WEB_MM, power, circulating).width_mm
    }

    fn link_names(&mut self, places: &mut Places) {
        for shaft in [self.layout.input, self.layout.output] {
            let name = self.gearbox.link_name(shaft.link).to_owned();
            let outward = if shaft.at.x <= self.layout.axis.from.x { -1.0 } else { 1.0 };
            let end = self.at(shaft.at);
            let tip = Point::new(end.x + 5.4 * outward, end.y);
            let half = 0.5 * epicyclic_drawing::Text::new(tip, 2.5, &*name).width_mm();
            let mut wishes = vec![Point::new(tip.x, tip.y + 3.2), Point::new(tip.x, tip.y - 3.6)];
            let outer = end.x + outward * (1.0 + half);
            wishes.extend([Point::new(outer, tip.y + 3.2), Point::new(outer, tip.y - 3.6)]);
            wishes.extend([3.0, 6.0, 10.0].map(|dx| Point::new(outer + outward * dx, tip.y + 3.2)));
            self.put(places, &name, &[tip], &wishes);
        }
        let named = [self.layout.input.link, self.layout.output.link];
        for shape in &self.layout.links.clone() {
            if shape.link == LinkId::GROUND || named.contains(&shape.link) {
                continue;
            }
            let name = self.gearbox.link_name(shape.link).to_owned();
            let (mut points, wishes): (Vec<Point>, Vec<Point>) =
                wishes(shape, &name, |place| self.at(place)).into_iter().unzip();
            // If a carrier lies within its planets' bearings, the pins' ends are visible.
            let carried = self.layout.sets.iter().filter(|stack| stack.members[2] == shape.link);
            for stack in carried {
                let pin = self.at(Place { x: stack.x, y: stack.planet });
                points.extend([-1.0, 1.0].map(|side| Point::new(pin.x + side * PLANET_PIN_MM, pin.y)));
            }
            points.dedup();
            self.put(places, &name, &points, &wishes);
        }
    }
}

/// Desired places of a link's name: along its shafts, the longest first, and then along its webs. Each comes
/// with the point of the link that it names.
fn wishes(shape: &LinkShape, name: &str, at: impl Fn(Place) -> Point) -> Vec<(Point, Point)> {
    let mut segments: Vec<[Point; 2]> = shape.segments.iter().map(|s| [at(s.from), at(s.to)]).collect();
    let length = |[from, to]: &[Point; 2]| (to.x - from.x) + (to.y - from.y);
    segments.sort_by(|one, other| {
        let level = |[from, to]: &[Point; 2]| from.y == to.y;
        level(other).cmp(&level(one)).then(length(other).total_cmp(&length(one)))
    });
    let mut wishes = vec![];
    for [from, to] in segments {
        for part in [0.5, 0.35, 0.65, 0.2, 0.8, 0.1, 0.9] {
            let on = Point::new(from.x + part * (to.x - from.x), from.y + part * (to.y - from.y));
            if from.y == to.y {
                wishes.extend([OFF_MM, -OFF_MM].map(|dy| (on, Point::new(on.x, on.y + dy))));
            } else {
                wishes.extend(beside(on, name, 0.6).map(|wish| (on, wish)));
            }
        }
    }
    wishes
}
