//! Functions that differ only in the types they take: listed by pair instead of spelled out.

/// Functions of two operands with bodies of their own: one implementation for each.
#[doc(hidden)]
#[macro_export]
macro_rules! unrolled {
    (impl<T: $Bound:ident> $Trait:ident for $Left:ident<T> {$(
        $(#[$doc:meta])*
        fn $method:ident($this:ident, $argument:ident: $Right:ty) -> $Output:ty $body:block
    )*}) => {$(
        impl<T: $Bound> $Trait<$Right> for $Left<T> {
            type Output = $Output;
            $(#[$doc])*
            #[inline]
            fn $method($this, $argument: $Right) -> $Output $body
        }
    )*};
}

/// Products that vanish identically.
#[doc(hidden)]
#[macro_export]
macro_rules! vanishing {
    (Scalar $trait:ident $method:ident $Left:ident: $($Right:ident),*) => {$(
        impl<T: $crate::Scalar> $crate::ops::$trait<$Right<T>> for $Left<T> {
            type Output = Scalar<T>;
            #[doc = "Vanishes identically for these types; no operations."]
            #[inline]
            fn $method(self, _: $Right<T>) -> Scalar<T> {
                Scalar { s: T::ZERO }
            }
        }
    )*};
    (number $trait:ident $method:ident $Left:ident: $($Right:ident),*) => {$(
        impl<T: $crate::Scalar> $crate::ops::$trait<$Right<T>> for $Left<T> {
            type Output = T;
            #[doc = "Vanishes identically for these types; no operations."]
            #[inline]
            fn $method(self, _: $Right<T>) -> T {
                T::ZERO
            }
        }
    )*};
}

/// Products that are another function: of the same operands, of the operands exchanged, or of
/// the operands widened to the types of their parity.
#[doc(hidden)]
#[macro_export]
macro_rules! shared {
    ($trait:ident $method:ident $Left:ident: $($kind:ident $Right:ident => $Output:ident ($($word:ident)*) $doc:literal,)*) => {$(
        impl<T: $crate::Scalar> $crate::ops::$trait<$Right<T>> for $Left<T> {
            type Output = $Output<T>;
            #[doc = $doc]
            #[inline]
            fn $method(self, b: $Right<T>) -> $Output<T> {
                $crate::shared!(@$kind $method self b $($word)*)
            }
        }
    )*};
    ($trait:ident $method:ident $Left:ident number: $($kind:ident $Right:ident ($($word:ident)*) $doc:literal,)*) => {$(
        impl<T: $crate::Scalar> $crate::ops::$trait<$Right<T>> for $Left<T> {
            type Output = T;
            #[doc = $doc]
            #[inline]
            fn $method(self, b: $Right<T>) -> T {
                $crate::shared!(@$kind $method self b $($word)*)
            }
        }
    )*};
    (@same $own:ident $a:ident $b:ident $method:ident) => {
        $a.$method($b)
    };
    (@swapped $own:ident $a:ident $b:ident $method:ident) => {
        $b.$method($a)
    };
    (@minus_same $own:ident $a:ident $b:ident $method:ident) => {
        -$a.$method($b)
    };
    (@minus_swapped $own:ident $a:ident $b:ident $method:ident) => {
        -$b.$method($a)
    };
    (@reversed $own:ident $a:ident $b:ident $method:ident) => {
        $b.$method($a).reverse()
    };
    (@minus_reversed $own:ident $a:ident $b:ident $method:ident) => {
        -$b.$method($a).reverse()
    };
    (@number $own:ident $a:ident $b:ident $method:ident) => {
        $a.$method($b).s
    };
    (@number_swapped $own:ident $a:ident $b:ident $method:ident) => {
        $b.$method($a)
    };
    (@widened $own:ident $a:ident $b:ident $Left:ident $Right:ident) => {
        $Left::from($a).$own($Right::from($b))
    };
}

/// Sums and differences of different types, in the smallest type that holds both.
#[doc(hidden)]
#[macro_export]
macro_rules! sums {
    ($bound:ident $Left:ident: $($Right:ident => $Sum:ident),*) => {$(
        impl<T: $crate::$bound> ::core::ops::Add<$Right<T>> for $Left<T> {
            type Output = $Sum<T>;
            /// The sum, in the smallest type that holds both; one addition a coefficient.
            #[inline]
            fn add(self, b: $Right<T>) -> $Sum<T> {
                $Sum::from(self) + $Sum::from(b)
            }
        }
        impl<T: $crate::$bound> ::core::ops::Sub<$Right<T>> for $Left<T> {
            type Output = $Sum<T>;
            /// The difference, in the smallest type that holds both; one subtraction a
            /// coefficient.
            #[inline]
            fn sub(self, b: $Right<T>) -> $Sum<T> {
                $Sum::from(self) - $Sum::from(b)
            }
        }
    )*};
}

/// The products that have operators, with a reference on the right.
#[doc(hidden)]
#[macro_export]
macro_rules! references {
    ($Left:ident: $($Right:ident),*) => {
        $($crate::references! { @each $Left $Right
            Geometric geometric, Wedge wedge, Inner inner, Regressive regressive,
            LeftContract left_contract, Quotient quotient
        })*
    };
    (@each $Left:ident $Right:ident $($trait:ident $method:ident),*) => {$(
        impl<'b, T: ::core::marker::Copy> $crate::ops::$trait<&'b $Right<T>> for $Left<T>
        where
            $Left<T>: $crate::ops::$trait<$Right<T>>,
        {
            type Output = <$Left<T> as $crate::ops::$trait<$Right<T>>>::Output;
            /// The same with the value.
            #[inline]
            fn $method(self, b: &'b $Right<T>) -> Self::Output {
                $crate::ops::$trait::$method(self, *b)
            }
        }
    )*};
}

/// Narrowing conversions, the inverses of the widening ones.
#[doc(hidden)]
#[macro_export]
macro_rules! narrowing {
    ($Name:ident: $($Wide:ident),*) => {$(
        impl<T: $crate::Real> ::core::convert::TryFrom<$Wide<T>> for $Name<T> {
            type Error = $crate::Narrowing;
            /// The coefficients that the type stores, each as it is; an error where one of the
            /// others is not negligible against the largest. No operations apart from the
            /// comparison: two multiplications and two additions a coefficient at most.
            #[inline]
            fn try_from(wide: $Wide<T>) -> ::core::result::Result<Self, $crate::Narrowing> {
                $crate::convert::narrow(wide, T::from_f64($crate::Narrowing::TOLERANCE))
            }
        }
    )*};
}

/// Inverses of types whose `X X̃` is a scalar.
#[doc(hidden)]
#[macro_export]
macro_rules! inverse {
    ($Name:ident => $Output:ident $doc:literal) => {
        impl<T: $crate::Field> $crate::ops::Inverse for $Name<T> {
            type Number = T;
            type Output = $Output<T>;
            /// The squared norm `X X̃`, at the cost of `norm_squared`.
            #[inline]
            fn determinant(self) -> T {
                $crate::ops::NormSquared::norm_squared(self)
            }
            #[doc = $doc]
            #[inline]
            fn adjugate(self) -> $Output<T> {
                $Output::from($crate::ops::Reverse::reverse(self))
            }
            /// The adjugate times a number, one multiplication a coefficient.
            #[inline]
            fn scale(adjugate: $Output<T>, factor: T) -> $Output<T> {
                adjugate * factor
            }
        }
    };
}

/// Inverses by the Faddeev–LeVerrier algorithm on the whole algebra.
#[doc(hidden)]
#[macro_export]
macro_rules! general_inverse {
    ($Name:ident => $Output:ident in $All:ident $count:literal $doc:literal) => {
        impl<T: $crate::Field> $crate::ops::Inverse for $Name<T> {
            type Number = T;
            type Output = $Output<T>;
            #[doc = $doc]
            #[inline]
            fn determinant(self) -> T {
                $crate::algorithm::adjugate::<$All<T>>($All::from(self), $count).1
            }
            #[doc = $doc]
            fn adjugate(self) -> $Output<T> {
                $crate::convert::pick(
                    $crate::algorithm::adjugate::<$All<T>>($All::from(self), $count).0,
                )
            }
            /// The adjugate times a number, one multiplication a coefficient.
            #[inline]
            fn scale(adjugate: $Output<T>, factor: T) -> $Output<T> {
                adjugate * factor
            }
        }
    };
}

/// Exponentials of types with fixed coefficients: that of the type of their sums.
#[doc(hidden)]
#[macro_export]
macro_rules! widened_exponential {
    ($Name:ident => $Wide:ident) => {
        impl<T: $crate::Real> $crate::ops::Exponential for $Name<T>
        where
            $Wide<T>: $crate::ops::Exponential + ::core::convert::From<$Name<T>>,
        {
            type Output = <$Wide<T> as $crate::ops::Exponential>::Output;
            /// The exponential of the same element without fixed coefficients, at its cost.
            #[inline]
            fn exp(self) -> Self::Output {
                $crate::ops::Exponential::exp($Wide::from(self))
            }
        }
    };
}

/// Exponentials by scaling and squaring.
#[doc(hidden)]
#[macro_export]
macro_rules! series_exponential {
    ($Name:ident => $Output:ident) => {
        impl<T: $crate::Real> $crate::ops::Exponential for $Name<T> {
            type Output = $Output<T>;
            /// The exponential, by scaling and squaring its power series.
            fn exp(self) -> $Output<T> {
                $crate::algorithm::exponential($Output::from(self))
            }
        }
    };
}

/// Logarithms and square roots by inverse scaling and squaring: the type, the type of all even
/// elements and that of bivectors.
#[doc(hidden)]
#[macro_export]
macro_rules! iterated_functions {
    ($Name:ident => $Even:ident $Bivector:ident $log:literal $sqrt:literal) => {
        impl<T: $crate::Real> $crate::ops::Logarithm for $Name<T> {
            type Output = $Bivector<T>;
            #[doc = $log]
            fn log(self) -> ::core::option::Option<$Bivector<T>> {
                $crate::algorithm::principal_logarithm::<$Even<T>, _>($Even::from(self))
            }
        }
        impl<T: $crate::Real> $crate::ops::SquareRoot for $Name<T> {
            type Output = $Even<T>;
            #[doc = $sqrt]
            fn sqrt(self) -> ::core::option::Option<$Even<T>> {
                $crate::algorithm::principal_square_root::<$Even<T>, $Bivector<T>>($Even::from(
                    self,
                ))
            }
        }
    };
}

/// Exponentials and splits of bivectors: the type, the type of the exponential, and the types of
/// commuting bivectors and of outer squares.
#[doc(hidden)]
#[macro_export]
macro_rules! bivector_functions {
    ($algorithm:ident $Name:ident => $Versor:ident ($Bivector:ident $Fourth:ident) $doc:literal $split:literal) => {
        impl<T: $crate::Real> $crate::ops::Exponential for $Name<T> {
            type Output = $Versor<T>;
            #[doc = $doc]
            #[inline]
            fn exp(self) -> $Versor<T> {
                $crate::algorithm::$algorithm::<T, $Bivector<T>, $Fourth<T>, _>($Bivector::from(
                    self,
                ))
            }
        }
        impl<T: $crate::Real> $crate::ops::SplitCommuting for $Name<T> {
            type Output = $Bivector<T>;
            #[doc = $split]
            #[inline]
            fn split_commuting(self) -> $crate::algorithm::Split<$Bivector<T>> {
                $crate::algorithm::split::<T, $Bivector<T>, $Fourth<T>>($Bivector::from(self))
            }
        }
    };
}

/// Polar normalisation of types whose `X X̃` is a number.
#[doc(hidden)]
#[macro_export]
macro_rules! renormalization {
    ($Name:ident $doc:literal) => {
        impl<T: $crate::Real> $crate::ops::Renormalize for $Name<T> {
            type Output = $Name<T>;
            #[doc = $doc]
            #[inline]
            fn renormalized(self) -> ::core::option::Option<$Name<T>> {
                $crate::algorithm::over_norm(self)
            }
        }
    };
}

/// Logarithms, roots and polar normalisation of even types: the type, the type of its roots, and
/// the types of its bivectors and four-vectors, which commute if marked so.
#[doc(hidden)]
#[macro_export]
macro_rules! versor_functions {
    (
        $logarithm:ident $commuting:ident
        $Name:ident => $Versor:ident ($Bivector:ident $Fourth:ident) $log:literal $sqrt:literal $normal:literal
    ) => {
        impl<T: $crate::Real> $crate::ops::Logarithm for $Name<T> {
            type Output = $Bivector<T>;
            #[doc = $log]
            #[inline]
            fn log(self) -> ::core::option::Option<$Bivector<T>> {
                $crate::algorithm::$logarithm::<T, _, $Bivector<T>, $Fourth<T>>(
                    self,
                    $crate::versor_functions!(@$commuting $Bivector $Fourth),
                )
            }
        }
        impl<T: $crate::Real> $crate::ops::SquareRoot for $Name<T> {
            type Output = $Versor<T>;
            #[doc = $sqrt]
            #[inline]
            fn sqrt(self) -> ::core::option::Option<$Versor<T>> {
                $crate::algorithm::square_root::<T, _, $Bivector<T>, $Fourth<T>, _>(
                    self,
                    $crate::versor_functions!(@$commuting $Bivector $Fourth),
                )
            }
        }
        impl<T: $crate::Real> $crate::ops::Renormalize for $Name<T> {
            type Output = $Versor<T>;
            #[doc = $normal]
            #[inline]
            fn renormalized(self) -> ::core::option::Option<$Versor<T>> {
                $crate::algorithm::renormalise::<T, _, $Bivector<T>, $Fourth<T>, _>(
                    self,
                    $crate::versor_functions!(@$commuting $Bivector $Fourth),
                )
            }
        }
    };
    (@commuting $Bivector:ident $Fourth:ident) => {
        $crate::algorithm::Commutators {
            planes: |_: $Bivector<T>, _: $Fourth<T>| $Fourth::default(),
            fourths: |_: $Fourth<T>, _: $Fourth<T>| $Bivector::default(),
        }
    };
    (@general $Bivector:ident $Fourth:ident) => {
        $crate::algorithm::Commutators {
            planes: |a: $Bivector<T>, b: $Fourth<T>| -> $Fourth<T> {
                $crate::convert::pick($crate::ops::Commutator::commutator(a, b))
            },
            fourths: |a: $Fourth<T>, b: $Fourth<T>| -> $Bivector<T> {
                $crate::convert::pick($crate::ops::Commutator::commutator(a, b))
            },
        }
    };
}

/// Quotients `a b⁻¹`.
#[doc(hidden)]
#[macro_export]
macro_rules! quotients {
    ($Left:ident: $($Right:ident $doc:literal),*) => {$(
        impl<T: $crate::Field> $crate::ops::Quotient<$Right<T>> for $Left<T> {
            type Output = <$Left<T> as $crate::ops::Geometric<<$Right<T> as $crate::ops::Inverse>::Output>>::Output;
            #[doc = $doc]
            #[inline]
            fn quotient(self, b: $Right<T>) -> Self::Output {
                $crate::ops::Geometric::geometric(self, $crate::ops::Inverse::reciprocal(b))
            }
        }
    )*};
}

/// Sandwiches computed as two products, of which only the result's blades are kept.
#[doc(hidden)]
#[macro_export]
macro_rules! composed_sandwich {
    ($Versor:ident even: $($Operand:ident => $Result:ident $doc:literal),*) => {$(
        $crate::composed_sandwich! { @one $Versor $Operand $Result false $doc }
    )*};
    ($Versor:ident odd: $($Operand:ident => $Result:ident $doc:literal),*) => {$(
        $crate::composed_sandwich! { @one $Versor $Operand $Result true $doc }
    )*};
    (@one $Versor:ident $Operand:ident $Result:ident $odd:literal $doc:literal) => {
        impl<T: $crate::Field> $crate::ops::Sandwich<$Operand<T>> for $Versor<T> {
            type Output = $Result<T>;
            #[doc = $doc]
            #[inline]
            fn sandwich(self, x: $Operand<T>) -> $Result<T> {
                let back = $crate::ops::Reverse::reverse(self);
                let image = $crate::ops::Geometric::geometric(self, x);
                let image = $crate::ops::Geometric::geometric(image, back);
                $crate::convert::image::<_, $Operand<T>, _>(image, $odd)
            }
        }
    };
}

/// Versor application by way of the sandwich.
#[doc(hidden)]
#[macro_export]
macro_rules! application {
    ($Versor:ident unit: $($Operand:ident $doc:literal),*) => {$(
        impl<T: $crate::Field> $crate::ops::Apply<$Operand<T>> for $Versor<T> {
            type Output = <$Versor<T> as $crate::ops::Sandwich<$Operand<T>>>::Output;
            #[doc = $doc]
            #[inline]
            fn apply(self, x: $Operand<T>) -> Self::Output {
                $crate::ops::Sandwich::sandwich(self, x)
            }
        }
    )*};
    ($Versor:ident divided: $($Operand:ident $doc:literal),*) => {$(
        impl<T: $crate::Field> $crate::ops::Apply<$Operand<T>> for $Versor<T> {
            type Output = <$Versor<T> as $crate::ops::Sandwich<$Operand<T>>>::Output;
            #[doc = $doc]
            #[inline]
            fn apply(self, x: $Operand<T>) -> Self::Output {
                let factor = T::ONE / $crate::ops::NormSquared::norm_squared(self);
                $crate::ops::Sandwich::sandwich(self, x) * factor
            }
        }
    )*};
}

/// Versor application handed on by duality: the pseudoscalar passes through versors, so that
/// `(V I)[x] = V[x̂]` and `V[x I] = ±V[x] I`, minus for odd versors.
#[doc(hidden)]
#[macro_export]
macro_rules! dual_application {
    ($Versor:ident: $($form:ident $Operand:ident => $Output:ident $doc:literal),*) => {$(
        impl<T: $crate::Field> $crate::ops::Apply<$Operand<T>> for $Versor<T> {
            type Output = $Output<T>;
            #[doc = $doc]
            #[inline]
            fn apply(self, x: $Operand<T>) -> $Output<T> {
                $crate::dual_application!(@$form self x)
            }
        }
    )*};
    (@versor $v:ident $x:ident) => {
        $v.dual().apply($x)
    };
    (@minus_versor $v:ident $x:ident) => {
        -$v.dual().apply($x)
    };
    (@involuted_versor $v:ident $x:ident) => {
        $v.dual().apply($x.involute())
    };
    (@operand $v:ident $x:ident) => {
        $v.apply($x.dual()).undual()
    };
    (@minus_operand $v:ident $x:ident) => {
        -$v.apply($x.dual()).undual()
    };
}
