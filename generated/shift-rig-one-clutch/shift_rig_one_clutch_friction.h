/*
 * shift_rig_one_clutch_friction.h: friction that sticks and slips, and shafts with backlash
 *
 * Emitted by ptgen 0.1.0 from shift-rig-one-clutch.toml (SHA-256 78ebad094db7f87a), template friction.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef SHIFT_RIG_ONE_CLUTCH_FRICTION_H
#define SHIFT_RIG_ONE_CLUTCH_FRICTION_H

#include "shift_rig_one_clutch_support.h"

enum { shift_rig_one_clutch_friction_elements = 1 };

/*
 * Friction torques that hold or let go: given velocities w without friction torques and w_plus = w - K T, find T with
 *
 *     lo_i <= T_i <= hi_i;  w_plus_i > 0 only where T_i = hi_i;  w_plus_i < 0 only where T_i = lo_i;  else exactly 0,
 *
 * which is the minimum of T'K T / 2 - w'T over the box. K is symmetric and positive semidefinite; one of the two bounds
 * of an element may be infinite. T holds torques of a similar problem and becomes the solution.
 * One clamp. Returns 0.
 */
int shift_rig_one_clutch_solve_box(int deficient, const shift_rig_one_clutch_real *K, const shift_rig_one_clutch_real *w, const shift_rig_one_clutch_real *lo,
    const shift_rig_one_clutch_real *hi, shift_rig_one_clutch_real *T, shift_rig_one_clutch_real *w_plus);

/*
 * Friction over one step: from velocities w to w_free - K mean. Inside the step velocities move on straight lines; one
 * that reaches zero is held there if its capacity `rest` allows, or goes on with its capacity `slide` in the other
 * direction. `torque` and `rest_before` hold the torques at the end, and the capacities at rest, of the last step (zero if
 * there was none), and become those of this one. The bits of `one_way` tell which elements hold any positive torque.
 * `status` is 0, the number of the first element (from 1) whose capacity is no number from 0 up, which then counts as 0,
 * or -1 if the residual stayed above rounding.
 */
void shift_rig_one_clutch_friction_step(int deficient, int one_way, const shift_rig_one_clutch_real *K, const shift_rig_one_clutch_real *w,
    const shift_rig_one_clutch_real *w_free, const shift_rig_one_clutch_real *slide, const shift_rig_one_clutch_real *rest, shift_rig_one_clutch_real *torque,
    shift_rig_one_clutch_real *rest_before, shift_rig_one_clutch_real *mean, shift_rig_one_clutch_real *w_plus, shift_rig_one_clutch_real *status);

#endif
