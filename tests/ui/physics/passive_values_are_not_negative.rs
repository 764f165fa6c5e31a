mstmm::mstmm_chain! {
    chain Pendulum {
        body Bar {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }
        param wear = 2 N*m*s/rad;
        ground -> pin a -> Bar one -> floating b -> Bar two;
        hinge a { damping = (1 N*m*s/rad) - wear; armature = -0.1 kg*m^2; }
        hinge b { stiffness = [1, -1, 1] N/m; }
    }
}

fn main() {}
