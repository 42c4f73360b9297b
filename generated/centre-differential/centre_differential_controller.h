/*
 * centre_differential_controller.h: controller of the bed centre_differential
 *
 * Emitted by ptgen 0.1.0 from centre-differential.toml (SHA-256 11edcc3b908b78c3), template block.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef CENTRE_DIFFERENTIAL_CONTROLLER_H
#define CENTRE_DIFFERENTIAL_CONTROLLER_H

#include "centre_differential_support.h"

/* Parameters, in SI units; call centre_differential_controller_update after a change. */
typedef struct {
    centre_differential_real sample_time; /* step of the controller (s) */
    centre_differential_real fault_ramp; /* time from a fault to zero torque (s) */
    centre_differential_real flange2_torque_ref_plausible; /* largest plausible flange2_torque_ref (N m) */
    centre_differential_real flange3_torque_ref_plausible; /* largest plausible flange3_torque_ref (N m) */
    centre_differential_real M1_speed_ref_plausible; /* largest plausible M1_speed_ref (rad/s) */
    centre_differential_real M1_speed_plausible; /* largest plausible M1_speed (rad/s) */
    centre_differential_real flange1_torque_plausible; /* largest plausible flange1_torque (N m) */
    centre_differential_real flange2_torque_plausible; /* largest plausible flange2_torque (N m) */
    centre_differential_real M2_speed_plausible; /* largest plausible M2_speed (rad/s) */
    centre_differential_real flange3_torque_plausible; /* largest plausible flange3_torque (N m) */
    centre_differential_real M3_speed_plausible; /* largest plausible M3_speed (rad/s) */
    centre_differential_real load_compensation; /* switch of the load torque compensation, 0 to 1 */
    centre_differential_real acceleration_torque; /* switch of the acceleration torque, 0 to 1 */
    centre_differential_real switch_time; /* time in which a switch or a damping follows its parameter (s) */
    centre_differential_real M2_damping; /* active damping by M2 (5.81) (N m s/rad) */
    centre_differential_real M3_damping; /* active damping by M3 (5.81) (N m s/rad) */
    centre_differential_real M1_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    centre_differential_real M1_speed_max; /* largest admissible speed (rad/s) */
    centre_differential_real M1_speed_taper; /* speed above M1_speed_max over which accelerating torque is taken back (rad/s) */
    centre_differential_real M1_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    centre_differential_real M2_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    centre_differential_real M2_speed_max; /* largest admissible speed (rad/s) */
    centre_differential_real M2_speed_taper; /* speed above M2_speed_max over which accelerating torque is taken back (rad/s) */
    centre_differential_real M2_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    centre_differential_real M3_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    centre_differential_real M3_speed_max; /* largest admissible speed (rad/s) */
    centre_differential_real M3_speed_taper; /* speed above M3_speed_max over which accelerating torque is taken back (rad/s) */
    centre_differential_real M3_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    centre_differential_real M1_speed_ref_rate; /* largest rate of M1_speed_ref (rad/s^2) */
    centre_differential_real M1_speed_gain; /* proportional gain of the speed of M1 (N m s/rad) */
    centre_differential_real M1_speed_integral_gain; /* integral gain of the speed of M1 (N m/rad) */
    centre_differential_real M2_sensor_inertia_M1; /* torque of M2 that its sensors miss, per acceleration of M1 (kg m^2) */
    centre_differential_real M1_inertia; /* moment of inertia of the rotor (kg m^2) */
    centre_differential_real M2_inertia_estimate; /* inertia that M2 accelerates (5.78) (kg m^2) */
    centre_differential_real M2_feedforward; /* share of the torque reference fed forward to M2 */
    centre_differential_real M2_torque_gain; /* proportional gain of the torque control of M2, above -1 (5.115a) */
    centre_differential_real flange2_torque_ref_rate; /* largest rate of flange2_torque_ref (N m/s) */
    centre_differential_real M2_model_stiffness; /* stiffness in the torque model of M2 (N m/rad) */
    centre_differential_real M2_model_damping; /* damping in the torque model of M2 (N m s/rad) */
    centre_differential_real M2_torque_model; /* switch of the torque model of M2, 0 to 1 */
    centre_differential_real M3_sensor_inertia_M1; /* torque of M3 that its sensors miss, per acceleration of M1 (kg m^2) */
    centre_differential_real M3_inertia_estimate; /* inertia that M3 accelerates (5.78) (kg m^2) */
    centre_differential_real M3_feedforward; /* share of the torque reference fed forward to M3 */
    centre_differential_real M3_torque_gain; /* proportional gain of the torque control of M3, above -1 (5.115a) */
    centre_differential_real flange3_torque_ref_rate; /* largest rate of flange3_torque_ref (N m/s) */
    centre_differential_real M3_model_stiffness; /* stiffness in the torque model of M3 (N m/rad) */
    centre_differential_real M3_model_damping; /* damping in the torque model of M3 (N m s/rad) */
    centre_differential_real M3_torque_model; /* switch of the torque model of M3, 0 to 1 */
    centre_differential_real cardan2_flange2_equivalent_stiffness; /* equivalent stiffness cardan2_flange2 (N m/rad) */
    centre_differential_real flange1_cardan1_cardan2_flange2_equivalent_stiffness; /* equivalent stiffness flange1_cardan1_cardan2_flange2 (N m/rad) */
    centre_differential_real diff_ratio; /* ratio i_d of input speed to mean output speed */
    centre_differential_real M2_torque_integral_gain; /* integral gain of the torque control of M2 (1/s) */
    centre_differential_real M2_damping_reserve; /* share of the torque of M2 kept for damping */
    centre_differential_real M2_torque_integral_limit; /* limit of the torque integrator of M2 (N m) */
    centre_differential_real flange1_cardan1_equivalent_stiffness; /* equivalent stiffness flange1_cardan1 (N m/rad) */
    centre_differential_real M3_torque_integral_gain; /* integral gain of the torque control of M3 (1/s) */
    centre_differential_real M3_damping_reserve; /* share of the torque of M3 kept for damping */
    centre_differential_real M3_torque_integral_limit; /* limit of the torque integrator of M3 (N m) */
} centre_differential_controller_params;

/* Inputs of a step. */
typedef struct {
    centre_differential_real flange2_torque_ref; /* reference (N m) */
    centre_differential_real flange3_torque_ref; /* reference (N m) */
    centre_differential_real M1_speed_ref; /* reference (rad/s) */
    centre_differential_real M1_speed; /* measured (rad/s) */
    centre_differential_real flange1_torque; /* measured (N m) */
    centre_differential_real flange2_torque; /* measured (N m) */
    centre_differential_real M2_speed; /* measured (rad/s) */
    centre_differential_real flange3_torque; /* measured (N m) */
    centre_differential_real M3_speed; /* measured (rad/s) */
} centre_differential_controller_inputs;

/* Outputs of a step; torques are positive when they drive the right-hand neighbour. */
typedef struct {
    centre_differential_real M1_torque_ref; /* air-gap torque reference of M1 (N m) */
    centre_differential_real M2_torque_ref; /* air-gap torque reference of M2 (N m) */
    centre_differential_real M3_torque_ref; /* air-gap torque reference of M3 (N m) */
} centre_differential_controller_outputs;

/* States first, then what follows from the parameters. Matrices are stored by columns. */
typedef struct {
    centre_differential_real fault; /* 0, or the number of the input that failed */
    centre_differential_real flange2_torque_ref_held; /* last sound value of flange2_torque_ref (N m) */
    centre_differential_real flange3_torque_ref_held; /* last sound value of flange3_torque_ref (N m) */
    centre_differential_real M1_speed_ref_held; /* last sound value of M1_speed_ref (rad/s) */
    centre_differential_real M1_speed_held; /* last sound value of M1_speed (rad/s) */
    centre_differential_real flange1_torque_held; /* last sound value of flange1_torque (N m) */
    centre_differential_real flange2_torque_held; /* last sound value of flange2_torque (N m) */
    centre_differential_real M2_speed_held; /* last sound value of M2_speed (rad/s) */
    centre_differential_real flange3_torque_held; /* last sound value of flange3_torque (N m) */
    centre_differential_real M3_speed_held; /* last sound value of M3_speed (rad/s) */
    centre_differential_real load_compensation_now; /* load_compensation on its way to the parameter */
    centre_differential_real load_compensation_target; /* load_compensation as the last step found it */
    centre_differential_real load_compensation_step; /* how far load_compensation moves in a step */
    centre_differential_real running; /* 1 once a step was done without a fault */
    centre_differential_real acceleration_torque_now; /* acceleration_torque on its way to the parameter */
    centre_differential_real acceleration_torque_target; /* acceleration_torque as the last step found it */
    centre_differential_real acceleration_torque_step; /* how far acceleration_torque moves in a step */
    centre_differential_real M2_damping_now; /* M2_damping on its way to the parameter (N m s/rad) */
    centre_differential_real M2_damping_target; /* M2_damping as the last step found it (N m s/rad) */
    centre_differential_real M2_damping_step; /* how far M2_damping moves in a step (N m s/rad) */
    centre_differential_real M3_damping_now; /* M3_damping on its way to the parameter (N m s/rad) */
    centre_differential_real M3_damping_target; /* M3_damping as the last step found it (N m s/rad) */
    centre_differential_real M3_damping_step; /* how far M3_damping moves in a step (N m s/rad) */
    centre_differential_real M1_speed_ref_limited; /* M1_speed_ref behind its rate limiter (rad/s) */
    centre_differential_real M1_speed_integral; /* integrator of the speed control of M1 (N m) */
    centre_differential_real flange2_torque_ref_limited; /* flange2_torque_ref behind its rate limiter (N m) */
    centre_differential_real M2_model_torque; /* torque that the feedforward to M2 should give (N m) */
    centre_differential_real M2_model_rate; /* rate of the torque model of M2 (N m/s) */
    centre_differential_real M2_torque_integral; /* integrator of the torque control of M2 (N m) */
    centre_differential_real flange3_torque_ref_limited; /* flange3_torque_ref behind its rate limiter (N m) */
    centre_differential_real M3_model_torque; /* torque that the feedforward to M3 should give (N m) */
    centre_differential_real M3_model_rate; /* rate of the torque model of M3 (N m/s) */
    centre_differential_real M3_torque_integral; /* integrator of the torque control of M3 (N m) */
    centre_differential_real M1_last; /* last torque of M1 before a fault (N m) */
    centre_differential_real M2_last; /* last torque of M2 before a fault (N m) */
    centre_differential_real M3_last; /* last torque of M3 before a fault (N m) */
    centre_differential_real authority; /* 1, going to 0 along the ramp after a fault */
    centre_differential_real switch_share; /* share of a change per step */
    centre_differential_real M1_taper_slope; /* share of the torque of M1 per excess of speed (s/rad) */
    centre_differential_real M1_taper_end; /* share at standstill if it were not limited */
    centre_differential_real M2_taper_slope; /* share of the torque of M2 per excess of speed (s/rad) */
    centre_differential_real M2_taper_end; /* share at standstill if it were not limited */
    centre_differential_real M3_taper_slope; /* share of the torque of M3 per excess of speed (s/rad) */
    centre_differential_real M3_taper_end; /* share at standstill if it were not limited */
    centre_differential_real M1_speed_ref_step; /* largest change of M1_speed_ref in a step (rad/s) */
    centre_differential_real M1_speed_growth; /* growth of the integrator per error (N m s/rad) */
    centre_differential_real M1_speed_conditioning; /* growth per torque cut off */
    centre_differential_real M2_unread_M1; /* the same per net torque */
    centre_differential_real flange2_torque_ref_step; /* largest change of flange2_torque_ref in a step (N m) */
    centre_differential_real M2_model_pull; /* rate of the torque model per missing torque (1/s) */
    centre_differential_real M2_model_drag; /* decay of that rate in a step */
    centre_differential_real M3_unread_M1; /* the same per net torque */
    centre_differential_real flange3_torque_ref_step; /* largest change of flange3_torque_ref in a step (N m) */
    centre_differential_real M3_model_pull; /* rate of the torque model per missing torque (1/s) */
    centre_differential_real M3_model_drag; /* decay of that rate in a step */
    centre_differential_real M2_twist_M1_speed; /* coefficient of M1_speed */
    centre_differential_real M2_twist_M3_speed; /* coefficient of M3_speed */
    centre_differential_real M2_torque_growth; /* growth of the integrator per error */
    centre_differential_real M3_twist_M1_speed; /* coefficient of M1_speed */
    centre_differential_real M3_twist_M2_speed; /* coefficient of M2_speed */
    centre_differential_real M3_torque_growth; /* growth of the integrator per error */
} centre_differential_controller_state;

typedef enum {
    centre_differential_controller_ok = 0,
    centre_differential_controller_fault_flange2_torque_ref = 1, /* flange2_torque_ref was not finite or not plausible */
    centre_differential_controller_fault_flange3_torque_ref = 2, /* flange3_torque_ref was not finite or not plausible */
    centre_differential_controller_fault_M1_speed_ref = 3, /* M1_speed_ref was not finite or not plausible */
    centre_differential_controller_fault_M1_speed = 4, /* M1_speed was not finite or not plausible */
    centre_differential_controller_fault_flange1_torque = 5, /* flange1_torque was not finite or not plausible */
    centre_differential_controller_fault_flange2_torque = 6, /* flange2_torque was not finite or not plausible */
    centre_differential_controller_fault_M2_speed = 7, /* M2_speed was not finite or not plausible */
    centre_differential_controller_fault_flange3_torque = 8, /* flange3_torque was not finite or not plausible */
    centre_differential_controller_fault_M3_speed = 9, /* M3_speed was not finite or not plausible */
    centre_differential_controller_fault_M1_torque_ref = 10, /* M1_torque_ref was not finite or not plausible */
    centre_differential_controller_fault_M2_torque_ref = 11, /* M2_torque_ref was not finite or not plausible */
    centre_differential_controller_fault_M3_torque_ref = 12, /* M3_torque_ref was not finite or not plausible */
    centre_differential_controller_bad_sample_time = 2000, /* outside its range */
    centre_differential_controller_bad_fault_ramp = 2001, /* outside its range */
    centre_differential_controller_bad_flange2_torque_ref_plausible = 2002, /* outside its range */
    centre_differential_controller_bad_flange3_torque_ref_plausible = 2003, /* outside its range */
    centre_differential_controller_bad_M1_speed_ref_plausible = 2004, /* outside its range */
    centre_differential_controller_bad_M1_speed_plausible = 2005, /* outside its range */
    centre_differential_controller_bad_flange1_torque_plausible = 2006, /* outside its range */
    centre_differential_controller_bad_flange2_torque_plausible = 2007, /* outside its range */
    centre_differential_controller_bad_M2_speed_plausible = 2008, /* outside its range */
    centre_differential_controller_bad_flange3_torque_plausible = 2009, /* outside its range */
    centre_differential_controller_bad_M3_speed_plausible = 2010, /* outside its range */
    centre_differential_controller_bad_load_compensation = 2011, /* outside its range */
    centre_differential_controller_bad_acceleration_torque = 2012, /* outside its range */
    centre_differential_controller_bad_switch_time = 2013, /* outside its range */
    centre_differential_controller_bad_M2_damping = 2014, /* outside its range */
    centre_differential_controller_bad_M3_damping = 2015, /* outside its range */
    centre_differential_controller_bad_M1_speed_rated = 2016, /* outside its range */
    centre_differential_controller_bad_M1_speed_max = 2017, /* outside its range */
    centre_differential_controller_bad_M1_speed_taper = 2018, /* outside its range */
    centre_differential_controller_bad_M1_torque_max = 2019, /* outside its range */
    centre_differential_controller_bad_M2_speed_rated = 2020, /* outside its range */
    centre_differential_controller_bad_M2_speed_max = 2021, /* outside its range */
    centre_differential_controller_bad_M2_speed_taper = 2022, /* outside its range */
    centre_differential_controller_bad_M2_torque_max = 2023, /* outside its range */
    centre_differential_controller_bad_M3_speed_rated = 2024, /* outside its range */
    centre_differential_controller_bad_M3_speed_max = 2025, /* outside its range */
    centre_differential_controller_bad_M3_speed_taper = 2026, /* outside its range */
    centre_differential_controller_bad_M3_torque_max = 2027, /* outside its range */
    centre_differential_controller_bad_M1_speed_ref_rate = 2028, /* outside its range */
    centre_differential_controller_bad_M1_speed_gain = 2029, /* outside its range */
    centre_differential_controller_bad_M1_speed_integral_gain = 2030, /* outside its range */
    centre_differential_controller_bad_M2_sensor_inertia_M1 = 2031, /* outside its range */
    centre_differential_controller_bad_M1_inertia = 2032, /* outside its range */
    centre_differential_controller_bad_M2_inertia_estimate = 2033, /* outside its range */
    centre_differential_controller_bad_M2_feedforward = 2034, /* outside its range */
    centre_differential_controller_bad_M2_torque_gain = 2035, /* outside its range */
    centre_differential_controller_bad_flange2_torque_ref_rate = 2036, /* outside its range */
    centre_differential_controller_bad_M2_model_stiffness = 2037, /* outside its range */
    centre_differential_controller_bad_M2_model_damping = 2038, /* outside its range */
    centre_differential_controller_bad_M2_torque_model = 2039, /* outside its range */
    centre_differential_controller_bad_M3_sensor_inertia_M1 = 2040, /* outside its range */
    centre_differential_controller_bad_M3_inertia_estimate = 2041, /* outside its range */
    centre_differential_controller_bad_M3_feedforward = 2042, /* outside its range */
    centre_differential_controller_bad_M3_torque_gain = 2043, /* outside its range */
    centre_differential_controller_bad_flange3_torque_ref_rate = 2044, /* outside its range */
    centre_differential_controller_bad_M3_model_stiffness = 2045, /* outside its range */
    centre_differential_controller_bad_M3_model_damping = 2046, /* outside its range */
    centre_differential_controller_bad_M3_torque_model = 2047, /* outside its range */
    centre_differential_controller_bad_cardan2_flange2_equivalent_stiffness = 2048, /* outside its range */
    centre_differential_controller_bad_flange1_cardan1_cardan2_flange2_equivalent_stiffness = 2049, /* outside its range */
    centre_differential_controller_bad_diff_ratio = 2050, /* outside its range */
    centre_differential_controller_bad_M2_torque_integral_gain = 2051, /* outside its range */
    centre_differential_controller_bad_M2_damping_reserve = 2052, /* outside its range */
    centre_differential_controller_bad_M2_torque_integral_limit = 2053, /* outside its range */
    centre_differential_controller_bad_flange1_cardan1_equivalent_stiffness = 2054, /* outside its range */
    centre_differential_controller_bad_M3_torque_integral_gain = 2055, /* outside its range */
    centre_differential_controller_bad_M3_damping_reserve = 2056, /* outside its range */
    centre_differential_controller_bad_M3_torque_integral_limit = 2057, /* outside its range */
} centre_differential_controller_status;

extern const centre_differential_controller_params centre_differential_controller_defaults;
extern const centre_differential_controller_params centre_differential_controller_conventional;

/* Name of a status, for logs. */
const char *centre_differential_controller_status_text(centre_differential_controller_status status);

/* Sets the initial state and prepares everything that follows from the parameters. */
centre_differential_controller_status centre_differential_controller_init(centre_differential_controller_state *state, const centre_differential_controller_params *params);

/* Checks the parameters and prepares what follows from them; the rest of the state stays. */
centre_differential_controller_status centre_differential_controller_update(centre_differential_controller_state *state, const centre_differential_controller_params *params);

/* One step. */
centre_differential_controller_status centre_differential_controller_step(centre_differential_controller_state *state, const centre_differential_controller_params *params,
    const centre_differential_controller_inputs *inputs, centre_differential_controller_outputs *outputs);

#endif
