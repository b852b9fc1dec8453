//! Sets of order 6.

use super::{Coefficients, palindrome, set};

set! {
    /// Order 6 in 7 stages. Yoshida's solution A: the fewest stages of order 6.
    ///
    /// # Reference
    /// H. Yoshida, Phys. Lett. A 150 (1990) 262–268, table 1; digits as in E. Hairer, C. Lubich and G. Wanner, Geometric
    /// Numerical Integration (2006), V.3, (3.11).
    pub struct Yoshida6: Coefficients<7>, order 6;
    GAMMA = palindrome([
        0.78451361047755726381949763,
        0.23557321335935813368479318,
        -1.17767998417887100694641568,
        1.31518632068391121888425,
    ]);
}

set! {
    /// Order 6 in 9 stages. McLachlan's nine stages.
    ///
    /// # Reference
    /// R. I. McLachlan, SIAM J. Sci. Comput. 16 (1995) 151–168.
    pub struct McLachlan6: Coefficients<9>, order 6;
    GAMMA = palindrome([
        0.1867,
        0.55549702371247839916,
        0.12946694891347535806,
        -0.84326562338773460855,
        0.94320330152356170266,
    ]);
}

set! {
    /// Order 6 in 9 stages. Kahan and Li's s9odr6a.
    ///
    /// # Reference
    /// W. Kahan and R.-C. Li, Math. Comp. 66 (1997) 1089–1099; Hairer, Lubich and Wanner (2006), V.3, (3.12).
    pub struct KahanLi6: Coefficients<9>, order 6;
    GAMMA = palindrome([
        0.39216144400731413927925056,
        0.33259913678935943859974864,
        -0.70624617255763935980996482,
        0.08221359629355080023149045,
        0.7985439909348299633989503,
    ]);
}

set! {
    /// Order 6 in 11 stages. Sofroniou and Spaletta's eleven stages.
    ///
    /// # Reference
    /// M. Sofroniou and G. Spaletta, Optim. Methods Softw. 20 (2005) 597–613.
    pub struct SofroniouSpaletta6S11: Coefficients<11>, order 6;
    GAMMA = palindrome([
        0.21375583945878254555518066964857,
        0.18329381407425713911385974425217,
        0.17692819473098943794898811709929,
        -0.44329082681170215849622829626258,
        0.11728560432865935385403585669136,
        0.5040547484380273640483278,
    ]);
}

set! {
    /// Order 6 in 13 stages. Sofroniou and Spaletta's thirteen stages: no stage is longer than 0.40 of the step.
    ///
    /// # Reference
    /// M. Sofroniou and G. Spaletta, Optim. Methods Softw. 20 (2005) 597–613.
    pub struct SofroniouSpaletta6: Coefficients<13>, order 6;
    GAMMA = palindrome([
        0.13861930854051695245808013042625,
        0.13346562851074760407046858832209,
        0.13070531011449225190542755785015,
        0.12961893756907034772505366537091,
        -0.35000324893920896516170830911323,
        0.11805530653002387170273438954049,
        0.399077515348715874599888,
    ]);
    LOW = palindrome([
        -8.700948011565917e-18,
        -9.618167604497014e-18,
        1.1668855328699525e-17,
        1.1689516526629563e-17,
        1.2235477808628282e-17,
        9.43618111645117e-19,
        -8.681128703450201e-18,
    ]);
}
