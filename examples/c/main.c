/* The arm under its own weight and a controller that holds it, for one second. */
#include <stdio.h>

#include "mstmm_arm.h"

enum { MOTORS = 3 };

/* Their coordinates, rates and torques. */
static const int Q[MOTORS] = {MSTMM_ARM_Q_WAIST_ANGLE, MSTMM_ARM_Q_SHOULDER_ANGLE,
                              MSTMM_ARM_Q_ELBOW_ANGLE};
static const int V[MOTORS] = {MSTMM_ARM_V_WAIST_RATE, MSTMM_ARM_V_SHOULDER_RATE,
                              MSTMM_ARM_V_ELBOW_RATE};
static const int U[MOTORS] = {MSTMM_ARM_U_WAIST, MSTMM_ARM_U_SHOULDER, MSTMM_ARM_U_ELBOW};

/* The target angles of the joints in rad, and the gains of the controller. */
static const mstmm_real TARGET[MOTORS] = {0.5f, -0.5f, 1.25f};
static const mstmm_real STIFFNESS[MOTORS] = {200.0f, 400.0f, 200.0f}; /* N m/rad */
static const mstmm_real DAMPING[MOTORS] = {40.0f, 60.0f, 20.0f};      /* N m s/rad */

/* All have a fixed size, so the program may put them anywhere; here they are static. */
static mstmm_arm arm;
static mstmm_arm_state state;
static mstmm_arm_inputs inputs;
static mstmm_arm_results at;

static int failed(mstmm_status status)
{
    if (status.code == MSTMM_OK) {
        return 0;
    }
    fprintf(stderr, "%s %s: %s\n", mstmm_code_name(status.code),
            mstmm_arm_hinge_name(status.hinge), mstmm_code_message(status.code));
    return 1;
}

static void print(const char *name, const mstmm_real *numbers, int count)
{
    printf("%-22s", name);
    for (int i = 0; i < count; ++i) {
        printf(" %.9g", (double)numbers[i]); /* nine digits identify a float */
    }
    printf("\n");
}

int main(void)
{
    if (mstmm_arm_size() != sizeof arm) {
        fprintf(stderr, "this library is not that of the header\n");
        return 1;
    }
    if (failed(mstmm_arm_init(&arm, 1e-3f)) || failed(mstmm_arm_set_payload_mass(&arm, 3.0f)) ||
        failed(mstmm_arm_initial_state(&arm, &state))) {
        return 1;
    }
    for (int step = 0; step < 1000; ++step) {
        for (int i = 0; i < MOTORS; ++i) {
            mstmm_real pull = STIFFNESS[i] * (TARGET[i] - state.q[Q[i]]);
            mstmm_real brake = DAMPING[i] * state.v[V[i]];
            inputs.u[U[i]] = pull - brake;
        }
        if (failed(mstmm_arm_step(&arm, &state, &inputs))) {
            return 1;
        }
    }
    if (failed(mstmm_arm_solve(&arm, &state, &inputs, &at))) {
        return 1;
    }
    print("time, s", &state.t, 1);
    print("joint angles, rad", state.q, MOTORS);
    print("hook, quaternion", &state.q[MSTMM_ARM_Q_HOOK_ORIENTATION_W], 4);
    print("mount, rad", &state.q[MSTMM_ARM_Q_MOUNT_ANGLE], 1);
    print("rates, rad/s", state.v, MSTMM_ARM_RATES);
    print("tip, m", at.points[MSTMM_ARM_AT_PAYLOAD_OUTPUT].position, 3);
    print("its orientation", at.points[MSTMM_ARM_AT_PAYLOAD_OUTPUT].orientation[0], 3);
    print("", at.points[MSTMM_ARM_AT_PAYLOAD_OUTPUT].orientation[1], 3);
    print("", at.points[MSTMM_ARM_AT_PAYLOAD_OUTPUT].orientation[2], 3);
    print("its acceleration, m/s2", at.points[MSTMM_ARM_AT_PAYLOAD_OUTPUT].acceleration, 3);
    print("camera, m", at.points[MSTMM_ARM_AT_CAMERA_OUTPUT].position, 3);
    print("force at the mast, N", at.points[MSTMM_ARM_AT_COLUMN_MAST].force, 3);
    print("force at the hook, N", at.points[MSTMM_ARM_AT_PAYLOAD_INPUT].force, 3);
    print("moment at the base, Nm", at.points[MSTMM_ARM_AT_WAIST_INPUT].moment, 3);
    print("kinetic energy, J", &at.kinetic_energy, 1);
    print("potential energy, J", &at.potential_energy, 1);
    return 0;
}
