//! Why the best candidate is first, and why the others are not.

use super::{chosen, joined, name, name_of_unreachable};
use crate::select::answer::candidate::{
    Candidate, Criterion, InSource, InSourceStanding, Reach, ReachKind, Verdict,
};
use crate::select::answer::required::Objective;
use crate::select::answer::{RelaxedCriterion, Remedy, Select, Unreachable};
use crate::table::report::Text;
use epicyclic_units::format::trimmed;

/// Mechanisms out of reach that are told one by one.
const MOST_TOLD: usize = 6;

/// The reasons, as a list.
pub(super) fn why(select: &Select, accepted: &[Candidate]) -> Text {
    let (heading, mut points) = match accepted.split_first() {
        None if select.accepted == 0 => {
            ("Nothing meets every required criterion".to_owned(), ways_out(select))
        }
        None => (of(select.accepted, "candidate") + " accepted", vec![]),
        Some((best, others)) => {
            let mut points = vec![why_first(select, best)];
            let objections = best.criteria.iter().filter(|verdict| !verdict.met);
            points.extend(objections.map(|one| {
                format!(
                    "objection, not a required criterion: {}{}",
                    objection(best, one),
                    remedy(select, one)
                )
            }));
            points.extend(others.iter().map(|other| behind(best, other)));
            (format!("Why {} is first", named(best)), points)
        }
    };
    if select.rejected > 0 {
        let hint = if select.required.ratios.len() == 2 {
            "--teeth also tries ratios off the wanted ones"
        } else {
            "--teeth also tries ratios off the wanted one"
        };
        points.push(format!("{} rejected, for the reasons above; {hint}", of(select.rejected, "design")));
    }
    points.extend(out_of_reach(&select.unreachable));
    Text::list(heading, points)
}

/// Where nothing is accepted: which options would help, those that search more first.
#[must_use]
pub fn ways_out(select: &Select) -> Vec<String> {
    let mut ways = vec![];
    if let Some(all) = select.accepted_of_all_structures.filter(|all| *all > 0) {
        ways.push(format!("--all-structures leaves {}", of(all, "design")));
    }
    for relaxation in &select.relaxations {
        let nearest = select.candidates.iter().find(|one| one.no == relaxation.nearest);
        let which = nearest.map_or_else(|| of(relaxation.candidates, "design"), named);
        let more = match relaxation.candidates {
            0 | 1 => String::new(),
            all => format!(", the nearest of {all} that nothing else keeps out"),
        };
        let options: Vec<String> = relaxation.limits().map(|one| option_that_admits(select, one)).collect();
        let admit = if options.len() > 1 { "admit" } else { "admits" };
        ways.push(format!("{} {admit} {which}{more}", options.join(" and ")));
    }
    if select.accepted_of_all_structures == Some(0) {
        ways.push("--all-structures finds nothing either".to_owned());
    }
    ways
}

/// The option with a value that admits the nearest candidate, to three digits on the safe side.
fn option_that_admits(select: &Select, relaxation: RelaxedCriterion) -> String {
    let limit = relaxation.limit.unwrap_or_default();
    let (up, down) = (|| trimmed(rounded(limit, f64::ceil), 4), || trimmed(rounded(limit, f64::floor), 4));
    match relaxation.criterion {
        Criterion::RatioError => {
            format!("--tolerance {}%", trimmed(rounded(100.0 * limit, f64::ceil), 4))
        }
        Criterion::RingToSunRatio => {
            let [least, greatest] = [select.required.k.least, select.required.k.greatest];
            if limit < least {
                format!("--k {}..{}", down(), trimmed(greatest, 6))
            } else {
                format!("--k {}..{}", trimmed(least, 6), up())
            }
        }
        Criterion::Efficiency => format!("--least-efficiency {}", down()),
        Criterion::LinkSpeed => format!("--link-speed {}", up()),
        Criterion::PlanetSpeed => format!("--planet-speed {}", up()),
        Criterion::ClutchSlip => format!("--clutch-slip {}", up()),
        Criterion::Circulation => format!("--circulation {}", up()),
        Criterion::SameDirection => "leaving out --same-direction".to_owned(),
        Criterion::Drawable => "--allow-crossing".to_owned(),
    }
}

/// Three significant digits, the last by `round`.
fn rounded(value: f64, round: fn(f64) -> f64) -> f64 {
    if value == 0.0 {
        return 0.0;
    }
    let unit = libm::pow(10_f64, libm::log10(value.abs()).floor() - 2.0);
    round(value / unit) * unit
}

fn of(count: usize, what: &str) -> String {
    if count == 1 { format!("1 {what}") } else { format!("{count} {what}s") }
}

/// A candidate by its name and ratios: one mechanism may serve the ratios in several ways.
fn named(one: &Candidate) -> String {
    let ratios: Vec<String> = one.gears.iter().map(|gear| trimmed(gear.ratio, 5)).collect();
    format!("{} (i = {})", name(one), ratios.join(", "))
}

fn why_first(select: &Select, best: &Candidate) -> String {
    match select.decided_by {
        _ if select.accepted == 1 => "nothing else meets every required criterion".to_owned(),
        None => "all others are equal to it in every objective".to_owned(),
        Some(Objective::Direction) => {
            "the output of all others reverses against direct drive; such schemes are ranked last".to_owned()
        }
        Some(first) => format!("{}; the order asks for that first", extreme(first, best)),
    }
}

fn extreme(objective: Objective, best: &Candidate) -> String {
    let shown = shown(objective, best);
    match objective {
        Objective::Direction => "its output turns alike in all gears".to_owned(),
        Objective::Efficiency if best.gears.len() == 1 => format!("its efficiency is the highest, {shown}"),
        Objective::Efficiency => format!("the efficiency of its worse gear is the highest, {shown}"),
        Objective::Speed => {
            format!("its fastest link or planet is the slowest, {shown} of the input's speed")
        }
        Objective::RingToSunRatio => {
            format!("its ring-to-sun ratios are nearest to the preferred ones, {shown} away")
        }
        Objective::RatioError => format!("its ratios are nearest to the wanted ones, {shown} off"),
        Objective::Size => format!("its largest ring is the smallest, {shown}"),
        Objective::Circulation => format!("the least power circulates in it, {shown} of what enters"),
    }
}

fn shown(objective: Objective, one: &Candidate) -> String {
    let of = &one.objectives;
    match objective {
        Objective::Direction => String::new(),
        Objective::Efficiency => trimmed(of.efficiency, 4),
        Objective::Speed => trimmed(of.speed_of_input, 4),
        Objective::RingToSunRatio => trimmed(of.ring_to_sun_distance, 4),
        Objective::RatioError => format!("{} %", trimmed(100.0 * of.ratio_error, 3)),
        Objective::Size => trimmed(of.size, 4),
        Objective::Circulation => trimmed(of.circulating_of_entering, 4),
    }
}

/// What puts one behind the best.
fn behind(best: &Candidate, other: &Candidate) -> String {
    let name = named(other);
    let Some(objective) = other.behind_by else { return format!("{name}: equal in every objective") };
    let (what, than) = match objective {
        Objective::Direction => return format!("{name}: its output reverses against direct drive"),
        Objective::Efficiency => ("efficiency", "less than"),
        Objective::Speed => ("speed", "above"),
        Objective::RingToSunRatio => ("distance of the ring-to-sun ratios", "above"),
        Objective::RatioError => ("error of the ratio", "above"),
        Objective::Size => ("size", "above"),
        Objective::Circulation => ("circulating power", "above"),
    };
    format!("{name}: {what} {}, {than} {}", shown(objective, other), shown(objective, best))
}

fn out_of_reach(all: &[Unreachable]) -> Vec<String> {
    if all.len() > MOST_TOLD {
        return vec![format!(
            "{} assignments of the ratios to a mechanism are out of reach: a set would need k at or below 1, or none; \
             --format json lists them",
            all.len()
        )];
    }
    let told = |one: &Unreachable| {
        let wanted: Vec<String> = one.wanted_ratios.iter().map(|ratio| trimmed(*ratio, 5)).collect();
        format!(
            "{} (i = {}): {}",
            name_of_unreachable(one),
            wanted.join(", "),
            needed(one.needed_k.as_deref())
        )
    };
    all.iter().map(told).collect()
}

fn needed(k: Option<&[f64]>) -> String {
    let Some(k) = k else { return "a set would need an infinite k".to_owned() };
    let bad = (1..).zip(k).filter(|(_, k)| **k <= 1.0).map(|(set, k)| format!("k{set} = {k:.3}"));
    format!("{} needed, and k of a simple set is above 1", bad.collect::<Vec<_>>().join(" and "))
}

/// Criteria that a candidate does not meet, required or not.
pub(crate) fn unmet(one: &Candidate) -> Vec<String> {
    one.criteria.iter().filter(|verdict| !verdict.met).map(|verdict| objection(one, verdict)).collect()
}

/// Required criteria that a candidate does not meet.
pub(super) fn objections(one: &Candidate) -> String {
    let all = one.criteria.iter().filter(|verdict| verdict.required && !verdict.met);
    all.map(|verdict| objection(one, verdict)).collect::<Vec<_>>().join("; ")
}

fn objection(one: &Candidate, verdict: &Verdict) -> String {
    let value = verdict.value.map_or_else(|| "none".to_owned(), |value| trimmed(value, 4));
    let least = trimmed(verdict.least, 4);
    let greatest = verdict.greatest.map_or_else(|| "infinity".to_owned(), |limit| trimmed(limit, 4));
    let percent = |share: Option<f64>| trimmed(100.0 * share.unwrap_or_default(), 3);
    let gear = verdict.gear.map_or_else(String::new, |gear| format!("gear {gear}"));
    let set = verdict.set.map_or_else(String::new, |set| set.to_string());
    match verdict.criterion {
        Criterion::RatioError => {
            format!("ratio of {gear} {} % off, {} allowed", percent(verdict.value), percent(verdict.greatest))
        }
        Criterion::RingToSunRatio => format!("k = {value} of set {set} outside {least} to {greatest}"),
        Criterion::Efficiency => format!("efficiency {value} in {gear}, least {least}"),
        Criterion::LinkSpeed => {
            let link = verdict.link.map_or("a link", |link| link.symbol());
            format!("speed {value} of {link} in {gear}, greatest {greatest}")
        }
        Criterion::PlanetSpeed => {
            format!("speed {value} of planet {set} relative to its carrier in {gear}, greatest {greatest}")
        }
        Criterion::ClutchSlip => {
            let clutch = chosen(one).map_or_else(|| "no direct-drive clutch".to_owned(), joined);
            format!("slip {value} of the direct-drive clutch ({clutch}), greatest {greatest}")
        }
        Criterion::Circulation => {
            format!(
                "{value} of what enters circulates in {gear}, {} {greatest}",
                if verdict.required { "greatest" } else { "more than" }
            )
        }
        Criterion::SameDirection => {
            let backward = one.gears.iter().filter(|gear| gear.ratio < 0.0);
            let gears: Vec<&str> = backward.map(|gear| gear.gear.name()).collect();
            let (plural, turn) = if gears.len() == 1 { ("", "turns") } else { ("s", "turn") };
            format!("gear{plural} {} {turn} the output against direct drive", gears.join(" and "))
        }
        Criterion::Drawable => {
            let crossing = verdict.crossing.as_deref().unwrap_or_default();
            format!("not drawable: {crossing}")
        }
    }
}

/// Which option requires a criterion that is not required, and what it leaves.
fn remedy(select: &Select, verdict: &Verdict) -> String {
    let Some(remedy) = select.remedies.iter().find(|remedy| remedy.criterion == verdict.criterion) else {
        return String::new();
    };
    let option = match verdict.criterion {
        Criterion::Circulation => {
            format!("--circulation {}", trimmed(verdict.greatest.unwrap_or_default(), 4))
        }
        _ => "--same-direction".to_owned(),
    };
    match remedy {
        Remedy { accepted: 0, accepted_of_all_structures: None | Some(0), .. } => {
            "; of the designs that meet the criteria none is free of it".to_owned()
        }
        Remedy { accepted: 0, accepted_of_all_structures: Some(all), .. } => {
            format!("; {option} with --all-structures leaves {}", of(*all, "design"))
        }
        Remedy { accepted, .. } => format!("; {option} leaves {}", of(*accepted, "design")),
    }
}

/// Whether the source has a structure, and why not; nothing of one that it lists.
pub(super) fn in_source(one: &Candidate, source: &InSource) -> Option<String> {
    let ratio = |reach: Option<Reach>| reach.map_or_else(|| "none".to_owned(), range);
    let words = match source.standing {
        InSourceStanding::Listed => return None,
        InSourceStanding::OutOfReach => format!("out of reach: gear 2 gives {}", ratio(source.ratio_2)),
        InSourceStanding::Missed => format!(
            "missed by the source: gear 1 gives {}, gear 2 {}",
            ratio(source.ratio_1),
            ratio(source.ratio_2)
        ),
        InSourceStanding::Reversed => format!(
            "equal to {} with D and B exchanged",
            source.reversed_of.as_deref().unwrap_or("another structure")
        ),
        InSourceStanding::Parallel => {
            "outside the source's rule: set 2 ties T2, not T1, to D and B, and works alone".to_owned()
        }
        InSourceStanding::Serial => {
            "outside the source's rule: no set has both D and B, the sets work in series".to_owned()
        }
    };
    Some(format!("In the source: {}: {words}", name(one)))
}

fn range(Reach { kind, from, to }: Reach) -> String {
    match kind {
        ReachKind::Between => format!("{from:.3} to {to:.3}"),
        ReachKind::ThroughZero => format!("{from:.3} to {to:.3}, 0 included"),
        ReachKind::ThroughInfinity => format!("below {from:.3} and above {to:.3}"),
    }
}
