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
/// 4 degrees of freedom; accelerations by `riccati`, 286 operations (171 mul, 107 add, 6 reciprocal, 2 square root, 4 sin/cos); with everything at every connection point 449 operations.
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
    /// 286 operations: 171 mul, 107 add, 6 reciprocal, 2 square root, 4 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `b` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 15 | 9 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 23 | 16 | 1 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 103 | 57 | 4 | 2 | 0 |
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
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 103 mul, 57 add, 4 reciprocal, 2 square root.
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
        let t78 = t51 * t51;
        let t79 = t78 * c(4.166666666666667);
        let t80 = cos_rocker_pin_angle * c(1.5);
        let t81 = cos_rocker_pin_angle - t80;
        let t82 = t76 * t52;
        let t83 = t76 * t77;
        let t84 = cos_b_angle * sin_rocker_pin_angle;
        let t85 = sin_b_angle * t81;
        let t86 = t84 + t85;
        let t87 = sin_b_angle * sin_rocker_pin_angle;
        let t88 = cos_b_angle * t81;
        let t89 = t87 - t88;
        let t90 = c(0.6) * t89;
        let t91 = t90 * t18;
        let t92 = t62 * t62;
        let t93 = t18 * t92;
        let t94 = t79 + t93;
        let t95 = t90 * a_z0_force_x;
        let t96 = t86 - t95;
        let t97 = t90 * a_z0_force_y;
        let t98 = t89 - t97;
        let t99 = t90 * t63;
        let t100 = t82 - t99;
        let t101 = t90 * t91;
        let t102 = t83 + t101;
        let t103 = sin_a_angle * t96;
        let t104 = cos_a_angle * t98;
        let t105 = t103 + t104;
        let t106 = c(0.2) * t105;
        let t107 = t106 * t50;
        let t108 = t73 * t73;
        let t109 = t50 * t108;
        let t110 = t94 + t109;
        let t111 = t106 * t74;
        let t112 = t100 - t111;
        let t113 = t106 * t107;
        let t114 = t102 + t113;
        let t115 = ::mstmm::generated::recip_above(closure_d0, t110);
        let t116 = t112 * t115;
        let t117 = t112 * t116;
        let closure_d1 = t114 - t117;
        let t118 = cos_rocker_pin_angle * minus_b_e_force_x;
        let t119 = sin_rocker_pin_angle * minus_b_e_force_x;
        let t120 = t119 - c(9.8);
        let t121 = t76 * t76;
        let t122 = c(4.166666666666667) * t121;
        let t123 = minus_b_drift_lin_x * cos_rocker_pin_angle;
        let t124 = b_drift_lin_y * t54;
        let t125 = t123 - t124;
        let t126 = minus_b_drift_lin_x * sin_rocker_pin_angle;
        let t127 = b_drift_lin_y * t81;
        let t128 = t126 + t127;
        let t129 = t62 * t35;
        let t130 = t125 - t129;
        let t131 = t90 * t35;
        let t132 = t128 - t131;
        let t133 = t90 * t90;
        let t134 = t18 * t133;
        let t135 = t122 + t134;
        let t136 = minus_a_drift_lin_x * t65;
        let t137 = a_drift_lin_y * t67;
        let t138 = t136 - t137;
        let t139 = t130 + t138;
        let t140 = minus_a_drift_lin_x * t96;
        let t141 = a_drift_lin_y * t98;
        let t142 = t140 - t141;
        let t143 = t132 + t142;
        let t144 = cos_a_angle * t65;
        let t145 = sin_a_angle * t67;
        let t146 = t144 - t145;
        let t147 = cos_a_angle * t96;
        let t148 = sin_a_angle * t98;
        let t149 = t147 - t148;
        let t150 = crank_pin_input0 + minus_crank_pin_e_moment_z;
        let t151 = t50 * t150;
        let t152 = t73 * minus_crank_pin_z0_force_x;
        let t153 = t146 + t152;
        let t154 = t73 * crank_pin_z0_force_y;
        let t155 = t72 - t154;
        let t156 = t73 * t151;
        let t157 = t139 - t156;
        let t158 = t106 * minus_crank_pin_z0_force_x;
        let t159 = t149 + t158;
        let t160 = t106 * crank_pin_z0_force_y;
        let t161 = t105 - t160;
        let t162 = t106 * t151;
        let t163 = t143 - t162;
        let t164 = t106 * t106;
        let t165 = t50 * t164;
        let t166 = t135 + t165;
        let crank_pin_a_lin_x = sin_crank_pin_angle * c(9.8);
        let crank_pin_a_lin_y = cos_crank_pin_angle * c(9.8);
        let t167 = t153 * crank_pin_a_lin_x;
        let t168 = t155 * crank_pin_a_lin_y;
        let t169 = t167 + t168;
        let t170 = t157 - t169;
        let t171 = t159 * crank_pin_a_lin_x;
        let t172 = t161 * crank_pin_a_lin_y;
        let t173 = t171 + t172;
        let t174 = t163 - t173;
        let t175 = t118 + t170;
        let t176 = t120 + t174;
        let t177 = ::mstmm::generated::recip_above(closure_d1, t166);
        let t178 = t175 * t116;
        let t179 = t176 + t178;
        let t180 = t175 * t115;
        let t181 = t177 * t179;
        let t182 = t116 * t181;
        let t183 = t180 + t182;
        let t184 = closure_d0 * t115;
        let t185 = c(1.0) - t184;
        let t186 = t185 * t185;
        let t187 = ::mstmm::generated::recip_above(t186, c(1.0));
        let t188 = T::sqrt(t187);
        let t189 = t185 * t188;
        let t190 = t183 * t189;
        let t191 = t189 * t190;
        let t192 = t183 - t191;
        let t193 = closure_d1 * t177;
        let t194 = c(1.0) - t193;
        let t195 = t116 * t194;
        let t196 = t189 * t195;
        let t197 = t189 * t196;
        let t198 = t195 - t197;
        let t199 = t198 * t198;
        let t200 = t194 * t194;
        let t201 = t199 + t200;
        let t202 = ::mstmm::generated::recip_above(t201, c(1.0));
        let t203 = T::sqrt(t202);
        let t204 = t198 * t203;
        let t205 = t194 * t203;
        let t206 = t192 * t204;
        let t207 = t181 * t205;
        let t208 = t206 + t207;
        let t209 = t204 * t208;
        let minus_closure_reaction0 = t192 - t209;
        let t210 = t205 * t208;
        let closure_reaction1 = t181 - t210;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 4 mul, 4 add, 0 reciprocal.
        let t211 = t74 * minus_closure_reaction0;
        let t212 = t107 * closure_reaction1;
        let t213 = t211 + t212;
        let t214 = t151 + t213;
        let t215 = minus_crank_pin_z0_force_x * crank_pin_a_lin_x;
        let t216 = crank_pin_z0_force_y * crank_pin_a_lin_y;
        let t217 = t215 - t216;
        let crank_pin_a_ang_z = t214 + t217;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 9 mul, 9 add, 0 reciprocal.
        let t218 = c(0.2) * crank_pin_a_ang_z;
        let t219 = crank_pin_a_lin_y + t218;
        let t220 = cos_a_angle * crank_pin_a_lin_x;
        let t221 = sin_a_angle * t219;
        let t222 = t220 + t221;
        let minus_a_a_lin_x = minus_a_drift_lin_x - t222;
        let t223 = sin_a_angle * crank_pin_a_lin_x;
        let t224 = cos_a_angle * t219;
        let t225 = t223 - t224;
        let a_a_lin_y = a_drift_lin_y - t225;
        let t226 = t63 * minus_closure_reaction0;
        let t227 = t91 * closure_reaction1;
        let t228 = t226 + t227;
        let t229 = t35 + t228;
        let t230 = a_z0_force_x * minus_a_a_lin_x;
        let t231 = a_z0_force_y * a_a_lin_y;
        let t232 = t230 - t231;
        let a_a_ang_z = t229 + t232;
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 6 mul, 5 add, 0 reciprocal.
        let t233 = c(0.6) * a_a_ang_z;
        let t234 = a_a_lin_y + t233;
        let t235 = sin_b_angle * minus_a_a_lin_x;
        let t236 = cos_b_angle * t234;
        let t237 = t235 + t236;
        let b_a_lin_y = b_drift_lin_y + t237;
        let t238 = t52 * minus_closure_reaction0;
        let t239 = t77 * closure_reaction1;
        let t240 = t238 - t239;
        let t241 = c(2.5) * b_a_lin_y;
        let b_a_ang_z = t240 - t241;
        /// Results: 1 mul, 5 add, 0 reciprocal.
        let t242 = crank_pin_a_ang_z - a_a_ang_z;
        let t243 = a_a_ang_z - b_a_ang_z;
        let t244 = t20 - t22;
        let t245 = c(4.0) - t244;
        let t246 = t245 * c(0.04000000000000001);
        let t247 = t246 + c(0.030000000000000006);
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
            [c(2.04), t247],
            [crank_pin_a_ang_z, -t242, -t243, -b_a_ang_z],
        )?;
        accelerations.data.0 = [[crank_pin_a_ang_z, -t242, -t243, -b_a_ang_z]];
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
    /// 449 operations: 270 mul, 171 add, 6 reciprocal, 2 square root, 4 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `b` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 15 | 9 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 23 | 16 | 1 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 103 | 57 | 4 | 2 | 0 |
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
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 103 mul, 57 add, 4 reciprocal, 2 square root.
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
        let t78 = t51 * t51;
        let t79 = t78 * c(4.166666666666667);
        let t80 = cos_rocker_pin_angle * c(1.5);
        let t81 = cos_rocker_pin_angle - t80;
        let t82 = t76 * t52;
        let t83 = t76 * t77;
        let t84 = cos_b_angle * sin_rocker_pin_angle;
        let t85 = sin_b_angle * t81;
        let t86 = t84 + t85;
        let t87 = sin_b_angle * sin_rocker_pin_angle;
        let t88 = cos_b_angle * t81;
        let t89 = t87 - t88;
        let t90 = c(0.6) * t89;
        let t91 = t90 * t18;
        let t92 = t62 * t62;
        let t93 = t18 * t92;
        let t94 = t79 + t93;
        let t95 = t90 * a_z0_force_x;
        let t96 = t86 - t95;
        let t97 = t90 * a_z0_force_y;
        let t98 = t89 - t97;
        let t99 = t90 * t63;
        let t100 = t82 - t99;
        let t101 = t90 * t91;
        let t102 = t83 + t101;
        let t103 = sin_a_angle * t96;
        let t104 = cos_a_angle * t98;
        let t105 = t103 + t104;
        let t106 = c(0.2) * t105;
        let t107 = t106 * t50;
        let t108 = t73 * t73;
        let t109 = t50 * t108;
        let t110 = t94 + t109;
        let t111 = t106 * t74;
        let t112 = t100 - t111;
        let t113 = t106 * t107;
        let t114 = t102 + t113;
        let t115 = ::mstmm::generated::recip_above(closure_d0, t110);
        let t116 = t112 * t115;
        let t117 = t112 * t116;
        let closure_d1 = t114 - t117;
        let t118 = cos_rocker_pin_angle * minus_b_e_force_x;
        let t119 = sin_rocker_pin_angle * minus_b_e_force_x;
        let t120 = t119 - c(9.8);
        let t121 = t76 * t76;
        let t122 = c(4.166666666666667) * t121;
        let t123 = minus_b_drift_lin_x * cos_rocker_pin_angle;
        let t124 = b_drift_lin_y * t54;
        let t125 = t123 - t124;
        let t126 = minus_b_drift_lin_x * sin_rocker_pin_angle;
        let t127 = b_drift_lin_y * t81;
        let t128 = t126 + t127;
        let t129 = t62 * t35;
        let t130 = t125 - t129;
        let t131 = t90 * t35;
        let t132 = t128 - t131;
        let t133 = t90 * t90;
        let t134 = t18 * t133;
        let t135 = t122 + t134;
        let t136 = minus_a_drift_lin_x * t65;
        let t137 = a_drift_lin_y * t67;
        let t138 = t136 - t137;
        let t139 = t130 + t138;
        let t140 = minus_a_drift_lin_x * t96;
        let t141 = a_drift_lin_y * t98;
        let t142 = t140 - t141;
        let t143 = t132 + t142;
        let t144 = cos_a_angle * t65;
        let t145 = sin_a_angle * t67;
        let t146 = t144 - t145;
        let t147 = cos_a_angle * t96;
        let t148 = sin_a_angle * t98;
        let t149 = t147 - t148;
        let t150 = crank_pin_input0 + minus_crank_pin_e_moment_z;
        let t151 = t50 * t150;
        let t152 = t73 * minus_crank_pin_z0_force_x;
        let t153 = t146 + t152;
        let t154 = t73 * crank_pin_z0_force_y;
        let t155 = t72 - t154;
        let t156 = t73 * t151;
        let t157 = t139 - t156;
        let t158 = t106 * minus_crank_pin_z0_force_x;
        let t159 = t149 + t158;
        let t160 = t106 * crank_pin_z0_force_y;
        let t161 = t105 - t160;
        let t162 = t106 * t151;
        let t163 = t143 - t162;
        let t164 = t106 * t106;
        let t165 = t50 * t164;
        let t166 = t135 + t165;
        let crank_pin_a_lin_x = sin_crank_pin_angle * c(9.8);
        let crank_pin_a_lin_y = cos_crank_pin_angle * c(9.8);
        let t167 = t153 * crank_pin_a_lin_x;
        let t168 = t155 * crank_pin_a_lin_y;
        let t169 = t167 + t168;
        let t170 = t157 - t169;
        let t171 = t159 * crank_pin_a_lin_x;
        let t172 = t161 * crank_pin_a_lin_y;
        let t173 = t171 + t172;
        let t174 = t163 - t173;
        let t175 = t118 + t170;
        let t176 = t120 + t174;
        let t177 = ::mstmm::generated::recip_above(closure_d1, t166);
        let t178 = t175 * t116;
        let t179 = t176 + t178;
        let t180 = t175 * t115;
        let t181 = t177 * t179;
        let t182 = t116 * t181;
        let t183 = t180 + t182;
        let t184 = closure_d0 * t115;
        let t185 = c(1.0) - t184;
        let t186 = t185 * t185;
        let t187 = ::mstmm::generated::recip_above(t186, c(1.0));
        let t188 = T::sqrt(t187);
        let t189 = t185 * t188;
        let t190 = t183 * t189;
        let t191 = t189 * t190;
        let t192 = t183 - t191;
        let t193 = closure_d1 * t177;
        let t194 = c(1.0) - t193;
        let t195 = t116 * t194;
        let t196 = t189 * t195;
        let t197 = t189 * t196;
        let t198 = t195 - t197;
        let t199 = t198 * t198;
        let t200 = t194 * t194;
        let t201 = t199 + t200;
        let t202 = ::mstmm::generated::recip_above(t201, c(1.0));
        let t203 = T::sqrt(t202);
        let t204 = t198 * t203;
        let t205 = t194 * t203;
        let t206 = t192 * t204;
        let t207 = t181 * t205;
        let t208 = t206 + t207;
        let t209 = t204 * t208;
        let minus_closure_reaction0 = t192 - t209;
        let t210 = t205 * t208;
        let closure_reaction1 = t181 - t210;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 4 mul, 4 add, 0 reciprocal.
        let t211 = t74 * minus_closure_reaction0;
        let t212 = t107 * closure_reaction1;
        let t213 = t211 + t212;
        let t214 = t151 + t213;
        let t215 = minus_crank_pin_z0_force_x * crank_pin_a_lin_x;
        let t216 = crank_pin_z0_force_y * crank_pin_a_lin_y;
        let t217 = t215 - t216;
        let crank_pin_a_ang_z = t214 + t217;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 9 mul, 9 add, 0 reciprocal.
        let t218 = c(0.2) * crank_pin_a_ang_z;
        let t219 = crank_pin_a_lin_y + t218;
        let t220 = cos_a_angle * crank_pin_a_lin_x;
        let t221 = sin_a_angle * t219;
        let t222 = t220 + t221;
        let minus_a_a_lin_x = minus_a_drift_lin_x - t222;
        let t223 = sin_a_angle * crank_pin_a_lin_x;
        let t224 = cos_a_angle * t219;
        let t225 = t223 - t224;
        let a_a_lin_y = a_drift_lin_y - t225;
        let t226 = t63 * minus_closure_reaction0;
        let t227 = t91 * closure_reaction1;
        let t228 = t226 + t227;
        let t229 = t35 + t228;
        let t230 = a_z0_force_x * minus_a_a_lin_x;
        let t231 = a_z0_force_y * a_a_lin_y;
        let t232 = t230 - t231;
        let a_a_ang_z = t229 + t232;
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 8 mul, 7 add, 0 reciprocal.
        let t233 = c(0.6) * a_a_ang_z;
        let t234 = a_a_lin_y + t233;
        let t235 = cos_b_angle * minus_a_a_lin_x;
        let t236 = sin_b_angle * t234;
        let t237 = t235 - t236;
        let minus_b_a_lin_x = minus_b_drift_lin_x + t237;
        let t238 = sin_b_angle * minus_a_a_lin_x;
        let t239 = cos_b_angle * t234;
        let t240 = t238 + t239;
        let b_a_lin_y = b_drift_lin_y + t240;
        let t241 = t52 * minus_closure_reaction0;
        let t242 = t77 * closure_reaction1;
        let t243 = t241 - t242;
        let t244 = c(2.5) * b_a_lin_y;
        let b_a_ang_z = t243 - t244;
        /// Motion across `a`, [P, Eqs. (1), (13), (36)]: 10 mul, 2 add, 0 reciprocal.
        let t245 = cos_crank_pin_angle * cos_a_angle;
        let t246 = sin_crank_pin_angle * sin_a_angle;
        let a_axes_x_x = t245 - t246;
        let t247 = cos_crank_pin_angle * sin_a_angle;
        let t248 = sin_crank_pin_angle * cos_a_angle;
        let minus_a_axes_x_y = t247 + t248;
        let t249 = cos_crank_pin_angle * c(0.2);
        let t250 = crank_pin_rate * t249;
        let minus_a_drift_lin_x_2 = crank_pin_rate * t250;
        let t251 = sin_crank_pin_angle * c(0.2);
        let t252 = crank_pin_rate * t251;
        let minus_a_drift_lin_y = crank_pin_rate * t252;
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 10 mul, 2 add, 0 reciprocal.
        let t253 = cos_b_angle * a_axes_x_x;
        let t254 = sin_b_angle * minus_a_axes_x_y;
        let b_axes_x_x = t253 - t254;
        let t255 = sin_b_angle * a_axes_x_x;
        let t256 = cos_b_angle * minus_a_axes_x_y;
        let minus_b_axes_x_y = t255 + t256;
        let t257 = c(0.6) * a_axes_x_x;
        let t258 = a_omega_z * t257;
        let minus_b_drift_lin_x_2 = a_omega_z * t258;
        let t259 = c(0.6) * minus_a_axes_x_y;
        let t260 = a_omega_z * t259;
        let minus_b_drift_lin_y = a_omega_z * t260;
        /// Point of `a`, [P, Eqs. (12), (13), (36)]: 2 mul, 2 add, 0 reciprocal.
        let t261 = crank_pin_a_ang_z * t251;
        let minus_a_acc_lin_x = minus_a_drift_lin_x_2 + t261;
        let t262 = crank_pin_a_ang_z * t249;
        let minus_a_acc_lin_y = minus_a_drift_lin_y - t262;
        /// Point of `b`, [P, Eqs. (12), (13), (36)]: 2 mul, 4 add, 0 reciprocal.
        let t263 = a_a_ang_z * t259;
        let t264 = minus_a_acc_lin_x + t263;
        let minus_b_acc_lin_x = minus_b_drift_lin_x_2 + t264;
        let t265 = a_a_ang_z * t257;
        let t266 = minus_a_acc_lin_y - t265;
        let minus_b_acc_lin_y = minus_b_drift_lin_y + t266;
        /// Load of the body at `crank_pin`, [P, Eqs. (18), (19)]: 7 mul, 4 add, 0 reciprocal.
        let t267 = crank_pin_rate * c(0.1);
        let t268 = crank_pin_rate * t267;
        let t269 = c(0.1) * crank_pin_a_ang_z;
        let t270 = crank_pin_a_lin_y + t269;
        let t271 = t268 - crank_pin_a_lin_x;
        let t272 = cos_crank_pin_angle * t271;
        let t273 = sin_crank_pin_angle * t270;
        let minus_crank_pin_own_force_x = t272 + t273;
        let t274 = sin_crank_pin_angle * t271;
        let t275 = cos_crank_pin_angle * t270;
        let minus_crank_pin_own_force_y = t274 - t275;
        /// Load of the body at `a`, [P, Eqs. (18), (19)]: 6 mul, 4 add, 0 reciprocal.
        let t276 = c(2.0) * minus_a_a_lin_x;
        let t277 = c(2.0) * a_a_lin_y;
        let t278 = t233 + t277;
        let t279 = t3 + t276;
        let t280 = a_axes_x_x * t279;
        let t281 = minus_a_axes_x_y * t278;
        let minus_a_own_force_x = t280 + t281;
        let t282 = minus_a_axes_x_y * t279;
        let t283 = a_axes_x_x * t278;
        let minus_a_own_force_y = t282 - t283;
        /// Load of the body at `b`, [P, Eqs. (18), (19)]: 7 mul, 4 add, 0 reciprocal.
        let t284 = c(0.6) * b_a_ang_z;
        let t285 = c(2.0) * minus_b_a_lin_x;
        let t286 = c(2.0) * b_a_lin_y;
        let t287 = t284 + t286;
        let t288 = minus_b_e_force_x + t285;
        let t289 = b_axes_x_x * t288;
        let t290 = minus_b_axes_x_y * t287;
        let minus_b_own_force_x = t289 + t290;
        let t291 = minus_b_axes_x_y * t288;
        let t292 = b_axes_x_x * t287;
        let minus_b_own_force_y = t291 - t292;
        /// Load on `rocker_pin`, [P, Eqs. (18), (19)]: 8 mul, 4 add, 0 reciprocal.
        let t293 = cos_rocker_pin_angle * minus_closure_reaction0;
        let t294 = sin_rocker_pin_angle * closure_reaction1;
        let t295 = t293 + t294;
        let t296 = sin_rocker_pin_angle * minus_closure_reaction0;
        let t297 = cos_rocker_pin_angle * closure_reaction1;
        let t298 = t296 - t297;
        let t299 = t295 * b_axes_x_x;
        let t300 = t298 * minus_b_axes_x_y;
        let minus_rocker_pin_load_force_x = t299 - t300;
        let t301 = t295 * minus_b_axes_x_y;
        let t302 = t298 * b_axes_x_x;
        let minus_rocker_pin_load_force_y = t301 + t302;
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
        let t303 = crank_pin_a_ang_z - a_a_ang_z;
        let t304 = a_a_ang_z - b_a_ang_z;
        let t305 = t20 - t22;
        let t306 = c(4.0) - t305;
        let t307 = t306 * c(0.04000000000000001);
        let t308 = t307 + c(0.030000000000000006);
        let t309 = cos_crank_pin_angle * c(0.1);
        let t310 = sin_crank_pin_angle * c(0.1);
        let t311 = t252 + t260;
        let t312 = t250 + t258;
        let t313 = crank_pin_rate * t310;
        let t314 = crank_pin_rate * t309;
        let t315 = crank_pin_rate * c(0.01);
        let t316 = crank_pin_rate * t315;
        let t317 = t313 * t313;
        let t318 = t314 * t314;
        let t319 = t317 + t318;
        let t320 = t316 + t319;
        let t321 = a_axes_x_x * c(0.3);
        let t322 = minus_a_axes_x_y * c(0.3);
        let t323 = a_omega_z * t322;
        let t324 = a_omega_z * t321;
        let t325 = t252 + t323;
        let t326 = t250 + t324;
        let t327 = a_omega_z * c(0.06);
        let t328 = a_omega_z * t327;
        let t329 = t325 * t325;
        let t330 = t326 * t326;
        let t331 = t329 + t330;
        let t332 = c(2.0) * t331;
        let t333 = t328 + t332;
        let t334 = b_axes_x_x * c(0.3);
        let t335 = minus_b_axes_x_y * c(0.3);
        let t336 = b_omega_z * t335;
        let t337 = b_omega_z * t334;
        let t338 = t311 + t336;
        let t339 = t312 + t337;
        let t340 = b_omega_z * c(0.06);
        let t341 = b_omega_z * t340;
        let t342 = t338 * t338;
        let t343 = t339 * t339;
        let t344 = t342 + t343;
        let t345 = c(2.0) * t344;
        let t346 = t341 + t345;
        let t347 = c(0.5) * t346;
        let t348 = t320 + t333;
        let t349 = c(0.5) * t348;
        let t350 = t347 + t349;
        let t351 = t251 + t259;
        let t352 = sin_crank_pin_angle * c(0.9800000000000001);
        let t353 = t251 + t322;
        let t354 = t353 * c(19.6);
        let t355 = t352 + t354;
        let t356 = t351 + t335;
        let t357 = c(19.6) * t356;
        let t358 = t355 + t357;
        let t359 = cos_rocker_pin_angle * t189;
        let t360 = sin_rocker_pin_angle * t189;
        let t361 = cos_rocker_pin_angle * t204;
        let t362 = sin_rocker_pin_angle * t205;
        let t363 = t361 + t362;
        let t364 = sin_rocker_pin_angle * t204;
        let t365 = cos_rocker_pin_angle * t205;
        let t366 = t364 - t365;
        let t367 = t249 + t257;
        let t368 = c(0.6) * b_axes_x_x;
        let t369 = t368 + t367;
        let t370 = c(0.6) * minus_b_axes_x_y;
        let t371 = t370 + t351;
        let t372 = b_omega_z * t370;
        let t373 = t311 + t372;
        let t374 = b_omega_z * t368;
        let t375 = t312 + t374;
        let t376 = b_omega_z * t374;
        let t377 = b_a_ang_z * t370;
        let t378 = minus_b_acc_lin_x + t377;
        let t379 = t376 + t378;
        let t380 = b_omega_z * t372;
        let t381 = b_a_ang_z * t368;
        let t382 = minus_b_acc_lin_y - t381;
        let t383 = t380 + t382;
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
            [c(2.04), t308],
            [crank_pin_a_ang_z, -t303, -t304, -b_a_ang_z],
        )?;
        at.accelerations.data.0 = [[crank_pin_a_ang_z, -t303, -t304, -b_a_ang_z]];
        at.rate_accelerations.data.0 = [[crank_pin_a_ang_z, -t303, -t304, -b_a_ang_z]];
        at.efforts.data.0 = [[crank_pin_input0, c(0.0), c(0.0), c(0.0)]];
        at.closure = ::mstmm::generated::closure([
            [t359, t360, c(0.0), c(0.0), c(0.0), c(0.0)],
            [-t363, -t366, c(0.0), c(0.0), c(0.0), c(0.0)],
        ]);
        at.kinetic_energy = t350;
        at.potential_energy = t358;
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
                [t249, t251],
                [cos_crank_pin_angle, sin_crank_pin_angle],
                [-t252, t250],
                crank_pin_rate,
                ::mstmm::PlaneStateVector::new(
                    [-minus_a_acc_lin_x, -minus_a_acc_lin_y],
                    crank_pin_a_ang_z,
                    c(0.0),
                    [-minus_a_load_force_x, -minus_a_load_force_y],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t249, t251],
                [a_axes_x_x, minus_a_axes_x_y],
                [-t252, t250],
                a_omega_z,
                ::mstmm::PlaneStateVector::new(
                    [-minus_a_acc_lin_x, -minus_a_acc_lin_y],
                    a_a_ang_z,
                    c(0.0),
                    [-minus_a_load_force_x, -minus_a_load_force_y],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t367, t351],
                [a_axes_x_x, minus_a_axes_x_y],
                [-t311, t312],
                a_omega_z,
                ::mstmm::PlaneStateVector::new(
                    [-minus_b_acc_lin_x, -minus_b_acc_lin_y],
                    a_a_ang_z,
                    c(0.0),
                    [-minus_b_load_force_x, -minus_b_load_force_y],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t367, t351],
                [b_axes_x_x, minus_b_axes_x_y],
                [-t311, t312],
                b_omega_z,
                ::mstmm::PlaneStateVector::new(
                    [-minus_b_acc_lin_x, -minus_b_acc_lin_y],
                    b_a_ang_z,
                    c(0.0),
                    [-minus_b_load_force_x, -minus_b_load_force_y],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t369, t371],
                [b_axes_x_x, minus_b_axes_x_y],
                [-t373, t375],
                b_omega_z,
                ::mstmm::PlaneStateVector::new(
                    [-t379, -t383],
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
    /// 288 operations: 171 mul, 108 add, 6 reciprocal, 3 square root, 4 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 8 | 5 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 8 | 7 | 0 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 96 | 46 | 5 | 2 | 0 |
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
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 96 mul, 46 add, 5 reciprocal, 2 square root.
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
        let t48 = t20 * t20;
        let t49 = t48 * c(4.166666666666667);
        let t50 = cos_rocker_pin_angle * c(1.5);
        let t51 = cos_rocker_pin_angle - t50;
        let t52 = t46 * t21;
        let t53 = t46 * t47;
        let t54 = cos_b_angle * sin_rocker_pin_angle;
        let t55 = sin_b_angle * t51;
        let t56 = t54 + t55;
        let t57 = sin_b_angle * sin_rocker_pin_angle;
        let t58 = cos_b_angle * t51;
        let t59 = t57 - t58;
        let t60 = c(0.6) * t59;
        let t61 = t60 * t5;
        let t62 = t31 * t31;
        let t63 = t5 * t62;
        let t64 = t49 + t63;
        let t65 = t60 * a_z0_force_x;
        let t66 = t56 - t65;
        let t67 = t60 * a_z0_force_y;
        let t68 = t59 - t67;
        let t69 = t60 * t32;
        let t70 = t52 - t69;
        let t71 = t60 * t61;
        let t72 = t53 + t71;
        let t73 = sin_a_angle * t66;
        let t74 = cos_a_angle * t68;
        let t75 = t73 + t74;
        let t76 = c(0.2) * t75;
        let t77 = t76 * t43;
        let t78 = t42 * t42;
        let t79 = t43 * t78;
        let t80 = t64 + t79;
        let t81 = t76 * t44;
        let t82 = t70 - t81;
        let t83 = t76 * t77;
        let t84 = t72 + t83;
        let t85 = ::mstmm::generated::recip_above(closure_d0, t80);
        let t86 = t82 * t85;
        let t87 = t82 * t86;
        let closure_d1 = t84 - t87;
        let t88 = t46 * t46;
        let t89 = c(4.166666666666667) * t88;
        let t90 = t60 * t60;
        let t91 = t5 * t90;
        let t92 = t89 + t91;
        let t93 = t76 * t76;
        let t94 = t43 * t93;
        let t95 = t92 + t94;
        let t96 = ::mstmm::generated::recip_above(closure_d1, t95);
        let t97 = closure_d0 * t85;
        let t98 = c(1.0) - t97;
        let t99 = t98 * t98;
        let t100 = ::mstmm::generated::recip_above(t99, c(1.0));
        let t101 = T::sqrt(t100);
        let t102 = t98 * t101;
        let t103 = closure_d1 * t96;
        let t104 = c(1.0) - t103;
        let t105 = t86 * t104;
        let t106 = t102 * t105;
        let t107 = t102 * t106;
        let t108 = t105 - t107;
        let t109 = t108 * t108;
        let t110 = t104 * t104;
        let t111 = t109 + t110;
        let t112 = ::mstmm::generated::recip_above(t111, c(1.0));
        let t113 = T::sqrt(t112);
        let t114 = t108 * t113;
        let t115 = t104 * t113;
        let t116 = cos_crank_pin_angle * cos_a_angle;
        let t117 = sin_crank_pin_angle * sin_a_angle;
        let t118 = t116 - t117;
        let t119 = cos_crank_pin_angle * sin_a_angle;
        let t120 = sin_crank_pin_angle * cos_a_angle;
        let t121 = t119 + t120;
        let t122 = cos_crank_pin_angle * c(0.2);
        let t123 = sin_crank_pin_angle * c(0.2);
        let t124 = c(0.6) * t118;
        let t125 = c(0.6) * t121;
        let t126 = cos_b_angle * t118;
        let t127 = sin_b_angle * t121;
        let t128 = t126 - t127;
        let t129 = sin_b_angle * t118;
        let t130 = cos_b_angle * t121;
        let t131 = t129 + t130;
        let t132 = c(0.6) * t128;
        let t133 = c(0.6) * t131;
        let t134 = t122 + t124;
        let t135 = t123 + t125;
        let t136 = cos_rocker_pin_angle * t128;
        let t137 = sin_rocker_pin_angle * t131;
        let t138 = t136 - t137;
        let t139 = sin_rocker_pin_angle * t128;
        let t140 = cos_rocker_pin_angle * t131;
        let t141 = t139 + t140;
        let t142 = t132 + t134;
        let t143 = t133 + t135;
        let t144 = c(0.8) - t142;
        let t145 = t138 * t144;
        let t146 = t141 * t143;
        let t147 = t145 - t146;
        let t148 = t141 * t144;
        let t149 = t138 * t143;
        let t150 = t148 + t149;
        let t151 = t86 * t147;
        let t152 = t150 + t151;
        let t153 = t85 * t147;
        let t154 = t96 * t152;
        let t155 = t86 * t154;
        let t156 = t153 + t155;
        let t157 = t102 * t156;
        let t158 = t102 * t157;
        let t159 = t156 - t158;
        let t160 = t114 * t159;
        let t161 = t115 * t154;
        let t162 = t160 + t161;
        let t163 = t114 * t162;
        let minus_closure_reaction0 = t159 - t163;
        let t164 = t115 * t162;
        let closure_reaction1 = t154 - t164;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 2 mul, 1 add, 0 reciprocal.
        let t165 = t44 * minus_closure_reaction0;
        let t166 = t77 * closure_reaction1;
        let crank_pin_a_ang_z = t165 + t166;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 7 mul, 3 add, 0 reciprocal.
        let t167 = c(0.2) * crank_pin_a_ang_z;
        let a_a_lin_x = sin_a_angle * t167;
        let a_a_lin_y = cos_a_angle * t167;
        let t168 = t32 * minus_closure_reaction0;
        let t169 = t61 * closure_reaction1;
        let t170 = t168 + t169;
        let t171 = a_z0_force_x * a_a_lin_x;
        let t172 = a_z0_force_y * a_a_lin_y;
        let t173 = t171 + t172;
        let a_a_ang_z = t170 - t173;
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 6 mul, 4 add, 0 reciprocal.
        let t174 = c(0.6) * a_a_ang_z;
        let t175 = a_a_lin_y + t174;
        let t176 = sin_b_angle * a_a_lin_x;
        let t177 = cos_b_angle * t175;
        let minus_b_a_lin_y = t176 - t177;
        let t178 = t21 * minus_closure_reaction0;
        let t179 = t47 * closure_reaction1;
        let t180 = t178 - t179;
        let t181 = c(2.5) * minus_b_a_lin_y;
        let b_a_ang_z = t180 + t181;
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 23 mul, 12 add, 0 reciprocal.
        let t182 = crank_pin_rate * c(0.2);
        let t183 = a_omega_z * c(0.6);
        let t184 = c(0.6) * b_omega_z;
        let t185 = sin_a_angle * t182;
        let t186 = cos_a_angle * t182;
        let t187 = t183 + t186;
        let t188 = cos_b_angle * t185;
        let t189 = sin_b_angle * t187;
        let t190 = t188 + t189;
        let t191 = sin_b_angle * t185;
        let t192 = cos_b_angle * t187;
        let t193 = t191 - t192;
        let t194 = t184 - t193;
        let t195 = cos_rocker_pin_angle * t190;
        let t196 = sin_rocker_pin_angle * t194;
        let t197 = t195 + t196;
        let t198 = sin_rocker_pin_angle * t190;
        let t199 = cos_rocker_pin_angle * t194;
        let t200 = t198 - t199;
        let t201 = t86 * t197;
        let t202 = t200 + t201;
        let t203 = t85 * t197;
        let t204 = t96 * t202;
        let t205 = t86 * t204;
        let t206 = t203 + t205;
        let t207 = t102 * t206;
        let t208 = t102 * t207;
        let t209 = t206 - t208;
        let t210 = t114 * t209;
        let t211 = t115 * t204;
        let t212 = t210 + t211;
        let t213 = t114 * t212;
        let closure_reaction0 = t209 - t213;
        let t214 = t115 * t212;
        let minus_closure_reaction1 = t204 - t214;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 2 mul, 1 add, 0 reciprocal.
        let t215 = t44 * closure_reaction0;
        let t216 = t77 * minus_closure_reaction1;
        let minus_crank_pin_a_ang_z = t215 + t216;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 7 mul, 3 add, 0 reciprocal.
        let t217 = c(0.2) * minus_crank_pin_a_ang_z;
        let minus_a_a_lin_x = sin_a_angle * t217;
        let minus_a_a_lin_y = cos_a_angle * t217;
        let t218 = t32 * closure_reaction0;
        let t219 = t61 * minus_closure_reaction1;
        let t220 = t218 + t219;
        let t221 = a_z0_force_x * minus_a_a_lin_x;
        let t222 = a_z0_force_y * minus_a_a_lin_y;
        let t223 = t221 + t222;
        let minus_a_a_ang_z = t220 - t223;
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 6 mul, 4 add, 0 reciprocal.
        let t224 = c(0.6) * minus_a_a_ang_z;
        let t225 = minus_a_a_lin_y + t224;
        let t226 = sin_b_angle * minus_a_a_lin_x;
        let t227 = cos_b_angle * t225;
        let b_a_lin_y = t226 - t227;
        let t228 = t21 * closure_reaction0;
        let t229 = t47 * minus_closure_reaction1;
        let t230 = t228 - t229;
        let t231 = c(2.5) * b_a_lin_y;
        let minus_b_a_ang_z = t230 + t231;
        /// Results: 6 mul, 20 add, 0 reciprocal, 1 square root.
        let t232 = crank_pin_angle + crank_pin_a_ang_z;
        let t233 = crank_pin_a_ang_z - a_a_ang_z;
        let t234 = a_angle - t233;
        let t235 = a_a_ang_z - b_a_ang_z;
        let t236 = b_angle - t235;
        let t237 = t141 + b_a_ang_z;
        let t238 = rocker_pin_angle - t237;
        let t239 = crank_pin_rate - minus_crank_pin_a_ang_z;
        let t240 = minus_crank_pin_a_ang_z - minus_a_a_ang_z;
        let t241 = a_rate + t240;
        let t242 = minus_a_a_ang_z - minus_b_a_ang_z;
        let t243 = b_rate + t242;
        let t244 = rocker_pin_rate + b_omega_z;
        let t245 = t244 - minus_b_a_ang_z;
        let t246 = rocker_pin_rate - t245;
        let t247 = t147 * t147;
        let t248 = t150 * t150;
        let t249 = t247 + t248;
        let t250 = t141 * t141;
        let t251 = t249 + t250;
        let t252 = t197 * t197;
        let t253 = t200 * t200;
        let t254 = t252 + t253;
        let t255 = t244 * t244;
        let t256 = t254 + t255;
        let t257 = t251 + t256;
        let t258 = T::sqrt(t257);
        let residual = t258;
        state.q.data.0 = [[t232, t234, t236, t238]];
        state.v.data.0 = [[t239, t241, t243, t246]];
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
