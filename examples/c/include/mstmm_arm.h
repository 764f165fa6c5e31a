/*
 * An arm with three motors, a payload that swings on a ball below its end, and a camera on a spring
 * beside its column:
 *
 *     ground -> pin waist -> column -> pin shoulder -> upper arm
 *            -> pin elbow -> forearm -> ball hook -> payload
 *     column's mast -> pin mount -> camera
 *
 * The library has no static memory, does not allocate, and calls only functions like memcpy. Every
 * function may be called from an interrupt or a thread if no other call writes to its arguments.
 *
 * Units are SI: m, kg, s, rad, N. Frames are right-handed. The inertial frame has its origin at the
 * waist and z upward; vectors have inertial components unless stated otherwise.
 *
 * A pointer must point to a struct of its type or be null, which returns MSTMM_NULL_POINTER; two
 * pointers of one call must not point to the same memory. A call that fails leaves parameters, state
 * and results unchanged.
 *
 * C11, or C++11.
 */
#ifndef MSTMM_ARM_H
#define MSTMM_ARM_H

#include <assert.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The scalar of all computations. */
typedef float mstmm_real;

/* The number of each. */
enum {
    MSTMM_ARM_COORDINATES = 8,
    MSTMM_ARM_RATES = 7,
    MSTMM_ARM_MOTORS = 3,
    MSTMM_ARM_POINTS = 12
};

/* The hinges. Up to the hook, each number is also the index of the hinge's torque, of its first
 * coordinate and of its first rate. The mount has the last coordinate and the last rate. */
enum {
    MSTMM_ARM_WAIST,    /* pin about z, upward */
    MSTMM_ARM_SHOULDER, /* pin about y; a positive angle lowers the upper arm */
    MSTMM_ARM_ELBOW,    /* pin about y; a positive angle lowers the forearm */
    MSTMM_ARM_HOOK,     /* ball */
    MSTMM_ARM_MOUNT     /* pin about x, with a spring */
};

/* The connection points: the ground, which is the input of the waist, then the output of each
 * hinge and body. The input of an element is the output of the previous element; that of the mount is
 * the mast. */
enum {
    MSTMM_ARM_AT_GROUND,
    MSTMM_ARM_AT_WAIST,
    MSTMM_ARM_AT_COLUMN,
    MSTMM_ARM_AT_MAST, /* a point of the column */
    MSTMM_ARM_AT_SHOULDER,
    MSTMM_ARM_AT_UPPER_ARM,
    MSTMM_ARM_AT_ELBOW,
    MSTMM_ARM_AT_FOREARM,
    MSTMM_ARM_AT_HOOK,
    MSTMM_ARM_AT_PAYLOAD, /* its lower end, the tip */
    MSTMM_ARM_AT_MOUNT,
    MSTMM_ARM_AT_CAMERA /* its lens */
};

/* The codes of a status. */
enum {
    MSTMM_OK,
    MSTMM_NULL_POINTER,
    MSTMM_NOT_FINITE, /* a number of the state, the inputs or the results is not finite */
    MSTMM_SINGULAR,   /* the bodies outboard of a hinge have no inertia in this state */
    MSTMM_PARAMETER,  /* a parameter cannot have this value */
    MSTMM_OTHER       /* any other error; does not occur for this arm */
};

typedef struct mstmm_status {
    int32_t code;  /* MSTMM_OK or an error */
    int32_t hinge; /* the hinge of MSTMM_SINGULAR; -1 otherwise */
} mstmm_status;

/* The arm with its parameters and its integrator. The contents are private; it may be copied by
 * assignment. */
typedef struct mstmm_arm {
    mstmm_real numbers[65];
} mstmm_arm;

typedef struct mstmm_arm_state {
    /* Angles of the pins in rad; of the hook, the unit quaternion w, x, y, z of the rotation from
     * components in the payload's frame to components in the forearm's frame. Last, the angle of the
     * mount in rad. */
    mstmm_real q[MSTMM_ARM_COORDINATES];
    /* Rates of the pins in rad/s; of the hook, the angular velocity of the payload relative to the
     * forearm, in the payload's frame. Last, the rate of the mount in rad/s. */
    mstmm_real v[MSTMM_ARM_RATES];
    /* Time in s. */
    mstmm_real t;
} mstmm_arm_state;

typedef struct mstmm_arm_inputs {
    /* Torques of the motors in N m: a positive torque increases its rate. */
    mstmm_real torque[MSTMM_ARM_MOTORS];
} mstmm_arm_inputs;

/* A connection point and the frame that moves with it. */
typedef struct mstmm_point {
    mstmm_real position[3];             /* m */
    mstmm_real orientation[3][3];       /* rows of the rotation matrix from components in the
                                         * point's frame to inertial components */
    mstmm_real velocity[3];             /* m/s */
    mstmm_real angular_velocity[3];     /* rad/s */
    mstmm_real acceleration[3];         /* m/s^2, relative to the inertial frame: zero at rest */
    mstmm_real angular_acceleration[3]; /* rad/s^2 */
    mstmm_real moment[3];               /* N m, acts on the part inboard of the point; its opposite
                                         * acts on the part outboard of the point */
    mstmm_real force[3];                /* N, acts on the part outboard of the point; its opposite
                                         * acts on the part inboard of the point */
} mstmm_point;

typedef struct mstmm_arm_results {
    mstmm_real accelerations[MSTMM_ARM_RATES]; /* time derivatives of the rates, rad/s^2 */
    mstmm_real kinetic_energy;                 /* J */
    mstmm_real potential_energy;               /* J, of gravity; zero with all masses at z = 0 */
    mstmm_point points[MSTMM_ARM_POINTS];
} mstmm_arm_results;

/* Initialises an arm with a payload of 2 kg and a step of `step` seconds; a negative step goes back
 * in time. Must be called before any other function with this arm.
 *
 * MSTMM_NOT_FINITE if the step is NaN or infinite. */
mstmm_status mstmm_arm_init(mstmm_arm *arm, mstmm_real step);

/* Writes the start of the arm: at rest at time zero, the upper arm raised by 45 degrees, the
 * forearm lowered by 45 degrees, the payload hanging straight down. */
mstmm_status mstmm_arm_initial_state(const mstmm_arm *arm, mstmm_arm_state *state);

/* Sets the payload's mass in kg; its inertia about its centre of mass does not change.
 *
 * MSTMM_PARAMETER if the mass is not positive or not finite. */
mstmm_status mstmm_arm_set_payload_mass(mstmm_arm *arm, mstmm_real mass);

/* Sets the payload's moment of inertia about its z axis in kg m^2, initially 0.01. If it is below the
 * rounding error of the other moments, the payload is a thin rod, and the hook is MSTMM_SINGULAR: the
 * rotation of a thin rod about its axis is not determined.
 *
 * MSTMM_PARAMETER if the moment is not positive or not finite. */
mstmm_status mstmm_arm_set_payload_spin(mstmm_arm *arm, mstmm_real moment);

/* Takes one step by the classical Runge-Kutta method of order four, with constant torques. The
 * quaternion has unit length afterwards. The number of operations is always the same.
 *
 * MSTMM_NOT_FINITE, MSTMM_SINGULAR; the state is then unchanged. */
mstmm_status mstmm_arm_step(mstmm_arm *arm, mstmm_arm_state *state, const mstmm_arm_inputs *inputs);

/* Computes accelerations, energies, and the motions and loads at all connection points, in this state
 * and with these torques. The quaternion must have unit length up to rounding.
 *
 * MSTMM_NOT_FINITE, MSTMM_SINGULAR; the results are then unchanged. */
mstmm_status mstmm_arm_solve(const mstmm_arm *arm, const mstmm_arm_state *state,
                             const mstmm_arm_inputs *inputs, mstmm_arm_results *results);

/* Returns sizeof(mstmm_arm) of the library, to check that header and library match. */
uint32_t mstmm_arm_size(void);

/* Returns the name of a code, such as "MSTMM_SINGULAR"; "" for an unknown code. */
const char *mstmm_code_name(int32_t code);

/* Returns the name of a hinge, such as "elbow"; "" for an unknown hinge. */
const char *mstmm_arm_hinge_name(int32_t hinge);

/* The library checks the same sizes. */
static_assert(sizeof(mstmm_status) == 8, "mstmm_status");
static_assert(sizeof(mstmm_arm) == 65 * sizeof(mstmm_real), "mstmm_arm");
static_assert(sizeof(mstmm_arm_state) == 16 * sizeof(mstmm_real), "mstmm_arm_state");
static_assert(sizeof(mstmm_arm_inputs) == 3 * sizeof(mstmm_real), "mstmm_arm_inputs");
static_assert(sizeof(mstmm_point) == 30 * sizeof(mstmm_real), "mstmm_point");
static_assert(sizeof(mstmm_arm_results) == 369 * sizeof(mstmm_real), "mstmm_arm_results");

#ifdef __cplusplus
}
#endif

#endif
