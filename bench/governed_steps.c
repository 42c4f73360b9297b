/* Time of one step: the least of several, each from the same state; see governed_steps.py. */
#define _POSIX_C_SOURCE 199309L
#include <string.h>
#include <time.h>

typedef int step_function(void *state, const void *params, const void *inputs, void *outputs);

double least_time(step_function *step, const void *before, void *state, unsigned long size, const void *params,
    const void *inputs, void *outputs, int count)
{
    double least = 1e30;
    for (int k = 0; k < count; ++k) {
        struct timespec start, end;
        memcpy(state, before, size);
        clock_gettime(CLOCK_MONOTONIC, &start);
        step(state, params, inputs, outputs);
        clock_gettime(CLOCK_MONOTONIC, &end);
        const double taken = 1e9 * (double)(end.tv_sec - start.tv_sec) + (double)(end.tv_nsec - start.tv_nsec);
        least = taken < least ? taken : least;
    }
    return least;
}
