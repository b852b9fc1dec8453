//! Pictures, and where they go.
#![allow(dead_code, unused_imports, reason = "each example uses its part")]

use std::path::{Path, PathBuf};
use std::{env, fs, io};

pub(crate) use dmech::plot::*;

/// Draws a picture of the given size in pixels into the build folder and tells where it is.
pub(crate) fn save(name: &str, size: [u32; 2], onto: impl FnOnce(&Area<'_>) -> Drawn) -> Drawn<PathBuf> {
    let path = place(name)?;
    fs::write(&path, draw(size, onto)?)?;
    Ok(path)
}

/// Where a file of the given name goes.
pub(crate) fn place(name: &str) -> io::Result<PathBuf> {
    Ok(folder()?.join(name))
}

/// `dmech/` in the build folder, which is the one above the program that has cargo's tag; else in the current folder.
fn folder() -> io::Result<PathBuf> {
    let program = env::current_exe()?;
    let here = env::current_dir()?;
    let target = program.ancestors().find(|folder| folder.join("CACHEDIR.TAG").is_file());
    let folder = target.unwrap_or(Path::new("")).join("dmech");
    fs::create_dir_all(&folder)?;
    Ok(folder.strip_prefix(here).map(Path::to_path_buf).unwrap_or(folder))
}
