//! What is one motion is one motion, whichever system it is written as: a scene of three bodies, and one law of all their
//! coordinates with a mass for each.

use dmech::models::pairs::Morse;
use dmech::prelude::*;

use super::setups::*;

/// The energies of three pairs.
#[derive(Clone, Copy, Debug)]
struct Three {
    pair: Morse,
}

#[dmech::law]
impl Three {
    #[potential]
    fn energy(&self, q: [f64; 6]) -> f64 {
        self.bond(q[0] - q[2], q[1] - q[3]) + self.bond(q[0] - q[4], q[1] - q[5]) + self.bond(q[2] - q[4], q[3] - q[5])
    }

    fn bond(&self, x: f64, y: f64) -> f64 {
        let stretch = (-self.pair.width * ((x * x + y * y).sqrt() - self.pair.length)).exp();
        self.pair.depth * (1.0 - stretch) * (1.0 - stretch)
    }
}

fn both<S>(scheme: S, most: f64)
where
    S: Method
        + Scheme<Particle<dmech::extend::Masses<Three, 6>, 6>>
        + Scheme<
            <Scene<2, (), ((), dmech::scene::Linked<Morse, dmech::scene::Pairs>)> as dmech::extend::Setup<()>>::System,
        >,
{
    let start = State::new([0.9, 0.1, -0.8, 0.3, 0.2, -1.1], [0.1, 0.4, 0.2, -0.3, -0.3, 0.1]);
    let law = Simulation::new(Three { pair: MORSE }, start).masses([1.3, 1.3, 0.7, 0.7, 2.1, 2.1]);
    let law = law.scheme(scheme).dt(0.05).run(400).expect("a resolved motion");
    let scene = Simulation::scene(cluster().pairs(MORSE)).scheme(scheme).dt(0.05).run(400).expect("the same motion");
    let apart = apart(law.last(), scene.last());
    let [one, other] =
        [law.drift(Invariant::Energy), scene.drift(Invariant::Energy)].map(|drift| drift.expect("conserved"));
    let (one, other) = (one.max_abs(), other.max_abs());
    println!("{:<44} {apart:.1e}, energy to {one:.1e}", S::NAME);
    assert!(apart < most, "{}: {apart:e}", S::NAME);
    assert!((one - other).abs() < 1e-12 + 1e-9 * one, "{}: {one:e} and {other:e}", S::NAME);
}

#[test]
fn a_scene_and_one_law_of_all_its_coordinates_move_alike() {
    both(Explicit, 1e-11);
    both(Leapfrog, 1e-11);
    both(CompensatedLeapfrog, 1e-11);
    both(Implicit, 1e-10);
    both(DiscreteGradient, 1e-10);
    both(Kanatani, 1e-10);
    both(Composed::order4(Implicit), 1e-10);
    both(Composed::order6(DiscreteGradient), 1e-10);
    both(Nystrom::order6(), 1e-11);
    both(ForceGradient::order4(), 1e-11);
    both(ForceGradient::order6(), 1e-11);
    both(ForceGradient::order8(), 1e-11);
}
