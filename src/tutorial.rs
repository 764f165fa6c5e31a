#![doc = include_str!("tutorial/tutorial.md")]

pub mod five_minutes {
    #![doc(alias("URDF", "import", "quick start", "robot", "Parser", "AddModels", "mj_loadXML"))]
    #![doc(alias("buildModelFromUrdf", "buildModelFromMJCF"))]
    #![doc = include_str!("tutorial/five_minutes.md")]
}

pub mod further {
    #![doc(alias(
        "autodiff",
        "AutoDiffXd",
        "dual number",
        "derivative",
        "linearization",
        "sensitivity",
        "event",
        "zero crossing"
    ))]
    #![doc = include_str!("tutorial/further.md")]
}

pub mod trees {
    #![doc(alias("branch", "contact", "humanoid", "leg", "legged robot", "quadruped", "tree"))]
    #![doc(alias("parent", "attach", "appendModel", "prefix", "replicate"))]
    #![doc = include_str!("tutorial/trees.md")]
}

pub mod answers {
    #![doc(alias(
        "Jacobian",
        "mass matrix",
        "gravity compensation",
        "operational space control",
        "control engineer",
        "computeAllTerms",
        "J-dot v"
    ))]
    #![doc = include_str!("tutorial/answers.md")]
}

pub mod equilibrium {
    #![doc(alias(
        "trim",
        "trim condition",
        "operating point",
        "fixed point",
        "steady state",
        "FindFixedPoint",
        "findop",
        "natural frequency",
        "eigenfrequency",
        "modal analysis",
        "mode shape",
        "damping ratio",
        "vibration",
        "vibration mode"
    ))]
    #![doc = include_str!("tutorial/equilibrium.md")]
}

pub mod several_loops {
    #![doc(alias(
        "parallel robot",
        "delta robot",
        "Stewart platform",
        "hexapod",
        "KKT",
        "Lagrange multiplier",
        "closed loops",
        "loop constraint"
    ))]
    #![doc = include_str!("tutorial/several_loops.md")]
}

pub mod balance {
    #![doc(alias(
        "LQR",
        "linear-quadratic regulator",
        "linearization",
        "inverted pendulum",
        "acrobot"
    ))]
    #![doc = include_str!("tutorial/balance.md")]
    #![doc = include_str!("tutorial/balance.svg")]
}

pub mod computed_torque {
    #![doc(alias("inverse dynamics", "feedback linearization", "feed-forward", "payload"))]
    #![doc = include_str!("tutorial/computed_torque.md")]
    #![doc = include_str!("tutorial/computed_torque.svg")]
}

pub mod identify {
    #![doc(alias("identification", "regressor", "base parameters", "calibration"))]
    #![doc = include_str!("tutorial/identify.md")]
    #![doc = include_str!("tutorial/identify.svg")]
}

pub mod bearing_loads {
    #![doc(alias("bearing", "reaction", "gyroscopic moment", "unbalance"))]
    #![doc = include_str!("tutorial/bearing_loads.md")]
    #![doc = include_str!("tutorial/bearing_loads.svg")]
}

pub mod diffsol {
    #![doc(alias(
        "BDF",
        "SUNDIALS",
        "CVODE",
        "ODE solver",
        "stiff",
        "event",
        "impact",
        "root finding",
        "forward sensitivity"
    ))]
    #![doc = include_str!("tutorial/diffsol.md")]
}
