//! Published sets of drifts and kicks; a test holds them to every order condition.
//!
//! McLachlan's digits are those of the source. Blanes and Moan print 15, which hold the conditions to 2·10⁻¹⁶; theirs are
//! continued to the nearest 25 that hold them to 10⁻²⁵. Those of order 8 are 25 of 30 that hold them to 5·10⁻³¹.

use crate::scheme::set::set;
use crate::scheme::splitting::{First, opening, palindrome};

/// The lengths of the drifts a₁, … and kicks b₁, … of a Runge–Kutta–Nyström splitting, in units of the step.
///
/// A step that begins with a drift is a₁ b₁ a₂ b₂ … a_N b_N a₁, one that begins with a kick b₁ a₁ b₂ a₂ … b_N a_N b₁; both
/// read the same from either end. With an implementation of your own, [`Nystrom::new`](crate::Nystrom::new) takes other sets.
pub trait NystromCoefficients<const KICKS: usize>: Copy + core::fmt::Debug {
    /// The name in reports.
    const NAME: &'static str;
    /// The order for q″ = a(q).
    const ORDER: u32;
    /// The angle in radians by which a step turns the linearised motion when it errs by 10⁻⁶ of the half-axis in a revolution
    /// of a Kepler orbit of eccentricity 0.9: what [`Simulation::adaptive`](crate::Simulation::adaptive) goes by. Measured.
    const TURN: f64 = 0.3;
    /// What the step begins with.
    const FIRST: First;
    /// a₁, …, a_N; a palindrome where the step begins with a kick, else x_k = x_{N+2−k}.
    const DRIFTS: [f64; KICKS];
    /// b₁, …, b_N; a palindrome where the step begins with a drift, else x_k = x_{N+2−k}.
    const KICKS: [f64; KICKS];
}

set! {
    /// Order 4 in 4 kicks, of lengths 1, −½, −½, 1. McLachlan's fewest.
    ///
    /// # Reference
    /// R. I. McLachlan, SIAM J. Sci. Comput. 16 (1995) 151–168, SB³A 4.
    pub struct McLachlan4S4: NystromCoefficients<4>, order 4, turn 0.11, first Drift;
    DRIFTS = opening([0.18819521776883821787, -0.021528551102171551201, 0.66666666666666666667]);
    KICKS = palindrome([1.0, -0.5]);
}

set! {
    /// Order 4 in 5 kicks.
    ///
    /// # Reference
    /// R. I. McLachlan, SIAM J. Sci. Comput. 16 (1995) 151–168, SB³A 5.
    pub struct McLachlan4S5: NystromCoefficients<5>, order 4, turn 0.143, first Drift;
    DRIFTS = opening([0.4051886183952522772, -0.2871440408165240890, 0.3819554224212718118]);
    KICKS = palindrome([-0.041095890410958904110, 0.28813559322033898305, 0.50592059438123984212]);
}

set! {
    /// Order 4 in 6 kicks. Blanes and Moan's SRKN₆ᵇ: no drift is longer than 0.61 of the step.
    ///
    /// # Reference
    /// S. Blanes and P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313–330, table 3.
    pub struct BlanesMoan4S6: NystromCoefficients<6>, order 4, turn 0.34, first Kick;
    DRIFTS = palindrome([0.2452989571842711626039324, 0.6048726657110799749608927, -0.3501716228953511375648251]);
    KICKS = opening([
        0.08298440641740501883834748,
        0.3963098014983680770949115,
        -0.03905630492234843517086529,
        0.1195241940131506784752126,
    ]);
}

set! {
    /// Order 6 in 7 kicks, the fewest; three of them step backward, and its error is large. Okunbor and Skeel's method 13.
    ///
    /// # Reference
    /// D. I. Okunbor and R. D. Skeel, J. Comput. Appl. Math. 51 (1994) 375–382; digits as in R. I. McLachlan, SIAM J. Sci.
    /// Comput. 16 (1995) 151–168.
    pub struct OkunborSkeel6S7: NystromCoefficients<7>, order 6, turn 0.245, first Drift;
    DRIFTS = opening([-1.0130879789171747298, 1.1874295737325427070, -0.018335852096460590340, 0.34399425728109261313]);
    KICKS = palindrome([
        0.00016600692650009894,
        -0.37962421426377360608,
        0.68913741185181063674,
        0.38064159097092574080,
    ]);
}

set! {
    /// Order 6 in 11 kicks. Blanes and Moan's SRKN₁₁ᵇ.
    ///
    /// # Reference
    /// S. Blanes and P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313–330, table 3.
    pub struct BlanesMoan6S11: NystromCoefficients<11>, order 6, turn 0.66, first Kick;
    DRIFTS = palindrome([
        0.1232297759462711515610864,
        0.2905537977995582703664142,
        -0.1270492126254169156625051,
        -0.2463317610620754041949735,
        0.3572088727959277526198603,
        0.2047770542914702906202353,
    ]);
    KICKS = opening([
        0.04146499851826284329877813,
        0.1981286719180665411367265,
        -0.04000619210415268688882836,
        0.07525398430158034112787888,
        -0.0115113874206877700624432,
        0.2366699247869307313878881,
    ]);
}

set! {
    /// Order 6 in 14 kicks. Blanes and Moan's SRKN₁₄ᵃ: no drift is longer than 0.32 of the step.
    ///
    /// # Reference
    /// S. Blanes and P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313–330, table 3.
    pub struct BlanesMoan6S14: NystromCoefficients<14>, order 6, turn 0.84, first Drift;
    DRIFTS = opening([
        0.03785931984061094144702118,
        0.1026356331024365528470823,
        -0.02586788826655833316394696,
        0.3142414030714464341471425,
        -0.1301444595174151138496151,
        0.1064177003695413680222801,
        -0.008794243128510204394069428,
        0.2073050690568967098882107,
    ]);
    KICKS = palindrome([
        0.09171915262446201798118323,
        0.1839831700050048984914766,
        -0.05653436583288910439527704,
        0.004914688774711885640205616,
        0.1437611271683616823873745,
        0.3285676937468041402004813,
        -0.1964114664864555203054442,
    ]);
}

set! {
    /// Order 8 in 19 kicks. Blanes, Casas and Escorihuela-Tomàs's A₁₉: no drift is longer than 0.43 of the step.
    ///
    /// # Reference
    /// S. Blanes, F. Casas and A. Escorihuela-Tomàs, Runge–Kutta–Nyström symplectic splitting methods of order 8, Appl. Numer.
    /// Math. (2022), arXiv:2202.01541, table 4; digits as in a public program by J. Knox (2025).
    pub struct Blanes8S19: NystromCoefficients<19>, order 8, turn 0.75, first Drift;
    DRIFTS = opening([
        0.0505805,
        0.149999,
        -0.0551795510771615573511027,
        0.4237558988353379514822650,
        -0.2134953535846590480596722,
        -0.0680769774574032619111631,
        0.2279170569740134359488872,
        -0.2353736193810589065247400,
        0.3874138691798780478167940,
        -0.1675408234889466614012682,
    ]);
    KICKS = palindrome([
        0.1294786065605367306624938,
        0.2222572600926711434230436,
        -0.0577514893325147204757023,
        -0.0578312262103924910221345,
        0.1030872974371753567479333,
        -0.1408196125540907682055541,
        0.0234462603492826276699714,
        0.1348545173566840966178822,
        0.0287973821073779306345172,
        0.2289620083865401878950991,
    ]);
}
