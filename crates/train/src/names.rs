//! Names that a person may have mistyped.

/// The nearest of some names, if one is near enough to be a slip of the pen.
#[must_use]
pub fn nearest<'a>(name: &str, among: impl Iterator<Item = &'a str>) -> Option<String> {
    among
        .map(|other| (strsim::osa_distance(&name.to_lowercase(), &other.to_lowercase()), other))
        .min_by_key(|(distance, _)| *distance)
        // Names of one letter differ by one letter all, unless it is the case that differs.
        .filter(|(distance, _)| {
            *distance <= (1 + name.chars().count() / 3).min(name.chars().count().saturating_sub(1))
        })
        .map(|(_, other)| other.to_owned())
}

/// A nearest name in words, the end of a message.
pub(crate) fn hint(suggestion: Option<&str>) -> String {
    suggestion.map_or_else(String::new, |name| format!("; did you mean `{name}`?"))
}
