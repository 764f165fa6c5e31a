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
/// Accelerations by `riccati`, 326 operations (192 mul, 120 add, 8 reciprocal, 6 square root, 4 sin/cos); with everything at every connection point 489 operations.
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
        /// Riccati transfer over `a`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 15 mul, 9 add, 1 reciprocal.
        let t5_ = sin_b_angle_ * c_(1.5);
        let t6_ = sin_b_angle_ * t5_;
        let minus_a_k_xx_ = t6_ - c_(4.0);
        let a_k_yy_ = c_(2.5) + t6_;
        let a_k_xy_ = cos_b_angle_ * t5_;
        let a_b_x_z_ = c_(0.6) * a_k_xy_;
        let t7_ = c_(0.5) + t6_;
        let t8_ = c_(0.6) * t7_;
        let a_b_y_z_ = c_(0.6) + t8_;
        let t9_ = c_(0.36) * t7_;
        let a_j_zz_ = c_(0.24) + t9_;
        let t10_ = minus_b_drift_lin_x_ * c_(2.0);
        let t11_ = b_drift_lin_y_ * c_(0.5);
        let t12_ = minus_b_e_force_x_ + t10_;
        let t13_ = cos_b_angle_ * t12_;
        let t14_ = sin_b_angle_ * t11_;
        let t15_ = t13_ + t14_;
        let minus_a_e_force_x_ = t3_ + t15_;
        let t16_ = sin_b_angle_ * t12_;
        let t17_ = cos_b_angle_ * t11_;
        let minus_a_e_force_y_ = t16_ - t17_;
        let minus_a_e_moment_z_ = c_(0.6) * minus_a_e_force_y_;
        let t18_ = T::recip(a_j_zz_);
        let a_z0_force_x_ = a_b_x_z_ * t18_;
        let a_z0_force_y_ = a_b_y_z_ * t18_;
        /// Riccati transfer over `crank_pin`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 23 mul, 16 add, 1 reciprocal.
        let t19_ = a_b_x_z_ * a_z0_force_x_;
        let t20_ = minus_a_k_xx_ + t19_;
        let t21_ = a_b_y_z_ * a_z0_force_y_;
        let t22_ = a_k_yy_ - t21_;
        let t23_ = a_b_y_z_ * a_z0_force_x_;
        let t24_ = a_k_xy_ - t23_;
        let t25_ = t20_ + t22_;
        let t26_ = sin_a_angle_ * t25_;
        let t27_ = c_(2.0) * t24_;
        let t28_ = cos_a_angle_ * t27_;
        let t29_ = t26_ - t28_;
        let t30_ = cos_a_angle_ * t29_;
        let minus_crank_pin_k_xy_ = t24_ + t30_;
        let minus_crank_pin_b_x_z_ = c_(0.2) * minus_crank_pin_k_xy_;
        let t31_ = sin_a_angle_ * t29_;
        let t32_ = t22_ - t31_;
        let t33_ = c_(0.2) * t32_;
        let crank_pin_b_y_z_ = c_(0.1) + t33_;
        let t34_ = c_(0.04000000000000001) * t32_;
        let crank_pin_j_zz_ = c_(0.020000000000000004) + t34_;
        let t35_ = minus_a_e_moment_z_ * t18_;
        let t36_ = a_b_x_z_ * t35_;
        let t37_ = minus_a_e_force_x_ - t36_;
        let t38_ = a_b_y_z_ * t35_;
        let t39_ = minus_a_e_force_y_ - t38_;
        let t40_ = minus_a_drift_lin_x_ * t20_;
        let t41_ = a_drift_lin_y_ * t24_;
        let t42_ = t40_ + t41_;
        let t43_ = minus_a_drift_lin_x_ * t24_;
        let t44_ = a_drift_lin_y_ * t22_;
        let t45_ = t43_ - t44_;
        let t46_ = t37_ - t42_;
        let t47_ = t39_ + t45_;
        let t48_ = sin_a_angle_ * t46_;
        let t49_ = cos_a_angle_ * t47_;
        let minus_crank_pin_e_force_y_ = t48_ + t49_;
        let minus_crank_pin_e_moment_z_ = c_(0.2) * minus_crank_pin_e_force_y_;
        let t50_ = T::recip(crank_pin_j_zz_);
        let minus_crank_pin_z0_force_x_ = minus_crank_pin_b_x_z_ * t50_;
        let crank_pin_z0_force_y_ = crank_pin_b_y_z_ * t50_;
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 124 mul, 70 add, 6 reciprocal, 6 square root.
        let t51_ = c_(0.6) * sin_rocker_pin_angle_;
        let t52_ = sin_rocker_pin_angle_ * c_(2.5);
        let t53_ = sin_rocker_pin_angle_ * c_(1.5);
        let t54_ = sin_rocker_pin_angle_ - t53_;
        let t55_ = t51_ * t52_;
        let t56_ = cos_b_angle_ * cos_rocker_pin_angle_;
        let t57_ = sin_b_angle_ * t54_;
        let t58_ = t56_ - t57_;
        let t59_ = sin_b_angle_ * cos_rocker_pin_angle_;
        let t60_ = cos_b_angle_ * t54_;
        let t61_ = t59_ + t60_;
        let t62_ = c_(0.6) * t61_;
        let t63_ = t62_ * t18_;
        let t64_ = t62_ * a_z0_force_x_;
        let t65_ = t58_ - t64_;
        let t66_ = t62_ * a_z0_force_y_;
        let t67_ = t61_ - t66_;
        let t68_ = t62_ * t63_;
        let t69_ = t55_ + t68_;
        let t70_ = sin_a_angle_ * t65_;
        let t71_ = cos_a_angle_ * t67_;
        let t72_ = t70_ + t71_;
        let t73_ = c_(0.2) * t72_;
        let t74_ = t73_ * t50_;
        let t75_ = t73_ * t74_;
        let closure_d0_ = t69_ + t75_;
        let t76_ = c_(0.6) * cos_rocker_pin_angle_;
        let t77_ = cos_rocker_pin_angle_ * c_(2.5);
        let t78_ = cos_rocker_pin_angle_ * cos_rocker_pin_angle_;
        let t79_ = sin_rocker_pin_angle_ * sin_rocker_pin_angle_;
        let t80_ = t78_ + t79_;
        let t81_ = t51_ * t51_;
        let t82_ = t80_ * c_(0.36);
        let t83_ = t81_ + t82_;
        let t84_ = t83_ * c_(4.166666666666667);
        let t85_ = cos_rocker_pin_angle_ * c_(1.5);
        let t86_ = cos_rocker_pin_angle_ - t85_;
        let t87_ = t76_ * t52_;
        let t88_ = t76_ * t77_;
        let t89_ = cos_b_angle_ * sin_rocker_pin_angle_;
        let t90_ = sin_b_angle_ * t86_;
        let t91_ = t89_ + t90_;
        let t92_ = sin_b_angle_ * sin_rocker_pin_angle_;
        let t93_ = cos_b_angle_ * t86_;
        let t94_ = t92_ - t93_;
        let t95_ = c_(0.6) * t94_;
        let t96_ = t95_ * t18_;
        let t97_ = t58_ * t58_;
        let t98_ = t61_ * t61_;
        let t99_ = t97_ + t98_;
        let t100_ = t62_ * t62_;
        let t101_ = t99_ * c_(0.72);
        let t102_ = t100_ + t101_;
        let t103_ = t18_ * t102_;
        let t104_ = t84_ + t103_;
        let t105_ = t95_ * a_z0_force_x_;
        let t106_ = t91_ - t105_;
        let t107_ = t95_ * a_z0_force_y_;
        let t108_ = t94_ - t107_;
        let t109_ = t95_ * t63_;
        let t110_ = t87_ - t109_;
        let t111_ = t95_ * t96_;
        let t112_ = t88_ + t111_;
        let t113_ = cos_a_angle_ * t65_;
        let t114_ = sin_a_angle_ * t67_;
        let t115_ = t113_ - t114_;
        let t116_ = sin_a_angle_ * t106_;
        let t117_ = cos_a_angle_ * t108_;
        let t118_ = t116_ + t117_;
        let t119_ = c_(0.2) * t118_;
        let t120_ = t119_ * t50_;
        let t121_ = t115_ * t115_;
        let t122_ = t72_ * t72_;
        let t123_ = t121_ + t122_;
        let t124_ = t73_ * t73_;
        let t125_ = t123_ * c_(0.76);
        let t126_ = t124_ + t125_;
        let t127_ = t50_ * t126_;
        let t128_ = t104_ + t127_;
        let t129_ = t119_ * t74_;
        let t130_ = t110_ - t129_;
        let t131_ = t119_ * t120_;
        let t132_ = t112_ + t131_;
        let t133_ = T::copysign(closure_d0_, c_(1.0));
        let t134_ = closure_d0_ + t133_;
        let t135_ = c_(0.5) * t134_;
        let t136_ = T::sqrt(t135_);
        let t137_ = T::sqrt(t128_);
        let t138_ = ::mstmm::generated::recip_above(t136_, t137_);
        let t139_ = t136_ * t138_;
        let t140_ = ::mstmm::generated::recip_above(closure_d0_, closure_d0_);
        let t141_ = t139_ * t140_;
        let t142_ = t130_ * t141_;
        let t143_ = t130_ * t142_;
        let closure_d1_ = t132_ - t143_;
        let t144_ = cos_rocker_pin_angle_ * minus_b_e_force_x_;
        let t145_ = sin_rocker_pin_angle_ * minus_b_e_force_x_;
        let t146_ = t145_ - c_(9.8);
        let t147_ = t76_ * t76_;
        let t148_ = t82_ + t147_;
        let t149_ = c_(4.166666666666667) * t148_;
        let t150_ = minus_b_drift_lin_x_ * cos_rocker_pin_angle_;
        let t151_ = b_drift_lin_y_ * t54_;
        let t152_ = t150_ - t151_;
        let t153_ = minus_b_drift_lin_x_ * sin_rocker_pin_angle_;
        let t154_ = b_drift_lin_y_ * t86_;
        let t155_ = t153_ + t154_;
        let t156_ = t62_ * t35_;
        let t157_ = t152_ - t156_;
        let t158_ = t95_ * t35_;
        let t159_ = t155_ - t158_;
        let t160_ = t91_ * t91_;
        let t161_ = t94_ * t94_;
        let t162_ = t160_ + t161_;
        let t163_ = t95_ * t95_;
        let t164_ = c_(0.72) * t162_;
        let t165_ = t163_ + t164_;
        let t166_ = t18_ * t165_;
        let t167_ = t149_ + t166_;
        let t168_ = minus_a_drift_lin_x_ * t65_;
        let t169_ = a_drift_lin_y_ * t67_;
        let t170_ = t168_ - t169_;
        let t171_ = t157_ + t170_;
        let t172_ = minus_a_drift_lin_x_ * t106_;
        let t173_ = a_drift_lin_y_ * t108_;
        let t174_ = t172_ - t173_;
        let t175_ = t159_ + t174_;
        let t176_ = cos_a_angle_ * t106_;
        let t177_ = sin_a_angle_ * t108_;
        let t178_ = t176_ - t177_;
        let t179_ = crank_pin_input0_ + minus_crank_pin_e_moment_z_;
        let t180_ = t50_ * t179_;
        let t181_ = t73_ * minus_crank_pin_z0_force_x_;
        let t182_ = t115_ + t181_;
        let t183_ = t73_ * crank_pin_z0_force_y_;
        let t184_ = t72_ - t183_;
        let t185_ = t73_ * t180_;
        let t186_ = t171_ - t185_;
        let t187_ = t119_ * minus_crank_pin_z0_force_x_;
        let t188_ = t178_ + t187_;
        let t189_ = t119_ * crank_pin_z0_force_y_;
        let t190_ = t118_ - t189_;
        let t191_ = t119_ * t180_;
        let t192_ = t175_ - t191_;
        let t193_ = t178_ * t178_;
        let t194_ = t118_ * t118_;
        let t195_ = t193_ + t194_;
        let t196_ = t119_ * t119_;
        let t197_ = c_(0.76) * t195_;
        let t198_ = t196_ + t197_;
        let t199_ = t50_ * t198_;
        let t200_ = t167_ + t199_;
        let crank_pin_a_lin_x_ = sin_crank_pin_angle_ * c_(9.8);
        let crank_pin_a_lin_y_ = cos_crank_pin_angle_ * c_(9.8);
        let t201_ = t182_ * crank_pin_a_lin_x_;
        let t202_ = t184_ * crank_pin_a_lin_y_;
        let t203_ = t201_ + t202_;
        let t204_ = t186_ - t203_;
        let t205_ = t188_ * crank_pin_a_lin_x_;
        let t206_ = t190_ * crank_pin_a_lin_y_;
        let t207_ = t205_ + t206_;
        let t208_ = t192_ - t207_;
        let t209_ = t144_ + t204_;
        let t210_ = t146_ + t208_;
        let t211_ = T::copysign(closure_d1_, c_(1.0));
        let t212_ = closure_d1_ + t211_;
        let t213_ = c_(0.5) * t212_;
        let t214_ = T::sqrt(t213_);
        let t215_ = T::sqrt(t200_);
        let t216_ = ::mstmm::generated::recip_above(t214_, t215_);
        let t217_ = t214_ * t216_;
        let t218_ = ::mstmm::generated::recip_above(closure_d1_, t132_);
        let t219_ = t217_ * t218_;
        let t220_ = t209_ * t142_;
        let t221_ = t210_ + t220_;
        let t222_ = t209_ * t141_;
        let t223_ = t219_ * t221_;
        let t224_ = t142_ * t223_;
        let t225_ = t222_ + t224_;
        let t226_ = closure_d0_ * t141_;
        let t227_ = c_(1.0) - t226_;
        let t228_ = t227_ * t227_;
        let t229_ = ::mstmm::generated::recip_above(t228_, c_(1.0));
        let t230_ = T::sqrt(t229_);
        let t231_ = t227_ * t230_;
        let t232_ = t225_ * t231_;
        let t233_ = t231_ * t232_;
        let t234_ = t225_ - t233_;
        let t235_ = closure_d1_ * t219_;
        let t236_ = c_(1.0) - t235_;
        let t237_ = t142_ * t236_;
        let t238_ = t231_ * t237_;
        let t239_ = t231_ * t238_;
        let t240_ = t237_ - t239_;
        let t241_ = t240_ * t240_;
        let t242_ = t236_ * t236_;
        let t243_ = t241_ + t242_;
        let t244_ = ::mstmm::generated::recip_above(t243_, c_(1.0));
        let t245_ = T::sqrt(t244_);
        let t246_ = t240_ * t245_;
        let t247_ = t236_ * t245_;
        let t248_ = t234_ * t246_;
        let t249_ = t223_ * t247_;
        let t250_ = t248_ + t249_;
        let t251_ = t246_ * t250_;
        let minus_closure_reaction0_ = t234_ - t251_;
        let t252_ = t247_ * t250_;
        let closure_reaction1_ = t223_ - t252_;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 4 mul, 4 add, 0 reciprocal.
        let t253_ = t74_ * minus_closure_reaction0_;
        let t254_ = t120_ * closure_reaction1_;
        let t255_ = t253_ + t254_;
        let t256_ = t180_ + t255_;
        let t257_ = minus_crank_pin_z0_force_x_ * crank_pin_a_lin_x_;
        let t258_ = crank_pin_z0_force_y_ * crank_pin_a_lin_y_;
        let t259_ = t257_ - t258_;
        let crank_pin_a_ang_z_ = t256_ + t259_;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 9 mul, 9 add, 0 reciprocal.
        let t260_ = c_(0.2) * crank_pin_a_ang_z_;
        let t261_ = crank_pin_a_lin_y_ + t260_;
        let t262_ = cos_a_angle_ * crank_pin_a_lin_x_;
        let t263_ = sin_a_angle_ * t261_;
        let t264_ = t262_ + t263_;
        let minus_a_a_lin_x_ = minus_a_drift_lin_x_ - t264_;
        let t265_ = sin_a_angle_ * crank_pin_a_lin_x_;
        let t266_ = cos_a_angle_ * t261_;
        let t267_ = t265_ - t266_;
        let a_a_lin_y_ = a_drift_lin_y_ - t267_;
        let t268_ = t63_ * minus_closure_reaction0_;
        let t269_ = t96_ * closure_reaction1_;
        let t270_ = t268_ + t269_;
        let t271_ = t35_ + t270_;
        let t272_ = a_z0_force_x_ * minus_a_a_lin_x_;
        let t273_ = a_z0_force_y_ * a_a_lin_y_;
        let t274_ = t272_ - t273_;
        let a_a_ang_z_ = t271_ + t274_;
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 6 mul, 5 add, 0 reciprocal.
        let t275_ = c_(0.6) * a_a_ang_z_;
        let t276_ = a_a_lin_y_ + t275_;
        let t277_ = sin_b_angle_ * minus_a_a_lin_x_;
        let t278_ = cos_b_angle_ * t276_;
        let t279_ = t277_ + t278_;
        let b_a_lin_y_ = b_drift_lin_y_ + t279_;
        let t280_ = t52_ * minus_closure_reaction0_;
        let t281_ = t77_ * closure_reaction1_;
        let t282_ = t280_ - t281_;
        let t283_ = c_(2.5) * b_a_lin_y_;
        let b_a_ang_z_ = t282_ - t283_;
        /// Results: 1 mul, 5 add, 0 reciprocal.
        let t284_ = crank_pin_a_ang_z_ - a_a_ang_z_;
        let t285_ = a_a_ang_z_ - b_a_ang_z_;
        let t286_ = t20_ - t22_;
        let t287_ = c_(4.0) - t286_;
        let t288_ = t287_ * c_(0.04000000000000001);
        let t289_ = t288_ + c_(0.030000000000000006);
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
            [c_(2.04), t289_],
            [crank_pin_a_ang_z_, -t284_, -t285_, -b_a_ang_z_],
        )?;
        accelerations_.data.0 = [[crank_pin_a_ang_z_, -t284_, -t285_, -b_a_ang_z_]];
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
        /// Riccati transfer over `a`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 15 mul, 9 add, 1 reciprocal.
        let t5_ = sin_b_angle_ * c_(1.5);
        let t6_ = sin_b_angle_ * t5_;
        let minus_a_k_xx_ = t6_ - c_(4.0);
        let a_k_yy_ = c_(2.5) + t6_;
        let a_k_xy_ = cos_b_angle_ * t5_;
        let a_b_x_z_ = c_(0.6) * a_k_xy_;
        let t7_ = c_(0.5) + t6_;
        let t8_ = c_(0.6) * t7_;
        let a_b_y_z_ = c_(0.6) + t8_;
        let t9_ = c_(0.36) * t7_;
        let a_j_zz_ = c_(0.24) + t9_;
        let t10_ = minus_b_drift_lin_x_ * c_(2.0);
        let t11_ = b_drift_lin_y_ * c_(0.5);
        let t12_ = minus_b_e_force_x_ + t10_;
        let t13_ = cos_b_angle_ * t12_;
        let t14_ = sin_b_angle_ * t11_;
        let t15_ = t13_ + t14_;
        let minus_a_e_force_x_ = t3_ + t15_;
        let t16_ = sin_b_angle_ * t12_;
        let t17_ = cos_b_angle_ * t11_;
        let minus_a_e_force_y_ = t16_ - t17_;
        let minus_a_e_moment_z_ = c_(0.6) * minus_a_e_force_y_;
        let t18_ = T::recip(a_j_zz_);
        let a_z0_force_x_ = a_b_x_z_ * t18_;
        let a_z0_force_y_ = a_b_y_z_ * t18_;
        /// Riccati transfer over `crank_pin`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 23 mul, 16 add, 1 reciprocal.
        let t19_ = a_b_x_z_ * a_z0_force_x_;
        let t20_ = minus_a_k_xx_ + t19_;
        let t21_ = a_b_y_z_ * a_z0_force_y_;
        let t22_ = a_k_yy_ - t21_;
        let t23_ = a_b_y_z_ * a_z0_force_x_;
        let t24_ = a_k_xy_ - t23_;
        let t25_ = t20_ + t22_;
        let t26_ = sin_a_angle_ * t25_;
        let t27_ = c_(2.0) * t24_;
        let t28_ = cos_a_angle_ * t27_;
        let t29_ = t26_ - t28_;
        let t30_ = cos_a_angle_ * t29_;
        let minus_crank_pin_k_xy_ = t24_ + t30_;
        let minus_crank_pin_b_x_z_ = c_(0.2) * minus_crank_pin_k_xy_;
        let t31_ = sin_a_angle_ * t29_;
        let t32_ = t22_ - t31_;
        let t33_ = c_(0.2) * t32_;
        let crank_pin_b_y_z_ = c_(0.1) + t33_;
        let t34_ = c_(0.04000000000000001) * t32_;
        let crank_pin_j_zz_ = c_(0.020000000000000004) + t34_;
        let t35_ = minus_a_e_moment_z_ * t18_;
        let t36_ = a_b_x_z_ * t35_;
        let t37_ = minus_a_e_force_x_ - t36_;
        let t38_ = a_b_y_z_ * t35_;
        let t39_ = minus_a_e_force_y_ - t38_;
        let t40_ = minus_a_drift_lin_x_ * t20_;
        let t41_ = a_drift_lin_y_ * t24_;
        let t42_ = t40_ + t41_;
        let t43_ = minus_a_drift_lin_x_ * t24_;
        let t44_ = a_drift_lin_y_ * t22_;
        let t45_ = t43_ - t44_;
        let t46_ = t37_ - t42_;
        let t47_ = t39_ + t45_;
        let t48_ = sin_a_angle_ * t46_;
        let t49_ = cos_a_angle_ * t47_;
        let minus_crank_pin_e_force_y_ = t48_ + t49_;
        let minus_crank_pin_e_moment_z_ = c_(0.2) * minus_crank_pin_e_force_y_;
        let t50_ = T::recip(crank_pin_j_zz_);
        let minus_crank_pin_z0_force_x_ = minus_crank_pin_b_x_z_ * t50_;
        let crank_pin_z0_force_y_ = crank_pin_b_y_z_ * t50_;
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 124 mul, 70 add, 6 reciprocal, 6 square root.
        let t51_ = c_(0.6) * sin_rocker_pin_angle_;
        let t52_ = sin_rocker_pin_angle_ * c_(2.5);
        let t53_ = sin_rocker_pin_angle_ * c_(1.5);
        let t54_ = sin_rocker_pin_angle_ - t53_;
        let t55_ = t51_ * t52_;
        let t56_ = cos_b_angle_ * cos_rocker_pin_angle_;
        let t57_ = sin_b_angle_ * t54_;
        let t58_ = t56_ - t57_;
        let t59_ = sin_b_angle_ * cos_rocker_pin_angle_;
        let t60_ = cos_b_angle_ * t54_;
        let t61_ = t59_ + t60_;
        let t62_ = c_(0.6) * t61_;
        let t63_ = t62_ * t18_;
        let t64_ = t62_ * a_z0_force_x_;
        let t65_ = t58_ - t64_;
        let t66_ = t62_ * a_z0_force_y_;
        let t67_ = t61_ - t66_;
        let t68_ = t62_ * t63_;
        let t69_ = t55_ + t68_;
        let t70_ = sin_a_angle_ * t65_;
        let t71_ = cos_a_angle_ * t67_;
        let t72_ = t70_ + t71_;
        let t73_ = c_(0.2) * t72_;
        let t74_ = t73_ * t50_;
        let t75_ = t73_ * t74_;
        let closure_d0_ = t69_ + t75_;
        let t76_ = c_(0.6) * cos_rocker_pin_angle_;
        let t77_ = cos_rocker_pin_angle_ * c_(2.5);
        let t78_ = cos_rocker_pin_angle_ * cos_rocker_pin_angle_;
        let t79_ = sin_rocker_pin_angle_ * sin_rocker_pin_angle_;
        let t80_ = t78_ + t79_;
        let t81_ = t51_ * t51_;
        let t82_ = t80_ * c_(0.36);
        let t83_ = t81_ + t82_;
        let t84_ = t83_ * c_(4.166666666666667);
        let t85_ = cos_rocker_pin_angle_ * c_(1.5);
        let t86_ = cos_rocker_pin_angle_ - t85_;
        let t87_ = t76_ * t52_;
        let t88_ = t76_ * t77_;
        let t89_ = cos_b_angle_ * sin_rocker_pin_angle_;
        let t90_ = sin_b_angle_ * t86_;
        let t91_ = t89_ + t90_;
        let t92_ = sin_b_angle_ * sin_rocker_pin_angle_;
        let t93_ = cos_b_angle_ * t86_;
        let t94_ = t92_ - t93_;
        let t95_ = c_(0.6) * t94_;
        let t96_ = t95_ * t18_;
        let t97_ = t58_ * t58_;
        let t98_ = t61_ * t61_;
        let t99_ = t97_ + t98_;
        let t100_ = t62_ * t62_;
        let t101_ = t99_ * c_(0.72);
        let t102_ = t100_ + t101_;
        let t103_ = t18_ * t102_;
        let t104_ = t84_ + t103_;
        let t105_ = t95_ * a_z0_force_x_;
        let t106_ = t91_ - t105_;
        let t107_ = t95_ * a_z0_force_y_;
        let t108_ = t94_ - t107_;
        let t109_ = t95_ * t63_;
        let t110_ = t87_ - t109_;
        let t111_ = t95_ * t96_;
        let t112_ = t88_ + t111_;
        let t113_ = cos_a_angle_ * t65_;
        let t114_ = sin_a_angle_ * t67_;
        let t115_ = t113_ - t114_;
        let t116_ = sin_a_angle_ * t106_;
        let t117_ = cos_a_angle_ * t108_;
        let t118_ = t116_ + t117_;
        let t119_ = c_(0.2) * t118_;
        let t120_ = t119_ * t50_;
        let t121_ = t115_ * t115_;
        let t122_ = t72_ * t72_;
        let t123_ = t121_ + t122_;
        let t124_ = t73_ * t73_;
        let t125_ = t123_ * c_(0.76);
        let t126_ = t124_ + t125_;
        let t127_ = t50_ * t126_;
        let t128_ = t104_ + t127_;
        let t129_ = t119_ * t74_;
        let t130_ = t110_ - t129_;
        let t131_ = t119_ * t120_;
        let t132_ = t112_ + t131_;
        let t133_ = T::copysign(closure_d0_, c_(1.0));
        let t134_ = closure_d0_ + t133_;
        let t135_ = c_(0.5) * t134_;
        let t136_ = T::sqrt(t135_);
        let t137_ = T::sqrt(t128_);
        let t138_ = ::mstmm::generated::recip_above(t136_, t137_);
        let t139_ = t136_ * t138_;
        let t140_ = ::mstmm::generated::recip_above(closure_d0_, closure_d0_);
        let t141_ = t139_ * t140_;
        let t142_ = t130_ * t141_;
        let t143_ = t130_ * t142_;
        let closure_d1_ = t132_ - t143_;
        let t144_ = cos_rocker_pin_angle_ * minus_b_e_force_x_;
        let t145_ = sin_rocker_pin_angle_ * minus_b_e_force_x_;
        let t146_ = t145_ - c_(9.8);
        let t147_ = t76_ * t76_;
        let t148_ = t82_ + t147_;
        let t149_ = c_(4.166666666666667) * t148_;
        let t150_ = minus_b_drift_lin_x_ * cos_rocker_pin_angle_;
        let t151_ = b_drift_lin_y_ * t54_;
        let t152_ = t150_ - t151_;
        let t153_ = minus_b_drift_lin_x_ * sin_rocker_pin_angle_;
        let t154_ = b_drift_lin_y_ * t86_;
        let t155_ = t153_ + t154_;
        let t156_ = t62_ * t35_;
        let t157_ = t152_ - t156_;
        let t158_ = t95_ * t35_;
        let t159_ = t155_ - t158_;
        let t160_ = t91_ * t91_;
        let t161_ = t94_ * t94_;
        let t162_ = t160_ + t161_;
        let t163_ = t95_ * t95_;
        let t164_ = c_(0.72) * t162_;
        let t165_ = t163_ + t164_;
        let t166_ = t18_ * t165_;
        let t167_ = t149_ + t166_;
        let t168_ = minus_a_drift_lin_x_ * t65_;
        let t169_ = a_drift_lin_y_ * t67_;
        let t170_ = t168_ - t169_;
        let t171_ = t157_ + t170_;
        let t172_ = minus_a_drift_lin_x_ * t106_;
        let t173_ = a_drift_lin_y_ * t108_;
        let t174_ = t172_ - t173_;
        let t175_ = t159_ + t174_;
        let t176_ = cos_a_angle_ * t106_;
        let t177_ = sin_a_angle_ * t108_;
        let t178_ = t176_ - t177_;
        let t179_ = crank_pin_input0_ + minus_crank_pin_e_moment_z_;
        let t180_ = t50_ * t179_;
        let t181_ = t73_ * minus_crank_pin_z0_force_x_;
        let t182_ = t115_ + t181_;
        let t183_ = t73_ * crank_pin_z0_force_y_;
        let t184_ = t72_ - t183_;
        let t185_ = t73_ * t180_;
        let t186_ = t171_ - t185_;
        let t187_ = t119_ * minus_crank_pin_z0_force_x_;
        let t188_ = t178_ + t187_;
        let t189_ = t119_ * crank_pin_z0_force_y_;
        let t190_ = t118_ - t189_;
        let t191_ = t119_ * t180_;
        let t192_ = t175_ - t191_;
        let t193_ = t178_ * t178_;
        let t194_ = t118_ * t118_;
        let t195_ = t193_ + t194_;
        let t196_ = t119_ * t119_;
        let t197_ = c_(0.76) * t195_;
        let t198_ = t196_ + t197_;
        let t199_ = t50_ * t198_;
        let t200_ = t167_ + t199_;
        let crank_pin_a_lin_x_ = sin_crank_pin_angle_ * c_(9.8);
        let crank_pin_a_lin_y_ = cos_crank_pin_angle_ * c_(9.8);
        let t201_ = t182_ * crank_pin_a_lin_x_;
        let t202_ = t184_ * crank_pin_a_lin_y_;
        let t203_ = t201_ + t202_;
        let t204_ = t186_ - t203_;
        let t205_ = t188_ * crank_pin_a_lin_x_;
        let t206_ = t190_ * crank_pin_a_lin_y_;
        let t207_ = t205_ + t206_;
        let t208_ = t192_ - t207_;
        let t209_ = t144_ + t204_;
        let t210_ = t146_ + t208_;
        let t211_ = T::copysign(closure_d1_, c_(1.0));
        let t212_ = closure_d1_ + t211_;
        let t213_ = c_(0.5) * t212_;
        let t214_ = T::sqrt(t213_);
        let t215_ = T::sqrt(t200_);
        let t216_ = ::mstmm::generated::recip_above(t214_, t215_);
        let t217_ = t214_ * t216_;
        let t218_ = ::mstmm::generated::recip_above(closure_d1_, t132_);
        let t219_ = t217_ * t218_;
        let t220_ = t209_ * t142_;
        let t221_ = t210_ + t220_;
        let t222_ = t209_ * t141_;
        let t223_ = t219_ * t221_;
        let t224_ = t142_ * t223_;
        let t225_ = t222_ + t224_;
        let t226_ = closure_d0_ * t141_;
        let t227_ = c_(1.0) - t226_;
        let t228_ = t227_ * t227_;
        let t229_ = ::mstmm::generated::recip_above(t228_, c_(1.0));
        let t230_ = T::sqrt(t229_);
        let t231_ = t227_ * t230_;
        let t232_ = t225_ * t231_;
        let t233_ = t231_ * t232_;
        let t234_ = t225_ - t233_;
        let t235_ = closure_d1_ * t219_;
        let t236_ = c_(1.0) - t235_;
        let t237_ = t142_ * t236_;
        let t238_ = t231_ * t237_;
        let t239_ = t231_ * t238_;
        let t240_ = t237_ - t239_;
        let t241_ = t240_ * t240_;
        let t242_ = t236_ * t236_;
        let t243_ = t241_ + t242_;
        let t244_ = ::mstmm::generated::recip_above(t243_, c_(1.0));
        let t245_ = T::sqrt(t244_);
        let t246_ = t240_ * t245_;
        let t247_ = t236_ * t245_;
        let t248_ = t234_ * t246_;
        let t249_ = t223_ * t247_;
        let t250_ = t248_ + t249_;
        let t251_ = t246_ * t250_;
        let minus_closure_reaction0_ = t234_ - t251_;
        let t252_ = t247_ * t250_;
        let closure_reaction1_ = t223_ - t252_;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 4 mul, 4 add, 0 reciprocal.
        let t253_ = t74_ * minus_closure_reaction0_;
        let t254_ = t120_ * closure_reaction1_;
        let t255_ = t253_ + t254_;
        let t256_ = t180_ + t255_;
        let t257_ = minus_crank_pin_z0_force_x_ * crank_pin_a_lin_x_;
        let t258_ = crank_pin_z0_force_y_ * crank_pin_a_lin_y_;
        let t259_ = t257_ - t258_;
        let crank_pin_a_ang_z_ = t256_ + t259_;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 9 mul, 9 add, 0 reciprocal.
        let t260_ = c_(0.2) * crank_pin_a_ang_z_;
        let t261_ = crank_pin_a_lin_y_ + t260_;
        let t262_ = cos_a_angle_ * crank_pin_a_lin_x_;
        let t263_ = sin_a_angle_ * t261_;
        let t264_ = t262_ + t263_;
        let minus_a_a_lin_x_ = minus_a_drift_lin_x_ - t264_;
        let t265_ = sin_a_angle_ * crank_pin_a_lin_x_;
        let t266_ = cos_a_angle_ * t261_;
        let t267_ = t265_ - t266_;
        let a_a_lin_y_ = a_drift_lin_y_ - t267_;
        let t268_ = t63_ * minus_closure_reaction0_;
        let t269_ = t96_ * closure_reaction1_;
        let t270_ = t268_ + t269_;
        let t271_ = t35_ + t270_;
        let t272_ = a_z0_force_x_ * minus_a_a_lin_x_;
        let t273_ = a_z0_force_y_ * a_a_lin_y_;
        let t274_ = t272_ - t273_;
        let a_a_ang_z_ = t271_ + t274_;
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 8 mul, 7 add, 0 reciprocal.
        let t275_ = c_(0.6) * a_a_ang_z_;
        let t276_ = a_a_lin_y_ + t275_;
        let t277_ = cos_b_angle_ * minus_a_a_lin_x_;
        let t278_ = sin_b_angle_ * t276_;
        let t279_ = t277_ - t278_;
        let minus_b_a_lin_x_ = minus_b_drift_lin_x_ + t279_;
        let t280_ = sin_b_angle_ * minus_a_a_lin_x_;
        let t281_ = cos_b_angle_ * t276_;
        let t282_ = t280_ + t281_;
        let b_a_lin_y_ = b_drift_lin_y_ + t282_;
        let t283_ = t52_ * minus_closure_reaction0_;
        let t284_ = t77_ * closure_reaction1_;
        let t285_ = t283_ - t284_;
        let t286_ = c_(2.5) * b_a_lin_y_;
        let b_a_ang_z_ = t285_ - t286_;
        /// Motion across `a`, [P, Eqs. (1), (13), (36)]: 10 mul, 2 add, 0 reciprocal.
        let t287_ = cos_crank_pin_angle_ * cos_a_angle_;
        let t288_ = sin_crank_pin_angle_ * sin_a_angle_;
        let a_axes_x_x_ = t287_ - t288_;
        let t289_ = cos_crank_pin_angle_ * sin_a_angle_;
        let t290_ = sin_crank_pin_angle_ * cos_a_angle_;
        let minus_a_axes_x_y_ = t289_ + t290_;
        let t291_ = cos_crank_pin_angle_ * c_(0.2);
        let t292_ = crank_pin_rate_ * t291_;
        let minus_a_drift_lin_x_2_ = crank_pin_rate_ * t292_;
        let t293_ = sin_crank_pin_angle_ * c_(0.2);
        let t294_ = crank_pin_rate_ * t293_;
        let minus_a_drift_lin_y_ = crank_pin_rate_ * t294_;
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 10 mul, 2 add, 0 reciprocal.
        let t295_ = cos_b_angle_ * a_axes_x_x_;
        let t296_ = sin_b_angle_ * minus_a_axes_x_y_;
        let b_axes_x_x_ = t295_ - t296_;
        let t297_ = sin_b_angle_ * a_axes_x_x_;
        let t298_ = cos_b_angle_ * minus_a_axes_x_y_;
        let minus_b_axes_x_y_ = t297_ + t298_;
        let t299_ = c_(0.6) * a_axes_x_x_;
        let t300_ = a_omega_z_ * t299_;
        let minus_b_drift_lin_x_2_ = a_omega_z_ * t300_;
        let t301_ = c_(0.6) * minus_a_axes_x_y_;
        let t302_ = a_omega_z_ * t301_;
        let minus_b_drift_lin_y_ = a_omega_z_ * t302_;
        /// Point of `a`, [P, Eqs. (12), (13), (36)]: 2 mul, 2 add, 0 reciprocal.
        let t303_ = crank_pin_a_ang_z_ * t293_;
        let minus_a_acc_lin_x_ = minus_a_drift_lin_x_2_ + t303_;
        let t304_ = crank_pin_a_ang_z_ * t291_;
        let minus_a_acc_lin_y_ = minus_a_drift_lin_y_ - t304_;
        /// Point of `b`, [P, Eqs. (12), (13), (36)]: 2 mul, 4 add, 0 reciprocal.
        let t305_ = a_a_ang_z_ * t301_;
        let t306_ = minus_a_acc_lin_x_ + t305_;
        let minus_b_acc_lin_x_ = minus_b_drift_lin_x_2_ + t306_;
        let t307_ = a_a_ang_z_ * t299_;
        let t308_ = minus_a_acc_lin_y_ - t307_;
        let minus_b_acc_lin_y_ = minus_b_drift_lin_y_ + t308_;
        /// Load of the body at `crank_pin`, [P, Eqs. (18), (19)]: 7 mul, 4 add, 0 reciprocal.
        let t309_ = crank_pin_rate_ * c_(0.1);
        let t310_ = crank_pin_rate_ * t309_;
        let t311_ = c_(0.1) * crank_pin_a_ang_z_;
        let t312_ = crank_pin_a_lin_y_ + t311_;
        let t313_ = t310_ - crank_pin_a_lin_x_;
        let t314_ = cos_crank_pin_angle_ * t313_;
        let t315_ = sin_crank_pin_angle_ * t312_;
        let minus_crank_pin_own_force_x_ = t314_ + t315_;
        let t316_ = sin_crank_pin_angle_ * t313_;
        let t317_ = cos_crank_pin_angle_ * t312_;
        let minus_crank_pin_own_force_y_ = t316_ - t317_;
        /// Load of the body at `a`, [P, Eqs. (18), (19)]: 6 mul, 4 add, 0 reciprocal.
        let t318_ = c_(2.0) * minus_a_a_lin_x_;
        let t319_ = c_(2.0) * a_a_lin_y_;
        let t320_ = t275_ + t319_;
        let t321_ = t3_ + t318_;
        let t322_ = a_axes_x_x_ * t321_;
        let t323_ = minus_a_axes_x_y_ * t320_;
        let minus_a_own_force_x_ = t322_ + t323_;
        let t324_ = minus_a_axes_x_y_ * t321_;
        let t325_ = a_axes_x_x_ * t320_;
        let minus_a_own_force_y_ = t324_ - t325_;
        /// Load of the body at `b`, [P, Eqs. (18), (19)]: 7 mul, 4 add, 0 reciprocal.
        let t326_ = c_(0.6) * b_a_ang_z_;
        let t327_ = c_(2.0) * minus_b_a_lin_x_;
        let t328_ = c_(2.0) * b_a_lin_y_;
        let t329_ = t326_ + t328_;
        let t330_ = minus_b_e_force_x_ + t327_;
        let t331_ = b_axes_x_x_ * t330_;
        let t332_ = minus_b_axes_x_y_ * t329_;
        let minus_b_own_force_x_ = t331_ + t332_;
        let t333_ = minus_b_axes_x_y_ * t330_;
        let t334_ = b_axes_x_x_ * t329_;
        let minus_b_own_force_y_ = t333_ - t334_;
        /// Load on `rocker_pin`, [P, Eqs. (18), (19)]: 8 mul, 4 add, 0 reciprocal.
        let t335_ = cos_rocker_pin_angle_ * minus_closure_reaction0_;
        let t336_ = sin_rocker_pin_angle_ * closure_reaction1_;
        let t337_ = t335_ + t336_;
        let t338_ = sin_rocker_pin_angle_ * minus_closure_reaction0_;
        let t339_ = cos_rocker_pin_angle_ * closure_reaction1_;
        let t340_ = t338_ - t339_;
        let t341_ = t337_ * b_axes_x_x_;
        let t342_ = t340_ * minus_b_axes_x_y_;
        let minus_rocker_pin_load_force_x_ = t341_ - t342_;
        let t343_ = t337_ * minus_b_axes_x_y_;
        let t344_ = t340_ * b_axes_x_x_;
        let minus_rocker_pin_load_force_y_ = t343_ + t344_;
        /// Load on `b`, [P, Eqs. (18), (19)]: 0 mul, 2 add, 0 reciprocal.
        let minus_b_load_force_x_ = minus_b_own_force_x_
            + minus_rocker_pin_load_force_x_;
        let minus_b_load_force_y_ = minus_b_own_force_y_
            + minus_rocker_pin_load_force_y_;
        /// Load on `a`, [P, Eqs. (18), (19)]: 0 mul, 2 add, 0 reciprocal.
        let minus_a_load_force_x_ = minus_a_own_force_x_ + minus_b_load_force_x_;
        let minus_a_load_force_y_ = minus_a_own_force_y_ + minus_b_load_force_y_;
        /// Load on `crank_pin`, [P, Eqs. (18), (19)]: 0 mul, 2 add, 0 reciprocal.
        let minus_crank_pin_load_force_x_ = minus_crank_pin_own_force_x_
            + minus_a_load_force_x_;
        let minus_crank_pin_load_force_y_ = minus_crank_pin_own_force_y_
            + minus_a_load_force_y_;
        /// Results: 46 mul, 35 add, 0 reciprocal.
        let t345_ = crank_pin_a_ang_z_ - a_a_ang_z_;
        let t346_ = a_a_ang_z_ - b_a_ang_z_;
        let t347_ = t20_ - t22_;
        let t348_ = c_(4.0) - t347_;
        let t349_ = t348_ * c_(0.04000000000000001);
        let t350_ = t349_ + c_(0.030000000000000006);
        let t351_ = cos_crank_pin_angle_ * c_(0.1);
        let t352_ = sin_crank_pin_angle_ * c_(0.1);
        let t353_ = t294_ + t302_;
        let t354_ = t292_ + t300_;
        let t355_ = crank_pin_rate_ * t352_;
        let t356_ = crank_pin_rate_ * t351_;
        let t357_ = crank_pin_rate_ * c_(0.01);
        let t358_ = crank_pin_rate_ * t357_;
        let t359_ = t355_ * t355_;
        let t360_ = t356_ * t356_;
        let t361_ = t359_ + t360_;
        let t362_ = t358_ + t361_;
        let t363_ = a_axes_x_x_ * c_(0.3);
        let t364_ = minus_a_axes_x_y_ * c_(0.3);
        let t365_ = a_omega_z_ * t364_;
        let t366_ = a_omega_z_ * t363_;
        let t367_ = t294_ + t365_;
        let t368_ = t292_ + t366_;
        let t369_ = a_omega_z_ * c_(0.06);
        let t370_ = a_omega_z_ * t369_;
        let t371_ = t367_ * t367_;
        let t372_ = t368_ * t368_;
        let t373_ = t371_ + t372_;
        let t374_ = c_(2.0) * t373_;
        let t375_ = t370_ + t374_;
        let t376_ = b_axes_x_x_ * c_(0.3);
        let t377_ = minus_b_axes_x_y_ * c_(0.3);
        let t378_ = b_omega_z_ * t377_;
        let t379_ = b_omega_z_ * t376_;
        let t380_ = t353_ + t378_;
        let t381_ = t354_ + t379_;
        let t382_ = b_omega_z_ * c_(0.06);
        let t383_ = b_omega_z_ * t382_;
        let t384_ = t380_ * t380_;
        let t385_ = t381_ * t381_;
        let t386_ = t384_ + t385_;
        let t387_ = c_(2.0) * t386_;
        let t388_ = t383_ + t387_;
        let t389_ = c_(0.5) * t388_;
        let t390_ = t362_ + t375_;
        let t391_ = c_(0.5) * t390_;
        let t392_ = t389_ + t391_;
        let t393_ = t293_ + t301_;
        let t394_ = sin_crank_pin_angle_ * c_(0.9800000000000001);
        let t395_ = t293_ + t364_;
        let t396_ = t395_ * c_(19.6);
        let t397_ = t394_ + t396_;
        let t398_ = t393_ + t377_;
        let t399_ = c_(19.6) * t398_;
        let t400_ = t397_ + t399_;
        let t401_ = cos_rocker_pin_angle_ * t231_;
        let t402_ = sin_rocker_pin_angle_ * t231_;
        let t403_ = cos_rocker_pin_angle_ * t246_;
        let t404_ = sin_rocker_pin_angle_ * t247_;
        let t405_ = t403_ + t404_;
        let t406_ = sin_rocker_pin_angle_ * t246_;
        let t407_ = cos_rocker_pin_angle_ * t247_;
        let t408_ = t406_ - t407_;
        let t409_ = t291_ + t299_;
        let t410_ = c_(0.6) * b_axes_x_x_;
        let t411_ = t410_ + t409_;
        let t412_ = c_(0.6) * minus_b_axes_x_y_;
        let t413_ = t412_ + t393_;
        let t414_ = b_omega_z_ * t412_;
        let t415_ = t353_ + t414_;
        let t416_ = b_omega_z_ * t410_;
        let t417_ = t354_ + t416_;
        let t418_ = b_omega_z_ * t416_;
        let t419_ = b_a_ang_z_ * t412_;
        let t420_ = minus_b_acc_lin_x_ + t419_;
        let t421_ = t418_ + t420_;
        let t422_ = b_omega_z_ * t414_;
        let t423_ = b_a_ang_z_ * t410_;
        let t424_ = minus_b_acc_lin_y_ - t423_;
        let t425_ = t422_ + t424_;
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
            [c_(2.04), t350_],
            [crank_pin_a_ang_z_, -t345_, -t346_, -b_a_ang_z_],
        )?;
        at_.accelerations.data.0 = [[crank_pin_a_ang_z_, -t345_, -t346_, -b_a_ang_z_]];
        at_.rate_accelerations.data.0 = [
            [crank_pin_a_ang_z_, -t345_, -t346_, -b_a_ang_z_],
        ];
        at_.efforts.data.0 = [[crank_pin_input0_, c_(0.0), c_(0.0), c_(0.0)]];
        at_.closure = ::mstmm::generated::closure([
            [t401_, t402_, c_(0.0), c_(0.0), c_(0.0), c_(0.0)],
            [-t405_, -t408_, c_(0.0), c_(0.0), c_(0.0), c_(0.0)],
        ]);
        at_.kinetic_energy = t392_;
        at_.potential_energy = t400_;
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
                    [-minus_crank_pin_load_force_x_, -minus_crank_pin_load_force_y_],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [c_(0.0), c_(0.0)],
                [cos_crank_pin_angle_, sin_crank_pin_angle_],
                [c_(0.0), c_(0.0)],
                crank_pin_rate_,
                ::mstmm::PlaneStateVector::new(
                    [c_(0.0), c_(0.0)],
                    crank_pin_a_ang_z_,
                    -crank_pin_input0_,
                    [-minus_crank_pin_load_force_x_, -minus_crank_pin_load_force_y_],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t291_, t293_],
                [cos_crank_pin_angle_, sin_crank_pin_angle_],
                [-t294_, t292_],
                crank_pin_rate_,
                ::mstmm::PlaneStateVector::new(
                    [-minus_a_acc_lin_x_, -minus_a_acc_lin_y_],
                    crank_pin_a_ang_z_,
                    c_(0.0),
                    [-minus_a_load_force_x_, -minus_a_load_force_y_],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t291_, t293_],
                [a_axes_x_x_, minus_a_axes_x_y_],
                [-t294_, t292_],
                a_omega_z_,
                ::mstmm::PlaneStateVector::new(
                    [-minus_a_acc_lin_x_, -minus_a_acc_lin_y_],
                    a_a_ang_z_,
                    c_(0.0),
                    [-minus_a_load_force_x_, -minus_a_load_force_y_],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t409_, t393_],
                [a_axes_x_x_, minus_a_axes_x_y_],
                [-t353_, t354_],
                a_omega_z_,
                ::mstmm::PlaneStateVector::new(
                    [-minus_b_acc_lin_x_, -minus_b_acc_lin_y_],
                    a_a_ang_z_,
                    c_(0.0),
                    [-minus_b_load_force_x_, -minus_b_load_force_y_],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t409_, t393_],
                [b_axes_x_x_, minus_b_axes_x_y_],
                [-t353_, t354_],
                b_omega_z_,
                ::mstmm::PlaneStateVector::new(
                    [-minus_b_acc_lin_x_, -minus_b_acc_lin_y_],
                    b_a_ang_z_,
                    c_(0.0),
                    [-minus_b_load_force_x_, -minus_b_load_force_y_],
                ),
            ),
            ::mstmm::PlanePoint::new(
                [t411_, t413_],
                [b_axes_x_x_, minus_b_axes_x_y_],
                [-t415_, t417_],
                b_omega_z_,
                ::mstmm::PlaneStateVector::new(
                    [-t421_, -t425_],
                    b_a_ang_z_,
                    c_(0.0),
                    [-minus_rocker_pin_load_force_x_, -minus_rocker_pin_load_force_y_],
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
                    [-minus_rocker_pin_load_force_x_, -minus_rocker_pin_load_force_y_],
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
        let t1_ = sin_crank_pin_angle_ * sin_a_angle_;
        let a_axes_x_x_ = t0_ - t1_;
        let t2_ = cos_crank_pin_angle_ * sin_a_angle_;
        let t3_ = sin_crank_pin_angle_ * cos_a_angle_;
        let minus_a_axes_x_y_ = t2_ + t3_;
        let a_omega_z_ = crank_pin_rate_ + a_rate_;
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 4 mul, 3 add, 0 reciprocal.
        let t4_ = cos_b_angle_ * a_axes_x_x_;
        let t5_ = sin_b_angle_ * minus_a_axes_x_y_;
        let b_axes_x_x_ = t4_ - t5_;
        let t6_ = sin_b_angle_ * a_axes_x_x_;
        let t7_ = cos_b_angle_ * minus_a_axes_x_y_;
        let minus_b_axes_x_y_ = t6_ + t7_;
        let b_omega_z_ = b_rate_ + a_omega_z_;
        /// Results: 39 mul, 19 add, 0 reciprocal.
        let t8_ = cos_crank_pin_angle_ * c_(0.1);
        let t9_ = sin_crank_pin_angle_ * c_(0.1);
        let t10_ = cos_crank_pin_angle_ * c_(0.2);
        let t11_ = sin_crank_pin_angle_ * c_(0.2);
        let t12_ = crank_pin_rate_ * t11_;
        let t13_ = crank_pin_rate_ * t10_;
        let t14_ = c_(0.6) * a_axes_x_x_;
        let t15_ = c_(0.6) * minus_a_axes_x_y_;
        let t16_ = a_omega_z_ * t15_;
        let t17_ = a_omega_z_ * t14_;
        let t18_ = t12_ + t16_;
        let t19_ = t13_ + t17_;
        let t20_ = crank_pin_rate_ * t9_;
        let t21_ = crank_pin_rate_ * t8_;
        let t22_ = crank_pin_rate_ * c_(0.01);
        let t23_ = crank_pin_rate_ * t22_;
        let t24_ = t20_ * t20_;
        let t25_ = t21_ * t21_;
        let t26_ = t24_ + t25_;
        let t27_ = t23_ + t26_;
        let t28_ = a_axes_x_x_ * c_(0.3);
        let t29_ = minus_a_axes_x_y_ * c_(0.3);
        let t30_ = a_omega_z_ * t29_;
        let t31_ = a_omega_z_ * t28_;
        let t32_ = t12_ + t30_;
        let t33_ = t13_ + t31_;
        let t34_ = a_omega_z_ * c_(0.06);
        let t35_ = a_omega_z_ * t34_;
        let t36_ = t32_ * t32_;
        let t37_ = t33_ * t33_;
        let t38_ = t36_ + t37_;
        let t39_ = c_(2.0) * t38_;
        let t40_ = t35_ + t39_;
        let t41_ = b_axes_x_x_ * c_(0.3);
        let t42_ = minus_b_axes_x_y_ * c_(0.3);
        let t43_ = b_omega_z_ * t42_;
        let t44_ = b_omega_z_ * t41_;
        let t45_ = t18_ + t43_;
        let t46_ = t19_ + t44_;
        let t47_ = b_omega_z_ * c_(0.06);
        let t48_ = b_omega_z_ * t47_;
        let t49_ = t45_ * t45_;
        let t50_ = t46_ * t46_;
        let t51_ = t49_ + t50_;
        let t52_ = c_(2.0) * t51_;
        let t53_ = t48_ + t52_;
        let t54_ = c_(0.5) * t53_;
        let t55_ = t27_ + t40_;
        let t56_ = c_(0.5) * t55_;
        let t57_ = t54_ + t56_;
        let t58_ = t11_ + t15_;
        let t59_ = sin_crank_pin_angle_ * c_(0.9800000000000001);
        let t60_ = t11_ + t29_;
        let t61_ = t60_ * c_(19.6);
        let t62_ = t59_ + t61_;
        let t63_ = t58_ + t42_;
        let t64_ = c_(19.6) * t63_;
        let t65_ = t62_ + t64_;
        ::mstmm::Energy {
            kinetic: t57_,
            potential: t65_,
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
        /// Riccati transfer over `a`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 8 mul, 5 add, 1 reciprocal.
        let t0_ = sin_b_angle_ * c_(1.5);
        let t1_ = sin_b_angle_ * t0_;
        let minus_a_k_xx_ = t1_ - c_(4.0);
        let a_k_yy_ = c_(2.5) + t1_;
        let a_k_xy_ = cos_b_angle_ * t0_;
        let a_b_x_z_ = c_(0.6) * a_k_xy_;
        let t2_ = c_(0.5) + t1_;
        let t3_ = c_(0.6) * t2_;
        let a_b_y_z_ = c_(0.6) + t3_;
        let t4_ = c_(0.36) * t2_;
        let a_j_zz_ = c_(0.24) + t4_;
        let t5_ = T::recip(a_j_zz_);
        let a_z0_force_x_ = a_b_x_z_ * t5_;
        let a_z0_force_y_ = a_b_y_z_ * t5_;
        /// Riccati transfer over `crank_pin`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 8 mul, 7 add, 0 reciprocal.
        let t6_ = a_b_x_z_ * a_z0_force_x_;
        let t7_ = minus_a_k_xx_ + t6_;
        let t8_ = a_b_y_z_ * a_z0_force_y_;
        let t9_ = a_k_yy_ - t8_;
        let t10_ = a_b_y_z_ * a_z0_force_x_;
        let t11_ = a_k_xy_ - t10_;
        let t12_ = t7_ + t9_;
        let t13_ = sin_a_angle_ * t12_;
        let t14_ = c_(2.0) * t11_;
        let t15_ = cos_a_angle_ * t14_;
        let t16_ = t13_ - t15_;
        let t17_ = sin_a_angle_ * t16_;
        let t18_ = t9_ - t17_;
        let t19_ = c_(0.04000000000000001) * t18_;
        let crank_pin_j_zz_ = c_(0.020000000000000004) + t19_;
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 121 mul, 61 add, 7 reciprocal, 6 square root.
        let t20_ = c_(0.6) * sin_rocker_pin_angle_;
        let t21_ = sin_rocker_pin_angle_ * c_(2.5);
        let t22_ = sin_rocker_pin_angle_ * c_(1.5);
        let t23_ = sin_rocker_pin_angle_ - t22_;
        let t24_ = t20_ * t21_;
        let t25_ = cos_b_angle_ * cos_rocker_pin_angle_;
        let t26_ = sin_b_angle_ * t23_;
        let t27_ = t25_ - t26_;
        let t28_ = sin_b_angle_ * cos_rocker_pin_angle_;
        let t29_ = cos_b_angle_ * t23_;
        let t30_ = t28_ + t29_;
        let t31_ = c_(0.6) * t30_;
        let t32_ = t31_ * t5_;
        let t33_ = t31_ * a_z0_force_x_;
        let t34_ = t27_ - t33_;
        let t35_ = t31_ * a_z0_force_y_;
        let t36_ = t30_ - t35_;
        let t37_ = t31_ * t32_;
        let t38_ = t24_ + t37_;
        let t39_ = sin_a_angle_ * t34_;
        let t40_ = cos_a_angle_ * t36_;
        let t41_ = t39_ + t40_;
        let t42_ = c_(0.2) * t41_;
        let t43_ = T::recip(crank_pin_j_zz_);
        let t44_ = t42_ * t43_;
        let t45_ = t42_ * t44_;
        let closure_d0_ = t38_ + t45_;
        let t46_ = c_(0.6) * cos_rocker_pin_angle_;
        let t47_ = cos_rocker_pin_angle_ * c_(2.5);
        let t48_ = cos_rocker_pin_angle_ * cos_rocker_pin_angle_;
        let t49_ = sin_rocker_pin_angle_ * sin_rocker_pin_angle_;
        let t50_ = t48_ + t49_;
        let t51_ = t20_ * t20_;
        let t52_ = t50_ * c_(0.36);
        let t53_ = t51_ + t52_;
        let t54_ = t53_ * c_(4.166666666666667);
        let t55_ = cos_rocker_pin_angle_ * c_(1.5);
        let t56_ = cos_rocker_pin_angle_ - t55_;
        let t57_ = t46_ * t21_;
        let t58_ = t46_ * t47_;
        let t59_ = cos_b_angle_ * sin_rocker_pin_angle_;
        let t60_ = sin_b_angle_ * t56_;
        let t61_ = t59_ + t60_;
        let t62_ = sin_b_angle_ * sin_rocker_pin_angle_;
        let t63_ = cos_b_angle_ * t56_;
        let t64_ = t62_ - t63_;
        let t65_ = c_(0.6) * t64_;
        let t66_ = t65_ * t5_;
        let t67_ = t27_ * t27_;
        let t68_ = t30_ * t30_;
        let t69_ = t67_ + t68_;
        let t70_ = t31_ * t31_;
        let t71_ = t69_ * c_(0.72);
        let t72_ = t70_ + t71_;
        let t73_ = t5_ * t72_;
        let t74_ = t54_ + t73_;
        let t75_ = t65_ * a_z0_force_x_;
        let t76_ = t61_ - t75_;
        let t77_ = t65_ * a_z0_force_y_;
        let t78_ = t64_ - t77_;
        let t79_ = t65_ * t32_;
        let t80_ = t57_ - t79_;
        let t81_ = t65_ * t66_;
        let t82_ = t58_ + t81_;
        let t83_ = cos_a_angle_ * t34_;
        let t84_ = sin_a_angle_ * t36_;
        let t85_ = t83_ - t84_;
        let t86_ = sin_a_angle_ * t76_;
        let t87_ = cos_a_angle_ * t78_;
        let t88_ = t86_ + t87_;
        let t89_ = c_(0.2) * t88_;
        let t90_ = t89_ * t43_;
        let t91_ = t85_ * t85_;
        let t92_ = t41_ * t41_;
        let t93_ = t91_ + t92_;
        let t94_ = t42_ * t42_;
        let t95_ = t93_ * c_(0.76);
        let t96_ = t94_ + t95_;
        let t97_ = t43_ * t96_;
        let t98_ = t74_ + t97_;
        let t99_ = t89_ * t44_;
        let t100_ = t80_ - t99_;
        let t101_ = t89_ * t90_;
        let t102_ = t82_ + t101_;
        let t103_ = T::copysign(closure_d0_, c_(1.0));
        let t104_ = closure_d0_ + t103_;
        let t105_ = c_(0.5) * t104_;
        let t106_ = T::sqrt(t105_);
        let t107_ = T::sqrt(t98_);
        let t108_ = ::mstmm::generated::recip_above(t106_, t107_);
        let t109_ = t106_ * t108_;
        let t110_ = ::mstmm::generated::recip_above(closure_d0_, closure_d0_);
        let t111_ = t109_ * t110_;
        let t112_ = t100_ * t111_;
        let t113_ = t100_ * t112_;
        let closure_d1_ = t102_ - t113_;
        let t114_ = t46_ * t46_;
        let t115_ = t52_ + t114_;
        let t116_ = c_(4.166666666666667) * t115_;
        let t117_ = t61_ * t61_;
        let t118_ = t64_ * t64_;
        let t119_ = t117_ + t118_;
        let t120_ = t65_ * t65_;
        let t121_ = c_(0.72) * t119_;
        let t122_ = t120_ + t121_;
        let t123_ = t5_ * t122_;
        let t124_ = t116_ + t123_;
        let t125_ = cos_a_angle_ * t76_;
        let t126_ = sin_a_angle_ * t78_;
        let t127_ = t125_ - t126_;
        let t128_ = t127_ * t127_;
        let t129_ = t88_ * t88_;
        let t130_ = t128_ + t129_;
        let t131_ = t89_ * t89_;
        let t132_ = c_(0.76) * t130_;
        let t133_ = t131_ + t132_;
        let t134_ = t43_ * t133_;
        let t135_ = t124_ + t134_;
        let t136_ = T::copysign(closure_d1_, c_(1.0));
        let t137_ = closure_d1_ + t136_;
        let t138_ = c_(0.5) * t137_;
        let t139_ = T::sqrt(t138_);
        let t140_ = T::sqrt(t135_);
        let t141_ = ::mstmm::generated::recip_above(t139_, t140_);
        let t142_ = t139_ * t141_;
        let t143_ = ::mstmm::generated::recip_above(closure_d1_, t102_);
        let t144_ = t142_ * t143_;
        let t145_ = closure_d0_ * t111_;
        let t146_ = c_(1.0) - t145_;
        let t147_ = t146_ * t146_;
        let t148_ = ::mstmm::generated::recip_above(t147_, c_(1.0));
        let t149_ = T::sqrt(t148_);
        let t150_ = t146_ * t149_;
        let t151_ = closure_d1_ * t144_;
        let t152_ = c_(1.0) - t151_;
        let t153_ = t112_ * t152_;
        let t154_ = t150_ * t153_;
        let t155_ = t150_ * t154_;
        let t156_ = t153_ - t155_;
        let t157_ = t156_ * t156_;
        let t158_ = t152_ * t152_;
        let t159_ = t157_ + t158_;
        let t160_ = ::mstmm::generated::recip_above(t159_, c_(1.0));
        let t161_ = T::sqrt(t160_);
        let t162_ = t156_ * t161_;
        let t163_ = t152_ * t161_;
        let t164_ = cos_crank_pin_angle_ * cos_a_angle_;
        let t165_ = sin_crank_pin_angle_ * sin_a_angle_;
        let t166_ = t164_ - t165_;
        let t167_ = cos_crank_pin_angle_ * sin_a_angle_;
        let t168_ = sin_crank_pin_angle_ * cos_a_angle_;
        let t169_ = t167_ + t168_;
        let t170_ = cos_crank_pin_angle_ * c_(0.2);
        let t171_ = sin_crank_pin_angle_ * c_(0.2);
        let t172_ = c_(0.6) * t166_;
        let t173_ = c_(0.6) * t169_;
        let t174_ = cos_b_angle_ * t166_;
        let t175_ = sin_b_angle_ * t169_;
        let t176_ = t174_ - t175_;
        let t177_ = sin_b_angle_ * t166_;
        let t178_ = cos_b_angle_ * t169_;
        let t179_ = t177_ + t178_;
        let t180_ = c_(0.6) * t176_;
        let t181_ = c_(0.6) * t179_;
        let t182_ = t170_ + t172_;
        let t183_ = t171_ + t173_;
        let t184_ = cos_rocker_pin_angle_ * t176_;
        let t185_ = sin_rocker_pin_angle_ * t179_;
        let t186_ = t184_ - t185_;
        let t187_ = sin_rocker_pin_angle_ * t176_;
        let t188_ = cos_rocker_pin_angle_ * t179_;
        let t189_ = t187_ + t188_;
        let t190_ = t180_ + t182_;
        let t191_ = t181_ + t183_;
        let t192_ = c_(0.8) - t190_;
        let t193_ = t186_ * t192_;
        let t194_ = t189_ * t191_;
        let t195_ = t193_ - t194_;
        let t196_ = t189_ * t192_;
        let t197_ = t186_ * t191_;
        let t198_ = t196_ + t197_;
        let t199_ = t112_ * t195_;
        let t200_ = t198_ + t199_;
        let t201_ = t111_ * t195_;
        let t202_ = t144_ * t200_;
        let t203_ = t112_ * t202_;
        let t204_ = t201_ + t203_;
        let t205_ = t150_ * t204_;
        let t206_ = t150_ * t205_;
        let t207_ = t204_ - t206_;
        let t208_ = t162_ * t207_;
        let t209_ = t163_ * t202_;
        let t210_ = t208_ + t209_;
        let t211_ = t162_ * t210_;
        let minus_closure_reaction0_ = t207_ - t211_;
        let t212_ = t163_ * t210_;
        let closure_reaction1_ = t202_ - t212_;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 2 mul, 1 add, 0 reciprocal.
        let t213_ = t44_ * minus_closure_reaction0_;
        let t214_ = t90_ * closure_reaction1_;
        let crank_pin_a_ang_z_ = t213_ + t214_;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 7 mul, 3 add, 0 reciprocal.
        let t215_ = c_(0.2) * crank_pin_a_ang_z_;
        let a_a_lin_x_ = sin_a_angle_ * t215_;
        let a_a_lin_y_ = cos_a_angle_ * t215_;
        let t216_ = t32_ * minus_closure_reaction0_;
        let t217_ = t66_ * closure_reaction1_;
        let t218_ = t216_ + t217_;
        let t219_ = a_z0_force_x_ * a_a_lin_x_;
        let t220_ = a_z0_force_y_ * a_a_lin_y_;
        let t221_ = t219_ + t220_;
        let a_a_ang_z_ = t218_ - t221_;
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 6 mul, 4 add, 0 reciprocal.
        let t222_ = c_(0.6) * a_a_ang_z_;
        let t223_ = a_a_lin_y_ + t222_;
        let t224_ = sin_b_angle_ * a_a_lin_x_;
        let t225_ = cos_b_angle_ * t223_;
        let minus_b_a_lin_y_ = t224_ - t225_;
        let t226_ = t21_ * minus_closure_reaction0_;
        let t227_ = t47_ * closure_reaction1_;
        let t228_ = t226_ - t227_;
        let t229_ = c_(2.5) * minus_b_a_lin_y_;
        let b_a_ang_z_ = t228_ + t229_;
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 23 mul, 12 add, 0 reciprocal.
        let t230_ = crank_pin_rate_ * c_(0.2);
        let t231_ = a_omega_z_ * c_(0.6);
        let t232_ = c_(0.6) * b_omega_z_;
        let t233_ = sin_a_angle_ * t230_;
        let t234_ = cos_a_angle_ * t230_;
        let t235_ = t231_ + t234_;
        let t236_ = cos_b_angle_ * t233_;
        let t237_ = sin_b_angle_ * t235_;
        let t238_ = t236_ + t237_;
        let t239_ = sin_b_angle_ * t233_;
        let t240_ = cos_b_angle_ * t235_;
        let t241_ = t239_ - t240_;
        let t242_ = t232_ - t241_;
        let t243_ = cos_rocker_pin_angle_ * t238_;
        let t244_ = sin_rocker_pin_angle_ * t242_;
        let t245_ = t243_ + t244_;
        let t246_ = sin_rocker_pin_angle_ * t238_;
        let t247_ = cos_rocker_pin_angle_ * t242_;
        let t248_ = t246_ - t247_;
        let t249_ = t112_ * t245_;
        let t250_ = t248_ + t249_;
        let t251_ = t111_ * t245_;
        let t252_ = t144_ * t250_;
        let t253_ = t112_ * t252_;
        let t254_ = t251_ + t253_;
        let t255_ = t150_ * t254_;
        let t256_ = t150_ * t255_;
        let t257_ = t254_ - t256_;
        let t258_ = t162_ * t257_;
        let t259_ = t163_ * t252_;
        let t260_ = t258_ + t259_;
        let t261_ = t162_ * t260_;
        let closure_reaction0_ = t257_ - t261_;
        let t262_ = t163_ * t260_;
        let minus_closure_reaction1_ = t252_ - t262_;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 2 mul, 1 add, 0 reciprocal.
        let t263_ = t44_ * closure_reaction0_;
        let t264_ = t90_ * minus_closure_reaction1_;
        let minus_crank_pin_a_ang_z_ = t263_ + t264_;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 7 mul, 3 add, 0 reciprocal.
        let t265_ = c_(0.2) * minus_crank_pin_a_ang_z_;
        let minus_a_a_lin_x_ = sin_a_angle_ * t265_;
        let minus_a_a_lin_y_ = cos_a_angle_ * t265_;
        let t266_ = t32_ * closure_reaction0_;
        let t267_ = t66_ * minus_closure_reaction1_;
        let t268_ = t266_ + t267_;
        let t269_ = a_z0_force_x_ * minus_a_a_lin_x_;
        let t270_ = a_z0_force_y_ * minus_a_a_lin_y_;
        let t271_ = t269_ + t270_;
        let minus_a_a_ang_z_ = t268_ - t271_;
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 6 mul, 4 add, 0 reciprocal.
        let t272_ = c_(0.6) * minus_a_a_ang_z_;
        let t273_ = minus_a_a_lin_y_ + t272_;
        let t274_ = sin_b_angle_ * minus_a_a_lin_x_;
        let t275_ = cos_b_angle_ * t273_;
        let b_a_lin_y_ = t274_ - t275_;
        let t276_ = t21_ * closure_reaction0_;
        let t277_ = t47_ * minus_closure_reaction1_;
        let t278_ = t276_ - t277_;
        let t279_ = c_(2.5) * b_a_lin_y_;
        let minus_b_a_ang_z_ = t278_ + t279_;
        /// Results: 10 mul, 23 add, 1 reciprocal, 2 square root, 1 sin/cos.
        let t280_ = crank_pin_angle_ + crank_pin_a_ang_z_;
        let t281_ = crank_pin_a_ang_z_ - a_a_ang_z_;
        let t282_ = a_angle_ - t281_;
        let t283_ = a_a_ang_z_ - b_a_ang_z_;
        let t284_ = b_angle_ - t283_;
        let t285_ = t189_ * t189_;
        let t286_ = t285_ + c_(0.000000000000000000000000000001);
        let t287_ = T::sqrt(t286_);
        let t288_ = T::atan2(t287_, t186_);
        let t289_ = T::recip(t287_);
        let t290_ = t288_ * t289_;
        let t291_ = t189_ * t290_;
        let t292_ = t291_ + b_a_ang_z_;
        let t293_ = rocker_pin_angle_ - t292_;
        let t294_ = crank_pin_rate_ - minus_crank_pin_a_ang_z_;
        let t295_ = minus_crank_pin_a_ang_z_ - minus_a_a_ang_z_;
        let t296_ = a_rate_ + t295_;
        let t297_ = minus_a_a_ang_z_ - minus_b_a_ang_z_;
        let t298_ = b_rate_ + t297_;
        let t299_ = rocker_pin_rate_ + b_omega_z_;
        let t300_ = t299_ - minus_b_a_ang_z_;
        let t301_ = rocker_pin_rate_ - t300_;
        let t302_ = t195_ * t195_;
        let t303_ = t198_ * t198_;
        let t304_ = t302_ + t303_;
        let t305_ = t291_ * t291_;
        let t306_ = t304_ + t305_;
        let t307_ = c_(1.0) - t186_;
        let t308_ = t307_ * t307_;
        let t309_ = t306_ + t308_;
        let t310_ = t245_ * t245_;
        let t311_ = t248_ * t248_;
        let t312_ = t310_ + t311_;
        let t313_ = t299_ * t299_;
        let t314_ = t312_ + t313_;
        let t315_ = t309_ + t314_;
        let t316_ = T::sqrt(t315_);
        let residual_ = t316_;
        state_.q.data.0 = [[t280_, t282_, t284_, t293_]];
        state_.v.data.0 = [[t294_, t296_, t298_, t301_]];
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
