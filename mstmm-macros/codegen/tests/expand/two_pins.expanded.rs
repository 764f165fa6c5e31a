/// Two rods in a plane, by the forward product.
///
/// # The chain
///
/// `ground -> pin shoulder -> upper -> pin elbow -> lower`
///
/// <svg role="img" aria-label="The chain at its start" viewBox="0 0 472 303" width="472" style="max-width:100%;height:auto" font-size="12" stroke-linecap="round" fill="currentColor">
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
/// Accelerations by `transfer`, 130 operations (75 mul, 50 add, 3 reciprocal, 2 square root, 2 sin/cos); with everything at every connection point 213 operations.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct TwoPins<T> {
    parameters: TwoPinsParameters<T>,
    derived: [T; 0],
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
        let (chain_, _) = Self::derive(parameters_);
        chain_
    }
    /// The numbers that may change at run time.
    #[inline]
    pub fn parameters(&self) -> &TwoPinsParameters<T> {
        &self.parameters
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
    fn derive(parameters_: TwoPinsParameters<T>) -> (Self, [T; 0]) {
        let (derived_, checks_) = ([], []);
        (
            Self {
                parameters: parameters_,
                derived: derived_,
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
    /// The accelerations `v̇` of all hinges, in the order of the rates: the fast path.
    ///
    /// 130 operations: 75 mul, 50 add, 3 reciprocal, 2 square root, 2 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `shoulder` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 2 |
    /// | Motion across `elbow` | \[P, Eqs. (1), (13), (36)\] | 3 | 1 | 0 | 0 | 0 |
    /// | Inertia beyond the hinges, to be divided by | the pivots of the Riccati transfer | 2 | 1 | 0 | 0 | 0 |
    /// | Transfer to `shoulder` | \[P, Eqs. (8), (21)\] with the conditions \[P, Eqs. (25), (35)\] of this hinge | 2 | 0 | 0 | 0 | 0 |
    /// | Transfer to `elbow` | \[P, Eqs. (8), (21)\] with the conditions \[P, Eqs. (25), (35)\] of this hinge | 24 | 18 | 0 | 0 | 0 |
    /// | Boundary solve at the far end | \[P, Eqs. (9) to (11)\] | 41 | 28 | 3 | 2 | 0 |
    /// | Back to `shoulder` | \[P, Eqs. (8), (11)\] | 3 | 2 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// `Error::Singular` if nothing with inertia lies beyond a
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
        /// Motion across `elbow`, [P, Eqs. (1), (13), (36)]: 3 mul, 1 add, 0 reciprocal.
        let elbow_omega_z_ = shoulder_rate_ + elbow_rate_;
        let t0_ = shoulder_rate_ * shoulder_rate_;
        let minus_elbow_drift_lin_x_ = cos_elbow_angle_ * t0_;
        let elbow_drift_lin_y_ = sin_elbow_angle_ * t0_;
        /// Inertia beyond the hinges, to be divided by, the pivots of the Riccati transfer: 2 mul, 1 add, 0 reciprocal.
        let t1_ = sin_elbow_angle_ * c_(0.75);
        let t2_ = sin_elbow_angle_ * t1_;
        let shoulder_d_ = t2_ + c_(0.5833333333333333);
        /// Transfer to `shoulder`, [P, Eqs. (8), (21)] with the conditions [P, Eqs. (25), (35)] of this hinge: 2 mul, 0 add, 0 reciprocal.
        let shoulder_a_lin_x_ = sin_shoulder_angle_ * c_(9.8);
        let shoulder_a_lin_y_ = cos_shoulder_angle_ * c_(9.8);
        /// Transfer to `elbow`, [P, Eqs. (8), (21)] with the conditions [P, Eqs. (25), (35)] of this hinge: 24 mul, 18 add, 0 reciprocal.
        let t3_ = sin_elbow_angle_ * c_(0.013606076167856269);
        let elbow_a4_lin_x_ = sin_elbow_angle_ - t3_;
        let t4_ = cos_elbow_angle_ * c_(0.013606076167856269);
        let elbow_a4_lin_y_ = cos_elbow_angle_ - t4_;
        let t5_ = sin_elbow_angle_ * c_(0.5);
        let t6_ = sin_elbow_angle_ * c_(0.17120202538928544);
        let minus_elbow_f4_force_x_ = t5_ - t6_;
        let t7_ = cos_elbow_angle_ * c_(0.5);
        let t8_ = cos_elbow_angle_ * c_(0.17120202538928544);
        let minus_elbow_f4_force_y_ = t7_ - t8_;
        let t9_ = cos_shoulder_angle_ * c_(4.9);
        let t10_ = cos_elbow_angle_ * shoulder_a_lin_x_;
        let t11_ = sin_elbow_angle_ * shoulder_a_lin_y_;
        let t12_ = t10_ + t11_;
        let t13_ = shoulder_a_lin_y_ - t9_;
        let t14_ = minus_elbow_drift_lin_x_ - t12_;
        let t15_ = t13_ * c_(0.9863939238321437);
        let t16_ = sin_elbow_angle_ * c_(0.16439898730535732);
        let t17_ = t15_ * t16_;
        let minus_elbow_a_lin_x_ = t14_ + t17_;
        let t18_ = sin_elbow_angle_ * shoulder_a_lin_x_;
        let t19_ = cos_elbow_angle_ * shoulder_a_lin_y_;
        let t20_ = t18_ - t19_;
        let t21_ = elbow_drift_lin_y_ - t20_;
        let t22_ = cos_elbow_angle_ * c_(0.16439898730535732);
        let t23_ = t15_ * t22_;
        let elbow_a_lin_y_ = t21_ - t23_;
        let t24_ = shoulder_rate_ * c_(0.5);
        let t25_ = shoulder_rate_ * t24_;
        let t26_ = t25_ - shoulder_a_lin_x_;
        let t27_ = cos_elbow_angle_ * t26_;
        let t28_ = t11_ - t27_;
        let t29_ = sin_elbow_angle_ * c_(2.0685934174848226);
        let t30_ = sin_elbow_angle_ - t29_;
        let t31_ = t15_ * t30_;
        let minus_elbow_f_force_x_ = t28_ + t31_;
        let t32_ = sin_elbow_angle_ * t26_;
        let t33_ = t19_ + t32_;
        let t34_ = cos_elbow_angle_ * c_(2.0685934174848226);
        let t35_ = cos_elbow_angle_ - t34_;
        let t36_ = t15_ * t35_;
        let minus_elbow_f_force_y_ = t33_ + t36_;
        /// Boundary solve at the far end, [P, Eqs. (9) to (11)]: 41 mul, 28 add, 3 reciprocal, 2 square root.
        let t37_ = elbow_omega_z_ * c_(0.5);
        let t38_ = elbow_omega_z_ * t37_;
        let t39_ = t13_ * c_(0.0810810810810811);
        let t40_ = elbow_a_lin_y_ - t39_;
        let t41_ = c_(0.5) * elbow_a_lin_y_;
        let t42_ = t13_ * c_(0.054054054054054064);
        let t43_ = t41_ - t42_;
        let t44_ = elbow_a4_lin_y_ + c_(0.4931969619160719);
        let t45_ = c_(0.5) * elbow_a4_lin_y_;
        let t46_ = t45_ + c_(0.3287979746107146);
        let t47_ = cos_elbow_angle_ * cos_elbow_angle_;
        let t48_ = minus_elbow_a_lin_x_ - minus_elbow_f_force_x_;
        let t49_ = t40_ + minus_elbow_f_force_y_;
        let t50_ = t38_ + t48_;
        let t51_ = elbow_a4_lin_x_ + minus_elbow_f4_force_x_;
        let t52_ = t44_ + minus_elbow_f4_force_y_;
        let t53_ = t51_ * t51_;
        let t54_ = t47_ + t53_;
        let t55_ = T::sqrt(t54_);
        let t56_ = T::copysign(t55_, cos_elbow_angle_);
        let t57_ = cos_elbow_angle_ + t56_;
        let t58_ = t56_ * t57_;
        let t59_ = T::recip(t58_);
        let t60_ = t57_ * t59_;
        let t61_ = t50_ * t60_;
        let t62_ = sin_elbow_angle_ * t57_;
        let t63_ = t51_ * t52_;
        let t64_ = t62_ - t63_;
        let t65_ = t59_ * t64_;
        let t66_ = t57_ * t65_;
        let t67_ = sin_elbow_angle_ - t66_;
        let t68_ = t51_ * t65_;
        let t69_ = t52_ + t68_;
        let t70_ = t61_ * t67_;
        let t71_ = t49_ + t70_;
        let t72_ = t46_ * t51_;
        let t73_ = t59_ * t72_;
        let t74_ = t57_ * t73_;
        let t75_ = t51_ * t73_;
        let t76_ = t46_ - t75_;
        let t77_ = t61_ * t74_;
        let t78_ = t43_ + t77_;
        let t79_ = t69_ * t69_;
        let t80_ = c_(0.25) + t79_;
        let t81_ = T::sqrt(t80_);
        let t82_ = T::copysign(t81_, -t69_);
        let t83_ = t69_ - t82_;
        let t84_ = t82_ * t83_;
        let t85_ = T::recip(t84_);
        let t86_ = t83_ * t85_;
        let t87_ = t71_ * t86_;
        let t88_ = t76_ * t83_;
        let t89_ = c_(0.16666666666666666) + t88_;
        let t90_ = t85_ * t89_;
        let t91_ = t83_ * t90_;
        let t92_ = t76_ + t91_;
        let t93_ = c_(0.5) * t90_;
        let t94_ = c_(0.3333333333333333) + t93_;
        let t95_ = t87_ * t92_;
        let t96_ = t78_ - t95_;
        let t97_ = T::recip(t94_);
        let t98_ = t96_ * t97_;
        let t99_ = t83_ * t87_;
        let t100_ = c_(0.5) * t98_;
        let t101_ = t99_ + t100_;
        let t102_ = t85_ * t101_;
        let t103_ = t83_ * t102_;
        let t104_ = t87_ + t103_;
        let t105_ = t57_ * t61_;
        let t106_ = t51_ * t104_;
        let t107_ = t105_ + t106_;
        let t108_ = t59_ * t107_;
        let t109_ = t51_ * t108_;
        let minus_end_x4_ = t104_ - t109_;
        let t110_ = c_(0.5) * t102_;
        let minus_end_x5_ = t98_ + t110_;
        /// Back to `shoulder`, [P, Eqs. (8), (11)]: 3 mul, 2 add, 0 reciprocal.
        let t111_ = t13_ * c_(1.9863939238321437);
        let t112_ = c_(0.16666666666666669) * minus_end_x4_;
        let t113_ = t111_ - t112_;
        let t114_ = c_(0.0816364570071376) * t113_;
        let minus_shoulder_beta0_ = minus_end_x4_ + t114_;
        ::mstmm::generated::finite::<
            T,
        >(&[state_.q.as_slice(), state_.v.as_slice(), &[state_.t]])?;
        ::mstmm::generated::regular::<
            T,
            _,
            _,
        >(
            &["shoulder"],
            [shoulder_d_],
            [c_(2.9266666666666667)],
            [-minus_shoulder_beta0_, -minus_end_x5_],
        )?;
        accelerations_.data.0 = [[-minus_shoulder_beta0_, -minus_end_x5_]];
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
    /// Everything: accelerations, efforts, energies and, at every connection point, pose,
    /// velocity and the state vector `z`, written into `at`.
    ///
    /// 213 operations: 122 mul, 86 add, 3 reciprocal, 2 square root, 2 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `shoulder` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 2 |
    /// | Motion across `elbow` | \[P, Eqs. (1), (13), (36)\] | 3 | 1 | 0 | 0 | 0 |
    /// | Inertia beyond the hinges, to be divided by | the pivots of the Riccati transfer | 2 | 1 | 0 | 0 | 0 |
    /// | Transfer to `shoulder` | \[P, Eqs. (8), (21)\] with the conditions \[P, Eqs. (25), (35)\] of this hinge | 2 | 0 | 0 | 0 | 0 |
    /// | Transfer to `elbow` | \[P, Eqs. (8), (21)\] with the conditions \[P, Eqs. (25), (35)\] of this hinge | 24 | 18 | 0 | 0 | 0 |
    /// | Boundary solve at the far end | \[P, Eqs. (9) to (11)\] | 41 | 28 | 3 | 2 | 0 |
    /// | Back to `shoulder` | \[P, Eqs. (8), (11)\] | 3 | 2 | 0 | 0 | 0 |
    /// | Motion across `elbow` | \[P, Eqs. (1), (13), (36)\] | 8 | 2 | 0 | 0 | 0 |
    /// | Point of `elbow` | \[P, Eqs. (12), (13), (36)\] | 2 | 3 | 0 | 0 | 0 |
    /// | Load of the body at `shoulder` | \[P, Eqs. (18), (19)\] | 5 | 3 | 0 | 0 | 0 |
    /// | Load of the body at `elbow` | \[P, Eqs. (18), (19)\] | 7 | 9 | 0 | 0 | 0 |
    /// | Load on `shoulder` | \[P, Eqs. (18), (19)\] | 0 | 2 | 0 | 0 | 0 |
    /// | Results |  | 25 | 17 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// As [`accelerations_into`](Self::accelerations_into); `at` is not touched then.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn solve_into(
        &self,
        state_: &TwoPinsState<T>,
        inputs_: &TwoPinsInputs<T>,
        at_: &mut TwoPinsWorkspace<T>,
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
        /// Motion across `elbow`, [P, Eqs. (1), (13), (36)]: 3 mul, 1 add, 0 reciprocal.
        let elbow_omega_z_ = shoulder_rate_ + elbow_rate_;
        let t0_ = shoulder_rate_ * shoulder_rate_;
        let minus_elbow_drift_lin_x_ = cos_elbow_angle_ * t0_;
        let elbow_drift_lin_y_ = sin_elbow_angle_ * t0_;
        /// Inertia beyond the hinges, to be divided by, the pivots of the Riccati transfer: 2 mul, 1 add, 0 reciprocal.
        let t1_ = sin_elbow_angle_ * c_(0.75);
        let t2_ = sin_elbow_angle_ * t1_;
        let shoulder_d_ = t2_ + c_(0.5833333333333333);
        /// Transfer to `shoulder`, [P, Eqs. (8), (21)] with the conditions [P, Eqs. (25), (35)] of this hinge: 2 mul, 0 add, 0 reciprocal.
        let shoulder_a_lin_x_ = sin_shoulder_angle_ * c_(9.8);
        let shoulder_a_lin_y_ = cos_shoulder_angle_ * c_(9.8);
        /// Transfer to `elbow`, [P, Eqs. (8), (21)] with the conditions [P, Eqs. (25), (35)] of this hinge: 24 mul, 18 add, 0 reciprocal.
        let t3_ = sin_elbow_angle_ * c_(0.013606076167856269);
        let elbow_a4_lin_x_ = sin_elbow_angle_ - t3_;
        let t4_ = cos_elbow_angle_ * c_(0.013606076167856269);
        let elbow_a4_lin_y_ = cos_elbow_angle_ - t4_;
        let t5_ = sin_elbow_angle_ * c_(0.5);
        let t6_ = sin_elbow_angle_ * c_(0.17120202538928544);
        let minus_elbow_f4_force_x_ = t5_ - t6_;
        let t7_ = cos_elbow_angle_ * c_(0.5);
        let t8_ = cos_elbow_angle_ * c_(0.17120202538928544);
        let minus_elbow_f4_force_y_ = t7_ - t8_;
        let t9_ = cos_shoulder_angle_ * c_(4.9);
        let t10_ = cos_elbow_angle_ * shoulder_a_lin_x_;
        let t11_ = sin_elbow_angle_ * shoulder_a_lin_y_;
        let t12_ = t10_ + t11_;
        let t13_ = shoulder_a_lin_y_ - t9_;
        let t14_ = minus_elbow_drift_lin_x_ - t12_;
        let t15_ = t13_ * c_(0.9863939238321437);
        let t16_ = sin_elbow_angle_ * c_(0.16439898730535732);
        let t17_ = t15_ * t16_;
        let minus_elbow_a_lin_x_ = t14_ + t17_;
        let t18_ = sin_elbow_angle_ * shoulder_a_lin_x_;
        let t19_ = cos_elbow_angle_ * shoulder_a_lin_y_;
        let t20_ = t18_ - t19_;
        let t21_ = elbow_drift_lin_y_ - t20_;
        let t22_ = cos_elbow_angle_ * c_(0.16439898730535732);
        let t23_ = t15_ * t22_;
        let elbow_a_lin_y_ = t21_ - t23_;
        let t24_ = shoulder_rate_ * c_(0.5);
        let t25_ = shoulder_rate_ * t24_;
        let t26_ = t25_ - shoulder_a_lin_x_;
        let t27_ = cos_elbow_angle_ * t26_;
        let t28_ = t11_ - t27_;
        let t29_ = sin_elbow_angle_ * c_(2.0685934174848226);
        let t30_ = sin_elbow_angle_ - t29_;
        let t31_ = t15_ * t30_;
        let minus_elbow_f_force_x_ = t28_ + t31_;
        let t32_ = sin_elbow_angle_ * t26_;
        let t33_ = t19_ + t32_;
        let t34_ = cos_elbow_angle_ * c_(2.0685934174848226);
        let t35_ = cos_elbow_angle_ - t34_;
        let t36_ = t15_ * t35_;
        let minus_elbow_f_force_y_ = t33_ + t36_;
        /// Boundary solve at the far end, [P, Eqs. (9) to (11)]: 41 mul, 28 add, 3 reciprocal, 2 square root.
        let t37_ = elbow_omega_z_ * c_(0.5);
        let t38_ = elbow_omega_z_ * t37_;
        let t39_ = t13_ * c_(0.0810810810810811);
        let t40_ = elbow_a_lin_y_ - t39_;
        let t41_ = c_(0.5) * elbow_a_lin_y_;
        let t42_ = t13_ * c_(0.054054054054054064);
        let t43_ = t41_ - t42_;
        let t44_ = elbow_a4_lin_y_ + c_(0.4931969619160719);
        let t45_ = c_(0.5) * elbow_a4_lin_y_;
        let t46_ = t45_ + c_(0.3287979746107146);
        let t47_ = cos_elbow_angle_ * cos_elbow_angle_;
        let t48_ = minus_elbow_a_lin_x_ - minus_elbow_f_force_x_;
        let t49_ = t40_ + minus_elbow_f_force_y_;
        let t50_ = t38_ + t48_;
        let t51_ = elbow_a4_lin_x_ + minus_elbow_f4_force_x_;
        let t52_ = t44_ + minus_elbow_f4_force_y_;
        let t53_ = t51_ * t51_;
        let t54_ = t47_ + t53_;
        let t55_ = T::sqrt(t54_);
        let t56_ = T::copysign(t55_, cos_elbow_angle_);
        let t57_ = cos_elbow_angle_ + t56_;
        let t58_ = t56_ * t57_;
        let t59_ = T::recip(t58_);
        let t60_ = t57_ * t59_;
        let t61_ = t50_ * t60_;
        let t62_ = sin_elbow_angle_ * t57_;
        let t63_ = t51_ * t52_;
        let t64_ = t62_ - t63_;
        let t65_ = t59_ * t64_;
        let t66_ = t57_ * t65_;
        let t67_ = sin_elbow_angle_ - t66_;
        let t68_ = t51_ * t65_;
        let t69_ = t52_ + t68_;
        let t70_ = t61_ * t67_;
        let t71_ = t49_ + t70_;
        let t72_ = t46_ * t51_;
        let t73_ = t59_ * t72_;
        let t74_ = t57_ * t73_;
        let t75_ = t51_ * t73_;
        let t76_ = t46_ - t75_;
        let t77_ = t61_ * t74_;
        let t78_ = t43_ + t77_;
        let t79_ = t69_ * t69_;
        let t80_ = c_(0.25) + t79_;
        let t81_ = T::sqrt(t80_);
        let t82_ = T::copysign(t81_, -t69_);
        let t83_ = t69_ - t82_;
        let t84_ = t82_ * t83_;
        let t85_ = T::recip(t84_);
        let t86_ = t83_ * t85_;
        let t87_ = t71_ * t86_;
        let t88_ = t76_ * t83_;
        let t89_ = c_(0.16666666666666666) + t88_;
        let t90_ = t85_ * t89_;
        let t91_ = t83_ * t90_;
        let t92_ = t76_ + t91_;
        let t93_ = c_(0.5) * t90_;
        let t94_ = c_(0.3333333333333333) + t93_;
        let t95_ = t87_ * t92_;
        let t96_ = t78_ - t95_;
        let t97_ = T::recip(t94_);
        let t98_ = t96_ * t97_;
        let t99_ = t83_ * t87_;
        let t100_ = c_(0.5) * t98_;
        let t101_ = t99_ + t100_;
        let t102_ = t85_ * t101_;
        let t103_ = t83_ * t102_;
        let t104_ = t87_ + t103_;
        let t105_ = t57_ * t61_;
        let t106_ = t51_ * t104_;
        let t107_ = t105_ + t106_;
        let t108_ = t59_ * t107_;
        let t109_ = t51_ * t108_;
        let minus_end_x4_ = t104_ - t109_;
        let t110_ = c_(0.5) * t102_;
        let minus_end_x5_ = t98_ + t110_;
        /// Back to `shoulder`, [P, Eqs. (8), (11)]: 3 mul, 2 add, 0 reciprocal.
        let t111_ = t13_ * c_(1.9863939238321437);
        let t112_ = c_(0.16666666666666669) * minus_end_x4_;
        let t113_ = t111_ - t112_;
        let t114_ = c_(0.0816364570071376) * t113_;
        let minus_shoulder_beta0_ = minus_end_x4_ + t114_;
        /// Motion across `elbow`, [P, Eqs. (1), (13), (36)]: 8 mul, 2 add, 0 reciprocal.
        let t115_ = cos_shoulder_angle_ * cos_elbow_angle_;
        let t116_ = sin_shoulder_angle_ * sin_elbow_angle_;
        let elbow_axes_x_x_ = t115_ - t116_;
        let t117_ = cos_shoulder_angle_ * sin_elbow_angle_;
        let t118_ = sin_shoulder_angle_ * cos_elbow_angle_;
        let minus_elbow_axes_x_y_ = t117_ + t118_;
        let t119_ = shoulder_rate_ * cos_shoulder_angle_;
        let minus_elbow_drift_lin_x_2_ = shoulder_rate_ * t119_;
        let t120_ = shoulder_rate_ * sin_shoulder_angle_;
        let minus_elbow_drift_lin_y_ = shoulder_rate_ * t120_;
        /// Point of `elbow`, [P, Eqs. (12), (13), (36)]: 2 mul, 3 add, 0 reciprocal.
        let t121_ = sin_shoulder_angle_ * minus_shoulder_beta0_;
        let minus_elbow_acc_lin_x_ = minus_elbow_drift_lin_x_2_ - t121_;
        let t122_ = cos_shoulder_angle_ * minus_shoulder_beta0_;
        let minus_elbow_acc_lin_y_ = minus_elbow_drift_lin_y_ + t122_;
        let minus_elbow_acc_ang_z_ = minus_end_x5_ + minus_shoulder_beta0_;
        /// Load of the body at `shoulder`, [P, Eqs. (18), (19)]: 5 mul, 3 add, 0 reciprocal.
        let t123_ = cos_shoulder_angle_ * t26_;
        let t124_ = c_(0.5) * minus_shoulder_beta0_;
        let t125_ = shoulder_a_lin_y_ - t124_;
        let t126_ = sin_shoulder_angle_ * t125_;
        let minus_shoulder_own_force_x_ = t123_ + t126_;
        let t127_ = sin_shoulder_angle_ * t26_;
        let t128_ = cos_shoulder_angle_ * t125_;
        let minus_shoulder_own_force_y_ = t127_ - t128_;
        /// Load of the body at `elbow`, [P, Eqs. (18), (19)]: 7 mul, 9 add, 0 reciprocal.
        let t129_ = shoulder_a_lin_y_ - minus_shoulder_beta0_;
        let t130_ = sin_elbow_angle_ * t129_;
        let t131_ = t10_ + t130_;
        let t132_ = cos_elbow_angle_ * t129_;
        let t133_ = t18_ - t132_;
        let t134_ = minus_elbow_drift_lin_x_ - t131_;
        let t135_ = elbow_drift_lin_y_ - t133_;
        let t136_ = c_(0.5) * minus_elbow_acc_ang_z_;
        let t137_ = t135_ - t136_;
        let t138_ = t38_ + t134_;
        let t139_ = elbow_axes_x_x_ * t138_;
        let t140_ = minus_elbow_axes_x_y_ * t137_;
        let minus_elbow_own_force_x_ = t139_ + t140_;
        let t141_ = minus_elbow_axes_x_y_ * t138_;
        let t142_ = elbow_axes_x_x_ * t137_;
        let minus_elbow_own_force_y_ = t141_ - t142_;
        /// Load on `shoulder`, [P, Eqs. (18), (19)]: 0 mul, 2 add, 0 reciprocal.
        let minus_shoulder_load_force_x_ = minus_shoulder_own_force_x_
            + minus_elbow_own_force_x_;
        let minus_shoulder_load_force_y_ = minus_shoulder_own_force_y_
            + minus_elbow_own_force_y_;
        /// Results: 25 mul, 17 add, 0 reciprocal.
        let t143_ = cos_shoulder_angle_ * c_(0.5);
        let t144_ = sin_shoulder_angle_ * c_(0.5);
        let t145_ = c_(0.5) * elbow_axes_x_x_;
        let t146_ = c_(0.5) * minus_elbow_axes_x_y_;
        let t147_ = shoulder_rate_ * t144_;
        let t148_ = shoulder_rate_ * t143_;
        let t149_ = shoulder_rate_ * c_(0.08333333333333333);
        let t150_ = shoulder_rate_ * t149_;
        let t151_ = t147_ * t147_;
        let t152_ = t148_ * t148_;
        let t153_ = t151_ + t152_;
        let t154_ = t150_ + t153_;
        let t155_ = elbow_omega_z_ * t146_;
        let t156_ = elbow_omega_z_ * t145_;
        let t157_ = t120_ + t155_;
        let t158_ = t119_ + t156_;
        let t159_ = elbow_omega_z_ * c_(0.08333333333333333);
        let t160_ = elbow_omega_z_ * t159_;
        let t161_ = t157_ * t157_;
        let t162_ = t158_ * t158_;
        let t163_ = t161_ + t162_;
        let t164_ = t160_ + t163_;
        let t165_ = t154_ + t164_;
        let t166_ = c_(0.5) * t165_;
        let t167_ = sin_shoulder_angle_ * c_(4.9);
        let t168_ = sin_shoulder_angle_ + t146_;
        let t169_ = c_(9.8) * t168_;
        let t170_ = t167_ + t169_;
        let t171_ = cos_shoulder_angle_ + elbow_axes_x_x_;
        let t172_ = sin_shoulder_angle_ + minus_elbow_axes_x_y_;
        let t173_ = elbow_omega_z_ * minus_elbow_axes_x_y_;
        let t174_ = t120_ + t173_;
        let t175_ = elbow_omega_z_ * elbow_axes_x_x_;
        let t176_ = t119_ + t175_;
        let t177_ = elbow_omega_z_ * t175_;
        let t178_ = minus_elbow_axes_x_y_ * minus_elbow_acc_ang_z_;
        let t179_ = minus_elbow_acc_lin_x_ - t178_;
        let t180_ = t177_ + t179_;
        let t181_ = elbow_omega_z_ * t173_;
        let t182_ = elbow_axes_x_x_ * minus_elbow_acc_ang_z_;
        let t183_ = minus_elbow_acc_lin_y_ + t182_;
        let t184_ = t181_ + t183_;
        ::mstmm::generated::finite::<
            T,
        >(&[state_.q.as_slice(), state_.v.as_slice(), &[state_.t]])?;
        ::mstmm::generated::regular::<
            T,
            _,
            _,
        >(
            &["shoulder"],
            [shoulder_d_],
            [c_(2.9266666666666667)],
            [-minus_shoulder_beta0_, -minus_end_x5_],
        )?;
        at_.accelerations.data.0 = [[-minus_shoulder_beta0_, -minus_end_x5_]];
        at_.rate_accelerations.data.0 = [[-minus_shoulder_beta0_, -minus_end_x5_]];
        at_.efforts.data.0 = [[c_(0.0), c_(0.0)]];
        at_.kinetic_energy = t166_;
        at_.potential_energy = t170_;
        at_.points = [
            ::mstmm::Point::new(
                [c_(0.0), c_(0.0), c_(0.0)],
                [
                    [c_(1.0), c_(0.0), c_(0.0)],
                    [c_(0.0), c_(1.0), c_(0.0)],
                    [c_(0.0), c_(0.0), c_(1.0)],
                ],
                [c_(0.0), c_(0.0), c_(0.0)],
                [c_(0.0), c_(0.0), c_(0.0)],
                ::mstmm::StateVector::new(
                    [c_(0.0), c_(0.0), c_(0.0)],
                    [c_(0.0), c_(0.0), c_(0.0)],
                    [c_(0.0), c_(0.0), c_(0.0)],
                    [
                        -minus_shoulder_load_force_x_,
                        -minus_shoulder_load_force_y_,
                        c_(0.0),
                    ],
                ),
            ),
            ::mstmm::Point::new(
                [c_(0.0), c_(0.0), c_(0.0)],
                [
                    [cos_shoulder_angle_, -sin_shoulder_angle_, c_(0.0)],
                    [sin_shoulder_angle_, cos_shoulder_angle_, c_(0.0)],
                    [c_(0.0), c_(0.0), c_(1.0)],
                ],
                [c_(0.0), c_(0.0), c_(0.0)],
                [c_(0.0), c_(0.0), shoulder_rate_],
                ::mstmm::StateVector::new(
                    [c_(0.0), c_(0.0), c_(0.0)],
                    [c_(0.0), c_(0.0), -minus_shoulder_beta0_],
                    [c_(0.0), c_(0.0), c_(0.0)],
                    [
                        -minus_shoulder_load_force_x_,
                        -minus_shoulder_load_force_y_,
                        c_(0.0),
                    ],
                ),
            ),
            ::mstmm::Point::new(
                [cos_shoulder_angle_, sin_shoulder_angle_, c_(0.0)],
                [
                    [cos_shoulder_angle_, -sin_shoulder_angle_, c_(0.0)],
                    [sin_shoulder_angle_, cos_shoulder_angle_, c_(0.0)],
                    [c_(0.0), c_(0.0), c_(1.0)],
                ],
                [-t120_, t119_, c_(0.0)],
                [c_(0.0), c_(0.0), shoulder_rate_],
                ::mstmm::StateVector::new(
                    [-minus_elbow_acc_lin_x_, -minus_elbow_acc_lin_y_, c_(0.0)],
                    [c_(0.0), c_(0.0), -minus_shoulder_beta0_],
                    [c_(0.0), c_(0.0), c_(0.0)],
                    [-minus_elbow_own_force_x_, -minus_elbow_own_force_y_, c_(0.0)],
                ),
            ),
            ::mstmm::Point::new(
                [cos_shoulder_angle_, sin_shoulder_angle_, c_(0.0)],
                [
                    [elbow_axes_x_x_, -minus_elbow_axes_x_y_, c_(0.0)],
                    [minus_elbow_axes_x_y_, elbow_axes_x_x_, c_(0.0)],
                    [c_(0.0), c_(0.0), c_(1.0)],
                ],
                [-t120_, t119_, c_(0.0)],
                [c_(0.0), c_(0.0), elbow_omega_z_],
                ::mstmm::StateVector::new(
                    [-minus_elbow_acc_lin_x_, -minus_elbow_acc_lin_y_, c_(0.0)],
                    [c_(0.0), c_(0.0), -minus_elbow_acc_ang_z_],
                    [c_(0.0), c_(0.0), c_(0.0)],
                    [-minus_elbow_own_force_x_, -minus_elbow_own_force_y_, c_(0.0)],
                ),
            ),
            ::mstmm::Point::new(
                [t171_, t172_, c_(0.0)],
                [
                    [elbow_axes_x_x_, -minus_elbow_axes_x_y_, c_(0.0)],
                    [minus_elbow_axes_x_y_, elbow_axes_x_x_, c_(0.0)],
                    [c_(0.0), c_(0.0), c_(1.0)],
                ],
                [-t174_, t176_, c_(0.0)],
                [c_(0.0), c_(0.0), elbow_omega_z_],
                ::mstmm::StateVector::new(
                    [-t180_, -t184_, c_(0.0)],
                    [c_(0.0), c_(0.0), -minus_elbow_acc_ang_z_],
                    [c_(0.0), c_(0.0), c_(0.0)],
                    [c_(0.0), c_(0.0), c_(0.0)],
                ),
            ),
        ];
        ::core::result::Result::Ok(())
    }
    /// Kinetic and potential energy in J; the potential of gravity is zero with every centre
    /// of mass at the inertial origin.
    ///
    /// 37 operations: 25 mul, 12 add, 0 reciprocal, 2 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `shoulder` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 2 |
    /// | Motion across `elbow` | \[P, Eqs. (1), (13), (36)\] | 4 | 3 | 0 | 0 | 0 |
    /// | Results |  | 21 | 9 | 0 | 0 | 0 |
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
        /// Motion across `elbow`, [P, Eqs. (1), (13), (36)]: 4 mul, 3 add, 0 reciprocal.
        let t0_ = cos_shoulder_angle_ * cos_elbow_angle_;
        let t1_ = sin_shoulder_angle_ * sin_elbow_angle_;
        let elbow_axes_x_x_ = t0_ - t1_;
        let t2_ = cos_shoulder_angle_ * sin_elbow_angle_;
        let t3_ = sin_shoulder_angle_ * cos_elbow_angle_;
        let minus_elbow_axes_x_y_ = t2_ + t3_;
        let elbow_omega_z_ = shoulder_rate_ + elbow_rate_;
        /// Results: 21 mul, 9 add, 0 reciprocal.
        let t4_ = cos_shoulder_angle_ * c_(0.5);
        let t5_ = sin_shoulder_angle_ * c_(0.5);
        let t6_ = shoulder_rate_ * sin_shoulder_angle_;
        let t7_ = shoulder_rate_ * cos_shoulder_angle_;
        let t8_ = c_(0.5) * elbow_axes_x_x_;
        let t9_ = c_(0.5) * minus_elbow_axes_x_y_;
        let t10_ = shoulder_rate_ * t5_;
        let t11_ = shoulder_rate_ * t4_;
        let t12_ = shoulder_rate_ * c_(0.08333333333333333);
        let t13_ = shoulder_rate_ * t12_;
        let t14_ = t10_ * t10_;
        let t15_ = t11_ * t11_;
        let t16_ = t14_ + t15_;
        let t17_ = t13_ + t16_;
        let t18_ = elbow_omega_z_ * t9_;
        let t19_ = elbow_omega_z_ * t8_;
        let t20_ = t6_ + t18_;
        let t21_ = t7_ + t19_;
        let t22_ = elbow_omega_z_ * c_(0.08333333333333333);
        let t23_ = elbow_omega_z_ * t22_;
        let t24_ = t20_ * t20_;
        let t25_ = t21_ * t21_;
        let t26_ = t24_ + t25_;
        let t27_ = t23_ + t26_;
        let t28_ = t17_ + t27_;
        let t29_ = c_(0.5) * t28_;
        let t30_ = sin_shoulder_angle_ * c_(4.9);
        let t31_ = sin_shoulder_angle_ + t9_;
        let t32_ = c_(9.8) * t31_;
        let t33_ = t30_ + t32_;
        ::mstmm::Energy {
            kinetic: t29_,
            potential: t33_,
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
/// The hinges lie one after the other in the order written. [`Default`] is every hinge at
/// rest in its zero position.
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
/// Results of [`TwoPins::solve_into`].
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct TwoPinsWorkspace<T> {
    accelerations: ::mstmm::nalgebra::SVector<T, 2>,
    rate_accelerations: ::mstmm::nalgebra::SVector<T, 2>,
    efforts: ::mstmm::nalgebra::SVector<T, 2>,
    kinetic_energy: T,
    potential_energy: T,
    points: [::mstmm::Point<T>; 5],
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TwoPinsWorkspace<T> {
    /// Accelerations `v̇` of all hinges, in the order of the rates.
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
    /// All connection points in the order written: the first element's input, then every
    /// element's output.
    #[inline]
    pub fn points(&self) -> &[::mstmm::Point<T>; 5] {
        &self.points
    }
    /// Acceleration, effort, input and output of hinge `shoulder`.
    #[inline]
    pub fn shoulder(&self) -> ::mstmm::HingeResult<'_, T, T, ::mstmm::Point<T>> {
        let [input_, output_, ..] = &self.points;
        ::mstmm::HingeResult::new(
            {
                let [value_] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.rate_accelerations.as_slice(), 0);
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
    /// Input and output of body `upper`.
    #[inline]
    pub fn upper(&self) -> ::mstmm::BodyResult<'_, T, ::mstmm::Point<T>> {
        let [_, input_, output_, ..] = &self.points;
        ::mstmm::BodyResult::new(input_, output_)
    }
    /// Acceleration, effort, input and output of hinge `elbow`.
    #[inline]
    pub fn elbow(&self) -> ::mstmm::HingeResult<'_, T, T, ::mstmm::Point<T>> {
        let [_, _, input_, output_, ..] = &self.points;
        ::mstmm::HingeResult::new(
            {
                let [value_] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.rate_accelerations.as_slice(), 1);
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
    /// Input and output of body `lower`.
    #[inline]
    pub fn lower(&self) -> ::mstmm::BodyResult<'_, T, ::mstmm::Point<T>> {
        let [_, _, _, input_, output_, ..] = &self.points;
        ::mstmm::BodyResult::new(input_, output_)
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TwoPins<T> {
    /// Room for the results of [`solve_into`](Self::solve_into).
    #[must_use]
    pub fn workspace(&self) -> TwoPinsWorkspace<T> {
        let zero_ = T::constant(0.0);
        TwoPinsWorkspace {
            accelerations: ::mstmm::generated::vector([zero_; 2]),
            rate_accelerations: ::mstmm::generated::vector([zero_; 2]),
            efforts: ::mstmm::generated::vector([zero_; 2]),
            kinetic_energy: zero_,
            potential_energy: zero_,
            points: [::core::default::Default::default(); 5],
        }
    }
}
#[allow(dead_code, non_camel_case_types, clippy::all)]
const _: () = {
    struct Rod;
    const _: Rod = Rod;
    const _: Rod = Rod;
};
