//! Vibration of planetary sets on the page of a gearbox.

use crate::analyze::answer::gear::OneGear;
use crate::page::sheet::{Arrangement, Block, Section};
use crate::table::quantities::words;
use crate::table::text::Error;
use crate::vibrate::answer::Vibration;
use crate::vibrate::answer::records::{MeshResponse, Response};
use crate::vibrate::table::{Chapter, campbell, chapter, response, shapes, torsional_campbell};
use epicyclic_drawing::Scene;
use epicyclic_pictures as pictures;
use epicyclic_units::Dimension::{AngularSpeed, Force, Torque};

/// Field of a Campbell diagram that spans a page, with the names of its orders.
const CAMPBELL_MM: [f64; 2] = [130.0, 90.0];
/// Field of the plot of forces.
const FORCES_MM: [f64; 2] = [150.0, 70.0];

/// Effects that the calculation leaves out.
pub(crate) const LEFT_OUT: &str = "Vibration: gaps, friction, the change of the stiffness of a mesh over time, tilting and axial motion; the housing is rigid.";

/// Sections for frequencies and kinds, modes, resonances and forces, as far as the answer has them.
pub(crate) fn sections(all: &Vibration) -> Result<Vec<Section>, Error> {
    let whole = if all.coupled.is_empty() {
        "The torsional frequencies are of the whole gearbox."
    } else {
        "The torsional and the coupled frequencies are of the whole gearbox."
    };
    let about = format!(
        "Each set as bodies on springs, planar: central gears, carrier and planets (Lin and Parker, 1999). A centre without a stated support is \
         held. {whole}"
    );
    let mut sections = vec![rows(
        "Vibration: natural frequencies",
        &about,
        vec![Block::Answer(chapter(all, Chapter::Frequencies))],
    )];
    let mut modes = vec![];
    for place in 0..all.sets.len() {
        if let Some((title, of_set)) = shapes(all, place) {
            let caption = format!("{title}.");
            modes.push(Block::picture(drawn(pictures::modes::scene(&title, &of_set))?, caption));
        }
    }
    if !modes.is_empty() {
        let about = "What the bodies do in each mode, seen along the axis, enlarged: at rest grey, sun red, ring blue, planets green, the circle of the \
                     carrier dash-dotted; a mark on each shows its rotation. Circles are base circles. Of several modes of one frequency one is drawn.";
        sections.push(rows("Vibration: modes", about, modes));
    }
    let resonances = chapter(all, Chapter::Resonances);
    if !resonances.parts.is_empty() {
        let mut blocks = vec![];
        let of_sets = (0..all.campbell.len()).map(|place| campbell(all, place));
        let of_gears = (0..all.torsional.len()).map(|place| torsional_campbell(all, place));
        for picture in of_sets.chain(of_gears).flatten() {
            let caption =
                format!("{}: frequencies over the speed, orders as rays, resonances as dots.", picture.title);
            let picture = pictures::campbell::Campbell { size_mm: CAMPBELL_MM, is_untitled: true, ..picture };
            blocks.push(Block::picture(drawn(picture.scene())?, caption));
        }
        blocks.push(Block::Answer(resonances));
        let about = "What excites each set in each gear, in axes on its carrier, and the speeds of the input at which it has the frequency of a mode that \
                     the phases of the planets let it excite; and the same of the torsional modes of the whole gearbox.";
        sections.push(rows("Vibration: resonances", about, blocks));
    }
    if !all.responses.is_empty() {
        let mut blocks = vec![];
        for place in 0..all.responses.len() {
            if let Some(plot) = response(all, place) {
                let caption = format!("{}.", plot.title);
                blocks.push(Block::picture(drawn(plot.sized(FORCES_MM).untitled().scene())?, caption));
            }
        }
        blocks.push(Block::Answer(chapter(all, Chapter::Forces)));
        let about = "Forces beside the mean ones that the stated transmission error makes in the meshes.";
        sections.push(rows("Vibration: forces by the transmission error", about, blocks));
    }
    Ok(sections)
}

/// Greatest force for the first page; `None` without forces.
pub(crate) fn in_short(all: &Vibration) -> Option<String> {
    let (response, mesh) =
        forces(all).max_by(|one, other| one.1.greatest.force_n.total_cmp(&other.1.greatest.force_n))?;
    let (mesh, greatest) = (&mesh.mesh, mesh.greatest);
    Some(format!(
        "Vibration: the transmission error makes at most {} in a mesh of the {mesh}, in set {} in gear {} at {} of the input.",
        words(Force, greatest.force_n, 3),
        response.set,
        response.gear,
        words(AngularSpeed, greatest.input_speed_rad_s, 4),
    ))
}

/// Objections: resonances at which the flanks separate at the load of the operating point.
pub(crate) fn objections(all: &Vibration, gears: &[OneGear]) -> Vec<String> {
    let mut told: Vec<String> = vec![];
    for response in &all.responses {
        let gear = gears.iter().find(|gear| gear.gear.gear == response.gear);
        let member = |name: &str| {
            let is_own = |set: &str, member: &str| set == response.set && member == name;
            gear?.members.iter().find(|one| is_own(&one.set, &one.member))?.torque_n_m.map(f64::abs)
        };
        // Meshes whose flanks part at the load, the worst one last.
        let own = forces(all).filter(|(other, _)| std::ptr::eq(*other, response));
        let parting = own.filter_map(|(_, mesh)| {
            let (name, below) = (mesh.torque_on.as_deref()?, mesh.greatest.parts_below_torque_n_m?);
            let load = member(name).filter(|load| below > *load)?;
            Some((below / load, below, load, name, mesh))
        });
        let Some((_, below, load, name, mesh)) = parting.max_by(|one, other| one.0.total_cmp(&other.0))
        else {
            continue;
        };
        told.push(format!(
            "set {} in gear {}: at {} of the input the flanks of the {} part below {} on the {name}; the load is {}",
            response.set,
            response.gear,
            words(AngularSpeed, mesh.greatest.input_speed_rad_s, 4),
            mesh.mesh,
            words(Torque, below, 3),
            words(Torque, load, 3),
        ));
    }
    told
}

/// Greatest forces of every harmonic and mesh.
fn forces(all: &Vibration) -> impl Iterator<Item = (&Response, &MeshResponse)> {
    all.responses.iter().flat_map(|response| {
        let meshes = response.harmonics.iter().flat_map(|harmonic| &harmonic.meshes);
        meshes.map(move |mesh| (response, mesh))
    })
}

fn rows(heading: &str, about: &str, mut blocks: Vec<Block>) -> Section {
    blocks.insert(0, Block::words(about));
    Section::new(heading, blocks).arranged(Arrangement::Rows)
}

fn drawn(scene: Result<Scene, epicyclic_drawing::Error>) -> Result<Scene, Error> {
    Ok(scene.map_err(pictures::Error::from)?)
}
