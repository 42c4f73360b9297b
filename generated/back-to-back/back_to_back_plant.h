/*
 * back_to_back_plant.h: plant of the bed back_to_back
 *
 * Emitted by ptgen 0.1.0 from back-to-back.toml (SHA-256 376363ff9555c6b9), template block.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef BACK_TO_BACK_PLANT_H
#define BACK_TO_BACK_PLANT_H

#include "back_to_back_support.h"

/* Parameters, in SI units; call back_to_back_plant_update after a change. */
typedef struct {
    back_to_back_real M1_inertia; /* moment of inertia of the rotor (kg m^2) */
    back_to_back_real M1_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    back_to_back_real M1_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    back_to_back_real M1_inverter_dead_time; /* dead time of the torque loop (s) */
    back_to_back_real M1_inverter_time_constant; /* time constant of the torque loop (s) */
    back_to_back_real flange1_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    back_to_back_real flange1_stiffness; /* torsional stiffness c_f (N m/rad) */
    back_to_back_real flange1_damping; /* internal damping d_f (N m s/rad) */
    back_to_back_real shaft1_stiffness; /* torsional stiffness c_s (N m/rad) */
    back_to_back_real shaft1_damping; /* internal damping d_s (N m s/rad) */
    back_to_back_real flange2_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    back_to_back_real flange2_stiffness; /* torsional stiffness c_f (N m/rad) */
    back_to_back_real flange2_damping; /* internal damping d_f (N m s/rad) */
    back_to_back_real M2_inertia; /* moment of inertia of the rotor (kg m^2) */
    back_to_back_real M2_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    back_to_back_real M2_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    back_to_back_real M2_inverter_dead_time; /* dead time of the torque loop (s) */
    back_to_back_real M2_inverter_time_constant; /* time constant of the torque loop (s) */
    back_to_back_real sample_time; /* step of the plant (s) */
} back_to_back_plant_params;

/* Inputs of a step. */
typedef struct {
    back_to_back_real M1_torque_ref; /* air-gap torque reference of M1 (N m) */
    back_to_back_real M2_torque_ref; /* air-gap torque reference of M2 (N m) */
} back_to_back_plant_inputs;

/* Outputs of a step; torques are positive when they drive the right-hand neighbour. */
typedef struct {
    back_to_back_real M1_speed; /* measured or observed, positive to the right (rad/s) */
    back_to_back_real flange1_torque; /* measured or observed, positive to the right (N m) */
    back_to_back_real flange2_torque; /* measured or observed, positive to the right (N m) */
    back_to_back_real M2_speed; /* measured or observed, positive to the right (rad/s) */
    back_to_back_real M1_torque; /* air-gap torque of M1 (N m) */
    back_to_back_real M2_torque; /* air-gap torque of M2 (N m) */
} back_to_back_plant_outputs;

/* States first, then what follows from the parameters. Matrices are stored by columns. */
typedef struct {
    back_to_back_real x[16]; /* velocities, twists, air-gap torques; then the commands that act late and early: */
    /*   [0] velocity of M1.shaft (rad/s) */
    /*   [1] velocity of M2.shaft (rad/s) */
    /*   [2] velocity of flange1.uut (rad/s) */
    /*   [3] velocity of flange2.uut (rad/s) */
    /*   [4] twist of flange1 (rad) */
    /*   [5] twist of shaft1 (rad) */
    /*   [6] twist of flange2 (rad) */
    /*   [7] air-gap torque of M1 (N m) */
    /*   [8] air-gap torque of M2 (N m) */
    /*   [9] late command to M1 (N m) */
    /*   [10] late command to M2 (N m) */
    /*   [11] early command to M1 (N m) */
    /*   [12] early command to M2 (N m) */
    back_to_back_real M1_delay[16]; /* commands to M1 of past steps (N m) */
    back_to_back_real M2_delay[16]; /* commands to M2 of past steps (N m) */
    back_to_back_real transition[13][12]; /* x at the end of the step without friction torques */
    back_to_back_real M1_dead_steps; /* whole steps of dead time */
    back_to_back_real M2_dead_steps; /* whole steps of dead time */
} back_to_back_plant_state;

typedef enum {
    back_to_back_plant_ok = 0,
    back_to_back_plant_mass_matrix = 1001,
    back_to_back_plant_exponential_range = 1002,
    back_to_back_plant_bad_input_M1_torque_ref = 1100, /* is not finite */
    back_to_back_plant_bad_input_M2_torque_ref = 1101, /* is not finite */
    back_to_back_plant_bad_M1_inertia = 2000, /* outside its range */
    back_to_back_plant_bad_M1_torque_max = 2001, /* outside its range */
    back_to_back_plant_bad_M1_speed_rated = 2002, /* outside its range */
    back_to_back_plant_bad_M1_inverter_dead_time = 2003, /* outside its range */
    back_to_back_plant_bad_M1_inverter_time_constant = 2004, /* outside its range */
    back_to_back_plant_bad_flange1_inertia = 2005, /* outside its range */
    back_to_back_plant_bad_flange1_stiffness = 2006, /* outside its range */
    back_to_back_plant_bad_flange1_damping = 2007, /* outside its range */
    back_to_back_plant_bad_shaft1_stiffness = 2008, /* outside its range */
    back_to_back_plant_bad_shaft1_damping = 2009, /* outside its range */
    back_to_back_plant_bad_flange2_inertia = 2010, /* outside its range */
    back_to_back_plant_bad_flange2_stiffness = 2011, /* outside its range */
    back_to_back_plant_bad_flange2_damping = 2012, /* outside its range */
    back_to_back_plant_bad_M2_inertia = 2013, /* outside its range */
    back_to_back_plant_bad_M2_torque_max = 2014, /* outside its range */
    back_to_back_plant_bad_M2_speed_rated = 2015, /* outside its range */
    back_to_back_plant_bad_M2_inverter_dead_time = 2016, /* outside its range */
    back_to_back_plant_bad_M2_inverter_time_constant = 2017, /* outside its range */
    back_to_back_plant_bad_sample_time = 2018, /* outside its range */
} back_to_back_plant_status;

extern const back_to_back_plant_params back_to_back_plant_defaults;

/* Name of a status, for logs. */
const char *back_to_back_plant_status_text(back_to_back_plant_status status);

/* Sets the initial state and prepares everything that follows from the parameters. */
back_to_back_plant_status back_to_back_plant_init(back_to_back_plant_state *state, const back_to_back_plant_params *params);

/* Checks the parameters and prepares what follows from them; the rest of the state stays. */
back_to_back_plant_status back_to_back_plant_update(back_to_back_plant_state *state, const back_to_back_plant_params *params);

/* One step. After a bad input the state is as it was, and the outputs are those of that state. */
back_to_back_plant_status back_to_back_plant_step(back_to_back_plant_state *state, const back_to_back_plant_params *params,
    const back_to_back_plant_inputs *inputs, back_to_back_plant_outputs *outputs);

/* Outputs of the present state, as at the end of a step. */
void back_to_back_plant_measure(const back_to_back_plant_state *state, const back_to_back_plant_params *params,
    back_to_back_plant_outputs *outputs);

#endif
