//! Size of a search, shown before it begins, and refusal of searches that are too large for this machine.

use crate::desk::Call;
use crate::failure::Failure;
use crate::progress::duration;
use crate::synthesize::answer::Searching;
use epicyclic_synthesis::estimate;
use epicyclic_synthesis::wish::Wish;
use epicyclic_synthesis::work::Share;
use epicyclic_units::Physical as _;
use std::ffi::OsString;
use uom::si::f64::Time;

/// Structures times sets of shift elements from which on the size of a search is shown.
const TOLD: f64 = 1e6;
/// Structures times sets of shift elements from which on a sample estimates the duration.
const SAMPLED: f64 = 1e9;
/// How long a sample takes, in s, and once more as long; longer where few structures take that long.
const SAMPLE_S: f64 = 1.0;
/// Longest duration of a sample, s. A longer one is cut and estimated from the part searched until then.
const MOST_SAMPLE_S: f64 = 20.0;
/// How long the structures of a class are counted, in s; of more their number is estimated, in as long.
const COUNT_S: f64 = 1.0;
/// Of how many structures a sample is small.
const FEW: usize = 100;
/// The longest search that is begun without being asked for, in s.
const LONGEST_S: f64 = 3600.0;
/// The most memory of such a search, in GB.
const MOST_GB: f64 = 4.0;

/// Shows the size of a search that is not small; for a large one also its duration. Refuses a search that
/// takes too long.
pub(crate) fn check(
    call: &Call<'_>,
    searching: &Searching,
    wish: &Wish,
    longest: Option<Time>,
) -> Result<(), Failure> {
    let class = searching.class;
    let clock = || call.desk.seconds();
    let ended = || call.goes_on().is_break();
    // Where the search is to end it ends by itself, with what classes before had.
    let Some(size) = estimate::size(class, COUNT_S, &clock, &ended) else { return Ok(()) };
    let space = searching.space(size.structures as f64);
    if space < TOLD && longest.is_none() {
        return Ok(());
    }
    let count = if size.is_counted() {
        size.structures.to_string()
    } else {
        format!("about {:.1e}", size.structures as f64)
    };
    let told =
        format!("{class}: {count}, with sets of {} shift elements {space:.1e}", searching.shift_elements);
    call.complain(&format!("searching {told}"));
    if space < SAMPLED && longest.is_none() {
        return Ok(());
    }
    let begun = clock();
    let is_over = || ended() || clock() - begun > MOST_SAMPLE_S;
    let sampled = estimate::sample(class, wish, Share::WHOLE, &size, (SAMPLE_S, &clock), &is_over)
        .map_err(crate::error::Error::from)?;
    if ended() || sampled.sampled == 0 {
        return Ok(());
    }
    let threads = call.desk.threads();
    let seconds = sampled.seconds() / threads as f64;
    let gigabytes = sampled.bytes(threads) / 1e9;
    // The times of single structures differ widely.
    let few = match sampled.sampled {
        1 => ", by a sample of one structure".to_owned(),
        few @ ..FEW => format!(", by a sample of {few} structures"),
        _ => String::new(),
    };
    let least = if sampled.is_cut { "at least" } else { "about" };
    let about = format!("{least} {} and {gigabytes:.1} GB on {threads} threads{few}", duration(seconds));
    let refused = match longest {
        Some(longest) => seconds > longest.si(),
        None => seconds > LONGEST_S || gigabytes > MOST_GB,
    };
    if refused {
        let shares = sampled.shares(LONGEST_S * threads as f64).ceil().max(2.0);
        return Err(Failure::TooLong(refusal(&told, &about, shares, call.words.iter().cloned())));
    }
    call.complain(&format!("this takes {about}"));
    Ok(())
}

/// Remedy for a search that is too large, with the commands to divide it.
fn refusal(size: &str, about: &str, shares: f64, args: impl Iterator<Item = OsString>) -> String {
    let command = command(args);
    format!(
        "{size}, {about}: a greater --longest begins it here; or in {shares:.0} shares on as many machines\n  \
         {command} --shard 1/{shares:.0} -o part-1.parquet\nand so on to --shard {shares:.0}/{shares:.0}, then together\n  \
         {command} --merge part-*.parquet"
    )
}

/// The command line as a shell takes it, without what is about the answer.
fn command(args: impl Iterator<Item = OsString>) -> String {
    let mut words = vec!["epicyclic".to_owned()];
    let mut args = args.map(|arg| arg.to_string_lossy().into_owned());
    while let Some(arg) = args.next() {
        match arg.as_str() {
            "-o" | "--output" | "--format" | "--limit" | "--longest" => {
                args.next();
            }
            of if ["-o", "--output=", "--format=", "--limit=", "--longest="]
                .iter()
                .any(|option| of.starts_with(option)) => {}
            _ => words.push(quoted(&arg)),
        }
    }
    words.join(" ")
}

/// A word in quotes where a shell would take it for something else.
fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./=%,:+".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', "'\\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_search_that_takes_too_long_is_refused_with_commands_to_copy() {
        let args = [
            "synthesize",
            "--ratios",
            "4.7, 3.1",
            "--sets",
            "4",
            "-o",
            "x.json",
            "--format=json",
            "--tolerance=1%",
        ];
        let told = refusal("a class", "about 9 h on 2 threads", 9.0, args.iter().map(OsString::from));
        assert_eq!(
            told,
            "a class, about 9 h on 2 threads: a greater --longest begins it here; or in 9 shares on as many machines\n  epicyclic synthesize \
             --ratios '4.7, 3.1' --sets 4 --tolerance=1% --shard 1/9 -o part-1.parquet\nand so on to --shard 9/9, then \
             together\n  epicyclic synthesize --ratios '4.7, 3.1' --sets 4 --tolerance=1% --merge part-*.parquet"
        );
    }

    #[test]
    fn words_are_quoted_where_a_shell_would_part_or_change_them() {
        assert_eq!(quoted("a.yaml"), "a.yaml");
        assert_eq!(quoted("4.7 3.1"), "'4.7 3.1'");
        assert_eq!(quoted("it's"), "'it'\\''s'");
        assert_eq!(quoted("?"), "'?'");
        assert_eq!(quoted(""), "''");
    }
}
