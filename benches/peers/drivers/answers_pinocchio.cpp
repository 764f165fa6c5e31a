// Pinocchio's algorithms for the answers, on a model of any chain or tree:
//
//     contender MODEL WHAT STATES RESULTS MILLISECONDS
//
// MODEL is a text file written by `models.py`, followed by the index of a body and the position of the tip
// on it. Results stay in Pinocchio's data while the time is taken, and have its conventions.
#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/regressor.hpp>
#include <pinocchio/algorithm/rnea-derivatives.hpp>
#include <pinocchio/algorithm/rnea.hpp>

#define EVALUATE evaluate
static void (*evaluate)(const double *state, double *result);
#define PREPARE prepare
#define FINISH finish
static void prepare(double *state);
static void (*finish)(const double *state, double *result);
#include "contender.h"

#include "pinocchio_model.h"

#include "answers.h"

using Vector = Eigen::VectorXd;
using Given = Eigen::Map<const Vector>;
using Matrix = Eigen::MatrixXd;
using Rows = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

static pin::Data *data;
static pin::FrameIndex tip;
static Matrix jacobian_of_tip;
static struct places places;

static Given coordinates(const double *state) { return Given(state, model.nq); }
static Given rates(const double *state) { return Given(state + places.rates, model.nv); }
static Given efforts(const double *state) { return Given(state + places.efforts, model.nv); }
static Given given_accelerations(const double *state) {
    return Given(state + places.accelerations, model.nv);
}

// The acceleration of a floating base is spatial: it lacks ω × v, and it has the base's axes.
static void prepare(double *state) {
    take_coordinates(state);
    if (!is_floating()) return;
    Eigen::Map<const Eigen::Vector3d> velocity(state + places.rates), omega(state + places.rates + 3);
    Eigen::Map<Eigen::Vector3d> acceleration(state + places.accelerations);
    acceleration = Eigen::Map<const Eigen::Quaterniond>(state + 3).inverse() * acceleration;
    acceleration -= omega.cross(velocity);
}

static double *put(double *place, const Matrix &matrix) {
    Rows(place, matrix.rows(), matrix.cols()) = matrix;
    return place + matrix.size();
}

// Of some matrices only the upper triangle is computed.
template <typename Any> static Matrix whole(const Any &upper) {
    return Matrix(upper).selfadjointView<Eigen::Upper>();
}

struct question {
    const char *name;
    void (*evaluate)(const double *state, double *result);
    void (*finish)(const double *state, double *result);
    // The number of results.
    size_t (*count)(size_t rates);
};

static const struct question questions[] = {
    {"accelerations",
     [](const double *state, double *) {
         pin::aba(model, *data, coordinates(state), rates(state), efforts(state));
     },
     [](const double *, double *result) { put(result, data->ddq); },
     [](size_t n) { return n; }},
    {"inverse_dynamics",
     [](const double *state, double *) {
         pin::rnea(model, *data, coordinates(state), rates(state), given_accelerations(state));
     },
     [](const double *, double *result) { put(result, data->tau); },
     [](size_t n) { return n; }},
    {"bias_efforts",
     [](const double *state, double *) {
         pin::nonLinearEffects(model, *data, coordinates(state), rates(state));
     },
     // Also the mass matrix, by which a floating base's efforts are converted.
     [](const double *state, double *result) {
         result = put(result, data->nle);
         put(result, whole(pin::crba(model, *data, coordinates(state))));
     },
     [](size_t n) { return n + n * n; }},
    {"mass_matrix",
     [](const double *state, double *) { pin::crba(model, *data, coordinates(state)); },
     [](const double *, double *result) { put(result, whole(data->M)); },
     [](size_t n) { return n * n; }},
    {"inverse_mass_matrix",
     [](const double *state, double *) { pin::computeMinverse(model, *data, coordinates(state)); },
     [](const double *, double *result) { put(result, whole(data->Minv)); },
     [](size_t n) { return n * n; }},
    {"coriolis_matrix",
     [](const double *state, double *) {
         pin::computeCoriolisMatrix(model, *data, coordinates(state), rates(state));
     },
     // Also the mass matrix, by which a floating base's columns are converted.
     [](const double *state, double *result) {
         result = put(result, data->C);
         put(result, whole(pin::crba(model, *data, coordinates(state))));
     },
     [](size_t n) { return 2 * n * n; }},
    {"jacobian",
     [](const double *state, double *) {
         auto axes = pin::LOCAL_WORLD_ALIGNED;
         pin::computeFrameJacobian(model, *data, coordinates(state), tip, axes, jacobian_of_tip);
     },
     [](const double *, double *result) { put(result, jacobian_of_tip); },
     [](size_t n) { return 6 * n; }},
    {"regressor",
     [](const double *state, double *) {
         pin::computeJointTorqueRegressor(
             model, *data, coordinates(state), rates(state), given_accelerations(state)
         );
     },
     [](const double *, double *result) { put(result, data->jointTorqueRegressor); },
     [](size_t n) { return n * 10 * (size_t)(model.njoints - 1); }},
    {"derivatives",
     [](const double *state, double *) {
         pin::computeRNEADerivatives(
             model, *data, coordinates(state), rates(state), given_accelerations(state)
         );
     },
     [](const double *, double *result) {
         result = put(put(result, data->dtau_dq), data->dtau_dv);
         put(put(result, whole(data->M)), data->tau);
     },
     [](size_t n) { return 3 * n * n + n; }},
    {"linearize",
     [](const double *state, double *) {
         pin::computeABADerivatives(model, *data, coordinates(state), rates(state), efforts(state));
     },
     [](const double *, double *result) {
         result = put(put(result, data->ddq_dq), data->ddq_dv);
         put(put(result, whole(data->Minv)), data->ddq);
     },
     [](size_t n) { return 3 * n * n + n; }},
};

int main(int count, char **arguments) {
    if (count != 6) fail("contender MODEL WHAT STATES RESULTS MILLISECONDS");
    std::ifstream file(arguments[1]);
    read_model(file);
    Eigen::Vector3d position;
    pin::JointIndex body;
    file >> body;
    for (int i = 0; i < 3; i++) file >> position[i];
    if (!file) fail("cannot read the tip");
    pin::SE3 placement(Eigen::Matrix3d::Identity(), position);
    tip = model.addFrame(pin::Frame("tip", body, placement, pin::OP_FRAME), false);
    jacobian_of_tip.setZero(6, model.nv);
    data = new pin::Data(model);
    places = places_of((size_t)model.nq, (size_t)model.nv);
    state_numbers = places.all;
    for (const auto &question : questions) {
        if (strcmp(question.name, arguments[2])) continue;
        evaluate = question.evaluate;
        finish = question.finish;
        result_numbers = question.count((size_t)model.nv);
        return contend(arguments + 3);
    }
    fail("no such question");
}
