/// Rods on pins with springs, and a weight: the rods are the times of a loop.
///
/// # The chain
///
/// `pin joint -> rod -> pin hook -> weight`
///
/// | element | kind | freedoms |
/// |---|---|---|
/// | `joint` | pin | 1 |
/// | `rod` | body `Rod` |  |
/// | `hook` | pin | 1 |
/// | `weight` | body `Weight` |  |
///
/// 11 degrees of freedom; accelerations by `riccati`, 87 operations (47 mul, 39 add, 1 reciprocal, 2 sin/cos); with everything at every connection point 247 operations; those of repeated parts are counted once.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct Rope<T> {
    parameters: RopeParameters<T>,
    derived: [T; 0],
    derived0: [T; 60],
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
        let parameters = RopeParameters {
            knot: [T::constant(0f64); 10],
        };
        let (chain, _) = Self::derive(parameters);
        chain
    }
    /// The numbers that may change at run time.
    #[inline]
    pub fn parameters(&self) -> &RopeParameters<T> {
        &self.parameters
    }
    /// Sets `knot` in kg.
    ///
    /// One number for each of 10 times, from `value` by index.
    ///
    /// # Errors
    ///
    /// [`Error::Parameter`](::mstmm::Error::Parameter) if the number is not finite or would
    /// leave the chain with a mass that is not positive, a stiffness or damping that is negative
    /// or a quantity that is not finite; the old one is kept then.
    #[allow(unused_variables, clippy::all)]
    pub fn set_knot(
        &mut self,
        mut value: impl ::core::ops::FnMut(usize) -> T,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let mut parameters = self.parameters;
        for (index, place) in parameters.knot.iter_mut().enumerate() {
            *place = value(index);
        }
        let values = &parameters.knot;
        let (chain, checks) = Self::derive(parameters);
        ::mstmm::generated::check_parameter(
            "knot",
            values,
            &[&chain.derived, &chain.derived0],
        )?;
        for numbers in ::mstmm::generated::times::<T, 1>(checks.as_slice(), 0, 10).iter()
        {
            ::mstmm::generated::check_numbers(
                "knot",
                numbers,
                &[(true, "must leave the mass of body `rod` positive")],
            )?;
        }
        *self = chain;
        ::core::result::Result::Ok(())
    }
    /// The state that the description starts from, at time zero.
    #[must_use]
    #[allow(unused_doc_comments, clippy::all)]
    pub fn initial_state(&self) -> RopeState<T> {
        let c = T::constant;
        let mut results0 = [T::constant(0.0); 11];
        let mut results1 = [T::constant(0.0); 11];
        for [o0] in ::mstmm::generated::times_mut::<T, 1>(results0.as_mut_slice(), 0, 10)
            .iter_mut()
        {
            *o0 = c(0.0);
        }
        for [o0] in ::mstmm::generated::times_mut::<T, 1>(results0.as_mut_slice(), 10, 1)
            .iter_mut()
        {
            *o0 = c(0.0);
        }
        for [o0] in ::mstmm::generated::times_mut::<T, 1>(results1.as_mut_slice(), 0, 10)
            .iter_mut()
        {
            *o0 = c(0.0);
        }
        for [o0] in ::mstmm::generated::times_mut::<T, 1>(results1.as_mut_slice(), 10, 1)
            .iter_mut()
        {
            *o0 = c(0.0);
        }
        RopeState {
            q: ::mstmm::generated::vector(results0),
            v: ::mstmm::generated::vector(results1),
            t: T::constant(0.0),
        }
    }
    /// Quantities derived from parameters and constants: 2 mul, 3 add, 0 reciprocal.
    #[allow(unused_doc_comments, unused_variables, unused_mut, clippy::all)]
    fn derive(parameters: RopeParameters<T>) -> (Self, [T; 10]) {
        let c = T::constant;
        let mut results1 = [T::constant(0.0); 10];
        let mut results2 = [T::constant(0.0); 60];
        for ((&knot, [o1_0]), [o2_0, o2_1, o2_2, o2_3, o2_4, o2_5]) in parameters
            .knot
            .iter()
            .zip(
                ::mstmm::generated::times_mut::<T, 1>(results1.as_mut_slice(), 0, 10)
                    .iter_mut(),
            )
            .zip(
                ::mstmm::generated::times_mut::<T, 6>(results2.as_mut_slice(), 0, 10)
                    .iter_mut(),
            )
        {
            /// Quantities derived from parameters and constants: 2 mul, 3 add, 0 reciprocal.
            let p1 = knot + c(0.1);
            let p2 = p1 * c(0.05);
            let p3 = p1 * c(0.0025000000000000005);
            let p4 = p3 + c(0.0001);
            let p5 = p3 + p4;
            *o1_0 = p1;
            *o2_0 = knot;
            *o2_1 = p1;
            *o2_2 = p2;
            *o2_3 = p3;
            *o2_4 = p4;
            *o2_5 = p5;
            () = ();
        }
        let (derived, checks) = ([], results1);
        (
            Self {
                parameters,
                derived,
                derived0: results2,
            },
            checks,
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
    /// 117 operations: 61 mul, 55 add, 1 reciprocal, 2 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `hook` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 1 |
    /// | Results |  | 5 | 3 | 0 | 0 | 0 |
    /// | Motion across `joint` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 1 |
    /// | Motion across `end_of_repeat0` | \[P, Eqs. (1), (13), (36)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Results |  | 5 | 2 | 0 | 0 | 0 |
    /// | Motion across `hook` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `hook` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Results |  | 2 | 0 | 0 | 0 | 0 |
    /// | Riccati transfer over `joint` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 10 | 15 | 1 | 0 | 0 |
    /// | Results |  | 24 | 23 | 0 | 0 | 0 |
    /// | Acceleration of `joint` | \[P, Eqs. (13), (36), (44)\] | 7 | 6 | 0 | 0 | 0 |
    /// | Acceleration of `end_of_repeat0` | \[P, Eqs. (13), (36), (44)\] | 1 | 2 | 0 | 0 | 0 |
    /// | Acceleration of `hook` | \[P, Eqs. (13), (36), (44)\] | 3 | 1 | 0 | 0 | 0 |
    /// | Results |  | 0 | 1 | 0 | 0 | 0 |
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn implicit_accelerations_into(
        &self,
        state: &RopeState<T>,
        inputs: &RopeInputs<T>,
        step: T,
        accelerations: &mut ::mstmm::nalgebra::SVector<T, 11>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let c = T::constant;
        let [hook_angle] = ::mstmm::generated::piece::<T, 1>(state.q.as_slice(), 10);
        let [hook_rate] = ::mstmm::generated::piece::<T, 1>(state.v.as_slice(), 10);
        let mut results0 = [T::constant(0.0); 11];
        let mut regular0 = <T::Mask as ::mstmm::Mask>::splat(true);
        let mut store1 = [[T::constant(0.0); 5]; 10];
        let mut store3 = [[T::constant(0.0); 4]; 10];
        /// Motion across `hook`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 1 sin/cos.
        let ([sin_hook_angle], [cos_hook_angle]) = T::sin_cos([hook_angle]);
        /// Results: 5 mul, 3 add, 0 reciprocal.
        let t0 = sin_hook_angle * c(1.3333333333333333);
        let t1 = sin_hook_angle * t0;
        let t2 = cos_hook_angle * t0;
        let t3 = t1 + c(0.6666666666666667);
        let t4 = t1 - c(2.0);
        let t5 = step * c(0.2);
        let t6 = c(0.01) + t5;
        let t7 = step * t6;
        let mut carry0_0 = c(0.0);
        for (
            (
                (&[joint_angle], &[joint_rate]),
                &[known_knot,
                known_p1,
                known_p2,
                known_p3,
                known_p4,
                known_p5,
                ],
            ),
            store,
        ) in ::mstmm::generated::times::<T, 1>(state.q.as_slice(), 0, 10)
            .iter()
            .zip(::mstmm::generated::times::<T, 1>(state.v.as_slice(), 0, 10).iter())
            .zip(
                ::mstmm::generated::times::<T, 6>(self.derived0.as_slice(), 0, 10).iter(),
            )
            .zip(store1.iter_mut())
        {
            let carry0_0_before = carry0_0;
            /// Motion across `joint`, [P, Eqs. (1), (13), (36)]: 0 mul, 1 add, 0 reciprocal, 1 sin/cos.
            let ([sin_joint_angle], [cos_joint_angle]) = T::sin_cos([joint_angle]);
            let joint_omega_z = joint_rate + carry0_0_before;
            /// Motion across `end_of_repeat0`, [P, Eqs. (1), (13), (36)]: 2 mul, 0 add, 0 reciprocal.
            let t8 = c(0.1) * joint_omega_z;
            let minus_end_of_repeat0_drift_lin_x = joint_omega_z * t8;
            /// Results: 5 mul, 2 add, 0 reciprocal.
            let t9 = joint_angle * c(0.2);
            let t10 = joint_rate * c(0.01);
            let t11 = t9 + t10;
            let t12 = known_p2 * joint_omega_z;
            let t13 = joint_omega_z * t12;
            let t14 = joint_rate * t5;
            let t15 = t11 + t14;
            *store = [
                sin_joint_angle,
                cos_joint_angle,
                minus_end_of_repeat0_drift_lin_x,
                t13,
                t15,
            ];
            (carry0_0,) = (joint_omega_z,);
        }
        /// Motion across `hook`, [P, Eqs. (1), (13), (36)]: 0 mul, 1 add, 0 reciprocal.
        let hook_omega_z = hook_rate + carry0_0;
        /// Riccati transfer over `hook`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 0 add, 0 reciprocal.
        let t16 = c(0.2) * hook_omega_z;
        let hook_e_force_y = hook_omega_z * t16;
        /// Results: 2 mul, 0 add, 0 reciprocal.
        let t17 = sin_hook_angle * hook_e_force_y;
        let t18 = cos_hook_angle * hook_e_force_y;
        let mut carry1_0 = t3;
        let mut carry1_1 = -t4;
        let mut carry1_2 = c(2.0);
        let mut carry1_3 = -t2;
        let mut carry1_4 = c(0.0);
        let mut carry1_5 = c(0.0);
        let mut carry1_6 = c(0.0);
        let mut carry1_7 = -t17;
        let mut carry1_8 = t18;
        let mut carry1_9 = c(0.0);
        for (
            (
                &[_,
                known_p1,
                known_p2,
                _,
                known_p4,
                known_p5,
                ],
                &[sin_joint_angle,
                cos_joint_angle,
                minus_end_of_repeat0_drift_lin_x,
                t13,
                t15,
                ],
            ),
            store,
        ) in ::mstmm::generated::times::<T, 6>(self.derived0.as_slice(), 0, 10)
            .iter()
            .zip(store1.iter())
            .zip(store3.iter_mut())
            .rev()
        {
            let carry1_0_before = carry1_0;
            let carry1_1_before = carry1_1;
            let carry1_2_before = carry1_2;
            let carry1_3_before = carry1_3;
            let carry1_4_before = carry1_4;
            let carry1_5_before = carry1_5;
            let carry1_6_before = carry1_6;
            let carry1_7_before = carry1_7;
            let carry1_8_before = carry1_8;
            let carry1_9_before = carry1_9;
            /// Riccati transfer over `joint`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 10 mul, 15 add, 1 reciprocal.
            let joint_k_xx = known_p1 + carry1_0_before;
            let joint_k_yy = known_p1 + carry1_1_before;
            let joint_k_zz = known_p1 + carry1_2_before;
            let t19 = c(0.1) * carry1_3_before;
            let joint_b_x_z = carry1_4_before + t19;
            let t20 = c(0.1) * carry1_1_before;
            let t21 = carry1_5_before + t20;
            let joint_b_y_z = known_p2 + t21;
            let t22 = carry1_5_before + t21;
            let t23 = c(0.1) * t22;
            let t24 = carry1_6_before + t23;
            let joint_j_zz = known_p4 + t24;
            let t25 = carry1_0_before * minus_end_of_repeat0_drift_lin_x;
            let t26 = carry1_7_before - t25;
            let minus_joint_e_force_x = t13 - t26;
            let t27 = carry1_3_before * minus_end_of_repeat0_drift_lin_x;
            let joint_e_force_y = carry1_8_before - t27;
            let t28 = carry1_4_before * minus_end_of_repeat0_drift_lin_x;
            let t29 = carry1_9_before - t28;
            let t30 = c(0.1) * joint_e_force_y;
            let joint_e_moment_z = t29 + t30;
            let joint_d0 = t7 + joint_j_zz;
            let t31 = T::recip(joint_d0);
            let joint_z0_force_x = joint_b_x_z * t31;
            let joint_z0_force_y = joint_b_y_z * t31;
            let joint_z0_moment_z = joint_j_zz * t31;
            /// Results: 24 mul, 23 add, 0 reciprocal.
            let t32 = carry1_0_before + carry1_1_before;
            let t33 = carry1_2_before + t32;
            let t34 = c(0.010000000000000002) * t33;
            let t35 = known_p5 + t34;
            let t36 = t35 + t7;
            let t37 = t15 + joint_e_moment_z;
            let t38 = t37 * t31;
            let t39 = joint_b_x_z * joint_z0_force_x;
            let t40 = joint_k_xx - t39;
            let t41 = joint_b_y_z * joint_z0_force_y;
            let t42 = joint_k_yy - t41;
            let t43 = joint_b_y_z * joint_z0_force_x;
            let t44 = carry1_3_before - t43;
            let t45 = joint_j_zz * joint_z0_force_x;
            let t46 = joint_b_x_z - t45;
            let t47 = joint_j_zz * joint_z0_force_y;
            let t48 = joint_b_y_z - t47;
            let t49 = joint_j_zz * joint_z0_moment_z;
            let t50 = joint_j_zz - t49;
            let t51 = joint_b_x_z * t38;
            let t52 = minus_joint_e_force_x + t51;
            let t53 = joint_b_y_z * t38;
            let t54 = joint_e_force_y - t53;
            let t55 = joint_j_zz * t38;
            let t56 = joint_e_moment_z - t55;
            let t57 = t40 - t42;
            let t58 = sin_joint_angle * t57;
            let t59 = c(2.0) * t44;
            let t60 = cos_joint_angle * t59;
            let t61 = t58 + t60;
            let t62 = sin_joint_angle * t61;
            let t63 = cos_joint_angle * t61;
            let t64 = t40 - t62;
            let t65 = t44 - t63;
            let t66 = t42 + t62;
            let t67 = cos_joint_angle * t46;
            let t68 = sin_joint_angle * t48;
            let t69 = t67 - t68;
            let t70 = sin_joint_angle * t46;
            let t71 = cos_joint_angle * t48;
            let t72 = t70 + t71;
            let t73 = cos_joint_angle * t52;
            let t74 = sin_joint_angle * t54;
            let t75 = t73 + t74;
            let t76 = sin_joint_angle * t52;
            let t77 = cos_joint_angle * t54;
            let t78 = t76 - t77;
            *store = [t38, joint_z0_force_x, joint_z0_force_y, joint_z0_moment_z];
            regular0 = regular0 & !::mstmm::generated::vanishes(joint_d0, t36);
            (
                carry1_0,
                carry1_1,
                carry1_2,
                carry1_3,
                carry1_4,
                carry1_5,
                carry1_6,
                carry1_7,
                carry1_8,
                carry1_9,
            ) = (t64, t66, joint_k_zz, -t65, t69, t72, t50, -t75, -t78, t56);
        }
        let mut carry2_0 = c(0.0);
        let mut carry2_1 = c(9.8);
        let mut carry2_2 = c(0.0);
        for (
            (
                &[sin_joint_angle,
                cos_joint_angle,
                minus_end_of_repeat0_drift_lin_x,
                _,
                _,
                ],
                &[t38,
                joint_z0_force_x,
                joint_z0_force_y,
                joint_z0_moment_z,
                ],
            ),
            [o0_0,
            ],
        ) in store1
            .iter()
            .zip(store3.iter())
            .zip(
                ::mstmm::generated::times_mut::<T, 1>(results0.as_mut_slice(), 0, 10)
                    .iter_mut(),
            )
        {
            let carry2_0_before = carry2_0;
            let carry2_1_before = carry2_1;
            let carry2_2_before = carry2_2;
            /// Acceleration of `joint`, [P, Eqs. (13), (36), (44)]: 7 mul, 6 add, 0 reciprocal.
            let t79 = cos_joint_angle * carry2_0_before;
            let t80 = sin_joint_angle * carry2_1_before;
            let joint_a_lin_x = t79 + t80;
            let t81 = sin_joint_angle * carry2_0_before;
            let t82 = cos_joint_angle * carry2_1_before;
            let minus_joint_a_lin_y = t81 - t82;
            let t83 = joint_a_lin_x * joint_z0_force_x;
            let t84 = minus_joint_a_lin_y * joint_z0_force_y;
            let t85 = t83 - t84;
            let t86 = carry2_2_before * joint_z0_moment_z;
            let t87 = t85 + t86;
            let t88 = t38 + t87;
            let joint_a_ang_z = carry2_2_before - t88;
            /// Acceleration of `end_of_repeat0`, [P, Eqs. (13), (36), (44)]: 1 mul, 2 add, 0 reciprocal.
            let minus_end_of_repeat0_a_lin_x = minus_end_of_repeat0_drift_lin_x
                - joint_a_lin_x;
            let t89 = c(0.1) * joint_a_ang_z;
            let minus_end_of_repeat0_a_lin_y = minus_joint_a_lin_y - t89;
            *o0_0 = -t88;
            (carry2_0, carry2_1, carry2_2) = (
                -minus_end_of_repeat0_a_lin_x,
                -minus_end_of_repeat0_a_lin_y,
                joint_a_ang_z,
            );
        }
        /// Acceleration of `hook`, [P, Eqs. (13), (36), (44)]: 3 mul, 1 add, 0 reciprocal.
        let t90 = cos_hook_angle * carry2_0;
        let t91 = sin_hook_angle * carry2_1;
        let hook_a_lin_x = t90 + t91;
        let minus_hook_a_ang_z = c(6.666666666666666) * hook_a_lin_x;
        /// Results: 0 mul, 1 add, 0 reciprocal.
        let t92 = carry2_2 + minus_hook_a_ang_z;
        for [o0] in ::mstmm::generated::times_mut::<T, 1>(results0.as_mut_slice(), 10, 1)
            .iter_mut()
        {
            *o0 = -t92;
        }
        ::mstmm::generated::finite::<T>(&[state.q.as_slice(), state.v.as_slice()])?;
        ::mstmm::generated::require(regular0, "joint")?;
        ::mstmm::generated::regular::<T, _, _>(&[], [], [], [])?;
        ::mstmm::generated::finite::<T>(&[results0.as_slice()])?;
        accelerations.data.0 = [results0];
        ::core::result::Result::Ok(())
    }
    /// The accelerations `v̇` of all hinges, in the order of the rates: the fast path.
    ///
    /// 87 operations: 47 mul, 39 add, 1 reciprocal, 2 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `hook` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 1 |
    /// | Results |  | 3 | 2 | 0 | 0 | 0 |
    /// | Motion across `joint` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 1 |
    /// | Motion across `end_of_repeat0` | \[P, Eqs. (1), (13), (36)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Results |  | 4 | 1 | 0 | 0 | 0 |
    /// | Motion across `hook` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `hook` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Results |  | 2 | 0 | 0 | 0 | 0 |
    /// | Riccati transfer over `joint` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 8 | 9 | 1 | 0 | 0 |
    /// | Results |  | 16 | 16 | 0 | 0 | 0 |
    /// | Acceleration of `joint` | \[P, Eqs. (13), (36), (44)\] | 6 | 4 | 0 | 0 | 0 |
    /// | Acceleration of `end_of_repeat0` | \[P, Eqs. (13), (36), (44)\] | 1 | 2 | 0 | 0 | 0 |
    /// | Results |  | 0 | 1 | 0 | 0 | 0 |
    /// | Acceleration of `hook` | \[P, Eqs. (13), (36), (44)\] | 3 | 1 | 0 | 0 | 0 |
    /// | Results |  | 0 | 1 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// [`Error::Singular`](::mstmm::Error::Singular) if nothing with inertia lies beyond a
    /// hinge, [`Error::NotFinite`](::mstmm::Error::NotFinite) if a number of the state or the
    /// inputs is not finite. `accelerations` is not touched then.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn accelerations_into(
        &self,
        state: &RopeState<T>,
        inputs: &RopeInputs<T>,
        accelerations: &mut ::mstmm::nalgebra::SVector<T, 11>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let c = T::constant;
        let [hook_angle] = ::mstmm::generated::piece::<T, 1>(state.q.as_slice(), 10);
        let [hook_rate] = ::mstmm::generated::piece::<T, 1>(state.v.as_slice(), 10);
        let mut results0 = [T::constant(0.0); 11];
        let mut regular0 = <T::Mask as ::mstmm::Mask>::splat(true);
        let mut store1 = [[T::constant(0.0); 5]; 10];
        let mut store3 = [[T::constant(0.0); 3]; 10];
        /// Motion across `hook`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 1 sin/cos.
        let ([sin_hook_angle], [cos_hook_angle]) = T::sin_cos([hook_angle]);
        /// Results: 3 mul, 2 add, 0 reciprocal.
        let t0 = sin_hook_angle * c(1.3333333333333333);
        let t1 = sin_hook_angle * t0;
        let t2 = cos_hook_angle * t0;
        let t3 = t1 + c(0.6666666666666667);
        let t4 = t1 - c(2.0);
        let mut carry0_0 = c(0.0);
        for (
            (
                (&[joint_angle], &[joint_rate]),
                &[known_knot,
                known_p1,
                known_p2,
                known_p3,
                known_p4,
                known_p5,
                ],
            ),
            store,
        ) in ::mstmm::generated::times::<T, 1>(state.q.as_slice(), 0, 10)
            .iter()
            .zip(::mstmm::generated::times::<T, 1>(state.v.as_slice(), 0, 10).iter())
            .zip(
                ::mstmm::generated::times::<T, 6>(self.derived0.as_slice(), 0, 10).iter(),
            )
            .zip(store1.iter_mut())
        {
            let carry0_0_before = carry0_0;
            /// Motion across `joint`, [P, Eqs. (1), (13), (36)]: 0 mul, 1 add, 0 reciprocal, 1 sin/cos.
            let ([sin_joint_angle], [cos_joint_angle]) = T::sin_cos([joint_angle]);
            let joint_omega_z = joint_rate + carry0_0_before;
            /// Motion across `end_of_repeat0`, [P, Eqs. (1), (13), (36)]: 2 mul, 0 add, 0 reciprocal.
            let t5 = c(0.1) * joint_omega_z;
            let minus_end_of_repeat0_drift_lin_x = joint_omega_z * t5;
            /// Results: 4 mul, 1 add, 0 reciprocal.
            let t6 = joint_angle * c(0.2);
            let t7 = joint_rate * c(0.01);
            let t8 = t6 + t7;
            let t9 = known_p2 * joint_omega_z;
            let t10 = joint_omega_z * t9;
            *store = [
                sin_joint_angle,
                cos_joint_angle,
                t8,
                minus_end_of_repeat0_drift_lin_x,
                t10,
            ];
            (carry0_0,) = (joint_omega_z,);
        }
        /// Motion across `hook`, [P, Eqs. (1), (13), (36)]: 0 mul, 1 add, 0 reciprocal.
        let hook_omega_z = hook_rate + carry0_0;
        /// Riccati transfer over `hook`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 0 add, 0 reciprocal.
        let t11 = c(0.2) * hook_omega_z;
        let hook_e_force_y = hook_omega_z * t11;
        /// Results: 2 mul, 0 add, 0 reciprocal.
        let t12 = sin_hook_angle * hook_e_force_y;
        let t13 = cos_hook_angle * hook_e_force_y;
        let mut carry1_0 = t3;
        let mut carry1_1 = -t4;
        let mut carry1_2 = c(2.0);
        let mut carry1_3 = -t2;
        let mut carry1_4 = -t12;
        let mut carry1_5 = t13;
        let mut carry1_6 = c(0.0);
        for (
            (
                &[_,
                known_p1,
                known_p2,
                _,
                known_p4,
                known_p5,
                ],
                &[sin_joint_angle,
                cos_joint_angle,
                t8,
                minus_end_of_repeat0_drift_lin_x,
                t10,
                ],
            ),
            store,
        ) in ::mstmm::generated::times::<T, 6>(self.derived0.as_slice(), 0, 10)
            .iter()
            .zip(store1.iter())
            .zip(store3.iter_mut())
            .rev()
        {
            let carry1_0_before = carry1_0;
            let carry1_1_before = carry1_1;
            let carry1_2_before = carry1_2;
            let carry1_3_before = carry1_3;
            let carry1_4_before = carry1_4;
            let carry1_5_before = carry1_5;
            let carry1_6_before = carry1_6;
            /// Riccati transfer over `joint`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 8 mul, 9 add, 1 reciprocal.
            let joint_k_xx = known_p1 + carry1_0_before;
            let joint_k_yy = known_p1 + carry1_1_before;
            let joint_k_zz = known_p1 + carry1_2_before;
            let joint_b_x_z = c(0.1) * carry1_3_before;
            let t14 = c(0.1) * carry1_1_before;
            let joint_b_y_z = known_p2 + t14;
            let t15 = carry1_1_before * c(0.010000000000000002);
            let joint_j_zz = known_p4 + t15;
            let t16 = carry1_0_before * minus_end_of_repeat0_drift_lin_x;
            let t17 = carry1_4_before - t16;
            let minus_joint_e_force_x = t10 - t17;
            let t18 = carry1_3_before * minus_end_of_repeat0_drift_lin_x;
            let joint_e_force_y = carry1_5_before - t18;
            let t19 = c(0.1) * joint_e_force_y;
            let joint_e_moment_z = carry1_6_before + t19;
            let t20 = T::recip(joint_j_zz);
            let joint_z0_force_x = joint_b_x_z * t20;
            let joint_z0_force_y = joint_b_y_z * t20;
            /// Results: 16 mul, 16 add, 0 reciprocal.
            let t21 = carry1_0_before + carry1_1_before;
            let t22 = carry1_2_before + t21;
            let t23 = c(0.010000000000000002) * t22;
            let t24 = known_p5 + t23;
            let t25 = t8 + joint_e_moment_z;
            let t26 = t20 * t25;
            let t27 = joint_b_x_z * joint_z0_force_x;
            let t28 = joint_k_xx - t27;
            let t29 = joint_b_y_z * joint_z0_force_y;
            let t30 = joint_k_yy - t29;
            let t31 = joint_b_y_z * joint_z0_force_x;
            let t32 = carry1_3_before - t31;
            let t33 = joint_b_x_z * t26;
            let t34 = minus_joint_e_force_x + t33;
            let t35 = joint_b_y_z * t26;
            let t36 = joint_e_force_y - t35;
            let t37 = t28 - t30;
            let t38 = sin_joint_angle * t37;
            let t39 = c(2.0) * t32;
            let t40 = cos_joint_angle * t39;
            let t41 = t38 + t40;
            let t42 = sin_joint_angle * t41;
            let t43 = cos_joint_angle * t41;
            let t44 = t28 - t42;
            let t45 = t32 - t43;
            let t46 = t30 + t42;
            let t47 = cos_joint_angle * t34;
            let t48 = sin_joint_angle * t36;
            let t49 = t47 + t48;
            let t50 = sin_joint_angle * t34;
            let t51 = cos_joint_angle * t36;
            let t52 = t50 - t51;
            *store = [t26, joint_z0_force_x, joint_z0_force_y];
            regular0 = regular0 & !::mstmm::generated::vanishes(joint_j_zz, t24);
            (carry1_0, carry1_1, carry1_2, carry1_3, carry1_4, carry1_5, carry1_6) = (
                t44,
                t46,
                joint_k_zz,
                -t45,
                -t49,
                -t52,
                -t8,
            );
        }
        let mut carry2_0 = c(0.0);
        let mut carry2_1 = c(9.8);
        let mut carry2_2 = c(0.0);
        for (
            (
                &[sin_joint_angle,
                cos_joint_angle,
                _,
                minus_end_of_repeat0_drift_lin_x,
                _,
                ],
                &[t26,
                joint_z0_force_x,
                joint_z0_force_y,
                ],
            ),
            [o0_0,
            ],
        ) in store1
            .iter()
            .zip(store3.iter())
            .zip(
                ::mstmm::generated::times_mut::<T, 1>(results0.as_mut_slice(), 0, 10)
                    .iter_mut(),
            )
        {
            let carry2_0_before = carry2_0;
            let carry2_1_before = carry2_1;
            let carry2_2_before = carry2_2;
            /// Acceleration of `joint`, [P, Eqs. (13), (36), (44)]: 6 mul, 4 add, 0 reciprocal.
            let t53 = cos_joint_angle * carry2_0_before;
            let t54 = sin_joint_angle * carry2_1_before;
            let joint_a_lin_x = t53 + t54;
            let t55 = sin_joint_angle * carry2_0_before;
            let t56 = cos_joint_angle * carry2_1_before;
            let minus_joint_a_lin_y = t55 - t56;
            let t57 = joint_z0_force_x * joint_a_lin_x;
            let t58 = joint_z0_force_y * minus_joint_a_lin_y;
            let t59 = t57 - t58;
            let minus_joint_a_ang_z = t26 + t59;
            /// Acceleration of `end_of_repeat0`, [P, Eqs. (13), (36), (44)]: 1 mul, 2 add, 0 reciprocal.
            let minus_end_of_repeat0_a_lin_x = minus_end_of_repeat0_drift_lin_x
                - joint_a_lin_x;
            let t60 = c(0.1) * minus_joint_a_ang_z;
            let minus_end_of_repeat0_a_lin_y = minus_joint_a_lin_y + t60;
            /// Results: 0 mul, 1 add, 0 reciprocal.
            let t61 = carry2_2_before + minus_joint_a_ang_z;
            *o0_0 = -t61;
            (carry2_0, carry2_1, carry2_2) = (
                -minus_end_of_repeat0_a_lin_x,
                -minus_end_of_repeat0_a_lin_y,
                -minus_joint_a_ang_z,
            );
        }
        /// Acceleration of `hook`, [P, Eqs. (13), (36), (44)]: 3 mul, 1 add, 0 reciprocal.
        let t62 = cos_hook_angle * carry2_0;
        let t63 = sin_hook_angle * carry2_1;
        let hook_a_lin_x = t62 + t63;
        let minus_hook_a_ang_z = hook_a_lin_x * c(6.666666666666666);
        /// Results: 0 mul, 1 add, 0 reciprocal.
        let t64 = carry2_2 + minus_hook_a_ang_z;
        for [o0] in ::mstmm::generated::times_mut::<T, 1>(results0.as_mut_slice(), 10, 1)
            .iter_mut()
        {
            *o0 = -t64;
        }
        ::mstmm::generated::finite::<T>(&[state.q.as_slice(), state.v.as_slice()])?;
        ::mstmm::generated::require(regular0, "joint")?;
        ::mstmm::generated::regular::<T, _, _>(&[], [], [], [])?;
        ::mstmm::generated::finite::<T>(&[results0.as_slice()])?;
        accelerations.data.0 = [results0];
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
        state: &RopeState<T>,
        inputs: &RopeInputs<T>,
    ) -> ::core::result::Result<::mstmm::nalgebra::SVector<T, 11>, ::mstmm::Error> {
        let mut accelerations = ::mstmm::generated::vector([T::constant(0.0); 11]);
        self.accelerations_into(state, inputs, &mut accelerations)?;
        ::core::result::Result::Ok(accelerations)
    }
    /// Everything: accelerations, efforts, energies and, at every connection point, pose,
    /// velocity and the state vector `z`, written into `at`.
    ///
    /// 247 operations: 141 mul, 105 add, 1 reciprocal, 2 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `hook` | \[P, Eqs. (1), (13), (36)\] | 0 | 0 | 0 | 0 | 1 |
    /// | Results |  | 3 | 2 | 0 | 0 | 0 |
    /// | Motion across `joint` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 1 |
    /// | Motion across `end_of_repeat0` | \[P, Eqs. (1), (13), (36)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Load on `joint` | \[P, Eqs. (18), (19)\] | 2 | 1 | 0 | 0 | 0 |
    /// | Results |  | 4 | 0 | 0 | 0 | 0 |
    /// | Motion across `hook` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Riccati transfer over `hook` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Results |  | 2 | 0 | 0 | 0 | 0 |
    /// | Riccati transfer over `joint` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 8 | 9 | 1 | 0 | 0 |
    /// | Results |  | 16 | 16 | 0 | 0 | 0 |
    /// | Acceleration of `joint` | \[P, Eqs. (13), (36), (44)\] | 6 | 4 | 0 | 0 | 0 |
    /// | Acceleration of `end_of_repeat0` | \[P, Eqs. (13), (36), (44)\] | 1 | 2 | 0 | 0 | 0 |
    /// | Results |  | 0 | 1 | 0 | 0 | 0 |
    /// | Acceleration of `hook` | \[P, Eqs. (13), (36), (44)\] | 3 | 1 | 0 | 0 | 0 |
    /// | Results |  | 0 | 1 | 0 | 0 | 0 |
    /// | Motion across `joint` | \[P, Eqs. (1), (13), (36)\] | 8 | 5 | 0 | 0 | 0 |
    /// | Motion across `end_of_repeat0` | \[P, Eqs. (1), (13), (36)\] | 6 | 0 | 0 | 0 | 0 |
    /// | Motion across `hook` | \[P, Eqs. (1), (13), (36)\] | 8 | 5 | 0 | 0 | 0 |
    /// | Results |  | 0 | 4 | 0 | 0 | 0 |
    /// | Point of `joint` | \[P, Eqs. (12), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Point of `end_of_repeat0` | \[P, Eqs. (12), (13), (36)\] | 2 | 4 | 0 | 0 | 0 |
    /// | Point of `hook` | \[P, Eqs. (12), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Motion across `joint` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Motion across `end_of_repeat0` | \[P, Eqs. (1), (13), (36)\] | 2 | 0 | 0 | 0 | 0 |
    /// | Results |  | 2 | 0 | 0 | 0 | 0 |
    /// | Motion across `hook` | \[P, Eqs. (1), (13), (36)\] | 0 | 1 | 0 | 0 | 0 |
    /// | Results |  | 2 | 0 | 0 | 0 | 0 |
    /// | Load of the body at `joint` | \[P, Eqs. (18), (19)\] | 11 | 7 | 0 | 0 | 0 |
    /// | Results |  | 1 | 2 | 0 | 0 | 0 |
    /// | Load of the body at `hook` | \[P, Eqs. (18), (19)\] | 11 | 7 | 0 | 0 | 0 |
    /// | Load on `joint` | \[P, Eqs. (18), (19)\] | 0 | 2 | 0 | 0 | 0 |
    /// | Motion across `joint` | \[P, Eqs. (1), (13), (36)\] | 8 | 5 | 0 | 0 | 0 |
    /// | Results |  | 10 | 0 | 0 | 0 | 0 |
    /// | Motion across `hook` | \[P, Eqs. (1), (13), (36)\] | 4 | 3 | 0 | 0 | 0 |
    /// | Results |  | 6 | 0 | 0 | 0 | 0 |
    /// | Results |  | 6 | 8 | 0 | 0 | 0 |
    /// | Results |  | 5 | 5 | 0 | 0 | 0 |
    /// | Results |  | 0 | 3 | 0 | 0 | 0 |
    /// | Results |  | 0 | 2 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// As [`accelerations_into`](Self::accelerations_into); `at` is not touched then.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn solve_into(
        &self,
        state: &RopeState<T>,
        inputs: &RopeInputs<T>,
        at: &mut RopeWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let c = T::constant;
        let [hook_angle] = ::mstmm::generated::piece::<T, 1>(state.q.as_slice(), 10);
        let [hook_rate] = ::mstmm::generated::piece::<T, 1>(state.v.as_slice(), 10);
        let mut results0 = [T::constant(0.0); 11];
        let mut results3 = [T::constant(0.0); 11];
        let mut results4 = [T::constant(0.0); 11];
        let mut results7 = [T::constant(0.0); 299];
        let mut regular0 = <T::Mask as ::mstmm::Mask>::splat(true);
        let mut store1 = [[T::constant(0.0); 6]; 10];
        let mut store3 = [[T::constant(0.0); 3]; 10];
        let mut store4 = [[T::constant(0.0); 1]; 10];
        let mut store6 = [[T::constant(0.0); 10]; 10];
        let mut store11 = [[T::constant(0.0); 2]; 10];
        let mut store13 = [[T::constant(0.0); 2]; 10];
        let mut store16 = [[T::constant(0.0); 7]; 10];
        let mut store18 = [[T::constant(0.0); 2]; 10];
        /// Motion across `hook`, [P, Eqs. (1), (13), (36)]: 0 mul, 0 add, 0 reciprocal, 1 sin/cos.
        let ([sin_hook_angle], [cos_hook_angle]) = T::sin_cos([hook_angle]);
        /// Results: 3 mul, 2 add, 0 reciprocal.
        let t0 = sin_hook_angle * c(1.3333333333333333);
        let t1 = sin_hook_angle * t0;
        let t2 = cos_hook_angle * t0;
        let t3 = t1 + c(0.6666666666666667);
        let t4 = t1 - c(2.0);
        let mut carry0_0 = c(0.0);
        for (
            (
                (
                    (&[joint_angle], &[joint_rate]),
                    &[known_knot,
                    known_p1,
                    known_p2,
                    known_p3,
                    known_p4,
                    known_p5,
                    ],
                ),
                store,
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
            o7_23,
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
            ],
        ) in ::mstmm::generated::times::<T, 1>(state.q.as_slice(), 0, 10)
            .iter()
            .zip(::mstmm::generated::times::<T, 1>(state.v.as_slice(), 0, 10).iter())
            .zip(
                ::mstmm::generated::times::<T, 6>(self.derived0.as_slice(), 0, 10).iter(),
            )
            .zip(store1.iter_mut())
            .zip(
                ::mstmm::generated::times_mut::<T, 26>(results7.as_mut_slice(), 13, 10)
                    .iter_mut(),
            )
        {
            let carry0_0_before = carry0_0;
            /// Motion across `joint`, [P, Eqs. (1), (13), (36)]: 0 mul, 1 add, 0 reciprocal, 1 sin/cos.
            let ([sin_joint_angle], [cos_joint_angle]) = T::sin_cos([joint_angle]);
            let joint_omega_z = joint_rate + carry0_0_before;
            /// Motion across `end_of_repeat0`, [P, Eqs. (1), (13), (36)]: 2 mul, 0 add, 0 reciprocal.
            let t5 = c(0.1) * joint_omega_z;
            let minus_end_of_repeat0_drift_lin_x = joint_omega_z * t5;
            /// Load on `joint`, [P, Eqs. (18), (19)]: 2 mul, 1 add, 0 reciprocal.
            let t6 = joint_angle * c(0.2);
            let t7 = joint_rate * c(0.01);
            let minus_joint_load_moment_z = t6 + t7;
            /// Results: 4 mul, 0 add, 0 reciprocal.
            let t8 = joint_angle * t6;
            let t9 = t8 * c(0.5);
            let t10 = known_p2 * joint_omega_z;
            let t11 = joint_omega_z * t10;
            *store = [
                sin_joint_angle,
                cos_joint_angle,
                minus_joint_load_moment_z,
                minus_end_of_repeat0_drift_lin_x,
                t11,
                t9,
            ];
            *o7_23 = minus_joint_load_moment_z;
            (carry0_0,) = (joint_omega_z,);
        }
        /// Motion across `hook`, [P, Eqs. (1), (13), (36)]: 0 mul, 1 add, 0 reciprocal.
        let hook_omega_z = hook_rate + carry0_0;
        /// Riccati transfer over `hook`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 2 mul, 0 add, 0 reciprocal.
        let t12 = c(0.2) * hook_omega_z;
        let hook_e_force_y = hook_omega_z * t12;
        /// Results: 2 mul, 0 add, 0 reciprocal.
        let t13 = sin_hook_angle * hook_e_force_y;
        let t14 = cos_hook_angle * hook_e_force_y;
        let mut carry1_0 = t3;
        let mut carry1_1 = -t4;
        let mut carry1_2 = c(2.0);
        let mut carry1_3 = -t2;
        let mut carry1_4 = -t13;
        let mut carry1_5 = t14;
        let mut carry1_6 = c(0.0);
        for (
            (
                &[_,
                known_p1,
                known_p2,
                _,
                known_p4,
                known_p5,
                ],
                &[sin_joint_angle,
                cos_joint_angle,
                minus_joint_load_moment_z,
                minus_end_of_repeat0_drift_lin_x,
                t11,
                _,
                ],
            ),
            store,
        ) in ::mstmm::generated::times::<T, 6>(self.derived0.as_slice(), 0, 10)
            .iter()
            .zip(store1.iter())
            .zip(store3.iter_mut())
            .rev()
        {
            let carry1_0_before = carry1_0;
            let carry1_1_before = carry1_1;
            let carry1_2_before = carry1_2;
            let carry1_3_before = carry1_3;
            let carry1_4_before = carry1_4;
            let carry1_5_before = carry1_5;
            let carry1_6_before = carry1_6;
            /// Riccati transfer over `joint`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 8 mul, 9 add, 1 reciprocal.
            let joint_k_xx = known_p1 + carry1_0_before;
            let joint_k_yy = known_p1 + carry1_1_before;
            let joint_k_zz = known_p1 + carry1_2_before;
            let joint_b_x_z = c(0.1) * carry1_3_before;
            let t15 = c(0.1) * carry1_1_before;
            let joint_b_y_z = known_p2 + t15;
            let t16 = carry1_1_before * c(0.010000000000000002);
            let joint_j_zz = known_p4 + t16;
            let t17 = carry1_0_before * minus_end_of_repeat0_drift_lin_x;
            let t18 = carry1_4_before - t17;
            let minus_joint_e_force_x = t11 - t18;
            let t19 = carry1_3_before * minus_end_of_repeat0_drift_lin_x;
            let joint_e_force_y = carry1_5_before - t19;
            let t20 = c(0.1) * joint_e_force_y;
            let joint_e_moment_z = carry1_6_before + t20;
            let t21 = T::recip(joint_j_zz);
            let joint_z0_force_x = joint_b_x_z * t21;
            let joint_z0_force_y = joint_b_y_z * t21;
            /// Results: 16 mul, 16 add, 0 reciprocal.
            let t22 = carry1_0_before + carry1_1_before;
            let t23 = carry1_2_before + t22;
            let t24 = c(0.010000000000000002) * t23;
            let t25 = known_p5 + t24;
            let t26 = minus_joint_load_moment_z + joint_e_moment_z;
            let t27 = t21 * t26;
            let t28 = joint_b_x_z * joint_z0_force_x;
            let t29 = joint_k_xx - t28;
            let t30 = joint_b_y_z * joint_z0_force_y;
            let t31 = joint_k_yy - t30;
            let t32 = joint_b_y_z * joint_z0_force_x;
            let t33 = carry1_3_before - t32;
            let t34 = joint_b_x_z * t27;
            let t35 = minus_joint_e_force_x + t34;
            let t36 = joint_b_y_z * t27;
            let t37 = joint_e_force_y - t36;
            let t38 = t29 - t31;
            let t39 = sin_joint_angle * t38;
            let t40 = c(2.0) * t33;
            let t41 = cos_joint_angle * t40;
            let t42 = t39 + t41;
            let t43 = sin_joint_angle * t42;
            let t44 = cos_joint_angle * t42;
            let t45 = t29 - t43;
            let t46 = t33 - t44;
            let t47 = t31 + t43;
            let t48 = cos_joint_angle * t35;
            let t49 = sin_joint_angle * t37;
            let t50 = t48 + t49;
            let t51 = sin_joint_angle * t35;
            let t52 = cos_joint_angle * t37;
            let t53 = t51 - t52;
            *store = [t27, joint_z0_force_x, joint_z0_force_y];
            regular0 = regular0 & !::mstmm::generated::vanishes(joint_j_zz, t25);
            (carry1_0, carry1_1, carry1_2, carry1_3, carry1_4, carry1_5, carry1_6) = (
                t45,
                t47,
                joint_k_zz,
                -t46,
                -t50,
                -t53,
                -minus_joint_load_moment_z,
            );
        }
        let mut carry2_0 = c(0.0);
        let mut carry2_1 = c(9.8);
        let mut carry2_2 = c(0.0);
        for (
            (
                (
                    (
                        &[sin_joint_angle,
                        cos_joint_angle,
                        _,
                        minus_end_of_repeat0_drift_lin_x,
                        _,
                        _,
                        ],
                        &[t27,
                        joint_z0_force_x,
                        joint_z0_force_y,
                        ],
                    ),
                    store,
                ),
                [o0_0,
                ],
            ),
            [o3_0,
            ],
        ) in store1
            .iter()
            .zip(store3.iter())
            .zip(store4.iter_mut())
            .zip(
                ::mstmm::generated::times_mut::<T, 1>(results0.as_mut_slice(), 0, 10)
                    .iter_mut(),
            )
            .zip(
                ::mstmm::generated::times_mut::<T, 1>(results3.as_mut_slice(), 0, 10)
                    .iter_mut(),
            )
        {
            let carry2_0_before = carry2_0;
            let carry2_1_before = carry2_1;
            let carry2_2_before = carry2_2;
            /// Acceleration of `joint`, [P, Eqs. (13), (36), (44)]: 6 mul, 4 add, 0 reciprocal.
            let t54 = cos_joint_angle * carry2_0_before;
            let t55 = sin_joint_angle * carry2_1_before;
            let joint_a_lin_x = t54 + t55;
            let t56 = sin_joint_angle * carry2_0_before;
            let t57 = cos_joint_angle * carry2_1_before;
            let minus_joint_a_lin_y = t56 - t57;
            let t58 = joint_z0_force_x * joint_a_lin_x;
            let t59 = joint_z0_force_y * minus_joint_a_lin_y;
            let t60 = t58 - t59;
            let minus_joint_a_ang_z = t27 + t60;
            /// Acceleration of `end_of_repeat0`, [P, Eqs. (13), (36), (44)]: 1 mul, 2 add, 0 reciprocal.
            let minus_end_of_repeat0_a_lin_x = minus_end_of_repeat0_drift_lin_x
                - joint_a_lin_x;
            let t61 = c(0.1) * minus_joint_a_ang_z;
            let minus_end_of_repeat0_a_lin_y = minus_joint_a_lin_y + t61;
            /// Results: 0 mul, 1 add, 0 reciprocal.
            let t62 = carry2_2_before + minus_joint_a_ang_z;
            *store = [t62];
            *o0_0 = -t62;
            *o3_0 = -t62;
            (carry2_0, carry2_1, carry2_2) = (
                -minus_end_of_repeat0_a_lin_x,
                -minus_end_of_repeat0_a_lin_y,
                -minus_joint_a_ang_z,
            );
        }
        /// Acceleration of `hook`, [P, Eqs. (13), (36), (44)]: 3 mul, 1 add, 0 reciprocal.
        let t63 = cos_hook_angle * carry2_0;
        let t64 = sin_hook_angle * carry2_1;
        let hook_a_lin_x = t63 + t64;
        let minus_hook_a_ang_z = hook_a_lin_x * c(6.666666666666666);
        /// Results: 0 mul, 1 add, 0 reciprocal.
        let t65 = carry2_2 + minus_hook_a_ang_z;
        let mut carry3_0 = c(1.0);
        let mut carry3_1 = c(0.0);
        let mut carry3_2 = c(0.0);
        let mut carry3_3 = c(1.0);
        let mut carry3_4 = c(0.0);
        for (
            ((&[joint_rate], &[sin_joint_angle, cos_joint_angle, _, _, _, _]), store),
            [_,
            _,
            o7_15,
            o7_16,
            _,
            _,
            o7_19,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            o7_28,
            o7_29,
            _,
            _,
            o7_32,
            _,
            _,
            _,
            _,
            _,
            _,
            ],
        ) in ::mstmm::generated::times::<T, 1>(state.v.as_slice(), 0, 10)
            .iter()
            .zip(store1.iter())
            .zip(store6.iter_mut())
            .zip(
                ::mstmm::generated::times_mut::<T, 26>(results7.as_mut_slice(), 13, 10)
                    .iter_mut(),
            )
        {
            let carry3_0_before = carry3_0;
            let carry3_1_before = carry3_1;
            let carry3_2_before = carry3_2;
            let carry3_3_before = carry3_3;
            let carry3_4_before = carry3_4;
            /// Motion across `joint`, [P, Eqs. (1), (13), (36)]: 8 mul, 5 add, 0 reciprocal.
            let t66 = cos_joint_angle * carry3_0_before;
            let t67 = sin_joint_angle * carry3_1_before;
            let joint_axes_x_x = t66 + t67;
            let t68 = sin_joint_angle * carry3_0_before;
            let t69 = cos_joint_angle * carry3_1_before;
            let minus_joint_axes_x_y = t68 - t69;
            let t70 = cos_joint_angle * carry3_2_before;
            let t71 = sin_joint_angle * carry3_3_before;
            let joint_axes_y_x = t70 + t71;
            let t72 = sin_joint_angle * carry3_2_before;
            let t73 = cos_joint_angle * carry3_3_before;
            let minus_joint_axes_y_y = t72 - t73;
            let joint_omega_z_2 = joint_rate + carry3_4_before;
            /// Motion across `end_of_repeat0`, [P, Eqs. (1), (13), (36)]: 6 mul, 0 add, 0 reciprocal.
            let t74 = c(0.1) * joint_axes_x_x;
            let t75 = joint_omega_z_2 * t74;
            let minus_end_of_repeat0_drift_lin_x_2 = joint_omega_z_2 * t75;
            let t76 = c(0.1) * joint_axes_y_x;
            let t77 = joint_omega_z_2 * t76;
            let minus_end_of_repeat0_drift_lin_y = joint_omega_z_2 * t77;
            *store = [
                t74,
                t76,
                t77,
                t75,
                minus_end_of_repeat0_drift_lin_x_2,
                minus_end_of_repeat0_drift_lin_y,
                joint_axes_x_x,
                minus_joint_axes_x_y,
                joint_axes_y_x,
                minus_joint_axes_y_y,
            ];
            *o7_15 = joint_axes_x_x;
            *o7_16 = joint_axes_y_x;
            *o7_19 = joint_omega_z_2;
            *o7_28 = joint_axes_x_x;
            *o7_29 = joint_axes_y_x;
            *o7_32 = joint_omega_z_2;
            (carry3_0, carry3_1, carry3_2, carry3_3, carry3_4) = (
                joint_axes_x_x,
                -minus_joint_axes_x_y,
                joint_axes_y_x,
                -minus_joint_axes_y_y,
                joint_omega_z_2,
            );
        }
        /// Motion across `hook`, [P, Eqs. (1), (13), (36)]: 8 mul, 5 add, 0 reciprocal.
        let t78 = cos_hook_angle * carry3_0;
        let t79 = sin_hook_angle * carry3_1;
        let hook_axes_x_x = t78 + t79;
        let t80 = sin_hook_angle * carry3_0;
        let t81 = cos_hook_angle * carry3_1;
        let minus_hook_axes_x_y = t80 - t81;
        let t82 = cos_hook_angle * carry3_2;
        let t83 = sin_hook_angle * carry3_3;
        let hook_axes_y_x = t82 + t83;
        let t84 = sin_hook_angle * carry3_2;
        let t85 = cos_hook_angle * carry3_3;
        let minus_hook_axes_y_y = t84 - t85;
        let hook_omega_z_2 = hook_rate + carry3_4;
        let mut carry4_0 = c(0.0);
        let mut carry4_1 = c(0.0);
        let mut carry4_2 = c(0.0);
        let mut carry4_3 = c(0.0);
        for (
            &[t74,
            t76,
            t77,
            t75,
            _,
            _,
            _,
            _,
            _,
            _,
            ],
            [o7_13,
            o7_14,
            _,
            _,
            o7_17,
            o7_18,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            o7_26,
            o7_27,
            _,
            _,
            o7_30,
            o7_31,
            _,
            _,
            _,
            _,
            _,
            _,
            _,
            ],
        ) in store6
            .iter()
            .zip(
                ::mstmm::generated::times_mut::<T, 26>(results7.as_mut_slice(), 13, 10)
                    .iter_mut(),
            )
        {
            let carry4_0_before = carry4_0;
            let carry4_1_before = carry4_1;
            let carry4_2_before = carry4_2;
            let carry4_3_before = carry4_3;
            /// Results: 0 mul, 4 add, 0 reciprocal.
            let t86 = t77 - carry4_2_before;
            let t87 = t75 + carry4_3_before;
            let t88 = t74 + carry4_0_before;
            let t89 = t76 + carry4_1_before;
            *o7_13 = carry4_0_before;
            *o7_14 = carry4_1_before;
            *o7_17 = carry4_2_before;
            *o7_18 = carry4_3_before;
            *o7_26 = t88;
            *o7_27 = t89;
            *o7_30 = -t86;
            *o7_31 = t87;
            (carry4_0, carry4_1, carry4_2, carry4_3) = (t88, t89, -t86, t87);
        }
        let mut carry5_0 = c(0.0);
        let mut carry5_1 = c(0.0);
        let mut carry5_2 = c(0.0);
        for (
            (
                &[t62,
                ],
                &[t74,
                t76,
                _,
                _,
                minus_end_of_repeat0_drift_lin_x_2,
                minus_end_of_repeat0_drift_lin_y,
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
            o7_20,
            o7_21,
            o7_22,
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
            o7_33,
            o7_34,
            o7_35,
            _,
            _,
            _,
            ],
        ) in store4
            .iter()
            .zip(store6.iter())
            .zip(
                ::mstmm::generated::times_mut::<T, 26>(results7.as_mut_slice(), 13, 10)
                    .iter_mut(),
            )
        {
            let carry5_0_before = carry5_0;
            let carry5_1_before = carry5_1;
            let carry5_2_before = carry5_2;
            /// Point of `joint`, [P, Eqs. (12), (13), (36)]: 0 mul, 1 add, 0 reciprocal.
            let minus_joint_acc_ang_z = t62 - carry5_2_before;
            /// Point of `end_of_repeat0`, [P, Eqs. (12), (13), (36)]: 2 mul, 4 add, 0 reciprocal.
            let t90 = t76 * minus_joint_acc_ang_z;
            let t91 = carry5_0_before + t90;
            let minus_end_of_repeat0_acc_lin_x = minus_end_of_repeat0_drift_lin_x_2
                - t91;
            let t92 = t74 * minus_joint_acc_ang_z;
            let t93 = carry5_1_before - t92;
            let minus_end_of_repeat0_acc_lin_y = minus_end_of_repeat0_drift_lin_y - t93;
            *o7_20 = carry5_0_before;
            *o7_21 = carry5_1_before;
            *o7_22 = -minus_joint_acc_ang_z;
            *o7_33 = -minus_end_of_repeat0_acc_lin_x;
            *o7_34 = -minus_end_of_repeat0_acc_lin_y;
            *o7_35 = -minus_joint_acc_ang_z;
            (carry5_0, carry5_1, carry5_2) = (
                -minus_end_of_repeat0_acc_lin_x,
                -minus_end_of_repeat0_acc_lin_y,
                -minus_joint_acc_ang_z,
            );
        }
        /// Point of `hook`, [P, Eqs. (12), (13), (36)]: 0 mul, 1 add, 0 reciprocal.
        let minus_hook_acc_ang_z = t65 - carry5_2;
        let mut carry6_0 = c(0.0);
        for ((&[joint_rate], &[_, _, known_p2, _, _, _]), store) in ::mstmm::generated::times::<
            T,
            1,
        >(state.v.as_slice(), 0, 10)
            .iter()
            .zip(
                ::mstmm::generated::times::<T, 6>(self.derived0.as_slice(), 0, 10).iter(),
            )
            .zip(store11.iter_mut())
        {
            let carry6_0_before = carry6_0;
            /// Motion across `joint`, [P, Eqs. (1), (13), (36)]: 0 mul, 1 add, 0 reciprocal.
            let joint_omega_z_3 = joint_rate + carry6_0_before;
            /// Motion across `end_of_repeat0`, [P, Eqs. (1), (13), (36)]: 2 mul, 0 add, 0 reciprocal.
            let t94 = c(0.1) * joint_omega_z_3;
            let minus_end_of_repeat0_drift_lin_x_3 = joint_omega_z_3 * t94;
            /// Results: 2 mul, 0 add, 0 reciprocal.
            let t95 = known_p2 * joint_omega_z_3;
            let t96 = joint_omega_z_3 * t95;
            *store = [minus_end_of_repeat0_drift_lin_x_3, t96];
            (carry6_0,) = (joint_omega_z_3,);
        }
        /// Motion across `hook`, [P, Eqs. (1), (13), (36)]: 0 mul, 1 add, 0 reciprocal.
        let hook_omega_z_3 = hook_rate + carry6_0;
        /// Results: 2 mul, 0 add, 0 reciprocal.
        let t97 = c(0.2) * hook_omega_z_3;
        let t98 = hook_omega_z_3 * t97;
        let mut carry7_0 = c(0.0);
        let mut carry7_1 = c(9.8);
        let mut carry7_2 = c(0.0);
        for (
            (
                (
                    (
                        (
                            &[_,
                            known_p1,
                            known_p2,
                            _,
                            _,
                            _,
                            ],
                            &[sin_joint_angle,
                            cos_joint_angle,
                            _,
                            _,
                            _,
                            _,
                            ],
                        ),
                        &[t62,
                        ],
                    ),
                    &[_,
                    _,
                    _,
                    _,
                    _,
                    _,
                    joint_axes_x_x,
                    minus_joint_axes_x_y,
                    joint_axes_y_x,
                    minus_joint_axes_y_y,
                    ],
                ),
                &[minus_end_of_repeat0_drift_lin_x_3,
                t96,
                ],
            ),
            store,
        ) in ::mstmm::generated::times::<T, 6>(self.derived0.as_slice(), 0, 10)
            .iter()
            .zip(store1.iter())
            .zip(store4.iter())
            .zip(store6.iter())
            .zip(store11.iter())
            .zip(store13.iter_mut())
        {
            let carry7_0_before = carry7_0;
            let carry7_1_before = carry7_1;
            let carry7_2_before = carry7_2;
            /// Load of the body at `joint`, [P, Eqs. (18), (19)]: 11 mul, 7 add, 0 reciprocal.
            let t99 = cos_joint_angle * carry7_0_before;
            let t100 = sin_joint_angle * carry7_1_before;
            let t101 = t99 + t100;
            let t102 = sin_joint_angle * carry7_0_before;
            let t103 = cos_joint_angle * carry7_1_before;
            let t104 = t102 - t103;
            let t105 = t62 - carry7_2_before;
            let t106 = known_p1 * t101;
            let t107 = known_p1 * t104;
            let t108 = known_p2 * t105;
            let t109 = t107 + t108;
            let t110 = t106 - t96;
            let t111 = joint_axes_x_x * t110;
            let t112 = minus_joint_axes_x_y * t109;
            let joint_own_force_x = t111 + t112;
            let t113 = joint_axes_y_x * t110;
            let t114 = minus_joint_axes_y_y * t109;
            let joint_own_force_y = t113 + t114;
            /// Results: 1 mul, 2 add, 0 reciprocal.
            let t115 = c(0.1) * t105;
            let t116 = t104 + t115;
            let t117 = minus_end_of_repeat0_drift_lin_x_3 - t101;
            *store = [joint_own_force_x, joint_own_force_y];
            (carry7_0, carry7_1, carry7_2) = (-t117, -t116, -t105);
        }
        /// Load of the body at `hook`, [P, Eqs. (18), (19)]: 11 mul, 7 add, 0 reciprocal.
        let t118 = cos_hook_angle * carry7_0;
        let t119 = sin_hook_angle * carry7_1;
        let t120 = t118 + t119;
        let t121 = sin_hook_angle * carry7_0;
        let t122 = cos_hook_angle * carry7_1;
        let t123 = t121 - t122;
        let t124 = t65 - carry7_2;
        let t125 = c(2.0) * t120;
        let t126 = c(2.0) * t123;
        let t127 = c(0.2) * t124;
        let t128 = t125 - t127;
        let t129 = t126 - t98;
        let t130 = hook_axes_x_x * t128;
        let t131 = minus_hook_axes_x_y * t129;
        let hook_own_force_x = t130 + t131;
        let t132 = hook_axes_y_x * t128;
        let t133 = minus_hook_axes_y_y * t129;
        let hook_own_force_y = t132 + t133;
        let mut carry8_0 = hook_own_force_x;
        let mut carry8_1 = hook_own_force_y;
        let mut carry8_2 = c(0.0);
        for (
            (
                &[_,
                _,
                minus_joint_load_moment_z,
                _,
                _,
                _,
                ],
                &[joint_own_force_x,
                joint_own_force_y,
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
            o7_24,
            o7_25,
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
            o7_36,
            o7_37,
            o7_38,
            ],
        ) in store1
            .iter()
            .zip(store13.iter())
            .zip(
                ::mstmm::generated::times_mut::<T, 26>(results7.as_mut_slice(), 13, 10)
                    .iter_mut(),
            )
            .rev()
        {
            let carry8_0_before = carry8_0;
            let carry8_1_before = carry8_1;
            let carry8_2_before = carry8_2;
            /// Load on `joint`, [P, Eqs. (18), (19)]: 0 mul, 2 add, 0 reciprocal.
            let joint_load_force_x = joint_own_force_x + carry8_0_before;
            let joint_load_force_y = joint_own_force_y + carry8_1_before;
            *o7_24 = joint_load_force_x;
            *o7_25 = joint_load_force_y;
            *o7_36 = -carry8_2_before;
            *o7_37 = carry8_0_before;
            *o7_38 = carry8_1_before;
            (carry8_0, carry8_1, carry8_2) = (
                joint_load_force_x,
                joint_load_force_y,
                -minus_joint_load_moment_z,
            );
        }
        let mut carry9_0 = c(1.0);
        let mut carry9_1 = c(0.0);
        let mut carry9_2 = c(0.0);
        let mut carry9_3 = c(1.0);
        let mut carry9_4 = c(0.0);
        for ((&[joint_rate], &[sin_joint_angle, cos_joint_angle, _, _, _, _]), store) in ::mstmm::generated::times::<
            T,
            1,
        >(state.v.as_slice(), 0, 10)
            .iter()
            .zip(store1.iter())
            .zip(store16.iter_mut())
        {
            let carry9_0_before = carry9_0;
            let carry9_1_before = carry9_1;
            let carry9_2_before = carry9_2;
            let carry9_3_before = carry9_3;
            let carry9_4_before = carry9_4;
            /// Motion across `joint`, [P, Eqs. (1), (13), (36)]: 8 mul, 5 add, 0 reciprocal.
            let t134 = cos_joint_angle * carry9_0_before;
            let t135 = sin_joint_angle * carry9_1_before;
            let joint_axes_x_x_2 = t134 + t135;
            let t136 = sin_joint_angle * carry9_0_before;
            let t137 = cos_joint_angle * carry9_1_before;
            let minus_joint_axes_x_y_2 = t136 - t137;
            let t138 = cos_joint_angle * carry9_2_before;
            let t139 = sin_joint_angle * carry9_3_before;
            let joint_axes_y_x_2 = t138 + t139;
            let t140 = sin_joint_angle * carry9_2_before;
            let t141 = cos_joint_angle * carry9_3_before;
            let minus_joint_axes_y_y_2 = t140 - t141;
            let joint_omega_z_4 = joint_rate + carry9_4_before;
            /// Results: 10 mul, 0 add, 0 reciprocal.
            let t142 = c(0.1) * joint_axes_x_x_2;
            let t143 = c(0.1) * joint_axes_y_x_2;
            let t144 = joint_omega_z_4 * t143;
            let t145 = joint_omega_z_4 * t142;
            let t146 = c(0.05) * joint_axes_x_x_2;
            let t147 = c(0.05) * joint_axes_y_x_2;
            let t148 = joint_omega_z_4 * t147;
            let t149 = joint_omega_z_4 * t146;
            let t150 = c(0.0001) * joint_omega_z_4;
            let t151 = joint_omega_z_4 * t150;
            *store = [t143, t144, t145, t147, t148, t149, t151];
            (carry9_0, carry9_1, carry9_2, carry9_3, carry9_4) = (
                joint_axes_x_x_2,
                -minus_joint_axes_x_y_2,
                joint_axes_y_x_2,
                -minus_joint_axes_y_y_2,
                joint_omega_z_4,
            );
        }
        /// Motion across `hook`, [P, Eqs. (1), (13), (36)]: 4 mul, 3 add, 0 reciprocal.
        let t152 = sin_hook_angle * carry9_0;
        let t153 = cos_hook_angle * carry9_1;
        let minus_hook_axes_x_y_2 = t152 - t153;
        let t154 = sin_hook_angle * carry9_2;
        let t155 = cos_hook_angle * carry9_3;
        let minus_hook_axes_y_y_2 = t154 - t155;
        let hook_omega_z_4 = hook_rate + carry9_4;
        /// Results: 6 mul, 0 add, 0 reciprocal.
        let t156 = c(0.1) * minus_hook_axes_x_y_2;
        let t157 = c(0.1) * minus_hook_axes_y_y_2;
        let t158 = hook_omega_z_4 * t157;
        let t159 = hook_omega_z_4 * t156;
        let t160 = c(0.01) * hook_omega_z_4;
        let t161 = hook_omega_z_4 * t160;
        let mut carry10_0 = c(0.0);
        let mut carry10_1 = c(0.0);
        let mut carry10_2 = c(0.0);
        for (
            (&[_, known_p1, _, _, _, _], &[t143, t144, t145, t147, t148, t149, t151]),
            store,
        ) in ::mstmm::generated::times::<T, 6>(self.derived0.as_slice(), 0, 10)
            .iter()
            .zip(store16.iter())
            .zip(store18.iter_mut())
        {
            let carry10_0_before = carry10_0;
            let carry10_1_before = carry10_1;
            let carry10_2_before = carry10_2;
            /// Results: 6 mul, 8 add, 0 reciprocal.
            let t162 = t144 - carry10_1_before;
            let t163 = t145 + carry10_2_before;
            let t164 = t143 + carry10_0_before;
            let t165 = carry10_1_before - t148;
            let t166 = carry10_2_before + t149;
            let t167 = t165 * t165;
            let t168 = t166 * t166;
            let t169 = t167 + t168;
            let t170 = known_p1 * t169;
            let t171 = t151 + t170;
            let t172 = c(0.5) * t171;
            let t173 = carry10_0_before + t147;
            let t174 = c(9.8) * t173;
            let t175 = known_p1 * t174;
            *store = [t172, t175];
            (carry10_0, carry10_1, carry10_2) = (t164, -t162, t163);
        }
        /// Results: 5 mul, 5 add, 0 reciprocal.
        let t176 = carry10_1 - t158;
        let t177 = carry10_2 + t159;
        let t178 = t176 * t176;
        let t179 = t177 * t177;
        let t180 = t178 + t179;
        let t181 = c(2.0) * t180;
        let t182 = t161 + t181;
        let t183 = c(0.5) * t182;
        let t184 = carry10_0 + t157;
        let t185 = c(19.6) * t184;
        let mut carry11_0 = c(0.0);
        let mut carry11_1 = c(0.0);
        for (&[_, _, _, _, _, t9], &[t172, t175]) in store1.iter().zip(store18.iter()) {
            let carry11_0_before = carry11_0;
            let carry11_1_before = carry11_1;
            /// Results: 0 mul, 3 add, 0 reciprocal.
            let t186 = carry11_0_before + t172;
            let t187 = carry11_1_before + t175;
            let t188 = t9 + t187;
            (carry11_0, carry11_1) = (t186, t188);
        }
        /// Results: 0 mul, 2 add, 0 reciprocal.
        let t189 = carry11_0 + t183;
        let t190 = carry11_1 + t185;
        for [o0] in ::mstmm::generated::times_mut::<T, 1>(results0.as_mut_slice(), 10, 1)
            .iter_mut()
        {
            *o0 = -t65;
        }
        for [o0] in ::mstmm::generated::times_mut::<T, 1>(results3.as_mut_slice(), 10, 1)
            .iter_mut()
        {
            *o0 = -t65;
        }
        for [o0] in ::mstmm::generated::times_mut::<T, 1>(results4.as_mut_slice(), 0, 10)
            .iter_mut()
        {
            *o0 = c(0.0);
        }
        for [o0] in ::mstmm::generated::times_mut::<T, 1>(results4.as_mut_slice(), 10, 1)
            .iter_mut()
        {
            *o0 = c(0.0);
        }
        for [o0, o1, o2, o3, o4, o5, o6, o7, o8, o9, o10, o11, o12] in ::mstmm::generated::times_mut::<
            T,
            13,
        >(results7.as_mut_slice(), 0, 1)
            .iter_mut()
        {
            *o0 = c(0.0);
            *o1 = c(0.0);
            *o2 = c(1.0);
            *o3 = c(0.0);
            *o4 = c(0.0);
            *o5 = c(0.0);
            *o6 = c(0.0);
            *o7 = c(0.0);
            *o8 = c(0.0);
            *o9 = c(0.0);
            *o10 = -carry8_2;
            *o11 = carry8_0;
            *o12 = carry8_1;
        }
        for [o0, o1, o2, o3, o4, o5, o6, o7, o8, o9, o10, o11, o12, o13, o14, o15, o16,
        o17, o18, o19, o20, o21, o22, o23, o24, o25] in ::mstmm::generated::times_mut::<
            T,
            26,
        >(results7.as_mut_slice(), 273, 1)
            .iter_mut()
        {
            *o0 = carry4_0;
            *o1 = carry4_1;
            *o2 = hook_axes_x_x;
            *o3 = hook_axes_y_x;
            *o4 = carry4_2;
            *o5 = carry4_3;
            *o6 = hook_omega_z_2;
            *o7 = carry5_0;
            *o8 = carry5_1;
            *o9 = -minus_hook_acc_ang_z;
            *o10 = c(0.0);
            *o11 = hook_own_force_x;
            *o12 = hook_own_force_y;
            *o13 = carry4_0;
            *o14 = carry4_1;
            *o15 = hook_axes_x_x;
            *o16 = hook_axes_y_x;
            *o17 = carry4_2;
            *o18 = carry4_3;
            *o19 = hook_omega_z_2;
            *o20 = carry5_0;
            *o21 = carry5_1;
            *o22 = -minus_hook_acc_ang_z;
            *o23 = c(0.0);
            *o24 = c(0.0);
            *o25 = c(0.0);
        }
        ::mstmm::generated::finite::<T>(&[state.q.as_slice(), state.v.as_slice()])?;
        ::mstmm::generated::require(regular0, "joint")?;
        ::mstmm::generated::regular::<T, _, _>(&[], [], [], [])?;
        ::mstmm::generated::finite::<T>(&[results0.as_slice()])?;
        at.accelerations.data.0 = [results0];
        at.rate_accelerations.data.0 = [results3];
        at.efforts.data.0 = [results4];
        at.kinetic_energy = t189;
        at.potential_energy = t190;
        for (point, &[p0, p1, p2, p3, p4, p5, p6, p7, p8, p9, p10, p11, p12]) in at
            .points
            .iter_mut()
            .zip(results7.as_chunks::<13>().0)
        {
            *point = ::mstmm::PlanePoint::new(
                [p0, p1],
                [p2, p3],
                [p4, p5],
                p6,
                ::mstmm::PlaneStateVector::new([p7, p8], p9, p10, [p11, p12]),
            );
        }
        ::core::result::Result::Ok(())
    }
    /// Kinetic and potential energy in J; the potential of gravity is zero with every centre
    /// of mass at the inertial origin.
    ///
    /// 68 operations: 42 mul, 26 add, 0 reciprocal, 2 sin/cos.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Results |  | 0 | 0 | 0 | 0 | 1 |
    /// | Motion across `joint` | \[P, Eqs. (1), (13), (36)\] | 8 | 5 | 0 | 0 | 1 |
    /// | Results |  | 13 | 0 | 0 | 0 | 0 |
    /// | Motion across `hook` | \[P, Eqs. (1), (13), (36)\] | 4 | 3 | 0 | 0 | 0 |
    /// | Results |  | 6 | 0 | 0 | 0 | 0 |
    /// | Results |  | 6 | 8 | 0 | 0 | 0 |
    /// | Results |  | 5 | 5 | 0 | 0 | 0 |
    /// | Results |  | 0 | 3 | 0 | 0 | 0 |
    /// | Results |  | 0 | 2 | 0 | 0 | 0 |
    #[must_use]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    pub fn energy(&self, state: &RopeState<T>) -> ::mstmm::Energy<T> {
        let c = T::constant;
        let [hook_angle] = ::mstmm::generated::piece::<T, 1>(state.q.as_slice(), 10);
        let [hook_rate] = ::mstmm::generated::piece::<T, 1>(state.v.as_slice(), 10);
        let mut store1 = [[T::constant(0.0); 8]; 10];
        let mut store3 = [[T::constant(0.0); 2]; 10];
        /// Results: 0 mul, 0 add, 0 reciprocal, 1 sin/cos.
        let ([sin_hook_angle], [cos_hook_angle]) = T::sin_cos([hook_angle]);
        let mut carry0_0 = c(1.0);
        let mut carry0_1 = c(0.0);
        let mut carry0_2 = c(0.0);
        let mut carry0_3 = c(1.0);
        let mut carry0_4 = c(0.0);
        for (
            ((&[joint_angle], &[joint_rate]), &[known_knot, known_p1, _, _, _, _]),
            store,
        ) in ::mstmm::generated::times::<T, 1>(state.q.as_slice(), 0, 10)
            .iter()
            .zip(::mstmm::generated::times::<T, 1>(state.v.as_slice(), 0, 10).iter())
            .zip(
                ::mstmm::generated::times::<T, 6>(self.derived0.as_slice(), 0, 10).iter(),
            )
            .zip(store1.iter_mut())
        {
            let carry0_0_before = carry0_0;
            let carry0_1_before = carry0_1;
            let carry0_2_before = carry0_2;
            let carry0_3_before = carry0_3;
            let carry0_4_before = carry0_4;
            /// Motion across `joint`, [P, Eqs. (1), (13), (36)]: 8 mul, 5 add, 0 reciprocal, 1 sin/cos.
            let ([sin_joint_angle], [cos_joint_angle]) = T::sin_cos([joint_angle]);
            let t0 = cos_joint_angle * carry0_0_before;
            let t1 = sin_joint_angle * carry0_1_before;
            let joint_axes_x_x = t0 + t1;
            let t2 = sin_joint_angle * carry0_0_before;
            let t3 = cos_joint_angle * carry0_1_before;
            let minus_joint_axes_x_y = t2 - t3;
            let t4 = sin_joint_angle * carry0_3_before;
            let t5 = cos_joint_angle * carry0_2_before;
            let joint_axes_y_x = t4 + t5;
            let t6 = cos_joint_angle * carry0_3_before;
            let t7 = sin_joint_angle * carry0_2_before;
            let joint_axes_y_y = t6 - t7;
            let joint_omega_z = joint_rate + carry0_4_before;
            /// Results: 13 mul, 0 add, 0 reciprocal.
            let t8 = joint_angle * c(0.2);
            let t9 = joint_angle * t8;
            let t10 = t9 * c(0.5);
            let t11 = c(0.1) * joint_axes_x_x;
            let t12 = c(0.1) * joint_axes_y_x;
            let t13 = joint_omega_z * t12;
            let t14 = joint_omega_z * t11;
            let t15 = c(0.05) * joint_axes_x_x;
            let t16 = c(0.05) * joint_axes_y_x;
            let t17 = joint_omega_z * t16;
            let t18 = joint_omega_z * t15;
            let t19 = c(0.0001) * joint_omega_z;
            let t20 = joint_omega_z * t19;
            *store = [t12, t13, t14, t16, t17, t18, t20, t10];
            (carry0_0, carry0_1, carry0_2, carry0_3, carry0_4) = (
                joint_axes_x_x,
                -minus_joint_axes_x_y,
                joint_axes_y_x,
                joint_axes_y_y,
                joint_omega_z,
            );
        }
        /// Motion across `hook`, [P, Eqs. (1), (13), (36)]: 4 mul, 3 add, 0 reciprocal.
        let t21 = sin_hook_angle * carry0_0;
        let t22 = cos_hook_angle * carry0_1;
        let minus_hook_axes_x_y = t21 - t22;
        let t23 = sin_hook_angle * carry0_2;
        let t24 = cos_hook_angle * carry0_3;
        let minus_hook_axes_y_y = t23 - t24;
        let hook_omega_z = hook_rate + carry0_4;
        /// Results: 6 mul, 0 add, 0 reciprocal.
        let t25 = c(0.1) * minus_hook_axes_x_y;
        let t26 = c(0.1) * minus_hook_axes_y_y;
        let t27 = hook_omega_z * t26;
        let t28 = hook_omega_z * t25;
        let t29 = c(0.01) * hook_omega_z;
        let t30 = hook_omega_z * t29;
        let mut carry1_0 = c(0.0);
        let mut carry1_1 = c(0.0);
        let mut carry1_2 = c(0.0);
        for (
            (&[_, known_p1, _, _, _, _], &[t12, t13, t14, t16, t17, t18, t20, _]),
            store,
        ) in ::mstmm::generated::times::<T, 6>(self.derived0.as_slice(), 0, 10)
            .iter()
            .zip(store1.iter())
            .zip(store3.iter_mut())
        {
            let carry1_0_before = carry1_0;
            let carry1_1_before = carry1_1;
            let carry1_2_before = carry1_2;
            /// Results: 6 mul, 8 add, 0 reciprocal.
            let t31 = carry1_1_before - t13;
            let t32 = carry1_2_before + t14;
            let t33 = carry1_0_before + t12;
            let t34 = carry1_1_before - t17;
            let t35 = carry1_2_before + t18;
            let t36 = t34 * t34;
            let t37 = t35 * t35;
            let t38 = t36 + t37;
            let t39 = known_p1 * t38;
            let t40 = t20 + t39;
            let t41 = c(0.5) * t40;
            let t42 = carry1_0_before + t16;
            let t43 = c(9.8) * t42;
            let t44 = known_p1 * t43;
            *store = [t41, t44];
            (carry1_0, carry1_1, carry1_2) = (t33, t31, t32);
        }
        /// Results: 5 mul, 5 add, 0 reciprocal.
        let t45 = carry1_1 - t27;
        let t46 = carry1_2 + t28;
        let t47 = t45 * t45;
        let t48 = t46 * t46;
        let t49 = t47 + t48;
        let t50 = c(2.0) * t49;
        let t51 = t30 + t50;
        let t52 = c(0.5) * t51;
        let t53 = carry1_0 + t26;
        let t54 = c(19.6) * t53;
        let mut carry2_0 = c(0.0);
        let mut carry2_1 = c(0.0);
        for (&[_, _, _, _, _, _, _, t10], &[t41, t44]) in store1
            .iter()
            .zip(store3.iter())
        {
            let carry2_0_before = carry2_0;
            let carry2_1_before = carry2_1;
            /// Results: 0 mul, 3 add, 0 reciprocal.
            let t55 = carry2_0_before + t41;
            let t56 = carry2_1_before + t44;
            let t57 = t10 + t56;
            (carry2_0, carry2_1) = (t55, t57);
        }
        /// Results: 0 mul, 2 add, 0 reciprocal.
        let t58 = carry2_0 + t52;
        let t59 = carry2_1 + t54;
        ::mstmm::Energy {
            kinetic: t58,
            potential: t59,
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
        state: &RopeState<T>,
        inputs: &RopeInputs<T>,
        rate: &mut RopeState<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.accelerations_into(state, inputs, &mut rate.v)?;
        self.configuration_rate_into(state, rate);
        ::core::result::Result::Ok(())
    }
    #[inline]
    fn implicit_derivative_into(
        &self,
        state: &RopeState<T>,
        inputs: &RopeInputs<T>,
        step: T,
        rate: &mut RopeState<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.implicit_accelerations_into(state, inputs, step, &mut rate.v)?;
        self.configuration_rate_into(state, rate);
        ::core::result::Result::Ok(())
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn configuration_rate_into(&self, state: &RopeState<T>, rate: &mut RopeState<T>) {
        rate.q.data.0 = {
            let [hook_rate] = ::mstmm::generated::piece::<T, 1>(state.v.as_slice(), 10);
            let mut results0 = [T::constant(0.0); 11];
            for (&[joint_rate], [o0_0]) in ::mstmm::generated::times::<
                T,
                1,
            >(state.v.as_slice(), 0, 10)
                .iter()
                .zip(
                    ::mstmm::generated::times_mut::<T, 1>(results0.as_mut_slice(), 0, 10)
                        .iter_mut(),
                )
            {
                *o0_0 = joint_rate;
                () = ();
            }
            for [o0] in ::mstmm::generated::times_mut::<
                T,
                1,
            >(results0.as_mut_slice(), 10, 1)
                .iter_mut()
            {
                *o0 = hook_rate;
            }
            [results0]
        };
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn normalize(&self, state: &mut RopeState<T>) {
        state.q.data.0 = {
            let [hook_angle] = ::mstmm::generated::piece::<T, 1>(state.q.as_slice(), 10);
            let mut results0 = [T::constant(0.0); 11];
            for (&[joint_angle], [o0_0]) in ::mstmm::generated::times::<
                T,
                1,
            >(state.q.as_slice(), 0, 10)
                .iter()
                .zip(
                    ::mstmm::generated::times_mut::<T, 1>(results0.as_mut_slice(), 0, 10)
                        .iter_mut(),
                )
            {
                *o0_0 = joint_angle;
                () = ();
            }
            for [o0] in ::mstmm::generated::times_mut::<
                T,
                1,
            >(results0.as_mut_slice(), 10, 1)
                .iter_mut()
            {
                *o0 = hook_angle;
            }
            [results0]
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
        state: &RopeState<T>,
        inputs: &RopeInputs<T>,
        at: &mut RopeWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.solve_into(state, inputs, at)
    }
    #[inline]
    fn energy(&self, state: &RopeState<T>) -> ::mstmm::Energy<T> {
        self.energy(state)
    }
}
/// Coordinates and rates of [`Rope`] at a time.
///
/// The hinges lie one after the other in the order written. [`Default`] is every hinge at
/// rest in its zero position.
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
    pub fn joint(&self, index: usize) -> ::core::option::Option<::mstmm::PinState<T>> {
        let &[q0] = ::mstmm::generated::times::<T, 1>(self.q.as_slice(), 0, 10)
            .iter()
            .nth(index)?;
        let &[v0] = ::mstmm::generated::times::<T, 1>(self.v.as_slice(), 0, 10)
            .iter()
            .nth(index)?;
        ::core::option::Option::Some(::mstmm::PinState::new(q0, v0))
    }
    /// Coordinates and rates of hinge `joint` number `index` of 10. To be changed.
    #[inline]
    pub fn joint_mut(
        &mut self,
        index: usize,
    ) -> ::core::option::Option<::mstmm::PinStateMut<'_, T>> {
        let [q0] = ::mstmm::generated::times_mut::<T, 1>(self.q.as_mut_slice(), 0, 10)
            .iter_mut()
            .nth(index)?;
        let [v0] = ::mstmm::generated::times_mut::<T, 1>(self.v.as_mut_slice(), 0, 10)
            .iter_mut()
            .nth(index)?;
        ::core::option::Option::Some(::mstmm::PinStateMut::new(q0, v0))
    }
    /// Sets coordinates and rates of all hinges `joint` by their index.
    pub fn set_each_joint(
        &mut self,
        mut view: impl ::core::ops::FnMut(usize) -> ::mstmm::PinState<T>,
    ) {
        let mut set = |index: usize| -> ::core::option::Option<()> {
            let (new_q0, new_v0) = view(index).into_groups();
            let [q0] = ::mstmm::generated::times_mut::<
                T,
                1,
            >(self.q.as_mut_slice(), 0, 10)
                .iter_mut()
                .nth(index)?;
            let [v0] = ::mstmm::generated::times_mut::<
                T,
                1,
            >(self.v.as_mut_slice(), 0, 10)
                .iter_mut()
                .nth(index)?;
            *q0 = new_q0;
            *v0 = new_v0;
            ::core::option::Option::Some(())
        };
        for index in 0..10 {
            set(index);
        }
    }
    /// Coordinates and rates of hinge `hook`.
    #[inline]
    #[must_use]
    pub fn hook(&self) -> ::mstmm::PinState<T> {
        let [q0] = ::mstmm::generated::piece::<T, 1>(self.q.as_slice(), 10);
        let [v0] = ::mstmm::generated::piece::<T, 1>(self.v.as_slice(), 10);
        ::mstmm::PinState::new(q0, v0)
    }
    /// Coordinates and rates of hinge `hook`, to be changed.
    #[inline]
    pub fn hook_mut(&mut self) -> ::mstmm::PinStateMut<'_, T> {
        let [[.., q0]] = &mut self.q.data.0;
        let [[.., v0]] = &mut self.v.data.0;
        ::mstmm::PinStateMut::new(q0, v0)
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for RopeState<T> {
    fn default() -> Self {
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        let _ = one;
        Self {
            q: ::mstmm::generated::vector({
                let mut rest = [zero; 11];
                for part in ::mstmm::generated::times_mut::<
                    T,
                    1,
                >(rest.as_mut_slice(), 0, 10)
                    .iter_mut()
                {
                    *part = [zero];
                }
                for part in ::mstmm::generated::times_mut::<
                    T,
                    1,
                >(rest.as_mut_slice(), 10, 1)
                    .iter_mut()
                {
                    *part = [zero];
                }
                rest
            }),
            v: ::mstmm::generated::vector([zero; 11]),
            t: zero,
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
    fn set_time(&mut self, time: T) {
        self.t = time;
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
/// Results of [`Rope::solve_into`].
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
pub struct RopeWorkspace<T> {
    accelerations: ::mstmm::nalgebra::SVector<T, 11>,
    rate_accelerations: ::mstmm::nalgebra::SVector<T, 11>,
    efforts: ::mstmm::nalgebra::SVector<T, 11>,
    kinetic_energy: T,
    potential_energy: T,
    points: [::mstmm::PlanePoint<T>; 23],
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> RopeWorkspace<T> {
    /// Accelerations `v̇` of all hinges, in the order of the rates.
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
    /// All connection points in the order written: the first element's input, then every
    /// element's output.
    #[inline]
    pub fn points(&self) -> &[::mstmm::PlanePoint<T>; 23] {
        &self.points
    }
    /// Acceleration, effort, input and output of hinge `joint` number `index` of 10.
    #[inline]
    pub fn joint(
        &self,
        index: usize,
    ) -> ::core::option::Option<::mstmm::HingeResult<'_, T, T, ::mstmm::PlanePoint<T>>> {
        if index >= 10 {
            return ::core::option::Option::None;
        }
        let [input, output] = self.points.get(0 + index * 2..)?.first_chunk()?;
        let result = ::mstmm::HingeResult::new(
            {
                let &[x0] = ::mstmm::generated::times::<
                    T,
                    1,
                >(self.rate_accelerations.as_slice(), 0, 10)
                    .iter()
                    .nth(index)?;
                x0
            },
            {
                let &[x0] = ::mstmm::generated::times::<
                    T,
                    1,
                >(self.efforts.as_slice(), 0, 10)
                    .iter()
                    .nth(index)?;
                x0
            },
            input,
            output,
        );
        ::core::option::Option::Some(result)
    }
    /// Input and output of body `rod` number `index` of 10.
    #[inline]
    pub fn rod(
        &self,
        index: usize,
    ) -> ::core::option::Option<::mstmm::BodyResult<'_, T, ::mstmm::PlanePoint<T>>> {
        if index >= 10 {
            return ::core::option::Option::None;
        }
        let [input, output] = self.points.get(1 + index * 2..)?.first_chunk()?;
        ::core::option::Option::Some(::mstmm::BodyResult::new(input, output))
    }
    /// Acceleration, effort, input and output of hinge `hook`.
    #[inline]
    pub fn hook(&self) -> ::mstmm::HingeResult<'_, T, T, ::mstmm::PlanePoint<T>> {
        let (input, output) = (&self.points[20], &self.points[21]);
        ::mstmm::HingeResult::new(
            {
                let [value] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.rate_accelerations.as_slice(), 10);
                value
            },
            {
                let [value] = ::mstmm::generated::piece::<
                    T,
                    1,
                >(self.efforts.as_slice(), 10);
                value
            },
            input,
            output,
        )
    }
    /// Input and output of body `weight`.
    #[inline]
    pub fn weight(&self) -> ::mstmm::BodyResult<'_, T, ::mstmm::PlanePoint<T>> {
        let (input, output) = (&self.points[21], &self.points[22]);
        ::mstmm::BodyResult::new(input, output)
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> Rope<T> {
    /// Room for the results of [`solve_into`](Self::solve_into).
    #[must_use]
    pub fn workspace(&self) -> RopeWorkspace<T> {
        let zero = T::constant(0.0);
        RopeWorkspace {
            accelerations: ::mstmm::generated::vector([zero; 11]),
            rate_accelerations: ::mstmm::generated::vector([zero; 11]),
            efforts: ::mstmm::generated::vector([zero; 11]),
            kinetic_energy: zero,
            potential_energy: zero,
            points: [::core::default::Default::default(); 23],
        }
    }
}
