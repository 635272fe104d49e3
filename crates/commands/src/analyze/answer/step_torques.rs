//! Torques of a gear without losses, and their balance on each link.

use super::records::member_name;
use crate::tolerance::ROUNDED;
use epicyclic_numerics::values::largest_absolute;
use epicyclic_train::groups::Groups;
use epicyclic_train::{Analysis, Gearbox, LinkId};
use schemars::JsonSchema;
use serde::Serialize;

/// Torques without losses, relative to the input torque.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct StepTorques {
    /// Torques on the members of sets that carry torque: in each equation 1, −i₀ and i₀ − 1 times one value.
    pub members: Vec<MemberTorque>,
    /// Torque balances of the links that carry torque.
    pub links: Vec<LinkBalance>,
}

/// Torque on a member of a set.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct MemberTorque {
    /// Name of the set.
    pub set: String,
    /// Name of the member.
    pub member: String,
    /// Torque on the member relative to the input torque.
    pub torque_of_input: f64,
}

/// Torques on a link, whose sum is 0.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct LinkBalance {
    /// Names of the link and of the links permanently connected to it.
    pub links: Vec<String>,
    /// Torques on the link.
    pub torques: Vec<TorqueOnLink>,
}

/// Torque on a link.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct TorqueOnLink {
    /// Origin of the torque.
    pub from: TorqueFrom,
    /// Name of the shift element or set; null for the input and output.
    pub name: Option<String>,
    /// Name of the member of the set; null unless the torque comes from a set.
    pub member: Option<String>,
    /// Torque relative to the input torque.
    pub torque_of_input: f64,
}

/// Origins of a torque on a link.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TorqueFrom {
    /// Machine at the input.
    Input,
    /// Machine at the output.
    Output,
    /// Shift element.
    ShiftElement,
    /// Set: the reaction to the torque on its member.
    Set,
}

impl StepTorques {
    /// Steps for a gear; `None` if torques cannot be computed.
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
