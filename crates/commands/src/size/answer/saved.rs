//! Gearbox file with the sizes found for it.

use super::Size;
use super::records::{SizedBearing, SizedDesign, SizedSet};
use crate::error::Error;
use crate::shared::tool::{CuttingTool, ToolKind};
use epicyclic_formats::Document;
use epicyclic_formats::yaml::{Mapping, Value, to_string, to_value};
use epicyclic_units::format::trimmed;

/// Millimetres in a metre.
const MM: f64 = 1e3;

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
        if let Some(name) = best.bearing.as_ref().and_then(|bearing| bearing.designation.as_ref()) {
            comment += &format!("# Set {}: bearing {}.\n", set.set.escape_default(), name.escape_default());
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
        let entries = file.get_mut("sets").and_then(Value::as_sequence_mut).into_iter().flatten();
        let own = |entry: &&mut Value| entry.get("id").and_then(Value::as_str) == Some(set.set.as_str());
        if let Some(entry) = entries.into_iter().find(own).and_then(Value::as_mapping_mut) {
            write(entry, set.teeth[1], best)?;
        }
    }
    to_string(&file).map_err(|error| Error::Json(error.to_string()))
}

fn millimetres(metres: f64) -> Value {
    Value::from(format!("{} mm", trimmed(metres * MM, DIGITS)))
}

fn write(entry: &mut Mapping, planet_teeth: u32, design: &SizedDesign) -> Result<(), Error> {
    let list = |values: [f64; 3]| to_value(values).map_err(|error| Error::Json(error.to_string()));
    let mut keys = vec![
        ("planet_teeth", Value::from(vec![Value::from(planet_teeth)])),
        ("planets", Value::from(design.planets)),
        ("profile_shifts", list(design.profile_shifts)?),
        ("tip_alterations", list(design.tip_alterations)?),
        ("module", millimetres(design.module_m)),
        ("face_width", millimetres(design.face_width_m)),
    ];
    if let Some(SizedBearing { rollers, outside_diameter_m, load_rating_n, .. }) = &design.bearing {
        keys.extend(outside_diameter_m.map(|bore| ("planet_bore", millimetres(bore))));
        keys.push(("load_rating", Value::from(format!("{} N", trimmed(*load_rating_n, DIGITS)))));
        keys.push(("bearing_rolling", Value::from(if *rollers { "rollers" } else { "balls" })));
    }
    for (key, value) in keys {
        entry.insert(Value::from(key), value);
    }
    if let Some(strength) = entry.get_mut("strength").and_then(Value::as_mapping_mut) {
        if let Some(rim) = design.planet_rim_m {
            strength.insert(Value::from("planet_rim"), millimetres(rim));
        }
        strength.insert(Value::from("ring_rim"), millimetres(design.ring_rim_m));
    }
    write_tool(entry, &design.ring_tool);
    Ok(())
}

/// Writes the ring's tool as the search used it, so that the teeth remain those of the design.
fn write_tool(entry: &mut Mapping, tool: &CuttingTool) {
    let has_tools = entry.get("tools").and_then(|tools| tools.get("ring")).is_some();
    let of_strength = entry.get_mut("strength").and_then(|strength| strength.get_mut("shaper"));
    if let Some(shaper) = of_strength.and_then(Value::as_mapping_mut).filter(|_| !has_tools) {
        if let Some(addendum) = tool.shaper_addendum_in_modules {
            shaper.insert(Value::from("addendum"), Value::from(addendum));
        }
        return;
    }
    let inner = |map: &Mapping, key| map.get(key).and_then(Value::as_mapping).cloned().unwrap_or_default();
    let mut tools = inner(entry, "tools");
    let mut ring = inner(&tools, "ring");
    match tool.kind {
        ToolKind::Rack => {}
        ToolKind::Form => {
            ring.insert(Value::from("form_fillet"), Value::from(tool.corner_radius_in_modules));
        }
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
            ring.insert(Value::from("shaper"), Value::Mapping(shaper));
        }
    }
    tools.insert(Value::from("ring"), Value::Mapping(ring));
    entry.insert(Value::from("tools"), Value::Mapping(tools));
}
