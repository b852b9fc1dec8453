//! [`Real`] for `f64`, with the functions of this crate, and for `f32`, with those of the standard library and the cardinal ones.

use crate::{Count, Mask, Real, functions};

/// Whether a fused multiply-add is one instruction, and [`Real::mul_add`] rounds once: always on AArch64, POWER, z and RISC-V
/// with doubles, by target feature on x86.
pub const FUSED: bool = cfg!(any(
    target_feature = "fma",
    target_arch = "aarch64",
    target_arch = "powerpc64",
    target_arch = "s390x",
    all(target_arch = "riscv64", target_feature = "d"),
));

impl Count for u32 {
    #[inline(always)]
    fn of(n: u32) -> u32 {
        n
    }
    #[inline(always)]
    fn to_u64(self) -> u64 {
        self.into()
    }
}

impl Mask for bool {
    type Count = u32;

    #[inline(always)]
    fn of(holds: bool) -> bool {
        holds
    }
    #[inline(always)]
    fn all(self) -> bool {
        self
    }
    #[inline(always)]
    fn any(self) -> bool {
        self
    }
    #[inline(always)]
    fn and(self, other: bool) -> bool {
        self & other
    }
    #[inline(always)]
    fn or(self, other: bool) -> bool {
        self | other
    }
    #[inline(always)]
    fn not(self) -> bool {
        !self
    }
    #[inline(always)]
    fn count(self, holds: u32, fails: u32) -> u32 {
        if self { holds } else { fails }
    }
}

/// `method(argument: type)` becomes a call of the standard library's method of the same name.
macro_rules! from_std {
    ($real:ty: $($name:ident($($arg:ident: $ty:ty),*);)*) => {$(
        #[inline(always)]
        fn $name(self $(, $arg: $ty)*) -> Self {
            <$real>::$name(self $(, $arg)*)
        }
    )*};
}

/// The cardinal functions are computed in `f64`; an `f32` then rounds once.
macro_rules! through_f64 {
    ($real:ty: $($name:ident)*) => {$(
        #[inline]
        fn $name(self) -> Self {
            functions::$name(f64::from(self)) as $real
        }
    )*};
}

/// `method(argument)` becomes a call of this crate's function of the same name.
macro_rules! own {
    ($($name:ident($($arg:ident)?);)*) => {$(
        #[inline(always)]
        fn $name(self $(, $arg: Self)?) -> Self {
            functions::$name(self $(, $arg)?)
        }
    )*};
}

macro_rules! primitive {
    ($($real:ident { $($functions:tt)* })*) => {$(
        impl Real for $real {
            type Mask = bool;

            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const EPSILON: Self = $real::EPSILON;

            #[inline(always)]
            fn from_f64(x: f64) -> Self {
                x as $real
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            #[inline(always)]
            fn less(self, other: Self) -> bool {
                self < other
            }
            #[inline(always)]
            fn less_or_equal(self, other: Self) -> bool {
                self <= other
            }
            #[inline(always)]
            fn equal(self, other: Self) -> bool {
                self == other
            }
            #[inline(always)]
            fn finite(self) -> bool {
                self.is_finite()
            }
            #[inline(always)]
            fn select(mask: bool, yes: impl FnOnce() -> Self, no: impl FnOnce() -> Self) -> Self {
                if mask { yes() } else { no() }
            }
            #[inline(always)]
            fn mul_add(self, b: Self, c: Self) -> Self {
                if FUSED { $real::mul_add(self, b, c) } else { self * b + c }
            }
            from_std! { $real:
                recip(); abs(); signum(); round(); floor(); trunc(); min(other: Self); max(other: Self); powi(n: i32); sqrt();
            }
            $($functions)*
        }
    )*};
}

primitive! {
    f64 {
        own! {
            exp(); exp2(); exp_m1(); ln(); ln_1p(); log2(); log10();
            sin(); cos(); tan(); asin(); acos(); atan(); atan2(x);
            sinh(); cosh(); tanh(); asinh(); acosh(); atanh(); powf(p); cbrt();
            sinc(); sinc_slope(); sinhc(); sinhc_slope(); atanc(); atanc_slope(); atanhc(); atanhc_slope();
        }
    }
    f32 {
        #[inline(always)]
        fn least() -> Self {
            1e-37
        }
        #[inline(always)]
        fn product(self, b: Self) -> (Self, Self) {
            let product = self * b;
            (product, (f64::from(self) * f64::from(b) - f64::from(product)) as Self)
        }
        from_std! { f32:
            powf(p: Self); cbrt();
            exp(); exp2(); exp_m1(); ln(); ln_1p(); log2(); log10();
            sin(); cos(); tan(); asin(); acos(); atan(); atan2(x: Self);
            sinh(); cosh(); tanh(); asinh();
        }
        // The standard library's arcosh loses the digits of self − 1 near 1, its artanh is 20 ulp off near −1.
        #[inline]
        fn acosh(self) -> Self {
            let t = self - 1.0;
            (t + t.sqrt() * (t + 2.0).sqrt()).ln_1p()
        }
        #[inline]
        fn atanh(self) -> Self {
            let a = self.abs();
            (0.5 * (2.0 * a / (1.0 - a)).ln_1p()).copysign(self)
        }
        through_f64! { f32: sinc sinc_slope sinhc sinhc_slope atanc atanc_slope atanhc atanhc_slope }
    }
}
