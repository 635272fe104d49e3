//! Usual values of what a gearbox is for.

use crate::shared::basis::Basis;
use epicyclic_formats::yaml::{Mapping, Value};

/// What a gearbox is for, with the values that are usual of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Application {
    /// Belt and scraper conveyors.
    Conveyor,
    /// Travel drives of crawlers and wheels.
    Travel,
    /// Slewing drives of cranes and excavators.
    Slewing,
    /// Winches and hoists.
    Winch,
    /// Mixers and agitators.
    Mixer,
    /// Wind turbines.
    Wind,
    /// Robots and servo drives.
    Robot,
    /// Automatic transmissions of cars.
    Automatic,
}

/// Values that are usual of an application.
struct Usual {
    /// Application factor.
    k_a: f64,
    life_h: u32,
    /// Required safeties of flank and root.
    safeties: [f64; 2],
}

impl Application {
    /// Values of usual practice; none is measured.
    const fn usual(self) -> Usual {
        let (k_a, life_h, safeties) = match self {
            Self::Conveyor => (1.5, 30_000, [1.2, 1.5]),
            Self::Travel => (1.25, 5_000, [1.0, 1.4]),
            Self::Slewing => (1.4, 6_300, [1.1, 1.5]),
            Self::Winch => (1.4, 3_200, [1.1, 1.5]),
            Self::Mixer => (1.5, 20_000, [1.2, 1.5]),
            Self::Wind => (1.25, 175_200, [1.25, 1.56]),
            Self::Robot => (1.1, 20_000, [1.0, 1.4]),
            Self::Automatic => (1.0, 3_000, [1.0, 1.2]),
        };
        Usual { k_a, life_h, safeties }
    }

    /// The default basis with the values of the application.
    pub(crate) fn basis(self) -> Basis {
        let Usual { k_a, life_h, safeties: [flank, root] } = self.usual();
        let required = [("flank", flank), ("root", root)];
        let required = required.map(|(key, value)| (Value::from(key), Value::from(value)));
        Basis::default()
            .with_factors(&[("K_A".to_owned(), k_a)])
            .with("life", format!("{life_h} h").into())
            .with("required", Value::Mapping(required.into_iter().collect::<Mapping>()))
    }
}
