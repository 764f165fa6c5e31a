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
/// Accelerations by `riccati`, 325 operations (195 mul, 116 add, 8 reciprocal, 6 square root, 4 sin/cos); with everything at every connection point 430 operations.
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
    /// 325 operations: 195 mul, 116 add, 8 reciprocal, 6 square root, 4 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 13 | 4 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 28 | 20 | 1 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 119 | 65 | 6 | 6 | 0 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 2 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 2 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `b` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Acceleration of `a` | \[P, Eqs. (13), (36), (44)\] | 13 | 10 | 0 | 0 | 0 |
    /// | Acceleration of `crank_pin` | \[P, Eqs. (13), (36), (44)\] | 5 | 4 | 0 | 0 | 0 |
    /// | Acceleration of `b` | \[P, Eqs. (13), (36), (44)\] | 10 | 6 | 0 | 0 | 0 |
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
        let [q_] = &state_.q.data.0;
        let [v_] = &state_.v.data.0;
        let crank_pin_input_ = &inputs_.crank_pin;
        /// Room for values until they are needed again, and references to read unknowns again.
        let mut room_ = ::mstmm::generated::room::<T, 25>();
        let (room_, self_again_, state_again_, inputs_again_) = ::mstmm::generated::in_memory::<
            T,
            _,
        >((&mut room_, self, state_, inputs_));
        let [place0_, place1_, place2_, place3_, place4_, place5_, place6_, place7_,
        place8_, place9_, place10_, place11_, place12_, place13_, place14_, place15_,
        place16_, place17_, place18_, place19_, place20_, place21_, place22_, place23_,
        place24_] = room_;
        let [q_again_] = &state_again_.q.data.0;
        let [v_again_] = &state_again_.v.data.0;
        let crank_pin_input_again_ = &inputs_again_.crank_pin;
        /// Motion across `crank_pin`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 4 sin/cos.
        let crank_pin_angle_ = q_[0];
        let a_angle_ = q_[1];
        let b_angle_ = q_[2];
        let rocker_pin_angle_ = q_[3];
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
        /// Riccati transfer over `a`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 13 mul, 4 add, 1 reciprocal.
        let t4_ = sin_b_angle_ * sin_b_angle_;
        let t5_ = c_(1.5) * t4_;
        let t6_ = t5_ + c_(0.5);
        let a_j_zz_ = T::mul_add(c_(0.36), t6_, c_(0.24));
        let t8_ = T::recip(a_j_zz_);
        let t3_ = sin_b_angle_ * cos_b_angle_;
        let a_b_y_z_ = T::mul_add(c_(0.6), t6_, c_(0.6));
        let a_b_x_z_ = t3_ * c_(0.8999999999999999);
        /// Riccati transfer over `crank_pin`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 28 mul, 20 add, 1 reciprocal.
        let t18_ = sin_a_angle_ * cos_a_angle_;
        /// Riccati transfer over `a`.
        let a_k_xy_ = c_(1.5) * t3_;
        /// Riccati transfer over `crank_pin`.
        let t13_ = a_b_y_z_ * a_b_y_z_;
        let t15_ = a_b_x_z_ * a_b_y_z_;
        let t10_ = c_(2.5) + t5_;
        let t11_ = a_b_x_z_ * a_b_x_z_;
        let t9_ = t5_ - c_(4.0);
        let t22_ = c_(2.0) * t18_;
        let t14_ = T::mul_neg_add(t8_, t13_, t10_);
        let t16_ = T::mul_neg_add(t8_, t15_, a_k_xy_);
        let t12_ = T::mul_add(t8_, t11_, t9_);
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 119 mul, 65 add, 6 reciprocal, 6 square root.
        let t36_ = T::mul_neg_add(sin_rocker_pin_angle_, c_(1.5), sin_rocker_pin_angle_);
        let t40_ = sin_b_angle_ * cos_rocker_pin_angle_;
        /// Riccati transfer over `crank_pin`.
        let t17_ = sin_a_angle_ * sin_a_angle_;
        let t23_ = T::mul_add(t16_, t22_, t14_);
        let t19_ = t12_ + t14_;
        /// Closure.
        let t38_ = cos_b_angle_ * cos_rocker_pin_angle_;
        let t41_ = T::mul_add(cos_b_angle_, t36_, t40_);
        /// Riccati transfer over `crank_pin`.
        let t24_ = T::mul_sub(t17_, t19_, t23_);
        /// Closure.
        let t39_ = T::mul_neg_add(sin_b_angle_, t36_, t38_);
        let t42_ = c_(0.6) * t41_;
        /// Riccati transfer over `a`.
        let a_z0_force_x_ = a_b_x_z_ * t8_;
        /// Riccati transfer over `crank_pin`.
        let crank_pin_j_zz_ = T::mul_neg_add(
            c_(0.04000000000000001),
            t24_,
            c_(0.020000000000000004),
        );
        /// Riccati transfer over `a`.
        let a_z0_force_y_ = a_b_y_z_ * t8_;
        /// Closure.
        let a_j_zz_spilled_ = ::mstmm::generated::spill(place0_, a_j_zz_);
        let t44_ = T::mul_neg_add(t42_, a_z0_force_x_, t39_);
        /// Riccati transfer over `crank_pin`.
        let t12_spilled_ = ::mstmm::generated::spill(place1_, t12_);
        let t32_ = T::recip(crank_pin_j_zz_);
        /// Closure.
        let crank_pin_j_zz_spilled_ = ::mstmm::generated::spill(
            place2_,
            crank_pin_j_zz_,
        );
        let t53_ = cos_rocker_pin_angle_ * cos_rocker_pin_angle_;
        let t14_spilled_ = ::mstmm::generated::spill(place3_, t14_);
        let t45_ = T::mul_neg_add(t42_, a_z0_force_y_, t41_);
        let sin_crank_pin_angle_spilled_ = ::mstmm::generated::spill(
            place4_,
            sin_crank_pin_angle_,
        );
        let t47_ = sin_a_angle_ * t44_;
        let cos_crank_pin_angle_spilled_ = ::mstmm::generated::spill(
            place5_,
            cos_crank_pin_angle_,
        );
        let t34_ = c_(0.6) * sin_rocker_pin_angle_;
        let t24_spilled_ = ::mstmm::generated::spill(place6_, t24_);
        let t35_ = sin_rocker_pin_angle_ * c_(2.5);
        let t54_ = T::mul_add(sin_rocker_pin_angle_, sin_rocker_pin_angle_, t53_);
        let t48_ = T::mul_add(cos_a_angle_, t45_, t47_);
        let t76_ = cos_a_angle_ * t44_;
        let t18_spilled_ = ::mstmm::generated::spill(place7_, t18_);
        let t37_ = t34_ * t35_;
        let t55_ = t54_ * c_(0.36);
        let t19_spilled_ = ::mstmm::generated::spill(place8_, t19_);
        let t43_ = t42_ * t8_;
        let a_b_x_z_spilled_ = ::mstmm::generated::spill(place9_, a_b_x_z_);
        let t49_ = c_(0.2) * t48_;
        let t16_spilled_ = ::mstmm::generated::spill(place10_, t16_);
        let t67_ = t39_ * t39_;
        let t77_ = T::mul_neg_add(sin_a_angle_, t45_, t76_);
        let t56_ = T::mul_add(t34_, t34_, t55_);
        let t46_ = T::mul_add(t42_, t43_, t37_);
        let t50_ = t49_ * t32_;
        let t68_ = T::mul_add(t41_, t41_, t67_);
        let t69_ = t42_ * t42_;
        let t42_spilled_ = ::mstmm::generated::spill(place11_, t42_);
        let t81_ = t77_ * t77_;
        let closure_d0_ = T::mul_add(t49_, t50_, t46_);
        let t57_ = t56_ * c_(4.166666666666667);
        let t70_ = T::mul_add(t68_, c_(0.72), t69_);
        let t82_ = T::mul_add(t48_, t48_, t81_);
        let t83_ = t49_ * t49_;
        let t48_spilled_ = ::mstmm::generated::spill(place12_, t48_);
        let t89_ = T::copysign(closure_d0_, c_(1.0));
        let t71_ = T::mul_add(t8_, t70_, t57_);
        let t84_ = T::mul_add(t82_, c_(0.76), t83_);
        let t90_ = closure_d0_ + t89_;
        let t86_ = T::mul_add(t84_, t32_, t71_);
        let t91_ = c_(0.5) * t90_;
        let t93_ = T::sqrt(t86_);
        let t92_ = T::sqrt(t91_);
        let t58_ = T::mul_neg_add(cos_rocker_pin_angle_, c_(1.5), cos_rocker_pin_angle_);
        let t63_ = sin_b_angle_ * sin_rocker_pin_angle_;
        let t61_ = cos_b_angle_ * sin_rocker_pin_angle_;
        let t64_ = T::mul_neg_add(cos_b_angle_, t58_, t63_);
        let t62_ = T::mul_add(sin_b_angle_, t58_, t61_);
        let t65_ = c_(0.6) * t64_;
        let t94_ = ::mstmm::generated::recip_above(t92_, t93_);
        let t49_spilled_ = ::mstmm::generated::spill(place13_, t49_);
        let t72_ = T::mul_neg_add(t65_, a_z0_force_x_, t62_);
        let a_z0_force_x_spilled_ = ::mstmm::generated::spill(place14_, a_z0_force_x_);
        let t96_ = ::mstmm::generated::recip_above(closure_d0_, closure_d0_);
        let t77_spilled_ = ::mstmm::generated::spill(place15_, t77_);
        let t73_ = T::mul_neg_add(t65_, a_z0_force_y_, t64_);
        let a_z0_force_y_spilled_ = ::mstmm::generated::spill(place16_, a_z0_force_y_);
        let t78_ = sin_a_angle_ * t72_;
        let t39_spilled_ = ::mstmm::generated::spill(place17_, t39_);
        let t51_ = c_(0.6) * cos_rocker_pin_angle_;
        let sin_rocker_pin_angle_spilled_ = ::mstmm::generated::spill(
            place18_,
            sin_rocker_pin_angle_,
        );
        let t52_ = cos_rocker_pin_angle_ * c_(2.5);
        let t79_ = T::mul_add(cos_a_angle_, t73_, t78_);
        let cos_rocker_pin_angle_spilled_ = ::mstmm::generated::spill(
            place19_,
            cos_rocker_pin_angle_,
        );
        let t59_ = t51_ * t35_;
        let t35_spilled_ = ::mstmm::generated::spill(place20_, t35_);
        let t60_ = t51_ * t52_;
        let t52_spilled_ = ::mstmm::generated::spill(place21_, t52_);
        let t66_ = t65_ * t8_;
        let a_b_y_z_spilled_ = ::mstmm::generated::spill(place22_, a_b_y_z_);
        let t80_ = c_(0.2) * t79_;
        let t74_ = T::mul_neg_add(t65_, t43_, t59_);
        let t95_ = t92_ * t94_;
        let t108_ = cos_a_angle_ * t72_;
        let t75_ = T::mul_add(t65_, t66_, t60_);
        let t85_ = t80_ * t32_;
        let t87_ = T::mul_neg_add(t80_, t50_, t74_);
        let t97_ = t95_ * t96_;
        let t103_ = t62_ * t62_;
        let t109_ = T::mul_neg_add(sin_a_angle_, t73_, t108_);
        let t101_ = T::mul_add(t51_, t51_, t55_);
        let t88_ = T::mul_add(t80_, t85_, t75_);
        let t98_ = t87_ * t97_;
        let t104_ = T::mul_add(t64_, t64_, t103_);
        let t105_ = t65_ * t65_;
        let t110_ = t109_ * t109_;
        let closure_d1_ = T::mul_neg_add(t87_, t98_, t88_);
        let t102_ = c_(4.166666666666667) * t101_;
        let t106_ = T::mul_add(c_(0.72), t104_, t105_);
        let t111_ = T::mul_add(t79_, t79_, t110_);
        let t112_ = t80_ * t80_;
        let t43_spilled_ = ::mstmm::generated::spill(place23_, t43_);
        let t125_ = T::copysign(closure_d1_, c_(1.0));
        let t107_ = T::mul_add(t8_, t106_, t102_);
        let t113_ = T::mul_add(c_(0.76), t111_, t112_);
        let t126_ = closure_d1_ + t125_;
        let t124_ = T::mul_add(t113_, t32_, t107_);
        let t127_ = c_(0.5) * t126_;
        let t129_ = T::sqrt(t124_);
        let t128_ = T::sqrt(t127_);
        let t134_ = T::mul_neg_add(closure_d0_, t97_, c_(1.0));
        let t135_ = t134_ * t134_;
        /// Motion across `a`, [P, Eqs. (1), (13), (36)]: 2 mul, 1 add, 0 reciprocal.
        let crank_pin_rate_ = v_[0];
        let a_rate_ = v_[1];
        let a_omega_z_ = crank_pin_rate_ + a_rate_;
        /// Closure.
        let t136_ = ::mstmm::generated::recip_above(t135_, c_(1.0));
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 2 mul, 1 add, 0 reciprocal.
        let b_rate_ = v_[2];
        let b_omega_z_ = b_rate_ + a_omega_z_;
        /// Riccati transfer over `b`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 0 add, 0 reciprocal.
        let t2_ = b_omega_z_ * b_omega_z_;
        /// Closure.
        let t130_ = ::mstmm::generated::recip_above(t128_, t129_);
        /// Motion across `b`.
        let t1_ = a_omega_z_ * a_omega_z_;
        /// Riccati transfer over `b`.
        let minus_b_e_force_x_ = c_(0.6) * t2_;
        /// Closure.
        let t132_ = ::mstmm::generated::recip_above(closure_d1_, t88_);
        /// Motion across `b`.
        let minus_b_centripetal_x_ = t1_ * c_(0.6);
        /// Riccati transfer over `a`.
        let t50_spilled_ = ::mstmm::generated::spill(place24_, t50_);
        let t7_ = sin_b_angle_ * minus_b_e_force_x_;
        /// Closure.
        let t137_ = T::sqrt(t136_);
        /// Riccati transfer over `a`.
        let minus_a_e_force_y_ = T::mul_add(minus_b_centripetal_x_, a_k_xy_, t7_);
        /// Closure.
        let t131_ = t128_ * t130_;
        /// Riccati transfer over `a`.
        let minus_a_e_moment_z_ = c_(0.6) * minus_a_e_force_y_;
        /// Riccati transfer over `crank_pin`.
        let t28_ = T::mul_add(cos_b_angle_, minus_b_e_force_x_, minus_b_centripetal_x_);
        let t25_ = t5_ - c_(2.0);
        /// Closure.
        let t133_ = t131_ * t132_;
        /// Riccati transfer over `a`.
        let a_w0_ = minus_a_e_moment_z_ * t8_;
        /// Riccati transfer over `crank_pin`.
        let t20_ = T::mul_neg_add(c_(2.0), t17_, c_(1.0));
        let t29_ = T::mul_sub(minus_b_centripetal_x_, t25_, t28_);
        /// Closure.
        let t139_ = T::mul_neg_add(closure_d1_, t133_, c_(1.0));
        /// Riccati transfer over `crank_pin`.
        let a_b_y_z_ = *a_b_y_z_spilled_;
        let t26_ = T::mul_neg_add(a_b_y_z_, a_w0_, minus_a_e_force_y_);
        /// Motion across `a`.
        let crank_pin_rate_ = v_again_[0];
        let t0_ = crank_pin_rate_ * crank_pin_rate_;
        /// Riccati transfer over `crank_pin`.
        let t16_ = *t16_spilled_;
        let t21_ = t16_ * t20_;
        let a_b_x_z_ = *a_b_x_z_spilled_;
        let t30_ = T::mul_add(a_b_x_z_, a_w0_, t29_);
        /// Closure.
        let t138_ = t134_ * t137_;
        let t140_ = t98_ * t139_;
        /// Riccati transfer over `crank_pin`.
        let t27_ = cos_a_angle_ * t26_;
        /// Motion across `a`.
        let minus_a_centripetal_x_ = t0_ * c_(0.2);
        /// Closure.
        let cos_rocker_pin_angle_ = *cos_rocker_pin_angle_spilled_;
        let t99_ = cos_rocker_pin_angle_ * minus_b_e_force_x_;
        /// Riccati transfer over `crank_pin`.
        let t18_ = *t18_spilled_;
        let t19_ = *t19_spilled_;
        let crank_pin_k_xy_ = T::mul_neg_add(t18_, t19_, t21_);
        /// Closure.
        let t141_ = t138_ * t140_;
        /// Riccati transfer over `crank_pin`.
        let t31_ = T::mul_neg_add(sin_a_angle_, t30_, t27_);
        /// Closure.
        let sin_rocker_pin_angle_ = *sin_rocker_pin_angle_spilled_;
        let t100_ = T::mul_sub(sin_rocker_pin_angle_, minus_b_e_force_x_, c_(9.8));
        let t39_ = *t39_spilled_;
        let t114_ = T::mul_add(minus_b_centripetal_x_, t39_, t99_);
        let t143_ = t139_ * t139_;
        let t142_ = T::mul_neg_add(t138_, t141_, t140_);
        /// Riccati transfer over `crank_pin`.
        let minus_crank_pin_e_force_y_ = T::mul_add(
            minus_a_centripetal_x_,
            crank_pin_k_xy_,
            t31_,
        );
        /// Closure.
        let t117_ = T::mul_add(minus_b_centripetal_x_, t62_, t100_);
        let t42_ = *t42_spilled_;
        let t115_ = T::mul_sub(t42_, a_w0_, t114_);
        /// Riccati transfer over `crank_pin`.
        let t24_ = *t24_spilled_;
        let crank_pin_b_y_z_ = T::mul_neg_add(c_(0.2), t24_, c_(0.1));
        /// Closure.
        let t144_ = T::mul_add(t142_, t142_, t143_);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_input0_ = *crank_pin_input_;
        let t33_ = T::mul_add(c_(0.2), minus_crank_pin_e_force_y_, crank_pin_input0_);
        /// Closure.
        let t118_ = T::mul_sub(t65_, a_w0_, t117_);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_b_x_z_ = c_(0.2) * crank_pin_k_xy_;
        /// Closure.
        let t77_ = *t77_spilled_;
        let t116_ = T::mul_sub(minus_a_centripetal_x_, t77_, t115_);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_z0_force_y_ = crank_pin_b_y_z_ * t32_;
        /// Closure.
        let t145_ = ::mstmm::generated::recip_above(t144_, c_(1.0));
        /// Riccati transfer over `crank_pin`.
        let crank_pin_w0_ = t33_ * t32_;
        /// Closure.
        let t119_ = T::mul_sub(minus_a_centripetal_x_, t109_, t118_);
        let cos_crank_pin_angle_ = *cos_crank_pin_angle_spilled_;
        let crank_pin_a_lin_y_ = cos_crank_pin_angle_ * c_(9.8);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_z0_force_x_ = crank_pin_b_x_z_ * t32_;
        /// Closure.
        let t49_ = *t49_spilled_;
        let t48_ = *t48_spilled_;
        let sin_b_angle_spilled_ = ::mstmm::generated::spill(place12_, sin_b_angle_);
        let t121_ = T::mul_neg_add(t49_, crank_pin_z0_force_y_, t48_);
        let t123_ = T::mul_neg_add(t80_, crank_pin_z0_force_y_, t79_);
        let t149_ = T::mul_neg_add(t49_, crank_pin_w0_, t116_);
        let t152_ = T::mul_neg_add(t80_, crank_pin_w0_, t119_);
        let sin_crank_pin_angle_ = *sin_crank_pin_angle_spilled_;
        let minus_b_centripetal_x_spilled_ = ::mstmm::generated::spill(
            place6_,
            minus_b_centripetal_x_,
        );
        let cos_b_angle_spilled_ = ::mstmm::generated::spill(place11_, cos_b_angle_);
        let crank_pin_a_lin_x_ = sin_crank_pin_angle_ * c_(9.8);
        let t120_ = T::mul_neg_add(t49_, crank_pin_z0_force_x_, t77_);
        let t122_ = T::mul_neg_add(t80_, crank_pin_z0_force_x_, t109_);
        let t150_ = T::mul_sub(crank_pin_a_lin_y_, t121_, t149_);
        let t153_ = T::mul_sub(crank_pin_a_lin_y_, t123_, t152_);
        let t151_ = T::mul_add(crank_pin_a_lin_x_, t120_, t150_);
        let t154_ = T::mul_add(crank_pin_a_lin_x_, t122_, t153_);
        let t146_ = T::sqrt(t145_);
        let t155_ = T::mul_add(t98_, t151_, t154_);
        let t156_ = t97_ * t151_;
        let t157_ = t133_ * t155_;
        let t158_ = T::mul_add(t98_, t157_, t156_);
        let t159_ = t138_ * t158_;
        let t160_ = T::mul_neg_add(t138_, t159_, t158_);
        let t147_ = t142_ * t146_;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 13 mul, 10 add, 0 reciprocal.
        let a_z0_force_x_ = *a_z0_force_x_spilled_;
        let t170_ = cos_a_angle_ * a_z0_force_x_;
        let t172_ = sin_a_angle_ * a_z0_force_x_;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 5 mul, 4 add, 0 reciprocal.
        let t163_ = sin_crank_pin_angle_ * crank_pin_z0_force_x_;
        /// Closure.
        let t148_ = t139_ * t146_;
        let t161_ = t147_ * t160_;
        /// Acceleration of `a`.
        let a_z0_force_y_ = *a_z0_force_y_spilled_;
        let t171_ = T::mul_neg_add(sin_a_angle_, a_z0_force_y_, t170_);
        let t167_ = minus_a_centripetal_x_ - crank_pin_a_lin_x_;
        let t173_ = T::mul_add(cos_a_angle_, a_z0_force_y_, t172_);
        /// Acceleration of `crank_pin`.
        let cos_crank_pin_angle_ = *cos_crank_pin_angle_spilled_;
        let t164_ = T::mul_add(cos_crank_pin_angle_, crank_pin_z0_force_y_, t163_);
        /// Closure.
        let t162_ = T::mul_add(t148_, t157_, t161_);
        /// Acceleration of `a`.
        let t175_ = T::mul_add(t167_, t171_, a_w0_);
        /// Acceleration of `crank_pin`.
        let t165_ = T::mul_sub(c_(9.8), t164_, crank_pin_w0_);
        /// Closure.
        let minus_closure_reaction1_ = T::mul_neg_add(t148_, t162_, t157_);
        /// Acceleration of `a`.
        let t176_ = T::mul_sub(crank_pin_a_lin_y_, t173_, t175_);
        /// Closure.
        let closure_reaction0_ = T::mul_neg_add(t147_, t162_, t160_);
        /// Acceleration of `crank_pin`.
        let t166_ = T::mul_add(t85_, minus_closure_reaction1_, t165_);
        /// Acceleration of `a`.
        let t177_ = T::mul_add(t66_, minus_closure_reaction1_, t176_);
        let t174_ = c_(0.2) * t173_;
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 10 mul, 6 add, 0 reciprocal.
        let t35_ = *t35_spilled_;
        let t182_ = t35_ * closure_reaction0_;
        /// Acceleration of `crank_pin`.
        let t50_ = *t50_spilled_;
        let minus_crank_pin_a_ang_z_ = T::mul_add(t50_, closure_reaction0_, t166_);
        /// Acceleration of `a`.
        let t43_ = *t43_spilled_;
        let t178_ = T::mul_add(t43_, closure_reaction0_, t177_);
        /// Acceleration of `b`.
        let cos_b_angle_ = *cos_b_angle_spilled_;
        let t181_ = cos_b_angle_ * c_(1.5);
        let minus_b_centripetal_x_ = *minus_b_centripetal_x_spilled_;
        let t183_ = T::mul_add(cos_a_angle_, t167_, minus_b_centripetal_x_);
        let t52_ = *t52_spilled_;
        let t185_ = T::mul_neg_add(t52_, minus_closure_reaction1_, t182_);
        /// Acceleration of `a`.
        let t169_ = T::mul_neg_add(
            c_(0.2),
            minus_crank_pin_a_ang_z_,
            crank_pin_a_lin_y_,
        );
        let a_a_ang_z_ = T::mul_sub(t174_, minus_crank_pin_a_ang_z_, t178_);
        /// Acceleration of `b`.
        let sin_b_angle_ = *sin_b_angle_spilled_;
        let t179_ = sin_b_angle_ * c_(2.5);
        /// Acceleration of `a`.
        let t168_ = sin_a_angle_ * t167_;
        /// Acceleration of `b`.
        let t184_ = T::mul_sub(sin_a_angle_, t169_, t183_);
        let t186_ = T::mul_add(t181_, a_a_ang_z_, t185_);
        let t180_ = cos_b_angle_ * c_(2.5);
        /// Acceleration of `a`.
        let a_a_lin_y_ = T::mul_add(cos_a_angle_, t169_, t168_);
        /// Acceleration of `b`.
        let t187_ = T::mul_sub(t179_, t184_, t186_);
        /// Results: 1 mul, 5 add, 0 reciprocal.
        let t14_ = *t14_spilled_;
        let t190_ = c_(4.0) + t14_;
        let t12_ = *t12_spilled_;
        let t191_ = t12_ - t190_;
        /// Acceleration of `b`.
        let minus_b_a_ang_z_ = T::mul_sub(t180_, a_a_lin_y_, t187_);
        /// Results.
        let t192_ = T::mul_neg_add(
            c_(0.04000000000000001),
            t191_,
            c_(0.030000000000000006),
        );
        let t188_ = minus_crank_pin_a_ang_z_ + a_a_ang_z_;
        let t189_ = a_a_ang_z_ + minus_b_a_ang_z_;
        let a_j_zz_ = *a_j_zz_spilled_;
        let crank_pin_j_zz_ = *crank_pin_j_zz_spilled_;
        if !::mstmm::generated::regular::<
            T,
            _,
            _,
        >(
            [a_j_zz_, crank_pin_j_zz_],
            [c_(2.04), t192_],
            [state_.t, state_.v.data.0[0][3], t188_, -t189_],
        ) {
            return ::core::result::Result::Err(
                ::mstmm::generated::irregular::<
                    T,
                    _,
                >(&["a", "crank_pin"], [a_j_zz_, crank_pin_j_zz_], [c_(2.04), t192_]),
            );
        }
        accelerations_.data.0 = [
            [-minus_crank_pin_a_ang_z_, t188_, -t189_, minus_b_a_ang_z_],
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
    /// Writes into `at`: accelerations, efforts, energies and, at every connection point, pose, velocity and the state vector `z`.
    ///
    /// 430 operations: 257 mul, 159 add, 8 reciprocal, 6 square root, 4 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 13 | 4 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 28 | 20 | 1 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 119 | 65 | 6 | 6 | 0 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 2 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 2 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `b` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Acceleration of `a` | \[P, Eqs. (13), (36), (44)\] | 15 | 11 | 0 | 0 | 0 |
    /// | Acceleration of `crank_pin` | \[P, Eqs. (13), (36), (44)\] | 5 | 4 | 0 | 0 | 0 |
    /// | Acceleration of `b` | \[P, Eqs. (13), (36), (44)\] | 13 | 8 | 0 | 0 | 0 |
    /// | Results |  | 16 | 13 | 0 | 0 | 0 |
    /// | Load on `crank_pin` | \[P, Eqs. (18), (19)\] | 19 | 18 | 0 | 0 | 0 |
    /// | Velocity behind `a` |  | 3 | 0 | 0 | 0 | 0 |
    /// | Connection points | \[P, Eqs. (4), (12), (13)\] | 3 | 5 | 0 | 0 | 0 |
    /// | Pose behind `a` | \[P, Eq. (12)\] | 6 | 2 | 0 | 0 | 0 |
    /// | Velocity behind `b` |  | 5 | 3 | 0 | 0 | 0 |
    /// | Pose behind `b` | \[P, Eq. (12)\] | 6 | 4 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// As [`accelerations_into`](Self::accelerations_into); `at` is then as
    /// [`workspace`](Self::workspace) makes it: results of earlier calls are gone.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn solve_into(
        &self,
        state_: &FourBarState<T>,
        inputs_: &FourBarInputs<T>,
        at_: &mut FourBarWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let [_, _, n2_, n3_, n4_, n5_, n6_, n7_, n8_, n9_, n10_, n11_, n12_, n13_, n14_,
        n15_, n16_, n17_, n18_, n19_, n20_, n21_, n22_, n23_, n24_, n25_, n26_, n27_,
        n28_, n29_, n30_, n31_, n32_, n33_, n34_, n35_, n36_, n37_, n38_, n39_, n40_,
        n41_, n42_, _, _] = &mut at_.numbers;
        let c_ = T::constant;
        let [[crank_pin_angle_, a_angle_, b_angle_, rocker_pin_angle_]] = state_
            .q
            .data
            .0;
        let [[crank_pin_rate_, a_rate_, b_rate_, ..]] = state_.v.data.0;
        let crank_pin_input0_ = inputs_.crank_pin;
        at_.efforts.data.0 = [[crank_pin_input0_, c_(0.0), c_(0.0), c_(0.0)]];
        *n2_ = crank_pin_input0_;
        *n7_ = crank_pin_rate_;
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
        *n6_ = sin_crank_pin_angle_;
        *n5_ = cos_crank_pin_angle_;
        ::mstmm::generated::written();
        /// Riccati transfer over `a`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 13 mul, 4 add, 1 reciprocal.
        let t4_ = sin_b_angle_ * sin_b_angle_;
        let t5_ = c_(1.5) * t4_;
        let t6_ = t5_ + c_(0.5);
        let a_j_zz_ = T::mul_add(c_(0.36), t6_, c_(0.24));
        let t8_ = T::recip(a_j_zz_);
        let t3_ = sin_b_angle_ * cos_b_angle_;
        let a_b_y_z_ = T::mul_add(c_(0.6), t6_, c_(0.6));
        let a_b_x_z_ = t3_ * c_(0.8999999999999999);
        /// Riccati transfer over `crank_pin`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 28 mul, 20 add, 1 reciprocal.
        let t18_ = sin_a_angle_ * cos_a_angle_;
        /// Riccati transfer over `a`.
        let a_k_xy_ = c_(1.5) * t3_;
        /// Riccati transfer over `crank_pin`.
        let t13_ = a_b_y_z_ * a_b_y_z_;
        let t15_ = a_b_x_z_ * a_b_y_z_;
        let t10_ = c_(2.5) + t5_;
        let t11_ = a_b_x_z_ * a_b_x_z_;
        let t9_ = t5_ - c_(4.0);
        let t22_ = c_(2.0) * t18_;
        let t14_ = T::mul_neg_add(t8_, t13_, t10_);
        let t16_ = T::mul_neg_add(t8_, t15_, a_k_xy_);
        let t12_ = T::mul_add(t8_, t11_, t9_);
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 119 mul, 65 add, 6 reciprocal, 6 square root.
        let t36_ = T::mul_neg_add(sin_rocker_pin_angle_, c_(1.5), sin_rocker_pin_angle_);
        let t40_ = sin_b_angle_ * cos_rocker_pin_angle_;
        /// Riccati transfer over `crank_pin`.
        let t17_ = sin_a_angle_ * sin_a_angle_;
        let t23_ = T::mul_add(t16_, t22_, t14_);
        let t19_ = t12_ + t14_;
        /// Closure.
        let t38_ = cos_b_angle_ * cos_rocker_pin_angle_;
        let t41_ = T::mul_add(cos_b_angle_, t36_, t40_);
        /// Riccati transfer over `crank_pin`.
        let t24_ = T::mul_sub(t17_, t19_, t23_);
        /// Closure.
        let t39_ = T::mul_neg_add(sin_b_angle_, t36_, t38_);
        let t42_ = c_(0.6) * t41_;
        /// Riccati transfer over `a`.
        let a_z0_force_x_ = a_b_x_z_ * t8_;
        /// Riccati transfer over `crank_pin`.
        let crank_pin_j_zz_ = T::mul_neg_add(
            c_(0.04000000000000001),
            t24_,
            c_(0.020000000000000004),
        );
        /// Riccati transfer over `a`.
        let a_z0_force_y_ = a_b_y_z_ * t8_;
        /// Closure.
        let t44_ = T::mul_neg_add(t42_, a_z0_force_x_, t39_);
        /// Riccati transfer over `crank_pin`.
        let t32_ = T::recip(crank_pin_j_zz_);
        /// Closure.
        let t53_ = cos_rocker_pin_angle_ * cos_rocker_pin_angle_;
        let t45_ = T::mul_neg_add(t42_, a_z0_force_y_, t41_);
        let t47_ = sin_a_angle_ * t44_;
        let t34_ = c_(0.6) * sin_rocker_pin_angle_;
        let t35_ = sin_rocker_pin_angle_ * c_(2.5);
        let t54_ = T::mul_add(sin_rocker_pin_angle_, sin_rocker_pin_angle_, t53_);
        let t48_ = T::mul_add(cos_a_angle_, t45_, t47_);
        let t76_ = cos_a_angle_ * t44_;
        let t37_ = t34_ * t35_;
        let t55_ = t54_ * c_(0.36);
        let t43_ = t42_ * t8_;
        let t49_ = c_(0.2) * t48_;
        let t67_ = t39_ * t39_;
        let t77_ = T::mul_neg_add(sin_a_angle_, t45_, t76_);
        let t56_ = T::mul_add(t34_, t34_, t55_);
        let t46_ = T::mul_add(t42_, t43_, t37_);
        let t50_ = t49_ * t32_;
        let t68_ = T::mul_add(t41_, t41_, t67_);
        let t69_ = t42_ * t42_;
        let t81_ = t77_ * t77_;
        let closure_d0_ = T::mul_add(t49_, t50_, t46_);
        let t57_ = t56_ * c_(4.166666666666667);
        let t70_ = T::mul_add(t68_, c_(0.72), t69_);
        let t82_ = T::mul_add(t48_, t48_, t81_);
        let t83_ = t49_ * t49_;
        let t89_ = T::copysign(closure_d0_, c_(1.0));
        let t71_ = T::mul_add(t8_, t70_, t57_);
        let t84_ = T::mul_add(t82_, c_(0.76), t83_);
        let t90_ = closure_d0_ + t89_;
        let t86_ = T::mul_add(t84_, t32_, t71_);
        let t91_ = c_(0.5) * t90_;
        let t93_ = T::sqrt(t86_);
        let t92_ = T::sqrt(t91_);
        let t58_ = T::mul_neg_add(cos_rocker_pin_angle_, c_(1.5), cos_rocker_pin_angle_);
        let t63_ = sin_b_angle_ * sin_rocker_pin_angle_;
        let t61_ = cos_b_angle_ * sin_rocker_pin_angle_;
        let t64_ = T::mul_neg_add(cos_b_angle_, t58_, t63_);
        let t62_ = T::mul_add(sin_b_angle_, t58_, t61_);
        let t65_ = c_(0.6) * t64_;
        let t94_ = ::mstmm::generated::recip_above(t92_, t93_);
        let t72_ = T::mul_neg_add(t65_, a_z0_force_x_, t62_);
        let t96_ = ::mstmm::generated::recip_above(closure_d0_, closure_d0_);
        let t73_ = T::mul_neg_add(t65_, a_z0_force_y_, t64_);
        let t78_ = sin_a_angle_ * t72_;
        let t51_ = c_(0.6) * cos_rocker_pin_angle_;
        let t52_ = cos_rocker_pin_angle_ * c_(2.5);
        let t79_ = T::mul_add(cos_a_angle_, t73_, t78_);
        let t59_ = t51_ * t35_;
        let t60_ = t51_ * t52_;
        let t66_ = t65_ * t8_;
        let t80_ = c_(0.2) * t79_;
        let t74_ = T::mul_neg_add(t65_, t43_, t59_);
        let t95_ = t92_ * t94_;
        let t108_ = cos_a_angle_ * t72_;
        let t75_ = T::mul_add(t65_, t66_, t60_);
        let t85_ = t80_ * t32_;
        let t87_ = T::mul_neg_add(t80_, t50_, t74_);
        let t97_ = t95_ * t96_;
        let t103_ = t62_ * t62_;
        let t109_ = T::mul_neg_add(sin_a_angle_, t73_, t108_);
        let t101_ = T::mul_add(t51_, t51_, t55_);
        let t88_ = T::mul_add(t80_, t85_, t75_);
        let t98_ = t87_ * t97_;
        let t104_ = T::mul_add(t64_, t64_, t103_);
        let t105_ = t65_ * t65_;
        let t110_ = t109_ * t109_;
        let closure_d1_ = T::mul_neg_add(t87_, t98_, t88_);
        let t102_ = c_(4.166666666666667) * t101_;
        let t106_ = T::mul_add(c_(0.72), t104_, t105_);
        let t111_ = T::mul_add(t79_, t79_, t110_);
        let t112_ = t80_ * t80_;
        let t125_ = T::copysign(closure_d1_, c_(1.0));
        let t107_ = T::mul_add(t8_, t106_, t102_);
        let t113_ = T::mul_add(c_(0.76), t111_, t112_);
        let t126_ = closure_d1_ + t125_;
        let t124_ = T::mul_add(t113_, t32_, t107_);
        let t127_ = c_(0.5) * t126_;
        let t129_ = T::sqrt(t124_);
        let t128_ = T::sqrt(t127_);
        let t134_ = T::mul_neg_add(closure_d0_, t97_, c_(1.0));
        let t135_ = t134_ * t134_;
        /// Motion across `a`, [P, Eqs. (1), (13), (36)]: 2 mul, 1 add, 0 reciprocal.
        let a_omega_z_ = crank_pin_rate_ + a_rate_;
        *n21_ = a_omega_z_;
        ::mstmm::generated::written();
        /// Closure.
        let t136_ = ::mstmm::generated::recip_above(t135_, c_(1.0));
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 2 mul, 1 add, 0 reciprocal.
        let b_omega_z_ = b_rate_ + a_omega_z_;
        *n33_ = b_omega_z_;
        ::mstmm::generated::written();
        /// Riccati transfer over `b`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 0 add, 0 reciprocal.
        let t2_ = b_omega_z_ * b_omega_z_;
        /// Closure.
        let t130_ = ::mstmm::generated::recip_above(t128_, t129_);
        /// Motion across `b`.
        let t1_ = a_omega_z_ * a_omega_z_;
        /// Riccati transfer over `b`.
        let minus_b_e_force_x_ = c_(0.6) * t2_;
        /// Closure.
        let t132_ = ::mstmm::generated::recip_above(closure_d1_, t88_);
        /// Motion across `b`.
        let minus_b_centripetal_x_ = t1_ * c_(0.6);
        /// Riccati transfer over `a`.
        let t7_ = sin_b_angle_ * minus_b_e_force_x_;
        /// Closure.
        let t137_ = T::sqrt(t136_);
        /// Riccati transfer over `a`.
        let minus_a_e_force_y_ = T::mul_add(minus_b_centripetal_x_, a_k_xy_, t7_);
        /// Closure.
        let t131_ = t128_ * t130_;
        /// Riccati transfer over `a`.
        let minus_a_e_moment_z_ = c_(0.6) * minus_a_e_force_y_;
        /// Riccati transfer over `crank_pin`.
        let t28_ = T::mul_add(cos_b_angle_, minus_b_e_force_x_, minus_b_centripetal_x_);
        let t25_ = t5_ - c_(2.0);
        /// Closure.
        let t133_ = t131_ * t132_;
        /// Riccati transfer over `a`.
        let a_w0_ = minus_a_e_moment_z_ * t8_;
        /// Riccati transfer over `crank_pin`.
        let t20_ = T::mul_neg_add(c_(2.0), t17_, c_(1.0));
        let t29_ = T::mul_sub(minus_b_centripetal_x_, t25_, t28_);
        /// Closure.
        let t139_ = T::mul_neg_add(closure_d1_, t133_, c_(1.0));
        /// Riccati transfer over `crank_pin`.
        let t26_ = T::mul_neg_add(a_b_y_z_, a_w0_, minus_a_e_force_y_);
        /// Motion across `a`.
        let t0_ = crank_pin_rate_ * crank_pin_rate_;
        /// Riccati transfer over `crank_pin`.
        let t21_ = t16_ * t20_;
        let t30_ = T::mul_add(a_b_x_z_, a_w0_, t29_);
        /// Closure.
        let t138_ = t134_ * t137_;
        let t140_ = t98_ * t139_;
        /// Riccati transfer over `crank_pin`.
        let t27_ = cos_a_angle_ * t26_;
        /// Motion across `a`.
        let minus_a_centripetal_x_ = t0_ * c_(0.2);
        /// Closure.
        let t99_ = cos_rocker_pin_angle_ * minus_b_e_force_x_;
        /// Riccati transfer over `crank_pin`.
        let crank_pin_k_xy_ = T::mul_neg_add(t18_, t19_, t21_);
        /// Closure.
        let t141_ = t138_ * t140_;
        /// Riccati transfer over `crank_pin`.
        let t31_ = T::mul_neg_add(sin_a_angle_, t30_, t27_);
        /// Closure.
        let t100_ = T::mul_sub(sin_rocker_pin_angle_, minus_b_e_force_x_, c_(9.8));
        let t114_ = T::mul_add(minus_b_centripetal_x_, t39_, t99_);
        let t143_ = t139_ * t139_;
        let t142_ = T::mul_neg_add(t138_, t141_, t140_);
        /// Riccati transfer over `crank_pin`.
        let minus_crank_pin_e_force_y_ = T::mul_add(
            minus_a_centripetal_x_,
            crank_pin_k_xy_,
            t31_,
        );
        /// Closure.
        let t117_ = T::mul_add(minus_b_centripetal_x_, t62_, t100_);
        let t115_ = T::mul_sub(t42_, a_w0_, t114_);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_b_y_z_ = T::mul_neg_add(c_(0.2), t24_, c_(0.1));
        /// Closure.
        let t144_ = T::mul_add(t142_, t142_, t143_);
        /// Riccati transfer over `crank_pin`.
        let t33_ = T::mul_add(c_(0.2), minus_crank_pin_e_force_y_, crank_pin_input0_);
        /// Closure.
        let t118_ = T::mul_sub(t65_, a_w0_, t117_);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_b_x_z_ = c_(0.2) * crank_pin_k_xy_;
        /// Closure.
        let t116_ = T::mul_sub(minus_a_centripetal_x_, t77_, t115_);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_z0_force_y_ = crank_pin_b_y_z_ * t32_;
        /// Closure.
        let t145_ = ::mstmm::generated::recip_above(t144_, c_(1.0));
        /// Riccati transfer over `crank_pin`.
        let crank_pin_w0_ = t33_ * t32_;
        /// Closure.
        let t119_ = T::mul_sub(minus_a_centripetal_x_, t109_, t118_);
        let crank_pin_a_lin_y_ = cos_crank_pin_angle_ * c_(9.8);
        *n9_ = crank_pin_a_lin_y_;
        ::mstmm::generated::written();
        /// Riccati transfer over `crank_pin`.
        let crank_pin_z0_force_x_ = crank_pin_b_x_z_ * t32_;
        /// Closure.
        let t121_ = T::mul_neg_add(t49_, crank_pin_z0_force_y_, t48_);
        let t123_ = T::mul_neg_add(t80_, crank_pin_z0_force_y_, t79_);
        let t149_ = T::mul_neg_add(t49_, crank_pin_w0_, t116_);
        let t152_ = T::mul_neg_add(t80_, crank_pin_w0_, t119_);
        let crank_pin_a_lin_x_ = sin_crank_pin_angle_ * c_(9.8);
        *n8_ = crank_pin_a_lin_x_;
        ::mstmm::generated::written();
        let t120_ = T::mul_neg_add(t49_, crank_pin_z0_force_x_, t77_);
        let t122_ = T::mul_neg_add(t80_, crank_pin_z0_force_x_, t109_);
        let t150_ = T::mul_sub(crank_pin_a_lin_y_, t121_, t149_);
        let t153_ = T::mul_sub(crank_pin_a_lin_y_, t123_, t152_);
        let t151_ = T::mul_add(crank_pin_a_lin_x_, t120_, t150_);
        let t154_ = T::mul_add(crank_pin_a_lin_x_, t122_, t153_);
        let t146_ = T::sqrt(t145_);
        let t155_ = T::mul_add(t98_, t151_, t154_);
        let t156_ = t97_ * t151_;
        let t157_ = t133_ * t155_;
        let t158_ = T::mul_add(t98_, t157_, t156_);
        let t159_ = t138_ * t158_;
        let t160_ = T::mul_neg_add(t138_, t159_, t158_);
        let t147_ = t142_ * t146_;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 15 mul, 11 add, 0 reciprocal.
        let t171_ = cos_a_angle_ * a_z0_force_x_;
        let t173_ = sin_a_angle_ * a_z0_force_x_;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 5 mul, 4 add, 0 reciprocal.
        let t163_ = sin_crank_pin_angle_ * crank_pin_z0_force_x_;
        /// Closure.
        let t148_ = t139_ * t146_;
        let t161_ = t147_ * t160_;
        /// Acceleration of `a`.
        let t172_ = T::mul_neg_add(sin_a_angle_, a_z0_force_y_, t171_);
        let t167_ = minus_a_centripetal_x_ - crank_pin_a_lin_x_;
        let t174_ = T::mul_add(cos_a_angle_, a_z0_force_y_, t173_);
        /// Acceleration of `crank_pin`.
        let t164_ = T::mul_add(cos_crank_pin_angle_, crank_pin_z0_force_y_, t163_);
        /// Closure.
        let t162_ = T::mul_add(t148_, t157_, t161_);
        /// Acceleration of `a`.
        let t176_ = T::mul_add(t167_, t172_, a_w0_);
        /// Acceleration of `crank_pin`.
        let t165_ = T::mul_sub(c_(9.8), t164_, crank_pin_w0_);
        /// Closure.
        let minus_closure_reaction1_ = T::mul_neg_add(t148_, t162_, t157_);
        /// Acceleration of `a`.
        let t177_ = T::mul_sub(crank_pin_a_lin_y_, t174_, t176_);
        /// Closure.
        let closure_reaction0_ = T::mul_neg_add(t147_, t162_, t160_);
        /// Acceleration of `crank_pin`.
        let t166_ = T::mul_add(t85_, minus_closure_reaction1_, t165_);
        /// Acceleration of `a`.
        let t178_ = T::mul_add(t66_, minus_closure_reaction1_, t177_);
        let t175_ = c_(0.2) * t174_;
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 13 mul, 8 add, 0 reciprocal.
        let t188_ = t35_ * closure_reaction0_;
        /// Acceleration of `crank_pin`.
        let minus_crank_pin_a_ang_z_ = T::mul_add(t50_, closure_reaction0_, t166_);
        *n10_ = minus_crank_pin_a_ang_z_;
        ::mstmm::generated::written();
        /// Acceleration of `a`.
        let t179_ = T::mul_add(t43_, closure_reaction0_, t178_);
        /// Acceleration of `b`.
        let t187_ = cos_b_angle_ * c_(1.5);
        /// Acceleration of `a`.
        let t170_ = sin_a_angle_ * t167_;
        /// Acceleration of `b`.
        let t189_ = T::mul_neg_add(t52_, minus_closure_reaction1_, t188_);
        /// Acceleration of `a`.
        let t169_ = T::mul_neg_add(
            c_(0.2),
            minus_crank_pin_a_ang_z_,
            crank_pin_a_lin_y_,
        );
        let a_a_ang_z_ = T::mul_sub(t175_, minus_crank_pin_a_ang_z_, t179_);
        *n22_ = a_a_ang_z_;
        ::mstmm::generated::written();
        let t168_ = cos_a_angle_ * t167_;
        /// Acceleration of `b`.
        let t186_ = cos_b_angle_ * c_(2.5);
        /// Acceleration of `a`.
        let a_a_lin_y_ = T::mul_add(cos_a_angle_, t169_, t170_);
        *n18_ = a_a_lin_y_;
        ::mstmm::generated::written();
        /// Acceleration of `b`.
        let t190_ = T::mul_add(t187_, a_a_ang_z_, t189_);
        /// Acceleration of `a`.
        let minus_a_a_lin_x_ = T::mul_neg_add(sin_a_angle_, t169_, t168_);
        *n17_ = minus_a_a_lin_x_;
        ::mstmm::generated::written();
        /// Acceleration of `b`.
        let t185_ = sin_b_angle_ * c_(2.5);
        let t191_ = T::mul_add(t186_, a_a_lin_y_, t190_);
        /// Results: 16 mul, 13 add, 0 reciprocal.
        let t221_ = t0_ * c_(0.09000000000000002);
        /// Acceleration of `b`.
        let t180_ = minus_b_centripetal_x_ + minus_a_a_lin_x_;
        /// Load on `crank_pin`, [P, Eqs. (18), (19)]: 19 mul, 18 add, 0 reciprocal.
        let t196_ = sin_rocker_pin_angle_ * closure_reaction0_;
        /// Acceleration of `b`.
        let t181_ = c_(0.6) * a_a_ang_z_;
        let minus_b_a_ang_z_ = T::mul_add(t185_, t180_, t191_);
        *n34_ = minus_b_a_ang_z_;
        ::mstmm::generated::written();
        /// Results.
        let t223_ = T::mul_add(t1_, c_(0.48), t221_);
        /// Velocity behind `a`: 3 mul, 0 add, 0 reciprocal.
        let t209_ = crank_pin_rate_ * c_(0.2);
        /// Results.
        let t222_ = a_omega_z_ * c_(1.7999999999999998);
        /// Load on `crank_pin`.
        let t194_ = cos_rocker_pin_angle_ * closure_reaction0_;
        let t197_ = T::mul_neg_add(
            cos_rocker_pin_angle_,
            minus_closure_reaction1_,
            t196_,
        );
        *n42_ = t197_;
        ::mstmm::generated::written();
        /// Acceleration of `b`.
        let t184_ = sin_b_angle_ * t180_;
        let t182_ = a_a_lin_y_ + t181_;
        /// Load on `crank_pin`.
        let t193_ = c_(0.6) * minus_b_a_ang_z_;
        /// Connection points, [P, Eqs. (4), (12), (13)]: 3 mul, 5 add, 0 reciprocal.
        let t215_ = c_(0.6) * b_omega_z_;
        /// Results.
        let t224_ = T::mul_add(t2_, c_(0.12), t223_);
        /// Pose behind `a`, [P, Eq. (12)]: 6 mul, 2 add, 0 reciprocal.
        let t207_ = cos_crank_pin_angle_ * cos_a_angle_;
        let a_position_x_ = cos_crank_pin_angle_ * c_(0.2);
        *n11_ = a_position_x_;
        ::mstmm::generated::written();
        let a_position_y_ = sin_crank_pin_angle_ * c_(0.2);
        *n12_ = a_position_y_;
        ::mstmm::generated::written();
        /// Velocity behind `a`.
        let a_velocity_y_ = cos_a_angle_ * t209_;
        *n14_ = a_velocity_y_;
        ::mstmm::generated::written();
        /// Acceleration of `b`.
        let t183_ = cos_b_angle_ * t180_;
        let b_a_lin_y_ = T::mul_add(cos_b_angle_, t182_, t184_);
        *n30_ = b_a_lin_y_;
        ::mstmm::generated::written();
        /// Load on `crank_pin`.
        let t195_ = T::mul_add(sin_rocker_pin_angle_, minus_closure_reaction1_, t194_);
        *n41_ = t195_;
        ::mstmm::generated::written();
        let t199_ = t193_ - t197_;
        /// Velocity behind `a`.
        let a_velocity_x_ = sin_a_angle_ * t209_;
        *n13_ = a_velocity_x_;
        ::mstmm::generated::written();
        /// Pose behind `a`.
        let t208_ = cos_crank_pin_angle_ * sin_a_angle_;
        let a_to_inertial_x_x_ = T::mul_neg_add(
            sin_crank_pin_angle_,
            sin_a_angle_,
            t207_,
        );
        *n15_ = a_to_inertial_x_x_;
        ::mstmm::generated::written();
        /// Results.
        let t227_ = sin_crank_pin_angle_ * c_(8.82);
        /// Load on `crank_pin`.
        let t192_ = T::mul_sub(t0_, c_(0.1), crank_pin_a_lin_x_);
        let t202_ = T::mul_add(c_(2.0), a_a_lin_y_, t181_);
        /// Acceleration of `b`.
        let minus_b_a_lin_x_ = T::mul_neg_add(sin_b_angle_, t182_, t183_);
        *n29_ = minus_b_a_lin_x_;
        ::mstmm::generated::written();
        /// Load on `crank_pin`.
        let b_load_force_y_ = T::mul_sub(c_(2.0), b_a_lin_y_, t199_);
        *n32_ = b_load_force_y_;
        ::mstmm::generated::written();
        let t198_ = minus_b_e_force_x_ - t195_;
        /// Velocity behind `b`: 5 mul, 3 add, 0 reciprocal.
        let t212_ = T::mul_add(a_omega_z_, c_(0.6), a_velocity_y_);
        let t214_ = sin_b_angle_ * a_velocity_x_;
        /// Pose behind `a`.
        let minus_a_to_inertial_x_y_ = T::mul_add(
            sin_crank_pin_angle_,
            cos_a_angle_,
            t208_,
        );
        *n16_ = minus_a_to_inertial_x_y_;
        ::mstmm::generated::written();
        /// Pose behind `b`, [P, Eq. (12)]: 6 mul, 4 add, 0 reciprocal.
        let t210_ = cos_b_angle_ * a_to_inertial_x_x_;
        /// Velocity behind `b`.
        let t213_ = cos_b_angle_ * a_velocity_x_;
        /// Results.
        let t225_ = T::mul_add(a_velocity_y_, t222_, t224_);
        /// Load on `crank_pin`.
        let t200_ = T::mul_add(c_(2.0), minus_a_a_lin_x_, minus_b_centripetal_x_);
        let minus_b_load_force_x_ = T::mul_add(c_(2.0), minus_b_a_lin_x_, t198_);
        *n31_ = minus_b_load_force_x_;
        ::mstmm::generated::written();
        let t203_ = T::mul_add(cos_b_angle_, b_load_force_y_, t202_);
        /// Pose behind `b`.
        let b_position_x_ = T::mul_add(c_(0.6), a_to_inertial_x_x_, a_position_x_);
        *n23_ = b_position_x_;
        ::mstmm::generated::written();
        let t211_ = sin_b_angle_ * a_to_inertial_x_x_;
        /// Velocity behind `b`.
        let minus_b_velocity_y_ = T::mul_neg_add(cos_b_angle_, t212_, t214_);
        *n26_ = minus_b_velocity_y_;
        ::mstmm::generated::written();
        /// Pose behind `b`.
        let b_position_y_ = T::mul_add(c_(0.6), minus_a_to_inertial_x_y_, a_position_y_);
        *n24_ = b_position_y_;
        ::mstmm::generated::written();
        let b_to_inertial_x_x_ = T::mul_neg_add(
            sin_b_angle_,
            minus_a_to_inertial_x_y_,
            t210_,
        );
        *n27_ = b_to_inertial_x_x_;
        ::mstmm::generated::written();
        /// Velocity behind `b`.
        let b_velocity_x_ = T::mul_add(sin_b_angle_, t212_, t213_);
        *n25_ = b_velocity_x_;
        *n37_ = b_velocity_x_;
        ::mstmm::generated::written();
        /// Results.
        let t228_ = T::mul_add(minus_a_to_inertial_x_y_, c_(17.64), t227_);
        let t218_ = c_(4.0) + t14_;
        /// Load on `crank_pin`.
        let t201_ = T::mul_add(sin_b_angle_, b_load_force_y_, t200_);
        let minus_a_load_force_y_ = T::mul_sub(
            sin_b_angle_,
            minus_b_load_force_x_,
            t203_,
        );
        *n20_ = minus_a_load_force_y_;
        ::mstmm::generated::written();
        let t205_ = T::mul_neg_add(
            c_(0.1),
            minus_crank_pin_a_ang_z_,
            crank_pin_a_lin_y_,
        );
        /// Pose behind `b`.
        let minus_b_to_inertial_x_y_ = T::mul_add(
            cos_b_angle_,
            minus_a_to_inertial_x_y_,
            t211_,
        );
        *n28_ = minus_b_to_inertial_x_y_;
        ::mstmm::generated::written();
        /// Connection points.
        let minus_point6_velocity_y_ = minus_b_velocity_y_ - t215_;
        *n38_ = minus_point6_velocity_y_;
        ::mstmm::generated::written();
        /// Results.
        let t226_ = T::mul_sub(minus_b_velocity_y_, t215_, t225_);
        at_.kinetic_energy = -t226_;
        ::mstmm::generated::written();
        /// Connection points.
        let point6_position_x_ = T::mul_add(c_(0.6), b_to_inertial_x_x_, b_position_x_);
        *n35_ = point6_position_x_;
        ::mstmm::generated::written();
        /// Results.
        let t219_ = t12_ - t218_;
        let t232_ = cos_rocker_pin_angle_ * t147_;
        let t234_ = sin_rocker_pin_angle_ * t147_;
        /// Load on `crank_pin`.
        let minus_a_load_force_x_ = T::mul_add(
            cos_b_angle_,
            minus_b_load_force_x_,
            t201_,
        );
        *n19_ = minus_a_load_force_x_;
        ::mstmm::generated::written();
        let t204_ = T::mul_neg_add(sin_a_angle_, minus_a_load_force_y_, t192_);
        let t206_ = T::mul_sub(cos_a_angle_, minus_a_load_force_y_, t205_);
        /// Connection points.
        let point6_position_y_ = T::mul_add(
            c_(0.6),
            minus_b_to_inertial_x_y_,
            b_position_y_,
        );
        *n36_ = point6_position_y_;
        ::mstmm::generated::written();
        /// Results.
        let t229_ = T::mul_add(minus_b_to_inertial_x_y_, c_(5.88), t228_);
        at_.potential_energy = t229_;
        ::mstmm::generated::written();
        let t220_ = T::mul_neg_add(
            c_(0.04000000000000001),
            t219_,
            c_(0.030000000000000006),
        );
        let t230_ = cos_rocker_pin_angle_ * t138_;
        let t231_ = sin_rocker_pin_angle_ * t138_;
        let t233_ = T::mul_add(sin_rocker_pin_angle_, t148_, t232_);
        let t235_ = T::mul_neg_add(cos_rocker_pin_angle_, t148_, t234_);
        at_.closure = ::mstmm::generated::closure([
            [t230_, t231_, c_(0.0), c_(0.0), c_(0.0), c_(0.0)],
            [-t233_, -t235_, c_(0.0), c_(0.0), c_(0.0), c_(0.0)],
        ]);
        ::mstmm::generated::written();
        let t216_ = minus_crank_pin_a_ang_z_ + a_a_ang_z_;
        /// Load on `crank_pin`.
        let minus_crank_pin_load_force_x_ = T::mul_add(
            cos_a_angle_,
            minus_a_load_force_x_,
            t204_,
        );
        *n3_ = minus_crank_pin_load_force_x_;
        ::mstmm::generated::written();
        let minus_crank_pin_load_force_y_ = T::mul_add(
            sin_a_angle_,
            minus_a_load_force_x_,
            t206_,
        );
        *n4_ = minus_crank_pin_load_force_y_;
        ::mstmm::generated::written();
        /// Results.
        let t217_ = a_a_ang_z_ + minus_b_a_ang_z_;
        if !::mstmm::generated::regular::<
            T,
            _,
            _,
        >(
            [a_j_zz_, crank_pin_j_zz_],
            [c_(2.04), t220_],
            [state_.t, state_.v.data.0[0][3], t216_, -t217_],
        ) {
            let error_ = ::mstmm::generated::irregular::<
                T,
                _,
            >(&["a", "crank_pin"], [a_j_zz_, crank_pin_j_zz_], [c_(2.04), t220_]);
            ::mstmm::generated::take_back(at_, || self.workspace());
            return ::core::result::Result::Err(error_);
        }
        at_.accelerations.data.0 = [
            [-minus_crank_pin_a_ang_z_, t216_, -t217_, minus_b_a_ang_z_],
        ];
        ::mstmm::generated::written();
        /// Connection points.
        let minus_point6_felt_x_ = minus_b_e_force_x_ + minus_b_a_lin_x_;
        *n39_ = minus_point6_felt_x_;
        ::mstmm::generated::written();
        let point6_felt_y_ = b_a_lin_y_ - t193_;
        *n40_ = point6_felt_y_;
        ::mstmm::generated::written();
        ::core::result::Result::Ok(())
    }
    /// Kinetic and potential energy in J; the potential of gravity is zero with every centre
    /// of mass at the inertial origin.
    ///
    /// 38 operations: 25 mul, 13 add, 0 reciprocal, 3 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 3 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Results |  | 25 | 11 | 0 | 0 | 0 |
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
        /// Motion across `a`, [P, Eqs. (1), (13), (36)]: 0 mul, 1 add, 0 reciprocal.
        let a_omega_z_ = crank_pin_rate_ + a_rate_;
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 0 mul, 1 add, 0 reciprocal.
        let b_omega_z_ = b_rate_ + a_omega_z_;
        /// Results: 25 mul, 11 add, 0 reciprocal.
        let t0_ = crank_pin_rate_ * crank_pin_rate_;
        let t1_ = a_omega_z_ * a_omega_z_;
        let t2_ = b_omega_z_ * b_omega_z_;
        let t3_ = crank_pin_rate_ * c_(0.2);
        let t4_ = sin_a_angle_ * t3_;
        let t5_ = cos_a_angle_ * t3_;
        let t6_ = T::mul_add(a_omega_z_, c_(0.6), t5_);
        let t7_ = sin_b_angle_ * t4_;
        let t8_ = T::mul_neg_add(cos_b_angle_, t6_, t7_);
        let t9_ = c_(0.6) * b_omega_z_;
        let t10_ = t0_ * c_(0.09000000000000002);
        let t11_ = a_omega_z_ * c_(1.7999999999999998);
        let t12_ = T::mul_add(t1_, c_(0.48), t10_);
        let t13_ = T::mul_add(t2_, c_(0.12), t12_);
        let t14_ = T::mul_add(t5_, t11_, t13_);
        let t15_ = T::mul_sub(t8_, t9_, t14_);
        let t16_ = cos_crank_pin_angle_ * cos_a_angle_;
        let t17_ = T::mul_neg_add(sin_crank_pin_angle_, sin_a_angle_, t16_);
        let t18_ = cos_crank_pin_angle_ * sin_a_angle_;
        let t19_ = T::mul_add(sin_crank_pin_angle_, cos_a_angle_, t18_);
        let t20_ = sin_b_angle_ * t17_;
        let t21_ = T::mul_add(cos_b_angle_, t19_, t20_);
        let t22_ = sin_crank_pin_angle_ * c_(8.82);
        let t23_ = T::mul_add(t19_, c_(17.64), t22_);
        let t24_ = T::mul_add(t21_, c_(5.88), t23_);
        ::mstmm::Energy {
            kinetic: -t15_,
            potential: t24_,
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
    /// 346 operations: 205 mul, 124 add, 9 reciprocal, 8 square root, 5 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 9 | 3 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 12 | 9 | 0 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 142 | 73 | 7 | 6 | 0 |
    /// | Acceleration of `crank_pin` | \[P, Eqs. (13), (36), (44)\] | 4 | 2 | 0 | 0 | 0 |
    /// | Acceleration of `a` | \[P, Eqs. (13), (36), (44)\] | 15 | 5 | 0 | 0 | 0 |
    /// | Acceleration of `b` | \[P, Eqs. (13), (36), (44)\] | 13 | 8 | 0 | 0 | 0 |
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
        /// Riccati transfer over `a`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 9 mul, 3 add, 1 reciprocal.
        let t0_ = sin_b_angle_ * cos_b_angle_;
        let a_k_xy_ = c_(1.5) * t0_;
        let a_b_x_z_ = t0_ * c_(0.8999999999999999);
        let t1_ = sin_b_angle_ * sin_b_angle_;
        let t2_ = c_(1.5) * t1_;
        let t3_ = t2_ + c_(0.5);
        let a_b_y_z_ = T::mul_add(c_(0.6), t3_, c_(0.6));
        let a_j_zz_ = T::mul_add(c_(0.36), t3_, c_(0.24));
        let t4_ = T::recip(a_j_zz_);
        let a_z0_force_x_ = a_b_x_z_ * t4_;
        let a_z0_force_y_ = a_b_y_z_ * t4_;
        /// Riccati transfer over `crank_pin`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 12 mul, 9 add, 0 reciprocal.
        let t5_ = t2_ - c_(4.0);
        let t6_ = c_(2.5) + t2_;
        let t7_ = a_b_x_z_ * a_b_x_z_;
        let t8_ = T::mul_add(t4_, t7_, t5_);
        let t9_ = a_b_y_z_ * a_b_y_z_;
        let t10_ = T::mul_neg_add(t4_, t9_, t6_);
        let t11_ = a_b_x_z_ * a_b_y_z_;
        let t12_ = T::mul_neg_add(t4_, t11_, a_k_xy_);
        let t13_ = sin_a_angle_ * sin_a_angle_;
        let t14_ = sin_a_angle_ * cos_a_angle_;
        let t15_ = t8_ + t10_;
        let t16_ = c_(2.0) * t14_;
        let t17_ = T::mul_add(t12_, t16_, t10_);
        let t18_ = T::mul_sub(t13_, t15_, t17_);
        let crank_pin_j_zz_ = T::mul_neg_add(
            c_(0.04000000000000001),
            t18_,
            c_(0.020000000000000004),
        );
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 142 mul, 73 add, 7 reciprocal, 6 square root.
        let t19_ = c_(0.6) * sin_rocker_pin_angle_;
        let t20_ = sin_rocker_pin_angle_ * c_(2.5);
        let t21_ = T::mul_neg_add(sin_rocker_pin_angle_, c_(1.5), sin_rocker_pin_angle_);
        let t22_ = t19_ * t20_;
        let t23_ = cos_b_angle_ * cos_rocker_pin_angle_;
        let t24_ = T::mul_neg_add(sin_b_angle_, t21_, t23_);
        let t25_ = sin_b_angle_ * cos_rocker_pin_angle_;
        let t26_ = T::mul_add(cos_b_angle_, t21_, t25_);
        let t27_ = c_(0.6) * t26_;
        let t28_ = t27_ * t4_;
        let t29_ = T::mul_neg_add(t27_, a_z0_force_x_, t24_);
        let t30_ = T::mul_neg_add(t27_, a_z0_force_y_, t26_);
        let t31_ = T::mul_add(t27_, t28_, t22_);
        let t32_ = sin_a_angle_ * t29_;
        let t33_ = T::mul_add(cos_a_angle_, t30_, t32_);
        let t34_ = c_(0.2) * t33_;
        let t35_ = T::recip(crank_pin_j_zz_);
        let t36_ = t34_ * t35_;
        let closure_d0_ = T::mul_add(t34_, t36_, t31_);
        let t37_ = c_(0.6) * cos_rocker_pin_angle_;
        let t38_ = cos_rocker_pin_angle_ * c_(2.5);
        let t39_ = cos_rocker_pin_angle_ * cos_rocker_pin_angle_;
        let t40_ = T::mul_add(sin_rocker_pin_angle_, sin_rocker_pin_angle_, t39_);
        let t41_ = t40_ * c_(0.36);
        let t42_ = T::mul_add(t19_, t19_, t41_);
        let t43_ = t42_ * c_(4.166666666666667);
        let t44_ = T::mul_neg_add(cos_rocker_pin_angle_, c_(1.5), cos_rocker_pin_angle_);
        let t45_ = t37_ * t20_;
        let t46_ = t37_ * t38_;
        let t47_ = cos_b_angle_ * sin_rocker_pin_angle_;
        let t48_ = T::mul_add(sin_b_angle_, t44_, t47_);
        let t49_ = sin_b_angle_ * sin_rocker_pin_angle_;
        let t50_ = T::mul_neg_add(cos_b_angle_, t44_, t49_);
        let t51_ = c_(0.6) * t50_;
        let t52_ = t51_ * t4_;
        let t53_ = t24_ * t24_;
        let t54_ = T::mul_add(t26_, t26_, t53_);
        let t55_ = t27_ * t27_;
        let t56_ = T::mul_add(t54_, c_(0.72), t55_);
        let t57_ = T::mul_add(t4_, t56_, t43_);
        let t58_ = T::mul_neg_add(t51_, a_z0_force_x_, t48_);
        let t59_ = T::mul_neg_add(t51_, a_z0_force_y_, t50_);
        let t60_ = T::mul_neg_add(t51_, t28_, t45_);
        let t61_ = T::mul_add(t51_, t52_, t46_);
        let t62_ = cos_a_angle_ * t29_;
        let t63_ = T::mul_neg_add(sin_a_angle_, t30_, t62_);
        let t64_ = sin_a_angle_ * t58_;
        let t65_ = T::mul_add(cos_a_angle_, t59_, t64_);
        let t66_ = c_(0.2) * t65_;
        let t67_ = t63_ * t63_;
        let t68_ = T::mul_add(t33_, t33_, t67_);
        let t69_ = t34_ * t34_;
        let t70_ = T::mul_add(t68_, c_(0.76), t69_);
        let t71_ = t66_ * t35_;
        let t72_ = T::mul_add(t70_, t35_, t57_);
        let t73_ = T::mul_neg_add(t66_, t36_, t60_);
        let t74_ = T::mul_add(t66_, t71_, t61_);
        let t75_ = T::copysign(closure_d0_, c_(1.0));
        let t76_ = closure_d0_ + t75_;
        let t77_ = c_(0.5) * t76_;
        let t78_ = T::sqrt(t77_);
        let t79_ = T::sqrt(t72_);
        let t80_ = ::mstmm::generated::recip_above(t78_, t79_);
        let t81_ = t78_ * t80_;
        let t82_ = ::mstmm::generated::recip_above(closure_d0_, closure_d0_);
        let t83_ = t81_ * t82_;
        let t84_ = t73_ * t83_;
        let closure_d1_ = T::mul_neg_add(t73_, t84_, t74_);
        let t85_ = T::mul_add(t37_, t37_, t41_);
        let t86_ = c_(4.166666666666667) * t85_;
        let t87_ = t48_ * t48_;
        let t88_ = T::mul_add(t50_, t50_, t87_);
        let t89_ = t51_ * t51_;
        let t90_ = T::mul_add(c_(0.72), t88_, t89_);
        let t91_ = T::mul_add(t4_, t90_, t86_);
        let t92_ = cos_a_angle_ * t58_;
        let t93_ = T::mul_neg_add(sin_a_angle_, t59_, t92_);
        let t94_ = t93_ * t93_;
        let t95_ = T::mul_add(t65_, t65_, t94_);
        let t96_ = t66_ * t66_;
        let t97_ = T::mul_add(c_(0.76), t95_, t96_);
        let t98_ = T::mul_add(t97_, t35_, t91_);
        let t99_ = T::copysign(closure_d1_, c_(1.0));
        let t100_ = closure_d1_ + t99_;
        let t101_ = c_(0.5) * t100_;
        let t102_ = T::sqrt(t101_);
        let t103_ = T::sqrt(t98_);
        let t104_ = ::mstmm::generated::recip_above(t102_, t103_);
        let t105_ = t102_ * t104_;
        let t106_ = ::mstmm::generated::recip_above(closure_d1_, t74_);
        let t107_ = t105_ * t106_;
        let t108_ = T::mul_neg_add(closure_d0_, t83_, c_(1.0));
        let t109_ = t108_ * t108_;
        let t110_ = ::mstmm::generated::recip_above(t109_, c_(1.0));
        let t111_ = T::sqrt(t110_);
        let t112_ = t108_ * t111_;
        let t113_ = T::mul_neg_add(closure_d1_, t107_, c_(1.0));
        let t114_ = t84_ * t113_;
        let t115_ = t112_ * t114_;
        let t116_ = T::mul_neg_add(t112_, t115_, t114_);
        let t117_ = t113_ * t113_;
        let t118_ = T::mul_add(t116_, t116_, t117_);
        let t119_ = ::mstmm::generated::recip_above(t118_, c_(1.0));
        let t120_ = T::sqrt(t119_);
        let t121_ = t116_ * t120_;
        let t122_ = t113_ * t120_;
        let t123_ = sin_crank_pin_angle_ * c_(0.2);
        let t124_ = cos_crank_pin_angle_ * cos_a_angle_;
        let t125_ = T::mul_neg_add(sin_crank_pin_angle_, sin_a_angle_, t124_);
        let t126_ = cos_crank_pin_angle_ * sin_a_angle_;
        let t127_ = T::mul_add(sin_crank_pin_angle_, cos_a_angle_, t126_);
        let t128_ = cos_b_angle_ * t125_;
        let t129_ = T::mul_neg_add(sin_b_angle_, t127_, t128_);
        let t130_ = sin_b_angle_ * t125_;
        let t131_ = T::mul_add(cos_b_angle_, t127_, t130_);
        let t132_ = cos_rocker_pin_angle_ * t129_;
        let t133_ = T::mul_neg_add(sin_rocker_pin_angle_, t131_, t132_);
        let t134_ = sin_rocker_pin_angle_ * t129_;
        let t135_ = T::mul_add(cos_rocker_pin_angle_, t131_, t134_);
        let t136_ = t127_ + t131_;
        let t137_ = T::mul_add(c_(0.6), t136_, t123_);
        let t138_ = t125_ + t129_;
        let t139_ = T::mul_neg_add(cos_crank_pin_angle_, c_(0.2), c_(0.8));
        let t140_ = T::mul_sub(c_(0.6), t138_, t139_);
        let t141_ = t133_ * t140_;
        let t142_ = T::mul_add(t135_, t137_, t141_);
        let t143_ = t135_ * t140_;
        let t144_ = T::mul_neg_add(t133_, t137_, t143_);
        let t145_ = T::mul_add(t84_, t142_, t144_);
        let t146_ = t83_ * t142_;
        let t147_ = t107_ * t145_;
        let t148_ = T::mul_add(t84_, t147_, t146_);
        let t149_ = t112_ * t148_;
        let t150_ = T::mul_neg_add(t112_, t149_, t148_);
        let t151_ = t121_ * t150_;
        let t152_ = T::mul_add(t122_, t147_, t151_);
        let closure_reaction0_ = T::mul_neg_add(t121_, t152_, t150_);
        let minus_closure_reaction1_ = T::mul_neg_add(t122_, t152_, t147_);
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 4 mul, 2 add, 0 reciprocal.
        let t153_ = t36_ * closure_reaction0_;
        let minus_crank_pin_a_ang_z_ = T::mul_add(t71_, minus_closure_reaction1_, t153_);
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 15 mul, 5 add, 0 reciprocal.
        let t154_ = c_(0.2) * minus_crank_pin_a_ang_z_;
        let minus_a_a_lin_x_ = sin_a_angle_ * t154_;
        let minus_a_a_lin_y_ = cos_a_angle_ * t154_;
        let t155_ = sin_a_angle_ * a_z0_force_x_;
        let t156_ = T::mul_add(cos_a_angle_, a_z0_force_y_, t155_);
        let t157_ = c_(0.2) * t156_;
        let t158_ = t28_ * closure_reaction0_;
        let t159_ = T::mul_add(t52_, minus_closure_reaction1_, t158_);
        let a_a_ang_z_ = T::mul_sub(t157_, minus_crank_pin_a_ang_z_, t159_);
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 13 mul, 8 add, 0 reciprocal.
        let t160_ = sin_b_angle_ * c_(2.5);
        let t161_ = cos_b_angle_ * c_(2.5);
        let t162_ = cos_b_angle_ * c_(1.5);
        let t163_ = t20_ * closure_reaction0_;
        let t164_ = T::mul_neg_add(t38_, minus_closure_reaction1_, t163_);
        let t165_ = T::mul_add(t162_, a_a_ang_z_, t164_);
        let t166_ = T::mul_sub(t161_, minus_a_a_lin_y_, t165_);
        let minus_b_a_ang_z_ = T::mul_sub(t160_, minus_a_a_lin_x_, t166_);
        /// Closure.
        let t167_ = crank_pin_rate_ * c_(0.2);
        let t168_ = sin_a_angle_ * t167_;
        let t169_ = a_omega_z_ * c_(0.6);
        let t170_ = T::mul_add(cos_a_angle_, t167_, t169_);
        let t171_ = cos_b_angle_ * t168_;
        let t172_ = T::mul_add(sin_b_angle_, t170_, t171_);
        let t173_ = c_(0.6) * b_omega_z_;
        let t174_ = cos_rocker_pin_angle_ * t172_;
        let t175_ = sin_rocker_pin_angle_ * t172_;
        let t176_ = T::mul_sub(sin_b_angle_, t168_, t173_);
        let t177_ = T::mul_sub(cos_b_angle_, t170_, t176_);
        let t178_ = T::mul_add(sin_rocker_pin_angle_, t177_, t174_);
        let t179_ = T::mul_neg_add(cos_rocker_pin_angle_, t177_, t175_);
        let t180_ = T::mul_add(t84_, t178_, t179_);
        let t181_ = t83_ * t178_;
        let t182_ = t107_ * t180_;
        let t183_ = T::mul_add(t84_, t182_, t181_);
        let t184_ = t112_ * t183_;
        let t185_ = T::mul_neg_add(t112_, t184_, t183_);
        let t186_ = t121_ * t185_;
        let t187_ = T::mul_add(t122_, t182_, t186_);
        let closure_reaction0_2_ = T::mul_neg_add(t121_, t187_, t185_);
        let minus_closure_reaction1_2_ = T::mul_neg_add(t122_, t187_, t182_);
        /// Acceleration of `crank_pin`.
        let t188_ = t36_ * closure_reaction0_2_;
        let minus_crank_pin_a_ang_z_2_ = T::mul_add(
            t71_,
            minus_closure_reaction1_2_,
            t188_,
        );
        /// Acceleration of `a`.
        let t189_ = c_(0.2) * minus_crank_pin_a_ang_z_2_;
        let minus_a_a_lin_x_2_ = sin_a_angle_ * t189_;
        let minus_a_a_lin_y_2_ = cos_a_angle_ * t189_;
        let t190_ = t28_ * closure_reaction0_2_;
        let t191_ = T::mul_add(t52_, minus_closure_reaction1_2_, t190_);
        let a_a_ang_z_2_ = T::mul_sub(t157_, minus_crank_pin_a_ang_z_2_, t191_);
        /// Acceleration of `b`.
        let t192_ = t20_ * closure_reaction0_2_;
        let t193_ = T::mul_neg_add(t38_, minus_closure_reaction1_2_, t192_);
        let t194_ = T::mul_add(t162_, a_a_ang_z_2_, t193_);
        let t195_ = T::mul_sub(t161_, minus_a_a_lin_y_2_, t194_);
        let minus_b_a_ang_z_2_ = T::mul_sub(t160_, minus_a_a_lin_x_2_, t195_);
        /// Results: 10 mul, 22 add, 1 reciprocal, 2 square root, 1 sin/cos.
        let t196_ = crank_pin_angle_ - minus_crank_pin_a_ang_z_;
        let t197_ = a_angle_ + minus_crank_pin_a_ang_z_;
        let t198_ = a_a_ang_z_ + t197_;
        let t199_ = b_angle_ - a_a_ang_z_;
        let t200_ = minus_b_a_ang_z_ - t199_;
        let t201_ = T::mul_add(t135_, t135_, c_(0.000000000000000000000000000001));
        let t202_ = T::sqrt(t201_);
        let t203_ = T::atan2(t202_, t133_);
        let t204_ = T::recip(t202_);
        let t205_ = t203_ * t204_;
        let t206_ = t135_ * t205_;
        let t207_ = rocker_pin_angle_ - t206_;
        let t208_ = t207_ + minus_b_a_ang_z_;
        let t209_ = crank_pin_rate_ - minus_crank_pin_a_ang_z_2_;
        let t210_ = a_rate_ + minus_crank_pin_a_ang_z_2_;
        let t211_ = a_a_ang_z_2_ + t210_;
        let t212_ = b_rate_ - a_a_ang_z_2_;
        let t213_ = minus_b_a_ang_z_2_ - t212_;
        let t214_ = b_omega_z_ - minus_b_a_ang_z_2_;
        let t215_ = rocker_pin_rate_ + b_omega_z_;
        let t216_ = c_(1.0) - t133_;
        let t217_ = t215_ * t215_;
        let t218_ = T::mul_add(t179_, t179_, t217_);
        let t219_ = T::mul_add(t178_, t178_, t218_);
        let t220_ = T::mul_add(t216_, t216_, t219_);
        let t221_ = T::mul_add(t142_, t142_, t220_);
        let t222_ = T::mul_add(t144_, t144_, t221_);
        let t223_ = T::mul_add(t206_, t206_, t222_);
        let t224_ = T::sqrt(t223_);
        let residual_ = t224_;
        state_.q.data.0 = [[t196_, t198_, -t200_, t208_]];
        state_.v.data.0 = [[t209_, t211_, -t213_, -t214_]];
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
/// Results of [`FourBar::solve_into`]: accelerations, efforts, energies and, at every connection point, pose, velocity and the state vector `z`.
#[derive(Clone, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct FourBarWorkspace<T> {
    accelerations: ::mstmm::nalgebra::SVector<T, 4>,
    efforts: ::mstmm::nalgebra::SVector<T, 4>,
    kinetic_energy: T,
    potential_energy: T,
    closure: ::mstmm::Closure<T, 2>,
    numbers: [T; 45],
    at_rest: [T; 2],
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
    pub fn points(&self) -> [::mstmm::PlanePoint<T>; 8] {
        [
            self.point_(0),
            self.point_(1),
            self.point_(2),
            self.point_(3),
            self.point_(4),
            self.point_(5),
            self.point_(6),
            self.point_(7),
        ]
    }
    /// Where every point of the model has its numbers.
    const PLACES_: [::mstmm::generated::Places<1, 6>; 8] = [
        ::mstmm::generated::Places::new(
            0,
            [0],
            [([0], 0), ([0], 0), ([0], 10), ([0], 0), ([0], 31), ([60], 43)],
        ),
        ::mstmm::generated::Places::new(
            0,
            [60],
            [([0], 0), ([0], 80), ([60], 90), ([0], 111), ([0], 31), ([60], 43)],
        ),
        ::mstmm::generated::Places::new(
            120,
            [60],
            [([160], 140), ([0], 80), ([160], 181), ([0], 111), ([0], 0), ([160], 203)],
        ),
        ::mstmm::generated::Places::new(
            120,
            [160],
            [([160], 140), ([0], 220), ([160], 181), ([0], 230), ([0], 0), ([160], 203)],
        ),
        ::mstmm::generated::Places::new(
            240,
            [160],
            [([280], 262), ([0], 220), ([280], 301), ([0], 230), ([0], 0), ([280], 321)],
        ),
        ::mstmm::generated::Places::new(
            240,
            [280],
            [([280], 262), ([0], 340), ([280], 301), ([0], 351), ([0], 0), ([280], 321)],
        ),
        ::mstmm::generated::Places::new(
            360,
            [280],
            [([280], 382), ([0], 340), ([280], 401), ([0], 351), ([0], 0), ([280], 420)],
        ),
        ::mstmm::generated::Places::new(
            440,
            [0],
            [([0], 0), ([0], 0), ([0], 10), ([0], 0), ([0], 0), ([280], 420)],
        ),
    ];
    /// Connection point number `index`.
    #[inline(always)]
    fn point_(&self, index_: ::core::primitive::usize) -> ::mstmm::PlanePoint<T> {
        let (model_, numbers_) = (index_, &self.numbers[..]);
        <::mstmm::PlanePoint<T>>::read(numbers_, Self::PLACES_.get(model_), self.at_rest)
    }
    /// Which reactions of the closing hinge, the last one, the motion does not determine:
    /// wrenches in axes of its inboard frame.
    #[inline]
    pub fn closure(&self) -> &::mstmm::Closure<T, 2> {
        &self.closure
    }
    /// Acceleration, effort, input and output of hinge `crank_pin`.
    #[inline]
    pub fn crank_pin(&self) -> ::mstmm::HingeResult<T, T, ::mstmm::PlanePoint<T>> {
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
    /// Input and output of body `crank`.
    #[inline]
    pub fn crank(&self) -> ::mstmm::BodyResult<T, ::mstmm::PlanePoint<T>> {
        let (input_, output_) = (self.point_(1), self.point_(2));
        ::mstmm::BodyResult::new(input_, output_)
    }
    /// Acceleration, effort, input and output of hinge `a`.
    #[inline]
    pub fn a(&self) -> ::mstmm::HingeResult<T, T, ::mstmm::PlanePoint<T>> {
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
    /// Input and output of body `coupler`.
    #[inline]
    pub fn coupler(&self) -> ::mstmm::BodyResult<T, ::mstmm::PlanePoint<T>> {
        let (input_, output_) = (self.point_(3), self.point_(4));
        ::mstmm::BodyResult::new(input_, output_)
    }
    /// Acceleration, effort, input and output of hinge `b`.
    #[inline]
    pub fn b(&self) -> ::mstmm::HingeResult<T, T, ::mstmm::PlanePoint<T>> {
        let (input_, output_) = (self.point_(4), self.point_(5));
        ::mstmm::HingeResult::new(
            {
                let [value_] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.accelerations.as_slice(), 2);
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
    pub fn rocker(&self) -> ::mstmm::BodyResult<T, ::mstmm::PlanePoint<T>> {
        let (input_, output_) = (self.point_(5), self.point_(6));
        ::mstmm::BodyResult::new(input_, output_)
    }
    /// Acceleration, effort, input and output of hinge `rocker_pin`.
    #[inline]
    pub fn rocker_pin(&self) -> ::mstmm::HingeResult<T, T, ::mstmm::PlanePoint<T>> {
        let (input_, output_) = (self.point_(6), self.point_(7));
        ::mstmm::HingeResult::new(
            {
                let [value_] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.accelerations.as_slice(), 3);
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
impl<T: ::mstmm::Scalar> ::core::fmt::Debug for FourBarWorkspace<T> {
    fn fmt(&self, to_: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
        to_.debug_struct("FourBarWorkspace")
            .field("accelerations", &self.accelerations)
            .field("efforts", &self.efforts)
            .field("kinetic_energy", &self.kinetic_energy)
            .field("potential_energy", &self.potential_energy)
            .field("closure", &self.closure)
            .field("points", &self.points())
            .finish()
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> FourBar<T> {
    /// Room for the results of [`solve_into`](Self::solve_into), which mean nothing before.
    #[must_use]
    #[allow(clippy::all)]
    pub fn workspace(&self) -> FourBarWorkspace<T> {
        let zero_ = T::constant(0.0);
        FourBarWorkspace {
            accelerations: ::mstmm::generated::vector([zero_; 4]),
            efforts: ::mstmm::generated::vector([zero_; 4]),
            kinetic_energy: zero_,
            potential_energy: zero_,
            closure: ::core::default::Default::default(),
            numbers: {
                let c_ = T::constant;
                ::mstmm::generated::with_known(
                    [T::constant(0.0); 45],
                    &[(1, c_(9.8)), (43, c_(0.8))],
                )
            },
            at_rest: {
                let c_ = T::constant;
                ::mstmm::generated::with_known([T::constant(0.0); 2], &[(1, c_(9.8))])
            },
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
