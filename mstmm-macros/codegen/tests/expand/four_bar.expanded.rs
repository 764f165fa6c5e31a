/// A crank, a coupler and a rocker between two points of the ground.
///
/// # The chain
///
/// `ground -> pin crank_pin -> crank -> pin a -> coupler -> pin b -> rocker -> pin rocker_pin -> ground`
///
/// | element | kind | freedoms |
/// |---|---|---|
/// | `crank_pin` | pin | 1 |
/// | `crank` | body `Crank` |  |
/// | `a` | pin | 1 |
/// | `coupler` | body `Bar` |  |
/// | `b` | pin | 1 |
/// | `rocker` | body `Bar` |  |
/// | `rocker_pin` | pin | 1 |
///
/// 4 degrees of freedom; accelerations by `riccati`, 270 operations (159 mul, 103 add, 6 reciprocal, 2 square root, 4 sin/cos); with everything at every connection point 433 operations.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct FourBar<T> {
    parameters: FourBarParameters<T>,
    derived: [T; 0],
}
/// Numbers of [`FourBar`] that may change at run time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct FourBarParameters<T> {
    none: ::core::marker::PhantomData<T>,
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> FourBarParameters<T> {}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> FourBar<T> {
    /// The chain as described.
    #[inline]
    #[must_use]
    #[allow(clippy::all)]
    pub fn new() -> Self {
        let parameters = FourBarParameters {
            none: ::core::marker::PhantomData,
        };
        let (chain, _) = Self::derive(parameters);
        chain
    }
    /// The numbers that may change at run time.
    #[inline]
    pub fn parameters(&self) -> &FourBarParameters<T> {
        &self.parameters
    }
    /// The state that the description starts from, at time zero.
    #[must_use]
    #[allow(unused_doc_comments, clippy::all)]
    pub fn initial_state(&self) -> FourBarState<T> {
        let c = T::constant;
        FourBarState {
            q: ::mstmm::generated::vector([c(0.0), c(0.0), c(0.0), c(0.0)]),
            v: ::mstmm::generated::vector([c(0.0), c(0.0), c(0.0), c(0.0)]),
            t: T::constant(0.0),
        }
    }
    /// Quantities derived from parameters and constants: 0 mul, 0 add, 0 reciprocal.
    #[allow(unused_doc_comments, unused_variables, unused_mut, clippy::all)]
    fn derive(parameters: FourBarParameters<T>) -> (Self, [T; 0]) {
        let (derived, checks) = ([], []);
        (Self { parameters, derived }, checks)
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for FourBar<T> {
    fn default() -> Self {
        Self::new()
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> FourBar<T> {
    /// The accelerations `v̇` of all hinges, in the order of the rates: the fast path.
    ///
    /// 270 operations: 159 mul, 103 add, 6 reciprocal, 2 square root, 4 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `b` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 15 | 9 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 23 | 16 | 1 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 91 | 53 | 4 | 2 | 0 |
    /// | Acceleration of `crank_pin` | \[P, Eqs. (13), (36), (44)\] | 4 | 4 | 0 | 0 | 0 |
    /// | Acceleration of `a` | \[P, Eqs. (13), (36), (44)\] | 9 | 9 | 0 | 0 | 0 |
    /// | Acceleration of `b` | \[P, Eqs. (13), (36), (44)\] | 6 | 5 | 0 | 0 | 0 |
    /// | Results |  | 1 | 5 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// [`Error::Singular`](::mstmm::Error::Singular) if nothing with inertia lies beyond a
    /// hinge, [`Error::NotFinite`](::mstmm::Error::NotFinite) if a number of the state or the
    /// inputs is not finite. `accelerations` is not touched then.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn accelerations_into(
        &self,
        state: &FourBarState<T>,
        inputs: &FourBarInputs<T>,
        accelerations: &mut ::mstmm::nalgebra::SVector<T, 4>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let c = T::constant;
        let [[crank_pin_angle, a_angle, b_angle, rocker_pin_angle]] = state.q.data.0;
        let [[crank_pin_rate, a_rate, b_rate, ..]] = state.v.data.0;
        let crank_pin_input0 = inputs.crank_pin;
        /// Motion across `crank_pin`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 4 sin/cos.
        let (
            [sin_crank_pin_angle,
            sin_a_angle,
            sin_b_angle,
            sin_rocker_pin_angle,
            ],
            [cos_crank_pin_angle,
            cos_a_angle,
            cos_b_angle,
            cos_rocker_pin_angle,
            ],
        ) = T::sin_cos([crank_pin_angle, a_angle, b_angle, rocker_pin_angle]);
        /// Motion across `a`, [P, Eqs. (1), (13), (36)]: 4 mul, 1 add, 0 reciprocal.
        let a_omega_z = crank_pin_rate + a_rate;
        let t0 = crank_pin_rate * c(0.2);
        let t1 = crank_pin_rate * t0;
        let minus_a_drift_lin_x = cos_a_angle * t1;
        let a_drift_lin_y = sin_a_angle * t1;
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 4 mul, 1 add, 0 reciprocal.
        let b_omega_z = b_rate + a_omega_z;
        let t2 = a_omega_z * c(0.6);
        let t3 = a_omega_z * t2;
        let minus_b_drift_lin_x = cos_b_angle * t3;
        let b_drift_lin_y = sin_b_angle * t3;
        /// Riccati transfer over `b`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 0 add, 0 reciprocal.
        let t4 = c(0.6) * b_omega_z;
        let minus_b_e_force_x = b_omega_z * t4;
        /// Riccati transfer over `a`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 15 mul, 9 add, 1 reciprocal.
        let t5 = sin_b_angle * c(1.5);
        let t6 = sin_b_angle * t5;
        let minus_a_k_xx = t6 - c(4.0);
        let a_k_yy = c(2.5) + t6;
        let a_k_xy = cos_b_angle * t5;
        let a_b_x_z = c(0.6) * a_k_xy;
        let t7 = c(0.5) + t6;
        let t8 = c(0.6) * t7;
        let a_b_y_z = c(0.6) + t8;
        let t9 = t7 * c(0.36);
        let a_j_zz = c(0.24) + t9;
        let t10 = minus_b_drift_lin_x * c(2.0);
        let t11 = b_drift_lin_y * c(0.5);
        let t12 = minus_b_e_force_x + t10;
        let t13 = cos_b_angle * t12;
        let t14 = sin_b_angle * t11;
        let t15 = t13 + t14;
        let minus_a_e_force_x = t3 + t15;
        let t16 = sin_b_angle * t12;
        let t17 = cos_b_angle * t11;
        let minus_a_e_force_y = t16 - t17;
        let minus_a_e_moment_z = c(0.6) * minus_a_e_force_y;
        let t18 = T::recip(a_j_zz);
        let a_z0_force_x = a_b_x_z * t18;
        let a_z0_force_y = a_b_y_z * t18;
        /// Riccati transfer over `crank_pin`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 23 mul, 16 add, 1 reciprocal.
        let t19 = a_b_x_z * a_z0_force_x;
        let t20 = minus_a_k_xx + t19;
        let t21 = a_b_y_z * a_z0_force_y;
        let t22 = a_k_yy - t21;
        let t23 = a_b_y_z * a_z0_force_x;
        let t24 = a_k_xy - t23;
        let t25 = t20 + t22;
        let t26 = sin_a_angle * t25;
        let t27 = c(2.0) * t24;
        let t28 = cos_a_angle * t27;
        let t29 = t26 - t28;
        let t30 = cos_a_angle * t29;
        let minus_crank_pin_k_xy = t24 + t30;
        let minus_crank_pin_b_x_z = c(0.2) * minus_crank_pin_k_xy;
        let t31 = sin_a_angle * t29;
        let t32 = t22 - t31;
        let t33 = c(0.2) * t32;
        let crank_pin_b_y_z = c(0.1) + t33;
        let t34 = c(0.04000000000000001) * t32;
        let crank_pin_j_zz = c(0.020000000000000004) + t34;
        let t35 = minus_a_e_moment_z * t18;
        let t36 = a_b_x_z * t35;
        let t37 = minus_a_e_force_x - t36;
        let t38 = a_b_y_z * t35;
        let t39 = minus_a_e_force_y - t38;
        let t40 = minus_a_drift_lin_x * t20;
        let t41 = a_drift_lin_y * t24;
        let t42 = t40 + t41;
        let t43 = minus_a_drift_lin_x * t24;
        let t44 = a_drift_lin_y * t22;
        let t45 = t43 - t44;
        let t46 = t37 - t42;
        let t47 = t39 + t45;
        let t48 = sin_a_angle * t46;
        let t49 = cos_a_angle * t47;
        let minus_crank_pin_e_force_y = t48 + t49;
        let minus_crank_pin_e_moment_z = c(0.2) * minus_crank_pin_e_force_y;
        let t50 = T::recip(crank_pin_j_zz);
        let minus_crank_pin_z0_force_x = minus_crank_pin_b_x_z * t50;
        let crank_pin_z0_force_y = crank_pin_b_y_z * t50;
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 91 mul, 53 add, 4 reciprocal, 2 square root.
        let t51 = c(0.6) * sin_rocker_pin_angle;
        let t52 = sin_rocker_pin_angle * c(2.5);
        let t53 = sin_rocker_pin_angle * c(1.5);
        let t54 = sin_rocker_pin_angle - t53;
        let t55 = t51 * t52;
        let t56 = cos_b_angle * cos_rocker_pin_angle;
        let t57 = sin_b_angle * t54;
        let t58 = t56 - t57;
        let t59 = sin_b_angle * cos_rocker_pin_angle;
        let t60 = cos_b_angle * t54;
        let t61 = t59 + t60;
        let t62 = c(0.6) * t61;
        let t63 = t62 * t18;
        let t64 = t62 * a_z0_force_x;
        let t65 = t58 - t64;
        let t66 = t62 * a_z0_force_y;
        let t67 = t61 - t66;
        let t68 = t62 * t63;
        let t69 = t55 + t68;
        let t70 = sin_a_angle * t65;
        let t71 = cos_a_angle * t67;
        let t72 = t70 + t71;
        let t73 = c(0.2) * t72;
        let t74 = t73 * t50;
        let t75 = t73 * t74;
        let closure_d0 = t69 + t75;
        let t76 = c(0.6) * cos_rocker_pin_angle;
        let t77 = cos_rocker_pin_angle * c(2.5);
        let t78 = cos_rocker_pin_angle * c(1.5);
        let t79 = cos_rocker_pin_angle - t78;
        let t80 = t76 * t52;
        let t81 = t76 * t77;
        let t82 = cos_b_angle * sin_rocker_pin_angle;
        let t83 = sin_b_angle * t79;
        let t84 = t82 + t83;
        let t85 = sin_b_angle * sin_rocker_pin_angle;
        let t86 = cos_b_angle * t79;
        let t87 = t85 - t86;
        let t88 = c(0.6) * t87;
        let t89 = t88 * t18;
        let t90 = t88 * a_z0_force_x;
        let t91 = t84 - t90;
        let t92 = t88 * a_z0_force_y;
        let t93 = t87 - t92;
        let t94 = t88 * t63;
        let t95 = t80 - t94;
        let t96 = t88 * t89;
        let t97 = t81 + t96;
        let t98 = sin_a_angle * t91;
        let t99 = cos_a_angle * t93;
        let t100 = t98 + t99;
        let t101 = c(0.2) * t100;
        let t102 = t101 * t50;
        let t103 = t101 * t74;
        let t104 = t95 - t103;
        let t105 = t101 * t102;
        let t106 = t97 + t105;
        let t107 = ::mstmm::generated::recip_above(closure_d0, closure_d0);
        let t108 = t104 * t107;
        let t109 = t104 * t108;
        let closure_d1 = t106 - t109;
        let t110 = cos_rocker_pin_angle * minus_b_e_force_x;
        let t111 = sin_rocker_pin_angle * minus_b_e_force_x;
        let t112 = t111 - c(9.8);
        let t113 = minus_b_drift_lin_x * cos_rocker_pin_angle;
        let t114 = b_drift_lin_y * t54;
        let t115 = t113 - t114;
        let t116 = minus_b_drift_lin_x * sin_rocker_pin_angle;
        let t117 = b_drift_lin_y * t79;
        let t118 = t116 + t117;
        let t119 = t62 * t35;
        let t120 = t115 - t119;
        let t121 = t88 * t35;
        let t122 = t118 - t121;
        let t123 = minus_a_drift_lin_x * t65;
        let t124 = a_drift_lin_y * t67;
        let t125 = t123 - t124;
        let t126 = t120 + t125;
        let t127 = minus_a_drift_lin_x * t91;
        let t128 = a_drift_lin_y * t93;
        let t129 = t127 - t128;
        let t130 = t122 + t129;
        let t131 = cos_a_angle * t65;
        let t132 = sin_a_angle * t67;
        let t133 = t131 - t132;
        let t134 = cos_a_angle * t91;
        let t135 = sin_a_angle * t93;
        let t136 = t134 - t135;
        let t137 = crank_pin_input0 + minus_crank_pin_e_moment_z;
        let t138 = t50 * t137;
        let t139 = t73 * minus_crank_pin_z0_force_x;
        let t140 = t133 + t139;
        let t141 = t73 * crank_pin_z0_force_y;
        let t142 = t72 - t141;
        let t143 = t73 * t138;
        let t144 = t126 - t143;
        let t145 = t101 * minus_crank_pin_z0_force_x;
        let t146 = t136 + t145;
        let t147 = t101 * crank_pin_z0_force_y;
        let t148 = t100 - t147;
        let t149 = t101 * t138;
        let t150 = t130 - t149;
        let crank_pin_a_lin_x = sin_crank_pin_angle * c(9.8);
        let crank_pin_a_lin_y = cos_crank_pin_angle * c(9.8);
        let t151 = t140 * crank_pin_a_lin_x;
        let t152 = t142 * crank_pin_a_lin_y;
        let t153 = t151 + t152;
        let t154 = t144 - t153;
        let t155 = t146 * crank_pin_a_lin_x;
        let t156 = t148 * crank_pin_a_lin_y;
        let t157 = t155 + t156;
        let t158 = t150 - t157;
        let t159 = t110 + t154;
        let t160 = t112 + t158;
        let t161 = ::mstmm::generated::recip_above(closure_d1, t106);
        let t162 = t159 * t108;
        let t163 = t160 + t162;
        let t164 = t159 * t107;
        let t165 = t161 * t163;
        let t166 = t108 * t165;
        let t167 = t164 + t166;
        let t168 = closure_d0 * t107;
        let t169 = c(1.0) - t168;
        let t170 = t169 * t169;
        let t171 = ::mstmm::generated::recip_above(t170, c(1.0));
        let t172 = T::sqrt(t171);
        let t173 = t169 * t172;
        let t174 = t167 * t173;
        let t175 = t173 * t174;
        let t176 = t167 - t175;
        let t177 = closure_d1 * t161;
        let t178 = c(1.0) - t177;
        let t179 = t108 * t178;
        let t180 = t173 * t179;
        let t181 = t173 * t180;
        let t182 = t179 - t181;
        let t183 = t182 * t182;
        let t184 = t178 * t178;
        let t185 = t183 + t184;
        let t186 = ::mstmm::generated::recip_above(t185, c(1.0));
        let t187 = T::sqrt(t186);
        let t188 = t182 * t187;
        let t189 = t178 * t187;
        let t190 = t176 * t188;
        let t191 = t165 * t189;
        let t192 = t190 + t191;
        let t193 = t188 * t192;
        let minus_closure_reaction0 = t176 - t193;
        let t194 = t189 * t192;
        let closure_reaction1 = t165 - t194;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 4 mul, 4 add, 0 reciprocal.
        let t195 = t74 * minus_closure_reaction0;
        let t196 = t102 * closure_reaction1;
        let t197 = t195 + t196;
        let t198 = t138 + t197;
        let t199 = minus_crank_pin_z0_force_x * crank_pin_a_lin_x;
        let t200 = crank_pin_z0_force_y * crank_pin_a_lin_y;
        let t201 = t199 - t200;
        let crank_pin_a_ang_z = t198 + t201;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 9 mul, 9 add, 0 reciprocal.
        let t202 = c(0.2) * crank_pin_a_ang_z;
        let t203 = crank_pin_a_lin_y + t202;
        let t204 = cos_a_angle * crank_pin_a_lin_x;
        let t205 = sin_a_angle * t203;
        let t206 = t204 + t205;
        let minus_a_a_lin_x = minus_a_drift_lin_x - t206;
        let t207 = sin_a_angle * crank_pin_a_lin_x;
        let t208 = cos_a_angle * t203;
        let t209 = t207 - t208;
        let a_a_lin_y = a_drift_lin_y - t209;
        let t210 = t63 * minus_closure_reaction0;
        let t211 = t89 * closure_reaction1;
        let t212 = t210 + t211;
        let t213 = t35 + t212;
        let t214 = a_z0_force_x * minus_a_a_lin_x;
        let t215 = a_z0_force_y * a_a_lin_y;
        let t216 = t214 - t215;
        let a_a_ang_z = t213 + t216;
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 6 mul, 5 add, 0 reciprocal.
        let t217 = c(0.6) * a_a_ang_z;
        let t218 = a_a_lin_y + t217;
        let t219 = sin_b_angle * minus_a_a_lin_x;
        let t220 = cos_b_angle * t218;
        let t221 = t219 + t220;
        let b_a_lin_y = b_drift_lin_y + t221;
        let t222 = t52 * minus_closure_reaction0;
        let t223 = t77 * closure_reaction1;
        let t224 = t222 - t223;
        let t225 = c(2.5) * b_a_lin_y;
        let b_a_ang_z = t224 - t225;
        /// Results: 1 mul, 5 add, 0 reciprocal.
        let t226 = crank_pin_a_ang_z - a_a_ang_z;
        let t227 = a_a_ang_z - b_a_ang_z;
        let t228 = t20 - t22;
        let t229 = c(4.0) - t228;
        let t230 = t229 * c(0.04000000000000001);
        let t231 = t230 + c(0.030000000000000006);
        ::mstmm::generated::finite::<
            T,
        >(&[state.q.as_slice(), state.v.as_slice(), &[inputs.crank_pin]])?;
        ::mstmm::generated::regular::<
            T,
            _,
            _,
        >(
            &["a", "crank_pin"],
            [a_j_zz, crank_pin_j_zz],
            [c(2.04), t231],
            [crank_pin_a_ang_z, -t226, -t227, -b_a_ang_z],
        )?;
        accelerations.data.0 = [[crank_pin_a_ang_z, -t226, -t227, -b_a_ang_z]];
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
        state: &FourBarState<T>,
        inputs: &FourBarInputs<T>,
    ) -> ::core::result::Result<::mstmm::nalgebra::SVector<T, 4>, ::mstmm::Error> {
        let mut accelerations = ::mstmm::generated::vector([T::constant(0.0); 4]);
        self.accelerations_into(state, inputs, &mut accelerations)?;
        ::core::result::Result::Ok(accelerations)
    }
    /// Everything: accelerations, efforts, energies and, at every connection point, pose,
    /// velocity and the state vector `z`, written into `at`.
    ///
    /// 433 operations: 258 mul, 167 add, 6 reciprocal, 2 square root, 4 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `b` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 15 | 9 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 23 | 16 | 1 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 91 | 53 | 4 | 2 | 0 |
    /// | Acceleration of `crank_pin` | \[P, Eqs. (13), (36), (44)\] | 4 | 4 | 0 | 0 | 0 |
    /// | Acceleration of `a` | \[P, Eqs. (13), (36), (44)\] | 9 | 9 | 0 | 0 | 0 |
    /// | Acceleration of `b` | \[P, Eqs. (13), (36), (44)\] | 8 | 7 | 0 | 0 | 0 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 10 | 2 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 10 | 2 | 0 | 0 | 0 |
    /// | Point of `a` | \[P, Eqs. (12), (13), (36)\] | 2 | 2 | 0 | 0 | 0 |
    /// | Point of `b` | \[P, Eqs. (12), (13), (36)\] | 2 | 4 | 0 | 0 | 0 |
    /// | Load of the body at `crank_pin` | \[P, Eqs. (18), (19)\] | 7 | 4 | 0 | 0 | 0 |
    /// | Load of the body at `a` | \[P, Eqs. (18), (19)\] | 6 | 4 | 0 | 0 | 0 |
    /// | Load of the body at `b` | \[P, Eqs. (18), (19)\] | 7 | 4 | 0 | 0 | 0 |
    /// | Load on `rocker_pin` | \[P, Eqs. (18), (19)\] | 8 | 4 | 0 | 0 | 0 |
    /// | Load on `b` | \[P, Eqs. (18), (19)\] | 0 | 2 | 0 | 0 | 0 |
    /// | Load on `a` | \[P, Eqs. (18), (19)\] | 0 | 2 | 0 | 0 | 0 |
    /// | Load on `crank_pin` | \[P, Eqs. (18), (19)\] | 0 | 2 | 0 | 0 | 0 |
    /// | Results |  | 46 | 35 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// As [`accelerations_into`](Self::accelerations_into); `at` is not touched then.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn solve_into(
        &self,
        state: &FourBarState<T>,
        inputs: &FourBarInputs<T>,
        at: &mut FourBarWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let c = T::constant;
        let [[crank_pin_angle, a_angle, b_angle, rocker_pin_angle]] = state.q.data.0;
        let [[crank_pin_rate, a_rate, b_rate, ..]] = state.v.data.0;
        let crank_pin_input0 = inputs.crank_pin;
        /// Motion across `crank_pin`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 4 sin/cos.
        let (
            [sin_crank_pin_angle,
            sin_a_angle,
            sin_b_angle,
            sin_rocker_pin_angle,
            ],
            [cos_crank_pin_angle,
            cos_a_angle,
            cos_b_angle,
            cos_rocker_pin_angle,
            ],
        ) = T::sin_cos([crank_pin_angle, a_angle, b_angle, rocker_pin_angle]);
        /// Motion across `a`, [P, Eqs. (1), (13), (36)]: 4 mul, 1 add, 0 reciprocal.
        let a_omega_z = crank_pin_rate + a_rate;
        let t0 = crank_pin_rate * c(0.2);
        let t1 = crank_pin_rate * t0;
        let minus_a_drift_lin_x = cos_a_angle * t1;
        let a_drift_lin_y = sin_a_angle * t1;
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 4 mul, 1 add, 0 reciprocal.
        let b_omega_z = b_rate + a_omega_z;
        let t2 = a_omega_z * c(0.6);
        let t3 = a_omega_z * t2;
        let minus_b_drift_lin_x = cos_b_angle * t3;
        let b_drift_lin_y = sin_b_angle * t3;
        /// Riccati transfer over `b`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 0 add, 0 reciprocal.
        let t4 = c(0.6) * b_omega_z;
        let minus_b_e_force_x = b_omega_z * t4;
        /// Riccati transfer over `a`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 15 mul, 9 add, 1 reciprocal.
        let t5 = sin_b_angle * c(1.5);
        let t6 = sin_b_angle * t5;
        let minus_a_k_xx = t6 - c(4.0);
        let a_k_yy = c(2.5) + t6;
        let a_k_xy = cos_b_angle * t5;
        let a_b_x_z = c(0.6) * a_k_xy;
        let t7 = c(0.5) + t6;
        let t8 = c(0.6) * t7;
        let a_b_y_z = c(0.6) + t8;
        let t9 = t7 * c(0.36);
        let a_j_zz = c(0.24) + t9;
        let t10 = minus_b_drift_lin_x * c(2.0);
        let t11 = b_drift_lin_y * c(0.5);
        let t12 = minus_b_e_force_x + t10;
        let t13 = cos_b_angle * t12;
        let t14 = sin_b_angle * t11;
        let t15 = t13 + t14;
        let minus_a_e_force_x = t3 + t15;
        let t16 = sin_b_angle * t12;
        let t17 = cos_b_angle * t11;
        let minus_a_e_force_y = t16 - t17;
        let minus_a_e_moment_z = c(0.6) * minus_a_e_force_y;
        let t18 = T::recip(a_j_zz);
        let a_z0_force_x = a_b_x_z * t18;
        let a_z0_force_y = a_b_y_z * t18;
        /// Riccati transfer over `crank_pin`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 23 mul, 16 add, 1 reciprocal.
        let t19 = a_b_x_z * a_z0_force_x;
        let t20 = minus_a_k_xx + t19;
        let t21 = a_b_y_z * a_z0_force_y;
        let t22 = a_k_yy - t21;
        let t23 = a_b_y_z * a_z0_force_x;
        let t24 = a_k_xy - t23;
        let t25 = t20 + t22;
        let t26 = sin_a_angle * t25;
        let t27 = c(2.0) * t24;
        let t28 = cos_a_angle * t27;
        let t29 = t26 - t28;
        let t30 = cos_a_angle * t29;
        let minus_crank_pin_k_xy = t24 + t30;
        let minus_crank_pin_b_x_z = c(0.2) * minus_crank_pin_k_xy;
        let t31 = sin_a_angle * t29;
        let t32 = t22 - t31;
        let t33 = c(0.2) * t32;
        let crank_pin_b_y_z = c(0.1) + t33;
        let t34 = c(0.04000000000000001) * t32;
        let crank_pin_j_zz = c(0.020000000000000004) + t34;
        let t35 = minus_a_e_moment_z * t18;
        let t36 = a_b_x_z * t35;
        let t37 = minus_a_e_force_x - t36;
        let t38 = a_b_y_z * t35;
        let t39 = minus_a_e_force_y - t38;
        let t40 = minus_a_drift_lin_x * t20;
        let t41 = a_drift_lin_y * t24;
        let t42 = t40 + t41;
        let t43 = minus_a_drift_lin_x * t24;
        let t44 = a_drift_lin_y * t22;
        let t45 = t43 - t44;
        let t46 = t37 - t42;
        let t47 = t39 + t45;
        let t48 = sin_a_angle * t46;
        let t49 = cos_a_angle * t47;
        let minus_crank_pin_e_force_y = t48 + t49;
        let minus_crank_pin_e_moment_z = c(0.2) * minus_crank_pin_e_force_y;
        let t50 = T::recip(crank_pin_j_zz);
        let minus_crank_pin_z0_force_x = minus_crank_pin_b_x_z * t50;
        let crank_pin_z0_force_y = crank_pin_b_y_z * t50;
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 91 mul, 53 add, 4 reciprocal, 2 square root.
        let t51 = c(0.6) * sin_rocker_pin_angle;
        let t52 = sin_rocker_pin_angle * c(2.5);
        let t53 = sin_rocker_pin_angle * c(1.5);
        let t54 = sin_rocker_pin_angle - t53;
        let t55 = t51 * t52;
        let t56 = cos_b_angle * cos_rocker_pin_angle;
        let t57 = sin_b_angle * t54;
        let t58 = t56 - t57;
        let t59 = sin_b_angle * cos_rocker_pin_angle;
        let t60 = cos_b_angle * t54;
        let t61 = t59 + t60;
        let t62 = c(0.6) * t61;
        let t63 = t62 * t18;
        let t64 = t62 * a_z0_force_x;
        let t65 = t58 - t64;
        let t66 = t62 * a_z0_force_y;
        let t67 = t61 - t66;
        let t68 = t62 * t63;
        let t69 = t55 + t68;
        let t70 = sin_a_angle * t65;
        let t71 = cos_a_angle * t67;
        let t72 = t70 + t71;
        let t73 = c(0.2) * t72;
        let t74 = t73 * t50;
        let t75 = t73 * t74;
        let closure_d0 = t69 + t75;
        let t76 = c(0.6) * cos_rocker_pin_angle;
        let t77 = cos_rocker_pin_angle * c(2.5);
        let t78 = cos_rocker_pin_angle * c(1.5);
        let t79 = cos_rocker_pin_angle - t78;
        let t80 = t76 * t52;
        let t81 = t76 * t77;
        let t82 = cos_b_angle * sin_rocker_pin_angle;
        let t83 = sin_b_angle * t79;
        let t84 = t82 + t83;
        let t85 = sin_b_angle * sin_rocker_pin_angle;
        let t86 = cos_b_angle * t79;
        let t87 = t85 - t86;
        let t88 = c(0.6) * t87;
        let t89 = t88 * t18;
        let t90 = t88 * a_z0_force_x;
        let t91 = t84 - t90;
        let t92 = t88 * a_z0_force_y;
        let t93 = t87 - t92;
        let t94 = t88 * t63;
        let t95 = t80 - t94;
        let t96 = t88 * t89;
        let t97 = t81 + t96;
        let t98 = sin_a_angle * t91;
        let t99 = cos_a_angle * t93;
        let t100 = t98 + t99;
        let t101 = c(0.2) * t100;
        let t102 = t101 * t50;
        let t103 = t101 * t74;
        let t104 = t95 - t103;
        let t105 = t101 * t102;
        let t106 = t97 + t105;
        let t107 = ::mstmm::generated::recip_above(closure_d0, closure_d0);
        let t108 = t104 * t107;
        let t109 = t104 * t108;
        let closure_d1 = t106 - t109;
        let t110 = cos_rocker_pin_angle * minus_b_e_force_x;
        let t111 = sin_rocker_pin_angle * minus_b_e_force_x;
        let t112 = t111 - c(9.8);
        let t113 = minus_b_drift_lin_x * cos_rocker_pin_angle;
        let t114 = b_drift_lin_y * t54;
        let t115 = t113 - t114;
        let t116 = minus_b_drift_lin_x * sin_rocker_pin_angle;
        let t117 = b_drift_lin_y * t79;
        let t118 = t116 + t117;
        let t119 = t62 * t35;
        let t120 = t115 - t119;
        let t121 = t88 * t35;
        let t122 = t118 - t121;
        let t123 = minus_a_drift_lin_x * t65;
        let t124 = a_drift_lin_y * t67;
        let t125 = t123 - t124;
        let t126 = t120 + t125;
        let t127 = minus_a_drift_lin_x * t91;
        let t128 = a_drift_lin_y * t93;
        let t129 = t127 - t128;
        let t130 = t122 + t129;
        let t131 = cos_a_angle * t65;
        let t132 = sin_a_angle * t67;
        let t133 = t131 - t132;
        let t134 = cos_a_angle * t91;
        let t135 = sin_a_angle * t93;
        let t136 = t134 - t135;
        let t137 = crank_pin_input0 + minus_crank_pin_e_moment_z;
        let t138 = t50 * t137;
        let t139 = t73 * minus_crank_pin_z0_force_x;
        let t140 = t133 + t139;
        let t141 = t73 * crank_pin_z0_force_y;
        let t142 = t72 - t141;
        let t143 = t73 * t138;
        let t144 = t126 - t143;
        let t145 = t101 * minus_crank_pin_z0_force_x;
        let t146 = t136 + t145;
        let t147 = t101 * crank_pin_z0_force_y;
        let t148 = t100 - t147;
        let t149 = t101 * t138;
        let t150 = t130 - t149;
        let crank_pin_a_lin_x = sin_crank_pin_angle * c(9.8);
        let crank_pin_a_lin_y = cos_crank_pin_angle * c(9.8);
        let t151 = t140 * crank_pin_a_lin_x;
        let t152 = t142 * crank_pin_a_lin_y;
        let t153 = t151 + t152;
        let t154 = t144 - t153;
        let t155 = t146 * crank_pin_a_lin_x;
        let t156 = t148 * crank_pin_a_lin_y;
        let t157 = t155 + t156;
        let t158 = t150 - t157;
        let t159 = t110 + t154;
        let t160 = t112 + t158;
        let t161 = ::mstmm::generated::recip_above(closure_d1, t106);
        let t162 = t159 * t108;
        let t163 = t160 + t162;
        let t164 = t159 * t107;
        let t165 = t161 * t163;
        let t166 = t108 * t165;
        let t167 = t164 + t166;
        let t168 = closure_d0 * t107;
        let t169 = c(1.0) - t168;
        let t170 = t169 * t169;
        let t171 = ::mstmm::generated::recip_above(t170, c(1.0));
        let t172 = T::sqrt(t171);
        let t173 = t169 * t172;
        let t174 = t167 * t173;
        let t175 = t173 * t174;
        let t176 = t167 - t175;
        let t177 = closure_d1 * t161;
        let t178 = c(1.0) - t177;
        let t179 = t108 * t178;
        let t180 = t173 * t179;
        let t181 = t173 * t180;
        let t182 = t179 - t181;
        let t183 = t182 * t182;
        let t184 = t178 * t178;
        let t185 = t183 + t184;
        let t186 = ::mstmm::generated::recip_above(t185, c(1.0));
        let t187 = T::sqrt(t186);
        let t188 = t182 * t187;
        let t189 = t178 * t187;
        let t190 = t176 * t188;
        let t191 = t165 * t189;
        let t192 = t190 + t191;
        let t193 = t188 * t192;
        let minus_closure_reaction0 = t176 - t193;
        let t194 = t189 * t192;
        let closure_reaction1 = t165 - t194;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 4 mul, 4 add, 0 reciprocal.
        let t195 = t74 * minus_closure_reaction0;
        let t196 = t102 * closure_reaction1;
        let t197 = t195 + t196;
        let t198 = t138 + t197;
        let t199 = minus_crank_pin_z0_force_x * crank_pin_a_lin_x;
        let t200 = crank_pin_z0_force_y * crank_pin_a_lin_y;
        let t201 = t199 - t200;
        let crank_pin_a_ang_z = t198 + t201;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 9 mul, 9 add, 0 reciprocal.
        let t202 = c(0.2) * crank_pin_a_ang_z;
        let t203 = crank_pin_a_lin_y + t202;
        let t204 = cos_a_angle * crank_pin_a_lin_x;
        let t205 = sin_a_angle * t203;
        let t206 = t204 + t205;
        let minus_a_a_lin_x = minus_a_drift_lin_x - t206;
        let t207 = sin_a_angle * crank_pin_a_lin_x;
        let t208 = cos_a_angle * t203;
        let t209 = t207 - t208;
        let a_a_lin_y = a_drift_lin_y - t209;
        let t210 = t63 * minus_closure_reaction0;
        let t211 = t89 * closure_reaction1;
        let t212 = t210 + t211;
        let t213 = t35 + t212;
        let t214 = a_z0_force_x * minus_a_a_lin_x;
        let t215 = a_z0_force_y * a_a_lin_y;
        let t216 = t214 - t215;
        let a_a_ang_z = t213 + t216;
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 8 mul, 7 add, 0 reciprocal.
        let t217 = c(0.6) * a_a_ang_z;
        let t218 = a_a_lin_y + t217;
        let t219 = cos_b_angle * minus_a_a_lin_x;
        let t220 = sin_b_angle * t218;
        let t221 = t219 - t220;
        let minus_b_a_lin_x = minus_b_drift_lin_x + t221;
        let t222 = sin_b_angle * minus_a_a_lin_x;
        let t223 = cos_b_angle * t218;
        let t224 = t222 + t223;
        let b_a_lin_y = b_drift_lin_y + t224;
        let t225 = t52 * minus_closure_reaction0;
        let t226 = t77 * closure_reaction1;
        let t227 = t225 - t226;
        let t228 = c(2.5) * b_a_lin_y;
        let b_a_ang_z = t227 - t228;
        /// Motion across `a`, [P, Eqs. (1), (13), (36)]: 10 mul, 2 add, 0 reciprocal.
        let t229 = cos_crank_pin_angle * cos_a_angle;
        let t230 = sin_crank_pin_angle * sin_a_angle;
        let a_axes_x_x = t229 - t230;
        let t231 = cos_crank_pin_angle * sin_a_angle;
        let t232 = sin_crank_pin_angle * cos_a_angle;
        let minus_a_axes_x_y = t231 + t232;
        let t233 = cos_crank_pin_angle * c(0.2);
        let t234 = crank_pin_rate * t233;
        let minus_a_drift_lin_x_2 = crank_pin_rate * t234;
        let t235 = sin_crank_pin_angle * c(0.2);
        let t236 = crank_pin_rate * t235;
        let minus_a_drift_lin_y = crank_pin_rate * t236;
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 10 mul, 2 add, 0 reciprocal.
        let t237 = cos_b_angle * a_axes_x_x;
        let t238 = sin_b_angle * minus_a_axes_x_y;
        let b_axes_x_x = t237 - t238;
        let t239 = sin_b_angle * a_axes_x_x;
        let t240 = cos_b_angle * minus_a_axes_x_y;
        let minus_b_axes_x_y = t239 + t240;
        let t241 = c(0.6) * a_axes_x_x;
        let t242 = a_omega_z * t241;
        let minus_b_drift_lin_x_2 = a_omega_z * t242;
        let t243 = c(0.6) * minus_a_axes_x_y;
        let t244 = a_omega_z * t243;
        let minus_b_drift_lin_y = a_omega_z * t244;
        /// Point of `a`, [P, Eqs. (12), (13), (36)]: 2 mul, 2 add, 0 reciprocal.
        let t245 = crank_pin_a_ang_z * t235;
        let minus_a_acc_lin_x = minus_a_drift_lin_x_2 + t245;
        let t246 = crank_pin_a_ang_z * t233;
        let minus_a_acc_lin_y = minus_a_drift_lin_y - t246;
        /// Point of `b`, [P, Eqs. (12), (13), (36)]: 2 mul, 4 add, 0 reciprocal.
        let t247 = a_a_ang_z * t243;
        let t248 = minus_a_acc_lin_x + t247;
        let minus_b_acc_lin_x = minus_b_drift_lin_x_2 + t248;
        let t249 = a_a_ang_z * t241;
        let t250 = minus_a_acc_lin_y - t249;
        let minus_b_acc_lin_y = minus_b_drift_lin_y + t250;
        /// Load of the body at `crank_pin`, [P, Eqs. (18), (19)]: 7 mul, 4 add, 0 reciprocal.
        let t251 = crank_pin_rate * c(0.1);
        let t252 = crank_pin_rate * t251;
        let t253 = c(0.1) * crank_pin_a_ang_z;
        let t254 = crank_pin_a_lin_y + t253;
        let t255 = t252 - crank_pin_a_lin_x;
        let t256 = cos_crank_pin_angle * t255;
        let t257 = sin_crank_pin_angle * t254;
        let minus_crank_pin_own_force_x = t256 + t257;
        let t258 = sin_crank_pin_angle * t255;
        let t259 = cos_crank_pin_angle * t254;
        let minus_crank_pin_own_force_y = t258 - t259;
        /// Load of the body at `a`, [P, Eqs. (18), (19)]: 6 mul, 4 add, 0 reciprocal.
        let t260 = c(2.0) * minus_a_a_lin_x;
        let t261 = c(2.0) * a_a_lin_y;
        let t262 = t217 + t261;
        let t263 = t3 + t260;
        let t264 = a_axes_x_x * t263;
        let t265 = minus_a_axes_x_y * t262;
        let minus_a_own_force_x = t264 + t265;
        let t266 = minus_a_axes_x_y * t263;
        let t267 = a_axes_x_x * t262;
        let minus_a_own_force_y = t266 - t267;
        /// Load of the body at `b`, [P, Eqs. (18), (19)]: 7 mul, 4 add, 0 reciprocal.
        let t268 = c(0.6) * b_a_ang_z;
        let t269 = c(2.0) * minus_b_a_lin_x;
        let t270 = c(2.0) * b_a_lin_y;
        let t271 = t268 + t270;
        let t272 = minus_b_e_force_x + t269;
        let t273 = b_axes_x_x * t272;
        let t274 = minus_b_axes_x_y * t271;
        let minus_b_own_force_x = t273 + t274;
        let t275 = minus_b_axes_x_y * t272;
        let t276 = b_axes_x_x * t271;
        let minus_b_own_force_y = t275 - t276;
        /// Load on `rocker_pin`, [P, Eqs. (18), (19)]: 8 mul, 4 add, 0 reciprocal.
        let t277 = cos_rocker_pin_angle * minus_closure_reaction0;
        let t278 = sin_rocker_pin_angle * closure_reaction1;
        let t279 = t277 + t278;
        let t280 = sin_rocker_pin_angle * minus_closure_reaction0;
        let t281 = cos_rocker_pin_angle * closure_reaction1;
        let t282 = t280 - t281;
        let t283 = t279 * b_axes_x_x;
        let t284 = t282 * minus_b_axes_x_y;
        let minus_rocker_pin_load_force_x = t283 - t284;
        let t285 = t279 * minus_b_axes_x_y;
        let t286 = t282 * b_axes_x_x;
        let minus_rocker_pin_load_force_y = t285 + t286;
        /// Load on `b`, [P, Eqs. (18), (19)]: 0 mul, 2 add, 0 reciprocal.
        let minus_b_load_force_x = minus_b_own_force_x + minus_rocker_pin_load_force_x;
        let minus_b_load_force_y = minus_b_own_force_y + minus_rocker_pin_load_force_y;
        /// Load on `a`, [P, Eqs. (18), (19)]: 0 mul, 2 add, 0 reciprocal.
        let minus_a_load_force_x = minus_a_own_force_x + minus_b_load_force_x;
        let minus_a_load_force_y = minus_a_own_force_y + minus_b_load_force_y;
        /// Load on `crank_pin`, [P, Eqs. (18), (19)]: 0 mul, 2 add, 0 reciprocal.
        let minus_crank_pin_load_force_x = minus_crank_pin_own_force_x
            + minus_a_load_force_x;
        let minus_crank_pin_load_force_y = minus_crank_pin_own_force_y
            + minus_a_load_force_y;
        /// Results: 46 mul, 35 add, 0 reciprocal.
        let t287 = crank_pin_a_ang_z - a_a_ang_z;
        let t288 = a_a_ang_z - b_a_ang_z;
        let t289 = t20 - t22;
        let t290 = c(4.0) - t289;
        let t291 = t290 * c(0.04000000000000001);
        let t292 = t291 + c(0.030000000000000006);
        let t293 = cos_crank_pin_angle * c(0.1);
        let t294 = sin_crank_pin_angle * c(0.1);
        let t295 = t236 + t244;
        let t296 = t234 + t242;
        let t297 = crank_pin_rate * t294;
        let t298 = crank_pin_rate * t293;
        let t299 = crank_pin_rate * c(0.01);
        let t300 = crank_pin_rate * t299;
        let t301 = t297 * t297;
        let t302 = t298 * t298;
        let t303 = t301 + t302;
        let t304 = t300 + t303;
        let t305 = a_axes_x_x * c(0.3);
        let t306 = minus_a_axes_x_y * c(0.3);
        let t307 = a_omega_z * t306;
        let t308 = a_omega_z * t305;
        let t309 = t236 + t307;
        let t310 = t234 + t308;
        let t311 = a_omega_z * c(0.06);
        let t312 = a_omega_z * t311;
        let t313 = t309 * t309;
        let t314 = t310 * t310;
        let t315 = t313 + t314;
        let t316 = c(2.0) * t315;
        let t317 = t312 + t316;
        let t318 = b_axes_x_x * c(0.3);
        let t319 = minus_b_axes_x_y * c(0.3);
        let t320 = b_omega_z * t319;
        let t321 = b_omega_z * t318;
        let t322 = t295 + t320;
        let t323 = t296 + t321;
        let t324 = b_omega_z * c(0.06);
        let t325 = b_omega_z * t324;
        let t326 = t322 * t322;
        let t327 = t323 * t323;
        let t328 = t326 + t327;
        let t329 = c(2.0) * t328;
        let t330 = t325 + t329;
        let t331 = c(0.5) * t330;
        let t332 = t304 + t317;
        let t333 = c(0.5) * t332;
        let t334 = t331 + t333;
        let t335 = t235 + t243;
        let t336 = sin_crank_pin_angle * c(0.9800000000000001);
        let t337 = t235 + t306;
        let t338 = t337 * c(19.6);
        let t339 = t336 + t338;
        let t340 = t335 + t319;
        let t341 = c(19.6) * t340;
        let t342 = t339 + t341;
        let t343 = cos_rocker_pin_angle * t173;
        let t344 = sin_rocker_pin_angle * t173;
        let t345 = cos_rocker_pin_angle * t188;
        let t346 = sin_rocker_pin_angle * t189;
        let t347 = t345 + t346;
        let t348 = sin_rocker_pin_angle * t188;
        let t349 = cos_rocker_pin_angle * t189;
        let t350 = t348 - t349;
        let t351 = t233 + t241;
        let t352 = c(0.6) * b_axes_x_x;
        let t353 = t352 + t351;
        let t354 = c(0.6) * minus_b_axes_x_y;
        let t355 = t354 + t335;
        let t356 = b_omega_z * t354;
        let t357 = t295 + t356;
        let t358 = b_omega_z * t352;
        let t359 = t296 + t358;
        let t360 = b_omega_z * t358;
        let t361 = b_a_ang_z * t354;
        let t362 = minus_b_acc_lin_x + t361;
        let t363 = t360 + t362;
        let t364 = b_omega_z * t356;
        let t365 = b_a_ang_z * t352;
        let t366 = minus_b_acc_lin_y - t365;
        let t367 = t364 + t366;
        ::mstmm::generated::finite::<
            T,
        >(&[state.q.as_slice(), state.v.as_slice(), &[inputs.crank_pin]])?;
        ::mstmm::generated::regular::<
            T,
            _,
            _,
        >(
            &["a", "crank_pin"],
            [a_j_zz, crank_pin_j_zz],
            [c(2.04), t292],
            [crank_pin_a_ang_z, -t287, -t288, -b_a_ang_z],
        )?;
        at.accelerations.data.0 = [[crank_pin_a_ang_z, -t287, -t288, -b_a_ang_z]];
        at.rate_accelerations.data.0 = [[crank_pin_a_ang_z, -t287, -t288, -b_a_ang_z]];
        at.efforts.data.0 = [[crank_pin_input0, c(0.0), c(0.0), c(0.0)]];
        at.closure = ::mstmm::generated::closure([
            [t343, t344, c(0.0), c(0.0), c(0.0), c(0.0)],
            [-t347, -t350, c(0.0), c(0.0), c(0.0), c(0.0)],
        ]);
        at.kinetic_energy = t334;
        at.potential_energy = t342;
        at.points = [
            ::mstmm::PlanePoint::new(
                [c(0.0), c(0.0)],
                [c(1.0), c(0.0)],
                [c(0.0), c(0.0)],
                c(0.0),
                ::mstmm::PlaneStateVector::new(
                    [c(0.0), c(0.0)],
                    c(0.0),
                    -crank_pin_input0,
                    [-minus_crank_pin_load_force_x, -minus_crank_pin_load_force_y],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [c(0.0), c(0.0)],
                [cos_crank_pin_angle, sin_crank_pin_angle],
                [c(0.0), c(0.0)],
                crank_pin_rate,
                ::mstmm::PlaneStateVector::new(
                    [c(0.0), c(0.0)],
                    crank_pin_a_ang_z,
                    -crank_pin_input0,
                    [-minus_crank_pin_load_force_x, -minus_crank_pin_load_force_y],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t233, t235],
                [cos_crank_pin_angle, sin_crank_pin_angle],
                [-t236, t234],
                crank_pin_rate,
                ::mstmm::PlaneStateVector::new(
                    [-minus_a_acc_lin_x, -minus_a_acc_lin_y],
                    crank_pin_a_ang_z,
                    c(0.0),
                    [-minus_a_load_force_x, -minus_a_load_force_y],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t233, t235],
                [a_axes_x_x, minus_a_axes_x_y],
                [-t236, t234],
                a_omega_z,
                ::mstmm::PlaneStateVector::new(
                    [-minus_a_acc_lin_x, -minus_a_acc_lin_y],
                    a_a_ang_z,
                    c(0.0),
                    [-minus_a_load_force_x, -minus_a_load_force_y],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t351, t335],
                [a_axes_x_x, minus_a_axes_x_y],
                [-t295, t296],
                a_omega_z,
                ::mstmm::PlaneStateVector::new(
                    [-minus_b_acc_lin_x, -minus_b_acc_lin_y],
                    a_a_ang_z,
                    c(0.0),
                    [-minus_b_load_force_x, -minus_b_load_force_y],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t351, t335],
                [b_axes_x_x, minus_b_axes_x_y],
                [-t295, t296],
                b_omega_z,
                ::mstmm::PlaneStateVector::new(
                    [-minus_b_acc_lin_x, -minus_b_acc_lin_y],
                    b_a_ang_z,
                    c(0.0),
                    [-minus_b_load_force_x, -minus_b_load_force_y],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t353, t355],
                [b_axes_x_x, minus_b_axes_x_y],
                [-t357, t359],
                b_omega_z,
                ::mstmm::PlaneStateVector::new(
                    [-t363, -t367],
                    b_a_ang_z,
                    c(0.0),
                    [-minus_rocker_pin_load_force_x, -minus_rocker_pin_load_force_y],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [c(0.8), c(0.0)],
                [c(1.0), c(0.0)],
                [c(0.0), c(0.0)],
                c(0.0),
                ::mstmm::PlaneStateVector::new(
                    [c(0.0), c(0.0)],
                    c(0.0),
                    c(0.0),
                    [-minus_rocker_pin_load_force_x, -minus_rocker_pin_load_force_y],
                ),
            ),
        ];
        ::core::result::Result::Ok(())
    }
    /// Kinetic and potential energy in J; the potential of gravity is zero with every centre
    /// of mass at the inertial origin.
    ///
    /// 72 operations: 47 mul, 25 add, 0 reciprocal, 3 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 3 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 4 | 3 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 4 | 3 | 0 | 0 | 0 |
    /// | Results |  | 39 | 19 | 0 | 0 | 0 |
    #[must_use]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn energy(&self, state: &FourBarState<T>) -> ::mstmm::Energy<T> {
        let c = T::constant;
        let [[crank_pin_angle, a_angle, b_angle, ..]] = state.q.data.0;
        let [[crank_pin_rate, a_rate, b_rate, ..]] = state.v.data.0;
        /// Motion across `crank_pin`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 3 sin/cos.
        let (
            [sin_crank_pin_angle,
            sin_a_angle,
            sin_b_angle,
            ],
            [cos_crank_pin_angle,
            cos_a_angle,
            cos_b_angle,
            ],
        ) = T::sin_cos([crank_pin_angle, a_angle, b_angle]);
        /// Motion across `a`, [P, Eqs. (1), (13), (36)]: 4 mul, 3 add, 0 reciprocal.
        let t0 = cos_crank_pin_angle * cos_a_angle;
        let t1 = sin_crank_pin_angle * sin_a_angle;
        let a_axes_x_x = t0 - t1;
        let t2 = cos_crank_pin_angle * sin_a_angle;
        let t3 = sin_crank_pin_angle * cos_a_angle;
        let minus_a_axes_x_y = t2 + t3;
        let a_omega_z = crank_pin_rate + a_rate;
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 4 mul, 3 add, 0 reciprocal.
        let t4 = cos_b_angle * a_axes_x_x;
        let t5 = sin_b_angle * minus_a_axes_x_y;
        let b_axes_x_x = t4 - t5;
        let t6 = sin_b_angle * a_axes_x_x;
        let t7 = cos_b_angle * minus_a_axes_x_y;
        let minus_b_axes_x_y = t6 + t7;
        let b_omega_z = b_rate + a_omega_z;
        /// Results: 39 mul, 19 add, 0 reciprocal.
        let t8 = cos_crank_pin_angle * c(0.1);
        let t9 = sin_crank_pin_angle * c(0.1);
        let t10 = cos_crank_pin_angle * c(0.2);
        let t11 = sin_crank_pin_angle * c(0.2);
        let t12 = crank_pin_rate * t11;
        let t13 = crank_pin_rate * t10;
        let t14 = c(0.6) * a_axes_x_x;
        let t15 = c(0.6) * minus_a_axes_x_y;
        let t16 = a_omega_z * t15;
        let t17 = a_omega_z * t14;
        let t18 = t12 + t16;
        let t19 = t13 + t17;
        let t20 = crank_pin_rate * t9;
        let t21 = crank_pin_rate * t8;
        let t22 = crank_pin_rate * c(0.01);
        let t23 = crank_pin_rate * t22;
        let t24 = t20 * t20;
        let t25 = t21 * t21;
        let t26 = t24 + t25;
        let t27 = t23 + t26;
        let t28 = a_axes_x_x * c(0.3);
        let t29 = minus_a_axes_x_y * c(0.3);
        let t30 = a_omega_z * t29;
        let t31 = a_omega_z * t28;
        let t32 = t12 + t30;
        let t33 = t13 + t31;
        let t34 = a_omega_z * c(0.06);
        let t35 = a_omega_z * t34;
        let t36 = t32 * t32;
        let t37 = t33 * t33;
        let t38 = t36 + t37;
        let t39 = c(2.0) * t38;
        let t40 = t35 + t39;
        let t41 = b_axes_x_x * c(0.3);
        let t42 = minus_b_axes_x_y * c(0.3);
        let t43 = b_omega_z * t42;
        let t44 = b_omega_z * t41;
        let t45 = t18 + t43;
        let t46 = t19 + t44;
        let t47 = b_omega_z * c(0.06);
        let t48 = b_omega_z * t47;
        let t49 = t45 * t45;
        let t50 = t46 * t46;
        let t51 = t49 + t50;
        let t52 = c(2.0) * t51;
        let t53 = t48 + t52;
        let t54 = c(0.5) * t53;
        let t55 = t27 + t40;
        let t56 = c(0.5) * t55;
        let t57 = t54 + t56;
        let t58 = t11 + t15;
        let t59 = sin_crank_pin_angle * c(0.9800000000000001);
        let t60 = t11 + t29;
        let t61 = t60 * c(19.6);
        let t62 = t59 + t61;
        let t63 = t58 + t42;
        let t64 = c(19.6) * t63;
        let t65 = t62 + t64;
        ::mstmm::Energy {
            kinetic: t57,
            potential: t65,
        }
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::Chain for FourBar<T> {
    type Scalar = T;
    type State = FourBarState<T>;
    type Inputs = FourBarInputs<T>;
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn derivative_into(
        &self,
        state: &FourBarState<T>,
        inputs: &FourBarInputs<T>,
        rate: &mut FourBarState<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.accelerations_into(state, inputs, &mut rate.v)?;
        self.configuration_rate_into(state, rate);
        ::core::result::Result::Ok(())
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn configuration_rate_into(
        &self,
        state: &FourBarState<T>,
        rate: &mut FourBarState<T>,
    ) {
        rate.q.data.0 = {
            let [[crank_pin_rate, a_rate, b_rate, rocker_pin_rate]] = state.v.data.0;
            [[crank_pin_rate, a_rate, b_rate, rocker_pin_rate]]
        };
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn normalize(&self, state: &mut FourBarState<T>) {
        state.q.data.0 = {
            let [[crank_pin_angle, a_angle, b_angle, rocker_pin_angle]] = state.q.data.0;
            [[crank_pin_angle, a_angle, b_angle, rocker_pin_angle]]
        };
    }
    #[inline]
    fn close(
        &self,
        state: &mut FourBarState<T>,
        inputs: impl ::core::ops::FnOnce(&FourBarState<T>) -> FourBarInputs<T>,
    ) {
        let inputs = inputs(state);
        self.correct(state, &inputs);
    }
}
#[allow(dead_code)]
impl<T: ::mstmm::Scalar> FourBar<T> {
    /// Corrects coordinates and rates once by the smallest motion that closes the
    /// chain, and returns how far it was from closed.
    ///
    /// 272 operations: 159 mul, 104 add, 6 reciprocal, 3 square root, 4 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 8 | 5 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 8 | 7 | 0 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 84 | 42 | 5 | 2 | 0 |
    /// | Acceleration of `crank_pin` | \[P, Eqs. (13), (36), (44)\] | 2 | 1 | 0 | 0 | 0 |
    /// | Acceleration of `a` | \[P, Eqs. (13), (36), (44)\] | 7 | 3 | 0 | 0 | 0 |
    /// | Acceleration of `b` | \[P, Eqs. (13), (36), (44)\] | 6 | 4 | 0 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 23 | 12 | 0 | 0 | 0 |
    /// | Acceleration of `crank_pin` | \[P, Eqs. (13), (36), (44)\] | 2 | 1 | 0 | 0 | 0 |
    /// | Acceleration of `a` | \[P, Eqs. (13), (36), (44)\] | 7 | 3 | 0 | 0 | 0 |
    /// | Acceleration of `b` | \[P, Eqs. (13), (36), (44)\] | 6 | 4 | 0 | 0 | 0 |
    /// | Results |  | 6 | 20 | 0 | 1 | 0 |
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn correct(&self, state: &mut FourBarState<T>, inputs: &FourBarInputs<T>) -> T {
        let c = T::constant;
        let [[crank_pin_angle, a_angle, b_angle, rocker_pin_angle]] = state.q.data.0;
        let [[crank_pin_rate, a_rate, b_rate, rocker_pin_rate]] = state.v.data.0;
        /// Motion across `crank_pin`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 4 sin/cos.
        let (
            [sin_crank_pin_angle,
            sin_a_angle,
            sin_b_angle,
            sin_rocker_pin_angle,
            ],
            [cos_crank_pin_angle,
            cos_a_angle,
            cos_b_angle,
            cos_rocker_pin_angle,
            ],
        ) = T::sin_cos([crank_pin_angle, a_angle, b_angle, rocker_pin_angle]);
        /// Motion across `a`, [P, Eqs. (1), (13), (36)]: 0 mul, 1 add, 0 reciprocal.
        let a_omega_z = crank_pin_rate + a_rate;
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 0 mul, 1 add, 0 reciprocal.
        let b_omega_z = b_rate + a_omega_z;
        /// Riccati transfer over `a`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 8 mul, 5 add, 1 reciprocal.
        let t0 = sin_b_angle * c(1.5);
        let t1 = sin_b_angle * t0;
        let minus_a_k_xx = t1 - c(4.0);
        let a_k_yy = c(2.5) + t1;
        let a_k_xy = cos_b_angle * t0;
        let a_b_x_z = c(0.6) * a_k_xy;
        let t2 = c(0.5) + t1;
        let t3 = c(0.6) * t2;
        let a_b_y_z = c(0.6) + t3;
        let t4 = t2 * c(0.36);
        let a_j_zz = c(0.24) + t4;
        let t5 = T::recip(a_j_zz);
        let a_z0_force_x = a_b_x_z * t5;
        let a_z0_force_y = a_b_y_z * t5;
        /// Riccati transfer over `crank_pin`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 8 mul, 7 add, 0 reciprocal.
        let t6 = a_b_x_z * a_z0_force_x;
        let t7 = minus_a_k_xx + t6;
        let t8 = a_b_y_z * a_z0_force_y;
        let t9 = a_k_yy - t8;
        let t10 = a_b_y_z * a_z0_force_x;
        let t11 = a_k_xy - t10;
        let t12 = t7 + t9;
        let t13 = sin_a_angle * t12;
        let t14 = c(2.0) * t11;
        let t15 = cos_a_angle * t14;
        let t16 = t13 - t15;
        let t17 = sin_a_angle * t16;
        let t18 = t9 - t17;
        let t19 = c(0.04000000000000001) * t18;
        let crank_pin_j_zz = c(0.020000000000000004) + t19;
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 84 mul, 42 add, 5 reciprocal, 2 square root.
        let t20 = c(0.6) * sin_rocker_pin_angle;
        let t21 = sin_rocker_pin_angle * c(2.5);
        let t22 = sin_rocker_pin_angle * c(1.5);
        let t23 = sin_rocker_pin_angle - t22;
        let t24 = t20 * t21;
        let t25 = cos_b_angle * cos_rocker_pin_angle;
        let t26 = sin_b_angle * t23;
        let t27 = t25 - t26;
        let t28 = sin_b_angle * cos_rocker_pin_angle;
        let t29 = cos_b_angle * t23;
        let t30 = t28 + t29;
        let t31 = c(0.6) * t30;
        let t32 = t31 * t5;
        let t33 = t31 * a_z0_force_x;
        let t34 = t27 - t33;
        let t35 = t31 * a_z0_force_y;
        let t36 = t30 - t35;
        let t37 = t31 * t32;
        let t38 = t24 + t37;
        let t39 = sin_a_angle * t34;
        let t40 = cos_a_angle * t36;
        let t41 = t39 + t40;
        let t42 = c(0.2) * t41;
        let t43 = T::recip(crank_pin_j_zz);
        let t44 = t42 * t43;
        let t45 = t42 * t44;
        let closure_d0 = t38 + t45;
        let t46 = c(0.6) * cos_rocker_pin_angle;
        let t47 = cos_rocker_pin_angle * c(2.5);
        let t48 = cos_rocker_pin_angle * c(1.5);
        let t49 = cos_rocker_pin_angle - t48;
        let t50 = t46 * t21;
        let t51 = t46 * t47;
        let t52 = cos_b_angle * sin_rocker_pin_angle;
        let t53 = sin_b_angle * t49;
        let t54 = t52 + t53;
        let t55 = sin_b_angle * sin_rocker_pin_angle;
        let t56 = cos_b_angle * t49;
        let t57 = t55 - t56;
        let t58 = c(0.6) * t57;
        let t59 = t58 * t5;
        let t60 = t58 * a_z0_force_x;
        let t61 = t54 - t60;
        let t62 = t58 * a_z0_force_y;
        let t63 = t57 - t62;
        let t64 = t58 * t32;
        let t65 = t50 - t64;
        let t66 = t58 * t59;
        let t67 = t51 + t66;
        let t68 = sin_a_angle * t61;
        let t69 = cos_a_angle * t63;
        let t70 = t68 + t69;
        let t71 = c(0.2) * t70;
        let t72 = t71 * t43;
        let t73 = t71 * t44;
        let t74 = t65 - t73;
        let t75 = t71 * t72;
        let t76 = t67 + t75;
        let t77 = ::mstmm::generated::recip_above(closure_d0, closure_d0);
        let t78 = t74 * t77;
        let t79 = t74 * t78;
        let closure_d1 = t76 - t79;
        let t80 = ::mstmm::generated::recip_above(closure_d1, t76);
        let t81 = closure_d0 * t77;
        let t82 = c(1.0) - t81;
        let t83 = t82 * t82;
        let t84 = ::mstmm::generated::recip_above(t83, c(1.0));
        let t85 = T::sqrt(t84);
        let t86 = t82 * t85;
        let t87 = closure_d1 * t80;
        let t88 = c(1.0) - t87;
        let t89 = t78 * t88;
        let t90 = t86 * t89;
        let t91 = t86 * t90;
        let t92 = t89 - t91;
        let t93 = t92 * t92;
        let t94 = t88 * t88;
        let t95 = t93 + t94;
        let t96 = ::mstmm::generated::recip_above(t95, c(1.0));
        let t97 = T::sqrt(t96);
        let t98 = t92 * t97;
        let t99 = t88 * t97;
        let t100 = cos_crank_pin_angle * cos_a_angle;
        let t101 = sin_crank_pin_angle * sin_a_angle;
        let t102 = t100 - t101;
        let t103 = cos_crank_pin_angle * sin_a_angle;
        let t104 = sin_crank_pin_angle * cos_a_angle;
        let t105 = t103 + t104;
        let t106 = cos_crank_pin_angle * c(0.2);
        let t107 = sin_crank_pin_angle * c(0.2);
        let t108 = c(0.6) * t102;
        let t109 = c(0.6) * t105;
        let t110 = cos_b_angle * t102;
        let t111 = sin_b_angle * t105;
        let t112 = t110 - t111;
        let t113 = sin_b_angle * t102;
        let t114 = cos_b_angle * t105;
        let t115 = t113 + t114;
        let t116 = c(0.6) * t112;
        let t117 = c(0.6) * t115;
        let t118 = t106 + t108;
        let t119 = t107 + t109;
        let t120 = cos_rocker_pin_angle * t112;
        let t121 = sin_rocker_pin_angle * t115;
        let t122 = t120 - t121;
        let t123 = sin_rocker_pin_angle * t112;
        let t124 = cos_rocker_pin_angle * t115;
        let t125 = t123 + t124;
        let t126 = t116 + t118;
        let t127 = t117 + t119;
        let t128 = c(0.8) - t126;
        let t129 = t122 * t128;
        let t130 = t125 * t127;
        let t131 = t129 - t130;
        let t132 = t125 * t128;
        let t133 = t122 * t127;
        let t134 = t132 + t133;
        let t135 = t78 * t131;
        let t136 = t134 + t135;
        let t137 = t77 * t131;
        let t138 = t80 * t136;
        let t139 = t78 * t138;
        let t140 = t137 + t139;
        let t141 = t86 * t140;
        let t142 = t86 * t141;
        let t143 = t140 - t142;
        let t144 = t98 * t143;
        let t145 = t99 * t138;
        let t146 = t144 + t145;
        let t147 = t98 * t146;
        let minus_closure_reaction0 = t143 - t147;
        let t148 = t99 * t146;
        let closure_reaction1 = t138 - t148;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 2 mul, 1 add, 0 reciprocal.
        let t149 = t44 * minus_closure_reaction0;
        let t150 = t72 * closure_reaction1;
        let crank_pin_a_ang_z = t149 + t150;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 7 mul, 3 add, 0 reciprocal.
        let t151 = c(0.2) * crank_pin_a_ang_z;
        let a_a_lin_x = sin_a_angle * t151;
        let a_a_lin_y = cos_a_angle * t151;
        let t152 = t32 * minus_closure_reaction0;
        let t153 = t59 * closure_reaction1;
        let t154 = t152 + t153;
        let t155 = a_z0_force_x * a_a_lin_x;
        let t156 = a_z0_force_y * a_a_lin_y;
        let t157 = t155 + t156;
        let a_a_ang_z = t154 - t157;
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 6 mul, 4 add, 0 reciprocal.
        let t158 = c(0.6) * a_a_ang_z;
        let t159 = a_a_lin_y + t158;
        let t160 = sin_b_angle * a_a_lin_x;
        let t161 = cos_b_angle * t159;
        let minus_b_a_lin_y = t160 - t161;
        let t162 = t21 * minus_closure_reaction0;
        let t163 = t47 * closure_reaction1;
        let t164 = t162 - t163;
        let t165 = c(2.5) * minus_b_a_lin_y;
        let b_a_ang_z = t164 + t165;
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 23 mul, 12 add, 0 reciprocal.
        let t166 = crank_pin_rate * c(0.2);
        let t167 = a_omega_z * c(0.6);
        let t168 = c(0.6) * b_omega_z;
        let t169 = sin_a_angle * t166;
        let t170 = cos_a_angle * t166;
        let t171 = t167 + t170;
        let t172 = cos_b_angle * t169;
        let t173 = sin_b_angle * t171;
        let t174 = t172 + t173;
        let t175 = sin_b_angle * t169;
        let t176 = cos_b_angle * t171;
        let t177 = t175 - t176;
        let t178 = t168 - t177;
        let t179 = cos_rocker_pin_angle * t174;
        let t180 = sin_rocker_pin_angle * t178;
        let t181 = t179 + t180;
        let t182 = sin_rocker_pin_angle * t174;
        let t183 = cos_rocker_pin_angle * t178;
        let t184 = t182 - t183;
        let t185 = t78 * t181;
        let t186 = t184 + t185;
        let t187 = t77 * t181;
        let t188 = t80 * t186;
        let t189 = t78 * t188;
        let t190 = t187 + t189;
        let t191 = t86 * t190;
        let t192 = t86 * t191;
        let t193 = t190 - t192;
        let t194 = t98 * t193;
        let t195 = t99 * t188;
        let t196 = t194 + t195;
        let t197 = t98 * t196;
        let closure_reaction0 = t193 - t197;
        let t198 = t99 * t196;
        let minus_closure_reaction1 = t188 - t198;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 2 mul, 1 add, 0 reciprocal.
        let t199 = t44 * closure_reaction0;
        let t200 = t72 * minus_closure_reaction1;
        let minus_crank_pin_a_ang_z = t199 + t200;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 7 mul, 3 add, 0 reciprocal.
        let t201 = c(0.2) * minus_crank_pin_a_ang_z;
        let minus_a_a_lin_x = sin_a_angle * t201;
        let minus_a_a_lin_y = cos_a_angle * t201;
        let t202 = t32 * closure_reaction0;
        let t203 = t59 * minus_closure_reaction1;
        let t204 = t202 + t203;
        let t205 = a_z0_force_x * minus_a_a_lin_x;
        let t206 = a_z0_force_y * minus_a_a_lin_y;
        let t207 = t205 + t206;
        let minus_a_a_ang_z = t204 - t207;
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 6 mul, 4 add, 0 reciprocal.
        let t208 = c(0.6) * minus_a_a_ang_z;
        let t209 = minus_a_a_lin_y + t208;
        let t210 = sin_b_angle * minus_a_a_lin_x;
        let t211 = cos_b_angle * t209;
        let b_a_lin_y = t210 - t211;
        let t212 = t21 * closure_reaction0;
        let t213 = t47 * minus_closure_reaction1;
        let t214 = t212 - t213;
        let t215 = c(2.5) * b_a_lin_y;
        let minus_b_a_ang_z = t214 + t215;
        /// Results: 6 mul, 20 add, 0 reciprocal, 1 square root.
        let t216 = crank_pin_angle + crank_pin_a_ang_z;
        let t217 = crank_pin_a_ang_z - a_a_ang_z;
        let t218 = a_angle - t217;
        let t219 = a_a_ang_z - b_a_ang_z;
        let t220 = b_angle - t219;
        let t221 = t125 + b_a_ang_z;
        let t222 = rocker_pin_angle - t221;
        let t223 = crank_pin_rate - minus_crank_pin_a_ang_z;
        let t224 = minus_crank_pin_a_ang_z - minus_a_a_ang_z;
        let t225 = a_rate + t224;
        let t226 = minus_a_a_ang_z - minus_b_a_ang_z;
        let t227 = b_rate + t226;
        let t228 = rocker_pin_rate + b_omega_z;
        let t229 = t228 - minus_b_a_ang_z;
        let t230 = rocker_pin_rate - t229;
        let t231 = t131 * t131;
        let t232 = t134 * t134;
        let t233 = t231 + t232;
        let t234 = t125 * t125;
        let t235 = t233 + t234;
        let t236 = t181 * t181;
        let t237 = t184 * t184;
        let t238 = t236 + t237;
        let t239 = t228 * t228;
        let t240 = t238 + t239;
        let t241 = t235 + t240;
        let t242 = T::sqrt(t241);
        let residual = t242;
        state.q.data.0 = [[t216, t218, t220, t222]];
        state.v.data.0 = [[t223, t225, t227, t230]];
        residual
    }
}
impl<T: ::mstmm::Scalar> FourBar<T> {
    /// Closes the chain: moves `state` to coordinates and rates nearby, measured by
    /// the kinetic energy that it takes, that fulfil the closure.
    ///
    /// # Errors
    ///
    /// [`Error::NotAssembled`](::mstmm::Error::NotAssembled) if that leads nowhere;
    /// `state` is left as it was.
    #[allow(dead_code)]
    pub fn assemble(
        &self,
        state: &mut FourBarState<T>,
        inputs: &FourBarInputs<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        ::mstmm::generated::assemble(state, |state| self.correct(state, inputs))
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::GeneratedChain for FourBar<T> {
    type Workspace = FourBarWorkspace<T>;
    #[inline]
    fn initial_state(&self) -> FourBarState<T> {
        self.initial_state()
    }
    #[inline]
    fn no_inputs(&self) -> FourBarInputs<T> {
        self.no_inputs()
    }
    #[inline]
    fn workspace(&self) -> FourBarWorkspace<T> {
        self.workspace()
    }
    #[inline]
    fn solve_into(
        &self,
        state: &FourBarState<T>,
        inputs: &FourBarInputs<T>,
        at: &mut FourBarWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.solve_into(state, inputs, at)
    }
    #[inline]
    fn assemble(
        &self,
        state: &mut FourBarState<T>,
        inputs: &FourBarInputs<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.assemble(state, inputs)
    }
    #[inline]
    fn energy(&self, state: &FourBarState<T>) -> ::mstmm::Energy<T> {
        self.energy(state)
    }
}
/// Coordinates and rates of [`FourBar`] at a time.
///
/// The hinges lie one after the other in the order written. [`Default`] is every hinge at
/// rest in its zero position.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct FourBarState<T> {
    /// Coordinates: angles in rad, lengths in m, unit quaternions as w, x, y, z.
    pub q: ::mstmm::nalgebra::SVector<T, 4>,
    /// Rates in rad/s and m/s.
    pub v: ::mstmm::nalgebra::SVector<T, 4>,
    /// Time in s.
    pub t: T,
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> FourBarState<T> {
    /// Coordinates and rates of hinge `crank_pin`.
    #[inline]
    #[must_use]
    pub fn crank_pin(&self) -> ::mstmm::PinState<T> {
        let [[q0, ..]] = self.q.data.0;
        let [[v0, ..]] = self.v.data.0;
        ::mstmm::PinState::new(q0, v0)
    }
    /// Coordinates and rates of hinge `crank_pin`, to be changed.
    #[inline]
    pub fn crank_pin_mut(&mut self) -> ::mstmm::PinStateMut<'_, T> {
        let [[q0, ..]] = &mut self.q.data.0;
        let [[v0, ..]] = &mut self.v.data.0;
        ::mstmm::PinStateMut::new(q0, v0)
    }
    /// Coordinates and rates of hinge `a`.
    #[inline]
    #[must_use]
    pub fn a(&self) -> ::mstmm::PinState<T> {
        let [[_, q1, ..]] = self.q.data.0;
        let [[_, v1, ..]] = self.v.data.0;
        ::mstmm::PinState::new(q1, v1)
    }
    /// Coordinates and rates of hinge `a`, to be changed.
    #[inline]
    pub fn a_mut(&mut self) -> ::mstmm::PinStateMut<'_, T> {
        let [[_, q1, ..]] = &mut self.q.data.0;
        let [[_, v1, ..]] = &mut self.v.data.0;
        ::mstmm::PinStateMut::new(q1, v1)
    }
    /// Coordinates and rates of hinge `b`.
    #[inline]
    #[must_use]
    pub fn b(&self) -> ::mstmm::PinState<T> {
        let [[_, _, q2, ..]] = self.q.data.0;
        let [[_, _, v2, ..]] = self.v.data.0;
        ::mstmm::PinState::new(q2, v2)
    }
    /// Coordinates and rates of hinge `b`, to be changed.
    #[inline]
    pub fn b_mut(&mut self) -> ::mstmm::PinStateMut<'_, T> {
        let [[_, _, q2, ..]] = &mut self.q.data.0;
        let [[_, _, v2, ..]] = &mut self.v.data.0;
        ::mstmm::PinStateMut::new(q2, v2)
    }
    /// Coordinates and rates of hinge `rocker_pin`.
    #[inline]
    #[must_use]
    pub fn rocker_pin(&self) -> ::mstmm::PinState<T> {
        let [[_, _, _, q3, ..]] = self.q.data.0;
        let [[_, _, _, v3, ..]] = self.v.data.0;
        ::mstmm::PinState::new(q3, v3)
    }
    /// Coordinates and rates of hinge `rocker_pin`, to be changed.
    #[inline]
    pub fn rocker_pin_mut(&mut self) -> ::mstmm::PinStateMut<'_, T> {
        let [[_, _, _, q3, ..]] = &mut self.q.data.0;
        let [[_, _, _, v3, ..]] = &mut self.v.data.0;
        ::mstmm::PinStateMut::new(q3, v3)
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for FourBarState<T> {
    fn default() -> Self {
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        let _ = one;
        Self {
            q: ::mstmm::generated::vector([zero, zero, zero, zero]),
            v: ::mstmm::generated::vector([zero; 4]),
            t: zero,
        }
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::ChainState for FourBarState<T> {
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
/// What drives [`FourBar`] from outside, given at every step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct FourBarInputs<T> {
    /// Efforts in N m that drive `crank_pin`, in the order of its rates.
    pub crank_pin: T,
}
impl<T: ::mstmm::Scalar> ::core::default::Default for FourBarInputs<T> {
    #[inline]
    fn default() -> Self {
        Self {
            crank_pin: T::constant(0.0),
        }
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> FourBar<T> {
    /// Inputs that are all zero; prescribed motions rest in the zero position.
    #[inline]
    #[must_use]
    pub fn no_inputs(&self) -> FourBarInputs<T> {
        ::core::default::Default::default()
    }
}
/// Results of [`FourBar::solve_into`].
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct FourBarWorkspace<T> {
    accelerations: ::mstmm::nalgebra::SVector<T, 4>,
    rate_accelerations: ::mstmm::nalgebra::SVector<T, 4>,
    efforts: ::mstmm::nalgebra::SVector<T, 4>,
    kinetic_energy: T,
    potential_energy: T,
    closure: ::mstmm::Closure<T, 2>,
    points: [::mstmm::PlanePoint<T>; 8],
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> FourBarWorkspace<T> {
    /// Accelerations `v̇` of all hinges, in the order of the rates.
    #[inline]
    pub fn accelerations(&self) -> &::mstmm::nalgebra::SVector<T, 4> {
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
    pub fn points(&self) -> &[::mstmm::PlanePoint<T>; 8] {
        &self.points
    }
    /// Which reactions of the closing hinge, the last one, the motion does not determine:
    /// wrenches in axes of its inboard frame.
    #[inline]
    pub fn closure(&self) -> &::mstmm::Closure<T, 2> {
        &self.closure
    }
    /// Acceleration, effort, input and output of hinge `crank_pin`.
    #[inline]
    pub fn crank_pin(&self) -> ::mstmm::HingeResult<'_, T, T, ::mstmm::PlanePoint<T>> {
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
    /// Input and output of body `crank`.
    #[inline]
    pub fn crank(&self) -> ::mstmm::BodyResult<'_, T, ::mstmm::PlanePoint<T>> {
        let [_, input, output, ..] = &self.points;
        ::mstmm::BodyResult::new(input, output)
    }
    /// Acceleration, effort, input and output of hinge `a`.
    #[inline]
    pub fn a(&self) -> ::mstmm::HingeResult<'_, T, T, ::mstmm::PlanePoint<T>> {
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
    /// Input and output of body `coupler`.
    #[inline]
    pub fn coupler(&self) -> ::mstmm::BodyResult<'_, T, ::mstmm::PlanePoint<T>> {
        let [_, _, _, input, output, ..] = &self.points;
        ::mstmm::BodyResult::new(input, output)
    }
    /// Acceleration, effort, input and output of hinge `b`.
    #[inline]
    pub fn b(&self) -> ::mstmm::HingeResult<'_, T, T, ::mstmm::PlanePoint<T>> {
        let [_, _, _, _, input, output, ..] = &self.points;
        ::mstmm::HingeResult::new(
            {
                let [value] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.rate_accelerations.as_slice(), 2);
                value
            },
            {
                let [value] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.efforts.as_slice(), 2);
                value
            },
            input,
            output,
        )
    }
    /// Input and output of body `rocker`.
    #[inline]
    pub fn rocker(&self) -> ::mstmm::BodyResult<'_, T, ::mstmm::PlanePoint<T>> {
        let [_, _, _, _, _, input, output, ..] = &self.points;
        ::mstmm::BodyResult::new(input, output)
    }
    /// Acceleration, effort, input and output of hinge `rocker_pin`.
    #[inline]
    pub fn rocker_pin(&self) -> ::mstmm::HingeResult<'_, T, T, ::mstmm::PlanePoint<T>> {
        let [_, _, _, _, _, _, input, output, ..] = &self.points;
        ::mstmm::HingeResult::new(
            {
                let [value] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.rate_accelerations.as_slice(), 3);
                value
            },
            {
                let [value] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.efforts.as_slice(), 3);
                value
            },
            input,
            output,
        )
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> FourBar<T> {
    /// Room for the results of [`solve_into`](Self::solve_into).
    #[must_use]
    pub fn workspace(&self) -> FourBarWorkspace<T> {
        let zero = T::constant(0.0);
        FourBarWorkspace {
            accelerations: ::mstmm::generated::vector([zero; 4]),
            rate_accelerations: ::mstmm::generated::vector([zero; 4]),
            efforts: ::mstmm::generated::vector([zero; 4]),
            kinetic_energy: zero,
            potential_energy: zero,
            closure: ::core::default::Default::default(),
            points: [::core::default::Default::default(); 8],
        }
    }
}
