//! Parts shared by several tests and the bench.

pub(crate) mod machines;
pub(crate) mod oracle;
pub(crate) mod plain;

/// Number of test cases: `usual`, unless `PROPTEST_CASES` gives another.
#[allow(dead_code, reason = "the bench has none")]
pub(crate) fn cases(usual: u32) -> u32 {
    std::env::var("PROPTEST_CASES").ok().and_then(|cases| cases.parse().ok()).unwrap_or(usual)
}
