/* Tests that invalid calls return the right code and change nothing. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "mstmm_arm.h"

static int failures = 0;

static void check(int holds, const char *what, int line)
{
    if (!holds) {
        fprintf(stderr, "misuse.c:%d: %s\n", line, what);
        ++failures;
    }
}

#define CHECK(condition) check(condition, #condition, __LINE__)

static mstmm_arm arm, arm_before;
static mstmm_arm_state state, state_before;
static mstmm_arm_inputs inputs;
static mstmm_arm_results at, at_before;

/* Tests that a call returned this code and changed nothing. */
static int refused(mstmm_status status, int32_t code, int32_t hinge)
{
    return status.code == code && status.hinge == hinge && !memcmp(&arm, &arm_before, sizeof arm) &&
           !memcmp(&state, &state_before, sizeof state) && !memcmp(&at, &at_before, sizeof at);
}

static int done(mstmm_status status)
{
    return status.code == MSTMM_OK && status.hinge == -1;
}

static void remember(void)
{
    arm_before = arm;
    state_before = state;
    at_before = at;
}

static void null_pointers(void)
{
    const int32_t code = MSTMM_NULL_POINTER;
    remember();
    CHECK(refused(mstmm_arm_init(NULL, 1e-3f), code, -1));
    CHECK(refused(mstmm_arm_set_step(NULL, 1e-3f), code, -1));
    CHECK(refused(mstmm_arm_no_inputs(NULL), code, -1));
    CHECK(refused(mstmm_arm_initial_state(NULL, &state), code, -1));
    CHECK(refused(mstmm_arm_initial_state(&arm, NULL), code, -1));
    CHECK(refused(mstmm_arm_set_payload_mass(NULL, 1.0f), code, -1));
    CHECK(refused(mstmm_arm_set_payload_spin(NULL, 1.0f), code, -1));
    mstmm_real value = 7.0f;
    CHECK(refused(mstmm_arm_get_payload_mass(NULL, &value), code, -1) && value == 7.0f);
    CHECK(refused(mstmm_arm_get_payload_mass(&arm, NULL), code, -1));
    mstmm_real accelerations[MSTMM_ARM_RATES];
    CHECK(refused(mstmm_arm_accelerations(NULL, &state, &inputs, accelerations), code, -1));
    CHECK(refused(mstmm_arm_accelerations(&arm, NULL, &inputs, accelerations), code, -1));
    CHECK(refused(mstmm_arm_accelerations(&arm, &state, NULL, accelerations), code, -1));
    CHECK(refused(mstmm_arm_accelerations(&arm, &state, &inputs, NULL), code, -1));
    const mstmm_real place[3] = {0.0f, 0.0f, 0.0f};
    mstmm_real jacobian[6 * MSTMM_ARM_RATES];
    CHECK(refused(mstmm_arm_payload_jacobian(&arm, &state, &inputs, NULL, jacobian), code, -1));
    CHECK(refused(mstmm_arm_payload_jacobian(&arm, &state, &inputs, place, NULL), code, -1));
    CHECK(refused(mstmm_arm_step(NULL, &state, &inputs), code, -1));
    CHECK(refused(mstmm_arm_step(&arm, NULL, &inputs), code, -1));
    CHECK(refused(mstmm_arm_step(&arm, &state, NULL), code, -1));
    CHECK(refused(mstmm_arm_solve(NULL, &state, &inputs, &at), code, -1));
    CHECK(refused(mstmm_arm_solve(&arm, NULL, &inputs, &at), code, -1));
    CHECK(refused(mstmm_arm_solve(&arm, &state, NULL, &at), code, -1));
    CHECK(refused(mstmm_arm_solve(&arm, &state, &inputs, NULL), code, -1));
}

/* The private contents of the arm may change. */
static int step_refused(int32_t code, int32_t hinge)
{
    mstmm_status status = mstmm_arm_step(&arm, &state, &inputs);
    arm = arm_before;
    return refused(status, code, hinge);
}

static void numbers(void)
{
    static const mstmm_real STRANGE[] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 3; ++i) {
        const mstmm_real place[3] = {0.0f, STRANGE[i], 0.0f};
        mstmm_real jacobian[6 * MSTMM_ARM_RATES] = {7.0f};
        remember();
        CHECK(refused(mstmm_arm_payload_jacobian(&arm, &state, &inputs, place, jacobian),
                      MSTMM_NOT_FINITE, -1) &&
              jacobian[0] == 7.0f);
        CHECK(refused(mstmm_arm_init(&arm, STRANGE[i]), MSTMM_NOT_FINITE, -1));
        CHECK(refused(mstmm_arm_set_step(&arm, STRANGE[i]), MSTMM_NOT_FINITE, -1));
        CHECK(refused(mstmm_arm_set_payload_mass(&arm, STRANGE[i]), MSTMM_PARAMETER, -1));
        CHECK(refused(mstmm_arm_set_payload_spin(&arm, STRANGE[i]), MSTMM_PARAMETER, -1));

        mstmm_real *places[] = {&state.q[MSTMM_ARM_Q_ELBOW_ANGLE],
                                &state.q[MSTMM_ARM_Q_HOOK_ORIENTATION_W],
                                &state.v[MSTMM_ARM_V_WAIST_RATE], &state.t,
                                &inputs.u[MSTMM_ARM_U_WAIST]};
        for (size_t place = 0; place < sizeof places / sizeof *places; ++place) {
            mstmm_real kept = *places[place];
            *places[place] = STRANGE[i];
            remember();
            CHECK(step_refused(MSTMM_NOT_FINITE, -1));
            CHECK(refused(mstmm_arm_solve(&arm, &state, &inputs, &at), MSTMM_NOT_FINITE, -1));
            *places[place] = kept;
        }
    }
    /* Finite, with results that are not finite. */
    state.v[MSTMM_ARM_V_WAIST_RATE] = 1e30f;
    remember();
    CHECK(step_refused(MSTMM_NOT_FINITE, -1));
    CHECK(done(mstmm_arm_initial_state(&arm, &state)));
}

/* A quaternion that is not a rotation. */
static void quaternions(void)
{
    for (int i = 0; i < 4; ++i) {
        state.q[MSTMM_ARM_Q_HOOK_ORIENTATION_W + i] = 0.0f;
    }
    remember();
    CHECK(step_refused(MSTMM_QUATERNION, MSTMM_ARM_HINGE_HOOK));
    CHECK(refused(mstmm_arm_solve(&arm, &state, &inputs, &at), MSTMM_QUATERNION,
                  MSTMM_ARM_HINGE_HOOK));
    const mstmm_real place[3] = {0.0f, 0.0f, 0.0f};
    mstmm_real jacobian[6 * MSTMM_ARM_RATES];
    CHECK(refused(mstmm_arm_payload_jacobian(&arm, &state, &inputs, place, jacobian),
                  MSTMM_QUATERNION, MSTMM_ARM_HINGE_HOOK));
    CHECK(done(mstmm_arm_initial_state(&arm, &state)));
}

static void parameters(void)
{
    mstmm_real value = 7.0f;
    CHECK(done(mstmm_arm_get_payload_mass(&arm, &value)) && value == 2.0f);
    remember();
    CHECK(refused(mstmm_arm_set_payload_mass(&arm, 0.0f), MSTMM_PARAMETER, -1));
    CHECK(refused(mstmm_arm_set_payload_mass(&arm, -1.0f), MSTMM_PARAMETER, -1));
    CHECK(refused(mstmm_arm_set_payload_spin(&arm, -0.01f), MSTMM_PARAMETER, -1));

    /* A thin rod up to rounding: its rotation about its axis is not determined. */
    const mstmm_real thin[] = {1e-9f, 0.0f};
    for (int rod = 0; rod < 2; ++rod) {
        CHECK(done(mstmm_arm_set_payload_spin(&arm, thin[rod])));
        remember();
        CHECK(step_refused(MSTMM_SINGULAR, MSTMM_ARM_HINGE_HOOK));
        CHECK(refused(mstmm_arm_solve(&arm, &state, &inputs, &at), MSTMM_SINGULAR, MSTMM_ARM_HINGE_HOOK));
    }
    CHECK(done(mstmm_arm_set_payload_spin(&arm, 0.01f)));
    CHECK(done(mstmm_arm_step(&arm, &state, &inputs)));
    CHECK(state.t == 1e-3f);
}

/* A copy of an arm continues in the same way. */
static void copies(void)
{
    mstmm_arm other = arm;
    mstmm_arm_state other_state = state;
    for (int step = 0; step < 100; ++step) {
        CHECK(done(mstmm_arm_step(&arm, &state, &inputs)));
        CHECK(done(mstmm_arm_step(&other, &other_state, &inputs)));
    }
    CHECK(!memcmp(&state, &other_state, sizeof state));
}

#define NAMED(code) CHECK(!strcmp(mstmm_code_name(code), #code))

static void names(void)
{
    NAMED(MSTMM_OK);
    NAMED(MSTMM_NULL_POINTER);
    NAMED(MSTMM_NOT_FINITE);
    NAMED(MSTMM_SINGULAR);
    NAMED(MSTMM_PARAMETER);
    NAMED(MSTMM_QUATERNION);
    NAMED(MSTMM_INDEX);
    NAMED(MSTMM_NOT_ASSEMBLED);
    NAMED(MSTMM_CLOSURE_RANK);
    NAMED(MSTMM_OTHER);
    CHECK(!strcmp(mstmm_arm_hinge_name(MSTMM_ARM_HINGE_WAIST), "waist"));
    CHECK(!strcmp(mstmm_arm_hinge_name(MSTMM_ARM_HINGE_SHOULDER), "shoulder"));
    CHECK(!strcmp(mstmm_arm_hinge_name(MSTMM_ARM_HINGE_ELBOW), "elbow"));
    CHECK(!strcmp(mstmm_arm_hinge_name(MSTMM_ARM_HINGE_HOOK), "hook"));
    CHECK(!strcmp(mstmm_arm_hinge_name(MSTMM_ARM_HINGE_MOUNT), "mount"));
    static const int32_t NONE[] = {-1, INT32_MIN, INT32_MAX, MSTMM_OTHER + 1};
    for (int i = 0; i < 4; ++i) {
        CHECK(!strcmp(mstmm_code_name(NONE[i]), ""));
        CHECK(!strcmp(mstmm_code_message(NONE[i]), ""));
        CHECK(!strcmp(mstmm_arm_hinge_name(NONE[i]), ""));
    }
}

int main(void)
{
    CHECK(mstmm_arm_size() == sizeof arm);
    CHECK(done(mstmm_arm_init(&arm, 2.0f)));
    CHECK(done(mstmm_arm_set_step(&arm, 1e-3f)));
    inputs.u[MSTMM_ARM_U_WAIST] = 1.0f;
    CHECK(done(mstmm_arm_no_inputs(&inputs)) && inputs.u[MSTMM_ARM_U_WAIST] == 0.0f);
    CHECK(done(mstmm_arm_initial_state(&arm, &state)));
    CHECK(done(mstmm_arm_solve(&arm, &state, &inputs, &at)));
    null_pointers();
    numbers();
    quaternions();
    parameters();
    copies();
    names();
    return failures != 0;
}
