//! Constants beside laws, called like the variables of what is written for them: `const c` is the speed of light, and `length` a field
//! and the constant that it is given.
#![deny(warnings)]
#![allow(non_upper_case_globals, dead_code)]

/// All names that are not arguments of a law below, and these.
macro_rules! constants {
    ($($name:ident)*) => {
        constants! { @ $($name)*
            a_q abs_y abs_ya abs_yb alpha b_q c change data delta delta0 delta1 drift0 drift1 e epsilon equation
            friction g gm h height inv_length inv_r10 inv_r12 inv_r14 inv_r16 inv_r2 inv_r4 inv_r6 inv_r8 inv_ra12
            inv_ra2 inv_ra4 inv_ra6 inv_rb12 inv_rb14 inv_rb2 inv_rb4 inv_rb6 inv_rb8 inv_s inv_s2 inv_s3 inv_s4 inv_sb
            inv_sb2 inv_sb3 k lambda law law_b law_g length ma mass mb place positive pull r2 r4 ra ra2 ra4 ra6 rate rb
            rb2 rb4 rb6 rhs0 rhs1 s sa sb see sigma sigma12 sigma2 sigma3 sigma6 signum_y signum_ya signum_yb slope
            sqrt_s sqrt_sa sqrt_sb t0 t1 t2 t3 t4 t5 t6 t7 t8 t9 top turned vx vxa vxa2 vy vya x x2 xa xa2 xb xb2 y y2
            y3 ya ya2 yb yb2
        }
    };
    (@ $($name:ident)*) => {
        $(const $name: f64 = 1.5;)*
        /// Of which none is a variable.
        const ALL: &[f64] = &[$($name),*];
    };
}

mod of_one {
    constants! { v m t r a b d va vb }
    static omega: f64 = 0.7;

    pub struct Central {
        pub gm: f64,
        pub mass: f64,
    }

    #[dmech::law]
    impl Central {
        #[potential]
        fn energy(&self, q: [f64; 2]) -> f64 {
            -self.gm * self.mass / (q[0] * q[0] + q[1] * q[1]).sqrt()
        }
    }

    pub struct Coupled {
        pub lambda: f64,
        pub omega: f64,
    }

    #[dmech::law]
    impl Coupled {
        #[potential]
        fn energy(&self, q: [f64; 2]) -> f64 {
            (self.lambda * q[0] * q[1]).sin()
                + self.omega * q[0].powi(4)
                + q[1].abs() * if q[0] < q[1] { q[0] } else { q[1] }
        }
        #[invariant]
        fn nothing(&self, q: [f64; 2]) -> f64 {
            0.0 * q[0] * q[1] * self.omega
        }
    }

    pub fn all() -> (Central, Coupled) {
        assert!(ALL.len() > 100);
        (Central { gm, mass }, Coupled { lambda, omega })
    }
}

mod of_time {
    constants! { v r a b d va vb }

    pub struct Spring {
        pub k: f64,
    }

    #[dmech::law]
    impl Spring {
        #[potential]
        fn energy(&self, q: [f64; 2], m: f64, t: f64) -> f64 {
            0.5 * m * self.k * (q[0] * q[0] + 2.0 * q[1] * q[1]) + q[0] * t.cos()
        }
    }

    pub fn all() -> Spring {
        Spring { k }
    }
}

mod of_velocity {
    constants! { m t r a b d va vb }

    pub struct Magnet {
        pub b: f64,
        pub c: f64,
    }

    #[dmech::law]
    impl Magnet {
        #[potential]
        fn well(&self, q: [f64; 2]) -> f64 {
            q[0].powi(4) + q[1] * q[1]
        }
        #[force]
        fn lorentz(&self, q: [f64; 2], v: [f64; 2]) -> [f64; 2] {
            [self.b * q[0] * v[1], -self.b * q[0] * v[0]]
        }
    }

    pub struct Damped {
        pub c: f64,
    }

    #[dmech::law]
    impl Damped {
        #[potential]
        fn well(&self, q: [f64; 2]) -> f64 {
            q[0].powi(4) + q[1] * q[1]
        }
        #[force]
        fn drag(&self, v: [f64; 2]) -> [f64; 2] {
            [-self.c * v[0], -self.c * v[1]]
        }
    }

    pub fn all() -> (Magnet, Damped) {
        (Magnet { b, c }, Damped { c })
    }
}

mod of_two {
    constants! { q v m t d va vb }

    pub struct Ion {
        pub charge: f64,
    }

    pub struct Attract {
        pub sigma: f64,
        pub epsilon: f64,
    }

    #[dmech::law]
    impl Attract {
        #[pair]
        fn energy(&self, r: f64, a: &Ion, b: &Ion) -> f64 {
            4.0 * self.epsilon * ((self.sigma / r).powi(12) - (self.sigma / r).powi(6)) + a.charge * b.charge / r
        }
    }

    pub fn all() -> Attract {
        Attract { sigma, epsilon }
    }
}

use dmech::prelude::*;

fn main() {
    let ((central, coupled), spring, (magnet, damped)) = (of_one::all(), of_time::all(), of_velocity::all());
    macro_rules! moves {
        ($($law:ident)*) => {$(
            let simulation = Simulation::new($law, State::new([0.3, 0.6], [0.1, 0.2])).dt(0.01);
            assert_ne!(simulation.scheme(DiscreteGradient).run(10).unwrap().last().q[0], 0.3);
        )*};
    }
    moves! { central coupled spring magnet damped }
    let scene = Scene::new().body_with(1.0, [0.0, 0.1], [0.0; 2], of_two::Ion { charge: 0.3 });
    let scene = scene.body_with(1.0, [1.6, 0.3], [0.0; 2], of_two::Ion { charge: 0.2 }).pairs(of_two::all());
    let run = Simulation::scene(scene).scheme(DiscreteGradient).dt(0.01).run(10).unwrap();
    assert_ne!(run.last().q[0], [0.0, 0.1]);
}
