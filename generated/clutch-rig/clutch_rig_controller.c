/*
 * clutch_rig_controller.c: controller of the bed clutch_rig
 *
 * Emitted by ptgen 0.1.0 from clutch-rig.toml (SHA-256 8a8f57b91ebde405), template block.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "clutch_rig_controller.h"

#include <float.h>
#include <string.h>

const clutch_rig_controller_params clutch_rig_controller_defaults = {
    .sample_time = 0.0001,
    .fault_ramp = 0.05,
    .M1_speed_ref_plausible = 942.4777960769385,
    .M2_speed_ref_plausible = 942.4777960769385,
    .M1_speed_plausible = 942.4777960769385,
    .flange1_torque_plausible = 1710.0,
    .flange2_torque_plausible = 1440.0,
    .M2_speed_plausible = 942.4777960769385,
    .load_compensation = 1.0,
    .acceleration_torque = 1.0,
    .switch_time = 0.5,
    .M1_speed_rated = 209.43951023932,
    .M1_speed_max = 628.318530717959,
    .M1_speed_taper = 31.4159,
    .M1_torque_max = 480.0,
    .M2_speed_rated = 209.43951023932,
    .M2_speed_max = 628.318530717959,
    .M2_speed_taper = 31.4159,
    .M2_torque_max = 480.0,
    .M1_speed_ref_rate = 1371.43,
    .M2_speed_ref_rate = 1371.43,
    .M1_speed_gain = 10.5,
    .M1_speed_integral_gain = 78.75,
    .M2_speed_gain = 10.5,
    .M2_speed_integral_gain = 78.75,
};

const clutch_rig_controller_params clutch_rig_controller_conventional = {
    .sample_time = 0.0001,
    .fault_ramp = 0.05,
    .M1_speed_ref_plausible = 942.4777960769385,
    .M2_speed_ref_plausible = 942.4777960769385,
    .M1_speed_plausible = 942.4777960769385,
    .flange1_torque_plausible = 1710.0,
    .flange2_torque_plausible = 1440.0,
    .M2_speed_plausible = 942.4777960769385,
    .load_compensation = 0.0,
    .acceleration_torque = 0.0,
    .switch_time = 0.5,
    .M1_speed_rated = 209.43951023932,
    .M1_speed_max = 628.318530717959,
    .M1_speed_taper = 31.4159,
    .M1_torque_max = 480.0,
    .M2_speed_rated = 209.43951023932,
    .M2_speed_max = 628.318530717959,
    .M2_speed_taper = 31.4159,
    .M2_torque_max = 480.0,
    .M1_speed_ref_rate = 1371.43,
    .M2_speed_ref_rate = 1371.43,
    .M1_speed_gain = 10.5,
    .M1_speed_integral_gain = 78.75,
    .M2_speed_gain = 10.5,
    .M2_speed_integral_gain = 78.75,
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
    { "the parameter sample_time is outside its range", offsetof(clutch_rig_controller_params, sample_time), 0.0, DBL_MAX, 1, 0 },
    { "the parameter fault_ramp is outside its range", offsetof(clutch_rig_controller_params, fault_ramp), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_ref_plausible is outside its range", offsetof(clutch_rig_controller_params, M1_speed_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_ref_plausible is outside its range", offsetof(clutch_rig_controller_params, M2_speed_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_plausible is outside its range", offsetof(clutch_rig_controller_params, M1_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_torque_plausible is outside its range", offsetof(clutch_rig_controller_params, flange1_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_torque_plausible is outside its range", offsetof(clutch_rig_controller_params, flange2_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_plausible is outside its range", offsetof(clutch_rig_controller_params, M2_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter load_compensation is outside its range", offsetof(clutch_rig_controller_params, load_compensation), 0.0, 1.0, 0, 0 },
    { "the parameter acceleration_torque is outside its range", offsetof(clutch_rig_controller_params, acceleration_torque), 0.0, 1.0, 0, 0 },
    { "the parameter switch_time is outside its range", offsetof(clutch_rig_controller_params, switch_time), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_rated is outside its range", offsetof(clutch_rig_controller_params, M1_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_max is outside its range", offsetof(clutch_rig_controller_params, M1_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_taper is outside its range", offsetof(clutch_rig_controller_params, M1_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_max is outside its range", offsetof(clutch_rig_controller_params, M1_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_rated is outside its range", offsetof(clutch_rig_controller_params, M2_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_max is outside its range", offsetof(clutch_rig_controller_params, M2_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_taper is outside its range", offsetof(clutch_rig_controller_params, M2_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_max is outside its range", offsetof(clutch_rig_controller_params, M2_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_ref_rate is outside its range", offsetof(clutch_rig_controller_params, M1_speed_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_ref_rate is outside its range", offsetof(clutch_rig_controller_params, M2_speed_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_gain is outside its range", offsetof(clutch_rig_controller_params, M1_speed_gain), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_integral_gain is outside its range", offsetof(clutch_rig_controller_params, M1_speed_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_speed_gain is outside its range", offsetof(clutch_rig_controller_params, M2_speed_gain), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_integral_gain is outside its range", offsetof(clutch_rig_controller_params, M2_speed_integral_gain), 0.0, DBL_MAX, 0, 0 },
};

enum { limit_count = sizeof limits / sizeof limits[0] };

const char *clutch_rig_controller_status_text(clutch_rig_controller_status status)
{
    switch ((int)status) {
    case clutch_rig_controller_ok:
        return "ok";
    case clutch_rig_controller_fault_M1_speed_ref:
        return "fault: M1_speed_ref was not finite or not plausible";
    case clutch_rig_controller_fault_M2_speed_ref:
        return "fault: M2_speed_ref was not finite or not plausible";
    case clutch_rig_controller_fault_M1_speed:
        return "fault: M1_speed was not finite or not plausible";
    case clutch_rig_controller_fault_flange1_torque:
        return "fault: flange1_torque was not finite or not plausible";
    case clutch_rig_controller_fault_flange2_torque:
        return "fault: flange2_torque was not finite or not plausible";
    case clutch_rig_controller_fault_M2_speed:
        return "fault: M2_speed was not finite or not plausible";
    case clutch_rig_controller_fault_M1_torque_ref:
        return "fault: M1_torque_ref was not finite or not plausible";
    case clutch_rig_controller_fault_M2_torque_ref:
        return "fault: M2_torque_ref was not finite or not plausible";
    default:
        break;
    }
    const int limit = (int)status - 2000;
    return limit >= 0 && limit < limit_count ? limits[limit].text : "unknown status";
}

clutch_rig_controller_status clutch_rig_controller_init(clutch_rig_controller_state *s, const clutch_rig_controller_params *p)
{
    memset(s, 0, sizeof *s);
    s->authority = 1.0;
    const clutch_rig_controller_status status = clutch_rig_controller_update(s, p);
    if (status != clutch_rig_controller_ok) {
        s->authority = 0.0; /* never started: no torque at all */
    }
    return status;
}

clutch_rig_controller_status clutch_rig_controller_update(clutch_rig_controller_state *s, const clutch_rig_controller_params *p)
{
    for (int k = 0; k < limit_count; ++k) {
        const clutch_rig_real value = *(const clutch_rig_real *)(const void *)((const char *)p + limits[k].offset);
        const int above = limits[k].open ? value > limits[k].least : value >= limits[k].least; /* false for NaN */
        if (!(above && value <= limits[k].most) || (limits[k].not_zero && value == 0.0)) {
            s->fault = s->fault > 0.0 ? s->fault : CLUTCH_RIG_REAL(2000 + k); /* latched like any fault */
            return (clutch_rig_controller_status)(2000 + k);
        }
    }
    s->switch_share = p->sample_time / p->switch_time;
    s->M1_taper_slope = 1.0 / p->M1_speed_taper;
    s->M1_taper_end = p->M1_speed_max / p->M1_speed_taper + 1.0;
    s->M2_taper_slope = 1.0 / p->M2_speed_taper;
    s->M2_taper_end = p->M2_speed_max / p->M2_speed_taper + 1.0;
    s->M1_speed_ref_step = p->M1_speed_ref_rate * p->sample_time;
    s->M2_speed_ref_step = p->M2_speed_ref_rate * p->sample_time;
    s->M1_speed_growth = p->M1_speed_integral_gain * p->sample_time;
    s->M1_speed_conditioning = p->M1_speed_integral_gain * p->sample_time / p->M1_speed_gain;
    s->M2_speed_growth = p->M2_speed_integral_gain * p->sample_time;
    s->M2_speed_conditioning = p->M2_speed_integral_gain * p->sample_time / p->M2_speed_gain;
    return clutch_rig_controller_ok;
}

clutch_rig_controller_status clutch_rig_controller_step(clutch_rig_controller_state *s, const clutch_rig_controller_params *p,
    const clutch_rig_controller_inputs *in, clutch_rig_controller_outputs *out)
{
    /* supervision */
    clutch_rig_real M1_speed_ref_sound;
    clutch_rig_guard(in->M1_speed_ref, p->M1_speed_ref_plausible, s->M1_speed_ref_held, &s->M1_speed_ref_held,
        &M1_speed_ref_sound);
    clutch_rig_real M2_speed_ref_sound;
    clutch_rig_guard(in->M2_speed_ref, p->M2_speed_ref_plausible, s->M2_speed_ref_held, &s->M2_speed_ref_held,
        &M2_speed_ref_sound);
    clutch_rig_real M1_speed_sound;
    clutch_rig_guard(in->M1_speed, p->M1_speed_plausible, s->M1_speed_held, &s->M1_speed_held, &M1_speed_sound);
    clutch_rig_real flange1_torque_sound;
    clutch_rig_guard(in->flange1_torque, p->flange1_torque_plausible, s->flange1_torque_held,
        &s->flange1_torque_held, &flange1_torque_sound);
    clutch_rig_real flange2_torque_sound;
    clutch_rig_guard(in->flange2_torque, p->flange2_torque_plausible, s->flange2_torque_held,
        &s->flange2_torque_held, &flange2_torque_sound);
    clutch_rig_real M2_speed_sound;
    clutch_rig_guard(in->M2_speed, p->M2_speed_plausible, s->M2_speed_held, &s->M2_speed_held, &M2_speed_sound);
    /* the first fault is latched */
    s->fault = ((M1_speed_ref_sound < 0.5 && s->fault < 0.5) ? 1.0 : s->fault);
    s->fault = ((M2_speed_ref_sound < 0.5 && s->fault < 0.5) ? 2.0 : s->fault);
    s->fault = ((M1_speed_sound < 0.5 && s->fault < 0.5) ? 3.0 : s->fault);
    s->fault = ((s->fault < 0.5 && flange1_torque_sound < 0.5) ? 4.0 : s->fault);
    s->fault = ((s->fault < 0.5 && flange2_torque_sound < 0.5) ? 5.0 : s->fault);
    s->fault = ((M2_speed_sound < 0.5 && s->fault < 0.5) ? 6.0 : s->fault);
    /* load_compensation follows its parameter along a ramp */
    const clutch_rig_real load_compensation_before = ((s->running > 0.5) ? s->load_compensation_now :
        p->load_compensation);
    const clutch_rig_real load_compensation_distance = p->load_compensation - load_compensation_before;
    const clutch_rig_real load_compensation_moved = ((p->load_compensation != s->load_compensation_target) ?
        clutch_rig_max(s->switch_share * clutch_rig_abs(load_compensation_distance), 1e-06 *
        clutch_rig_abs(p->load_compensation) + 1e-06 * clutch_rig_abs(load_compensation_before)) :
        s->load_compensation_step);
    s->load_compensation_now = ((load_compensation_moved >= clutch_rig_abs(load_compensation_distance)) ?
        p->load_compensation : ((load_compensation_distance > 0.0) ? load_compensation_before +
        load_compensation_moved : load_compensation_before - load_compensation_moved));
    s->load_compensation_step = ((load_compensation_moved >= clutch_rig_abs(load_compensation_distance)) ? 0.0 :
        load_compensation_moved);
    s->load_compensation_target = p->load_compensation;
    /* torque-speed envelope, Figure 7.1 */
    const clutch_rig_real M1_available = p->M1_speed_rated * p->M1_torque_max / clutch_rig_max(p->M1_speed_rated,
        clutch_rig_abs(s->M1_speed_held));
    const clutch_rig_real M1_least = -M1_available * clutch_rig_max(0.0, clutch_rig_min(1.0, s->M1_speed_held *
        s->M1_taper_slope + s->M1_taper_end));
    const clutch_rig_real M1_most = M1_available * clutch_rig_max(0.0, clutch_rig_min(1.0, -s->M1_speed_held *
        s->M1_taper_slope + s->M1_taper_end));
    const clutch_rig_real M2_available = p->M2_speed_rated * p->M2_torque_max / clutch_rig_max(p->M2_speed_rated,
        clutch_rig_abs(s->M2_speed_held));
    const clutch_rig_real M2_least = -M2_available * clutch_rig_max(0.0, clutch_rig_min(1.0, s->M2_speed_held *
        s->M2_taper_slope + s->M2_taper_end));
    const clutch_rig_real M2_most = M2_available * clutch_rig_max(0.0, clutch_rig_min(1.0, -s->M2_speed_held *
        s->M2_taper_slope + s->M2_taper_end));
    /* limit of the rate */
    const clutch_rig_real M1_speed_ref_before = ((s->running > 0.5) ? s->M1_speed_ref_limited : s->M1_speed_held);
    s->M1_speed_ref_limited = M1_speed_ref_before + clutch_rig_max(-s->M1_speed_ref_step,
        clutch_rig_min(s->M1_speed_ref_step, -M1_speed_ref_before + s->M1_speed_ref_held));
    const clutch_rig_real M2_speed_ref_before = ((s->running > 0.5) ? s->M2_speed_ref_limited : s->M2_speed_held);
    s->M2_speed_ref_limited = M2_speed_ref_before + clutch_rig_max(-s->M2_speed_ref_step,
        clutch_rig_min(s->M2_speed_ref_step, -M2_speed_ref_before + s->M2_speed_ref_held));
    const clutch_rig_real M1_speed_error = -s->M1_speed_held + s->M1_speed_ref_limited;
    /* load torque compensation (5.52), (5.74) */
    const clutch_rig_real M1_compensation = s->flange1_torque_held;
    /* so that a switch does not jump */
    const clutch_rig_real M1_given_away = M1_compensation * (load_compensation_before - s->load_compensation_now);
    /* PI speed control (5.84) */
    const clutch_rig_real M1_integral_before = ((p->M1_speed_integral_gain > 0.0) ? M1_given_away : 0.0) +
        ((s->running > 0.5) ? s->M1_speed_integral : 0.0);
    const clutch_rig_real M1_asked = M1_integral_before + M1_speed_error * p->M1_speed_gain;
    const clutch_rig_real M1_wanted = M1_asked + M1_compensation * s->load_compensation_now;
    /* torque-speed envelope */
    const clutch_rig_real M1_command = clutch_rig_max(M1_least, clutch_rig_min(M1_most, M1_wanted));
    /* what the limit cuts off */
    const clutch_rig_real M1_cut = M1_command - M1_wanted;
    /* conditioning anti-windup (Hanus) */
    s->M1_speed_integral = M1_cut * s->M1_speed_conditioning + M1_integral_before + M1_speed_error *
        s->M1_speed_growth;
    const clutch_rig_real M2_speed_error = -s->M2_speed_held + s->M2_speed_ref_limited;
    /* load torque compensation (5.52), (5.74) */
    const clutch_rig_real M2_compensation = -s->flange2_torque_held;
    /* so that a switch does not jump */
    const clutch_rig_real M2_given_away = M2_compensation * (load_compensation_before - s->load_compensation_now);
    /* PI speed control (5.84) */
    const clutch_rig_real M2_integral_before = ((p->M2_speed_integral_gain > 0.0) ? M2_given_away : 0.0) +
        ((s->running > 0.5) ? s->M2_speed_integral : 0.0);
    const clutch_rig_real M2_asked = M2_integral_before + M2_speed_error * p->M2_speed_gain;
    const clutch_rig_real M2_wanted = M2_asked + M2_compensation * s->load_compensation_now;
    /* torque-speed envelope */
    const clutch_rig_real M2_command = clutch_rig_max(M2_least, clutch_rig_min(M2_most, M2_wanted));
    /* what the limit cuts off */
    const clutch_rig_real M2_cut = M2_command - M2_wanted;
    /* conditioning anti-windup (Hanus) */
    s->M2_speed_integral = M2_cut * s->M2_speed_conditioning + M2_integral_before + M2_speed_error *
        s->M2_speed_growth;
    const clutch_rig_real M1_largest = 1.01 * p->M1_torque_max;
    /* only sound torques leave */
    clutch_rig_real M1_released;
    clutch_rig_real M1_released_sound;
    clutch_rig_guard(M1_command, M1_largest, s->M1_last, &M1_released, &M1_released_sound);
    const clutch_rig_real M2_largest = 1.01 * p->M2_torque_max;
    clutch_rig_real M2_released;
    clutch_rig_real M2_released_sound;
    clutch_rig_guard(M2_command, M2_largest, s->M2_last, &M2_released, &M2_released_sound);
    /* the first fault is latched */
    s->fault = ((M1_released_sound < 0.5 && s->fault < 0.5) ? 7.0 : s->fault);
    s->fault = ((M2_released_sound < 0.5 && s->fault < 0.5) ? 8.0 : s->fault);
    /* ramp to zero torque */
    s->authority = ((s->fault > 0.5) ? clutch_rig_max(0.0, s->authority - p->sample_time / p->fault_ramp) :
        s->authority);
    s->M1_last = ((s->fault > 0.5) ? s->M1_last : M1_released);
    out->M1_torque_ref = s->M1_last * s->authority;
    s->M2_last = ((s->fault > 0.5) ? s->M2_last : M2_released);
    out->M2_torque_ref = s->M2_last * s->authority;
    /* start anew after a fault */
    s->running = ((s->fault < 0.5) ? 1.0 : 0.0);
    /* The last line of defence, should parameters have been changed without an update. */
    if (!clutch_rig_is_finite(out->M1_torque_ref)) {
        out->M1_torque_ref = 0.0;
        s->fault = s->fault > 0.0 ? s->fault : CLUTCH_RIG_REAL(clutch_rig_controller_fault_M1_torque_ref);
    }
    if (!clutch_rig_is_finite(out->M2_torque_ref)) {
        out->M2_torque_ref = 0.0;
        s->fault = s->fault > 0.0 ? s->fault : CLUTCH_RIG_REAL(clutch_rig_controller_fault_M2_torque_ref);
    }
    return (clutch_rig_controller_status)s->fault;
}
