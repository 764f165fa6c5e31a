//! Connection points: the first element's input, then every element's output.

use mstmm::mstmm_chain;

macro_rules! chains {
    ($method:ident: $unrolled:ident $repeated:ident $hanging:ident $adrift:ident) => {
        mstmm_chain! {
            pub chain $unrolled {
                method = $method;
                gravity = [1, -9.8, 2] m/s^2;
                body Rod {
                    mass = 1 kg; com = [0.5, 0.1, 0] m; output = [1, 0, 0.2] m;
                    inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com;
                }
                ground -> pin(z) a -> Rod la -> weld w -> Rod lw -> ball b -> Rod lb;
                hinge a { start = 0.3; start_rate = 1; }
                hinge b { start = rpy(0.1, 0.2, 0.3); }
            }
            pub chain $repeated {
                method = $method;
                gravity = [1, -9.8, 2] m/s^2;
                body Rod {
                    mass = 1 kg; com = [0.5, 0.1, 0] m; output = [1, 0, 0.2] m;
                    inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com;
                }
                ground -> ball base -> Rod first -> repeat 3 { pin(z) a -> Rod la -> slider b -> Rod lb }
                    -> weld w -> Rod lw -> repeat 2 { pin(y) c -> Rod lc };
                hinge a { start = 0.3; start_rate = 1; }
                hinge c { start = 0.4; }
            }
            pub chain $hanging {
                method = $method;
                gravity = [1, -9.8, 2] m/s^2;
                body Rod {
                    mass = 1 kg; com = [0.5, 0.1, 0] m; output = [1, 0, 0.2] m;
                    inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com;
                }
                Rod la -> pin(z) a -> Rod lb -> pin(y) b -> ground;
                hinge a { start = 0.3; start_rate = 1; }
            }
            pub chain $adrift {
                method = $method;
                gravity = [1, -9.8, 2] m/s^2;
                body Rod {
                    mass = 1 kg; com = [0.5, 0.1, 0] m; output = [1, 0, 0.2] m;
                    inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com;
                }
                Rod hull -> pin(z) a -> Rod la;
                hinge a { start = 0.3; start_rate = 1; }
            }
        }
    };
}

chains! { riccati: Written Repeated Hanging Adrift }
chains! { transfer: WrittenByTransfer RepeatedByTransfer HangingByTransfer AdriftByTransfer }

/// The points of a chain, beside those of its elements along the route.
macro_rules! check {
    ($chain:ident $number:ident: $($element:ident $([$index:literal])?)*) => {{
        let chain = $chain::<$number>::new();
        let mut at = chain.workspace();
        let (state, inputs) = (chain.initial_state(), chain.no_inputs());
        chain.solve_into(&state, &inputs, &mut at).expect("a regular chain");
        let ends = [$({
            let element = at.$element($($index)?);
            $(let element = element.expect(concat!("number ", $index));)?
            (element.input(), element.output())
        }),*];
        let points = at.points();
        assert_eq!(points.len(), ends.len() + 1);
        assert_eq!(points[0], ends[0].0);
        for (k, (input, output)) in ends.into_iter().enumerate() {
            assert_eq!(points[k], input, "{k}");
            assert_eq!(points[k + 1], output, "{k}");
        }
        // They are not all the same: but for the sides of a weld every point differs from the next.
        assert!(points.windows(2).filter(|pair| pair[0] == pair[1]).count() < 2);
    }};
}

#[test]
fn points_lie_along_the_route() {
    check!(Written f64: a la w lw b lb);
    check!(Written f32: a la w lw b lb);
    check!(WrittenByTransfer f64: a la w lw b lb);
    check!(WrittenByTransfer f32: a la w lw b lb);
    check!(Hanging f64: la a lb b);
    check!(HangingByTransfer f64: la a lb b);
    check!(Adrift f64: hull a la);
    check!(AdriftByTransfer f64: hull a la);
}

#[test]
fn points_of_repeated_parts_lie_by_repetition() {
    check!(Repeated f64: base first a[0] la[0] b[0] lb[0] a[1] la[1] b[1] lb[1] a[2] la[2] b[2] lb[2]
        w lw c[0] lc[0] c[1] lc[1]);
    check!(Repeated f32: base first a[0] la[0] b[0] lb[0] a[1] la[1] b[1] lb[1] a[2] la[2] b[2] lb[2]
        w lw c[0] lc[0] c[1] lc[1]);
    check!(RepeatedByTransfer f64: base first a[0] la[0] b[0] lb[0] a[1] la[1] b[1] lb[1] a[2] la[2]
        b[2] lb[2] w lw c[0] lc[0] c[1] lc[1]);
}
