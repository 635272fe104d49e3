//! Parts of a search together: the search of the whole class.

use crate::error::Error;
use crate::part::Part;
use epicyclic_synthesis::asked::Asked;
use epicyclic_synthesis::run::Answer;
use epicyclic_synthesis::tally::Tally;
use epicyclic_synthesis::work::Found;

/// Merges parts, each with its file, into the results of searches of whole classes: one answer for each
/// question of `asked`.
///
/// The order of the parts and the number of shares do not change the answers.
///
/// # Errors
/// [`Error::Version`], [`Error::OtherSearch`], [`Error::Division`], [`Error::Double`], [`Error::Missing`] and
/// [`Error::Incomplete`]: all shares must be present, each once and complete, of one version and one
/// question.
pub fn merge(parts: &[(String, Part)], version: &str, asked: &[Asked]) -> Result<Vec<Answer>, Error> {
    let Some((first, Part { share: first_share, .. })) = parts.first() else {
        return Err(Error::Missing { shares: vec![1], of: 1 });
    };
    for (file, part) in parts {
        if part.version != version {
            let (given, version) = (part.version.clone(), version.to_owned());
            return Err(Error::Version { file: file.clone(), given, version });
        }
        same_question(file, part, asked)?;
        if part.share.of != first_share.of {
            let (one_of, other_of) = (first_share.of, part.share.of);
            return Err(Error::Division { one: first.clone(), one_of, other: file.clone(), other_of });
        }
    }
    let mut by_share: Vec<&(String, Part)> = parts.iter().collect();
    by_share.sort_by_key(|(_, part)| part.share);
    for pair in by_share.windows(2) {
        if pair[0].1.share == pair[1].1.share {
            let share = pair[0].1.share.to_string();
            return Err(Error::Double { share, one: pair[0].0.clone(), other: pair[1].0.clone() });
        }
    }
    let there = |number: &usize| by_share.binary_search_by_key(number, |(_, part)| part.share.number).is_ok();
    let shares: Vec<usize> =
        (0..first_share.of).filter(|number| !there(number)).map(|number| number + 1).collect();
    if !shares.is_empty() {
        return Err(Error::Missing { shares, of: first_share.of });
    }
    (0..asked.len()).map(|search| together(&by_share, search)).collect()
}

/// Checks that a part answers the same question.
///
/// # Errors
/// [`Error::OtherSearch`] with the difference.
pub fn same_question(file: &str, part: &Part, asked: &[Asked]) -> Result<(), Error> {
    let other = |what: String, given: String, here: String| {
        Err(Error::OtherSearch { file: file.to_owned(), what, given, here })
    };
    for (asked, (given, _)) in asked.iter().zip(&part.searches) {
        for (name, here) in asked {
            match given.iter().find(|(known, _)| known == name) {
                Some((_, given)) if given == here => {}
                Some((_, value)) => return other(format!("{name}:"), value.clone(), here.clone()),
                None => return other(format!("{name}:"), "none".into(), here.clone()),
            }
        }
        if let Some((name, value)) =
            given.iter().find(|(name, _)| asked.iter().all(|(known, _)| known != name))
        {
            return other(format!("{name}:"), value.clone(), "none".into());
        }
    }
    if part.searches.len() != asked.len() {
        let count = |count: usize| count.to_string();
        return other("number of classes:".into(), count(part.searches.len()), count(asked.len()));
    }
    Ok(())
}

/// One search of parts in the order of their shares.
fn together(parts: &[&(String, Part)], search: usize) -> Result<Answer, Error> {
    let mut tally = Tally::default();
    let mut found: Vec<(usize, &Found)> = Vec::new();
    let class_size = parts.first().map_or(0, |(_, part)| part.searches[search].1.class_size);
    for (file, part) in parts {
        let work = &part.searches[search].1;
        if !work.is_complete() {
            let at = work.progress();
            return Err(Error::Incomplete { file: file.clone(), done: at.done, structures: at.of });
        }
        if work.class_size != class_size || !work.is_sound() {
            return Err(Error::NoPart(format!(
                "{file} contradicts itself or another part; search its share anew"
            )));
        }
        tally += work.tally;
        found.extend(work.found.iter().map(|(place, found)| (part.share.place_in_class(*place), found)));
    }
    // Stable: solutions of one structure keep their order.
    found.sort_by_key(|(place, _)| *place);
    let found = found.into_iter().map(|(_, found)| found.clone()).collect();
    Ok(Answer { class_size, found, tally, complete: true })
}
