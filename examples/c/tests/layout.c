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
    FIELD(mstmm_arm_inputs, u);
    SIZE(mstmm_arm_point);
    FIELD(mstmm_arm_point, position);
    FIELD(mstmm_arm_point, orientation);
    FIELD(mstmm_arm_point, velocity);
    FIELD(mstmm_arm_point, angular_velocity);
    FIELD(mstmm_arm_point, acceleration);
    FIELD(mstmm_arm_point, angular_acceleration);
    FIELD(mstmm_arm_point, moment);
    FIELD(mstmm_arm_point, force);
    SIZE(mstmm_arm_results);
    FIELD(mstmm_arm_results, accelerations);
    FIELD(mstmm_arm_results, kinetic_energy);
    FIELD(mstmm_arm_results, potential_energy);
    FIELD(mstmm_arm_results, points);
    return 0;
}
