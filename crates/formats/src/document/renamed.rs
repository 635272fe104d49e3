//! Keys that files of gearboxes, drives and motors once had, and the words that took their place.

/// Old key and new, of all formats. An old key is refused where the new one is allowed.
pub const RENAMED: [(&str, &str); 6] = [
    ("wheels", "gear_set"),
    ("rows", "sets"),
    ("nodes", "links"),
    ("elements", "shift_elements"),
    ("controls", "shift_elements"),
    ("bearing_capacity", "load_rating"),
];

/// Name today of a key that is not known, if it is among those allowed.
pub(super) fn renamed(key: &str, allowed: &[&'static str]) -> Option<&'static str> {
    let new = RENAMED.iter().find(|(old, _)| *old == key)?.1;
    allowed.contains(&new).then_some(new)
}
