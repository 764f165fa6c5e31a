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
/// 4 rates, closed over 2 directions; accelerations by `riccati`, 326 operations (192 mul, 120 add, 8 reciprocal, 6 square root, 4 sin/cos); with everything at every connection point 489 operations.
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
    /// 326 operations: 192 mul, 120 add, 8 reciprocal, 6 square root, 4 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `b` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 15 | 9 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 23 | 16 | 1 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 124 | 70 | 6 | 6 | 0 |
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
        let t9 = c(0.36) * t7;
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
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 124 mul, 70 add, 6 reciprocal, 6 square root.
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
        let t78 = cos_rocker_pin_angle * cos_rocker_pin_angle;
        let t79 = sin_rocker_pin_angle * sin_rocker_pin_angle;
        let t80 = t78 + t79;
        let t81 = t51 * t51;
        let t82 = t80 * c(0.36);
        let t83 = t81 + t82;
        let t84 = t83 * c(4.166666666666667);
        let t85 = cos_rocker_pin_angle * c(1.5);
        let t86 = cos_rocker_pin_angle - t85;
        let t87 = t76 * t52;
        let t88 = t76 * t77;
        let t89 = cos_b_angle * sin_rocker_pin_angle;
        let t90 = sin_b_angle * t86;
        let t91 = t89 + t90;
        let t92 = sin_b_angle * sin_rocker_pin_angle;
        let t93 = cos_b_angle * t86;
        let t94 = t92 - t93;
        let t95 = c(0.6) * t94;
        let t96 = t95 * t18;
        let t97 = t58 * t58;
        let t98 = t61 * t61;
        let t99 = t97 + t98;
        let t100 = t62 * t62;
        let t101 = t99 * c(0.72);
        let t102 = t100 + t101;
        let t103 = t18 * t102;
        let t104 = t84 + t103;
        let t105 = t95 * a_z0_force_x;
        let t106 = t91 - t105;
        let t107 = t95 * a_z0_force_y;
        let t108 = t94 - t107;
        let t109 = t95 * t63;
        let t110 = t87 - t109;
        let t111 = t95 * t96;
        let t112 = t88 + t111;
        let t113 = cos_a_angle * t65;
        let t114 = sin_a_angle * t67;
        let t115 = t113 - t114;
        let t116 = sin_a_angle * t106;
        let t117 = cos_a_angle * t108;
        let t118 = t116 + t117;
        let t119 = c(0.2) * t118;
        let t120 = t119 * t50;
        let t121 = t115 * t115;
        let t122 = t72 * t72;
        let t123 = t121 + t122;
        let t124 = t73 * t73;
        let t125 = t123 * c(0.76);
        let t126 = t124 + t125;
        let t127 = t50 * t126;
        let t128 = t104 + t127;
        let t129 = t119 * t74;
        let t130 = t110 - t129;
        let t131 = t119 * t120;
        let t132 = t112 + t131;
        let t133 = T::copysign(closure_d0, c(1.0));
        let t134 = closure_d0 + t133;
        let t135 = c(0.5) * t134;
        let t136 = T::sqrt(t135);
        let t137 = T::sqrt(t128);
        let t138 = ::mstmm::generated::recip_above(t136, t137);
        let t139 = t136 * t138;
        let t140 = ::mstmm::generated::recip_above(closure_d0, closure_d0);
        let t141 = t139 * t140;
        let t142 = t130 * t141;
        let t143 = t130 * t142;
        let closure_d1 = t132 - t143;
        let t144 = cos_rocker_pin_angle * minus_b_e_force_x;
        let t145 = sin_rocker_pin_angle * minus_b_e_force_x;
        let t146 = t145 - c(9.8);
        let t147 = t76 * t76;
        let t148 = t82 + t147;
        let t149 = c(4.166666666666667) * t148;
        let t150 = minus_b_drift_lin_x * cos_rocker_pin_angle;
        let t151 = b_drift_lin_y * t54;
        let t152 = t150 - t151;
        let t153 = minus_b_drift_lin_x * sin_rocker_pin_angle;
        let t154 = b_drift_lin_y * t86;
        let t155 = t153 + t154;
        let t156 = t62 * t35;
        let t157 = t152 - t156;
        let t158 = t95 * t35;
        let t159 = t155 - t158;
        let t160 = t91 * t91;
        let t161 = t94 * t94;
        let t162 = t160 + t161;
        let t163 = t95 * t95;
        let t164 = c(0.72) * t162;
        let t165 = t163 + t164;
        let t166 = t18 * t165;
        let t167 = t149 + t166;
        let t168 = minus_a_drift_lin_x * t65;
        let t169 = a_drift_lin_y * t67;
        let t170 = t168 - t169;
        let t171 = t157 + t170;
        let t172 = minus_a_drift_lin_x * t106;
        let t173 = a_drift_lin_y * t108;
        let t174 = t172 - t173;
        let t175 = t159 + t174;
        let t176 = cos_a_angle * t106;
        let t177 = sin_a_angle * t108;
        let t178 = t176 - t177;
        let t179 = crank_pin_input0 + minus_crank_pin_e_moment_z;
        let t180 = t50 * t179;
        let t181 = t73 * minus_crank_pin_z0_force_x;
        let t182 = t115 + t181;
        let t183 = t73 * crank_pin_z0_force_y;
        let t184 = t72 - t183;
        let t185 = t73 * t180;
        let t186 = t171 - t185;
        let t187 = t119 * minus_crank_pin_z0_force_x;
        let t188 = t178 + t187;
        let t189 = t119 * crank_pin_z0_force_y;
        let t190 = t118 - t189;
        let t191 = t119 * t180;
        let t192 = t175 - t191;
        let t193 = t178 * t178;
        let t194 = t118 * t118;
        let t195 = t193 + t194;
        let t196 = t119 * t119;
        let t197 = c(0.76) * t195;
        let t198 = t196 + t197;
        let t199 = t50 * t198;
        let t200 = t167 + t199;
        let crank_pin_a_lin_x = sin_crank_pin_angle * c(9.8);
        let crank_pin_a_lin_y = cos_crank_pin_angle * c(9.8);
        let t201 = t182 * crank_pin_a_lin_x;
        let t202 = t184 * crank_pin_a_lin_y;
        let t203 = t201 + t202;
        let t204 = t186 - t203;
        let t205 = t188 * crank_pin_a_lin_x;
        let t206 = t190 * crank_pin_a_lin_y;
        let t207 = t205 + t206;
        let t208 = t192 - t207;
        let t209 = t144 + t204;
        let t210 = t146 + t208;
        let t211 = T::copysign(closure_d1, c(1.0));
        let t212 = closure_d1 + t211;
        let t213 = c(0.5) * t212;
        let t214 = T::sqrt(t213);
        let t215 = T::sqrt(t200);
        let t216 = ::mstmm::generated::recip_above(t214, t215);
        let t217 = t214 * t216;
        let t218 = ::mstmm::generated::recip_above(closure_d1, t132);
        let t219 = t217 * t218;
        let t220 = t209 * t142;
        let t221 = t210 + t220;
        let t222 = t209 * t141;
        let t223 = t219 * t221;
        let t224 = t142 * t223;
        let t225 = t222 + t224;
        let t226 = closure_d0 * t141;
        let t227 = c(1.0) - t226;
        let t228 = t227 * t227;
        let t229 = ::mstmm::generated::recip_above(t228, c(1.0));
        let t230 = T::sqrt(t229);
        let t231 = t227 * t230;
        let t232 = t225 * t231;
        let t233 = t231 * t232;
        let t234 = t225 - t233;
        let t235 = closure_d1 * t219;
        let t236 = c(1.0) - t235;
        let t237 = t142 * t236;
        let t238 = t231 * t237;
        let t239 = t231 * t238;
        let t240 = t237 - t239;
        let t241 = t240 * t240;
        let t242 = t236 * t236;
        let t243 = t241 + t242;
        let t244 = ::mstmm::generated::recip_above(t243, c(1.0));
        let t245 = T::sqrt(t244);
        let t246 = t240 * t245;
        let t247 = t236 * t245;
        let t248 = t234 * t246;
        let t249 = t223 * t247;
        let t250 = t248 + t249;
        let t251 = t246 * t250;
        let minus_closure_reaction0 = t234 - t251;
        let t252 = t247 * t250;
        let closure_reaction1 = t223 - t252;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 4 mul, 4 add, 0 reciprocal.
        let t253 = t74 * minus_closure_reaction0;
        let t254 = t120 * closure_reaction1;
        let t255 = t253 + t254;
        let t256 = t180 + t255;
        let t257 = minus_crank_pin_z0_force_x * crank_pin_a_lin_x;
        let t258 = crank_pin_z0_force_y * crank_pin_a_lin_y;
        let t259 = t257 - t258;
        let crank_pin_a_ang_z = t256 + t259;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 9 mul, 9 add, 0 reciprocal.
        let t260 = c(0.2) * crank_pin_a_ang_z;
        let t261 = crank_pin_a_lin_y + t260;
        let t262 = cos_a_angle * crank_pin_a_lin_x;
        let t263 = sin_a_angle * t261;
        let t264 = t262 + t263;
        let minus_a_a_lin_x = minus_a_drift_lin_x - t264;
        let t265 = sin_a_angle * crank_pin_a_lin_x;
        let t266 = cos_a_angle * t261;
        let t267 = t265 - t266;
        let a_a_lin_y = a_drift_lin_y - t267;
        let t268 = t63 * minus_closure_reaction0;
        let t269 = t96 * closure_reaction1;
        let t270 = t268 + t269;
        let t271 = t35 + t270;
        let t272 = a_z0_force_x * minus_a_a_lin_x;
        let t273 = a_z0_force_y * a_a_lin_y;
        let t274 = t272 - t273;
        let a_a_ang_z = t271 + t274;
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 6 mul, 5 add, 0 reciprocal.
        let t275 = c(0.6) * a_a_ang_z;
        let t276 = a_a_lin_y + t275;
        let t277 = sin_b_angle * minus_a_a_lin_x;
        let t278 = cos_b_angle * t276;
        let t279 = t277 + t278;
        let b_a_lin_y = b_drift_lin_y + t279;
        let t280 = t52 * minus_closure_reaction0;
        let t281 = t77 * closure_reaction1;
        let t282 = t280 - t281;
        let t283 = c(2.5) * b_a_lin_y;
        let b_a_ang_z = t282 - t283;
        /// Results: 1 mul, 5 add, 0 reciprocal.
        let t284 = crank_pin_a_ang_z - a_a_ang_z;
        let t285 = a_a_ang_z - b_a_ang_z;
        let t286 = t20 - t22;
        let t287 = c(4.0) - t286;
        let t288 = t287 * c(0.04000000000000001);
        let t289 = t288 + c(0.030000000000000006);
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
            [c(2.04), t289],
            [crank_pin_a_ang_z, -t284, -t285, -b_a_ang_z],
        )?;
        accelerations.data.0 = [[crank_pin_a_ang_z, -t284, -t285, -b_a_ang_z]];
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
    /// 489 operations: 291 mul, 184 add, 8 reciprocal, 6 square root, 4 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `b` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 15 | 9 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 23 | 16 | 1 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 124 | 70 | 6 | 6 | 0 |
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
        let t9 = c(0.36) * t7;
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
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 124 mul, 70 add, 6 reciprocal, 6 square root.
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
        let t78 = cos_rocker_pin_angle * cos_rocker_pin_angle;
        let t79 = sin_rocker_pin_angle * sin_rocker_pin_angle;
        let t80 = t78 + t79;
        let t81 = t51 * t51;
        let t82 = t80 * c(0.36);
        let t83 = t81 + t82;
        let t84 = t83 * c(4.166666666666667);
        let t85 = cos_rocker_pin_angle * c(1.5);
        let t86 = cos_rocker_pin_angle - t85;
        let t87 = t76 * t52;
        let t88 = t76 * t77;
        let t89 = cos_b_angle * sin_rocker_pin_angle;
        let t90 = sin_b_angle * t86;
        let t91 = t89 + t90;
        let t92 = sin_b_angle * sin_rocker_pin_angle;
        let t93 = cos_b_angle * t86;
        let t94 = t92 - t93;
        let t95 = c(0.6) * t94;
        let t96 = t95 * t18;
        let t97 = t58 * t58;
        let t98 = t61 * t61;
        let t99 = t97 + t98;
        let t100 = t62 * t62;
        let t101 = t99 * c(0.72);
        let t102 = t100 + t101;
        let t103 = t18 * t102;
        let t104 = t84 + t103;
        let t105 = t95 * a_z0_force_x;
        let t106 = t91 - t105;
        let t107 = t95 * a_z0_force_y;
        let t108 = t94 - t107;
        let t109 = t95 * t63;
        let t110 = t87 - t109;
        let t111 = t95 * t96;
        let t112 = t88 + t111;
        let t113 = cos_a_angle * t65;
        let t114 = sin_a_angle * t67;
        let t115 = t113 - t114;
        let t116 = sin_a_angle * t106;
        let t117 = cos_a_angle * t108;
        let t118 = t116 + t117;
        let t119 = c(0.2) * t118;
        let t120 = t119 * t50;
        let t121 = t115 * t115;
        let t122 = t72 * t72;
        let t123 = t121 + t122;
        let t124 = t73 * t73;
        let t125 = t123 * c(0.76);
        let t126 = t124 + t125;
        let t127 = t50 * t126;
        let t128 = t104 + t127;
        let t129 = t119 * t74;
        let t130 = t110 - t129;
        let t131 = t119 * t120;
        let t132 = t112 + t131;
        let t133 = T::copysign(closure_d0, c(1.0));
        let t134 = closure_d0 + t133;
        let t135 = c(0.5) * t134;
        let t136 = T::sqrt(t135);
        let t137 = T::sqrt(t128);
        let t138 = ::mstmm::generated::recip_above(t136, t137);
        let t139 = t136 * t138;
        let t140 = ::mstmm::generated::recip_above(closure_d0, closure_d0);
        let t141 = t139 * t140;
        let t142 = t130 * t141;
        let t143 = t130 * t142;
        let closure_d1 = t132 - t143;
        let t144 = cos_rocker_pin_angle * minus_b_e_force_x;
        let t145 = sin_rocker_pin_angle * minus_b_e_force_x;
        let t146 = t145 - c(9.8);
        let t147 = t76 * t76;
        let t148 = t82 + t147;
        let t149 = c(4.166666666666667) * t148;
        let t150 = minus_b_drift_lin_x * cos_rocker_pin_angle;
        let t151 = b_drift_lin_y * t54;
        let t152 = t150 - t151;
        let t153 = minus_b_drift_lin_x * sin_rocker_pin_angle;
        let t154 = b_drift_lin_y * t86;
        let t155 = t153 + t154;
        let t156 = t62 * t35;
        let t157 = t152 - t156;
        let t158 = t95 * t35;
        let t159 = t155 - t158;
        let t160 = t91 * t91;
        let t161 = t94 * t94;
        let t162 = t160 + t161;
        let t163 = t95 * t95;
        let t164 = c(0.72) * t162;
        let t165 = t163 + t164;
        let t166 = t18 * t165;
        let t167 = t149 + t166;
        let t168 = minus_a_drift_lin_x * t65;
        let t169 = a_drift_lin_y * t67;
        let t170 = t168 - t169;
        let t171 = t157 + t170;
        let t172 = minus_a_drift_lin_x * t106;
        let t173 = a_drift_lin_y * t108;
        let t174 = t172 - t173;
        let t175 = t159 + t174;
        let t176 = cos_a_angle * t106;
        let t177 = sin_a_angle * t108;
        let t178 = t176 - t177;
        let t179 = crank_pin_input0 + minus_crank_pin_e_moment_z;
        let t180 = t50 * t179;
        let t181 = t73 * minus_crank_pin_z0_force_x;
        let t182 = t115 + t181;
        let t183 = t73 * crank_pin_z0_force_y;
        let t184 = t72 - t183;
        let t185 = t73 * t180;
        let t186 = t171 - t185;
        let t187 = t119 * minus_crank_pin_z0_force_x;
        let t188 = t178 + t187;
        let t189 = t119 * crank_pin_z0_force_y;
        let t190 = t118 - t189;
        let t191 = t119 * t180;
        let t192 = t175 - t191;
        let t193 = t178 * t178;
        let t194 = t118 * t118;
        let t195 = t193 + t194;
        let t196 = t119 * t119;
        let t197 = c(0.76) * t195;
        let t198 = t196 + t197;
        let t199 = t50 * t198;
        let t200 = t167 + t199;
        let crank_pin_a_lin_x = sin_crank_pin_angle * c(9.8);
        let crank_pin_a_lin_y = cos_crank_pin_angle * c(9.8);
        let t201 = t182 * crank_pin_a_lin_x;
        let t202 = t184 * crank_pin_a_lin_y;
        let t203 = t201 + t202;
        let t204 = t186 - t203;
        let t205 = t188 * crank_pin_a_lin_x;
        let t206 = t190 * crank_pin_a_lin_y;
        let t207 = t205 + t206;
        let t208 = t192 - t207;
        let t209 = t144 + t204;
        let t210 = t146 + t208;
        let t211 = T::copysign(closure_d1, c(1.0));
        let t212 = closure_d1 + t211;
        let t213 = c(0.5) * t212;
        let t214 = T::sqrt(t213);
        let t215 = T::sqrt(t200);
        let t216 = ::mstmm::generated::recip_above(t214, t215);
        let t217 = t214 * t216;
        let t218 = ::mstmm::generated::recip_above(closure_d1, t132);
        let t219 = t217 * t218;
        let t220 = t209 * t142;
        let t221 = t210 + t220;
        let t222 = t209 * t141;
        let t223 = t219 * t221;
        let t224 = t142 * t223;
        let t225 = t222 + t224;
        let t226 = closure_d0 * t141;
        let t227 = c(1.0) - t226;
        let t228 = t227 * t227;
        let t229 = ::mstmm::generated::recip_above(t228, c(1.0));
        let t230 = T::sqrt(t229);
        let t231 = t227 * t230;
        let t232 = t225 * t231;
        let t233 = t231 * t232;
        let t234 = t225 - t233;
        let t235 = closure_d1 * t219;
        let t236 = c(1.0) - t235;
        let t237 = t142 * t236;
        let t238 = t231 * t237;
        let t239 = t231 * t238;
        let t240 = t237 - t239;
        let t241 = t240 * t240;
        let t242 = t236 * t236;
        let t243 = t241 + t242;
        let t244 = ::mstmm::generated::recip_above(t243, c(1.0));
        let t245 = T::sqrt(t244);
        let t246 = t240 * t245;
        let t247 = t236 * t245;
        let t248 = t234 * t246;
        let t249 = t223 * t247;
        let t250 = t248 + t249;
        let t251 = t246 * t250;
        let minus_closure_reaction0 = t234 - t251;
        let t252 = t247 * t250;
        let closure_reaction1 = t223 - t252;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 4 mul, 4 add, 0 reciprocal.
        let t253 = t74 * minus_closure_reaction0;
        let t254 = t120 * closure_reaction1;
        let t255 = t253 + t254;
        let t256 = t180 + t255;
        let t257 = minus_crank_pin_z0_force_x * crank_pin_a_lin_x;
        let t258 = crank_pin_z0_force_y * crank_pin_a_lin_y;
        let t259 = t257 - t258;
        let crank_pin_a_ang_z = t256 + t259;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 9 mul, 9 add, 0 reciprocal.
        let t260 = c(0.2) * crank_pin_a_ang_z;
        let t261 = crank_pin_a_lin_y + t260;
        let t262 = cos_a_angle * crank_pin_a_lin_x;
        let t263 = sin_a_angle * t261;
        let t264 = t262 + t263;
        let minus_a_a_lin_x = minus_a_drift_lin_x - t264;
        let t265 = sin_a_angle * crank_pin_a_lin_x;
        let t266 = cos_a_angle * t261;
        let t267 = t265 - t266;
        let a_a_lin_y = a_drift_lin_y - t267;
        let t268 = t63 * minus_closure_reaction0;
        let t269 = t96 * closure_reaction1;
        let t270 = t268 + t269;
        let t271 = t35 + t270;
        let t272 = a_z0_force_x * minus_a_a_lin_x;
        let t273 = a_z0_force_y * a_a_lin_y;
        let t274 = t272 - t273;
        let a_a_ang_z = t271 + t274;
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 8 mul, 7 add, 0 reciprocal.
        let t275 = c(0.6) * a_a_ang_z;
        let t276 = a_a_lin_y + t275;
        let t277 = cos_b_angle * minus_a_a_lin_x;
        let t278 = sin_b_angle * t276;
        let t279 = t277 - t278;
        let minus_b_a_lin_x = minus_b_drift_lin_x + t279;
        let t280 = sin_b_angle * minus_a_a_lin_x;
        let t281 = cos_b_angle * t276;
        let t282 = t280 + t281;
        let b_a_lin_y = b_drift_lin_y + t282;
        let t283 = t52 * minus_closure_reaction0;
        let t284 = t77 * closure_reaction1;
        let t285 = t283 - t284;
        let t286 = c(2.5) * b_a_lin_y;
        let b_a_ang_z = t285 - t286;
        /// Motion across `a`, [P, Eqs. (1), (13), (36)]: 10 mul, 2 add, 0 reciprocal.
        let t287 = cos_crank_pin_angle * cos_a_angle;
        let t288 = sin_crank_pin_angle * sin_a_angle;
        let a_axes_x_x = t287 - t288;
        let t289 = cos_crank_pin_angle * sin_a_angle;
        let t290 = sin_crank_pin_angle * cos_a_angle;
        let minus_a_axes_x_y = t289 + t290;
        let t291 = cos_crank_pin_angle * c(0.2);
        let t292 = crank_pin_rate * t291;
        let minus_a_drift_lin_x_2 = crank_pin_rate * t292;
        let t293 = sin_crank_pin_angle * c(0.2);
        let t294 = crank_pin_rate * t293;
        let minus_a_drift_lin_y = crank_pin_rate * t294;
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 10 mul, 2 add, 0 reciprocal.
        let t295 = cos_b_angle * a_axes_x_x;
        let t296 = sin_b_angle * minus_a_axes_x_y;
        let b_axes_x_x = t295 - t296;
        let t297 = sin_b_angle * a_axes_x_x;
        let t298 = cos_b_angle * minus_a_axes_x_y;
        let minus_b_axes_x_y = t297 + t298;
        let t299 = c(0.6) * a_axes_x_x;
        let t300 = a_omega_z * t299;
        let minus_b_drift_lin_x_2 = a_omega_z * t300;
        let t301 = c(0.6) * minus_a_axes_x_y;
        let t302 = a_omega_z * t301;
        let minus_b_drift_lin_y = a_omega_z * t302;
        /// Point of `a`, [P, Eqs. (12), (13), (36)]: 2 mul, 2 add, 0 reciprocal.
        let t303 = crank_pin_a_ang_z * t293;
        let minus_a_acc_lin_x = minus_a_drift_lin_x_2 + t303;
        let t304 = crank_pin_a_ang_z * t291;
        let minus_a_acc_lin_y = minus_a_drift_lin_y - t304;
        /// Point of `b`, [P, Eqs. (12), (13), (36)]: 2 mul, 4 add, 0 reciprocal.
        let t305 = a_a_ang_z * t301;
        let t306 = minus_a_acc_lin_x + t305;
        let minus_b_acc_lin_x = minus_b_drift_lin_x_2 + t306;
        let t307 = a_a_ang_z * t299;
        let t308 = minus_a_acc_lin_y - t307;
        let minus_b_acc_lin_y = minus_b_drift_lin_y + t308;
        /// Load of the body at `crank_pin`, [P, Eqs. (18), (19)]: 7 mul, 4 add, 0 reciprocal.
        let t309 = crank_pin_rate * c(0.1);
        let t310 = crank_pin_rate * t309;
        let t311 = c(0.1) * crank_pin_a_ang_z;
        let t312 = crank_pin_a_lin_y + t311;
        let t313 = t310 - crank_pin_a_lin_x;
        let t314 = cos_crank_pin_angle * t313;
        let t315 = sin_crank_pin_angle * t312;
        let minus_crank_pin_own_force_x = t314 + t315;
        let t316 = sin_crank_pin_angle * t313;
        let t317 = cos_crank_pin_angle * t312;
        let minus_crank_pin_own_force_y = t316 - t317;
        /// Load of the body at `a`, [P, Eqs. (18), (19)]: 6 mul, 4 add, 0 reciprocal.
        let t318 = c(2.0) * minus_a_a_lin_x;
        let t319 = c(2.0) * a_a_lin_y;
        let t320 = t275 + t319;
        let t321 = t3 + t318;
        let t322 = a_axes_x_x * t321;
        let t323 = minus_a_axes_x_y * t320;
        let minus_a_own_force_x = t322 + t323;
        let t324 = minus_a_axes_x_y * t321;
        let t325 = a_axes_x_x * t320;
        let minus_a_own_force_y = t324 - t325;
        /// Load of the body at `b`, [P, Eqs. (18), (19)]: 7 mul, 4 add, 0 reciprocal.
        let t326 = c(0.6) * b_a_ang_z;
        let t327 = c(2.0) * minus_b_a_lin_x;
        let t328 = c(2.0) * b_a_lin_y;
        let t329 = t326 + t328;
        let t330 = minus_b_e_force_x + t327;
        let t331 = b_axes_x_x * t330;
        let t332 = minus_b_axes_x_y * t329;
        let minus_b_own_force_x = t331 + t332;
        let t333 = minus_b_axes_x_y * t330;
        let t334 = b_axes_x_x * t329;
        let minus_b_own_force_y = t333 - t334;
        /// Load on `rocker_pin`, [P, Eqs. (18), (19)]: 8 mul, 4 add, 0 reciprocal.
        let t335 = cos_rocker_pin_angle * minus_closure_reaction0;
        let t336 = sin_rocker_pin_angle * closure_reaction1;
        let t337 = t335 + t336;
        let t338 = sin_rocker_pin_angle * minus_closure_reaction0;
        let t339 = cos_rocker_pin_angle * closure_reaction1;
        let t340 = t338 - t339;
        let t341 = t337 * b_axes_x_x;
        let t342 = t340 * minus_b_axes_x_y;
        let minus_rocker_pin_load_force_x = t341 - t342;
        let t343 = t337 * minus_b_axes_x_y;
        let t344 = t340 * b_axes_x_x;
        let minus_rocker_pin_load_force_y = t343 + t344;
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
        let t345 = crank_pin_a_ang_z - a_a_ang_z;
        let t346 = a_a_ang_z - b_a_ang_z;
        let t347 = t20 - t22;
        let t348 = c(4.0) - t347;
        let t349 = t348 * c(0.04000000000000001);
        let t350 = t349 + c(0.030000000000000006);
        let t351 = cos_crank_pin_angle * c(0.1);
        let t352 = sin_crank_pin_angle * c(0.1);
        let t353 = t294 + t302;
        let t354 = t292 + t300;
        let t355 = crank_pin_rate * t352;
        let t356 = crank_pin_rate * t351;
        let t357 = crank_pin_rate * c(0.01);
        let t358 = crank_pin_rate * t357;
        let t359 = t355 * t355;
        let t360 = t356 * t356;
        let t361 = t359 + t360;
        let t362 = t358 + t361;
        let t363 = a_axes_x_x * c(0.3);
        let t364 = minus_a_axes_x_y * c(0.3);
        let t365 = a_omega_z * t364;
        let t366 = a_omega_z * t363;
        let t367 = t294 + t365;
        let t368 = t292 + t366;
        let t369 = a_omega_z * c(0.06);
        let t370 = a_omega_z * t369;
        let t371 = t367 * t367;
        let t372 = t368 * t368;
        let t373 = t371 + t372;
        let t374 = c(2.0) * t373;
        let t375 = t370 + t374;
        let t376 = b_axes_x_x * c(0.3);
        let t377 = minus_b_axes_x_y * c(0.3);
        let t378 = b_omega_z * t377;
        let t379 = b_omega_z * t376;
        let t380 = t353 + t378;
        let t381 = t354 + t379;
        let t382 = b_omega_z * c(0.06);
        let t383 = b_omega_z * t382;
        let t384 = t380 * t380;
        let t385 = t381 * t381;
        let t386 = t384 + t385;
        let t387 = c(2.0) * t386;
        let t388 = t383 + t387;
        let t389 = c(0.5) * t388;
        let t390 = t362 + t375;
        let t391 = c(0.5) * t390;
        let t392 = t389 + t391;
        let t393 = t293 + t301;
        let t394 = sin_crank_pin_angle * c(0.9800000000000001);
        let t395 = t293 + t364;
        let t396 = t395 * c(19.6);
        let t397 = t394 + t396;
        let t398 = t393 + t377;
        let t399 = c(19.6) * t398;
        let t400 = t397 + t399;
        let t401 = cos_rocker_pin_angle * t231;
        let t402 = sin_rocker_pin_angle * t231;
        let t403 = cos_rocker_pin_angle * t246;
        let t404 = sin_rocker_pin_angle * t247;
        let t405 = t403 + t404;
        let t406 = sin_rocker_pin_angle * t246;
        let t407 = cos_rocker_pin_angle * t247;
        let t408 = t406 - t407;
        let t409 = t291 + t299;
        let t410 = c(0.6) * b_axes_x_x;
        let t411 = t410 + t409;
        let t412 = c(0.6) * minus_b_axes_x_y;
        let t413 = t412 + t393;
        let t414 = b_omega_z * t412;
        let t415 = t353 + t414;
        let t416 = b_omega_z * t410;
        let t417 = t354 + t416;
        let t418 = b_omega_z * t416;
        let t419 = b_a_ang_z * t412;
        let t420 = minus_b_acc_lin_x + t419;
        let t421 = t418 + t420;
        let t422 = b_omega_z * t414;
        let t423 = b_a_ang_z * t410;
        let t424 = minus_b_acc_lin_y - t423;
        let t425 = t422 + t424;
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
            [c(2.04), t350],
            [crank_pin_a_ang_z, -t345, -t346, -b_a_ang_z],
        )?;
        at.accelerations.data.0 = [[crank_pin_a_ang_z, -t345, -t346, -b_a_ang_z]];
        at.rate_accelerations.data.0 = [[crank_pin_a_ang_z, -t345, -t346, -b_a_ang_z]];
        at.efforts.data.0 = [[crank_pin_input0, c(0.0), c(0.0), c(0.0)]];
        at.closure = ::mstmm::generated::closure([
            [t401, t402, c(0.0), c(0.0), c(0.0), c(0.0)],
            [-t405, -t408, c(0.0), c(0.0), c(0.0), c(0.0)],
        ]);
        at.kinetic_energy = t392;
        at.potential_energy = t400;
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
                [t291, t293],
                [cos_crank_pin_angle, sin_crank_pin_angle],
                [-t294, t292],
                crank_pin_rate,
                ::mstmm::PlaneStateVector::new(
                    [-minus_a_acc_lin_x, -minus_a_acc_lin_y],
                    crank_pin_a_ang_z,
                    c(0.0),
                    [-minus_a_load_force_x, -minus_a_load_force_y],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t291, t293],
                [a_axes_x_x, minus_a_axes_x_y],
                [-t294, t292],
                a_omega_z,
                ::mstmm::PlaneStateVector::new(
                    [-minus_a_acc_lin_x, -minus_a_acc_lin_y],
                    a_a_ang_z,
                    c(0.0),
                    [-minus_a_load_force_x, -minus_a_load_force_y],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t409, t393],
                [a_axes_x_x, minus_a_axes_x_y],
                [-t353, t354],
                a_omega_z,
                ::mstmm::PlaneStateVector::new(
                    [-minus_b_acc_lin_x, -minus_b_acc_lin_y],
                    a_a_ang_z,
                    c(0.0),
                    [-minus_b_load_force_x, -minus_b_load_force_y],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t409, t393],
                [b_axes_x_x, minus_b_axes_x_y],
                [-t353, t354],
                b_omega_z,
                ::mstmm::PlaneStateVector::new(
                    [-minus_b_acc_lin_x, -minus_b_acc_lin_y],
                    b_a_ang_z,
                    c(0.0),
                    [-minus_b_load_force_x, -minus_b_load_force_y],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t411, t413],
                [b_axes_x_x, minus_b_axes_x_y],
                [-t415, t417],
                b_omega_z,
                ::mstmm::PlaneStateVector::new(
                    [-t421, -t425],
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
    /// 343 operations: 200 mul, 126 add, 9 reciprocal, 8 square root, 5 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 8 | 5 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 8 | 7 | 0 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 121 | 61 | 7 | 6 | 0 |
    /// | Acceleration of `crank_pin` | \[P, Eqs. (13), (36), (44)\] | 2 | 1 | 0 | 0 | 0 |
    /// | Acceleration of `a` | \[P, Eqs. (13), (36), (44)\] | 7 | 3 | 0 | 0 | 0 |
    /// | Acceleration of `b` | \[P, Eqs. (13), (36), (44)\] | 6 | 4 | 0 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 23 | 12 | 0 | 0 | 0 |
    /// | Acceleration of `crank_pin` | \[P, Eqs. (13), (36), (44)\] | 2 | 1 | 0 | 0 | 0 |
    /// | Acceleration of `a` | \[P, Eqs. (13), (36), (44)\] | 7 | 3 | 0 | 0 | 0 |
    /// | Acceleration of `b` | \[P, Eqs. (13), (36), (44)\] | 6 | 4 | 0 | 0 | 0 |
    /// | Results |  | 10 | 23 | 1 | 2 | 1 |
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
        let t4 = c(0.36) * t2;
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
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 121 mul, 61 add, 7 reciprocal, 6 square root.
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
        let t48 = cos_rocker_pin_angle * cos_rocker_pin_angle;
        let t49 = sin_rocker_pin_angle * sin_rocker_pin_angle;
        let t50 = t48 + t49;
        let t51 = t20 * t20;
        let t52 = t50 * c(0.36);
        let t53 = t51 + t52;
        let t54 = t53 * c(4.166666666666667);
        let t55 = cos_rocker_pin_angle * c(1.5);
        let t56 = cos_rocker_pin_angle - t55;
        let t57 = t46 * t21;
        let t58 = t46 * t47;
        let t59 = cos_b_angle * sin_rocker_pin_angle;
        let t60 = sin_b_angle * t56;
        let t61 = t59 + t60;
        let t62 = sin_b_angle * sin_rocker_pin_angle;
        let t63 = cos_b_angle * t56;
        let t64 = t62 - t63;
        let t65 = c(0.6) * t64;
        let t66 = t65 * t5;
        let t67 = t27 * t27;
        let t68 = t30 * t30;
        let t69 = t67 + t68;
        let t70 = t31 * t31;
        let t71 = t69 * c(0.72);
        let t72 = t70 + t71;
        let t73 = t5 * t72;
        let t74 = t54 + t73;
        let t75 = t65 * a_z0_force_x;
        let t76 = t61 - t75;
        let t77 = t65 * a_z0_force_y;
        let t78 = t64 - t77;
        let t79 = t65 * t32;
        let t80 = t57 - t79;
        let t81 = t65 * t66;
        let t82 = t58 + t81;
        let t83 = cos_a_angle * t34;
        let t84 = sin_a_angle * t36;
        let t85 = t83 - t84;
        let t86 = sin_a_angle * t76;
        let t87 = cos_a_angle * t78;
        let t88 = t86 + t87;
        let t89 = c(0.2) * t88;
        let t90 = t89 * t43;
        let t91 = t85 * t85;
        let t92 = t41 * t41;
        let t93 = t91 + t92;
        let t94 = t42 * t42;
        let t95 = t93 * c(0.76);
        let t96 = t94 + t95;
        let t97 = t43 * t96;
        let t98 = t74 + t97;
        let t99 = t89 * t44;
        let t100 = t80 - t99;
        let t101 = t89 * t90;
        let t102 = t82 + t101;
        let t103 = T::copysign(closure_d0, c(1.0));
        let t104 = closure_d0 + t103;
        let t105 = c(0.5) * t104;
        let t106 = T::sqrt(t105);
        let t107 = T::sqrt(t98);
        let t108 = ::mstmm::generated::recip_above(t106, t107);
        let t109 = t106 * t108;
        let t110 = ::mstmm::generated::recip_above(closure_d0, closure_d0);
        let t111 = t109 * t110;
        let t112 = t100 * t111;
        let t113 = t100 * t112;
        let closure_d1 = t102 - t113;
        let t114 = t46 * t46;
        let t115 = t52 + t114;
        let t116 = c(4.166666666666667) * t115;
        let t117 = t61 * t61;
        let t118 = t64 * t64;
        let t119 = t117 + t118;
        let t120 = t65 * t65;
        let t121 = c(0.72) * t119;
        let t122 = t120 + t121;
        let t123 = t5 * t122;
        let t124 = t116 + t123;
        let t125 = cos_a_angle * t76;
        let t126 = sin_a_angle * t78;
        let t127 = t125 - t126;
        let t128 = t127 * t127;
        let t129 = t88 * t88;
        let t130 = t128 + t129;
        let t131 = t89 * t89;
        let t132 = c(0.76) * t130;
        let t133 = t131 + t132;
        let t134 = t43 * t133;
        let t135 = t124 + t134;
        let t136 = T::copysign(closure_d1, c(1.0));
        let t137 = closure_d1 + t136;
        let t138 = c(0.5) * t137;
        let t139 = T::sqrt(t138);
        let t140 = T::sqrt(t135);
        let t141 = ::mstmm::generated::recip_above(t139, t140);
        let t142 = t139 * t141;
        let t143 = ::mstmm::generated::recip_above(closure_d1, t102);
        let t144 = t142 * t143;
        let t145 = closure_d0 * t111;
        let t146 = c(1.0) - t145;
        let t147 = t146 * t146;
        let t148 = ::mstmm::generated::recip_above(t147, c(1.0));
        let t149 = T::sqrt(t148);
        let t150 = t146 * t149;
        let t151 = closure_d1 * t144;
        let t152 = c(1.0) - t151;
        let t153 = t112 * t152;
        let t154 = t150 * t153;
        let t155 = t150 * t154;
        let t156 = t153 - t155;
        let t157 = t156 * t156;
        let t158 = t152 * t152;
        let t159 = t157 + t158;
        let t160 = ::mstmm::generated::recip_above(t159, c(1.0));
        let t161 = T::sqrt(t160);
        let t162 = t156 * t161;
        let t163 = t152 * t161;
        let t164 = cos_crank_pin_angle * cos_a_angle;
        let t165 = sin_crank_pin_angle * sin_a_angle;
        let t166 = t164 - t165;
        let t167 = cos_crank_pin_angle * sin_a_angle;
        let t168 = sin_crank_pin_angle * cos_a_angle;
        let t169 = t167 + t168;
        let t170 = cos_crank_pin_angle * c(0.2);
        let t171 = sin_crank_pin_angle * c(0.2);
        let t172 = c(0.6) * t166;
        let t173 = c(0.6) * t169;
        let t174 = cos_b_angle * t166;
        let t175 = sin_b_angle * t169;
        let t176 = t174 - t175;
        let t177 = sin_b_angle * t166;
        let t178 = cos_b_angle * t169;
        let t179 = t177 + t178;
        let t180 = c(0.6) * t176;
        let t181 = c(0.6) * t179;
        let t182 = t170 + t172;
        let t183 = t171 + t173;
        let t184 = cos_rocker_pin_angle * t176;
        let t185 = sin_rocker_pin_angle * t179;
        let t186 = t184 - t185;
        let t187 = sin_rocker_pin_angle * t176;
        let t188 = cos_rocker_pin_angle * t179;
        let t189 = t187 + t188;
        let t190 = t180 + t182;
        let t191 = t181 + t183;
        let t192 = c(0.8) - t190;
        let t193 = t186 * t192;
        let t194 = t189 * t191;
        let t195 = t193 - t194;
        let t196 = t189 * t192;
        let t197 = t186 * t191;
        let t198 = t196 + t197;
        let t199 = t112 * t195;
        let t200 = t198 + t199;
        let t201 = t111 * t195;
        let t202 = t144 * t200;
        let t203 = t112 * t202;
        let t204 = t201 + t203;
        let t205 = t150 * t204;
        let t206 = t150 * t205;
        let t207 = t204 - t206;
        let t208 = t162 * t207;
        let t209 = t163 * t202;
        let t210 = t208 + t209;
        let t211 = t162 * t210;
        let minus_closure_reaction0 = t207 - t211;
        let t212 = t163 * t210;
        let closure_reaction1 = t202 - t212;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 2 mul, 1 add, 0 reciprocal.
        let t213 = t44 * minus_closure_reaction0;
        let t214 = t90 * closure_reaction1;
        let crank_pin_a_ang_z = t213 + t214;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 7 mul, 3 add, 0 reciprocal.
        let t215 = c(0.2) * crank_pin_a_ang_z;
        let a_a_lin_x = sin_a_angle * t215;
        let a_a_lin_y = cos_a_angle * t215;
        let t216 = t32 * minus_closure_reaction0;
        let t217 = t66 * closure_reaction1;
        let t218 = t216 + t217;
        let t219 = a_z0_force_x * a_a_lin_x;
        let t220 = a_z0_force_y * a_a_lin_y;
        let t221 = t219 + t220;
        let a_a_ang_z = t218 - t221;
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 6 mul, 4 add, 0 reciprocal.
        let t222 = c(0.6) * a_a_ang_z;
        let t223 = a_a_lin_y + t222;
        let t224 = sin_b_angle * a_a_lin_x;
        let t225 = cos_b_angle * t223;
        let minus_b_a_lin_y = t224 - t225;
        let t226 = t21 * minus_closure_reaction0;
        let t227 = t47 * closure_reaction1;
        let t228 = t226 - t227;
        let t229 = c(2.5) * minus_b_a_lin_y;
        let b_a_ang_z = t228 + t229;
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 23 mul, 12 add, 0 reciprocal.
        let t230 = crank_pin_rate * c(0.2);
        let t231 = a_omega_z * c(0.6);
        let t232 = c(0.6) * b_omega_z;
        let t233 = sin_a_angle * t230;
        let t234 = cos_a_angle * t230;
        let t235 = t231 + t234;
        let t236 = cos_b_angle * t233;
        let t237 = sin_b_angle * t235;
        let t238 = t236 + t237;
        let t239 = sin_b_angle * t233;
        let t240 = cos_b_angle * t235;
        let t241 = t239 - t240;
        let t242 = t232 - t241;
        let t243 = cos_rocker_pin_angle * t238;
        let t244 = sin_rocker_pin_angle * t242;
        let t245 = t243 + t244;
        let t246 = sin_rocker_pin_angle * t238;
        let t247 = cos_rocker_pin_angle * t242;
        let t248 = t246 - t247;
        let t249 = t112 * t245;
        let t250 = t248 + t249;
        let t251 = t111 * t245;
        let t252 = t144 * t250;
        let t253 = t112 * t252;
        let t254 = t251 + t253;
        let t255 = t150 * t254;
        let t256 = t150 * t255;
        let t257 = t254 - t256;
        let t258 = t162 * t257;
        let t259 = t163 * t252;
        let t260 = t258 + t259;
        let t261 = t162 * t260;
        let closure_reaction0 = t257 - t261;
        let t262 = t163 * t260;
        let minus_closure_reaction1 = t252 - t262;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 2 mul, 1 add, 0 reciprocal.
        let t263 = t44 * closure_reaction0;
        let t264 = t90 * minus_closure_reaction1;
        let minus_crank_pin_a_ang_z = t263 + t264;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 7 mul, 3 add, 0 reciprocal.
        let t265 = c(0.2) * minus_crank_pin_a_ang_z;
        let minus_a_a_lin_x = sin_a_angle * t265;
        let minus_a_a_lin_y = cos_a_angle * t265;
        let t266 = t32 * closure_reaction0;
        let t267 = t66 * minus_closure_reaction1;
        let t268 = t266 + t267;
        let t269 = a_z0_force_x * minus_a_a_lin_x;
        let t270 = a_z0_force_y * minus_a_a_lin_y;
        let t271 = t269 + t270;
        let minus_a_a_ang_z = t268 - t271;
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 6 mul, 4 add, 0 reciprocal.
        let t272 = c(0.6) * minus_a_a_ang_z;
        let t273 = minus_a_a_lin_y + t272;
        let t274 = sin_b_angle * minus_a_a_lin_x;
        let t275 = cos_b_angle * t273;
        let b_a_lin_y = t274 - t275;
        let t276 = t21 * closure_reaction0;
        let t277 = t47 * minus_closure_reaction1;
        let t278 = t276 - t277;
        let t279 = c(2.5) * b_a_lin_y;
        let minus_b_a_ang_z = t278 + t279;
        /// Results: 10 mul, 23 add, 1 reciprocal, 2 square root, 1 sin/cos.
        let t280 = crank_pin_angle + crank_pin_a_ang_z;
        let t281 = crank_pin_a_ang_z - a_a_ang_z;
        let t282 = a_angle - t281;
        let t283 = a_a_ang_z - b_a_ang_z;
        let t284 = b_angle - t283;
        let t285 = t189 * t189;
        let t286 = t285 + c(0.000000000000000000000000000001);
        let t287 = T::sqrt(t286);
        let t288 = T::atan2(t287, t186);
        let t289 = T::recip(t287);
        let t290 = t288 * t289;
        let t291 = t189 * t290;
        let t292 = t291 + b_a_ang_z;
        let t293 = rocker_pin_angle - t292;
        let t294 = crank_pin_rate - minus_crank_pin_a_ang_z;
        let t295 = minus_crank_pin_a_ang_z - minus_a_a_ang_z;
        let t296 = a_rate + t295;
        let t297 = minus_a_a_ang_z - minus_b_a_ang_z;
        let t298 = b_rate + t297;
        let t299 = rocker_pin_rate + b_omega_z;
        let t300 = t299 - minus_b_a_ang_z;
        let t301 = rocker_pin_rate - t300;
        let t302 = t195 * t195;
        let t303 = t198 * t198;
        let t304 = t302 + t303;
        let t305 = t291 * t291;
        let t306 = t304 + t305;
        let t307 = c(1.0) - t186;
        let t308 = t307 * t307;
        let t309 = t306 + t308;
        let t310 = t245 * t245;
        let t311 = t248 * t248;
        let t312 = t310 + t311;
        let t313 = t299 * t299;
        let t314 = t312 + t313;
        let t315 = t309 + t314;
        let t316 = T::sqrt(t315);
        let residual = t316;
        state.q.data.0 = [[t280, t282, t284, t293]];
        state.v.data.0 = [[t294, t296, t298, t301]];
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
