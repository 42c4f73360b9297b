/*
 * shift_rig_plant.h: plant of the bed shift_rig
 *
 * Emitted by ptgen 0.1.0 from shift-rig.toml (SHA-256 627f699c509849a3), template block.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef SHIFT_RIG_PLANT_H
#define SHIFT_RIG_PLANT_H

#include "shift_rig_support.h"

/* Parameters, in SI units; call shift_rig_plant_update after a change. */
typedef struct {
    shift_rig_real M1_inertia; /* moment of inertia of the rotor (kg m^2) */
    shift_rig_real M1_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    shift_rig_real M1_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    shift_rig_real M1_inverter_dead_time; /* dead time of the torque loop (s) */
    shift_rig_real M1_inverter_time_constant; /* time constant of the torque loop (s) */
    shift_rig_real flange1_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    shift_rig_real flange1_stiffness; /* torsional stiffness c_f (N m/rad) */
    shift_rig_real flange1_damping; /* internal damping d_f (N m s/rad) */
    shift_rig_real shaft1_stiffness; /* torsional stiffness c_s (N m/rad) */
    shift_rig_real shaft1_damping; /* internal damping d_s (N m s/rad) */
    shift_rig_real gears_P1_ratio; /* ratio g of the ring's to the sun's radius or teeth */
    shift_rig_real gears_P1_inertia_sun; /* moment of inertia I_s of the sun gear (kg m^2) */
    shift_rig_real gears_P1_inertia_ring; /* moment of inertia I_r of the ring gear (kg m^2) */
    shift_rig_real gears_P1_inertia_carrier; /* moment of inertia I_c of carrier and planets about the main axis (kg m^2) */
    shift_rig_real gears_P1_inertia_planets; /* moment of inertia of all planets about their own axes, n_p I_p (kg m^2) */
    shift_rig_real gears_P2_ratio; /* ratio g of the ring's to the sun's radius or teeth */
    shift_rig_real gears_P2_inertia_sun; /* moment of inertia I_s of the sun gear (kg m^2) */
    shift_rig_real gears_P2_inertia_ring; /* moment of inertia I_r of the ring gear (kg m^2) */
    shift_rig_real gears_P2_inertia_carrier; /* moment of inertia I_c of carrier and planets about the main axis (kg m^2) */
    shift_rig_real gears_P2_inertia_planets; /* moment of inertia of all planets about their own axes, n_p I_p (kg m^2) */
    shift_rig_real gears_P3_ratio; /* ratio g of the ring's to the sun's radius or teeth */
    shift_rig_real gears_P3_inertia_sun; /* moment of inertia I_s of the sun gear (kg m^2) */
    shift_rig_real gears_P3_inertia_ring; /* moment of inertia I_r of the ring gear (kg m^2) */
    shift_rig_real gears_P3_inertia_carrier; /* moment of inertia I_c of carrier and planets about the main axis (kg m^2) */
    shift_rig_real gears_P3_inertia_planets; /* moment of inertia of all planets about their own axes, n_p I_p (kg m^2) */
    shift_rig_real gears_P4_ratio; /* ratio g of the ring's to the sun's radius or teeth */
    shift_rig_real gears_P4_inertia_sun; /* moment of inertia I_s of the sun gear (kg m^2) */
    shift_rig_real gears_P4_inertia_ring; /* moment of inertia I_r of the ring gear (kg m^2) */
    shift_rig_real gears_P4_inertia_carrier; /* moment of inertia I_c of carrier and planets about the main axis (kg m^2) */
    shift_rig_real gears_P4_inertia_planets; /* moment of inertia of all planets about their own axes, n_p I_p (kg m^2) */
    shift_rig_real gears_A_viscous; /* viscous friction k_c,v (N m s/rad) */
    shift_rig_real gears_A_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    shift_rig_real gears_B_viscous; /* viscous friction k_c,v (N m s/rad) */
    shift_rig_real gears_B_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    shift_rig_real gears_C_viscous; /* viscous friction k_c,v (N m s/rad) */
    shift_rig_real gears_C_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    shift_rig_real gears_D_viscous; /* viscous friction k_c,v (N m s/rad) */
    shift_rig_real gears_D_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    shift_rig_real gears_E_viscous; /* viscous friction k_c,v (N m s/rad) */
    shift_rig_real gears_E_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    shift_rig_real gears_F_viscous; /* viscous friction k_c,v (N m s/rad) */
    shift_rig_real gears_F_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    shift_rig_real gears_input_inertia; /* moment of inertia of the member (kg m^2) */
    shift_rig_real gears_a_inertia; /* moment of inertia of the member (kg m^2) */
    shift_rig_real gears_b_inertia; /* moment of inertia of the member (kg m^2) */
    shift_rig_real gears_output_inertia; /* moment of inertia of the member (kg m^2) */
    shift_rig_real gears_carrier1_inertia; /* moment of inertia of the member (kg m^2) */
    shift_rig_real gears_sun2_inertia; /* moment of inertia of the member (kg m^2) */
    shift_rig_real gears_ring3_inertia; /* moment of inertia of the member (kg m^2) */
    shift_rig_real gears_carrier4_inertia; /* moment of inertia of the member (kg m^2) */
    shift_rig_real shaft2_stiffness; /* torsional stiffness c_s (N m/rad) */
    shift_rig_real shaft2_damping; /* internal damping d_s (N m s/rad) */
    shift_rig_real flange2_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    shift_rig_real flange2_stiffness; /* torsional stiffness c_f (N m/rad) */
    shift_rig_real flange2_damping; /* internal damping d_f (N m s/rad) */
    shift_rig_real M2_inertia; /* moment of inertia of the rotor (kg m^2) */
    shift_rig_real M2_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    shift_rig_real M2_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    shift_rig_real M2_inverter_dead_time; /* dead time of the torque loop (s) */
    shift_rig_real M2_inverter_time_constant; /* time constant of the torque loop (s) */
    shift_rig_real standstill_speed; /* friction velocities below this are none (rad/s) */
    shift_rig_real sample_time; /* step of the plant (s) */
} shift_rig_plant_params;

/* Inputs of a step. */
typedef struct {
    shift_rig_real M1_torque_ref; /* air-gap torque reference of M1 (N m) */
    shift_rig_real M2_torque_ref; /* air-gap torque reference of M2 (N m) */
    shift_rig_real gears_A_actuation; /* actuation of gears.A, 0 to 1 */
    shift_rig_real gears_B_actuation; /* actuation of gears.B, 0 to 1 */
    shift_rig_real gears_C_actuation; /* actuation of gears.C, 0 to 1 */
    shift_rig_real gears_D_actuation; /* actuation of gears.D, 0 to 1 */
    shift_rig_real gears_E_actuation; /* actuation of gears.E, 0 to 1 */
    shift_rig_real gears_F_actuation; /* actuation of gears.F, 0 to 1 */
} shift_rig_plant_inputs;

/* Outputs of a step; torques are positive when they drive the right-hand neighbour. */
typedef struct {
    shift_rig_real M1_speed; /* measured or observed, positive to the right (rad/s) */
    shift_rig_real flange1_torque; /* measured or observed, positive to the right (N m) */
    shift_rig_real flange2_torque; /* measured or observed, positive to the right (N m) */
    shift_rig_real M2_speed; /* measured or observed, positive to the right (rad/s) */
    shift_rig_real M1_torque; /* air-gap torque of M1 (N m) */
    shift_rig_real M2_torque; /* air-gap torque of M2 (N m) */
    shift_rig_real gears_A_torque; /* torque of the friction element gears.A (N m) */
    shift_rig_real gears_A_speed; /* velocity of the friction element gears.A (rad/s) */
    shift_rig_real gears_B_torque; /* torque of the friction element gears.B (N m) */
    shift_rig_real gears_B_speed; /* velocity of the friction element gears.B (rad/s) */
    shift_rig_real gears_C_torque; /* torque of the friction element gears.C (N m) */
    shift_rig_real gears_C_speed; /* velocity of the friction element gears.C (rad/s) */
    shift_rig_real gears_D_torque; /* torque of the friction element gears.D (N m) */
    shift_rig_real gears_D_speed; /* velocity of the friction element gears.D (rad/s) */
    shift_rig_real gears_E_torque; /* torque of the friction element gears.E (N m) */
    shift_rig_real gears_E_speed; /* velocity of the friction element gears.E (rad/s) */
    shift_rig_real gears_F_torque; /* torque of the friction element gears.F (N m) */
    shift_rig_real gears_F_speed; /* velocity of the friction element gears.F (rad/s) */
} shift_rig_plant_outputs;

/* States first, then what follows from the parameters. Matrices are stored by columns. */
typedef struct {
    shift_rig_real x[20]; /* velocities, twists, air-gap torques; then the commands that act late and early: */
    /*   [0] velocity of gears.A.left (rad/s) */
    /*   [1] velocity of gears.B.left (rad/s) */
    /*   [2] velocity of gears.C.left (rad/s) */
    /*   [3] velocity of gears.D (rad/s) */
    /*   [4] velocity of M1.shaft (rad/s) */
    /*   [5] velocity of M2.shaft (rad/s) */
    /*   [6] velocity of flange1.uut (rad/s) */
    /*   [7] velocity of flange2.uut (rad/s) */
    /*   [8] twist of flange1 (rad) */
    /*   [9] twist of shaft1 (rad) */
    /*   [10] twist of shaft2 (rad) */
    /*   [11] twist of flange2 (rad) */
    /*   [12] air-gap torque of M1 (N m) */
    /*   [13] air-gap torque of M2 (N m) */
    /*   [14] late command to M1 (N m) */
    /*   [15] late command to M2 (N m) */
    /*   [16] early command to M1 (N m) */
    /*   [17] early command to M2 (N m) */
    shift_rig_real M1_delay[16]; /* commands to M1 of past steps (N m) */
    shift_rig_real M2_delay[16]; /* commands to M2 of past steps (N m) */
    shift_rig_real friction_torque[8]; /* friction torques at the end of the step (N m): */
    /*   [0] gears.A */
    /*   [1] gears.B */
    /*   [2] gears.C */
    /*   [3] gears.D */
    /*   [4] gears.E */
    /*   [5] gears.F */
    shift_rig_real friction_rest[8]; /* capacities at rest in the last step (N m): */
    /*   [0] gears.A */
    /*   [1] gears.B */
    /*   [2] gears.C */
    /*   [3] gears.D */
    /*   [4] gears.E */
    /*   [5] gears.F */
    shift_rig_real friction_status; /* 0, or what was wrong with the friction of the last step */
    shift_rig_real transition[18][16]; /* x at the end of the step without friction torques */
    shift_rig_real M1_dead_steps; /* whole steps of dead time */
    shift_rig_real M2_dead_steps; /* whole steps of dead time */
    shift_rig_real G[8][8]; /* friction velocities per velocity */
    shift_rig_real gamma[6][16]; /* x at the end of the step per friction and contact torque */
    shift_rig_real velocity_rounding; /* share of a sum of velocities that is rounding */
    shift_rig_real K[6][8]; /* friction velocities lost per mean friction torque (rad/(N m s)) */
} shift_rig_plant_state;

typedef enum {
    shift_rig_plant_ok = 0,
    shift_rig_plant_mass_matrix = 1001,
    shift_rig_plant_exponential_range = 1002,
    shift_rig_plant_friction_matrix = 1003,
    shift_rig_plant_bad_input_M1_torque_ref = 1100, /* is not finite */
    shift_rig_plant_bad_input_M2_torque_ref = 1101, /* is not finite */
    shift_rig_plant_bad_input_gears_A_actuation = 1102, /* is outside its range 0 to 1 */
    shift_rig_plant_bad_input_gears_B_actuation = 1103, /* is outside its range 0 to 1 */
    shift_rig_plant_bad_input_gears_C_actuation = 1104, /* is outside its range 0 to 1 */
    shift_rig_plant_bad_input_gears_D_actuation = 1105, /* is outside its range 0 to 1 */
    shift_rig_plant_bad_input_gears_E_actuation = 1106, /* is outside its range 0 to 1 */
    shift_rig_plant_bad_input_gears_F_actuation = 1107, /* is outside its range 0 to 1 */
    shift_rig_plant_friction_unsolved = 1501, /* the friction torques are not exact */
    shift_rig_plant_bad_capacity_gears_A = 1502, /* the capacity of gears.A is no number from 0 up; it was taken as 0 */
    shift_rig_plant_bad_capacity_gears_B = 1503, /* the capacity of gears.B is no number from 0 up; it was taken as 0 */
    shift_rig_plant_bad_capacity_gears_C = 1504, /* the capacity of gears.C is no number from 0 up; it was taken as 0 */
    shift_rig_plant_bad_capacity_gears_D = 1505, /* the capacity of gears.D is no number from 0 up; it was taken as 0 */
    shift_rig_plant_bad_capacity_gears_E = 1506, /* the capacity of gears.E is no number from 0 up; it was taken as 0 */
    shift_rig_plant_bad_capacity_gears_F = 1507, /* the capacity of gears.F is no number from 0 up; it was taken as 0 */
    shift_rig_plant_bad_M1_inertia = 2000, /* outside its range */
    shift_rig_plant_bad_M1_torque_max = 2001, /* outside its range */
    shift_rig_plant_bad_M1_speed_rated = 2002, /* outside its range */
    shift_rig_plant_bad_M1_inverter_dead_time = 2003, /* outside its range */
    shift_rig_plant_bad_M1_inverter_time_constant = 2004, /* outside its range */
    shift_rig_plant_bad_flange1_inertia = 2005, /* outside its range */
    shift_rig_plant_bad_flange1_stiffness = 2006, /* outside its range */
    shift_rig_plant_bad_flange1_damping = 2007, /* outside its range */
    shift_rig_plant_bad_shaft1_stiffness = 2008, /* outside its range */
    shift_rig_plant_bad_shaft1_damping = 2009, /* outside its range */
    shift_rig_plant_bad_gears_P1_ratio = 2010, /* outside its range */
    shift_rig_plant_bad_gears_P1_inertia_sun = 2011, /* outside its range */
    shift_rig_plant_bad_gears_P1_inertia_ring = 2012, /* outside its range */
    shift_rig_plant_bad_gears_P1_inertia_carrier = 2013, /* outside its range */
    shift_rig_plant_bad_gears_P1_inertia_planets = 2014, /* outside its range */
    shift_rig_plant_bad_gears_P2_ratio = 2015, /* outside its range */
    shift_rig_plant_bad_gears_P2_inertia_sun = 2016, /* outside its range */
    shift_rig_plant_bad_gears_P2_inertia_ring = 2017, /* outside its range */
    shift_rig_plant_bad_gears_P2_inertia_carrier = 2018, /* outside its range */
    shift_rig_plant_bad_gears_P2_inertia_planets = 2019, /* outside its range */
    shift_rig_plant_bad_gears_P3_ratio = 2020, /* outside its range */
    shift_rig_plant_bad_gears_P3_inertia_sun = 2021, /* outside its range */
    shift_rig_plant_bad_gears_P3_inertia_ring = 2022, /* outside its range */
    shift_rig_plant_bad_gears_P3_inertia_carrier = 2023, /* outside its range */
    shift_rig_plant_bad_gears_P3_inertia_planets = 2024, /* outside its range */
    shift_rig_plant_bad_gears_P4_ratio = 2025, /* outside its range */
    shift_rig_plant_bad_gears_P4_inertia_sun = 2026, /* outside its range */
    shift_rig_plant_bad_gears_P4_inertia_ring = 2027, /* outside its range */
    shift_rig_plant_bad_gears_P4_inertia_carrier = 2028, /* outside its range */
    shift_rig_plant_bad_gears_P4_inertia_planets = 2029, /* outside its range */
    shift_rig_plant_bad_gears_A_viscous = 2030, /* outside its range */
    shift_rig_plant_bad_gears_A_capacity = 2031, /* outside its range */
    shift_rig_plant_bad_gears_B_viscous = 2032, /* outside its range */
    shift_rig_plant_bad_gears_B_capacity = 2033, /* outside its range */
    shift_rig_plant_bad_gears_C_viscous = 2034, /* outside its range */
    shift_rig_plant_bad_gears_C_capacity = 2035, /* outside its range */
    shift_rig_plant_bad_gears_D_viscous = 2036, /* outside its range */
    shift_rig_plant_bad_gears_D_capacity = 2037, /* outside its range */
    shift_rig_plant_bad_gears_E_viscous = 2038, /* outside its range */
    shift_rig_plant_bad_gears_E_capacity = 2039, /* outside its range */
    shift_rig_plant_bad_gears_F_viscous = 2040, /* outside its range */
    shift_rig_plant_bad_gears_F_capacity = 2041, /* outside its range */
    shift_rig_plant_bad_gears_input_inertia = 2042, /* outside its range */
    shift_rig_plant_bad_gears_a_inertia = 2043, /* outside its range */
    shift_rig_plant_bad_gears_b_inertia = 2044, /* outside its range */
    shift_rig_plant_bad_gears_output_inertia = 2045, /* outside its range */
    shift_rig_plant_bad_gears_carrier1_inertia = 2046, /* outside its range */
    shift_rig_plant_bad_gears_sun2_inertia = 2047, /* outside its range */
    shift_rig_plant_bad_gears_ring3_inertia = 2048, /* outside its range */
    shift_rig_plant_bad_gears_carrier4_inertia = 2049, /* outside its range */
    shift_rig_plant_bad_shaft2_stiffness = 2050, /* outside its range */
    shift_rig_plant_bad_shaft2_damping = 2051, /* outside its range */
    shift_rig_plant_bad_flange2_inertia = 2052, /* outside its range */
    shift_rig_plant_bad_flange2_stiffness = 2053, /* outside its range */
    shift_rig_plant_bad_flange2_damping = 2054, /* outside its range */
    shift_rig_plant_bad_M2_inertia = 2055, /* outside its range */
    shift_rig_plant_bad_M2_torque_max = 2056, /* outside its range */
    shift_rig_plant_bad_M2_speed_rated = 2057, /* outside its range */
    shift_rig_plant_bad_M2_inverter_dead_time = 2058, /* outside its range */
    shift_rig_plant_bad_M2_inverter_time_constant = 2059, /* outside its range */
    shift_rig_plant_bad_standstill_speed = 2060, /* outside its range */
    shift_rig_plant_bad_sample_time = 2061, /* outside its range */
} shift_rig_plant_status;

extern const shift_rig_plant_params shift_rig_plant_defaults;

/* Name of a status, for logs. */
const char *shift_rig_plant_status_text(shift_rig_plant_status status);

/* Sets the initial state and prepares everything that follows from the parameters. */
shift_rig_plant_status shift_rig_plant_init(shift_rig_plant_state *state, const shift_rig_plant_params *params);

/* Checks the parameters and prepares what follows from them; the rest of the state stays. */
shift_rig_plant_status shift_rig_plant_update(shift_rig_plant_state *state, const shift_rig_plant_params *params);

/* One step. After a bad input the state is as it was, and the outputs are those of that state. */
shift_rig_plant_status shift_rig_plant_step(shift_rig_plant_state *state, const shift_rig_plant_params *params,
    const shift_rig_plant_inputs *inputs, shift_rig_plant_outputs *outputs);

/* Outputs of the present state, as at the end of a step. */
void shift_rig_plant_measure(const shift_rig_plant_state *state, const shift_rig_plant_params *params,
    shift_rig_plant_outputs *outputs);

#endif
