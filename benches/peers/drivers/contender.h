// The common part of all contenders in C and C++: they read states, evaluate each state once, write the
// results, and then time batches of evaluations. See the README.
//
// A contender includes this file, defines the items declared first, and calls `contend`.
#pragma once

#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

// The number of states that are evaluated at once, with interleaved numbers.
#ifndef LANES
#define LANES 1
#endif

// The numbers of values of a state and of results.
static size_t state_numbers, result_numbers;
// Evaluates `LANES` states; may be a macro.
#ifndef EVALUATE
#define EVALUATE evaluate
static void evaluate(const double *state, double *result);
#endif

// Converts a state after it is read, and a result before it is written. May be macros; not with several
// lanes.
#ifndef PREPARE
#define PREPARE(state) (void)(state)
#define FINISH(state, result) (void)(result)
#endif

static void fail(const char *message) {
    fprintf(stderr, "%s\n", message);
    exit(1);
}

static uint64_t now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (uint64_t)time.tv_sec * 1000000000u + (uint64_t)time.tv_nsec;
}

// Allocates memory for a number of values, in whole cache lines.
static double *numbers(size_t count) {
    double *place = (double *)aligned_alloc(64, (count * sizeof(double) + 63) / 64 * 64);
    if (!place) fail("out of memory");
    return place;
}

struct states {
    double *all;
    // Groups of `LANES`.
    size_t groups;
};

static struct states read_states(const char *path) {
    FILE *file = fopen(path, "rb");
    if (!file) fail("cannot read the states");
    fseek(file, 0, SEEK_END);
    size_t count = (size_t)ftell(file) / sizeof(double) / state_numbers;
    rewind(file);
    double *read = numbers(count * state_numbers), *all = numbers(count * state_numbers);
    if (fread(read, sizeof(double) * state_numbers, count, file) != count) fail("states are cut off");
    fclose(file);
    for (size_t state = 0; state < count; state++)
        for (size_t i = 0; i < state_numbers; i++)
            all[(state / LANES * state_numbers + i) * LANES + state % LANES] =
                read[state * state_numbers + i];
    free(read);
    for (size_t state = 0; state < count; state++) PREPARE(all + state * state_numbers);
    struct states states = {all, count / LANES};
    return states;
}

static void write_results(const char *path, struct states states, double *result) {
    FILE *file = fopen(path, "wb");
    if (!file) fail("cannot write the results");
    for (size_t group = 0; group < states.groups; group++) {
        const double *state = states.all + group * state_numbers * LANES;
        EVALUATE(state, result);
        FINISH(state, result);
        for (size_t lane = 0; lane < LANES; lane++)
            for (size_t i = 0; i < result_numbers; i++)
                fwrite(result + i * LANES + lane, sizeof(double), 1, file);
    }
    fclose(file);
}

// Evaluates a number of groups of states, cyclically from `*group`, and returns the time in ns.
static uint64_t batch(struct states states, size_t *group, size_t count, double *result) {
    uint64_t start = now();
    for (size_t i = 0; i < count; i++) {
        EVALUATE(states.all + *group * state_numbers * LANES, result);
        // Forces the compiler to compute the result, and hides it from the next evaluation.
        __asm__ volatile("" : : "r"(result) : "memory");
        *group = *group + 1 == states.groups ? 0 : *group + 1;
    }
    return now() - start;
}

// `states`, `results` and `milliseconds` are the last arguments of every contender; `-` means no results.
static int contend(char **arguments) {
    struct states states = read_states(arguments[0]);
    double *result = numbers(result_numbers * LANES);
    if (strcmp(arguments[1], "-")) write_results(arguments[1], states, result);
    uint64_t budget = (uint64_t)atoll(arguments[2]) * 1000000u;

    // Warms up the processor before timing.
    size_t group = 0, count = 1;
    for (uint64_t start = now(); now() - start < 5000000u;) batch(states, &group, 1, result);
    while (batch(states, &group, count, result) < 200000u) count *= 2;
    printf("{\"evaluations\": %zu, \"nanoseconds\": [", count * LANES);
    uint64_t start = now();
    printf("%llu", (unsigned long long)batch(states, &group, count, result));
    while (now() - start < budget)
        printf(", %llu", (unsigned long long)batch(states, &group, count, result));
    printf("]}\n");
    return 0;
}
