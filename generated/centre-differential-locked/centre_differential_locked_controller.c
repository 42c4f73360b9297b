/*
 * centre_differential_locked_controller.c: controller of the bed centre_differential_locked
 *
 * Emitted by ptgen 0.1.0 from centre-differential-locked.toml (SHA-256 853679bdb0920a51), template block.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "centre_differential_locked_controller.h"

#include <float.h>
#include <string.h>

const centre_differential_locked_controller_params centre_differential_locked_controller_defaults = {
    .sample_time = 0.0001,
    .fault_ramp = 0.05,
    .hold_time = 0.001,
    .flange2_torque_ref_plausible = 6000.0,
    .flange3_torque_ref_plausible = 6000.0,
    .M1_speed_ref_plausible = 1413.716694115407,
    .M1_speed_plausible = 1413.716694115407,
    .flange1_torque_plausible = 5190.0,
    .flange2_torque_plausible = 6000.0,
    .M2_speed_plausible = 942.4777960769385,
    .flange3_torque_plausible = 6000.0,
    .M3_speed_plausible = 942.4777960769385,
    .M1_overspeed = 1037.0,
    .M2_overspeed = 691.2,
    .M3_overspeed = 691.2,
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
    .disagreement_leak = 5.0,
    .M1_inertia = 1.0,
    .M1_disagreement_limit = 37.2,
    .M1_frozen_limit = 9.3,
    .frozen_time = 0.01,
    .M2_inertia = 1.9,
    .M2_disagreement_limit = 25.3,
    .M2_frozen_limit = 6.33,
    .M3_inertia = 1.9,
    .M3_disagreement_limit = 25.3,
    .M3_frozen_limit = 6.33,
    .oscillation_frequency = 5.47,
    .flange1_torque_oscillation_limit = 930.0,
    .flange2_torque_oscillation_limit = 1200.0,
    .flange3_torque_oscillation_limit = 1200.0,
    .M1_torque_ref_oscillation_limit = 465.0,
    .M2_torque_ref_oscillation_limit = 600.0,
    .M3_torque_ref_oscillation_limit = 600.0,
    .M1_speed_ref_rate = 930.0,
    .flange2_torque_ref_rate = 84823.7,
    .flange3_torque_ref_rate = 72060.4,
    .M1_speed_gain = 15.0,
    .M1_speed_integral_gain = 56.25,
    .M2_sensor_inertia_M1 = 0.0,
    .M2_inertia_estimate = 1.9,
    .M2_feedforward = 1.0,
    .M2_torque_gain = 0.0,
    .M2_model_stiffness = 9493.47,
    .M2_model_damping = 134.304,
    .M2_torque_model = 1.0,
    .M3_sensor_inertia_M1 = 0.0,
    .M3_inertia_estimate = 1.9,
    .M3_feedforward = 1.0,
    .M3_torque_gain = 0.0,
    .M3_model_stiffness = 6851.48,
    .M3_model_damping = 114.096,
    .M3_torque_model = 1.0,
    .diff_ratio = 1.0,
    .M2_M3_equivalent_stiffness = -1279.2804526283935,
    .M2_equivalent_stiffness = 9493.474505177111,
    .M3_equivalent_stiffness = 6851.482266053254,
    .M2_torque_integral_gain = 10.0,
    .M2_damping_reserve = 0.1,
    .M2_torque_integral_limit = 585.0,
    .M3_torque_integral_gain = 10.0,
    .M3_damping_reserve = 0.1,
    .M3_torque_integral_limit = 585.0,
};

const centre_differential_locked_controller_params centre_differential_locked_controller_conventional = {
    .sample_time = 0.0001,
    .fault_ramp = 0.05,
    .hold_time = 0.001,
    .flange2_torque_ref_plausible = 6000.0,
    .flange3_torque_ref_plausible = 6000.0,
    .M1_speed_ref_plausible = 1413.716694115407,
    .M1_speed_plausible = 1413.716694115407,
    .flange1_torque_plausible = 5190.0,
    .flange2_torque_plausible = 6000.0,
    .M2_speed_plausible = 942.4777960769385,
    .flange3_torque_plausible = 6000.0,
    .M3_speed_plausible = 942.4777960769385,
    .M1_overspeed = 1037.0,
    .M2_overspeed = 691.2,
    .M3_overspeed = 691.2,
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
    .disagreement_leak = 5.0,
    .M1_inertia = 1.0,
    .M1_disagreement_limit = 37.2,
    .M1_frozen_limit = 9.3,
    .frozen_time = 0.01,
    .M2_inertia = 1.9,
    .M2_disagreement_limit = 25.3,
    .M2_frozen_limit = 6.33,
    .M3_inertia = 1.9,
    .M3_disagreement_limit = 25.3,
    .M3_frozen_limit = 6.33,
    .oscillation_frequency = 5.47,
    .flange1_torque_oscillation_limit = 930.0,
    .flange2_torque_oscillation_limit = 1200.0,
    .flange3_torque_oscillation_limit = 1200.0,
    .M1_torque_ref_oscillation_limit = 465.0,
    .M2_torque_ref_oscillation_limit = 600.0,
    .M3_torque_ref_oscillation_limit = 600.0,
    .M1_speed_ref_rate = 930.0,
    .flange2_torque_ref_rate = 84823.7,
    .flange3_torque_ref_rate = 72060.4,
    .M1_speed_gain = 15.0,
    .M1_speed_integral_gain = 56.25,
    .M2_sensor_inertia_M1 = 0.0,
    .M2_inertia_estimate = 1.9,
    .M2_feedforward = 1.0,
    .M2_torque_gain = 0.0,
    .M2_model_stiffness = 9493.47,
    .M2_model_damping = 134.304,
    .M2_torque_model = 0.0,
    .M3_sensor_inertia_M1 = 0.0,
    .M3_inertia_estimate = 1.9,
    .M3_feedforward = 1.0,
    .M3_torque_gain = 0.0,
    .M3_model_stiffness = 6851.48,
    .M3_model_damping = 114.096,
    .M3_torque_model = 0.0,
    .diff_ratio = 1.0,
    .M2_M3_equivalent_stiffness = -1279.2804526283935,
    .M2_equivalent_stiffness = 9493.474505177111,
    .M3_equivalent_stiffness = 6851.482266053254,
    .M2_torque_integral_gain = 0.250545,
    .M2_damping_reserve = 0.1,
    .M2_torque_integral_limit = 585.0,
    .M3_torque_integral_gain = 0.250545,
    .M3_damping_reserve = 0.1,
    .M3_torque_integral_limit = 585.0,
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
    { "the parameter sample_time is outside its range", offsetof(centre_differential_locked_controller_params, sample_time), 0.0, DBL_MAX, 1, 0 },
    { "the parameter fault_ramp is outside its range", offsetof(centre_differential_locked_controller_params, fault_ramp), 0.0, DBL_MAX, 1, 0 },
    { "the parameter hold_time is outside its range", offsetof(centre_differential_locked_controller_params, hold_time), 0.0, DBL_MAX, 0, 0 },
    { "the parameter flange2_torque_ref_plausible is outside its range", offsetof(centre_differential_locked_controller_params, flange2_torque_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_torque_ref_plausible is outside its range", offsetof(centre_differential_locked_controller_params, flange3_torque_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_ref_plausible is outside its range", offsetof(centre_differential_locked_controller_params, M1_speed_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_plausible is outside its range", offsetof(centre_differential_locked_controller_params, M1_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_torque_plausible is outside its range", offsetof(centre_differential_locked_controller_params, flange1_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_torque_plausible is outside its range", offsetof(centre_differential_locked_controller_params, flange2_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_plausible is outside its range", offsetof(centre_differential_locked_controller_params, M2_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_torque_plausible is outside its range", offsetof(centre_differential_locked_controller_params, flange3_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_plausible is outside its range", offsetof(centre_differential_locked_controller_params, M3_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_overspeed is outside its range", offsetof(centre_differential_locked_controller_params, M1_overspeed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_overspeed is outside its range", offsetof(centre_differential_locked_controller_params, M2_overspeed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_overspeed is outside its range", offsetof(centre_differential_locked_controller_params, M3_overspeed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter load_compensation is outside its range", offsetof(centre_differential_locked_controller_params, load_compensation), 0.0, 1.0, 0, 0 },
    { "the parameter acceleration_torque is outside its range", offsetof(centre_differential_locked_controller_params, acceleration_torque), 0.0, 1.0, 0, 0 },
    { "the parameter switch_time is outside its range", offsetof(centre_differential_locked_controller_params, switch_time), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_damping is outside its range", offsetof(centre_differential_locked_controller_params, M2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M3_damping is outside its range", offsetof(centre_differential_locked_controller_params, M3_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_speed_rated is outside its range", offsetof(centre_differential_locked_controller_params, M1_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_max is outside its range", offsetof(centre_differential_locked_controller_params, M1_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_taper is outside its range", offsetof(centre_differential_locked_controller_params, M1_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_max is outside its range", offsetof(centre_differential_locked_controller_params, M1_torque_max), 0.0, 930.0, 1, 0 },
    { "the parameter M2_speed_rated is outside its range", offsetof(centre_differential_locked_controller_params, M2_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_max is outside its range", offsetof(centre_differential_locked_controller_params, M2_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_taper is outside its range", offsetof(centre_differential_locked_controller_params, M2_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_max is outside its range", offsetof(centre_differential_locked_controller_params, M2_torque_max), 0.0, 1200.0, 1, 0 },
    { "the parameter M3_speed_rated is outside its range", offsetof(centre_differential_locked_controller_params, M3_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_max is outside its range", offsetof(centre_differential_locked_controller_params, M3_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_taper is outside its range", offsetof(centre_differential_locked_controller_params, M3_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_torque_max is outside its range", offsetof(centre_differential_locked_controller_params, M3_torque_max), 0.0, 1200.0, 1, 0 },
    { "the parameter disagreement_leak is outside its range", offsetof(centre_differential_locked_controller_params, disagreement_leak), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_inertia is outside its range", offsetof(centre_differential_locked_controller_params, M1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_disagreement_limit is outside its range", offsetof(centre_differential_locked_controller_params, M1_disagreement_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_frozen_limit is outside its range", offsetof(centre_differential_locked_controller_params, M1_frozen_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter frozen_time is outside its range", offsetof(centre_differential_locked_controller_params, frozen_time), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_inertia is outside its range", offsetof(centre_differential_locked_controller_params, M2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_disagreement_limit is outside its range", offsetof(centre_differential_locked_controller_params, M2_disagreement_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_frozen_limit is outside its range", offsetof(centre_differential_locked_controller_params, M2_frozen_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_inertia is outside its range", offsetof(centre_differential_locked_controller_params, M3_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_disagreement_limit is outside its range", offsetof(centre_differential_locked_controller_params, M3_disagreement_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_frozen_limit is outside its range", offsetof(centre_differential_locked_controller_params, M3_frozen_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter oscillation_frequency is outside its range", offsetof(centre_differential_locked_controller_params, oscillation_frequency), 0.0, DBL_MAX, 0, 0 },
    { "the parameter flange1_torque_oscillation_limit is outside its range", offsetof(centre_differential_locked_controller_params, flange1_torque_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_torque_oscillation_limit is outside its range", offsetof(centre_differential_locked_controller_params, flange2_torque_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_torque_oscillation_limit is outside its range", offsetof(centre_differential_locked_controller_params, flange3_torque_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_ref_oscillation_limit is outside its range", offsetof(centre_differential_locked_controller_params, M1_torque_ref_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_ref_oscillation_limit is outside its range", offsetof(centre_differential_locked_controller_params, M2_torque_ref_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_torque_ref_oscillation_limit is outside its range", offsetof(centre_differential_locked_controller_params, M3_torque_ref_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_ref_rate is outside its range", offsetof(centre_differential_locked_controller_params, M1_speed_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_torque_ref_rate is outside its range", offsetof(centre_differential_locked_controller_params, flange2_torque_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_torque_ref_rate is outside its range", offsetof(centre_differential_locked_controller_params, flange3_torque_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_gain is outside its range", offsetof(centre_differential_locked_controller_params, M1_speed_gain), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_integral_gain is outside its range", offsetof(centre_differential_locked_controller_params, M1_speed_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_sensor_inertia_M1 is outside its range", offsetof(centre_differential_locked_controller_params, M2_sensor_inertia_M1), -DBL_MAX, DBL_MAX, 0, 0 },
    { "the parameter M2_inertia_estimate is outside its range", offsetof(centre_differential_locked_controller_params, M2_inertia_estimate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_feedforward is outside its range", offsetof(centre_differential_locked_controller_params, M2_feedforward), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_torque_gain is outside its range", offsetof(centre_differential_locked_controller_params, M2_torque_gain), -1.0, DBL_MAX, 1, 0 },
    { "the parameter M2_model_stiffness is outside its range", offsetof(centre_differential_locked_controller_params, M2_model_stiffness), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_model_damping is outside its range", offsetof(centre_differential_locked_controller_params, M2_model_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_torque_model is outside its range", offsetof(centre_differential_locked_controller_params, M2_torque_model), 0.0, 1.0, 0, 0 },
    { "the parameter M3_sensor_inertia_M1 is outside its range", offsetof(centre_differential_locked_controller_params, M3_sensor_inertia_M1), -DBL_MAX, DBL_MAX, 0, 0 },
    { "the parameter M3_inertia_estimate is outside its range", offsetof(centre_differential_locked_controller_params, M3_inertia_estimate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_feedforward is outside its range", offsetof(centre_differential_locked_controller_params, M3_feedforward), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M3_torque_gain is outside its range", offsetof(centre_differential_locked_controller_params, M3_torque_gain), -1.0, DBL_MAX, 1, 0 },
    { "the parameter M3_model_stiffness is outside its range", offsetof(centre_differential_locked_controller_params, M3_model_stiffness), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M3_model_damping is outside its range", offsetof(centre_differential_locked_controller_params, M3_model_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M3_torque_model is outside its range", offsetof(centre_differential_locked_controller_params, M3_torque_model), 0.0, 1.0, 0, 0 },
    { "the parameter diff_ratio is outside its range", offsetof(centre_differential_locked_controller_params, diff_ratio), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter M2_M3_equivalent_stiffness is outside its range", offsetof(centre_differential_locked_controller_params, M2_M3_equivalent_stiffness), -DBL_MAX, DBL_MAX, 0, 0 },
    { "the parameter M2_equivalent_stiffness is outside its range", offsetof(centre_differential_locked_controller_params, M2_equivalent_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_equivalent_stiffness is outside its range", offsetof(centre_differential_locked_controller_params, M3_equivalent_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_integral_gain is outside its range", offsetof(centre_differential_locked_controller_params, M2_torque_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_damping_reserve is outside its range", offsetof(centre_differential_locked_controller_params, M2_damping_reserve), 0.0, 1.0, 0, 0 },
    { "the parameter M2_torque_integral_limit is outside its range", offsetof(centre_differential_locked_controller_params, M2_torque_integral_limit), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M3_torque_integral_gain is outside its range", offsetof(centre_differential_locked_controller_params, M3_torque_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M3_damping_reserve is outside its range", offsetof(centre_differential_locked_controller_params, M3_damping_reserve), 0.0, 1.0, 0, 0 },
    { "the parameter M3_torque_integral_limit is outside its range", offsetof(centre_differential_locked_controller_params, M3_torque_integral_limit), 0.0, DBL_MAX, 0, 0 },
};

enum { limit_count = sizeof limits / sizeof limits[0] };

const char *centre_differential_locked_controller_status_text(centre_differential_locked_controller_status status)
{
    switch ((int)status) {
    case centre_differential_locked_controller_ok:
        return "ok";
    case centre_differential_locked_controller_fault_flange2_torque_ref:
        return "flange2_torque_ref: not finite or not plausible";
    case centre_differential_locked_controller_fault_flange3_torque_ref:
        return "flange3_torque_ref: not finite or not plausible";
    case centre_differential_locked_controller_fault_M1_speed_ref:
        return "M1_speed_ref: not finite or not plausible";
    case centre_differential_locked_controller_fault_M1_speed:
        return "M1_speed: not finite or not plausible";
    case centre_differential_locked_controller_fault_flange1_torque:
        return "flange1_torque: not finite or not plausible";
    case centre_differential_locked_controller_fault_flange2_torque:
        return "flange2_torque: not finite or not plausible";
    case centre_differential_locked_controller_fault_M2_speed:
        return "M2_speed: not finite or not plausible";
    case centre_differential_locked_controller_fault_flange3_torque:
        return "flange3_torque: not finite or not plausible";
    case centre_differential_locked_controller_fault_M3_speed:
        return "M3_speed: not finite or not plausible";
    case centre_differential_locked_controller_fault_M1_speed_overspeed:
        return "M1_speed: overspeed";
    case centre_differential_locked_controller_fault_M2_speed_overspeed:
        return "M2_speed: overspeed";
    case centre_differential_locked_controller_fault_M3_speed_overspeed:
        return "M3_speed: overspeed";
    case centre_differential_locked_controller_fault_M1_speed_frozen:
        return "M1_speed: frozen while the torques accelerate the machine";
    case centre_differential_locked_controller_fault_M1_speed_disagreement:
        return "M1_speed: disagrees with the integrated torque";
    case centre_differential_locked_controller_fault_flange1_torque_frozen:
        return "flange1_torque: frozen while the torque of the machine changes";
    case centre_differential_locked_controller_fault_M2_speed_frozen:
        return "M2_speed: frozen while the torques accelerate the machine";
    case centre_differential_locked_controller_fault_M2_speed_disagreement:
        return "M2_speed: disagrees with the integrated torque";
    case centre_differential_locked_controller_fault_flange2_torque_frozen:
        return "flange2_torque: frozen while the torque of the machine changes";
    case centre_differential_locked_controller_fault_M3_speed_frozen:
        return "M3_speed: frozen while the torques accelerate the machine";
    case centre_differential_locked_controller_fault_M3_speed_disagreement:
        return "M3_speed: disagrees with the integrated torque";
    case centre_differential_locked_controller_fault_flange3_torque_frozen:
        return "flange3_torque: frozen while the torque of the machine changes";
    case centre_differential_locked_controller_fault_flange1_torque_oscillation:
        return "flange1_torque: oscillates beyond its limit";
    case centre_differential_locked_controller_fault_flange2_torque_oscillation:
        return "flange2_torque: oscillates beyond its limit";
    case centre_differential_locked_controller_fault_flange3_torque_oscillation:
        return "flange3_torque: oscillates beyond its limit";
    case centre_differential_locked_controller_fault_M1_torque_ref_oscillation:
        return "M1_torque_ref: the command oscillates";
    case centre_differential_locked_controller_fault_M2_torque_ref_oscillation:
        return "M2_torque_ref: the command oscillates";
    case centre_differential_locked_controller_fault_M3_torque_ref_oscillation:
        return "M3_torque_ref: the command oscillates";
    case centre_differential_locked_controller_fault_M1_torque_ref:
        return "M1_torque_ref: the command is not finite, or beyond the torque of the machine";
    case centre_differential_locked_controller_fault_M2_torque_ref:
        return "M2_torque_ref: the command is not finite, or beyond the torque of the machine";
    case centre_differential_locked_controller_fault_M3_torque_ref:
        return "M3_torque_ref: the command is not finite, or beyond the torque of the machine";
    default:
        break;
    }
    const int limit = (int)status - 2000;
    return limit >= 0 && limit < limit_count ? limits[limit].text : "unknown status";
}

centre_differential_locked_controller_status centre_differential_locked_controller_init(centre_differential_locked_controller_state *s, const centre_differential_locked_controller_params *p)
{
    memset(s, 0, sizeof *s);
    s->authority = 1.0;
    s->flange2_torque_ref_bad_time = 1e+30;
    s->flange3_torque_ref_bad_time = 1e+30;
    s->M1_speed_ref_bad_time = 1e+30;
    s->M1_speed_bad_time = 1e+30;
    s->flange1_torque_bad_time = 1e+30;
    s->flange2_torque_bad_time = 1e+30;
    s->M2_speed_bad_time = 1e+30;
    s->flange3_torque_bad_time = 1e+30;
    s->M3_speed_bad_time = 1e+30;
    s->reset_before = 1.0;
    const centre_differential_locked_controller_status status = centre_differential_locked_controller_update(s, p);
    if (status != centre_differential_locked_controller_ok) {
        s->authority = 0.0; /* never started: no torque at all */
    }
    return status;
}

centre_differential_locked_controller_status centre_differential_locked_controller_update(centre_differential_locked_controller_state *s, const centre_differential_locked_controller_params *p)
{
    for (int k = 0; k < limit_count; ++k) {
        const centre_differential_locked_real value = *(const centre_differential_locked_real *)(const void *)((const char *)p + limits[k].offset);
        const int above = limits[k].open ? value > limits[k].least : value >= limits[k].least; /* false for NaN */
        if (!(above && value <= limits[k].most) || (limits[k].not_zero && value == 0.0)) {
            s->fault = s->fault > 0.0 ? s->fault : CENTRE_DIFFERENTIAL_LOCKED_REAL(2000 + k); /* latched like any fault */
            s->refused = 1.0; /* no reset before an update succeeds */
            return (centre_differential_locked_controller_status)(2000 + k);
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
    s->M1_speed_ref_step = p->M1_speed_ref_rate * p->sample_time;
    s->flange2_torque_ref_step = p->flange2_torque_ref_rate * p->sample_time;
    s->flange3_torque_ref_step = p->flange3_torque_ref_rate * p->sample_time;
    s->M1_speed_growth = p->M1_speed_integral_gain * p->sample_time;
    s->M1_speed_conditioning = p->M1_speed_integral_gain * p->sample_time / p->M1_speed_gain;
    s->M2_unread_M1 = p->M2_sensor_inertia_M1 / p->M1_inertia;
    s->M2_model_pull = p->M2_model_stiffness * p->sample_time / p->M2_inertia_estimate;
    s->M2_model_drag = p->M2_model_damping * p->sample_time / p->M2_inertia_estimate;
    s->M3_unread_M1 = p->M3_sensor_inertia_M1 / p->M1_inertia;
    s->M3_model_pull = p->M3_model_stiffness * p->sample_time / p->M3_inertia_estimate;
    s->M3_model_drag = p->M3_model_damping * p->sample_time / p->M3_inertia_estimate;
    s->M2_with_M1 = p->M2_inertia_estimate / (p->M1_inertia * p->diff_ratio);
    s->M2_share_M2 = p->M2_equivalent_stiffness * p->M3_equivalent_stiffness / ((p->M2_M3_equivalent_stiffness *
        p->M2_M3_equivalent_stiffness) - p->M2_equivalent_stiffness * p->M3_equivalent_stiffness);
    s->M2_share_M3 = -p->M2_M3_equivalent_stiffness * p->M2_inertia_estimate * p->M3_equivalent_stiffness /
        (p->M3_inertia_estimate * ((p->M2_M3_equivalent_stiffness * p->M2_M3_equivalent_stiffness) -
        p->M2_equivalent_stiffness * p->M3_equivalent_stiffness));
    s->M2_from_flange2_torque = -(p->M2_M3_equivalent_stiffness * p->M2_M3_equivalent_stiffness) /
        ((p->M2_M3_equivalent_stiffness * p->M2_M3_equivalent_stiffness) - p->M2_equivalent_stiffness *
        p->M3_equivalent_stiffness);
    s->M2_from_flange3_torque = p->M2_M3_equivalent_stiffness * p->M2_inertia_estimate * p->M3_equivalent_stiffness
        / (p->M3_inertia_estimate * ((p->M2_M3_equivalent_stiffness * p->M2_M3_equivalent_stiffness) -
        p->M2_equivalent_stiffness * p->M3_equivalent_stiffness));
    s->M2_twist_M2_M1_speed = -p->M3_equivalent_stiffness * (p->M2_M3_equivalent_stiffness +
        p->M2_equivalent_stiffness) / (p->diff_ratio * ((p->M2_M3_equivalent_stiffness *
        p->M2_M3_equivalent_stiffness) - p->M2_equivalent_stiffness * p->M3_equivalent_stiffness));
    s->M2_twist_M2_M2_speed = p->M2_equivalent_stiffness * p->M3_equivalent_stiffness /
        ((p->M2_M3_equivalent_stiffness * p->M2_M3_equivalent_stiffness) - p->M2_equivalent_stiffness *
        p->M3_equivalent_stiffness);
    s->M2_twist_M2_M3_speed = p->M2_M3_equivalent_stiffness * p->M3_equivalent_stiffness /
        ((p->M2_M3_equivalent_stiffness * p->M2_M3_equivalent_stiffness) - p->M2_equivalent_stiffness *
        p->M3_equivalent_stiffness);
    s->M2_twist_M3_M1_speed = p->M2_M3_equivalent_stiffness * p->M2_inertia_estimate *
        (p->M2_M3_equivalent_stiffness + p->M3_equivalent_stiffness) / (p->M3_inertia_estimate * p->diff_ratio *
        ((p->M2_M3_equivalent_stiffness * p->M2_M3_equivalent_stiffness) - p->M2_equivalent_stiffness *
        p->M3_equivalent_stiffness));
    s->M2_twist_M3_M2_speed = -(p->M2_M3_equivalent_stiffness * p->M2_M3_equivalent_stiffness) *
        p->M2_inertia_estimate / (p->M3_inertia_estimate * ((p->M2_M3_equivalent_stiffness *
        p->M2_M3_equivalent_stiffness) - p->M2_equivalent_stiffness * p->M3_equivalent_stiffness));
    s->M2_twist_M3_M3_speed = -p->M2_M3_equivalent_stiffness * p->M2_inertia_estimate * p->M3_equivalent_stiffness /
        (p->M3_inertia_estimate * ((p->M2_M3_equivalent_stiffness * p->M2_M3_equivalent_stiffness) -
        p->M2_equivalent_stiffness * p->M3_equivalent_stiffness));
    s->M2_torque_growth = p->M2_torque_integral_gain * p->sample_time;
    s->M2_share = p->M2_equivalent_stiffness * p->M3_equivalent_stiffness / ((p->M2_M3_equivalent_stiffness *
        p->M2_M3_equivalent_stiffness) - p->M2_equivalent_stiffness * p->M3_equivalent_stiffness);
    s->M3_with_M1 = p->M3_inertia_estimate / (p->M1_inertia * p->diff_ratio);
    s->M3_share_M2 = -p->M2_M3_equivalent_stiffness * p->M2_equivalent_stiffness * p->M3_inertia_estimate /
        (p->M2_inertia_estimate * ((p->M2_M3_equivalent_stiffness * p->M2_M3_equivalent_stiffness) -
        p->M2_equivalent_stiffness * p->M3_equivalent_stiffness));
    s->M3_share_M3 = p->M2_equivalent_stiffness * p->M3_equivalent_stiffness / ((p->M2_M3_equivalent_stiffness *
        p->M2_M3_equivalent_stiffness) - p->M2_equivalent_stiffness * p->M3_equivalent_stiffness);
    s->M3_from_flange2_torque = p->M2_M3_equivalent_stiffness * p->M2_equivalent_stiffness * p->M3_inertia_estimate
        / (p->M2_inertia_estimate * ((p->M2_M3_equivalent_stiffness * p->M2_M3_equivalent_stiffness) -
        p->M2_equivalent_stiffness * p->M3_equivalent_stiffness));
    s->M3_from_flange3_torque = -(p->M2_M3_equivalent_stiffness * p->M2_M3_equivalent_stiffness) /
        ((p->M2_M3_equivalent_stiffness * p->M2_M3_equivalent_stiffness) - p->M2_equivalent_stiffness *
        p->M3_equivalent_stiffness);
    s->M3_twist_M2_M1_speed = p->M2_M3_equivalent_stiffness * p->M3_inertia_estimate *
        (p->M2_M3_equivalent_stiffness + p->M2_equivalent_stiffness) / (p->M2_inertia_estimate * p->diff_ratio *
        ((p->M2_M3_equivalent_stiffness * p->M2_M3_equivalent_stiffness) - p->M2_equivalent_stiffness *
        p->M3_equivalent_stiffness));
    s->M3_twist_M2_M2_speed = -p->M2_M3_equivalent_stiffness * p->M2_equivalent_stiffness * p->M3_inertia_estimate /
        (p->M2_inertia_estimate * ((p->M2_M3_equivalent_stiffness * p->M2_M3_equivalent_stiffness) -
        p->M2_equivalent_stiffness * p->M3_equivalent_stiffness));
    s->M3_twist_M2_M3_speed = -(p->M2_M3_equivalent_stiffness * p->M2_M3_equivalent_stiffness) *
        p->M3_inertia_estimate / (p->M2_inertia_estimate * ((p->M2_M3_equivalent_stiffness *
        p->M2_M3_equivalent_stiffness) - p->M2_equivalent_stiffness * p->M3_equivalent_stiffness));
    s->M3_twist_M3_M1_speed = -p->M2_equivalent_stiffness * (p->M2_M3_equivalent_stiffness +
        p->M3_equivalent_stiffness) / (p->diff_ratio * ((p->M2_M3_equivalent_stiffness *
        p->M2_M3_equivalent_stiffness) - p->M2_equivalent_stiffness * p->M3_equivalent_stiffness));
    s->M3_twist_M3_M2_speed = p->M2_M3_equivalent_stiffness * p->M2_equivalent_stiffness /
        ((p->M2_M3_equivalent_stiffness * p->M2_M3_equivalent_stiffness) - p->M2_equivalent_stiffness *
        p->M3_equivalent_stiffness);
    s->M3_twist_M3_M3_speed = p->M2_equivalent_stiffness * p->M3_equivalent_stiffness /
        ((p->M2_M3_equivalent_stiffness * p->M2_M3_equivalent_stiffness) - p->M2_equivalent_stiffness *
        p->M3_equivalent_stiffness);
    s->M3_torque_growth = p->M3_torque_integral_gain * p->sample_time;
    s->M3_share = p->M2_equivalent_stiffness * p->M3_equivalent_stiffness / ((p->M2_M3_equivalent_stiffness *
        p->M2_M3_equivalent_stiffness) - p->M2_equivalent_stiffness * p->M3_equivalent_stiffness);
    s->M1_largest = 1.01 * centre_differential_locked_min(930.0, p->M1_torque_max);
    s->M2_largest = 1.01 * centre_differential_locked_min(1200.0, p->M2_torque_max);
    s->M3_largest = 1.01 * centre_differential_locked_min(1200.0, p->M3_torque_max);
    s->ramp_step = p->sample_time / p->fault_ramp;
    s->calm_share = p->sample_time / (p->sample_time + 0.02);
    s->refused = 0.0;
    return centre_differential_locked_controller_ok;
}

centre_differential_locked_controller_status centre_differential_locked_controller_step(centre_differential_locked_controller_state *s, const centre_differential_locked_controller_params *p,
    const centre_differential_locked_controller_inputs *in, centre_differential_locked_controller_outputs *out)
{
    /* supervision: bad samples are bridged */
    centre_differential_locked_real flange2_torque_ref_sound;
    centre_differential_locked_guard(in->flange2_torque_ref, p->flange2_torque_ref_plausible,
        s->flange2_torque_ref_held, &s->flange2_torque_ref_held, &flange2_torque_ref_sound);
    centre_differential_locked_lasting(flange2_torque_ref_sound, s->flange2_torque_ref_bad_time, p->sample_time,
        p->hold_time, &s->flange2_torque_ref_bad_time);
    centre_differential_locked_real flange3_torque_ref_sound;
    centre_differential_locked_guard(in->flange3_torque_ref, p->flange3_torque_ref_plausible,
        s->flange3_torque_ref_held, &s->flange3_torque_ref_held, &flange3_torque_ref_sound);
    centre_differential_locked_lasting(flange3_torque_ref_sound, s->flange3_torque_ref_bad_time, p->sample_time,
        p->hold_time, &s->flange3_torque_ref_bad_time);
    centre_differential_locked_real M1_speed_ref_sound;
    centre_differential_locked_guard(in->M1_speed_ref, p->M1_speed_ref_plausible, s->M1_speed_ref_held,
        &s->M1_speed_ref_held, &M1_speed_ref_sound);
    centre_differential_locked_lasting(M1_speed_ref_sound, s->M1_speed_ref_bad_time, p->sample_time, p->hold_time,
        &s->M1_speed_ref_bad_time);
    centre_differential_locked_real M1_speed_sound;
    centre_differential_locked_guard(in->M1_speed, p->M1_speed_plausible, s->M1_speed_held, &s->M1_speed_held,
        &M1_speed_sound);
    centre_differential_locked_lasting(M1_speed_sound, s->M1_speed_bad_time, p->sample_time, p->hold_time,
        &s->M1_speed_bad_time);
    centre_differential_locked_real flange1_torque_sound;
    centre_differential_locked_guard(in->flange1_torque, p->flange1_torque_plausible, s->flange1_torque_held,
        &s->flange1_torque_held, &flange1_torque_sound);
    centre_differential_locked_lasting(flange1_torque_sound, s->flange1_torque_bad_time, p->sample_time,
        p->hold_time, &s->flange1_torque_bad_time);
    centre_differential_locked_real flange2_torque_sound;
    centre_differential_locked_guard(in->flange2_torque, p->flange2_torque_plausible, s->flange2_torque_held,
        &s->flange2_torque_held, &flange2_torque_sound);
    centre_differential_locked_lasting(flange2_torque_sound, s->flange2_torque_bad_time, p->sample_time,
        p->hold_time, &s->flange2_torque_bad_time);
    centre_differential_locked_real M2_speed_sound;
    centre_differential_locked_guard(in->M2_speed, p->M2_speed_plausible, s->M2_speed_held, &s->M2_speed_held,
        &M2_speed_sound);
    centre_differential_locked_lasting(M2_speed_sound, s->M2_speed_bad_time, p->sample_time, p->hold_time,
        &s->M2_speed_bad_time);
    centre_differential_locked_real flange3_torque_sound;
    centre_differential_locked_guard(in->flange3_torque, p->flange3_torque_plausible, s->flange3_torque_held,
        &s->flange3_torque_held, &flange3_torque_sound);
    centre_differential_locked_lasting(flange3_torque_sound, s->flange3_torque_bad_time, p->sample_time,
        p->hold_time, &s->flange3_torque_bad_time);
    centre_differential_locked_real M3_speed_sound;
    centre_differential_locked_guard(in->M3_speed, p->M3_speed_plausible, s->M3_speed_held, &s->M3_speed_held,
        &M3_speed_sound);
    centre_differential_locked_lasting(M3_speed_sound, s->M3_speed_bad_time, p->sample_time, p->hold_time,
        &s->M3_speed_bad_time);
    /* overspeed */
    const centre_differential_locked_real M1_slow_enough = centre_differential_locked_select(p->M1_overspeed >=
        centre_differential_locked_abs(s->M1_speed_held), 1.0, 0.0);
    centre_differential_locked_lasting(M1_slow_enough, s->M1_overspeed_time, p->sample_time, p->hold_time,
        &s->M1_overspeed_time);
    const centre_differential_locked_real M2_slow_enough = centre_differential_locked_select(p->M2_overspeed >=
        centre_differential_locked_abs(s->M2_speed_held), 1.0, 0.0);
    centre_differential_locked_lasting(M2_slow_enough, s->M2_overspeed_time, p->sample_time, p->hold_time,
        &s->M2_overspeed_time);
    const centre_differential_locked_real M3_slow_enough = centre_differential_locked_select(p->M3_overspeed >=
        centre_differential_locked_abs(s->M3_speed_held), 1.0, 0.0);
    centre_differential_locked_lasting(M3_slow_enough, s->M3_overspeed_time, p->sample_time, p->hold_time,
        &s->M3_overspeed_time);
    /* reset on request, when the cause is gone */
    const centre_differential_locked_real reset_pressed =
        centre_differential_locked_select(centre_differential_locked_abs(in->reset - 1.0) <= 0.5, 1.0, 0.0);
    s->reset_request = centre_differential_locked_select(s->fault > 0.5,
        centre_differential_locked_select(p->M1_overspeed >= centre_differential_locked_abs(s->M1_speed_held) &&
        p->M1_speed_plausible >= centre_differential_locked_abs(in->M1_speed) && p->M1_speed_ref_plausible >=
        centre_differential_locked_abs(in->M1_speed_ref) && p->M2_overspeed >=
        centre_differential_locked_abs(s->M2_speed_held) && p->M2_speed_plausible >=
        centre_differential_locked_abs(in->M2_speed) && p->M3_overspeed >=
        centre_differential_locked_abs(s->M3_speed_held) && p->M3_speed_plausible >=
        centre_differential_locked_abs(in->M3_speed) && p->flange1_torque_plausible >=
        centre_differential_locked_abs(in->flange1_torque) && p->flange2_torque_plausible >=
        centre_differential_locked_abs(in->flange2_torque) && p->flange2_torque_ref_plausible >=
        centre_differential_locked_abs(in->flange2_torque_ref) && p->flange3_torque_plausible >=
        centre_differential_locked_abs(in->flange3_torque) && p->flange3_torque_ref_plausible >=
        centre_differential_locked_abs(in->flange3_torque_ref), (1.0 - s->refused) *
        centre_differential_locked_max(s->reset_request, -s->reset_before + reset_pressed), 0.0), 0.0);
    s->reset_before = reset_pressed;
    s->fault = s->fault * (1.0 - centre_differential_locked_select(s->authority <= 0.0, s->reset_request, 0.0));
    s->reset_request = centre_differential_locked_select(s->fault > 0.5, s->reset_request, 0.0);
    /* the first fault is latched */
    centre_differential_locked_real cause_of_inputs = 0.0;
    cause_of_inputs = centre_differential_locked_select(s->M3_overspeed_time <= s->bridged_time, cause_of_inputs,
        4009.0);
    cause_of_inputs = centre_differential_locked_select(s->M2_overspeed_time <= s->bridged_time, cause_of_inputs,
        4007.0);
    cause_of_inputs = centre_differential_locked_select(s->M1_overspeed_time <= s->bridged_time, cause_of_inputs,
        4004.0);
    cause_of_inputs = centre_differential_locked_select(s->M3_speed_bad_time <= s->bridged_time, cause_of_inputs,
        9.0);
    cause_of_inputs = centre_differential_locked_select(s->flange3_torque_bad_time <= s->bridged_time,
        cause_of_inputs, 8.0);
    cause_of_inputs = centre_differential_locked_select(s->M2_speed_bad_time <= s->bridged_time, cause_of_inputs,
        7.0);
    cause_of_inputs = centre_differential_locked_select(s->flange2_torque_bad_time <= s->bridged_time,
        cause_of_inputs, 6.0);
    cause_of_inputs = centre_differential_locked_select(s->flange1_torque_bad_time <= s->bridged_time,
        cause_of_inputs, 5.0);
    cause_of_inputs = centre_differential_locked_select(s->M1_speed_bad_time <= s->bridged_time, cause_of_inputs,
        4.0);
    cause_of_inputs = centre_differential_locked_select(s->M1_speed_ref_bad_time <= s->bridged_time,
        cause_of_inputs, 3.0);
    cause_of_inputs = centre_differential_locked_select(s->flange3_torque_ref_bad_time <= s->bridged_time,
        cause_of_inputs, 2.0);
    cause_of_inputs = centre_differential_locked_select(s->flange2_torque_ref_bad_time <= s->bridged_time,
        cause_of_inputs, 1.0);
    s->fault = centre_differential_locked_select(s->fault > 0.5, s->fault, cause_of_inputs);
    if (s->running <= 0.5) {
        /* the first step, and the first one after a fault, starts anew */
        s->load_compensation_now = p->load_compensation;
        s->acceleration_torque_now = p->acceleration_torque;
        s->M2_damping_now = p->M2_damping;
        s->M3_damping_now = p->M3_damping;
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
        s->M1_speed_ref_limited = s->M1_speed_held;
        s->M1_speed_integral = 0.0;
        s->M2_model_rate = 0.0;
        s->M2_torque_integral = 0.0;
        s->M3_model_rate = 0.0;
        s->M3_torque_integral = 0.0;
    }
    /* load_compensation follows its parameter along a ramp */
    const centre_differential_locked_real load_compensation_before = s->load_compensation_now;
    const centre_differential_locked_real load_compensation_distance = p->load_compensation -
        load_compensation_before;
    if (p->load_compensation != s->load_compensation_target) {
        s->load_compensation_step = centre_differential_locked_max(s->switch_share *
            centre_differential_locked_abs(load_compensation_distance), 1e-06 *
            centre_differential_locked_abs(p->load_compensation) + 1e-06 *
            centre_differential_locked_abs(load_compensation_before));
    }
    s->load_compensation_now = centre_differential_locked_select(s->load_compensation_step <
        centre_differential_locked_abs(load_compensation_distance), load_compensation_before +
        centre_differential_locked_max(-s->load_compensation_step,
        centre_differential_locked_min(load_compensation_distance, s->load_compensation_step)),
        p->load_compensation);
    s->load_compensation_step = centre_differential_locked_select(s->load_compensation_step <
        centre_differential_locked_abs(load_compensation_distance), s->load_compensation_step, 0.0);
    s->load_compensation_target = p->load_compensation;
    /* acceleration_torque follows its parameter along a ramp */
    const centre_differential_locked_real acceleration_torque_before = s->acceleration_torque_now;
    const centre_differential_locked_real acceleration_torque_distance = p->acceleration_torque -
        acceleration_torque_before;
    if (p->acceleration_torque != s->acceleration_torque_target) {
        s->acceleration_torque_step = centre_differential_locked_max(s->switch_share *
            centre_differential_locked_abs(acceleration_torque_distance), 1e-06 *
            centre_differential_locked_abs(p->acceleration_torque) + 1e-06 *
            centre_differential_locked_abs(acceleration_torque_before));
    }
    s->acceleration_torque_now = centre_differential_locked_select(s->acceleration_torque_step <
        centre_differential_locked_abs(acceleration_torque_distance), acceleration_torque_before +
        centre_differential_locked_max(-s->acceleration_torque_step,
        centre_differential_locked_min(acceleration_torque_distance, s->acceleration_torque_step)),
        p->acceleration_torque);
    s->acceleration_torque_step = centre_differential_locked_select(s->acceleration_torque_step <
        centre_differential_locked_abs(acceleration_torque_distance), s->acceleration_torque_step, 0.0);
    s->acceleration_torque_target = p->acceleration_torque;
    /* M2_damping follows its parameter along a ramp */
    const centre_differential_locked_real M2_damping_before = s->M2_damping_now;
    const centre_differential_locked_real M2_damping_distance = p->M2_damping - M2_damping_before;
    if (p->M2_damping != s->M2_damping_target) {
        s->M2_damping_step = centre_differential_locked_max(s->switch_share *
            centre_differential_locked_abs(M2_damping_distance), 1e-06 * centre_differential_locked_abs(p->M2_damping) +
            1e-06 * centre_differential_locked_abs(M2_damping_before));
    }
    s->M2_damping_now = centre_differential_locked_select(s->M2_damping_step <
        centre_differential_locked_abs(M2_damping_distance), M2_damping_before +
        centre_differential_locked_max(-s->M2_damping_step, centre_differential_locked_min(M2_damping_distance,
        s->M2_damping_step)), p->M2_damping);
    s->M2_damping_step = centre_differential_locked_select(s->M2_damping_step <
        centre_differential_locked_abs(M2_damping_distance), s->M2_damping_step, 0.0);
    s->M2_damping_target = p->M2_damping;
    /* M3_damping follows its parameter along a ramp */
    const centre_differential_locked_real M3_damping_before = s->M3_damping_now;
    const centre_differential_locked_real M3_damping_distance = p->M3_damping - M3_damping_before;
    if (p->M3_damping != s->M3_damping_target) {
        s->M3_damping_step = centre_differential_locked_max(s->switch_share *
            centre_differential_locked_abs(M3_damping_distance), 1e-06 * centre_differential_locked_abs(p->M3_damping) +
            1e-06 * centre_differential_locked_abs(M3_damping_before));
    }
    s->M3_damping_now = centre_differential_locked_select(s->M3_damping_step <
        centre_differential_locked_abs(M3_damping_distance), M3_damping_before +
        centre_differential_locked_max(-s->M3_damping_step, centre_differential_locked_min(M3_damping_distance,
        s->M3_damping_step)), p->M3_damping);
    s->M3_damping_step = centre_differential_locked_select(s->M3_damping_step <
        centre_differential_locked_abs(M3_damping_distance), s->M3_damping_step, 0.0);
    s->M3_damping_target = p->M3_damping;
    /* torque-speed envelope, Figure 7.1 */
    const centre_differential_locked_real M1_available = s->M1_power /
        centre_differential_locked_max(p->M1_speed_rated, centre_differential_locked_abs(s->M1_speed_held));
    const centre_differential_locked_real M1_least = -M1_available * centre_differential_locked_max(0.0,
        centre_differential_locked_min(1.0, s->M1_speed_held * s->M1_taper_slope + s->M1_taper_end));
    const centre_differential_locked_real M1_most = M1_available * centre_differential_locked_max(0.0,
        centre_differential_locked_min(1.0, -s->M1_speed_held * s->M1_taper_slope + s->M1_taper_end));
    const centre_differential_locked_real M2_available = s->M2_power /
        centre_differential_locked_max(p->M2_speed_rated, centre_differential_locked_abs(s->M2_speed_held));
    const centre_differential_locked_real M2_least = -M2_available * centre_differential_locked_max(0.0,
        centre_differential_locked_min(1.0, s->M2_speed_held * s->M2_taper_slope + s->M2_taper_end));
    const centre_differential_locked_real M2_most = M2_available * centre_differential_locked_max(0.0,
        centre_differential_locked_min(1.0, -s->M2_speed_held * s->M2_taper_slope + s->M2_taper_end));
    const centre_differential_locked_real M3_available = s->M3_power /
        centre_differential_locked_max(p->M3_speed_rated, centre_differential_locked_abs(s->M3_speed_held));
    const centre_differential_locked_real M3_least = -M3_available * centre_differential_locked_max(0.0,
        centre_differential_locked_min(1.0, s->M3_speed_held * s->M3_taper_slope + s->M3_taper_end));
    const centre_differential_locked_real M3_most = M3_available * centre_differential_locked_max(0.0,
        centre_differential_locked_min(1.0, -s->M3_speed_held * s->M3_taper_slope + s->M3_taper_end));
    /* torque commands of the step before */
    const centre_differential_locked_real M1_applied = s->M1_last * s->authority;
    const centre_differential_locked_real M2_applied = s->M2_last * s->authority;
    const centre_differential_locked_real M3_applied = s->M3_last * s->authority;
    /* speed from the torques on the rotor */
    const centre_differential_locked_real M1_integrated_before = s->M1_integrated;
    s->M1_integrated = M1_integrated_before + s->M1_per_step * (M1_applied - s->flange1_torque_held) +
        s->disagreement_share * (-M1_integrated_before + s->M1_speed_held);
    const centre_differential_locked_real M1_difference = centre_differential_locked_abs(s->M1_integrated -
        s->M1_speed_held);
    /* speed against torques */
    const centre_differential_locked_real M1_agrees = centre_differential_locked_select(M1_difference <=
        p->M1_disagreement_limit, 1.0, 0.0);
    centre_differential_locked_lasting(M1_agrees, s->M1_disagreement_time, p->sample_time, p->hold_time,
        &s->M1_disagreement_time);
    /* M1_speed to the last bit */
    centre_differential_locked_still(s->M1_speed_held, s->M1_speed_before, s->M1_speed_still_time, p->sample_time,
        &s->M1_speed_still_time);
    s->M1_speed_before = s->M1_speed_held;
    /* flange1_torque to the last bit */
    centre_differential_locked_still(s->flange1_torque_held, s->flange1_torque_before, s->flange1_torque_still_time,
        p->sample_time, &s->flange1_torque_still_time);
    s->flange1_torque_before = s->flange1_torque_held;
    s->flange1_torque_command = centre_differential_locked_select(s->flange1_torque_still_time > 0.0,
        s->flange1_torque_command, M1_applied);
    /* speed from the torques on the rotor */
    const centre_differential_locked_real M2_integrated_before = s->M2_integrated;
    s->M2_integrated = M2_integrated_before + s->M2_per_step * (M2_applied + s->flange2_torque_held) +
        s->disagreement_share * (-M2_integrated_before + s->M2_speed_held);
    const centre_differential_locked_real M2_difference = centre_differential_locked_abs(s->M2_integrated -
        s->M2_speed_held);
    /* speed against torques */
    const centre_differential_locked_real M2_agrees = centre_differential_locked_select(M2_difference <=
        p->M2_disagreement_limit, 1.0, 0.0);
    centre_differential_locked_lasting(M2_agrees, s->M2_disagreement_time, p->sample_time, p->hold_time,
        &s->M2_disagreement_time);
    /* M2_speed to the last bit */
    centre_differential_locked_still(s->M2_speed_held, s->M2_speed_before, s->M2_speed_still_time, p->sample_time,
        &s->M2_speed_still_time);
    s->M2_speed_before = s->M2_speed_held;
    /* flange2_torque to the last bit */
    centre_differential_locked_still(s->flange2_torque_held, s->flange2_torque_before, s->flange2_torque_still_time,
        p->sample_time, &s->flange2_torque_still_time);
    s->flange2_torque_before = s->flange2_torque_held;
    s->flange2_torque_command = centre_differential_locked_select(s->flange2_torque_still_time > 0.0,
        s->flange2_torque_command, M2_applied);
    /* speed from the torques on the rotor */
    const centre_differential_locked_real M3_integrated_before = s->M3_integrated;
    s->M3_integrated = M3_integrated_before + s->M3_per_step * (M3_applied + s->flange3_torque_held) +
        s->disagreement_share * (-M3_integrated_before + s->M3_speed_held);
    const centre_differential_locked_real M3_difference = centre_differential_locked_abs(s->M3_integrated -
        s->M3_speed_held);
    /* speed against torques */
    const centre_differential_locked_real M3_agrees = centre_differential_locked_select(M3_difference <=
        p->M3_disagreement_limit, 1.0, 0.0);
    centre_differential_locked_lasting(M3_agrees, s->M3_disagreement_time, p->sample_time, p->hold_time,
        &s->M3_disagreement_time);
    /* M3_speed to the last bit */
    centre_differential_locked_still(s->M3_speed_held, s->M3_speed_before, s->M3_speed_still_time, p->sample_time,
        &s->M3_speed_still_time);
    s->M3_speed_before = s->M3_speed_held;
    /* flange3_torque to the last bit */
    centre_differential_locked_still(s->flange3_torque_held, s->flange3_torque_before, s->flange3_torque_still_time,
        p->sample_time, &s->flange3_torque_still_time);
    s->flange3_torque_before = s->flange3_torque_held;
    s->flange3_torque_command = centre_differential_locked_select(s->flange3_torque_still_time > 0.0,
        s->flange3_torque_command, M3_applied);
    /* oscillation of flange1_torque */
    const centre_differential_locked_real flange1_torque_mean_before = s->flange1_torque_mean;
    const centre_differential_locked_real flange1_torque_swing = s->flange1_torque_held -
        flange1_torque_mean_before;
    s->flange1_torque_mean = flange1_torque_mean_before + flange1_torque_swing * s->mean_share;
    centre_differential_locked_swings(flange1_torque_swing, p->flange1_torque_oscillation_limit,
        s->flange1_torque_side, s->flange1_torque_swings, s->forgotten_swings, &s->flange1_torque_side,
        &s->flange1_torque_swings);
    /* oscillation of flange2_torque */
    const centre_differential_locked_real flange2_torque_mean_before = s->flange2_torque_mean;
    const centre_differential_locked_real flange2_torque_swing = s->flange2_torque_held -
        flange2_torque_mean_before;
    s->flange2_torque_mean = flange2_torque_mean_before + flange2_torque_swing * s->mean_share;
    centre_differential_locked_swings(flange2_torque_swing, p->flange2_torque_oscillation_limit,
        s->flange2_torque_side, s->flange2_torque_swings, s->forgotten_swings, &s->flange2_torque_side,
        &s->flange2_torque_swings);
    /* oscillation of flange3_torque */
    const centre_differential_locked_real flange3_torque_mean_before = s->flange3_torque_mean;
    const centre_differential_locked_real flange3_torque_swing = s->flange3_torque_held -
        flange3_torque_mean_before;
    s->flange3_torque_mean = flange3_torque_mean_before + flange3_torque_swing * s->mean_share;
    centre_differential_locked_swings(flange3_torque_swing, p->flange3_torque_oscillation_limit,
        s->flange3_torque_side, s->flange3_torque_swings, s->forgotten_swings, &s->flange3_torque_side,
        &s->flange3_torque_swings);
    /* oscillation of M1_torque_ref */
    const centre_differential_locked_real M1_torque_ref_mean_before = s->M1_torque_ref_mean;
    const centre_differential_locked_real M1_torque_ref_swing = M1_applied - M1_torque_ref_mean_before;
    s->M1_torque_ref_mean = M1_torque_ref_mean_before + M1_torque_ref_swing * s->mean_share;
    centre_differential_locked_swings(M1_torque_ref_swing, p->M1_torque_ref_oscillation_limit,
        s->M1_torque_ref_side, s->M1_torque_ref_swings, s->forgotten_swings, &s->M1_torque_ref_side,
        &s->M1_torque_ref_swings);
    /* oscillation of M2_torque_ref */
    const centre_differential_locked_real M2_torque_ref_mean_before = s->M2_torque_ref_mean;
    const centre_differential_locked_real M2_torque_ref_swing = M2_applied - M2_torque_ref_mean_before;
    s->M2_torque_ref_mean = M2_torque_ref_mean_before + M2_torque_ref_swing * s->mean_share;
    centre_differential_locked_swings(M2_torque_ref_swing, p->M2_torque_ref_oscillation_limit,
        s->M2_torque_ref_side, s->M2_torque_ref_swings, s->forgotten_swings, &s->M2_torque_ref_side,
        &s->M2_torque_ref_swings);
    /* oscillation of M3_torque_ref */
    const centre_differential_locked_real M3_torque_ref_mean_before = s->M3_torque_ref_mean;
    const centre_differential_locked_real M3_torque_ref_swing = M3_applied - M3_torque_ref_mean_before;
    s->M3_torque_ref_mean = M3_torque_ref_mean_before + M3_torque_ref_swing * s->mean_share;
    centre_differential_locked_swings(M3_torque_ref_swing, p->M3_torque_ref_oscillation_limit,
        s->M3_torque_ref_side, s->M3_torque_ref_swings, s->forgotten_swings, &s->M3_torque_ref_side,
        &s->M3_torque_ref_swings);
    /* the first fault is latched */
    centre_differential_locked_real cause_of_watching = 0.0;
    cause_of_watching = centre_differential_locked_select(s->M3_torque_ref_swings <= 5.5, cause_of_watching,
        8003.0);
    cause_of_watching = centre_differential_locked_select(s->M2_torque_ref_swings <= 5.5, cause_of_watching,
        8002.0);
    cause_of_watching = centre_differential_locked_select(s->M1_torque_ref_swings <= 5.5, cause_of_watching,
        8001.0);
    cause_of_watching = centre_differential_locked_select(s->flange3_torque_swings <= 5.5, cause_of_watching,
        6008.0);
    cause_of_watching = centre_differential_locked_select(s->flange2_torque_swings <= 5.5, cause_of_watching,
        6006.0);
    cause_of_watching = centre_differential_locked_select(s->flange1_torque_swings <= 5.5, cause_of_watching,
        6005.0);
    cause_of_watching = centre_differential_locked_select(s->M3_disagreement_time <= s->bridged_time,
        cause_of_watching, 5009.0);
    cause_of_watching = centre_differential_locked_select(s->M2_disagreement_time <= s->bridged_time,
        cause_of_watching, 5007.0);
    cause_of_watching = centre_differential_locked_select(s->M1_disagreement_time <= s->bridged_time,
        cause_of_watching, 5004.0);
    cause_of_watching = centre_differential_locked_select(M3_difference <= p->M3_frozen_limit ||
        s->M3_speed_still_time <= p->frozen_time, cause_of_watching, 3009.0);
    cause_of_watching = centre_differential_locked_select(M3_difference <= p->M3_frozen_limit ||
        s->flange3_torque_still_time <= p->frozen_time || centre_differential_locked_abs(M3_applied -
        s->flange3_torque_command) <= s->M3_moved_torque, cause_of_watching, 3008.0);
    cause_of_watching = centre_differential_locked_select(M2_difference <= p->M2_frozen_limit ||
        s->M2_speed_still_time <= p->frozen_time, cause_of_watching, 3007.0);
    cause_of_watching = centre_differential_locked_select(M2_difference <= p->M2_frozen_limit ||
        s->flange2_torque_still_time <= p->frozen_time || centre_differential_locked_abs(M2_applied -
        s->flange2_torque_command) <= s->M2_moved_torque, cause_of_watching, 3006.0);
    cause_of_watching = centre_differential_locked_select(M1_difference <= p->M1_frozen_limit ||
        s->flange1_torque_still_time <= p->frozen_time || centre_differential_locked_abs(M1_applied -
        s->flange1_torque_command) <= s->M1_moved_torque, cause_of_watching, 3005.0);
    cause_of_watching = centre_differential_locked_select(M1_difference <= p->M1_frozen_limit ||
        s->M1_speed_still_time <= p->frozen_time, cause_of_watching, 3004.0);
    s->fault = centre_differential_locked_select(s->fault > 0.5, s->fault, cause_of_watching);
    /* limit of the rate */
    const centre_differential_locked_real M1_speed_ref_before = s->M1_speed_ref_limited;
    s->M1_speed_ref_limited = M1_speed_ref_before + centre_differential_locked_max(-s->M1_speed_ref_step,
        centre_differential_locked_min(s->M1_speed_ref_step, -M1_speed_ref_before + s->M1_speed_ref_held));
    /* testing torque while nothing accelerates (5.95), (5.96) */
    const centre_differential_locked_real flange2_torque_steady = s->flange2_torque_held;
    if (s->running <= 0.5) {
        /* the first step, and the first one after a fault, starts anew */
        s->flange2_torque_ref_limited = flange2_torque_steady;
    }
    /* limit of the rate */
    const centre_differential_locked_real flange2_torque_ref_before = s->flange2_torque_ref_limited;
    s->flange2_torque_ref_limited = flange2_torque_ref_before +
        centre_differential_locked_max(-s->flange2_torque_ref_step,
        centre_differential_locked_min(s->flange2_torque_ref_step, -flange2_torque_ref_before +
        s->flange2_torque_ref_held));
    /* testing torque while nothing accelerates (5.95), (5.96) */
    const centre_differential_locked_real flange3_torque_steady = s->flange3_torque_held;
    if (s->running <= 0.5) {
        /* the first step, and the first one after a fault, starts anew */
        s->flange3_torque_ref_limited = flange3_torque_steady;
    }
    /* limit of the rate */
    const centre_differential_locked_real flange3_torque_ref_before = s->flange3_torque_ref_limited;
    s->flange3_torque_ref_limited = flange3_torque_ref_before +
        centre_differential_locked_max(-s->flange3_torque_ref_step,
        centre_differential_locked_min(s->flange3_torque_ref_step, -flange3_torque_ref_before +
        s->flange3_torque_ref_held));
    const centre_differential_locked_real M1_speed_error = -s->M1_speed_held + s->M1_speed_ref_limited;
    /* load torque compensation (5.52), (5.74) */
    const centre_differential_locked_real M1_compensation = s->flange1_torque_held;
    /* so that a switch does not jump */
    const centre_differential_locked_real M1_given_away = M1_compensation * (load_compensation_before -
        s->load_compensation_now);
    /* PI speed control (5.84) */
    const centre_differential_locked_real M1_integral_before = s->M1_speed_integral +
        centre_differential_locked_select(p->M1_speed_integral_gain > 0.0, M1_given_away, 0.0);
    const centre_differential_locked_real M1_asked = M1_integral_before + M1_speed_error * p->M1_speed_gain;
    const centre_differential_locked_real M1_wanted = M1_asked + M1_compensation * s->load_compensation_now;
    /* torque-speed envelope */
    const centre_differential_locked_real M1_command = centre_differential_locked_max(M1_least,
        centre_differential_locked_min(M1_most, M1_wanted));
    /* what the limit cuts off */
    const centre_differential_locked_real M1_cut = M1_command - M1_wanted;
    /* conditioning anti-windup (Hanus) */
    s->M1_speed_integral = M1_cut * s->M1_speed_conditioning + M1_integral_before + M1_speed_error *
        s->M1_speed_growth;
    /* net torque on the rotor */
    const centre_differential_locked_real M1_net = M1_command - M1_compensation;
    /* testing torque from the sensors (5.95), (5.96), (5.98) */
    const centre_differential_locked_real flange2_torque_estimate = M1_net * s->M2_unread_M1 +
        flange2_torque_steady;
    if (s->running <= 0.5) {
        /* the first step, and the first one after a fault, starts anew */
        s->M2_model_torque = flange2_torque_steady;
    }
    /* torque model (5.57), (5.76) */
    const centre_differential_locked_real M2_model_before = s->M2_model_torque;
    const centre_differential_locked_real M2_rate_before = s->M2_model_rate;
    s->M2_model_rate = -s->M2_model_drag * M2_rate_before + s->M2_model_pull * (-M2_model_before +
        s->flange2_torque_ref_limited) + M2_rate_before;
    s->M2_model_torque = M2_model_before + s->M2_model_rate * p->sample_time;
    const centre_differential_locked_real M2_torque_error = s->M2_model_torque * p->M2_torque_model -
        flange2_torque_estimate + s->flange2_torque_ref_limited * (1.0 - p->M2_torque_model);
    /* torque control (5.99) */
    const centre_differential_locked_real M2_integral_before = s->M2_torque_integral;
    const centre_differential_locked_real M2_virtual = p->M2_feedforward * s->flange2_torque_ref_limited +
        M2_integral_before + M2_torque_error * p->M2_torque_gain;
    /* testing torque from the sensors (5.95), (5.96), (5.98) */
    const centre_differential_locked_real flange3_torque_estimate = M1_net * s->M3_unread_M1 +
        flange3_torque_steady;
    if (s->running <= 0.5) {
        /* the first step, and the first one after a fault, starts anew */
        s->M3_model_torque = flange3_torque_steady;
    }
    /* torque model (5.57), (5.76) */
    const centre_differential_locked_real M3_model_before = s->M3_model_torque;
    const centre_differential_locked_real M3_rate_before = s->M3_model_rate;
    s->M3_model_rate = -s->M3_model_drag * M3_rate_before + s->M3_model_pull * (-M3_model_before +
        s->flange3_torque_ref_limited) + M3_rate_before;
    s->M3_model_torque = M3_model_before + s->M3_model_rate * p->sample_time;
    const centre_differential_locked_real M3_torque_error = s->M3_model_torque * p->M3_torque_model -
        flange3_torque_estimate + s->flange3_torque_ref_limited * (1.0 - p->M3_torque_model);
    /* torque control (5.99) */
    const centre_differential_locked_real M3_integral_before = s->M3_torque_integral;
    const centre_differential_locked_real M3_virtual = p->M3_feedforward * s->flange3_torque_ref_limited +
        M3_integral_before + M3_torque_error * p->M3_torque_gain;
    /* active damping (5.62), (5.78) */
    const centre_differential_locked_real M2_twist_rate_M2 = s->M1_speed_held * s->M2_twist_M2_M1_speed +
        s->M2_speed_held * s->M2_twist_M2_M2_speed + s->M2_twist_M2_M3_speed * s->M3_speed_held;
    const centre_differential_locked_real M2_twist_rate_M3 = s->M1_speed_held * s->M2_twist_M3_M1_speed +
        s->M2_speed_held * s->M2_twist_M3_M2_speed + s->M2_twist_M3_M3_speed * s->M3_speed_held;
    const centre_differential_locked_real M2_damping_torque = s->M2_damping_now * M2_twist_rate_M2 +
        s->M2_from_flange2_torque * s->flange2_torque_held + s->M2_from_flange3_torque * s->flange3_torque_held +
        M2_twist_rate_M3 * s->M3_damping_now;
    /* with the acceleration torque (5.62), (5.78) */
    const centre_differential_locked_real M2_wanted = M1_net * s->M2_with_M1 * s->acceleration_torque_now +
        s->M2_share_M2 * M2_virtual + s->M2_share_M3 * M3_virtual;
    /* reserve for active damping */
    const centre_differential_locked_real M2_kept = centre_differential_locked_max(M2_least * (1.0 -
        p->M2_damping_reserve), centre_differential_locked_min(M2_wanted, M2_most * (1.0 - p->M2_damping_reserve)));
    /* torque-speed envelope */
    const centre_differential_locked_real M2_command = centre_differential_locked_max(M2_least,
        centre_differential_locked_min(M2_most, M2_damping_torque + M2_kept));
    /* limited integrator */
    s->M2_torque_integral = centre_differential_locked_select(s->M2_share * M2_torque_error * (-M2_kept + M2_wanted)
        > 0.0, M2_integral_before, centre_differential_locked_max(-p->M2_torque_integral_limit,
        centre_differential_locked_min(p->M2_torque_integral_limit, M2_integral_before + M2_torque_error *
        s->M2_torque_growth)));
    /* active damping (5.62), (5.78) */
    const centre_differential_locked_real M3_twist_rate_M2 = s->M1_speed_held * s->M3_twist_M2_M1_speed +
        s->M2_speed_held * s->M3_twist_M2_M2_speed + s->M3_speed_held * s->M3_twist_M2_M3_speed;
    const centre_differential_locked_real M3_twist_rate_M3 = s->M1_speed_held * s->M3_twist_M3_M1_speed +
        s->M2_speed_held * s->M3_twist_M3_M2_speed + s->M3_speed_held * s->M3_twist_M3_M3_speed;
    const centre_differential_locked_real M3_damping_torque = s->M2_damping_now * M3_twist_rate_M2 +
        s->M3_damping_now * M3_twist_rate_M3 + s->M3_from_flange2_torque * s->flange2_torque_held +
        s->M3_from_flange3_torque * s->flange3_torque_held;
    /* with the acceleration torque (5.62), (5.78) */
    const centre_differential_locked_real M3_wanted = M1_net * s->M3_with_M1 * s->acceleration_torque_now +
        M2_virtual * s->M3_share_M2 + s->M3_share_M3 * M3_virtual;
    /* reserve for active damping */
    const centre_differential_locked_real M3_kept = centre_differential_locked_max(M3_least * (1.0 -
        p->M3_damping_reserve), centre_differential_locked_min(M3_wanted, M3_most * (1.0 - p->M3_damping_reserve)));
    /* torque-speed envelope */
    const centre_differential_locked_real M3_command = centre_differential_locked_max(M3_least,
        centre_differential_locked_min(M3_most, M3_damping_torque + M3_kept));
    /* limited integrator */
    s->M3_torque_integral = centre_differential_locked_select(s->M3_share * M3_torque_error * (-M3_kept + M3_wanted)
        > 0.0, M3_integral_before, centre_differential_locked_max(-p->M3_torque_integral_limit,
        centre_differential_locked_min(p->M3_torque_integral_limit, M3_integral_before + M3_torque_error *
        s->M3_torque_growth)));
    /* only sound torques leave */
    centre_differential_locked_real M1_released;
    centre_differential_locked_real M1_released_sound;
    centre_differential_locked_guard(M1_command, s->M1_largest, s->M1_last, &M1_released, &M1_released_sound);
    centre_differential_locked_real M2_released;
    centre_differential_locked_real M2_released_sound;
    centre_differential_locked_guard(M2_command, s->M2_largest, s->M2_last, &M2_released, &M2_released_sound);
    centre_differential_locked_real M3_released;
    centre_differential_locked_real M3_released_sound;
    centre_differential_locked_guard(M3_command, s->M3_largest, s->M3_last, &M3_released, &M3_released_sound);
    /* the first fault is latched */
    centre_differential_locked_real cause_of_commands = 0.0;
    cause_of_commands = centre_differential_locked_select(M3_released_sound > 0.5, cause_of_commands, 7003.0);
    cause_of_commands = centre_differential_locked_select(M2_released_sound > 0.5, cause_of_commands, 7002.0);
    cause_of_commands = centre_differential_locked_select(M1_released_sound > 0.5, cause_of_commands, 7001.0);
    s->fault = centre_differential_locked_select(s->fault > 0.5, s->fault, cause_of_commands);
    /* ramp of the torques */
    const centre_differential_locked_real authority_wanted = s->authority +
        centre_differential_locked_select(s->fault > 0.5, -s->ramp_step, s->ramp_step);
    centre_differential_locked_share(authority_wanted, &s->authority);
    s->running = centre_differential_locked_select(s->fault > 0.5, 0.0, 1.0);
    if (s->fault <= 0.5) {
        s->M1_last = M1_released;
    }
    /* the torque of before */
    const centre_differential_locked_real M1_calmer = s->M1_calm + s->calm_share * (-s->M1_calm + s->M1_last);
    centre_differential_locked_real M1_calm_sound;
    centre_differential_locked_guard(M1_calmer, s->M1_largest, s->M1_calm, &s->M1_calm, &M1_calm_sound);
    if (s->fault > 2999.5) {
        s->M1_last = s->M1_calm;
    }
    if (s->fault <= 0.5) {
        /* ramp of the torques */
        s->M2_last = M2_released;
    }
    /* the torque of before */
    const centre_differential_locked_real M2_calmer = s->M2_calm + s->calm_share * (-s->M2_calm + s->M2_last);
    centre_differential_locked_real M2_calm_sound;
    centre_differential_locked_guard(M2_calmer, s->M2_largest, s->M2_calm, &s->M2_calm, &M2_calm_sound);
    if (s->fault > 2999.5) {
        s->M2_last = s->M2_calm;
    }
    if (s->fault <= 0.5) {
        /* ramp of the torques */
        s->M3_last = M3_released;
    }
    /* the torque of before */
    const centre_differential_locked_real M3_calmer = s->M3_calm + s->calm_share * (-s->M3_calm + s->M3_last);
    centre_differential_locked_real M3_calm_sound;
    centre_differential_locked_guard(M3_calmer, s->M3_largest, s->M3_calm, &s->M3_calm, &M3_calm_sound);
    if (s->fault > 2999.5) {
        s->M3_last = s->M3_calm;
    }
    out->M1_torque_ref = centre_differential_locked_max(-930.0, centre_differential_locked_min(930.0, s->M1_last *
        s->authority));
    out->M2_torque_ref = centre_differential_locked_max(-1200.0, centre_differential_locked_min(1200.0, s->M2_last *
        s->authority));
    out->M3_torque_ref = centre_differential_locked_max(-1200.0, centre_differential_locked_min(1200.0, s->M3_last *
        s->authority));
    /* The last line of defence, should parameters have been changed without an update. */
    if (!centre_differential_locked_is_finite(out->M1_torque_ref + out->M2_torque_ref + out->M3_torque_ref)) {
        if (!centre_differential_locked_is_finite(out->M1_torque_ref)) {
            out->M1_torque_ref = 0.0;
            s->fault = s->fault > 0.0 ? s->fault : CENTRE_DIFFERENTIAL_LOCKED_REAL(centre_differential_locked_controller_fault_M1_torque_ref);
            s->running = 0.0;
        }
        if (!centre_differential_locked_is_finite(out->M2_torque_ref)) {
            out->M2_torque_ref = 0.0;
            s->fault = s->fault > 0.0 ? s->fault : CENTRE_DIFFERENTIAL_LOCKED_REAL(centre_differential_locked_controller_fault_M2_torque_ref);
            s->running = 0.0;
        }
        if (!centre_differential_locked_is_finite(out->M3_torque_ref)) {
            out->M3_torque_ref = 0.0;
            s->fault = s->fault > 0.0 ? s->fault : CENTRE_DIFFERENTIAL_LOCKED_REAL(centre_differential_locked_controller_fault_M3_torque_ref);
            s->running = 0.0;
        }
    }
    return (centre_differential_locked_controller_status)s->fault;
}
