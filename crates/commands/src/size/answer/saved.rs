//! Gearbox file with the sizes found for it.

use super::Size;
use super::records::{SizedBearing, SizedDesign, SizedFamily, SizedGear, SizedSet, SizedTeeth};
use crate::error::Error;
use crate::shared::tool::ToolKind;
use epicyclic_formats::Document;
use epicyclic_formats::yaml::{Mapping, Value, to_string};
use epicyclic_units::format::trimmed;

/// Millimetres in a metre.
const MM: f64 = 1e3;

/// Name of `K_Hβ` in the usual basis.
const FACE_LOAD: &str = "K_H_beta";

/// Significant digits of a length; more would show only the rounding of binary fractions.
const DIGITS: usize = 14;

/// Gearbox file without its comments, with the best design of each set.
///
/// # Errors
/// [`Error::NoSize`] for a set without one; [`Error::Json`] for a file that cannot be written.
pub fn saved(document: &Document, size: &Size) -> Result<String, Error> {
    if let Some(set) = size.sets.iter().find(|set| set.found.is_empty()) {
        return Err(Error::NoSize { set: set.set.clone() });
    }
    let mut comment =
        format!("# {}: the best sizes of {} designs.\n", size.gearbox.escape_default(), size.designs);
    for (set, best) in best(&size.sets) {
        let mut last = None;
        for planet in &best.planet_sizes {
            let name = planet.bearing.as_ref().and_then(|bearing| bearing.designation.as_ref());
            if let Some(name) = name.filter(|name| last.replace(*name) != Some(name)) {
                comment +=
                    &format!("# Set {}: bearing {}.\n", set.set.escape_default(), name.escape_default());
            }
        }
    }
    Ok(comment + &written(document, &size.sets)?)
}

/// Sets that have designs, with their best ones.
fn best(sets: &[SizedSet]) -> impl Iterator<Item = (&SizedSet, &SizedDesign)> {
    sets.iter().filter_map(|set| Some((set, set.found.first()?)))
}

/// Gearbox file with the best design of each set that has one.
pub(super) fn written(document: &Document, sets: &[SizedSet]) -> Result<String, Error> {
    let mut file = document.value().clone();
    for (set, best) in best(sets) {
        for list in ["sets", "compound_sets"] {
            let entries = file.get_mut(list).and_then(Value::as_sequence_mut).into_iter().flatten();
            let own = |entry: &&mut Value| entry.get("id").and_then(Value::as_str) == Some(set.set.as_str());
            if let Some(entry) = entries.into_iter().find(own).and_then(Value::as_mapping_mut) {
                write(entry, list == "sets", best);
            }
        }
    }
    to_string(&file).map_err(|error| Error::Json(error.to_string()))
}

fn millimetres(metres: f64) -> Value {
    Value::from(format!("{} mm", trimmed(metres * MM, DIGITS)))
}

/// Values of gears: a list of a set with two central gears, by name of others.
fn of_gears(design: &SizedDesign, is_short: bool, of: impl Fn(&SizedTeeth) -> Value) -> Value {
    if is_short {
        return Value::from(design.gears.iter().map(of).collect::<Vec<_>>());
    }
    let named = design.gears.iter().map(|gear| (Value::from(gear.key.as_str()), of(gear)));
    Value::Mapping(named.collect())
}

fn write(entry: &mut Mapping, is_short: bool, design: &SizedDesign) {
    let family = |key: &str| {
        let gear = design.gears.iter().find(|gear| gear.key == key)?;
        design.families.iter().find(|family| family.toothed_gears.contains(&gear.toothed_gear))
    };
    let mut keys = vec![
        ("profile_shifts", of_gears(design, is_short, |gear| Value::from(gear.profile_shift))),
        ("tip_alterations", of_gears(design, is_short, |gear| Value::from(gear.tip_alteration))),
    ];
    if let ([_, planet, _], [_], true) = (&design.gears[..], &design.planet_sizes[..], is_short) {
        keys.push(("planet_teeth", Value::from(vec![Value::from(planet.teeth)])));
    }
    if !design.planet_sizes.is_empty() {
        keys.push(("planets", Value::from(design.planets)));
    }
    match &design.families[..] {
        [only] => keys.push(("module", millimetres(only.module_m))),
        several if is_short => {
            entry.remove("module");
            let modules = several.iter().map(|family| millimetres(family.module_m));
            keys.push(("modules", Value::from(modules.collect::<Vec<_>>())));
        }
        _ => {
            entry.remove("module");
            let meshes = entry.get_mut("meshes").and_then(Value::as_sequence_mut).into_iter().flatten();
            for mesh in meshes {
                let gear = mesh.get("gears").and_then(|gears| gears.get(0)).and_then(Value::as_str);
                let module = gear.and_then(family).map(|family| millimetres(family.module_m));
                if let Some((mesh, module)) = mesh.as_mapping_mut().zip(module) {
                    mesh.insert(Value::from("module"), module);
                }
            }
        }
    }
    entry.remove("face_width");
    entry.remove("face_widths");
    let first = design.gears.first().map_or(0.0, |gear| gear.face_width_m);
    keys.push(match design.gears.iter().all(|gear| gear.face_width_m == first) {
        true => ("face_width", millimetres(first)),
        false => ("face_widths", of_gears(design, is_short, |gear| millimetres(gear.face_width_m))),
    });
    for (key, value) in keys {
        entry.insert(Value::from(key), value);
    }
    for planet in &design.planet_sizes {
        let Some(bearing) = &planet.bearing else { continue };
        let SizedBearing { rolling, outside_diameter_m, load_rating_n, .. } = bearing;
        let mut keys: Vec<(&str, Value)> =
            vec![("load_rating", Value::from(format!("{} N", trimmed(*load_rating_n, DIGITS))))];
        let bore = if is_short { "planet_bore" } else { "bore" };
        keys.extend(outside_diameter_m.map(|outside| (bore, millimetres(outside))));
        let of = if is_short { &mut *entry } else { inner(inner(entry, "planet_sizes"), &planet.key) };
        // Other data of a bearing that the search chose are not those of one that the file had in mind.
        if bearing.designation.is_some() {
            ["static_load_rating", "fatigue_limit", "bearing_diameter"].iter().for_each(|key| {
                of.remove(*key);
            });
            keys.push(("bearing_rolling", Value::from(*rolling)));
            keys.extend(bearing.span_m.map(|span| ("bearing_span", millimetres(span))));
            let newtons = |rating: f64| Value::from(format!("{} N", trimmed(rating, DIGITS)));
            keys.extend(bearing.static_load_rating_n.map(|rating| ("static_load_rating", newtons(rating))));
            let diameters = bearing.bore_m.zip(*outside_diameter_m);
            keys.extend(
                diameters.map(|(bore, outside)| ("bearing_diameter", millimetres(bore.midpoint(outside)))),
            );
        }
        for (key, value) in keys {
            of.insert(Value::from(key), value);
        }
    }
    if let Some(strength) = entry.get_mut("strength").and_then(Value::as_mapping_mut) {
        write_face_loads(strength, design);
        let is_simple = is_short && design.gears.len() == 3 && design.planet_sizes.len() == 1;
        for (gear, rim) in design.gears.iter().filter_map(|gear| Some((gear, gear.rim_m?))) {
            let of = if is_simple { &mut *strength } else { inner(strength, "rims") };
            let key = if is_simple { format!("{}_rim", gear.key) } else { gear.key.clone() };
            of.insert(Value::from(key), millimetres(rim));
        }
    }
    for gear in &design.gears {
        write_tool(entry, gear);
    }
}

/// Writes `K_Hβ` by the face widths: the greatest of all meshes, and where it differs that of each mesh.
fn write_face_loads(strength: &mut Mapping, design: &SizedDesign) {
    let factors = || design.families.iter().filter_map(|family| family.face_load_factor);
    let Some(greatest) = factors().reduce(f64::max) else { return };
    inner(strength, "factors").insert(Value::from(FACE_LOAD), Value::from(greatest));
    if factors().all(|factor| factor == greatest) {
        return;
    }
    // Both gears of a mesh that the duty loads stand beside each other.
    for mesh in design.over_duty.chunks_exact(2) {
        let key = |of: &SizedGear| {
            let gear = design.gears.iter().find(|gear| gear.toothed_gear == of.toothed_gear)?;
            Some(gear.key.as_str())
        };
        let of_mesh = |family: &&SizedFamily| family.toothed_gears.contains(&mesh[0].toothed_gear);
        let factor = design.families.iter().find(of_mesh).and_then(|family| family.face_load_factor);
        if let (Some(first), Some(second), Some(factor)) = (key(&mesh[0]), key(&mesh[1]), factor) {
            let own = inner(inner(strength, "mesh_factors"), &format!("{first}-{second}"));
            own.insert(Value::from(FACE_LOAD), Value::from(factor));
        }
    }
}

/// Mapping below a key; adds an empty one if the key is missing.
fn inner<'m>(map: &'m mut Mapping, key: &str) -> &'m mut Mapping {
    let value = map.entry(Value::from(key)).or_insert_with(|| Value::Mapping(Mapping::new()));
    if !value.is_mapping() {
        *value = Value::Mapping(Mapping::new());
    }
    match value {
        Value::Mapping(map) => map,
        _ => unreachable!("a mapping was put here"),
    }
}

/// Writes the tool of a gear as the search used it, so that the teeth remain those of the design.
fn write_tool(entry: &mut Mapping, gear: &SizedTeeth) {
    let tool = &gear.tool;
    let has_tools = entry.get("tools").and_then(|tools| tools.get(gear.key.as_str())).is_some();
    let of_strength = entry.get_mut("strength").and_then(|strength| strength.get_mut("shaper"));
    let of_strength = of_strength.and_then(Value::as_mapping_mut).filter(|_| gear.is_internal && !has_tools);
    if let Some(shaper) = of_strength {
        if let Some(addendum) = tool.shaper_addendum_in_modules {
            shaper.insert(Value::from("addendum"), Value::from(addendum));
        }
        return;
    }
    let mut set = |key: &str, value: Value| {
        inner(inner(entry, "tools"), &gear.key).insert(Value::from(key), value);
    };
    match tool.kind {
        ToolKind::Rack => {}
        ToolKind::Form => set("form_fillet", Value::from(tool.corner_radius_in_modules)),
        ToolKind::Shaper => {
            let mut shaper = Mapping::new();
            let numbers = [
                ("shift", tool.shaper_shift),
                ("addendum", tool.shaper_addendum_in_modules),
                ("tip_radius", Some(tool.corner_radius_in_modules)),
            ];
            shaper.extend(tool.shaper_teeth.map(|teeth| (Value::from("teeth"), Value::from(teeth))));
            for (key, value) in numbers {
                shaper.extend(value.map(|value| (Value::from(key), Value::from(value))));
            }
            set("shaper", Value::Mapping(shaper));
        }
    }
}
