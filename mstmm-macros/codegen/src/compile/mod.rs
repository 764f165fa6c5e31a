//! From a model to its programs: the equations written down, simplified and ordered.

use crate::equations::{self, Axes, Numbers, Pivot, Situation, Solved, Trace};
use crate::expr::{Edge, Expr, Graph, Stage};
use crate::model::{Chain, Hinge, HingeKind, Layout, Method, Value};
use crate::passes::{Heading, Setup, factor, schedule};
use crate::program::Program;
use crate::symbols::Symbols;

/// Everything that is computed for a chain, as programs.
#[derive(Clone, Debug)]
pub struct Programs {
    /// Numbers and names of the unknowns that all programs read.
    pub symbols: Symbols,
    /// The method that the accelerations are solved with.
    pub method: Method,
    /// Parameters and constants to the slots of all other programs, then to the masses that
    /// [`Programs::checked_masses`] names.
    pub setup: Program,
    /// Bodies whose mass is known at run time only.
    pub checked_masses: Vec<usize>,
    /// To the start values of `q` and `v`.
    pub start: Program,
    /// `q`, `v`, inputs to `v̇`, pivots and their scales.
    pub accelerations: Program,
    /// Links that the pivots belong to.
    pub pivots: Vec<usize>,
    /// `q`, `v`, inputs to `v̇`, pivots, scales, efforts, energies, then one group a point.
    pub solution: Program,
    /// `q`, `v` to kinetic and potential energy.
    pub energy: Program,
    /// `q`, `v` to `q̇`.
    pub coordinate_rates: Program,
    /// `q` to `q` with unit quaternions.
    pub normalized: Program,
}

/// The axes of the sweeps. In inertial axes `riccati` took 45 % more operations in the best case
/// measured (thirty balls) and six times as many in the worst (one ball).
const AXES: Axes = Axes::Body;

/// Chains of up to this many bodies are also counted with `transfer`; for longer ones `riccati`
/// was cheaper in every case measured.
const COUNTED_WITH_TRANSFER: usize = 2;

/// Writes down, simplifies and orders all equations of `chain`.
pub fn programs(chain: &Chain, layout: &Layout) -> Programs {
    let symbols = Symbols::of(chain, layout);
    let graph = Graph::default();
    let scene = Scene::new(chain, layout, &symbols, &graph);
    let mut setup = Setup::default();
    let method = scene.cheapest();
    let (accelerations, pivots) = scene.accelerations(method, &mut setup);
    let solution = scene.solution(method, &mut setup);
    let energy = scene.energy(&mut setup);
    let coordinate_rates = scene.coordinates(&mut setup, equations::hinge::coordinate_rates);
    let normalized =
        scene.coordinates(&mut setup, |kind, q, _| equations::hinge::normalized(kind, q));
    let start = scene.start(&mut setup);
    let (setup, checked_masses) = scene.setup(setup);
    Programs {
        symbols: symbols.clone(),
        method,
        setup,
        checked_masses,
        start,
        accelerations,
        pivots,
        solution,
        energy,
        coordinate_rates,
        normalized,
    }
}

/// A chain in a state of unknowns.
struct Scene<'a, 'g> {
    chain: &'a Chain,
    layout: &'a Layout,
    symbols: &'a Symbols,
    graph: &'g Graph,
    numbers: Numbers<Expr<'g>>,
    q: Vec<Expr<'g>>,
    v: Vec<Expr<'g>>,
    inputs: Vec<Expr<'g>>,
}

impl<'a, 'g> Scene<'a, 'g> {
    fn new(chain: &'a Chain, layout: &'a Layout, symbols: &'a Symbols, graph: &'g Graph) -> Self {
        let unknowns = |range: std::ops::Range<usize>, stage| {
            range.map(|number| graph.symbol(number as u32, stage)).collect()
        };
        Scene {
            chain,
            layout,
            symbols,
            graph,
            numbers: Numbers {
                parameters: unknowns(symbols.parameters(), Stage::Setup),
                constants: unknowns(symbols.constants(), Stage::Setup),
            },
            q: unknowns(symbols.q(), Stage::State),
            v: unknowns(symbols.v(), Stage::State),
            inputs: unknowns(symbols.inputs(), Stage::State),
        }
    }

    fn situation(&self) -> Situation<'_, Expr<'g>> {
        Situation {
            chain: self.chain,
            layout: self.layout,
            numbers: &self.numbers,
            q: &self.q,
            v: &self.v,
            inputs: &self.inputs,
        }
    }

    /// Simplifies and orders what leads to `outputs`.
    fn program(
        &self,
        stage: Stage,
        trace: &Trace<Expr<'g>>,
        outputs: &[Vec<Expr<'g>>],
        setup: &mut Setup,
    ) -> Program {
        let edges: Vec<Vec<Edge>> = outputs
            .iter()
            .map(|group| group.iter().map(|&expr| self.graph.edge(expr)).collect())
            .collect();
        let results: Vec<Edge> = edges.iter().flatten().copied().collect();
        let image = factor(self.graph, &results);
        let go = |edge: Edge| {
            image[edge.node() as usize]
                .map(|image| if edge.is_negative() { image.negated() } else { image })
        };
        let outputs: Vec<Vec<Edge>> =
            edges.iter().map(|group| group.iter().filter_map(|&edge| go(edge)).collect()).collect();
        let headings: Vec<Heading> = trace
            .sections
            .iter()
            .map(|section| Heading {
                title: section.title.clone(),
                source: section.source.to_owned(),
                values: section
                    .values
                    .iter()
                    .filter_map(|(name, expr)| match expr {
                        Expr::Formula(_, edge) => image
                            .get(edge.node() as usize)
                            .and_then(|_| go(*edge))
                            .map(|edge| (name.clone(), edge)),
                        Expr::Number(_) => None,
                    })
                    .collect(),
            })
            .collect();
        schedule(self.graph, self.symbols.names(), stage, &headings, &outputs, setup)
    }

    /// The method asked for, or the cheapest.
    fn cheapest(&self) -> Method {
        if let Some(method) = self.chain.method {
            return method;
        }
        if self.layout.links.len() > COUNTED_WITH_TRANSFER {
            return Method::Riccati;
        }
        let cost = |method| {
            let (program, _) = self.accelerations(method, &mut Setup::default());
            program.cost().arithmetic()
        };
        if cost(Method::Transfer) < cost(Method::Riccati) {
            Method::Transfer
        } else {
            Method::Riccati
        }
    }

    fn accelerations(&self, method: Method, setup: &mut Setup) -> (Program, Vec<usize>) {
        let mut trace = Trace::new();
        let solved = equations::accelerations(&self.situation(), method, AXES, &mut trace);
        let (groups, links) = split(&solved);
        (self.program(Stage::State, &trace, &groups, setup), links)
    }

    fn solution(&self, method: Method, setup: &mut Setup) -> Program {
        let mut trace = Trace::new();
        let situation = self.situation();
        let solved = equations::accelerations(&situation, method, AXES, &mut trace);
        let report = equations::report(&situation, &solved.accelerations, &mut trace);
        let energy = equations::energy(&situation, &mut trace);
        let (mut groups, _) = split(&solved);
        groups.push(self.numbers.efforts(self.chain, self.layout, &self.inputs));
        groups.push(vec![energy.kinetic, energy.potential]);
        groups.extend(report.points.iter().map(|point| {
            let mut all = point.position.0.to_vec();
            all.extend(point.rotation.0.iter().flatten());
            all.extend(point.velocity.0);
            all.extend(point.omega.0);
            all.extend(point.acceleration.linear.0);
            all.extend(point.acceleration.angular.0);
            all.extend(point.moment.0);
            all.extend(point.force.0);
            all
        }));
        self.program(Stage::State, &trace, &groups, setup)
    }

    fn energy(&self, setup: &mut Setup) -> Program {
        let mut trace = Trace::new();
        let energy = equations::energy(&self.situation(), &mut trace);
        self.program(Stage::State, &trace, &[vec![energy.kinetic, energy.potential]], setup)
    }

    /// A program that maps every hinge's coordinates (and rates).
    fn coordinates(
        &self,
        setup: &mut Setup,
        map: impl Fn(&HingeKind, &[Expr<'g>], &[Expr<'g>]) -> Vec<Expr<'g>>,
    ) -> Program {
        let layout = self.layout;
        let one = |(index, hinge): (usize, &Hinge)| {
            map(&hinge.kind, &self.q[layout.q[index].clone()], &self.v[layout.v[index].clone()])
        };
        let outputs = self.chain.hinges.iter().enumerate().flat_map(one).collect();
        self.program(Stage::State, &Trace::new(), &[outputs], setup)
    }

    fn start(&self, setup: &mut Setup) -> Program {
        let values = |all: fn(&Hinge) -> &Vec<Value>| {
            let values = self.chain.hinges.iter().flat_map(all);
            values.map(|value| self.numbers.scalar(value)).collect::<Vec<_>>()
        };
        let outputs = [values(|hinge| &hinge.start), values(|hinge| &hinge.start_rate)];
        self.program(Stage::State, &Trace::new(), &outputs, setup)
    }

    fn setup(&self, setup: Setup) -> (Program, Vec<usize>) {
        let bodies = &self.chain.bodies;
        let checked: Vec<usize> =
            (0..bodies.len()).filter(|&body| bodies[body].mass.known().is_none()).collect();
        let mut trace = Trace::new();
        trace.section("Quantities derived from parameters and constants", "");
        let mut slots = Vec::new();
        for (name, edge) in setup.values() {
            let value = self.graph.expr(edge);
            trace.number(name, value);
            slots.push(value);
        }
        let masses = checked.iter().map(|&body| self.numbers.scalar(&bodies[body].mass)).collect();
        let program = self.program(Stage::Setup, &trace, &[slots, masses], &mut Setup::default());
        (program, checked)
    }
}

/// How many units in the last place of its scale a pivot must exceed: the same as in every step.
const NOISE: f64 = 8.0;

/// Whether a pivot is known, and known to be positive beyond rounding, so that no step has to look.
fn is_positive(pivot: &Pivot<Expr>) -> bool {
    match (pivot.value.known(), pivot.scale.known()) {
        (Some(value), Some(scale)) => value > NOISE * f64::EPSILON * scale,
        _ => false,
    }
}

/// `v̇`, pivots and scales as groups of outputs, and the links of the pivots.
fn split<'g>(solved: &Solved<Expr<'g>>) -> (Vec<Vec<Expr<'g>>>, Vec<usize>) {
    let pivots: Vec<_> = solved.pivots.iter().filter(|pivot| !is_positive(pivot)).collect();
    let groups = vec![
        solved.accelerations.clone(),
        pivots.iter().map(|pivot| pivot.value).collect(),
        pivots.iter().map(|pivot| pivot.scale).collect(),
    ];
    (groups, pivots.iter().map(|pivot| pivot.link).collect())
}
