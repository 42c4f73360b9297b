/*
 * transmission_plant.h: plant of the bed transmission
 *
 * Emitted by ptgen 0.1.0 from transmission.toml (SHA-256 e06936acb40aa4a5), template block.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef TRANSMISSION_PLANT_H
#define TRANSMISSION_PLANT_H

#include "transmission_support.h"

/* Parameters, in SI units; call transmission_plant_update after a change. */
typedef struct {
    transmission_real M1_inertia; /* moment of inertia of the rotor (kg m^2) */
    transmission_real M1_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    transmission_real M1_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    transmission_real M1_inverter_dead_time; /* dead time of the torque loop (s) */
    transmission_real M1_inverter_time_constant; /* time constant of the torque loop (s) */
    transmission_real flange1_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    transmission_real flange1_stiffness; /* torsional stiffness c_f (N m/rad) */
    transmission_real flange1_damping; /* internal damping d_f (N m s/rad) */
    transmission_real shaft1_stiffness; /* torsional stiffness c_s (N m/rad) */
    transmission_real shaft1_damping; /* internal damping d_s (N m s/rad) */
    transmission_real shaft1_backlash; /* full width theta_bl of the gap (rad) */
    transmission_real converter_inertia_pump; /* moment of inertia I_p of the pump (kg m^2) */
    transmission_real converter_inertia_turbine; /* moment of inertia I_t of the turbine (kg m^2) */
    transmission_real converter_reference_speed; /* speed omega_pc of the faster wheel for which the maps hold (rad/s) */
    transmission_real converter_lockup_static; /* largest torque T_c,s that it holds at rest (N m) */
    transmission_real converter_lockup_stribeck_speed; /* velocity omega_c,s over which the torque falls from static (rad/s) */
    transmission_real converter_lockup_viscous; /* viscous friction k_c,v (N m s/rad) */
    transmission_real converter_lockup_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    transmission_real gears_inertia_input; /* moment of inertia I_gbi at the input (kg m^2) */
    transmission_real gears_inertia_output; /* moment of inertia I_gbo at the output (kg m^2) */
    transmission_real gears_clutch1_static; /* largest torque T_c,s that it holds at rest (N m) */
    transmission_real gears_clutch1_stribeck_speed; /* velocity omega_c,s over which the torque falls from static (rad/s) */
    transmission_real gears_clutch1_viscous; /* viscous friction k_c,v (N m s/rad) */
    transmission_real gears_clutch1_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    transmission_real gears_clutch2_static; /* largest torque T_c,s that it holds at rest (N m) */
    transmission_real gears_clutch2_stribeck_speed; /* velocity omega_c,s over which the torque falls from static (rad/s) */
    transmission_real gears_clutch2_viscous; /* viscous friction k_c,v (N m s/rad) */
    transmission_real gears_clutch2_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    transmission_real shaft2_stiffness; /* torsional stiffness c_s (N m/rad) */
    transmission_real shaft2_damping; /* internal damping d_s (N m s/rad) */
    transmission_real shaft2_backlash; /* full width theta_bl of the gap (rad) */
    transmission_real flange2_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    transmission_real flange2_stiffness; /* torsional stiffness c_f (N m/rad) */
    transmission_real flange2_damping; /* internal damping d_f (N m s/rad) */
    transmission_real M2_inertia; /* moment of inertia of the rotor (kg m^2) */
    transmission_real M2_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    transmission_real M2_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    transmission_real M2_inverter_dead_time; /* dead time of the torque loop (s) */
    transmission_real M2_inverter_time_constant; /* time constant of the torque loop (s) */
    transmission_real standstill_speed; /* friction velocities below this are none (rad/s) */
    transmission_real sample_time; /* step of the plant (s) */
} transmission_plant_params;

/* Inputs of a step. */
typedef struct {
    transmission_real M1_torque_ref; /* air-gap torque reference of M1 (N m) */
    transmission_real M2_torque_ref; /* air-gap torque reference of M2 (N m) */
    transmission_real converter_lockup_actuation; /* actuation of converter.lockup, 0 to 1 */
    transmission_real gears_clutch1_actuation; /* actuation of gears.clutch1, 0 to 1 */
    transmission_real gears_clutch2_actuation; /* actuation of gears.clutch2, 0 to 1 */
    transmission_real gears_ratio1; /* input speed over output speed behind the first clutch */
    transmission_real gears_ratio2; /* input speed over output speed behind the second clutch */
} transmission_plant_inputs;

/* Outputs of a step; torques are positive when they drive the right-hand neighbour. */
typedef struct {
    transmission_real M1_speed; /* measured or observed, positive to the right (rad/s) */
    transmission_real flange1_torque; /* measured or observed, positive to the right (N m) */
    transmission_real flange2_torque; /* measured or observed, positive to the right (N m) */
    transmission_real M2_speed; /* measured or observed, positive to the right (rad/s) */
    transmission_real gears_input_torque; /* measured or observed, positive to the right (N m) */
    transmission_real M1_torque; /* air-gap torque of M1 (N m) */
    transmission_real M2_torque; /* air-gap torque of M2 (N m) */
    transmission_real converter_lockup_torque; /* torque of the friction element converter.lockup (N m) */
    transmission_real converter_lockup_speed; /* velocity of the friction element converter.lockup (rad/s) */
    transmission_real gears_clutch1_torque; /* torque of the friction element gears.clutch1 (N m) */
    transmission_real gears_clutch1_speed; /* velocity of the friction element gears.clutch1 (rad/s) */
    transmission_real gears_clutch2_torque; /* torque of the friction element gears.clutch2 (N m) */
    transmission_real gears_clutch2_speed; /* velocity of the friction element gears.clutch2 (rad/s) */
    transmission_real converter_fluid_pump_torque; /* torque that converter.fluid takes from the pump (N m) */
    transmission_real converter_fluid_turbine_torque; /* torque that converter.fluid exerts on the turbine (N m) */
} transmission_plant_outputs;

/* States first, then what follows from the parameters. Matrices are stored by columns. */
typedef struct {
    transmission_real x[20]; /* velocities, twists, air-gap torques; then the commands that act late and early: */
    /*   [0] velocity of converter.lockup (rad/s) */
    /*   [1] velocity of M1.shaft (rad/s) */
    /*   [2] velocity of M2.shaft (rad/s) */
    /*   [3] velocity of flange1.uut (rad/s) */
    /*   [4] velocity of converter.pump (rad/s) */
    /*   [5] velocity of gears.output (rad/s) */
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
    transmission_real M1_delay[16]; /* commands to M1 of past steps (N m) */
    transmission_real M2_delay[16]; /* commands to M2 of past steps (N m) */
    transmission_real fluid_torque[4]; /* torques of fluids at the end of the step (N m): */
    /*   [0] converter_fluid_pump_torque */
    /*   [1] converter_fluid_turbine_torque */
    transmission_real gears_ratio1_now; /* input speed over output speed behind the first clutch, in the last step */
    transmission_real gears_ratio2_now; /* input speed over output speed behind the second clutch, in the last step */
    transmission_real friction_torque[4]; /* friction torques at the end of the step (N m): */
    /*   [0] converter.lockup */
    /*   [1] gears.clutch1 */
    /*   [2] gears.clutch2 */
    transmission_real friction_rest[4]; /* capacities at rest in the last step (N m): */
    /*   [0] converter.lockup */
    /*   [1] gears.clutch1 */
    /*   [2] gears.clutch2 */
    transmission_real friction_status; /* 0, or what was wrong with the friction of the last step */
    transmission_real contact_torque[4]; /* torques of shafts with backlash at the end of the step (N m): */
    /*   [0] shaft1 */
    /*   [1] shaft2 */
    transmission_real transition[17][16]; /* x at the end of the step without friction torques */
    transmission_real M1_dead_steps; /* whole steps of dead time */
    transmission_real M2_dead_steps; /* whole steps of dead time */
    transmission_real gears_input_torque_reaction[20]; /* gears_input_torque per velocity, twist, input, friction and contact, fluid */
    transmission_real gears_input_torque_pressed[4]; /* gears_input_torque per friction torque on a coordinate */
    transmission_real gamma[7][16]; /* x at the end of the step per friction, contact and fluid torque */
    transmission_real velocity_rounding; /* share of a sum of velocities that is rounding */
    transmission_real K[3][4]; /* friction velocities lost per mean friction torque (rad/(N m s)) */
    transmission_real gamma_pressed[3][16]; /* x at the end of the step per friction torque on a coordinate */
    transmission_real K_base[4][4]; /* the same for the elements that others are put together from (rad/(N m s)) */
    transmission_real kappa[2][4]; /* twist lost over the step per torque (rad/(N m)) */
    transmission_real half_gap[4]; /* half of the gaps (rad) */
    transmission_real contact_stiffness[4]; /* stiffness beyond the gaps (N m/rad) */
    transmission_real contact_damping[4]; /* damping over the step (N m/rad) */
} transmission_plant_state;

typedef enum {
    transmission_plant_ok = 0,
    transmission_plant_mass_matrix = 1001,
    transmission_plant_exponential_range = 1002,
    transmission_plant_friction_matrix = 1003,
    transmission_plant_bad_input_M1_torque_ref = 1100, /* is not finite */
    transmission_plant_bad_input_M2_torque_ref = 1101, /* is not finite */
    transmission_plant_bad_input_converter_lockup_actuation = 1102, /* is outside its range 0 to 1 */
    transmission_plant_bad_input_gears_clutch1_actuation = 1103, /* is outside its range 0 to 1 */
    transmission_plant_bad_input_gears_clutch2_actuation = 1104, /* is outside its range 0 to 1 */
    transmission_plant_bad_input_gears_ratio1 = 1105, /* is outside its range -4.932 to 5.503 */
    transmission_plant_bad_input_gears_ratio2 = 1106, /* is outside its range -4.932 to 5.503 */
    transmission_plant_friction_unsolved = 1501, /* the friction torques are not exact */
    transmission_plant_bad_capacity_converter_lockup = 1502, /* the capacity of converter.lockup is no number from 0 up; it was taken as 0 */
    transmission_plant_bad_capacity_gears_clutch1 = 1503, /* the capacity of gears.clutch1 is no number from 0 up; it was taken as 0 */
    transmission_plant_bad_capacity_gears_clutch2 = 1504, /* the capacity of gears.clutch2 is no number from 0 up; it was taken as 0 */
    transmission_plant_bad_M1_inertia = 2000, /* outside its range */
    transmission_plant_bad_M1_torque_max = 2001, /* outside its range */
    transmission_plant_bad_M1_speed_rated = 2002, /* outside its range */
    transmission_plant_bad_M1_inverter_dead_time = 2003, /* outside its range */
    transmission_plant_bad_M1_inverter_time_constant = 2004, /* outside its range */
    transmission_plant_bad_flange1_inertia = 2005, /* outside its range */
    transmission_plant_bad_flange1_stiffness = 2006, /* outside its range */
    transmission_plant_bad_flange1_damping = 2007, /* outside its range */
    transmission_plant_bad_shaft1_stiffness = 2008, /* outside its range */
    transmission_plant_bad_shaft1_damping = 2009, /* outside its range */
    transmission_plant_bad_shaft1_backlash = 2010, /* outside its range */
    transmission_plant_bad_converter_inertia_pump = 2011, /* outside its range */
    transmission_plant_bad_converter_inertia_turbine = 2012, /* outside its range */
    transmission_plant_bad_converter_reference_speed = 2013, /* outside its range */
    transmission_plant_bad_converter_lockup_static = 2014, /* outside its range */
    transmission_plant_bad_converter_lockup_stribeck_speed = 2015, /* outside its range */
    transmission_plant_bad_converter_lockup_viscous = 2016, /* outside its range */
    transmission_plant_bad_converter_lockup_capacity = 2017, /* outside its range */
    transmission_plant_bad_gears_inertia_input = 2018, /* outside its range */
    transmission_plant_bad_gears_inertia_output = 2019, /* outside its range */
    transmission_plant_bad_gears_clutch1_static = 2020, /* outside its range */
    transmission_plant_bad_gears_clutch1_stribeck_speed = 2021, /* outside its range */
    transmission_plant_bad_gears_clutch1_viscous = 2022, /* outside its range */
    transmission_plant_bad_gears_clutch1_capacity = 2023, /* outside its range */
    transmission_plant_bad_gears_clutch2_static = 2024, /* outside its range */
    transmission_plant_bad_gears_clutch2_stribeck_speed = 2025, /* outside its range */
    transmission_plant_bad_gears_clutch2_viscous = 2026, /* outside its range */
    transmission_plant_bad_gears_clutch2_capacity = 2027, /* outside its range */
    transmission_plant_bad_shaft2_stiffness = 2028, /* outside its range */
    transmission_plant_bad_shaft2_damping = 2029, /* outside its range */
    transmission_plant_bad_shaft2_backlash = 2030, /* outside its range */
    transmission_plant_bad_flange2_inertia = 2031, /* outside its range */
    transmission_plant_bad_flange2_stiffness = 2032, /* outside its range */
    transmission_plant_bad_flange2_damping = 2033, /* outside its range */
    transmission_plant_bad_M2_inertia = 2034, /* outside its range */
    transmission_plant_bad_M2_torque_max = 2035, /* outside its range */
    transmission_plant_bad_M2_speed_rated = 2036, /* outside its range */
    transmission_plant_bad_M2_inverter_dead_time = 2037, /* outside its range */
    transmission_plant_bad_M2_inverter_time_constant = 2038, /* outside its range */
    transmission_plant_bad_standstill_speed = 2039, /* outside its range */
    transmission_plant_bad_sample_time = 2040, /* outside its range */
} transmission_plant_status;

extern const transmission_plant_params transmission_plant_defaults;

/* Name of a status, for logs. */
const char *transmission_plant_status_text(transmission_plant_status status);

/* Sets the initial state and prepares everything that follows from the parameters. */
transmission_plant_status transmission_plant_init(transmission_plant_state *state, const transmission_plant_params *params);

/* Checks the parameters and prepares what follows from them; the rest of the state stays. */
transmission_plant_status transmission_plant_update(transmission_plant_state *state, const transmission_plant_params *params);

/* One step. After a bad input the state is as it was, and the outputs are those of that state. */
transmission_plant_status transmission_plant_step(transmission_plant_state *state, const transmission_plant_params *params,
    const transmission_plant_inputs *inputs, transmission_plant_outputs *outputs);

/* Outputs of the present state, as at the end of a step. */
void transmission_plant_measure(const transmission_plant_state *state, const transmission_plant_params *params,
    transmission_plant_outputs *outputs);

#endif
