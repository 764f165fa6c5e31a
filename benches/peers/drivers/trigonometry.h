// Sines and cosines of all angles of a state; after `core.h`, which defines PINS.
#pragma once

#include <math.h>

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
