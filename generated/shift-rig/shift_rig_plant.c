/*
 * shift_rig_plant.c: plant of the bed shift_rig
 *
 * Emitted by ptgen 0.1.0 from shift-rig.toml (SHA-256 627f699c509849a3), template block.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "shift_rig_plant.h"
#include "shift_rig_friction.h"

#include <float.h>
#include <string.h>

const shift_rig_plant_params shift_rig_plant_defaults = {
    .M1_inertia = 0.4,
    .M1_torque_max = 900.0,
    .M1_speed_rated = 335.103216382911,
    .M1_inverter_dead_time = 0.0001,
    .M1_inverter_time_constant = 0.00025,
    .flange1_inertia = 0.01,
    .flange1_stiffness = 380000.0,
    .flange1_damping = 0.5,
    .shaft1_stiffness = 25000.0,
    .shaft1_damping = 2.0,
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
    .flange2_inertia = 0.03,
    .flange2_stiffness = 220000.0,
    .flange2_damping = 0.5,
    .M2_inertia = 4.5,
    .M2_torque_max = 3300.0,
    .M2_speed_rated = 104.71975511966,
    .M2_inverter_dead_time = 0.0001,
    .M2_inverter_time_constant = 0.00025,
    .standstill_speed = 1e-09,
    .sample_time = 0.0001,
};

/* Range of each parameter; `open` excludes the lower bound. The order is that of the status codes. */
static const struct {
    const char *text;
    size_t offset;
    shift_rig_real least;
    shift_rig_real most;
    int open;
    int not_zero;
} limits[] = {
    { "the parameter M1_inertia is outside its range", offsetof(shift_rig_plant_params, M1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_max is outside its range", offsetof(shift_rig_plant_params, M1_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_rated is outside its range", offsetof(shift_rig_plant_params, M1_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_inverter_dead_time is outside its range", offsetof(shift_rig_plant_params, M1_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M1_inverter_time_constant is outside its range", offsetof(shift_rig_plant_params, M1_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_inertia is outside its range", offsetof(shift_rig_plant_params, flange1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_stiffness is outside its range", offsetof(shift_rig_plant_params, flange1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_damping is outside its range", offsetof(shift_rig_plant_params, flange1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter shaft1_stiffness is outside its range", offsetof(shift_rig_plant_params, shaft1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft1_damping is outside its range", offsetof(shift_rig_plant_params, shaft1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_P1_ratio is outside its range", offsetof(shift_rig_plant_params, gears_P1_ratio), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P1_inertia_sun is outside its range", offsetof(shift_rig_plant_params, gears_P1_inertia_sun), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P1_inertia_ring is outside its range", offsetof(shift_rig_plant_params, gears_P1_inertia_ring), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P1_inertia_carrier is outside its range", offsetof(shift_rig_plant_params, gears_P1_inertia_carrier), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P1_inertia_planets is outside its range", offsetof(shift_rig_plant_params, gears_P1_inertia_planets), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P2_ratio is outside its range", offsetof(shift_rig_plant_params, gears_P2_ratio), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P2_inertia_sun is outside its range", offsetof(shift_rig_plant_params, gears_P2_inertia_sun), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P2_inertia_ring is outside its range", offsetof(shift_rig_plant_params, gears_P2_inertia_ring), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P2_inertia_carrier is outside its range", offsetof(shift_rig_plant_params, gears_P2_inertia_carrier), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P2_inertia_planets is outside its range", offsetof(shift_rig_plant_params, gears_P2_inertia_planets), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P3_ratio is outside its range", offsetof(shift_rig_plant_params, gears_P3_ratio), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P3_inertia_sun is outside its range", offsetof(shift_rig_plant_params, gears_P3_inertia_sun), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P3_inertia_ring is outside its range", offsetof(shift_rig_plant_params, gears_P3_inertia_ring), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P3_inertia_carrier is outside its range", offsetof(shift_rig_plant_params, gears_P3_inertia_carrier), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P3_inertia_planets is outside its range", offsetof(shift_rig_plant_params, gears_P3_inertia_planets), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P4_ratio is outside its range", offsetof(shift_rig_plant_params, gears_P4_ratio), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P4_inertia_sun is outside its range", offsetof(shift_rig_plant_params, gears_P4_inertia_sun), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P4_inertia_ring is outside its range", offsetof(shift_rig_plant_params, gears_P4_inertia_ring), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P4_inertia_carrier is outside its range", offsetof(shift_rig_plant_params, gears_P4_inertia_carrier), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_P4_inertia_planets is outside its range", offsetof(shift_rig_plant_params, gears_P4_inertia_planets), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_A_viscous is outside its range", offsetof(shift_rig_plant_params, gears_A_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_A_capacity is outside its range", offsetof(shift_rig_plant_params, gears_A_capacity), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_B_viscous is outside its range", offsetof(shift_rig_plant_params, gears_B_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_B_capacity is outside its range", offsetof(shift_rig_plant_params, gears_B_capacity), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_C_viscous is outside its range", offsetof(shift_rig_plant_params, gears_C_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_C_capacity is outside its range", offsetof(shift_rig_plant_params, gears_C_capacity), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_D_viscous is outside its range", offsetof(shift_rig_plant_params, gears_D_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_D_capacity is outside its range", offsetof(shift_rig_plant_params, gears_D_capacity), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_E_viscous is outside its range", offsetof(shift_rig_plant_params, gears_E_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_E_capacity is outside its range", offsetof(shift_rig_plant_params, gears_E_capacity), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_F_viscous is outside its range", offsetof(shift_rig_plant_params, gears_F_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter gears_F_capacity is outside its range", offsetof(shift_rig_plant_params, gears_F_capacity), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_input_inertia is outside its range", offsetof(shift_rig_plant_params, gears_input_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_a_inertia is outside its range", offsetof(shift_rig_plant_params, gears_a_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_b_inertia is outside its range", offsetof(shift_rig_plant_params, gears_b_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_output_inertia is outside its range", offsetof(shift_rig_plant_params, gears_output_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_carrier1_inertia is outside its range", offsetof(shift_rig_plant_params, gears_carrier1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_sun2_inertia is outside its range", offsetof(shift_rig_plant_params, gears_sun2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_ring3_inertia is outside its range", offsetof(shift_rig_plant_params, gears_ring3_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter gears_carrier4_inertia is outside its range", offsetof(shift_rig_plant_params, gears_carrier4_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft2_stiffness is outside its range", offsetof(shift_rig_plant_params, shaft2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter shaft2_damping is outside its range", offsetof(shift_rig_plant_params, shaft2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter flange2_inertia is outside its range", offsetof(shift_rig_plant_params, flange2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_stiffness is outside its range", offsetof(shift_rig_plant_params, flange2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_damping is outside its range", offsetof(shift_rig_plant_params, flange2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_inertia is outside its range", offsetof(shift_rig_plant_params, M2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_max is outside its range", offsetof(shift_rig_plant_params, M2_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_rated is outside its range", offsetof(shift_rig_plant_params, M2_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_inverter_dead_time is outside its range", offsetof(shift_rig_plant_params, M2_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M2_inverter_time_constant is outside its range", offsetof(shift_rig_plant_params, M2_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter standstill_speed is outside its range", offsetof(shift_rig_plant_params, standstill_speed), 0.0, DBL_MAX, 0, 0 },
    { "the parameter sample_time is outside its range", offsetof(shift_rig_plant_params, sample_time), 0.0, DBL_MAX, 1, 0 },
};

enum { limit_count = sizeof limits / sizeof limits[0] };

const char *shift_rig_plant_status_text(shift_rig_plant_status status)
{
    switch ((int)status) {
    case shift_rig_plant_ok:
        return "ok";
    case shift_rig_plant_mass_matrix:
        return "the inertia matrix is not positive definite";
    case shift_rig_plant_exponential_range:
        return "the parameters are too far from those that the code was emitted for; emit it again";
    case shift_rig_plant_friction_matrix:
        return "a mode of the bed is too fast for the step; make a stiff shaft rigid, or the step shorter";
    case shift_rig_plant_friction_unsolved:
        return "the friction torques are not exact";
    case shift_rig_plant_bad_capacity_gears_A:
        return "the capacity of gears.A is no number from 0 up; it was taken as 0";
    case shift_rig_plant_bad_capacity_gears_B:
        return "the capacity of gears.B is no number from 0 up; it was taken as 0";
    case shift_rig_plant_bad_capacity_gears_C:
        return "the capacity of gears.C is no number from 0 up; it was taken as 0";
    case shift_rig_plant_bad_capacity_gears_D:
        return "the capacity of gears.D is no number from 0 up; it was taken as 0";
    case shift_rig_plant_bad_capacity_gears_E:
        return "the capacity of gears.E is no number from 0 up; it was taken as 0";
    case shift_rig_plant_bad_capacity_gears_F:
        return "the capacity of gears.F is no number from 0 up; it was taken as 0";
    case shift_rig_plant_bad_input_M1_torque_ref:
        return "the input M1_torque_ref is not finite";
    case shift_rig_plant_bad_input_M2_torque_ref:
        return "the input M2_torque_ref is not finite";
    case shift_rig_plant_bad_input_gears_A_actuation:
        return "the input gears_A_actuation is outside its range 0 to 1";
    case shift_rig_plant_bad_input_gears_B_actuation:
        return "the input gears_B_actuation is outside its range 0 to 1";
    case shift_rig_plant_bad_input_gears_C_actuation:
        return "the input gears_C_actuation is outside its range 0 to 1";
    case shift_rig_plant_bad_input_gears_D_actuation:
        return "the input gears_D_actuation is outside its range 0 to 1";
    case shift_rig_plant_bad_input_gears_E_actuation:
        return "the input gears_E_actuation is outside its range 0 to 1";
    case shift_rig_plant_bad_input_gears_F_actuation:
        return "the input gears_F_actuation is outside its range 0 to 1";
    default:
        break;
    }
    const int limit = (int)status - 2000;
    return limit >= 0 && limit < limit_count ? limits[limit].text : "unknown status";
}

shift_rig_plant_status shift_rig_plant_init(shift_rig_plant_state *s, const shift_rig_plant_params *p)
{
    memset(s, 0, sizeof *s);
    return shift_rig_plant_update(s, p);
}

shift_rig_plant_status shift_rig_plant_update(shift_rig_plant_state *s, const shift_rig_plant_params *p)
{
    for (int k = 0; k < limit_count; ++k) {
        const shift_rig_real value = *(const shift_rig_real *)(const void *)((const char *)p + limits[k].offset);
        const int above = limits[k].open ? value > limits[k].least : value >= limits[k].least; /* false for NaN */
        if (!(above && value <= limits[k].most) || (limits[k].not_zero && value == 0.0)) {
            return (shift_rig_plant_status)(2000 + k);
        }
    }
    memset(s->transition, 0, sizeof s->transition);
    memset(s->G, 0, sizeof s->G);
    memset(s->gamma, 0, sizeof s->gamma);
    memset(s->K, 0, sizeof s->K);
    shift_rig_real mass[8][8];
    shift_rig_real forces[20][8];
    shift_rig_real A[22][16];
    shift_rig_real scale[24];
    shift_rig_real whole[22][16];
    shift_rig_real late[22][16];
    shift_rig_real early[22][16];
    shift_rig_real rates[20][8];
    shift_rig_zero(sizeof mass, mass);
    shift_rig_zero(sizeof forces, forces);
    shift_rig_zero(sizeof A, A);
    shift_rig_zero(sizeof scale, scale);
    shift_rig_zero(sizeof whole, whole);
    shift_rig_zero(sizeof late, late);
    shift_rig_zero(sizeof early, early);
    shift_rig_zero(sizeof rates, rates);
    
    /* friction velocities per velocity */
    s->G[0][4] = 1.0 / p->gears_P2_ratio;
    s->G[1][4] = -1.0 / p->gears_P2_ratio;
    s->G[3][4] = (-p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio);
    s->G[0][5] = (p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio - p->gears_P3_ratio - p->gears_P4_ratio
        - 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio
        + p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio);
    s->G[1][5] = (p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P2_ratio);
    s->G[2][5] = -p->gears_P3_ratio * p->gears_P4_ratio / (p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P3_ratio
        + p->gears_P4_ratio + 1.0);
    s->G[3][5] = (p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P1_ratio
        * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio + p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P3_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio *
        p->gears_P2_ratio);
    /* M = S' I S */
    mass[0][0] = p->gears_P1_inertia_carrier + p->gears_P1_inertia_ring + p->gears_P1_inertia_sun +
        p->gears_P2_inertia_carrier + 4.0 * p->gears_P2_inertia_planets / ((p->gears_P2_ratio * p->gears_P2_ratio) -
        2.0 * p->gears_P2_ratio + 1.0) + p->gears_P2_inertia_ring * ((p->gears_P2_ratio * p->gears_P2_ratio) + 2.0 *
        p->gears_P2_ratio + 1.0) / (p->gears_P2_ratio * p->gears_P2_ratio) + p->gears_P3_inertia_carrier *
        ((p->gears_P2_ratio * p->gears_P2_ratio) + 2.0 * p->gears_P2_ratio + 1.0) / ((p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P3_inertia_planets * (4.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 8.0 * p->gears_P2_ratio
        * (p->gears_P3_ratio * p->gears_P3_ratio) + 4.0 * (p->gears_P3_ratio * p->gears_P3_ratio)) /
        ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio *
        p->gears_P3_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio)
        + (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_carrier * ((p->gears_P2_ratio *
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
    mass[1][0] = -4.0 * p->gears_P2_inertia_planets / ((p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 *
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
    mass[2][0] = p->gears_P3_inertia_carrier * (p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P3_ratio) /
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
    mass[3][0] = -p->gears_P1_inertia_ring / p->gears_P1_ratio + p->gears_P1_inertia_sun - 4.0 *
        p->gears_P2_inertia_planets / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 *
        p->gears_P1_ratio * p->gears_P2_ratio + p->gears_P1_ratio) + p->gears_P3_inertia_carrier *
        (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio
        * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio)) + p->gears_P3_inertia_planets * (-4.0 * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) - 8.0 * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio)
        - 4.0 * (p->gears_P3_ratio * p->gears_P3_ratio)) / (p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 *
        p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) +
        p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_carrier *
        (-(p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio - 2.0 * (p->gears_P2_ratio *
        p->gears_P2_ratio) * p->gears_P3_ratio - (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P4_ratio - (p->gears_P2_ratio
        * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) - 4.0 *
        p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio - 4.0 * p->gears_P2_ratio * p->gears_P3_ratio -
        2.0 * p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * p->gears_P2_ratio *
        p->gears_P4_ratio - 2.0 * p->gears_P2_ratio - (p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 *
        p->gears_P3_ratio * p->gears_P4_ratio - 2.0 * p->gears_P3_ratio - (p->gears_P4_ratio * p->gears_P4_ratio) -
        2.0 * p->gears_P4_ratio - 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio
        * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio +
        p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0
        * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 4.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio *
        p->gears_P4_ratio + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio +
        p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0
        * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P4_ratio + p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_planets * (-4.0 * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) - 8.0
        * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) -
        4.0 * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio)) /
        (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio) + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0
        * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio *
        p->gears_P4_ratio) - 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio
        * p->gears_P4_ratio) + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P4_inertia_ring * (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) /
        (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0
        * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_carrier4_inertia * (-(p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio * p->gears_P4_ratio - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio
        - (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P4_ratio - (p->gears_P2_ratio * p->gears_P2_ratio) - 2.0
        * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) - 4.0 * p->gears_P2_ratio * p->gears_P3_ratio
        * p->gears_P4_ratio - 4.0 * p->gears_P2_ratio * p->gears_P3_ratio - 2.0 * p->gears_P2_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * p->gears_P2_ratio * p->gears_P4_ratio - 2.0 *
        p->gears_P2_ratio - (p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 * p->gears_P3_ratio * p->gears_P4_ratio -
        2.0 * p->gears_P3_ratio - (p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P4_ratio - 1.0) /
        (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * p->gears_P1_ratio
        * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P1_ratio
        * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P4_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_input_inertia + p->gears_output_inertia * (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 *
        p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio
        * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio
        + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) - p->gears_P2_inertia_carrier /
        p->gears_P1_ratio + p->gears_P2_inertia_ring * (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 *
        p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) -
        p->gears_a_inertia / p->gears_P1_ratio + p->gears_P3_inertia_sun * (-(p->gears_P2_ratio * p->gears_P2_ratio)
        - 2.0 * p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P4_inertia_sun * (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) /
        (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_b_inertia * (-(p->gears_P2_ratio *
        p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio));
    mass[0][1] = -4.0 * p->gears_P2_inertia_planets / ((p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 *
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
    mass[1][1] = 4.0 * p->gears_P2_inertia_planets / ((p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 *
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
    mass[2][1] = -p->gears_P3_inertia_carrier * p->gears_P3_ratio / (p->gears_P2_ratio * (p->gears_P3_ratio *
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
    mass[3][1] = 4.0 * p->gears_P2_inertia_planets / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) -
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
    mass[0][2] = p->gears_P3_inertia_carrier * (p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P3_ratio) /
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
    mass[1][2] = -p->gears_P3_inertia_carrier * p->gears_P3_ratio / (p->gears_P2_ratio * (p->gears_P3_ratio *
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
    mass[2][2] = p->gears_P3_inertia_carrier * (p->gears_P3_ratio * p->gears_P3_ratio) / ((p->gears_P3_ratio *
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
    mass[3][2] = p->gears_P3_inertia_carrier * (-p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P3_ratio) /
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
    mass[0][3] = -p->gears_P1_inertia_ring / p->gears_P1_ratio + p->gears_P1_inertia_sun - 4.0 *
        p->gears_P2_inertia_planets / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 *
        p->gears_P1_ratio * p->gears_P2_ratio + p->gears_P1_ratio) + p->gears_P3_inertia_carrier *
        (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio
        * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio)) + p->gears_P3_inertia_planets * (-4.0 * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) - 8.0 * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio)
        - 4.0 * (p->gears_P3_ratio * p->gears_P3_ratio)) / (p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 *
        p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) +
        p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_carrier *
        (-(p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio - 2.0 * (p->gears_P2_ratio *
        p->gears_P2_ratio) * p->gears_P3_ratio - (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P4_ratio - (p->gears_P2_ratio
        * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) - 4.0 *
        p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio - 4.0 * p->gears_P2_ratio * p->gears_P3_ratio -
        2.0 * p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * p->gears_P2_ratio *
        p->gears_P4_ratio - 2.0 * p->gears_P2_ratio - (p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 *
        p->gears_P3_ratio * p->gears_P4_ratio - 2.0 * p->gears_P3_ratio - (p->gears_P4_ratio * p->gears_P4_ratio) -
        2.0 * p->gears_P4_ratio - 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio
        * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio +
        p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0
        * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 4.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio *
        p->gears_P4_ratio + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio +
        p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0
        * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P4_ratio + p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_planets * (-4.0 * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) - 8.0
        * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) -
        4.0 * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio)) /
        (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio) + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0
        * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio *
        p->gears_P4_ratio) - 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio
        * p->gears_P4_ratio) + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P4_inertia_ring * (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) /
        (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0
        * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio *
        (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_carrier4_inertia * (-(p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio * p->gears_P4_ratio - 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio
        - (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P4_ratio - (p->gears_P2_ratio * p->gears_P2_ratio) - 2.0
        * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) - 4.0 * p->gears_P2_ratio * p->gears_P3_ratio
        * p->gears_P4_ratio - 4.0 * p->gears_P2_ratio * p->gears_P3_ratio - 2.0 * p->gears_P2_ratio *
        (p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * p->gears_P2_ratio * p->gears_P4_ratio - 2.0 *
        p->gears_P2_ratio - (p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 * p->gears_P3_ratio * p->gears_P4_ratio -
        2.0 * p->gears_P3_ratio - (p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * p->gears_P4_ratio - 1.0) /
        (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) *
        (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)
        * (p->gears_P3_ratio * p->gears_P3_ratio) * p->gears_P4_ratio + p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * p->gears_P1_ratio
        * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P1_ratio
        * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio
        * p->gears_P2_ratio) * p->gears_P4_ratio + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_input_inertia + p->gears_output_inertia * (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 *
        p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio
        * p->gears_P3_ratio) + 2.0 * p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio
        + p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) - p->gears_P2_inertia_carrier /
        p->gears_P1_ratio + p->gears_P2_inertia_ring * (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 *
        p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) -
        p->gears_a_inertia / p->gears_P1_ratio + p->gears_P3_inertia_sun * (-(p->gears_P2_ratio * p->gears_P2_ratio)
        - 2.0 * p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) +
        p->gears_P4_inertia_sun * (-(p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) /
        (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_b_inertia * (-(p->gears_P2_ratio *
        p->gears_P2_ratio) - 2.0 * p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * (p->gears_P2_ratio *
        p->gears_P2_ratio));
    mass[1][3] = 4.0 * p->gears_P2_inertia_planets / (p->gears_P1_ratio * (p->gears_P2_ratio * p->gears_P2_ratio) -
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
    mass[2][3] = p->gears_P3_inertia_carrier * (-p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P3_ratio) /
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
    mass[3][3] = 4.0 * p->gears_P1_inertia_planets / ((p->gears_P1_ratio * p->gears_P1_ratio) - 2.0 *
        p->gears_P1_ratio + 1.0) + p->gears_P1_inertia_ring / (p->gears_P1_ratio * p->gears_P1_ratio) +
        p->gears_P1_inertia_sun + 4.0 * p->gears_P2_inertia_planets / ((p->gears_P1_ratio * p->gears_P1_ratio) *
        (p->gears_P2_ratio * p->gears_P2_ratio) - 2.0 * (p->gears_P1_ratio * p->gears_P1_ratio) * p->gears_P2_ratio
        + (p->gears_P1_ratio * p->gears_P1_ratio)) + p->gears_P3_inertia_carrier * ((p->gears_P2_ratio *
        p->gears_P2_ratio) + 2.0 * p->gears_P2_ratio + 1.0) / ((p->gears_P1_ratio * p->gears_P1_ratio) *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P1_ratio
        * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P1_ratio *
        p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P3_inertia_planets * (4.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 8.0 * p->gears_P2_ratio
        * (p->gears_P3_ratio * p->gears_P3_ratio) + 4.0 * (p->gears_P3_ratio * p->gears_P3_ratio)) /
        ((p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio * p->gears_P3_ratio * p->gears_P3_ratio) - 2.0 * (p->gears_P1_ratio * p->gears_P1_ratio) *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + (p->gears_P1_ratio *
        p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_carrier *
        ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * (p->gears_P2_ratio *
        p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P4_ratio + (p->gears_P2_ratio
        * p->gears_P2_ratio) + 2.0 * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) + 4.0 *
        p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + 4.0 * p->gears_P2_ratio * p->gears_P3_ratio +
        2.0 * p->gears_P2_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 4.0 * p->gears_P2_ratio *
        p->gears_P4_ratio + 2.0 * p->gears_P2_ratio + (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 *
        p->gears_P3_ratio * p->gears_P4_ratio + 2.0 * p->gears_P3_ratio + (p->gears_P4_ratio * p->gears_P4_ratio) +
        2.0 * p->gears_P4_ratio + 1.0) / ((p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0
        * (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) * p->gears_P4_ratio + (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P1_ratio * p->gears_P1_ratio)
        * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) +
        4.0 * (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio
        * p->gears_P4_ratio + 2.0 * (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio *
        p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0 * (p->gears_P1_ratio * p->gears_P1_ratio)
        * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P4_ratio + (p->gears_P1_ratio * p->gears_P1_ratio) *
        (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_planets * (4.0 * (p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + 8.0
        * p->gears_P2_ratio * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) +
        4.0 * (p->gears_P3_ratio * p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio)) /
        ((p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 *
        (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + (p->gears_P1_ratio * p->gears_P1_ratio) *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P1_ratio
        * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio *
        p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 4.0 * (p->gears_P1_ratio * p->gears_P1_ratio) *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio * (p->gears_P4_ratio * p->gears_P4_ratio) + 2.0
        * (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio +
        (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio *
        p->gears_P4_ratio * p->gears_P4_ratio * p->gears_P4_ratio) - 2.0 * (p->gears_P1_ratio * p->gears_P1_ratio) *
        (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P4_ratio * p->gears_P4_ratio) + (p->gears_P1_ratio *
        p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio)) + p->gears_P4_inertia_ring *
        ((p->gears_P2_ratio * p->gears_P2_ratio) + 2.0 * p->gears_P2_ratio + 1.0) / ((p->gears_P1_ratio *
        p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0
        * (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio +
        (p->gears_P1_ratio * p->gears_P1_ratio) * (p->gears_P2_ratio * p->gears_P2_ratio)) +
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
    mass[4][4] = p->M1_inertia;
    mass[5][5] = p->M2_inertia;
    mass[6][6] = p->flange1_inertia;
    mass[7][7] = p->flange2_inertia;
    /* M dz/dt = B' u - E'(C e + D E z) - G'(T + k_v G z) */
    forces[0][0] = -p->shaft1_damping - ((p->gears_P2_ratio * p->gears_P2_ratio) * p->shaft2_damping + 2.0 *
        p->gears_P2_ratio * p->shaft2_damping + p->shaft2_damping) / ((p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio
        + (p->gears_P2_ratio * p->gears_P2_ratio));
    forces[1][0] = ((p->gears_P2_ratio * p->gears_P2_ratio) * p->shaft2_damping + 2.0 * p->gears_P2_ratio *
        p->shaft2_damping + p->shaft2_damping) / ((p->gears_P2_ratio + 1.0) * ((p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[2][0] = -p->gears_P2_ratio * p->gears_P3_ratio * ((p->gears_P2_ratio * p->gears_P2_ratio) *
        p->shaft2_damping + 2.0 * p->gears_P2_ratio * p->shaft2_damping + p->shaft2_damping) / ((p->gears_P2_ratio +
        1.0) * ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[3][0] = -p->shaft1_damping + ((p->gears_P2_ratio * p->gears_P2_ratio) * p->shaft2_damping + 2.0 *
        p->gears_P2_ratio * p->shaft2_damping + p->shaft2_damping) / (p->gears_P1_ratio * ((p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[6][0] = p->shaft1_damping;
    forces[7][0] = -(-p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P2_ratio) * ((p->gears_P2_ratio *
        p->gears_P2_ratio) * p->shaft2_damping + 2.0 * p->gears_P2_ratio * p->shaft2_damping + p->shaft2_damping) /
        ((p->gears_P2_ratio + 1.0) * ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio
        * p->gears_P2_ratio)));
    forces[9][0] = p->shaft1_stiffness;
    forces[10][0] = -((p->gears_P2_ratio * p->gears_P2_ratio) * p->shaft2_stiffness + 2.0 * p->gears_P2_ratio *
        p->shaft2_stiffness + p->shaft2_stiffness) / ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio
        * p->gears_P2_ratio));
    forces[14][0] = -1.0;
    forces[18][0] = -1.0 / p->gears_P2_ratio;
    forces[19][0] = -(p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio - p->gears_P3_ratio -
        p->gears_P4_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P2_ratio *
        p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio);
    forces[0][1] = ((p->gears_P2_ratio * p->gears_P2_ratio) * p->shaft2_damping + 2.0 * p->gears_P2_ratio *
        p->shaft2_damping + p->shaft2_damping) / ((p->gears_P2_ratio + 1.0) * ((p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[1][1] = -((p->gears_P2_ratio * p->gears_P2_ratio) * p->shaft2_damping + 2.0 * p->gears_P2_ratio *
        p->shaft2_damping + p->shaft2_damping) / (((p->gears_P2_ratio + 1.0) * (p->gears_P2_ratio + 1.0)) *
        ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[2][1] = p->gears_P2_ratio * p->gears_P3_ratio * ((p->gears_P2_ratio * p->gears_P2_ratio) *
        p->shaft2_damping + 2.0 * p->gears_P2_ratio * p->shaft2_damping + p->shaft2_damping) / (((p->gears_P2_ratio
        + 1.0) * (p->gears_P2_ratio + 1.0)) * ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio
        * p->gears_P2_ratio)));
    forces[3][1] = -((p->gears_P2_ratio * p->gears_P2_ratio) * p->shaft2_damping + 2.0 * p->gears_P2_ratio *
        p->shaft2_damping + p->shaft2_damping) / (p->gears_P1_ratio * (p->gears_P2_ratio + 1.0) *
        ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[7][1] = (-p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P2_ratio) * ((p->gears_P2_ratio *
        p->gears_P2_ratio) * p->shaft2_damping + 2.0 * p->gears_P2_ratio * p->shaft2_damping + p->shaft2_damping) /
        (((p->gears_P2_ratio + 1.0) * (p->gears_P2_ratio + 1.0)) * ((p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio
        + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[10][1] = ((p->gears_P2_ratio * p->gears_P2_ratio) * p->shaft2_stiffness + 2.0 * p->gears_P2_ratio *
        p->shaft2_stiffness + p->shaft2_stiffness) / ((p->gears_P2_ratio + 1.0) * ((p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[15][1] = -1.0;
    forces[18][1] = 1.0 / p->gears_P2_ratio;
    forces[19][1] = -(p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P2_ratio);
    forces[0][2] = -p->gears_P2_ratio * p->gears_P3_ratio * ((p->gears_P2_ratio * p->gears_P2_ratio) *
        p->shaft2_damping + 2.0 * p->gears_P2_ratio * p->shaft2_damping + p->shaft2_damping) / ((p->gears_P2_ratio +
        1.0) * ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[1][2] = p->gears_P2_ratio * p->gears_P3_ratio * ((p->gears_P2_ratio * p->gears_P2_ratio) *
        p->shaft2_damping + 2.0 * p->gears_P2_ratio * p->shaft2_damping + p->shaft2_damping) / (((p->gears_P2_ratio
        + 1.0) * (p->gears_P2_ratio + 1.0)) * ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio
        * p->gears_P2_ratio)));
    forces[2][2] = -(p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) *
        ((p->gears_P2_ratio * p->gears_P2_ratio) * p->shaft2_damping + 2.0 * p->gears_P2_ratio * p->shaft2_damping +
        p->shaft2_damping) / (((p->gears_P2_ratio + 1.0) * (p->gears_P2_ratio + 1.0)) * ((p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[3][2] = p->gears_P2_ratio * p->gears_P3_ratio * ((p->gears_P2_ratio * p->gears_P2_ratio) *
        p->shaft2_damping + 2.0 * p->gears_P2_ratio * p->shaft2_damping + p->shaft2_damping) / (p->gears_P1_ratio *
        (p->gears_P2_ratio + 1.0) * ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio
        * p->gears_P2_ratio)));
    forces[7][2] = -p->gears_P2_ratio * p->gears_P3_ratio * (-p->gears_P2_ratio * p->gears_P3_ratio -
        p->gears_P2_ratio) * ((p->gears_P2_ratio * p->gears_P2_ratio) * p->shaft2_damping + 2.0 * p->gears_P2_ratio
        * p->shaft2_damping + p->shaft2_damping) / (((p->gears_P2_ratio + 1.0) * (p->gears_P2_ratio + 1.0)) *
        ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[10][2] = -p->gears_P2_ratio * p->gears_P3_ratio * ((p->gears_P2_ratio * p->gears_P2_ratio) *
        p->shaft2_stiffness + 2.0 * p->gears_P2_ratio * p->shaft2_stiffness + p->shaft2_stiffness) /
        ((p->gears_P2_ratio + 1.0) * ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio
        * p->gears_P2_ratio)));
    forces[16][2] = -1.0;
    forces[19][2] = p->gears_P3_ratio * p->gears_P4_ratio / (p->gears_P3_ratio * p->gears_P4_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0);
    forces[0][3] = -p->shaft1_damping + ((p->gears_P2_ratio * p->gears_P2_ratio) * p->shaft2_damping + 2.0 *
        p->gears_P2_ratio * p->shaft2_damping + p->shaft2_damping) / (p->gears_P1_ratio * ((p->gears_P2_ratio *
        p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio)
        * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[1][3] = -((p->gears_P2_ratio * p->gears_P2_ratio) * p->shaft2_damping + 2.0 * p->gears_P2_ratio *
        p->shaft2_damping + p->shaft2_damping) / (p->gears_P1_ratio * (p->gears_P2_ratio + 1.0) *
        ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[2][3] = p->gears_P2_ratio * p->gears_P3_ratio * ((p->gears_P2_ratio * p->gears_P2_ratio) *
        p->shaft2_damping + 2.0 * p->gears_P2_ratio * p->shaft2_damping + p->shaft2_damping) / (p->gears_P1_ratio *
        (p->gears_P2_ratio + 1.0) * ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio
        * p->gears_P2_ratio)));
    forces[3][3] = -p->shaft1_damping - ((p->gears_P2_ratio * p->gears_P2_ratio) * p->shaft2_damping + 2.0 *
        p->gears_P2_ratio * p->shaft2_damping + p->shaft2_damping) / ((p->gears_P1_ratio * p->gears_P1_ratio) *
        ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[6][3] = p->shaft1_damping;
    forces[7][3] = (-p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P2_ratio) * ((p->gears_P2_ratio *
        p->gears_P2_ratio) * p->shaft2_damping + 2.0 * p->gears_P2_ratio * p->shaft2_damping + p->shaft2_damping) /
        (p->gears_P1_ratio * (p->gears_P2_ratio + 1.0) * ((p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio
        + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[9][3] = p->shaft1_stiffness;
    forces[10][3] = ((p->gears_P2_ratio * p->gears_P2_ratio) * p->shaft2_stiffness + 2.0 * p->gears_P2_ratio *
        p->shaft2_stiffness + p->shaft2_stiffness) / (p->gears_P1_ratio * ((p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio
        + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[17][3] = -1.0;
    forces[18][3] = -(-p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio);
    forces[19][3] = -(p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio + p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio + p->gears_P3_ratio + p->gears_P4_ratio + 1.0) /
        (p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio);
    forces[4][4] = -p->flange1_damping;
    forces[6][4] = p->flange1_damping;
    forces[8][4] = -p->flange1_stiffness;
    forces[12][4] = 1.0;
    forces[5][5] = -p->flange2_damping;
    forces[7][5] = p->flange2_damping;
    forces[11][5] = -p->flange2_stiffness;
    forces[13][5] = 1.0;
    forces[0][6] = p->shaft1_damping;
    forces[3][6] = p->shaft1_damping;
    forces[4][6] = p->flange1_damping;
    forces[6][6] = -p->flange1_damping - p->shaft1_damping;
    forces[8][6] = p->flange1_stiffness;
    forces[9][6] = -p->shaft1_stiffness;
    forces[0][7] = -(-p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P2_ratio) * ((p->gears_P2_ratio *
        p->gears_P2_ratio) * p->shaft2_damping + 2.0 * p->gears_P2_ratio * p->shaft2_damping + p->shaft2_damping) /
        ((p->gears_P2_ratio + 1.0) * ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio
        * p->gears_P2_ratio)));
    forces[1][7] = (-p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P2_ratio) * ((p->gears_P2_ratio *
        p->gears_P2_ratio) * p->shaft2_damping + 2.0 * p->gears_P2_ratio * p->shaft2_damping + p->shaft2_damping) /
        (((p->gears_P2_ratio + 1.0) * (p->gears_P2_ratio + 1.0)) * ((p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio
        + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[2][7] = -p->gears_P2_ratio * p->gears_P3_ratio * (-p->gears_P2_ratio * p->gears_P3_ratio -
        p->gears_P2_ratio) * ((p->gears_P2_ratio * p->gears_P2_ratio) * p->shaft2_damping + 2.0 * p->gears_P2_ratio
        * p->shaft2_damping + p->shaft2_damping) / (((p->gears_P2_ratio + 1.0) * (p->gears_P2_ratio + 1.0)) *
        ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 *
        (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[3][7] = (-p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P2_ratio) * ((p->gears_P2_ratio *
        p->gears_P2_ratio) * p->shaft2_damping + 2.0 * p->gears_P2_ratio * p->shaft2_damping + p->shaft2_damping) /
        (p->gears_P1_ratio * (p->gears_P2_ratio + 1.0) * ((p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio
        + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[5][7] = p->flange2_damping;
    forces[7][7] = -p->flange2_damping - ((-p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P2_ratio) *
        (-p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P2_ratio)) * ((p->gears_P2_ratio * p->gears_P2_ratio) *
        p->shaft2_damping + 2.0 * p->gears_P2_ratio * p->shaft2_damping + p->shaft2_damping) / (((p->gears_P2_ratio
        + 1.0) * (p->gears_P2_ratio + 1.0)) * ((p->gears_P2_ratio * p->gears_P2_ratio) * (p->gears_P3_ratio *
        p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio + (p->gears_P2_ratio
        * p->gears_P2_ratio)));
    forces[10][7] = -(-p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P2_ratio) * ((p->gears_P2_ratio *
        p->gears_P2_ratio) * p->shaft2_stiffness + 2.0 * p->gears_P2_ratio * p->shaft2_stiffness +
        p->shaft2_stiffness) / ((p->gears_P2_ratio + 1.0) * ((p->gears_P2_ratio * p->gears_P2_ratio) *
        (p->gears_P3_ratio * p->gears_P3_ratio) + 2.0 * (p->gears_P2_ratio * p->gears_P2_ratio) * p->gears_P3_ratio
        + (p->gears_P2_ratio * p->gears_P2_ratio)));
    forces[11][7] = p->flange2_stiffness;
    if (!shift_rig_cholesky_solve(8, 20, &mass[0][0], &forces[0][0], &rates[0][0])) {
        return shift_rig_plant_mass_matrix;
    }
    shift_rig_insert(8, 16, 8, 0, 0, 0, 12, &A[0][0], &rates[0][0]);
    /* de/dt = E z */
    A[4][8] = 1.0;
    A[6][8] = -1.0;
    A[0][9] = -1.0;
    A[3][9] = -1.0;
    A[6][9] = 1.0;
    A[0][10] = 1.0;
    A[1][10] = -1.0 / (p->gears_P2_ratio + 1.0);
    A[2][10] = p->gears_P2_ratio * p->gears_P3_ratio / (p->gears_P2_ratio + 1.0);
    A[3][10] = -1.0 / p->gears_P1_ratio;
    A[7][10] = (-p->gears_P2_ratio * p->gears_P3_ratio - p->gears_P2_ratio) / (p->gears_P2_ratio + 1.0);
    A[5][11] = 1.0;
    A[7][11] = -1.0;
    shift_rig_insert(8, 16, 8, 0, 12, 12, 1, &A[0][0], &rates[0][0]);
    /* lag of the torque loop */
    A[12][12] = -1.0 / p->M1_inverter_time_constant;
    A[14][12] = 1.0 / p->M1_inverter_time_constant;
    shift_rig_insert(8, 16, 8, 0, 13, 13, 1, &A[0][0], &rates[0][0]);
    A[13][13] = -1.0 / p->M2_inverter_time_constant;
    A[15][13] = 1.0 / p->M2_inverter_time_constant;
    shift_rig_insert(8, 16, 8, 0, 16, 14, 6, &A[0][0], &rates[0][0]);
    scale[0] = 1.0;
    scale[1] = 1.0;
    scale[2] = 1.0;
    scale[3] = 1.0;
    scale[4] = 1.0;
    scale[5] = 1.0;
    scale[6] = 1.0;
    scale[7] = 1.0;
    scale[8] = p->sample_time;
    scale[9] = p->sample_time;
    scale[10] = p->sample_time;
    scale[11] = p->sample_time;
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
    /* exact discretisation */
    if (!shift_rig_discretise(14, 22, 5, &A[0][0], scale, p->sample_time, &whole[0][0])) {
        return shift_rig_plant_exponential_range;
    }
    shift_rig_insert(14, 16, 16, 0, 0, 0, 14, &s->transition[0][0], &whole[0][0]);
    /* dead time = (d + f) h */
    s->M1_dead_steps = shift_rig_floor(p->M1_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const shift_rig_real M1_late_time = p->sample_time - shift_rig_max(0.0, -s->M1_dead_steps * p->sample_time +
        p->M1_inverter_dead_time);
    if (!shift_rig_discretise(14, 22, 5, &A[0][0], scale, M1_late_time, &late[0][0])) {
        return shift_rig_plant_exponential_range;
    }
    shift_rig_difference(14, 22, &whole[0][0], &late[0][0], &early[0][0]);
    shift_rig_insert(14, 16, 16, 0, 14, 14, 1, &s->transition[0][0], &late[0][0]);
    shift_rig_insert(14, 16, 16, 0, 16, 14, 1, &s->transition[0][0], &early[0][0]);
    /* dead time = (d + f) h */
    s->M2_dead_steps = shift_rig_floor(p->M2_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const shift_rig_real M2_late_time = p->sample_time - shift_rig_max(0.0, -s->M2_dead_steps * p->sample_time +
        p->M2_inverter_dead_time);
    if (!shift_rig_discretise(14, 22, 5, &A[0][0], scale, M2_late_time, &late[0][0])) {
        return shift_rig_plant_exponential_range;
    }
    shift_rig_difference(14, 22, &whole[0][0], &late[0][0], &early[0][0]);
    shift_rig_insert(14, 16, 16, 0, 15, 15, 1, &s->transition[0][0], &late[0][0]);
    shift_rig_insert(14, 16, 16, 0, 17, 15, 1, &s->transition[0][0], &early[0][0]);
    shift_rig_insert(14, 16, 16, 0, 0, 16, 6, &s->gamma[0][0], &whole[0][0]);
    /* K = -G Gamma_f */
    s->K[0][0] = -whole[16][0];
    s->K[1][0] = -whole[17][0];
    s->K[2][0] = -whole[18][0];
    s->K[3][0] = -whole[19][0];
    s->K[4][0] = -whole[20][0];
    s->K[5][0] = -whole[21][0];
    s->K[0][1] = -whole[16][1];
    s->K[1][1] = -whole[17][1];
    s->K[2][1] = -whole[18][1];
    s->K[3][1] = -whole[19][1];
    s->K[4][1] = -whole[20][1];
    s->K[5][1] = -whole[21][1];
    s->K[0][2] = -whole[16][2];
    s->K[1][2] = -whole[17][2];
    s->K[2][2] = -whole[18][2];
    s->K[3][2] = -whole[19][2];
    s->K[4][2] = -whole[20][2];
    s->K[5][2] = -whole[21][2];
    s->K[0][3] = -whole[16][3];
    s->K[1][3] = -whole[17][3];
    s->K[2][3] = -whole[18][3];
    s->K[3][3] = -whole[19][3];
    s->K[4][3] = -whole[20][3];
    s->K[5][3] = -whole[21][3];
    s->K[0][4] = -whole[16][0] / p->gears_P2_ratio + whole[16][1] / p->gears_P2_ratio - whole[16][3] *
        (-p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[1][4] = -whole[17][0] / p->gears_P2_ratio + whole[17][1] / p->gears_P2_ratio - whole[17][3] *
        (-p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[2][4] = -whole[18][0] / p->gears_P2_ratio + whole[18][1] / p->gears_P2_ratio - whole[18][3] *
        (-p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[3][4] = -whole[19][0] / p->gears_P2_ratio + whole[19][1] / p->gears_P2_ratio - whole[19][3] *
        (-p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[4][4] = -whole[20][0] / p->gears_P2_ratio + whole[20][1] / p->gears_P2_ratio - whole[20][3] *
        (-p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[5][4] = -whole[21][0] / p->gears_P2_ratio + whole[21][1] / p->gears_P2_ratio - whole[21][3] *
        (-p->gears_P2_ratio - 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[0][5] = p->gears_P3_ratio * p->gears_P4_ratio * whole[16][2] / (p->gears_P3_ratio * p->gears_P4_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) - whole[16][0] * (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio - p->gears_P3_ratio - p->gears_P4_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P2_ratio) - whole[16][1] * (p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio) - whole[16][3] * (p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio +
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[1][5] = p->gears_P3_ratio * p->gears_P4_ratio * whole[17][2] / (p->gears_P3_ratio * p->gears_P4_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) - whole[17][0] * (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio - p->gears_P3_ratio - p->gears_P4_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P2_ratio) - whole[17][1] * (p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio) - whole[17][3] * (p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio +
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[2][5] = p->gears_P3_ratio * p->gears_P4_ratio * whole[18][2] / (p->gears_P3_ratio * p->gears_P4_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) - whole[18][0] * (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio - p->gears_P3_ratio - p->gears_P4_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P2_ratio) - whole[18][1] * (p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio) - whole[18][3] * (p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio +
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[3][5] = p->gears_P3_ratio * p->gears_P4_ratio * whole[19][2] / (p->gears_P3_ratio * p->gears_P4_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) - whole[19][0] * (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio - p->gears_P3_ratio - p->gears_P4_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P2_ratio) - whole[19][1] * (p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio) - whole[19][3] * (p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio +
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[4][5] = p->gears_P3_ratio * p->gears_P4_ratio * whole[20][2] / (p->gears_P3_ratio * p->gears_P4_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) - whole[20][0] * (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio - p->gears_P3_ratio - p->gears_P4_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P2_ratio) - whole[20][1] * (p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio) - whole[20][3] * (p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio +
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio);
    s->K[5][5] = p->gears_P3_ratio * p->gears_P4_ratio * whole[21][2] / (p->gears_P3_ratio * p->gears_P4_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) - whole[21][0] * (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio - p->gears_P3_ratio - p->gears_P4_ratio - 1.0) / (p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio +
        p->gears_P2_ratio) - whole[21][1] * (p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio *
        p->gears_P4_ratio + p->gears_P2_ratio) - whole[21][3] * (p->gears_P1_ratio * p->gears_P2_ratio *
        p->gears_P3_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio +
        p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio +
        p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P2_ratio +
        p->gears_P3_ratio + p->gears_P4_ratio + 1.0) / (p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio *
        p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio * p->gears_P3_ratio + p->gears_P1_ratio *
        p->gears_P2_ratio * p->gears_P4_ratio + p->gears_P1_ratio * p->gears_P2_ratio);
    /* of a sum of velocities */
    shift_rig_rounding_unit(&s->velocity_rounding);
    /* friction can be solved */
    if (!shift_rig_require_definite(6, 1, &s->K[0][0])) {
        return shift_rig_plant_friction_matrix;
    }
    return shift_rig_plant_ok;
}

void shift_rig_plant_measure(const shift_rig_plant_state *s, const shift_rig_plant_params *p, shift_rig_plant_outputs *out)
{
    out->M1_speed = s->x[4];
    out->flange1_torque = p->flange1_damping * s->x[4] - p->flange1_damping * s->x[6] + p->flange1_stiffness *
        s->x[8];
    out->flange2_torque = -p->flange2_damping * s->x[5] + p->flange2_damping * s->x[7] - p->flange2_stiffness *
        s->x[11];
    out->M2_speed = s->x[5];
    out->M1_torque = s->x[12];
    out->M2_torque = s->x[13];
    out->gears_A_speed = s->x[0];
    out->gears_A_torque = s->friction_torque[0];
    out->gears_B_speed = s->x[1];
    out->gears_B_torque = s->friction_torque[1];
    out->gears_C_speed = s->x[2];
    out->gears_C_torque = s->friction_torque[2];
    out->gears_D_speed = s->x[3];
    out->gears_D_torque = s->friction_torque[3];
    out->gears_E_speed = shift_rig_select(shift_rig_abs(s->G[0][4] * s->x[0] + s->G[1][4] * s->x[1] + s->G[3][4] *
        s->x[3]) < p->standstill_speed + s->velocity_rounding * (shift_rig_abs(s->G[0][4] * s->x[0]) +
        shift_rig_abs(s->G[1][4] * s->x[1]) + shift_rig_abs(s->G[3][4] * s->x[3])), 0.0, s->G[0][4] * s->x[0] +
        s->G[1][4] * s->x[1] + s->G[3][4] * s->x[3]);
    out->gears_E_torque = s->friction_torque[4];
    out->gears_F_speed = shift_rig_select(shift_rig_abs(s->G[0][5] * s->x[0] + s->G[1][5] * s->x[1] + s->G[2][5] *
        s->x[2] + s->G[3][5] * s->x[3]) < p->standstill_speed + s->velocity_rounding * (shift_rig_abs(s->G[0][5] *
        s->x[0]) + shift_rig_abs(s->G[1][5] * s->x[1]) + shift_rig_abs(s->G[2][5] * s->x[2]) +
        shift_rig_abs(s->G[3][5] * s->x[3])), 0.0, s->G[0][5] * s->x[0] + s->G[1][5] * s->x[1] + s->G[2][5] *
        s->x[2] + s->G[3][5] * s->x[3]);
    out->gears_F_torque = s->friction_torque[5];
}

/* Status of the first input that is not finite or outside its range. */
static int check_inputs(const shift_rig_plant_inputs *in)
{
    if (!shift_rig_is_finite(in->M1_torque_ref)) {
        return (int)shift_rig_plant_bad_input_M1_torque_ref;
    }
    if (!shift_rig_is_finite(in->M2_torque_ref)) {
        return (int)shift_rig_plant_bad_input_M2_torque_ref;
    }
    if (!(in->gears_A_actuation >= 0.0 && in->gears_A_actuation <= 1.0)) {
        return (int)shift_rig_plant_bad_input_gears_A_actuation;
    }
    if (!(in->gears_B_actuation >= 0.0 && in->gears_B_actuation <= 1.0)) {
        return (int)shift_rig_plant_bad_input_gears_B_actuation;
    }
    if (!(in->gears_C_actuation >= 0.0 && in->gears_C_actuation <= 1.0)) {
        return (int)shift_rig_plant_bad_input_gears_C_actuation;
    }
    if (!(in->gears_D_actuation >= 0.0 && in->gears_D_actuation <= 1.0)) {
        return (int)shift_rig_plant_bad_input_gears_D_actuation;
    }
    if (!(in->gears_E_actuation >= 0.0 && in->gears_E_actuation <= 1.0)) {
        return (int)shift_rig_plant_bad_input_gears_E_actuation;
    }
    if (!(in->gears_F_actuation >= 0.0 && in->gears_F_actuation <= 1.0)) {
        return (int)shift_rig_plant_bad_input_gears_F_actuation;
    }
    return 0;
}

shift_rig_plant_status shift_rig_plant_step(shift_rig_plant_state *s, const shift_rig_plant_params *p,
    const shift_rig_plant_inputs *in, shift_rig_plant_outputs *out)
{
    const int bad = check_inputs(in);
    if (bad != 0) {
        shift_rig_plant_measure(s, p, out);
        return (shift_rig_plant_status)bad;
    }
    shift_rig_real x_free[16];
    shift_rig_real mean_torque[8];
    shift_rig_real w_start[8];
    shift_rig_real w_free[8];
    shift_rig_real w_plus[8];
    shift_rig_real slide[8];
    shift_rig_real rest[8];
    shift_rig_real friction_mean[8];
    shift_rig_zero(sizeof x_free, x_free);
    shift_rig_zero(sizeof mean_torque, mean_torque);
    shift_rig_zero(sizeof w_start, w_start);
    shift_rig_zero(sizeof w_free, w_free);
    shift_rig_zero(sizeof w_plus, w_plus);
    shift_rig_zero(sizeof slide, slide);
    shift_rig_zero(sizeof rest, rest);
    shift_rig_zero(sizeof friction_mean, friction_mean);
    
    /* torque-speed envelope, Figure 7.1 */
    const shift_rig_real M1_available = p->M1_speed_rated * p->M1_torque_max / shift_rig_max(p->M1_speed_rated,
        shift_rig_abs(s->x[4]));
    const shift_rig_real M1_limited = shift_rig_max(-M1_available, shift_rig_min(M1_available, in->M1_torque_ref));
    /* dead time of the torque loop */
    shift_rig_delay(16, s->M1_delay, M1_limited, s->M1_dead_steps, &s->x[14], &s->x[16]);
    /* torque-speed envelope, Figure 7.1 */
    const shift_rig_real M2_available = p->M2_speed_rated * p->M2_torque_max / shift_rig_max(p->M2_speed_rated,
        shift_rig_abs(s->x[5]));
    const shift_rig_real M2_limited = shift_rig_max(-M2_available, shift_rig_min(M2_available, in->M2_torque_ref));
    /* dead time of the torque loop */
    shift_rig_delay(16, s->M2_delay, M2_limited, s->M2_dead_steps, &s->x[15], &s->x[17]);
    /* x+ = Phi x + Gamma_u u */
    shift_rig_multiply(14, 18, &s->transition[0][0], s->x, x_free);
    /* w = G z */
    w_start[0] = s->x[0];
    w_start[1] = s->x[1];
    w_start[2] = s->x[2];
    w_start[3] = s->x[3];
    w_start[4] = shift_rig_select(shift_rig_abs(s->G[0][4] * s->x[0] + s->G[1][4] * s->x[1] + s->G[3][4] * s->x[3])
        < p->standstill_speed + s->velocity_rounding * (shift_rig_abs(s->G[0][4] * s->x[0]) +
        shift_rig_abs(s->G[1][4] * s->x[1]) + shift_rig_abs(s->G[3][4] * s->x[3])), 0.0, s->G[0][4] * s->x[0] +
        s->G[1][4] * s->x[1] + s->G[3][4] * s->x[3]);
    w_start[5] = shift_rig_select(shift_rig_abs(s->G[0][5] * s->x[0] + s->G[1][5] * s->x[1] + s->G[2][5] * s->x[2] +
        s->G[3][5] * s->x[3]) < p->standstill_speed + s->velocity_rounding * (shift_rig_abs(s->G[0][5] * s->x[0]) +
        shift_rig_abs(s->G[1][5] * s->x[1]) + shift_rig_abs(s->G[2][5] * s->x[2]) + shift_rig_abs(s->G[3][5] *
        s->x[3])), 0.0, s->G[0][5] * s->x[0] + s->G[1][5] * s->x[1] + s->G[2][5] * s->x[2] + s->G[3][5] * s->x[3]);
    /* speed at mid-step */
    const shift_rig_real gears_A_mid_speed = (0.5) * shift_rig_abs(s->friction_torque[0] * s->gamma[0][0] +
        s->friction_torque[1] * s->gamma[1][0] + s->friction_torque[2] * s->gamma[2][0] + s->friction_torque[3] *
        s->gamma[3][0] + s->friction_torque[4] * s->gamma[4][0] + s->friction_torque[5] * s->gamma[5][0] +
        w_start[0] + x_free[0]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[0] = in->gears_A_actuation * (p->gears_A_capacity + gears_A_mid_speed * p->gears_A_viscous);
    rest[0] = in->gears_A_actuation * p->gears_A_capacity;
    /* speed at mid-step */
    const shift_rig_real gears_B_mid_speed = (0.5) * shift_rig_abs(s->friction_torque[0] * s->gamma[0][1] +
        s->friction_torque[1] * s->gamma[1][1] + s->friction_torque[2] * s->gamma[2][1] + s->friction_torque[3] *
        s->gamma[3][1] + s->friction_torque[4] * s->gamma[4][1] + s->friction_torque[5] * s->gamma[5][1] +
        w_start[1] + x_free[1]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[1] = in->gears_B_actuation * (p->gears_B_capacity + gears_B_mid_speed * p->gears_B_viscous);
    rest[1] = in->gears_B_actuation * p->gears_B_capacity;
    /* speed at mid-step */
    const shift_rig_real gears_C_mid_speed = (0.5) * shift_rig_abs(s->friction_torque[0] * s->gamma[0][2] +
        s->friction_torque[1] * s->gamma[1][2] + s->friction_torque[2] * s->gamma[2][2] + s->friction_torque[3] *
        s->gamma[3][2] + s->friction_torque[4] * s->gamma[4][2] + s->friction_torque[5] * s->gamma[5][2] +
        w_start[2] + x_free[2]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[2] = in->gears_C_actuation * (p->gears_C_capacity + gears_C_mid_speed * p->gears_C_viscous);
    rest[2] = in->gears_C_actuation * p->gears_C_capacity;
    /* speed at mid-step */
    const shift_rig_real gears_D_mid_speed = (0.5) * shift_rig_abs(s->friction_torque[0] * s->gamma[0][3] +
        s->friction_torque[1] * s->gamma[1][3] + s->friction_torque[2] * s->gamma[2][3] + s->friction_torque[3] *
        s->gamma[3][3] + s->friction_torque[4] * s->gamma[4][3] + s->friction_torque[5] * s->gamma[5][3] +
        w_start[3] + x_free[3]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[3] = in->gears_D_actuation * (p->gears_D_capacity + gears_D_mid_speed * p->gears_D_viscous);
    rest[3] = in->gears_D_actuation * p->gears_D_capacity;
    /* speed at mid-step */
    const shift_rig_real gears_E_mid_speed = (0.5) * shift_rig_abs(s->G[0][4] * (s->friction_torque[0] *
        s->gamma[0][0] + s->friction_torque[1] * s->gamma[1][0] + s->friction_torque[2] * s->gamma[2][0] +
        s->friction_torque[3] * s->gamma[3][0] + s->friction_torque[4] * s->gamma[4][0] + s->friction_torque[5] *
        s->gamma[5][0] + x_free[0]) + s->G[1][4] * (s->friction_torque[0] * s->gamma[0][1] + s->friction_torque[1] *
        s->gamma[1][1] + s->friction_torque[2] * s->gamma[2][1] + s->friction_torque[3] * s->gamma[3][1] +
        s->friction_torque[4] * s->gamma[4][1] + s->friction_torque[5] * s->gamma[5][1] + x_free[1]) + s->G[3][4] *
        (s->friction_torque[0] * s->gamma[0][3] + s->friction_torque[1] * s->gamma[1][3] + s->friction_torque[2] *
        s->gamma[2][3] + s->friction_torque[3] * s->gamma[3][3] + s->friction_torque[4] * s->gamma[4][3] +
        s->friction_torque[5] * s->gamma[5][3] + x_free[3]) + w_start[4]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[4] = in->gears_E_actuation * (p->gears_E_capacity + gears_E_mid_speed * p->gears_E_viscous);
    rest[4] = in->gears_E_actuation * p->gears_E_capacity;
    /* speed at mid-step */
    const shift_rig_real gears_F_mid_speed = (0.5) * shift_rig_abs(s->G[0][5] * (s->friction_torque[0] *
        s->gamma[0][0] + s->friction_torque[1] * s->gamma[1][0] + s->friction_torque[2] * s->gamma[2][0] +
        s->friction_torque[3] * s->gamma[3][0] + s->friction_torque[4] * s->gamma[4][0] + s->friction_torque[5] *
        s->gamma[5][0] + x_free[0]) + s->G[1][5] * (s->friction_torque[0] * s->gamma[0][1] + s->friction_torque[1] *
        s->gamma[1][1] + s->friction_torque[2] * s->gamma[2][1] + s->friction_torque[3] * s->gamma[3][1] +
        s->friction_torque[4] * s->gamma[4][1] + s->friction_torque[5] * s->gamma[5][1] + x_free[1]) + s->G[2][5] *
        (s->friction_torque[0] * s->gamma[0][2] + s->friction_torque[1] * s->gamma[1][2] + s->friction_torque[2] *
        s->gamma[2][2] + s->friction_torque[3] * s->gamma[3][2] + s->friction_torque[4] * s->gamma[4][2] +
        s->friction_torque[5] * s->gamma[5][2] + x_free[2]) + s->G[3][5] * (s->friction_torque[0] * s->gamma[0][3] +
        s->friction_torque[1] * s->gamma[1][3] + s->friction_torque[2] * s->gamma[2][3] + s->friction_torque[3] *
        s->gamma[3][3] + s->friction_torque[4] * s->gamma[4][3] + s->friction_torque[5] * s->gamma[5][3] +
        x_free[3]) + w_start[5]);
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[5] = in->gears_F_actuation * (p->gears_F_capacity + gears_F_mid_speed * p->gears_F_viscous);
    rest[5] = in->gears_F_actuation * p->gears_F_capacity;
    /* w_free = G z_free */
    w_free[0] = x_free[0];
    w_free[1] = x_free[1];
    w_free[2] = x_free[2];
    w_free[3] = x_free[3];
    w_free[4] = s->G[0][4] * x_free[0] + s->G[1][4] * x_free[1] + s->G[3][4] * x_free[3];
    w_free[5] = s->G[0][5] * x_free[0] + s->G[1][5] * x_free[1] + s->G[2][5] * x_free[2] + s->G[3][5] * x_free[3];
    /* what sticks, slips and passes zero */
    shift_rig_friction_step(1, 0, &s->K[0][0], w_start, w_free, slide, rest, s->friction_torque, s->friction_rest,
        friction_mean, w_plus, &s->friction_status);
    mean_torque[0] = friction_mean[0];
    mean_torque[1] = friction_mean[1];
    mean_torque[2] = friction_mean[2];
    mean_torque[3] = friction_mean[3];
    mean_torque[4] = friction_mean[4];
    mean_torque[5] = friction_mean[5];
    /* x+ = x_free + Gamma_f T */
    shift_rig_add_product(14, 6, s->x, x_free, &s->gamma[0][0], mean_torque);
    /* exactly zero while it sticks */
    s->x[0] = shift_rig_select(p->standstill_speed > shift_rig_abs(w_plus[0]), 0.0, w_plus[0]);
    s->x[1] = shift_rig_select(p->standstill_speed > shift_rig_abs(w_plus[1]), 0.0, w_plus[1]);
    s->x[2] = shift_rig_select(p->standstill_speed > shift_rig_abs(w_plus[2]), 0.0, w_plus[2]);
    s->x[3] = shift_rig_select(p->standstill_speed > shift_rig_abs(w_plus[3]), 0.0, w_plus[3]);
    shift_rig_plant_measure(s, p, out);
    if (s->friction_status == SHIFT_RIG_REAL(-1)) {
        return shift_rig_plant_friction_unsolved;
    }
    if (s->friction_status == SHIFT_RIG_REAL(1)) {
        return shift_rig_plant_bad_capacity_gears_A;
    }
    if (s->friction_status == SHIFT_RIG_REAL(2)) {
        return shift_rig_plant_bad_capacity_gears_B;
    }
    if (s->friction_status == SHIFT_RIG_REAL(3)) {
        return shift_rig_plant_bad_capacity_gears_C;
    }
    if (s->friction_status == SHIFT_RIG_REAL(4)) {
        return shift_rig_plant_bad_capacity_gears_D;
    }
    if (s->friction_status == SHIFT_RIG_REAL(5)) {
        return shift_rig_plant_bad_capacity_gears_E;
    }
    if (s->friction_status == SHIFT_RIG_REAL(6)) {
        return shift_rig_plant_bad_capacity_gears_F;
    }
    return shift_rig_plant_ok;
}
