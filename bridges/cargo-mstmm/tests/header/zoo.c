/* Prints indices, and results by their bits, for the comparison with Rust. In C99 and C++11. */
#include <stdio.h>
#include <string.h>

#include "mstmm_zoo.h"

static mstmm_zoo zoo;
static mstmm_zoo_state state;
static mstmm_zoo_inputs inputs;
static mstmm_zoo_results at;
static mstmm_real efforts[MSTMM_ZOO_RATES];
static mstmm_real matrix[MSTMM_ZOO_RATES * MSTMM_ZOO_RATES];
static mstmm_real jacobian[6 * MSTMM_ZOO_RATES];
static mstmm_zoo_momentum_result momentum;

static mstmm_swing swing;
static mstmm_swing_state swing_state;
static mstmm_swing_inputs swing_inputs;
static mstmm_swing_results swing_at;
static mstmm_real swing_matrix[MSTMM_SWING_RATES * MSTMM_SWING_RATES];
static mstmm_real swing_a[4 * MSTMM_SWING_RATES * MSTMM_SWING_RATES];
static mstmm_real swing_b[2 * MSTMM_SWING_RATES * MSTMM_SWING_INPUTS];

static mstmm_cart cart;
static mstmm_cart_state cart_state;
static mstmm_cart_inputs cart_inputs;
static mstmm_cart_results cart_at;

static void print(const char *name, const void *numbers, size_t size)
{
    size_t i;
    printf("%s", name);
    for (i = 0; i < size / sizeof(mstmm_real); ++i) {
        uint32_t bits;
        memcpy(&bits, (const char *)numbers + i * sizeof(mstmm_real), sizeof bits);
        printf(" %08lx", (unsigned long)bits);
    }
    printf("\n");
}

static void status(mstmm_status status)
{
    printf("%s %s\n", mstmm_code_name(status.code), mstmm_zoo_hinge_name(status.hinge));
}

static void indices(void)
{
    printf("indices %d %d %d %d\n", MSTMM_ZOO_Q_D_ANGLE, MSTMM_ZOO_Q_LINK_ORIENTATION_X(2),
           MSTMM_ZOO_V_LINK_RATE_Z(1), MSTMM_ZOO_U_INT_STATE_RATE);
    printf("points %d %d %d\n", MSTMM_ZOO_AT_BEAD_OUTPUT(1), MSTMM_ZOO_AT_WHEEL_INPUT,
           MSTMM_ZOO_AT_D_OUTPUT);
    printf("counts %d %d %d %d %d\n", MSTMM_ZOO_COORDINATES, MSTMM_ZOO_RATES, MSTMM_ZOO_INPUTS,
           MSTMM_ZOO_PARAMETERS, MSTMM_ZOO_POINTS);
    /* Two paths with the same name in upper case. */
    printf("swing %d %d\n", MSTMM_SWING_Q_A_B_ANGLE, MSTMM_SWING_Q_A_B_ANGLE_2);
}

static void motion(void)
{
    int step;
    mstmm_real value = 0;
    status(mstmm_zoo_init(&zoo, 1e-3f));
    status(mstmm_zoo_set_load(&zoo, 1.5f));
    status(mstmm_zoo_set_load(&zoo, -1.0f));
    status(mstmm_zoo_set_knot(&zoo, 1, 0.2f));
    status(mstmm_zoo_set_knot(&zoo, 3, 0.2f));
    status(mstmm_zoo_set_knot(&zoo, -1, 0.2f));
    status(mstmm_zoo_get_knot(&zoo, 1, &value));
    print("knot", &value, sizeof value);
    status(mstmm_zoo_initial_state(&zoo, &state));
    status(mstmm_zoo_no_inputs(&inputs));
    inputs.u[MSTMM_ZOO_U_GRAVITY_Z] = -9.81f;
    inputs.u[MSTMM_ZOO_U_A] = 0.3f;
    inputs.u[MSTMM_ZOO_U_INT_STATE_ANGLE] = 0.1f;
    inputs.u[MSTMM_ZOO_U_INT_STATE_RATE] = 0.2f;
    inputs.u[MSTMM_ZOO_U_INT_ACCELERATION] = 0.4f;
    inputs.u[MSTMM_ZOO_U_PUSH_FORCE_X] = 1.0f;
    state.q[MSTMM_ZOO_Q_B_ANGLE] += 0.01f;
    status(mstmm_zoo_assemble(&zoo, &state, &inputs));
    print("assembled", &state, sizeof state);
    for (step = 0; step < 50; ++step) {
        mstmm_status stepped = mstmm_zoo_step(&zoo, &state, &inputs);
        if (stepped.code != MSTMM_OK) {
            status(stepped);
        }
    }
    print("moved", &state, sizeof state);
    status(mstmm_zoo_solve(&zoo, &state, &inputs, &at));
    print("results", &at, sizeof at);
    status(mstmm_zoo_inverse_dynamics(&zoo, &state, &inputs, at.accelerations, efforts));
    print("efforts", efforts, sizeof efforts);
    status(mstmm_zoo_mass_matrix_times(&zoo, &state, &inputs, at.accelerations, efforts));
    print("product", efforts, sizeof efforts);
    status(mstmm_zoo_mass_matrix(&zoo, &state, &inputs, matrix));
    print("matrix", matrix, sizeof matrix);
    status(mstmm_zoo_jacobian(&zoo, &state, &inputs, MSTMM_ZOO_FRAME_WHEEL_RIM, jacobian));
    print("jacobian", jacobian, sizeof jacobian);
    status(mstmm_zoo_momentum(&zoo, &state, &inputs, &momentum));
    print("momentum", &momentum, sizeof momentum);
    state.q[MSTMM_ZOO_Q_LINK_ORIENTATION_W(1)] = 3.0f;
    status(mstmm_zoo_step(&zoo, &state, &inputs));
    status(mstmm_zoo_assemble(&zoo, &state, NULL));
}

static void others(void)
{
    status(mstmm_swing_init(&swing, 1e-3f));
    status(mstmm_swing_set_length_2(&swing, 0.7f));
    status(mstmm_swing_initial_state(&swing, &swing_state));
    swing_inputs.u[MSTMM_SWING_U_A_B] = 0.5f;
    status(mstmm_swing_step(&swing, &swing_state, &swing_inputs));
    status(mstmm_swing_solve(&swing, &swing_state, &swing_inputs, &swing_at));
    print("swing", &swing_at, sizeof swing_at);
    status(mstmm_swing_linearize(&swing, &swing_state, &swing_inputs, swing_a, swing_b));
    print("a", swing_a, sizeof swing_a);
    print("b", swing_b, sizeof swing_b);
    status(mstmm_swing_mass_matrix(&swing, &swing_state, &swing_inputs, swing_matrix));
    print("matrix", swing_matrix, sizeof swing_matrix);

    status(mstmm_cart_init(&cart, 1e-3f));
    status(mstmm_cart_no_inputs(&cart_inputs));
    status(mstmm_cart_initial_state(&cart, &cart_state));
    status(mstmm_cart_step(&cart, &cart_state, &cart_inputs));
    status(mstmm_cart_solve(&cart, &cart_state, &cart_inputs, &cart_at));
    print("cart", &cart_at, sizeof cart_at);
}

int main(void)
{
    if (mstmm_zoo_size() != sizeof zoo || mstmm_swing_size() != sizeof swing ||
        mstmm_cart_size() != sizeof cart) {
        return 1;
    }
    indices();
    motion();
    others();
    return 0;
}
