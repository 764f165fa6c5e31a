/// Two rods in a plane, by the forward product.
///
/// # The chain
///
/// `ground -> pin shoulder -> upper -> pin elbow -> lower`
///
/// | element | kind | freedoms |
/// |---|---|---|
/// | `shoulder` | pin | 1 |
/// | `upper` | body `Rod` |  |
/// | `elbow` | pin | 1 |
/// | `lower` | body `Rod` |  |
///
/// 2 degrees of freedom; accelerations by `transfer`, 130 operations (75 mul, 50 add, 3 reciprocal, 2 square root, 2 sin/cos); with everything at every connection point 213 operations.
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
        let parameters = TwoPinsParameters {
            none: ::core::marker::PhantomData,
        };
        let (chain, _) = Self::derive(parameters);
        chain
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
        let c = T::constant;
        TwoPinsState {
            q: ::mstmm::generated::vector([c(0.0), c(0.0)]),
            v: ::mstmm::generated::vector([c(0.0), c(0.0)]),
            t: T::constant(0.0),
        }
    }
    /// Quantities derived from parameters and constants: 0 mul, 0 add, 0 reciprocal.
    #[allow(unused_doc_comments, unused_variables, unused_mut, clippy::all)]
    fn derive(parameters: TwoPinsParameters<T>) -> (Self, [T; 0]) {
        let (derived, checks) = ([], []);
        (Self { parameters, derived }, checks)
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
    /// [`Error::Singular`](::mstmm::Error::Singular) if nothing with inertia lies beyond a
    /// hinge, [`Error::NotFinite`](::mstmm::Error::NotFinite) if a number of the state or the
    /// inputs is not finite. `accelerations` is not touched then.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn accelerations_into(
        &self,
        state: &TwoPinsState<T>,
        inputs: &TwoPinsInputs<T>,
        accelerations: &mut ::mstmm::nalgebra::SVector<T, 2>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let c = T::constant;
        let [[shoulder_angle, elbow_angle]] = state.q.data.0;
        let [[shoulder_rate, elbow_rate]] = state.v.data.0;
        /// Motion across `shoulder`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 2 sin/cos.
        let (
            [sin_shoulder_angle,
            sin_elbow_angle,
            ],
            [cos_shoulder_angle,
            cos_elbow_angle,
            ],
        ) = T::sin_cos([shoulder_angle, elbow_angle]);
        /// Motion across `elbow`, [P, Eqs. (1), (13), (36)]: 3 mul, 1 add, 0 reciprocal.
        let elbow_omega_z = shoulder_rate + elbow_rate;
        let t0 = shoulder_rate * shoulder_rate;
        let minus_elbow_drift_lin_x = cos_elbow_angle * t0;
        let elbow_drift_lin_y = sin_elbow_angle * t0;
        /// Inertia beyond the hinges, to be divided by, the pivots of the Riccati transfer: 2 mul, 1 add, 0 reciprocal.
        let t1 = sin_elbow_angle * c(0.75);
        let t2 = sin_elbow_angle * t1;
        let shoulder_d = t2 + c(0.5833333333333333);
        /// Transfer to `shoulder`, [P, Eqs. (8), (21)] with the conditions [P, Eqs. (25), (35)] of this hinge: 2 mul, 0 add, 0 reciprocal.
        let shoulder_a_lin_x = sin_shoulder_angle * c(9.8);
        let shoulder_a_lin_y = cos_shoulder_angle * c(9.8);
        /// Transfer to `elbow`, [P, Eqs. (8), (21)] with the conditions [P, Eqs. (25), (35)] of this hinge: 24 mul, 18 add, 0 reciprocal.
        let t3 = sin_elbow_angle * c(0.013606076167856269);
        let elbow_a4_lin_x = sin_elbow_angle - t3;
        let t4 = cos_elbow_angle * c(0.013606076167856269);
        let elbow_a4_lin_y = cos_elbow_angle - t4;
        let t5 = sin_elbow_angle * c(0.5);
        let t6 = sin_elbow_angle * c(0.17120202538928544);
        let minus_elbow_f4_force_x = t5 - t6;
        let t7 = cos_elbow_angle * c(0.5);
        let t8 = cos_elbow_angle * c(0.17120202538928544);
        let minus_elbow_f4_force_y = t7 - t8;
        let t9 = cos_shoulder_angle * c(4.9);
        let t10 = cos_elbow_angle * shoulder_a_lin_x;
        let t11 = sin_elbow_angle * shoulder_a_lin_y;
        let t12 = t10 + t11;
        let t13 = shoulder_a_lin_y - t9;
        let t14 = minus_elbow_drift_lin_x - t12;
        let t15 = t13 * c(0.9863939238321437);
        let t16 = sin_elbow_angle * c(0.16439898730535732);
        let t17 = t15 * t16;
        let minus_elbow_a_lin_x = t14 + t17;
        let t18 = sin_elbow_angle * shoulder_a_lin_x;
        let t19 = cos_elbow_angle * shoulder_a_lin_y;
        let t20 = t18 - t19;
        let t21 = elbow_drift_lin_y - t20;
        let t22 = cos_elbow_angle * c(0.16439898730535732);
        let t23 = t15 * t22;
        let elbow_a_lin_y = t21 - t23;
        let t24 = shoulder_rate * c(0.5);
        let t25 = shoulder_rate * t24;
        let t26 = t25 - shoulder_a_lin_x;
        let t27 = cos_elbow_angle * t26;
        let t28 = t11 - t27;
        let t29 = sin_elbow_angle * c(2.0685934174848226);
        let t30 = sin_elbow_angle - t29;
        let t31 = t15 * t30;
        let minus_elbow_f_force_x = t28 + t31;
        let t32 = sin_elbow_angle * t26;
        let t33 = t19 + t32;
        let t34 = cos_elbow_angle * c(2.0685934174848226);
        let t35 = cos_elbow_angle - t34;
        let t36 = t15 * t35;
        let minus_elbow_f_force_y = t33 + t36;
        /// Boundary solve at the far end, [P, Eqs. (9) to (11)]: 41 mul, 28 add, 3 reciprocal, 2 square root.
        let t37 = elbow_omega_z * c(0.5);
        let t38 = elbow_omega_z * t37;
        let t39 = t13 * c(0.0810810810810811);
        let t40 = elbow_a_lin_y - t39;
        let t41 = c(0.5) * elbow_a_lin_y;
        let t42 = t13 * c(0.054054054054054064);
        let t43 = t41 - t42;
        let t44 = elbow_a4_lin_y + c(0.4931969619160719);
        let t45 = c(0.5) * elbow_a4_lin_y;
        let t46 = t45 + c(0.3287979746107146);
        let t47 = cos_elbow_angle * cos_elbow_angle;
        let t48 = minus_elbow_a_lin_x - minus_elbow_f_force_x;
        let t49 = t40 + minus_elbow_f_force_y;
        let t50 = t38 + t48;
        let t51 = elbow_a4_lin_x + minus_elbow_f4_force_x;
        let t52 = t44 + minus_elbow_f4_force_y;
        let t53 = t51 * t51;
        let t54 = t47 + t53;
        let t55 = T::sqrt(t54);
        let t56 = T::copysign(t55, cos_elbow_angle);
        let t57 = cos_elbow_angle + t56;
        let t58 = t56 * t57;
        let t59 = T::recip(t58);
        let t60 = t57 * t59;
        let t61 = t50 * t60;
        let t62 = sin_elbow_angle * t57;
        let t63 = t51 * t52;
        let t64 = t62 - t63;
        let t65 = t59 * t64;
        let t66 = t57 * t65;
        let t67 = sin_elbow_angle - t66;
        let t68 = t51 * t65;
        let t69 = t52 + t68;
        let t70 = t61 * t67;
        let t71 = t49 + t70;
        let t72 = t46 * t51;
        let t73 = t59 * t72;
        let t74 = t57 * t73;
        let t75 = t51 * t73;
        let t76 = t46 - t75;
        let t77 = t61 * t74;
        let t78 = t43 + t77;
        let t79 = t69 * t69;
        let t80 = c(0.25) + t79;
        let t81 = T::sqrt(t80);
        let t82 = T::copysign(t81, -t69);
        let t83 = t69 - t82;
        let t84 = t82 * t83;
        let t85 = T::recip(t84);
        let t86 = t83 * t85;
        let t87 = t71 * t86;
        let t88 = t76 * t83;
        let t89 = c(0.16666666666666666) + t88;
        let t90 = t85 * t89;
        let t91 = t83 * t90;
        let t92 = t76 + t91;
        let t93 = c(0.5) * t90;
        let t94 = c(0.3333333333333333) + t93;
        let t95 = t87 * t92;
        let t96 = t78 - t95;
        let t97 = T::recip(t94);
        let t98 = t96 * t97;
        let t99 = t83 * t87;
        let t100 = c(0.5) * t98;
        let t101 = t99 + t100;
        let t102 = t85 * t101;
        let t103 = t83 * t102;
        let t104 = t87 + t103;
        let t105 = t57 * t61;
        let t106 = t51 * t104;
        let t107 = t105 + t106;
        let t108 = t59 * t107;
        let t109 = t51 * t108;
        let minus_end_x4 = t104 - t109;
        let t110 = c(0.5) * t102;
        let minus_end_x5 = t98 + t110;
        /// Back to `shoulder`, [P, Eqs. (8), (11)]: 3 mul, 2 add, 0 reciprocal.
        let t111 = t13 * c(1.9863939238321437);
        let t112 = c(0.16666666666666669) * minus_end_x4;
        let t113 = t111 - t112;
        let t114 = c(0.0816364570071376) * t113;
        let minus_shoulder_beta0 = minus_end_x4 + t114;
        ::mstmm::generated::finite::<T>(&[state.q.as_slice(), state.v.as_slice()])?;
        ::mstmm::generated::regular::<
            T,
            _,
            _,
        >(
            &["shoulder"],
            [shoulder_d],
            [c(2.9266666666666667)],
            [-minus_shoulder_beta0, -minus_end_x5],
        )?;
        accelerations.data.0 = [[-minus_shoulder_beta0, -minus_end_x5]];
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
        state: &TwoPinsState<T>,
        inputs: &TwoPinsInputs<T>,
    ) -> ::core::result::Result<::mstmm::nalgebra::SVector<T, 2>, ::mstmm::Error> {
        let mut accelerations = ::mstmm::generated::vector([T::constant(0.0); 2]);
        self.accelerations_into(state, inputs, &mut accelerations)?;
        ::core::result::Result::Ok(accelerations)
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
        state: &TwoPinsState<T>,
        inputs: &TwoPinsInputs<T>,
        at: &mut TwoPinsWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let c = T::constant;
        let [[shoulder_angle, elbow_angle]] = state.q.data.0;
        let [[shoulder_rate, elbow_rate]] = state.v.data.0;
        /// Motion across `shoulder`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 2 sin/cos.
        let (
            [sin_shoulder_angle,
            sin_elbow_angle,
            ],
            [cos_shoulder_angle,
            cos_elbow_angle,
            ],
        ) = T::sin_cos([shoulder_angle, elbow_angle]);
        /// Motion across `elbow`, [P, Eqs. (1), (13), (36)]: 3 mul, 1 add, 0 reciprocal.
        let elbow_omega_z = shoulder_rate + elbow_rate;
        let t0 = shoulder_rate * shoulder_rate;
        let minus_elbow_drift_lin_x = cos_elbow_angle * t0;
        let elbow_drift_lin_y = sin_elbow_angle * t0;
        /// Inertia beyond the hinges, to be divided by, the pivots of the Riccati transfer: 2 mul, 1 add, 0 reciprocal.
        let t1 = sin_elbow_angle * c(0.75);
        let t2 = sin_elbow_angle * t1;
        let shoulder_d = t2 + c(0.5833333333333333);
        /// Transfer to `shoulder`, [P, Eqs. (8), (21)] with the conditions [P, Eqs. (25), (35)] of this hinge: 2 mul, 0 add, 0 reciprocal.
        let shoulder_a_lin_x = sin_shoulder_angle * c(9.8);
        let shoulder_a_lin_y = cos_shoulder_angle * c(9.8);
        /// Transfer to `elbow`, [P, Eqs. (8), (21)] with the conditions [P, Eqs. (25), (35)] of this hinge: 24 mul, 18 add, 0 reciprocal.
        let t3 = sin_elbow_angle * c(0.013606076167856269);
        let elbow_a4_lin_x = sin_elbow_angle - t3;
        let t4 = cos_elbow_angle * c(0.013606076167856269);
        let elbow_a4_lin_y = cos_elbow_angle - t4;
        let t5 = sin_elbow_angle * c(0.5);
        let t6 = sin_elbow_angle * c(0.17120202538928544);
        let minus_elbow_f4_force_x = t5 - t6;
        let t7 = cos_elbow_angle * c(0.5);
        let t8 = cos_elbow_angle * c(0.17120202538928544);
        let minus_elbow_f4_force_y = t7 - t8;
        let t9 = cos_shoulder_angle * c(4.9);
        let t10 = cos_elbow_angle * shoulder_a_lin_x;
        let t11 = sin_elbow_angle * shoulder_a_lin_y;
        let t12 = t10 + t11;
        let t13 = shoulder_a_lin_y - t9;
        let t14 = minus_elbow_drift_lin_x - t12;
        let t15 = t13 * c(0.9863939238321437);
        let t16 = sin_elbow_angle * c(0.16439898730535732);
        let t17 = t15 * t16;
        let minus_elbow_a_lin_x = t14 + t17;
        let t18 = sin_elbow_angle * shoulder_a_lin_x;
        let t19 = cos_elbow_angle * shoulder_a_lin_y;
        let t20 = t18 - t19;
        let t21 = elbow_drift_lin_y - t20;
        let t22 = cos_elbow_angle * c(0.16439898730535732);
        let t23 = t15 * t22;
        let elbow_a_lin_y = t21 - t23;
        let t24 = shoulder_rate * c(0.5);
        let t25 = shoulder_rate * t24;
        let t26 = t25 - shoulder_a_lin_x;
        let t27 = cos_elbow_angle * t26;
        let t28 = t11 - t27;
        let t29 = sin_elbow_angle * c(2.0685934174848226);
        let t30 = sin_elbow_angle - t29;
        let t31 = t15 * t30;
        let minus_elbow_f_force_x = t28 + t31;
        let t32 = sin_elbow_angle * t26;
        let t33 = t19 + t32;
        let t34 = cos_elbow_angle * c(2.0685934174848226);
        let t35 = cos_elbow_angle - t34;
        let t36 = t15 * t35;
        let minus_elbow_f_force_y = t33 + t36;
        /// Boundary solve at the far end, [P, Eqs. (9) to (11)]: 41 mul, 28 add, 3 reciprocal, 2 square root.
        let t37 = elbow_omega_z * c(0.5);
        let t38 = elbow_omega_z * t37;
        let t39 = t13 * c(0.0810810810810811);
        let t40 = elbow_a_lin_y - t39;
        let t41 = c(0.5) * elbow_a_lin_y;
        let t42 = t13 * c(0.054054054054054064);
        let t43 = t41 - t42;
        let t44 = elbow_a4_lin_y + c(0.4931969619160719);
        let t45 = c(0.5) * elbow_a4_lin_y;
        let t46 = t45 + c(0.3287979746107146);
        let t47 = cos_elbow_angle * cos_elbow_angle;
        let t48 = minus_elbow_a_lin_x - minus_elbow_f_force_x;
        let t49 = t40 + minus_elbow_f_force_y;
        let t50 = t38 + t48;
        let t51 = elbow_a4_lin_x + minus_elbow_f4_force_x;
        let t52 = t44 + minus_elbow_f4_force_y;
        let t53 = t51 * t51;
        let t54 = t47 + t53;
        let t55 = T::sqrt(t54);
        let t56 = T::copysign(t55, cos_elbow_angle);
        let t57 = cos_elbow_angle + t56;
        let t58 = t56 * t57;
        let t59 = T::recip(t58);
        let t60 = t57 * t59;
        let t61 = t50 * t60;
        let t62 = sin_elbow_angle * t57;
        let t63 = t51 * t52;
        let t64 = t62 - t63;
        let t65 = t59 * t64;
        let t66 = t57 * t65;
        let t67 = sin_elbow_angle - t66;
        let t68 = t51 * t65;
        let t69 = t52 + t68;
        let t70 = t61 * t67;
        let t71 = t49 + t70;
        let t72 = t46 * t51;
        let t73 = t59 * t72;
        let t74 = t57 * t73;
        let t75 = t51 * t73;
        let t76 = t46 - t75;
        let t77 = t61 * t74;
        let t78 = t43 + t77;
        let t79 = t69 * t69;
        let t80 = c(0.25) + t79;
        let t81 = T::sqrt(t80);
        let t82 = T::copysign(t81, -t69);
        let t83 = t69 - t82;
        let t84 = t82 * t83;
        let t85 = T::recip(t84);
        let t86 = t83 * t85;
        let t87 = t71 * t86;
        let t88 = t76 * t83;
        let t89 = c(0.16666666666666666) + t88;
        let t90 = t85 * t89;
        let t91 = t83 * t90;
        let t92 = t76 + t91;
        let t93 = c(0.5) * t90;
        let t94 = c(0.3333333333333333) + t93;
        let t95 = t87 * t92;
        let t96 = t78 - t95;
        let t97 = T::recip(t94);
        let t98 = t96 * t97;
        let t99 = t83 * t87;
        let t100 = c(0.5) * t98;
        let t101 = t99 + t100;
        let t102 = t85 * t101;
        let t103 = t83 * t102;
        let t104 = t87 + t103;
        let t105 = t57 * t61;
        let t106 = t51 * t104;
        let t107 = t105 + t106;
        let t108 = t59 * t107;
        let t109 = t51 * t108;
        let minus_end_x4 = t104 - t109;
        let t110 = c(0.5) * t102;
        let minus_end_x5 = t98 + t110;
        /// Back to `shoulder`, [P, Eqs. (8), (11)]: 3 mul, 2 add, 0 reciprocal.
        let t111 = t13 * c(1.9863939238321437);
        let t112 = c(0.16666666666666669) * minus_end_x4;
        let t113 = t111 - t112;
        let t114 = c(0.0816364570071376) * t113;
        let minus_shoulder_beta0 = minus_end_x4 + t114;
        /// Motion across `elbow`, [P, Eqs. (1), (13), (36)]: 8 mul, 2 add, 0 reciprocal.
        let t115 = cos_shoulder_angle * cos_elbow_angle;
        let t116 = sin_shoulder_angle * sin_elbow_angle;
        let elbow_axes_x_x = t115 - t116;
        let t117 = cos_shoulder_angle * sin_elbow_angle;
        let t118 = sin_shoulder_angle * cos_elbow_angle;
        let minus_elbow_axes_x_y = t117 + t118;
        let t119 = shoulder_rate * cos_shoulder_angle;
        let minus_elbow_drift_lin_x_2 = shoulder_rate * t119;
        let t120 = shoulder_rate * sin_shoulder_angle;
        let minus_elbow_drift_lin_y = shoulder_rate * t120;
        /// Point of `elbow`, [P, Eqs. (12), (13), (36)]: 2 mul, 3 add, 0 reciprocal.
        let t121 = sin_shoulder_angle * minus_shoulder_beta0;
        let minus_elbow_acc_lin_x = minus_elbow_drift_lin_x_2 - t121;
        let t122 = cos_shoulder_angle * minus_shoulder_beta0;
        let minus_elbow_acc_lin_y = minus_elbow_drift_lin_y + t122;
        let minus_elbow_acc_ang_z = minus_end_x5 + minus_shoulder_beta0;
        /// Load of the body at `shoulder`, [P, Eqs. (18), (19)]: 5 mul, 3 add, 0 reciprocal.
        let t123 = cos_shoulder_angle * t26;
        let t124 = c(0.5) * minus_shoulder_beta0;
        let t125 = shoulder_a_lin_y - t124;
        let t126 = sin_shoulder_angle * t125;
        let minus_shoulder_own_force_x = t123 + t126;
        let t127 = sin_shoulder_angle * t26;
        let t128 = cos_shoulder_angle * t125;
        let minus_shoulder_own_force_y = t127 - t128;
        /// Load of the body at `elbow`, [P, Eqs. (18), (19)]: 7 mul, 9 add, 0 reciprocal.
        let t129 = shoulder_a_lin_y - minus_shoulder_beta0;
        let t130 = sin_elbow_angle * t129;
        let t131 = t10 + t130;
        let t132 = cos_elbow_angle * t129;
        let t133 = t18 - t132;
        let t134 = minus_elbow_drift_lin_x - t131;
        let t135 = elbow_drift_lin_y - t133;
        let t136 = c(0.5) * minus_elbow_acc_ang_z;
        let t137 = t135 - t136;
        let t138 = t38 + t134;
        let t139 = elbow_axes_x_x * t138;
        let t140 = minus_elbow_axes_x_y * t137;
        let minus_elbow_own_force_x = t139 + t140;
        let t141 = minus_elbow_axes_x_y * t138;
        let t142 = elbow_axes_x_x * t137;
        let minus_elbow_own_force_y = t141 - t142;
        /// Load on `shoulder`, [P, Eqs. (18), (19)]: 0 mul, 2 add, 0 reciprocal.
        let minus_shoulder_load_force_x = minus_shoulder_own_force_x
            + minus_elbow_own_force_x;
        let minus_shoulder_load_force_y = minus_shoulder_own_force_y
            + minus_elbow_own_force_y;
        /// Results: 25 mul, 17 add, 0 reciprocal.
        let t143 = cos_shoulder_angle * c(0.5);
        let t144 = sin_shoulder_angle * c(0.5);
        let t145 = c(0.5) * elbow_axes_x_x;
        let t146 = c(0.5) * minus_elbow_axes_x_y;
        let t147 = shoulder_rate * t144;
        let t148 = shoulder_rate * t143;
        let t149 = shoulder_rate * c(0.08333333333333333);
        let t150 = shoulder_rate * t149;
        let t151 = t147 * t147;
        let t152 = t148 * t148;
        let t153 = t151 + t152;
        let t154 = t150 + t153;
        let t155 = elbow_omega_z * t146;
        let t156 = elbow_omega_z * t145;
        let t157 = t120 + t155;
        let t158 = t119 + t156;
        let t159 = elbow_omega_z * c(0.08333333333333333);
        let t160 = elbow_omega_z * t159;
        let t161 = t157 * t157;
        let t162 = t158 * t158;
        let t163 = t161 + t162;
        let t164 = t160 + t163;
        let t165 = t154 + t164;
        let t166 = c(0.5) * t165;
        let t167 = sin_shoulder_angle * c(4.9);
        let t168 = sin_shoulder_angle + t146;
        let t169 = c(9.8) * t168;
        let t170 = t167 + t169;
        let t171 = cos_shoulder_angle + elbow_axes_x_x;
        let t172 = sin_shoulder_angle + minus_elbow_axes_x_y;
        let t173 = elbow_omega_z * minus_elbow_axes_x_y;
        let t174 = t120 + t173;
        let t175 = elbow_omega_z * elbow_axes_x_x;
        let t176 = t119 + t175;
        let t177 = elbow_omega_z * t175;
        let t178 = minus_elbow_axes_x_y * minus_elbow_acc_ang_z;
        let t179 = minus_elbow_acc_lin_x - t178;
        let t180 = t177 + t179;
        let t181 = elbow_omega_z * t173;
        let t182 = elbow_axes_x_x * minus_elbow_acc_ang_z;
        let t183 = minus_elbow_acc_lin_y + t182;
        let t184 = t181 + t183;
        ::mstmm::generated::finite::<T>(&[state.q.as_slice(), state.v.as_slice()])?;
        ::mstmm::generated::regular::<
            T,
            _,
            _,
        >(
            &["shoulder"],
            [shoulder_d],
            [c(2.9266666666666667)],
            [-minus_shoulder_beta0, -minus_end_x5],
        )?;
        at.accelerations.data.0 = [[-minus_shoulder_beta0, -minus_end_x5]];
        at.rate_accelerations.data.0 = [[-minus_shoulder_beta0, -minus_end_x5]];
        at.efforts.data.0 = [[c(0.0), c(0.0)]];
        at.kinetic_energy = t166;
        at.potential_energy = t170;
        at.points = [
            ::mstmm::Point::new(
                [c(0.0), c(0.0), c(0.0)],
                [
                    [c(1.0), c(0.0), c(0.0)],
                    [c(0.0), c(1.0), c(0.0)],
                    [c(0.0), c(0.0), c(1.0)],
                ],
                [c(0.0), c(0.0), c(0.0)],
                [c(0.0), c(0.0), c(0.0)],
                ::mstmm::StateVector::new(
                    [c(0.0), c(0.0), c(0.0)],
                    [c(0.0), c(0.0), c(0.0)],
                    [c(0.0), c(0.0), c(0.0)],
                    [-minus_shoulder_load_force_x, -minus_shoulder_load_force_y, c(0.0)],
                ),
            ),
            ::mstmm::Point::new(
                [c(0.0), c(0.0), c(0.0)],
                [
                    [cos_shoulder_angle, -sin_shoulder_angle, c(0.0)],
                    [sin_shoulder_angle, cos_shoulder_angle, c(0.0)],
                    [c(0.0), c(0.0), c(1.0)],
                ],
                [c(0.0), c(0.0), c(0.0)],
                [c(0.0), c(0.0), shoulder_rate],
                ::mstmm::StateVector::new(
                    [c(0.0), c(0.0), c(0.0)],
                    [c(0.0), c(0.0), -minus_shoulder_beta0],
                    [c(0.0), c(0.0), c(0.0)],
                    [-minus_shoulder_load_force_x, -minus_shoulder_load_force_y, c(0.0)],
                ),
            ),
            ::mstmm::Point::new(
                [cos_shoulder_angle, sin_shoulder_angle, c(0.0)],
                [
                    [cos_shoulder_angle, -sin_shoulder_angle, c(0.0)],
                    [sin_shoulder_angle, cos_shoulder_angle, c(0.0)],
                    [c(0.0), c(0.0), c(1.0)],
                ],
                [-t120, t119, c(0.0)],
                [c(0.0), c(0.0), shoulder_rate],
                ::mstmm::StateVector::new(
                    [-minus_elbow_acc_lin_x, -minus_elbow_acc_lin_y, c(0.0)],
                    [c(0.0), c(0.0), -minus_shoulder_beta0],
                    [c(0.0), c(0.0), c(0.0)],
                    [-minus_elbow_own_force_x, -minus_elbow_own_force_y, c(0.0)],
                ),
            ),
            ::mstmm::Point::new(
                [cos_shoulder_angle, sin_shoulder_angle, c(0.0)],
                [
                    [elbow_axes_x_x, -minus_elbow_axes_x_y, c(0.0)],
                    [minus_elbow_axes_x_y, elbow_axes_x_x, c(0.0)],
                    [c(0.0), c(0.0), c(1.0)],
                ],
                [-t120, t119, c(0.0)],
                [c(0.0), c(0.0), elbow_omega_z],
                ::mstmm::StateVector::new(
                    [-minus_elbow_acc_lin_x, -minus_elbow_acc_lin_y, c(0.0)],
                    [c(0.0), c(0.0), -minus_elbow_acc_ang_z],
                    [c(0.0), c(0.0), c(0.0)],
                    [-minus_elbow_own_force_x, -minus_elbow_own_force_y, c(0.0)],
                ),
            ),
            ::mstmm::Point::new(
                [t171, t172, c(0.0)],
                [
                    [elbow_axes_x_x, -minus_elbow_axes_x_y, c(0.0)],
                    [minus_elbow_axes_x_y, elbow_axes_x_x, c(0.0)],
                    [c(0.0), c(0.0), c(1.0)],
                ],
                [-t174, t176, c(0.0)],
                [c(0.0), c(0.0), elbow_omega_z],
                ::mstmm::StateVector::new(
                    [-t180, -t184, c(0.0)],
                    [c(0.0), c(0.0), -minus_elbow_acc_ang_z],
                    [c(0.0), c(0.0), c(0.0)],
                    [c(0.0), c(0.0), c(0.0)],
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
    pub fn energy(&self, state: &TwoPinsState<T>) -> ::mstmm::Energy<T> {
        let c = T::constant;
        let [[shoulder_angle, elbow_angle]] = state.q.data.0;
        let [[shoulder_rate, elbow_rate]] = state.v.data.0;
        /// Motion across `shoulder`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 2 sin/cos.
        let (
            [sin_shoulder_angle,
            sin_elbow_angle,
            ],
            [cos_shoulder_angle,
            cos_elbow_angle,
            ],
        ) = T::sin_cos([shoulder_angle, elbow_angle]);
        /// Motion across `elbow`, [P, Eqs. (1), (13), (36)]: 4 mul, 3 add, 0 reciprocal.
        let t0 = cos_shoulder_angle * cos_elbow_angle;
        let t1 = sin_shoulder_angle * sin_elbow_angle;
        let elbow_axes_x_x = t0 - t1;
        let t2 = cos_shoulder_angle * sin_elbow_angle;
        let t3 = sin_shoulder_angle * cos_elbow_angle;
        let minus_elbow_axes_x_y = t2 + t3;
        let elbow_omega_z = shoulder_rate + elbow_rate;
        /// Results: 21 mul, 9 add, 0 reciprocal.
        let t4 = cos_shoulder_angle * c(0.5);
        let t5 = sin_shoulder_angle * c(0.5);
        let t6 = shoulder_rate * sin_shoulder_angle;
        let t7 = shoulder_rate * cos_shoulder_angle;
        let t8 = c(0.5) * elbow_axes_x_x;
        let t9 = c(0.5) * minus_elbow_axes_x_y;
        let t10 = shoulder_rate * t5;
        let t11 = shoulder_rate * t4;
        let t12 = shoulder_rate * c(0.08333333333333333);
        let t13 = shoulder_rate * t12;
        let t14 = t10 * t10;
        let t15 = t11 * t11;
        let t16 = t14 + t15;
        let t17 = t13 + t16;
        let t18 = elbow_omega_z * t9;
        let t19 = elbow_omega_z * t8;
        let t20 = t6 + t18;
        let t21 = t7 + t19;
        let t22 = elbow_omega_z * c(0.08333333333333333);
        let t23 = elbow_omega_z * t22;
        let t24 = t20 * t20;
        let t25 = t21 * t21;
        let t26 = t24 + t25;
        let t27 = t23 + t26;
        let t28 = t17 + t27;
        let t29 = c(0.5) * t28;
        let t30 = sin_shoulder_angle * c(4.9);
        let t31 = sin_shoulder_angle + t9;
        let t32 = c(9.8) * t31;
        let t33 = t30 + t32;
        ::mstmm::Energy {
            kinetic: t29,
            potential: t33,
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
        state: &TwoPinsState<T>,
        inputs: &TwoPinsInputs<T>,
        rate: &mut TwoPinsState<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.accelerations_into(state, inputs, &mut rate.v)?;
        self.configuration_rate_into(state, rate);
        ::core::result::Result::Ok(())
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn configuration_rate_into(
        &self,
        state: &TwoPinsState<T>,
        rate: &mut TwoPinsState<T>,
    ) {
        rate.q.data.0 = {
            let [[shoulder_rate, elbow_rate]] = state.v.data.0;
            [[shoulder_rate, elbow_rate]]
        };
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn normalize(&self, state: &mut TwoPinsState<T>) {
        state.q.data.0 = {
            let [[shoulder_angle, elbow_angle]] = state.q.data.0;
            [[shoulder_angle, elbow_angle]]
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
        state: &TwoPinsState<T>,
        inputs: &TwoPinsInputs<T>,
        at: &mut TwoPinsWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.solve_into(state, inputs, at)
    }
    #[inline]
    fn energy(&self, state: &TwoPinsState<T>) -> ::mstmm::Energy<T> {
        self.energy(state)
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
        let [[q0, ..]] = self.q.data.0;
        let [[v0, ..]] = self.v.data.0;
        ::mstmm::PinState::new(q0, v0)
    }
    /// Coordinates and rates of hinge `shoulder`, to be changed.
    #[inline]
    pub fn shoulder_mut(&mut self) -> ::mstmm::PinStateMut<'_, T> {
        let [[q0, ..]] = &mut self.q.data.0;
        let [[v0, ..]] = &mut self.v.data.0;
        ::mstmm::PinStateMut::new(q0, v0)
    }
    /// Coordinates and rates of hinge `elbow`.
    #[inline]
    #[must_use]
    pub fn elbow(&self) -> ::mstmm::PinState<T> {
        let [[_, q1, ..]] = self.q.data.0;
        let [[_, v1, ..]] = self.v.data.0;
        ::mstmm::PinState::new(q1, v1)
    }
    /// Coordinates and rates of hinge `elbow`, to be changed.
    #[inline]
    pub fn elbow_mut(&mut self) -> ::mstmm::PinStateMut<'_, T> {
        let [[_, q1, ..]] = &mut self.q.data.0;
        let [[_, v1, ..]] = &mut self.v.data.0;
        ::mstmm::PinStateMut::new(q1, v1)
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for TwoPinsState<T> {
    fn default() -> Self {
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        let _ = one;
        Self {
            q: ::mstmm::generated::vector([zero, zero]),
            v: ::mstmm::generated::vector([zero; 2]),
            t: zero,
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
    fn set_time(&mut self, time: T) {
        self.t = time;
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
        let [input, output, ..] = &self.points;
        ::mstmm::HingeResult::new(
            {
                let [value] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.rate_accelerations.as_slice(), 0);
                value
            },
            {
                let [value] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.efforts.as_slice(), 0);
                value
            },
            input,
            output,
        )
    }
    /// Input and output of body `upper`.
    #[inline]
    pub fn upper(&self) -> ::mstmm::BodyResult<'_, T, ::mstmm::Point<T>> {
        let [_, input, output, ..] = &self.points;
        ::mstmm::BodyResult::new(input, output)
    }
    /// Acceleration, effort, input and output of hinge `elbow`.
    #[inline]
    pub fn elbow(&self) -> ::mstmm::HingeResult<'_, T, T, ::mstmm::Point<T>> {
        let [_, _, input, output, ..] = &self.points;
        ::mstmm::HingeResult::new(
            {
                let [value] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.rate_accelerations.as_slice(), 1);
                value
            },
            {
                let [value] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.efforts.as_slice(), 1);
                value
            },
            input,
            output,
        )
    }
    /// Input and output of body `lower`.
    #[inline]
    pub fn lower(&self) -> ::mstmm::BodyResult<'_, T, ::mstmm::Point<T>> {
        let [_, _, _, input, output, ..] = &self.points;
        ::mstmm::BodyResult::new(input, output)
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TwoPins<T> {
    /// Room for the results of [`solve_into`](Self::solve_into).
    #[must_use]
    pub fn workspace(&self) -> TwoPinsWorkspace<T> {
        let zero = T::constant(0.0);
        TwoPinsWorkspace {
            accelerations: ::mstmm::generated::vector([zero; 2]),
            rate_accelerations: ::mstmm::generated::vector([zero; 2]),
            efforts: ::mstmm::generated::vector([zero; 2]),
            kinetic_energy: zero,
            potential_energy: zero,
            points: [::core::default::Default::default(); 5],
        }
    }
}
