// Pinocchio's articulated-body algorithm on a model of any chain or tree:
//
//     contender MODEL WHAT STATES RESULTS MILLISECONDS
//
// MODEL is a text file written by `models.py`; WHAT is `accelerations`, `all` or `rk4`.
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <pinocchio/algorithm/rnea.hpp>

#define EVALUATE evaluate
static void (*evaluate)(const double *state, double *result);
// Pinocchio has other coordinates, rates and accelerations of balls and floating bases.
#define PREPARE prepare
#define FINISH finish
static void prepare(double *state);
static void finish(const double *state, double *result);
#include "contender.h"

#include "pinocchio_model.h"

using Vector = Eigen::VectorXd;
using Given = Eigen::Map<const Vector>;

static pin::Data *data;
static const double step = 1e-3;

static void prepare(double *state) { take_coordinates(state); }

// The acceleration of a floating base is spatial: it lacks ω × v, and it has the base's axes.
static void finish(const double *state, double *result) {
    if (!is_floating()) return;
    Eigen::Map<const Eigen::Vector3d> velocity(state + model.nq), omega(state + model.nq + 3);
    Eigen::Map<Eigen::Vector3d> acceleration(result);
    acceleration += omega.cross(velocity);
    acceleration = Eigen::Map<const Eigen::Quaterniond>(state + 3) * acceleration;
}

static void accelerations(const double *state, double *result) {
    Given q(state, model.nq), v(state + model.nq, model.nv), torques(state + model.nq + model.nv, model.nv);
    pin::aba(model, *data, q, v, torques);
    Eigen::Map<Vector>(result, model.nv) = data->ddq;
}

// Also computes the wrench in every hinge, which `rnea` stores in `data->f`.
static void all(const double *state, double *result) {
    accelerations(state, result);
    pin::rnea(model, *data, Given(state, model.nq), Given(state + model.nq, model.nv), data->ddq);
}

static void rk4(const double *state, double *result) {
    static Vector q, v, speeds[4], accelerations[4];
    Given start(state, model.nq), torques(state + model.nq + model.nv, model.nv);
    q = start;
    v = Given(state + model.nq, model.nv);
    const double way[] = {0.5 * step, 0.5 * step, step};
    speeds[0] = v;
    for (int stage = 0;; stage++) {
        accelerations[stage] = pin::aba(model, *data, q, speeds[stage], torques);
        if (stage == 3) break;
        pin::integrate(model, start, way[stage] * speeds[stage], q);
        speeds[stage + 1] = v + way[stage] * accelerations[stage];
    }
    speeds[0] += 2 * speeds[1] + 2 * speeds[2] + speeds[3];
    accelerations[0] += 2 * accelerations[1] + 2 * accelerations[2] + accelerations[3];
    pin::integrate(model, start, step / 6 * speeds[0], q);
    v += step / 6 * accelerations[0];
    Eigen::Map<Vector>(result, model.nv) = v;
}

int main(int count, char **arguments) {
    if (count != 6) fail("contender MODEL WHAT STATES RESULTS MILLISECONDS");
    std::ifstream file(arguments[1]);
    read_model(file);
    data = new pin::Data(model);
    std::string what = arguments[2];
    evaluate = what == "accelerations" ? accelerations : what == "all" ? all : rk4;
    state_numbers = (size_t)(model.nq + 2 * model.nv);
    result_numbers = (size_t)model.nv;
    return contend(arguments + 3);
}
