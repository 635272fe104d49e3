//! The compiled part of the Python package `epicyclic`.
//!
//! | module | is |
//! |---|---|
//! | `call` | a call of the command line: the same words, the same answer |
//! | `commands` | the commands and their options as data |
//! | `sweep` | many variants or operating points of a gearbox in one call, as arrays |
//! | `work` | long work: without Python's lock, with progress and Ctrl-C |
//!
//! The module only passes data: questions go to the library of the program or to `answers`, and answers come
//! back as JSON or arrays. The classes that people use are in Python, in `python/epicyclic`.

mod call;
mod commands;
mod sweep;
mod work;

use pyo3::prelude::*;

/// The compiled part of the package `epicyclic`; use that.
#[pymodule]
fn _core(module: &Bound<'_, PyModule>) -> PyResult<()> {
    work::loaded();
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_function(wrap_pyfunction!(call::call, module)?)?;
    module.add_function(wrap_pyfunction!(commands::commands, module)?)?;
    module.add_function(wrap_pyfunction!(sweep::sweep, module)?)?;
    module.add_function(wrap_pyfunction!(sweep::points, module)?)
}
