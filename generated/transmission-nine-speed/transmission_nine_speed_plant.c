/*
 * transmission_nine_speed_plant.c: plant of the bed transmission_nine_speed
 *
 * Emitted by ptgen 0.1.0 from transmission-nine-speed.toml (SHA-256 65236af78ec41a0c), template block.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "transmission_nine_speed_plant.h"
#include "transmission_nine_speed_friction.h"
#include "transmission_nine_speed_fluid.h"

#include <float.h>
#include <string.h>

const transmission_nine_speed_plant_params transmission_nine_speed_plant_defaults = {
    .M1_inertia = 0.4,
    .M1_torque_max = 900.0,
    .M1_speed_rated = 335.103216382911,
    .M1_inverter_dead_time = 0.001,
    .M1_inverter_time_constant = 0.002,
    .flange1_inertia = 0.01,
    .flange1_stiffness = 380000.0,
    .flange1_damping = 0.5,
    .shaft1_stiffness = 25000.0,
    .shaft1_damping = 2.0,
    .shaft1_backlash = 0.00872664625997165,
    .converter_inertia_pump = 0.1,
    .converter_inertia_turbine = 0.04,
    .converter_reference_speed = 209.43951023932,
    .converter_lockup_static = 750.0,
    .converter_lockup_stribeck_speed = 5.0,
    .converter_lockup_viscous = 0.0,
    .converter_lockup_capacity = 700.0,
    .gears_P1_ratio = 2.130434782608696,
    .gears_P1_inertia_sun = 0.0012,
    .gears_P1_inertia_ring = 0.006,
    .gears_P1_inertia_carrier = 0.005,
    .gears_P1_inertia_planets = 0.0002,
    .gears_P2_ratio = 2.272727272727273,
    .gears_P2_inertia_sun = 0.0012,
    .gears_P2_inertia_ring = 0.0065,
    .gears_P2_inertia_carrier = 0.005,
    .gears_P2_inertia_planets = 0.00025,
    .gears_P3_ratio = 2.3333333333333335,
    .gears_P3_inertia_sun = 0.0008,
    .gears_P3_inertia_ring = 0.005,
    .gears_P3_inertia_carrier = 0.006,
    .gears_P3_inertia_planets = 0.00025,
    .gears_P4_ratio = 2.5294117647058822,
    .gears_P4_inertia_sun = 0.0008,
    .gears_P4_inertia_ring = 0.0055,
    .gears_P4_inertia_carrier = 0.005,
    .gears_P4_inertia_planets = 0.0003,
    .gears_A_viscous = 0.0,
    .gears_A_capacity = 2000.0,
    .gears_B_viscous = 0.0,
    .gears_B_capacity = 2000.0,
    .gears_C_viscous = 0.0,
    .gears_C_capacity = 3500.0,
    .gears_D_viscous = 0.0,
    .gears_D_capacity = 1800.0,
    .gears_E_viscous = 0.0,
    .gears_E_capacity = 2200.0,
    .gears_F_viscous = 0.0,
    .gears_F_capacity = 1800.0,
    .gears_input_inertia = 0.01,
    .gears_a_inertia = 0.006,
    .gears_b_inertia = 0.008,
    .gears_output_inertia = 0.02,
    .gears_carrier1_inertia = 0.007,
    .gears_sun2_inertia = 0.004,
    .gears_ring3_inertia = 0.008,
    .gears_carrier4_inertia = 0.009,
    .shaft2_stiffness = 40000.0,
    .shaft2_damping = 3.0,
    .shaft2_backlash = 0.0174532925199433,
    .flange2_inertia = 0.03,
    .flange2_stiffness = 220000.0,
    .flange2_damping = 0.5,
    .M2_inertia = 4.5,
    .M2_torque_max = 3300.0,
    .M2_speed_rated = 104.71975511966,
    .M2_inverter_dead_time = 0.001,
    .M2_inverter_time_constant = 0.002,
    .standstill_speed = 1e-09,
    .sample_time = 0.0001,
};

/* shares of the slower wheel from which each polynomial holds: pump faster, forward, turbine faster, forward, pump
 * faster, backward, turbine faster, backward */
static const transmission_nine_speed_real converter_fluid_knots[4][8] = {
    { -1.0, 0.0, 0.2, 0.4, 0.6, 0.8, 0.9 },
    { -1.0, 0.0, 0.2, 0.4, 0.6, 0.8, 0.9 },
    { -1.0, 0.0, 0.2, 0.4, 0.6, 0.8, 0.9 },
    { -1.0, 0.0, 0.2, 0.4, 0.6, 0.8, 0.9 },
};

/* torques at the reference speed: 4 coefficients of the faster wheel's, the rest of the slower one's (N m) */
static const transmission_nine_speed_real converter_fluid_curves[28][12] = {
    { 180.0, 0.0, 0.0, 0.0, 360.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 180.0, 0.0, 375.0, -1250.0, 360.0, 0.0, -1500.0, 3125.0, -4687.5, 27343.75, -39062.5 },
    { 185.0, 0.0, -187.5, 312.5, 323.75, -231.25, -328.125, 781.25, -390.625, 0.0, 0.0 },
    { 180.0, -37.5, -225.00000000000026, 187.5000000000008, 270.0, -281.25, -337.50000000000074, 806.6406250000023,
        -224.60937500000065, -341.7968750000019, 244.14062500000185 },
    { 165.0, -104.99999999999999, -205.43478260869506, -722.8260869565228, 206.25, -328.90625, -739.9745374211723,
        2972.5504065715118, -439.3090012722622, -1369.344386132298, -14204.486720737897 },
    { 130.0, -273.9130434782608, -3367.8929765886314, 11070.234113712382, 132.6, -320.4752738134749,
        -3307.006561311244, 13359.779417396423, -6878.3476729046, -24730.78199596631, 92956.16431361568 },
    { 80.0, -615.3846153846156, -2192.3076923076924, 3461.538461538454, 80.0, -615.3846153846156,
        -2192.3076923076924, 3461.538461538454, 0.0, 0.0, 0.0 },
    { -180.0, 0.0, 0.0, 0.0, -180.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { -180.0, 0.0, -375.0, 1250.0, -180.0, 0.0, -375.0, 1250.0, 0.0, 0.0, 0.0 },
    { -185.0, 0.0, 187.5, -312.5, -185.0, 0.0, 187.5, -312.5, 0.0, 0.0, 0.0 },
    { -180.0, 37.5, 225.00000000000026, -187.5000000000008, -180.0, 37.5, 225.00000000000026, -187.5000000000008,
        0.0, 0.0, 0.0 },
    { -165.0, 104.99999999999999, 205.43478260869506, 722.8260869565228, -165.0, 104.99999999999999,
        205.43478260869506, 722.8260869565228, 0.0, 0.0, 0.0 },
    { -130.0, 273.9130434782608, 3367.8929765886314, -11070.234113712382, -130.0, 273.9130434782608,
        3367.8929765886314, -11070.234113712382, 0.0, 0.0, 0.0 },
    { -80.0, 615.3846153846156, 2192.3076923076924, -3461.538461538454, -80.0, 615.3846153846156,
        2192.3076923076924, -3461.538461538454, 0.0, 0.0, 0.0 },
    { -180.0, 0.0, 0.0, 0.0, -180.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { -180.0, 0.0, -375.0, 1250.0, -180.0, 0.0, -375.0, 1250.0, 0.0, 0.0, 0.0 },
    { -185.0, 0.0, 187.5, -312.5, -185.0, 0.0, 187.5, -312.5, 0.0, 0.0, 0.0 },
    { -180.0, 37.5, 225.00000000000026, -187.5000000000008, -180.0, 37.5, 225.00000000000026, -187.5000000000008,
        0.0, 0.0, 0.0 },
    { -165.0, 104.99999999999999, 205.43478260869506, 722.8260869565228, -165.0, 104.99999999999999,
        205.43478260869506, 722.8260869565228, 0.0, 0.0, 0.0 },
    { -130.0, 273.9130434782608, 3367.8929765886314, -11070.234113712382, -130.0, 273.9130434782608,
        3367.8929765886314, -11070.234113712382, 0.0, 0.0, 0.0 },
    { -80.0, 615.3846153846156, 2192.3076923076924, -3461.538461538454, -80.0, 615.3846153846156,
        2192.3076923076924, -3461.538461538454, 0.0, 0.0, 0.0 },
    { 360.0, 0.0, -540.0, 360.0, 180.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 },
    { 180.0, 0.0, 375.0, -1250.0, 180.0, 0.0, 375.0, -1250.0, 0.0, 0.0, 0.0 },
    { 185.0, 0.0, -187.5, 312.5, 185.0, 0.0, -187.5, 312.5, 0.0, 0.0, 0.0 },
    { 180.0, -37.5, -225.00000000000026, 187.5000000000008, 180.0, -37.5, -225.00000000000026, 187.5000000000008,
        0.0, 0.0, 0.0 },
    { 165.0, -104.99999999999999, -205.43478260869506, -722.8260869565228, 165.0, -104.99999999999999,
        -205.43478260869506, -722.8260869565228, 0.0, 0.0, 0.0 },
    { 130.0, -273.9130434782608, -3367.8929765886314, 11070.234113712382, 130.0, -273.9130434782608,
        -3367.8929765886314, 11070.234113712382, 0.0, 0.0, 0.0 },
    { 80.0, -615.3846153846156, -2192.3076923076924, 3461.538461538454, 80.0, -615.3846153846156,
        -2192.3076923076924, 3461.538461538454, 0.0, 0.0, 0.0 },
};

/* Range of each parameter; `open` excludes the lower bound. The order is that of the status codes. */
static const struct {
    const char *text;
    size_t offset;
    transmission_nine_speed_real least;
    transmission_nine_speed_real most;
    int open;
    int not_zero;
} limits[] = {
    { "the parameter M1_inertia is outside its range", offsetof(transmission_nine_speed_plant_params, M1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_max is outside its range", offsetof(transmission_nine_speed_plant_params, M1_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_rated is outside its range", offsetof(transmission_nine_speed_plant_params, M1_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_inverter_dead_time is outside its range", offsetof(transmission_nine_speed_plant_params, M1_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M1_inverter_time_constant is outside its range", offsetof(transmission_nine_speed_plant_params, M1_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_inertia is outside its range", offsetof(transmission_nine_speed_plant_params, flange1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_stiffness is outside its range", offsetof(transmission_nine_speed_plant_params, flange1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_damping is outside its range", offsetof(transmission_nine_speed_plant_params, flange1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter shaft1_stiffness is outside its range", offsetof(transmission_nine_speed_plant_params, shaft1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft1_damping is outside its range", offsetof(transmission_nine_speed_plant_params, shaft1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter shaft1_backlash is outside its range", offsetof(transmission_nine_speed_plant_params, shaft1_backlash), 0.0, DBL_MAX, 1, 0 },
    { "the parameter converter_inertia_pump is outside its range", offsetof(transmission_nine_speed_plant_params, converter_inertia_pump), 0.0, DBL_MAX, 1, 0 },
    { "the parameter converter_inertia_turbine is outside its range", offsetof(transmission_nine_speed_plant_params, converter_inertia_turbine), 0.0, DBL_MAX, 1, 0 },
    { "the parameter converter_reference_speed is outside its range", offsetof(transmission_nine_speed_plant_params, converter_reference_speed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter converter_lockup_static is outside its range", offsetof(transmission_nine_speed_plant_params, converter_lockup_static), 0.0, DBL_MAX, 1, 0 },
    { "the parameter converter_lockup_stribeck_speed is outside its range", offsetof(transmission_nine_speed_plant_params, converter_lockup_stribeck_speed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter converter_lockup_viscous is outside its range", offsetof(transmission_nine_speed_plant_params, converter_lockup_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter converter_lockup_capacity is outside its range", offsetof(transmission_nine_speed_plant_params, converter_lockup_capacity), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P1_ratio is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P1_ratio), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P1_inertia_sun is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P1_inertia_sun), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P1_inertia_ring is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P1_inertia_ring), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P1_inertia_carrier is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P1_inertia_carrier), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P1_inertia_planets is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P1_inertia_planets), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P2_ratio is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P2_ratio), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P2_inertia_sun is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P2_inertia_sun), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P2_inertia_ring is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P2_inertia_ring), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P2_inertia_carrier is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P2_inertia_carrier), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P2_inertia_planets is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P2_inertia_planets), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P3_ratio is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P3_ratio), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P3_inertia_sun is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P3_inertia_sun), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P3_inertia_ring is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P3_inertia_ring), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P3_inertia_carrier is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P3_inertia_carrier), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P3_inertia_planets is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P3_inertia_planets), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P4_ratio is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P4_ratio), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P4_inertia_sun is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P4_inertia_sun), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P4_inertia_ring is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P4_inertia_ring), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P4_inertia_carrier is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P4_inertia_carrier), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P4_inertia_planets is outside its range", offsetof(transmission_nine_speed_plant_params, gears_P4_inertia_planets), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_A_viscous is outside its range", offsetof(transmission_nine_speed_plant_params, gears_A_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_A_capacity is outside its range", offsetof(transmission_nine_speed_plant_params, gears_A_capacity), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_B_viscous is outside its range", offsetof(transmission_nine_speed_plant_params, gears_B_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_B_capacity is outside its range", offsetof(transmission_nine_speed_plant_params, gears_B_capacity), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_C_viscous is outside its range", offsetof(transmission_nine_speed_plant_params, gears_C_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_C_capacity is outside its range", offsetof(transmission_nine_speed_plant_params, gears_C_capacity), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_D_viscous is outside its range", offsetof(transmission_nine_speed_plant_params, gears_D_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_D_capacity is outside its range", offsetof(transmission_nine_speed_plant_params, gears_D_capacity), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_E_viscous is outside its range", offsetof(transmission_nine_speed_plant_params, gears_E_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_E_capacity is outside its range", offsetof(transmission_nine_speed_plant_params, gears_E_capacity), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_F_viscous is outside its range", offsetof(transmission_nine_speed_plant_params, gears_F_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_F_capacity is outside its range", offsetof(transmission_nine_speed_plant_params, gears_F_capacity), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_input_inertia is outside its range", offsetof(transmission_nine_speed_plant_params, gears_input_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_a_inertia is outside its range", offsetof(transmission_nine_speed_plant_params, gears_a_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_b_inertia is outside its range", offsetof(transmission_nine_speed_plant_params, gears_b_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_output_inertia is outside its range", offsetof(transmission_nine_speed_plant_params, gears_output_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_carrier1_inertia is outside its range", offsetof(transmission_nine_speed_plant_params, gears_carrier1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_sun2_inertia is outside its range", offsetof(transmission_nine_speed_plant_params, gears_sun2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_ring3_inertia is outside its range", offsetof(transmission_nine_speed_plant_params, gears_ring3_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_carrier4_inertia is outside its range", offsetof(transmission_nine_speed_plant_params, gears_carrier4_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft2_stiffness is outside its range", offsetof(transmission_nine_speed_plant_params, shaft2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft2_damping is outside its range", offsetof(transmission_nine_speed_plant_params, shaft2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter shaft2_backlash is outside its range", offsetof(transmission_nine_speed_plant_params, shaft2_backlash), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_inertia is outside its range", offsetof(transmission_nine_speed_plant_params, flange2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_stiffness is outside its range", offsetof(transmission_nine_speed_plant_params, flange2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_damping is outside its range", offsetof(transmission_nine_speed_plant_params, flange2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_inertia is outside its range", offsetof(transmission_nine_speed_plant_params, M2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_max is outside its range", offsetof(transmission_nine_speed_plant_params, M2_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_rated is outside its range", offsetof(transmission_nine_speed_plant_params, M2_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_inverter_dead_time is outside its range", offsetof(transmission_nine_speed_plant_params, M2_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M2_inverter_time_constant is outside its range", offsetof(transmission_nine_speed_plant_params, M2_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter standstill_speed is outside its range", offsetof(transmission_nine_speed_plant_params, standstill_speed), 0.0, DBL_MAX, 0, 0 },
    { "the parameter sample_time is outside its range", offsetof(transmission_nine_speed_plant_params, sample_time), 0.0, DBL_MAX, 1, 0 },
};

enum { limit_count = sizeof limits / sizeof limits[0] };

const char *transmission_nine_speed_plant_status_text(transmission_nine_speed_plant_status status)
{
    switch ((int)status) {
    case transmission_nine_speed_plant_ok:
        return "ok";
    case transmission_nine_speed_plant_mass_matrix:
        return "the inertia matrix is not positive definite";
    case transmission_nine_speed_plant_exponential_range:
        return "the parameters are too far from those that the code was emitted for; emit it again";
    case transmission_nine_speed_plant_friction_matrix:
        return "a mode of the bed is too fast for the step; make a stiff shaft rigid, or the step shorter";
    case transmission_nine_speed_plant_friction_unsolved:
        return "the friction torques are not exact";
    case transmission_nine_speed_plant_bad_capacity_converter_lockup:
        return "the capacity of converter.lockup is no number from 0 up; it was taken as 0";
    case transmission_nine_speed_plant_bad_capacity_gears_A:
        return "the capacity of gears.A is no number from 0 up; it was taken as 0";
    case transmission_nine_speed_plant_bad_capacity_gears_B:
        return "the capacity of gears.B is no number from 0 up; it was taken as 0";
    case transmission_nine_speed_plant_bad_capacity_gears_C:
        return "the capacity of gears.C is no number from 0 up; it was taken as 0";
    case transmission_nine_speed_plant_bad_capacity_gears_D:
        return "the capacity of gears.D is no number from 0 up; it was taken as 0";
    case transmission_nine_speed_plant_bad_capacity_gears_E:
        return "the capacity of gears.E is no number from 0 up; it was taken as 0";
    case transmission_nine_speed_plant_bad_capacity_gears_F:
        return "the capacity of gears.F is no number from 0 up; it was taken as 0";
    case transmission_nine_speed_plant_bad_input_M1_torque_ref:
        return "the input M1_torque_ref is not finite";
    case transmission_nine_speed_plant_bad_input_M2_torque_ref:
        return "the input M2_torque_ref is not finite";
    case transmission_nine_speed_plant_bad_input_converter_lockup_actuation:
        return "the input converter_lockup_actuation is outside its range 0 to 1";
    case transmission_nine_speed_plant_bad_input_gears_A_actuation:
        return "the input gears_A_actuation is outside its range 0 to 1";
    case transmission_nine_speed_plant_bad_input_gears_B_actuation:
        return "the input gears_B_actuation is outside its range 0 to 1";
    case transmission_nine_speed_plant_bad_input_gears_C_actuation:
        return "the input gears_C_actuation is outside its range 0 to 1";
    case transmission_nine_speed_plant_bad_input_gears_D_actuation:
        return "the input gears_D_actuation is outside its range 0 to 1";
    case transmission_nine_speed_plant_bad_input_gears_E_actuation:
        return "the input gears_E_actuation is outside its range 0 to 1";
    case transmission_nine_speed_plant_bad_input_gears_F_actuation:
        return "the input gears_F_actuation is outside its range 0 to 1";
    default:
        break;
    }
    const int limit = (int)status - 2000;
    return limit >= 0 && limit < limit_count ? limits[limit].text : "unknown status";
}

transmission_nine_speed_plant_status transmission_nine_speed_plant_init(transmission_nine_speed_plant_state *s, const transmission_nine_speed_plant_params *p)
{
    memset(s, 0, sizeof *s);
    return transmission_nine_speed_plant_update(s, p);
}

transmission_nine_speed_plant_status transmission_nine_speed_plant_update(transmission_nine_speed_plant_state *s, const transmission_nine_speed_plant_params *p)
{
    for (int k = 0; k < limit_count; ++k) {
        const transmission_nine_speed_real value = *(const transmission_nine_speed_real *)(const void *)((const char *)p + limits[k].offset);
        const int above = limits[k].open ? value > limits[k].least : value >= limits[k].least; /* false for NaN */
        if (!(above && value <= limits[k].most) || (limits[k].not_zero && value == 0.0)) {
            return (transmission_nine_speed_plant_status)(2000 + k);
        }
    }
    memset(s->transition, 0, sizeof s->transition);
    memset(s->G, 0, sizeof s->G);
    memset(s->L, 0, sizeof s->L);
    memset(s->gears_input_torque_reaction, 0, sizeof s->gears_input_torque_reaction);
    memset(s->gamma, 0, sizeof s->gamma);
    memset(s->K, 0, sizeof s->K);
    memset(s->kappa, 0, sizeof s->kappa);
    memset(s->half_gap, 0, sizeof s->half_gap);
    memset(s->contact_stiffness, 0, sizeof s->contact_stiffness);
    memset(s->contact_damping, 0, sizeof s->contact_damping);
    transmission_nine_speed_real mass[9][12];
    transmission_nine_speed_real forces[26][12];
    transmission_nine_speed_real A[28][16];
    transmission_nine_speed_real scale[28];
    transmission_nine_speed_real whole[28][16];
    transmission_nine_speed_real late[28][16];
    transmission_nine_speed_real early[28][16];
    transmission_nine_speed_real rates[26][12];
    transmission_nine_speed_zero(sizeof mass, mass);
    transmission_nine_speed_zero(sizeof forces, forces);
    transmission_nine_speed_zero(sizeof A, A);
    transmission_nine_speed_zero(sizeof scale, scale);
    transmission_nine_speed_zero(sizeof whole, whole);
    transmission_nine_speed_zero(sizeof late, late);
    transmission_nine_speed_zero(sizeof early, early);
    transmission_nine_speed_zero(sizeof rates, rates);
    
    /* friction velocities per velocity */
    s->G[1][5] = 1.0 / p->gears_P2_ratio;
    s->G[2][5] = -1.0 / p->gears_P2_ratio;
    s->G[4][5] = (-p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio);
    s->G[1][6] = (p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio - p->gears_P3_ratio - p->gears_P4_ratio
        - 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio
        + p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio);
    s->G[2][6] = (p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P2_ratio);
    s->G[3][6] = -p->gears_P3_ratio * p->gears_P4_ratio / (p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P3_ratio
        + p->gears_P4_ratio + 1.0);
    s->G[4][6] = (p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P1_ratio
        * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio + p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P3_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio *
        p->gears_P2_ratio);
    /* twists of shafts with backlash per twist */
    s->L[2][1] = (p->gears_P2_ratio + 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio);
    /* M = S' I S */
    mass[0][0] = p->converter_inertia_pump;
    mass[1][0] = p->converter_inertia_pump;
    mass[4][0] = p->converter_inertia_pump;
    mass[0][1] = p->converter_inertia_pump;
    mass[1][1] = p->converter_inertia_pump + p->converter_inertia_turbine + p->gears_P1_inertia_carrier +
        p->gears_P1_inertia_ring + p->gears_P1_inertia_sun + p->gears_P2_inertia_carrier + 4.0 *
        p->gears_P2_inertia_planets / ((p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio + 1.0) +
        p->gears_P2_inertia_ring * ((p->gears_P2_ratio * p->gears_P2_ratio) + 2.0 * p->gears_P2_ratio + 1.0) /
        (p->gears_P2_ratio * p->gears_P2_ratio) + p->gears_P3_inertia_carrier * ((p->gears_P2_ratio *
        p->gears_P2_ratio) + 2.0 * p->gears_P2_ratio + 1.0) / ((p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio
        + (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P3_inertia_planets * (4.0 * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 8.0 * p->gears_P2_ratio * (p->gears_P3_ratio
        * p->gears_P3_ratio) + 4.0 * (p->gears_P3_ratio * p->gears_P3_ratio)) / ((p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + (p->gears_P2_ratio *
        p->gears_P2_ratio)) + p->gears_P4_inertia_carrier * ((p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio
        * p->gears_P4_ratio + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio
        * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio *
        p->gears_P2_ratio) * p->gears_P4_ratio + (p->gears_P2_ratio * p->gears_P2_ratio) + 2.0 * p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 4.0 * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio +
        4.0 * p->gears_P2_ratio * p->gears_P3_ratio + 2.0 * p->gears_P2_ratio * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 4.0 * p->gears_P2_ratio * p->gears_P4_ratio + 2.0 * p->gears_P2_ratio +
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 *
        p->gears_P3_ratio + (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P4_ratio + 1.0) /
        ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio)
        * p->gears_P4_ratio + (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) +
        2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio)
        + 4.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P4_ratio
        + (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_planets * (4.0 * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 8.0
        * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) +
        4.0 * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio)) /
        ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 4.0
        * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) +
        2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)
        * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * (p->gears_P2_ratio
        * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P4_inertia_ring * ((p->gears_P2_ratio * p->gears_P2_ratio) + 2.0 * p->gears_P2_ratio + 1.0) /
        ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_a_inertia + p->gears_carrier1_inertia + p->gears_carrier4_inertia * ((p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio
        + (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P4_ratio + (p->gears_P2_ratio * p->gears_P2_ratio) + 2.0
        * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 4.0 * p->gears_P2_ratio * p->gears_P3_ratio
        * p->gears_P4_ratio + 4.0 * p->gears_P2_ratio * p->gears_P3_ratio + 2.0 * p->gears_P2_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * p->gears_P2_ratio * p->gears_P4_ratio + 2.0 *
        p->gears_P2_ratio + (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P3_ratio * p->gears_P4_ratio +
        2.0 * p->gears_P3_ratio + (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P4_ratio + 1.0) /
        ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio)
        * p->gears_P4_ratio + (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) +
        2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio)
        + 4.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P4_ratio
        + (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_input_inertia + p->gears_output_inertia *
        ((p->gears_P2_ratio * p->gears_P2_ratio) + 2.0 * p->gears_P2_ratio + 1.0) / ((p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P3_inertia_sun *
        ((p->gears_P2_ratio * p->gears_P2_ratio) + 2.0 * p->gears_P2_ratio + 1.0) / (p->gears_P2_ratio *
        p->gears_P2_ratio) + p->gears_P4_inertia_sun * ((p->gears_P2_ratio * p->gears_P2_ratio) + 2.0 *
        p->gears_P2_ratio + 1.0) / (p->gears_P2_ratio * p->gears_P2_ratio) + p->gears_b_inertia *
        ((p->gears_P2_ratio * p->gears_P2_ratio) + 2.0 * p->gears_P2_ratio + 1.0) / (p->gears_P2_ratio *
        p->gears_P2_ratio);
    mass[2][1] = -4.0 * p->gears_P2_inertia_planets / ((p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 *
        p->gears_P2_ratio + 1.0) + p->gears_P2_inertia_ring * (-p->gears_P2_ratio - 1.0) / (p->gears_P2_ratio *
        p->gears_P2_ratio) + p->gears_P3_inertia_carrier * (-p->gears_P2_ratio - 1.0) / ((p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P3_inertia_planets * (-4.0 *
        p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) - 4.0 * (p->gears_P3_ratio * p->gears_P3_ratio))
        / ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio *
        p->gears_P3_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio)
        + (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_carrier * (-p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio -
        2.0 * p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) -
        2.0 * p->gears_P2_ratio * p->gears_P4_ratio - p->gears_P2_ratio - (p->gears_P3_ratio * p->gears_P3_ratio) -
        2.0 * p->gears_P3_ratio * p->gears_P4_ratio - 2.0 * p->gears_P3_ratio - (p->gears_P4_ratio *
        p->gears_P4_ratio) - 2.0 * p->gears_P4_ratio - 1.0) / ((p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio
        * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio + (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * (p->gears_P2_ratio *
        p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) *
        p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0
        * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P4_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P4_inertia_planets * (-4.0 * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio
        * p->gears_P4_ratio)) / ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) +
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio *
        p->gears_P4_ratio) - 4.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio
        * p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio +
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio *
        p->gears_P4_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio)
        + (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_ring * (-p->gears_P2_ratio - 1.0) /
        ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_carrier4_inertia * (-p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 *
        p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio - 2.0 * p->gears_P2_ratio * p->gears_P3_ratio -
        p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P2_ratio * p->gears_P4_ratio -
        p->gears_P2_ratio - (p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 * p->gears_P3_ratio * p->gears_P4_ratio -
        2.0 * p->gears_P3_ratio - (p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P4_ratio - 1.0) /
        ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio)
        * p->gears_P4_ratio + (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) +
        2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio)
        + 4.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P4_ratio
        + (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_output_inertia * (-p->gears_P2_ratio - 1.0) /
        ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P3_inertia_sun * (-p->gears_P2_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P2_ratio) +
        p->gears_P4_inertia_sun * (-p->gears_P2_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P2_ratio) +
        p->gears_b_inertia * (-p->gears_P2_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P2_ratio);
    mass[3][1] = p->gears_P3_inertia_carrier * (p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P3_ratio) /
        (p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P2_ratio) + p->gears_P3_inertia_planets * (-4.0 * p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) - 4.0 * (p->gears_P3_ratio * p->gears_P3_ratio)) / (p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 * p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio) + p->gears_P2_ratio) + p->gears_P4_inertia_carrier *
        (p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P2_ratio *
        p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P3_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio) + p->gears_P3_ratio * p->gears_P4_ratio) / (p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P2_ratio
        * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) +
        4.0 * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P2_ratio *
        p->gears_P3_ratio + p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P2_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio) + p->gears_P4_inertia_planets * (-4.0 * p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * (p->gears_P3_ratio
        * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio)) / (p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 *
        p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) +
        p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * p->gears_P2_ratio *
        p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 *
        p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + p->gears_P2_ratio) + p->gears_P4_inertia_ring
        * (p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P3_ratio) / (p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio) +
        p->gears_carrier4_inertia * (p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio
        + p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio +
        p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + p->gears_P3_ratio * p->gears_P4_ratio) /
        (p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0
        * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 4.0 * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 *
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 *
        p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio) + p->gears_output_inertia * (p->gears_P2_ratio *
        p->gears_P3_ratio + p->gears_P3_ratio) / (p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0
        * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio);
    mass[4][1] = p->converter_inertia_pump + p->converter_inertia_turbine - p->gears_P1_inertia_ring /
        p->gears_P1_ratio + p->gears_P1_inertia_sun - 4.0 * p->gears_P2_inertia_planets / (p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P1_ratio * p->gears_P2_ratio + p->gears_P1_ratio) +
        p->gears_P3_inertia_carrier * (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) /
        (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0
        * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P3_inertia_planets * (-4.0 * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) - 8.0 * p->gears_P2_ratio * (p->gears_P3_ratio
        * p->gears_P3_ratio) - 4.0 * (p->gears_P3_ratio * p->gears_P3_ratio)) / (p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio *
        p->gears_P3_ratio) - 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio
        * p->gears_P3_ratio) + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P4_inertia_carrier * (-(p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio -
        2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio - (p->gears_P2_ratio * p->gears_P2_ratio)
        * (p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) *
        p->gears_P4_ratio - (p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) - 4.0 * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio - 4.0 *
        p->gears_P2_ratio * p->gears_P3_ratio - 2.0 * p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) -
        4.0 * p->gears_P2_ratio * p->gears_P4_ratio - 2.0 * p->gears_P2_ratio - (p->gears_P3_ratio *
        p->gears_P3_ratio) - 2.0 * p->gears_P3_ratio * p->gears_P4_ratio - 2.0 * p->gears_P3_ratio -
        (p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P4_ratio - 1.0) / (p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio
        * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * p->gears_P1_ratio * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P4_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P4_inertia_planets * (-4.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) - 8.0 * p->gears_P2_ratio * (p->gears_P3_ratio
        * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * (p->gears_P3_ratio *
        p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio)) / (p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio *
        p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio
        * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio *
        p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_ring * (-(p->gears_P2_ratio *
        p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_carrier4_inertia * (-(p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio -
        2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio - (p->gears_P2_ratio * p->gears_P2_ratio)
        * (p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) *
        p->gears_P4_ratio - (p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) - 4.0 * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio - 4.0 *
        p->gears_P2_ratio * p->gears_P3_ratio - 2.0 * p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) -
        4.0 * p->gears_P2_ratio * p->gears_P4_ratio - 2.0 * p->gears_P2_ratio - (p->gears_P3_ratio *
        p->gears_P3_ratio) - 2.0 * p->gears_P3_ratio * p->gears_P4_ratio - 2.0 * p->gears_P3_ratio -
        (p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P4_ratio - 1.0) / (p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio
        * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * p->gears_P1_ratio * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P4_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_input_inertia
        + p->gears_output_inertia * (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) /
        (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0
        * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio)) - p->gears_P2_inertia_carrier / p->gears_P1_ratio +
        p->gears_P2_inertia_ring * (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) /
        (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) - p->gears_a_inertia / p->gears_P1_ratio +
        p->gears_P3_inertia_sun * (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) /
        (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_sun *
        (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_b_inertia * (-(p->gears_P2_ratio * p->gears_P2_ratio) -
        2.0 * p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio));
    mass[1][2] = -4.0 * p->gears_P2_inertia_planets / ((p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 *
        p->gears_P2_ratio + 1.0) + p->gears_P2_inertia_ring * (-p->gears_P2_ratio - 1.0) / (p->gears_P2_ratio *
        p->gears_P2_ratio) + p->gears_P3_inertia_carrier * (-p->gears_P2_ratio - 1.0) / ((p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P3_inertia_planets * (-4.0 *
        p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) - 4.0 * (p->gears_P3_ratio * p->gears_P3_ratio))
        / ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio *
        p->gears_P3_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio)
        + (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_carrier * (-p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio -
        2.0 * p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) -
        2.0 * p->gears_P2_ratio * p->gears_P4_ratio - p->gears_P2_ratio - (p->gears_P3_ratio * p->gears_P3_ratio) -
        2.0 * p->gears_P3_ratio * p->gears_P4_ratio - 2.0 * p->gears_P3_ratio - (p->gears_P4_ratio *
        p->gears_P4_ratio) - 2.0 * p->gears_P4_ratio - 1.0) / ((p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio
        * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio + (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * (p->gears_P2_ratio *
        p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) *
        p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0
        * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P4_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P4_inertia_planets * (-4.0 * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio
        * p->gears_P4_ratio)) / ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) +
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio *
        p->gears_P4_ratio) - 4.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio
        * p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio +
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio *
        p->gears_P4_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio)
        + (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_ring * (-p->gears_P2_ratio - 1.0) /
        ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_carrier4_inertia * (-p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 *
        p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio - 2.0 * p->gears_P2_ratio * p->gears_P3_ratio -
        p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P2_ratio * p->gears_P4_ratio -
        p->gears_P2_ratio - (p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 * p->gears_P3_ratio * p->gears_P4_ratio -
        2.0 * p->gears_P3_ratio - (p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P4_ratio - 1.0) /
        ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio)
        * p->gears_P4_ratio + (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) +
        2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio)
        + 4.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P4_ratio
        + (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_output_inertia * (-p->gears_P2_ratio - 1.0) /
        ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P3_inertia_sun * (-p->gears_P2_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P2_ratio) +
        p->gears_P4_inertia_sun * (-p->gears_P2_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P2_ratio) +
        p->gears_b_inertia * (-p->gears_P2_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P2_ratio);
    mass[2][2] = 4.0 * p->gears_P2_inertia_planets / ((p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 *
        p->gears_P2_ratio + 1.0) + p->gears_P2_inertia_ring / (p->gears_P2_ratio * p->gears_P2_ratio) +
        p->gears_P2_inertia_sun + p->gears_P3_inertia_carrier / ((p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio
        + (p->gears_P2_ratio * p->gears_P2_ratio)) + 4.0 * p->gears_P3_inertia_planets * (p->gears_P3_ratio *
        p->gears_P3_ratio) / ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio *
        p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio
        * p->gears_P3_ratio) + (p->gears_P2_ratio * p->gears_P2_ratio)) + 4.0 * (p->gears_P3_ratio *
        p->gears_P3_ratio) * p->gears_P4_inertia_planets * (p->gears_P4_ratio * p->gears_P4_ratio) /
        ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 4.0
        * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) +
        2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)
        * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * (p->gears_P2_ratio
        * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P4_inertia_carrier * ((p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P3_ratio *
        p->gears_P4_ratio + 2.0 * p->gears_P3_ratio + (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 *
        p->gears_P4_ratio + 1.0) / ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio)
        * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio + (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio
        * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * (p->gears_P2_ratio * p->gears_P2_ratio) *
        p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio +
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P4_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P4_inertia_ring / ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio
        * p->gears_P2_ratio)) + p->gears_carrier4_inertia * ((p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 *
        p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P3_ratio + (p->gears_P4_ratio * p->gears_P4_ratio) +
        2.0 * p->gears_P4_ratio + 1.0) / ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio)
        * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio + (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio
        * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * (p->gears_P2_ratio * p->gears_P2_ratio) *
        p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio +
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P4_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_output_inertia / ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio)
        + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio *
        p->gears_P2_ratio)) + p->gears_sun2_inertia + p->gears_P3_inertia_sun / (p->gears_P2_ratio *
        p->gears_P2_ratio) + p->gears_P4_inertia_sun / (p->gears_P2_ratio * p->gears_P2_ratio) + p->gears_b_inertia
        / (p->gears_P2_ratio * p->gears_P2_ratio);
    mass[3][2] = -p->gears_P3_inertia_carrier * p->gears_P3_ratio / (p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio) + 4.0 *
        p->gears_P3_inertia_planets * (p->gears_P3_ratio * p->gears_P3_ratio) / (p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 * p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio) + p->gears_P2_ratio) + 4.0 * (p->gears_P3_ratio * p->gears_P3_ratio)
        * p->gears_P4_inertia_planets * (p->gears_P4_ratio * p->gears_P4_ratio) / (p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio *
        p->gears_P4_ratio) - 2.0 * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio
        * p->gears_P4_ratio) + p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio
        * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 4.0
        * p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P2_ratio
        * p->gears_P3_ratio + p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio *
        p->gears_P4_ratio) - 2.0 * p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + p->gears_P2_ratio)
        - p->gears_P3_ratio * p->gears_P4_inertia_ring / (p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio) - p->gears_P3_ratio *
        p->gears_output_inertia / (p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 *
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio) + p->gears_P4_inertia_carrier *
        (-(p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio - p->gears_P3_ratio * (p->gears_P4_ratio *
        p->gears_P4_ratio) - p->gears_P3_ratio * p->gears_P4_ratio) / (p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P2_ratio * (p->gears_P3_ratio
        * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0
        * p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * p->gears_P2_ratio
        * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio) +
        p->gears_carrier4_inertia * (-(p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio -
        p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) - p->gears_P3_ratio * p->gears_P4_ratio) /
        (p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0
        * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 4.0 * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 *
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 *
        p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio);
    mass[4][2] = 4.0 * p->gears_P2_inertia_planets / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) -
        2.0 * p->gears_P1_ratio * p->gears_P2_ratio + p->gears_P1_ratio) + p->gears_P3_inertia_carrier *
        (p->gears_P2_ratio + 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P3_inertia_planets * (4.0 * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 4.0 *
        (p->gears_P3_ratio * p->gears_P3_ratio)) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 * p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_carrier * (p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio +
        2.0 * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) +
        2.0 * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio + (p->gears_P3_ratio * p->gears_P3_ratio) +
        2.0 * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P3_ratio + (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * p->gears_P4_ratio + 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0
        * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) *
        p->gears_P4_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P4_ratio +
        p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_planets * (4.0 *
        p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0
        * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio)) / (p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) +
        p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0
        * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio *
        p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 *
        p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) +
        p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_ring * (p->gears_P2_ratio
        + 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio +
        p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_carrier4_inertia *
        (p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio + (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P3_ratio +
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P4_ratio + 1.0) / (p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio
        * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * p->gears_P1_ratio * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P4_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_output_inertia
        * (p->gears_P2_ratio + 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P2_inertia_ring * (p->gears_P2_ratio + 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio)) + p->gears_P3_inertia_sun * (p->gears_P2_ratio + 1.0) / (p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_sun * (p->gears_P2_ratio + 1.0) /
        (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_b_inertia * (p->gears_P2_ratio +
        1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio));
    mass[1][3] = p->gears_P3_inertia_carrier * (p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P3_ratio) /
        (p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P2_ratio) + p->gears_P3_inertia_planets * (-4.0 * p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) - 4.0 * (p->gears_P3_ratio * p->gears_P3_ratio)) / (p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 * p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio) + p->gears_P2_ratio) + p->gears_P4_inertia_carrier *
        (p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P2_ratio *
        p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P3_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio) + p->gears_P3_ratio * p->gears_P4_ratio) / (p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P2_ratio
        * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) +
        4.0 * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P2_ratio *
        p->gears_P3_ratio + p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P2_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio) + p->gears_P4_inertia_planets * (-4.0 * p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * (p->gears_P3_ratio
        * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio)) / (p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 *
        p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) +
        p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * p->gears_P2_ratio *
        p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 *
        p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + p->gears_P2_ratio) + p->gears_P4_inertia_ring
        * (p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P3_ratio) / (p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio) +
        p->gears_carrier4_inertia * (p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio
        + p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio +
        p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + p->gears_P3_ratio * p->gears_P4_ratio) /
        (p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0
        * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 4.0 * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 *
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 *
        p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio) + p->gears_output_inertia * (p->gears_P2_ratio *
        p->gears_P3_ratio + p->gears_P3_ratio) / (p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0
        * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio);
    mass[2][3] = -p->gears_P3_inertia_carrier * p->gears_P3_ratio / (p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio) + 4.0 *
        p->gears_P3_inertia_planets * (p->gears_P3_ratio * p->gears_P3_ratio) / (p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 * p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio) + p->gears_P2_ratio) + 4.0 * (p->gears_P3_ratio * p->gears_P3_ratio)
        * p->gears_P4_inertia_planets * (p->gears_P4_ratio * p->gears_P4_ratio) / (p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio *
        p->gears_P4_ratio) - 2.0 * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio
        * p->gears_P4_ratio) + p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio
        * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 4.0
        * p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P2_ratio
        * p->gears_P3_ratio + p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio *
        p->gears_P4_ratio) - 2.0 * p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + p->gears_P2_ratio)
        - p->gears_P3_ratio * p->gears_P4_inertia_ring / (p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio) - p->gears_P3_ratio *
        p->gears_output_inertia / (p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 *
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio) + p->gears_P4_inertia_carrier *
        (-(p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio - p->gears_P3_ratio * (p->gears_P4_ratio *
        p->gears_P4_ratio) - p->gears_P3_ratio * p->gears_P4_ratio) / (p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P2_ratio * (p->gears_P3_ratio
        * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0
        * p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * p->gears_P2_ratio
        * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio) +
        p->gears_carrier4_inertia * (-(p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio -
        p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) - p->gears_P3_ratio * p->gears_P4_ratio) /
        (p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0
        * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 4.0 * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 *
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 *
        p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio);
    mass[3][3] = p->gears_P3_inertia_carrier * (p->gears_P3_ratio * p->gears_P3_ratio) / ((p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P3_ratio + 1.0) + 4.0 * p->gears_P3_inertia_planets * (p->gears_P3_ratio
        * p->gears_P3_ratio) / ((p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio) -
        2.0 * (p->gears_P3_ratio * p->gears_P3_ratio) + 1.0) + p->gears_P3_inertia_ring + (p->gears_P3_ratio *
        p->gears_P3_ratio) * p->gears_P4_inertia_carrier * (p->gears_P4_ratio * p->gears_P4_ratio) /
        ((p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 *
        (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio + (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0
        * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * p->gears_P3_ratio * p->gears_P4_ratio
        + 2.0 * p->gears_P3_ratio + (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P4_ratio + 1.0) + 4.0 *
        (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_inertia_planets * (p->gears_P4_ratio *
        p->gears_P4_ratio) / ((p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio *
        p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio
        * p->gears_P4_ratio) + (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P3_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * p->gears_P3_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P3_ratio + (p->gears_P4_ratio * p->gears_P4_ratio *
        p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * (p->gears_P4_ratio * p->gears_P4_ratio) + 1.0) +
        (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_inertia_ring / ((p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P3_ratio + 1.0) + (p->gears_P3_ratio * p->gears_P3_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio) * p->gears_carrier4_inertia / ((p->gears_P3_ratio *
        p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * (p->gears_P3_ratio * p->gears_P3_ratio)
        * p->gears_P4_ratio + (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P3_ratio * (p->gears_P4_ratio
        * p->gears_P4_ratio) + 4.0 * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P3_ratio +
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P4_ratio + 1.0) + (p->gears_P3_ratio *
        p->gears_P3_ratio) * p->gears_output_inertia / ((p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 *
        p->gears_P3_ratio + 1.0) + p->gears_ring3_inertia;
    mass[4][3] = p->gears_P3_inertia_carrier * (-p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P3_ratio) /
        (p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio * p->gears_P2_ratio) + p->gears_P3_inertia_planets
        * (4.0 * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 4.0 * (p->gears_P3_ratio *
        p->gears_P3_ratio)) / (p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio *
        p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 * p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) + p->gears_P1_ratio * p->gears_P2_ratio) + p->gears_P4_inertia_carrier *
        (-p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio - p->gears_P2_ratio *
        p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) - p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio - (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio - p->gears_P3_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio) - p->gears_P3_ratio * p->gears_P4_ratio) / (p->gears_P1_ratio *
        p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0
        * p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P3_ratio + p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 *
        p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio) +
        p->gears_P4_inertia_planets * (4.0 * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio
        * p->gears_P4_ratio)) / (p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P1_ratio *
        p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) +
        p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio *
        p->gears_P4_ratio) - 4.0 * p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio *
        p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 *
        p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + p->gears_P1_ratio *
        p->gears_P2_ratio) + p->gears_P4_inertia_ring * (-p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P3_ratio)
        / (p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio
        * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio * p->gears_P2_ratio) + p->gears_carrier4_inertia
        * (-p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio - p->gears_P2_ratio *
        p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) - p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio - (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio - p->gears_P3_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio) - p->gears_P3_ratio * p->gears_P4_ratio) / (p->gears_P1_ratio *
        p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0
        * p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P3_ratio + p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 *
        p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio) +
        p->gears_output_inertia * (-p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P3_ratio) / (p->gears_P1_ratio
        * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * p->gears_P2_ratio
        * p->gears_P3_ratio + p->gears_P1_ratio * p->gears_P2_ratio);
    mass[0][4] = p->converter_inertia_pump;
    mass[1][4] = p->converter_inertia_pump + p->converter_inertia_turbine - p->gears_P1_inertia_ring /
        p->gears_P1_ratio + p->gears_P1_inertia_sun - 4.0 * p->gears_P2_inertia_planets / (p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P1_ratio * p->gears_P2_ratio + p->gears_P1_ratio) +
        p->gears_P3_inertia_carrier * (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) /
        (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0
        * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P3_inertia_planets * (-4.0 * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) - 8.0 * p->gears_P2_ratio * (p->gears_P3_ratio
        * p->gears_P3_ratio) - 4.0 * (p->gears_P3_ratio * p->gears_P3_ratio)) / (p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio *
        p->gears_P3_ratio) - 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio
        * p->gears_P3_ratio) + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P4_inertia_carrier * (-(p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio -
        2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio - (p->gears_P2_ratio * p->gears_P2_ratio)
        * (p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) *
        p->gears_P4_ratio - (p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) - 4.0 * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio - 4.0 *
        p->gears_P2_ratio * p->gears_P3_ratio - 2.0 * p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) -
        4.0 * p->gears_P2_ratio * p->gears_P4_ratio - 2.0 * p->gears_P2_ratio - (p->gears_P3_ratio *
        p->gears_P3_ratio) - 2.0 * p->gears_P3_ratio * p->gears_P4_ratio - 2.0 * p->gears_P3_ratio -
        (p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P4_ratio - 1.0) / (p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio
        * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * p->gears_P1_ratio * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P4_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P4_inertia_planets * (-4.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) - 8.0 * p->gears_P2_ratio * (p->gears_P3_ratio
        * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * (p->gears_P3_ratio *
        p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio)) / (p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio *
        p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio
        * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio *
        p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_ring * (-(p->gears_P2_ratio *
        p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_carrier4_inertia * (-(p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio -
        2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio - (p->gears_P2_ratio * p->gears_P2_ratio)
        * (p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) *
        p->gears_P4_ratio - (p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) - 4.0 * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio - 4.0 *
        p->gears_P2_ratio * p->gears_P3_ratio - 2.0 * p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) -
        4.0 * p->gears_P2_ratio * p->gears_P4_ratio - 2.0 * p->gears_P2_ratio - (p->gears_P3_ratio *
        p->gears_P3_ratio) - 2.0 * p->gears_P3_ratio * p->gears_P4_ratio - 2.0 * p->gears_P3_ratio -
        (p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P4_ratio - 1.0) / (p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio
        * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * p->gears_P1_ratio * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P4_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_input_inertia
        + p->gears_output_inertia * (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) /
        (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0
        * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio)) - p->gears_P2_inertia_carrier / p->gears_P1_ratio +
        p->gears_P2_inertia_ring * (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) /
        (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) - p->gears_a_inertia / p->gears_P1_ratio +
        p->gears_P3_inertia_sun * (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) /
        (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_sun *
        (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_b_inertia * (-(p->gears_P2_ratio * p->gears_P2_ratio) -
        2.0 * p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio));
    mass[2][4] = 4.0 * p->gears_P2_inertia_planets / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) -
        2.0 * p->gears_P1_ratio * p->gears_P2_ratio + p->gears_P1_ratio) + p->gears_P3_inertia_carrier *
        (p->gears_P2_ratio + 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P3_inertia_planets * (4.0 * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 4.0 *
        (p->gears_P3_ratio * p->gears_P3_ratio)) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 * p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_carrier * (p->gears_P2_ratio *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio +
        2.0 * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) +
        2.0 * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio + (p->gears_P3_ratio * p->gears_P3_ratio) +
        2.0 * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P3_ratio + (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * p->gears_P4_ratio + 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0
        * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) *
        p->gears_P4_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P4_ratio +
        p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_planets * (4.0 *
        p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0
        * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio)) / (p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) +
        p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0
        * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio *
        p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 *
        p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) +
        p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_ring * (p->gears_P2_ratio
        + 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio +
        p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_carrier4_inertia *
        (p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + 2.0 * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio + (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P3_ratio +
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P4_ratio + 1.0) / (p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio
        * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * p->gears_P1_ratio * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P4_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_output_inertia
        * (p->gears_P2_ratio + 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P2_inertia_ring * (p->gears_P2_ratio + 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio)) + p->gears_P3_inertia_sun * (p->gears_P2_ratio + 1.0) / (p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_sun * (p->gears_P2_ratio + 1.0) /
        (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_b_inertia * (p->gears_P2_ratio +
        1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio));
    mass[3][4] = p->gears_P3_inertia_carrier * (-p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P3_ratio) /
        (p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio * p->gears_P2_ratio) + p->gears_P3_inertia_planets
        * (4.0 * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 4.0 * (p->gears_P3_ratio *
        p->gears_P3_ratio)) / (p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio *
        p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 * p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) + p->gears_P1_ratio * p->gears_P2_ratio) + p->gears_P4_inertia_carrier *
        (-p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio - p->gears_P2_ratio *
        p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) - p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio - (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio - p->gears_P3_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio) - p->gears_P3_ratio * p->gears_P4_ratio) / (p->gears_P1_ratio *
        p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0
        * p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P3_ratio + p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 *
        p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio) +
        p->gears_P4_inertia_planets * (4.0 * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio
        * p->gears_P4_ratio)) / (p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P1_ratio *
        p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) +
        p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio *
        p->gears_P4_ratio) - 4.0 * p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio *
        p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 *
        p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + p->gears_P1_ratio *
        p->gears_P2_ratio) + p->gears_P4_inertia_ring * (-p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P3_ratio)
        / (p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio
        * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio * p->gears_P2_ratio) + p->gears_carrier4_inertia
        * (-p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio - p->gears_P2_ratio *
        p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) - p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio - (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio - p->gears_P3_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio) - p->gears_P3_ratio * p->gears_P4_ratio) / (p->gears_P1_ratio *
        p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0
        * p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P3_ratio + p->gears_P1_ratio * p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 *
        p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio) +
        p->gears_output_inertia * (-p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P3_ratio) / (p->gears_P1_ratio
        * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * p->gears_P2_ratio
        * p->gears_P3_ratio + p->gears_P1_ratio * p->gears_P2_ratio);
    mass[4][4] = p->converter_inertia_pump + p->converter_inertia_turbine + 4.0 * p->gears_P1_inertia_planets /
        ((p->gears_P1_ratio * p->gears_P1_ratio) - 2.0 * p->gears_P1_ratio + 1.0) + p->gears_P1_inertia_ring /
        (p->gears_P1_ratio * p->gears_P1_ratio) + p->gears_P1_inertia_sun + 4.0 * p->gears_P2_inertia_planets /
        ((p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 *
        (p->gears_P1_ratio * p->gears_P1_ratio) * p->gears_P2_ratio + (p->gears_P1_ratio * p->gears_P1_ratio)) +
        p->gears_P3_inertia_carrier * ((p->gears_P2_ratio * p->gears_P2_ratio) + 2.0 * p->gears_P2_ratio + 1.0) /
        ((p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P3_inertia_planets * (4.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 8.0 * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 4.0 *
        (p->gears_P3_ratio * p->gears_P3_ratio)) / ((p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 *
        (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P4_inertia_carrier * ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio +
        2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)
        * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) *
        p->gears_P4_ratio + (p->gears_P2_ratio * p->gears_P2_ratio) + 2.0 * p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 4.0 * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + 4.0 *
        p->gears_P2_ratio * p->gears_P3_ratio + 2.0 * p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) +
        4.0 * p->gears_P2_ratio * p->gears_P4_ratio + 2.0 * p->gears_P2_ratio + (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P3_ratio +
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P4_ratio + 1.0) / ((p->gears_P1_ratio *
        p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio
        * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio + (p->gears_P1_ratio *
        p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0
        * (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * (p->gears_P1_ratio * p->gears_P1_ratio)
        * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P1_ratio * p->gears_P1_ratio) *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * (p->gears_P1_ratio
        * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P4_ratio + (p->gears_P1_ratio *
        p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_planets * (4.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 8.0 * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio
        * p->gears_P4_ratio) + 4.0 * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio)) / ((p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio *
        p->gears_P4_ratio) - 2.0 * (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio)
        * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + (p->gears_P1_ratio *
        p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0
        * (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * (p->gears_P1_ratio *
        p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * (p->gears_P1_ratio *
        p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) +
        (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P4_inertia_ring * ((p->gears_P2_ratio * p->gears_P2_ratio) + 2.0 * p->gears_P2_ratio + 1.0) /
        ((p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_carrier4_inertia * ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio +
        2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)
        * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) *
        p->gears_P4_ratio + (p->gears_P2_ratio * p->gears_P2_ratio) + 2.0 * p->gears_P2_ratio * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 4.0 * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + 4.0 *
        p->gears_P2_ratio * p->gears_P3_ratio + 2.0 * p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) +
        4.0 * p->gears_P2_ratio * p->gears_P4_ratio + 2.0 * p->gears_P2_ratio + (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P3_ratio +
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P4_ratio + 1.0) / ((p->gears_P1_ratio *
        p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio
        * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio + (p->gears_P1_ratio *
        p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0
        * (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * (p->gears_P1_ratio * p->gears_P1_ratio)
        * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P1_ratio * p->gears_P1_ratio) *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * (p->gears_P1_ratio
        * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P4_ratio + (p->gears_P1_ratio *
        p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_input_inertia +
        p->gears_output_inertia * ((p->gears_P2_ratio * p->gears_P2_ratio) + 2.0 * p->gears_P2_ratio + 1.0) /
        ((p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P2_inertia_carrier / (p->gears_P1_ratio * p->gears_P1_ratio) + p->gears_P2_inertia_ring *
        ((p->gears_P2_ratio * p->gears_P2_ratio) + 2.0 * p->gears_P2_ratio + 1.0) / ((p->gears_P1_ratio *
        p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_a_inertia / (p->gears_P1_ratio *
        p->gears_P1_ratio) + p->gears_P3_inertia_sun * ((p->gears_P2_ratio * p->gears_P2_ratio) + 2.0 *
        p->gears_P2_ratio + 1.0) / ((p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio *
        p->gears_P2_ratio)) + p->gears_P4_inertia_sun * ((p->gears_P2_ratio * p->gears_P2_ratio) + 2.0 *
        p->gears_P2_ratio + 1.0) / ((p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio *
        p->gears_P2_ratio)) + p->gears_b_inertia * ((p->gears_P2_ratio * p->gears_P2_ratio) + 2.0 *
        p->gears_P2_ratio + 1.0) / ((p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio *
        p->gears_P2_ratio));
    mass[5][5] = p->M1_inertia;
    mass[6][6] = p->M2_inertia;
    mass[7][7] = p->flange1_inertia;
    mass[8][8] = p->flange2_inertia;
    /* M dz/dt = B' u - E'(C e + D E z) - G'(T + k_v G z) */
    forces[15][0] = -1.0;
    forces[22][0] = 1.0;
    forces[24][0] = -1.0;
    forces[16][1] = -1.0;
    forces[20][1] = -1.0 / p->gears_P2_ratio;
    forces[21][1] = -(p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio - p->gears_P3_ratio -
        p->gears_P4_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P2_ratio *
        p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio);
    forces[22][1] = 1.0;
    forces[23][1] = -(p->gears_P2_ratio + 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio);
    forces[24][1] = -1.0;
    forces[25][1] = 1.0;
    forces[17][2] = -1.0;
    forces[20][2] = 1.0 / p->gears_P2_ratio;
    forces[21][2] = -(p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P2_ratio);
    forces[23][2] = 1.0 / (p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio);
    forces[18][3] = -1.0;
    forces[21][3] = p->gears_P3_ratio * p->gears_P4_ratio / (p->gears_P3_ratio * p->gears_P4_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0);
    forces[23][3] = -p->gears_P3_ratio / (p->gears_P3_ratio + 1.0);
    forces[19][4] = -1.0;
    forces[20][4] = -(-p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio);
    forces[21][4] = -(p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio + p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio + p->gears_P3_ratio + p->gears_P4_ratio + 1.0) /
        (p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio);
    forces[22][4] = 1.0;
    forces[23][4] = -(-p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio);
    forces[24][4] = -1.0;
    forces[25][4] = 1.0;
    forces[5][5] = -p->flange1_damping;
    forces[7][5] = p->flange1_damping;
    forces[9][5] = -p->flange1_stiffness;
    forces[13][5] = 1.0;
    forces[6][6] = -p->flange2_damping;
    forces[8][6] = p->flange2_damping;
    forces[12][6] = -p->flange2_stiffness;
    forces[14][6] = 1.0;
    forces[5][7] = p->flange1_damping;
    forces[7][7] = -p->flange1_damping;
    forces[9][7] = p->flange1_stiffness;
    forces[22][7] = -1.0;
    forces[6][8] = p->flange2_damping;
    forces[8][8] = -p->flange2_damping;
    forces[12][8] = p->flange2_stiffness;
    forces[23][8] = 1.0;
    if (!transmission_nine_speed_cholesky_solve(9, 26, &mass[0][0], &forces[0][0], &rates[0][0])) {
        return transmission_nine_speed_plant_mass_matrix;
    }
    transmission_nine_speed_insert(9, 16, 12, 0, 0, 0, 13, &A[0][0], &rates[0][0]);
    /* de/dt = E z */
    A[5][9] = 1.0;
    A[7][9] = -1.0;
    A[0][10] = -1.0;
    A[1][10] = -1.0;
    A[4][10] = -1.0;
    A[7][10] = 1.0;
    A[1][11] = 1.0;
    A[2][11] = -1.0 / (p->gears_P2_ratio + 1.0);
    A[3][11] = p->gears_P2_ratio * p->gears_P3_ratio / (p->gears_P2_ratio + 1.0);
    A[4][11] = -1.0 / p->gears_P1_ratio;
    A[8][11] = (-p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P2_ratio) / (p->gears_P2_ratio + 1.0);
    A[6][12] = 1.0;
    A[8][12] = -1.0;
    transmission_nine_speed_insert(9, 16, 12, 0, 13, 13, 1, &A[0][0], &rates[0][0]);
    /* lag of the torque loop */
    A[13][13] = -1.0 / p->M1_inverter_time_constant;
    A[15][13] = 1.0 / p->M1_inverter_time_constant;
    transmission_nine_speed_insert(9, 16, 12, 0, 14, 14, 1, &A[0][0], &rates[0][0]);
    A[14][14] = -1.0 / p->M2_inverter_time_constant;
    A[16][14] = 1.0 / p->M2_inverter_time_constant;
    transmission_nine_speed_insert(9, 16, 12, 0, 17, 15, 11, &A[0][0], &rates[0][0]);
    scale[0] = 1.0;
    scale[1] = 1.0;
    scale[2] = 1.0;
    scale[3] = 1.0;
    scale[4] = 1.0;
    scale[5] = 1.0;
    scale[6] = 1.0;
    scale[7] = 1.0;
    scale[8] = 1.0;
    scale[9] = p->sample_time;
    scale[10] = p->sample_time;
    scale[11] = p->sample_time;
    scale[12] = p->sample_time;
    scale[13] = 1.0;
    scale[14] = 1.0;
    scale[15] = 1.0;
    scale[16] = 1.0;
    scale[17] = 1.0;
    scale[18] = 1.0;
    scale[19] = 1.0;
    scale[20] = 1.0;
    scale[21] = 1.0;
    scale[22] = 1.0;
    scale[23] = 1.0;
    scale[24] = 1.0;
    scale[25] = 1.0;
    scale[26] = 1.0;
    scale[27] = 1.0;
    /* exact discretisation */
    if (!transmission_nine_speed_discretise(15, 28, 5, &A[0][0], scale, p->sample_time, &whole[0][0])) {
        return transmission_nine_speed_plant_exponential_range;
    }
    transmission_nine_speed_insert(15, 16, 16, 0, 0, 0, 15, &s->transition[0][0], &whole[0][0]);
    /* dead time = (d + f) h */
    s->M1_dead_steps = transmission_nine_speed_floor(p->M1_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const transmission_nine_speed_real M1_late_time = p->sample_time - transmission_nine_speed_max(0.0,
        -s->M1_dead_steps * p->sample_time + p->M1_inverter_dead_time);
    if (!transmission_nine_speed_discretise(15, 28, 5, &A[0][0], scale, M1_late_time, &late[0][0])) {
        return transmission_nine_speed_plant_exponential_range;
    }
    transmission_nine_speed_difference(15, 28, &whole[0][0], &late[0][0], &early[0][0]);
    transmission_nine_speed_insert(15, 16, 16, 0, 15, 15, 1, &s->transition[0][0], &late[0][0]);
    transmission_nine_speed_insert(15, 16, 16, 0, 17, 15, 1, &s->transition[0][0], &early[0][0]);
    /* dead time = (d + f) h */
    s->M2_dead_steps = transmission_nine_speed_floor(p->M2_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const transmission_nine_speed_real M2_late_time = p->sample_time - transmission_nine_speed_max(0.0,
        -s->M2_dead_steps * p->sample_time + p->M2_inverter_dead_time);
    if (!transmission_nine_speed_discretise(15, 28, 5, &A[0][0], scale, M2_late_time, &late[0][0])) {
        return transmission_nine_speed_plant_exponential_range;
    }
    transmission_nine_speed_difference(15, 28, &whole[0][0], &late[0][0], &early[0][0]);
    transmission_nine_speed_insert(15, 16, 16, 0, 16, 16, 1, &s->transition[0][0], &late[0][0]);
    transmission_nine_speed_insert(15, 16, 16, 0, 18, 16, 1, &s->transition[0][0], &early[0][0]);
    transmission_nine_speed_insert(15, 16, 16, 0, 0, 17, 11, &s->gamma[0][0], &whole[0][0]);
    /* K = -G Gamma_f */
    s->K[0][0] = -whole[17][0];
    s->K[1][0] = -whole[18][0];
    s->K[2][0] = -whole[19][0];
    s->K[3][0] = -whole[20][0];
    s->K[4][0] = -whole[21][0];
    s->K[5][0] = -whole[22][0];
    s->K[6][0] = -whole[23][0];
    s->K[0][1] = -whole[17][1];
    s->K[1][1] = -whole[18][1];
    s->K[2][1] = -whole[19][1];
    s->K[3][1] = -whole[20][1];
    s->K[4][1] = -whole[21][1];
    s->K[5][1] = -whole[22][1];
    s->K[6][1] = -whole[23][1];
    s->K[0][2] = -whole[17][2];
    s->K[1][2] = -whole[18][2];
    s->K[2][2] = -whole[19][2];
    s->K[3][2] = -whole[20][2];
    s->K[4][2] = -whole[21][2];
    s->K[5][2] = -whole[22][2];
    s->K[6][2] = -whole[23][2];
    s->K[0][3] = -whole[17][3];
    s->K[1][3] = -whole[18][3];
    s->K[2][3] = -whole[19][3];
    s->K[3][3] = -whole[20][3];
    s->K[4][3] = -whole[21][3];
    s->K[5][3] = -whole[22][3];
    s->K[6][3] = -whole[23][3];
    s->K[0][4] = -whole[17][4];
    s->K[1][4] = -whole[18][4];
    s->K[2][4] = -whole[19][4];
    s->K[3][4] = -whole[20][4];
    s->K[4][4] = -whole[21][4];
    s->K[5][4] = -whole[22][4];
    s->K[6][4] = -whole[23][4];
    s->K[0][5] = -whole[17][1] / p->gears_P2_ratio + whole[17][2] / p->gears_P2_ratio - whole[17][4] *
        (-p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[1][5] = -whole[18][1] / p->gears_P2_ratio + whole[18][2] / p->gears_P2_ratio - whole[18][4] *
        (-p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[2][5] = -whole[19][1] / p->gears_P2_ratio + whole[19][2] / p->gears_P2_ratio - whole[19][4] *
        (-p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[3][5] = -whole[20][1] / p->gears_P2_ratio + whole[20][2] / p->gears_P2_ratio - whole[20][4] *
        (-p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[4][5] = -whole[21][1] / p->gears_P2_ratio + whole[21][2] / p->gears_P2_ratio - whole[21][4] *
        (-p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[5][5] = -whole[22][1] / p->gears_P2_ratio + whole[22][2] / p->gears_P2_ratio - whole[22][4] *
        (-p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[6][5] = -whole[23][1] / p->gears_P2_ratio + whole[23][2] / p->gears_P2_ratio - whole[23][4] *
        (-p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[0][6] = p->gears_P3_ratio * p->gears_P4_ratio * whole[17][3] / (p->gears_P3_ratio * p->gears_P4_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) - whole[17][1] * (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio - p->gears_P3_ratio - p->gears_P4_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P2_ratio) - whole[17][2] * (p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio) - whole[17][4] * (p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio +
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[1][6] = p->gears_P3_ratio * p->gears_P4_ratio * whole[18][3] / (p->gears_P3_ratio * p->gears_P4_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) - whole[18][1] * (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio - p->gears_P3_ratio - p->gears_P4_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P2_ratio) - whole[18][2] * (p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio) - whole[18][4] * (p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio +
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[2][6] = p->gears_P3_ratio * p->gears_P4_ratio * whole[19][3] / (p->gears_P3_ratio * p->gears_P4_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) - whole[19][1] * (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio - p->gears_P3_ratio - p->gears_P4_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P2_ratio) - whole[19][2] * (p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio) - whole[19][4] * (p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio +
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[3][6] = p->gears_P3_ratio * p->gears_P4_ratio * whole[20][3] / (p->gears_P3_ratio * p->gears_P4_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) - whole[20][1] * (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio - p->gears_P3_ratio - p->gears_P4_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P2_ratio) - whole[20][2] * (p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio) - whole[20][4] * (p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio +
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[4][6] = p->gears_P3_ratio * p->gears_P4_ratio * whole[21][3] / (p->gears_P3_ratio * p->gears_P4_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) - whole[21][1] * (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio - p->gears_P3_ratio - p->gears_P4_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P2_ratio) - whole[21][2] * (p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio) - whole[21][4] * (p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio +
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[5][6] = p->gears_P3_ratio * p->gears_P4_ratio * whole[22][3] / (p->gears_P3_ratio * p->gears_P4_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) - whole[22][1] * (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio - p->gears_P3_ratio - p->gears_P4_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P2_ratio) - whole[22][2] * (p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio) - whole[22][4] * (p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio +
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[6][6] = p->gears_P3_ratio * p->gears_P4_ratio * whole[23][3] / (p->gears_P3_ratio * p->gears_P4_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) - whole[23][1] * (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio - p->gears_P3_ratio - p->gears_P4_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P2_ratio) - whole[23][2] * (p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio) - whole[23][4] * (p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio +
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio);
    /* of a sum of velocities */
    transmission_nine_speed_rounding_unit(&s->velocity_rounding);
    /* friction can be solved */
    if (!transmission_nine_speed_require_definite(7, 1, &s->K[0][0])) {
        return transmission_nine_speed_plant_friction_matrix;
    }
    /* twist lost per torque of a contact */
    s->kappa[0][0] = -whole[24][10];
    s->kappa[1][0] = -whole[25][10];
    s->kappa[0][1] = -whole[24][11] * (p->gears_P2_ratio + 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P2_ratio);
    s->kappa[1][1] = -whole[25][11] * (p->gears_P2_ratio + 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P2_ratio);
    /* (3.5) */
    s->half_gap[0] = (0.5) * p->shaft1_backlash;
    s->contact_stiffness[0] = p->shaft1_stiffness;
    s->contact_damping[0] = p->shaft1_damping / p->sample_time;
    s->half_gap[1] = (0.5) * p->shaft2_backlash;
    s->contact_stiffness[1] = p->shaft2_stiffness;
    s->contact_damping[1] = p->shaft2_damping / p->sample_time;
    /* d'Alembert */
    s->gears_input_torque_reaction[0] = -p->converter_inertia_turbine * rates[0][1] - p->converter_inertia_turbine *
        rates[0][4];
    s->gears_input_torque_reaction[1] = -p->converter_inertia_turbine * rates[1][1] - p->converter_inertia_turbine *
        rates[1][4];
    s->gears_input_torque_reaction[2] = -p->converter_inertia_turbine * rates[2][1] - p->converter_inertia_turbine *
        rates[2][4];
    s->gears_input_torque_reaction[3] = -p->converter_inertia_turbine * rates[3][1] - p->converter_inertia_turbine *
        rates[3][4];
    s->gears_input_torque_reaction[4] = -p->converter_inertia_turbine * rates[4][1] - p->converter_inertia_turbine *
        rates[4][4];
    s->gears_input_torque_reaction[5] = -p->converter_inertia_turbine * rates[5][1] - p->converter_inertia_turbine *
        rates[5][4];
    s->gears_input_torque_reaction[6] = -p->converter_inertia_turbine * rates[6][1] - p->converter_inertia_turbine *
        rates[6][4];
    s->gears_input_torque_reaction[7] = -p->converter_inertia_turbine * rates[7][1] - p->converter_inertia_turbine *
        rates[7][4];
    s->gears_input_torque_reaction[8] = -p->converter_inertia_turbine * rates[8][1] - p->converter_inertia_turbine *
        rates[8][4];
    s->gears_input_torque_reaction[9] = -p->converter_inertia_turbine * rates[9][1] - p->converter_inertia_turbine *
        rates[9][4];
    s->gears_input_torque_reaction[10] = -p->converter_inertia_turbine * rates[10][1] - p->converter_inertia_turbine
        * rates[10][4];
    s->gears_input_torque_reaction[11] = -p->converter_inertia_turbine * rates[11][1] - p->converter_inertia_turbine
        * rates[11][4];
    s->gears_input_torque_reaction[12] = -p->converter_inertia_turbine * rates[12][1] - p->converter_inertia_turbine
        * rates[12][4];
    s->gears_input_torque_reaction[13] = -p->converter_inertia_turbine * rates[13][1] - p->converter_inertia_turbine
        * rates[13][4];
    s->gears_input_torque_reaction[14] = -p->converter_inertia_turbine * rates[14][1] - p->converter_inertia_turbine
        * rates[14][4];
    s->gears_input_torque_reaction[15] = -p->converter_inertia_turbine * rates[15][1] - p->converter_inertia_turbine
        * rates[15][4];
    s->gears_input_torque_reaction[16] = -p->converter_inertia_turbine * rates[16][1] - p->converter_inertia_turbine
        * rates[16][4];
    s->gears_input_torque_reaction[17] = -p->converter_inertia_turbine * rates[17][1] - p->converter_inertia_turbine
        * rates[17][4];
    s->gears_input_torque_reaction[18] = -p->converter_inertia_turbine * rates[18][1] - p->converter_inertia_turbine
        * rates[18][4];
    s->gears_input_torque_reaction[19] = -p->converter_inertia_turbine * rates[19][1] - p->converter_inertia_turbine
        * rates[19][4];
    s->gears_input_torque_reaction[20] = -p->converter_inertia_turbine * rates[20][1] - p->converter_inertia_turbine
        * rates[20][4];
    s->gears_input_torque_reaction[21] = -p->converter_inertia_turbine * rates[21][1] - p->converter_inertia_turbine
        * rates[21][4];
    s->gears_input_torque_reaction[22] = -p->converter_inertia_turbine * rates[22][1] - p->converter_inertia_turbine
        * rates[22][4];
    s->gears_input_torque_reaction[23] = -p->converter_inertia_turbine * rates[23][1] - p->converter_inertia_turbine
        * rates[23][4];
    s->gears_input_torque_reaction[24] = -p->converter_inertia_turbine * rates[24][1] - p->converter_inertia_turbine
        * rates[24][4];
    s->gears_input_torque_reaction[25] = -p->converter_inertia_turbine * rates[25][1] - p->converter_inertia_turbine
        * rates[25][4];
    return transmission_nine_speed_plant_ok;
}

void transmission_nine_speed_plant_measure(const transmission_nine_speed_plant_state *s, const transmission_nine_speed_plant_params *p, transmission_nine_speed_plant_outputs *out)
{
    out->M1_speed = s->x[5];
    out->flange1_torque = p->flange1_damping * s->x[5] - p->flange1_damping * s->x[7] + p->flange1_stiffness *
        s->x[9];
    out->flange2_torque = -p->flange2_damping * s->x[6] + p->flange2_damping * s->x[8] - p->flange2_stiffness *
        s->x[12];
    out->M2_speed = s->x[6];
    out->gears_input_torque = s->contact_torque[0] * s->gears_input_torque_reaction[22] + s->contact_torque[1] *
        s->gears_input_torque_reaction[23] + s->fluid_torque[0] * s->gears_input_torque_reaction[24] +
        s->fluid_torque[1] * (s->gears_input_torque_reaction[25] + 1.0) + s->friction_torque[0] *
        (s->gears_input_torque_reaction[15] + 1.0) + s->friction_torque[1] * s->gears_input_torque_reaction[16] +
        s->friction_torque[2] * s->gears_input_torque_reaction[17] + s->friction_torque[3] *
        s->gears_input_torque_reaction[18] + s->friction_torque[4] * s->gears_input_torque_reaction[19] +
        s->friction_torque[5] * s->gears_input_torque_reaction[20] + s->friction_torque[6] *
        s->gears_input_torque_reaction[21] + s->gears_input_torque_reaction[0] * s->x[0] +
        s->gears_input_torque_reaction[10] * s->x[10] + s->gears_input_torque_reaction[11] * s->x[11] +
        s->gears_input_torque_reaction[12] * s->x[12] + s->gears_input_torque_reaction[13] * s->x[13] +
        s->gears_input_torque_reaction[14] * s->x[14] + s->gears_input_torque_reaction[1] * s->x[1] +
        s->gears_input_torque_reaction[2] * s->x[2] + s->gears_input_torque_reaction[3] * s->x[3] +
        s->gears_input_torque_reaction[4] * s->x[4] + s->gears_input_torque_reaction[5] * s->x[5] +
        s->gears_input_torque_reaction[6] * s->x[6] + s->gears_input_torque_reaction[7] * s->x[7] +
        s->gears_input_torque_reaction[8] * s->x[8] + s->gears_input_torque_reaction[9] * s->x[9];
    out->M1_torque = s->x[13];
    out->M2_torque = s->x[14];
    out->converter_lockup_speed = s->x[0];
    out->converter_lockup_torque = s->friction_torque[0];
    out->gears_A_speed = s->x[1];
    out->gears_A_torque = s->friction_torque[1];
    out->gears_B_speed = s->x[2];
    out->gears_B_torque = s->friction_torque[2];
    out->gears_C_speed = s->x[3];
    out->gears_C_torque = s->friction_torque[3];
    out->gears_D_speed = s->x[4];
    out->gears_D_torque = s->friction_torque[4];
    out->gears_E_speed = transmission_nine_speed_select(transmission_nine_speed_abs(s->G[1][5] * s->x[1] +
        s->G[2][5] * s->x[2] + s->G[4][5] * s->x[4]) < p->standstill_speed + s->velocity_rounding *
        (transmission_nine_speed_abs(s->G[1][5] * s->x[1]) + transmission_nine_speed_abs(s->G[2][5] * s->x[2]) +
        transmission_nine_speed_abs(s->G[4][5] * s->x[4])), 0.0, s->G[1][5] * s->x[1] + s->G[2][5] * s->x[2] +
        s->G[4][5] * s->x[4]);
    out->gears_E_torque = s->friction_torque[5];
    out->gears_F_speed = transmission_nine_speed_select(transmission_nine_speed_abs(s->G[1][6] * s->x[1] +
        s->G[2][6] * s->x[2] + s->G[3][6] * s->x[3] + s->G[4][6] * s->x[4]) < p->standstill_speed +
        s->velocity_rounding * (transmission_nine_speed_abs(s->G[1][6] * s->x[1]) +
        transmission_nine_speed_abs(s->G[2][6] * s->x[2]) + transmission_nine_speed_abs(s->G[3][6] * s->x[3]) +
        transmission_nine_speed_abs(s->G[4][6] * s->x[4])), 0.0, s->G[1][6] * s->x[1] + s->G[2][6] * s->x[2] +
        s->G[3][6] * s->x[3] + s->G[4][6] * s->x[4]);
    out->gears_F_torque = s->friction_torque[6];
    out->converter_fluid_pump_torque = s->fluid_torque[0];
    out->converter_fluid_turbine_torque = s->fluid_torque[1];
}

/* Status of the first input that is not finite or outside its range. */
static int check_inputs(const transmission_nine_speed_plant_inputs *in)
{
    if (!transmission_nine_speed_is_finite(in->M1_torque_ref)) {
        return (int)transmission_nine_speed_plant_bad_input_M1_torque_ref;
    }
    if (!transmission_nine_speed_is_finite(in->M2_torque_ref)) {
        return (int)transmission_nine_speed_plant_bad_input_M2_torque_ref;
    }
    if (!(in->converter_lockup_actuation >= 0.0 && in->converter_lockup_actuation <= 1.0)) {
        return (int)transmission_nine_speed_plant_bad_input_converter_lockup_actuation;
    }
    if (!(in->gears_A_actuation >= 0.0 && in->gears_A_actuation <= 1.0)) {
        return (int)transmission_nine_speed_plant_bad_input_gears_A_actuation;
    }
    if (!(in->gears_B_actuation >= 0.0 && in->gears_B_actuation <= 1.0)) {
        return (int)transmission_nine_speed_plant_bad_input_gears_B_actuation;
    }
    if (!(in->gears_C_actuation >= 0.0 && in->gears_C_actuation <= 1.0)) {
        return (int)transmission_nine_speed_plant_bad_input_gears_C_actuation;
    }
    if (!(in->gears_D_actuation >= 0.0 && in->gears_D_actuation <= 1.0)) {
        return (int)transmission_nine_speed_plant_bad_input_gears_D_actuation;
    }
    if (!(in->gears_E_actuation >= 0.0 && in->gears_E_actuation <= 1.0)) {
        return (int)transmission_nine_speed_plant_bad_input_gears_E_actuation;
    }
    if (!(in->gears_F_actuation >= 0.0 && in->gears_F_actuation <= 1.0)) {
        return (int)transmission_nine_speed_plant_bad_input_gears_F_actuation;
    }
    return 0;
}

transmission_nine_speed_plant_status transmission_nine_speed_plant_step(transmission_nine_speed_plant_state *s, const transmission_nine_speed_plant_params *p,
    const transmission_nine_speed_plant_inputs *in, transmission_nine_speed_plant_outputs *out)
{
    const int bad = check_inputs(in);
    if (bad != 0) {
        transmission_nine_speed_plant_measure(s, p, out);
        return (transmission_nine_speed_plant_status)bad;
    }
    transmission_nine_speed_real x_free[16];
    transmission_nine_speed_real mean_torque[12];
    transmission_nine_speed_real w_start[8];
    transmission_nine_speed_real w_free[8];
    transmission_nine_speed_real w_plus[8];
    transmission_nine_speed_real slide[8];
    transmission_nine_speed_real rest[8];
    transmission_nine_speed_real friction_mean[8];
    transmission_nine_speed_real twist_start[4];
    transmission_nine_speed_real twist_free[4];
    transmission_nine_speed_real contact_mean[4];
    transmission_nine_speed_zero(sizeof x_free, x_free);
    transmission_nine_speed_zero(sizeof mean_torque, mean_torque);
    transmission_nine_speed_zero(sizeof w_start, w_start);
    transmission_nine_speed_zero(sizeof w_free, w_free);
    transmission_nine_speed_zero(sizeof w_plus, w_plus);
    transmission_nine_speed_zero(sizeof slide, slide);
    transmission_nine_speed_zero(sizeof rest, rest);
    transmission_nine_speed_zero(sizeof friction_mean, friction_mean);
    transmission_nine_speed_zero(sizeof twist_start, twist_start);
    transmission_nine_speed_zero(sizeof twist_free, twist_free);
    transmission_nine_speed_zero(sizeof contact_mean, contact_mean);
    
    /* torque-speed envelope, Figure 7.1 */
    const transmission_nine_speed_real M1_available = p->M1_speed_rated * p->M1_torque_max /
        transmission_nine_speed_max(p->M1_speed_rated, transmission_nine_speed_abs(s->x[5]));
    const transmission_nine_speed_real M1_limited = transmission_nine_speed_max(-M1_available,
        transmission_nine_speed_min(M1_available, in->M1_torque_ref));
    /* dead time of the torque loop */
    transmission_nine_speed_delay(16, s->M1_delay, M1_limited, s->M1_dead_steps, &s->x[15], &s->x[17]);
    /* torque-speed envelope, Figure 7.1 */
    const transmission_nine_speed_real M2_available = p->M2_speed_rated * p->M2_torque_max /
        transmission_nine_speed_max(p->M2_speed_rated, transmission_nine_speed_abs(s->x[6]));
    const transmission_nine_speed_real M2_limited = transmission_nine_speed_max(-M2_available,
        transmission_nine_speed_min(M2_available, in->M2_torque_ref));
    /* dead time of the torque loop */
    transmission_nine_speed_delay(16, s->M2_delay, M2_limited, s->M2_dead_steps, &s->x[16], &s->x[18]);
    /* x+ = Phi x + Gamma_u u */
    transmission_nine_speed_multiply(15, 19, &s->transition[0][0], s->x, x_free);
    /* speeds by the reference speed */
    const transmission_nine_speed_real converter_fluid_pump_mid = ((0.5) * s->contact_torque[0] * s->gamma[7][0] +
        (0.5) * s->contact_torque[0] * s->gamma[7][1] + (0.5) * s->contact_torque[0] * s->gamma[7][4] + (0.5) *
        s->contact_torque[1] * s->gamma[8][0] + (0.5) * s->contact_torque[1] * s->gamma[8][1] + (0.5) *
        s->contact_torque[1] * s->gamma[8][4] + (0.5) * s->fluid_torque[0] * s->gamma[9][0] + (0.5) *
        s->fluid_torque[0] * s->gamma[9][1] + (0.5) * s->fluid_torque[0] * s->gamma[9][4] + (0.5) *
        s->fluid_torque[1] * s->gamma[10][0] + (0.5) * s->fluid_torque[1] * s->gamma[10][1] + (0.5) *
        s->fluid_torque[1] * s->gamma[10][4] + (0.5) * s->friction_torque[0] * s->gamma[0][0] + (0.5) *
        s->friction_torque[0] * s->gamma[0][1] + (0.5) * s->friction_torque[0] * s->gamma[0][4] + (0.5) *
        s->friction_torque[1] * s->gamma[1][0] + (0.5) * s->friction_torque[1] * s->gamma[1][1] + (0.5) *
        s->friction_torque[1] * s->gamma[1][4] + (0.5) * s->friction_torque[2] * s->gamma[2][0] + (0.5) *
        s->friction_torque[2] * s->gamma[2][1] + (0.5) * s->friction_torque[2] * s->gamma[2][4] + (0.5) *
        s->friction_torque[3] * s->gamma[3][0] + (0.5) * s->friction_torque[3] * s->gamma[3][1] + (0.5) *
        s->friction_torque[3] * s->gamma[3][4] + (0.5) * s->friction_torque[4] * s->gamma[4][0] + (0.5) *
        s->friction_torque[4] * s->gamma[4][1] + (0.5) * s->friction_torque[4] * s->gamma[4][4] + (0.5) *
        s->friction_torque[5] * s->gamma[5][0] + (0.5) * s->friction_torque[5] * s->gamma[5][1] + (0.5) *
        s->friction_torque[5] * s->gamma[5][4] + (0.5) * s->friction_torque[6] * s->gamma[6][0] + (0.5) *
        s->friction_torque[6] * s->gamma[6][1] + (0.5) * s->friction_torque[6] * s->gamma[6][4] + (0.5) * s->x[0] +
        (0.5) * s->x[1] + (0.5) * s->x[4] + (0.5) * x_free[0] + (0.5) * x_free[1] + (0.5) * x_free[4]) /
        p->converter_reference_speed;
    const transmission_nine_speed_real converter_fluid_turbine_mid = ((0.5) * s->contact_torque[0] * s->gamma[7][1]
        + (0.5) * s->contact_torque[0] * s->gamma[7][4] + (0.5) * s->contact_torque[1] * s->gamma[8][1] + (0.5) *
        s->contact_torque[1] * s->gamma[8][4] + (0.5) * s->fluid_torque[0] * s->gamma[9][1] + (0.5) *
        s->fluid_torque[0] * s->gamma[9][4] + (0.5) * s->fluid_torque[1] * s->gamma[10][1] + (0.5) *
        s->fluid_torque[1] * s->gamma[10][4] + (0.5) * s->friction_torque[0] * s->gamma[0][1] + (0.5) *
        s->friction_torque[0] * s->gamma[0][4] + (0.5) * s->friction_torque[1] * s->gamma[1][1] + (0.5) *
        s->friction_torque[1] * s->gamma[1][4] + (0.5) * s->friction_torque[2] * s->gamma[2][1] + (0.5) *
        s->friction_torque[2] * s->gamma[2][4] + (0.5) * s->friction_torque[3] * s->gamma[3][1] + (0.5) *
        s->friction_torque[3] * s->gamma[3][4] + (0.5) * s->friction_torque[4] * s->gamma[4][1] + (0.5) *
        s->friction_torque[4] * s->gamma[4][4] + (0.5) * s->friction_torque[5] * s->gamma[5][1] + (0.5) *
        s->friction_torque[5] * s->gamma[5][4] + (0.5) * s->friction_torque[6] * s->gamma[6][1] + (0.5) *
        s->friction_torque[6] * s->gamma[6][4] + (0.5) * s->x[1] + (0.5) * s->x[4] + (0.5) * x_free[1] + (0.5) *
        x_free[4]) / p->converter_reference_speed;
    /* (3.37)-(3.39), all quadrants */
    transmission_nine_speed_fluid_torques(7, converter_fluid_pump_mid, converter_fluid_turbine_mid,
        &converter_fluid_knots[0][0], &converter_fluid_curves[0][0], &mean_torque[9], &mean_torque[10]);
    /* e = L x_e */
    twist_start[0] = s->x[10];
    twist_free[0] = s->friction_torque[0] * s->gamma[0][10] + s->friction_torque[1] * s->gamma[1][10] +
        s->friction_torque[2] * s->gamma[2][10] + s->friction_torque[3] * s->gamma[3][10] + s->friction_torque[4] *
        s->gamma[4][10] + s->friction_torque[5] * s->gamma[5][10] + s->friction_torque[6] * s->gamma[6][10] +
        s->gamma[10][10] * mean_torque[10] + s->gamma[9][10] * mean_torque[9] + x_free[10];
    twist_start[1] = s->L[2][1] * s->x[11];
    twist_free[1] = s->L[2][1] * (s->friction_torque[0] * s->gamma[0][11] + s->friction_torque[1] * s->gamma[1][11]
        + s->friction_torque[2] * s->gamma[2][11] + s->friction_torque[3] * s->gamma[3][11] + s->friction_torque[4]
        * s->gamma[4][11] + s->friction_torque[5] * s->gamma[5][11] + s->friction_torque[6] * s->gamma[6][11] +
        s->gamma[10][11] * mean_torque[10] + s->gamma[9][11] * mean_torque[9] + x_free[11]);
    /* (3.5) as a mean over the step */
    transmission_nine_speed_backlash_step(&s->kappa[0][0], twist_start, twist_free, s->half_gap,
        s->contact_stiffness, s->contact_damping, contact_mean);
    mean_torque[7] = contact_mean[0];
    mean_torque[8] = contact_mean[1];
    /* w = G z */
    w_start[0] = s->x[0];
    w_start[1] = s->x[1];
    w_start[2] = s->x[2];
    w_start[3] = s->x[3];
    w_start[4] = s->x[4];
    w_start[5] = transmission_nine_speed_select(transmission_nine_speed_abs(s->G[1][5] * s->x[1] + s->G[2][5] *
        s->x[2] + s->G[4][5] * s->x[4]) < p->standstill_speed + s->velocity_rounding *
        (transmission_nine_speed_abs(s->G[1][5] * s->x[1]) + transmission_nine_speed_abs(s->G[2][5] * s->x[2]) +
        transmission_nine_speed_abs(s->G[4][5] * s->x[4])), 0.0, s->G[1][5] * s->x[1] + s->G[2][5] * s->x[2] +
        s->G[4][5] * s->x[4]);
    w_start[6] = transmission_nine_speed_select(transmission_nine_speed_abs(s->G[1][6] * s->x[1] + s->G[2][6] *
        s->x[2] + s->G[3][6] * s->x[3] + s->G[4][6] * s->x[4]) < p->standstill_speed + s->velocity_rounding *
        (transmission_nine_speed_abs(s->G[1][6] * s->x[1]) + transmission_nine_speed_abs(s->G[2][6] * s->x[2]) +
        transmission_nine_speed_abs(s->G[3][6] * s->x[3]) + transmission_nine_speed_abs(s->G[4][6] * s->x[4])), 0.0,
        s->G[1][6] * s->x[1] + s->G[2][6] * s->x[2] + s->G[3][6] * s->x[3] + s->G[4][6] * s->x[4]);
    /* speed at mid-step */
    const transmission_nine_speed_real converter_lockup_mid_speed = (0.5) *
        transmission_nine_speed_abs(contact_mean[0] * s->gamma[7][0] + contact_mean[1] * s->gamma[8][0] +
        s->friction_torque[0] * s->gamma[0][0] + s->friction_torque[1] * s->gamma[1][0] + s->friction_torque[2] *
        s->gamma[2][0] + s->friction_torque[3] * s->gamma[3][0] + s->friction_torque[4] * s->gamma[4][0] +
        s->friction_torque[5] * s->gamma[5][0] + s->friction_torque[6] * s->gamma[6][0] + s->gamma[10][0] *
        mean_torque[10] + s->gamma[9][0] * mean_torque[9] + w_start[0] + x_free[0]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[0] = in->converter_lockup_actuation * (p->converter_lockup_capacity + converter_lockup_mid_speed *
        p->converter_lockup_viscous + (-p->converter_lockup_capacity + p->converter_lockup_static) *
        transmission_nine_speed_exp(-converter_lockup_mid_speed / p->converter_lockup_stribeck_speed));
    rest[0] = in->converter_lockup_actuation * p->converter_lockup_static;
    /* speed at mid-step */
    const transmission_nine_speed_real gears_A_mid_speed = (0.5) * transmission_nine_speed_abs(contact_mean[0] *
        s->gamma[7][1] + contact_mean[1] * s->gamma[8][1] + s->friction_torque[0] * s->gamma[0][1] +
        s->friction_torque[1] * s->gamma[1][1] + s->friction_torque[2] * s->gamma[2][1] + s->friction_torque[3] *
        s->gamma[3][1] + s->friction_torque[4] * s->gamma[4][1] + s->friction_torque[5] * s->gamma[5][1] +
        s->friction_torque[6] * s->gamma[6][1] + s->gamma[10][1] * mean_torque[10] + s->gamma[9][1] * mean_torque[9]
        + w_start[1] + x_free[1]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[1] = in->gears_A_actuation * (p->gears_A_capacity + gears_A_mid_speed * p->gears_A_viscous);
    rest[1] = in->gears_A_actuation * p->gears_A_capacity;
    /* speed at mid-step */
    const transmission_nine_speed_real gears_B_mid_speed = (0.5) * transmission_nine_speed_abs(contact_mean[0] *
        s->gamma[7][2] + contact_mean[1] * s->gamma[8][2] + s->friction_torque[0] * s->gamma[0][2] +
        s->friction_torque[1] * s->gamma[1][2] + s->friction_torque[2] * s->gamma[2][2] + s->friction_torque[3] *
        s->gamma[3][2] + s->friction_torque[4] * s->gamma[4][2] + s->friction_torque[5] * s->gamma[5][2] +
        s->friction_torque[6] * s->gamma[6][2] + s->gamma[10][2] * mean_torque[10] + s->gamma[9][2] * mean_torque[9]
        + w_start[2] + x_free[2]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[2] = in->gears_B_actuation * (p->gears_B_capacity + gears_B_mid_speed * p->gears_B_viscous);
    rest[2] = in->gears_B_actuation * p->gears_B_capacity;
    /* speed at mid-step */
    const transmission_nine_speed_real gears_C_mid_speed = (0.5) * transmission_nine_speed_abs(contact_mean[0] *
        s->gamma[7][3] + contact_mean[1] * s->gamma[8][3] + s->friction_torque[0] * s->gamma[0][3] +
        s->friction_torque[1] * s->gamma[1][3] + s->friction_torque[2] * s->gamma[2][3] + s->friction_torque[3] *
        s->gamma[3][3] + s->friction_torque[4] * s->gamma[4][3] + s->friction_torque[5] * s->gamma[5][3] +
        s->friction_torque[6] * s->gamma[6][3] + s->gamma[10][3] * mean_torque[10] + s->gamma[9][3] * mean_torque[9]
        + w_start[3] + x_free[3]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[3] = in->gears_C_actuation * (p->gears_C_capacity + gears_C_mid_speed * p->gears_C_viscous);
    rest[3] = in->gears_C_actuation * p->gears_C_capacity;
    /* speed at mid-step */
    const transmission_nine_speed_real gears_D_mid_speed = (0.5) * transmission_nine_speed_abs(contact_mean[0] *
        s->gamma[7][4] + contact_mean[1] * s->gamma[8][4] + s->friction_torque[0] * s->gamma[0][4] +
        s->friction_torque[1] * s->gamma[1][4] + s->friction_torque[2] * s->gamma[2][4] + s->friction_torque[3] *
        s->gamma[3][4] + s->friction_torque[4] * s->gamma[4][4] + s->friction_torque[5] * s->gamma[5][4] +
        s->friction_torque[6] * s->gamma[6][4] + s->gamma[10][4] * mean_torque[10] + s->gamma[9][4] * mean_torque[9]
        + w_start[4] + x_free[4]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[4] = in->gears_D_actuation * (p->gears_D_capacity + gears_D_mid_speed * p->gears_D_viscous);
    rest[4] = in->gears_D_actuation * p->gears_D_capacity;
    /* speed at mid-step */
    const transmission_nine_speed_real gears_E_mid_speed = (0.5) * transmission_nine_speed_abs(s->G[1][5] *
        (contact_mean[0] * s->gamma[7][1] + contact_mean[1] * s->gamma[8][1] + s->friction_torque[0] *
        s->gamma[0][1] + s->friction_torque[1] * s->gamma[1][1] + s->friction_torque[2] * s->gamma[2][1] +
        s->friction_torque[3] * s->gamma[3][1] + s->friction_torque[4] * s->gamma[4][1] + s->friction_torque[5] *
        s->gamma[5][1] + s->friction_torque[6] * s->gamma[6][1] + s->gamma[10][1] * mean_torque[10] + s->gamma[9][1]
        * mean_torque[9] + x_free[1]) + s->G[2][5] * (contact_mean[0] * s->gamma[7][2] + contact_mean[1] *
        s->gamma[8][2] + s->friction_torque[0] * s->gamma[0][2] + s->friction_torque[1] * s->gamma[1][2] +
        s->friction_torque[2] * s->gamma[2][2] + s->friction_torque[3] * s->gamma[3][2] + s->friction_torque[4] *
        s->gamma[4][2] + s->friction_torque[5] * s->gamma[5][2] + s->friction_torque[6] * s->gamma[6][2] +
        s->gamma[10][2] * mean_torque[10] + s->gamma[9][2] * mean_torque[9] + x_free[2]) + s->G[4][5] *
        (contact_mean[0] * s->gamma[7][4] + contact_mean[1] * s->gamma[8][4] + s->friction_torque[0] *
        s->gamma[0][4] + s->friction_torque[1] * s->gamma[1][4] + s->friction_torque[2] * s->gamma[2][4] +
        s->friction_torque[3] * s->gamma[3][4] + s->friction_torque[4] * s->gamma[4][4] + s->friction_torque[5] *
        s->gamma[5][4] + s->friction_torque[6] * s->gamma[6][4] + s->gamma[10][4] * mean_torque[10] + s->gamma[9][4]
        * mean_torque[9] + x_free[4]) + w_start[5]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[5] = in->gears_E_actuation * (p->gears_E_capacity + gears_E_mid_speed * p->gears_E_viscous);
    rest[5] = in->gears_E_actuation * p->gears_E_capacity;
    /* speed at mid-step */
    const transmission_nine_speed_real gears_F_mid_speed = (0.5) * transmission_nine_speed_abs(s->G[1][6] *
        (contact_mean[0] * s->gamma[7][1] + contact_mean[1] * s->gamma[8][1] + s->friction_torque[0] *
        s->gamma[0][1] + s->friction_torque[1] * s->gamma[1][1] + s->friction_torque[2] * s->gamma[2][1] +
        s->friction_torque[3] * s->gamma[3][1] + s->friction_torque[4] * s->gamma[4][1] + s->friction_torque[5] *
        s->gamma[5][1] + s->friction_torque[6] * s->gamma[6][1] + s->gamma[10][1] * mean_torque[10] + s->gamma[9][1]
        * mean_torque[9] + x_free[1]) + s->G[2][6] * (contact_mean[0] * s->gamma[7][2] + contact_mean[1] *
        s->gamma[8][2] + s->friction_torque[0] * s->gamma[0][2] + s->friction_torque[1] * s->gamma[1][2] +
        s->friction_torque[2] * s->gamma[2][2] + s->friction_torque[3] * s->gamma[3][2] + s->friction_torque[4] *
        s->gamma[4][2] + s->friction_torque[5] * s->gamma[5][2] + s->friction_torque[6] * s->gamma[6][2] +
        s->gamma[10][2] * mean_torque[10] + s->gamma[9][2] * mean_torque[9] + x_free[2]) + s->G[3][6] *
        (contact_mean[0] * s->gamma[7][3] + contact_mean[1] * s->gamma[8][3] + s->friction_torque[0] *
        s->gamma[0][3] + s->friction_torque[1] * s->gamma[1][3] + s->friction_torque[2] * s->gamma[2][3] +
        s->friction_torque[3] * s->gamma[3][3] + s->friction_torque[4] * s->gamma[4][3] + s->friction_torque[5] *
        s->gamma[5][3] + s->friction_torque[6] * s->gamma[6][3] + s->gamma[10][3] * mean_torque[10] + s->gamma[9][3]
        * mean_torque[9] + x_free[3]) + s->G[4][6] * (contact_mean[0] * s->gamma[7][4] + contact_mean[1] *
        s->gamma[8][4] + s->friction_torque[0] * s->gamma[0][4] + s->friction_torque[1] * s->gamma[1][4] +
        s->friction_torque[2] * s->gamma[2][4] + s->friction_torque[3] * s->gamma[3][4] + s->friction_torque[4] *
        s->gamma[4][4] + s->friction_torque[5] * s->gamma[5][4] + s->friction_torque[6] * s->gamma[6][4] +
        s->gamma[10][4] * mean_torque[10] + s->gamma[9][4] * mean_torque[9] + x_free[4]) + w_start[6]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[6] = in->gears_F_actuation * (p->gears_F_capacity + gears_F_mid_speed * p->gears_F_viscous);
    rest[6] = in->gears_F_actuation * p->gears_F_capacity;
    /* w_free = G z_free */
    w_free[0] = contact_mean[0] * s->gamma[7][0] + contact_mean[1] * s->gamma[8][0] + s->gamma[10][0] *
        mean_torque[10] + s->gamma[9][0] * mean_torque[9] + x_free[0];
    w_free[1] = contact_mean[0] * s->gamma[7][1] + contact_mean[1] * s->gamma[8][1] + s->gamma[10][1] *
        mean_torque[10] + s->gamma[9][1] * mean_torque[9] + x_free[1];
    w_free[2] = contact_mean[0] * s->gamma[7][2] + contact_mean[1] * s->gamma[8][2] + s->gamma[10][2] *
        mean_torque[10] + s->gamma[9][2] * mean_torque[9] + x_free[2];
    w_free[3] = contact_mean[0] * s->gamma[7][3] + contact_mean[1] * s->gamma[8][3] + s->gamma[10][3] *
        mean_torque[10] + s->gamma[9][3] * mean_torque[9] + x_free[3];
    w_free[4] = contact_mean[0] * s->gamma[7][4] + contact_mean[1] * s->gamma[8][4] + s->gamma[10][4] *
        mean_torque[10] + s->gamma[9][4] * mean_torque[9] + x_free[4];
    w_free[5] = s->G[1][5] * (contact_mean[0] * s->gamma[7][1] + contact_mean[1] * s->gamma[8][1] + s->gamma[10][1]
        * mean_torque[10] + s->gamma[9][1] * mean_torque[9] + x_free[1]) + s->G[2][5] * (contact_mean[0] *
        s->gamma[7][2] + contact_mean[1] * s->gamma[8][2] + s->gamma[10][2] * mean_torque[10] + s->gamma[9][2] *
        mean_torque[9] + x_free[2]) + s->G[4][5] * (contact_mean[0] * s->gamma[7][4] + contact_mean[1] *
        s->gamma[8][4] + s->gamma[10][4] * mean_torque[10] + s->gamma[9][4] * mean_torque[9] + x_free[4]);
    w_free[6] = s->G[1][6] * (contact_mean[0] * s->gamma[7][1] + contact_mean[1] * s->gamma[8][1] + s->gamma[10][1]
        * mean_torque[10] + s->gamma[9][1] * mean_torque[9] + x_free[1]) + s->G[2][6] * (contact_mean[0] *
        s->gamma[7][2] + contact_mean[1] * s->gamma[8][2] + s->gamma[10][2] * mean_torque[10] + s->gamma[9][2] *
        mean_torque[9] + x_free[2]) + s->G[3][6] * (contact_mean[0] * s->gamma[7][3] + contact_mean[1] *
        s->gamma[8][3] + s->gamma[10][3] * mean_torque[10] + s->gamma[9][3] * mean_torque[9] + x_free[3]) +
        s->G[4][6] * (contact_mean[0] * s->gamma[7][4] + contact_mean[1] * s->gamma[8][4] + s->gamma[10][4] *
        mean_torque[10] + s->gamma[9][4] * mean_torque[9] + x_free[4]);
    /* what sticks, slips and passes zero */
    transmission_nine_speed_friction_step(1, 0, &s->K[0][0], w_start, w_free, slide, rest, s->friction_torque,
        s->friction_rest, friction_mean, w_plus, &s->friction_status);
    mean_torque[0] = friction_mean[0];
    mean_torque[1] = friction_mean[1];
    mean_torque[2] = friction_mean[2];
    mean_torque[3] = friction_mean[3];
    mean_torque[4] = friction_mean[4];
    mean_torque[5] = friction_mean[5];
    mean_torque[6] = friction_mean[6];
    /* x+ = x_free + Gamma_f T */
    transmission_nine_speed_add_product(15, 11, s->x, x_free, &s->gamma[0][0], mean_torque);
    /* exactly zero while it sticks */
    s->x[0] = transmission_nine_speed_select(p->standstill_speed > transmission_nine_speed_abs(w_plus[0]), 0.0,
        w_plus[0]);
    s->x[1] = transmission_nine_speed_select(p->standstill_speed > transmission_nine_speed_abs(w_plus[1]), 0.0,
        w_plus[1]);
    s->x[2] = transmission_nine_speed_select(p->standstill_speed > transmission_nine_speed_abs(w_plus[2]), 0.0,
        w_plus[2]);
    s->x[3] = transmission_nine_speed_select(p->standstill_speed > transmission_nine_speed_abs(w_plus[3]), 0.0,
        w_plus[3]);
    s->x[4] = transmission_nine_speed_select(p->standstill_speed > transmission_nine_speed_abs(w_plus[4]), 0.0,
        w_plus[4]);
    const transmission_nine_speed_real shaft1_twist = s->x[10];
    /* (3.5) */
    s->contact_torque[0] = p->shaft1_stiffness * (shaft1_twist - transmission_nine_speed_max(-s->half_gap[0],
        transmission_nine_speed_min(s->half_gap[0], shaft1_twist))) + transmission_nine_speed_select(s->half_gap[0]
        < transmission_nine_speed_abs(shaft1_twist), p->shaft1_damping * (-s->x[0] - s->x[1] - s->x[4] + s->x[7]),
        0.0);
    const transmission_nine_speed_real shaft2_twist = s->L[2][1] * s->x[11];
    s->contact_torque[1] = p->shaft2_stiffness * (shaft2_twist - transmission_nine_speed_max(-s->half_gap[1],
        transmission_nine_speed_min(s->half_gap[1], shaft2_twist))) + transmission_nine_speed_select(s->half_gap[1]
        < transmission_nine_speed_abs(shaft2_twist), p->shaft2_damping * (p->gears_P3_ratio * s->x[3] /
        (p->gears_P3_ratio + 1.0) + s->x[1] * (p->gears_P2_ratio + 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P2_ratio) - s->x[2] / (p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio) + s->x[4] *
        (-p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio
        * p->gears_P2_ratio) - s->x[8]), 0.0);
    /* speeds by the reference speed */
    const transmission_nine_speed_real converter_fluid_pump_end = (s->x[0] + s->x[1] + s->x[4]) /
        p->converter_reference_speed;
    const transmission_nine_speed_real converter_fluid_turbine_end = (s->x[1] + s->x[4]) /
        p->converter_reference_speed;
    /* (3.37)-(3.39), all quadrants */
    transmission_nine_speed_fluid_torques(7, converter_fluid_pump_end, converter_fluid_turbine_end,
        &converter_fluid_knots[0][0], &converter_fluid_curves[0][0], &s->fluid_torque[0], &s->fluid_torque[1]);
    transmission_nine_speed_plant_measure(s, p, out);
    if (s->friction_status == TRANSMISSION_NINE_SPEED_REAL(-1)) {
        return transmission_nine_speed_plant_friction_unsolved;
    }
    if (s->friction_status == TRANSMISSION_NINE_SPEED_REAL(1)) {
        return transmission_nine_speed_plant_bad_capacity_converter_lockup;
    }
    if (s->friction_status == TRANSMISSION_NINE_SPEED_REAL(2)) {
        return transmission_nine_speed_plant_bad_capacity_gears_A;
    }
    if (s->friction_status == TRANSMISSION_NINE_SPEED_REAL(3)) {
        return transmission_nine_speed_plant_bad_capacity_gears_B;
    }
    if (s->friction_status == TRANSMISSION_NINE_SPEED_REAL(4)) {
        return transmission_nine_speed_plant_bad_capacity_gears_C;
    }
    if (s->friction_status == TRANSMISSION_NINE_SPEED_REAL(5)) {
        return transmission_nine_speed_plant_bad_capacity_gears_D;
    }
    if (s->friction_status == TRANSMISSION_NINE_SPEED_REAL(6)) {
        return transmission_nine_speed_plant_bad_capacity_gears_E;
    }
    if (s->friction_status == TRANSMISSION_NINE_SPEED_REAL(7)) {
        return transmission_nine_speed_plant_bad_capacity_gears_F;
    }
    return transmission_nine_speed_plant_ok;
}
