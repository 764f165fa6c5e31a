//! `Display`: tables with names, aligned values and units.

use mstmm_formats::{Arm, ArmState, Poses, Rope, RopeState, Swing, Weight, WeightState};

#[test]
fn states_are_tables() {
    let text = ArmState::<f64>::default().to_string();
    let expected = "\
shoulder.angle   0.5236 rad
rail.position    0.1250 m
shoulder.rate    0.0000 rad/s
rail.velocity   -2.0000 m/s
time             0.0000 s";
    assert_eq!(text, expected);
    let text = format!("{:+.1}", WeightState::<f32> { t: 12.5, ..Default::default() });
    assert_eq!(text, "hold.position   +0.0 m\nhold.velocity   +0.0 m/s\ntime           +12.5 s");
    let text = format!("{:.2e}", ArmState::<f64>::default());
    assert!(text.starts_with("shoulder.angle  5.24e-1 rad\n"), "{text}");
}

#[test]
fn repeated_hinges_and_quaternions_have_their_names() {
    let text = RopeState::<f64>::default().to_string();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 13 * 7 + 2 + 1);
    assert_eq!(lines[48], "joint[12].orientation.w  1.0000");
    let has = |name: &str| lines.iter().any(|line| line.starts_with(name));
    assert!(has("joint[12].rate.z ") && has("hook.angle ") && !has("joint[13]"));
}

#[test]
fn inputs_and_parameters_are_tables() {
    let mut arm = Arm::<f64>::new();
    arm.set_payload(0.75).expect("a mass");
    assert_eq!(arm.parameters().to_string(), "payload  0.7500 kg\nreach    0.4000 m");
    let mut inputs = arm.no_inputs();
    (inputs.shoulder, inputs.push_force.z) = (3.0, -4.5);
    let expected = "\
shoulder       3.0000 N*m
push.force.x   0.0000 N
push.force.y   0.0000 N
push.force.z  -4.5000 N";
    assert_eq!(inputs.to_string(), expected);
    let mut rope = Rope::<f64>::new();
    rope.set_stiffness(|index| index as f64).expect("damping");
    let text = rope.parameters().to_string();
    assert_eq!(text.lines().count(), 13);
    assert!(text.ends_with("stiffness[12]  12.0000 N*m*s/rad"), "{text}");
    let none = Weight::<f64>::new();
    assert_eq!(format!("{}{}", none.no_inputs(), none.parameters()), "");
}

/// The spring pulls the block down with 10 N.
#[test]
fn points_on_a_line_are_tables() -> Result<(), mstmm::Error> {
    let weight = Weight::<f64>::new();
    let mut state = weight.initial_state();
    state.hold_mut().set_position(0.1).set_velocity(-3.0);
    let mut at = weight.workspace();
    weight.solve_into(&state, &weight.no_inputs(), &mut at)?;
    let expected = "\
position        0.10 m
velocity       -3.00 m/s
acceleration  -19.81 m/s^2
force         -10.00 N";
    assert_eq!(format!("{:.2}", at.block().input()), expected);
    Ok(())
}

/// Every line has what the accessors say.
#[test]
fn points_in_space_are_tables() -> Result<(), mstmm::Error> {
    let arm = Arm::<f64>::new();
    let mut state = arm.initial_state();
    state.shoulder_mut().set_rate(1.5);
    let mut inputs = arm.no_inputs();
    inputs.push_force.y = 7.0;
    let mut at = arm.workspace();
    arm.solve_into(&state, &inputs, &mut at)?;
    let point = at.lower().input();
    let rows =
        point.orientation().matrix().row_iter().map(|row| row.transpose()).collect::<Vec<_>>();
    let expected = [
        ("position", point.position(), " m"),
        ("orientation", rows[0], ""),
        ("", rows[1], ""),
        ("", rows[2], ""),
        ("velocity", point.velocity(), " m/s"),
        ("angular velocity", point.angular_velocity(), " rad/s"),
        ("acceleration", point.acceleration(), " m/s^2"),
        ("angular acceleration", point.angular_acceleration(), " rad/s^2"),
        ("force", point.force(), " N"),
        ("moment", point.moment(), " N*m"),
    ];
    let text = format!("{point:.3}");
    assert_eq!(text.lines().count(), expected.len(), "{text}");
    let width = expected.iter().flat_map(|(_, v, _)| v.iter()).map(|v| format!("{v:.3}").len());
    let width = 2 + width.max().expect("some values");
    for (line, (label, v, unit)) in text.lines().zip(&expected) {
        let [x, y, z] = [v.x, v.y, v.z].map(|value| format!("{value:>width$.3}"));
        assert_eq!(line, format!("{label:20}{x}{y}{z}{unit}"), "{text}");
    }
    assert!(point.force().norm() > 1.0 && point.moment().norm() > 1.0);
    Ok(())
}

/// The tables of points of bodies have the lines of connection points without force and moment, and what the accessors say.
#[test]
fn points_of_bodies_in_space_are_tables() -> Result<(), mstmm::Error> {
    let arm = Arm::<f64>::new();
    let mut state = arm.initial_state();
    state.shoulder_mut().set_rate(1.5);
    let mut at = arm.workspace();
    arm.solve_into(&state, &arm.no_inputs(), &mut at)?;
    let (tool, input) = (at.lower().tool(), at.lower().input());
    let [x, y, z] =
        input.orientation().matrix().row_iter().map(|row| row.transpose()).collect::<Vec<_>>()[..]
    else {
        panic!("three rows")
    };
    let expected = [
        ("position", tool.position(), " m"),
        ("orientation", x, ""),
        ("", y, ""),
        ("", z, ""),
        ("velocity", tool.velocity(), " m/s"),
        ("angular velocity", tool.angular_velocity(), " rad/s"),
        ("acceleration", tool.acceleration(), " m/s^2"),
        ("angular acceleration", tool.angular_acceleration(), " rad/s^2"),
    ];
    let text = format!("{tool:.3}");
    assert_eq!(text.lines().count(), expected.len(), "{text}");
    for (line, (label, value, unit)) in text.lines().zip(&expected) {
        let words: Vec<String> = value.iter().map(|value| format!("{value:.3}")).collect();
        let found: Vec<&str> =
            line[label.len()..].trim_end_matches(unit).split_whitespace().collect();
        assert!(line.starts_with(label) && line.ends_with(unit), "{text}");
        assert_eq!(found, words, "{text}");
    }
    assert!((tool.velocity() - input.velocity()).norm() > 0.1);
    assert!((tool.acceleration() - input.acceleration()).norm() > 0.1);
    Ok(())
}

/// A rod that rotates at 2 rad/s about its end, without weight: its tip has the speed 2 m/s and the acceleration 4 m/s².
#[test]
fn points_of_bodies_in_the_plane_and_on_a_line_are_tables() -> Result<(), mstmm::Error> {
    let swing = Swing::<f64>::new();
    let mut state = swing.initial_state();
    state.hub_mut().set_rate(2.0);
    let mut at = swing.workspace();
    swing.solve_into(&state, &swing.no_inputs(), &mut at)?;
    let expected = "\
position               1.0   0.0 m
cosine and sine        1.0   0.0
velocity               0.0   2.0 m/s
angular velocity       2.0 rad/s
acceleration          -4.0   0.0 m/s^2
angular acceleration   0.0 rad/s^2";
    assert_eq!(format!("{:.1}", at.rod().tip()), expected);
    let exponents = format!("{:.0e}", at.rod().tip());
    assert!(exponents.starts_with("position               1e0   0e0 m\n"), "{exponents}");

    let weight = Weight::<f64>::new();
    let mut state = weight.initial_state();
    state.hold_mut().set_position(0.1).set_velocity(-3.0);
    let mut at = weight.workspace();
    weight.solve_into(&state, &weight.no_inputs(), &mut at)?;
    let expected = "position        0.60 m\nvelocity       -3.00 m/s\nacceleration  -19.81 m/s^2";
    assert_eq!(format!("{:.2}", at.block().top()), expected);
    Ok(())
}

/// A chain whose results are poses has no other lines.
#[test]
fn omitted_results_of_points_of_bodies_have_no_lines() -> Result<(), mstmm::Error> {
    let poses = Poses::<f64>::new();
    let mut at = poses.workspace();
    poses.solve_into(&poses.initial_state(), &poses.no_inputs(), &mut at)?;
    let expected = "position         1.0  0.0 m\ncosine and sine  1.0  0.0";
    assert_eq!(format!("{:.1}", at.rod().tip()), expected);
    Ok(())
}
