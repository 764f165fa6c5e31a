//! Body types are wrong: outputs, centres of mass and named points can be read all the same.

use mstmm::prelude::*;

mstmm_chain! {
    chain Arm {
        body Rod {
            mass = 1 furlong;
            com = [0.5, 0, 0] m;
            inertia = diag(0.1, 5, 5) kg*m^2 about com;
            point tip = [1, 0, 0] m;
        }
        body Hand {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            inertia = diag(1, 5, 5) kg*m^2 about com;
            point palm = [1, 0] m;
            point thumb = [1, 0, 0] furlong;
        }
        ground -> pin(z) joint -> Rod rod -> repeat 3 { pin(y) wrist -> Hand hand } -> pin(z) last -> Hnad end;
    }
}

fn tip(rod: &ArmRodResult<f64>) -> mstmm::BodyPoint<mstmm::Point<f64>> {
    rod.tip()
}

fn main() -> Result<(), mstmm::Error> {
    let arm = Arm::<f64>::new();
    let mut at = arm.workspace();
    arm.solve_into(&arm.initial_state(), &arm.no_inputs(), &mut at)?;
    println!("{} {}", tip(&at.rod()).position(), at.rod().output().force());
    println!("{:?}", at.hand(1).map(|hand| (hand.palm().velocity(), hand.com(), hand.output())));
    println!("{} {}", at.end().palm().position(), at.end().thumb().acceleration());
    println!("{}", at.end().output().position());
    Ok(())
}
