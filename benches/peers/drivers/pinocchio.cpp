// Pinocchio's articulated-body algorithm on a model of any chain:
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
    pin::JointIndex before = 0;
    for (size_t index = 0; index < bodies; index++) {
        std::string hinge;
        Eigen::Vector3d position, com;
        Eigen::Matrix3d rotation, inertia;
        double mass;
        file >> hinge;
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
        before = model.addJoint(before, joint, pin::SE3(rotation, position), std::to_string(index));
        model.appendBodyToJoint(before, pin::Inertia(mass, com, inertia));
    }
}

// The coordinates, with quaternions in Pinocchio's order.
static Vector coordinates;

static void take_coordinates(const double *state) {
    if (model.nq == model.nv) {
        coordinates = Given(state, model.nq);
        return;
    }
    for (int i = 0; i < model.nq; i += 4) {
        coordinates.segment<3>(i) = Eigen::Map<const Eigen::Vector3d>(state + i + 1);
        coordinates[i + 3] = state[i];
    }
}

static void accelerations(const double *state, double *result) {
    take_coordinates(state);
    Given v(state + model.nq, model.nv), torques(state + model.nq + model.nv, model.nv);
    pin::aba(model, *data, coordinates, v, torques);
    Eigen::Map<Vector>(result, model.nv) = data->ddq;
}

// Also computes the wrench in every hinge, which `rnea` stores in `data->f`.
static void all(const double *state, double *result) {
    accelerations(state, result);
    Given v(state + model.nq, model.nv);
    pin::rnea(model, *data, coordinates, v, data->ddq);
}

static void rk4(const double *state, double *result) {
    static Vector q, v, speeds[4], accelerations[4];
    take_coordinates(state);
    q = coordinates;
    v = Given(state + model.nq, model.nv);
    Given torques(state + model.nq + model.nv, model.nv);
    const double way[] = {0.5 * step, 0.5 * step, step};
    speeds[0] = v;
    for (int stage = 0;; stage++) {
        accelerations[stage] = pin::aba(model, *data, q, speeds[stage], torques);
        if (stage == 3) break;
        pin::integrate(model, coordinates, way[stage] * speeds[stage], q);
        speeds[stage + 1] = v + way[stage] * accelerations[stage];
    }
    speeds[0] += 2 * speeds[1] + 2 * speeds[2] + speeds[3];
    accelerations[0] += 2 * accelerations[1] + 2 * accelerations[2] + accelerations[3];
    pin::integrate(model, coordinates, step / 6 * speeds[0], q);
    v += step / 6 * accelerations[0];
    Eigen::Map<Vector>(result, model.nv) = v;
}

int main(int count, char **arguments) {
    if (count != 6) fail("contender MODEL WHAT STATES RESULTS MILLISECONDS");
    read_model(arguments[1]);
    data = new pin::Data(model);
    coordinates = Vector::Zero(model.nq);
    std::string what = arguments[2];
    evaluate = what == "accelerations" ? accelerations : what == "all" ? all : rk4;
    state_numbers = (size_t)(model.nq + 2 * model.nv);
    result_numbers = (size_t)model.nv;
    return contend(arguments + 3);
}
