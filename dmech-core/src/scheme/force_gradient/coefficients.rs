//! Sets of drifts, kicks and gradient terms, published ones with the digits of their sources and one found here; a test holds
//! them to every order condition.

use crate::scheme::set::set;
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

set! {
    /// Order 4 in 2 kicks, one of them with a gradient: 1/6, 2/3, 1/6 as in Simpson's rule. Chin's scheme A.
    ///
    /// # Reference
    /// S. A. Chin, Phys. Lett. A 226 (1997) 344–348; M. Suzuki, in: Computer Simulation Studies in Condensed-Matter Physics
    /// VIII (1995).
    pub struct Chin4A: ForceGradientCoefficients<2>, order 4, turn 0.123, first Kick;
    DRIFTS = palindrome([0.5]);
    KICKS = opening([1.0 / 6.0, 2.0 / 3.0]);
    GRADIENTS = opening([0.0, 1.0 / 36.0]);
}

set! {
    /// Order 4 in 3 kicks, one of them with a gradient: 3/8, 1/4, 3/8. Chin's scheme C.
    ///
    /// # Reference
    /// S. A. Chin, Phys. Lett. A 226 (1997) 344–348.
    pub struct Chin4C: ForceGradientCoefficients<3>, order 4, turn 0.149, first Drift;
    DRIFTS = opening([1.0 / 6.0, 1.0 / 3.0]);
    KICKS = palindrome([3.0 / 8.0, 1.0 / 4.0]);
    GRADIENTS = palindrome([0.0, 1.0 / 96.0]);
}

set! {
    /// Order 4 in 3 kicks, two of them with a gradient.
    ///
    /// # Reference
    /// I. P. Omelyan, I. M. Mryglod and R. Folk, Comput. Phys. Commun. 151 (2003) 272–314, (37): the others follow from θ = a₁.
    pub struct Omelyan4S3: ForceGradientCoefficients<3>, order 4, turn 0.217, first Kick;
    DRIFTS = palindrome([THETA, 1.0 - 2.0 * THETA]);
    KICKS = {
        let lambda = 0.5 + 1.0 / (12.0 * THETA * (THETA - 1.0));
        opening([lambda, 0.5 - lambda])
    };
    GRADIENTS = {
        let rest = 1.0 - THETA;
        opening([0.0, (1.0 - 6.0 * THETA * rest * rest) / (144.0 * THETA * rest * rest)])
    };
}

/// θ of [`Omelyan4S3`].
const THETA: f64 = 0.2813980611667719;

set! {
    /// Order 4 in 4 kicks, two of them with a gradient.
    ///
    /// # Reference
    /// I. P. Omelyan, I. M. Mryglod and R. Folk, Comput. Phys. Commun. 151 (2003) 272–314, (48) and (53).
    pub struct Omelyan4S4: ForceGradientCoefficients<4>, order 4, turn 0.26, first Kick;
    DRIFTS = palindrome([0.1921125277429464, 0.5 - 0.1921125277429464]);
    KICKS = opening([0.05851872613455621, 0.2852162240687091, 1.0 - 2.0 * (0.05851872613455621 + 0.2852162240687091)]);
    GRADIENTS = opening([2.0 * 0.0004339598806816256, 0.0, 2.0 * 0.00242747525966305]);
}

set! {
    /// Order 4 in 5 kicks, two of them with a gradient.
    ///
    /// # Reference
    /// I. P. Omelyan, I. M. Mryglod and R. Folk, Comput. Phys. Commun. 151 (2003) 272–314, (72) and (78).
    pub struct Omelyan4S5: ForceGradientCoefficients<5>, order 4, turn 0.345, first Drift;
    DRIFTS = opening([0.06419108866816235, 0.1919807940455741, 0.5 - (0.06419108866816235 + 0.1919807940455741)]);
    KICKS = palindrome([0.1518179640276466, 0.2158369476787619, 1.0 - 2.0 * (0.1518179640276466 + 0.2158369476787619)]);
    GRADIENTS = palindrome([0.0, 2.0 * 0.0009628905212024874, 0.0]);
}

set! {
    /// Order 6 in 5 kicks, three of them with a gradient; the fewest kicks of order 6, and some step backward.
    ///
    /// # Reference
    /// I. P. Omelyan, I. M. Mryglod and R. Folk, Phys. Rev. E 66 (2002) 026701, (50) and (51); Comput. Phys. Commun. 151 (2003)
    /// 272–314, (72) and (76).
    pub struct Omelyan6S5: ForceGradientCoefficients<5>, order 6, turn 0.387, first Drift;
    DRIFTS = opening([0.1097059723948682, 0.4140632267310831, 0.5 - (0.1097059723948682 + 0.4140632267310831)]);
    KICKS = palindrome([0.2693315848935301, 1.1319803486515564, 1.0 - 2.0 * (0.2693315848935301 + 1.1319803486515564)]);
    GRADIENTS = palindrome([2.0 * 0.0008642161339706166, 0.0, -2.0 * 0.01324638643416052]);
}

set! {
    /// Order 8 in 11 kicks, all of them with a gradient.
    ///
    /// # Reference
    /// I. P. Omelyan, I. M. Mryglod and R. Folk, Phys. Rev. E 66 (2002) 026701, (53).
    pub struct Omelyan8S11: ForceGradientCoefficients<11>, order 8, turn 0.68, first Drift;
    DRIFTS = opening([
        0.41009674738801111928784693005080,
        -0.34123345756052780489101697378499,
        0.25644714021068150492361761631743,
        0.27765273975812438394100476242641,
        -0.56926266869753773902939657321159,
        0.46629949890124853576794423820194,
    ]);
    KICKS = {
        let [b1, b2, b3] = [
            0.0048249309817414952912695842664785,
            0.17492394861090375603419001374207,
            0.29304366370957066164364546204288,
        ];
        let [b4, b5] = [0.047448940168459770284238136482511, -0.0015299863411743974499219652320477];
        palindrome([b1, b2, b3, b4, b5, 1.0 - 2.0 * (b1 + b2 + b3 + b4 + b5)])
    };
    GRADIENTS = palindrome([
        2.0 * 0.00014743936907797528364717244760736,
        2.0 * 0.00023288450531932545357194967600155,
        2.0 * 0.0061648659635535962497705619884752,
        -2.0 * 0.012307516860831240716732016960034,
        -2.0 * 0.000073296648559126385387017161643798,
        2.0 * 0.015295860994523744731993293847001,
    ]);
}

set! {
    /// Order 8 in 14 kicks, all of them with a gradient; no drift is longer than 0.31 of the step, no kick than 0.17.
    ///
    /// Found here, from some 10⁵ random starts with 13 to 19 kicks. Of its 22 numbers the conditions up to order 8 leave
    /// five free, and these lessen the sum of squares of the violated conditions of orders 9, 11, …, 21, so that also what
    /// changes within a step, as a force does where bodies pass close by, is followed. The weight of a tree is that of
    /// forces which are analytic up to a distance: Π n!/σ, n the branches of each of its forces and σ its symmetries, times
    /// 0.03 for each force beyond the first and 0.4 for each order beyond 9; beyond order 9 without trees of more than
    /// three forces, beyond 13 of more than two, beyond 17 of more than one. Motions, those below among them, took part in
    /// the choice of the weights and of the minimum.
    ///
    /// The largest error of the energy, at equal cost with 1.5 for a force and its gradient (geometric means over six costs):
    ///
    /// | motion | `Smooth8S14` | `Omelyan8S11` | `Blanes8S19` |
    /// |---|---|---|---|
    /// | Kepler, e = 0.5, 100 revolutions | 7.0·10⁻¹¹ | 3.9·10⁻⁹ | 3.4·10⁻¹¹ |
    /// | Hénon–Heiles | 1.5·10⁻⁹ | 2.4·10⁻⁸ | 1.1·10⁻⁸ |
    /// | quartic well in the plane | 8.8·10⁻¹¹ | 2.0·10⁻⁹ | 3.1·10⁻⁹ |
    /// | three bodies on springs that pass at 0.04 of their length | 3.5·10⁻¹² | 2.4·10⁻⁹ | 1.0·10⁻⁹ |
    /// | three bodies that attract | 1.3·10⁻⁵ | 2.1·10⁻⁴ | 9.0·10⁻⁶ |
    pub struct Smooth8S14: ForceGradientCoefficients<14>, order 8, turn 1.03, first Kick;
    DRIFTS = palindrome([
        0.0592455191102480718471960476920017712,
        0.120342318500542195028506978618699996,
        0.309868744232537172825908046373146279,
        -0.159243496734054684534609162641418502,
        0.198455742518968893445335496029933446,
        -0.158800205648516151856228000743245773,
        0.130131378020274503243890594670882784,
    ]);
    KICKS = opening([
        0.0168705300492902049488627340537337254,
        0.0951239013035328480289196968778911958,
        0.139741533231335599576144310070749327,
        0.0124810055452342891440839303342472321,
        0.164938963526758364951433973829038898,
        0.146631103014194631753262856802796563,
        -0.0149567441586874602592555010534910613,
        -0.121660585023316956286904001829931761,
    ]);
    GRADIENTS = opening([
        -0.0000538684269003132846493463670830998478,
        0.000227956748031905803427732666127825692,
        -0.000039157891547123004019633671713682819,
        0.000359059449672717116639108939097326975,
        0.00107400224010106789886224384396972716,
        0.000730638642960412872188068258077369172,
        -0.000403437729450979691262959427695219369,
        -0.00160897003922163151969802188434979412,
    ]);
}
