//! Why a gearbox cannot be drawn, in words.

use crate::shared::drawability::answer::{Conflict, Element, ElementKind, Reach};

/// Which link is shut in by which.
#[must_use]
pub fn shut_in(conflict: &Conflict) -> String {
    let quoted = |links: &[String]| links.iter().map(|link| format!("`{link}`")).collect::<Vec<_>>();
    let inside = quoted(&conflict.shut_in);
    let what = match (conflict.cannot_reach, &inside[..]) {
        (Some(Reach::Housing), [link, ..]) => format!("{link} cannot reach the housing"),
        (Some(Reach::Outside), [link, ..]) => format!("{link} has no way out"),
        (Some(Reach::EachOther), [one, other, ..]) => format!("{one} cannot reach {other}"),
        _ => "its links run through one another".to_owned(),
    };
    match &quoted(&conflict.shut_in_by)[..] {
        [] => what,
        [one] => format!("{what}, shut in by {one}"),
        [first @ .., last] => format!("{what}, shut in by {} and {last}", first.join(", ")),
    }
}

/// What cannot be drawn together.
#[must_use]
pub fn together(conflict: &Conflict) -> String {
    let element = |Element { kind, name }: &Element| match kind {
        ElementKind::Set => format!("set `{name}`"),
        ElementKind::Brake => format!("brake `{name}`"),
        ElementKind::Clutch => format!("clutch `{name}`"),
        ElementKind::Link => format!("link `{name}`"),
        ElementKind::Input => format!("the input at `{name}`"),
        ElementKind::Output => format!("the output at `{name}`"),
        ElementKind::TakeOff => format!("the way out of `{name}`"),
    };
    let elements: Vec<String> = conflict.elements.iter().map(element).collect();
    format!("cannot be drawn together: {}", elements.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_shut_in_is_told_with_what_is_around_it() {
        let links = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
        let conflict = |shut_in, cannot_reach, by| Conflict {
            elements: vec![],
            shut_in: links(shut_in),
            cannot_reach,
            shut_in_by: links(by),
        };
        let told = |inside, reach, by| shut_in(&conflict(inside, reach, by));
        assert_eq!(told(&["B"], Some(Reach::Outside), &[]), "`B` has no way out");
        assert_eq!(
            told(&["D", "T1"], Some(Reach::EachOther), &["B"]),
            "`D` cannot reach `T1`, shut in by `B`"
        );
        assert_eq!(
            told(&["T1"], Some(Reach::Housing), &["D", "B", "T2"]),
            "`T1` cannot reach the housing, shut in by `D`, `B` and `T2`"
        );
        assert_eq!(told(&[], None, &[]), "its links run through one another");
    }
}
