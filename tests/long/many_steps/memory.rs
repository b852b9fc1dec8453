//! What a scene takes of memory: an explicit scheme O(N) numbers, whatever the law links.

use dmech::models::pairs::LennardJones;
use dmech::prelude::*;
use dmech_tests::memory::bytes;

/// Ten thousand atoms in less than 10 MB; without optimisation a fifth of them in a fifth of that. A Newton matrix would take
/// 7 GB, or a twenty-fifth.
#[test]
fn explicit_steps_of_all_pairs_take_a_kilobyte_a_body() {
    let side = if cfg!(debug_assertions) { 13_u32 } else { 22 };
    let bodies = side.pow(3).min(10_000) as usize;
    let place = |i: u32| [i % side, i / side % side, i / side / side].map(|x| 1.1 * f64::from(x));
    let atoms = || {
        let scene = (0..bodies as u32).fold(Scene::<3>::new(), |scene, i| scene.body(1.0, place(i), [0.0; 3]));
        scene.pairs(LennardJones { epsilon: 1.0, sigma: 1.0 })
    };
    fn check<S: dmech::scheme::Scheme<dmech::scene::SceneSystem<3, A>>, A: dmech::scene::Acts<3>>(
        mut stepper: dmech::Stepper<dmech::scene::SceneSystem<3, A>, S>,
        before: isize,
    ) {
        stepper.step().unwrap();
        let (taken, bodies) = (bytes() - before, stepper.q().bodies() as isize);
        println!("{}: {bodies} bodies, {taken} bytes", S::NAME);
        assert!(taken < 1000 * bodies, "{}: {taken} bytes", S::NAME);
    }
    macro_rules! every {
        ($($scheme:expr),*) => {$({
            let before = bytes();
            let scene = atoms();
            let clock = std::time::Instant::now();
            let stepper = Simulation::scene(scene).scheme($scheme).dt(0.001).stepper().unwrap();
            println!("set-up: {:?}", clock.elapsed());
            check(stepper, before);
        })*};
    }
    every!(Explicit, Leapfrog, Nystrom::order4(), Composed::order4(Leapfrog));
}
