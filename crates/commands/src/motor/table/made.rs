//! Flanks under load, ports as made, leaks and friction of a motor as tables.

use super::{count, facts, maybe, one};
use crate::motor::answer::{
    AllowedPressure, Efficiency, Flanks, ForceAt, GoverningLimit, Losses, MadePorts, OpenTo, Port, PortState,
};
use crate::table::columns::Table;
use crate::table::figure::Figure;
use crate::table::quantities::{remarked, words};
use crate::table::report::{Part, Records, Row, Text};
use epicyclic_hydromotor::flanks::Push;
use epicyclic_hydromotor::ports::timing::AtExtreme;
use epicyclic_units::Dimension::{
    Angle, AngularSpeed, Area, Force, Length, Power, Pressure, Torque, Volume, VolumeRate,
};

fn push(push: Push) -> Figure {
    let words = match push {
        Push::Forward => "crest",
        Push::Back => "trough",
    };
    Figure::choice(push, words)
}

/// The ripple with satellites that seal where flanks touch.
pub(crate) fn flank_ripple(flanks: &Flanks) -> Row {
    Row::new("flank_ripple", "ripple at the flanks", "δ′", [Figure::Share(flanks.ripple)])
}

/// Sealing and forces, then stresses.
pub(crate) fn flanks(flanks: &Flanks) -> Vec<Part> {
    let mut rows = vec![
        count("loaded_satellites", "satellites that part the pressures", "2n", flanks.loaded_satellites),
        flank_ripple(flanks),
        Row::new(
            "least_over_mean",
            "least over mean torque there",
            "",
            [Figure::Multiple(flanks.least_over_mean)],
        ),
        one("least_at", "least with the rotor at", "", Angle, flanks.least_at_rad),
    ];
    rows.extend(maybe("flank_least_torque", "least torque there", "", Torque, flanks.least_torque_n_m));
    if let Some(forces) = &flanks.forces {
        let force = |name, label, symbol, at: ForceAt| one(name, label, symbol, Force, at.force_n);
        rows.push(force("force_by_crest", "greatest on a flank, by a crest", "N", forces.by_crest));
        rows.push(force("force_by_trough", "greatest on a flank, by a trough", "N", forces.by_trough));
        rows.push(force("stator_bound", "bound on the stator's flanks", "N₃", forces.stator_bound));
        rows.push(force("rotor_bound", "bound on the rotor's flanks", "N₁", forces.rotor_bound));
        let back = |name, label, at: Option<ForceAt>| at.map(|at| force(name, label, "", at));
        rows.extend(back("stator_back_bound", "bound on its back flanks, stator", forces.stator_back_bound));
        rows.extend(back("rotor_back_bound", "bound on its back flanks, rotor", forces.rotor_back_bound));
        rows.push(force("bearing_load", "greatest load of the rotor's bearing", "", forces.bearing_load));
    }
    rows.push(one(
        "effective_modulus",
        "effective modulus of the teeth",
        "E*",
        Pressure,
        flanks.effective_modulus_pa,
    ));
    let note = "Chambers are sealed where flanks touch, not at the pitch points. Bounds: the contacts where they are, one pair a mesh, rigid teeth; the back flank of a wheel holds the satellite.";
    let mut parts = vec![facts("flanks", "Flanks under load", rows, note)];
    if !flanks.contact.is_empty() {
        parts.push(Part::Records(contact(flanks)));
    }
    if !flanks.roots.is_empty() {
        parts.push(Part::Records(roots(flanks)));
    }
    if let Some(allowed) = &flanks.allowed {
        parts.push(facts("allowed_pressure", "Pressure that the shape allows", allowed_rows(allowed), ""));
    }
    parts
}

fn contact(flanks: &Flanks) -> Records {
    let note = "Greatest over the revolution. One pair: where no other pair of flanks shares the load; anywhere: all load on one pair, a bound. e: from the pitch point towards the \
                   satellite's base circle. Reported, not certified.";
    Table::new("contact_stresses", flanks.contact.iter())
        .words("wheel", "flanks of", |one| Figure::answer(one.wheel.words(), one.wheel.words()))
        .words("by", "by a", |one| push(one.by))
        .headed("at_pitch_point", "pitch point", Pressure, |one| one.at_pitch_point_pa)
        .headed("alone", "one pair", Pressure, |one| one.alone_pa)
        .quantity("alone_offset", "at e", Length, |one| one.alone_offset_m)
        .headed("on_path", "anywhere", Pressure, |one| one.on_path_pa)
        .quantity("on_path_offset", "at e", Length, |one| one.on_path_offset_m)
        .view(
            "Contact stress of Hertz, MPa",
            "wheel by at_pitch_point alone alone_offset on_path on_path_offset",
        )
        .note(note)
        .records()
}

fn roots(flanks: &Flanks) -> Records {
    let note = "Nominal bending after Lewis in the worst section of the generated tooth, without the notch; for stator and rotor a comparison of shapes.";
    Table::new("root_stresses", flanks.roots.iter())
        .words("wheel", "roots of", |one| Figure::answer(one.wheel.words(), one.wheel.words()))
        .headed("alone", "one pair", Pressure, |one| one.alone_pa)
        .headed("on_path", "anywhere", Pressure, |one| one.on_path_pa)
        .quantity("thickness", "section", Length, |one| one.thickness_m)
        .view("Bending at the roots, MPa", "wheel alone on_path thickness")
        .note(note)
        .records()
}

fn allowed_rows(allowed: &AllowedPressure) -> Vec<Row> {
    let governing = match allowed.governing {
        GoverningLimit::Contact => "contact governs",
        GoverningLimit::StatorRoot => "the stator's roots govern",
        GoverningLimit::RotorRoot => "the rotor's roots govern",
        GoverningLimit::SatelliteRoot => "the satellites' roots govern",
    };
    vec![
        remarked(one("allowed", "pressure drop allowed", "Δp", Pressure, allowed.pressure_pa), governing),
        one("by_contact", "by contact stress, one pair", "", Pressure, allowed.by_contact_pa),
        one("by_root", "by bending, one pair", "", Pressure, allowed.by_root_pa),
        one("allowed_on_path", "with all load on one pair anywhere", "", Pressure, allowed.on_path_pa),
    ]
}

fn port(name: [&'static str; 3], label: &'static str, port: &Port) -> Vec<Row> {
    let size = port.diameter_m.zip(port.pitch_radius_m).map_or_else(
        || {
            let kidney = port.inner_radius_m.zip(port.outer_radius_m).zip(port.span_rad);
            kidney.map_or_else(String::new, |((inner, outer), span)| {
                format!(
                    "kidney from radius {} to {}, {} long",
                    words(Length, inner, 4),
                    words(Length, outer, 4),
                    words(Angle, span, 4)
                )
            })
        },
        |(diameter, radius)| {
            format!("hole of {} at radius {}", words(Length, diameter, 4), words(Length, radius, 4))
        },
    );
    vec![
        remarked(one(name[0], label, "", Angle, port.angle_rad), size),
        one(name[1], "… area", "", Area, port.area_m2),
        one(name[2], "… widest opening of a chamber", "", Area, port.widest_opening_m2),
    ]
}

/// Ports, the cycle of a chamber, throttling.
pub(crate) fn ports(ports: &MadePorts) -> Vec<Part> {
    let mut rows = port(
        ["made_high_angle", "made_high_area", "high_widest"],
        "high-pressure port from the crest",
        &ports.high,
    );
    rows.extend(port(
        ["made_low_angle", "made_low_area", "low_widest"],
        "low-pressure port from the crest",
        &ports.low,
    ));
    rows.push(one("land", "land between both pressures", "", Length, ports.land_m));
    rows.push(one("cycle", "cycle of a chamber", "", Angle, ports.cycle_rad));
    let [least, greatest] = &ports.extremes;
    rows.push(one("least_bend", "bend of the chamber's area, least", "A″", Area, least.bend_m2));
    rows.push(one("greatest_bend", "bend of the chamber's area, greatest", "A″", Area, greatest.bend_m2));
    rows.extend(maybe(
        "precompression",
        "closed angle that compresses to Δp",
        "",
        Angle,
        least.precompression_rad,
    ));
    rows.extend(maybe("charge", "oil for compression a revolution", "", Volume, ports.charge_m3));
    rows.extend(
        ports
            .charge_share
            .map(|share| Row::new("charge_share", "of the displacement", "", [Figure::Share(share)])),
    );
    let mut parts = vec![facts("made_ports", "Ports as made", rows, ""), Part::Records(cycle(ports))];
    if !ports.throttling.is_empty() {
        parts.push(Part::Records(throttling(ports)));
    }
    parts
}

fn open_to(open: OpenTo) -> Figure {
    let words = match open {
        OpenTo::High => "high pressure",
        OpenTo::Low => "low pressure",
        OpenTo::Both => "BOTH: short circuit",
        OpenTo::Neither => "closed",
    };
    Figure::choice(open, words)
}

fn cycle(ports: &MadePorts) -> Records {
    let note = "Phases of a chamber, 0 where it is greatest. Changes: the greatest of the pressure since it closed, with the bulk modulus.";
    let closed = |state: &PortState| {
        ports.closed.iter().find(|one| state.open_to == OpenTo::Neither && one.from_rad == state.from_rad)
    };
    Table::new("port_states", ports.states.iter())
        .quantity("from", "from", Angle, |state| state.from_rad)
        .quantity("to", "to", Angle, |state| state.to_rad)
        .words("open_to", "open to", |state| open_to(state.open_to))
        .words("extreme", "about the", |state| {
            closed(state).and_then(|one| one.extreme).map_or(Figure::None, |extreme| match extreme {
                AtExtreme::Greatest => Figure::choice(extreme, "greatest"),
                AtExtreme::Least => Figure::choice(extreme, "least"),
            })
        })
        .headed("before", "before", Angle, |state| closed(state).map(|one| one.before_rad))
        .headed("after", "after", Angle, |state| closed(state).map(|one| one.after_rad))
        .quantity("change", "changes", Pressure, |state| closed(state).and_then(|one| one.change_pa))
        .view("Cycle of a chamber at its ports", "from to open_to extreme before after change")
        .note(note)
        .records()
}

fn throttling(ports: &MadePorts) -> Records {
    Table::new("throttling", ports.throttling.iter())
        .words("ports", "ports of", |one| open_to(one.ports))
        .quantity("smallest_opening", "least opening", Area, |one| one.smallest_opening_m2)
        .quantity("drop", "drop there", Pressure, |one| one.drop_pa)
        .headed("greatest_drop", "greatest", Pressure, |one| one.greatest_drop_pa)
        .quantity("power", "power", Power, |one| one.power_w)
        .view("Throttling by the ports", "ports smallest_opening drop greatest_drop power")
        .records()
}

/// Leaks, friction, efficiencies.
pub(crate) fn losses(losses: &Losses) -> Vec<Part> {
    let mut rows = vec![];
    if let Some(leakage) = &losses.leakage {
        rows.push(one("satellite_gap", "gap at a face of a satellite", "h", Length, leakage.satellite_gap_m));
        rows.push(one("rotor_gap", "gap at a face of the rotor", "", Length, leakage.rotor_gap_m));
        let law = |is_turbulent| if is_turbulent { "by your turbulent law" } else { "laminar" };
        let reynolds = |name, label, gap: &crate::motor::answer::Gap| {
            remarked(Row::new(name, label, "Re", [Figure::Multiple(gap.reynolds)]), law(gap.is_turbulent))
        };
        rows.push(one(
            "satellite_leak",
            "leak at a loaded satellite",
            "",
            VolumeRate,
            leakage.satellite.flow_m3_s,
        ));
        rows.push(reynolds("satellite_reynolds", "its Reynolds number", &leakage.satellite));
        rows.push(one("rotor_leak", "leak at the rotor", "", VolumeRate, leakage.rotor.flow_m3_s));
        rows.push(reynolds("rotor_reynolds", "its Reynolds number", &leakage.rotor));
        rows.push(one("leakage", "all leaks of end gaps", "", VolumeRate, leakage.flow_m3_s));
    }
    if let Some(friction) = &losses.friction {
        let both = |name, label, symbol, [most, least]: [f64; 2]| {
            Row::new(name, label, symbol, [Figure::List { si: vec![most, least], dimension: Torque }])
        };
        rows.push(Row::new(
            "friction_coefficients",
            "friction of the flanks, greatest and least",
            "μ_f",
            [Figure::Numbers(friction.coefficients.to_vec())],
        ));
        rows.push(both("friction_torque", "torque that it takes", "", friction.torque_n_m));
        rows.push(Row::new(
            "friction_share",
            "of the mean torque, at most",
            "",
            [Figure::Share(friction.share[0])],
        ));
        rows.extend(
            friction
                .starting_torque_n_m
                .map(|torques| both("starting_torque", "least torque at the start", "", torques)),
        );
        rows.extend(maybe(
            "frictionless_start",
            "the same without friction",
            "",
            Torque,
            friction.starting_torque_without_n_m,
        ));
        rows.extend(maybe("worst_at", "with the rotor at", "", Angle, friction.worst_at_rad));
    }
    let mut parts = vec![facts(
        "losses",
        "Leaks and friction",
        rows,
        "Models from the gaps, oil and friction given; nothing of it is measured. Of two values the first is with the greatest friction.",
    )];
    match (&losses.at_point, &losses.map) {
        (Some(point), Some(map)) => {
            parts.push(facts("efficiency", "Efficiency", efficiency(point), ""));
            parts.push(Part::Records(map_records(map)));
        }
        _ => parts.push(Part::Text(Text {
            heading: Some("Efficiency".to_owned()),
            paragraphs: vec![format!("Not told: it needs {}, too.", losses.missing.join(", "))],
            ..Text::default()
        })),
    }
    parts
}

fn efficiency(point: &Efficiency) -> Vec<Row> {
    let share = |name, label, symbol, value| Row::new(name, label, symbol, [Figure::Multiple(value)]);
    let shares = |name, label, symbol, values: [f64; 2]| {
        Row::new(name, label, symbol, [Figure::Numbers(values.to_vec())])
    };
    let torque = |name, label, values: [f64; 2]| {
        Row::new(name, label, "", [Figure::List { si: values.to_vec(), dimension: Torque }])
    };
    vec![
        one("inlet_flow", "flow into the motor", "", VolumeRate, point.inlet_flow_m3_s),
        one("charge_flow", "of it to compress the oil", "", VolumeRate, point.charge_m3_s),
        torque("shaft_torque", "mean torque of the shaft", point.torque_n_m),
        torque("flank_friction", "friction of the flanks", point.flank_friction_n_m),
        one("gap_drag", "drag of the gaps", "", Torque, point.gap_drag_n_m),
        one("port_power", "power that the ports take", "", Power, point.throttling_w),
        share("volumetric", "volumetric efficiency", "η_v", point.volumetric),
        shares("mechanical", "mechanical efficiency", "η_m", point.mechanical),
        shares("total", "total efficiency", "η", point.total),
    ]
}

/// A line for each point of the map.
fn map_records(map: &crate::motor::answer::EfficiencyMap) -> Records {
    let rows = map.pressures_pa.iter().enumerate().flat_map(|(row, pressure)| {
        map.speeds_rad_s.iter().enumerate().map(move |(place, speed)| (row, *pressure, place, *speed))
    });
    let at = |of: &[Vec<f64>], row: usize, place: usize| of.get(row)?.get(place).copied();
    Table::new("efficiency_map", rows)
        .quantity("pressure", "Δp", Pressure, |(_, pressure, ..)| *pressure)
        .quantity("speed", "n", AngularSpeed, |(.., speed)| *speed)
        .multiple("volumetric", "η_v", |(row, _, place, _)| at(&map.volumetric, *row, *place))
        .multiple("mechanical", "η_m", |(row, _, place, _)| at(&map.mechanical, *row, *place))
        .multiple("total", "η", |(row, _, place, _)| at(&map.total, *row, *place))
        .multiple("total_with_least_friction", "η, least μ_f", |(row, _, place, _)| {
            at(&map.total_with_least_friction, *row, *place)
        })
        .records()
}

/// What is left out, by what was given.
pub(crate) fn neglected(has_ports: bool, losses: Option<&Losses>) -> String {
    let mut all = vec![];
    if losses.is_none() {
        all.push("Leaks and friction, and what they cost of flow, torque and power (--gaps, --oil and --friction tell them)");
    } else {
        all.push("Leaks at the flanks, friction of bearings and seals, churning, a viscosity that changes");
    }
    if !has_ports {
        all.push("the real ports, which open by and by (--ports), and the compression of the fluid");
    }
    all.push("inertia; sharing of load between teeth, notches, fatigue; the strength of housing and shaft");
    format!("{}.", all.join("; "))
}
