//! What MuJoCo 4.0 and older versions know. MuJoCo refuses everything else.

use super::super::robot::Note;
use super::super::spelling::{self, Known};
use super::super::xml::Element;

const ORIENTATION: &str = "quat axisangle euler xyaxes zaxis";

/// The elements in a body or in a frame.
const INNER: &str = "inertial joint freejoint geom site camera light plugin body frame include replicate attach \
                     composite flexcomp";

const KNOWN: &[Known] = &[
    Known {
        tag: "mujoco",
        attributes: &["model"],
        elements: "compiler option size visual statistic default extension custom asset worldbody deformable contact \
                   equality tendon actuator sensor keyframe include",
    },
    Known {
        tag: "compiler",
        attributes: &[
            "autolimits boundmass boundinertia settotalmass balanceinertia strippath coordinate angle fitaabb eulerseq",
            "meshdir texturedir assetdir discardvisual usethread fusestatic inertiafromgeom inertiagrouprange",
            "saveinertial savecompiled savecanonical passthrough alignfree conflict convexhull exactmeshinertia",
        ],
        elements: "lengthrange",
    },
    Known {
        tag: "option",
        attributes: &[
            "gravity density viscosity wind magnetic timestep integrator solver cone jacobian apirate impratio",
            "actuatorgroupdisable tolerance ls_tolerance noslip_tolerance ccd_tolerance sleep_tolerance mpr_tolerance",
            "iterations ls_iterations noslip_iterations ccd_iterations sdf_iterations mpr_iterations sdf_initpoints",
            "o_friction o_margin o_solimp o_solref collision",
        ],
        elements: "flag",
    },
    Known {
        tag: "flag",
        attributes: &[
            "gravity constraint damper spring passive frictionloss limit equality contact actuation autoreset clampctrl",
            "diagexact energy eulerdamp filterparent fwdinv invdiscrete ipc island midphase multiccd nativeccd override",
            "refsafe sensor sensornoise sleep speculative warmstart",
        ],
        elements: "",
    },
    Known {
        tag: "default",
        attributes: &["class"],
        elements: "mesh texture material joint geom site camera light pair equality tendon general motor position velocity \
                   intvelocity orientation pid damper cylinder muscle adhesion dcmotor default plugin",
    },
    Known { tag: "worldbody", attributes: &["name childclass"], elements: INNER },
    Known {
        tag: "body",
        attributes: &["name childclass pos mocap gravcomp sleep fuse simple user", ORIENTATION],
        elements: INNER,
    },
    Known { tag: "frame", attributes: &["name childclass pos", ORIENTATION], elements: INNER },
    Known {
        tag: "joint",
        attributes: &[
            "name class type group pos axis springdamper limited actuatorfrclimited actuatorfrcrange actuatorgravcomp",
            "solreflimit solimplimit solreffriction solimpfriction stiffness range margin ref springref springyield",
            "armature damping frictionloss user",
        ],
        elements: "",
    },
    Known { tag: "freejoint", attributes: &["name group align"], elements: "" },
    Known {
        tag: "inertial",
        attributes: &["pos mass diaginertia fullinertia", ORIENTATION],
        elements: "",
    },
    Known {
        tag: "site",
        attributes: &["name class type group pos size fromto material mesh rgba user", ORIENTATION],
        elements: "",
    },
];

/// Returns a warning for each misspelled attribute or element.
pub fn notes(root: Element) -> Vec<Note> {
    spelling::notes(root, KNOWN)
}
