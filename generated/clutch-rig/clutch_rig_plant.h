/*
 * clutch_rig_plant.h: plant of the bed clutch_rig
 *
 * Emitted by ptgen 0.1.0 from clutch-rig.toml (SHA-256 8a8f57b91ebde405), template block.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef CLUTCH_RIG_PLANT_H
#define CLUTCH_RIG_PLANT_H

#include "clutch_rig_support.h"

/* Parameters, in SI units; call clutch_rig_plant_update after a change. */
typedef struct {
    clutch_rig_real M1_inertia; /* moment of inertia of the rotor (kg m^2) */
    clutch_rig_real M1_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    clutch_rig_real M1_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    clutch_rig_real M1_inverter_dead_time; /* dead time of the torque loop (s) */
    clutch_rig_real M1_inverter_time_constant; /* time constant of the torque loop (s) */
    clutch_rig_real flange1_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    clutch_rig_real flange1_stiffness; /* torsional stiffness c_f (N m/rad) */
    clutch_rig_real flange1_damping; /* internal damping d_f (N m s/rad) */
    clutch_rig_real shaft1_stiffness; /* torsional stiffness c_s (N m/rad) */
    clutch_rig_real shaft1_damping; /* internal damping d_s (N m s/rad) */
    clutch_rig_real clutch1_viscous; /* viscous friction k_c,v (N m s/rad) */
    clutch_rig_real clutch1_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    clutch_rig_real clutch1_inertia_input; /* moment of inertia I_ci of the input disk (kg m^2) */
    clutch_rig_real clutch1_inertia_output; /* moment of inertia I_co of the output disk (kg m^2) */
    clutch_rig_real middle_inertia; /* moment of inertia (kg m^2) */
    clutch_rig_real clutch2_static; /* largest torque T_c,s that it holds at rest (N m) */
    clutch_rig_real clutch2_stribeck_speed; /* velocity omega_c,s over which the torque falls from static (rad/s) */
    clutch_rig_real clutch2_viscous; /* viscous friction k_c,v (N m s/rad) */
    clutch_rig_real clutch2_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    clutch_rig_real clutch2_inertia_input; /* moment of inertia I_ci of the input disk (kg m^2) */
    clutch_rig_real clutch2_inertia_output; /* moment of inertia I_co of the output disk (kg m^2) */
    clutch_rig_real shaft2_stiffness; /* torsional stiffness c_s (N m/rad) */
    clutch_rig_real shaft2_damping; /* internal damping d_s (N m s/rad) */
    clutch_rig_real flange2_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    clutch_rig_real flange2_stiffness; /* torsional stiffness c_f (N m/rad) */
    clutch_rig_real flange2_damping; /* internal damping d_f (N m s/rad) */
    clutch_rig_real M2_inertia; /* moment of inertia of the rotor (kg m^2) */
    clutch_rig_real M2_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    clutch_rig_real M2_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    clutch_rig_real M2_inverter_dead_time; /* dead time of the torque loop (s) */
    clutch_rig_real M2_inverter_time_constant; /* time constant of the torque loop (s) */
    clutch_rig_real standstill_speed; /* friction velocities below this are none (rad/s) */
    clutch_rig_real sample_time; /* step of the plant (s) */
} clutch_rig_plant_params;

/* Inputs of a step. */
typedef struct {
    clutch_rig_real M1_torque_ref; /* air-gap torque reference of M1 (N m) */
    clutch_rig_real M2_torque_ref; /* air-gap torque reference of M2 (N m) */
    clutch_rig_real clutch1_actuation; /* actuation of clutch1, 0 to 1 */
    clutch_rig_real clutch2_actuation; /* actuation of clutch2, 0 to 1 */
} clutch_rig_plant_inputs;

/* Outputs of a step; torques are positive when they drive the right-hand neighbour. */
typedef struct {
    clutch_rig_real M1_speed; /* measured or observed, positive to the right (rad/s) */
    clutch_rig_real flange1_torque; /* measured or observed, positive to the right (N m) */
    clutch_rig_real flange2_torque; /* measured or observed, positive to the right (N m) */
    clutch_rig_real M2_speed; /* measured or observed, positive to the right (rad/s) */
    clutch_rig_real M1_torque; /* air-gap torque of M1 (N m) */
    clutch_rig_real M2_torque; /* air-gap torque of M2 (N m) */
    clutch_rig_real clutch1_torque; /* torque of the friction element clutch1 (N m) */
    clutch_rig_real clutch1_speed; /* velocity of the friction element clutch1 (rad/s) */
    clutch_rig_real clutch2_torque; /* torque of the friction element clutch2 (N m) */
    clutch_rig_real clutch2_speed; /* velocity of the friction element clutch2 (rad/s) */
} clutch_rig_plant_outputs;

/* States first, then what follows from the parameters. Matrices are stored by columns. */
typedef struct {
    clutch_rig_real x[20]; /* velocities, twists, air-gap torques; then the commands that act late and early: */
    /*   [0] velocity of clutch1 (rad/s) */
    /*   [1] velocity of clutch2 (rad/s) */
    /*   [2] velocity of M1.shaft (rad/s) */
    /*   [3] velocity of M2.shaft (rad/s) */
    /*   [4] velocity of flange1.uut (rad/s) */
    /*   [5] velocity of clutch1.input (rad/s) */
    /*   [6] velocity of flange2.uut (rad/s) */
    /*   [7] twist of flange1 (rad) */
    /*   [8] twist of shaft1 (rad) */
    /*   [9] twist of shaft2 (rad) */
    /*   [10] twist of flange2 (rad) */
    /*   [11] air-gap torque of M1 (N m) */
    /*   [12] air-gap torque of M2 (N m) */
    /*   [13] late command to M1 (N m) */
    /*   [14] late command to M2 (N m) */
    /*   [15] early command to M1 (N m) */
    /*   [16] early command to M2 (N m) */
    clutch_rig_real M1_delay[16]; /* commands to M1 of past steps (N m) */
    clutch_rig_real M2_delay[16]; /* commands to M2 of past steps (N m) */
    clutch_rig_real friction_torque[4]; /* friction torques at the end of the step (N m): */
    /*   [0] clutch1 */
    /*   [1] clutch2 */
    clutch_rig_real friction_rest[4]; /* capacities at rest in the last step (N m): */
    /*   [0] clutch1 */
    /*   [1] clutch2 */
    clutch_rig_real friction_status; /* 0, or what was wrong with the friction of the last step */
    clutch_rig_real transition[17][16]; /* x at the end of the step without friction torques */
    clutch_rig_real M1_dead_steps; /* whole steps of dead time */
    clutch_rig_real M2_dead_steps; /* whole steps of dead time */
    clutch_rig_real gamma[2][16]; /* x at the end of the step per friction and contact torque */
    clutch_rig_real K[2][4]; /* friction velocities lost per mean friction torque (rad/(N m s)) */
} clutch_rig_plant_state;

typedef enum {
    clutch_rig_plant_ok = 0,
    clutch_rig_plant_mass_matrix = 1001,
    clutch_rig_plant_exponential_range = 1002,
    clutch_rig_plant_friction_matrix = 1003,
    clutch_rig_plant_bad_input_M1_torque_ref = 1100, /* is not finite */
    clutch_rig_plant_bad_input_M2_torque_ref = 1101, /* is not finite */
    clutch_rig_plant_bad_input_clutch1_actuation = 1102, /* is outside its range 0 to 1 */
    clutch_rig_plant_bad_input_clutch2_actuation = 1103, /* is outside its range 0 to 1 */
    clutch_rig_plant_friction_unsolved = 1501, /* the friction torques are not exact */
    clutch_rig_plant_bad_capacity_clutch1 = 1502, /* the capacity of clutch1 is no number from 0 up; it was taken as 0 */
    clutch_rig_plant_bad_capacity_clutch2 = 1503, /* the capacity of clutch2 is no number from 0 up; it was taken as 0 */
    clutch_rig_plant_bad_M1_inertia = 2000, /* outside its range */
    clutch_rig_plant_bad_M1_torque_max = 2001, /* outside its range */
    clutch_rig_plant_bad_M1_speed_rated = 2002, /* outside its range */
    clutch_rig_plant_bad_M1_inverter_dead_time = 2003, /* outside its range */
    clutch_rig_plant_bad_M1_inverter_time_constant = 2004, /* outside its range */
    clutch_rig_plant_bad_flange1_inertia = 2005, /* outside its range */
    clutch_rig_plant_bad_flange1_stiffness = 2006, /* outside its range */
    clutch_rig_plant_bad_flange1_damping = 2007, /* outside its range */
    clutch_rig_plant_bad_shaft1_stiffness = 2008, /* outside its range */
    clutch_rig_plant_bad_shaft1_damping = 2009, /* outside its range */
    clutch_rig_plant_bad_clutch1_viscous = 2010, /* outside its range */
    clutch_rig_plant_bad_clutch1_capacity = 2011, /* outside its range */
    clutch_rig_plant_bad_clutch1_inertia_input = 2012, /* outside its range */
    clutch_rig_plant_bad_clutch1_inertia_output = 2013, /* outside its range */
    clutch_rig_plant_bad_middle_inertia = 2014, /* outside its range */
    clutch_rig_plant_bad_clutch2_static = 2015, /* outside its range */
    clutch_rig_plant_bad_clutch2_stribeck_speed = 2016, /* outside its range */
    clutch_rig_plant_bad_clutch2_viscous = 2017, /* outside its range */
    clutch_rig_plant_bad_clutch2_capacity = 2018, /* outside its range */
    clutch_rig_plant_bad_clutch2_inertia_input = 2019, /* outside its range */
    clutch_rig_plant_bad_clutch2_inertia_output = 2020, /* outside its range */
    clutch_rig_plant_bad_shaft2_stiffness = 2021, /* outside its range */
    clutch_rig_plant_bad_shaft2_damping = 2022, /* outside its range */
    clutch_rig_plant_bad_flange2_inertia = 2023, /* outside its range */
    clutch_rig_plant_bad_flange2_stiffness = 2024, /* outside its range */
    clutch_rig_plant_bad_flange2_damping = 2025, /* outside its range */
    clutch_rig_plant_bad_M2_inertia = 2026, /* outside its range */
    clutch_rig_plant_bad_M2_torque_max = 2027, /* outside its range */
    clutch_rig_plant_bad_M2_speed_rated = 2028, /* outside its range */
    clutch_rig_plant_bad_M2_inverter_dead_time = 2029, /* outside its range */
    clutch_rig_plant_bad_M2_inverter_time_constant = 2030, /* outside its range */
    clutch_rig_plant_bad_standstill_speed = 2031, /* outside its range */
    clutch_rig_plant_bad_sample_time = 2032, /* outside its range */
} clutch_rig_plant_status;

extern const clutch_rig_plant_params clutch_rig_plant_defaults;

/* Name of a status, for logs. */
const char *clutch_rig_plant_status_text(clutch_rig_plant_status status);

/* Sets the initial state and prepares everything that follows from the parameters. */
clutch_rig_plant_status clutch_rig_plant_init(clutch_rig_plant_state *state, const clutch_rig_plant_params *params);

/* Checks the parameters and prepares what follows from them; the rest of the state stays. */
clutch_rig_plant_status clutch_rig_plant_update(clutch_rig_plant_state *state, const clutch_rig_plant_params *params);

/* One step. After a bad input the state is as it was, and the outputs are those of that state. */
clutch_rig_plant_status clutch_rig_plant_step(clutch_rig_plant_state *state, const clutch_rig_plant_params *params,
    const clutch_rig_plant_inputs *inputs, clutch_rig_plant_outputs *outputs);

/* Outputs of the present state, as at the end of a step. */
void clutch_rig_plant_measure(const clutch_rig_plant_state *state, const clutch_rig_plant_params *params,
    clutch_rig_plant_outputs *outputs);

#endif
