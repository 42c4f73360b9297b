/*
 * back_to_back_plant.c: plant of the bed back_to_back
 *
 * Emitted by ptgen 0.1.0 from back-to-back.toml (SHA-256 376363ff9555c6b9), template block.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "back_to_back_plant.h"

#include <float.h>
#include <string.h>

const back_to_back_plant_params back_to_back_plant_defaults = {
    .M1_inertia = 5.0,
    .M1_torque_max = 3050.0,
    .M1_speed_rated = 188.495559215388,
    .M1_inverter_dead_time = 0.0001,
    .M1_inverter_time_constant = 0.00025,
    .flange1_inertia = 0.032,
    .flange1_stiffness = 380000.0,
    .flange1_damping = 0.5,
    .shaft1_stiffness = 33500.0,
    .shaft1_damping = 10.0,
    .flange2_inertia = 0.032,
    .flange2_stiffness = 380000.0,
    .flange2_damping = 0.5,
    .M2_inertia = 5.0,
    .M2_torque_max = 3050.0,
    .M2_speed_rated = 188.495559215388,
    .M2_inverter_dead_time = 0.0001,
    .M2_inverter_time_constant = 0.00025,
    .sample_time = 0.0001,
};

/* Range of each parameter; `open` excludes the lower bound. The order is that of the status codes. */
static const struct {
    const char *text;
    size_t offset;
    back_to_back_real least;
    back_to_back_real most;
    int open;
    int not_zero;
} limits[] = {
    { "the parameter M1_inertia is outside its range", offsetof(back_to_back_plant_params, M1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_max is outside its range", offsetof(back_to_back_plant_params, M1_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_rated is outside its range", offsetof(back_to_back_plant_params, M1_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_inverter_dead_time is outside its range", offsetof(back_to_back_plant_params, M1_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M1_inverter_time_constant is outside its range", offsetof(back_to_back_plant_params, M1_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_inertia is outside its range", offsetof(back_to_back_plant_params, flange1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_stiffness is outside its range", offsetof(back_to_back_plant_params, flange1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_damping is outside its range", offsetof(back_to_back_plant_params, flange1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter shaft1_stiffness is outside its range", offsetof(back_to_back_plant_params, shaft1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft1_damping is outside its range", offsetof(back_to_back_plant_params, shaft1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter flange2_inertia is outside its range", offsetof(back_to_back_plant_params, flange2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_stiffness is outside its range", offsetof(back_to_back_plant_params, flange2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_damping is outside its range", offsetof(back_to_back_plant_params, flange2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_inertia is outside its range", offsetof(back_to_back_plant_params, M2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_max is outside its range", offsetof(back_to_back_plant_params, M2_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_rated is outside its range", offsetof(back_to_back_plant_params, M2_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_inverter_dead_time is outside its range", offsetof(back_to_back_plant_params, M2_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M2_inverter_time_constant is outside its range", offsetof(back_to_back_plant_params, M2_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter sample_time is outside its range", offsetof(back_to_back_plant_params, sample_time), 0.0, DBL_MAX, 1, 0 },
};

enum { limit_count = sizeof limits / sizeof limits[0] };

const char *back_to_back_plant_status_text(back_to_back_plant_status status)
{
    switch ((int)status) {
    case back_to_back_plant_ok:
        return "ok";
    case back_to_back_plant_mass_matrix:
        return "the inertia matrix is not positive definite";
    case back_to_back_plant_exponential_range:
        return "the parameters are too far from those that the code was emitted for; emit it again";
    case back_to_back_plant_bad_input_M1_torque_ref:
        return "the input M1_torque_ref is not finite";
    case back_to_back_plant_bad_input_M2_torque_ref:
        return "the input M2_torque_ref is not finite";
    default:
        break;
    }
    const int limit = (int)status - 2000;
    return limit >= 0 && limit < limit_count ? limits[limit].text : "unknown status";
}

back_to_back_plant_status back_to_back_plant_init(back_to_back_plant_state *s, const back_to_back_plant_params *p)
{
    memset(s, 0, sizeof *s);
    return back_to_back_plant_update(s, p);
}

back_to_back_plant_status back_to_back_plant_update(back_to_back_plant_state *s, const back_to_back_plant_params *p)
{
    for (int k = 0; k < limit_count; ++k) {
        const back_to_back_real value = *(const back_to_back_real *)(const void *)((const char *)p + limits[k].offset);
        const int above = limits[k].open ? value > limits[k].least : value >= limits[k].least; /* false for NaN */
        if (!(above && value <= limits[k].most) || (limits[k].not_zero && value == 0.0)) {
            return (back_to_back_plant_status)(2000 + k);
        }
    }
    memset(s->transition, 0, sizeof s->transition);
    back_to_back_real mass[4][4];
    back_to_back_real forces[9][4];
    back_to_back_real A[11][12];
    back_to_back_real scale[12];
    back_to_back_real whole[11][12];
    back_to_back_real late[11][12];
    back_to_back_real early[11][12];
    back_to_back_real rates[9][4];
    back_to_back_zero(sizeof mass, mass);
    back_to_back_zero(sizeof forces, forces);
    back_to_back_zero(sizeof A, A);
    back_to_back_zero(sizeof scale, scale);
    back_to_back_zero(sizeof whole, whole);
    back_to_back_zero(sizeof late, late);
    back_to_back_zero(sizeof early, early);
    back_to_back_zero(sizeof rates, rates);
    
    /* M = S' I S */
    mass[0][0] = p->M1_inertia;
    mass[1][1] = p->M2_inertia;
    mass[2][2] = p->flange1_inertia;
    mass[3][3] = p->flange2_inertia;
    /* M dz/dt = B' u - E'(C e + D E z) - G'(T + k_v G z) */
    forces[0][0] = -p->flange1_damping;
    forces[2][0] = p->flange1_damping;
    forces[4][0] = -p->flange1_stiffness;
    forces[7][0] = 1.0;
    forces[1][1] = -p->flange2_damping;
    forces[3][1] = p->flange2_damping;
    forces[6][1] = -p->flange2_stiffness;
    forces[8][1] = 1.0;
    forces[0][2] = p->flange1_damping;
    forces[2][2] = -p->flange1_damping - p->shaft1_damping;
    forces[3][2] = p->shaft1_damping;
    forces[4][2] = p->flange1_stiffness;
    forces[5][2] = -p->shaft1_stiffness;
    forces[1][3] = p->flange2_damping;
    forces[2][3] = p->shaft1_damping;
    forces[3][3] = -p->flange2_damping - p->shaft1_damping;
    forces[5][3] = p->shaft1_stiffness;
    forces[6][3] = p->flange2_stiffness;
    if (!back_to_back_cholesky_solve(4, 9, &mass[0][0], &forces[0][0], &rates[0][0])) {
        return back_to_back_plant_mass_matrix;
    }
    back_to_back_insert(4, 12, 4, 0, 0, 0, 7, &A[0][0], &rates[0][0]);
    /* de/dt = E z */
    A[0][4] = 1.0;
    A[2][4] = -1.0;
    A[2][5] = 1.0;
    A[3][5] = -1.0;
    A[1][6] = 1.0;
    A[3][6] = -1.0;
    back_to_back_insert(4, 12, 4, 0, 7, 7, 1, &A[0][0], &rates[0][0]);
    /* lag of the torque loop */
    A[7][7] = -1.0 / p->M1_inverter_time_constant;
    A[9][7] = 1.0 / p->M1_inverter_time_constant;
    back_to_back_insert(4, 12, 4, 0, 8, 8, 1, &A[0][0], &rates[0][0]);
    A[8][8] = -1.0 / p->M2_inverter_time_constant;
    A[10][8] = 1.0 / p->M2_inverter_time_constant;
    scale[0] = 1.0;
    scale[1] = 1.0;
    scale[2] = 1.0;
    scale[3] = 1.0;
    scale[4] = p->sample_time;
    scale[5] = p->sample_time;
    scale[6] = p->sample_time;
    scale[7] = 1.0;
    scale[8] = 1.0;
    scale[9] = 1.0;
    scale[10] = 1.0;
    /* exact discretisation */
    if (!back_to_back_discretise(9, 11, 5, &A[0][0], scale, p->sample_time, &whole[0][0])) {
        return back_to_back_plant_exponential_range;
    }
    back_to_back_insert(9, 12, 12, 0, 0, 0, 9, &s->transition[0][0], &whole[0][0]);
    /* dead time = (d + f) h */
    s->M1_dead_steps = back_to_back_floor(p->M1_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const back_to_back_real M1_late_time = p->sample_time - back_to_back_max(0.0, -s->M1_dead_steps * p->sample_time
        + p->M1_inverter_dead_time);
    if (!back_to_back_discretise(9, 11, 5, &A[0][0], scale, M1_late_time, &late[0][0])) {
        return back_to_back_plant_exponential_range;
    }
    back_to_back_difference(9, 11, &whole[0][0], &late[0][0], &early[0][0]);
    back_to_back_insert(9, 12, 12, 0, 9, 9, 1, &s->transition[0][0], &late[0][0]);
    back_to_back_insert(9, 12, 12, 0, 11, 9, 1, &s->transition[0][0], &early[0][0]);
    /* dead time = (d + f) h */
    s->M2_dead_steps = back_to_back_floor(p->M2_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const back_to_back_real M2_late_time = p->sample_time - back_to_back_max(0.0, -s->M2_dead_steps * p->sample_time
        + p->M2_inverter_dead_time);
    if (!back_to_back_discretise(9, 11, 5, &A[0][0], scale, M2_late_time, &late[0][0])) {
        return back_to_back_plant_exponential_range;
    }
    back_to_back_difference(9, 11, &whole[0][0], &late[0][0], &early[0][0]);
    back_to_back_insert(9, 12, 12, 0, 10, 10, 1, &s->transition[0][0], &late[0][0]);
    back_to_back_insert(9, 12, 12, 0, 12, 10, 1, &s->transition[0][0], &early[0][0]);
    return back_to_back_plant_ok;
}

void back_to_back_plant_measure(const back_to_back_plant_state *s, const back_to_back_plant_params *p, back_to_back_plant_outputs *out)
{
    out->M1_speed = s->x[0];
    out->flange1_torque = p->flange1_damping * s->x[0] - p->flange1_damping * s->x[2] + p->flange1_stiffness *
        s->x[4];
    out->flange2_torque = -p->flange2_damping * s->x[1] + p->flange2_damping * s->x[3] - p->flange2_stiffness *
        s->x[6];
    out->M2_speed = s->x[1];
    out->M1_torque = s->x[7];
    out->M2_torque = s->x[8];
}

/* Status of the first input that is not finite or outside its range. */
static int check_inputs(const back_to_back_plant_inputs *in)
{
    if (!back_to_back_is_finite(in->M1_torque_ref)) {
        return (int)back_to_back_plant_bad_input_M1_torque_ref;
    }
    if (!back_to_back_is_finite(in->M2_torque_ref)) {
        return (int)back_to_back_plant_bad_input_M2_torque_ref;
    }
    return 0;
}

back_to_back_plant_status back_to_back_plant_step(back_to_back_plant_state *s, const back_to_back_plant_params *p,
    const back_to_back_plant_inputs *in, back_to_back_plant_outputs *out)
{
    const int bad = check_inputs(in);
    if (bad != 0) {
        back_to_back_plant_measure(s, p, out);
        return (back_to_back_plant_status)bad;
    }
    back_to_back_real x_free[12];
    back_to_back_zero(sizeof x_free, x_free);
    
    /* torque-speed envelope, Figure 7.1 */
    const back_to_back_real M1_available = p->M1_speed_rated * p->M1_torque_max /
        back_to_back_max(p->M1_speed_rated, back_to_back_abs(s->x[0]));
    const back_to_back_real M1_limited = back_to_back_max(-M1_available, back_to_back_min(M1_available,
        in->M1_torque_ref));
    /* dead time of the torque loop */
    back_to_back_delay(16, s->M1_delay, M1_limited, s->M1_dead_steps, &s->x[9], &s->x[11]);
    /* torque-speed envelope, Figure 7.1 */
    const back_to_back_real M2_available = p->M2_speed_rated * p->M2_torque_max /
        back_to_back_max(p->M2_speed_rated, back_to_back_abs(s->x[1]));
    const back_to_back_real M2_limited = back_to_back_max(-M2_available, back_to_back_min(M2_available,
        in->M2_torque_ref));
    /* dead time of the torque loop */
    back_to_back_delay(16, s->M2_delay, M2_limited, s->M2_dead_steps, &s->x[10], &s->x[12]);
    /* x+ = Phi x + Gamma_u u */
    back_to_back_multiply(9, 13, &s->transition[0][0], s->x, x_free);
    s->x[0] = x_free[0];
    s->x[1] = x_free[1];
    s->x[2] = x_free[2];
    s->x[3] = x_free[3];
    s->x[4] = x_free[4];
    s->x[5] = x_free[5];
    s->x[6] = x_free[6];
    s->x[7] = x_free[7];
    s->x[8] = x_free[8];
    back_to_back_plant_measure(s, p, out);
    return back_to_back_plant_ok;
}
