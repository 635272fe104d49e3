//! Load factors: what raises the tangential force of a tooth above its nominal value.
//!
//! `K_A` and `K_Hβ` are given. `K_γ` is given or follows from the number of planets and whether a member
//! floats ([`load_sharing`]). `K_v`, `K_Hα` and `K_Fα` are given or follow by method B from deviations,
//! stiffness and masses; `K_Fβ` is given or follows from `K_Hβ`.
//!
//! ```text
//! K_Fβ = K_Hβ^N_F, N_F = 1/(1 + h/b + (h/b)²)     h the larger tooth height, h/b at most 1/3
//! q' = 0.04723 + 0.15551/z_n1 + 0.25791/z_n2 − 0.00635·x_1 − 0.11654·x_1/z_n1 − 0.00193·x_2
//!      − 0.24188·x_2/z_n2 + 0.00529·x_1² + 0.00182·x_2²
//! c' = 0.8·C_R·C_B·cos β/q'·E/E_St                 1/z_n2 = 0 of an internal gear
//! C_B = (1 + 0.5·(1.2 − h_fP))·(1 − 0.02·(20° − α_n))
//! c_γα = c'·(0.75·ε_α + 0.25)
//! m* = π/8·ρ·d_m⁴·(1 − q⁴)/d_b²                    d_m mean of tip and root diameter, q = d_i/d_m
//! m_red = m*_1·m*_2/(m*_1 + m*_2)
//!         sun and p planets: m*_s·m*_p/(m*_s + p·m*_p); planet and held ring: m*_p
//! n_E = 30000/(π·z_1)·√(c_γα/m_red), N = n_1/n_E
//! B_p = c'·(f_pb − y_p)/w, B_f = c'·(f_fα − y_f)/w, B_k = |1 − c'·C_a/w|, 1 without tip relief
//! w = F_t·K_A·K_γ/b
//! K_v = 1 + N·(C_v1·B_p + C_v2·B_f + C_v3·B_k)     N ≤ 0.85
//!     = 1 + C_v1·B_p + C_v2·B_f + C_v4·B_k         to N = 1.15
//!     = C_v5·B_p + C_v6·B_f + C_v7                 from N = 1.5; between, a straight line
//! K_α = ε_γ/2·(0.9 + 0.4·q), ε_γ ≤ 2;  0.9 + 0.4·√(2·(ε_γ − 1)/ε_γ)·q
//! q = c_γα·(f_pb − y_α)·b/(F_t·K_A·K_γ·K_v·K_Hβ)
//! 1 ≤ K_Hα ≤ ε_γ/(ε_α·Z_ε²),  1 ≤ K_Fα ≤ ε_γ/(0.25·ε_α + 0.75)
//! ```
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | `w` | line load | N/mm |
//! | `c'`, `c_γα` | stiffness of one pair of teeth, and of the mesh, per mm of width | N/(mm·µm) |
//! | `m*`, `m_red` | mass of a gear and of the mesh at the line of action, per mm of width | kg/mm |
//! | `n_1`, `n_E`, `N` | speed of the first gear relative to the carrier, its resonance, their ratio | rpm |
//! | `f_pb`, `f_fα` | base pitch deviation, profile form deviation, the larger of both gears | µm |
//! | `y_p` = `y_α`, `y_f` | running-in allowances | µm |
//! | `C_a` | tip relief | µm |
//! | `C_R` | gear blank factor, 1 of solid discs | 1 |
//!
//! In `q'` gear 1 is the pinion, the gear with fewer teeth, whichever drives; of equal numbers of teeth `q'`
//! is the mean of both ways.
//!
//! `K_v` by method B is not offered below 100 N/mm, where the standard reduces the stiffness: there it is
//! given.
//!
//! # Source
//! ISO 6336-1:2006, clauses 6 to 9: formulas (6), (9), (13) to (17), (20) to (22), (73) to (76). `K_γ`:
//! [`load_sharing`]. Tested against the NREL reference wind gearbox: `c'` 12.240/14.053, `m_red`
//! 0.1534/1.4684, `n_E` 5357/993, `K_v` 1.02/1.061, `K_Fβ` 1.94/1.14.

use crate::checks::{not_negative, positive};
use crate::factor::{Document, Factor, Reference};
use crate::material::{Class, Material};
use crate::symbol::Symbol;
use crate::{Error, Quantity};
use epicyclic_gears::geometry::GearKind;
use epicyclic_gears::involute::{InvoluteGear, Pair};
use epicyclic_units::Physical;
use std::cmp::Ordering;
use std::f64::consts::PI;
use uom::si::f64::{Length, SurfaceTension};

/// Whether a member of a planetary set floats: sun, ring or carrier without a bearing of its own, or on
/// flexible supports.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Floating {
    /// No statement; one member is assumed to float.
    #[default]
    Assumed,
    /// One member floats.
    Yes,
    /// No member floats: all members turn in rigid bearings.
    No,
}

/// Mesh load factors `K_γ` of 3, 4, 5, 6 and 7 planets with one floating member.
const SHARING: [f64; 5] = [1.10, 1.25, 1.35, 1.44, 1.47];

/// Largest number of planets with a factor of [`load_sharing`].
pub const MOST_SHARING: u32 = SHARING.len() as u32 + 2;

/// Factor of [`SHARING`] without a floating member.
const RIGID: f64 = 1.15;

/// Mesh load factor `K_γ` of a number of planets where it is not measured or calculated.
///
/// | planets | 1 | 2, 3 | 4 | 5 | 6 | 7 |
/// |---|---|---|---|---|---|---|
/// | one member floats | 1 | 1.10 | 1.25 | 1.35 | 1.44 | 1.47 |
///
/// Without a floating member the values from two planets on are 1.15 times these. The source begins at three
/// planets; two take its first value, since a member that floats settles between two planets as between
/// three.
///
/// # Errors
/// [`Error::NotPositive`] without planets; [`Error::MissingFactor`] for more than 7, where the table ends.
///
/// # Example
/// ```
/// use epicyclic_strength::load::{Floating, load_sharing};
///
/// # fn main() -> Result<(), epicyclic_strength::Error> {
/// assert_eq!(load_sharing(4, Floating::Yes)?, 1.25);
/// assert_eq!(load_sharing(4, Floating::No)?, 1.25 * 1.15);
/// # Ok(())
/// # }
/// ```
///
/// # Source
/// IEC 61400-4 and ISO 6336-1:2019 with a floating member; 1.15 is a value of practice.
pub fn load_sharing(planets: u32, floating: Floating) -> Result<f64, Error> {
    let rigid = if floating == Floating::No { RIGID } else { 1.0 };
    match planets {
        0 => Err(Error::NotPositive { quantity: Quantity::Planets, value: 0.0, unit: "planets" }),
        1 => Ok(1.0),
        _ => SHARING.get(planets.saturating_sub(3) as usize).map(|factor| factor * rigid).ok_or(
            Error::MissingFactor {
                symbol: Symbol::LoadSharing,
                because: "its table ends at 7 planets; give it",
            },
        ),
    }
}

impl Floating {
    /// Source of the value of [`load_sharing`].
    #[must_use]
    pub(crate) const fn reference(self) -> Reference {
        Reference::new(
            Document::Iec61400Part4,
            match self {
                Self::Assumed => "load sharing of planets, a floating member assumed",
                Self::Yes => "load sharing of planets with a floating member",
                Self::No => "load sharing of planets, × 1.15 without a floating member",
            },
        )
    }
}

/// Masses that swing in a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Arrangement {
    /// Two gears.
    Pair,
    /// A sun, the first gear, with its number of planets.
    SunAndPlanets(u32),
    /// A planet, the first gear, in a ring that does not swing.
    PlanetInRing,
}

/// Data of method B for `K_v`, `K_Hα` and `K_Fα`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dynamics {
    /// Masses that swing.
    pub arrangement: Arrangement,
    /// Base pitch deviations `f_pb` of both gears.
    pub pitch_deviations: [Length; 2],
    /// Profile form deviations `f_fα` of both gears.
    pub profile_deviations: [Length; 2],
    /// Tip relief `C_a`; none, or of gears coarser than accuracy grade 5, `None`.
    pub tip_relief: Option<Length>,
    /// Inside diameters `d_i` of the gears' rims, `None` of solid ones; of a ring its outside diameter.
    pub rims: [Option<Length>; 2],
    /// Gear blank factor `C_R`.
    pub blank_factor: f64,
}

/// Load factors of a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadFactors {
    /// `K_A`.
    pub application: Factor,
    /// `K_γ`.
    pub sharing: Factor,
    /// `K_v`.
    pub dynamic: Factor,
    /// `K_Hβ`.
    pub face_contact: Factor,
    /// `K_Hα`.
    pub transverse_contact: Factor,
    /// `K_Fβ`.
    pub face_root: Factor,
    /// `K_Fα`.
    pub transverse_root: Factor,
}

impl LoadFactors {
    fn common(&self) -> f64 {
        self.application.value * self.sharing.value * self.dynamic.value
    }

    pub(crate) fn contact(&self) -> f64 {
        (self.common() * self.face_contact.value * self.transverse_contact.value).sqrt()
    }

    pub(crate) fn root(&self) -> f64 {
        self.common() * self.face_root.value * self.transverse_root.value
    }
}

/// A mesh as its load factors see it.
pub(crate) struct Swinging<'a> {
    pub(crate) pair: &'a Pair,
    pub(crate) module_mm: f64,
    pub(crate) materials: [&'a Material; 2],
    pub(crate) transverse: f64,
    pub(crate) overlap: f64,
    /// m/s.
    pub(crate) speed: f64,
    /// Helix angle at the base cylinder, rad.
    pub(crate) base_helix: f64,
}

/// `K_v` and the reference of its formula.
pub(crate) struct DynamicFactor {
    pub(crate) value: f64,
    pub(crate) reference: Reference,
}

const fn part1(place: &'static str) -> Reference {
    Reference::new(Document::Iso6336Part1, place)
}

/// `N_F` of the tooth heights and the face width, mm.
pub(crate) fn face_exponent(heights: [f64; 2], face_width: f64) -> f64 {
    let ratio = (heights[0].max(heights[1]) / face_width).min(1.0 / 3.0);
    1.0 / (1.0 + ratio + ratio * ratio)
}

/// Running-in allowance of a deviation, µm.
fn running_in(material: &Material, speed: f64, deviation: f64) -> f64 {
    let limit = material.contact_limit.mpa();
    match material.class {
        Class::Structural | Class::ThroughHardened | Class::NodularPearlitic | Class::Malleable => {
            let most = most_running_in(speed, 12_800.0 / limit);
            (160.0 / limit * deviation).min(most)
        }
        Class::GreyIron | Class::NodularFerritic => (0.275 * deviation).min(most_running_in(speed, 22.0)),
        Class::CaseHardened
        | Class::SurfaceHardened
        | Class::Nitrided
        | Class::ThroughHardenedNitrided
        | Class::Nitrocarburized => (0.075 * deviation).min(3.0),
    }
}

fn most_running_in(speed: f64, at_ten: f64) -> f64 {
    if speed <= 5.0 {
        f64::INFINITY
    } else if speed <= 10.0 {
        at_ten
    } else {
        at_ten / 2.0
    }
}

/// `q'` with one gear as the pinion: `z_n` over `narrowing` teeth, and shifts.
fn flexibility([pinion, wheel]: [&InvoluteGear; 2], narrowing: f64) -> f64 {
    let (x1, x2) = (pinion.shift(), wheel.shift());
    let per_tooth = |gear: &InvoluteGear| match gear.kind() {
        GearKind::External => narrowing / gear.teeth().as_f64(),
        GearKind::Internal => 0.0,
    };
    let (per_z1, per_z2) = (per_tooth(pinion), per_tooth(wheel));
    0.04723 + 0.15551 * per_z1 + 0.25791 * per_z2
        - 0.00635 * x1
        - 0.11654 * x1 * per_z1
        - 0.00193 * x2
        - 0.24188 * x2 * per_z2
        + 0.00529 * x1 * x1
        + 0.00182 * x2 * x2
}

/// `c'` of Young's moduli, N/mm².
fn single_stiffness(pair: &Pair, moduli: [f64; 2], base_helix: f64, blank_factor: f64) -> Result<f64, Error> {
    let blank = positive(Quantity::BlankFactor, blank_factor, "")?;
    let [first, second] = pair.gears();
    let helix = first.profile().helix_angle.si();
    let narrowing = libm::cos(base_helix).powi(2) * libm::cos(helix);
    let q = match first.teeth().cmp(&second.teeth()) {
        Ordering::Less => flexibility([first, second], narrowing),
        Ordering::Greater => flexibility([second, first], narrowing),
        // Neither is the pinion.
        Ordering::Equal => {
            f64::midpoint(flexibility([first, second], narrowing), flexibility([second, first], narrowing))
        }
    };
    let rack = |gear: &InvoluteGear| {
        let rack = &gear.profile().rack;
        let depth = rack.addendum + rack.clearance;
        (1.0 + 0.5 * (1.2 - depth)) * (1.0 - 0.02 * (20.0 - rack.pressure_angle.si().to_degrees()))
    };
    let [e1, e2] = moduli;
    let elasticity = 2.0 * e1 * e2 / (e1 + e2) / STEEL;
    Ok(0.8 * blank * f64::midpoint(rack(first), rack(second)) * libm::cos(helix) / q * elasticity)
}

/// `c_γα` of `c'` and `ε_α`.
fn whole_stiffness(single: f64, transverse: f64) -> f64 {
    single * (0.75 * transverse + 0.25)
}

/// Mean stiffness of a mesh of two steel gears along its line of action, `c_γα·b`.
///
/// | symbol | argument | meaning | unit |
/// |---|---|---|---|
/// | `b` | `face_width` | common face width | m |
///
/// It holds from a line load of 100 N/mm; below, the standard takes less. Gears are solid discs, `C_R = 1`.
///
/// # Errors
/// [`Error::NotPositive`] for the face width.
///
/// # Source
/// ISO 6336-1:2006, clause 9: see the [module](self).
pub fn mesh_stiffness(pair: &Pair, face_width: Length) -> Result<SurfaceTension, Error> {
    let width_mm = positive(Quantity::FaceWidth, face_width.mm(), "mm")?;
    let base_helix = pair.gears()[0].profile().base_helix_rad();
    let single = single_stiffness(pair, [STEEL; 2], base_helix, 1.0)?;
    let stiffness_n_um = whole_stiffness(single, pair.transverse_contact_ratio()) * width_mm;
    Ok(SurfaceTension::from_si(stiffness_n_um * 1e6))
}

impl Swinging<'_> {
    /// Deviation of the mesh after running-in, µm.
    fn left(&self, deviations: [Length; 2], quantity: Quantity) -> Result<f64, Error> {
        let [first, second] = deviations.map(Physical::um);
        let deviation = not_negative(quantity, first, "µm")?.max(not_negative(quantity, second, "µm")?);
        let [one, other] = self.materials.map(|material| running_in(material, self.speed, deviation));
        Ok(deviation - f64::midpoint(one, other))
    }

    /// `c'`.
    pub(crate) fn single_stiffness(&self, blank_factor: f64) -> Result<f64, Error> {
        let moduli = self.materials.map(|material| material.youngs_modulus.mpa());
        single_stiffness(self.pair, moduli, self.base_helix, blank_factor)
    }

    /// `c_γα`.
    fn mesh_stiffness(&self, single: f64) -> f64 {
        whole_stiffness(single, self.transverse)
    }

    /// `m_red`.
    fn reduced_mass(&self, dynamics: &Dynamics) -> Result<f64, Error> {
        let [first, second] = self.pair.gears();
        let external = |gear: &InvoluteGear, material: &Material, rim: Option<Length>| {
            let mean = f64::midpoint(gear.tip_diameter(), gear.root_diameter()) * self.module_mm;
            let bore = rim.map_or(0.0, Physical::mm);
            if !(0.0..mean).contains(&bore) {
                return Err(Error::OutOfRange {
                    quantity: Quantity::Bore,
                    value: bore,
                    low: 0.0,
                    high: mean,
                    unit: "mm",
                });
            }
            let base = gear.base_diameter() * self.module_mm;
            Ok(PI / 8.0 * material.density.si() / MM3_IN_M3 * (mean.powi(4) - bore.powi(4)) / (base * base))
        };
        let [own, mate] = self.materials;
        let one = external(first, own, dynamics.rims[0])?;
        match dynamics.arrangement {
            Arrangement::PlanetInRing => Ok(one),
            Arrangement::SunAndPlanets(0) => {
                Err(Error::NotPositive { quantity: Quantity::Planets, value: 0.0, unit: "planets" })
            }
            Arrangement::SunAndPlanets(planets) => {
                let other = external(second, mate, dynamics.rims[1])?;
                Ok(one * other / (one + f64::from(planets) * other))
            }
            Arrangement::Pair if self.pair.is_internal() => {
                let mean = f64::midpoint(second.tip_diameter(), second.root_diameter()) * self.module_mm;
                let outside = dynamics.rims[1].map(Physical::mm).filter(|outside| *outside > mean).ok_or(
                    Error::NotAbove {
                        quantity: Quantity::RingOutside,
                        value: dynamics.rims[1].map_or(0.0, Physical::mm),
                        low: mean,
                        unit: "mm",
                    },
                )?;
                let base = second.base_diameter() * self.module_mm;
                let other = PI / 8.0 * mate.density.si() / MM3_IN_M3 * (outside.powi(4) - mean.powi(4))
                    / (base * base);
                Ok(one * other / (one + other))
            }
            Arrangement::Pair => {
                let other = external(second, mate, dynamics.rims[1])?;
                Ok(one * other / (one + other))
            }
        }
    }

    /// `N`, of the first gear's speed, rpm, and `c'`.
    fn resonance_ratio(&self, dynamics: &Dynamics, speed_rpm: f64, single: f64) -> Result<f64, Error> {
        let stiffness = self.mesh_stiffness(single);
        let resonance = 30_000.0 / (PI * self.pair.gears()[0].teeth().as_f64())
            * (stiffness / self.reduced_mass(dynamics)?).sqrt();
        Ok(speed_rpm / resonance)
    }

    /// `K_v`, of the first gear's speed, rpm, the line load, N/mm, and `c'`.
    pub(crate) fn dynamic_factor(
        &self,
        dynamics: &Dynamics,
        speed_rpm: f64,
        line_load: f64,
        single: f64,
    ) -> Result<DynamicFactor, Error> {
        if line_load.is_nan() || line_load < LEAST_LINE_LOAD {
            return Err(Error::MissingFactor {
                symbol: Symbol::Dynamic,
                because: "below a line load of 100 N/mm method B is not offered; give it",
            });
        }
        let total = self.transverse + self.overlap;
        if total <= 1.0 {
            return Err(Error::NotAbove {
                quantity: Quantity::TotalContactRatio,
                value: total,
                low: 1.0,
                unit: "",
            });
        }
        let n = self.resonance_ratio(dynamics, speed_rpm, single)?;
        let b_p = single * self.left(dynamics.pitch_deviations, Quantity::PitchDeviation)? / line_load;
        let b_f = single * self.left(dynamics.profile_deviations, Quantity::ProfileDeviation)? / line_load;
        let b_k = match dynamics.tip_relief {
            Some(relief) => {
                (1.0 - single * not_negative(Quantity::TipRelief, relief.um(), "µm")? / line_load).abs()
            }
            None => 1.0,
        };
        let c = Constants::of(total);
        let below = 1.0 + n * (c.v1 * b_p + c.v2 * b_f + c.v3 * b_k);
        let resonant = 1.0 + c.v1 * b_p + c.v2 * b_f + c.v4 * b_k;
        let above = c.v5 * b_p + c.v6 * b_f + c.v7;
        let (value, place) = if n <= 0.85 {
            (below, "formula (14)")
        } else if n <= 1.15 {
            (resonant, "formula (20)")
        } else if n < 1.5 {
            (above + (resonant - above) * (1.5 - n) / 0.35, "formula (22)")
        } else {
            (above, "formula (21)")
        };
        Ok(DynamicFactor { value, reference: part1(place) })
    }

    /// `K_Hα` and `K_Fα`, of `F_t·K_A·K_γ·K_v·K_Hβ/b`, N/mm, `Z_ε`, and `c'`.
    pub(crate) fn transverse_factors(
        &self,
        dynamics: &Dynamics,
        load: f64,
        z_epsilon: f64,
        single: f64,
    ) -> Result<[f64; 2], Error> {
        let stiffness = self.mesh_stiffness(single);
        let q = stiffness * self.left(dynamics.pitch_deviations, Quantity::PitchDeviation)? / load;
        let total = self.transverse + self.overlap;
        let raw = if total <= 2.0 {
            total / 2.0 * (0.9 + 0.4 * q)
        } else {
            0.9 + 0.4 * (2.0 * (total - 1.0) / total).sqrt() * q
        };
        let most =
            [total / (self.transverse * z_epsilon * z_epsilon), total / (0.25 * self.transverse + 0.75)];
        Ok(most.map(|most| raw.min(most).max(1.0)))
    }
}

/// Young's modulus of steel, N/mm².
const STEEL: f64 = 206_000.0;

const MM3_IN_M3: f64 = 1e9;

/// N/mm.
const LEAST_LINE_LOAD: f64 = 100.0;

/// `C_v1` to `C_v7`.
struct Constants {
    v1: f64,
    v2: f64,
    v3: f64,
    v4: f64,
    v5: f64,
    v6: f64,
    v7: f64,
}

impl Constants {
    /// Constants for a total contact ratio above 1.
    fn of(total: f64) -> Self {
        let v7 = if total <= 1.5 {
            0.75
        } else if total <= 2.5 {
            0.125 * libm::sin(PI * (total - 2.0)) + 0.875
        } else {
            1.0
        };
        if total <= 2.0 {
            Self { v1: 0.32, v2: 0.34, v3: 0.23, v4: 0.90, v5: 0.47, v6: 0.47, v7 }
        } else {
            Self {
                v1: 0.32,
                v2: 0.57 / (total - 0.3),
                v3: 0.096 / (total - 1.56),
                v4: (0.57 - 0.05 * total) / (total - 1.44),
                v5: 0.47,
                v6: 0.12 / (total - 1.74),
                v7,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn load_sharing_is_that_of_a_floating_member_and_more_without() {
        let of = |planets| load_sharing(planets, Floating::Yes).unwrap();
        assert_eq!([1, 2, 3, 4, 5, 6, 7].map(of), [1.0, 1.10, 1.10, 1.25, 1.35, 1.44, 1.47]);
        for planets in 1..=7 {
            let [assumed, rigid] =
                [Floating::Assumed, Floating::No].map(|floating| load_sharing(planets, floating).unwrap());
            assert_eq!(assumed, of(planets));
            let more = if planets == 1 { 1.0 } else { 1.15 };
            assert!((rigid / of(planets) - more).abs() < 1e-15);
        }
        assert_eq!(load_sharing(0, Floating::Yes).unwrap_err().name(), "not-positive");
        assert_eq!(load_sharing(8, Floating::Yes).unwrap_err().name(), "missing-factor");
        assert_eq!(MOST_SHARING, 7);
    }

    #[test]
    fn constants_join_where_the_contact_ratio_passes_2() {
        let [below, above] = [2.0, 2.000_001].map(Constants::of);
        for (one, other) in
            [(below.v2, above.v2), (below.v3, above.v3), (below.v4, above.v4), (below.v6, above.v6)]
        {
            // The standard's columns are fits: they differ by 5 to 7 hundredths there.
            assert!((one - other).abs() < 0.07 * one, "{one} {other}");
        }
        assert!(
            (Constants::of(1.500_001).v7 - 0.75).abs() < 1e-5 && (Constants::of(2.5).v7 - 1.0).abs() < 1e-9
        );
    }

    #[test]
    fn wide_faces_hand_the_whole_factor_to_the_root() {
        assert!((face_exponent([1.0, 0.5], 1e9) - 1.0).abs() < 1e-8);
        assert_eq!(face_exponent([1.0, 0.5], 1.0), face_exponent([1.0, 0.5], 3.0));
    }
}
