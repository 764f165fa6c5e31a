// CasADi's code of one case, which `casadi_code.py` writes to `core.h`; compiled once for each variant:
//
//     contender STATES RESULTS MILLISECONDS
//
// WIDE: eight states at a time. VECTOR_TRIGONOMETRY: vector functions for all angles of a state. RK4: a
// step of the classical Runge–Kutta method.
#ifdef WIDE
#define LANES 8
typedef double real __attribute__((ext_vector_type(8)));
#else
typedef double real;
#endif

#include "contender.h"
#include "core.h"
#include "trigonometry.h"

static inline void accelerations(const real *q, const real *v, const real *torques, real *result) {
#if PINS > 0
    real sines[PINS], cosines[PINS];
    sines_and_cosines(q + BASE, sines, cosines);
#if BASE > 0
    core(q, sines, cosines, v, torques, result);
#else
    core(sines, cosines, v, torques, result);
#endif
#else
    core(q, v, torques, result);
#endif
}

#ifdef RK4
static const double step = 1e-3;

static inline void coordinate_rates(const real *q, const real *v, real *rates) {
#if PINS > 0
    memcpy(rates, v, sizeof(real) * RATES);
#else
    for (int i = 0; i < COORDINATES / 4; i++, q += 4, v += 3, rates += 4) {
        rates[0] = -0.5 * (q[1] * v[0] + q[2] * v[1] + q[3] * v[2]);
        rates[1] = 0.5 * (q[0] * v[0] + q[2] * v[2] - q[3] * v[1]);
        rates[2] = 0.5 * (q[0] * v[1] + q[3] * v[0] - q[1] * v[2]);
        rates[3] = 0.5 * (q[0] * v[2] + q[1] * v[1] - q[2] * v[0]);
    }
#endif
}

// Coordinates and rates are one array here. The result is the rates; the coordinates are computed, too.
static void evaluate(const double *state, double *result) {
    enum { ALL = COORDINATES + RATES };
    static const double weights[] = {1, 2, 2, 1}, ways[] = {0.5, 0.5, 1};
    real at[ALL], rates[ALL], sums[ALL] = {0};
    memcpy(at, state, sizeof at);
    for (int stage = 0;; stage++) {
        coordinate_rates(at, at + COORDINATES, rates);
        accelerations(at, at + COORDINATES, state + ALL, rates + COORDINATES);
        for (int i = 0; i < ALL; i++) sums[i] += weights[stage] * rates[i];
        if (stage == 3) break;
        for (int i = 0; i < ALL; i++) at[i] = state[i] + ways[stage] * step * rates[i];
    }
    for (int i = 0; i < ALL; i++) at[i] = state[i] + step / 6 * sums[i];
#if PINS == 0
    for (int i = 0; i < COORDINATES; i += 4) {
        real *q = at + i;
        real scale = 1 / sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        for (int j = 0; j < 4; j++) q[j] *= scale;
    }
#endif
    memcpy(result, at + COORDINATES, sizeof(real) * RATES);
    // The coordinates are not used here, but they are part of a step.
    __asm__ volatile("" : : "r"(at) : "memory");
}
#else
static void evaluate(const double *state, double *result) {
    const real *q = (const real *)state, *v = q + COORDINATES;
    accelerations(q, v, v + RATES, (real *)result);
}
#endif

int main(int count, char **arguments) {
    if (count != 4) fail("contender STATES RESULTS MILLISECONDS");
    state_numbers = COORDINATES + 2 * RATES;
    result_numbers = RESULTS;
    return contend(arguments + 1);
}
