//! Motions on which time steps fail: what must hold there for every scheme. The cases are those of the example
//! `hard_cases`, which prints and draws them; here the runs are shorter.
//!
//! In all of them every recorded state is finite and stands at the time of its step, a run that does not reach its end
//! says at which step and why, and what a scheme keeps exactly is kept to rounding.

use crate::cases::{CASES, Length};

/// Everything that a case states; how many statements there must be at least, so that none is without.
fn holds(name: &str, at_least: usize) {
    let (_, case) = CASES.iter().find(|(known, _)| *known == name).expect("a case");
    let case = case(Length::Test);
    assert_eq!(case.name, name);
    let failures: Vec<_> = case.checks.iter().filter(|check| !check.holds()).collect();
    for check in &failures {
        println!("{}: {:e}, and may be {:e}", check.what, check.value, check.most);
    }
    assert!(failures.is_empty(), "{} of {} statements do not hold", failures.len(), case.checks.len());
    assert!(case.checks.len() >= at_least, "only {} statements", case.checks.len());
    assert!(!case.rows.is_empty() && !case.hard.is_empty() && !case.holds.is_empty());
}

macro_rules! cases {
    ($($name:ident, $at_least:expr;)*) => {
        $(
            #[test]
            fn $name() {
                holds(stringify!($name), $at_least);
            }
        )*

        #[test]
        fn every_case_is_tested() {
            assert_eq!(CASES.iter().map(|(name, _)| *name).collect::<Vec<_>>(), [$(stringify!($name)),*]);
        }
    };
}

cases! {
    kepler, 80;
    collision, 40;
    stiff, 45;
    summit, 50;
    henon_heiles, 45;
    pythagoras, 30;
    figure_eight, 90;
    atoms, 500;
    wall, 40;
    damping, 30;
    van_der_pol, 14;
    duffing, 40;
    long_chain, 15;
    scales, 200;
}
