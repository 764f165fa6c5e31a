//! Inverse dynamics: the efforts that the drives of all free rates must supply for given
//! accelerations.
//!
//! All hinges of the chain and a floating base are prescribed; the solver in maximal coordinates
//! then computes the efforts of the drives. A closed chain is opened at its last hinge that is not
//! a weld.

use crate::chain::{Chain, Element, End, Frame, State};
use crate::drives::{Drives, FrameMotion, HingeMotion};
use crate::hinge::{Hinge, HingeKind};
use crate::passive::Passive;
use crate::route::Route;
use nalgebra::DVector;

impl Chain {
    /// Returns the efforts `τ` of the drives of all free rates at which these rates have the given
    /// derivatives `v̇`:
    ///
    /// ```text
    /// M(q) v̇ + bias = τ
    /// ```
    ///
    /// The efforts are in the order of [`State::v`], and `τᵀ v` is the power of the drives. Those of
    /// a floating base are a force on its input point in N (inertial axes), then a torque in N·m
    /// (body axes).
    ///
    /// `bias` contains everything that acts except the drives of free rates: gravity, Coriolis and
    /// centrifugal terms, springs, dampers, friction, limits, loads, moving ends and prescribed
    /// motions. It does not contain the efforts of motors, neither inputs nor constants: they are
    /// part of `τ`, so [`Drives::efforts`] are ignored. In an open chain `τ` therefore equals the
    /// efforts of the motors, with zeros for a floating base, if `v̇` are the accelerations of
    /// [`Chain::solve_driven`].
    ///
    /// A closed chain is the tree that remains without its closing hinge, the last hinge that is not a
    /// weld. The closing hinge transmits nothing; the efforts of its rates are those of its rotors,
    /// springs, dampers, friction and limits. Bodies that welds join to the finish stay there. With
    /// the reactions `λ` of the loop constraint `J v̇ = d` the equations are
    ///
    /// ```text
    /// M(q) v̇ + bias = τ + Jᵀ λ
    /// ```
    ///
    /// The state of a closed chain need not close.
    ///
    /// # Panics
    ///
    /// Panics when the elements do not alternate, and when the state, the drives or the
    /// accelerations have the wrong length.
    pub fn inverse_dynamics(
        &self,
        state: &State,
        drives: &Drives,
        accelerations: &[f64],
    ) -> Vec<f64> {
        self.check_lengths(state, drives);
        assert_eq!(accelerations.len(), self.dof_count(), "chain {}: accelerations", self.name);
        let mut opened = Opened::new(self, state, drives, accelerations);
        if self.closed() {
            opened.remove_closing_hinge();
        }
        opened.efforts()
    }

    /// Returns the `bias` of [`Chain::inverse_dynamics`]: the efforts of the drives at zero
    /// accelerations.
    ///
    /// # Panics
    ///
    /// Panics like [`Chain::inverse_dynamics`].
    pub fn bias_efforts(&self, state: &State, drives: &Drives) -> Vec<f64> {
        self.inverse_dynamics(state, drives, &vec![0.0; self.dof_count()])
    }

    /// Returns the mass matrix `M` of [`Chain::inverse_dynamics`] row by row, including the inertias
    /// of rotors.
    ///
    /// # Panics
    ///
    /// Panics like [`Chain::inverse_dynamics`].
    pub fn mass_matrix(&self, state: &State, drives: &Drives) -> Vec<Vec<f64>> {
        let bias = self.bias_efforts(state, drives);
        let mut rows = vec![vec![0.0; bias.len()]; bias.len()];
        for column in 0..bias.len() {
            let mut accelerations = vec![0.0; bias.len()];
            accelerations[column] = 1.0;
            let efforts = self.inverse_dynamics(state, drives, &accelerations);
            for (row, (effort, bias)) in rows.iter_mut().zip(efforts.iter().zip(&bias)) {
                row[column] = effort - bias;
            }
        }
        rows
    }
}

/// A chain whose hinges are all prescribed.
struct Opened {
    chain: Chain,
    drives: Drives,
    /// Whether the rates of each hinge are free in the original chain.
    free: Vec<bool>,
    /// The number of the hinge that has been removed, and its efforts, if its rates are free.
    removed: Option<(usize, Vec<f64>)>,
}

impl Opened {
    fn new(chain: &Chain, state: &State, drives: &Drives, accelerations: &[f64]) -> Opened {
        let mut own = Own { q: &state.q, v: &state.v, a: accelerations };
        let mut opened = Opened {
            chain: chain.clone(),
            drives: drives.clone(),
            free: Vec::new(),
            removed: None,
        };
        let mut motions = Vec::new();
        if chain.floats() {
            let base = Hinge::new("base", HingeKind::of_base(chain.dimension));
            motions.push(own.motion(&base));
            opened.free.push(true);
            opened.chain.start = End::Held(Frame::IDENTITY);
            opened.chain.elements.insert(0, Element::Hinge(base));
        }
        let mut given = drives.motions.iter().cloned();
        for hinge in chain.hinges() {
            let given = if hinge.prescribed { given.next() } else { None };
            motions.push(given.unwrap_or_else(|| own.motion(hinge)));
            opened.free.push(!hinge.prescribed);
        }
        opened.drives.motions = motions;
        opened.drives.efforts = Vec::new();
        for element in opened.chain.all_elements_mut() {
            if let Element::Hinge(hinge) = element {
                hinge.prescribed = true;
            }
        }
        opened
    }

    /// Removes the closing hinge: the last hinge of the closed route that is not a weld. The bodies
    /// that welds join to the finish become a route without a start.
    fn remove_closing_hinge(&mut self) {
        let moves = |element: &Element| matches!(element, Element::Hinge(hinge) if hinge.kind != HingeKind::Weld);
        let chain = &mut self.chain;
        let closed = chain.later_routes.iter().position(|route| route.finish != End::Free);
        let before = |count: usize, chain: &Chain| -> usize {
            let routes = chain.routes().take(count);
            routes.map(|(_, elements, _)| elements.iter().filter(is_hinge).count()).sum()
        };
        let number = before(closed.map_or(0, |route| route + 1), chain);
        let (elements, finish) = match closed {
            None => (&mut chain.elements, &mut chain.finish),
            Some(route) => {
                let route = &mut chain.later_routes[route];
                (&mut route.elements, &mut route.finish)
            }
        };
        let mut welded = elements.split_off(elements.iter().rposition(moves).unwrap_or(0));
        let number = number + elements.iter().filter(is_hinge).count();
        let finish = std::mem::replace(finish, End::Free);
        let closing = welded.remove(0);
        if !welded.is_empty() {
            let next = closed.map_or(0, |route| route + 1);
            let route = Route { start: End::Free, elements: welded, finish };
            chain.later_routes.insert(next, route);
            self.drives.route_starts.insert(next, FrameMotion::AT_REST);
        }
        let HingeMotion { q, v, a } = self.drives.motions.remove(number);
        if let (Element::Hinge(hinge), true) = (&closing, self.free.remove(number)) {
            let passive = Passive::new(hinge, &q, &v);
            let efforts = passive.inertia * DVector::from_column_slice(&a) + passive.inertia_bias
                - passive.efforts;
            self.removed = Some((number, efforts.as_slice().to_vec()));
        }
    }

    /// Returns the efforts of the drives of the rates that are free in the original chain.
    fn efforts(self) -> Vec<f64> {
        let none = State { q: Vec::new(), v: Vec::new() };
        let solution = self.chain.solve_driven(&none, &self.drives);
        let all = solution.efforts.into_iter().zip(self.free);
        let mut efforts: Vec<Vec<f64>> =
            all.map(|(efforts, free)| if free { efforts } else { Vec::new() }).collect();
        if let Some((number, removed)) = self.removed {
            efforts.insert(number, removed);
        }
        efforts.concat()
    }
}

fn is_hinge(element: &&Element) -> bool {
    matches!(element, Element::Hinge(_))
}

/// The entries of a state and of its accelerations that are not assigned to a hinge yet.
struct Own<'a> {
    q: &'a [f64],
    v: &'a [f64],
    a: &'a [f64],
}

impl Own<'_> {
    /// Returns the motion of the next hinge.
    fn motion(&mut self, hinge: &Hinge) -> HingeMotion {
        let take = |from: &mut &[f64], count: usize| {
            let (own, rest) = from.split_at(count);
            *from = rest;
            own.to_vec()
        };
        HingeMotion {
            q: take(&mut self.q, hinge.kind.coordinates()),
            v: take(&mut self.v, hinge.kind.dof_count()),
            a: take(&mut self.a, hinge.kind.dof_count()),
        }
    }
}
