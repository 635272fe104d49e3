//! Signs: housing, central gears, planets on their planet pins, brakes and clutches, ends of shafts.

use super::to_scale::Wheel;
use super::{Look, SHAFT_MM, Sheet, UP_MM, WEB_MM};
use crate::gearbox::{ENGAGED, RESTING};
use crate::tolerance::IDLE;
use epicyclic_drawing::{Color, Point, Shape, Style};
use epicyclic_layout::layout::{Point as Place, Segment, SetStack};
use epicyclic_train::LinkId;
use epicyclic_train::set::SetKind;

/// Half the length of a rim, and of a plate.
pub(super) const RIM_MM: f64 = 2.6;
/// Half the room between two rims in mesh.
pub(super) const MESH_MM: f64 = 0.55;
/// Distance from the middle of a set to a carrier's fork, and to the remaining bearings of a pair.
pub(super) const FORK_MM: f64 = 4.2;
/// Length of a planet pin outside its planet.
pub(super) const PLANET_PIN_MM: f64 = 3.2;
/// Distance from the middle of a set to planets drawn side by side, and half the length of their rims.
pub(super) const BESIDE_MM: f64 = 1.9;
const SHORT_RIM_MM: f64 = 1.2;
/// Half the hub of a planet of two.
pub(super) const HUB_MM: f64 = 0.8;
/// Room beside a line in front.
pub(super) const BEHIND_MM: f64 = 0.7;
/// The smaller step of a planet over the larger.
pub(super) const STEP: f64 = 0.72;
/// Radius of the circle where power enters or leaves in some gears only.
pub(super) const TAKE_OFF_MM: f64 = 1.2;
/// Length of hatching strokes along the axis and away from it. They lean to the right of upright walls and
/// above level ones.
const HATCH_MM: f64 = 1.8;

/// Whether the carrier of a set is not drawn straight through its planet.
pub(super) fn is_cut(kind: SetKind) -> bool {
    matches!(kind, SetKind::DoublePlanet | SetKind::MeshingSuns) || kind.is_pair()
}

/// Pieces of a link's line that remain where carriers fork around double planets and bearings of pairs end.
pub(super) fn without_forks(sheet: &Sheet<'_>, link: LinkId, line: [Place; 2]) -> Vec<[Place; 2]> {
    let [from, to] = line;
    let mut left = vec![line];
    if from.y != to.y {
        return left;
    }
    for stack in &sheet.layout.sets {
        let kind = sheet.gearbox.drawn_sets()[stack.set].kind;
        let long = sheet.long_pair_of(stack.set);
        if !is_cut(kind) && long.is_none() || stack.members[2] != link || stack.planet != from.y {
            continue;
        }
        // A carrier forks around a long planet as a whole.
        let ends = long.map_or([stack.x; 2], |pair| pair.stacks.map(|stack| stack.x));
        let [low, high] = [ends[0].min(ends[1]), ends[0].max(ends[1])].map(|x| sheet.along.mm(x));
        let [low, high] = [low - FORK_MM, high + FORK_MM].map(|mm| sheet.along.x(mm));
        left = left
            .into_iter()
            .flat_map(|[from, to]| {
                let (a, b) = (from.x.min(to.x), from.x.max(to.x));
                let y = from.y;
                let place = move |x: f64| Place { x, y };
                [[a, b.min(low)], [a.max(high), b]]
                    .into_iter()
                    .filter(|[a, b]| a < b)
                    .map(move |[a, b]| [place(a), place(b)])
            })
            .collect();
    }
    left
}

impl Sheet<'_> {
    /// Draws the axis, the wall and the projections of the wall.
    pub(super) fn housing(&mut self) {
        let (axis, wall) = (self.layout.axis, self.layout.housing);
        let (left, right) = (self.at(axis.from), self.at(axis.to));
        self.scene.add(self.layers.axis, Shape::line([left.x - 13.0, 0.0], [right.x + 13.0, 0.0]));
        self.hatched(wall);
        let ground = self.layout.links.iter().filter(|shape| shape.link == LinkId::GROUND);
        let segments: Vec<Segment> = ground.flat_map(|shape| shape.segments.clone()).collect();
        for segment in segments {
            for [from, to] in without_forks(self, LinkId::GROUND, [segment.from, segment.to]) {
                self.hatched(Segment { from, to });
            }
        }
    }

    fn hatched(&mut self, segment: Segment) {
        let (from, to) = (self.at(segment.from), self.at(segment.to));
        self.scene.add_styled(self.layers.housing, Style::line(SHAFT_MM), Shape::line(from, to));
        let upright = from.x == to.x;
        let length = (to.x - from.x).max(to.y - from.y);
        let mut along = 0.8;
        while along < length - 0.2 {
            let (x, y) = if upright { (from.x, from.y + along) } else { (from.x + along, from.y) };
            let stroke = Shape::line([x, y], [x + HATCH_MM, y + HATCH_MM]);
            self.scene.add_styled(self.layers.housing, Style::line(0.18), stroke);
            along += 2.2;
        }
    }

    /// Brakes and clutches: plates, filled between where engaged.
    pub(super) fn shift_elements(&mut self) {
        for mark in self.layout.clutches.clone() {
            let ends = [mark.lower, mark.upper].map(|(link, place)| (Some(link), self.at(place)));
            self.plates(mark.shift_element, ends);
        }
        for mark in self.layout.brakes.clone() {
            self.plates(
                mark.shift_element,
                [(Some(mark.link), self.at(mark.link_end)), (None, self.at(mark.housing))],
            );
            if mark.housing.y != self.layout.housing.from.y {
                // A separate plate on the projection of the wall, hatched on its far side.
                let (plate, away) = (self.at(mark.housing), (mark.housing.y - mark.link_end.y).signum());
                for i in -1..=1 {
                    let x = plate.x + 1.7 * f64::from(i) - 0.6;
                    let stroke = Shape::line([x, plate.y], [x + 1.2, plate.y + 1.2 * away]);
                    self.scene.add_styled(self.layers.housing, Style::line(0.18), stroke);
                }
            }
        }
    }

    fn plates(&mut self, shift_element: usize, ends: [(Option<LinkId>, Point); 2]) {
        let engaged = self.engaged(shift_element);
        let [low, high] = ends.map(|(_, point)| point);
        if engaged {
            let box_between = Shape::rectangle([low.x - RIM_MM, low.y], [high.x + RIM_MM, high.y]);
            self.scene.add_styled(self.layers.shift_elements, Style::filled(ENGAGED), box_between);
        }
        for (link, point) in ends {
            let color = match link {
                _ if engaged => ENGAGED,
                Some(link) if self.rests(link) => RESTING,
                _ => Color::BLACK,
            };
            let plate = Shape::line([point.x - RIM_MM, point.y], [point.x + RIM_MM, point.y]);
            self.scene.add_styled(self.layers.shift_elements, Style::line(SHAFT_MM).color(color), plate);
        }
    }

    /// Central gears and planets of all sets.
    pub(super) fn sets(&mut self) {
        for pair in self.pairs.clone() {
            self.pair(&pair);
        }
        for stack in self.layout.sets.clone() {
            if self.pair_of(stack.set).is_some() {
                continue;
            }
            let kind = self.gearbox.drawn_sets()[stack.set].kind;
            let x = self.at(Place { x: stack.x, y: 0.0 }).x;
            // Rims of stepped planets' gears are on two sides, and so are those of planets side by side.
            let beside = self.beside(&stack);
            let aside = match beside {
                Some(_) => BESIDE_MM,
                None if kind.is_stepped() => 3.2,
                None => 0.0,
            };
            let (sun_mesh, ring_mesh) = match kind.is_pair() {
                true => (UP_MM * stack.planet, UP_MM * stack.planet),
                false => (UP_MM * stack.sun_mesh, UP_MM * stack.ring_mesh),
            };
            self.central_gear(&stack, 0, [x, UP_MM * stack.sun], sun_mesh - MESH_MM, -aside);
            self.central_gear(&stack, 1, [x, UP_MM * stack.ring], ring_mesh + MESH_MM, aside);
            match kind {
                _ if kind.is_pair() => {}
                SetKind::DoublePlanet | SetKind::MeshingSuns => match beside {
                    Some(planets) => self.planets_beside(&stack, x, planets),
                    None => self.double_planet(&stack, x),
                },
                _ if kind.is_stepped() => self.stepped_planet(&stack, x, aside),
                _ => {
                    let rims = [sun_mesh + MESH_MM, ring_mesh - MESH_MM];
                    self.planet_pin(&stack, x, UP_MM * stack.planet);
                    self.planet(&stack, x, UP_MM * stack.planet, rims);
                }
            }
        }
    }

    /// The look of a member of a set in its gear.
    pub(super) fn member_look(&self, stack: &SetStack, member: usize, width: f64) -> Look {
        let (power, circulating) = self.member(stack.set, member);
        self.look(stack.members[member], width, power, circulating)
    }

    /// A central gear: its web from where it sits to its rim, the rim `aside` of the web.
    pub(super) fn central_gear(
        &mut self,
        stack: &SetStack,
        member: usize,
        [x, seat]: [f64; 2],
        rim: f64,
        aside: f64,
    ) {
        let look = self.member_look(stack, member, WEB_MM);
        self.line(self.layers.toothed_gears, look, Point::new(x, seat), Point::new(x, rim));
        let color = if look.color == RESTING { RESTING } else { Color::BLACK };
        let reach = [x.min(x + aside) - RIM_MM, x.max(x + aside) + RIM_MM];
        let reach = if aside < 0.0 {
            [reach[0], x + 0.5]
        } else if aside > 0.0 {
            [x - 0.5, reach[1]]
        } else {
            reach
        };
        self.rim(color, reach, rim);
    }

    fn rim(&mut self, color: Color, [left, right]: [f64; 2], y: f64) {
        let style = Style::line(SHAFT_MM).color(color);
        self.scene.add_styled(self.layers.toothed_gears, style, Shape::line([left, y], [right, y]));
    }

    /// Colour of planets: grey where neither carrier nor central gears turn.
    pub(super) fn planet_color(&self, stack: &SetStack) -> Color {
        if stack.members.iter().all(|link| self.rests(*link)) { RESTING } else { Color::BLACK }
    }

    /// Half the width of the carrier's line, from which the planet's bearing keeps away.
    pub(super) fn planet_pin_half(&self, stack: &SetStack) -> f64 {
        0.5 * self.member_look(stack, 2, SHAFT_MM).width_mm
    }

    pub(super) fn planet_pin(&mut self, stack: &SetStack, x: f64, y: f64) {
        let color = if self.rests(stack.members[2]) { RESTING } else { Color::BLACK };
        let look = Look { color, width_mm: WEB_MM, inner_mm: 0.0 };
        self.line(
            self.layers.toothed_gears,
            look,
            Point::new(x - PLANET_PIN_MM, y),
            Point::new(x + PLANET_PIN_MM, y),
        );
    }

    /// A planet about a planet pin at `y`: bearing, webs, rims.
    fn planet(&mut self, stack: &SetStack, x: f64, y: f64, [low, high]: [f64; 2]) {
        let color = self.planet_color(stack);
        let hub = (self.planet_pin_half(stack) + 0.55).min(0.4 * (high - low));
        let style = Style::line(WEB_MM).color(color);
        for (member, side, rim) in [(0, -1.0, low), (1, 1.0, high)] {
            let bearing = y + side * hub;
            let look = Look { color, ..self.member_look(stack, member, WEB_MM) };
            let look = match self.member(stack.set, member).0 {
                Some(power) if power.abs() > IDLE => self.member_look(stack, member, WEB_MM),
                _ => look,
            };
            self.line(self.layers.toothed_gears, look, Point::new(x, bearing), Point::new(x, rim));
            self.scene.add_styled(
                self.layers.toothed_gears,
                style,
                Shape::line([x - 1.5, bearing], [x + 1.5, bearing]),
            );
            self.rim(color, [x - RIM_MM, x + RIM_MM], rim);
        }
    }

    /// Two planets of a set to scale that cannot be drawn one above the other, as they reach past each other.
    pub(super) fn beside(&self, stack: &SetStack) -> Option<[Wheel; 2]> {
        let &[one, other] = self.scale?.wheels.get(stack.set)?.as_slice() else { return None };
        let kind = self.gearbox.drawn_sets()[stack.set].kind;
        let is_double = matches!(kind, SetKind::DoublePlanet | SetKind::MeshingSuns);
        (is_double && UP_MM * (one.pin + one.radius - other.pin + other.radius) > MESH_MM)
            .then_some([one, other])
    }

    /// Draws planets on the arms of a fork, one on either side; an arm that passes behind the other planet
    /// has a gap there.
    fn planets_beside(&mut self, stack: &SetStack, x: f64, planets: [Wheel; 2]) {
        let pins = planets.map(|planet| UP_MM * planet.pin);
        let look = Look { inner_mm: 0.0, width_mm: SHAFT_MM, ..self.member_look(stack, 2, SHAFT_MM) };
        let level = UP_MM * stack.planet;
        let sides = self.carrier_sides(stack);
        for &side in &sides {
            let fork = x + side * FORK_MM;
            let ends = [pins[0].min(pins[1]).min(level), pins[0].max(pins[1]).max(level)];
            self.line(self.layers.toothed_gears, look, Point::new(fork, ends[0]), Point::new(fork, ends[1]));
            for (place, pin) in pins.into_iter().enumerate() {
                let own = if place == 0 { -1.0 } else { 1.0 };
                // With a fork on either side each planet has the arm next to it.
                if sides.len() > 1 && own != side {
                    continue;
                }
                let (near, far) = (x - own * BESIDE_MM, x + own * BESIDE_MM);
                let end = far - side * SHORT_RIM_MM;
                let is_behind = own != side && (pins[0] - pins[1]).abs() > HUB_MM;
                let mut line = |from: f64, to: f64| {
                    self.line(self.layers.toothed_gears, look, Point::new(from, pin), Point::new(to, pin));
                };
                if is_behind {
                    line(fork, near + side * BEHIND_MM);
                    line(near - side * BEHIND_MM, end);
                } else {
                    line(fork, end);
                }
            }
        }
        let color = self.planet_color(stack);
        for ((planet, pin), own) in planets.into_iter().zip(pins).zip([-1.0, 1.0]) {
            self.wheel(x + own * BESIDE_MM, [SHORT_RIM_MM; 2], pin, UP_MM * planet.radius - MESH_MM, color);
        }
    }

    /// A planet in section on a pin of its own: hub, webs and rims; its rims so far to the left and right.
    pub(super) fn wheel(&mut self, x: f64, [left, right]: [f64; 2], pin: f64, radius: f64, color: Color) {
        let style = Style::line(WEB_MM).color(color);
        for side in [-1.0, 1.0] {
            let (hub, rim) = (pin + side * HUB_MM.min(0.5 * radius), pin + side * radius);
            self.scene.add_styled(self.layers.toothed_gears, style, Shape::line([x, hub], [x, rim]));
            let bearing = Shape::line([x - SHORT_RIM_MM, hub], [x + SHORT_RIM_MM, hub]);
            self.scene.add_styled(self.layers.toothed_gears, style, bearing);
            self.rim(color, [x - left, x + right], rim);
        }
    }

    /// Two planets in mesh on the arms of a fork.
    fn double_planet(&mut self, stack: &SetStack, x: f64) {
        let middle = match self.scale.and_then(|scale| scale.wheels.get(stack.set)?.first()) {
            Some(first) => UP_MM * (first.pin + first.radius),
            None => UP_MM * stack.planet,
        };
        let rims = [
            [UP_MM * stack.sun_mesh + MESH_MM, middle - MESH_MM],
            [middle + MESH_MM, UP_MM * stack.ring_mesh - MESH_MM],
        ];
        let planet_pins = rims.map(|[low, high]| f64::midpoint(low, high));
        let look = Look { inner_mm: 0.0, width_mm: SHAFT_MM, ..self.member_look(stack, 2, SHAFT_MM) };
        for side in self.carrier_sides(stack) {
            let fork = x + side * FORK_MM;
            self.line(
                self.layers.toothed_gears,
                look,
                Point::new(fork, planet_pins[0]),
                Point::new(fork, planet_pins[1]),
            );
            for planet_pin in planet_pins {
                self.line(
                    self.layers.toothed_gears,
                    look,
                    Point::new(fork, planet_pin),
                    Point::new(x - side * 1.8, planet_pin),
                );
            }
        }
        let color = self.planet_color(stack);
        let style = Style::line(WEB_MM).color(color);
        for ([low, high], planet_pin) in rims.into_iter().zip(planet_pins) {
            for (side, rim) in [(-1.0, low), (1.0, high)] {
                let bearing = planet_pin + 0.8 * side;
                self.scene.add_styled(self.layers.toothed_gears, style, Shape::line([x, bearing], [x, rim]));
                let hub = Shape::line([x - 1.2, bearing], [x + 1.2, bearing]);
                self.scene.add_styled(self.layers.toothed_gears, style, hub);
                self.rim(color, [x - RIM_MM, x + RIM_MM], rim);
            }
        }
    }

    /// Whether a set is drawn to scale.
    pub(super) fn is_to_scale(&self, stack: &SetStack) -> bool {
        self.scale.and_then(|scale| scale.wheels.get(stack.set)).is_some_and(|wheels| !wheels.is_empty())
    }

    /// Sides on which a carrier reaches the planet of a set.
    pub(super) fn carrier_sides(&self, stack: &SetStack) -> Vec<f64> {
        let ground = self.layout.links.iter().filter(|shape| shape.link == stack.members[2]);
        let level = ground
            .flat_map(|shape| &shape.segments)
            .filter(|s| s.from.y == stack.planet && s.to.y == stack.planet);
        let here: Vec<&Segment> = level.filter(|s| (s.from.x..=s.to.x).contains(&stack.x)).collect();
        let mut sides = vec![];
        if here.iter().any(|s| s.from.x < stack.x) {
            sides.push(-1.0);
        }
        if here.iter().any(|s| s.to.x > stack.x) {
            sides.push(1.0);
        }
        sides
    }

    /// Two steps on one shaft, the one in mesh with the first central gear on the left.
    fn stepped_planet(&mut self, stack: &SetStack, x: f64, aside: f64) {
        let y = UP_MM * stack.planet;
        self.planet_pin(stack, x, y);
        let color = self.planet_color(stack);
        let style = Style::line(WEB_MM).color(color);
        let hub = self.planet_pin_half(stack) + 0.55;
        let reach =
            [UP_MM * stack.sun_mesh + MESH_MM - y, UP_MM * stack.ring_mesh - MESH_MM - y].map(f64::abs);
        // The step in mesh below is the larger one, so that both are seen; to scale each is as large on both
        // sides.
        let far = if self.is_to_scale(stack) { 1.0 } else { STEP };
        for (x, size, meshes) in [(x - aside, reach[0], -1.0), (x + aside, reach[1], 1.0)] {
            for side in [-1.0, 1.0] {
                let rim = y + side * if side == meshes { size } else { far * size };
                self.scene.add_styled(
                    self.layers.toothed_gears,
                    style,
                    Shape::line([x, y + side * hub], [x, rim]),
                );
                self.rim(color, [x - 1.7, x + 1.7], rim);
            }
        }
        for side in [-1.0, 1.0] {
            let tube = Shape::line([x - aside - 0.8, y + side * hub], [x + aside + 0.8, y + side * hub]);
            self.scene.add_styled(self.layers.toothed_gears, style, tube);
        }
    }

    /// Arrows at input and output, circles where power enters or leaves in some gears only.
    pub(super) fn shaft_ends(&mut self) {
        let gear = self.gear.map(epicyclic_train::Analysis::gear);
        let of = |link: LinkId| super::flow::piece_of(self.gearbox, link);
        let [input, output] = match gear {
            Some(gear) => [of(gear.input()), of(gear.output())],
            None => [self.layout.input.link, self.layout.output.link],
        };
        for shaft in [self.layout.input, self.layout.output] {
            let end = self.at(shaft.at);
            let outward = if shaft.at.x <= self.layout.axis.from.x { -1.0 } else { 1.0 };
            let sense = if shaft.link == input {
                -outward
            } else if shaft.link == output {
                outward
            } else {
                continue;
            };
            let (near, far) = (end.x + 1.8 * outward, end.x + 9.0 * outward);
            let (tail, head) = if sense == outward { (near, far) } else { (far, near) };
            let style = Style::line(WEB_MM);
            self.scene.add_styled(
                self.layers.links,
                style,
                Shape::line([tail, end.y], [head - 2.0 * sense, end.y]),
            );
            let tip = [[head, end.y], [head - 2.8 * sense, end.y + 1.1], [head - 2.8 * sense, end.y - 1.1]];
            self.scene.add_styled(self.layers.links, Style::filled(Color::BLACK), Shape::polygon(tip));
        }
        for shaft in self.layout.take_offs.clone() {
            let rests = self.rests(shaft.link);
            let color = if rests { RESTING } else { Color::BLACK };
            let style = Style::line(WEB_MM).color(color).fill(Color::WHITE);
            self.scene.add_styled(
                self.layers.links,
                style,
                Shape::Circle { centre: self.at(shaft.at), radius: TAKE_OFF_MM },
            );
        }
    }
}
