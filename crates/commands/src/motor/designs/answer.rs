//! Common parts of both searches for hydromotors: listed designs, and a design as a motor of a given size.

use crate::error::Error;
use crate::motor::answer::{Chosen, Designed, Groups, Inputs, Made, Point, saved};
use crate::shared::number::si;
use epicyclic_formats::motor::MaterialGroup;
use epicyclic_hydromotor::closure::Family;
use epicyclic_hydromotor::profile::{Profile, ToothForm};
use epicyclic_hydromotor::search::{Dimensions, Requirements};
use epicyclic_hydromotor::{Motor, MotorNumbers};
use std::collections::HashSet;
use uom::si::f64::{Angle, Length};

/// Designs of a search to list.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Listing {
    /// Whether only the first design of each set of lobes and teeth is listed.
    pub first_of_each_set: bool,
    /// Maximum number of designs listed.
    pub most: usize,
}

impl Default for Listing {
    /// All designs.
    fn default() -> Self {
        Self { first_of_each_set: false, most: usize::MAX }
    }
}

/// Finished search for motors: its answer, and the motor of each design. Designs are numbered from 1.
pub trait Searched {
    /// Record of the results.
    type Answer;

    /// Command of the search.
    const COMMAND: &'static str;

    /// Record of the results with these designs.
    fn answer(&self, listing: Listing) -> Self::Answer;

    /// Numbers of designs found, listed, and of further ones that are not listed.
    fn counts(answer: &Self::Answer) -> [usize; 3];

    /// Motor of a design in the size shown for it.
    ///
    /// # Errors
    /// [`Error::NoSuchDesign`].
    fn motor(&self, design: usize, angle: Angle) -> Result<Designed, Error>;

    /// Number of designs found.
    fn designs(&self) -> usize;

    /// Material of the teeth, if given.
    fn material(&self) -> Option<&MaterialGroup>;

    /// Motor file of a design in the size shown for it, with its origin and the material of its teeth.
    ///
    /// # Errors
    /// [`Error::NoSuchDesign`].
    fn saved(&self, design: usize) -> Result<String, Error> {
        let designed = self.motor(design, Angle::default())?;
        let numbers = designed.motor.numbers();
        let title = format!("Hydromotor {}×{}", numbers.stator_lobes(), numbers.rotor_lobes());
        let origin = format!("Design {design} of {} found by epicyclic {}.", self.designs(), Self::COMMAND);
        saved::file(&designed, self.material(), &title, &origin)
    }
}

/// Designs that are shown, with their places, and the number that is hidden.
pub(crate) struct Listed<'d, Design> {
    pub(crate) shown: Vec<(usize, &'d Design)>,
    pub(crate) hidden: usize,
}

impl<'d, Design> Listed<'d, Design> {
    /// Lists all designs in their order, or the first of each set of numbers, up to a maximum number.
    pub(crate) fn of(
        designs: &'d [Design],
        Listing { first_of_each_set, most }: Listing,
        numbers: impl Fn(&Design) -> MotorNumbers,
    ) -> Self {
        let mut seen = HashSet::new();
        let mut is_listed = |design: &Design| !first_of_each_set || seen.insert(numbers(design));
        let mut shown: Vec<_> = designs.iter().enumerate().filter(|(_, design)| is_listed(design)).collect();
        let hidden = shown.len().saturating_sub(most);
        shown.truncate(most);
        Self { shown, hidden }
    }
}

/// Design by its number, from 1, and the size that is shown for it.
pub(crate) fn nth<Design>(
    designs: &[Design],
    number: usize,
    size: impl Fn(&Design) -> Option<&Dimensions>,
) -> Result<(&Design, &Dimensions), Error> {
    let design = number.checked_sub(1).and_then(|place| designs.get(place));
    let found = design.and_then(|design| Some((design, size(design)?)));
    found.ok_or(Error::NoSuchDesign { design: number, designs: designs.len() })
}

/// Motor of a design, for drawings.
pub(crate) struct Drawn<'a> {
    pub(crate) motor: Motor,
    pub(crate) form: ToothForm,
    pub(crate) width: Length,
    pub(crate) angle: Angle,
    pub(crate) made: &'a Groups,
}

impl Drawn<'_> {
    /// Designs the motor at the pressure and speed of the requirements.
    pub(crate) fn designed(self, requirements: &Requirements) -> Result<Designed, Error> {
        let Self { motor, form, angle, made, .. } = self;
        let (width, pressure, speed) = (Some(self.width), requirements.pressure_drop, requirements.speed);
        let point = Point { form, width, pressure, speed };
        let family = motor.arcs().map(|_| Family::new(motor.numbers(), motor.module())).transpose()?;
        Ok(Designed {
            made: Made::of(&motor, &Inputs::of(made, point)?, point)?,
            profile: Profile::new(&motor, form),
            family,
            motor,
            chosen: Chosen::Given,
            form,
            width,
            pressure,
            speed,
            angle,
        })
    }
}

/// Finds the size whose width is closest to half its diameter.
pub(crate) fn nearest_half(sizes: &[Dimensions]) -> Option<&Dimensions> {
    let off = |size: &&Dimensions| (si(size.width) / si(size.outer_diameter) - 0.5).abs();
    sizes.iter().min_by(|one, other| off(one).total_cmp(&off(other)))
}
