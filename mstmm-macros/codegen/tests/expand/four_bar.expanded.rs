/// A crank, a coupler and a rocker between two points of the ground.
///
/// # The chain
///
/// `ground -> pin crank_pin -> crank -> pin a -> coupler -> pin b -> rocker -> pin rocker_pin -> ground`
///
/// <svg role="img" aria-label="The chain at its start" viewBox="0 0 574 239" width="574" style="max-width:100%;height:auto" font-size="12" stroke-linecap="round" fill="currentColor">
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
/// <path d="M544.0 22.0l0.0 28.0m-3.5 -6.1l3.5 6.1l3.5 -6.1" fill="none" stroke="currentColor" stroke-width="1.5"/><text x="557.0" y="40.0" font-style="italic" text-anchor="middle">g</text>
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
/// Accelerations by `riccati`, 325 operations (199 mul, 116 add, 6 reciprocal, 4 square root, 4 sin/cos); with everything at every connection point 430 operations.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct FourBar<T> {
    changed_by_setters: ::mstmm::generated::Sealed<FourBarParameters<T>, [T; 0]>,
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
        let (chain_, _) = Self::derive(::mstmm::generated::Sealed::new(parameters_));
        chain_
    }
    /// The values that may change at run time: there are none.
    #[inline]
    pub fn parameters(&self) -> &FourBarParameters<T> {
        self.changed_by_setters.parameters()
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
    fn derive(
        sealed_: ::mstmm::generated::Sealed<FourBarParameters<T>>,
    ) -> (Self, [T; 0]) {
        let parameters_ = sealed_.parameters();
        let (derived_, checks_) = ([], []);
        (
            Self {
                changed_by_setters: sealed_.with(derived_),
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
    /// The accelerations `v̇` of all hinges, in the order of `v` of the state: the fast path.
    ///
    /// 325 operations: 199 mul, 116 add, 6 reciprocal, 4 square root, 4 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 13 | 4 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 29 | 23 | 1 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 117 | 65 | 4 | 4 | 0 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 2 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 2 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `b` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Acceleration of `a` | \[P, Eqs. (13), (36), (44)\] | 15 | 10 | 0 | 0 | 0 |
    /// | Acceleration of `crank_pin` | \[P, Eqs. (13), (36), (44)\] | 7 | 4 | 0 | 0 | 0 |
    /// | Acceleration of `b` | \[P, Eqs. (13), (36), (44)\] | 12 | 6 | 0 | 0 | 0 |
    /// | Results |  | 0 | 2 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// `Error::Singular` if no inertia is left beyond a
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
        /// Riccati transfer over `a`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 13 mul, 4 add, 1 reciprocal.
        let t4_ = sin_b_angle_ * sin_b_angle_;
        let t5_ = c_(1.5) * t4_;
        let t6_ = t5_ + c_(0.5);
        let a_articulated_inertia_zz_ = T::mul_add(c_(0.36), t6_, c_(0.24));
        let a_d_inverse_ = T::recip(a_articulated_inertia_zz_);
        let t3_ = sin_b_angle_ * cos_b_angle_;
        let a_articulated_coupling_yz_ = T::mul_add(c_(0.6), t6_, c_(0.6));
        let a_articulated_coupling_xz_ = t3_ * c_(0.8999999999999999);
        /// Riccati transfer over `crank_pin`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 29 mul, 23 add, 1 reciprocal.
        let t17_ = sin_a_angle_ * cos_a_angle_;
        /// Riccati transfer over `a`.
        let a_articulated_mass_xy_ = c_(1.5) * t3_;
        /// Riccati transfer over `crank_pin`.
        let t12_ = a_articulated_coupling_yz_ * a_articulated_coupling_yz_;
        let t14_ = a_articulated_coupling_xz_ * a_articulated_coupling_yz_;
        let t9_ = c_(2.5) + t5_;
        let t10_ = a_articulated_coupling_xz_ * a_articulated_coupling_xz_;
        let t8_ = t5_ - c_(4.0);
        let t21_ = c_(2.0) * t17_;
        let t13_ = T::mul_neg_add(a_d_inverse_, t12_, t9_);
        let t15_ = T::mul_neg_add(a_d_inverse_, t14_, a_articulated_mass_xy_);
        let t11_ = T::mul_add(a_d_inverse_, t10_, t8_);
        let t16_ = sin_a_angle_ * sin_a_angle_;
        let t22_ = T::mul_add(t15_, t21_, t13_);
        let t18_ = t11_ + t13_;
        let t23_ = T::mul_sub(t16_, t18_, t22_);
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 117 mul, 65 add, 4 reciprocal, 4 square root.
        let t34_ = T::mul_neg_add(sin_rocker_pin_angle_, c_(1.5), sin_rocker_pin_angle_);
        let t37_ = sin_b_angle_ * cos_rocker_pin_angle_;
        /// Riccati transfer over `crank_pin`.
        let crank_pin_articulated_inertia_zz_ = T::mul_neg_add(
            c_(0.04000000000000001),
            t23_,
            c_(0.020000000000000004),
        );
        /// Closure.
        let t35_ = cos_b_angle_ * cos_rocker_pin_angle_;
        let t38_ = T::mul_add(cos_b_angle_, t34_, t37_);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_d_inverse_ = T::recip(crank_pin_articulated_inertia_zz_);
        /// Closure.
        let t36_ = T::mul_neg_add(sin_b_angle_, t34_, t35_);
        let t39_ = c_(0.6) * t38_;
        /// Riccati transfer over `a`.
        let a_gain_fx_ = a_articulated_coupling_xz_ * a_d_inverse_;
        /// Closure.
        let t53_ = cos_rocker_pin_angle_ * cos_rocker_pin_angle_;
        /// Riccati transfer over `a`.
        let a_gain_fy_ = a_articulated_coupling_yz_ * a_d_inverse_;
        /// Closure.
        let t40_ = T::mul_neg_add(t39_, a_gain_fx_, t36_);
        let t45_ = T::sqrt(a_d_inverse_);
        let t54_ = T::mul_add(sin_rocker_pin_angle_, sin_rocker_pin_angle_, t53_);
        let t41_ = T::mul_neg_add(t39_, a_gain_fy_, t38_);
        let t71_ = cos_a_angle_ * t40_;
        let t42_ = sin_a_angle_ * t40_;
        let t50_ = T::sqrt(crank_pin_d_inverse_);
        let t52_ = c_(0.6) * sin_rocker_pin_angle_;
        let t55_ = t54_ * c_(0.36);
        let t64_ = t36_ * t36_;
        let t72_ = T::mul_neg_add(sin_a_angle_, t41_, t71_);
        let t43_ = T::mul_add(cos_a_angle_, t41_, t42_);
        let t56_ = T::mul_add(t52_, t52_, t55_);
        let t65_ = T::mul_add(t38_, t38_, t64_);
        let t66_ = t39_ * t39_;
        let t76_ = t72_ * t72_;
        let t44_ = c_(0.2) * t43_;
        let t57_ = T::mul_neg_add(cos_rocker_pin_angle_, c_(1.5), cos_rocker_pin_angle_);
        let t61_ = sin_b_angle_ * sin_rocker_pin_angle_;
        let t46_ = sin_rocker_pin_angle_ * c_(1.2247448713915892);
        let t58_ = t56_ * c_(4.166666666666667);
        let t67_ = T::mul_add(t65_, c_(0.72), t66_);
        let t77_ = T::mul_add(t43_, t43_, t76_);
        let t78_ = t44_ * t44_;
        let t59_ = cos_b_angle_ * sin_rocker_pin_angle_;
        let t62_ = T::mul_neg_add(cos_b_angle_, t57_, t61_);
        let t48_ = t46_ * t46_;
        let t70_ = T::mul_add(a_d_inverse_, t67_, t58_);
        let t47_ = t39_ * t45_;
        let t79_ = T::mul_add(t77_, c_(0.76), t78_);
        let t60_ = T::mul_add(sin_b_angle_, t57_, t59_);
        let t63_ = c_(0.6) * t62_;
        let t49_ = T::mul_add(t47_, t47_, t48_);
        let t84_ = T::mul_add(t79_, crank_pin_d_inverse_, t70_);
        let t51_ = t44_ * t50_;
        let t68_ = T::mul_neg_add(t63_, a_gain_fx_, t60_);
        let t86_ = c_(0.0009765625) * t84_;
        let closure_d0_ = T::mul_add(t51_, t51_, t49_);
        let t69_ = T::mul_neg_add(t63_, a_gain_fy_, t62_);
        let t73_ = sin_a_angle_ * t68_;
        let t80_ = cos_rocker_pin_angle_ * c_(1.2247448713915892);
        let t87_ = ::mstmm::generated::recip_above(closure_d0_, t86_);
        let t74_ = T::mul_add(cos_a_angle_, t69_, t73_);
        let t82_ = t46_ * t80_;
        let t81_ = t63_ * t45_;
        let t75_ = c_(0.2) * t74_;
        let t105_ = cos_a_angle_ * t68_;
        let t83_ = T::mul_neg_add(t47_, t81_, t82_);
        let t85_ = t75_ * t50_;
        let t97_ = c_(0.6) * cos_rocker_pin_angle_;
        let t100_ = t60_ * t60_;
        let t106_ = T::mul_neg_add(sin_a_angle_, t69_, t105_);
        let t88_ = T::mul_neg_add(t51_, t85_, t83_);
        let t98_ = T::mul_add(t97_, t97_, t55_);
        let t124_ = T::mul_neg_add(closure_d0_, t87_, c_(1.0));
        let t101_ = T::mul_add(t62_, t62_, t100_);
        let t102_ = t63_ * t63_;
        let t107_ = t106_ * t106_;
        let t89_ = t87_ * t88_;
        let t127_ = t124_ * t124_;
        let t99_ = t98_ * c_(4.166666666666667);
        let t103_ = T::mul_add(c_(0.72), t101_, t102_);
        let t108_ = T::mul_add(t74_, t74_, t107_);
        let t109_ = t75_ * t75_;
        /// Motion across `a`, [P, Eqs. (1), (13), (36)]: 2 mul, 1 add, 0 reciprocal.
        let a_omega_z_ = crank_pin_rate_ + a_rate_;
        /// Closure.
        let t90_ = T::mul_neg_add(t46_, t89_, t80_);
        let t128_ = ::mstmm::generated::recip_above(t127_, c_(1.0));
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 2 mul, 1 add, 0 reciprocal.
        let b_omega_z_ = b_rate_ + a_omega_z_;
        /// Closure.
        let t104_ = T::mul_add(a_d_inverse_, t103_, t99_);
        let t110_ = T::mul_add(c_(0.76), t108_, t109_);
        let t91_ = T::mul_add(t47_, t89_, t81_);
        let t93_ = t90_ * t90_;
        /// Riccati transfer over `b`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 0 add, 0 reciprocal.
        let t2_ = b_omega_z_ * b_omega_z_;
        /// Closure.
        let t121_ = T::mul_add(t110_, crank_pin_d_inverse_, t104_);
        let t92_ = T::mul_add(t51_, t89_, t85_);
        let t94_ = T::mul_add(t91_, t91_, t93_);
        /// Motion across `b`.
        let t1_ = a_omega_z_ * a_omega_z_;
        /// Riccati transfer over `b`.
        let minus_b_bias_fx_ = c_(0.6) * t2_;
        /// Closure.
        let t122_ = c_(0.0009765625) * t121_;
        let closure_d1_ = T::mul_add(t92_, t92_, t94_);
        /// Motion across `b`.
        let minus_b_centripetal_x_ = t1_ * c_(0.6);
        /// Riccati transfer over `a`.
        let t7_ = sin_b_angle_ * minus_b_bias_fx_;
        /// Closure.
        let t129_ = T::sqrt(t128_);
        let t123_ = ::mstmm::generated::recip_above(closure_d1_, t122_);
        /// Riccati transfer over `a`.
        let minus_a_bias_fy_ = T::mul_add(
            minus_b_centripetal_x_,
            a_articulated_mass_xy_,
            t7_,
        );
        let minus_a_bias_mz_ = c_(0.6) * minus_a_bias_fy_;
        /// Riccati transfer over `crank_pin`.
        let t27_ = T::mul_add(cos_b_angle_, minus_b_bias_fx_, minus_b_centripetal_x_);
        let t24_ = t5_ - c_(2.0);
        /// Riccati transfer over `a`.
        let a_rest_ = minus_a_bias_mz_ * a_d_inverse_;
        /// Riccati transfer over `crank_pin`.
        let t19_ = T::mul_neg_add(c_(2.0), t16_, c_(1.0));
        let t28_ = T::mul_sub(minus_b_centripetal_x_, t24_, t27_);
        /// Closure.
        let t125_ = T::mul_neg_add(closure_d1_, t123_, c_(1.0));
        /// Riccati transfer over `crank_pin`.
        let t25_ = T::mul_neg_add(a_articulated_coupling_yz_, a_rest_, minus_a_bias_fy_);
        /// Motion across `a`.
        let t0_ = crank_pin_rate_ * crank_pin_rate_;
        /// Riccati transfer over `crank_pin`.
        let t20_ = t15_ * t19_;
        let t29_ = T::mul_add(a_articulated_coupling_xz_, a_rest_, t28_);
        /// Closure.
        let t126_ = t89_ * t125_;
        let t130_ = t124_ * t129_;
        /// Riccati transfer over `crank_pin`.
        let t26_ = cos_a_angle_ * t25_;
        /// Motion across `a`.
        let minus_a_centripetal_x_ = t0_ * c_(0.2);
        /// Closure.
        let t95_ = cos_rocker_pin_angle_ * minus_b_bias_fx_;
        /// Riccati transfer over `crank_pin`.
        let crank_pin_articulated_mass_xy_ = T::mul_neg_add(t17_, t18_, t20_);
        /// Closure.
        let t131_ = t126_ * t130_;
        /// Riccati transfer over `crank_pin`.
        let t30_ = T::mul_neg_add(sin_a_angle_, t29_, t26_);
        /// Closure.
        let t96_ = T::mul_sub(sin_rocker_pin_angle_, minus_b_bias_fx_, c_(9.8));
        let t111_ = T::mul_add(minus_b_centripetal_x_, t36_, t95_);
        let t133_ = t125_ * t125_;
        let t132_ = T::mul_neg_add(t130_, t131_, t126_);
        /// Riccati transfer over `crank_pin`.
        let minus_crank_pin_bias_fy_ = T::mul_add(
            minus_a_centripetal_x_,
            crank_pin_articulated_mass_xy_,
            t30_,
        );
        /// Closure.
        let t114_ = T::mul_add(minus_b_centripetal_x_, t60_, t96_);
        let t112_ = T::mul_sub(t39_, a_rest_, t111_);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_articulated_coupling_yz_ = T::mul_neg_add(c_(0.2), t23_, c_(0.1));
        /// Closure.
        let t134_ = T::mul_add(t132_, t132_, t133_);
        /// Riccati transfer over `crank_pin`.
        let t33_ = T::mul_add(c_(0.2), minus_crank_pin_bias_fy_, crank_pin_input0_);
        /// Closure.
        let t115_ = T::mul_sub(t63_, a_rest_, t114_);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_articulated_coupling_xz_ = c_(0.2)
            * crank_pin_articulated_mass_xy_;
        /// Closure.
        let t113_ = T::mul_sub(minus_a_centripetal_x_, t72_, t112_);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_gain_fy_ = crank_pin_articulated_coupling_yz_
            * crank_pin_d_inverse_;
        /// Closure.
        let t135_ = ::mstmm::generated::recip_above(t134_, c_(1.0));
        /// Riccati transfer over `crank_pin`.
        let crank_pin_rest_ = t33_ * crank_pin_d_inverse_;
        /// Closure.
        let t116_ = T::mul_sub(minus_a_centripetal_x_, t106_, t115_);
        let crank_pin_a_lin_y_ = cos_crank_pin_angle_ * c_(9.8);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_gain_fx_ = crank_pin_articulated_coupling_xz_
            * crank_pin_d_inverse_;
        /// Closure.
        let t118_ = T::mul_neg_add(t44_, crank_pin_gain_fy_, t43_);
        let t120_ = T::mul_neg_add(t75_, crank_pin_gain_fy_, t74_);
        let t139_ = T::mul_neg_add(t44_, crank_pin_rest_, t113_);
        let t142_ = T::mul_neg_add(t75_, crank_pin_rest_, t116_);
        let crank_pin_a_lin_x_ = sin_crank_pin_angle_ * c_(9.8);
        let t117_ = T::mul_neg_add(t44_, crank_pin_gain_fx_, t72_);
        let t119_ = T::mul_neg_add(t75_, crank_pin_gain_fx_, t106_);
        let t140_ = T::mul_sub(crank_pin_a_lin_y_, t118_, t139_);
        let t143_ = T::mul_sub(crank_pin_a_lin_y_, t120_, t142_);
        let t141_ = T::mul_add(crank_pin_a_lin_x_, t117_, t140_);
        let t144_ = T::mul_add(crank_pin_a_lin_x_, t119_, t143_);
        let t136_ = T::sqrt(t135_);
        let t145_ = T::mul_add(t89_, t141_, t144_);
        let t146_ = t87_ * t141_;
        let t147_ = t123_ * t145_;
        let t148_ = T::mul_add(t89_, t147_, t146_);
        let t149_ = t130_ * t148_;
        let t150_ = T::mul_neg_add(t130_, t149_, t148_);
        let t137_ = t132_ * t136_;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 15 mul, 10 add, 0 reciprocal.
        let t164_ = cos_a_angle_ * a_gain_fx_;
        let t166_ = sin_a_angle_ * a_gain_fx_;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 7 mul, 4 add, 0 reciprocal.
        let t155_ = sin_crank_pin_angle_ * crank_pin_gain_fx_;
        /// Closure.
        let t138_ = t125_ * t136_;
        let t151_ = t137_ * t150_;
        /// Acceleration of `a`.
        let t165_ = T::mul_neg_add(sin_a_angle_, a_gain_fy_, t164_);
        let t159_ = minus_a_centripetal_x_ - crank_pin_a_lin_x_;
        let t167_ = T::mul_add(cos_a_angle_, a_gain_fy_, t166_);
        /// Acceleration of `crank_pin`.
        let t156_ = T::mul_add(cos_crank_pin_angle_, crank_pin_gain_fy_, t155_);
        /// Closure.
        let t152_ = T::mul_add(t138_, t147_, t151_);
        /// Acceleration of `a`.
        let t169_ = T::mul_add(t159_, t165_, a_rest_);
        let t163_ = t63_ * a_d_inverse_;
        /// Acceleration of `crank_pin`.
        let t154_ = t75_ * crank_pin_d_inverse_;
        let t157_ = T::mul_sub(c_(9.8), t156_, crank_pin_rest_);
        /// Closure.
        let minus_closure_reaction1_ = T::mul_neg_add(t138_, t152_, t147_);
        /// Acceleration of `a`.
        let t170_ = T::mul_sub(crank_pin_a_lin_y_, t167_, t169_);
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 12 mul, 6 add, 0 reciprocal.
        let t173_ = sin_rocker_pin_angle_ * c_(2.5);
        /// Acceleration of `a`.
        let t162_ = t39_ * a_d_inverse_;
        /// Acceleration of `crank_pin`.
        let t153_ = t44_ * crank_pin_d_inverse_;
        /// Closure.
        let closure_reaction0_ = T::mul_neg_add(t137_, t152_, t150_);
        /// Acceleration of `crank_pin`.
        let t158_ = T::mul_add(t154_, minus_closure_reaction1_, t157_);
        /// Acceleration of `a`.
        let t171_ = T::mul_add(t163_, minus_closure_reaction1_, t170_);
        /// Acceleration of `b`.
        let t174_ = cos_rocker_pin_angle_ * c_(2.5);
        /// Acceleration of `a`.
        let t168_ = c_(0.2) * t167_;
        /// Acceleration of `b`.
        let t178_ = t173_ * closure_reaction0_;
        /// Acceleration of `crank_pin`.
        let minus_crank_pin_a_ang_z_ = T::mul_add(t153_, closure_reaction0_, t158_);
        /// Acceleration of `a`.
        let t172_ = T::mul_add(t162_, closure_reaction0_, t171_);
        /// Acceleration of `b`.
        let t177_ = cos_b_angle_ * c_(1.5);
        let t179_ = T::mul_add(cos_a_angle_, t159_, minus_b_centripetal_x_);
        let t181_ = T::mul_neg_add(t174_, minus_closure_reaction1_, t178_);
        /// Acceleration of `a`.
        let t161_ = T::mul_neg_add(
            c_(0.2),
            minus_crank_pin_a_ang_z_,
            crank_pin_a_lin_y_,
        );
        let a_a_ang_z_ = T::mul_sub(t168_, minus_crank_pin_a_ang_z_, t172_);
        /// Acceleration of `b`.
        let t175_ = sin_b_angle_ * c_(2.5);
        /// Acceleration of `a`.
        let t160_ = sin_a_angle_ * t159_;
        /// Acceleration of `b`.
        let t180_ = T::mul_sub(sin_a_angle_, t161_, t179_);
        let t182_ = T::mul_add(t177_, a_a_ang_z_, t181_);
        let t176_ = cos_b_angle_ * c_(2.5);
        /// Acceleration of `a`.
        let a_a_lin_y_ = T::mul_add(cos_a_angle_, t161_, t160_);
        /// Acceleration of `b`.
        let t183_ = T::mul_sub(t175_, t180_, t182_);
        /// Riccati transfer over `crank_pin`.
        let t31_ = c_(4.0) + t13_;
        let t32_ = t11_ - t31_;
        /// Acceleration of `b`.
        let minus_b_a_ang_z_ = T::mul_sub(t176_, a_a_lin_y_, t183_);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_d_scale_ = T::mul_neg_add(
            c_(0.04000000000000001),
            t32_,
            c_(0.030000000000000006),
        );
        /// Results: 0 mul, 2 add, 0 reciprocal.
        let t184_ = minus_crank_pin_a_ang_z_ + a_a_ang_z_;
        let t185_ = a_a_ang_z_ + minus_b_a_ang_z_;
        if !::mstmm::generated::regular::<
            T,
            _,
            _,
        >(
            [a_articulated_inertia_zz_, crank_pin_articulated_inertia_zz_],
            [c_(2.04), crank_pin_d_scale_],
            [state_.t, state_.v.data.0[0][3], t184_, -t185_],
        ) {
            return ::core::result::Result::Err(
                ::mstmm::generated::irregular::<
                    T,
                    _,
                >(
                    &["a", "crank_pin"],
                    [a_articulated_inertia_zz_, crank_pin_articulated_inertia_zz_],
                    [c_(2.04), crank_pin_d_scale_],
                ),
            );
        }
        accelerations_.data.0 = [
            [-minus_crank_pin_a_ang_z_, t184_, -t185_, minus_b_a_ang_z_],
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
    /// 430 operations: 261 mul, 159 add, 6 reciprocal, 4 square root, 4 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 13 | 4 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 29 | 23 | 1 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 117 | 65 | 4 | 4 | 0 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 2 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 2 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `b` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Acceleration of `a` | \[P, Eqs. (13), (36), (44)\] | 17 | 11 | 0 | 0 | 0 |
    /// | Acceleration of `crank_pin` | \[P, Eqs. (13), (36), (44)\] | 7 | 4 | 0 | 0 | 0 |
    /// | Acceleration of `b` | \[P, Eqs. (13), (36), (44)\] | 15 | 8 | 0 | 0 | 0 |
    /// | Results |  | 15 | 10 | 0 | 0 | 0 |
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
        *n2_ = -crank_pin_input0_;
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
        let a_articulated_inertia_zz_ = T::mul_add(c_(0.36), t6_, c_(0.24));
        let a_d_inverse_ = T::recip(a_articulated_inertia_zz_);
        let t3_ = sin_b_angle_ * cos_b_angle_;
        let a_articulated_coupling_yz_ = T::mul_add(c_(0.6), t6_, c_(0.6));
        let a_articulated_coupling_xz_ = t3_ * c_(0.8999999999999999);
        /// Riccati transfer over `crank_pin`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 29 mul, 23 add, 1 reciprocal.
        let t17_ = sin_a_angle_ * cos_a_angle_;
        /// Riccati transfer over `a`.
        let a_articulated_mass_xy_ = c_(1.5) * t3_;
        /// Riccati transfer over `crank_pin`.
        let t12_ = a_articulated_coupling_yz_ * a_articulated_coupling_yz_;
        let t14_ = a_articulated_coupling_xz_ * a_articulated_coupling_yz_;
        let t9_ = c_(2.5) + t5_;
        let t10_ = a_articulated_coupling_xz_ * a_articulated_coupling_xz_;
        let t8_ = t5_ - c_(4.0);
        let t21_ = c_(2.0) * t17_;
        let t13_ = T::mul_neg_add(a_d_inverse_, t12_, t9_);
        let t15_ = T::mul_neg_add(a_d_inverse_, t14_, a_articulated_mass_xy_);
        let t11_ = T::mul_add(a_d_inverse_, t10_, t8_);
        let t16_ = sin_a_angle_ * sin_a_angle_;
        let t22_ = T::mul_add(t15_, t21_, t13_);
        let t18_ = t11_ + t13_;
        let t23_ = T::mul_sub(t16_, t18_, t22_);
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 117 mul, 65 add, 4 reciprocal, 4 square root.
        let t34_ = T::mul_neg_add(sin_rocker_pin_angle_, c_(1.5), sin_rocker_pin_angle_);
        let t37_ = sin_b_angle_ * cos_rocker_pin_angle_;
        /// Riccati transfer over `crank_pin`.
        let crank_pin_articulated_inertia_zz_ = T::mul_neg_add(
            c_(0.04000000000000001),
            t23_,
            c_(0.020000000000000004),
        );
        /// Closure.
        let t35_ = cos_b_angle_ * cos_rocker_pin_angle_;
        let t38_ = T::mul_add(cos_b_angle_, t34_, t37_);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_d_inverse_ = T::recip(crank_pin_articulated_inertia_zz_);
        /// Closure.
        let t36_ = T::mul_neg_add(sin_b_angle_, t34_, t35_);
        let t39_ = c_(0.6) * t38_;
        /// Riccati transfer over `a`.
        let a_gain_fx_ = a_articulated_coupling_xz_ * a_d_inverse_;
        /// Closure.
        let t53_ = cos_rocker_pin_angle_ * cos_rocker_pin_angle_;
        /// Riccati transfer over `a`.
        let a_gain_fy_ = a_articulated_coupling_yz_ * a_d_inverse_;
        /// Closure.
        let t40_ = T::mul_neg_add(t39_, a_gain_fx_, t36_);
        let t45_ = T::sqrt(a_d_inverse_);
        let t54_ = T::mul_add(sin_rocker_pin_angle_, sin_rocker_pin_angle_, t53_);
        let t41_ = T::mul_neg_add(t39_, a_gain_fy_, t38_);
        let t71_ = cos_a_angle_ * t40_;
        let t42_ = sin_a_angle_ * t40_;
        let t50_ = T::sqrt(crank_pin_d_inverse_);
        let t52_ = c_(0.6) * sin_rocker_pin_angle_;
        let t55_ = t54_ * c_(0.36);
        let t64_ = t36_ * t36_;
        let t72_ = T::mul_neg_add(sin_a_angle_, t41_, t71_);
        let t43_ = T::mul_add(cos_a_angle_, t41_, t42_);
        let t56_ = T::mul_add(t52_, t52_, t55_);
        let t65_ = T::mul_add(t38_, t38_, t64_);
        let t66_ = t39_ * t39_;
        let t76_ = t72_ * t72_;
        let t44_ = c_(0.2) * t43_;
        let t57_ = T::mul_neg_add(cos_rocker_pin_angle_, c_(1.5), cos_rocker_pin_angle_);
        let t61_ = sin_b_angle_ * sin_rocker_pin_angle_;
        let t46_ = sin_rocker_pin_angle_ * c_(1.2247448713915892);
        let t58_ = t56_ * c_(4.166666666666667);
        let t67_ = T::mul_add(t65_, c_(0.72), t66_);
        let t77_ = T::mul_add(t43_, t43_, t76_);
        let t78_ = t44_ * t44_;
        let t59_ = cos_b_angle_ * sin_rocker_pin_angle_;
        let t62_ = T::mul_neg_add(cos_b_angle_, t57_, t61_);
        let t48_ = t46_ * t46_;
        let t70_ = T::mul_add(a_d_inverse_, t67_, t58_);
        let t47_ = t39_ * t45_;
        let t79_ = T::mul_add(t77_, c_(0.76), t78_);
        let t60_ = T::mul_add(sin_b_angle_, t57_, t59_);
        let t63_ = c_(0.6) * t62_;
        let t49_ = T::mul_add(t47_, t47_, t48_);
        let t84_ = T::mul_add(t79_, crank_pin_d_inverse_, t70_);
        let t51_ = t44_ * t50_;
        let t68_ = T::mul_neg_add(t63_, a_gain_fx_, t60_);
        let t86_ = c_(0.0009765625) * t84_;
        let closure_d0_ = T::mul_add(t51_, t51_, t49_);
        let t69_ = T::mul_neg_add(t63_, a_gain_fy_, t62_);
        let t73_ = sin_a_angle_ * t68_;
        let t80_ = cos_rocker_pin_angle_ * c_(1.2247448713915892);
        let t87_ = ::mstmm::generated::recip_above(closure_d0_, t86_);
        let t74_ = T::mul_add(cos_a_angle_, t69_, t73_);
        let t82_ = t46_ * t80_;
        let t81_ = t63_ * t45_;
        let t75_ = c_(0.2) * t74_;
        let t105_ = cos_a_angle_ * t68_;
        let t83_ = T::mul_neg_add(t47_, t81_, t82_);
        let t85_ = t75_ * t50_;
        let t97_ = c_(0.6) * cos_rocker_pin_angle_;
        let t100_ = t60_ * t60_;
        let t106_ = T::mul_neg_add(sin_a_angle_, t69_, t105_);
        let t88_ = T::mul_neg_add(t51_, t85_, t83_);
        let t98_ = T::mul_add(t97_, t97_, t55_);
        let t124_ = T::mul_neg_add(closure_d0_, t87_, c_(1.0));
        let t101_ = T::mul_add(t62_, t62_, t100_);
        let t102_ = t63_ * t63_;
        let t107_ = t106_ * t106_;
        let t89_ = t87_ * t88_;
        let t127_ = t124_ * t124_;
        let t99_ = t98_ * c_(4.166666666666667);
        let t103_ = T::mul_add(c_(0.72), t101_, t102_);
        let t108_ = T::mul_add(t74_, t74_, t107_);
        let t109_ = t75_ * t75_;
        /// Motion across `a`, [P, Eqs. (1), (13), (36)]: 2 mul, 1 add, 0 reciprocal.
        let a_omega_z_ = crank_pin_rate_ + a_rate_;
        *n21_ = a_omega_z_;
        ::mstmm::generated::written();
        /// Closure.
        let t90_ = T::mul_neg_add(t46_, t89_, t80_);
        let t128_ = ::mstmm::generated::recip_above(t127_, c_(1.0));
        /// Motion across `b`, [P, Eqs. (1), (13), (36)]: 2 mul, 1 add, 0 reciprocal.
        let b_omega_z_ = b_rate_ + a_omega_z_;
        *n33_ = b_omega_z_;
        ::mstmm::generated::written();
        /// Closure.
        let t104_ = T::mul_add(a_d_inverse_, t103_, t99_);
        let t110_ = T::mul_add(c_(0.76), t108_, t109_);
        let t91_ = T::mul_add(t47_, t89_, t81_);
        let t93_ = t90_ * t90_;
        /// Riccati transfer over `b`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 0 add, 0 reciprocal.
        let t2_ = b_omega_z_ * b_omega_z_;
        /// Closure.
        let t121_ = T::mul_add(t110_, crank_pin_d_inverse_, t104_);
        let t92_ = T::mul_add(t51_, t89_, t85_);
        let t94_ = T::mul_add(t91_, t91_, t93_);
        /// Motion across `b`.
        let t1_ = a_omega_z_ * a_omega_z_;
        /// Riccati transfer over `b`.
        let minus_b_bias_fx_ = c_(0.6) * t2_;
        /// Closure.
        let t122_ = c_(0.0009765625) * t121_;
        let closure_d1_ = T::mul_add(t92_, t92_, t94_);
        /// Motion across `b`.
        let minus_b_centripetal_x_ = t1_ * c_(0.6);
        /// Riccati transfer over `a`.
        let t7_ = sin_b_angle_ * minus_b_bias_fx_;
        /// Closure.
        let t129_ = T::sqrt(t128_);
        let t123_ = ::mstmm::generated::recip_above(closure_d1_, t122_);
        /// Riccati transfer over `a`.
        let minus_a_bias_fy_ = T::mul_add(
            minus_b_centripetal_x_,
            a_articulated_mass_xy_,
            t7_,
        );
        let minus_a_bias_mz_ = c_(0.6) * minus_a_bias_fy_;
        /// Riccati transfer over `crank_pin`.
        let t27_ = T::mul_add(cos_b_angle_, minus_b_bias_fx_, minus_b_centripetal_x_);
        let t24_ = t5_ - c_(2.0);
        /// Riccati transfer over `a`.
        let a_rest_ = minus_a_bias_mz_ * a_d_inverse_;
        /// Riccati transfer over `crank_pin`.
        let t19_ = T::mul_neg_add(c_(2.0), t16_, c_(1.0));
        let t28_ = T::mul_sub(minus_b_centripetal_x_, t24_, t27_);
        /// Closure.
        let t125_ = T::mul_neg_add(closure_d1_, t123_, c_(1.0));
        /// Riccati transfer over `crank_pin`.
        let t25_ = T::mul_neg_add(a_articulated_coupling_yz_, a_rest_, minus_a_bias_fy_);
        /// Motion across `a`.
        let t0_ = crank_pin_rate_ * crank_pin_rate_;
        /// Riccati transfer over `crank_pin`.
        let t20_ = t15_ * t19_;
        let t29_ = T::mul_add(a_articulated_coupling_xz_, a_rest_, t28_);
        /// Closure.
        let t126_ = t89_ * t125_;
        let t130_ = t124_ * t129_;
        /// Riccati transfer over `crank_pin`.
        let t26_ = cos_a_angle_ * t25_;
        /// Motion across `a`.
        let minus_a_centripetal_x_ = t0_ * c_(0.2);
        /// Closure.
        let t95_ = cos_rocker_pin_angle_ * minus_b_bias_fx_;
        /// Riccati transfer over `crank_pin`.
        let crank_pin_articulated_mass_xy_ = T::mul_neg_add(t17_, t18_, t20_);
        /// Closure.
        let t131_ = t126_ * t130_;
        /// Riccati transfer over `crank_pin`.
        let t30_ = T::mul_neg_add(sin_a_angle_, t29_, t26_);
        /// Closure.
        let t96_ = T::mul_sub(sin_rocker_pin_angle_, minus_b_bias_fx_, c_(9.8));
        let t111_ = T::mul_add(minus_b_centripetal_x_, t36_, t95_);
        let t133_ = t125_ * t125_;
        let t132_ = T::mul_neg_add(t130_, t131_, t126_);
        /// Riccati transfer over `crank_pin`.
        let minus_crank_pin_bias_fy_ = T::mul_add(
            minus_a_centripetal_x_,
            crank_pin_articulated_mass_xy_,
            t30_,
        );
        /// Closure.
        let t114_ = T::mul_add(minus_b_centripetal_x_, t60_, t96_);
        let t112_ = T::mul_sub(t39_, a_rest_, t111_);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_articulated_coupling_yz_ = T::mul_neg_add(c_(0.2), t23_, c_(0.1));
        /// Closure.
        let t134_ = T::mul_add(t132_, t132_, t133_);
        /// Riccati transfer over `crank_pin`.
        let t33_ = T::mul_add(c_(0.2), minus_crank_pin_bias_fy_, crank_pin_input0_);
        /// Closure.
        let t115_ = T::mul_sub(t63_, a_rest_, t114_);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_articulated_coupling_xz_ = c_(0.2)
            * crank_pin_articulated_mass_xy_;
        /// Closure.
        let t113_ = T::mul_sub(minus_a_centripetal_x_, t72_, t112_);
        /// Riccati transfer over `crank_pin`.
        let crank_pin_gain_fy_ = crank_pin_articulated_coupling_yz_
            * crank_pin_d_inverse_;
        /// Closure.
        let t135_ = ::mstmm::generated::recip_above(t134_, c_(1.0));
        /// Riccati transfer over `crank_pin`.
        let crank_pin_rest_ = t33_ * crank_pin_d_inverse_;
        /// Closure.
        let t116_ = T::mul_sub(minus_a_centripetal_x_, t106_, t115_);
        let crank_pin_a_lin_y_ = cos_crank_pin_angle_ * c_(9.8);
        *n9_ = crank_pin_a_lin_y_;
        ::mstmm::generated::written();
        /// Riccati transfer over `crank_pin`.
        let crank_pin_gain_fx_ = crank_pin_articulated_coupling_xz_
            * crank_pin_d_inverse_;
        /// Closure.
        let t118_ = T::mul_neg_add(t44_, crank_pin_gain_fy_, t43_);
        let t120_ = T::mul_neg_add(t75_, crank_pin_gain_fy_, t74_);
        let t139_ = T::mul_neg_add(t44_, crank_pin_rest_, t113_);
        let t142_ = T::mul_neg_add(t75_, crank_pin_rest_, t116_);
        let crank_pin_a_lin_x_ = sin_crank_pin_angle_ * c_(9.8);
        *n8_ = crank_pin_a_lin_x_;
        ::mstmm::generated::written();
        let t117_ = T::mul_neg_add(t44_, crank_pin_gain_fx_, t72_);
        let t119_ = T::mul_neg_add(t75_, crank_pin_gain_fx_, t106_);
        let t140_ = T::mul_sub(crank_pin_a_lin_y_, t118_, t139_);
        let t143_ = T::mul_sub(crank_pin_a_lin_y_, t120_, t142_);
        let t141_ = T::mul_add(crank_pin_a_lin_x_, t117_, t140_);
        let t144_ = T::mul_add(crank_pin_a_lin_x_, t119_, t143_);
        let t136_ = T::sqrt(t135_);
        let t145_ = T::mul_add(t89_, t141_, t144_);
        let t146_ = t87_ * t141_;
        let t147_ = t123_ * t145_;
        let t148_ = T::mul_add(t89_, t147_, t146_);
        let t149_ = t130_ * t148_;
        let t150_ = T::mul_neg_add(t130_, t149_, t148_);
        let t137_ = t132_ * t136_;
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 17 mul, 11 add, 0 reciprocal.
        let t165_ = cos_a_angle_ * a_gain_fx_;
        let t167_ = sin_a_angle_ * a_gain_fx_;
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 7 mul, 4 add, 0 reciprocal.
        let t155_ = sin_crank_pin_angle_ * crank_pin_gain_fx_;
        /// Closure.
        let t138_ = t125_ * t136_;
        let t151_ = t137_ * t150_;
        /// Acceleration of `a`.
        let t166_ = T::mul_neg_add(sin_a_angle_, a_gain_fy_, t165_);
        let t159_ = minus_a_centripetal_x_ - crank_pin_a_lin_x_;
        let t168_ = T::mul_add(cos_a_angle_, a_gain_fy_, t167_);
        /// Acceleration of `crank_pin`.
        let t156_ = T::mul_add(cos_crank_pin_angle_, crank_pin_gain_fy_, t155_);
        /// Closure.
        let t152_ = T::mul_add(t138_, t147_, t151_);
        /// Acceleration of `a`.
        let t170_ = T::mul_add(t159_, t166_, a_rest_);
        let t164_ = t63_ * a_d_inverse_;
        /// Acceleration of `crank_pin`.
        let t154_ = t75_ * crank_pin_d_inverse_;
        let t157_ = T::mul_sub(c_(9.8), t156_, crank_pin_rest_);
        /// Closure.
        let minus_closure_reaction1_ = T::mul_neg_add(t138_, t152_, t147_);
        /// Acceleration of `a`.
        let t171_ = T::mul_sub(crank_pin_a_lin_y_, t168_, t170_);
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 15 mul, 8 add, 0 reciprocal.
        let t179_ = sin_rocker_pin_angle_ * c_(2.5);
        /// Acceleration of `a`.
        let t163_ = t39_ * a_d_inverse_;
        /// Acceleration of `crank_pin`.
        let t153_ = t44_ * crank_pin_d_inverse_;
        /// Closure.
        let closure_reaction0_ = T::mul_neg_add(t137_, t152_, t150_);
        /// Acceleration of `crank_pin`.
        let t158_ = T::mul_add(t154_, minus_closure_reaction1_, t157_);
        /// Acceleration of `a`.
        let t172_ = T::mul_add(t164_, minus_closure_reaction1_, t171_);
        /// Acceleration of `b`.
        let t180_ = cos_rocker_pin_angle_ * c_(2.5);
        /// Acceleration of `a`.
        let t169_ = c_(0.2) * t168_;
        /// Acceleration of `b`.
        let t184_ = t179_ * closure_reaction0_;
        /// Acceleration of `crank_pin`.
        let minus_crank_pin_a_ang_z_ = T::mul_add(t153_, closure_reaction0_, t158_);
        *n10_ = -minus_crank_pin_a_ang_z_;
        ::mstmm::generated::written();
        /// Acceleration of `a`.
        let t173_ = T::mul_add(t163_, closure_reaction0_, t172_);
        /// Acceleration of `b`.
        let t183_ = cos_b_angle_ * c_(1.5);
        /// Acceleration of `a`.
        let t162_ = sin_a_angle_ * t159_;
        /// Acceleration of `b`.
        let t185_ = T::mul_neg_add(t180_, minus_closure_reaction1_, t184_);
        /// Acceleration of `a`.
        let t161_ = T::mul_neg_add(
            c_(0.2),
            minus_crank_pin_a_ang_z_,
            crank_pin_a_lin_y_,
        );
        let a_a_ang_z_ = T::mul_sub(t169_, minus_crank_pin_a_ang_z_, t173_);
        *n22_ = a_a_ang_z_;
        ::mstmm::generated::written();
        let t160_ = cos_a_angle_ * t159_;
        /// Acceleration of `b`.
        let t182_ = cos_b_angle_ * c_(2.5);
        /// Acceleration of `a`.
        let a_a_lin_y_ = T::mul_add(cos_a_angle_, t161_, t162_);
        *n18_ = a_a_lin_y_;
        ::mstmm::generated::written();
        /// Acceleration of `b`.
        let t186_ = T::mul_add(t183_, a_a_ang_z_, t185_);
        /// Acceleration of `a`.
        let minus_a_a_lin_x_ = T::mul_neg_add(sin_a_angle_, t161_, t160_);
        *n17_ = -minus_a_a_lin_x_;
        ::mstmm::generated::written();
        /// Acceleration of `b`.
        let t181_ = sin_b_angle_ * c_(2.5);
        let t187_ = T::mul_add(t182_, a_a_lin_y_, t186_);
        /// Results: 15 mul, 10 add, 0 reciprocal.
        let t214_ = t0_ * c_(0.09000000000000002);
        /// Acceleration of `b`.
        let t174_ = minus_b_centripetal_x_ + minus_a_a_lin_x_;
        /// Load on `crank_pin`, [P, Eqs. (18), (19)]: 19 mul, 18 add, 0 reciprocal.
        let t192_ = sin_rocker_pin_angle_ * closure_reaction0_;
        /// Acceleration of `b`.
        let t175_ = c_(0.6) * a_a_ang_z_;
        let minus_b_a_ang_z_ = T::mul_add(t181_, t174_, t187_);
        *n34_ = -minus_b_a_ang_z_;
        ::mstmm::generated::written();
        /// Results.
        let t216_ = T::mul_add(t1_, c_(0.48), t214_);
        /// Velocity behind `a`: 3 mul, 0 add, 0 reciprocal.
        let t205_ = crank_pin_rate_ * c_(0.2);
        /// Results.
        let t215_ = a_omega_z_ * c_(1.7999999999999998);
        /// Load on `crank_pin`.
        let t190_ = cos_rocker_pin_angle_ * closure_reaction0_;
        let t193_ = T::mul_neg_add(
            cos_rocker_pin_angle_,
            minus_closure_reaction1_,
            t192_,
        );
        *n42_ = t193_;
        ::mstmm::generated::written();
        /// Acceleration of `b`.
        let t178_ = sin_b_angle_ * t174_;
        let t176_ = a_a_lin_y_ + t175_;
        /// Load on `crank_pin`.
        let t189_ = c_(0.6) * minus_b_a_ang_z_;
        /// Connection points, [P, Eqs. (4), (12), (13)]: 3 mul, 5 add, 0 reciprocal.
        let t211_ = c_(0.6) * b_omega_z_;
        /// Results.
        let t217_ = T::mul_add(t2_, c_(0.12), t216_);
        /// Pose behind `a`, [P, Eq. (12)]: 6 mul, 2 add, 0 reciprocal.
        let t203_ = cos_crank_pin_angle_ * cos_a_angle_;
        let a_position_x_ = cos_crank_pin_angle_ * c_(0.2);
        *n11_ = a_position_x_;
        ::mstmm::generated::written();
        let a_position_y_ = sin_crank_pin_angle_ * c_(0.2);
        *n12_ = a_position_y_;
        ::mstmm::generated::written();
        /// Velocity behind `a`.
        let a_velocity_y_ = cos_a_angle_ * t205_;
        *n14_ = a_velocity_y_;
        ::mstmm::generated::written();
        /// Acceleration of `b`.
        let t177_ = cos_b_angle_ * t174_;
        let b_a_lin_y_ = T::mul_add(cos_b_angle_, t176_, t178_);
        *n30_ = b_a_lin_y_;
        ::mstmm::generated::written();
        /// Load on `crank_pin`.
        let t191_ = T::mul_add(sin_rocker_pin_angle_, minus_closure_reaction1_, t190_);
        *n41_ = t191_;
        ::mstmm::generated::written();
        let t195_ = t189_ - t193_;
        /// Velocity behind `a`.
        let a_velocity_x_ = sin_a_angle_ * t205_;
        *n13_ = a_velocity_x_;
        ::mstmm::generated::written();
        /// Pose behind `a`.
        let t204_ = cos_crank_pin_angle_ * sin_a_angle_;
        let a_to_inertial_xx_ = T::mul_neg_add(
            sin_crank_pin_angle_,
            sin_a_angle_,
            t203_,
        );
        *n15_ = a_to_inertial_xx_;
        ::mstmm::generated::written();
        /// Results.
        let t220_ = sin_crank_pin_angle_ * c_(8.82);
        /// Load on `crank_pin`.
        let t188_ = T::mul_sub(t0_, c_(0.1), crank_pin_a_lin_x_);
        let t198_ = T::mul_add(c_(2.0), a_a_lin_y_, t175_);
        /// Acceleration of `b`.
        let minus_b_a_lin_x_ = T::mul_neg_add(sin_b_angle_, t176_, t177_);
        *n29_ = -minus_b_a_lin_x_;
        ::mstmm::generated::written();
        /// Load on `crank_pin`.
        let b_load_fy_ = T::mul_sub(c_(2.0), b_a_lin_y_, t195_);
        *n32_ = b_load_fy_;
        ::mstmm::generated::written();
        let t194_ = minus_b_bias_fx_ - t191_;
        /// Velocity behind `b`: 5 mul, 3 add, 0 reciprocal.
        let t208_ = T::mul_add(a_omega_z_, c_(0.6), a_velocity_y_);
        let t210_ = sin_b_angle_ * a_velocity_x_;
        /// Pose behind `a`.
        let minus_a_to_inertial_xy_ = T::mul_add(
            sin_crank_pin_angle_,
            cos_a_angle_,
            t204_,
        );
        *n16_ = minus_a_to_inertial_xy_;
        ::mstmm::generated::written();
        /// Pose behind `b`, [P, Eq. (12)]: 6 mul, 4 add, 0 reciprocal.
        let t206_ = cos_b_angle_ * a_to_inertial_xx_;
        /// Velocity behind `b`.
        let t209_ = cos_b_angle_ * a_velocity_x_;
        /// Results.
        let t218_ = T::mul_add(a_velocity_y_, t215_, t217_);
        /// Load on `crank_pin`.
        let t196_ = T::mul_add(c_(2.0), minus_a_a_lin_x_, minus_b_centripetal_x_);
        let minus_b_load_fx_ = T::mul_add(c_(2.0), minus_b_a_lin_x_, t194_);
        *n31_ = -minus_b_load_fx_;
        ::mstmm::generated::written();
        let t199_ = T::mul_add(cos_b_angle_, b_load_fy_, t198_);
        /// Pose behind `b`.
        let b_position_x_ = T::mul_add(c_(0.6), a_to_inertial_xx_, a_position_x_);
        *n23_ = b_position_x_;
        ::mstmm::generated::written();
        let t207_ = sin_b_angle_ * a_to_inertial_xx_;
        /// Velocity behind `b`.
        let minus_b_velocity_y_ = T::mul_neg_add(cos_b_angle_, t208_, t210_);
        *n26_ = -minus_b_velocity_y_;
        ::mstmm::generated::written();
        /// Pose behind `b`.
        let b_position_y_ = T::mul_add(c_(0.6), minus_a_to_inertial_xy_, a_position_y_);
        *n24_ = b_position_y_;
        ::mstmm::generated::written();
        let b_to_inertial_xx_ = T::mul_neg_add(
            sin_b_angle_,
            minus_a_to_inertial_xy_,
            t206_,
        );
        *n27_ = b_to_inertial_xx_;
        ::mstmm::generated::written();
        /// Velocity behind `b`.
        let b_velocity_x_ = T::mul_add(sin_b_angle_, t208_, t209_);
        *n25_ = b_velocity_x_;
        *n37_ = b_velocity_x_;
        ::mstmm::generated::written();
        /// Results.
        let t221_ = T::mul_add(minus_a_to_inertial_xy_, c_(17.64), t220_);
        /// Riccati transfer over `crank_pin`.
        let t31_ = c_(4.0) + t13_;
        /// Load on `crank_pin`.
        let t197_ = T::mul_add(sin_b_angle_, b_load_fy_, t196_);
        let minus_a_load_fy_ = T::mul_sub(sin_b_angle_, minus_b_load_fx_, t199_);
        *n20_ = -minus_a_load_fy_;
        ::mstmm::generated::written();
        let t201_ = T::mul_neg_add(
            c_(0.1),
            minus_crank_pin_a_ang_z_,
            crank_pin_a_lin_y_,
        );
        /// Pose behind `b`.
        let minus_b_to_inertial_xy_ = T::mul_add(
            cos_b_angle_,
            minus_a_to_inertial_xy_,
            t207_,
        );
        *n28_ = minus_b_to_inertial_xy_;
        ::mstmm::generated::written();
        /// Connection points.
        let minus_point6_velocity_y_ = minus_b_velocity_y_ - t211_;
        *n38_ = -minus_point6_velocity_y_;
        ::mstmm::generated::written();
        /// Results.
        let t219_ = T::mul_sub(minus_b_velocity_y_, t211_, t218_);
        at_.kinetic_energy = -t219_;
        ::mstmm::generated::written();
        /// Connection points.
        let point6_position_x_ = T::mul_add(c_(0.6), b_to_inertial_xx_, b_position_x_);
        *n35_ = point6_position_x_;
        ::mstmm::generated::written();
        /// Riccati transfer over `crank_pin`.
        let t32_ = t11_ - t31_;
        /// Results.
        let t225_ = cos_rocker_pin_angle_ * t137_;
        let t227_ = sin_rocker_pin_angle_ * t137_;
        /// Load on `crank_pin`.
        let minus_a_load_fx_ = T::mul_add(cos_b_angle_, minus_b_load_fx_, t197_);
        *n19_ = -minus_a_load_fx_;
        ::mstmm::generated::written();
        let t200_ = T::mul_neg_add(sin_a_angle_, minus_a_load_fy_, t188_);
        let t202_ = T::mul_sub(cos_a_angle_, minus_a_load_fy_, t201_);
        /// Connection points.
        let point6_position_y_ = T::mul_add(
            c_(0.6),
            minus_b_to_inertial_xy_,
            b_position_y_,
        );
        *n36_ = point6_position_y_;
        ::mstmm::generated::written();
        /// Results.
        let t222_ = T::mul_add(minus_b_to_inertial_xy_, c_(5.88), t221_);
        at_.potential_energy = t222_;
        ::mstmm::generated::written();
        /// Riccati transfer over `crank_pin`.
        let crank_pin_d_scale_ = T::mul_neg_add(
            c_(0.04000000000000001),
            t32_,
            c_(0.030000000000000006),
        );
        /// Results.
        let t223_ = cos_rocker_pin_angle_ * t130_;
        let t224_ = sin_rocker_pin_angle_ * t130_;
        let t226_ = T::mul_add(sin_rocker_pin_angle_, t138_, t225_);
        let t228_ = T::mul_neg_add(cos_rocker_pin_angle_, t138_, t227_);
        at_.closure = ::mstmm::generated::closure([
            [t223_, t224_, c_(0.0), c_(0.0), c_(0.0), c_(0.0)],
            [-t226_, -t228_, c_(0.0), c_(0.0), c_(0.0), c_(0.0)],
        ]);
        ::mstmm::generated::written();
        let t212_ = minus_crank_pin_a_ang_z_ + a_a_ang_z_;
        /// Load on `crank_pin`.
        let minus_crank_pin_load_fx_ = T::mul_add(cos_a_angle_, minus_a_load_fx_, t200_);
        *n3_ = -minus_crank_pin_load_fx_;
        ::mstmm::generated::written();
        let minus_crank_pin_load_fy_ = T::mul_add(sin_a_angle_, minus_a_load_fx_, t202_);
        *n4_ = -minus_crank_pin_load_fy_;
        ::mstmm::generated::written();
        /// Results.
        let t213_ = a_a_ang_z_ + minus_b_a_ang_z_;
        if !::mstmm::generated::regular::<
            T,
            _,
            _,
        >(
            [a_articulated_inertia_zz_, crank_pin_articulated_inertia_zz_],
            [c_(2.04), crank_pin_d_scale_],
            [state_.t, state_.v.data.0[0][3], t212_, -t213_],
        ) {
            let error_ = ::mstmm::generated::irregular::<
                T,
                _,
            >(
                &["a", "crank_pin"],
                [a_articulated_inertia_zz_, crank_pin_articulated_inertia_zz_],
                [c_(2.04), crank_pin_d_scale_],
            );
            ::mstmm::generated::take_back(at_, || self.workspace());
            return ::core::result::Result::Err(error_);
        }
        at_.accelerations.data.0 = [
            [-minus_crank_pin_a_ang_z_, t212_, -t213_, minus_b_a_ang_z_],
        ];
        ::mstmm::generated::written();
        /// Connection points.
        let minus_point6_felt_x_ = minus_b_bias_fx_ + minus_b_a_lin_x_;
        *n39_ = -minus_point6_felt_x_;
        ::mstmm::generated::written();
        let point6_felt_y_ = b_a_lin_y_ - t189_;
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
    fn close<E: ::core::convert::From<::mstmm::Error>>(
        &self,
        state_: &mut FourBarState<T>,
        inputs_: impl ::core::ops::FnOnce(
            &FourBarState<T>,
        ) -> ::core::result::Result<FourBarInputs<T>, E>,
    ) -> ::core::result::Result<(), E> {
        let inputs_ = inputs_(state_)?;
        let residual_ = self.correct(state_, &inputs_);
        ::core::result::Result::Ok(())
    }
}
#[allow(dead_code)]
impl<T: ::mstmm::Scalar> FourBar<T> {
    /// Corrects coordinates and rates once by the motion of least kinetic energy that
    /// closes the chain, and returns how far it was from closed and how much
    /// redundant directions of the closing hinge held.
    ///
    /// 346 operations: 209 mul, 124 add, 7 reciprocal, 6 square root, 5 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `crank_pin` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 4 |
    /// | Motion across `a` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Motion across `b` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `a` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 9 | 3 | 1 | 0 | 0 |
    /// | Riccati transfer over `crank_pin` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 12 | 9 | 1 | 0 | 0 |
    /// | Closure | \[P, Eqs. (9) to (11)\] at the held end | 140 | 73 | 4 | 4 | 0 |
    /// | Acceleration of `crank_pin` | \[P, Eqs. (13), (36), (44)\] | 6 | 2 | 0 | 0 | 0 |
    /// | Acceleration of `a` | \[P, Eqs. (13), (36), (44)\] | 17 | 5 | 0 | 0 | 0 |
    /// | Acceleration of `b` | \[P, Eqs. (13), (36), (44)\] | 15 | 8 | 0 | 0 | 0 |
    /// | Results |  | 10 | 22 | 1 | 2 | 1 |
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn correct(
        &self,
        state_: &mut FourBarState<T>,
        inputs_: &FourBarInputs<T>,
    ) -> [T; 2] {
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
        let a_articulated_mass_xy_ = c_(1.5) * t0_;
        let a_articulated_coupling_xz_ = t0_ * c_(0.8999999999999999);
        let t1_ = sin_b_angle_ * sin_b_angle_;
        let t2_ = c_(1.5) * t1_;
        let t3_ = t2_ + c_(0.5);
        let a_articulated_coupling_yz_ = T::mul_add(c_(0.6), t3_, c_(0.6));
        let a_articulated_inertia_zz_ = T::mul_add(c_(0.36), t3_, c_(0.24));
        let a_d_inverse_ = T::recip(a_articulated_inertia_zz_);
        let a_gain_fx_ = a_articulated_coupling_xz_ * a_d_inverse_;
        let a_gain_fy_ = a_articulated_coupling_yz_ * a_d_inverse_;
        /// Riccati transfer over `crank_pin`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 12 mul, 9 add, 1 reciprocal.
        let t4_ = t2_ - c_(4.0);
        let t5_ = c_(2.5) + t2_;
        let t6_ = a_articulated_coupling_xz_ * a_articulated_coupling_xz_;
        let t7_ = T::mul_add(a_d_inverse_, t6_, t4_);
        let t8_ = a_articulated_coupling_yz_ * a_articulated_coupling_yz_;
        let t9_ = T::mul_neg_add(a_d_inverse_, t8_, t5_);
        let t10_ = a_articulated_coupling_xz_ * a_articulated_coupling_yz_;
        let t11_ = T::mul_neg_add(a_d_inverse_, t10_, a_articulated_mass_xy_);
        let t12_ = sin_a_angle_ * sin_a_angle_;
        let t13_ = sin_a_angle_ * cos_a_angle_;
        let t14_ = t7_ + t9_;
        let t15_ = c_(2.0) * t13_;
        let t16_ = T::mul_add(t11_, t15_, t9_);
        let t17_ = T::mul_sub(t12_, t14_, t16_);
        let crank_pin_articulated_inertia_zz_ = T::mul_neg_add(
            c_(0.04000000000000001),
            t17_,
            c_(0.020000000000000004),
        );
        let crank_pin_d_inverse_ = T::recip(crank_pin_articulated_inertia_zz_);
        /// Closure, [P, Eqs. (9) to (11)] at the held end: 140 mul, 73 add, 4 reciprocal, 4 square root.
        let t18_ = T::mul_neg_add(sin_rocker_pin_angle_, c_(1.5), sin_rocker_pin_angle_);
        let t19_ = cos_b_angle_ * cos_rocker_pin_angle_;
        let t20_ = T::mul_neg_add(sin_b_angle_, t18_, t19_);
        let t21_ = sin_b_angle_ * cos_rocker_pin_angle_;
        let t22_ = T::mul_add(cos_b_angle_, t18_, t21_);
        let t23_ = c_(0.6) * t22_;
        let t24_ = T::mul_neg_add(t23_, a_gain_fx_, t20_);
        let t25_ = T::mul_neg_add(t23_, a_gain_fy_, t22_);
        let t26_ = sin_a_angle_ * t24_;
        let t27_ = T::mul_add(cos_a_angle_, t25_, t26_);
        let t28_ = c_(0.2) * t27_;
        let t29_ = T::sqrt(a_d_inverse_);
        let t30_ = sin_rocker_pin_angle_ * c_(1.2247448713915892);
        let t31_ = t23_ * t29_;
        let t32_ = t30_ * t30_;
        let t33_ = T::mul_add(t31_, t31_, t32_);
        let t34_ = T::sqrt(crank_pin_d_inverse_);
        let t35_ = t28_ * t34_;
        let closure_d0_ = T::mul_add(t35_, t35_, t33_);
        let t36_ = c_(0.6) * sin_rocker_pin_angle_;
        let t37_ = cos_rocker_pin_angle_ * cos_rocker_pin_angle_;
        let t38_ = T::mul_add(sin_rocker_pin_angle_, sin_rocker_pin_angle_, t37_);
        let t39_ = t38_ * c_(0.36);
        let t40_ = T::mul_add(t36_, t36_, t39_);
        let t41_ = T::mul_neg_add(cos_rocker_pin_angle_, c_(1.5), cos_rocker_pin_angle_);
        let t42_ = t40_ * c_(4.166666666666667);
        let t43_ = cos_b_angle_ * sin_rocker_pin_angle_;
        let t44_ = T::mul_add(sin_b_angle_, t41_, t43_);
        let t45_ = sin_b_angle_ * sin_rocker_pin_angle_;
        let t46_ = T::mul_neg_add(cos_b_angle_, t41_, t45_);
        let t47_ = c_(0.6) * t46_;
        let t48_ = t20_ * t20_;
        let t49_ = T::mul_add(t22_, t22_, t48_);
        let t50_ = t23_ * t23_;
        let t51_ = T::mul_add(t49_, c_(0.72), t50_);
        let t52_ = T::mul_neg_add(t47_, a_gain_fx_, t44_);
        let t53_ = T::mul_neg_add(t47_, a_gain_fy_, t46_);
        let t54_ = T::mul_add(a_d_inverse_, t51_, t42_);
        let t55_ = cos_a_angle_ * t24_;
        let t56_ = T::mul_neg_add(sin_a_angle_, t25_, t55_);
        let t57_ = sin_a_angle_ * t52_;
        let t58_ = T::mul_add(cos_a_angle_, t53_, t57_);
        let t59_ = c_(0.2) * t58_;
        let t60_ = t56_ * t56_;
        let t61_ = T::mul_add(t27_, t27_, t60_);
        let t62_ = t28_ * t28_;
        let t63_ = T::mul_add(t61_, c_(0.76), t62_);
        let t64_ = cos_rocker_pin_angle_ * c_(1.2247448713915892);
        let t65_ = t47_ * t29_;
        let t66_ = t30_ * t64_;
        let t67_ = T::mul_neg_add(t31_, t65_, t66_);
        let t68_ = T::mul_add(t63_, crank_pin_d_inverse_, t54_);
        let t69_ = t59_ * t34_;
        let t70_ = c_(0.0009765625) * t68_;
        let t71_ = ::mstmm::generated::recip_above(closure_d0_, t70_);
        let t72_ = T::mul_neg_add(t35_, t69_, t67_);
        let t73_ = t71_ * t72_;
        let t74_ = T::mul_neg_add(t30_, t73_, t64_);
        let t75_ = T::mul_add(t31_, t73_, t65_);
        let t76_ = T::mul_add(t35_, t73_, t69_);
        let t77_ = t74_ * t74_;
        let t78_ = T::mul_add(t75_, t75_, t77_);
        let closure_d1_ = T::mul_add(t76_, t76_, t78_);
        let t79_ = c_(0.6) * cos_rocker_pin_angle_;
        let t80_ = T::mul_add(t79_, t79_, t39_);
        let t81_ = t80_ * c_(4.166666666666667);
        let t82_ = t44_ * t44_;
        let t83_ = T::mul_add(t46_, t46_, t82_);
        let t84_ = t47_ * t47_;
        let t85_ = T::mul_add(c_(0.72), t83_, t84_);
        let t86_ = T::mul_add(a_d_inverse_, t85_, t81_);
        let t87_ = cos_a_angle_ * t52_;
        let t88_ = T::mul_neg_add(sin_a_angle_, t53_, t87_);
        let t89_ = t88_ * t88_;
        let t90_ = T::mul_add(t58_, t58_, t89_);
        let t91_ = t59_ * t59_;
        let t92_ = T::mul_add(c_(0.76), t90_, t91_);
        let t93_ = T::mul_add(t92_, crank_pin_d_inverse_, t86_);
        let t94_ = c_(0.0009765625) * t93_;
        let t95_ = ::mstmm::generated::recip_above(closure_d1_, t94_);
        let t96_ = T::mul_neg_add(closure_d0_, t71_, c_(1.0));
        let t97_ = T::mul_neg_add(closure_d1_, t95_, c_(1.0));
        let t98_ = t73_ * t97_;
        let t99_ = t96_ * t96_;
        let t100_ = ::mstmm::generated::recip_above(t99_, c_(1.0));
        let t101_ = T::sqrt(t100_);
        let t102_ = t96_ * t101_;
        let t103_ = t98_ * t102_;
        let t104_ = T::mul_neg_add(t102_, t103_, t98_);
        let t105_ = t97_ * t97_;
        let t106_ = T::mul_add(t104_, t104_, t105_);
        let t107_ = ::mstmm::generated::recip_above(t106_, c_(1.0));
        let t108_ = T::sqrt(t107_);
        let t109_ = t104_ * t108_;
        let t110_ = t97_ * t108_;
        let t111_ = sin_crank_pin_angle_ * c_(0.2);
        let t112_ = cos_crank_pin_angle_ * cos_a_angle_;
        let t113_ = T::mul_neg_add(sin_crank_pin_angle_, sin_a_angle_, t112_);
        let t114_ = cos_crank_pin_angle_ * sin_a_angle_;
        let t115_ = T::mul_add(sin_crank_pin_angle_, cos_a_angle_, t114_);
        let t116_ = cos_b_angle_ * t113_;
        let t117_ = T::mul_neg_add(sin_b_angle_, t115_, t116_);
        let t118_ = sin_b_angle_ * t113_;
        let t119_ = T::mul_add(cos_b_angle_, t115_, t118_);
        let t120_ = cos_rocker_pin_angle_ * t117_;
        let t121_ = T::mul_neg_add(sin_rocker_pin_angle_, t119_, t120_);
        let t122_ = sin_rocker_pin_angle_ * t117_;
        let t123_ = T::mul_add(cos_rocker_pin_angle_, t119_, t122_);
        let t124_ = t115_ + t119_;
        let t125_ = T::mul_add(c_(0.6), t124_, t111_);
        let t126_ = t113_ + t117_;
        let t127_ = T::mul_neg_add(cos_crank_pin_angle_, c_(0.2), c_(0.8));
        let t128_ = T::mul_sub(c_(0.6), t126_, t127_);
        let t129_ = t121_ * t128_;
        let t130_ = T::mul_add(t123_, t125_, t129_);
        let t131_ = t123_ * t128_;
        let t132_ = T::mul_neg_add(t121_, t125_, t131_);
        let t133_ = T::mul_add(t73_, t130_, t132_);
        let t134_ = t71_ * t130_;
        let t135_ = t95_ * t133_;
        let t136_ = T::mul_add(t73_, t135_, t134_);
        let t137_ = t102_ * t136_;
        let t138_ = T::mul_neg_add(t102_, t137_, t136_);
        let t139_ = t109_ * t138_;
        let t140_ = T::mul_add(t110_, t135_, t139_);
        let closure_reaction0_ = T::mul_neg_add(t109_, t140_, t138_);
        let minus_closure_reaction1_ = T::mul_neg_add(t110_, t140_, t135_);
        /// Acceleration of `crank_pin`, [P, Eqs. (13), (36), (44)]: 6 mul, 2 add, 0 reciprocal.
        let t141_ = t28_ * crank_pin_d_inverse_;
        let t142_ = t59_ * crank_pin_d_inverse_;
        let t143_ = t141_ * closure_reaction0_;
        let minus_crank_pin_a_ang_z_ = T::mul_add(
            t142_,
            minus_closure_reaction1_,
            t143_,
        );
        /// Acceleration of `a`, [P, Eqs. (13), (36), (44)]: 17 mul, 5 add, 0 reciprocal.
        let t144_ = c_(0.2) * minus_crank_pin_a_ang_z_;
        let minus_a_a_lin_x_ = sin_a_angle_ * t144_;
        let minus_a_a_lin_y_ = cos_a_angle_ * t144_;
        let t145_ = t23_ * a_d_inverse_;
        let t146_ = t47_ * a_d_inverse_;
        let t147_ = sin_a_angle_ * a_gain_fx_;
        let t148_ = T::mul_add(cos_a_angle_, a_gain_fy_, t147_);
        let t149_ = c_(0.2) * t148_;
        let t150_ = t145_ * closure_reaction0_;
        let t151_ = T::mul_add(t146_, minus_closure_reaction1_, t150_);
        let a_a_ang_z_ = T::mul_sub(t149_, minus_crank_pin_a_ang_z_, t151_);
        /// Acceleration of `b`, [P, Eqs. (13), (36), (44)]: 15 mul, 8 add, 0 reciprocal.
        let t152_ = sin_rocker_pin_angle_ * c_(2.5);
        let t153_ = cos_rocker_pin_angle_ * c_(2.5);
        let t154_ = sin_b_angle_ * c_(2.5);
        let t155_ = cos_b_angle_ * c_(2.5);
        let t156_ = cos_b_angle_ * c_(1.5);
        let t157_ = t152_ * closure_reaction0_;
        let t158_ = T::mul_neg_add(t153_, minus_closure_reaction1_, t157_);
        let t159_ = T::mul_add(t156_, a_a_ang_z_, t158_);
        let t160_ = T::mul_sub(t155_, minus_a_a_lin_y_, t159_);
        let minus_b_a_ang_z_ = T::mul_sub(t154_, minus_a_a_lin_x_, t160_);
        /// Closure.
        let t161_ = crank_pin_rate_ * c_(0.2);
        let t162_ = sin_a_angle_ * t161_;
        let t163_ = a_omega_z_ * c_(0.6);
        let t164_ = T::mul_add(cos_a_angle_, t161_, t163_);
        let t165_ = cos_b_angle_ * t162_;
        let t166_ = T::mul_add(sin_b_angle_, t164_, t165_);
        let t167_ = c_(0.6) * b_omega_z_;
        let t168_ = cos_rocker_pin_angle_ * t166_;
        let t169_ = sin_rocker_pin_angle_ * t166_;
        let t170_ = T::mul_sub(sin_b_angle_, t162_, t167_);
        let t171_ = T::mul_sub(cos_b_angle_, t164_, t170_);
        let t172_ = T::mul_add(sin_rocker_pin_angle_, t171_, t168_);
        let t173_ = T::mul_neg_add(cos_rocker_pin_angle_, t171_, t169_);
        let t174_ = T::mul_add(t73_, t172_, t173_);
        let t175_ = t71_ * t172_;
        let t176_ = t95_ * t174_;
        let t177_ = T::mul_add(t73_, t176_, t175_);
        let t178_ = t102_ * t177_;
        let t179_ = T::mul_neg_add(t102_, t178_, t177_);
        let t180_ = t109_ * t179_;
        let t181_ = T::mul_add(t110_, t176_, t180_);
        let closure_reaction0_2_ = T::mul_neg_add(t109_, t181_, t179_);
        let minus_closure_reaction1_2_ = T::mul_neg_add(t110_, t181_, t176_);
        /// Acceleration of `crank_pin`.
        let t182_ = t141_ * closure_reaction0_2_;
        let minus_crank_pin_a_ang_z_2_ = T::mul_add(
            t142_,
            minus_closure_reaction1_2_,
            t182_,
        );
        /// Acceleration of `a`.
        let t183_ = c_(0.2) * minus_crank_pin_a_ang_z_2_;
        let minus_a_a_lin_x_2_ = sin_a_angle_ * t183_;
        let minus_a_a_lin_y_2_ = cos_a_angle_ * t183_;
        let t184_ = t145_ * closure_reaction0_2_;
        let t185_ = T::mul_add(t146_, minus_closure_reaction1_2_, t184_);
        let a_a_ang_z_2_ = T::mul_sub(t149_, minus_crank_pin_a_ang_z_2_, t185_);
        /// Acceleration of `b`.
        let t186_ = t152_ * closure_reaction0_2_;
        let t187_ = T::mul_neg_add(t153_, minus_closure_reaction1_2_, t186_);
        let t188_ = T::mul_add(t156_, a_a_ang_z_2_, t187_);
        let t189_ = T::mul_sub(t155_, minus_a_a_lin_y_2_, t188_);
        let minus_b_a_ang_z_2_ = T::mul_sub(t154_, minus_a_a_lin_x_2_, t189_);
        /// Results: 10 mul, 22 add, 1 reciprocal, 2 square root, 1 sin/cos.
        let t190_ = crank_pin_angle_ - minus_crank_pin_a_ang_z_;
        let t191_ = a_angle_ + minus_crank_pin_a_ang_z_;
        let t192_ = a_a_ang_z_ + t191_;
        let t193_ = b_angle_ - a_a_ang_z_;
        let t194_ = minus_b_a_ang_z_ - t193_;
        let t195_ = T::mul_add(t123_, t123_, c_(0.000000000000000000000000000001));
        let t196_ = T::sqrt(t195_);
        let t197_ = T::atan2(t196_, t121_);
        let t198_ = T::recip(t196_);
        let t199_ = t197_ * t198_;
        let t200_ = t123_ * t199_;
        let t201_ = rocker_pin_angle_ - t200_;
        let t202_ = t201_ + minus_b_a_ang_z_;
        let t203_ = crank_pin_rate_ - minus_crank_pin_a_ang_z_2_;
        let t204_ = a_rate_ + minus_crank_pin_a_ang_z_2_;
        let t205_ = a_a_ang_z_2_ + t204_;
        let t206_ = b_rate_ - a_a_ang_z_2_;
        let t207_ = minus_b_a_ang_z_2_ - t206_;
        let t208_ = b_omega_z_ - minus_b_a_ang_z_2_;
        let t209_ = rocker_pin_rate_ + b_omega_z_;
        let t210_ = c_(1.0) - t121_;
        let t211_ = t209_ * t209_;
        let t212_ = T::mul_add(t173_, t173_, t211_);
        let t213_ = T::mul_add(t172_, t172_, t212_);
        let t214_ = T::mul_add(t210_, t210_, t213_);
        let t215_ = T::mul_add(t130_, t130_, t214_);
        let t216_ = T::mul_add(t132_, t132_, t215_);
        let t217_ = T::mul_add(t200_, t200_, t216_);
        let t218_ = T::sqrt(t217_);
        let residual_ = [t218_, c_(0.0)];
        state_.q.data.0 = [[t190_, t192_, -t194_, t202_]];
        state_.v.data.0 = [[t203_, t205_, -t207_, -t208_]];
        residual_
    }
}
impl<T: ::mstmm::Scalar> FourBar<T> {
    /// Closes the chain: moves `state` to coordinates and rates nearby that fulfil the
    /// closure.
    ///
    /// The coordinates are found by Newton's method. Of all small motions that close
    /// the gap to first order, each correction is the one with the least kinetic energy,
    /// ½ δᵀ M δ for a motion δ along the rates and the mass matrix M of bodies and rotors.
    /// The rates are changed along with them: of all changes that make the closing
    /// hinge's sides move alike, each is the one with the least kinetic energy, as
    /// an impulse in the closing hinge would make it. Each correction is minimal; the sum
    /// of several corrections is minimal up to the square of its length.
    ///
    /// # Errors
    ///
    /// `Error::NotAssembled` if the corrections do not converge, `Error::Closure` if they lead to
    /// a pose in which the closure has a higher rank than around the start;
    /// `state` is left as it was.
    #[allow(dead_code)]
    pub fn assemble(
        &self,
        state_: &mut FourBarState<T>,
        inputs_: &FourBarInputs<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        ::mstmm::generated::assemble(
            state_,
            "rocker_pin",
            |state_| self.correct(state_, inputs_),
        )
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
/// The hinges lie one after the other in the order of the route. A body that floats comes
/// first; a hinge whose motion is prescribed has no place.
///
/// | of | places in `q` | places in `v` |
/// |---|---|---|
/// | `crank_pin` | 0 | 0 |
/// | `a` | 1 | 1 |
/// | `b` | 2 | 2 |
/// | `rocker_pin` | 3 | 3 |
///
/// [`Default`] is every hinge at rest in its zero position.
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
    /// Accelerations `v̇` of all hinges, in the order of `v` of the state.
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
    /// All connection points in the order of the route: the input of the first element, then the
    /// output of every element, which is the input of the next one.
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
            [([0], 0), ([0], 0), ([0], 1), ([0], 0), ([0], 3), ([6], 4)],
        ),
        ::mstmm::generated::Places::new(
            0,
            [6],
            [([0], 0), ([0], 8), ([6], 9), ([0], 11), ([0], 3), ([6], 4)],
        ),
        ::mstmm::generated::Places::new(
            12,
            [6],
            [([16], 14), ([0], 8), ([16], 18), ([0], 11), ([0], 0), ([16], 20)],
        ),
        ::mstmm::generated::Places::new(
            12,
            [16],
            [([16], 14), ([0], 22), ([16], 18), ([0], 23), ([0], 0), ([16], 20)],
        ),
        ::mstmm::generated::Places::new(
            24,
            [16],
            [([28], 26), ([0], 22), ([28], 30), ([0], 23), ([0], 0), ([28], 32)],
        ),
        ::mstmm::generated::Places::new(
            24,
            [28],
            [([28], 26), ([0], 34), ([28], 30), ([0], 35), ([0], 0), ([28], 32)],
        ),
        ::mstmm::generated::Places::new(
            36,
            [28],
            [([28], 38), ([0], 34), ([28], 40), ([0], 35), ([0], 0), ([28], 42)],
        ),
        ::mstmm::generated::Places::new(
            44,
            [0],
            [([0], 0), ([0], 0), ([0], 1), ([0], 0), ([0], 0), ([28], 42)],
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
    /// Results at body `crank`: input, output and centre of mass.
    #[inline]
    pub fn crank(&self) -> ::mstmm::BodyResult<T, ::mstmm::PlanePoint<T>> {
        let (input_, output_) = (self.point_(1), self.point_(2));
        ::mstmm::BodyResult::new(
            input_,
            output_,
            [T::constant(0.1f64), T::constant(0f64)],
        )
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
    /// Results at body `coupler`: input, output and centre of mass.
    #[inline]
    pub fn coupler(&self) -> ::mstmm::BodyResult<T, ::mstmm::PlanePoint<T>> {
        let (input_, output_) = (self.point_(3), self.point_(4));
        ::mstmm::BodyResult::new(
            input_,
            output_,
            [T::constant(0.3f64), T::constant(0f64)],
        )
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
    /// Results at body `rocker`: input, output and centre of mass.
    #[inline]
    pub fn rocker(&self) -> ::mstmm::BodyResult<T, ::mstmm::PlanePoint<T>> {
        let (input_, output_) = (self.point_(5), self.point_(6));
        ::mstmm::BodyResult::new(
            input_,
            output_,
            [T::constant(0.3f64), T::constant(0f64)],
        )
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
