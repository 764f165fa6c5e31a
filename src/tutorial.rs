#![doc = include_str!("tutorial/tutorial.md")]

pub mod further {
    #![doc(alias(
        "autodiff",
        "AutoDiffXd",
        "dual number",
        "derivative",
        "linearization",
        "sensitivity"
    ))]
    #![doc = include_str!("tutorial/further.md")]
}

pub mod trees {
    #![doc(alias("branch", "contact", "humanoid", "leg", "legged robot", "quadruped", "tree"))]
    #![doc = include_str!("tutorial/trees.md")]
}
