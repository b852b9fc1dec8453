//! A program of someone who depends on the published packages: see `scripts/packages`.

use dmech::prelude::*;

/// A planet about a fixed sun, Φ(q) = −gm/|q|.
#[derive(Clone, Copy, Debug)]
struct Kepler {
    gm: f64,
}

#[dmech::law]
impl Kepler {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -self.gm / q[0].hypot(q[1])
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let planet = Simulation::new(Kepler { gm: 1.0 }, State::new([0.5, 0.0], [0.0, 1.63]));
    let run = planet.scheme(DiscreteGradient).dt(0.01).run(1000)?;
    println!("{run}");
    assert!(run.drift(Invariant::Energy).ok_or("the energy is an invariant")?.max_relative() < 1e-13);

    let spring = dmech::models::pairs::Spring { k: 70.0, length: 1.0 };
    let chain = (0..8).map(|k| 1.1 * f64::from(k)).fold(Scene::<1>::new(), |chain, x| chain.body(1.0, [x], [0.0]));
    let bonds = (0..7).map(|k| (k, k + 1));
    let run = Simulation::scene(chain.bonds(spring, bonds)).scheme(DiscreteGradient).dt(0.01).run(100)?;
    assert!(run.drift(Invariant::Energy).ok_or("the energy is an invariant")?.max_relative() < 1e-12);

    #[cfg(feature = "all")]
    all()?;
    Ok(())
}

/// What other features bring.
#[cfg(feature = "all")]
fn all() -> Result<(), Box<dyn std::error::Error>> {
    let law = Kepler { gm: 1.0 };
    let store = std::env::temp_dir().join(format!("dmech-outside-{}.sqlite", std::process::id()));
    let sweep = Ensemble::of(16)
        .law(|_| law)
        .start(|k| State::new([0.5 + 0.01 * k as f64, 0.0], [0.0, 1.63]))
        .scheme(Nystrom::order6())
        .dt(0.01)
        .store(&store)
        .run(100);
    let sweep = sweep.map_err(|error| error.to_string());
    std::fs::remove_file(&store)?;
    let alone = Simulation::new(law, State::new([0.6, 0.0], [0.0, 1.63])).scheme(Nystrom::order6()).dt(0.01).run(100)?;
    assert_eq!(sweep?.last(10)?, *alone.last());
    let svg = dmech::plot::draw([300, 200], |_| Ok(()))?;
    assert!(svg.starts_with("<svg"));
    Ok(())
}
