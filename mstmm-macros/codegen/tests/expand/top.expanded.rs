/// A top on a ball and socket.
///
/// # The chain
///
/// `ground -> ball tip -> cone`
///
/// | element | kind | freedoms |
/// |---|---|---|
/// | `tip` | ball | 3 |
/// | `cone` | body `Cone` |  |
///
/// 3 degrees of freedom; accelerations by `riccati`, 28 operations (21 mul, 7 add, 0 reciprocal); with everything at every connection point 149 operations.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
struct Top<T> {
    parameters: TopParameters<T>,
    derived: [T; 0],
}
/// Numbers of [`Top`] that may change at run time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
struct TopParameters<T> {
    none: ::core::marker::PhantomData<T>,
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TopParameters<T> {}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> Top<T> {
    /// The chain as described.
    #[inline]
    #[must_use]
    #[allow(clippy::all)]
    fn new() -> Self {
        let parameters = TopParameters {
            none: ::core::marker::PhantomData,
        };
        let (chain, _) = Self::derive(parameters);
        chain
    }
    /// The numbers that may change at run time.
    #[inline]
    fn parameters(&self) -> &TopParameters<T> {
        &self.parameters
    }
    /// The state that the description starts from, at time zero.
    #[must_use]
    #[allow(unused_doc_comments, clippy::all)]
    fn initial_state(&self) -> TopState<T> {
        let c = T::constant;
        TopState {
            q: ::mstmm::generated::vector([
                c(0.9961946980917455),
                c(0.08715574274765817),
                c(0.0),
                c(0.0),
            ]),
            v: ::mstmm::generated::vector([c(0.0), c(0.0), c(300.0)]),
            t: T::constant(0.0),
        }
    }
    /// Quantities derived from parameters and constants: 0 mul, 0 add, 0 reciprocal.
    #[allow(unused_doc_comments, unused_variables, unused_mut, clippy::all)]
    fn derive(parameters: TopParameters<T>) -> (Self, [T; 0]) {
        let (derived, checks) = ([], []);
        (Self { parameters, derived }, checks)
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for Top<T> {
    fn default() -> Self {
        Self::new()
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> Top<T> {
    /// The accelerations `v̇` of all hinges, in the order of the rates: the fast path.
    ///
    /// 28 operations: 21 mul, 7 add, 0 reciprocal.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `tip` | \[P, Eqs. (1), (13), (36)\] | 7 | 2 | 0 | 0 | 0 |
    /// | Riccati transfer over `tip` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 9 | 3 | 0 | 0 | 0 |
    /// | Acceleration of `tip` | \[P, Eqs. (13), (36), (44)\] | 5 | 2 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// [`Error::Singular`](::mstmm::Error::Singular) if nothing with inertia lies beyond a
    /// hinge, [`Error::NotFinite`](::mstmm::Error::NotFinite) if a number of the state or the
    /// inputs is not finite. `accelerations` is not touched then.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn accelerations_into(
        &self,
        state: &TopState<T>,
        inputs: &TopInputs<T>,
        accelerations: &mut ::mstmm::nalgebra::SVector<T, 3>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let c = T::constant;
        let [[tip_qw, tip_qx, tip_qy, tip_qz]] = state.q.data.0;
        let [[tip_wx, tip_wy, tip_wz]] = state.v.data.0;
        /// Motion across `tip`, [P, Eqs. (1), (13), (36)]: 7 mul, 2 add, 0 reciprocal.
        let t0 = tip_qy * c(2.0);
        let t1 = tip_qz * c(2.0);
        let t2 = tip_qw * t0;
        let t3 = tip_qx * t1;
        let minus_tip_turn_z_x = t2 - t3;
        let t4 = tip_qx * c(2.0);
        let t5 = tip_qw * t4;
        let t6 = tip_qy * t1;
        let tip_turn_z_y = t5 + t6;
        /// Riccati transfer over `tip`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 9 mul, 3 add, 0 reciprocal.
        let t7 = tip_wy * c(0.001);
        let t8 = tip_wz * c(0.0001);
        let t9 = tip_wy * t8;
        let t10 = tip_wz * t7;
        let tip_e_moment_x = t9 - t10;
        let t11 = tip_wx * c(0.001);
        let t12 = tip_wz * t11;
        let t13 = tip_wx * t8;
        let tip_e_moment_y = t12 - t13;
        let t14 = tip_wx * t7;
        let t15 = tip_wy * t11;
        let tip_e_moment_z = t14 - t15;
        /// Acceleration of `tip`, [P, Eqs. (13), (36), (44)]: 5 mul, 2 add, 0 reciprocal.
        let t16 = tip_e_moment_x * c(1000.0);
        let t17 = tip_turn_z_y * c(117.60000000000001);
        let minus_tip_a_ang_x = t16 - t17;
        let t18 = tip_e_moment_y * c(1000.0);
        let t19 = minus_tip_turn_z_x * c(117.60000000000001);
        let minus_tip_a_ang_y = t18 - t19;
        let minus_tip_a_ang_z = tip_e_moment_z * c(10000.0);
        ::mstmm::generated::finite::<T>(&[state.q.as_slice(), state.v.as_slice()])?;
        ::mstmm::generated::regular::<
            T,
            _,
            _,
        >(&[], [], [], [-minus_tip_a_ang_x, -minus_tip_a_ang_y, -minus_tip_a_ang_z])?;
        accelerations.data.0 = [
            [-minus_tip_a_ang_x, -minus_tip_a_ang_y, -minus_tip_a_ang_z],
        ];
        ::core::result::Result::Ok(())
    }
    /// The accelerations `v̇` of all hinges by value; see
    /// [`accelerations_into`](Self::accelerations_into).
    ///
    /// # Errors
    ///
    /// As [`accelerations_into`](Self::accelerations_into).
    #[inline]
    fn accelerations(
        &self,
        state: &TopState<T>,
        inputs: &TopInputs<T>,
    ) -> ::core::result::Result<::mstmm::nalgebra::SVector<T, 3>, ::mstmm::Error> {
        let mut accelerations = ::mstmm::generated::vector([T::constant(0.0); 3]);
        self.accelerations_into(state, inputs, &mut accelerations)?;
        ::core::result::Result::Ok(accelerations)
    }
    /// Everything: accelerations, efforts, energies and, at every connection point, pose,
    /// velocity and the state vector `z`, written into `at`.
    ///
    /// 149 operations: 94 mul, 55 add, 0 reciprocal.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `tip` | \[P, Eqs. (1), (13), (36)\] | 12 | 12 | 0 | 0 | 0 |
    /// | Riccati transfer over `tip` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 15 | 4 | 0 | 0 | 0 |
    /// | Acceleration of `tip` | \[P, Eqs. (13), (36), (44)\] | 5 | 2 | 0 | 0 | 0 |
    /// | Motion across `tip` | \[P, Eqs. (1), (13), (36)\] | 9 | 6 | 0 | 0 | 0 |
    /// | Point of `tip` | \[P, Eqs. (12), (13), (36)\] | 9 | 6 | 0 | 0 | 0 |
    /// | Load of the body at `tip` | \[P, Eqs. (18), (19)\] | 14 | 11 | 0 | 0 | 0 |
    /// | Results |  | 30 | 14 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// As [`accelerations_into`](Self::accelerations_into); `at` is not touched then.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn solve_into(
        &self,
        state: &TopState<T>,
        inputs: &TopInputs<T>,
        at: &mut TopWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let c = T::constant;
        let [[tip_qw, tip_qx, tip_qy, tip_qz]] = state.q.data.0;
        let [[tip_wx, tip_wy, tip_wz]] = state.v.data.0;
        /// Motion across `tip`, [P, Eqs. (1), (13), (36)]: 12 mul, 12 add, 0 reciprocal.
        let t0 = tip_qy * c(2.0);
        let t1 = tip_qz * c(2.0);
        let t2 = tip_qy * t0;
        let t3 = tip_qz * t1;
        let t4 = t2 + t3;
        let minus_tip_turn_x_x = t4 - c(1.0);
        let t5 = tip_qw * t1;
        let t6 = tip_qx * t0;
        let minus_tip_turn_x_y = t5 - t6;
        let t7 = tip_qw * t0;
        let t8 = tip_qx * t1;
        let tip_turn_x_z = t7 + t8;
        let tip_turn_y_x = t5 + t6;
        let t9 = tip_qx * c(2.0);
        let t10 = tip_qx * t9;
        let t11 = t10 + t3;
        let tip_turn_y_y = c(1.0) - t11;
        let t12 = tip_qw * t9;
        let t13 = tip_qy * t1;
        let minus_tip_turn_y_z = t12 - t13;
        let minus_tip_turn_z_x = t7 - t8;
        let tip_turn_z_y = t12 + t13;
        let t14 = t10 + t2;
        let tip_turn_z_z = c(1.0) - t14;
        /// Riccati transfer over `tip`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 15 mul, 4 add, 0 reciprocal.
        let t15 = tip_wx * c(0.012);
        let tip_e_force_x = tip_wz * t15;
        let t16 = tip_wy * c(0.012);
        let tip_e_force_y = tip_wz * t16;
        let t17 = tip_wx * t15;
        let t18 = tip_wy * t16;
        let minus_tip_e_force_z = t17 + t18;
        let t19 = tip_wy * c(0.001);
        let t20 = tip_wz * c(0.0001);
        let t21 = tip_wy * t20;
        let t22 = tip_wz * t19;
        let tip_e_moment_x = t21 - t22;
        let t23 = tip_wx * c(0.001);
        let t24 = tip_wz * t23;
        let t25 = tip_wx * t20;
        let tip_e_moment_y = t24 - t25;
        let t26 = tip_wx * t19;
        let t27 = tip_wy * t23;
        let tip_e_moment_z = t26 - t27;
        /// Acceleration of `tip`, [P, Eqs. (13), (36), (44)]: 5 mul, 2 add, 0 reciprocal.
        let t28 = tip_e_moment_x * c(1000.0);
        let t29 = tip_turn_z_y * c(117.60000000000001);
        let minus_tip_a_ang_x = t28 - t29;
        let t30 = tip_e_moment_y * c(1000.0);
        let t31 = minus_tip_turn_z_x * c(117.60000000000001);
        let minus_tip_a_ang_y = t30 - t31;
        let minus_tip_a_ang_z = tip_e_moment_z * c(10000.0);
        /// Motion across `tip`, [P, Eqs. (1), (13), (36)]: 9 mul, 6 add, 0 reciprocal.
        let t32 = tip_wx * minus_tip_turn_x_x;
        let t33 = tip_wy * minus_tip_turn_x_y;
        let t34 = t32 + t33;
        let t35 = tip_wz * tip_turn_x_z;
        let minus_tip_omega_x = t34 - t35;
        let t36 = tip_wx * tip_turn_y_x;
        let t37 = tip_wy * tip_turn_y_y;
        let t38 = t36 + t37;
        let t39 = tip_wz * minus_tip_turn_y_z;
        let tip_omega_y = t38 - t39;
        let t40 = tip_wx * minus_tip_turn_z_x;
        let t41 = tip_wy * tip_turn_z_y;
        let t42 = t40 - t41;
        let t43 = tip_wz * tip_turn_z_z;
        let minus_tip_omega_z = t42 - t43;
        /// Point of `tip`, [P, Eqs. (12), (13), (36)]: 9 mul, 6 add, 0 reciprocal.
        let t44 = minus_tip_turn_x_x * minus_tip_a_ang_x;
        let t45 = minus_tip_turn_x_y * minus_tip_a_ang_y;
        let t46 = t44 + t45;
        let t47 = tip_turn_x_z * minus_tip_a_ang_z;
        let tip_acc_ang_x = t46 - t47;
        let t48 = tip_turn_y_x * minus_tip_a_ang_x;
        let t49 = tip_turn_y_y * minus_tip_a_ang_y;
        let t50 = t48 + t49;
        let t51 = minus_tip_turn_y_z * minus_tip_a_ang_z;
        let minus_tip_acc_ang_y = t50 - t51;
        let t52 = minus_tip_turn_z_x * minus_tip_a_ang_x;
        let t53 = tip_turn_z_y * minus_tip_a_ang_y;
        let t54 = t52 - t53;
        let t55 = tip_turn_z_z * minus_tip_a_ang_z;
        let tip_acc_ang_z = t54 - t55;
        /// Load of the body at `tip`, [P, Eqs. (18), (19)]: 14 mul, 11 add, 0 reciprocal.
        let t56 = minus_tip_turn_z_x * c(1.9600000000000002);
        let t57 = tip_turn_z_y * c(1.9600000000000002);
        let t58 = tip_turn_z_z * c(1.9600000000000002);
        let t59 = minus_tip_e_force_z - t58;
        let t60 = c(0.012) * minus_tip_a_ang_y;
        let t61 = c(0.012) * minus_tip_a_ang_x;
        let t62 = t56 + t60;
        let t63 = t57 + t61;
        let t64 = tip_e_force_x - t62;
        let t65 = tip_e_force_y + t63;
        let t66 = minus_tip_turn_x_x * t64;
        let t67 = minus_tip_turn_x_y * t65;
        let t68 = t66 + t67;
        let t69 = tip_turn_x_z * t59;
        let minus_tip_own_force_x = t68 + t69;
        let t70 = tip_turn_y_x * t64;
        let t71 = tip_turn_y_y * t65;
        let t72 = t70 + t71;
        let t73 = minus_tip_turn_y_z * t59;
        let tip_own_force_y = t72 + t73;
        let t74 = minus_tip_turn_z_x * t64;
        let t75 = tip_turn_z_y * t65;
        let t76 = t74 - t75;
        let t77 = tip_turn_z_z * t59;
        let minus_tip_own_force_z = t76 + t77;
        /// Results: 30 mul, 14 add, 0 reciprocal.
        let t78 = tip_turn_x_z * c(0.06);
        let t79 = minus_tip_turn_y_z * c(0.06);
        let t80 = tip_turn_z_z * c(0.06);
        let t81 = tip_omega_y * t80;
        let t82 = minus_tip_omega_z * t79;
        let t83 = t81 - t82;
        let t84 = minus_tip_omega_z * t78;
        let t85 = minus_tip_omega_x * t80;
        let t86 = t84 - t85;
        let t87 = minus_tip_omega_x * t79;
        let t88 = tip_omega_y * t78;
        let t89 = t87 - t88;
        let t90 = minus_tip_turn_x_x * minus_tip_omega_x;
        let t91 = tip_turn_y_x * tip_omega_y;
        let t92 = t90 + t91;
        let t93 = minus_tip_turn_z_x * minus_tip_omega_z;
        let t94 = t92 + t93;
        let t95 = minus_tip_turn_x_y * minus_tip_omega_x;
        let t96 = tip_turn_y_y * tip_omega_y;
        let t97 = t95 + t96;
        let t98 = tip_turn_z_y * minus_tip_omega_z;
        let t99 = t97 - t98;
        let t100 = tip_turn_x_z * minus_tip_omega_x;
        let t101 = minus_tip_turn_y_z * tip_omega_y;
        let t102 = t100 + t101;
        let t103 = tip_turn_z_z * minus_tip_omega_z;
        let t104 = t102 + t103;
        let t105 = t94 * c(0.0002800000000000001);
        let t106 = t99 * c(0.0002800000000000001);
        let t107 = c(0.0001) * t104;
        let t108 = t94 * t105;
        let t109 = t99 * t106;
        let t110 = t108 + t109;
        let t111 = t104 * t107;
        let t112 = t110 + t111;
        let t113 = t83 * t83;
        let t114 = t86 * t86;
        let t115 = t113 + t114;
        let t116 = t89 * t89;
        let t117 = t115 + t116;
        let t118 = t117 * c(0.2);
        let t119 = t112 + t118;
        let t120 = t119 * c(0.5);
        let t121 = tip_turn_z_z * c(0.1176);
        ::mstmm::generated::finite::<T>(&[state.q.as_slice(), state.v.as_slice()])?;
        ::mstmm::generated::regular::<
            T,
            _,
            _,
        >(&[], [], [], [-minus_tip_a_ang_x, -minus_tip_a_ang_y, -minus_tip_a_ang_z])?;
        at.accelerations.data.0 = [
            [-minus_tip_a_ang_x, -minus_tip_a_ang_y, -minus_tip_a_ang_z],
        ];
        at.rate_accelerations.data.0 = [
            [-minus_tip_a_ang_x, -minus_tip_a_ang_y, -minus_tip_a_ang_z],
        ];
        at.efforts.data.0 = [[c(0.0), c(0.0), c(0.0)]];
        at.kinetic_energy = t120;
        at.potential_energy = t121;
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
                    [-minus_tip_own_force_x, tip_own_force_y, -minus_tip_own_force_z],
                ),
            ),
            ::mstmm::Point::new(
                [c(0.0), c(0.0), c(0.0)],
                [
                    [-minus_tip_turn_x_x, -minus_tip_turn_x_y, tip_turn_x_z],
                    [tip_turn_y_x, tip_turn_y_y, -minus_tip_turn_y_z],
                    [-minus_tip_turn_z_x, tip_turn_z_y, tip_turn_z_z],
                ],
                [c(0.0), c(0.0), c(0.0)],
                [-minus_tip_omega_x, tip_omega_y, -minus_tip_omega_z],
                ::mstmm::StateVector::new(
                    [c(0.0), c(0.0), c(0.0)],
                    [tip_acc_ang_x, -minus_tip_acc_ang_y, tip_acc_ang_z],
                    [c(0.0), c(0.0), c(0.0)],
                    [-minus_tip_own_force_x, tip_own_force_y, -minus_tip_own_force_z],
                ),
            ),
            ::mstmm::Point::new(
                [c(0.0), c(0.0), c(0.0)],
                [
                    [-minus_tip_turn_x_x, -minus_tip_turn_x_y, tip_turn_x_z],
                    [tip_turn_y_x, tip_turn_y_y, -minus_tip_turn_y_z],
                    [-minus_tip_turn_z_x, tip_turn_z_y, tip_turn_z_z],
                ],
                [c(0.0), c(0.0), c(0.0)],
                [-minus_tip_omega_x, tip_omega_y, -minus_tip_omega_z],
                ::mstmm::StateVector::new(
                    [c(0.0), c(0.0), c(0.0)],
                    [tip_acc_ang_x, -minus_tip_acc_ang_y, tip_acc_ang_z],
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
    /// 83 operations: 51 mul, 32 add, 0 reciprocal.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `tip` | \[P, Eqs. (1), (13), (36)\] | 21 | 18 | 0 | 0 | 0 |
    /// | Results |  | 30 | 14 | 0 | 0 | 0 |
    #[must_use]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn energy(&self, state: &TopState<T>) -> ::mstmm::Energy<T> {
        let c = T::constant;
        let [[tip_qw, tip_qx, tip_qy, tip_qz]] = state.q.data.0;
        let [[tip_wx, tip_wy, tip_wz]] = state.v.data.0;
        /// Motion across `tip`, [P, Eqs. (1), (13), (36)]: 21 mul, 18 add, 0 reciprocal.
        let t0 = tip_qy * c(2.0);
        let t1 = tip_qz * c(2.0);
        let t2 = tip_qy * t0;
        let t3 = tip_qz * t1;
        let t4 = t2 + t3;
        let minus_tip_axes_x_x = t4 - c(1.0);
        let t5 = tip_qw * t1;
        let t6 = tip_qx * t0;
        let minus_tip_axes_x_y = t5 - t6;
        let t7 = tip_qw * t0;
        let t8 = tip_qx * t1;
        let tip_axes_x_z = t7 + t8;
        let tip_axes_y_x = t5 + t6;
        let t9 = tip_qx * c(2.0);
        let t10 = tip_qx * t9;
        let t11 = t10 + t3;
        let tip_axes_y_y = c(1.0) - t11;
        let t12 = tip_qw * t9;
        let t13 = tip_qy * t1;
        let minus_tip_axes_y_z = t12 - t13;
        let minus_tip_axes_z_x = t7 - t8;
        let tip_axes_z_y = t12 + t13;
        let t14 = t10 + t2;
        let tip_axes_z_z = c(1.0) - t14;
        let t15 = tip_wx * minus_tip_axes_x_x;
        let t16 = tip_wy * minus_tip_axes_x_y;
        let t17 = t15 + t16;
        let t18 = tip_wz * tip_axes_x_z;
        let minus_tip_omega_x = t17 - t18;
        let t19 = tip_wx * tip_axes_y_x;
        let t20 = tip_wy * tip_axes_y_y;
        let t21 = t19 + t20;
        let t22 = tip_wz * minus_tip_axes_y_z;
        let tip_omega_y = t21 - t22;
        let t23 = tip_wx * minus_tip_axes_z_x;
        let t24 = tip_wy * tip_axes_z_y;
        let t25 = t23 - t24;
        let t26 = tip_wz * tip_axes_z_z;
        let minus_tip_omega_z = t25 - t26;
        /// Results: 30 mul, 14 add, 0 reciprocal.
        let t27 = tip_axes_x_z * c(0.06);
        let t28 = minus_tip_axes_y_z * c(0.06);
        let t29 = tip_axes_z_z * c(0.06);
        let t30 = tip_omega_y * t29;
        let t31 = minus_tip_omega_z * t28;
        let t32 = t30 - t31;
        let t33 = minus_tip_omega_z * t27;
        let t34 = minus_tip_omega_x * t29;
        let t35 = t33 - t34;
        let t36 = minus_tip_omega_x * t28;
        let t37 = tip_omega_y * t27;
        let t38 = t36 - t37;
        let t39 = minus_tip_axes_x_x * minus_tip_omega_x;
        let t40 = tip_axes_y_x * tip_omega_y;
        let t41 = t39 + t40;
        let t42 = minus_tip_axes_z_x * minus_tip_omega_z;
        let t43 = t41 + t42;
        let t44 = minus_tip_axes_x_y * minus_tip_omega_x;
        let t45 = tip_axes_y_y * tip_omega_y;
        let t46 = t44 + t45;
        let t47 = tip_axes_z_y * minus_tip_omega_z;
        let t48 = t46 - t47;
        let t49 = tip_axes_x_z * minus_tip_omega_x;
        let t50 = minus_tip_axes_y_z * tip_omega_y;
        let t51 = t49 + t50;
        let t52 = tip_axes_z_z * minus_tip_omega_z;
        let t53 = t51 + t52;
        let t54 = t43 * c(0.0002800000000000001);
        let t55 = t48 * c(0.0002800000000000001);
        let t56 = c(0.0001) * t53;
        let t57 = t43 * t54;
        let t58 = t48 * t55;
        let t59 = t57 + t58;
        let t60 = t53 * t56;
        let t61 = t59 + t60;
        let t62 = t32 * t32;
        let t63 = t35 * t35;
        let t64 = t62 + t63;
        let t65 = t38 * t38;
        let t66 = t64 + t65;
        let t67 = t66 * c(0.2);
        let t68 = t61 + t67;
        let t69 = t68 * c(0.5);
        let t70 = tip_axes_z_z * c(0.1176);
        ::mstmm::Energy {
            kinetic: t69,
            potential: t70,
        }
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::Chain for Top<T> {
    type Scalar = T;
    type State = TopState<T>;
    type Inputs = TopInputs<T>;
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn derivative_into(
        &self,
        state: &TopState<T>,
        inputs: &TopInputs<T>,
        rate: &mut TopState<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.accelerations_into(state, inputs, &mut rate.v)?;
        self.configuration_rate_into(state, rate);
        ::core::result::Result::Ok(())
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn configuration_rate_into(&self, state: &TopState<T>, rate: &mut TopState<T>) {
        rate.q.data.0 = {
            let c = T::constant;
            let [[tip_qw, tip_qx, tip_qy, tip_qz]] = state.q.data.0;
            let [[tip_wx, tip_wy, tip_wz]] = state.v.data.0;
            /// Results: 15 mul, 8 add, 0 reciprocal.
            let t0 = tip_wx * c(0.5);
            let t1 = tip_wy * c(0.5);
            let t2 = tip_wz * c(0.5);
            let t3 = tip_qx * t0;
            let t4 = tip_qy * t1;
            let t5 = t3 + t4;
            let t6 = tip_qz * t2;
            let t7 = t5 + t6;
            let t8 = tip_qw * t0;
            let t9 = tip_qy * t2;
            let t10 = tip_qz * t1;
            let t11 = t9 - t10;
            let t12 = t8 + t11;
            let t13 = tip_qw * t1;
            let t14 = tip_qz * t0;
            let t15 = tip_qx * t2;
            let t16 = t14 - t15;
            let t17 = t13 + t16;
            let t18 = tip_qw * t2;
            let t19 = tip_qx * t1;
            let t20 = tip_qy * t0;
            let t21 = t19 - t20;
            let t22 = t18 + t21;
            [[-t7, t12, t17, t22]]
        };
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn normalize(&self, state: &mut TopState<T>) {
        state.q.data.0 = {
            let [[tip_qw, tip_qx, tip_qy, tip_qz]] = state.q.data.0;
            /// Results: 8 mul, 3 add, 1 reciprocal, 1 square root.
            let t0 = tip_qw * tip_qw;
            let t1 = tip_qx * tip_qx;
            let t2 = t0 + t1;
            let t3 = tip_qy * tip_qy;
            let t4 = t2 + t3;
            let t5 = tip_qz * tip_qz;
            let t6 = t4 + t5;
            let t7 = T::sqrt(t6);
            let t8 = T::recip(t7);
            let t9 = tip_qw * t8;
            let t10 = tip_qx * t8;
            let t11 = tip_qy * t8;
            let t12 = tip_qz * t8;
            [[t9, t10, t11, t12]]
        };
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::GeneratedChain for Top<T> {
    type Workspace = TopWorkspace<T>;
    #[inline]
    fn initial_state(&self) -> TopState<T> {
        self.initial_state()
    }
    #[inline]
    fn no_inputs(&self) -> TopInputs<T> {
        self.no_inputs()
    }
    #[inline]
    fn workspace(&self) -> TopWorkspace<T> {
        self.workspace()
    }
    #[inline]
    fn solve_into(
        &self,
        state: &TopState<T>,
        inputs: &TopInputs<T>,
        at: &mut TopWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.solve_into(state, inputs, at)
    }
    #[inline]
    fn energy(&self, state: &TopState<T>) -> ::mstmm::Energy<T> {
        self.energy(state)
    }
}
/// Coordinates and rates of [`Top`] at a time.
///
/// The hinges lie one after the other in the order written. [`Default`] is every hinge at
/// rest in its zero position.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
struct TopState<T> {
    /// Coordinates: angles in rad, lengths in m, unit quaternions as w, x, y, z.
    q: ::mstmm::nalgebra::SVector<T, 4>,
    /// Rates in rad/s and m/s.
    v: ::mstmm::nalgebra::SVector<T, 3>,
    /// Time in s.
    t: T,
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TopState<T> {
    /// Coordinates and rates of hinge `tip`.
    #[inline]
    #[must_use]
    fn tip(&self) -> ::mstmm::BallState<T> {
        let [[q0, q1, q2, q3, ..]] = self.q.data.0;
        let [[v0, v1, v2, ..]] = self.v.data.0;
        ::mstmm::BallState::new([q0, q1, q2, q3], [v0, v1, v2])
    }
    /// Coordinates and rates of hinge `tip`, to be changed.
    #[inline]
    fn tip_mut(&mut self) -> ::mstmm::BallStateMut<'_, T> {
        let [[q0, q1, q2, q3, ..]] = &mut self.q.data.0;
        let [[v0, v1, v2, ..]] = &mut self.v.data.0;
        ::mstmm::BallStateMut::new([q0, q1, q2, q3], [v0, v1, v2])
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for TopState<T> {
    fn default() -> Self {
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        let _ = one;
        Self {
            q: ::mstmm::generated::vector([one, zero, zero, zero]),
            v: ::mstmm::generated::vector([zero; 3]),
            t: zero,
        }
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::ChainState for TopState<T> {
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
/// What drives [`Top`] from outside, given at every step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
struct TopInputs<T> {
    none: ::core::marker::PhantomData<T>,
}
impl<T: ::mstmm::Scalar> ::core::default::Default for TopInputs<T> {
    #[inline]
    fn default() -> Self {
        Self {
            none: ::core::marker::PhantomData,
        }
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> Top<T> {
    /// Inputs that are all zero; prescribed motions rest in the zero position.
    #[inline]
    #[must_use]
    fn no_inputs(&self) -> TopInputs<T> {
        ::core::default::Default::default()
    }
}
/// Results of [`Top::solve_into`].
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
struct TopWorkspace<T> {
    accelerations: ::mstmm::nalgebra::SVector<T, 3>,
    rate_accelerations: ::mstmm::nalgebra::SVector<T, 3>,
    efforts: ::mstmm::nalgebra::SVector<T, 3>,
    kinetic_energy: T,
    potential_energy: T,
    points: [::mstmm::Point<T>; 3],
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TopWorkspace<T> {
    /// Accelerations `v̇` of all hinges, in the order of the rates.
    #[inline]
    fn accelerations(&self) -> &::mstmm::nalgebra::SVector<T, 3> {
        &self.accelerations
    }
    /// Kinetic energy in J.
    #[inline]
    fn kinetic_energy(&self) -> T {
        self.kinetic_energy
    }
    /// Potential energy in J: of gravity, zero with every centre of mass at the inertial
    /// origin, and of springs.
    #[inline]
    fn potential_energy(&self) -> T {
        self.potential_energy
    }
    /// All connection points in the order written: the first element's input, then every
    /// element's output.
    #[inline]
    fn points(&self) -> &[::mstmm::Point<T>; 3] {
        &self.points
    }
    /// Acceleration, effort, input and output of hinge `tip`.
    #[inline]
    fn tip(
        &self,
    ) -> ::mstmm::HingeResult<
        '_,
        T,
        ::mstmm::nalgebra::SVector<T, 3usize>,
        ::mstmm::Point<T>,
    > {
        let [input, output, ..] = &self.points;
        ::mstmm::HingeResult::new(
            ::mstmm::generated::vector(
                ::mstmm::generated::piece::<T, 3>(self.rate_accelerations.as_slice(), 0),
            ),
            ::mstmm::generated::vector(
                ::mstmm::generated::piece::<T, 3>(self.efforts.as_slice(), 0),
            ),
            input,
            output,
        )
    }
    /// Input and output of body `cone`.
    #[inline]
    fn cone(&self) -> ::mstmm::BodyResult<'_, T, ::mstmm::Point<T>> {
        let [_, input, output, ..] = &self.points;
        ::mstmm::BodyResult::new(input, output)
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> Top<T> {
    /// Room for the results of [`solve_into`](Self::solve_into).
    #[must_use]
    fn workspace(&self) -> TopWorkspace<T> {
        let zero = T::constant(0.0);
        TopWorkspace {
            accelerations: ::mstmm::generated::vector([zero; 3]),
            rate_accelerations: ::mstmm::generated::vector([zero; 3]),
            efforts: ::mstmm::generated::vector([zero; 3]),
            kinetic_energy: zero,
            potential_energy: zero,
            points: [::core::default::Default::default(); 3],
        }
    }
}
