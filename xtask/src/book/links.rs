//! Check of the links of finished pages: each leads to a file of the book, and to a place in it; nothing is
//! loaded from outside.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Component, Path, PathBuf};
use std::{fs, io};

/// Page with its links and the places that they can lead to.
#[derive(Debug, Default)]
struct Page {
    /// `href` of anchors and stylesheets, `src` of pictures and scripts.
    links: Vec<Link>,
    places: BTreeSet<String>,
}

#[derive(Debug)]
struct Link {
    to: String,
    /// Whether the browser fetches the target automatically.
    is_loaded: bool,
}

/// Links of the pages in a folder that lead nowhere, and addresses outside from which a page would load
/// something.
///
/// # Errors
/// A page that cannot be read.
pub fn dead(folder: &Path) -> io::Result<Vec<String>> {
    let mut pages = BTreeMap::new();
    read(folder, folder, &mut pages)?;
    let mut dead = Vec::new();
    for (path, page) in &pages {
        for link in &page.links {
            let from_outside = link.to.contains("://") || link.to.starts_with("//");
            let why = match from_outside {
                true if link.is_loaded => Some("is loaded from outside"),
                true => None,
                false => missing(folder, &pages, path, &link.to),
            };
            if let Some(why) = why {
                dead.push(format!("{}: {} {why}", path.display(), link.to));
            }
        }
    }
    Ok(dead)
}

/// Reason why a link within the book leads nowhere; `None` if it is valid.
fn missing(folder: &Path, pages: &BTreeMap<PathBuf, Page>, from: &Path, link: &str) -> Option<&'static str> {
    if link.starts_with("mailto:") || link.starts_with("data:") || link.starts_with("javascript:") {
        return None;
    }
    let (file, place) = link.split_once('#').unwrap_or((link, ""));
    let file = file.split('?').next().unwrap_or(file);
    // The page for missing files is shown at any address, so its links begin at the root.
    let target = match file {
        "" => from.to_owned(),
        _ if file.starts_with('/') => PathBuf::from(file.trim_start_matches('/')),
        _ => match within(&from.parent().unwrap_or(Path::new("")).join(file)) {
            Some(target) => target,
            None => return Some("leads out of the book"),
        },
    };
    if !folder.join(&target).exists() {
        return Some("does not exist");
    }
    let is_known = place.is_empty()
        || pages
            .get(&target)
            .is_none_or(|page| page.places.contains(place) || page.places.contains(&decoded(place)));
    (!is_known).then_some("is no place of that page")
}

/// Path without `..`; `None` if it leads out of the book.
fn within(path: &Path) -> Option<PathBuf> {
    let mut plain = PathBuf::new();
    for component in path.components() {
        match component {
            Component::Normal(name) => plain.push(name),
            Component::ParentDir if plain.pop() => {}
            Component::CurDir => {}
            _ => return None,
        }
    }
    Some(plain)
}

/// Decodes escapes such as `%CE%B7` to their letters.
fn decoded(text: &str) -> String {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, after @ ..] = rest {
        let code = text.get(text.len() - after.len()..text.len() - after.len() + 2);
        match code.and_then(|code| u8::from_str_radix(code, 16).ok()) {
            Some(byte) if *first == b'%' => {
                bytes.push(byte);
                rest = &after[2..];
            }
            _ => {
                bytes.push(*first);
                rest = after;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

fn read(root: &Path, folder: &Path, pages: &mut BTreeMap<PathBuf, Page>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            read(root, &path, pages)?;
        } else if path.extension().is_some_and(|ending| ending == "html") {
            let inner = path.strip_prefix(root).unwrap_or(&path).to_owned();
            pages.insert(inner, page(&fs::read_to_string(&path)?));
        }
    }
    Ok(())
}

/// Links and places of a page as mdBook writes it: attributes in double quotes.
fn page(html: &str) -> Page {
    let mut page = Page::default();
    for tag in html.split('<').skip(1).map(|rest| rest.split('>').next().unwrap_or_default()) {
        let name = tag.split_whitespace().next().unwrap_or_default();
        let value = |attribute: &str| {
            let (_, rest) = tag.split_once(&format!(" {attribute}=\""))?;
            Some(rest.split('"').next().unwrap_or_default().replace("&amp;", "&"))
        };
        for attribute in ["id", "name"] {
            page.places.extend(value(attribute));
        }
        if let Some(to) = value("href") {
            page.links.push(Link { to, is_loaded: name == "link" });
        }
        if let Some(to) = value("src") {
            page.links.push(Link { to, is_loaded: true });
        }
    }
    page
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_way_to_lead_nowhere_is_found() -> io::Result<()> {
        let folder = tempfile::tempdir()?;
        fs::create_dir(folder.path().join("theory"))?;
        let good = "<h2 id=\"the-loss-η\"></h2><a href=\"theory/a.html#b\"></a><a href=\"https://example.org\"></a>\
                    <a href=\"#the-loss-%CE%B7\"></a><img src=\"data:x\">";
        fs::write(folder.path().join("index.html"), good)?;
        fs::write(folder.path().join("theory/a.html"), "<p id=\"b\"></p><a href=\"../index.html\"></a>")?;
        assert_eq!(dead(folder.path())?, Vec::<String>::new());
        let bad = "<a href=\"index.html#c\"></a><a href=\"no.html\"></a><img src=\"../out.svg\">\
                   <script src=\"https://example.org/a.js\"></script>";
        fs::write(folder.path().join("bad.html"), bad)?;
        let said = dead(folder.path())?;
        assert_eq!(said.len(), 4, "{said:?}");
        for why in ["is no place", "does not exist", "leads out", "loaded from outside"] {
            assert!(said.iter().any(|line| line.contains(why)), "{why}: {said:?}");
        }
        Ok(())
    }
}
