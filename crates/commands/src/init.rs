//! `init`: files to start from.

pub mod request;
