// MuJoCo on a model of any chain:
//
//     contender MODEL WHAT STATES RESULTS MILLISECONDS
//
// MODEL is a compiled model; WHAT is `accelerations`, `all` or `rk4`.
#define EVALUATE evaluate
static void (*evaluate)(const double *state, double *result);
#include "contender.h"

#include <mujoco/mujoco.h>

static mjModel *model;
static mjData *data;

static void take_state(const double *state) {
    mju_copy(data->qpos, state, model->nq);
    mju_copy(data->qvel, state + model->nq, model->nv);
    mju_copy(data->qfrc_applied, state + model->nq + model->nv, model->nv);
}

static void accelerations(const double *state, double *result) {
    take_state(state);
    mj_forward(model, data);
    mju_copy(result, data->qacc, model->nv);
}

// Also computes the wrench in every hinge, in `data->cfrc_int`.
static void all(const double *state, double *result) {
    accelerations(state, result);
    mj_rnePostConstraint(model, data);
}

static void rk4(const double *state, double *result) {
    take_state(state);
    mj_step(model, data);
    mju_copy(result, data->qvel, model->nv);
}

int main(int count, char **arguments) {
    if (count != 6) fail("contender MODEL WHAT STATES RESULTS MILLISECONDS");
    model = mj_loadModel(arguments[1], NULL);
    if (!model) fail("cannot read the model");
    data = mj_makeData(model);
    const char *what = arguments[2];
    evaluate = !strcmp(what, "accelerations") ? accelerations : !strcmp(what, "all") ? all : rk4;
    state_numbers = (size_t)(model->nq + 2 * model->nv);
    result_numbers = (size_t)model->nv;
    return contend(arguments + 3);
}
