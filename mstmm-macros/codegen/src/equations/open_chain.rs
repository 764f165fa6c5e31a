//! Forward dynamics of an open chain together with products of the inverse mass matrix. Both solve the
//! same linear problem with different right sides, so they share the factors of the Riccati transfer.
//!
//! ```text
//! M(q) v̇ + bias(q, v) = τ         forward dynamics
//! M(q) y = x                      y = M⁻¹ x: no gravity, velocities and loads; efforts x
//! ```

use super::base_parameters::{OriginalInertia, to_base_parameters};
use super::composite::{outward_rates, unit_vector};
use super::dense_matrix::DenseMatrix;
use super::forward_dynamics::motion_problem;
use super::kinematics::{BiasAcceleration, LinkKinematics};
use super::motion_problem::{HingePivot, MotionProblem};
use super::strategy::uses_base_parameters;
use super::sweep::PerLink;
use super::{Axes, EvalContext, Trace, kinematics, riccati};
use crate::math::{Motion, Scalar, Wrench};
use crate::model::SolutionMethod;

/// The links of an open chain in a state.
#[derive(Debug)]
pub struct OpenChain<'a, S> {
    context: &'a EvalContext<'a, S>,
    links: PerLink<LinkKinematics<S>>,
    original_inertias: Option<PerLink<OriginalInertia<S>>>,
}

impl<'a, S: Scalar> OpenChain<'a, S> {
    /// Returns the links of the chain in `context`.
    pub fn new(context: &'a EvalContext<'a, S>, axes: Axes, trace: &mut Trace<S>) -> Self {
        if !context.layout.loop_hinges.is_empty() {
            bug!("a closed chain has no inverse of its mass matrix")
        }
        let mut links = kinematics(context, axes, trace);
        let original_inertias = uses_base_parameters(SolutionMethod::Riccati, axes, false)
            .then(|| to_base_parameters(context, &mut links, trace));
        OpenChain { context, links, original_inertias }
    }

    /// Solves for the accelerations `v̇` of all free rates; returns them in the layout's order, with the
    /// pivots.
    pub fn accelerations(&self, trace: &mut Trace<S>) -> (Vec<S>, Vec<HingePivot<S>>) {
        let problem = MotionProblem {
            original_inertias: self.original_inertias.clone(),
            ..motion_problem(self.context, &self.links, None, trace)
        };
        let (solution, pivots) = riccati::solve(&problem, trace);
        (solution.rates(&self.links, self.context.layout), pivots)
    }

    /// Returns `M⁻¹ x` for a vector with one entry for each free rate, in the layout's order, with the
    /// pivots.
    pub fn inverse_mass_matrix_times(
        &self,
        x: &[S],
        trace: &mut Trace<S>,
    ) -> (Vec<S>, Vec<HingePivot<S>>) {
        let (context, links) = (self.context, &self.links);
        let efforts = |link: &LinkKinematics<S>| {
            link.hinge.basis.to_basis(&x[context.layout.v[link.hinge.id].clone()])
        };
        let problem = MotionProblem {
            links,
            dimension: context.chain.dimension,
            tree: context.tree,
            bias_accelerations: links.iter().map(|_| BiasAcceleration::zero()).collect(),
            bias_forces: links.iter().map(|_| Wrench::zero()).collect(),
            efforts: links.iter().map(efforts).collect(),
            base_acceleration: Motion::zero(),
            loop_constraints: None,
            original_inertias: self.original_inertias.clone(),
            added_inertia: None,
        };
        let (solution, pivots) = riccati::solve(&problem, &mut Trace::silent());
        let product = solution.rates(links, context.layout);
        trace.section("product", "Product with the inverse of the mass matrix", "");
        product
            .iter()
            .enumerate()
            .for_each(|(k, &entry)| trace.number(format!("product{k}"), entry));
        (product, pivots)
    }

    /// Returns `M⁻¹`, with the pivots. Of each pair of symmetric entries one is computed: that of the column
    /// of the hinge further outboard, whose accelerations are needed only up to this hinge.
    pub fn inverse_mass_matrix(
        &self,
        trace: &mut Trace<S>,
    ) -> (DenseMatrix<S>, Vec<HingePivot<S>>) {
        let count = self.context.layout.dof_count();
        let mut matrix = DenseMatrix::zero(count, count);
        let mut pivots = Vec::new();
        let outward = outward_rates(self.context.layout);
        for (number, &(_, column)) in outward.iter().enumerate() {
            let unit = unit_vector(count, column);
            let (product, of_solution) = self.inverse_mass_matrix_times(&unit, trace);
            for &(_, row) in &outward[..=number] {
                matrix.set(row, column, product[row]);
                matrix.set(column, row, product[row]);
            }
            pivots = of_solution;
        }
        (matrix, pivots)
    }
}
