//! Why a profile shift gives no gear.

/// Why a shift gives no gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ShiftFault {
    /// It is no number.
    NotFinite,
    /// A root or tip circle of radius 0 or less.
    NoCircle,
    /// Tips at or below the roots.
    NoTooth,
    /// The flanks meet before the tip circle.
    Pointed {
        /// Normal thickness at the tip circle, modules: 0 or less.
        tip_thickness: f64,
    },
}
