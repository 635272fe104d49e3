//! Makes `NAME.js`, `NAME.d.ts` and `NAME_bg.wasm` for a browser from the WebAssembly that Cargo built.
//!
//! `epicyclic-bindgen INPUT.wasm DIRECTORY NAME`

use std::process::ExitCode;
use wasm_bindgen_cli_support::Bindgen;

fn main() -> ExitCode {
    let [input, directory, name] = &std::env::args().skip(1).collect::<Vec<_>>()[..] else {
        eprintln!("usage: epicyclic-bindgen INPUT.wasm DIRECTORY NAME");
        return ExitCode::from(2);
    };
    let mut bindgen = Bindgen::new();
    bindgen.remove_name_section(true).remove_producers_section(true);
    let made = bindgen.input_path(input).out_name(name).typescript(true).web(true);
    match made.and_then(|made| made.generate(directory)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:?}");
            ExitCode::FAILURE
        }
    }
}
