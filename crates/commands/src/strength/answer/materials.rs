//! Materials of a file, and what else of its strength several answers read alike.

use crate::error::Error;
use crate::shared::fault::{Named, refused};
use crate::shared::gearbox::Gearbox;
use epicyclic_formats::gearbox::{FloatingEntry, GearboxFile, MaterialClass, MaterialEntry, StrengthEntry};
use epicyclic_formats::{Document, Path};
use epicyclic_strength::factor::Symbol;
use epicyclic_strength::load::Floating;
use epicyclic_strength::material::{self, Class, Material};
use epicyclic_units::Number;

/// Whether a member of a set floats.
pub(crate) const fn floating(entry: FloatingEntry) -> Floating {
    match entry {
        FloatingEntry::None => Floating::No,
        FloatingEntry::Sun | FloatingEntry::Ring | FloatingEntry::Carrier => Floating::Yes,
    }
}

/// Value of `K_γ` that is given for all meshes of a set, in any spelling of its symbol; before it that for
/// meshes of suns.
pub(crate) fn given_sharing(strength: &StrengthEntry) -> Option<f64> {
    let all = strength.sun_mesh_factors.iter().chain(&strength.factors);
    let own = |(name, value): (&String, &Number)| {
        (Symbol::named(name) == Some(Symbol::LoadSharing)).then(|| value.get())
    };
    all.filter_map(own).next()
}

/// Refuses materials of equal name, and cast iron without its modulus.
pub(super) fn check_materials(document: &Document, file: &GearboxFile) -> Result<(), Error> {
    for (place, own) in file.materials.iter().enumerate() {
        let path = Path::root().key("materials").index(place);
        let is_iron = matches!(
            own.class,
            MaterialClass::GreyIron
                | MaterialClass::NodularPearlitic
                | MaterialClass::NodularFerritic
                | MaterialClass::Malleable
        );
        let is_known = material::listed(&own.name).is_some();
        if is_known || file.materials[..place].iter().any(|other| other.name == own.name) {
            let message = format!("there is a material `{}`; this one needs another name", own.name);
            return Err(refused(document, &path, &["name"], &Named("duplicate", message)));
        }
        if is_iron && own.youngs_modulus.is_none() {
            let message = format!("material `{}`: cast iron needs its `youngs_modulus`", own.name);
            return Err(refused(document, &path, &["class"], &Named("no-youngs-modulus", message)));
        }
        of_entry(own).check().map_err(|error| refused(document, &path, &[], &error))?;
    }
    Ok(())
}

/// Material of a name: one of the file, or of the program's table; `at` is the path of the name.
pub(crate) fn material(
    subject: &Gearbox,
    file: &GearboxFile,
    at: &Path,
    name: &str,
) -> Result<Material, Error> {
    if let Some(own) = file.materials.iter().find(|own| own.name == name) {
        return Ok(of_entry(own));
    }
    material::listed(name).map(|listed| listed.material).ok_or_else(|| {
        let listed = material::all().into_iter().map(|listed| listed.designation);
        let all: Vec<&str> = file.materials.iter().map(|own| own.name.as_str()).chain(listed).collect();
        let message = format!(
            "no material is called `{name}`; there are {}, and those that `materials` of the gearbox states",
            all.join(", ")
        );
        refused(&subject.document, at, &[], &Named("no-material", message))
    })
}

fn of_entry(own: &MaterialEntry) -> Material {
    let class = match own.class {
        MaterialClass::Structural => Class::Structural,
        MaterialClass::ThroughHardened => Class::ThroughHardened,
        MaterialClass::GreyIron => Class::GreyIron,
        MaterialClass::NodularPearlitic => Class::NodularPearlitic,
        MaterialClass::NodularFerritic => Class::NodularFerritic,
        MaterialClass::Malleable => Class::Malleable,
        MaterialClass::CaseHardened => Class::CaseHardened,
        MaterialClass::SurfaceHardened => Class::SurfaceHardened,
        MaterialClass::Nitrided => Class::Nitrided,
        MaterialClass::ThroughHardenedNitrided => Class::ThroughHardenedNitrided,
        MaterialClass::Nitrocarburized => Class::Nitrocarburized,
    };
    let steel = Material::steel(class, own.contact_limit.0, own.root_limit.0);
    Material {
        hardness: own.hardness.map(Number::get),
        strength: own.strength.map(|strength| strength.0),
        youngs_modulus: own.youngs_modulus.map_or(steel.youngs_modulus, |modulus| modulus.0),
        ..steel
    }
}
