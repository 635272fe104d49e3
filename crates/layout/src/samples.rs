//! Gearboxes that several tests draw.

use epicyclic_train::Gearbox;
use epicyclic_train::set::SetSpec;

/// Scheme I: one set, its ring braked.
pub(crate) fn scheme_one() -> Gearbox {
    Gearbox::builder("I")
        .links(["D", "B", "T1"])
        .set(SetSpec::simple("1", ["D", "T1", "B"], 2.94))
        .brake("K1", "T1")
        .input("D")
        .output("B")
        .build()
        .unwrap()
}
