//! Sums, multiples and the operators, on values and on references.

/// Addition and multiples. A type with fixed coefficients widens first.
#[doc(hidden)]
#[macro_export]
macro_rules! element_arithmetic {
    ($Name:ident $Sum:ident { $($field:ident,)* } {}) => {
        impl<T: $crate::Scalar> ::core::ops::Add for $Name<T> {
            type Output = $Name<T>;
            $crate::inlined! {
                /// The sum, coefficient by coefficient: one addition each.
                fn add(self, b: Self) -> Self {
                    $Name { $($field: self.$field + b.$field),* }
                }
            }
        }
        impl<T: $crate::Scalar> ::core::ops::Sub for $Name<T> {
            type Output = $Name<T>;
            $crate::inlined! {
                /// The difference, coefficient by coefficient: one subtraction each.
                fn sub(self, b: Self) -> Self {
                    $Name { $($field: self.$field - b.$field),* }
                }
            }
        }
        impl<T: $crate::Scalar> ::core::ops::Neg for $Name<T> {
            type Output = $Name<T>;
            $crate::inlined! {
                /// Every coefficient negated; no other operations.
                fn neg(self) -> Self {
                    $Name { $($field: -self.$field),* }
                }
            }
        }
        impl<T: $crate::Scalar> $crate::ops::Geometric<T> for $Name<T> {
            type Output = $Name<T>;
            $crate::inlined! {
                /// The multiple `a b`: one multiplication a coefficient.
                fn geometric(self, b: T) -> Self {
                    $Name { $($field: self.$field * b),* }
                }
            }
        }
        impl<T: $crate::Field> $crate::ops::Quotient<T> for $Name<T> {
            type Output = $Name<T>;
            $crate::inlined! {
                /// The multiple `a / b`: one division a coefficient.
                fn quotient(self, b: T) -> Self {
                    $Name { $($field: self.$field / b),* }
                }
            }
        }
        impl<T: $crate::Scalar> ::core::ops::AddAssign for $Name<T> {
            $crate::inlined! {
                /// Adds, coefficient by coefficient: one addition each.
                fn add_assign(&mut self, b: Self) {
                    $(self.$field += b.$field;)*
                }
            }
        }
        impl<T: $crate::Scalar> ::core::ops::SubAssign for $Name<T> {
            $crate::inlined! {
                /// Subtracts, coefficient by coefficient: one subtraction each.
                fn sub_assign(&mut self, b: Self) {
                    $(self.$field -= b.$field;)*
                }
            }
        }
        impl<T: $crate::Scalar> ::core::ops::MulAssign<T> for $Name<T> {
            $crate::inlined! {
                /// Multiplies by a number: one multiplication a coefficient.
                fn mul_assign(&mut self, b: T) {
                    $(self.$field *= b;)*
                }
            }
        }
        impl<T: $crate::Field> ::core::ops::DivAssign<T> for $Name<T> {
            $crate::inlined! {
                /// Divides by a number: one division a coefficient.
                fn div_assign(&mut self, b: T) {
                    $(self.$field /= b;)*
                }
            }
        }
        impl<T: $crate::Scalar> ::core::iter::Sum for $Name<T> {
            fn sum<I: ::core::iter::Iterator<Item = Self>>(terms: I) -> Self {
                terms.fold(Self { $($field: T::ZERO),* }, |sum, term| sum + term)
            }
        }
        impl<'a, T: $crate::Scalar> ::core::iter::Sum<&'a $Name<T>> for $Name<T> {
            fn sum<I: ::core::iter::Iterator<Item = &'a Self>>(terms: I) -> Self {
                terms.copied().sum()
            }
        }
        impl<T: $crate::Scalar> ::core::convert::From<[T; { $crate::count!($($field)*) }]> for $Name<T> {
            $crate::inlined! {
                fn from([$($field),*]: [T; { $crate::count!($($field)*) }]) -> Self {
                    $Name { $($field),* }
                }
            }
        }
        $crate::element_arithmetic! { @references $Name $Name { $($field,)* } }
    };
    ($Name:ident $Sum:ident { $($field:ident,)* } { $($fixed:tt)+ }) => {
        impl<T: $crate::Field> ::core::ops::Add for $Name<T> {
            type Output = $Sum<T>;
            $crate::inlined! {
                /// The sum, without the fixed coefficients: one addition a coefficient of the result.
                fn add(self, b: Self) -> $Sum<T> {
                    $Sum::from(self) + $Sum::from(b)
                }
            }
        }
        impl<T: $crate::Field> ::core::ops::Sub for $Name<T> {
            type Output = $Sum<T>;
            $crate::inlined! {
                /// The difference, without the fixed coefficients: one subtraction a coefficient of the
                /// result.
                fn sub(self, b: Self) -> $Sum<T> {
                    $Sum::from(self) - $Sum::from(b)
                }
            }
        }
        impl<T: $crate::Field> ::core::ops::Neg for $Name<T> {
            type Output = $Sum<T>;
            $crate::inlined! {
                /// Every coefficient negated, without the fixed ones as such; no other operations.
                fn neg(self) -> $Sum<T> {
                    -$Sum::from(self)
                }
            }
        }
        impl<T: $crate::Field> $crate::ops::Geometric<T> for $Name<T> {
            type Output = $Sum<T>;
            $crate::inlined! {
                /// The multiple `a b`, without the fixed coefficients: one multiplication a coefficient of
                /// the result.
                fn geometric(self, b: T) -> $Sum<T> {
                    $Sum::from(self).geometric(b)
                }
            }
        }
        impl<T: $crate::Field> $crate::ops::Quotient<T> for $Name<T> {
            type Output = $Sum<T>;
            $crate::inlined! {
                /// The multiple `a / b`, without the fixed coefficients: one division a coefficient of the
                /// result.
                fn quotient(self, b: T) -> $Sum<T> {
                    $Sum::from(self).quotient(b)
                }
            }
        }
        impl<T: $crate::Field> ::core::iter::Sum<$Name<T>> for $Sum<T> {
            fn sum<I: ::core::iter::Iterator<Item = $Name<T>>>(terms: I) -> Self {
                terms.map($Sum::from).sum()
            }
        }
        impl<T: $crate::Scalar> ::core::convert::From<[T; { $crate::count!($($field)*) }]> for $Name<T> {
            $crate::inlined! {
                fn from([$($field),*]: [T; { $crate::count!($($field)*) }]) -> Self {
                    $Name { $($field),* }
                }
            }
        }
        $crate::element_arithmetic! { @references $Name $Sum { $($field,)* } }
    };
    (@references $Name:ident $Sum:ident { $($field:ident,)* }) => {
        impl<T: $crate::Scalar> ::core::convert::From<$Name<T>> for [T; { $crate::count!($($field)*) }] {
            $crate::inlined! {
                fn from(a: $Name<T>) -> Self {
                    [$(a.$field),*]
                }
            }
        }
        $crate::element_arithmetic! { @binary $Name Add add Sub sub }
        $crate::element_arithmetic! { @number $Name $Sum f32 f64 }
        impl<'a, T: $crate::Scalar> ::core::ops::Neg for &'a $Name<T>
        where
            $Name<T>: ::core::ops::Neg,
        {
            type Output = <$Name<T> as ::core::ops::Neg>::Output;
            $crate::inlined! {
                fn neg(self) -> Self::Output {
                    -*self
                }
            }
        }
    };
    (@binary $Name:ident $($trait:ident $method:ident)*) => {$(
        impl<'a, T: $crate::Scalar> ::core::ops::$trait<&'a $Name<T>> for $Name<T>
        where
            $Name<T>: ::core::ops::$trait,
        {
            type Output = <$Name<T> as ::core::ops::$trait>::Output;
            $crate::inlined! {
                fn $method(self, b: &'a $Name<T>) -> Self::Output {
                    ::core::ops::$trait::$method(self, *b)
                }
            }
        }
        impl<'a, T: $crate::Scalar> ::core::ops::$trait<$Name<T>> for &'a $Name<T>
        where
            $Name<T>: ::core::ops::$trait,
        {
            type Output = <$Name<T> as ::core::ops::$trait>::Output;
            $crate::inlined! {
                fn $method(self, b: $Name<T>) -> Self::Output {
                    ::core::ops::$trait::$method(*self, b)
                }
            }
        }
        impl<'a, 'b, T: $crate::Scalar> ::core::ops::$trait<&'b $Name<T>> for &'a $Name<T>
        where
            $Name<T>: ::core::ops::$trait,
        {
            type Output = <$Name<T> as ::core::ops::$trait>::Output;
            $crate::inlined! {
                fn $method(self, b: &'b $Name<T>) -> Self::Output {
                    ::core::ops::$trait::$method(*self, *b)
                }
            }
        }
    )*};
    // Numbers on the left: the orphan rule wants them one by one.
    (@number $Name:ident $Sum:ident $($number:ident)*) => {$(
        impl ::core::ops::Mul<$Name<$number>> for $number {
            type Output = $Sum<$number>;
            $crate::inlined! {
                fn mul(self, b: $Name<$number>) -> $Sum<$number> {
                    b * self
                }
            }
        }
        impl<'a> ::core::ops::Mul<&'a $Name<$number>> for $number {
            type Output = $Sum<$number>;
            $crate::inlined! {
                fn mul(self, b: &'a $Name<$number>) -> $Sum<$number> {
                    *b * self
                }
            }
        }
    )*};
}

/// The operators, each a name for one product: `*` geometric, `^` outer, `|` inner,
/// `&` regressive, `<<` left contraction, `/` quotient, `!` dual.
#[doc(hidden)]
#[macro_export]
macro_rules! element_operators {
    ($Name:ident) => {
        $crate::element_operators! { @binary $Name
            Mul mul Geometric geometric,
            BitXor bitxor Wedge wedge,
            BitOr bitor Inner inner,
            BitAnd bitand Regressive regressive,
            Shl shl LeftContract left_contract,
            Div div Quotient quotient,
        }
        $crate::element_operators! { @sum $Name
            Add add,
            Sub sub,
        }
        impl<T> ::core::ops::Not for $Name<T>
        where
            $Name<T>: $crate::ops::Dual,
        {
            type Output = <$Name<T> as $crate::ops::Dual>::Output;
            $crate::inlined! {
                fn not(self) -> Self::Output {
                    $crate::ops::Dual::dual(self)
                }
            }
        }
    };
    (@sum $Name:ident $($operator:ident $method:ident,)*) => {$(
        /// With elements of other types, in the smallest type that holds both; one operation a
        /// coefficient.
        impl<T, B> ::core::ops::$operator<B> for $Name<T>
        where
            $Name<T>: $crate::ops::Addend<B>,
        {
            type Output = <$Name<T> as $crate::ops::Addend<B>>::Sum;
            $crate::inlined! {
                fn $method(self, b: B) -> Self::Output {
                    ::core::ops::$operator::$method(Self::Output::from(self), Self::Output::from(b))
                }
            }
        }
    )*};
    (@binary $Name:ident $($operator:ident $method:ident $product:ident $name:ident,)*) => {$(
        impl<T, B> ::core::ops::$operator<B> for $Name<T>
        where
            $Name<T>: $crate::ops::$product<B>,
        {
            type Output = <$Name<T> as $crate::ops::$product<B>>::Output;
            $crate::inlined! {
                fn $method(self, b: B) -> Self::Output {
                    $crate::ops::$product::$name(self, b)
                }
            }
        }
        impl<'a, T: ::core::marker::Copy, B> ::core::ops::$operator<B> for &'a $Name<T>
        where
            $Name<T>: $crate::ops::$product<B>,
        {
            type Output = <$Name<T> as $crate::ops::$product<B>>::Output;
            $crate::inlined! {
                fn $method(self, b: B) -> Self::Output {
                    $crate::ops::$product::$name(*self, b)
                }
            }
        }
    )*};
}
