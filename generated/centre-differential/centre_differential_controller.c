/*
 * centre_differential_controller.c: controller of the bed centre_differential
 *
 * Emitted by ptgen 0.1.0 from centre-differential.toml (SHA-256 11edcc3b908b78c3), template block.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "centre_differential_controller.h"

#include <float.h>
#include <string.h>

const centre_differential_controller_params centre_differential_controller_defaults = {
    .sample_time = 0.0001,
    .fault_ramp = 0.05,
    .flange2_torque_ref_plausible = 6000.0,
    .flange3_torque_ref_plausible = 6000.0,
    .M1_speed_ref_plausible = 1413.716694115407,
    .M1_speed_plausible = 1413.716694115407,
    .flange1_torque_plausible = 5190.0,
    .flange2_torque_plausible = 6000.0,
    .M2_speed_plausible = 942.4777960769385,
    .flange3_torque_plausible = 6000.0,
    .M3_speed_plausible = 942.4777960769385,
    .load_compensation = 1.0,
    .acceleration_torque = 1.0,
    .switch_time = 0.5,
    .M2_damping = 134.304,
    .M3_damping = 114.096,
    .M1_speed_rated = 699.946843219806,
    .M1_speed_max = 942.477796076938,
    .M1_speed_taper = 47.1239,
    .M1_torque_max = 930.0,
    .M2_speed_rated = 251.327412287183,
    .M2_speed_max = 628.318530717959,
    .M2_speed_taper = 31.4159,
    .M2_torque_max = 1200.0,
    .M3_speed_rated = 251.327412287183,
    .M3_speed_max = 628.318530717959,
    .M3_speed_taper = 31.4159,
    .M3_torque_max = 1200.0,
    .M1_speed_ref_rate = 930.0,
    .M1_speed_gain = 15.0,
    .M1_speed_integral_gain = 56.25,
    .M2_sensor_inertia_M1 = 0.0,
    .M1_inertia = 1.0,
    .M2_inertia_estimate = 1.9,
    .M2_feedforward = 1.0,
    .M2_torque_gain = 0.0,
    .flange2_torque_ref_rate = 84823.7,
    .M2_model_stiffness = 9493.47,
    .M2_model_damping = 134.304,
    .M2_torque_model = 1.0,
    .M3_sensor_inertia_M1 = 0.0,
    .M3_inertia_estimate = 1.9,
    .M3_feedforward = 1.0,
    .M3_torque_gain = 0.0,
    .flange3_torque_ref_rate = 72060.4,
    .M3_model_stiffness = 6851.48,
    .M3_model_damping = 114.096,
    .M3_torque_model = 1.0,
    .cardan2_flange2_equivalent_stiffness = 9493.474505177111,
    .flange1_cardan1_cardan2_flange2_equivalent_stiffness = -8214.194052548717,
    .diff_ratio = 1.0,
    .M2_torque_integral_gain = 10.0,
    .M2_damping_reserve = 0.1,
    .M2_torque_integral_limit = 600.0,
    .flange1_cardan1_equivalent_stiffness = 13786.395865973578,
    .M3_torque_integral_gain = 10.0,
    .M3_damping_reserve = 0.1,
    .M3_torque_integral_limit = 600.0,
};

const centre_differential_controller_params centre_differential_controller_conventional = {
    .sample_time = 0.0001,
    .fault_ramp = 0.05,
    .flange2_torque_ref_plausible = 6000.0,
    .flange3_torque_ref_plausible = 6000.0,
    .M1_speed_ref_plausible = 1413.716694115407,
    .M1_speed_plausible = 1413.716694115407,
    .flange1_torque_plausible = 5190.0,
    .flange2_torque_plausible = 6000.0,
    .M2_speed_plausible = 942.4777960769385,
    .flange3_torque_plausible = 6000.0,
    .M3_speed_plausible = 942.4777960769385,
    .load_compensation = 0.0,
    .acceleration_torque = 0.0,
    .switch_time = 0.5,
    .M2_damping = 0.0,
    .M3_damping = 0.0,
    .M1_speed_rated = 699.946843219806,
    .M1_speed_max = 942.477796076938,
    .M1_speed_taper = 47.1239,
    .M1_torque_max = 930.0,
    .M2_speed_rated = 251.327412287183,
    .M2_speed_max = 628.318530717959,
    .M2_speed_taper = 31.4159,
    .M2_torque_max = 1200.0,
    .M3_speed_rated = 251.327412287183,
    .M3_speed_max = 628.318530717959,
    .M3_speed_taper = 31.4159,
    .M3_torque_max = 1200.0,
    .M1_speed_ref_rate = 930.0,
    .M1_speed_gain = 15.0,
    .M1_speed_integral_gain = 56.25,
    .M2_sensor_inertia_M1 = 0.0,
    .M1_inertia = 1.0,
    .M2_inertia_estimate = 1.9,
    .M2_feedforward = 1.0,
    .M2_torque_gain = 0.0,
    .flange2_torque_ref_rate = 84823.7,
    .M2_model_stiffness = 9493.47,
    .M2_model_damping = 134.304,
    .M2_torque_model = 0.0,
    .M3_sensor_inertia_M1 = 0.0,
    .M3_inertia_estimate = 1.9,
    .M3_feedforward = 1.0,
    .M3_torque_gain = 0.0,
    .flange3_torque_ref_rate = 72060.4,
    .M3_model_stiffness = 6851.48,
    .M3_model_damping = 114.096,
    .M3_torque_model = 0.0,
    .cardan2_flange2_equivalent_stiffness = 9493.474505177111,
    .flange1_cardan1_cardan2_flange2_equivalent_stiffness = -8214.194052548717,
    .diff_ratio = 1.0,
    .M2_torque_integral_gain = 0.250545,
    .M2_damping_reserve = 0.1,
    .M2_torque_integral_limit = 600.0,
    .flange1_cardan1_equivalent_stiffness = 13786.395865973578,
    .M3_torque_integral_gain = 0.250545,
    .M3_damping_reserve = 0.1,
    .M3_torque_integral_limit = 600.0,
};

/* Range of each parameter; `open` excludes the lower bound. The order is that of the status codes. */
static const struct {
    const char *text;
    size_t offset;
    centre_differential_real least;
    centre_differential_real most;
    int open;
    int not_zero;
} limits[] = {
    { "the parameter sample_time is outside its range", offsetof(centre_differential_controller_params, sample_time), 0.0, DBL_MAX, 1, 0 },
    { "the parameter fault_ramp is outside its range", offsetof(centre_differential_controller_params, fault_ramp), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_torque_ref_plausible is outside its range", offsetof(centre_differential_controller_params, flange2_torque_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_torque_ref_plausible is outside its range", offsetof(centre_differential_controller_params, flange3_torque_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_ref_plausible is outside its range", offsetof(centre_differential_controller_params, M1_speed_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_plausible is outside its range", offsetof(centre_differential_controller_params, M1_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_torque_plausible is outside its range", offsetof(centre_differential_controller_params, flange1_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_torque_plausible is outside its range", offsetof(centre_differential_controller_params, flange2_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_plausible is outside its range", offsetof(centre_differential_controller_params, M2_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_torque_plausible is outside its range", offsetof(centre_differential_controller_params, flange3_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_plausible is outside its range", offsetof(centre_differential_controller_params, M3_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter load_compensation is outside its range", offsetof(centre_differential_controller_params, load_compensation), 0.0, 1.0, 0, 0 },
    { "the parameter acceleration_torque is outside its range", offsetof(centre_differential_controller_params, acceleration_torque), 0.0, 1.0, 0, 0 },
    { "the parameter switch_time is outside its range", offsetof(centre_differential_controller_params, switch_time), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_damping is outside its range", offsetof(centre_differential_controller_params, M2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M3_damping is outside its range", offsetof(centre_differential_controller_params, M3_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_speed_rated is outside its range", offsetof(centre_differential_controller_params, M1_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_max is outside its range", offsetof(centre_differential_controller_params, M1_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_taper is outside its range", offsetof(centre_differential_controller_params, M1_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_max is outside its range", offsetof(centre_differential_controller_params, M1_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_rated is outside its range", offsetof(centre_differential_controller_params, M2_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_max is outside its range", offsetof(centre_differential_controller_params, M2_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_taper is outside its range", offsetof(centre_differential_controller_params, M2_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_max is outside its range", offsetof(centre_differential_controller_params, M2_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_rated is outside its range", offsetof(centre_differential_controller_params, M3_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_max is outside its range", offsetof(centre_differential_controller_params, M3_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_taper is outside its range", offsetof(centre_differential_controller_params, M3_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_torque_max is outside its range", offsetof(centre_differential_controller_params, M3_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_ref_rate is outside its range", offsetof(centre_differential_controller_params, M1_speed_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_gain is outside its range", offsetof(centre_differential_controller_params, M1_speed_gain), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_integral_gain is outside its range", offsetof(centre_differential_controller_params, M1_speed_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_sensor_inertia_M1 is outside its range", offsetof(centre_differential_controller_params, M2_sensor_inertia_M1), -DBL_MAX, DBL_MAX, 0, 0 },
    { "the parameter M1_inertia is outside its range", offsetof(centre_differential_controller_params, M1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_inertia_estimate is outside its range", offsetof(centre_differential_controller_params, M2_inertia_estimate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_feedforward is outside its range", offsetof(centre_differential_controller_params, M2_feedforward), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_torque_gain is outside its range", offsetof(centre_differential_controller_params, M2_torque_gain), -1.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_torque_ref_rate is outside its range", offsetof(centre_differential_controller_params, flange2_torque_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_model_stiffness is outside its range", offsetof(centre_differential_controller_params, M2_model_stiffness), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_model_damping is outside its range", offsetof(centre_differential_controller_params, M2_model_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_torque_model is outside its range", offsetof(centre_differential_controller_params, M2_torque_model), 0.0, 1.0, 0, 0 },
    { "the parameter M3_sensor_inertia_M1 is outside its range", offsetof(centre_differential_controller_params, M3_sensor_inertia_M1), -DBL_MAX, DBL_MAX, 0, 0 },
    { "the parameter M3_inertia_estimate is outside its range", offsetof(centre_differential_controller_params, M3_inertia_estimate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_feedforward is outside its range", offsetof(centre_differential_controller_params, M3_feedforward), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M3_torque_gain is outside its range", offsetof(centre_differential_controller_params, M3_torque_gain), -1.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_torque_ref_rate is outside its range", offsetof(centre_differential_controller_params, flange3_torque_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_model_stiffness is outside its range", offsetof(centre_differential_controller_params, M3_model_stiffness), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M3_model_damping is outside its range", offsetof(centre_differential_controller_params, M3_model_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M3_torque_model is outside its range", offsetof(centre_differential_controller_params, M3_torque_model), 0.0, 1.0, 0, 0 },
    { "the parameter cardan2_flange2_equivalent_stiffness is outside its range", offsetof(centre_differential_controller_params, cardan2_flange2_equivalent_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_cardan1_cardan2_flange2_equivalent_stiffness is outside its range", offsetof(centre_differential_controller_params, flange1_cardan1_cardan2_flange2_equivalent_stiffness), -DBL_MAX, DBL_MAX, 0, 0 },
    { "the parameter diff_ratio is outside its range", offsetof(centre_differential_controller_params, diff_ratio), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter M2_torque_integral_gain is outside its range", offsetof(centre_differential_controller_params, M2_torque_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_damping_reserve is outside its range", offsetof(centre_differential_controller_params, M2_damping_reserve), 0.0, 1.0, 0, 0 },
    { "the parameter M2_torque_integral_limit is outside its range", offsetof(centre_differential_controller_params, M2_torque_integral_limit), 0.0, DBL_MAX, 0, 0 },
    { "the parameter flange1_cardan1_equivalent_stiffness is outside its range", offsetof(centre_differential_controller_params, flange1_cardan1_equivalent_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_torque_integral_gain is outside its range", offsetof(centre_differential_controller_params, M3_torque_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M3_damping_reserve is outside its range", offsetof(centre_differential_controller_params, M3_damping_reserve), 0.0, 1.0, 0, 0 },
    { "the parameter M3_torque_integral_limit is outside its range", offsetof(centre_differential_controller_params, M3_torque_integral_limit), 0.0, DBL_MAX, 0, 0 },
};

enum { limit_count = sizeof limits / sizeof limits[0] };

const char *centre_differential_controller_status_text(centre_differential_controller_status status)
{
    switch ((int)status) {
    case centre_differential_controller_ok:
        return "ok";
    case centre_differential_controller_fault_flange2_torque_ref:
        return "fault: flange2_torque_ref was not finite or not plausible";
    case centre_differential_controller_fault_flange3_torque_ref:
        return "fault: flange3_torque_ref was not finite or not plausible";
    case centre_differential_controller_fault_M1_speed_ref:
        return "fault: M1_speed_ref was not finite or not plausible";
    case centre_differential_controller_fault_M1_speed:
        return "fault: M1_speed was not finite or not plausible";
    case centre_differential_controller_fault_flange1_torque:
        return "fault: flange1_torque was not finite or not plausible";
    case centre_differential_controller_fault_flange2_torque:
        return "fault: flange2_torque was not finite or not plausible";
    case centre_differential_controller_fault_M2_speed:
        return "fault: M2_speed was not finite or not plausible";
    case centre_differential_controller_fault_flange3_torque:
        return "fault: flange3_torque was not finite or not plausible";
    case centre_differential_controller_fault_M3_speed:
        return "fault: M3_speed was not finite or not plausible";
    case centre_differential_controller_fault_M1_torque_ref:
        return "fault: M1_torque_ref was not finite or not plausible";
    case centre_differential_controller_fault_M2_torque_ref:
        return "fault: M2_torque_ref was not finite or not plausible";
    case centre_differential_controller_fault_M3_torque_ref:
        return "fault: M3_torque_ref was not finite or not plausible";
    default:
        break;
    }
    const int limit = (int)status - 2000;
    return limit >= 0 && limit < limit_count ? limits[limit].text : "unknown status";
}

centre_differential_controller_status centre_differential_controller_init(centre_differential_controller_state *s, const centre_differential_controller_params *p)
{
    memset(s, 0, sizeof *s);
    s->authority = 1.0;
    const centre_differential_controller_status status = centre_differential_controller_update(s, p);
    if (status != centre_differential_controller_ok) {
        s->authority = 0.0; /* never started: no torque at all */
    }
    return status;
}

centre_differential_controller_status centre_differential_controller_update(centre_differential_controller_state *s, const centre_differential_controller_params *p)
{
    for (int k = 0; k < limit_count; ++k) {
        const centre_differential_real value = *(const centre_differential_real *)(const void *)((const char *)p + limits[k].offset);
        const int above = limits[k].open ? value > limits[k].least : value >= limits[k].least; /* false for NaN */
        if (!(above && value <= limits[k].most) || (limits[k].not_zero && value == 0.0)) {
            s->fault = s->fault > 0.0 ? s->fault : CENTRE_DIFFERENTIAL_REAL(2000 + k); /* latched like any fault */
            return (centre_differential_controller_status)(2000 + k);
        }
    }
    s->switch_share = p->sample_time / p->switch_time;
    s->M1_taper_slope = 1.0 / p->M1_speed_taper;
    s->M1_taper_end = p->M1_speed_max / p->M1_speed_taper + 1.0;
    s->M2_taper_slope = 1.0 / p->M2_speed_taper;
    s->M2_taper_end = p->M2_speed_max / p->M2_speed_taper + 1.0;
    s->M3_taper_slope = 1.0 / p->M3_speed_taper;
    s->M3_taper_end = p->M3_speed_max / p->M3_speed_taper + 1.0;
    s->M1_speed_ref_step = p->M1_speed_ref_rate * p->sample_time;
    s->M1_speed_growth = p->M1_speed_integral_gain * p->sample_time;
    s->M1_speed_conditioning = p->M1_speed_integral_gain * p->sample_time / p->M1_speed_gain;
    s->M2_unread_M1 = p->M2_sensor_inertia_M1 / p->M1_inertia;
    s->flange2_torque_ref_step = p->flange2_torque_ref_rate * p->sample_time;
    s->M2_model_pull = p->M2_model_stiffness * p->sample_time / p->M2_inertia_estimate;
    s->M2_model_drag = p->M2_model_damping * p->sample_time / p->M2_inertia_estimate;
    s->M3_unread_M1 = p->M3_sensor_inertia_M1 / p->M1_inertia;
    s->flange3_torque_ref_step = p->flange3_torque_ref_rate * p->sample_time;
    s->M3_model_pull = p->M3_model_stiffness * p->sample_time / p->M3_inertia_estimate;
    s->M3_model_drag = p->M3_model_damping * p->sample_time / p->M3_inertia_estimate;
    s->M2_twist_M1_speed = -p->flange1_cardan1_cardan2_flange2_equivalent_stiffness /
        p->cardan2_flange2_equivalent_stiffness;
    s->M2_twist_M3_speed = (p->cardan2_flange2_equivalent_stiffness + p->diff_ratio *
        p->flange1_cardan1_cardan2_flange2_equivalent_stiffness) / p->cardan2_flange2_equivalent_stiffness;
    s->M2_torque_growth = p->M2_torque_integral_gain * p->sample_time;
    s->M3_twist_M1_speed = (p->diff_ratio * p->flange1_cardan1_equivalent_stiffness +
        p->flange1_cardan1_cardan2_flange2_equivalent_stiffness) / (p->cardan2_flange2_equivalent_stiffness +
        (p->diff_ratio * p->diff_ratio) * p->flange1_cardan1_equivalent_stiffness + 2.0 * p->diff_ratio *
        p->flange1_cardan1_cardan2_flange2_equivalent_stiffness);
    s->M3_twist_M2_speed = (p->cardan2_flange2_equivalent_stiffness + p->diff_ratio *
        p->flange1_cardan1_cardan2_flange2_equivalent_stiffness) / (p->cardan2_flange2_equivalent_stiffness +
        (p->diff_ratio * p->diff_ratio) * p->flange1_cardan1_equivalent_stiffness + 2.0 * p->diff_ratio *
        p->flange1_cardan1_cardan2_flange2_equivalent_stiffness);
    s->M3_torque_growth = p->M3_torque_integral_gain * p->sample_time;
    return centre_differential_controller_ok;
}

centre_differential_controller_status centre_differential_controller_step(centre_differential_controller_state *s, const centre_differential_controller_params *p,
    const centre_differential_controller_inputs *in, centre_differential_controller_outputs *out)
{
    /* supervision */
    centre_differential_real flange2_torque_ref_sound;
    centre_differential_guard(in->flange2_torque_ref, p->flange2_torque_ref_plausible, s->flange2_torque_ref_held,
        &s->flange2_torque_ref_held, &flange2_torque_ref_sound);
    centre_differential_real flange3_torque_ref_sound;
    centre_differential_guard(in->flange3_torque_ref, p->flange3_torque_ref_plausible, s->flange3_torque_ref_held,
        &s->flange3_torque_ref_held, &flange3_torque_ref_sound);
    centre_differential_real M1_speed_ref_sound;
    centre_differential_guard(in->M1_speed_ref, p->M1_speed_ref_plausible, s->M1_speed_ref_held,
        &s->M1_speed_ref_held, &M1_speed_ref_sound);
    centre_differential_real M1_speed_sound;
    centre_differential_guard(in->M1_speed, p->M1_speed_plausible, s->M1_speed_held, &s->M1_speed_held,
        &M1_speed_sound);
    centre_differential_real flange1_torque_sound;
    centre_differential_guard(in->flange1_torque, p->flange1_torque_plausible, s->flange1_torque_held,
        &s->flange1_torque_held, &flange1_torque_sound);
    centre_differential_real flange2_torque_sound;
    centre_differential_guard(in->flange2_torque, p->flange2_torque_plausible, s->flange2_torque_held,
        &s->flange2_torque_held, &flange2_torque_sound);
    centre_differential_real M2_speed_sound;
    centre_differential_guard(in->M2_speed, p->M2_speed_plausible, s->M2_speed_held, &s->M2_speed_held,
        &M2_speed_sound);
    centre_differential_real flange3_torque_sound;
    centre_differential_guard(in->flange3_torque, p->flange3_torque_plausible, s->flange3_torque_held,
        &s->flange3_torque_held, &flange3_torque_sound);
    centre_differential_real M3_speed_sound;
    centre_differential_guard(in->M3_speed, p->M3_speed_plausible, s->M3_speed_held, &s->M3_speed_held,
        &M3_speed_sound);
    /* the first fault is latched */
    s->fault = ((s->fault < 0.5 && flange2_torque_ref_sound < 0.5) ? 1.0 : s->fault);
    s->fault = ((s->fault < 0.5 && flange3_torque_ref_sound < 0.5) ? 2.0 : s->fault);
    s->fault = ((M1_speed_ref_sound < 0.5 && s->fault < 0.5) ? 3.0 : s->fault);
    s->fault = ((M1_speed_sound < 0.5 && s->fault < 0.5) ? 4.0 : s->fault);
    s->fault = ((s->fault < 0.5 && flange1_torque_sound < 0.5) ? 5.0 : s->fault);
    s->fault = ((s->fault < 0.5 && flange2_torque_sound < 0.5) ? 6.0 : s->fault);
    s->fault = ((M2_speed_sound < 0.5 && s->fault < 0.5) ? 7.0 : s->fault);
    s->fault = ((s->fault < 0.5 && flange3_torque_sound < 0.5) ? 8.0 : s->fault);
    s->fault = ((M3_speed_sound < 0.5 && s->fault < 0.5) ? 9.0 : s->fault);
    /* load_compensation follows its parameter along a ramp */
    const centre_differential_real load_compensation_before = ((s->running > 0.5) ? s->load_compensation_now :
        p->load_compensation);
    const centre_differential_real load_compensation_distance = p->load_compensation - load_compensation_before;
    const centre_differential_real load_compensation_moved = ((p->load_compensation != s->load_compensation_target)
        ? centre_differential_max(s->switch_share * centre_differential_abs(load_compensation_distance), 1e-06 *
        centre_differential_abs(p->load_compensation) + 1e-06 * centre_differential_abs(load_compensation_before)) :
        s->load_compensation_step);
    s->load_compensation_now = ((load_compensation_moved >= centre_differential_abs(load_compensation_distance)) ?
        p->load_compensation : ((load_compensation_distance > 0.0) ? load_compensation_before +
        load_compensation_moved : load_compensation_before - load_compensation_moved));
    s->load_compensation_step = ((load_compensation_moved >= centre_differential_abs(load_compensation_distance)) ?
        0.0 : load_compensation_moved);
    s->load_compensation_target = p->load_compensation;
    /* acceleration_torque follows its parameter along a ramp */
    const centre_differential_real acceleration_torque_before = ((s->running > 0.5) ? s->acceleration_torque_now :
        p->acceleration_torque);
    const centre_differential_real acceleration_torque_distance = p->acceleration_torque -
        acceleration_torque_before;
    const centre_differential_real acceleration_torque_moved = ((p->acceleration_torque !=
        s->acceleration_torque_target) ? centre_differential_max(s->switch_share *
        centre_differential_abs(acceleration_torque_distance), 1e-06 *
        centre_differential_abs(p->acceleration_torque) + 1e-06 *
        centre_differential_abs(acceleration_torque_before)) : s->acceleration_torque_step);
    s->acceleration_torque_now = ((acceleration_torque_moved >=
        centre_differential_abs(acceleration_torque_distance)) ? p->acceleration_torque :
        ((acceleration_torque_distance > 0.0) ? acceleration_torque_before + acceleration_torque_moved :
        acceleration_torque_before - acceleration_torque_moved));
    s->acceleration_torque_step = ((acceleration_torque_moved >=
        centre_differential_abs(acceleration_torque_distance)) ? 0.0 : acceleration_torque_moved);
    s->acceleration_torque_target = p->acceleration_torque;
    /* M2_damping follows its parameter along a ramp */
    const centre_differential_real M2_damping_before = ((s->running > 0.5) ? s->M2_damping_now : p->M2_damping);
    const centre_differential_real M2_damping_distance = p->M2_damping - M2_damping_before;
    const centre_differential_real M2_damping_moved = ((p->M2_damping != s->M2_damping_target) ?
        centre_differential_max(s->switch_share * centre_differential_abs(M2_damping_distance), 1e-06 *
        centre_differential_abs(p->M2_damping) + 1e-06 * centre_differential_abs(M2_damping_before)) :
        s->M2_damping_step);
    s->M2_damping_now = ((M2_damping_moved >= centre_differential_abs(M2_damping_distance)) ? p->M2_damping :
        ((M2_damping_distance > 0.0) ? M2_damping_before + M2_damping_moved : M2_damping_before -
        M2_damping_moved));
    s->M2_damping_step = ((M2_damping_moved >= centre_differential_abs(M2_damping_distance)) ? 0.0 :
        M2_damping_moved);
    s->M2_damping_target = p->M2_damping;
    /* M3_damping follows its parameter along a ramp */
    const centre_differential_real M3_damping_before = ((s->running > 0.5) ? s->M3_damping_now : p->M3_damping);
    const centre_differential_real M3_damping_distance = p->M3_damping - M3_damping_before;
    const centre_differential_real M3_damping_moved = ((p->M3_damping != s->M3_damping_target) ?
        centre_differential_max(s->switch_share * centre_differential_abs(M3_damping_distance), 1e-06 *
        centre_differential_abs(p->M3_damping) + 1e-06 * centre_differential_abs(M3_damping_before)) :
        s->M3_damping_step);
    s->M3_damping_now = ((M3_damping_moved >= centre_differential_abs(M3_damping_distance)) ? p->M3_damping :
        ((M3_damping_distance > 0.0) ? M3_damping_before + M3_damping_moved : M3_damping_before -
        M3_damping_moved));
    s->M3_damping_step = ((M3_damping_moved >= centre_differential_abs(M3_damping_distance)) ? 0.0 :
        M3_damping_moved);
    s->M3_damping_target = p->M3_damping;
    /* torque-speed envelope, Figure 7.1 */
    const centre_differential_real M1_available = p->M1_speed_rated * p->M1_torque_max /
        centre_differential_max(p->M1_speed_rated, centre_differential_abs(s->M1_speed_held));
    const centre_differential_real M1_least = -M1_available * centre_differential_max(0.0,
        centre_differential_min(1.0, s->M1_speed_held * s->M1_taper_slope + s->M1_taper_end));
    const centre_differential_real M1_most = M1_available * centre_differential_max(0.0,
        centre_differential_min(1.0, -s->M1_speed_held * s->M1_taper_slope + s->M1_taper_end));
    const centre_differential_real M2_available = p->M2_speed_rated * p->M2_torque_max /
        centre_differential_max(p->M2_speed_rated, centre_differential_abs(s->M2_speed_held));
    const centre_differential_real M2_least = -M2_available * centre_differential_max(0.0,
        centre_differential_min(1.0, s->M2_speed_held * s->M2_taper_slope + s->M2_taper_end));
    const centre_differential_real M2_most = M2_available * centre_differential_max(0.0,
        centre_differential_min(1.0, -s->M2_speed_held * s->M2_taper_slope + s->M2_taper_end));
    const centre_differential_real M3_available = p->M3_speed_rated * p->M3_torque_max /
        centre_differential_max(p->M3_speed_rated, centre_differential_abs(s->M3_speed_held));
    const centre_differential_real M3_least = -M3_available * centre_differential_max(0.0,
        centre_differential_min(1.0, s->M3_speed_held * s->M3_taper_slope + s->M3_taper_end));
    const centre_differential_real M3_most = M3_available * centre_differential_max(0.0,
        centre_differential_min(1.0, -s->M3_speed_held * s->M3_taper_slope + s->M3_taper_end));
    /* limit of the rate */
    const centre_differential_real M1_speed_ref_before = ((s->running > 0.5) ? s->M1_speed_ref_limited :
        s->M1_speed_held);
    s->M1_speed_ref_limited = M1_speed_ref_before + centre_differential_max(-s->M1_speed_ref_step,
        centre_differential_min(s->M1_speed_ref_step, -M1_speed_ref_before + s->M1_speed_ref_held));
    const centre_differential_real M1_speed_error = -s->M1_speed_held + s->M1_speed_ref_limited;
    /* load torque compensation (5.52), (5.74) */
    const centre_differential_real M1_compensation = s->flange1_torque_held;
    /* so that a switch does not jump */
    const centre_differential_real M1_given_away = M1_compensation * (load_compensation_before -
        s->load_compensation_now);
    /* PI speed control (5.84) */
    const centre_differential_real M1_integral_before = ((p->M1_speed_integral_gain > 0.0) ? M1_given_away : 0.0) +
        ((s->running > 0.5) ? s->M1_speed_integral : 0.0);
    const centre_differential_real M1_asked = M1_integral_before + M1_speed_error * p->M1_speed_gain;
    const centre_differential_real M1_wanted = M1_asked + M1_compensation * s->load_compensation_now;
    /* torque-speed envelope */
    const centre_differential_real M1_command = centre_differential_max(M1_least, centre_differential_min(M1_most,
        M1_wanted));
    /* what the limit cuts off */
    const centre_differential_real M1_cut = M1_command - M1_wanted;
    /* conditioning anti-windup (Hanus) */
    s->M1_speed_integral = M1_cut * s->M1_speed_conditioning + M1_integral_before + M1_speed_error *
        s->M1_speed_growth;
    /* net torque on the rotor */
    const centre_differential_real M1_net = M1_command - M1_compensation;
    /* testing torque from the sensors (5.95), (5.96), (5.98) */
    const centre_differential_real flange2_torque_estimate = M1_net * s->M2_unread_M1 + s->flange2_torque_held;
    /* limit of the rate */
    const centre_differential_real flange2_torque_ref_before = ((s->running > 0.5) ? s->flange2_torque_ref_limited :
        flange2_torque_estimate);
    s->flange2_torque_ref_limited = flange2_torque_ref_before + centre_differential_max(-s->flange2_torque_ref_step,
        centre_differential_min(s->flange2_torque_ref_step, -flange2_torque_ref_before +
        s->flange2_torque_ref_held));
    /* torque model (5.57), (5.76) */
    const centre_differential_real M2_model_before = ((s->running > 0.5) ? s->M2_model_torque :
        flange2_torque_estimate);
    const centre_differential_real M2_rate_before = ((s->running > 0.5) ? s->M2_model_rate : 0.0);
    s->M2_model_rate = -s->M2_model_drag * M2_rate_before + s->M2_model_pull * (-M2_model_before +
        s->flange2_torque_ref_limited) + M2_rate_before;
    s->M2_model_torque = M2_model_before + s->M2_model_rate * p->sample_time;
    const centre_differential_real M2_torque_error = s->M2_model_torque * p->M2_torque_model -
        flange2_torque_estimate + s->flange2_torque_ref_limited * (1.0 - p->M2_torque_model);
    /* torque control (5.99) */
    const centre_differential_real M2_integral_before = ((s->running > 0.5) ? s->M2_torque_integral : 0.0);
    const centre_differential_real M2_virtual = p->M2_feedforward * s->flange2_torque_ref_limited +
        M2_integral_before + M2_torque_error * p->M2_torque_gain;
    /* testing torque from the sensors (5.95), (5.96), (5.98) */
    const centre_differential_real flange3_torque_estimate = M1_net * s->M3_unread_M1 + s->flange3_torque_held;
    /* limit of the rate */
    const centre_differential_real flange3_torque_ref_before = ((s->running > 0.5) ? s->flange3_torque_ref_limited :
        flange3_torque_estimate);
    s->flange3_torque_ref_limited = flange3_torque_ref_before + centre_differential_max(-s->flange3_torque_ref_step,
        centre_differential_min(s->flange3_torque_ref_step, -flange3_torque_ref_before +
        s->flange3_torque_ref_held));
    /* torque model (5.57), (5.76) */
    const centre_differential_real M3_model_before = ((s->running > 0.5) ? s->M3_model_torque :
        flange3_torque_estimate);
    const centre_differential_real M3_rate_before = ((s->running > 0.5) ? s->M3_model_rate : 0.0);
    s->M3_model_rate = -s->M3_model_drag * M3_rate_before + s->M3_model_pull * (-M3_model_before +
        s->flange3_torque_ref_limited) + M3_rate_before;
    s->M3_model_torque = M3_model_before + s->M3_model_rate * p->sample_time;
    const centre_differential_real M3_torque_error = s->M3_model_torque * p->M3_torque_model -
        flange3_torque_estimate + s->flange3_torque_ref_limited * (1.0 - p->M3_torque_model);
    /* torque control (5.99) */
    const centre_differential_real M3_integral_before = ((s->running > 0.5) ? s->M3_torque_integral : 0.0);
    const centre_differential_real M3_virtual = p->M3_feedforward * s->flange3_torque_ref_limited +
        M3_integral_before + M3_torque_error * p->M3_torque_gain;
    /* active damping (5.62), (5.78) */
    const centre_differential_real M2_twist_rate_M2 = s->M1_speed_held * s->M2_twist_M1_speed - s->M2_speed_held +
        s->M2_twist_M3_speed * s->M3_speed_held;
    const centre_differential_real M2_damping_torque = s->M2_damping_now * M2_twist_rate_M2;
    /* with the acceleration torque (5.62), (5.78) */
    const centre_differential_real M2_wanted = -M2_virtual;
    /* reserve for active damping */
    const centre_differential_real M2_kept = centre_differential_max(M2_least * (1.0 - p->M2_damping_reserve),
        centre_differential_min(M2_wanted, M2_most * (1.0 - p->M2_damping_reserve)));
    /* torque-speed envelope */
    const centre_differential_real M2_command = centre_differential_max(M2_least, centre_differential_min(M2_most,
        M2_damping_torque + M2_kept));
    /* limited integrator */
    s->M2_torque_integral = ((M2_torque_error * (-M2_kept + M2_wanted) < 0.0) ? M2_integral_before :
        centre_differential_max(-p->M2_torque_integral_limit, centre_differential_min(p->M2_torque_integral_limit,
        M2_integral_before + M2_torque_error * s->M2_torque_growth)));
    /* active damping (5.62), (5.78) */
    const centre_differential_real M3_twist_rate_M3 = s->M1_speed_held * s->M3_twist_M1_speed + s->M2_speed_held *
        s->M3_twist_M2_speed - s->M3_speed_held;
    const centre_differential_real M3_damping_torque = s->M3_damping_now * M3_twist_rate_M3;
    /* with the acceleration torque (5.62), (5.78) */
    const centre_differential_real M3_wanted = -M3_virtual;
    /* reserve for active damping */
    const centre_differential_real M3_kept = centre_differential_max(M3_least * (1.0 - p->M3_damping_reserve),
        centre_differential_min(M3_wanted, M3_most * (1.0 - p->M3_damping_reserve)));
    /* torque-speed envelope */
    const centre_differential_real M3_command = centre_differential_max(M3_least, centre_differential_min(M3_most,
        M3_damping_torque + M3_kept));
    /* limited integrator */
    s->M3_torque_integral = ((M3_torque_error * (-M3_kept + M3_wanted) < 0.0) ? M3_integral_before :
        centre_differential_max(-p->M3_torque_integral_limit, centre_differential_min(p->M3_torque_integral_limit,
        M3_integral_before + M3_torque_error * s->M3_torque_growth)));
    const centre_differential_real M1_largest = 1.01 * p->M1_torque_max;
    /* only sound torques leave */
    centre_differential_real M1_released;
    centre_differential_real M1_released_sound;
    centre_differential_guard(M1_command, M1_largest, s->M1_last, &M1_released, &M1_released_sound);
    const centre_differential_real M2_largest = 1.01 * p->M2_torque_max;
    centre_differential_real M2_released;
    centre_differential_real M2_released_sound;
    centre_differential_guard(M2_command, M2_largest, s->M2_last, &M2_released, &M2_released_sound);
    const centre_differential_real M3_largest = 1.01 * p->M3_torque_max;
    centre_differential_real M3_released;
    centre_differential_real M3_released_sound;
    centre_differential_guard(M3_command, M3_largest, s->M3_last, &M3_released, &M3_released_sound);
    /* the first fault is latched */
    s->fault = ((M1_released_sound < 0.5 && s->fault < 0.5) ? 10.0 : s->fault);
    s->fault = ((M2_released_sound < 0.5 && s->fault < 0.5) ? 11.0 : s->fault);
    s->fault = ((M3_released_sound < 0.5 && s->fault < 0.5) ? 12.0 : s->fault);
    /* ramp to zero torque */
    s->authority = ((s->fault > 0.5) ? centre_differential_max(0.0, s->authority - p->sample_time / p->fault_ramp) :
        s->authority);
    s->M1_last = ((s->fault > 0.5) ? s->M1_last : M1_released);
    out->M1_torque_ref = s->M1_last * s->authority;
    s->M2_last = ((s->fault > 0.5) ? s->M2_last : M2_released);
    out->M2_torque_ref = s->M2_last * s->authority;
    s->M3_last = ((s->fault > 0.5) ? s->M3_last : M3_released);
    out->M3_torque_ref = s->M3_last * s->authority;
    /* start anew after a fault */
    s->running = ((s->fault < 0.5) ? 1.0 : 0.0);
    /* The last line of defence, should parameters have been changed without an update. */
    if (!centre_differential_is_finite(out->M1_torque_ref)) {
        out->M1_torque_ref = 0.0;
        s->fault = s->fault > 0.0 ? s->fault : CENTRE_DIFFERENTIAL_REAL(centre_differential_controller_fault_M1_torque_ref);
    }
    if (!centre_differential_is_finite(out->M2_torque_ref)) {
        out->M2_torque_ref = 0.0;
        s->fault = s->fault > 0.0 ? s->fault : CENTRE_DIFFERENTIAL_REAL(centre_differential_controller_fault_M2_torque_ref);
    }
    if (!centre_differential_is_finite(out->M3_torque_ref)) {
        out->M3_torque_ref = 0.0;
        s->fault = s->fault > 0.0 ? s->fault : CENTRE_DIFFERENTIAL_REAL(centre_differential_controller_fault_M3_torque_ref);
    }
    return (centre_differential_controller_status)s->fault;
}
