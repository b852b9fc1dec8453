//! Nobody waits for a slower one: what is computed over all lanes against what each needs alone.

use std::cell::Cell;

use dmech::extend::{Fields, LANES, Real};
use dmech::models::Kepler;
use dmech::prelude::*;

thread_local! {
    /// Forces that were evaluated, a register of lanes as one.
    static FORCES: Cell<u64> = const { Cell::new(0) };
}

/// Kepler's law, counted.
#[derive(Clone, Copy)]
struct Counted(Kepler);

#[derive(Clone, Copy)]
struct Counting<P>(P);

impl<P, R: Real> Potential<2, R> for Counting<P>
where
    P: Potential<2, R>,
{
    fn potential(&self, q: [R; 2]) -> R {
        self.0.potential(q)
    }
    fn gradient(&self, q: [R; 2]) -> [R; 2] {
        FORCES.set(FORCES.get() + 1);
        self.0.gradient(q)
    }
    fn hessian(&self, q: [R; 2]) -> [[R; 2]; 2] {
        self.0.hessian(q)
    }
    fn discrete_gradient(&self, a: [R; 2], b: [R; 2]) -> [R; 2] {
        self.0.discrete_gradient(a, b)
    }
    fn discrete_gradient_jacobian(&self, a: [R; 2], b: [R; 2]) -> [[R; 2]; 2] {
        self.0.discrete_gradient_jacobian(a, b)
    }
}

impl<P: Potential<2, R>, R: Real> dmech::extend::Field<2, R> for Counting<P> {}

impl Law<2> for Counted {
    type Field<'a> = Counting<<Kepler as Law<2>>::Field<'a>>;

    fn field(&self, mass: f64, t: f64) -> Self::Field<'_> {
        Counting(self.0.field(mass, t))
    }
}

impl VelocityIndependent for Counted {}

impl Fields<2> for Counted {
    type Numbers = <Kepler as Fields<2>>::Numbers;
    type Moment<R: Real> = Counting<<Kepler as Fields<2>>::Moment<R>>;

    fn numbers(&self) -> Self::Numbers {
        self.0.numbers()
    }

    fn moment<R: Real>(numbers: <Self::Numbers as dmech::extend::Numbers>::Of<R>, mass: R, t: R) -> Self::Moment<R> {
        Counting(Kepler::moment(numbers, mass, t))
    }
}

fn forces(run: impl FnOnce()) -> u64 {
    FORCES.set(0);
    run();
    FORCES.get()
}

/// Orbits of all eccentricities with the steps that each asks for, some twice as many as others: the lanes are full but at the end.
#[test]
fn lanes_stay_full() {
    let (members, law) = (512, Kepler { gm: 1.0 });
    let start = |k: usize| law.pericentre(1.0, 0.99 * k as f64 / (members - 1) as f64);
    let ensemble = |lanes: usize| {
        let ensemble = Ensemble::of(members).law(|_| Counted(law)).start(start).scheme(Nystrom::order6());
        let ensemble = ensemble.adaptive(1e-6).look_every(1_000_000).threads(1).lanes(lanes);
        let mut steps = Vec::new();
        let forces = forces(|| {
            let run = ensemble.run_until(100.0).unwrap();
            steps = run.members().map(|member| member.unwrap().steps()).collect();
        });
        (forces, steps)
    };
    let ((alone, own), (together, same)) = (ensemble(1), ensemble(usize::MAX));
    assert_eq!(own, same);
    assert!(own.iter().max() > own.iter().min().map(|least| 2 * least).as_ref());
    let ratio = together as f64 * LANES as f64 / alone as f64;
    assert!(ratio < 1.15, "{together} forces in {} lanes for {alone} alone: {ratio}", LANES);
    println!("{ratio:.3} of the work of each alone, in {} lanes", LANES);
}
