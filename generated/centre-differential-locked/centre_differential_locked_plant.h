/*
 * centre_differential_locked_plant.h: plant of the bed centre_differential_locked
 *
 * Emitted by ptgen 0.1.0 from centre-differential-locked.toml (SHA-256 853679bdb0920a51), template block.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef CENTRE_DIFFERENTIAL_LOCKED_PLANT_H
#define CENTRE_DIFFERENTIAL_LOCKED_PLANT_H

#include "centre_differential_locked_support.h"

/* Parameters, in SI units; call centre_differential_locked_plant_update after a change. */
typedef struct {
    centre_differential_locked_real M1_inertia; /* moment of inertia of the rotor (kg m^2) */
    centre_differential_locked_real M1_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    centre_differential_locked_real M1_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    centre_differential_locked_real M1_inverter_dead_time; /* dead time of the torque loop (s) */
    centre_differential_locked_real M1_inverter_time_constant; /* time constant of the torque loop (s) */
    centre_differential_locked_real flange1_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    centre_differential_locked_real flange1_stiffness; /* torsional stiffness c_f (N m/rad) */
    centre_differential_locked_real flange1_damping; /* internal damping d_f (N m s/rad) */
    centre_differential_locked_real cardan1_stiffness; /* torsional stiffness c_s (N m/rad) */
    centre_differential_locked_real cardan1_damping; /* internal damping d_s (N m s/rad) */
    centre_differential_locked_real diff_loss_coulomb; /* Coulomb friction torque T_0 (N m) */
    centre_differential_locked_real diff_loss_load; /* friction torque per unit of input torque, k_T */
    centre_differential_locked_real diff_loss_viscous; /* viscous friction, k_omega (N m s/rad) */
    centre_differential_locked_real diff_limited_slip_coulomb; /* Coulomb friction torque T_0 (N m) */
    centre_differential_locked_real diff_limited_slip_load; /* friction torque per unit of input torque, k_T */
    centre_differential_locked_real diff_limited_slip_viscous; /* viscous friction, k_omega (N m s/rad) */
    centre_differential_locked_real diff_ratio; /* ratio i_d of input speed to mean output speed */
    centre_differential_locked_real diff_inertia; /* moment of inertia I_di, referred to the input (kg m^2) */
    centre_differential_locked_real diff_inertia_pinion; /* moment of inertia I_3b of the relative motion of the outputs (kg m^2) */
    centre_differential_locked_real diff_pinion_ratio; /* radius of the pinion over radius of the output gears, r_3/r_1 */
    centre_differential_locked_real cardan2_stiffness; /* torsional stiffness c_s (N m/rad) */
    centre_differential_locked_real cardan2_damping; /* internal damping d_s (N m s/rad) */
    centre_differential_locked_real cardan2_backlash; /* full width theta_bl of the gap (rad) */
    centre_differential_locked_real flange2_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    centre_differential_locked_real flange2_stiffness; /* torsional stiffness c_f (N m/rad) */
    centre_differential_locked_real flange2_damping; /* internal damping d_f (N m s/rad) */
    centre_differential_locked_real M2_inertia; /* moment of inertia of the rotor (kg m^2) */
    centre_differential_locked_real M2_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    centre_differential_locked_real M2_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    centre_differential_locked_real M2_inverter_dead_time; /* dead time of the torque loop (s) */
    centre_differential_locked_real M2_inverter_time_constant; /* time constant of the torque loop (s) */
    centre_differential_locked_real cardan3_stiffness; /* torsional stiffness c_s (N m/rad) */
    centre_differential_locked_real cardan3_damping; /* internal damping d_s (N m s/rad) */
    centre_differential_locked_real cardan3_backlash; /* full width theta_bl of the gap (rad) */
    centre_differential_locked_real flange3_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    centre_differential_locked_real flange3_stiffness; /* torsional stiffness c_f (N m/rad) */
    centre_differential_locked_real flange3_damping; /* internal damping d_f (N m s/rad) */
    centre_differential_locked_real M3_inertia; /* moment of inertia of the rotor (kg m^2) */
    centre_differential_locked_real M3_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    centre_differential_locked_real M3_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    centre_differential_locked_real M3_inverter_dead_time; /* dead time of the torque loop (s) */
    centre_differential_locked_real M3_inverter_time_constant; /* time constant of the torque loop (s) */
    centre_differential_locked_real standstill_speed; /* friction velocities below this are none (rad/s) */
    centre_differential_locked_real sample_time; /* step of the plant (s) */
} centre_differential_locked_plant_params;

/* Inputs of a step. */
typedef struct {
    centre_differential_locked_real M1_torque_ref; /* air-gap torque reference of M1 (N m) */
    centre_differential_locked_real M2_torque_ref; /* air-gap torque reference of M2 (N m) */
    centre_differential_locked_real M3_torque_ref; /* air-gap torque reference of M3 (N m) */
} centre_differential_locked_plant_inputs;

/* Outputs of a step; torques are positive when they drive the right-hand neighbour. */
typedef struct {
    centre_differential_locked_real M1_speed; /* measured or observed, positive to the right (rad/s) */
    centre_differential_locked_real flange1_torque; /* measured or observed, positive to the right (N m) */
    centre_differential_locked_real flange2_torque; /* measured or observed, positive to the right (N m) */
    centre_differential_locked_real M2_speed; /* measured or observed, positive to the right (rad/s) */
    centre_differential_locked_real flange3_torque; /* measured or observed, positive to the right (N m) */
    centre_differential_locked_real M3_speed; /* measured or observed, positive to the right (rad/s) */
    centre_differential_locked_real diff_input_torque; /* measured or observed, positive to the right (N m) */
    centre_differential_locked_real M1_torque; /* air-gap torque of M1 (N m) */
    centre_differential_locked_real M2_torque; /* air-gap torque of M2 (N m) */
    centre_differential_locked_real M3_torque; /* air-gap torque of M3 (N m) */
    centre_differential_locked_real diff_loss_torque; /* torque of the friction element diff.loss (N m) */
    centre_differential_locked_real diff_loss_speed; /* velocity of the friction element diff.loss (rad/s) */
    centre_differential_locked_real diff_limited_slip_torque; /* torque of the friction element diff.limited_slip (N m) */
    centre_differential_locked_real diff_limited_slip_speed; /* velocity of the friction element diff.limited_slip (rad/s) */
} centre_differential_locked_plant_outputs;

/* States first, then what follows from the parameters. Matrices are stored by columns. */
typedef struct {
    centre_differential_locked_real x[24]; /* velocities, twists, air-gap torques; then the commands that act late and early: */
    /*   [0] velocity of diff.input (rad/s) */
    /*   [1] velocity of diff.pinion (rad/s) */
    /*   [2] velocity of M1.shaft (rad/s) */
    /*   [3] velocity of M2.shaft (rad/s) */
    /*   [4] velocity of M3.shaft (rad/s) */
    /*   [5] velocity of flange1.uut (rad/s) */
    /*   [6] velocity of flange2.uut (rad/s) */
    /*   [7] velocity of flange3.uut (rad/s) */
    /*   [8] twist of flange1 (rad) */
    /*   [9] twist of cardan1 (rad) */
    /*   [10] twist of cardan2 (rad) */
    /*   [11] twist of flange2 (rad) */
    /*   [12] twist of cardan3 (rad) */
    /*   [13] twist of flange3 (rad) */
    /*   [14] air-gap torque of M1 (N m) */
    /*   [15] air-gap torque of M2 (N m) */
    /*   [16] air-gap torque of M3 (N m) */
    /*   [17] late command to M1 (N m) */
    /*   [18] late command to M2 (N m) */
    /*   [19] late command to M3 (N m) */
    /*   [20] early command to M1 (N m) */
    /*   [21] early command to M2 (N m) */
    /*   [22] early command to M3 (N m) */
    centre_differential_locked_real M1_delay[16]; /* commands to M1 of past steps (N m) */
    centre_differential_locked_real M2_delay[16]; /* commands to M2 of past steps (N m) */
    centre_differential_locked_real M3_delay[16]; /* commands to M3 of past steps (N m) */
    centre_differential_locked_real friction_torque[4]; /* friction torques at the end of the step (N m): */
    /*   [0] diff.loss */
    /*   [1] diff.limited_slip */
    centre_differential_locked_real friction_rest[4]; /* capacities at rest in the last step (N m): */
    /*   [0] diff.loss */
    /*   [1] diff.limited_slip */
    centre_differential_locked_real friction_status; /* 0, or what was wrong with the friction of the last step */
    centre_differential_locked_real contact_torque[4]; /* torques of shafts with backlash at the end of the step (N m): */
    /*   [0] cardan2 */
    /*   [1] cardan3 */
    centre_differential_locked_real transition[23][20]; /* x at the end of the step without friction torques */
    centre_differential_locked_real M1_dead_steps; /* whole steps of dead time */
    centre_differential_locked_real M2_dead_steps; /* whole steps of dead time */
    centre_differential_locked_real M3_dead_steps; /* whole steps of dead time */
    centre_differential_locked_real L[6][4]; /* twists of shafts with backlash per twist */
    centre_differential_locked_real gamma[4][20]; /* x at the end of the step per friction and contact torque */
    centre_differential_locked_real K[2][4]; /* friction velocities lost per mean friction torque (rad/(N m s)) */
    centre_differential_locked_real kappa[2][4]; /* twist lost over the step per torque (rad/(N m)) */
    centre_differential_locked_real half_gap[4]; /* half of the gaps (rad) */
    centre_differential_locked_real contact_stiffness[4]; /* stiffness beyond the gaps (N m/rad) */
    centre_differential_locked_real contact_damping[4]; /* damping over the step (N m/rad) */
} centre_differential_locked_plant_state;

typedef enum {
    centre_differential_locked_plant_ok = 0,
    centre_differential_locked_plant_mass_matrix = 1001,
    centre_differential_locked_plant_exponential_range = 1002,
    centre_differential_locked_plant_friction_matrix = 1003,
    centre_differential_locked_plant_bad_input_M1_torque_ref = 1100, /* is not finite */
    centre_differential_locked_plant_bad_input_M2_torque_ref = 1101, /* is not finite */
    centre_differential_locked_plant_bad_input_M3_torque_ref = 1102, /* is not finite */
    centre_differential_locked_plant_friction_unsolved = 1501, /* the friction torques are not exact */
    centre_differential_locked_plant_bad_capacity_diff_loss = 1502, /* the capacity of diff.loss is no number from 0 up; it was taken as 0 */
    centre_differential_locked_plant_bad_capacity_diff_limited_slip = 1503, /* the capacity of diff.limited_slip is no number from 0 up; it was taken as 0 */
    centre_differential_locked_plant_bad_M1_inertia = 2000, /* outside its range */
    centre_differential_locked_plant_bad_M1_torque_max = 2001, /* outside its range */
    centre_differential_locked_plant_bad_M1_speed_rated = 2002, /* outside its range */
    centre_differential_locked_plant_bad_M1_inverter_dead_time = 2003, /* outside its range */
    centre_differential_locked_plant_bad_M1_inverter_time_constant = 2004, /* outside its range */
    centre_differential_locked_plant_bad_flange1_inertia = 2005, /* outside its range */
    centre_differential_locked_plant_bad_flange1_stiffness = 2006, /* outside its range */
    centre_differential_locked_plant_bad_flange1_damping = 2007, /* outside its range */
    centre_differential_locked_plant_bad_cardan1_stiffness = 2008, /* outside its range */
    centre_differential_locked_plant_bad_cardan1_damping = 2009, /* outside its range */
    centre_differential_locked_plant_bad_diff_loss_coulomb = 2010, /* outside its range */
    centre_differential_locked_plant_bad_diff_loss_load = 2011, /* outside its range */
    centre_differential_locked_plant_bad_diff_loss_viscous = 2012, /* outside its range */
    centre_differential_locked_plant_bad_diff_limited_slip_coulomb = 2013, /* outside its range */
    centre_differential_locked_plant_bad_diff_limited_slip_load = 2014, /* outside its range */
    centre_differential_locked_plant_bad_diff_limited_slip_viscous = 2015, /* outside its range */
    centre_differential_locked_plant_bad_diff_ratio = 2016, /* outside its range */
    centre_differential_locked_plant_bad_diff_inertia = 2017, /* outside its range */
    centre_differential_locked_plant_bad_diff_inertia_pinion = 2018, /* outside its range */
    centre_differential_locked_plant_bad_diff_pinion_ratio = 2019, /* outside its range */
    centre_differential_locked_plant_bad_cardan2_stiffness = 2020, /* outside its range */
    centre_differential_locked_plant_bad_cardan2_damping = 2021, /* outside its range */
    centre_differential_locked_plant_bad_cardan2_backlash = 2022, /* outside its range */
    centre_differential_locked_plant_bad_flange2_inertia = 2023, /* outside its range */
    centre_differential_locked_plant_bad_flange2_stiffness = 2024, /* outside its range */
    centre_differential_locked_plant_bad_flange2_damping = 2025, /* outside its range */
    centre_differential_locked_plant_bad_M2_inertia = 2026, /* outside its range */
    centre_differential_locked_plant_bad_M2_torque_max = 2027, /* outside its range */
    centre_differential_locked_plant_bad_M2_speed_rated = 2028, /* outside its range */
    centre_differential_locked_plant_bad_M2_inverter_dead_time = 2029, /* outside its range */
    centre_differential_locked_plant_bad_M2_inverter_time_constant = 2030, /* outside its range */
    centre_differential_locked_plant_bad_cardan3_stiffness = 2031, /* outside its range */
    centre_differential_locked_plant_bad_cardan3_damping = 2032, /* outside its range */
    centre_differential_locked_plant_bad_cardan3_backlash = 2033, /* outside its range */
    centre_differential_locked_plant_bad_flange3_inertia = 2034, /* outside its range */
    centre_differential_locked_plant_bad_flange3_stiffness = 2035, /* outside its range */
    centre_differential_locked_plant_bad_flange3_damping = 2036, /* outside its range */
    centre_differential_locked_plant_bad_M3_inertia = 2037, /* outside its range */
    centre_differential_locked_plant_bad_M3_torque_max = 2038, /* outside its range */
    centre_differential_locked_plant_bad_M3_speed_rated = 2039, /* outside its range */
    centre_differential_locked_plant_bad_M3_inverter_dead_time = 2040, /* outside its range */
    centre_differential_locked_plant_bad_M3_inverter_time_constant = 2041, /* outside its range */
    centre_differential_locked_plant_bad_standstill_speed = 2042, /* outside its range */
    centre_differential_locked_plant_bad_sample_time = 2043, /* outside its range */
} centre_differential_locked_plant_status;

extern const centre_differential_locked_plant_params centre_differential_locked_plant_defaults;

/* Name of a status, for logs. */
const char *centre_differential_locked_plant_status_text(centre_differential_locked_plant_status status);

/* Sets the initial state and prepares everything that follows from the parameters. */
centre_differential_locked_plant_status centre_differential_locked_plant_init(centre_differential_locked_plant_state *state, const centre_differential_locked_plant_params *params);

/* Checks the parameters and prepares what follows from them; the rest of the state stays. */
centre_differential_locked_plant_status centre_differential_locked_plant_update(centre_differential_locked_plant_state *state, const centre_differential_locked_plant_params *params);

/* One step. After a bad input the state is as it was, and the outputs are those of that state. */
centre_differential_locked_plant_status centre_differential_locked_plant_step(centre_differential_locked_plant_state *state, const centre_differential_locked_plant_params *params,
    const centre_differential_locked_plant_inputs *inputs, centre_differential_locked_plant_outputs *outputs);

/* Outputs of the present state, as at the end of a step. */
void centre_differential_locked_plant_measure(const centre_differential_locked_plant_state *state, const centre_differential_locked_plant_params *params,
    centre_differential_locked_plant_outputs *outputs);

#endif
