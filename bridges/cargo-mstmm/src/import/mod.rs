//! Reads a robot file, URDF or MJCF, and writes it as the text of a chain.
//!
//! ```text
//! file --xml, robot--> links and joints --bodies--> tree of bodies --parts, naming--> text
//! ```
//!
//! The file is parsed by `roxmltree`: it keeps the places of elements for messages, and it reads files that have a mesh
//! without a name, which `urdf-rs` refuses.

mod bodies;
mod check;
mod comments;
mod error;
mod expressions;
mod frame;
mod mass;
mod mjcf;
mod names;
mod naming;
mod numbers;
mod parts;
mod places;
mod robot;
mod scope;
mod shapes;
mod spelling;
mod stiffness;
mod text;
mod urdf_words;
mod visual;
mod xacro;
mod xml;

use bodies::Tree;
pub use error::{ImportError, Place, Result};
pub(crate) use frame::angles_of;
pub(crate) use names::Names;
pub(crate) use numbers::number;
use robot::{Kind, Mimic, Robot};
use scope::Source;
pub(crate) use stiffness::Distance;
use text::Heading;

/// The tolerance of whole degrees in rad.
pub const SNAP: f64 = 1e-12;

/// How a file is read.
#[derive(Clone, Debug)]
pub struct Options {
    /// The name of the chain; that of the robot in camel case if absent.
    pub name: Option<String>,
    /// The link up to which joints move; all others are held at zero.
    pub tip: Option<String>,
    /// Angles that are this close to whole degrees, in rad, become these.
    pub snap: f64,
    /// Refuses what a chain cannot have, instead of a warning.
    pub strict: bool,
    /// The root link is a free body instead of the ground.
    pub floating: bool,
    /// The name of the file, for a comment.
    pub file: String,
}

impl Default for Options {
    fn default() -> Self {
        let file = "a URDF file".to_owned();
        Options { name: None, tip: None, snap: SNAP, strict: false, floating: false, file }
    }
}

/// The text of a chain.
#[derive(Clone, Debug)]
pub struct Imported {
    /// The text.
    pub text: String,
    /// What the text has otherwise than the file.
    pub warnings: Vec<String>,
}

/// Returns a robot file, URDF or MJCF, as the text of a chain.
///
/// # Errors
///
/// The place and the reason, if the file is malformed or a chain cannot have what it describes.
pub fn import(urdf: &str, options: &Options) -> Result<Imported> {
    if !(options.snap >= 0.0 && options.snap < 0.1) {
        return Err(ImportError::new("`--snap` must be between 0 and 0.1 rad"));
    }
    let robot = Robot::parse(urdf, options.snap)?;
    let tree = Tree::of(&robot, options.floating, options.tip.as_deref())?;
    if tree.bodies.is_empty() {
        let advice = if options.tip.is_some() { "" } else { ": import it with `--floating`" };
        return Err(ImportError::new(format!("no joint of the robot moves{advice}")));
    }
    let warnings = warnings(&robot, &tree, options.strict)?;
    let chain = chain_name(&robot, options)?;
    let source = Source { robot: &robot, tree: &tree, snap: options.snap };
    let heading = Heading { chain: &chain, file: &options.file, warnings: &warnings };
    let written = text::write(source, &heading);
    check::check(&robot, &written)?;
    Ok(Imported { text: written.text, warnings })
}

/// Returns what the text has otherwise than the file; with `strict` this is an error.
fn warnings(robot: &Robot, tree: &Tree, strict: bool) -> Result<Vec<String>> {
    let noted = robot.notes.iter().map(|note| (note.place, note.text.clone()));
    let mut warnings: Vec<(Place, String)> = noted.collect();
    for joint in tree.bodies.iter().filter_map(|body| body.joint) {
        let joint = &robot.joints[joint];
        let name = joint.name.escape_debug();
        if let Some(mimic) = &joint.mimic {
            let warning = match mimic {
                Mimic::Joint(other) => {
                    let other = other.escape_debug();
                    format!("joint `{name}` mimics `{other}` in the file, and is independent here")
                }
                Mimic::Constant => {
                    format!("joint `{name}` is held at a constant in the file, and moves here")
                }
            };
            warnings.push((joint.place, warning));
        }
        let omits = joint.damping > 0.0 || joint.friction > 0.0 || joint.armature > 0.0;
        if matches!(joint.kind, Kind::Planar | Kind::Floating | Kind::Ball) && omits {
            let warning = format!(
                "joint `{name}` has damping, friction or a rotor in the file, and none here"
            );
            warnings.push((joint.place, warning));
        }
    }
    for link in tree.rounded.iter().map(|link| &robot.links[*link]) {
        let name = link.name.escape_debug();
        let warning = format!(
            "link `{name}` has only rounding errors as its inertia tensor, which is zero here"
        );
        warnings.push((link.place, warning));
    }
    match warnings.first() {
        Some((place, warning)) if strict => Err(ImportError::at(*place, warning.clone())),
        _ => Ok(warnings.into_iter().map(|(_, warning)| warning).collect()),
    }
}

fn chain_name(robot: &Robot, options: &Options) -> Result<String> {
    let Some(name) = &options.name else {
        // In camel case twice: the name of the chain is the robot's name when it is exported.
        let camel = |name: &str| names::camel(&names::camel(name));
        return Ok(camel(&names::Names::default().unique(&camel(&robot.name), "Robot")));
    };
    let is_name = syn::parse_str::<proc_macro2::Ident>(name).is_ok() && name != "T" && name != "_";
    match is_name {
        true => Ok(name.clone()),
        false => Err(ImportError::new(format!("`{name}` of `--name` is not a name for a chain"))),
    }
}
