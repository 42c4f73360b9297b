/*
 * transmission_friction.h: friction that sticks and slips, and shafts with backlash
 *
 * Emitted by ptgen 0.1.0 from transmission.toml (SHA-256 e06936acb40aa4a5), template friction.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef TRANSMISSION_FRICTION_H
#define TRANSMISSION_FRICTION_H

#include "transmission_support.h"

enum { transmission_friction_elements = 3 };

/*
 * Friction torques that hold or let go: given velocities w without friction torques and w_plus = w - K T, find T with
 *
 *     lo_i <= T_i <= hi_i;  w_plus_i > 0 only where T_i = hi_i;  w_plus_i < 0 only where T_i = lo_i;  else exactly 0,
 *
 * which is the minimum of T'K T / 2 - w'T over the box. K is symmetric and positive semidefinite; one of the two bounds
 * of an element may be infinite. T holds torques of a similar problem and becomes the solution.
 * A sweep of clamped coordinate minimisations finds a face of the box, factorisation the minimum on it; each lowers the
 * function, so it ends. If elements hold the same motion (`deficient`), the torques of least norm are taken.
 * Returns the number of factorisations, or -1 if the residual stayed above rounding.
 */
int transmission_solve_box(int deficient, const transmission_real *K, const transmission_real *w, const transmission_real *lo,
    const transmission_real *hi, transmission_real *T, transmission_real *w_plus);

/*
 * Friction over one step: from velocities w to w_free - K mean. Inside the step velocities move on straight lines; one
 * that reaches zero is held there if its capacity `rest` allows, or goes on with its capacity `slide` in the other
 * direction. `torque` and `rest_before` hold the torques at the end, and the capacities at rest, of the last step (zero if
 * there was none), and become those of this one. The bits of `one_way` tell which elements hold any positive torque.
 * `status` is 0, the number of the first element (from 1) whose capacity is no number from 0 up, which then counts as 0,
 * or -1 if the residual stayed above rounding.
 */
void transmission_friction_step(int deficient, int one_way, const transmission_real *K, const transmission_real *w,
    const transmission_real *w_free, const transmission_real *slide, const transmission_real *rest, transmission_real *torque,
    transmission_real *rest_before, transmission_real *mean, transmission_real *w_plus, transmission_real *status);

enum { transmission_contacts = 2 };

/*
 * Mean torques of shafts with backlash over a step in which their twists go from e to e_free - kappa T:
 * T = (V(e_plus) - V(e)) / (e_plus - e) + damping (p(e_plus) - p(e)), with the twist p beyond the gap and V = c p^2 / 2.
 * So their work is what V has lost, less what the damping takes: rattling makes no energy.
 */
void transmission_backlash_step(const transmission_real *kappa, const transmission_real *e, const transmission_real *e_free,
    const transmission_real *half_gap, const transmission_real *stiffness, const transmission_real *damping, transmission_real *T);

#endif
