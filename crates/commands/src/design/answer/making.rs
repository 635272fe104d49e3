//! The gearbox file in the making: its duty, and the data for the strength of its sets.

use crate::analyze::answer::pins;
use crate::answer::Warning;
use crate::error::Error;
use crate::shared::basis::Basis;
use crate::shared::bearing_type::BearingType;
use crate::shared::gearbox::{Choice, one};
use crate::size::answer::Size;
use crate::size::answer::records::SizedDesign;
use crate::size::options::Request as SizeRequest;
use crate::strength::answer::duty::steps;
use epicyclic_formats::Document;
use epicyclic_formats::gearbox::GearboxFile;
use epicyclic_formats::yaml::{Mapping, Value};
use epicyclic_strength::sizing::Requirement;
use epicyclic_units::Physical;
use epicyclic_units::format::trimmed;
use uom::si::f64::{AngularVelocity, Torque};

/// Name of the unfinished gearbox in error messages.
pub(super) const MAKING: &str = "the gearbox in the making";

/// Significant digits of torque and speed in the file.
const DIGITS: usize = 12;

/// Load of the input in every gear.
#[derive(Debug, Clone, Copy)]
pub(super) struct Load<'a> {
    pub(super) torque: Torque,
    pub(super) speed: AngularVelocity,
    /// Greatest torque during the life over the nominal torque.
    pub(super) overload: Option<f64>,
    /// Steps in each gear: share of its time, torque and speed over these.
    pub(super) spectrum: &'a [[f64; 3]],
}

/// Writes the basis into every set, which is a simple one or a pair, and the duty into the file.
pub(super) fn with_load(file: &mut Value, basis: &Basis, gears: &[(&str, f64)], load: Load<'_>) {
    let of_pair = basis.strength_of_pair();
    for_each_set(file, |set| {
        let strength = if is_pair(set) { &of_pair } else { &basis.strength };
        set.insert("strength".into(), strength.clone());
    });
    with_duty(file, basis, gears, load);
}

/// Kind of a set that is a pair of external gears on fixed axes.
pub(super) const PAIR: &str = "external_pair";

/// Whether a set is such a pair.
fn is_pair(set: &Mapping) -> bool {
    set.get("kind").and_then(Value::as_str) == Some(PAIR)
}

/// Gears with their shares of the time, equal ones unless shares are given.
///
/// # Errors
/// [`Error::Shares`] unless there is one share per gear.
pub(super) fn shared<'g>(gears: Vec<&'g str>, shares: &[f64]) -> Result<Vec<(&'g str, f64)>, Error> {
    if !shares.is_empty() && shares.len() != gears.len() {
        let gears = gears.into_iter().map(str::to_owned).collect();
        return Err(Error::Shares { given: shares.len(), gears });
    }
    let equal = 1.0 / gears.len() as f64;
    let share = |place: usize| shares.get(place).copied().unwrap_or(equal);
    Ok(gears.into_iter().enumerate().map(|(place, gear)| (gear, share(place))).collect())
}

/// Mapping of these keys in their order.
pub(super) fn mapping(keys: Vec<(&str, Value)>) -> Value {
    Value::Mapping(keys.into_iter().map(|(key, value)| (Value::from(key), value)).collect::<Mapping>())
}

/// Changes the entries of all sets that are not compound.
pub(super) fn for_each_set(file: &mut Value, change: impl FnMut(&mut Mapping)) {
    for_each_of("sets", file, change);
}

/// Changes the entries of a list.
fn for_each_of(key: &str, file: &mut Value, change: impl FnMut(&mut Mapping)) {
    let sets = file.get_mut(key).and_then(Value::as_sequence_mut).into_iter().flatten();
    sets.filter_map(Value::as_mapping_mut).for_each(change);
}

/// Writes helix angle and tools into the sets and the duty into the file: its gears with their shares of the
/// time.
pub(super) fn with_duty(file: &mut Value, basis: &Basis, gears: &[(&str, f64)], load: Load<'_>) {
    if let (Some(tools), Some(of_pair)) = (&basis.tools, basis.tools_of_pair()) {
        for_each_set(file, |set| {
            let tools = if is_pair(set) { &of_pair } else { tools };
            set.insert("tools".into(), tools.clone());
        });
    }
    if let Some(angle) = basis.helix_angle.filter(|angle| angle.0.si() != 0.0) {
        for key in ["sets", "compound_sets"] {
            for_each_of(key, file, |set| {
                set.insert("helix_angle".into(), format!("{angle:.DIGITS$}").into());
            });
        }
    }
    // More digits would show only the rounding of the unit conversion.
    let written = |value: f64, unit: &str| Value::from(format!("{} {unit}", trimmed(value, DIGITS)));
    let greatest = load.overload.map(|factor| written(factor * load.torque.si(), "N·m"));
    let step = |(gear, share): &(&str, f64), [part, torque, speed]: &[f64; 3]| {
        mapping(vec![
            ("gear", Value::from(*gear)),
            ("share", Value::from(share * part)),
            ("torque", written(torque * load.torque.si(), "N·m")),
            ("speed", written(speed * load.speed.rpm(), "rpm")),
        ])
    };
    let steps = |gear| load.spectrum.iter().map(move |of| step(gear, of));
    let duty: Vec<Value> = gears.iter().flat_map(steps).collect();
    let against = |torque: &Value| {
        let overload =
            |(gear, _): &(&str, f64)| mapping(vec![("gear", Value::from(*gear)), ("torque", torque.clone())]);
        gears.iter().map(overload).collect()
    };
    if let Some(file) = file.as_mapping_mut() {
        for (key, value) in &basis.keys {
            file.insert(key.as_str().into(), value.clone());
        }
        file.insert("duty".into(), Value::Sequence(duty));
        if let Some(torque) = &greatest {
            file.insert("overload".into(), Value::Sequence(against(torque)));
        }
    }
}

/// Bearings decide the size of a set where the reserve of torque of its teeth is so many times theirs.
const SPARE: f64 = 1.5;

/// Name of the remark that bearings decide a size.
pub(super) const BEARINGS_DECIDE: &str = "bearings-decide";

/// A remark where flanks and roots of sets have much to spare and their bearings, of those that may be chosen,
/// have not; `None` where planets may have a full complement of rollers or needles in their bore.
fn bearings_decide(size: &Size, file: &GearboxFile, request: &SizeRequest) -> Option<Warning> {
    let is_bought = |kind: &BearingType| matches!(kind, BearingType::Balls | BearingType::Rollers);
    let has_more = |kind: &BearingType| {
        is_bought(kind) || matches!(kind, BearingType::RollersInBore | BearingType::Plain)
    };
    let kinds = request.bearing_kinds();
    if request.bearings.is_some() || !kinds.iter().all(has_more) {
        return None;
    }
    let has = |kind| kinds.contains(&kind);
    let more = match has(BearingType::RollersInBore) && !has(BearingType::Plain) {
        true => "full-complement,plain",
        false => "rollers-in-bore,full-complement,plain",
    };
    let required = file.required.as_ref()?;
    let is_decided = |design: &SizedDesign| {
        let teeth = design.over_duty.iter().map(|of| {
            let flank = Requirement::Flank.reserve(of.flank.safety, required.flank.get());
            flank.min(Requirement::Root.reserve(of.root.safety, required.root.get()))
        });
        let spare = teeth.fold(f64::INFINITY, f64::min);
        design.governing.requirement == Requirement::BearingLife && spare > SPARE * design.governing.reserve()
    };
    let sets = size.sets.iter().filter(|set| set.found.first().is_some_and(is_decided));
    let sets: Vec<&str> = sets.map(|set| set.set.as_str()).collect();
    (!sets.is_empty()).then(|| Warning {
        name: BEARINGS_DECIDE,
        message: format!(
            "the bearings decide the size of {}, whose teeth have much to spare: --bearing-type rollers,{more}, or larger \
             bearings of --bearings, may make it smaller",
            sets.join(", ")
        ),
    })
}

/// Warnings about the sizes, with one of the speeds of all planets in place of one for each.
pub(super) fn warnings(
    size: &Size,
    file: Option<&str>,
    request: &SizeRequest,
) -> Result<Vec<Warning>, Error> {
    let mut warnings = size.warnings.clone();
    let Some(file) = file else { return Ok(warnings) };
    let document = Document::parse_one(MAKING, file.as_bytes())?;
    let gearbox: GearboxFile = document.read()?;
    warnings.extend(bearings_decide(size, &gearbox, request));
    let subject = one(&document, &Choice::default())?;
    let steps = steps(&subject, &gearbox.duty)?;
    let fastest: Vec<_> = steps.iter().filter_map(|step| step.turning(&subject)).collect();
    let loaded: Vec<_> = steps.iter().filter_map(|step| step.1.as_ref()).collect();
    if let Some(warning) = pins::warning(&subject, &loaded, &fastest.iter().collect::<Vec<_>>()) {
        warnings.retain(|one| pins::OF_PINS.iter().all(|rule| rule.name() != one.name));
        warnings.push(warning);
    }
    Ok(warnings)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shared::application::FULL_LOAD;
    use epicyclic_units::Quantity;
    use uom::si::f64::Angle;

    /// Sets that share planets are in a list of their own.
    #[test]
    fn sets_of_both_lists_get_the_helix_angle() {
        let text = "sets: [{ id: a }, { id: b }]\ncompound_sets: [{ id: c }]\n";
        let load = Load {
            torque: Torque::from_si(1.0),
            speed: AngularVelocity::from_si(1.0),
            overload: None,
            spectrum: &FULL_LOAD,
        };
        for (degrees, written) in [(None, None), (Some(0.0), None), (Some(-12.5), Some("-12.5 deg"))] {
            let mut file = Document::parse_one(MAKING, text.as_bytes()).unwrap().value().clone();
            let helix_angle = degrees.map(|degrees| Quantity(Angle::from_degrees(degrees)));
            with_duty(&mut file, &Basis { helix_angle, ..Basis::default() }, &[("1", 1.0)], load);
            for (list, place) in [("sets", 0), ("sets", 1), ("compound_sets", 0)] {
                let own = file[list][place].get("helix_angle").and_then(Value::as_str);
                assert_eq!(own, written, "{list} {place}");
            }
        }
    }
}
