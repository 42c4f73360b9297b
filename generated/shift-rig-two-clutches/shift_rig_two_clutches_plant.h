/*
 * shift_rig_two_clutches_plant.h: plant of the bed shift_rig_two_clutches
 *
 * Emitted by ptgen 0.1.0 from shift-rig-two-clutches.toml (SHA-256 dd9752ce0776f1aa), template block.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef SHIFT_RIG_TWO_CLUTCHES_PLANT_H
#define SHIFT_RIG_TWO_CLUTCHES_PLANT_H

#include "shift_rig_two_clutches_support.h"

/* Parameters, in SI units; call shift_rig_two_clutches_plant_update after a change. */
typedef struct {
    shift_rig_two_clutches_real M1_inertia; /* moment of inertia of the rotor (kg m^2) */
    shift_rig_two_clutches_real M1_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    shift_rig_two_clutches_real M1_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    shift_rig_two_clutches_real M1_inverter_dead_time; /* dead time of the torque loop (s) */
    shift_rig_two_clutches_real M1_inverter_time_constant; /* time constant of the torque loop (s) */
    shift_rig_two_clutches_real flange1_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    shift_rig_two_clutches_real flange1_stiffness; /* torsional stiffness c_f (N m/rad) */
    shift_rig_two_clutches_real flange1_damping; /* internal damping d_f (N m s/rad) */
    shift_rig_two_clutches_real shaft1_stiffness; /* torsional stiffness c_s (N m/rad) */
    shift_rig_two_clutches_real shaft1_damping; /* internal damping d_s (N m s/rad) */
    shift_rig_two_clutches_real gears_inertia_input; /* moment of inertia I_gbi at the input (kg m^2) */
    shift_rig_two_clutches_real gears_inertia_output; /* moment of inertia I_gbo at the output (kg m^2) */
    shift_rig_two_clutches_real gears_clutch1_viscous; /* viscous friction k_c,v (N m s/rad) */
    shift_rig_two_clutches_real gears_clutch1_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    shift_rig_two_clutches_real gears_clutch2_viscous; /* viscous friction k_c,v (N m s/rad) */
    shift_rig_two_clutches_real gears_clutch2_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    shift_rig_two_clutches_real shaft2_stiffness; /* torsional stiffness c_s (N m/rad) */
    shift_rig_two_clutches_real shaft2_damping; /* internal damping d_s (N m s/rad) */
    shift_rig_two_clutches_real flange2_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    shift_rig_two_clutches_real flange2_stiffness; /* torsional stiffness c_f (N m/rad) */
    shift_rig_two_clutches_real flange2_damping; /* internal damping d_f (N m s/rad) */
    shift_rig_two_clutches_real M2_inertia; /* moment of inertia of the rotor (kg m^2) */
    shift_rig_two_clutches_real M2_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    shift_rig_two_clutches_real M2_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    shift_rig_two_clutches_real M2_inverter_dead_time; /* dead time of the torque loop (s) */
    shift_rig_two_clutches_real M2_inverter_time_constant; /* time constant of the torque loop (s) */
    shift_rig_two_clutches_real standstill_speed; /* friction velocities below this are none (rad/s) */
    shift_rig_two_clutches_real sample_time; /* step of the plant (s) */
} shift_rig_two_clutches_plant_params;

/* Inputs of a step. */
typedef struct {
    shift_rig_two_clutches_real M1_torque_ref; /* air-gap torque reference of M1 (N m) */
    shift_rig_two_clutches_real M2_torque_ref; /* air-gap torque reference of M2 (N m) */
    shift_rig_two_clutches_real gears_clutch1_actuation; /* actuation of gears.clutch1, 0 to 1 */
    shift_rig_two_clutches_real gears_clutch2_actuation; /* actuation of gears.clutch2, 0 to 1 */
    shift_rig_two_clutches_real gears_ratio1; /* input speed over output speed behind the first clutch */
    shift_rig_two_clutches_real gears_ratio2; /* input speed over output speed behind the second clutch */
} shift_rig_two_clutches_plant_inputs;

/* Outputs of a step; torques are positive when they drive the right-hand neighbour. */
typedef struct {
    shift_rig_two_clutches_real M1_speed; /* measured or observed, positive to the right (rad/s) */
    shift_rig_two_clutches_real flange1_torque; /* measured or observed, positive to the right (N m) */
    shift_rig_two_clutches_real flange2_torque; /* measured or observed, positive to the right (N m) */
    shift_rig_two_clutches_real M2_speed; /* measured or observed, positive to the right (rad/s) */
    shift_rig_two_clutches_real M1_torque; /* air-gap torque of M1 (N m) */
    shift_rig_two_clutches_real M2_torque; /* air-gap torque of M2 (N m) */
    shift_rig_two_clutches_real gears_clutch1_torque; /* torque of the friction element gears.clutch1 (N m) */
    shift_rig_two_clutches_real gears_clutch1_speed; /* velocity of the friction element gears.clutch1 (rad/s) */
    shift_rig_two_clutches_real gears_clutch2_torque; /* torque of the friction element gears.clutch2 (N m) */
    shift_rig_two_clutches_real gears_clutch2_speed; /* velocity of the friction element gears.clutch2 (rad/s) */
} shift_rig_two_clutches_plant_outputs;

/* States first, then what follows from the parameters. Matrices are stored by columns. */
typedef struct {
    shift_rig_two_clutches_real x[16]; /* velocities, twists, air-gap torques; then the commands that act late and early: */
    /*   [0] velocity of M1.shaft (rad/s) */
    /*   [1] velocity of M2.shaft (rad/s) */
    /*   [2] velocity of flange1.uut (rad/s) */
    /*   [3] velocity of gears.input (rad/s) */
    /*   [4] velocity of gears.output (rad/s) */
    /*   [5] velocity of flange2.uut (rad/s) */
    /*   [6] twist of flange1 (rad) */
    /*   [7] twist of shaft1 (rad) */
    /*   [8] twist of shaft2 (rad) */
    /*   [9] twist of flange2 (rad) */
    /*   [10] air-gap torque of M1 (N m) */
    /*   [11] air-gap torque of M2 (N m) */
    /*   [12] late command to M1 (N m) */
    /*   [13] late command to M2 (N m) */
    /*   [14] early command to M1 (N m) */
    /*   [15] early command to M2 (N m) */
    shift_rig_two_clutches_real M1_delay[16]; /* commands to M1 of past steps (N m) */
    shift_rig_two_clutches_real M2_delay[16]; /* commands to M2 of past steps (N m) */
    shift_rig_two_clutches_real gears_ratio1_now; /* input speed over output speed behind the first clutch, in the last step */
    shift_rig_two_clutches_real gears_ratio2_now; /* input speed over output speed behind the second clutch, in the last step */
    shift_rig_two_clutches_real friction_torque[4]; /* friction torques at the end of the step (N m): */
    /*   [0] gears.clutch1 */
    /*   [1] gears.clutch2 */
    shift_rig_two_clutches_real friction_rest[4]; /* capacities at rest in the last step (N m): */
    /*   [0] gears.clutch1 */
    /*   [1] gears.clutch2 */
    shift_rig_two_clutches_real friction_status; /* 0, or what was wrong with the friction of the last step */
    shift_rig_two_clutches_real transition[16][12]; /* x at the end of the step without friction torques */
    shift_rig_two_clutches_real M1_dead_steps; /* whole steps of dead time */
    shift_rig_two_clutches_real M2_dead_steps; /* whole steps of dead time */
    shift_rig_two_clutches_real gamma[2][12]; /* x at the end of the step per friction and contact torque */
    shift_rig_two_clutches_real velocity_rounding; /* share of a sum of velocities that is rounding */
    shift_rig_two_clutches_real K[2][4]; /* friction velocities lost per mean friction torque (rad/(N m s)) */
    shift_rig_two_clutches_real gamma_pressed[2][12]; /* x at the end of the step per friction torque on a coordinate */
    shift_rig_two_clutches_real K_base[2][4]; /* the same for the elements that others are put together from (rad/(N m s)) */
} shift_rig_two_clutches_plant_state;

typedef enum {
    shift_rig_two_clutches_plant_ok = 0,
    shift_rig_two_clutches_plant_mass_matrix = 1001,
    shift_rig_two_clutches_plant_exponential_range = 1002,
    shift_rig_two_clutches_plant_friction_matrix = 1003,
    shift_rig_two_clutches_plant_bad_input_M1_torque_ref = 1100, /* is not finite */
    shift_rig_two_clutches_plant_bad_input_M2_torque_ref = 1101, /* is not finite */
    shift_rig_two_clutches_plant_bad_input_gears_clutch1_actuation = 1102, /* is outside its range 0 to 1 */
    shift_rig_two_clutches_plant_bad_input_gears_clutch2_actuation = 1103, /* is outside its range 0 to 1 */
    shift_rig_two_clutches_plant_bad_input_gears_ratio1 = 1104, /* is outside its range 3.33333 to 5.50322 */
    shift_rig_two_clutches_plant_bad_input_gears_ratio2 = 1105, /* is outside its range 3.33333 to 5.50322 */
    shift_rig_two_clutches_plant_friction_unsolved = 1501, /* the friction torques are not exact */
    shift_rig_two_clutches_plant_bad_capacity_gears_clutch1 = 1502, /* the capacity of gears.clutch1 is no number from 0 up; it was taken as 0 */
    shift_rig_two_clutches_plant_bad_capacity_gears_clutch2 = 1503, /* the capacity of gears.clutch2 is no number from 0 up; it was taken as 0 */
    shift_rig_two_clutches_plant_bad_M1_inertia = 2000, /* outside its range */
    shift_rig_two_clutches_plant_bad_M1_torque_max = 2001, /* outside its range */
    shift_rig_two_clutches_plant_bad_M1_speed_rated = 2002, /* outside its range */
    shift_rig_two_clutches_plant_bad_M1_inverter_dead_time = 2003, /* outside its range */
    shift_rig_two_clutches_plant_bad_M1_inverter_time_constant = 2004, /* outside its range */
    shift_rig_two_clutches_plant_bad_flange1_inertia = 2005, /* outside its range */
    shift_rig_two_clutches_plant_bad_flange1_stiffness = 2006, /* outside its range */
    shift_rig_two_clutches_plant_bad_flange1_damping = 2007, /* outside its range */
    shift_rig_two_clutches_plant_bad_shaft1_stiffness = 2008, /* outside its range */
    shift_rig_two_clutches_plant_bad_shaft1_damping = 2009, /* outside its range */
    shift_rig_two_clutches_plant_bad_gears_inertia_input = 2010, /* outside its range */
    shift_rig_two_clutches_plant_bad_gears_inertia_output = 2011, /* outside its range */
    shift_rig_two_clutches_plant_bad_gears_clutch1_viscous = 2012, /* outside its range */
    shift_rig_two_clutches_plant_bad_gears_clutch1_capacity = 2013, /* outside its range */
    shift_rig_two_clutches_plant_bad_gears_clutch2_viscous = 2014, /* outside its range */
    shift_rig_two_clutches_plant_bad_gears_clutch2_capacity = 2015, /* outside its range */
    shift_rig_two_clutches_plant_bad_shaft2_stiffness = 2016, /* outside its range */
    shift_rig_two_clutches_plant_bad_shaft2_damping = 2017, /* outside its range */
    shift_rig_two_clutches_plant_bad_flange2_inertia = 2018, /* outside its range */
    shift_rig_two_clutches_plant_bad_flange2_stiffness = 2019, /* outside its range */
    shift_rig_two_clutches_plant_bad_flange2_damping = 2020, /* outside its range */
    shift_rig_two_clutches_plant_bad_M2_inertia = 2021, /* outside its range */
    shift_rig_two_clutches_plant_bad_M2_torque_max = 2022, /* outside its range */
    shift_rig_two_clutches_plant_bad_M2_speed_rated = 2023, /* outside its range */
    shift_rig_two_clutches_plant_bad_M2_inverter_dead_time = 2024, /* outside its range */
    shift_rig_two_clutches_plant_bad_M2_inverter_time_constant = 2025, /* outside its range */
    shift_rig_two_clutches_plant_bad_standstill_speed = 2026, /* outside its range */
    shift_rig_two_clutches_plant_bad_sample_time = 2027, /* outside its range */
} shift_rig_two_clutches_plant_status;

extern const shift_rig_two_clutches_plant_params shift_rig_two_clutches_plant_defaults;

/* Name of a status, for logs. */
const char *shift_rig_two_clutches_plant_status_text(shift_rig_two_clutches_plant_status status);

/* Sets the initial state and prepares everything that follows from the parameters. */
shift_rig_two_clutches_plant_status shift_rig_two_clutches_plant_init(shift_rig_two_clutches_plant_state *state, const shift_rig_two_clutches_plant_params *params);

/* Checks the parameters and prepares what follows from them; the rest of the state stays. */
shift_rig_two_clutches_plant_status shift_rig_two_clutches_plant_update(shift_rig_two_clutches_plant_state *state, const shift_rig_two_clutches_plant_params *params);

/* One step. After a bad input the state is as it was, and the outputs are those of that state. */
shift_rig_two_clutches_plant_status shift_rig_two_clutches_plant_step(shift_rig_two_clutches_plant_state *state, const shift_rig_two_clutches_plant_params *params,
    const shift_rig_two_clutches_plant_inputs *inputs, shift_rig_two_clutches_plant_outputs *outputs);

/* Outputs of the present state, as at the end of a step. */
void shift_rig_two_clutches_plant_measure(const shift_rig_two_clutches_plant_state *state, const shift_rig_two_clutches_plant_params *params,
    shift_rig_two_clutches_plant_outputs *outputs);

#endif
