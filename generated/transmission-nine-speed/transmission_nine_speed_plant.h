/*
 * transmission_nine_speed_plant.h: plant of the bed transmission_nine_speed
 *
 * Emitted by ptgen 0.1.0 from transmission-nine-speed.toml (SHA-256 65236af78ec41a0c), template block.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef TRANSMISSION_NINE_SPEED_PLANT_H
#define TRANSMISSION_NINE_SPEED_PLANT_H

#include "transmission_nine_speed_support.h"

/* Parameters, in SI units; call transmission_nine_speed_plant_update after a change. */
typedef struct {
    transmission_nine_speed_real M1_inertia; /* moment of inertia of the rotor (kg m^2) */
    transmission_nine_speed_real M1_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    transmission_nine_speed_real M1_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    transmission_nine_speed_real M1_inverter_dead_time; /* dead time of the torque loop (s) */
    transmission_nine_speed_real M1_inverter_time_constant; /* time constant of the torque loop (s) */
    transmission_nine_speed_real flange1_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    transmission_nine_speed_real flange1_stiffness; /* torsional stiffness c_f (N m/rad) */
    transmission_nine_speed_real flange1_damping; /* internal damping d_f (N m s/rad) */
    transmission_nine_speed_real shaft1_stiffness; /* torsional stiffness c_s (N m/rad) */
    transmission_nine_speed_real shaft1_damping; /* internal damping d_s (N m s/rad) */
    transmission_nine_speed_real shaft1_backlash; /* full width theta_bl of the gap (rad) */
    transmission_nine_speed_real converter_inertia_pump; /* moment of inertia I_p of the pump (kg m^2) */
    transmission_nine_speed_real converter_inertia_turbine; /* moment of inertia I_t of the turbine (kg m^2) */
    transmission_nine_speed_real converter_reference_speed; /* speed omega_pc of the faster wheel for which the maps hold (rad/s) */
    transmission_nine_speed_real converter_lockup_static; /* largest torque T_c,s that it holds at rest (N m) */
    transmission_nine_speed_real converter_lockup_stribeck_speed; /* velocity omega_c,s over which the torque falls from static (rad/s) */
    transmission_nine_speed_real converter_lockup_viscous; /* viscous friction k_c,v (N m s/rad) */
    transmission_nine_speed_real converter_lockup_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    transmission_nine_speed_real gears_P1_ratio; /* ratio g of the ring's to the sun's radius or teeth */
    transmission_nine_speed_real gears_P1_inertia_sun; /* moment of inertia I_s of the sun gear (kg m^2) */
    transmission_nine_speed_real gears_P1_inertia_ring; /* moment of inertia I_r of the ring gear (kg m^2) */
    transmission_nine_speed_real gears_P1_inertia_carrier; /* moment of inertia I_c of carrier and planets about the main axis (kg m^2) */
    transmission_nine_speed_real gears_P1_inertia_planets; /* moment of inertia of all planets about their own axes, n_p I_p (kg m^2) */
    transmission_nine_speed_real gears_P2_ratio; /* ratio g of the ring's to the sun's radius or teeth */
    transmission_nine_speed_real gears_P2_inertia_sun; /* moment of inertia I_s of the sun gear (kg m^2) */
    transmission_nine_speed_real gears_P2_inertia_ring; /* moment of inertia I_r of the ring gear (kg m^2) */
    transmission_nine_speed_real gears_P2_inertia_carrier; /* moment of inertia I_c of carrier and planets about the main axis (kg m^2) */
    transmission_nine_speed_real gears_P2_inertia_planets; /* moment of inertia of all planets about their own axes, n_p I_p (kg m^2) */
    transmission_nine_speed_real gears_P3_ratio; /* ratio g of the ring's to the sun's radius or teeth */
    transmission_nine_speed_real gears_P3_inertia_sun; /* moment of inertia I_s of the sun gear (kg m^2) */
    transmission_nine_speed_real gears_P3_inertia_ring; /* moment of inertia I_r of the ring gear (kg m^2) */
    transmission_nine_speed_real gears_P3_inertia_carrier; /* moment of inertia I_c of carrier and planets about the main axis (kg m^2) */
    transmission_nine_speed_real gears_P3_inertia_planets; /* moment of inertia of all planets about their own axes, n_p I_p (kg m^2) */
    transmission_nine_speed_real gears_P4_ratio; /* ratio g of the ring's to the sun's radius or teeth */
    transmission_nine_speed_real gears_P4_inertia_sun; /* moment of inertia I_s of the sun gear (kg m^2) */
    transmission_nine_speed_real gears_P4_inertia_ring; /* moment of inertia I_r of the ring gear (kg m^2) */
    transmission_nine_speed_real gears_P4_inertia_carrier; /* moment of inertia I_c of carrier and planets about the main axis (kg m^2) */
    transmission_nine_speed_real gears_P4_inertia_planets; /* moment of inertia of all planets about their own axes, n_p I_p (kg m^2) */
    transmission_nine_speed_real gears_A_viscous; /* viscous friction k_c,v (N m s/rad) */
    transmission_nine_speed_real gears_A_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    transmission_nine_speed_real gears_B_viscous; /* viscous friction k_c,v (N m s/rad) */
    transmission_nine_speed_real gears_B_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    transmission_nine_speed_real gears_C_viscous; /* viscous friction k_c,v (N m s/rad) */
    transmission_nine_speed_real gears_C_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    transmission_nine_speed_real gears_D_viscous; /* viscous friction k_c,v (N m s/rad) */
    transmission_nine_speed_real gears_D_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    transmission_nine_speed_real gears_E_viscous; /* viscous friction k_c,v (N m s/rad) */
    transmission_nine_speed_real gears_E_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    transmission_nine_speed_real gears_F_viscous; /* viscous friction k_c,v (N m s/rad) */
    transmission_nine_speed_real gears_F_capacity; /* Coulomb torque T_c,c at full actuation (N m) */
    transmission_nine_speed_real gears_input_inertia; /* moment of inertia of the member (kg m^2) */
    transmission_nine_speed_real gears_a_inertia; /* moment of inertia of the member (kg m^2) */
    transmission_nine_speed_real gears_b_inertia; /* moment of inertia of the member (kg m^2) */
    transmission_nine_speed_real gears_output_inertia; /* moment of inertia of the member (kg m^2) */
    transmission_nine_speed_real gears_carrier1_inertia; /* moment of inertia of the member (kg m^2) */
    transmission_nine_speed_real gears_sun2_inertia; /* moment of inertia of the member (kg m^2) */
    transmission_nine_speed_real gears_ring3_inertia; /* moment of inertia of the member (kg m^2) */
    transmission_nine_speed_real gears_carrier4_inertia; /* moment of inertia of the member (kg m^2) */
    transmission_nine_speed_real shaft2_stiffness; /* torsional stiffness c_s (N m/rad) */
    transmission_nine_speed_real shaft2_damping; /* internal damping d_s (N m s/rad) */
    transmission_nine_speed_real shaft2_backlash; /* full width theta_bl of the gap (rad) */
    transmission_nine_speed_real flange2_inertia; /* moment of inertia on the side of the unit under test (kg m^2) */
    transmission_nine_speed_real flange2_stiffness; /* torsional stiffness c_f (N m/rad) */
    transmission_nine_speed_real flange2_damping; /* internal damping d_f (N m s/rad) */
    transmission_nine_speed_real M2_inertia; /* moment of inertia of the rotor (kg m^2) */
    transmission_nine_speed_real M2_torque_max; /* largest air-gap torque up to the rated speed (N m) */
    transmission_nine_speed_real M2_speed_rated; /* speed up to which the largest torque is available (rad/s) */
    transmission_nine_speed_real M2_inverter_dead_time; /* dead time of the torque loop (s) */
    transmission_nine_speed_real M2_inverter_time_constant; /* time constant of the torque loop (s) */
    transmission_nine_speed_real standstill_speed; /* friction velocities below this are none (rad/s) */
    transmission_nine_speed_real sample_time; /* step of the plant (s) */
} transmission_nine_speed_plant_params;

/* Inputs of a step. */
typedef struct {
    transmission_nine_speed_real M1_torque_ref; /* air-gap torque reference of M1 (N m) */
    transmission_nine_speed_real M2_torque_ref; /* air-gap torque reference of M2 (N m) */
    transmission_nine_speed_real converter_lockup_actuation; /* actuation of converter.lockup, 0 to 1 */
    transmission_nine_speed_real gears_A_actuation; /* actuation of gears.A, 0 to 1 */
    transmission_nine_speed_real gears_B_actuation; /* actuation of gears.B, 0 to 1 */
    transmission_nine_speed_real gears_C_actuation; /* actuation of gears.C, 0 to 1 */
    transmission_nine_speed_real gears_D_actuation; /* actuation of gears.D, 0 to 1 */
    transmission_nine_speed_real gears_E_actuation; /* actuation of gears.E, 0 to 1 */
    transmission_nine_speed_real gears_F_actuation; /* actuation of gears.F, 0 to 1 */
} transmission_nine_speed_plant_inputs;

/* Outputs of a step; torques are positive when they drive the right-hand neighbour. */
typedef struct {
    transmission_nine_speed_real M1_speed; /* measured or observed, positive to the right (rad/s) */
    transmission_nine_speed_real flange1_torque; /* measured or observed, positive to the right (N m) */
    transmission_nine_speed_real flange2_torque; /* measured or observed, positive to the right (N m) */
    transmission_nine_speed_real M2_speed; /* measured or observed, positive to the right (rad/s) */
    transmission_nine_speed_real gears_input_torque; /* measured or observed, positive to the right (N m) */
    transmission_nine_speed_real M1_torque; /* air-gap torque of M1 (N m) */
    transmission_nine_speed_real M2_torque; /* air-gap torque of M2 (N m) */
    transmission_nine_speed_real converter_lockup_torque; /* torque of the friction element converter.lockup (N m) */
    transmission_nine_speed_real converter_lockup_speed; /* velocity of the friction element converter.lockup (rad/s) */
    transmission_nine_speed_real gears_A_torque; /* torque of the friction element gears.A (N m) */
    transmission_nine_speed_real gears_A_speed; /* velocity of the friction element gears.A (rad/s) */
    transmission_nine_speed_real gears_B_torque; /* torque of the friction element gears.B (N m) */
    transmission_nine_speed_real gears_B_speed; /* velocity of the friction element gears.B (rad/s) */
    transmission_nine_speed_real gears_C_torque; /* torque of the friction element gears.C (N m) */
    transmission_nine_speed_real gears_C_speed; /* velocity of the friction element gears.C (rad/s) */
    transmission_nine_speed_real gears_D_torque; /* torque of the friction element gears.D (N m) */
    transmission_nine_speed_real gears_D_speed; /* velocity of the friction element gears.D (rad/s) */
    transmission_nine_speed_real gears_E_torque; /* torque of the friction element gears.E (N m) */
    transmission_nine_speed_real gears_E_speed; /* velocity of the friction element gears.E (rad/s) */
    transmission_nine_speed_real gears_F_torque; /* torque of the friction element gears.F (N m) */
    transmission_nine_speed_real gears_F_speed; /* velocity of the friction element gears.F (rad/s) */
    transmission_nine_speed_real converter_fluid_pump_torque; /* torque that converter.fluid takes from the pump (N m) */
    transmission_nine_speed_real converter_fluid_turbine_torque; /* torque that converter.fluid exerts on the turbine (N m) */
} transmission_nine_speed_plant_outputs;

/* States first, then what follows from the parameters. Matrices are stored by columns. */
typedef struct {
    transmission_nine_speed_real x[20]; /* velocities, twists, air-gap torques; then the commands that act late and early: */
    /*   [0] velocity of converter.lockup (rad/s) */
    /*   [1] velocity of gears.A.left (rad/s) */
    /*   [2] velocity of gears.B.left (rad/s) */
    /*   [3] velocity of gears.C.left (rad/s) */
    /*   [4] velocity of gears.D (rad/s) */
    /*   [5] velocity of M1.shaft (rad/s) */
    /*   [6] velocity of M2.shaft (rad/s) */
    /*   [7] velocity of flange1.uut (rad/s) */
    /*   [8] velocity of flange2.uut (rad/s) */
    /*   [9] twist of flange1 (rad) */
    /*   [10] twist of shaft1 (rad) */
    /*   [11] twist of shaft2 (rad) */
    /*   [12] twist of flange2 (rad) */
    /*   [13] air-gap torque of M1 (N m) */
    /*   [14] air-gap torque of M2 (N m) */
    /*   [15] late command to M1 (N m) */
    /*   [16] late command to M2 (N m) */
    /*   [17] early command to M1 (N m) */
    /*   [18] early command to M2 (N m) */
    transmission_nine_speed_real M1_delay[16]; /* commands to M1 of past steps (N m) */
    transmission_nine_speed_real M2_delay[16]; /* commands to M2 of past steps (N m) */
    transmission_nine_speed_real fluid_torque[4]; /* torques of fluids at the end of the step (N m): */
    /*   [0] converter_fluid_pump_torque */
    /*   [1] converter_fluid_turbine_torque */
    transmission_nine_speed_real friction_torque[8]; /* friction torques at the end of the step (N m): */
    /*   [0] converter.lockup */
    /*   [1] gears.A */
    /*   [2] gears.B */
    /*   [3] gears.C */
    /*   [4] gears.D */
    /*   [5] gears.E */
    /*   [6] gears.F */
    transmission_nine_speed_real friction_rest[8]; /* capacities at rest in the last step (N m): */
    /*   [0] converter.lockup */
    /*   [1] gears.A */
    /*   [2] gears.B */
    /*   [3] gears.C */
    /*   [4] gears.D */
    /*   [5] gears.E */
    /*   [6] gears.F */
    transmission_nine_speed_real friction_status; /* 0, or what was wrong with the friction of the last step */
    transmission_nine_speed_real contact_torque[4]; /* torques of shafts with backlash at the end of the step (N m): */
    /*   [0] shaft1 */
    /*   [1] shaft2 */
    transmission_nine_speed_real transition[19][16]; /* x at the end of the step without friction torques */
    transmission_nine_speed_real M1_dead_steps; /* whole steps of dead time */
    transmission_nine_speed_real M2_dead_steps; /* whole steps of dead time */
    transmission_nine_speed_real G[9][8]; /* friction velocities per velocity */
    transmission_nine_speed_real L[4][4]; /* twists of shafts with backlash per twist */
    transmission_nine_speed_real gears_input_torque_reaction[28]; /* gears_input_torque per velocity, twist, input, friction and contact, fluid */
    transmission_nine_speed_real gamma[11][16]; /* x at the end of the step per friction, contact and fluid torque */
    transmission_nine_speed_real velocity_rounding; /* share of a sum of velocities that is rounding */
    transmission_nine_speed_real K[7][8]; /* friction velocities lost per mean friction torque (rad/(N m s)) */
    transmission_nine_speed_real kappa[2][4]; /* twist lost over the step per torque (rad/(N m)) */
    transmission_nine_speed_real half_gap[4]; /* half of the gaps (rad) */
    transmission_nine_speed_real contact_stiffness[4]; /* stiffness beyond the gaps (N m/rad) */
    transmission_nine_speed_real contact_damping[4]; /* damping over the step (N m/rad) */
} transmission_nine_speed_plant_state;

typedef enum {
    transmission_nine_speed_plant_ok = 0,
    transmission_nine_speed_plant_mass_matrix = 1001,
    transmission_nine_speed_plant_exponential_range = 1002,
    transmission_nine_speed_plant_friction_matrix = 1003,
    transmission_nine_speed_plant_bad_input_M1_torque_ref = 1100, /* is not finite */
    transmission_nine_speed_plant_bad_input_M2_torque_ref = 1101, /* is not finite */
    transmission_nine_speed_plant_bad_input_converter_lockup_actuation = 1102, /* is outside its range 0 to 1 */
    transmission_nine_speed_plant_bad_input_gears_A_actuation = 1103, /* is outside its range 0 to 1 */
    transmission_nine_speed_plant_bad_input_gears_B_actuation = 1104, /* is outside its range 0 to 1 */
    transmission_nine_speed_plant_bad_input_gears_C_actuation = 1105, /* is outside its range 0 to 1 */
    transmission_nine_speed_plant_bad_input_gears_D_actuation = 1106, /* is outside its range 0 to 1 */
    transmission_nine_speed_plant_bad_input_gears_E_actuation = 1107, /* is outside its range 0 to 1 */
    transmission_nine_speed_plant_bad_input_gears_F_actuation = 1108, /* is outside its range 0 to 1 */
    transmission_nine_speed_plant_friction_unsolved = 1501, /* the friction torques are not exact */
    transmission_nine_speed_plant_bad_capacity_converter_lockup = 1502, /* the capacity of converter.lockup is no number from 0 up; it was taken as 0 */
    transmission_nine_speed_plant_bad_capacity_gears_A = 1503, /* the capacity of gears.A is no number from 0 up; it was taken as 0 */
    transmission_nine_speed_plant_bad_capacity_gears_B = 1504, /* the capacity of gears.B is no number from 0 up; it was taken as 0 */
    transmission_nine_speed_plant_bad_capacity_gears_C = 1505, /* the capacity of gears.C is no number from 0 up; it was taken as 0 */
    transmission_nine_speed_plant_bad_capacity_gears_D = 1506, /* the capacity of gears.D is no number from 0 up; it was taken as 0 */
    transmission_nine_speed_plant_bad_capacity_gears_E = 1507, /* the capacity of gears.E is no number from 0 up; it was taken as 0 */
    transmission_nine_speed_plant_bad_capacity_gears_F = 1508, /* the capacity of gears.F is no number from 0 up; it was taken as 0 */
    transmission_nine_speed_plant_bad_M1_inertia = 2000, /* outside its range */
    transmission_nine_speed_plant_bad_M1_torque_max = 2001, /* outside its range */
    transmission_nine_speed_plant_bad_M1_speed_rated = 2002, /* outside its range */
    transmission_nine_speed_plant_bad_M1_inverter_dead_time = 2003, /* outside its range */
    transmission_nine_speed_plant_bad_M1_inverter_time_constant = 2004, /* outside its range */
    transmission_nine_speed_plant_bad_flange1_inertia = 2005, /* outside its range */
    transmission_nine_speed_plant_bad_flange1_stiffness = 2006, /* outside its range */
    transmission_nine_speed_plant_bad_flange1_damping = 2007, /* outside its range */
    transmission_nine_speed_plant_bad_shaft1_stiffness = 2008, /* outside its range */
    transmission_nine_speed_plant_bad_shaft1_damping = 2009, /* outside its range */
    transmission_nine_speed_plant_bad_shaft1_backlash = 2010, /* outside its range */
    transmission_nine_speed_plant_bad_converter_inertia_pump = 2011, /* outside its range */
    transmission_nine_speed_plant_bad_converter_inertia_turbine = 2012, /* outside its range */
    transmission_nine_speed_plant_bad_converter_reference_speed = 2013, /* outside its range */
    transmission_nine_speed_plant_bad_converter_lockup_static = 2014, /* outside its range */
    transmission_nine_speed_plant_bad_converter_lockup_stribeck_speed = 2015, /* outside its range */
    transmission_nine_speed_plant_bad_converter_lockup_viscous = 2016, /* outside its range */
    transmission_nine_speed_plant_bad_converter_lockup_capacity = 2017, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P1_ratio = 2018, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P1_inertia_sun = 2019, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P1_inertia_ring = 2020, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P1_inertia_carrier = 2021, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P1_inertia_planets = 2022, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P2_ratio = 2023, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P2_inertia_sun = 2024, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P2_inertia_ring = 2025, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P2_inertia_carrier = 2026, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P2_inertia_planets = 2027, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P3_ratio = 2028, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P3_inertia_sun = 2029, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P3_inertia_ring = 2030, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P3_inertia_carrier = 2031, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P3_inertia_planets = 2032, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P4_ratio = 2033, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P4_inertia_sun = 2034, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P4_inertia_ring = 2035, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P4_inertia_carrier = 2036, /* outside its range */
    transmission_nine_speed_plant_bad_gears_P4_inertia_planets = 2037, /* outside its range */
    transmission_nine_speed_plant_bad_gears_A_viscous = 2038, /* outside its range */
    transmission_nine_speed_plant_bad_gears_A_capacity = 2039, /* outside its range */
    transmission_nine_speed_plant_bad_gears_B_viscous = 2040, /* outside its range */
    transmission_nine_speed_plant_bad_gears_B_capacity = 2041, /* outside its range */
    transmission_nine_speed_plant_bad_gears_C_viscous = 2042, /* outside its range */
    transmission_nine_speed_plant_bad_gears_C_capacity = 2043, /* outside its range */
    transmission_nine_speed_plant_bad_gears_D_viscous = 2044, /* outside its range */
    transmission_nine_speed_plant_bad_gears_D_capacity = 2045, /* outside its range */
    transmission_nine_speed_plant_bad_gears_E_viscous = 2046, /* outside its range */
    transmission_nine_speed_plant_bad_gears_E_capacity = 2047, /* outside its range */
    transmission_nine_speed_plant_bad_gears_F_viscous = 2048, /* outside its range */
    transmission_nine_speed_plant_bad_gears_F_capacity = 2049, /* outside its range */
    transmission_nine_speed_plant_bad_gears_input_inertia = 2050, /* outside its range */
    transmission_nine_speed_plant_bad_gears_a_inertia = 2051, /* outside its range */
    transmission_nine_speed_plant_bad_gears_b_inertia = 2052, /* outside its range */
    transmission_nine_speed_plant_bad_gears_output_inertia = 2053, /* outside its range */
    transmission_nine_speed_plant_bad_gears_carrier1_inertia = 2054, /* outside its range */
    transmission_nine_speed_plant_bad_gears_sun2_inertia = 2055, /* outside its range */
    transmission_nine_speed_plant_bad_gears_ring3_inertia = 2056, /* outside its range */
    transmission_nine_speed_plant_bad_gears_carrier4_inertia = 2057, /* outside its range */
    transmission_nine_speed_plant_bad_shaft2_stiffness = 2058, /* outside its range */
    transmission_nine_speed_plant_bad_shaft2_damping = 2059, /* outside its range */
    transmission_nine_speed_plant_bad_shaft2_backlash = 2060, /* outside its range */
    transmission_nine_speed_plant_bad_flange2_inertia = 2061, /* outside its range */
    transmission_nine_speed_plant_bad_flange2_stiffness = 2062, /* outside its range */
    transmission_nine_speed_plant_bad_flange2_damping = 2063, /* outside its range */
    transmission_nine_speed_plant_bad_M2_inertia = 2064, /* outside its range */
    transmission_nine_speed_plant_bad_M2_torque_max = 2065, /* outside its range */
    transmission_nine_speed_plant_bad_M2_speed_rated = 2066, /* outside its range */
    transmission_nine_speed_plant_bad_M2_inverter_dead_time = 2067, /* outside its range */
    transmission_nine_speed_plant_bad_M2_inverter_time_constant = 2068, /* outside its range */
    transmission_nine_speed_plant_bad_standstill_speed = 2069, /* outside its range */
    transmission_nine_speed_plant_bad_sample_time = 2070, /* outside its range */
} transmission_nine_speed_plant_status;

extern const transmission_nine_speed_plant_params transmission_nine_speed_plant_defaults;

/* Name of a status, for logs. */
const char *transmission_nine_speed_plant_status_text(transmission_nine_speed_plant_status status);

/* Sets the initial state and prepares everything that follows from the parameters. */
transmission_nine_speed_plant_status transmission_nine_speed_plant_init(transmission_nine_speed_plant_state *state, const transmission_nine_speed_plant_params *params);

/* Checks the parameters and prepares what follows from them; the rest of the state stays. */
transmission_nine_speed_plant_status transmission_nine_speed_plant_update(transmission_nine_speed_plant_state *state, const transmission_nine_speed_plant_params *params);

/* One step. After a bad input the state is as it was, and the outputs are those of that state. */
transmission_nine_speed_plant_status transmission_nine_speed_plant_step(transmission_nine_speed_plant_state *state, const transmission_nine_speed_plant_params *params,
    const transmission_nine_speed_plant_inputs *inputs, transmission_nine_speed_plant_outputs *outputs);

/* Outputs of the present state, as at the end of a step. */
void transmission_nine_speed_plant_measure(const transmission_nine_speed_plant_state *state, const transmission_nine_speed_plant_params *params,
    transmission_nine_speed_plant_outputs *outputs);

#endif
