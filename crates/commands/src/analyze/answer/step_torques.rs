//! Torques of a gear without losses, and their balance on each link.

use super::records::member_name;
use crate::tolerance::ROUNDED;
use epicyclic_numerics::values::largest_absolute;
use epicyclic_train::groups::Groups;
use epicyclic_train::{Analysis, Gearbox, LinkId};
use schemars::JsonSchema;
use serde::Serialize;

/// Torques without losses, as multiples of the input's.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct StepTorques {
    /// On the members of sets that carry torque: in each equation 1, −i₀ and i₀ − 1 times the same.
    pub members: Vec<MemberTorque>,
    /// On the links that carry torque.
    pub links: Vec<LinkBalance>,
}

/// The torque on a member of a set.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MemberTorque {
    /// The set.
    pub set: String,
    /// The member.
    pub member: String,
    /// Torque on it over the input's.
    pub torque_of_input: f64,
}

/// The torques on a link, whose sum is 0.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LinkBalance {
    /// The link, and those that are permanently connected to it.
    pub links: Vec<String>,
    /// The torques.
    pub torques: Vec<TorqueOnLink>,
}

/// A torque on a link.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TorqueOnLink {
    /// What it comes from.
    pub from: TorqueFrom,
    /// Name of the shift element or set.
    pub name: Option<String>,
    /// The member of the set.
    pub member: Option<String>,
    /// The torque over the input's.
    pub torque_of_input: f64,
}

/// What a torque on a link comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TorqueFrom {
    /// The machine at the input.
    Input,
    /// The machine at the output.
    Output,
    /// A shift element.
    ShiftElement,
    /// A set: the reaction to the torque on its member.
    Set,
}

impl StepTorques {
    /// Of a gear; `None` where torques do not follow.
    pub(super) fn of(gearbox: &Gearbox, analysis: &Analysis<'_>) -> Option<Self> {
        let case = analysis.ideal()?;
        let members = case.members.iter().cloned().collect::<Option<Vec<Vec<f64>>>>()?;
        let elements = case.shift_elements.iter().copied().collect::<Option<Vec<f64>>>()?;
        let all = || members.iter().flatten().chain(&elements).chain([&case.input, &case.output]);
        let nothing = ROUNDED * largest_absolute(all());
        let mut groups = Groups::new(gearbox.links().len());
        for [first, second] in gearbox.permanent() {
            groups.join(first.index(), second.index());
        }
        let piece = |link: LinkId| groups.root(link.index());
        let sets = || {
            gearbox.sets().iter().zip(&members).flat_map(|(set, torques)| {
                let of_set = set.members().iter().zip(torques).enumerate();
                of_set.map(move |(member, (link, torque))| (set, member, *link, *torque))
            })
        };
        let on = |from, name: Option<&str>, torque: f64| TorqueOnLink {
            from,
            name: name.map(str::to_owned),
            member: None,
            torque_of_input: torque / case.input,
        };
        let balance = |root: usize| {
            let terminals = [
                (TorqueFrom::Input, analysis.gear().input(), case.input),
                (TorqueFrom::Output, analysis.gear().output(), case.output),
            ];
            let outside = terminals.into_iter().filter(|(_, link, _)| piece(*link) == root);
            let outside = outside.map(|(from, _, torque)| on(from, None, torque));
            let shift = gearbox.shift_elements().iter().zip(&elements).flat_map(|(element, torque)| {
                let ends = element.links().map(piece);
                let share = f64::from(i8::from(ends[0] == root) - i8::from(ends[1] == root));
                (share != 0.0).then(|| on(TorqueFrom::ShiftElement, Some(element.id()), share * torque))
            });
            let reactions = sets().filter(|(_, _, link, _)| piece(*link) == root);
            let reactions = reactions.map(|(set, member, _, torque)| TorqueOnLink {
                member: Some(member_name(set, member)),
                ..on(TorqueFrom::Set, Some(set.id()), -torque)
            });
            let torques: Vec<TorqueOnLink> = outside
                .chain(shift)
                .chain(reactions)
                .filter(|one| one.torque_of_input.abs() > nothing / case.input.abs())
                .collect();
            let links = gearbox.link_ids().filter(|link| piece(*link) == root);
            let links = links.map(|link| gearbox.link_name(link).to_owned()).collect();
            LinkBalance { links, torques }
        };
        let roots = (1..gearbox.links().len()).filter(|link| groups.root(*link) == *link);
        let loaded = sets().filter(|(.., torque)| torque.abs() > nothing);
        Some(Self {
            members: loaded
                .map(|(set, member, _, torque)| MemberTorque {
                    set: set.id().to_owned(),
                    member: member_name(set, member),
                    torque_of_input: torque / case.input,
                })
                .collect(),
            links: roots.map(balance).filter(|link| !link.torques.is_empty()).collect(),
        })
    }
}
