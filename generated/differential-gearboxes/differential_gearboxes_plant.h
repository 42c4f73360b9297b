/*
 * differential_gearboxes_plant.h: plant of the bed differential_gearboxes
 *
 * Emitted by ptgen 0.1.0 from differential-gearboxes.toml (SHA-256 08abf4d695c2194f), template block.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef DIFFERENTIAL_GEARBOXES_PLANT_H
#define DIFFERENTIAL_GEARBOXES_PLANT_H

#include "differential_gearboxes_support.h"

/* Parameters, in SI units; call differential_gearboxes_plant_update after a change. */
typedef struct {
    differential_gearboxes_real M1_inertia; /* moment of inertia of the rotor (kg m^2) */
    differential_gearboxes_real M1_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    differential_gearboxes_real M1_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    differential_gearboxes_real M1_inverter_dead_time; /* dead time of the torque loop (s) */
    differential_gearboxes_real M1_inverter_time_constant; /* time constant of the torque loop (s) */
    differential_gearboxes_real flange1_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    differential_gearboxes_real flange1_stiffness; /* torsional stiffness c_f (N m/rad) */
    differential_gearboxes_real flange1_damping; /* internal damping d_f (N m s/rad) */
    differential_gearboxes_real shaft1_stiffness; /* torsional stiffness c_s (N m/rad) */
    differential_gearboxes_real shaft1_damping; /* internal damping d_s (N m s/rad) */
    differential_gearboxes_real gearbox1_ratio; /* ratio of input speed to output speed; negative when the sense reverses */
    differential_gearboxes_real gearbox1_inertia; /* moment of inertia, referred to the side named in inertia_side (kg m^2) */
    differential_gearboxes_real cardan1_stiffness; /* torsional stiffness c_s (N m/rad) */
    differential_gearboxes_real cardan1_damping; /* internal damping d_s (N m s/rad) */
    differential_gearboxes_real diff_loss_coulomb; /* Coulomb friction torque T_0 (N m) */
    differential_gearboxes_real diff_loss_load; /* friction torque per unit of input torque, k_T */
    differential_gearboxes_real diff_loss_viscous; /* viscous friction, k_omega (N m s/rad) */
    differential_gearboxes_real diff_limited_slip_coulomb; /* Coulomb friction torque T_0 (N m) */
    differential_gearboxes_real diff_limited_slip_load; /* friction torque per unit of input torque, k_T */
    differential_gearboxes_real diff_limited_slip_viscous; /* viscous friction, k_omega (N m s/rad) */
    differential_gearboxes_real diff_ratio; /* ratio i_d of input speed to mean output speed */
    differential_gearboxes_real diff_inertia; /* moment of inertia I_di, referred to the input (kg m^2) */
    differential_gearboxes_real diff_inertia_pinion; /* moment of inertia I_3b of the relative motion of the outputs (kg m^2) */
    differential_gearboxes_real diff_pinion_ratio; /* radius of the pinion over radius of the output gears, r_3/r_1 */
    differential_gearboxes_real cardan2_stiffness; /* torsional stiffness c_s (N m/rad) */
    differential_gearboxes_real cardan2_damping; /* internal damping d_s (N m s/rad) */
    differential_gearboxes_real gearbox2_ratio; /* ratio of input speed to output speed; negative when the sense reverses */
    differential_gearboxes_real gearbox2_inertia; /* moment of inertia, referred to the side named in inertia_side (kg m^2) */
    differential_gearboxes_real shaft2_stiffness; /* torsional stiffness c_s (N m/rad) */
    differential_gearboxes_real shaft2_damping; /* internal damping d_s (N m s/rad) */
    differential_gearboxes_real flange2_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    differential_gearboxes_real flange2_stiffness; /* torsional stiffness c_f (N m/rad) */
    differential_gearboxes_real flange2_damping; /* internal damping d_f (N m s/rad) */
    differential_gearboxes_real M2_inertia; /* moment of inertia of the rotor (kg m^2) */
    differential_gearboxes_real M2_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    differential_gearboxes_real M2_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    differential_gearboxes_real M2_inverter_dead_time; /* dead time of the torque loop (s) */
    differential_gearboxes_real M2_inverter_time_constant; /* time constant of the torque loop (s) */
    differential_gearboxes_real cardan3_stiffness; /* torsional stiffness c_s (N m/rad) */
    differential_gearboxes_real cardan3_damping; /* internal damping d_s (N m s/rad) */
    differential_gearboxes_real gearbox3_ratio; /* ratio of input speed to output speed; negative when the sense reverses */
    differential_gearboxes_real gearbox3_inertia; /* moment of inertia, referred to the side named in inertia_side (kg m^2) */
    differential_gearboxes_real shaft3_stiffness; /* torsional stiffness c_s (N m/rad) */
    differential_gearboxes_real shaft3_damping; /* internal damping d_s (N m s/rad) */
    differential_gearboxes_real flange3_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    differential_gearboxes_real flange3_stiffness; /* torsional stiffness c_f (N m/rad) */
    differential_gearboxes_real flange3_damping; /* internal damping d_f (N m s/rad) */
    differential_gearboxes_real M3_inertia; /* moment of inertia of the rotor (kg m^2) */
    differential_gearboxes_real M3_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    differential_gearboxes_real M3_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    differential_gearboxes_real M3_inverter_dead_time; /* dead time of the torque loop (s) */
    differential_gearboxes_real M3_inverter_time_constant; /* time constant of the torque loop (s) */
    differential_gearboxes_real standstill_speed; /* friction velocities below this are none (rad/s) */
    differential_gearboxes_real sample_time; /* step of the plant (s) */
} differential_gearboxes_plant_params;

/* Inputs of a step. */
typedef struct {
    differential_gearboxes_real M1_torque_ref; /* air-gap torque reference of M1 (N m) */
    differential_gearboxes_real M2_torque_ref; /* air-gap torque reference of M2 (N m) */
    differential_gearboxes_real M3_torque_ref; /* air-gap torque reference of M3 (N m) */
} differential_gearboxes_plant_inputs;

/* Outputs of a step; torques are positive when they drive the right-hand neighbour. */
typedef struct {
    differential_gearboxes_real M1_speed; /* measured or observed, positive to the right (rad/s) */
    differential_gearboxes_real flange1_torque; /* measured or observed, positive to the right (N m) */
    differential_gearboxes_real flange2_torque; /* measured or observed, positive to the right (N m) */
    differential_gearboxes_real M2_speed; /* measured or observed, positive to the right (rad/s) */
    differential_gearboxes_real flange3_torque; /* measured or observed, positive to the right (N m) */
    differential_gearboxes_real M3_speed; /* measured or observed, positive to the right (rad/s) */
    differential_gearboxes_real diff_outputs_torque; /* measured or observed, positive to the right (N m) */
    differential_gearboxes_real diff_input_torque; /* measured or observed, positive to the right (N m) */
    differential_gearboxes_real M1_torque; /* air-gap torque of M1 (N m) */
    differential_gearboxes_real M2_torque; /* air-gap torque of M2 (N m) */
    differential_gearboxes_real M3_torque; /* air-gap torque of M3 (N m) */
    differential_gearboxes_real diff_loss_torque; /* torque of the friction element diff.loss (N m) */
    differential_gearboxes_real diff_loss_speed; /* velocity of the friction element diff.loss (rad/s) */
    differential_gearboxes_real diff_limited_slip_torque; /* torque of the friction element diff.limited_slip (N m) */
    differential_gearboxes_real diff_limited_slip_speed; /* velocity of the friction element diff.limited_slip (rad/s) */
} differential_gearboxes_plant_outputs;

/* States first, then what follows from the parameters. Matrices are stored by columns. */
typedef struct {
    differential_gearboxes_real x[32]; /* velocities, twists, air-gap torques; then the commands that act late and early: */
    /*   [0] velocity of diff.input (rad/s) */
    /*   [1] velocity of diff.pinion (rad/s) */
    /*   [2] velocity of M1.shaft (rad/s) */
    /*   [3] velocity of M2.shaft (rad/s) */
    /*   [4] velocity of M3.shaft (rad/s) */
    /*   [5] velocity of flange1.uut (rad/s) */
    /*   [6] velocity of gearbox1.input (rad/s) */
    /*   [7] velocity of gearbox2.input (rad/s) */
    /*   [8] velocity of flange2.uut (rad/s) */
    /*   [9] velocity of gearbox3.input (rad/s) */
    /*   [10] velocity of flange3.uut (rad/s) */
    /*   [11] twist of flange1 (rad) */
    /*   [12] twist of shaft1 (rad) */
    /*   [13] twist of cardan1 (rad) */
    /*   [14] twist of cardan2 (rad) */
    /*   [15] twist of shaft2 (rad) */
    /*   [16] twist of flange2 (rad) */
    /*   [17] twist of cardan3 (rad) */
    /*   [18] twist of shaft3 (rad) */
    /*   [19] twist of flange3 (rad) */
    /*   [20] air-gap torque of M1 (N m) */
    /*   [21] air-gap torque of M2 (N m) */
    /*   [22] air-gap torque of M3 (N m) */
    /*   [23] late command to M1 (N m) */
    /*   [24] late command to M2 (N m) */
    /*   [25] late command to M3 (N m) */
    /*   [26] early command to M1 (N m) */
    /*   [27] early command to M2 (N m) */
    /*   [28] early command to M3 (N m) */
    differential_gearboxes_real M1_delay[16]; /* commands to M1 of past steps (N m) */
    differential_gearboxes_real M2_delay[16]; /* commands to M2 of past steps (N m) */
    differential_gearboxes_real M3_delay[16]; /* commands to M3 of past steps (N m) */
    differential_gearboxes_real friction_torque[4]; /* friction torques at the end of the step (N m): */
    /*   [0] diff.loss */
    /*   [1] diff.limited_slip */
    differential_gearboxes_real friction_rest[4]; /* capacities at rest in the last step (N m): */
    /*   [0] diff.loss */
    /*   [1] diff.limited_slip */
    differential_gearboxes_real friction_status; /* 0, or what was wrong with the friction of the last step */
    differential_gearboxes_real transition[29][24]; /* x at the end of the step without friction torques */
    differential_gearboxes_real M1_dead_steps; /* whole steps of dead time */
    differential_gearboxes_real M2_dead_steps; /* whole steps of dead time */
    differential_gearboxes_real M3_dead_steps; /* whole steps of dead time */
    differential_gearboxes_real gamma[2][24]; /* x at the end of the step per friction and contact torque */
    differential_gearboxes_real K[2][4]; /* friction velocities lost per mean friction torque (rad/(N m s)) */
} differential_gearboxes_plant_state;

typedef enum {
    differential_gearboxes_plant_ok = 0,
    differential_gearboxes_plant_mass_matrix = 1001,
    differential_gearboxes_plant_exponential_range = 1002,
    differential_gearboxes_plant_friction_matrix = 1003,
    differential_gearboxes_plant_bad_input_M1_torque_ref = 1100, /* is not finite */
    differential_gearboxes_plant_bad_input_M2_torque_ref = 1101, /* is not finite */
    differential_gearboxes_plant_bad_input_M3_torque_ref = 1102, /* is not finite */
    differential_gearboxes_plant_friction_unsolved = 1501, /* the friction torques are not exact */
    differential_gearboxes_plant_bad_capacity_diff_loss = 1502, /* the capacity of diff.loss is no number from 0 up; it was taken as 0 */
    differential_gearboxes_plant_bad_capacity_diff_limited_slip = 1503, /* the capacity of diff.limited_slip is no number from 0 up; it was taken as 0 */
    differential_gearboxes_plant_bad_M1_inertia = 2000, /* outside its range */
    differential_gearboxes_plant_bad_M1_torque_max = 2001, /* outside its range */
    differential_gearboxes_plant_bad_M1_speed_rated = 2002, /* outside its range */
    differential_gearboxes_plant_bad_M1_inverter_dead_time = 2003, /* outside its range */
    differential_gearboxes_plant_bad_M1_inverter_time_constant = 2004, /* outside its range */
    differential_gearboxes_plant_bad_flange1_inertia = 2005, /* outside its range */
    differential_gearboxes_plant_bad_flange1_stiffness = 2006, /* outside its range */
    differential_gearboxes_plant_bad_flange1_damping = 2007, /* outside its range */
    differential_gearboxes_plant_bad_shaft1_stiffness = 2008, /* outside its range */
    differential_gearboxes_plant_bad_shaft1_damping = 2009, /* outside its range */
    differential_gearboxes_plant_bad_gearbox1_ratio = 2010, /* outside its range */
    differential_gearboxes_plant_bad_gearbox1_inertia = 2011, /* outside its range */
    differential_gearboxes_plant_bad_cardan1_stiffness = 2012, /* outside its range */
    differential_gearboxes_plant_bad_cardan1_damping = 2013, /* outside its range */
    differential_gearboxes_plant_bad_diff_loss_coulomb = 2014, /* outside its range */
    differential_gearboxes_plant_bad_diff_loss_load = 2015, /* outside its range */
    differential_gearboxes_plant_bad_diff_loss_viscous = 2016, /* outside its range */
    differential_gearboxes_plant_bad_diff_limited_slip_coulomb = 2017, /* outside its range */
    differential_gearboxes_plant_bad_diff_limited_slip_load = 2018, /* outside its range */
    differential_gearboxes_plant_bad_diff_limited_slip_viscous = 2019, /* outside its range */
    differential_gearboxes_plant_bad_diff_ratio = 2020, /* outside its range */
    differential_gearboxes_plant_bad_diff_inertia = 2021, /* outside its range */
    differential_gearboxes_plant_bad_diff_inertia_pinion = 2022, /* outside its range */
    differential_gearboxes_plant_bad_diff_pinion_ratio = 2023, /* outside its range */
    differential_gearboxes_plant_bad_cardan2_stiffness = 2024, /* outside its range */
    differential_gearboxes_plant_bad_cardan2_damping = 2025, /* outside its range */
    differential_gearboxes_plant_bad_gearbox2_ratio = 2026, /* outside its range */
    differential_gearboxes_plant_bad_gearbox2_inertia = 2027, /* outside its range */
    differential_gearboxes_plant_bad_shaft2_stiffness = 2028, /* outside its range */
    differential_gearboxes_plant_bad_shaft2_damping = 2029, /* outside its range */
    differential_gearboxes_plant_bad_flange2_inertia = 2030, /* outside its range */
    differential_gearboxes_plant_bad_flange2_stiffness = 2031, /* outside its range */
    differential_gearboxes_plant_bad_flange2_damping = 2032, /* outside its range */
    differential_gearboxes_plant_bad_M2_inertia = 2033, /* outside its range */
    differential_gearboxes_plant_bad_M2_torque_max = 2034, /* outside its range */
    differential_gearboxes_plant_bad_M2_speed_rated = 2035, /* outside its range */
    differential_gearboxes_plant_bad_M2_inverter_dead_time = 2036, /* outside its range */
    differential_gearboxes_plant_bad_M2_inverter_time_constant = 2037, /* outside its range */
    differential_gearboxes_plant_bad_cardan3_stiffness = 2038, /* outside its range */
    differential_gearboxes_plant_bad_cardan3_damping = 2039, /* outside its range */
    differential_gearboxes_plant_bad_gearbox3_ratio = 2040, /* outside its range */
    differential_gearboxes_plant_bad_gearbox3_inertia = 2041, /* outside its range */
    differential_gearboxes_plant_bad_shaft3_stiffness = 2042, /* outside its range */
    differential_gearboxes_plant_bad_shaft3_damping = 2043, /* outside its range */
    differential_gearboxes_plant_bad_flange3_inertia = 2044, /* outside its range */
    differential_gearboxes_plant_bad_flange3_stiffness = 2045, /* outside its range */
    differential_gearboxes_plant_bad_flange3_damping = 2046, /* outside its range */
    differential_gearboxes_plant_bad_M3_inertia = 2047, /* outside its range */
    differential_gearboxes_plant_bad_M3_torque_max = 2048, /* outside its range */
    differential_gearboxes_plant_bad_M3_speed_rated = 2049, /* outside its range */
    differential_gearboxes_plant_bad_M3_inverter_dead_time = 2050, /* outside its range */
    differential_gearboxes_plant_bad_M3_inverter_time_constant = 2051, /* outside its range */
    differential_gearboxes_plant_bad_standstill_speed = 2052, /* outside its range */
    differential_gearboxes_plant_bad_sample_time = 2053, /* outside its range */
} differential_gearboxes_plant_status;

extern const differential_gearboxes_plant_params differential_gearboxes_plant_defaults;

/* Name of a status, for logs. */
const char *differential_gearboxes_plant_status_text(differential_gearboxes_plant_status status);

/* Sets the initial state and prepares everything that follows from the parameters. */
differential_gearboxes_plant_status differential_gearboxes_plant_init(differential_gearboxes_plant_state *state, const differential_gearboxes_plant_params *params);

/* Checks the parameters and prepares what follows from them; the rest of the state stays. */
differential_gearboxes_plant_status differential_gearboxes_plant_update(differential_gearboxes_plant_state *state, const differential_gearboxes_plant_params *params);

/* One step. After a bad input the state is as it was, and the outputs are those of that state. */
differential_gearboxes_plant_status differential_gearboxes_plant_step(differential_gearboxes_plant_state *state, const differential_gearboxes_plant_params *params,
    const differential_gearboxes_plant_inputs *inputs, differential_gearboxes_plant_outputs *outputs);

/* Outputs of the present state, as at the end of a step. */
void differential_gearboxes_plant_measure(const differential_gearboxes_plant_state *state, const differential_gearboxes_plant_params *params,
    differential_gearboxes_plant_outputs *outputs);

#endif
