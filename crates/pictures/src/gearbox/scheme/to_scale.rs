//! Heights of gears by their pitch radii.
//!
//! ```text
//! r = m·z/2                                        of central gears and planets
//! R = r_sun + r_planet = r_ring − r_planet         of planet pins
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `r` | pitch radius | mm, or in units of `m/2` |
//! | `R` | radius of a planet pin | that of `r` |
//! | `m`, `z` | module, number of teeth | mm, 1 |
//!
//! All sets have one scale. A set without a module has that of the first set that has one; without any module
//! all sets have the same. If only `k` of a set is known, its largest central gear is drawn as large as the
//! largest of the others. The picture names these sets. If planets of a set mesh with each other and their
//! sizes are not given, the sizes are those of the [speed diagram](crate::gearbox::speeds).
//!
//! Two central gears that a half-plane shows on one side of their planet, such as two suns, are drawn on both
//! sides of it. The second is mirrored at the planet's axis, of two rings the first. Bevel gears have no
//! radius of this kind and keep any height.

use super::UP_MM;
use super::halves::{Common, Pair, pairs};
use crate::Error;
use crate::gearbox::radii::{Planet, Radii, radii};
use crate::gearbox::words::{decimal, set_name};
use epicyclic_gears::mesh::Gear;
use epicyclic_layout::layout::SetStack;
use epicyclic_layout::{Layout, SetRadii};
use epicyclic_train::Gearbox;
use epicyclic_train::drawn::DrawnSet;
use epicyclic_train::planet_bearings::PlanetBearing;
use epicyclic_train::planet_set::GearOf;
use epicyclic_train::set::SetKind;
use epicyclic_units::Physical;

/// Radius of the smallest planet or step.
const LEAST_WHEEL_MM: f64 = 4.2;
/// The least that lies between axis, contacts and pin of a set, over how far it reaches.
const LEAST_SHARE: f64 = 1.0 / 32.0;

/// A gear on a planet pin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Wheel {
    /// Height of its pin, in units of the layout.
    pub(super) pin: f64,
    /// Radius, in units of the layout.
    pub(super) radius: f64,
}

/// The scale of a layout, and the planets in it.
#[derive(Debug, Clone, PartialEq)]
pub struct Scale {
    /// Planets of each drawn set, or their steps from central gear 1 to 2; none where they are not to scale.
    pub(super) wheels: Vec<Vec<Wheel>>,
    /// Remarks of the picture.
    pub(super) notes: Vec<String>,
    /// Units of the layout to a millimetre of radius, where that is known.
    units_to_mm: Option<f64>,
}

/// A bar as long as a round number of millimetres in a scale.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bar {
    /// Length that the bar represents.
    pub(super) length_mm: f64,
    /// Length of the bar as drawn.
    pub(super) drawn_mm: f64,
}

impl Scale {
    /// The scale bar: 1, 2 or 5 times a power of ten, at most so long as drawn; `None` where no module is
    /// known.
    pub(super) fn bar(&self, most_mm: f64) -> Option<Bar> {
        let drawn = UP_MM * self.units_to_mm?;
        let most = most_mm / drawn;
        let ten = libm::pow(10_f64, libm::log10(most).floor());
        let length_mm =
            [5.0, 2.0, 1.0].map(|times| times * ten).into_iter().find(|length| *length <= most)?;
        Some(Bar { length_mm, drawn_mm: drawn * length_mm })
    }

    /// Magnification of the heights.
    pub(super) fn enlarged(&self) -> Option<f64> {
        self.units_to_mm.map(|units| UP_MM * units)
    }
}

/// Layout with gears at heights in proportion to their pitch radii, and the scale. The planet bearings give
/// the modules of the sets for which they are known.
///
/// ```
/// use epicyclic_layout::{self as layout, Verdict};
/// use epicyclic_pictures::gearbox::scheme::to_scale;
/// use epicyclic_train::{Gearbox, set::{SetKind, SetSpec}};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let gearbox = Gearbox::builder("one set")
///     .links(["sun", "arm"])
///     .set(SetSpec::teeth("P", SetKind::Simple, ["sun", "ground", "arm"], 20, 60)?)
///     .input("sun")
///     .output("arm")
///     .build()?;
/// let Verdict::Drawable(plain) = layout::draw(&gearbox, layout::Options::default()) else {
///     unreachable!("one set can be drawn");
/// };
/// let (layout, _) = to_scale(&gearbox, &plain, &[])?;
/// let set = layout.sets[0];
/// assert!(
///     (set.ring_mesh / set.sun_mesh - 3.0).abs() < 1e-12
///         && (set.planet / set.sun_mesh - 2.0).abs() < 1e-12
/// );
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// [`Error::NotToScale`] if the layout has a set above a larger one, [`Error::NoRadii`] if no set has radii.
pub fn to_scale(
    gearbox: &Gearbox,
    layout: &Layout,
    bearings: &[PlanetBearing],
) -> Result<(Layout, Scale), Error> {
    let drawn = gearbox.drawn_sets();
    let pairs = pairs(gearbox, layout);
    let mut all: Vec<Radii> = drawn.iter().map(|set| radii(gearbox, set)).collect();
    for pair in &pairs {
        tie(gearbox, pair, &mut all);
    }
    let sizes = Sizes::of(gearbox, &all, bearings);
    let mut notes = vec![];
    let (mut radii, mut wheels) = (vec![], vec![]);
    for (place, (set, own)) in drawn.iter().zip(&all).enumerate() {
        let in_pair = pairs.iter().find(|pair| pair.stacks.iter().any(|stack| stack.set == place));
        let (radius, own) = heights(set, own, in_pair, sizes.units[place]);
        radii.push(radius);
        wheels.push(own);
    }
    for pair in &pairs {
        // One planet, whatever the rounding of two halves.
        let [first, second] = pair.stacks.map(|stack| stack.set);
        if let SetRadii::Planets { planet: pin, .. } = radii[first]
            && let SetRadii::Planets { planet, .. } = &mut radii[second]
        {
            *planet = pin;
        }
    }
    if radii.iter().all(|radii| *radii == SetRadii::Free) {
        return Err(Error::NoRadii { gearbox: gearbox.name().into() });
    }
    let ordered: Vec<SetRadii> = layout.sets.iter().map(|stack: &SetStack| radii[stack.set]).collect();
    let smallest = wheels.iter().flatten().map(|wheel| wheel.radius).reduce(f64::min);
    let chosen = |least: f64| {
        let least = smallest.map_or(least, |radius| least.max(LEAST_WHEEL_MM / (UP_MM * radius)));
        if sizes.is_in_mm { round(UP_MM * least) / UP_MM } else { least }
    };
    let (layout, scale) = layout.to_scale(&ordered, chosen).map_err(|in_the_way| {
        let [lower, upper] = in_the_way.sets.map(|set| set_name(gearbox, set));
        Error::NotToScale { lower, upper }
    })?;
    for wheel in wheels.iter_mut().flatten() {
        *wheel = Wheel { pin: scale * wheel.pin, radius: scale * wheel.radius };
    }
    let units_to_mm = sizes.is_in_mm.then_some(scale);
    let mut scale = Scale { wheels, notes: vec![], units_to_mm };
    notes.push(match scale.enlarged() {
        Some(times) => {
            format!("heights of gears and planet axes to scale, {}; widths are not", ratio(times))
        }
        None => "heights of gears and planet axes in proportion to their pitch radii; widths are not".into(),
    });
    notes.extend(sizes.notes);
    notes.extend(remarks(drawn, &all, &pairs, &radii));
    scale.notes = notes;
    Ok((layout, scale))
}

/// The next larger scale that is `n : 1` or `1 : n` with two digits in `n`.
fn round(scale: f64) -> f64 {
    let one = if scale < 1.0 { 1.0 / scale } else { scale };
    let digit = libm::pow(10_f64, libm::log10(one).floor() - 1.0);
    if scale < 1.0 { 1.0 / ((one / digit).floor() * digit) } else { (one / digit).ceil() * digit }
}

/// A scale as drawings have it.
fn ratio(scale: f64) -> String {
    let short = |n: f64| format!("{n:.4}").trim_end_matches('0').trim_end_matches('.').to_owned();
    if scale < 1.0 { format!("1 : {}", short(1.0 / scale)) } else { format!("{} : 1", short(scale)) }
}

/// Gives the halves of one set the pin of their planet in common, and the sizes that follow.
fn tie(gearbox: &Gearbox, pair: &Pair, all: &mut [Radii]) {
    let [first, second] = pair.stacks.map(|stack| stack.set);
    let drawn = gearbox.drawn_sets();
    match pair.common {
        // The long planet lies between the ring and the simple half's sun.
        Common::Long => {
            let ([double, simple], sizes) = (
                [&all[first], &all[second]],
                [first, second].map(|set| drawn[set].basic_ratio(gearbox).abs()),
            );
            let Some(long) = simple.planets.first() else { return };
            let pin = long.pin * sizes[0] / sizes[1];
            let is_short_known = double.planets.first().is_some_and(|short| !short.is_assumed);
            let short = match double.planets.first() {
                Some(short) if is_short_known => *short,
                _ => Planet { letter: "g", pin, contacts: [Some((0, 1.0)), None], is_assumed: true },
            };
            let long = Planet { letter: "f", pin, contacts: [Some((1, sizes[0])), None], is_assumed: false };
            all[first].planets = vec![short, long];
        }
        // The pin of the first half fixes the second by i₀ = (r_g/r_1)·(r_2/r_f) and r_2 = R + r_f.
        Common::Stepped => {
            let Some(pin) = all[first].planets.first().map(|planet| planet.pin) else { return };
            let ratio = drawn[second].basic_ratio(gearbox).abs();
            let step = (pin - 1.0) * pin / (ratio - (pin - 1.0));
            if step > 0.0 {
                let ring = pin + step;
                all[second] = Radii {
                    central_gears: [1.0, ring],
                    planets: vec![Planet {
                        letter: "g",
                        pin,
                        contacts: [Some((0, 1.0)), Some((1, ring))],
                        is_assumed: false,
                    }],
                };
            }
        }
    }
}

/// Known sizes of all sets.
struct Sizes {
    /// Radius of central gear 1 of each drawn set.
    units: Vec<f64>,
    is_in_mm: bool,
    notes: Vec<String>,
}

/// The central gear that all drawn sets of a set have in common: its place in each.
fn root(drawn: &[DrawnSet], set: usize) -> usize {
    let of: Vec<&DrawnSet> = drawn.iter().filter(|other| other.set == set).collect();
    let is_common = |central: usize| of.iter().all(|other| other.members[..2].contains(&central));
    let ends = of.first().map_or([0; 2], |first| [first.members[0], first.members[1]]);
    ends.into_iter().find(|&central| is_common(central)).unwrap_or(ends[0])
}

impl Sizes {
    fn of(gearbox: &Gearbox, all: &[Radii], bearings: &[PlanetBearing]) -> Self {
        let drawn = gearbox.drawn_sets();
        let sets = gearbox.sets().len();
        let radius_in = |place: usize, central: usize| {
            let member = usize::from(drawn[place].members[1] == central);
            all[place].central_gears[member]
        };
        let in_mm = |set: usize| {
            let contacts =
                bearings.iter().filter(|bearing| bearing.set == set).flat_map(|bearing| &bearing.contacts);
            contacts.into_iter().find_map(|contact| {
                let GearOf::Central(central) = contact.with else { return None };
                let radius = contact.pitch_radius?.mm();
                let place = drawn
                    .iter()
                    .position(|other| other.set == set && other.members[..2].contains(&central))?;
                Some(radius * radius_in(place, root(drawn, set)) / radius_in(place, central))
            })
        };
        let in_teeth = |set: usize| {
            let teeth = gearbox.sets()[set].centrals().get(root(drawn, set))?.teeth?;
            Some(Gear::external(teeth.as_f64()).pitch_radius())
        };
        let known: Vec<Option<f64>> = (0..sets).map(in_mm).collect();
        let is_in_mm = known.iter().any(Option::is_some);
        let module = (0..sets).find_map(|set| Some((set, known[set]? / in_teeth(set)?)));
        let mut roots: Vec<Option<f64>> = (0..sets)
            .map(|set| {
                known[set].or_else(|| match (is_in_mm, module) {
                    (true, Some((_, module))) => Some(module * in_teeth(set)?),
                    (true, None) => None,
                    (false, _) => in_teeth(set),
                })
            })
            .collect();
        let largest = |set: usize| {
            let own = (0..drawn.len()).filter(|&place| drawn[place].set == set);
            let over = |place: usize| {
                let [one, other] = all[place].central_gears;
                one.max(other) / radius_in(place, root(drawn, set))
            };
            own.map(over).fold(1.0, f64::max)
        };
        let most = (0..sets).filter_map(|set| Some(roots[set]? * largest(set))).reduce(f64::max);
        // Sets without radii say nothing of theirs.
        let has_radii = |place: usize| drawn[place].kind.is_pair() || !all[place].planets.is_empty();
        let places = |is: &dyn Fn(usize) -> bool| -> Vec<usize> {
            (0..drawn.len()).filter(|&place| has_radii(place) && is(drawn[place].set)).collect()
        };
        let mut notes = vec![];
        let lent = places(&|set| is_in_mm && known[set].is_none() && roots[set].is_some());
        if let (Some((from, module)), false) = (module, lent.is_empty()) {
            let from = places(&|set| set == from);
            notes.push(format!(
                "{}: module not given, that of {}, {} mm",
                named(&lent),
                named(&from),
                decimal(module)
            ));
        }
        let unknown = places(&|set| roots[set].is_none());
        if !unknown.is_empty() && sets > 1 {
            let size = if most.is_some() { "as large as that of the others" } else { "equally large" };
            notes.push(format!("{}: only k given, the largest gear drawn {size}", named(&unknown)));
        }
        if !is_in_mm && most.is_some() && sets - roots.iter().filter(|root| root.is_none()).count() > 1 {
            notes.push("all modules taken as equal".into());
        }
        for (set, root) in roots.iter_mut().enumerate() {
            *root = root.or(Some(most.unwrap_or(1.0) / largest(set)));
        }
        let units = drawn
            .iter()
            .enumerate()
            .map(|(place, set)| roots[set.set].unwrap_or(1.0) / radius_in(place, root(drawn, set.set)));
        Self { units: units.collect(), is_in_mm, notes }
    }
}

/// Heights of a drawn set whose central gear 1 is `unit` large, in the unit of that, and its planets.
fn heights(set: &DrawnSet, radii: &Radii, pair: Option<&Pair>, unit: f64) -> (SetRadii, Vec<Wheel>) {
    if set.kind.is_pair() {
        return (SetRadii::Contact(unit), vec![]);
    }
    let [first, second] = radii.central_gears;
    let wheels: Vec<Wheel> = radii
        .planets
        .iter()
        .flat_map(|planet| {
            let contacts = planet.contacts.iter().flatten();
            contacts.map(|(_, radius)| Wheel {
                pin: unit * planet.pin,
                radius: unit * (radius - planet.pin).abs(),
            })
        })
        .collect();
    let [Some(one), Some(other)] = [wheels.first(), wheels.last()] else { return (SetRadii::Free, vec![]) };
    // Central gear 1 below its planet, central gear 2 above.
    let sun_mesh = if set.kind == SetKind::SteppedRings { one.pin - one.radius } else { unit * first };
    let ring_mesh = match set.kind {
        SetKind::SteppedSuns | SetKind::MeshingSuns => other.pin + other.radius,
        _ => unit * second,
    };
    let planet = match pair {
        Some(pair) if pair.common == Common::Long => other.pin,
        _ => f64::midpoint(one.pin, other.pin),
    };
    let low = wheels.iter().map(|wheel| wheel.pin - wheel.radius).fold(sun_mesh, f64::min);
    let high = wheels.iter().map(|wheel| wheel.pin + wheel.radius).fold(ring_mesh, f64::max);
    // A planet that hardly orbits, as in an eccentric drive, would be invisible beside a ring of that size.
    if low.min(planet - sun_mesh).min(ring_mesh - planet) < LEAST_SHARE * high {
        return (SetRadii::Free, vec![]);
    }
    (SetRadii::Planets { sun_mesh, planet, ring_mesh, reach: [low, high] }, wheels)
}

/// Remarks of the picture on single sets.
fn remarks(drawn: &[DrawnSet], all: &[Radii], pairs: &[Pair], heights: &[SetRadii]) -> Vec<String> {
    let is_in_pair =
        |place: usize| pairs.iter().any(|pair| pair.stacks.iter().any(|stack| stack.set == place));
    let free = |place: usize| heights[place] == SetRadii::Free;
    let of =
        |is: &dyn Fn(usize) -> bool| -> Vec<usize> { (0..drawn.len()).filter(|&place| is(place)).collect() };
    let kind = |place: usize| drawn[place].kind;
    let remarks = [
        (of(&|place| free(place)), "not to scale"),
        (of(&|place| kind(place).is_pair()), "gear 1 of the pair to scale, gear 2 on an axis of its own"),
        (
            of(&|place| {
                !free(place)
                    && matches!(
                        kind(place),
                        SetKind::SteppedSuns | SetKind::SteppedRings | SetKind::MeshingSuns
                    )
            }),
            "a gear that would lie inside its planet is drawn on the planet's far side",
        ),
        (
            of(&|place| !free(place) && matches!(kind(place), SetKind::DoublePlanet | SetKind::MeshingSuns)),
            "planets in mesh with each other, drawn beside each other",
        ),
        (
            of(&|place| {
                !free(place)
                    && all[place].planets.iter().any(|planet| planet.is_assumed)
                    && (!is_in_pair(place) || kind(place) == SetKind::DoublePlanet)
            }),
            "sizes of planets assumed",
        ),
    ];
    let said = remarks.into_iter().filter(|(sets, _)| !sets.is_empty());
    said.map(|(sets, words)| format!("{}: {words}", named(&sets))).collect()
}

fn named(sets: &[usize]) -> String {
    let numbers: Vec<String> = sets.iter().map(|set| (set + 1).to_string()).collect();
    format!("{} {}", if sets.len() == 1 { "set" } else { "sets" }, numbers.join(", "))
}

#[cfg(test)]
mod tests {
    use super::{ratio, round};

    #[test]
    fn scales_are_round_and_no_smaller() {
        for (scale, rounded, words) in [
            (0.166, 1.0 / 6.0, "1 : 6"),
            (0.95, 1.0, "1 : 1"),
            (1.02, 1.1, "1.1 : 1"),
            (0.011, 1.0 / 90.0, "1 : 90"),
        ] {
            let found = round(scale);
            assert!((found - rounded).abs() < 1e-12 && found >= scale, "{scale}: {found}");
            assert_eq!(ratio(found), words);
        }
    }
}
