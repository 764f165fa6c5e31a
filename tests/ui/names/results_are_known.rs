mstmm::mstmm_chain! {
    chain Misspelt {
        results = [z, pose, energies];
        body Rod { mass = 1 kg; com = [0.5, 0, 0] m; inertia = diag(0.01, 1, 1) kg*m^2 about com; }
        ground -> pin(z) joint -> Rod rod;
    }

    chain Twice {
        results = [z, z];
        body Rod { mass = 1 kg; com = [0.5, 0, 0] m; inertia = diag(0.01, 1, 1) kg*m^2 about com; }
        ground -> pin(z) joint -> Rod rod;
    }

    chain Nothing {
        results = [];
        body Rod { mass = 1 kg; com = [0.5, 0, 0] m; inertia = diag(0.01, 1, 1) kg*m^2 about com; }
        ground -> pin(z) joint -> Rod rod;
    }

    chain Counted {
        results = [1, loads];
        body Rod { mass = 1 kg; com = [0.5, 0, 0] m; inertia = diag(0.01, 1, 1) kg*m^2 about com; }
        ground -> pin(z) joint -> Rod rod;
    }

    chain Measured {
        results = [z] N;
        body Rod { mass = 1 kg; com = [0.5, 0, 0] m; inertia = diag(0.01, 1, 1) kg*m^2 about com; }
        ground -> pin(z) joint -> Rod rod;
    }
}

fn main() {}
