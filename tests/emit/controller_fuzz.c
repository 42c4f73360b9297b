/*
 * Feeds a controller with anything and checks what may never happen; see test_controller_fuzz.py.
 *
 *     fuzz ROUNDS SEED CHECKED      CHECKED: 1 only parameters that an update has accepted, 0 anything
 *
 * All structs of a block hold nothing but numbers, so they are filled as arrays.
 */
#include CONTROLLER_HEADER

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
#define C(name) JOIN(BED, JOIN(_controller_, name))

typedef JOIN(BED, _real) real;

enum {
    input_count = sizeof(C(inputs)) / sizeof(real),
    output_count = sizeof(C(outputs)) / sizeof(real),
    parameter_count = sizeof(C(params)) / sizeof(real)
};

static const real ratings[output_count] = { RATINGS };

static uint64_t state;

static uint64_t bits(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state * UINT64_C(2685821657736338717);
}

static double uniform(void) { return (double)(bits() >> 11) / 9007199254740992.0; }

static real anything(void)
{
    const uint64_t raw = bits();
    double value;
    switch (bits() % 8) {
    case 0: return (real)NAN;
    case 1: return (real)(raw & 1 ? INFINITY : -INFINITY);
    case 2: return (real)0;
    case 3: return (real)(raw & 1 ? 5e-324 : -2e-310);
    case 4: return (real)(raw & 1 ? 1.7e308 : -1.7e308);
    case 5: return (real)((uniform() - 0.5) * 2000.0);
    default: memcpy(&value, &raw, sizeof value); return sizeof(real) == sizeof(double) ? (real)value : (real)(isfinite(value) && fabs(value) > 3e38 ? 0 : value);
    }
}

static void realistic(C(inputs) *in)
{
    static real level[input_count];
    real *value = (real *)(void *)in;
    for (int i = 0; i < input_count; ++i) {
        level[i] += (real)((uniform() - 0.5) * 4.0 - 0.002 * (double)level[i]);
        value[i] = level[i];
    }
    in->reset = (real)(bits() % 50 == 0);
}

static long failures;

static void complain(const char *what, long step, double value)
{
    if (failures++ < 10) {
        printf("step %ld: %s (%g)\n", step, what, value);
    }
}

static void check(const C(outputs) *out, long step)
{
    const real *torque = (const real *)(const void *)out;
    for (int i = 0; i < output_count; ++i) {
        if (!(fabs((double)torque[i]) <= (double)ratings[i])) {
            complain("torque beyond its machine", step, (double)torque[i]);
        }
    }
}

/* With sound parameters and inputs, every fault can be left by the edge of reset. */
static void recover(C(state) *s, long step)
{
    const C(params) p = C(defaults);
    C(inputs) in;
    C(outputs) out;
    int status = (int)C(update)(s, &p);
    memset(&in, 0, sizeof in);
    GEARBOX_RATIOS
    const long ramp = (long)(p.fault_ramp / p.sample_time) + 3;
    C(inputs) bad = in;
    *(real *)(void *)&bad = (real)NAN; /* whatever was latched before, or not: now something is */
    for (long k = 0; k < ramp + (long)(p.hold_time / p.sample_time) + 3; ++k) {
        status = (int)C(step)(s, &p, &bad, &out);
        check(&out, step);
    }
    status = (int)C(step)(s, &p, &in, &out);
    if (status == 0) {
        complain("a fault left on its own", step, 0);
    }
    const real *torque = (const real *)(const void *)&out;
    for (int i = 0; i < output_count; ++i) {
        if (torque[i] != 0) {
            complain("torque after the ramp", step, (double)torque[i]);
        }
    }
    in.reset = (real)1;
    for (long k = 0; k < 2 * ramp; ++k) {
        status = (int)C(step)(s, &p, &in, &out);
        check(&out, step);
        if (status != 0) {
            complain(C(status_text)((C(status))status), step, status);
            break;
        }
    }
    for (unsigned long k = 0; k < sizeof *s / sizeof(real); ++k) {
        const double value = (double)((const real *)(const void *)s)[k];
        if (!isfinite(value)) {
            complain("a state stays not finite", step, (double)k);
        }
    }
}

int main(int argc, char **argv)
{
    if (argc != 4) {
        return 2;
    }
    const long rounds = atol(argv[1]);
    const int checked = atoi(argv[3]);
    state = strtoull(argv[2], NULL, 10) * UINT64_C(0x9E3779B97F4A7C15) + 1;
    static C(state) s;
    long steps = 0, faults = 0;
    for (long round = 0; round < rounds; ++round) {
        C(params) p = C(defaults);
        C(inputs) in;
        C(outputs) out;
        memset(&in, 0, sizeof in);
        if (bits() % 4 == 0 || round == 0) {
            (void)C(init)(&s, &p);
        }
        const uint64_t kind = bits() % 4;
        for (int k = 0; k < 300; ++k, ++steps) {
            if (bits() % 64 == 0) {
                C(params) next = p;
                for (int n = (int)(bits() % 3); n >= 0; --n) {
                    ((real *)(void *)&next)[bits() % parameter_count] = anything();
                }
                const int status = bits() % 8 == 0 ? (int)C(init)(&s, &next) : (int)C(update)(&s, &next);
                if (status == 0 || !checked) {
                    p = next;
                }
            }
            realistic(&in);
            real *value = (real *)(void *)&in;
            if (kind == 0) {
                for (int i = 0; i < input_count; ++i) {
                    value[i] = anything();
                }
            } else if (kind == 1 && bits() % 16 == 0) {
                value[bits() % input_count] = anything();
            } else if (kind == 2 && k / 20 % 3 == 1) {
                value[(k / 60) % input_count] = anything();
            }
            const int status = (int)C(step)(&s, &p, &in, &out);
            faults += status != 0;
            if (C(status_text)((C(status))status)[0] == '\0' || strcmp(C(status_text)((C(status))status), "unknown status") == 0) {
                complain("a status without text", steps, status);
            }
            check(&out, steps);
        }
        recover(&s, steps);
    }
    printf("%ld steps, %ld with a fault, %ld failures\n", steps, faults, failures);
    return failures != 0;
}
