//! A planetary gear set seen along its axis, to scale: pitch, tip and root circles.

use epicyclic_drawing::{Align, Color, Error, Point, Scene, Shape, Style, Text};
use epicyclic_gears::geometry::ToothedGear;

use epicyclic_units::Physical;
use uom::si::f64::{Angle, Length};

/// Sun, planets and ring of a simple set.
#[derive(Debug, Clone, PartialEq)]
pub struct GearSet<'a> {
    /// The sun.
    pub sun: Circles,
    /// A planet.
    pub planet: Circles,
    /// The ring.
    pub ring: Circles,
    /// Radius of the planets' orbit.
    pub centre_distance: Length,
    /// Angles of the planets.
    pub angles: &'a [Angle],
}

/// Circles of a gear that are drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circles {
    /// Number of teeth.
    pub teeth: u32,
    /// Pitch diameter.
    pub pitch_diameter: Length,
    /// Tip diameter.
    pub tip_diameter: Length,
    /// Root diameter.
    pub root_diameter: Length,
}

impl Circles {
    /// Circles of a gear.
    #[must_use]
    pub fn of(gear: &ToothedGear) -> Self {
        Self {
            teeth: gear.teeth().get(),
            pitch_diameter: gear.pitch_diameter(),
            tip_diameter: gear.tip_diameter(),
            root_diameter: gear.root_diameter(),
        }
    }
}

impl GearSet<'_> {
    /// The scene: 1 mm of it is 1 mm of the gear set.
    ///
    /// # Errors
    /// As [`Scene::check`]: for gears larger than 100 m.
    pub fn scene(&self) -> Result<Scene, Error> {
        let radius = |gear: &Circles| 0.5 * gear.tip_diameter.mm();
        // Lines and letters keep their proportion to the set, whatever its size.
        let outside = 0.5 * self.ring.root_diameter.mm();
        let unit = outside / 60.0;
        let mut scene = Scene::new("The gear set along its axis");
        let axes = scene.layer("axes", Style::centre_line().width(0.15 * unit))?;
        let body = Style::line(0.35 * unit);
        let ring = scene.layer("ring", body.fill(Color::new(226, 226, 230)))?;
        let planets = scene.layer("planets", body.fill(Color::new(214, 228, 242)))?;
        let sun = scene.layer("sun", body.fill(Color::new(246, 226, 206)))?;
        let labels = scene.layer("labels", Style::line(0.1))?;
        let circle = |centre: Point, diameter: Length| Shape::Circle { centre, radius: 0.5 * diameter.mm() };
        let centre = Point::default();
        scene.add(ring, Shape::Circle { centre, radius: outside + 5.0 * unit });
        scene.add_styled(ring, body.fill(Color::WHITE), circle(centre, self.ring.tip_diameter));
        let thin = Style::line(0.15 * unit);
        scene.add_styled(ring, thin, circle(centre, self.ring.root_diameter));
        let orbit = Shape::Circle { centre, radius: self.centre_distance.mm() };
        let mut gear = |layer, centre: Point, gear: &Circles| {
            scene.add(layer, circle(centre, gear.tip_diameter));
            scene.add_styled(layer, thin, circle(centre, gear.root_diameter));
            scene.add(axes, circle(centre, gear.pitch_diameter));
            let arm = radius(gear) + 1.5 * unit;
            let hair = 0.25 * arm;
            scene.add(axes, Shape::line([centre.x - hair, centre.y], [centre.x + hair, centre.y]));
            scene.add(axes, Shape::line([centre.x, centre.y - hair], [centre.x, centre.y + hair]));
        };
        gear(sun, centre, &self.sun);
        for angle in self.angles {
            gear(planets, Point::polar(centre, self.centre_distance.mm(), angle.si()), &self.planet);
        }
        scene.add(axes, circle(centre, self.ring.pitch_diameter));
        scene.add(axes, orbit);
        let x = outside + 9.0 * unit;
        let lines = [
            format!("sun z₁ = {}", self.sun.teeth),
            format!("{} planets z₂ = {}", self.angles.len(), self.planet.teeth),
            format!("ring z₃ = {}", self.ring.teeth),
            format!(
                "pitch diameters {}, {}, {} mm",
                short(self.sun.pitch_diameter.mm()),
                short(self.planet.pitch_diameter.mm()),
                short(self.ring.pitch_diameter.mm())
            ),
            format!("centre distance {} mm", short(self.centre_distance.mm())),
        ];
        for (line, y) in lines.into_iter().zip([16.0, 8.0, 0.0, -8.0, -16.0]) {
            scene.add(labels, Text::new([x, y * unit], 3.0 * unit, line).align(Align::Left));
        }
        scene.check()?;
        Ok(scene)
    }
}

/// Millimetres to a thousandth.
fn short(value: f64) -> String {
    let text = format!("{value:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use epicyclic_drawing::text::overlaps;
    use epicyclic_gears::geometry::{BasicRack, GearKind};
    use epicyclic_gears::teeth::ToothCount;

    #[test]
    fn planets_stand_between_sun_and_ring_and_no_label_is_in_the_way() {
        let module = Length::from_mm(8.0);
        let gear = |kind, teeth| {
            ToothedGear::new(kind, module, ToothCount::new(teeth).unwrap(), BasicRack::default()).unwrap()
        };
        let [sun, planet] = [18, 36].map(|teeth| Circles::of(&gear(GearKind::External, teeth)));
        let ring = Circles::of(&gear(GearKind::Internal, 90));
        let angles = [0.0, 2.0, 4.0].map(Angle::from_si);
        let centre_distance = Length::from_mm(216.0);
        let set = GearSet { sun, planet, ring, centre_distance, angles: &angles };
        let scene = set.scene().unwrap();
        assert_eq!(overlaps(&scene), vec![]);
        // The pitch circles of planets touch the sun's and the ring's: 216 − 144 = 72, 216 + 144 = 360.
        let circles = scene.items().iter().filter(|item| {
            matches!(item.shape, Shape::Circle { radius, .. } if [72.0, 144.0, 360.0].iter().any(|r: &f64| (r - radius).abs() < 1e-9))
        });
        assert_eq!(circles.count(), 5);
    }
}
