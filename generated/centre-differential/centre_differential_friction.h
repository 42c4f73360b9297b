/*
 * centre_differential_friction.h: friction that sticks and slips, and shafts with backlash
 *
 * Emitted by ptgen 0.1.0 from centre-differential.toml (SHA-256 11edcc3b908b78c3), template friction.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef CENTRE_DIFFERENTIAL_FRICTION_H
#define CENTRE_DIFFERENTIAL_FRICTION_H

#include "centre_differential_support.h"

enum { centre_differential_friction_elements = 2 };

/*
 * Friction torques that hold or let go: given velocities w without friction torques and w_plus = w - K T, find T with
 *
 *     lo_i <= T_i <= hi_i;  w_plus_i > 0 only where T_i = hi_i;  w_plus_i < 0 only where T_i = lo_i;  else exactly 0,
 *
 * which is the minimum of T'K T / 2 - w'T over the box. K is symmetric and positive semidefinite; one of the two bounds
 * of an element may be infinite. T holds torques of a similar problem and becomes the solution.
 * Three clamps give the nine sectors of the source's Figure 4.7. Returns 0.
 */
int centre_differential_solve_box(int deficient, const centre_differential_real *K, const centre_differential_real *w, const centre_differential_real *lo,
    const centre_differential_real *hi, centre_differential_real *T, centre_differential_real *w_plus);

/*
 * Friction over one step: from velocities w to w_free - K mean. Inside the step velocities move on straight lines; one
 * that reaches zero is held there if its capacity `rest` allows, or goes on with its capacity `slide` in the other
 * direction. `torque` and `rest_before` hold the torques at the end, and the capacities at rest, of the last step (zero if
 * there was none), and become those of this one. The bits of `one_way` tell which elements hold any positive torque.
 * `status` is 0, the number of the first element (from 1) whose capacity is no number from 0 up, which then counts as 0,
 * or -1 if the residual stayed above rounding.
 */
void centre_differential_friction_step(int deficient, int one_way, const centre_differential_real *K, const centre_differential_real *w,
    const centre_differential_real *w_free, const centre_differential_real *slide, const centre_differential_real *rest, centre_differential_real *torque,
    centre_differential_real *rest_before, centre_differential_real *mean, centre_differential_real *w_plus, centre_differential_real *status);

enum { centre_differential_contacts = 2 };

/*
 * Mean torques of shafts with backlash over a step in which their twists go from e to e_free - kappa T:
 * T = (V(e_plus) - V(e)) / (e_plus - e) + damping (p(e_plus) - p(e)), with the twist p beyond the gap and V = c p^2 / 2.
 * So their work is what V has lost, less what the damping takes: rattling makes no energy.
 */
void centre_differential_backlash_step(const centre_differential_real *kappa, const centre_differential_real *e, const centre_differential_real *e_free,
    const centre_differential_real *half_gap, const centre_differential_real *stiffness, const centre_differential_real *damping, centre_differential_real *T);

#endif
