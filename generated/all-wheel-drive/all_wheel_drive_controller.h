/*
 * all_wheel_drive_controller.h: controller of the bed all_wheel_drive
 *
 * Emitted by ptgen 0.1.0 from all-wheel-drive.toml (SHA-256 4a4f0cf573c3f3c3), template block.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef ALL_WHEEL_DRIVE_CONTROLLER_H
#define ALL_WHEEL_DRIVE_CONTROLLER_H

#include "all_wheel_drive_support.h"

/* Parameters, in SI units; call all_wheel_drive_controller_update after a change. */
typedef struct {
    all_wheel_drive_real sample_time; /* step of the controller (s) */
    all_wheel_drive_real fault_ramp; /* time from a fault to zero torque (s) */
    all_wheel_drive_real centre_input_torque_ref_plausible; /* largest plausible centre_input_torque_ref (N m) */
    all_wheel_drive_real M2_speed_ref_plausible; /* largest plausible M2_speed_ref (rad/s) */
    all_wheel_drive_real M3_speed_ref_plausible; /* largest plausible M3_speed_ref (rad/s) */
    all_wheel_drive_real M4_speed_ref_plausible; /* largest plausible M4_speed_ref (rad/s) */
    all_wheel_drive_real M5_speed_ref_plausible; /* largest plausible M5_speed_ref (rad/s) */
    all_wheel_drive_real M1_speed_plausible; /* largest plausible M1_speed (rad/s) */
    all_wheel_drive_real flange1_torque_plausible; /* largest plausible flange1_torque (N m) */
    all_wheel_drive_real flange2_torque_plausible; /* largest plausible flange2_torque (N m) */
    all_wheel_drive_real M2_speed_plausible; /* largest plausible M2_speed (rad/s) */
    all_wheel_drive_real flange3_torque_plausible; /* largest plausible flange3_torque (N m) */
    all_wheel_drive_real M3_speed_plausible; /* largest plausible M3_speed (rad/s) */
    all_wheel_drive_real flange4_torque_plausible; /* largest plausible flange4_torque (N m) */
    all_wheel_drive_real M4_speed_plausible; /* largest plausible M4_speed (rad/s) */
    all_wheel_drive_real flange5_torque_plausible; /* largest plausible flange5_torque (N m) */
    all_wheel_drive_real M5_speed_plausible; /* largest plausible M5_speed (rad/s) */
    all_wheel_drive_real load_compensation; /* switch of the load torque compensation, 0 to 1 */
    all_wheel_drive_real acceleration_torque; /* switch of the acceleration torque, 0 to 1 */
    all_wheel_drive_real switch_time; /* time in which a switch or a damping follows its parameter (s) */
    all_wheel_drive_real M1_damping; /* active damping by M1 (5.81) (N m s/rad) */
    all_wheel_drive_real M1_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    all_wheel_drive_real M1_speed_max; /* largest admissible speed (rad/s) */
    all_wheel_drive_real M1_speed_taper; /* speed above M1_speed_max over which accelerating torque is taken back (rad/s) */
    all_wheel_drive_real M1_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    all_wheel_drive_real M2_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    all_wheel_drive_real M2_speed_max; /* largest admissible speed (rad/s) */
    all_wheel_drive_real M2_speed_taper; /* speed above M2_speed_max over which accelerating torque is taken back (rad/s) */
    all_wheel_drive_real M2_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    all_wheel_drive_real M3_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    all_wheel_drive_real M3_speed_max; /* largest admissible speed (rad/s) */
    all_wheel_drive_real M3_speed_taper; /* speed above M3_speed_max over which accelerating torque is taken back (rad/s) */
    all_wheel_drive_real M3_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    all_wheel_drive_real M4_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    all_wheel_drive_real M4_speed_max; /* largest admissible speed (rad/s) */
    all_wheel_drive_real M4_speed_taper; /* speed above M4_speed_max over which accelerating torque is taken back (rad/s) */
    all_wheel_drive_real M4_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    all_wheel_drive_real M5_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    all_wheel_drive_real M5_speed_max; /* largest admissible speed (rad/s) */
    all_wheel_drive_real M5_speed_taper; /* speed above M5_speed_max over which accelerating torque is taken back (rad/s) */
    all_wheel_drive_real M5_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    all_wheel_drive_real M2_speed_ref_rate; /* largest rate of M2_speed_ref (rad/s^2) */
    all_wheel_drive_real M3_speed_ref_rate; /* largest rate of M3_speed_ref (rad/s^2) */
    all_wheel_drive_real M4_speed_ref_rate; /* largest rate of M4_speed_ref (rad/s^2) */
    all_wheel_drive_real M5_speed_ref_rate; /* largest rate of M5_speed_ref (rad/s^2) */
    all_wheel_drive_real M2_speed_gain; /* proportional gain of the speed of M2 (N m s/rad) */
    all_wheel_drive_real M2_speed_integral_gain; /* integral gain of the speed of M2 (N m/rad) */
    all_wheel_drive_real M3_speed_gain; /* proportional gain of the speed of M3 (N m s/rad) */
    all_wheel_drive_real M3_speed_integral_gain; /* integral gain of the speed of M3 (N m/rad) */
    all_wheel_drive_real M4_speed_gain; /* proportional gain of the speed of M4 (N m s/rad) */
    all_wheel_drive_real M4_speed_integral_gain; /* integral gain of the speed of M4 (N m/rad) */
    all_wheel_drive_real M5_speed_gain; /* proportional gain of the speed of M5 (N m s/rad) */
    all_wheel_drive_real M5_speed_integral_gain; /* integral gain of the speed of M5 (N m/rad) */
    all_wheel_drive_real M1_sensor_inertia_M2; /* torque of M1 that its sensors miss, per acceleration of M2 (kg m^2) */
    all_wheel_drive_real M2_inertia; /* moment of inertia of the rotor (kg m^2) */
    all_wheel_drive_real M1_sensor_inertia_M3; /* torque of M1 that its sensors miss, per acceleration of M3 (kg m^2) */
    all_wheel_drive_real M3_inertia; /* moment of inertia of the rotor (kg m^2) */
    all_wheel_drive_real M1_sensor_inertia_M4; /* torque of M1 that its sensors miss, per acceleration of M4 (kg m^2) */
    all_wheel_drive_real M4_inertia; /* moment of inertia of the rotor (kg m^2) */
    all_wheel_drive_real M1_sensor_inertia_M5; /* torque of M1 that its sensors miss, per acceleration of M5 (kg m^2) */
    all_wheel_drive_real M5_inertia; /* moment of inertia of the rotor (kg m^2) */
    all_wheel_drive_real M1_inertia_estimate; /* inertia that M1 accelerates (5.78) (kg m^2) */
    all_wheel_drive_real M1_feedforward; /* share of the torque reference fed forward to M1 */
    all_wheel_drive_real M1_torque_gain; /* proportional gain of the torque control of M1, above -1 (5.115a) */
    all_wheel_drive_real centre_input_torque_ref_rate; /* largest rate of centre_input_torque_ref (N m/s) */
    all_wheel_drive_real M1_model_stiffness; /* stiffness in the torque model of M1 (N m/rad) */
    all_wheel_drive_real M1_model_damping; /* damping in the torque model of M1 (N m s/rad) */
    all_wheel_drive_real M1_torque_model; /* switch of the torque model of M1, 0 to 1 */
    all_wheel_drive_real centre_ratio; /* ratio i_d of input speed to mean output speed */
    all_wheel_drive_real front_ratio; /* ratio i_d of input speed to mean output speed */
    all_wheel_drive_real rear_ratio; /* ratio i_d of input speed to mean output speed */
    all_wheel_drive_real M1_torque_integral_gain; /* integral gain of the torque control of M1 (1/s) */
    all_wheel_drive_real M1_damping_reserve; /* share of the torque of M1 kept for damping */
    all_wheel_drive_real M1_torque_integral_limit; /* limit of the torque integrator of M1 (N m) */
} all_wheel_drive_controller_params;

/* Inputs of a step. */
typedef struct {
    all_wheel_drive_real centre_input_torque_ref; /* reference (N m) */
    all_wheel_drive_real M2_speed_ref; /* reference (rad/s) */
    all_wheel_drive_real M3_speed_ref; /* reference (rad/s) */
    all_wheel_drive_real M4_speed_ref; /* reference (rad/s) */
    all_wheel_drive_real M5_speed_ref; /* reference (rad/s) */
    all_wheel_drive_real M1_speed; /* measured (rad/s) */
    all_wheel_drive_real flange1_torque; /* measured (N m) */
    all_wheel_drive_real flange2_torque; /* measured (N m) */
    all_wheel_drive_real M2_speed; /* measured (rad/s) */
    all_wheel_drive_real flange3_torque; /* measured (N m) */
    all_wheel_drive_real M3_speed; /* measured (rad/s) */
    all_wheel_drive_real flange4_torque; /* measured (N m) */
    all_wheel_drive_real M4_speed; /* measured (rad/s) */
    all_wheel_drive_real flange5_torque; /* measured (N m) */
    all_wheel_drive_real M5_speed; /* measured (rad/s) */
} all_wheel_drive_controller_inputs;

/* Outputs of a step; torques are positive when they drive the right-hand neighbour. */
typedef struct {
    all_wheel_drive_real M1_torque_ref; /* air-gap torque reference of M1 (N m) */
    all_wheel_drive_real M2_torque_ref; /* air-gap torque reference of M2 (N m) */
    all_wheel_drive_real M3_torque_ref; /* air-gap torque reference of M3 (N m) */
    all_wheel_drive_real M4_torque_ref; /* air-gap torque reference of M4 (N m) */
    all_wheel_drive_real M5_torque_ref; /* air-gap torque reference of M5 (N m) */
} all_wheel_drive_controller_outputs;

/* States first, then what follows from the parameters. Matrices are stored by columns. */
typedef struct {
    all_wheel_drive_real fault; /* 0, or the number of the input that failed */
    all_wheel_drive_real centre_input_torque_ref_held; /* last sound value of centre_input_torque_ref (N m) */
    all_wheel_drive_real M2_speed_ref_held; /* last sound value of M2_speed_ref (rad/s) */
    all_wheel_drive_real M3_speed_ref_held; /* last sound value of M3_speed_ref (rad/s) */
    all_wheel_drive_real M4_speed_ref_held; /* last sound value of M4_speed_ref (rad/s) */
    all_wheel_drive_real M5_speed_ref_held; /* last sound value of M5_speed_ref (rad/s) */
    all_wheel_drive_real M1_speed_held; /* last sound value of M1_speed (rad/s) */
    all_wheel_drive_real flange1_torque_held; /* last sound value of flange1_torque (N m) */
    all_wheel_drive_real flange2_torque_held; /* last sound value of flange2_torque (N m) */
    all_wheel_drive_real M2_speed_held; /* last sound value of M2_speed (rad/s) */
    all_wheel_drive_real flange3_torque_held; /* last sound value of flange3_torque (N m) */
    all_wheel_drive_real M3_speed_held; /* last sound value of M3_speed (rad/s) */
    all_wheel_drive_real flange4_torque_held; /* last sound value of flange4_torque (N m) */
    all_wheel_drive_real M4_speed_held; /* last sound value of M4_speed (rad/s) */
    all_wheel_drive_real flange5_torque_held; /* last sound value of flange5_torque (N m) */
    all_wheel_drive_real M5_speed_held; /* last sound value of M5_speed (rad/s) */
    all_wheel_drive_real load_compensation_now; /* load_compensation on its way to the parameter */
    all_wheel_drive_real load_compensation_target; /* load_compensation as the last step found it */
    all_wheel_drive_real load_compensation_step; /* how far load_compensation moves in a step */
    all_wheel_drive_real running; /* 1 once a step was done without a fault */
    all_wheel_drive_real acceleration_torque_now; /* acceleration_torque on its way to the parameter */
    all_wheel_drive_real acceleration_torque_target; /* acceleration_torque as the last step found it */
    all_wheel_drive_real acceleration_torque_step; /* how far acceleration_torque moves in a step */
    all_wheel_drive_real M1_damping_now; /* M1_damping on its way to the parameter (N m s/rad) */
    all_wheel_drive_real M1_damping_target; /* M1_damping as the last step found it (N m s/rad) */
    all_wheel_drive_real M1_damping_step; /* how far M1_damping moves in a step (N m s/rad) */
    all_wheel_drive_real M2_speed_ref_limited; /* M2_speed_ref behind its rate limiter (rad/s) */
    all_wheel_drive_real M3_speed_ref_limited; /* M3_speed_ref behind its rate limiter (rad/s) */
    all_wheel_drive_real M4_speed_ref_limited; /* M4_speed_ref behind its rate limiter (rad/s) */
    all_wheel_drive_real M5_speed_ref_limited; /* M5_speed_ref behind its rate limiter (rad/s) */
    all_wheel_drive_real M2_speed_integral; /* integrator of the speed control of M2 (N m) */
    all_wheel_drive_real M3_speed_integral; /* integrator of the speed control of M3 (N m) */
    all_wheel_drive_real M4_speed_integral; /* integrator of the speed control of M4 (N m) */
    all_wheel_drive_real M5_speed_integral; /* integrator of the speed control of M5 (N m) */
    all_wheel_drive_real centre_input_torque_ref_limited; /* centre_input_torque_ref behind its rate limiter (N m) */
    all_wheel_drive_real M1_model_torque; /* torque that the feedforward to M1 should give (N m) */
    all_wheel_drive_real M1_model_rate; /* rate of the torque model of M1 (N m/s) */
    all_wheel_drive_real M1_torque_integral; /* integrator of the torque control of M1 (N m) */
    all_wheel_drive_real M1_last; /* last torque of M1 before a fault (N m) */
    all_wheel_drive_real M2_last; /* last torque of M2 before a fault (N m) */
    all_wheel_drive_real M3_last; /* last torque of M3 before a fault (N m) */
    all_wheel_drive_real M4_last; /* last torque of M4 before a fault (N m) */
    all_wheel_drive_real M5_last; /* last torque of M5 before a fault (N m) */
    all_wheel_drive_real authority; /* 1, going to 0 along the ramp after a fault */
    all_wheel_drive_real switch_share; /* share of a change per step */
    all_wheel_drive_real M1_taper_slope; /* share of the torque of M1 per excess of speed (s/rad) */
    all_wheel_drive_real M1_taper_end; /* share at standstill if it were not limited */
    all_wheel_drive_real M2_taper_slope; /* share of the torque of M2 per excess of speed (s/rad) */
    all_wheel_drive_real M2_taper_end; /* share at standstill if it were not limited */
    all_wheel_drive_real M3_taper_slope; /* share of the torque of M3 per excess of speed (s/rad) */
    all_wheel_drive_real M3_taper_end; /* share at standstill if it were not limited */
    all_wheel_drive_real M4_taper_slope; /* share of the torque of M4 per excess of speed (s/rad) */
    all_wheel_drive_real M4_taper_end; /* share at standstill if it were not limited */
    all_wheel_drive_real M5_taper_slope; /* share of the torque of M5 per excess of speed (s/rad) */
    all_wheel_drive_real M5_taper_end; /* share at standstill if it were not limited */
    all_wheel_drive_real M2_speed_ref_step; /* largest change of M2_speed_ref in a step (rad/s) */
    all_wheel_drive_real M3_speed_ref_step; /* largest change of M3_speed_ref in a step (rad/s) */
    all_wheel_drive_real M4_speed_ref_step; /* largest change of M4_speed_ref in a step (rad/s) */
    all_wheel_drive_real M5_speed_ref_step; /* largest change of M5_speed_ref in a step (rad/s) */
    all_wheel_drive_real M2_speed_growth; /* growth of the integrator per error (N m s/rad) */
    all_wheel_drive_real M2_speed_conditioning; /* growth per torque cut off */
    all_wheel_drive_real M3_speed_growth; /* growth of the integrator per error (N m s/rad) */
    all_wheel_drive_real M3_speed_conditioning; /* growth per torque cut off */
    all_wheel_drive_real M4_speed_growth; /* growth of the integrator per error (N m s/rad) */
    all_wheel_drive_real M4_speed_conditioning; /* growth per torque cut off */
    all_wheel_drive_real M5_speed_growth; /* growth of the integrator per error (N m s/rad) */
    all_wheel_drive_real M5_speed_conditioning; /* growth per torque cut off */
    all_wheel_drive_real M1_unread_M2; /* the same per net torque */
    all_wheel_drive_real M1_unread_M3; /* the same per net torque */
    all_wheel_drive_real M1_unread_M4; /* the same per net torque */
    all_wheel_drive_real M1_unread_M5; /* the same per net torque */
    all_wheel_drive_real centre_input_torque_ref_step; /* largest change of centre_input_torque_ref in a step (N m) */
    all_wheel_drive_real M1_model_pull; /* rate of the torque model per missing torque (1/s) */
    all_wheel_drive_real M1_model_drag; /* decay of that rate in a step */
    all_wheel_drive_real M1_with_M2; /* coefficient of the virtual input of M2 */
    all_wheel_drive_real M1_with_M3; /* coefficient of the virtual input of M3 */
    all_wheel_drive_real M1_with_M4; /* coefficient of the virtual input of M4 */
    all_wheel_drive_real M1_with_M5; /* coefficient of the virtual input of M5 */
    all_wheel_drive_real M1_twist_M2_speed; /* coefficient of M2_speed */
    all_wheel_drive_real M1_twist_M3_speed; /* coefficient of M3_speed */
    all_wheel_drive_real M1_twist_M4_speed; /* coefficient of M4_speed */
    all_wheel_drive_real M1_twist_M5_speed; /* coefficient of M5_speed */
    all_wheel_drive_real M1_torque_growth; /* growth of the integrator per error */
} all_wheel_drive_controller_state;

typedef enum {
    all_wheel_drive_controller_ok = 0,
    all_wheel_drive_controller_fault_centre_input_torque_ref = 1, /* centre_input_torque_ref was not finite or not plausible */
    all_wheel_drive_controller_fault_M2_speed_ref = 2, /* M2_speed_ref was not finite or not plausible */
    all_wheel_drive_controller_fault_M3_speed_ref = 3, /* M3_speed_ref was not finite or not plausible */
    all_wheel_drive_controller_fault_M4_speed_ref = 4, /* M4_speed_ref was not finite or not plausible */
    all_wheel_drive_controller_fault_M5_speed_ref = 5, /* M5_speed_ref was not finite or not plausible */
    all_wheel_drive_controller_fault_M1_speed = 6, /* M1_speed was not finite or not plausible */
    all_wheel_drive_controller_fault_flange1_torque = 7, /* flange1_torque was not finite or not plausible */
    all_wheel_drive_controller_fault_flange2_torque = 8, /* flange2_torque was not finite or not plausible */
    all_wheel_drive_controller_fault_M2_speed = 9, /* M2_speed was not finite or not plausible */
    all_wheel_drive_controller_fault_flange3_torque = 10, /* flange3_torque was not finite or not plausible */
    all_wheel_drive_controller_fault_M3_speed = 11, /* M3_speed was not finite or not plausible */
    all_wheel_drive_controller_fault_flange4_torque = 12, /* flange4_torque was not finite or not plausible */
    all_wheel_drive_controller_fault_M4_speed = 13, /* M4_speed was not finite or not plausible */
    all_wheel_drive_controller_fault_flange5_torque = 14, /* flange5_torque was not finite or not plausible */
    all_wheel_drive_controller_fault_M5_speed = 15, /* M5_speed was not finite or not plausible */
    all_wheel_drive_controller_fault_M1_torque_ref = 16, /* M1_torque_ref was not finite or not plausible */
    all_wheel_drive_controller_fault_M2_torque_ref = 17, /* M2_torque_ref was not finite or not plausible */
    all_wheel_drive_controller_fault_M3_torque_ref = 18, /* M3_torque_ref was not finite or not plausible */
    all_wheel_drive_controller_fault_M4_torque_ref = 19, /* M4_torque_ref was not finite or not plausible */
    all_wheel_drive_controller_fault_M5_torque_ref = 20, /* M5_torque_ref was not finite or not plausible */
    all_wheel_drive_controller_bad_sample_time = 2000, /* outside its range */
    all_wheel_drive_controller_bad_fault_ramp = 2001, /* outside its range */
    all_wheel_drive_controller_bad_centre_input_torque_ref_plausible = 2002, /* outside its range */
    all_wheel_drive_controller_bad_M2_speed_ref_plausible = 2003, /* outside its range */
    all_wheel_drive_controller_bad_M3_speed_ref_plausible = 2004, /* outside its range */
    all_wheel_drive_controller_bad_M4_speed_ref_plausible = 2005, /* outside its range */
    all_wheel_drive_controller_bad_M5_speed_ref_plausible = 2006, /* outside its range */
    all_wheel_drive_controller_bad_M1_speed_plausible = 2007, /* outside its range */
    all_wheel_drive_controller_bad_flange1_torque_plausible = 2008, /* outside its range */
    all_wheel_drive_controller_bad_flange2_torque_plausible = 2009, /* outside its range */
    all_wheel_drive_controller_bad_M2_speed_plausible = 2010, /* outside its range */
    all_wheel_drive_controller_bad_flange3_torque_plausible = 2011, /* outside its range */
    all_wheel_drive_controller_bad_M3_speed_plausible = 2012, /* outside its range */
    all_wheel_drive_controller_bad_flange4_torque_plausible = 2013, /* outside its range */
    all_wheel_drive_controller_bad_M4_speed_plausible = 2014, /* outside its range */
    all_wheel_drive_controller_bad_flange5_torque_plausible = 2015, /* outside its range */
    all_wheel_drive_controller_bad_M5_speed_plausible = 2016, /* outside its range */
    all_wheel_drive_controller_bad_load_compensation = 2017, /* outside its range */
    all_wheel_drive_controller_bad_acceleration_torque = 2018, /* outside its range */
    all_wheel_drive_controller_bad_switch_time = 2019, /* outside its range */
    all_wheel_drive_controller_bad_M1_damping = 2020, /* outside its range */
    all_wheel_drive_controller_bad_M1_speed_rated = 2021, /* outside its range */
    all_wheel_drive_controller_bad_M1_speed_max = 2022, /* outside its range */
    all_wheel_drive_controller_bad_M1_speed_taper = 2023, /* outside its range */
    all_wheel_drive_controller_bad_M1_torque_max = 2024, /* outside its range */
    all_wheel_drive_controller_bad_M2_speed_rated = 2025, /* outside its range */
    all_wheel_drive_controller_bad_M2_speed_max = 2026, /* outside its range */
    all_wheel_drive_controller_bad_M2_speed_taper = 2027, /* outside its range */
    all_wheel_drive_controller_bad_M2_torque_max = 2028, /* outside its range */
    all_wheel_drive_controller_bad_M3_speed_rated = 2029, /* outside its range */
    all_wheel_drive_controller_bad_M3_speed_max = 2030, /* outside its range */
    all_wheel_drive_controller_bad_M3_speed_taper = 2031, /* outside its range */
    all_wheel_drive_controller_bad_M3_torque_max = 2032, /* outside its range */
    all_wheel_drive_controller_bad_M4_speed_rated = 2033, /* outside its range */
    all_wheel_drive_controller_bad_M4_speed_max = 2034, /* outside its range */
    all_wheel_drive_controller_bad_M4_speed_taper = 2035, /* outside its range */
    all_wheel_drive_controller_bad_M4_torque_max = 2036, /* outside its range */
    all_wheel_drive_controller_bad_M5_speed_rated = 2037, /* outside its range */
    all_wheel_drive_controller_bad_M5_speed_max = 2038, /* outside its range */
    all_wheel_drive_controller_bad_M5_speed_taper = 2039, /* outside its range */
    all_wheel_drive_controller_bad_M5_torque_max = 2040, /* outside its range */
    all_wheel_drive_controller_bad_M2_speed_ref_rate = 2041, /* outside its range */
    all_wheel_drive_controller_bad_M3_speed_ref_rate = 2042, /* outside its range */
    all_wheel_drive_controller_bad_M4_speed_ref_rate = 2043, /* outside its range */
    all_wheel_drive_controller_bad_M5_speed_ref_rate = 2044, /* outside its range */
    all_wheel_drive_controller_bad_M2_speed_gain = 2045, /* outside its range */
    all_wheel_drive_controller_bad_M2_speed_integral_gain = 2046, /* outside its range */
    all_wheel_drive_controller_bad_M3_speed_gain = 2047, /* outside its range */
    all_wheel_drive_controller_bad_M3_speed_integral_gain = 2048, /* outside its range */
    all_wheel_drive_controller_bad_M4_speed_gain = 2049, /* outside its range */
    all_wheel_drive_controller_bad_M4_speed_integral_gain = 2050, /* outside its range */
    all_wheel_drive_controller_bad_M5_speed_gain = 2051, /* outside its range */
    all_wheel_drive_controller_bad_M5_speed_integral_gain = 2052, /* outside its range */
    all_wheel_drive_controller_bad_M1_sensor_inertia_M2 = 2053, /* outside its range */
    all_wheel_drive_controller_bad_M2_inertia = 2054, /* outside its range */
    all_wheel_drive_controller_bad_M1_sensor_inertia_M3 = 2055, /* outside its range */
    all_wheel_drive_controller_bad_M3_inertia = 2056, /* outside its range */
    all_wheel_drive_controller_bad_M1_sensor_inertia_M4 = 2057, /* outside its range */
    all_wheel_drive_controller_bad_M4_inertia = 2058, /* outside its range */
    all_wheel_drive_controller_bad_M1_sensor_inertia_M5 = 2059, /* outside its range */
    all_wheel_drive_controller_bad_M5_inertia = 2060, /* outside its range */
    all_wheel_drive_controller_bad_M1_inertia_estimate = 2061, /* outside its range */
    all_wheel_drive_controller_bad_M1_feedforward = 2062, /* outside its range */
    all_wheel_drive_controller_bad_M1_torque_gain = 2063, /* outside its range */
    all_wheel_drive_controller_bad_centre_input_torque_ref_rate = 2064, /* outside its range */
    all_wheel_drive_controller_bad_M1_model_stiffness = 2065, /* outside its range */
    all_wheel_drive_controller_bad_M1_model_damping = 2066, /* outside its range */
    all_wheel_drive_controller_bad_M1_torque_model = 2067, /* outside its range */
    all_wheel_drive_controller_bad_centre_ratio = 2068, /* outside its range */
    all_wheel_drive_controller_bad_front_ratio = 2069, /* outside its range */
    all_wheel_drive_controller_bad_rear_ratio = 2070, /* outside its range */
    all_wheel_drive_controller_bad_M1_torque_integral_gain = 2071, /* outside its range */
    all_wheel_drive_controller_bad_M1_damping_reserve = 2072, /* outside its range */
    all_wheel_drive_controller_bad_M1_torque_integral_limit = 2073, /* outside its range */
} all_wheel_drive_controller_status;

extern const all_wheel_drive_controller_params all_wheel_drive_controller_defaults;
extern const all_wheel_drive_controller_params all_wheel_drive_controller_conventional;

/* Name of a status, for logs. */
const char *all_wheel_drive_controller_status_text(all_wheel_drive_controller_status status);

/* Sets the initial state and prepares everything that follows from the parameters. */
all_wheel_drive_controller_status all_wheel_drive_controller_init(all_wheel_drive_controller_state *state, const all_wheel_drive_controller_params *params);

/* Checks the parameters and prepares what follows from them; the rest of the state stays. */
all_wheel_drive_controller_status all_wheel_drive_controller_update(all_wheel_drive_controller_state *state, const all_wheel_drive_controller_params *params);

/* One step. */
all_wheel_drive_controller_status all_wheel_drive_controller_step(all_wheel_drive_controller_state *state, const all_wheel_drive_controller_params *params,
    const all_wheel_drive_controller_inputs *inputs, all_wheel_drive_controller_outputs *outputs);

#endif
