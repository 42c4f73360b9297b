/*
 * differential_gearboxes_plant.c: plant of the bed differential_gearboxes
 *
 * Emitted by ptgen 0.1.0 from differential-gearboxes.toml (SHA-256 08abf4d695c2194f), template block.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "differential_gearboxes_plant.h"
#include "differential_gearboxes_friction.h"

#include <float.h>
#include <string.h>

const differential_gearboxes_plant_params differential_gearboxes_plant_defaults = {
    .M1_inertia = 3.25,
    .M1_torque_max = 3700.0,
    .M1_speed_rated = 188.495559215388,
    .M1_inverter_dead_time = 0.0001,
    .M1_inverter_time_constant = 0.00025,
    .flange1_inertia = 0.032,
    .flange1_stiffness = 380000.0,
    .flange1_damping = 0.5,
    .shaft1_stiffness = 150000.0,
    .shaft1_damping = 5.0,
    .gearbox1_ratio = 8.1,
    .gearbox1_inertia = 1.05,
    .cardan1_stiffness = 33000.0,
    .cardan1_damping = 150.0,
    .diff_loss_coulomb = 5.0,
    .diff_loss_load = 0.02,
    .diff_loss_viscous = 0.05,
    .diff_limited_slip_coulomb = 0.5,
    .diff_limited_slip_load = 0.06,
    .diff_limited_slip_viscous = 0.06,
    .diff_ratio = 2.85,
    .diff_inertia = 0.3,
    .diff_inertia_pinion = 1.5,
    .diff_pinion_ratio = 1.0,
    .cardan2_stiffness = 240000.0,
    .cardan2_damping = 1100.0,
    .gearbox2_ratio = 10.4,
    .gearbox2_inertia = 1.65,
    .shaft2_stiffness = 150000.0,
    .shaft2_damping = 5.0,
    .flange2_inertia = 0.032,
    .flange2_stiffness = 220000.0,
    .flange2_damping = 0.5,
    .M2_inertia = 10.3,
    .M2_torque_max = 3700.0,
    .M2_speed_rated = 188.495559215388,
    .M2_inverter_dead_time = 0.0001,
    .M2_inverter_time_constant = 0.00025,
    .cardan3_stiffness = 240000.0,
    .cardan3_damping = 1100.0,
    .gearbox3_ratio = 10.4,
    .gearbox3_inertia = 1.65,
    .shaft3_stiffness = 150000.0,
    .shaft3_damping = 5.0,
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
    differential_gearboxes_real least;
    differential_gearboxes_real most;
    int open;
    int not_zero;
} limits[] = {
    { "the parameter M1_inertia is outside its range", offsetof(differential_gearboxes_plant_params, M1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_max is outside its range", offsetof(differential_gearboxes_plant_params, M1_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_rated is outside its range", offsetof(differential_gearboxes_plant_params, M1_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_inverter_dead_time is outside its range", offsetof(differential_gearboxes_plant_params, M1_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M1_inverter_time_constant is outside its range", offsetof(differential_gearboxes_plant_params, M1_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_inertia is outside its range", offsetof(differential_gearboxes_plant_params, flange1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_stiffness is outside its range", offsetof(differential_gearboxes_plant_params, flange1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_damping is outside its range", offsetof(differential_gearboxes_plant_params, flange1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter shaft1_stiffness is outside its range", offsetof(differential_gearboxes_plant_params, shaft1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft1_damping is outside its range", offsetof(differential_gearboxes_plant_params, shaft1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gearbox1_ratio is outside its range", offsetof(differential_gearboxes_plant_params, gearbox1_ratio), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter gearbox1_inertia is outside its range", offsetof(differential_gearboxes_plant_params, gearbox1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter cardan1_stiffness is outside its range", offsetof(differential_gearboxes_plant_params, cardan1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter cardan1_damping is outside its range", offsetof(differential_gearboxes_plant_params, cardan1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_loss_coulomb is outside its range", offsetof(differential_gearboxes_plant_params, diff_loss_coulomb), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_loss_load is outside its range", offsetof(differential_gearboxes_plant_params, diff_loss_load), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_loss_viscous is outside its range", offsetof(differential_gearboxes_plant_params, diff_loss_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_limited_slip_coulomb is outside its range", offsetof(differential_gearboxes_plant_params, diff_limited_slip_coulomb), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_limited_slip_load is outside its range", offsetof(differential_gearboxes_plant_params, diff_limited_slip_load), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_limited_slip_viscous is outside its range", offsetof(differential_gearboxes_plant_params, diff_limited_slip_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_ratio is outside its range", offsetof(differential_gearboxes_plant_params, diff_ratio), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter diff_inertia is outside its range", offsetof(differential_gearboxes_plant_params, diff_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter diff_inertia_pinion is outside its range", offsetof(differential_gearboxes_plant_params, diff_inertia_pinion), 0.0, DBL_MAX, 1, 0 },
    { "the parameter diff_pinion_ratio is outside its range", offsetof(differential_gearboxes_plant_params, diff_pinion_ratio), 0.0, DBL_MAX, 1, 0 },
    { "the parameter cardan2_stiffness is outside its range", offsetof(differential_gearboxes_plant_params, cardan2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter cardan2_damping is outside its range", offsetof(differential_gearboxes_plant_params, cardan2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gearbox2_ratio is outside its range", offsetof(differential_gearboxes_plant_params, gearbox2_ratio), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter gearbox2_inertia is outside its range", offsetof(differential_gearboxes_plant_params, gearbox2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft2_stiffness is outside its range", offsetof(differential_gearboxes_plant_params, shaft2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft2_damping is outside its range", offsetof(differential_gearboxes_plant_params, shaft2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter flange2_inertia is outside its range", offsetof(differential_gearboxes_plant_params, flange2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_stiffness is outside its range", offsetof(differential_gearboxes_plant_params, flange2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_damping is outside its range", offsetof(differential_gearboxes_plant_params, flange2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_inertia is outside its range", offsetof(differential_gearboxes_plant_params, M2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_max is outside its range", offsetof(differential_gearboxes_plant_params, M2_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_rated is outside its range", offsetof(differential_gearboxes_plant_params, M2_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_inverter_dead_time is outside its range", offsetof(differential_gearboxes_plant_params, M2_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M2_inverter_time_constant is outside its range", offsetof(differential_gearboxes_plant_params, M2_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter cardan3_stiffness is outside its range", offsetof(differential_gearboxes_plant_params, cardan3_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter cardan3_damping is outside its range", offsetof(differential_gearboxes_plant_params, cardan3_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gearbox3_ratio is outside its range", offsetof(differential_gearboxes_plant_params, gearbox3_ratio), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter gearbox3_inertia is outside its range", offsetof(differential_gearboxes_plant_params, gearbox3_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft3_stiffness is outside its range", offsetof(differential_gearboxes_plant_params, shaft3_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft3_damping is outside its range", offsetof(differential_gearboxes_plant_params, shaft3_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter flange3_inertia is outside its range", offsetof(differential_gearboxes_plant_params, flange3_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_stiffness is outside its range", offsetof(differential_gearboxes_plant_params, flange3_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_damping is outside its range", offsetof(differential_gearboxes_plant_params, flange3_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M3_inertia is outside its range", offsetof(differential_gearboxes_plant_params, M3_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_torque_max is outside its range", offsetof(differential_gearboxes_plant_params, M3_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_rated is outside its range", offsetof(differential_gearboxes_plant_params, M3_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_inverter_dead_time is outside its range", offsetof(differential_gearboxes_plant_params, M3_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M3_inverter_time_constant is outside its range", offsetof(differential_gearboxes_plant_params, M3_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter standstill_speed is outside its range", offsetof(differential_gearboxes_plant_params, standstill_speed), 0.0, DBL_MAX, 0, 0 },
    { "the parameter sample_time is outside its range", offsetof(differential_gearboxes_plant_params, sample_time), 0.0, DBL_MAX, 1, 0 },
};

enum { limit_count = sizeof limits / sizeof limits[0] };

const char *differential_gearboxes_plant_status_text(differential_gearboxes_plant_status status)
{
    switch ((int)status) {
    case differential_gearboxes_plant_ok:
        return "ok";
    case differential_gearboxes_plant_mass_matrix:
        return "the inertia matrix is not positive definite";
    case differential_gearboxes_plant_exponential_range:
        return "the parameters are too far from those that the code was emitted for; emit it again";
    case differential_gearboxes_plant_friction_matrix:
        return "a mode of the bed is too fast for the step; make a stiff shaft rigid, or the step shorter";
    case differential_gearboxes_plant_friction_unsolved:
        return "the friction torques are not exact";
    case differential_gearboxes_plant_bad_capacity_diff_loss:
        return "the capacity of diff.loss is no number from 0 up; it was taken as 0";
    case differential_gearboxes_plant_bad_capacity_diff_limited_slip:
        return "the capacity of diff.limited_slip is no number from 0 up; it was taken as 0";
    case differential_gearboxes_plant_bad_input_M1_torque_ref:
        return "the input M1_torque_ref is not finite";
    case differential_gearboxes_plant_bad_input_M2_torque_ref:
        return "the input M2_torque_ref is not finite";
    case differential_gearboxes_plant_bad_input_M3_torque_ref:
        return "the input M3_torque_ref is not finite";
    default:
        break;
    }
    const int limit = (int)status - 2000;
    return limit >= 0 && limit < limit_count ? limits[limit].text : "unknown status";
}

differential_gearboxes_plant_status differential_gearboxes_plant_init(differential_gearboxes_plant_state *s, const differential_gearboxes_plant_params *p)
{
    memset(s, 0, sizeof *s);
    return differential_gearboxes_plant_update(s, p);
}

differential_gearboxes_plant_status differential_gearboxes_plant_update(differential_gearboxes_plant_state *s, const differential_gearboxes_plant_params *p)
{
    for (int k = 0; k < limit_count; ++k) {
        const differential_gearboxes_real value = *(const differential_gearboxes_real *)(const void *)((const char *)p + limits[k].offset);
        const int above = limits[k].open ? value > limits[k].least : value >= limits[k].least; /* false for NaN */
        if (!(above && value <= limits[k].most) || (limits[k].not_zero && value == 0.0)) {
            return (differential_gearboxes_plant_status)(2000 + k);
        }
    }
    memset(s->transition, 0, sizeof s->transition);
    memset(s->gamma, 0, sizeof s->gamma);
    memset(s->K, 0, sizeof s->K);
    differential_gearboxes_real mass[11][12];
    differential_gearboxes_real forces[25][12];
    differential_gearboxes_real A[28][24];
    differential_gearboxes_real scale[28];
    differential_gearboxes_real whole[28][24];
    differential_gearboxes_real late[28][24];
    differential_gearboxes_real early[28][24];
    differential_gearboxes_real rates[25][12];
    differential_gearboxes_zero(sizeof mass, mass);
    differential_gearboxes_zero(sizeof forces, forces);
    differential_gearboxes_zero(sizeof A, A);
    differential_gearboxes_zero(sizeof scale, scale);
    differential_gearboxes_zero(sizeof whole, whole);
    differential_gearboxes_zero(sizeof late, late);
    differential_gearboxes_zero(sizeof early, early);
    differential_gearboxes_zero(sizeof rates, rates);
    
    /* M = S' I S */
    mass[0][0] = p->diff_inertia;
    mass[1][1] = p->diff_inertia_pinion * p->diff_pinion_ratio;
    mass[2][2] = p->M1_inertia;
    mass[3][3] = p->M2_inertia;
    mass[4][4] = p->M3_inertia;
    mass[5][5] = p->flange1_inertia;
    mass[6][6] = p->gearbox1_inertia;
    mass[7][7] = p->gearbox2_inertia;
    mass[8][8] = p->flange2_inertia;
    mass[9][9] = p->gearbox3_inertia;
    mass[10][10] = p->flange3_inertia;
    /* M dz/dt = B' u - E'(C e + D E z) - G'(T + k_v G z) */
    forces[0][0] = -p->cardan1_damping - p->cardan2_damping / (p->diff_ratio * p->diff_ratio) - p->cardan3_damping /
        (p->diff_ratio * p->diff_ratio) - p->diff_loss_viscous;
    forces[1][0] = -p->cardan2_damping * p->diff_pinion_ratio / p->diff_ratio + p->cardan3_damping *
        p->diff_pinion_ratio / p->diff_ratio;
    forces[6][0] = p->cardan1_damping / p->gearbox1_ratio;
    forces[7][0] = p->cardan2_damping / (p->diff_ratio * p->gearbox2_ratio);
    forces[9][0] = p->cardan3_damping / (p->diff_ratio * p->gearbox3_ratio);
    forces[13][0] = p->cardan1_stiffness;
    forces[14][0] = -p->cardan2_stiffness / (p->diff_ratio * p->diff_ratio);
    forces[17][0] = -p->cardan3_stiffness / (p->diff_ratio * p->diff_ratio);
    forces[23][0] = -1.0;
    forces[0][1] = -p->cardan2_damping * p->diff_pinion_ratio / p->diff_ratio + p->cardan3_damping *
        p->diff_pinion_ratio / p->diff_ratio;
    forces[1][1] = -p->cardan2_damping * (p->diff_pinion_ratio * p->diff_pinion_ratio) - p->cardan3_damping *
        (p->diff_pinion_ratio * p->diff_pinion_ratio) - p->diff_limited_slip_viscous;
    forces[7][1] = p->cardan2_damping * p->diff_pinion_ratio / p->gearbox2_ratio;
    forces[9][1] = -p->cardan3_damping * p->diff_pinion_ratio / p->gearbox3_ratio;
    forces[14][1] = -p->cardan2_stiffness * p->diff_pinion_ratio / p->diff_ratio;
    forces[17][1] = p->cardan3_stiffness * p->diff_pinion_ratio / p->diff_ratio;
    forces[24][1] = -1.0;
    forces[2][2] = -p->flange1_damping;
    forces[5][2] = p->flange1_damping;
    forces[11][2] = -p->flange1_stiffness;
    forces[20][2] = 1.0;
    forces[3][3] = -p->flange2_damping;
    forces[8][3] = p->flange2_damping;
    forces[16][3] = -p->flange2_stiffness;
    forces[21][3] = 1.0;
    forces[4][4] = -p->flange3_damping;
    forces[10][4] = p->flange3_damping;
    forces[19][4] = -p->flange3_stiffness;
    forces[22][4] = 1.0;
    forces[2][5] = p->flange1_damping;
    forces[5][5] = -p->flange1_damping - p->shaft1_damping;
    forces[6][5] = p->shaft1_damping;
    forces[11][5] = p->flange1_stiffness;
    forces[12][5] = -p->shaft1_stiffness;
    forces[0][6] = p->cardan1_damping / p->gearbox1_ratio;
    forces[5][6] = p->shaft1_damping;
    forces[6][6] = -p->cardan1_damping / (p->gearbox1_ratio * p->gearbox1_ratio) - p->shaft1_damping;
    forces[12][6] = p->shaft1_stiffness;
    forces[13][6] = -p->cardan1_stiffness / p->gearbox1_ratio;
    forces[0][7] = p->cardan2_damping / (p->diff_ratio * p->gearbox2_ratio);
    forces[1][7] = p->cardan2_damping * p->diff_pinion_ratio / p->gearbox2_ratio;
    forces[7][7] = -p->cardan2_damping / (p->gearbox2_ratio * p->gearbox2_ratio) - p->shaft2_damping;
    forces[8][7] = p->shaft2_damping;
    forces[14][7] = p->cardan2_stiffness / (p->diff_ratio * p->gearbox2_ratio);
    forces[15][7] = -p->shaft2_stiffness;
    forces[3][8] = p->flange2_damping;
    forces[7][8] = p->shaft2_damping;
    forces[8][8] = -p->flange2_damping - p->shaft2_damping;
    forces[15][8] = p->shaft2_stiffness;
    forces[16][8] = p->flange2_stiffness;
    forces[0][9] = p->cardan3_damping / (p->diff_ratio * p->gearbox3_ratio);
    forces[1][9] = -p->cardan3_damping * p->diff_pinion_ratio / p->gearbox3_ratio;
    forces[9][9] = -p->cardan3_damping / (p->gearbox3_ratio * p->gearbox3_ratio) - p->shaft3_damping;
    forces[10][9] = p->shaft3_damping;
    forces[17][9] = p->cardan3_stiffness / (p->diff_ratio * p->gearbox3_ratio);
    forces[18][9] = -p->shaft3_stiffness;
    forces[4][10] = p->flange3_damping;
    forces[9][10] = p->shaft3_damping;
    forces[10][10] = -p->flange3_damping - p->shaft3_damping;
    forces[18][10] = p->shaft3_stiffness;
    forces[19][10] = p->flange3_stiffness;
    if (!differential_gearboxes_cholesky_solve(11, 25, &mass[0][0], &forces[0][0], &rates[0][0])) {
        return differential_gearboxes_plant_mass_matrix;
    }
    differential_gearboxes_insert(11, 24, 12, 0, 0, 0, 20, &A[0][0], &rates[0][0]);
    /* de/dt = E z */
    A[2][11] = 1.0;
    A[5][11] = -1.0;
    A[5][12] = 1.0;
    A[6][12] = -1.0;
    A[0][13] = -1.0;
    A[6][13] = 1.0 / p->gearbox1_ratio;
    A[0][14] = 1.0;
    A[1][14] = p->diff_pinion_ratio * p->diff_ratio;
    A[7][14] = -p->diff_ratio / p->gearbox2_ratio;
    A[7][15] = 1.0;
    A[8][15] = -1.0;
    A[3][16] = 1.0;
    A[8][16] = -1.0;
    A[0][17] = 1.0;
    A[1][17] = -p->diff_pinion_ratio * p->diff_ratio;
    A[9][17] = -p->diff_ratio / p->gearbox3_ratio;
    A[9][18] = 1.0;
    A[10][18] = -1.0;
    A[4][19] = 1.0;
    A[10][19] = -1.0;
    differential_gearboxes_insert(11, 24, 12, 0, 20, 20, 1, &A[0][0], &rates[0][0]);
    /* lag of the torque loop */
    A[20][20] = -1.0 / p->M1_inverter_time_constant;
    A[23][20] = 1.0 / p->M1_inverter_time_constant;
    differential_gearboxes_insert(11, 24, 12, 0, 21, 21, 1, &A[0][0], &rates[0][0]);
    A[21][21] = -1.0 / p->M2_inverter_time_constant;
    A[24][21] = 1.0 / p->M2_inverter_time_constant;
    differential_gearboxes_insert(11, 24, 12, 0, 22, 22, 1, &A[0][0], &rates[0][0]);
    A[22][22] = -1.0 / p->M3_inverter_time_constant;
    A[25][22] = 1.0 / p->M3_inverter_time_constant;
    differential_gearboxes_insert(11, 24, 12, 0, 26, 23, 2, &A[0][0], &rates[0][0]);
    scale[0] = 1.0;
    scale[1] = 1.0;
    scale[2] = 1.0;
    scale[3] = 1.0;
    scale[4] = 1.0;
    scale[5] = 1.0;
    scale[6] = 1.0;
    scale[7] = 1.0;
    scale[8] = 1.0;
    scale[9] = 1.0;
    scale[10] = 1.0;
    scale[11] = p->sample_time;
    scale[12] = p->sample_time;
    scale[13] = p->sample_time;
    scale[14] = p->sample_time;
    scale[15] = p->sample_time;
    scale[16] = p->sample_time;
    scale[17] = p->sample_time;
    scale[18] = p->sample_time;
    scale[19] = p->sample_time;
    scale[20] = 1.0;
    scale[21] = 1.0;
    scale[22] = 1.0;
    scale[23] = 1.0;
    scale[24] = 1.0;
    scale[25] = 1.0;
    scale[26] = 1.0;
    scale[27] = 1.0;
    /* exact discretisation */
    if (!differential_gearboxes_discretise(23, 28, 6, &A[0][0], scale, p->sample_time, &whole[0][0])) {
        return differential_gearboxes_plant_exponential_range;
    }
    differential_gearboxes_insert(23, 24, 24, 0, 0, 0, 23, &s->transition[0][0], &whole[0][0]);
    /* dead time = (d + f) h */
    s->M1_dead_steps = differential_gearboxes_floor(p->M1_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const differential_gearboxes_real M1_late_time = p->sample_time - differential_gearboxes_max(0.0,
        -s->M1_dead_steps * p->sample_time + p->M1_inverter_dead_time);
    if (!differential_gearboxes_discretise(23, 28, 6, &A[0][0], scale, M1_late_time, &late[0][0])) {
        return differential_gearboxes_plant_exponential_range;
    }
    differential_gearboxes_difference(23, 28, &whole[0][0], &late[0][0], &early[0][0]);
    differential_gearboxes_insert(23, 24, 24, 0, 23, 23, 1, &s->transition[0][0], &late[0][0]);
    differential_gearboxes_insert(23, 24, 24, 0, 26, 23, 1, &s->transition[0][0], &early[0][0]);
    /* dead time = (d + f) h */
    s->M2_dead_steps = differential_gearboxes_floor(p->M2_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const differential_gearboxes_real M2_late_time = p->sample_time - differential_gearboxes_max(0.0,
        -s->M2_dead_steps * p->sample_time + p->M2_inverter_dead_time);
    if (!differential_gearboxes_discretise(23, 28, 6, &A[0][0], scale, M2_late_time, &late[0][0])) {
        return differential_gearboxes_plant_exponential_range;
    }
    differential_gearboxes_difference(23, 28, &whole[0][0], &late[0][0], &early[0][0]);
    differential_gearboxes_insert(23, 24, 24, 0, 24, 24, 1, &s->transition[0][0], &late[0][0]);
    differential_gearboxes_insert(23, 24, 24, 0, 27, 24, 1, &s->transition[0][0], &early[0][0]);
    /* dead time = (d + f) h */
    s->M3_dead_steps = differential_gearboxes_floor(p->M3_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const differential_gearboxes_real M3_late_time = p->sample_time - differential_gearboxes_max(0.0,
        -s->M3_dead_steps * p->sample_time + p->M3_inverter_dead_time);
    if (!differential_gearboxes_discretise(23, 28, 6, &A[0][0], scale, M3_late_time, &late[0][0])) {
        return differential_gearboxes_plant_exponential_range;
    }
    differential_gearboxes_difference(23, 28, &whole[0][0], &late[0][0], &early[0][0]);
    differential_gearboxes_insert(23, 24, 24, 0, 25, 25, 1, &s->transition[0][0], &late[0][0]);
    differential_gearboxes_insert(23, 24, 24, 0, 28, 25, 1, &s->transition[0][0], &early[0][0]);
    differential_gearboxes_insert(23, 24, 24, 0, 0, 26, 2, &s->gamma[0][0], &whole[0][0]);
    /* K = -G Gamma_f */
    s->K[0][0] = -whole[26][0];
    s->K[1][0] = -whole[27][0];
    s->K[0][1] = -whole[26][1];
    s->K[1][1] = -whole[27][1];
    /* friction can be solved */
    if (!differential_gearboxes_require_definite(2, 0, &s->K[0][0])) {
        return differential_gearboxes_plant_friction_matrix;
    }
    return differential_gearboxes_plant_ok;
}

void differential_gearboxes_plant_measure(const differential_gearboxes_plant_state *s, const differential_gearboxes_plant_params *p, differential_gearboxes_plant_outputs *out)
{
    out->M1_speed = s->x[2];
    out->flange1_torque = p->flange1_damping * s->x[2] - p->flange1_damping * s->x[5] + p->flange1_stiffness *
        s->x[11];
    out->flange2_torque = -p->flange2_damping * s->x[3] + p->flange2_damping * s->x[8] - p->flange2_stiffness *
        s->x[16];
    out->M2_speed = s->x[3];
    out->flange3_torque = p->flange3_damping * s->x[10] - p->flange3_damping * s->x[4] - p->flange3_stiffness *
        s->x[19];
    out->M3_speed = s->x[4];
    out->diff_outputs_torque = -p->cardan2_damping * s->x[7] / p->gearbox2_ratio + p->cardan2_stiffness * s->x[14] /
        p->diff_ratio - p->cardan3_damping * s->x[9] / p->gearbox3_ratio + p->cardan3_stiffness * s->x[17] /
        p->diff_ratio + s->x[0] * (p->cardan2_damping / p->diff_ratio + p->cardan3_damping / p->diff_ratio) +
        s->x[1] * (p->cardan2_damping * p->diff_pinion_ratio - p->cardan3_damping * p->diff_pinion_ratio);
    out->diff_input_torque = -p->cardan1_damping * s->x[0] + p->cardan1_damping * s->x[6] / p->gearbox1_ratio +
        p->cardan1_stiffness * s->x[13];
    out->M1_torque = s->x[20];
    out->M2_torque = s->x[21];
    out->M3_torque = s->x[22];
    out->diff_loss_speed = s->x[0];
    out->diff_loss_torque = out->diff_loss_speed * p->diff_loss_viscous + s->friction_torque[0];
    out->diff_limited_slip_speed = s->x[1];
    out->diff_limited_slip_torque = out->diff_limited_slip_speed * p->diff_limited_slip_viscous +
        s->friction_torque[1];
}

/* Status of the first input that is not finite or outside its range. */
static int check_inputs(const differential_gearboxes_plant_inputs *in)
{
    if (!differential_gearboxes_is_finite(in->M1_torque_ref)) {
        return (int)differential_gearboxes_plant_bad_input_M1_torque_ref;
    }
    if (!differential_gearboxes_is_finite(in->M2_torque_ref)) {
        return (int)differential_gearboxes_plant_bad_input_M2_torque_ref;
    }
    if (!differential_gearboxes_is_finite(in->M3_torque_ref)) {
        return (int)differential_gearboxes_plant_bad_input_M3_torque_ref;
    }
    return 0;
}

differential_gearboxes_plant_status differential_gearboxes_plant_step(differential_gearboxes_plant_state *s, const differential_gearboxes_plant_params *p,
    const differential_gearboxes_plant_inputs *in, differential_gearboxes_plant_outputs *out)
{
    const int bad = check_inputs(in);
    if (bad != 0) {
        differential_gearboxes_plant_measure(s, p, out);
        return (differential_gearboxes_plant_status)bad;
    }
    differential_gearboxes_real x_free[24];
    differential_gearboxes_real mean_torque[4];
    differential_gearboxes_real w_start[4];
    differential_gearboxes_real w_free[4];
    differential_gearboxes_real w_plus[4];
    differential_gearboxes_real slide[4];
    differential_gearboxes_real rest[4];
    differential_gearboxes_real friction_mean[4];
    differential_gearboxes_zero(sizeof x_free, x_free);
    differential_gearboxes_zero(sizeof mean_torque, mean_torque);
    differential_gearboxes_zero(sizeof w_start, w_start);
    differential_gearboxes_zero(sizeof w_free, w_free);
    differential_gearboxes_zero(sizeof w_plus, w_plus);
    differential_gearboxes_zero(sizeof slide, slide);
    differential_gearboxes_zero(sizeof rest, rest);
    differential_gearboxes_zero(sizeof friction_mean, friction_mean);
    
    /* torque-speed envelope, Figure 7.1 */
    const differential_gearboxes_real M1_available = p->M1_speed_rated * p->M1_torque_max /
        differential_gearboxes_max(p->M1_speed_rated, differential_gearboxes_abs(s->x[2]));
    const differential_gearboxes_real M1_limited = differential_gearboxes_max(-M1_available,
        differential_gearboxes_min(M1_available, in->M1_torque_ref));
    /* dead time of the torque loop */
    differential_gearboxes_delay(16, s->M1_delay, M1_limited, s->M1_dead_steps, &s->x[23], &s->x[26]);
    /* torque-speed envelope, Figure 7.1 */
    const differential_gearboxes_real M2_available = p->M2_speed_rated * p->M2_torque_max /
        differential_gearboxes_max(p->M2_speed_rated, differential_gearboxes_abs(s->x[3]));
    const differential_gearboxes_real M2_limited = differential_gearboxes_max(-M2_available,
        differential_gearboxes_min(M2_available, in->M2_torque_ref));
    /* dead time of the torque loop */
    differential_gearboxes_delay(16, s->M2_delay, M2_limited, s->M2_dead_steps, &s->x[24], &s->x[27]);
    /* torque-speed envelope, Figure 7.1 */
    const differential_gearboxes_real M3_available = p->M3_speed_rated * p->M3_torque_max /
        differential_gearboxes_max(p->M3_speed_rated, differential_gearboxes_abs(s->x[4]));
    const differential_gearboxes_real M3_limited = differential_gearboxes_max(-M3_available,
        differential_gearboxes_min(M3_available, in->M3_torque_ref));
    /* dead time of the torque loop */
    differential_gearboxes_delay(16, s->M3_delay, M3_limited, s->M3_dead_steps, &s->x[25], &s->x[28]);
    const differential_gearboxes_real diff_input_torque_start = -p->cardan1_damping * s->x[0] + p->cardan1_damping *
        s->x[6] / p->gearbox1_ratio + p->cardan1_stiffness * s->x[13];
    /* x+ = Phi x + Gamma_u u */
    differential_gearboxes_multiply(23, 29, &s->transition[0][0], s->x, x_free);
    /* w = G z */
    w_start[0] = s->x[0];
    w_start[1] = s->x[1];
    /* predicted */
    const differential_gearboxes_real diff_input_torque_end = -p->cardan1_damping * (s->friction_torque[0] *
        s->gamma[0][0] + s->friction_torque[1] * s->gamma[1][0] + x_free[0]) + p->cardan1_damping *
        (s->friction_torque[0] * s->gamma[0][6] + s->friction_torque[1] * s->gamma[1][6] + x_free[6]) /
        p->gearbox1_ratio + p->cardan1_stiffness * (s->friction_torque[0] * s->gamma[0][13] + s->friction_torque[1]
        * s->gamma[1][13] + x_free[13]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[0] = p->diff_loss_coulomb + p->diff_loss_load * differential_gearboxes_abs((0.5) * diff_input_torque_end +
        (0.5) * diff_input_torque_start);
    rest[0] = p->diff_loss_coulomb + p->diff_loss_load * differential_gearboxes_abs((0.5) * diff_input_torque_end +
        (0.5) * diff_input_torque_start);
    slide[1] = p->diff_limited_slip_coulomb + p->diff_limited_slip_load * differential_gearboxes_abs((0.5) *
        diff_input_torque_end + (0.5) * diff_input_torque_start);
    rest[1] = p->diff_limited_slip_coulomb + p->diff_limited_slip_load * differential_gearboxes_abs((0.5) *
        diff_input_torque_end + (0.5) * diff_input_torque_start);
    /* w_free = G z_free */
    w_free[0] = x_free[0];
    w_free[1] = x_free[1];
    /* what sticks, slips and passes zero */
    differential_gearboxes_friction_step(0, 0, &s->K[0][0], w_start, w_free, slide, rest, s->friction_torque,
        s->friction_rest, friction_mean, w_plus, &s->friction_status);
    mean_torque[0] = friction_mean[0];
    mean_torque[1] = friction_mean[1];
    /* x+ = x_free + Gamma_f T */
    differential_gearboxes_add_product(23, 2, s->x, x_free, &s->gamma[0][0], mean_torque);
    /* exactly zero while it sticks */
    s->x[0] = differential_gearboxes_select(p->standstill_speed > differential_gearboxes_abs(w_plus[0]), 0.0,
        w_plus[0]);
    s->x[1] = differential_gearboxes_select(p->standstill_speed > differential_gearboxes_abs(w_plus[1]), 0.0,
        w_plus[1]);
    differential_gearboxes_plant_measure(s, p, out);
    if (s->friction_status == DIFFERENTIAL_GEARBOXES_REAL(-1)) {
        return differential_gearboxes_plant_friction_unsolved;
    }
    if (s->friction_status == DIFFERENTIAL_GEARBOXES_REAL(1)) {
        return differential_gearboxes_plant_bad_capacity_diff_loss;
    }
    if (s->friction_status == DIFFERENTIAL_GEARBOXES_REAL(2)) {
        return differential_gearboxes_plant_bad_capacity_diff_limited_slip;
    }
    return differential_gearboxes_plant_ok;
}
