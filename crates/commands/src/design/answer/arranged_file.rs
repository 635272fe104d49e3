//! The gearbox file of one stage with planets of two gears.

use super::making::{Load, MAKING, mapping, with_duty};
use super::stage_kind::StageKind;
use super::stages_wanted::WantedStages;
use crate::error::Error;
use crate::shared::gearbox::{Choice, one};
use crate::strength::answer::missing::{MissingKeys, Purpose};
use epicyclic_formats::Document;
use epicyclic_formats::yaml::{Value, to_string};
use uom::si::f64::Torque;

/// Name of the only gear.
pub(super) const GEAR: &str = "only";

/// The gearbox in the making with materials, factors and duty, and this torque on the input.
pub(super) fn making(wanted: &WantedStages, teeth: &[u32], torque: Torque) -> Result<Document, Error> {
    let making = text(wanted, teeth, torque)?;
    let document = Document::parse_one(MAKING, making.as_bytes())?;
    let subject = one(&document, &Choice::default())?;
    let missing = MissingKeys::of(&subject, &document.read()?, &wanted.basis, Purpose::Sizes)?;
    let completed = missing.assumed(&wanted.basis)?;
    Ok(completed.map_or(document, |(gearbox, _)| gearbox.document))
}

/// File of a set without sizes and strength, with a torque on the input.
pub(super) fn text(wanted: &WantedStages, teeth: &[u32], torque: Torque) -> Result<String, Error> {
    let [fast, slow] = if wanted.steps_up { ["output", "input"] } else { ["input", "output"] };
    let number = |place: usize| Value::from(teeth[place]);
    let gears = |of: [&str; 2]| Value::Sequence(of.map(Value::from).to_vec());
    let mesh = |of: [&str; 2], efficiency: f64| {
        mapping(vec![("gears", gears(of)), ("efficiency", efficiency.into())])
    };
    let [outer, inner] = wanted.efficiencies_of_meshes();
    let of_sun = mesh([fast, "planet.1"], outer);
    let is_wolfrom = StageKind::of(teeth) == StageKind::Wolfrom;
    let (carrier, rings, steps, meshes) = if is_wolfrom {
        (
            "carrier",
            mapping(vec![("ground", number(2)), (slow, number(4))]),
            [1, 3],
            vec![of_sun, mesh(["planet.1", "ground"], inner), mesh(["planet.2", slow], inner)],
        )
    } else {
        let [carrier, ring] = if wanted.turns_back { ["ground", slow] } else { [slow, "ground"] };
        let rings = mapping(vec![(ring, number(3))]);
        (carrier, rings, [1, 2], vec![of_sun, mesh(["planet.2", ring], inner)])
    };
    let steps = Value::Sequence(steps.map(number).to_vec());
    let set = mapping(vec![
        ("id", "stage 1".into()),
        ("carrier", carrier.into()),
        ("suns", mapping(vec![(fast, number(0))])),
        ("rings", rings),
        ("planet_gears", mapping(vec![("planet", steps)])),
        ("meshes", Value::Sequence(meshes)),
    ]);
    let name = if is_wolfrom { "Wolfrom set" } else { "set with stepped planets" };
    let sets = ("compound_sets", Value::Sequence(vec![set]));
    let load = Load { torque, speed: wanted.speed, overload: wanted.overload, spectrum: &wanted.spectrum };
    written(name, sets, |file| with_duty(file, &wanted.basis, &[(GEAR, 1.0)], load))
}

/// File of a gearbox with one gear and these sets, and what is added to it.
pub(super) fn written(
    name: &str,
    sets: (&str, Value),
    add: impl FnOnce(&mut Value),
) -> Result<String, Error> {
    let mut file = mapping(vec![
        ("gearbox", name.into()),
        ("input", "input".into()),
        ("output", "output".into()),
        sets,
        ("gears", Value::Sequence(vec![mapping(vec![("name", GEAR.into())])])),
    ]);
    add(&mut file);
    to_string(&file).map_err(|error| Error::Json(error.to_string()))
}
