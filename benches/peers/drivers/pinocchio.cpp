// Pinocchio's articulated-body algorithm on a model of any chain or tree:
//
//     contender MODEL WHAT STATES RESULTS MILLISECONDS
//
// MODEL is a text file written by `models.py`; WHAT is `accelerations`, `all` or `rk4`.
#include <fstream>
#include <string>

#include <pinocchio/multibody.hpp>
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

namespace pin = pinocchio;
using Vector = Eigen::VectorXd;
using Given = Eigen::Map<const Vector>;

static pin::Model model;
static pin::Data *data;
static const double step = 1e-3;

static void read_model(const char *path) {
    std::ifstream file(path);
    size_t bodies;
    Eigen::Vector3d gravity;
    file >> bodies >> gravity[0] >> gravity[1] >> gravity[2];
    model.gravity.linear(gravity);
    for (size_t index = 0; index < bodies; index++) {
        std::string hinge;
        Eigen::Vector3d position, com;
        Eigen::Matrix3d rotation, inertia;
        double mass;
        pin::JointIndex parent;
        file >> hinge >> parent;
        for (int i = 0; i < 3; i++) file >> position[i];
        for (int i = 0; i < 9; i++) file >> rotation(i / 3, i % 3);
        file >> mass;
        for (int i = 0; i < 3; i++) file >> com[i];
        for (int i = 0; i < 9; i++) file >> inertia(i / 3, i % 3);
        if (!file) fail("cannot read the model");
        pin::JointModel joint;
        if (hinge == "x") joint = pin::JointModelRX();
        if (hinge == "y") joint = pin::JointModelRY();
        if (hinge == "z") joint = pin::JointModelRZ();
        if (hinge == "ball") joint = pin::JointModelSpherical();
        if (hinge == "floating") joint = pin::JointModelFreeFlyer();
        auto own = model.addJoint(parent, joint, pin::SE3(rotation, position), std::to_string(index));
        model.appendBodyToJoint(own, pin::Inertia(mass, com, inertia));
    }
}

static bool is_floating() { return model.joints[1].shortname() == "JointModelFreeFlyer"; }

// Quaternions are x, y, z, w here; the velocity of a floating base has its axes.
static void prepare(double *state) {
    if (model.nq == model.nv) return;
    bool floats = is_floating();
    for (int i = floats ? 3 : 0; i < (floats ? 7 : model.nq); i += 4) {
        double w = state[i];
        memmove(state + i, state + i + 1, 3 * sizeof(double));
        state[i + 3] = w;
    }
    if (!floats) return;
    Eigen::Map<Eigen::Vector3d> velocity(state + model.nq);
    velocity = Eigen::Map<const Eigen::Quaterniond>(state + 3).inverse() * velocity;
}

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
    read_model(arguments[1]);
    data = new pin::Data(model);
    std::string what = arguments[2];
    evaluate = what == "accelerations" ? accelerations : what == "all" ? all : rk4;
    state_numbers = (size_t)(model.nq + 2 * model.nv);
    result_numbers = (size_t)model.nv;
    return contend(arguments + 3);
}
