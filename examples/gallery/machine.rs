//! On what, when and with what the page was made.

use std::path::Path;
use std::process::Command;
use std::{env, fs, thread};

use crate::clock::Clock;

/// The features of dmech that this program was built with, and so will be the examples.
const FEATURES: [(&str, bool); 10] = [
    ("scene", cfg!(feature = "scene")),
    ("sparse", cfg!(feature = "sparse")),
    ("serde", cfg!(feature = "serde")),
    ("approx", cfg!(feature = "approx")),
    ("nalgebra", cfg!(feature = "nalgebra")),
    ("progress", cfg!(feature = "progress")),
    ("store", cfg!(feature = "store")),
    ("ranks", cfg!(feature = "ranks")),
    ("plot", cfg!(feature = "plot")),
    ("parallel", cfg!(feature = "parallel")),
];

/// Instructions beyond the least of a processor that the code was built for.
const INSTRUCTIONS: [(&str, bool); 8] = [
    ("SSE2", cfg!(target_feature = "sse2")),
    ("SSE4.2", cfg!(target_feature = "sse4.2")),
    ("AVX", cfg!(target_feature = "avx")),
    ("AVX2", cfg!(target_feature = "avx2")),
    ("FMA", cfg!(target_feature = "fma")),
    ("AVX-512F", cfg!(target_feature = "avx512f")),
    ("NEON", cfg!(target_feature = "neon")),
    ("SVE", cfg!(target_feature = "sve")),
];

/// With commas, as cargo takes them.
pub(crate) fn features() -> String {
    present(&FEATURES).join(",")
}

fn present(all: &[(&'static str, bool)]) -> Vec<&'static str> {
    all.iter().filter(|(_, is)| *is).map(|(name, _)| *name).collect()
}

/// What stands at the head of the page.
pub(crate) fn facts() -> Vec<(&'static str, String)> {
    let rustc = env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    let unknown = || "unknown".to_owned();
    let cores = thread::available_parallelism().map_or(String::new(), |cores| format!(", {cores} threads at once"));
    let instructions = present(&INSTRUCTIONS).join(", ");
    vec![
        ("Date", output("date", &["-u", "+%Y-%m-%d"]).unwrap_or_else(unknown)),
        ("Processor", processor().unwrap_or_else(unknown) + &cores),
        ("Built for", format!("{} with {instructions}, {}", env::consts::ARCH, env::consts::OS)),
        ("Compiler", output(&rustc, &["--version"]).unwrap_or_else(unknown)),
        ("dmech", format!("{}, features {}", env!("CARGO_PKG_VERSION"), present(&FEATURES).join(", "))),
        ("Times", Clock::what().to_owned()),
    ]
}

/// The name that the maker gave it.
fn processor() -> Option<String> {
    if cfg!(target_os = "macos") {
        return output("sysctl", &["-n", "machdep.cpu.brand_string"]);
    }
    let told = fs::read_to_string(Path::new("/proc/cpuinfo")).ok()?;
    let name = told.lines().find(|line| line.starts_with("model name"))?;
    Some(name.split_once(':')?.1.trim().to_owned())
}

/// The one line that a program prints.
fn output(program: &str, arguments: &[&str]) -> Option<String> {
    let output = Command::new(program).args(arguments).current_dir(env!("CARGO_MANIFEST_DIR")).output().ok()?;
    let line = String::from_utf8(output.stdout).ok()?.trim().to_owned();
    (output.status.success() && !line.is_empty()).then_some(line)
}
