//! Published sets of drifts, kicks and gradient terms. The digits are those of the sources; a test holds them to every order
//! condition.

use crate::scheme::splitting::{First, opening, palindrome};

/// The lengths of the drifts a₁, … and kicks b₁, … of a force-gradient scheme in units of the step, and e₁, …, by which a kick
/// adds e_k h³ a′a.
///
/// The order of drifts and kicks is that of [`NystromCoefficients`](crate::coefficients::NystromCoefficients). Omelyan,
/// Mryglod and Folk write e_k/2.
pub trait ForceGradientCoefficients<const KICKS: usize>: Copy + core::fmt::Debug {
    /// The name in reports.
    const NAME: &'static str;
    /// The order for q″ = a(q).
    const ORDER: u32;
    /// As in [`NystromCoefficients`](crate::coefficients::NystromCoefficients::TURN).
    const TURN: f64 = 0.3;
    /// What the step begins with.
    const FIRST: First;
    /// a₁, …, a_N; a palindrome where the step begins with a kick, else x_k = x_{N+2−k}.
    const DRIFTS: [f64; KICKS];
    /// b₁, …, b_N; a palindrome where the step begins with a drift, else x_k = x_{N+2−k}.
    const KICKS: [f64; KICKS];
    /// e₁, …, e_N, in the order of the kicks.
    const GRADIENTS: [f64; KICKS];
}

/// Order 4 in 2 kicks, one of them with a gradient: 1/6, 2/3, 1/6 as in Simpson's rule. Chin's scheme A.
///
/// # Reference
/// S. A. Chin, Phys. Lett. A 226 (1997) 344–348; M. Suzuki, in: Computer Simulation Studies in Condensed-Matter Physics VIII
/// (1995).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Chin4A;

impl ForceGradientCoefficients<2> for Chin4A {
    const NAME: &'static str = "Chin4A";
    const ORDER: u32 = 4;
    const TURN: f64 = 0.123;
    const FIRST: First = First::Kick;
    const DRIFTS: [f64; 2] = palindrome([0.5]);
    const KICKS: [f64; 2] = opening([1.0 / 6.0, 2.0 / 3.0]);
    const GRADIENTS: [f64; 2] = opening([0.0, 1.0 / 36.0]);
}

/// Order 4 in 3 kicks, one of them with a gradient: 3/8, 1/4, 3/8. Chin's scheme C.
///
/// # Reference
/// S. A. Chin, Phys. Lett. A 226 (1997) 344–348.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Chin4C;

impl ForceGradientCoefficients<3> for Chin4C {
    const NAME: &'static str = "Chin4C";
    const ORDER: u32 = 4;
    const TURN: f64 = 0.149;
    const FIRST: First = First::Drift;
    const DRIFTS: [f64; 3] = opening([1.0 / 6.0, 1.0 / 3.0]);
    const KICKS: [f64; 3] = palindrome([3.0 / 8.0, 1.0 / 4.0]);
    const GRADIENTS: [f64; 3] = palindrome([0.0, 1.0 / 96.0]);
}

/// Order 4 in 3 kicks, two of them with a gradient.
///
/// # Reference
/// I. P. Omelyan, I. M. Mryglod and R. Folk, Comput. Phys. Commun. 151 (2003) 272–314, (37): the others follow from θ = a₁.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Omelyan4S3;

impl ForceGradientCoefficients<3> for Omelyan4S3 {
    const NAME: &'static str = "Omelyan4S3";
    const ORDER: u32 = 4;
    const TURN: f64 = 0.217;
    const FIRST: First = First::Kick;
    const DRIFTS: [f64; 3] = palindrome([THETA, 1.0 - 2.0 * THETA]);
    const KICKS: [f64; 3] = {
        let lambda = 0.5 + 1.0 / (12.0 * THETA * (THETA - 1.0));
        opening([lambda, 0.5 - lambda])
    };
    const GRADIENTS: [f64; 3] = {
        let rest = 1.0 - THETA;
        opening([0.0, (1.0 - 6.0 * THETA * rest * rest) / (144.0 * THETA * rest * rest)])
    };
}

/// θ of [`Omelyan4S3`].
const THETA: f64 = 0.2813980611667719;

/// Order 4 in 4 kicks, two of them with a gradient.
///
/// # Reference
/// I. P. Omelyan, I. M. Mryglod and R. Folk, Comput. Phys. Commun. 151 (2003) 272–314, (48) and (53).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Omelyan4S4;

impl ForceGradientCoefficients<4> for Omelyan4S4 {
    const NAME: &'static str = "Omelyan4S4";
    const ORDER: u32 = 4;
    const TURN: f64 = 0.26;
    const FIRST: First = First::Kick;
    const DRIFTS: [f64; 4] = palindrome([0.1921125277429464, 0.5 - 0.1921125277429464]);
    const KICKS: [f64; 4] =
        opening([0.05851872613455621, 0.2852162240687091, 1.0 - 2.0 * (0.05851872613455621 + 0.2852162240687091)]);
    const GRADIENTS: [f64; 4] = opening([2.0 * 0.0004339598806816256, 0.0, 2.0 * 0.00242747525966305]);
}

/// Order 4 in 5 kicks, two of them with a gradient.
///
/// # Reference
/// I. P. Omelyan, I. M. Mryglod and R. Folk, Comput. Phys. Commun. 151 (2003) 272–314, (72) and (78).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Omelyan4S5;

impl ForceGradientCoefficients<5> for Omelyan4S5 {
    const NAME: &'static str = "Omelyan4S5";
    const ORDER: u32 = 4;
    const TURN: f64 = 0.345;
    const FIRST: First = First::Drift;
    const DRIFTS: [f64; 5] =
        opening([0.06419108866816235, 0.1919807940455741, 0.5 - (0.06419108866816235 + 0.1919807940455741)]);
    const KICKS: [f64; 5] =
        palindrome([0.1518179640276466, 0.2158369476787619, 1.0 - 2.0 * (0.1518179640276466 + 0.2158369476787619)]);
    const GRADIENTS: [f64; 5] = palindrome([0.0, 2.0 * 0.0009628905212024874, 0.0]);
}

/// Order 6 in 5 kicks, three of them with a gradient; the fewest kicks of order 6, and some step backward.
///
/// # Reference
/// I. P. Omelyan, I. M. Mryglod and R. Folk, Phys. Rev. E 66 (2002) 026701, (50) and (51); Comput. Phys. Commun. 151 (2003)
/// 272–314, (72) and (76).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Omelyan6S5;

impl ForceGradientCoefficients<5> for Omelyan6S5 {
    const NAME: &'static str = "Omelyan6S5";
    const ORDER: u32 = 6;
    const TURN: f64 = 0.387;
    const FIRST: First = First::Drift;
    const DRIFTS: [f64; 5] =
        opening([0.1097059723948682, 0.4140632267310831, 0.5 - (0.1097059723948682 + 0.4140632267310831)]);
    const KICKS: [f64; 5] =
        palindrome([0.2693315848935301, 1.1319803486515564, 1.0 - 2.0 * (0.2693315848935301 + 1.1319803486515564)]);
    const GRADIENTS: [f64; 5] = palindrome([2.0 * 0.0008642161339706166, 0.0, -2.0 * 0.01324638643416052]);
}

/// Order 8 in 11 kicks, all of them with a gradient.
///
/// # Reference
/// I. P. Omelyan, I. M. Mryglod and R. Folk, Phys. Rev. E 66 (2002) 026701, (53).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Omelyan8S11;

#[expect(clippy::excessive_precision)]
impl ForceGradientCoefficients<11> for Omelyan8S11 {
    const NAME: &'static str = "Omelyan8S11";
    const ORDER: u32 = 8;
    const TURN: f64 = 0.68;
    const FIRST: First = First::Drift;
    const DRIFTS: [f64; 11] = opening([
        0.41009674738801111928784693005080,
        -0.34123345756052780489101697378499,
        0.25644714021068150492361761631743,
        0.27765273975812438394100476242641,
        -0.56926266869753773902939657321159,
        0.46629949890124853576794423820194,
    ]);
    const KICKS: [f64; 11] = {
        let [b1, b2, b3] = [
            0.0048249309817414952912695842664785,
            0.17492394861090375603419001374207,
            0.29304366370957066164364546204288,
        ];
        let [b4, b5] = [0.047448940168459770284238136482511, -0.0015299863411743974499219652320477];
        palindrome([b1, b2, b3, b4, b5, 1.0 - 2.0 * (b1 + b2 + b3 + b4 + b5)])
    };
    const GRADIENTS: [f64; 11] = palindrome([
        2.0 * 0.00014743936907797528364717244760736,
        2.0 * 0.00023288450531932545357194967600155,
        2.0 * 0.0061648659635535962497705619884752,
        -2.0 * 0.012307516860831240716732016960034,
        -2.0 * 0.000073296648559126385387017161643798,
        2.0 * 0.015295860994523744731993293847001,
    ]);
}
