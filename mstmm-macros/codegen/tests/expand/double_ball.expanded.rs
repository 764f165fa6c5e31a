/// Two cubes of the paper's section 4.1.
///
/// # The chain
///
/// `ground -> ball shoulder -> upper -> ball elbow -> lower`
///
/// | element | kind | freedoms |
/// |---|---|---|
/// | `shoulder` | ball | 3 |
/// | `upper` | body `Cube` |  |
/// | `elbow` | ball | 3 |
/// | `lower` | body `Cube` |  |
///
/// 6 degrees of freedom; accelerations by `riccati`, 250 operations (147 mul, 101 add, 2 reciprocal); with everything at every connection point 787 operations.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code)]
struct DoubleBall<T> {
    parameters: DoubleBallParameters<T>,
    derived: [T; 0],
}
/// Numbers of [`DoubleBall`] that may change at run time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(dead_code)]
struct DoubleBallParameters<T> {
    none: ::core::marker::PhantomData<T>,
}
#[allow(dead_code)]
impl<T: ::mstmm::Scalar> DoubleBallParameters<T> {}
#[allow(dead_code)]
impl<T: ::mstmm::Scalar> DoubleBall<T> {
    /// The chain as described.
    #[inline]
    #[must_use]
    fn new() -> Self {
        let parameters = DoubleBallParameters {
            none: ::core::marker::PhantomData,
        };
        let (derived, _) = Self::derive(&parameters);
        Self { parameters, derived }
    }
    /// The numbers that may change at run time.
    #[inline]
    fn parameters(&self) -> &DoubleBallParameters<T> {
        &self.parameters
    }
    /// The state that the description starts from, at time zero.
    #[must_use]
    #[allow(unused_doc_comments, clippy::all)]
    fn initial_state(&self) -> DoubleBallState<T> {
        let c = T::constant;
        DoubleBallState {
            q: ::mstmm::nalgebra::SVector::from([
                c(1.0),
                c(0.0),
                c(0.0),
                c(0.0),
                c(1.0),
                c(0.0),
                c(0.0),
                c(0.0),
            ]),
            v: ::mstmm::nalgebra::SVector::from([
                c(0.0),
                c(0.0),
                c(0.0),
                c(0.0),
                c(0.0),
                c(0.0),
            ]),
            t: T::constant(0.0),
        }
    }
    /// Quantities derived from parameters and constants: 0 mul, 0 add, 0 reciprocal.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn derive(parameters: &DoubleBallParameters<T>) -> ([T; 0], [T; 0]) {
        ([], [])
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for DoubleBall<T> {
    fn default() -> Self {
        Self::new()
    }
}
#[allow(dead_code)]
impl<T: ::mstmm::Scalar> DoubleBall<T> {
    /// The accelerations `v̇` of all hinges, in the order of the rates: the fast path.
    ///
    /// 250 operations: 147 mul, 101 add, 2 reciprocal.
    ///
    /// | section | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|
    /// | Motion across `shoulder` | 9 | 4 | 0 | 0 | 0 |
    /// | Motion across `elbow` | 40 | 31 | 0 | 0 | 0 |
    /// | Riccati transfer over `elbow` | 15 | 4 | 0 | 0 | 0 |
    /// | Riccati transfer over `shoulder` | 49 | 32 | 2 | 0 | 0 |
    /// | Acceleration of `shoulder` | 14 | 8 | 0 | 0 | 0 |
    /// | Acceleration of `elbow` | 11 | 10 | 0 | 0 | 0 |
    /// | Results | 9 | 12 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// [`Error::Singular`](::mstmm::Error::Singular) if nothing with inertia lies beyond a
    /// hinge, [`Error::NotFinite`](::mstmm::Error::NotFinite) if a number of the state or the
    /// inputs is not finite. `accelerations` is not touched then.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn accelerations_into(
        &self,
        state: &DoubleBallState<T>,
        inputs: &DoubleBallInputs<T>,
        accelerations: &mut ::mstmm::nalgebra::SVector<T, 6>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let c = T::constant;
        let [[shoulder_qw, shoulder_qx, shoulder_qy, shoulder_qz, elbow_qw, elbow_qx,
        elbow_qy, elbow_qz]] = state.q.data.0;
        let [[shoulder_wx, shoulder_wy, shoulder_wz, elbow_wx, elbow_wy, elbow_wz]] = state
            .v
            .data
            .0;
        /// Motion across `shoulder`, [P, Eqs. (1), (13), (36)]: 9 mul, 4 add, 0 reciprocal.
        let t0 = shoulder_qy * c(2.0);
        let t1 = shoulder_qz * c(2.0);
        let t2 = shoulder_qw * t1;
        let t3 = shoulder_qx * t0;
        let shoulder_turn_y_x = t2 + t3;
        let t4 = shoulder_qx * c(2.0);
        let t5 = shoulder_qx * t4;
        let t6 = shoulder_qz * t1;
        let t7 = t5 + t6;
        let shoulder_turn_y_y = c(1.0) - t7;
        let t8 = shoulder_qw * t4;
        let t9 = shoulder_qy * t1;
        let minus_shoulder_turn_y_z = t8 - t9;
        /// Motion across `elbow`, [P, Eqs. (1), (13), (36)]: 40 mul, 31 add, 0 reciprocal.
        let t10 = elbow_qy * c(2.0);
        let t11 = elbow_qz * c(2.0);
        let t12 = elbow_qy * t10;
        let t13 = elbow_qz * t11;
        let t14 = t12 + t13;
        let elbow_turn_x_x = c(1.0) - t14;
        let t15 = elbow_qw * t11;
        let t16 = elbow_qx * t10;
        let minus_elbow_turn_x_y = t15 - t16;
        let t17 = elbow_qw * t10;
        let t18 = elbow_qx * t11;
        let elbow_turn_x_z = t17 + t18;
        let elbow_turn_y_x = t15 + t16;
        let t19 = elbow_qx * c(2.0);
        let t20 = elbow_qx * t19;
        let t21 = t20 + t13;
        let elbow_turn_y_y = c(1.0) - t21;
        let t22 = elbow_qw * t19;
        let t23 = elbow_qy * t11;
        let minus_elbow_turn_y_z = t22 - t23;
        let minus_elbow_turn_z_x = t17 - t18;
        let elbow_turn_z_y = t22 + t23;
        let t24 = t20 + t12;
        let elbow_turn_z_z = c(1.0) - t24;
        let t25 = shoulder_wx * elbow_turn_x_x;
        let t26 = shoulder_wy * elbow_turn_y_x;
        let t27 = t25 + t26;
        let t28 = shoulder_wz * minus_elbow_turn_z_x;
        let t29 = t27 - t28;
        let elbow_omega_x = elbow_wx + t29;
        let t30 = shoulder_wx * minus_elbow_turn_x_y;
        let t31 = shoulder_wy * elbow_turn_y_y;
        let t32 = t30 - t31;
        let t33 = shoulder_wz * elbow_turn_z_y;
        let t34 = t32 - t33;
        let elbow_omega_y = elbow_wy - t34;
        let t35 = shoulder_wx * elbow_turn_x_z;
        let t36 = shoulder_wy * minus_elbow_turn_y_z;
        let t37 = t35 - t36;
        let t38 = shoulder_wz * elbow_turn_z_z;
        let t39 = t37 + t38;
        let elbow_omega_z = elbow_wz + t39;
        let t40 = shoulder_wy * shoulder_wy;
        let t41 = shoulder_wz * shoulder_wz;
        let t42 = t40 + t41;
        let t43 = shoulder_wx * shoulder_wy;
        let t44 = shoulder_wx * shoulder_wz;
        let t45 = elbow_turn_x_x * t42;
        let t46 = elbow_turn_y_x * t43;
        let t47 = t45 - t46;
        let t48 = minus_elbow_turn_z_x * t44;
        let minus_elbow_drift_lin_x = t47 + t48;
        let t49 = minus_elbow_turn_x_y * t42;
        let t50 = elbow_turn_y_y * t43;
        let t51 = t49 + t50;
        let t52 = elbow_turn_z_y * t44;
        let elbow_drift_lin_y = t51 + t52;
        let t53 = elbow_turn_x_z * t42;
        let t54 = minus_elbow_turn_y_z * t43;
        let t55 = t53 + t54;
        let t56 = elbow_turn_z_z * t44;
        let minus_elbow_drift_lin_z = t55 - t56;
        let t57 = elbow_wz * t34;
        let t58 = elbow_wy * t39;
        let minus_elbow_drift_ang_x = t57 + t58;
        let t59 = elbow_wx * t39;
        let t60 = elbow_wz * t29;
        let elbow_drift_ang_y = t59 - t60;
        let t61 = elbow_wy * t29;
        let t62 = elbow_wx * t34;
        let elbow_drift_ang_z = t61 + t62;
        /// Riccati transfer over `elbow`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 15 mul, 4 add, 0 reciprocal.
        let t63 = elbow_omega_z * c(0.5);
        let t64 = elbow_omega_y * c(0.5);
        let t65 = elbow_omega_y * t64;
        let t66 = elbow_omega_z * t63;
        let minus_elbow_e_force_x = t65 + t66;
        let elbow_e_force_y = elbow_omega_x * t64;
        let elbow_e_force_z = elbow_omega_x * t63;
        let t67 = elbow_omega_y * c(0.4166666666666667);
        let t68 = elbow_omega_z * c(0.4166666666666667);
        let t69 = elbow_omega_y * t68;
        let t70 = elbow_omega_z * t67;
        let elbow_e_moment_x = t69 - t70;
        let t71 = elbow_omega_x * c(0.16666666666666666);
        let t72 = elbow_omega_z * t71;
        let t73 = elbow_omega_x * t68;
        let elbow_e_moment_y = t72 - t73;
        let t74 = elbow_omega_x * t67;
        let t75 = elbow_omega_y * t71;
        let elbow_e_moment_z = t74 - t75;
        /// Riccati transfer over `shoulder`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 49 mul, 32 add, 2 reciprocal.
        let t76 = minus_elbow_turn_x_y * c(0.4);
        let t77 = elbow_turn_x_z * c(0.4);
        let t78 = elbow_turn_x_x * elbow_turn_y_x;
        let t79 = elbow_turn_y_y * t76;
        let t80 = t78 - t79;
        let t81 = minus_elbow_turn_y_z * t77;
        let shoulder_k_xy = t80 - t81;
        let t82 = elbow_turn_x_x * minus_elbow_turn_z_x;
        let t83 = elbow_turn_z_y * t76;
        let t84 = t82 + t83;
        let t85 = elbow_turn_z_z * t77;
        let minus_shoulder_k_xz = t84 - t85;
        let t86 = elbow_turn_y_x * minus_elbow_turn_z_x;
        let t87 = elbow_turn_y_y * c(0.4);
        let t88 = minus_elbow_turn_y_z * c(0.4);
        let t89 = elbow_turn_z_y * t87;
        let t90 = t86 - t89;
        let t91 = elbow_turn_z_z * t88;
        let minus_shoulder_k_yz = t90 + t91;
        let t92 = elbow_turn_y_x * elbow_turn_y_x;
        let t93 = elbow_turn_y_y * t87;
        let t94 = t92 + t93;
        let t95 = minus_elbow_turn_y_z * t88;
        let t96 = t94 + t95;
        let shoulder_b_y_z = c(0.5) + t96;
        let t97 = minus_elbow_turn_z_x * minus_elbow_turn_z_x;
        let t98 = elbow_turn_z_y * c(0.4);
        let t99 = elbow_turn_z_z * c(0.4);
        let t100 = elbow_turn_z_y * t98;
        let t101 = t97 + t100;
        let t102 = elbow_turn_z_z * t99;
        let t103 = t101 + t102;
        let minus_shoulder_b_z_y = c(0.5) + t103;
        let shoulder_j_yy = c(0.4166666666666667) + t103;
        let shoulder_j_zz = c(0.4166666666666667) + t96;
        let t104 = shoulder_wy * c(0.4166666666666667);
        let t105 = shoulder_wz * c(0.4166666666666667);
        let t106 = shoulder_wy * t105;
        let t107 = shoulder_wz * t104;
        let shoulder_e_moment_x = t106 - t107;
        let t108 = shoulder_wx * c(0.16666666666666666);
        let t109 = shoulder_wz * t108;
        let t110 = shoulder_wx * t105;
        let t111 = t109 - t110;
        let t112 = elbow_e_moment_y * c(1.2);
        let t113 = elbow_e_force_z + t112;
        let t114 = elbow_e_moment_z * c(1.2);
        let t115 = elbow_e_force_y - t114;
        let t116 = elbow_drift_lin_y * c(0.4);
        let t117 = minus_elbow_drift_lin_z * c(0.4);
        let t118 = minus_elbow_drift_lin_x + minus_elbow_e_force_x;
        let t119 = t115 + t116;
        let t120 = t113 - t117;
        let t121 = minus_elbow_turn_z_x * t118;
        let t122 = elbow_turn_z_y * t119;
        let t123 = t121 + t122;
        let t124 = elbow_turn_z_z * t120;
        let t125 = t123 + t124;
        let shoulder_e_moment_y = t111 - t125;
        let t126 = shoulder_wx * t104;
        let t127 = shoulder_wy * t108;
        let t128 = t126 - t127;
        let t129 = elbow_turn_y_x * t118;
        let t130 = elbow_turn_y_y * t119;
        let t131 = t129 - t130;
        let t132 = minus_elbow_turn_y_z * t120;
        let t133 = t131 + t132;
        let shoulder_e_moment_z = t128 - t133;
        let t134 = T::recip(shoulder_j_yy);
        let shoulder_z1_force_x = minus_shoulder_k_xz * t134;
        let shoulder_z1_force_y = minus_shoulder_k_yz * t134;
        let minus_shoulder_z1_force_z = minus_shoulder_b_z_y * t134;
        let t135 = minus_shoulder_k_yz * shoulder_z1_force_y;
        let shoulder_d2 = shoulder_j_zz - t135;
        let t136 = minus_shoulder_k_yz * shoulder_z1_force_x;
        let t137 = shoulder_k_xy - t136;
        let t138 = T::recip(shoulder_d2);
        let shoulder_z2_force_x = t137 * t138;
        let t139 = shoulder_b_y_z - t135;
        let shoulder_z2_force_y = t139 * t138;
        let t140 = minus_shoulder_k_yz * minus_shoulder_z1_force_z;
        let t141 = minus_shoulder_k_yz - t140;
        let minus_shoulder_z2_force_z = t141 * t138;
        /// Acceleration of `shoulder`, [P, Eqs. (13), (36), (44)]: 14 mul, 8 add, 0 reciprocal.
        let shoulder_a_lin_x = shoulder_turn_y_x * c(9.8);
        let shoulder_a_lin_y = shoulder_turn_y_y * c(9.8);
        let minus_shoulder_a_lin_z = minus_shoulder_turn_y_z * c(9.8);
        let minus_shoulder_a_ang_x = shoulder_e_moment_x * c(6.0);
        let t142 = shoulder_e_moment_y * t134;
        let t143 = minus_shoulder_k_yz * t142;
        let t144 = shoulder_e_moment_z - t143;
        let t145 = t144 * t138;
        let t146 = shoulder_a_lin_x * shoulder_z2_force_x;
        let t147 = shoulder_a_lin_y * shoulder_z2_force_y;
        let t148 = t146 + t147;
        let t149 = minus_shoulder_a_lin_z * minus_shoulder_z2_force_z;
        let t150 = t148 + t149;
        let minus_shoulder_a_ang_z = t145 + t150;
        let t151 = shoulder_a_lin_x * shoulder_z1_force_x;
        let t152 = shoulder_a_lin_y * shoulder_z1_force_y;
        let t153 = t151 + t152;
        let t154 = minus_shoulder_a_lin_z * minus_shoulder_z1_force_z;
        let t155 = t153 + t154;
        let t156 = shoulder_z1_force_y * minus_shoulder_a_ang_z;
        let t157 = t155 - t156;
        let minus_shoulder_a_ang_y = t142 + t157;
        /// Acceleration of `elbow`, [P, Eqs. (13), (36), (44)]: 11 mul, 10 add, 0 reciprocal.
        let t158 = minus_elbow_turn_x_y * shoulder_a_lin_x;
        let t159 = shoulder_a_lin_y - minus_shoulder_a_ang_z;
        let t160 = minus_shoulder_a_lin_z - minus_shoulder_a_ang_y;
        let t161 = elbow_turn_y_y * t159;
        let t162 = t158 - t161;
        let t163 = elbow_turn_z_y * t160;
        let t164 = t162 + t163;
        let elbow_a_lin_y = elbow_drift_lin_y - t164;
        let t165 = elbow_turn_x_z * shoulder_a_lin_x;
        let t166 = minus_elbow_turn_y_z * t159;
        let t167 = t165 - t166;
        let t168 = elbow_turn_z_z * t160;
        let t169 = t167 - t168;
        let minus_elbow_a_lin_z = minus_elbow_drift_lin_z - t169;
        let minus_elbow_a_ang_x = elbow_e_moment_x * c(6.0);
        let t170 = elbow_e_moment_y * c(2.4);
        let t171 = c(1.2) * minus_elbow_a_lin_z;
        let minus_elbow_a_ang_y = t170 + t171;
        let t172 = elbow_e_moment_z * c(2.4);
        let t173 = c(1.2) * elbow_a_lin_y;
        let minus_elbow_a_ang_z = t172 + t173;
        /// Results: 9 mul, 12 add, 0 reciprocal.
        let t174 = elbow_turn_x_x * minus_shoulder_a_ang_x;
        let t175 = elbow_turn_y_x * minus_shoulder_a_ang_y;
        let t176 = t174 + t175;
        let t177 = minus_elbow_turn_z_x * minus_shoulder_a_ang_z;
        let t178 = t176 - t177;
        let t179 = minus_elbow_drift_ang_x + t178;
        let t180 = minus_elbow_a_ang_x - t179;
        let t181 = minus_elbow_turn_x_y * minus_shoulder_a_ang_x;
        let t182 = elbow_turn_y_y * minus_shoulder_a_ang_y;
        let t183 = t181 - t182;
        let t184 = elbow_turn_z_y * minus_shoulder_a_ang_z;
        let t185 = t183 - t184;
        let t186 = elbow_drift_ang_y + t185;
        let t187 = t186 + minus_elbow_a_ang_y;
        let t188 = elbow_turn_x_z * minus_shoulder_a_ang_x;
        let t189 = minus_elbow_turn_y_z * minus_shoulder_a_ang_y;
        let t190 = t188 - t189;
        let t191 = elbow_turn_z_z * minus_shoulder_a_ang_z;
        let t192 = t190 + t191;
        let t193 = elbow_drift_ang_z - t192;
        let t194 = t193 + minus_elbow_a_ang_z;
        ::mstmm::generated::regular(
            &["elbow", "elbow", "elbow", "shoulder", "shoulder", "shoulder"],
            [
                c(0.16666666666666666),
                c(0.4166666666666667),
                c(0.4166666666666667),
                c(0.16666666666666666),
                shoulder_j_yy,
                shoulder_d2,
            ],
            [c(1.0), c(1.0), c(1.0), c(1.0), c(1.0), c(1.0)],
            [
                -minus_shoulder_a_ang_x,
                -minus_shoulder_a_ang_y,
                -minus_shoulder_a_ang_z,
                -t180,
                -t187,
                -t194,
            ],
        )?;
        accelerations.data.0 = [
            [
                -minus_shoulder_a_ang_x,
                -minus_shoulder_a_ang_y,
                -minus_shoulder_a_ang_z,
                -t180,
                -t187,
                -t194,
            ],
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
        state: &DoubleBallState<T>,
        inputs: &DoubleBallInputs<T>,
    ) -> ::core::result::Result<::mstmm::nalgebra::SVector<T, 6>, ::mstmm::Error> {
        let mut accelerations = ::mstmm::nalgebra::SVector::from([T::constant(0.0); 6]);
        self.accelerations_into(state, inputs, &mut accelerations)?;
        ::core::result::Result::Ok(accelerations)
    }
    /// Everything: accelerations, efforts, energies and, at every connection point, pose,
    /// velocity and the state vector `z`, written into `at`.
    ///
    /// 787 operations: 452 mul, 333 add, 2 reciprocal.
    ///
    /// | section | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|
    /// | Motion across `shoulder` | 12 | 12 | 0 | 0 | 0 |
    /// | Motion across `elbow` | 40 | 31 | 0 | 0 | 0 |
    /// | Riccati transfer over `elbow` | 15 | 4 | 0 | 0 | 0 |
    /// | Riccati transfer over `shoulder` | 49 | 32 | 2 | 0 | 0 |
    /// | Acceleration of `shoulder` | 14 | 8 | 0 | 0 | 0 |
    /// | Acceleration of `elbow` | 11 | 10 | 0 | 0 | 0 |
    /// | Motion across `shoulder` | 9 | 6 | 0 | 0 | 0 |
    /// | Motion across `elbow` | 54 | 36 | 0 | 0 | 0 |
    /// | Point of `shoulder` | 9 | 6 | 0 | 0 | 0 |
    /// | Point of `elbow` | 24 | 30 | 0 | 0 | 0 |
    /// | Load on `elbow` | 78 | 52 | 0 | 0 | 0 |
    /// | Load on `shoulder` | 80 | 57 | 0 | 0 | 0 |
    /// | Results | 57 | 49 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// As [`accelerations_into`](Self::accelerations_into); `at` is not touched then.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn solve_into(
        &self,
        state: &DoubleBallState<T>,
        inputs: &DoubleBallInputs<T>,
        at: &mut DoubleBallWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let c = T::constant;
        let [[shoulder_qw, shoulder_qx, shoulder_qy, shoulder_qz, elbow_qw, elbow_qx,
        elbow_qy, elbow_qz]] = state.q.data.0;
        let [[shoulder_wx, shoulder_wy, shoulder_wz, elbow_wx, elbow_wy, elbow_wz]] = state
            .v
            .data
            .0;
        /// Motion across `shoulder`, [P, Eqs. (1), (13), (36)]: 12 mul, 12 add, 0 reciprocal.
        let t0 = shoulder_qy * c(2.0);
        let t1 = shoulder_qz * c(2.0);
        let t2 = shoulder_qy * t0;
        let t3 = shoulder_qz * t1;
        let t4 = t2 + t3;
        let minus_shoulder_turn_x_x = t4 - c(1.0);
        let t5 = shoulder_qw * t1;
        let t6 = shoulder_qx * t0;
        let minus_shoulder_turn_x_y = t5 - t6;
        let t7 = shoulder_qw * t0;
        let t8 = shoulder_qx * t1;
        let shoulder_turn_x_z = t7 + t8;
        let shoulder_turn_y_x = t5 + t6;
        let t9 = shoulder_qx * c(2.0);
        let t10 = shoulder_qx * t9;
        let t11 = t10 + t3;
        let shoulder_turn_y_y = c(1.0) - t11;
        let t12 = shoulder_qw * t9;
        let t13 = shoulder_qy * t1;
        let minus_shoulder_turn_y_z = t12 - t13;
        let minus_shoulder_turn_z_x = t7 - t8;
        let shoulder_turn_z_y = t12 + t13;
        let t14 = t10 + t2;
        let shoulder_turn_z_z = c(1.0) - t14;
        /// Motion across `elbow`, [P, Eqs. (1), (13), (36)]: 40 mul, 31 add, 0 reciprocal.
        let t15 = elbow_qy * c(2.0);
        let t16 = elbow_qz * c(2.0);
        let t17 = elbow_qy * t15;
        let t18 = elbow_qz * t16;
        let t19 = t17 + t18;
        let elbow_turn_x_x = c(1.0) - t19;
        let t20 = elbow_qw * t16;
        let t21 = elbow_qx * t15;
        let minus_elbow_turn_x_y = t20 - t21;
        let t22 = elbow_qw * t15;
        let t23 = elbow_qx * t16;
        let elbow_turn_x_z = t22 + t23;
        let elbow_turn_y_x = t20 + t21;
        let t24 = elbow_qx * c(2.0);
        let t25 = elbow_qx * t24;
        let t26 = t25 + t18;
        let elbow_turn_y_y = c(1.0) - t26;
        let t27 = elbow_qw * t24;
        let t28 = elbow_qy * t16;
        let minus_elbow_turn_y_z = t27 - t28;
        let minus_elbow_turn_z_x = t22 - t23;
        let elbow_turn_z_y = t27 + t28;
        let t29 = t25 + t17;
        let elbow_turn_z_z = c(1.0) - t29;
        let t30 = shoulder_wx * elbow_turn_x_x;
        let t31 = shoulder_wy * elbow_turn_y_x;
        let t32 = t30 + t31;
        let t33 = shoulder_wz * minus_elbow_turn_z_x;
        let t34 = t32 - t33;
        let elbow_omega_x = elbow_wx + t34;
        let t35 = shoulder_wx * minus_elbow_turn_x_y;
        let t36 = shoulder_wy * elbow_turn_y_y;
        let t37 = t35 - t36;
        let t38 = shoulder_wz * elbow_turn_z_y;
        let t39 = t37 - t38;
        let elbow_omega_y = elbow_wy - t39;
        let t40 = shoulder_wx * elbow_turn_x_z;
        let t41 = shoulder_wy * minus_elbow_turn_y_z;
        let t42 = t40 - t41;
        let t43 = shoulder_wz * elbow_turn_z_z;
        let t44 = t42 + t43;
        let elbow_omega_z = elbow_wz + t44;
        let t45 = shoulder_wy * shoulder_wy;
        let t46 = shoulder_wz * shoulder_wz;
        let t47 = t45 + t46;
        let t48 = shoulder_wx * shoulder_wy;
        let t49 = shoulder_wx * shoulder_wz;
        let t50 = elbow_turn_x_x * t47;
        let t51 = elbow_turn_y_x * t48;
        let t52 = t50 - t51;
        let t53 = minus_elbow_turn_z_x * t49;
        let minus_elbow_drift_lin_x = t52 + t53;
        let t54 = minus_elbow_turn_x_y * t47;
        let t55 = elbow_turn_y_y * t48;
        let t56 = t54 + t55;
        let t57 = elbow_turn_z_y * t49;
        let elbow_drift_lin_y = t56 + t57;
        let t58 = elbow_turn_x_z * t47;
        let t59 = minus_elbow_turn_y_z * t48;
        let t60 = t58 + t59;
        let t61 = elbow_turn_z_z * t49;
        let minus_elbow_drift_lin_z = t60 - t61;
        let t62 = elbow_wz * t39;
        let t63 = elbow_wy * t44;
        let minus_elbow_drift_ang_x = t62 + t63;
        let t64 = elbow_wx * t44;
        let t65 = elbow_wz * t34;
        let elbow_drift_ang_y = t64 - t65;
        let t66 = elbow_wy * t34;
        let t67 = elbow_wx * t39;
        let elbow_drift_ang_z = t66 + t67;
        /// Riccati transfer over `elbow`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 15 mul, 4 add, 0 reciprocal.
        let t68 = elbow_omega_z * c(0.5);
        let t69 = elbow_omega_y * c(0.5);
        let t70 = elbow_omega_y * t69;
        let t71 = elbow_omega_z * t68;
        let minus_elbow_e_force_x = t70 + t71;
        let elbow_e_force_y = elbow_omega_x * t69;
        let elbow_e_force_z = elbow_omega_x * t68;
        let t72 = elbow_omega_y * c(0.4166666666666667);
        let t73 = elbow_omega_z * c(0.4166666666666667);
        let t74 = elbow_omega_y * t73;
        let t75 = elbow_omega_z * t72;
        let elbow_e_moment_x = t74 - t75;
        let t76 = elbow_omega_x * c(0.16666666666666666);
        let t77 = elbow_omega_z * t76;
        let t78 = elbow_omega_x * t73;
        let elbow_e_moment_y = t77 - t78;
        let t79 = elbow_omega_x * t72;
        let t80 = elbow_omega_y * t76;
        let elbow_e_moment_z = t79 - t80;
        /// Riccati transfer over `shoulder`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 49 mul, 32 add, 2 reciprocal.
        let t81 = minus_elbow_turn_x_y * c(0.4);
        let t82 = elbow_turn_x_z * c(0.4);
        let t83 = elbow_turn_x_x * elbow_turn_y_x;
        let t84 = elbow_turn_y_y * t81;
        let t85 = t83 - t84;
        let t86 = minus_elbow_turn_y_z * t82;
        let shoulder_k_xy = t85 - t86;
        let t87 = elbow_turn_x_x * minus_elbow_turn_z_x;
        let t88 = elbow_turn_z_y * t81;
        let t89 = t87 + t88;
        let t90 = elbow_turn_z_z * t82;
        let minus_shoulder_k_xz = t89 - t90;
        let t91 = elbow_turn_y_x * minus_elbow_turn_z_x;
        let t92 = elbow_turn_y_y * c(0.4);
        let t93 = minus_elbow_turn_y_z * c(0.4);
        let t94 = elbow_turn_z_y * t92;
        let t95 = t91 - t94;
        let t96 = elbow_turn_z_z * t93;
        let minus_shoulder_k_yz = t95 + t96;
        let t97 = elbow_turn_y_x * elbow_turn_y_x;
        let t98 = elbow_turn_y_y * t92;
        let t99 = t97 + t98;
        let t100 = minus_elbow_turn_y_z * t93;
        let t101 = t99 + t100;
        let shoulder_b_y_z = c(0.5) + t101;
        let t102 = minus_elbow_turn_z_x * minus_elbow_turn_z_x;
        let t103 = elbow_turn_z_y * c(0.4);
        let t104 = elbow_turn_z_z * c(0.4);
        let t105 = elbow_turn_z_y * t103;
        let t106 = t102 + t105;
        let t107 = elbow_turn_z_z * t104;
        let t108 = t106 + t107;
        let minus_shoulder_b_z_y = c(0.5) + t108;
        let shoulder_j_yy = c(0.4166666666666667) + t108;
        let shoulder_j_zz = c(0.4166666666666667) + t101;
        let t109 = shoulder_wy * c(0.4166666666666667);
        let t110 = shoulder_wz * c(0.4166666666666667);
        let t111 = shoulder_wy * t110;
        let t112 = shoulder_wz * t109;
        let shoulder_e_moment_x = t111 - t112;
        let t113 = shoulder_wx * c(0.16666666666666666);
        let t114 = shoulder_wz * t113;
        let t115 = shoulder_wx * t110;
        let t116 = t114 - t115;
        let t117 = elbow_e_moment_y * c(1.2);
        let t118 = elbow_e_force_z + t117;
        let t119 = elbow_e_moment_z * c(1.2);
        let t120 = elbow_e_force_y - t119;
        let t121 = elbow_drift_lin_y * c(0.4);
        let t122 = minus_elbow_drift_lin_z * c(0.4);
        let t123 = minus_elbow_drift_lin_x + minus_elbow_e_force_x;
        let t124 = t120 + t121;
        let t125 = t118 - t122;
        let t126 = minus_elbow_turn_z_x * t123;
        let t127 = elbow_turn_z_y * t124;
        let t128 = t126 + t127;
        let t129 = elbow_turn_z_z * t125;
        let t130 = t128 + t129;
        let shoulder_e_moment_y = t116 - t130;
        let t131 = shoulder_wx * t109;
        let t132 = shoulder_wy * t113;
        let t133 = t131 - t132;
        let t134 = elbow_turn_y_x * t123;
        let t135 = elbow_turn_y_y * t124;
        let t136 = t134 - t135;
        let t137 = minus_elbow_turn_y_z * t125;
        let t138 = t136 + t137;
        let shoulder_e_moment_z = t133 - t138;
        let t139 = T::recip(shoulder_j_yy);
        let shoulder_z1_force_x = minus_shoulder_k_xz * t139;
        let shoulder_z1_force_y = minus_shoulder_k_yz * t139;
        let minus_shoulder_z1_force_z = minus_shoulder_b_z_y * t139;
        let t140 = minus_shoulder_k_yz * shoulder_z1_force_y;
        let shoulder_d2 = shoulder_j_zz - t140;
        let t141 = minus_shoulder_k_yz * shoulder_z1_force_x;
        let t142 = shoulder_k_xy - t141;
        let t143 = T::recip(shoulder_d2);
        let shoulder_z2_force_x = t142 * t143;
        let t144 = shoulder_b_y_z - t140;
        let shoulder_z2_force_y = t144 * t143;
        let t145 = minus_shoulder_k_yz * minus_shoulder_z1_force_z;
        let t146 = minus_shoulder_k_yz - t145;
        let minus_shoulder_z2_force_z = t146 * t143;
        /// Acceleration of `shoulder`, [P, Eqs. (13), (36), (44)]: 14 mul, 8 add, 0 reciprocal.
        let shoulder_a_lin_x = shoulder_turn_y_x * c(9.8);
        let shoulder_a_lin_y = shoulder_turn_y_y * c(9.8);
        let minus_shoulder_a_lin_z = minus_shoulder_turn_y_z * c(9.8);
        let minus_shoulder_a_ang_x = shoulder_e_moment_x * c(6.0);
        let t147 = shoulder_e_moment_y * t139;
        let t148 = minus_shoulder_k_yz * t147;
        let t149 = shoulder_e_moment_z - t148;
        let t150 = t149 * t143;
        let t151 = shoulder_a_lin_x * shoulder_z2_force_x;
        let t152 = shoulder_a_lin_y * shoulder_z2_force_y;
        let t153 = t151 + t152;
        let t154 = minus_shoulder_a_lin_z * minus_shoulder_z2_force_z;
        let t155 = t153 + t154;
        let minus_shoulder_a_ang_z = t150 + t155;
        let t156 = shoulder_a_lin_x * shoulder_z1_force_x;
        let t157 = shoulder_a_lin_y * shoulder_z1_force_y;
        let t158 = t156 + t157;
        let t159 = minus_shoulder_a_lin_z * minus_shoulder_z1_force_z;
        let t160 = t158 + t159;
        let t161 = shoulder_z1_force_y * minus_shoulder_a_ang_z;
        let t162 = t160 - t161;
        let minus_shoulder_a_ang_y = t147 + t162;
        /// Acceleration of `elbow`, [P, Eqs. (13), (36), (44)]: 11 mul, 10 add, 0 reciprocal.
        let t163 = minus_elbow_turn_x_y * shoulder_a_lin_x;
        let t164 = shoulder_a_lin_y - minus_shoulder_a_ang_z;
        let t165 = minus_shoulder_a_lin_z - minus_shoulder_a_ang_y;
        let t166 = elbow_turn_y_y * t164;
        let t167 = t163 - t166;
        let t168 = elbow_turn_z_y * t165;
        let t169 = t167 + t168;
        let elbow_a_lin_y = elbow_drift_lin_y - t169;
        let t170 = elbow_turn_x_z * shoulder_a_lin_x;
        let t171 = minus_elbow_turn_y_z * t164;
        let t172 = t170 - t171;
        let t173 = elbow_turn_z_z * t165;
        let t174 = t172 - t173;
        let minus_elbow_a_lin_z = minus_elbow_drift_lin_z - t174;
        let minus_elbow_a_ang_x = elbow_e_moment_x * c(6.0);
        let t175 = elbow_e_moment_y * c(2.4);
        let t176 = c(1.2) * minus_elbow_a_lin_z;
        let minus_elbow_a_ang_y = t175 + t176;
        let t177 = elbow_e_moment_z * c(2.4);
        let t178 = c(1.2) * elbow_a_lin_y;
        let minus_elbow_a_ang_z = t177 + t178;
        /// Motion across `shoulder`, [P, Eqs. (1), (13), (36)]: 9 mul, 6 add, 0 reciprocal.
        let t179 = shoulder_wx * minus_shoulder_turn_x_x;
        let t180 = shoulder_wy * minus_shoulder_turn_x_y;
        let t181 = t179 + t180;
        let t182 = shoulder_wz * shoulder_turn_x_z;
        let minus_shoulder_omega_x = t181 - t182;
        let t183 = shoulder_wx * shoulder_turn_y_x;
        let t184 = shoulder_wy * shoulder_turn_y_y;
        let t185 = t183 + t184;
        let t186 = shoulder_wz * minus_shoulder_turn_y_z;
        let shoulder_omega_y = t185 - t186;
        let t187 = shoulder_wx * minus_shoulder_turn_z_x;
        let t188 = shoulder_wy * shoulder_turn_z_y;
        let t189 = t187 - t188;
        let t190 = shoulder_wz * shoulder_turn_z_z;
        let minus_shoulder_omega_z = t189 - t190;
        /// Motion across `elbow`, [P, Eqs. (1), (13), (36)]: 54 mul, 36 add, 0 reciprocal.
        let t191 = minus_shoulder_turn_x_x * elbow_turn_x_x;
        let t192 = minus_shoulder_turn_x_y * elbow_turn_y_x;
        let t193 = t191 + t192;
        let t194 = shoulder_turn_x_z * minus_elbow_turn_z_x;
        let minus_elbow_axes_x_x = t193 + t194;
        let t195 = minus_shoulder_turn_x_x * minus_elbow_turn_x_y;
        let t196 = minus_shoulder_turn_x_y * elbow_turn_y_y;
        let t197 = t195 - t196;
        let t198 = shoulder_turn_x_z * elbow_turn_z_y;
        let elbow_axes_x_y = t197 + t198;
        let t199 = minus_shoulder_turn_x_x * elbow_turn_x_z;
        let t200 = minus_shoulder_turn_x_y * minus_elbow_turn_y_z;
        let t201 = t199 - t200;
        let t202 = shoulder_turn_x_z * elbow_turn_z_z;
        let minus_elbow_axes_x_z = t201 - t202;
        let t203 = shoulder_turn_y_x * elbow_turn_x_x;
        let t204 = shoulder_turn_y_y * elbow_turn_y_x;
        let t205 = t203 + t204;
        let t206 = minus_shoulder_turn_y_z * minus_elbow_turn_z_x;
        let elbow_axes_y_x = t205 + t206;
        let t207 = shoulder_turn_y_x * minus_elbow_turn_x_y;
        let t208 = shoulder_turn_y_y * elbow_turn_y_y;
        let t209 = t207 - t208;
        let t210 = minus_shoulder_turn_y_z * elbow_turn_z_y;
        let minus_elbow_axes_y_y = t209 + t210;
        let t211 = shoulder_turn_y_x * elbow_turn_x_z;
        let t212 = shoulder_turn_y_y * minus_elbow_turn_y_z;
        let t213 = t211 - t212;
        let t214 = minus_shoulder_turn_y_z * elbow_turn_z_z;
        let elbow_axes_y_z = t213 - t214;
        let t215 = minus_shoulder_turn_z_x * elbow_turn_x_x;
        let t216 = shoulder_turn_z_y * elbow_turn_y_x;
        let t217 = t215 - t216;
        let t218 = shoulder_turn_z_z * minus_elbow_turn_z_x;
        let minus_elbow_axes_z_x = t217 + t218;
        let t219 = minus_shoulder_turn_z_x * minus_elbow_turn_x_y;
        let t220 = shoulder_turn_z_y * elbow_turn_y_y;
        let t221 = t219 + t220;
        let t222 = shoulder_turn_z_z * elbow_turn_z_y;
        let elbow_axes_z_y = t221 + t222;
        let t223 = minus_shoulder_turn_z_x * elbow_turn_x_z;
        let t224 = shoulder_turn_z_y * minus_elbow_turn_y_z;
        let t225 = t223 + t224;
        let t226 = shoulder_turn_z_z * elbow_turn_z_z;
        let minus_elbow_axes_z_z = t225 - t226;
        let t227 = elbow_wx * minus_elbow_axes_x_x;
        let t228 = elbow_wy * elbow_axes_x_y;
        let t229 = t227 - t228;
        let t230 = elbow_wz * minus_elbow_axes_x_z;
        let t231 = t229 + t230;
        let minus_elbow_omega_x = minus_shoulder_omega_x + t231;
        let t232 = elbow_wx * elbow_axes_y_x;
        let t233 = elbow_wy * minus_elbow_axes_y_y;
        let t234 = t232 - t233;
        let t235 = elbow_wz * elbow_axes_y_z;
        let t236 = t234 + t235;
        let elbow_omega_y_2 = shoulder_omega_y + t236;
        let t237 = elbow_wx * minus_elbow_axes_z_x;
        let t238 = elbow_wy * elbow_axes_z_y;
        let t239 = t237 - t238;
        let t240 = elbow_wz * minus_elbow_axes_z_z;
        let t241 = t239 + t240;
        let minus_elbow_omega_z = minus_shoulder_omega_z + t241;
        let t242 = minus_shoulder_turn_x_x * minus_shoulder_omega_z;
        let t243 = minus_shoulder_turn_z_x * minus_shoulder_omega_x;
        let t244 = t242 - t243;
        let t245 = shoulder_turn_y_x * minus_shoulder_omega_x;
        let t246 = minus_shoulder_turn_x_x * shoulder_omega_y;
        let t247 = t245 - t246;
        let t248 = shoulder_omega_y * t247;
        let t249 = minus_shoulder_omega_z * t244;
        let minus_elbow_drift_lin_x_2 = t248 - t249;
        let t250 = minus_shoulder_turn_z_x * shoulder_omega_y;
        let t251 = shoulder_turn_y_x * minus_shoulder_omega_z;
        let t252 = t250 - t251;
        let t253 = minus_shoulder_omega_z * t252;
        let t254 = minus_shoulder_omega_x * t247;
        let elbow_drift_lin_y_2 = t253 - t254;
        let t255 = minus_shoulder_omega_x * t244;
        let t256 = shoulder_omega_y * t252;
        let minus_elbow_drift_lin_z_2 = t255 - t256;
        let t257 = shoulder_omega_y * t241;
        let t258 = minus_shoulder_omega_z * t236;
        let minus_elbow_drift_ang_x_2 = t257 - t258;
        let t259 = minus_shoulder_omega_z * t231;
        let t260 = minus_shoulder_omega_x * t241;
        let elbow_drift_ang_y_2 = t259 - t260;
        let t261 = minus_shoulder_omega_x * t236;
        let t262 = shoulder_omega_y * t231;
        let minus_elbow_drift_ang_z = t261 - t262;
        /// Point of `shoulder`, [P, Eqs. (12), (13), (36)]: 9 mul, 6 add, 0 reciprocal.
        let t263 = minus_shoulder_turn_x_x * minus_shoulder_a_ang_x;
        let t264 = minus_shoulder_turn_x_y * minus_shoulder_a_ang_y;
        let t265 = t263 + t264;
        let t266 = shoulder_turn_x_z * minus_shoulder_a_ang_z;
        let shoulder_acc_ang_x = t265 - t266;
        let t267 = shoulder_turn_y_x * minus_shoulder_a_ang_x;
        let t268 = shoulder_turn_y_y * minus_shoulder_a_ang_y;
        let t269 = t267 + t268;
        let t270 = minus_shoulder_turn_y_z * minus_shoulder_a_ang_z;
        let minus_shoulder_acc_ang_y = t269 - t270;
        let t271 = minus_shoulder_turn_z_x * minus_shoulder_a_ang_x;
        let t272 = shoulder_turn_z_y * minus_shoulder_a_ang_y;
        let t273 = t271 - t272;
        let t274 = shoulder_turn_z_z * minus_shoulder_a_ang_z;
        let shoulder_acc_ang_z = t273 - t274;
        /// Point of `elbow`, [P, Eqs. (12), (13), (36)]: 24 mul, 30 add, 0 reciprocal.
        let t275 = minus_shoulder_turn_z_x * minus_shoulder_acc_ang_y;
        let t276 = shoulder_turn_y_x * shoulder_acc_ang_z;
        let t277 = t275 - t276;
        let minus_elbow_acc_lin_x = minus_elbow_drift_lin_x_2 - t277;
        let t278 = minus_shoulder_turn_x_x * shoulder_acc_ang_z;
        let t279 = minus_shoulder_turn_z_x * shoulder_acc_ang_x;
        let t280 = t278 - t279;
        let elbow_acc_lin_y = elbow_drift_lin_y_2 - t280;
        let t281 = shoulder_turn_y_x * shoulder_acc_ang_x;
        let t282 = minus_shoulder_turn_x_x * minus_shoulder_acc_ang_y;
        let t283 = t281 - t282;
        let minus_elbow_acc_lin_z = minus_elbow_drift_lin_z_2 - t283;
        let t284 = elbow_turn_x_x * minus_shoulder_a_ang_x;
        let t285 = elbow_turn_y_x * minus_shoulder_a_ang_y;
        let t286 = t284 + t285;
        let t287 = minus_elbow_turn_z_x * minus_shoulder_a_ang_z;
        let t288 = t286 - t287;
        let t289 = minus_elbow_turn_x_y * minus_shoulder_a_ang_x;
        let t290 = elbow_turn_y_y * minus_shoulder_a_ang_y;
        let t291 = t289 - t290;
        let t292 = elbow_turn_z_y * minus_shoulder_a_ang_z;
        let t293 = t291 - t292;
        let t294 = elbow_turn_x_z * minus_shoulder_a_ang_x;
        let t295 = minus_elbow_turn_y_z * minus_shoulder_a_ang_y;
        let t296 = t294 - t295;
        let t297 = elbow_turn_z_z * minus_shoulder_a_ang_z;
        let t298 = t296 + t297;
        let t299 = minus_elbow_drift_ang_x + t288;
        let t300 = elbow_drift_ang_y + t293;
        let t301 = elbow_drift_ang_z - t298;
        let t302 = t301 + minus_elbow_a_ang_z;
        let t303 = t300 + minus_elbow_a_ang_y;
        let t304 = minus_elbow_a_ang_x - t299;
        let t305 = minus_elbow_drift_ang_x_2 - shoulder_acc_ang_x;
        let t306 = t304 * minus_elbow_axes_x_x;
        let t307 = t303 * elbow_axes_x_y;
        let t308 = t306 - t307;
        let t309 = t302 * minus_elbow_axes_x_z;
        let t310 = t308 + t309;
        let minus_elbow_acc_ang_x = t305 - t310;
        let t311 = elbow_drift_ang_y_2 - minus_shoulder_acc_ang_y;
        let t312 = t304 * elbow_axes_y_x;
        let t313 = t303 * minus_elbow_axes_y_y;
        let t314 = t312 - t313;
        let t315 = t302 * elbow_axes_y_z;
        let t316 = t314 + t315;
        let elbow_acc_ang_y = t311 - t316;
        let t317 = minus_elbow_drift_ang_z - shoulder_acc_ang_z;
        let t318 = t304 * minus_elbow_axes_z_x;
        let t319 = t303 * elbow_axes_z_y;
        let t320 = t318 - t319;
        let t321 = t302 * minus_elbow_axes_z_z;
        let t322 = t320 + t321;
        let minus_elbow_acc_ang_z = t317 - t322;
        /// Load on `elbow`, [P, Eqs. (18), (19)]: 78 mul, 52 add, 0 reciprocal.
        let t323 = c(0.5) * minus_elbow_axes_x_x;
        let t324 = c(0.5) * elbow_axes_y_x;
        let t325 = c(0.5) * minus_elbow_axes_z_x;
        let t326 = t325 * elbow_acc_ang_y;
        let t327 = t324 * minus_elbow_acc_ang_z;
        let t328 = t326 - t327;
        let t329 = minus_elbow_acc_lin_x + t328;
        let t330 = minus_elbow_omega_z * t323;
        let t331 = minus_elbow_omega_x * t325;
        let t332 = t330 - t331;
        let t333 = minus_elbow_omega_x * t324;
        let t334 = elbow_omega_y_2 * t323;
        let t335 = t333 - t334;
        let t336 = elbow_omega_y_2 * t335;
        let t337 = minus_elbow_omega_z * t332;
        let t338 = t336 - t337;
        let minus_elbow_load_force_x = t329 + t338;
        let t339 = c(9.8) + elbow_acc_lin_y;
        let t340 = t325 * minus_elbow_acc_ang_x;
        let t341 = t323 * minus_elbow_acc_ang_z;
        let t342 = t340 - t341;
        let t343 = t339 - t342;
        let t344 = elbow_omega_y_2 * t325;
        let t345 = minus_elbow_omega_z * t324;
        let t346 = t344 - t345;
        let t347 = minus_elbow_omega_z * t346;
        let t348 = minus_elbow_omega_x * t335;
        let t349 = t347 - t348;
        let elbow_load_force_y = t343 + t349;
        let t350 = t324 * minus_elbow_acc_ang_x;
        let t351 = t323 * elbow_acc_ang_y;
        let t352 = t350 - t351;
        let t353 = minus_elbow_acc_lin_z + t352;
        let t354 = minus_elbow_omega_x * t332;
        let t355 = elbow_omega_y_2 * t346;
        let t356 = t354 - t355;
        let minus_elbow_load_force_z = t353 + t356;
        let t357 = c(0.16666666666666666) * minus_elbow_axes_x_x;
        let t358 = c(0.4166666666666667) * elbow_axes_x_y;
        let t359 = c(0.4166666666666667) * minus_elbow_axes_x_z;
        let t360 = c(0.16666666666666666) * elbow_axes_y_x;
        let t361 = c(0.4166666666666667) * minus_elbow_axes_y_y;
        let t362 = c(0.4166666666666667) * elbow_axes_y_z;
        let t363 = c(0.16666666666666666) * minus_elbow_axes_z_x;
        let t364 = c(0.4166666666666667) * elbow_axes_z_y;
        let t365 = c(0.4166666666666667) * minus_elbow_axes_z_z;
        let t366 = minus_elbow_axes_x_x * t357;
        let t367 = elbow_axes_x_y * t358;
        let t368 = t366 + t367;
        let t369 = minus_elbow_axes_x_z * t359;
        let t370 = t368 + t369;
        let t371 = elbow_axes_y_x * t360;
        let t372 = minus_elbow_axes_y_y * t361;
        let t373 = t371 + t372;
        let t374 = elbow_axes_y_z * t362;
        let t375 = t373 + t374;
        let t376 = minus_elbow_axes_z_x * t363;
        let t377 = elbow_axes_z_y * t364;
        let t378 = t376 + t377;
        let t379 = minus_elbow_axes_z_z * t365;
        let t380 = t378 + t379;
        let t381 = elbow_axes_y_x * t357;
        let t382 = minus_elbow_axes_y_y * t358;
        let t383 = t381 + t382;
        let t384 = elbow_axes_y_z * t359;
        let t385 = t383 + t384;
        let t386 = minus_elbow_axes_z_x * t357;
        let t387 = elbow_axes_z_y * t358;
        let t388 = t386 + t387;
        let t389 = minus_elbow_axes_z_z * t359;
        let t390 = t388 + t389;
        let t391 = minus_elbow_axes_z_x * t360;
        let t392 = elbow_axes_z_y * t361;
        let t393 = t391 + t392;
        let t394 = minus_elbow_axes_z_z * t362;
        let t395 = t393 + t394;
        let t396 = t325 * t339;
        let t397 = t324 * minus_elbow_acc_lin_z;
        let t398 = t396 - t397;
        let t399 = t370 * minus_elbow_acc_ang_x;
        let t400 = t385 * elbow_acc_ang_y;
        let t401 = t399 + t400;
        let t402 = t390 * minus_elbow_acc_ang_z;
        let t403 = t401 + t402;
        let t404 = t398 - t403;
        let t405 = minus_elbow_omega_x * t385;
        let t406 = elbow_omega_y_2 * t375;
        let t407 = t405 + t406;
        let t408 = minus_elbow_omega_z * t395;
        let t409 = t407 + t408;
        let t410 = minus_elbow_omega_x * t390;
        let t411 = elbow_omega_y_2 * t395;
        let t412 = t410 + t411;
        let t413 = minus_elbow_omega_z * t380;
        let t414 = t412 + t413;
        let t415 = elbow_omega_y_2 * t414;
        let t416 = minus_elbow_omega_z * t409;
        let t417 = t415 - t416;
        let elbow_load_moment_x = t404 - t417;
        let t418 = t325 * minus_elbow_acc_lin_x;
        let t419 = t323 * minus_elbow_acc_lin_z;
        let t420 = t418 - t419;
        let t421 = t385 * minus_elbow_acc_ang_x;
        let t422 = t375 * elbow_acc_ang_y;
        let t423 = t421 + t422;
        let t424 = t395 * minus_elbow_acc_ang_z;
        let t425 = t423 + t424;
        let t426 = t420 + t425;
        let t427 = minus_elbow_omega_x * t370;
        let t428 = elbow_omega_y_2 * t385;
        let t429 = t427 + t428;
        let t430 = minus_elbow_omega_z * t390;
        let t431 = t429 + t430;
        let t432 = minus_elbow_omega_z * t431;
        let t433 = minus_elbow_omega_x * t414;
        let t434 = t432 - t433;
        let elbow_load_moment_y = t426 + t434;
        let t435 = t324 * minus_elbow_acc_lin_x;
        let t436 = t323 * t339;
        let t437 = t435 - t436;
        let t438 = t390 * minus_elbow_acc_ang_x;
        let t439 = t395 * elbow_acc_ang_y;
        let t440 = t438 + t439;
        let t441 = t380 * minus_elbow_acc_ang_z;
        let t442 = t440 + t441;
        let t443 = t437 - t442;
        let t444 = minus_elbow_omega_x * t409;
        let t445 = elbow_omega_y_2 * t431;
        let t446 = t444 - t445;
        let elbow_load_moment_z = t443 - t446;
        /// Load on `shoulder`, [P, Eqs. (18), (19)]: 80 mul, 57 add, 0 reciprocal.
        let t447 = minus_shoulder_turn_x_x * c(0.5);
        let t448 = shoulder_turn_y_x * c(0.5);
        let t449 = minus_shoulder_turn_z_x * c(0.5);
        let t450 = t449 * minus_shoulder_acc_ang_y;
        let t451 = t448 * shoulder_acc_ang_z;
        let t452 = t450 - t451;
        let t453 = minus_shoulder_omega_z * t447;
        let t454 = minus_shoulder_omega_x * t449;
        let t455 = t453 - t454;
        let t456 = minus_shoulder_omega_x * t448;
        let t457 = shoulder_omega_y * t447;
        let t458 = t456 - t457;
        let t459 = shoulder_omega_y * t458;
        let t460 = minus_shoulder_omega_z * t455;
        let t461 = t459 - t460;
        let t462 = t452 - t461;
        let minus_shoulder_load_force_x = minus_elbow_load_force_x - t462;
        let t463 = t449 * shoulder_acc_ang_x;
        let t464 = t447 * shoulder_acc_ang_z;
        let t465 = t463 - t464;
        let t466 = c(9.8) + t465;
        let t467 = shoulder_omega_y * t449;
        let t468 = minus_shoulder_omega_z * t448;
        let t469 = t467 - t468;
        let t470 = minus_shoulder_omega_z * t469;
        let t471 = minus_shoulder_omega_x * t458;
        let t472 = t470 - t471;
        let t473 = t466 + t472;
        let shoulder_load_force_y = elbow_load_force_y + t473;
        let t474 = t448 * shoulder_acc_ang_x;
        let t475 = t447 * minus_shoulder_acc_ang_y;
        let t476 = t474 - t475;
        let t477 = minus_shoulder_omega_x * t455;
        let t478 = shoulder_omega_y * t469;
        let t479 = t477 - t478;
        let t480 = t476 - t479;
        let minus_shoulder_load_force_z = minus_elbow_load_force_z - t480;
        let t481 = minus_shoulder_turn_x_x * c(0.16666666666666666);
        let t482 = minus_shoulder_turn_x_y * c(0.4166666666666667);
        let t483 = shoulder_turn_x_z * c(0.4166666666666667);
        let t484 = shoulder_turn_y_x * c(0.16666666666666666);
        let t485 = shoulder_turn_y_y * c(0.4166666666666667);
        let t486 = minus_shoulder_turn_y_z * c(0.4166666666666667);
        let t487 = minus_shoulder_turn_z_x * c(0.16666666666666666);
        let t488 = shoulder_turn_z_y * c(0.4166666666666667);
        let t489 = shoulder_turn_z_z * c(0.4166666666666667);
        let t490 = minus_shoulder_turn_x_x * t481;
        let t491 = minus_shoulder_turn_x_y * t482;
        let t492 = t490 + t491;
        let t493 = shoulder_turn_x_z * t483;
        let t494 = t492 + t493;
        let t495 = shoulder_turn_y_x * t484;
        let t496 = shoulder_turn_y_y * t485;
        let t497 = t495 + t496;
        let t498 = minus_shoulder_turn_y_z * t486;
        let t499 = t497 + t498;
        let t500 = minus_shoulder_turn_z_x * t487;
        let t501 = shoulder_turn_z_y * t488;
        let t502 = t500 + t501;
        let t503 = shoulder_turn_z_z * t489;
        let t504 = t502 + t503;
        let t505 = shoulder_turn_y_x * t481;
        let t506 = shoulder_turn_y_y * t482;
        let t507 = t505 + t506;
        let t508 = minus_shoulder_turn_y_z * t483;
        let t509 = t507 + t508;
        let t510 = minus_shoulder_turn_z_x * t481;
        let t511 = shoulder_turn_z_y * t482;
        let t512 = t510 - t511;
        let t513 = shoulder_turn_z_z * t483;
        let t514 = t512 + t513;
        let t515 = minus_shoulder_turn_z_x * t484;
        let t516 = shoulder_turn_z_y * t485;
        let t517 = t515 - t516;
        let t518 = shoulder_turn_z_z * t486;
        let t519 = t517 + t518;
        let t520 = shoulder_turn_y_x * minus_elbow_load_force_z;
        let t521 = minus_shoulder_turn_z_x * elbow_load_force_y;
        let t522 = t520 - t521;
        let t523 = elbow_load_moment_x - t522;
        let t524 = minus_shoulder_turn_z_x * c(4.9);
        let t525 = t494 * shoulder_acc_ang_x;
        let t526 = t509 * minus_shoulder_acc_ang_y;
        let t527 = t525 + t526;
        let t528 = t514 * shoulder_acc_ang_z;
        let t529 = t527 + t528;
        let t530 = t524 + t529;
        let t531 = minus_shoulder_omega_x * t509;
        let t532 = shoulder_omega_y * t499;
        let t533 = t531 + t532;
        let t534 = minus_shoulder_omega_z * t519;
        let t535 = t533 + t534;
        let t536 = minus_shoulder_omega_x * t514;
        let t537 = shoulder_omega_y * t519;
        let t538 = t536 + t537;
        let t539 = minus_shoulder_omega_z * t504;
        let t540 = t538 + t539;
        let t541 = shoulder_omega_y * t540;
        let t542 = minus_shoulder_omega_z * t535;
        let t543 = t541 - t542;
        let t544 = t530 - t543;
        let shoulder_load_moment_x = t523 + t544;
        let t545 = minus_shoulder_turn_z_x * minus_elbow_load_force_x;
        let t546 = minus_shoulder_turn_x_x * minus_elbow_load_force_z;
        let t547 = t545 - t546;
        let t548 = elbow_load_moment_y + t547;
        let t549 = t509 * shoulder_acc_ang_x;
        let t550 = t499 * minus_shoulder_acc_ang_y;
        let t551 = t549 + t550;
        let t552 = t519 * shoulder_acc_ang_z;
        let t553 = t551 + t552;
        let t554 = minus_shoulder_omega_x * t494;
        let t555 = shoulder_omega_y * t509;
        let t556 = t554 + t555;
        let t557 = minus_shoulder_omega_z * t514;
        let t558 = t556 + t557;
        let t559 = minus_shoulder_omega_z * t558;
        let t560 = minus_shoulder_omega_x * t540;
        let t561 = t559 - t560;
        let t562 = t553 - t561;
        let shoulder_load_moment_y = t548 - t562;
        let t563 = minus_shoulder_turn_x_x * elbow_load_force_y;
        let t564 = shoulder_turn_y_x * minus_elbow_load_force_x;
        let t565 = t563 - t564;
        let t566 = elbow_load_moment_z - t565;
        let t567 = minus_shoulder_turn_x_x * c(4.9);
        let t568 = t514 * shoulder_acc_ang_x;
        let t569 = t519 * minus_shoulder_acc_ang_y;
        let t570 = t568 + t569;
        let t571 = t504 * shoulder_acc_ang_z;
        let t572 = t570 + t571;
        let t573 = t567 - t572;
        let t574 = minus_shoulder_omega_x * t535;
        let t575 = shoulder_omega_y * t558;
        let t576 = t574 - t575;
        let t577 = t573 + t576;
        let shoulder_load_moment_z = t566 - t577;
        /// Results: 57 mul, 49 add, 0 reciprocal.
        let t578 = minus_shoulder_turn_x_x * minus_shoulder_omega_x;
        let t579 = shoulder_turn_y_x * shoulder_omega_y;
        let t580 = t578 + t579;
        let t581 = minus_shoulder_turn_z_x * minus_shoulder_omega_z;
        let t582 = t580 + t581;
        let t583 = minus_shoulder_turn_x_y * minus_shoulder_omega_x;
        let t584 = shoulder_turn_y_y * shoulder_omega_y;
        let t585 = t583 + t584;
        let t586 = shoulder_turn_z_y * minus_shoulder_omega_z;
        let t587 = t585 - t586;
        let t588 = shoulder_turn_x_z * minus_shoulder_omega_x;
        let t589 = minus_shoulder_turn_y_z * shoulder_omega_y;
        let t590 = t588 + t589;
        let t591 = shoulder_turn_z_z * minus_shoulder_omega_z;
        let t592 = t590 + t591;
        let t593 = c(0.16666666666666666) * t582;
        let t594 = t587 * c(0.16666666666666669);
        let t595 = t592 * c(0.16666666666666669);
        let t596 = t582 * t593;
        let t597 = t587 * t594;
        let t598 = t596 + t597;
        let t599 = t592 * t595;
        let t600 = t598 + t599;
        let t601 = t469 * t469;
        let t602 = t455 * t455;
        let t603 = t601 + t602;
        let t604 = t458 * t458;
        let t605 = t603 + t604;
        let t606 = t600 + t605;
        let t607 = t252 + t346;
        let t608 = t244 + t332;
        let t609 = t247 + t335;
        let t610 = minus_elbow_axes_x_x * minus_elbow_omega_x;
        let t611 = elbow_axes_y_x * elbow_omega_y_2;
        let t612 = t610 + t611;
        let t613 = minus_elbow_axes_z_x * minus_elbow_omega_z;
        let t614 = t612 + t613;
        let t615 = elbow_axes_x_y * minus_elbow_omega_x;
        let t616 = minus_elbow_axes_y_y * elbow_omega_y_2;
        let t617 = t615 + t616;
        let t618 = elbow_axes_z_y * minus_elbow_omega_z;
        let t619 = t617 + t618;
        let t620 = minus_elbow_axes_x_z * minus_elbow_omega_x;
        let t621 = elbow_axes_y_z * elbow_omega_y_2;
        let t622 = t620 + t621;
        let t623 = minus_elbow_axes_z_z * minus_elbow_omega_z;
        let t624 = t622 + t623;
        let t625 = c(0.16666666666666666) * t614;
        let t626 = c(0.16666666666666669) * t619;
        let t627 = c(0.16666666666666669) * t624;
        let t628 = t614 * t625;
        let t629 = t619 * t626;
        let t630 = t628 + t629;
        let t631 = t624 * t627;
        let t632 = t630 + t631;
        let t633 = t607 * t607;
        let t634 = t608 * t608;
        let t635 = t633 + t634;
        let t636 = t609 * t609;
        let t637 = t635 + t636;
        let t638 = t632 + t637;
        let t639 = t606 + t638;
        let t640 = c(0.5) * t639;
        let t641 = shoulder_turn_y_x * c(4.9);
        let t642 = shoulder_turn_y_x + t324;
        let t643 = c(9.8) * t642;
        let t644 = t641 + t643;
        let t645 = minus_shoulder_turn_x_x + minus_elbow_axes_x_x;
        let t646 = shoulder_turn_y_x + elbow_axes_y_x;
        let t647 = minus_shoulder_turn_z_x + minus_elbow_axes_z_x;
        let t648 = minus_elbow_axes_z_x * elbow_omega_y_2;
        let t649 = elbow_axes_y_x * minus_elbow_omega_z;
        let t650 = t648 - t649;
        let t651 = t252 + t650;
        let t652 = minus_elbow_axes_x_x * minus_elbow_omega_z;
        let t653 = minus_elbow_axes_z_x * minus_elbow_omega_x;
        let t654 = t652 - t653;
        let t655 = t244 + t654;
        let t656 = elbow_axes_y_x * minus_elbow_omega_x;
        let t657 = minus_elbow_axes_x_x * elbow_omega_y_2;
        let t658 = t656 - t657;
        let t659 = t247 + t658;
        let t660 = minus_elbow_axes_z_x * elbow_acc_ang_y;
        let t661 = elbow_axes_y_x * minus_elbow_acc_ang_z;
        let t662 = t660 - t661;
        let t663 = minus_elbow_acc_lin_x + t662;
        let t664 = elbow_omega_y_2 * t658;
        let t665 = minus_elbow_omega_z * t654;
        let t666 = t664 - t665;
        let t667 = t663 + t666;
        let t668 = minus_elbow_axes_x_x * minus_elbow_acc_ang_z;
        let t669 = minus_elbow_axes_z_x * minus_elbow_acc_ang_x;
        let t670 = t668 - t669;
        let t671 = elbow_acc_lin_y + t670;
        let t672 = minus_elbow_omega_z * t650;
        let t673 = minus_elbow_omega_x * t658;
        let t674 = t672 - t673;
        let t675 = t671 + t674;
        let t676 = elbow_axes_y_x * minus_elbow_acc_ang_x;
        let t677 = minus_elbow_axes_x_x * elbow_acc_ang_y;
        let t678 = t676 - t677;
        let t679 = minus_elbow_acc_lin_z + t678;
        let t680 = minus_elbow_omega_x * t654;
        let t681 = elbow_omega_y_2 * t650;
        let t682 = t680 - t681;
        let t683 = t679 + t682;
        ::mstmm::generated::regular(
            &["elbow", "elbow", "elbow", "shoulder", "shoulder", "shoulder"],
            [
                c(0.16666666666666666),
                c(0.4166666666666667),
                c(0.4166666666666667),
                c(0.16666666666666666),
                shoulder_j_yy,
                shoulder_d2,
            ],
            [c(1.0), c(1.0), c(1.0), c(1.0), c(1.0), c(1.0)],
            [
                -minus_shoulder_a_ang_x,
                -minus_shoulder_a_ang_y,
                -minus_shoulder_a_ang_z,
                -t304,
                -t303,
                -t302,
            ],
        )?;
        at.accelerations.data.0 = [
            [
                -minus_shoulder_a_ang_x,
                -minus_shoulder_a_ang_y,
                -minus_shoulder_a_ang_z,
                -t304,
                -t303,
                -t302,
            ],
        ];
        at.efforts.data.0 = [[c(0.0), c(0.0), c(0.0), c(0.0), c(0.0), c(0.0)]];
        at.kinetic_energy = t640;
        at.potential_energy = t644;
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
                    [
                        -shoulder_load_moment_x,
                        -shoulder_load_moment_y,
                        -shoulder_load_moment_z,
                    ],
                    [
                        -minus_shoulder_load_force_x,
                        shoulder_load_force_y,
                        -minus_shoulder_load_force_z,
                    ],
                ),
            ),
            ::mstmm::Point::new(
                [c(0.0), c(0.0), c(0.0)],
                [
                    [
                        -minus_shoulder_turn_x_x,
                        -minus_shoulder_turn_x_y,
                        shoulder_turn_x_z,
                    ],
                    [shoulder_turn_y_x, shoulder_turn_y_y, -minus_shoulder_turn_y_z],
                    [-minus_shoulder_turn_z_x, shoulder_turn_z_y, shoulder_turn_z_z],
                ],
                [c(0.0), c(0.0), c(0.0)],
                [-minus_shoulder_omega_x, shoulder_omega_y, -minus_shoulder_omega_z],
                ::mstmm::StateVector::new(
                    [c(0.0), c(0.0), c(0.0)],
                    [shoulder_acc_ang_x, -minus_shoulder_acc_ang_y, shoulder_acc_ang_z],
                    [
                        -shoulder_load_moment_x,
                        -shoulder_load_moment_y,
                        -shoulder_load_moment_z,
                    ],
                    [
                        -minus_shoulder_load_force_x,
                        shoulder_load_force_y,
                        -minus_shoulder_load_force_z,
                    ],
                ),
            ),
            ::mstmm::Point::new(
                [-minus_shoulder_turn_x_x, shoulder_turn_y_x, -minus_shoulder_turn_z_x],
                [
                    [
                        -minus_shoulder_turn_x_x,
                        -minus_shoulder_turn_x_y,
                        shoulder_turn_x_z,
                    ],
                    [shoulder_turn_y_x, shoulder_turn_y_y, -minus_shoulder_turn_y_z],
                    [-minus_shoulder_turn_z_x, shoulder_turn_z_y, shoulder_turn_z_z],
                ],
                [-t252, t244, -t247],
                [-minus_shoulder_omega_x, shoulder_omega_y, -minus_shoulder_omega_z],
                ::mstmm::StateVector::new(
                    [-minus_elbow_acc_lin_x, elbow_acc_lin_y, -minus_elbow_acc_lin_z],
                    [shoulder_acc_ang_x, -minus_shoulder_acc_ang_y, shoulder_acc_ang_z],
                    [-elbow_load_moment_x, -elbow_load_moment_y, -elbow_load_moment_z],
                    [
                        -minus_elbow_load_force_x,
                        elbow_load_force_y,
                        -minus_elbow_load_force_z,
                    ],
                ),
            ),
            ::mstmm::Point::new(
                [-minus_shoulder_turn_x_x, shoulder_turn_y_x, -minus_shoulder_turn_z_x],
                [
                    [-minus_elbow_axes_x_x, elbow_axes_x_y, -minus_elbow_axes_x_z],
                    [elbow_axes_y_x, -minus_elbow_axes_y_y, elbow_axes_y_z],
                    [-minus_elbow_axes_z_x, elbow_axes_z_y, -minus_elbow_axes_z_z],
                ],
                [-t252, t244, -t247],
                [-minus_elbow_omega_x, elbow_omega_y_2, -minus_elbow_omega_z],
                ::mstmm::StateVector::new(
                    [-minus_elbow_acc_lin_x, elbow_acc_lin_y, -minus_elbow_acc_lin_z],
                    [-minus_elbow_acc_ang_x, elbow_acc_ang_y, -minus_elbow_acc_ang_z],
                    [-elbow_load_moment_x, -elbow_load_moment_y, -elbow_load_moment_z],
                    [
                        -minus_elbow_load_force_x,
                        elbow_load_force_y,
                        -minus_elbow_load_force_z,
                    ],
                ),
            ),
            ::mstmm::Point::new(
                [-t645, t646, -t647],
                [
                    [-minus_elbow_axes_x_x, elbow_axes_x_y, -minus_elbow_axes_x_z],
                    [elbow_axes_y_x, -minus_elbow_axes_y_y, elbow_axes_y_z],
                    [-minus_elbow_axes_z_x, elbow_axes_z_y, -minus_elbow_axes_z_z],
                ],
                [-t651, t655, -t659],
                [-minus_elbow_omega_x, elbow_omega_y_2, -minus_elbow_omega_z],
                ::mstmm::StateVector::new(
                    [-t667, t675, -t683],
                    [-minus_elbow_acc_ang_x, elbow_acc_ang_y, -minus_elbow_acc_ang_z],
                    [c(0.0), c(0.0), c(0.0)],
                    [c(0.0), c(0.0), c(0.0)],
                ),
            ),
        ];
        ::core::result::Result::Ok(())
    }
    /// Kinetic and potential energy in J; the potential is zero with every centre of mass at
    /// the inertial origin.
    ///
    /// 226 operations: 132 mul, 94 add, 0 reciprocal.
    ///
    /// | section | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|
    /// | Motion across `shoulder` | 21 | 18 | 0 | 0 | 0 |
    /// | Motion across `elbow` | 48 | 39 | 0 | 0 | 0 |
    /// | Results | 63 | 37 | 0 | 0 | 0 |
    #[must_use]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn energy(&self, state: &DoubleBallState<T>) -> ::mstmm::Energy<T> {
        let c = T::constant;
        let [[shoulder_qw, shoulder_qx, shoulder_qy, shoulder_qz, elbow_qw, elbow_qx,
        elbow_qy, elbow_qz]] = state.q.data.0;
        let [[shoulder_wx, shoulder_wy, shoulder_wz, elbow_wx, elbow_wy, elbow_wz]] = state
            .v
            .data
            .0;
        /// Motion across `shoulder`, [P, Eqs. (1), (13), (36)]: 21 mul, 18 add, 0 reciprocal.
        let t0 = shoulder_qy * c(2.0);
        let t1 = shoulder_qz * c(2.0);
        let t2 = shoulder_qy * t0;
        let t3 = shoulder_qz * t1;
        let t4 = t2 + t3;
        let minus_shoulder_axes_x_x = t4 - c(1.0);
        let t5 = shoulder_qw * t1;
        let t6 = shoulder_qx * t0;
        let minus_shoulder_axes_x_y = t5 - t6;
        let t7 = shoulder_qw * t0;
        let t8 = shoulder_qx * t1;
        let shoulder_axes_x_z = t7 + t8;
        let shoulder_axes_y_x = t5 + t6;
        let t9 = shoulder_qx * c(2.0);
        let t10 = shoulder_qx * t9;
        let t11 = t10 + t3;
        let shoulder_axes_y_y = c(1.0) - t11;
        let t12 = shoulder_qw * t9;
        let t13 = shoulder_qy * t1;
        let minus_shoulder_axes_y_z = t12 - t13;
        let minus_shoulder_axes_z_x = t7 - t8;
        let shoulder_axes_z_y = t12 + t13;
        let t14 = t10 + t2;
        let shoulder_axes_z_z = c(1.0) - t14;
        let t15 = shoulder_wx * minus_shoulder_axes_x_x;
        let t16 = shoulder_wy * minus_shoulder_axes_x_y;
        let t17 = t15 + t16;
        let t18 = shoulder_wz * shoulder_axes_x_z;
        let minus_shoulder_omega_x = t17 - t18;
        let t19 = shoulder_wx * shoulder_axes_y_x;
        let t20 = shoulder_wy * shoulder_axes_y_y;
        let t21 = t19 + t20;
        let t22 = shoulder_wz * minus_shoulder_axes_y_z;
        let shoulder_omega_y = t21 - t22;
        let t23 = shoulder_wx * minus_shoulder_axes_z_x;
        let t24 = shoulder_wy * shoulder_axes_z_y;
        let t25 = t23 - t24;
        let t26 = shoulder_wz * shoulder_axes_z_z;
        let minus_shoulder_omega_z = t25 - t26;
        /// Motion across `elbow`, [P, Eqs. (1), (13), (36)]: 48 mul, 39 add, 0 reciprocal.
        let t27 = elbow_qy * c(2.0);
        let t28 = elbow_qz * c(2.0);
        let t29 = elbow_qw * t27;
        let t30 = elbow_qw * t28;
        let t31 = elbow_qx * t27;
        let t32 = elbow_qx * t28;
        let t33 = elbow_qy * t27;
        let t34 = elbow_qz * t28;
        let t35 = t33 + t34;
        let t36 = c(1.0) - t35;
        let t37 = t30 + t31;
        let t38 = t29 - t32;
        let t39 = minus_shoulder_axes_x_x * t36;
        let t40 = minus_shoulder_axes_x_y * t37;
        let t41 = t39 + t40;
        let t42 = shoulder_axes_x_z * t38;
        let minus_elbow_axes_x_x = t41 + t42;
        let t43 = elbow_qx * c(2.0);
        let t44 = elbow_qw * t43;
        let t45 = elbow_qx * t43;
        let t46 = elbow_qy * t28;
        let t47 = t30 - t31;
        let t48 = t45 + t34;
        let t49 = c(1.0) - t48;
        let t50 = t44 + t46;
        let t51 = minus_shoulder_axes_x_x * t47;
        let t52 = minus_shoulder_axes_x_y * t49;
        let t53 = t51 - t52;
        let t54 = shoulder_axes_x_z * t50;
        let elbow_axes_x_y = t53 + t54;
        let t55 = t29 + t32;
        let t56 = t44 - t46;
        let t57 = t45 + t33;
        let t58 = c(1.0) - t57;
        let t59 = minus_shoulder_axes_x_x * t55;
        let t60 = minus_shoulder_axes_x_y * t56;
        let t61 = t59 - t60;
        let t62 = shoulder_axes_x_z * t58;
        let minus_elbow_axes_x_z = t61 - t62;
        let t63 = shoulder_axes_y_x * t36;
        let t64 = shoulder_axes_y_y * t37;
        let t65 = t63 + t64;
        let t66 = minus_shoulder_axes_y_z * t38;
        let elbow_axes_y_x = t65 + t66;
        let t67 = shoulder_axes_y_x * t47;
        let t68 = shoulder_axes_y_y * t49;
        let t69 = t67 - t68;
        let t70 = minus_shoulder_axes_y_z * t50;
        let minus_elbow_axes_y_y = t69 + t70;
        let t71 = shoulder_axes_y_x * t55;
        let t72 = shoulder_axes_y_y * t56;
        let t73 = t71 - t72;
        let t74 = minus_shoulder_axes_y_z * t58;
        let elbow_axes_y_z = t73 - t74;
        let t75 = minus_shoulder_axes_z_x * t36;
        let t76 = shoulder_axes_z_y * t37;
        let t77 = t75 - t76;
        let t78 = shoulder_axes_z_z * t38;
        let minus_elbow_axes_z_x = t77 + t78;
        let t79 = minus_shoulder_axes_z_x * t47;
        let t80 = shoulder_axes_z_y * t49;
        let t81 = t79 + t80;
        let t82 = shoulder_axes_z_z * t50;
        let elbow_axes_z_y = t81 + t82;
        let t83 = minus_shoulder_axes_z_x * t55;
        let t84 = shoulder_axes_z_y * t56;
        let t85 = t83 + t84;
        let t86 = shoulder_axes_z_z * t58;
        let minus_elbow_axes_z_z = t85 - t86;
        let t87 = elbow_wx * minus_elbow_axes_x_x;
        let t88 = elbow_wy * elbow_axes_x_y;
        let t89 = t87 - t88;
        let t90 = elbow_wz * minus_elbow_axes_x_z;
        let t91 = t89 + t90;
        let minus_elbow_omega_x = minus_shoulder_omega_x + t91;
        let t92 = elbow_wx * elbow_axes_y_x;
        let t93 = elbow_wy * minus_elbow_axes_y_y;
        let t94 = t92 - t93;
        let t95 = elbow_wz * elbow_axes_y_z;
        let t96 = t94 + t95;
        let elbow_omega_y = shoulder_omega_y + t96;
        let t97 = elbow_wx * minus_elbow_axes_z_x;
        let t98 = elbow_wy * elbow_axes_z_y;
        let t99 = t97 - t98;
        let t100 = elbow_wz * minus_elbow_axes_z_z;
        let t101 = t99 + t100;
        let minus_elbow_omega_z = minus_shoulder_omega_z + t101;
        /// Results: 63 mul, 37 add, 0 reciprocal.
        let t102 = minus_shoulder_axes_x_x * c(0.5);
        let t103 = shoulder_axes_y_x * c(0.5);
        let t104 = minus_shoulder_axes_z_x * c(0.5);
        let t105 = minus_shoulder_axes_z_x * shoulder_omega_y;
        let t106 = shoulder_axes_y_x * minus_shoulder_omega_z;
        let t107 = t105 - t106;
        let t108 = minus_shoulder_axes_x_x * minus_shoulder_omega_z;
        let t109 = minus_shoulder_axes_z_x * minus_shoulder_omega_x;
        let t110 = t108 - t109;
        let t111 = shoulder_axes_y_x * minus_shoulder_omega_x;
        let t112 = minus_shoulder_axes_x_x * shoulder_omega_y;
        let t113 = t111 - t112;
        let t114 = c(0.5) * minus_elbow_axes_x_x;
        let t115 = c(0.5) * elbow_axes_y_x;
        let t116 = c(0.5) * minus_elbow_axes_z_x;
        let t117 = elbow_omega_y * t116;
        let t118 = minus_elbow_omega_z * t115;
        let t119 = t117 - t118;
        let t120 = minus_elbow_omega_z * t114;
        let t121 = minus_elbow_omega_x * t116;
        let t122 = t120 - t121;
        let t123 = minus_elbow_omega_x * t115;
        let t124 = elbow_omega_y * t114;
        let t125 = t123 - t124;
        let t126 = shoulder_omega_y * t104;
        let t127 = minus_shoulder_omega_z * t103;
        let t128 = t126 - t127;
        let t129 = minus_shoulder_omega_z * t102;
        let t130 = minus_shoulder_omega_x * t104;
        let t131 = t129 - t130;
        let t132 = minus_shoulder_omega_x * t103;
        let t133 = shoulder_omega_y * t102;
        let t134 = t132 - t133;
        let t135 = minus_shoulder_axes_x_x * minus_shoulder_omega_x;
        let t136 = shoulder_axes_y_x * shoulder_omega_y;
        let t137 = t135 + t136;
        let t138 = minus_shoulder_axes_z_x * minus_shoulder_omega_z;
        let t139 = t137 + t138;
        let t140 = minus_shoulder_axes_x_y * minus_shoulder_omega_x;
        let t141 = shoulder_axes_y_y * shoulder_omega_y;
        let t142 = t140 + t141;
        let t143 = shoulder_axes_z_y * minus_shoulder_omega_z;
        let t144 = t142 - t143;
        let t145 = shoulder_axes_x_z * minus_shoulder_omega_x;
        let t146 = minus_shoulder_axes_y_z * shoulder_omega_y;
        let t147 = t145 + t146;
        let t148 = shoulder_axes_z_z * minus_shoulder_omega_z;
        let t149 = t147 + t148;
        let t150 = c(0.16666666666666666) * t139;
        let t151 = t144 * c(0.16666666666666669);
        let t152 = t149 * c(0.16666666666666669);
        let t153 = t139 * t150;
        let t154 = t144 * t151;
        let t155 = t153 + t154;
        let t156 = t149 * t152;
        let t157 = t155 + t156;
        let t158 = t128 * t128;
        let t159 = t131 * t131;
        let t160 = t158 + t159;
        let t161 = t134 * t134;
        let t162 = t160 + t161;
        let t163 = t157 + t162;
        let t164 = t107 + t119;
        let t165 = t110 + t122;
        let t166 = t113 + t125;
        let t167 = minus_elbow_axes_x_x * minus_elbow_omega_x;
        let t168 = elbow_axes_y_x * elbow_omega_y;
        let t169 = t167 + t168;
        let t170 = minus_elbow_axes_z_x * minus_elbow_omega_z;
        let t171 = t169 + t170;
        let t172 = elbow_axes_x_y * minus_elbow_omega_x;
        let t173 = minus_elbow_axes_y_y * elbow_omega_y;
        let t174 = t172 + t173;
        let t175 = elbow_axes_z_y * minus_elbow_omega_z;
        let t176 = t174 + t175;
        let t177 = minus_elbow_axes_x_z * minus_elbow_omega_x;
        let t178 = elbow_axes_y_z * elbow_omega_y;
        let t179 = t177 + t178;
        let t180 = minus_elbow_axes_z_z * minus_elbow_omega_z;
        let t181 = t179 + t180;
        let t182 = c(0.16666666666666666) * t171;
        let t183 = c(0.16666666666666669) * t176;
        let t184 = c(0.16666666666666669) * t181;
        let t185 = t171 * t182;
        let t186 = t176 * t183;
        let t187 = t185 + t186;
        let t188 = t181 * t184;
        let t189 = t187 + t188;
        let t190 = t164 * t164;
        let t191 = t165 * t165;
        let t192 = t190 + t191;
        let t193 = t166 * t166;
        let t194 = t192 + t193;
        let t195 = t189 + t194;
        let t196 = t163 + t195;
        let t197 = c(0.5) * t196;
        let t198 = shoulder_axes_y_x * c(4.9);
        let t199 = shoulder_axes_y_x + t115;
        let t200 = c(9.8) * t199;
        let t201 = t198 + t200;
        ::mstmm::Energy {
            kinetic: t197,
            potential: t201,
        }
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::Chain for DoubleBall<T> {
    type Scalar = T;
    type State = DoubleBallState<T>;
    type Inputs = DoubleBallInputs<T>;
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn derivative_into(
        &self,
        state: &DoubleBallState<T>,
        inputs: &DoubleBallInputs<T>,
        rate: &mut DoubleBallState<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.accelerations_into(state, inputs, &mut rate.v)?;
        rate.q.data.0 = {
            let c = T::constant;
            let [[shoulder_qw, shoulder_qx, shoulder_qy, shoulder_qz, elbow_qw, elbow_qx,
            elbow_qy, elbow_qz]] = state.q.data.0;
            let [[shoulder_wx, shoulder_wy, shoulder_wz, elbow_wx, elbow_wy, elbow_wz],
            ] = state.v.data.0;
            /// Results: 30 mul, 16 add, 0 reciprocal.
            let t0 = shoulder_wz * c(0.5);
            let t1 = shoulder_wy * c(0.5);
            let t2 = shoulder_wx * c(0.5);
            let t3 = shoulder_qx * t2;
            let t4 = shoulder_qy * t1;
            let t5 = t3 + t4;
            let t6 = shoulder_qz * t0;
            let t7 = t5 + t6;
            let t8 = shoulder_qw * t2;
            let t9 = shoulder_qy * t0;
            let t10 = shoulder_qz * t1;
            let t11 = t9 - t10;
            let t12 = t8 + t11;
            let t13 = shoulder_qw * t1;
            let t14 = shoulder_qz * t2;
            let t15 = shoulder_qx * t0;
            let t16 = t14 - t15;
            let t17 = t13 + t16;
            let t18 = shoulder_qw * t0;
            let t19 = shoulder_qx * t1;
            let t20 = shoulder_qy * t2;
            let t21 = t19 - t20;
            let t22 = t18 + t21;
            let t23 = elbow_wx * c(0.5);
            let t24 = elbow_wy * c(0.5);
            let t25 = elbow_wz * c(0.5);
            let t26 = elbow_qx * t23;
            let t27 = elbow_qy * t24;
            let t28 = t26 + t27;
            let t29 = elbow_qz * t25;
            let t30 = t28 + t29;
            let t31 = elbow_qw * t23;
            let t32 = elbow_qy * t25;
            let t33 = elbow_qz * t24;
            let t34 = t32 - t33;
            let t35 = t31 + t34;
            let t36 = elbow_qw * t24;
            let t37 = elbow_qz * t23;
            let t38 = elbow_qx * t25;
            let t39 = t37 - t38;
            let t40 = t36 + t39;
            let t41 = elbow_qw * t25;
            let t42 = elbow_qx * t24;
            let t43 = elbow_qy * t23;
            let t44 = t42 - t43;
            let t45 = t41 + t44;
            [[-t7, t12, t17, t22, -t30, t35, t40, t45]]
        };
        ::core::result::Result::Ok(())
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn normalize(&self, state: &mut DoubleBallState<T>) {
        state.q.data.0 = {
            let [[shoulder_qw, shoulder_qx, shoulder_qy, shoulder_qz, elbow_qw, elbow_qx,
            elbow_qy, elbow_qz]] = state.q.data.0;
            /// Results: 16 mul, 6 add, 2 reciprocal, 2 square root.
            let t0 = shoulder_qw * shoulder_qw;
            let t1 = shoulder_qx * shoulder_qx;
            let t2 = t0 + t1;
            let t3 = shoulder_qy * shoulder_qy;
            let t4 = t2 + t3;
            let t5 = shoulder_qz * shoulder_qz;
            let t6 = t4 + t5;
            let t7 = T::sqrt(t6);
            let t8 = T::recip(t7);
            let t9 = shoulder_qw * t8;
            let t10 = shoulder_qx * t8;
            let t11 = shoulder_qy * t8;
            let t12 = shoulder_qz * t8;
            let t13 = elbow_qw * elbow_qw;
            let t14 = elbow_qx * elbow_qx;
            let t15 = t13 + t14;
            let t16 = elbow_qy * elbow_qy;
            let t17 = t15 + t16;
            let t18 = elbow_qz * elbow_qz;
            let t19 = t17 + t18;
            let t20 = T::sqrt(t19);
            let t21 = T::recip(t20);
            let t22 = elbow_qw * t21;
            let t23 = elbow_qx * t21;
            let t24 = elbow_qy * t21;
            let t25 = elbow_qz * t21;
            [[t9, t10, t11, t12, t22, t23, t24, t25]]
        };
    }
}
/// Coordinates and rates of [`DoubleBall`] at a time.
///
/// The hinges lie one after the other in the order written. [`Default`] is every hinge at
/// rest in its zero position.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code)]
struct DoubleBallState<T> {
    /// Coordinates: angles in rad, lengths in m, unit quaternions as w, x, y, z.
    q: ::mstmm::nalgebra::SVector<T, 8>,
    /// Rates in rad/s and m/s.
    v: ::mstmm::nalgebra::SVector<T, 6>,
    /// Time in s.
    t: T,
}
#[allow(dead_code)]
impl<T: ::mstmm::Scalar> DoubleBallState<T> {
    /// Coordinates and rates of hinge `shoulder`.
    #[inline]
    #[must_use]
    fn shoulder(&self) -> ::mstmm::BallState<T> {
        let [[q0, q1, q2, q3, ..]] = self.q.data.0;
        let [[v0, v1, v2, ..]] = self.v.data.0;
        ::mstmm::BallState::new([q0, q1, q2, q3], [v0, v1, v2])
    }
    /// Coordinates and rates of hinge `shoulder`, to be changed.
    #[inline]
    fn shoulder_mut(&mut self) -> ::mstmm::BallStateMut<'_, T> {
        let [[q0, q1, q2, q3, ..]] = &mut self.q.data.0;
        let [[v0, v1, v2, ..]] = &mut self.v.data.0;
        ::mstmm::BallStateMut::new([q0, q1, q2, q3], [v0, v1, v2])
    }
    /// Coordinates and rates of hinge `elbow`.
    #[inline]
    #[must_use]
    fn elbow(&self) -> ::mstmm::BallState<T> {
        let [[_, _, _, _, q4, q5, q6, q7, ..]] = self.q.data.0;
        let [[_, _, _, v3, v4, v5, ..]] = self.v.data.0;
        ::mstmm::BallState::new([q4, q5, q6, q7], [v3, v4, v5])
    }
    /// Coordinates and rates of hinge `elbow`, to be changed.
    #[inline]
    fn elbow_mut(&mut self) -> ::mstmm::BallStateMut<'_, T> {
        let [[_, _, _, _, q4, q5, q6, q7, ..]] = &mut self.q.data.0;
        let [[_, _, _, v3, v4, v5, ..]] = &mut self.v.data.0;
        ::mstmm::BallStateMut::new([q4, q5, q6, q7], [v3, v4, v5])
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for DoubleBallState<T> {
    fn default() -> Self {
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        let _ = one;
        Self {
            q: ::mstmm::nalgebra::SVector::from([
                one,
                zero,
                zero,
                zero,
                one,
                zero,
                zero,
                zero,
            ]),
            v: ::mstmm::nalgebra::SVector::from([zero; 6]),
            t: zero,
        }
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::ChainState for DoubleBallState<T> {
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
/// What drives [`DoubleBall`] from outside, given at every step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(dead_code)]
struct DoubleBallInputs<T> {
    none: ::core::marker::PhantomData<T>,
}
impl<T: ::mstmm::Scalar> ::core::default::Default for DoubleBallInputs<T> {
    #[inline]
    fn default() -> Self {
        Self {
            none: ::core::marker::PhantomData,
        }
    }
}
#[allow(dead_code)]
impl<T: ::mstmm::Scalar> DoubleBall<T> {
    /// Inputs that are all zero.
    #[inline]
    #[must_use]
    fn no_inputs(&self) -> DoubleBallInputs<T> {
        ::core::default::Default::default()
    }
}
/// Results of [`DoubleBall::solve_into`].
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code)]
struct DoubleBallWorkspace<T> {
    accelerations: ::mstmm::nalgebra::SVector<T, 6>,
    efforts: ::mstmm::nalgebra::SVector<T, 6>,
    kinetic_energy: T,
    potential_energy: T,
    points: [::mstmm::Point<T>; 5],
}
#[allow(dead_code)]
impl<T: ::mstmm::Scalar> DoubleBallWorkspace<T> {
    /// Accelerations `v̇` of all hinges, in the order of the rates.
    #[inline]
    fn accelerations(&self) -> &::mstmm::nalgebra::SVector<T, 6> {
        &self.accelerations
    }
    /// Kinetic energy in J.
    #[inline]
    fn kinetic_energy(&self) -> T {
        self.kinetic_energy
    }
    /// Potential energy in J; zero with every centre of mass at the inertial origin.
    #[inline]
    fn potential_energy(&self) -> T {
        self.potential_energy
    }
    /// All connection points in the order written: the first element's input, then every
    /// element's output.
    #[inline]
    fn points(&self) -> &[::mstmm::Point<T>; 5] {
        &self.points
    }
    /// Acceleration, effort, input and output of hinge `shoulder`.
    #[inline]
    fn shoulder(&self) -> ::mstmm::HingeResult<'_, T, ::mstmm::nalgebra::Vector3<T>> {
        let [input, output, ..] = &self.points;
        ::mstmm::HingeResult::new(
            {
                let [[x, y, z, ..]] = self.accelerations.data.0;
                ::mstmm::nalgebra::Vector3::from([x, y, z])
            },
            {
                let [[x, y, z, ..]] = self.efforts.data.0;
                ::mstmm::nalgebra::Vector3::from([x, y, z])
            },
            input,
            output,
        )
    }
    /// Input and output of body `upper`.
    #[inline]
    fn upper(&self) -> ::mstmm::BodyResult<'_, T> {
        let [_, input, output, ..] = &self.points;
        ::mstmm::BodyResult::new(input, output)
    }
    /// Acceleration, effort, input and output of hinge `elbow`.
    #[inline]
    fn elbow(&self) -> ::mstmm::HingeResult<'_, T, ::mstmm::nalgebra::Vector3<T>> {
        let [_, _, input, output, ..] = &self.points;
        ::mstmm::HingeResult::new(
            {
                let [[_, _, _, x, y, z, ..]] = self.accelerations.data.0;
                ::mstmm::nalgebra::Vector3::from([x, y, z])
            },
            {
                let [[_, _, _, x, y, z, ..]] = self.efforts.data.0;
                ::mstmm::nalgebra::Vector3::from([x, y, z])
            },
            input,
            output,
        )
    }
    /// Input and output of body `lower`.
    #[inline]
    fn lower(&self) -> ::mstmm::BodyResult<'_, T> {
        let [_, _, _, input, output, ..] = &self.points;
        ::mstmm::BodyResult::new(input, output)
    }
}
#[allow(dead_code)]
impl<T: ::mstmm::Scalar> DoubleBall<T> {
    /// Room for the results of [`solve_into`](Self::solve_into).
    #[must_use]
    fn workspace(&self) -> DoubleBallWorkspace<T> {
        let zero = T::constant(0.0);
        DoubleBallWorkspace {
            accelerations: ::mstmm::nalgebra::SVector::from([zero; 6]),
            efforts: ::mstmm::nalgebra::SVector::from([zero; 6]),
            kinetic_energy: zero,
            potential_energy: zero,
            points: [::core::default::Default::default(); 5],
        }
    }
}
