/*
 * transmission_fixed_gear_plant.c: plant of the bed transmission_fixed_gear
 *
 * Emitted by ptgen 0.1.0 from transmission-fixed-gear.toml (SHA-256 ccd2b8cca096cd29), template block.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "transmission_fixed_gear_plant.h"

#include <float.h>
#include <string.h>

const transmission_fixed_gear_plant_params transmission_fixed_gear_plant_defaults = {
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
    .gearbox_inertia = 0.01,
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
    .sample_time = 0.0001,
};

/* Range of each parameter; `open` excludes the lower bound. The order is that of the status codes. */
static const struct {
    const char *text;
    size_t offset;
    transmission_fixed_gear_real least;
    transmission_fixed_gear_real most;
    int open;
    int not_zero;
} limits[] = {
    { "the parameter M1_inertia is outside its range", offsetof(transmission_fixed_gear_plant_params, M1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_max is outside its range", offsetof(transmission_fixed_gear_plant_params, M1_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_rated is outside its range", offsetof(transmission_fixed_gear_plant_params, M1_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_inverter_dead_time is outside its range", offsetof(transmission_fixed_gear_plant_params, M1_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M1_inverter_time_constant is outside its range", offsetof(transmission_fixed_gear_plant_params, M1_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_inertia is outside its range", offsetof(transmission_fixed_gear_plant_params, flange1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_stiffness is outside its range", offsetof(transmission_fixed_gear_plant_params, flange1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_damping is outside its range", offsetof(transmission_fixed_gear_plant_params, flange1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter shaft1_stiffness is outside its range", offsetof(transmission_fixed_gear_plant_params, shaft1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft1_damping is outside its range", offsetof(transmission_fixed_gear_plant_params, shaft1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gearbox_inertia is outside its range", offsetof(transmission_fixed_gear_plant_params, gearbox_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft2_stiffness is outside its range", offsetof(transmission_fixed_gear_plant_params, shaft2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft2_damping is outside its range", offsetof(transmission_fixed_gear_plant_params, shaft2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter flange2_inertia is outside its range", offsetof(transmission_fixed_gear_plant_params, flange2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_stiffness is outside its range", offsetof(transmission_fixed_gear_plant_params, flange2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_damping is outside its range", offsetof(transmission_fixed_gear_plant_params, flange2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_inertia is outside its range", offsetof(transmission_fixed_gear_plant_params, M2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_max is outside its range", offsetof(transmission_fixed_gear_plant_params, M2_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_rated is outside its range", offsetof(transmission_fixed_gear_plant_params, M2_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_inverter_dead_time is outside its range", offsetof(transmission_fixed_gear_plant_params, M2_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M2_inverter_time_constant is outside its range", offsetof(transmission_fixed_gear_plant_params, M2_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter sample_time is outside its range", offsetof(transmission_fixed_gear_plant_params, sample_time), 0.0, DBL_MAX, 1, 0 },
};

enum { limit_count = sizeof limits / sizeof limits[0] };

const char *transmission_fixed_gear_plant_status_text(transmission_fixed_gear_plant_status status)
{
    switch ((int)status) {
    case transmission_fixed_gear_plant_ok:
        return "ok";
    case transmission_fixed_gear_plant_mass_matrix:
        return "the inertia matrix is not positive definite";
    case transmission_fixed_gear_plant_exponential_range:
        return "the parameters are too far from those that the code was emitted for; emit it again";
    case transmission_fixed_gear_plant_bad_input_M1_torque_ref:
        return "the input M1_torque_ref is not finite";
    case transmission_fixed_gear_plant_bad_input_M2_torque_ref:
        return "the input M2_torque_ref is not finite";
    case transmission_fixed_gear_plant_bad_input_gearbox_ratio:
        return "the input gearbox_ratio is outside its range 0.65 to 4.7";
    default:
        break;
    }
    const int limit = (int)status - 2000;
    return limit >= 0 && limit < limit_count ? limits[limit].text : "unknown status";
}

transmission_fixed_gear_plant_status transmission_fixed_gear_plant_init(transmission_fixed_gear_plant_state *s, const transmission_fixed_gear_plant_params *p)
{
    memset(s, 0, sizeof *s);
    s->gearbox_ratio_now = 3.13;
    return transmission_fixed_gear_plant_update(s, p);
}

/* What follows from the parameters, and from what a step may change: gearbox_ratio_now. */
static transmission_fixed_gear_plant_status prepare(transmission_fixed_gear_plant_state *s, const transmission_fixed_gear_plant_params *p)
{
    memset(s->transition, 0, sizeof s->transition);
    transmission_fixed_gear_real mass[5][8];
    transmission_fixed_gear_real forces[11][8];
    transmission_fixed_gear_real A[13][12];
    transmission_fixed_gear_real scale[16];
    transmission_fixed_gear_real whole[13][12];
    transmission_fixed_gear_real late[13][12];
    transmission_fixed_gear_real early[13][12];
    transmission_fixed_gear_real rates[11][8];
    transmission_fixed_gear_zero(sizeof mass, mass);
    transmission_fixed_gear_zero(sizeof forces, forces);
    transmission_fixed_gear_zero(sizeof A, A);
    transmission_fixed_gear_zero(sizeof scale, scale);
    transmission_fixed_gear_zero(sizeof whole, whole);
    transmission_fixed_gear_zero(sizeof late, late);
    transmission_fixed_gear_zero(sizeof early, early);
    transmission_fixed_gear_zero(sizeof rates, rates);
    
    /* M = S' I S */
    mass[0][0] = p->M1_inertia;
    mass[1][1] = p->M2_inertia;
    mass[2][2] = p->flange1_inertia;
    mass[3][3] = p->gearbox_inertia;
    mass[4][4] = p->flange2_inertia;
    /* M dz/dt = B' u - E'(C e + D E z) - G'(T + k_v G z) */
    forces[0][0] = -p->flange1_damping;
    forces[2][0] = p->flange1_damping;
    forces[5][0] = -p->flange1_stiffness;
    forces[9][0] = 1.0;
    forces[1][1] = -p->flange2_damping;
    forces[4][1] = p->flange2_damping;
    forces[8][1] = -p->flange2_stiffness;
    forces[10][1] = 1.0;
    forces[0][2] = p->flange1_damping;
    forces[2][2] = -p->flange1_damping - p->shaft1_damping;
    forces[3][2] = p->shaft1_damping;
    forces[5][2] = p->flange1_stiffness;
    forces[6][2] = -p->shaft1_stiffness;
    forces[2][3] = p->shaft1_damping;
    forces[3][3] = -p->shaft1_damping - p->shaft2_damping / (s->gearbox_ratio_now * s->gearbox_ratio_now);
    forces[4][3] = p->shaft2_damping / s->gearbox_ratio_now;
    forces[6][3] = p->shaft1_stiffness;
    forces[7][3] = -p->shaft2_stiffness / s->gearbox_ratio_now;
    forces[1][4] = p->flange2_damping;
    forces[3][4] = p->shaft2_damping / s->gearbox_ratio_now;
    forces[4][4] = -p->flange2_damping - p->shaft2_damping;
    forces[7][4] = p->shaft2_stiffness;
    forces[8][4] = p->flange2_stiffness;
    if (!transmission_fixed_gear_cholesky_solve(5, 11, &mass[0][0], &forces[0][0], &rates[0][0])) {
        return transmission_fixed_gear_plant_mass_matrix;
    }
    transmission_fixed_gear_insert(5, 12, 8, 0, 0, 0, 9, &A[0][0], &rates[0][0]);
    /* de/dt = E z */
    A[0][5] = 1.0;
    A[2][5] = -1.0;
    A[2][6] = 1.0;
    A[3][6] = -1.0;
    A[3][7] = 1.0 / s->gearbox_ratio_now;
    A[4][7] = -1.0;
    A[1][8] = 1.0;
    A[4][8] = -1.0;
    transmission_fixed_gear_insert(5, 12, 8, 0, 9, 9, 1, &A[0][0], &rates[0][0]);
    /* lag of the torque loop */
    A[9][9] = -1.0 / p->M1_inverter_time_constant;
    A[11][9] = 1.0 / p->M1_inverter_time_constant;
    transmission_fixed_gear_insert(5, 12, 8, 0, 10, 10, 1, &A[0][0], &rates[0][0]);
    A[10][10] = -1.0 / p->M2_inverter_time_constant;
    A[12][10] = 1.0 / p->M2_inverter_time_constant;
    scale[0] = 1.0;
    scale[1] = 1.0;
    scale[2] = 1.0;
    scale[3] = 1.0;
    scale[4] = 1.0;
    scale[5] = p->sample_time;
    scale[6] = p->sample_time;
    scale[7] = p->sample_time;
    scale[8] = p->sample_time;
    scale[9] = 1.0;
    scale[10] = 1.0;
    scale[11] = 1.0;
    scale[12] = 1.0;
    /* exact discretisation */
    if (!transmission_fixed_gear_discretise(11, 13, 5, &A[0][0], scale, p->sample_time, &whole[0][0])) {
        return transmission_fixed_gear_plant_exponential_range;
    }
    transmission_fixed_gear_insert(11, 12, 12, 0, 0, 0, 11, &s->transition[0][0], &whole[0][0]);
    /* dead time = (d + f) h */
    s->M1_dead_steps = transmission_fixed_gear_floor(p->M1_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const transmission_fixed_gear_real M1_late_time = p->sample_time - transmission_fixed_gear_max(0.0,
        -s->M1_dead_steps * p->sample_time + p->M1_inverter_dead_time);
    if (!transmission_fixed_gear_discretise(11, 13, 5, &A[0][0], scale, M1_late_time, &late[0][0])) {
        return transmission_fixed_gear_plant_exponential_range;
    }
    transmission_fixed_gear_difference(11, 13, &whole[0][0], &late[0][0], &early[0][0]);
    transmission_fixed_gear_insert(11, 12, 12, 0, 11, 11, 1, &s->transition[0][0], &late[0][0]);
    transmission_fixed_gear_insert(11, 12, 12, 0, 13, 11, 1, &s->transition[0][0], &early[0][0]);
    /* dead time = (d + f) h */
    s->M2_dead_steps = transmission_fixed_gear_floor(p->M2_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const transmission_fixed_gear_real M2_late_time = p->sample_time - transmission_fixed_gear_max(0.0,
        -s->M2_dead_steps * p->sample_time + p->M2_inverter_dead_time);
    if (!transmission_fixed_gear_discretise(11, 13, 5, &A[0][0], scale, M2_late_time, &late[0][0])) {
        return transmission_fixed_gear_plant_exponential_range;
    }
    transmission_fixed_gear_difference(11, 13, &whole[0][0], &late[0][0], &early[0][0]);
    transmission_fixed_gear_insert(11, 12, 12, 0, 12, 12, 1, &s->transition[0][0], &late[0][0]);
    transmission_fixed_gear_insert(11, 12, 12, 0, 14, 12, 1, &s->transition[0][0], &early[0][0]);
    return transmission_fixed_gear_plant_ok;
}

transmission_fixed_gear_plant_status transmission_fixed_gear_plant_update(transmission_fixed_gear_plant_state *s, const transmission_fixed_gear_plant_params *p)
{
    for (int k = 0; k < limit_count; ++k) {
        const transmission_fixed_gear_real value = *(const transmission_fixed_gear_real *)(const void *)((const char *)p + limits[k].offset);
        const int above = limits[k].open ? value > limits[k].least : value >= limits[k].least; /* false for NaN */
        if (!(above && value <= limits[k].most) || (limits[k].not_zero && value == 0.0)) {
            return (transmission_fixed_gear_plant_status)(2000 + k);
        }
    }
    return prepare(s, p);
}

void transmission_fixed_gear_plant_measure(const transmission_fixed_gear_plant_state *s, const transmission_fixed_gear_plant_params *p, transmission_fixed_gear_plant_outputs *out)
{
    out->M1_speed = s->x[0];
    out->flange1_torque = p->flange1_damping * s->x[0] - p->flange1_damping * s->x[2] + p->flange1_stiffness *
        s->x[5];
    out->flange2_torque = -p->flange2_damping * s->x[1] + p->flange2_damping * s->x[4] - p->flange2_stiffness *
        s->x[8];
    out->M2_speed = s->x[1];
    out->gearbox_input_torque = p->shaft1_damping * s->x[2] - p->shaft1_damping * s->x[3] + p->shaft1_stiffness *
        s->x[6];
    out->M1_torque = s->x[9];
    out->M2_torque = s->x[10];
}

/* Status of the first input that is not finite or outside its range. */
static int check_inputs(const transmission_fixed_gear_plant_inputs *in)
{
    if (!transmission_fixed_gear_is_finite(in->M1_torque_ref)) {
        return (int)transmission_fixed_gear_plant_bad_input_M1_torque_ref;
    }
    if (!transmission_fixed_gear_is_finite(in->M2_torque_ref)) {
        return (int)transmission_fixed_gear_plant_bad_input_M2_torque_ref;
    }
    if (!(in->gearbox_ratio >= 0.65 && in->gearbox_ratio <= 4.7)) {
        return (int)transmission_fixed_gear_plant_bad_input_gearbox_ratio;
    }
    return 0;
}

transmission_fixed_gear_plant_status transmission_fixed_gear_plant_step(transmission_fixed_gear_plant_state *s, const transmission_fixed_gear_plant_params *p,
    const transmission_fixed_gear_plant_inputs *in, transmission_fixed_gear_plant_outputs *out)
{
    const int bad = check_inputs(in);
    if (bad != 0) {
        transmission_fixed_gear_plant_measure(s, p, out);
        return (transmission_fixed_gear_plant_status)bad;
    }
    if (in->gearbox_ratio != s->gearbox_ratio_now) {
        const transmission_fixed_gear_plant_state before = *s;
        s->gearbox_ratio_now = in->gearbox_ratio;
        const transmission_fixed_gear_plant_status prepared = prepare(s, p);
        if (prepared != transmission_fixed_gear_plant_ok) { /* refused like a bad input: all stays as it was */
            *s = before;
            transmission_fixed_gear_plant_measure(s, p, out);
            return prepared;
        }
    }
    transmission_fixed_gear_real x_free[12];
    transmission_fixed_gear_zero(sizeof x_free, x_free);
    
    /* torque-speed envelope, Figure 7.1 */
    const transmission_fixed_gear_real M1_available = p->M1_speed_rated * p->M1_torque_max /
        transmission_fixed_gear_max(p->M1_speed_rated, transmission_fixed_gear_abs(s->x[0]));
    const transmission_fixed_gear_real M1_limited = transmission_fixed_gear_max(-M1_available,
        transmission_fixed_gear_min(M1_available, in->M1_torque_ref));
    /* dead time of the torque loop */
    transmission_fixed_gear_delay(16, s->M1_delay, M1_limited, s->M1_dead_steps, &s->x[11], &s->x[13]);
    /* torque-speed envelope, Figure 7.1 */
    const transmission_fixed_gear_real M2_available = p->M2_speed_rated * p->M2_torque_max /
        transmission_fixed_gear_max(p->M2_speed_rated, transmission_fixed_gear_abs(s->x[1]));
    const transmission_fixed_gear_real M2_limited = transmission_fixed_gear_max(-M2_available,
        transmission_fixed_gear_min(M2_available, in->M2_torque_ref));
    /* dead time of the torque loop */
    transmission_fixed_gear_delay(16, s->M2_delay, M2_limited, s->M2_dead_steps, &s->x[12], &s->x[14]);
    /* x+ = Phi x + Gamma_u u */
    transmission_fixed_gear_multiply(11, 15, &s->transition[0][0], s->x, x_free);
    s->x[0] = x_free[0];
    s->x[1] = x_free[1];
    s->x[2] = x_free[2];
    s->x[3] = x_free[3];
    s->x[4] = x_free[4];
    s->x[5] = x_free[5];
    s->x[6] = x_free[6];
    s->x[7] = x_free[7];
    s->x[8] = x_free[8];
    s->x[9] = x_free[9];
    s->x[10] = x_free[10];
    transmission_fixed_gear_plant_measure(s, p, out);
    return transmission_fixed_gear_plant_ok;
}
