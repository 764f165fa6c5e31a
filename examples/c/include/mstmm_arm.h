/*
 * An arm with three motors, and a payload that swings on a ball below its end:
 *
 *     ground -> pin waist -> column -> pin shoulder -> upper arm
 *            -> pin elbow -> forearm -> ball hook -> payload
 *
 * The library has no memory of its own, allocates none, and calls nothing but the like of memcpy.
 * Every function may be called from an interrupt or a thread, if no other call writes to what it
 * is given.
 *
 * Units are SI: m, kg, s, rad, N. Frames are right-handed. The inertial frame has its origin at the
 * waist and z upward; where nothing else is said, vectors are along its axes.
 *
 * Pointers must be null, which is answered with MSTMM_NULL_POINTER, or lead to a struct of their
 * type; no two pointers of one call may lead to the same memory. What fails leaves parameters,
 * state and results as they were.
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

/* The numbers that everything is computed in. */
typedef float mstmm_real;

/* How many there are of each. */
enum {
    MSTMM_ARM_COORDINATES = 7,
    MSTMM_ARM_RATES = 6,
    MSTMM_ARM_MOTORS = 3,
    MSTMM_ARM_POINTS = 9
};

/* The hinges. Each number is also the place of a hinge among the torques, and that of its first
 * coordinate and of its first rate. */
enum {
    MSTMM_ARM_WAIST,    /* pin about z, upward */
    MSTMM_ARM_SHOULDER, /* pin about y; a positive angle lowers the upper arm */
    MSTMM_ARM_ELBOW,    /* pin about y; a positive angle lowers the forearm */
    MSTMM_ARM_HOOK      /* ball */
};

/* The connection points: the ground, which is the input of the waist, then the output of each
 * hinge and body. The input of one is the output of the one before it. */
enum {
    MSTMM_ARM_AT_GROUND,
    MSTMM_ARM_AT_WAIST,
    MSTMM_ARM_AT_COLUMN,
    MSTMM_ARM_AT_SHOULDER,
    MSTMM_ARM_AT_UPPER_ARM,
    MSTMM_ARM_AT_ELBOW,
    MSTMM_ARM_AT_FOREARM,
    MSTMM_ARM_AT_HOOK,
    MSTMM_ARM_AT_PAYLOAD /* its lower end, the tip */
};

/* How a call went. */
enum {
    MSTMM_OK,
    MSTMM_NULL_POINTER,
    MSTMM_NOT_FINITE, /* a number of the state or of the inputs, or what would come of them */
    MSTMM_SINGULAR,   /* nothing beyond a hinge has inertia in this state */
    MSTMM_PARAMETER,  /* a parameter cannot have this value */
    MSTMM_OTHER       /* nothing that this arm can come to */
};

typedef struct mstmm_status {
    int32_t code;  /* MSTMM_OK or what went wrong */
    int32_t hinge; /* which one, with MSTMM_SINGULAR; -1 otherwise */
} mstmm_status;

/* The arm with its parameters, and its integrator. What is in it is the library's; it may be
 * copied by assignment. */
typedef struct mstmm_arm {
    mstmm_real numbers[59];
} mstmm_arm;

typedef struct mstmm_arm_state {
    /* Angles of the pins in rad; of the hook, the unit quaternion w, x, y, z that turns components
     * in the payload's frame into those in the forearm's. */
    mstmm_real q[MSTMM_ARM_COORDINATES];
    /* Rates of the pins in rad/s; of the hook, the angular velocity of the payload against the
     * forearm, in the payload's frame. */
    mstmm_real v[MSTMM_ARM_RATES];
    /* Time in s. */
    mstmm_real t;
} mstmm_arm_state;

typedef struct mstmm_arm_inputs {
    /* Torques of the motors in N m: a positive one drives its rate up. */
    mstmm_real torque[MSTMM_ARM_MOTORS];
} mstmm_arm_inputs;

/* A connection point and the frame that moves with it. */
typedef struct mstmm_point {
    mstmm_real position[3];             /* m */
    mstmm_real orientation[3][3];       /* rows of the rotation matrix; turns components in the
                                         * point's frame into inertial ones */
    mstmm_real velocity[3];             /* m/s */
    mstmm_real angular_velocity[3];     /* rad/s */
    mstmm_real acceleration[3];         /* m/s^2, the true one: at rest there is none */
    mstmm_real angular_acceleration[3]; /* rad/s^2 */
    mstmm_real moment[3];               /* N m, on the part before the point; the one on the part
                                         * behind it is the opposite */
    mstmm_real force[3];                /* N, on the part behind the point; the one on the part
                                         * before it is the opposite */
} mstmm_point;

typedef struct mstmm_arm_results {
    mstmm_real accelerations[MSTMM_ARM_RATES]; /* time derivatives of the rates, rad/s^2 */
    mstmm_real kinetic_energy;                 /* J */
    mstmm_real potential_energy;               /* J, of gravity; zero with all masses at z = 0 */
    mstmm_point points[MSTMM_ARM_POINTS];
} mstmm_arm_results;

/* Makes an arm with a payload of 2 kg, to be stepped by `step` seconds; a negative step goes back
 * in time. Must come first: nothing else may be called with an arm that was not made.
 *
 * MSTMM_NOT_FINITE if the step is NaN or infinite. */
mstmm_status mstmm_arm_init(mstmm_arm *arm, mstmm_real step);

/* Writes where the arm starts: at rest at time zero, the upper arm raised by 45 degrees, the
 * forearm lowered by 45 degrees, the payload hanging straight down. */
mstmm_status mstmm_arm_initial_state(const mstmm_arm *arm, mstmm_arm_state *state);

/* Sets the payload's mass in kg; its inertia about its centre of mass stays.
 *
 * MSTMM_PARAMETER if the mass is not positive or not finite. */
mstmm_status mstmm_arm_set_payload_mass(mstmm_arm *arm, mstmm_real mass);

/* Sets the payload's moment of inertia about its own z in kg m^2, which is 0.01 at first. Where it
 * drowns in the rounding of the others the payload is a thin rod, and then the hook is
 * MSTMM_SINGULAR: nothing says how the rod turns about itself.
 *
 * MSTMM_PARAMETER if the moment is not positive or not finite. */
mstmm_status mstmm_arm_set_payload_spin(mstmm_arm *arm, mstmm_real moment);

/* Takes the state one step further by the classical Runge-Kutta method of order four, with the same
 * torques during the whole step. The quaternion comes out of unit length. Always takes the same
 * number of operations.
 *
 * MSTMM_NOT_FINITE, MSTMM_SINGULAR; the state is left as it was. */
mstmm_status mstmm_arm_step(mstmm_arm *arm, mstmm_arm_state *state, const mstmm_arm_inputs *inputs);

/* Computes accelerations, energies, and motion and load at every connection point, in this state
 * and with these torques. The quaternion must be of unit length up to rounding.
 *
 * MSTMM_NOT_FINITE, MSTMM_SINGULAR; the results are left as they were. */
mstmm_status mstmm_arm_solve(const mstmm_arm *arm, const mstmm_arm_state *state,
                             const mstmm_arm_inputs *inputs, mstmm_arm_results *results);

/* sizeof(mstmm_arm) as the library has it: to ask once, whether header and library belong
 * together. */
uint32_t mstmm_arm_size(void);

/* The name of a code, such as "MSTMM_SINGULAR"; "" if there is none of this number. */
const char *mstmm_code_name(int32_t code);

/* The name of a hinge, such as "elbow"; "" if there is none of this number. */
const char *mstmm_arm_hinge_name(int32_t hinge);

/* The library states the same sizes. */
static_assert(sizeof(mstmm_status) == 8, "mstmm_status");
static_assert(sizeof(mstmm_arm) == 59 * sizeof(mstmm_real), "mstmm_arm");
static_assert(sizeof(mstmm_arm_state) == 14 * sizeof(mstmm_real), "mstmm_arm_state");
static_assert(sizeof(mstmm_arm_inputs) == 3 * sizeof(mstmm_real), "mstmm_arm_inputs");
static_assert(sizeof(mstmm_point) == 30 * sizeof(mstmm_real), "mstmm_point");
static_assert(sizeof(mstmm_arm_results) == 278 * sizeof(mstmm_real), "mstmm_arm_results");

#ifdef __cplusplus
}
#endif

#endif
