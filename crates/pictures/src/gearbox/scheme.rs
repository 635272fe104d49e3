//! The kinematic scheme: the section of a gearbox by the half-plane above its axis, in the field's signs.
//!
//! | sign | is |
//! |---|---|
//! | thick line | a shaft, drum or web |
//! | T | a central gear: its rim at the contact, its web at right angles to the axis |
//! | two rims a little apart | gears in mesh |
//! | web between two short lines on a shaft | a planet that turns on its planet pin |
//! | two plates apart | a clutch; a brake, where one plate is the housing's |
//! | hatched line | the housing |
//! | dashes and dots | the axis |
//! | circle at the end of a shaft | a machine or train at the housing, for power in some gears only |
//!
//! Central gears are drawn at the places of the [layout](epicyclic_layout::Layout). Heights are radii only in
//! a layout [`to_scale`]. Planets of a stepped set have two rims side by side, double planets are two on a
//! forked carrier, a pair on fixed axes is drawn about one axis. Two stepped suns or rings, meshing suns and
//! bevel sets are drawn as sun, planet and ring; the line of their set below the drawing names the kind.
//!
//! A Ravigneaux set and a Wolfrom drive are drawn as one set if the layout has their two halves side by side.
//! The planet that they have in common passes through both, and the common gear is drawn once. The lines
//! below the drawing say so, or that the halves are drawn apart.
//!
//! In a gear the engaged shift elements are filled and the parts at rest are grey. With the power flow each
//! line is as wide as the power that passes it, `|Σ T·ω|` over the power that enters. The circulating part is
//! drawn inside in another colour.

mod along;
mod flow;
mod halves;
mod names;
mod shared;
mod signs;
mod to_scale;

use super::words::{self, decimal};
use super::{CIRCULATING, ENGAGED, Error, POWER, RESTING, TITLE_MM};
use crate::tolerance::{CIRCULATES, IDLE, RESTS};
use along::Along;
use epicyclic_drawing::text::overlaps;
use epicyclic_drawing::{Align, Color, LayerId, Point, Scene, Shape, Style, Text};
use epicyclic_layout::Layout;
use epicyclic_layout::layout::Point as Place;
use epicyclic_train::{Analysis, Gearbox, LinkId, LoadCase};
use flow::Piece;
pub(super) use flow::piece_of;
pub use to_scale::{Scale, to_scale};

/// Millimetres to a unit of the layout along the axis.
pub const ALONG_MM: f64 = 13.0;
/// Millimetres to a unit of the layout away from the axis.
pub const UP_MM: f64 = 12.0;

/// The least of [`Options::along_mm`] in [`narrow`]: the signs of neighbouring sets stay apart.
const LEAST_ALONG_MM: f64 = 7.0;

/// Additional width of the next trial of [`narrow`].
const WIDER_MM: f64 = 0.25;

/// Width of shafts, and of gears' rims.
const SHAFT_MM: f64 = 0.7;
/// Width of webs and plates.
const WEB_MM: f64 = 0.5;
/// Width of a line for the power that enters, unless others are so much larger that they get [`WIDEST_MM`].
const ENTERING_MM: f64 = 2.2;
const WIDEST_MM: f64 = 4.5;
/// Width of what turns without power.
const IDLE_MM: f64 = 0.3;

/// Longest scale bar, and its distance beyond the right end of the axis.
const LONGEST_BAR_MM: f64 = 30.0;
const BAR_OFF_MM: f64 = 17.0;

/// State of a gear that is shown.
#[derive(Debug, Clone, Copy)]
pub enum Show<'a> {
    /// No gear: the structure alone.
    Structure,
    /// The engaged elements and the parts at rest.
    Gear(&'a Analysis<'a>),
    /// The engaged elements, and the power as width of the lines: with losses if they are known.
    Power(&'a Analysis<'a>),
}

/// Options of the drawing of a scheme.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// The title; `None` for the gearbox's name and the gear's ratio.
    pub title: Option<String>,
    /// Whether both halves are drawn, the lower as a mirror image.
    pub whole: bool,
    /// Whether the lines of the sets say `k` or teeth.
    pub gearing: bool,
    /// Whether title, sets and the meaning of the colours are left out, for a page that gives them.
    pub bare: bool,
    /// Millimetres to a unit of the layout along the axis. If it is less than [`ALONG_MM`], lines without
    /// signs are drawn even closer together.
    pub along_mm: f64,
    /// The scale of a layout that has one: see [`to_scale`].
    pub scale: Option<Scale>,
}

impl Default for Options {
    fn default() -> Self {
        Self { title: None, whole: false, gearing: true, bare: false, along_mm: ALONG_MM, scale: None }
    }
}

/// The scheme of a gearbox as it is laid out.
///
/// ```
/// use epicyclic_pictures::gearbox::scheme::{Options, Show, scene};
/// use epicyclic_layout::{self as layout, Verdict};
/// use epicyclic_train::{Gearbox, set::SetSpec};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let gearbox = Gearbox::builder("I")
///     .links(["D", "B", "T1"])
///     .set(SetSpec::simple("1", ["D", "T1", "B"], 2.94))
///     .brake("K1", "T1")
///     .input("D")
///     .output("B")
///     .gear("slow", ["K1"])
///     .build()?;
/// let Verdict::Drawable(layout) = layout::draw(&gearbox, layout::Options::default()) else {
///     unreachable!("I can be drawn");
/// };
/// let slow = gearbox.analyze("slow")?;
/// let image =
///     epicyclic_drawing::svg::write(&scene(&gearbox, &layout, Show::Power(&slow), &Options::default())?)?;
/// assert!(image.contains("K1"));
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// [`Error::SpeedsUnknown`] for a gear in which the speed of a link does not follow, [`Error::NoPower`] where
/// no power flow does.
pub fn scene(gearbox: &Gearbox, layout: &Layout, show: Show<'_>, options: &Options) -> Result<Scene, Error> {
    let mut sheet = unnamed(gearbox, layout, show, options)?;
    sheet.names();
    sheet.legend(options);
    sheet.scene.check()?;
    Ok(sheet.scene)
}

/// The scheme without the names of its parts.
fn unnamed<'a>(
    gearbox: &'a Gearbox,
    layout: &'a Layout,
    show: Show<'a>,
    options: &'a Options,
) -> Result<Sheet<'a>, Error> {
    let gear = match show {
        Show::Structure => None,
        Show::Gear(gear) | Show::Power(gear) => Some(gear),
    };
    if let Some(gear) = gear {
        known(gearbox, gear)?;
    }
    let load = match show {
        Show::Power(gear) => Some(load(gear).ok_or_else(|| Error::NoPower {
            gear: gear.gear().name().into(),
            state: gear.state().to_string(),
        })?),
        _ => None,
    };
    let title = options.title.clone().unwrap_or_else(|| title(gearbox, gear));
    let mut sheet = Sheet::new(gearbox, layout, gear, load, &title, options)?;
    sheet.housing();
    sheet.shift_elements();
    sheet.links();
    sheet.sets();
    if options.whole {
        sheet.mirror();
    }
    sheet.shaft_ends();
    sheet.scale_bar();
    Ok(sheet)
}

/// Scheme for a page: [bare](Options::bare), and compressed along the axis to about this width, as far as the
/// labels have room. A layout [to scale](to_scale) needs its scale.
///
/// # Errors
/// Those of [`scene`].
pub fn narrow(
    gearbox: &Gearbox,
    layout: &Layout,
    show: Show<'_>,
    scale: Option<&Scale>,
    width_mm: f64,
) -> Result<Scene, Error> {
    let bare = |along_mm| Options { bare: true, along_mm, scale: scale.cloned(), ..Options::default() };
    let usual = scene(gearbox, layout, show, &bare(ALONG_MM))?;
    let too_wide = usual.bounds().width() - width_mm;
    if too_wide <= 0.0 {
        return Ok(usual);
    }
    let units = layout.axis.to.x - layout.axis.from.x;
    let mut along_mm = (ALONG_MM - too_wide / units.max(1.0)).clamp(LEAST_ALONG_MM, ALONG_MM);
    // A little wider each time until all labels have room.
    while along_mm < ALONG_MM {
        let options = bare(along_mm);
        let mut sheet = unnamed(gearbox, layout, show, &options)?;
        // Names move no other part: an overlap without them remains with them.
        if overlaps(&sheet.scene).is_empty() {
            sheet.names();
            sheet.legend(&options);
            if overlaps(&sheet.scene).is_empty() {
                sheet.scene.check()?;
                return Ok(sheet.scene);
            }
        }
        along_mm += WIDER_MM;
    }
    Ok(usual)
}

/// The load case that is drawn.
fn load<'a>(gear: &'a Analysis<'_>) -> Option<&'a LoadCase> {
    gear.driving().or_else(|| gear.ideal())
}

/// Refuses a gear with speeds that do not follow.
pub(super) fn known(gearbox: &Gearbox, gear: &Analysis) -> Result<(), Error> {
    let free: Vec<&str> = gearbox
        .links()
        .iter()
        .zip(gear.speeds())
        .filter(|(_, speed)| speed.is_none())
        .map(|(link, _)| link.as_str())
        .collect();
    if free.is_empty() {
        return Ok(());
    }
    Err(Error::SpeedsUnknown {
        gear: gear.gear().name().into(),
        state: gear.state().name().into(),
        links: free.join(", "),
    })
}

/// The gearbox, and of a gear its name and ratio.
pub(super) fn title(gearbox: &Gearbox, gear: Option<&Analysis>) -> String {
    let Some(gear) = gear else { return gearbox.name().into() };
    let ratio =
        gear.ratio().map_or_else(|| gear.state().name().to_owned(), |i| format!("i = {}", decimal(i)));
    format!("{}, gear {}: {ratio}", gearbox.name(), gear.gear().name())
}

/// Colour and widths of a line of a link.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Look {
    color: Color,
    width_mm: f64,
    /// Width of what circulates, inside.
    inner_mm: f64,
}

struct Layers {
    axis: LayerId,
    housing: LayerId,
    links: LayerId,
    toothed_gears: LayerId,
    shift_elements: LayerId,
    power: LayerId,
    labels: LayerId,
}

/// The scheme while it is drawn.
struct Sheet<'a> {
    gearbox: &'a Gearbox,
    layout: &'a Layout,
    gear: Option<&'a Analysis<'a>>,
    load: Option<&'a LoadCase>,
    pieces: Vec<Piece>,
    /// Drawn sets that are one.
    pairs: Vec<halves::Pair>,
    /// Width of the power that enters.
    entering_mm: f64,
    along: Along,
    scale: Option<&'a Scale>,
    scene: Scene,
    layers: Layers,
}

impl<'a> Sheet<'a> {
    fn new(
        gearbox: &'a Gearbox,
        layout: &'a Layout,
        gear: Option<&'a Analysis<'a>>,
        load: Option<&'a LoadCase>,
        title: &str,
        options: &'a Options,
    ) -> Result<Self, Error> {
        let mut scene = Scene::new(title);
        let layers = Layers {
            axis: scene.layer("axis", Style::centre_line())?,
            housing: scene.layer("housing", Style::line(WEB_MM))?,
            shift_elements: scene.layer("shift elements", Style::line(WEB_MM))?,
            links: scene.layer("links", Style::line(SHAFT_MM))?,
            toothed_gears: scene.layer("gears", Style::line(WEB_MM))?,
            power: scene.layer("power", Style::filled(POWER))?,
            labels: scene.layer("labels", Style::line(0.1))?,
        };
        let pieces = flow::pieces(gearbox, layout, gear.zip(load));
        let places = 0..gearbox.drawn_sets().len();
        let members =
            gear.zip(load).map(|(gear, case)| places.filter_map(|place| gear.drawn_power(case, place)));
        let members = members.into_iter().flatten().flat_map(|power| power.members);
        let powers = pieces.iter().filter_map(|piece| piece.power).chain(members).map(f64::abs);
        let largest = powers.fold(1.0, f64::max);
        let entering_mm = ENTERING_MM.min(WIDEST_MM / largest);
        let along = Along::of(gearbox, layout, options.along_mm);
        let scale = options.scale.as_ref();
        let pairs = halves::pairs(gearbox, layout);
        Ok(Self { gearbox, layout, gear, load, pieces, pairs, entering_mm, along, scale, scene, layers })
    }

    /// A place of the layout on paper.
    fn at(&self, place: Place) -> Point {
        Point::new(self.along.mm(place.x), UP_MM * place.y)
    }

    /// Whether a link rests in the gear shown.
    fn rests(&self, link: LinkId) -> bool {
        self.gear.and_then(|gear| gear.speed(link)).is_some_and(|speed| speed.abs() < RESTS)
    }

    fn engaged(&self, shift_element: usize) -> bool {
        self.gear.is_some_and(|gear| gear.gear().engaged().contains(&shift_element))
    }

    /// Colour and width of a line: `width` without powers, else in proportion to `power`. The circulating
    /// part is drawn inside.
    fn look(&self, link: LinkId, width: f64, power: Option<f64>, circulating: f64) -> Look {
        let color = if self.rests(link) { RESTING } else { Color::BLACK };
        if self.load.is_none() || link == LinkId::GROUND {
            return Look { color, width_mm: width, inner_mm: 0.0 };
        }
        match power {
            None => Look { color, width_mm: width, inner_mm: 0.0 },
            Some(power) if power.abs() < IDLE => Look { color, width_mm: IDLE_MM, inner_mm: 0.0 },
            Some(power) => Look {
                color: POWER,
                width_mm: power.abs() * self.entering_mm,
                inner_mm: circulating.abs().min(power.abs()) * self.entering_mm,
            },
        }
    }

    fn line(&mut self, layer: LayerId, look: Look, from: Point, to: Point) {
        let style = Style::line(look.width_mm).color(look.color);
        self.scene.add_styled(layer, style, Shape::line(from, to));
        if look.inner_mm > 0.0 {
            let style = Style::line(look.inner_mm).color(CIRCULATING);
            self.scene.add_styled(self.layers.power, style, Shape::line(from, to));
        }
    }

    /// Power of a member into its set, and the part of it that circulates.
    fn member(&self, set: usize, member: usize) -> (Option<f64>, f64) {
        let of = |set| self.gear.zip(self.load).and_then(|(gear, case)| gear.drawn_power(case, set));
        let shared = self.pair_of(set).filter(|pair| pair.member == member && pair.without.is_some());
        let sets = shared.map_or(vec![set], |pair| pair.stacks.map(|stack| stack.set).to_vec());
        let powers: Option<Vec<_>> = sets.into_iter().map(of).collect();
        powers.map_or((None, 0.0), |powers| {
            (
                Some(powers.iter().map(|power| power.members[member]).sum()),
                powers.iter().map(|power| power.circulating[member]).sum(),
            )
        })
    }

    fn leads_nowhere(&self, piece: &Piece) -> bool {
        halves::leads_nowhere(&self.pairs, piece.link, piece.from, piece.to)
    }

    fn links(&mut self) {
        let pieces = std::mem::take(&mut self.pieces);
        let drawn: Vec<&Piece> = pieces.iter().filter(|piece| !self.leads_nowhere(piece)).collect();
        for piece in &drawn {
            let look = self.look(piece.link, SHAFT_MM, piece.power, piece.circulating);
            for [from, to] in signs::without_forks(self, piece.link, [piece.from, piece.to]) {
                self.line(self.layers.links, look, self.at(from), self.at(to));
            }
        }
        for piece in drawn {
            self.arrow(piece);
        }
        self.pieces = pieces;
    }

    /// Draws the direction of a power that is not small, if an arrow has room.
    fn arrow(&mut self, piece: &Piece) {
        let (from, to) = (self.at(piece.from), self.at(piece.to));
        let length = libm::hypot(to.x - from.x, to.y - from.y);
        let Some(power) = piece.power.filter(|power| power.abs() > 0.02) else { return };
        let size = 1.6 + 0.75 * power.abs() * self.entering_mm;
        if length < 2.2 * size {
            return;
        }
        let sense = power.signum() / length;
        let (dx, dy) = (sense * (to.x - from.x), sense * (to.y - from.y));
        let middle = Point::new(f64::midpoint(from.x, to.x), f64::midpoint(from.y, to.y));
        let corner = |ahead: f64, aside: f64| {
            [middle.x + size * (ahead * dx - aside * dy), middle.y + size * (ahead * dy + aside * dx)]
        };
        let head = Shape::polygon([corner(0.9, 0.0), corner(-0.7, 0.8), corner(-0.7, -0.8)]);
        let color = if piece.circulating.abs() > 0.5 * power.abs() { CIRCULATING } else { POWER };
        self.scene.add_styled(self.layers.power, Style::filled(color), head);
    }

    /// Everything so far once more below the axis.
    fn mirror(&mut self) {
        let down = |p: Point| Point::new(p.x, -p.y);
        for item in self.scene.items().to_vec() {
            let mut shape = item.shape;
            match &mut shape {
                Shape::Line { from, to } => (*from, *to) = (down(*from), down(*to)),
                Shape::Polyline { vertices, .. } => {
                    for vertex in vertices {
                        (vertex.at, vertex.bulge) = (down(vertex.at), -vertex.bulge);
                    }
                }
                Shape::Circle { centre, .. } => *centre = down(*centre),
                _ => continue,
            }
            match item.style {
                Some(style) => self.scene.add_styled(item.layer, style, shape),
                None => self.scene.add(item.layer, shape),
            }
        }
    }

    /// How long some millimetres of radius are, beside the scheme.
    fn scale_bar(&mut self) {
        let Some(bar) = self.scale.and_then(|scale| scale.bar(LONGEST_BAR_MM)) else { return };
        let x = self.at(self.layout.axis.to).x + BAR_OFF_MM;
        let style = Style::line(IDLE_MM);
        let ends = [0.0, bar.drawn_mm].map(|y| Shape::line([x - 1.0, y], [x + 1.0, y]));
        let upright = Shape::line([x, 0.0], [x, bar.drawn_mm]);
        for line in ends.into_iter().chain([upright]) {
            self.scene.add_styled(self.layers.labels, style, line);
        }
        let words = format!("{} mm", bar.length_mm);
        let at = [x + 2.0, 0.5 * bar.drawn_mm];
        self.scene.add(self.layers.labels, Text::new(at, super::LETTERS_MM, words).align(Align::Left));
    }

    /// The title above, the sets and what the colours mean below.
    fn legend(&mut self, options: &Options) {
        let bounds = self.scene.bounds();
        let layer = self.layers.labels;
        if !options.bare {
            let at = [bounds.left, bounds.top + 6.0];
            let title = Text::new(at, TITLE_MM, self.scene.title()).align(Align::Left);
            self.scene.add(layer, title);
        }
        let mut y = bounds.bottom - 6.0;
        let mut write = |scene: &mut Scene, x: f64, words: String| {
            scene.add(layer, Text::new([bounds.left + x, y], super::LETTERS_MM, words).align(Align::Left));
            y -= 4.6;
            y + 4.6
        };
        let sets = if options.bare { 0 } else { self.gearbox.drawn_sets().len() };
        for place in 0..sets {
            write(&mut self.scene, 0.0, words::set(self.gearbox, place, options.gearing));
        }
        let said = if options.bare { vec![] } else { halves::words(self.gearbox, self.layout) };
        let of_scale = self.scale.filter(|_| !options.bare).map(|scale| scale.notes.clone());
        for words in said.into_iter().chain(of_scale.unwrap_or_default()) {
            write(&mut self.scene, 0.0, words);
        }
        if !self.layout.take_offs.is_empty() {
            let y = write(&mut self.scene, 10.0, "power enters or leaves here in some gears only".into());
            let sample =
                Shape::Circle { centre: Point::new(bounds.left + 3.5, y), radius: signs::TAKE_OFF_MM };
            self.scene.add_styled(self.layers.links, Style::line(WEB_MM).fill(Color::WHITE), sample);
        }
        let is_unknown = self.load.is_some() && self.pieces.iter().any(|piece| piece.power.is_none());
        const UNKNOWN: &str = "black lines of full width: their power does not follow";
        if options.bare && is_unknown {
            write(&mut self.scene, 0.0, UNKNOWN.into());
        }
        let Some(gear) = self.gear.filter(|_| !options.bare) else { return };
        let shift_elements =
            gear.gear().engaged().iter().map(|&place| self.gearbox.shift_elements()[place].id());
        let engaged: Vec<&str> = shift_elements.collect();
        if !engaged.is_empty() {
            let y = write(&mut self.scene, 10.0, format!("engaged: {}", engaged.join(", ")));
            let sample = Shape::rectangle([bounds.left, y - 1.2], [bounds.left + 7.0, y + 1.2]);
            self.scene.add_styled(self.layers.shift_elements, Style::filled(ENGAGED), sample);
        }
        let line = |scene: &mut Scene, y: f64, style: Style| {
            scene.add_styled(layer, style, Shape::line([bounds.left + 1.0, y], [bounds.left + 6.0, y]));
        };
        if self.layout.links.iter().any(|shape| shape.link != LinkId::GROUND && self.rests(shape.link)) {
            let y = write(&mut self.scene, 10.0, "at rest".into());
            line(&mut self.scene, y, Style::line(SHAFT_MM).color(RESTING));
        }
        let Some(case) = self.load else { return };
        let eta = case.efficiency;
        let losses = if eta < 1.0 { format!("; efficiency {}", decimal(eta)) } else { String::new() };
        let y = write(&mut self.scene, 10.0, format!("the input power{losses}; other lines in proportion"));
        line(&mut self.scene, y, Style::line(self.entering_mm).color(POWER));
        if case.power.circulating > CIRCULATES {
            let words =
                format!("circulating power, in all {} of the input power", decimal(case.power.circulating));
            let y = write(&mut self.scene, 10.0, words);
            line(&mut self.scene, y, Style::line(0.6 * self.entering_mm).color(CIRCULATING));
        }
        if is_unknown {
            write(&mut self.scene, 0.0, UNKNOWN.into());
        }
    }
}
