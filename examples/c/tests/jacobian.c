/* Tests that the Jacobian of a body at a free end is that of a frame on it. */
#include <math.h>
#include <stdio.h>

#include "mstmm_arm.h"

enum { SIZE = 6 * MSTMM_ARM_RATES };

int main(void)
{
    static mstmm_arm arm;
    static mstmm_arm_state state;
    static mstmm_arm_inputs inputs;
    /* That of the point `grip` in the description. */
    const mstmm_real place[3] = {0.0f, 0.0f, -0.3f};
    mstmm_real of_frame[SIZE], of_body[SIZE];
    mstmm_real largest = 0.0f;
    int failures = 0;

    failures += mstmm_arm_init(&arm, 1e-3f).code;
    failures += mstmm_arm_no_inputs(&inputs).code;
    failures += mstmm_arm_initial_state(&arm, &state).code;
    inputs.u[MSTMM_ARM_U_WAIST] = 5.0f;
    for (int step = 0; step < 200; ++step) {
        failures += mstmm_arm_step(&arm, &state, &inputs).code;
    }
    failures += mstmm_arm_jacobian(&arm, &state, &inputs, MSTMM_ARM_FRAME_PAYLOAD_GRIP, of_frame).code;
    failures += mstmm_arm_payload_jacobian(&arm, &state, &inputs, place, of_body).code;
    for (int i = 0; i < SIZE; ++i) {
        largest = fmaxf(largest, fabsf(of_frame[i]));
        /* About 60 roundings of values up to 2 m. */
        if (!(fabsf(of_body[i] - of_frame[i]) < 1e-5f)) {
            fprintf(stderr, "jacobian.c: entry %d is %g instead of %g\n", i, of_body[i], of_frame[i]);
            ++failures;
        }
    }
    /* The rotation of the waist is an entry of one. */
    return failures != 0 || !(largest >= 1.0f);
}
