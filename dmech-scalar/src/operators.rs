//! The operators of numbers that stand side by side.

/// `+`, `-`, `*` and `/` of a type that has `with`: register by register.
macro_rules! operators {
    ($type:ty, $generics:tt) => {
        operators! {
            $type, $generics:
            Add::add, AddAssign::add_assign;
            Sub::sub, SubAssign::sub_assign;
            Mul::mul, MulAssign::mul_assign;
            Div::div, DivAssign::div_assign;
        }
    };
    ($type:ty, $generics:tt: $($Op:ident::$op:ident, $OpAssign:ident::$op_assign:ident;)*) => {
        $(operators! { @ $type, $generics, $Op::$op, $OpAssign::$op_assign })*
    };
    (@ $type:ty, [$($generics:tt)*], $Op:ident::$op:ident, $OpAssign:ident::$op_assign:ident) => {
        impl<$($generics)*> core::ops::$Op for $type {
            type Output = Self;
            #[inline(always)]
            fn $op(self, other: Self) -> Self {
                self.with(other, core::ops::$Op::$op)
            }
        }
        impl<$($generics)*> core::ops::$OpAssign for $type {
            #[inline(always)]
            fn $op_assign(&mut self, other: Self) {
                *self = core::ops::$Op::$op(*self, other);
            }
        }
    };
}

pub(crate) use operators;
