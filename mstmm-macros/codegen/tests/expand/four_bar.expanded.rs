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
/// Accelerations by `riccati`, 348 operations (209 mul, 125 add, 8 reciprocal, 6 square root, 4 sin/cos); with everything at every connection point 459 operations.
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
    /// 348 operations: 209 mul, 125 add, 8 reciprocal, 6 square root, 4 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 4 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `b` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 15 | 5 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 31 | 22 | 1 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 121 | 68 | 6 | 6 | 0 |
    /// | Acceleration of `b` | \[P, Eqs. (13), (36), (44)\] | 9 | 5 | 0 | 0 | 0 |
    /// | Acceleration of `a` | \[P, Eqs. (13), (36), (44)\] | 17 | 14 | 0 | 0 | 0 |
    /// | Results |  | 1 | 5 | 0 | 0 | 0 |
    /// | Acceleration of `crank_pin` | \[P, Eqs. (13), (36), (44)\] | 5 | 4 | 0 | 0 | 0 |
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
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 4 mul, 1 add, 0 reciprocal.
        let t2_ = a_omega_z_ * c_(0.6);
        let b_omega_z_ = b_rate_ + a_omega_z_;
        /// Motion across `a`.
        let t1_ = crank_pin_rate_ * t0_;
        /// Riccati transfer over `b`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 0 add, 0 reciprocal.
        let t4_ = c_(0.6) * b_omega_z_;
        /// Motion across `b`.
        let t3_ = a_omega_z_ * t2_;
        /// Riccati transfer over `b`.
        let minus_b_e_force_x_ = b_omega_z_ * t4_;
        /// Riccati transfer over `a`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 15 mul, 5 add, 1 reciprocal.
        let t6_ = sin_b_angle_ * sin_b_angle_;
        let t5_ = sin_b_angle_ * cos_b_angle_;
        /// Riccati transfer over `crank_pin`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 31 mul, 22 add, 1 reciprocal.
        let t22_ = sin_a_angle_ * cos_a_angle_;
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 121 mul, 68 add, 6 reciprocal, 6 square root.
        let t43_ = T::mul_neg_add(sin_rocker_pin_angle_, c_(1.5), sin_rocker_pin_angle_);
        let t47_ = sin_b_angle_ * cos_rocker_pin_angle_;
        /// Riccati transfer over `crank_pin`.
        let t21_ = sin_a_angle_ * sin_a_angle_;
        /// Closure.
        let t45_ = cos_b_angle_ * cos_rocker_pin_angle_;
        let t60_ = cos_rocker_pin_angle_ * cos_rocker_pin_angle_;
        let t41_ = c_(0.6) * sin_rocker_pin_angle_;
        let t42_ = sin_rocker_pin_angle_ * c_(2.5);
        /// Riccati transfer over `a`.
        let t7_ = c_(1.5) * t6_;
        let a_b_x_z_ = t5_ * c_(0.8999999999999999);
        let a_k_xy_ = c_(1.5) * t5_;
        /// Riccati transfer over `crank_pin`.
        let t26_ = c_(2.0) * t22_;
        /// Closure.
        let t48_ = T::mul_add(cos_b_angle_, t43_, t47_);
        let t65_ = T::mul_neg_add(cos_rocker_pin_angle_, c_(1.5), cos_rocker_pin_angle_);
        let t46_ = T::mul_neg_add(sin_b_angle_, t43_, t45_);
        let t61_ = T::mul_add(sin_rocker_pin_angle_, sin_rocker_pin_angle_, t60_);
        let t70_ = sin_b_angle_ * sin_rocker_pin_angle_;
        let t44_ = t41_ * t42_;
        /// Riccati transfer over `a`.
        let t8_ = c_(0.5) + t7_;
        /// Riccati transfer over `crank_pin`.
        let t14_ = c_(2.5) + t7_;
        let t15_ = a_b_x_z_ * a_b_x_z_;
        let t13_ = t7_ - c_(4.0);
        /// Closure.
        let t49_ = c_(0.6) * t48_;
        let t68_ = cos_b_angle_ * sin_rocker_pin_angle_;
        let t74_ = t46_ * t46_;
        let t62_ = t61_ * c_(0.36);
        /// Riccati transfer over `a`.
        let a_j_zz_ = T::mul_add(c_(0.36), t8_, c_(0.24));
        let a_b_y_z_ = T::mul_add(c_(0.6), t8_, c_(0.6));
        /// Closure.
        let t71_ = T::mul_neg_add(cos_b_angle_, t65_, t70_);
        let t58_ = c_(0.6) * cos_rocker_pin_angle_;
        let t59_ = cos_rocker_pin_angle_ * c_(2.5);
        /// Motion across `b`.
        let minus_b_drift_lin_x_ = cos_b_angle_ * t3_;
        /// Closure.
        let t76_ = t49_ * t49_;
        let t69_ = T::mul_add(sin_b_angle_, t65_, t68_);
        let t75_ = T::mul_add(t48_, t48_, t74_);
        let t63_ = T::mul_add(t41_, t41_, t62_);
        /// Riccati transfer over `a`.
        let t12_ = T::recip(a_j_zz_);
        /// Riccati transfer over `crank_pin`.
        let t17_ = a_b_y_z_ * a_b_y_z_;
        let t19_ = a_b_x_z_ * a_b_y_z_;
        /// Closure.
        let t72_ = c_(0.6) * t71_;
        let t66_ = t58_ * t42_;
        let t67_ = t58_ * t59_;
        let t106_ = T::mul_add(t58_, t58_, t62_);
        let t110_ = t69_ * t69_;
        let t77_ = T::mul_add(t75_, c_(0.72), t76_);
        let t64_ = t63_ * c_(4.166666666666667);
        /// Motion across `b`.
        let b_drift_lin_y_ = sin_b_angle_ * t3_;
        /// Riccati transfer over `a`.
        let t10_ = T::mul_add(minus_b_drift_lin_x_, c_(2.0), minus_b_e_force_x_);
        /// Motion across `a`.
        let a_drift_lin_y_ = sin_a_angle_ * t1_;
        /// Closure.
        let t112_ = t72_ * t72_;
        /// Motion across `a`.
        let minus_a_drift_lin_x_ = cos_a_angle_ * t1_;
        /// Riccati transfer over `crank_pin`.
        let t24_ = T::mul_neg_add(c_(2.0), t21_, c_(1.0));
        /// Closure.
        let t107_ = c_(4.166666666666667) * t106_;
        let t111_ = T::mul_add(t71_, t71_, t110_);
        let t122_ = minus_b_drift_lin_x_ + minus_b_e_force_x_;
        let crank_pin_a_lin_x_ = sin_crank_pin_angle_ * c_(9.8);
        /// Riccati transfer over `a`.
        let t9_ = b_drift_lin_y_ * c_(0.5);
        let t11_ = sin_b_angle_ * t10_;
        /// Riccati transfer over `crank_pin`.
        let t30_ = T::mul_add(cos_b_angle_, t10_, t3_);
        /// Closure.
        let t108_ = b_drift_lin_y_ * t43_;
        let t109_ = b_drift_lin_y_ * t65_;
        let crank_pin_a_lin_y_ = cos_crank_pin_angle_ * c_(9.8);
        let t159_ = T::mul_neg_add(sin_rocker_pin_angle_, t122_, c_(9.8));
        let t113_ = T::mul_add(c_(0.72), t111_, t112_);
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 9 mul, 5 add, 0 reciprocal.
        let t194_ = b_drift_lin_y_ * c_(2.5);
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 17 mul, 14 add, 0 reciprocal.
        let t179_ = T::mul_neg_add(
            cos_a_angle_,
            crank_pin_a_lin_x_,
            minus_a_drift_lin_x_,
        );
        /// Riccati transfer over `crank_pin`.
        let t29_ = sin_b_angle_ * t9_;
        /// Riccati transfer over `a`.
        let minus_a_e_force_y_ = T::mul_neg_add(cos_b_angle_, t9_, t11_);
        /// Acceleration of `a`.
        let t181_ = T::mul_neg_add(sin_a_angle_, crank_pin_a_lin_x_, a_drift_lin_y_);
        /// Acceleration of `b`.
        let t197_ = cos_b_angle_ * c_(1.5);
        let t195_ = sin_b_angle_ * c_(2.5);
        /// Riccati transfer over `crank_pin`.
        let t18_ = T::mul_neg_add(t12_, t17_, t14_);
        let t20_ = T::mul_neg_add(t12_, t19_, a_k_xy_);
        let t16_ = T::mul_add(t12_, t15_, t13_);
        /// Riccati transfer over `a`.
        let a_z0_force_x_ = a_b_x_z_ * t12_;
        let a_z0_force_y_ = a_b_y_z_ * t12_;
        /// Closure.
        let t50_ = t49_ * t12_;
        let t78_ = T::mul_add(t12_, t77_, t64_);
        let t73_ = t72_ * t12_;
        let t114_ = T::mul_add(t12_, t113_, t107_);
        /// Riccati transfer over `a`.
        let minus_a_e_moment_z_ = c_(0.6) * minus_a_e_force_y_;
        /// Riccati transfer over `crank_pin`.
        let t35_ = T::mul_neg_add(a_drift_lin_y_, t18_, minus_a_e_force_y_);
        let t27_ = T::mul_add(t20_, t26_, t18_);
        let t23_ = t16_ + t18_;
        /// Closure.
        let t51_ = T::mul_neg_add(t49_, a_z0_force_x_, t46_);
        let t52_ = T::mul_neg_add(t49_, a_z0_force_y_, t48_);
        let t53_ = T::mul_add(t49_, t50_, t44_);
        let t79_ = T::mul_neg_add(t72_, a_z0_force_x_, t69_);
        let t80_ = T::mul_neg_add(t72_, a_z0_force_y_, t71_);
        let t81_ = T::mul_neg_add(t72_, t50_, t66_);
        let t82_ = T::mul_add(t72_, t73_, t67_);
        /// Riccati transfer over `a`.
        let a_w0_ = minus_a_e_moment_z_ * t12_;
        /// Riccati transfer over `crank_pin`.
        let t28_ = T::mul_sub(t21_, t23_, t27_);
        let t32_ = T::mul_neg_add(a_drift_lin_y_, t20_, t29_);
        /// Closure.
        let t54_ = sin_a_angle_ * t51_;
        let t83_ = cos_a_angle_ * t51_;
        /// Riccati transfer over `crank_pin`.
        let t31_ = T::mul_sub(minus_a_drift_lin_x_, t16_, t30_);
        /// Closure.
        let t85_ = sin_a_angle_ * t79_;
        let t116_ = cos_a_angle_ * t79_;
        /// Riccati transfer over `crank_pin`.
        let t25_ = t20_ * t24_;
        /// Closure.
        let t115_ = a_drift_lin_y_ * t52_;
        /// Riccati transfer over `crank_pin`.
        let t36_ = T::mul_sub(a_b_y_z_, a_w0_, t35_);
        let crank_pin_j_zz_ = T::mul_neg_add(
            c_(0.04000000000000001),
            t28_,
            c_(0.020000000000000004),
        );
        let t33_ = T::mul_sub(a_b_x_z_, a_w0_, t32_);
        /// Closure.
        let t55_ = T::mul_add(cos_a_angle_, t52_, t54_);
        let t84_ = T::mul_neg_add(sin_a_angle_, t52_, t83_);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_b_y_z_ = T::mul_neg_add(c_(0.2), t28_, c_(0.1));
        /// Closure.
        let t86_ = T::mul_add(cos_a_angle_, t80_, t85_);
        let t117_ = T::mul_neg_add(sin_a_angle_, t80_, t116_);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_k_xy_ = T::mul_neg_add(t22_, t23_, t25_);
        /// Closure.
        let t123_ = T::mul_add(t49_, a_w0_, t108_);
        /// Riccati transfer over `crank_pin`.
        let t37_ = T::mul_sub(minus_a_drift_lin_x_, t20_, t36_);
        let t39_ = T::recip(crank_pin_j_zz_);
        let t34_ = t31_ + t33_;
        /// Closure.
        let t56_ = c_(0.2) * t55_;
        let t88_ = t84_ * t84_;
        let t155_ = T::mul_neg_add(cos_rocker_pin_angle_, t122_, t115_);
        let t87_ = c_(0.2) * t86_;
        let t118_ = t117_ * t117_;
        /// Riccati transfer over `crank_pin`.
        let crank_pin_b_x_z_ = c_(0.2) * crank_pin_k_xy_;
        /// Closure.
        let t163_ = T::mul_neg_add(t72_, a_w0_, t109_);
        /// Riccati transfer over `crank_pin`.
        let t38_ = sin_a_angle_ * t34_;
        /// Closure.
        let t124_ = T::mul_sub(minus_a_drift_lin_x_, t51_, t123_);
        let t160_ = T::mul_add(a_drift_lin_y_, t80_, t159_);
        let t90_ = t56_ * t56_;
        let t89_ = T::mul_add(t55_, t55_, t88_);
        /// Acceleration of `a`.
        let t185_ = sin_a_angle_ * a_z0_force_x_;
        /// Closure.
        let t120_ = t87_ * t87_;
        let t119_ = T::mul_add(t86_, t86_, t118_);
        /// Acceleration of `a`.
        let t182_ = a_drift_lin_y_ * a_z0_force_y_;
        /// Closure.
        let t164_ = T::mul_add(minus_a_drift_lin_x_, t79_, t163_);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_e_force_y_ = T::mul_neg_add(cos_a_angle_, t37_, t38_);
        /// Acceleration of `a`.
        let t183_ = cos_a_angle_ * a_z0_force_x_;
        let t188_ = T::mul_add(minus_a_drift_lin_x_, a_z0_force_x_, a_w0_);
        /// Acceleration of `b`.
        let t196_ = cos_b_angle_ * c_(2.5);
        /// Closure.
        let t91_ = T::mul_add(t89_, c_(0.76), t90_);
        /// Acceleration of `a`.
        let t186_ = T::mul_add(cos_a_angle_, a_z0_force_y_, t185_);
        /// Results: 1 mul, 5 add, 0 reciprocal.
        let t205_ = c_(4.0) + t18_;
        /// Closure.
        let t121_ = T::mul_add(c_(0.76), t119_, t120_);
        /// Riccati transfer over `crank_pin`.
        let t40_ = T::mul_neg_add(c_(0.2), crank_pin_e_force_y_, crank_pin_input0_);
        /// Acceleration of `a`.
        let t184_ = T::mul_neg_add(sin_a_angle_, a_z0_force_y_, t183_);
        /// Results.
        let t206_ = t16_ - t205_;
        /// Acceleration of `a`.
        let t191_ = T::mul_add(crank_pin_a_lin_y_, t186_, t182_);
        /// Closure.
        let t57_ = t56_ * t39_;
        let t93_ = T::mul_add(t91_, t39_, t78_);
        let t92_ = t87_ * t39_;
        let t129_ = T::mul_add(t121_, t39_, t114_);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_z0_force_x_ = crank_pin_b_x_z_ * t39_;
        let crank_pin_z0_force_y_ = crank_pin_b_y_z_ * t39_;
        let crank_pin_w0_ = t39_ * t40_;
        /// Acceleration of `a`.
        let t187_ = c_(0.2) * t186_;
        let t189_ = T::mul_sub(crank_pin_a_lin_x_, t184_, t188_);
        /// Results.
        let t207_ = T::mul_neg_add(
            c_(0.04000000000000001),
            t206_,
            c_(0.030000000000000006),
        );
        /// Closure.
        let closure_d0_ = T::mul_add(t56_, t57_, t53_);
        let t100_ = T::sqrt(t93_);
        let t94_ = T::mul_neg_add(t87_, t57_, t81_);
        let t95_ = T::mul_add(t87_, t92_, t82_);
        let t134_ = T::sqrt(t129_);
        let t125_ = T::mul_neg_add(t56_, crank_pin_z0_force_x_, t84_);
        let t126_ = T::mul_neg_add(t56_, crank_pin_z0_force_y_, t55_);
        let t156_ = T::mul_add(t56_, crank_pin_w0_, t155_);
        let t128_ = T::mul_neg_add(t87_, crank_pin_z0_force_y_, t86_);
        let t127_ = T::mul_neg_add(t87_, crank_pin_z0_force_x_, t117_);
        let t96_ = T::copysign(closure_d0_, c_(1.0));
        let t103_ = ::mstmm::generated::recip_above(closure_d0_, closure_d0_);
        let t161_ = T::mul_add(t87_, crank_pin_w0_, t160_);
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 5 mul, 4 add, 0 reciprocal.
        let t175_ = sin_crank_pin_angle_ * crank_pin_z0_force_x_;
        /// Closure.
        let t154_ = T::mul_neg_add(crank_pin_a_lin_y_, t126_, t124_);
        let t157_ = T::mul_add(crank_pin_a_lin_x_, t125_, t156_);
        let t97_ = closure_d0_ + t96_;
        let t165_ = T::mul_sub(crank_pin_a_lin_y_, t128_, t164_);
        let t162_ = T::mul_add(crank_pin_a_lin_x_, t127_, t161_);
        /// Acceleration of `crank_pin`.
        let t176_ = T::mul_add(cos_crank_pin_angle_, crank_pin_z0_force_y_, t175_);
        /// Closure.
        let t98_ = c_(0.5) * t97_;
        let t158_ = t154_ - t157_;
        /// Acceleration of `crank_pin`.
        let t177_ = T::mul_sub(c_(9.8), t176_, crank_pin_w0_);
        /// Closure.
        let t99_ = T::sqrt(t98_);
        let t101_ = ::mstmm::generated::recip_above(t99_, t100_);
        let t102_ = t99_ * t101_;
        let t104_ = t102_ * t103_;
        let t105_ = t94_ * t104_;
        let t139_ = T::mul_neg_add(closure_d0_, t104_, c_(1.0));
        let t168_ = t104_ * t158_;
        let closure_d1_ = T::mul_neg_add(t94_, t105_, t95_);
        let t140_ = t139_ * t139_;
        let t166_ = T::mul_sub(t105_, t158_, t165_);
        let t130_ = T::copysign(closure_d1_, c_(1.0));
        let t141_ = ::mstmm::generated::recip_above(t140_, c_(1.0));
        let t137_ = ::mstmm::generated::recip_above(closure_d1_, t95_);
        let t167_ = t162_ - t166_;
        let t131_ = closure_d1_ + t130_;
        let t132_ = c_(0.5) * t131_;
        let t133_ = T::sqrt(t132_);
        let t142_ = T::sqrt(t141_);
        let t135_ = ::mstmm::generated::recip_above(t133_, t134_);
        let t143_ = t139_ * t142_;
        let t136_ = t133_ * t135_;
        let t138_ = t136_ * t137_;
        let t144_ = T::mul_neg_add(closure_d1_, t138_, c_(1.0));
        let t169_ = t138_ * t167_;
        let t145_ = t105_ * t144_;
        let t170_ = T::mul_neg_add(t105_, t169_, t168_);
        let t146_ = t143_ * t145_;
        let t171_ = t143_ * t170_;
        let t147_ = T::mul_neg_add(t143_, t146_, t145_);
        let t172_ = T::mul_neg_add(t143_, t171_, t170_);
        let t148_ = t147_ * t147_;
        let t149_ = T::mul_add(t144_, t144_, t148_);
        let t150_ = ::mstmm::generated::recip_above(t149_, c_(1.0));
        let t151_ = T::sqrt(t150_);
        let t152_ = t147_ * t151_;
        let t153_ = t144_ * t151_;
        let t173_ = t152_ * t172_;
        let t174_ = T::mul_neg_add(t153_, t169_, t173_);
        let minus_closure_reaction1_ = T::mul_add(t153_, t174_, t169_);
        let minus_closure_reaction0_ = T::mul_neg_add(t152_, t174_, t172_);
        /// Acceleration of `crank_pin`.
        let t178_ = T::mul_add(t92_, minus_closure_reaction1_, t177_);
        /// Acceleration of `a`.
        let t192_ = T::mul_add(t73_, minus_closure_reaction1_, t191_);
        let t190_ = T::mul_sub(t50_, minus_closure_reaction0_, t189_);
        /// Acceleration of `b`.
        let t198_ = t42_ * minus_closure_reaction0_;
        let t199_ = T::mul_neg_add(t59_, minus_closure_reaction1_, t194_);
        /// Acceleration of `crank_pin`.
        let crank_pin_a_ang_z_ = T::mul_sub(t57_, minus_closure_reaction0_, t178_);
        /// Acceleration of `a`.
        let t193_ = T::mul_add(t187_, crank_pin_a_ang_z_, t192_);
        let t180_ = T::mul_add(c_(0.2), crank_pin_a_ang_z_, crank_pin_a_lin_y_);
        let a_a_ang_z_ = t190_ - t193_;
        let minus_a_a_lin_x_ = T::mul_neg_add(sin_a_angle_, t180_, t179_);
        let a_a_lin_y_ = T::mul_add(cos_a_angle_, t180_, t181_);
        /// Acceleration of `b`.
        let t201_ = T::mul_neg_add(t197_, a_a_ang_z_, t198_);
        /// Results.
        let t203_ = crank_pin_a_ang_z_ - a_a_ang_z_;
        /// Acceleration of `b`.
        let t200_ = T::mul_add(t196_, a_a_lin_y_, t199_);
        let t202_ = T::mul_sub(t195_, minus_a_a_lin_x_, t201_);
        let minus_b_a_ang_z_ = t200_ + t202_;
        /// Results.
        let t204_ = a_a_ang_z_ + minus_b_a_ang_z_;
        ::mstmm::generated::finite::<T>(&[&[state_.v.data.0[0][3], state_.t]])?;
        ::mstmm::generated::regular::<
            T,
            _,
            _,
        >(
            &["a", "crank_pin"],
            [a_j_zz_, crank_pin_j_zz_],
            [c_(2.04), t207_],
            [crank_pin_a_ang_z_, -t203_, -t204_, minus_b_a_ang_z_],
        )?;
        accelerations_.data.0 = [[crank_pin_a_ang_z_, -t203_, -t204_, minus_b_a_ang_z_]];
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
    /// 459 operations: 269 mul, 176 add, 8 reciprocal, 6 square root, 4 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 14 | 3 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 12 | 3 | 0 | 0 | 0 |
    /// | Riccati transfer over `b` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 15 | 5 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 31 | 22 | 1 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 121 | 68 | 6 | 6 | 0 |
    /// | Acceleration of `crank_pin` | \[P, Eqs. (13), (36), (44)\] | 5 | 4 | 0 | 0 | 0 |
    /// | Acceleration of `a` | \[P, Eqs. (13), (36), (44)\] | 17 | 14 | 0 | 0 | 0 |
    /// | Acceleration of `b` | \[P, Eqs. (13), (36), (44)\] | 9 | 5 | 0 | 0 | 0 |
    /// | Point of `a` | \[P, Eqs. (12), (13), (36)\] | 2 | 2 | 0 | 0 | 0 |
    /// | Point of `b` | \[P, Eqs. (12), (13), (36)\] | 4 | 4 | 0 | 0 | 0 |
    /// | Load on `rocker_pin` | \[P, Eqs. (18), (19)\] | 8 | 4 | 0 | 0 | 0 |
    /// | Load on `b` | \[P, Eqs. (18), (19)\] | 8 | 9 | 0 | 0 | 0 |
    /// | Load on `a` | \[P, Eqs. (18), (19)\] | 0 | 5 | 0 | 0 | 0 |
    /// | Load on `crank_pin` | \[P, Eqs. (18), (19)\] | 2 | 4 | 0 | 0 | 0 |
    /// | Results |  | 19 | 24 | 0 | 0 | 0 |
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
        let [point0_, point1_, point2_, point3_, point4_, point5_, point6_, point7_] = &mut at_
            .points;
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
        /// Motion across `a`, [P, Eqs. (1), (13), (36)]: 14 mul, 3 add, 0 reciprocal.
        let a_omega_z_ = crank_pin_rate_ + a_rate_;
        let t0_ = crank_pin_rate_ * c_(0.2);
        let t1_ = crank_pin_rate_ * t0_;
        let minus_a_drift_lin_x_ = cos_a_angle_ * t1_;
        let a_drift_lin_y_ = sin_a_angle_ * t1_;
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 12 mul, 3 add, 0 reciprocal.
        let b_omega_z_ = b_rate_ + a_omega_z_;
        let t2_ = a_omega_z_ * c_(0.6);
        let t3_ = a_omega_z_ * t2_;
        let minus_b_drift_lin_x_ = cos_b_angle_ * t3_;
        let b_drift_lin_y_ = sin_b_angle_ * t3_;
        /// Riccati transfer over `b`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 0 add, 0 reciprocal.
        let t4_ = c_(0.6) * b_omega_z_;
        let minus_b_e_force_x_ = b_omega_z_ * t4_;
        /// Riccati transfer over `a`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 15 mul, 5 add, 1 reciprocal.
        let t5_ = sin_b_angle_ * cos_b_angle_;
        let a_k_xy_ = c_(1.5) * t5_;
        let a_b_x_z_ = t5_ * c_(0.8999999999999999);
        let t6_ = sin_b_angle_ * sin_b_angle_;
        let t7_ = c_(1.5) * t6_;
        let t8_ = c_(0.5) + t7_;
        let a_b_y_z_ = T::mul_add(c_(0.6), t8_, c_(0.6));
        let a_j_zz_ = T::mul_add(c_(0.36), t8_, c_(0.24));
        let t9_ = b_drift_lin_y_ * c_(0.5);
        let t10_ = T::mul_add(minus_b_drift_lin_x_, c_(2.0), minus_b_e_force_x_);
        let t11_ = sin_b_angle_ * t10_;
        let minus_a_e_force_y_ = T::mul_neg_add(cos_b_angle_, t9_, t11_);
        let minus_a_e_moment_z_ = c_(0.6) * minus_a_e_force_y_;
        let t12_ = T::recip(a_j_zz_);
        let a_z0_force_x_ = a_b_x_z_ * t12_;
        let a_z0_force_y_ = a_b_y_z_ * t12_;
        let a_w0_ = minus_a_e_moment_z_ * t12_;
        /// Riccati transfer over `crank_pin`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 31 mul, 22 add, 1 reciprocal.
        let t13_ = t7_ - c_(4.0);
        let t14_ = c_(2.5) + t7_;
        let t15_ = a_b_x_z_ * a_b_x_z_;
        let t16_ = T::mul_add(t12_, t15_, t13_);
        let t17_ = a_b_y_z_ * a_b_y_z_;
        let t18_ = T::mul_neg_add(t12_, t17_, t14_);
        let t19_ = a_b_x_z_ * a_b_y_z_;
        let t20_ = T::mul_neg_add(t12_, t19_, a_k_xy_);
        let t21_ = sin_a_angle_ * sin_a_angle_;
        let t22_ = sin_a_angle_ * cos_a_angle_;
        let t23_ = t16_ + t18_;
        let t24_ = T::mul_neg_add(c_(2.0), t21_, c_(1.0));
        let t25_ = t20_ * t24_;
        let crank_pin_k_xy_ = T::mul_neg_add(t22_, t23_, t25_);
        let crank_pin_b_x_z_ = c_(0.2) * crank_pin_k_xy_;
        let t26_ = c_(2.0) * t22_;
        let t27_ = T::mul_add(t20_, t26_, t18_);
        let t28_ = T::mul_sub(t21_, t23_, t27_);
        let crank_pin_b_y_z_ = T::mul_neg_add(c_(0.2), t28_, c_(0.1));
        let crank_pin_j_zz_ = T::mul_neg_add(
            c_(0.04000000000000001),
            t28_,
            c_(0.020000000000000004),
        );
        let t29_ = sin_b_angle_ * t9_;
        let t30_ = T::mul_add(cos_b_angle_, t10_, t3_);
        let t31_ = T::mul_sub(minus_a_drift_lin_x_, t16_, t30_);
        let t32_ = T::mul_neg_add(a_drift_lin_y_, t20_, t29_);
        let t33_ = T::mul_sub(a_b_x_z_, a_w0_, t32_);
        let t34_ = t31_ + t33_;
        let t35_ = T::mul_neg_add(a_drift_lin_y_, t18_, minus_a_e_force_y_);
        let t36_ = T::mul_sub(a_b_y_z_, a_w0_, t35_);
        let t37_ = T::mul_sub(minus_a_drift_lin_x_, t20_, t36_);
        let t38_ = sin_a_angle_ * t34_;
        let crank_pin_e_force_y_ = T::mul_neg_add(cos_a_angle_, t37_, t38_);
        let t39_ = T::recip(crank_pin_j_zz_);
        let crank_pin_z0_force_x_ = crank_pin_b_x_z_ * t39_;
        let crank_pin_z0_force_y_ = crank_pin_b_y_z_ * t39_;
        let t40_ = T::mul_neg_add(c_(0.2), crank_pin_e_force_y_, crank_pin_input0_);
        let crank_pin_w0_ = t39_ * t40_;
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 121 mul, 68 add, 6 reciprocal, 6 square root.
        let t41_ = c_(0.6) * sin_rocker_pin_angle_;
        let t42_ = sin_rocker_pin_angle_ * c_(2.5);
        let t43_ = T::mul_neg_add(sin_rocker_pin_angle_, c_(1.5), sin_rocker_pin_angle_);
        let t44_ = t41_ * t42_;
        let t45_ = cos_b_angle_ * cos_rocker_pin_angle_;
        let t46_ = T::mul_neg_add(sin_b_angle_, t43_, t45_);
        let t47_ = sin_b_angle_ * cos_rocker_pin_angle_;
        let t48_ = T::mul_add(cos_b_angle_, t43_, t47_);
        let t49_ = c_(0.6) * t48_;
        let t50_ = t49_ * t12_;
        let t51_ = T::mul_neg_add(t49_, a_z0_force_x_, t46_);
        let t52_ = T::mul_neg_add(t49_, a_z0_force_y_, t48_);
        let t53_ = T::mul_add(t49_, t50_, t44_);
        let t54_ = sin_a_angle_ * t51_;
        let t55_ = T::mul_add(cos_a_angle_, t52_, t54_);
        let t56_ = c_(0.2) * t55_;
        let t57_ = t56_ * t39_;
        let closure_d0_ = T::mul_add(t56_, t57_, t53_);
        let t58_ = c_(0.6) * cos_rocker_pin_angle_;
        let t59_ = cos_rocker_pin_angle_ * c_(2.5);
        let t60_ = cos_rocker_pin_angle_ * cos_rocker_pin_angle_;
        let t61_ = T::mul_add(sin_rocker_pin_angle_, sin_rocker_pin_angle_, t60_);
        let t62_ = t61_ * c_(0.36);
        let t63_ = T::mul_add(t41_, t41_, t62_);
        let t64_ = t63_ * c_(4.166666666666667);
        let t65_ = T::mul_neg_add(cos_rocker_pin_angle_, c_(1.5), cos_rocker_pin_angle_);
        let t66_ = t58_ * t42_;
        let t67_ = t58_ * t59_;
        let t68_ = cos_b_angle_ * sin_rocker_pin_angle_;
        let t69_ = T::mul_add(sin_b_angle_, t65_, t68_);
        let t70_ = sin_b_angle_ * sin_rocker_pin_angle_;
        let t71_ = T::mul_neg_add(cos_b_angle_, t65_, t70_);
        let t72_ = c_(0.6) * t71_;
        let t73_ = t72_ * t12_;
        let t74_ = t46_ * t46_;
        let t75_ = T::mul_add(t48_, t48_, t74_);
        let t76_ = t49_ * t49_;
        let t77_ = T::mul_add(t75_, c_(0.72), t76_);
        let t78_ = T::mul_add(t12_, t77_, t64_);
        let t79_ = T::mul_neg_add(t72_, a_z0_force_x_, t69_);
        let t80_ = T::mul_neg_add(t72_, a_z0_force_y_, t71_);
        let t81_ = T::mul_neg_add(t72_, t50_, t66_);
        let t82_ = T::mul_add(t72_, t73_, t67_);
        let t83_ = cos_a_angle_ * t51_;
        let t84_ = T::mul_neg_add(sin_a_angle_, t52_, t83_);
        let t85_ = sin_a_angle_ * t79_;
        let t86_ = T::mul_add(cos_a_angle_, t80_, t85_);
        let t87_ = c_(0.2) * t86_;
        let t88_ = t84_ * t84_;
        let t89_ = T::mul_add(t55_, t55_, t88_);
        let t90_ = t56_ * t56_;
        let t91_ = T::mul_add(t89_, c_(0.76), t90_);
        let t92_ = t87_ * t39_;
        let t93_ = T::mul_add(t91_, t39_, t78_);
        let t94_ = T::mul_neg_add(t87_, t57_, t81_);
        let t95_ = T::mul_add(t87_, t92_, t82_);
        let t96_ = T::copysign(closure_d0_, c_(1.0));
        let t97_ = closure_d0_ + t96_;
        let t98_ = c_(0.5) * t97_;
        let t99_ = T::sqrt(t98_);
        let t100_ = T::sqrt(t93_);
        let t101_ = ::mstmm::generated::recip_above(t99_, t100_);
        let t102_ = t99_ * t101_;
        let t103_ = ::mstmm::generated::recip_above(closure_d0_, closure_d0_);
        let t104_ = t102_ * t103_;
        let t105_ = t94_ * t104_;
        let closure_d1_ = T::mul_neg_add(t94_, t105_, t95_);
        let t106_ = T::mul_add(t58_, t58_, t62_);
        let t107_ = c_(4.166666666666667) * t106_;
        let t108_ = b_drift_lin_y_ * t43_;
        let t109_ = b_drift_lin_y_ * t65_;
        let t110_ = t69_ * t69_;
        let t111_ = T::mul_add(t71_, t71_, t110_);
        let t112_ = t72_ * t72_;
        let t113_ = T::mul_add(c_(0.72), t111_, t112_);
        let t114_ = T::mul_add(t12_, t113_, t107_);
        let t115_ = a_drift_lin_y_ * t52_;
        let t116_ = cos_a_angle_ * t79_;
        let t117_ = T::mul_neg_add(sin_a_angle_, t80_, t116_);
        let t118_ = t117_ * t117_;
        let t119_ = T::mul_add(t86_, t86_, t118_);
        let t120_ = t87_ * t87_;
        let t121_ = T::mul_add(c_(0.76), t119_, t120_);
        let crank_pin_a_lin_x_ = sin_crank_pin_angle_ * c_(9.8);
        let crank_pin_a_lin_y_ = cos_crank_pin_angle_ * c_(9.8);
        let t122_ = minus_b_drift_lin_x_ + minus_b_e_force_x_;
        let t123_ = T::mul_add(t49_, a_w0_, t108_);
        let t124_ = T::mul_sub(minus_a_drift_lin_x_, t51_, t123_);
        let t125_ = T::mul_neg_add(t56_, crank_pin_z0_force_x_, t84_);
        let t126_ = T::mul_neg_add(t56_, crank_pin_z0_force_y_, t55_);
        let t127_ = T::mul_neg_add(t87_, crank_pin_z0_force_x_, t117_);
        let t128_ = T::mul_neg_add(t87_, crank_pin_z0_force_y_, t86_);
        let t129_ = T::mul_add(t121_, t39_, t114_);
        let t130_ = T::copysign(closure_d1_, c_(1.0));
        let t131_ = closure_d1_ + t130_;
        let t132_ = c_(0.5) * t131_;
        let t133_ = T::sqrt(t132_);
        let t134_ = T::sqrt(t129_);
        let t135_ = ::mstmm::generated::recip_above(t133_, t134_);
        let t136_ = t133_ * t135_;
        let t137_ = ::mstmm::generated::recip_above(closure_d1_, t95_);
        let t138_ = t136_ * t137_;
        let t139_ = T::mul_neg_add(closure_d0_, t104_, c_(1.0));
        let t140_ = t139_ * t139_;
        let t141_ = ::mstmm::generated::recip_above(t140_, c_(1.0));
        let t142_ = T::sqrt(t141_);
        let t143_ = t139_ * t142_;
        let t144_ = T::mul_neg_add(closure_d1_, t138_, c_(1.0));
        let t145_ = t105_ * t144_;
        let t146_ = t143_ * t145_;
        let t147_ = T::mul_neg_add(t143_, t146_, t145_);
        let t148_ = t147_ * t147_;
        let t149_ = T::mul_add(t144_, t144_, t148_);
        let t150_ = ::mstmm::generated::recip_above(t149_, c_(1.0));
        let t151_ = T::sqrt(t150_);
        let t152_ = t147_ * t151_;
        let t153_ = t144_ * t151_;
        let t154_ = T::mul_neg_add(crank_pin_a_lin_y_, t126_, t124_);
        let t155_ = T::mul_neg_add(cos_rocker_pin_angle_, t122_, t115_);
        let t156_ = T::mul_add(t56_, crank_pin_w0_, t155_);
        let t157_ = T::mul_add(crank_pin_a_lin_x_, t125_, t156_);
        let t158_ = t154_ - t157_;
        let t159_ = T::mul_neg_add(sin_rocker_pin_angle_, t122_, c_(9.8));
        let t160_ = T::mul_add(a_drift_lin_y_, t80_, t159_);
        let t161_ = T::mul_add(t87_, crank_pin_w0_, t160_);
        let t162_ = T::mul_add(crank_pin_a_lin_x_, t127_, t161_);
        let t163_ = T::mul_neg_add(t72_, a_w0_, t109_);
        let t164_ = T::mul_add(minus_a_drift_lin_x_, t79_, t163_);
        let t165_ = T::mul_sub(crank_pin_a_lin_y_, t128_, t164_);
        let t166_ = T::mul_sub(t105_, t158_, t165_);
        let t167_ = t162_ - t166_;
        let t168_ = t104_ * t158_;
        let t169_ = t138_ * t167_;
        let t170_ = T::mul_neg_add(t105_, t169_, t168_);
        let t171_ = t143_ * t170_;
        let t172_ = T::mul_neg_add(t143_, t171_, t170_);
        let t173_ = t152_ * t172_;
        let t174_ = T::mul_neg_add(t153_, t169_, t173_);
        let minus_closure_reaction0_ = T::mul_neg_add(t152_, t174_, t172_);
        let minus_closure_reaction1_ = T::mul_add(t153_, t174_, t169_);
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 5 mul, 4 add, 0 reciprocal.
        let t175_ = sin_crank_pin_angle_ * crank_pin_z0_force_x_;
        let t176_ = T::mul_add(cos_crank_pin_angle_, crank_pin_z0_force_y_, t175_);
        let t177_ = T::mul_sub(c_(9.8), t176_, crank_pin_w0_);
        let t178_ = T::mul_add(t92_, minus_closure_reaction1_, t177_);
        let crank_pin_a_ang_z_ = T::mul_sub(t57_, minus_closure_reaction0_, t178_);
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 17 mul, 14 add, 0 reciprocal.
        let t179_ = T::mul_neg_add(
            cos_a_angle_,
            crank_pin_a_lin_x_,
            minus_a_drift_lin_x_,
        );
        let t180_ = T::mul_add(c_(0.2), crank_pin_a_ang_z_, crank_pin_a_lin_y_);
        let minus_a_a_lin_x_ = T::mul_neg_add(sin_a_angle_, t180_, t179_);
        let t181_ = T::mul_neg_add(sin_a_angle_, crank_pin_a_lin_x_, a_drift_lin_y_);
        let a_a_lin_y_ = T::mul_add(cos_a_angle_, t180_, t181_);
        let t182_ = a_drift_lin_y_ * a_z0_force_y_;
        let t183_ = cos_a_angle_ * a_z0_force_x_;
        let t184_ = T::mul_neg_add(sin_a_angle_, a_z0_force_y_, t183_);
        let t185_ = sin_a_angle_ * a_z0_force_x_;
        let t186_ = T::mul_add(cos_a_angle_, a_z0_force_y_, t185_);
        let t187_ = c_(0.2) * t186_;
        let t188_ = T::mul_add(minus_a_drift_lin_x_, a_z0_force_x_, a_w0_);
        let t189_ = T::mul_sub(crank_pin_a_lin_x_, t184_, t188_);
        let t190_ = T::mul_sub(t50_, minus_closure_reaction0_, t189_);
        let t191_ = T::mul_add(crank_pin_a_lin_y_, t186_, t182_);
        let t192_ = T::mul_add(t73_, minus_closure_reaction1_, t191_);
        let t193_ = T::mul_add(t187_, crank_pin_a_ang_z_, t192_);
        let a_a_ang_z_ = t190_ - t193_;
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 9 mul, 5 add, 0 reciprocal.
        let t194_ = b_drift_lin_y_ * c_(2.5);
        let t195_ = sin_b_angle_ * c_(2.5);
        let t196_ = cos_b_angle_ * c_(2.5);
        let t197_ = cos_b_angle_ * c_(1.5);
        let t198_ = t42_ * minus_closure_reaction0_;
        let t199_ = T::mul_neg_add(t59_, minus_closure_reaction1_, t194_);
        let t200_ = T::mul_add(t196_, a_a_lin_y_, t199_);
        let t201_ = T::mul_neg_add(t197_, a_a_ang_z_, t198_);
        let t202_ = T::mul_sub(t195_, minus_a_a_lin_x_, t201_);
        let minus_b_a_ang_z_ = t200_ + t202_;
        /// Motion across `a`.
        let t203_ = cos_crank_pin_angle_ * cos_a_angle_;
        let a_axes_x_x_ = T::mul_neg_add(sin_crank_pin_angle_, sin_a_angle_, t203_);
        let t204_ = cos_crank_pin_angle_ * sin_a_angle_;
        let minus_a_axes_x_y_ = T::mul_add(sin_crank_pin_angle_, cos_a_angle_, t204_);
        let t205_ = cos_crank_pin_angle_ * c_(0.2);
        let t206_ = crank_pin_rate_ * t205_;
        let minus_a_drift_lin_x_2_ = crank_pin_rate_ * t206_;
        let t207_ = sin_crank_pin_angle_ * c_(0.2);
        let t208_ = crank_pin_rate_ * t207_;
        let minus_a_drift_lin_y_ = crank_pin_rate_ * t208_;
        /// Motion across `b`.
        let t209_ = cos_b_angle_ * a_axes_x_x_;
        let b_axes_x_x_ = T::mul_neg_add(sin_b_angle_, minus_a_axes_x_y_, t209_);
        let t210_ = sin_b_angle_ * a_axes_x_x_;
        let minus_b_axes_x_y_ = T::mul_add(cos_b_angle_, minus_a_axes_x_y_, t210_);
        let t211_ = c_(0.6) * a_axes_x_x_;
        let t212_ = a_omega_z_ * t211_;
        let t213_ = c_(0.6) * minus_a_axes_x_y_;
        let t214_ = a_omega_z_ * t213_;
        /// Point of `a`, [P, Eqs. (12), (13), (36)]: 2 mul, 2 add, 0 reciprocal.
        let minus_a_acc_lin_x_ = T::mul_add(
            crank_pin_a_ang_z_,
            t207_,
            minus_a_drift_lin_x_2_,
        );
        let minus_a_acc_lin_y_ = T::mul_neg_add(
            crank_pin_a_ang_z_,
            t205_,
            minus_a_drift_lin_y_,
        );
        /// Point of `b`, [P, Eqs. (12), (13), (36)]: 4 mul, 4 add, 0 reciprocal.
        let t215_ = T::mul_add(a_omega_z_, t212_, minus_a_acc_lin_x_);
        let minus_b_acc_lin_x_ = T::mul_add(a_a_ang_z_, t213_, t215_);
        let t216_ = T::mul_add(a_omega_z_, t214_, minus_a_acc_lin_y_);
        let b_acc_lin_y_ = T::mul_sub(a_a_ang_z_, t211_, t216_);
        /// Load on `rocker_pin`, [P, Eqs. (18), (19)]: 8 mul, 4 add, 0 reciprocal.
        let t217_ = cos_rocker_pin_angle_ * minus_closure_reaction0_;
        let t218_ = T::mul_neg_add(
            sin_rocker_pin_angle_,
            minus_closure_reaction1_,
            t217_,
        );
        let t219_ = sin_rocker_pin_angle_ * minus_closure_reaction0_;
        let t220_ = T::mul_add(cos_rocker_pin_angle_, minus_closure_reaction1_, t219_);
        let t221_ = b_axes_x_x_ * t218_;
        let minus_rocker_pin_load_force_x_ = T::mul_neg_add(
            minus_b_axes_x_y_,
            t220_,
            t221_,
        );
        let t222_ = minus_b_axes_x_y_ * t218_;
        let minus_rocker_pin_load_force_y_ = T::mul_add(b_axes_x_x_, t220_, t222_);
        /// Load on `b`, [P, Eqs. (18), (19)]: 8 mul, 9 add, 0 reciprocal.
        let t223_ = c_(0.6) * b_axes_x_x_;
        let t224_ = c_(0.6) * minus_b_axes_x_y_;
        let t225_ = b_omega_z_ * t223_;
        let t226_ = T::mul_add(b_omega_z_, t225_, minus_b_acc_lin_x_);
        let t227_ = T::mul_sub(minus_b_a_ang_z_, t224_, t226_);
        let t228_ = minus_b_acc_lin_x_ + minus_rocker_pin_load_force_x_;
        let b_load_force_x_ = t227_ - t228_;
        let t229_ = b_omega_z_ * t224_;
        let t230_ = T::mul_sub(b_omega_z_, t229_, b_acc_lin_y_);
        let t231_ = T::mul_add(minus_b_a_ang_z_, t223_, t230_);
        let t232_ = c_(19.6) - minus_rocker_pin_load_force_y_;
        let t233_ = b_acc_lin_y_ + t232_;
        let minus_b_load_force_y_ = t231_ - t233_;
        /// Load on `a`, [P, Eqs. (18), (19)]: 0 mul, 5 add, 0 reciprocal.
        let t234_ = minus_a_acc_lin_x_ + minus_b_acc_lin_x_;
        let a_load_force_x_ = b_load_force_x_ - t234_;
        let t235_ = c_(19.6) - minus_a_acc_lin_y_;
        let t236_ = b_acc_lin_y_ + t235_;
        let minus_a_load_force_y_ = minus_b_load_force_y_ - t236_;
        /// Load on `crank_pin`, [P, Eqs. (18), (19)]: 2 mul, 4 add, 0 reciprocal.
        let minus_crank_pin_load_force_x_ = T::mul_sub(
            c_(0.5),
            minus_a_acc_lin_x_,
            a_load_force_x_,
        );
        let t237_ = c_(9.8) - minus_a_acc_lin_y_;
        let t238_ = T::mul_add(c_(0.5), t237_, c_(4.9));
        let minus_crank_pin_load_force_y_ = minus_a_load_force_y_ - t238_;
        /// Results: 19 mul, 24 add, 0 reciprocal.
        let t239_ = crank_pin_a_ang_z_ - a_a_ang_z_;
        let t240_ = a_a_ang_z_ + minus_b_a_ang_z_;
        let t241_ = c_(4.0) + t18_;
        let t242_ = t16_ - t241_;
        let t243_ = T::mul_neg_add(
            c_(0.04000000000000001),
            t242_,
            c_(0.030000000000000006),
        );
        ::mstmm::generated::finite::<T>(&[&[state_.v.data.0[0][3], state_.t]])?;
        ::mstmm::generated::regular::<
            T,
            _,
            _,
        >(
            &["a", "crank_pin"],
            [a_j_zz_, crank_pin_j_zz_],
            [c_(2.04), t243_],
            [crank_pin_a_ang_z_, -t239_, -t240_, minus_b_a_ang_z_],
        )?;
        at_.accelerations.data.0 = [
            [crank_pin_a_ang_z_, -t239_, -t240_, minus_b_a_ang_z_],
        ];
        at_.rate_accelerations.data.0 = [
            [crank_pin_a_ang_z_, -t239_, -t240_, minus_b_a_ang_z_],
        ];
        at_.efforts.data.0 = [[crank_pin_input0_, c_(0.0), c_(0.0), c_(0.0)]];
        point0_.set_position([c_(0.0), c_(0.0)]);
        point0_.set_orientation([c_(1.0), c_(0.0)]);
        point0_.set_velocity([c_(0.0), c_(0.0)]);
        point0_.set_angular_velocity([c_(0.0)]);
        point0_.set_acceleration([c_(0.0), c_(0.0)]);
        point0_.set_angular_acceleration([c_(0.0)]);
        point0_.set_moment([-crank_pin_input0_]);
        point0_
            .set_force([-minus_crank_pin_load_force_x_, -minus_crank_pin_load_force_y_]);
        point1_.set_position([c_(0.0), c_(0.0)]);
        point1_.set_orientation([cos_crank_pin_angle_, sin_crank_pin_angle_]);
        point1_.set_velocity([c_(0.0), c_(0.0)]);
        point1_.set_angular_velocity([crank_pin_rate_]);
        point1_.set_acceleration([c_(0.0), c_(0.0)]);
        point1_.set_angular_acceleration([crank_pin_a_ang_z_]);
        point1_.set_moment([-crank_pin_input0_]);
        point1_
            .set_force([-minus_crank_pin_load_force_x_, -minus_crank_pin_load_force_y_]);
        point2_.set_position([t205_, t207_]);
        point2_.set_orientation([cos_crank_pin_angle_, sin_crank_pin_angle_]);
        point2_.set_velocity([-t208_, t206_]);
        point2_.set_angular_velocity([crank_pin_rate_]);
        point2_.set_acceleration([-minus_a_acc_lin_x_, -minus_a_acc_lin_y_]);
        point2_.set_angular_acceleration([crank_pin_a_ang_z_]);
        point2_.set_moment([c_(0.0)]);
        point2_.set_force([a_load_force_x_, -minus_a_load_force_y_]);
        point3_.set_position([t205_, t207_]);
        point3_.set_orientation([a_axes_x_x_, minus_a_axes_x_y_]);
        point3_.set_velocity([-t208_, t206_]);
        point3_.set_angular_velocity([a_omega_z_]);
        point3_.set_acceleration([-minus_a_acc_lin_x_, -minus_a_acc_lin_y_]);
        point3_.set_angular_acceleration([a_a_ang_z_]);
        point3_.set_moment([c_(0.0)]);
        point3_.set_force([a_load_force_x_, -minus_a_load_force_y_]);
        point4_.set_orientation([a_axes_x_x_, minus_a_axes_x_y_]);
        point4_.set_angular_velocity([a_omega_z_]);
        point4_.set_acceleration([-minus_b_acc_lin_x_, b_acc_lin_y_]);
        point4_.set_angular_acceleration([a_a_ang_z_]);
        point4_.set_moment([c_(0.0)]);
        point4_.set_force([b_load_force_x_, -minus_b_load_force_y_]);
        point5_.set_orientation([b_axes_x_x_, minus_b_axes_x_y_]);
        point5_.set_angular_velocity([b_omega_z_]);
        point5_.set_acceleration([-minus_b_acc_lin_x_, b_acc_lin_y_]);
        point5_.set_angular_acceleration([-minus_b_a_ang_z_]);
        point5_.set_moment([c_(0.0)]);
        point5_.set_force([b_load_force_x_, -minus_b_load_force_y_]);
        point6_.set_orientation([b_axes_x_x_, minus_b_axes_x_y_]);
        point6_.set_angular_velocity([b_omega_z_]);
        point6_.set_acceleration([t227_, -t231_]);
        point6_.set_angular_acceleration([-minus_b_a_ang_z_]);
        point6_.set_moment([c_(0.0)]);
        point6_
            .set_force([
                -minus_rocker_pin_load_force_x_,
                -minus_rocker_pin_load_force_y_,
            ]);
        point7_.set_position([c_(0.8), c_(0.0)]);
        point7_.set_orientation([c_(1.0), c_(0.0)]);
        point7_.set_velocity([c_(0.0), c_(0.0)]);
        point7_.set_angular_velocity([c_(0.0)]);
        point7_.set_acceleration([c_(0.0), c_(0.0)]);
        point7_.set_angular_acceleration([c_(0.0)]);
        point7_.set_moment([c_(0.0)]);
        point7_
            .set_force([
                -minus_rocker_pin_load_force_x_,
                -minus_rocker_pin_load_force_y_,
            ]);
        let t244_ = crank_pin_rate_ * c_(0.020000000000000004);
        let t245_ = a_omega_z_ * c_(0.24);
        let t246_ = b_omega_z_ * c_(0.24);
        let t247_ = t208_ + t214_;
        let t248_ = t206_ + t212_;
        point4_.set_velocity([-t247_, t248_]);
        point5_.set_velocity([-t247_, t248_]);
        let t249_ = t247_ + t229_;
        let t250_ = t248_ + t225_;
        point6_.set_velocity([-t249_, t250_]);
        let t251_ = crank_pin_rate_ * t244_;
        let t252_ = T::mul_add(a_omega_z_, t245_, t251_);
        let t253_ = T::mul_add(b_omega_z_, t246_, t252_);
        let t254_ = c_(0.5) * t253_;
        let t255_ = t208_ + t249_;
        let t256_ = t206_ + t250_;
        let t257_ = T::mul_add(t248_, t256_, t254_);
        let t258_ = T::mul_add(t247_, t255_, t257_);
        at_.kinetic_energy = t258_;
        let t259_ = t207_ + t213_;
        let t260_ = t259_ * c_(19.6);
        let t261_ = minus_a_axes_x_y_ + minus_b_axes_x_y_;
        let t262_ = T::mul_add(sin_crank_pin_angle_, c_(4.9), t260_);
        let t263_ = T::mul_add(c_(5.88), t261_, t262_);
        at_.potential_energy = t263_;
        let t264_ = cos_rocker_pin_angle_ * t143_;
        let t265_ = sin_rocker_pin_angle_ * t143_;
        let t266_ = cos_rocker_pin_angle_ * t152_;
        let t267_ = T::mul_add(sin_rocker_pin_angle_, t153_, t266_);
        let t268_ = sin_rocker_pin_angle_ * t152_;
        let t269_ = T::mul_neg_add(cos_rocker_pin_angle_, t153_, t268_);
        at_.closure = ::mstmm::generated::closure([
            [t264_, t265_, c_(0.0), c_(0.0), c_(0.0), c_(0.0)],
            [-t267_, -t269_, c_(0.0), c_(0.0), c_(0.0), c_(0.0)],
        ]);
        let t270_ = t205_ + t211_;
        point4_.set_position([t270_, t259_]);
        point5_.set_position([t270_, t259_]);
        let t271_ = t223_ + t270_;
        let t272_ = t224_ + t259_;
        point6_.set_position([t271_, t272_]);
        ::core::result::Result::Ok(())
    }
    /// Kinetic and potential energy in J; the potential of gravity is zero with every centre
    /// of mass at the inertial origin.
    ///
    /// 52 operations: 32 mul, 20 add, 0 reciprocal, 3 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 3 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 4 | 3 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 4 | 3 | 0 | 0 | 0 |
    /// | Results |  | 24 | 14 | 0 | 0 | 0 |
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
        /// Results: 24 mul, 14 add, 0 reciprocal.
        let t4_ = crank_pin_rate_ * c_(0.020000000000000004);
        let t5_ = a_omega_z_ * c_(0.24);
        let t6_ = b_omega_z_ * c_(0.24);
        let t7_ = cos_crank_pin_angle_ * c_(0.2);
        let t8_ = sin_crank_pin_angle_ * c_(0.2);
        let t9_ = crank_pin_rate_ * t8_;
        let t10_ = crank_pin_rate_ * t7_;
        let t11_ = c_(0.6) * a_axes_x_x_;
        let t12_ = c_(0.6) * minus_a_axes_x_y_;
        let t13_ = c_(0.6) * b_axes_x_x_;
        let t14_ = c_(0.6) * minus_b_axes_x_y_;
        let t15_ = T::mul_add(a_omega_z_, t12_, t9_);
        let t16_ = T::mul_add(a_omega_z_, t11_, t10_);
        let t17_ = crank_pin_rate_ * t4_;
        let t18_ = T::mul_add(a_omega_z_, t5_, t17_);
        let t19_ = T::mul_add(b_omega_z_, t6_, t18_);
        let t20_ = c_(0.5) * t19_;
        let t21_ = t9_ + t15_;
        let t22_ = T::mul_add(b_omega_z_, t14_, t21_);
        let t23_ = t10_ + t16_;
        let t24_ = T::mul_add(b_omega_z_, t13_, t23_);
        let t25_ = T::mul_add(t16_, t24_, t20_);
        let t26_ = T::mul_add(t15_, t22_, t25_);
        let t27_ = t8_ + t12_;
        let t28_ = t27_ * c_(19.6);
        let t29_ = minus_a_axes_x_y_ + minus_b_axes_x_y_;
        let t30_ = T::mul_add(sin_crank_pin_angle_, c_(4.9), t28_);
        let t31_ = T::mul_add(c_(5.88), t29_, t30_);
        ::mstmm::Energy {
            kinetic: t26_,
            potential: t31_,
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
        let t3_ = c_(0.5) + t2_;
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
        let t117_ = t116_ * t116_;
        let t118_ = T::mul_add(t113_, t113_, t117_);
        let t119_ = ::mstmm::generated::recip_above(t118_, c_(1.0));
        let t120_ = T::sqrt(t119_);
        let t121_ = t116_ * t120_;
        let t122_ = t113_ * t120_;
        let t123_ = cos_crank_pin_angle_ * cos_a_angle_;
        let t124_ = T::mul_neg_add(sin_crank_pin_angle_, sin_a_angle_, t123_);
        let t125_ = cos_crank_pin_angle_ * sin_a_angle_;
        let t126_ = T::mul_add(sin_crank_pin_angle_, cos_a_angle_, t125_);
        let t127_ = sin_crank_pin_angle_ * c_(0.2);
        let t128_ = cos_b_angle_ * t124_;
        let t129_ = T::mul_neg_add(sin_b_angle_, t126_, t128_);
        let t130_ = sin_b_angle_ * t124_;
        let t131_ = T::mul_add(cos_b_angle_, t126_, t130_);
        let t132_ = cos_rocker_pin_angle_ * t129_;
        let t133_ = T::mul_neg_add(sin_rocker_pin_angle_, t131_, t132_);
        let t134_ = sin_rocker_pin_angle_ * t129_;
        let t135_ = T::mul_add(cos_rocker_pin_angle_, t131_, t134_);
        let t136_ = t126_ + t131_;
        let t137_ = T::mul_add(c_(0.6), t136_, t127_);
        let t138_ = t124_ + t129_;
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
        let t168_ = a_omega_z_ * c_(0.6);
        let t169_ = c_(0.6) * b_omega_z_;
        let t170_ = sin_a_angle_ * t167_;
        let t171_ = T::mul_add(cos_a_angle_, t167_, t168_);
        let t172_ = cos_b_angle_ * t170_;
        let t173_ = T::mul_add(sin_b_angle_, t171_, t172_);
        let t174_ = cos_rocker_pin_angle_ * t173_;
        let t175_ = sin_rocker_pin_angle_ * t173_;
        let t176_ = T::mul_add(cos_b_angle_, t171_, t169_);
        let t177_ = T::mul_sub(sin_b_angle_, t170_, t176_);
        let t178_ = T::mul_neg_add(sin_rocker_pin_angle_, t177_, t174_);
        let t179_ = T::mul_add(cos_rocker_pin_angle_, t177_, t175_);
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
        let t217_ = t216_ * t216_;
        let t218_ = t215_ * t215_;
        let t219_ = T::mul_add(t178_, t178_, t218_);
        let t220_ = T::mul_add(t142_, t142_, t219_);
        let t221_ = T::mul_add(t206_, t206_, t220_);
        let t222_ = T::mul_add(t179_, t179_, t217_);
        let t223_ = T::mul_add(t144_, t144_, t222_);
        let t224_ = t221_ + t223_;
        let t225_ = T::sqrt(t224_);
        let residual_ = t225_;
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
