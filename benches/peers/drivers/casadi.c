// CasADi's code of one case, which `casadi_code.py` writes to `core.h`; compiled once for each variant:
//
//     contender STATES RESULTS MILLISECONDS
//
// WIDE: eight states at a time. VECTOR_TRIGONOMETRY: all angles of a state side by side.
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
// glibc's vector functions, by their names in its ABI; exact to 4 units in the last place.
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
    // Of all lanes, or of all angles: as they lie in memory, the last ones beyond the end.
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

static void evaluate(const double *state, double *result) {
    const real *q = (const real *)state, *v = q + COORDINATES, *torques = v + RATES;
#if PINS > 0
    real sines[PINS], cosines[PINS];
    sines_and_cosines(q, sines, cosines);
    core(sines, cosines, v, torques, (real *)result);
#else
    core(q, v, torques, (real *)result);
#endif
}

int main(int count, char **arguments) {
    if (count != 4) fail("contender STATES RESULTS MILLISECONDS");
    state_numbers = COORDINATES + 2 * RATES;
    result_numbers = RESULTS;
    return contend(arguments + 1);
}
