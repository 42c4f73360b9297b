/*
 * differential_governed_plant.c: plant of the bed differential_governed
 *
 * Emitted by ptgen 0.1.0 from differential-governed.toml (SHA-256 acf552a043b195e0), template block.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "differential_governed_plant.h"
#include "differential_governed_friction.h"

#include <float.h>
#include <string.h>

const differential_governed_plant_params differential_governed_plant_defaults = {
    .M1_inertia = 1.0,
    .M1_torque_max = 930.0,
    .M1_speed_rated = 699.946843219806,
    .M1_inverter_dead_time = 0.0001,
    .M1_inverter_time_constant = 0.00025,
    .flange1_inertia = 0.032,
    .flange1_stiffness = 380000.0,
    .flange1_damping = 0.5,
    .cardan1_stiffness = 57000.0,
    .cardan1_damping = 2.0,
    .diff_loss_coulomb = 2.0,
    .diff_loss_load = 0.01,
    .diff_loss_viscous = 0.002,
    .diff_limited_slip_coulomb = 20.0,
    .diff_limited_slip_load = 0.15,
    .diff_limited_slip_viscous = 0.05,
    .diff_ratio = 1.91,
    .diff_inertia = 0.022,
    .diff_inertia_pinion = 0.04,
    .diff_pinion_ratio = 1.0,
    .cardan2_stiffness = 57000.0,
    .cardan2_damping = 2.0,
    .flange2_inertia = 0.032,
    .flange2_stiffness = 220000.0,
    .flange2_damping = 0.5,
    .M2_inertia = 10.3,
    .M2_torque_max = 3700.0,
    .M2_speed_rated = 188.495559215388,
    .M2_inverter_dead_time = 0.0001,
    .M2_inverter_time_constant = 0.00025,
    .cardan3_stiffness = 57000.0,
    .cardan3_damping = 2.0,
    .flange3_inertia = 0.029,
    .flange3_stiffness = 220000.0,
    .flange3_damping = 0.5,
    .M3_inertia = 10.3,
    .M3_torque_max = 3700.0,
    .M3_speed_rated = 188.495559215388,
    .M3_inverter_dead_time = 0.0001,
    .M3_inverter_time_constant = 0.00025,
    .standstill_speed = 1e-09,
    .sample_time = 0.0001,
};

/* Range of each parameter; `open` excludes the lower bound. The order is that of the status codes. */
static const struct {
    const char *text;
    size_t offset;
    differential_governed_real least;
    differential_governed_real most;
    int open;
    int not_zero;
} limits[] = {
    { "the parameter M1_inertia is outside its range", offsetof(differential_governed_plant_params, M1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_max is outside its range", offsetof(differential_governed_plant_params, M1_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_rated is outside its range", offsetof(differential_governed_plant_params, M1_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_inverter_dead_time is outside its range", offsetof(differential_governed_plant_params, M1_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M1_inverter_time_constant is outside its range", offsetof(differential_governed_plant_params, M1_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_inertia is outside its range", offsetof(differential_governed_plant_params, flange1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_stiffness is outside its range", offsetof(differential_governed_plant_params, flange1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_damping is outside its range", offsetof(differential_governed_plant_params, flange1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter cardan1_stiffness is outside its range", offsetof(differential_governed_plant_params, cardan1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter cardan1_damping is outside its range", offsetof(differential_governed_plant_params, cardan1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_loss_coulomb is outside its range", offsetof(differential_governed_plant_params, diff_loss_coulomb), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_loss_load is outside its range", offsetof(differential_governed_plant_params, diff_loss_load), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_loss_viscous is outside its range", offsetof(differential_governed_plant_params, diff_loss_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_limited_slip_coulomb is outside its range", offsetof(differential_governed_plant_params, diff_limited_slip_coulomb), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_limited_slip_load is outside its range", offsetof(differential_governed_plant_params, diff_limited_slip_load), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_limited_slip_viscous is outside its range", offsetof(differential_governed_plant_params, diff_limited_slip_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_ratio is outside its range", offsetof(differential_governed_plant_params, diff_ratio), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter diff_inertia is outside its range", offsetof(differential_governed_plant_params, diff_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter diff_inertia_pinion is outside its range", offsetof(differential_governed_plant_params, diff_inertia_pinion), 0.0, DBL_MAX, 1, 0 },
    { "the parameter diff_pinion_ratio is outside its range", offsetof(differential_governed_plant_params, diff_pinion_ratio), 0.0, DBL_MAX, 1, 0 },
    { "the parameter cardan2_stiffness is outside its range", offsetof(differential_governed_plant_params, cardan2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter cardan2_damping is outside its range", offsetof(differential_governed_plant_params, cardan2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter flange2_inertia is outside its range", offsetof(differential_governed_plant_params, flange2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_stiffness is outside its range", offsetof(differential_governed_plant_params, flange2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_damping is outside its range", offsetof(differential_governed_plant_params, flange2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_inertia is outside its range", offsetof(differential_governed_plant_params, M2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_max is outside its range", offsetof(differential_governed_plant_params, M2_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_rated is outside its range", offsetof(differential_governed_plant_params, M2_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_inverter_dead_time is outside its range", offsetof(differential_governed_plant_params, M2_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M2_inverter_time_constant is outside its range", offsetof(differential_governed_plant_params, M2_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter cardan3_stiffness is outside its range", offsetof(differential_governed_plant_params, cardan3_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter cardan3_damping is outside its range", offsetof(differential_governed_plant_params, cardan3_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter flange3_inertia is outside its range", offsetof(differential_governed_plant_params, flange3_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_stiffness is outside its range", offsetof(differential_governed_plant_params, flange3_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_damping is outside its range", offsetof(differential_governed_plant_params, flange3_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M3_inertia is outside its range", offsetof(differential_governed_plant_params, M3_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_torque_max is outside its range", offsetof(differential_governed_plant_params, M3_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_rated is outside its range", offsetof(differential_governed_plant_params, M3_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_inverter_dead_time is outside its range", offsetof(differential_governed_plant_params, M3_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M3_inverter_time_constant is outside its range", offsetof(differential_governed_plant_params, M3_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter standstill_speed is outside its range", offsetof(differential_governed_plant_params, standstill_speed), 0.0, DBL_MAX, 0, 0 },
    { "the parameter sample_time is outside its range", offsetof(differential_governed_plant_params, sample_time), 0.0, DBL_MAX, 1, 0 },
};

enum { limit_count = sizeof limits / sizeof limits[0] };

const char *differential_governed_plant_status_text(differential_governed_plant_status status)
{
    switch ((int)status) {
    case differential_governed_plant_ok:
        return "ok";
    case differential_governed_plant_mass_matrix:
        return "the inertia matrix is not positive definite";
    case differential_governed_plant_exponential_range:
        return "the parameters are too far from those that the code was emitted for; emit it again";
    case differential_governed_plant_friction_matrix:
        return "a mode of the bed is too fast for the step; make a stiff shaft rigid, or the step shorter";
    case differential_governed_plant_friction_unsolved:
        return "the friction torques are not exact";
    case differential_governed_plant_bad_capacity_diff_loss:
        return "the capacity of diff.loss is no number from 0 up; it was taken as 0";
    case differential_governed_plant_bad_capacity_diff_limited_slip:
        return "the capacity of diff.limited_slip is no number from 0 up; it was taken as 0";
    case differential_governed_plant_bad_input_M1_torque_ref:
        return "the input M1_torque_ref is not finite";
    case differential_governed_plant_bad_input_M2_torque_ref:
        return "the input M2_torque_ref is not finite";
    case differential_governed_plant_bad_input_M3_torque_ref:
        return "the input M3_torque_ref is not finite";
    default:
        break;
    }
    const int limit = (int)status - 2000;
    return limit >= 0 && limit < limit_count ? limits[limit].text : "unknown status";
}

differential_governed_plant_status differential_governed_plant_init(differential_governed_plant_state *s, const differential_governed_plant_params *p)
{
    memset(s, 0, sizeof *s);
    return differential_governed_plant_update(s, p);
}

differential_governed_plant_status differential_governed_plant_update(differential_governed_plant_state *s, const differential_governed_plant_params *p)
{
    for (int k = 0; k < limit_count; ++k) {
        const differential_governed_real value = *(const differential_governed_real *)(const void *)((const char *)p + limits[k].offset);
        const int above = limits[k].open ? value > limits[k].least : value >= limits[k].least; /* false for NaN */
        if (!(above && value <= limits[k].most) || (limits[k].not_zero && value == 0.0)) {
            return (differential_governed_plant_status)(2000 + k);
        }
    }
    memset(s->transition, 0, sizeof s->transition);
    memset(s->gamma, 0, sizeof s->gamma);
    memset(s->K, 0, sizeof s->K);
    differential_governed_real mass[8][8];
    differential_governed_real forces[19][8];
    differential_governed_real A[22][20];
    differential_governed_real scale[24];
    differential_governed_real whole[22][20];
    differential_governed_real late[22][20];
    differential_governed_real early[22][20];
    differential_governed_real rates[19][8];
    differential_governed_zero(sizeof mass, mass);
    differential_governed_zero(sizeof forces, forces);
    differential_governed_zero(sizeof A, A);
    differential_governed_zero(sizeof scale, scale);
    differential_governed_zero(sizeof whole, whole);
    differential_governed_zero(sizeof late, late);
    differential_governed_zero(sizeof early, early);
    differential_governed_zero(sizeof rates, rates);
    
    /* M = S' I S */
    mass[0][0] = p->diff_inertia;
    mass[1][1] = p->diff_inertia_pinion * p->diff_pinion_ratio;
    mass[2][2] = p->M1_inertia;
    mass[3][3] = p->M2_inertia;
    mass[4][4] = p->M3_inertia;
    mass[5][5] = p->flange1_inertia;
    mass[6][6] = p->flange2_inertia;
    mass[7][7] = p->flange3_inertia;
    /* M dz/dt = B' u - E'(C e + D E z) - G'(T + k_v G z) */
    forces[0][0] = -p->cardan1_damping - p->cardan2_damping / (p->diff_ratio * p->diff_ratio) - p->cardan3_damping /
        (p->diff_ratio * p->diff_ratio) - p->diff_loss_viscous;
    forces[1][0] = -p->cardan2_damping * p->diff_pinion_ratio / p->diff_ratio + p->cardan3_damping *
        p->diff_pinion_ratio / p->diff_ratio;
    forces[5][0] = p->cardan1_damping;
    forces[6][0] = p->cardan2_damping / p->diff_ratio;
    forces[7][0] = p->cardan3_damping / p->diff_ratio;
    forces[9][0] = p->cardan1_stiffness;
    forces[10][0] = -p->cardan2_stiffness / (p->diff_ratio * p->diff_ratio);
    forces[12][0] = -p->cardan3_stiffness / (p->diff_ratio * p->diff_ratio);
    forces[17][0] = -1.0;
    forces[0][1] = -p->cardan2_damping * p->diff_pinion_ratio / p->diff_ratio + p->cardan3_damping *
        p->diff_pinion_ratio / p->diff_ratio;
    forces[1][1] = -p->cardan2_damping * (p->diff_pinion_ratio * p->diff_pinion_ratio) - p->cardan3_damping *
        (p->diff_pinion_ratio * p->diff_pinion_ratio) - p->diff_limited_slip_viscous;
    forces[6][1] = p->cardan2_damping * p->diff_pinion_ratio;
    forces[7][1] = -p->cardan3_damping * p->diff_pinion_ratio;
    forces[10][1] = -p->cardan2_stiffness * p->diff_pinion_ratio / p->diff_ratio;
    forces[12][1] = p->cardan3_stiffness * p->diff_pinion_ratio / p->diff_ratio;
    forces[18][1] = -1.0;
    forces[2][2] = -p->flange1_damping;
    forces[5][2] = p->flange1_damping;
    forces[8][2] = -p->flange1_stiffness;
    forces[14][2] = 1.0;
    forces[3][3] = -p->flange2_damping;
    forces[6][3] = p->flange2_damping;
    forces[11][3] = -p->flange2_stiffness;
    forces[15][3] = 1.0;
    forces[4][4] = -p->flange3_damping;
    forces[7][4] = p->flange3_damping;
    forces[13][4] = -p->flange3_stiffness;
    forces[16][4] = 1.0;
    forces[0][5] = p->cardan1_damping;
    forces[2][5] = p->flange1_damping;
    forces[5][5] = -p->cardan1_damping - p->flange1_damping;
    forces[8][5] = p->flange1_stiffness;
    forces[9][5] = -p->cardan1_stiffness;
    forces[0][6] = p->cardan2_damping / p->diff_ratio;
    forces[1][6] = p->cardan2_damping * p->diff_pinion_ratio;
    forces[3][6] = p->flange2_damping;
    forces[6][6] = -p->cardan2_damping - p->flange2_damping;
    forces[10][6] = p->cardan2_stiffness / p->diff_ratio;
    forces[11][6] = p->flange2_stiffness;
    forces[0][7] = p->cardan3_damping / p->diff_ratio;
    forces[1][7] = -p->cardan3_damping * p->diff_pinion_ratio;
    forces[4][7] = p->flange3_damping;
    forces[7][7] = -p->cardan3_damping - p->flange3_damping;
    forces[12][7] = p->cardan3_stiffness / p->diff_ratio;
    forces[13][7] = p->flange3_stiffness;
    if (!differential_governed_cholesky_solve(8, 19, &mass[0][0], &forces[0][0], &rates[0][0])) {
        return differential_governed_plant_mass_matrix;
    }
    differential_governed_insert(8, 20, 8, 0, 0, 0, 14, &A[0][0], &rates[0][0]);
    /* de/dt = E z */
    A[2][8] = 1.0;
    A[5][8] = -1.0;
    A[0][9] = -1.0;
    A[5][9] = 1.0;
    A[0][10] = 1.0;
    A[1][10] = p->diff_pinion_ratio * p->diff_ratio;
    A[6][10] = -p->diff_ratio;
    A[3][11] = 1.0;
    A[6][11] = -1.0;
    A[0][12] = 1.0;
    A[1][12] = -p->diff_pinion_ratio * p->diff_ratio;
    A[7][12] = -p->diff_ratio;
    A[4][13] = 1.0;
    A[7][13] = -1.0;
    differential_governed_insert(8, 20, 8, 0, 14, 14, 1, &A[0][0], &rates[0][0]);
    /* lag of the torque loop */
    A[14][14] = -1.0 / p->M1_inverter_time_constant;
    A[17][14] = 1.0 / p->M1_inverter_time_constant;
    differential_governed_insert(8, 20, 8, 0, 15, 15, 1, &A[0][0], &rates[0][0]);
    A[15][15] = -1.0 / p->M2_inverter_time_constant;
    A[18][15] = 1.0 / p->M2_inverter_time_constant;
    differential_governed_insert(8, 20, 8, 0, 16, 16, 1, &A[0][0], &rates[0][0]);
    A[16][16] = -1.0 / p->M3_inverter_time_constant;
    A[19][16] = 1.0 / p->M3_inverter_time_constant;
    differential_governed_insert(8, 20, 8, 0, 20, 17, 2, &A[0][0], &rates[0][0]);
    scale[0] = 1.0;
    scale[1] = 1.0;
    scale[2] = 1.0;
    scale[3] = 1.0;
    scale[4] = 1.0;
    scale[5] = 1.0;
    scale[6] = 1.0;
    scale[7] = 1.0;
    scale[8] = p->sample_time;
    scale[9] = p->sample_time;
    scale[10] = p->sample_time;
    scale[11] = p->sample_time;
    scale[12] = p->sample_time;
    scale[13] = p->sample_time;
    scale[14] = 1.0;
    scale[15] = 1.0;
    scale[16] = 1.0;
    scale[17] = 1.0;
    scale[18] = 1.0;
    scale[19] = 1.0;
    scale[20] = 1.0;
    scale[21] = 1.0;
    /* exact discretisation */
    if (!differential_governed_discretise(17, 22, 5, &A[0][0], scale, p->sample_time, &whole[0][0])) {
        return differential_governed_plant_exponential_range;
    }
    differential_governed_insert(17, 20, 20, 0, 0, 0, 17, &s->transition[0][0], &whole[0][0]);
    /* dead time = (d + f) h */
    s->M1_dead_steps = differential_governed_floor(p->M1_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const differential_governed_real M1_late_time = p->sample_time - differential_governed_max(0.0,
        -s->M1_dead_steps * p->sample_time + p->M1_inverter_dead_time);
    if (!differential_governed_discretise(17, 22, 5, &A[0][0], scale, M1_late_time, &late[0][0])) {
        return differential_governed_plant_exponential_range;
    }
    differential_governed_difference(17, 22, &whole[0][0], &late[0][0], &early[0][0]);
    differential_governed_insert(17, 20, 20, 0, 17, 17, 1, &s->transition[0][0], &late[0][0]);
    differential_governed_insert(17, 20, 20, 0, 20, 17, 1, &s->transition[0][0], &early[0][0]);
    /* dead time = (d + f) h */
    s->M2_dead_steps = differential_governed_floor(p->M2_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const differential_governed_real M2_late_time = p->sample_time - differential_governed_max(0.0,
        -s->M2_dead_steps * p->sample_time + p->M2_inverter_dead_time);
    if (!differential_governed_discretise(17, 22, 5, &A[0][0], scale, M2_late_time, &late[0][0])) {
        return differential_governed_plant_exponential_range;
    }
    differential_governed_difference(17, 22, &whole[0][0], &late[0][0], &early[0][0]);
    differential_governed_insert(17, 20, 20, 0, 18, 18, 1, &s->transition[0][0], &late[0][0]);
    differential_governed_insert(17, 20, 20, 0, 21, 18, 1, &s->transition[0][0], &early[0][0]);
    /* dead time = (d + f) h */
    s->M3_dead_steps = differential_governed_floor(p->M3_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const differential_governed_real M3_late_time = p->sample_time - differential_governed_max(0.0,
        -s->M3_dead_steps * p->sample_time + p->M3_inverter_dead_time);
    if (!differential_governed_discretise(17, 22, 5, &A[0][0], scale, M3_late_time, &late[0][0])) {
        return differential_governed_plant_exponential_range;
    }
    differential_governed_difference(17, 22, &whole[0][0], &late[0][0], &early[0][0]);
    differential_governed_insert(17, 20, 20, 0, 19, 19, 1, &s->transition[0][0], &late[0][0]);
    differential_governed_insert(17, 20, 20, 0, 22, 19, 1, &s->transition[0][0], &early[0][0]);
    differential_governed_insert(17, 20, 20, 0, 0, 20, 2, &s->gamma[0][0], &whole[0][0]);
    /* K = -G Gamma_f */
    s->K[0][0] = -whole[20][0];
    s->K[1][0] = -whole[21][0];
    s->K[0][1] = -whole[20][1];
    s->K[1][1] = -whole[21][1];
    /* friction can be solved */
    if (!differential_governed_require_definite(2, 0, &s->K[0][0])) {
        return differential_governed_plant_friction_matrix;
    }
    return differential_governed_plant_ok;
}

void differential_governed_plant_measure(const differential_governed_plant_state *s, const differential_governed_plant_params *p, differential_governed_plant_outputs *out)
{
    out->M1_speed = s->x[2];
    out->flange1_torque = p->flange1_damping * s->x[2] - p->flange1_damping * s->x[5] + p->flange1_stiffness *
        s->x[8];
    out->flange2_torque = -p->flange2_damping * s->x[3] + p->flange2_damping * s->x[6] - p->flange2_stiffness *
        s->x[11];
    out->M2_speed = s->x[3];
    out->flange3_torque = -p->flange3_damping * s->x[4] + p->flange3_damping * s->x[7] - p->flange3_stiffness *
        s->x[13];
    out->M3_speed = s->x[4];
    out->diff_input_torque = -p->cardan1_damping * s->x[0] + p->cardan1_damping * s->x[5] + p->cardan1_stiffness *
        s->x[9];
    out->M1_torque = s->x[14];
    out->M2_torque = s->x[15];
    out->M3_torque = s->x[16];
    out->diff_loss_speed = s->x[0];
    out->diff_loss_torque = out->diff_loss_speed * p->diff_loss_viscous + s->friction_torque[0];
    out->diff_limited_slip_speed = s->x[1];
    out->diff_limited_slip_torque = out->diff_limited_slip_speed * p->diff_limited_slip_viscous +
        s->friction_torque[1];
}

/* Status of the first input that is not finite or outside its range. */
static int check_inputs(const differential_governed_plant_inputs *in)
{
    if (!differential_governed_is_finite(in->M1_torque_ref)) {
        return (int)differential_governed_plant_bad_input_M1_torque_ref;
    }
    if (!differential_governed_is_finite(in->M2_torque_ref)) {
        return (int)differential_governed_plant_bad_input_M2_torque_ref;
    }
    if (!differential_governed_is_finite(in->M3_torque_ref)) {
        return (int)differential_governed_plant_bad_input_M3_torque_ref;
    }
    return 0;
}

differential_governed_plant_status differential_governed_plant_step(differential_governed_plant_state *s, const differential_governed_plant_params *p,
    const differential_governed_plant_inputs *in, differential_governed_plant_outputs *out)
{
    const int bad = check_inputs(in);
    if (bad != 0) {
        differential_governed_plant_measure(s, p, out);
        return (differential_governed_plant_status)bad;
    }
    differential_governed_real x_free[20];
    differential_governed_real mean_torque[4];
    differential_governed_real w_start[4];
    differential_governed_real w_free[4];
    differential_governed_real w_plus[4];
    differential_governed_real slide[4];
    differential_governed_real rest[4];
    differential_governed_real friction_mean[4];
    differential_governed_zero(sizeof x_free, x_free);
    differential_governed_zero(sizeof mean_torque, mean_torque);
    differential_governed_zero(sizeof w_start, w_start);
    differential_governed_zero(sizeof w_free, w_free);
    differential_governed_zero(sizeof w_plus, w_plus);
    differential_governed_zero(sizeof slide, slide);
    differential_governed_zero(sizeof rest, rest);
    differential_governed_zero(sizeof friction_mean, friction_mean);
    
    /* torque-speed envelope, Figure 7.1 */
    const differential_governed_real M1_available = p->M1_speed_rated * p->M1_torque_max /
        differential_governed_max(p->M1_speed_rated, differential_governed_abs(s->x[2]));
    const differential_governed_real M1_limited = differential_governed_max(-M1_available,
        differential_governed_min(M1_available, in->M1_torque_ref));
    /* dead time of the torque loop */
    differential_governed_delay(16, s->M1_delay, M1_limited, s->M1_dead_steps, &s->x[17], &s->x[20]);
    /* torque-speed envelope, Figure 7.1 */
    const differential_governed_real M2_available = p->M2_speed_rated * p->M2_torque_max /
        differential_governed_max(p->M2_speed_rated, differential_governed_abs(s->x[3]));
    const differential_governed_real M2_limited = differential_governed_max(-M2_available,
        differential_governed_min(M2_available, in->M2_torque_ref));
    /* dead time of the torque loop */
    differential_governed_delay(16, s->M2_delay, M2_limited, s->M2_dead_steps, &s->x[18], &s->x[21]);
    /* torque-speed envelope, Figure 7.1 */
    const differential_governed_real M3_available = p->M3_speed_rated * p->M3_torque_max /
        differential_governed_max(p->M3_speed_rated, differential_governed_abs(s->x[4]));
    const differential_governed_real M3_limited = differential_governed_max(-M3_available,
        differential_governed_min(M3_available, in->M3_torque_ref));
    /* dead time of the torque loop */
    differential_governed_delay(16, s->M3_delay, M3_limited, s->M3_dead_steps, &s->x[19], &s->x[22]);
    const differential_governed_real diff_input_torque_start = -p->cardan1_damping * s->x[0] + p->cardan1_damping *
        s->x[5] + p->cardan1_stiffness * s->x[9];
    /* x+ = Phi x + Gamma_u u */
    differential_governed_multiply(17, 23, &s->transition[0][0], s->x, x_free);
    /* w = G z */
    w_start[0] = s->x[0];
    w_start[1] = s->x[1];
    /* predicted */
    const differential_governed_real diff_input_torque_end = -p->cardan1_damping * (s->friction_torque[0] *
        s->gamma[0][0] + s->friction_torque[1] * s->gamma[1][0] + x_free[0]) + p->cardan1_damping *
        (s->friction_torque[0] * s->gamma[0][5] + s->friction_torque[1] * s->gamma[1][5] + x_free[5]) +
        p->cardan1_stiffness * (s->friction_torque[0] * s->gamma[0][9] + s->friction_torque[1] * s->gamma[1][9] +
        x_free[9]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[0] = p->diff_loss_coulomb + p->diff_loss_load * differential_governed_abs((0.5) * diff_input_torque_end +
        (0.5) * diff_input_torque_start);
    rest[0] = p->diff_loss_coulomb + p->diff_loss_load * differential_governed_abs((0.5) * diff_input_torque_end +
        (0.5) * diff_input_torque_start);
    slide[1] = p->diff_limited_slip_coulomb + p->diff_limited_slip_load * differential_governed_abs((0.5) *
        diff_input_torque_end + (0.5) * diff_input_torque_start);
    rest[1] = p->diff_limited_slip_coulomb + p->diff_limited_slip_load * differential_governed_abs((0.5) *
        diff_input_torque_end + (0.5) * diff_input_torque_start);
    /* w_free = G z_free */
    w_free[0] = x_free[0];
    w_free[1] = x_free[1];
    /* what sticks, slips and passes zero */
    differential_governed_friction_step(0, 0, &s->K[0][0], w_start, w_free, slide, rest, s->friction_torque,
        s->friction_rest, friction_mean, w_plus, &s->friction_status);
    mean_torque[0] = friction_mean[0];
    mean_torque[1] = friction_mean[1];
    /* x+ = x_free + Gamma_f T */
    differential_governed_add_product(17, 2, s->x, x_free, &s->gamma[0][0], mean_torque);
    /* exactly zero while it sticks */
    s->x[0] = differential_governed_select(p->standstill_speed > differential_governed_abs(w_plus[0]), 0.0,
        w_plus[0]);
    s->x[1] = differential_governed_select(p->standstill_speed > differential_governed_abs(w_plus[1]), 0.0,
        w_plus[1]);
    differential_governed_plant_measure(s, p, out);
    if (s->friction_status == DIFFERENTIAL_GOVERNED_REAL(-1)) {
        return differential_governed_plant_friction_unsolved;
    }
    if (s->friction_status == DIFFERENTIAL_GOVERNED_REAL(1)) {
        return differential_governed_plant_bad_capacity_diff_loss;
    }
    if (s->friction_status == DIFFERENTIAL_GOVERNED_REAL(2)) {
        return differential_governed_plant_bad_capacity_diff_limited_slip;
    }
    return differential_governed_plant_ok;
}
