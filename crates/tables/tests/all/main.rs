//! Parquet files of searches. One program: its tests run side by side.

mod atlas;
mod parts;
