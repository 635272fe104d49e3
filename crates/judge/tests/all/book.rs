//! The table of rules in the book.

use epicyclic_judge::{Range, Rule};
use std::fmt::Write as _;
use std::path::Path;

fn range(range: Range) -> String {
    match (range.least.is_finite(), range.most.is_finite()) {
        (true, true) => format!("{} to {}", range.least, range.most),
        (true, false) => format!("at least {}", range.least),
        (false, true) => format!("at most {}", range.most),
        (false, false) => String::new(),
    }
}

/// The page lists every rule with its bounds; `UPDATE_BOOK` writes it.
#[test]
fn the_book_has_every_rule_with_its_bounds() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src/reference/practice.md");
    let page = std::fs::read_to_string(&path).unwrap();
    let head = "|---|---|---|---|---|---|\n";
    let start = page.find(head).unwrap() + head.len();
    // The table ends at the first line that is none of it.
    let lines = page[start..].split_inclusive('\n').take_while(|line| line.starts_with('|'));
    let end = start + lines.map(str::len).sum::<usize>();
    let mut rows = String::new();
    for rule in Rule::ALL {
        let unit = if rule.unit().is_empty() { String::new() } else { format!(", {}", rule.unit()) };
        let mut ranges = rule.bounds().0.map(range);
        if let Some((severity, limit)) = rule.own_limit() {
            ranges[severity as usize] = limit.to_owned();
        }
        let [remark, warning, error] = ranges;
        writeln!(
            rows,
            "| `{}` | {}{unit} | {remark} | {warning} | {error} | {} |",
            rule.name(),
            rule.what(),
            rule.source()
        )
        .unwrap();
    }
    let fresh = format!("{}{rows}{}", &page[..start], &page[end..]);
    if std::env::var_os("UPDATE_BOOK").is_some() {
        std::fs::write(&path, &fresh).unwrap();
    }
    assert!(std::env::var_os("UPDATE_BOOK").is_some() || page == fresh, "set UPDATE_BOOK to renew the table");
}
