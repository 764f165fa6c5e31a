/* Prints all answers by their bits, for the comparison with Rust. In C99 and C++11. */
#include <stdio.h>
#include <string.h>

#include "mstmm_whip.h"

#define N MSTMM_WHIP_RATES
#define U MSTMM_WHIP_INPUTS
#define P MSTMM_WHIP_DYNAMIC_PARAMETERS

static mstmm_whip whip;
static mstmm_whip_state state;
static mstmm_whip_inputs inputs;
static mstmm_whip_results results;
static mstmm_whip_motion motion;
static mstmm_whip_momentum_result momentum;
static mstmm_whip_variation variation;
static mstmm_real x[N], y[N], z[N], square[N * N], second[N * N], third[N * N];
static mstmm_real jacobian[6 * N], a[4 * N * N], b[2 * N * U], regressor[N * P], dynamic[P];

static void print(const char *name, const void *numbers, size_t size)
{
    size_t i;
    printf("%s", name);
    for (i = 0; i < size / sizeof(mstmm_real); ++i) {
        uint64_t bits;
        memcpy(&bits, (const char *)numbers + i * sizeof(mstmm_real), sizeof bits);
        printf(" %08lx%08lx", (unsigned long)(bits >> 32), (unsigned long)(bits & 0xffffffffu));
    }
    printf("\n");
}

static void status(mstmm_status status)
{
    printf("%s\n", mstmm_code_name(status.code));
}

static void in_space(void)
{
    int i;
    status(mstmm_whip_init(&whip, 1e-3));
    status(mstmm_whip_set_load(&whip, 1.5));
    status(mstmm_whip_initial_state(&whip, &state));
    status(mstmm_whip_no_inputs(&inputs));
    inputs.u[MSTMM_WHIP_U_WRIST] = 0.5;
    for (i = 0; i < 20; ++i) {
        mstmm_whip_step(&whip, &state, &inputs);
    }
    for (i = 0; i < N; ++i) {
        x[i] = 0.25 * i - 1.0;
    }
    status(mstmm_whip_kinematics(&whip, &state, &inputs, MSTMM_WHIP_FRAME_HAND_FINGER, &motion));
    print("finger", &motion, sizeof motion);
    status(mstmm_whip_kinematics(&whip, &state, &inputs, MSTMM_WHIP_FRAME_BEAD_EYE(1), &motion));
    print("eye", &motion, sizeof motion);
    status(mstmm_whip_jacobian(&whip, &state, &inputs, MSTMM_WHIP_FRAME_BEAD_OUTPUT(2), jacobian));
    print("jacobian", jacobian, sizeof jacobian);
    status(mstmm_whip_kinematics(&whip, &state, &inputs, MSTMM_WHIP_FRAMES, &motion));
    status(mstmm_whip_jacobian(&whip, &state, &inputs, -1, jacobian));
    status(mstmm_whip_jacobian(&whip, &state, &inputs, 0, NULL));
    status(mstmm_whip_momentum(&whip, &state, &inputs, &momentum));
    print("momentum", &momentum, sizeof momentum);
    status(mstmm_whip_momentum_matrix(&whip, &state, &inputs, jacobian));
    print("momentum matrix", jacobian, sizeof jacobian);
    status(mstmm_whip_regressor(&whip, &state, &inputs, x, regressor));
    print("regressor", regressor, sizeof regressor);
    status(mstmm_whip_dynamic_parameters(&whip, dynamic));
    print("dynamic", dynamic, sizeof dynamic);
    print("mass", &dynamic[MSTMM_WHIP_DYNAMIC_HAND_MASS], sizeof(mstmm_real));
    print("mass", &dynamic[MSTMM_WHIP_DYNAMIC_BEAD_MASS(2)], sizeof(mstmm_real));
    print("damping", &dynamic[MSTMM_WHIP_DYNAMIC_LINK_DAMPING_WY(1)], sizeof(mstmm_real));
    status(mstmm_whip_regressor_times(&whip, &state, &inputs, x, dynamic, y));
    print("efforts", y, sizeof y);
    status(mstmm_whip_inverse_solve(&whip, &state, &inputs, x, &results));
    print("solved", &results, sizeof results);
    status(mstmm_whip_mass_matrix(&whip, &state, &inputs, square));
    print("matrix", square, sizeof square);
    status(mstmm_whip_inverse_mass_matrix(&whip, &state, &inputs, square));
    print("inverse", square, sizeof square);
    status(mstmm_whip_inverse_dynamics_derivatives(&whip, &state, &inputs, x, square, second, third));
    print("by coordinates", square, sizeof square);
    print("by rates", second, sizeof second);
    print("by accelerations", third, sizeof third);
    status(mstmm_whip_linearize(&whip, &state, &inputs, a, b));
    print("a", a, sizeof a);
    print("b", b, sizeof b);
    memset(&variation, 0, sizeof variation);
    variation.coordinates[0] = 0.5;
    variation.rates[MSTMM_WHIP_V_LINK_RATE_Y(2)] = -0.25;
    variation.inputs[MSTMM_WHIP_U_WRIST] = 2.0;
    variation.parameters[0] = 1.0;
    status(mstmm_whip_push(&whip, &state, &inputs, &variation, y, z));
    print("push", y, sizeof y);
    print("change", z, sizeof z);
    status(mstmm_whip_pull(&whip, &state, &inputs, x, y, &variation));
    print("pull", y, sizeof y);
    print("gradient", &variation, sizeof variation);
    state.q[MSTMM_WHIP_Q_LINK_ORIENTATION_W(1)] = 3.0;
    status(mstmm_whip_linearize(&whip, &state, &inputs, a, b));
}

static void in_a_plane(void)
{
    static mstmm_flat flat;
    static mstmm_flat_state at;
    static mstmm_flat_inputs none;
    static mstmm_flat_motion moved;
    static mstmm_flat_momentum_result total;
    static mstmm_flat_variation change;
    static mstmm_flat_results solved;
    mstmm_real j[3 * MSTMM_FLAT_RATES];
    const mstmm_real place[2] = {0.1, -0.2};
    status(mstmm_flat_init(&flat, 1e-3));
    status(mstmm_flat_initial_state(&flat, &at));
    status(mstmm_flat_kinematics(&flat, &at, &none, MSTMM_FLAT_FRAME_B_MARK, &moved));
    print("mark", &moved, sizeof moved);
    status(mstmm_flat_jacobian(&flat, &at, &none, MSTMM_FLAT_FRAME_B_COM, j));
    print("jacobian", j, sizeof j);
    status(mstmm_flat_b_jacobian(&flat, &at, &none, place, j));
    print("jacobian of b", j, sizeof j);
    status(mstmm_flat_b_jacobian(&flat, &at, &none, NULL, j));
    status(mstmm_flat_momentum(&flat, &at, &none, &total));
    print("momentum", &total, sizeof total);
    memset(&change, 0, sizeof change);
    change.rates[1] = 1.0;
    status(mstmm_flat_push(&flat, &at, &none, &change, x, y));
    print("change", y, MSTMM_FLAT_RATES * sizeof(mstmm_real));
    status(mstmm_flat_inverse_solve(&flat, &at, &none, y, &solved));
    print("solved", &solved, sizeof solved);
}

static void on_a_line(void)
{
    static mstmm_train train;
    static mstmm_train_state at;
    static mstmm_train_inputs none;
    static mstmm_train_motion moved;
    static mstmm_train_momentum_result total;
    static mstmm_train_variation change;
    const mstmm_real place = 2.0;
    mstmm_real j[MSTMM_TRAIN_RATES], linear[4 * MSTMM_TRAIN_RATES * MSTMM_TRAIN_RATES];
    status(mstmm_train_init(&train, 1e-3));
    status(mstmm_train_initial_state(&train, &at));
    status(mstmm_train_kinematics(&train, &at, &none, MSTMM_TRAIN_FRAME_SECOND_OUTPUT, &moved));
    print("end", &moved, sizeof moved);
    status(mstmm_train_jacobian(&train, &at, &none, MSTMM_TRAIN_FRAME_SECOND_OUTPUT, j));
    print("jacobian", j, sizeof j);
    status(mstmm_train_second_jacobian(&train, &at, &none, &place, j));
    print("jacobian of second", j, sizeof j);
    status(mstmm_train_momentum(&train, &at, &none, &total));
    print("momentum", &total, sizeof total);
    status(mstmm_train_linearize(&train, &at, &none, linear));
    print("a", linear, sizeof linear);
    x[0] = 1.0;
    x[1] = 2.0;
    status(mstmm_train_pull(&train, &at, &none, x, y, &change));
    print("coordinates", change.coordinates, sizeof change.coordinates);
}

int main(void)
{
    in_space();
    in_a_plane();
    on_a_line();
    return 0;
}
