//! Calculations of involute gears with profile shift: one pair, and the least teeth of pairs.

use super::{Calculation, Refusal, Results};
use epicyclic_gears::ToothCount;
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::sliding::loss_factor;
use epicyclic_gears::involute::{InvoluteGear, Pair, Profile};
use epicyclic_gears::rack::BasicRack;
use epicyclic_units::{Number, Physical, Quantity};
use schemars::JsonSchema;
use serde::Deserialize;
use uom::si::f64::{Angle, Length};

pub(super) fn calculations() -> Vec<Calculation> {
    vec![
        Calculation::new(
            "gears.involute_pair",
            "circles, measures, path of contact and sliding of two gears with profile shift",
            involute_pair,
        ),
        Calculation::new(
            "gears.least_teeth",
            "least rings that a cutter of given teeth leaves whole, and least pinions in given rings",
            least_teeth,
        ),
    ]
}

/// A gear of a pair.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct ToothedGiven {
    /// Number of teeth.
    pub(super) teeth: u32,
    /// Profile shift coefficient; of a ring positive where its tips lie further inwards (ISO 21771). One of
    /// the two shifts may be left out where the centre distance is given: then the pair has no backlash.
    #[serde(default)]
    shift: Option<Number>,
    /// Tip alteration, below 0 of a shortened tooth. Default 0.
    #[serde(default)]
    tip_alteration: Option<Quantity<Length>>,
    /// Radius at the root of the basic rack, in modules. Default 0.38.
    #[serde(default)]
    fillet: Option<Number>,
}

/// Two gears in mesh.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct PairGiven {
    /// Normal module.
    pub(super) module: Quantity<Length>,
    /// Normal pressure angle. Default 20°.
    #[serde(default)]
    pressure_angle: Option<Quantity<Angle>>,
    /// Helix angle. Default 0.
    #[serde(default)]
    helix_angle: Option<Quantity<Angle>>,
    /// Whether the second gear is a ring. Default: it is not.
    #[serde(default)]
    internal: bool,
    /// The two gears; of an internal pair the ring is the second.
    pub(super) gears: [ToothedGiven; 2],
    /// Centre distance. Default: that without backlash.
    #[serde(default)]
    centre_distance: Option<Quantity<Length>>,
    /// Whether the tips of both gears are shortened so that the tip clearance is that of the rack, in place
    /// of `tip_alteration`. Default: they are not.
    #[serde(default)]
    shortened_tips: bool,
}

impl PairGiven {
    /// The pair, its lengths in modules.
    pub(super) fn pair(&self) -> Result<Pair, Refusal> {
        let gears = self.gears.each_ref().map(|gear| gear.shift);
        let made = |place: usize, shift: f64| {
            let given = &self.gears[place];
            let kind = if self.internal && place == 1 { GearKind::Internal } else { GearKind::External };
            let rack = self.pressure_angle.map_or_else(BasicRack::default, |angle| BasicRack {
                pressure_angle: angle.0,
                ..BasicRack::default()
            });
            let usual = Profile { rack, ..Profile::default() };
            let profile = Profile {
                fillet: given.fillet.map_or(usual.fillet, Number::get),
                helix_angle: self.helix_angle.map_or(usual.helix_angle, |angle| angle.0),
                ..usual
            };
            let alteration = given.tip_alteration.map_or(0.0, |length| (length.0 / self.module.0).value);
            let gear = InvoluteGear::new(kind, ToothCount::new(given.teeth)?, profile, shift)?;
            gear.with_tip_alteration(alteration)
        };
        let distance = self.centre_distance.map(|length| (length.0 / self.module.0).value);
        let number = |shift: Option<Number>| shift.map_or(0.0, Number::get);
        let [mut first, mut second] = [made(0, number(gears[0]))?, made(1, number(gears[1]))?];
        let pair = match (distance, gears) {
            (Some(distance), [Some(_), Some(_)]) => Pair::at_centre_distance(first, second, distance)?,
            (Some(distance), [Some(shift), None]) => {
                second = second.with_shift(Pair::shift_sum(&first, &second, distance)? - shift.get())?;
                Pair::at_centre_distance(first, second, distance)?
            }
            (Some(distance), [None, Some(shift)]) => {
                first = first.with_shift(Pair::shift_sum(&first, &second, distance)? - shift.get())?;
                Pair::at_centre_distance(first, second, distance)?
            }
            (None, [Some(_), Some(_)]) => Pair::without_backlash(first, second)?,
            _ => {
                let message = "give the shifts of both gears, or one of them and centre_distance";
                return Err(Refusal { name: "shift-missing".into(), message: message.into() });
            }
        };
        if self.shortened_tips {
            let alteration = pair.tip_alteration();
            return Ok(pair.with_tip_alterations([alteration; 2])?);
        }
        Ok(pair)
    }
}

/// Measurements on a gear.
#[derive(Debug, Clone, Copy, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct MeasuredGiven {
    /// Teeth, of a ring spaces, over which the span is measured. Default: those by which it touches the
    /// middle of the flanks.
    #[serde(default)]
    spanned_teeth: Option<u32>,
    /// Diameter of the balls. Default: that by which they touch the middle of the flanks.
    #[serde(default)]
    ball: Option<Quantity<Length>>,
}

/// Two gears with their measurements.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct InvolutePairGiven {
    /// The gears in mesh.
    pair: PairGiven,
    /// Measurements on the first and on the second gear.
    #[serde(default)]
    measured: [MeasuredGiven; 2],
}

fn involute_pair(given: &InvolutePairGiven) -> Result<Results, Refusal> {
    let pair = given.pair.pair()?;
    let module = given.pair.module.0;
    let [first, second] = pair.gears();
    let [from, to] = pair.contact();
    let pitch_point = pair.working_diameters()[0] / 2.0 * libm::sin(pair.working_angle_rad());
    let mut results = Results::default();
    results
        .quantity("working_angle", Angle::from_si(pair.working_angle_rad()))
        .quantity("centre_distance", module * pair.centre_distance())
        .quantity("reference_centre_distance", module * pair.reference_centre_distance())
        .number("shift_sum", Pair::shift_sum(first, second, pair.centre_distance())?)
        .quantity("tip_alteration", module * pair.tip_alteration())
        .quantity("backlash", module * pair.backlash())
        .number("contact_ratio", pair.transverse_contact_ratio())
        // From A, where the contact begins, to B, C, D and E.
        .quantity("path.ab", module * (to - pair.base_pitch() - from))
        .quantity("path.ac", module * (pitch_point - from))
        .quantity("path.ad", module * pair.base_pitch())
        .quantity("path.ae", module * (to - from))
        .number("loss_factor", loss_factor(&pair)?);
    let (sliding, clearances) = (pair.specific_sliding(), pair.tip_clearances());
    for (place, (name, gear)) in [("first", first), ("second", second)].into_iter().enumerate() {
        let measured = given.measured[place];
        let teeth = measured.spanned_teeth.unwrap_or_else(|| gear.spanned_teeth());
        let ball = measured.ball.map_or_else(|| gear.ball_diameter(), |ball| (ball.0 / module).value);
        results
            .number(format!("{name}.shift"), gear.shift())
            .quantity(format!("{name}.reference_diameter"), module * gear.reference_diameter())
            .quantity(format!("{name}.base_diameter"), module * gear.base_diameter())
            .quantity(format!("{name}.tip_diameter"), module * gear.tip_diameter())
            .quantity(format!("{name}.root_diameter"), module * gear.root_diameter())
            .quantity(format!("{name}.form_diameter"), module * gear.form_diameter())
            .quantity(format!("{name}.working_diameter"), module * pair.working_diameters()[place])
            .quantity(format!("{name}.tip_thickness"), module * gear.tip_thickness())
            .quantity(format!("{name}.tip_clearance"), module * clearances[place])
            .number(format!("{name}.sliding_at_tip"), sliding[place][0])
            .number(format!("{name}.sliding_at_root"), sliding[place][1])
            .count(format!("{name}.spanned_teeth"), teeth)
            .quantity(format!("{name}.span"), module * gear.span(teeth));
        if let Some(over) = gear.over_balls(ball) {
            results.quantity(format!("{name}.over_balls"), module * over);
        }
    }
    if let Some(interference) = pair.interference() {
        results
            .answer("involute_is_met_above_its_base", interference.base >= 0.0)
            .answer("turns", interference.is_free())
            .answer("goes_together_radially", interference.can_be_put_together_radially());
    }
    Ok(results)
}

/// Rings and cutters without profile shift.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct LeastTeethGiven {
    /// Teeth of the rings whose least pinion is wanted.
    #[serde(default)]
    rings: Vec<u32>,
    /// Teeth of the cutters whose least ring is wanted.
    #[serde(default)]
    cutters: Vec<u32>,
    /// Addendum of the cutters, in modules. Default 1.25.
    #[serde(default)]
    cutter_addendum: Option<Number>,
}

/// Teeth that a ring has beyond its cutter where the search begins: far more than the least ring.
const MOST_BEYOND: u32 = 200;

fn least_teeth(given: &LeastTeethGiven) -> Result<Results, Refusal> {
    let gear = |kind, teeth: u32| -> Result<InvoluteGear, Refusal> {
        Ok(InvoluteGear::new(kind, ToothCount::new(teeth)?, Profile::default(), 0.0)?)
    };
    let addendum = given.cutter_addendum.map_or(1.25, Number::get);
    let mut results = Results::default();
    for &teeth in &given.rings {
        let ring = gear(GearKind::Internal, teeth)?;
        let mut least = None;
        // A small pinion interferes: the search goes down from the largest, and ends at the first that does.
        for pinion in (2..teeth).rev() {
            let pair = Pair::without_backlash(gear(GearKind::External, pinion)?, ring);
            match pair.ok().and_then(|pair| pair.interference()) {
                Some(interference) if interference.base >= 0.0 => least = Some(pinion),
                _ => break,
            }
        }
        if let Some(least) = least {
            results.count(format!("pinion_in.{teeth}"), least);
        }
    }
    for &teeth in &given.cutters {
        let cutter = gear(GearKind::External, teeth)?.with_tip_alteration(addendum - 1.0)?;
        let mut least = None;
        // Down from large rings, too: tips of almost as many teeth as the cutter's miss each other again.
        for ring in (teeth + 1..=teeth.saturating_add(MOST_BEYOND)).rev() {
            let pair = Pair::without_backlash(cutter, gear(GearKind::Internal, ring)?);
            match pair.ok().and_then(|pair| pair.interference()) {
                Some(interference) if interference.trimming >= 0.0 => least = Some(ring),
                _ => break,
            }
        }
        if let Some(least) = least {
            results.count(format!("ring_by.{teeth}"), least);
        }
    }
    Ok(results)
}
