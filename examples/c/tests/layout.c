/* Prints sizes and offsets of the structs of the header, to be compared with the library's. */
#include <stddef.h>
#include <stdio.h>

#include "mstmm_arm.h"

#define SIZE(type) printf(#type " %zu\n", sizeof(type))
#define FIELD(type, field) printf(#type "." #field " %zu\n", offsetof(type, field))

int main(void)
{
    SIZE(mstmm_status);
    FIELD(mstmm_status, code);
    FIELD(mstmm_status, hinge);
    SIZE(mstmm_arm);
    SIZE(mstmm_arm_state);
    FIELD(mstmm_arm_state, q);
    FIELD(mstmm_arm_state, v);
    FIELD(mstmm_arm_state, t);
    SIZE(mstmm_arm_inputs);
    FIELD(mstmm_arm_inputs, torque);
    SIZE(mstmm_point);
    FIELD(mstmm_point, position);
    FIELD(mstmm_point, orientation);
    FIELD(mstmm_point, velocity);
    FIELD(mstmm_point, angular_velocity);
    FIELD(mstmm_point, acceleration);
    FIELD(mstmm_point, angular_acceleration);
    FIELD(mstmm_point, moment);
    FIELD(mstmm_point, force);
    SIZE(mstmm_arm_results);
    FIELD(mstmm_arm_results, accelerations);
    FIELD(mstmm_arm_results, kinetic_energy);
    FIELD(mstmm_arm_results, potential_energy);
    FIELD(mstmm_arm_results, points);
    return 0;
}
