/*
 * differential_gearboxes_controller.h: controller of the bed differential_gearboxes
 *
 * Emitted by ptgen 0.1.0 from differential-gearboxes.toml (SHA-256 08abf4d695c2194f), template block.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef DIFFERENTIAL_GEARBOXES_CONTROLLER_H
#define DIFFERENTIAL_GEARBOXES_CONTROLLER_H

#include "differential_gearboxes_support.h"

/* Parameters, in SI units; call differential_gearboxes_controller_update after a change. */
typedef struct {
    differential_gearboxes_real sample_time; /* step of the controller (s) */
    differential_gearboxes_real fault_ramp; /* time from a fault to zero torque (s) */
    differential_gearboxes_real diff_outputs_torque_ref_plausible; /* largest plausible diff_outputs_torque_ref (N m) */
    differential_gearboxes_real M2_speed_ref_plausible; /* largest plausible M2_speed_ref (rad/s) */
    differential_gearboxes_real M3_speed_ref_plausible; /* largest plausible M3_speed_ref (rad/s) */
    differential_gearboxes_real M1_speed_plausible; /* largest plausible M1_speed (rad/s) */
    differential_gearboxes_real flange2_torque_plausible; /* largest plausible flange2_torque (N m) */
    differential_gearboxes_real M2_speed_plausible; /* largest plausible M2_speed (rad/s) */
    differential_gearboxes_real flange3_torque_plausible; /* largest plausible flange3_torque (N m) */
    differential_gearboxes_real M3_speed_plausible; /* largest plausible M3_speed (rad/s) */
    differential_gearboxes_real load_compensation; /* switch of the load torque compensation, 0 to 1 */
    differential_gearboxes_real acceleration_torque; /* switch of the acceleration torque, 0 to 1 */
    differential_gearboxes_real switch_time; /* time in which a switch or a damping follows its parameter (s) */
    differential_gearboxes_real M1_damping; /* active damping by M1 (5.81) (N m s/rad) */
    differential_gearboxes_real M1_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    differential_gearboxes_real M1_speed_max; /* largest admissible speed (rad/s) */
    differential_gearboxes_real M1_speed_taper; /* speed above M1_speed_max over which accelerating torque is taken back (rad/s) */
    differential_gearboxes_real M1_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    differential_gearboxes_real M2_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    differential_gearboxes_real M2_speed_max; /* largest admissible speed (rad/s) */
    differential_gearboxes_real M2_speed_taper; /* speed above M2_speed_max over which accelerating torque is taken back (rad/s) */
    differential_gearboxes_real M2_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    differential_gearboxes_real M3_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    differential_gearboxes_real M3_speed_max; /* largest admissible speed (rad/s) */
    differential_gearboxes_real M3_speed_taper; /* speed above M3_speed_max over which accelerating torque is taken back (rad/s) */
    differential_gearboxes_real M3_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    differential_gearboxes_real M2_speed_ref_rate; /* largest rate of M2_speed_ref (rad/s^2) */
    differential_gearboxes_real M3_speed_ref_rate; /* largest rate of M3_speed_ref (rad/s^2) */
    differential_gearboxes_real M2_speed_gain; /* proportional gain of the speed of M2 (N m s/rad) */
    differential_gearboxes_real M2_speed_integral_gain; /* integral gain of the speed of M2 (N m/rad) */
    differential_gearboxes_real M3_speed_gain; /* proportional gain of the speed of M3 (N m s/rad) */
    differential_gearboxes_real M3_speed_integral_gain; /* integral gain of the speed of M3 (N m/rad) */
    differential_gearboxes_real gearbox2_ratio; /* ratio of input speed to output speed; negative when the sense reverses */
    differential_gearboxes_real gearbox3_ratio; /* ratio of input speed to output speed; negative when the sense reverses */
    differential_gearboxes_real M2_inertia; /* moment of inertia of the rotor (kg m^2) */
    differential_gearboxes_real gearbox2_inertia; /* moment of inertia, referred to the side named in inertia_side (kg m^2) */
    differential_gearboxes_real M3_inertia; /* moment of inertia of the rotor (kg m^2) */
    differential_gearboxes_real gearbox3_inertia; /* moment of inertia, referred to the side named in inertia_side (kg m^2) */
    differential_gearboxes_real M1_sensor_inertia_M2; /* torque of M1 that its sensors miss, per acceleration of M2 (kg m^2) */
    differential_gearboxes_real M1_sensor_inertia_M3; /* torque of M1 that its sensors miss, per acceleration of M3 (kg m^2) */
    differential_gearboxes_real M1_inertia_estimate; /* inertia that M1 accelerates (5.78) (kg m^2) */
    differential_gearboxes_real M1_feedforward; /* share of the torque reference fed forward to M1 */
    differential_gearboxes_real M1_torque_gain; /* proportional gain of the torque control of M1, above -1 (5.115a) */
    differential_gearboxes_real diff_outputs_torque_ref_rate; /* largest rate of diff_outputs_torque_ref (N m/s) */
    differential_gearboxes_real M1_model_stiffness; /* stiffness in the torque model of M1 (N m/rad) */
    differential_gearboxes_real M1_model_damping; /* damping in the torque model of M1 (N m s/rad) */
    differential_gearboxes_real M1_torque_model; /* switch of the torque model of M1, 0 to 1 */
    differential_gearboxes_real diff_ratio; /* ratio i_d of input speed to mean output speed */
    differential_gearboxes_real gearbox1_ratio; /* ratio of input speed to output speed; negative when the sense reverses */
    differential_gearboxes_real M1_torque_integral_gain; /* integral gain of the torque control of M1 (1/s) */
    differential_gearboxes_real M1_damping_reserve; /* share of the torque of M1 kept for damping */
    differential_gearboxes_real M1_torque_integral_limit; /* limit of the torque integrator of M1 (N m) */
} differential_gearboxes_controller_params;

/* Inputs of a step. */
typedef struct {
    differential_gearboxes_real diff_outputs_torque_ref; /* reference (N m) */
    differential_gearboxes_real M2_speed_ref; /* reference (rad/s) */
    differential_gearboxes_real M3_speed_ref; /* reference (rad/s) */
    differential_gearboxes_real M1_speed; /* measured (rad/s) */
    differential_gearboxes_real flange2_torque; /* measured (N m) */
    differential_gearboxes_real M2_speed; /* measured (rad/s) */
    differential_gearboxes_real flange3_torque; /* measured (N m) */
    differential_gearboxes_real M3_speed; /* measured (rad/s) */
} differential_gearboxes_controller_inputs;

/* Outputs of a step; torques are positive when they drive the right-hand neighbour. */
typedef struct {
    differential_gearboxes_real M1_torque_ref; /* air-gap torque reference of M1 (N m) */
    differential_gearboxes_real M2_torque_ref; /* air-gap torque reference of M2 (N m) */
    differential_gearboxes_real M3_torque_ref; /* air-gap torque reference of M3 (N m) */
} differential_gearboxes_controller_outputs;

/* States first, then what follows from the parameters. Matrices are stored by columns. */
typedef struct {
    differential_gearboxes_real fault; /* 0, or the number of the input that failed */
    differential_gearboxes_real diff_outputs_torque_ref_held; /* last sound value of diff_outputs_torque_ref (N m) */
    differential_gearboxes_real M2_speed_ref_held; /* last sound value of M2_speed_ref (rad/s) */
    differential_gearboxes_real M3_speed_ref_held; /* last sound value of M3_speed_ref (rad/s) */
    differential_gearboxes_real M1_speed_held; /* last sound value of M1_speed (rad/s) */
    differential_gearboxes_real flange2_torque_held; /* last sound value of flange2_torque (N m) */
    differential_gearboxes_real M2_speed_held; /* last sound value of M2_speed (rad/s) */
    differential_gearboxes_real flange3_torque_held; /* last sound value of flange3_torque (N m) */
    differential_gearboxes_real M3_speed_held; /* last sound value of M3_speed (rad/s) */
    differential_gearboxes_real load_compensation_now; /* load_compensation on its way to the parameter */
    differential_gearboxes_real load_compensation_target; /* load_compensation as the last step found it */
    differential_gearboxes_real load_compensation_step; /* how far load_compensation moves in a step */
    differential_gearboxes_real running; /* 1 once a step was done without a fault */
    differential_gearboxes_real acceleration_torque_now; /* acceleration_torque on its way to the parameter */
    differential_gearboxes_real acceleration_torque_target; /* acceleration_torque as the last step found it */
    differential_gearboxes_real acceleration_torque_step; /* how far acceleration_torque moves in a step */
    differential_gearboxes_real M1_damping_now; /* M1_damping on its way to the parameter (N m s/rad) */
    differential_gearboxes_real M1_damping_target; /* M1_damping as the last step found it (N m s/rad) */
    differential_gearboxes_real M1_damping_step; /* how far M1_damping moves in a step (N m s/rad) */
    differential_gearboxes_real M2_speed_ref_limited; /* M2_speed_ref behind its rate limiter (rad/s) */
    differential_gearboxes_real M3_speed_ref_limited; /* M3_speed_ref behind its rate limiter (rad/s) */
    differential_gearboxes_real M2_speed_integral; /* integrator of the speed control of M2 (N m) */
    differential_gearboxes_real M3_speed_integral; /* integrator of the speed control of M3 (N m) */
    differential_gearboxes_real diff_outputs_torque_ref_limited; /* diff_outputs_torque_ref behind its rate limiter (N m) */
    differential_gearboxes_real M1_model_torque; /* torque that the feedforward to M1 should give (N m) */
    differential_gearboxes_real M1_model_rate; /* rate of the torque model of M1 (N m/s) */
    differential_gearboxes_real M1_torque_integral; /* integrator of the torque control of M1 (N m) */
    differential_gearboxes_real M1_last; /* last torque of M1 before a fault (N m) */
    differential_gearboxes_real M2_last; /* last torque of M2 before a fault (N m) */
    differential_gearboxes_real M3_last; /* last torque of M3 before a fault (N m) */
    differential_gearboxes_real authority; /* 1, going to 0 along the ramp after a fault */
    differential_gearboxes_real switch_share; /* share of a change per step */
    differential_gearboxes_real M1_taper_slope; /* share of the torque of M1 per excess of speed (s/rad) */
    differential_gearboxes_real M1_taper_end; /* share at standstill if it were not limited */
    differential_gearboxes_real M2_taper_slope; /* share of the torque of M2 per excess of speed (s/rad) */
    differential_gearboxes_real M2_taper_end; /* share at standstill if it were not limited */
    differential_gearboxes_real M3_taper_slope; /* share of the torque of M3 per excess of speed (s/rad) */
    differential_gearboxes_real M3_taper_end; /* share at standstill if it were not limited */
    differential_gearboxes_real M2_speed_ref_step; /* largest change of M2_speed_ref in a step (rad/s) */
    differential_gearboxes_real M3_speed_ref_step; /* largest change of M3_speed_ref in a step (rad/s) */
    differential_gearboxes_real M2_speed_growth; /* growth of the integrator per error (N m s/rad) */
    differential_gearboxes_real M2_speed_conditioning; /* growth per torque cut off */
    differential_gearboxes_real M3_speed_growth; /* growth of the integrator per error (N m s/rad) */
    differential_gearboxes_real M3_speed_conditioning; /* growth per torque cut off */
    differential_gearboxes_real M1_read_M2; /* coefficient of the virtual input of M2 */
    differential_gearboxes_real M1_read_M3; /* coefficient of the virtual input of M3 */
    differential_gearboxes_real M1_unread_M2; /* the same per net torque */
    differential_gearboxes_real M1_unread_M3; /* the same per net torque */
    differential_gearboxes_real diff_outputs_torque_ref_step; /* largest change of diff_outputs_torque_ref in a step (N m) */
    differential_gearboxes_real M1_model_pull; /* rate of the torque model per missing torque (1/s) */
    differential_gearboxes_real M1_model_drag; /* decay of that rate in a step */
    differential_gearboxes_real M1_with_M2; /* coefficient of the virtual input of M2 */
    differential_gearboxes_real M1_with_M3; /* coefficient of the virtual input of M3 */
    differential_gearboxes_real M1_share_M1; /* coefficient of the virtual input of M1 */
    differential_gearboxes_real M1_twist_M2_speed; /* coefficient of M2_speed */
    differential_gearboxes_real M1_twist_M3_speed; /* coefficient of M3_speed */
    differential_gearboxes_real M1_torque_growth; /* growth of the integrator per error */
    differential_gearboxes_real M1_share; /* share of its virtual input in M1 */
} differential_gearboxes_controller_state;

typedef enum {
    differential_gearboxes_controller_ok = 0,
    differential_gearboxes_controller_fault_diff_outputs_torque_ref = 1, /* diff_outputs_torque_ref was not finite or not plausible */
    differential_gearboxes_controller_fault_M2_speed_ref = 2, /* M2_speed_ref was not finite or not plausible */
    differential_gearboxes_controller_fault_M3_speed_ref = 3, /* M3_speed_ref was not finite or not plausible */
    differential_gearboxes_controller_fault_M1_speed = 4, /* M1_speed was not finite or not plausible */
    differential_gearboxes_controller_fault_flange2_torque = 5, /* flange2_torque was not finite or not plausible */
    differential_gearboxes_controller_fault_M2_speed = 6, /* M2_speed was not finite or not plausible */
    differential_gearboxes_controller_fault_flange3_torque = 7, /* flange3_torque was not finite or not plausible */
    differential_gearboxes_controller_fault_M3_speed = 8, /* M3_speed was not finite or not plausible */
    differential_gearboxes_controller_fault_M1_torque_ref = 9, /* M1_torque_ref was not finite or not plausible */
    differential_gearboxes_controller_fault_M2_torque_ref = 10, /* M2_torque_ref was not finite or not plausible */
    differential_gearboxes_controller_fault_M3_torque_ref = 11, /* M3_torque_ref was not finite or not plausible */
    differential_gearboxes_controller_bad_sample_time = 2000, /* outside its range */
    differential_gearboxes_controller_bad_fault_ramp = 2001, /* outside its range */
    differential_gearboxes_controller_bad_diff_outputs_torque_ref_plausible = 2002, /* outside its range */
    differential_gearboxes_controller_bad_M2_speed_ref_plausible = 2003, /* outside its range */
    differential_gearboxes_controller_bad_M3_speed_ref_plausible = 2004, /* outside its range */
    differential_gearboxes_controller_bad_M1_speed_plausible = 2005, /* outside its range */
    differential_gearboxes_controller_bad_flange2_torque_plausible = 2006, /* outside its range */
    differential_gearboxes_controller_bad_M2_speed_plausible = 2007, /* outside its range */
    differential_gearboxes_controller_bad_flange3_torque_plausible = 2008, /* outside its range */
    differential_gearboxes_controller_bad_M3_speed_plausible = 2009, /* outside its range */
    differential_gearboxes_controller_bad_load_compensation = 2010, /* outside its range */
    differential_gearboxes_controller_bad_acceleration_torque = 2011, /* outside its range */
    differential_gearboxes_controller_bad_switch_time = 2012, /* outside its range */
    differential_gearboxes_controller_bad_M1_damping = 2013, /* outside its range */
    differential_gearboxes_controller_bad_M1_speed_rated = 2014, /* outside its range */
    differential_gearboxes_controller_bad_M1_speed_max = 2015, /* outside its range */
    differential_gearboxes_controller_bad_M1_speed_taper = 2016, /* outside its range */
    differential_gearboxes_controller_bad_M1_torque_max = 2017, /* outside its range */
    differential_gearboxes_controller_bad_M2_speed_rated = 2018, /* outside its range */
    differential_gearboxes_controller_bad_M2_speed_max = 2019, /* outside its range */
    differential_gearboxes_controller_bad_M2_speed_taper = 2020, /* outside its range */
    differential_gearboxes_controller_bad_M2_torque_max = 2021, /* outside its range */
    differential_gearboxes_controller_bad_M3_speed_rated = 2022, /* outside its range */
    differential_gearboxes_controller_bad_M3_speed_max = 2023, /* outside its range */
    differential_gearboxes_controller_bad_M3_speed_taper = 2024, /* outside its range */
    differential_gearboxes_controller_bad_M3_torque_max = 2025, /* outside its range */
    differential_gearboxes_controller_bad_M2_speed_ref_rate = 2026, /* outside its range */
    differential_gearboxes_controller_bad_M3_speed_ref_rate = 2027, /* outside its range */
    differential_gearboxes_controller_bad_M2_speed_gain = 2028, /* outside its range */
    differential_gearboxes_controller_bad_M2_speed_integral_gain = 2029, /* outside its range */
    differential_gearboxes_controller_bad_M3_speed_gain = 2030, /* outside its range */
    differential_gearboxes_controller_bad_M3_speed_integral_gain = 2031, /* outside its range */
    differential_gearboxes_controller_bad_gearbox2_ratio = 2032, /* outside its range */
    differential_gearboxes_controller_bad_gearbox3_ratio = 2033, /* outside its range */
    differential_gearboxes_controller_bad_M2_inertia = 2034, /* outside its range */
    differential_gearboxes_controller_bad_gearbox2_inertia = 2035, /* outside its range */
    differential_gearboxes_controller_bad_M3_inertia = 2036, /* outside its range */
    differential_gearboxes_controller_bad_gearbox3_inertia = 2037, /* outside its range */
    differential_gearboxes_controller_bad_M1_sensor_inertia_M2 = 2038, /* outside its range */
    differential_gearboxes_controller_bad_M1_sensor_inertia_M3 = 2039, /* outside its range */
    differential_gearboxes_controller_bad_M1_inertia_estimate = 2040, /* outside its range */
    differential_gearboxes_controller_bad_M1_feedforward = 2041, /* outside its range */
    differential_gearboxes_controller_bad_M1_torque_gain = 2042, /* outside its range */
    differential_gearboxes_controller_bad_diff_outputs_torque_ref_rate = 2043, /* outside its range */
    differential_gearboxes_controller_bad_M1_model_stiffness = 2044, /* outside its range */
    differential_gearboxes_controller_bad_M1_model_damping = 2045, /* outside its range */
    differential_gearboxes_controller_bad_M1_torque_model = 2046, /* outside its range */
    differential_gearboxes_controller_bad_diff_ratio = 2047, /* outside its range */
    differential_gearboxes_controller_bad_gearbox1_ratio = 2048, /* outside its range */
    differential_gearboxes_controller_bad_M1_torque_integral_gain = 2049, /* outside its range */
    differential_gearboxes_controller_bad_M1_damping_reserve = 2050, /* outside its range */
    differential_gearboxes_controller_bad_M1_torque_integral_limit = 2051, /* outside its range */
} differential_gearboxes_controller_status;

extern const differential_gearboxes_controller_params differential_gearboxes_controller_defaults;
extern const differential_gearboxes_controller_params differential_gearboxes_controller_conventional;

/* Name of a status, for logs. */
const char *differential_gearboxes_controller_status_text(differential_gearboxes_controller_status status);

/* Sets the initial state and prepares everything that follows from the parameters. */
differential_gearboxes_controller_status differential_gearboxes_controller_init(differential_gearboxes_controller_state *state, const differential_gearboxes_controller_params *params);

/* Checks the parameters and prepares what follows from them; the rest of the state stays. */
differential_gearboxes_controller_status differential_gearboxes_controller_update(differential_gearboxes_controller_state *state, const differential_gearboxes_controller_params *params);

/* One step. */
differential_gearboxes_controller_status differential_gearboxes_controller_step(differential_gearboxes_controller_state *state, const differential_gearboxes_controller_params *params,
    const differential_gearboxes_controller_inputs *inputs, differential_gearboxes_controller_outputs *outputs);

#endif
