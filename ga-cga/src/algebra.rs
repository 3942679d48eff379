//! The one declaration that the conformal model is generated from.

ga_macros::define_algebra! {
    /// Conformal geometric algebra of Euclidean 3-space, signature (4, 1), in the null basis.
    ///
    /// `no` is the point at the origin n_o = (e₋ + e₊)/2, `ni` the point at infinity
    /// n_∞ = e₋ − e₊ (2.39), so that n_o·n_∞ = −1 and E = n_o∧n_∞ squares to 1 (2.43).
    /// The types are the rows of Table 2.6; direct (outer-product) and dual (inner-product)
    /// forms are different types.
    pub mod cga3: R4_1 {
        basis { e1, e2, e3, no, ni }
        metric { e1^2 = 1, e2^2 = 1, e3^2 = 1, no.ni = -1 }
        types {
            /// A Euclidean vector **a**, relative to the origin: e₁, e₂, e₃ of Table 2.5.
            Vector3 { e1, e2, e3 }
            /// A Euclidean bivector **B** = **a**∧**b**: a plane through the origin with an
            /// orientation and an area: e₁₂, e₁₃, e₂₃ of Table 2.5.
            Bivector3 { e12, e13, e23 }
            /// A Euclidean trivector, a multiple of the volume **I**₃: e₁₂₃ of Table 2.5.
            Trivector3 { e123 }
            /// A point of weight 1, p = n_o + **x** + ½**x**² n_∞ (2.44); n_o of Table 2.5 is the origin.
            /// [`at`](Self::at) makes them; whoever gives all coefficients promises the last.
            #[null]
            Point { no = 1, e1, e2, e3, ni }
            /// A dual sphere σ = p − ½r² n_∞ (2.52) of any weight; with it every vector of the
            /// algebra, all grade 1 of Table 2.5: weighted points, dual planes, imaginary spheres, n_∞.
            DualSphere { no, e1, e2, e3, ni }
            /// A dual plane π = **n** + δ n_∞ with normal **n** at distance δ: e₁, e₂, e₃, n_∞ of Table 2.5.
            DualPlane { e1, e2, e3, ni }
            /// A point pair κ = a∧b (2.47), also the dual of a circle: all grade 2 of Table 2.5.
            PointPair = grade 2;
            /// A flat point p∧n_∞, where three planes meet: E and e₁n_∞, e₂n_∞, e₃n_∞ of Table 2.5.
            FlatPoint { e1^ni, e2^ni, e3^ni, no^ni }
            /// A direction vector **t** n_∞, which generates translations: e₁n_∞, e₂n_∞, e₃n_∞ of Table 2.5.
            DirectionVector { e1^ni, e2^ni, e3^ni }
            /// A tangent vector n_o **t**, which generates transversions: e₁n_o, e₂n_o, e₃n_o of Table 2.5.
            TangentVector { e1^no, e2^no, e3^no }
            /// A dual line λ = **B** + **d** n_∞, which generates motors: e₁₂ … and e₁n_∞ … of Table 2.5.
            DualLine { e12, e13, e23, e1^ni, e2^ni, e3^ni }
            /// A multiple of E = n_o∧n_∞, the Minkowski plane of Table 2.5, which generates dilations.
            MinkowskiPlane { no^ni }
            /// A circle K = a∧b∧c (2.48), also the dual of a point pair: all grade 3 of Table 2.5.
            Circle = grade 3;
            /// A line Λ = a∧b∧n_∞ (2.50): e₁E, e₂E, e₃E and e₁₂n_∞, e₁₃n_∞, e₂₃n_∞ of Table 2.5.
            Line { e12^ni, e13^ni, e23^ni, e1^no^ni, e2^no^ni, e3^no^ni }
            /// A direction bivector **B** n_∞: e₁₂n_∞, e₁₃n_∞, e₂₃n_∞ of Table 2.5.
            DirectionBivector { e12^ni, e13^ni, e23^ni }
            /// A tangent bivector n_o **B** at the origin: e₁₂n_o, e₁₃n_o, e₂₃n_o of Table 2.5.
            TangentBivector { e12^no, e13^no, e23^no }
            /// A sphere Σ = a∧b∧c∧d (2.49): all grade 4 of Table 2.5.
            Sphere = grade 4;
            /// A plane Π = a∧b∧c∧n_∞ (2.51): e₁₂E, e₁₃E, e₂₃E and e₁₂₃n_∞ of Table 2.5.
            Plane { e123^ni, e12^no^ni, e13^no^ni, e23^no^ni }
            /// A direction trivector **I**₃ n_∞: e₁₂₃n_∞ of Table 2.5.
            DirectionTrivector { e123^ni }
            /// A tangent trivector n_o **I**₃ at the origin: e₁₂₃n_o of Table 2.5.
            TangentTrivector { e123^no }
            /// A multiple of the pseudoscalar I = e₁₂₃ E, grade 5 of Table 2.5: all of space.
            Pseudoscalar { e123^no^ni }
            /// A rotor e^{−θB/2}: a rotation by θ in the sense of B about the origin.
            Rotor { 1, e12, e13, e23 }
            /// A translator 1 − ½**v** n_∞: a translation by **v**.
            Translator { 1 = 1, e1^ni, e2^ni, e3^ni }
            /// A motor, any rigid motion without reflection: a translator times a rotor.
            Motor { 1, e12, e13, e23, e1^ni, e2^ni, e3^ni, e123^ni }
            /// A dilator e^{−cE/2}: a scaling about the origin by e^{−c}.
            Dilator { 1, no^ni }
            /// A transversor 1 − ½**v** n_o: an inversion, a translation by ½**v** and the
            /// inversion back.
            Transversor { 1 = 1, e1^no, e2^no, e3^no }
        }
    }
}
