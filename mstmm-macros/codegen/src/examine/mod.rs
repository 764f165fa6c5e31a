//! Numerical checks of a chain: whether every hinge moves a body with inertia, how many degrees of
//! freedom a closed chain has, and the pose at the start.

mod base_parameters;
mod drawing;
mod dry_run;
mod start_warnings;

use crate::diag::Diagnostics;
use crate::equations::{HingePivot, LoopReaction, SymbolValues};
use crate::math::PIVOT_ULPS;
use crate::model::{Chain, ClosureRank, Drive, Hinge, HingeId, Layout, Request, Role};
pub use drawing::{Drawing, DrawnEnd, DrawnMark, DrawnSpring};
use dry_run::{Configuration, DryRun, Number, values};
use proc_macro2::Ident;

/// The number of states tried. A hinge with a zero pivot in all of them has a zero pivot in every
/// state.
const STATES: usize = 4;

/// Chains with more elements are checked and drawn with shortened repeated parts.
const ELEMENTS: usize = 100;
const CUT_SHORT: usize = 3;

/// The smallest relative pivot of an independent constraint. In a pose that is closed within
/// `dry_run::CLOSED`, a redundant constraint leaves the square of that, and rounding errors: far less. A
/// linkage whose smallest singular value is a thousandth of its largest leaves a millionth.
const INDEPENDENT: f64 = 1e-10;

/// The findings. The default is for a chain without any.
#[derive(Clone, Debug, Default)]
pub struct Findings {
    /// Whether some bodies of a closed chain have inertia in all directions only because of the
    /// loop constraints.
    pub held_by_closure: bool,
    /// The number of independent loop constraints.
    pub closure_rank: ClosureRank,
    /// The mobility of a chain that is held at both ends, if a closed pose was found.
    pub mobility: Option<Mobility>,
    /// The largest mass divided by the smallest mass or 1 kg, whichever is less, with parameters at their defaults; `None`
    /// if masses are Rust constants.
    pub mass_ratio: Option<f64>,
    /// The indices of the dynamic parameters that motions can identify, if the chain has a regressor and its numbers are
    /// known.
    pub base_parameters: Vec<usize>,
    /// The chain at its start, closed if it is a closed chain; `None` if it contains Rust
    /// constants.
    pub start: Option<Drawing>,
}

/// The mobility of a closed chain in a general pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mobility {
    /// Remaining degrees of freedom.
    pub dofs: usize,
    /// Constraints of the loop hinge.
    pub constraints: usize,
    /// Constraints that depend on others.
    pub redundant: usize,
}

/// The hinges with a zero pivot.
#[derive(Default)]
struct SingularHinges {
    /// Those at the start, or in the first state that fits Rust constants.
    at_start: Vec<HingeId>,
    /// Those in all states: what they move has no inertia.
    always: Vec<HingeId>,
    /// Whether the accelerations are not finite at the start, though all pivots are present.
    overflows_at_start: bool,
}

const OVERFLOW: &str = "the accelerations at the start are not finite: a mass, a length or a stiffness is too large or too small";

/// Returns the name of the hinge that closes a chain.
fn closing_hinge<'a>(chain: &'a Chain, merged: &Layout) -> Option<&'a str> {
    merged.loop_hinges.first().map(|&hinge| chain.hinges[hinge].path.as_str())
}

/// Checks a chain numerically, and reports its errors.
pub fn examine(chain: &Chain, diagnostics: &mut Diagnostics) -> Findings {
    let whole = chain.count_elements(usize::MAX) <= ELEMENTS;
    let most = if whole { usize::MAX } else { CUT_SHORT };
    let mut dry_run = DryRun::new(chain.unrolled(most));
    let mut singular = dry_run.singular_hinges();
    if !dry_run.merged.loop_hinges.is_empty() && !singular.always.is_empty() {
        // The loop constraints may hold bodies that have no inertia in some direction.
        dry_run.held_by_closure = true;
        singular = dry_run.singular_hinges();
    }
    let moves_all = singular.always.is_empty();
    dry_run.refuse_massless_hinges(&singular.always, diagnostics);
    let held_by_closure = dry_run.held_by_closure;
    // A final weld next to a repeated part is merged if the chain is written out: another hinge closes it then.
    let closes_alike = closing_hinge(&dry_run.chain, &dry_run.merged)
        == closing_hinge(chain, &Layout::merged(chain));
    let mut closure_rank =
        if closes_alike { dry_run.closure_rank_at_run_time() } else { ClosureRank::Unknown };
    if chain.constants > 0 {
        return Findings { held_by_closure, closure_rank, ..Findings::default() };
    }
    if moves_all {
        dry_run.warn_of_singular_accelerations(&singular.at_start, diagnostics);
    }
    if singular.overflows_at_start && dry_run.merged.loop_hinges.is_empty() {
        diagnostics.error(chain.name.span(), OVERFLOW);
    }
    let closed = dry_run.closed_poses();
    let closes_from_start = !matches!(closed[..], [None, ..]);
    let poses: Vec<Configuration> = closed.into_iter().flatten().collect();
    let mobility = if whole { dry_run.mobility(&poses) } else { None };
    // A single pose has prescribed motions at zero, which may be a singular position.
    let is_enough = poses.len() > 1 || !chain.hinges.iter().any(Hinge::is_prescribed);
    if let (Some((rank, directions)), true) = (
        dry_run.closure_rank(&poses),
        whole && is_enough && closes_alike && chain.geometry_is_known(),
    ) {
        closure_rank = ClosureRank::Known { rank, directions };
    }
    if let Some(Mobility { dofs: 0, .. }) = mobility {
        dry_run.refuse_rigid_chain(diagnostics);
    } else if whole && moves_all && !closes_from_start {
        dry_run.warn_of_open_loop(!poses.is_empty(), diagnostics);
    } else if whole && moves_all {
        dry_run.warn_of_singular_closure(&poses, diagnostics);
    }
    // A place has one warning: that of its limits is the least serious.
    dry_run.warn_of_limits(diagnostics);
    let mass_ratio = Some(dry_run.mass_ratio());
    let start = Some(dry_run.drawing(poses, &chain.unrolled_springs(most)));
    let has_regressor = chain.requests.contains(&Request::Regressor) && chain.repeats.is_empty();
    let base_parameters = if has_regressor { dry_run.base_parameters() } else { Vec::new() };
    Findings { held_by_closure, closure_rank, mobility, mass_ratio, base_parameters, start }
}

impl DryRun {
    /// Returns the hinges with zero pivots.
    fn singular_hinges(&self) -> SingularHinges {
        let mut found: Option<SingularHinges> = None;
        for seed in 0..STATES {
            let values = values(&self.chain, seed);
            if !self.fits(&values) {
                continue;
            }
            let (now, is_finite) = self.singular_in(&values, &self.pose(&values, seed));
            let found = match &mut found {
                None => found.insert(SingularHinges {
                    at_start: now.clone(),
                    overflows_at_start: now.is_empty() && !is_finite,
                    always: now,
                }),
                Some(found) => {
                    found.always.retain(|hinge| now.contains(hinge));
                    found
                }
            };
            if found.always.is_empty() {
                break;
            }
        }
        found.unwrap_or_default()
    }

    /// Returns the hinges with a zero pivot in this pose, and whether the accelerations are finite.
    fn singular_in(
        &self,
        values: &SymbolValues<Number>,
        pose: &Configuration,
    ) -> (Vec<HingeId>, bool) {
        let solved = self.solved(values, pose);
        let numbers = |pivot: &HingePivot<Number>| (pivot.value.value(), pivot.scale.value());
        let is_known = |pivot: &&HingePivot<Number>| {
            let (value, scale) = numbers(pivot);
            value.is_finite() && scale.is_finite()
        };
        let vanishing = solved.pivots.iter().filter(is_known).filter(|pivot| {
            let (value, scale) = numbers(pivot);
            value.abs() <= PIVOT_ULPS * f64::EPSILON * scale
        });
        let hinges = vanishing.map(|pivot| self.merged.links[pivot.link].hinge).collect();
        let mut accelerations = solved.accelerations.iter();
        let is_finite = solved.pivots.iter().all(|pivot| is_known(&pivot))
            && accelerations.all(|acceleration| acceleration.value().is_finite());
        (hinges, is_finite)
    }

    /// Returns the largest mass divided by the smallest mass or 1 kg, whichever is less.
    fn mass_ratio(&self) -> f64 {
        let bodies = self.chain.bodies.iter().filter(|body| body.role == Role::Physical);
        let masses = bodies.map(|body| self.values.scalar(&body.mass).value());
        let (least, most) = masses
            .fold((1.0_f64, 0.0_f64), |(least, most), mass| (least.min(mass), most.max(mass)));
        most / least
    }

    /// Whether values of Rust constants fulfil the chain's assertions.
    fn fits(&self, values: &SymbolValues<Number>) -> bool {
        let mut conditions = self.chain.assertions.iter().flatten();
        conditions.all(|condition| condition.must.holds(values.scalar(&condition.value).value()))
    }

    /// Reports hinges that move no inertia.
    fn refuse_massless_hinges(&self, massless: &[HingeId], diagnostics: &mut Diagnostics) {
        let mut reported: Vec<&Ident> = Vec::new();
        for hinge in massless.iter().map(|&hinge| &self.chain.hinges[hinge]) {
            if !reported.contains(&&hinge.name) {
                reported.push(&hinge.name);
                diagnostics.error(hinge.name.span(), self.massless_message(hinge));
            }
        }
    }

    /// Returns the message for a hinge that moves no inertia.
    fn massless_message(&self, hinge: &Hinge) -> String {
        let name = &hinge.path;
        let floats = self.chain.bodies.iter().any(|body| body.path == *name);
        if floats {
            return format!(
                "the bodies that float with `{name}` have no inertia about one of their axes: \
                 give one of them a moment of inertia about it"
            );
        }
        let axes = match hinge.kind.dof_count() {
            1 => "its axis",
            _ => "one of its axes",
        };
        format!(
            "the bodies that hinge `{name}` moves have no inertia about {axes}: give one of \
             them a moment of inertia about it, or the hinge an `armature`"
        )
    }

    /// Reports a closed chain that cannot move, unless a motion is prescribed.
    fn refuse_rigid_chain(&self, diagnostics: &mut Diagnostics) {
        let closing = self.merged.loop_hinges.first().map(|&hinge| &self.chain.hinges[hinge]);
        let driven = self.chain.hinges.iter().any(|hinge| hinge.drive == Drive::Prescribed);
        let Some(closing) = closing.filter(|_| !driven) else { return };
        let dof_count = self.merged.dof_count();
        let message = format!(
            "this closed chain cannot move: its loop constraints remove all degrees of freedom \
             of its hinges ({dof_count}); add a hinge or an axis, or leave one end free"
        );
        diagnostics.error(closing.name.span(), message);
    }

    /// Returns closed poses, from the start and from poses near it, since the start may be a singular pose: `None` where
    /// there is no closed pose nearby. Empty for a chain that is not closed.
    fn closed_poses(&self) -> Vec<Option<Configuration>> {
        let seeds = if self.merged.loop_hinges.is_empty() { 0..0 } else { 0..STATES };
        seeds.map(|seed| self.closed(self.pose(&self.values, seed))).collect()
    }

    /// Returns the mobility in these poses.
    fn mobility(&self, poses: &[Configuration]) -> Option<Mobility> {
        let loop_hinge = *self.merged.loop_hinges.first()?;
        let redundant = self.closure_rank(poses).map(|(rank, directions)| directions - rank)?;
        let rates = self.merged.v[loop_hinge].len();
        let constraints = self.chain.dimension.axes().len() - rates;
        let open = self.merged.dof_count() - rates;
        Some(Mobility {
            dofs: (open + redundant).checked_sub(constraints)?,
            constraints,
            redundant,
        })
    }

    /// Returns whether the rank of the loop constraints must be found when parameters are set. With
    /// prescribed motions this is not done, since their zero positions may be singular.
    fn closure_rank_at_run_time(&self) -> ClosureRank {
        let chain = &self.chain;
        let is_prescribed = chain.hinges.iter().any(Hinge::is_prescribed);
        let is_known = chain.geometry_is_known() && chain.constants == 0;
        if self.merged.loop_hinges.is_empty() || is_prescribed || is_known {
            return ClosureRank::Unknown;
        }
        match self.solved(&self.values, &self.pose(&self.values, 0)).reaction {
            Some(reaction) => ClosureRank::FoundAtRunTime(reaction.undetermined.len()),
            None => ClosureRank::Unknown,
        }
    }

    /// Returns the largest rank of the loop constraints in these poses, and the number of
    /// constraints, including those that rotors add.
    pub(super) fn closure_rank(&self, poses: &[Configuration]) -> Option<(usize, usize)> {
        let ranks = poses.iter().filter_map(|pose| {
            let LoopReaction { pivots, undetermined, .. } =
                self.solved(&self.values, pose).reaction?;
            let rank = pivots.iter().filter(|pivot| pivot.value() > INDEPENDENT).count();
            Some((rank, undetermined.len()))
        });
        ranks.max()
    }
}
