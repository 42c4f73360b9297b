/*
 * all_wheel_drive_plant.h: plant of the bed all_wheel_drive
 *
 * Emitted by ptgen 0.1.0 from all-wheel-drive.toml (SHA-256 4a4f0cf573c3f3c3), template block.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef ALL_WHEEL_DRIVE_PLANT_H
#define ALL_WHEEL_DRIVE_PLANT_H

#include "all_wheel_drive_support.h"

/* Parameters, in SI units; call all_wheel_drive_plant_update after a change. */
typedef struct {
    all_wheel_drive_real M1_inertia; /* moment of inertia of the rotor (kg m^2) */
    all_wheel_drive_real M1_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    all_wheel_drive_real M1_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    all_wheel_drive_real M1_inverter_dead_time; /* dead time of the torque loop (s) */
    all_wheel_drive_real M1_inverter_time_constant; /* time constant of the torque loop (s) */
    all_wheel_drive_real flange1_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    all_wheel_drive_real flange1_stiffness; /* torsional stiffness c_f (N m/rad) */
    all_wheel_drive_real flange1_damping; /* internal damping d_f (N m s/rad) */
    all_wheel_drive_real cardan1_stiffness; /* torsional stiffness c_s (N m/rad) */
    all_wheel_drive_real cardan1_damping; /* internal damping d_s (N m s/rad) */
    all_wheel_drive_real centre_loss_coulomb; /* Coulomb friction torque T_0 (N m) */
    all_wheel_drive_real centre_loss_load; /* friction torque per unit of input torque, k_T */
    all_wheel_drive_real centre_loss_viscous; /* viscous friction, k_omega (N m s/rad) */
    all_wheel_drive_real centre_limited_slip_coulomb; /* Coulomb friction torque T_0 (N m) */
    all_wheel_drive_real centre_limited_slip_load; /* friction torque per unit of input torque, k_T */
    all_wheel_drive_real centre_limited_slip_viscous; /* viscous friction, k_omega (N m s/rad) */
    all_wheel_drive_real centre_ratio; /* ratio i_d of input speed to mean output speed */
    all_wheel_drive_real centre_inertia; /* moment of inertia I_di, referred to the input (kg m^2) */
    all_wheel_drive_real centre_inertia_pinion; /* moment of inertia I_3b of the relative motion of the outputs (kg m^2) */
    all_wheel_drive_real centre_pinion_ratio; /* radius of the pinion over radius of the output gears, r_3/r_1 */
    all_wheel_drive_real front_cardan_stiffness; /* torsional stiffness c_s (N m/rad) */
    all_wheel_drive_real front_cardan_damping; /* internal damping d_s (N m s/rad) */
    all_wheel_drive_real rear_cardan_stiffness; /* torsional stiffness c_s (N m/rad) */
    all_wheel_drive_real rear_cardan_damping; /* internal damping d_s (N m s/rad) */
    all_wheel_drive_real front_loss_coulomb; /* Coulomb friction torque T_0 (N m) */
    all_wheel_drive_real front_loss_load; /* friction torque per unit of input torque, k_T */
    all_wheel_drive_real front_loss_viscous; /* viscous friction, k_omega (N m s/rad) */
    all_wheel_drive_real front_limited_slip_coulomb; /* Coulomb friction torque T_0 (N m) */
    all_wheel_drive_real front_limited_slip_load; /* friction torque per unit of input torque, k_T */
    all_wheel_drive_real front_limited_slip_viscous; /* viscous friction, k_omega (N m s/rad) */
    all_wheel_drive_real front_ratio; /* ratio i_d of input speed to mean output speed */
    all_wheel_drive_real front_inertia; /* moment of inertia I_di, referred to the input (kg m^2) */
    all_wheel_drive_real front_inertia_pinion; /* moment of inertia I_3b of the relative motion of the outputs (kg m^2) */
    all_wheel_drive_real front_pinion_ratio; /* radius of the pinion over radius of the output gears, r_3/r_1 */
    all_wheel_drive_real rear_loss_coulomb; /* Coulomb friction torque T_0 (N m) */
    all_wheel_drive_real rear_loss_load; /* friction torque per unit of input torque, k_T */
    all_wheel_drive_real rear_loss_viscous; /* viscous friction, k_omega (N m s/rad) */
    all_wheel_drive_real rear_limited_slip_coulomb; /* Coulomb friction torque T_0 (N m) */
    all_wheel_drive_real rear_limited_slip_load; /* friction torque per unit of input torque, k_T */
    all_wheel_drive_real rear_limited_slip_viscous; /* viscous friction, k_omega (N m s/rad) */
    all_wheel_drive_real rear_ratio; /* ratio i_d of input speed to mean output speed */
    all_wheel_drive_real rear_inertia; /* moment of inertia I_di, referred to the input (kg m^2) */
    all_wheel_drive_real rear_inertia_pinion; /* moment of inertia I_3b of the relative motion of the outputs (kg m^2) */
    all_wheel_drive_real rear_pinion_ratio; /* radius of the pinion over radius of the output gears, r_3/r_1 */
    all_wheel_drive_real side2_stiffness; /* torsional stiffness c_s (N m/rad) */
    all_wheel_drive_real side2_damping; /* internal damping d_s (N m s/rad) */
    all_wheel_drive_real flange2_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    all_wheel_drive_real flange2_stiffness; /* torsional stiffness c_f (N m/rad) */
    all_wheel_drive_real flange2_damping; /* internal damping d_f (N m s/rad) */
    all_wheel_drive_real M2_inertia; /* moment of inertia of the rotor (kg m^2) */
    all_wheel_drive_real M2_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    all_wheel_drive_real M2_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    all_wheel_drive_real M2_inverter_dead_time; /* dead time of the torque loop (s) */
    all_wheel_drive_real M2_inverter_time_constant; /* time constant of the torque loop (s) */
    all_wheel_drive_real side3_stiffness; /* torsional stiffness c_s (N m/rad) */
    all_wheel_drive_real side3_damping; /* internal damping d_s (N m s/rad) */
    all_wheel_drive_real flange3_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    all_wheel_drive_real flange3_stiffness; /* torsional stiffness c_f (N m/rad) */
    all_wheel_drive_real flange3_damping; /* internal damping d_f (N m s/rad) */
    all_wheel_drive_real M3_inertia; /* moment of inertia of the rotor (kg m^2) */
    all_wheel_drive_real M3_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    all_wheel_drive_real M3_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    all_wheel_drive_real M3_inverter_dead_time; /* dead time of the torque loop (s) */
    all_wheel_drive_real M3_inverter_time_constant; /* time constant of the torque loop (s) */
    all_wheel_drive_real side4_stiffness; /* torsional stiffness c_s (N m/rad) */
    all_wheel_drive_real side4_damping; /* internal damping d_s (N m s/rad) */
    all_wheel_drive_real flange4_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    all_wheel_drive_real flange4_stiffness; /* torsional stiffness c_f (N m/rad) */
    all_wheel_drive_real flange4_damping; /* internal damping d_f (N m s/rad) */
    all_wheel_drive_real M4_inertia; /* moment of inertia of the rotor (kg m^2) */
    all_wheel_drive_real M4_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    all_wheel_drive_real M4_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    all_wheel_drive_real M4_inverter_dead_time; /* dead time of the torque loop (s) */
    all_wheel_drive_real M4_inverter_time_constant; /* time constant of the torque loop (s) */
    all_wheel_drive_real side5_stiffness; /* torsional stiffness c_s (N m/rad) */
    all_wheel_drive_real side5_damping; /* internal damping d_s (N m s/rad) */
    all_wheel_drive_real flange5_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    all_wheel_drive_real flange5_stiffness; /* torsional stiffness c_f (N m/rad) */
    all_wheel_drive_real flange5_damping; /* internal damping d_f (N m s/rad) */
    all_wheel_drive_real M5_inertia; /* moment of inertia of the rotor (kg m^2) */
    all_wheel_drive_real M5_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    all_wheel_drive_real M5_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    all_wheel_drive_real M5_inverter_dead_time; /* dead time of the torque loop (s) */
    all_wheel_drive_real M5_inverter_time_constant; /* time constant of the torque loop (s) */
    all_wheel_drive_real standstill_speed; /* friction velocities below this are none (rad/s) */
    all_wheel_drive_real sample_time; /* step of the plant (s) */
} all_wheel_drive_plant_params;

/* Inputs of a step. */
typedef struct {
    all_wheel_drive_real M1_torque_ref; /* air-gap torque reference of M1 (N m) */
    all_wheel_drive_real M2_torque_ref; /* air-gap torque reference of M2 (N m) */
    all_wheel_drive_real M3_torque_ref; /* air-gap torque reference of M3 (N m) */
    all_wheel_drive_real M4_torque_ref; /* air-gap torque reference of M4 (N m) */
    all_wheel_drive_real M5_torque_ref; /* air-gap torque reference of M5 (N m) */
} all_wheel_drive_plant_inputs;

/* Outputs of a step; torques are positive when they drive the right-hand neighbour. */
typedef struct {
    all_wheel_drive_real M1_speed; /* measured or observed, positive to the right (rad/s) */
    all_wheel_drive_real flange1_torque; /* measured or observed, positive to the right (N m) */
    all_wheel_drive_real flange2_torque; /* measured or observed, positive to the right (N m) */
    all_wheel_drive_real M2_speed; /* measured or observed, positive to the right (rad/s) */
    all_wheel_drive_real flange3_torque; /* measured or observed, positive to the right (N m) */
    all_wheel_drive_real M3_speed; /* measured or observed, positive to the right (rad/s) */
    all_wheel_drive_real flange4_torque; /* measured or observed, positive to the right (N m) */
    all_wheel_drive_real M4_speed; /* measured or observed, positive to the right (rad/s) */
    all_wheel_drive_real flange5_torque; /* measured or observed, positive to the right (N m) */
    all_wheel_drive_real M5_speed; /* measured or observed, positive to the right (rad/s) */
    all_wheel_drive_real centre_input_torque; /* measured or observed, positive to the right (N m) */
    all_wheel_drive_real front_input_torque; /* measured or observed, positive to the right (N m) */
    all_wheel_drive_real rear_input_torque; /* measured or observed, positive to the right (N m) */
    all_wheel_drive_real M1_torque; /* air-gap torque of M1 (N m) */
    all_wheel_drive_real M2_torque; /* air-gap torque of M2 (N m) */
    all_wheel_drive_real M3_torque; /* air-gap torque of M3 (N m) */
    all_wheel_drive_real M4_torque; /* air-gap torque of M4 (N m) */
    all_wheel_drive_real M5_torque; /* air-gap torque of M5 (N m) */
    all_wheel_drive_real centre_loss_torque; /* torque of the friction element centre.loss (N m) */
    all_wheel_drive_real centre_loss_speed; /* velocity of the friction element centre.loss (rad/s) */
    all_wheel_drive_real centre_limited_slip_torque; /* torque of the friction element centre.limited_slip (N m) */
    all_wheel_drive_real centre_limited_slip_speed; /* velocity of the friction element centre.limited_slip (rad/s) */
    all_wheel_drive_real front_loss_torque; /* torque of the friction element front.loss (N m) */
    all_wheel_drive_real front_loss_speed; /* velocity of the friction element front.loss (rad/s) */
    all_wheel_drive_real front_limited_slip_torque; /* torque of the friction element front.limited_slip (N m) */
    all_wheel_drive_real front_limited_slip_speed; /* velocity of the friction element front.limited_slip (rad/s) */
    all_wheel_drive_real rear_loss_torque; /* torque of the friction element rear.loss (N m) */
    all_wheel_drive_real rear_loss_speed; /* velocity of the friction element rear.loss (rad/s) */
    all_wheel_drive_real rear_limited_slip_torque; /* torque of the friction element rear.limited_slip (N m) */
    all_wheel_drive_real rear_limited_slip_speed; /* velocity of the friction element rear.limited_slip (rad/s) */
} all_wheel_drive_plant_outputs;

/* States first, then what follows from the parameters. Matrices are stored by columns. */
typedef struct {
    all_wheel_drive_real x[44]; /* velocities, twists, air-gap torques; then the commands that act late and early: */
    /*   [0] velocity of centre.input (rad/s) */
    /*   [1] velocity of centre.pinion (rad/s) */
    /*   [2] velocity of front.input (rad/s) */
    /*   [3] velocity of front.pinion (rad/s) */
    /*   [4] velocity of rear.input (rad/s) */
    /*   [5] velocity of rear.pinion (rad/s) */
    /*   [6] velocity of M1.shaft (rad/s) */
    /*   [7] velocity of M2.shaft (rad/s) */
    /*   [8] velocity of M3.shaft (rad/s) */
    /*   [9] velocity of M4.shaft (rad/s) */
    /*   [10] velocity of M5.shaft (rad/s) */
    /*   [11] velocity of flange1.uut (rad/s) */
    /*   [12] velocity of flange2.uut (rad/s) */
    /*   [13] velocity of flange3.uut (rad/s) */
    /*   [14] velocity of flange4.uut (rad/s) */
    /*   [15] velocity of flange5.uut (rad/s) */
    /*   [16] twist of flange1 (rad) */
    /*   [17] twist of cardan1 (rad) */
    /*   [18] twist of front_cardan (rad) */
    /*   [19] twist of rear_cardan (rad) */
    /*   [20] twist of side2 (rad) */
    /*   [21] twist of flange2 (rad) */
    /*   [22] twist of side3 (rad) */
    /*   [23] twist of flange3 (rad) */
    /*   [24] twist of side4 (rad) */
    /*   [25] twist of flange4 (rad) */
    /*   [26] twist of side5 (rad) */
    /*   [27] twist of flange5 (rad) */
    /*   [28] air-gap torque of M1 (N m) */
    /*   [29] air-gap torque of M2 (N m) */
    /*   [30] air-gap torque of M3 (N m) */
    /*   [31] air-gap torque of M4 (N m) */
    /*   [32] air-gap torque of M5 (N m) */
    /*   [33] late command to M1 (N m) */
    /*   [34] late command to M2 (N m) */
    /*   [35] late command to M3 (N m) */
    /*   [36] late command to M4 (N m) */
    /*   [37] late command to M5 (N m) */
    /*   [38] early command to M1 (N m) */
    /*   [39] early command to M2 (N m) */
    /*   [40] early command to M3 (N m) */
    /*   [41] early command to M4 (N m) */
    /*   [42] early command to M5 (N m) */
    all_wheel_drive_real M1_delay[16]; /* commands to M1 of past steps (N m) */
    all_wheel_drive_real M2_delay[16]; /* commands to M2 of past steps (N m) */
    all_wheel_drive_real M3_delay[16]; /* commands to M3 of past steps (N m) */
    all_wheel_drive_real M4_delay[16]; /* commands to M4 of past steps (N m) */
    all_wheel_drive_real M5_delay[16]; /* commands to M5 of past steps (N m) */
    all_wheel_drive_real friction_torque[8]; /* friction torques at the end of the step (N m): */
    /*   [0] centre.loss */
    /*   [1] centre.limited_slip */
    /*   [2] front.loss */
    /*   [3] front.limited_slip */
    /*   [4] rear.loss */
    /*   [5] rear.limited_slip */
    all_wheel_drive_real friction_rest[8]; /* capacities at rest in the last step (N m): */
    /*   [0] centre.loss */
    /*   [1] centre.limited_slip */
    /*   [2] front.loss */
    /*   [3] front.limited_slip */
    /*   [4] rear.loss */
    /*   [5] rear.limited_slip */
    all_wheel_drive_real friction_status; /* 0, or what was wrong with the friction of the last step */
    all_wheel_drive_real transition[43][36]; /* x at the end of the step without friction torques */
    all_wheel_drive_real M1_dead_steps; /* whole steps of dead time */
    all_wheel_drive_real M2_dead_steps; /* whole steps of dead time */
    all_wheel_drive_real M3_dead_steps; /* whole steps of dead time */
    all_wheel_drive_real M4_dead_steps; /* whole steps of dead time */
    all_wheel_drive_real M5_dead_steps; /* whole steps of dead time */
    all_wheel_drive_real gamma[6][36]; /* x at the end of the step per friction and contact torque */
    all_wheel_drive_real K[6][8]; /* friction velocities lost per mean friction torque (rad/(N m s)) */
} all_wheel_drive_plant_state;

typedef enum {
    all_wheel_drive_plant_ok = 0,
    all_wheel_drive_plant_mass_matrix = 1001,
    all_wheel_drive_plant_exponential_range = 1002,
    all_wheel_drive_plant_friction_matrix = 1003,
    all_wheel_drive_plant_bad_input_M1_torque_ref = 1100, /* is not finite */
    all_wheel_drive_plant_bad_input_M2_torque_ref = 1101, /* is not finite */
    all_wheel_drive_plant_bad_input_M3_torque_ref = 1102, /* is not finite */
    all_wheel_drive_plant_bad_input_M4_torque_ref = 1103, /* is not finite */
    all_wheel_drive_plant_bad_input_M5_torque_ref = 1104, /* is not finite */
    all_wheel_drive_plant_friction_unsolved = 1501, /* the friction torques are not exact */
    all_wheel_drive_plant_bad_capacity_centre_loss = 1502, /* the capacity of centre.loss is no number from 0 up; it was taken as 0 */
    all_wheel_drive_plant_bad_capacity_centre_limited_slip = 1503, /* the capacity of centre.limited_slip is no number from 0 up; it was taken as 0 */
    all_wheel_drive_plant_bad_capacity_front_loss = 1504, /* the capacity of front.loss is no number from 0 up; it was taken as 0 */
    all_wheel_drive_plant_bad_capacity_front_limited_slip = 1505, /* the capacity of front.limited_slip is no number from 0 up; it was taken as 0 */
    all_wheel_drive_plant_bad_capacity_rear_loss = 1506, /* the capacity of rear.loss is no number from 0 up; it was taken as 0 */
    all_wheel_drive_plant_bad_capacity_rear_limited_slip = 1507, /* the capacity of rear.limited_slip is no number from 0 up; it was taken as 0 */
    all_wheel_drive_plant_bad_M1_inertia = 2000, /* outside its range */
    all_wheel_drive_plant_bad_M1_torque_max = 2001, /* outside its range */
    all_wheel_drive_plant_bad_M1_speed_rated = 2002, /* outside its range */
    all_wheel_drive_plant_bad_M1_inverter_dead_time = 2003, /* outside its range */
    all_wheel_drive_plant_bad_M1_inverter_time_constant = 2004, /* outside its range */
    all_wheel_drive_plant_bad_flange1_inertia = 2005, /* outside its range */
    all_wheel_drive_plant_bad_flange1_stiffness = 2006, /* outside its range */
    all_wheel_drive_plant_bad_flange1_damping = 2007, /* outside its range */
    all_wheel_drive_plant_bad_cardan1_stiffness = 2008, /* outside its range */
    all_wheel_drive_plant_bad_cardan1_damping = 2009, /* outside its range */
    all_wheel_drive_plant_bad_centre_loss_coulomb = 2010, /* outside its range */
    all_wheel_drive_plant_bad_centre_loss_load = 2011, /* outside its range */
    all_wheel_drive_plant_bad_centre_loss_viscous = 2012, /* outside its range */
    all_wheel_drive_plant_bad_centre_limited_slip_coulomb = 2013, /* outside its range */
    all_wheel_drive_plant_bad_centre_limited_slip_load = 2014, /* outside its range */
    all_wheel_drive_plant_bad_centre_limited_slip_viscous = 2015, /* outside its range */
    all_wheel_drive_plant_bad_centre_ratio = 2016, /* outside its range */
    all_wheel_drive_plant_bad_centre_inertia = 2017, /* outside its range */
    all_wheel_drive_plant_bad_centre_inertia_pinion = 2018, /* outside its range */
    all_wheel_drive_plant_bad_centre_pinion_ratio = 2019, /* outside its range */
    all_wheel_drive_plant_bad_front_cardan_stiffness = 2020, /* outside its range */
    all_wheel_drive_plant_bad_front_cardan_damping = 2021, /* outside its range */
    all_wheel_drive_plant_bad_rear_cardan_stiffness = 2022, /* outside its range */
    all_wheel_drive_plant_bad_rear_cardan_damping = 2023, /* outside its range */
    all_wheel_drive_plant_bad_front_loss_coulomb = 2024, /* outside its range */
    all_wheel_drive_plant_bad_front_loss_load = 2025, /* outside its range */
    all_wheel_drive_plant_bad_front_loss_viscous = 2026, /* outside its range */
    all_wheel_drive_plant_bad_front_limited_slip_coulomb = 2027, /* outside its range */
    all_wheel_drive_plant_bad_front_limited_slip_load = 2028, /* outside its range */
    all_wheel_drive_plant_bad_front_limited_slip_viscous = 2029, /* outside its range */
    all_wheel_drive_plant_bad_front_ratio = 2030, /* outside its range */
    all_wheel_drive_plant_bad_front_inertia = 2031, /* outside its range */
    all_wheel_drive_plant_bad_front_inertia_pinion = 2032, /* outside its range */
    all_wheel_drive_plant_bad_front_pinion_ratio = 2033, /* outside its range */
    all_wheel_drive_plant_bad_rear_loss_coulomb = 2034, /* outside its range */
    all_wheel_drive_plant_bad_rear_loss_load = 2035, /* outside its range */
    all_wheel_drive_plant_bad_rear_loss_viscous = 2036, /* outside its range */
    all_wheel_drive_plant_bad_rear_limited_slip_coulomb = 2037, /* outside its range */
    all_wheel_drive_plant_bad_rear_limited_slip_load = 2038, /* outside its range */
    all_wheel_drive_plant_bad_rear_limited_slip_viscous = 2039, /* outside its range */
    all_wheel_drive_plant_bad_rear_ratio = 2040, /* outside its range */
    all_wheel_drive_plant_bad_rear_inertia = 2041, /* outside its range */
    all_wheel_drive_plant_bad_rear_inertia_pinion = 2042, /* outside its range */
    all_wheel_drive_plant_bad_rear_pinion_ratio = 2043, /* outside its range */
    all_wheel_drive_plant_bad_side2_stiffness = 2044, /* outside its range */
    all_wheel_drive_plant_bad_side2_damping = 2045, /* outside its range */
    all_wheel_drive_plant_bad_flange2_inertia = 2046, /* outside its range */
    all_wheel_drive_plant_bad_flange2_stiffness = 2047, /* outside its range */
    all_wheel_drive_plant_bad_flange2_damping = 2048, /* outside its range */
    all_wheel_drive_plant_bad_M2_inertia = 2049, /* outside its range */
    all_wheel_drive_plant_bad_M2_torque_max = 2050, /* outside its range */
    all_wheel_drive_plant_bad_M2_speed_rated = 2051, /* outside its range */
    all_wheel_drive_plant_bad_M2_inverter_dead_time = 2052, /* outside its range */
    all_wheel_drive_plant_bad_M2_inverter_time_constant = 2053, /* outside its range */
    all_wheel_drive_plant_bad_side3_stiffness = 2054, /* outside its range */
    all_wheel_drive_plant_bad_side3_damping = 2055, /* outside its range */
    all_wheel_drive_plant_bad_flange3_inertia = 2056, /* outside its range */
    all_wheel_drive_plant_bad_flange3_stiffness = 2057, /* outside its range */
    all_wheel_drive_plant_bad_flange3_damping = 2058, /* outside its range */
    all_wheel_drive_plant_bad_M3_inertia = 2059, /* outside its range */
    all_wheel_drive_plant_bad_M3_torque_max = 2060, /* outside its range */
    all_wheel_drive_plant_bad_M3_speed_rated = 2061, /* outside its range */
    all_wheel_drive_plant_bad_M3_inverter_dead_time = 2062, /* outside its range */
    all_wheel_drive_plant_bad_M3_inverter_time_constant = 2063, /* outside its range */
    all_wheel_drive_plant_bad_side4_stiffness = 2064, /* outside its range */
    all_wheel_drive_plant_bad_side4_damping = 2065, /* outside its range */
    all_wheel_drive_plant_bad_flange4_inertia = 2066, /* outside its range */
    all_wheel_drive_plant_bad_flange4_stiffness = 2067, /* outside its range */
    all_wheel_drive_plant_bad_flange4_damping = 2068, /* outside its range */
    all_wheel_drive_plant_bad_M4_inertia = 2069, /* outside its range */
    all_wheel_drive_plant_bad_M4_torque_max = 2070, /* outside its range */
    all_wheel_drive_plant_bad_M4_speed_rated = 2071, /* outside its range */
    all_wheel_drive_plant_bad_M4_inverter_dead_time = 2072, /* outside its range */
    all_wheel_drive_plant_bad_M4_inverter_time_constant = 2073, /* outside its range */
    all_wheel_drive_plant_bad_side5_stiffness = 2074, /* outside its range */
    all_wheel_drive_plant_bad_side5_damping = 2075, /* outside its range */
    all_wheel_drive_plant_bad_flange5_inertia = 2076, /* outside its range */
    all_wheel_drive_plant_bad_flange5_stiffness = 2077, /* outside its range */
    all_wheel_drive_plant_bad_flange5_damping = 2078, /* outside its range */
    all_wheel_drive_plant_bad_M5_inertia = 2079, /* outside its range */
    all_wheel_drive_plant_bad_M5_torque_max = 2080, /* outside its range */
    all_wheel_drive_plant_bad_M5_speed_rated = 2081, /* outside its range */
    all_wheel_drive_plant_bad_M5_inverter_dead_time = 2082, /* outside its range */
    all_wheel_drive_plant_bad_M5_inverter_time_constant = 2083, /* outside its range */
    all_wheel_drive_plant_bad_standstill_speed = 2084, /* outside its range */
    all_wheel_drive_plant_bad_sample_time = 2085, /* outside its range */
} all_wheel_drive_plant_status;

extern const all_wheel_drive_plant_params all_wheel_drive_plant_defaults;

/* Name of a status, for logs. */
const char *all_wheel_drive_plant_status_text(all_wheel_drive_plant_status status);

/* Sets the initial state and prepares everything that follows from the parameters. */
all_wheel_drive_plant_status all_wheel_drive_plant_init(all_wheel_drive_plant_state *state, const all_wheel_drive_plant_params *params);

/* Checks the parameters and prepares what follows from them; the rest of the state stays. */
all_wheel_drive_plant_status all_wheel_drive_plant_update(all_wheel_drive_plant_state *state, const all_wheel_drive_plant_params *params);

/* One step. After a bad input the state is as it was, and the outputs are those of that state. */
all_wheel_drive_plant_status all_wheel_drive_plant_step(all_wheel_drive_plant_state *state, const all_wheel_drive_plant_params *params,
    const all_wheel_drive_plant_inputs *inputs, all_wheel_drive_plant_outputs *outputs);

/* Outputs of the present state, as at the end of a step. */
void all_wheel_drive_plant_measure(const all_wheel_drive_plant_state *state, const all_wheel_drive_plant_params *params,
    all_wheel_drive_plant_outputs *outputs);

#endif
