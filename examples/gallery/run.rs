//! Examples as programs of their own: built as this one was, and run.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, io};

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

/// By cargo, in the profile, with the features and in the folders of this program.
fn build(name: &str) -> Result<PathBuf, String> {
    let said = |error: io::Error| error.to_string();
    let this = env::current_exe().map_err(said)?;
    // TARGET/release/examples/gallery, or TARGET/TRIPLE/release/examples/gallery.
    let unknown = || format!("{} is not where cargo builds examples", this.display());
    let examples = this.parent().ok_or_else(unknown)?;
    let profile = examples.parent().ok_or_else(unknown)?;
    let target = profile.ancestors().find(|folder| folder.join("CACHEDIR.TAG").is_file()).ok_or_else(unknown)?;
    let (Some(profile_name), Some(above)) = (name_of(profile), profile.parent()) else { return Err(unknown()) };
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.args(["build", "--quiet", "--package", "dmech", "--example", name, "--features", &machine::features()]);
    cargo.args(["--profile", if profile_name == "debug" { "dev" } else { profile_name }]);
    cargo.arg("--target-dir").arg(target);
    if let (true, Some(triple)) = (above != target, name_of(above)) {
        cargo.args(["--target", triple]);
    }
    if !cfg!(feature = "scene") {
        cargo.arg("--no-default-features");
    }
    let output = cargo.current_dir(env!("CARGO_MANIFEST_DIR")).output().map_err(said)?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    Ok(examples.join(name).with_extension(env::consts::EXE_EXTENSION))
}

fn name_of(folder: &Path) -> Option<&str> {
    folder.file_name()?.to_str()
}
