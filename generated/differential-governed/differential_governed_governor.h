/*
 * differential_governed_governor.h: references that keep the machines inside their torque limits
 *
 * Emitted by ptgen 0.1.0 from differential-governed.toml (SHA-256 acf552a043b195e0), template governor.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef DIFFERENTIAL_GOVERNED_GOVERNOR_H
#define DIFFERENTIAL_GOVERNED_GOVERNOR_H

#include "differential_governed_support.h"

/* Number of machines, and of references. */
enum { differential_governed_governor_machines = 3 };

/*
 * The torque commands of this step are free + gain (shaped - before) (N m), with one reference for each machine (rad/s or
 * N m): `wanted`, of which the last step made `before`. They must stay from `least` to `most`. References of the same
 * positive number in `group` that are closer than `tie`, before and wanted, are led together.
 */

/*
 * One reference after the other, each as close to the wanted one as its machine allows. Earlier ones give way if `reserve`
 * (N m) is not kept, or `rate_step`, the smallest change of the reference. Shaped references lie between `before` and
 * `wanted`; if `modified` is 1, they may go back instead. An input that is not finite leaves `before`.
 */
void differential_governed_sequential_governor(const differential_governed_real *wanted, const differential_governed_real *before,
    const differential_governed_real *free, const differential_governed_real *gain, const differential_governed_real *least,
    const differential_governed_real *most, const differential_governed_real *reserve, const differential_governed_real *rate_step,
    differential_governed_real tie, differential_governed_real modified, const differential_governed_real *group, differential_governed_real *shaped);

/* States of the prediction, rows of all machines, and what the solution may take. */
enum {
    differential_governed_governor_states = 9,
    differential_governed_governor_rows = 433,
    differential_governed_governor_iterations = 40
};

/*
 * The references that keep the limits in all predicted steps: shaped_i = before_i + h_i (wanted_i - before_i) with h from
 * 0 to 1, and the largest sum of weight_i h_i. A row predicts the command of its machine: it adds
 * rows_x deviation + rows_r (shaped - wanted), with the `deviation` of the state from the one at which the closed loop
 * would rest with the wanted references. Rows are grouped machine by machine.
 *
 * Dual simplex from h = 1: no work if nothing binds. `status` is
 *   0  nothing binds, or not `chosen` (at most 0.5), which gives the fallback,
 *   1  some reference is held back,
 *   2  limits were widened by `slack` (N m), which is what is lacking if nothing is changed,
 *   3  not solved within the bound of iterations, or an input is not finite: the fallback.
 */
void differential_governed_optimal_governor(differential_governed_real chosen, const differential_governed_real *wanted, const differential_governed_real *before,
    const differential_governed_real *free, const differential_governed_real *gain, const differential_governed_real *least,
    const differential_governed_real *most, const differential_governed_real *deviation, const differential_governed_real *rows_x,
    const differential_governed_real *rows_r, const differential_governed_real *weight, differential_governed_real tie, const differential_governed_real *group,
    const differential_governed_real *fallback, differential_governed_real *shaped, differential_governed_real *slack, differential_governed_real *iterations,
    differential_governed_real *status);

#endif
