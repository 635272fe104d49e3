//! Files as people write them. One program: its tests run side by side.

mod book;
mod examples;
mod oracle;
mod places;
mod put;
mod renamed;
mod robust;
