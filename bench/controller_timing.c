/*
 * Steps of an emitted controller or plant with inputs of one kind, for bench/controller.py.
 *
 *     bench CASE STEPS      prints ns per step
 *
 * Inputs are taken in turn from a table, so that loading them costs the same in every case.
 */
#define _POSIX_C_SOURCE 199309L
#include CONTROLLER_HEADER
#include PLANT_HEADER

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
#define C(name) JOIN(BED, JOIN(_controller_, name))
#define P(name) JOIN(BED, JOIN(_plant_, name))

typedef JOIN(BED, _real) real;

enum { rows = 64, width = sizeof(C(inputs)) / sizeof(real) };

static real noise(void)
{
    static unsigned long state = 1;
    state = state * 6364136223846793005ul + 1442695040888963407ul;
    return (real)((double)(state >> 33) / 2147483648.0 - 0.5);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        return 2;
    }
    const char *kind = argv[1];
    const long steps = atol(argv[2]);
    static C(inputs) table[rows];
    for (int k = 0; k < rows; ++k) {
        real *value = (real *)(void *)&table[k];
        for (int i = 0; i < width; ++i) {
            value[i] = noise() * (real)(strcmp(kind, "saturated") == 0 ? 200.0 : 0.02);
        }
        if (strcmp(kind, "bridged") == 0 && k % 4 == 0) {
            value[k / 4 % (width - 1)] = (real)NAN;
        }
        if (strcmp(kind, "faulted") == 0) {
            for (int i = 0; i < width; ++i) {
                value[i] = (real)NAN;
            }
        }
        table[k].reset = (real)(strcmp(kind, "reset") == 0 && k % 2);
    }
    C(params) controller_params = C(defaults);
    const P(params) plant_params = P(defaults);
    static C(state) controller;
    static P(state) plant;
    if ((int)C(init)(&controller, &controller_params) != 0 || (int)P(init)(&plant, &plant_params) != 0) {
        return 1;
    }
    real sum = 0;
    double start = now();
    if (strcmp(kind, "plant") == 0) {
        P(inputs) inputs = {AT_REST};
        P(outputs) outputs;
        for (long k = 0; k < steps; ++k) {
            *(real *)(void *)&inputs = noise();
            if ((int)P(step)(&plant, &plant_params, &inputs, &outputs) != 0) {
                return 1;
            }
            sum += *(real *)(void *)&outputs;
        }
    } else {
        C(outputs) outputs;
        for (long k = 0; k < steps; ++k) {
            C(step)(&controller, &controller_params, &table[k % rows], &outputs);
            sum += *(real *)(void *)&outputs;
        }
    }
    printf("%.3f\n", (now() - start) / (double)steps);
    return sum == (real)12345;
}
