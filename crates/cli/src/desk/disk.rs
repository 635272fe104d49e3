//! Output files: each is written as a whole, and of one call all or none.
//!
//! Every content goes into a temporary file in the folder of its target. When all are complete and on the
//! disk, they are renamed. A device or a pipe cannot be renamed; it is written just before. After that only a
//! renaming within a folder can fail.
//!
//! The name of a temporary file is `.epicyclic-` with sixteen hexadecimal digits and `.tmp`; it is locked
//! while its program lives. The files of a killed program have no lock any more, and the next call that
//! writes into the folder removes them.

use epicyclic_commands::desk::{Content, NotWritten, Source, Text};
use std::collections::VecDeque;
use std::fs::{self, File, OpenOptions, Permissions};
use std::hash::{BuildHasher as _, RandomState};
use std::io::{self, BufWriter, ErrorKind, Read, Write as _};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Temporary files of this program.
static PENDING: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn pending() -> MutexGuard<'static, Vec<PathBuf>> {
    PENDING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes all temporary files of this program before it ends; nothing can be written while the returned
/// guard lives.
#[must_use]
pub fn remove_temporary() -> impl Drop {
    let pending = pending();
    for path in pending.iter() {
        let _ = fs::remove_file(path);
    }
    pending
}

/// Reads a file, unless it has more bytes than `most`.
///
/// # Errors
/// The error of a file that cannot be read.
pub fn read(file: &Path, most: u64) -> io::Result<Text> {
    let file = File::open(file)?;
    let metadata = file.metadata()?;
    let size = metadata.is_file().then_some(metadata.len());
    if size.is_some_and(|size| size > most) {
        return Ok(Text::TooLarge { size });
    }
    // The file may have grown since its size was read.
    limited(file, most)
}

/// Reads no more bytes than the limit, because a device may have no end.
///
/// # Errors
/// The error of a stream that cannot be read.
pub fn limited(from: impl Read, most: u64) -> io::Result<Text> {
    let mut bytes = Vec::new();
    from.take(most.saturating_add(1)).read_to_end(&mut bytes)?;
    Ok(if bytes.len() as u64 > most { Text::TooLarge { size: None } } else { Text::Whole(bytes) })
}

/// Creates a folder if it does not exist.
///
/// # Errors
/// The error of a folder that cannot be created.
pub fn make_folder(folder: &Path) -> io::Result<()> {
    if folder.is_dir() { Ok(()) } else { fs::create_dir(folder) }
}

/// Removes a file if it exists.
///
/// # Errors
/// The error of a file that cannot be removed.
pub fn remove(file: &Path) -> io::Result<()> {
    match fs::remove_file(file) {
        Err(error) if error.kind() != ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

/// Writes all files completely, or none; the last one may be streamed.
///
/// # Errors
/// The file that cannot be written; no file is written then.
pub fn write(files: &[Content], streamed: Option<(&Path, &mut Source)>) -> Result<(), NotWritten> {
    let mut all: Vec<(&Path, Box<Source>)> = vec![];
    for (file, content) in files {
        all.push((file, Box::new(|out| out.write_all(content))));
    }
    all.extend(streamed.map(|(file, source)| (file, Box::new(source) as Box<Source>)));
    let mut prepared = Prepared::default();
    let mut devices = vec![];
    for (file, mut source) in all {
        let target = Target::of(file).map_err(|error| failed(file, error))?;
        match target {
            Target::Device => devices.push((file, source, None)),
            Target::Stream(stream) => devices.push((file, source, Some(stream))),
            Target::File { place, permissions } => {
                remove_stale(folder_of(&place));
                let added = prepared.add(file, place, permissions, &mut *source);
                added.map_err(|error| failed(file, error))?;
            }
        }
    }
    for (file, mut source, stream) in devices {
        let written = match stream {
            Some(stream) => stream.write(&mut *source),
            None => write_device(file, &mut *source),
        };
        written.map_err(|error| failed(file, error))?;
    }
    prepared.take_names()
}

fn failed(file: &Path, why: io::Error) -> NotWritten {
    NotWritten { file: file.to_owned(), why }
}

fn write_device(file: &Path, source: &mut Source) -> io::Result<()> {
    let mut out = BufWriter::new(OpenOptions::new().write(true).open(file)?);
    source(&mut out)?;
    out.flush()
}

/// An open stream of this program.
#[derive(Clone, Copy)]
enum Stream {
    Out,
    Error,
}

impl Stream {
    /// Stream that leads to a file: `/dev/stdout`, or the file that a shell has opened for it. The file is
    /// written through the stream, because a renamed file would leave the stream's own file behind.
    #[cfg(unix)]
    fn of(file: &fs::Metadata) -> Option<Self> {
        use std::os::fd::{AsFd as _, BorrowedFd};
        use std::os::unix::fs::MetadataExt as _;
        let is_file = |stream: BorrowedFd<'_>| {
            let own = stream.try_clone_to_owned().ok().and_then(|stream| File::from(stream).metadata().ok());
            own.is_some_and(|own| (own.dev(), own.ino()) == (file.dev(), file.ino()))
        };
        if is_file(io::stdout().as_fd()) {
            return Some(Self::Out);
        }
        is_file(io::stderr().as_fd()).then_some(Self::Error)
    }

    #[cfg(not(unix))]
    fn of(_: &fs::Metadata) -> Option<Self> {
        None
    }

    fn write(self, source: &mut Source) -> io::Result<()> {
        match self {
            Self::Out => {
                let mut out = BufWriter::new(io::stdout().lock());
                source(&mut out)?;
                out.flush()
            }
            Self::Error => source(&mut io::stderr().lock()),
        }
    }
}

/// Target of a file.
enum Target {
    /// Device, which has no content to keep.
    Device,
    /// Stream that is already open.
    Stream(Stream),
    File {
        /// Place of the file behind any links, so that they remain links.
        place: PathBuf,
        /// Permissions of the existing file.
        permissions: Option<Permissions>,
    },
}

impl Target {
    fn of(file: &Path) -> io::Result<Self> {
        let permissions = match fs::metadata(file) {
            Ok(metadata) if metadata.is_dir() => return Err(ErrorKind::IsADirectory.into()),
            Ok(metadata) if !metadata.is_file() => return Ok(Self::Device),
            Ok(metadata) => match Stream::of(&metadata) {
                Some(stream) => return Ok(Self::Stream(stream)),
                None => Some(metadata.permissions()),
            },
            Err(error) if error.kind() == ErrorKind::NotFound => None,
            Err(error) => return Err(error),
        };
        if permissions.as_ref().is_some_and(Permissions::readonly) {
            return Err(ErrorKind::PermissionDenied.into());
        }
        let place = behind_links(file)?;
        let folder = folder_of(&place);
        if !folder.is_dir() {
            let message = format!("there is no folder {}", folder.display());
            return Err(io::Error::new(ErrorKind::NotFound, message));
        }
        Ok(Self::File { place, permissions })
    }
}

fn folder_of(file: &Path) -> &Path {
    match file.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// Place that a path denotes, even if nothing exists there yet; links are followed to their end.
fn behind_links(file: &Path) -> io::Result<PathBuf> {
    /// Maximum number of links, as in Linux.
    const MOST_LINKS: usize = 40;
    let mut place = file.to_owned();
    for _ in 0..MOST_LINKS {
        match fs::read_link(&place) {
            // A path from the root takes the place of the folder.
            Ok(next) => place = folder_of(&place).join(next),
            Err(_) => return Ok(place),
        }
    }
    Err(io::Error::other("too many links"))
}

/// Whether two paths denote one file, which may not exist yet. Devices and pipes never do, because nothing in
/// them is replaced.
#[must_use]
pub fn are_one_file(one: &Path, other: &Path) -> bool {
    match (fs::metadata(one), fs::metadata(other)) {
        (Ok(one_is), Ok(other_is)) if one_is.is_file() && other_is.is_file() => {
            #[cfg(unix)]
            {
                use std::os::unix::fs::MetadataExt as _;
                if (one_is.dev(), one_is.ino()) == (other_is.dev(), other_is.ino()) {
                    return true;
                }
            }
            fs::canonicalize(one)
                .ok()
                .is_some_and(|one| fs::canonicalize(other).is_ok_and(|other| one == other))
        }
        (Err(_), Err(_)) => {
            let (one, other) = (place_to_be(one), place_to_be(other));
            one.is_some() && one == other
        }
        _ => false,
    }
}

/// Place of a file that does not exist yet.
fn place_to_be(file: &Path) -> Option<PathBuf> {
    let place = behind_links(file).ok()?;
    let folder = folder_of(&place);
    let folder = fs::canonicalize(folder).or_else(|_| std::path::absolute(folder)).ok()?;
    Some(folder.join(place.file_name()?))
}

const PREFIX: &str = ".epicyclic-";
const SUFFIX: &str = ".tmp";
const DIGITS: usize = 16;

/// Whether a file has a name like our temporary files.
fn is_ours(name: &str) -> bool {
    let digits = name.strip_prefix(PREFIX).and_then(|name| name.strip_suffix(SUFFIX));
    digits.is_some_and(|digits| {
        digits.len() == DIGITS && digits.bytes().all(|b| matches!(b, b'0'..=b'9' | b'a'..=b'f'))
    })
}

/// Removes temporary files of programs that no longer run. Obstacles are ignored, because they are not faults
/// of this call.
fn remove_stale(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        let is_file = entry.file_type().is_ok_and(|kind| kind.is_file());
        if !is_file || !entry.file_name().to_str().is_some_and(is_ours) {
            continue;
        }
        // A living program holds the lock, except in the moment between creating and locking the file. Our
        // lock is held until the file is removed; such a program then waits, finds its file gone and creates
        // another.
        let Ok(file) = OpenOptions::new().read(true).write(true).open(entry.path()) else { continue };
        if file.try_lock().is_ok() {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// Complete files without their final names; files that do not get them are removed with this value.
#[derive(Default)]
struct Prepared(VecDeque<Temporary>);

/// A temporary file, which is locked while it is open.
struct Temporary {
    path: PathBuf,
    file: File,
    /// Name of the target as given.
    named: PathBuf,
    /// Final place of the file.
    place: PathBuf,
}

impl Prepared {
    /// Adds a file. Errors name the target, because the user did not ask for the temporary file.
    fn add(
        &mut self,
        named: &Path,
        place: PathBuf,
        permissions: Option<Permissions>,
        source: &mut Source,
    ) -> io::Result<()> {
        let (path, file) = create(folder_of(&place))?;
        self.0.push_back(Temporary { path, file, named: named.to_owned(), place });
        let Some(Temporary { file, .. }) = self.0.back_mut() else { return Ok(()) };
        let mut out = BufWriter::new(&*file);
        source(&mut out)?;
        out.flush()?;
        drop(out);
        if let Some(permissions) = permissions {
            file.set_permissions(permissions)?;
        }
        file.sync_all()
    }

    /// Renames all files; Ctrl-C waits until all have their names.
    fn take_names(&mut self) -> Result<(), NotWritten> {
        let mut pending = pending();
        while let Some(next) = self.0.front() {
            fs::rename(&next.path, &next.place).map_err(|error| failed(&next.named, error))?;
            pending.retain(|path| *path != next.path);
            self.0.pop_front();
        }
        Ok(())
    }
}

/// Creates a temporary file and locks it.
fn create(folder: &Path) -> io::Result<(PathBuf, File)> {
    /// Another program may take the file for a stale one before it is locked; that hardly happens twice.
    const MOST_TRIES: u32 = 16;
    for attempt in 0..MOST_TRIES {
        let number = RandomState::new().hash_one((std::process::id(), attempt));
        let path = folder.join(format!("{PREFIX}{number:016x}{SUFFIX}"));
        let file = {
            // The list is held, so that Ctrl-C knows every existing file.
            let mut pending = pending();
            let made = OpenOptions::new().read(true).write(true).create_new(true).open(&path);
            match made {
                Err(error) if error.kind() == ErrorKind::AlreadyExists => continue,
                made => {
                    let file = made?;
                    pending.push(path.clone());
                    file
                }
            }
        };
        // On a file system without locks nobody gets one, so no file is taken for stale.
        let _ = file.lock();
        if path.try_exists()? {
            return Ok((path, file));
        }
        pending().retain(|other| *other != path);
    }
    Err(ErrorKind::AlreadyExists.into())
}

impl Drop for Prepared {
    fn drop(&mut self) {
        let mut pending = pending();
        for temporary in &self.0 {
            let _ = fs::remove_file(&temporary.path);
            pending.retain(|path| *path != temporary.path);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn content(file: &Path) -> Content {
        (file.to_owned(), b"new".to_vec())
    }

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn of_several_files_all_are_written_or_none() {
        let folder = tempfile::tempdir().unwrap();
        let [first, second] = ["first", "second"].map(|name| folder.path().join(name));
        fs::write(&first, "old").unwrap();
        fs::create_dir(&second).unwrap();
        let error = write(&[content(&first), content(&second)], None).unwrap_err();
        assert_eq!(error.to_string(), format!("{}: cannot be written: is a directory", second.display()));
        assert_eq!(
            (names(folder.path()), fs::read(&first).unwrap()),
            (vec!["first".into(), "second".into()], b"old".to_vec())
        );
        fs::remove_dir(&second).unwrap();
        write(&[content(&first), content(&second)], None).unwrap();
        assert_eq!(
            (fs::read(&first).unwrap(), fs::read(&second).unwrap()),
            (b"new".to_vec(), b"new".to_vec())
        );
        assert_eq!(names(folder.path()), ["first", "second"]);
    }

    #[test]
    fn a_stale_temporary_file_goes_and_a_living_one_stays() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        let [stale, living] = [".epicyclic-0123456789abcdef.tmp", ".epicyclic-00112233445566ff.tmp"];
        // Of others, however like ours.
        let others = [
            ".epicyclic-0123456789ABCDEF.tmp",
            ".epicyclic-0123.tmp",
            ".epicyclic-abcdefghijklmnop.tmp",
            ".epicyclic-x",
        ];
        for name in others.iter().chain([&stale, &living]) {
            fs::write(path(name), "part").unwrap();
        }
        let file = OpenOptions::new().write(true).open(path(living)).unwrap();
        file.lock().unwrap();
        write(&[content(&path("answer"))], None).unwrap();
        let found = names(folder.path());
        assert!(!found.contains(&stale.to_owned()) && found.len() == others.len() + 2, "{found:?}");
        assert!(found.contains(&living.to_owned()), "{found:?}");
    }

    #[cfg(unix)]
    #[test]
    fn a_link_stays_a_link_also_where_it_leads_to_nothing_yet() {
        use std::os::unix::fs::symlink;
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        fs::create_dir(path("other")).unwrap();
        symlink("other/second", path("first")).unwrap();
        symlink(path("target"), path("other/second")).unwrap();
        for _ in 0..2 {
            write(&[content(&path("first"))], None).unwrap();
            assert!(path("first").is_symlink() && path("other/second").is_symlink());
            assert_eq!(fs::read(path("target")).unwrap(), b"new");
        }
        symlink("nowhere/file", path("broken")).unwrap();
        let error = write(&[content(&path("broken"))], None).unwrap_err().to_string();
        assert!(error.ends_with("/nowhere"), "{error}");
        symlink("round", path("round")).unwrap();
        assert!(write(&[content(&path("round"))], None).is_err() && path("round").is_symlink());
    }

    #[cfg(unix)]
    #[test]
    fn one_file_is_known_by_any_of_its_names() {
        use std::os::unix::fs::symlink;
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        fs::create_dir(path("sub")).unwrap();
        fs::write(path("file"), "x").unwrap();
        fs::write(path("copy"), "x").unwrap();
        symlink("../file", path("sub/link")).unwrap();
        fs::hard_link(path("file"), path("hard")).unwrap();
        symlink("new", path("to-new")).unwrap();
        for (one, other, same) in [
            ("file", "sub/../file", true),
            ("file", "sub/link", true),
            ("file", "hard", true),
            ("file", "copy", false),
            ("file", "new", false),
            ("new", "sub/../new", true),
            ("new", "to-new", true),
            ("new", "newer", false),
            ("no/new", "no/new", true),
            ("sub", "sub", false),
        ] {
            assert_eq!(are_one_file(&path(one), &path(other)), same, "{one} {other}");
            assert_eq!(are_one_file(&path(other), &path(one)), same, "{other} {one}");
        }
        assert!(!are_one_file(Path::new("/dev/null"), Path::new("/dev/null")));
    }
}
