/// Rods on pins with springs, and a weight: the rods are the times of a loop.
///
/// # The chain
///
/// `ground -> repeat 10 { pin joint -> rod } -> pin hook -> weight`
///
/// <svg role="img" aria-label="The chain at its start" viewBox="0 0 532 112" width="532" style="max-width:100%;height:auto" font-size="12" stroke-linecap="round" fill="currentColor">
/// <path d="M22 90l14.0 0.0" stroke="currentColor" opacity="0.6"/><text x="43.0" y="93.0" font-size="10" opacity="0.6" text-anchor="middle">x</text>
/// <path d="M22 90l0.0 -14.0" stroke="currentColor" opacity="0.6"/><text x="22.0" y="72.0" font-size="10" opacity="0.6" text-anchor="middle">y</text>
/// <path d="M36.0 36.0L76.0 36.0" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M36.0 36.0L56.0 36.0L76.0 36.0" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="56.0" cy="36.0" r="3" fill="#3a87c8"/>
/// <path d="M76.0 36.0L116.0 36.0" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M76.0 36.0L96.0 36.0L116.0 36.0" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="96.0" cy="36.0" r="3" fill="#3a87c8"/>
/// <path d="M116.0 36.0L156.0 36.0" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M116.0 36.0L136.0 36.0L156.0 36.0" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="136.0" cy="36.0" r="3" fill="#3a87c8"/>
/// <path d="M156.0 36.0L196.0 36.0" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M156.0 36.0L176.0 36.0L196.0 36.0" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="176.0" cy="36.0" r="3" fill="#3a87c8"/>
/// <path d="M196.0 36.0L236.0 36.0" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M196.0 36.0L216.0 36.0L236.0 36.0" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="216.0" cy="36.0" r="3" fill="#3a87c8"/>
/// <path d="M236.0 36.0L276.0 36.0" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M236.0 36.0L256.0 36.0L276.0 36.0" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="256.0" cy="36.0" r="3" fill="#3a87c8"/>
/// <path d="M276.0 36.0L316.0 36.0" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M276.0 36.0L296.0 36.0L316.0 36.0" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="296.0" cy="36.0" r="3" fill="#3a87c8"/>
/// <path d="M316.0 36.0L356.0 36.0" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M316.0 36.0L336.0 36.0L356.0 36.0" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="336.0" cy="36.0" r="3" fill="#3a87c8"/>
/// <path d="M356.0 36.0L396.0 36.0" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M356.0 36.0L376.0 36.0L396.0 36.0" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="376.0" cy="36.0" r="3" fill="#3a87c8"/>
/// <path d="M396.0 36.0L436.0 36.0" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M396.0 36.0L416.0 36.0L436.0 36.0" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="416.0" cy="36.0" r="3" fill="#3a87c8"/>
/// <path d="M436.0 36.0L436.0 36.0" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M436.0 36.0L436.0 76.0L436.0 36.0" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="436.0" cy="76.0" r="3" fill="#3a87c8"/>
/// <path d="M22.0 45.0h28m-26 7l5 -7m2 7l5 -7m2 7l5 -7" fill="none" stroke="currentColor"/>
/// <circle cx="36.0" cy="36.0" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <circle cx="76.0" cy="36.0" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <circle cx="116.0" cy="36.0" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <circle cx="156.0" cy="36.0" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <circle cx="196.0" cy="36.0" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <circle cx="236.0" cy="36.0" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <circle cx="276.0" cy="36.0" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <circle cx="316.0" cy="36.0" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <circle cx="356.0" cy="36.0" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <circle cx="396.0" cy="36.0" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <circle cx="436.0" cy="36.0" r="5" fill-opacity="0.15" stroke="currentColor" stroke-width="1.5"/>
/// <text x="44.0" y="28.0">joint</text>
/// <text x="56.0" y="56.0" text-anchor="middle" font-style="italic">rod</text>
/// <text x="84.0" y="28.0">joint</text>
/// <text x="96.0" y="56.0" text-anchor="middle" font-style="italic">rod</text>
/// <text x="124.0" y="28.0">joint</text>
/// <text x="136.0" y="56.0" text-anchor="middle" font-style="italic">rod</text>
/// <text x="164.0" y="28.0">joint</text>
/// <text x="176.0" y="56.0" text-anchor="middle" font-style="italic">rod</text>
/// <text x="204.0" y="28.0">joint</text>
/// <text x="216.0" y="56.0" text-anchor="middle" font-style="italic">rod</text>
/// <text x="244.0" y="28.0">joint</text>
/// <text x="256.0" y="56.0" text-anchor="middle" font-style="italic">rod</text>
/// <text x="284.0" y="28.0">joint</text>
/// <text x="296.0" y="56.0" text-anchor="middle" font-style="italic">rod</text>
/// <text x="324.0" y="28.0">joint</text>
/// <text x="336.0" y="56.0" text-anchor="middle" font-style="italic">rod</text>
/// <text x="364.0" y="28.0">joint</text>
/// <text x="376.0" y="56.0" text-anchor="middle" font-style="italic">rod</text>
/// <text x="404.0" y="28.0">joint</text>
/// <text x="416.0" y="56.0" text-anchor="middle" font-style="italic">rod</text>
/// <text x="444.0" y="28.0">hook</text>
/// <text x="436.0" y="56.0" text-anchor="middle" font-style="italic">weight</text>
/// <path d="M502.0 22.0l0.0 28.0m-3.5 -6.1l3.5 6.1l3.5 -6.1" fill="none" stroke="currentColor" stroke-width="1.5"/><text x="515.0" y="40.0" font-style="italic" text-anchor="middle">g</text>
/// </svg>
///
/// | element | what it is | freedoms |
/// |---|---|---|
/// | `joint` | pin(z) | 1 |
/// | `rod` | body `Rod` |  |
/// | `hook` | pin(z) | 1 |
/// | `weight` | body `Weight`, 2 kg |  |
///
/// Mobility 11: 11 degrees of freedom.
///
/// Accelerations by `riccati`, 102 operations (58 mul, 43 add, 1 reciprocal, 2 sin/cos); with everything at every connection point 204 operations; those of repeated parts are counted once.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct Rope<T> {
    changed_by_setters: ::mstmm::generated::Sealed<RopeParameters<T>, ([T; 0], [T; 70])>,
}
/// Numbers of [`Rope`] that may change at run time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct RopeParameters<T> {
    knot: [T; 10],
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> RopeParameters<T> {
    /// `knot` in kg.
    #[inline]
    pub fn knot(&self) -> &[T; 10] {
        &self.knot
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> Rope<T> {
    /// The chain as described, its parameters at their defaults.
    #[inline]
    #[must_use]
    #[allow(clippy::all)]
    pub fn new() -> Self {
        let parameters_ = RopeParameters {
            knot: [T::constant(0f64); 10],
        };
        let (chain_, _) = Self::derive(::mstmm::generated::Sealed::new(parameters_));
        chain_
    }
    /// The values that may change at run time. Each has a setter.
    #[inline]
    pub fn parameters(&self) -> &RopeParameters<T> {
        self.changed_by_setters.parameters()
    }
    /// Sets `knot` in kg.
    ///
    /// One number for each of 10 times, from `value` by index.
    ///
    /// # Errors
    ///
    /// `Error::Parameter` if the number is not finite or would
    /// leave the chain with a mass that is not positive, a stiffness or damping that is negative
    /// or a quantity that is not finite; the old one is kept then.
    #[allow(unused_variables, clippy::all)]
    pub fn set_knot(
        &mut self,
        mut value_: impl ::core::ops::FnMut(::core::primitive::usize) -> T,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let mut parameters_ = *self.parameters();
        for (index_, place_) in ::core::iter::zip(0.., &mut parameters_.knot) {
            *place_ = value_(index_);
        }
        let values_ = &parameters_.knot;
        let sealed_ = ::mstmm::generated::Sealed::new(parameters_);
        let (chain_, checks_) = Self::derive(sealed_);
        ::mstmm::generated::check_parameter(
            "knot",
            values_,
            &[
                &chain_.changed_by_setters.derived().0,
                &chain_.changed_by_setters.derived().1,
            ],
        )?;
        for numbers_ in ::mstmm::generated::times::<T, 1>(checks_.as_slice(), 0, 10) {
            ::mstmm::generated::check_numbers(
                "knot",
                numbers_,
                &[(true, "must leave the mass of body `rod` positive")],
            )?;
        }
        *self = chain_;
        ::core::result::Result::Ok(())
    }
    /// The state that the description starts from, at time zero.
    #[must_use]
    #[allow(unused_doc_comments, clippy::all)]
    pub fn initial_state(&self) -> RopeState<T> {
        let c_ = T::constant;
        let mut results0_ = [T::constant(0.0); 11];
        let mut results1_ = [T::constant(0.0); 11];
        for [o0_] in ::mstmm::generated::times_mut::<
            T,
            1,
        >(results0_.as_mut_slice(), 0, 10) {
            *o0_ = c_(0.0);
        }
        for [o0_] in ::mstmm::generated::times_mut::<
            T,
            1,
        >(results0_.as_mut_slice(), 10, 1) {
            *o0_ = c_(0.0);
        }
        for [o0_] in ::mstmm::generated::times_mut::<
            T,
            1,
        >(results1_.as_mut_slice(), 0, 10) {
            *o0_ = c_(0.0);
        }
        for [o0_] in ::mstmm::generated::times_mut::<
            T,
            1,
        >(results1_.as_mut_slice(), 10, 1) {
            *o0_ = c_(0.0);
        }
        RopeState {
            q: ::mstmm::generated::vector(results0_),
            v: ::mstmm::generated::vector(results1_),
            t: T::constant(0.0),
        }
    }
    /// Quantities derived from parameters and constants: 3 mul, 3 add, 0 reciprocal.
    #[allow(unused_doc_comments, unused_variables, unused_mut, clippy::all)]
    fn derive(
        sealed_: ::mstmm::generated::Sealed<RopeParameters<T>>,
    ) -> (Self, [T; 10]) {
        let parameters_ = sealed_.parameters();
        let c_ = T::constant;
        let mut results1_ = [T::constant(0.0); 10];
        let mut results2_ = [T::constant(0.0); 70];
        for ((&knot_, [o1_0_]), [o2_0_, o2_1_, o2_2_, o2_3_, o2_4_, o2_5_, o2_6_]) in ::core::iter::zip(
            ::core::iter::zip(
                parameters_.knot.iter(),
                ::mstmm::generated::times_mut::<T, 1>(results1_.as_mut_slice(), 0, 10)
                    .iter_mut(),
            ),
            ::mstmm::generated::times_mut::<T, 7>(results2_.as_mut_slice(), 0, 10)
                .iter_mut(),
        ) {
            /// Quantities derived from parameters and constants: 3 mul, 3 add, 0 reciprocal.
            let rod_mass_ = knot_ + c_(0.1);
            let rod_first_moment_x_ = rod_mass_ * c_(0.05);
            let rod_inertia_yy_ = rod_mass_ * c_(0.0025000000000000005);
            let rod_inertia_zz_ = rod_inertia_yy_ + c_(0.0001);
            let joint_riccati_p1_ = rod_inertia_yy_ + rod_inertia_zz_;
            let result_p1_ = c_(0.5) * rod_mass_;
            *o1_0_ = rod_mass_;
            *o2_0_ = rod_mass_;
            *o2_1_ = rod_first_moment_x_;
            *o2_2_ = rod_inertia_yy_;
            *o2_3_ = rod_inertia_zz_;
            *o2_4_ = knot_;
            *o2_5_ = joint_riccati_p1_;
            *o2_6_ = result_p1_;
            () = ();
        }
        let (derived_, checks_) = ([], results1_);
        (
            Self {
                changed_by_setters: sealed_.with((derived_, results2_)),
            },
            checks_,
        )
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for Rope<T> {
    fn default() -> Self {
        Self::new()
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> Rope<T> {
    /// The accelerations of a linearly implicit step of Euler's method.
    ///
    /// 116 operations: 61 mul, 54 add, 1 reciprocal, 2 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `hook` | \[P, Eqs. (1), (13), (36)\] | 2 | 1 | 0 | 0 | 1 |
    /// | Riccati transfer over `joint` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 37 | 36 | 1 | 0 | 0 |
    /// | Riccati transfer over `end_of_repeat0` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 3 | 6 | 0 | 0 | 0 |
    /// | Results |  | 4 | 2 | 0 | 0 | 0 |
    /// | Motion across `joint` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 1 |
    /// | Motion across `end_of_repeat0` | \[P, Eqs. (1), (13), (36)\] | 3 | 0 | 0 | 0 | 0 |
    /// | Riccati transfer over `hook` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 4 | 0 | 0 | 0 | 0 |
    /// | Acceleration of `joint` | \[P, Eqs. (13), (36), (44)\] | 7 | 6 | 0 | 0 | 0 |
    /// | Acceleration of `end_of_repeat0` | \[P, Eqs. (13), (36), (44)\] | 1 | 2 | 0 | 0 | 0 |
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn implicit_accelerations_into(
        &self,
        state_: &RopeState<T>,
        inputs_: &RopeInputs<T>,
        step_: T,
        accelerations_: &mut ::mstmm::nalgebra::SVector<T, 11>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        ::mstmm::generated::all_finite::<T>(state_.v.as_slice())?;
        let c_ = T::constant;
        let [hook_angle_] = ::mstmm::generated::piece::<T, 1>(state_.q.as_slice(), 10);
        let [hook_rate_] = ::mstmm::generated::piece::<T, 1>(state_.v.as_slice(), 10);
        let mut results0_ = [T::constant(0.0); 11];
        let mut regular0_ = <T::Mask as ::mstmm::Mask>::splat(true);
        let mut store1_ = ::mstmm::generated::Stored::<[T; 6], 10>::new_const();
        let mut store3_ = ::mstmm::generated::Stored::<[T; 4], 10>::new_const();
        /// Motion across `hook`, [P, Eqs. (1), (13), (36)]: 2 mul, 0 add, 0 reciprocal, 1 sin/cos.
        let ([sin_hook_angle_], [cos_hook_angle_]) = T::sin_cos([hook_angle_]);
        let t2_ = sin_hook_angle_ * sin_hook_angle_;
        /// Riccati transfer over `joint`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 1 add, 0 reciprocal.
        let t0_ = T::mul_add(step_, c_(0.2), c_(0.01));
        /// Motion across `hook`.
        let t3_ = sin_hook_angle_ * cos_hook_angle_;
        /// Riccati transfer over `end_of_repeat0`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 2 add, 0 reciprocal.
        let t4_ = t2_ * c_(1.3333333333333335);
        /// Riccati transfer over `joint`.
        let t1_ = step_ * t0_;
        /// Results: 2 mul, 0 add, 0 reciprocal.
        let t8_ = cos_hook_angle_ * c_(6.666666666666666);
        let t9_ = sin_hook_angle_ * c_(6.666666666666666);
        /// Riccati transfer over `end_of_repeat0`.
        let t6_ = t3_ * c_(1.3333333333333335);
        let t5_ = t4_ - c_(2.0);
        let t7_ = t4_ + c_(0.6666666666666665);
        let mut carry0_0_ = c_(0.0);
        for (
            (&[joint_angle_], &[joint_rate_]),
            &[known_rod_mass_,
            known_rod_first_moment_x_,
            known_rod_inertia_yy_,
            known_rod_inertia_zz_,
            known_knot_,
            known_joint_riccati_p1_,
            _,
            ],
        ) in ::core::iter::zip(
            ::core::iter::zip(
                ::mstmm::generated::times::<T, 1>(state_.q.as_slice(), 0, 10).iter(),
                ::mstmm::generated::times::<T, 1>(state_.v.as_slice(), 0, 10).iter(),
            ),
            ::mstmm::generated::times::<
                T,
                7,
            >(self.changed_by_setters.derived().1.as_slice(), 0, 10)
                .iter(),
        ) {
            let carry0_0_before_ = carry0_0_;
            /// Motion across `joint`, [P, Eqs. (1), (13), (36)]: 0 mul, 1 add, 0 reciprocal, 1 sin/cos.
            let ([sin_joint_angle_], [cos_joint_angle_]) = T::sin_cos([joint_angle_]);
            let joint_omega_z_ = joint_rate_ + carry0_0_before_;
            /// Motion across `end_of_repeat0`, [P, Eqs. (1), (13), (36)]: 3 mul, 0 add, 0 reciprocal.
            let t10_ = joint_omega_z_ * joint_omega_z_;
            let minus_end_of_repeat0_centripetal_x_ = c_(0.1) * t10_;
            let t14_ = known_rod_first_moment_x_ * t10_;
            /// Riccati transfer over `joint`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 2 add, 0 reciprocal.
            let t11_ = joint_angle_ * c_(0.2);
            let t12_ = T::mul_add(joint_rate_, t0_, t11_);
            let t13_ = known_joint_riccati_p1_ + t1_;
            _ = store1_
                .try_push([
                    sin_joint_angle_,
                    cos_joint_angle_,
                    minus_end_of_repeat0_centripetal_x_,
                    t14_,
                    t12_,
                    t13_,
                ]);
            (carry0_0_,) = (joint_omega_z_,);
        }
        /// Motion across `hook`, [P, Eqs. (1), (13), (36)]: 0 mul, 1 add, 0 reciprocal.
        let hook_omega_z_ = hook_rate_ + carry0_0_;
        /// Riccati transfer over `hook`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 4 mul, 0 add, 0 reciprocal.
        let t15_ = hook_omega_z_ * hook_omega_z_;
        let hook_bias_fy_ = c_(0.2) * t15_;
        let t16_ = sin_hook_angle_ * hook_bias_fy_;
        let t17_ = cos_hook_angle_ * hook_bias_fy_;
        let mut carry1_0_ = t7_;
        let mut carry1_1_ = -t5_;
        let mut carry1_2_ = c_(2.0);
        let mut carry1_3_ = -t6_;
        let mut carry1_4_ = c_(0.0);
        let mut carry1_5_ = c_(0.0);
        let mut carry1_6_ = c_(0.0);
        let mut carry1_7_ = -t16_;
        let mut carry1_8_ = t17_;
        let mut carry1_9_ = c_(0.0);
        for (
            &[known_rod_mass_,
            known_rod_first_moment_x_,
            _,
            known_rod_inertia_zz_,
            _,
            _,
            _,
            ],
            &[sin_joint_angle_,
            cos_joint_angle_,
            minus_end_of_repeat0_centripetal_x_,
            t14_,
            t12_,
            t13_,
            ],
        ) in ::core::iter::Iterator::rev(
            ::core::iter::zip(
                ::mstmm::generated::times::<
                    T,
                    7,
                >(self.changed_by_setters.derived().1.as_slice(), 0, 10)
                    .iter(),
                store1_.iter(),
            ),
        ) {
            let carry1_0_before_ = carry1_0_;
            let carry1_1_before_ = carry1_1_;
            let carry1_2_before_ = carry1_2_;
            let carry1_3_before_ = carry1_3_;
            let carry1_4_before_ = carry1_4_;
            let carry1_5_before_ = carry1_5_;
            let carry1_6_before_ = carry1_6_;
            let carry1_7_before_ = carry1_7_;
            let carry1_8_before_ = carry1_8_;
            let carry1_9_before_ = carry1_9_;
            /// Riccati transfer over `end_of_repeat0`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 1 mul, 4 add, 0 reciprocal.
            let t25_ = known_rod_mass_ + carry1_0_before_;
            let t26_ = known_rod_mass_ + carry1_1_before_;
            let t33_ = t14_ - carry1_7_before_;
            let t34_ = T::mul_add(
                carry1_0_before_,
                minus_end_of_repeat0_centripetal_x_,
                t33_,
            );
            /// Riccati transfer over `joint`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 33 mul, 33 add, 1 reciprocal.
            let joint_articulated_mass_zz_ = known_rod_mass_ + carry1_2_before_;
            let joint_articulated_coupling_xz_ = T::mul_add(
                c_(0.1),
                carry1_3_before_,
                carry1_4_before_,
            );
            let t18_ = T::mul_add(c_(0.1), carry1_1_before_, carry1_5_before_);
            let joint_articulated_coupling_yz_ = known_rod_first_moment_x_ + t18_;
            let t19_ = carry1_5_before_ + t18_;
            let t20_ = known_rod_inertia_zz_ + carry1_6_before_;
            let joint_articulated_inertia_zz_ = T::mul_add(c_(0.1), t19_, t20_);
            let joint_bias_fy_ = T::mul_neg_add(
                carry1_3_before_,
                minus_end_of_repeat0_centripetal_x_,
                carry1_8_before_,
            );
            let t21_ = T::mul_neg_add(
                carry1_4_before_,
                minus_end_of_repeat0_centripetal_x_,
                carry1_9_before_,
            );
            let joint_bias_mz_ = T::mul_add(c_(0.1), joint_bias_fy_, t21_);
            let joint_d_ = t1_ + joint_articulated_inertia_zz_;
            let joint_d_inverse_ = T::recip(joint_d_);
            let t22_ = carry1_0_before_ + carry1_1_before_;
            let t23_ = carry1_2_before_ + t22_;
            let joint_d_scale_ = T::mul_add(c_(0.010000000000000002), t23_, t13_);
            let joint_gain_fx_ = joint_articulated_coupling_xz_ * joint_d_inverse_;
            let joint_gain_fy_ = joint_articulated_coupling_yz_ * joint_d_inverse_;
            let joint_gain_mz_ = joint_articulated_inertia_zz_ * joint_d_inverse_;
            let t24_ = joint_bias_mz_ + t12_;
            let minus_joint_rest_ = joint_d_inverse_ * t24_;
            let t27_ = T::mul_neg_add(
                joint_articulated_coupling_xz_,
                joint_gain_fx_,
                t25_,
            );
            let t28_ = T::mul_neg_add(
                joint_articulated_coupling_yz_,
                joint_gain_fy_,
                t26_,
            );
            let t29_ = T::mul_neg_add(
                joint_articulated_coupling_yz_,
                joint_gain_fx_,
                carry1_3_before_,
            );
            let t30_ = T::mul_neg_add(
                joint_articulated_inertia_zz_,
                joint_gain_fx_,
                joint_articulated_coupling_xz_,
            );
            let t31_ = T::mul_neg_add(
                joint_articulated_inertia_zz_,
                joint_gain_fy_,
                joint_articulated_coupling_yz_,
            );
            let t32_ = T::mul_neg_add(
                joint_articulated_inertia_zz_,
                joint_gain_mz_,
                joint_articulated_inertia_zz_,
            );
            let t35_ = T::mul_add(
                joint_articulated_coupling_xz_,
                minus_joint_rest_,
                t34_,
            );
            let t36_ = T::mul_neg_add(
                joint_articulated_coupling_yz_,
                minus_joint_rest_,
                joint_bias_fy_,
            );
            let t37_ = T::mul_neg_add(
                joint_articulated_inertia_zz_,
                minus_joint_rest_,
                joint_bias_mz_,
            );
            let t38_ = cos_joint_angle_ * t35_;
            let t39_ = T::mul_add(sin_joint_angle_, t36_, t38_);
            let t40_ = sin_joint_angle_ * t35_;
            let t41_ = T::mul_neg_add(cos_joint_angle_, t36_, t40_);
            let t42_ = t27_ - t28_;
            let t43_ = sin_joint_angle_ * t42_;
            let t44_ = c_(2.0) * t29_;
            let t45_ = T::mul_add(cos_joint_angle_, t44_, t43_);
            let t46_ = sin_joint_angle_ * t45_;
            let t47_ = t27_ - t46_;
            let t48_ = T::mul_neg_add(cos_joint_angle_, t45_, t29_);
            let t49_ = t28_ + t46_;
            let t50_ = cos_joint_angle_ * t30_;
            let t51_ = T::mul_neg_add(sin_joint_angle_, t31_, t50_);
            let t52_ = sin_joint_angle_ * t30_;
            let t53_ = T::mul_add(cos_joint_angle_, t31_, t52_);
            _ = store3_
                .try_push([
                    minus_joint_rest_,
                    joint_gain_fx_,
                    joint_gain_fy_,
                    joint_gain_mz_,
                ]);
            regular0_ = regular0_
                & !::mstmm::generated::vanishes(joint_d_, joint_d_scale_);
            (
                carry1_0_,
                carry1_1_,
                carry1_2_,
                carry1_3_,
                carry1_4_,
                carry1_5_,
                carry1_6_,
                carry1_7_,
                carry1_8_,
                carry1_9_,
            ) = (
                t47_,
                t49_,
                joint_articulated_mass_zz_,
                -t48_,
                t51_,
                t53_,
                t32_,
                -t39_,
                -t41_,
                t37_,
            );
        }
        let mut carry2_0_ = c_(0.0);
        let mut carry2_1_ = c_(9.8);
        let mut carry2_2_ = c_(0.0);
        for (
            (
                &[sin_joint_angle_,
                cos_joint_angle_,
                minus_end_of_repeat0_centripetal_x_,
                _,
                _,
                _,
                ],
                &[minus_joint_rest_,
                joint_gain_fx_,
                joint_gain_fy_,
                joint_gain_mz_,
                ],
            ),
            [o0_0_,
            ],
        ) in ::core::iter::zip(
            ::core::iter::zip(
                store1_.iter(),
                ::core::iter::Iterator::rev(store3_.iter()),
            ),
            ::mstmm::generated::times_mut::<T, 1>(results0_.as_mut_slice(), 0, 10)
                .iter_mut(),
        ) {
            let carry2_0_before_ = carry2_0_;
            let carry2_1_before_ = carry2_1_;
            let carry2_2_before_ = carry2_2_;
            /// Acceleration of `joint`, [P, Eqs. (13), (36), (44)]: 7 mul, 6 add, 0 reciprocal.
            let t54_ = cos_joint_angle_ * carry2_0_before_;
            let joint_a_lin_x_ = T::mul_add(sin_joint_angle_, carry2_1_before_, t54_);
            let t55_ = sin_joint_angle_ * carry2_0_before_;
            let minus_joint_a_lin_y_ = T::mul_neg_add(
                cos_joint_angle_,
                carry2_1_before_,
                t55_,
            );
            let t56_ = T::mul_add(carry2_2_before_, joint_gain_mz_, minus_joint_rest_);
            let t57_ = T::mul_sub(minus_joint_a_lin_y_, joint_gain_fy_, t56_);
            let t58_ = T::mul_sub(joint_a_lin_x_, joint_gain_fx_, t57_);
            let joint_a_ang_z_ = carry2_2_before_ - t58_;
            /// Acceleration of `end_of_repeat0`, [P, Eqs. (13), (36), (44)]: 1 mul, 2 add, 0 reciprocal.
            let minus_end_of_repeat0_a_lin_x_ = minus_end_of_repeat0_centripetal_x_
                - joint_a_lin_x_;
            let minus_end_of_repeat0_a_lin_y_ = T::mul_neg_add(
                c_(0.1),
                joint_a_ang_z_,
                minus_joint_a_lin_y_,
            );
            *o0_0_ = -t58_;
            (carry2_0_, carry2_1_, carry2_2_) = (
                -minus_end_of_repeat0_a_lin_x_,
                -minus_end_of_repeat0_a_lin_y_,
                joint_a_ang_z_,
            );
        }
        /// Results: 2 mul, 2 add, 0 reciprocal.
        let t59_ = T::mul_add(t9_, carry2_1_, carry2_2_);
        let t60_ = T::mul_add(t8_, carry2_0_, t59_);
        for [o0_] in ::mstmm::generated::times_mut::<
            T,
            1,
        >(results0_.as_mut_slice(), 10, 1) {
            *o0_ = -t60_;
        }
        ::mstmm::generated::require(regular0_, "joint")?;
        if !::mstmm::generated::regular::<T, _, _>([], [], [state_.t]) {
            return ::core::result::Result::Err(
                ::mstmm::generated::irregular::<T, _>(&[], [], []),
            );
        }
        ::mstmm::generated::all_finite::<T>(results0_.as_slice())?;
        accelerations_.data.0 = [results0_];
        ::core::result::Result::Ok(())
    }
    /// The accelerations `v̇` of all hinges, in the order of `v` of the state: the fast path.
    ///
    /// 102 operations: 58 mul, 43 add, 1 reciprocal, 2 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `hook` | \[P, Eqs. (1), (13), (36)\] | 2 | 1 | 0 | 0 | 1 |
    /// | Riccati transfer over `end_of_repeat0` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 3 | 6 | 0 | 0 | 0 |
    /// | Results |  | 4 | 2 | 0 | 0 | 0 |
    /// | Motion across `joint` | \[P, Eqs. (1), (13), (36)\] | 4 | 2 | 0 | 0 | 1 |
    /// | Motion across `end_of_repeat0` | \[P, Eqs. (1), (13), (36)\] | 3 | 0 | 0 | 0 | 0 |
    /// | Riccati transfer over `joint` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 27 | 23 | 1 | 0 | 0 |
    /// | Riccati transfer over `hook` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 4 | 0 | 0 | 0 | 0 |
    /// | Acceleration of `joint` | \[P, Eqs. (13), (36), (44)\] | 6 | 5 | 0 | 0 | 0 |
    /// | Acceleration of `end_of_repeat0` | \[P, Eqs. (13), (36), (44)\] | 5 | 4 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// `Error::Singular` if no inertia is left beyond a
    /// hinge, `Error::NotFinite` if a number of the state or the
    /// inputs is not finite. `accelerations` is not touched then.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn accelerations_into(
        &self,
        state_: &RopeState<T>,
        inputs_: &RopeInputs<T>,
        accelerations_: &mut ::mstmm::nalgebra::SVector<T, 11>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        ::mstmm::generated::all_finite::<T>(state_.v.as_slice())?;
        let c_ = T::constant;
        let [hook_angle_] = ::mstmm::generated::piece::<T, 1>(state_.q.as_slice(), 10);
        let [hook_rate_] = ::mstmm::generated::piece::<T, 1>(state_.v.as_slice(), 10);
        let mut results0_ = [T::constant(0.0); 11];
        let mut regular0_ = <T::Mask as ::mstmm::Mask>::splat(true);
        let mut store1_ = ::mstmm::generated::Stored::<[T; 9], 10>::new_const();
        let mut store3_ = ::mstmm::generated::Stored::<[T; 3], 10>::new_const();
        /// Motion across `hook`, [P, Eqs. (1), (13), (36)]: 2 mul, 0 add, 0 reciprocal, 1 sin/cos.
        let ([sin_hook_angle_], [cos_hook_angle_]) = T::sin_cos([hook_angle_]);
        let t0_ = sin_hook_angle_ * sin_hook_angle_;
        let t1_ = sin_hook_angle_ * cos_hook_angle_;
        /// Riccati transfer over `end_of_repeat0`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 2 add, 0 reciprocal.
        let t2_ = t0_ * c_(1.3333333333333335);
        /// Results: 2 mul, 0 add, 0 reciprocal.
        let t6_ = cos_hook_angle_ * c_(6.666666666666666);
        let t7_ = sin_hook_angle_ * c_(6.666666666666666);
        /// Riccati transfer over `end_of_repeat0`.
        let t4_ = t1_ * c_(1.3333333333333335);
        let t3_ = t2_ - c_(2.0);
        let t5_ = t2_ + c_(0.6666666666666665);
        let mut carry0_0_ = c_(0.0);
        for (
            (&[joint_angle_], &[joint_rate_]),
            &[known_rod_mass_,
            known_rod_first_moment_x_,
            known_rod_inertia_yy_,
            known_rod_inertia_zz_,
            known_knot_,
            known_joint_riccati_p1_,
            _,
            ],
        ) in ::core::iter::zip(
            ::core::iter::zip(
                ::mstmm::generated::times::<T, 1>(state_.q.as_slice(), 0, 10).iter(),
                ::mstmm::generated::times::<T, 1>(state_.v.as_slice(), 0, 10).iter(),
            ),
            ::mstmm::generated::times::<
                T,
                7,
            >(self.changed_by_setters.derived().1.as_slice(), 0, 10)
                .iter(),
        ) {
            let carry0_0_before_ = carry0_0_;
            /// Motion across `joint`, [P, Eqs. (1), (13), (36)]: 4 mul, 2 add, 0 reciprocal, 1 sin/cos.
            let ([sin_joint_angle_], [cos_joint_angle_]) = T::sin_cos([joint_angle_]);
            let joint_omega_z_ = joint_rate_ + carry0_0_before_;
            let t11_ = sin_joint_angle_ * sin_joint_angle_;
            let t12_ = sin_joint_angle_ * cos_joint_angle_;
            let t13_ = c_(2.0) * t12_;
            let t14_ = T::mul_neg_add(c_(2.0), t11_, c_(1.0));
            /// Motion across `end_of_repeat0`, [P, Eqs. (1), (13), (36)]: 3 mul, 0 add, 0 reciprocal.
            let t8_ = joint_omega_z_ * joint_omega_z_;
            let minus_end_of_repeat0_centripetal_x_ = c_(0.1) * t8_;
            let t15_ = known_rod_first_moment_x_ * t8_;
            /// Riccati transfer over `joint`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 1 add, 0 reciprocal.
            let t9_ = joint_angle_ * c_(0.2);
            let t10_ = T::mul_add(joint_rate_, c_(0.01), t9_);
            _ = store1_
                .try_push([
                    sin_joint_angle_,
                    cos_joint_angle_,
                    t10_,
                    t11_,
                    t12_,
                    t13_,
                    t14_,
                    minus_end_of_repeat0_centripetal_x_,
                    t15_,
                ]);
            (carry0_0_,) = (joint_omega_z_,);
        }
        /// Motion across `hook`, [P, Eqs. (1), (13), (36)]: 0 mul, 1 add, 0 reciprocal.
        let hook_omega_z_ = hook_rate_ + carry0_0_;
        /// Riccati transfer over `hook`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 4 mul, 0 add, 0 reciprocal.
        let t16_ = hook_omega_z_ * hook_omega_z_;
        let hook_bias_fy_ = c_(0.2) * t16_;
        let t17_ = sin_hook_angle_ * hook_bias_fy_;
        let t18_ = cos_hook_angle_ * hook_bias_fy_;
        let mut carry1_0_ = t5_;
        let mut carry1_1_ = -t3_;
        let mut carry1_2_ = c_(2.0);
        let mut carry1_3_ = -t4_;
        let mut carry1_4_ = -t17_;
        let mut carry1_5_ = t18_;
        let mut carry1_6_ = c_(0.0);
        for (
            &[known_rod_mass_,
            known_rod_first_moment_x_,
            _,
            known_rod_inertia_zz_,
            _,
            known_joint_riccati_p1_,
            _,
            ],
            &[sin_joint_angle_,
            cos_joint_angle_,
            t10_,
            t11_,
            t12_,
            t13_,
            t14_,
            minus_end_of_repeat0_centripetal_x_,
            t15_,
            ],
        ) in ::core::iter::Iterator::rev(
            ::core::iter::zip(
                ::mstmm::generated::times::<
                    T,
                    7,
                >(self.changed_by_setters.derived().1.as_slice(), 0, 10)
                    .iter(),
                store1_.iter(),
            ),
        ) {
            let carry1_0_before_ = carry1_0_;
            let carry1_1_before_ = carry1_1_;
            let carry1_2_before_ = carry1_2_;
            let carry1_3_before_ = carry1_3_;
            let carry1_4_before_ = carry1_4_;
            let carry1_5_before_ = carry1_5_;
            let carry1_6_before_ = carry1_6_;
            /// Riccati transfer over `end_of_repeat0`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 1 mul, 4 add, 0 reciprocal.
            let t27_ = known_rod_mass_ + carry1_0_before_;
            let t28_ = known_rod_mass_ + carry1_1_before_;
            let t39_ = t15_ - carry1_4_before_;
            let t40_ = T::mul_add(
                carry1_0_before_,
                minus_end_of_repeat0_centripetal_x_,
                t39_,
            );
            /// Riccati transfer over `joint`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 25 mul, 22 add, 1 reciprocal.
            let joint_articulated_mass_zz_ = known_rod_mass_ + carry1_2_before_;
            let joint_articulated_coupling_xz_ = c_(0.1) * carry1_3_before_;
            let joint_articulated_coupling_yz_ = T::mul_add(
                c_(0.1),
                carry1_1_before_,
                known_rod_first_moment_x_,
            );
            let joint_articulated_inertia_zz_ = T::mul_add(
                carry1_1_before_,
                c_(0.010000000000000002),
                known_rod_inertia_zz_,
            );
            let joint_bias_fy_ = T::mul_neg_add(
                carry1_3_before_,
                minus_end_of_repeat0_centripetal_x_,
                carry1_5_before_,
            );
            let joint_d_inverse_ = T::recip(joint_articulated_inertia_zz_);
            let t19_ = carry1_0_before_ + carry1_1_before_;
            let t20_ = carry1_2_before_ + t19_;
            let joint_d_scale_ = T::mul_add(
                c_(0.010000000000000002),
                t20_,
                known_joint_riccati_p1_,
            );
            let joint_gain_fx_ = joint_articulated_coupling_xz_ * joint_d_inverse_;
            let joint_gain_fy_ = joint_articulated_coupling_yz_ * joint_d_inverse_;
            let t21_ = t10_ + carry1_6_before_;
            let t22_ = T::mul_add(c_(0.1), joint_bias_fy_, t21_);
            let minus_joint_rest_ = joint_d_inverse_ * t22_;
            let t29_ = joint_articulated_coupling_xz_ * joint_articulated_coupling_xz_;
            let t30_ = T::mul_neg_add(joint_d_inverse_, t29_, t27_);
            let t31_ = joint_articulated_coupling_yz_ * joint_articulated_coupling_yz_;
            let t32_ = T::mul_neg_add(joint_d_inverse_, t31_, t28_);
            let t33_ = joint_articulated_coupling_xz_ * joint_articulated_coupling_yz_;
            let t34_ = T::mul_neg_add(joint_d_inverse_, t33_, carry1_3_before_);
            let t35_ = t30_ + t32_;
            let t36_ = t30_ - t32_;
            let t37_ = t14_ * t34_;
            let t38_ = T::mul_add(t12_, t36_, t37_);
            let t41_ = T::mul_add(
                joint_articulated_coupling_xz_,
                minus_joint_rest_,
                t40_,
            );
            let t42_ = T::mul_neg_add(
                joint_articulated_coupling_yz_,
                minus_joint_rest_,
                joint_bias_fy_,
            );
            let t43_ = cos_joint_angle_ * t41_;
            let t44_ = T::mul_add(sin_joint_angle_, t42_, t43_);
            let t45_ = sin_joint_angle_ * t41_;
            let t46_ = T::mul_neg_add(cos_joint_angle_, t42_, t45_);
            let t47_ = T::mul_add(t13_, t34_, t32_);
            let t48_ = T::mul_add(t11_, t36_, t47_);
            let t49_ = t35_ - t48_;
            /// Acceleration of `joint`, [P, Eqs. (13), (36), (44)]: 4 mul, 2 add, 0 reciprocal.
            let t23_ = cos_joint_angle_ * joint_gain_fx_;
            let t24_ = T::mul_neg_add(sin_joint_angle_, joint_gain_fy_, t23_);
            let t25_ = sin_joint_angle_ * joint_gain_fx_;
            let t26_ = T::mul_add(cos_joint_angle_, joint_gain_fy_, t25_);
            _ = store3_.try_push([t24_, t26_, minus_joint_rest_]);
            regular0_ = regular0_
                & !::mstmm::generated::vanishes(
                    joint_articulated_inertia_zz_,
                    joint_d_scale_,
                );
            (
                carry1_0_,
                carry1_1_,
                carry1_2_,
                carry1_3_,
                carry1_4_,
                carry1_5_,
                carry1_6_,
            ) = (t49_, t48_, joint_articulated_mass_zz_, t38_, -t44_, -t46_, -t10_);
        }
        let mut carry2_0_ = c_(0.0);
        let mut carry2_1_ = c_(9.8);
        let mut carry2_2_ = c_(0.0);
        for (
            (
                &[sin_joint_angle_,
                cos_joint_angle_,
                _,
                _,
                _,
                _,
                _,
                minus_end_of_repeat0_centripetal_x_,
                _,
                ],
                &[t24_,
                t26_,
                minus_joint_rest_,
                ],
            ),
            [o0_0_,
            ],
        ) in ::core::iter::zip(
            ::core::iter::zip(
                store1_.iter(),
                ::core::iter::Iterator::rev(store3_.iter()),
            ),
            ::mstmm::generated::times_mut::<T, 1>(results0_.as_mut_slice(), 0, 10)
                .iter_mut(),
        ) {
            let carry2_0_before_ = carry2_0_;
            let carry2_1_before_ = carry2_1_;
            let carry2_2_before_ = carry2_2_;
            /// Acceleration of `joint`, [P, Eqs. (13), (36), (44)]: 2 mul, 3 add, 0 reciprocal.
            let t50_ = T::mul_add(carry2_1_before_, t26_, minus_joint_rest_);
            let minus_joint_a_ang_z_ = T::mul_add(carry2_0_before_, t24_, t50_);
            let t54_ = carry2_2_before_ + minus_joint_a_ang_z_;
            /// Acceleration of `end_of_repeat0`, [P, Eqs. (13), (36), (44)]: 5 mul, 4 add, 0 reciprocal.
            let t51_ = T::mul_neg_add(
                sin_joint_angle_,
                carry2_1_before_,
                minus_end_of_repeat0_centripetal_x_,
            );
            let end_of_repeat0_a_lin_x_ = T::mul_sub(
                cos_joint_angle_,
                carry2_0_before_,
                t51_,
            );
            let t52_ = sin_joint_angle_ * carry2_0_before_;
            let t53_ = T::mul_neg_add(cos_joint_angle_, carry2_1_before_, t52_);
            let minus_end_of_repeat0_a_lin_y_ = T::mul_add(
                c_(0.1),
                minus_joint_a_ang_z_,
                t53_,
            );
            *o0_0_ = -t54_;
            (carry2_0_, carry2_1_, carry2_2_) = (
                end_of_repeat0_a_lin_x_,
                -minus_end_of_repeat0_a_lin_y_,
                -minus_joint_a_ang_z_,
            );
        }
        /// Results: 2 mul, 2 add, 0 reciprocal.
        let t55_ = T::mul_add(t7_, carry2_1_, carry2_2_);
        let t56_ = T::mul_add(t6_, carry2_0_, t55_);
        for [o0_] in ::mstmm::generated::times_mut::<
            T,
            1,
        >(results0_.as_mut_slice(), 10, 1) {
            *o0_ = -t56_;
        }
        ::mstmm::generated::require(regular0_, "joint")?;
        if !::mstmm::generated::regular::<T, _, _>([], [], [state_.t]) {
            return ::core::result::Result::Err(
                ::mstmm::generated::irregular::<T, _>(&[], [], []),
            );
        }
        ::mstmm::generated::all_finite::<T>(results0_.as_slice())?;
        accelerations_.data.0 = [results0_];
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
        state_: &RopeState<T>,
        inputs_: &RopeInputs<T>,
    ) -> ::core::result::Result<::mstmm::nalgebra::SVector<T, 11>, ::mstmm::Error> {
        let mut accelerations_ = ::mstmm::generated::vector([T::constant(0.0); 11]);
        self.accelerations_into(state_, inputs_, &mut accelerations_)?;
        ::core::result::Result::Ok(accelerations_)
    }
    /// Writes into `at`: accelerations, efforts, energies and, at every connection point, pose, velocity and the state vector `z`.
    ///
    /// 204 operations: 119 mul, 84 add, 1 reciprocal, 2 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `hook` | \[P, Eqs. (1), (13), (36)\] | 3 | 1 | 0 | 0 | 1 |
    /// | Riccati transfer over `end_of_repeat0` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 2 | 1 | 0 | 0 | 0 |
    /// | Acceleration of `hook` | \[P, Eqs. (13), (36), (44)\] | 8 | 4 | 0 | 0 | 0 |
    /// | Load on `hook` | \[P, Eqs. (18), (19)\] | 3 | 3 | 0 | 0 | 0 |
    /// | Motion across `joint` | \[P, Eqs. (1), (13), (36)\] | 5 | 2 | 0 | 0 | 1 |
    /// | Motion across `end_of_repeat0` | \[P, Eqs. (1), (13), (36)\] | 4 | 0 | 0 | 0 | 0 |
    /// | Riccati transfer over `joint` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 13 | 10 | 1 | 0 | 0 |
    /// | Load on `joint` | \[P, Eqs. (18), (19)\] | 22 | 21 | 0 | 0 | 0 |
    /// | Connection points | \[P, Eqs. (4), (12), (13)\] | 3 | 3 | 0 | 0 | 0 |
    /// | Riccati transfer over `hook` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 5 | 0 | 0 | 0 | 0 |
    /// | Acceleration of `joint` | \[P, Eqs. (13), (36), (44)\] | 10 | 7 | 0 | 0 | 0 |
    /// | Load on `start_of_repeat0` | \[P, Eqs. (18), (19)\] | 2 | 2 | 0 | 0 | 0 |
    /// | Acceleration of `end_of_repeat0` | \[P, Eqs. (13), (36), (44)\] | 1 | 2 | 0 | 0 | 0 |
    /// | Load on `end_of_repeat0` | \[P, Eqs. (18), (19)\] | 4 | 4 | 0 | 0 | 0 |
    /// | Pose behind `joint` | \[P, Eq. (12)\] | 8 | 4 | 0 | 0 | 0 |
    /// | Velocity behind `joint` |  | 6 | 3 | 0 | 0 | 0 |
    /// | Results |  | 10 | 11 | 0 | 0 | 0 |
    /// | Pose behind `hook` | \[P, Eq. (12)\] | 6 | 3 | 0 | 0 | 0 |
    /// | Velocity behind `hook` |  | 4 | 3 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// As [`accelerations_into`](Self::accelerations_into); `at` is then as
    /// [`workspace`](Self::workspace) makes it: results of earlier calls are gone.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn solve_into(
        &self,
        state_: &RopeState<T>,
        inputs_: &RopeInputs<T>,
        at_: &mut RopeWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let checked_ = (|| {
            ::mstmm::generated::all_finite::<T>(state_.v.as_slice())?;
            ::core::result::Result::Ok(())
        })();
        if let ::core::result::Result::Err(error_) = checked_ {
            ::mstmm::generated::take_back(at_, || self.workspace());
            return ::core::result::Result::Err(error_);
        }
        let c_ = T::constant;
        let [hook_angle_] = ::mstmm::generated::piece::<T, 1>(state_.q.as_slice(), 10);
        let [hook_rate_] = ::mstmm::generated::piece::<T, 1>(state_.v.as_slice(), 10);
        let results7_ = &mut at_.numbers;
        let results0_ = &mut at_.accelerations;
        let results4_ = &mut at_.efforts;
        let mut regular0_ = <T::Mask as ::mstmm::Mask>::splat(true);
        let mut store1_ = ::mstmm::generated::Stored::<[T; 13], 10>::new_const();
        let mut store3_ = ::mstmm::generated::Stored::<[T; 13], 10>::new_const();
        /// Motion across `hook`, [P, Eqs. (1), (13), (36)]: 2 mul, 0 add, 0 reciprocal, 1 sin/cos.
        let ([sin_hook_angle_], [cos_hook_angle_]) = T::sin_cos([hook_angle_]);
        let t2_ = sin_hook_angle_ * sin_hook_angle_;
        let t3_ = sin_hook_angle_ * cos_hook_angle_;
        /// Riccati transfer over `end_of_repeat0`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 1 add, 0 reciprocal.
        let t4_ = t2_ * c_(1.3333333333333335);
        /// Acceleration of `hook`, [P, Eqs. (13), (36), (44)]: 2 mul, 0 add, 0 reciprocal.
        let t0_ = cos_hook_angle_ * c_(6.666666666666666);
        let t1_ = sin_hook_angle_ * c_(6.666666666666666);
        /// Riccati transfer over `end_of_repeat0`.
        let t6_ = t3_ * c_(1.3333333333333335);
        let t7_ = t4_ + c_(0.6666666666666665);
        /// Load on `hook`, [P, Eqs. (18), (19)]: 0 mul, 1 add, 0 reciprocal.
        let t5_ = t4_ - c_(2.0);
        let mut carry0_0_ = c_(0.0);
        for (
            (
                (&[joint_angle_], &[joint_rate_]),
                &[known_rod_mass_,
                known_rod_first_moment_x_,
                known_rod_inertia_yy_,
                known_rod_inertia_zz_,
                known_knot_,
                known_joint_riccati_p1_,
                known_result_p1_,
                ],
            ),
            [_,
            _,
            _,
            _,
            _,
            _,
            o7_11_,
            _,
            _,
            _,
            o7_15_,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            ],
        ) in ::core::iter::zip(
            ::core::iter::zip(
                ::core::iter::zip(
                    ::mstmm::generated::times::<T, 1>(state_.q.as_slice(), 0, 10).iter(),
                    ::mstmm::generated::times::<T, 1>(state_.v.as_slice(), 0, 10).iter(),
                ),
                ::mstmm::generated::times::<
                    T,
                    7,
                >(self.changed_by_setters.derived().1.as_slice(), 0, 10)
                    .iter(),
            ),
            ::mstmm::generated::times_mut::<T, 22>(results7_.as_mut_slice(), 5, 10)
                .iter_mut(),
        ) {
            let carry0_0_before_ = carry0_0_;
            /// Motion across `joint`, [P, Eqs. (1), (13), (36)]: 5 mul, 2 add, 0 reciprocal, 1 sin/cos.
            let ([sin_joint_angle_], [cos_joint_angle_]) = T::sin_cos([joint_angle_]);
            let joint_omega_z_ = joint_rate_ + carry0_0_before_;
            let t14_ = sin_joint_angle_ * sin_joint_angle_;
            let t15_ = sin_joint_angle_ * cos_joint_angle_;
            let t16_ = c_(2.0) * t15_;
            let t17_ = T::mul_neg_add(c_(2.0), t14_, c_(1.0));
            let t18_ = known_rod_first_moment_x_ * joint_omega_z_;
            /// Motion across `end_of_repeat0`, [P, Eqs. (1), (13), (36)]: 4 mul, 0 add, 0 reciprocal.
            let t8_ = joint_omega_z_ * joint_omega_z_;
            let minus_end_of_repeat0_centripetal_x_ = c_(0.1) * t8_;
            let t19_ = known_rod_inertia_zz_ * t8_;
            let t20_ = c_(0.5) * t19_;
            /// Riccati transfer over `joint`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 4 mul, 1 add, 0 reciprocal.
            let t9_ = joint_angle_ * c_(0.2);
            let minus_joint_load_mz_ = T::mul_add(joint_rate_, c_(0.01), t9_);
            let t12_ = joint_angle_ * t9_;
            let t13_ = t12_ * c_(0.5);
            /// Load on `joint`, [P, Eqs. (18), (19)]: 1 mul, 0 add, 0 reciprocal.
            let t10_ = known_rod_first_moment_x_ * t8_;
            /// Connection points, [P, Eqs. (4), (12), (13)]: 1 mul, 0 add, 0 reciprocal.
            let t11_ = c_(0.1) * joint_omega_z_;
            _ = store1_
                .try_push([
                    sin_joint_angle_,
                    cos_joint_angle_,
                    minus_joint_load_mz_,
                    t14_,
                    t15_,
                    t16_,
                    t17_,
                    minus_end_of_repeat0_centripetal_x_,
                    t10_,
                    t13_,
                    t11_,
                    t18_,
                    t20_,
                ]);
            *o7_11_ = joint_omega_z_;
            *o7_15_ = minus_joint_load_mz_;
            (carry0_0_,) = (joint_omega_z_,);
        }
        /// Motion across `hook`, [P, Eqs. (1), (13), (36)]: 1 mul, 1 add, 0 reciprocal.
        let hook_omega_z_ = hook_rate_ + carry0_0_;
        /// Riccati transfer over `hook`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 5 mul, 0 add, 0 reciprocal.
        let t21_ = hook_omega_z_ * hook_omega_z_;
        let hook_bias_fy_ = c_(0.2) * t21_;
        /// Motion across `hook`.
        let t24_ = c_(0.2) * hook_omega_z_;
        /// Riccati transfer over `hook`.
        let t25_ = t21_ * c_(0.015000000000000003);
        let t22_ = sin_hook_angle_ * hook_bias_fy_;
        let t23_ = cos_hook_angle_ * hook_bias_fy_;
        let mut carry1_0_ = t7_;
        let mut carry1_1_ = -t5_;
        let mut carry1_2_ = c_(2.0);
        let mut carry1_3_ = -t6_;
        let mut carry1_4_ = -t22_;
        let mut carry1_5_ = t23_;
        let mut carry1_6_ = c_(0.0);
        for (
            (
                &[known_rod_mass_,
                known_rod_first_moment_x_,
                _,
                known_rod_inertia_zz_,
                _,
                known_joint_riccati_p1_,
                _,
                ],
                &[sin_joint_angle_,
                cos_joint_angle_,
                minus_joint_load_mz_,
                t14_,
                t15_,
                t16_,
                t17_,
                minus_end_of_repeat0_centripetal_x_,
                t10_,
                _,
                _,
                _,
                _,
                ],
            ),
            [_,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            o7_24_,
            _,
            _,
            ],
        ) in ::core::iter::Iterator::rev(
            ::core::iter::zip(
                ::core::iter::zip(
                    ::mstmm::generated::times::<
                        T,
                        7,
                    >(self.changed_by_setters.derived().1.as_slice(), 0, 10)
                        .iter(),
                    store1_.iter(),
                ),
                ::mstmm::generated::times_mut::<T, 22>(results7_.as_mut_slice(), 5, 10)
                    .iter_mut(),
            ),
        ) {
            let carry1_0_before_ = carry1_0_;
            let carry1_1_before_ = carry1_1_;
            let carry1_2_before_ = carry1_2_;
            let carry1_3_before_ = carry1_3_;
            let carry1_4_before_ = carry1_4_;
            let carry1_5_before_ = carry1_5_;
            let carry1_6_before_ = carry1_6_;
            /// Riccati transfer over `joint`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 9 mul, 9 add, 1 reciprocal.
            let joint_articulated_mass_zz_ = known_rod_mass_ + carry1_2_before_;
            let joint_articulated_coupling_xz_ = c_(0.1) * carry1_3_before_;
            let joint_articulated_coupling_yz_ = T::mul_add(
                c_(0.1),
                carry1_1_before_,
                known_rod_first_moment_x_,
            );
            let joint_articulated_inertia_zz_ = T::mul_add(
                carry1_1_before_,
                c_(0.010000000000000002),
                known_rod_inertia_zz_,
            );
            let joint_bias_fy_ = T::mul_neg_add(
                carry1_3_before_,
                minus_end_of_repeat0_centripetal_x_,
                carry1_5_before_,
            );
            let joint_d_inverse_ = T::recip(joint_articulated_inertia_zz_);
            let t26_ = carry1_0_before_ + carry1_1_before_;
            let t27_ = carry1_2_before_ + t26_;
            let joint_d_scale_ = T::mul_add(
                c_(0.010000000000000002),
                t27_,
                known_joint_riccati_p1_,
            );
            let joint_gain_fx_ = joint_articulated_coupling_xz_ * joint_d_inverse_;
            let joint_gain_fy_ = joint_articulated_coupling_yz_ * joint_d_inverse_;
            let t28_ = minus_joint_load_mz_ + carry1_6_before_;
            let t29_ = T::mul_add(c_(0.1), joint_bias_fy_, t28_);
            let minus_joint_rest_ = joint_d_inverse_ * t29_;
            /// Acceleration of `joint`, [P, Eqs. (13), (36), (44)]: 4 mul, 2 add, 0 reciprocal.
            let t30_ = cos_joint_angle_ * joint_gain_fx_;
            let t31_ = T::mul_neg_add(sin_joint_angle_, joint_gain_fy_, t30_);
            let t32_ = sin_joint_angle_ * joint_gain_fx_;
            let t33_ = T::mul_add(cos_joint_angle_, joint_gain_fy_, t32_);
            /// Load on `joint`, [P, Eqs. (18), (19)]: 17 mul, 17 add, 0 reciprocal.
            let t34_ = known_rod_mass_ + carry1_0_before_;
            let t35_ = known_rod_mass_ + carry1_1_before_;
            let t36_ = joint_articulated_coupling_xz_ * joint_articulated_coupling_xz_;
            let t37_ = T::mul_neg_add(joint_d_inverse_, t36_, t34_);
            let t38_ = joint_articulated_coupling_yz_ * joint_articulated_coupling_yz_;
            let t39_ = T::mul_neg_add(joint_d_inverse_, t38_, t35_);
            let t40_ = joint_articulated_coupling_xz_ * joint_articulated_coupling_yz_;
            let t41_ = T::mul_neg_add(joint_d_inverse_, t40_, carry1_3_before_);
            let t42_ = t10_ - carry1_4_before_;
            let t43_ = T::mul_add(
                carry1_0_before_,
                minus_end_of_repeat0_centripetal_x_,
                t42_,
            );
            let t44_ = T::mul_add(
                joint_articulated_coupling_xz_,
                minus_joint_rest_,
                t43_,
            );
            let t45_ = T::mul_neg_add(
                joint_articulated_coupling_yz_,
                minus_joint_rest_,
                joint_bias_fy_,
            );
            let t46_ = t37_ + t39_;
            let t47_ = t37_ - t39_;
            let t48_ = t17_ * t41_;
            let t49_ = T::mul_add(t15_, t47_, t48_);
            let t50_ = cos_joint_angle_ * t44_;
            let t51_ = T::mul_add(sin_joint_angle_, t45_, t50_);
            let t52_ = sin_joint_angle_ * t44_;
            let t53_ = T::mul_neg_add(cos_joint_angle_, t45_, t52_);
            let t54_ = T::mul_add(t16_, t41_, t39_);
            let t55_ = T::mul_add(t14_, t47_, t54_);
            let t56_ = t46_ - t55_;
            _ = store3_
                .try_push([
                    carry1_0_before_,
                    carry1_1_before_,
                    carry1_3_before_,
                    carry1_4_before_,
                    carry1_5_before_,
                    t37_,
                    t39_,
                    t41_,
                    t31_,
                    t33_,
                    minus_joint_rest_,
                    t44_,
                    t45_,
                ]);
            *o7_24_ = -carry1_6_before_;
            regular0_ = regular0_
                & !::mstmm::generated::vanishes(
                    joint_articulated_inertia_zz_,
                    joint_d_scale_,
                );
            (
                carry1_0_,
                carry1_1_,
                carry1_2_,
                carry1_3_,
                carry1_4_,
                carry1_5_,
                carry1_6_,
            ) = (
                t56_,
                t55_,
                joint_articulated_mass_zz_,
                t49_,
                -t51_,
                -t53_,
                -minus_joint_load_mz_,
            );
        }
        /// Load on `start_of_repeat0`, [P, Eqs. (18), (19)]: 2 mul, 2 add, 0 reciprocal.
        let start_of_repeat0_load_fx_ = T::mul_add(carry1_3_, c_(9.8), carry1_4_);
        let start_of_repeat0_load_fy_ = T::mul_add(carry1_1_, c_(9.8), carry1_5_);
        let mut carry2_0_ = c_(0.0);
        let mut carry2_1_ = c_(9.8);
        let mut carry2_2_ = c_(0.0);
        let mut carry2_3_ = c_(0.0);
        let mut carry2_4_ = c_(0.0);
        let mut carry2_5_ = c_(1.0);
        let mut carry2_6_ = c_(0.0);
        let mut carry2_7_ = c_(0.0);
        let mut carry2_8_ = c_(1.0);
        let mut carry2_9_ = c_(0.0);
        let mut carry2_10_ = c_(0.0);
        let mut carry2_11_ = c_(0.0);
        let mut carry2_12_ = c_(0.0);
        for (
            (
                (
                    (
                        &[known_rod_mass_,
                        known_rod_first_moment_x_,
                        _,
                        _,
                        _,
                        _,
                        known_result_p1_,
                        ],
                        &[sin_joint_angle_,
                        cos_joint_angle_,
                        _,
                        _,
                        _,
                        _,
                        _,
                        minus_end_of_repeat0_centripetal_x_,
                        _,
                        t13_,
                        t11_,
                        t18_,
                        t20_,
                        ],
                    ),
                    &[carry1_0_before_,
                    carry1_1_before_,
                    carry1_3_before_,
                    carry1_4_before_,
                    carry1_5_before_,
                    t37_,
                    t39_,
                    t41_,
                    t31_,
                    t33_,
                    minus_joint_rest_,
                    t44_,
                    t45_,
                    ],
                ),
                [o7_5_,
                o7_6_,
                o7_7_,
                o7_8_,
                o7_9_,
                o7_10_,
                _,
                o7_12_,
                o7_13_,
                o7_14_,
                _,
                o7_16_,
                o7_17_,
                o7_18_,
                o7_19_,
                o7_20_,
                o7_21_,
                o7_22_,
                o7_23_,
                _,
                o7_25_,
                o7_26_,
                ],
            ),
            [o0_0_,
            ],
        ) in ::core::iter::zip(
            ::core::iter::zip(
                ::core::iter::zip(
                    ::core::iter::zip(
                        ::mstmm::generated::times::<
                            T,
                            7,
                        >(self.changed_by_setters.derived().1.as_slice(), 0, 10)
                            .iter(),
                        store1_.iter(),
                    ),
                    ::core::iter::Iterator::rev(store3_.iter()),
                ),
                ::mstmm::generated::times_mut::<T, 22>(results7_.as_mut_slice(), 5, 10)
                    .iter_mut(),
            ),
            ::mstmm::generated::times_mut::<T, 1>(results0_.as_mut_slice(), 0, 10)
                .iter_mut(),
        ) {
            let carry2_0_before_ = carry2_0_;
            let carry2_1_before_ = carry2_1_;
            let carry2_2_before_ = carry2_2_;
            let carry2_3_before_ = carry2_3_;
            let carry2_4_before_ = carry2_4_;
            let carry2_5_before_ = carry2_5_;
            let carry2_6_before_ = carry2_6_;
            let carry2_7_before_ = carry2_7_;
            let carry2_8_before_ = carry2_8_;
            let carry2_9_before_ = carry2_9_;
            let carry2_10_before_ = carry2_10_;
            let carry2_11_before_ = carry2_11_;
            let carry2_12_before_ = carry2_12_;
            /// Acceleration of `joint`, [P, Eqs. (13), (36), (44)]: 6 mul, 5 add, 0 reciprocal.
            let t57_ = cos_joint_angle_ * carry2_0_before_;
            let joint_a_lin_x_ = T::mul_add(sin_joint_angle_, carry2_1_before_, t57_);
            let t58_ = sin_joint_angle_ * carry2_0_before_;
            let minus_joint_a_lin_y_ = T::mul_neg_add(
                cos_joint_angle_,
                carry2_1_before_,
                t58_,
            );
            let t59_ = T::mul_add(carry2_1_before_, t33_, minus_joint_rest_);
            let minus_joint_a_ang_z_ = T::mul_add(carry2_0_before_, t31_, t59_);
            let t70_ = carry2_2_before_ + minus_joint_a_ang_z_;
            /// Acceleration of `end_of_repeat0`, [P, Eqs. (13), (36), (44)]: 1 mul, 2 add, 0 reciprocal.
            let minus_end_of_repeat0_a_lin_x_ = minus_end_of_repeat0_centripetal_x_
                - joint_a_lin_x_;
            let minus_end_of_repeat0_a_lin_y_ = T::mul_add(
                c_(0.1),
                minus_joint_a_ang_z_,
                minus_joint_a_lin_y_,
            );
            /// Load on `joint`, [P, Eqs. (18), (19)]: 4 mul, 4 add, 0 reciprocal.
            let t60_ = T::mul_add(t41_, minus_joint_a_lin_y_, t44_);
            let joint_load_fx_ = T::mul_sub(t37_, joint_a_lin_x_, t60_);
            let t61_ = T::mul_neg_add(t39_, minus_joint_a_lin_y_, t45_);
            let joint_load_fy_ = T::mul_add(t41_, joint_a_lin_x_, t61_);
            /// Load on `end_of_repeat0`, [P, Eqs. (18), (19)]: 4 mul, 4 add, 0 reciprocal.
            let t62_ = T::mul_neg_add(
                carry1_3_before_,
                minus_end_of_repeat0_a_lin_y_,
                carry1_4_before_,
            );
            let minus_end_of_repeat0_load_fx_ = T::mul_sub(
                carry1_0_before_,
                minus_end_of_repeat0_a_lin_x_,
                t62_,
            );
            let t63_ = T::mul_neg_add(
                carry1_1_before_,
                minus_end_of_repeat0_a_lin_y_,
                carry1_5_before_,
            );
            let minus_end_of_repeat0_load_fy_ = T::mul_sub(
                carry1_3_before_,
                minus_end_of_repeat0_a_lin_x_,
                t63_,
            );
            /// Pose behind `joint`, [P, Eq. (12)]: 8 mul, 4 add, 0 reciprocal.
            let t64_ = cos_joint_angle_ * carry2_5_before_;
            let joint_to_inertial_xx_ = T::mul_add(
                sin_joint_angle_,
                carry2_6_before_,
                t64_,
            );
            let t65_ = sin_joint_angle_ * carry2_5_before_;
            let minus_joint_to_inertial_xy_ = T::mul_neg_add(
                cos_joint_angle_,
                carry2_6_before_,
                t65_,
            );
            let t66_ = cos_joint_angle_ * carry2_7_before_;
            let joint_to_inertial_yx_ = T::mul_add(
                sin_joint_angle_,
                carry2_8_before_,
                t66_,
            );
            let t67_ = sin_joint_angle_ * carry2_7_before_;
            let minus_joint_to_inertial_yy_ = T::mul_neg_add(
                cos_joint_angle_,
                carry2_8_before_,
                t67_,
            );
            /// Velocity behind `joint`: 6 mul, 3 add, 0 reciprocal.
            let t68_ = cos_joint_angle_ * carry2_9_before_;
            let joint_velocity_x_ = T::mul_add(
                sin_joint_angle_,
                carry2_10_before_,
                t68_,
            );
            let t69_ = sin_joint_angle_ * carry2_9_before_;
            let minus_joint_velocity_y_ = T::mul_neg_add(
                cos_joint_angle_,
                carry2_10_before_,
                t69_,
            );
            let t73_ = known_result_p1_ * joint_velocity_x_;
            let t74_ = T::mul_neg_add(known_result_p1_, minus_joint_velocity_y_, t18_);
            /// Connection points, [P, Eqs. (4), (12), (13)]: 2 mul, 3 add, 0 reciprocal.
            let point2_velocity_y_ = t11_ - minus_joint_velocity_y_;
            let point2_position_x_ = T::mul_add(
                c_(0.1),
                joint_to_inertial_xx_,
                carry2_3_before_,
            );
            let point2_position_y_ = T::mul_add(
                c_(0.1),
                joint_to_inertial_yx_,
                carry2_4_before_,
            );
            /// Results: 5 mul, 6 add, 0 reciprocal.
            let t71_ = known_rod_mass_ * carry2_4_before_;
            let t72_ = T::mul_add(
                known_rod_first_moment_x_,
                joint_to_inertial_yx_,
                t71_,
            );
            let t75_ = carry2_11_before_ + t20_;
            let t76_ = T::mul_sub(minus_joint_velocity_y_, t74_, t75_);
            let t77_ = T::mul_sub(joint_velocity_x_, t73_, t76_);
            let t78_ = t13_ + carry2_12_before_;
            let t79_ = T::mul_add(c_(9.8), t72_, t78_);
            *o7_5_ = carry2_3_before_;
            *o7_6_ = carry2_4_before_;
            *o7_7_ = joint_to_inertial_xx_;
            *o7_8_ = joint_to_inertial_yx_;
            *o7_9_ = joint_velocity_x_;
            *o7_10_ = -minus_joint_velocity_y_;
            *o7_12_ = joint_a_lin_x_;
            *o7_13_ = -minus_joint_a_lin_y_;
            *o7_14_ = -minus_joint_a_ang_z_;
            *o7_16_ = joint_load_fx_;
            *o7_17_ = joint_load_fy_;
            *o7_18_ = point2_position_x_;
            *o7_19_ = point2_position_y_;
            *o7_20_ = joint_velocity_x_;
            *o7_21_ = point2_velocity_y_;
            *o7_22_ = -minus_end_of_repeat0_a_lin_x_;
            *o7_23_ = -minus_end_of_repeat0_a_lin_y_;
            *o7_25_ = -minus_end_of_repeat0_load_fx_;
            *o7_26_ = -minus_end_of_repeat0_load_fy_;
            *o0_0_ = -t70_;
            (
                carry2_0_,
                carry2_1_,
                carry2_2_,
                carry2_3_,
                carry2_4_,
                carry2_5_,
                carry2_6_,
                carry2_7_,
                carry2_8_,
                carry2_9_,
                carry2_10_,
                carry2_11_,
                carry2_12_,
            ) = (
                -minus_end_of_repeat0_a_lin_x_,
                -minus_end_of_repeat0_a_lin_y_,
                -minus_joint_a_ang_z_,
                point2_position_x_,
                point2_position_y_,
                joint_to_inertial_xx_,
                -minus_joint_to_inertial_xy_,
                joint_to_inertial_yx_,
                -minus_joint_to_inertial_yy_,
                joint_velocity_x_,
                point2_velocity_y_,
                t77_,
                t79_,
            );
        }
        /// Acceleration of `hook`, [P, Eqs. (13), (36), (44)]: 6 mul, 4 add, 0 reciprocal.
        let t80_ = cos_hook_angle_ * carry2_0_;
        /// Pose behind `hook`, [P, Eq. (12)]: 6 mul, 3 add, 0 reciprocal.
        let t86_ = sin_hook_angle_ * carry2_7_;
        /// Velocity behind `hook`: 4 mul, 3 add, 0 reciprocal.
        let t88_ = sin_hook_angle_ * carry2_9_;
        let t87_ = cos_hook_angle_ * carry2_9_;
        /// Acceleration of `hook`.
        let t81_ = sin_hook_angle_ * carry2_0_;
        let t82_ = t0_ * carry2_0_;
        /// Results: 5 mul, 5 add, 0 reciprocal.
        let t90_ = c_(2.0) * carry2_4_;
        /// Acceleration of `hook`.
        let hook_a_lin_x_ = T::mul_add(sin_hook_angle_, carry2_1_, t80_);
        /// Pose behind `hook`.
        let minus_hook_to_inertial_yy_ = T::mul_neg_add(
            cos_hook_angle_,
            carry2_8_,
            t86_,
        );
        /// Velocity behind `hook`.
        let minus_hook_velocity_y_ = T::mul_neg_add(cos_hook_angle_, carry2_10_, t88_);
        /// Results.
        let t94_ = carry2_11_ + t25_;
        /// Velocity behind `hook`.
        let hook_velocity_x_ = T::mul_add(sin_hook_angle_, carry2_10_, t87_);
        /// Pose behind `hook`.
        let t84_ = cos_hook_angle_ * carry2_5_;
        let t85_ = cos_hook_angle_ * carry2_7_;
        /// Acceleration of `hook`.
        let minus_hook_a_lin_y_ = T::mul_neg_add(cos_hook_angle_, carry2_1_, t81_);
        let minus_hook_a_ang_z_ = T::mul_add(t1_, carry2_1_, t82_);
        /// Load on `hook`, [P, Eqs. (18), (19)]: 3 mul, 2 add, 0 reciprocal.
        let t83_ = c_(2.0) * hook_a_lin_x_;
        /// Results.
        let t91_ = T::mul_add(c_(0.2), minus_hook_to_inertial_yy_, t90_);
        let t95_ = T::mul_add(minus_hook_velocity_y_, minus_hook_velocity_y_, t94_);
        /// Velocity behind `hook`.
        let t92_ = t24_ + hook_velocity_x_;
        /// Pose behind `hook`.
        let hook_to_inertial_xx_ = T::mul_add(sin_hook_angle_, carry2_6_, t84_);
        let hook_to_inertial_yx_ = T::mul_add(sin_hook_angle_, carry2_8_, t85_);
        /// Load on `hook`.
        let hook_load_fy_ = T::mul_neg_add(c_(2.0), minus_hook_a_lin_y_, hook_bias_fy_);
        let hook_load_fx_ = T::mul_neg_add(c_(0.2), minus_hook_a_ang_z_, t83_);
        /// Results.
        let t93_ = T::mul_add(c_(9.8), t91_, carry2_12_);
        let t96_ = T::mul_add(hook_velocity_x_, t92_, t95_);
        /// Acceleration of `hook`.
        let t89_ = carry2_2_ + minus_hook_a_ang_z_;
        for [o0_, o1_, o2_, o3_, o4_] in ::mstmm::generated::times_mut::<
            T,
            5,
        >(results7_.as_mut_slice(), 0, 1) {
            *o0_ = c_(0.0);
            *o1_ = c_(9.8);
            *o2_ = -carry1_6_;
            *o3_ = start_of_repeat0_load_fx_;
            *o4_ = start_of_repeat0_load_fy_;
        }
        for [o0_, o1_, o2_, o3_, o4_, o5_, o6_, o7_, o8_, o9_, o10_, o11_] in ::mstmm::generated::times_mut::<
            T,
            12,
        >(results7_.as_mut_slice(), 225, 1) {
            *o0_ = carry2_3_;
            *o1_ = carry2_4_;
            *o2_ = hook_to_inertial_xx_;
            *o3_ = hook_to_inertial_yx_;
            *o4_ = hook_velocity_x_;
            *o5_ = -minus_hook_velocity_y_;
            *o6_ = hook_omega_z_;
            *o7_ = hook_a_lin_x_;
            *o8_ = -minus_hook_a_lin_y_;
            *o9_ = -minus_hook_a_ang_z_;
            *o10_ = hook_load_fx_;
            *o11_ = hook_load_fy_;
        }
        for [o0_] in ::mstmm::generated::times_mut::<
            T,
            1,
        >(results0_.as_mut_slice(), 10, 1) {
            *o0_ = -t89_;
        }
        for [o0_] in ::mstmm::generated::times_mut::<
            T,
            1,
        >(results4_.as_mut_slice(), 0, 10) {
            *o0_ = c_(0.0);
        }
        for [o0_] in ::mstmm::generated::times_mut::<
            T,
            1,
        >(results4_.as_mut_slice(), 10, 1) {
            *o0_ = c_(0.0);
        }
        let checked_ = (|| {
            ::mstmm::generated::require(regular0_, "joint")?;
            ::core::result::Result::Ok(())
        })();
        if let ::core::result::Result::Err(error_) = checked_ {
            ::mstmm::generated::take_back(at_, || self.workspace());
            return ::core::result::Result::Err(error_);
        }
        if !::mstmm::generated::regular::<T, _, _>([], [], [state_.t]) {
            let error_ = ::mstmm::generated::irregular::<T, _>(&[], [], []);
            ::mstmm::generated::take_back(at_, || self.workspace());
            return ::core::result::Result::Err(error_);
        }
        let checked_ = (|| {
            ::mstmm::generated::all_finite::<T>(results0_.as_slice())?;
            ::core::result::Result::Ok(())
        })();
        if let ::core::result::Result::Err(error_) = checked_ {
            ::mstmm::generated::take_back(at_, || self.workspace());
            return ::core::result::Result::Err(error_);
        }
        at_.kinetic_energy = t96_;
        at_.potential_energy = t93_;
        at_.at_rest = [c_(0.0), c_(9.8)];
        ::core::result::Result::Ok(())
    }
    /// Kinetic and potential energy in J; the potential of gravity is zero with every centre
    /// of mass at the inertial origin.
    ///
    /// 62 operations: 38 mul, 24 add, 0 reciprocal, 2 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `hook` | \[P, Eqs. (1), (13), (36)\] | 2 | 2 | 0 | 0 | 1 |
    /// | Motion across `joint` | \[P, Eqs. (1), (13), (36)\] | 18 | 11 | 0 | 0 | 1 |
    /// | Results |  | 18 | 11 | 0 | 0 | 0 |
    #[must_use]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn energy(&self, state_: &RopeState<T>) -> ::mstmm::Energy<T> {
        let c_ = T::constant;
        let [hook_angle_] = ::mstmm::generated::piece::<T, 1>(state_.q.as_slice(), 10);
        let [hook_rate_] = ::mstmm::generated::piece::<T, 1>(state_.v.as_slice(), 10);
        /// Motion across `hook`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 1 sin/cos.
        let ([sin_hook_angle_], [cos_hook_angle_]) = T::sin_cos([hook_angle_]);
        let mut carry0_0_ = c_(0.0);
        let mut carry0_1_ = c_(0.0);
        let mut carry0_2_ = c_(0.0);
        let mut carry0_3_ = c_(1.0);
        let mut carry0_4_ = c_(0.0);
        let mut carry0_5_ = c_(0.0);
        let mut carry0_6_ = c_(0.0);
        let mut carry0_7_ = c_(0.0);
        for (
            (&[joint_angle_], &[joint_rate_]),
            &[known_rod_mass_,
            known_rod_first_moment_x_,
            known_rod_inertia_yy_,
            known_rod_inertia_zz_,
            known_knot_,
            _,
            known_result_p1_,
            ],
        ) in ::core::iter::zip(
            ::core::iter::zip(
                ::mstmm::generated::times::<T, 1>(state_.q.as_slice(), 0, 10).iter(),
                ::mstmm::generated::times::<T, 1>(state_.v.as_slice(), 0, 10).iter(),
            ),
            ::mstmm::generated::times::<
                T,
                7,
            >(self.changed_by_setters.derived().1.as_slice(), 0, 10)
                .iter(),
        ) {
            let carry0_0_before_ = carry0_0_;
            let carry0_1_before_ = carry0_1_;
            let carry0_2_before_ = carry0_2_;
            let carry0_3_before_ = carry0_3_;
            let carry0_4_before_ = carry0_4_;
            let carry0_5_before_ = carry0_5_;
            let carry0_6_before_ = carry0_6_;
            let carry0_7_before_ = carry0_7_;
            /// Motion across `joint`, [P, Eqs. (1), (13), (36)]: 18 mul, 11 add, 0 reciprocal, 1 sin/cos.
            let ([sin_joint_angle_], [cos_joint_angle_]) = T::sin_cos([joint_angle_]);
            let joint_omega_z_ = joint_rate_ + carry0_0_before_;
            let t2_ = joint_omega_z_ * joint_omega_z_;
            let t3_ = cos_joint_angle_ * carry0_2_before_;
            let t4_ = sin_joint_angle_ * carry0_2_before_;
            let t5_ = cos_joint_angle_ * carry0_4_before_;
            let t6_ = sin_joint_angle_ * carry0_4_before_;
            let t7_ = known_rod_first_moment_x_ * joint_omega_z_;
            let t8_ = known_rod_inertia_zz_ * t2_;
            let t9_ = T::mul_add(sin_joint_angle_, carry0_3_before_, t3_);
            let t10_ = T::mul_neg_add(cos_joint_angle_, carry0_3_before_, t4_);
            let t11_ = T::mul_add(c_(0.1), t9_, carry0_1_before_);
            let t14_ = T::mul_add(sin_joint_angle_, carry0_5_before_, t5_);
            let t15_ = T::mul_neg_add(cos_joint_angle_, carry0_5_before_, t6_);
            let t16_ = T::mul_sub(c_(0.1), joint_omega_z_, t15_);
            let t17_ = known_result_p1_ * t14_;
            let t18_ = T::mul_neg_add(known_result_p1_, t15_, t7_);
            let t19_ = T::mul_add(c_(0.5), t8_, carry0_6_before_);
            let t22_ = T::mul_sub(t15_, t18_, t19_);
            let t23_ = T::mul_sub(t14_, t17_, t22_);
            /// Results: 6 mul, 3 add, 0 reciprocal.
            let t0_ = joint_angle_ * c_(0.2);
            let t1_ = joint_angle_ * t0_;
            let t12_ = known_rod_mass_ * carry0_1_before_;
            let t13_ = T::mul_add(known_rod_first_moment_x_, t9_, t12_);
            let t20_ = T::mul_add(t1_, c_(0.5), carry0_7_before_);
            let t21_ = T::mul_add(c_(9.8), t13_, t20_);
            (
                carry0_0_,
                carry0_1_,
                carry0_2_,
                carry0_3_,
                carry0_4_,
                carry0_5_,
                carry0_6_,
                carry0_7_,
            ) = (joint_omega_z_, t11_, t9_, -t10_, t14_, t16_, t23_, t21_);
        }
        /// Motion across `hook`, [P, Eqs. (1), (13), (36)]: 2 mul, 2 add, 0 reciprocal.
        let hook_omega_z_ = hook_rate_ + carry0_0_;
        let t24_ = hook_omega_z_ * hook_omega_z_;
        let t35_ = T::mul_add(t24_, c_(0.015000000000000003), carry0_6_);
        /// Results: 12 mul, 8 add, 0 reciprocal.
        let t25_ = sin_hook_angle_ * carry0_2_;
        let t26_ = T::mul_neg_add(cos_hook_angle_, carry0_3_, t25_);
        let t27_ = sin_hook_angle_ * carry0_4_;
        let t28_ = cos_hook_angle_ * carry0_4_;
        let t29_ = c_(2.0) * carry0_1_;
        let t30_ = T::mul_add(c_(0.2), t26_, t29_);
        let t31_ = T::mul_add(sin_hook_angle_, carry0_5_, t28_);
        let t32_ = T::mul_neg_add(cos_hook_angle_, carry0_5_, t27_);
        let t33_ = T::mul_add(c_(0.2), hook_omega_z_, t31_);
        let t34_ = T::mul_add(c_(9.8), t30_, carry0_7_);
        let t36_ = T::mul_add(t32_, t32_, t35_);
        let t37_ = T::mul_add(t31_, t33_, t36_);
        ::mstmm::Energy {
            kinetic: t37_,
            potential: t34_,
        }
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::Chain for Rope<T> {
    type Scalar = T;
    type State = RopeState<T>;
    type Inputs = RopeInputs<T>;
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn derivative_into(
        &self,
        state_: &RopeState<T>,
        inputs_: &RopeInputs<T>,
        rate_: &mut RopeState<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.accelerations_into(state_, inputs_, &mut rate_.v)?;
        self.configuration_rate_into(state_, rate_);
        ::core::result::Result::Ok(())
    }
    #[inline]
    fn implicit_derivative_into(
        &self,
        state_: &RopeState<T>,
        inputs_: &RopeInputs<T>,
        step_: T,
        rate_: &mut RopeState<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.implicit_accelerations_into(state_, inputs_, step_, &mut rate_.v)?;
        self.configuration_rate_into(state_, rate_);
        ::core::result::Result::Ok(())
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn configuration_rate_into(&self, state_: &RopeState<T>, rate_: &mut RopeState<T>) {
        rate_.q.data.0 = {
            let [hook_rate_] = ::mstmm::generated::piece::<
                T,
                1,
            >(state_.v.as_slice(), 10);
            let mut results0_ = [T::constant(0.0); 11];
            for (&[joint_rate_], [o0_0_]) in ::core::iter::zip(
                ::mstmm::generated::times::<T, 1>(state_.v.as_slice(), 0, 10).iter(),
                ::mstmm::generated::times_mut::<T, 1>(results0_.as_mut_slice(), 0, 10)
                    .iter_mut(),
            ) {
                *o0_0_ = joint_rate_;
                () = ();
            }
            for [o0_] in ::mstmm::generated::times_mut::<
                T,
                1,
            >(results0_.as_mut_slice(), 10, 1) {
                *o0_ = hook_rate_;
            }
            [results0_]
        };
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn normalize(&self, state_: &mut RopeState<T>) {
        state_.q.data.0 = {
            let [hook_angle_] = ::mstmm::generated::piece::<
                T,
                1,
            >(state_.q.as_slice(), 10);
            let mut results0_ = [T::constant(0.0); 11];
            for (&[joint_angle_], [o0_0_]) in ::core::iter::zip(
                ::mstmm::generated::times::<T, 1>(state_.q.as_slice(), 0, 10).iter(),
                ::mstmm::generated::times_mut::<T, 1>(results0_.as_mut_slice(), 0, 10)
                    .iter_mut(),
            ) {
                *o0_0_ = joint_angle_;
                () = ();
            }
            for [o0_] in ::mstmm::generated::times_mut::<
                T,
                1,
            >(results0_.as_mut_slice(), 10, 1) {
                *o0_ = hook_angle_;
            }
            [results0_]
        };
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::GeneratedChain for Rope<T> {
    type Workspace = RopeWorkspace<T>;
    #[inline]
    fn initial_state(&self) -> RopeState<T> {
        self.initial_state()
    }
    #[inline]
    fn no_inputs(&self) -> RopeInputs<T> {
        self.no_inputs()
    }
    #[inline]
    fn workspace(&self) -> RopeWorkspace<T> {
        self.workspace()
    }
    #[inline]
    fn solve_into(
        &self,
        state_: &RopeState<T>,
        inputs_: &RopeInputs<T>,
        at_: &mut RopeWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.solve_into(state_, inputs_, at_)
    }
    #[inline]
    fn energy(&self, state_: &RopeState<T>) -> ::mstmm::Energy<T> {
        self.energy(state_)
    }
}
/// Coordinates and rates of [`Rope`] at a time.
///
/// The hinges lie one after the other in the order of the route. A body that floats comes
/// first; a hinge whose motion is prescribed has no place.
/// A repeated part lies repetition by repetition: all its hinges in the order of the route
/// for the first repetition, then all of them for the second, and so on.
///
/// | of | places in `q`, with k from zero | places in `v` |
/// |---|---|---|
/// | `joint`, repetition k of 10 | 0 (+ k) | 0 (+ k) |
/// | `hook` | 10 | 10 |
///
/// [`Default`] is every hinge at rest in its zero position.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct RopeState<T> {
    /// Coordinates: angles in rad, lengths in m, unit quaternions as w, x, y, z.
    pub q: ::mstmm::nalgebra::SVector<T, 11>,
    /// Rates in rad/s and m/s.
    pub v: ::mstmm::nalgebra::SVector<T, 11>,
    /// Time in s.
    pub t: T,
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> RopeState<T> {
    /// Coordinates and rates of hinge `joint` number `index` of 10.
    #[inline]
    #[must_use]
    pub fn joint(
        &self,
        index_: ::core::primitive::usize,
    ) -> ::core::option::Option<::mstmm::PinState<T>> {
        let &[q0_] = ::mstmm::generated::times::<T, 1>(self.q.as_slice(), 0, 10)
            .get(index_)?;
        let &[v0_] = ::mstmm::generated::times::<T, 1>(self.v.as_slice(), 0, 10)
            .get(index_)?;
        ::core::option::Option::Some(::mstmm::PinState::new(q0_, v0_))
    }
    /// Coordinates and rates of hinge `joint` number `index` of 10. To be changed.
    #[inline]
    pub fn joint_mut(
        &mut self,
        index_: ::core::primitive::usize,
    ) -> ::core::option::Option<::mstmm::PinStateMut<'_, T>> {
        let [q0_] = ::mstmm::generated::times_mut::<T, 1>(self.q.as_mut_slice(), 0, 10)
            .get_mut(index_)?;
        let [v0_] = ::mstmm::generated::times_mut::<T, 1>(self.v.as_mut_slice(), 0, 10)
            .get_mut(index_)?;
        ::core::option::Option::Some(::mstmm::PinStateMut::new(q0_, v0_))
    }
    /// Sets coordinates and rates of all hinges `joint` by their index.
    pub fn set_each_joint(
        &mut self,
        mut view_: impl ::core::ops::FnMut(
            ::core::primitive::usize,
        ) -> ::mstmm::PinState<T>,
    ) {
        let mut set_ = |index_: ::core::primitive::usize| -> ::core::option::Option<()> {
            let (new_q0_, new_v0_) = view_(index_).into_groups();
            let [q0_] = ::mstmm::generated::times_mut::<
                T,
                1,
            >(self.q.as_mut_slice(), 0, 10)
                .get_mut(index_)?;
            let [v0_] = ::mstmm::generated::times_mut::<
                T,
                1,
            >(self.v.as_mut_slice(), 0, 10)
                .get_mut(index_)?;
            *q0_ = new_q0_;
            *v0_ = new_v0_;
            ::core::option::Option::Some(())
        };
        for index_ in 0..10 {
            set_(index_);
        }
    }
    /// Coordinates and rates of hinge `hook`.
    #[inline]
    #[must_use]
    pub fn hook(&self) -> ::mstmm::PinState<T> {
        let [q0_] = ::mstmm::generated::piece::<T, 1>(self.q.as_slice(), 10);
        let [v0_] = ::mstmm::generated::piece::<T, 1>(self.v.as_slice(), 10);
        ::mstmm::PinState::new(q0_, v0_)
    }
    /// Coordinates and rates of hinge `hook`, to be changed.
    #[inline]
    pub fn hook_mut(&mut self) -> ::mstmm::PinStateMut<'_, T> {
        let [[.., q0_]] = &mut self.q.data.0;
        let [[.., v0_]] = &mut self.v.data.0;
        ::mstmm::PinStateMut::new(q0_, v0_)
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for RopeState<T> {
    fn default() -> Self {
        let (zero_, one_) = (T::constant(0.0), T::constant(1.0));
        let _ = one_;
        Self {
            q: ::mstmm::generated::vector({
                let mut rest_ = [zero_; 11];
                for part_ in ::mstmm::generated::times_mut::<
                    T,
                    1,
                >(rest_.as_mut_slice(), 0, 10) {
                    *part_ = [zero_];
                }
                for part_ in ::mstmm::generated::times_mut::<
                    T,
                    1,
                >(rest_.as_mut_slice(), 10, 1) {
                    *part_ = [zero_];
                }
                rest_
            }),
            v: ::mstmm::generated::vector([zero_; 11]),
            t: zero_,
        }
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::ChainState for RopeState<T> {
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
/// What drives [`Rope`] from outside, given at every step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct RopeInputs<T> {
    none: ::core::marker::PhantomData<T>,
}
impl<T: ::mstmm::Scalar> ::core::default::Default for RopeInputs<T> {
    #[inline]
    fn default() -> Self {
        Self {
            none: ::core::marker::PhantomData,
        }
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> Rope<T> {
    /// Inputs that are all zero; prescribed motions rest in the zero position.
    #[inline]
    #[must_use]
    pub fn no_inputs(&self) -> RopeInputs<T> {
        ::core::default::Default::default()
    }
}
/// Results of [`Rope::solve_into`]: accelerations, efforts, energies and, at every connection point, pose, velocity and the state vector `z`.
#[derive(Clone, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct RopeWorkspace<T> {
    accelerations: ::mstmm::nalgebra::SVector<T, 11>,
    efforts: ::mstmm::nalgebra::SVector<T, 11>,
    kinetic_energy: T,
    potential_energy: T,
    numbers: [T; 237],
    at_rest: [T; 2],
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> RopeWorkspace<T> {
    /// Accelerations `v̇` of all hinges, in the order of `v` of the state.
    #[inline]
    pub fn accelerations(&self) -> &::mstmm::nalgebra::SVector<T, 11> {
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
    /// Those of a repeated part come repetition by repetition: the outputs of all its elements
    /// for the first repetition, then those for the second, and so on.
    #[inline]
    pub fn points(&self) -> [::mstmm::PlanePoint<T>; 23] {
        ::core::array::from_fn(|index_| self.point_(index_))
    }
    /// Where every point of the model has its numbers.
    const PLACES_: [::mstmm::generated::Places<1, 6>; 5] = [
        ::mstmm::generated::Places::new(
            0,
            [0],
            [([0], 0), ([0], 0), ([0], 1), ([0], 0), ([0], 3), ([0], 4)],
        ),
        ::mstmm::generated::Places::new(
            1,
            [3],
            [([3], 5), ([0], 7), ([3], 8), ([0], 10), ([0], 11), ([3], 12)],
        ),
        ::mstmm::generated::Places::new(
            14,
            [3],
            [([3], 16), ([0], 7), ([3], 18), ([0], 10), ([0], 20), ([3], 21)],
        ),
        ::mstmm::generated::Places::new(
            1,
            [3],
            [([3], 5), ([0], 7), ([3], 8), ([0], 10), ([0], 0), ([3], 11)],
        ),
        ::mstmm::generated::Places::new(
            1,
            [3],
            [([3], 5), ([0], 7), ([3], 8), ([0], 10), ([0], 0), ([0], 0)],
        ),
    ];
    /// Connection point number `index`.
    #[inline]
    fn point_(&self, index_: ::core::primitive::usize) -> ::mstmm::PlanePoint<T> {
        let (model_, numbers_) = ::mstmm::generated::place_of(
            &self.numbers,
            &[[0, 1, 0, 1, 0, 5], [1, 2, 1, 20, 5, 22], [3, 2, 21, 2, 225, 12]],
            index_,
        );
        <::mstmm::PlanePoint<T>>::read(numbers_, Self::PLACES_.get(model_), self.at_rest)
    }
    /// Acceleration, effort, input and output of hinge `joint` number `index` of 10.
    #[inline]
    pub fn joint(
        &self,
        index_: ::core::primitive::usize,
    ) -> ::core::option::Option<::mstmm::HingeResult<T, T, ::mstmm::PlanePoint<T>>> {
        if index_ >= 10 {
            return ::core::option::Option::None;
        }
        let first_ = 0 + index_ * 2;
        let (input_, output_) = (self.point_(first_), self.point_(first_ + 1));
        let result_ = ::mstmm::HingeResult::new(
            {
                let &[x0_] = ::mstmm::generated::times::<
                    T,
                    1,
                >(self.accelerations.as_slice(), 0, 10)
                    .get(index_)?;
                x0_
            },
            {
                let &[x0_] = ::mstmm::generated::times::<
                    T,
                    1,
                >(self.efforts.as_slice(), 0, 10)
                    .get(index_)?;
                x0_
            },
            input_,
            output_,
        );
        ::core::option::Option::Some(result_)
    }
    /// Results at body `rod` number `index` of 10: input, output and centre of mass.
    #[inline]
    pub fn rod(
        &self,
        index_: ::core::primitive::usize,
    ) -> ::core::option::Option<::mstmm::BodyResult<T, ::mstmm::PlanePoint<T>>> {
        if index_ >= 10 {
            return ::core::option::Option::None;
        }
        let first_ = 1 + index_ * 2;
        let (input_, output_) = (self.point_(first_), self.point_(first_ + 1));
        ::core::option::Option::Some(
            ::mstmm::BodyResult::new(
                input_,
                output_,
                [T::constant(0.05f64), T::constant(0f64)],
            ),
        )
    }
    /// Acceleration, effort, input and output of hinge `hook`.
    #[inline]
    pub fn hook(&self) -> ::mstmm::HingeResult<T, T, ::mstmm::PlanePoint<T>> {
        let (input_, output_) = (self.point_(20), self.point_(21));
        ::mstmm::HingeResult::new(
            {
                let [value_] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.accelerations.as_slice(), 10);
                value_
            },
            {
                let [value_] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.efforts.as_slice(), 10);
                value_
            },
            input_,
            output_,
        )
    }
    /// Results at body `weight`: input and centre of mass.
    #[inline]
    pub fn weight(
        &self,
    ) -> ::mstmm::BodyResult<T, ::mstmm::PlanePoint<T>, ::mstmm::Written<false, true>> {
        let (input_, output_) = (self.point_(21), self.point_(22));
        ::mstmm::BodyResult::new(
            input_,
            output_,
            [T::constant(0f64), T::constant((-0.1f64))],
        )
    }
}
impl<T: ::mstmm::Scalar> ::core::fmt::Debug for RopeWorkspace<T> {
    fn fmt(&self, to_: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
        to_.debug_struct("RopeWorkspace")
            .field("accelerations", &self.accelerations)
            .field("efforts", &self.efforts)
            .field("kinetic_energy", &self.kinetic_energy)
            .field("potential_energy", &self.potential_energy)
            .field("points", &self.points())
            .finish()
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> Rope<T> {
    /// Room for the results of [`solve_into`](Self::solve_into), which mean nothing before.
    #[must_use]
    #[allow(clippy::all)]
    pub fn workspace(&self) -> RopeWorkspace<T> {
        let zero_ = T::constant(0.0);
        RopeWorkspace {
            accelerations: ::mstmm::generated::vector([zero_; 11]),
            efforts: ::mstmm::generated::vector([zero_; 11]),
            kinetic_energy: zero_,
            potential_energy: zero_,
            numbers: [T::constant(0.0); 237],
            at_rest: [T::constant(0.0); 2],
        }
    }
}
const _: () = {
    #[allow(dead_code)]
    fn elements<T: ::mstmm::Scalar>() {
        let _ = RopeWorkspace::<T>::joint;
    }
};
#[allow(dead_code, non_camel_case_types, clippy::all)]
const _: () = {
    struct Rod;
    struct Weight;
    const _: Rod = Rod;
    const _: Weight = Weight;
};
