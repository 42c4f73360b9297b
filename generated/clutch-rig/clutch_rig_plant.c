/*
 * clutch_rig_plant.c: plant of the bed clutch_rig
 *
 * Emitted by ptgen 0.1.0 from clutch-rig.toml (SHA-256 8a8f57b91ebde405), template block.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "clutch_rig_plant.h"
#include "clutch_rig_friction.h"

#include <float.h>
#include <string.h>

const clutch_rig_plant_params clutch_rig_plant_defaults = {
    .M1_inertia = 0.35,
    .M1_torque_max = 480.0,
    .M1_speed_rated = 209.43951023932,
    .M1_inverter_dead_time = 0.0001,
    .M1_inverter_time_constant = 0.00025,
    .flange1_inertia = 0.02,
    .flange1_stiffness = 220000.0,
    .flange1_damping = 0.5,
    .shaft1_stiffness = 20000.0,
    .shaft1_damping = 3.0,
    .clutch1_viscous = 0.0,
    .clutch1_capacity = 150.0,
    .clutch1_inertia_input = 1.0,
    .clutch1_inertia_output = 1.0,
    .middle_inertia = 0.01,
    .clutch2_static = 220.0,
    .clutch2_stribeck_speed = 2.0943951023932,
    .clutch2_viscous = 0.2,
    .clutch2_capacity = 180.0,
    .clutch2_inertia_input = 1.0,
    .clutch2_inertia_output = 1.0,
    .shaft2_stiffness = 20000.0,
    .shaft2_damping = 3.0,
    .flange2_inertia = 0.02,
    .flange2_stiffness = 220000.0,
    .flange2_damping = 0.5,
    .M2_inertia = 0.35,
    .M2_torque_max = 480.0,
    .M2_speed_rated = 209.43951023932,
    .M2_inverter_dead_time = 0.0001,
    .M2_inverter_time_constant = 0.00025,
    .standstill_speed = 1e-09,
    .sample_time = 0.0001,
};

/* Range of each parameter; `open` excludes the lower bound. The order is that of the status codes. */
static const struct {
    const char *text;
    size_t offset;
    clutch_rig_real least;
    clutch_rig_real most;
    int open;
    int not_zero;
} limits[] = {
    { "the parameter M1_inertia is outside its range", offsetof(clutch_rig_plant_params, M1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_max is outside its range", offsetof(clutch_rig_plant_params, M1_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_rated is outside its range", offsetof(clutch_rig_plant_params, M1_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_inverter_dead_time is outside its range", offsetof(clutch_rig_plant_params, M1_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M1_inverter_time_constant is outside its range", offsetof(clutch_rig_plant_params, M1_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_inertia is outside its range", offsetof(clutch_rig_plant_params, flange1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_stiffness is outside its range", offsetof(clutch_rig_plant_params, flange1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_damping is outside its range", offsetof(clutch_rig_plant_params, flange1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter shaft1_stiffness is outside its range", offsetof(clutch_rig_plant_params, shaft1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft1_damping is outside its range", offsetof(clutch_rig_plant_params, shaft1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter clutch1_viscous is outside its range", offsetof(clutch_rig_plant_params, clutch1_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter clutch1_capacity is outside its range", offsetof(clutch_rig_plant_params, clutch1_capacity), 0.0, DBL_MAX, 1, 0 },
    { "the parameter clutch1_inertia_input is outside its range", offsetof(clutch_rig_plant_params, clutch1_inertia_input), 0.0, DBL_MAX, 1, 0 },
    { "the parameter clutch1_inertia_output is outside its range", offsetof(clutch_rig_plant_params, clutch1_inertia_output), 0.0, DBL_MAX, 1, 0 },
    { "the parameter middle_inertia is outside its range", offsetof(clutch_rig_plant_params, middle_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter clutch2_static is outside its range", offsetof(clutch_rig_plant_params, clutch2_static), 0.0, DBL_MAX, 1, 0 },
    { "the parameter clutch2_stribeck_speed is outside its range", offsetof(clutch_rig_plant_params, clutch2_stribeck_speed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter clutch2_viscous is outside its range", offsetof(clutch_rig_plant_params, clutch2_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter clutch2_capacity is outside its range", offsetof(clutch_rig_plant_params, clutch2_capacity), 0.0, DBL_MAX, 1, 0 },
    { "the parameter clutch2_inertia_input is outside its range", offsetof(clutch_rig_plant_params, clutch2_inertia_input), 0.0, DBL_MAX, 1, 0 },
    { "the parameter clutch2_inertia_output is outside its range", offsetof(clutch_rig_plant_params, clutch2_inertia_output), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft2_stiffness is outside its range", offsetof(clutch_rig_plant_params, shaft2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft2_damping is outside its range", offsetof(clutch_rig_plant_params, shaft2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter flange2_inertia is outside its range", offsetof(clutch_rig_plant_params, flange2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_stiffness is outside its range", offsetof(clutch_rig_plant_params, flange2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_damping is outside its range", offsetof(clutch_rig_plant_params, flange2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_inertia is outside its range", offsetof(clutch_rig_plant_params, M2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_max is outside its range", offsetof(clutch_rig_plant_params, M2_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_rated is outside its range", offsetof(clutch_rig_plant_params, M2_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_inverter_dead_time is outside its range", offsetof(clutch_rig_plant_params, M2_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M2_inverter_time_constant is outside its range", offsetof(clutch_rig_plant_params, M2_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter standstill_speed is outside its range", offsetof(clutch_rig_plant_params, standstill_speed), 0.0, DBL_MAX, 0, 0 },
    { "the parameter sample_time is outside its range", offsetof(clutch_rig_plant_params, sample_time), 0.0, DBL_MAX, 1, 0 },
};

enum { limit_count = sizeof limits / sizeof limits[0] };

const char *clutch_rig_plant_status_text(clutch_rig_plant_status status)
{
    switch ((int)status) {
    case clutch_rig_plant_ok:
        return "ok";
    case clutch_rig_plant_mass_matrix:
        return "the inertia matrix is not positive definite";
    case clutch_rig_plant_exponential_range:
        return "the parameters are too far from those that the code was emitted for; emit it again";
    case clutch_rig_plant_friction_matrix:
        return "a mode of the bed is too fast for the step; make a stiff shaft rigid, or the step shorter";
    case clutch_rig_plant_friction_unsolved:
        return "the friction torques are not exact";
    case clutch_rig_plant_bad_capacity_clutch1:
        return "the capacity of clutch1 is no number from 0 up; it was taken as 0";
    case clutch_rig_plant_bad_capacity_clutch2:
        return "the capacity of clutch2 is no number from 0 up; it was taken as 0";
    case clutch_rig_plant_bad_input_M1_torque_ref:
        return "the input M1_torque_ref is not finite";
    case clutch_rig_plant_bad_input_M2_torque_ref:
        return "the input M2_torque_ref is not finite";
    case clutch_rig_plant_bad_input_clutch1_actuation:
        return "the input clutch1_actuation is outside its range 0 to 1";
    case clutch_rig_plant_bad_input_clutch2_actuation:
        return "the input clutch2_actuation is outside its range 0 to 1";
    default:
        break;
    }
    const int limit = (int)status - 2000;
    return limit >= 0 && limit < limit_count ? limits[limit].text : "unknown status";
}

clutch_rig_plant_status clutch_rig_plant_init(clutch_rig_plant_state *s, const clutch_rig_plant_params *p)
{
    memset(s, 0, sizeof *s);
    return clutch_rig_plant_update(s, p);
}

clutch_rig_plant_status clutch_rig_plant_update(clutch_rig_plant_state *s, const clutch_rig_plant_params *p)
{
    for (int k = 0; k < limit_count; ++k) {
        const clutch_rig_real value = *(const clutch_rig_real *)(const void *)((const char *)p + limits[k].offset);
        const int above = limits[k].open ? value > limits[k].least : value >= limits[k].least; /* false for NaN */
        if (!(above && value <= limits[k].most) || (limits[k].not_zero && value == 0.0)) {
            return (clutch_rig_plant_status)(2000 + k);
        }
    }
    memset(s->transition, 0, sizeof s->transition);
    memset(s->gamma, 0, sizeof s->gamma);
    memset(s->K, 0, sizeof s->K);
    clutch_rig_real mass[7][8];
    clutch_rig_real forces[15][8];
    clutch_rig_real A[17][16];
    clutch_rig_real scale[20];
    clutch_rig_real whole[17][16];
    clutch_rig_real late[17][16];
    clutch_rig_real early[17][16];
    clutch_rig_real rates[15][8];
    clutch_rig_zero(sizeof mass, mass);
    clutch_rig_zero(sizeof forces, forces);
    clutch_rig_zero(sizeof A, A);
    clutch_rig_zero(sizeof scale, scale);
    clutch_rig_zero(sizeof whole, whole);
    clutch_rig_zero(sizeof late, late);
    clutch_rig_zero(sizeof early, early);
    clutch_rig_zero(sizeof rates, rates);
    
    /* M = S' I S */
    mass[0][0] = p->clutch1_inertia_output + p->clutch2_inertia_input + p->clutch2_inertia_output +
        p->middle_inertia;
    mass[1][0] = p->clutch2_inertia_output;
    mass[5][0] = -p->clutch1_inertia_output - p->clutch2_inertia_input - p->clutch2_inertia_output -
        p->middle_inertia;
    mass[0][1] = p->clutch2_inertia_output;
    mass[1][1] = p->clutch2_inertia_output;
    mass[5][1] = -p->clutch2_inertia_output;
    mass[2][2] = p->M1_inertia;
    mass[3][3] = p->M2_inertia;
    mass[4][4] = p->flange1_inertia;
    mass[0][5] = -p->clutch1_inertia_output - p->clutch2_inertia_input - p->clutch2_inertia_output -
        p->middle_inertia;
    mass[1][5] = -p->clutch2_inertia_output;
    mass[5][5] = p->clutch1_inertia_input + p->clutch1_inertia_output + p->clutch2_inertia_input +
        p->clutch2_inertia_output + p->middle_inertia;
    mass[6][6] = p->flange2_inertia;
    /* M dz/dt = B' u - E'(C e + D E z) - G'(T + k_v G z) */
    forces[0][0] = -p->shaft2_damping;
    forces[1][0] = -p->shaft2_damping;
    forces[5][0] = p->shaft2_damping;
    forces[6][0] = -p->shaft2_damping;
    forces[9][0] = p->shaft2_stiffness;
    forces[13][0] = -1.0;
    forces[0][1] = -p->shaft2_damping;
    forces[1][1] = -p->shaft2_damping;
    forces[5][1] = p->shaft2_damping;
    forces[6][1] = -p->shaft2_damping;
    forces[9][1] = p->shaft2_stiffness;
    forces[14][1] = -1.0;
    forces[2][2] = -p->flange1_damping;
    forces[4][2] = p->flange1_damping;
    forces[7][2] = -p->flange1_stiffness;
    forces[11][2] = 1.0;
    forces[3][3] = -p->flange2_damping;
    forces[6][3] = p->flange2_damping;
    forces[10][3] = -p->flange2_stiffness;
    forces[12][3] = 1.0;
    forces[2][4] = p->flange1_damping;
    forces[4][4] = -p->flange1_damping - p->shaft1_damping;
    forces[5][4] = p->shaft1_damping;
    forces[7][4] = p->flange1_stiffness;
    forces[8][4] = -p->shaft1_stiffness;
    forces[0][5] = p->shaft2_damping;
    forces[1][5] = p->shaft2_damping;
    forces[4][5] = p->shaft1_damping;
    forces[5][5] = -p->shaft1_damping - p->shaft2_damping;
    forces[6][5] = p->shaft2_damping;
    forces[8][5] = p->shaft1_stiffness;
    forces[9][5] = -p->shaft2_stiffness;
    forces[0][6] = -p->shaft2_damping;
    forces[1][6] = -p->shaft2_damping;
    forces[3][6] = p->flange2_damping;
    forces[5][6] = p->shaft2_damping;
    forces[6][6] = -p->flange2_damping - p->shaft2_damping;
    forces[9][6] = p->shaft2_stiffness;
    forces[10][6] = p->flange2_stiffness;
    if (!clutch_rig_cholesky_solve(7, 15, &mass[0][0], &forces[0][0], &rates[0][0])) {
        return clutch_rig_plant_mass_matrix;
    }
    clutch_rig_insert(7, 16, 8, 0, 0, 0, 11, &A[0][0], &rates[0][0]);
    /* de/dt = E z */
    A[2][7] = 1.0;
    A[4][7] = -1.0;
    A[4][8] = 1.0;
    A[5][8] = -1.0;
    A[0][9] = -1.0;
    A[1][9] = -1.0;
    A[5][9] = 1.0;
    A[6][9] = -1.0;
    A[3][10] = 1.0;
    A[6][10] = -1.0;
    clutch_rig_insert(7, 16, 8, 0, 11, 11, 1, &A[0][0], &rates[0][0]);
    /* lag of the torque loop */
    A[11][11] = -1.0 / p->M1_inverter_time_constant;
    A[13][11] = 1.0 / p->M1_inverter_time_constant;
    clutch_rig_insert(7, 16, 8, 0, 12, 12, 1, &A[0][0], &rates[0][0]);
    A[12][12] = -1.0 / p->M2_inverter_time_constant;
    A[14][12] = 1.0 / p->M2_inverter_time_constant;
    clutch_rig_insert(7, 16, 8, 0, 15, 13, 2, &A[0][0], &rates[0][0]);
    scale[0] = 1.0;
    scale[1] = 1.0;
    scale[2] = 1.0;
    scale[3] = 1.0;
    scale[4] = 1.0;
    scale[5] = 1.0;
    scale[6] = 1.0;
    scale[7] = p->sample_time;
    scale[8] = p->sample_time;
    scale[9] = p->sample_time;
    scale[10] = p->sample_time;
    scale[11] = 1.0;
    scale[12] = 1.0;
    scale[13] = 1.0;
    scale[14] = 1.0;
    scale[15] = 1.0;
    scale[16] = 1.0;
    /* exact discretisation */
    if (!clutch_rig_discretise(13, 17, 5, &A[0][0], scale, p->sample_time, &whole[0][0])) {
        return clutch_rig_plant_exponential_range;
    }
    clutch_rig_insert(13, 16, 16, 0, 0, 0, 13, &s->transition[0][0], &whole[0][0]);
    /* dead time = (d + f) h */
    s->M1_dead_steps = clutch_rig_floor(p->M1_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const clutch_rig_real M1_late_time = p->sample_time - clutch_rig_max(0.0, -s->M1_dead_steps * p->sample_time +
        p->M1_inverter_dead_time);
    if (!clutch_rig_discretise(13, 17, 5, &A[0][0], scale, M1_late_time, &late[0][0])) {
        return clutch_rig_plant_exponential_range;
    }
    clutch_rig_difference(13, 17, &whole[0][0], &late[0][0], &early[0][0]);
    clutch_rig_insert(13, 16, 16, 0, 13, 13, 1, &s->transition[0][0], &late[0][0]);
    clutch_rig_insert(13, 16, 16, 0, 15, 13, 1, &s->transition[0][0], &early[0][0]);
    /* dead time = (d + f) h */
    s->M2_dead_steps = clutch_rig_floor(p->M2_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const clutch_rig_real M2_late_time = p->sample_time - clutch_rig_max(0.0, -s->M2_dead_steps * p->sample_time +
        p->M2_inverter_dead_time);
    if (!clutch_rig_discretise(13, 17, 5, &A[0][0], scale, M2_late_time, &late[0][0])) {
        return clutch_rig_plant_exponential_range;
    }
    clutch_rig_difference(13, 17, &whole[0][0], &late[0][0], &early[0][0]);
    clutch_rig_insert(13, 16, 16, 0, 14, 14, 1, &s->transition[0][0], &late[0][0]);
    clutch_rig_insert(13, 16, 16, 0, 16, 14, 1, &s->transition[0][0], &early[0][0]);
    clutch_rig_insert(13, 16, 16, 0, 0, 15, 2, &s->gamma[0][0], &whole[0][0]);
    /* K = -G Gamma_f */
    s->K[0][0] = -whole[15][0];
    s->K[1][0] = -whole[16][0];
    s->K[0][1] = -whole[15][1];
    s->K[1][1] = -whole[16][1];
    /* friction can be solved */
    if (!clutch_rig_require_definite(2, 0, &s->K[0][0])) {
        return clutch_rig_plant_friction_matrix;
    }
    return clutch_rig_plant_ok;
}

void clutch_rig_plant_measure(const clutch_rig_plant_state *s, const clutch_rig_plant_params *p, clutch_rig_plant_outputs *out)
{
    out->M1_speed = s->x[2];
    out->flange1_torque = p->flange1_damping * s->x[2] - p->flange1_damping * s->x[4] + p->flange1_stiffness *
        s->x[7];
    out->flange2_torque = -p->flange2_damping * s->x[3] + p->flange2_damping * s->x[6] - p->flange2_stiffness *
        s->x[10];
    out->M2_speed = s->x[3];
    out->M1_torque = s->x[11];
    out->M2_torque = s->x[12];
    out->clutch1_speed = s->x[0];
    out->clutch1_torque = s->friction_torque[0];
    out->clutch2_speed = s->x[1];
    out->clutch2_torque = s->friction_torque[1];
}

/* Status of the first input that is not finite or outside its range. */
static int check_inputs(const clutch_rig_plant_inputs *in)
{
    if (!clutch_rig_is_finite(in->M1_torque_ref)) {
        return (int)clutch_rig_plant_bad_input_M1_torque_ref;
    }
    if (!clutch_rig_is_finite(in->M2_torque_ref)) {
        return (int)clutch_rig_plant_bad_input_M2_torque_ref;
    }
    if (!(in->clutch1_actuation >= 0.0 && in->clutch1_actuation <= 1.0)) {
        return (int)clutch_rig_plant_bad_input_clutch1_actuation;
    }
    if (!(in->clutch2_actuation >= 0.0 && in->clutch2_actuation <= 1.0)) {
        return (int)clutch_rig_plant_bad_input_clutch2_actuation;
    }
    return 0;
}

clutch_rig_plant_status clutch_rig_plant_step(clutch_rig_plant_state *s, const clutch_rig_plant_params *p,
    const clutch_rig_plant_inputs *in, clutch_rig_plant_outputs *out)
{
    const int bad = check_inputs(in);
    if (bad != 0) {
        clutch_rig_plant_measure(s, p, out);
        return (clutch_rig_plant_status)bad;
    }
    clutch_rig_real x_free[16];
    clutch_rig_real mean_torque[4];
    clutch_rig_real w_start[4];
    clutch_rig_real w_free[4];
    clutch_rig_real w_plus[4];
    clutch_rig_real slide[4];
    clutch_rig_real rest[4];
    clutch_rig_real friction_mean[4];
    clutch_rig_zero(sizeof x_free, x_free);
    clutch_rig_zero(sizeof mean_torque, mean_torque);
    clutch_rig_zero(sizeof w_start, w_start);
    clutch_rig_zero(sizeof w_free, w_free);
    clutch_rig_zero(sizeof w_plus, w_plus);
    clutch_rig_zero(sizeof slide, slide);
    clutch_rig_zero(sizeof rest, rest);
    clutch_rig_zero(sizeof friction_mean, friction_mean);
    
    /* torque-speed envelope, Figure 7.1 */
    const clutch_rig_real M1_available = p->M1_speed_rated * p->M1_torque_max / clutch_rig_max(p->M1_speed_rated,
        clutch_rig_abs(s->x[2]));
    const clutch_rig_real M1_limited = clutch_rig_max(-M1_available, clutch_rig_min(M1_available,
        in->M1_torque_ref));
    /* dead time of the torque loop */
    clutch_rig_delay(16, s->M1_delay, M1_limited, s->M1_dead_steps, &s->x[13], &s->x[15]);
    /* torque-speed envelope, Figure 7.1 */
    const clutch_rig_real M2_available = p->M2_speed_rated * p->M2_torque_max / clutch_rig_max(p->M2_speed_rated,
        clutch_rig_abs(s->x[3]));
    const clutch_rig_real M2_limited = clutch_rig_max(-M2_available, clutch_rig_min(M2_available,
        in->M2_torque_ref));
    /* dead time of the torque loop */
    clutch_rig_delay(16, s->M2_delay, M2_limited, s->M2_dead_steps, &s->x[14], &s->x[16]);
    /* x+ = Phi x + Gamma_u u */
    clutch_rig_multiply(13, 17, &s->transition[0][0], s->x, x_free);
    /* w = G z */
    w_start[0] = s->x[0];
    w_start[1] = s->x[1];
    /* speed at mid-step */
    const clutch_rig_real clutch1_mid_speed = (0.5) * clutch_rig_abs(s->friction_torque[0] * s->gamma[0][0] +
        s->friction_torque[1] * s->gamma[1][0] + w_start[0] + x_free[0]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[0] = in->clutch1_actuation * (p->clutch1_capacity + clutch1_mid_speed * p->clutch1_viscous);
    rest[0] = in->clutch1_actuation * p->clutch1_capacity;
    /* speed at mid-step */
    const clutch_rig_real clutch2_mid_speed = (0.5) * clutch_rig_abs(s->friction_torque[0] * s->gamma[0][1] +
        s->friction_torque[1] * s->gamma[1][1] + w_start[1] + x_free[1]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[1] = in->clutch2_actuation * (p->clutch2_capacity + clutch2_mid_speed * p->clutch2_viscous +
        (-p->clutch2_capacity + p->clutch2_static) * clutch_rig_exp(-clutch2_mid_speed /
        p->clutch2_stribeck_speed));
    rest[1] = in->clutch2_actuation * p->clutch2_static;
    /* w_free = G z_free */
    w_free[0] = x_free[0];
    w_free[1] = x_free[1];
    /* what sticks, slips and passes zero */
    clutch_rig_friction_step(0, 0, &s->K[0][0], w_start, w_free, slide, rest, s->friction_torque, s->friction_rest,
        friction_mean, w_plus, &s->friction_status);
    mean_torque[0] = friction_mean[0];
    mean_torque[1] = friction_mean[1];
    /* x+ = x_free + Gamma_f T */
    clutch_rig_add_product(13, 2, s->x, x_free, &s->gamma[0][0], mean_torque);
    /* exactly zero while it sticks */
    s->x[0] = clutch_rig_select(p->standstill_speed > clutch_rig_abs(w_plus[0]), 0.0, w_plus[0]);
    s->x[1] = clutch_rig_select(p->standstill_speed > clutch_rig_abs(w_plus[1]), 0.0, w_plus[1]);
    clutch_rig_plant_measure(s, p, out);
    if (s->friction_status == CLUTCH_RIG_REAL(-1)) {
        return clutch_rig_plant_friction_unsolved;
    }
    if (s->friction_status == CLUTCH_RIG_REAL(1)) {
        return clutch_rig_plant_bad_capacity_clutch1;
    }
    if (s->friction_status == CLUTCH_RIG_REAL(2)) {
        return clutch_rig_plant_bad_capacity_clutch2;
    }
    return clutch_rig_plant_ok;
}
