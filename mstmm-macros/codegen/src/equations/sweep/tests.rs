//! Tests of the sweeps and of the boundaries that they cross.

use super::{Channel, LinkTree, LoopHook, PerLink};
use crate::model::{Layout, LinkId};
use std::cell::RefCell;

/// Records what crosses boundaries. `enter` adds 100, `leave` adds 1000.
#[derive(Debug, Default)]
struct Loops(RefCell<Vec<(&'static str, bool, f64)>>);

impl LoopHook<f64> for Loops {
    fn enter(&self, _: Channel, inwards: bool, first: &[f64]) -> Vec<f64> {
        self.0.borrow_mut().push(("enter", inwards, first[0]));
        vec![first[0] + 100.0]
    }
    fn leave(&self, _: Channel, any: &[f64]) -> Vec<f64> {
        self.0.borrow_mut().push(("leave", false, any[0]));
        vec![any[0] + 1000.0]
    }
}

/// A pin, a repeated part with a boundary link at either end, and a pin.
fn layout() -> Layout {
    let text = "chain Rope {
        body Rod {
            mass = 1 kg; com = [0, 0, 0] m; output = [1, 0, 0] m;
            inertia = diag(1, 1, 1) kg*m^2 about com;
        }
        ground -> pin a -> Rod b -> repeat 3 { pin c -> Rod d } -> pin e -> Rod f;
    }";
    let chains = crate::read(text.parse().expect("tokens")).expect("a good description");
    Layout::of(&chains[0].0)
}

#[test]
fn every_sweep_crosses_every_boundary_once() {
    let layout = layout();
    let boundaries: Vec<bool> = layout.links.iter().map(|link| link.boundary.is_some()).collect();
    assert_eq!(boundaries, [false, true, false, true, false]);
    let crossings = |sweep: &dyn Fn(LinkTree<f64>)| {
        let loops = Loops::default();
        sweep(LinkTree::new(&layout).with_loops(&loops));
        loops.0.into_inner()
    };
    let path: Vec<LinkId> = layout.links.ids().into_iter().collect();
    let with_nothing: Vec<(LinkId, ())> = path.iter().map(|&link| (link, ())).collect();
    // Each link counts one. A repetition begins after two links and ends after two more.
    let outwards = [("enter", false, 2.0), ("leave", false, 104.0)];
    assert_eq!(
        crossings(&|tree| {
            let (carried, _) = tree.outward(0.0, |_, parent| (parent + 1.0, ()));
            assert_eq!(carried.as_slice(), [1.0, 102.0, 103.0, 1104.0, 1105.0]);
        }),
        outwards
    );
    assert_eq!(
        crossings(&|tree| assert_eq!(tree.total(0.0, |_, sum| sum + 1.0), 1105.0)),
        outwards
    );
    assert_eq!(
        crossings(&|tree| {
            let (last, _) = tree.along(&path, 0.0, |_, sum| (sum + 1.0, ()));
            assert_eq!(last, 1105.0);
        }),
        outwards
    );
    // An inward sweep crosses a boundary before it adds the link.
    assert_eq!(
        crossings(&|tree| {
            let own = PerLink::filled(1.0, path.len());
            let (_, ground) = tree.inward(own, 0.0, |_, here, parent| *parent += here);
            assert_eq!(ground, 1105.0);
        }),
        [("enter", true, 2.0), ("leave", false, 104.0)]
    );
    assert_eq!(
        crossings(&|tree| {
            let (ground, _) = tree.back_along(&with_nothing, 0.0, |_, (), sum| (sum + 1.0, ()));
            assert_eq!(ground, 1105.0);
        }),
        [("enter", true, 1.0), ("leave", false, 103.0)]
    );
}

#[test]
fn boundaries_do_not_change_plain_numbers() {
    let layout = layout();
    let tree: LinkTree<f64> = LinkTree::new(&layout);
    assert_eq!(tree.total(0.0, |_, sum| sum + 1.0), 5.0);
    assert_eq!(tree.path_to(LinkId(2)), [LinkId(0), LinkId(1), LinkId(2)]);
}
