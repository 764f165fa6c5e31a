// MuJoCo's functions for the answers, on a model of any chain or tree:
//
//     contender MODEL WHAT STATES RESULTS MILLISECONDS
//
// MODEL is a compiled model with a site at the tip, WHAT a question.
//
// `linearize` is `mjd_transitionFD`: the matrix A of one step of 1 ms of the semi-implicit Euler method by
// one-sided differences of 1e-6, without B, since the model has no actuators. `derivatives` is
// `mjd_inverseFD`, with the same differences.
#define EVALUATE evaluate
static void (*evaluate)(const double *state, double *result);
#include "contender.h"

#include "answers.h"
#include <mujoco/mujoco.h>

static const double difference = 1e-6;

static mjModel *model;
static mjData *data;
static struct places places;
static double *identity;

static void take_coordinates(const double *state) { mju_copy(data->qpos, state, model->nq); }

static void take_state(const double *state) {
    take_coordinates(state);
    mju_copy(data->qvel, state + places.rates, model->nv);
}

static void take_efforts(const double *state) {
    take_state(state);
    mju_copy(data->qfrc_applied, state + places.efforts, model->nv);
}

static void take_accelerations(const double *state) {
    take_state(state);
    mju_copy(data->qacc, state + places.accelerations, model->nv);
}

static void accelerations(const double *state, double *result) {
    take_efforts(state);
    mj_forward(model, data);
    mju_copy(result, data->qacc, model->nv);
}

static void inverse_dynamics(const double *state, double *result) {
    take_accelerations(state);
    mj_inverse(model, data);
    mju_copy(result, data->qfrc_inverse, model->nv);
}

static void bias_efforts(const double *state, double *result) {
    take_state(state);
    mj_kinematics(model, data);
    mj_comPos(model, data);
    mj_comVel(model, data);
    mj_rne(model, data, 0, result);
}

static void inertias(const double *state) {
    take_coordinates(state);
    mj_kinematics(model, data);
    mj_comPos(model, data);
    mj_makeM(model, data);
}

static void mass_matrix(const double *state, double *result) {
    inertias(state);
    mj_fullM(model, data, result);
}

static void inverse_mass_matrix(const double *state, double *result) {
    inertias(state);
    mj_factorM(model, data);
    mj_solveM(model, data, result, identity, model->nv);
}

static void jacobian(const double *state, double *result) {
    take_coordinates(state);
    mj_kinematics(model, data);
    mj_comPos(model, data);
    mj_jacSite(model, data, result, result + 3 * model->nv, 0);
}

static void derivatives(const double *state, double *result) {
    take_accelerations(state);
    int square = model->nv * model->nv;
    mjd_inverseFD(
        model, data, difference, 0, result, result + square, result + 2 * square, NULL, NULL, NULL, NULL
    );
}

static void linearize(const double *state, double *result) {
    take_efforts(state);
    mjd_transitionFD(model, data, difference, 0, result, NULL, NULL, NULL);
}

int main(int count, char **arguments) {
    if (count != 6) fail("contender MODEL WHAT STATES RESULTS MILLISECONDS");
    model = mj_loadModel(arguments[1], NULL);
    if (!model) fail("cannot read the model");
    model->opt.integrator = mjINT_EULER;
    data = mj_makeData(model);
    size_t n = (size_t)model->nv;
    places = places_of((size_t)model->nq, n);
    state_numbers = places.all;
    identity = numbers(n * n);
    mju_zero(identity, (int)(n * n));
    for (size_t i = 0; i < n; i++) identity[i * n + i] = 1;

    const struct {
        const char *name;
        void (*evaluate)(const double *state, double *result);
        size_t results;
    } questions[] = {
        {"accelerations", accelerations, n},
        {"inverse_dynamics", inverse_dynamics, n},
        {"bias_efforts", bias_efforts, n},
        {"mass_matrix", mass_matrix, n * n},
        {"inverse_mass_matrix", inverse_mass_matrix, n * n},
        {"jacobian", jacobian, 6 * n},
        {"derivatives", derivatives, 3 * n * n},
        {"linearize", linearize, 4 * n * n},
    };
    for (size_t i = 0; i < sizeof questions / sizeof *questions; i++) {
        if (strcmp(questions[i].name, arguments[2])) continue;
        evaluate = questions[i].evaluate;
        result_numbers = questions[i].results;
        return contend(arguments + 3);
    }
    fail("no such question");
}
