//! The examples in the order of a reader, and where the heart of each is.

use std::path::Path;
use std::{fs, io};

/// The name of an example, and the pieces of its code that are shown: a file in `examples/` and how the piece begins.
pub(crate) type Example = (&'static str, &'static [(&'static str, &'static str)]);

/// Groups with their titles.
pub(crate) const GROUPS: [(&str, &[Example]); 4] = [
    (
        "One body",
        &[
            ("planet", &[("planet.rs", "impl Kepler"), ("planet.rs", "let start ="), ("planet.rs", "let run =")]),
            ("orbit", &[("shared/table_1.rs", "pub(crate) fn five_schemes")]),
            (
                "oscillator",
                &[
                    ("oscillator.rs", "impl Spring"),
                    ("oscillator.rs", "let run = Simulation::new(SPRING, START).mass(MASS).scheme(Kanatani).dt(dt)"),
                ],
            ),
            (
                "inverse_square",
                &[("inverse_square.rs", "fn planet"), ("inverse_square.rs", "fn kinetic_and_potential")],
            ),
            (
                "pendulum",
                &[("shared/section_4.rs", "pub(crate) fn implicit"), ("shared/section_4.rs", "pub(crate) fn leapfrog")],
            ),
            ("magnetic", &[("shared/gyration.rs", "impl Graded"), ("magnetic.rs", "fn simulate")]),
            ("section", &[("section.rs", "fn motion"), ("section.rs", "fn section")]),
            ("billiard", &[("billiard.rs", "fn bounce"), ("billiard.rs", "fn motion")]),
            (
                "comet",
                &[
                    ("comet.rs", "let start = halley"),
                    ("comet.rs", "let law ="),
                    ("comet.rs", "let scheme ="),
                    ("comet.rs", "let run = Simulation::new(law, start)"),
                    ("comet.rs", "show(\"Sun alone\""),
                ],
            ),
        ],
    ),
    (
        "Many bodies",
        &[
            (
                "three_molecules",
                &[("shared/section_6.rs", "impl Molecular"), ("shared/section_6.rs", "pub(crate) fn implicit")],
            ),
            ("string", &[("shared/section_7.rs", "impl Tension"), ("string.rs", "let exact = Simulation")]),
            ("chain", &[("chain.rs", "fn chain"), ("chain.rs", "fn discrete_gradient")]),
            (
                "cluster",
                &[("cluster.rs", "const ATOMS"), ("cluster.rs", "fn cluster"), ("cluster.rs", "fn discrete_gradient")],
            ),
            ("liquid", &[("liquid.rs", "fn leapfrog"), ("liquid.rs", "fn liquid")]),
            (
                "cloth",
                &[("cloth.rs", "impl Ball"), ("cloth.rs", "if let Some(mut air)"), ("cloth.rs", "stepper.set_body(0")],
            ),
        ],
    ),
    (
        "Long and hard",
        &[
            ("kirkwood", &[("kirkwood.rs", "let run = Simulation::scene")]),
            ("sweep", &[("sweep.rs", "let run = Ensemble::of")]),
            (
                "hard_cases",
                &[
                    ("hard_cases/cases/wall.rs", "let law ="),
                    ("hard_cases/cases/wall.rs", "let motion ="),
                    ("hard_cases/cases/wall.rs", "let trials ="),
                ],
            ),
            ("round_off", &[("round_off.rs", "let lines = [")]),
        ],
    ),
    ("Speed against error", &[("work_precision", &[("work_precision.rs", "fn orbit")])]),
];

/// Those that take a minute or more.
pub(crate) const LONG: [&str; 2] = ["round_off", "work_precision"];

/// All names, in order.
pub(crate) fn names() -> impl Iterator<Item = &'static str> {
    GROUPS.iter().flat_map(|(_, examples)| *examples).map(|(name, _)| *name)
}

/// The examples of a folder that no group has.
///
/// # Errors
/// Those of reading the folder.
pub(crate) fn unlisted(folder: &Path) -> io::Result<Vec<String>> {
    let mut unlisted = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let program = path.extension().is_some_and(|kind| kind == "rs") || path.join("main.rs").is_file();
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        if program && name != "gallery" && !names().any(|listed| listed == name) {
            unlisted.push(name);
        }
    }
    Ok(unlisted)
}
