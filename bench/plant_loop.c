/*
 * Steps of an emitted plant from a given state; PLANT is its prefix. Inputs are rows of the input struct.
 */
#include <stddef.h>

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#define NAME(suffix) JOIN(PLANT, suffix)
#define TEXT_(a) #a
#define TEXT(a) TEXT_(a)
#include TEXT(PLANT_HEADER)

long plant_loop(double sample_time, const double *start, size_t states, const NAME(_plant_inputs) *inputs, long steps,
    double *end)
{
    static NAME(_plant_state) state;
    NAME(_plant_params) params = NAME(_plant_defaults);
    NAME(_plant_outputs) outputs;
    params.sample_time = sample_time;
    long status = (long)NAME(_plant_init)(&state, &params);
    for (size_t i = 0; i < states; ++i) {
        state.x[i] = start[i];
    }
    for (long k = 0; k < steps && status == 0; ++k) {
        status = (long)NAME(_plant_step)(&state, &params, &inputs[k], &outputs);
    }
    for (size_t i = 0; i < states; ++i) {
        end[i] = state.x[i];
    }
    return status;
}
