//! What several tests and the bench share.

pub(crate) mod machines;
pub(crate) mod oracle;
pub(crate) mod plain;

/// So many cases, unless `PROPTEST_CASES` says how many.
#[allow(dead_code, reason = "the bench has none")]
pub(crate) fn cases(usual: u32) -> u32 {
    std::env::var("PROPTEST_CASES").ok().and_then(|cases| cases.parse().ok()).unwrap_or(usual)
}
