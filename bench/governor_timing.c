/* Solves one problem of the governor many times: `governor_timing sequential|optimal <count>`; see governor_kernels.py. */
#include "bed_governor.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "problem.h"

int main(int argc, char **argv)
{
    const long count = argc > 2 ? atol(argv[2]) : 1;
    const int optimal = argc > 1 && strcmp(argv[1], "optimal") == 0;
    bed_real shaped[8], slack[8], iterations = 0, status = 0, sum = 0;
    const clock_t start = clock();
    for (long k = 0; k < count; ++k) {
        if (optimal) {
            bed_optimal_governor(1, wanted, before, free_torque, &gain[0][0], least, most, deviation, &rows_x[0][0],
                &rows_r[0][0], weight, tie, group, before, shaped, slack, &iterations, &status);
        } else {
            bed_sequential_governor(wanted, before, free_torque, &gain[0][0], least, most, reserve, rate_step, tie,
                modified, group, shaped);
        }
        sum += shaped[0];
    }
    const double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    printf("%.17g %.17g %g %g %.1f\n", (double)sum, (double)shaped[1], (double)iterations, (double)status,
        seconds / (double)count * 1e9);
    return 0;
}
