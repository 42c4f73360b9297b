/*
 * differential_governed_controller.h: controller of the bed differential_governed
 *
 * Emitted by ptgen 0.1.0 from differential-governed.toml (SHA-256 acf552a043b195e0), template block.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef DIFFERENTIAL_GOVERNED_CONTROLLER_H
#define DIFFERENTIAL_GOVERNED_CONTROLLER_H

#include "differential_governed_support.h"

/* Parameters, in SI units; call differential_governed_controller_update after a change. */
typedef struct {
    differential_governed_real sample_time; /* step of the controller (s) */
    differential_governed_real fault_ramp; /* time from a fault to zero torque (s) */
    differential_governed_real hold_time; /* bad samples are bridged for that long, and no longer (s) */
    differential_governed_real diff_input_torque_ref_plausible; /* largest plausible diff_input_torque_ref (N m) */
    differential_governed_real M2_speed_ref_plausible; /* largest plausible M2_speed_ref (rad/s) */
    differential_governed_real M3_speed_ref_plausible; /* largest plausible M3_speed_ref (rad/s) */
    differential_governed_real M1_speed_plausible; /* largest plausible M1_speed (rad/s) */
    differential_governed_real flange1_torque_plausible; /* largest plausible flange1_torque (N m) */
    differential_governed_real flange2_torque_plausible; /* largest plausible flange2_torque (N m) */
    differential_governed_real M2_speed_plausible; /* largest plausible M2_speed (rad/s) */
    differential_governed_real flange3_torque_plausible; /* largest plausible flange3_torque (N m) */
    differential_governed_real M3_speed_plausible; /* largest plausible M3_speed (rad/s) */
    differential_governed_real M1_overspeed; /* speed of M1 that is a fault (rad/s) */
    differential_governed_real M2_overspeed; /* speed of M2 that is a fault (rad/s) */
    differential_governed_real M3_overspeed; /* speed of M3 that is a fault (rad/s) */
    differential_governed_real load_compensation; /* switch of the load torque compensation, 0 to 1 */
    differential_governed_real acceleration_torque; /* switch of the acceleration torque, 0 to 1 */
    differential_governed_real switch_time; /* time in which a switch or a damping follows its parameter (s) */
    differential_governed_real M1_damping; /* active damping by M1 (5.81) (N m s/rad) */
    differential_governed_real M1_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    differential_governed_real M1_speed_max; /* largest admissible speed (rad/s) */
    differential_governed_real M1_speed_taper; /* speed above M1_speed_max over which accelerating torque is taken back (rad/s) */
    differential_governed_real M1_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    differential_governed_real M2_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    differential_governed_real M2_speed_max; /* largest admissible speed (rad/s) */
    differential_governed_real M2_speed_taper; /* speed above M2_speed_max over which accelerating torque is taken back (rad/s) */
    differential_governed_real M2_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    differential_governed_real M3_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    differential_governed_real M3_speed_max; /* largest admissible speed (rad/s) */
    differential_governed_real M3_speed_taper; /* speed above M3_speed_max over which accelerating torque is taken back (rad/s) */
    differential_governed_real M3_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    differential_governed_real disagreement_leak; /* rate at which the integrated speeds forget (1/s) */
    differential_governed_real M1_inertia; /* moment of inertia of the rotor (kg m^2) */
    differential_governed_real M1_disagreement_limit; /* largest difference between measured and integrated speed of M1 (rad/s) */
    differential_governed_real M1_frozen_limit; /* the same while a signal of M1 stays the same to the last bit (rad/s) */
    differential_governed_real frozen_time; /* for how long a frozen signal stays the same (s) */
    differential_governed_real M2_inertia; /* moment of inertia of the rotor (kg m^2) */
    differential_governed_real M2_disagreement_limit; /* largest difference between measured and integrated speed of M2 (rad/s) */
    differential_governed_real M2_frozen_limit; /* the same while a signal of M2 stays the same to the last bit (rad/s) */
    differential_governed_real M3_inertia; /* moment of inertia of the rotor (kg m^2) */
    differential_governed_real M3_disagreement_limit; /* largest difference between measured and integrated speed of M3 (rad/s) */
    differential_governed_real M3_frozen_limit; /* the same while a signal of M3 stays the same to the last bit (rad/s) */
    differential_governed_real oscillation_frequency; /* slowest oscillation of a torque that is watched (Hz) */
    differential_governed_real flange1_torque_oscillation_limit; /* amplitude with which flange1_torque may oscillate (N m) */
    differential_governed_real flange2_torque_oscillation_limit; /* amplitude with which flange2_torque may oscillate (N m) */
    differential_governed_real flange3_torque_oscillation_limit; /* amplitude with which flange3_torque may oscillate (N m) */
    differential_governed_real M1_torque_ref_oscillation_limit; /* amplitude with which M1_torque_ref may oscillate (N m) */
    differential_governed_real M2_torque_ref_oscillation_limit; /* amplitude with which M2_torque_ref may oscillate (N m) */
    differential_governed_real M3_torque_ref_oscillation_limit; /* amplitude with which M3_torque_ref may oscillate (N m) */
    differential_governed_real M2_speed_ref_rate; /* largest rate of M2_speed_ref (rad/s^2) */
    differential_governed_real M3_speed_ref_rate; /* largest rate of M3_speed_ref (rad/s^2) */
    differential_governed_real diff_input_torque_ref_rate; /* largest rate of diff_input_torque_ref (N m/s) */
    differential_governed_real M2_speed_gain; /* proportional gain of the speed of M2 (N m s/rad) */
    differential_governed_real M2_speed_integral_gain; /* integral gain of the speed of M2 (N m/rad) */
    differential_governed_real M3_speed_gain; /* proportional gain of the speed of M3 (N m s/rad) */
    differential_governed_real M3_speed_integral_gain; /* integral gain of the speed of M3 (N m/rad) */
    differential_governed_real M1_sensor_inertia_M2; /* torque of M1 that its sensors miss, per acceleration of M2 (kg m^2) */
    differential_governed_real M1_sensor_inertia_M3; /* torque of M1 that its sensors miss, per acceleration of M3 (kg m^2) */
    differential_governed_real M1_inertia_estimate; /* inertia that M1 accelerates (5.78) (kg m^2) */
    differential_governed_real M1_feedforward; /* share of the torque reference fed forward to M1 */
    differential_governed_real M1_torque_gain; /* proportional gain of the torque control of M1, above -1 (5.115a) */
    differential_governed_real M1_model_stiffness; /* stiffness in the torque model of M1 (N m/rad) */
    differential_governed_real M1_model_damping; /* damping in the torque model of M1 (N m s/rad) */
    differential_governed_real M1_torque_model; /* switch of the torque model of M1, 0 to 1 */
    differential_governed_real diff_ratio; /* ratio i_d of input speed to mean output speed */
    differential_governed_real M1_torque_integral_gain; /* integral gain of the torque control of M1 (1/s) */
    differential_governed_real M1_damping_reserve; /* share of the torque of M1 kept for damping */
    differential_governed_real M1_torque_integral_limit; /* limit of the torque integrator of M1 (N m) */
    differential_governed_real governor; /* reference governor: 0 none, 1 sequential, 2 sequential modified, 3 optimal */
    differential_governed_real governor_reserve; /* share of every machine's torque that the governor leaves free, eps_1 (7.30) */
    differential_governed_real governor_stationary_reserve; /* further share that it leaves free of torques at rest and of speeds, eps_inf (7.32) */
    differential_governed_real governor_tie; /* speed references that differ by less stay together (rad/s) */
    differential_governed_real torque_rate_min; /* rate that the sequential governor leaves a torque (N m/s) */
    differential_governed_real torque_reserve; /* torque of a torque-controlled machine that it leaves free (N m) */
    differential_governed_real governor_torque_weight; /* weight of a torque reference, alpha_T (7.36) */
    differential_governed_real governor_speed_weight; /* weight of a speed reference, alpha_omega (7.36) */
    differential_governed_real M1_at_rest_diff_input_torque_ref; /* torque of M1 at rest per diff_input_torque_ref */
    differential_governed_real M2_at_rest_diff_input_torque_ref; /* torque of M2 at rest per diff_input_torque_ref */
    differential_governed_real M3_at_rest_diff_input_torque_ref; /* torque of M3 at rest per diff_input_torque_ref */
    differential_governed_real M1_speed_at_rest_M2_speed_ref; /* speed of M1 at rest per M2_speed_ref */
    differential_governed_real M1_speed_at_rest_M3_speed_ref; /* speed of M1 at rest per M3_speed_ref */
} differential_governed_controller_params;

/* Inputs of a step. */
typedef struct {
    differential_governed_real diff_input_torque_ref; /* reference (N m) */
    differential_governed_real M2_speed_ref; /* reference (rad/s) */
    differential_governed_real M3_speed_ref; /* reference (rad/s) */
    differential_governed_real M1_speed; /* measured (rad/s) */
    differential_governed_real flange1_torque; /* measured (N m) */
    differential_governed_real flange2_torque; /* measured (N m) */
    differential_governed_real M2_speed; /* measured (rad/s) */
    differential_governed_real flange3_torque; /* measured (N m) */
    differential_governed_real M3_speed; /* measured (rad/s) */
    differential_governed_real reset; /* 0 or 1; its rising edge takes back a fault whose cause is gone */
} differential_governed_controller_inputs;

/* Outputs of a step; torques are positive when they drive the right-hand neighbour. */
typedef struct {
    differential_governed_real M1_torque_ref; /* air-gap torque reference of M1 (N m) */
    differential_governed_real M2_torque_ref; /* air-gap torque reference of M2 (N m) */
    differential_governed_real M3_torque_ref; /* air-gap torque reference of M3 (N m) */
} differential_governed_controller_outputs;

/* States first, then what follows from the parameters. Matrices are stored by columns. */
typedef struct {
    differential_governed_real fault; /* 0, or the status of the first fault */
    differential_governed_real authority; /* share of the torques that is released; goes along the ramp */
    differential_governed_real running; /* 1 if the last step ran without a fault, 0 before and after */
    differential_governed_real refused; /* 1 while the parameters of the last update are refused */
    differential_governed_real diff_input_torque_ref_held; /* last sound value of diff_input_torque_ref (N m) */
    differential_governed_real diff_input_torque_ref_bad_time; /* for how long diff_input_torque_ref was bad (s) */
    differential_governed_real M2_speed_ref_held; /* last sound value of M2_speed_ref (rad/s) */
    differential_governed_real M2_speed_ref_bad_time; /* for how long M2_speed_ref was bad (s) */
    differential_governed_real M3_speed_ref_held; /* last sound value of M3_speed_ref (rad/s) */
    differential_governed_real M3_speed_ref_bad_time; /* for how long M3_speed_ref was bad (s) */
    differential_governed_real M1_speed_held; /* last sound value of M1_speed (rad/s) */
    differential_governed_real M1_speed_bad_time; /* for how long M1_speed was bad (s) */
    differential_governed_real flange1_torque_held; /* last sound value of flange1_torque (N m) */
    differential_governed_real flange1_torque_bad_time; /* for how long flange1_torque was bad (s) */
    differential_governed_real flange2_torque_held; /* last sound value of flange2_torque (N m) */
    differential_governed_real flange2_torque_bad_time; /* for how long flange2_torque was bad (s) */
    differential_governed_real M2_speed_held; /* last sound value of M2_speed (rad/s) */
    differential_governed_real M2_speed_bad_time; /* for how long M2_speed was bad (s) */
    differential_governed_real flange3_torque_held; /* last sound value of flange3_torque (N m) */
    differential_governed_real flange3_torque_bad_time; /* for how long flange3_torque was bad (s) */
    differential_governed_real M3_speed_held; /* last sound value of M3_speed (rad/s) */
    differential_governed_real M3_speed_bad_time; /* for how long M3_speed was bad (s) */
    differential_governed_real M1_overspeed_time; /* for how long M1 was too fast (s) */
    differential_governed_real M2_overspeed_time; /* for how long M2 was too fast (s) */
    differential_governed_real M3_overspeed_time; /* for how long M3 was too fast (s) */
    differential_governed_real reset_before; /* reset in the step before */
    differential_governed_real reset_request; /* 1 while a reset waits for zero torque */
    differential_governed_real load_compensation_now; /* load_compensation on its way to the parameter */
    differential_governed_real load_compensation_target; /* load_compensation as the last step found it */
    differential_governed_real load_compensation_step; /* how far load_compensation moves in a step */
    differential_governed_real acceleration_torque_now; /* acceleration_torque on its way to the parameter */
    differential_governed_real acceleration_torque_target; /* acceleration_torque as the last step found it */
    differential_governed_real acceleration_torque_step; /* how far acceleration_torque moves in a step */
    differential_governed_real M1_damping_now; /* M1_damping on its way to the parameter (N m s/rad) */
    differential_governed_real M1_damping_target; /* M1_damping as the last step found it (N m s/rad) */
    differential_governed_real M1_damping_step; /* how far M1_damping moves in a step (N m s/rad) */
    differential_governed_real M1_integrated; /* speed of M1 from the torques (rad/s) */
    differential_governed_real M1_disagreement_time; /* for how long the speed of M1 disagreed (s) */
    differential_governed_real M1_speed_before; /* M1_speed in the step before (rad/s) */
    differential_governed_real M1_speed_still_time; /* for how long M1_speed has been the same (s) */
    differential_governed_real flange1_torque_before; /* flange1_torque in the step before (N m) */
    differential_governed_real flange1_torque_still_time; /* for how long flange1_torque has been the same (s) */
    differential_governed_real flange1_torque_command; /* command to M1 when flange1_torque last changed (N m) */
    differential_governed_real M2_integrated; /* speed of M2 from the torques (rad/s) */
    differential_governed_real M2_disagreement_time; /* for how long the speed of M2 disagreed (s) */
    differential_governed_real M2_speed_before; /* M2_speed in the step before (rad/s) */
    differential_governed_real M2_speed_still_time; /* for how long M2_speed has been the same (s) */
    differential_governed_real flange2_torque_before; /* flange2_torque in the step before (N m) */
    differential_governed_real flange2_torque_still_time; /* for how long flange2_torque has been the same (s) */
    differential_governed_real flange2_torque_command; /* command to M2 when flange2_torque last changed (N m) */
    differential_governed_real M3_integrated; /* speed of M3 from the torques (rad/s) */
    differential_governed_real M3_disagreement_time; /* for how long the speed of M3 disagreed (s) */
    differential_governed_real M3_speed_before; /* M3_speed in the step before (rad/s) */
    differential_governed_real M3_speed_still_time; /* for how long M3_speed has been the same (s) */
    differential_governed_real flange3_torque_before; /* flange3_torque in the step before (N m) */
    differential_governed_real flange3_torque_still_time; /* for how long flange3_torque has been the same (s) */
    differential_governed_real flange3_torque_command; /* command to M3 when flange3_torque last changed (N m) */
    differential_governed_real flange1_torque_mean; /* flange1_torque without its oscillation (N m) */
    differential_governed_real flange1_torque_side; /* side on which flange1_torque last was beyond the limit */
    differential_governed_real flange1_torque_swings; /* half swings of flange1_torque, forgotten in time */
    differential_governed_real flange2_torque_mean; /* flange2_torque without its oscillation (N m) */
    differential_governed_real flange2_torque_side; /* side on which flange2_torque last was beyond the limit */
    differential_governed_real flange2_torque_swings; /* half swings of flange2_torque, forgotten in time */
    differential_governed_real flange3_torque_mean; /* flange3_torque without its oscillation (N m) */
    differential_governed_real flange3_torque_side; /* side on which flange3_torque last was beyond the limit */
    differential_governed_real flange3_torque_swings; /* half swings of flange3_torque, forgotten in time */
    differential_governed_real M1_torque_ref_mean; /* M1_torque_ref without its oscillation (N m) */
    differential_governed_real M1_torque_ref_side; /* side on which M1_torque_ref last was beyond the limit */
    differential_governed_real M1_torque_ref_swings; /* half swings of M1_torque_ref, forgotten in time */
    differential_governed_real M2_torque_ref_mean; /* M2_torque_ref without its oscillation (N m) */
    differential_governed_real M2_torque_ref_side; /* side on which M2_torque_ref last was beyond the limit */
    differential_governed_real M2_torque_ref_swings; /* half swings of M2_torque_ref, forgotten in time */
    differential_governed_real M3_torque_ref_mean; /* M3_torque_ref without its oscillation (N m) */
    differential_governed_real M3_torque_ref_side; /* side on which M3_torque_ref last was beyond the limit */
    differential_governed_real M3_torque_ref_swings; /* half swings of M3_torque_ref, forgotten in time */
    differential_governed_real M2_speed_ref_limited; /* M2_speed_ref behind its rate limiter (rad/s) */
    differential_governed_real M3_speed_ref_limited; /* M3_speed_ref behind its rate limiter (rad/s) */
    differential_governed_real diff_input_torque_ref_limited; /* diff_input_torque_ref behind its rate limiter (N m) */
    differential_governed_real M2_speed_integral; /* integrator of the speed control of M2 (N m) */
    differential_governed_real M3_speed_integral; /* integrator of the speed control of M3 (N m) */
    differential_governed_real M1_model_torque; /* torque that the feedforward to M1 should give (N m) */
    differential_governed_real M1_model_rate; /* rate of the torque model of M1 (N m/s) */
    differential_governed_real M1_torque_integral; /* integrator of the torque control of M1 (N m) */
    differential_governed_real diff_input_torque_ref_shaped; /* diff_input_torque_ref behind the reference governor (N m) */
    differential_governed_real M2_speed_ref_shaped; /* M2_speed_ref behind the reference governor (rad/s) */
    differential_governed_real M3_speed_ref_shaped; /* M3_speed_ref behind the reference governor (rad/s) */
    differential_governed_real governor_iterations; /* steps of the optimal governor's solver */
    differential_governed_real governor_slack_M1; /* by how much the command of M1 is beyond what the governor keeps it in (N m) */
    differential_governed_real governor_demand_M1; /* what the control law asks of M1, before any limit (N m) */
    differential_governed_real governor_slack_M2; /* by how much the command of M2 is beyond what the governor keeps it in (N m) */
    differential_governed_real governor_demand_M2; /* what the control law asks of M2, before any limit (N m) */
    differential_governed_real governor_slack_M3; /* by how much the command of M3 is beyond what the governor keeps it in (N m) */
    differential_governed_real governor_demand_M3; /* what the control law asks of M3, before any limit (N m) */
    differential_governed_real governor_status; /* 0 nothing is held back, 1 a reference is, 2 a limit cannot be kept, 3 no solution in the bound of iterations, 4 parameters are not those of the design; with 3 and 4 the sequential governor holds */
    differential_governed_real M1_last; /* last torque of M1 before a fault (N m) */
    differential_governed_real M2_last; /* last torque of M2 before a fault (N m) */
    differential_governed_real M3_last; /* last torque of M3 before a fault (N m) */
    differential_governed_real M1_calm; /* smoothed torque of M1, that of before a fault (N m) */
    differential_governed_real M2_calm; /* smoothed torque of M2, that of before a fault (N m) */
    differential_governed_real M3_calm; /* smoothed torque of M3, that of before a fault (N m) */
    differential_governed_real bridged_time; /* for how long bad samples are bridged, with room for rounding (s) */
    differential_governed_real switch_share; /* share of a change per step */
    differential_governed_real M1_taper_slope; /* share of the torque of M1 per excess of speed (s/rad) */
    differential_governed_real M1_taper_end; /* share at standstill if it were not limited */
    differential_governed_real M1_power; /* power of M1 above its rated speed (W) */
    differential_governed_real M2_taper_slope; /* share of the torque of M2 per excess of speed (s/rad) */
    differential_governed_real M2_taper_end; /* share at standstill if it were not limited */
    differential_governed_real M2_power; /* power of M2 above its rated speed (W) */
    differential_governed_real M3_taper_slope; /* share of the torque of M3 per excess of speed (s/rad) */
    differential_governed_real M3_taper_end; /* share at standstill if it were not limited */
    differential_governed_real M3_power; /* power of M3 above its rated speed (W) */
    differential_governed_real disagreement_share; /* share of the difference that is forgotten per step */
    differential_governed_real M1_per_step; /* change of speed of M1 per torque in a step (rad/s/(N m)) */
    differential_governed_real M1_moved_torque; /* change of the command to M1 that a torque must follow (N m) */
    differential_governed_real M2_per_step; /* change of speed of M2 per torque in a step (rad/s/(N m)) */
    differential_governed_real M2_moved_torque; /* change of the command to M2 that a torque must follow (N m) */
    differential_governed_real M3_per_step; /* change of speed of M3 per torque in a step (rad/s/(N m)) */
    differential_governed_real M3_moved_torque; /* change of the command to M3 that a torque must follow (N m) */
    differential_governed_real forgotten_swings; /* half swings that are forgotten per step */
    differential_governed_real mean_share; /* share of a step in the mean of a torque */
    differential_governed_real M2_speed_ref_step; /* largest change of M2_speed_ref in a step (rad/s) */
    differential_governed_real M3_speed_ref_step; /* largest change of M3_speed_ref in a step (rad/s) */
    differential_governed_real diff_input_torque_ref_step; /* largest change of diff_input_torque_ref in a step (N m) */
    differential_governed_real M2_speed_growth; /* growth of the integrator per error (N m s/rad) */
    differential_governed_real M2_speed_conditioning; /* growth per torque cut off */
    differential_governed_real M3_speed_growth; /* growth of the integrator per error (N m s/rad) */
    differential_governed_real M3_speed_conditioning; /* growth per torque cut off */
    differential_governed_real M1_unread_M2; /* the same per net torque */
    differential_governed_real M1_unread_M3; /* the same per net torque */
    differential_governed_real M1_model_pull; /* rate of the torque model per missing torque (1/s) */
    differential_governed_real M1_model_drag; /* decay of that rate in a step */
    differential_governed_real M1_with_M2; /* coefficient of the virtual input of M2 */
    differential_governed_real M1_with_M3; /* coefficient of the virtual input of M3 */
    differential_governed_real M1_twist_M1_M2_speed; /* coefficient of M2_speed */
    differential_governed_real M1_twist_M1_M3_speed; /* coefficient of M3_speed */
    differential_governed_real M1_torque_growth; /* growth of the integrator per error */
    differential_governed_real M1_governed_speed; /* largest speed to which the governor lets references drive M1 (rad/s) */
    differential_governed_real M2_governed_speed; /* largest speed to which the governor lets references drive M2 (rad/s) */
    differential_governed_real M3_governed_speed; /* largest speed to which the governor lets references drive M3 (rad/s) */
    differential_governed_real M1_follows_M1; /* change of the command of M1 with the reference of M1 */
    differential_governed_real torque_step_min; /* step of a torque reference that others leave room for (N m) */
    differential_governed_real governor_designed; /* 1 while gains and all else that the prediction rests on are those of the design */
    differential_governed_real governor_finite; /* what counts as finite */
    differential_governed_real M1_largest; /* torque of M1 that is a fault (N m) */
    differential_governed_real M2_largest; /* torque of M2 that is a fault (N m) */
    differential_governed_real M3_largest; /* torque of M3 that is a fault (N m) */
    differential_governed_real ramp_step; /* change of the released share per step */
    differential_governed_real calm_share; /* share of a new torque in the smoothed ones */
} differential_governed_controller_state;

typedef enum {
    differential_governed_controller_ok = 0,
    differential_governed_controller_fault_diff_input_torque_ref = 1, /* diff_input_torque_ref: not finite or not plausible */
    differential_governed_controller_fault_M2_speed_ref = 2, /* M2_speed_ref: not finite or not plausible */
    differential_governed_controller_fault_M3_speed_ref = 3, /* M3_speed_ref: not finite or not plausible */
    differential_governed_controller_fault_M1_speed = 4, /* M1_speed: not finite or not plausible */
    differential_governed_controller_fault_flange1_torque = 5, /* flange1_torque: not finite or not plausible */
    differential_governed_controller_fault_flange2_torque = 6, /* flange2_torque: not finite or not plausible */
    differential_governed_controller_fault_M2_speed = 7, /* M2_speed: not finite or not plausible */
    differential_governed_controller_fault_flange3_torque = 8, /* flange3_torque: not finite or not plausible */
    differential_governed_controller_fault_M3_speed = 9, /* M3_speed: not finite or not plausible */
    differential_governed_controller_fault_M1_speed_overspeed = 4004, /* M1_speed: overspeed */
    differential_governed_controller_fault_M2_speed_overspeed = 4007, /* M2_speed: overspeed */
    differential_governed_controller_fault_M3_speed_overspeed = 4009, /* M3_speed: overspeed */
    differential_governed_controller_fault_M1_speed_frozen = 3004, /* M1_speed: frozen while the torques accelerate the machine */
    differential_governed_controller_fault_M1_speed_disagreement = 5004, /* M1_speed: disagrees with the integrated torque */
    differential_governed_controller_fault_flange1_torque_frozen = 3005, /* flange1_torque: frozen while the torque of the machine changes */
    differential_governed_controller_fault_M2_speed_frozen = 3007, /* M2_speed: frozen while the torques accelerate the machine */
    differential_governed_controller_fault_M2_speed_disagreement = 5007, /* M2_speed: disagrees with the integrated torque */
    differential_governed_controller_fault_flange2_torque_frozen = 3006, /* flange2_torque: frozen while the torque of the machine changes */
    differential_governed_controller_fault_M3_speed_frozen = 3009, /* M3_speed: frozen while the torques accelerate the machine */
    differential_governed_controller_fault_M3_speed_disagreement = 5009, /* M3_speed: disagrees with the integrated torque */
    differential_governed_controller_fault_flange3_torque_frozen = 3008, /* flange3_torque: frozen while the torque of the machine changes */
    differential_governed_controller_fault_flange1_torque_oscillation = 6005, /* flange1_torque: oscillates beyond its limit */
    differential_governed_controller_fault_flange2_torque_oscillation = 6006, /* flange2_torque: oscillates beyond its limit */
    differential_governed_controller_fault_flange3_torque_oscillation = 6008, /* flange3_torque: oscillates beyond its limit */
    differential_governed_controller_fault_M1_torque_ref_oscillation = 8001, /* M1_torque_ref: the command oscillates */
    differential_governed_controller_fault_M2_torque_ref_oscillation = 8002, /* M2_torque_ref: the command oscillates */
    differential_governed_controller_fault_M3_torque_ref_oscillation = 8003, /* M3_torque_ref: the command oscillates */
    differential_governed_controller_fault_M1_torque_ref = 7001, /* M1_torque_ref: the command is not finite, or beyond the torque of the machine */
    differential_governed_controller_fault_M2_torque_ref = 7002, /* M2_torque_ref: the command is not finite, or beyond the torque of the machine */
    differential_governed_controller_fault_M3_torque_ref = 7003, /* M3_torque_ref: the command is not finite, or beyond the torque of the machine */
    differential_governed_controller_bad_sample_time = 2000, /* outside its range */
    differential_governed_controller_bad_fault_ramp = 2001, /* outside its range */
    differential_governed_controller_bad_hold_time = 2002, /* outside its range */
    differential_governed_controller_bad_diff_input_torque_ref_plausible = 2003, /* outside its range */
    differential_governed_controller_bad_M2_speed_ref_plausible = 2004, /* outside its range */
    differential_governed_controller_bad_M3_speed_ref_plausible = 2005, /* outside its range */
    differential_governed_controller_bad_M1_speed_plausible = 2006, /* outside its range */
    differential_governed_controller_bad_flange1_torque_plausible = 2007, /* outside its range */
    differential_governed_controller_bad_flange2_torque_plausible = 2008, /* outside its range */
    differential_governed_controller_bad_M2_speed_plausible = 2009, /* outside its range */
    differential_governed_controller_bad_flange3_torque_plausible = 2010, /* outside its range */
    differential_governed_controller_bad_M3_speed_plausible = 2011, /* outside its range */
    differential_governed_controller_bad_M1_overspeed = 2012, /* outside its range */
    differential_governed_controller_bad_M2_overspeed = 2013, /* outside its range */
    differential_governed_controller_bad_M3_overspeed = 2014, /* outside its range */
    differential_governed_controller_bad_load_compensation = 2015, /* outside its range */
    differential_governed_controller_bad_acceleration_torque = 2016, /* outside its range */
    differential_governed_controller_bad_switch_time = 2017, /* outside its range */
    differential_governed_controller_bad_M1_damping = 2018, /* outside its range */
    differential_governed_controller_bad_M1_speed_rated = 2019, /* outside its range */
    differential_governed_controller_bad_M1_speed_max = 2020, /* outside its range */
    differential_governed_controller_bad_M1_speed_taper = 2021, /* outside its range */
    differential_governed_controller_bad_M1_torque_max = 2022, /* outside its range */
    differential_governed_controller_bad_M2_speed_rated = 2023, /* outside its range */
    differential_governed_controller_bad_M2_speed_max = 2024, /* outside its range */
    differential_governed_controller_bad_M2_speed_taper = 2025, /* outside its range */
    differential_governed_controller_bad_M2_torque_max = 2026, /* outside its range */
    differential_governed_controller_bad_M3_speed_rated = 2027, /* outside its range */
    differential_governed_controller_bad_M3_speed_max = 2028, /* outside its range */
    differential_governed_controller_bad_M3_speed_taper = 2029, /* outside its range */
    differential_governed_controller_bad_M3_torque_max = 2030, /* outside its range */
    differential_governed_controller_bad_disagreement_leak = 2031, /* outside its range */
    differential_governed_controller_bad_M1_inertia = 2032, /* outside its range */
    differential_governed_controller_bad_M1_disagreement_limit = 2033, /* outside its range */
    differential_governed_controller_bad_M1_frozen_limit = 2034, /* outside its range */
    differential_governed_controller_bad_frozen_time = 2035, /* outside its range */
    differential_governed_controller_bad_M2_inertia = 2036, /* outside its range */
    differential_governed_controller_bad_M2_disagreement_limit = 2037, /* outside its range */
    differential_governed_controller_bad_M2_frozen_limit = 2038, /* outside its range */
    differential_governed_controller_bad_M3_inertia = 2039, /* outside its range */
    differential_governed_controller_bad_M3_disagreement_limit = 2040, /* outside its range */
    differential_governed_controller_bad_M3_frozen_limit = 2041, /* outside its range */
    differential_governed_controller_bad_oscillation_frequency = 2042, /* outside its range */
    differential_governed_controller_bad_flange1_torque_oscillation_limit = 2043, /* outside its range */
    differential_governed_controller_bad_flange2_torque_oscillation_limit = 2044, /* outside its range */
    differential_governed_controller_bad_flange3_torque_oscillation_limit = 2045, /* outside its range */
    differential_governed_controller_bad_M1_torque_ref_oscillation_limit = 2046, /* outside its range */
    differential_governed_controller_bad_M2_torque_ref_oscillation_limit = 2047, /* outside its range */
    differential_governed_controller_bad_M3_torque_ref_oscillation_limit = 2048, /* outside its range */
    differential_governed_controller_bad_M2_speed_ref_rate = 2049, /* outside its range */
    differential_governed_controller_bad_M3_speed_ref_rate = 2050, /* outside its range */
    differential_governed_controller_bad_diff_input_torque_ref_rate = 2051, /* outside its range */
    differential_governed_controller_bad_M2_speed_gain = 2052, /* outside its range */
    differential_governed_controller_bad_M2_speed_integral_gain = 2053, /* outside its range */
    differential_governed_controller_bad_M3_speed_gain = 2054, /* outside its range */
    differential_governed_controller_bad_M3_speed_integral_gain = 2055, /* outside its range */
    differential_governed_controller_bad_M1_sensor_inertia_M2 = 2056, /* outside its range */
    differential_governed_controller_bad_M1_sensor_inertia_M3 = 2057, /* outside its range */
    differential_governed_controller_bad_M1_inertia_estimate = 2058, /* outside its range */
    differential_governed_controller_bad_M1_feedforward = 2059, /* outside its range */
    differential_governed_controller_bad_M1_torque_gain = 2060, /* outside its range */
    differential_governed_controller_bad_M1_model_stiffness = 2061, /* outside its range */
    differential_governed_controller_bad_M1_model_damping = 2062, /* outside its range */
    differential_governed_controller_bad_M1_torque_model = 2063, /* outside its range */
    differential_governed_controller_bad_diff_ratio = 2064, /* outside its range */
    differential_governed_controller_bad_M1_torque_integral_gain = 2065, /* outside its range */
    differential_governed_controller_bad_M1_damping_reserve = 2066, /* outside its range */
    differential_governed_controller_bad_M1_torque_integral_limit = 2067, /* outside its range */
    differential_governed_controller_bad_governor = 2068, /* outside its range */
    differential_governed_controller_bad_governor_reserve = 2069, /* outside its range */
    differential_governed_controller_bad_governor_stationary_reserve = 2070, /* outside its range */
    differential_governed_controller_bad_governor_tie = 2071, /* outside its range */
    differential_governed_controller_bad_torque_rate_min = 2072, /* outside its range */
    differential_governed_controller_bad_torque_reserve = 2073, /* outside its range */
    differential_governed_controller_bad_governor_torque_weight = 2074, /* outside its range */
    differential_governed_controller_bad_governor_speed_weight = 2075, /* outside its range */
    differential_governed_controller_bad_M1_at_rest_diff_input_torque_ref = 2076, /* outside its range */
    differential_governed_controller_bad_M2_at_rest_diff_input_torque_ref = 2077, /* outside its range */
    differential_governed_controller_bad_M3_at_rest_diff_input_torque_ref = 2078, /* outside its range */
    differential_governed_controller_bad_M1_speed_at_rest_M2_speed_ref = 2079, /* outside its range */
    differential_governed_controller_bad_M1_speed_at_rest_M3_speed_ref = 2080, /* outside its range */
} differential_governed_controller_status;

extern const differential_governed_controller_params differential_governed_controller_defaults;
extern const differential_governed_controller_params differential_governed_controller_conventional;

/* Name of a status, for logs. */
const char *differential_governed_controller_status_text(differential_governed_controller_status status);

/* Sets the initial state and prepares everything that follows from the parameters. */
differential_governed_controller_status differential_governed_controller_init(differential_governed_controller_state *state, const differential_governed_controller_params *params);

/* Checks the parameters and prepares what follows from them; the rest of the state stays. */
differential_governed_controller_status differential_governed_controller_update(differential_governed_controller_state *state, const differential_governed_controller_params *params);

/* One step. */
differential_governed_controller_status differential_governed_controller_step(differential_governed_controller_state *state, const differential_governed_controller_params *params,
    const differential_governed_controller_inputs *inputs, differential_governed_controller_outputs *outputs);

#endif
