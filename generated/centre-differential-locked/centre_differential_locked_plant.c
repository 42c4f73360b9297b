/*
 * centre_differential_locked_plant.c: plant of the bed centre_differential_locked
 *
 * Emitted by ptgen 0.1.0 from centre-differential-locked.toml (SHA-256 853679bdb0920a51), template block.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "centre_differential_locked_plant.h"
#include "centre_differential_locked_friction.h"

#include <float.h>
#include <string.h>

const centre_differential_locked_plant_params centre_differential_locked_plant_defaults = {
    .M1_inertia = 1.0,
    .M1_torque_max = 930.0,
    .M1_speed_rated = 699.946843219806,
    .M1_inverter_dead_time = 0.0005,
    .M1_inverter_time_constant = 0.001,
    .flange1_inertia = 0.032,
    .flange1_stiffness = 380000.0,
    .flange1_damping = 0.5,
    .cardan1_stiffness = 57000.0,
    .cardan1_damping = 2.0,
    .diff_loss_coulomb = 2.0,
    .diff_loss_load = 0.01,
    .diff_loss_viscous = 0.002,
    .diff_limited_slip_coulomb = 80.0,
    .diff_limited_slip_load = 0.3,
    .diff_limited_slip_viscous = 0.05,
    .diff_ratio = 1.0,
    .diff_inertia = 0.03,
    .diff_inertia_pinion = 0.02,
    .diff_pinion_ratio = 1.0,
    .cardan2_stiffness = 12000.0,
    .cardan2_damping = 1.0,
    .cardan2_backlash = 0.010471975511966,
    .flange2_inertia = 0.032,
    .flange2_stiffness = 220000.0,
    .flange2_damping = 0.5,
    .M2_inertia = 1.9,
    .M2_torque_max = 1200.0,
    .M2_speed_rated = 251.327412287183,
    .M2_inverter_dead_time = 0.0005,
    .M2_inverter_time_constant = 0.001,
    .cardan3_stiffness = 8000.0,
    .cardan3_damping = 1.0,
    .cardan3_backlash = 0.010471975511966,
    .flange3_inertia = 0.029,
    .flange3_stiffness = 220000.0,
    .flange3_damping = 0.5,
    .M3_inertia = 1.9,
    .M3_torque_max = 1200.0,
    .M3_speed_rated = 251.327412287183,
    .M3_inverter_dead_time = 0.0005,
    .M3_inverter_time_constant = 0.001,
    .standstill_speed = 1e-09,
    .sample_time = 0.0001,
};

/* Range of each parameter; `open` excludes the lower bound. The order is that of the status codes. */
static const struct {
    const char *text;
    size_t offset;
    centre_differential_locked_real least;
    centre_differential_locked_real most;
    int open;
    int not_zero;
} limits[] = {
    { "the parameter M1_inertia is outside its range", offsetof(centre_differential_locked_plant_params, M1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_max is outside its range", offsetof(centre_differential_locked_plant_params, M1_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_rated is outside its range", offsetof(centre_differential_locked_plant_params, M1_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_inverter_dead_time is outside its range", offsetof(centre_differential_locked_plant_params, M1_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M1_inverter_time_constant is outside its range", offsetof(centre_differential_locked_plant_params, M1_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_inertia is outside its range", offsetof(centre_differential_locked_plant_params, flange1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_stiffness is outside its range", offsetof(centre_differential_locked_plant_params, flange1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_damping is outside its range", offsetof(centre_differential_locked_plant_params, flange1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter cardan1_stiffness is outside its range", offsetof(centre_differential_locked_plant_params, cardan1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter cardan1_damping is outside its range", offsetof(centre_differential_locked_plant_params, cardan1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_loss_coulomb is outside its range", offsetof(centre_differential_locked_plant_params, diff_loss_coulomb), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_loss_load is outside its range", offsetof(centre_differential_locked_plant_params, diff_loss_load), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_loss_viscous is outside its range", offsetof(centre_differential_locked_plant_params, diff_loss_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_limited_slip_coulomb is outside its range", offsetof(centre_differential_locked_plant_params, diff_limited_slip_coulomb), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_limited_slip_load is outside its range", offsetof(centre_differential_locked_plant_params, diff_limited_slip_load), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_limited_slip_viscous is outside its range", offsetof(centre_differential_locked_plant_params, diff_limited_slip_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_ratio is outside its range", offsetof(centre_differential_locked_plant_params, diff_ratio), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter diff_inertia is outside its range", offsetof(centre_differential_locked_plant_params, diff_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter diff_inertia_pinion is outside its range", offsetof(centre_differential_locked_plant_params, diff_inertia_pinion), 0.0, DBL_MAX, 1, 0 },
    { "the parameter diff_pinion_ratio is outside its range", offsetof(centre_differential_locked_plant_params, diff_pinion_ratio), 0.0, DBL_MAX, 1, 0 },
    { "the parameter cardan2_stiffness is outside its range", offsetof(centre_differential_locked_plant_params, cardan2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter cardan2_damping is outside its range", offsetof(centre_differential_locked_plant_params, cardan2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter cardan2_backlash is outside its range", offsetof(centre_differential_locked_plant_params, cardan2_backlash), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_inertia is outside its range", offsetof(centre_differential_locked_plant_params, flange2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_stiffness is outside its range", offsetof(centre_differential_locked_plant_params, flange2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_damping is outside its range", offsetof(centre_differential_locked_plant_params, flange2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_inertia is outside its range", offsetof(centre_differential_locked_plant_params, M2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_max is outside its range", offsetof(centre_differential_locked_plant_params, M2_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_rated is outside its range", offsetof(centre_differential_locked_plant_params, M2_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_inverter_dead_time is outside its range", offsetof(centre_differential_locked_plant_params, M2_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M2_inverter_time_constant is outside its range", offsetof(centre_differential_locked_plant_params, M2_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter cardan3_stiffness is outside its range", offsetof(centre_differential_locked_plant_params, cardan3_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter cardan3_damping is outside its range", offsetof(centre_differential_locked_plant_params, cardan3_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter cardan3_backlash is outside its range", offsetof(centre_differential_locked_plant_params, cardan3_backlash), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_inertia is outside its range", offsetof(centre_differential_locked_plant_params, flange3_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_stiffness is outside its range", offsetof(centre_differential_locked_plant_params, flange3_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_damping is outside its range", offsetof(centre_differential_locked_plant_params, flange3_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M3_inertia is outside its range", offsetof(centre_differential_locked_plant_params, M3_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_torque_max is outside its range", offsetof(centre_differential_locked_plant_params, M3_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_rated is outside its range", offsetof(centre_differential_locked_plant_params, M3_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_inverter_dead_time is outside its range", offsetof(centre_differential_locked_plant_params, M3_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M3_inverter_time_constant is outside its range", offsetof(centre_differential_locked_plant_params, M3_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter standstill_speed is outside its range", offsetof(centre_differential_locked_plant_params, standstill_speed), 0.0, DBL_MAX, 0, 0 },
    { "the parameter sample_time is outside its range", offsetof(centre_differential_locked_plant_params, sample_time), 0.0, DBL_MAX, 1, 0 },
};

enum { limit_count = sizeof limits / sizeof limits[0] };

const char *centre_differential_locked_plant_status_text(centre_differential_locked_plant_status status)
{
    switch ((int)status) {
    case centre_differential_locked_plant_ok:
        return "ok";
    case centre_differential_locked_plant_mass_matrix:
        return "the inertia matrix is not positive definite";
    case centre_differential_locked_plant_exponential_range:
        return "the parameters are too far from those that the code was emitted for; emit it again";
    case centre_differential_locked_plant_friction_matrix:
        return "a mode of the bed is too fast for the step; make a stiff shaft rigid, or the step shorter";
    case centre_differential_locked_plant_friction_unsolved:
        return "the friction torques are not exact";
    case centre_differential_locked_plant_bad_capacity_diff_loss:
        return "the capacity of diff.loss is no number from 0 up; it was taken as 0";
    case centre_differential_locked_plant_bad_capacity_diff_limited_slip:
        return "the capacity of diff.limited_slip is no number from 0 up; it was taken as 0";
    case centre_differential_locked_plant_bad_input_M1_torque_ref:
        return "the input M1_torque_ref is not finite";
    case centre_differential_locked_plant_bad_input_M2_torque_ref:
        return "the input M2_torque_ref is not finite";
    case centre_differential_locked_plant_bad_input_M3_torque_ref:
        return "the input M3_torque_ref is not finite";
    default:
        break;
    }
    const int limit = (int)status - 2000;
    return limit >= 0 && limit < limit_count ? limits[limit].text : "unknown status";
}

centre_differential_locked_plant_status centre_differential_locked_plant_init(centre_differential_locked_plant_state *s, const centre_differential_locked_plant_params *p)
{
    memset(s, 0, sizeof *s);
    return centre_differential_locked_plant_update(s, p);
}

centre_differential_locked_plant_status centre_differential_locked_plant_update(centre_differential_locked_plant_state *s, const centre_differential_locked_plant_params *p)
{
    for (int k = 0; k < limit_count; ++k) {
        const centre_differential_locked_real value = *(const centre_differential_locked_real *)(const void *)((const char *)p + limits[k].offset);
        const int above = limits[k].open ? value > limits[k].least : value >= limits[k].least; /* false for NaN */
        if (!(above && value <= limits[k].most) || (limits[k].not_zero && value == 0.0)) {
            return (centre_differential_locked_plant_status)(2000 + k);
        }
    }
    memset(s->transition, 0, sizeof s->transition);
    memset(s->L, 0, sizeof s->L);
    memset(s->gamma, 0, sizeof s->gamma);
    memset(s->K, 0, sizeof s->K);
    memset(s->kappa, 0, sizeof s->kappa);
    memset(s->half_gap, 0, sizeof s->half_gap);
    memset(s->contact_stiffness, 0, sizeof s->contact_stiffness);
    memset(s->contact_damping, 0, sizeof s->contact_damping);
    centre_differential_locked_real mass[8][8];
    centre_differential_locked_real forces[21][8];
    centre_differential_locked_real A[24][20];
    centre_differential_locked_real scale[24];
    centre_differential_locked_real whole[24][20];
    centre_differential_locked_real late[24][20];
    centre_differential_locked_real early[24][20];
    centre_differential_locked_real rates[21][8];
    centre_differential_locked_zero(sizeof mass, mass);
    centre_differential_locked_zero(sizeof forces, forces);
    centre_differential_locked_zero(sizeof A, A);
    centre_differential_locked_zero(sizeof scale, scale);
    centre_differential_locked_zero(sizeof whole, whole);
    centre_differential_locked_zero(sizeof late, late);
    centre_differential_locked_zero(sizeof early, early);
    centre_differential_locked_zero(sizeof rates, rates);
    
    /* twists of shafts with backlash per twist */
    s->L[2][0] = 1.0 / p->diff_ratio;
    s->L[4][1] = 1.0 / p->diff_ratio;
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
    forces[0][0] = -p->cardan1_damping - p->diff_loss_viscous;
    forces[5][0] = p->cardan1_damping;
    forces[9][0] = p->cardan1_stiffness;
    forces[17][0] = -1.0;
    forces[19][0] = -1.0 / p->diff_ratio;
    forces[20][0] = -1.0 / p->diff_ratio;
    forces[1][1] = -p->diff_limited_slip_viscous;
    forces[18][1] = -1.0;
    forces[19][1] = -p->diff_pinion_ratio;
    forces[20][1] = p->diff_pinion_ratio;
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
    forces[3][6] = p->flange2_damping;
    forces[6][6] = -p->flange2_damping;
    forces[11][6] = p->flange2_stiffness;
    forces[19][6] = 1.0;
    forces[4][7] = p->flange3_damping;
    forces[7][7] = -p->flange3_damping;
    forces[13][7] = p->flange3_stiffness;
    forces[20][7] = 1.0;
    if (!centre_differential_locked_cholesky_solve(8, 21, &mass[0][0], &forces[0][0], &rates[0][0])) {
        return centre_differential_locked_plant_mass_matrix;
    }
    centre_differential_locked_insert(8, 20, 8, 0, 0, 0, 14, &A[0][0], &rates[0][0]);
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
    centre_differential_locked_insert(8, 20, 8, 0, 14, 14, 1, &A[0][0], &rates[0][0]);
    /* lag of the torque loop */
    A[14][14] = -1.0 / p->M1_inverter_time_constant;
    A[17][14] = 1.0 / p->M1_inverter_time_constant;
    centre_differential_locked_insert(8, 20, 8, 0, 15, 15, 1, &A[0][0], &rates[0][0]);
    A[15][15] = -1.0 / p->M2_inverter_time_constant;
    A[18][15] = 1.0 / p->M2_inverter_time_constant;
    centre_differential_locked_insert(8, 20, 8, 0, 16, 16, 1, &A[0][0], &rates[0][0]);
    A[16][16] = -1.0 / p->M3_inverter_time_constant;
    A[19][16] = 1.0 / p->M3_inverter_time_constant;
    centre_differential_locked_insert(8, 20, 8, 0, 20, 17, 4, &A[0][0], &rates[0][0]);
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
    scale[22] = 1.0;
    scale[23] = 1.0;
    /* exact discretisation */
    if (!centre_differential_locked_discretise(17, 24, 5, &A[0][0], scale, p->sample_time, &whole[0][0])) {
        return centre_differential_locked_plant_exponential_range;
    }
    centre_differential_locked_insert(17, 20, 20, 0, 0, 0, 17, &s->transition[0][0], &whole[0][0]);
    /* dead time = (d + f) h */
    s->M1_dead_steps = centre_differential_locked_floor(p->M1_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const centre_differential_locked_real M1_late_time = p->sample_time - centre_differential_locked_max(0.0,
        -s->M1_dead_steps * p->sample_time + p->M1_inverter_dead_time);
    if (!centre_differential_locked_discretise(17, 24, 5, &A[0][0], scale, M1_late_time, &late[0][0])) {
        return centre_differential_locked_plant_exponential_range;
    }
    centre_differential_locked_difference(17, 24, &whole[0][0], &late[0][0], &early[0][0]);
    centre_differential_locked_insert(17, 20, 20, 0, 17, 17, 1, &s->transition[0][0], &late[0][0]);
    centre_differential_locked_insert(17, 20, 20, 0, 20, 17, 1, &s->transition[0][0], &early[0][0]);
    /* dead time = (d + f) h */
    s->M2_dead_steps = centre_differential_locked_floor(p->M2_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const centre_differential_locked_real M2_late_time = p->sample_time - centre_differential_locked_max(0.0,
        -s->M2_dead_steps * p->sample_time + p->M2_inverter_dead_time);
    if (!centre_differential_locked_discretise(17, 24, 5, &A[0][0], scale, M2_late_time, &late[0][0])) {
        return centre_differential_locked_plant_exponential_range;
    }
    centre_differential_locked_difference(17, 24, &whole[0][0], &late[0][0], &early[0][0]);
    centre_differential_locked_insert(17, 20, 20, 0, 18, 18, 1, &s->transition[0][0], &late[0][0]);
    centre_differential_locked_insert(17, 20, 20, 0, 21, 18, 1, &s->transition[0][0], &early[0][0]);
    /* dead time = (d + f) h */
    s->M3_dead_steps = centre_differential_locked_floor(p->M3_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const centre_differential_locked_real M3_late_time = p->sample_time - centre_differential_locked_max(0.0,
        -s->M3_dead_steps * p->sample_time + p->M3_inverter_dead_time);
    if (!centre_differential_locked_discretise(17, 24, 5, &A[0][0], scale, M3_late_time, &late[0][0])) {
        return centre_differential_locked_plant_exponential_range;
    }
    centre_differential_locked_difference(17, 24, &whole[0][0], &late[0][0], &early[0][0]);
    centre_differential_locked_insert(17, 20, 20, 0, 19, 19, 1, &s->transition[0][0], &late[0][0]);
    centre_differential_locked_insert(17, 20, 20, 0, 22, 19, 1, &s->transition[0][0], &early[0][0]);
    centre_differential_locked_insert(17, 20, 20, 0, 0, 20, 4, &s->gamma[0][0], &whole[0][0]);
    /* K = -G Gamma_f */
    s->K[0][0] = -whole[20][0];
    s->K[1][0] = -whole[21][0];
    s->K[0][1] = -whole[20][1];
    s->K[1][1] = -whole[21][1];
    /* friction can be solved */
    if (!centre_differential_locked_require_definite(2, 0, &s->K[0][0])) {
        return centre_differential_locked_plant_friction_matrix;
    }
    /* twist lost per torque of a contact */
    s->kappa[0][0] = -whole[22][10] / p->diff_ratio;
    s->kappa[1][0] = -whole[23][10] / p->diff_ratio;
    s->kappa[0][1] = -whole[22][12] / p->diff_ratio;
    s->kappa[1][1] = -whole[23][12] / p->diff_ratio;
    /* (3.5) */
    s->half_gap[0] = (0.5) * p->cardan2_backlash;
    s->contact_stiffness[0] = p->cardan2_stiffness;
    s->contact_damping[0] = p->cardan2_damping / p->sample_time;
    s->half_gap[1] = (0.5) * p->cardan3_backlash;
    s->contact_stiffness[1] = p->cardan3_stiffness;
    s->contact_damping[1] = p->cardan3_damping / p->sample_time;
    return centre_differential_locked_plant_ok;
}

void centre_differential_locked_plant_measure(const centre_differential_locked_plant_state *s, const centre_differential_locked_plant_params *p, centre_differential_locked_plant_outputs *out)
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
static int check_inputs(const centre_differential_locked_plant_inputs *in)
{
    if (!centre_differential_locked_is_finite(in->M1_torque_ref)) {
        return (int)centre_differential_locked_plant_bad_input_M1_torque_ref;
    }
    if (!centre_differential_locked_is_finite(in->M2_torque_ref)) {
        return (int)centre_differential_locked_plant_bad_input_M2_torque_ref;
    }
    if (!centre_differential_locked_is_finite(in->M3_torque_ref)) {
        return (int)centre_differential_locked_plant_bad_input_M3_torque_ref;
    }
    return 0;
}

centre_differential_locked_plant_status centre_differential_locked_plant_step(centre_differential_locked_plant_state *s, const centre_differential_locked_plant_params *p,
    const centre_differential_locked_plant_inputs *in, centre_differential_locked_plant_outputs *out)
{
    const int bad = check_inputs(in);
    if (bad != 0) {
        centre_differential_locked_plant_measure(s, p, out);
        return (centre_differential_locked_plant_status)bad;
    }
    centre_differential_locked_real x_free[20];
    centre_differential_locked_real mean_torque[4];
    centre_differential_locked_real w_start[4];
    centre_differential_locked_real w_free[4];
    centre_differential_locked_real w_plus[4];
    centre_differential_locked_real slide[4];
    centre_differential_locked_real rest[4];
    centre_differential_locked_real friction_mean[4];
    centre_differential_locked_real twist_start[4];
    centre_differential_locked_real twist_free[4];
    centre_differential_locked_real contact_mean[4];
    centre_differential_locked_zero(sizeof x_free, x_free);
    centre_differential_locked_zero(sizeof mean_torque, mean_torque);
    centre_differential_locked_zero(sizeof w_start, w_start);
    centre_differential_locked_zero(sizeof w_free, w_free);
    centre_differential_locked_zero(sizeof w_plus, w_plus);
    centre_differential_locked_zero(sizeof slide, slide);
    centre_differential_locked_zero(sizeof rest, rest);
    centre_differential_locked_zero(sizeof friction_mean, friction_mean);
    centre_differential_locked_zero(sizeof twist_start, twist_start);
    centre_differential_locked_zero(sizeof twist_free, twist_free);
    centre_differential_locked_zero(sizeof contact_mean, contact_mean);
    
    /* torque-speed envelope, Figure 7.1 */
    const centre_differential_locked_real M1_available = p->M1_speed_rated * p->M1_torque_max /
        centre_differential_locked_max(p->M1_speed_rated, centre_differential_locked_abs(s->x[2]));
    const centre_differential_locked_real M1_limited = centre_differential_locked_max(-M1_available,
        centre_differential_locked_min(M1_available, in->M1_torque_ref));
    /* dead time of the torque loop */
    centre_differential_locked_delay(16, s->M1_delay, M1_limited, s->M1_dead_steps, &s->x[17], &s->x[20]);
    /* torque-speed envelope, Figure 7.1 */
    const centre_differential_locked_real M2_available = p->M2_speed_rated * p->M2_torque_max /
        centre_differential_locked_max(p->M2_speed_rated, centre_differential_locked_abs(s->x[3]));
    const centre_differential_locked_real M2_limited = centre_differential_locked_max(-M2_available,
        centre_differential_locked_min(M2_available, in->M2_torque_ref));
    /* dead time of the torque loop */
    centre_differential_locked_delay(16, s->M2_delay, M2_limited, s->M2_dead_steps, &s->x[18], &s->x[21]);
    /* torque-speed envelope, Figure 7.1 */
    const centre_differential_locked_real M3_available = p->M3_speed_rated * p->M3_torque_max /
        centre_differential_locked_max(p->M3_speed_rated, centre_differential_locked_abs(s->x[4]));
    const centre_differential_locked_real M3_limited = centre_differential_locked_max(-M3_available,
        centre_differential_locked_min(M3_available, in->M3_torque_ref));
    /* dead time of the torque loop */
    centre_differential_locked_delay(16, s->M3_delay, M3_limited, s->M3_dead_steps, &s->x[19], &s->x[22]);
    const centre_differential_locked_real diff_input_torque_start = -p->cardan1_damping * s->x[0] +
        p->cardan1_damping * s->x[5] + p->cardan1_stiffness * s->x[9];
    /* x+ = Phi x + Gamma_u u */
    centre_differential_locked_multiply(17, 23, &s->transition[0][0], s->x, x_free);
    /* e = L x_e */
    twist_start[0] = s->L[2][0] * s->x[10];
    twist_free[0] = s->L[2][0] * (s->friction_torque[0] * s->gamma[0][10] + s->friction_torque[1] * s->gamma[1][10]
        + x_free[10]);
    twist_start[1] = s->L[4][1] * s->x[12];
    twist_free[1] = s->L[4][1] * (s->friction_torque[0] * s->gamma[0][12] + s->friction_torque[1] * s->gamma[1][12]
        + x_free[12]);
    /* (3.5) as a mean over the step */
    centre_differential_locked_backlash_step(&s->kappa[0][0], twist_start, twist_free, s->half_gap,
        s->contact_stiffness, s->contact_damping, contact_mean);
    mean_torque[2] = contact_mean[0];
    mean_torque[3] = contact_mean[1];
    /* w = G z */
    w_start[0] = s->x[0];
    w_start[1] = s->x[1];
    /* predicted */
    const centre_differential_locked_real diff_input_torque_end = -p->cardan1_damping * (contact_mean[0] *
        s->gamma[2][0] + contact_mean[1] * s->gamma[3][0] + s->friction_torque[0] * s->gamma[0][0] +
        s->friction_torque[1] * s->gamma[1][0] + x_free[0]) + p->cardan1_damping * (contact_mean[0] * s->gamma[2][5]
        + contact_mean[1] * s->gamma[3][5] + s->friction_torque[0] * s->gamma[0][5] + s->friction_torque[1] *
        s->gamma[1][5] + x_free[5]) + p->cardan1_stiffness * (contact_mean[0] * s->gamma[2][9] + contact_mean[1] *
        s->gamma[3][9] + s->friction_torque[0] * s->gamma[0][9] + s->friction_torque[1] * s->gamma[1][9] +
        x_free[9]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[0] = p->diff_loss_coulomb + p->diff_loss_load * centre_differential_locked_abs((0.5) *
        diff_input_torque_end + (0.5) * diff_input_torque_start);
    rest[0] = p->diff_loss_coulomb + p->diff_loss_load * centre_differential_locked_abs((0.5) *
        diff_input_torque_end + (0.5) * diff_input_torque_start);
    slide[1] = p->diff_limited_slip_coulomb + p->diff_limited_slip_load * centre_differential_locked_abs((0.5) *
        diff_input_torque_end + (0.5) * diff_input_torque_start);
    rest[1] = p->diff_limited_slip_coulomb + p->diff_limited_slip_load * centre_differential_locked_abs((0.5) *
        diff_input_torque_end + (0.5) * diff_input_torque_start);
    /* w_free = G z_free */
    w_free[0] = contact_mean[0] * s->gamma[2][0] + contact_mean[1] * s->gamma[3][0] + x_free[0];
    w_free[1] = contact_mean[0] * s->gamma[2][1] + contact_mean[1] * s->gamma[3][1] + x_free[1];
    /* what sticks, slips and passes zero */
    centre_differential_locked_friction_step(0, 0, &s->K[0][0], w_start, w_free, slide, rest, s->friction_torque,
        s->friction_rest, friction_mean, w_plus, &s->friction_status);
    mean_torque[0] = friction_mean[0];
    mean_torque[1] = friction_mean[1];
    /* x+ = x_free + Gamma_f T */
    centre_differential_locked_add_product(17, 4, s->x, x_free, &s->gamma[0][0], mean_torque);
    /* exactly zero while it sticks */
    s->x[0] = centre_differential_locked_select(p->standstill_speed > centre_differential_locked_abs(w_plus[0]),
        0.0, w_plus[0]);
    s->x[1] = centre_differential_locked_select(p->standstill_speed > centre_differential_locked_abs(w_plus[1]),
        0.0, w_plus[1]);
    const centre_differential_locked_real cardan2_twist = s->L[2][0] * s->x[10];
    /* (3.5) */
    s->contact_torque[0] = p->cardan2_stiffness * (cardan2_twist - centre_differential_locked_max(-s->half_gap[0],
        centre_differential_locked_min(cardan2_twist, s->half_gap[0]))) +
        centre_differential_locked_select(s->half_gap[0] < centre_differential_locked_abs(cardan2_twist),
        p->cardan2_damping * (p->diff_pinion_ratio * s->x[1] - s->x[6] + s->x[0] / p->diff_ratio), 0.0);
    const centre_differential_locked_real cardan3_twist = s->L[4][1] * s->x[12];
    s->contact_torque[1] = p->cardan3_stiffness * (cardan3_twist - centre_differential_locked_max(-s->half_gap[1],
        centre_differential_locked_min(cardan3_twist, s->half_gap[1]))) +
        centre_differential_locked_select(s->half_gap[1] < centre_differential_locked_abs(cardan3_twist),
        p->cardan3_damping * (-p->diff_pinion_ratio * s->x[1] - s->x[7] + s->x[0] / p->diff_ratio), 0.0);
    centre_differential_locked_plant_measure(s, p, out);
    if (s->friction_status == CENTRE_DIFFERENTIAL_LOCKED_REAL(-1)) {
        return centre_differential_locked_plant_friction_unsolved;
    }
    if (s->friction_status == CENTRE_DIFFERENTIAL_LOCKED_REAL(1)) {
        return centre_differential_locked_plant_bad_capacity_diff_loss;
    }
    if (s->friction_status == CENTRE_DIFFERENTIAL_LOCKED_REAL(2)) {
        return centre_differential_locked_plant_bad_capacity_diff_limited_slip;
    }
    return centre_differential_locked_plant_ok;
}
