/*
 * all_wheel_drive_controller.c: controller of the bed all_wheel_drive
 *
 * Emitted by ptgen 0.1.0 from all-wheel-drive.toml (SHA-256 4a4f0cf573c3f3c3), template block.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "all_wheel_drive_controller.h"

#include <float.h>
#include <string.h>

const all_wheel_drive_controller_params all_wheel_drive_controller_defaults = {
    .sample_time = 0.0001,
    .fault_ramp = 0.05,
    .hold_time = 0.001,
    .centre_input_torque_ref_plausible = 15000.0,
    .M2_speed_ref_plausible = 471.2388980384685,
    .M3_speed_ref_plausible = 471.2388980384685,
    .M4_speed_ref_plausible = 471.2388980384685,
    .M5_speed_ref_plausible = 471.2388980384685,
    .M1_speed_plausible = 1256.637061435917,
    .flange1_torque_plausible = 15000.0,
    .flange2_torque_plausible = 12000.0,
    .M2_speed_plausible = 471.2388980384685,
    .flange3_torque_plausible = 12000.0,
    .M3_speed_plausible = 471.2388980384685,
    .flange4_torque_plausible = 12000.0,
    .M4_speed_plausible = 471.2388980384685,
    .flange5_torque_plausible = 12000.0,
    .M5_speed_plausible = 471.2388980384685,
    .M1_overspeed = 921.5,
    .M2_overspeed = 345.6,
    .M3_overspeed = 345.6,
    .M4_overspeed = 345.6,
    .M5_overspeed = 345.6,
    .load_compensation = 1.0,
    .acceleration_torque = 1.0,
    .switch_time = 0.5,
    .M1_damping = 96.356,
    .M1_speed_rated = 335.103216382911,
    .M1_speed_max = 837.758040957278,
    .M1_speed_taper = 41.8879,
    .M1_torque_max = 900.0,
    .M2_speed_rated = 104.71975511966,
    .M2_speed_max = 314.159265358979,
    .M2_speed_taper = 15.708,
    .M2_torque_max = 2400.0,
    .M3_speed_rated = 104.71975511966,
    .M3_speed_max = 314.159265358979,
    .M3_speed_taper = 15.708,
    .M3_torque_max = 2400.0,
    .M4_speed_rated = 104.71975511966,
    .M4_speed_max = 314.159265358979,
    .M4_speed_taper = 15.708,
    .M4_torque_max = 2400.0,
    .M5_speed_rated = 104.71975511966,
    .M5_speed_max = 314.159265358979,
    .M5_speed_taper = 15.708,
    .M5_torque_max = 2400.0,
    .disagreement_leak = 5.0,
    .M1_inertia = 0.5,
    .M1_disagreement_limit = 72.0,
    .M1_frozen_limit = 18.0,
    .frozen_time = 0.01,
    .M2_inertia = 2.5,
    .M2_disagreement_limit = 38.4,
    .M2_frozen_limit = 9.6,
    .M3_inertia = 2.5,
    .M3_disagreement_limit = 38.4,
    .M3_frozen_limit = 9.6,
    .M4_inertia = 2.5,
    .M4_disagreement_limit = 38.4,
    .M4_frozen_limit = 9.6,
    .M5_inertia = 2.5,
    .M5_disagreement_limit = 38.4,
    .M5_frozen_limit = 9.6,
    .oscillation_frequency = 9.0,
    .flange1_torque_oscillation_limit = 900.0,
    .flange2_torque_oscillation_limit = 2400.0,
    .flange3_torque_oscillation_limit = 2400.0,
    .flange4_torque_oscillation_limit = 2400.0,
    .flange5_torque_oscillation_limit = 2400.0,
    .M1_torque_ref_oscillation_limit = 450.0,
    .M2_torque_ref_oscillation_limit = 1200.0,
    .M3_torque_ref_oscillation_limit = 1200.0,
    .M4_torque_ref_oscillation_limit = 1200.0,
    .M5_torque_ref_oscillation_limit = 1200.0,
    .M2_speed_ref_rate = 960.0,
    .M3_speed_ref_rate = 960.0,
    .M4_speed_ref_rate = 960.0,
    .M5_speed_ref_rate = 960.0,
    .centre_input_torque_ref_rate = 277950.0,
    .M2_speed_gain = 50.0,
    .M2_speed_integral_gain = 250.0,
    .M3_speed_gain = 50.0,
    .M3_speed_integral_gain = 250.0,
    .M4_speed_gain = 50.0,
    .M4_speed_integral_gain = 250.0,
    .M5_speed_gain = 50.0,
    .M5_speed_integral_gain = 250.0,
    .M1_sensor_inertia_M2 = -0.016,
    .M1_sensor_inertia_M3 = -0.016,
    .M1_sensor_inertia_M4 = -0.016,
    .M1_sensor_inertia_M5 = -0.016,
    .M1_inertia_estimate = 0.52,
    .M1_feedforward = 1.0,
    .M1_torque_gain = 0.0,
    .M1_model_stiffness = 4463.69,
    .M1_model_damping = 96.356,
    .M1_torque_model = 1.0,
    .centre_ratio = 1.0,
    .front_ratio = 3.2,
    .rear_ratio = 3.2,
    .M1_torque_integral_gain = 15.0,
    .M1_damping_reserve = 0.1,
    .M1_torque_integral_limit = 450.0,
};

const all_wheel_drive_controller_params all_wheel_drive_controller_conventional = {
    .sample_time = 0.0001,
    .fault_ramp = 0.05,
    .hold_time = 0.001,
    .centre_input_torque_ref_plausible = 15000.0,
    .M2_speed_ref_plausible = 471.2388980384685,
    .M3_speed_ref_plausible = 471.2388980384685,
    .M4_speed_ref_plausible = 471.2388980384685,
    .M5_speed_ref_plausible = 471.2388980384685,
    .M1_speed_plausible = 1256.637061435917,
    .flange1_torque_plausible = 15000.0,
    .flange2_torque_plausible = 12000.0,
    .M2_speed_plausible = 471.2388980384685,
    .flange3_torque_plausible = 12000.0,
    .M3_speed_plausible = 471.2388980384685,
    .flange4_torque_plausible = 12000.0,
    .M4_speed_plausible = 471.2388980384685,
    .flange5_torque_plausible = 12000.0,
    .M5_speed_plausible = 471.2388980384685,
    .M1_overspeed = 921.5,
    .M2_overspeed = 345.6,
    .M3_overspeed = 345.6,
    .M4_overspeed = 345.6,
    .M5_overspeed = 345.6,
    .load_compensation = 0.0,
    .acceleration_torque = 0.0,
    .switch_time = 0.5,
    .M1_damping = 0.0,
    .M1_speed_rated = 335.103216382911,
    .M1_speed_max = 837.758040957278,
    .M1_speed_taper = 41.8879,
    .M1_torque_max = 900.0,
    .M2_speed_rated = 104.71975511966,
    .M2_speed_max = 314.159265358979,
    .M2_speed_taper = 15.708,
    .M2_torque_max = 2400.0,
    .M3_speed_rated = 104.71975511966,
    .M3_speed_max = 314.159265358979,
    .M3_speed_taper = 15.708,
    .M3_torque_max = 2400.0,
    .M4_speed_rated = 104.71975511966,
    .M4_speed_max = 314.159265358979,
    .M4_speed_taper = 15.708,
    .M4_torque_max = 2400.0,
    .M5_speed_rated = 104.71975511966,
    .M5_speed_max = 314.159265358979,
    .M5_speed_taper = 15.708,
    .M5_torque_max = 2400.0,
    .disagreement_leak = 5.0,
    .M1_inertia = 0.5,
    .M1_disagreement_limit = 72.0,
    .M1_frozen_limit = 18.0,
    .frozen_time = 0.01,
    .M2_inertia = 2.5,
    .M2_disagreement_limit = 38.4,
    .M2_frozen_limit = 9.6,
    .M3_inertia = 2.5,
    .M3_disagreement_limit = 38.4,
    .M3_frozen_limit = 9.6,
    .M4_inertia = 2.5,
    .M4_disagreement_limit = 38.4,
    .M4_frozen_limit = 9.6,
    .M5_inertia = 2.5,
    .M5_disagreement_limit = 38.4,
    .M5_frozen_limit = 9.6,
    .oscillation_frequency = 9.0,
    .flange1_torque_oscillation_limit = 900.0,
    .flange2_torque_oscillation_limit = 2400.0,
    .flange3_torque_oscillation_limit = 2400.0,
    .flange4_torque_oscillation_limit = 2400.0,
    .flange5_torque_oscillation_limit = 2400.0,
    .M1_torque_ref_oscillation_limit = 450.0,
    .M2_torque_ref_oscillation_limit = 1200.0,
    .M3_torque_ref_oscillation_limit = 1200.0,
    .M4_torque_ref_oscillation_limit = 1200.0,
    .M5_torque_ref_oscillation_limit = 1200.0,
    .M2_speed_ref_rate = 960.0,
    .M3_speed_ref_rate = 960.0,
    .M4_speed_ref_rate = 960.0,
    .M5_speed_ref_rate = 960.0,
    .centre_input_torque_ref_rate = 277950.0,
    .M2_speed_gain = 50.0,
    .M2_speed_integral_gain = 250.0,
    .M3_speed_gain = 50.0,
    .M3_speed_integral_gain = 250.0,
    .M4_speed_gain = 50.0,
    .M4_speed_integral_gain = 250.0,
    .M5_speed_gain = 50.0,
    .M5_speed_integral_gain = 250.0,
    .M1_sensor_inertia_M2 = -0.016,
    .M1_sensor_inertia_M3 = -0.016,
    .M1_sensor_inertia_M4 = -0.016,
    .M1_sensor_inertia_M5 = -0.016,
    .M1_inertia_estimate = 0.52,
    .M1_feedforward = 1.0,
    .M1_torque_gain = 0.0,
    .M1_model_stiffness = 4463.69,
    .M1_model_damping = 96.356,
    .M1_torque_model = 0.0,
    .centre_ratio = 1.0,
    .front_ratio = 3.2,
    .rear_ratio = 3.2,
    .M1_torque_integral_gain = 0.397048,
    .M1_damping_reserve = 0.1,
    .M1_torque_integral_limit = 450.0,
};

/* Range of each parameter; `open` excludes the lower bound. The order is that of the status codes. */
static const struct {
    const char *text;
    size_t offset;
    all_wheel_drive_real least;
    all_wheel_drive_real most;
    int open;
    int not_zero;
} limits[] = {
    { "the parameter sample_time is outside its range", offsetof(all_wheel_drive_controller_params, sample_time), 0.0, DBL_MAX, 1, 0 },
    { "the parameter fault_ramp is outside its range", offsetof(all_wheel_drive_controller_params, fault_ramp), 0.0, DBL_MAX, 1, 0 },
    { "the parameter hold_time is outside its range", offsetof(all_wheel_drive_controller_params, hold_time), 0.0, DBL_MAX, 0, 0 },
    { "the parameter centre_input_torque_ref_plausible is outside its range", offsetof(all_wheel_drive_controller_params, centre_input_torque_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_ref_plausible is outside its range", offsetof(all_wheel_drive_controller_params, M2_speed_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_ref_plausible is outside its range", offsetof(all_wheel_drive_controller_params, M3_speed_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M4_speed_ref_plausible is outside its range", offsetof(all_wheel_drive_controller_params, M4_speed_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M5_speed_ref_plausible is outside its range", offsetof(all_wheel_drive_controller_params, M5_speed_ref_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_plausible is outside its range", offsetof(all_wheel_drive_controller_params, M1_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_torque_plausible is outside its range", offsetof(all_wheel_drive_controller_params, flange1_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_torque_plausible is outside its range", offsetof(all_wheel_drive_controller_params, flange2_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_plausible is outside its range", offsetof(all_wheel_drive_controller_params, M2_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_torque_plausible is outside its range", offsetof(all_wheel_drive_controller_params, flange3_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_plausible is outside its range", offsetof(all_wheel_drive_controller_params, M3_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange4_torque_plausible is outside its range", offsetof(all_wheel_drive_controller_params, flange4_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M4_speed_plausible is outside its range", offsetof(all_wheel_drive_controller_params, M4_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange5_torque_plausible is outside its range", offsetof(all_wheel_drive_controller_params, flange5_torque_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M5_speed_plausible is outside its range", offsetof(all_wheel_drive_controller_params, M5_speed_plausible), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_overspeed is outside its range", offsetof(all_wheel_drive_controller_params, M1_overspeed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_overspeed is outside its range", offsetof(all_wheel_drive_controller_params, M2_overspeed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_overspeed is outside its range", offsetof(all_wheel_drive_controller_params, M3_overspeed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M4_overspeed is outside its range", offsetof(all_wheel_drive_controller_params, M4_overspeed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M5_overspeed is outside its range", offsetof(all_wheel_drive_controller_params, M5_overspeed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter load_compensation is outside its range", offsetof(all_wheel_drive_controller_params, load_compensation), 0.0, 1.0, 0, 0 },
    { "the parameter acceleration_torque is outside its range", offsetof(all_wheel_drive_controller_params, acceleration_torque), 0.0, 1.0, 0, 0 },
    { "the parameter switch_time is outside its range", offsetof(all_wheel_drive_controller_params, switch_time), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_damping is outside its range", offsetof(all_wheel_drive_controller_params, M1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_speed_rated is outside its range", offsetof(all_wheel_drive_controller_params, M1_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_max is outside its range", offsetof(all_wheel_drive_controller_params, M1_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_taper is outside its range", offsetof(all_wheel_drive_controller_params, M1_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_max is outside its range", offsetof(all_wheel_drive_controller_params, M1_torque_max), 0.0, 900.0, 1, 0 },
    { "the parameter M2_speed_rated is outside its range", offsetof(all_wheel_drive_controller_params, M2_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_max is outside its range", offsetof(all_wheel_drive_controller_params, M2_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_taper is outside its range", offsetof(all_wheel_drive_controller_params, M2_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_max is outside its range", offsetof(all_wheel_drive_controller_params, M2_torque_max), 0.0, 2400.0, 1, 0 },
    { "the parameter M3_speed_rated is outside its range", offsetof(all_wheel_drive_controller_params, M3_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_max is outside its range", offsetof(all_wheel_drive_controller_params, M3_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_taper is outside its range", offsetof(all_wheel_drive_controller_params, M3_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_torque_max is outside its range", offsetof(all_wheel_drive_controller_params, M3_torque_max), 0.0, 2400.0, 1, 0 },
    { "the parameter M4_speed_rated is outside its range", offsetof(all_wheel_drive_controller_params, M4_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M4_speed_max is outside its range", offsetof(all_wheel_drive_controller_params, M4_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M4_speed_taper is outside its range", offsetof(all_wheel_drive_controller_params, M4_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M4_torque_max is outside its range", offsetof(all_wheel_drive_controller_params, M4_torque_max), 0.0, 2400.0, 1, 0 },
    { "the parameter M5_speed_rated is outside its range", offsetof(all_wheel_drive_controller_params, M5_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M5_speed_max is outside its range", offsetof(all_wheel_drive_controller_params, M5_speed_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M5_speed_taper is outside its range", offsetof(all_wheel_drive_controller_params, M5_speed_taper), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M5_torque_max is outside its range", offsetof(all_wheel_drive_controller_params, M5_torque_max), 0.0, 2400.0, 1, 0 },
    { "the parameter disagreement_leak is outside its range", offsetof(all_wheel_drive_controller_params, disagreement_leak), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_inertia is outside its range", offsetof(all_wheel_drive_controller_params, M1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_disagreement_limit is outside its range", offsetof(all_wheel_drive_controller_params, M1_disagreement_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_frozen_limit is outside its range", offsetof(all_wheel_drive_controller_params, M1_frozen_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter frozen_time is outside its range", offsetof(all_wheel_drive_controller_params, frozen_time), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_inertia is outside its range", offsetof(all_wheel_drive_controller_params, M2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_disagreement_limit is outside its range", offsetof(all_wheel_drive_controller_params, M2_disagreement_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_frozen_limit is outside its range", offsetof(all_wheel_drive_controller_params, M2_frozen_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_inertia is outside its range", offsetof(all_wheel_drive_controller_params, M3_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_disagreement_limit is outside its range", offsetof(all_wheel_drive_controller_params, M3_disagreement_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_frozen_limit is outside its range", offsetof(all_wheel_drive_controller_params, M3_frozen_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M4_inertia is outside its range", offsetof(all_wheel_drive_controller_params, M4_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M4_disagreement_limit is outside its range", offsetof(all_wheel_drive_controller_params, M4_disagreement_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M4_frozen_limit is outside its range", offsetof(all_wheel_drive_controller_params, M4_frozen_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M5_inertia is outside its range", offsetof(all_wheel_drive_controller_params, M5_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M5_disagreement_limit is outside its range", offsetof(all_wheel_drive_controller_params, M5_disagreement_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M5_frozen_limit is outside its range", offsetof(all_wheel_drive_controller_params, M5_frozen_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter oscillation_frequency is outside its range", offsetof(all_wheel_drive_controller_params, oscillation_frequency), 0.0, DBL_MAX, 0, 0 },
    { "the parameter flange1_torque_oscillation_limit is outside its range", offsetof(all_wheel_drive_controller_params, flange1_torque_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_torque_oscillation_limit is outside its range", offsetof(all_wheel_drive_controller_params, flange2_torque_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_torque_oscillation_limit is outside its range", offsetof(all_wheel_drive_controller_params, flange3_torque_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange4_torque_oscillation_limit is outside its range", offsetof(all_wheel_drive_controller_params, flange4_torque_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange5_torque_oscillation_limit is outside its range", offsetof(all_wheel_drive_controller_params, flange5_torque_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_ref_oscillation_limit is outside its range", offsetof(all_wheel_drive_controller_params, M1_torque_ref_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_ref_oscillation_limit is outside its range", offsetof(all_wheel_drive_controller_params, M2_torque_ref_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_torque_ref_oscillation_limit is outside its range", offsetof(all_wheel_drive_controller_params, M3_torque_ref_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M4_torque_ref_oscillation_limit is outside its range", offsetof(all_wheel_drive_controller_params, M4_torque_ref_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M5_torque_ref_oscillation_limit is outside its range", offsetof(all_wheel_drive_controller_params, M5_torque_ref_oscillation_limit), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_ref_rate is outside its range", offsetof(all_wheel_drive_controller_params, M2_speed_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_ref_rate is outside its range", offsetof(all_wheel_drive_controller_params, M3_speed_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M4_speed_ref_rate is outside its range", offsetof(all_wheel_drive_controller_params, M4_speed_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M5_speed_ref_rate is outside its range", offsetof(all_wheel_drive_controller_params, M5_speed_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter centre_input_torque_ref_rate is outside its range", offsetof(all_wheel_drive_controller_params, centre_input_torque_ref_rate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_gain is outside its range", offsetof(all_wheel_drive_controller_params, M2_speed_gain), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_integral_gain is outside its range", offsetof(all_wheel_drive_controller_params, M2_speed_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M3_speed_gain is outside its range", offsetof(all_wheel_drive_controller_params, M3_speed_gain), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_integral_gain is outside its range", offsetof(all_wheel_drive_controller_params, M3_speed_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M4_speed_gain is outside its range", offsetof(all_wheel_drive_controller_params, M4_speed_gain), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M4_speed_integral_gain is outside its range", offsetof(all_wheel_drive_controller_params, M4_speed_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M5_speed_gain is outside its range", offsetof(all_wheel_drive_controller_params, M5_speed_gain), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M5_speed_integral_gain is outside its range", offsetof(all_wheel_drive_controller_params, M5_speed_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_sensor_inertia_M2 is outside its range", offsetof(all_wheel_drive_controller_params, M1_sensor_inertia_M2), -DBL_MAX, DBL_MAX, 0, 0 },
    { "the parameter M1_sensor_inertia_M3 is outside its range", offsetof(all_wheel_drive_controller_params, M1_sensor_inertia_M3), -DBL_MAX, DBL_MAX, 0, 0 },
    { "the parameter M1_sensor_inertia_M4 is outside its range", offsetof(all_wheel_drive_controller_params, M1_sensor_inertia_M4), -DBL_MAX, DBL_MAX, 0, 0 },
    { "the parameter M1_sensor_inertia_M5 is outside its range", offsetof(all_wheel_drive_controller_params, M1_sensor_inertia_M5), -DBL_MAX, DBL_MAX, 0, 0 },
    { "the parameter M1_inertia_estimate is outside its range", offsetof(all_wheel_drive_controller_params, M1_inertia_estimate), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_feedforward is outside its range", offsetof(all_wheel_drive_controller_params, M1_feedforward), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_torque_gain is outside its range", offsetof(all_wheel_drive_controller_params, M1_torque_gain), -1.0, DBL_MAX, 1, 0 },
    { "the parameter M1_model_stiffness is outside its range", offsetof(all_wheel_drive_controller_params, M1_model_stiffness), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_model_damping is outside its range", offsetof(all_wheel_drive_controller_params, M1_model_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_torque_model is outside its range", offsetof(all_wheel_drive_controller_params, M1_torque_model), 0.0, 1.0, 0, 0 },
    { "the parameter centre_ratio is outside its range", offsetof(all_wheel_drive_controller_params, centre_ratio), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter front_ratio is outside its range", offsetof(all_wheel_drive_controller_params, front_ratio), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter rear_ratio is outside its range", offsetof(all_wheel_drive_controller_params, rear_ratio), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter M1_torque_integral_gain is outside its range", offsetof(all_wheel_drive_controller_params, M1_torque_integral_gain), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M1_damping_reserve is outside its range", offsetof(all_wheel_drive_controller_params, M1_damping_reserve), 0.0, 1.0, 0, 0 },
    { "the parameter M1_torque_integral_limit is outside its range", offsetof(all_wheel_drive_controller_params, M1_torque_integral_limit), 0.0, DBL_MAX, 0, 0 },
};

enum { limit_count = sizeof limits / sizeof limits[0] };

const char *all_wheel_drive_controller_status_text(all_wheel_drive_controller_status status)
{
    switch ((int)status) {
    case all_wheel_drive_controller_ok:
        return "ok";
    case all_wheel_drive_controller_fault_centre_input_torque_ref:
        return "centre_input_torque_ref: not finite or not plausible";
    case all_wheel_drive_controller_fault_M2_speed_ref:
        return "M2_speed_ref: not finite or not plausible";
    case all_wheel_drive_controller_fault_M3_speed_ref:
        return "M3_speed_ref: not finite or not plausible";
    case all_wheel_drive_controller_fault_M4_speed_ref:
        return "M4_speed_ref: not finite or not plausible";
    case all_wheel_drive_controller_fault_M5_speed_ref:
        return "M5_speed_ref: not finite or not plausible";
    case all_wheel_drive_controller_fault_M1_speed:
        return "M1_speed: not finite or not plausible";
    case all_wheel_drive_controller_fault_flange1_torque:
        return "flange1_torque: not finite or not plausible";
    case all_wheel_drive_controller_fault_flange2_torque:
        return "flange2_torque: not finite or not plausible";
    case all_wheel_drive_controller_fault_M2_speed:
        return "M2_speed: not finite or not plausible";
    case all_wheel_drive_controller_fault_flange3_torque:
        return "flange3_torque: not finite or not plausible";
    case all_wheel_drive_controller_fault_M3_speed:
        return "M3_speed: not finite or not plausible";
    case all_wheel_drive_controller_fault_flange4_torque:
        return "flange4_torque: not finite or not plausible";
    case all_wheel_drive_controller_fault_M4_speed:
        return "M4_speed: not finite or not plausible";
    case all_wheel_drive_controller_fault_flange5_torque:
        return "flange5_torque: not finite or not plausible";
    case all_wheel_drive_controller_fault_M5_speed:
        return "M5_speed: not finite or not plausible";
    case all_wheel_drive_controller_fault_M1_speed_overspeed:
        return "M1_speed: overspeed";
    case all_wheel_drive_controller_fault_M2_speed_overspeed:
        return "M2_speed: overspeed";
    case all_wheel_drive_controller_fault_M3_speed_overspeed:
        return "M3_speed: overspeed";
    case all_wheel_drive_controller_fault_M4_speed_overspeed:
        return "M4_speed: overspeed";
    case all_wheel_drive_controller_fault_M5_speed_overspeed:
        return "M5_speed: overspeed";
    case all_wheel_drive_controller_fault_M1_speed_frozen:
        return "M1_speed: frozen while the torques accelerate the machine";
    case all_wheel_drive_controller_fault_M1_speed_disagreement:
        return "M1_speed: disagrees with the integrated torque";
    case all_wheel_drive_controller_fault_flange1_torque_frozen:
        return "flange1_torque: frozen while the torque of the machine changes";
    case all_wheel_drive_controller_fault_M2_speed_frozen:
        return "M2_speed: frozen while the torques accelerate the machine";
    case all_wheel_drive_controller_fault_M2_speed_disagreement:
        return "M2_speed: disagrees with the integrated torque";
    case all_wheel_drive_controller_fault_flange2_torque_frozen:
        return "flange2_torque: frozen while the torque of the machine changes";
    case all_wheel_drive_controller_fault_M3_speed_frozen:
        return "M3_speed: frozen while the torques accelerate the machine";
    case all_wheel_drive_controller_fault_M3_speed_disagreement:
        return "M3_speed: disagrees with the integrated torque";
    case all_wheel_drive_controller_fault_flange3_torque_frozen:
        return "flange3_torque: frozen while the torque of the machine changes";
    case all_wheel_drive_controller_fault_M4_speed_frozen:
        return "M4_speed: frozen while the torques accelerate the machine";
    case all_wheel_drive_controller_fault_M4_speed_disagreement:
        return "M4_speed: disagrees with the integrated torque";
    case all_wheel_drive_controller_fault_flange4_torque_frozen:
        return "flange4_torque: frozen while the torque of the machine changes";
    case all_wheel_drive_controller_fault_M5_speed_frozen:
        return "M5_speed: frozen while the torques accelerate the machine";
    case all_wheel_drive_controller_fault_M5_speed_disagreement:
        return "M5_speed: disagrees with the integrated torque";
    case all_wheel_drive_controller_fault_flange5_torque_frozen:
        return "flange5_torque: frozen while the torque of the machine changes";
    case all_wheel_drive_controller_fault_flange1_torque_oscillation:
        return "flange1_torque: oscillates beyond its limit";
    case all_wheel_drive_controller_fault_flange2_torque_oscillation:
        return "flange2_torque: oscillates beyond its limit";
    case all_wheel_drive_controller_fault_flange3_torque_oscillation:
        return "flange3_torque: oscillates beyond its limit";
    case all_wheel_drive_controller_fault_flange4_torque_oscillation:
        return "flange4_torque: oscillates beyond its limit";
    case all_wheel_drive_controller_fault_flange5_torque_oscillation:
        return "flange5_torque: oscillates beyond its limit";
    case all_wheel_drive_controller_fault_M1_torque_ref_oscillation:
        return "M1_torque_ref: the command oscillates";
    case all_wheel_drive_controller_fault_M2_torque_ref_oscillation:
        return "M2_torque_ref: the command oscillates";
    case all_wheel_drive_controller_fault_M3_torque_ref_oscillation:
        return "M3_torque_ref: the command oscillates";
    case all_wheel_drive_controller_fault_M4_torque_ref_oscillation:
        return "M4_torque_ref: the command oscillates";
    case all_wheel_drive_controller_fault_M5_torque_ref_oscillation:
        return "M5_torque_ref: the command oscillates";
    case all_wheel_drive_controller_fault_M1_torque_ref:
        return "M1_torque_ref: the command is not finite, or beyond the torque of the machine";
    case all_wheel_drive_controller_fault_M2_torque_ref:
        return "M2_torque_ref: the command is not finite, or beyond the torque of the machine";
    case all_wheel_drive_controller_fault_M3_torque_ref:
        return "M3_torque_ref: the command is not finite, or beyond the torque of the machine";
    case all_wheel_drive_controller_fault_M4_torque_ref:
        return "M4_torque_ref: the command is not finite, or beyond the torque of the machine";
    case all_wheel_drive_controller_fault_M5_torque_ref:
        return "M5_torque_ref: the command is not finite, or beyond the torque of the machine";
    default:
        break;
    }
    const int limit = (int)status - 2000;
    return limit >= 0 && limit < limit_count ? limits[limit].text : "unknown status";
}

all_wheel_drive_controller_status all_wheel_drive_controller_init(all_wheel_drive_controller_state *s, const all_wheel_drive_controller_params *p)
{
    memset(s, 0, sizeof *s);
    s->authority = 1.0;
    s->centre_input_torque_ref_bad_time = 1e+30;
    s->M2_speed_ref_bad_time = 1e+30;
    s->M3_speed_ref_bad_time = 1e+30;
    s->M4_speed_ref_bad_time = 1e+30;
    s->M5_speed_ref_bad_time = 1e+30;
    s->M1_speed_bad_time = 1e+30;
    s->flange1_torque_bad_time = 1e+30;
    s->flange2_torque_bad_time = 1e+30;
    s->M2_speed_bad_time = 1e+30;
    s->flange3_torque_bad_time = 1e+30;
    s->M3_speed_bad_time = 1e+30;
    s->flange4_torque_bad_time = 1e+30;
    s->M4_speed_bad_time = 1e+30;
    s->flange5_torque_bad_time = 1e+30;
    s->M5_speed_bad_time = 1e+30;
    s->reset_before = 1.0;
    const all_wheel_drive_controller_status status = all_wheel_drive_controller_update(s, p);
    if (status != all_wheel_drive_controller_ok) {
        s->authority = 0.0; /* never started: no torque at all */
    }
    return status;
}

all_wheel_drive_controller_status all_wheel_drive_controller_update(all_wheel_drive_controller_state *s, const all_wheel_drive_controller_params *p)
{
    for (int k = 0; k < limit_count; ++k) {
        const all_wheel_drive_real value = *(const all_wheel_drive_real *)(const void *)((const char *)p + limits[k].offset);
        const int above = limits[k].open ? value > limits[k].least : value >= limits[k].least; /* false for NaN */
        if (!(above && value <= limits[k].most) || (limits[k].not_zero && value == 0.0)) {
            s->fault = s->fault > 0.0 ? s->fault : ALL_WHEEL_DRIVE_REAL(2000 + k); /* latched like any fault */
            s->refused = 1.0; /* no reset before an update succeeds */
            return (all_wheel_drive_controller_status)(2000 + k);
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
    s->M4_taper_slope = 1.0 / p->M4_speed_taper;
    s->M4_taper_end = p->M4_speed_max / p->M4_speed_taper + 1.0;
    s->M4_power = p->M4_speed_rated * p->M4_torque_max;
    s->M5_taper_slope = 1.0 / p->M5_speed_taper;
    s->M5_taper_end = p->M5_speed_max / p->M5_speed_taper + 1.0;
    s->M5_power = p->M5_speed_rated * p->M5_torque_max;
    s->disagreement_share = p->disagreement_leak * p->sample_time;
    s->M1_per_step = p->sample_time / p->M1_inertia;
    s->M1_moved_torque = 0.05 * p->M1_torque_max;
    s->M2_per_step = p->sample_time / p->M2_inertia;
    s->M2_moved_torque = 0.05 * p->M2_torque_max;
    s->M3_per_step = p->sample_time / p->M3_inertia;
    s->M3_moved_torque = 0.05 * p->M3_torque_max;
    s->M4_per_step = p->sample_time / p->M4_inertia;
    s->M4_moved_torque = 0.05 * p->M4_torque_max;
    s->M5_per_step = p->sample_time / p->M5_inertia;
    s->M5_moved_torque = 0.05 * p->M5_torque_max;
    s->forgotten_swings = p->oscillation_frequency * p->sample_time;
    s->mean_share = 6.2832 * p->oscillation_frequency * p->sample_time;
    s->M2_speed_ref_step = p->M2_speed_ref_rate * p->sample_time;
    s->M3_speed_ref_step = p->M3_speed_ref_rate * p->sample_time;
    s->M4_speed_ref_step = p->M4_speed_ref_rate * p->sample_time;
    s->M5_speed_ref_step = p->M5_speed_ref_rate * p->sample_time;
    s->centre_input_torque_ref_step = p->centre_input_torque_ref_rate * p->sample_time;
    s->M2_speed_growth = p->M2_speed_integral_gain * p->sample_time;
    s->M2_speed_conditioning = p->M2_speed_integral_gain * p->sample_time / p->M2_speed_gain;
    s->M3_speed_growth = p->M3_speed_integral_gain * p->sample_time;
    s->M3_speed_conditioning = p->M3_speed_integral_gain * p->sample_time / p->M3_speed_gain;
    s->M4_speed_growth = p->M4_speed_integral_gain * p->sample_time;
    s->M4_speed_conditioning = p->M4_speed_integral_gain * p->sample_time / p->M4_speed_gain;
    s->M5_speed_growth = p->M5_speed_integral_gain * p->sample_time;
    s->M5_speed_conditioning = p->M5_speed_integral_gain * p->sample_time / p->M5_speed_gain;
    s->M1_unread_M2 = p->M1_sensor_inertia_M2 / p->M2_inertia;
    s->M1_unread_M3 = p->M1_sensor_inertia_M3 / p->M3_inertia;
    s->M1_unread_M4 = p->M1_sensor_inertia_M4 / p->M4_inertia;
    s->M1_unread_M5 = p->M1_sensor_inertia_M5 / p->M5_inertia;
    s->M1_model_pull = p->M1_model_stiffness * p->sample_time / p->M1_inertia_estimate;
    s->M1_model_drag = p->M1_model_damping * p->sample_time / p->M1_inertia_estimate;
    s->M1_with_M2 = (0.25) * p->M1_inertia_estimate * p->centre_ratio * p->front_ratio / p->M2_inertia;
    s->M1_with_M3 = (0.25) * p->M1_inertia_estimate * p->centre_ratio * p->front_ratio / p->M3_inertia;
    s->M1_with_M4 = (0.25) * p->M1_inertia_estimate * p->centre_ratio * p->rear_ratio / p->M4_inertia;
    s->M1_with_M5 = (0.25) * p->M1_inertia_estimate * p->centre_ratio * p->rear_ratio / p->M5_inertia;
    s->M1_twist_M1_M2_speed = (0.25) * p->centre_ratio * p->front_ratio;
    s->M1_twist_M1_M3_speed = (0.25) * p->centre_ratio * p->front_ratio;
    s->M1_twist_M1_M4_speed = (0.25) * p->centre_ratio * p->rear_ratio;
    s->M1_twist_M1_M5_speed = (0.25) * p->centre_ratio * p->rear_ratio;
    s->M1_torque_growth = p->M1_torque_integral_gain * p->sample_time;
    s->M1_largest = 1.01 * all_wheel_drive_min(900.0, p->M1_torque_max);
    s->M2_largest = 1.01 * all_wheel_drive_min(2400.0, p->M2_torque_max);
    s->M3_largest = 1.01 * all_wheel_drive_min(2400.0, p->M3_torque_max);
    s->M4_largest = 1.01 * all_wheel_drive_min(2400.0, p->M4_torque_max);
    s->M5_largest = 1.01 * all_wheel_drive_min(2400.0, p->M5_torque_max);
    s->ramp_step = p->sample_time / p->fault_ramp;
    s->calm_share = p->sample_time / (p->sample_time + 0.02);
    s->refused = 0.0;
    return all_wheel_drive_controller_ok;
}

all_wheel_drive_controller_status all_wheel_drive_controller_step(all_wheel_drive_controller_state *s, const all_wheel_drive_controller_params *p,
    const all_wheel_drive_controller_inputs *in, all_wheel_drive_controller_outputs *out)
{
    /* supervision: bad samples are bridged */
    all_wheel_drive_real centre_input_torque_ref_sound;
    all_wheel_drive_guard(in->centre_input_torque_ref, p->centre_input_torque_ref_plausible,
        s->centre_input_torque_ref_held, &s->centre_input_torque_ref_held, &centre_input_torque_ref_sound);
    all_wheel_drive_lasting(centre_input_torque_ref_sound, s->centre_input_torque_ref_bad_time, p->sample_time,
        p->hold_time, &s->centre_input_torque_ref_bad_time);
    all_wheel_drive_real M2_speed_ref_sound;
    all_wheel_drive_guard(in->M2_speed_ref, p->M2_speed_ref_plausible, s->M2_speed_ref_held, &s->M2_speed_ref_held,
        &M2_speed_ref_sound);
    all_wheel_drive_lasting(M2_speed_ref_sound, s->M2_speed_ref_bad_time, p->sample_time, p->hold_time,
        &s->M2_speed_ref_bad_time);
    all_wheel_drive_real M3_speed_ref_sound;
    all_wheel_drive_guard(in->M3_speed_ref, p->M3_speed_ref_plausible, s->M3_speed_ref_held, &s->M3_speed_ref_held,
        &M3_speed_ref_sound);
    all_wheel_drive_lasting(M3_speed_ref_sound, s->M3_speed_ref_bad_time, p->sample_time, p->hold_time,
        &s->M3_speed_ref_bad_time);
    all_wheel_drive_real M4_speed_ref_sound;
    all_wheel_drive_guard(in->M4_speed_ref, p->M4_speed_ref_plausible, s->M4_speed_ref_held, &s->M4_speed_ref_held,
        &M4_speed_ref_sound);
    all_wheel_drive_lasting(M4_speed_ref_sound, s->M4_speed_ref_bad_time, p->sample_time, p->hold_time,
        &s->M4_speed_ref_bad_time);
    all_wheel_drive_real M5_speed_ref_sound;
    all_wheel_drive_guard(in->M5_speed_ref, p->M5_speed_ref_plausible, s->M5_speed_ref_held, &s->M5_speed_ref_held,
        &M5_speed_ref_sound);
    all_wheel_drive_lasting(M5_speed_ref_sound, s->M5_speed_ref_bad_time, p->sample_time, p->hold_time,
        &s->M5_speed_ref_bad_time);
    all_wheel_drive_real M1_speed_sound;
    all_wheel_drive_guard(in->M1_speed, p->M1_speed_plausible, s->M1_speed_held, &s->M1_speed_held,
        &M1_speed_sound);
    all_wheel_drive_lasting(M1_speed_sound, s->M1_speed_bad_time, p->sample_time, p->hold_time,
        &s->M1_speed_bad_time);
    all_wheel_drive_real flange1_torque_sound;
    all_wheel_drive_guard(in->flange1_torque, p->flange1_torque_plausible, s->flange1_torque_held,
        &s->flange1_torque_held, &flange1_torque_sound);
    all_wheel_drive_lasting(flange1_torque_sound, s->flange1_torque_bad_time, p->sample_time, p->hold_time,
        &s->flange1_torque_bad_time);
    all_wheel_drive_real flange2_torque_sound;
    all_wheel_drive_guard(in->flange2_torque, p->flange2_torque_plausible, s->flange2_torque_held,
        &s->flange2_torque_held, &flange2_torque_sound);
    all_wheel_drive_lasting(flange2_torque_sound, s->flange2_torque_bad_time, p->sample_time, p->hold_time,
        &s->flange2_torque_bad_time);
    all_wheel_drive_real M2_speed_sound;
    all_wheel_drive_guard(in->M2_speed, p->M2_speed_plausible, s->M2_speed_held, &s->M2_speed_held,
        &M2_speed_sound);
    all_wheel_drive_lasting(M2_speed_sound, s->M2_speed_bad_time, p->sample_time, p->hold_time,
        &s->M2_speed_bad_time);
    all_wheel_drive_real flange3_torque_sound;
    all_wheel_drive_guard(in->flange3_torque, p->flange3_torque_plausible, s->flange3_torque_held,
        &s->flange3_torque_held, &flange3_torque_sound);
    all_wheel_drive_lasting(flange3_torque_sound, s->flange3_torque_bad_time, p->sample_time, p->hold_time,
        &s->flange3_torque_bad_time);
    all_wheel_drive_real M3_speed_sound;
    all_wheel_drive_guard(in->M3_speed, p->M3_speed_plausible, s->M3_speed_held, &s->M3_speed_held,
        &M3_speed_sound);
    all_wheel_drive_lasting(M3_speed_sound, s->M3_speed_bad_time, p->sample_time, p->hold_time,
        &s->M3_speed_bad_time);
    all_wheel_drive_real flange4_torque_sound;
    all_wheel_drive_guard(in->flange4_torque, p->flange4_torque_plausible, s->flange4_torque_held,
        &s->flange4_torque_held, &flange4_torque_sound);
    all_wheel_drive_lasting(flange4_torque_sound, s->flange4_torque_bad_time, p->sample_time, p->hold_time,
        &s->flange4_torque_bad_time);
    all_wheel_drive_real M4_speed_sound;
    all_wheel_drive_guard(in->M4_speed, p->M4_speed_plausible, s->M4_speed_held, &s->M4_speed_held,
        &M4_speed_sound);
    all_wheel_drive_lasting(M4_speed_sound, s->M4_speed_bad_time, p->sample_time, p->hold_time,
        &s->M4_speed_bad_time);
    all_wheel_drive_real flange5_torque_sound;
    all_wheel_drive_guard(in->flange5_torque, p->flange5_torque_plausible, s->flange5_torque_held,
        &s->flange5_torque_held, &flange5_torque_sound);
    all_wheel_drive_lasting(flange5_torque_sound, s->flange5_torque_bad_time, p->sample_time, p->hold_time,
        &s->flange5_torque_bad_time);
    all_wheel_drive_real M5_speed_sound;
    all_wheel_drive_guard(in->M5_speed, p->M5_speed_plausible, s->M5_speed_held, &s->M5_speed_held,
        &M5_speed_sound);
    all_wheel_drive_lasting(M5_speed_sound, s->M5_speed_bad_time, p->sample_time, p->hold_time,
        &s->M5_speed_bad_time);
    /* overspeed */
    const all_wheel_drive_real M1_slow_enough = all_wheel_drive_select(p->M1_overspeed >=
        all_wheel_drive_abs(s->M1_speed_held), 1.0, 0.0);
    all_wheel_drive_lasting(M1_slow_enough, s->M1_overspeed_time, p->sample_time, p->hold_time,
        &s->M1_overspeed_time);
    const all_wheel_drive_real M2_slow_enough = all_wheel_drive_select(p->M2_overspeed >=
        all_wheel_drive_abs(s->M2_speed_held), 1.0, 0.0);
    all_wheel_drive_lasting(M2_slow_enough, s->M2_overspeed_time, p->sample_time, p->hold_time,
        &s->M2_overspeed_time);
    const all_wheel_drive_real M3_slow_enough = all_wheel_drive_select(p->M3_overspeed >=
        all_wheel_drive_abs(s->M3_speed_held), 1.0, 0.0);
    all_wheel_drive_lasting(M3_slow_enough, s->M3_overspeed_time, p->sample_time, p->hold_time,
        &s->M3_overspeed_time);
    const all_wheel_drive_real M4_slow_enough = all_wheel_drive_select(p->M4_overspeed >=
        all_wheel_drive_abs(s->M4_speed_held), 1.0, 0.0);
    all_wheel_drive_lasting(M4_slow_enough, s->M4_overspeed_time, p->sample_time, p->hold_time,
        &s->M4_overspeed_time);
    const all_wheel_drive_real M5_slow_enough = all_wheel_drive_select(p->M5_overspeed >=
        all_wheel_drive_abs(s->M5_speed_held), 1.0, 0.0);
    all_wheel_drive_lasting(M5_slow_enough, s->M5_overspeed_time, p->sample_time, p->hold_time,
        &s->M5_overspeed_time);
    /* reset on request, when the cause is gone */
    const all_wheel_drive_real reset_pressed = all_wheel_drive_select(all_wheel_drive_abs(in->reset - 1.0) <= 0.5,
        1.0, 0.0);
    s->reset_request = all_wheel_drive_select(s->fault > 0.5, all_wheel_drive_select(p->M1_overspeed >=
        all_wheel_drive_abs(s->M1_speed_held) && p->M1_speed_plausible >= all_wheel_drive_abs(in->M1_speed) &&
        p->M2_overspeed >= all_wheel_drive_abs(s->M2_speed_held) && p->M2_speed_plausible >=
        all_wheel_drive_abs(in->M2_speed) && p->M2_speed_ref_plausible >= all_wheel_drive_abs(in->M2_speed_ref) &&
        p->M3_overspeed >= all_wheel_drive_abs(s->M3_speed_held) && p->M3_speed_plausible >=
        all_wheel_drive_abs(in->M3_speed) && p->M3_speed_ref_plausible >= all_wheel_drive_abs(in->M3_speed_ref) &&
        p->M4_overspeed >= all_wheel_drive_abs(s->M4_speed_held) && p->M4_speed_plausible >=
        all_wheel_drive_abs(in->M4_speed) && p->M4_speed_ref_plausible >= all_wheel_drive_abs(in->M4_speed_ref) &&
        p->M5_overspeed >= all_wheel_drive_abs(s->M5_speed_held) && p->M5_speed_plausible >=
        all_wheel_drive_abs(in->M5_speed) && p->M5_speed_ref_plausible >= all_wheel_drive_abs(in->M5_speed_ref) &&
        p->centre_input_torque_ref_plausible >= all_wheel_drive_abs(in->centre_input_torque_ref) &&
        p->flange1_torque_plausible >= all_wheel_drive_abs(in->flange1_torque) && p->flange2_torque_plausible >=
        all_wheel_drive_abs(in->flange2_torque) && p->flange3_torque_plausible >=
        all_wheel_drive_abs(in->flange3_torque) && p->flange4_torque_plausible >=
        all_wheel_drive_abs(in->flange4_torque) && p->flange5_torque_plausible >=
        all_wheel_drive_abs(in->flange5_torque), (1.0 - s->refused) * all_wheel_drive_max(s->reset_request,
        -s->reset_before + reset_pressed), 0.0), 0.0);
    s->reset_before = reset_pressed;
    s->fault = s->fault * (1.0 - all_wheel_drive_select(s->authority <= 0.0, s->reset_request, 0.0));
    s->reset_request = all_wheel_drive_select(s->fault > 0.5, s->reset_request, 0.0);
    /* the first fault is latched */
    all_wheel_drive_real cause_of_inputs = 0.0;
    cause_of_inputs = all_wheel_drive_select(s->M5_overspeed_time <= s->bridged_time, cause_of_inputs, 4015.0);
    cause_of_inputs = all_wheel_drive_select(s->M4_overspeed_time <= s->bridged_time, cause_of_inputs, 4013.0);
    cause_of_inputs = all_wheel_drive_select(s->M3_overspeed_time <= s->bridged_time, cause_of_inputs, 4011.0);
    cause_of_inputs = all_wheel_drive_select(s->M2_overspeed_time <= s->bridged_time, cause_of_inputs, 4009.0);
    cause_of_inputs = all_wheel_drive_select(s->M1_overspeed_time <= s->bridged_time, cause_of_inputs, 4006.0);
    cause_of_inputs = all_wheel_drive_select(s->M5_speed_bad_time <= s->bridged_time, cause_of_inputs, 15.0);
    cause_of_inputs = all_wheel_drive_select(s->flange5_torque_bad_time <= s->bridged_time, cause_of_inputs, 14.0);
    cause_of_inputs = all_wheel_drive_select(s->M4_speed_bad_time <= s->bridged_time, cause_of_inputs, 13.0);
    cause_of_inputs = all_wheel_drive_select(s->flange4_torque_bad_time <= s->bridged_time, cause_of_inputs, 12.0);
    cause_of_inputs = all_wheel_drive_select(s->M3_speed_bad_time <= s->bridged_time, cause_of_inputs, 11.0);
    cause_of_inputs = all_wheel_drive_select(s->flange3_torque_bad_time <= s->bridged_time, cause_of_inputs, 10.0);
    cause_of_inputs = all_wheel_drive_select(s->M2_speed_bad_time <= s->bridged_time, cause_of_inputs, 9.0);
    cause_of_inputs = all_wheel_drive_select(s->flange2_torque_bad_time <= s->bridged_time, cause_of_inputs, 8.0);
    cause_of_inputs = all_wheel_drive_select(s->flange1_torque_bad_time <= s->bridged_time, cause_of_inputs, 7.0);
    cause_of_inputs = all_wheel_drive_select(s->M1_speed_bad_time <= s->bridged_time, cause_of_inputs, 6.0);
    cause_of_inputs = all_wheel_drive_select(s->M5_speed_ref_bad_time <= s->bridged_time, cause_of_inputs, 5.0);
    cause_of_inputs = all_wheel_drive_select(s->M4_speed_ref_bad_time <= s->bridged_time, cause_of_inputs, 4.0);
    cause_of_inputs = all_wheel_drive_select(s->M3_speed_ref_bad_time <= s->bridged_time, cause_of_inputs, 3.0);
    cause_of_inputs = all_wheel_drive_select(s->M2_speed_ref_bad_time <= s->bridged_time, cause_of_inputs, 2.0);
    cause_of_inputs = all_wheel_drive_select(s->centre_input_torque_ref_bad_time <= s->bridged_time,
        cause_of_inputs, 1.0);
    s->fault = all_wheel_drive_select(s->fault > 0.5, s->fault, cause_of_inputs);
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
        s->M4_integrated = s->M4_speed_held;
        s->M4_speed_still_time = 0.0;
        s->flange4_torque_still_time = 0.0;
        s->M5_integrated = s->M5_speed_held;
        s->M5_speed_still_time = 0.0;
        s->flange5_torque_still_time = 0.0;
        s->flange1_torque_mean = s->flange1_torque_held;
        s->flange1_torque_swings = 0.0;
        s->flange2_torque_mean = s->flange2_torque_held;
        s->flange2_torque_swings = 0.0;
        s->flange3_torque_mean = s->flange3_torque_held;
        s->flange3_torque_swings = 0.0;
        s->flange4_torque_mean = s->flange4_torque_held;
        s->flange4_torque_swings = 0.0;
        s->flange5_torque_mean = s->flange5_torque_held;
        s->flange5_torque_swings = 0.0;
        s->M1_torque_ref_mean = 0.0;
        s->M1_torque_ref_swings = 0.0;
        s->M2_torque_ref_mean = 0.0;
        s->M2_torque_ref_swings = 0.0;
        s->M3_torque_ref_mean = 0.0;
        s->M3_torque_ref_swings = 0.0;
        s->M4_torque_ref_mean = 0.0;
        s->M4_torque_ref_swings = 0.0;
        s->M5_torque_ref_mean = 0.0;
        s->M5_torque_ref_swings = 0.0;
        s->M2_speed_ref_limited = s->M2_speed_held;
        s->M3_speed_ref_limited = s->M3_speed_held;
        s->M4_speed_ref_limited = s->M4_speed_held;
        s->M5_speed_ref_limited = s->M5_speed_held;
        s->M2_speed_integral = 0.0;
        s->M3_speed_integral = 0.0;
        s->M4_speed_integral = 0.0;
        s->M5_speed_integral = 0.0;
        s->M1_model_rate = 0.0;
        s->M1_torque_integral = 0.0;
    }
    /* load_compensation follows its parameter along a ramp */
    const all_wheel_drive_real load_compensation_before = s->load_compensation_now;
    const all_wheel_drive_real load_compensation_distance = p->load_compensation - load_compensation_before;
    if (p->load_compensation != s->load_compensation_target) {
        s->load_compensation_step = all_wheel_drive_max(s->switch_share *
            all_wheel_drive_abs(load_compensation_distance), 1e-06 * all_wheel_drive_abs(p->load_compensation) + 1e-06 *
            all_wheel_drive_abs(load_compensation_before));
    }
    s->load_compensation_now = all_wheel_drive_select(s->load_compensation_step <
        all_wheel_drive_abs(load_compensation_distance), load_compensation_before +
        all_wheel_drive_max(-s->load_compensation_step, all_wheel_drive_min(load_compensation_distance,
        s->load_compensation_step)), p->load_compensation);
    s->load_compensation_step = all_wheel_drive_select(s->load_compensation_step <
        all_wheel_drive_abs(load_compensation_distance), s->load_compensation_step, 0.0);
    s->load_compensation_target = p->load_compensation;
    /* acceleration_torque follows its parameter along a ramp */
    const all_wheel_drive_real acceleration_torque_before = s->acceleration_torque_now;
    const all_wheel_drive_real acceleration_torque_distance = p->acceleration_torque - acceleration_torque_before;
    if (p->acceleration_torque != s->acceleration_torque_target) {
        s->acceleration_torque_step = all_wheel_drive_max(s->switch_share *
            all_wheel_drive_abs(acceleration_torque_distance), 1e-06 * all_wheel_drive_abs(p->acceleration_torque) +
            1e-06 * all_wheel_drive_abs(acceleration_torque_before));
    }
    s->acceleration_torque_now = all_wheel_drive_select(s->acceleration_torque_step <
        all_wheel_drive_abs(acceleration_torque_distance), acceleration_torque_before +
        all_wheel_drive_max(-s->acceleration_torque_step, all_wheel_drive_min(acceleration_torque_distance,
        s->acceleration_torque_step)), p->acceleration_torque);
    s->acceleration_torque_step = all_wheel_drive_select(s->acceleration_torque_step <
        all_wheel_drive_abs(acceleration_torque_distance), s->acceleration_torque_step, 0.0);
    s->acceleration_torque_target = p->acceleration_torque;
    /* M1_damping follows its parameter along a ramp */
    const all_wheel_drive_real M1_damping_before = s->M1_damping_now;
    const all_wheel_drive_real M1_damping_distance = p->M1_damping - M1_damping_before;
    if (p->M1_damping != s->M1_damping_target) {
        s->M1_damping_step = all_wheel_drive_max(s->switch_share * all_wheel_drive_abs(M1_damping_distance), 1e-06 *
            all_wheel_drive_abs(p->M1_damping) + 1e-06 * all_wheel_drive_abs(M1_damping_before));
    }
    s->M1_damping_now = all_wheel_drive_select(s->M1_damping_step < all_wheel_drive_abs(M1_damping_distance),
        M1_damping_before + all_wheel_drive_max(-s->M1_damping_step, all_wheel_drive_min(M1_damping_distance,
        s->M1_damping_step)), p->M1_damping);
    s->M1_damping_step = all_wheel_drive_select(s->M1_damping_step < all_wheel_drive_abs(M1_damping_distance),
        s->M1_damping_step, 0.0);
    s->M1_damping_target = p->M1_damping;
    /* torque-speed envelope, Figure 7.1 */
    const all_wheel_drive_real M1_available = s->M1_power / all_wheel_drive_max(p->M1_speed_rated,
        all_wheel_drive_abs(s->M1_speed_held));
    const all_wheel_drive_real M1_least = -M1_available * all_wheel_drive_max(0.0, all_wheel_drive_min(1.0,
        s->M1_speed_held * s->M1_taper_slope + s->M1_taper_end));
    const all_wheel_drive_real M1_most = M1_available * all_wheel_drive_max(0.0, all_wheel_drive_min(1.0,
        -s->M1_speed_held * s->M1_taper_slope + s->M1_taper_end));
    const all_wheel_drive_real M2_available = s->M2_power / all_wheel_drive_max(p->M2_speed_rated,
        all_wheel_drive_abs(s->M2_speed_held));
    const all_wheel_drive_real M2_least = -M2_available * all_wheel_drive_max(0.0, all_wheel_drive_min(1.0,
        s->M2_speed_held * s->M2_taper_slope + s->M2_taper_end));
    const all_wheel_drive_real M2_most = M2_available * all_wheel_drive_max(0.0, all_wheel_drive_min(1.0,
        -s->M2_speed_held * s->M2_taper_slope + s->M2_taper_end));
    const all_wheel_drive_real M3_available = s->M3_power / all_wheel_drive_max(p->M3_speed_rated,
        all_wheel_drive_abs(s->M3_speed_held));
    const all_wheel_drive_real M3_least = -M3_available * all_wheel_drive_max(0.0, all_wheel_drive_min(1.0,
        s->M3_speed_held * s->M3_taper_slope + s->M3_taper_end));
    const all_wheel_drive_real M3_most = M3_available * all_wheel_drive_max(0.0, all_wheel_drive_min(1.0,
        -s->M3_speed_held * s->M3_taper_slope + s->M3_taper_end));
    const all_wheel_drive_real M4_available = s->M4_power / all_wheel_drive_max(p->M4_speed_rated,
        all_wheel_drive_abs(s->M4_speed_held));
    const all_wheel_drive_real M4_least = -M4_available * all_wheel_drive_max(0.0, all_wheel_drive_min(1.0,
        s->M4_speed_held * s->M4_taper_slope + s->M4_taper_end));
    const all_wheel_drive_real M4_most = M4_available * all_wheel_drive_max(0.0, all_wheel_drive_min(1.0,
        -s->M4_speed_held * s->M4_taper_slope + s->M4_taper_end));
    const all_wheel_drive_real M5_available = s->M5_power / all_wheel_drive_max(p->M5_speed_rated,
        all_wheel_drive_abs(s->M5_speed_held));
    const all_wheel_drive_real M5_least = -M5_available * all_wheel_drive_max(0.0, all_wheel_drive_min(1.0,
        s->M5_speed_held * s->M5_taper_slope + s->M5_taper_end));
    const all_wheel_drive_real M5_most = M5_available * all_wheel_drive_max(0.0, all_wheel_drive_min(1.0,
        -s->M5_speed_held * s->M5_taper_slope + s->M5_taper_end));
    /* torque commands of the step before */
    const all_wheel_drive_real M1_applied = s->M1_last * s->authority;
    const all_wheel_drive_real M2_applied = s->M2_last * s->authority;
    const all_wheel_drive_real M3_applied = s->M3_last * s->authority;
    const all_wheel_drive_real M4_applied = s->M4_last * s->authority;
    const all_wheel_drive_real M5_applied = s->M5_last * s->authority;
    /* speed from the torques on the rotor */
    const all_wheel_drive_real M1_integrated_before = s->M1_integrated;
    s->M1_integrated = M1_integrated_before + s->M1_per_step * (M1_applied - s->flange1_torque_held) +
        s->disagreement_share * (-M1_integrated_before + s->M1_speed_held);
    const all_wheel_drive_real M1_difference = all_wheel_drive_abs(s->M1_integrated - s->M1_speed_held);
    /* speed against torques */
    const all_wheel_drive_real M1_agrees = all_wheel_drive_select(M1_difference <= p->M1_disagreement_limit, 1.0,
        0.0);
    all_wheel_drive_lasting(M1_agrees, s->M1_disagreement_time, p->sample_time, p->hold_time,
        &s->M1_disagreement_time);
    /* M1_speed to the last bit */
    all_wheel_drive_still(s->M1_speed_held, s->M1_speed_before, s->M1_speed_still_time, p->sample_time,
        &s->M1_speed_still_time);
    s->M1_speed_before = s->M1_speed_held;
    /* flange1_torque to the last bit */
    all_wheel_drive_still(s->flange1_torque_held, s->flange1_torque_before, s->flange1_torque_still_time,
        p->sample_time, &s->flange1_torque_still_time);
    s->flange1_torque_before = s->flange1_torque_held;
    s->flange1_torque_command = all_wheel_drive_select(s->flange1_torque_still_time > 0.0,
        s->flange1_torque_command, M1_applied);
    /* speed from the torques on the rotor */
    const all_wheel_drive_real M2_integrated_before = s->M2_integrated;
    s->M2_integrated = M2_integrated_before + s->M2_per_step * (M2_applied + s->flange2_torque_held) +
        s->disagreement_share * (-M2_integrated_before + s->M2_speed_held);
    const all_wheel_drive_real M2_difference = all_wheel_drive_abs(s->M2_integrated - s->M2_speed_held);
    /* speed against torques */
    const all_wheel_drive_real M2_agrees = all_wheel_drive_select(M2_difference <= p->M2_disagreement_limit, 1.0,
        0.0);
    all_wheel_drive_lasting(M2_agrees, s->M2_disagreement_time, p->sample_time, p->hold_time,
        &s->M2_disagreement_time);
    /* M2_speed to the last bit */
    all_wheel_drive_still(s->M2_speed_held, s->M2_speed_before, s->M2_speed_still_time, p->sample_time,
        &s->M2_speed_still_time);
    s->M2_speed_before = s->M2_speed_held;
    /* flange2_torque to the last bit */
    all_wheel_drive_still(s->flange2_torque_held, s->flange2_torque_before, s->flange2_torque_still_time,
        p->sample_time, &s->flange2_torque_still_time);
    s->flange2_torque_before = s->flange2_torque_held;
    s->flange2_torque_command = all_wheel_drive_select(s->flange2_torque_still_time > 0.0,
        s->flange2_torque_command, M2_applied);
    /* speed from the torques on the rotor */
    const all_wheel_drive_real M3_integrated_before = s->M3_integrated;
    s->M3_integrated = M3_integrated_before + s->M3_per_step * (M3_applied + s->flange3_torque_held) +
        s->disagreement_share * (-M3_integrated_before + s->M3_speed_held);
    const all_wheel_drive_real M3_difference = all_wheel_drive_abs(s->M3_integrated - s->M3_speed_held);
    /* speed against torques */
    const all_wheel_drive_real M3_agrees = all_wheel_drive_select(M3_difference <= p->M3_disagreement_limit, 1.0,
        0.0);
    all_wheel_drive_lasting(M3_agrees, s->M3_disagreement_time, p->sample_time, p->hold_time,
        &s->M3_disagreement_time);
    /* M3_speed to the last bit */
    all_wheel_drive_still(s->M3_speed_held, s->M3_speed_before, s->M3_speed_still_time, p->sample_time,
        &s->M3_speed_still_time);
    s->M3_speed_before = s->M3_speed_held;
    /* flange3_torque to the last bit */
    all_wheel_drive_still(s->flange3_torque_held, s->flange3_torque_before, s->flange3_torque_still_time,
        p->sample_time, &s->flange3_torque_still_time);
    s->flange3_torque_before = s->flange3_torque_held;
    s->flange3_torque_command = all_wheel_drive_select(s->flange3_torque_still_time > 0.0,
        s->flange3_torque_command, M3_applied);
    /* speed from the torques on the rotor */
    const all_wheel_drive_real M4_integrated_before = s->M4_integrated;
    s->M4_integrated = M4_integrated_before + s->M4_per_step * (M4_applied + s->flange4_torque_held) +
        s->disagreement_share * (-M4_integrated_before + s->M4_speed_held);
    const all_wheel_drive_real M4_difference = all_wheel_drive_abs(s->M4_integrated - s->M4_speed_held);
    /* speed against torques */
    const all_wheel_drive_real M4_agrees = all_wheel_drive_select(M4_difference <= p->M4_disagreement_limit, 1.0,
        0.0);
    all_wheel_drive_lasting(M4_agrees, s->M4_disagreement_time, p->sample_time, p->hold_time,
        &s->M4_disagreement_time);
    /* M4_speed to the last bit */
    all_wheel_drive_still(s->M4_speed_held, s->M4_speed_before, s->M4_speed_still_time, p->sample_time,
        &s->M4_speed_still_time);
    s->M4_speed_before = s->M4_speed_held;
    /* flange4_torque to the last bit */
    all_wheel_drive_still(s->flange4_torque_held, s->flange4_torque_before, s->flange4_torque_still_time,
        p->sample_time, &s->flange4_torque_still_time);
    s->flange4_torque_before = s->flange4_torque_held;
    s->flange4_torque_command = all_wheel_drive_select(s->flange4_torque_still_time > 0.0,
        s->flange4_torque_command, M4_applied);
    /* speed from the torques on the rotor */
    const all_wheel_drive_real M5_integrated_before = s->M5_integrated;
    s->M5_integrated = M5_integrated_before + s->M5_per_step * (M5_applied + s->flange5_torque_held) +
        s->disagreement_share * (-M5_integrated_before + s->M5_speed_held);
    const all_wheel_drive_real M5_difference = all_wheel_drive_abs(s->M5_integrated - s->M5_speed_held);
    /* speed against torques */
    const all_wheel_drive_real M5_agrees = all_wheel_drive_select(M5_difference <= p->M5_disagreement_limit, 1.0,
        0.0);
    all_wheel_drive_lasting(M5_agrees, s->M5_disagreement_time, p->sample_time, p->hold_time,
        &s->M5_disagreement_time);
    /* M5_speed to the last bit */
    all_wheel_drive_still(s->M5_speed_held, s->M5_speed_before, s->M5_speed_still_time, p->sample_time,
        &s->M5_speed_still_time);
    s->M5_speed_before = s->M5_speed_held;
    /* flange5_torque to the last bit */
    all_wheel_drive_still(s->flange5_torque_held, s->flange5_torque_before, s->flange5_torque_still_time,
        p->sample_time, &s->flange5_torque_still_time);
    s->flange5_torque_before = s->flange5_torque_held;
    s->flange5_torque_command = all_wheel_drive_select(s->flange5_torque_still_time > 0.0,
        s->flange5_torque_command, M5_applied);
    /* oscillation of flange1_torque */
    const all_wheel_drive_real flange1_torque_mean_before = s->flange1_torque_mean;
    const all_wheel_drive_real flange1_torque_swing = s->flange1_torque_held - flange1_torque_mean_before;
    s->flange1_torque_mean = flange1_torque_mean_before + flange1_torque_swing * s->mean_share;
    all_wheel_drive_swings(flange1_torque_swing, p->flange1_torque_oscillation_limit, s->flange1_torque_side,
        s->flange1_torque_swings, s->forgotten_swings, &s->flange1_torque_side, &s->flange1_torque_swings);
    /* oscillation of flange2_torque */
    const all_wheel_drive_real flange2_torque_mean_before = s->flange2_torque_mean;
    const all_wheel_drive_real flange2_torque_swing = s->flange2_torque_held - flange2_torque_mean_before;
    s->flange2_torque_mean = flange2_torque_mean_before + flange2_torque_swing * s->mean_share;
    all_wheel_drive_swings(flange2_torque_swing, p->flange2_torque_oscillation_limit, s->flange2_torque_side,
        s->flange2_torque_swings, s->forgotten_swings, &s->flange2_torque_side, &s->flange2_torque_swings);
    /* oscillation of flange3_torque */
    const all_wheel_drive_real flange3_torque_mean_before = s->flange3_torque_mean;
    const all_wheel_drive_real flange3_torque_swing = s->flange3_torque_held - flange3_torque_mean_before;
    s->flange3_torque_mean = flange3_torque_mean_before + flange3_torque_swing * s->mean_share;
    all_wheel_drive_swings(flange3_torque_swing, p->flange3_torque_oscillation_limit, s->flange3_torque_side,
        s->flange3_torque_swings, s->forgotten_swings, &s->flange3_torque_side, &s->flange3_torque_swings);
    /* oscillation of flange4_torque */
    const all_wheel_drive_real flange4_torque_mean_before = s->flange4_torque_mean;
    const all_wheel_drive_real flange4_torque_swing = s->flange4_torque_held - flange4_torque_mean_before;
    s->flange4_torque_mean = flange4_torque_mean_before + flange4_torque_swing * s->mean_share;
    all_wheel_drive_swings(flange4_torque_swing, p->flange4_torque_oscillation_limit, s->flange4_torque_side,
        s->flange4_torque_swings, s->forgotten_swings, &s->flange4_torque_side, &s->flange4_torque_swings);
    /* oscillation of flange5_torque */
    const all_wheel_drive_real flange5_torque_mean_before = s->flange5_torque_mean;
    const all_wheel_drive_real flange5_torque_swing = s->flange5_torque_held - flange5_torque_mean_before;
    s->flange5_torque_mean = flange5_torque_mean_before + flange5_torque_swing * s->mean_share;
    all_wheel_drive_swings(flange5_torque_swing, p->flange5_torque_oscillation_limit, s->flange5_torque_side,
        s->flange5_torque_swings, s->forgotten_swings, &s->flange5_torque_side, &s->flange5_torque_swings);
    /* oscillation of M1_torque_ref */
    const all_wheel_drive_real M1_torque_ref_mean_before = s->M1_torque_ref_mean;
    const all_wheel_drive_real M1_torque_ref_swing = M1_applied - M1_torque_ref_mean_before;
    s->M1_torque_ref_mean = M1_torque_ref_mean_before + M1_torque_ref_swing * s->mean_share;
    all_wheel_drive_swings(M1_torque_ref_swing, p->M1_torque_ref_oscillation_limit, s->M1_torque_ref_side,
        s->M1_torque_ref_swings, s->forgotten_swings, &s->M1_torque_ref_side, &s->M1_torque_ref_swings);
    /* oscillation of M2_torque_ref */
    const all_wheel_drive_real M2_torque_ref_mean_before = s->M2_torque_ref_mean;
    const all_wheel_drive_real M2_torque_ref_swing = M2_applied - M2_torque_ref_mean_before;
    s->M2_torque_ref_mean = M2_torque_ref_mean_before + M2_torque_ref_swing * s->mean_share;
    all_wheel_drive_swings(M2_torque_ref_swing, p->M2_torque_ref_oscillation_limit, s->M2_torque_ref_side,
        s->M2_torque_ref_swings, s->forgotten_swings, &s->M2_torque_ref_side, &s->M2_torque_ref_swings);
    /* oscillation of M3_torque_ref */
    const all_wheel_drive_real M3_torque_ref_mean_before = s->M3_torque_ref_mean;
    const all_wheel_drive_real M3_torque_ref_swing = M3_applied - M3_torque_ref_mean_before;
    s->M3_torque_ref_mean = M3_torque_ref_mean_before + M3_torque_ref_swing * s->mean_share;
    all_wheel_drive_swings(M3_torque_ref_swing, p->M3_torque_ref_oscillation_limit, s->M3_torque_ref_side,
        s->M3_torque_ref_swings, s->forgotten_swings, &s->M3_torque_ref_side, &s->M3_torque_ref_swings);
    /* oscillation of M4_torque_ref */
    const all_wheel_drive_real M4_torque_ref_mean_before = s->M4_torque_ref_mean;
    const all_wheel_drive_real M4_torque_ref_swing = M4_applied - M4_torque_ref_mean_before;
    s->M4_torque_ref_mean = M4_torque_ref_mean_before + M4_torque_ref_swing * s->mean_share;
    all_wheel_drive_swings(M4_torque_ref_swing, p->M4_torque_ref_oscillation_limit, s->M4_torque_ref_side,
        s->M4_torque_ref_swings, s->forgotten_swings, &s->M4_torque_ref_side, &s->M4_torque_ref_swings);
    /* oscillation of M5_torque_ref */
    const all_wheel_drive_real M5_torque_ref_mean_before = s->M5_torque_ref_mean;
    const all_wheel_drive_real M5_torque_ref_swing = M5_applied - M5_torque_ref_mean_before;
    s->M5_torque_ref_mean = M5_torque_ref_mean_before + M5_torque_ref_swing * s->mean_share;
    all_wheel_drive_swings(M5_torque_ref_swing, p->M5_torque_ref_oscillation_limit, s->M5_torque_ref_side,
        s->M5_torque_ref_swings, s->forgotten_swings, &s->M5_torque_ref_side, &s->M5_torque_ref_swings);
    /* the first fault is latched */
    all_wheel_drive_real cause_of_watching = 0.0;
    cause_of_watching = all_wheel_drive_select(s->M5_torque_ref_swings <= 5.5, cause_of_watching, 8005.0);
    cause_of_watching = all_wheel_drive_select(s->M4_torque_ref_swings <= 5.5, cause_of_watching, 8004.0);
    cause_of_watching = all_wheel_drive_select(s->M3_torque_ref_swings <= 5.5, cause_of_watching, 8003.0);
    cause_of_watching = all_wheel_drive_select(s->M2_torque_ref_swings <= 5.5, cause_of_watching, 8002.0);
    cause_of_watching = all_wheel_drive_select(s->M1_torque_ref_swings <= 5.5, cause_of_watching, 8001.0);
    cause_of_watching = all_wheel_drive_select(s->flange5_torque_swings <= 5.5, cause_of_watching, 6014.0);
    cause_of_watching = all_wheel_drive_select(s->flange4_torque_swings <= 5.5, cause_of_watching, 6012.0);
    cause_of_watching = all_wheel_drive_select(s->flange3_torque_swings <= 5.5, cause_of_watching, 6010.0);
    cause_of_watching = all_wheel_drive_select(s->flange2_torque_swings <= 5.5, cause_of_watching, 6008.0);
    cause_of_watching = all_wheel_drive_select(s->flange1_torque_swings <= 5.5, cause_of_watching, 6007.0);
    cause_of_watching = all_wheel_drive_select(s->M5_disagreement_time <= s->bridged_time, cause_of_watching,
        5015.0);
    cause_of_watching = all_wheel_drive_select(s->M4_disagreement_time <= s->bridged_time, cause_of_watching,
        5013.0);
    cause_of_watching = all_wheel_drive_select(s->M3_disagreement_time <= s->bridged_time, cause_of_watching,
        5011.0);
    cause_of_watching = all_wheel_drive_select(s->M2_disagreement_time <= s->bridged_time, cause_of_watching,
        5009.0);
    cause_of_watching = all_wheel_drive_select(s->M1_disagreement_time <= s->bridged_time, cause_of_watching,
        5006.0);
    cause_of_watching = all_wheel_drive_select(M5_difference <= p->M5_frozen_limit || s->M5_speed_still_time <=
        p->frozen_time, cause_of_watching, 3015.0);
    cause_of_watching = all_wheel_drive_select(M5_difference <= p->M5_frozen_limit || s->flange5_torque_still_time
        <= p->frozen_time || all_wheel_drive_abs(M5_applied - s->flange5_torque_command) <= s->M5_moved_torque,
        cause_of_watching, 3014.0);
    cause_of_watching = all_wheel_drive_select(M4_difference <= p->M4_frozen_limit || s->M4_speed_still_time <=
        p->frozen_time, cause_of_watching, 3013.0);
    cause_of_watching = all_wheel_drive_select(M4_difference <= p->M4_frozen_limit || s->flange4_torque_still_time
        <= p->frozen_time || all_wheel_drive_abs(M4_applied - s->flange4_torque_command) <= s->M4_moved_torque,
        cause_of_watching, 3012.0);
    cause_of_watching = all_wheel_drive_select(M3_difference <= p->M3_frozen_limit || s->M3_speed_still_time <=
        p->frozen_time, cause_of_watching, 3011.0);
    cause_of_watching = all_wheel_drive_select(M3_difference <= p->M3_frozen_limit || s->flange3_torque_still_time
        <= p->frozen_time || all_wheel_drive_abs(M3_applied - s->flange3_torque_command) <= s->M3_moved_torque,
        cause_of_watching, 3010.0);
    cause_of_watching = all_wheel_drive_select(M2_difference <= p->M2_frozen_limit || s->M2_speed_still_time <=
        p->frozen_time, cause_of_watching, 3009.0);
    cause_of_watching = all_wheel_drive_select(M2_difference <= p->M2_frozen_limit || s->flange2_torque_still_time
        <= p->frozen_time || all_wheel_drive_abs(M2_applied - s->flange2_torque_command) <= s->M2_moved_torque,
        cause_of_watching, 3008.0);
    cause_of_watching = all_wheel_drive_select(M1_difference <= p->M1_frozen_limit || s->flange1_torque_still_time
        <= p->frozen_time || all_wheel_drive_abs(M1_applied - s->flange1_torque_command) <= s->M1_moved_torque,
        cause_of_watching, 3007.0);
    cause_of_watching = all_wheel_drive_select(M1_difference <= p->M1_frozen_limit || s->M1_speed_still_time <=
        p->frozen_time, cause_of_watching, 3006.0);
    s->fault = all_wheel_drive_select(s->fault > 0.5, s->fault, cause_of_watching);
    /* limit of the rate */
    const all_wheel_drive_real M2_speed_ref_before = s->M2_speed_ref_limited;
    s->M2_speed_ref_limited = M2_speed_ref_before + all_wheel_drive_max(-s->M2_speed_ref_step,
        all_wheel_drive_min(s->M2_speed_ref_step, -M2_speed_ref_before + s->M2_speed_ref_held));
    const all_wheel_drive_real M3_speed_ref_before = s->M3_speed_ref_limited;
    s->M3_speed_ref_limited = M3_speed_ref_before + all_wheel_drive_max(-s->M3_speed_ref_step,
        all_wheel_drive_min(s->M3_speed_ref_step, -M3_speed_ref_before + s->M3_speed_ref_held));
    const all_wheel_drive_real M4_speed_ref_before = s->M4_speed_ref_limited;
    s->M4_speed_ref_limited = M4_speed_ref_before + all_wheel_drive_max(-s->M4_speed_ref_step,
        all_wheel_drive_min(s->M4_speed_ref_step, -M4_speed_ref_before + s->M4_speed_ref_held));
    const all_wheel_drive_real M5_speed_ref_before = s->M5_speed_ref_limited;
    s->M5_speed_ref_limited = M5_speed_ref_before + all_wheel_drive_max(-s->M5_speed_ref_step,
        all_wheel_drive_min(s->M5_speed_ref_step, -M5_speed_ref_before + s->M5_speed_ref_held));
    /* testing torque while nothing accelerates (5.95), (5.96) */
    const all_wheel_drive_real centre_input_torque_steady = s->flange1_torque_held;
    if (s->running <= 0.5) {
        /* the first step, and the first one after a fault, starts anew */
        s->centre_input_torque_ref_limited = centre_input_torque_steady;
    }
    /* limit of the rate */
    const all_wheel_drive_real centre_input_torque_ref_before = s->centre_input_torque_ref_limited;
    s->centre_input_torque_ref_limited = centre_input_torque_ref_before +
        all_wheel_drive_max(-s->centre_input_torque_ref_step, all_wheel_drive_min(s->centre_input_torque_ref_step,
        -centre_input_torque_ref_before + s->centre_input_torque_ref_held));
    const all_wheel_drive_real M2_speed_error = -s->M2_speed_held + s->M2_speed_ref_limited;
    /* load torque compensation (5.52), (5.74) */
    const all_wheel_drive_real M2_compensation = -s->flange2_torque_held;
    /* so that a switch does not jump */
    const all_wheel_drive_real M2_given_away = M2_compensation * (load_compensation_before -
        s->load_compensation_now);
    /* PI speed control (5.84) */
    const all_wheel_drive_real M2_integral_before = s->M2_speed_integral +
        all_wheel_drive_select(p->M2_speed_integral_gain > 0.0, M2_given_away, 0.0);
    const all_wheel_drive_real M2_asked = M2_integral_before + M2_speed_error * p->M2_speed_gain;
    const all_wheel_drive_real M2_wanted = M2_asked + M2_compensation * s->load_compensation_now;
    /* torque-speed envelope */
    const all_wheel_drive_real M2_command = all_wheel_drive_max(M2_least, all_wheel_drive_min(M2_most, M2_wanted));
    /* what the limit cuts off */
    const all_wheel_drive_real M2_cut = M2_command - M2_wanted;
    /* conditioning anti-windup (Hanus) */
    s->M2_speed_integral = M2_cut * s->M2_speed_conditioning + M2_integral_before + M2_speed_error *
        s->M2_speed_growth;
    /* net torque on the rotor */
    const all_wheel_drive_real M2_net = M2_command - M2_compensation;
    const all_wheel_drive_real M3_speed_error = -s->M3_speed_held + s->M3_speed_ref_limited;
    /* load torque compensation (5.52), (5.74) */
    const all_wheel_drive_real M3_compensation = -s->flange3_torque_held;
    /* so that a switch does not jump */
    const all_wheel_drive_real M3_given_away = M3_compensation * (load_compensation_before -
        s->load_compensation_now);
    /* PI speed control (5.84) */
    const all_wheel_drive_real M3_integral_before = s->M3_speed_integral +
        all_wheel_drive_select(p->M3_speed_integral_gain > 0.0, M3_given_away, 0.0);
    const all_wheel_drive_real M3_asked = M3_integral_before + M3_speed_error * p->M3_speed_gain;
    const all_wheel_drive_real M3_wanted = M3_asked + M3_compensation * s->load_compensation_now;
    /* torque-speed envelope */
    const all_wheel_drive_real M3_command = all_wheel_drive_max(M3_least, all_wheel_drive_min(M3_most, M3_wanted));
    /* what the limit cuts off */
    const all_wheel_drive_real M3_cut = M3_command - M3_wanted;
    /* conditioning anti-windup (Hanus) */
    s->M3_speed_integral = M3_cut * s->M3_speed_conditioning + M3_integral_before + M3_speed_error *
        s->M3_speed_growth;
    /* net torque on the rotor */
    const all_wheel_drive_real M3_net = M3_command - M3_compensation;
    const all_wheel_drive_real M4_speed_error = -s->M4_speed_held + s->M4_speed_ref_limited;
    /* load torque compensation (5.52), (5.74) */
    const all_wheel_drive_real M4_compensation = -s->flange4_torque_held;
    /* so that a switch does not jump */
    const all_wheel_drive_real M4_given_away = M4_compensation * (load_compensation_before -
        s->load_compensation_now);
    /* PI speed control (5.84) */
    const all_wheel_drive_real M4_integral_before = s->M4_speed_integral +
        all_wheel_drive_select(p->M4_speed_integral_gain > 0.0, M4_given_away, 0.0);
    const all_wheel_drive_real M4_asked = M4_integral_before + M4_speed_error * p->M4_speed_gain;
    const all_wheel_drive_real M4_wanted = M4_asked + M4_compensation * s->load_compensation_now;
    /* torque-speed envelope */
    const all_wheel_drive_real M4_command = all_wheel_drive_max(M4_least, all_wheel_drive_min(M4_most, M4_wanted));
    /* what the limit cuts off */
    const all_wheel_drive_real M4_cut = M4_command - M4_wanted;
    /* conditioning anti-windup (Hanus) */
    s->M4_speed_integral = M4_cut * s->M4_speed_conditioning + M4_integral_before + M4_speed_error *
        s->M4_speed_growth;
    /* net torque on the rotor */
    const all_wheel_drive_real M4_net = M4_command - M4_compensation;
    const all_wheel_drive_real M5_speed_error = -s->M5_speed_held + s->M5_speed_ref_limited;
    /* load torque compensation (5.52), (5.74) */
    const all_wheel_drive_real M5_compensation = -s->flange5_torque_held;
    /* so that a switch does not jump */
    const all_wheel_drive_real M5_given_away = M5_compensation * (load_compensation_before -
        s->load_compensation_now);
    /* PI speed control (5.84) */
    const all_wheel_drive_real M5_integral_before = s->M5_speed_integral +
        all_wheel_drive_select(p->M5_speed_integral_gain > 0.0, M5_given_away, 0.0);
    const all_wheel_drive_real M5_asked = M5_integral_before + M5_speed_error * p->M5_speed_gain;
    const all_wheel_drive_real M5_wanted = M5_asked + M5_compensation * s->load_compensation_now;
    /* torque-speed envelope */
    const all_wheel_drive_real M5_command = all_wheel_drive_max(M5_least, all_wheel_drive_min(M5_most, M5_wanted));
    /* what the limit cuts off */
    const all_wheel_drive_real M5_cut = M5_command - M5_wanted;
    /* conditioning anti-windup (Hanus) */
    s->M5_speed_integral = M5_cut * s->M5_speed_conditioning + M5_integral_before + M5_speed_error *
        s->M5_speed_growth;
    /* net torque on the rotor */
    const all_wheel_drive_real M5_net = M5_command - M5_compensation;
    /* testing torque from the sensors (5.95), (5.96), (5.98) */
    const all_wheel_drive_real centre_input_torque_estimate = s->M1_unread_M2 * M2_net + s->M1_unread_M3 * M3_net +
        s->M1_unread_M4 * M4_net + s->M1_unread_M5 * M5_net + centre_input_torque_steady;
    if (s->running <= 0.5) {
        /* the first step, and the first one after a fault, starts anew */
        s->M1_model_torque = centre_input_torque_steady;
    }
    /* torque model (5.57), (5.76) */
    const all_wheel_drive_real M1_model_before = s->M1_model_torque;
    const all_wheel_drive_real M1_rate_before = s->M1_model_rate;
    s->M1_model_rate = -s->M1_model_drag * M1_rate_before + s->M1_model_pull * (-M1_model_before +
        s->centre_input_torque_ref_limited) + M1_rate_before;
    s->M1_model_torque = M1_model_before + s->M1_model_rate * p->sample_time;
    const all_wheel_drive_real M1_torque_error = s->M1_model_torque * p->M1_torque_model -
        centre_input_torque_estimate + s->centre_input_torque_ref_limited * (1.0 - p->M1_torque_model);
    /* torque control (5.99) */
    const all_wheel_drive_real M1_integral_before = s->M1_torque_integral;
    const all_wheel_drive_real M1_virtual = p->M1_feedforward * s->centre_input_torque_ref_limited +
        M1_integral_before + M1_torque_error * p->M1_torque_gain;
    /* active damping (5.62), (5.78) */
    const all_wheel_drive_real M1_twist_rate_M1 = -s->M1_speed_held + s->M1_twist_M1_M2_speed * s->M2_speed_held +
        s->M1_twist_M1_M3_speed * s->M3_speed_held + s->M1_twist_M1_M4_speed * s->M4_speed_held +
        s->M1_twist_M1_M5_speed * s->M5_speed_held;
    const all_wheel_drive_real M1_damping_torque = s->M1_damping_now * M1_twist_rate_M1;
    /* with the acceleration torque (5.62), (5.78) */
    const all_wheel_drive_real M1_wanted = M1_virtual + s->acceleration_torque_now * (s->M1_with_M2 * M2_net +
        s->M1_with_M3 * M3_net + s->M1_with_M4 * M4_net + s->M1_with_M5 * M5_net);
    /* reserve for active damping */
    const all_wheel_drive_real M1_kept = all_wheel_drive_max(M1_least * (1.0 - p->M1_damping_reserve),
        all_wheel_drive_min(M1_wanted, M1_most * (1.0 - p->M1_damping_reserve)));
    /* torque-speed envelope */
    const all_wheel_drive_real M1_command = all_wheel_drive_max(M1_least, all_wheel_drive_min(M1_most,
        M1_damping_torque + M1_kept));
    /* limited integrator */
    s->M1_torque_integral = all_wheel_drive_select(M1_torque_error * (-M1_kept + M1_wanted) > 0.0,
        M1_integral_before, all_wheel_drive_max(-p->M1_torque_integral_limit,
        all_wheel_drive_min(p->M1_torque_integral_limit, M1_integral_before + M1_torque_error *
        s->M1_torque_growth)));
    /* only sound torques leave */
    all_wheel_drive_real M1_released;
    all_wheel_drive_real M1_released_sound;
    all_wheel_drive_guard(M1_command, s->M1_largest, s->M1_last, &M1_released, &M1_released_sound);
    all_wheel_drive_real M2_released;
    all_wheel_drive_real M2_released_sound;
    all_wheel_drive_guard(M2_command, s->M2_largest, s->M2_last, &M2_released, &M2_released_sound);
    all_wheel_drive_real M3_released;
    all_wheel_drive_real M3_released_sound;
    all_wheel_drive_guard(M3_command, s->M3_largest, s->M3_last, &M3_released, &M3_released_sound);
    all_wheel_drive_real M4_released;
    all_wheel_drive_real M4_released_sound;
    all_wheel_drive_guard(M4_command, s->M4_largest, s->M4_last, &M4_released, &M4_released_sound);
    all_wheel_drive_real M5_released;
    all_wheel_drive_real M5_released_sound;
    all_wheel_drive_guard(M5_command, s->M5_largest, s->M5_last, &M5_released, &M5_released_sound);
    /* the first fault is latched */
    all_wheel_drive_real cause_of_commands = 0.0;
    cause_of_commands = all_wheel_drive_select(M5_released_sound > 0.5, cause_of_commands, 7005.0);
    cause_of_commands = all_wheel_drive_select(M4_released_sound > 0.5, cause_of_commands, 7004.0);
    cause_of_commands = all_wheel_drive_select(M3_released_sound > 0.5, cause_of_commands, 7003.0);
    cause_of_commands = all_wheel_drive_select(M2_released_sound > 0.5, cause_of_commands, 7002.0);
    cause_of_commands = all_wheel_drive_select(M1_released_sound > 0.5, cause_of_commands, 7001.0);
    s->fault = all_wheel_drive_select(s->fault > 0.5, s->fault, cause_of_commands);
    /* ramp of the torques */
    const all_wheel_drive_real authority_wanted = s->authority + all_wheel_drive_select(s->fault > 0.5,
        -s->ramp_step, s->ramp_step);
    all_wheel_drive_share(authority_wanted, &s->authority);
    s->running = all_wheel_drive_select(s->fault > 0.5, 0.0, 1.0);
    if (s->fault <= 0.5) {
        s->M1_last = M1_released;
    }
    /* the torque of before */
    const all_wheel_drive_real M1_calmer = s->M1_calm + s->calm_share * (-s->M1_calm + s->M1_last);
    all_wheel_drive_real M1_calm_sound;
    all_wheel_drive_guard(M1_calmer, s->M1_largest, s->M1_calm, &s->M1_calm, &M1_calm_sound);
    if (s->fault > 2999.5) {
        s->M1_last = s->M1_calm;
    }
    if (s->fault <= 0.5) {
        /* ramp of the torques */
        s->M2_last = M2_released;
    }
    /* the torque of before */
    const all_wheel_drive_real M2_calmer = s->M2_calm + s->calm_share * (-s->M2_calm + s->M2_last);
    all_wheel_drive_real M2_calm_sound;
    all_wheel_drive_guard(M2_calmer, s->M2_largest, s->M2_calm, &s->M2_calm, &M2_calm_sound);
    if (s->fault > 2999.5) {
        s->M2_last = s->M2_calm;
    }
    if (s->fault <= 0.5) {
        /* ramp of the torques */
        s->M3_last = M3_released;
    }
    /* the torque of before */
    const all_wheel_drive_real M3_calmer = s->M3_calm + s->calm_share * (-s->M3_calm + s->M3_last);
    all_wheel_drive_real M3_calm_sound;
    all_wheel_drive_guard(M3_calmer, s->M3_largest, s->M3_calm, &s->M3_calm, &M3_calm_sound);
    if (s->fault > 2999.5) {
        s->M3_last = s->M3_calm;
    }
    if (s->fault <= 0.5) {
        /* ramp of the torques */
        s->M4_last = M4_released;
    }
    /* the torque of before */
    const all_wheel_drive_real M4_calmer = s->M4_calm + s->calm_share * (-s->M4_calm + s->M4_last);
    all_wheel_drive_real M4_calm_sound;
    all_wheel_drive_guard(M4_calmer, s->M4_largest, s->M4_calm, &s->M4_calm, &M4_calm_sound);
    if (s->fault > 2999.5) {
        s->M4_last = s->M4_calm;
    }
    if (s->fault <= 0.5) {
        /* ramp of the torques */
        s->M5_last = M5_released;
    }
    /* the torque of before */
    const all_wheel_drive_real M5_calmer = s->M5_calm + s->calm_share * (-s->M5_calm + s->M5_last);
    all_wheel_drive_real M5_calm_sound;
    all_wheel_drive_guard(M5_calmer, s->M5_largest, s->M5_calm, &s->M5_calm, &M5_calm_sound);
    if (s->fault > 2999.5) {
        s->M5_last = s->M5_calm;
    }
    out->M1_torque_ref = all_wheel_drive_max(-900.0, all_wheel_drive_min(900.0, s->M1_last * s->authority));
    out->M2_torque_ref = all_wheel_drive_max(-2400.0, all_wheel_drive_min(2400.0, s->M2_last * s->authority));
    out->M3_torque_ref = all_wheel_drive_max(-2400.0, all_wheel_drive_min(2400.0, s->M3_last * s->authority));
    out->M4_torque_ref = all_wheel_drive_max(-2400.0, all_wheel_drive_min(2400.0, s->M4_last * s->authority));
    out->M5_torque_ref = all_wheel_drive_max(-2400.0, all_wheel_drive_min(2400.0, s->M5_last * s->authority));
    /* The last line of defence, should parameters have been changed without an update. */
    if (!all_wheel_drive_is_finite(out->M1_torque_ref + out->M2_torque_ref + out->M3_torque_ref + out->M4_torque_ref + out->M5_torque_ref)) {
        if (!all_wheel_drive_is_finite(out->M1_torque_ref)) {
            out->M1_torque_ref = 0.0;
            s->fault = s->fault > 0.0 ? s->fault : ALL_WHEEL_DRIVE_REAL(all_wheel_drive_controller_fault_M1_torque_ref);
            s->running = 0.0;
        }
        if (!all_wheel_drive_is_finite(out->M2_torque_ref)) {
            out->M2_torque_ref = 0.0;
            s->fault = s->fault > 0.0 ? s->fault : ALL_WHEEL_DRIVE_REAL(all_wheel_drive_controller_fault_M2_torque_ref);
            s->running = 0.0;
        }
        if (!all_wheel_drive_is_finite(out->M3_torque_ref)) {
            out->M3_torque_ref = 0.0;
            s->fault = s->fault > 0.0 ? s->fault : ALL_WHEEL_DRIVE_REAL(all_wheel_drive_controller_fault_M3_torque_ref);
            s->running = 0.0;
        }
        if (!all_wheel_drive_is_finite(out->M4_torque_ref)) {
            out->M4_torque_ref = 0.0;
            s->fault = s->fault > 0.0 ? s->fault : ALL_WHEEL_DRIVE_REAL(all_wheel_drive_controller_fault_M4_torque_ref);
            s->running = 0.0;
        }
        if (!all_wheel_drive_is_finite(out->M5_torque_ref)) {
            out->M5_torque_ref = 0.0;
            s->fault = s->fault > 0.0 ? s->fault : ALL_WHEEL_DRIVE_REAL(all_wheel_drive_controller_fault_M5_torque_ref);
            s->running = 0.0;
        }
    }
    return (all_wheel_drive_controller_status)s->fault;
}
