//! What several tests and the bench share.

pub(crate) mod machines;
pub(crate) mod oracle;
pub(crate) mod plain;
