/*
 * transmission_controller.h: controller of the bed transmission
 *
 * Emitted by ptgen 0.1.0 from transmission.toml (SHA-256 e06936acb40aa4a5), template block.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef TRANSMISSION_CONTROLLER_H
#define TRANSMISSION_CONTROLLER_H

#include "transmission_support.h"

/* Parameters, in SI units; call transmission_controller_update after a change. */
typedef struct {
    transmission_real sample_time; /* step of the controller (s) */
    transmission_real fault_ramp; /* time from a fault to zero torque (s) */
    transmission_real hold_time; /* bad samples are bridged for that long, and no longer (s) */
    transmission_real gears_input_torque_ref_plausible; /* largest plausible gears_input_torque_ref (N m) */
    transmission_real M2_speed_ref_plausible; /* largest plausible M2_speed_ref (rad/s) */
    transmission_real gears_ratio_plausible; /* largest plausible gears_ratio */
    transmission_real M1_speed_plausible; /* largest plausible M1_speed (rad/s) */
    transmission_real flange1_torque_plausible; /* largest plausible flange1_torque (N m) */
    transmission_real flange2_torque_plausible; /* largest plausible flange2_torque (N m) */
    transmission_real M2_speed_plausible; /* largest plausible M2_speed (rad/s) */
    transmission_real M1_overspeed; /* speed of M1 that is a fault (rad/s) */
    transmission_real M2_overspeed; /* speed of M2 that is a fault (rad/s) */
    transmission_real load_compensation; /* switch of the load torque compensation, 0 to 1 */
    transmission_real acceleration_torque; /* switch of the acceleration torque, 0 to 1 */
    transmission_real switch_time; /* time in which a switch or a damping follows its parameter (s) */
    transmission_real M1_damping; /* active damping by M1 (5.81) (N m s/rad) */
    transmission_real M1_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    transmission_real M1_speed_max; /* largest admissible speed (rad/s) */
    transmission_real M1_speed_taper; /* speed above M1_speed_max over which accelerating torque is taken back (rad/s) */
    transmission_real M1_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    transmission_real M2_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    transmission_real M2_speed_max; /* largest admissible speed (rad/s) */
    transmission_real M2_speed_taper; /* speed above M2_speed_max over which accelerating torque is taken back (rad/s) */
    transmission_real M2_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    transmission_real gears_ratio_least; /* least gears_ratio */
    transmission_real gears_ratio_most; /* largest gears_ratio */
    transmission_real gears_ratio_source; /* switch: 0 the ratio is the input, 1 it is estimated from the speeds */
    transmission_real gears_ratio_least_speed; /* speed behind the ratio below which gears_ratio is not estimated (rad/s) */
    transmission_real gears_ratio_estimate_time; /* time constant of the estimate of gears_ratio (s) */
    transmission_real gears_ratio_tolerance; /* distance from the ratio of a gear, as a share of it, within which gears_ratio is taken for that gear */
    transmission_real gears_ratio_settle_time; /* time that gears_ratio stays there before (s) */
    transmission_real gears_ratio_rate; /* largest rate of gears_ratio (/s) */
    transmission_real disagreement_leak; /* rate at which the integrated speeds forget (1/s) */
    transmission_real M1_inertia; /* moment of inertia of the rotor (kg m^2) */
    transmission_real M1_disagreement_limit; /* largest difference between measured and integrated speed of M1 (rad/s) */
    transmission_real M1_frozen_limit; /* the same while a signal of M1 stays the same to the last bit (rad/s) */
    transmission_real frozen_time; /* for how long a frozen signal stays the same (s) */
    transmission_real M2_inertia; /* moment of inertia of the rotor (kg m^2) */
    transmission_real M2_disagreement_limit; /* largest difference between measured and integrated speed of M2 (rad/s) */
    transmission_real M2_frozen_limit; /* the same while a signal of M2 stays the same to the last bit (rad/s) */
    transmission_real oscillation_frequency; /* slowest oscillation of a torque that is watched (Hz) */
    transmission_real flange1_torque_oscillation_limit; /* amplitude with which flange1_torque may oscillate (N m) */
    transmission_real flange2_torque_oscillation_limit; /* amplitude with which flange2_torque may oscillate (N m) */
    transmission_real M1_torque_ref_oscillation_limit; /* amplitude with which M1_torque_ref may oscillate (N m) */
    transmission_real M2_torque_ref_oscillation_limit; /* amplitude with which M2_torque_ref may oscillate (N m) */
    transmission_real M2_speed_ref_rate; /* largest rate of M2_speed_ref (rad/s^2) */
    transmission_real gears_input_torque_ref_rate; /* largest rate of gears_input_torque_ref (N m/s) */
    transmission_real M2_speed_gain; /* proportional gain of the speed of M2 (N m s/rad) */
    transmission_real M2_speed_integral_gain; /* integral gain of the speed of M2 (N m/rad) */
    transmission_real M1_sensor_inertia_M2; /* torque of M1 that its sensors miss, per acceleration of M2 times gears_ratio (kg m^2) */
    transmission_real M1_inertia_estimate; /* inertia that M1 accelerates (5.78) (kg m^2) */
    transmission_real M1_feedforward; /* share of the torque reference fed forward to M1 */
    transmission_real M1_torque_gain; /* proportional gain of the torque control of M1, above -1 (5.115a) */
    transmission_real M1_model_stiffness; /* stiffness in the torque model of M1 (N m/rad) */
    transmission_real M1_model_damping; /* damping in the torque model of M1 (N m s/rad) */
    transmission_real M1_torque_model; /* switch of the torque model of M1, 0 to 1 */
    transmission_real M1_torque_integral_gain; /* integral gain of the torque control of M1 (1/s) */
    transmission_real M1_damping_reserve; /* share of the torque of M1 kept for damping */
    transmission_real M1_torque_integral_limit; /* limit of the torque integrator of M1 (N m) */
} transmission_controller_params;

/* Inputs of a step. */
typedef struct {
    transmission_real gears_input_torque_ref; /* reference (N m) */
    transmission_real M2_speed_ref; /* reference (rad/s) */
    transmission_real gears_ratio; /* measured */
    transmission_real M1_speed; /* measured (rad/s) */
    transmission_real flange1_torque; /* measured (N m) */
    transmission_real flange2_torque; /* measured (N m) */
    transmission_real M2_speed; /* measured (rad/s) */
    transmission_real reset; /* 0 or 1; its rising edge takes back a fault whose cause is gone */
} transmission_controller_inputs;

/* Outputs of a step; torques are positive when they drive the right-hand neighbour. */
typedef struct {
    transmission_real M1_torque_ref; /* air-gap torque reference of M1 (N m) */
    transmission_real M2_torque_ref; /* air-gap torque reference of M2 (N m) */
} transmission_controller_outputs;

/* States first, then what follows from the parameters. Matrices are stored by columns. */
typedef struct {
    transmission_real fault; /* 0, or the status of the first fault */
    transmission_real authority; /* share of the torques that is released; goes along the ramp */
    transmission_real running; /* 1 if the last step ran without a fault, 0 before and after */
    transmission_real refused; /* 1 while the parameters of the last update are refused */
    transmission_real gears_input_torque_ref_held; /* last sound value of gears_input_torque_ref (N m) */
    transmission_real gears_input_torque_ref_bad_time; /* for how long gears_input_torque_ref was bad (s) */
    transmission_real M2_speed_ref_held; /* last sound value of M2_speed_ref (rad/s) */
    transmission_real M2_speed_ref_bad_time; /* for how long M2_speed_ref was bad (s) */
    transmission_real gears_ratio_held; /* last sound value of gears_ratio */
    transmission_real gears_ratio_bad_time; /* for how long gears_ratio was bad (s) */
    transmission_real M1_speed_held; /* last sound value of M1_speed (rad/s) */
    transmission_real M1_speed_bad_time; /* for how long M1_speed was bad (s) */
    transmission_real flange1_torque_held; /* last sound value of flange1_torque (N m) */
    transmission_real flange1_torque_bad_time; /* for how long flange1_torque was bad (s) */
    transmission_real flange2_torque_held; /* last sound value of flange2_torque (N m) */
    transmission_real flange2_torque_bad_time; /* for how long flange2_torque was bad (s) */
    transmission_real M2_speed_held; /* last sound value of M2_speed (rad/s) */
    transmission_real M2_speed_bad_time; /* for how long M2_speed was bad (s) */
    transmission_real M1_overspeed_time; /* for how long M1 was too fast (s) */
    transmission_real M2_overspeed_time; /* for how long M2 was too fast (s) */
    transmission_real reset_before; /* reset in the step before */
    transmission_real reset_request; /* 1 while a reset waits for zero torque */
    transmission_real load_compensation_now; /* load_compensation on its way to the parameter */
    transmission_real load_compensation_target; /* load_compensation as the last step found it */
    transmission_real load_compensation_step; /* how far load_compensation moves in a step */
    transmission_real acceleration_torque_now; /* acceleration_torque on its way to the parameter */
    transmission_real acceleration_torque_target; /* acceleration_torque as the last step found it */
    transmission_real acceleration_torque_step; /* how far acceleration_torque moves in a step */
    transmission_real M1_damping_now; /* M1_damping on its way to the parameter (N m s/rad) */
    transmission_real M1_damping_target; /* M1_damping as the last step found it (N m s/rad) */
    transmission_real M1_damping_step; /* how far M1_damping moves in a step (N m s/rad) */
    transmission_real gears_ratio_source_now; /* gears_ratio_source on its way to the parameter */
    transmission_real gears_ratio_source_target; /* gears_ratio_source as the last step found it */
    transmission_real gears_ratio_source_step; /* how far gears_ratio_source moves in a step */
    transmission_real gears_ratio_estimate; /* gears_ratio from the speeds, low-passed */
    transmission_real gears_ratio_near_time; /* for how long gears_ratio has been near a gear (s) */
    transmission_real gears_ratio_gear; /* ratio of the gear that the estimate of gears_ratio is taken for, 0 for none */
    transmission_real gears_ratio_limited; /* gears_ratio behind its rate limiter */
    transmission_real M1_integrated; /* speed of M1 from the torques (rad/s) */
    transmission_real M1_disagreement_time; /* for how long the speed of M1 disagreed (s) */
    transmission_real M1_speed_before; /* M1_speed in the step before (rad/s) */
    transmission_real M1_speed_still_time; /* for how long M1_speed has been the same (s) */
    transmission_real flange1_torque_before; /* flange1_torque in the step before (N m) */
    transmission_real flange1_torque_still_time; /* for how long flange1_torque has been the same (s) */
    transmission_real flange1_torque_command; /* command to M1 when flange1_torque last changed (N m) */
    transmission_real M2_integrated; /* speed of M2 from the torques (rad/s) */
    transmission_real M2_disagreement_time; /* for how long the speed of M2 disagreed (s) */
    transmission_real M2_speed_before; /* M2_speed in the step before (rad/s) */
    transmission_real M2_speed_still_time; /* for how long M2_speed has been the same (s) */
    transmission_real flange2_torque_before; /* flange2_torque in the step before (N m) */
    transmission_real flange2_torque_still_time; /* for how long flange2_torque has been the same (s) */
    transmission_real flange2_torque_command; /* command to M2 when flange2_torque last changed (N m) */
    transmission_real flange1_torque_mean; /* flange1_torque without its oscillation (N m) */
    transmission_real flange1_torque_side; /* side on which flange1_torque last was beyond the limit */
    transmission_real flange1_torque_swings; /* half swings of flange1_torque, forgotten in time */
    transmission_real flange2_torque_mean; /* flange2_torque without its oscillation (N m) */
    transmission_real flange2_torque_side; /* side on which flange2_torque last was beyond the limit */
    transmission_real flange2_torque_swings; /* half swings of flange2_torque, forgotten in time */
    transmission_real M1_torque_ref_mean; /* M1_torque_ref without its oscillation (N m) */
    transmission_real M1_torque_ref_side; /* side on which M1_torque_ref last was beyond the limit */
    transmission_real M1_torque_ref_swings; /* half swings of M1_torque_ref, forgotten in time */
    transmission_real M2_torque_ref_mean; /* M2_torque_ref without its oscillation (N m) */
    transmission_real M2_torque_ref_side; /* side on which M2_torque_ref last was beyond the limit */
    transmission_real M2_torque_ref_swings; /* half swings of M2_torque_ref, forgotten in time */
    transmission_real M2_speed_ref_limited; /* M2_speed_ref behind its rate limiter (rad/s) */
    transmission_real gears_input_torque_ref_limited; /* gears_input_torque_ref behind its rate limiter (N m) */
    transmission_real M2_speed_integral; /* integrator of the speed control of M2 (N m) */
    transmission_real M1_model_torque; /* torque that the feedforward to M1 should give (N m) */
    transmission_real M1_model_rate; /* rate of the torque model of M1 (N m/s) */
    transmission_real M1_torque_integral; /* integrator of the torque control of M1 (N m) */
    transmission_real M1_last; /* last torque of M1 before a fault (N m) */
    transmission_real M2_last; /* last torque of M2 before a fault (N m) */
    transmission_real M1_calm; /* smoothed torque of M1, that of before a fault (N m) */
    transmission_real M2_calm; /* smoothed torque of M2, that of before a fault (N m) */
    transmission_real bridged_time; /* for how long bad samples are bridged, with room for rounding (s) */
    transmission_real switch_share; /* share of a change per step */
    transmission_real M1_taper_slope; /* share of the torque of M1 per excess of speed (s/rad) */
    transmission_real M1_taper_end; /* share at standstill if it were not limited */
    transmission_real M1_power; /* power of M1 above its rated speed (W) */
    transmission_real M2_taper_slope; /* share of the torque of M2 per excess of speed (s/rad) */
    transmission_real M2_taper_end; /* share at standstill if it were not limited */
    transmission_real M2_power; /* power of M2 above its rated speed (W) */
    transmission_real gears_ratio_estimate_share; /* share of a new value in the estimate of gears_ratio */
    transmission_real gears_ratio_step; /* largest change of gears_ratio in a step */
    transmission_real steps_per_second; /* one over the step (1/s) */
    transmission_real disagreement_share; /* share of the difference that is forgotten per step */
    transmission_real M1_per_step; /* change of speed of M1 per torque in a step (rad/s/(N m)) */
    transmission_real M1_moved_torque; /* change of the command to M1 that a torque must follow (N m) */
    transmission_real M2_per_step; /* change of speed of M2 per torque in a step (rad/s/(N m)) */
    transmission_real M2_moved_torque; /* change of the command to M2 that a torque must follow (N m) */
    transmission_real forgotten_swings; /* half swings that are forgotten per step */
    transmission_real mean_share; /* share of a step in the mean of a torque */
    transmission_real M2_speed_ref_step; /* largest change of M2_speed_ref in a step (rad/s) */
    transmission_real gears_input_torque_ref_step; /* largest change of gears_input_torque_ref in a step (N m) */
    transmission_real M2_speed_growth; /* growth of the integrator per error (N m s/rad) */
    transmission_real M2_speed_conditioning; /* growth per torque cut off */
    transmission_real M1_unread_M2; /* the same per net torque */
    transmission_real M1_model_pull; /* rate of the torque model per missing torque (1/s) */
    transmission_real M1_model_drag; /* decay of that rate in a step */
    transmission_real M1_torque_growth; /* growth of the integrator per error */
    transmission_real M1_largest; /* torque of M1 that is a fault (N m) */
    transmission_real M2_largest; /* torque of M2 that is a fault (N m) */
    transmission_real ramp_step; /* change of the released share per step */
    transmission_real calm_share; /* share of a new torque in the smoothed ones */
} transmission_controller_state;

typedef enum {
    transmission_controller_ok = 0,
    transmission_controller_fault_gears_input_torque_ref = 1, /* gears_input_torque_ref: not finite or not plausible */
    transmission_controller_fault_M2_speed_ref = 2, /* M2_speed_ref: not finite or not plausible */
    transmission_controller_fault_gears_ratio = 3, /* gears_ratio: not finite or not plausible */
    transmission_controller_fault_M1_speed = 4, /* M1_speed: not finite or not plausible */
    transmission_controller_fault_flange1_torque = 5, /* flange1_torque: not finite or not plausible */
    transmission_controller_fault_flange2_torque = 6, /* flange2_torque: not finite or not plausible */
    transmission_controller_fault_M2_speed = 7, /* M2_speed: not finite or not plausible */
    transmission_controller_fault_M1_speed_overspeed = 4004, /* M1_speed: overspeed */
    transmission_controller_fault_M2_speed_overspeed = 4007, /* M2_speed: overspeed */
    transmission_controller_fault_M1_speed_frozen = 3004, /* M1_speed: frozen while the torques accelerate the machine */
    transmission_controller_fault_M1_speed_disagreement = 5004, /* M1_speed: disagrees with the integrated torque */
    transmission_controller_fault_flange1_torque_frozen = 3005, /* flange1_torque: frozen while the torque of the machine changes */
    transmission_controller_fault_M2_speed_frozen = 3007, /* M2_speed: frozen while the torques accelerate the machine */
    transmission_controller_fault_M2_speed_disagreement = 5007, /* M2_speed: disagrees with the integrated torque */
    transmission_controller_fault_flange2_torque_frozen = 3006, /* flange2_torque: frozen while the torque of the machine changes */
    transmission_controller_fault_flange1_torque_oscillation = 6005, /* flange1_torque: oscillates beyond its limit */
    transmission_controller_fault_flange2_torque_oscillation = 6006, /* flange2_torque: oscillates beyond its limit */
    transmission_controller_fault_M1_torque_ref_oscillation = 8001, /* M1_torque_ref: the command oscillates */
    transmission_controller_fault_M2_torque_ref_oscillation = 8002, /* M2_torque_ref: the command oscillates */
    transmission_controller_fault_M1_torque_ref = 7001, /* M1_torque_ref: the command is not finite, or beyond the torque of the machine */
    transmission_controller_fault_M2_torque_ref = 7002, /* M2_torque_ref: the command is not finite, or beyond the torque of the machine */
    transmission_controller_bad_sample_time = 2000, /* outside its range */
    transmission_controller_bad_fault_ramp = 2001, /* outside its range */
    transmission_controller_bad_hold_time = 2002, /* outside its range */
    transmission_controller_bad_gears_input_torque_ref_plausible = 2003, /* outside its range */
    transmission_controller_bad_M2_speed_ref_plausible = 2004, /* outside its range */
    transmission_controller_bad_gears_ratio_plausible = 2005, /* outside its range */
    transmission_controller_bad_M1_speed_plausible = 2006, /* outside its range */
    transmission_controller_bad_flange1_torque_plausible = 2007, /* outside its range */
    transmission_controller_bad_flange2_torque_plausible = 2008, /* outside its range */
    transmission_controller_bad_M2_speed_plausible = 2009, /* outside its range */
    transmission_controller_bad_M1_overspeed = 2010, /* outside its range */
    transmission_controller_bad_M2_overspeed = 2011, /* outside its range */
    transmission_controller_bad_load_compensation = 2012, /* outside its range */
    transmission_controller_bad_acceleration_torque = 2013, /* outside its range */
    transmission_controller_bad_switch_time = 2014, /* outside its range */
    transmission_controller_bad_M1_damping = 2015, /* outside its range */
    transmission_controller_bad_M1_speed_rated = 2016, /* outside its range */
    transmission_controller_bad_M1_speed_max = 2017, /* outside its range */
    transmission_controller_bad_M1_speed_taper = 2018, /* outside its range */
    transmission_controller_bad_M1_torque_max = 2019, /* outside its range */
    transmission_controller_bad_M2_speed_rated = 2020, /* outside its range */
    transmission_controller_bad_M2_speed_max = 2021, /* outside its range */
    transmission_controller_bad_M2_speed_taper = 2022, /* outside its range */
    transmission_controller_bad_M2_torque_max = 2023, /* outside its range */
    transmission_controller_bad_gears_ratio_least = 2024, /* outside its range */
    transmission_controller_bad_gears_ratio_most = 2025, /* outside its range */
    transmission_controller_bad_gears_ratio_source = 2026, /* outside its range */
    transmission_controller_bad_gears_ratio_least_speed = 2027, /* outside its range */
    transmission_controller_bad_gears_ratio_estimate_time = 2028, /* outside its range */
    transmission_controller_bad_gears_ratio_tolerance = 2029, /* outside its range */
    transmission_controller_bad_gears_ratio_settle_time = 2030, /* outside its range */
    transmission_controller_bad_gears_ratio_rate = 2031, /* outside its range */
    transmission_controller_bad_disagreement_leak = 2032, /* outside its range */
    transmission_controller_bad_M1_inertia = 2033, /* outside its range */
    transmission_controller_bad_M1_disagreement_limit = 2034, /* outside its range */
    transmission_controller_bad_M1_frozen_limit = 2035, /* outside its range */
    transmission_controller_bad_frozen_time = 2036, /* outside its range */
    transmission_controller_bad_M2_inertia = 2037, /* outside its range */
    transmission_controller_bad_M2_disagreement_limit = 2038, /* outside its range */
    transmission_controller_bad_M2_frozen_limit = 2039, /* outside its range */
    transmission_controller_bad_oscillation_frequency = 2040, /* outside its range */
    transmission_controller_bad_flange1_torque_oscillation_limit = 2041, /* outside its range */
    transmission_controller_bad_flange2_torque_oscillation_limit = 2042, /* outside its range */
    transmission_controller_bad_M1_torque_ref_oscillation_limit = 2043, /* outside its range */
    transmission_controller_bad_M2_torque_ref_oscillation_limit = 2044, /* outside its range */
    transmission_controller_bad_M2_speed_ref_rate = 2045, /* outside its range */
    transmission_controller_bad_gears_input_torque_ref_rate = 2046, /* outside its range */
    transmission_controller_bad_M2_speed_gain = 2047, /* outside its range */
    transmission_controller_bad_M2_speed_integral_gain = 2048, /* outside its range */
    transmission_controller_bad_M1_sensor_inertia_M2 = 2049, /* outside its range */
    transmission_controller_bad_M1_inertia_estimate = 2050, /* outside its range */
    transmission_controller_bad_M1_feedforward = 2051, /* outside its range */
    transmission_controller_bad_M1_torque_gain = 2052, /* outside its range */
    transmission_controller_bad_M1_model_stiffness = 2053, /* outside its range */
    transmission_controller_bad_M1_model_damping = 2054, /* outside its range */
    transmission_controller_bad_M1_torque_model = 2055, /* outside its range */
    transmission_controller_bad_M1_torque_integral_gain = 2056, /* outside its range */
    transmission_controller_bad_M1_damping_reserve = 2057, /* outside its range */
    transmission_controller_bad_M1_torque_integral_limit = 2058, /* outside its range */
} transmission_controller_status;

extern const transmission_controller_params transmission_controller_defaults;
extern const transmission_controller_params transmission_controller_conventional;

/* Name of a status, for logs. */
const char *transmission_controller_status_text(transmission_controller_status status);

/* Sets the initial state and prepares everything that follows from the parameters. */
transmission_controller_status transmission_controller_init(transmission_controller_state *state, const transmission_controller_params *params);

/* Checks the parameters and prepares what follows from them; the rest of the state stays. */
transmission_controller_status transmission_controller_update(transmission_controller_state *state, const transmission_controller_params *params);

/* One step. */
transmission_controller_status transmission_controller_step(transmission_controller_state *state, const transmission_controller_params *params,
    const transmission_controller_inputs *inputs, transmission_controller_outputs *outputs);

#endif
