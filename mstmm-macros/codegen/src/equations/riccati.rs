//! Riccati transfer: from the free end to the ground, the relation `F = A a + e` at every point.
//!
//! For every hinge, with `a = a' + S β` and the condition `Sᵀ F = τ`, one free direction `s` after
//! the other is eliminated:
//!
//! (1)  `y = A s`, `d = sᵀ y`, `z = y / d`, `w = τ − sᵀ e`
//! (2)  `A ← A − z yᵀ`, `e ← e + z w`
//! (3)  `β = w / d − zᵀ a'`, on the way back
//!
//! What is left has `A s = 0` and `sᵀ e = τ`. Where `s` is an axis both are set exactly, and `A`
//! keeps one of each pair of entries only: without that, chains of balls lose all digits.

use super::hinge::Column;
use super::{LinkMotion, Pivot, Trace};
use crate::math::{Motion, Scalar, SpatialInertia, Wrench};

/// A free direction that has been eliminated.
struct Eliminated<S> {
    column: Column<S>,
    /// `z`
    gain: Wrench<S>,
    /// `w / d`
    rest: S,
}

/// Amounts of every link's free columns, and the pivots `d`.
pub fn solve<S: Scalar>(
    links: &[LinkMotion<S>],
    efforts: &[Vec<S>],
    ground: Motion<S>,
    trace: &mut Trace<S>,
) -> (Vec<Vec<S>>, Vec<Pivot<S>>) {
    let (eliminated, pivots) = reduce(links, efforts, trace);
    (recover(links, &eliminated, ground, trace), pivots)
}

/// The pivots alone, for methods that have none of their own for each hinge.
pub fn pivots<S: Scalar>(links: &[LinkMotion<S>], trace: &mut Trace<S>) -> Vec<Pivot<S>> {
    let no_efforts: Vec<Vec<S>> =
        links.iter().map(|link| vec![S::zero(); link.freedom.columns.len()]).collect();
    let (_, pivots) = reduce(links, &no_efforts, &mut Trace::new());
    trace.section(
        "Inertia beyond the hinges, to be divided by",
        "the pivots of the Riccati transfer",
    );
    for pivot in &pivots {
        trace.number(format!("{}_d", links[pivot.link].name), pivot.value);
    }
    pivots
}

/// From the free end to the ground: what each link has eliminated, and the pivots.
fn reduce<S: Scalar>(
    links: &[LinkMotion<S>],
    efforts: &[Vec<S>],
    trace: &mut Trace<S>,
) -> (Vec<Vec<Eliminated<S>>>, Vec<Pivot<S>>) {
    let mut eliminated: Vec<Vec<Eliminated<S>>> = links.iter().map(|_| Vec::new()).collect();
    let mut pivots = Vec::new();
    let mut own: Vec<(SpatialInertia<S>, Wrench<S>)> =
        links.iter().map(|link| (link.rigid(), link.velocity_load())).collect();
    // Sizes of what a pivot is the sum of: a pivot that should vanish is what rounding leaves of them.
    let mut scales: Vec<(S, S)> =
        links.iter().map(|link| (link.mass, link.inertia.trace())).collect();
    for index in (0..links.len()).rev() {
        let link = &links[index];
        trace.section(
            format!("Riccati transfer over `{}`", link.name),
            "F = A a + e of [P, Eqs. (18), (19)] with the conditions [P, Eqs. (25), (35)]",
        );
        let (mut inertia, mut load) = own[index];
        trace.inertia(&link.name, inertia);
        trace.wrench(&format!("{}_e", link.name), load);
        for (number, (&column, &effort)) in
            link.freedom.columns.iter().zip(&efforts[index]).enumerate()
        {
            let pivot = eliminate(&mut inertia, &mut load, column, effort, &mut eliminated[index]);
            trace.number(format!("{}_d{number}", link.name), pivot);
            trace.wrench(&format!("{}_z{number}", link.name), eliminated[index][number].gain);
            let (linear, angular) = scales[index];
            let scale = if column.is_linear() { linear } else { angular };
            pivots.push(Pivot { link: index, value: pivot, scale });
        }
        if let Some(parent) = link.parent {
            let carried = inertia.linear.trace();
            scales[parent].0 = scales[parent].0 + carried;
            scales[parent].1 = scales[parent].1 + carried * link.arm.dot(link.arm);
            let load = load + inertia.times(link.drift);
            let (inertia, load) =
                (link.to_parent.of_inertia(&inertia), load.turned(&link.to_parent));
            own[parent].0 = own[parent].0 + inertia.moved_from(link.arm);
            own[parent].1 = own[parent].1 + load.moved_from(link.arm);
        }
    }
    (eliminated, pivots)
}

/// Equations (1) and (2) for one free direction; returns `d`.
fn eliminate<S: Scalar>(
    inertia: &mut SpatialInertia<S>,
    load: &mut Wrench<S>,
    column: Column<S>,
    effort: S,
    eliminated: &mut Vec<Eliminated<S>>,
) -> S {
    let direction = column.motion();
    let (old, y) = (*inertia, inertia.times(direction));
    let pivot = direction.power(y);
    let inverse = pivot.recip();
    let rest = (effort - direction.power(*load)) * inverse;
    let along = |k: usize| matches!(column, Column::Axis(axis) if axis == k);
    let gain = Wrench::from_fn(|k| if along(k) { S::one() } else { y.at(k) * inverse });
    *inertia = SpatialInertia::from_fn(|i, j| {
        if along(i) || along(j) { S::zero() } else { old.at(i, j) - gain.at(i) * y.at(j) }
    });
    let before = *load;
    *load = Wrench::from_fn(|k| if along(k) { effort } else { before.at(k) + y.at(k) * rest });
    eliminated.push(Eliminated { column, gain, rest });
    pivot
}

/// Equation (3), from the ground outwards.
fn recover<S: Scalar>(
    links: &[LinkMotion<S>],
    eliminated: &[Vec<Eliminated<S>>],
    ground: Motion<S>,
    trace: &mut Trace<S>,
) -> Vec<Vec<S>> {
    let mut accelerations: Vec<Motion<S>> = Vec::new();
    let mut amounts = Vec::new();
    for (link, eliminated) in links.iter().zip(eliminated) {
        trace.section(format!("Acceleration of `{}`", link.name), "[P, Eqs. (13), (36), (44)]");
        let mut acceleration = link.carried(link.parent.map_or(ground, |p| accelerations[p]));
        let mut betas: Vec<S> = Vec::new();
        for step in eliminated.iter().rev() {
            betas.insert(0, advance(&mut acceleration, step));
        }
        trace.motion(&format!("{}_a", link.name), acceleration);
        accelerations.push(acceleration);
        amounts.push(betas);
    }
    amounts
}

/// Adds one free direction's part to `acceleration` and returns its amount `β`.
fn advance<S: Scalar>(acceleration: &mut Motion<S>, step: &Eliminated<S>) -> S {
    let before = *acceleration;
    match step.column {
        // The new component follows without the old one, which then matters to `β` alone.
        Column::Axis(axis) => {
            let others = Motion::from_fn(|k| if k == axis { S::zero() } else { before.at(k) });
            let new = step.rest - others.power(step.gain);
            *acceleration = Motion::from_fn(|k| if k == axis { new } else { before.at(k) });
            new - before.at(axis)
        }
        Column::General(direction) => {
            let beta = step.rest - before.power(step.gain);
            *acceleration = before + direction.scaled(beta);
            beta
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Column, SpatialInertia, Wrench, eliminate};
    use crate::math::{Mat3, Sym3, Vec3};

    /// Without exact zeros, rounding leaks back into the angular block of every ball and grows from
    /// one to the next until no digit is left.
    #[test]
    fn what_a_ball_lets_go_is_exactly_zero() {
        let mut inertia = SpatialInertia {
            linear: Sym3([3.1, 2.7, 4.3, 0.3, -0.2, 0.7]),
            coupling: Mat3([[0.1, 0.7, -0.3], [0.2, -0.6, 0.9], [0.4, 0.3, 0.8]]),
            angular: Sym3([2.3, 3.7, 2.9, 0.11, -0.23, 0.37]),
        };
        let mut load = Wrench { force: Vec3([0.3, -0.7, 1.1]), moment: Vec3([1.3, 0.9, -0.1]) };
        let efforts = [0.25, -0.5, 0.125];
        let mut eliminated = Vec::new();
        for (k, effort) in efforts.into_iter().enumerate() {
            let pivot =
                eliminate(&mut inertia, &mut load, Column::Axis(3 + k), effort, &mut eliminated);
            assert!(pivot > 0.0);
        }
        assert_eq!(inertia.angular, Sym3([0.0; 6]));
        assert_eq!(inertia.coupling, Mat3([[0.0; 3]; 3]));
        assert_eq!(load.moment, Vec3(efforts));
    }
}
