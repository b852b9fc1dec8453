//! Sets of order 8.

use super::{Coefficients, palindrome, set};

set! {
    /// Order 8 in 15 stages. Yoshida's solution D. The published digits, 15 of them, are right to 12; these solve the
    /// conditions to 25.
    ///
    /// # Reference
    /// H. Yoshida, Phys. Lett. A 150 (1990) 262–268, table 2.
    pub struct Yoshida8: Coefficients<15>, order 8;
    GAMMA = palindrome([
        0.9148442462297915667487935,
        0.253693336566211354146146,
        -1.444852236860605157694731,
        -0.1582406353680501752040668,
        1.938139137622525986579186,
        -1.960610232975310807607633,
        0.1027998493917964406981151,
        1.70845307078728158466838,
    ]);
}

set! {
    /// Order 8 in 15 stages. The fifteen stages of Suzuki and Umeno, found again by McLachlan.
    ///
    /// # Reference
    /// M. Suzuki and K. Umeno, Springer Proc. Phys. 76 (1993) 74–86; R. I. McLachlan, SIAM J. Sci. Comput. 16 (1995) 151–168;
    /// Hairer, Lubich and Wanner (2006), V.3, (3.13).
    pub struct SuzukiUmeno8: Coefficients<15>, order 8;
    GAMMA = palindrome([
        0.74167036435061295344822780,
        -0.40910082580003159399730010,
        0.19075471029623837995387626,
        -0.57386247111608226665638773,
        0.29906418130365592384446354,
        0.33462491824529818378495798,
        0.31529309239676659663205666,
        -0.7968879393529163540197888,
    ]);
}

set! {
    /// Order 8 in 17 stages. McLachlan's seventeen stages.
    ///
    /// # Reference
    /// R. I. McLachlan, SIAM J. Sci. Comput. 16 (1995) 151–168.
    pub struct McLachlan8: Coefficients<17>, order 8;
    GAMMA = palindrome([
        0.12886597938144329897,
        0.5815140871052509624,
        -0.41017537146985013753,
        0.1851469357165877327,
        -0.40955234342085141934,
        0.14440594108001204106,
        0.27833550039367965131,
        0.31495668391629485789,
        -0.62699482540513397492,
    ]);
}

set! {
    /// Order 8 in 17 stages. Kahan and Li's s17odr8a.
    ///
    /// # Reference
    /// W. Kahan and R.-C. Li, Math. Comp. 66 (1997) 1089–1099; Hairer, Lubich and Wanner (2006), V.3, (3.14).
    pub struct KahanLi8: Coefficients<17>, order 8;
    GAMMA = palindrome([
        0.13020248308889008087881763,
        0.56116298177510838456196441,
        -0.38947496264484728640807860,
        0.15884190655515560089621075,
        -0.39590389413323757733623154,
        0.18453964097831570709183254,
        0.25837438768632204729397911,
        0.29501172360931029887096624,
        -0.6055085338300345116989211,
    ]);
}

set! {
    /// Order 8 in 17 stages. Seventeen stages, near those of Kahan and Li.
    ///
    /// # Reference
    /// M. E. S. Morales, P. C. S. Costa, G. Pantaleoni, D. K. Burgarth, Y. R. Sanders and D. W. Berry, Greatly improved
    /// higher-order product formulae for quantum simulation (2022), arXiv:2210.15817.
    pub struct Morales8: Coefficients<17>, order 8;
    GAMMA = palindrome([
        0.12783360986284110837857554950443,
        0.56148845266356446893590729572808,
        -0.38400573301491401473462588779099,
        0.15982762208609923217390166127256,
        -0.40049110428180105319963667975074,
        0.18669648149540687549831902999911,
        0.26020394234904150277316667709864,
        0.29137384767986663096528500968049,
        -0.6058542376802095015817853,
    ]);
}

set! {
    /// Order 8 in 21 stages. Sofroniou and Spaletta's twenty-one stages: no stage is longer than 0.39 of the step.
    ///
    /// # Reference
    /// M. Sofroniou and G. Spaletta, Optim. Methods Softw. 20 (2005) 597–613.
    pub struct SofroniouSpaletta8: Coefficients<21>, order 8;
    GAMMA = palindrome([
        0.10647728984550031823931967854896,
        0.10837408645835726397433410591546,
        0.35337821052654342419534541324080,
        -0.23341414023165082198780281128319,
        -0.24445266791528841269462171413216,
        0.11317848435755633314700952515599,
        0.11892905625000350062692972283951,
        0.12603912321825988140305670268365,
        0.12581718736176041804392391641587,
        0.11699135019217642180722881433533,
        -0.3826359601264366535094467,
    ]);
    LOW = palindrome([
        6.845541886003226e-18,
        6.8923248216449885e-19,
        -2.1695378247100082e-17,
        7.594418906545171e-18,
        2.9734812114292566e-19,
        5.514010809029823e-18,
        5.28389249308059e-18,
        -3.892054941470881e-18,
        -6.125153138596297e-18,
        2.997670888667282e-19,
        -1.7378826534960317e-17,
    ]);
}
