//! Motions that die away: they come to rest, however small the numbers become on the way.

use dmech::extend::Real;
use dmech::models::DampedPendulum;
use dmech::prelude::*;

/// Two coupled pendulums in a medium.
#[derive(Clone, Copy, Debug)]
struct Coupled;

#[dmech::law]
impl Coupled {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        -q[0].cos() - 1.7 * (0.3 * q[0] + q[1]).cos()
    }

    #[force]
    fn drag(&self, v: [f64; 2]) -> [f64; 2] {
        v.map(|v| -1.1 * v)
    }
}

/// A soft link.
#[derive(Clone, Copy, Debug)]
struct Link;

#[dmech::law]
impl Link {
    #[pair]
    fn energy(&self, d: [f64; 2]) -> f64 {
        let r2 = d[0] * d[0] + d[1] * d[1];
        0.5 * r2 + 0.25 * r2 * r2
    }
}

/// A pendulum in one or two coordinates from `size` on, which is near the end, so that few steps lead through the smallest
/// numbers of a scalar; how many of these are left.
macro_rules! dies {
    ($R:ident, $scheme:expr, $size:expr, $smallest:expr) => {{
        let mut left = vec![];
        for dt in [0.05, 0.1, 0.23, 0.37, 0.5] {
            let law = DampedPendulum { k: 1.3, alpha: 1.0 };
            let [one, other] = [1.0, -0.3].map(|x| $R::from_f64(x * $size));
            let alone = Simulation::new(law, State::of([one], [other])).scheme($scheme).dt(dt).record_every(1000);
            let both = Simulation::new(Coupled, State::of([one, other], [other, one])).scheme($scheme).dt(dt);
            let (alone, both) = (alone.run(4000), both.record_every(1000).run(4000));
            left.extend(alone.unwrap_or_else(|e| panic!("{dt}: {e}")).last().q.map(|x| x.to_f64() / $smallest));
            left.extend(both.unwrap_or_else(|e| panic!("{dt}: {e}")).last().q.map(|x| x.to_f64() / $smallest));
        }
        // The force of what is left, times g, is less than half of the smallest number.
        assert!(left.iter().all(|x| x.abs() < 1e4), "{left:?}");
    }};
}

// A pendulum of some mass in a medium, each coordinate by itself.
law!(Light, 2, |self, q| -self.k * (q[0].cos() + 1.3 * q[1].cos()), |v| v.map(|v| -self.k * v));

/// Forces of light bodies are below the smallest number long before their positions are.
#[test]
fn light_bodies_come_to_rest() {
    for mass in [1e-3, 1e-6, 1e-12] {
        for dt in [0.05, 0.2] {
            let law = Light { k: mass };
            let alone = || {
                Simulation::new(law, State::new([1e-290, 3e-291], [0.0, 1e-291])).mass(mass).dt(dt).record_every(9000)
            };
            let bodies = || {
                let one = Scene::new().body(mass, [1e-290, 3e-291], [0.0, 1e-291]);
                let two = one.body(1.7 * mass, [5e-291, -2e-291], [3e-291, 0.0]);
                Simulation::scene(two.field(law)).dt(dt).record_every(9000)
            };
            let laws = [alone().scheme(DiscreteGradient).run(3000), alone().scheme(Implicit).run(3000)];
            let scenes = [bodies().scheme(DiscreteGradient).run(3000), bodies().scheme(Implicit).run(3000)];
            let left = laws.map(|run| run.unwrap_or_else(|e| panic!("{mass}, {dt}: {e}")).last().q[0].abs());
            assert!(left.iter().all(|left| left * mass < 1e-320), "{mass}, {dt}: {left:?}");
            let left = scenes.map(|run| run.unwrap_or_else(|e| panic!("{mass}, {dt}: {e}")).last().q[0][0].abs());
            assert!(left.iter().all(|left| left * mass < 1e-320), "{mass}, {dt}: {left:?}");
        }
    }
}

/// An implicit step has a root where all of its numbers are the smallest that there are.
#[test]
fn implicit_steps_of_laws_come_to_rest() {
    let tiny = f64::from_bits(1);
    dies!(f64, DiscreteGradient, 1e-310, tiny);
    dies!(f64, Implicit, 1e-310, tiny);
    dies!(f64, Composed::order4(DiscreteGradient), 1e-310, tiny);
    dies!(f32, DiscreteGradient, 1e-36, 2f64.powi(-149));
    dies!(f32, Implicit, 1e-36, 2f64.powi(-149));
    dies!(DoubleDouble, DiscreteGradient, 1e-310, tiny);
    dies!(DoubleDouble, Implicit, 1e-300, tiny);
}

/// And of bodies: each in a field, in chains, in pairs.
#[test]
fn implicit_steps_of_scenes_come_to_rest() {
    let still = || {
        let place = |i: f64| [1e-310 * (1.0 + 0.3 * i), -1e-310 * i];
        (0..4)
            .fold(Scene::new(), |scene, i| scene.body(1.0 + 0.2 * f64::from(i), place(i.into()), [0.0; 2]))
            .field(Coupled)
    };
    macro_rules! rests {
        ($scene:expr) => {
            for dt in [0.1, 0.23, 0.37, 0.5] {
                let of = || Simulation::scene($scene).dt(dt).record_every(1000);
                let runs = [of().scheme(DiscreteGradient).run(4000), of().scheme(Implicit).run(4000)];
                for run in runs {
                    let last = run.unwrap_or_else(|e| panic!("{dt}: {e}")).last().q.clone();
                    assert!(last.iter().flatten().all(|x| x.abs() < 1e-318), "{dt}: {last:?}");
                }
            }
        };
    }
    rests!(still());
    rests!(still().chain(Link));
    rests!(still().pairs(Link));
}

/// Wells that are flat at their centre, made of roots.
#[derive(Clone, Copy, Debug)]
struct Well;

#[dmech::law]
impl Well {
    #[potential]
    fn energy(&self, q: [f64; 2]) -> f64 {
        let r = q[0].hypot(q[1]);
        (q[0].powi(4) + q[1].powi(4)).sqrt() + r * r.tanh()
    }
}

/// Two bodies that repel each other, and do so least where they meet.
#[derive(Clone, Copy, Debug)]
struct Repulsion;

#[dmech::law]
impl Repulsion {
    #[pair]
    fn energy(&self, r: f64) -> f64 {
        -r.powf(1.5)
    }

    #[pair_force]
    fn drag(&self, va: [f64; 2], vb: [f64; 2]) -> [f64; 2] {
        let v = [va[0] - vb[0], va[1] - vb[1]];
        v.map(|x| -x * v[0].hypot(v[1]).sqrt())
    }
}

/// What rests at a centre stays there, and what is pushed off it is followed, its energy kept.
#[test]
fn implicit_steps_start_at_a_centre_made_of_roots() {
    for v in [[0.0, 0.0], [0.3, -0.2], [1e-160, 0.0]] {
        let of = || Simulation::new(Well, State::new([0.0, 0.0], v)).dt(0.1);
        let runs = [of().scheme(DiscreteGradient).run(200), of().scheme(Implicit).run(200)];
        let [exact, _] = runs.map(|run| run.unwrap_or_else(|e| panic!("{v:?}: {e}")));
        assert!(exact.drift(Invariant::Energy).unwrap().max_abs() < 1e-14, "{v:?}");
        assert!(v != [0.0, 0.0] || exact.last().q == [0.0, 0.0]);
    }
    let pair = || Scene::new().body(1.0, [0.2, 0.1], [0.0; 2]).body(2.0, [0.2, 0.1], [0.0; 2]).pairs(Repulsion);
    let of = || Simulation::scene(pair()).dt(0.1);
    for run in [of().scheme(DiscreteGradient).run(50), of().scheme(Implicit).run(50)] {
        assert_eq!(run.unwrap().last().q[0], [0.2, 0.1]);
    }
}
