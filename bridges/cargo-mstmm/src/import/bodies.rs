//! The robot as a tree of bodies: links that fixed joints connect are one body.

use std::collections::HashSet;

use super::error::{ImportError, Result};
use super::frame::Frame;
use super::mass::Mass;
use super::robot::{Kind, Robot};
use super::visual::Visual;

/// A rigid body with its inboard joint.
pub struct Body {
    /// The index of the link that the joint moves; its frame is that of the body.
    pub link: usize,
    /// The index of the joint; none for a floating base.
    pub joint: Option<usize>,
    /// The index of the inboard body; none for the ground.
    pub inboard: Option<usize>,
    /// The joint's inboard frame, in the frame of the inboard body.
    pub frame: Frame,
    pub mass: Mass,
    /// The links that are fixed to the first one, with their frames.
    pub fixed: Vec<(usize, Frame)>,
    /// The shapes of all links, in the frame of the body.
    pub visuals: Vec<Visual>,
    /// The outboard bodies, in the order of the file.
    pub children: Vec<usize>,
}

/// All bodies, each after its inboard body, depth first.
pub struct Tree {
    pub bodies: Vec<Body>,
    /// The links that are the ground.
    pub ground: Vec<usize>,
    /// The joints that move in the file, and are held at zero.
    pub held: Vec<usize>,
    /// The links whose bodies have only rounding errors as their tensor, which is zero here.
    pub rounded: Vec<usize>,
}

impl Tree {
    /// Merges the links. With `floating`, the root link is a free body, otherwise it is the ground. With `tip`,
    /// only the joints between the root and this link move.
    pub fn of(robot: &Robot, floating: bool, tip: Option<&str>) -> Result<Tree> {
        let inboard = inboard_joints(robot)?;
        let root = root(robot, &inboard)?;
        let path = tip.map(|tip| path_to(robot, &inboard, tip)).transpose()?;
        let is_held = |joint: usize| path.as_ref().is_some_and(|path| !path.contains(&joint));
        let mut outboard = vec![Vec::new(); robot.links.len()];
        for (index, joint) in robot.joints.iter().enumerate() {
            outboard[joint.parent].push(index);
        }
        let mut tree =
            Tree { bodies: Vec::new(), ground: Vec::new(), held: Vec::new(), rounded: Vec::new() };
        let mut masses = Vec::new();
        // Depth first without recursion, since a file may have any depth. Each link has the body of its parent, and
        // its frame there, unless a joint moves it.
        let mut waiting = vec![(root, None, Frame::identity())];
        let mut visited = 0;
        while let Some((link, parent, frame)) = waiting.pop() {
            visited += 1;
            let joint = inboard[link];
            let moves = joint.map_or(floating, |joint| robot.joints[joint].kind != Kind::Fixed);
            let held = moves && joint.is_some_and(is_held);
            tree.held.extend(joint.filter(|_| held));
            let (body, frame) = if moves && !held {
                masses.push(Vec::new());
                (Some(tree.begin(link, joint, parent, frame)), Frame::identity())
            } else {
                (parent, frame)
            };
            match body {
                None => tree.ground.push(link),
                Some(body) => {
                    masses[body].push(robot.links[link].mass.seen_from(&frame));
                    tree.bodies[body].hold(robot, link, &frame);
                }
            }
            for &index in outboard[link].iter().rev() {
                let joint = &robot.joints[index];
                waiting.push((joint.child, body, frame.compose(&joint.origin)));
            }
        }
        if visited < robot.links.len() {
            return Err(cycle(robot, &inboard, root));
        }
        for (body, masses) in tree.bodies.iter_mut().zip(&masses) {
            body.mass = Mass::sum(masses);
            check_mass(robot, body)?;
            if body.mass.drop_rounding_errors() {
                tree.rounded.push(body.link);
            }
        }
        Ok(tree)
    }

    /// Adds a body and returns its index.
    fn begin(
        &mut self,
        link: usize,
        joint: Option<usize>,
        inboard: Option<usize>,
        frame: Frame,
    ) -> usize {
        let index = self.bodies.len();
        if let Some(inboard) = inboard {
            self.bodies[inboard].children.push(index);
        }
        self.bodies.push(Body {
            link,
            joint,
            inboard,
            frame,
            mass: Mass::none(),
            fixed: Vec::new(),
            visuals: Vec::new(),
            children: Vec::new(),
        });
        index
    }

    /// Returns the bodies that joints connect to the ground.
    pub fn on_ground(&self) -> Vec<usize> {
        let bodies = self.bodies.iter().enumerate();
        let on_ground = bodies.filter(|(_, body)| body.inboard.is_none() && body.joint.is_some());
        on_ground.map(|(index, _)| index).collect()
    }

    /// Returns a body and all bodies outboard of it, in their order.
    pub fn branch(&self, body: usize) -> Vec<usize> {
        let mut branch = Vec::new();
        let mut waiting = vec![body];
        while let Some(body) = waiting.pop() {
            branch.push(body);
            waiting.extend(self.bodies[body].children.iter().rev());
        }
        branch
    }
}

impl Body {
    fn hold(&mut self, robot: &Robot, link: usize, frame: &Frame) {
        if link != self.link {
            self.fixed.push((link, frame.clone()));
        }
        let shapes = robot.links[link].visuals.iter();
        self.visuals.extend(shapes.map(|visual| Visual {
            frame: frame.compose(&visual.frame),
            shape: visual.shape.clone(),
        }));
    }
}

/// Returns the inboard joint of each link.
fn inboard_joints(robot: &Robot) -> Result<Vec<Option<usize>>> {
    let mut inboard: Vec<Option<usize>> = vec![None; robot.links.len()];
    for (index, joint) in robot.joints.iter().enumerate() {
        if let Some(other) = inboard[joint.child].replace(index) {
            let link = &robot.links[joint.child].name;
            let message = format!(
                "link `{link}` is the child of the joints `{}` and `{}`: closed loops are not supported",
                robot.joints[other].name, joint.name
            );
            return Err(ImportError::at(joint.place, message));
        }
    }
    Ok(inboard)
}

/// Returns the only link that is the child of no joint.
fn root(robot: &Robot, inboard: &[Option<usize>]) -> Result<usize> {
    let roots: Vec<usize> = (0..inboard.len()).filter(|link| inboard[*link].is_none()).collect();
    match roots[..] {
        [root] => Ok(root),
        [first, second, ..] => {
            let [first, second] = [first, second].map(|link| &robot.links[link]);
            let message = format!(
                "link `{}` is a second root: neither it nor `{}` is the child of a joint",
                second.name, first.name
            );
            Err(ImportError::at(second.place, message))
        }
        [] => Err(match robot.joints.first() {
            None => ImportError::new("the file has no links"),
            Some(joint) => {
                let message = format!(
                    "joint `{}`: every link is the child of a joint, so the joints are a cycle",
                    joint.name
                );
                ImportError::at(joint.place, message)
            }
        }),
    }
}

/// Makes the error about links that are not connected to the root.
fn cycle(robot: &Robot, inboard: &[Option<usize>], root: usize) -> ImportError {
    // Inboard of a link that the root does not reach there is always another joint.
    let is_reached = |link: usize| {
        let mut at = link;
        for _ in 0..robot.links.len() {
            match inboard[at] {
                Some(joint) => at = robot.joints[joint].parent,
                None => return at == root,
            }
        }
        false
    };
    let lost = robot.joints.iter().find(|joint| !is_reached(joint.child));
    match lost {
        Some(joint) => {
            let message = format!("joint `{}` is part of a cycle, or outboard of one", joint.name);
            ImportError::at(joint.place, message)
        }
        None => ImportError::new("the joints are a cycle"),
    }
}

/// Returns the joints between the root and a link.
fn path_to(robot: &Robot, inboard: &[Option<usize>], tip: &str) -> Result<HashSet<usize>> {
    let missing = || ImportError::new(format!("the link `{tip}` of `--tip` does not exist"));
    let mut link = robot.links.iter().position(|link| link.name == tip).ok_or_else(missing)?;
    let mut path = HashSet::new();
    while let Some(joint) = inboard[link].filter(|joint| path.insert(*joint)) {
        link = robot.joints[joint].parent;
    }
    Ok(path)
}

fn check_mass(robot: &Robot, body: &Body) -> Result<()> {
    if body.mass.mass > 0.0 {
        return Ok(());
    }
    let link = &robot.links[body.link];
    let message = match body.joint.map(|joint| &robot.joints[joint]) {
        Some(joint) => {
            let message =
                format!("joint `{}` moves the link `{}`, which has no mass", joint.name, link.name);
            return Err(ImportError::at(joint.place, message));
        }
        None => format!("the root link `{}` floats and has no mass", link.name),
    };
    Err(ImportError::at(link.place, message))
}
