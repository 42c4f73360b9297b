/*
 * differential_output_torque_friction.h: friction that sticks and slips, and shafts with backlash
 *
 * Emitted by ptgen 0.1.0 from differential-output-torque.toml (SHA-256 110eb6b1ebccd836), template friction.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef DIFFERENTIAL_OUTPUT_TORQUE_FRICTION_H
#define DIFFERENTIAL_OUTPUT_TORQUE_FRICTION_H

#include "differential_output_torque_support.h"

enum { differential_output_torque_friction_elements = 2 };

/*
 * Friction torques that hold or let go: given velocities w without friction torques and w_plus = w - K T, find T with
 *
 *     lo_i <= T_i <= hi_i;  w_plus_i > 0 only where T_i = hi_i;  w_plus_i < 0 only where T_i = lo_i;  else exactly 0,
 *
 * which is the minimum of T'K T / 2 - w'T over the box. K is symmetric and positive semidefinite; one of the two bounds
 * of an element may be infinite. T holds torques of a similar problem and becomes the solution.
 * Three clamps give the nine sectors of the source's Figure 4.7. Returns 0.
 */
int differential_output_torque_solve_box(int deficient, const differential_output_torque_real *K, const differential_output_torque_real *w, const differential_output_torque_real *lo,
    const differential_output_torque_real *hi, differential_output_torque_real *T, differential_output_torque_real *w_plus);

/*
 * Friction over one step: from velocities w to w_free - K mean. Inside the step velocities move on straight lines; one
 * that reaches zero is held there if its capacity `rest` allows, or goes on with its capacity `slide` in the other
 * direction. `torque` and `rest_before` hold the torques at the end, and the capacities at rest, of the last step (zero if
 * there was none), and become those of this one. The bits of `one_way` tell which elements hold any positive torque.
 * `status` is 0, the number of the first element (from 1) whose capacity is no number from 0 up, which then counts as 0,
 * or -1 if the residual stayed above rounding.
 */
void differential_output_torque_friction_step(int deficient, int one_way, const differential_output_torque_real *K, const differential_output_torque_real *w,
    const differential_output_torque_real *w_free, const differential_output_torque_real *slide, const differential_output_torque_real *rest, differential_output_torque_real *torque,
    differential_output_torque_real *rest_before, differential_output_torque_real *mean, differential_output_torque_real *w_plus, differential_output_torque_real *status);

#endif
