mstmm::mstmm_chain! {
    line chain Asked {
        answers = bias_effort;
        body Car { mass = 1 kg; }
        ground -> slider a -> Car b;
    }

    line chain Twice {
        answers = [bias_efforts, bias_efforts];
        body Car { mass = 1 kg; }
        ground -> slider a -> Car b;
    }

    line chain Nothing {
        answers = [];
        body Car { mass = 1 kg; }
        ground -> slider a -> Car b;
    }

    line chain Measured {
        answers = [bias_efforts] N;
        body Car { mass = 1 kg; }
        ground -> slider a -> Car b;
    }

    line chain Several {
        answers = [basic, jacobians, linearize, basic];
        body Car { mass = 1 kg; }
        ground -> slider a -> Car b;
    }
}

fn main() {}
