/*
 * differential_governed_governor.h: references that keep the machines inside their torque limits
 *
 * Emitted by ptgen 0.1.0 from differential-governed.toml (SHA-256 d08516f63c075637), template governor.h.jinja.
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

#endif
