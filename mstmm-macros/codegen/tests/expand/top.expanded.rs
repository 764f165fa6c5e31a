/// A top on a ball and socket.
///
/// # The chain
///
/// `ground -> ball tip -> cone`
///
/// <svg role="img" aria-label="The chain at its start" viewBox="0 0 188 472" width="188" style="max-width:100%;height:auto" font-size="12" stroke-linecap="round" fill="currentColor">
/// <path d="M22 450l-12.1 7.0" stroke="currentColor" opacity="0.6"/><text x="3.8" y="463.5" font-size="10" opacity="0.6" text-anchor="middle">x</text>
/// <path d="M22 450l12.1 7.0" stroke="currentColor" opacity="0.6"/><text x="40.2" y="463.5" font-size="10" opacity="0.6" text-anchor="middle">y</text>
/// <path d="M22 450l0.0 -14.0" stroke="currentColor" opacity="0.6"/><text x="22.0" y="432.0" font-size="10" opacity="0.6" text-anchor="middle">z</text>
/// <path d="M92.1 436.0L92.1 436.0" stroke="#3a87c8" stroke-width="7" stroke-opacity="0.45"/><path d="M92.1 436.0L36.0 36.0L92.1 436.0" fill="none" stroke="#3a87c8" stroke-width="1"/><circle cx="36.0" cy="36.0" r="3" fill="#3a87c8"/>
/// <path d="M78.1 445.0h28m-26 7l5 -7m2 7l5 -7m2 7l5 -7" fill="none" stroke="currentColor"/>
/// <circle cx="92.1" cy="436.0" r="5" stroke="currentColor" stroke-width="1.5"/>
/// <text x="100.1" y="428.0">tip</text>
/// <text x="92.1" y="456.0" text-anchor="middle" font-style="italic">cone</text>
/// <path d="M158.1 22.0l0.0 28.0m-3.5 -6.1l3.5 6.1l3.5 -6.1" fill="none" stroke="currentColor" stroke-width="1.5"/><text x="171.1" y="40.0" font-style="italic" text-anchor="middle">g</text>
/// </svg>
///
/// | element | what it is | freedoms |
/// |---|---|---|
/// | `tip` | ball | 3 |
/// | `cone` | body `Cone`, 0.2 kg |  |
///
/// Mobility 3: 3 degrees of freedom.
///
/// Accelerations by `riccati`, 17 operations (13 mul, 4 add, 0 reciprocal); with everything at every connection point 54 operations.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
struct Top<T> {
    changed_by_setters: ::mstmm::generated::Sealed<TopParameters<T>, [T; 0]>,
}
/// Numbers of [`Top`] that may change at run time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
struct TopParameters<T> {
    none: ::core::marker::PhantomData<T>,
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TopParameters<T> {}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> Top<T> {
    /// The chain as described.
    #[inline]
    #[must_use]
    #[allow(clippy::all)]
    fn new() -> Self {
        let parameters_ = TopParameters {
            none: ::core::marker::PhantomData,
        };
        let (chain_, _) = Self::derive(::mstmm::generated::Sealed::new(parameters_));
        chain_
    }
    /// The values that may change at run time: there are none.
    #[inline]
    fn parameters(&self) -> &TopParameters<T> {
        self.changed_by_setters.parameters()
    }
    /// The state that the description starts from, at time zero.
    #[must_use]
    #[allow(unused_doc_comments, clippy::all)]
    fn initial_state(&self) -> TopState<T> {
        let c_ = T::constant;
        TopState {
            q: ::mstmm::generated::vector([
                c_(0.9961946980917455),
                c_(0.08715574274765817),
                c_(0.0),
                c_(0.0),
            ]),
            v: ::mstmm::generated::vector([c_(0.0), c_(0.0), c_(300.0)]),
            t: T::constant(0.0),
        }
    }
    /// Quantities derived from parameters and constants: 0 mul, 0 add, 0 reciprocal.
    #[allow(unused_doc_comments, unused_variables, unused_mut, clippy::all)]
    fn derive(sealed_: ::mstmm::generated::Sealed<TopParameters<T>>) -> (Self, [T; 0]) {
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
impl<T: ::mstmm::Scalar> ::core::default::Default for Top<T> {
    fn default() -> Self {
        Self::new()
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> Top<T> {
    /// The accelerations `v̇` of all hinges, in the order of `v` of the state: the fast path.
    ///
    /// Quaternions may have any length near one, as those of an integrator's stages have. They
    /// are used unchanged and are not checked: for a quaternion of length n whose rotation matrix
    /// is R, the matrix (1 − n²) 1 + n² R is used instead of R, which is R up to terms of the
    /// order of n² − 1.
    ///
    /// 17 operations: 13 mul, 4 add, 0 reciprocal.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `tip` | \[P, Eqs. (1), (13), (36)\] | 7 | 2 | 0 | 0 | 0 |
    /// | Riccati transfer over `tip` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 4 | 0 | 0 | 0 | 0 |
    /// | Acceleration of `tip` | \[P, Eqs. (13), (36), (44)\] | 2 | 2 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// `Error::Singular` if no inertia is left beyond a
    /// hinge, `Error::NotFinite` if a number of the state or the
    /// inputs is not finite. `accelerations` is not touched then.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn accelerations_into(
        &self,
        state_: &TopState<T>,
        inputs_: &TopInputs<T>,
        accelerations_: &mut ::mstmm::nalgebra::SVector<T, 3>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let c_ = T::constant;
        let [[tip_qw_, tip_qx_, tip_qy_, tip_qz_]] = state_.q.data.0;
        let [[tip_wx_, tip_wy_, tip_wz_]] = state_.v.data.0;
        /// Motion across `tip`, [P, Eqs. (1), (13), (36)]: 7 mul, 2 add, 0 reciprocal.
        let t3_ = tip_qx_ * c_(2.0);
        let t0_ = tip_qy_ * c_(2.0);
        let t1_ = tip_qz_ * c_(2.0);
        /// Riccati transfer over `tip`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 4 mul, 0 add, 0 reciprocal.
        let t5_ = tip_wy_ * tip_wz_;
        let t6_ = tip_wx_ * tip_wz_;
        /// Motion across `tip`.
        let t4_ = tip_qw_ * t3_;
        let t2_ = tip_qw_ * t0_;
        /// Riccati transfer over `tip`.
        let tip_rest0_ = t5_ * c_(0.9);
        let minus_tip_rest1_ = t6_ * c_(0.9);
        /// Motion across `tip`.
        let tip_turn_zy_ = T::mul_add(tip_qy_, t1_, t4_);
        let minus_tip_turn_zx_ = T::mul_neg_add(tip_qx_, t1_, t2_);
        /// Acceleration of `tip`, [P, Eqs. (13), (36), (44)]: 2 mul, 2 add, 0 reciprocal.
        let tip_a_ang_x_ = T::mul_add(tip_turn_zy_, c_(117.60000000000001), tip_rest0_);
        let minus_tip_a_ang_y_ = T::mul_neg_add(
            minus_tip_turn_zx_,
            c_(117.60000000000001),
            minus_tip_rest1_,
        );
        if !::mstmm::generated::regular::<
            T,
            _,
            _,
        >([], [], [state_.t, tip_a_ang_x_, -minus_tip_a_ang_y_]) {
            return ::core::result::Result::Err(
                ::mstmm::generated::irregular::<T, _>(&[], [], []),
            );
        }
        accelerations_.data.0 = [[tip_a_ang_x_, -minus_tip_a_ang_y_, c_(0.0)]];
        ::core::result::Result::Ok(())
    }
    /// The accelerations `v̇` of all hinges by value; see
    /// [`accelerations_into`](Self::accelerations_into).
    ///
    /// # Errors
    ///
    /// As [`accelerations_into`](Self::accelerations_into).
    ///
    /// `Error::Quaternion` if the length of a quaternion is not between 0.9 and 1.1.
    #[inline]
    fn accelerations(
        &self,
        state_: &TopState<T>,
        inputs_: &TopInputs<T>,
    ) -> ::core::result::Result<::mstmm::nalgebra::SVector<T, 3>, ::mstmm::Error> {
        ::mstmm::Chain::check_state(self, state_)?;
        let mut accelerations_ = ::mstmm::generated::vector([T::constant(0.0); 3]);
        self.accelerations_into(state_, inputs_, &mut accelerations_)?;
        ::core::result::Result::Ok(accelerations_)
    }
    /// Writes into `at`: accelerations, efforts, energies and, at every connection point, pose, velocity and the state vector `z`.
    ///
    /// 54 operations: 34 mul, 20 add, 0 reciprocal.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `tip` | \[P, Eqs. (1), (13), (36)\] | 12 | 11 | 0 | 0 | 0 |
    /// | Riccati transfer over `tip` | F = A a + e of \[P, Eqs. (18), (19)\] with the conditions \[P, Eqs. (25), (35)\] | 7 | 1 | 0 | 0 | 0 |
    /// | Results |  | 5 | 1 | 0 | 0 | 0 |
    /// | Acceleration of `tip` | \[P, Eqs. (13), (36), (44)\] | 5 | 2 | 0 | 0 | 0 |
    /// | Load on `tip` | \[P, Eqs. (18), (19)\] | 5 | 5 | 0 | 0 | 0 |
    ///
    /// # Errors
    ///
    /// As [`accelerations_into`](Self::accelerations_into); `at` is then as
    /// [`workspace`](Self::workspace) makes it: results of earlier calls are gone.
    ///
    /// `Error::Quaternion` if the length of a quaternion is not between 0.9 and 1.1.
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn solve_into(
        &self,
        state_: &TopState<T>,
        inputs_: &TopInputs<T>,
        at_: &mut TopWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        let checked_ = (|| {
            ::mstmm::Chain::check_state(self, state_)?;
            ::core::result::Result::Ok(())
        })();
        if let ::core::result::Result::Err(error_) = checked_ {
            ::mstmm::generated::take_back(at_, || self.workspace());
            return ::core::result::Result::Err(error_);
        }
        let [_, _, _, n3_, n4_, n5_, n6_, n7_, n8_, n9_, n10_, n11_, n12_, n13_, n14_,
        n15_, n16_, n17_, n18_, n19_, n20_, n21_, n22_, _] = &mut at_.numbers;
        let c_ = T::constant;
        let [[tip_qw_, tip_qx_, tip_qy_, tip_qz_]] = state_.q.data.0;
        let [[tip_wx_, tip_wy_, tip_wz_]] = state_.v.data.0;
        at_.efforts.data.0 = [[c_(0.0), c_(0.0), c_(0.0)]];
        *n15_ = tip_wx_;
        *n16_ = tip_wy_;
        *n17_ = tip_wz_;
        /// Motion across `tip`, [P, Eqs. (1), (13), (36)]: 12 mul, 11 add, 0 reciprocal.
        let t0_ = tip_qy_ * c_(2.0);
        let t1_ = tip_qz_ * c_(2.0);
        let t9_ = tip_qx_ * c_(2.0);
        /// Riccati transfer over `tip`, F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]: 7 mul, 1 add, 0 reciprocal.
        let t15_ = tip_wy_ * tip_wz_;
        let t16_ = tip_wx_ * tip_wz_;
        /// Motion across `tip`.
        let t7_ = tip_qw_ * t0_;
        let t8_ = tip_qx_ * t1_;
        let t11_ = tip_qw_ * t9_;
        let t12_ = tip_qy_ * t1_;
        /// Riccati transfer over `tip`.
        let t13_ = tip_wy_ * tip_wy_;
        /// Results: 5 mul, 1 add, 0 reciprocal.
        let t21_ = tip_wz_ * tip_wz_;
        /// Motion across `tip`.
        let t2_ = tip_qy_ * t0_;
        let t5_ = tip_qw_ * t1_;
        /// Riccati transfer over `tip`.
        let minus_tip_rest1_ = t16_ * c_(0.9);
        let tip_rest0_ = t15_ * c_(0.9);
        /// Motion across `tip`.
        let t6_ = tip_qx_ * t0_;
        let minus_tip_turn_zx_ = t7_ - t8_;
        *n8_ = -minus_tip_turn_zx_;
        ::mstmm::generated::written();
        let tip_turn_zy_ = t11_ + t12_;
        *n11_ = tip_turn_zy_;
        ::mstmm::generated::written();
        let t10_ = T::mul_sub(tip_qx_, t9_, c_(1.0));
        /// Riccati transfer over `tip`.
        let t14_ = T::mul_add(tip_wx_, tip_wx_, t13_);
        /// Results.
        let t22_ = t21_ * c_(0.0001);
        /// Motion across `tip`.
        let t3_ = tip_qz_ * t1_;
        let t4_ = t2_ - c_(1.0);
        /// Acceleration of `tip`, [P, Eqs. (13), (36), (44)]: 5 mul, 2 add, 0 reciprocal.
        let minus_tip_a_ang_y_ = T::mul_neg_add(
            minus_tip_turn_zx_,
            c_(117.60000000000001),
            minus_tip_rest1_,
        );
        *n22_ = -minus_tip_a_ang_y_;
        ::mstmm::generated::written();
        let tip_a_ang_x_ = T::mul_add(tip_turn_zy_, c_(117.60000000000001), tip_rest0_);
        if !::mstmm::generated::regular::<
            T,
            _,
            _,
        >([], [], [state_.t, -minus_tip_a_ang_y_, tip_a_ang_x_]) {
            let error_ = ::mstmm::generated::irregular::<T, _>(&[], [], []);
            ::mstmm::generated::take_back(at_, || self.workspace());
            return ::core::result::Result::Err(error_);
        }
        at_.accelerations.data.0 = [[tip_a_ang_x_, -minus_tip_a_ang_y_, c_(0.0)]];
        *n21_ = tip_a_ang_x_;
        ::mstmm::generated::written();
        /// Motion across `tip`.
        let minus_tip_turn_xy_ = t5_ - t6_;
        *n9_ = -minus_tip_turn_xy_;
        ::mstmm::generated::written();
        let tip_turn_xz_ = t7_ + t8_;
        *n12_ = tip_turn_xz_;
        ::mstmm::generated::written();
        let tip_turn_yx_ = t5_ + t6_;
        *n7_ = tip_turn_yx_;
        ::mstmm::generated::written();
        let minus_tip_turn_zz_ = t2_ + t10_;
        *n14_ = -minus_tip_turn_zz_;
        ::mstmm::generated::written();
        /// Riccati transfer over `tip`.
        let minus_tip_bias_fz_ = c_(0.012) * t14_;
        /// Results.
        let t23_ = T::mul_add(t14_, c_(0.001), t22_);
        /// Load on `tip`, [P, Eqs. (18), (19)]: 5 mul, 5 add, 0 reciprocal.
        let t17_ = minus_tip_turn_zx_ * c_(1.9600000000000002);
        let t19_ = tip_turn_zy_ * c_(1.9600000000000002);
        let t18_ = t16_ - minus_tip_a_ang_y_;
        let t20_ = t15_ - tip_a_ang_x_;
        /// Acceleration of `tip`.
        let minus_tip_a_lin_x_ = minus_tip_turn_zx_ * c_(9.8);
        *n18_ = -minus_tip_a_lin_x_;
        ::mstmm::generated::written();
        let tip_a_lin_y_ = tip_turn_zy_ * c_(9.8);
        *n19_ = tip_a_lin_y_;
        ::mstmm::generated::written();
        let minus_tip_a_lin_z_ = c_(9.8) * minus_tip_turn_zz_;
        *n20_ = -minus_tip_a_lin_z_;
        ::mstmm::generated::written();
        /// Results.
        let t25_ = c_(0.11760000000000001) * minus_tip_turn_zz_;
        at_.potential_energy = -t25_;
        ::mstmm::generated::written();
        /// Load on `tip`.
        let minus_tip_load_fz_ = T::mul_add(
            c_(1.9600000000000002),
            minus_tip_turn_zz_,
            minus_tip_bias_fz_,
        );
        *n5_ = -minus_tip_load_fz_;
        ::mstmm::generated::written();
        /// Results.
        let t24_ = c_(0.5) * t23_;
        at_.kinetic_energy = t24_;
        ::mstmm::generated::written();
        /// Load on `tip`.
        let minus_tip_load_fx_ = T::mul_neg_add(c_(0.012), t18_, t17_);
        *n3_ = -minus_tip_load_fx_;
        ::mstmm::generated::written();
        let tip_load_fy_ = T::mul_add(c_(0.012), t20_, t19_);
        *n4_ = tip_load_fy_;
        ::mstmm::generated::written();
        /// Motion across `tip`.
        let minus_tip_turn_yy_ = t3_ + t10_;
        *n10_ = -minus_tip_turn_yy_;
        ::mstmm::generated::written();
        let minus_tip_turn_yz_ = t11_ - t12_;
        *n13_ = -minus_tip_turn_yz_;
        ::mstmm::generated::written();
        let minus_tip_turn_xx_ = t3_ + t4_;
        *n6_ = -minus_tip_turn_xx_;
        ::mstmm::generated::written();
        ::core::result::Result::Ok(())
    }
    /// Kinetic and potential energy in J; the potential of gravity is zero with every centre
    /// of mass at the inertial origin.
    ///
    /// 15 operations: 11 mul, 4 add, 0 reciprocal.
    ///
    /// | section | equations | mul | add | reciprocal | square root | sin/cos |
    /// |---|---|---|---|---|---|---|
    /// | Motion across `tip` | \[P, Eqs. (1), (13), (36)\] | 4 | 2 | 0 | 0 | 0 |
    /// | Results |  | 7 | 2 | 0 | 0 | 0 |
    #[must_use]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn energy(&self, state_: &TopState<T>) -> ::mstmm::Energy<T> {
        let c_ = T::constant;
        let [[_, tip_qx_, tip_qy_, ..]] = state_.q.data.0;
        let [[tip_wx_, tip_wy_, tip_wz_]] = state_.v.data.0;
        /// Motion across `tip`, [P, Eqs. (1), (13), (36)]: 4 mul, 2 add, 0 reciprocal.
        let t0_ = tip_qx_ * c_(2.0);
        let t1_ = tip_qy_ * c_(2.0);
        let t2_ = T::mul_sub(tip_qy_, t1_, c_(1.0));
        let minus_tip_turn_zz_ = T::mul_add(tip_qx_, t0_, t2_);
        /// Results: 7 mul, 2 add, 0 reciprocal.
        let t3_ = tip_wy_ * tip_wy_;
        let t4_ = tip_wz_ * tip_wz_;
        let t5_ = T::mul_add(tip_wx_, tip_wx_, t3_);
        let t6_ = t4_ * c_(0.0001);
        let t7_ = T::mul_add(t5_, c_(0.001), t6_);
        let t8_ = c_(0.5) * t7_;
        let t9_ = c_(0.11760000000000001) * minus_tip_turn_zz_;
        ::mstmm::Energy {
            kinetic: t8_,
            potential: -t9_,
        }
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::Chain for Top<T> {
    type Scalar = T;
    type State = TopState<T>;
    type Inputs = TopInputs<T>;
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn derivative_into(
        &self,
        state_: &TopState<T>,
        inputs_: &TopInputs<T>,
        rate_: &mut TopState<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.accelerations_into(state_, inputs_, &mut rate_.v)?;
        self.configuration_rate_into(state_, rate_);
        ::core::result::Result::Ok(())
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn configuration_rate_into(&self, state_: &TopState<T>, rate_: &mut TopState<T>) {
        rate_.q.data.0 = {
            let c_ = T::constant;
            let [[tip_qw_, tip_qx_, tip_qy_, tip_qz_]] = state_.q.data.0;
            let [[tip_wx_, tip_wy_, tip_wz_]] = state_.v.data.0;
            /// Results: 15 mul, 8 add, 0 reciprocal.
            let t0_ = tip_wx_ * c_(0.5);
            let t1_ = tip_wy_ * c_(0.5);
            let t2_ = tip_wz_ * c_(0.5);
            let t3_ = tip_qx_ * t0_;
            let t4_ = T::mul_add(tip_qy_, t1_, t3_);
            let t5_ = T::mul_add(tip_qz_, t2_, t4_);
            let t6_ = tip_qw_ * t0_;
            let t7_ = T::mul_neg_add(tip_qz_, t1_, t6_);
            let t8_ = T::mul_add(tip_qy_, t2_, t7_);
            let t9_ = tip_qw_ * t1_;
            let t10_ = T::mul_neg_add(tip_qx_, t2_, t9_);
            let t11_ = T::mul_add(tip_qz_, t0_, t10_);
            let t12_ = tip_qw_ * t2_;
            let t13_ = T::mul_neg_add(tip_qy_, t0_, t12_);
            let t14_ = T::mul_add(tip_qx_, t1_, t13_);
            [[-t5_, t8_, t11_, t14_]]
        };
    }
    #[inline]
    #[allow(unused_doc_comments, unused_variables, clippy::all)]
    fn normalize(&self, state_: &mut TopState<T>) {
        state_.q.data.0 = {
            let [[tip_qw_, tip_qx_, tip_qy_, tip_qz_]] = state_.q.data.0;
            /// Results: 8 mul, 3 add, 1 reciprocal, 1 square root.
            let t0_ = tip_qw_ * tip_qw_;
            let t1_ = T::mul_add(tip_qx_, tip_qx_, t0_);
            let t2_ = T::mul_add(tip_qy_, tip_qy_, t1_);
            let t3_ = T::mul_add(tip_qz_, tip_qz_, t2_);
            let t4_ = T::sqrt(t3_);
            let t5_ = T::recip(t4_);
            let t6_ = tip_qw_ * t5_;
            let t7_ = tip_qx_ * t5_;
            let t8_ = tip_qy_ * t5_;
            let t9_ = tip_qz_ * t5_;
            [[t6_, t7_, t8_, t9_]]
        };
    }
    #[inline]
    fn check_state(
        &self,
        state_: &TopState<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        ::mstmm::generated::check_quaternions(
            state_.q.as_slice(),
            &[
                ::mstmm::generated::QuaternionsOf {
                    hinge: "tip",
                    first: 0,
                    stride: 4,
                    count: 1,
                },
            ],
        )
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::GeneratedChain for Top<T> {
    type Workspace = TopWorkspace<T>;
    #[inline]
    fn initial_state(&self) -> TopState<T> {
        self.initial_state()
    }
    #[inline]
    fn no_inputs(&self) -> TopInputs<T> {
        self.no_inputs()
    }
    #[inline]
    fn workspace(&self) -> TopWorkspace<T> {
        self.workspace()
    }
    #[inline]
    fn solve_into(
        &self,
        state_: &TopState<T>,
        inputs_: &TopInputs<T>,
        at_: &mut TopWorkspace<T>,
    ) -> ::core::result::Result<(), ::mstmm::Error> {
        self.solve_into(state_, inputs_, at_)
    }
    #[inline]
    fn energy(&self, state_: &TopState<T>) -> ::mstmm::Energy<T> {
        self.energy(state_)
    }
}
/// Coordinates and rates of [`Top`] at a time.
///
/// The hinges lie one after the other in the order of the route. A body that floats comes
/// first; a hinge whose motion is prescribed has no place.
///
/// | of | places in `q` | places in `v` |
/// |---|---|---|
/// | `tip` | 0 to 3 | 0 to 2 |
///
/// [`Default`] is every hinge at rest in its zero position.
#[derive(Clone, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
struct TopState<T> {
    /// Coordinates: angles in rad, lengths in m, unit quaternions as w, x, y, z.
    q: ::mstmm::nalgebra::SVector<T, 4>,
    /// Rates in rad/s and m/s.
    v: ::mstmm::nalgebra::SVector<T, 3>,
    /// Time in s.
    t: T,
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TopState<T> {
    /// Coordinates and rates of hinge `tip`.
    #[inline]
    #[must_use]
    fn tip(&self) -> ::mstmm::BallState<T> {
        let [[q0_, q1_, q2_, q3_, ..]] = self.q.data.0;
        let [[v0_, v1_, v2_, ..]] = self.v.data.0;
        ::mstmm::BallState::new([q0_, q1_, q2_, q3_], [v0_, v1_, v2_])
    }
    /// Coordinates and rates of hinge `tip`, to be changed.
    #[inline]
    fn tip_mut(&mut self) -> ::mstmm::BallStateMut<'_, T> {
        let [[q0_, q1_, q2_, q3_, ..]] = &mut self.q.data.0;
        let [[v0_, v1_, v2_, ..]] = &mut self.v.data.0;
        ::mstmm::BallStateMut::new([q0_, q1_, q2_, q3_], [v0_, v1_, v2_]).named("tip")
    }
}
impl<T: ::mstmm::Scalar> ::core::default::Default for TopState<T> {
    fn default() -> Self {
        let (zero_, one_) = (T::constant(0.0), T::constant(1.0));
        let _ = one_;
        Self {
            q: ::mstmm::generated::vector([one_, zero_, zero_, zero_]),
            v: ::mstmm::generated::vector([zero_; 3]),
            t: zero_,
        }
    }
}
impl<T: ::mstmm::Scalar> ::mstmm::ChainState for TopState<T> {
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
/// What drives [`Top`] from outside, given at every step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(dead_code, non_snake_case)]
struct TopInputs<T> {
    none: ::core::marker::PhantomData<T>,
}
impl<T: ::mstmm::Scalar> ::core::default::Default for TopInputs<T> {
    #[inline]
    fn default() -> Self {
        Self {
            none: ::core::marker::PhantomData,
        }
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> Top<T> {
    /// Inputs that are all zero; prescribed motions rest in the zero position.
    #[inline]
    #[must_use]
    fn no_inputs(&self) -> TopInputs<T> {
        ::core::default::Default::default()
    }
}
/// Results of [`Top::solve_into`]: accelerations, efforts, energies and, at every connection point, pose, velocity and the state vector `z`.
#[derive(Clone, PartialEq)]
#[allow(dead_code, non_snake_case)]
struct TopWorkspace<T> {
    accelerations: ::mstmm::nalgebra::SVector<T, 3>,
    efforts: ::mstmm::nalgebra::SVector<T, 3>,
    kinetic_energy: T,
    potential_energy: T,
    numbers: [T; 24],
    at_rest: [T; 3],
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> TopWorkspace<T> {
    /// Accelerations `v̇` of all hinges, in the order of `v` of the state.
    #[inline]
    fn accelerations(&self) -> &::mstmm::nalgebra::SVector<T, 3> {
        &self.accelerations
    }
    /// Kinetic energy in J.
    #[inline]
    fn kinetic_energy(&self) -> T {
        self.kinetic_energy
    }
    /// Potential energy in J: of gravity, zero with every centre of mass at the inertial
    /// origin, and of springs.
    #[inline]
    fn potential_energy(&self) -> T {
        self.potential_energy
    }
    /// All connection points in the order of the route: the input of the first element, then the
    /// output of every element, which is the input of the next one.
    #[inline]
    fn points(&self) -> [::mstmm::Point<T>; 3] {
        [self.point_(0), self.point_(1), self.point_(2)]
    }
    /// Where every point of the model has its numbers.
    const PLACES_: [::mstmm::generated::Places<3, 6>; 3] = [
        ::mstmm::generated::Places::new(
            0,
            [0, 0, 0],
            [
                ([0, 0, 0], 0),
                ([0, 0, 0], 0),
                ([0, 0, 0], 1),
                ([0, 0, 0], 0),
                ([0, 0, 0], 0),
                ([7, 10, 13], 4),
            ],
        ),
        ::mstmm::generated::Places::new(
            0,
            [7, 10, 13],
            [
                ([0, 0, 0], 0),
                ([7, 10, 13], 16),
                ([7, 10, 13], 19),
                ([7, 10, 13], 22),
                ([0, 0, 0], 0),
                ([7, 10, 13], 4),
            ],
        ),
        ::mstmm::generated::Places::new(
            0,
            [7, 10, 13],
            [
                ([0, 0, 0], 0),
                ([7, 10, 13], 16),
                ([7, 10, 13], 19),
                ([7, 10, 13], 22),
                ([0, 0, 0], 0),
                ([0, 0, 0], 0),
            ],
        ),
    ];
    /// Connection point number `index`.
    #[inline(always)]
    fn point_(&self, index_: ::core::primitive::usize) -> ::mstmm::Point<T> {
        let (model_, numbers_) = (index_, &self.numbers[..]);
        <::mstmm::Point<T>>::read(numbers_, Self::PLACES_.get(model_), self.at_rest)
    }
    /// Acceleration, effort, input and output of hinge `tip`.
    #[inline]
    fn tip(
        &self,
    ) -> ::mstmm::HingeResult<
        T,
        ::mstmm::nalgebra::SVector<T, 3usize>,
        ::mstmm::Point<T>,
    > {
        let (input_, output_) = (self.point_(0), self.point_(1));
        ::mstmm::HingeResult::new(
            ::mstmm::generated::vector(
                ::mstmm::generated::piece::<T, 3>(self.accelerations.as_slice(), 0),
            ),
            ::mstmm::generated::vector(
                ::mstmm::generated::piece::<T, 3>(self.efforts.as_slice(), 0),
            ),
            input_,
            output_,
        )
    }
    /// Results at body `cone`: input and centre of mass.
    #[inline]
    fn cone(
        &self,
    ) -> ::mstmm::BodyResult<T, ::mstmm::Point<T>, ::mstmm::Written<false, true>> {
        let (input_, output_) = (self.point_(1), self.point_(2));
        ::mstmm::BodyResult::new(
            input_,
            output_,
            [T::constant(0f64), T::constant(0f64), T::constant(0.06f64)],
        )
    }
}
impl<T: ::mstmm::Scalar> ::core::fmt::Debug for TopWorkspace<T> {
    fn fmt(&self, to_: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
        to_.debug_struct("TopWorkspace")
            .field("accelerations", &self.accelerations)
            .field("efforts", &self.efforts)
            .field("kinetic_energy", &self.kinetic_energy)
            .field("potential_energy", &self.potential_energy)
            .field("points", &self.points())
            .finish()
    }
}
#[allow(dead_code, non_snake_case)]
impl<T: ::mstmm::Scalar> Top<T> {
    /// Room for the results of [`solve_into`](Self::solve_into), which mean nothing before.
    #[must_use]
    #[allow(clippy::all)]
    fn workspace(&self) -> TopWorkspace<T> {
        let zero_ = T::constant(0.0);
        TopWorkspace {
            accelerations: ::mstmm::generated::vector([zero_; 3]),
            efforts: ::mstmm::generated::vector([zero_; 3]),
            kinetic_energy: zero_,
            potential_energy: zero_,
            numbers: {
                let c_ = T::constant;
                ::mstmm::generated::with_known([T::constant(0.0); 24], &[(2, c_(9.8))])
            },
            at_rest: {
                let c_ = T::constant;
                ::mstmm::generated::with_known([T::constant(0.0); 3], &[(2, c_(9.8))])
            },
        }
    }
}
const _: () = {
    #[allow(dead_code)]
    fn elements<T: ::mstmm::Scalar>() {
        let _ = TopWorkspace::<T>::tip;
    }
};
#[allow(dead_code, non_camel_case_types, clippy::all)]
const _: () = {
    struct Cone;
    const _: Cone = Cone;
};
