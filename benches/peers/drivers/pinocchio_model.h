// A model of Pinocchio from the text of `models.py`, and the conversion of states; after `contender.h`.
#pragma once

#include <cstring>
#include <fstream>
#include <string>

#include <pinocchio/multibody.hpp>

namespace pin = pinocchio;

static pin::Model model;

static void read_model(std::ifstream &file) {
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

// Converts coordinates and rates of a state. Quaternions are x, y, z, w here; the velocity of a floating
// base has its axes.
static void take_coordinates(double *state) {
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
