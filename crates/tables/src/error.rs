//! Errors of tables.

use parquet::errors::ParquetError;

/// A table that cannot be made, or from which nothing can be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// An error of the reader or writer of Parquet.
    #[error("Parquet: {0}")]
    Parquet(#[from] ParquetError),
    /// A table that the caller cancelled.
    #[error("the table was cancelled")]
    Cancelled,
    /// More sets than the atlas has.
    #[error("{sets} planet sets: the atlas has at most {most}")]
    Sets {
        /// Number of sets.
        sets: usize,
        /// The most.
        most: usize,
    },
    /// A table that is not part of a search, or not as it was written.
    #[error("{0}")]
    NoPart(String),
    /// A table that is not as it was written.
    #[error("damaged: its checksum is not that of its bytes; copy it again, or search its share anew")]
    Damaged,
    /// A table without a checksum.
    #[error(
        "no part of a search with a checksum: it is another file, is damaged, or was written by an earlier version of the program; search \
         its share anew"
    )]
    Unsealed,
    /// Parts of different versions of the program.
    #[error("{file} is of version {given}, not {version}: all parts have to be of one version")]
    Version {
        /// The part.
        file: String,
        /// Version of the part.
        given: String,
        /// The required version.
        version: String,
    },
    /// A part of another search.
    #[error("{file} is of another search: its {what} {given}, here {here}")]
    OtherSearch {
        /// The part.
        file: String,
        /// The differing question or count.
        what: String,
        /// Value in the part.
        given: String,
        /// Value in this search.
        here: String,
    },
    /// Parts whose shares are of different numbers.
    #[error("{one} is of {one_of} shares, {other} of {other_of}: all parts have to be of one division")]
    Division {
        /// A part.
        one: String,
        /// Number of shares of the first part.
        one_of: usize,
        /// Another.
        other: String,
        /// Number of shares of the other part.
        other_of: usize,
    },
    /// A share that is given twice.
    #[error("{one} and {other} are both share {share}; give one of them")]
    Double {
        /// The share.
        share: String,
        /// A part of it.
        one: String,
        /// The other.
        other: String,
    },
    /// Shares that are not there.
    #[error("missing: {} of {of}", missing(shares))]
    Missing {
        /// Numbers of the missing shares.
        shares: Vec<usize>,
        /// Number of all shares.
        of: usize,
    },
    /// A part in work.
    #[error(
        "{file} is not complete: {done} of {structures} structures searched; go on with it by its own command"
    )]
    Incomplete {
        /// The part.
        file: String,
        /// Structures that were searched.
        done: usize,
        /// Structures of its share.
        structures: usize,
    },
}

/// `shares 2, 3, 5`; of many the first.
fn missing(shares: &[usize]) -> String {
    /// Number of shares that are listed.
    const NAMED: usize = 20;
    let named: Vec<String> = shares.iter().take(NAMED).map(usize::to_string).collect();
    let more = match shares.len().saturating_sub(NAMED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    format!("share{} {}{more}", if shares.len() == 1 { "" } else { "s" }, named.join(", "))
}
