//! Puts the browser app into the program, compressed, with the feature `app`. The files come from
//! `target/app`, where `scripts/web build` leaves them, or from the folder that `EPICYCLIC_APP` names.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    #[cfg(feature = "app")]
    if let Err(why) = app::put_in() {
        println!("cargo::error={why}");
    }
}

#[cfg(feature = "app")]
mod app {
    use flate2::{Compression, write::GzEncoder};
    use std::fmt::Write as _;
    use std::io::Write as _;
    use std::path::PathBuf;
    use std::{env, fs};

    pub(crate) fn put_in() -> Result<(), String> {
        println!("cargo::rerun-if-env-changed=EPICYCLIC_APP");
        let folder = env::var_os("EPICYCLIC_APP").map_or_else(
            || PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../target/app"),
            PathBuf::from,
        );
        println!("cargo::rerun-if-changed={}", folder.display());
        let failed = |error: std::io::Error| {
            format!(
                "the app is not in {} ({error}): scripts/web build makes it, EPICYCLIC_APP names another folder",
                folder.display()
            )
        };
        let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default());
        let mut names = vec![];
        for entry in fs::read_dir(&folder).map_err(failed)? {
            let entry = entry.map_err(failed)?;
            if entry.file_type().map_err(failed)?.is_file() {
                names.extend(entry.file_name().into_string());
            }
        }
        names.sort();
        let mut list = String::from("&[\n");
        for name in names {
            let mut packed = GzEncoder::new(vec![], Compression::best());
            packed.write_all(&fs::read(folder.join(&name)).map_err(failed)?).map_err(failed)?;
            fs::write(out.join(&name), packed.finish().map_err(failed)?).map_err(failed)?;
            let _ = writeln!(
                list,
                "    ({name:?}, include_bytes!(concat!(env!(\"OUT_DIR\"), \"/\", {name:?}))),"
            );
        }
        list.push(']');
        fs::write(out.join("app.rs"), list).map_err(failed)
    }
}
