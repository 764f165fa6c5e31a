#![doc = include_str!("tutorial/tutorial.md")]

pub mod further {
    #![doc = include_str!("tutorial/further.md")]
}
