//! Parts that the description of a compound set names.

use crate::compound::{CentralKind, CompoundSpec, GearName};
use crate::error::{CompoundFault, MeshFault, Place};
use crate::names::nearest;
use crate::planet_set::{Central, GearOf, Mesh, MeshKind, Parts, Planet};
use crate::site::{SetFaults, SetPart};
use crate::tolerance::{MOST_MEMBERS, MOST_PLANETS};
use crate::{Error, Gearbox, LinkId, Named};
use epicyclic_gears::teeth::ToothCount;

/// The parts that a compound description names.
pub(super) fn parts_of_compound(gearbox: &Gearbox, spec: &CompoundSpec) -> Result<Parts, SetFaults> {
    let fault = |fault| Error::Compound { set: spec.id.clone(), fault };
    let counts = [
        (Named::Member, spec.centrals.len(), MOST_MEMBERS, SetPart::Central(MOST_MEMBERS)),
        (Named::Planet, spec.planets.len(), MOST_PLANETS, SetPart::Planet(MOST_PLANETS)),
        (
            Named::Mesh,
            spec.meshes.len(),
            MOST_MEMBERS + MOST_PLANETS,
            SetPart::Mesh(MOST_MEMBERS + MOST_PLANETS),
        ),
    ];
    let beyond = counts.into_iter().filter(|(_, count, limit, _)| count > limit);
    let mut faults: SetFaults =
        beyond.map(|(what, count, limit, part)| (part, Error::TooMany { what, count, limit })).collect();
    if spec.centrals.len() < 2 {
        faults.push((SetPart::Whole, fault(CompoundFault::TooFewMembers { given: spec.centrals.len() })));
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let mut refuse = |part, of_part| faults.push((part, fault(of_part)));
    let mut gears: Vec<(GearName, GearOf, SetPart)> = vec![];
    let mut planets = vec![];
    for (place, planet) in spec.planets.iter().enumerate() {
        let (part, name) = (SetPart::Planet(place), &planet.name);
        let given = planet.teeth.len();
        if given > MOST_PLANETS {
            refuse(part, CompoundFault::PlanetGears { planet: name.clone(), given, most: MOST_PLANETS });
        } else if spec.proportional && given > 0 {
            refuse(part, CompoundFault::PlanetTeeth { planet: name.clone() });
        }
        let mut counts = vec![];
        if planet.teeth.is_empty() {
            counts.push(None);
            gears.push((GearName::only(name), GearOf::Planet(place, 0), part));
        }
        for (step, &count) in planet.teeth.iter().take(MOST_PLANETS).enumerate() {
            let step_of_several = (given > 1).then_some(step + 1);
            let gear = GearName { of: name.clone(), step: step_of_several };
            let count = ToothCount::new(count).ok();
            if count.is_none() {
                refuse(SetPart::PlanetGear(place, step), CompoundFault::NoTeeth { gear: gear.clone() });
            }
            counts.push(count);
            gears.push((gear, GearOf::Planet(place, step), part));
        }
        planets.push(Planet { name: name.clone(), gears: counts });
    }
    let mut unknown_links = vec![];
    let mut centrals: Vec<Central> = vec![];
    for (place, central) in spec.centrals.iter().enumerate() {
        let (part, given) = (SetPart::Central(place), central.teeth);
        let link = gearbox.known_link(&central.link, || Place::Set(spec.id.clone()));
        let link = link.map_err(|error| unknown_links.push((part, error))).unwrap_or(LinkId::GROUND);
        let gear = GearName::only(&central.name);
        let (mut teeth, mut body) = (None, place);
        match (&central.planet, central.kind) {
            (Some(name), CentralKind::PlanetShaft) => {
                match spec.planets.iter().position(|planet| planet.name == *name) {
                    Some(planet) => body = spec.centrals.len() + planet,
                    None => {
                        let among = spec.planets.iter().map(|planet| planet.name.as_str());
                        let suggestion = nearest(name, among);
                        refuse(part, CompoundFault::UnknownGear { name: name.clone(), suggestion });
                    }
                }
            }
            _ if spec.proportional => {}
            _ if given.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&given) => {
                teeth = ToothCount::new(given as u32).ok();
                if teeth.is_none() {
                    refuse(part, CompoundFault::NoTeeth { gear: gear.clone() });
                }
            }
            _ => refuse(part, CompoundFault::NotWhole { gear: gear.clone(), given }),
        }
        if centrals.iter().any(|other| other.body == body) {
            let planet = central.planet.clone().unwrap_or_default();
            refuse(part, CompoundFault::TwoShafts { name: central.name.clone(), planet });
        }
        let proportion = (spec.proportional && central.planet.is_none()).then_some(given);
        if proportion.is_some_and(|given| !(given > 0.0 && given.is_finite())) {
            refuse(part, CompoundFault::Proportion { gear: gear.clone(), given });
        }
        gears.push((gear, GearOf::Central(place), part));
        centrals.push(Central { link, kind: central.kind, teeth, proportion, body });
    }
    // Names that meshes use: `long.2` may be a step of a planet or a central gear.
    let spelt: Vec<String> = gears.iter().map(|(name, ..)| name.to_string()).collect();
    let bodies = spec.planets.iter().enumerate().filter(|(_, planet)| !spelt.contains(&planet.name));
    let bodies =
        bodies.map(|(place, one)| (one.name.as_str(), GearName::only(&one.name), SetPart::Planet(place)));
    let named =
        spelt.iter().zip(&gears).map(|(spelt, (name, _, part))| (spelt.as_str(), name.clone(), *part));
    let mut names = std::collections::BTreeSet::new();
    for (_, name, part) in named.chain(bodies).filter(|(spelling, ..)| !names.insert(*spelling)) {
        refuse(part, CompoundFault::NameTwice { name });
    }
    let mut meshes = vec![];
    for (place, mesh) in spec.meshes.iter().enumerate() {
        let [first, second] = &mesh.between;
        let mut gear = |end: usize| {
            let name = &mesh.between[end];
            let known = spelt.iter().position(|spelling| spelling == name);
            if known.is_none() {
                let suggestion = nearest(name, spelt.iter().map(String::as_str));
                let unknown = CompoundFault::UnknownGear { name: name.clone(), suggestion };
                refuse(SetPart::MeshGear(place, end), unknown);
            }
            known.map(|known| gears[known].1)
        };
        let (Some(one), Some(other)) = (gear(0), gear(1)) else { continue };
        let pair = [one, other];
        let kind = match pair {
            [GearOf::Central(_), GearOf::Central(_)] => Err(MeshFault::TwoCentrals),
            [GearOf::Planet(one, _), GearOf::Planet(other, _)] if one == other => Err(MeshFault::OnePlanet),
            [GearOf::Planet(..), GearOf::Planet(..)] => Ok(MeshKind::External),
            [GearOf::Central(central), GearOf::Planet(planet, step)]
            | [GearOf::Planet(planet, step), GearOf::Central(central)] => match centrals[central].kind {
                CentralKind::Sun => Ok(MeshKind::External),
                CentralKind::Ring => match (centrals[central].teeth, planets[planet].gears[step]) {
                    (Some(ring), Some(planet)) if ring <= planet => Err(MeshFault::SmallRing),
                    _ => Ok(MeshKind::Internal),
                },
                CentralKind::BevelLeft => Ok(MeshKind::BevelLeft),
                CentralKind::BevelRight => Ok(MeshKind::BevelRight),
                CentralKind::PlanetShaft => Err(MeshFault::PlanetShaft),
            },
        };
        match kind {
            Ok(kind) => meshes.push(Mesh { gears: pair, kind, efficiency: mesh.efficiency }),
            Err(why) => {
                let (first, second) = (first.clone(), second.clone());
                refuse(SetPart::Mesh(place), CompoundFault::Mesh { first, second, why });
            }
        }
    }
    faults.extend(unknown_links);
    if !faults.is_empty() {
        return Err(faults);
    }
    let bodies = centrals.len() + planets.len();
    Ok(Parts {
        centrals,
        planets,
        meshes,
        factors: vec![None; bodies],
        exact: vec![None; bodies],
        rational: None,
        loss: None,
    })
}
