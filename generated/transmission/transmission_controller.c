/*
 * transmission_controller.c: controller of the bed transmission
 *
 * Emitted by ptgen 0.1.0 from transmission.toml (SHA-256 e06936acb40aa4a5), template block.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "transmission_controller.h"

#include <float.h>
#include <string.h>

const transmission_controller_params transmission_controller_defaults = {
    .sample_time = 0.0001,
    .fault_ramp = 0.05,
    .hold_time = 0.001,
    .gears_input_torque_ref_plausible = 4950.0,
    .M2_speed_ref_plausible = 706.8583470577036,
    .gears_ratio_plausible = 8.2545,
    .M1_speed_plausible = 1256.637061435917,
    .flange1_torque_plausible = 4950.0,
    .flange2_torque_plausible = 16500.0,
    .M2_speed_plausible = 706.8583470577036,
    .M1_overspeed = 921.5,
    .M2_overspeed = 518.4,
    .load_compensation = 1.0,
    .acceleration_torque = 1.0,
    .switch_time = 0.5,
    .M1_damping = 77.0217,
    .M1_speed_rated = 335.103216382911,
    .M1_speed_max = 837.758040957278,
    .M1_speed_taper = 41.8879,
    .M1_torque_max = 900.0,
    .M2_speed_rated = 104.71975511966,
    .M2_speed_max = 471.238898038469,
    .M2_speed_taper = 23.5619,
    .M2_torque_max = 3300.0,
    .gears_ratio_least = -4.932,
    .gears_ratio_most = 5.503,
    .gears_ratio_source = 0.0,
    .gears_ratio_least_speed = 4.71,
    .gears_ratio_estimate_time = 0.02,
    .gears_ratio_tolerance = 0.02,
    .gears_ratio_settle_time = 0.05,
    .gears_ratio_rate = 20.87,
    .disagreement_leak = 5.0,
    .M1_inertia = 0.4,
    .M1_disagreement_limit = 90.0,
    .M1_frozen_limit = 22.5,
    .frozen_time = 0.01,
    .M2_inertia = 4.5,
    .M2_disagreement_limit = 29.3,
    .M2_frozen_limit = 7.33,
    .oscillation_frequency = 8.64,
    .flange1_torque_oscillation_limit = 900.0,
    .flange2_torque_oscillation_limit = 3300.0,
    .M1_torque_ref_oscillation_limit = 450.0,
    .M2_torque_ref_oscillation_limit = 1650.0,
    .M2_speed_ref_rate = 733.333,
    .gears_input_torque_ref_rate = 69326.4,
    .M2_speed_gain = 67.5,
    .M2_speed_integral_gain = 253.125,
    .M1_sensor_inertia_M2 = -0.15,
    .M1_inertia_estimate = 0.55,
    .M1_feedforward = 1.0,
    .M1_torque_gain = 0.0,
    .M1_model_stiffness = 2696.52,
    .M1_model_damping = 77.0217,
    .M1_torque_model = 1.0,
    .M1_torque_integral_gain = 10.0,
    .M1_damping_reserve = 0.1,
    .M1_torque_integral_limit = 450.0,
};

const transmission_controller_params transmission_controller_conventional = {
    .sample_time = 0.0001,
    .fault_ramp = 0.05,
    .hold_time = 0.001,
    .gears_input_torque_ref_plausible = 4950.0,
    .M2_speed_ref_plausible = 706.8583470577036,
    .gears_ratio_plausible = 8.2545,
    .M1_speed_plausible = 1256.637061435917,
    .flange1_torque_plausible = 4950.0,
    .flange2_torque_plausible = 16500.0,
    .M2_speed_plausible = 706.8583470577036,
    .M1_overspeed = 921.5,
    .M2_overspeed = 518.4,
    .load_compensation = 0.0,
    .acceleration_torque = 0.0,
    .switch_time = 0.5,
    .M1_damping = 0.0,
    .M1_speed_rated = 335.103216382911,
    .M1_speed_max = 837.758040957278,
    .M1_speed_taper = 41.8879,
    .M1_torque_max = 900.0,
    .M2_speed_rated = 104.71975511966,
    .M2_speed_max = 471.238898038469,
    .M2_speed_taper = 23.5619,
    .M2_torque_max = 3300.0,
    .gears_ratio_least = -4.932,
    .gears_ratio_most = 5.503,
    .gears_ratio_source = 0.0,
    .gears_ratio_least_speed = 4.71,
    .gears_ratio_estimate_time = 0.02,
    .gears_ratio_tolerance = 0.02,
    .gears_ratio_settle_time = 0.05,
    .gears_ratio_rate = 20.87,
    .disagreement_leak = 5.0,
    .M1_inertia = 0.4,
    .M1_disagreement_limit = 90.0,
    .M1_frozen_limit = 22.5,
    .frozen_time = 0.01,
    .M2_inertia = 4.5,
    .M2_disagreement_limit = 29.3,
    .M2_frozen_limit = 7.33,
    .oscillation_frequency = 8.64,
    .flange1_torque_oscillation_limit = 900.0,
    .flange2_torque_oscillation_limit = 3300.0,
    .M1_torque_ref_oscillation_limit = 450.0,
    .M2_torque_ref_oscillation_limit = 1650.0,
    .M2_speed_ref_rate = 733.333,
    .gears_input_torque_ref_rate = 69326.4,
    .M2_speed_gain = 67.5,
    .M2_speed_integral_gain = 253.125,
    .M1_sensor_inertia_M2 = -0.15,
    .M1_inertia_estimate = 0.55,
    .M1_feedforward = 1.0,
    .M1_torque_gain = 0.0,
    .M1_model_stiffness = 2696.52,
    .M1_model_damping = 77.0217,
    .M1_torque_model = 0.0,
    .M1_torque_integral_gain = 0.380945,
    .M1_damping_reserve = 0.1,
    .M1_torque_integral_limit = 450.0,
};

/* Range of each parameter; `open` excludes the lower bound. The order is that of the status codes. */
static const struct {
    const char *text;
    size_t offset;
    transmission_real least;
    transmission_real most;
    int open;
    int not_zero;
} limits[] = {
    { "the parameter sample_time is outside its range", offsetof(transmission_controller_params, sample_time), 0.0, DBL_MAX, 1, 0 },
    { "the parameter fault_ramp is outside its range", offsetof(transmission_controller_params, fault_ramp), 0.0, DBL_MAX, 1, 0 },
    { "the parameter hold_time is outside its range", offsetof(transmission_controller_params, hold_time), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_input_torque_ref_plausible is outside its range", offsetof(transmission_controller_params, gears_input_torque_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_ref_plausible is outside its range", offsetof(transmission_controller_params, M2_speed_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_ratio_plausible is outside its range", offsetof(transmission_controller_params, gears_ratio_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_plausible is outside its range", offsetof(transmission_controller_params, M1_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_torque_plausible is outside its range", offsetof(transmission_controller_params, flange1_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_torque_plausible is outside its range", offsetof(transmission_controller_params, flange2_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_plausible is outside its range", offsetof(transmission_controller_params, M2_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_overspeed is outside its range", offsetof(transmission_controller_params, M1_overspeed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_overspeed is outside its range", offsetof(transmission_controller_params, M2_overspeed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter load_compensation is outside its range", offsetof(transmission_controller_params, load_compensation), 0.0, 1.0, 0, 0 },
    { "the parameter acceleration_torque is outside its range", offsetof(transmission_controller_params, acceleration_torque), 0.0, 1.0, 0, 0 },
    { "the parameter switch_time is outside its range", offsetof(transmission_controller_params, switch_time), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_damping is outside its range", offsetof(transmission_controller_params, M1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_speed_rated is outside its range", offsetof(transmission_controller_params, M1_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_max is outside its range", offsetof(transmission_controller_params, M1_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_taper is outside its range", offsetof(transmission_controller_params, M1_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_max is outside its range", offsetof(transmission_controller_params, M1_torque_max), 0.0, 900.0, 1, 0 },
    { "the parameter M2_speed_rated is outside its range", offsetof(transmission_controller_params, M2_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_max is outside its range", offsetof(transmission_controller_params, M2_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_taper is outside its range", offsetof(transmission_controller_params, M2_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_max is outside its range", offsetof(transmission_controller_params, M2_torque_max), 0.0, 3300.0, 1, 0 },
    { "the parameter gears_ratio_least is outside its range", offsetof(transmission_controller_params, gears_ratio_least), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter gears_ratio_most is outside its range", offsetof(transmission_controller_params, gears_ratio_most), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter gears_ratio_source is outside its range", offsetof(transmission_controller_params, gears_ratio_source), 0.0, 1.0, 0, 0 },
    { "the parameter gears_ratio_least_speed is outside its range", offsetof(transmission_controller_params, gears_ratio_least_speed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_ratio_estimate_time is outside its range", offsetof(transmission_controller_params, gears_ratio_estimate_time), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_ratio_tolerance is outside its range", offsetof(transmission_controller_params, gears_ratio_tolerance), 0.0, 0.0675, 1, 0 },
    { "the parameter gears_ratio_settle_time is outside its range", offsetof(transmission_controller_params, gears_ratio_settle_time), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_ratio_rate is outside its range", offsetof(transmission_controller_params, gears_ratio_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter disagreement_leak is outside its range", offsetof(transmission_controller_params, disagreement_leak), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_inertia is outside its range", offsetof(transmission_controller_params, M1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_disagreement_limit is outside its range", offsetof(transmission_controller_params, M1_disagreement_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_frozen_limit is outside its range", offsetof(transmission_controller_params, M1_frozen_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter frozen_time is outside its range", offsetof(transmission_controller_params, frozen_time), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_inertia is outside its range", offsetof(transmission_controller_params, M2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_disagreement_limit is outside its range", offsetof(transmission_controller_params, M2_disagreement_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_frozen_limit is outside its range", offsetof(transmission_controller_params, M2_frozen_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter oscillation_frequency is outside its range", offsetof(transmission_controller_params, oscillation_frequency), 0.0, DBL_MAX, 0, 0 },
    { "the parameter flange1_torque_oscillation_limit is outside its range", offsetof(transmission_controller_params, flange1_torque_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_torque_oscillation_limit is outside its range", offsetof(transmission_controller_params, flange2_torque_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_ref_oscillation_limit is outside its range", offsetof(transmission_controller_params, M1_torque_ref_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_ref_oscillation_limit is outside its range", offsetof(transmission_controller_params, M2_torque_ref_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_ref_rate is outside its range", offsetof(transmission_controller_params, M2_speed_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_input_torque_ref_rate is outside its range", offsetof(transmission_controller_params, gears_input_torque_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_gain is outside its range", offsetof(transmission_controller_params, M2_speed_gain), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_integral_gain is outside its range", offsetof(transmission_controller_params, M2_speed_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_sensor_inertia_M2 is outside its range", offsetof(transmission_controller_params, M1_sensor_inertia_M2), -DBL_MAX, DBL_MAX, 0, 0 },
    { "the parameter M1_inertia_estimate is outside its range", offsetof(transmission_controller_params, M1_inertia_estimate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_feedforward is outside its range", offsetof(transmission_controller_params, M1_feedforward), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_torque_gain is outside its range", offsetof(transmission_controller_params, M1_torque_gain), -1.0, DBL_MAX, 1, 0 },
    { "the parameter M1_model_stiffness is outside its range", offsetof(transmission_controller_params, M1_model_stiffness), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_model_damping is outside its range", offsetof(transmission_controller_params, M1_model_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_torque_model is outside its range", offsetof(transmission_controller_params, M1_torque_model), 0.0, 1.0, 0, 0 },
    { "the parameter M1_torque_integral_gain is outside its range", offsetof(transmission_controller_params, M1_torque_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_damping_reserve is outside its range", offsetof(transmission_controller_params, M1_damping_reserve), 0.0, 1.0, 0, 0 },
    { "the parameter M1_torque_integral_limit is outside its range", offsetof(transmission_controller_params, M1_torque_integral_limit), 0.0, DBL_MAX, 0, 0 },
};

enum { limit_count = sizeof limits / sizeof limits[0] };

const char *transmission_controller_status_text(transmission_controller_status status)
{
    switch ((int)status) {
    case transmission_controller_ok:
        return "ok";
    case transmission_controller_fault_gears_input_torque_ref:
        return "gears_input_torque_ref: not finite or not plausible";
    case transmission_controller_fault_M2_speed_ref:
        return "M2_speed_ref: not finite or not plausible";
    case transmission_controller_fault_gears_ratio:
        return "gears_ratio: not finite or not plausible";
    case transmission_controller_fault_M1_speed:
        return "M1_speed: not finite or not plausible";
    case transmission_controller_fault_flange1_torque:
        return "flange1_torque: not finite or not plausible";
    case transmission_controller_fault_flange2_torque:
        return "flange2_torque: not finite or not plausible";
    case transmission_controller_fault_M2_speed:
        return "M2_speed: not finite or not plausible";
    case transmission_controller_fault_M1_speed_overspeed:
        return "M1_speed: overspeed";
    case transmission_controller_fault_M2_speed_overspeed:
        return "M2_speed: overspeed";
    case transmission_controller_fault_M1_speed_frozen:
        return "M1_speed: frozen while the torques accelerate the machine";
    case transmission_controller_fault_M1_speed_disagreement:
        return "M1_speed: disagrees with the integrated torque";
    case transmission_controller_fault_flange1_torque_frozen:
        return "flange1_torque: frozen while the torque of the machine changes";
    case transmission_controller_fault_M2_speed_frozen:
        return "M2_speed: frozen while the torques accelerate the machine";
    case transmission_controller_fault_M2_speed_disagreement:
        return "M2_speed: disagrees with the integrated torque";
    case transmission_controller_fault_flange2_torque_frozen:
        return "flange2_torque: frozen while the torque of the machine changes";
    case transmission_controller_fault_flange1_torque_oscillation:
        return "flange1_torque: oscillates beyond its limit";
    case transmission_controller_fault_flange2_torque_oscillation:
        return "flange2_torque: oscillates beyond its limit";
    case transmission_controller_fault_M1_torque_ref_oscillation:
        return "M1_torque_ref: the command oscillates";
    case transmission_controller_fault_M2_torque_ref_oscillation:
        return "M2_torque_ref: the command oscillates";
    case transmission_controller_fault_M1_torque_ref:
        return "M1_torque_ref: the command is not finite, or beyond the torque of the machine";
    case transmission_controller_fault_M2_torque_ref:
        return "M2_torque_ref: the command is not finite, or beyond the torque of the machine";
    default:
        break;
    }
    const int limit = (int)status - 2000;
    return limit >= 0 && limit < limit_count ? limits[limit].text : "unknown status";
}

transmission_controller_status transmission_controller_init(transmission_controller_state *s, const transmission_controller_params *p)
{
    memset(s, 0, sizeof *s);
    s->authority = 1.0;
    s->gears_input_torque_ref_bad_time = 1e+30;
    s->M2_speed_ref_bad_time = 1e+30;
    s->gears_ratio_bad_time = 1e+30;
    s->M1_speed_bad_time = 1e+30;
    s->flange1_torque_bad_time = 1e+30;
    s->flange2_torque_bad_time = 1e+30;
    s->M2_speed_bad_time = 1e+30;
    s->reset_before = 1.0;
    const transmission_controller_status status = transmission_controller_update(s, p);
    if (status != transmission_controller_ok) {
        s->authority = 0.0; /* never started: no torque at all */
    }
    return status;
}

transmission_controller_status transmission_controller_update(transmission_controller_state *s, const transmission_controller_params *p)
{
    for (int k = 0; k < limit_count; ++k) {
        const transmission_real value = *(const transmission_real *)(const void *)((const char *)p + limits[k].offset);
        const int above = limits[k].open ? value > limits[k].least : value >= limits[k].least; /* false for NaN */
        if (!(above && value <= limits[k].most) || (limits[k].not_zero && value == 0.0)) {
            s->fault = s->fault > 0.0 ? s->fault : TRANSMISSION_REAL(2000 + k); /* latched like any fault */
            s->refused = 1.0; /* no reset before an update succeeds */
            return (transmission_controller_status)(2000 + k);
        }
    }
    s->bridged_time = p->hold_time + (0.5) * p->sample_time;
    s->switch_share = p->sample_time / p->switch_time;
    s->M1_taper_slope = 1.0 / p->M1_speed_taper;
    s->M1_taper_end = p->M1_speed_max / p->M1_speed_taper + 1.0;
    s->M1_power = p->M1_speed_rated * p->M1_torque_max;
    s->M2_taper_slope = 1.0 / p->M2_speed_taper;
    s->M2_taper_end = p->M2_speed_max / p->M2_speed_taper + 1.0;
    s->M2_power = p->M2_speed_rated * p->M2_torque_max;
    s->gears_ratio_estimate_share = p->sample_time / (p->gears_ratio_estimate_time + p->sample_time);
    s->gears_ratio_step = p->gears_ratio_rate * p->sample_time;
    s->steps_per_second = 1.0 / p->sample_time;
    s->disagreement_share = p->disagreement_leak * p->sample_time;
    s->M1_per_step = p->sample_time / p->M1_inertia;
    s->M1_moved_torque = 0.05 * p->M1_torque_max;
    s->M2_per_step = p->sample_time / p->M2_inertia;
    s->M2_moved_torque = 0.05 * p->M2_torque_max;
    s->forgotten_swings = p->oscillation_frequency * p->sample_time;
    s->mean_share = 6.2832 * p->oscillation_frequency * p->sample_time;
    s->M2_speed_ref_step = p->M2_speed_ref_rate * p->sample_time;
    s->gears_input_torque_ref_step = p->gears_input_torque_ref_rate * p->sample_time;
    s->M2_speed_growth = p->M2_speed_integral_gain * p->sample_time;
    s->M2_speed_conditioning = p->M2_speed_integral_gain * p->sample_time / p->M2_speed_gain;
    s->M1_unread_M2 = p->M1_sensor_inertia_M2 / p->M2_inertia;
    s->M1_model_pull = p->M1_model_stiffness * p->sample_time / p->M1_inertia_estimate;
    s->M1_model_drag = p->M1_model_damping * p->sample_time / p->M1_inertia_estimate;
    s->M1_torque_growth = p->M1_torque_integral_gain * p->sample_time;
    s->M1_largest = 1.01 * transmission_min(900.0, p->M1_torque_max);
    s->M2_largest = 1.01 * transmission_min(3300.0, p->M2_torque_max);
    s->ramp_step = p->sample_time / p->fault_ramp;
    s->calm_share = p->sample_time / (p->sample_time + 0.02);
    s->refused = 0.0;
    return transmission_controller_ok;
}

transmission_controller_status transmission_controller_step(transmission_controller_state *s, const transmission_controller_params *p,
    const transmission_controller_inputs *in, transmission_controller_outputs *out)
{
    /* supervision: bad samples are bridged */
    transmission_real gears_input_torque_ref_sound;
    transmission_guard(in->gears_input_torque_ref, p->gears_input_torque_ref_plausible,
        s->gears_input_torque_ref_held, &s->gears_input_torque_ref_held, &gears_input_torque_ref_sound);
    transmission_lasting(gears_input_torque_ref_sound, s->gears_input_torque_ref_bad_time, p->sample_time,
        p->hold_time, &s->gears_input_torque_ref_bad_time);
    transmission_real M2_speed_ref_sound;
    transmission_guard(in->M2_speed_ref, p->M2_speed_ref_plausible, s->M2_speed_ref_held, &s->M2_speed_ref_held,
        &M2_speed_ref_sound);
    transmission_lasting(M2_speed_ref_sound, s->M2_speed_ref_bad_time, p->sample_time, p->hold_time,
        &s->M2_speed_ref_bad_time);
    transmission_real gears_ratio_sound;
    transmission_guard(in->gears_ratio, p->gears_ratio_plausible, s->gears_ratio_held, &s->gears_ratio_held,
        &gears_ratio_sound);
    transmission_lasting(gears_ratio_sound, s->gears_ratio_bad_time, p->sample_time, p->hold_time,
        &s->gears_ratio_bad_time);
    transmission_real M1_speed_sound;
    transmission_guard(in->M1_speed, p->M1_speed_plausible, s->M1_speed_held, &s->M1_speed_held, &M1_speed_sound);
    transmission_lasting(M1_speed_sound, s->M1_speed_bad_time, p->sample_time, p->hold_time, &s->M1_speed_bad_time);
    transmission_real flange1_torque_sound;
    transmission_guard(in->flange1_torque, p->flange1_torque_plausible, s->flange1_torque_held,
        &s->flange1_torque_held, &flange1_torque_sound);
    transmission_lasting(flange1_torque_sound, s->flange1_torque_bad_time, p->sample_time, p->hold_time,
        &s->flange1_torque_bad_time);
    transmission_real flange2_torque_sound;
    transmission_guard(in->flange2_torque, p->flange2_torque_plausible, s->flange2_torque_held,
        &s->flange2_torque_held, &flange2_torque_sound);
    transmission_lasting(flange2_torque_sound, s->flange2_torque_bad_time, p->sample_time, p->hold_time,
        &s->flange2_torque_bad_time);
    transmission_real M2_speed_sound;
    transmission_guard(in->M2_speed, p->M2_speed_plausible, s->M2_speed_held, &s->M2_speed_held, &M2_speed_sound);
    transmission_lasting(M2_speed_sound, s->M2_speed_bad_time, p->sample_time, p->hold_time, &s->M2_speed_bad_time);
    /* overspeed */
    const transmission_real M1_slow_enough = transmission_select(p->M1_overspeed >=
        transmission_abs(s->M1_speed_held), 1.0, 0.0);
    transmission_lasting(M1_slow_enough, s->M1_overspeed_time, p->sample_time, p->hold_time, &s->M1_overspeed_time);
    const transmission_real M2_slow_enough = transmission_select(p->M2_overspeed >=
        transmission_abs(s->M2_speed_held), 1.0, 0.0);
    transmission_lasting(M2_slow_enough, s->M2_overspeed_time, p->sample_time, p->hold_time, &s->M2_overspeed_time);
    /* reset on request, when the cause is gone */
    const transmission_real reset_pressed = transmission_select(transmission_abs(in->reset - 1.0) <= 0.5, 1.0, 0.0);
    s->reset_request = transmission_select(s->fault > 0.5, transmission_select(p->M1_overspeed >=
        transmission_abs(s->M1_speed_held) && p->M1_speed_plausible >= transmission_abs(in->M1_speed) &&
        p->M2_overspeed >= transmission_abs(s->M2_speed_held) && p->M2_speed_plausible >=
        transmission_abs(in->M2_speed) && p->M2_speed_ref_plausible >= transmission_abs(in->M2_speed_ref) &&
        p->flange1_torque_plausible >= transmission_abs(in->flange1_torque) && p->flange2_torque_plausible >=
        transmission_abs(in->flange2_torque) && p->gears_input_torque_ref_plausible >=
        transmission_abs(in->gears_input_torque_ref) && p->gears_ratio_plausible >=
        transmission_abs(in->gears_ratio), (1.0 - s->refused) * transmission_max(s->reset_request, -s->reset_before
        + reset_pressed), 0.0), 0.0);
    s->reset_before = reset_pressed;
    s->fault = s->fault * (1.0 - transmission_select(s->authority <= 0.0, s->reset_request, 0.0));
    s->reset_request = transmission_select(s->fault > 0.5, s->reset_request, 0.0);
    /* the first fault is latched */
    transmission_real cause_of_inputs = 0.0;
    cause_of_inputs = transmission_select(s->M2_overspeed_time <= s->bridged_time, cause_of_inputs, 4007.0);
    cause_of_inputs = transmission_select(s->M1_overspeed_time <= s->bridged_time, cause_of_inputs, 4004.0);
    cause_of_inputs = transmission_select(s->M2_speed_bad_time <= s->bridged_time, cause_of_inputs, 7.0);
    cause_of_inputs = transmission_select(s->flange2_torque_bad_time <= s->bridged_time, cause_of_inputs, 6.0);
    cause_of_inputs = transmission_select(s->flange1_torque_bad_time <= s->bridged_time, cause_of_inputs, 5.0);
    cause_of_inputs = transmission_select(s->M1_speed_bad_time <= s->bridged_time, cause_of_inputs, 4.0);
    cause_of_inputs = transmission_select(s->gears_ratio_bad_time <= s->bridged_time, cause_of_inputs, 3.0);
    cause_of_inputs = transmission_select(s->M2_speed_ref_bad_time <= s->bridged_time, cause_of_inputs, 2.0);
    cause_of_inputs = transmission_select(s->gears_input_torque_ref_bad_time <= s->bridged_time, cause_of_inputs,
        1.0);
    s->fault = transmission_select(s->fault > 0.5, s->fault, cause_of_inputs);
    if (s->running <= 0.5) {
        /* the first step, and the first one after a fault, starts anew */
        s->load_compensation_now = p->load_compensation;
        s->acceleration_torque_now = p->acceleration_torque;
        s->M1_damping_now = p->M1_damping;
        s->gears_ratio_source_now = p->gears_ratio_source;
        s->gears_ratio_near_time = 0.0;
        s->gears_ratio_gear = 0.0;
        s->M1_integrated = s->M1_speed_held;
        s->M1_speed_still_time = 0.0;
        s->flange1_torque_still_time = 0.0;
        s->M2_integrated = s->M2_speed_held;
        s->M2_speed_still_time = 0.0;
        s->flange2_torque_still_time = 0.0;
        s->flange1_torque_mean = s->flange1_torque_held;
        s->flange1_torque_swings = 0.0;
        s->flange2_torque_mean = s->flange2_torque_held;
        s->flange2_torque_swings = 0.0;
        s->M1_torque_ref_mean = 0.0;
        s->M1_torque_ref_swings = 0.0;
        s->M2_torque_ref_mean = 0.0;
        s->M2_torque_ref_swings = 0.0;
        s->M2_speed_ref_limited = s->M2_speed_held;
        s->M2_speed_integral = 0.0;
        s->M1_model_rate = 0.0;
        s->M1_torque_integral = 0.0;
    }
    /* load_compensation follows its parameter along a ramp */
    const transmission_real load_compensation_before = s->load_compensation_now;
    const transmission_real load_compensation_distance = p->load_compensation - load_compensation_before;
    if (p->load_compensation != s->load_compensation_target) {
        s->load_compensation_step = transmission_max(s->switch_share * transmission_abs(load_compensation_distance),
            1e-06 * transmission_abs(p->load_compensation) + 1e-06 * transmission_abs(load_compensation_before));
    }
    s->load_compensation_now = transmission_select(s->load_compensation_step <
        transmission_abs(load_compensation_distance), load_compensation_before +
        transmission_max(-s->load_compensation_step, transmission_min(load_compensation_distance,
        s->load_compensation_step)), p->load_compensation);
    s->load_compensation_step = transmission_select(s->load_compensation_step <
        transmission_abs(load_compensation_distance), s->load_compensation_step, 0.0);
    s->load_compensation_target = p->load_compensation;
    /* acceleration_torque follows its parameter along a ramp */
    const transmission_real acceleration_torque_before = s->acceleration_torque_now;
    const transmission_real acceleration_torque_distance = p->acceleration_torque - acceleration_torque_before;
    if (p->acceleration_torque != s->acceleration_torque_target) {
        s->acceleration_torque_step = transmission_max(s->switch_share * transmission_abs(acceleration_torque_distance),
            1e-06 * transmission_abs(p->acceleration_torque) + 1e-06 * transmission_abs(acceleration_torque_before));
    }
    s->acceleration_torque_now = transmission_select(s->acceleration_torque_step <
        transmission_abs(acceleration_torque_distance), acceleration_torque_before +
        transmission_max(-s->acceleration_torque_step, transmission_min(acceleration_torque_distance,
        s->acceleration_torque_step)), p->acceleration_torque);
    s->acceleration_torque_step = transmission_select(s->acceleration_torque_step <
        transmission_abs(acceleration_torque_distance), s->acceleration_torque_step, 0.0);
    s->acceleration_torque_target = p->acceleration_torque;
    /* M1_damping follows its parameter along a ramp */
    const transmission_real M1_damping_before = s->M1_damping_now;
    const transmission_real M1_damping_distance = p->M1_damping - M1_damping_before;
    if (p->M1_damping != s->M1_damping_target) {
        s->M1_damping_step = transmission_max(s->switch_share * transmission_abs(M1_damping_distance), 1e-06 *
            transmission_abs(p->M1_damping) + 1e-06 * transmission_abs(M1_damping_before));
    }
    s->M1_damping_now = transmission_select(s->M1_damping_step < transmission_abs(M1_damping_distance),
        M1_damping_before + transmission_max(-s->M1_damping_step, transmission_min(M1_damping_distance,
        s->M1_damping_step)), p->M1_damping);
    s->M1_damping_step = transmission_select(s->M1_damping_step < transmission_abs(M1_damping_distance),
        s->M1_damping_step, 0.0);
    s->M1_damping_target = p->M1_damping;
    /* torque-speed envelope, Figure 7.1 */
    const transmission_real M1_available = s->M1_power / transmission_max(p->M1_speed_rated,
        transmission_abs(s->M1_speed_held));
    const transmission_real M1_least = -M1_available * transmission_max(0.0, transmission_min(1.0, s->M1_speed_held
        * s->M1_taper_slope + s->M1_taper_end));
    const transmission_real M1_most = M1_available * transmission_max(0.0, transmission_min(1.0, -s->M1_speed_held *
        s->M1_taper_slope + s->M1_taper_end));
    const transmission_real M2_available = s->M2_power / transmission_max(p->M2_speed_rated,
        transmission_abs(s->M2_speed_held));
    const transmission_real M2_least = -M2_available * transmission_max(0.0, transmission_min(1.0, s->M2_speed_held
        * s->M2_taper_slope + s->M2_taper_end));
    const transmission_real M2_most = M2_available * transmission_max(0.0, transmission_min(1.0, -s->M2_speed_held *
        s->M2_taper_slope + s->M2_taper_end));
    /* range and rate of the ratio */
    const transmission_real gears_ratio_inside = transmission_max(p->gears_ratio_least,
        transmission_min(s->gears_ratio_held, p->gears_ratio_most));
    /* gears_ratio_source follows its parameter along a ramp */
    const transmission_real gears_ratio_source_before = s->gears_ratio_source_now;
    const transmission_real gears_ratio_source_distance = p->gears_ratio_source - gears_ratio_source_before;
    if (p->gears_ratio_source != s->gears_ratio_source_target) {
        s->gears_ratio_source_step = transmission_max(s->switch_share * transmission_abs(gears_ratio_source_distance),
            1e-06 * transmission_abs(p->gears_ratio_source) + 1e-06 * transmission_abs(gears_ratio_source_before));
    }
    s->gears_ratio_source_now = transmission_select(s->gears_ratio_source_step <
        transmission_abs(gears_ratio_source_distance), gears_ratio_source_before +
        transmission_max(-s->gears_ratio_source_step, transmission_min(gears_ratio_source_distance,
        s->gears_ratio_source_step)), p->gears_ratio_source);
    s->gears_ratio_source_step = transmission_select(s->gears_ratio_source_step <
        transmission_abs(gears_ratio_source_distance), s->gears_ratio_source_step, 0.0);
    s->gears_ratio_source_target = p->gears_ratio_source;
    /* ratio from the speeds */
    const transmission_real gears_ratio_behind = s->M2_speed_held;
    const transmission_real gears_ratio_divisor = transmission_select(p->gears_ratio_least_speed <=
        transmission_abs(gears_ratio_behind), gears_ratio_behind, 1.0);
    const transmission_real gears_ratio_quotient = transmission_max(p->gears_ratio_least,
        transmission_min(p->gears_ratio_most, s->M1_speed_held / gears_ratio_divisor));
    if (s->running <= 0.5) {
        /* the first step, and the first one after a fault, starts anew */
        s->gears_ratio_estimate = transmission_select(p->gears_ratio_least_speed <=
            transmission_abs(gears_ratio_behind), gears_ratio_quotient, gears_ratio_inside);
    }
    /* ratio from the speeds */
    const transmission_real gears_ratio_estimate_before = s->gears_ratio_estimate;
    s->gears_ratio_estimate = gears_ratio_estimate_before + transmission_select(p->gears_ratio_least_speed <=
        transmission_abs(gears_ratio_behind), s->gears_ratio_estimate_share * (-gears_ratio_estimate_before +
        gears_ratio_quotient), 0.0);
    /* a settled estimate is the ratio of a gear */
    const transmission_real gears_ratio_nearest = transmission_select(s->gears_ratio_estimate <= -2.1655, -4.932,
        transmission_select(s->gears_ratio_estimate <= 0.659, 0.601, transmission_select(s->gears_ratio_estimate <=
        0.7909999999999999, 0.717, transmission_select(s->gears_ratio_estimate <= 0.9325, 0.865,
        transmission_select(s->gears_ratio_estimate <= 1.1055000000000001, 1.0,
        transmission_select(s->gears_ratio_estimate <= 1.436, 1.211, transmission_select(s->gears_ratio_estimate <=
        1.988, 1.661, transmission_select(s->gears_ratio_estimate <= 2.824, 2.315,
        transmission_select(s->gears_ratio_estimate <= 4.418, 3.333, 5.503)))))))));
    s->gears_ratio_near_time = transmission_select(p->gears_ratio_tolerance * transmission_abs(gears_ratio_nearest)
        >= transmission_abs(s->gears_ratio_estimate - gears_ratio_nearest),
        transmission_min(s->gears_ratio_near_time + p->sample_time, p->gears_ratio_settle_time + p->sample_time),
        0.0);
    const transmission_real gears_ratio_gear_before = s->gears_ratio_gear;
    s->gears_ratio_gear = transmission_select(s->gears_ratio_near_time > p->gears_ratio_settle_time,
        gears_ratio_nearest, transmission_select(p->gears_ratio_tolerance *
        transmission_abs(gears_ratio_gear_before) < (0.6666666666666666) * transmission_abs(s->gears_ratio_estimate
        - gears_ratio_gear_before), 0.0, gears_ratio_gear_before));
    const transmission_real gears_ratio_snapped = transmission_select(transmission_abs(s->gears_ratio_gear) > 0.0,
        s->gears_ratio_gear, s->gears_ratio_estimate);
    /* ratio known or estimated (5.4.1) */
    const transmission_real gears_ratio_chosen = gears_ratio_inside * (1.0 - s->gears_ratio_source_now) +
        gears_ratio_snapped * s->gears_ratio_source_now;
    /* near standstill the speeds do not tell the ratio */
    const transmission_real gears_ratio_sure = -s->gears_ratio_source_now * (1.0 - transmission_max(0.0,
        transmission_min(1.0, -1.0 + transmission_abs(gears_ratio_behind) / p->gears_ratio_least_speed))) + 1.0;
    if (s->running <= 0.5) {
        /* the first step, and the first one after a fault, starts anew */
        s->gears_ratio_limited = gears_ratio_chosen;
    }
    /* limit of the rate */
    const transmission_real gears_ratio_before = s->gears_ratio_limited;
    s->gears_ratio_limited = gears_ratio_before + transmission_max(-s->gears_ratio_step,
        transmission_min(s->gears_ratio_step, -gears_ratio_before + gears_ratio_chosen));
    const transmission_real gears_ratio_change = s->steps_per_second * (1.0 - s->gears_ratio_source_now) *
        (-gears_ratio_before + s->gears_ratio_limited);
    /* torque commands of the step before */
    const transmission_real M1_applied = s->M1_last * s->authority;
    const transmission_real M2_applied = s->M2_last * s->authority;
    /* speed from the torques on the rotor */
    const transmission_real M1_integrated_before = s->M1_integrated;
    s->M1_integrated = M1_integrated_before + s->M1_per_step * (M1_applied - s->flange1_torque_held) +
        s->disagreement_share * (-M1_integrated_before + s->M1_speed_held);
    const transmission_real M1_difference = transmission_abs(s->M1_integrated - s->M1_speed_held);
    /* speed against torques */
    const transmission_real M1_agrees = transmission_select(M1_difference <= p->M1_disagreement_limit, 1.0, 0.0);
    transmission_lasting(M1_agrees, s->M1_disagreement_time, p->sample_time, p->hold_time,
        &s->M1_disagreement_time);
    /* M1_speed to the last bit */
    transmission_still(s->M1_speed_held, s->M1_speed_before, s->M1_speed_still_time, p->sample_time,
        &s->M1_speed_still_time);
    s->M1_speed_before = s->M1_speed_held;
    /* flange1_torque to the last bit */
    transmission_still(s->flange1_torque_held, s->flange1_torque_before, s->flange1_torque_still_time,
        p->sample_time, &s->flange1_torque_still_time);
    s->flange1_torque_before = s->flange1_torque_held;
    s->flange1_torque_command = transmission_select(s->flange1_torque_still_time > 0.0, s->flange1_torque_command,
        M1_applied);
    /* speed from the torques on the rotor */
    const transmission_real M2_integrated_before = s->M2_integrated;
    s->M2_integrated = M2_integrated_before + s->M2_per_step * (M2_applied + s->flange2_torque_held) +
        s->disagreement_share * (-M2_integrated_before + s->M2_speed_held);
    const transmission_real M2_difference = transmission_abs(s->M2_integrated - s->M2_speed_held);
    /* speed against torques */
    const transmission_real M2_agrees = transmission_select(M2_difference <= p->M2_disagreement_limit, 1.0, 0.0);
    transmission_lasting(M2_agrees, s->M2_disagreement_time, p->sample_time, p->hold_time,
        &s->M2_disagreement_time);
    /* M2_speed to the last bit */
    transmission_still(s->M2_speed_held, s->M2_speed_before, s->M2_speed_still_time, p->sample_time,
        &s->M2_speed_still_time);
    s->M2_speed_before = s->M2_speed_held;
    /* flange2_torque to the last bit */
    transmission_still(s->flange2_torque_held, s->flange2_torque_before, s->flange2_torque_still_time,
        p->sample_time, &s->flange2_torque_still_time);
    s->flange2_torque_before = s->flange2_torque_held;
    s->flange2_torque_command = transmission_select(s->flange2_torque_still_time > 0.0, s->flange2_torque_command,
        M2_applied);
    /* oscillation of flange1_torque */
    const transmission_real flange1_torque_mean_before = s->flange1_torque_mean;
    const transmission_real flange1_torque_swing = s->flange1_torque_held - flange1_torque_mean_before;
    s->flange1_torque_mean = flange1_torque_mean_before + flange1_torque_swing * s->mean_share;
    transmission_swings(flange1_torque_swing, p->flange1_torque_oscillation_limit, s->flange1_torque_side,
        s->flange1_torque_swings, s->forgotten_swings, &s->flange1_torque_side, &s->flange1_torque_swings);
    /* oscillation of flange2_torque */
    const transmission_real flange2_torque_mean_before = s->flange2_torque_mean;
    const transmission_real flange2_torque_swing = s->flange2_torque_held - flange2_torque_mean_before;
    s->flange2_torque_mean = flange2_torque_mean_before + flange2_torque_swing * s->mean_share;
    transmission_swings(flange2_torque_swing, p->flange2_torque_oscillation_limit, s->flange2_torque_side,
        s->flange2_torque_swings, s->forgotten_swings, &s->flange2_torque_side, &s->flange2_torque_swings);
    /* oscillation of M1_torque_ref */
    const transmission_real M1_torque_ref_mean_before = s->M1_torque_ref_mean;
    const transmission_real M1_torque_ref_swing = M1_applied - M1_torque_ref_mean_before;
    s->M1_torque_ref_mean = M1_torque_ref_mean_before + M1_torque_ref_swing * s->mean_share;
    transmission_swings(M1_torque_ref_swing, p->M1_torque_ref_oscillation_limit, s->M1_torque_ref_side,
        s->M1_torque_ref_swings, s->forgotten_swings, &s->M1_torque_ref_side, &s->M1_torque_ref_swings);
    /* oscillation of M2_torque_ref */
    const transmission_real M2_torque_ref_mean_before = s->M2_torque_ref_mean;
    const transmission_real M2_torque_ref_swing = M2_applied - M2_torque_ref_mean_before;
    s->M2_torque_ref_mean = M2_torque_ref_mean_before + M2_torque_ref_swing * s->mean_share;
    transmission_swings(M2_torque_ref_swing, p->M2_torque_ref_oscillation_limit, s->M2_torque_ref_side,
        s->M2_torque_ref_swings, s->forgotten_swings, &s->M2_torque_ref_side, &s->M2_torque_ref_swings);
    /* the first fault is latched */
    transmission_real cause_of_watching = 0.0;
    cause_of_watching = transmission_select(s->M2_torque_ref_swings <= 5.5, cause_of_watching, 8002.0);
    cause_of_watching = transmission_select(s->M1_torque_ref_swings <= 5.5, cause_of_watching, 8001.0);
    cause_of_watching = transmission_select(s->flange2_torque_swings <= 5.5, cause_of_watching, 6006.0);
    cause_of_watching = transmission_select(s->flange1_torque_swings <= 5.5, cause_of_watching, 6005.0);
    cause_of_watching = transmission_select(s->M2_disagreement_time <= s->bridged_time, cause_of_watching, 5007.0);
    cause_of_watching = transmission_select(s->M1_disagreement_time <= s->bridged_time, cause_of_watching, 5004.0);
    cause_of_watching = transmission_select(M2_difference <= p->M2_frozen_limit || s->M2_speed_still_time <=
        p->frozen_time, cause_of_watching, 3007.0);
    cause_of_watching = transmission_select(M2_difference <= p->M2_frozen_limit || s->flange2_torque_still_time <=
        p->frozen_time || transmission_abs(M2_applied - s->flange2_torque_command) <= s->M2_moved_torque,
        cause_of_watching, 3006.0);
    cause_of_watching = transmission_select(M1_difference <= p->M1_frozen_limit || s->flange1_torque_still_time <=
        p->frozen_time || transmission_abs(M1_applied - s->flange1_torque_command) <= s->M1_moved_torque,
        cause_of_watching, 3005.0);
    cause_of_watching = transmission_select(M1_difference <= p->M1_frozen_limit || s->M1_speed_still_time <=
        p->frozen_time, cause_of_watching, 3004.0);
    s->fault = transmission_select(s->fault > 0.5, s->fault, cause_of_watching);
    /* limit of the rate */
    const transmission_real M2_speed_ref_before = s->M2_speed_ref_limited;
    s->M2_speed_ref_limited = M2_speed_ref_before + transmission_max(-s->M2_speed_ref_step,
        transmission_min(s->M2_speed_ref_step, -M2_speed_ref_before + s->M2_speed_ref_held));
    /* testing torque while nothing accelerates (5.95), (5.96) */
    const transmission_real gears_input_torque_steady = s->flange1_torque_held;
    if (s->running <= 0.5) {
        /* the first step, and the first one after a fault, starts anew */
        s->gears_input_torque_ref_limited = gears_input_torque_steady;
    }
    /* limit of the rate */
    const transmission_real gears_input_torque_ref_before = s->gears_input_torque_ref_limited;
    s->gears_input_torque_ref_limited = gears_input_torque_ref_before +
        transmission_max(-s->gears_input_torque_ref_step, transmission_min(s->gears_input_torque_ref_step,
        -gears_input_torque_ref_before + s->gears_input_torque_ref_held));
    const transmission_real M2_speed_error = -s->M2_speed_held + s->M2_speed_ref_limited;
    /* load torque compensation (5.52), (5.74) */
    const transmission_real M2_compensation = -s->flange2_torque_held;
    /* so that a switch does not jump */
    const transmission_real M2_given_away = M2_compensation * (load_compensation_before - s->load_compensation_now);
    /* PI speed control (5.84) */
    const transmission_real M2_integral_before = s->M2_speed_integral +
        transmission_select(p->M2_speed_integral_gain > 0.0, M2_given_away, 0.0);
    const transmission_real M2_asked = M2_integral_before + M2_speed_error * p->M2_speed_gain;
    const transmission_real M2_wanted = M2_asked + M2_compensation * s->load_compensation_now;
    /* torque-speed envelope */
    const transmission_real M2_command = transmission_max(M2_least, transmission_min(M2_most, M2_wanted));
    /* what the limit cuts off */
    const transmission_real M2_cut = M2_command - M2_wanted;
    /* conditioning anti-windup (Hanus) */
    s->M2_speed_integral = M2_cut * s->M2_speed_conditioning + M2_integral_before + M2_speed_error *
        s->M2_speed_growth;
    /* net torque on the rotor */
    const transmission_real M2_net = M2_command - M2_compensation;
    /* testing torque from the sensors (5.95), (5.96), (5.98) */
    const transmission_real gears_input_torque_estimate = p->M1_sensor_inertia_M2 * s->M2_speed_held *
        gears_ratio_change + s->M1_unread_M2 * M2_net * s->gears_ratio_limited + gears_input_torque_steady;
    if (s->running <= 0.5) {
        /* the first step, and the first one after a fault, starts anew */
        s->M1_model_torque = gears_input_torque_steady;
    }
    /* torque model (5.57), (5.76) */
    const transmission_real M1_model_before = s->M1_model_torque;
    const transmission_real M1_rate_before = s->M1_model_rate;
    s->M1_model_rate = -s->M1_model_drag * M1_rate_before + s->M1_model_pull * (-M1_model_before +
        s->gears_input_torque_ref_limited) + M1_rate_before;
    s->M1_model_torque = M1_model_before + s->M1_model_rate * p->sample_time;
    const transmission_real M1_torque_error = s->M1_model_torque * p->M1_torque_model - gears_input_torque_estimate
        + s->gears_input_torque_ref_limited * (1.0 - p->M1_torque_model);
    /* torque control (5.99) */
    const transmission_real M1_integral_before = s->M1_torque_integral;
    const transmission_real M1_virtual = p->M1_feedforward * s->gears_input_torque_ref_limited + M1_integral_before
        + M1_torque_error * p->M1_torque_gain;
    /* active damping (5.62), (5.78) */
    const transmission_real M1_twist_rate_M1 = -s->M1_speed_held + s->M2_speed_held * s->gears_ratio_limited;
    const transmission_real M1_damping_torque = s->M1_damping_now * M1_twist_rate_M1 * gears_ratio_sure;
    /* with the acceleration torque (5.62), (5.78) */
    const transmission_real M1_wanted = M1_virtual + s->acceleration_torque_now * (p->M1_inertia_estimate *
        s->M2_speed_held * gears_ratio_change + p->M1_inertia_estimate * M2_net * s->gears_ratio_limited /
        p->M2_inertia);
    /* reserve for active damping */
    const transmission_real M1_kept = transmission_max(M1_least * (1.0 - p->M1_damping_reserve),
        transmission_min(M1_wanted, M1_most * (1.0 - p->M1_damping_reserve)));
    /* torque-speed envelope */
    const transmission_real M1_command = transmission_max(M1_least, transmission_min(M1_most, M1_damping_torque +
        M1_kept));
    /* limited integrator */
    s->M1_torque_integral = transmission_select(M1_torque_error * (-M1_kept + M1_wanted) > 0.0, M1_integral_before,
        transmission_max(-p->M1_torque_integral_limit, transmission_min(p->M1_torque_integral_limit,
        M1_integral_before + M1_torque_error * s->M1_torque_growth)));
    /* only sound torques leave */
    transmission_real M1_released;
    transmission_real M1_released_sound;
    transmission_guard(M1_command, s->M1_largest, s->M1_last, &M1_released, &M1_released_sound);
    transmission_real M2_released;
    transmission_real M2_released_sound;
    transmission_guard(M2_command, s->M2_largest, s->M2_last, &M2_released, &M2_released_sound);
    /* the first fault is latched */
    transmission_real cause_of_commands = 0.0;
    cause_of_commands = transmission_select(M2_released_sound > 0.5, cause_of_commands, 7002.0);
    cause_of_commands = transmission_select(M1_released_sound > 0.5, cause_of_commands, 7001.0);
    s->fault = transmission_select(s->fault > 0.5, s->fault, cause_of_commands);
    /* ramp of the torques */
    const transmission_real authority_wanted = s->authority + transmission_select(s->fault > 0.5, -s->ramp_step,
        s->ramp_step);
    transmission_share(authority_wanted, &s->authority);
    s->running = transmission_select(s->fault > 0.5, 0.0, 1.0);
    if (s->fault <= 0.5) {
        s->M1_last = M1_released;
    }
    /* the torque of before */
    const transmission_real M1_calmer = s->M1_calm + s->calm_share * (-s->M1_calm + s->M1_last);
    transmission_real M1_calm_sound;
    transmission_guard(M1_calmer, s->M1_largest, s->M1_calm, &s->M1_calm, &M1_calm_sound);
    if (s->fault > 2999.5) {
        s->M1_last = s->M1_calm;
    }
    if (s->fault <= 0.5) {
        /* ramp of the torques */
        s->M2_last = M2_released;
    }
    /* the torque of before */
    const transmission_real M2_calmer = s->M2_calm + s->calm_share * (-s->M2_calm + s->M2_last);
    transmission_real M2_calm_sound;
    transmission_guard(M2_calmer, s->M2_largest, s->M2_calm, &s->M2_calm, &M2_calm_sound);
    if (s->fault > 2999.5) {
        s->M2_last = s->M2_calm;
    }
    out->M1_torque_ref = transmission_max(-900.0, transmission_min(900.0, s->M1_last * s->authority));
    out->M2_torque_ref = transmission_max(-3300.0, transmission_min(3300.0, s->M2_last * s->authority));
    /* The last line of defence, should parameters have been changed without an update. */
    if (!transmission_is_finite(out->M1_torque_ref + out->M2_torque_ref)) {
        if (!transmission_is_finite(out->M1_torque_ref)) {
            out->M1_torque_ref = 0.0;
            s->fault = s->fault > 0.0 ? s->fault : TRANSMISSION_REAL(transmission_controller_fault_M1_torque_ref);
            s->running = 0.0;
        }
        if (!transmission_is_finite(out->M2_torque_ref)) {
            out->M2_torque_ref = 0.0;
            s->fault = s->fault > 0.0 ? s->fault : TRANSMISSION_REAL(transmission_controller_fault_M2_torque_ref);
            s->running = 0.0;
        }
    }
    return (transmission_controller_status)s->fault;
}
