//! Materials of gears: class, stress limits, elasticity.
//!
//! The class decides which of the standard's life, notch, surface and size factors apply. Stress limits
//! `σ_Hlim`, `σ_Flim` are given, or taken from the small table [`listed`].
//!
//! | class | in ISO 6336 |
//! |---|---|
//! | structural steel | St |
//! | through-hardened steel | V |
//! | grey, nodular, black malleable cast iron | GG, GGG (perl., bai.; ferr.), GTS (perl.) |
//! | case-hardened, induction- or flame-hardened | Eh, IF |
//! | nitriding steel, nitrided | NT (nitr.) |
//! | through-hardened steel, nitrided or nitrocarburized | NV (nitr.), NV (nitrocar.) |

use crate::checks::{positive, within};
use crate::{Error, Quantity};
use epicyclic_units::Physical;
use uom::si::f64::{MassDensity, Pressure};

epicyclic_gears::words! {
    /// Class of a material.
    Class {
        Structural "structural steel (St)"
        ThroughHardened "through-hardened steel (V)"
        GreyIron "grey cast iron (GG)"
        NodularPearlitic "nodular cast iron, pearlitic or bainitic (GGG)"
        NodularFerritic "nodular cast iron, ferritic (GGG)"
        Malleable "black malleable cast iron (GTS)"
        CaseHardened "case-hardened steel (Eh)"
        SurfaceHardened "induction- or flame-hardened steel (IF)"
        Nitrided "nitriding steel, nitrided (NT)"
        ThroughHardenedNitrided "through-hardened steel, nitrided (NV, nitr.)"
        Nitrocarburized "steel, nitrocarburized (NV, nitrocar.)"
    }
}

impl Class {
    /// Whether the flank is harder than the core.
    #[must_use]
    pub const fn is_surface_hardened(self) -> bool {
        use Class::{CaseHardened, Nitrided, Nitrocarburized, SurfaceHardened, ThroughHardenedNitrided};
        matches!(self, CaseHardened | SurfaceHardened | Nitrided | ThroughHardenedNitrided | Nitrocarburized)
    }
}

/// The material of a gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Class.
    pub class: Class,
    /// Contact stress limit `σ_Hlim`.
    pub contact_limit: Pressure,
    /// Root stress limit `σ_Flim` of the test gear, for one direction of load.
    pub root_limit: Pressure,
    /// Brinell hardness of the flank, for `Z_W` of a soft gear in mesh with a hard one.
    pub hardness: Option<f64>,
    /// Strength that the notch factor of the class needs: yield strength `σ_S` of St, 0.2 % proof stress
    /// `σ_0.2` of V, GTS and GGG (perl., bai.), tensile strength `σ_B` of GG and GGG (ferr.). Other classes
    /// do not need it.
    pub strength: Option<Pressure>,
    /// Young's modulus `E`.
    pub youngs_modulus: Pressure,
    /// Poisson's ratio `ν`.
    pub poisson_ratio: f64,
    /// Density `ρ`.
    pub density: MassDensity,
}

impl Material {
    /// A steel: `E` = 206 000 N/mm², `ν` = 0.3, `ρ` = 7830 kg/m³.
    #[must_use]
    pub fn steel(class: Class, contact_limit: Pressure, root_limit: Pressure) -> Self {
        Self {
            class,
            contact_limit,
            root_limit,
            hardness: None,
            strength: None,
            youngs_modulus: Pressure::from_mpa(206_000.0),
            poisson_ratio: 0.3,
            density: MassDensity::from_si(7830.0),
        }
    }

    /// Refuses what no material has.
    ///
    /// # Errors
    /// [`Error::NotPositive`], [`Error::OutOfRange`] for a Poisson's ratio outside 0 to 0.5.
    pub fn check(&self) -> Result<(), Error> {
        positive(Quantity::ContactLimit, self.contact_limit.mpa(), "N/mm²")?;
        positive(Quantity::RootLimit, self.root_limit.mpa(), "N/mm²")?;
        positive(Quantity::YoungsModulus, self.youngs_modulus.mpa(), "N/mm²")?;
        within(Quantity::PoissonRatio, self.poisson_ratio, [0.0, 0.5], "")?;
        positive(Quantity::Density, self.density.si(), "kg/m³")?;
        if let Some(hardness) = self.hardness {
            positive(Quantity::Hardness, hardness, "HBW")?;
        }
        if let Some(strength) = self.strength {
            positive(Quantity::Strength, strength.mpa(), "N/mm²")?;
        }
        Ok(())
    }
}

/// A material of the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Listed {
    /// Designation, `18CrNiMo7-6`.
    pub designation: &'static str,
    /// Values of the material.
    pub material: Material,
    /// Source of the values.
    pub source: &'static str,
}

const WIND: &str = "ISO 6336-5 (quality MQ) as a commercial calculation of the NREL reference wind gearbox takes it \
                    (Nejad, Guo, Gao, Moan 2016)";

/// The table: materials whose limits were read in a source. Others are given by their values.
///
/// ```
/// use epicyclic_strength::material;
/// use uom::si::pressure::megapascal;
///
/// let steel = material::listed("18CrNiMo7-6").unwrap().material;
/// assert_eq!(steel.contact_limit.get::<megapascal>().round(), 1500.0);
/// assert!(material::listed("wood").is_none());
/// ```
#[must_use]
pub fn listed(designation: &str) -> Option<Listed> {
    all().into_iter().find(|listed| listed.designation == designation)
}

/// Every material of the table.
#[must_use]
pub fn all() -> [Listed; 2] {
    let steel = |class, contact, root, hardness, strength| Material {
        hardness,
        strength: Some(Pressure::from_mpa(strength)),
        ..Material::steel(class, Pressure::from_mpa(contact), Pressure::from_mpa(root))
    };
    [
        Listed {
            designation: "18CrNiMo7-6",
            material: steel(Class::CaseHardened, 1500.0, 430.0, None, 850.0),
            source: WIND,
        },
        Listed {
            designation: "34CrNiMo6",
            material: steel(Class::ThroughHardened, 700.0, 290.0, Some(240.0), 1000.0),
            source: WIND,
        },
    ]
}
