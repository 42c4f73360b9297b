/*
 * transmission_plant.c: plant of the bed transmission
 *
 * Emitted by ptgen 0.1.0 from transmission.toml (SHA-256 e06936acb40aa4a5), template block.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "transmission_plant.h"
#include "transmission_friction.h"
#include "transmission_fluid.h"

#include <float.h>
#include <string.h>

const transmission_plant_params transmission_plant_defaults = {
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
    .gears_inertia_input = 0.05,
    .gears_inertia_output = 0.04,
    .gears_clutch1_static = 1300.0,
    .gears_clutch1_stribeck_speed = 5.0,
    .gears_clutch1_viscous = 0.0,
    .gears_clutch1_capacity = 1200.0,
    .gears_clutch2_static = 1300.0,
    .gears_clutch2_stribeck_speed = 5.0,
    .gears_clutch2_viscous = 0.0,
    .gears_clutch2_capacity = 1200.0,
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
static const transmission_real converter_fluid_knots[4][8] = {
    { -1.0, 0.0, 0.2, 0.4, 0.6, 0.8, 0.9 },
    { -1.0, 0.0, 0.2, 0.4, 0.6, 0.8, 0.9 },
    { -1.0, 0.0, 0.2, 0.4, 0.6, 0.8, 0.9 },
    { -1.0, 0.0, 0.2, 0.4, 0.6, 0.8, 0.9 },
};

/* torques at the reference speed: 4 coefficients of the faster wheel's, the rest of the slower one's (N m) */
static const transmission_real converter_fluid_curves[28][12] = {
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
    transmission_real least;
    transmission_real most;
    int open;
    int not_zero;
} limits[] = {
    { "the parameter M1_inertia is outside its range", offsetof(transmission_plant_params, M1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_max is outside its range", offsetof(transmission_plant_params, M1_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_rated is outside its range", offsetof(transmission_plant_params, M1_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_inverter_dead_time is outside its range", offsetof(transmission_plant_params, M1_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M1_inverter_time_constant is outside its range", offsetof(transmission_plant_params, M1_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_inertia is outside its range", offsetof(transmission_plant_params, flange1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_stiffness is outside its range", offsetof(transmission_plant_params, flange1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_damping is outside its range", offsetof(transmission_plant_params, flange1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter shaft1_stiffness is outside its range", offsetof(transmission_plant_params, shaft1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft1_damping is outside its range", offsetof(transmission_plant_params, shaft1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter shaft1_backlash is outside its range", offsetof(transmission_plant_params, shaft1_backlash), 0.0, DBL_MAX, 1, 0 },
    { "the parameter converter_inertia_pump is outside its range", offsetof(transmission_plant_params, converter_inertia_pump), 0.0, DBL_MAX, 1, 0 },
    { "the parameter converter_inertia_turbine is outside its range", offsetof(transmission_plant_params, converter_inertia_turbine), 0.0, DBL_MAX, 1, 0 },
    { "the parameter converter_reference_speed is outside its range", offsetof(transmission_plant_params, converter_reference_speed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter converter_lockup_static is outside its range", offsetof(transmission_plant_params, converter_lockup_static), 0.0, DBL_MAX, 1, 0 },
    { "the parameter converter_lockup_stribeck_speed is outside its range", offsetof(transmission_plant_params, converter_lockup_stribeck_speed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter converter_lockup_viscous is outside its range", offsetof(transmission_plant_params, converter_lockup_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter converter_lockup_capacity is outside its range", offsetof(transmission_plant_params, converter_lockup_capacity), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_inertia_input is outside its range", offsetof(transmission_plant_params, gears_inertia_input), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_inertia_output is outside its range", offsetof(transmission_plant_params, gears_inertia_output), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_clutch1_static is outside its range", offsetof(transmission_plant_params, gears_clutch1_static), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_clutch1_stribeck_speed is outside its range", offsetof(transmission_plant_params, gears_clutch1_stribeck_speed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_clutch1_viscous is outside its range", offsetof(transmission_plant_params, gears_clutch1_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_clutch1_capacity is outside its range", offsetof(transmission_plant_params, gears_clutch1_capacity), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_clutch2_static is outside its range", offsetof(transmission_plant_params, gears_clutch2_static), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_clutch2_stribeck_speed is outside its range", offsetof(transmission_plant_params, gears_clutch2_stribeck_speed), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_clutch2_viscous is outside its range", offsetof(transmission_plant_params, gears_clutch2_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_clutch2_capacity is outside its range", offsetof(transmission_plant_params, gears_clutch2_capacity), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft2_stiffness is outside its range", offsetof(transmission_plant_params, shaft2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft2_damping is outside its range", offsetof(transmission_plant_params, shaft2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter shaft2_backlash is outside its range", offsetof(transmission_plant_params, shaft2_backlash), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_inertia is outside its range", offsetof(transmission_plant_params, flange2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_stiffness is outside its range", offsetof(transmission_plant_params, flange2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_damping is outside its range", offsetof(transmission_plant_params, flange2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_inertia is outside its range", offsetof(transmission_plant_params, M2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_max is outside its range", offsetof(transmission_plant_params, M2_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_rated is outside its range", offsetof(transmission_plant_params, M2_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_inverter_dead_time is outside its range", offsetof(transmission_plant_params, M2_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M2_inverter_time_constant is outside its range", offsetof(transmission_plant_params, M2_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter standstill_speed is outside its range", offsetof(transmission_plant_params, standstill_speed), 0.0, DBL_MAX, 0, 0 },
    { "the parameter sample_time is outside its range", offsetof(transmission_plant_params, sample_time), 0.0, DBL_MAX, 1, 0 },
};

enum { limit_count = sizeof limits / sizeof limits[0] };

const char *transmission_plant_status_text(transmission_plant_status status)
{
    switch ((int)status) {
    case transmission_plant_ok:
        return "ok";
    case transmission_plant_mass_matrix:
        return "the inertia matrix is not positive definite";
    case transmission_plant_exponential_range:
        return "the parameters are too far from those that the code was emitted for; emit it again";
    case transmission_plant_friction_matrix:
        return "a mode of the bed is too fast for the step; make a stiff shaft rigid, or the step shorter";
    case transmission_plant_friction_unsolved:
        return "the friction torques are not exact";
    case transmission_plant_bad_capacity_converter_lockup:
        return "the capacity of converter.lockup is no number from 0 up; it was taken as 0";
    case transmission_plant_bad_capacity_gears_clutch1:
        return "the capacity of gears.clutch1 is no number from 0 up; it was taken as 0";
    case transmission_plant_bad_capacity_gears_clutch2:
        return "the capacity of gears.clutch2 is no number from 0 up; it was taken as 0";
    case transmission_plant_bad_input_M1_torque_ref:
        return "the input M1_torque_ref is not finite";
    case transmission_plant_bad_input_M2_torque_ref:
        return "the input M2_torque_ref is not finite";
    case transmission_plant_bad_input_converter_lockup_actuation:
        return "the input converter_lockup_actuation is outside its range 0 to 1";
    case transmission_plant_bad_input_gears_clutch1_actuation:
        return "the input gears_clutch1_actuation is outside its range 0 to 1";
    case transmission_plant_bad_input_gears_clutch2_actuation:
        return "the input gears_clutch2_actuation is outside its range 0 to 1";
    case transmission_plant_bad_input_gears_ratio1:
        return "the input gears_ratio1 is outside its range -4.932 to 5.503";
    case transmission_plant_bad_input_gears_ratio2:
        return "the input gears_ratio2 is outside its range -4.932 to 5.503";
    default:
        break;
    }
    const int limit = (int)status - 2000;
    return limit >= 0 && limit < limit_count ? limits[limit].text : "unknown status";
}

transmission_plant_status transmission_plant_init(transmission_plant_state *s, const transmission_plant_params *p)
{
    memset(s, 0, sizeof *s);
    s->gears_ratio1_now = 5.503;
    s->gears_ratio2_now = 3.333;
    return transmission_plant_update(s, p);
}

/* What follows from what every step may change: gears_ratio1_now, gears_ratio2_now. */
static void refresh(transmission_plant_state *s, const transmission_plant_params *p)
{
    (void)p;
    /* Gamma_T = Gamma_z G' */
    s->gamma[1][0] = -s->gamma_pressed[0][0] + s->gamma_pressed[1][0] - s->gamma_pressed[2][0] *
        s->gears_ratio1_now;
    s->gamma[1][1] = -s->gamma_pressed[0][1] + s->gamma_pressed[1][1] - s->gamma_pressed[2][1] *
        s->gears_ratio1_now;
    s->gamma[1][2] = -s->gamma_pressed[0][2] + s->gamma_pressed[1][2] - s->gamma_pressed[2][2] *
        s->gears_ratio1_now;
    s->gamma[1][3] = -s->gamma_pressed[0][3] + s->gamma_pressed[1][3] - s->gamma_pressed[2][3] *
        s->gears_ratio1_now;
    s->gamma[1][4] = -s->gamma_pressed[0][4] + s->gamma_pressed[1][4] - s->gamma_pressed[2][4] *
        s->gears_ratio1_now;
    s->gamma[1][5] = -s->gamma_pressed[0][5] + s->gamma_pressed[1][5] - s->gamma_pressed[2][5] *
        s->gears_ratio1_now;
    s->gamma[1][6] = -s->gamma_pressed[0][6] + s->gamma_pressed[1][6] - s->gamma_pressed[2][6] *
        s->gears_ratio1_now;
    s->gamma[1][7] = -s->gamma_pressed[0][7] + s->gamma_pressed[1][7] - s->gamma_pressed[2][7] *
        s->gears_ratio1_now;
    s->gamma[1][8] = -s->gamma_pressed[0][8] + s->gamma_pressed[1][8] - s->gamma_pressed[2][8] *
        s->gears_ratio1_now;
    s->gamma[1][9] = -s->gamma_pressed[0][9] + s->gamma_pressed[1][9] - s->gamma_pressed[2][9] *
        s->gears_ratio1_now;
    s->gamma[1][10] = -s->gamma_pressed[0][10] + s->gamma_pressed[1][10] - s->gamma_pressed[2][10] *
        s->gears_ratio1_now;
    s->gamma[1][11] = -s->gamma_pressed[0][11] + s->gamma_pressed[1][11] - s->gamma_pressed[2][11] *
        s->gears_ratio1_now;
    s->gamma[1][12] = -s->gamma_pressed[0][12] + s->gamma_pressed[1][12] - s->gamma_pressed[2][12] *
        s->gears_ratio1_now;
    s->gamma[2][0] = -s->gamma_pressed[0][0] + s->gamma_pressed[1][0] - s->gamma_pressed[2][0] *
        s->gears_ratio2_now;
    s->gamma[2][1] = -s->gamma_pressed[0][1] + s->gamma_pressed[1][1] - s->gamma_pressed[2][1] *
        s->gears_ratio2_now;
    s->gamma[2][2] = -s->gamma_pressed[0][2] + s->gamma_pressed[1][2] - s->gamma_pressed[2][2] *
        s->gears_ratio2_now;
    s->gamma[2][3] = -s->gamma_pressed[0][3] + s->gamma_pressed[1][3] - s->gamma_pressed[2][3] *
        s->gears_ratio2_now;
    s->gamma[2][4] = -s->gamma_pressed[0][4] + s->gamma_pressed[1][4] - s->gamma_pressed[2][4] *
        s->gears_ratio2_now;
    s->gamma[2][5] = -s->gamma_pressed[0][5] + s->gamma_pressed[1][5] - s->gamma_pressed[2][5] *
        s->gears_ratio2_now;
    s->gamma[2][6] = -s->gamma_pressed[0][6] + s->gamma_pressed[1][6] - s->gamma_pressed[2][6] *
        s->gears_ratio2_now;
    s->gamma[2][7] = -s->gamma_pressed[0][7] + s->gamma_pressed[1][7] - s->gamma_pressed[2][7] *
        s->gears_ratio2_now;
    s->gamma[2][8] = -s->gamma_pressed[0][8] + s->gamma_pressed[1][8] - s->gamma_pressed[2][8] *
        s->gears_ratio2_now;
    s->gamma[2][9] = -s->gamma_pressed[0][9] + s->gamma_pressed[1][9] - s->gamma_pressed[2][9] *
        s->gears_ratio2_now;
    s->gamma[2][10] = -s->gamma_pressed[0][10] + s->gamma_pressed[1][10] - s->gamma_pressed[2][10] *
        s->gears_ratio2_now;
    s->gamma[2][11] = -s->gamma_pressed[0][11] + s->gamma_pressed[1][11] - s->gamma_pressed[2][11] *
        s->gears_ratio2_now;
    s->gamma[2][12] = -s->gamma_pressed[0][12] + s->gamma_pressed[1][12] - s->gamma_pressed[2][12] *
        s->gears_ratio2_now;
    /* K = G K_z G' */
    s->K[1][0] = -s->K_base[1][0] + s->K_base[2][0] - s->K_base[3][0] * s->gears_ratio1_now;
    s->K[2][0] = -s->K_base[1][0] + s->K_base[2][0] - s->K_base[3][0] * s->gears_ratio2_now;
    s->K[0][1] = -s->K_base[0][1] + s->K_base[0][2] - s->K_base[0][3] * s->gears_ratio1_now;
    s->K[1][1] = s->K_base[1][1] - s->K_base[2][1] + s->K_base[3][1] * s->gears_ratio1_now - s->K_base[1][2] +
        s->K_base[2][2] - s->K_base[3][2] * s->gears_ratio1_now + s->K_base[1][3] * s->gears_ratio1_now -
        s->K_base[2][3] * s->gears_ratio1_now + s->K_base[3][3] * (s->gears_ratio1_now * s->gears_ratio1_now);
    s->K[2][1] = s->K_base[1][1] - s->K_base[2][1] + s->K_base[3][1] * s->gears_ratio2_now - s->K_base[1][2] +
        s->K_base[2][2] - s->K_base[3][2] * s->gears_ratio2_now + s->K_base[1][3] * s->gears_ratio1_now -
        s->K_base[2][3] * s->gears_ratio1_now + s->K_base[3][3] * s->gears_ratio1_now * s->gears_ratio2_now;
    s->K[0][2] = -s->K_base[0][1] + s->K_base[0][2] - s->K_base[0][3] * s->gears_ratio2_now;
    s->K[1][2] = s->K_base[1][1] - s->K_base[2][1] + s->K_base[3][1] * s->gears_ratio1_now - s->K_base[1][2] +
        s->K_base[2][2] - s->K_base[3][2] * s->gears_ratio1_now + s->K_base[1][3] * s->gears_ratio2_now -
        s->K_base[2][3] * s->gears_ratio2_now + s->K_base[3][3] * s->gears_ratio1_now * s->gears_ratio2_now;
    s->K[2][2] = s->K_base[1][1] - s->K_base[2][1] + s->K_base[3][1] * s->gears_ratio2_now - s->K_base[1][2] +
        s->K_base[2][2] - s->K_base[3][2] * s->gears_ratio2_now + s->K_base[1][3] * s->gears_ratio2_now -
        s->K_base[2][3] * s->gears_ratio2_now + s->K_base[3][3] * (s->gears_ratio2_now * s->gears_ratio2_now);
    /* d'Alembert */
    s->gears_input_torque_reaction[14] = -s->gears_input_torque_pressed[0] + s->gears_input_torque_pressed[1] -
        s->gears_input_torque_pressed[2] * s->gears_ratio1_now;
    s->gears_input_torque_reaction[15] = -s->gears_input_torque_pressed[0] + s->gears_input_torque_pressed[1] -
        s->gears_input_torque_pressed[2] * s->gears_ratio2_now;
}

transmission_plant_status transmission_plant_update(transmission_plant_state *s, const transmission_plant_params *p)
{
    for (int k = 0; k < limit_count; ++k) {
        const transmission_real value = *(const transmission_real *)(const void *)((const char *)p + limits[k].offset);
        const int above = limits[k].open ? value > limits[k].least : value >= limits[k].least; /* false for NaN */
        if (!(above && value <= limits[k].most) || (limits[k].not_zero && value == 0.0)) {
            return (transmission_plant_status)(2000 + k);
        }
    }
    memset(s->transition, 0, sizeof s->transition);
    memset(s->gears_input_torque_reaction, 0, sizeof s->gears_input_torque_reaction);
    memset(s->gears_input_torque_pressed, 0, sizeof s->gears_input_torque_pressed);
    memset(s->gamma, 0, sizeof s->gamma);
    memset(s->K, 0, sizeof s->K);
    memset(s->gamma_pressed, 0, sizeof s->gamma_pressed);
    memset(s->K_base, 0, sizeof s->K_base);
    memset(s->kappa, 0, sizeof s->kappa);
    memset(s->half_gap, 0, sizeof s->half_gap);
    memset(s->contact_stiffness, 0, sizeof s->contact_stiffness);
    memset(s->contact_damping, 0, sizeof s->contact_damping);
    transmission_real mass[7][8];
    transmission_real forces[21][8];
    transmission_real A[23][16];
    transmission_real scale[24];
    transmission_real whole[23][16];
    transmission_real late[23][16];
    transmission_real early[23][16];
    transmission_real rates[21][8];
    transmission_zero(sizeof mass, mass);
    transmission_zero(sizeof forces, forces);
    transmission_zero(sizeof A, A);
    transmission_zero(sizeof scale, scale);
    transmission_zero(sizeof whole, whole);
    transmission_zero(sizeof late, late);
    transmission_zero(sizeof early, early);
    transmission_zero(sizeof rates, rates);
    
    /* M = S' I S */
    mass[0][0] = p->converter_inertia_turbine + p->gears_inertia_input;
    mass[4][0] = -p->converter_inertia_turbine - p->gears_inertia_input;
    mass[1][1] = p->M1_inertia;
    mass[2][2] = p->M2_inertia;
    mass[3][3] = p->flange1_inertia;
    mass[0][4] = -p->converter_inertia_turbine - p->gears_inertia_input;
    mass[4][4] = p->converter_inertia_pump + p->converter_inertia_turbine + p->gears_inertia_input;
    mass[5][5] = p->gears_inertia_output;
    mass[6][6] = p->flange2_inertia;
    /* M dz/dt = B' u - E'(C e + D E z) - G'(T + k_v G z) */
    forces[13][0] = -1.0;
    forces[17][0] = -1.0;
    forces[18][0] = -1.0;
    forces[1][1] = -p->flange1_damping;
    forces[3][1] = p->flange1_damping;
    forces[7][1] = -p->flange1_stiffness;
    forces[11][1] = 1.0;
    forces[2][2] = -p->flange2_damping;
    forces[6][2] = p->flange2_damping;
    forces[10][2] = -p->flange2_stiffness;
    forces[12][2] = 1.0;
    forces[1][3] = p->flange1_damping;
    forces[3][3] = -p->flange1_damping;
    forces[7][3] = p->flange1_stiffness;
    forces[14][3] = -1.0;
    forces[14][4] = 1.0;
    forces[16][4] = -1.0;
    forces[17][4] = 1.0;
    forces[19][4] = -1.0;
    forces[15][5] = -1.0;
    forces[20][5] = -1.0;
    forces[2][6] = p->flange2_damping;
    forces[6][6] = -p->flange2_damping;
    forces[10][6] = p->flange2_stiffness;
    forces[15][6] = 1.0;
    if (!transmission_cholesky_solve(7, 21, &mass[0][0], &forces[0][0], &rates[0][0])) {
        return transmission_plant_mass_matrix;
    }
    transmission_insert(7, 16, 8, 0, 0, 0, 11, &A[0][0], &rates[0][0]);
    /* de/dt = E z */
    A[1][7] = 1.0;
    A[3][7] = -1.0;
    A[3][8] = 1.0;
    A[4][8] = -1.0;
    A[5][9] = 1.0;
    A[6][9] = -1.0;
    A[2][10] = 1.0;
    A[6][10] = -1.0;
    transmission_insert(7, 16, 8, 0, 11, 11, 1, &A[0][0], &rates[0][0]);
    /* lag of the torque loop */
    A[11][11] = -1.0 / p->M1_inverter_time_constant;
    A[13][11] = 1.0 / p->M1_inverter_time_constant;
    transmission_insert(7, 16, 8, 0, 12, 12, 1, &A[0][0], &rates[0][0]);
    A[12][12] = -1.0 / p->M2_inverter_time_constant;
    A[14][12] = 1.0 / p->M2_inverter_time_constant;
    transmission_insert(7, 16, 8, 0, 15, 13, 8, &A[0][0], &rates[0][0]);
    scale[0] = 1.0;
    scale[1] = 1.0;
    scale[2] = 1.0;
    scale[3] = 1.0;
    scale[4] = 1.0;
    scale[5] = 1.0;
    scale[6] = 1.0;
    scale[7] = p->sample_time;
    scale[8] = p->sample_time;
    scale[9] = p->sample_time;
    scale[10] = p->sample_time;
    scale[11] = 1.0;
    scale[12] = 1.0;
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
    /* exact discretisation */
    if (!transmission_discretise(13, 23, 5, &A[0][0], scale, p->sample_time, &whole[0][0])) {
        return transmission_plant_exponential_range;
    }
    transmission_insert(13, 16, 16, 0, 0, 0, 13, &s->transition[0][0], &whole[0][0]);
    /* dead time = (d + f) h */
    s->M1_dead_steps = transmission_floor(p->M1_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const transmission_real M1_late_time = p->sample_time - transmission_max(0.0, -s->M1_dead_steps * p->sample_time
        + p->M1_inverter_dead_time);
    if (!transmission_discretise(13, 23, 5, &A[0][0], scale, M1_late_time, &late[0][0])) {
        return transmission_plant_exponential_range;
    }
    transmission_difference(13, 23, &whole[0][0], &late[0][0], &early[0][0]);
    transmission_insert(13, 16, 16, 0, 13, 13, 1, &s->transition[0][0], &late[0][0]);
    transmission_insert(13, 16, 16, 0, 15, 13, 1, &s->transition[0][0], &early[0][0]);
    /* dead time = (d + f) h */
    s->M2_dead_steps = transmission_floor(p->M2_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const transmission_real M2_late_time = p->sample_time - transmission_max(0.0, -s->M2_dead_steps * p->sample_time
        + p->M2_inverter_dead_time);
    if (!transmission_discretise(13, 23, 5, &A[0][0], scale, M2_late_time, &late[0][0])) {
        return transmission_plant_exponential_range;
    }
    transmission_difference(13, 23, &whole[0][0], &late[0][0], &early[0][0]);
    transmission_insert(13, 16, 16, 0, 14, 14, 1, &s->transition[0][0], &late[0][0]);
    transmission_insert(13, 16, 16, 0, 16, 14, 1, &s->transition[0][0], &early[0][0]);
    transmission_insert(13, 16, 16, 0, 0, 15, 1, &s->gamma[0][0], &whole[0][0]);
    transmission_insert(13, 16, 16, 0, 3, 16, 1, &s->gamma[0][0], &whole[0][0]);
    transmission_insert(13, 16, 16, 0, 4, 17, 1, &s->gamma[0][0], &whole[0][0]);
    transmission_insert(13, 16, 16, 0, 5, 18, 1, &s->gamma[0][0], &whole[0][0]);
    transmission_insert(13, 16, 16, 0, 6, 19, 1, &s->gamma[0][0], &whole[0][0]);
    transmission_insert(13, 16, 16, 0, 0, 20, 3, &s->gamma_pressed[0][0], &whole[0][0]);
    /* K = -G Gamma_f, also on pressed coordinates */
    s->K_base[0][0] = -whole[15][0];
    s->K_base[1][0] = -whole[20][0];
    s->K_base[2][0] = -whole[21][0];
    s->K_base[3][0] = -whole[22][0];
    s->K_base[0][1] = -whole[15][0];
    s->K_base[1][1] = -whole[20][0];
    s->K_base[2][1] = -whole[21][0];
    s->K_base[3][1] = -whole[22][0];
    s->K_base[0][2] = -whole[15][4];
    s->K_base[1][2] = -whole[20][4];
    s->K_base[2][2] = -whole[21][4];
    s->K_base[3][2] = -whole[22][4];
    s->K_base[0][3] = -whole[15][5];
    s->K_base[1][3] = -whole[20][5];
    s->K_base[2][3] = -whole[21][5];
    s->K_base[3][3] = -whole[22][5];
    s->K[0][0] = s->K_base[0][0];
    /* of a sum of velocities */
    transmission_rounding_unit(&s->velocity_rounding);
    /* friction can be solved */
    if (!transmission_require_definite(4, 1, &s->K_base[0][0])) {
        return transmission_plant_friction_matrix;
    }
    /* twist lost per torque of a contact */
    s->kappa[0][0] = -whole[16][8];
    s->kappa[1][0] = -whole[17][8];
    s->kappa[0][1] = -whole[16][9];
    s->kappa[1][1] = -whole[17][9];
    /* (3.5) */
    s->half_gap[0] = (0.5) * p->shaft1_backlash;
    s->contact_stiffness[0] = p->shaft1_stiffness;
    s->contact_damping[0] = p->shaft1_damping / p->sample_time;
    s->half_gap[1] = (0.5) * p->shaft2_backlash;
    s->contact_stiffness[1] = p->shaft2_stiffness;
    s->contact_damping[1] = p->shaft2_damping / p->sample_time;
    /* d'Alembert */
    s->gears_input_torque_reaction[0] = p->converter_inertia_turbine * rates[0][0] - p->converter_inertia_turbine *
        rates[0][4];
    s->gears_input_torque_reaction[1] = p->converter_inertia_turbine * rates[1][0] - p->converter_inertia_turbine *
        rates[1][4];
    s->gears_input_torque_reaction[2] = p->converter_inertia_turbine * rates[2][0] - p->converter_inertia_turbine *
        rates[2][4];
    s->gears_input_torque_reaction[3] = p->converter_inertia_turbine * rates[3][0] - p->converter_inertia_turbine *
        rates[3][4];
    s->gears_input_torque_reaction[4] = p->converter_inertia_turbine * rates[4][0] - p->converter_inertia_turbine *
        rates[4][4];
    s->gears_input_torque_reaction[5] = p->converter_inertia_turbine * rates[5][0] - p->converter_inertia_turbine *
        rates[5][4];
    s->gears_input_torque_reaction[6] = p->converter_inertia_turbine * rates[6][0] - p->converter_inertia_turbine *
        rates[6][4];
    s->gears_input_torque_reaction[7] = p->converter_inertia_turbine * rates[7][0] - p->converter_inertia_turbine *
        rates[7][4];
    s->gears_input_torque_reaction[8] = p->converter_inertia_turbine * rates[8][0] - p->converter_inertia_turbine *
        rates[8][4];
    s->gears_input_torque_reaction[9] = p->converter_inertia_turbine * rates[9][0] - p->converter_inertia_turbine *
        rates[9][4];
    s->gears_input_torque_reaction[10] = p->converter_inertia_turbine * rates[10][0] - p->converter_inertia_turbine
        * rates[10][4];
    s->gears_input_torque_reaction[11] = p->converter_inertia_turbine * rates[11][0] - p->converter_inertia_turbine
        * rates[11][4];
    s->gears_input_torque_reaction[12] = p->converter_inertia_turbine * rates[12][0] - p->converter_inertia_turbine
        * rates[12][4];
    s->gears_input_torque_reaction[13] = p->converter_inertia_turbine * rates[13][0] - p->converter_inertia_turbine
        * rates[13][4];
    s->gears_input_torque_reaction[16] = p->converter_inertia_turbine * rates[14][0] - p->converter_inertia_turbine
        * rates[14][4];
    s->gears_input_torque_reaction[17] = p->converter_inertia_turbine * rates[15][0] - p->converter_inertia_turbine
        * rates[15][4];
    s->gears_input_torque_reaction[18] = p->converter_inertia_turbine * rates[16][0] - p->converter_inertia_turbine
        * rates[16][4];
    s->gears_input_torque_reaction[19] = p->converter_inertia_turbine * rates[17][0] - p->converter_inertia_turbine
        * rates[17][4];
    s->gears_input_torque_pressed[0] = p->converter_inertia_turbine * rates[18][0] - p->converter_inertia_turbine *
        rates[18][4];
    s->gears_input_torque_pressed[1] = p->converter_inertia_turbine * rates[19][0] - p->converter_inertia_turbine *
        rates[19][4];
    s->gears_input_torque_pressed[2] = p->converter_inertia_turbine * rates[20][0] - p->converter_inertia_turbine *
        rates[20][4];
    refresh(s, p);
    return transmission_plant_ok;
}

void transmission_plant_measure(const transmission_plant_state *s, const transmission_plant_params *p, transmission_plant_outputs *out)
{
    out->M1_speed = s->x[1];
    out->flange1_torque = p->flange1_damping * s->x[1] - p->flange1_damping * s->x[3] + p->flange1_stiffness *
        s->x[7];
    out->flange2_torque = -p->flange2_damping * s->x[2] + p->flange2_damping * s->x[6] - p->flange2_stiffness *
        s->x[10];
    out->M2_speed = s->x[2];
    out->gears_input_torque = s->contact_torque[0] * s->gears_input_torque_reaction[16] + s->contact_torque[1] *
        s->gears_input_torque_reaction[17] + s->fluid_torque[0] * s->gears_input_torque_reaction[18] +
        s->fluid_torque[1] * (s->gears_input_torque_reaction[19] + 1.0) + s->friction_torque[0] *
        (s->gears_input_torque_reaction[13] + 1.0) + s->friction_torque[1] * s->gears_input_torque_reaction[14] +
        s->friction_torque[2] * s->gears_input_torque_reaction[15] + s->gears_input_torque_reaction[0] * s->x[0] +
        s->gears_input_torque_reaction[10] * s->x[10] + s->gears_input_torque_reaction[11] * s->x[11] +
        s->gears_input_torque_reaction[12] * s->x[12] + s->gears_input_torque_reaction[1] * s->x[1] +
        s->gears_input_torque_reaction[2] * s->x[2] + s->gears_input_torque_reaction[3] * s->x[3] +
        s->gears_input_torque_reaction[4] * s->x[4] + s->gears_input_torque_reaction[5] * s->x[5] +
        s->gears_input_torque_reaction[6] * s->x[6] + s->gears_input_torque_reaction[7] * s->x[7] +
        s->gears_input_torque_reaction[8] * s->x[8] + s->gears_input_torque_reaction[9] * s->x[9];
    out->M1_torque = s->x[11];
    out->M2_torque = s->x[12];
    out->converter_lockup_speed = s->x[0];
    out->converter_lockup_torque = s->friction_torque[0];
    out->gears_clutch1_speed = transmission_select(transmission_abs(s->gears_ratio1_now * s->x[5] + s->x[0] -
        s->x[4]) < p->standstill_speed + s->velocity_rounding * (transmission_abs(s->x[0]) +
        transmission_abs(s->x[4]) + transmission_abs(s->gears_ratio1_now * s->x[5])), 0.0, -s->gears_ratio1_now *
        s->x[5] - s->x[0] + s->x[4]);
    out->gears_clutch1_torque = s->friction_torque[1];
    out->gears_clutch2_speed = transmission_select(transmission_abs(s->gears_ratio2_now * s->x[5] + s->x[0] -
        s->x[4]) < p->standstill_speed + s->velocity_rounding * (transmission_abs(s->x[0]) +
        transmission_abs(s->x[4]) + transmission_abs(s->gears_ratio2_now * s->x[5])), 0.0, -s->gears_ratio2_now *
        s->x[5] - s->x[0] + s->x[4]);
    out->gears_clutch2_torque = s->friction_torque[2];
    out->converter_fluid_pump_torque = s->fluid_torque[0];
    out->converter_fluid_turbine_torque = s->fluid_torque[1];
}

/* Status of the first input that is not finite or outside its range. */
static int check_inputs(const transmission_plant_inputs *in)
{
    if (!transmission_is_finite(in->M1_torque_ref)) {
        return (int)transmission_plant_bad_input_M1_torque_ref;
    }
    if (!transmission_is_finite(in->M2_torque_ref)) {
        return (int)transmission_plant_bad_input_M2_torque_ref;
    }
    if (!(in->converter_lockup_actuation >= 0.0 && in->converter_lockup_actuation <= 1.0)) {
        return (int)transmission_plant_bad_input_converter_lockup_actuation;
    }
    if (!(in->gears_clutch1_actuation >= 0.0 && in->gears_clutch1_actuation <= 1.0)) {
        return (int)transmission_plant_bad_input_gears_clutch1_actuation;
    }
    if (!(in->gears_clutch2_actuation >= 0.0 && in->gears_clutch2_actuation <= 1.0)) {
        return (int)transmission_plant_bad_input_gears_clutch2_actuation;
    }
    if (!(in->gears_ratio1 >= -4.932 && in->gears_ratio1 <= 5.503)) {
        return (int)transmission_plant_bad_input_gears_ratio1;
    }
    if (!(in->gears_ratio2 >= -4.932 && in->gears_ratio2 <= 5.503)) {
        return (int)transmission_plant_bad_input_gears_ratio2;
    }
    return 0;
}

transmission_plant_status transmission_plant_step(transmission_plant_state *s, const transmission_plant_params *p,
    const transmission_plant_inputs *in, transmission_plant_outputs *out)
{
    const int bad = check_inputs(in);
    if (bad != 0) {
        transmission_plant_measure(s, p, out);
        return (transmission_plant_status)bad;
    }
    if (in->gears_ratio1 != s->gears_ratio1_now || in->gears_ratio2 != s->gears_ratio2_now) {
        s->gears_ratio1_now = in->gears_ratio1;
        s->gears_ratio2_now = in->gears_ratio2;
        refresh(s, p);
    }
    transmission_real x_free[16];
    transmission_real mean_torque[8];
    transmission_real w_start[4];
    transmission_real w_free[4];
    transmission_real w_plus[4];
    transmission_real slide[4];
    transmission_real rest[4];
    transmission_real friction_mean[4];
    transmission_real twist_start[4];
    transmission_real twist_free[4];
    transmission_real contact_mean[4];
    transmission_zero(sizeof x_free, x_free);
    transmission_zero(sizeof mean_torque, mean_torque);
    transmission_zero(sizeof w_start, w_start);
    transmission_zero(sizeof w_free, w_free);
    transmission_zero(sizeof w_plus, w_plus);
    transmission_zero(sizeof slide, slide);
    transmission_zero(sizeof rest, rest);
    transmission_zero(sizeof friction_mean, friction_mean);
    transmission_zero(sizeof twist_start, twist_start);
    transmission_zero(sizeof twist_free, twist_free);
    transmission_zero(sizeof contact_mean, contact_mean);
    
    /* torque-speed envelope, Figure 7.1 */
    const transmission_real M1_available = p->M1_speed_rated * p->M1_torque_max /
        transmission_max(p->M1_speed_rated, transmission_abs(s->x[1]));
    const transmission_real M1_limited = transmission_max(-M1_available, transmission_min(M1_available,
        in->M1_torque_ref));
    /* dead time of the torque loop */
    transmission_delay(16, s->M1_delay, M1_limited, s->M1_dead_steps, &s->x[13], &s->x[15]);
    /* torque-speed envelope, Figure 7.1 */
    const transmission_real M2_available = p->M2_speed_rated * p->M2_torque_max /
        transmission_max(p->M2_speed_rated, transmission_abs(s->x[2]));
    const transmission_real M2_limited = transmission_max(-M2_available, transmission_min(M2_available,
        in->M2_torque_ref));
    /* dead time of the torque loop */
    transmission_delay(16, s->M2_delay, M2_limited, s->M2_dead_steps, &s->x[14], &s->x[16]);
    /* x+ = Phi x + Gamma_u u */
    transmission_multiply(13, 17, &s->transition[0][0], s->x, x_free);
    /* speeds by the reference speed */
    const transmission_real converter_fluid_pump_mid = ((0.5) * s->contact_torque[0] * s->gamma[3][4] + (0.5) *
        s->contact_torque[1] * s->gamma[4][4] + (0.5) * s->fluid_torque[0] * s->gamma[5][4] + (0.5) *
        s->fluid_torque[1] * s->gamma[6][4] + (0.5) * s->friction_torque[0] * s->gamma[0][4] + (0.5) *
        s->friction_torque[1] * s->gamma[1][4] + (0.5) * s->friction_torque[2] * s->gamma[2][4] + (0.5) * s->x[4] +
        (0.5) * x_free[4]) / p->converter_reference_speed;
    const transmission_real converter_fluid_turbine_mid = (-0.5 * s->contact_torque[0] * s->gamma[3][0] + (0.5) *
        s->contact_torque[0] * s->gamma[3][4] - 0.5 * s->contact_torque[1] * s->gamma[4][0] + (0.5) *
        s->contact_torque[1] * s->gamma[4][4] - 0.5 * s->fluid_torque[0] * s->gamma[5][0] + (0.5) *
        s->fluid_torque[0] * s->gamma[5][4] - 0.5 * s->fluid_torque[1] * s->gamma[6][0] + (0.5) * s->fluid_torque[1]
        * s->gamma[6][4] - 0.5 * s->friction_torque[0] * s->gamma[0][0] + (0.5) * s->friction_torque[0] *
        s->gamma[0][4] - 0.5 * s->friction_torque[1] * s->gamma[1][0] + (0.5) * s->friction_torque[1] *
        s->gamma[1][4] - 0.5 * s->friction_torque[2] * s->gamma[2][0] + (0.5) * s->friction_torque[2] *
        s->gamma[2][4] - 0.5 * s->x[0] + (0.5) * s->x[4] - 0.5 * x_free[0] + (0.5) * x_free[4]) /
        p->converter_reference_speed;
    /* (3.37)-(3.39), all quadrants */
    transmission_fluid_torques(7, converter_fluid_pump_mid, converter_fluid_turbine_mid,
        &converter_fluid_knots[0][0], &converter_fluid_curves[0][0], &mean_torque[5], &mean_torque[6]);
    /* e = L x_e */
    twist_start[0] = s->x[8];
    twist_free[0] = s->friction_torque[0] * s->gamma[0][8] + s->friction_torque[1] * s->gamma[1][8] +
        s->friction_torque[2] * s->gamma[2][8] + s->gamma[5][8] * mean_torque[5] + s->gamma[6][8] * mean_torque[6] +
        x_free[8];
    twist_start[1] = s->x[9];
    twist_free[1] = s->friction_torque[0] * s->gamma[0][9] + s->friction_torque[1] * s->gamma[1][9] +
        s->friction_torque[2] * s->gamma[2][9] + s->gamma[5][9] * mean_torque[5] + s->gamma[6][9] * mean_torque[6] +
        x_free[9];
    /* (3.5) as a mean over the step */
    transmission_backlash_step(&s->kappa[0][0], twist_start, twist_free, s->half_gap, s->contact_stiffness,
        s->contact_damping, contact_mean);
    mean_torque[3] = contact_mean[0];
    mean_torque[4] = contact_mean[1];
    /* w = G z */
    w_start[0] = s->x[0];
    w_start[1] = transmission_select(transmission_abs(s->gears_ratio1_now * s->x[5] + s->x[0] - s->x[4]) <
        p->standstill_speed + s->velocity_rounding * (transmission_abs(s->x[0]) + transmission_abs(s->x[4]) +
        transmission_abs(s->gears_ratio1_now * s->x[5])), 0.0, -s->gears_ratio1_now * s->x[5] - s->x[0] + s->x[4]);
    w_start[2] = transmission_select(transmission_abs(s->gears_ratio2_now * s->x[5] + s->x[0] - s->x[4]) <
        p->standstill_speed + s->velocity_rounding * (transmission_abs(s->x[0]) + transmission_abs(s->x[4]) +
        transmission_abs(s->gears_ratio2_now * s->x[5])), 0.0, -s->gears_ratio2_now * s->x[5] - s->x[0] + s->x[4]);
    /* speed at mid-step */
    const transmission_real converter_lockup_mid_speed = (0.5) * transmission_abs(contact_mean[0] * s->gamma[3][0] +
        contact_mean[1] * s->gamma[4][0] + s->friction_torque[0] * s->gamma[0][0] + s->friction_torque[1] *
        s->gamma[1][0] + s->friction_torque[2] * s->gamma[2][0] + s->gamma[5][0] * mean_torque[5] + s->gamma[6][0] *
        mean_torque[6] + w_start[0] + x_free[0]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[0] = in->converter_lockup_actuation * (p->converter_lockup_capacity + converter_lockup_mid_speed *
        p->converter_lockup_viscous + (-p->converter_lockup_capacity + p->converter_lockup_static) *
        transmission_exp(-converter_lockup_mid_speed / p->converter_lockup_stribeck_speed));
    rest[0] = in->converter_lockup_actuation * p->converter_lockup_static;
    /* speed at mid-step */
    const transmission_real gears_clutch1_mid_speed = (0.5) * transmission_abs(contact_mean[0] * s->gamma[3][0] -
        contact_mean[0] * s->gamma[3][4] + contact_mean[1] * s->gamma[4][0] - contact_mean[1] * s->gamma[4][4] +
        s->friction_torque[0] * s->gamma[0][0] - s->friction_torque[0] * s->gamma[0][4] + s->friction_torque[1] *
        s->gamma[1][0] - s->friction_torque[1] * s->gamma[1][4] + s->friction_torque[2] * s->gamma[2][0] -
        s->friction_torque[2] * s->gamma[2][4] + s->gamma[5][0] * mean_torque[5] + s->gamma[6][0] * mean_torque[6] -
        s->gamma[5][4] * mean_torque[5] - s->gamma[6][4] * mean_torque[6] + s->gears_ratio1_now * (contact_mean[0] *
        s->gamma[3][5] + contact_mean[1] * s->gamma[4][5] + s->friction_torque[0] * s->gamma[0][5] +
        s->friction_torque[1] * s->gamma[1][5] + s->friction_torque[2] * s->gamma[2][5] + s->gamma[5][5] *
        mean_torque[5] + s->gamma[6][5] * mean_torque[6] + x_free[5]) - w_start[1] + x_free[0] - x_free[4]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[1] = in->gears_clutch1_actuation * (p->gears_clutch1_capacity + gears_clutch1_mid_speed *
        p->gears_clutch1_viscous + (-p->gears_clutch1_capacity + p->gears_clutch1_static) *
        transmission_exp(-gears_clutch1_mid_speed / p->gears_clutch1_stribeck_speed));
    rest[1] = in->gears_clutch1_actuation * p->gears_clutch1_static;
    /* speed at mid-step */
    const transmission_real gears_clutch2_mid_speed = (0.5) * transmission_abs(contact_mean[0] * s->gamma[3][0] -
        contact_mean[0] * s->gamma[3][4] + contact_mean[1] * s->gamma[4][0] - contact_mean[1] * s->gamma[4][4] +
        s->friction_torque[0] * s->gamma[0][0] - s->friction_torque[0] * s->gamma[0][4] + s->friction_torque[1] *
        s->gamma[1][0] - s->friction_torque[1] * s->gamma[1][4] + s->friction_torque[2] * s->gamma[2][0] -
        s->friction_torque[2] * s->gamma[2][4] + s->gamma[5][0] * mean_torque[5] + s->gamma[6][0] * mean_torque[6] -
        s->gamma[5][4] * mean_torque[5] - s->gamma[6][4] * mean_torque[6] + s->gears_ratio2_now * (contact_mean[0] *
        s->gamma[3][5] + contact_mean[1] * s->gamma[4][5] + s->friction_torque[0] * s->gamma[0][5] +
        s->friction_torque[1] * s->gamma[1][5] + s->friction_torque[2] * s->gamma[2][5] + s->gamma[5][5] *
        mean_torque[5] + s->gamma[6][5] * mean_torque[6] + x_free[5]) - w_start[2] + x_free[0] - x_free[4]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[2] = in->gears_clutch2_actuation * (p->gears_clutch2_capacity + gears_clutch2_mid_speed *
        p->gears_clutch2_viscous + (-p->gears_clutch2_capacity + p->gears_clutch2_static) *
        transmission_exp(-gears_clutch2_mid_speed / p->gears_clutch2_stribeck_speed));
    rest[2] = in->gears_clutch2_actuation * p->gears_clutch2_static;
    /* w_free = G z_free */
    w_free[0] = contact_mean[0] * s->gamma[3][0] + contact_mean[1] * s->gamma[4][0] + s->gamma[5][0] *
        mean_torque[5] + s->gamma[6][0] * mean_torque[6] + x_free[0];
    w_free[1] = -contact_mean[0] * s->gamma[3][0] + contact_mean[0] * s->gamma[3][4] - contact_mean[1] *
        s->gamma[4][0] + contact_mean[1] * s->gamma[4][4] - s->gamma[5][0] * mean_torque[5] - s->gamma[6][0] *
        mean_torque[6] + s->gamma[5][4] * mean_torque[5] + s->gamma[6][4] * mean_torque[6] - s->gears_ratio1_now *
        (contact_mean[0] * s->gamma[3][5] + contact_mean[1] * s->gamma[4][5] + s->gamma[5][5] * mean_torque[5] +
        s->gamma[6][5] * mean_torque[6] + x_free[5]) - x_free[0] + x_free[4];
    w_free[2] = -contact_mean[0] * s->gamma[3][0] + contact_mean[0] * s->gamma[3][4] - contact_mean[1] *
        s->gamma[4][0] + contact_mean[1] * s->gamma[4][4] - s->gamma[5][0] * mean_torque[5] - s->gamma[6][0] *
        mean_torque[6] + s->gamma[5][4] * mean_torque[5] + s->gamma[6][4] * mean_torque[6] - s->gears_ratio2_now *
        (contact_mean[0] * s->gamma[3][5] + contact_mean[1] * s->gamma[4][5] + s->gamma[5][5] * mean_torque[5] +
        s->gamma[6][5] * mean_torque[6] + x_free[5]) - x_free[0] + x_free[4];
    /* what sticks, slips and passes zero */
    transmission_friction_step(1, 0, &s->K[0][0], w_start, w_free, slide, rest, s->friction_torque,
        s->friction_rest, friction_mean, w_plus, &s->friction_status);
    mean_torque[0] = friction_mean[0];
    mean_torque[1] = friction_mean[1];
    mean_torque[2] = friction_mean[2];
    /* x+ = x_free + Gamma_f T */
    transmission_add_product(13, 7, s->x, x_free, &s->gamma[0][0], mean_torque);
    /* exactly zero while it sticks */
    s->x[0] = transmission_select(p->standstill_speed > transmission_abs(w_plus[0]), 0.0, w_plus[0]);
    const transmission_real shaft1_twist = s->x[8];
    /* (3.5) */
    s->contact_torque[0] = p->shaft1_stiffness * (shaft1_twist - transmission_max(-s->half_gap[0],
        transmission_min(s->half_gap[0], shaft1_twist))) + transmission_select(s->half_gap[0] <
        transmission_abs(shaft1_twist), p->shaft1_damping * (s->x[3] - s->x[4]), 0.0);
    const transmission_real shaft2_twist = s->x[9];
    s->contact_torque[1] = p->shaft2_stiffness * (shaft2_twist - transmission_max(-s->half_gap[1],
        transmission_min(s->half_gap[1], shaft2_twist))) + transmission_select(s->half_gap[1] <
        transmission_abs(shaft2_twist), p->shaft2_damping * (s->x[5] - s->x[6]), 0.0);
    /* speeds by the reference speed */
    const transmission_real converter_fluid_pump_end = s->x[4] / p->converter_reference_speed;
    const transmission_real converter_fluid_turbine_end = (-s->x[0] + s->x[4]) / p->converter_reference_speed;
    /* (3.37)-(3.39), all quadrants */
    transmission_fluid_torques(7, converter_fluid_pump_end, converter_fluid_turbine_end,
        &converter_fluid_knots[0][0], &converter_fluid_curves[0][0], &s->fluid_torque[0], &s->fluid_torque[1]);
    transmission_plant_measure(s, p, out);
    if (s->friction_status == TRANSMISSION_REAL(-1)) {
        return transmission_plant_friction_unsolved;
    }
    if (s->friction_status == TRANSMISSION_REAL(1)) {
        return transmission_plant_bad_capacity_converter_lockup;
    }
    if (s->friction_status == TRANSMISSION_REAL(2)) {
        return transmission_plant_bad_capacity_gears_clutch1;
    }
    if (s->friction_status == TRANSMISSION_REAL(3)) {
        return transmission_plant_bad_capacity_gears_clutch2;
    }
    return transmission_plant_ok;
}
