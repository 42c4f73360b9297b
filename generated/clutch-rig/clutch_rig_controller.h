/*
 * clutch_rig_controller.h: controller of the bed clutch_rig
 *
 * Emitted by ptgen 0.1.0 from clutch-rig.toml (SHA-256 8a8f57b91ebde405), template block.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef CLUTCH_RIG_CONTROLLER_H
#define CLUTCH_RIG_CONTROLLER_H

#include "clutch_rig_support.h"

/* Parameters, in SI units; call clutch_rig_controller_update after a change. */
typedef struct {
    clutch_rig_real sample_time; /* step of the controller (s) */
    clutch_rig_real fault_ramp; /* time from a fault to zero torque (s) */
    clutch_rig_real M1_speed_ref_plausible; /* largest plausible M1_speed_ref (rad/s) */
    clutch_rig_real M2_speed_ref_plausible; /* largest plausible M2_speed_ref (rad/s) */
    clutch_rig_real M1_speed_plausible; /* largest plausible M1_speed (rad/s) */
    clutch_rig_real flange1_torque_plausible; /* largest plausible flange1_torque (N m) */
    clutch_rig_real flange2_torque_plausible; /* largest plausible flange2_torque (N m) */
    clutch_rig_real M2_speed_plausible; /* largest plausible M2_speed (rad/s) */
    clutch_rig_real load_compensation; /* switch of the load torque compensation, 0 to 1 */
    clutch_rig_real acceleration_torque; /* switch of the acceleration torque, 0 to 1 */
    clutch_rig_real switch_time; /* time in which a switch or a damping follows its parameter (s) */
    clutch_rig_real M1_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    clutch_rig_real M1_speed_max; /* largest admissible speed (rad/s) */
    clutch_rig_real M1_speed_taper; /* speed above M1_speed_max over which accelerating torque is taken back (rad/s) */
    clutch_rig_real M1_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    clutch_rig_real M2_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    clutch_rig_real M2_speed_max; /* largest admissible speed (rad/s) */
    clutch_rig_real M2_speed_taper; /* speed above M2_speed_max over which accelerating torque is taken back (rad/s) */
    clutch_rig_real M2_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    clutch_rig_real M1_speed_ref_rate; /* largest rate of M1_speed_ref (rad/s^2) */
    clutch_rig_real M2_speed_ref_rate; /* largest rate of M2_speed_ref (rad/s^2) */
    clutch_rig_real M1_speed_gain; /* proportional gain of the speed of M1 (N m s/rad) */
    clutch_rig_real M1_speed_integral_gain; /* integral gain of the speed of M1 (N m/rad) */
    clutch_rig_real M2_speed_gain; /* proportional gain of the speed of M2 (N m s/rad) */
    clutch_rig_real M2_speed_integral_gain; /* integral gain of the speed of M2 (N m/rad) */
} clutch_rig_controller_params;

/* Inputs of a step. */
typedef struct {
    clutch_rig_real M1_speed_ref; /* reference (rad/s) */
    clutch_rig_real M2_speed_ref; /* reference (rad/s) */
    clutch_rig_real M1_speed; /* measured (rad/s) */
    clutch_rig_real flange1_torque; /* measured (N m) */
    clutch_rig_real flange2_torque; /* measured (N m) */
    clutch_rig_real M2_speed; /* measured (rad/s) */
} clutch_rig_controller_inputs;

/* Outputs of a step; torques are positive when they drive the right-hand neighbour. */
typedef struct {
    clutch_rig_real M1_torque_ref; /* air-gap torque reference of M1 (N m) */
    clutch_rig_real M2_torque_ref; /* air-gap torque reference of M2 (N m) */
} clutch_rig_controller_outputs;

/* States first, then what follows from the parameters. Matrices are stored by columns. */
typedef struct {
    clutch_rig_real fault; /* 0, or the number of the input that failed */
    clutch_rig_real M1_speed_ref_held; /* last sound value of M1_speed_ref (rad/s) */
    clutch_rig_real M2_speed_ref_held; /* last sound value of M2_speed_ref (rad/s) */
    clutch_rig_real M1_speed_held; /* last sound value of M1_speed (rad/s) */
    clutch_rig_real flange1_torque_held; /* last sound value of flange1_torque (N m) */
    clutch_rig_real flange2_torque_held; /* last sound value of flange2_torque (N m) */
    clutch_rig_real M2_speed_held; /* last sound value of M2_speed (rad/s) */
    clutch_rig_real load_compensation_now; /* load_compensation on its way to the parameter */
    clutch_rig_real load_compensation_target; /* load_compensation as the last step found it */
    clutch_rig_real load_compensation_step; /* how far load_compensation moves in a step */
    clutch_rig_real running; /* 1 once a step was done without a fault */
    clutch_rig_real M1_speed_ref_limited; /* M1_speed_ref behind its rate limiter (rad/s) */
    clutch_rig_real M2_speed_ref_limited; /* M2_speed_ref behind its rate limiter (rad/s) */
    clutch_rig_real M1_speed_integral; /* integrator of the speed control of M1 (N m) */
    clutch_rig_real M2_speed_integral; /* integrator of the speed control of M2 (N m) */
    clutch_rig_real M1_last; /* last torque of M1 before a fault (N m) */
    clutch_rig_real M2_last; /* last torque of M2 before a fault (N m) */
    clutch_rig_real authority; /* 1, going to 0 along the ramp after a fault */
    clutch_rig_real switch_share; /* share of a change per step */
    clutch_rig_real M1_taper_slope; /* share of the torque of M1 per excess of speed (s/rad) */
    clutch_rig_real M1_taper_end; /* share at standstill if it were not limited */
    clutch_rig_real M2_taper_slope; /* share of the torque of M2 per excess of speed (s/rad) */
    clutch_rig_real M2_taper_end; /* share at standstill if it were not limited */
    clutch_rig_real M1_speed_ref_step; /* largest change of M1_speed_ref in a step (rad/s) */
    clutch_rig_real M2_speed_ref_step; /* largest change of M2_speed_ref in a step (rad/s) */
    clutch_rig_real M1_speed_growth; /* growth of the integrator per error (N m s/rad) */
    clutch_rig_real M1_speed_conditioning; /* growth per torque cut off */
    clutch_rig_real M2_speed_growth; /* growth of the integrator per error (N m s/rad) */
    clutch_rig_real M2_speed_conditioning; /* growth per torque cut off */
} clutch_rig_controller_state;

typedef enum {
    clutch_rig_controller_ok = 0,
    clutch_rig_controller_fault_M1_speed_ref = 1, /* M1_speed_ref was not finite or not plausible */
    clutch_rig_controller_fault_M2_speed_ref = 2, /* M2_speed_ref was not finite or not plausible */
    clutch_rig_controller_fault_M1_speed = 3, /* M1_speed was not finite or not plausible */
    clutch_rig_controller_fault_flange1_torque = 4, /* flange1_torque was not finite or not plausible */
    clutch_rig_controller_fault_flange2_torque = 5, /* flange2_torque was not finite or not plausible */
    clutch_rig_controller_fault_M2_speed = 6, /* M2_speed was not finite or not plausible */
    clutch_rig_controller_fault_M1_torque_ref = 7, /* M1_torque_ref was not finite or not plausible */
    clutch_rig_controller_fault_M2_torque_ref = 8, /* M2_torque_ref was not finite or not plausible */
    clutch_rig_controller_bad_sample_time = 2000, /* outside its range */
    clutch_rig_controller_bad_fault_ramp = 2001, /* outside its range */
    clutch_rig_controller_bad_M1_speed_ref_plausible = 2002, /* outside its range */
    clutch_rig_controller_bad_M2_speed_ref_plausible = 2003, /* outside its range */
    clutch_rig_controller_bad_M1_speed_plausible = 2004, /* outside its range */
    clutch_rig_controller_bad_flange1_torque_plausible = 2005, /* outside its range */
    clutch_rig_controller_bad_flange2_torque_plausible = 2006, /* outside its range */
    clutch_rig_controller_bad_M2_speed_plausible = 2007, /* outside its range */
    clutch_rig_controller_bad_load_compensation = 2008, /* outside its range */
    clutch_rig_controller_bad_acceleration_torque = 2009, /* outside its range */
    clutch_rig_controller_bad_switch_time = 2010, /* outside its range */
    clutch_rig_controller_bad_M1_speed_rated = 2011, /* outside its range */
    clutch_rig_controller_bad_M1_speed_max = 2012, /* outside its range */
    clutch_rig_controller_bad_M1_speed_taper = 2013, /* outside its range */
    clutch_rig_controller_bad_M1_torque_max = 2014, /* outside its range */
    clutch_rig_controller_bad_M2_speed_rated = 2015, /* outside its range */
    clutch_rig_controller_bad_M2_speed_max = 2016, /* outside its range */
    clutch_rig_controller_bad_M2_speed_taper = 2017, /* outside its range */
    clutch_rig_controller_bad_M2_torque_max = 2018, /* outside its range */
    clutch_rig_controller_bad_M1_speed_ref_rate = 2019, /* outside its range */
    clutch_rig_controller_bad_M2_speed_ref_rate = 2020, /* outside its range */
    clutch_rig_controller_bad_M1_speed_gain = 2021, /* outside its range */
    clutch_rig_controller_bad_M1_speed_integral_gain = 2022, /* outside its range */
    clutch_rig_controller_bad_M2_speed_gain = 2023, /* outside its range */
    clutch_rig_controller_bad_M2_speed_integral_gain = 2024, /* outside its range */
} clutch_rig_controller_status;

extern const clutch_rig_controller_params clutch_rig_controller_defaults;
extern const clutch_rig_controller_params clutch_rig_controller_conventional;

/* Name of a status, for logs. */
const char *clutch_rig_controller_status_text(clutch_rig_controller_status status);

/* Sets the initial state and prepares everything that follows from the parameters. */
clutch_rig_controller_status clutch_rig_controller_init(clutch_rig_controller_state *state, const clutch_rig_controller_params *params);

/* Checks the parameters and prepares what follows from them; the rest of the state stays. */
clutch_rig_controller_status clutch_rig_controller_update(clutch_rig_controller_state *state, const clutch_rig_controller_params *params);

/* One step. */
clutch_rig_controller_status clutch_rig_controller_step(clutch_rig_controller_state *state, const clutch_rig_controller_params *params,
    const clutch_rig_controller_inputs *inputs, clutch_rig_controller_outputs *outputs);

#endif
