//! Roles of the points of a lever, and their signs.

use crate::gearbox::scheme::piece_of;
use crate::tolerance::RESTS;
use epicyclic_drawing::{Color, LayerId, Point, Scene, Shape, Style};
use epicyclic_train::{Analysis, Gearbox, LinkId};

/// Half the size of a sign.
pub(super) const SIGN_MM: f64 = 1.6;

/// Role of a link in a gear, or in all gears.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    Input,
    Output,
    Held,
    Tied,
    Free,
}

impl Role {
    pub(super) const ALL: [Self; 5] = [Self::Input, Self::Output, Self::Held, Self::Tied, Self::Free];

    /// Roles of the links, in the order of the gearbox; the first that applies counts. Without a gear no
    /// shift element is engaged.
    pub(super) fn of_links(gearbox: &Gearbox, gear: Option<&Analysis>) -> Vec<Self> {
        let piece = |link: LinkId| piece_of(gearbox, link);
        let (input, output) = match gear {
            Some(gear) => (vec![gear.gear().input()], vec![gear.gear().output()]),
            None => gearbox.gears().iter().map(|gear| (gear.input(), gear.output())).unzip(),
        };
        let is_end = |ends: &[LinkId], link: LinkId| ends.iter().any(|end| piece(*end) == piece(link));
        let engaged = gear.map_or(&[][..], |gear| gear.gear().engaged());
        let tied = |link: LinkId| {
            engaged
                .iter()
                .map(|&place| &gearbox.shift_elements()[place])
                .any(|one| !one.is_brake() && one.links().iter().any(|end| piece(*end) == piece(link)))
        };
        let held = |link: LinkId| {
            let brakes = |&place: &usize| gearbox.shift_elements()[place].is_brake();
            let is_braked = engaged
                .iter()
                .filter(|place| brakes(place))
                .any(|&place| piece(gearbox.shift_elements()[place].links()[0]) == piece(link));
            is_braked
                || piece(link) == LinkId::GROUND
                || gear.and_then(|gear| gear.speed(link)).is_some_and(|speed| speed.abs() < RESTS)
        };
        let of = |link: LinkId| match link {
            link if is_end(&input, link) => Self::Input,
            link if is_end(&output, link) => Self::Output,
            link if held(link) => Self::Held,
            link if tied(link) => Self::Tied,
            _ => Self::Free,
        };
        gearbox.link_ids().map(of).collect()
    }

    pub(super) fn words(self) -> &'static str {
        match self {
            Self::Input => "input",
            Self::Output => "output",
            Self::Held => "held, at rest",
            Self::Tied => "tied by an engaged clutch",
            Self::Free => "other link",
        }
    }
}

/// Draws the sign of a point.
pub(super) fn draw(scene: &mut Scene, layer: LayerId, at: Point, role: Role) {
    let Point { x, y } = at;
    let r = SIGN_MM;
    let open = Style::line(0.5).fill(Color::WHITE);
    let circle = |radius: f64| Shape::Circle { centre: at, radius };
    match role {
        Role::Input => {
            let side = 0.85 * r;
            scene.add_styled(
                layer,
                open.fill(Color::BLACK),
                Shape::rectangle([x - side, y - side], [x + side, y + side]),
            );
        }
        Role::Output => {
            let corners = [[x - 1.2 * r, y], [x, y - 1.2 * r], [x + 1.2 * r, y], [x, y + 1.2 * r]];
            scene.add_styled(layer, open, Shape::polygon(corners));
        }
        Role::Held => {
            let corners = [[x - 1.1 * r, y - 0.8 * r], [x + 1.1 * r, y - 0.8 * r], [x, y + 1.1 * r]];
            scene.add_styled(layer, open.fill(Color::BLACK), Shape::polygon(corners));
        }
        Role::Tied => {
            scene.add_styled(layer, open, circle(r));
            scene.add_styled(layer, open.fill(Color::BLACK), circle(0.45 * r));
        }
        Role::Free => scene.add_styled(layer, open, circle(0.85 * r)),
    }
}
