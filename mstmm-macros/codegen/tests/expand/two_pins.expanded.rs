/// Two rods in a plane, by the forward product.
///
/// # The chain
///
/// `ground -> pin shoulder -> upper -> pin elbow -> lower`
///
/// <svg role="img" aria-label="The chain at its start" viewBox="0 0 532 303" width="532" style="max-width:100%;height:auto" font-size="12" stroke-linecap="round" fill="currentColor">
/// <path d="M22 281l12.1 7.0" stroke="currentColor" opacity="0.6"/><text x="40.2" y="294.4" font-size="10" opacity="0.6" text-anchor="middle">x</text>
/// <path d="M22 281l0.0 -14.0" stroke="currentColor" opacity="0.6"/><text x="22.0" y="262.9" font-size="10" opacity="0.6" text-anchor="middle">y</text>
/// <path d="M22 281l-12.1 7.0" stroke="currentColor" opacity="0.6"/><text x="3.8" y="294.4" font-size="10" opacity="0.6" text-anchor="middle">z</text>
/// <path d="M36.0 36.0L236.0 151.5" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M36.0 36.0L136.0 93.7L236.0 151.5" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="136.0" cy="93.7" r="3" fill="#3a87c8"/>
/// <path d="M236.0 151.5L436.0 266.9" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M236.0 151.5L336.0 209.2L436.0 266.9" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="336.0" cy="209.2" r="3" fill="#3a87c8"/>
/// <path d="M22.0 45.0h28m-26 7l5 -7m2 7l5 -7m2 7l5 -7" fill="none" stroke="currentColor"/>
/// <circle cx="36.0" cy="36.0" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <circle cx="236.0" cy="151.5" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <text x="44.0" y="28.0">shoulder</text>
/// <text x="136.0" y="113.7" text-anchor="middle" font-style="italic">upper</text>
/// <text x="244.0" y="143.5">elbow</text>
/// <text x="336.0" y="229.2" text-anchor="middle" font-style="italic">lower</text>
/// <path d="M502.0 22.0l0.0 28.0m-3.5 -6.1l3.5 6.1l3.5 -6.1" fill="none" stroke="currentColor" stroke-width="1.5"/><text x="515.0" y="40.0" font-style="italic" text-anchor="middle">g</text>
/// </svg>
///
/// | element | what it is | freedoms |
/// |---|---|---|
/// | `shoulder` | pin(z) | 1 |
/// | `upper` | body `Rod`, 1 kg |  |
/// | `elbow` | pin(z) | 1 |
/// | `lower` | body `Rod`, 1 kg |  |
///
/// Mobility 2: 2 degrees of freedom.
///
/// Accelerations by `transfer`, 122 operations (69 mul, 48 add, 3 reciprocal, 2 square root, 2 sin/cos); with the results that are asked for 160 operations.
///
/// **Precision of `transfer`.** The largest mass is 1 times the smallest, with parameters at their defaults. `transfer` may lose digits by that factor: for bodies of similar size the relative error of accelerations is up to 2.4e-13 in `f64` and 1.3e-4 in `f32`, that of wrenches at the lightest bodies up to a hundred times more. `riccati` does not lose them.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct TwoPins<T> {
    changed_by_setters: ::mstmm::generated::Sealed<TwoPinsParameters<T>, [T; 0]>,
}
/// Numbers of [`TwoPins`] that may change at run time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct TwoPinsParameters<T> {
    none: ::core::marker::PhantomData<T>,
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TwoPinsParameters<T> {}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TwoPins<T> {
    /// The chain as described.
    #[inline]
    #[must_use]
    #[allow(clippy::all)]
    pub fn new() -> Self {
        let parameters_ = TwoPinsParameters {
            none: ::core::marker::PhantomData,
        };
        let (chain_, _) = Self::derive(::mstmm::generated::Sealed::new(parameters_));
        chain_
    }
    /// The values that may change at run time: there are none.
    #[inline]
    pub fn parameters(&self) -> &TwoPinsParameters<T> {
        self.changed_by_setters.parameters()
    }
    /// The state that the description starts from, at time zero.
    #[must_use]
    #[allow(unused_doc_comments, clippy::all)]
    pub fn initial_state(&self) -> TwoPinsState<T> {
        let c_ = T::constant;
        TwoPinsState {
            q: ::mstmm::generated::vector([c_(0.0), c_(0.0)]),
            v: ::mstmm::generated::vector([c_(0.0), c_(0.0)]),
            t: T::constant(0.0),
        }
    }
    /// Quantities derived from parameters and constants: 0 mul, 0 add, 0 reciprocal.
    #[allow(unused_doc_comments, unused_variables, unused_mut, clippy::all)]
    fn derive(
        sealed_: ::mstmm::generated::Sealed<TwoPinsParameters<T>>,
    ) -> (Self, [T; 0]) {
        let parameters_ = sealed_.parameters();
        let (derived_, checks_) = ([], []);
        (
            Self {
                changed_by_setters: sealed_.with(derived_),
            },
            checks_,
        )
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for TwoPins<T> {
    fn default() -> Self {
        Self::new()
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TwoPins<T> {
    /// The accelerations `v̇` of all hinges, in the order of `v` of the state: the fast path.
    ///
    /// 122 operations: 69 mul, 48 add, 3 reciprocal, 2 square root, 2 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `shoulder` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 2 |
    /// | Boundary solve at the far end | \[P, Eqs. (9) to (11)\] | 54 | 39 | 3 | 2 | 0 |
    /// | Transfer to `elbow` | \[P, Eqs. (8), (21)\] with the conditions \[P, Eqs. (25), (35)\] of this hinge | 7 | 5 | 0 | 0 | 0 |
    /// | Motion across `elbow` | \[P, Eqs. (1), (13), (36)\] | 1 | 1 | 0 | 0 | 0 |
    /// | Transfer to `shoulder` | \[P, Eqs. (8), (21)\] with the conditions \[P, Eqs. (25), (35)\] of this hinge | 2 | 0 | 0 | 0 | 0 |
    /// | Back to `shoulder` | \[P, Eqs. (8), (11)\] | 3 | 2 | 0 | 0 | 0 |
    /// | Inertia beyond the hinges, to be divided by | the pivots of the Riccati transfer | 2 | 1 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// `Error::Singular` if no inertia is left beyond a
    /// hinge, `Error::NotFinite` if a number of the state or the
    /// inputs is not finite. `accelerations` is not touched then.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn accelerations_into(
        &self,
        state_: &TwoPinsState<T>,
        inputs_: &TwoPinsInputs<T>,
        accelerations_: &mut ::mstmm::nalgebra::SVector<T, 2>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let c_ = T::constant;
        let [[shoulder_angle_, elbow_angle_]] = state_.q.data.0;
        let [[shoulder_rate_, elbow_rate_]] = state_.v.data.0;
        /// Motion across `shoulder`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 2 sin/cos.
        let (
            [sin_shoulder_angle_,
            sin_elbow_angle_,
            ],
            [cos_shoulder_angle_,
            cos_elbow_angle_,
            ],
        ) = T::sin_cos([shoulder_angle_, elbow_angle_]);
        /// Boundary solve at the far end, [P, Eqs. (9) to (11)]: 54 mul, 39 add, 3 reciprocal, 2 square root.
        let t24_ = T::mul_add(
            sin_elbow_angle_,
            c_(0.48639392383214375),
            sin_elbow_angle_,
        );
        let t15_ = cos_elbow_angle_ * cos_elbow_angle_;
        let t25_ = T::mul_sub(sin_elbow_angle_, c_(0.17120202538928544), t24_);
        let t29_ = T::mul_add(t25_, t25_, t15_);
        let t30_ = T::sqrt(t29_);
        let t31_ = T::copysign(t30_, cos_elbow_angle_);
        let t32_ = cos_elbow_angle_ + t31_;
        let t26_ = T::mul_add(cos_elbow_angle_, c_(0.5), c_(0.4931969619160719));
        let t33_ = t31_ * t32_;
        /// Transfer to `elbow`, [P, Eqs. (8), (21)] with the conditions [P, Eqs. (25), (35)] of this hinge: 7 mul, 5 add, 0 reciprocal.
        let elbow_a4_lin_y_ = T::mul_neg_add(
            cos_elbow_angle_,
            c_(0.013606076167856269),
            cos_elbow_angle_,
        );
        /// Boundary solve at the far end.
        let t27_ = T::mul_sub(cos_elbow_angle_, c_(0.17120202538928544), t26_);
        let t34_ = T::recip(t33_);
        let t28_ = elbow_a4_lin_y_ - t27_;
        let t37_ = t25_ * t28_;
        let t38_ = T::mul_add(sin_elbow_angle_, t32_, t37_);
        let t39_ = t34_ * t38_;
        let t41_ = T::mul_neg_add(t25_, t39_, t28_);
        let t50_ = T::mul_add(t41_, t41_, c_(0.25));
        let t51_ = T::sqrt(t50_);
        let t52_ = T::copysign(t51_, -t41_);
        /// Motion across `elbow`, [P, Eqs. (1), (13), (36)]: 1 mul, 1 add, 0 reciprocal.
        let elbow_omega_z_ = shoulder_rate_ + elbow_rate_;
        let minus_elbow_centripetal_x_ = shoulder_rate_ * shoulder_rate_;
        /// Boundary solve at the far end.
        let t53_ = t41_ - t52_;
        /// Transfer to `shoulder`, [P, Eqs. (8), (21)] with the conditions [P, Eqs. (25), (35)] of this hinge: 2 mul, 0 add, 0 reciprocal.
        let shoulder_a_lin_x_ = sin_shoulder_angle_ * c_(9.8);
        /// Boundary solve at the far end.
        let t14_ = T::mul_add(c_(0.5), elbow_a4_lin_y_, c_(0.3287979746107146));
        let t54_ = t52_ * t53_;
        let t7_ = elbow_omega_z_ * elbow_omega_z_;
        let t9_ = T::mul_sub(minus_elbow_centripetal_x_, c_(0.5), shoulder_a_lin_x_);
        let t46_ = t14_ * t25_;
        /// Transfer to `elbow`.
        let t1_ = minus_elbow_centripetal_x_ - shoulder_a_lin_x_;
        /// Transfer to `shoulder`.
        let shoulder_a_lin_y_ = cos_shoulder_angle_ * c_(9.8);
        /// Boundary solve at the far end.
        let t55_ = T::recip(t54_);
        let t8_ = c_(0.5) * t7_;
        let t17_ = t9_ + t1_;
        let t47_ = t34_ * t46_;
        /// Transfer to `elbow`.
        let t2_ = cos_elbow_angle_ * shoulder_a_lin_y_;
        /// Boundary solve at the far end.
        let t10_ = sin_elbow_angle_ * shoulder_a_lin_y_;
        let t20_ = T::mul_add(cos_elbow_angle_, t17_, t8_);
        let t18_ = T::mul_neg_add(
            sin_elbow_angle_,
            c_(0.16439898730535732),
            sin_elbow_angle_,
        );
        let t49_ = T::mul_neg_add(t25_, t47_, t14_);
        /// Transfer to `elbow`.
        let t4_ = T::mul_neg_add(cos_shoulder_angle_, c_(4.9), shoulder_a_lin_y_);
        /// Boundary solve at the far end.
        let t11_ = T::mul_add(sin_elbow_angle_, t9_, t2_);
        let t21_ = t10_ - t20_;
        let t19_ = T::mul_sub(sin_elbow_angle_, c_(2.0685934174848226), t18_);
        let t58_ = T::mul_add(t49_, t53_, c_(0.16666666666666666));
        /// Transfer to `elbow`.
        let t5_ = t4_ * c_(0.9863939238321437);
        let t6_ = cos_elbow_angle_ * c_(0.16439898730535732);
        /// Boundary solve at the far end.
        let t16_ = T::mul_neg_add(
            cos_elbow_angle_,
            c_(2.0685934174848226),
            cos_elbow_angle_,
        );
        let t22_ = t10_ + t21_;
        /// Transfer to `elbow`.
        let t3_ = T::mul_add(sin_elbow_angle_, t1_, t2_);
        /// Boundary solve at the far end.
        let t42_ = T::mul_neg_add(t4_, c_(0.0810810810810811), t11_);
        let t59_ = t55_ * t58_;
        let t23_ = T::mul_sub(t5_, t19_, t22_);
        let t35_ = t32_ * t34_;
        /// Transfer to `elbow`.
        let elbow_a_lin_y_ = T::mul_neg_add(t5_, t6_, t3_);
        /// Boundary solve at the far end.
        let t43_ = T::mul_add(t5_, t16_, t42_);
        let t61_ = T::mul_add(c_(0.5), t59_, c_(0.3333333333333333));
        let t12_ = t4_ * c_(0.054054054054054064);
        let t36_ = t23_ * t35_;
        let t40_ = T::mul_neg_add(t32_, t39_, sin_elbow_angle_);
        let t44_ = elbow_a_lin_y_ + t43_;
        let t64_ = T::recip(t61_);
        let t13_ = T::mul_sub(c_(0.5), elbow_a_lin_y_, t12_);
        let t48_ = t32_ * t47_;
        let t45_ = T::mul_add(t36_, t40_, t44_);
        let t56_ = t53_ * t55_;
        let t62_ = T::mul_neg_add(t36_, t48_, t13_);
        let t57_ = t45_ * t56_;
        let t60_ = T::mul_add(t53_, t59_, t49_);
        let t63_ = T::mul_sub(t57_, t60_, t62_);
        let t66_ = t53_ * t57_;
        let t65_ = t63_ * t64_;
        let t67_ = T::mul_neg_add(c_(0.5), t65_, t66_);
        let t68_ = t55_ * t67_;
        let t70_ = t32_ * t36_;
        let t69_ = T::mul_add(t53_, t68_, t57_);
        let t71_ = T::mul_neg_add(t25_, t69_, t70_);
        let t72_ = t34_ * t71_;
        /// Back to `shoulder`, [P, Eqs. (8), (11)]: 3 mul, 2 add, 0 reciprocal.
        let t73_ = t4_ * c_(1.9863939238321437);
        /// Boundary solve at the far end.
        let minus_end_x4_ = T::mul_add(t25_, t72_, t69_);
        /// Inertia beyond the hinges, to be divided by, the pivots of the Riccati transfer: 2 mul, 1 add, 0 reciprocal.
        let t0_ = sin_elbow_angle_ * sin_elbow_angle_;
        /// Back to `shoulder`.
        let t74_ = T::mul_neg_add(c_(0.16666666666666669), minus_end_x4_, t73_);
        /// Inertia beyond the hinges, to be divided by.
        let shoulder_d_ = T::mul_add(t0_, c_(0.75), c_(0.5833333333333333));
        /// Boundary solve at the far end.
        let end_x5_ = T::mul_neg_add(c_(0.5), t68_, t65_);
        /// Back to `shoulder`.
        let minus_shoulder_beta0_ = T::mul_add(
            c_(0.0816364570071376),
            t74_,
            minus_end_x4_,
        );
        if !::mstmm::generated::regular::<
            T,
            _,
            _,
        >(
            [shoulder_d_],
            [c_(2.9266666666666667)],
            [state_.t, end_x5_, -minus_shoulder_beta0_],
        ) {
            return ::core::result::Result::Err(
                ::mstmm::generated::irregular::<
                    T,
                    _,
                >(&["shoulder"], [shoulder_d_], [c_(2.9266666666666667)]),
            );
        }
        accelerations_.data.0 = [[-minus_shoulder_beta0_, end_x5_]];
        ::core::result::Result::Ok(())
    }
    /// The accelerations `v̇` of all hinges by value; see
    /// [`accelerations_into`](Self::accelerations_into).
    ///
    /// # Errors
    ///
    /// As [`accelerations_into`](Self::accelerations_into).
    #[inline]
    pub fn accelerations(
        &self,
        state_: &TwoPinsState<T>,
        inputs_: &TwoPinsInputs<T>,
    ) -> ::core::result::Result<::mstmm::nalgebra::SVector<T, 2>, ::mstmm::Error> {
        let mut accelerations_ = ::mstmm::generated::vector([T::constant(0.0); 2]);
        self.accelerations_into(state_, inputs_, &mut accelerations_)?;
        ::core::result::Result::Ok(accelerations_)
    }
    /// Writes into `at`: accelerations, efforts, energies and, at every connection point, the state vector `z`.
    ///
    /// 160 operations: 89 mul, 66 add, 3 reciprocal, 2 square root, 2 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `shoulder` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 2 |
    /// | Boundary solve at the far end | \[P, Eqs. (9) to (11)\] | 55 | 39 | 3 | 2 | 0 |
    /// | Transfer to `elbow` | \[P, Eqs. (8), (21)\] with the conditions \[P, Eqs. (25), (35)\] of this hinge | 7 | 5 | 0 | 0 | 0 |
    /// | Motion across `elbow` | \[P, Eqs. (1), (13), (36)\] | 1 | 1 | 0 | 0 | 0 |
    /// | Transfer to `shoulder` | \[P, Eqs. (8), (21)\] with the conditions \[P, Eqs. (25), (35)\] of this hinge | 2 | 0 | 0 | 0 | 0 |
    /// | Back to `shoulder` | \[P, Eqs. (8), (11)\] | 3 | 2 | 0 | 0 | 0 |
    /// | Load on `shoulder` | \[P, Eqs. (18), (19)\] | 8 | 11 | 0 | 0 | 0 |
    /// | Results |  | 6 | 3 | 0 | 0 | 0 |
    /// | Pose behind `elbow` | \[P, Eq. (12)\] | 4 | 2 | 0 | 0 | 0 |
    /// | Inertia beyond the hinges, to be divided by | the pivots of the Riccati transfer | 2 | 1 | 0 | 0 | 0 |
    /// | Velocity behind `elbow` |  | 1 | 0 | 0 | 0 | 0 |
    /// | Connection points | \[P, Eqs. (4), (12), (13)\] | 0 | 2 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// As [`accelerations_into`](Self::accelerations_into); `at` is then as
    /// [`workspace`](Self::workspace) makes it: results of earlier calls are gone.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn solve_into(
        &self,
        state_: &TwoPinsState<T>,
        inputs_: &TwoPinsInputs<T>,
        at_: &mut TwoPinsWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let [_, _, _, n3_, n4_, _, n6_, n7_, _, n9_, n10_, _, _, _, _, n15_, n16_, _, _,
        _, n20_, n21_, n22_, _, n24_, n25_, _, n27_, n28_, _, n30_, n31_, _, _, _, n35_,
        n36_, n37_, _] = &mut at_.numbers;
        let c_ = T::constant;
        let [[shoulder_angle_, elbow_angle_]] = state_.q.data.0;
        let [[shoulder_rate_, elbow_rate_]] = state_.v.data.0;
        at_.efforts.data.0 = [[c_(0.0), c_(0.0)]];
        /// Motion across `shoulder`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 2 sin/cos.
        let (
            [sin_shoulder_angle_,
            sin_elbow_angle_,
            ],
            [cos_shoulder_angle_,
            cos_elbow_angle_,
            ],
        ) = T::sin_cos([shoulder_angle_, elbow_angle_]);
        *n7_ = sin_shoulder_angle_;
        *n9_ = -sin_shoulder_angle_;
        *n6_ = cos_shoulder_angle_;
        *n10_ = cos_shoulder_angle_;
        ::mstmm::generated::written();
        /// Boundary solve at the far end, [P, Eqs. (9) to (11)]: 55 mul, 39 add, 3 reciprocal, 2 square root.
        let t21_ = T::mul_add(
            sin_elbow_angle_,
            c_(0.48639392383214375),
            sin_elbow_angle_,
        );
        let t17_ = cos_elbow_angle_ * cos_elbow_angle_;
        let t22_ = T::mul_sub(sin_elbow_angle_, c_(0.17120202538928544), t21_);
        let t26_ = T::mul_add(t22_, t22_, t17_);
        let t27_ = T::sqrt(t26_);
        let t28_ = T::copysign(t27_, cos_elbow_angle_);
        let t29_ = cos_elbow_angle_ + t28_;
        let t23_ = T::mul_add(cos_elbow_angle_, c_(0.5), c_(0.4931969619160719));
        let t30_ = t28_ * t29_;
        /// Transfer to `elbow`, [P, Eqs. (8), (21)] with the conditions [P, Eqs. (25), (35)] of this hinge: 7 mul, 5 add, 0 reciprocal.
        let elbow_a4_lin_y_ = T::mul_neg_add(
            cos_elbow_angle_,
            c_(0.013606076167856269),
            cos_elbow_angle_,
        );
        /// Boundary solve at the far end.
        let t24_ = T::mul_sub(cos_elbow_angle_, c_(0.17120202538928544), t23_);
        let t31_ = T::recip(t30_);
        let t25_ = elbow_a4_lin_y_ - t24_;
        let t33_ = t22_ * t25_;
        let t34_ = T::mul_add(sin_elbow_angle_, t29_, t33_);
        let t35_ = t31_ * t34_;
        let t37_ = T::mul_neg_add(t22_, t35_, t25_);
        let t45_ = T::mul_add(t37_, t37_, c_(0.25));
        let t46_ = T::sqrt(t45_);
        /// Motion across `elbow`, [P, Eqs. (1), (13), (36)]: 1 mul, 1 add, 0 reciprocal.
        let elbow_omega_z_ = shoulder_rate_ + elbow_rate_;
        /// Boundary solve at the far end.
        let t47_ = T::copysign(t46_, -t37_);
        let t8_ = elbow_omega_z_ * elbow_omega_z_;
        let t48_ = t37_ - t47_;
        /// Motion across `elbow`.
        let minus_elbow_centripetal_x_ = shoulder_rate_ * shoulder_rate_;
        /// Boundary solve at the far end.
        let t16_ = T::mul_add(c_(0.5), elbow_a4_lin_y_, c_(0.3287979746107146));
        /// Transfer to `shoulder`, [P, Eqs. (8), (21)] with the conditions [P, Eqs. (25), (35)] of this hinge: 2 mul, 0 add, 0 reciprocal.
        let shoulder_a_lin_x_ = sin_shoulder_angle_ * c_(9.8);
        *n15_ = shoulder_a_lin_x_;
        ::mstmm::generated::written();
        /// Boundary solve at the far end.
        let t49_ = t47_ * t48_;
        let t9_ = c_(0.5) * t8_;
        /// Transfer to `shoulder`.
        let shoulder_a_lin_y_ = cos_shoulder_angle_ * c_(9.8);
        *n16_ = shoulder_a_lin_y_;
        ::mstmm::generated::written();
        /// Boundary solve at the far end.
        let t41_ = t16_ * t22_;
        let t10_ = T::mul_sub(minus_elbow_centripetal_x_, c_(0.5), shoulder_a_lin_x_);
        let t50_ = T::recip(t49_);
        let t12_ = sin_elbow_angle_ * shoulder_a_lin_y_;
        let t42_ = t31_ * t41_;
        let t57_ = T::mul_add(cos_elbow_angle_, t10_, t9_);
        /// Transfer to `elbow`.
        let t3_ = cos_elbow_angle_ * shoulder_a_lin_y_;
        let t1_ = minus_elbow_centripetal_x_ - shoulder_a_lin_x_;
        /// Boundary solve at the far end.
        let t44_ = T::mul_neg_add(t22_, t42_, t16_);
        let t58_ = t12_ - t57_;
        let t19_ = T::mul_neg_add(
            sin_elbow_angle_,
            c_(0.16439898730535732),
            sin_elbow_angle_,
        );
        /// Transfer to `elbow`.
        let t5_ = T::mul_neg_add(cos_shoulder_angle_, c_(4.9), shoulder_a_lin_y_);
        /// Boundary solve at the far end.
        let t11_ = cos_elbow_angle_ * t1_;
        let t13_ = T::mul_add(sin_elbow_angle_, t10_, t3_);
        /// Transfer to `elbow`.
        let t2_ = sin_elbow_angle_ * t1_;
        /// Boundary solve at the far end.
        let t59_ = t12_ + t58_;
        let t52_ = T::mul_add(t44_, t48_, c_(0.16666666666666666));
        let t20_ = T::mul_sub(sin_elbow_angle_, c_(2.0685934174848226), t19_);
        /// Transfer to `elbow`.
        let t6_ = t5_ * c_(0.9863939238321437);
        let t7_ = cos_elbow_angle_ * c_(0.16439898730535732);
        /// Boundary solve at the far end.
        let t18_ = T::mul_neg_add(
            cos_elbow_angle_,
            c_(2.0685934174848226),
            cos_elbow_angle_,
        );
        let t60_ = t11_ - t59_;
        let t38_ = T::mul_neg_add(t5_, c_(0.0810810810810811), t13_);
        /// Transfer to `elbow`.
        let t4_ = t2_ + t3_;
        /// Boundary solve at the far end.
        let t53_ = t50_ * t52_;
        let t61_ = T::mul_add(t6_, t20_, t60_);
        let t32_ = t29_ * t31_;
        /// Transfer to `elbow`.
        let elbow_a_lin_y_ = T::mul_neg_add(t6_, t7_, t4_);
        /// Boundary solve at the far end.
        let t39_ = T::mul_add(t6_, t18_, t38_);
        let t55_ = T::mul_add(c_(0.5), t53_, c_(0.3333333333333333));
        let t14_ = t5_ * c_(0.054054054054054064);
        let t36_ = T::mul_neg_add(t29_, t35_, sin_elbow_angle_);
        let t62_ = t32_ * t61_;
        let t40_ = elbow_a_lin_y_ + t39_;
        let t56_ = T::recip(t55_);
        let t15_ = T::mul_sub(c_(0.5), elbow_a_lin_y_, t14_);
        let t43_ = t29_ * t42_;
        let t63_ = T::mul_add(t36_, t62_, t40_);
        let t51_ = t48_ * t50_;
        let t65_ = T::mul_neg_add(t43_, t62_, t15_);
        let t54_ = T::mul_add(t48_, t53_, t44_);
        let t64_ = t51_ * t63_;
        let t66_ = T::mul_sub(t54_, t64_, t65_);
        let t68_ = t48_ * t64_;
        let t67_ = t56_ * t66_;
        let t69_ = T::mul_neg_add(c_(0.5), t67_, t68_);
        let t70_ = t50_ * t69_;
        let t72_ = t29_ * t62_;
        let t71_ = T::mul_add(t48_, t70_, t64_);
        let t73_ = T::mul_neg_add(t22_, t71_, t72_);
        let t74_ = t31_ * t73_;
        /// Back to `shoulder`, [P, Eqs. (8), (11)]: 3 mul, 2 add, 0 reciprocal.
        let t75_ = t5_ * c_(1.9863939238321437);
        /// Boundary solve at the far end.
        let minus_end_x4_ = T::mul_add(t22_, t74_, t71_);
        /// Back to `shoulder`.
        let t76_ = T::mul_neg_add(c_(0.16666666666666669), minus_end_x4_, t75_);
        let minus_shoulder_beta0_ = T::mul_add(
            c_(0.0816364570071376),
            t76_,
            minus_end_x4_,
        );
        *n20_ = -minus_shoulder_beta0_;
        ::mstmm::generated::written();
        /// Boundary solve at the far end.
        let end_x5_ = T::mul_neg_add(c_(0.5), t70_, t67_);
        at_.accelerations.data.0 = [[-minus_shoulder_beta0_, end_x5_]];
        ::mstmm::generated::written();
        /// Load on `shoulder`, [P, Eqs. (18), (19)]: 8 mul, 11 add, 0 reciprocal.
        let t77_ = shoulder_a_lin_y_ - minus_shoulder_beta0_;
        let point2_felt_y_ = T::mul_add(cos_elbow_angle_, t77_, t2_);
        *n22_ = point2_felt_y_;
        ::mstmm::generated::written();
        let t78_ = end_x5_ - minus_shoulder_beta0_;
        *n35_ = t78_;
        ::mstmm::generated::written();
        /// Results: 6 mul, 3 add, 0 reciprocal.
        let t84_ = minus_elbow_centripetal_x_ * c_(0.6666666666666666);
        /// Pose behind `elbow`, [P, Eq. (12)]: 4 mul, 2 add, 0 reciprocal.
        let t83_ = cos_shoulder_angle_ * sin_elbow_angle_;
        /// Load on `shoulder`.
        let elbow_load_fy_ = T::mul_add(c_(0.5), t78_, point2_felt_y_);
        *n31_ = elbow_load_fy_;
        ::mstmm::generated::written();
        let t80_ = T::mul_neg_add(c_(0.5), minus_shoulder_beta0_, shoulder_a_lin_y_);
        let minus_point2_felt_x_ = T::mul_neg_add(sin_elbow_angle_, t77_, t11_);
        *n21_ = -minus_point2_felt_x_;
        ::mstmm::generated::written();
        /// Results.
        let t85_ = elbow_omega_z_ * c_(0.5);
        let t86_ = T::mul_add(t8_, c_(0.16666666666666666), t84_);
        /// Inertia beyond the hinges, to be divided by, the pivots of the Riccati transfer: 2 mul, 1 add, 0 reciprocal.
        let t0_ = sin_elbow_angle_ * sin_elbow_angle_;
        /// Pose behind `elbow`.
        let t82_ = cos_shoulder_angle_ * cos_elbow_angle_;
        /// Velocity behind `elbow`: 1 mul, 0 add, 0 reciprocal.
        let elbow_velocity_y_ = shoulder_rate_ * cos_elbow_angle_;
        /// Results.
        let t88_ = sin_shoulder_angle_ * c_(14.700000000000001);
        /// Pose behind `elbow`.
        let minus_elbow_to_inertial_xy_ = T::mul_add(
            sin_shoulder_angle_,
            cos_elbow_angle_,
            t83_,
        );
        *n25_ = minus_elbow_to_inertial_xy_;
        *n27_ = -minus_elbow_to_inertial_xy_;
        ::mstmm::generated::written();
        /// Load on `shoulder`.
        let t79_ = T::mul_add(sin_elbow_angle_, elbow_load_fy_, t10_);
        let t81_ = T::mul_add(cos_elbow_angle_, elbow_load_fy_, t80_);
        let minus_elbow_load_fx_ = t9_ + minus_point2_felt_x_;
        *n30_ = -minus_elbow_load_fx_;
        ::mstmm::generated::written();
        /// Inertia beyond the hinges, to be divided by.
        let shoulder_d_ = T::mul_add(t0_, c_(0.75), c_(0.5833333333333333));
        if !::mstmm::generated::regular::<
            T,
            _,
            _,
        >(
            [shoulder_d_],
            [c_(2.9266666666666667)],
            [state_.t, -minus_shoulder_beta0_, end_x5_],
        ) {
            let error_ = ::mstmm::generated::irregular::<
                T,
                _,
            >(&["shoulder"], [shoulder_d_], [c_(2.9266666666666667)]);
            ::mstmm::generated::take_back(at_, || self.workspace());
            return ::core::result::Result::Err(error_);
        }
        ::mstmm::generated::written();
        /// Pose behind `elbow`.
        let elbow_to_inertial_xx_ = T::mul_neg_add(
            sin_shoulder_angle_,
            sin_elbow_angle_,
            t82_,
        );
        *n24_ = elbow_to_inertial_xx_;
        *n28_ = elbow_to_inertial_xx_;
        ::mstmm::generated::written();
        /// Results.
        let t87_ = T::mul_add(elbow_velocity_y_, t85_, t86_);
        at_.kinetic_energy = t87_;
        ::mstmm::generated::written();
        let t89_ = T::mul_add(c_(4.9), minus_elbow_to_inertial_xy_, t88_);
        at_.potential_energy = t89_;
        ::mstmm::generated::written();
        /// Load on `shoulder`.
        let minus_shoulder_load_fx_ = T::mul_add(
            cos_elbow_angle_,
            minus_elbow_load_fx_,
            t79_,
        );
        *n3_ = -minus_shoulder_load_fx_;
        ::mstmm::generated::written();
        let minus_shoulder_load_fy_ = T::mul_sub(
            sin_elbow_angle_,
            minus_elbow_load_fx_,
            t81_,
        );
        *n4_ = -minus_shoulder_load_fy_;
        ::mstmm::generated::written();
        /// Connection points, [P, Eqs. (4), (12), (13)]: 0 mul, 2 add, 0 reciprocal.
        let minus_point4_felt_x_ = t8_ + minus_point2_felt_x_;
        *n36_ = -minus_point4_felt_x_;
        ::mstmm::generated::written();
        let point4_felt_y_ = point2_felt_y_ + t78_;
        *n37_ = point4_felt_y_;
        ::mstmm::generated::written();
        ::core::result::Result::Ok(())
    }
    /// Kinetic and potential energy in J; the potential of gravity is zero with every centre
    /// of mass at the inertial origin.
    ///
    /// 16 operations: 11 mul, 5 add, 0 reciprocal, 2 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `shoulder` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 2 |
    /// | Motion across `elbow` | \[P, Eqs. (1), (13), (36)\] | 1 | 1 | 0 | 0 | 0 |
    /// | Results |  | 10 | 4 | 0 | 0 | 0 |
    #[must_use]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn energy(&self, state_: &TwoPinsState<T>) -> ::mstmm::Energy<T> {
        let c_ = T::constant;
        let [[shoulder_angle_, elbow_angle_]] = state_.q.data.0;
        let [[shoulder_rate_, elbow_rate_]] = state_.v.data.0;
        /// Motion across `shoulder`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 2 sin/cos.
        let (
            [sin_shoulder_angle_,
            sin_elbow_angle_,
            ],
            [cos_shoulder_angle_,
            cos_elbow_angle_,
            ],
        ) = T::sin_cos([shoulder_angle_, elbow_angle_]);
        /// Motion across `elbow`, [P, Eqs. (1), (13), (36)]: 1 mul, 1 add, 0 reciprocal.
        let elbow_omega_z_ = shoulder_rate_ + elbow_rate_;
        let minus_elbow_centripetal_x_ = shoulder_rate_ * shoulder_rate_;
        /// Results: 10 mul, 4 add, 0 reciprocal.
        let t0_ = elbow_omega_z_ * elbow_omega_z_;
        let t1_ = shoulder_rate_ * cos_elbow_angle_;
        let t2_ = minus_elbow_centripetal_x_ * c_(0.6666666666666666);
        let t3_ = elbow_omega_z_ * c_(0.5);
        let t4_ = T::mul_add(t0_, c_(0.16666666666666666), t2_);
        let t5_ = T::mul_add(t1_, t3_, t4_);
        let t6_ = cos_shoulder_angle_ * sin_elbow_angle_;
        let t7_ = T::mul_add(sin_shoulder_angle_, cos_elbow_angle_, t6_);
        let t8_ = sin_shoulder_angle_ * c_(14.700000000000001);
        let t9_ = T::mul_add(c_(4.9), t7_, t8_);
        ::mstmm::Energy {
            kinetic: t5_,
            potential: t9_,
        }
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::Chain for TwoPins<T> {
    type Scalar = T;
    type State = TwoPinsState<T>;
    type Inputs = TwoPinsInputs<T>;
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn derivative_into(
        &self,
        state_: &TwoPinsState<T>,
        inputs_: &TwoPinsInputs<T>,
        rate_: &mut TwoPinsState<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.accelerations_into(state_, inputs_, &mut rate_.v)?;
        self.configuration_rate_into(state_, rate_);
        ::core::result::Result::Ok(())
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn configuration_rate_into(
        &self,
        state_: &TwoPinsState<T>,
        rate_: &mut TwoPinsState<T>,
    ) {
        rate_.q.data.0 = {
            let [[shoulder_rate_, elbow_rate_]] = state_.v.data.0;
            [[shoulder_rate_, elbow_rate_]]
        };
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn normalize(&self, state_: &mut TwoPinsState<T>) {
        state_.q.data.0 = {
            let [[shoulder_angle_, elbow_angle_]] = state_.q.data.0;
            [[shoulder_angle_, elbow_angle_]]
        };
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::GeneratedChain for TwoPins<T> {
    type Workspace = TwoPinsWorkspace<T>;
    #[inline]
    fn initial_state(&self) -> TwoPinsState<T> {
        self.initial_state()
    }
    #[inline]
    fn no_inputs(&self) -> TwoPinsInputs<T> {
        self.no_inputs()
    }
    #[inline]
    fn workspace(&self) -> TwoPinsWorkspace<T> {
        self.workspace()
    }
    #[inline]
    fn solve_into(
        &self,
        state_: &TwoPinsState<T>,
        inputs_: &TwoPinsInputs<T>,
        at_: &mut TwoPinsWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.solve_into(state_, inputs_, at_)
    }
    #[inline]
    fn energy(&self, state_: &TwoPinsState<T>) -> ::mstmm::Energy<T> {
        self.energy(state_)
    }
}
/// Coordinates and rates of [`TwoPins`] at a time.
///
/// The hinges lie one after the other in the order of the route. A body that floats comes
/// first; a hinge whose motion is prescribed has no place.
///
/// | of | places in `q` | places in `v` |
/// |---|---|---|
/// | `shoulder` | 0 | 0 |
/// | `elbow` | 1 | 1 |
///
/// [`Default`] is every hinge at rest in its zero position.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct TwoPinsState<T> {
    /// Coordinates: angles in rad, lengths in m, unit quaternions as w, x, y, z.
    pub q: ::mstmm::nalgebra::SVector<T, 2>,
    /// Rates in rad/s and m/s.
    pub v: ::mstmm::nalgebra::SVector<T, 2>,
    /// Time in s.
    pub t: T,
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TwoPinsState<T> {
    /// Coordinates and rates of hinge `shoulder`.
    #[inline]
    #[must_use]
    pub fn shoulder(&self) -> ::mstmm::PinState<T> {
        let [[q0_, ..]] = self.q.data.0;
        let [[v0_, ..]] = self.v.data.0;
        ::mstmm::PinState::new(q0_, v0_)
    }
    /// Coordinates and rates of hinge `shoulder`, to be changed.
    #[inline]
    pub fn shoulder_mut(&mut self) -> ::mstmm::PinStateMut<'_, T> {
        let [[q0_, ..]] = &mut self.q.data.0;
        let [[v0_, ..]] = &mut self.v.data.0;
        ::mstmm::PinStateMut::new(q0_, v0_)
    }
    /// Coordinates and rates of hinge `elbow`.
    #[inline]
    #[must_use]
    pub fn elbow(&self) -> ::mstmm::PinState<T> {
        let [[_, q1_, ..]] = self.q.data.0;
        let [[_, v1_, ..]] = self.v.data.0;
        ::mstmm::PinState::new(q1_, v1_)
    }
    /// Coordinates and rates of hinge `elbow`, to be changed.
    #[inline]
    pub fn elbow_mut(&mut self) -> ::mstmm::PinStateMut<'_, T> {
        let [[_, q1_, ..]] = &mut self.q.data.0;
        let [[_, v1_, ..]] = &mut self.v.data.0;
        ::mstmm::PinStateMut::new(q1_, v1_)
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for TwoPinsState<T> {
    fn default() -> Self {
        let (zero_, one_) = (T::constant(0.0), T::constant(1.0));
        let _ = one_;
        Self {
            q: ::mstmm::generated::vector([zero_, zero_]),
            v: ::mstmm::generated::vector([zero_; 2]),
            t: zero_,
        }
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::ChainState for TwoPinsState<T> {
    type Scalar = T;
    #[inline]
    fn q(&self) -> &[T] {
        self.q.as_slice()
    }
    #[inline]
    fn q_mut(&mut self) -> &mut [T] {
        self.q.as_mut_slice()
    }
    #[inline]
    fn v(&self) -> &[T] {
        self.v.as_slice()
    }
    #[inline]
    fn v_mut(&mut self) -> &mut [T] {
        self.v.as_mut_slice()
    }
    #[inline]
    fn time(&self) -> T {
        self.t
    }
    #[inline]
    fn set_time(&mut self, time_: T) {
        self.t = time_;
    }
}
/// What drives [`TwoPins`] from outside, given at every step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct TwoPinsInputs<T> {
    none: ::core::marker::PhantomData<T>,
}
impl<T: ::mstmm::Scalar> ::core::default::Default for TwoPinsInputs<T> {
    #[inline]
    fn default() -> Self {
        Self {
            none: ::core::marker::PhantomData,
        }
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TwoPins<T> {
    /// Inputs that are all zero; prescribed motions rest in the zero position.
    #[inline]
    #[must_use]
    pub fn no_inputs(&self) -> TwoPinsInputs<T> {
        ::core::default::Default::default()
    }
}
/// Results of [`TwoPins::solve_into`]: accelerations, efforts, energies and, at every connection point, the state vector `z`.
#[derive(Clone, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct TwoPinsWorkspace<T> {
    accelerations: ::mstmm::nalgebra::SVector<T, 2>,
    efforts: ::mstmm::nalgebra::SVector<T, 2>,
    kinetic_energy: T,
    potential_energy: T,
    numbers: [T; 39],
    at_rest: [T; 3],
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TwoPinsWorkspace<T> {
    /// Accelerations `v̇` of all hinges, in the order of `v` of the state.
    #[inline]
    pub fn accelerations(&self) -> &::mstmm::nalgebra::SVector<T, 2> {
        &self.accelerations
    }
    /// Kinetic energy in J.
    #[inline]
    pub fn kinetic_energy(&self) -> T {
        self.kinetic_energy
    }
    /// Potential energy in J: of gravity, zero with every centre of mass at the inertial
    /// origin, and of springs.
    #[inline]
    pub fn potential_energy(&self) -> T {
        self.potential_energy
    }
    /// All connection points in the order of the route: the input of the first element, then the
    /// output of every element, which is the input of the next one.
    #[inline]
    pub fn points(
        &self,
    ) -> [::mstmm::Point<T, ::mstmm::Results<false, false, true>>; 5] {
        [self.point_(0), self.point_(1), self.point_(2), self.point_(3), self.point_(4)]
    }
    /// Where every point of the model has its numbers.
    const PLACES_: [::mstmm::generated::Places<3, 6>; 5] = [
        ::mstmm::generated::Places::new(
            0,
            [0, 0, 0],
            [
                ([0, 0, 0], 0),
                ([0, 0, 0], 0),
                ([0, 0, 0], 1),
                ([0, 0, 0], 0),
                ([0, 0, 0], 0),
                ([7, 10, 13], 4),
            ],
        ),
        ::mstmm::generated::Places::new(
            0,
            [0, 0, 0],
            [
                ([0, 0, 0], 0),
                ([0, 0, 0], 0),
                ([7, 10, 13], 16),
                ([7, 10, 13], 19),
                ([0, 0, 0], 0),
                ([7, 10, 13], 4),
            ],
        ),
        ::mstmm::generated::Places::new(
            0,
            [0, 0, 0],
            [
                ([0, 0, 0], 0),
                ([0, 0, 0], 0),
                ([25, 28, 13], 22),
                ([7, 10, 13], 19),
                ([0, 0, 0], 0),
                ([25, 28, 13], 31),
            ],
        ),
        ::mstmm::generated::Places::new(
            0,
            [0, 0, 0],
            [
                ([0, 0, 0], 0),
                ([0, 0, 0], 0),
                ([25, 28, 13], 22),
                ([25, 28, 13], 34),
                ([0, 0, 0], 0),
                ([25, 28, 13], 31),
            ],
        ),
        ::mstmm::generated::Places::new(
            0,
            [0, 0, 0],
            [
                ([0, 0, 0], 0),
                ([0, 0, 0], 0),
                ([25, 28, 13], 37),
                ([25, 28, 13], 34),
                ([0, 0, 0], 0),
                ([0, 0, 0], 0),
            ],
        ),
    ];
    /// Connection point number `index`.
    #[inline(always)]
    fn point_(
        &self,
        index_: ::core::primitive::usize,
    ) -> ::mstmm::Point<T, ::mstmm::Results<false, false, true>> {
        let (model_, numbers_) = (index_, &self.numbers[..]);
        <::mstmm::Point<
            T,
            ::mstmm::Results<false, false, true>,
        >>::read(numbers_, Self::PLACES_.get(model_), self.at_rest)
    }
    /// Acceleration, effort, input and output of hinge `shoulder`.
    #[inline]
    pub fn shoulder(
        &self,
    ) -> ::mstmm::HingeResult<
        T,
        T,
        ::mstmm::Point<T, ::mstmm::Results<false, false, true>>,
    > {
        let (input_, output_) = (self.point_(0), self.point_(1));
        ::mstmm::HingeResult::new(
            {
                let [value_] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.accelerations.as_slice(), 0);
                value_
            },
            {
                let [value_] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.efforts.as_slice(), 0);
                value_
            },
            input_,
            output_,
        )
    }
    /// Results at body `upper`: input, output and centre of mass.
    #[inline]
    pub fn upper(
        &self,
    ) -> ::mstmm::BodyResult<
        T,
        ::mstmm::Point<T, ::mstmm::Results<false, false, true>>,
    > {
        let (input_, output_) = (self.point_(1), self.point_(2));
        ::mstmm::BodyResult::new(
            input_,
            output_,
            [T::constant(0.5f64), T::constant(0f64), T::constant(0f64)],
        )
    }
    /// Acceleration, effort, input and output of hinge `elbow`.
    #[inline]
    pub fn elbow(
        &self,
    ) -> ::mstmm::HingeResult<
        T,
        T,
        ::mstmm::Point<T, ::mstmm::Results<false, false, true>>,
    > {
        let (input_, output_) = (self.point_(2), self.point_(3));
        ::mstmm::HingeResult::new(
            {
                let [value_] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.accelerations.as_slice(), 1);
                value_
            },
            {
                let [value_] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.efforts.as_slice(), 1);
                value_
            },
            input_,
            output_,
        )
    }
    /// Results at body `lower`: input, output and centre of mass.
    #[inline]
    pub fn lower(
        &self,
    ) -> ::mstmm::BodyResult<
        T,
        ::mstmm::Point<T, ::mstmm::Results<false, false, true>>,
    > {
        let (input_, output_) = (self.point_(3), self.point_(4));
        ::mstmm::BodyResult::new(
            input_,
            output_,
            [T::constant(0.5f64), T::constant(0f64), T::constant(0f64)],
        )
    }
}
impl<T: ::mstmm::Scalar> ::core::fmt::Debug for TwoPinsWorkspace<T> {
    fn fmt(&self, to_: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
        to_.debug_struct("TwoPinsWorkspace")
            .field("accelerations", &self.accelerations)
            .field("efforts", &self.efforts)
            .field("kinetic_energy", &self.kinetic_energy)
            .field("potential_energy", &self.potential_energy)
            .field("points", &self.points())
            .finish()
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TwoPins<T> {
    /// Room for the results of [`solve_into`](Self::solve_into), which mean nothing before.
    #[must_use]
    #[allow(clippy::all)]
    pub fn workspace(&self) -> TwoPinsWorkspace<T> {
        let zero_ = T::constant(0.0);
        TwoPinsWorkspace {
            accelerations: ::mstmm::generated::vector([zero_; 2]),
            efforts: ::mstmm::generated::vector([zero_; 2]),
            kinetic_energy: zero_,
            potential_energy: zero_,
            numbers: {
                let c_ = T::constant;
                ::mstmm::generated::with_known(
                    [T::constant(0.0); 39],
                    &[(1, c_(9.8)), (14, c_(1.0))],
                )
            },
            at_rest: {
                let c_ = T::constant;
                ::mstmm::generated::with_known([T::constant(0.0); 3], &[(1, c_(9.8))])
            },
        }
    }
}
#[allow(dead_code, non_camel_case_types, clippy::all)]
const _: () = {
    struct Rod;
    const _: Rod = Rod;
    const _: Rod = Rod;
};
