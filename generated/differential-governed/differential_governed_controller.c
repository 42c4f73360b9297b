/*
 * differential_governed_controller.c: controller of the bed differential_governed
 *
 * Emitted by ptgen 0.1.0 from differential-governed.toml (SHA-256 d08516f63c075637), template block.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "differential_governed_controller.h"
#include "differential_governed_governor.h"

#include <float.h>
#include <string.h>

const differential_governed_controller_params differential_governed_controller_defaults = {
    .sample_time = 0.0001,
    .fault_ramp = 0.05,
    .hold_time = 0.001,
    .diff_input_torque_ref_plausible = 19400.0,
    .M2_speed_ref_plausible = 942.4777960769385,
    .M3_speed_ref_plausible = 942.4777960769385,
    .M1_speed_plausible = 1413.716694115407,
    .flange1_torque_plausible = 19400.0,
    .flange2_torque_plausible = 18500.0,
    .M2_speed_plausible = 942.4777960769385,
    .flange3_torque_plausible = 18500.0,
    .M3_speed_plausible = 942.4777960769385,
    .M1_overspeed = 1037.0,
    .M2_overspeed = 691.2,
    .M3_overspeed = 691.2,
    .load_compensation = 1.0,
    .acceleration_torque = 1.0,
    .switch_time = 0.5,
    .M1_damping = 261.282,
    .M1_speed_rated = 699.946843219806,
    .M1_speed_max = 942.477796076938,
    .M1_speed_taper = 47.1239,
    .M1_torque_max = 930.0,
    .M2_speed_rated = 188.495559215388,
    .M2_speed_max = 628.318530717959,
    .M2_speed_taper = 31.4159,
    .M2_torque_max = 3700.0,
    .M3_speed_rated = 188.495559215388,
    .M3_speed_max = 628.318530717959,
    .M3_speed_taper = 31.4159,
    .M3_torque_max = 3700.0,
    .disagreement_leak = 5.0,
    .M1_inertia = 1.0,
    .M1_disagreement_limit = 37.2,
    .M1_frozen_limit = 9.3,
    .frozen_time = 0.01,
    .M2_inertia = 10.3,
    .M2_disagreement_limit = 18.8,
    .M2_frozen_limit = 4.7,
    .M3_inertia = 10.3,
    .M3_disagreement_limit = 18.8,
    .M3_frozen_limit = 4.7,
    .oscillation_frequency = 10.9,
    .flange1_torque_oscillation_limit = 930.0,
    .flange2_torque_oscillation_limit = 3700.0,
    .flange3_torque_oscillation_limit = 3700.0,
    .M1_torque_ref_oscillation_limit = 465.0,
    .M2_torque_ref_oscillation_limit = 1850.0,
    .M3_torque_ref_oscillation_limit = 1850.0,
    .M2_speed_ref_rate = 6283.18530717959,
    .M3_speed_ref_rate = 6283.18530717959,
    .diff_input_torque_ref_rate = 500000.0,
    .M2_speed_gain = 309.0,
    .M2_speed_integral_gain = 2317.5,
    .M3_speed_gain = 309.0,
    .M3_speed_integral_gain = 2317.5,
    .M1_sensor_inertia_M2 = -0.03056,
    .M1_sensor_inertia_M3 = -0.03056,
    .M1_inertia_estimate = 1.032,
    .M1_feedforward = 1.0,
    .M1_torque_gain = 0.0,
    .M1_model_stiffness = 16537.8,
    .M1_model_damping = 261.282,
    .M1_torque_model = 1.0,
    .diff_ratio = 1.91,
    .M1_torque_integral_gain = 20.0,
    .M1_damping_reserve = 0.05,
    .M1_torque_integral_limit = 465.0,
    .governor = 2.0,
    .governor_reserve = 0.05,
    .governor_stationary_reserve = 0.02,
    .governor_tie = 0.10471975511965977,
    .torque_rate_min = 1000.0,
    .torque_reserve = 0.0,
    .M1_at_rest_diff_input_torque_ref = 1.0,
    .M2_at_rest_diff_input_torque_ref = -0.955,
    .M3_at_rest_diff_input_torque_ref = -0.955,
};

const differential_governed_controller_params differential_governed_controller_conventional = {
    .sample_time = 0.0001,
    .fault_ramp = 0.05,
    .hold_time = 0.001,
    .diff_input_torque_ref_plausible = 19400.0,
    .M2_speed_ref_plausible = 942.4777960769385,
    .M3_speed_ref_plausible = 942.4777960769385,
    .M1_speed_plausible = 1413.716694115407,
    .flange1_torque_plausible = 19400.0,
    .flange2_torque_plausible = 18500.0,
    .M2_speed_plausible = 942.4777960769385,
    .flange3_torque_plausible = 18500.0,
    .M3_speed_plausible = 942.4777960769385,
    .M1_overspeed = 1037.0,
    .M2_overspeed = 691.2,
    .M3_overspeed = 691.2,
    .load_compensation = 0.0,
    .acceleration_torque = 0.0,
    .switch_time = 0.5,
    .M1_damping = 0.0,
    .M1_speed_rated = 699.946843219806,
    .M1_speed_max = 942.477796076938,
    .M1_speed_taper = 47.1239,
    .M1_torque_max = 930.0,
    .M2_speed_rated = 188.495559215388,
    .M2_speed_max = 628.318530717959,
    .M2_speed_taper = 31.4159,
    .M2_torque_max = 3700.0,
    .M3_speed_rated = 188.495559215388,
    .M3_speed_max = 628.318530717959,
    .M3_speed_taper = 31.4159,
    .M3_torque_max = 3700.0,
    .disagreement_leak = 5.0,
    .M1_inertia = 1.0,
    .M1_disagreement_limit = 37.2,
    .M1_frozen_limit = 9.3,
    .frozen_time = 0.01,
    .M2_inertia = 10.3,
    .M2_disagreement_limit = 18.8,
    .M2_frozen_limit = 4.7,
    .M3_inertia = 10.3,
    .M3_disagreement_limit = 18.8,
    .M3_frozen_limit = 4.7,
    .oscillation_frequency = 10.9,
    .flange1_torque_oscillation_limit = 930.0,
    .flange2_torque_oscillation_limit = 3700.0,
    .flange3_torque_oscillation_limit = 3700.0,
    .M1_torque_ref_oscillation_limit = 465.0,
    .M2_torque_ref_oscillation_limit = 1850.0,
    .M3_torque_ref_oscillation_limit = 1850.0,
    .M2_speed_ref_rate = 6283.18530717959,
    .M3_speed_ref_rate = 6283.18530717959,
    .diff_input_torque_ref_rate = 500000.0,
    .M2_speed_gain = 309.0,
    .M2_speed_integral_gain = 2317.5,
    .M3_speed_gain = 309.0,
    .M3_speed_integral_gain = 2317.5,
    .M1_sensor_inertia_M2 = -0.03056,
    .M1_sensor_inertia_M3 = -0.03056,
    .M1_inertia_estimate = 1.032,
    .M1_feedforward = 1.0,
    .M1_torque_gain = 0.0,
    .M1_model_stiffness = 16537.8,
    .M1_model_damping = 261.282,
    .M1_torque_model = 0.0,
    .diff_ratio = 1.91,
    .M1_torque_integral_gain = 0.275388,
    .M1_damping_reserve = 0.05,
    .M1_torque_integral_limit = 465.0,
    .governor = 2.0,
    .governor_reserve = 0.05,
    .governor_stationary_reserve = 0.02,
    .governor_tie = 0.10471975511965977,
    .torque_rate_min = 1000.0,
    .torque_reserve = 0.0,
    .M1_at_rest_diff_input_torque_ref = 1.0,
    .M2_at_rest_diff_input_torque_ref = -0.955,
    .M3_at_rest_diff_input_torque_ref = -0.955,
};

/* references with the same positive number may be led together */
static const differential_governed_real governor_groups[4] = {
    0.0, 1.0, 1.0,
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
    { "the parameter sample_time is outside its range", offsetof(differential_governed_controller_params, sample_time), 0.0, DBL_MAX, 1, 0 },
    { "the parameter fault_ramp is outside its range", offsetof(differential_governed_controller_params, fault_ramp), 0.0, DBL_MAX, 1, 0 },
    { "the parameter hold_time is outside its range", offsetof(differential_governed_controller_params, hold_time), 0.0, DBL_MAX, 0, 0 },
    { "the parameter diff_input_torque_ref_plausible is outside its range", offsetof(differential_governed_controller_params, diff_input_torque_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_ref_plausible is outside its range", offsetof(differential_governed_controller_params, M2_speed_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_ref_plausible is outside its range", offsetof(differential_governed_controller_params, M3_speed_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_plausible is outside its range", offsetof(differential_governed_controller_params, M1_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_torque_plausible is outside its range", offsetof(differential_governed_controller_params, flange1_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_torque_plausible is outside its range", offsetof(differential_governed_controller_params, flange2_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_plausible is outside its range", offsetof(differential_governed_controller_params, M2_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_torque_plausible is outside its range", offsetof(differential_governed_controller_params, flange3_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_plausible is outside its range", offsetof(differential_governed_controller_params, M3_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_overspeed is outside its range", offsetof(differential_governed_controller_params, M1_overspeed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_overspeed is outside its range", offsetof(differential_governed_controller_params, M2_overspeed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_overspeed is outside its range", offsetof(differential_governed_controller_params, M3_overspeed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter load_compensation is outside its range", offsetof(differential_governed_controller_params, load_compensation), 0.0, 1.0, 0, 0 },
    { "the parameter acceleration_torque is outside its range", offsetof(differential_governed_controller_params, acceleration_torque), 0.0, 1.0, 0, 0 },
    { "the parameter switch_time is outside its range", offsetof(differential_governed_controller_params, switch_time), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_damping is outside its range", offsetof(differential_governed_controller_params, M1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_speed_rated is outside its range", offsetof(differential_governed_controller_params, M1_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_max is outside its range", offsetof(differential_governed_controller_params, M1_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_taper is outside its range", offsetof(differential_governed_controller_params, M1_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_max is outside its range", offsetof(differential_governed_controller_params, M1_torque_max), 0.0, 930.0, 1, 0 },
    { "the parameter M2_speed_rated is outside its range", offsetof(differential_governed_controller_params, M2_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_max is outside its range", offsetof(differential_governed_controller_params, M2_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_taper is outside its range", offsetof(differential_governed_controller_params, M2_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_max is outside its range", offsetof(differential_governed_controller_params, M2_torque_max), 0.0, 3700.0, 1, 0 },
    { "the parameter M3_speed_rated is outside its range", offsetof(differential_governed_controller_params, M3_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_max is outside its range", offsetof(differential_governed_controller_params, M3_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_taper is outside its range", offsetof(differential_governed_controller_params, M3_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_torque_max is outside its range", offsetof(differential_governed_controller_params, M3_torque_max), 0.0, 3700.0, 1, 0 },
    { "the parameter disagreement_leak is outside its range", offsetof(differential_governed_controller_params, disagreement_leak), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_inertia is outside its range", offsetof(differential_governed_controller_params, M1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_disagreement_limit is outside its range", offsetof(differential_governed_controller_params, M1_disagreement_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_frozen_limit is outside its range", offsetof(differential_governed_controller_params, M1_frozen_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter frozen_time is outside its range", offsetof(differential_governed_controller_params, frozen_time), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_inertia is outside its range", offsetof(differential_governed_controller_params, M2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_disagreement_limit is outside its range", offsetof(differential_governed_controller_params, M2_disagreement_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_frozen_limit is outside its range", offsetof(differential_governed_controller_params, M2_frozen_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_inertia is outside its range", offsetof(differential_governed_controller_params, M3_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_disagreement_limit is outside its range", offsetof(differential_governed_controller_params, M3_disagreement_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_frozen_limit is outside its range", offsetof(differential_governed_controller_params, M3_frozen_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter oscillation_frequency is outside its range", offsetof(differential_governed_controller_params, oscillation_frequency), 0.0, DBL_MAX, 0, 0 },
    { "the parameter flange1_torque_oscillation_limit is outside its range", offsetof(differential_governed_controller_params, flange1_torque_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_torque_oscillation_limit is outside its range", offsetof(differential_governed_controller_params, flange2_torque_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_torque_oscillation_limit is outside its range", offsetof(differential_governed_controller_params, flange3_torque_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_ref_oscillation_limit is outside its range", offsetof(differential_governed_controller_params, M1_torque_ref_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_ref_oscillation_limit is outside its range", offsetof(differential_governed_controller_params, M2_torque_ref_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_torque_ref_oscillation_limit is outside its range", offsetof(differential_governed_controller_params, M3_torque_ref_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_ref_rate is outside its range", offsetof(differential_governed_controller_params, M2_speed_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_ref_rate is outside its range", offsetof(differential_governed_controller_params, M3_speed_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter diff_input_torque_ref_rate is outside its range", offsetof(differential_governed_controller_params, diff_input_torque_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_gain is outside its range", offsetof(differential_governed_controller_params, M2_speed_gain), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_integral_gain is outside its range", offsetof(differential_governed_controller_params, M2_speed_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M3_speed_gain is outside its range", offsetof(differential_governed_controller_params, M3_speed_gain), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_integral_gain is outside its range", offsetof(differential_governed_controller_params, M3_speed_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_sensor_inertia_M2 is outside its range", offsetof(differential_governed_controller_params, M1_sensor_inertia_M2), -DBL_MAX, DBL_MAX, 0, 0 },
    { "the parameter M1_sensor_inertia_M3 is outside its range", offsetof(differential_governed_controller_params, M1_sensor_inertia_M3), -DBL_MAX, DBL_MAX, 0, 0 },
    { "the parameter M1_inertia_estimate is outside its range", offsetof(differential_governed_controller_params, M1_inertia_estimate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_feedforward is outside its range", offsetof(differential_governed_controller_params, M1_feedforward), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_torque_gain is outside its range", offsetof(differential_governed_controller_params, M1_torque_gain), -1.0, DBL_MAX, 1, 0 },
    { "the parameter M1_model_stiffness is outside its range", offsetof(differential_governed_controller_params, M1_model_stiffness), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_model_damping is outside its range", offsetof(differential_governed_controller_params, M1_model_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_torque_model is outside its range", offsetof(differential_governed_controller_params, M1_torque_model), 0.0, 1.0, 0, 0 },
    { "the parameter diff_ratio is outside its range", offsetof(differential_governed_controller_params, diff_ratio), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter M1_torque_integral_gain is outside its range", offsetof(differential_governed_controller_params, M1_torque_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_damping_reserve is outside its range", offsetof(differential_governed_controller_params, M1_damping_reserve), 0.0, 1.0, 0, 0 },
    { "the parameter M1_torque_integral_limit is outside its range", offsetof(differential_governed_controller_params, M1_torque_integral_limit), 0.0, DBL_MAX, 0, 0 },
    { "the parameter governor is outside its range", offsetof(differential_governed_controller_params, governor), 0.0, 2.0, 0, 0 },
    { "the parameter governor_reserve is outside its range", offsetof(differential_governed_controller_params, governor_reserve), 0.0, 0.5, 0, 0 },
    { "the parameter governor_stationary_reserve is outside its range", offsetof(differential_governed_controller_params, governor_stationary_reserve), 0.0, 0.5, 0, 0 },
    { "the parameter governor_tie is outside its range", offsetof(differential_governed_controller_params, governor_tie), 0.0, DBL_MAX, 0, 0 },
    { "the parameter torque_rate_min is outside its range", offsetof(differential_governed_controller_params, torque_rate_min), 0.0, DBL_MAX, 0, 0 },
    { "the parameter torque_reserve is outside its range", offsetof(differential_governed_controller_params, torque_reserve), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_at_rest_diff_input_torque_ref is outside its range", offsetof(differential_governed_controller_params, M1_at_rest_diff_input_torque_ref), -DBL_MAX, DBL_MAX, 0, 0 },
    { "the parameter M2_at_rest_diff_input_torque_ref is outside its range", offsetof(differential_governed_controller_params, M2_at_rest_diff_input_torque_ref), -DBL_MAX, DBL_MAX, 0, 0 },
    { "the parameter M3_at_rest_diff_input_torque_ref is outside its range", offsetof(differential_governed_controller_params, M3_at_rest_diff_input_torque_ref), -DBL_MAX, DBL_MAX, 0, 0 },
};

enum { limit_count = sizeof limits / sizeof limits[0] };

const char *differential_governed_controller_status_text(differential_governed_controller_status status)
{
    switch ((int)status) {
    case differential_governed_controller_ok:
        return "ok";
    case differential_governed_controller_fault_diff_input_torque_ref:
        return "diff_input_torque_ref: not finite or not plausible";
    case differential_governed_controller_fault_M2_speed_ref:
        return "M2_speed_ref: not finite or not plausible";
    case differential_governed_controller_fault_M3_speed_ref:
        return "M3_speed_ref: not finite or not plausible";
    case differential_governed_controller_fault_M1_speed:
        return "M1_speed: not finite or not plausible";
    case differential_governed_controller_fault_flange1_torque:
        return "flange1_torque: not finite or not plausible";
    case differential_governed_controller_fault_flange2_torque:
        return "flange2_torque: not finite or not plausible";
    case differential_governed_controller_fault_M2_speed:
        return "M2_speed: not finite or not plausible";
    case differential_governed_controller_fault_flange3_torque:
        return "flange3_torque: not finite or not plausible";
    case differential_governed_controller_fault_M3_speed:
        return "M3_speed: not finite or not plausible";
    case differential_governed_controller_fault_M1_speed_overspeed:
        return "M1_speed: overspeed";
    case differential_governed_controller_fault_M2_speed_overspeed:
        return "M2_speed: overspeed";
    case differential_governed_controller_fault_M3_speed_overspeed:
        return "M3_speed: overspeed";
    case differential_governed_controller_fault_M1_speed_frozen:
        return "M1_speed: frozen while the torques accelerate the machine";
    case differential_governed_controller_fault_M1_speed_disagreement:
        return "M1_speed: disagrees with the integrated torque";
    case differential_governed_controller_fault_flange1_torque_frozen:
        return "flange1_torque: frozen while the torque of the machine changes";
    case differential_governed_controller_fault_M2_speed_frozen:
        return "M2_speed: frozen while the torques accelerate the machine";
    case differential_governed_controller_fault_M2_speed_disagreement:
        return "M2_speed: disagrees with the integrated torque";
    case differential_governed_controller_fault_flange2_torque_frozen:
        return "flange2_torque: frozen while the torque of the machine changes";
    case differential_governed_controller_fault_M3_speed_frozen:
        return "M3_speed: frozen while the torques accelerate the machine";
    case differential_governed_controller_fault_M3_speed_disagreement:
        return "M3_speed: disagrees with the integrated torque";
    case differential_governed_controller_fault_flange3_torque_frozen:
        return "flange3_torque: frozen while the torque of the machine changes";
    case differential_governed_controller_fault_flange1_torque_oscillation:
        return "flange1_torque: oscillates beyond its limit";
    case differential_governed_controller_fault_flange2_torque_oscillation:
        return "flange2_torque: oscillates beyond its limit";
    case differential_governed_controller_fault_flange3_torque_oscillation:
        return "flange3_torque: oscillates beyond its limit";
    case differential_governed_controller_fault_M1_torque_ref_oscillation:
        return "M1_torque_ref: the command oscillates";
    case differential_governed_controller_fault_M2_torque_ref_oscillation:
        return "M2_torque_ref: the command oscillates";
    case differential_governed_controller_fault_M3_torque_ref_oscillation:
        return "M3_torque_ref: the command oscillates";
    case differential_governed_controller_fault_M1_torque_ref:
        return "M1_torque_ref: the command is not finite, or beyond the torque of the machine";
    case differential_governed_controller_fault_M2_torque_ref:
        return "M2_torque_ref: the command is not finite, or beyond the torque of the machine";
    case differential_governed_controller_fault_M3_torque_ref:
        return "M3_torque_ref: the command is not finite, or beyond the torque of the machine";
    default:
        break;
    }
    const int limit = (int)status - 2000;
    return limit >= 0 && limit < limit_count ? limits[limit].text : "unknown status";
}

differential_governed_controller_status differential_governed_controller_init(differential_governed_controller_state *s, const differential_governed_controller_params *p)
{
    memset(s, 0, sizeof *s);
    s->authority = 1.0;
    s->diff_input_torque_ref_bad_time = 1e+30;
    s->M2_speed_ref_bad_time = 1e+30;
    s->M3_speed_ref_bad_time = 1e+30;
    s->M1_speed_bad_time = 1e+30;
    s->flange1_torque_bad_time = 1e+30;
    s->flange2_torque_bad_time = 1e+30;
    s->M2_speed_bad_time = 1e+30;
    s->flange3_torque_bad_time = 1e+30;
    s->M3_speed_bad_time = 1e+30;
    s->reset_before = 1.0;
    const differential_governed_controller_status status = differential_governed_controller_update(s, p);
    if (status != differential_governed_controller_ok) {
        s->authority = 0.0; /* never started: no torque at all */
    }
    return status;
}

differential_governed_controller_status differential_governed_controller_update(differential_governed_controller_state *s, const differential_governed_controller_params *p)
{
    for (int k = 0; k < limit_count; ++k) {
        const differential_governed_real value = *(const differential_governed_real *)(const void *)((const char *)p + limits[k].offset);
        const int above = limits[k].open ? value > limits[k].least : value >= limits[k].least; /* false for NaN */
        if (!(above && value <= limits[k].most) || (limits[k].not_zero && value == 0.0)) {
            s->fault = s->fault > 0.0 ? s->fault : DIFFERENTIAL_GOVERNED_REAL(2000 + k); /* latched like any fault */
            s->refused = 1.0; /* no reset before an update succeeds */
            return (differential_governed_controller_status)(2000 + k);
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
    s->M3_taper_slope = 1.0 / p->M3_speed_taper;
    s->M3_taper_end = p->M3_speed_max / p->M3_speed_taper + 1.0;
    s->M3_power = p->M3_speed_rated * p->M3_torque_max;
    s->disagreement_share = p->disagreement_leak * p->sample_time;
    s->M1_per_step = p->sample_time / p->M1_inertia;
    s->M1_moved_torque = 0.05 * p->M1_torque_max;
    s->M2_per_step = p->sample_time / p->M2_inertia;
    s->M2_moved_torque = 0.05 * p->M2_torque_max;
    s->M3_per_step = p->sample_time / p->M3_inertia;
    s->M3_moved_torque = 0.05 * p->M3_torque_max;
    s->forgotten_swings = p->oscillation_frequency * p->sample_time;
    s->mean_share = 6.2832 * p->oscillation_frequency * p->sample_time;
    s->M2_speed_ref_step = p->M2_speed_ref_rate * p->sample_time;
    s->M3_speed_ref_step = p->M3_speed_ref_rate * p->sample_time;
    s->diff_input_torque_ref_step = p->diff_input_torque_ref_rate * p->sample_time;
    s->M2_speed_growth = p->M2_speed_integral_gain * p->sample_time;
    s->M2_speed_conditioning = p->M2_speed_integral_gain * p->sample_time / p->M2_speed_gain;
    s->M3_speed_growth = p->M3_speed_integral_gain * p->sample_time;
    s->M3_speed_conditioning = p->M3_speed_integral_gain * p->sample_time / p->M3_speed_gain;
    s->M1_unread_M2 = p->M1_sensor_inertia_M2 / p->M2_inertia;
    s->M1_unread_M3 = p->M1_sensor_inertia_M3 / p->M3_inertia;
    s->M1_model_pull = p->M1_model_stiffness * p->sample_time / p->M1_inertia_estimate;
    s->M1_model_drag = p->M1_model_damping * p->sample_time / p->M1_inertia_estimate;
    s->M1_with_M2 = (0.5) * p->M1_inertia_estimate * p->diff_ratio / p->M2_inertia;
    s->M1_with_M3 = (0.5) * p->M1_inertia_estimate * p->diff_ratio / p->M3_inertia;
    s->M1_twist_M1_M2_speed = (0.5) * p->diff_ratio;
    s->M1_twist_M1_M3_speed = (0.5) * p->diff_ratio;
    s->M1_torque_growth = p->M1_torque_integral_gain * p->sample_time;
    s->M2_governed_speed = p->M2_speed_max * (1.0 - p->governor_stationary_reserve);
    s->M3_governed_speed = p->M3_speed_max * (1.0 - p->governor_stationary_reserve);
    s->M1_follows_M1 = p->M1_feedforward + p->M1_torque_gain * (s->M1_model_pull * p->M1_torque_model *
        p->sample_time - p->M1_torque_model + 1.0);
    s->torque_step_min = p->sample_time * p->torque_rate_min;
    s->governor_finite = 1e+30;
    s->M1_largest = 1.01 * differential_governed_min(930.0, p->M1_torque_max);
    s->M2_largest = 1.01 * differential_governed_min(3700.0, p->M2_torque_max);
    s->M3_largest = 1.01 * differential_governed_min(3700.0, p->M3_torque_max);
    s->ramp_step = p->sample_time / p->fault_ramp;
    s->calm_share = p->sample_time / (p->sample_time + 0.02);
    s->refused = 0.0;
    return differential_governed_controller_ok;
}

differential_governed_controller_status differential_governed_controller_step(differential_governed_controller_state *s, const differential_governed_controller_params *p,
    const differential_governed_controller_inputs *in, differential_governed_controller_outputs *out)
{
    differential_governed_real governor_wanted[4];
    differential_governed_real governor_before[4];
    differential_governed_real governor_least[4];
    differential_governed_real governor_most[4];
    differential_governed_real governor_free[4];
    differential_governed_real governor_gain[3][4];
    differential_governed_real governor_room[4];
    differential_governed_real governor_rate[4];
    differential_governed_real governor_sequential[4];
    differential_governed_real governor_change[4];
    differential_governed_real governor_response[4];
    differential_governed_zero(sizeof governor_wanted, governor_wanted);
    differential_governed_zero(sizeof governor_before, governor_before);
    differential_governed_zero(sizeof governor_least, governor_least);
    differential_governed_zero(sizeof governor_most, governor_most);
    differential_governed_zero(sizeof governor_free, governor_free);
    differential_governed_zero(sizeof governor_gain, governor_gain);
    differential_governed_zero(sizeof governor_room, governor_room);
    differential_governed_zero(sizeof governor_rate, governor_rate);
    differential_governed_zero(sizeof governor_sequential, governor_sequential);
    differential_governed_zero(sizeof governor_change, governor_change);
    differential_governed_zero(sizeof governor_response, governor_response);
    
    /* supervision: bad samples are bridged */
    differential_governed_real diff_input_torque_ref_sound;
    differential_governed_guard(in->diff_input_torque_ref, p->diff_input_torque_ref_plausible,
        s->diff_input_torque_ref_held, &s->diff_input_torque_ref_held, &diff_input_torque_ref_sound);
    differential_governed_lasting(diff_input_torque_ref_sound, s->diff_input_torque_ref_bad_time, p->sample_time,
        p->hold_time, &s->diff_input_torque_ref_bad_time);
    differential_governed_real M2_speed_ref_sound;
    differential_governed_guard(in->M2_speed_ref, p->M2_speed_ref_plausible, s->M2_speed_ref_held,
        &s->M2_speed_ref_held, &M2_speed_ref_sound);
    differential_governed_lasting(M2_speed_ref_sound, s->M2_speed_ref_bad_time, p->sample_time, p->hold_time,
        &s->M2_speed_ref_bad_time);
    differential_governed_real M3_speed_ref_sound;
    differential_governed_guard(in->M3_speed_ref, p->M3_speed_ref_plausible, s->M3_speed_ref_held,
        &s->M3_speed_ref_held, &M3_speed_ref_sound);
    differential_governed_lasting(M3_speed_ref_sound, s->M3_speed_ref_bad_time, p->sample_time, p->hold_time,
        &s->M3_speed_ref_bad_time);
    differential_governed_real M1_speed_sound;
    differential_governed_guard(in->M1_speed, p->M1_speed_plausible, s->M1_speed_held, &s->M1_speed_held,
        &M1_speed_sound);
    differential_governed_lasting(M1_speed_sound, s->M1_speed_bad_time, p->sample_time, p->hold_time,
        &s->M1_speed_bad_time);
    differential_governed_real flange1_torque_sound;
    differential_governed_guard(in->flange1_torque, p->flange1_torque_plausible, s->flange1_torque_held,
        &s->flange1_torque_held, &flange1_torque_sound);
    differential_governed_lasting(flange1_torque_sound, s->flange1_torque_bad_time, p->sample_time, p->hold_time,
        &s->flange1_torque_bad_time);
    differential_governed_real flange2_torque_sound;
    differential_governed_guard(in->flange2_torque, p->flange2_torque_plausible, s->flange2_torque_held,
        &s->flange2_torque_held, &flange2_torque_sound);
    differential_governed_lasting(flange2_torque_sound, s->flange2_torque_bad_time, p->sample_time, p->hold_time,
        &s->flange2_torque_bad_time);
    differential_governed_real M2_speed_sound;
    differential_governed_guard(in->M2_speed, p->M2_speed_plausible, s->M2_speed_held, &s->M2_speed_held,
        &M2_speed_sound);
    differential_governed_lasting(M2_speed_sound, s->M2_speed_bad_time, p->sample_time, p->hold_time,
        &s->M2_speed_bad_time);
    differential_governed_real flange3_torque_sound;
    differential_governed_guard(in->flange3_torque, p->flange3_torque_plausible, s->flange3_torque_held,
        &s->flange3_torque_held, &flange3_torque_sound);
    differential_governed_lasting(flange3_torque_sound, s->flange3_torque_bad_time, p->sample_time, p->hold_time,
        &s->flange3_torque_bad_time);
    differential_governed_real M3_speed_sound;
    differential_governed_guard(in->M3_speed, p->M3_speed_plausible, s->M3_speed_held, &s->M3_speed_held,
        &M3_speed_sound);
    differential_governed_lasting(M3_speed_sound, s->M3_speed_bad_time, p->sample_time, p->hold_time,
        &s->M3_speed_bad_time);
    /* overspeed */
    const differential_governed_real M1_slow_enough = differential_governed_select(p->M1_overspeed >=
        differential_governed_abs(s->M1_speed_held), 1.0, 0.0);
    differential_governed_lasting(M1_slow_enough, s->M1_overspeed_time, p->sample_time, p->hold_time,
        &s->M1_overspeed_time);
    const differential_governed_real M2_slow_enough = differential_governed_select(p->M2_overspeed >=
        differential_governed_abs(s->M2_speed_held), 1.0, 0.0);
    differential_governed_lasting(M2_slow_enough, s->M2_overspeed_time, p->sample_time, p->hold_time,
        &s->M2_overspeed_time);
    const differential_governed_real M3_slow_enough = differential_governed_select(p->M3_overspeed >=
        differential_governed_abs(s->M3_speed_held), 1.0, 0.0);
    differential_governed_lasting(M3_slow_enough, s->M3_overspeed_time, p->sample_time, p->hold_time,
        &s->M3_overspeed_time);
    /* reset on request, when the cause is gone */
    const differential_governed_real reset_pressed =
        differential_governed_select(differential_governed_abs(in->reset - 1.0) <= 0.5, 1.0, 0.0);
    s->reset_request = differential_governed_select(s->fault > 0.5, differential_governed_select(p->M1_overspeed >=
        differential_governed_abs(s->M1_speed_held) && p->M1_speed_plausible >=
        differential_governed_abs(in->M1_speed) && p->M2_overspeed >= differential_governed_abs(s->M2_speed_held) &&
        p->M2_speed_plausible >= differential_governed_abs(in->M2_speed) && p->M2_speed_ref_plausible >=
        differential_governed_abs(in->M2_speed_ref) && p->M3_overspeed >=
        differential_governed_abs(s->M3_speed_held) && p->M3_speed_plausible >=
        differential_governed_abs(in->M3_speed) && p->M3_speed_ref_plausible >=
        differential_governed_abs(in->M3_speed_ref) && p->diff_input_torque_ref_plausible >=
        differential_governed_abs(in->diff_input_torque_ref) && p->flange1_torque_plausible >=
        differential_governed_abs(in->flange1_torque) && p->flange2_torque_plausible >=
        differential_governed_abs(in->flange2_torque) && p->flange3_torque_plausible >=
        differential_governed_abs(in->flange3_torque), (1.0 - s->refused) *
        differential_governed_max(s->reset_request, -s->reset_before + reset_pressed), 0.0), 0.0);
    s->reset_before = reset_pressed;
    s->fault = s->fault * (1.0 - differential_governed_select(s->authority <= 0.0, s->reset_request, 0.0));
    s->reset_request = differential_governed_select(s->fault > 0.5, s->reset_request, 0.0);
    /* the first fault is latched */
    differential_governed_real cause_of_inputs = 0.0;
    cause_of_inputs = differential_governed_select(s->M3_overspeed_time <= s->bridged_time, cause_of_inputs,
        4009.0);
    cause_of_inputs = differential_governed_select(s->M2_overspeed_time <= s->bridged_time, cause_of_inputs,
        4007.0);
    cause_of_inputs = differential_governed_select(s->M1_overspeed_time <= s->bridged_time, cause_of_inputs,
        4004.0);
    cause_of_inputs = differential_governed_select(s->M3_speed_bad_time <= s->bridged_time, cause_of_inputs, 9.0);
    cause_of_inputs = differential_governed_select(s->flange3_torque_bad_time <= s->bridged_time, cause_of_inputs,
        8.0);
    cause_of_inputs = differential_governed_select(s->M2_speed_bad_time <= s->bridged_time, cause_of_inputs, 7.0);
    cause_of_inputs = differential_governed_select(s->flange2_torque_bad_time <= s->bridged_time, cause_of_inputs,
        6.0);
    cause_of_inputs = differential_governed_select(s->flange1_torque_bad_time <= s->bridged_time, cause_of_inputs,
        5.0);
    cause_of_inputs = differential_governed_select(s->M1_speed_bad_time <= s->bridged_time, cause_of_inputs, 4.0);
    cause_of_inputs = differential_governed_select(s->M3_speed_ref_bad_time <= s->bridged_time, cause_of_inputs,
        3.0);
    cause_of_inputs = differential_governed_select(s->M2_speed_ref_bad_time <= s->bridged_time, cause_of_inputs,
        2.0);
    cause_of_inputs = differential_governed_select(s->diff_input_torque_ref_bad_time <= s->bridged_time,
        cause_of_inputs, 1.0);
    s->fault = differential_governed_select(s->fault > 0.5, s->fault, cause_of_inputs);
    if (s->running <= 0.5) {
        /* the first step, and the first one after a fault, starts anew */
        s->load_compensation_now = p->load_compensation;
        s->acceleration_torque_now = p->acceleration_torque;
        s->M1_damping_now = p->M1_damping;
        s->M1_integrated = s->M1_speed_held;
        s->M1_speed_still_time = 0.0;
        s->flange1_torque_still_time = 0.0;
        s->M2_integrated = s->M2_speed_held;
        s->M2_speed_still_time = 0.0;
        s->flange2_torque_still_time = 0.0;
        s->M3_integrated = s->M3_speed_held;
        s->M3_speed_still_time = 0.0;
        s->flange3_torque_still_time = 0.0;
        s->flange1_torque_mean = s->flange1_torque_held;
        s->flange1_torque_swings = 0.0;
        s->flange2_torque_mean = s->flange2_torque_held;
        s->flange2_torque_swings = 0.0;
        s->flange3_torque_mean = s->flange3_torque_held;
        s->flange3_torque_swings = 0.0;
        s->M1_torque_ref_mean = 0.0;
        s->M1_torque_ref_swings = 0.0;
        s->M2_torque_ref_mean = 0.0;
        s->M2_torque_ref_swings = 0.0;
        s->M3_torque_ref_mean = 0.0;
        s->M3_torque_ref_swings = 0.0;
        s->M2_speed_ref_limited = s->M2_speed_held;
        s->M3_speed_ref_limited = s->M3_speed_held;
        s->M2_speed_integral = 0.0;
        s->M3_speed_integral = 0.0;
        s->M1_model_rate = 0.0;
        s->M1_torque_integral = 0.0;
    }
    /* load_compensation follows its parameter along a ramp */
    const differential_governed_real load_compensation_before = s->load_compensation_now;
    const differential_governed_real load_compensation_distance = p->load_compensation - load_compensation_before;
    if (p->load_compensation != s->load_compensation_target) {
        s->load_compensation_step = differential_governed_max(s->switch_share *
            differential_governed_abs(load_compensation_distance), 1e-06 *
            differential_governed_abs(p->load_compensation) + 1e-06 *
            differential_governed_abs(load_compensation_before));
    }
    s->load_compensation_now = differential_governed_select(s->load_compensation_step <
        differential_governed_abs(load_compensation_distance), load_compensation_before +
        differential_governed_max(-s->load_compensation_step, differential_governed_min(load_compensation_distance,
        s->load_compensation_step)), p->load_compensation);
    s->load_compensation_step = differential_governed_select(s->load_compensation_step <
        differential_governed_abs(load_compensation_distance), s->load_compensation_step, 0.0);
    s->load_compensation_target = p->load_compensation;
    /* acceleration_torque follows its parameter along a ramp */
    const differential_governed_real acceleration_torque_before = s->acceleration_torque_now;
    const differential_governed_real acceleration_torque_distance = p->acceleration_torque -
        acceleration_torque_before;
    if (p->acceleration_torque != s->acceleration_torque_target) {
        s->acceleration_torque_step = differential_governed_max(s->switch_share *
            differential_governed_abs(acceleration_torque_distance), 1e-06 *
            differential_governed_abs(p->acceleration_torque) + 1e-06 *
            differential_governed_abs(acceleration_torque_before));
    }
    s->acceleration_torque_now = differential_governed_select(s->acceleration_torque_step <
        differential_governed_abs(acceleration_torque_distance), acceleration_torque_before +
        differential_governed_max(-s->acceleration_torque_step,
        differential_governed_min(acceleration_torque_distance, s->acceleration_torque_step)),
        p->acceleration_torque);
    s->acceleration_torque_step = differential_governed_select(s->acceleration_torque_step <
        differential_governed_abs(acceleration_torque_distance), s->acceleration_torque_step, 0.0);
    s->acceleration_torque_target = p->acceleration_torque;
    /* M1_damping follows its parameter along a ramp */
    const differential_governed_real M1_damping_before = s->M1_damping_now;
    const differential_governed_real M1_damping_distance = p->M1_damping - M1_damping_before;
    if (p->M1_damping != s->M1_damping_target) {
        s->M1_damping_step = differential_governed_max(s->switch_share * differential_governed_abs(M1_damping_distance),
            1e-06 * differential_governed_abs(p->M1_damping) + 1e-06 * differential_governed_abs(M1_damping_before));
    }
    s->M1_damping_now = differential_governed_select(s->M1_damping_step <
        differential_governed_abs(M1_damping_distance), M1_damping_before +
        differential_governed_max(-s->M1_damping_step, differential_governed_min(M1_damping_distance,
        s->M1_damping_step)), p->M1_damping);
    s->M1_damping_step = differential_governed_select(s->M1_damping_step <
        differential_governed_abs(M1_damping_distance), s->M1_damping_step, 0.0);
    s->M1_damping_target = p->M1_damping;
    /* torque-speed envelope, Figure 7.1 */
    const differential_governed_real M1_available = s->M1_power / differential_governed_max(p->M1_speed_rated,
        differential_governed_abs(s->M1_speed_held));
    const differential_governed_real M1_least = -M1_available * differential_governed_max(0.0,
        differential_governed_min(1.0, s->M1_speed_held * s->M1_taper_slope + s->M1_taper_end));
    const differential_governed_real M1_most = M1_available * differential_governed_max(0.0,
        differential_governed_min(1.0, -s->M1_speed_held * s->M1_taper_slope + s->M1_taper_end));
    const differential_governed_real M2_available = s->M2_power / differential_governed_max(p->M2_speed_rated,
        differential_governed_abs(s->M2_speed_held));
    const differential_governed_real M2_least = -M2_available * differential_governed_max(0.0,
        differential_governed_min(1.0, s->M2_speed_held * s->M2_taper_slope + s->M2_taper_end));
    const differential_governed_real M2_most = M2_available * differential_governed_max(0.0,
        differential_governed_min(1.0, -s->M2_speed_held * s->M2_taper_slope + s->M2_taper_end));
    const differential_governed_real M3_available = s->M3_power / differential_governed_max(p->M3_speed_rated,
        differential_governed_abs(s->M3_speed_held));
    const differential_governed_real M3_least = -M3_available * differential_governed_max(0.0,
        differential_governed_min(1.0, s->M3_speed_held * s->M3_taper_slope + s->M3_taper_end));
    const differential_governed_real M3_most = M3_available * differential_governed_max(0.0,
        differential_governed_min(1.0, -s->M3_speed_held * s->M3_taper_slope + s->M3_taper_end));
    /* torque commands of the step before */
    const differential_governed_real M1_applied = s->M1_last * s->authority;
    const differential_governed_real M2_applied = s->M2_last * s->authority;
    const differential_governed_real M3_applied = s->M3_last * s->authority;
    /* speed from the torques on the rotor */
    const differential_governed_real M1_integrated_before = s->M1_integrated;
    s->M1_integrated = M1_integrated_before + s->M1_per_step * (M1_applied - s->flange1_torque_held) +
        s->disagreement_share * (-M1_integrated_before + s->M1_speed_held);
    const differential_governed_real M1_difference = differential_governed_abs(s->M1_integrated - s->M1_speed_held);
    /* speed against torques */
    const differential_governed_real M1_agrees = differential_governed_select(M1_difference <=
        p->M1_disagreement_limit, 1.0, 0.0);
    differential_governed_lasting(M1_agrees, s->M1_disagreement_time, p->sample_time, p->hold_time,
        &s->M1_disagreement_time);
    /* M1_speed to the last bit */
    differential_governed_still(s->M1_speed_held, s->M1_speed_before, s->M1_speed_still_time, p->sample_time,
        &s->M1_speed_still_time);
    s->M1_speed_before = s->M1_speed_held;
    /* flange1_torque to the last bit */
    differential_governed_still(s->flange1_torque_held, s->flange1_torque_before, s->flange1_torque_still_time,
        p->sample_time, &s->flange1_torque_still_time);
    s->flange1_torque_before = s->flange1_torque_held;
    s->flange1_torque_command = differential_governed_select(s->flange1_torque_still_time > 0.0,
        s->flange1_torque_command, M1_applied);
    /* speed from the torques on the rotor */
    const differential_governed_real M2_integrated_before = s->M2_integrated;
    s->M2_integrated = M2_integrated_before + s->M2_per_step * (M2_applied + s->flange2_torque_held) +
        s->disagreement_share * (-M2_integrated_before + s->M2_speed_held);
    const differential_governed_real M2_difference = differential_governed_abs(s->M2_integrated - s->M2_speed_held);
    /* speed against torques */
    const differential_governed_real M2_agrees = differential_governed_select(M2_difference <=
        p->M2_disagreement_limit, 1.0, 0.0);
    differential_governed_lasting(M2_agrees, s->M2_disagreement_time, p->sample_time, p->hold_time,
        &s->M2_disagreement_time);
    /* M2_speed to the last bit */
    differential_governed_still(s->M2_speed_held, s->M2_speed_before, s->M2_speed_still_time, p->sample_time,
        &s->M2_speed_still_time);
    s->M2_speed_before = s->M2_speed_held;
    /* flange2_torque to the last bit */
    differential_governed_still(s->flange2_torque_held, s->flange2_torque_before, s->flange2_torque_still_time,
        p->sample_time, &s->flange2_torque_still_time);
    s->flange2_torque_before = s->flange2_torque_held;
    s->flange2_torque_command = differential_governed_select(s->flange2_torque_still_time > 0.0,
        s->flange2_torque_command, M2_applied);
    /* speed from the torques on the rotor */
    const differential_governed_real M3_integrated_before = s->M3_integrated;
    s->M3_integrated = M3_integrated_before + s->M3_per_step * (M3_applied + s->flange3_torque_held) +
        s->disagreement_share * (-M3_integrated_before + s->M3_speed_held);
    const differential_governed_real M3_difference = differential_governed_abs(s->M3_integrated - s->M3_speed_held);
    /* speed against torques */
    const differential_governed_real M3_agrees = differential_governed_select(M3_difference <=
        p->M3_disagreement_limit, 1.0, 0.0);
    differential_governed_lasting(M3_agrees, s->M3_disagreement_time, p->sample_time, p->hold_time,
        &s->M3_disagreement_time);
    /* M3_speed to the last bit */
    differential_governed_still(s->M3_speed_held, s->M3_speed_before, s->M3_speed_still_time, p->sample_time,
        &s->M3_speed_still_time);
    s->M3_speed_before = s->M3_speed_held;
    /* flange3_torque to the last bit */
    differential_governed_still(s->flange3_torque_held, s->flange3_torque_before, s->flange3_torque_still_time,
        p->sample_time, &s->flange3_torque_still_time);
    s->flange3_torque_before = s->flange3_torque_held;
    s->flange3_torque_command = differential_governed_select(s->flange3_torque_still_time > 0.0,
        s->flange3_torque_command, M3_applied);
    /* oscillation of flange1_torque */
    const differential_governed_real flange1_torque_mean_before = s->flange1_torque_mean;
    const differential_governed_real flange1_torque_swing = s->flange1_torque_held - flange1_torque_mean_before;
    s->flange1_torque_mean = flange1_torque_mean_before + flange1_torque_swing * s->mean_share;
    differential_governed_swings(flange1_torque_swing, p->flange1_torque_oscillation_limit, s->flange1_torque_side,
        s->flange1_torque_swings, s->forgotten_swings, &s->flange1_torque_side, &s->flange1_torque_swings);
    /* oscillation of flange2_torque */
    const differential_governed_real flange2_torque_mean_before = s->flange2_torque_mean;
    const differential_governed_real flange2_torque_swing = s->flange2_torque_held - flange2_torque_mean_before;
    s->flange2_torque_mean = flange2_torque_mean_before + flange2_torque_swing * s->mean_share;
    differential_governed_swings(flange2_torque_swing, p->flange2_torque_oscillation_limit, s->flange2_torque_side,
        s->flange2_torque_swings, s->forgotten_swings, &s->flange2_torque_side, &s->flange2_torque_swings);
    /* oscillation of flange3_torque */
    const differential_governed_real flange3_torque_mean_before = s->flange3_torque_mean;
    const differential_governed_real flange3_torque_swing = s->flange3_torque_held - flange3_torque_mean_before;
    s->flange3_torque_mean = flange3_torque_mean_before + flange3_torque_swing * s->mean_share;
    differential_governed_swings(flange3_torque_swing, p->flange3_torque_oscillation_limit, s->flange3_torque_side,
        s->flange3_torque_swings, s->forgotten_swings, &s->flange3_torque_side, &s->flange3_torque_swings);
    /* oscillation of M1_torque_ref */
    const differential_governed_real M1_torque_ref_mean_before = s->M1_torque_ref_mean;
    const differential_governed_real M1_torque_ref_swing = M1_applied - M1_torque_ref_mean_before;
    s->M1_torque_ref_mean = M1_torque_ref_mean_before + M1_torque_ref_swing * s->mean_share;
    differential_governed_swings(M1_torque_ref_swing, p->M1_torque_ref_oscillation_limit, s->M1_torque_ref_side,
        s->M1_torque_ref_swings, s->forgotten_swings, &s->M1_torque_ref_side, &s->M1_torque_ref_swings);
    /* oscillation of M2_torque_ref */
    const differential_governed_real M2_torque_ref_mean_before = s->M2_torque_ref_mean;
    const differential_governed_real M2_torque_ref_swing = M2_applied - M2_torque_ref_mean_before;
    s->M2_torque_ref_mean = M2_torque_ref_mean_before + M2_torque_ref_swing * s->mean_share;
    differential_governed_swings(M2_torque_ref_swing, p->M2_torque_ref_oscillation_limit, s->M2_torque_ref_side,
        s->M2_torque_ref_swings, s->forgotten_swings, &s->M2_torque_ref_side, &s->M2_torque_ref_swings);
    /* oscillation of M3_torque_ref */
    const differential_governed_real M3_torque_ref_mean_before = s->M3_torque_ref_mean;
    const differential_governed_real M3_torque_ref_swing = M3_applied - M3_torque_ref_mean_before;
    s->M3_torque_ref_mean = M3_torque_ref_mean_before + M3_torque_ref_swing * s->mean_share;
    differential_governed_swings(M3_torque_ref_swing, p->M3_torque_ref_oscillation_limit, s->M3_torque_ref_side,
        s->M3_torque_ref_swings, s->forgotten_swings, &s->M3_torque_ref_side, &s->M3_torque_ref_swings);
    /* the first fault is latched */
    differential_governed_real cause_of_watching = 0.0;
    cause_of_watching = differential_governed_select(s->M3_torque_ref_swings <= 5.5, cause_of_watching, 8003.0);
    cause_of_watching = differential_governed_select(s->M2_torque_ref_swings <= 5.5, cause_of_watching, 8002.0);
    cause_of_watching = differential_governed_select(s->M1_torque_ref_swings <= 5.5, cause_of_watching, 8001.0);
    cause_of_watching = differential_governed_select(s->flange3_torque_swings <= 5.5, cause_of_watching, 6008.0);
    cause_of_watching = differential_governed_select(s->flange2_torque_swings <= 5.5, cause_of_watching, 6006.0);
    cause_of_watching = differential_governed_select(s->flange1_torque_swings <= 5.5, cause_of_watching, 6005.0);
    cause_of_watching = differential_governed_select(s->M3_disagreement_time <= s->bridged_time, cause_of_watching,
        5009.0);
    cause_of_watching = differential_governed_select(s->M2_disagreement_time <= s->bridged_time, cause_of_watching,
        5007.0);
    cause_of_watching = differential_governed_select(s->M1_disagreement_time <= s->bridged_time, cause_of_watching,
        5004.0);
    cause_of_watching = differential_governed_select(M3_difference <= p->M3_frozen_limit || s->M3_speed_still_time
        <= p->frozen_time, cause_of_watching, 3009.0);
    cause_of_watching = differential_governed_select(M3_difference <= p->M3_frozen_limit ||
        s->flange3_torque_still_time <= p->frozen_time || differential_governed_abs(M3_applied -
        s->flange3_torque_command) <= s->M3_moved_torque, cause_of_watching, 3008.0);
    cause_of_watching = differential_governed_select(M2_difference <= p->M2_frozen_limit || s->M2_speed_still_time
        <= p->frozen_time, cause_of_watching, 3007.0);
    cause_of_watching = differential_governed_select(M2_difference <= p->M2_frozen_limit ||
        s->flange2_torque_still_time <= p->frozen_time || differential_governed_abs(M2_applied -
        s->flange2_torque_command) <= s->M2_moved_torque, cause_of_watching, 3006.0);
    cause_of_watching = differential_governed_select(M1_difference <= p->M1_frozen_limit ||
        s->flange1_torque_still_time <= p->frozen_time || differential_governed_abs(M1_applied -
        s->flange1_torque_command) <= s->M1_moved_torque, cause_of_watching, 3005.0);
    cause_of_watching = differential_governed_select(M1_difference <= p->M1_frozen_limit || s->M1_speed_still_time
        <= p->frozen_time, cause_of_watching, 3004.0);
    s->fault = differential_governed_select(s->fault > 0.5, s->fault, cause_of_watching);
    /* limit of the rate */
    const differential_governed_real M2_speed_ref_before = s->M2_speed_ref_limited;
    s->M2_speed_ref_limited = M2_speed_ref_before + differential_governed_max(-s->M2_speed_ref_step,
        differential_governed_min(s->M2_speed_ref_step, -M2_speed_ref_before + s->M2_speed_ref_held));
    const differential_governed_real M3_speed_ref_before = s->M3_speed_ref_limited;
    s->M3_speed_ref_limited = M3_speed_ref_before + differential_governed_max(-s->M3_speed_ref_step,
        differential_governed_min(s->M3_speed_ref_step, -M3_speed_ref_before + s->M3_speed_ref_held));
    /* testing torque while nothing accelerates (5.95), (5.96) */
    const differential_governed_real diff_input_torque_steady = s->flange1_torque_held;
    if (s->running <= 0.5) {
        /* the first step, and the first one after a fault, starts anew */
        s->diff_input_torque_ref_limited = diff_input_torque_steady;
    }
    /* limit of the rate */
    const differential_governed_real diff_input_torque_ref_before = s->diff_input_torque_ref_limited;
    s->diff_input_torque_ref_limited = diff_input_torque_ref_before +
        differential_governed_max(-s->diff_input_torque_ref_step,
        differential_governed_min(s->diff_input_torque_ref_step, -diff_input_torque_ref_before +
        s->diff_input_torque_ref_held));
    if (s->running <= 0.5) {
        /* the first step, and the first one after a fault, starts anew */
        s->M1_model_torque = diff_input_torque_steady;
        s->diff_input_torque_ref_shaped = s->diff_input_torque_ref_limited;
    }
    /* references of the last step */
    const differential_governed_real diff_input_torque_ref_shaped_before = s->diff_input_torque_ref_shaped;
    if (s->running <= 0.5) {
        /* the first step, and the first one after a fault, starts anew */
        s->M2_speed_ref_shaped = s->M2_speed_ref_limited;
    }
    /* references of the last step */
    const differential_governed_real M2_speed_ref_shaped_before = s->M2_speed_ref_shaped;
    if (s->running <= 0.5) {
        /* the first step, and the first one after a fault, starts anew */
        s->M3_speed_ref_shaped = s->M3_speed_ref_limited;
    }
    /* references of the last step */
    const differential_governed_real M3_speed_ref_shaped_before = s->M3_speed_ref_shaped;
    /* limits that the governor keeps (7.30) */
    const differential_governed_real M1_governed_least = differential_governed_max(M1_least * (1.0 -
        p->governor_reserve), -s->M1_damping_now * s->M1_speed_held + s->M1_damping_now * s->M1_twist_M1_M2_speed *
        s->M2_speed_held + s->M1_damping_now * s->M1_twist_M1_M3_speed * s->M3_speed_held + M1_least * (0.99999 -
        0.99999 * p->M1_damping_reserve));
    const differential_governed_real M1_governed_most = differential_governed_min(M1_most * (1.0 -
        p->governor_reserve), -s->M1_damping_now * s->M1_speed_held + s->M1_damping_now * s->M1_twist_M1_M2_speed *
        s->M2_speed_held + s->M1_damping_now * s->M1_twist_M1_M3_speed * s->M3_speed_held + M1_most * (0.99999 -
        0.99999 * p->M1_damping_reserve));
    const differential_governed_real M2_governed_least = M2_least * (1.0 - p->governor_reserve);
    const differential_governed_real M2_governed_most = M2_most * (1.0 - p->governor_reserve);
    const differential_governed_real M3_governed_least = M3_least * (1.0 - p->governor_reserve);
    const differential_governed_real M3_governed_most = M3_most * (1.0 - p->governor_reserve);
    /* stationary limits (7.34), step 1 of Figure 7.4 */
    const differential_governed_real M1_beside = -p->M1_at_rest_diff_input_torque_ref * diff_input_torque_steady +
        s->flange1_torque_held;
    const differential_governed_real M1_room_below = M1_beside - M1_least * (1.0 - p->governor_stationary_reserve) *
        differential_governed_min(1.0 - p->M1_damping_reserve, 1.0 - p->governor_reserve);
    const differential_governed_real M1_room_above = -M1_beside + M1_most * (1.0 - p->governor_stationary_reserve) *
        differential_governed_min(1.0 - p->M1_damping_reserve, 1.0 - p->governor_reserve);
    const differential_governed_real M2_beside = -p->M2_at_rest_diff_input_torque_ref * diff_input_torque_steady -
        s->flange2_torque_held;
    const differential_governed_real M2_room_below = M2_beside - M2_least * (1.0 - p->governor_reserve) * (1.0 -
        p->governor_stationary_reserve);
    const differential_governed_real M2_room_above = -M2_beside + M2_most * (1.0 - p->governor_reserve) * (1.0 -
        p->governor_stationary_reserve);
    const differential_governed_real M3_beside = -p->M3_at_rest_diff_input_torque_ref * diff_input_torque_steady -
        s->flange3_torque_held;
    const differential_governed_real M3_room_below = M3_beside - M3_least * (1.0 - p->governor_reserve) * (1.0 -
        p->governor_stationary_reserve);
    const differential_governed_real M3_room_above = -M3_beside + M3_most * (1.0 - p->governor_reserve) * (1.0 -
        p->governor_stationary_reserve);
    const differential_governed_real diff_input_torque_ref_of_M1_reach = p->M1_at_rest_diff_input_torque_ref *
        s->diff_input_torque_ref_limited;
    const differential_governed_real diff_input_torque_ref_of_M1_room = differential_governed_max(0.0,
        differential_governed_select(diff_input_torque_ref_of_M1_reach > 0.0, M1_room_above, M1_room_below));
    const differential_governed_real diff_input_torque_ref_of_M2_reach = p->M2_at_rest_diff_input_torque_ref *
        s->diff_input_torque_ref_limited;
    const differential_governed_real diff_input_torque_ref_of_M2_room = differential_governed_max(0.0,
        differential_governed_select(diff_input_torque_ref_of_M2_reach > 0.0, M2_room_above, M2_room_below));
    const differential_governed_real diff_input_torque_ref_of_M3_reach = p->M3_at_rest_diff_input_torque_ref *
        s->diff_input_torque_ref_limited;
    const differential_governed_real diff_input_torque_ref_of_M3_room = differential_governed_max(0.0,
        differential_governed_select(diff_input_torque_ref_of_M3_reach > 0.0, M3_room_above, M3_room_below));
    const differential_governed_real diff_input_torque_ref_share_at_rest =
        differential_governed_min(differential_governed_min(1.0, diff_input_torque_ref_of_M1_room /
        differential_governed_max(differential_governed_max(1e-30, diff_input_torque_ref_of_M1_room),
        differential_governed_abs(diff_input_torque_ref_of_M1_reach))),
        differential_governed_min(diff_input_torque_ref_of_M2_room /
        differential_governed_max(differential_governed_max(1e-30, diff_input_torque_ref_of_M2_room),
        differential_governed_abs(diff_input_torque_ref_of_M2_reach)), diff_input_torque_ref_of_M3_room /
        differential_governed_max(differential_governed_max(1e-30, diff_input_torque_ref_of_M3_room),
        differential_governed_abs(diff_input_torque_ref_of_M3_reach))));
    const differential_governed_real diff_input_torque_ref_within = s->diff_input_torque_ref_limited *
        diff_input_torque_ref_share_at_rest;
    /* largest speeds, steps 2 and 3 of Figure 7.4 */
    const differential_governed_real M2_speed_ref_within = differential_governed_max(-s->M2_governed_speed,
        differential_governed_min(s->M2_governed_speed, s->M2_speed_ref_limited));
    const differential_governed_real M3_speed_ref_within = differential_governed_max(-s->M3_governed_speed,
        differential_governed_min(s->M3_governed_speed, s->M3_speed_ref_limited));
    /* what the governor works with */
    governor_wanted[0] = diff_input_torque_ref_within;
    governor_wanted[1] = M2_speed_ref_within;
    governor_wanted[2] = M3_speed_ref_within;
    governor_before[0] = diff_input_torque_ref_shaped_before;
    governor_before[1] = M2_speed_ref_shaped_before;
    governor_before[2] = M3_speed_ref_shaped_before;
    governor_least[0] = M1_governed_least;
    governor_least[1] = M2_governed_least;
    governor_least[2] = M3_governed_least;
    governor_most[0] = M1_governed_most;
    governor_most[1] = M2_governed_most;
    governor_most[2] = M3_governed_most;
    /* commands without limits (7.42) */
    const differential_governed_real M2_unchanged = p->M2_speed_gain * (-s->M2_speed_held +
        M2_speed_ref_shaped_before) + s->M2_speed_integral - s->flange2_torque_held * s->load_compensation_now +
        differential_governed_select(p->M2_speed_integral_gain > 0.0, -s->flange2_torque_held *
        (load_compensation_before - s->load_compensation_now), 0.0);
    const differential_governed_real M3_unchanged = p->M3_speed_gain * (-s->M3_speed_held +
        M3_speed_ref_shaped_before) + s->M3_speed_integral - s->flange3_torque_held * s->load_compensation_now +
        differential_governed_select(p->M3_speed_integral_gain > 0.0, -s->flange3_torque_held *
        (load_compensation_before - s->load_compensation_now), 0.0);
    const differential_governed_real M1_unchanged = s->M1_damping_now * (-s->M1_speed_held + s->M1_twist_M1_M2_speed
        * s->M2_speed_held + s->M1_twist_M1_M3_speed * s->M3_speed_held) + p->M1_feedforward *
        diff_input_torque_ref_shaped_before + p->M1_torque_gain * (p->M1_torque_model * (s->M1_model_torque +
        p->sample_time * (-s->M1_model_drag * s->M1_model_rate + s->M1_model_pull * (-s->M1_model_torque +
        diff_input_torque_ref_shaped_before) + s->M1_model_rate)) - s->M1_unread_M2 * (M2_unchanged +
        s->flange2_torque_held) - s->M1_unread_M3 * (M3_unchanged + s->flange3_torque_held) +
        diff_input_torque_ref_shaped_before * (1.0 - p->M1_torque_model) - diff_input_torque_steady) +
        s->M1_torque_integral + s->acceleration_torque_now * (s->M1_with_M2 * (M2_unchanged +
        s->flange2_torque_held) + s->M1_with_M3 * (M3_unchanged + s->flange3_torque_held));
    governor_free[0] = M1_unchanged;
    governor_free[1] = M2_unchanged;
    governor_free[2] = M3_unchanged;
    governor_gain[0][0] = s->M1_follows_M1;
    governor_gain[1][0] = p->M2_speed_gain * (-p->M1_torque_gain * s->M1_unread_M2 + s->M1_with_M2 *
        s->acceleration_torque_now);
    governor_gain[2][0] = p->M3_speed_gain * (-p->M1_torque_gain * s->M1_unread_M3 + s->M1_with_M3 *
        s->acceleration_torque_now);
    governor_gain[1][1] = p->M2_speed_gain;
    governor_gain[2][2] = p->M3_speed_gain;
    /* sequential governor (7.37)-(7.43) */
    governor_room[0] = p->torque_reserve;
    governor_rate[0] = s->torque_step_min;
    const differential_governed_real governor_modified = differential_governed_select(p->governor > 1.5, 1.0, 0.0);
    differential_governed_sequential_governor(governor_wanted, governor_before, governor_free, &governor_gain[0][0],
        governor_least, governor_most, governor_room, governor_rate, p->governor_tie, governor_modified,
        governor_groups, governor_sequential);
    /* shaped references (7.13) */
    const differential_governed_real diff_input_torque_ref_shaped_target = s->diff_input_torque_ref_limited;
    const differential_governed_real diff_input_torque_ref_shaped_distance = -diff_input_torque_ref_shaped_before +
        diff_input_torque_ref_shaped_target;
    const differential_governed_real diff_input_torque_ref_shaped_proposed =
        differential_governed_select(p->governor > 0.5, governor_sequential[0],
        differential_governed_select(differential_governed_abs(diff_input_torque_ref_shaped_distance) > 2.0 *
        s->diff_input_torque_ref_step, diff_input_torque_ref_shaped_before + differential_governed_max(-2.0 *
        s->diff_input_torque_ref_step, differential_governed_min(diff_input_torque_ref_shaped_distance, 2.0 *
        s->diff_input_torque_ref_step)), diff_input_torque_ref_shaped_target));
    differential_governed_real diff_input_torque_ref_shaped_sound;
    differential_governed_guard(diff_input_torque_ref_shaped_proposed, s->governor_finite,
        diff_input_torque_ref_shaped_target, &s->diff_input_torque_ref_shaped, &diff_input_torque_ref_shaped_sound);
    const differential_governed_real M2_speed_ref_shaped_target = s->M2_speed_ref_limited;
    const differential_governed_real M2_speed_ref_shaped_distance = -M2_speed_ref_shaped_before +
        M2_speed_ref_shaped_target;
    const differential_governed_real M2_speed_ref_shaped_proposed = differential_governed_select(p->governor > 0.5,
        governor_sequential[1], differential_governed_select(differential_governed_abs(M2_speed_ref_shaped_distance)
        > 2.0 * s->M2_speed_ref_step, M2_speed_ref_shaped_before + differential_governed_max(-2.0 *
        s->M2_speed_ref_step, differential_governed_min(M2_speed_ref_shaped_distance, 2.0 * s->M2_speed_ref_step)),
        M2_speed_ref_shaped_target));
    differential_governed_real M2_speed_ref_shaped_sound;
    differential_governed_guard(M2_speed_ref_shaped_proposed, s->governor_finite, M2_speed_ref_shaped_target,
        &s->M2_speed_ref_shaped, &M2_speed_ref_shaped_sound);
    const differential_governed_real M3_speed_ref_shaped_target = s->M3_speed_ref_limited;
    const differential_governed_real M3_speed_ref_shaped_distance = -M3_speed_ref_shaped_before +
        M3_speed_ref_shaped_target;
    const differential_governed_real M3_speed_ref_shaped_proposed = differential_governed_select(p->governor > 0.5,
        governor_sequential[2], differential_governed_select(differential_governed_abs(M3_speed_ref_shaped_distance)
        > 2.0 * s->M3_speed_ref_step, M3_speed_ref_shaped_before + differential_governed_max(-2.0 *
        s->M3_speed_ref_step, differential_governed_min(M3_speed_ref_shaped_distance, 2.0 * s->M3_speed_ref_step)),
        M3_speed_ref_shaped_target));
    differential_governed_real M3_speed_ref_shaped_sound;
    differential_governed_guard(M3_speed_ref_shaped_proposed, s->governor_finite, M3_speed_ref_shaped_target,
        &s->M3_speed_ref_shaped, &M3_speed_ref_shaped_sound);
    /* status of the governor */
    governor_change[0] = s->diff_input_torque_ref_shaped - diff_input_torque_ref_shaped_before;
    governor_change[1] = s->M2_speed_ref_shaped - M2_speed_ref_shaped_before;
    governor_change[2] = s->M3_speed_ref_shaped - M3_speed_ref_shaped_before;
    differential_governed_multiply(3, 3, &governor_gain[0][0], governor_change, governor_response);
    const differential_governed_real M1_governed = governor_free[0] + governor_response[0];
    s->governor_slack_M1 = differential_governed_select(differential_governed_max(differential_governed_max(0.0,
        -M1_governed + governor_least[0]), M1_governed - governor_most[0]) > -1e-05 * M1_least + 1e-05 * M1_most,
        differential_governed_max(differential_governed_max(0.0, -M1_governed + governor_least[0]), M1_governed -
        governor_most[0]), 0.0);
    const differential_governed_real M2_governed = governor_free[1] + governor_response[1];
    s->governor_slack_M2 = differential_governed_select(differential_governed_max(differential_governed_max(0.0,
        -M2_governed + governor_least[1]), M2_governed - governor_most[1]) > -1e-05 * M2_least + 1e-05 * M2_most,
        differential_governed_max(differential_governed_max(0.0, -M2_governed + governor_least[1]), M2_governed -
        governor_most[1]), 0.0);
    const differential_governed_real M3_governed = governor_free[2] + governor_response[2];
    s->governor_slack_M3 = differential_governed_select(differential_governed_max(differential_governed_max(0.0,
        -M3_governed + governor_least[2]), M3_governed - governor_most[2]) > -1e-05 * M3_least + 1e-05 * M3_most,
        differential_governed_max(differential_governed_max(0.0, -M3_governed + governor_least[2]), M3_governed -
        governor_most[2]), 0.0);
    s->governor_iterations = 0.0;
    s->governor_status = differential_governed_select(p->governor > 0.5,
        differential_governed_select(differential_governed_max(differential_governed_max(0.0, s->governor_slack_M1),
        differential_governed_max(s->governor_slack_M2, s->governor_slack_M3)) > 0.0, 2.0,
        differential_governed_select(s->M2_speed_ref_shaped != M2_speed_ref_shaped_target || s->M3_speed_ref_shaped
        != M3_speed_ref_shaped_target || s->diff_input_torque_ref_shaped != diff_input_torque_ref_shaped_target,
        1.0, 0.0)), 0.0);
    const differential_governed_real M2_speed_error = -s->M2_speed_held + s->M2_speed_ref_shaped;
    /* load torque compensation (5.52), (5.74) */
    const differential_governed_real M2_compensation = -s->flange2_torque_held;
    /* so that a switch does not jump */
    const differential_governed_real M2_given_away = M2_compensation * (load_compensation_before -
        s->load_compensation_now);
    /* PI speed control (5.84) */
    const differential_governed_real M2_integral_before = s->M2_speed_integral +
        differential_governed_select(p->M2_speed_integral_gain > 0.0, M2_given_away, 0.0);
    const differential_governed_real M2_asked = M2_integral_before + M2_speed_error * p->M2_speed_gain;
    const differential_governed_real M2_wanted = M2_asked + M2_compensation * s->load_compensation_now;
    /* torque-speed envelope */
    const differential_governed_real M2_command = differential_governed_max(M2_least,
        differential_governed_min(M2_most, M2_wanted));
    /* what the limit cuts off */
    const differential_governed_real M2_cut = M2_command - M2_wanted;
    /* conditioning anti-windup (Hanus) */
    s->M2_speed_integral = M2_cut * s->M2_speed_conditioning + M2_integral_before + M2_speed_error *
        s->M2_speed_growth;
    /* net torque on the rotor */
    const differential_governed_real M2_net = M2_command - M2_compensation;
    const differential_governed_real M3_speed_error = -s->M3_speed_held + s->M3_speed_ref_shaped;
    /* load torque compensation (5.52), (5.74) */
    const differential_governed_real M3_compensation = -s->flange3_torque_held;
    /* so that a switch does not jump */
    const differential_governed_real M3_given_away = M3_compensation * (load_compensation_before -
        s->load_compensation_now);
    /* PI speed control (5.84) */
    const differential_governed_real M3_integral_before = s->M3_speed_integral +
        differential_governed_select(p->M3_speed_integral_gain > 0.0, M3_given_away, 0.0);
    const differential_governed_real M3_asked = M3_integral_before + M3_speed_error * p->M3_speed_gain;
    const differential_governed_real M3_wanted = M3_asked + M3_compensation * s->load_compensation_now;
    /* torque-speed envelope */
    const differential_governed_real M3_command = differential_governed_max(M3_least,
        differential_governed_min(M3_most, M3_wanted));
    /* what the limit cuts off */
    const differential_governed_real M3_cut = M3_command - M3_wanted;
    /* conditioning anti-windup (Hanus) */
    s->M3_speed_integral = M3_cut * s->M3_speed_conditioning + M3_integral_before + M3_speed_error *
        s->M3_speed_growth;
    /* net torque on the rotor */
    const differential_governed_real M3_net = M3_command - M3_compensation;
    /* testing torque from the sensors (5.95), (5.96), (5.98) */
    const differential_governed_real diff_input_torque_estimate = s->M1_unread_M2 * M2_net + s->M1_unread_M3 *
        M3_net + diff_input_torque_steady;
    /* torque model (5.57), (5.76) */
    const differential_governed_real M1_model_before = s->M1_model_torque;
    const differential_governed_real M1_rate_before = s->M1_model_rate;
    s->M1_model_rate = -s->M1_model_drag * M1_rate_before + s->M1_model_pull * (-M1_model_before +
        s->diff_input_torque_ref_shaped) + M1_rate_before;
    s->M1_model_torque = M1_model_before + s->M1_model_rate * p->sample_time;
    const differential_governed_real M1_torque_error = s->M1_model_torque * p->M1_torque_model -
        diff_input_torque_estimate + s->diff_input_torque_ref_shaped * (1.0 - p->M1_torque_model);
    /* torque control (5.99) */
    const differential_governed_real M1_integral_before = s->M1_torque_integral;
    const differential_governed_real M1_virtual = p->M1_feedforward * s->diff_input_torque_ref_shaped +
        M1_integral_before + M1_torque_error * p->M1_torque_gain;
    /* active damping (5.62), (5.78) */
    const differential_governed_real M1_twist_rate_M1 = -s->M1_speed_held + s->M1_twist_M1_M2_speed *
        s->M2_speed_held + s->M1_twist_M1_M3_speed * s->M3_speed_held;
    const differential_governed_real M1_damping_torque = s->M1_damping_now * M1_twist_rate_M1;
    /* with the acceleration torque (5.62), (5.78) */
    const differential_governed_real M1_wanted = M1_virtual + s->acceleration_torque_now * (s->M1_with_M2 * M2_net +
        s->M1_with_M3 * M3_net);
    /* reserve for active damping */
    const differential_governed_real M1_kept = differential_governed_max(M1_least * (1.0 - p->M1_damping_reserve),
        differential_governed_min(M1_wanted, M1_most * (1.0 - p->M1_damping_reserve)));
    /* torque-speed envelope */
    const differential_governed_real M1_command = differential_governed_max(M1_least,
        differential_governed_min(M1_most, M1_damping_torque + M1_kept));
    /* limited integrator */
    s->M1_torque_integral = differential_governed_select(M1_torque_error * (-M1_kept + M1_wanted) > 0.0,
        M1_integral_before, differential_governed_max(-p->M1_torque_integral_limit,
        differential_governed_min(p->M1_torque_integral_limit, M1_integral_before + M1_torque_error *
        s->M1_torque_growth)));
    /* only sound torques leave */
    differential_governed_real M1_released;
    differential_governed_real M1_released_sound;
    differential_governed_guard(M1_command, s->M1_largest, s->M1_last, &M1_released, &M1_released_sound);
    differential_governed_real M2_released;
    differential_governed_real M2_released_sound;
    differential_governed_guard(M2_command, s->M2_largest, s->M2_last, &M2_released, &M2_released_sound);
    differential_governed_real M3_released;
    differential_governed_real M3_released_sound;
    differential_governed_guard(M3_command, s->M3_largest, s->M3_last, &M3_released, &M3_released_sound);
    /* the first fault is latched */
    differential_governed_real cause_of_commands = 0.0;
    cause_of_commands = differential_governed_select(M3_released_sound > 0.5, cause_of_commands, 7003.0);
    cause_of_commands = differential_governed_select(M2_released_sound > 0.5, cause_of_commands, 7002.0);
    cause_of_commands = differential_governed_select(M1_released_sound > 0.5, cause_of_commands, 7001.0);
    s->fault = differential_governed_select(s->fault > 0.5, s->fault, cause_of_commands);
    /* ramp of the torques */
    const differential_governed_real authority_wanted = s->authority + differential_governed_select(s->fault > 0.5,
        -s->ramp_step, s->ramp_step);
    differential_governed_share(authority_wanted, &s->authority);
    s->running = differential_governed_select(s->fault > 0.5, 0.0, 1.0);
    if (s->fault <= 0.5) {
        s->M1_last = M1_released;
    }
    /* the torque of before */
    const differential_governed_real M1_calmer = s->M1_calm + s->calm_share * (-s->M1_calm + s->M1_last);
    differential_governed_real M1_calm_sound;
    differential_governed_guard(M1_calmer, s->M1_largest, s->M1_calm, &s->M1_calm, &M1_calm_sound);
    if (s->fault > 2999.5) {
        s->M1_last = s->M1_calm;
    }
    if (s->fault <= 0.5) {
        /* ramp of the torques */
        s->M2_last = M2_released;
    }
    /* the torque of before */
    const differential_governed_real M2_calmer = s->M2_calm + s->calm_share * (-s->M2_calm + s->M2_last);
    differential_governed_real M2_calm_sound;
    differential_governed_guard(M2_calmer, s->M2_largest, s->M2_calm, &s->M2_calm, &M2_calm_sound);
    if (s->fault > 2999.5) {
        s->M2_last = s->M2_calm;
    }
    if (s->fault <= 0.5) {
        /* ramp of the torques */
        s->M3_last = M3_released;
    }
    /* the torque of before */
    const differential_governed_real M3_calmer = s->M3_calm + s->calm_share * (-s->M3_calm + s->M3_last);
    differential_governed_real M3_calm_sound;
    differential_governed_guard(M3_calmer, s->M3_largest, s->M3_calm, &s->M3_calm, &M3_calm_sound);
    if (s->fault > 2999.5) {
        s->M3_last = s->M3_calm;
    }
    out->M1_torque_ref = differential_governed_max(-930.0, differential_governed_min(930.0, s->M1_last *
        s->authority));
    out->M2_torque_ref = differential_governed_max(-3700.0, differential_governed_min(3700.0, s->M2_last *
        s->authority));
    out->M3_torque_ref = differential_governed_max(-3700.0, differential_governed_min(3700.0, s->M3_last *
        s->authority));
    /* The last line of defence, should parameters have been changed without an update. */
    if (!differential_governed_is_finite(out->M1_torque_ref + out->M2_torque_ref + out->M3_torque_ref)) {
        if (!differential_governed_is_finite(out->M1_torque_ref)) {
            out->M1_torque_ref = 0.0;
            s->fault = s->fault > 0.0 ? s->fault : DIFFERENTIAL_GOVERNED_REAL(differential_governed_controller_fault_M1_torque_ref);
            s->running = 0.0;
        }
        if (!differential_governed_is_finite(out->M2_torque_ref)) {
            out->M2_torque_ref = 0.0;
            s->fault = s->fault > 0.0 ? s->fault : DIFFERENTIAL_GOVERNED_REAL(differential_governed_controller_fault_M2_torque_ref);
            s->running = 0.0;
        }
        if (!differential_governed_is_finite(out->M3_torque_ref)) {
            out->M3_torque_ref = 0.0;
            s->fault = s->fault > 0.0 ? s->fault : DIFFERENTIAL_GOVERNED_REAL(differential_governed_controller_fault_M3_torque_ref);
            s->running = 0.0;
        }
    }
    return (differential_governed_controller_status)s->fault;
}
