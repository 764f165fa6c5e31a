// CasADi's code of one answer of one case, which `answers/casadi_code.py` writes to `core.h`:
//
//     contender STATES RESULTS MILLISECONDS
//
// VECTOR_TRIGONOMETRY: vector functions for all angles of a state.
typedef double real;

// CasADi's square; its arguments are variables.
#define casadi_sq(x) ((x) * (x))

#include "contender.h"

#include "answers.h"
#include "core.h"

#include "trigonometry.h"

static struct places places;

static void evaluate(const double *state, double *result) {
    double sines[PINS + 1], cosines[PINS + 1];
#if PINS > 0
    sines_and_cosines(state + BASE, sines, cosines);
#endif
    core(
        state, state + places.rates, state + places.efforts, state + places.accelerations,
        state + places.direction, state + places.weights, sines, cosines, result
    );
}

int main(int count, char **arguments) {
    if (count != 4) fail("contender STATES RESULTS MILLISECONDS");
    places = places_of(COORDINATES, RATES);
    state_numbers = places.all;
    result_numbers = RESULTS;
    return contend(arguments + 1);
}
