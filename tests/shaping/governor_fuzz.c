/*
 * Both governors with numbers of every sort, for the sanitizers: prints how many problems ended with each status.
 * Whatever comes in, references that were finite stay so, and between the last and the wanted ones.
 */
#include "bed_governor.h"

#include <float.h>
#include <stdint.h>
#include <stdio.h>

enum { m = bed_governor_machines, n = bed_governor_states, rows = (bed_governor_rows + 3) / 4 * 4, stride = (m + 3) / 4 * 4 };

static uint64_t state = 88172645463325252u;

static double uniform(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) * 0x1p-53;
}

static bed_real number(double wild)
{
    static const double odd[] = { 0.0, -0.0, 1e-320, 1e-40, DBL_MAX, -DBL_MAX, 1e38, -1e30, 1e300, INFINITY, -INFINITY, NAN };
    if (uniform() < wild) {
        return (bed_real)odd[(int)(uniform() * 12.0)];
    }
    return (bed_real)((uniform() - 0.5) * pow(10.0, uniform() * 4.0 - 1.0));
}

static void fill(int count, bed_real *numbers, double wild)
{
    for (int i = 0; i < count; ++i) {
        numbers[i] = number(wild);
    }
}

static int outside(const bed_real *shaped, const bed_real *before, const bed_real *wanted, int may_go_back)
{
    for (int i = 0; i < m; ++i) {
        if (!bed_is_finite(before[i])) {
            continue; /* was lost before */
        }
        if (!bed_is_finite(shaped[i])) {
            return 1;
        }
        const int between = (shaped[i] >= before[i] && shaped[i] <= wanted[i]) || (shaped[i] <= before[i] && shaped[i] >= wanted[i]);
        if (!may_go_back && !between && shaped[i] != before[i]) {
            return 1;
        }
    }
    return 0;
}

int main(void)
{
    static bed_real rows_x[n * rows], rows_r[m * rows];
    fill(n * rows, rows_x, 0.0);
    fill(m * rows, rows_r, 0.0);
    long ended[4] = { 0, 0, 0, 0 };
    for (long k = 0; k < 20000; ++k) {
        const double wild = k % 2 ? 0.01 : 0.0;
        bed_real wanted[stride], before[stride], free_torque[stride], gain[m * stride], least[stride], most[stride];
        bed_real reserve[stride], rate_step[stride], deviation[n + 4], weight[stride], group[stride], fallback[stride];
        bed_real *const vectors[] = { wanted, before, free_torque, most, least, reserve, rate_step, weight };
        for (int v = 0; v < 8; ++v) {
            fill(m, vectors[v], wild);
        }
        fill(m * stride, gain, wild);
        fill(n, deviation, wild);
        for (int i = 0; i < m; ++i) {
            group[i] = (bed_real)(i % 2);
            if (k % 3) {
                most[i] = bed_abs(most[i]) * (bed_real)pow(10.0, 1.0 + uniform() * 6.0);
                least[i] = -most[i];
            }
            weight[i] = bed_abs(weight[i]);
            wanted[i] = uniform() < 0.1 ? before[i] : wanted[i];
        }
        const bed_real tie = number(wild), modified = (bed_real)(k % 4 > 1);
        bed_real shaped[stride], slack[stride], iterations, status;
        bed_sequential_governor(wanted, before, free_torque, gain, least, most, reserve, rate_step, tie, modified, group, fallback);
        const int wrong = outside(fallback, before, wanted, modified > 0);
        bed_optimal_governor(1, wanted, before, free_torque, gain, least, most, deviation, rows_x, rows_r, weight, tie, group,
            fallback, shaped, slack, &iterations, &status);
        if (wrong || outside(shaped, before, wanted, modified > 0) || !(status >= 0 && status <= 3)
            || iterations > bed_governor_iterations) {
            printf("problem %ld is answered wrongly\n", k);
            return 1;
        }
        ++ended[(int)status];
    }
    printf("%ld %ld %ld %ld\n", ended[0], ended[1], ended[2], ended[3]);
    return 0;
}
