//! `atlas`: all gearboxes of two and three sets as Parquet tables.

pub mod request;
