/*
 * differential_gearboxes_controller.c: controller of the bed differential_gearboxes
 *
 * Emitted by ptgen 0.1.0 from differential-gearboxes.toml (SHA-256 08abf4d695c2194f), template block.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "differential_gearboxes_controller.h"

#include <float.h>
#include <string.h>

const differential_gearboxes_controller_params differential_gearboxes_controller_defaults = {
    .sample_time = 0.0001,
    .fault_ramp = 0.05,
    .diff_outputs_torque_ref_plausible = 427000.0,
    .M2_speed_ref_plausible = 942.4777960769385,
    .M3_speed_ref_plausible = 942.4777960769385,
    .M1_speed_plausible = 942.4777960769385,
    .flange2_torque_plausible = 20500.0,
    .M2_speed_plausible = 942.4777960769385,
    .flange3_torque_plausible = 20500.0,
    .M3_speed_plausible = 942.4777960769385,
    .load_compensation = 1.0,
    .acceleration_torque = 1.0,
    .switch_time = 0.5,
    .M1_damping = 74.8226,
    .M1_speed_rated = 188.495559215388,
    .M1_speed_max = 628.318530717959,
    .M1_speed_taper = 31.4159,
    .M1_torque_max = 3700.0,
    .M2_speed_rated = 188.495559215388,
    .M2_speed_max = 628.318530717959,
    .M2_speed_taper = 31.4159,
    .M2_torque_max = 3700.0,
    .M3_speed_rated = 188.495559215388,
    .M3_speed_max = 628.318530717959,
    .M3_speed_taper = 31.4159,
    .M3_torque_max = 3700.0,
    .M2_speed_ref_rate = 359.223,
    .M3_speed_ref_rate = 359.223,
    .M2_speed_gain = 61.8,
    .M2_speed_integral_gain = 92.7,
    .M3_speed_gain = 61.8,
    .M3_speed_integral_gain = 92.7,
    .gearbox2_ratio = 10.4,
    .gearbox3_ratio = 10.4,
    .M2_inertia = 10.3,
    .gearbox2_inertia = 1.65,
    .M3_inertia = 10.3,
    .gearbox3_inertia = 1.65,
    .M1_sensor_inertia_M2 = 0.3328,
    .M1_sensor_inertia_M3 = 0.3016,
    .M1_inertia_estimate = 4.33657,
    .M1_feedforward = 1.0,
    .M1_torque_gain = 0.0,
    .diff_outputs_torque_ref_rate = 736865.0,
    .M1_model_stiffness = 322.745,
    .M1_model_damping = 74.8226,
    .M1_torque_model = 1.0,
    .diff_ratio = 2.85,
    .gearbox1_ratio = 8.1,
    .M1_torque_integral_gain = 2.0,
    .M1_damping_reserve = 0.1,
    .M1_torque_integral_limit = 42700.0,
};

const differential_gearboxes_controller_params differential_gearboxes_controller_conventional = {
    .sample_time = 0.0001,
    .fault_ramp = 0.05,
    .diff_outputs_torque_ref_plausible = 427000.0,
    .M2_speed_ref_plausible = 942.4777960769385,
    .M3_speed_ref_plausible = 942.4777960769385,
    .M1_speed_plausible = 942.4777960769385,
    .flange2_torque_plausible = 20500.0,
    .M2_speed_plausible = 942.4777960769385,
    .flange3_torque_plausible = 20500.0,
    .M3_speed_plausible = 942.4777960769385,
    .load_compensation = 0.0,
    .acceleration_torque = 0.0,
    .switch_time = 0.5,
    .M1_damping = 0.0,
    .M1_speed_rated = 188.495559215388,
    .M1_speed_max = 628.318530717959,
    .M1_speed_taper = 31.4159,
    .M1_torque_max = 3700.0,
    .M2_speed_rated = 188.495559215388,
    .M2_speed_max = 628.318530717959,
    .M2_speed_taper = 31.4159,
    .M2_torque_max = 3700.0,
    .M3_speed_rated = 188.495559215388,
    .M3_speed_max = 628.318530717959,
    .M3_speed_taper = 31.4159,
    .M3_torque_max = 3700.0,
    .M2_speed_ref_rate = 359.223,
    .M3_speed_ref_rate = 359.223,
    .M2_speed_gain = 61.8,
    .M2_speed_integral_gain = 92.7,
    .M3_speed_gain = 61.8,
    .M3_speed_integral_gain = 92.7,
    .gearbox2_ratio = 10.4,
    .gearbox3_ratio = 10.4,
    .M2_inertia = 10.3,
    .gearbox2_inertia = 1.65,
    .M3_inertia = 10.3,
    .gearbox3_inertia = 1.65,
    .M1_sensor_inertia_M2 = 0.3328,
    .M1_sensor_inertia_M3 = 0.3016,
    .M1_inertia_estimate = 4.33657,
    .M1_feedforward = 1.0,
    .M1_torque_gain = 0.0,
    .diff_outputs_torque_ref_rate = 736865.0,
    .M1_model_stiffness = 322.745,
    .M1_model_damping = 74.8226,
    .M1_torque_model = 0.0,
    .diff_ratio = 2.85,
    .gearbox1_ratio = 8.1,
    .M1_torque_integral_gain = 0.315824,
    .M1_damping_reserve = 0.1,
    .M1_torque_integral_limit = 42700.0,
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
    { "the parameter sample_time is outside its range", offsetof(differential_gearboxes_controller_params, sample_time), 0.0, DBL_MAX, 1, 0 },
    { "the parameter fault_ramp is outside its range", offsetof(differential_gearboxes_controller_params, fault_ramp), 0.0, DBL_MAX, 1, 0 },
    { "the parameter diff_outputs_torque_ref_plausible is outside its range", offsetof(differential_gearboxes_controller_params, diff_outputs_torque_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_ref_plausible is outside its range", offsetof(differential_gearboxes_controller_params, M2_speed_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_ref_plausible is outside its range", offsetof(differential_gearboxes_controller_params, M3_speed_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_plausible is outside its range", offsetof(differential_gearboxes_controller_params, M1_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_torque_plausible is outside its range", offsetof(differential_gearboxes_controller_params, flange2_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_plausible is outside its range", offsetof(differential_gearboxes_controller_params, M2_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_torque_plausible is outside its range", offsetof(differential_gearboxes_controller_params, flange3_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_plausible is outside its range", offsetof(differential_gearboxes_controller_params, M3_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter load_compensation is outside its range", offsetof(differential_gearboxes_controller_params, load_compensation), 0.0, 1.0, 0, 0 },
    { "the parameter acceleration_torque is outside its range", offsetof(differential_gearboxes_controller_params, acceleration_torque), 0.0, 1.0, 0, 0 },
    { "the parameter switch_time is outside its range", offsetof(differential_gearboxes_controller_params, switch_time), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_damping is outside its range", offsetof(differential_gearboxes_controller_params, M1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_speed_rated is outside its range", offsetof(differential_gearboxes_controller_params, M1_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_max is outside its range", offsetof(differential_gearboxes_controller_params, M1_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_taper is outside its range", offsetof(differential_gearboxes_controller_params, M1_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_max is outside its range", offsetof(differential_gearboxes_controller_params, M1_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_rated is outside its range", offsetof(differential_gearboxes_controller_params, M2_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_max is outside its range", offsetof(differential_gearboxes_controller_params, M2_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_taper is outside its range", offsetof(differential_gearboxes_controller_params, M2_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_max is outside its range", offsetof(differential_gearboxes_controller_params, M2_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_rated is outside its range", offsetof(differential_gearboxes_controller_params, M3_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_max is outside its range", offsetof(differential_gearboxes_controller_params, M3_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_taper is outside its range", offsetof(differential_gearboxes_controller_params, M3_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_torque_max is outside its range", offsetof(differential_gearboxes_controller_params, M3_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_ref_rate is outside its range", offsetof(differential_gearboxes_controller_params, M2_speed_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_ref_rate is outside its range", offsetof(differential_gearboxes_controller_params, M3_speed_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_gain is outside its range", offsetof(differential_gearboxes_controller_params, M2_speed_gain), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_integral_gain is outside its range", offsetof(differential_gearboxes_controller_params, M2_speed_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M3_speed_gain is outside its range", offsetof(differential_gearboxes_controller_params, M3_speed_gain), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_integral_gain is outside its range", offsetof(differential_gearboxes_controller_params, M3_speed_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gearbox2_ratio is outside its range", offsetof(differential_gearboxes_controller_params, gearbox2_ratio), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter gearbox3_ratio is outside its range", offsetof(differential_gearboxes_controller_params, gearbox3_ratio), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter M2_inertia is outside its range", offsetof(differential_gearboxes_controller_params, M2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gearbox2_inertia is outside its range", offsetof(differential_gearboxes_controller_params, gearbox2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_inertia is outside its range", offsetof(differential_gearboxes_controller_params, M3_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gearbox3_inertia is outside its range", offsetof(differential_gearboxes_controller_params, gearbox3_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_sensor_inertia_M2 is outside its range", offsetof(differential_gearboxes_controller_params, M1_sensor_inertia_M2), -DBL_MAX, DBL_MAX, 0, 0 },
    { "the parameter M1_sensor_inertia_M3 is outside its range", offsetof(differential_gearboxes_controller_params, M1_sensor_inertia_M3), -DBL_MAX, DBL_MAX, 0, 0 },
    { "the parameter M1_inertia_estimate is outside its range", offsetof(differential_gearboxes_controller_params, M1_inertia_estimate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_feedforward is outside its range", offsetof(differential_gearboxes_controller_params, M1_feedforward), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_torque_gain is outside its range", offsetof(differential_gearboxes_controller_params, M1_torque_gain), -1.0, DBL_MAX, 1, 0 },
    { "the parameter diff_outputs_torque_ref_rate is outside its range", offsetof(differential_gearboxes_controller_params, diff_outputs_torque_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_model_stiffness is outside its range", offsetof(differential_gearboxes_controller_params, M1_model_stiffness), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_model_damping is outside its range", offsetof(differential_gearboxes_controller_params, M1_model_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_torque_model is outside its range", offsetof(differential_gearboxes_controller_params, M1_torque_model), 0.0, 1.0, 0, 0 },
    { "the parameter diff_ratio is outside its range", offsetof(differential_gearboxes_controller_params, diff_ratio), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter gearbox1_ratio is outside its range", offsetof(differential_gearboxes_controller_params, gearbox1_ratio), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter M1_torque_integral_gain is outside its range", offsetof(differential_gearboxes_controller_params, M1_torque_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_damping_reserve is outside its range", offsetof(differential_gearboxes_controller_params, M1_damping_reserve), 0.0, 1.0, 0, 0 },
    { "the parameter M1_torque_integral_limit is outside its range", offsetof(differential_gearboxes_controller_params, M1_torque_integral_limit), 0.0, DBL_MAX, 0, 0 },
};

enum { limit_count = sizeof limits / sizeof limits[0] };

const char *differential_gearboxes_controller_status_text(differential_gearboxes_controller_status status)
{
    switch ((int)status) {
    case differential_gearboxes_controller_ok:
        return "ok";
    case differential_gearboxes_controller_fault_diff_outputs_torque_ref:
        return "fault: diff_outputs_torque_ref was not finite or not plausible";
    case differential_gearboxes_controller_fault_M2_speed_ref:
        return "fault: M2_speed_ref was not finite or not plausible";
    case differential_gearboxes_controller_fault_M3_speed_ref:
        return "fault: M3_speed_ref was not finite or not plausible";
    case differential_gearboxes_controller_fault_M1_speed:
        return "fault: M1_speed was not finite or not plausible";
    case differential_gearboxes_controller_fault_flange2_torque:
        return "fault: flange2_torque was not finite or not plausible";
    case differential_gearboxes_controller_fault_M2_speed:
        return "fault: M2_speed was not finite or not plausible";
    case differential_gearboxes_controller_fault_flange3_torque:
        return "fault: flange3_torque was not finite or not plausible";
    case differential_gearboxes_controller_fault_M3_speed:
        return "fault: M3_speed was not finite or not plausible";
    case differential_gearboxes_controller_fault_M1_torque_ref:
        return "fault: M1_torque_ref was not finite or not plausible";
    case differential_gearboxes_controller_fault_M2_torque_ref:
        return "fault: M2_torque_ref was not finite or not plausible";
    case differential_gearboxes_controller_fault_M3_torque_ref:
        return "fault: M3_torque_ref was not finite or not plausible";
    default:
        break;
    }
    const int limit = (int)status - 2000;
    return limit >= 0 && limit < limit_count ? limits[limit].text : "unknown status";
}

differential_gearboxes_controller_status differential_gearboxes_controller_init(differential_gearboxes_controller_state *s, const differential_gearboxes_controller_params *p)
{
    memset(s, 0, sizeof *s);
    s->authority = 1.0;
    const differential_gearboxes_controller_status status = differential_gearboxes_controller_update(s, p);
    if (status != differential_gearboxes_controller_ok) {
        s->authority = 0.0; /* never started: no torque at all */
    }
    return status;
}

differential_gearboxes_controller_status differential_gearboxes_controller_update(differential_gearboxes_controller_state *s, const differential_gearboxes_controller_params *p)
{
    for (int k = 0; k < limit_count; ++k) {
        const differential_gearboxes_real value = *(const differential_gearboxes_real *)(const void *)((const char *)p + limits[k].offset);
        const int above = limits[k].open ? value > limits[k].least : value >= limits[k].least; /* false for NaN */
        if (!(above && value <= limits[k].most) || (limits[k].not_zero && value == 0.0)) {
            s->fault = s->fault > 0.0 ? s->fault : DIFFERENTIAL_GEARBOXES_REAL(2000 + k); /* latched like any fault */
            return (differential_gearboxes_controller_status)(2000 + k);
        }
    }
    s->switch_share = p->sample_time / p->switch_time;
    s->M1_taper_slope = 1.0 / p->M1_speed_taper;
    s->M1_taper_end = p->M1_speed_max / p->M1_speed_taper + 1.0;
    s->M2_taper_slope = 1.0 / p->M2_speed_taper;
    s->M2_taper_end = p->M2_speed_max / p->M2_speed_taper + 1.0;
    s->M3_taper_slope = 1.0 / p->M3_speed_taper;
    s->M3_taper_end = p->M3_speed_max / p->M3_speed_taper + 1.0;
    s->M2_speed_ref_step = p->M2_speed_ref_rate * p->sample_time;
    s->M3_speed_ref_step = p->M3_speed_ref_rate * p->sample_time;
    s->M2_speed_growth = p->M2_speed_integral_gain * p->sample_time;
    s->M2_speed_conditioning = p->M2_speed_integral_gain * p->sample_time / p->M2_speed_gain;
    s->M3_speed_growth = p->M3_speed_integral_gain * p->sample_time;
    s->M3_speed_conditioning = p->M3_speed_integral_gain * p->sample_time / p->M3_speed_gain;
    s->M1_read_M2 = p->gearbox2_inertia * p->gearbox2_ratio / p->M2_inertia;
    s->M1_read_M3 = p->gearbox3_inertia * p->gearbox3_ratio / p->M3_inertia;
    s->M1_unread_M2 = p->M1_sensor_inertia_M2 / p->M2_inertia;
    s->M1_unread_M3 = p->M1_sensor_inertia_M3 / p->M3_inertia;
    s->diff_outputs_torque_ref_step = p->diff_outputs_torque_ref_rate * p->sample_time;
    s->M1_model_pull = p->M1_model_stiffness * p->sample_time / p->M1_inertia_estimate;
    s->M1_model_drag = p->M1_model_damping * p->sample_time / p->M1_inertia_estimate;
    s->M1_with_M2 = (0.5) * p->M1_inertia_estimate * p->diff_ratio * p->gearbox1_ratio / (p->M2_inertia *
        p->gearbox2_ratio);
    s->M1_with_M3 = (0.5) * p->M1_inertia_estimate * p->diff_ratio * p->gearbox1_ratio / (p->M3_inertia *
        p->gearbox3_ratio);
    s->M1_share_M1 = 1.0 / (p->diff_ratio * p->gearbox1_ratio);
    s->M1_twist_M2_speed = (0.5) * p->diff_ratio * p->gearbox1_ratio / p->gearbox2_ratio;
    s->M1_twist_M3_speed = (0.5) * p->diff_ratio * p->gearbox1_ratio / p->gearbox3_ratio;
    s->M1_torque_growth = p->M1_torque_integral_gain * p->sample_time;
    s->M1_share = 1.0 / (p->diff_ratio * p->gearbox1_ratio);
    return differential_gearboxes_controller_ok;
}

differential_gearboxes_controller_status differential_gearboxes_controller_step(differential_gearboxes_controller_state *s, const differential_gearboxes_controller_params *p,
    const differential_gearboxes_controller_inputs *in, differential_gearboxes_controller_outputs *out)
{
    /* supervision */
    differential_gearboxes_real diff_outputs_torque_ref_sound;
    differential_gearboxes_guard(in->diff_outputs_torque_ref, p->diff_outputs_torque_ref_plausible,
        s->diff_outputs_torque_ref_held, &s->diff_outputs_torque_ref_held, &diff_outputs_torque_ref_sound);
    differential_gearboxes_real M2_speed_ref_sound;
    differential_gearboxes_guard(in->M2_speed_ref, p->M2_speed_ref_plausible, s->M2_speed_ref_held,
        &s->M2_speed_ref_held, &M2_speed_ref_sound);
    differential_gearboxes_real M3_speed_ref_sound;
    differential_gearboxes_guard(in->M3_speed_ref, p->M3_speed_ref_plausible, s->M3_speed_ref_held,
        &s->M3_speed_ref_held, &M3_speed_ref_sound);
    differential_gearboxes_real M1_speed_sound;
    differential_gearboxes_guard(in->M1_speed, p->M1_speed_plausible, s->M1_speed_held, &s->M1_speed_held,
        &M1_speed_sound);
    differential_gearboxes_real flange2_torque_sound;
    differential_gearboxes_guard(in->flange2_torque, p->flange2_torque_plausible, s->flange2_torque_held,
        &s->flange2_torque_held, &flange2_torque_sound);
    differential_gearboxes_real M2_speed_sound;
    differential_gearboxes_guard(in->M2_speed, p->M2_speed_plausible, s->M2_speed_held, &s->M2_speed_held,
        &M2_speed_sound);
    differential_gearboxes_real flange3_torque_sound;
    differential_gearboxes_guard(in->flange3_torque, p->flange3_torque_plausible, s->flange3_torque_held,
        &s->flange3_torque_held, &flange3_torque_sound);
    differential_gearboxes_real M3_speed_sound;
    differential_gearboxes_guard(in->M3_speed, p->M3_speed_plausible, s->M3_speed_held, &s->M3_speed_held,
        &M3_speed_sound);
    /* the first fault is latched */
    s->fault = ((diff_outputs_torque_ref_sound < 0.5 && s->fault < 0.5) ? 1.0 : s->fault);
    s->fault = ((M2_speed_ref_sound < 0.5 && s->fault < 0.5) ? 2.0 : s->fault);
    s->fault = ((M3_speed_ref_sound < 0.5 && s->fault < 0.5) ? 3.0 : s->fault);
    s->fault = ((M1_speed_sound < 0.5 && s->fault < 0.5) ? 4.0 : s->fault);
    s->fault = ((s->fault < 0.5 && flange2_torque_sound < 0.5) ? 5.0 : s->fault);
    s->fault = ((M2_speed_sound < 0.5 && s->fault < 0.5) ? 6.0 : s->fault);
    s->fault = ((s->fault < 0.5 && flange3_torque_sound < 0.5) ? 7.0 : s->fault);
    s->fault = ((M3_speed_sound < 0.5 && s->fault < 0.5) ? 8.0 : s->fault);
    /* load_compensation follows its parameter along a ramp */
    const differential_gearboxes_real load_compensation_before = ((s->running > 0.5) ? s->load_compensation_now :
        p->load_compensation);
    const differential_gearboxes_real load_compensation_distance = p->load_compensation - load_compensation_before;
    const differential_gearboxes_real load_compensation_moved = ((p->load_compensation !=
        s->load_compensation_target) ? differential_gearboxes_max(s->switch_share *
        differential_gearboxes_abs(load_compensation_distance), 1e-06 *
        differential_gearboxes_abs(p->load_compensation) + 1e-06 *
        differential_gearboxes_abs(load_compensation_before)) : s->load_compensation_step);
    s->load_compensation_now = ((load_compensation_moved >= differential_gearboxes_abs(load_compensation_distance))
        ? p->load_compensation : ((load_compensation_distance > 0.0) ? load_compensation_before +
        load_compensation_moved : load_compensation_before - load_compensation_moved));
    s->load_compensation_step = ((load_compensation_moved >= differential_gearboxes_abs(load_compensation_distance))
        ? 0.0 : load_compensation_moved);
    s->load_compensation_target = p->load_compensation;
    /* acceleration_torque follows its parameter along a ramp */
    const differential_gearboxes_real acceleration_torque_before = ((s->running > 0.5) ? s->acceleration_torque_now
        : p->acceleration_torque);
    const differential_gearboxes_real acceleration_torque_distance = p->acceleration_torque -
        acceleration_torque_before;
    const differential_gearboxes_real acceleration_torque_moved = ((p->acceleration_torque !=
        s->acceleration_torque_target) ? differential_gearboxes_max(s->switch_share *
        differential_gearboxes_abs(acceleration_torque_distance), 1e-06 *
        differential_gearboxes_abs(p->acceleration_torque) + 1e-06 *
        differential_gearboxes_abs(acceleration_torque_before)) : s->acceleration_torque_step);
    s->acceleration_torque_now = ((acceleration_torque_moved >=
        differential_gearboxes_abs(acceleration_torque_distance)) ? p->acceleration_torque :
        ((acceleration_torque_distance > 0.0) ? acceleration_torque_before + acceleration_torque_moved :
        acceleration_torque_before - acceleration_torque_moved));
    s->acceleration_torque_step = ((acceleration_torque_moved >=
        differential_gearboxes_abs(acceleration_torque_distance)) ? 0.0 : acceleration_torque_moved);
    s->acceleration_torque_target = p->acceleration_torque;
    /* M1_damping follows its parameter along a ramp */
    const differential_gearboxes_real M1_damping_before = ((s->running > 0.5) ? s->M1_damping_now : p->M1_damping);
    const differential_gearboxes_real M1_damping_distance = p->M1_damping - M1_damping_before;
    const differential_gearboxes_real M1_damping_moved = ((p->M1_damping != s->M1_damping_target) ?
        differential_gearboxes_max(s->switch_share * differential_gearboxes_abs(M1_damping_distance), 1e-06 *
        differential_gearboxes_abs(p->M1_damping) + 1e-06 * differential_gearboxes_abs(M1_damping_before)) :
        s->M1_damping_step);
    s->M1_damping_now = ((M1_damping_moved >= differential_gearboxes_abs(M1_damping_distance)) ? p->M1_damping :
        ((M1_damping_distance > 0.0) ? M1_damping_before + M1_damping_moved : M1_damping_before -
        M1_damping_moved));
    s->M1_damping_step = ((M1_damping_moved >= differential_gearboxes_abs(M1_damping_distance)) ? 0.0 :
        M1_damping_moved);
    s->M1_damping_target = p->M1_damping;
    /* torque-speed envelope, Figure 7.1 */
    const differential_gearboxes_real M1_available = p->M1_speed_rated * p->M1_torque_max /
        differential_gearboxes_max(p->M1_speed_rated, differential_gearboxes_abs(s->M1_speed_held));
    const differential_gearboxes_real M1_least = -M1_available * differential_gearboxes_max(0.0,
        differential_gearboxes_min(1.0, s->M1_speed_held * s->M1_taper_slope + s->M1_taper_end));
    const differential_gearboxes_real M1_most = M1_available * differential_gearboxes_max(0.0,
        differential_gearboxes_min(1.0, -s->M1_speed_held * s->M1_taper_slope + s->M1_taper_end));
    const differential_gearboxes_real M2_available = p->M2_speed_rated * p->M2_torque_max /
        differential_gearboxes_max(p->M2_speed_rated, differential_gearboxes_abs(s->M2_speed_held));
    const differential_gearboxes_real M2_least = -M2_available * differential_gearboxes_max(0.0,
        differential_gearboxes_min(1.0, s->M2_speed_held * s->M2_taper_slope + s->M2_taper_end));
    const differential_gearboxes_real M2_most = M2_available * differential_gearboxes_max(0.0,
        differential_gearboxes_min(1.0, -s->M2_speed_held * s->M2_taper_slope + s->M2_taper_end));
    const differential_gearboxes_real M3_available = p->M3_speed_rated * p->M3_torque_max /
        differential_gearboxes_max(p->M3_speed_rated, differential_gearboxes_abs(s->M3_speed_held));
    const differential_gearboxes_real M3_least = -M3_available * differential_gearboxes_max(0.0,
        differential_gearboxes_min(1.0, s->M3_speed_held * s->M3_taper_slope + s->M3_taper_end));
    const differential_gearboxes_real M3_most = M3_available * differential_gearboxes_max(0.0,
        differential_gearboxes_min(1.0, -s->M3_speed_held * s->M3_taper_slope + s->M3_taper_end));
    /* limit of the rate */
    const differential_gearboxes_real M2_speed_ref_before = ((s->running > 0.5) ? s->M2_speed_ref_limited :
        s->M2_speed_held);
    s->M2_speed_ref_limited = M2_speed_ref_before + differential_gearboxes_max(-s->M2_speed_ref_step,
        differential_gearboxes_min(s->M2_speed_ref_step, -M2_speed_ref_before + s->M2_speed_ref_held));
    const differential_gearboxes_real M3_speed_ref_before = ((s->running > 0.5) ? s->M3_speed_ref_limited :
        s->M3_speed_held);
    s->M3_speed_ref_limited = M3_speed_ref_before + differential_gearboxes_max(-s->M3_speed_ref_step,
        differential_gearboxes_min(s->M3_speed_ref_step, -M3_speed_ref_before + s->M3_speed_ref_held));
    const differential_gearboxes_real M2_speed_error = -s->M2_speed_held + s->M2_speed_ref_limited;
    /* load torque compensation (5.52), (5.74) */
    const differential_gearboxes_real M2_compensation = -s->flange2_torque_held;
    /* so that a switch does not jump */
    const differential_gearboxes_real M2_given_away = M2_compensation * (load_compensation_before -
        s->load_compensation_now);
    /* PI speed control (5.84) */
    const differential_gearboxes_real M2_integral_before = ((p->M2_speed_integral_gain > 0.0) ? M2_given_away : 0.0)
        + ((s->running > 0.5) ? s->M2_speed_integral : 0.0);
    const differential_gearboxes_real M2_asked = M2_integral_before + M2_speed_error * p->M2_speed_gain;
    const differential_gearboxes_real M2_wanted = M2_asked + M2_compensation * s->load_compensation_now;
    /* torque-speed envelope */
    const differential_gearboxes_real M2_command = differential_gearboxes_max(M2_least,
        differential_gearboxes_min(M2_most, M2_wanted));
    /* what the limit cuts off */
    const differential_gearboxes_real M2_cut = M2_command - M2_wanted;
    /* conditioning anti-windup (Hanus) */
    s->M2_speed_integral = M2_cut * s->M2_speed_conditioning + M2_integral_before + M2_speed_error *
        s->M2_speed_growth;
    /* net torque on the rotor */
    const differential_gearboxes_real M2_net = M2_command - M2_compensation;
    const differential_gearboxes_real M3_speed_error = -s->M3_speed_held + s->M3_speed_ref_limited;
    /* load torque compensation (5.52), (5.74) */
    const differential_gearboxes_real M3_compensation = -s->flange3_torque_held;
    /* so that a switch does not jump */
    const differential_gearboxes_real M3_given_away = M3_compensation * (load_compensation_before -
        s->load_compensation_now);
    /* PI speed control (5.84) */
    const differential_gearboxes_real M3_integral_before = ((p->M3_speed_integral_gain > 0.0) ? M3_given_away : 0.0)
        + ((s->running > 0.5) ? s->M3_speed_integral : 0.0);
    const differential_gearboxes_real M3_asked = M3_integral_before + M3_speed_error * p->M3_speed_gain;
    const differential_gearboxes_real M3_wanted = M3_asked + M3_compensation * s->load_compensation_now;
    /* torque-speed envelope */
    const differential_gearboxes_real M3_command = differential_gearboxes_max(M3_least,
        differential_gearboxes_min(M3_most, M3_wanted));
    /* what the limit cuts off */
    const differential_gearboxes_real M3_cut = M3_command - M3_wanted;
    /* conditioning anti-windup (Hanus) */
    s->M3_speed_integral = M3_cut * s->M3_speed_conditioning + M3_integral_before + M3_speed_error *
        s->M3_speed_growth;
    /* net torque on the rotor */
    const differential_gearboxes_real M3_net = M3_command - M3_compensation;
    /* testing torque from the sensors (5.95), (5.96), (5.98) */
    const differential_gearboxes_real diff_outputs_torque_estimate = s->M1_read_M2 * M2_net + s->M1_read_M3 * M3_net
        + s->M1_unread_M2 * M2_net + s->M1_unread_M3 * M3_net + s->flange2_torque_held * p->gearbox2_ratio +
        s->flange3_torque_held * p->gearbox3_ratio;
    /* limit of the rate */
    const differential_gearboxes_real diff_outputs_torque_ref_before = ((s->running > 0.5) ?
        s->diff_outputs_torque_ref_limited : diff_outputs_torque_estimate);
    s->diff_outputs_torque_ref_limited = diff_outputs_torque_ref_before +
        differential_gearboxes_max(-s->diff_outputs_torque_ref_step,
        differential_gearboxes_min(s->diff_outputs_torque_ref_step, -diff_outputs_torque_ref_before +
        s->diff_outputs_torque_ref_held));
    /* torque model (5.57), (5.76) */
    const differential_gearboxes_real M1_model_before = ((s->running > 0.5) ? s->M1_model_torque :
        diff_outputs_torque_estimate);
    const differential_gearboxes_real M1_rate_before = ((s->running > 0.5) ? s->M1_model_rate : 0.0);
    s->M1_model_rate = -s->M1_model_drag * M1_rate_before + s->M1_model_pull * (-M1_model_before +
        s->diff_outputs_torque_ref_limited) + M1_rate_before;
    s->M1_model_torque = M1_model_before + s->M1_model_rate * p->sample_time;
    const differential_gearboxes_real M1_torque_error = s->M1_model_torque * p->M1_torque_model -
        diff_outputs_torque_estimate + s->diff_outputs_torque_ref_limited * (1.0 - p->M1_torque_model);
    /* torque control (5.99) */
    const differential_gearboxes_real M1_integral_before = ((s->running > 0.5) ? s->M1_torque_integral : 0.0);
    const differential_gearboxes_real M1_virtual = p->M1_feedforward * s->diff_outputs_torque_ref_limited +
        M1_integral_before + M1_torque_error * p->M1_torque_gain;
    /* active damping (5.62), (5.78) */
    const differential_gearboxes_real M1_twist_rate_M1 = -s->M1_speed_held + s->M1_twist_M2_speed * s->M2_speed_held
        + s->M1_twist_M3_speed * s->M3_speed_held;
    const differential_gearboxes_real M1_damping_torque = s->M1_damping_now * M1_twist_rate_M1;
    /* with the acceleration torque (5.62), (5.78) */
    const differential_gearboxes_real M1_wanted = s->M1_share_M1 * M1_virtual + s->acceleration_torque_now *
        (s->M1_with_M2 * M2_net + s->M1_with_M3 * M3_net);
    /* reserve for active damping */
    const differential_gearboxes_real M1_kept = differential_gearboxes_max(M1_least * (1.0 - p->M1_damping_reserve),
        differential_gearboxes_min(M1_wanted, M1_most * (1.0 - p->M1_damping_reserve)));
    /* torque-speed envelope */
    const differential_gearboxes_real M1_command = differential_gearboxes_max(M1_least,
        differential_gearboxes_min(M1_most, M1_damping_torque + M1_kept));
    /* limited integrator */
    s->M1_torque_integral = ((s->M1_share * M1_torque_error * (-M1_kept + M1_wanted) > 0.0) ? M1_integral_before :
        differential_gearboxes_max(-p->M1_torque_integral_limit,
        differential_gearboxes_min(p->M1_torque_integral_limit, M1_integral_before + M1_torque_error *
        s->M1_torque_growth)));
    const differential_gearboxes_real M1_largest = 1.01 * p->M1_torque_max;
    /* only sound torques leave */
    differential_gearboxes_real M1_released;
    differential_gearboxes_real M1_released_sound;
    differential_gearboxes_guard(M1_command, M1_largest, s->M1_last, &M1_released, &M1_released_sound);
    const differential_gearboxes_real M2_largest = 1.01 * p->M2_torque_max;
    differential_gearboxes_real M2_released;
    differential_gearboxes_real M2_released_sound;
    differential_gearboxes_guard(M2_command, M2_largest, s->M2_last, &M2_released, &M2_released_sound);
    const differential_gearboxes_real M3_largest = 1.01 * p->M3_torque_max;
    differential_gearboxes_real M3_released;
    differential_gearboxes_real M3_released_sound;
    differential_gearboxes_guard(M3_command, M3_largest, s->M3_last, &M3_released, &M3_released_sound);
    /* the first fault is latched */
    s->fault = ((M1_released_sound < 0.5 && s->fault < 0.5) ? 9.0 : s->fault);
    s->fault = ((M2_released_sound < 0.5 && s->fault < 0.5) ? 10.0 : s->fault);
    s->fault = ((M3_released_sound < 0.5 && s->fault < 0.5) ? 11.0 : s->fault);
    /* ramp to zero torque */
    s->authority = ((s->fault > 0.5) ? differential_gearboxes_max(0.0, s->authority - p->sample_time /
        p->fault_ramp) : s->authority);
    s->M1_last = ((s->fault > 0.5) ? s->M1_last : M1_released);
    out->M1_torque_ref = s->M1_last * s->authority;
    s->M2_last = ((s->fault > 0.5) ? s->M2_last : M2_released);
    out->M2_torque_ref = s->M2_last * s->authority;
    s->M3_last = ((s->fault > 0.5) ? s->M3_last : M3_released);
    out->M3_torque_ref = s->M3_last * s->authority;
    /* start anew after a fault */
    s->running = ((s->fault < 0.5) ? 1.0 : 0.0);
    /* The last line of defence, should parameters have been changed without an update. */
    if (!differential_gearboxes_is_finite(out->M1_torque_ref)) {
        out->M1_torque_ref = 0.0;
        s->fault = s->fault > 0.0 ? s->fault : DIFFERENTIAL_GEARBOXES_REAL(differential_gearboxes_controller_fault_M1_torque_ref);
    }
    if (!differential_gearboxes_is_finite(out->M2_torque_ref)) {
        out->M2_torque_ref = 0.0;
        s->fault = s->fault > 0.0 ? s->fault : DIFFERENTIAL_GEARBOXES_REAL(differential_gearboxes_controller_fault_M2_torque_ref);
    }
    if (!differential_gearboxes_is_finite(out->M3_torque_ref)) {
        out->M3_torque_ref = 0.0;
        s->fault = s->fault > 0.0 ? s->fault : DIFFERENTIAL_GEARBOXES_REAL(differential_gearboxes_controller_fault_M3_torque_ref);
    }
    return (differential_gearboxes_controller_status)s->fault;
}
