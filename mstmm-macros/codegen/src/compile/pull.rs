//! The function for the gradient of the weighted accelerations.

use super::compiler::{ChainCompiler, Traced};
use super::{layouts, outputs};
use crate::equations::{AXES, OpenChain, virtual_power};
use crate::expr::Expr;
use crate::function::{Function, gradient, share_carries, substitute};
use crate::ids::SymbolId;
use crate::program::{Argument, Given};
use std::collections::HashMap;

impl<'a> ChainCompiler<'a> {
    /// Returns the function for the accelerations and the gradient of `yᵀ v̇`.
    ///
    /// Accelerations and virtual rates are symbols while the virtual power is differentiated, since they are held. They
    /// are replaced by their formulas afterwards. A small displacement, at which the power is differentiated, is set to zero.
    pub(super) fn pull(&self) -> Traced<'a> {
        let weights = self.given(Given::Vector);
        let [held, virtual_rates, displacement] =
            [Given::Accelerations, Given::VirtualRates, Given::CoordinateDirection]
                .map(|given| self.given(given));
        let ((solved, power), function) = self.traced(|tracer, trace| {
            let context = self.context(self.merged).with_loops(tracer);
            let chain = OpenChain::new(&context, AXES, trace);
            let (accelerations, pivots) = chain.accelerations(trace);
            let (z, _) = chain.inverse_mass_matrix_times(&weights, trace);
            let displaced =
                context.clone().with_accelerations(&held).with_displacement(&displacement);
            ((accelerations, pivots, z), virtual_power(&displaced, &virtual_rates, AXES))
        });
        let (accelerations, pivots, z) = solved;
        let (by, counts) = self.differentiated();
        let (function, derivatives) = gradient(function, self.graph.edge(power), &by);
        let mut derivatives: Vec<Expr> =
            derivatives.into_iter().map(|edge| self.graph.expr(edge)).collect();
        let mut part = |count: usize| derivatives.drain(..count).collect::<Vec<Expr>>();
        let [coordinates, rates, inputs, parameters] = counts.map(&mut part);
        let input_layout = layouts::inputs(self.chain, self.layout);
        let outputs = vec![
            self.rates(outputs::ACCELERATIONS, &accelerations),
            self.rates(outputs::BY_COORDINATES, &coordinates),
            self.rates(outputs::BY_RATES, &rates),
            self.output(outputs::BY_INPUTS, input_layout, &inputs),
            self.output(outputs::BY_PARAMETERS, layouts::parameters(self.chain), &parameters),
        ];
        let function = Function { outputs, pivots: self.pivots(&pivots), ..function };
        let zeros = vec![Expr::Number(0.0); displacement.len()];
        let replaced = [
            (Given::Accelerations, accelerations),
            (Given::VirtualRates, z),
            (Given::CoordinateDirection, zeros),
        ];
        let formulas: HashMap<SymbolId, Expr> = replaced
            .into_iter()
            .flat_map(|(given, formulas)| {
                self.unknowns.of(Argument::Given(given)).into_iter().zip(formulas)
            })
            .collect();
        // The kinematics of the displaced chain are then those of forward dynamics.
        share_carries(substitute(function, &formulas)).into()
    }

    /// Returns the symbols that the power is differentiated by, and the numbers of those along coordinates, rates, inputs and
    /// parameters.
    fn differentiated(&self) -> (Vec<SymbolId>, [usize; 4]) {
        let of = |argument| self.unknowns.of(argument).into_iter().collect::<Vec<SymbolId>>();
        let inputs = self.layout.inputs.ids().into_iter();
        let parameters = self.chain.parameters.ids().into_iter();
        let groups = [
            of(Argument::Given(Given::CoordinateDirection)),
            of(Argument::Rates),
            inputs.flat_map(|input| of(Argument::Input(input))).collect(),
            parameters.flat_map(|parameter| of(Argument::Parameter(parameter))).collect(),
        ];
        let counts = groups.each_ref().map(Vec::len);
        (groups.concat(), counts)
    }
}
