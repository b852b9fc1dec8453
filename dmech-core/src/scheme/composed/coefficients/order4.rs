//! Sets of order 4.

use super::{Coefficients, palindrome, set};

set! {
    /// Order 4 in 3 stages. The triple jump: γ₁ = γ₃ = 1/(2 − 2^{1/3}), γ₂ = 1 − 2γ₁. The fewest stages, and the largest error.
    ///
    /// # Reference
    /// M. Creutz and A. Gocksch, Phys. Rev. Lett. 63 (1989) 9; E. Forest, AIP Conf. Proc. 184 (1989) 1106; M. Suzuki, Phys.
    /// Lett. A 146 (1990) 319; H. Yoshida, Phys. Lett. A 150 (1990) 262.
    pub struct TripleJump4: Coefficients<3>, order 4;
    GAMMA = palindrome([1.351207191959657634047688, -1.702414383919315268095376]);
}

set! {
    /// Order 4 in 5 stages. Suzuki's fractal: γ₁ = γ₂ = γ₄ = γ₅ = 1/(4 − 4^{1/3}), γ₃ = 1 − 4γ₁. No stage is longer than
    /// 0.66 of the step.
    ///
    /// # Reference
    /// M. Suzuki, Phys. Lett. A 146 (1990) 319–323.
    pub struct Suzuki4: Coefficients<5>, order 4;
    GAMMA = palindrome([0.4144907717943757371423541, 0.4144907717943757371423541, -0.6579630871775029485694163]);
    LOW = palindrome([2.5197374150855977e-17, 2.5197374150855977e-17, 1.023280585909174e-17]);
}

set! {
    /// Order 4 in 7 stages. Suzuki's fractal with three steps on either side: γ = 1/(6 − 6^{1/3}) but for γ₄ = 1 − 6γ. No
    /// stage is longer than 0.44 of the step.
    ///
    /// At equal cost the energy-exact steps have 0.56 of the error of [`Suzuki4`] (0.49 to 0.56 on Kepler's problem at e = 0.33
    /// and 0.7, the pendulum, Hénon and Heiles, a quartic and an anharmonic well), leap-frog 0.58 to 1.05.
    ///
    /// # Reference
    /// M. Suzuki, Phys. Lett. A 146 (1990) 319–323.
    pub struct Suzuki4S7: Coefficients<7>, order 4;
    GAMMA = palindrome([
        0.23906976574232126017724705,
        0.23906976574232126017724705,
        0.23906976574232126017724705,
        -0.4344185944539275610634823,
    ]);
    LOW = palindrome([1.0519782117784042e-17, 1.0519782117784042e-17, 1.0519782117784042e-17, -7.607541475446419e-18]);
}

set! {
    /// Order 4 in 5 stages. McLachlan's five stages.
    ///
    /// # Reference
    /// R. I. McLachlan, SIAM J. Sci. Comput. 16 (1995) 151–168; also B. Leimkuhler and S. Reich, Simulating Hamiltonian
    /// Dynamics (2004), table 6.2.
    pub struct McLachlan4: Coefficients<5>, order 4;
    GAMMA = palindrome([0.28, 0.62546642846767004501, -0.81093285693534009002]);
}
