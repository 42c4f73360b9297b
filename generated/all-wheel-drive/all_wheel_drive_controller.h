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
    all_wheel_drive_real hold_time; /* bad samples are bridged for that long, and no longer (s) */
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
    all_wheel_drive_real M1_overspeed; /* speed of M1 that is a fault (rad/s) */
    all_wheel_drive_real M2_overspeed; /* speed of M2 that is a fault (rad/s) */
    all_wheel_drive_real M3_overspeed; /* speed of M3 that is a fault (rad/s) */
    all_wheel_drive_real M4_overspeed; /* speed of M4 that is a fault (rad/s) */
    all_wheel_drive_real M5_overspeed; /* speed of M5 that is a fault (rad/s) */
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
    all_wheel_drive_real disagreement_leak; /* rate at which the integrated speeds forget (1/s) */
    all_wheel_drive_real M1_inertia; /* moment of inertia of the rotor (kg m^2) */
    all_wheel_drive_real M1_disagreement_limit; /* largest difference between measured and integrated speed of M1 (rad/s) */
    all_wheel_drive_real M1_frozen_limit; /* the same while a signal of M1 stays the same to the last bit (rad/s) */
    all_wheel_drive_real frozen_time; /* for how long a frozen signal stays the same (s) */
    all_wheel_drive_real M2_inertia; /* moment of inertia of the rotor (kg m^2) */
    all_wheel_drive_real M2_disagreement_limit; /* largest difference between measured and integrated speed of M2 (rad/s) */
    all_wheel_drive_real M2_frozen_limit; /* the same while a signal of M2 stays the same to the last bit (rad/s) */
    all_wheel_drive_real M3_inertia; /* moment of inertia of the rotor (kg m^2) */
    all_wheel_drive_real M3_disagreement_limit; /* largest difference between measured and integrated speed of M3 (rad/s) */
    all_wheel_drive_real M3_frozen_limit; /* the same while a signal of M3 stays the same to the last bit (rad/s) */
    all_wheel_drive_real M4_inertia; /* moment of inertia of the rotor (kg m^2) */
    all_wheel_drive_real M4_disagreement_limit; /* largest difference between measured and integrated speed of M4 (rad/s) */
    all_wheel_drive_real M4_frozen_limit; /* the same while a signal of M4 stays the same to the last bit (rad/s) */
    all_wheel_drive_real M5_inertia; /* moment of inertia of the rotor (kg m^2) */
    all_wheel_drive_real M5_disagreement_limit; /* largest difference between measured and integrated speed of M5 (rad/s) */
    all_wheel_drive_real M5_frozen_limit; /* the same while a signal of M5 stays the same to the last bit (rad/s) */
    all_wheel_drive_real oscillation_frequency; /* slowest oscillation of a torque that is watched (Hz) */
    all_wheel_drive_real flange1_torque_oscillation_limit; /* amplitude with which flange1_torque may oscillate (N m) */
    all_wheel_drive_real flange2_torque_oscillation_limit; /* amplitude with which flange2_torque may oscillate (N m) */
    all_wheel_drive_real flange3_torque_oscillation_limit; /* amplitude with which flange3_torque may oscillate (N m) */
    all_wheel_drive_real flange4_torque_oscillation_limit; /* amplitude with which flange4_torque may oscillate (N m) */
    all_wheel_drive_real flange5_torque_oscillation_limit; /* amplitude with which flange5_torque may oscillate (N m) */
    all_wheel_drive_real M1_torque_ref_oscillation_limit; /* amplitude with which M1_torque_ref may oscillate (N m) */
    all_wheel_drive_real M2_torque_ref_oscillation_limit; /* amplitude with which M2_torque_ref may oscillate (N m) */
    all_wheel_drive_real M3_torque_ref_oscillation_limit; /* amplitude with which M3_torque_ref may oscillate (N m) */
    all_wheel_drive_real M4_torque_ref_oscillation_limit; /* amplitude with which M4_torque_ref may oscillate (N m) */
    all_wheel_drive_real M5_torque_ref_oscillation_limit; /* amplitude with which M5_torque_ref may oscillate (N m) */
    all_wheel_drive_real M2_speed_ref_rate; /* largest rate of M2_speed_ref (rad/s^2) */
    all_wheel_drive_real M3_speed_ref_rate; /* largest rate of M3_speed_ref (rad/s^2) */
    all_wheel_drive_real M4_speed_ref_rate; /* largest rate of M4_speed_ref (rad/s^2) */
    all_wheel_drive_real M5_speed_ref_rate; /* largest rate of M5_speed_ref (rad/s^2) */
    all_wheel_drive_real centre_input_torque_ref_rate; /* largest rate of centre_input_torque_ref (N m/s) */
    all_wheel_drive_real M2_speed_gain; /* proportional gain of the speed of M2 (N m s/rad) */
    all_wheel_drive_real M2_speed_integral_gain; /* integral gain of the speed of M2 (N m/rad) */
    all_wheel_drive_real M3_speed_gain; /* proportional gain of the speed of M3 (N m s/rad) */
    all_wheel_drive_real M3_speed_integral_gain; /* integral gain of the speed of M3 (N m/rad) */
    all_wheel_drive_real M4_speed_gain; /* proportional gain of the speed of M4 (N m s/rad) */
    all_wheel_drive_real M4_speed_integral_gain; /* integral gain of the speed of M4 (N m/rad) */
    all_wheel_drive_real M5_speed_gain; /* proportional gain of the speed of M5 (N m s/rad) */
    all_wheel_drive_real M5_speed_integral_gain; /* integral gain of the speed of M5 (N m/rad) */
    all_wheel_drive_real M1_sensor_inertia_M2; /* torque of M1 that its sensors miss, per acceleration of M2 (kg m^2) */
    all_wheel_drive_real M1_sensor_inertia_M3; /* torque of M1 that its sensors miss, per acceleration of M3 (kg m^2) */
    all_wheel_drive_real M1_sensor_inertia_M4; /* torque of M1 that its sensors miss, per acceleration of M4 (kg m^2) */
    all_wheel_drive_real M1_sensor_inertia_M5; /* torque of M1 that its sensors miss, per acceleration of M5 (kg m^2) */
    all_wheel_drive_real M1_inertia_estimate; /* inertia that M1 accelerates (5.78) (kg m^2) */
    all_wheel_drive_real M1_feedforward; /* share of the torque reference fed forward to M1 */
    all_wheel_drive_real M1_torque_gain; /* proportional gain of the torque control of M1, above -1 (5.115a) */
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
    all_wheel_drive_real reset; /* 0 or 1; its rising edge takes back a fault whose cause is gone */
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
    all_wheel_drive_real fault; /* 0, or the status of the first fault */
    all_wheel_drive_real authority; /* share of the torques that is released; goes along the ramp */
    all_wheel_drive_real running; /* 1 if the last step ran without a fault, 0 before and after */
    all_wheel_drive_real refused; /* 1 while the parameters of the last update are refused */
    all_wheel_drive_real centre_input_torque_ref_held; /* last sound value of centre_input_torque_ref (N m) */
    all_wheel_drive_real centre_input_torque_ref_bad_time; /* for how long centre_input_torque_ref was bad (s) */
    all_wheel_drive_real M2_speed_ref_held; /* last sound value of M2_speed_ref (rad/s) */
    all_wheel_drive_real M2_speed_ref_bad_time; /* for how long M2_speed_ref was bad (s) */
    all_wheel_drive_real M3_speed_ref_held; /* last sound value of M3_speed_ref (rad/s) */
    all_wheel_drive_real M3_speed_ref_bad_time; /* for how long M3_speed_ref was bad (s) */
    all_wheel_drive_real M4_speed_ref_held; /* last sound value of M4_speed_ref (rad/s) */
    all_wheel_drive_real M4_speed_ref_bad_time; /* for how long M4_speed_ref was bad (s) */
    all_wheel_drive_real M5_speed_ref_held; /* last sound value of M5_speed_ref (rad/s) */
    all_wheel_drive_real M5_speed_ref_bad_time; /* for how long M5_speed_ref was bad (s) */
    all_wheel_drive_real M1_speed_held; /* last sound value of M1_speed (rad/s) */
    all_wheel_drive_real M1_speed_bad_time; /* for how long M1_speed was bad (s) */
    all_wheel_drive_real flange1_torque_held; /* last sound value of flange1_torque (N m) */
    all_wheel_drive_real flange1_torque_bad_time; /* for how long flange1_torque was bad (s) */
    all_wheel_drive_real flange2_torque_held; /* last sound value of flange2_torque (N m) */
    all_wheel_drive_real flange2_torque_bad_time; /* for how long flange2_torque was bad (s) */
    all_wheel_drive_real M2_speed_held; /* last sound value of M2_speed (rad/s) */
    all_wheel_drive_real M2_speed_bad_time; /* for how long M2_speed was bad (s) */
    all_wheel_drive_real flange3_torque_held; /* last sound value of flange3_torque (N m) */
    all_wheel_drive_real flange3_torque_bad_time; /* for how long flange3_torque was bad (s) */
    all_wheel_drive_real M3_speed_held; /* last sound value of M3_speed (rad/s) */
    all_wheel_drive_real M3_speed_bad_time; /* for how long M3_speed was bad (s) */
    all_wheel_drive_real flange4_torque_held; /* last sound value of flange4_torque (N m) */
    all_wheel_drive_real flange4_torque_bad_time; /* for how long flange4_torque was bad (s) */
    all_wheel_drive_real M4_speed_held; /* last sound value of M4_speed (rad/s) */
    all_wheel_drive_real M4_speed_bad_time; /* for how long M4_speed was bad (s) */
    all_wheel_drive_real flange5_torque_held; /* last sound value of flange5_torque (N m) */
    all_wheel_drive_real flange5_torque_bad_time; /* for how long flange5_torque was bad (s) */
    all_wheel_drive_real M5_speed_held; /* last sound value of M5_speed (rad/s) */
    all_wheel_drive_real M5_speed_bad_time; /* for how long M5_speed was bad (s) */
    all_wheel_drive_real M1_overspeed_time; /* for how long M1 was too fast (s) */
    all_wheel_drive_real M2_overspeed_time; /* for how long M2 was too fast (s) */
    all_wheel_drive_real M3_overspeed_time; /* for how long M3 was too fast (s) */
    all_wheel_drive_real M4_overspeed_time; /* for how long M4 was too fast (s) */
    all_wheel_drive_real M5_overspeed_time; /* for how long M5 was too fast (s) */
    all_wheel_drive_real reset_before; /* reset in the step before */
    all_wheel_drive_real reset_request; /* 1 while a reset waits for zero torque */
    all_wheel_drive_real load_compensation_now; /* load_compensation on its way to the parameter */
    all_wheel_drive_real load_compensation_target; /* load_compensation as the last step found it */
    all_wheel_drive_real load_compensation_step; /* how far load_compensation moves in a step */
    all_wheel_drive_real acceleration_torque_now; /* acceleration_torque on its way to the parameter */
    all_wheel_drive_real acceleration_torque_target; /* acceleration_torque as the last step found it */
    all_wheel_drive_real acceleration_torque_step; /* how far acceleration_torque moves in a step */
    all_wheel_drive_real M1_damping_now; /* M1_damping on its way to the parameter (N m s/rad) */
    all_wheel_drive_real M1_damping_target; /* M1_damping as the last step found it (N m s/rad) */
    all_wheel_drive_real M1_damping_step; /* how far M1_damping moves in a step (N m s/rad) */
    all_wheel_drive_real M1_integrated; /* speed of M1 from the torques (rad/s) */
    all_wheel_drive_real M1_disagreement_time; /* for how long the speed of M1 disagreed (s) */
    all_wheel_drive_real M1_speed_before; /* M1_speed in the step before (rad/s) */
    all_wheel_drive_real M1_speed_still_time; /* for how long M1_speed has been the same (s) */
    all_wheel_drive_real flange1_torque_before; /* flange1_torque in the step before (N m) */
    all_wheel_drive_real flange1_torque_still_time; /* for how long flange1_torque has been the same (s) */
    all_wheel_drive_real flange1_torque_command; /* command to M1 when flange1_torque last changed (N m) */
    all_wheel_drive_real M2_integrated; /* speed of M2 from the torques (rad/s) */
    all_wheel_drive_real M2_disagreement_time; /* for how long the speed of M2 disagreed (s) */
    all_wheel_drive_real M2_speed_before; /* M2_speed in the step before (rad/s) */
    all_wheel_drive_real M2_speed_still_time; /* for how long M2_speed has been the same (s) */
    all_wheel_drive_real flange2_torque_before; /* flange2_torque in the step before (N m) */
    all_wheel_drive_real flange2_torque_still_time; /* for how long flange2_torque has been the same (s) */
    all_wheel_drive_real flange2_torque_command; /* command to M2 when flange2_torque last changed (N m) */
    all_wheel_drive_real M3_integrated; /* speed of M3 from the torques (rad/s) */
    all_wheel_drive_real M3_disagreement_time; /* for how long the speed of M3 disagreed (s) */
    all_wheel_drive_real M3_speed_before; /* M3_speed in the step before (rad/s) */
    all_wheel_drive_real M3_speed_still_time; /* for how long M3_speed has been the same (s) */
    all_wheel_drive_real flange3_torque_before; /* flange3_torque in the step before (N m) */
    all_wheel_drive_real flange3_torque_still_time; /* for how long flange3_torque has been the same (s) */
    all_wheel_drive_real flange3_torque_command; /* command to M3 when flange3_torque last changed (N m) */
    all_wheel_drive_real M4_integrated; /* speed of M4 from the torques (rad/s) */
    all_wheel_drive_real M4_disagreement_time; /* for how long the speed of M4 disagreed (s) */
    all_wheel_drive_real M4_speed_before; /* M4_speed in the step before (rad/s) */
    all_wheel_drive_real M4_speed_still_time; /* for how long M4_speed has been the same (s) */
    all_wheel_drive_real flange4_torque_before; /* flange4_torque in the step before (N m) */
    all_wheel_drive_real flange4_torque_still_time; /* for how long flange4_torque has been the same (s) */
    all_wheel_drive_real flange4_torque_command; /* command to M4 when flange4_torque last changed (N m) */
    all_wheel_drive_real M5_integrated; /* speed of M5 from the torques (rad/s) */
    all_wheel_drive_real M5_disagreement_time; /* for how long the speed of M5 disagreed (s) */
    all_wheel_drive_real M5_speed_before; /* M5_speed in the step before (rad/s) */
    all_wheel_drive_real M5_speed_still_time; /* for how long M5_speed has been the same (s) */
    all_wheel_drive_real flange5_torque_before; /* flange5_torque in the step before (N m) */
    all_wheel_drive_real flange5_torque_still_time; /* for how long flange5_torque has been the same (s) */
    all_wheel_drive_real flange5_torque_command; /* command to M5 when flange5_torque last changed (N m) */
    all_wheel_drive_real flange1_torque_mean; /* flange1_torque without its oscillation (N m) */
    all_wheel_drive_real flange1_torque_side; /* side on which flange1_torque last was beyond the limit */
    all_wheel_drive_real flange1_torque_swings; /* half swings of flange1_torque, forgotten in time */
    all_wheel_drive_real flange2_torque_mean; /* flange2_torque without its oscillation (N m) */
    all_wheel_drive_real flange2_torque_side; /* side on which flange2_torque last was beyond the limit */
    all_wheel_drive_real flange2_torque_swings; /* half swings of flange2_torque, forgotten in time */
    all_wheel_drive_real flange3_torque_mean; /* flange3_torque without its oscillation (N m) */
    all_wheel_drive_real flange3_torque_side; /* side on which flange3_torque last was beyond the limit */
    all_wheel_drive_real flange3_torque_swings; /* half swings of flange3_torque, forgotten in time */
    all_wheel_drive_real flange4_torque_mean; /* flange4_torque without its oscillation (N m) */
    all_wheel_drive_real flange4_torque_side; /* side on which flange4_torque last was beyond the limit */
    all_wheel_drive_real flange4_torque_swings; /* half swings of flange4_torque, forgotten in time */
    all_wheel_drive_real flange5_torque_mean; /* flange5_torque without its oscillation (N m) */
    all_wheel_drive_real flange5_torque_side; /* side on which flange5_torque last was beyond the limit */
    all_wheel_drive_real flange5_torque_swings; /* half swings of flange5_torque, forgotten in time */
    all_wheel_drive_real M1_torque_ref_mean; /* M1_torque_ref without its oscillation (N m) */
    all_wheel_drive_real M1_torque_ref_side; /* side on which M1_torque_ref last was beyond the limit */
    all_wheel_drive_real M1_torque_ref_swings; /* half swings of M1_torque_ref, forgotten in time */
    all_wheel_drive_real M2_torque_ref_mean; /* M2_torque_ref without its oscillation (N m) */
    all_wheel_drive_real M2_torque_ref_side; /* side on which M2_torque_ref last was beyond the limit */
    all_wheel_drive_real M2_torque_ref_swings; /* half swings of M2_torque_ref, forgotten in time */
    all_wheel_drive_real M3_torque_ref_mean; /* M3_torque_ref without its oscillation (N m) */
    all_wheel_drive_real M3_torque_ref_side; /* side on which M3_torque_ref last was beyond the limit */
    all_wheel_drive_real M3_torque_ref_swings; /* half swings of M3_torque_ref, forgotten in time */
    all_wheel_drive_real M4_torque_ref_mean; /* M4_torque_ref without its oscillation (N m) */
    all_wheel_drive_real M4_torque_ref_side; /* side on which M4_torque_ref last was beyond the limit */
    all_wheel_drive_real M4_torque_ref_swings; /* half swings of M4_torque_ref, forgotten in time */
    all_wheel_drive_real M5_torque_ref_mean; /* M5_torque_ref without its oscillation (N m) */
    all_wheel_drive_real M5_torque_ref_side; /* side on which M5_torque_ref last was beyond the limit */
    all_wheel_drive_real M5_torque_ref_swings; /* half swings of M5_torque_ref, forgotten in time */
    all_wheel_drive_real M2_speed_ref_limited; /* M2_speed_ref behind its rate limiter (rad/s) */
    all_wheel_drive_real M3_speed_ref_limited; /* M3_speed_ref behind its rate limiter (rad/s) */
    all_wheel_drive_real M4_speed_ref_limited; /* M4_speed_ref behind its rate limiter (rad/s) */
    all_wheel_drive_real M5_speed_ref_limited; /* M5_speed_ref behind its rate limiter (rad/s) */
    all_wheel_drive_real centre_input_torque_ref_limited; /* centre_input_torque_ref behind its rate limiter (N m) */
    all_wheel_drive_real M2_speed_integral; /* integrator of the speed control of M2 (N m) */
    all_wheel_drive_real M3_speed_integral; /* integrator of the speed control of M3 (N m) */
    all_wheel_drive_real M4_speed_integral; /* integrator of the speed control of M4 (N m) */
    all_wheel_drive_real M5_speed_integral; /* integrator of the speed control of M5 (N m) */
    all_wheel_drive_real M1_model_torque; /* torque that the feedforward to M1 should give (N m) */
    all_wheel_drive_real M1_model_rate; /* rate of the torque model of M1 (N m/s) */
    all_wheel_drive_real M1_torque_integral; /* integrator of the torque control of M1 (N m) */
    all_wheel_drive_real M1_last; /* last torque of M1 before a fault (N m) */
    all_wheel_drive_real M2_last; /* last torque of M2 before a fault (N m) */
    all_wheel_drive_real M3_last; /* last torque of M3 before a fault (N m) */
    all_wheel_drive_real M4_last; /* last torque of M4 before a fault (N m) */
    all_wheel_drive_real M5_last; /* last torque of M5 before a fault (N m) */
    all_wheel_drive_real M1_calm; /* smoothed torque of M1, that of before a fault (N m) */
    all_wheel_drive_real M2_calm; /* smoothed torque of M2, that of before a fault (N m) */
    all_wheel_drive_real M3_calm; /* smoothed torque of M3, that of before a fault (N m) */
    all_wheel_drive_real M4_calm; /* smoothed torque of M4, that of before a fault (N m) */
    all_wheel_drive_real M5_calm; /* smoothed torque of M5, that of before a fault (N m) */
    all_wheel_drive_real bridged_time; /* for how long bad samples are bridged, with room for rounding (s) */
    all_wheel_drive_real switch_share; /* share of a change per step */
    all_wheel_drive_real M1_taper_slope; /* share of the torque of M1 per excess of speed (s/rad) */
    all_wheel_drive_real M1_taper_end; /* share at standstill if it were not limited */
    all_wheel_drive_real M1_power; /* power of M1 above its rated speed (W) */
    all_wheel_drive_real M2_taper_slope; /* share of the torque of M2 per excess of speed (s/rad) */
    all_wheel_drive_real M2_taper_end; /* share at standstill if it were not limited */
    all_wheel_drive_real M2_power; /* power of M2 above its rated speed (W) */
    all_wheel_drive_real M3_taper_slope; /* share of the torque of M3 per excess of speed (s/rad) */
    all_wheel_drive_real M3_taper_end; /* share at standstill if it were not limited */
    all_wheel_drive_real M3_power; /* power of M3 above its rated speed (W) */
    all_wheel_drive_real M4_taper_slope; /* share of the torque of M4 per excess of speed (s/rad) */
    all_wheel_drive_real M4_taper_end; /* share at standstill if it were not limited */
    all_wheel_drive_real M4_power; /* power of M4 above its rated speed (W) */
    all_wheel_drive_real M5_taper_slope; /* share of the torque of M5 per excess of speed (s/rad) */
    all_wheel_drive_real M5_taper_end; /* share at standstill if it were not limited */
    all_wheel_drive_real M5_power; /* power of M5 above its rated speed (W) */
    all_wheel_drive_real disagreement_share; /* share of the difference that is forgotten per step */
    all_wheel_drive_real M1_per_step; /* change of speed of M1 per torque in a step (rad/s/(N m)) */
    all_wheel_drive_real M1_moved_torque; /* change of the command to M1 that a torque must follow (N m) */
    all_wheel_drive_real M2_per_step; /* change of speed of M2 per torque in a step (rad/s/(N m)) */
    all_wheel_drive_real M2_moved_torque; /* change of the command to M2 that a torque must follow (N m) */
    all_wheel_drive_real M3_per_step; /* change of speed of M3 per torque in a step (rad/s/(N m)) */
    all_wheel_drive_real M3_moved_torque; /* change of the command to M3 that a torque must follow (N m) */
    all_wheel_drive_real M4_per_step; /* change of speed of M4 per torque in a step (rad/s/(N m)) */
    all_wheel_drive_real M4_moved_torque; /* change of the command to M4 that a torque must follow (N m) */
    all_wheel_drive_real M5_per_step; /* change of speed of M5 per torque in a step (rad/s/(N m)) */
    all_wheel_drive_real M5_moved_torque; /* change of the command to M5 that a torque must follow (N m) */
    all_wheel_drive_real forgotten_swings; /* half swings that are forgotten per step */
    all_wheel_drive_real mean_share; /* share of a step in the mean of a torque */
    all_wheel_drive_real M2_speed_ref_step; /* largest change of M2_speed_ref in a step (rad/s) */
    all_wheel_drive_real M3_speed_ref_step; /* largest change of M3_speed_ref in a step (rad/s) */
    all_wheel_drive_real M4_speed_ref_step; /* largest change of M4_speed_ref in a step (rad/s) */
    all_wheel_drive_real M5_speed_ref_step; /* largest change of M5_speed_ref in a step (rad/s) */
    all_wheel_drive_real centre_input_torque_ref_step; /* largest change of centre_input_torque_ref in a step (N m) */
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
    all_wheel_drive_real M1_model_pull; /* rate of the torque model per missing torque (1/s) */
    all_wheel_drive_real M1_model_drag; /* decay of that rate in a step */
    all_wheel_drive_real M1_with_M2; /* coefficient of the virtual input of M2 */
    all_wheel_drive_real M1_with_M3; /* coefficient of the virtual input of M3 */
    all_wheel_drive_real M1_with_M4; /* coefficient of the virtual input of M4 */
    all_wheel_drive_real M1_with_M5; /* coefficient of the virtual input of M5 */
    all_wheel_drive_real M1_twist_M1_M2_speed; /* coefficient of M2_speed */
    all_wheel_drive_real M1_twist_M1_M3_speed; /* coefficient of M3_speed */
    all_wheel_drive_real M1_twist_M1_M4_speed; /* coefficient of M4_speed */
    all_wheel_drive_real M1_twist_M1_M5_speed; /* coefficient of M5_speed */
    all_wheel_drive_real M1_torque_growth; /* growth of the integrator per error */
    all_wheel_drive_real M1_largest; /* torque of M1 that is a fault (N m) */
    all_wheel_drive_real M2_largest; /* torque of M2 that is a fault (N m) */
    all_wheel_drive_real M3_largest; /* torque of M3 that is a fault (N m) */
    all_wheel_drive_real M4_largest; /* torque of M4 that is a fault (N m) */
    all_wheel_drive_real M5_largest; /* torque of M5 that is a fault (N m) */
    all_wheel_drive_real ramp_step; /* change of the released share per step */
    all_wheel_drive_real calm_share; /* share of a new torque in the smoothed ones */
} all_wheel_drive_controller_state;

typedef enum {
    all_wheel_drive_controller_ok = 0,
    all_wheel_drive_controller_fault_centre_input_torque_ref = 1, /* centre_input_torque_ref: not finite or not plausible */
    all_wheel_drive_controller_fault_M2_speed_ref = 2, /* M2_speed_ref: not finite or not plausible */
    all_wheel_drive_controller_fault_M3_speed_ref = 3, /* M3_speed_ref: not finite or not plausible */
    all_wheel_drive_controller_fault_M4_speed_ref = 4, /* M4_speed_ref: not finite or not plausible */
    all_wheel_drive_controller_fault_M5_speed_ref = 5, /* M5_speed_ref: not finite or not plausible */
    all_wheel_drive_controller_fault_M1_speed = 6, /* M1_speed: not finite or not plausible */
    all_wheel_drive_controller_fault_flange1_torque = 7, /* flange1_torque: not finite or not plausible */
    all_wheel_drive_controller_fault_flange2_torque = 8, /* flange2_torque: not finite or not plausible */
    all_wheel_drive_controller_fault_M2_speed = 9, /* M2_speed: not finite or not plausible */
    all_wheel_drive_controller_fault_flange3_torque = 10, /* flange3_torque: not finite or not plausible */
    all_wheel_drive_controller_fault_M3_speed = 11, /* M3_speed: not finite or not plausible */
    all_wheel_drive_controller_fault_flange4_torque = 12, /* flange4_torque: not finite or not plausible */
    all_wheel_drive_controller_fault_M4_speed = 13, /* M4_speed: not finite or not plausible */
    all_wheel_drive_controller_fault_flange5_torque = 14, /* flange5_torque: not finite or not plausible */
    all_wheel_drive_controller_fault_M5_speed = 15, /* M5_speed: not finite or not plausible */
    all_wheel_drive_controller_fault_M1_speed_overspeed = 4006, /* M1_speed: overspeed */
    all_wheel_drive_controller_fault_M2_speed_overspeed = 4009, /* M2_speed: overspeed */
    all_wheel_drive_controller_fault_M3_speed_overspeed = 4011, /* M3_speed: overspeed */
    all_wheel_drive_controller_fault_M4_speed_overspeed = 4013, /* M4_speed: overspeed */
    all_wheel_drive_controller_fault_M5_speed_overspeed = 4015, /* M5_speed: overspeed */
    all_wheel_drive_controller_fault_M1_speed_frozen = 3006, /* M1_speed: frozen while the torques accelerate the machine */
    all_wheel_drive_controller_fault_M1_speed_disagreement = 5006, /* M1_speed: disagrees with the integrated torque */
    all_wheel_drive_controller_fault_flange1_torque_frozen = 3007, /* flange1_torque: frozen while the torque of the machine changes */
    all_wheel_drive_controller_fault_M2_speed_frozen = 3009, /* M2_speed: frozen while the torques accelerate the machine */
    all_wheel_drive_controller_fault_M2_speed_disagreement = 5009, /* M2_speed: disagrees with the integrated torque */
    all_wheel_drive_controller_fault_flange2_torque_frozen = 3008, /* flange2_torque: frozen while the torque of the machine changes */
    all_wheel_drive_controller_fault_M3_speed_frozen = 3011, /* M3_speed: frozen while the torques accelerate the machine */
    all_wheel_drive_controller_fault_M3_speed_disagreement = 5011, /* M3_speed: disagrees with the integrated torque */
    all_wheel_drive_controller_fault_flange3_torque_frozen = 3010, /* flange3_torque: frozen while the torque of the machine changes */
    all_wheel_drive_controller_fault_M4_speed_frozen = 3013, /* M4_speed: frozen while the torques accelerate the machine */
    all_wheel_drive_controller_fault_M4_speed_disagreement = 5013, /* M4_speed: disagrees with the integrated torque */
    all_wheel_drive_controller_fault_flange4_torque_frozen = 3012, /* flange4_torque: frozen while the torque of the machine changes */
    all_wheel_drive_controller_fault_M5_speed_frozen = 3015, /* M5_speed: frozen while the torques accelerate the machine */
    all_wheel_drive_controller_fault_M5_speed_disagreement = 5015, /* M5_speed: disagrees with the integrated torque */
    all_wheel_drive_controller_fault_flange5_torque_frozen = 3014, /* flange5_torque: frozen while the torque of the machine changes */
    all_wheel_drive_controller_fault_flange1_torque_oscillation = 6007, /* flange1_torque: oscillates beyond its limit */
    all_wheel_drive_controller_fault_flange2_torque_oscillation = 6008, /* flange2_torque: oscillates beyond its limit */
    all_wheel_drive_controller_fault_flange3_torque_oscillation = 6010, /* flange3_torque: oscillates beyond its limit */
    all_wheel_drive_controller_fault_flange4_torque_oscillation = 6012, /* flange4_torque: oscillates beyond its limit */
    all_wheel_drive_controller_fault_flange5_torque_oscillation = 6014, /* flange5_torque: oscillates beyond its limit */
    all_wheel_drive_controller_fault_M1_torque_ref_oscillation = 8001, /* M1_torque_ref: the command oscillates */
    all_wheel_drive_controller_fault_M2_torque_ref_oscillation = 8002, /* M2_torque_ref: the command oscillates */
    all_wheel_drive_controller_fault_M3_torque_ref_oscillation = 8003, /* M3_torque_ref: the command oscillates */
    all_wheel_drive_controller_fault_M4_torque_ref_oscillation = 8004, /* M4_torque_ref: the command oscillates */
    all_wheel_drive_controller_fault_M5_torque_ref_oscillation = 8005, /* M5_torque_ref: the command oscillates */
    all_wheel_drive_controller_fault_M1_torque_ref = 7001, /* M1_torque_ref: the command is not finite, or beyond the torque of the machine */
    all_wheel_drive_controller_fault_M2_torque_ref = 7002, /* M2_torque_ref: the command is not finite, or beyond the torque of the machine */
    all_wheel_drive_controller_fault_M3_torque_ref = 7003, /* M3_torque_ref: the command is not finite, or beyond the torque of the machine */
    all_wheel_drive_controller_fault_M4_torque_ref = 7004, /* M4_torque_ref: the command is not finite, or beyond the torque of the machine */
    all_wheel_drive_controller_fault_M5_torque_ref = 7005, /* M5_torque_ref: the command is not finite, or beyond the torque of the machine */
    all_wheel_drive_controller_bad_sample_time = 2000, /* outside its range */
    all_wheel_drive_controller_bad_fault_ramp = 2001, /* outside its range */
    all_wheel_drive_controller_bad_hold_time = 2002, /* outside its range */
    all_wheel_drive_controller_bad_centre_input_torque_ref_plausible = 2003, /* outside its range */
    all_wheel_drive_controller_bad_M2_speed_ref_plausible = 2004, /* outside its range */
    all_wheel_drive_controller_bad_M3_speed_ref_plausible = 2005, /* outside its range */
    all_wheel_drive_controller_bad_M4_speed_ref_plausible = 2006, /* outside its range */
    all_wheel_drive_controller_bad_M5_speed_ref_plausible = 2007, /* outside its range */
    all_wheel_drive_controller_bad_M1_speed_plausible = 2008, /* outside its range */
    all_wheel_drive_controller_bad_flange1_torque_plausible = 2009, /* outside its range */
    all_wheel_drive_controller_bad_flange2_torque_plausible = 2010, /* outside its range */
    all_wheel_drive_controller_bad_M2_speed_plausible = 2011, /* outside its range */
    all_wheel_drive_controller_bad_flange3_torque_plausible = 2012, /* outside its range */
    all_wheel_drive_controller_bad_M3_speed_plausible = 2013, /* outside its range */
    all_wheel_drive_controller_bad_flange4_torque_plausible = 2014, /* outside its range */
    all_wheel_drive_controller_bad_M4_speed_plausible = 2015, /* outside its range */
    all_wheel_drive_controller_bad_flange5_torque_plausible = 2016, /* outside its range */
    all_wheel_drive_controller_bad_M5_speed_plausible = 2017, /* outside its range */
    all_wheel_drive_controller_bad_M1_overspeed = 2018, /* outside its range */
    all_wheel_drive_controller_bad_M2_overspeed = 2019, /* outside its range */
    all_wheel_drive_controller_bad_M3_overspeed = 2020, /* outside its range */
    all_wheel_drive_controller_bad_M4_overspeed = 2021, /* outside its range */
    all_wheel_drive_controller_bad_M5_overspeed = 2022, /* outside its range */
    all_wheel_drive_controller_bad_load_compensation = 2023, /* outside its range */
    all_wheel_drive_controller_bad_acceleration_torque = 2024, /* outside its range */
    all_wheel_drive_controller_bad_switch_time = 2025, /* outside its range */
    all_wheel_drive_controller_bad_M1_damping = 2026, /* outside its range */
    all_wheel_drive_controller_bad_M1_speed_rated = 2027, /* outside its range */
    all_wheel_drive_controller_bad_M1_speed_max = 2028, /* outside its range */
    all_wheel_drive_controller_bad_M1_speed_taper = 2029, /* outside its range */
    all_wheel_drive_controller_bad_M1_torque_max = 2030, /* outside its range */
    all_wheel_drive_controller_bad_M2_speed_rated = 2031, /* outside its range */
    all_wheel_drive_controller_bad_M2_speed_max = 2032, /* outside its range */
    all_wheel_drive_controller_bad_M2_speed_taper = 2033, /* outside its range */
    all_wheel_drive_controller_bad_M2_torque_max = 2034, /* outside its range */
    all_wheel_drive_controller_bad_M3_speed_rated = 2035, /* outside its range */
    all_wheel_drive_controller_bad_M3_speed_max = 2036, /* outside its range */
    all_wheel_drive_controller_bad_M3_speed_taper = 2037, /* outside its range */
    all_wheel_drive_controller_bad_M3_torque_max = 2038, /* outside its range */
    all_wheel_drive_controller_bad_M4_speed_rated = 2039, /* outside its range */
    all_wheel_drive_controller_bad_M4_speed_max = 2040, /* outside its range */
    all_wheel_drive_controller_bad_M4_speed_taper = 2041, /* outside its range */
    all_wheel_drive_controller_bad_M4_torque_max = 2042, /* outside its range */
    all_wheel_drive_controller_bad_M5_speed_rated = 2043, /* outside its range */
    all_wheel_drive_controller_bad_M5_speed_max = 2044, /* outside its range */
    all_wheel_drive_controller_bad_M5_speed_taper = 2045, /* outside its range */
    all_wheel_drive_controller_bad_M5_torque_max = 2046, /* outside its range */
    all_wheel_drive_controller_bad_disagreement_leak = 2047, /* outside its range */
    all_wheel_drive_controller_bad_M1_inertia = 2048, /* outside its range */
    all_wheel_drive_controller_bad_M1_disagreement_limit = 2049, /* outside its range */
    all_wheel_drive_controller_bad_M1_frozen_limit = 2050, /* outside its range */
    all_wheel_drive_controller_bad_frozen_time = 2051, /* outside its range */
    all_wheel_drive_controller_bad_M2_inertia = 2052, /* outside its range */
    all_wheel_drive_controller_bad_M2_disagreement_limit = 2053, /* outside its range */
    all_wheel_drive_controller_bad_M2_frozen_limit = 2054, /* outside its range */
    all_wheel_drive_controller_bad_M3_inertia = 2055, /* outside its range */
    all_wheel_drive_controller_bad_M3_disagreement_limit = 2056, /* outside its range */
    all_wheel_drive_controller_bad_M3_frozen_limit = 2057, /* outside its range */
    all_wheel_drive_controller_bad_M4_inertia = 2058, /* outside its range */
    all_wheel_drive_controller_bad_M4_disagreement_limit = 2059, /* outside its range */
    all_wheel_drive_controller_bad_M4_frozen_limit = 2060, /* outside its range */
    all_wheel_drive_controller_bad_M5_inertia = 2061, /* outside its range */
    all_wheel_drive_controller_bad_M5_disagreement_limit = 2062, /* outside its range */
    all_wheel_drive_controller_bad_M5_frozen_limit = 2063, /* outside its range */
    all_wheel_drive_controller_bad_oscillation_frequency = 2064, /* outside its range */
    all_wheel_drive_controller_bad_flange1_torque_oscillation_limit = 2065, /* outside its range */
    all_wheel_drive_controller_bad_flange2_torque_oscillation_limit = 2066, /* outside its range */
    all_wheel_drive_controller_bad_flange3_torque_oscillation_limit = 2067, /* outside its range */
    all_wheel_drive_controller_bad_flange4_torque_oscillation_limit = 2068, /* outside its range */
    all_wheel_drive_controller_bad_flange5_torque_oscillation_limit = 2069, /* outside its range */
    all_wheel_drive_controller_bad_M1_torque_ref_oscillation_limit = 2070, /* outside its range */
    all_wheel_drive_controller_bad_M2_torque_ref_oscillation_limit = 2071, /* outside its range */
    all_wheel_drive_controller_bad_M3_torque_ref_oscillation_limit = 2072, /* outside its range */
    all_wheel_drive_controller_bad_M4_torque_ref_oscillation_limit = 2073, /* outside its range */
    all_wheel_drive_controller_bad_M5_torque_ref_oscillation_limit = 2074, /* outside its range */
    all_wheel_drive_controller_bad_M2_speed_ref_rate = 2075, /* outside its range */
    all_wheel_drive_controller_bad_M3_speed_ref_rate = 2076, /* outside its range */
    all_wheel_drive_controller_bad_M4_speed_ref_rate = 2077, /* outside its range */
    all_wheel_drive_controller_bad_M5_speed_ref_rate = 2078, /* outside its range */
    all_wheel_drive_controller_bad_centre_input_torque_ref_rate = 2079, /* outside its range */
    all_wheel_drive_controller_bad_M2_speed_gain = 2080, /* outside its range */
    all_wheel_drive_controller_bad_M2_speed_integral_gain = 2081, /* outside its range */
    all_wheel_drive_controller_bad_M3_speed_gain = 2082, /* outside its range */
    all_wheel_drive_controller_bad_M3_speed_integral_gain = 2083, /* outside its range */
    all_wheel_drive_controller_bad_M4_speed_gain = 2084, /* outside its range */
    all_wheel_drive_controller_bad_M4_speed_integral_gain = 2085, /* outside its range */
    all_wheel_drive_controller_bad_M5_speed_gain = 2086, /* outside its range */
    all_wheel_drive_controller_bad_M5_speed_integral_gain = 2087, /* outside its range */
    all_wheel_drive_controller_bad_M1_sensor_inertia_M2 = 2088, /* outside its range */
    all_wheel_drive_controller_bad_M1_sensor_inertia_M3 = 2089, /* outside its range */
    all_wheel_drive_controller_bad_M1_sensor_inertia_M4 = 2090, /* outside its range */
    all_wheel_drive_controller_bad_M1_sensor_inertia_M5 = 2091, /* outside its range */
    all_wheel_drive_controller_bad_M1_inertia_estimate = 2092, /* outside its range */
    all_wheel_drive_controller_bad_M1_feedforward = 2093, /* outside its range */
    all_wheel_drive_controller_bad_M1_torque_gain = 2094, /* outside its range */
    all_wheel_drive_controller_bad_M1_model_stiffness = 2095, /* outside its range */
    all_wheel_drive_controller_bad_M1_model_damping = 2096, /* outside its range */
    all_wheel_drive_controller_bad_M1_torque_model = 2097, /* outside its range */
    all_wheel_drive_controller_bad_centre_ratio = 2098, /* outside its range */
    all_wheel_drive_controller_bad_front_ratio = 2099, /* outside its range */
    all_wheel_drive_controller_bad_rear_ratio = 2100, /* outside its range */
    all_wheel_drive_controller_bad_M1_torque_integral_gain = 2101, /* outside its range */
    all_wheel_drive_controller_bad_M1_damping_reserve = 2102, /* outside its range */
    all_wheel_drive_controller_bad_M1_torque_integral_limit = 2103, /* outside its range */
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
