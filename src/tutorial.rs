#![doc = include_str!("tutorial/tutorial.md")]

pub mod further {
    #![doc = include_str!("tutorial/further.md")]
}

#[doc(alias("branch", "contact", "humanoid", "leg", "legged robot", "quadruped", "tree"))]
pub mod trees {
    #![doc = include_str!("tutorial/trees.md")]
}
