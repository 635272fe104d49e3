//! A gear pair as a reviewer reads it: what holds, what does not, and what helps.

use epicyclic_judge::{Limits, Range, Rule};

fn main() {
    let mut limits = Limits::default();
    // This shop laps its teeth, and bears more sliding than is usual.
    limits.state(Rule::SpecificSliding, Range::at_most(3.5));
    for (rule, value) in [(Rule::FaceWidth, 0.31), (Rule::SpecificSliding, 3.2), (Rule::RingShift, 1.3)] {
        let verdict = limits.judge(rule, value);
        match verdict.severity {
            Some(severity) => println!("{severity:?}: {}: {}", verdict.words(), verdict.remedy()),
            None => println!("holds: {}", verdict.words()),
        }
    }
}
