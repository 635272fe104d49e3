//! Describing a gearbox by names, and checking that the description is one.

use crate::gearbox::{Control, Gear, SharedMesh, ascending, nearest};
use crate::groups::Groups;
use crate::row::{Gearing, MeshLoss, Row, RowKind, RowSpec};
use crate::{Error, GROUND, Gearbox, LinkId, Named, Warning};
use epicyclic_gears::efficiency::MeshEfficiency;
use epicyclic_gears::row::Member;

/// A gearbox being described; see [`Gearbox::builder`].
///
/// Nothing is checked before [`build`](Self::build), so the order of the calls is free.
#[derive(Debug, Clone, Default)]
pub struct GearboxBuilder {
    name: String,
    links: Vec<String>,
    rows: Vec<RowSpec>,
    controls: Vec<(String, [String; 2])>,
    permanent: Vec<[String; 2]>,
    shared: Vec<Vec<String>>,
    gears: Vec<GearSpec>,
    input: Option<String>,
    output: Option<String>,
}

/// Description of a gear by names.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct GearSpec {
    /// Name of the gear.
    pub name: String,
    /// Engaged controls.
    pub engaged: Vec<String>,
    /// Where power enters, if not at the gearbox's input.
    pub input: Option<String>,
    /// Where power leaves, if not at the gearbox's output.
    pub output: Option<String>,
}

impl Gearbox {
    /// Its description, to be changed and built again; unchanged it builds an equal gearbox.
    #[must_use]
    pub fn to_builder(&self) -> GearboxBuilder {
        let name = |link: LinkId| self.link_name(link).to_owned();
        let gear = |gear: &Gear| GearSpec {
            name: gear.name.clone(),
            engaged: gear.engaged.iter().map(|&place| self.controls[place].id.clone()).collect(),
            input: Some(name(gear.input)),
            output: Some(name(gear.output)),
        };
        let ids = |mesh: &SharedMesh| mesh.rows.iter().map(|&row| self.rows[row].id().to_owned()).collect();
        GearboxBuilder {
            name: self.name.clone(),
            links: self.links[1..].to_vec(),
            rows: self.rows.iter().map(|row| row.spec.clone()).collect(),
            controls: self.controls.iter().map(|c| (c.id.clone(), c.links.map(name))).collect(),
            permanent: self.permanent.iter().map(|pair| pair.map(name)).collect(),
            shared: self.shared.iter().map(ids).collect(),
            gears: self.gears.iter().map(gear).collect(),
            input: Some(name(self.input)),
            output: Some(name(self.output)),
        }
    }
}

impl GearboxBuilder {
    pub(crate) fn new(name: &str) -> Self {
        Self { name: name.into(), ..Self::default() }
    }

    /// Adds links. The housing, [`GROUND`], is there from the start.
    #[must_use]
    pub fn links<S: Into<String>>(mut self, names: impl IntoIterator<Item = S>) -> Self {
        self.links.extend(names.into_iter().map(Into::into));
        self
    }

    /// Adds a row.
    #[must_use]
    pub fn row(mut self, row: RowSpec) -> Self {
        self.rows.push(row);
        self
    }

    /// Adds a control that holds a link to the housing.
    #[must_use]
    pub fn brake(self, id: &str, link: &str) -> Self {
        self.clutch(id, link, GROUND)
    }

    /// Adds a control that joins two links.
    #[must_use]
    pub fn clutch(mut self, id: &str, first: &str, second: &str) -> Self {
        self.controls.push((id.into(), [first.into(), second.into()]));
        self
    }

    /// Holds a link to the housing for ever.
    #[must_use]
    pub fn ground(self, link: &str) -> Self {
        self.tie(link, GROUND)
    }

    /// Joins two links for ever.
    #[must_use]
    pub fn tie(mut self, first: &str, second: &str) -> Self {
        self.permanent.push([first.into(), second.into()]);
        self
    }

    /// Says that these rows share one mesh of a long planet with their common ring (Ravigneaux): its
    /// loss then acts on the net force of the mesh, not on each row's part.
    ///
    /// The rows must have one ring and one carrier and losses by mesh, that of the ring mesh equal.
    #[must_use]
    pub fn shared_ring_mesh<S: Into<String>>(mut self, rows: impl IntoIterator<Item = S>) -> Self {
        self.shared.push(rows.into_iter().map(Into::into).collect());
        self
    }

    /// Names the link where power enters.
    #[must_use]
    pub fn input(mut self, link: &str) -> Self {
        self.input = Some(link.into());
        self
    }

    /// Names the link where power leaves.
    #[must_use]
    pub fn output(mut self, link: &str) -> Self {
        self.output = Some(link.into());
        self
    }

    /// Adds a gear between the gearbox's input and output.
    #[must_use]
    pub fn gear<S: Into<String>>(self, name: &str, engaged: impl IntoIterator<Item = S>) -> Self {
        let engaged = engaged.into_iter().map(Into::into).collect();
        self.gear_spec(GearSpec { name: name.into(), engaged, input: None, output: None })
    }

    /// Adds a gear with its own input or output.
    #[must_use]
    pub fn gear_spec(mut self, gear: GearSpec) -> Self {
        self.gears.push(gear);
        self
    }

    /// Changes the rows described so far: other `k`, teeth or losses between the same links.
    ///
    /// ```
    /// use epicyclic_schemes::{Gearbox, row::{Gearing, RowSpec}};
    /// # fn main() -> Result<(), epicyclic_schemes::Error> {
    /// let gearbox = Gearbox::builder("I")
    ///     .links(["D", "B", "T1"])
    ///     .row(RowSpec::simple("1", ["D", "T1", "B"], 2.94))
    ///     .brake("K1", "T1")
    ///     .input("D")
    ///     .output("B")
    ///     .gear("slow", ["K1"])
    ///     .build()?;
    /// let other = gearbox.to_builder().map_rows(|row| RowSpec { gearing: Gearing::Parameter(4.0), ..row }).build()?;
    /// assert!((other.analyze("slow")?.ratio().unwrap() - 5.0).abs() < 1e-12);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn map_rows(mut self, change: impl FnMut(RowSpec) -> RowSpec) -> Self {
        self.rows = self.rows.into_iter().map(change).collect();
        self
    }

    /// Checks the description and returns the gearbox.
    ///
    /// # Errors
    /// Every variant of [`Error`] that speaks of a description: unknown and repeated names, members
    /// of a row that are one piece, `k ≤ 1` of a simple row, missing steps, controls that join a
    /// link with itself, permanent connections in a loop, terminals at the housing, rows that cannot
    /// share a mesh. Teeth that break coaxiality only leave a [`Warning`].
    pub fn build(self) -> Result<Gearbox, Error> {
        let mut links = vec![GROUND.to_owned()];
        links.extend(self.links.iter().cloned());
        unique(Named::Link, links.iter())?;
        unique(Named::Row, self.rows.iter().map(|row| &row.id))?;
        unique(Named::Control, self.controls.iter().map(|(id, _)| id))?;
        unique(Named::Gear, self.gears.iter().map(|gear| &gear.name))?;
        if self.rows.is_empty() {
            return Err(Error::NoRows);
        }
        let mut gearbox = Gearbox {
            name: self.name,
            links,
            rows: vec![],
            controls: vec![],
            permanent: vec![],
            shared: vec![],
            gears: vec![],
            input: LinkId::GROUND,
            output: LinkId::GROUND,
            warnings: vec![],
        };
        gearbox.input = terminal(&gearbox, self.input.as_deref(), "input")?;
        gearbox.output = terminal(&gearbox, self.output.as_deref(), "output")?;
        let mut groups = Groups::new(gearbox.links.len());
        for [first, second] in &self.permanent {
            let place = || "a permanent connection".to_owned();
            let pair = [link(&gearbox, first, place)?, link(&gearbox, second, place)?];
            if !groups.join(pair[0].0, pair[1].0) {
                return Err(Error::CyclicGrounds { first: first.clone(), second: second.clone() });
            }
            gearbox.permanent.push(pair);
        }
        for spec in self.rows {
            let row = build_row(&gearbox, spec, &groups)?;
            gearbox.warnings.extend(coaxiality(&row));
            gearbox.rows.push(row);
        }
        for (id, [first, second]) in self.controls {
            let place = || format!("control `{id}`");
            let mut pair = [link(&gearbox, &first, place)?, link(&gearbox, &second, place)?];
            if pair[0] == pair[1] {
                return Err(Error::ControlJoinsItself { control: id, link: first });
            }
            if pair[0] == LinkId::GROUND {
                pair.swap(0, 1);
            }
            gearbox.controls.push(Control { id, links: pair });
        }
        for names in &self.shared {
            let group = shared_mesh(&gearbox, names, &groups)?;
            gearbox.shared.push(group);
        }
        for spec in self.gears {
            let gear = build_gear(&gearbox, spec)?;
            gearbox.gears.push(gear);
        }
        let terminals = [gearbox.input, gearbox.output];
        let unreachable: Vec<_> =
            terminals.into_iter().filter(|terminal| !touched(&gearbox, *terminal)).collect();
        for terminal in unreachable {
            gearbox.warnings.push(Warning::Unreachable { link: gearbox.link_name(terminal).into() });
        }
        Ok(gearbox)
    }
}

fn unique<'a>(what: Named, names: impl Iterator<Item = &'a String>) -> Result<(), Error> {
    let mut seen = std::collections::BTreeSet::new();
    for name in names {
        if !seen.insert(name) {
            return Err(Error::Duplicate { what, name: name.clone() });
        }
    }
    Ok(())
}

fn link(gearbox: &Gearbox, name: &str, place: impl Fn() -> String) -> Result<LinkId, Error> {
    gearbox.link(name).ok_or_else(|| gearbox.unknown_link(name, place()))
}

fn terminal(gearbox: &Gearbox, name: Option<&str>, which: &'static str) -> Result<LinkId, Error> {
    let name = name.ok_or(Error::NoTerminal { terminal: which })?;
    let found = link(gearbox, name, || which.to_owned())?;
    if found == LinkId::GROUND {
        return Err(Error::GroundedTerminal { place: which.to_owned() });
    }
    Ok(found)
}

fn build_row(gearbox: &Gearbox, spec: RowSpec, groups: &Groups) -> Result<Row, Error> {
    let (ratio, exact) = spec.ratio()?;
    let place = || format!("row `{}`", spec.id);
    let [a, b, h] = &spec.members;
    let mut members = [link(gearbox, a, place)?, link(gearbox, b, place)?, link(gearbox, h, place)?];
    if spec.kind.is_pair() {
        members[2] = LinkId::GROUND;
    }
    // Members joined for ever make the row one block whatever is engaged. Where the two are the
    // housing the row is locked, which is the same mistake. Joined by a *control* they are the
    // ordinary direct drive.
    for (i, j) in [(0, 1), (0, 2), (1, 2)] {
        if groups.root(members[i].0) == groups.root(members[j].0) {
            return Err(Error::CoincidentMembers {
                row: spec.id.clone(),
                first: Member::ALL[i],
                second: Member::ALL[j],
                link: gearbox.link_name(members[i]).into(),
            });
        }
    }
    Ok(Row { spec, members, ratio, exact })
}

/// `z_b ≠ z_a + 2·z_g` of a simple row. Other kinds have their modules to play with.
fn coaxiality(row: &Row) -> Option<Warning> {
    let (Gearing::Teeth(sun, ring), Some(planet)) = (row.spec.gearing, row.spec.planet) else { return None };
    let unshifted = sun.get().saturating_add(planet.get().saturating_mul(2));
    (row.spec.kind == RowKind::Simple && unshifted != ring.get()).then(|| Warning::Coaxiality {
        row: row.spec.id.clone(),
        ring: ring.get(),
        unshifted,
    })
}

fn shared_mesh(gearbox: &Gearbox, names: &[String], groups: &Groups) -> Result<SharedMesh, Error> {
    let mut rows = vec![];
    for name in names {
        let row = gearbox.rows.iter().position(|row| row.spec.id == *name).ok_or_else(|| Error::Unknown {
            what: Named::Row,
            name: name.clone(),
            place: "a shared mesh".into(),
            suggestion: nearest(name, gearbox.rows.iter().map(|row| row.spec.id.as_str())),
        })?;
        rows.push(row);
    }
    let refuse = |second: usize, why| {
        Err(Error::SharedMesh {
            first: gearbox.rows[rows[0]].spec.id.clone(),
            second: gearbox.rows[second].spec.id.clone(),
            why,
        })
    };
    let mut eta = None;
    for (place, &row) in rows.iter().enumerate() {
        let [_, ring, carrier] = gearbox.rows[row].members.map(|link| groups.root(link.0));
        let [_, ring0, carrier0] = gearbox.rows[rows[0]].members.map(|link| groups.root(link.0));
        if rows[..place].contains(&row) || gearbox.shared_group(row).is_some() {
            return refuse(row, "a row shares its ring mesh once");
        }
        if ring != ring0 || carrier != carrier0 {
            return refuse(row, "they have neither one ring nor one carrier, or only one of them");
        }
        let MeshLoss::Meshes { second, .. } = gearbox.rows[row].spec.loss else {
            return refuse(
                row,
                "give their losses by mesh: a row factor does not say which part is the ring's",
            );
        };
        if eta.is_some_and(|eta| eta != second) {
            return refuse(row, "one mesh has one efficiency, and theirs differ");
        }
        eta = Some(second);
    }
    Ok(SharedMesh { rows, eta: eta.map_or(1.0, MeshEfficiency::get) })
}

fn build_gear(gearbox: &Gearbox, spec: GearSpec) -> Result<Gear, Error> {
    let place = format!("gear `{}`", spec.name);
    let engaged =
        spec.engaged.iter().map(|id| gearbox.control(id, place.clone())).collect::<Result<Vec<_>, _>>()?;
    let own = |name: Option<&str>, default: LinkId, which: &str| {
        let Some(name) = name else { return Ok(default) };
        let place = || format!("{which} of gear `{}`", spec.name);
        match link(gearbox, name, place)? {
            LinkId::GROUND => Err(Error::GroundedTerminal { place: place() }),
            link => Ok(link),
        }
    };
    let input = own(spec.input.as_deref(), gearbox.input, "input")?;
    let output = own(spec.output.as_deref(), gearbox.output, "output")?;
    Ok(Gear { name: spec.name, engaged: ascending(engaged), input, output })
}

fn touched(gearbox: &Gearbox, link: LinkId) -> bool {
    gearbox.rows.iter().any(|row| row.members.contains(&link))
        || gearbox.controls.iter().any(|control| control.links.contains(&link))
        || gearbox.permanent.iter().any(|pair| pair.contains(&link))
}
