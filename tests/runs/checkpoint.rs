//! Runs that are saved and resumed go on bit for bit; a checkpoint of another simulation is refused with what differs.

use dmech::extend::{Carried, Difference};
use dmech::models::pairs::{Charge, Coulomb, FermiPastaUlamTsingou};
use dmech::models::{DrivenPendulum, Kepler, Wall};
use dmech::prelude::*;
use dmech::scene::{SceneSystem, Term};

fn spring(alpha: f64) -> FermiPastaUlamTsingou {
    FermiPastaUlamTsingou { k: 1.0, alpha, beta: 0.0 }
}

/// A pulsating quartic bowl.
#[derive(Clone, Copy, Debug)]
struct Bowl {
    k: f64,
    omega: f64,
}

#[dmech::law]
impl Bowl {
    #[potential]
    fn energy(&self, q: [f64; 2], t: f64) -> f64 {
        self.k * (1.3 + (self.omega * t).sin()) * (q[0] * q[0] + 2.0 * q[1] * q[1]).powi(2)
    }
}

/// A force of position and time that is no gradient.
#[derive(Clone, Copy, Debug)]
struct Push {
    f: f64,
}

#[dmech::law]
impl Push {
    #[force]
    fn push(&self, q: [f64; 2], t: f64) -> [f64; 2] {
        [self.f * (1.7 * t).cos() - 0.1 * q[1], 0.3 * self.f * (q[0] - t).sin()]
    }
}

#[derive(Clone, Copy, Debug)]
struct Drag {
    c: f64,
}

#[dmech::law]
impl Drag {
    #[force]
    fn drag(&self, v: [f64; 2], m: f64) -> [f64; 2] {
        [-self.c * m * v[0], -self.c * v[1] * v[1].abs()]
    }
}

/// −1/√(q² + b²): steps that are too long to see its middle are shortened.
#[derive(Clone, Copy, Debug)]
struct Core {
    b: f64,
}

#[dmech::law]
impl Core {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -1.0 / (q[0] * q[0] + q[1] * q[1] + self.b * self.b).sqrt()
    }
}

#[derive(Clone, Copy, Debug)]
struct Gyration {
    b: f64,
}

#[dmech::law]
impl Gyration {
    #[force]
    fn lorentz(&self, v: [f64; 2]) -> [f64; 2] {
        [self.b * v[1], -self.b * v[0]]
    }
}

fn chain() -> Scene<1> {
    (0..12).fold(Scene::new(), |scene, i| {
        let f = f64::from(i);
        let v = if i == 0 { 0.0 } else { 0.1 * (2.0 * f).cos() };
        scene.body(1.0 + 0.1 * f, [0.7 * (0.9 * f).sin()], [v])
    })
}

fn ions() -> Scene<3, Charge> {
    Scene::new()
        .at_time(0.3)
        .body_with(1.0, [1.2, 0.0, 0.2], [0.0, 1.05, 0.0], Charge { q: 1.0 })
        .body_with(6.0, [0.0, 0.1, 0.0], [0.0, -0.15, 0.02], Charge { q: -1.5 })
        .body_with(1.5, [0.0, 4.0, -0.5], [-0.42, 0.0, 0.1], Charge { q: 0.7 })
}

fn swarm() -> Scene<2> {
    Scene::new().body(1.3, [0.7, -0.4], [0.3, 0.8]).body(0.6, [-0.5, 0.2], [0.1, -0.4]).body(
        2.1,
        [0.1, 0.9],
        [-0.6, 0.0],
    )
}

/// A checkpoint sent through JSON.
fn through_json(checkpoint: &Checkpoint) -> Checkpoint {
    let read: Checkpoint = serde_json::from_str(&serde_json::to_string(checkpoint).unwrap()).unwrap();
    assert_eq!(&read, checkpoint);
    read
}

/// 1000 steps in one go, and 400 with 600 more after a pause.
fn check<const D: usize, P: Clone, L, S>(scene: &Scene<D, P, L>, scheme: S, what: &str)
where
    L: Term<D, P> + Clone,
    S: Scheme<SceneSystem<D, L::Ready>>,
    S::Memory: Carried,
{
    let simulation = || Simulation::scene(scene.clone()).scheme(scheme).dt(0.01);
    let mut whole = simulation().stepper().unwrap();
    (0..1000).for_each(|_| whole.step().unwrap());

    let mut first = simulation().stepper().unwrap();
    first.advance(400).unwrap();
    let saved = through_json(&first.checkpoint());
    assert_eq!((saved.steps(), saved.t(), saved.scheme()), (400, first.t(), S::NAME));
    drop(first);
    let mut second = simulation().resume(&saved).unwrap();
    second.advance(600).unwrap();

    let bits = |stepper: &Stepper<SceneSystem<D, L::Ready>, S>| {
        let state = stepper.state();
        let numbers = state.q.into_iter().chain(state.v).flatten().chain([state.t]);
        numbers.map(f64::to_bits).collect::<Vec<_>>()
    };
    assert_eq!(bits(&second), bits(&whole), "{what}, {}", S::NAME);
    assert_ne!(bits(&second), bits(&simulation().stepper().unwrap()), "nothing moved");
    // The whole memory, low parts and past forces with it, and the counts.
    assert_eq!(second.checkpoint(), whole.checkpoint(), "{what}, {}", S::NAME);
}

#[test]
fn scenes_go_on_bit_for_bit() {
    macro_rules! five {
        ($scene:expr, $what:literal) => {{
            let scene = $scene;
            check(&scene, Explicit, $what);
            check(&scene, Leapfrog, $what);
            check(&scene, Boris, $what);
            check(&scene, Implicit, $what);
            check(&scene, DiscreteGradient, $what);
            check(&scene, Kanatani, $what);
            check(&scene, Nystrom::order4(), $what);
            check(&scene, Nystrom::order6(), $what);
            check(&scene, Kanatani.start(Start::BackwardStep).with(Newton::from_previous()), $what);
        }};
    }
    five!(chain().chain(spring(0.25)).pin(0), "chain");
    five!(ions().pairs(Coulomb { k: 1.0 }), "pairs");
    five!(chain().bonds(spring(0.25), [(0, 3), (3, 7), (7, 11), (11, 0), (5, 2)]), "bonds");
    five!(swarm().field(Bowl { k: 0.7, omega: 1.9 }).field(Push { f: 0.4 }), "a force of position and time");
    let braked = swarm().field(Bowl { k: 0.7, omega: 1.9 }).field(Drag { c: 0.2 });
    check(&braked, Explicit, "drag");
    check(&braked, Implicit, "drag");
    check(&braked, DiscreteGradient, "drag");
    let turned = swarm().field(Bowl { k: 0.7, omega: 1.9 }).field(Gyration { b: 0.9 });
    check(&turned, Boris, "magnetic field");
    check(&turned, Composed::order4(Boris), "magnetic field");
}

const START: State<2> = State::new([0.7, -0.4], [0.3, 0.8]);

#[test]
fn single_laws_go_on_bit_for_bit() {
    fn check<L: Law<2> + Clone, S: Scheme<Particle<L, 2>>>(law: L, scheme: S)
    where
        S::Memory: Carried,
    {
        goes_on(|| Simulation::new(law.clone(), START).mass(1.3).scheme(scheme).dt(0.01));
    }
    fn goes_on<L: Law<2>, S: Scheme<Particle<L, 2>>>(simulation: impl Fn() -> Simulation<L, State<2>, S>)
    where
        S::Memory: Carried,
    {
        let mut whole = simulation().stepper().unwrap();
        assert_eq!(through_json(&whole.checkpoint()), whole.checkpoint());
        whole.advance(1000).unwrap();
        let mut first = simulation().stepper().unwrap();
        (0..400).for_each(|_| first.step().unwrap());
        let mut second = simulation().resume(&through_json(&first.checkpoint())).unwrap();
        second.advance(600).unwrap();
        assert_ne!(second.q(), START.q);
        assert_eq!(second.checkpoint(), whole.checkpoint(), "{}", S::NAME);
        assert_eq!((second.t(), second.checkpoint().t()), (whole.t(), whole.t()), "{}", S::NAME);
        let bits = |state: State<2>| [state.q, state.v].map(|x| x.map(f64::to_bits));
        assert_eq!(bits(second.state()), bits(whole.state()), "{}", S::NAME);
    }
    let bowl = Bowl { k: 0.7, omega: 1.9 };
    check(bowl, Explicit);
    check(bowl, Leapfrog);
    check(bowl, CompensatedLeapfrog);
    check(bowl, Boris);
    check(bowl, Implicit);
    check(bowl, DiscreteGradient);
    check(bowl, Kanatani);
    check(bowl, Nystrom::order4());
    check(bowl, Nystrom::order6());
    check(bowl, ForceGradient::order4());
    check(Gyration { b: 0.9 }, Boris);
    check(Gyration { b: 0.9 }, Composed::order6(Boris));
    check(Drag { c: 0.2 }, Explicit);
    check(Drag { c: 0.2 }, Implicit);
    check(Drag { c: 0.2 }, DiscreteGradient);
    let orbit = || Simulation::new(Kepler { gm: 1.7 }, START).mass(1.3);
    goes_on(|| orbit().scheme(DiscreteGradient).adaptive(1e-2));
    goes_on(|| orbit().scheme(Composed::order4(DiscreteGradient)).adaptive(1e-4));
    goes_on(|| orbit().scheme(Composed::order6(Implicit)).adaptive(1e-4));
    let deep = State::new([1.0, 0.0], [0.0, 0.3]);
    goes_on(|| Simulation::new(Core { b: 0.3 }, deep).scheme(Gauss::order16()).adaptive(1e-8));
}

/// Before the first step the state is the start itself, also where the scheme holds it to rounding only.
#[test]
fn a_checkpoint_of_the_start() {
    let stepper = Simulation::scene(swarm().field(Push { f: 0.4 })).scheme(Kanatani).dt(0.01).stepper().unwrap();
    let elsewhere = Scene::new()
        .body(1.3, [1.0, 2.0], [0.0, 0.0])
        .body(0.6, [3.0, 4.0], [0.0, 0.0])
        .body(2.1, [5.0, 6.0], [0.0, 0.0])
        .field(Push { f: 0.4 });
    let resumed = Simulation::scene(elsewhere).scheme(Kanatani).dt(0.01).resume(&stepper.checkpoint()).unwrap();
    assert_eq!(resumed.state(), stepper.state());
}

#[test]
fn another_simulation_is_refused_with_what_differs() {
    fn refused<const D: usize, P, L: Term<D, P>, S>(
        scene: Scene<D, P, L>,
        scheme: S,
        dt: f64,
        saved: &Checkpoint,
        says: &str,
    ) where
        S: Scheme<SceneSystem<D, L::Ready>>,
        S::Memory: Carried,
    {
        let error = Simulation::scene(scene).scheme(scheme).dt(dt).resume(saved).err().expect(says);
        assert!(matches!(error, Error::Checkpoint(_)), "{error}");
        assert_eq!(error.to_string(), format!("cannot resume: {says}"));
    }
    let law = spring(0.25);
    let mut stepper = Simulation::scene(chain().chain(law).pin(0)).scheme(DiscreteGradient).dt(0.01).stepper().unwrap();
    stepper.advance(50).unwrap();
    let saved = &through_json(&stepper.checkpoint());
    let same = || chain().chain(law).pin(0);
    assert_eq!(Simulation::scene(same()).scheme(DiscreteGradient).dt(0.01).resume(saved).unwrap().steps(), 50);

    let more = chain().body(1.0, [0.1], [0.0]).chain(law).pin(0);
    refused(more, DiscreteGradient, 0.01, saved, "the checkpoint has 12 bodies, this scene 13");
    refused(same(), DiscreteGradient, 0.02, saved, "dt is 0.01 in the checkpoint against 0.02");
    refused(same(), Leapfrog, 0.01, saved, "the checkpoint is of DiscreteGradient, this simulation of Leapfrog");
    let options = DiscreteGradient.with(Newton::from_previous());
    let apart = "the scheme has other options: `guess: Predicted` in the checkpoint against `guess: Previous`";
    refused(same(), options, 0.01, saved, apart);
    refused(same().at_time(2.0), DiscreteGradient, 0.01, saved, "the start is at t = 0 in the checkpoint against 2");
    let pinned = "body 0 is pinned in the checkpoint and free in this scene";
    refused(chain().chain(law), DiscreteGradient, 0.01, saved, pinned);
    let free = "body 4 is free in the checkpoint and pinned in this scene";
    let still = (0..12).fold(Scene::new(), |scene, i| scene.body(1.0 + 0.1 * f64::from(i), [0.1], [0.0]));
    refused(still.chain(law).pin(0).pin(4), DiscreteGradient, 0.01, saved, free);
    let heavier = (0..12)
        .fold(Scene::new(), |scene, i| scene.body(if i == 3 { 7.5 } else { 1.0 + 0.1 * f64::from(i) }, [0.1], [0.0]));
    let mass = format!("body 3 has another mass: {} in the checkpoint against 7.5", 1.0 + 0.1 * 3.0);
    refused(heavier.chain(law).pin(0), DiscreteGradient, 0.01, saved, &mass);
    let plane = (0..12).fold(Scene::<2>::new(), |scene, i| scene.body(1.0, [f64::from(i), 0.1], [0.0, 0.0]));
    let dimension = "the dimension is 1 in the checkpoint against 2";
    refused(plane.field(Push { f: 0.4 }), DiscreteGradient, 0.01, saved, dimension);

    let laws = Difference::Laws.to_string();
    let next = spring(0.25f64.next_up());
    let field = "the laws differ: `alpha` is not what it is in the checkpoint";
    refused(chain().chain(next).pin(0), DiscreteGradient, 0.01, saved, field);
    let bonded = chain().bonds(law, (1..11).map(|i| (i - 1, i))).pin(0);
    refused(bonded, DiscreteGradient, 0.01, saved, &laws);
}

/// At rest in equilibrium no law does anything; the displaced positions show which it is.
#[test]
fn laws_are_told_apart_where_nothing_acts() {
    let rest = || (0..5).fold(Scene::<1>::new(), |scene, _| scene.body(1.0, [0.0], [0.0]));
    let saved = |alpha| {
        let simulation = Simulation::scene(rest().chain(spring(alpha))).scheme(Implicit).dt(0.1);
        simulation.stepper().unwrap().checkpoint()
    };
    let resume =
        |saved: &Checkpoint| Simulation::scene(rest().chain(spring(0.25))).scheme(Implicit).dt(0.1).resume(saved);
    assert!(resume(&saved(0.25)).is_ok());
    assert_eq!(resume(&saved(0.26)).err(), Some(Error::Checkpoint(Difference::Field { name: "alpha" })));

    let rest = |c| {
        let still = Scene::new().body(1.0, [0.3, 0.4], [0.0, 0.0]).body(2.0, [0.6, -0.4], [0.0, 0.0]);
        Simulation::scene(still.field(Drag { c })).scheme(Implicit).dt(0.1)
    };
    let saved = rest(0.2).stepper().unwrap().checkpoint();
    assert!(rest(0.2).resume(&saved).is_ok());
    assert_eq!(rest(0.3).resume(&saved).err(), Some(Error::Checkpoint(Difference::Field { name: "c" })));
    // So do the data of the bodies.
    let charged = |q| {
        let scene = Scene::new().body_with(1.0, [1.2, 0.0, 0.2], [0.0; 3], Charge { q }).body_with(
            6.0,
            [0.0, 0.1, 0.0],
            [0.0; 3],
            Charge { q: -1.5 },
        );
        Simulation::scene(scene.pairs(Coulomb { k: 1.0 })).scheme(Leapfrog).dt(0.01)
    };
    let saved = charged(1.0).stepper().unwrap().checkpoint();
    assert!(charged(1.0).resume(&saved).is_ok());
    let data = Difference::Field { name: "data of the bodies" };
    assert_eq!(charged(1.1).resume(&saved).err(), Some(Error::Checkpoint(data)));
}

#[test]
fn damaged_checkpoints_are_refused() {
    let simulation = || Simulation::scene(ions().pairs(Coulomb { k: 1.0 })).scheme(Implicit).dt(0.01);
    let mut stepper = simulation().stepper().unwrap();
    stepper.advance(3).unwrap();
    let whole = serde_json::to_value(stepper.checkpoint()).unwrap();
    let refusal = |change: &dyn Fn(&mut serde_json::Value)| {
        let mut damaged = whole.clone();
        change(&mut damaged);
        let read: Checkpoint = serde_json::from_value(damaged).unwrap();
        simulation().resume(&read).err().unwrap()
    };
    let difference = |found, expected| Error::Checkpoint(Difference::Damaged { found, expected });
    assert_eq!(refusal(&|x| x["memory"][2] = "1.5 2.5".into()), difference(2, 9));
    assert_eq!(refusal(&|x| drop(x["memory"].as_array_mut().unwrap().pop())), difference(6, 7));
    assert_eq!(refusal(&|x| x["masses"] = "".into()), difference(0, 3));
    assert_eq!(refusal(&|x| x["start"] = serde_json::json!(["1.0"])), difference(1, 2));
    assert_eq!(refusal(&|x| x["format"] = 9.into()), Error::Checkpoint(Difference::Format { checkpoint: 9, here: 4 }));
    assert_eq!(refusal(&|x| x["seals"] = serde_json::json!([])), difference(0, 6));
}

/// Whatever is changed in a checkpoint is noticed, and said.
#[test]
fn edited_checkpoints_are_refused() {
    fn check(whole: &Checkpoint, resume: &dyn Fn(&Checkpoint) -> Option<Error>) {
        let whole = serde_json::to_value(whole).unwrap();
        let refusal = |change: &dyn Fn(&mut serde_json::Value)| {
            let mut edited = whole.clone();
            change(&mut edited);
            assert_ne!(edited, whole, "nothing was edited");
            let edited: Checkpoint = serde_json::from_value(edited).unwrap();
            resume(&edited).expect("an edited checkpoint was taken")
        };
        let edited = |part| Error::Checkpoint(Difference::Edited { part });
        // One number of a list, by an ulp.
        let nudge = |list: &mut serde_json::Value, i: usize| {
            let mut numbers: Vec<f64> = list.as_str().unwrap().split(' ').map(|x| x.parse().unwrap()).collect();
            numbers[i] = numbers[i].next_up();
            *list = numbers.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(" ").into();
        };
        for (part, lists) in [("start", "start"), ("memory of the scheme", "memory")] {
            let lists_of = whole[lists].as_array().unwrap().len();
            for list in 0..lists_of {
                assert_eq!(refusal(&|x| nudge(&mut x[lists][list], 0)), edited(part), "{lists} {list}");
            }
            assert_eq!(refusal(&|x| x[lists].as_array_mut().unwrap().swap(0, 1)), edited(part));
        }
        let counts = edited("count of steps, evaluations or iterations");
        for count in ["steps", "evaluations", "iterations"] {
            for wrong in [1_u64, 1 << 60, u64::MAX] {
                assert_eq!(refusal(&|x| x[count] = wrong.into()), counts, "{count} = {wrong}");
            }
        }
        assert_eq!(refusal(&|x| nudge(&mut x["times"], 2)), edited("scheme, time step or time"));
        assert_eq!(refusal(&|x| x["laws"] = "0123456789abcdef".into()), edited("fingerprint of the laws"));
        assert_eq!(refusal(&|x| x["fields"] = serde_json::json!([])), edited("fingerprint of the laws"));
        println!("{counts}");
    }
    let single = || Simulation::new(Kepler { gm: 1.7 }, START).mass(1.3).scheme(DiscreteGradient).dt(0.01);
    let mut stepper = single().stepper().unwrap();
    stepper.advance(30).unwrap();
    check(&stepper.checkpoint(), &|saved| single().resume(saved).err());
    let adaptive = || Simulation::new(Kepler { gm: 1.7 }, START).scheme(Composed::order4(Implicit)).adaptive(1e-5);
    let mut stepper = adaptive().stepper().unwrap();
    stepper.advance(30).unwrap();
    check(&stepper.checkpoint(), &|saved| adaptive().resume(saved).err());
    let scene = || Simulation::scene(ions().pairs(Coulomb { k: 1.0 }).pin(1)).scheme(Implicit).dt(0.01);
    let still = || {
        let scene = Scene::new().body_with(1.0, [1.2, 0.0, 0.2], [0.0, 1.05, 0.0], Charge { q: 1.0 }).body_with(
            6.0,
            [0.0, 0.1, 0.0],
            [0.0; 3],
            Charge { q: -1.5 },
        );
        Simulation::scene(scene.pairs(Coulomb { k: 1.0 }).pin(1)).scheme(Implicit).dt(0.01)
    };
    assert!(scene().stepper().is_err(), "a pinned body that moves");
    let mut stepper = still().stepper().unwrap();
    stepper.advance(30).unwrap();
    check(&stepper.checkpoint(), &|saved| still().resume(saved).err());
}

/// A field that does nothing at the saved state, nor around it, is one of the law all the same.
#[test]
fn fields_that_matter_only_later_are_known() {
    let refused = |name| Some(Error::Checkpoint(Difference::Field { name }));
    // The drive is not felt yet: sin ωt = 0.
    let driven = |amplitude, omega| {
        let law = DrivenPendulum { amplitude, omega, ..DrivenPendulum::default() };
        Simulation::new(law, State::new([0.4], [0.1])).scheme(Implicit).dt(0.05)
    };
    let saved = driven(0.5, 1.2).stepper().unwrap().checkpoint();
    assert!(driven(0.5, 1.2).resume(&saved).is_ok());
    assert_eq!(driven(0.7, 1.2).resume(&saved).err(), refused("amplitude"));
    assert_eq!(driven(0.5, 1.3).resume(&saved).err(), refused("omega"));
    // The wall is not touched.
    let wall = |k| Simulation::new(Wall { k, pull: 0.3 }, State::new([50.0], [0.0])).scheme(DiscreteGradient).dt(0.05);
    let saved = wall(1e3).stepper().unwrap().checkpoint();
    assert!(wall(1e3).resume(&saved).is_ok());
    assert_eq!(wall(2e3).resume(&saved).err(), refused("k"));
    // Fields that are no numbers that could be saved.
    let capped = |cap| Simulation::new(Capped { cap }, State::new([0.3], [0.0])).scheme(Leapfrog).dt(0.1);
    let saved = through_json(&capped(f64::INFINITY).stepper().unwrap().checkpoint());
    assert!(capped(f64::INFINITY).resume(&saved).is_ok());
    assert_eq!(capped(f64::MAX).resume(&saved).err(), refused("cap"));
    // In scenes: the fields of laws on bodies and between them, what they read of bodies, and whom they link.
    let scene = |k, cap, links: [(usize, usize); 2]| {
        let bodies = (0..4).fold(Scene::new(), |scene, i| scene.body(1.0, [50.0 + f64::from(i)], [0.0]));
        let scene = bodies.field(Wall { k, pull: 0.3 }).bonds(Tether { cap }, links);
        Simulation::scene(scene).scheme(DiscreteGradient).dt(0.05)
    };
    let links = [(0, 1), (2, 3)];
    let saved = through_json(&scene(1e3, 60.0, links).stepper().unwrap().checkpoint());
    assert!(scene(1e3, 60.0, links).resume(&saved).is_ok());
    assert_eq!(scene(2e3, 60.0, links).resume(&saved).err(), refused("k"));
    assert_eq!(scene(1e3, 61.0, links).resume(&saved).err(), refused("cap"));
    assert_eq!(scene(1e3, 60.0, [(0, 1), (1, 2)]).resume(&saved).err(), refused("list of bonds"));
    let charged = |q| {
        let body = |scene: Scene<3, Charge>, x, q| scene.body_with(1.0, [x, 0.0, 0.0], [0.0; 3], Charge { q });
        let scene = body(body(Scene::new(), 0.0, 0.0), 1.0, q);
        Simulation::scene(scene.pairs(Coulomb { k: 1.0 })).scheme(Leapfrog).dt(0.01)
    };
    // Beside a body without charge no charge is felt.
    let saved = charged(1.0).stepper().unwrap().checkpoint();
    assert!(charged(1.0).resume(&saved).is_ok());
    assert_eq!(charged(1.5).resume(&saved).err(), refused("data of the bodies"));
}

/// k q²/2 up to a cap of the force.
#[derive(Clone, Copy, Debug)]
struct Capped {
    cap: f64,
}

#[dmech::law]
impl Capped {
    #[potential]
    fn energy(&self, q: f64) -> f64 {
        let cap = self.cap;
        if q.abs() < cap { 0.5 * q * q } else { cap * q.abs() - 0.5 * cap * cap }
    }
}

/// A rope that is slack up to a length.
#[derive(Clone, Copy, Debug)]
struct Tether {
    cap: f64,
}

#[dmech::law]
impl Tether {
    #[pair]
    fn energy(&self, r: f64) -> f64 {
        let stretch = (r - self.cap).max(0.0);
        stretch * stretch
    }
}

/// What is another in the options is told, also where they stand within those of a scheme within.
#[test]
fn other_options_are_named() {
    let orbit = || Simulation::new(Kepler::default(), State::new([1.0, 0.0], [0.0, 0.8]));
    let mut stepper = orbit().scheme(Gauss::order16()).adaptive(1e-6).stepper().unwrap();
    stepper.advance(5).unwrap();
    let refused = |error: Option<Error>| error.unwrap().to_string();
    let said = refused(orbit().scheme(Gauss::order16()).adaptive(1e-7).resume(&stepper.checkpoint()).err());
    assert!(
        said.ends_with("has other options: `tolerance: 1e-6` in the checkpoint against `tolerance: 1e-7`"),
        "{said}"
    );
    let within = |newton| orbit().scheme(Composed::order4(Implicit.with(newton))).dt(0.01);
    let saved = within(Newton::from_previous()).stepper().unwrap().checkpoint();
    let said = refused(within(Newton::predicted()).resume(&saved).err());
    assert!(said.ends_with("`guess: Previous` in the checkpoint against `guess: Predicted`"), "{said}");
}
