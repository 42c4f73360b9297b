/*
 * transmission_fixed_gear_plant.h: plant of the bed transmission_fixed_gear
 *
 * Emitted by ptgen 0.1.0 from transmission-fixed-gear.toml (SHA-256 ccd2b8cca096cd29), template block.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef TRANSMISSION_FIXED_GEAR_PLANT_H
#define TRANSMISSION_FIXED_GEAR_PLANT_H

#include "transmission_fixed_gear_support.h"

/* Parameters, in SI units; call transmission_fixed_gear_plant_update after a change. */
typedef struct {
    transmission_fixed_gear_real M1_inertia; /* moment of inertia of the rotor (kg m^2) */
    transmission_fixed_gear_real M1_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    transmission_fixed_gear_real M1_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    transmission_fixed_gear_real M1_inverter_dead_time; /* dead time of the torque loop (s) */
    transmission_fixed_gear_real M1_inverter_time_constant; /* time constant of the torque loop (s) */
    transmission_fixed_gear_real flange1_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    transmission_fixed_gear_real flange1_stiffness; /* torsional stiffness c_f (N m/rad) */
    transmission_fixed_gear_real flange1_damping; /* internal damping d_f (N m s/rad) */
    transmission_fixed_gear_real shaft1_stiffness; /* torsional stiffness c_s (N m/rad) */
    transmission_fixed_gear_real shaft1_damping; /* internal damping d_s (N m s/rad) */
    transmission_fixed_gear_real gearbox_inertia; /* moment of inertia, referred to the side named in inertia_side (kg m^2) */
    transmission_fixed_gear_real shaft2_stiffness; /* torsional stiffness c_s (N m/rad) */
    transmission_fixed_gear_real shaft2_damping; /* internal damping d_s (N m s/rad) */
    transmission_fixed_gear_real flange2_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    transmission_fixed_gear_real flange2_stiffness; /* torsional stiffness c_f (N m/rad) */
    transmission_fixed_gear_real flange2_damping; /* internal damping d_f (N m s/rad) */
    transmission_fixed_gear_real M2_inertia; /* moment of inertia of the rotor (kg m^2) */
    transmission_fixed_gear_real M2_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    transmission_fixed_gear_real M2_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    transmission_fixed_gear_real M2_inverter_dead_time; /* dead time of the torque loop (s) */
    transmission_fixed_gear_real M2_inverter_time_constant; /* time constant of the torque loop (s) */
    transmission_fixed_gear_real sample_time; /* step of the plant (s) */
} transmission_fixed_gear_plant_params;

/* Inputs of a step. */
typedef struct {
    transmission_fixed_gear_real M1_torque_ref; /* air-gap torque reference of M1 (N m) */
    transmission_fixed_gear_real M2_torque_ref; /* air-gap torque reference of M2 (N m) */
    transmission_fixed_gear_real gearbox_ratio; /* ratio of input speed to output speed; negative when the sense reverses */
} transmission_fixed_gear_plant_inputs;

/* Outputs of a step; torques are positive when they drive the right-hand neighbour. */
typedef struct {
    transmission_fixed_gear_real M1_speed; /* measured or observed, positive to the right (rad/s) */
    transmission_fixed_gear_real flange1_torque; /* measured or observed, positive to the right (N m) */
    transmission_fixed_gear_real flange2_torque; /* measured or observed, positive to the right (N m) */
    transmission_fixed_gear_real M2_speed; /* measured or observed, positive to the right (rad/s) */
    transmission_fixed_gear_real gearbox_input_torque; /* measured or observed, positive to the right (N m) */
    transmission_fixed_gear_real M1_torque; /* air-gap torque of M1 (N m) */
    transmission_fixed_gear_real M2_torque; /* air-gap torque of M2 (N m) */
} transmission_fixed_gear_plant_outputs;

/* States first, then what follows from the parameters. Matrices are stored by columns. */
typedef struct {
    transmission_fixed_gear_real x[16]; /* velocities, twists, air-gap torques; then the commands that act late and early: */
    /*   [0] velocity of M1.shaft (rad/s) */
    /*   [1] velocity of M2.shaft (rad/s) */
    /*   [2] velocity of flange1.uut (rad/s) */
    /*   [3] velocity of gearbox.input (rad/s) */
    /*   [4] velocity of flange2.uut (rad/s) */
    /*   [5] twist of flange1 (rad) */
    /*   [6] twist of shaft1 (rad) */
    /*   [7] twist of shaft2 (rad) */
    /*   [8] twist of flange2 (rad) */
    /*   [9] air-gap torque of M1 (N m) */
    /*   [10] air-gap torque of M2 (N m) */
    /*   [11] late command to M1 (N m) */
    /*   [12] late command to M2 (N m) */
    /*   [13] early command to M1 (N m) */
    /*   [14] early command to M2 (N m) */
    transmission_fixed_gear_real M1_delay[16]; /* commands to M1 of past steps (N m) */
    transmission_fixed_gear_real M2_delay[16]; /* commands to M2 of past steps (N m) */
    transmission_fixed_gear_real gearbox_ratio_now; /* ratio of input speed to output speed; negative when the sense reverses, in the last step */
    transmission_fixed_gear_real transition[15][12]; /* x at the end of the step without friction torques */
    transmission_fixed_gear_real M1_dead_steps; /* whole steps of dead time */
    transmission_fixed_gear_real M2_dead_steps; /* whole steps of dead time */
} transmission_fixed_gear_plant_state;

typedef enum {
    transmission_fixed_gear_plant_ok = 0,
    transmission_fixed_gear_plant_mass_matrix = 1001,
    transmission_fixed_gear_plant_exponential_range = 1002,
    transmission_fixed_gear_plant_bad_input_M1_torque_ref = 1100, /* is not finite */
    transmission_fixed_gear_plant_bad_input_M2_torque_ref = 1101, /* is not finite */
    transmission_fixed_gear_plant_bad_input_gearbox_ratio = 1102, /* is outside its range 0.65 to 4.7 */
    transmission_fixed_gear_plant_bad_M1_inertia = 2000, /* outside its range */
    transmission_fixed_gear_plant_bad_M1_torque_max = 2001, /* outside its range */
    transmission_fixed_gear_plant_bad_M1_speed_rated = 2002, /* outside its range */
    transmission_fixed_gear_plant_bad_M1_inverter_dead_time = 2003, /* outside its range */
    transmission_fixed_gear_plant_bad_M1_inverter_time_constant = 2004, /* outside its range */
    transmission_fixed_gear_plant_bad_flange1_inertia = 2005, /* outside its range */
    transmission_fixed_gear_plant_bad_flange1_stiffness = 2006, /* outside its range */
    transmission_fixed_gear_plant_bad_flange1_damping = 2007, /* outside its range */
    transmission_fixed_gear_plant_bad_shaft1_stiffness = 2008, /* outside its range */
    transmission_fixed_gear_plant_bad_shaft1_damping = 2009, /* outside its range */
    transmission_fixed_gear_plant_bad_gearbox_inertia = 2010, /* outside its range */
    transmission_fixed_gear_plant_bad_shaft2_stiffness = 2011, /* outside its range */
    transmission_fixed_gear_plant_bad_shaft2_damping = 2012, /* outside its range */
    transmission_fixed_gear_plant_bad_flange2_inertia = 2013, /* outside its range */
    transmission_fixed_gear_plant_bad_flange2_stiffness = 2014, /* outside its range */
    transmission_fixed_gear_plant_bad_flange2_damping = 2015, /* outside its range */
    transmission_fixed_gear_plant_bad_M2_inertia = 2016, /* outside its range */
    transmission_fixed_gear_plant_bad_M2_torque_max = 2017, /* outside its range */
    transmission_fixed_gear_plant_bad_M2_speed_rated = 2018, /* outside its range */
    transmission_fixed_gear_plant_bad_M2_inverter_dead_time = 2019, /* outside its range */
    transmission_fixed_gear_plant_bad_M2_inverter_time_constant = 2020, /* outside its range */
    transmission_fixed_gear_plant_bad_sample_time = 2021, /* outside its range */
} transmission_fixed_gear_plant_status;

extern const transmission_fixed_gear_plant_params transmission_fixed_gear_plant_defaults;

/* Name of a status, for logs. */
const char *transmission_fixed_gear_plant_status_text(transmission_fixed_gear_plant_status status);

/* Sets the initial state and prepares everything that follows from the parameters. */
transmission_fixed_gear_plant_status transmission_fixed_gear_plant_init(transmission_fixed_gear_plant_state *state, const transmission_fixed_gear_plant_params *params);

/* Checks the parameters and prepares what follows from them; the rest of the state stays. */
transmission_fixed_gear_plant_status transmission_fixed_gear_plant_update(transmission_fixed_gear_plant_state *state, const transmission_fixed_gear_plant_params *params);

/* One step. After a bad input the state is as it was, and the outputs are those of that state. */
transmission_fixed_gear_plant_status transmission_fixed_gear_plant_step(transmission_fixed_gear_plant_state *state, const transmission_fixed_gear_plant_params *params,
    const transmission_fixed_gear_plant_inputs *inputs, transmission_fixed_gear_plant_outputs *outputs);

/* Outputs of the present state, as at the end of a step. */
void transmission_fixed_gear_plant_measure(const transmission_fixed_gear_plant_state *state, const transmission_fixed_gear_plant_params *params,
    transmission_fixed_gear_plant_outputs *outputs);

#endif
