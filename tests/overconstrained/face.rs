//! Linkages written once, as chains of both methods and as data, with one face for all chains.

use super::algebra::Real;
use mstmm::{Chain, ChainState, Error, GeneratedChain};

/// What a chain says at one instant.
#[derive(Clone, Debug)]
pub struct Answer {
    /// By the fast path.
    pub fast: Vec<f64>,
    /// By `solve_into`.
    pub accelerations: Vec<f64>,
    pub redundant: usize,
    /// Force and moment in inertial axes.
    pub undetermined: Vec<[f64; 6]>,
    /// Force and moment of the ground on the last body, at the closing pin, inertial axes.
    pub reaction: Vec<f64>,
}

/// A generated linkage.
pub trait Closed: GeneratedChain + Default
where
    <Self as Chain>::Scalar: Real,
{
    fn answer(&self, state: &Self::State) -> Result<Answer, Error>;

    fn state(&self, q: &[Self::Scalar], v: &[Self::Scalar]) -> Self::State {
        let mut state = self.initial_state();
        state.coordinates_mut().copy_from_slice(q);
        state.rates_mut().copy_from_slice(v);
        state
    }
}

/// Values in double precision.
pub fn doubles<T: Real>(list: &[T]) -> Vec<f64> {
    list.iter().map(|x| x.double()).collect()
}

/// Writes a linkage as a chain by `riccati`, as one by `transfer`, and as data for the reference.
///
/// A frame is a position in m and a quaternion, a body its mass in kg, its centre of mass in m, its
/// tensor about that in kg m², and its output. Each pin has a start in rad and in rad/s.
macro_rules! linkage {
    (
        $name:ident: $riccati:ident $transfer:ident rank $rank:literal range $range:expr;
        gravity $gravity:tt;
        from $from:tt $from_turned:tt;
        $(
            pin $axis:tt $hinge:ident $start:tt $rate:tt
                -> $Type:ident $body:ident $mass:tt $com:tt $inertia:tt $out:tt $turned:tt;
        )*
        closing $last_axis:tt $last:ident $last_start:tt $last_rate:tt;
        to $to:tt $to_turned:tt;
    ) => {
        linkage! { @chains $riccati $transfer $last {
            gravity = $gravity m/s^2;
            $( body $Type {
                mass = $mass kg;
                com = $com m;
                inertia = tensor $inertia kg*m^2 about com;
                output = $out m turned quaternion $turned;
            } )*
            ground at $from m turned quaternion $from_turned
                $( -> pin($axis) $hinge -> $Type $body )*
                -> pin($last_axis) $last -> ground at $to m turned quaternion $to_turned;
            $( hinge $hinge { start = $start rad; start_rate = $rate rad/s; } )*
            hinge $last { start = $last_start rad; start_rate = $last_rate rad/s; }
        } }

        #[allow(unused_parens)]
        pub fn $name() -> $crate::overconstrained::linkage::Linkage {
            use $crate::overconstrained::linkage::{Frame, Link, Linkage};
            let frame = |position, (w, x, y, z)| Frame { position, turned: [w, x, y, z] };
            let tensor = |(xx, yy, zz, xy, xz, yz)| [xx, yy, zz, xy, xz, yz];
            Linkage {
                name: stringify!($riccati),
                gravity: $gravity,
                from: frame($from, $from_turned),
                links: vec![ $( Link {
                    axis: $axis,
                    mass: $mass,
                    com: $com,
                    inertia: tensor($inertia),
                    output: frame($out, $turned),
                } ),* ],
                last: $last_axis,
                to: frame($to, $to_turned),
                rank: $rank,
                range: $range,
                start: vec![$($start,)* $last_start],
                start_rate: vec![$($rate,)* $last_rate],
            }
        }
    };
    (@chains $riccati:ident $transfer:ident $last:ident { $($description:tt)* }) => {
        mstmm::mstmm_chain! { pub chain $riccati { method = riccati; $($description)* } }
        mstmm::mstmm_chain! { pub chain $transfer { method = transfer; $($description)* } }
        linkage! { @face $riccati $last }
        linkage! { @face $transfer $last }
    };
    (@face $name:ident $last:ident) => {
        impl<T> $crate::overconstrained::face::Closed for $name<T>
        where
            T: $crate::overconstrained::algebra::Real,
        {
            fn answer(
                &self,
                state: &Self::State,
            ) -> Result<$crate::overconstrained::face::Answer, mstmm::Error> {
                use $crate::overconstrained::algebra::transformed;
                use $crate::overconstrained::face::doubles;
                let inputs = self.no_inputs();
                let fast = self.accelerations(state, &inputs)?;
                let mut at = self.workspace();
                self.solve_into(state, &inputs, &mut at)?;
                let point = at.$last().input();
                let force = doubles(point.force().as_slice());
                let moment = doubles(point.moment().as_slice());
                let axes = point.orientation();
                let row = |k: usize| [0, 1, 2].map(|j| axes.matrix()[(k, j)].double());
                let axes = [0, 1, 2].map(row);
                let inertial = |wrench: &[T; 6]| {
                    let [fx, fy, fz, mx, my, mz] = wrench.map(|x| x.double());
                    let force = transformed(&axes, [fx, fy, fz]);
                    let moment = transformed(&axes, [mx, my, mz]);
                    [force[0], force[1], force[2], moment[0], moment[1], moment[2]]
                };
                // The force acts reversed on the body whose output this is, the moment as it is.
                let force = force.into_iter().map(|x| -x);
                Ok($crate::overconstrained::face::Answer {
                    fast: doubles(fast.as_slice()),
                    accelerations: doubles(at.accelerations().as_slice()),
                    redundant: at.closure().redundant(),
                    undetermined: at
                        .closure()
                        .undetermined()
                        .iter()
                        .map(inertial)
                        .collect(),
                    reaction: force.chain(moment).collect(),
                })
            }
        }
    };
}

/// Calls a macro with all linkages: the module, the function and both chains of each.
macro_rules! each_linkage {
    ($given:ident) => {
        $given! {
            bennett::bennett Bennett BennettByTransfer;
            bennett::bennett_tilted BennettTilted BennettTiltedByTransfer;
            bennett::bennett_slender BennettSlender BennettSlenderByTransfer;
            bennett::bennett_slender_tilted BennettSlenderTilted BennettSlenderTiltedByTransfer;
            sarrus::sarrus Sarrus SarrusByTransfer;
            sarrus::sarrus_tilted SarrusTilted SarrusTiltedByTransfer;
            goldberg::goldberg Goldberg GoldbergByTransfer;
            goldberg::goldberg_tilted GoldbergTilted GoldbergTiltedByTransfer;
            bricard::bricard Bricard BricardByTransfer;
            bricard::bricard_tilted BricardTilted BricardTiltedByTransfer;
            bricard::trihedral Trihedral TrihedralByTransfer;
            bricard::trihedral_tilted TrihedralTilted TrihedralTiltedByTransfer;
            four_bars::parallel Parallel ParallelByTransfer;
            four_bars::parallel_tilted ParallelTilted ParallelTiltedByTransfer;
            four_bars::spherical Spherical SphericalByTransfer;
            four_bars::spherical_tilted SphericalTilted SphericalTiltedByTransfer;
        }
    };
}
