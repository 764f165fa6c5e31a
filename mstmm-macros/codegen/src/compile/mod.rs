//! From a model to its programs: the equations written down, simplified and ordered.

mod arrange;
pub mod groups;
mod places;
mod text;

pub use places::{Place, Places, PointPlaces, Sight};
pub use text::chain_text;

use crate::equations::{self, Axes, Numbers, Pivot, Situation, Solved, Trace};
use crate::examine::Findings;
use crate::expr::{Expr, Graph, Stage};
use crate::math::NOISE;
use crate::model::{
    Chain, Check, ClosureRank, Hinge, HingeId, HingeKind, Layout, Method, Passive, RepeatId, Value,
};
use crate::passes::Setup;
use crate::program::Program;
use crate::symbols::Symbols;

/// Everything that is computed for a chain, as programs.
#[derive(Clone, Debug)]
pub struct Programs {
    /// Numbers and names of the unknowns that all programs read.
    pub symbols: Symbols,
    /// The method that the accelerations are solved with.
    pub method: Method,
    /// Parameters and constants to the slots of all other programs that stand once, to the numbers
    /// of [`Programs::checks`], then to the slots of every repeated part.
    pub setup: Program,
    /// Numbers that are known at run time only, and what they must be.
    pub checks: Vec<Check>,
    /// To the start values of `q` and `v`.
    pub start: Program,
    /// `q`, `v`, inputs to `v̇`, pivots and their scales.
    pub accelerations: Program,
    /// The same for a linearly implicit step, where that makes a difference, and the hinges that its
    /// pivots belong to.
    pub implicit: Option<(Program, Vec<HingeId>)>,
    /// Hinges that the pivots belong to.
    pub pivots: Vec<HingeId>,
    /// `q`, `v`, inputs to all that is asked for, by [`groups`].
    pub solution: Program,
    /// Where connection points have their numbers.
    pub places: Places,
    /// How many directions the closing hinge holds, if there is one.
    pub held: Option<usize>,
    /// `q`, `v`, inputs to kinetic and potential energy.
    pub energy: Program,
    /// `q`, `v` to `q̇`.
    pub coordinate_rates: Program,
    /// `q` to `q` with unit quaternions.
    pub normalized: Program,
    /// `q`, `v`, inputs to both put back onto the closure, and to how far off they were.
    pub correction: Option<Program>,
    /// `q` to the pivots of the closing hinge with all steps, the largest first, where the rank of the
    /// closure is found at run time.
    pub closure_pivots: Option<Program>,
}

/// The axes of the sweeps. In inertial axes `riccati` took 45 % more operations in the best case
/// measured (thirty balls) and six times as many in the worst (one ball).
const AXES: Axes = Axes::Body;

/// For whom programs are ordered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Reader {
    /// In the order of the equations.
    Person,
    /// With the terms of sums, loops and statements in the order in which a processor waits least.
    Processor,
}

/// Writes down, simplifies and orders all equations of `chain`, of which `findings` are known.
pub fn programs(chain: &Chain, findings: &Findings, layout: &Layout) -> Programs {
    programs_for(Reader::Processor, chain, findings, layout)
}

/// The same without what is done for processors.
fn readable(chain: &Chain, findings: &Findings, layout: &Layout) -> Programs {
    programs_for(Reader::Person, chain, findings, layout)
}

fn programs_for(reader: Reader, chain: &Chain, findings: &Findings, layout: &Layout) -> Programs {
    let symbols = Symbols::of(chain, layout, findings.closure_rank);
    let merged = Layout::merged(chain);
    let graph = Graph::default();
    let scene = Scene::new(reader, chain, findings, (layout, &merged), &symbols, &graph);
    let mut setup = Setup::default();
    let method = chain.method.unwrap_or(Method::Riccati);
    let (accelerations, pivots) = scene.accelerations(method, &mut setup);
    let yields = chain.hinges.iter().flat_map(|hinge| &hinge.passive).any(Passive::has_effort);
    let implicit = yields.then(|| scene.implicit(method, &mut setup));
    let (solution, places, held) = scene.solution(method, &mut setup);
    let energy = scene.energy(&mut setup);
    let coordinate_rates = scene.coordinates(&mut setup, equations::hinge::coordinate_rates);
    let normalized =
        scene.coordinates(&mut setup, |kind, q, _| equations::hinge::normalized(kind, q));
    let correction = scene.correction(&mut setup);
    let closure_pivots = scene.closure_pivots(&mut setup);
    let start = scene.start(&mut setup);
    let (setup, checks) = scene.setup(setup);
    Programs {
        symbols: symbols.clone(),
        method,
        setup,
        checks,
        start,
        accelerations,
        implicit,
        pivots,
        solution,
        places,
        held,
        energy,
        coordinate_rates,
        normalized,
        correction,
        closure_pivots,
    }
}

/// A chain in a state of unknowns.
struct Scene<'a, 'g> {
    reader: Reader,
    chain: &'a Chain,
    findings: &'a Findings,
    layout: &'a Layout,
    /// The layout with welded bodies merged, which has the same hinges in the same places.
    merged: &'a Layout,
    symbols: &'a Symbols,
    graph: &'g Graph,
    numbers: Numbers<Expr<'g>>,
    q: Vec<Expr<'g>>,
    v: Vec<Expr<'g>>,
    inputs: Vec<Expr<'g>>,
    step: Expr<'g>,
}

impl<'a, 'g> Scene<'a, 'g> {
    fn new(
        reader: Reader,
        chain: &'a Chain,
        findings: &'a Findings,
        (layout, merged): (&'a Layout, &'a Layout),
        symbols: &'a Symbols,
        graph: &'g Graph,
    ) -> Self {
        let unknowns = |range: std::ops::Range<usize>, stage| {
            range.map(|number| graph.symbol(number as u32, stage)).collect()
        };
        Scene {
            reader,
            chain,
            findings,
            layout,
            merged,
            symbols,
            graph,
            numbers: Numbers {
                parameters: unknowns(symbols.parameters(), Stage::Setup),
                constants: unknowns(symbols.constants(), Stage::Setup),
                closure_steps: unknowns(symbols.closure_steps(), Stage::Setup),
            },
            q: unknowns(symbols.q(), Stage::State),
            v: unknowns(symbols.v(), Stage::State),
            inputs: unknowns(symbols.inputs(), Stage::State),
            step: graph.symbol(symbols.step().start as u32, Stage::State),
        }
    }

    fn situation<'b>(&'b self, layout: &'b Layout) -> Situation<'b, Expr<'g>> {
        self.situation_with(layout, &self.numbers)
    }

    fn situation_with<'b>(
        &'b self,
        layout: &'b Layout,
        numbers: &'b Numbers<Expr<'g>>,
    ) -> Situation<'b, Expr<'g>> {
        let &Findings { held_by_closure, closure_rank, .. } = self.findings;
        let state = (&self.q[..], &self.v[..], &self.inputs[..]);
        Situation::new(self.chain, layout, numbers, state).knowing(held_by_closure, closure_rank)
    }

    fn accelerations(&self, method: Method, setup: &mut Setup) -> (Program, Vec<HingeId>) {
        self.solved(method, setup, |situation| situation)
    }

    fn implicit(&self, method: Method, setup: &mut Setup) -> (Program, Vec<HingeId>) {
        self.solved(method, setup, |situation| situation.within(self.step))
    }

    fn solved(
        &self,
        method: Method,
        setup: &mut Setup,
        set: impl for<'b> Fn(Situation<'b, Expr<'g>>) -> Situation<'b, Expr<'g>>,
    ) -> (Program, Vec<HingeId>) {
        let (solved, trace, turns) = self.woven(|loom, trace| {
            let situation = set(self.situation(self.merged)).woven(loom);
            equations::accelerations(&situation, method, AXES, trace)
        });
        let (groups, hinges) = self.split(&solved);
        let program = self.program(Stage::State, &trace, &groups, &turns, setup);
        (self.issued(program), hinges)
    }

    fn solution(&self, method: Method, setup: &mut Setup) -> (Program, Places, Option<usize>) {
        let results = self.chain.results;
        let ((solved, report, energy), trace, turns) = self.woven(|loom, trace| {
            let merged = self.situation(self.merged).woven(loom);
            let (solved, swept) = equations::sweep(&merged, method, AXES, trace);
            let situation = self.situation(self.layout).woven(loom);
            let report = equations::report(&situation, (&solved, &swept), trace);
            let energy = results.energies.then(|| equations::energy(&situation, trace));
            (solved, report, energy)
        });
        let (mut groups, _) = self.split(&solved);
        let undetermined = solved.reaction.map(|reaction| reaction.undetermined);
        let held = undetermined.as_ref().map(Vec::len);
        let wrenches = undetermined.into_iter().flatten();
        let wrenches = wrenches.flat_map(|w| w.force.0.into_iter().chain(w.moment.0));
        let (places, numbers) =
            places::places(self.chain, self.graph, &report.points, &self.numbers);
        let (shifts, zero) = (self.chain.dimension.shifts(), Expr::Number(0.0));
        groups.extend([
            report.accelerations,
            report.efforts,
            energy.map_or(Vec::new(), |energy| vec![energy.kinetic, energy.potential]),
            wrenches.collect(),
            numbers,
            shifts
                .iter()
                .map(|&axis| if results.z { report.at_rest[axis] } else { zero })
                .collect(),
        ]);
        let program = self.program(Stage::State, &trace, &groups, &turns, setup);
        (self.issued(program), places, held)
    }

    fn energy(&self, setup: &mut Setup) -> Program {
        let (energy, trace, turns) = self.woven(|loom, trace| {
            equations::energy(&self.situation(self.layout).woven(loom), trace)
        });
        let groups = [vec![energy.kinetic, energy.potential]];
        self.program(Stage::State, &trace, &groups, &turns, setup)
    }

    fn correction(&self, setup: &mut Setup) -> Option<Program> {
        let (correction, trace, turns) = self.woven(|loom, trace| {
            equations::correction(&self.situation(self.merged).woven(loom), trace)
        });
        let correction = correction?;
        let q = equations::moved(self.chain, self.layout, &self.q, &correction.coordinates);
        let v = self.v.iter().zip(correction.rates).map(|(&v, change)| v + change).collect();
        let groups = [q, v, vec![correction.residual, correction.excess]];
        Some(self.program(Stage::State, &trace, &groups, &turns, setup))
    }

    fn closure_pivots(&self, setup: &mut Setup) -> Option<Program> {
        let ClosureRank::FoundAtRunTime(directions) = self.findings.closure_rank else {
            return None;
        };
        let numbers = Numbers { closure_steps: Vec::new(), ..self.numbers.clone() };
        let (solved, trace, turns) = self.woven(|loom, trace| {
            let situation = self.situation_with(self.merged, &numbers).woven(loom);
            equations::accelerations(&situation, Method::Riccati, AXES, trace)
        });
        let Some(reaction) = solved.reaction else {
            bug!("the rank of a closure is to be found, and nothing closes")
        };
        // Directions that are held in no state have none.
        let mut pivots = reaction.pivots;
        if pivots.len() > directions {
            bug!("a closing hinge has {} pivots for {directions} directions", pivots.len())
        }
        pivots.resize(directions, Expr::Number(0.0));
        Some(self.program(Stage::State, &trace, &[pivots], &turns, setup))
    }

    /// A program that maps every hinge's coordinates (and rates).
    fn coordinates(
        &self,
        setup: &mut Setup,
        map: impl Fn(&HingeKind, &[Expr<'g>], &[Expr<'g>]) -> Vec<Expr<'g>>,
    ) -> Program {
        let layout = self.layout;
        let one = |(index, hinge): (HingeId, &Hinge)| {
            if hinge.is_prescribed() {
                return Vec::new();
            }
            map(&hinge.kind, &self.q[layout.q[index].clone()], &self.v[layout.v[index].clone()])
        };
        let outputs = self.chain.hinges.enumerate().flat_map(one).collect();
        self.program(Stage::State, &Trace::new(), &[outputs], &[], setup)
    }

    /// `v̇`, pivots and scales as groups of outputs, and the hinges of the pivots.
    fn split(&self, solved: &Solved<Expr<'g>>) -> (Vec<Vec<Expr<'g>>>, Vec<HingeId>) {
        let pivots: Vec<_> = solved.pivots.iter().filter(|pivot| !is_positive(pivot)).collect();
        let groups = vec![
            solved.accelerations.clone(),
            pivots.iter().map(|pivot| pivot.value).collect(),
            pivots.iter().map(|pivot| pivot.scale).collect(),
        ];
        (groups, pivots.iter().map(|pivot| self.merged.links[pivot.link].hinge).collect())
    }

    fn start(&self, setup: &mut Setup) -> Program {
        let values = |all: fn(&Hinge) -> &Vec<Value>| {
            let values =
                self.chain.hinges.iter().filter(|hinge| !hinge.is_prescribed()).flat_map(all);
            values.map(|value| self.numbers.scalar(value)).collect::<Vec<_>>()
        };
        let outputs = [values(|hinge| &hinge.start), values(|hinge| &hinge.start_rate)];
        self.program(Stage::State, &Trace::new(), &outputs, &[], setup)
    }

    fn setup(&self, setup: Setup) -> (Program, Vec<Check>) {
        let checks = self.chain.checks();
        let mut trace = Trace::new();
        trace.section("derived", "Quantities derived from parameters and constants", "");
        let mut group = |part: Option<RepeatId>| {
            let mut slots = Vec::new();
            for (name, edge) in setup.values(part) {
                let value = self.graph.expr(edge);
                trace.number(name, value);
                slots.push(value);
            }
            slots
        };
        let once = group(None);
        let parts: Vec<Vec<Expr<'g>>> =
            self.chain.repeats.ids().into_iter().map(|part| group(Some(part))).collect();
        let checked = checks.iter().map(|check| self.numbers.scalar(&check.value)).collect();
        let groups: Vec<Vec<Expr<'g>>> = [once, checked].into_iter().chain(parts).collect();
        let program = self.program(Stage::Setup, &trace, &groups, &[], &mut Setup::default());
        (program, checks)
    }
}

/// Whether a pivot is known, and known to be positive beyond rounding, so that no step has to look.
fn is_positive(pivot: &Pivot<Expr>) -> bool {
    match (pivot.value.known(), pivot.scale.known()) {
        (Some(value), Some(scale)) => value > NOISE * f64::EPSILON * scale,
        _ => false,
    }
}
