//! What schemes carry from step to step.

/// Declares a memory over a system `Y`: first the vectors and sums that a checkpoint saves, then lists of vectors that it saves,
/// then what a step computes before it reads it. A memory of stages is one of `Y: Staged with Pushes`.
///
/// `Clone` copies into what is there, so that a stepper of many bodies allocates nothing; the derived one would not.
macro_rules! memory {
    (
        $(#[$about:meta])*
        pub struct $name:ident<Y $(: $system:ident with $($more:ident),+)? $(, const $n:ident: usize)?> {
            $($(#[$of:meta])* $vis:vis $field:ident: $type:ty,)*
        }
        lists { $($(#[$of_list:meta])* $list:ident: $list_type:ty,)* }
        uncarried { $($(#[$of_rest:meta])* $rest:ident: $rest_type:ty,)* }
    ) => {
        $(#[$about])*
        pub struct $name<Y: crate::system::System $(+ $system)? $(, const $n: usize)?> {
            $($(#[$of])* $vis $field: $type,)*
            $($(#[$of_list])* pub(in crate::scheme) $list: $list_type,)*
            $($(#[$of_rest])* pub(in crate::scheme) $rest: $rest_type,)*
        }

        impl<Y: crate::system::System $(+ $system)? $(, const $n: usize)?> Clone for $name<Y $(, $n)?> {
            #[inline(always)]
            fn clone(&self) -> Self {
                $name {
                    $($field: self.$field.clone(),)*
                    $($list: self.$list.clone(),)*
                    $($rest: self.$rest.clone(),)*
                }
            }

            fn clone_from(&mut self, other: &Self) {
                $(self.$field.clone_from(&other.$field);)*
                $(for (list, other) in self.$list.iter_mut().zip(&other.$list) {
                    list.clone_from(other);
                })*
                $(self.$rest.clone_from(&other.$rest);)*
            }
        }

        impl<Y: crate::system::System $(+ $system)? $(, const $n: usize)?> Copy for $name<Y $(, $n)?>
        where
            Y::Vector: Copy,
            Y::Sum: Copy,
            Y::Work: Copy,
            $($(Y::$more: Copy,)+)?
        {
        }

        impl<Y: crate::system::System $(+ $system)? $(, const $n: usize)?> core::fmt::Debug for $name<Y $(, $n)?> {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.debug_struct(stringify!($name))
                    $(.field(stringify!($field), &self.$field))*
                    $(.field(stringify!($list), &self.$list))*
                    $(.field(stringify!($rest), &self.$rest))*
                    .finish()
            }
        }

        #[cfg(feature = "serde")]
        impl<Y: crate::system::System $(+ $system)? $(, const $n: usize)?> crate::checkpoint::Carried for $name<Y $(, $n)?>
        where
            Y::Vector: crate::checkpoint::Carried,
            Y::Sum: crate::checkpoint::Carried,
            $($(Y::$more: crate::checkpoint::Carried,)+)?
        {
            fn carried(&mut self) -> Vec<&mut [f64]> {
                let mut all = Vec::new();
                $(all.extend(self.$field.carried());)*
                $(self.$list.iter_mut().for_each(|vector| all.extend(vector.carried()));)*
                all
            }
        }
    };
}

/// What a scheme tells of a memory that has position and velocity as `q` and `v`; their values by `Y::value` where they are sums,
/// by `identity` where they are vectors.
macro_rules! q_and_v {
    ($value:path) => {
        #[inline]
        fn position<'m>(&self, memory: &'m Self::Memory) -> &'m Y::Vector {
            $value(&memory.q)
        }

        #[inline]
        fn velocity(&self, _: &Y, _: &Y::Stride, _: Y::Scalar, memory: &Self::Memory) -> Y::Vector {
            $value(&memory.v).clone()
        }

        #[inline]
        fn finite(&self, memory: &Self::Memory) -> bool {
            Y::is_finite($value(&memory.q)) && Y::is_finite($value(&memory.v))
        }

        fn kinetic_energy(&self, system: &Y, memory: &Self::Memory) -> Y::Scalar {
            system.kinetic_energy($value(&memory.v))
        }
    };
}

pub(crate) use {memory, q_and_v};
