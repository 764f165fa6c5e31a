/// A crank, a coupler and a rocker between two points of the ground.
///
/// # The chain
///
/// `ground -> pin crank_pin -> crank -> pin a -> coupler -> pin b -> rocker -> pin rocker_pin -> ground`
///
/// <svg role="img" aria-label="The chain at its start" viewBox="0 0 472 239" width="472" style="max-width:100%;height:auto" font-size="12" stroke-linecap="round" fill="currentColor">
/// <path d="M22 217l14.0 0.0" stroke="currentColor" opacity="0.6"/><text x="43.0" y="219.6" font-size="10" opacity="0.6" text-anchor="middle">x</text>
/// <path d="M22 217l0.0 -14.0" stroke="currentColor" opacity="0.6"/><text x="22.0" y="198.6" font-size="10" opacity="0.6" text-anchor="middle">y</text>
/// <path d="M105.3 202.6L36.0 157.5" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M105.3 202.6L70.6 180.0L36.0 157.5" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="70.6" cy="180.0" r="3" fill="#3a87c8"/>
/// <path d="M36.0 157.5L252.2 36.0" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M36.0 157.5L144.1 96.7L252.2 36.0" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="144.1" cy="96.7" r="3" fill="#3a87c8"/>
/// <path d="M252.2 36.0L436.0 202.6" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M252.2 36.0L344.1 119.3L436.0 202.6" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="344.1" cy="119.3" r="3" fill="#3a87c8"/>
/// <path d="M91.3 211.6h28m-26 7l5 -7m2 7l5 -7m2 7l5 -7" fill="none" stroke="currentColor"/>
/// <path d="M422.0 211.6h28m-26 7l5 -7m2 7l5 -7m2 7l5 -7" fill="none" stroke="currentColor"/>
/// <circle cx="105.3" cy="202.6" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <circle cx="36.0" cy="157.5" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <circle cx="252.2" cy="36.0" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <path d="M436.0 202.6L436.0 202.6" stroke="currentColor" stroke-dasharray="4 3"/><circle cx="436.0" cy="202.6" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <text x="113.3" y="194.6">crank_pin</text>
/// <text x="70.6" y="200.0" text-anchor="middle" font-style="italic">crank</text>
/// <text x="44.0" y="149.5">a</text>
/// <text x="144.1" y="116.7" text-anchor="middle" font-style="italic">coupler</text>
/// <text x="260.2" y="28.0">b</text>
/// <text x="344.1" y="139.3" text-anchor="middle" font-style="italic">rocker</text>
/// <text x="444.0" y="194.6">rocker_pin</text>
/// </svg>
///
/// | element | what it is | freedoms |
/// |---|---|---|
/// | `crank_pin` | pin(z) | 1 |
/// | `crank` | body `Crank`, 1 kg |  |
/// | `a` | pin(z) | 1 |
/// | `coupler` | body `Bar`, 2 kg |  |
/// | `b` | pin(z) | 1 |
/// | `rocker` | body `Bar`, 2 kg |  |
/// | `rocker_pin` | pin(z) | 1 |
///
/// Mobility 1: 4 rates, of which the closure takes 3.
///
/// Accelerations by `riccati`, 323 operations (190 mul, 119 add, 8 reciprocal, 6 square root, 4 sin/cos); with everything at every connection point 484 operations.
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
        let parameters_ = FourBarParameters {
            none: ::core::marker::PhantomData,
        };
        let (chain_, _) = Self::derive(parameters_);
        chain_
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
        let c_ = T::constant;
        FourBarState {
            q: ::mstmm::generated::vector([c_(0.0), c_(0.0), c_(0.0), c_(0.0)]),
            v: ::mstmm::generated::vector([c_(0.0), c_(0.0), c_(0.0), c_(0.0)]),
            t: T::constant(0.0),
        }
    }
    /// Quantities derived from parameters and constants: 0 mul, 0 add, 0 reciprocal.
    #[allow(unused_doc_comments, unused_variables, unused_mut, clippy::all)]
    fn derive(parameters_: FourBarParameters<T>) -> (Self, [T; 0]) {
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
impl<T: ::mstmm::Scalar> ::core::default::Default for FourBar<T> {
    fn default() -> Self {
        Self::new()
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> FourBar<T> {
    /// The accelerations `v̇` of all hinges, in the order of the rates: the fast path.
    ///
    /// 323 operations: 190 mul, 119 add, 8 reciprocal, 6 square root, 4 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `b` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 13 | 5 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 24 | 20 | 1 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 123 | 69 | 6 | 6 | 0 |
    /// | Acceleration of `crank_pin` | \[P, Eqs. (13), (36), (44)\] | 4 | 4 | 0 | 0 | 0 |
    /// | Acceleration of `a` | \[P, Eqs. (13), (36), (44)\] | 9 | 9 | 0 | 0 | 0 |
    /// | Acceleration of `b` | \[P, Eqs. (13), (36), (44)\] | 6 | 5 | 0 | 0 | 0 |
    /// | Results |  | 1 | 5 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// `Error::Singular` if nothing with inertia lies beyond a
    /// hinge, `Error::NotFinite` if a number of the state or the
    /// inputs is not finite. `accelerations` is not touched then.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn accelerations_into(
        &self,
        state_: &FourBarState<T>,
        inputs_: &FourBarInputs<T>,
        accelerations_: &mut ::mstmm::nalgebra::SVector<T, 4>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let c_ = T::constant;
        let [[crank_pin_angle_, a_angle_, b_angle_, rocker_pin_angle_]] = state_
            .q
            .data
            .0;
        let [[crank_pin_rate_, a_rate_, b_rate_, ..]] = state_.v.data.0;
        let crank_pin_input0_ = inputs_.crank_pin;
        /// Motion across `crank_pin`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 4 sin/cos.
        let (
            [sin_crank_pin_angle_,
            sin_a_angle_,
            sin_b_angle_,
            sin_rocker_pin_angle_,
            ],
            [cos_crank_pin_angle_,
            cos_a_angle_,
            cos_b_angle_,
            cos_rocker_pin_angle_,
            ],
        ) = T::sin_cos([crank_pin_angle_, a_angle_, b_angle_, rocker_pin_angle_]);
        /// Motion across `a`, [P, Eqs. (1), (13), (36)]: 4 mul, 1 add, 0 reciprocal.
        let a_omega_z_ = crank_pin_rate_ + a_rate_;
        let t0_ = crank_pin_rate_ * c_(0.2);
        let t1_ = crank_pin_rate_ * t0_;
        let minus_a_drift_lin_x_ = cos_a_angle_ * t1_;
        let a_drift_lin_y_ = sin_a_angle_ * t1_;
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 4 mul, 1 add, 0 reciprocal.
        let b_omega_z_ = b_rate_ + a_omega_z_;
        let t2_ = a_omega_z_ * c_(0.6);
        let t3_ = a_omega_z_ * t2_;
        let minus_b_drift_lin_x_ = cos_b_angle_ * t3_;
        let b_drift_lin_y_ = sin_b_angle_ * t3_;
        /// Riccati transfer over `b`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 0 add, 0 reciprocal.
        let t4_ = c_(0.6) * b_omega_z_;
        let minus_b_e_force_x_ = b_omega_z_ * t4_;
        /// Riccati transfer over `a`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 13 mul, 5 add, 1 reciprocal.
        let t5_ = sin_b_angle_ * c_(1.5);
        let a_k_xy_ = cos_b_angle_ * t5_;
        let a_b_x_z_ = c_(0.6) * a_k_xy_;
        let t6_ = sin_b_angle_ * t5_;
        let t7_ = c_(0.5) + t6_;
        let a_b_y_z_ = T::mul_add(c_(0.6), t7_, c_(0.6));
        let a_j_zz_ = T::mul_add(c_(0.36), t7_, c_(0.24));
        let t8_ = b_drift_lin_y_ * c_(0.5);
        let t9_ = T::mul_add(minus_b_drift_lin_x_, c_(2.0), minus_b_e_force_x_);
        let t10_ = sin_b_angle_ * t9_;
        let minus_a_e_force_y_ = T::mul_neg_add(cos_b_angle_, t8_, t10_);
        let minus_a_e_moment_z_ = c_(0.6) * minus_a_e_force_y_;
        let t11_ = T::recip(a_j_zz_);
        let a_z0_force_x_ = a_b_x_z_ * t11_;
        let a_z0_force_y_ = a_b_y_z_ * t11_;
        /// Riccati transfer over `crank_pin`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 24 mul, 20 add, 1 reciprocal.
        let t12_ = t6_ - c_(4.0);
        let t13_ = c_(2.5) + t6_;
        let t14_ = T::mul_add(a_b_x_z_, a_z0_force_x_, t12_);
        let t15_ = T::mul_neg_add(a_b_y_z_, a_z0_force_y_, t13_);
        let t16_ = T::mul_neg_add(a_b_y_z_, a_z0_force_x_, a_k_xy_);
        let t17_ = t14_ + t15_;
        let t18_ = sin_a_angle_ * t17_;
        let t19_ = c_(2.0) * t16_;
        let t20_ = T::mul_neg_add(cos_a_angle_, t19_, t18_);
        let minus_crank_pin_k_xy_ = T::mul_add(cos_a_angle_, t20_, t16_);
        let minus_crank_pin_b_x_z_ = c_(0.2) * minus_crank_pin_k_xy_;
        let t21_ = T::mul_neg_add(sin_a_angle_, t20_, t15_);
        let crank_pin_b_y_z_ = T::mul_add(c_(0.2), t21_, c_(0.1));
        let crank_pin_j_zz_ = T::mul_add(
            c_(0.04000000000000001),
            t21_,
            c_(0.020000000000000004),
        );
        let t22_ = sin_b_angle_ * t8_;
        let t23_ = minus_a_e_moment_z_ * t11_;
        let t24_ = T::mul_neg_add(a_b_y_z_, t23_, minus_a_e_force_y_);
        let t25_ = T::mul_add(cos_b_angle_, t9_, t3_);
        let t26_ = T::mul_sub(a_drift_lin_y_, t16_, t25_);
        let t27_ = T::mul_neg_add(a_b_x_z_, t23_, t22_);
        let t28_ = T::mul_sub(minus_a_drift_lin_x_, t14_, t27_);
        let t29_ = t26_ + t28_;
        let t30_ = T::mul_neg_add(a_drift_lin_y_, t15_, t24_);
        let t31_ = T::mul_add(minus_a_drift_lin_x_, t16_, t30_);
        let t32_ = sin_a_angle_ * t29_;
        let crank_pin_e_force_y_ = T::mul_neg_add(cos_a_angle_, t31_, t32_);
        let t33_ = T::recip(crank_pin_j_zz_);
        let minus_crank_pin_z0_force_x_ = minus_crank_pin_b_x_z_ * t33_;
        let crank_pin_z0_force_y_ = crank_pin_b_y_z_ * t33_;
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 123 mul, 69 add, 6 reciprocal, 6 square root.
        let t34_ = c_(0.6) * sin_rocker_pin_angle_;
        let t35_ = sin_rocker_pin_angle_ * c_(2.5);
        let t36_ = T::mul_neg_add(sin_rocker_pin_angle_, c_(1.5), sin_rocker_pin_angle_);
        let t37_ = t34_ * t35_;
        let t38_ = cos_b_angle_ * cos_rocker_pin_angle_;
        let t39_ = T::mul_neg_add(sin_b_angle_, t36_, t38_);
        let t40_ = sin_b_angle_ * cos_rocker_pin_angle_;
        let t41_ = T::mul_add(cos_b_angle_, t36_, t40_);
        let t42_ = c_(0.6) * t41_;
        let t43_ = t42_ * t11_;
        let t44_ = T::mul_neg_add(t42_, a_z0_force_x_, t39_);
        let t45_ = T::mul_neg_add(t42_, a_z0_force_y_, t41_);
        let t46_ = T::mul_add(t42_, t43_, t37_);
        let t47_ = sin_a_angle_ * t44_;
        let t48_ = T::mul_add(cos_a_angle_, t45_, t47_);
        let t49_ = c_(0.2) * t48_;
        let t50_ = t49_ * t33_;
        let closure_d0_ = T::mul_add(t49_, t50_, t46_);
        let t51_ = c_(0.6) * cos_rocker_pin_angle_;
        let t52_ = cos_rocker_pin_angle_ * c_(2.5);
        let t53_ = cos_rocker_pin_angle_ * cos_rocker_pin_angle_;
        let t54_ = T::mul_add(sin_rocker_pin_angle_, sin_rocker_pin_angle_, t53_);
        let t55_ = t54_ * c_(0.36);
        let t56_ = T::mul_add(t34_, t34_, t55_);
        let t57_ = t56_ * c_(4.166666666666667);
        let t58_ = T::mul_neg_add(cos_rocker_pin_angle_, c_(1.5), cos_rocker_pin_angle_);
        let t59_ = t51_ * t35_;
        let t60_ = t51_ * t52_;
        let t61_ = cos_b_angle_ * sin_rocker_pin_angle_;
        let t62_ = T::mul_add(sin_b_angle_, t58_, t61_);
        let t63_ = sin_b_angle_ * sin_rocker_pin_angle_;
        let t64_ = T::mul_neg_add(cos_b_angle_, t58_, t63_);
        let t65_ = c_(0.6) * t64_;
        let t66_ = t65_ * t11_;
        let t67_ = t39_ * t39_;
        let t68_ = T::mul_add(t41_, t41_, t67_);
        let t69_ = t42_ * t42_;
        let t70_ = T::mul_add(t68_, c_(0.72), t69_);
        let t71_ = T::mul_add(t11_, t70_, t57_);
        let t72_ = T::mul_neg_add(t65_, a_z0_force_x_, t62_);
        let t73_ = T::mul_neg_add(t65_, a_z0_force_y_, t64_);
        let t74_ = T::mul_neg_add(t65_, t43_, t59_);
        let t75_ = T::mul_add(t65_, t66_, t60_);
        let t76_ = cos_a_angle_ * t44_;
        let t77_ = T::mul_neg_add(sin_a_angle_, t45_, t76_);
        let t78_ = sin_a_angle_ * t72_;
        let t79_ = T::mul_add(cos_a_angle_, t73_, t78_);
        let t80_ = c_(0.2) * t79_;
        let t81_ = t80_ * t33_;
        let t82_ = t77_ * t77_;
        let t83_ = T::mul_add(t48_, t48_, t82_);
        let t84_ = t49_ * t49_;
        let t85_ = T::mul_add(t83_, c_(0.76), t84_);
        let t86_ = T::mul_add(t33_, t85_, t71_);
        let t87_ = T::mul_neg_add(t80_, t50_, t74_);
        let t88_ = T::mul_add(t80_, t81_, t75_);
        let t89_ = T::copysign(closure_d0_, c_(1.0));
        let t90_ = closure_d0_ + t89_;
        let t91_ = c_(0.5) * t90_;
        let t92_ = T::sqrt(t91_);
        let t93_ = T::sqrt(t86_);
        let t94_ = ::mstmm::generated::recip_above(t92_, t93_);
        let t95_ = t92_ * t94_;
        let t96_ = ::mstmm::generated::recip_above(closure_d0_, closure_d0_);
        let t97_ = t95_ * t96_;
        let t98_ = t87_ * t97_;
        let closure_d1_ = T::mul_neg_add(t87_, t98_, t88_);
        let t99_ = T::mul_add(t51_, t51_, t55_);
        let t100_ = c_(4.166666666666667) * t99_;
        let t101_ = b_drift_lin_y_ * t36_;
        let t102_ = t42_ * t23_;
        let t103_ = t65_ * t23_;
        let t104_ = t62_ * t62_;
        let t105_ = T::mul_add(t64_, t64_, t104_);
        let t106_ = t65_ * t65_;
        let t107_ = T::mul_add(c_(0.72), t105_, t106_);
        let t108_ = T::mul_add(t11_, t107_, t100_);
        let t109_ = cos_a_angle_ * t72_;
        let t110_ = T::mul_neg_add(sin_a_angle_, t73_, t109_);
        let t111_ = T::mul_add(t49_, minus_crank_pin_z0_force_x_, t77_);
        let t112_ = T::mul_neg_add(t49_, crank_pin_z0_force_y_, t48_);
        let t113_ = T::mul_add(t80_, minus_crank_pin_z0_force_x_, t110_);
        let t114_ = T::mul_neg_add(t80_, crank_pin_z0_force_y_, t79_);
        let t115_ = t110_ * t110_;
        let t116_ = T::mul_add(t79_, t79_, t115_);
        let t117_ = t80_ * t80_;
        let t118_ = T::mul_add(c_(0.76), t116_, t117_);
        let t119_ = T::mul_add(t33_, t118_, t108_);
        let crank_pin_a_lin_x_ = sin_crank_pin_angle_ * c_(9.8);
        let crank_pin_a_lin_y_ = cos_crank_pin_angle_ * c_(9.8);
        let t120_ = T::copysign(closure_d1_, c_(1.0));
        let t121_ = closure_d1_ + t120_;
        let t122_ = c_(0.5) * t121_;
        let t123_ = T::sqrt(t122_);
        let t124_ = T::sqrt(t119_);
        let t125_ = ::mstmm::generated::recip_above(t123_, t124_);
        let t126_ = t123_ * t125_;
        let t127_ = ::mstmm::generated::recip_above(closure_d1_, t88_);
        let t128_ = t126_ * t127_;
        let t129_ = T::mul_neg_add(closure_d0_, t97_, c_(1.0));
        let t130_ = t129_ * t129_;
        let t131_ = ::mstmm::generated::recip_above(t130_, c_(1.0));
        let t132_ = T::sqrt(t131_);
        let t133_ = t129_ * t132_;
        let t134_ = T::mul_neg_add(closure_d1_, t128_, c_(1.0));
        let t135_ = t98_ * t134_;
        let t136_ = t133_ * t135_;
        let t137_ = T::mul_neg_add(t133_, t136_, t135_);
        let t138_ = t137_ * t137_;
        let t139_ = T::mul_add(t134_, t134_, t138_);
        let t140_ = ::mstmm::generated::recip_above(t139_, c_(1.0));
        let t141_ = T::sqrt(t140_);
        let t142_ = t137_ * t141_;
        let t143_ = t134_ * t141_;
        let t144_ = minus_b_drift_lin_x_ + minus_b_e_force_x_;
        let t145_ = T::mul_neg_add(b_drift_lin_y_, t58_, c_(9.8));
        let t146_ = T::mul_neg_add(c_(0.2), crank_pin_e_force_y_, crank_pin_input0_);
        let t147_ = t33_ * t146_;
        let t148_ = T::mul_neg_add(cos_rocker_pin_angle_, t144_, t102_);
        let t149_ = T::mul_sub(minus_a_drift_lin_x_, t44_, t148_);
        let t150_ = T::mul_sub(t112_, crank_pin_a_lin_y_, t149_);
        let t151_ = T::mul_add(a_drift_lin_y_, t45_, t101_);
        let t152_ = T::mul_add(t49_, t147_, t151_);
        let t153_ = T::mul_add(t111_, crank_pin_a_lin_x_, t152_);
        let t154_ = t150_ + t153_;
        let t155_ = T::mul_add(a_drift_lin_y_, t73_, t145_);
        let t156_ = T::mul_add(t80_, t147_, t155_);
        let t157_ = T::mul_add(t113_, crank_pin_a_lin_x_, t156_);
        let t158_ = T::mul_neg_add(sin_rocker_pin_angle_, t144_, t103_);
        let t159_ = T::mul_sub(minus_a_drift_lin_x_, t72_, t158_);
        let t160_ = T::mul_sub(t114_, crank_pin_a_lin_y_, t159_);
        let t161_ = T::mul_add(t98_, t154_, t160_);
        let t162_ = t157_ + t161_;
        let t163_ = t97_ * t154_;
        let t164_ = t128_ * t162_;
        let t165_ = T::mul_add(t98_, t164_, t163_);
        let t166_ = t133_ * t165_;
        let t167_ = T::mul_neg_add(t133_, t166_, t165_);
        let t168_ = t142_ * t167_;
        let t169_ = T::mul_add(t143_, t164_, t168_);
        let closure_reaction0_ = T::mul_neg_add(t142_, t169_, t167_);
        let minus_closure_reaction1_ = T::mul_neg_add(t143_, t169_, t164_);
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 4 mul, 4 add, 0 reciprocal.
        let t170_ = T::mul_sub(crank_pin_z0_force_y_, crank_pin_a_lin_y_, t147_);
        let t171_ = T::mul_sub(minus_crank_pin_z0_force_x_, crank_pin_a_lin_x_, t170_);
        let t172_ = T::mul_sub(t81_, minus_closure_reaction1_, t171_);
        let minus_crank_pin_a_ang_z_ = T::mul_add(t50_, closure_reaction0_, t172_);
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 9 mul, 9 add, 0 reciprocal.
        let t173_ = T::mul_neg_add(
            cos_a_angle_,
            crank_pin_a_lin_x_,
            minus_a_drift_lin_x_,
        );
        let t174_ = T::mul_neg_add(
            c_(0.2),
            minus_crank_pin_a_ang_z_,
            crank_pin_a_lin_y_,
        );
        let minus_a_a_lin_x_ = T::mul_neg_add(sin_a_angle_, t174_, t173_);
        let t175_ = T::mul_neg_add(sin_a_angle_, crank_pin_a_lin_x_, a_drift_lin_y_);
        let a_a_lin_y_ = T::mul_add(cos_a_angle_, t174_, t175_);
        let t176_ = T::mul_neg_add(t66_, minus_closure_reaction1_, t23_);
        let t177_ = T::mul_sub(t43_, closure_reaction0_, t176_);
        let t178_ = T::mul_add(a_z0_force_y_, a_a_lin_y_, t177_);
        let a_a_ang_z_ = T::mul_sub(a_z0_force_x_, minus_a_a_lin_x_, t178_);
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 6 mul, 5 add, 0 reciprocal.
        let t179_ = T::mul_add(c_(0.6), a_a_ang_z_, a_a_lin_y_);
        let t180_ = T::mul_add(sin_b_angle_, minus_a_a_lin_x_, b_drift_lin_y_);
        let b_a_lin_y_ = T::mul_add(cos_b_angle_, t179_, t180_);
        let t181_ = t35_ * closure_reaction0_;
        let t182_ = T::mul_neg_add(t52_, minus_closure_reaction1_, t181_);
        let minus_b_a_ang_z_ = T::mul_add(c_(2.5), b_a_lin_y_, t182_);
        /// Results: 1 mul, 5 add, 0 reciprocal.
        let t183_ = minus_crank_pin_a_ang_z_ + a_a_ang_z_;
        let t184_ = a_a_ang_z_ + minus_b_a_ang_z_;
        let t185_ = c_(4.0) + t15_;
        let t186_ = t14_ - t185_;
        let t187_ = T::mul_neg_add(
            c_(0.04000000000000001),
            t186_,
            c_(0.030000000000000006),
        );
        ::mstmm::generated::finite::<
            T,
        >(
            &[
                state_.q.as_slice(),
                state_.v.as_slice(),
                &[state_.t],
                &[inputs_.crank_pin],
            ],
        )?;
        ::mstmm::generated::regular::<
            T,
            _,
            _,
        >(
            &["a", "crank_pin"],
            [a_j_zz_, crank_pin_j_zz_],
            [c_(2.04), t187_],
            [-minus_crank_pin_a_ang_z_, t183_, -t184_, minus_b_a_ang_z_],
        )?;
        accelerations_.data.0 = [
            [-minus_crank_pin_a_ang_z_, t183_, -t184_, minus_b_a_ang_z_],
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
    pub fn accelerations(
        &self,
        state_: &FourBarState<T>,
        inputs_: &FourBarInputs<T>,
    ) -> ::core::result::Result<::mstmm::nalgebra::SVector<T, 4>, ::mstmm::Error> {
        let mut accelerations_ = ::mstmm::generated::vector([T::constant(0.0); 4]);
        self.accelerations_into(state_, inputs_, &mut accelerations_)?;
        ::core::result::Result::Ok(accelerations_)
    }
    /// Everything: accelerations, efforts, energies and, at every connection point, pose,
    /// velocity and the state vector `z`, written into `at`.
    ///
    /// 484 operations: 287 mul, 183 add, 8 reciprocal, 6 square root, 4 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `b` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 13 | 5 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 24 | 20 | 1 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 123 | 69 | 6 | 6 | 0 |
    /// | Acceleration of `crank_pin` | \[P, Eqs. (13), (36), (44)\] | 4 | 4 | 0 | 0 | 0 |
    /// | Acceleration of `a` | \[P, Eqs. (13), (36), (44)\] | 9 | 9 | 0 | 0 | 0 |
    /// | Acceleration of `b` | \[P, Eqs. (13), (36), (44)\] | 8 | 7 | 0 | 0 | 0 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 10 | 2 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 8 | 2 | 0 | 0 | 0 |
    /// | Point of `a` | \[P, Eqs. (12), (13), (36)\] | 2 | 2 | 0 | 0 | 0 |
    /// | Point of `b` | \[P, Eqs. (12), (13), (36)\] | 4 | 4 | 0 | 0 | 0 |
    /// | Load on `rocker_pin` | \[P, Eqs. (18), (19)\] | 8 | 4 | 0 | 0 | 0 |
    /// | Load on `b` | \[P, Eqs. (18), (19)\] | 7 | 6 | 0 | 0 | 0 |
    /// | Load on `a` | \[P, Eqs. (18), (19)\] | 6 | 6 | 0 | 0 | 0 |
    /// | Load on `crank_pin` | \[P, Eqs. (18), (19)\] | 7 | 6 | 0 | 0 | 0 |
    /// | Results |  | 44 | 35 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// As [`accelerations_into`](Self::accelerations_into); `at` is not touched then.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn solve_into(
        &self,
        state_: &FourBarState<T>,
        inputs_: &FourBarInputs<T>,
        at_: &mut FourBarWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let c_ = T::constant;
        let [[crank_pin_angle_, a_angle_, b_angle_, rocker_pin_angle_]] = state_
            .q
            .data
            .0;
        let [[crank_pin_rate_, a_rate_, b_rate_, ..]] = state_.v.data.0;
        let crank_pin_input0_ = inputs_.crank_pin;
        /// Motion across `crank_pin`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 4 sin/cos.
        let (
            [sin_crank_pin_angle_,
            sin_a_angle_,
            sin_b_angle_,
            sin_rocker_pin_angle_,
            ],
            [cos_crank_pin_angle_,
            cos_a_angle_,
            cos_b_angle_,
            cos_rocker_pin_angle_,
            ],
        ) = T::sin_cos([crank_pin_angle_, a_angle_, b_angle_, rocker_pin_angle_]);
        /// Motion across `a`, [P, Eqs. (1), (13), (36)]: 4 mul, 1 add, 0 reciprocal.
        let a_omega_z_ = crank_pin_rate_ + a_rate_;
        let t0_ = crank_pin_rate_ * c_(0.2);
        let t1_ = crank_pin_rate_ * t0_;
        let minus_a_drift_lin_x_ = cos_a_angle_ * t1_;
        let a_drift_lin_y_ = sin_a_angle_ * t1_;
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 4 mul, 1 add, 0 reciprocal.
        let b_omega_z_ = b_rate_ + a_omega_z_;
        let t2_ = a_omega_z_ * c_(0.6);
        let t3_ = a_omega_z_ * t2_;
        let minus_b_drift_lin_x_ = cos_b_angle_ * t3_;
        let b_drift_lin_y_ = sin_b_angle_ * t3_;
        /// Riccati transfer over `b`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 0 add, 0 reciprocal.
        let t4_ = c_(0.6) * b_omega_z_;
        let minus_b_e_force_x_ = b_omega_z_ * t4_;
        /// Riccati transfer over `a`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 13 mul, 5 add, 1 reciprocal.
        let t5_ = sin_b_angle_ * c_(1.5);
        let a_k_xy_ = cos_b_angle_ * t5_;
        let a_b_x_z_ = c_(0.6) * a_k_xy_;
        let t6_ = sin_b_angle_ * t5_;
        let t7_ = c_(0.5) + t6_;
        let a_b_y_z_ = T::mul_add(c_(0.6), t7_, c_(0.6));
        let a_j_zz_ = T::mul_add(c_(0.36), t7_, c_(0.24));
        let t8_ = b_drift_lin_y_ * c_(0.5);
        let t9_ = T::mul_add(minus_b_drift_lin_x_, c_(2.0), minus_b_e_force_x_);
        let t10_ = sin_b_angle_ * t9_;
        let minus_a_e_force_y_ = T::mul_neg_add(cos_b_angle_, t8_, t10_);
        let minus_a_e_moment_z_ = c_(0.6) * minus_a_e_force_y_;
        let t11_ = T::recip(a_j_zz_);
        let a_z0_force_x_ = a_b_x_z_ * t11_;
        let a_z0_force_y_ = a_b_y_z_ * t11_;
        /// Riccati transfer over `crank_pin`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 24 mul, 20 add, 1 reciprocal.
        let t12_ = t6_ - c_(4.0);
        let t13_ = c_(2.5) + t6_;
        let t14_ = T::mul_add(a_b_x_z_, a_z0_force_x_, t12_);
        let t15_ = T::mul_neg_add(a_b_y_z_, a_z0_force_y_, t13_);
        let t16_ = T::mul_neg_add(a_b_y_z_, a_z0_force_x_, a_k_xy_);
        let t17_ = t14_ + t15_;
        let t18_ = sin_a_angle_ * t17_;
        let t19_ = c_(2.0) * t16_;
        let t20_ = T::mul_neg_add(cos_a_angle_, t19_, t18_);
        let minus_crank_pin_k_xy_ = T::mul_add(cos_a_angle_, t20_, t16_);
        let minus_crank_pin_b_x_z_ = c_(0.2) * minus_crank_pin_k_xy_;
        let t21_ = T::mul_neg_add(sin_a_angle_, t20_, t15_);
        let crank_pin_b_y_z_ = T::mul_add(c_(0.2), t21_, c_(0.1));
        let crank_pin_j_zz_ = T::mul_add(
            c_(0.04000000000000001),
            t21_,
            c_(0.020000000000000004),
        );
        let t22_ = sin_b_angle_ * t8_;
        let t23_ = minus_a_e_moment_z_ * t11_;
        let t24_ = T::mul_neg_add(a_b_y_z_, t23_, minus_a_e_force_y_);
        let t25_ = T::mul_add(cos_b_angle_, t9_, t3_);
        let t26_ = T::mul_sub(a_drift_lin_y_, t16_, t25_);
        let t27_ = T::mul_neg_add(a_b_x_z_, t23_, t22_);
        let t28_ = T::mul_sub(minus_a_drift_lin_x_, t14_, t27_);
        let t29_ = t26_ + t28_;
        let t30_ = T::mul_neg_add(a_drift_lin_y_, t15_, t24_);
        let t31_ = T::mul_add(minus_a_drift_lin_x_, t16_, t30_);
        let t32_ = sin_a_angle_ * t29_;
        let crank_pin_e_force_y_ = T::mul_neg_add(cos_a_angle_, t31_, t32_);
        let t33_ = T::recip(crank_pin_j_zz_);
        let minus_crank_pin_z0_force_x_ = minus_crank_pin_b_x_z_ * t33_;
        let crank_pin_z0_force_y_ = crank_pin_b_y_z_ * t33_;
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 123 mul, 69 add, 6 reciprocal, 6 square root.
        let t34_ = c_(0.6) * sin_rocker_pin_angle_;
        let t35_ = sin_rocker_pin_angle_ * c_(2.5);
        let t36_ = T::mul_neg_add(sin_rocker_pin_angle_, c_(1.5), sin_rocker_pin_angle_);
        let t37_ = t34_ * t35_;
        let t38_ = cos_b_angle_ * cos_rocker_pin_angle_;
        let t39_ = T::mul_neg_add(sin_b_angle_, t36_, t38_);
        let t40_ = sin_b_angle_ * cos_rocker_pin_angle_;
        let t41_ = T::mul_add(cos_b_angle_, t36_, t40_);
        let t42_ = c_(0.6) * t41_;
        let t43_ = t42_ * t11_;
        let t44_ = T::mul_neg_add(t42_, a_z0_force_x_, t39_);
        let t45_ = T::mul_neg_add(t42_, a_z0_force_y_, t41_);
        let t46_ = T::mul_add(t42_, t43_, t37_);
        let t47_ = sin_a_angle_ * t44_;
        let t48_ = T::mul_add(cos_a_angle_, t45_, t47_);
        let t49_ = c_(0.2) * t48_;
        let t50_ = t49_ * t33_;
        let closure_d0_ = T::mul_add(t49_, t50_, t46_);
        let t51_ = c_(0.6) * cos_rocker_pin_angle_;
        let t52_ = cos_rocker_pin_angle_ * c_(2.5);
        let t53_ = cos_rocker_pin_angle_ * cos_rocker_pin_angle_;
        let t54_ = T::mul_add(sin_rocker_pin_angle_, sin_rocker_pin_angle_, t53_);
        let t55_ = t54_ * c_(0.36);
        let t56_ = T::mul_add(t34_, t34_, t55_);
        let t57_ = t56_ * c_(4.166666666666667);
        let t58_ = T::mul_neg_add(cos_rocker_pin_angle_, c_(1.5), cos_rocker_pin_angle_);
        let t59_ = t51_ * t35_;
        let t60_ = t51_ * t52_;
        let t61_ = cos_b_angle_ * sin_rocker_pin_angle_;
        let t62_ = T::mul_add(sin_b_angle_, t58_, t61_);
        let t63_ = sin_b_angle_ * sin_rocker_pin_angle_;
        let t64_ = T::mul_neg_add(cos_b_angle_, t58_, t63_);
        let t65_ = c_(0.6) * t64_;
        let t66_ = t65_ * t11_;
        let t67_ = t39_ * t39_;
        let t68_ = T::mul_add(t41_, t41_, t67_);
        let t69_ = t42_ * t42_;
        let t70_ = T::mul_add(t68_, c_(0.72), t69_);
        let t71_ = T::mul_add(t11_, t70_, t57_);
        let t72_ = T::mul_neg_add(t65_, a_z0_force_x_, t62_);
        let t73_ = T::mul_neg_add(t65_, a_z0_force_y_, t64_);
        let t74_ = T::mul_neg_add(t65_, t43_, t59_);
        let t75_ = T::mul_add(t65_, t66_, t60_);
        let t76_ = cos_a_angle_ * t44_;
        let t77_ = T::mul_neg_add(sin_a_angle_, t45_, t76_);
        let t78_ = sin_a_angle_ * t72_;
        let t79_ = T::mul_add(cos_a_angle_, t73_, t78_);
        let t80_ = c_(0.2) * t79_;
        let t81_ = t80_ * t33_;
        let t82_ = t77_ * t77_;
        let t83_ = T::mul_add(t48_, t48_, t82_);
        let t84_ = t49_ * t49_;
        let t85_ = T::mul_add(t83_, c_(0.76), t84_);
        let t86_ = T::mul_add(t33_, t85_, t71_);
        let t87_ = T::mul_neg_add(t80_, t50_, t74_);
        let t88_ = T::mul_add(t80_, t81_, t75_);
        let t89_ = T::copysign(closure_d0_, c_(1.0));
        let t90_ = closure_d0_ + t89_;
        let t91_ = c_(0.5) * t90_;
        let t92_ = T::sqrt(t91_);
        let t93_ = T::sqrt(t86_);
        let t94_ = ::mstmm::generated::recip_above(t92_, t93_);
        let t95_ = t92_ * t94_;
        let t96_ = ::mstmm::generated::recip_above(closure_d0_, closure_d0_);
        let t97_ = t95_ * t96_;
        let t98_ = t87_ * t97_;
        let closure_d1_ = T::mul_neg_add(t87_, t98_, t88_);
        let t99_ = T::mul_add(t51_, t51_, t55_);
        let t100_ = c_(4.166666666666667) * t99_;
        let t101_ = b_drift_lin_y_ * t36_;
        let t102_ = t42_ * t23_;
        let t103_ = t65_ * t23_;
        let t104_ = t62_ * t62_;
        let t105_ = T::mul_add(t64_, t64_, t104_);
        let t106_ = t65_ * t65_;
        let t107_ = T::mul_add(c_(0.72), t105_, t106_);
        let t108_ = T::mul_add(t11_, t107_, t100_);
        let t109_ = cos_a_angle_ * t72_;
        let t110_ = T::mul_neg_add(sin_a_angle_, t73_, t109_);
        let t111_ = T::mul_add(t49_, minus_crank_pin_z0_force_x_, t77_);
        let t112_ = T::mul_neg_add(t49_, crank_pin_z0_force_y_, t48_);
        let t113_ = T::mul_add(t80_, minus_crank_pin_z0_force_x_, t110_);
        let t114_ = T::mul_neg_add(t80_, crank_pin_z0_force_y_, t79_);
        let t115_ = t110_ * t110_;
        let t116_ = T::mul_add(t79_, t79_, t115_);
        let t117_ = t80_ * t80_;
        let t118_ = T::mul_add(c_(0.76), t116_, t117_);
        let t119_ = T::mul_add(t33_, t118_, t108_);
        let crank_pin_a_lin_x_ = sin_crank_pin_angle_ * c_(9.8);
        let crank_pin_a_lin_y_ = cos_crank_pin_angle_ * c_(9.8);
        let t120_ = T::copysign(closure_d1_, c_(1.0));
        let t121_ = closure_d1_ + t120_;
        let t122_ = c_(0.5) * t121_;
        let t123_ = T::sqrt(t122_);
        let t124_ = T::sqrt(t119_);
        let t125_ = ::mstmm::generated::recip_above(t123_, t124_);
        let t126_ = t123_ * t125_;
        let t127_ = ::mstmm::generated::recip_above(closure_d1_, t88_);
        let t128_ = t126_ * t127_;
        let t129_ = T::mul_neg_add(closure_d0_, t97_, c_(1.0));
        let t130_ = t129_ * t129_;
        let t131_ = ::mstmm::generated::recip_above(t130_, c_(1.0));
        let t132_ = T::sqrt(t131_);
        let t133_ = t129_ * t132_;
        let t134_ = T::mul_neg_add(closure_d1_, t128_, c_(1.0));
        let t135_ = t98_ * t134_;
        let t136_ = t133_ * t135_;
        let t137_ = T::mul_neg_add(t133_, t136_, t135_);
        let t138_ = t137_ * t137_;
        let t139_ = T::mul_add(t134_, t134_, t138_);
        let t140_ = ::mstmm::generated::recip_above(t139_, c_(1.0));
        let t141_ = T::sqrt(t140_);
        let t142_ = t137_ * t141_;
        let t143_ = t134_ * t141_;
        let t144_ = minus_b_drift_lin_x_ + minus_b_e_force_x_;
        let t145_ = T::mul_neg_add(b_drift_lin_y_, t58_, c_(9.8));
        let t146_ = T::mul_neg_add(c_(0.2), crank_pin_e_force_y_, crank_pin_input0_);
        let t147_ = t33_ * t146_;
        let t148_ = T::mul_neg_add(cos_rocker_pin_angle_, t144_, t102_);
        let t149_ = T::mul_sub(minus_a_drift_lin_x_, t44_, t148_);
        let t150_ = T::mul_sub(t112_, crank_pin_a_lin_y_, t149_);
        let t151_ = T::mul_add(a_drift_lin_y_, t45_, t101_);
        let t152_ = T::mul_add(t49_, t147_, t151_);
        let t153_ = T::mul_add(t111_, crank_pin_a_lin_x_, t152_);
        let t154_ = t150_ + t153_;
        let t155_ = T::mul_add(a_drift_lin_y_, t73_, t145_);
        let t156_ = T::mul_add(t80_, t147_, t155_);
        let t157_ = T::mul_add(t113_, crank_pin_a_lin_x_, t156_);
        let t158_ = T::mul_neg_add(sin_rocker_pin_angle_, t144_, t103_);
        let t159_ = T::mul_sub(minus_a_drift_lin_x_, t72_, t158_);
        let t160_ = T::mul_sub(t114_, crank_pin_a_lin_y_, t159_);
        let t161_ = T::mul_add(t98_, t154_, t160_);
        let t162_ = t157_ + t161_;
        let t163_ = t97_ * t154_;
        let t164_ = t128_ * t162_;
        let t165_ = T::mul_add(t98_, t164_, t163_);
        let t166_ = t133_ * t165_;
        let t167_ = T::mul_neg_add(t133_, t166_, t165_);
        let t168_ = t142_ * t167_;
        let t169_ = T::mul_add(t143_, t164_, t168_);
        let closure_reaction0_ = T::mul_neg_add(t142_, t169_, t167_);
        let minus_closure_reaction1_ = T::mul_neg_add(t143_, t169_, t164_);
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 4 mul, 4 add, 0 reciprocal.
        let t170_ = T::mul_sub(crank_pin_z0_force_y_, crank_pin_a_lin_y_, t147_);
        let t171_ = T::mul_sub(minus_crank_pin_z0_force_x_, crank_pin_a_lin_x_, t170_);
        let t172_ = T::mul_sub(t81_, minus_closure_reaction1_, t171_);
        let minus_crank_pin_a_ang_z_ = T::mul_add(t50_, closure_reaction0_, t172_);
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 9 mul, 9 add, 0 reciprocal.
        let t173_ = T::mul_neg_add(
            cos_a_angle_,
            crank_pin_a_lin_x_,
            minus_a_drift_lin_x_,
        );
        let t174_ = T::mul_neg_add(
            c_(0.2),
            minus_crank_pin_a_ang_z_,
            crank_pin_a_lin_y_,
        );
        let minus_a_a_lin_x_ = T::mul_neg_add(sin_a_angle_, t174_, t173_);
        let t175_ = T::mul_neg_add(sin_a_angle_, crank_pin_a_lin_x_, a_drift_lin_y_);
        let a_a_lin_y_ = T::mul_add(cos_a_angle_, t174_, t175_);
        let t176_ = T::mul_neg_add(t66_, minus_closure_reaction1_, t23_);
        let t177_ = T::mul_sub(t43_, closure_reaction0_, t176_);
        let t178_ = T::mul_add(a_z0_force_y_, a_a_lin_y_, t177_);
        let a_a_ang_z_ = T::mul_sub(a_z0_force_x_, minus_a_a_lin_x_, t178_);
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 8 mul, 7 add, 0 reciprocal.
        let t179_ = c_(0.6) * a_a_ang_z_;
        let t180_ = a_a_lin_y_ + t179_;
        let t181_ = T::mul_add(cos_b_angle_, minus_a_a_lin_x_, minus_b_drift_lin_x_);
        let b_a_lin_x_ = T::mul_sub(sin_b_angle_, t180_, t181_);
        let t182_ = T::mul_add(sin_b_angle_, minus_a_a_lin_x_, b_drift_lin_y_);
        let b_a_lin_y_ = T::mul_add(cos_b_angle_, t180_, t182_);
        let t183_ = t35_ * closure_reaction0_;
        let t184_ = T::mul_neg_add(t52_, minus_closure_reaction1_, t183_);
        let minus_b_a_ang_z_ = T::mul_add(c_(2.5), b_a_lin_y_, t184_);
        /// Motion across `a`, [P, Eqs. (1), (13), (36)]: 10 mul, 2 add, 0 reciprocal.
        let t185_ = cos_crank_pin_angle_ * cos_a_angle_;
        let a_axes_x_x_ = T::mul_neg_add(sin_crank_pin_angle_, sin_a_angle_, t185_);
        let t186_ = cos_crank_pin_angle_ * sin_a_angle_;
        let minus_a_axes_x_y_ = T::mul_add(sin_crank_pin_angle_, cos_a_angle_, t186_);
        let t187_ = cos_crank_pin_angle_ * c_(0.2);
        let t188_ = crank_pin_rate_ * t187_;
        let minus_a_drift_lin_x_2_ = crank_pin_rate_ * t188_;
        let t189_ = sin_crank_pin_angle_ * c_(0.2);
        let t190_ = crank_pin_rate_ * t189_;
        let minus_a_drift_lin_y_ = crank_pin_rate_ * t190_;
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 8 mul, 2 add, 0 reciprocal.
        let t191_ = cos_b_angle_ * a_axes_x_x_;
        let b_axes_x_x_ = T::mul_neg_add(sin_b_angle_, minus_a_axes_x_y_, t191_);
        let t192_ = sin_b_angle_ * a_axes_x_x_;
        let minus_b_axes_x_y_ = T::mul_add(cos_b_angle_, minus_a_axes_x_y_, t192_);
        let t193_ = c_(0.6) * a_axes_x_x_;
        let t194_ = a_omega_z_ * t193_;
        let t195_ = c_(0.6) * minus_a_axes_x_y_;
        let t196_ = a_omega_z_ * t195_;
        /// Point of `a`, [P, Eqs. (12), (13), (36)]: 2 mul, 2 add, 0 reciprocal.
        let minus_a_acc_lin_x_ = T::mul_neg_add(
            minus_crank_pin_a_ang_z_,
            t189_,
            minus_a_drift_lin_x_2_,
        );
        let minus_a_acc_lin_y_ = T::mul_add(
            minus_crank_pin_a_ang_z_,
            t187_,
            minus_a_drift_lin_y_,
        );
        /// Point of `b`, [P, Eqs. (12), (13), (36)]: 4 mul, 4 add, 0 reciprocal.
        let t197_ = T::mul_add(a_omega_z_, t194_, minus_a_acc_lin_x_);
        let minus_b_acc_lin_x_ = T::mul_add(a_a_ang_z_, t195_, t197_);
        let t198_ = T::mul_add(a_omega_z_, t196_, minus_a_acc_lin_y_);
        let b_acc_lin_y_ = T::mul_sub(a_a_ang_z_, t193_, t198_);
        /// Load on `rocker_pin`, [P, Eqs. (18), (19)]: 8 mul, 4 add, 0 reciprocal.
        let t199_ = cos_rocker_pin_angle_ * closure_reaction0_;
        let t200_ = T::mul_add(sin_rocker_pin_angle_, minus_closure_reaction1_, t199_);
        let t201_ = sin_rocker_pin_angle_ * closure_reaction0_;
        let t202_ = T::mul_neg_add(
            cos_rocker_pin_angle_,
            minus_closure_reaction1_,
            t201_,
        );
        let t203_ = b_axes_x_x_ * t200_;
        let rocker_pin_load_force_x_ = T::mul_neg_add(minus_b_axes_x_y_, t202_, t203_);
        let t204_ = minus_b_axes_x_y_ * t200_;
        let rocker_pin_load_force_y_ = T::mul_add(b_axes_x_x_, t202_, t204_);
        /// Load on `b`, [P, Eqs. (18), (19)]: 7 mul, 6 add, 0 reciprocal.
        let t205_ = c_(0.6) * minus_b_a_ang_z_;
        let t206_ = T::mul_neg_add(c_(2.0), b_a_lin_y_, t205_);
        let t207_ = T::mul_neg_add(c_(2.0), b_a_lin_x_, minus_b_e_force_x_);
        let t208_ = T::mul_sub(b_axes_x_x_, t207_, rocker_pin_load_force_x_);
        let b_load_force_x_ = T::mul_sub(minus_b_axes_x_y_, t206_, t208_);
        let t209_ = T::mul_sub(minus_b_axes_x_y_, t207_, rocker_pin_load_force_y_);
        let minus_b_load_force_y_ = T::mul_add(b_axes_x_x_, t206_, t209_);
        /// Load on `a`, [P, Eqs. (18), (19)]: 6 mul, 6 add, 0 reciprocal.
        let t210_ = T::mul_add(c_(2.0), a_a_lin_y_, t179_);
        let t211_ = T::mul_add(c_(2.0), minus_a_a_lin_x_, t3_);
        let t212_ = a_axes_x_x_ * t211_;
        let t213_ = T::mul_add(minus_a_axes_x_y_, t210_, t212_);
        let a_load_force_x_ = b_load_force_x_ - t213_;
        let t214_ = minus_a_axes_x_y_ * t211_;
        let t215_ = T::mul_neg_add(a_axes_x_x_, t210_, t214_);
        let minus_a_load_force_y_ = minus_b_load_force_y_ + t215_;
        /// Load on `crank_pin`, [P, Eqs. (18), (19)]: 7 mul, 6 add, 0 reciprocal.
        let t216_ = crank_pin_rate_ * c_(0.1);
        let t217_ = T::mul_sub(crank_pin_rate_, t216_, crank_pin_a_lin_x_);
        let t218_ = cos_crank_pin_angle_ * t217_;
        let t219_ = T::mul_neg_add(
            c_(0.1),
            minus_crank_pin_a_ang_z_,
            crank_pin_a_lin_y_,
        );
        let t220_ = T::mul_add(sin_crank_pin_angle_, t219_, t218_);
        let crank_pin_load_force_x_ = a_load_force_x_ - t220_;
        let t221_ = sin_crank_pin_angle_ * t217_;
        let t222_ = T::mul_neg_add(cos_crank_pin_angle_, t219_, t221_);
        let minus_crank_pin_load_force_y_ = minus_a_load_force_y_ + t222_;
        /// Results: 44 mul, 35 add, 0 reciprocal.
        let t223_ = minus_crank_pin_a_ang_z_ + a_a_ang_z_;
        let t224_ = a_a_ang_z_ + minus_b_a_ang_z_;
        let t225_ = c_(4.0) + t15_;
        let t226_ = t14_ - t225_;
        let t227_ = T::mul_neg_add(
            c_(0.04000000000000001),
            t226_,
            c_(0.030000000000000006),
        );
        let t228_ = cos_crank_pin_angle_ * c_(0.1);
        let t229_ = sin_crank_pin_angle_ * c_(0.1);
        let t230_ = t190_ + t196_;
        let t231_ = t188_ + t194_;
        let t232_ = crank_pin_rate_ * t229_;
        let t233_ = crank_pin_rate_ * t228_;
        let t234_ = crank_pin_rate_ * c_(0.01);
        let t235_ = crank_pin_rate_ * t234_;
        let t236_ = t233_ * t233_;
        let t237_ = a_axes_x_x_ * c_(0.3);
        let t238_ = minus_a_axes_x_y_ * c_(0.3);
        let t239_ = T::mul_add(a_omega_z_, t238_, t190_);
        let t240_ = T::mul_add(a_omega_z_, t237_, t188_);
        let t241_ = a_omega_z_ * c_(0.06);
        let t242_ = t239_ * t239_;
        let t243_ = T::mul_add(t240_, t240_, t242_);
        let t244_ = b_axes_x_x_ * c_(0.3);
        let t245_ = minus_b_axes_x_y_ * c_(0.3);
        let t246_ = T::mul_add(b_omega_z_, t245_, t230_);
        let t247_ = T::mul_add(b_omega_z_, t244_, t231_);
        let t248_ = b_omega_z_ * c_(0.06);
        let t249_ = t246_ * t246_;
        let t250_ = T::mul_add(t247_, t247_, t249_);
        let t251_ = T::mul_add(b_omega_z_, t248_, t235_);
        let t252_ = T::mul_add(t232_, t232_, t251_);
        let t253_ = T::mul_add(c_(2.0), t250_, t252_);
        let t254_ = T::mul_add(a_omega_z_, t241_, t236_);
        let t255_ = T::mul_add(c_(2.0), t243_, t254_);
        let t256_ = t253_ + t255_;
        let t257_ = c_(0.5) * t256_;
        let t258_ = t189_ + t195_;
        let t259_ = sin_crank_pin_angle_ * c_(0.9800000000000001);
        let t260_ = t189_ + t238_;
        let t261_ = t258_ + t260_;
        let t262_ = t245_ + t261_;
        let t263_ = T::mul_add(c_(19.6), t262_, t259_);
        let t264_ = cos_rocker_pin_angle_ * t133_;
        let t265_ = sin_rocker_pin_angle_ * t133_;
        let t266_ = cos_rocker_pin_angle_ * t142_;
        let t267_ = T::mul_add(sin_rocker_pin_angle_, t143_, t266_);
        let t268_ = sin_rocker_pin_angle_ * t142_;
        let t269_ = T::mul_neg_add(cos_rocker_pin_angle_, t143_, t268_);
        let t270_ = t187_ + t193_;
        let t271_ = c_(0.6) * b_axes_x_x_;
        let t272_ = t271_ + t270_;
        let t273_ = c_(0.6) * minus_b_axes_x_y_;
        let t274_ = t273_ + t258_;
        let t275_ = b_omega_z_ * t273_;
        let t276_ = t230_ + t275_;
        let t277_ = b_omega_z_ * t271_;
        let t278_ = t231_ + t277_;
        let t279_ = T::mul_add(b_omega_z_, t277_, minus_b_acc_lin_x_);
        let t280_ = T::mul_sub(minus_b_a_ang_z_, t273_, t279_);
        let t281_ = T::mul_sub(b_omega_z_, t275_, b_acc_lin_y_);
        let t282_ = T::mul_add(minus_b_a_ang_z_, t271_, t281_);
        ::mstmm::generated::finite::<
            T,
        >(
            &[
                state_.q.as_slice(),
                state_.v.as_slice(),
                &[state_.t],
                &[inputs_.crank_pin],
            ],
        )?;
        ::mstmm::generated::regular::<
            T,
            _,
            _,
        >(
            &["a", "crank_pin"],
            [a_j_zz_, crank_pin_j_zz_],
            [c_(2.04), t227_],
            [-minus_crank_pin_a_ang_z_, t223_, -t224_, minus_b_a_ang_z_],
        )?;
        at_.accelerations.data.0 = [
            [-minus_crank_pin_a_ang_z_, t223_, -t224_, minus_b_a_ang_z_],
        ];
        at_.rate_accelerations.data.0 = [
            [-minus_crank_pin_a_ang_z_, t223_, -t224_, minus_b_a_ang_z_],
        ];
        at_.efforts.data.0 = [[crank_pin_input0_, c_(0.0), c_(0.0), c_(0.0)]];
        at_.closure = ::mstmm::generated::closure([
            [t264_, t265_, c_(0.0), c_(0.0), c_(0.0), c_(0.0)],
            [-t267_, -t269_, c_(0.0), c_(0.0), c_(0.0), c_(0.0)],
        ]);
        at_.kinetic_energy = t257_;
        at_.potential_energy = t263_;
        at_.points = [
            ::mstmm::PlanePoint::new(
                [c_(0.0), c_(0.0)],
                [c_(1.0), c_(0.0)],
                [c_(0.0), c_(0.0)],
                c_(0.0),
                ::mstmm::PlaneStateVector::new(
                    [c_(0.0), c_(0.0)],
                    c_(0.0),
                    -crank_pin_input0_,
                    [crank_pin_load_force_x_, -minus_crank_pin_load_force_y_],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [c_(0.0), c_(0.0)],
                [cos_crank_pin_angle_, sin_crank_pin_angle_],
                [c_(0.0), c_(0.0)],
                crank_pin_rate_,
                ::mstmm::PlaneStateVector::new(
                    [c_(0.0), c_(0.0)],
                    -minus_crank_pin_a_ang_z_,
                    -crank_pin_input0_,
                    [crank_pin_load_force_x_, -minus_crank_pin_load_force_y_],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t187_, t189_],
                [cos_crank_pin_angle_, sin_crank_pin_angle_],
                [-t190_, t188_],
                crank_pin_rate_,
                ::mstmm::PlaneStateVector::new(
                    [-minus_a_acc_lin_x_, -minus_a_acc_lin_y_],
                    -minus_crank_pin_a_ang_z_,
                    c_(0.0),
                    [a_load_force_x_, -minus_a_load_force_y_],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t187_, t189_],
                [a_axes_x_x_, minus_a_axes_x_y_],
                [-t190_, t188_],
                a_omega_z_,
                ::mstmm::PlaneStateVector::new(
                    [-minus_a_acc_lin_x_, -minus_a_acc_lin_y_],
                    a_a_ang_z_,
                    c_(0.0),
                    [a_load_force_x_, -minus_a_load_force_y_],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t270_, t258_],
                [a_axes_x_x_, minus_a_axes_x_y_],
                [-t230_, t231_],
                a_omega_z_,
                ::mstmm::PlaneStateVector::new(
                    [-minus_b_acc_lin_x_, b_acc_lin_y_],
                    a_a_ang_z_,
                    c_(0.0),
                    [b_load_force_x_, -minus_b_load_force_y_],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t270_, t258_],
                [b_axes_x_x_, minus_b_axes_x_y_],
                [-t230_, t231_],
                b_omega_z_,
                ::mstmm::PlaneStateVector::new(
                    [-minus_b_acc_lin_x_, b_acc_lin_y_],
                    -minus_b_a_ang_z_,
                    c_(0.0),
                    [b_load_force_x_, -minus_b_load_force_y_],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t272_, t274_],
                [b_axes_x_x_, minus_b_axes_x_y_],
                [-t276_, t278_],
                b_omega_z_,
                ::mstmm::PlaneStateVector::new(
                    [t280_, -t282_],
                    -minus_b_a_ang_z_,
                    c_(0.0),
                    [rocker_pin_load_force_x_, rocker_pin_load_force_y_],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [c_(0.8), c_(0.0)],
                [c_(1.0), c_(0.0)],
                [c_(0.0), c_(0.0)],
                c_(0.0),
                ::mstmm::PlaneStateVector::new(
                    [c_(0.0), c_(0.0)],
                    c_(0.0),
                    c_(0.0),
                    [rocker_pin_load_force_x_, rocker_pin_load_force_y_],
                ),
            ),
        ];
        ::core::result::Result::Ok(())
    }
    /// Kinetic and potential energy in J; the potential of gravity is zero with every centre
    /// of mass at the inertial origin.
    ///
    /// 70 operations: 46 mul, 24 add, 0 reciprocal, 3 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 3 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 4 | 3 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 4 | 3 | 0 | 0 | 0 |
    /// | Results |  | 38 | 18 | 0 | 0 | 0 |
    #[must_use]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn energy(&self, state_: &FourBarState<T>) -> ::mstmm::Energy<T> {
        let c_ = T::constant;
        let [[crank_pin_angle_, a_angle_, b_angle_, ..]] = state_.q.data.0;
        let [[crank_pin_rate_, a_rate_, b_rate_, ..]] = state_.v.data.0;
        /// Motion across `crank_pin`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 3 sin/cos.
        let (
            [sin_crank_pin_angle_,
            sin_a_angle_,
            sin_b_angle_,
            ],
            [cos_crank_pin_angle_,
            cos_a_angle_,
            cos_b_angle_,
            ],
        ) = T::sin_cos([crank_pin_angle_, a_angle_, b_angle_]);
        /// Motion across `a`, [P, Eqs. (1), (13), (36)]: 4 mul, 3 add, 0 reciprocal.
        let t0_ = cos_crank_pin_angle_ * cos_a_angle_;
        let a_axes_x_x_ = T::mul_neg_add(sin_crank_pin_angle_, sin_a_angle_, t0_);
        let t1_ = cos_crank_pin_angle_ * sin_a_angle_;
        let minus_a_axes_x_y_ = T::mul_add(sin_crank_pin_angle_, cos_a_angle_, t1_);
        let a_omega_z_ = crank_pin_rate_ + a_rate_;
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 4 mul, 3 add, 0 reciprocal.
        let t2_ = cos_b_angle_ * a_axes_x_x_;
        let b_axes_x_x_ = T::mul_neg_add(sin_b_angle_, minus_a_axes_x_y_, t2_);
        let t3_ = sin_b_angle_ * a_axes_x_x_;
        let minus_b_axes_x_y_ = T::mul_add(cos_b_angle_, minus_a_axes_x_y_, t3_);
        let b_omega_z_ = b_rate_ + a_omega_z_;
        /// Results: 38 mul, 18 add, 0 reciprocal.
        let t4_ = cos_crank_pin_angle_ * c_(0.1);
        let t5_ = sin_crank_pin_angle_ * c_(0.1);
        let t6_ = cos_crank_pin_angle_ * c_(0.2);
        let t7_ = sin_crank_pin_angle_ * c_(0.2);
        let t8_ = crank_pin_rate_ * t7_;
        let t9_ = crank_pin_rate_ * t6_;
        let t10_ = c_(0.6) * a_axes_x_x_;
        let t11_ = c_(0.6) * minus_a_axes_x_y_;
        let t12_ = T::mul_add(a_omega_z_, t11_, t8_);
        let t13_ = T::mul_add(a_omega_z_, t10_, t9_);
        let t14_ = crank_pin_rate_ * t5_;
        let t15_ = crank_pin_rate_ * t4_;
        let t16_ = crank_pin_rate_ * c_(0.01);
        let t17_ = crank_pin_rate_ * t16_;
        let t18_ = t15_ * t15_;
        let t19_ = a_axes_x_x_ * c_(0.3);
        let t20_ = minus_a_axes_x_y_ * c_(0.3);
        let t21_ = T::mul_add(a_omega_z_, t20_, t8_);
        let t22_ = T::mul_add(a_omega_z_, t19_, t9_);
        let t23_ = a_omega_z_ * c_(0.06);
        let t24_ = t21_ * t21_;
        let t25_ = T::mul_add(t22_, t22_, t24_);
        let t26_ = b_axes_x_x_ * c_(0.3);
        let t27_ = minus_b_axes_x_y_ * c_(0.3);
        let t28_ = T::mul_add(b_omega_z_, t27_, t12_);
        let t29_ = T::mul_add(b_omega_z_, t26_, t13_);
        let t30_ = b_omega_z_ * c_(0.06);
        let t31_ = t28_ * t28_;
        let t32_ = T::mul_add(t29_, t29_, t31_);
        let t33_ = T::mul_add(b_omega_z_, t30_, t17_);
        let t34_ = T::mul_add(t14_, t14_, t33_);
        let t35_ = T::mul_add(c_(2.0), t32_, t34_);
        let t36_ = T::mul_add(a_omega_z_, t23_, t18_);
        let t37_ = T::mul_add(c_(2.0), t25_, t36_);
        let t38_ = t35_ + t37_;
        let t39_ = c_(0.5) * t38_;
        let t40_ = sin_crank_pin_angle_ * c_(0.9800000000000001);
        let t41_ = T::mul_add(sin_crank_pin_angle_, c_(0.4), t20_);
        let t42_ = t11_ + t41_;
        let t43_ = t27_ + t42_;
        let t44_ = T::mul_add(c_(19.6), t43_, t40_);
        ::mstmm::Energy {
            kinetic: t39_,
            potential: t44_,
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
        state_: &FourBarState<T>,
        inputs_: &FourBarInputs<T>,
        rate_: &mut FourBarState<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.accelerations_into(state_, inputs_, &mut rate_.v)?;
        self.configuration_rate_into(state_, rate_);
        ::core::result::Result::Ok(())
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn configuration_rate_into(
        &self,
        state_: &FourBarState<T>,
        rate_: &mut FourBarState<T>,
    ) {
        rate_.q.data.0 = {
            let [[crank_pin_rate_, a_rate_, b_rate_, rocker_pin_rate_]] = state_
                .v
                .data
                .0;
            [[crank_pin_rate_, a_rate_, b_rate_, rocker_pin_rate_]]
        };
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn normalize(&self, state_: &mut FourBarState<T>) {
        state_.q.data.0 = {
            let [[crank_pin_angle_, a_angle_, b_angle_, rocker_pin_angle_]] = state_
                .q
                .data
                .0;
            [[crank_pin_angle_, a_angle_, b_angle_, rocker_pin_angle_]]
        };
    }
    #[inline]
    fn close(
        &self,
        state_: &mut FourBarState<T>,
        inputs_: impl ::core::ops::FnOnce(&FourBarState<T>) -> FourBarInputs<T>,
    ) {
        let inputs_ = inputs_(state_);
        self.correct(state_, &inputs_);
    }
}
#[allow(dead_code)]
impl<T: ::mstmm::Scalar> FourBar<T> {
    /// Corrects coordinates and rates once by the smallest motion that closes the
    /// chain, and returns how far it was from closed.
    ///
    /// 340 operations: 198 mul, 125 add, 9 reciprocal, 8 square root, 5 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 8 | 3 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 8 | 9 | 0 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 119 | 61 | 7 | 6 | 0 |
    /// | Acceleration of `crank_pin` | \[P, Eqs. (13), (36), (44)\] | 2 | 1 | 0 | 0 | 0 |
    /// | Acceleration of `a` | \[P, Eqs. (13), (36), (44)\] | 7 | 3 | 0 | 0 | 0 |
    /// | Acceleration of `b` | \[P, Eqs. (13), (36), (44)\] | 6 | 4 | 0 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 23 | 12 | 0 | 0 | 0 |
    /// | Acceleration of `crank_pin` | \[P, Eqs. (13), (36), (44)\] | 2 | 1 | 0 | 0 | 0 |
    /// | Acceleration of `a` | \[P, Eqs. (13), (36), (44)\] | 7 | 3 | 0 | 0 | 0 |
    /// | Acceleration of `b` | \[P, Eqs. (13), (36), (44)\] | 6 | 4 | 0 | 0 | 0 |
    /// | Results |  | 10 | 22 | 1 | 2 | 1 |
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn correct(&self, state_: &mut FourBarState<T>, inputs_: &FourBarInputs<T>) -> T {
        let c_ = T::constant;
        let [[crank_pin_angle_, a_angle_, b_angle_, rocker_pin_angle_]] = state_
            .q
            .data
            .0;
        let [[crank_pin_rate_, a_rate_, b_rate_, rocker_pin_rate_]] = state_.v.data.0;
        /// Motion across `crank_pin`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 4 sin/cos.
        let (
            [sin_crank_pin_angle_,
            sin_a_angle_,
            sin_b_angle_,
            sin_rocker_pin_angle_,
            ],
            [cos_crank_pin_angle_,
            cos_a_angle_,
            cos_b_angle_,
            cos_rocker_pin_angle_,
            ],
        ) = T::sin_cos([crank_pin_angle_, a_angle_, b_angle_, rocker_pin_angle_]);
        /// Motion across `a`, [P, Eqs. (1), (13), (36)]: 0 mul, 1 add, 0 reciprocal.
        let a_omega_z_ = crank_pin_rate_ + a_rate_;
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 0 mul, 1 add, 0 reciprocal.
        let b_omega_z_ = b_rate_ + a_omega_z_;
        /// Riccati transfer over `a`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 8 mul, 3 add, 1 reciprocal.
        let t0_ = sin_b_angle_ * c_(1.5);
        let a_k_xy_ = cos_b_angle_ * t0_;
        let a_b_x_z_ = c_(0.6) * a_k_xy_;
        let t1_ = sin_b_angle_ * t0_;
        let t2_ = c_(0.5) + t1_;
        let a_b_y_z_ = T::mul_add(c_(0.6), t2_, c_(0.6));
        let a_j_zz_ = T::mul_add(c_(0.36), t2_, c_(0.24));
        let t3_ = T::recip(a_j_zz_);
        let a_z0_force_x_ = a_b_x_z_ * t3_;
        let a_z0_force_y_ = a_b_y_z_ * t3_;
        /// Riccati transfer over `crank_pin`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 8 mul, 9 add, 0 reciprocal.
        let t4_ = t1_ - c_(4.0);
        let t5_ = c_(2.5) + t1_;
        let t6_ = T::mul_add(a_b_x_z_, a_z0_force_x_, t4_);
        let t7_ = T::mul_neg_add(a_b_y_z_, a_z0_force_y_, t5_);
        let t8_ = T::mul_neg_add(a_b_y_z_, a_z0_force_x_, a_k_xy_);
        let t9_ = t6_ + t7_;
        let t10_ = sin_a_angle_ * t9_;
        let t11_ = c_(2.0) * t8_;
        let t12_ = T::mul_neg_add(cos_a_angle_, t11_, t10_);
        let t13_ = T::mul_neg_add(sin_a_angle_, t12_, t7_);
        let crank_pin_j_zz_ = T::mul_add(
            c_(0.04000000000000001),
            t13_,
            c_(0.020000000000000004),
        );
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 119 mul, 61 add, 7 reciprocal, 6 square root.
        let t14_ = c_(0.6) * sin_rocker_pin_angle_;
        let t15_ = sin_rocker_pin_angle_ * c_(2.5);
        let t16_ = T::mul_neg_add(sin_rocker_pin_angle_, c_(1.5), sin_rocker_pin_angle_);
        let t17_ = t14_ * t15_;
        let t18_ = cos_b_angle_ * cos_rocker_pin_angle_;
        let t19_ = T::mul_neg_add(sin_b_angle_, t16_, t18_);
        let t20_ = sin_b_angle_ * cos_rocker_pin_angle_;
        let t21_ = T::mul_add(cos_b_angle_, t16_, t20_);
        let t22_ = c_(0.6) * t21_;
        let t23_ = t22_ * t3_;
        let t24_ = T::mul_neg_add(t22_, a_z0_force_x_, t19_);
        let t25_ = T::mul_neg_add(t22_, a_z0_force_y_, t21_);
        let t26_ = T::mul_add(t22_, t23_, t17_);
        let t27_ = sin_a_angle_ * t24_;
        let t28_ = T::mul_add(cos_a_angle_, t25_, t27_);
        let t29_ = c_(0.2) * t28_;
        let t30_ = T::recip(crank_pin_j_zz_);
        let t31_ = t29_ * t30_;
        let closure_d0_ = T::mul_add(t29_, t31_, t26_);
        let t32_ = c_(0.6) * cos_rocker_pin_angle_;
        let t33_ = cos_rocker_pin_angle_ * c_(2.5);
        let t34_ = cos_rocker_pin_angle_ * cos_rocker_pin_angle_;
        let t35_ = T::mul_add(sin_rocker_pin_angle_, sin_rocker_pin_angle_, t34_);
        let t36_ = t35_ * c_(0.36);
        let t37_ = T::mul_add(t14_, t14_, t36_);
        let t38_ = t37_ * c_(4.166666666666667);
        let t39_ = T::mul_neg_add(cos_rocker_pin_angle_, c_(1.5), cos_rocker_pin_angle_);
        let t40_ = t32_ * t15_;
        let t41_ = t32_ * t33_;
        let t42_ = cos_b_angle_ * sin_rocker_pin_angle_;
        let t43_ = T::mul_add(sin_b_angle_, t39_, t42_);
        let t44_ = sin_b_angle_ * sin_rocker_pin_angle_;
        let t45_ = T::mul_neg_add(cos_b_angle_, t39_, t44_);
        let t46_ = c_(0.6) * t45_;
        let t47_ = t46_ * t3_;
        let t48_ = t19_ * t19_;
        let t49_ = T::mul_add(t21_, t21_, t48_);
        let t50_ = t22_ * t22_;
        let t51_ = T::mul_add(t49_, c_(0.72), t50_);
        let t52_ = T::mul_add(t3_, t51_, t38_);
        let t53_ = T::mul_neg_add(t46_, a_z0_force_x_, t43_);
        let t54_ = T::mul_neg_add(t46_, a_z0_force_y_, t45_);
        let t55_ = T::mul_neg_add(t46_, t23_, t40_);
        let t56_ = T::mul_add(t46_, t47_, t41_);
        let t57_ = cos_a_angle_ * t24_;
        let t58_ = T::mul_neg_add(sin_a_angle_, t25_, t57_);
        let t59_ = sin_a_angle_ * t53_;
        let t60_ = T::mul_add(cos_a_angle_, t54_, t59_);
        let t61_ = c_(0.2) * t60_;
        let t62_ = t61_ * t30_;
        let t63_ = t58_ * t58_;
        let t64_ = T::mul_add(t28_, t28_, t63_);
        let t65_ = t29_ * t29_;
        let t66_ = T::mul_add(t64_, c_(0.76), t65_);
        let t67_ = T::mul_add(t30_, t66_, t52_);
        let t68_ = T::mul_neg_add(t61_, t31_, t55_);
        let t69_ = T::mul_add(t61_, t62_, t56_);
        let t70_ = T::copysign(closure_d0_, c_(1.0));
        let t71_ = closure_d0_ + t70_;
        let t72_ = c_(0.5) * t71_;
        let t73_ = T::sqrt(t72_);
        let t74_ = T::sqrt(t67_);
        let t75_ = ::mstmm::generated::recip_above(t73_, t74_);
        let t76_ = t73_ * t75_;
        let t77_ = ::mstmm::generated::recip_above(closure_d0_, closure_d0_);
        let t78_ = t76_ * t77_;
        let t79_ = t68_ * t78_;
        let closure_d1_ = T::mul_neg_add(t68_, t79_, t69_);
        let t80_ = T::mul_add(t32_, t32_, t36_);
        let t81_ = c_(4.166666666666667) * t80_;
        let t82_ = t43_ * t43_;
        let t83_ = T::mul_add(t45_, t45_, t82_);
        let t84_ = t46_ * t46_;
        let t85_ = T::mul_add(c_(0.72), t83_, t84_);
        let t86_ = T::mul_add(t3_, t85_, t81_);
        let t87_ = cos_a_angle_ * t53_;
        let t88_ = T::mul_neg_add(sin_a_angle_, t54_, t87_);
        let t89_ = t88_ * t88_;
        let t90_ = T::mul_add(t60_, t60_, t89_);
        let t91_ = t61_ * t61_;
        let t92_ = T::mul_add(c_(0.76), t90_, t91_);
        let t93_ = T::mul_add(t30_, t92_, t86_);
        let t94_ = T::copysign(closure_d1_, c_(1.0));
        let t95_ = closure_d1_ + t94_;
        let t96_ = c_(0.5) * t95_;
        let t97_ = T::sqrt(t96_);
        let t98_ = T::sqrt(t93_);
        let t99_ = ::mstmm::generated::recip_above(t97_, t98_);
        let t100_ = t97_ * t99_;
        let t101_ = ::mstmm::generated::recip_above(closure_d1_, t69_);
        let t102_ = t100_ * t101_;
        let t103_ = T::mul_neg_add(closure_d0_, t78_, c_(1.0));
        let t104_ = t103_ * t103_;
        let t105_ = ::mstmm::generated::recip_above(t104_, c_(1.0));
        let t106_ = T::sqrt(t105_);
        let t107_ = t103_ * t106_;
        let t108_ = T::mul_neg_add(closure_d1_, t102_, c_(1.0));
        let t109_ = t79_ * t108_;
        let t110_ = t107_ * t109_;
        let t111_ = T::mul_neg_add(t107_, t110_, t109_);
        let t112_ = t111_ * t111_;
        let t113_ = T::mul_add(t108_, t108_, t112_);
        let t114_ = ::mstmm::generated::recip_above(t113_, c_(1.0));
        let t115_ = T::sqrt(t114_);
        let t116_ = t111_ * t115_;
        let t117_ = t108_ * t115_;
        let t118_ = cos_crank_pin_angle_ * cos_a_angle_;
        let t119_ = T::mul_neg_add(sin_crank_pin_angle_, sin_a_angle_, t118_);
        let t120_ = cos_crank_pin_angle_ * sin_a_angle_;
        let t121_ = T::mul_add(sin_crank_pin_angle_, cos_a_angle_, t120_);
        let t122_ = sin_crank_pin_angle_ * c_(0.2);
        let t123_ = cos_b_angle_ * t119_;
        let t124_ = T::mul_neg_add(sin_b_angle_, t121_, t123_);
        let t125_ = sin_b_angle_ * t119_;
        let t126_ = T::mul_add(cos_b_angle_, t121_, t125_);
        let t127_ = cos_rocker_pin_angle_ * t124_;
        let t128_ = T::mul_neg_add(sin_rocker_pin_angle_, t126_, t127_);
        let t129_ = sin_rocker_pin_angle_ * t124_;
        let t130_ = T::mul_add(cos_rocker_pin_angle_, t126_, t129_);
        let t131_ = t121_ + t126_;
        let t132_ = T::mul_add(c_(0.6), t131_, t122_);
        let t133_ = t119_ + t124_;
        let t134_ = T::mul_neg_add(cos_crank_pin_angle_, c_(0.2), c_(0.8));
        let t135_ = T::mul_sub(c_(0.6), t133_, t134_);
        let t136_ = t128_ * t135_;
        let t137_ = T::mul_add(t130_, t132_, t136_);
        let t138_ = t130_ * t135_;
        let t139_ = T::mul_neg_add(t128_, t132_, t138_);
        let t140_ = T::mul_add(t79_, t137_, t139_);
        let t141_ = t78_ * t137_;
        let t142_ = t102_ * t140_;
        let t143_ = T::mul_add(t79_, t142_, t141_);
        let t144_ = t107_ * t143_;
        let t145_ = T::mul_neg_add(t107_, t144_, t143_);
        let t146_ = t116_ * t145_;
        let t147_ = T::mul_add(t117_, t142_, t146_);
        let closure_reaction0_ = T::mul_neg_add(t116_, t147_, t145_);
        let minus_closure_reaction1_ = T::mul_neg_add(t117_, t147_, t142_);
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 2 mul, 1 add, 0 reciprocal.
        let t148_ = t31_ * closure_reaction0_;
        let minus_crank_pin_a_ang_z_ = T::mul_add(t62_, minus_closure_reaction1_, t148_);
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 7 mul, 3 add, 0 reciprocal.
        let t149_ = c_(0.2) * minus_crank_pin_a_ang_z_;
        let minus_a_a_lin_x_ = sin_a_angle_ * t149_;
        let minus_a_a_lin_y_ = cos_a_angle_ * t149_;
        let t150_ = t23_ * closure_reaction0_;
        let t151_ = T::mul_add(t47_, minus_closure_reaction1_, t150_);
        let t152_ = T::mul_sub(a_z0_force_y_, minus_a_a_lin_y_, t151_);
        let a_a_ang_z_ = T::mul_add(a_z0_force_x_, minus_a_a_lin_x_, t152_);
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 6 mul, 4 add, 0 reciprocal.
        let t153_ = sin_b_angle_ * minus_a_a_lin_x_;
        let t154_ = T::mul_neg_add(c_(0.6), a_a_ang_z_, minus_a_a_lin_y_);
        let b_a_lin_y_ = T::mul_neg_add(cos_b_angle_, t154_, t153_);
        let t155_ = t15_ * closure_reaction0_;
        let t156_ = T::mul_neg_add(t33_, minus_closure_reaction1_, t155_);
        let minus_b_a_ang_z_ = T::mul_add(c_(2.5), b_a_lin_y_, t156_);
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 23 mul, 12 add, 0 reciprocal.
        let t157_ = crank_pin_rate_ * c_(0.2);
        let t158_ = a_omega_z_ * c_(0.6);
        let t159_ = c_(0.6) * b_omega_z_;
        let t160_ = sin_a_angle_ * t157_;
        let t161_ = T::mul_add(cos_a_angle_, t157_, t158_);
        let t162_ = cos_b_angle_ * t160_;
        let t163_ = T::mul_add(sin_b_angle_, t161_, t162_);
        let t164_ = cos_rocker_pin_angle_ * t163_;
        let t165_ = sin_rocker_pin_angle_ * t163_;
        let t166_ = T::mul_neg_add(sin_b_angle_, t160_, t159_);
        let t167_ = T::mul_add(cos_b_angle_, t161_, t166_);
        let t168_ = T::mul_add(sin_rocker_pin_angle_, t167_, t164_);
        let t169_ = T::mul_neg_add(cos_rocker_pin_angle_, t167_, t165_);
        let t170_ = T::mul_add(t79_, t168_, t169_);
        let t171_ = t78_ * t168_;
        let t172_ = t102_ * t170_;
        let t173_ = T::mul_add(t79_, t172_, t171_);
        let t174_ = t107_ * t173_;
        let t175_ = T::mul_neg_add(t107_, t174_, t173_);
        let t176_ = t116_ * t175_;
        let t177_ = T::mul_add(t117_, t172_, t176_);
        let closure_reaction0_2_ = T::mul_neg_add(t116_, t177_, t175_);
        let minus_closure_reaction1_2_ = T::mul_neg_add(t117_, t177_, t172_);
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 2 mul, 1 add, 0 reciprocal.
        let t178_ = t31_ * closure_reaction0_2_;
        let minus_crank_pin_a_ang_z_2_ = T::mul_add(
            t62_,
            minus_closure_reaction1_2_,
            t178_,
        );
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 7 mul, 3 add, 0 reciprocal.
        let t179_ = c_(0.2) * minus_crank_pin_a_ang_z_2_;
        let minus_a_a_lin_x_2_ = sin_a_angle_ * t179_;
        let minus_a_a_lin_y_2_ = cos_a_angle_ * t179_;
        let t180_ = t23_ * closure_reaction0_2_;
        let t181_ = T::mul_add(t47_, minus_closure_reaction1_2_, t180_);
        let t182_ = T::mul_sub(a_z0_force_y_, minus_a_a_lin_y_2_, t181_);
        let a_a_ang_z_2_ = T::mul_add(a_z0_force_x_, minus_a_a_lin_x_2_, t182_);
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 6 mul, 4 add, 0 reciprocal.
        let t183_ = sin_b_angle_ * minus_a_a_lin_x_2_;
        let t184_ = T::mul_neg_add(c_(0.6), a_a_ang_z_2_, minus_a_a_lin_y_2_);
        let b_a_lin_y_2_ = T::mul_neg_add(cos_b_angle_, t184_, t183_);
        let t185_ = t15_ * closure_reaction0_2_;
        let t186_ = T::mul_neg_add(t33_, minus_closure_reaction1_2_, t185_);
        let minus_b_a_ang_z_2_ = T::mul_add(c_(2.5), b_a_lin_y_2_, t186_);
        /// Results: 10 mul, 22 add, 1 reciprocal, 2 square root, 1 sin/cos.
        let t187_ = crank_pin_angle_ - minus_crank_pin_a_ang_z_;
        let t188_ = a_angle_ + minus_crank_pin_a_ang_z_;
        let t189_ = t188_ + a_a_ang_z_;
        let t190_ = b_angle_ - a_a_ang_z_;
        let t191_ = minus_b_a_ang_z_ - t190_;
        let t192_ = T::mul_add(t130_, t130_, c_(0.000000000000000000000000000001));
        let t193_ = T::sqrt(t192_);
        let t194_ = T::atan2(t193_, t128_);
        let t195_ = T::recip(t193_);
        let t196_ = t194_ * t195_;
        let t197_ = t130_ * t196_;
        let t198_ = rocker_pin_angle_ - t197_;
        let t199_ = t198_ + minus_b_a_ang_z_;
        let t200_ = crank_pin_rate_ - minus_crank_pin_a_ang_z_2_;
        let t201_ = a_rate_ + minus_crank_pin_a_ang_z_2_;
        let t202_ = t201_ + a_a_ang_z_2_;
        let t203_ = b_rate_ - a_a_ang_z_2_;
        let t204_ = minus_b_a_ang_z_2_ - t203_;
        let t205_ = b_omega_z_ - minus_b_a_ang_z_2_;
        let t206_ = rocker_pin_rate_ + b_omega_z_;
        let t207_ = c_(1.0) - t128_;
        let t208_ = t207_ * t207_;
        let t209_ = t206_ * t206_;
        let t210_ = T::mul_add(t168_, t168_, t209_);
        let t211_ = T::mul_add(t137_, t137_, t210_);
        let t212_ = T::mul_add(t197_, t197_, t211_);
        let t213_ = T::mul_add(t169_, t169_, t208_);
        let t214_ = T::mul_add(t139_, t139_, t213_);
        let t215_ = t212_ + t214_;
        let t216_ = T::sqrt(t215_);
        let residual_ = t216_;
        state_.q.data.0 = [[t187_, t189_, -t191_, t199_]];
        state_.v.data.0 = [[t200_, t202_, -t204_, -t205_]];
        residual_
    }
}
impl<T: ::mstmm::Scalar> FourBar<T> {
    /// Closes the chain: moves `state` to coordinates and rates nearby, measured by
    /// the kinetic energy that it takes, that fulfil the closure.
    ///
    /// # Errors
    ///
    /// `Error::NotAssembled` if that leads nowhere;
    /// `state` is left as it was.
    #[allow(dead_code)]
    pub fn assemble(
        &self,
        state_: &mut FourBarState<T>,
        inputs_: &FourBarInputs<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        ::mstmm::generated::assemble(state_, |state_| self.correct(state_, inputs_))
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
        state_: &FourBarState<T>,
        inputs_: &FourBarInputs<T>,
        at_: &mut FourBarWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.solve_into(state_, inputs_, at_)
    }
    #[inline]
    fn assemble(
        &self,
        state_: &mut FourBarState<T>,
        inputs_: &FourBarInputs<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.assemble(state_, inputs_)
    }
    #[inline]
    fn energy(&self, state_: &FourBarState<T>) -> ::mstmm::Energy<T> {
        self.energy(state_)
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
        let [[q0_, ..]] = self.q.data.0;
        let [[v0_, ..]] = self.v.data.0;
        ::mstmm::PinState::new(q0_, v0_)
    }
    /// Coordinates and rates of hinge `crank_pin`, to be changed.
    #[inline]
    pub fn crank_pin_mut(&mut self) -> ::mstmm::PinStateMut<'_, T> {
        let [[q0_, ..]] = &mut self.q.data.0;
        let [[v0_, ..]] = &mut self.v.data.0;
        ::mstmm::PinStateMut::new(q0_, v0_)
    }
    /// Coordinates and rates of hinge `a`.
    #[inline]
    #[must_use]
    pub fn a(&self) -> ::mstmm::PinState<T> {
        let [[_, q1_, ..]] = self.q.data.0;
        let [[_, v1_, ..]] = self.v.data.0;
        ::mstmm::PinState::new(q1_, v1_)
    }
    /// Coordinates and rates of hinge `a`, to be changed.
    #[inline]
    pub fn a_mut(&mut self) -> ::mstmm::PinStateMut<'_, T> {
        let [[_, q1_, ..]] = &mut self.q.data.0;
        let [[_, v1_, ..]] = &mut self.v.data.0;
        ::mstmm::PinStateMut::new(q1_, v1_)
    }
    /// Coordinates and rates of hinge `b`.
    #[inline]
    #[must_use]
    pub fn b(&self) -> ::mstmm::PinState<T> {
        let [[_, _, q2_, ..]] = self.q.data.0;
        let [[_, _, v2_, ..]] = self.v.data.0;
        ::mstmm::PinState::new(q2_, v2_)
    }
    /// Coordinates and rates of hinge `b`, to be changed.
    #[inline]
    pub fn b_mut(&mut self) -> ::mstmm::PinStateMut<'_, T> {
        let [[_, _, q2_, ..]] = &mut self.q.data.0;
        let [[_, _, v2_, ..]] = &mut self.v.data.0;
        ::mstmm::PinStateMut::new(q2_, v2_)
    }
    /// Coordinates and rates of hinge `rocker_pin`.
    #[inline]
    #[must_use]
    pub fn rocker_pin(&self) -> ::mstmm::PinState<T> {
        let [[_, _, _, q3_, ..]] = self.q.data.0;
        let [[_, _, _, v3_, ..]] = self.v.data.0;
        ::mstmm::PinState::new(q3_, v3_)
    }
    /// Coordinates and rates of hinge `rocker_pin`, to be changed.
    #[inline]
    pub fn rocker_pin_mut(&mut self) -> ::mstmm::PinStateMut<'_, T> {
        let [[_, _, _, q3_, ..]] = &mut self.q.data.0;
        let [[_, _, _, v3_, ..]] = &mut self.v.data.0;
        ::mstmm::PinStateMut::new(q3_, v3_)
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for FourBarState<T> {
    fn default() -> Self {
        let (zero_, one_) = (T::constant(0.0), T::constant(1.0));
        let _ = one_;
        Self {
            q: ::mstmm::generated::vector([zero_, zero_, zero_, zero_]),
            v: ::mstmm::generated::vector([zero_; 4]),
            t: zero_,
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
    fn set_time(&mut self, time_: T) {
        self.t = time_;
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
    /// Input and output of body `crank`.
    #[inline]
    pub fn crank(&self) -> ::mstmm::BodyResult<'_, T, ::mstmm::PlanePoint<T>> {
        let [_, input_, output_, ..] = &self.points;
        ::mstmm::BodyResult::new(input_, output_)
    }
    /// Acceleration, effort, input and output of hinge `a`.
    #[inline]
    pub fn a(&self) -> ::mstmm::HingeResult<'_, T, T, ::mstmm::PlanePoint<T>> {
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
    /// Input and output of body `coupler`.
    #[inline]
    pub fn coupler(&self) -> ::mstmm::BodyResult<'_, T, ::mstmm::PlanePoint<T>> {
        let [_, _, _, input_, output_, ..] = &self.points;
        ::mstmm::BodyResult::new(input_, output_)
    }
    /// Acceleration, effort, input and output of hinge `b`.
    #[inline]
    pub fn b(&self) -> ::mstmm::HingeResult<'_, T, T, ::mstmm::PlanePoint<T>> {
        let [_, _, _, _, input_, output_, ..] = &self.points;
        ::mstmm::HingeResult::new(
            {
                let [value_] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.rate_accelerations.as_slice(), 2);
                value_
            },
            {
                let [value_] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.efforts.as_slice(), 2);
                value_
            },
            input_,
            output_,
        )
    }
    /// Input and output of body `rocker`.
    #[inline]
    pub fn rocker(&self) -> ::mstmm::BodyResult<'_, T, ::mstmm::PlanePoint<T>> {
        let [_, _, _, _, _, input_, output_, ..] = &self.points;
        ::mstmm::BodyResult::new(input_, output_)
    }
    /// Acceleration, effort, input and output of hinge `rocker_pin`.
    #[inline]
    pub fn rocker_pin(&self) -> ::mstmm::HingeResult<'_, T, T, ::mstmm::PlanePoint<T>> {
        let [_, _, _, _, _, _, input_, output_, ..] = &self.points;
        ::mstmm::HingeResult::new(
            {
                let [value_] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.rate_accelerations.as_slice(), 3);
                value_
            },
            {
                let [value_] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.efforts.as_slice(), 3);
                value_
            },
            input_,
            output_,
        )
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> FourBar<T> {
    /// Room for the results of [`solve_into`](Self::solve_into).
    #[must_use]
    pub fn workspace(&self) -> FourBarWorkspace<T> {
        let zero_ = T::constant(0.0);
        FourBarWorkspace {
            accelerations: ::mstmm::generated::vector([zero_; 4]),
            rate_accelerations: ::mstmm::generated::vector([zero_; 4]),
            efforts: ::mstmm::generated::vector([zero_; 4]),
            kinetic_energy: zero_,
            potential_energy: zero_,
            closure: ::core::default::Default::default(),
            points: [::core::default::Default::default(); 8],
        }
    }
}
const _: () = {
    #[allow(dead_code)]
    fn elements<T: ::mstmm::Scalar>() {
        let _ = FourBarWorkspace::<T>::crank_pin;
    }
};
#[allow(dead_code, non_camel_case_types, clippy::all)]
const _: () = {
    struct Crank;
    struct Bar;
    const _: Crank = Crank;
    const _: Bar = Bar;
    const _: Bar = Bar;
};
