/*
 * shift_rig_one_clutch_plant.c: plant of the bed shift_rig_one_clutch
 *
 * Emitted by ptgen 0.1.0 from shift-rig-one-clutch.toml (SHA-256 78ebad094db7f87a), template block.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "shift_rig_one_clutch_plant.h"
#include "shift_rig_one_clutch_friction.h"

#include <float.h>
#include <string.h>

const shift_rig_one_clutch_plant_params shift_rig_one_clutch_plant_defaults = {
    .M1_inertia = 0.4,
    .M1_torque_max = 900.0,
    .M1_speed_rated = 335.103216382911,
    .M1_inverter_dead_time = 0.0001,
    .M1_inverter_time_constant = 0.00025,
    .flange1_inertia = 0.01,
    .flange1_stiffness = 380000.0,
    .flange1_damping = 0.5,
    .shaft1_stiffness = 25000.0,
    .shaft1_damping = 2.0,
    .gears_inertia_input = 0.00341256523468981,
    .gears_inertia_output = 0.720043069037452,
    .gears_clutch_viscous = 0.0,
    .gears_clutch_capacity = 3072.35621521336,
    .shaft2_stiffness = 40000.0,
    .shaft2_damping = 3.0,
    .flange2_inertia = 0.03,
    .flange2_stiffness = 220000.0,
    .flange2_damping = 0.5,
    .M2_inertia = 4.5,
    .M2_torque_max = 3300.0,
    .M2_speed_rated = 104.71975511966,
    .M2_inverter_dead_time = 0.0001,
    .M2_inverter_time_constant = 0.00025,
    .standstill_speed = 1e-09,
    .sample_time = 0.0001,
};

/* Range of each parameter; `open` excludes the lower bound. The order is that of the status codes. */
static const struct {
    const char *text;
    size_t offset;
    shift_rig_one_clutch_real least;
    shift_rig_one_clutch_real most;
    int open;
    int not_zero;
} limits[] = {
    { "the parameter M1_inertia is outside its range", offsetof(shift_rig_one_clutch_plant_params, M1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_max is outside its range", offsetof(shift_rig_one_clutch_plant_params, M1_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_rated is outside its range", offsetof(shift_rig_one_clutch_plant_params, M1_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_inverter_dead_time is outside its range", offsetof(shift_rig_one_clutch_plant_params, M1_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M1_inverter_time_constant is outside its range", offsetof(shift_rig_one_clutch_plant_params, M1_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_inertia is outside its range", offsetof(shift_rig_one_clutch_plant_params, flange1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_stiffness is outside its range", offsetof(shift_rig_one_clutch_plant_params, flange1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_damping is outside its range", offsetof(shift_rig_one_clutch_plant_params, flange1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter shaft1_stiffness is outside its range", offsetof(shift_rig_one_clutch_plant_params, shaft1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft1_damping is outside its range", offsetof(shift_rig_one_clutch_plant_params, shaft1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_inertia_input is outside its range", offsetof(shift_rig_one_clutch_plant_params, gears_inertia_input), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_inertia_output is outside its range", offsetof(shift_rig_one_clutch_plant_params, gears_inertia_output), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_clutch_viscous is outside its range", offsetof(shift_rig_one_clutch_plant_params, gears_clutch_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_clutch_capacity is outside its range", offsetof(shift_rig_one_clutch_plant_params, gears_clutch_capacity), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft2_stiffness is outside its range", offsetof(shift_rig_one_clutch_plant_params, shaft2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft2_damping is outside its range", offsetof(shift_rig_one_clutch_plant_params, shaft2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter flange2_inertia is outside its range", offsetof(shift_rig_one_clutch_plant_params, flange2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_stiffness is outside its range", offsetof(shift_rig_one_clutch_plant_params, flange2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_damping is outside its range", offsetof(shift_rig_one_clutch_plant_params, flange2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_inertia is outside its range", offsetof(shift_rig_one_clutch_plant_params, M2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_max is outside its range", offsetof(shift_rig_one_clutch_plant_params, M2_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_rated is outside its range", offsetof(shift_rig_one_clutch_plant_params, M2_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_inverter_dead_time is outside its range", offsetof(shift_rig_one_clutch_plant_params, M2_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M2_inverter_time_constant is outside its range", offsetof(shift_rig_one_clutch_plant_params, M2_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter standstill_speed is outside its range", offsetof(shift_rig_one_clutch_plant_params, standstill_speed), 0.0, DBL_MAX, 0, 0 },
    { "the parameter sample_time is outside its range", offsetof(shift_rig_one_clutch_plant_params, sample_time), 0.0, DBL_MAX, 1, 0 },
};

enum { limit_count = sizeof limits / sizeof limits[0] };

const char *shift_rig_one_clutch_plant_status_text(shift_rig_one_clutch_plant_status status)
{
    switch ((int)status) {
    case shift_rig_one_clutch_plant_ok:
        return "ok";
    case shift_rig_one_clutch_plant_mass_matrix:
        return "the inertia matrix is not positive definite";
    case shift_rig_one_clutch_plant_exponential_range:
        return "the parameters are too far from those that the code was emitted for; emit it again";
    case shift_rig_one_clutch_plant_friction_matrix:
        return "a mode of the bed is too fast for the step; make a stiff shaft rigid, or the step shorter";
    case shift_rig_one_clutch_plant_friction_unsolved:
        return "the friction torques are not exact";
    case shift_rig_one_clutch_plant_bad_capacity_gears_clutch:
        return "the capacity of gears.clutch is no number from 0 up; it was taken as 0";
    case shift_rig_one_clutch_plant_bad_input_M1_torque_ref:
        return "the input M1_torque_ref is not finite";
    case shift_rig_one_clutch_plant_bad_input_M2_torque_ref:
        return "the input M2_torque_ref is not finite";
    case shift_rig_one_clutch_plant_bad_input_gears_clutch_actuation:
        return "the input gears_clutch_actuation is outside its range 0 to 1";
    case shift_rig_one_clutch_plant_bad_input_gears_ratio:
        return "the input gears_ratio is outside its range 3.33333 to 5.50322";
    default:
        break;
    }
    const int limit = (int)status - 2000;
    return limit >= 0 && limit < limit_count ? limits[limit].text : "unknown status";
}

shift_rig_one_clutch_plant_status shift_rig_one_clutch_plant_init(shift_rig_one_clutch_plant_state *s, const shift_rig_one_clutch_plant_params *p)
{
    memset(s, 0, sizeof *s);
    s->gears_ratio_now = 5.503220611916264;
    return shift_rig_one_clutch_plant_update(s, p);
}

/* What follows from what every step may change: gears_ratio_now. */
static void refresh(shift_rig_one_clutch_plant_state *s, const shift_rig_one_clutch_plant_params *p)
{
    (void)p;
    /* Gamma_T = Gamma_z G' */
    s->gamma[0][0] = s->gamma_pressed[0][0] - s->gamma_pressed[1][0] * s->gears_ratio_now;
    s->gamma[0][1] = s->gamma_pressed[0][1] - s->gamma_pressed[1][1] * s->gears_ratio_now;
    s->gamma[0][2] = s->gamma_pressed[0][2] - s->gamma_pressed[1][2] * s->gears_ratio_now;
    s->gamma[0][3] = s->gamma_pressed[0][3] - s->gamma_pressed[1][3] * s->gears_ratio_now;
    s->gamma[0][4] = s->gamma_pressed[0][4] - s->gamma_pressed[1][4] * s->gears_ratio_now;
    s->gamma[0][5] = s->gamma_pressed[0][5] - s->gamma_pressed[1][5] * s->gears_ratio_now;
    s->gamma[0][6] = s->gamma_pressed[0][6] - s->gamma_pressed[1][6] * s->gears_ratio_now;
    s->gamma[0][7] = s->gamma_pressed[0][7] - s->gamma_pressed[1][7] * s->gears_ratio_now;
    s->gamma[0][8] = s->gamma_pressed[0][8] - s->gamma_pressed[1][8] * s->gears_ratio_now;
    s->gamma[0][9] = s->gamma_pressed[0][9] - s->gamma_pressed[1][9] * s->gears_ratio_now;
    s->gamma[0][10] = s->gamma_pressed[0][10] - s->gamma_pressed[1][10] * s->gears_ratio_now;
    s->gamma[0][11] = s->gamma_pressed[0][11] - s->gamma_pressed[1][11] * s->gears_ratio_now;
    /* K = G K_z G' */
    s->K[0][0] = s->K_base[0][0] - s->K_base[1][0] * s->gears_ratio_now - s->K_base[0][1] * s->gears_ratio_now +
        s->K_base[1][1] * (s->gears_ratio_now * s->gears_ratio_now);
}

shift_rig_one_clutch_plant_status shift_rig_one_clutch_plant_update(shift_rig_one_clutch_plant_state *s, const shift_rig_one_clutch_plant_params *p)
{
    for (int k = 0; k < limit_count; ++k) {
        const shift_rig_one_clutch_real value = *(const shift_rig_one_clutch_real *)(const void *)((const char *)p + limits[k].offset);
        const int above = limits[k].open ? value > limits[k].least : value >= limits[k].least; /* false for NaN */
        if (!(above && value <= limits[k].most) || (limits[k].not_zero && value == 0.0)) {
            return (shift_rig_one_clutch_plant_status)(2000 + k);
        }
    }
    memset(s->transition, 0, sizeof s->transition);
    memset(s->gamma, 0, sizeof s->gamma);
    memset(s->K, 0, sizeof s->K);
    memset(s->gamma_pressed, 0, sizeof s->gamma_pressed);
    memset(s->K_base, 0, sizeof s->K_base);
    shift_rig_one_clutch_real mass[6][8];
    shift_rig_one_clutch_real forces[14][8];
    shift_rig_one_clutch_real A[16][12];
    shift_rig_one_clutch_real scale[16];
    shift_rig_one_clutch_real whole[16][12];
    shift_rig_one_clutch_real late[16][12];
    shift_rig_one_clutch_real early[16][12];
    shift_rig_one_clutch_real rates[14][8];
    shift_rig_one_clutch_zero(sizeof mass, mass);
    shift_rig_one_clutch_zero(sizeof forces, forces);
    shift_rig_one_clutch_zero(sizeof A, A);
    shift_rig_one_clutch_zero(sizeof scale, scale);
    shift_rig_one_clutch_zero(sizeof whole, whole);
    shift_rig_one_clutch_zero(sizeof late, late);
    shift_rig_one_clutch_zero(sizeof early, early);
    shift_rig_one_clutch_zero(sizeof rates, rates);
    
    /* M = S' I S */
    mass[0][0] = p->M1_inertia;
    mass[1][1] = p->M2_inertia;
    mass[2][2] = p->flange1_inertia;
    mass[3][3] = p->gears_inertia_input;
    mass[4][4] = p->gears_inertia_output;
    mass[5][5] = p->flange2_inertia;
    /* M dz/dt = B' u - E'(C e + D E z) - G'(T + k_v G z) */
    forces[0][0] = -p->flange1_damping;
    forces[2][0] = p->flange1_damping;
    forces[6][0] = -p->flange1_stiffness;
    forces[10][0] = 1.0;
    forces[1][1] = -p->flange2_damping;
    forces[5][1] = p->flange2_damping;
    forces[9][1] = -p->flange2_stiffness;
    forces[11][1] = 1.0;
    forces[0][2] = p->flange1_damping;
    forces[2][2] = -p->flange1_damping - p->shaft1_damping;
    forces[3][2] = p->shaft1_damping;
    forces[6][2] = p->flange1_stiffness;
    forces[7][2] = -p->shaft1_stiffness;
    forces[2][3] = p->shaft1_damping;
    forces[3][3] = -p->shaft1_damping;
    forces[7][3] = p->shaft1_stiffness;
    forces[12][3] = -1.0;
    forces[4][4] = -p->shaft2_damping;
    forces[5][4] = p->shaft2_damping;
    forces[8][4] = -p->shaft2_stiffness;
    forces[13][4] = -1.0;
    forces[1][5] = p->flange2_damping;
    forces[4][5] = p->shaft2_damping;
    forces[5][5] = -p->flange2_damping - p->shaft2_damping;
    forces[8][5] = p->shaft2_stiffness;
    forces[9][5] = p->flange2_stiffness;
    if (!shift_rig_one_clutch_cholesky_solve(6, 14, &mass[0][0], &forces[0][0], &rates[0][0])) {
        return shift_rig_one_clutch_plant_mass_matrix;
    }
    shift_rig_one_clutch_insert(6, 12, 8, 0, 0, 0, 10, &A[0][0], &rates[0][0]);
    /* de/dt = E z */
    A[0][6] = 1.0;
    A[2][6] = -1.0;
    A[2][7] = 1.0;
    A[3][7] = -1.0;
    A[4][8] = 1.0;
    A[5][8] = -1.0;
    A[1][9] = 1.0;
    A[5][9] = -1.0;
    shift_rig_one_clutch_insert(6, 12, 8, 0, 10, 10, 1, &A[0][0], &rates[0][0]);
    /* lag of the torque loop */
    A[10][10] = -1.0 / p->M1_inverter_time_constant;
    A[12][10] = 1.0 / p->M1_inverter_time_constant;
    shift_rig_one_clutch_insert(6, 12, 8, 0, 11, 11, 1, &A[0][0], &rates[0][0]);
    A[11][11] = -1.0 / p->M2_inverter_time_constant;
    A[13][11] = 1.0 / p->M2_inverter_time_constant;
    shift_rig_one_clutch_insert(6, 12, 8, 0, 14, 12, 2, &A[0][0], &rates[0][0]);
    scale[0] = 1.0;
    scale[1] = 1.0;
    scale[2] = 1.0;
    scale[3] = 1.0;
    scale[4] = 1.0;
    scale[5] = 1.0;
    scale[6] = p->sample_time;
    scale[7] = p->sample_time;
    scale[8] = p->sample_time;
    scale[9] = p->sample_time;
    scale[10] = 1.0;
    scale[11] = 1.0;
    scale[12] = 1.0;
    scale[13] = 1.0;
    scale[14] = 1.0;
    scale[15] = 1.0;
    /* exact discretisation */
    if (!shift_rig_one_clutch_discretise(12, 16, 5, &A[0][0], scale, p->sample_time, &whole[0][0])) {
        return shift_rig_one_clutch_plant_exponential_range;
    }
    shift_rig_one_clutch_insert(12, 12, 12, 0, 0, 0, 12, &s->transition[0][0], &whole[0][0]);
    /* dead time = (d + f) h */
    s->M1_dead_steps = shift_rig_one_clutch_floor(p->M1_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const shift_rig_one_clutch_real M1_late_time = p->sample_time - shift_rig_one_clutch_max(0.0, -s->M1_dead_steps
        * p->sample_time + p->M1_inverter_dead_time);
    if (!shift_rig_one_clutch_discretise(12, 16, 5, &A[0][0], scale, M1_late_time, &late[0][0])) {
        return shift_rig_one_clutch_plant_exponential_range;
    }
    shift_rig_one_clutch_difference(12, 16, &whole[0][0], &late[0][0], &early[0][0]);
    shift_rig_one_clutch_insert(12, 12, 12, 0, 12, 12, 1, &s->transition[0][0], &late[0][0]);
    shift_rig_one_clutch_insert(12, 12, 12, 0, 14, 12, 1, &s->transition[0][0], &early[0][0]);
    /* dead time = (d + f) h */
    s->M2_dead_steps = shift_rig_one_clutch_floor(p->M2_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const shift_rig_one_clutch_real M2_late_time = p->sample_time - shift_rig_one_clutch_max(0.0, -s->M2_dead_steps
        * p->sample_time + p->M2_inverter_dead_time);
    if (!shift_rig_one_clutch_discretise(12, 16, 5, &A[0][0], scale, M2_late_time, &late[0][0])) {
        return shift_rig_one_clutch_plant_exponential_range;
    }
    shift_rig_one_clutch_difference(12, 16, &whole[0][0], &late[0][0], &early[0][0]);
    shift_rig_one_clutch_insert(12, 12, 12, 0, 13, 13, 1, &s->transition[0][0], &late[0][0]);
    shift_rig_one_clutch_insert(12, 12, 12, 0, 15, 13, 1, &s->transition[0][0], &early[0][0]);
    shift_rig_one_clutch_insert(12, 12, 12, 0, 0, 14, 2, &s->gamma_pressed[0][0], &whole[0][0]);
    /* K = -G Gamma_f, also on pressed coordinates */
    s->K_base[0][0] = -whole[14][3];
    s->K_base[1][0] = -whole[15][3];
    s->K_base[0][1] = -whole[14][4];
    s->K_base[1][1] = -whole[15][4];
    /* of a sum of velocities */
    shift_rig_one_clutch_rounding_unit(&s->velocity_rounding);
    /* friction can be solved */
    if (!shift_rig_one_clutch_require_definite(2, 0, &s->K_base[0][0])) {
        return shift_rig_one_clutch_plant_friction_matrix;
    }
    refresh(s, p);
    return shift_rig_one_clutch_plant_ok;
}

void shift_rig_one_clutch_plant_measure(const shift_rig_one_clutch_plant_state *s, const shift_rig_one_clutch_plant_params *p, shift_rig_one_clutch_plant_outputs *out)
{
    out->M1_speed = s->x[0];
    out->flange1_torque = p->flange1_damping * s->x[0] - p->flange1_damping * s->x[2] + p->flange1_stiffness *
        s->x[6];
    out->flange2_torque = -p->flange2_damping * s->x[1] + p->flange2_damping * s->x[5] - p->flange2_stiffness *
        s->x[9];
    out->M2_speed = s->x[1];
    out->M1_torque = s->x[10];
    out->M2_torque = s->x[11];
    out->gears_clutch_speed = shift_rig_one_clutch_select(shift_rig_one_clutch_abs(s->gears_ratio_now * s->x[4] -
        s->x[3]) < p->standstill_speed + s->velocity_rounding * (shift_rig_one_clutch_abs(s->x[3]) +
        shift_rig_one_clutch_abs(s->gears_ratio_now * s->x[4])), 0.0, -s->gears_ratio_now * s->x[4] + s->x[3]);
    out->gears_clutch_torque = s->friction_torque[0];
}

/* Status of the first input that is not finite or outside its range. */
static int check_inputs(const shift_rig_one_clutch_plant_inputs *in)
{
    if (!shift_rig_one_clutch_is_finite(in->M1_torque_ref)) {
        return (int)shift_rig_one_clutch_plant_bad_input_M1_torque_ref;
    }
    if (!shift_rig_one_clutch_is_finite(in->M2_torque_ref)) {
        return (int)shift_rig_one_clutch_plant_bad_input_M2_torque_ref;
    }
    if (!(in->gears_clutch_actuation >= 0.0 && in->gears_clutch_actuation <= 1.0)) {
        return (int)shift_rig_one_clutch_plant_bad_input_gears_clutch_actuation;
    }
    if (!(in->gears_ratio >= 3.3333333333333335 && in->gears_ratio <= 5.503220611916264)) {
        return (int)shift_rig_one_clutch_plant_bad_input_gears_ratio;
    }
    return 0;
}

shift_rig_one_clutch_plant_status shift_rig_one_clutch_plant_step(shift_rig_one_clutch_plant_state *s, const shift_rig_one_clutch_plant_params *p,
    const shift_rig_one_clutch_plant_inputs *in, shift_rig_one_clutch_plant_outputs *out)
{
    const int bad = check_inputs(in);
    if (bad != 0) {
        shift_rig_one_clutch_plant_measure(s, p, out);
        return (shift_rig_one_clutch_plant_status)bad;
    }
    if (in->gears_ratio != s->gears_ratio_now) {
        s->gears_ratio_now = in->gears_ratio;
        refresh(s, p);
    }
    shift_rig_one_clutch_real x_free[12];
    shift_rig_one_clutch_real mean_torque[4];
    shift_rig_one_clutch_real w_start[4];
    shift_rig_one_clutch_real w_free[4];
    shift_rig_one_clutch_real w_plus[4];
    shift_rig_one_clutch_real slide[4];
    shift_rig_one_clutch_real rest[4];
    shift_rig_one_clutch_real friction_mean[4];
    shift_rig_one_clutch_zero(sizeof x_free, x_free);
    shift_rig_one_clutch_zero(sizeof mean_torque, mean_torque);
    shift_rig_one_clutch_zero(sizeof w_start, w_start);
    shift_rig_one_clutch_zero(sizeof w_free, w_free);
    shift_rig_one_clutch_zero(sizeof w_plus, w_plus);
    shift_rig_one_clutch_zero(sizeof slide, slide);
    shift_rig_one_clutch_zero(sizeof rest, rest);
    shift_rig_one_clutch_zero(sizeof friction_mean, friction_mean);
    
    /* torque-speed envelope, Figure 7.1 */
    const shift_rig_one_clutch_real M1_available = p->M1_speed_rated * p->M1_torque_max /
        shift_rig_one_clutch_max(p->M1_speed_rated, shift_rig_one_clutch_abs(s->x[0]));
    const shift_rig_one_clutch_real M1_limited = shift_rig_one_clutch_max(-M1_available,
        shift_rig_one_clutch_min(M1_available, in->M1_torque_ref));
    /* dead time of the torque loop */
    shift_rig_one_clutch_delay(16, s->M1_delay, M1_limited, s->M1_dead_steps, &s->x[12], &s->x[14]);
    /* torque-speed envelope, Figure 7.1 */
    const shift_rig_one_clutch_real M2_available = p->M2_speed_rated * p->M2_torque_max /
        shift_rig_one_clutch_max(p->M2_speed_rated, shift_rig_one_clutch_abs(s->x[1]));
    const shift_rig_one_clutch_real M2_limited = shift_rig_one_clutch_max(-M2_available,
        shift_rig_one_clutch_min(M2_available, in->M2_torque_ref));
    /* dead time of the torque loop */
    shift_rig_one_clutch_delay(16, s->M2_delay, M2_limited, s->M2_dead_steps, &s->x[13], &s->x[15]);
    /* x+ = Phi x + Gamma_u u */
    shift_rig_one_clutch_multiply(12, 16, &s->transition[0][0], s->x, x_free);
    /* w = G z */
    w_start[0] = shift_rig_one_clutch_select(shift_rig_one_clutch_abs(s->gears_ratio_now * s->x[4] - s->x[3]) <
        p->standstill_speed + s->velocity_rounding * (shift_rig_one_clutch_abs(s->x[3]) +
        shift_rig_one_clutch_abs(s->gears_ratio_now * s->x[4])), 0.0, -s->gears_ratio_now * s->x[4] + s->x[3]);
    /* speed at mid-step */
    const shift_rig_one_clutch_real gears_clutch_mid_speed = (0.5) * shift_rig_one_clutch_abs(s->friction_torque[0]
        * s->gamma[0][3] - s->gears_ratio_now * (s->friction_torque[0] * s->gamma[0][4] + x_free[4]) + w_start[0] +
        x_free[3]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[0] = in->gears_clutch_actuation * (p->gears_clutch_capacity + gears_clutch_mid_speed *
        p->gears_clutch_viscous);
    rest[0] = in->gears_clutch_actuation * p->gears_clutch_capacity;
    /* w_free = G z_free */
    w_free[0] = -s->gears_ratio_now * x_free[4] + x_free[3];
    /* what sticks, slips and passes zero */
    shift_rig_one_clutch_friction_step(0, 0, &s->K[0][0], w_start, w_free, slide, rest, s->friction_torque,
        s->friction_rest, friction_mean, w_plus, &s->friction_status);
    mean_torque[0] = friction_mean[0];
    /* x+ = x_free + Gamma_f T */
    shift_rig_one_clutch_add_product(12, 1, s->x, x_free, &s->gamma[0][0], mean_torque);
    shift_rig_one_clutch_plant_measure(s, p, out);
    if (s->friction_status == SHIFT_RIG_ONE_CLUTCH_REAL(-1)) {
        return shift_rig_one_clutch_plant_friction_unsolved;
    }
    if (s->friction_status == SHIFT_RIG_ONE_CLUTCH_REAL(1)) {
        return shift_rig_one_clutch_plant_bad_capacity_gears_clutch;
    }
    return shift_rig_one_clutch_plant_ok;
}
