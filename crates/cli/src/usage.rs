//! Refusals of a command line: as an answer for programs, and shown to people.

use clap::error::{ContextKind, ContextValue, ErrorKind};
use epicyclic_commands::failure::{INVALID, WRONG};
use epicyclic_commands::refused::Refused;
use epicyclic_units::find_unit;
use epicyclic_units::visible::one_line;
use std::ffi::OsString;

/// A refusal of a command line as an answer.
pub(crate) fn refused(error: &clap::Error) -> Refused {
    let text = error.render().to_string();
    // What follows the first paragraph is advice for people at a terminal: usage, and where help is.
    let message = text.split("\n\n").next().unwrap_or_default();
    let message = message.strip_prefix("error: ").unwrap_or(message);
    let message = message.lines().map(str::trim).collect::<Vec<_>>().join(" ");
    let text = |kind| match error.get(kind)? {
        ContextValue::String(text) => Some(text.clone()).filter(|text| !text.is_empty()),
        ContextValue::Strings(texts) => texts.first().cloned(),
        _ => None,
    };
    let mut refused = Refused::new(name(error.kind()), message, WRONG).of_option(option(error));
    for fault in &mut refused.faults {
        let unknown = match error.kind() {
            ErrorKind::UnknownArgument => text(ContextKind::InvalidArg),
            ErrorKind::InvalidSubcommand => text(ContextKind::InvalidSubcommand),
            _ => None,
        };
        fault.value = text(ContextKind::InvalidValue).or(unknown);
        let suggested =
            [ContextKind::SuggestedValue, ContextKind::SuggestedArg, ContextKind::SuggestedSubcommand];
        fault.remedy = suggested.into_iter().find_map(text);
    }
    refused
}

/// The option at fault, without the name of its value.
fn option(error: &clap::Error) -> Option<String> {
    let argument = match error.get(ContextKind::InvalidArg)? {
        ContextValue::String(argument) => argument,
        ContextValue::Strings(arguments) => arguments.first()?,
        _ => return None,
    };
    let option = argument.split([' ', '=']).next()?;
    option.starts_with('-').then(|| option.to_owned())
}

/// The name of a kind of refusal, which does not change.
fn name(kind: ErrorKind) -> &'static str {
    match kind {
        ErrorKind::UnknownArgument => "unknown-argument",
        ErrorKind::InvalidSubcommand => "unknown-command",
        ErrorKind::InvalidValue | ErrorKind::ValueValidation => INVALID,
        ErrorKind::ArgumentConflict => "argument-conflict",
        ErrorKind::MissingRequiredArgument => "missing-argument",
        ErrorKind::MissingSubcommand | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            "missing-command"
        }
        _ => "usage",
    }
}

/// A refusal with every character of what was typed shown.
pub(crate) fn shown(mut error: clap::Error) -> clap::Error {
    let context: Vec<_> = error.context().map(|(kind, value)| (kind, value.clone())).collect();
    for (kind, value) in context {
        let value = match value {
            ContextValue::String(text) => ContextValue::String(one_line(&text).into_owned()),
            ContextValue::Strings(texts) => {
                ContextValue::Strings(texts.iter().map(|text| one_line(text).into_owned()).collect())
            }
            other => other,
        };
        error.insert(kind, value);
    }
    if let Some(tip) = of_conflict(&error) {
        error.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![tip.into()]));
    }
    error
}

/// Remedy for options that exclude one another; `None` of other refusals.
fn of_conflict(error: &clap::Error) -> Option<String> {
    if error.kind() != ErrorKind::ArgumentConflict {
        return None;
    }
    let name = |argument: &str| argument.split([' ', '=']).next().unwrap_or_default().to_owned();
    let Some(ContextValue::String(one)) = error.get(ContextKind::InvalidArg) else { return None };
    let others = match error.get(ContextKind::PriorArg) {
        Some(ContextValue::String(other)) => vec![name(other)],
        Some(ContextValue::Strings(others)) => others.iter().map(|other| name(other)).collect(),
        _ => vec![],
    };
    let one = name(one);
    if others.is_empty() || others.contains(&one) {
        return Some(format!("write '{one}' once"));
    }
    Some(format!("leave out '{one}', or '{}'", others.join("' and '")))
}

/// Message about a loose unit, in the place of an option, command or file: the shell separated it from its
/// number.
pub(crate) fn loose_unit(error: &clap::Error, words: &[OsString]) -> Option<String> {
    let kinds = [ContextKind::InvalidArg, ContextKind::InvalidSubcommand];
    let refused = kinds.into_iter().filter_map(|kind| match error.get(kind) {
        Some(ContextValue::String(word)) => Some(word.as_str()),
        _ => None,
    });
    let behind_numbers = words.windows(2).filter_map(|pair| {
        let [number, word] = [&pair[0], &pair[1]].map(|word| word.to_str());
        number?.parse::<f64>().ok().and(word)
    });
    refused.chain(behind_numbers).find(|word| find_unit(word).is_some()).map(str::to_owned)
}
