//! Examples as programs of their own: built as this one was, and run.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::clock::Clock;
use crate::entry::Outcome;
use crate::machine;

/// Builds an example and runs it; only the run is timed. A failure is part of what comes back.
pub(crate) fn run(name: &str, folder: &Path) -> Outcome {
    let program = match build(name) {
        Ok(program) => program,
        Err(failure) => return Outcome { failure: Some(failure), ..Outcome::default() },
    };
    let clock = Clock::start();
    let output = match Command::new(&program).output() {
        Ok(output) => output,
        Err(error) => return Outcome { failure: Some(error.to_string()), ..Outcome::default() },
    };
    let time = Some(clock.elapsed());
    let told = String::from_utf8_lossy(&output.stdout);
    // Pictures are what it says it has drawn.
    let said = told.split_whitespace().filter(|word| word.ends_with(".svg")).map(PathBuf::from);
    let (pictures, missing): (Vec<_>, Vec<_>) = said.partition(|path| path.is_file());
    let failure = match missing.first() {
        _ if !output.status.success() => {
            Some(format!("{}\n{}", output.status, String::from_utf8_lossy(&output.stderr)))
        }
        Some(path) => Some(format!("it says that it has drawn {}, which is not there", path.display())),
        None => None,
    };
    // Where the pictures are is of no use to who reads the page elsewhere.
    let numbers = told.replace(&format!("{}{}", folder.display(), std::path::MAIN_SEPARATOR), "");
    Outcome { numbers, pictures, time, failure }
}

/// Builds examples, several at a time, as far as they can be built: what is wrong with one is told when its turn comes.
///
/// # Errors
/// This program is not where cargo builds examples, or cargo does not run.
pub(crate) fn build_all(names: impl Iterator<Item = &'static str>) -> Result<(), String> {
    let mut cargo = cargo(&place()?);
    cargo.arg("--keep-going").args(names.flat_map(|name| ["--example", name]));
    cargo.output().map(|_| ()).map_err(|error| error.to_string())
}

fn build(name: &str) -> Result<PathBuf, String> {
    let place = place()?;
    let output = cargo(&place).args(["--example", name]).output().map_err(|error| error.to_string())?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    Ok(place.examples.join(name).with_extension(env::consts::EXE_EXTENSION))
}

/// TARGET/release/examples, or TARGET/TRIPLE/release/examples.
struct Place {
    examples: PathBuf,
    target: PathBuf,
    triple: Option<String>,
    profile: String,
}

/// Where this program is.
fn place() -> Result<Place, String> {
    let this = env::current_exe().map_err(|error| error.to_string())?;
    let found = || {
        let examples = this.parent()?;
        let profile = examples.parent()?;
        let above = profile.parent()?;
        let target = above.ancestors().find(|folder| folder.join("CACHEDIR.TAG").is_file())?;
        let name = |folder: &Path| Some(folder.file_name()?.to_str()?.to_owned());
        let triple = if above == target { None } else { Some(name(above)?) };
        Some(Place { examples: examples.to_owned(), target: target.to_owned(), triple, profile: name(profile)? })
    };
    found().ok_or_else(|| format!("{} is not where cargo builds examples", this.display()))
}

/// A build in the profile, with the features and in the folders of this program.
fn cargo(place: &Place) -> Command {
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.current_dir(env!("CARGO_MANIFEST_DIR"));
    cargo.args(["build", "--quiet", "--package", "dmech", "--features", &machine::features()]);
    cargo.args(["--profile", if place.profile == "debug" { "dev" } else { &place.profile }]);
    cargo.arg("--target-dir").arg(&place.target);
    if let Some(triple) = &place.triple {
        cargo.args(["--target", triple]);
    }
    if !cfg!(feature = "scene") {
        cargo.arg("--no-default-features");
    }
    cargo
}
