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

#include <math.h>

#include "core.h"

#if defined(WIDE) || defined(VECTOR_TRIGONOMETRY)
// glibc's vector functions, by their ABI names; accurate to 4 units in the last place.
#ifdef __AVX512F__
typedef double vector __attribute__((ext_vector_type(8)));
#define SINE _ZGVeN8v_sin
#define COSINE _ZGVeN8v_cos
#else
typedef double vector __attribute__((ext_vector_type(4)));
#define SINE _ZGVdN4v_sin
#define COSINE _ZGVdN4v_cos
#endif
vector SINE(vector);
vector COSINE(vector);
enum { WIDTH = sizeof(vector) / sizeof(double) };
#endif

#if PINS > 0
static inline void sines_and_cosines(const real *angles, real *sines, real *cosines) {
#if defined(WIDE) || defined(VECTOR_TRIGONOMETRY)
    // For all lanes, or for all angles, in the order of memory; the last vector may read beyond the end.
    enum { COUNT = PINS * LANES };
    for (int i = 0; i < COUNT; i += WIDTH) {
        vector angle = 0.0;
        size_t size = sizeof(double) * (COUNT - i < WIDTH ? COUNT - i : WIDTH);
        memcpy(&angle, (const double *)angles + i, size);
        vector sine = SINE(angle), cosine = COSINE(angle);
        memcpy((double *)sines + i, &sine, size);
        memcpy((double *)cosines + i, &cosine, size);
    }
#else
    for (int i = 0; i < PINS; i++) sincos(angles[i], &sines[i], &cosines[i]);
#endif
}
#endif

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
