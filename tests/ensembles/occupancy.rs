//! Nobody waits for a slower one: what is computed over all lanes against what each needs alone.

use std::cell::Cell;

use dmech::extend::{Fields, LANES, Real};
use dmech::models::Kepler;
use dmech::prelude::*;

thread_local! {
    /// Forces that were evaluated, a register of lanes as one.
    static FORCES: Cell<u64> = const { Cell::new(0) };
}

/// A law, counted.
#[derive(Clone, Copy)]
struct Counted<L>(L);

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
        FORCES.set(FORCES.get() + 1);
        self.0.discrete_gradient(a, b)
    }
    fn discrete_gradient_jacobian(&self, a: [R; 2], b: [R; 2]) -> [[R; 2]; 2] {
        self.0.discrete_gradient_jacobian(a, b)
    }
}

impl<P: Potential<2, R>, R: Real> dmech::extend::Field<2, R> for Counting<P> {}

impl<L: Law<2>> Law<2> for Counted<L> {
    type Field<'a>
        = Counting<L::Field<'a>>
    where
        L: 'a;

    fn field(&self, mass: f64, t: f64) -> Self::Field<'_> {
        Counting(self.0.field(mass, t))
    }
}

impl<L> VelocityIndependent for Counted<L> {}

impl<L: Fields<2>> Fields<2> for Counted<L> {
    type Numbers = L::Numbers;
    type Moment<R: Real> = Counting<L::Moment<R>>;

    fn numbers(&self) -> Self::Numbers {
        self.0.numbers()
    }

    fn moment<R: Real>(numbers: <Self::Numbers as dmech::extend::Numbers>::Of<R>, mass: R, t: R) -> Self::Moment<R> {
        Counting(L::moment(numbers, mass, t))
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

/// In units of a length, so that it has no value where that is 0.
#[derive(Clone, Copy)]
struct Well {
    l: f64,
}

#[dmech::law]
impl Well {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        0.25 * (q[0] / self.l).powi(4) + 0.5 * (q[1] / self.l).powi(2)
    }
}

/// Some have no law, and are where that of others has no value: nobody moves one by one for them.
#[test]
fn free_members_keep_nobody_from_riding() {
    fn check<L: Fields<2> + Copy + Sync>(law: L, orbit: State<2>) {
        let free = |k: usize| k.is_multiple_of(3);
        let start = |k: usize| match free(k) {
            true => State::new([0.0, 0.0], [0.01 * (k % 2) as f64, 0.0]),
            false => orbit,
        };
        let ensemble = |lanes: usize| {
            let ensemble = Ensemble::of(512).law(|k| (!free(k)).then_some(Counted(law))).start(start);
            let ensemble = ensemble.scheme(DiscreteGradient).dt(0.01).look_every(1_000_000).threads(1).lanes(lanes);
            forces(|| assert_eq!(ensemble.run(300).unwrap().failures().count(), 0))
        };
        let (alone, together) = (ensemble(1), ensemble(usize::MAX));
        let bound = alone / LANES as u64 * 3 / 2;
        assert!(together < bound + bound / 5, "{together} forces in {LANES} lanes for {alone} alone");
    }
    let law = Kepler { gm: 1.0 };
    check(law, law.pericentre(1.0, 0.5));
    check(Well { l: 1.5 }, State::new([0.7, 0.4], [0.1, 0.3]));
}
