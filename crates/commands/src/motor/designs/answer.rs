//! What both searches for hydromotors share: designs listed, a design as a motor in its size.

use crate::error::Error;
use crate::motor::answer::{Chosen, Designed, Groups, Made, Point, saved};
use crate::shared::number::si;
use epicyclic_formats::motor::MaterialGroup;
use epicyclic_hydromotor::closure::Family;
use epicyclic_hydromotor::profile::{Profile, ToothForm};
use epicyclic_hydromotor::search::Requirements;
use epicyclic_hydromotor::{Motor, MotorNumbers};
use std::collections::HashSet;
use uom::si::f64::{Angle, Length};

/// The designs that are shown, with their places, and how many are not.
pub(crate) struct Listed<'d, Design> {
    pub(crate) shown: Vec<(usize, &'d Design)>,
    pub(crate) hidden: usize,
}

impl<'d, Design> Listed<'d, Design> {
    /// Of designs in their order: all, or the first of each set of numbers, and of these so many at most.
    pub(crate) fn of(
        designs: &'d [Design],
        first_of_each_set: bool,
        most: usize,
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

/// A design by its number, from 1, and the size that is shown of it.
pub(crate) fn nth<Design, Size>(
    designs: &[Design],
    number: usize,
    size: impl Fn(&Design) -> Option<&Size>,
) -> Result<(&Design, &Size), Error> {
    let design = number.checked_sub(1).and_then(|place| designs.get(place));
    let found = design.and_then(|design| Some((design, size(design)?)));
    found.ok_or(Error::NoSuchDesign { design: number, designs: designs.len() })
}

/// The motor of a design, for drawings.
pub(crate) struct Drawn<'a> {
    pub(crate) motor: Motor,
    pub(crate) form: ToothForm,
    pub(crate) width: Length,
    pub(crate) angle: Angle,
    pub(crate) made: &'a Groups,
}

impl Drawn<'_> {
    /// With what is wanted of it.
    pub(crate) fn designed(self, requirements: &Requirements) -> Result<Designed, Error> {
        let Self { motor, form, angle, made, .. } = self;
        let (width, pressure, speed) = (Some(self.width), requirements.pressure_drop, requirements.speed);
        let family = motor.arcs().map(|_| Family::new(motor.numbers(), motor.module())).transpose()?;
        Ok(Designed {
            made: Made::of(&motor, made, Point { form, width, pressure, speed })?,
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

/// Which design of a search a motor is.
pub(crate) struct Origin {
    /// From 1.
    pub(crate) design: usize,
    /// How many there are.
    pub(crate) of: usize,
    /// The command that found it.
    pub(crate) by: &'static str,
}

impl Origin {
    /// Its file, with the material of its teeth where one is given.
    pub(crate) fn saved(
        &self,
        designed: &Designed,
        material: Option<&MaterialGroup>,
    ) -> Result<String, Error> {
        let Self { design, of, by } = self;
        let numbers = designed.motor.numbers();
        let title = format!("Hydromotor {}×{}", numbers.stator_lobes(), numbers.rotor_lobes());
        saved::file(designed, material, &title, &format!("Design {design} of {of} found by epicyclic {by}."))
    }
}

/// Of sizes with their width and diameter the one whose width is nearest to half its diameter.
pub(crate) fn nearest_half<T>(sizes: &[T], of: impl Fn(&T) -> [Length; 2]) -> Option<&T> {
    let off = |size: &&T| {
        let [width, diameter] = of(size).map(si);
        (width / diameter - 0.5).abs()
    };
    sizes.iter().min_by(|one, other| off(one).total_cmp(&off(other)))
}
