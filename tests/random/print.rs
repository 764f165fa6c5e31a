//! Prints a chain of the reference with its interface.

use mstmm_reference::{Chain, Dimension, Drives, End, Gravity, Hinge, HingeKind, Source};

const INDENT: &str = "    ";

/// The call that makes a chain by both methods and gives each its face; of a tree, by the default
/// method.
pub fn printed(chain: &Chain) -> String {
    printed_as(chain, &chain.to_macro_text(None))
}

/// The same with another text of the chain.
pub fn printed_as(chain: &Chain, description: &str) -> String {
    let name = &chain.name;
    let description = description.replacen(&format!(" {name} {{"), " {", 1);
    let point = match chain.dimension {
        Dimension::Space => "Point",
        Dimension::Plane => "PlanePoint",
        Dimension::Line => "LinePoint",
    };
    let moving = |end: &End| matches!(end, End::Moving { .. });
    let starts = chain.later_routes.iter().map(|route| &route.start);
    let has_prescribed_motion = starts.chain([&chain.start, &chain.finish]).any(moving)
        || prescribed(chain).next().is_some();
    let energy = if has_prescribed_motion { "energy_with(state, inputs)" } else { "energy(state)" };
    let fields = inputs(chain);
    let drives = if fields.is_empty() { "_drives" } else { "drives" };
    let fields: String = fields.iter().map(|field| format!("        {field},\n")).collect();
    let fields = if fields.is_empty() { "{}".to_owned() } else { format!("{{\n{fields}    }}") };
    let hinges: String = chain.hinges().map(|hinge| format!(" {}", hinge.name)).collect();
    let springs: String = chain.springs.iter().map(|spring| format!(" {}", spring.name)).collect();
    let names = match chain.later_routes[..] {
        [] => format!("{name}R {name}T"),
        _ => name.clone(),
    };
    format!(
        "\nprinted! {{\n    {names}, {point}, {energy};\n\
         {INDENT}inputs |{drives}| {fields}\n{INDENT}hinges{hinges};\n{INDENT}springs{springs};\n\
         {description}}}\n"
    )
}

fn prescribed(chain: &Chain) -> impl Iterator<Item = &Hinge> {
    chain.hinges().filter(|hinge| hinge.prescribed)
}

/// The fields of the inputs, each with its value out of `drives`.
fn inputs(chain: &Chain) -> Vec<String> {
    let mut fields = Vec::new();
    let frame = match chain.dimension {
        Dimension::Space => "space_frame",
        Dimension::Plane => "plane_frame",
        Dimension::Line => "line_frame",
    };
    for (end, which) in [(&chain.start, "start"), (&chain.finish, "finish")] {
        if let End::Moving { name } = end {
            fields.push(format!("{name}: {frame}(&drives.{which})"));
        }
    }
    for (place, route) in chain.later_routes.iter().enumerate() {
        if let End::Moving { name } = &route.start {
            fields.push(format!("{name}: {frame}(&drives.route_starts[{place}])"));
        }
    }
    for (place, hinge) in prescribed(chain).enumerate() {
        let word = motion_of(&hinge.kind);
        fields.push(format!("{}: {word}(&drives.motions[{place}])", hinge.name));
    }
    fields.extend(motors(chain));
    for (place, load) in chain.loads.iter().enumerate() {
        let name = &load.name;
        if load.force == Source::Input {
            let force = shifts(chain.dimension, &format!("drives.loads[{place}].force"));
            fields.push(format!("{name}_force: {force}"));
        }
        if load.torque == Source::Input {
            let torque = match chain.dimension {
                Dimension::Space => format!("drives.loads[{place}].torque.into()"),
                _ => format!("drives.loads[{place}].torque[2]"),
            };
            fields.push(format!("{name}_torque: {torque}"));
        }
    }
    for (place, spring) in chain.springs.iter().enumerate() {
        if spring.force == Source::Input {
            fields.push(format!("{}_force: drives.springs[{place}]", spring.name));
        }
    }
    if chain.gravity == Gravity::Input {
        fields.push(format!("gravity: {}", shifts(chain.dimension, "drives.gravity")));
    }
    fields
}

/// The inputs of motors, out of the efforts of all rates.
fn motors(chain: &Chain) -> Vec<String> {
    let mut fields = Vec::new();
    let mut first = Drives::none(chain).efforts.len();
    first -= chain.hinges().map(Hinge::dof_count).sum::<usize>();
    for hinge in chain.hinges() {
        let given = hinge.groups().into_iter().filter(|(group, _)| group.motor == Source::Input);
        let places: Vec<usize> =
            given.flat_map(|(_, rates)| rates).map(|rate| first + rate).collect();
        match places[..] {
            [] => {}
            [one] => fields.push(format!("{}: drives.efforts[{one}]", hinge.name)),
            _ => fields.push(format!("{}: vector(&drives.efforts, {places:?})", hinge.name)),
        }
        first += hinge.dof_count();
    }
    fields
}

/// The name of the function for the motion of a kind of hinge.
fn motion_of(kind: &HingeKind) -> &'static str {
    match kind {
        HingeKind::Weld => unreachable!("a weld has no motion"),
        HingeKind::Pin { .. } => "pin",
        HingeKind::Slider { .. } | HingeKind::LineFloating | HingeKind::LineElastic => "slider",
        HingeKind::Screw { .. } => "screw",
        HingeKind::Cylindrical { .. } => "cylindrical",
        HingeKind::Universal { .. } => "universal",
        HingeKind::Gimbal { .. } => "gimbal",
        HingeKind::Ball => "ball",
        HingeKind::Planar { .. } | HingeKind::PlaneFloating => "planar",
        HingeKind::PlaneElastic => "plane_elastic",
        HingeKind::Floating => "floating",
        HingeKind::Elastic => "elastic",
    }
}

/// As many components of a vector as a dimension has.
fn shifts(dimension: Dimension, vector: &str) -> String {
    match dimension {
        Dimension::Space => format!("{vector}.into()"),
        Dimension::Plane => format!("part(&{vector}, 0).into()"),
        Dimension::Line => format!("{vector}[0]"),
    }
}
