//! Data of a gear's teeth besides their number and profile shift: basic rack, helix angle and tool.

use super::tool::Tool;
use crate::checks::not_negative;
use crate::gear_kind::GearKind;
use crate::rack::BasicRack;
use crate::{Error, Quantity};
use epicyclic_units::Physical;
use std::f64::consts::PI;
use uom::si::f64::Angle;

/// Basic rack, helix angle and tool of a gear.
///
/// | symbol | field | meaning | unit | default |
/// |---|---|---|---|---|
/// | `h_aP*`, `c_P*`, `α_n` | `rack` | [`BasicRack`]; `h_fP* = h_aP* + c_P*` | modules, ° | 1, 0.25, 20° |
/// | `ρ_fP*` | `fillet` | radius at the root of the basic rack | modules | 0.38 |
/// | `p_r*` | `protuberance` | protuberance of the tool, normal to its flank | modules | 0 |
/// | `q*` | `stock` | stock that finishing takes off the flanks, normal to them | modules | 0 |
/// | `β` | `helix_angle` | helix angle at the reference cylinder | ° | 0 |
///
/// Gears in mesh have the pressure angle and the helix angle in common; all else is of each gear alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Profile {
    /// The basic rack.
    pub rack: BasicRack,
    /// Root fillet radius `ρ_fP*` of the basic rack.
    pub fillet: f64,
    /// Protuberance `p_r*` of the hob.
    pub protuberance: f64,
    /// Stock `q*` left on the flanks by the hob.
    pub stock: f64,
    /// Helix angle `β`, without its hand.
    pub helix_angle: Angle,
    /// Tool that cuts the gear; by default the [usual tool](Tool::usual) of its kind.
    pub tool: Option<Tool>,
}

impl Default for Profile {
    fn default() -> Self {
        Self {
            rack: BasicRack::default(),
            fillet: 0.38,
            protuberance: 0.0,
            stock: 0.0,
            helix_angle: Angle::from_si(0.0),
            tool: None,
        }
    }
}

/// Profiles of sun, planet and ring, with the pressure and helix angle in common.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Profiles(pub [Profile; 3]);

impl From<Profile> for Profiles {
    fn from(profile: Profile) -> Self {
        Self([profile; 3])
    }
}

impl Default for Profiles {
    fn default() -> Self {
        Profile::default().into()
    }
}

impl Profiles {
    /// Profile whose pressure and helix angle all three gears share: the sun's.
    #[must_use]
    pub const fn shared(&self) -> &Profile {
        &self.0[0]
    }

    /// Refuses proportions that no rack has, and tools that do not cut their gear.
    ///
    /// # Errors
    /// Those of [`Profile::check`] and [`Tool::check`].
    pub fn check(&self) -> Result<(), Error> {
        for (profile, kind) in self.0.iter().zip([GearKind::External, GearKind::External, GearKind::Internal])
        {
            profile.check()?;
            profile.tool.map_or(Ok(()), |tool| tool.check(kind))?;
        }
        Ok(())
    }
}

/// Deviations of a gear from the basic rack and the usual tool of its set; lengths in modules.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Cutting {
    /// Dedendum `h_fP*` of its basic rack.
    pub dedendum: Option<f64>,
    /// Root fillet radius `ρ_fP*` of its basic rack.
    pub fillet: Option<f64>,
    /// Protuberance `p_r*` of its hob.
    pub protuberance: f64,
    /// Stock `q*` that its hob leaves.
    pub stock: f64,
    /// Tool that cuts the gear.
    pub tool: Option<Tool>,
}

impl Cutting {
    /// The profile of the gear in a set with this one.
    #[must_use]
    pub fn of(&self, set: Profile) -> Profile {
        let rack = BasicRack {
            clearance: self.dedendum.map_or(set.rack.clearance, |dedendum| dedendum - set.rack.addendum),
            ..set.rack
        };
        let cut = Profile {
            rack,
            protuberance: self.protuberance,
            stock: self.stock,
            tool: self.tool.or(set.tool),
            ..set
        };
        // A usual fillet gives way to a deeper rack, a stated one does not.
        Profile { fillet: self.fillet.unwrap_or_else(|| set.fillet.min(cut.most_fillet()).max(0.0)), ..cut }
    }
}

impl Profiles {
    /// Profiles of a set whose gears are cut as `cutting` says.
    #[must_use]
    pub fn cut(profile: Profile, cutting: [Cutting; 3]) -> Self {
        Self(cutting.map(|cutting| cutting.of(profile)))
    }
}

/// Basic rack tooth profiles of ISO 53.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Iso53 {
    /// `h_fP* = 1.25`, `ρ_fP* = 0.38`: for high torques.
    A,
    /// `h_fP* = 1.25`, `ρ_fP* = 0.30`: usual service, of a standard hob.
    B,
    /// `h_fP* = 1.25`, `ρ_fP* = 0.25`: usual service.
    C,
    /// `h_fP* = 1.40`, `ρ_fP* = 0.39`: for fillets left unground.
    D,
}

impl From<Iso53> for Cutting {
    fn from(profile: Iso53) -> Self {
        let [dedendum, fillet] = profile.dedendum_and_fillet();
        Self { dedendum: Some(dedendum), fillet: Some(fillet), ..Self::default() }
    }
}

impl Iso53 {
    /// Dedendum `h_fP*` and fillet radius `ρ_fP*`.
    #[must_use]
    pub const fn dedendum_and_fillet(self) -> [f64; 2] {
        match self {
            Self::A => [1.25, 0.38],
            Self::B => [1.25, 0.30],
            Self::C => [1.25, 0.25],
            Self::D => [1.40, 0.39],
        }
    }
}

impl Profile {
    /// Spur teeth by a basic rack, with a fillet of 0.38 modules or what its clearance has room for.
    #[must_use]
    pub fn of_rack(rack: BasicRack) -> Self {
        let usual = Self { rack, ..Self::default() };
        let by_clearance = rack.clearance / (1.0 - libm::sin(rack.pressure_angle.si())) + ROUNDED_FILLET;
        Self { fillet: usual.fillet.min(by_clearance).min(usual.most_fillet()).max(0.0), ..usual }
    }

    /// Refuses proportions that no rack has.
    ///
    /// # Errors
    /// Those of [`BasicRack::check`]; [`Error::OutOfRange`] unless `0 ≤ β < 60°`, or for a fillet that the
    /// rack has no room for; [`Error::Negative`] for fillet, protuberance or stock.
    pub fn check(&self) -> Result<(), Error> {
        self.rack.check()?;
        not_negative(Quantity::RootFillet, self.fillet, "modules")?;
        not_negative(Quantity::Protuberance, self.protuberance, "modules")?;
        not_negative(Quantity::Stock, self.stock, "modules")?;
        let helix_deg = self.helix_angle.degrees();
        if !(0.0..MOST_HELIX_DEG).contains(&helix_deg) {
            return Err(Error::OutOfRange {
                quantity: Quantity::HelixAngle,
                value: helix_deg,
                low: 0.0,
                high: MOST_HELIX_DEG,
                unit: "°",
            });
        }
        let most = self.most_fillet();
        if self.fillet > most {
            return Err(Error::OutOfRange {
                quantity: Quantity::RootFillet,
                value: self.fillet,
                low: 0.0,
                high: most,
                unit: "modules",
            });
        }
        Ok(())
    }

    /// Dedendum `h_fP* = h_aP* + c_P*` of the basic rack.
    #[must_use]
    pub fn dedendum(&self) -> f64 {
        self.rack.addendum + self.rack.clearance
    }

    /// Generating profile shift `x_E = x + q/sin α_n` with which a hob leaves the stock of a gear of shift
    /// `x`.
    #[must_use]
    pub fn generating_shift(&self, shift: f64) -> f64 {
        shift + self.stock / libm::sin(self.rack.pressure_angle.si())
    }

    /// The largest fillet of the rack: one arc from flank to flank of a tooth space.
    ///
    /// ```text
    /// ρ_fP* ≤ (π/4 − h_fP*·tan α_n)/tan(45° − α_n/2) = (π/4 − h_fP*·tan α_n)·cos α_n/(1 − sin α_n)
    /// ```
    #[must_use]
    pub fn most_fillet(&self) -> f64 {
        let alpha = self.rack.pressure_angle.si();
        let half = PI / 4.0 - self.dedendum() * libm::tan(alpha) + self.protuberance / libm::cos(alpha);
        // ISO 53 rounds what there is room for: 0.39 of profile D at 0.3939, so nothing more is asked than
        // the arc's own width.
        half / libm::tan(PI / 4.0 - alpha / 2.0) + ROUNDED_FILLET
    }

    /// Transverse pressure angle `α_t`, rad.
    #[must_use]
    pub fn transverse_angle_rad(&self) -> f64 {
        libm::atan(libm::tan(self.rack.pressure_angle.si()) / libm::cos(self.helix_angle.si()))
    }

    /// Whether its teeth are helical.
    #[must_use]
    pub fn is_helical(&self) -> bool {
        self.helix_angle.si() != 0.0
    }

    /// Helix angle at the base cylinder `β_b`, rad: `tan β_b = tan β·cos α_t`.
    #[must_use]
    pub fn base_helix_rad(&self) -> f64 {
        libm::atan(libm::tan(self.helix_angle.si()) * libm::cos(self.transverse_angle_rad()))
    }
}

/// Helix angles of cylindrical gears stay below.
const MOST_HELIX_DEG: f64 = 60.0;

/// Rounding of the printed fillet radii of racks.
const ROUNDED_FILLET: f64 = 0.01;
