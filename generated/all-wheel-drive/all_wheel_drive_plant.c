/*
 * all_wheel_drive_plant.c: plant of the bed all_wheel_drive
 *
 * Emitted by ptgen 0.1.0 from all-wheel-drive.toml (SHA-256 4a4f0cf573c3f3c3), template block.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "all_wheel_drive_plant.h"
#include "all_wheel_drive_friction.h"

#include <float.h>
#include <string.h>

const all_wheel_drive_plant_params all_wheel_drive_plant_defaults = {
    .M1_inertia = 0.5,
    .M1_torque_max = 900.0,
    .M1_speed_rated = 335.103216382911,
    .M1_inverter_dead_time = 0.0001,
    .M1_inverter_time_constant = 0.00025,
    .flange1_inertia = 0.02,
    .flange1_stiffness = 380000.0,
    .flange1_damping = 0.5,
    .cardan1_stiffness = 40000.0,
    .cardan1_damping = 2.0,
    .centre_loss_coulomb = 2.0,
    .centre_loss_load = 0.01,
    .centre_loss_viscous = 0.002,
    .centre_limited_slip_coulomb = 20.0,
    .centre_limited_slip_load = 0.2,
    .centre_limited_slip_viscous = 0.05,
    .centre_ratio = 1.0,
    .centre_inertia = 0.02,
    .centre_inertia_pinion = 0.01,
    .centre_pinion_ratio = 1.0,
    .front_cardan_stiffness = 30000.0,
    .front_cardan_damping = 2.0,
    .rear_cardan_stiffness = 18000.0,
    .rear_cardan_damping = 2.0,
    .front_loss_coulomb = 2.0,
    .front_loss_load = 0.01,
    .front_loss_viscous = 0.002,
    .front_limited_slip_coulomb = 10.0,
    .front_limited_slip_load = 0.1,
    .front_limited_slip_viscous = 0.05,
    .front_ratio = 3.2,
    .front_inertia = 0.008,
    .front_inertia_pinion = 0.02,
    .front_pinion_ratio = 1.0,
    .rear_loss_coulomb = 2.0,
    .rear_loss_load = 0.01,
    .rear_loss_viscous = 0.002,
    .rear_limited_slip_coulomb = 40.0,
    .rear_limited_slip_load = 0.3,
    .rear_limited_slip_viscous = 0.05,
    .rear_ratio = 3.2,
    .rear_inertia = 0.01,
    .rear_inertia_pinion = 0.02,
    .rear_pinion_ratio = 1.0,
    .side2_stiffness = 14000.0,
    .side2_damping = 1.0,
    .flange2_inertia = 0.03,
    .flange2_stiffness = 220000.0,
    .flange2_damping = 0.5,
    .M2_inertia = 2.5,
    .M2_torque_max = 2400.0,
    .M2_speed_rated = 104.71975511966,
    .M2_inverter_dead_time = 0.0001,
    .M2_inverter_time_constant = 0.00025,
    .side3_stiffness = 14000.0,
    .side3_damping = 1.0,
    .flange3_inertia = 0.03,
    .flange3_stiffness = 220000.0,
    .flange3_damping = 0.5,
    .M3_inertia = 2.5,
    .M3_torque_max = 2400.0,
    .M3_speed_rated = 104.71975511966,
    .M3_inverter_dead_time = 0.0001,
    .M3_inverter_time_constant = 0.00025,
    .side4_stiffness = 18000.0,
    .side4_damping = 1.0,
    .flange4_inertia = 0.03,
    .flange4_stiffness = 220000.0,
    .flange4_damping = 0.5,
    .M4_inertia = 2.5,
    .M4_torque_max = 2400.0,
    .M4_speed_rated = 104.71975511966,
    .M4_inverter_dead_time = 0.0001,
    .M4_inverter_time_constant = 0.00025,
    .side5_stiffness = 18000.0,
    .side5_damping = 1.0,
    .flange5_inertia = 0.03,
    .flange5_stiffness = 220000.0,
    .flange5_damping = 0.5,
    .M5_inertia = 2.5,
    .M5_torque_max = 2400.0,
    .M5_speed_rated = 104.71975511966,
    .M5_inverter_dead_time = 0.0001,
    .M5_inverter_time_constant = 0.00025,
    .standstill_speed = 1e-09,
    .sample_time = 0.0001,
};

/* Range of each parameter; `open` excludes the lower bound. The order is that of the status codes. */
static const struct {
    const char *text;
    size_t offset;
    all_wheel_drive_real least;
    all_wheel_drive_real most;
    int open;
    int not_zero;
} limits[] = {
    { "the parameter M1_inertia is outside its range", offsetof(all_wheel_drive_plant_params, M1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_torque_max is outside its range", offsetof(all_wheel_drive_plant_params, M1_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_speed_rated is outside its range", offsetof(all_wheel_drive_plant_params, M1_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M1_inverter_dead_time is outside its range", offsetof(all_wheel_drive_plant_params, M1_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M1_inverter_time_constant is outside its range", offsetof(all_wheel_drive_plant_params, M1_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_inertia is outside its range", offsetof(all_wheel_drive_plant_params, flange1_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_stiffness is outside its range", offsetof(all_wheel_drive_plant_params, flange1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange1_damping is outside its range", offsetof(all_wheel_drive_plant_params, flange1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter cardan1_stiffness is outside its range", offsetof(all_wheel_drive_plant_params, cardan1_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter cardan1_damping is outside its range", offsetof(all_wheel_drive_plant_params, cardan1_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter centre_loss_coulomb is outside its range", offsetof(all_wheel_drive_plant_params, centre_loss_coulomb), 0.0, DBL_MAX, 0, 0 },
    { "the parameter centre_loss_load is outside its range", offsetof(all_wheel_drive_plant_params, centre_loss_load), 0.0, DBL_MAX, 0, 0 },
    { "the parameter centre_loss_viscous is outside its range", offsetof(all_wheel_drive_plant_params, centre_loss_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter centre_limited_slip_coulomb is outside its range", offsetof(all_wheel_drive_plant_params, centre_limited_slip_coulomb), 0.0, DBL_MAX, 0, 0 },
    { "the parameter centre_limited_slip_load is outside its range", offsetof(all_wheel_drive_plant_params, centre_limited_slip_load), 0.0, DBL_MAX, 0, 0 },
    { "the parameter centre_limited_slip_viscous is outside its range", offsetof(all_wheel_drive_plant_params, centre_limited_slip_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter centre_ratio is outside its range", offsetof(all_wheel_drive_plant_params, centre_ratio), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter centre_inertia is outside its range", offsetof(all_wheel_drive_plant_params, centre_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter centre_inertia_pinion is outside its range", offsetof(all_wheel_drive_plant_params, centre_inertia_pinion), 0.0, DBL_MAX, 1, 0 },
    { "the parameter centre_pinion_ratio is outside its range", offsetof(all_wheel_drive_plant_params, centre_pinion_ratio), 0.0, DBL_MAX, 1, 0 },
    { "the parameter front_cardan_stiffness is outside its range", offsetof(all_wheel_drive_plant_params, front_cardan_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter front_cardan_damping is outside its range", offsetof(all_wheel_drive_plant_params, front_cardan_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter rear_cardan_stiffness is outside its range", offsetof(all_wheel_drive_plant_params, rear_cardan_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter rear_cardan_damping is outside its range", offsetof(all_wheel_drive_plant_params, rear_cardan_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter front_loss_coulomb is outside its range", offsetof(all_wheel_drive_plant_params, front_loss_coulomb), 0.0, DBL_MAX, 0, 0 },
    { "the parameter front_loss_load is outside its range", offsetof(all_wheel_drive_plant_params, front_loss_load), 0.0, DBL_MAX, 0, 0 },
    { "the parameter front_loss_viscous is outside its range", offsetof(all_wheel_drive_plant_params, front_loss_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter front_limited_slip_coulomb is outside its range", offsetof(all_wheel_drive_plant_params, front_limited_slip_coulomb), 0.0, DBL_MAX, 0, 0 },
    { "the parameter front_limited_slip_load is outside its range", offsetof(all_wheel_drive_plant_params, front_limited_slip_load), 0.0, DBL_MAX, 0, 0 },
    { "the parameter front_limited_slip_viscous is outside its range", offsetof(all_wheel_drive_plant_params, front_limited_slip_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter front_ratio is outside its range", offsetof(all_wheel_drive_plant_params, front_ratio), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter front_inertia is outside its range", offsetof(all_wheel_drive_plant_params, front_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter front_inertia_pinion is outside its range", offsetof(all_wheel_drive_plant_params, front_inertia_pinion), 0.0, DBL_MAX, 1, 0 },
    { "the parameter front_pinion_ratio is outside its range", offsetof(all_wheel_drive_plant_params, front_pinion_ratio), 0.0, DBL_MAX, 1, 0 },
    { "the parameter rear_loss_coulomb is outside its range", offsetof(all_wheel_drive_plant_params, rear_loss_coulomb), 0.0, DBL_MAX, 0, 0 },
    { "the parameter rear_loss_load is outside its range", offsetof(all_wheel_drive_plant_params, rear_loss_load), 0.0, DBL_MAX, 0, 0 },
    { "the parameter rear_loss_viscous is outside its range", offsetof(all_wheel_drive_plant_params, rear_loss_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter rear_limited_slip_coulomb is outside its range", offsetof(all_wheel_drive_plant_params, rear_limited_slip_coulomb), 0.0, DBL_MAX, 0, 0 },
    { "the parameter rear_limited_slip_load is outside its range", offsetof(all_wheel_drive_plant_params, rear_limited_slip_load), 0.0, DBL_MAX, 0, 0 },
    { "the parameter rear_limited_slip_viscous is outside its range", offsetof(all_wheel_drive_plant_params, rear_limited_slip_viscous), 0.0, DBL_MAX, 0, 0 },
    { "the parameter rear_ratio is outside its range", offsetof(all_wheel_drive_plant_params, rear_ratio), -DBL_MAX, DBL_MAX, 0, 1 },
    { "the parameter rear_inertia is outside its range", offsetof(all_wheel_drive_plant_params, rear_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter rear_inertia_pinion is outside its range", offsetof(all_wheel_drive_plant_params, rear_inertia_pinion), 0.0, DBL_MAX, 1, 0 },
    { "the parameter rear_pinion_ratio is outside its range", offsetof(all_wheel_drive_plant_params, rear_pinion_ratio), 0.0, DBL_MAX, 1, 0 },
    { "the parameter side2_stiffness is outside its range", offsetof(all_wheel_drive_plant_params, side2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter side2_damping is outside its range", offsetof(all_wheel_drive_plant_params, side2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter flange2_inertia is outside its range", offsetof(all_wheel_drive_plant_params, flange2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_stiffness is outside its range", offsetof(all_wheel_drive_plant_params, flange2_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange2_damping is outside its range", offsetof(all_wheel_drive_plant_params, flange2_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M2_inertia is outside its range", offsetof(all_wheel_drive_plant_params, M2_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_torque_max is outside its range", offsetof(all_wheel_drive_plant_params, M2_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_speed_rated is outside its range", offsetof(all_wheel_drive_plant_params, M2_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M2_inverter_dead_time is outside its range", offsetof(all_wheel_drive_plant_params, M2_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M2_inverter_time_constant is outside its range", offsetof(all_wheel_drive_plant_params, M2_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter side3_stiffness is outside its range", offsetof(all_wheel_drive_plant_params, side3_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter side3_damping is outside its range", offsetof(all_wheel_drive_plant_params, side3_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter flange3_inertia is outside its range", offsetof(all_wheel_drive_plant_params, flange3_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_stiffness is outside its range", offsetof(all_wheel_drive_plant_params, flange3_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange3_damping is outside its range", offsetof(all_wheel_drive_plant_params, flange3_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M3_inertia is outside its range", offsetof(all_wheel_drive_plant_params, M3_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_torque_max is outside its range", offsetof(all_wheel_drive_plant_params, M3_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_speed_rated is outside its range", offsetof(all_wheel_drive_plant_params, M3_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M3_inverter_dead_time is outside its range", offsetof(all_wheel_drive_plant_params, M3_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M3_inverter_time_constant is outside its range", offsetof(all_wheel_drive_plant_params, M3_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter side4_stiffness is outside its range", offsetof(all_wheel_drive_plant_params, side4_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter side4_damping is outside its range", offsetof(all_wheel_drive_plant_params, side4_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter flange4_inertia is outside its range", offsetof(all_wheel_drive_plant_params, flange4_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange4_stiffness is outside its range", offsetof(all_wheel_drive_plant_params, flange4_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange4_damping is outside its range", offsetof(all_wheel_drive_plant_params, flange4_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M4_inertia is outside its range", offsetof(all_wheel_drive_plant_params, M4_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M4_torque_max is outside its range", offsetof(all_wheel_drive_plant_params, M4_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M4_speed_rated is outside its range", offsetof(all_wheel_drive_plant_params, M4_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M4_inverter_dead_time is outside its range", offsetof(all_wheel_drive_plant_params, M4_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M4_inverter_time_constant is outside its range", offsetof(all_wheel_drive_plant_params, M4_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter side5_stiffness is outside its range", offsetof(all_wheel_drive_plant_params, side5_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter side5_damping is outside its range", offsetof(all_wheel_drive_plant_params, side5_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter flange5_inertia is outside its range", offsetof(all_wheel_drive_plant_params, flange5_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange5_stiffness is outside its range", offsetof(all_wheel_drive_plant_params, flange5_stiffness), 0.0, DBL_MAX, 1, 0 },
    { "the parameter flange5_damping is outside its range", offsetof(all_wheel_drive_plant_params, flange5_damping), 0.0, DBL_MAX, 0, 0 },
    { "the parameter M5_inertia is outside its range", offsetof(all_wheel_drive_plant_params, M5_inertia), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M5_torque_max is outside its range", offsetof(all_wheel_drive_plant_params, M5_torque_max), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M5_speed_rated is outside its range", offsetof(all_wheel_drive_plant_params, M5_speed_rated), 0.0, DBL_MAX, 1, 0 },
    { "the parameter M5_inverter_dead_time is outside its range", offsetof(all_wheel_drive_plant_params, M5_inverter_dead_time), 0.0, 0.0015, 0, 0 },
    { "the parameter M5_inverter_time_constant is outside its range", offsetof(all_wheel_drive_plant_params, M5_inverter_time_constant), 0.0, DBL_MAX, 1, 0 },
    { "the parameter standstill_speed is outside its range", offsetof(all_wheel_drive_plant_params, standstill_speed), 0.0, DBL_MAX, 0, 0 },
    { "the parameter sample_time is outside its range", offsetof(all_wheel_drive_plant_params, sample_time), 0.0, DBL_MAX, 1, 0 },
};

enum { limit_count = sizeof limits / sizeof limits[0] };

const char *all_wheel_drive_plant_status_text(all_wheel_drive_plant_status status)
{
    switch ((int)status) {
    case all_wheel_drive_plant_ok:
        return "ok";
    case all_wheel_drive_plant_mass_matrix:
        return "the inertia matrix is not positive definite";
    case all_wheel_drive_plant_exponential_range:
        return "the parameters are too far from those that the code was emitted for; emit it again";
    case all_wheel_drive_plant_friction_matrix:
        return "a mode of the bed is too fast for the step; make a stiff shaft rigid, or the step shorter";
    case all_wheel_drive_plant_friction_unsolved:
        return "the friction torques are not exact";
    case all_wheel_drive_plant_bad_capacity_centre_loss:
        return "the capacity of centre.loss is no number from 0 up; it was taken as 0";
    case all_wheel_drive_plant_bad_capacity_centre_limited_slip:
        return "the capacity of centre.limited_slip is no number from 0 up; it was taken as 0";
    case all_wheel_drive_plant_bad_capacity_front_loss:
        return "the capacity of front.loss is no number from 0 up; it was taken as 0";
    case all_wheel_drive_plant_bad_capacity_front_limited_slip:
        return "the capacity of front.limited_slip is no number from 0 up; it was taken as 0";
    case all_wheel_drive_plant_bad_capacity_rear_loss:
        return "the capacity of rear.loss is no number from 0 up; it was taken as 0";
    case all_wheel_drive_plant_bad_capacity_rear_limited_slip:
        return "the capacity of rear.limited_slip is no number from 0 up; it was taken as 0";
    case all_wheel_drive_plant_bad_input_M1_torque_ref:
        return "the input M1_torque_ref is not finite";
    case all_wheel_drive_plant_bad_input_M2_torque_ref:
        return "the input M2_torque_ref is not finite";
    case all_wheel_drive_plant_bad_input_M3_torque_ref:
        return "the input M3_torque_ref is not finite";
    case all_wheel_drive_plant_bad_input_M4_torque_ref:
        return "the input M4_torque_ref is not finite";
    case all_wheel_drive_plant_bad_input_M5_torque_ref:
        return "the input M5_torque_ref is not finite";
    default:
        break;
    }
    const int limit = (int)status - 2000;
    return limit >= 0 && limit < limit_count ? limits[limit].text : "unknown status";
}

all_wheel_drive_plant_status all_wheel_drive_plant_init(all_wheel_drive_plant_state *s, const all_wheel_drive_plant_params *p)
{
    memset(s, 0, sizeof *s);
    return all_wheel_drive_plant_update(s, p);
}

all_wheel_drive_plant_status all_wheel_drive_plant_update(all_wheel_drive_plant_state *s, const all_wheel_drive_plant_params *p)
{
    for (int k = 0; k < limit_count; ++k) {
        const all_wheel_drive_real value = *(const all_wheel_drive_real *)(const void *)((const char *)p + limits[k].offset);
        const int above = limits[k].open ? value > limits[k].least : value >= limits[k].least; /* false for NaN */
        if (!(above && value <= limits[k].most) || (limits[k].not_zero && value == 0.0)) {
            return (all_wheel_drive_plant_status)(2000 + k);
        }
    }
    memset(s->transition, 0, sizeof s->transition);
    memset(s->gamma, 0, sizeof s->gamma);
    memset(s->K, 0, sizeof s->K);
    all_wheel_drive_real mass[16][16];
    all_wheel_drive_real forces[39][16];
    all_wheel_drive_real A[44][36];
    all_wheel_drive_real scale[44];
    all_wheel_drive_real whole[44][36];
    all_wheel_drive_real late[44][36];
    all_wheel_drive_real early[44][36];
    all_wheel_drive_real rates[39][16];
    all_wheel_drive_zero(sizeof mass, mass);
    all_wheel_drive_zero(sizeof forces, forces);
    all_wheel_drive_zero(sizeof A, A);
    all_wheel_drive_zero(sizeof scale, scale);
    all_wheel_drive_zero(sizeof whole, whole);
    all_wheel_drive_zero(sizeof late, late);
    all_wheel_drive_zero(sizeof early, early);
    all_wheel_drive_zero(sizeof rates, rates);
    
    /* M = S' I S */
    mass[0][0] = p->centre_inertia;
    mass[1][1] = p->centre_inertia_pinion * p->centre_pinion_ratio;
    mass[2][2] = p->front_inertia;
    mass[3][3] = p->front_inertia_pinion * p->front_pinion_ratio;
    mass[4][4] = p->rear_inertia;
    mass[5][5] = p->rear_inertia_pinion * p->rear_pinion_ratio;
    mass[6][6] = p->M1_inertia;
    mass[7][7] = p->M2_inertia;
    mass[8][8] = p->M3_inertia;
    mass[9][9] = p->M4_inertia;
    mass[10][10] = p->M5_inertia;
    mass[11][11] = p->flange1_inertia;
    mass[12][12] = p->flange2_inertia;
    mass[13][13] = p->flange3_inertia;
    mass[14][14] = p->flange4_inertia;
    mass[15][15] = p->flange5_inertia;
    /* M dz/dt = B' u - E'(C e + D E z) - G'(T + k_v G z) */
    forces[0][0] = -p->cardan1_damping - p->centre_loss_viscous - p->front_cardan_damping / (p->centre_ratio *
        p->centre_ratio) - p->rear_cardan_damping / (p->centre_ratio * p->centre_ratio);
    forces[1][0] = -p->centre_pinion_ratio * p->front_cardan_damping / p->centre_ratio + p->centre_pinion_ratio *
        p->rear_cardan_damping / p->centre_ratio;
    forces[2][0] = p->front_cardan_damping / p->centre_ratio;
    forces[4][0] = p->rear_cardan_damping / p->centre_ratio;
    forces[11][0] = p->cardan1_damping;
    forces[17][0] = p->cardan1_stiffness;
    forces[18][0] = -p->front_cardan_stiffness / (p->centre_ratio * p->centre_ratio);
    forces[19][0] = -p->rear_cardan_stiffness / (p->centre_ratio * p->centre_ratio);
    forces[33][0] = -1.0;
    forces[0][1] = -p->centre_pinion_ratio * p->front_cardan_damping / p->centre_ratio + p->centre_pinion_ratio *
        p->rear_cardan_damping / p->centre_ratio;
    forces[1][1] = -p->centre_limited_slip_viscous - (p->centre_pinion_ratio * p->centre_pinion_ratio) *
        p->front_cardan_damping - (p->centre_pinion_ratio * p->centre_pinion_ratio) * p->rear_cardan_damping;
    forces[2][1] = p->centre_pinion_ratio * p->front_cardan_damping;
    forces[4][1] = -p->centre_pinion_ratio * p->rear_cardan_damping;
    forces[18][1] = -p->centre_pinion_ratio * p->front_cardan_stiffness / p->centre_ratio;
    forces[19][1] = p->centre_pinion_ratio * p->rear_cardan_stiffness / p->centre_ratio;
    forces[34][1] = -1.0;
    forces[0][2] = p->front_cardan_damping / p->centre_ratio;
    forces[1][2] = p->centre_pinion_ratio * p->front_cardan_damping;
    forces[2][2] = -p->front_cardan_damping - p->front_loss_viscous - p->side2_damping / (p->front_ratio *
        p->front_ratio) - p->side3_damping / (p->front_ratio * p->front_ratio);
    forces[3][2] = -p->front_pinion_ratio * p->side2_damping / p->front_ratio + p->front_pinion_ratio *
        p->side3_damping / p->front_ratio;
    forces[12][2] = p->side2_damping / p->front_ratio;
    forces[13][2] = p->side3_damping / p->front_ratio;
    forces[18][2] = p->front_cardan_stiffness / p->centre_ratio;
    forces[20][2] = -p->side2_stiffness / (p->front_ratio * p->front_ratio);
    forces[22][2] = -p->side3_stiffness / (p->front_ratio * p->front_ratio);
    forces[35][2] = -1.0;
    forces[2][3] = -p->front_pinion_ratio * p->side2_damping / p->front_ratio + p->front_pinion_ratio *
        p->side3_damping / p->front_ratio;
    forces[3][3] = -p->front_limited_slip_viscous - (p->front_pinion_ratio * p->front_pinion_ratio) *
        p->side2_damping - (p->front_pinion_ratio * p->front_pinion_ratio) * p->side3_damping;
    forces[12][3] = p->front_pinion_ratio * p->side2_damping;
    forces[13][3] = -p->front_pinion_ratio * p->side3_damping;
    forces[20][3] = -p->front_pinion_ratio * p->side2_stiffness / p->front_ratio;
    forces[22][3] = p->front_pinion_ratio * p->side3_stiffness / p->front_ratio;
    forces[36][3] = -1.0;
    forces[0][4] = p->rear_cardan_damping / p->centre_ratio;
    forces[1][4] = -p->centre_pinion_ratio * p->rear_cardan_damping;
    forces[4][4] = -p->rear_cardan_damping - p->rear_loss_viscous - p->side4_damping / (p->rear_ratio *
        p->rear_ratio) - p->side5_damping / (p->rear_ratio * p->rear_ratio);
    forces[5][4] = -p->rear_pinion_ratio * p->side4_damping / p->rear_ratio + p->rear_pinion_ratio *
        p->side5_damping / p->rear_ratio;
    forces[14][4] = p->side4_damping / p->rear_ratio;
    forces[15][4] = p->side5_damping / p->rear_ratio;
    forces[19][4] = p->rear_cardan_stiffness / p->centre_ratio;
    forces[24][4] = -p->side4_stiffness / (p->rear_ratio * p->rear_ratio);
    forces[26][4] = -p->side5_stiffness / (p->rear_ratio * p->rear_ratio);
    forces[37][4] = -1.0;
    forces[4][5] = -p->rear_pinion_ratio * p->side4_damping / p->rear_ratio + p->rear_pinion_ratio *
        p->side5_damping / p->rear_ratio;
    forces[5][5] = -p->rear_limited_slip_viscous - (p->rear_pinion_ratio * p->rear_pinion_ratio) * p->side4_damping
        - (p->rear_pinion_ratio * p->rear_pinion_ratio) * p->side5_damping;
    forces[14][5] = p->rear_pinion_ratio * p->side4_damping;
    forces[15][5] = -p->rear_pinion_ratio * p->side5_damping;
    forces[24][5] = -p->rear_pinion_ratio * p->side4_stiffness / p->rear_ratio;
    forces[26][5] = p->rear_pinion_ratio * p->side5_stiffness / p->rear_ratio;
    forces[38][5] = -1.0;
    forces[6][6] = -p->flange1_damping;
    forces[11][6] = p->flange1_damping;
    forces[16][6] = -p->flange1_stiffness;
    forces[28][6] = 1.0;
    forces[7][7] = -p->flange2_damping;
    forces[12][7] = p->flange2_damping;
    forces[21][7] = -p->flange2_stiffness;
    forces[29][7] = 1.0;
    forces[8][8] = -p->flange3_damping;
    forces[13][8] = p->flange3_damping;
    forces[23][8] = -p->flange3_stiffness;
    forces[30][8] = 1.0;
    forces[9][9] = -p->flange4_damping;
    forces[14][9] = p->flange4_damping;
    forces[25][9] = -p->flange4_stiffness;
    forces[31][9] = 1.0;
    forces[10][10] = -p->flange5_damping;
    forces[15][10] = p->flange5_damping;
    forces[27][10] = -p->flange5_stiffness;
    forces[32][10] = 1.0;
    forces[0][11] = p->cardan1_damping;
    forces[6][11] = p->flange1_damping;
    forces[11][11] = -p->cardan1_damping - p->flange1_damping;
    forces[16][11] = p->flange1_stiffness;
    forces[17][11] = -p->cardan1_stiffness;
    forces[2][12] = p->side2_damping / p->front_ratio;
    forces[3][12] = p->front_pinion_ratio * p->side2_damping;
    forces[7][12] = p->flange2_damping;
    forces[12][12] = -p->flange2_damping - p->side2_damping;
    forces[20][12] = p->side2_stiffness / p->front_ratio;
    forces[21][12] = p->flange2_stiffness;
    forces[2][13] = p->side3_damping / p->front_ratio;
    forces[3][13] = -p->front_pinion_ratio * p->side3_damping;
    forces[8][13] = p->flange3_damping;
    forces[13][13] = -p->flange3_damping - p->side3_damping;
    forces[22][13] = p->side3_stiffness / p->front_ratio;
    forces[23][13] = p->flange3_stiffness;
    forces[4][14] = p->side4_damping / p->rear_ratio;
    forces[5][14] = p->rear_pinion_ratio * p->side4_damping;
    forces[9][14] = p->flange4_damping;
    forces[14][14] = -p->flange4_damping - p->side4_damping;
    forces[24][14] = p->side4_stiffness / p->rear_ratio;
    forces[25][14] = p->flange4_stiffness;
    forces[4][15] = p->side5_damping / p->rear_ratio;
    forces[5][15] = -p->rear_pinion_ratio * p->side5_damping;
    forces[10][15] = p->flange5_damping;
    forces[15][15] = -p->flange5_damping - p->side5_damping;
    forces[26][15] = p->side5_stiffness / p->rear_ratio;
    forces[27][15] = p->flange5_stiffness;
    if (!all_wheel_drive_cholesky_solve(16, 39, &mass[0][0], &forces[0][0], &rates[0][0])) {
        return all_wheel_drive_plant_mass_matrix;
    }
    all_wheel_drive_insert(16, 36, 16, 0, 0, 0, 28, &A[0][0], &rates[0][0]);
    /* de/dt = E z */
    A[6][16] = 1.0;
    A[11][16] = -1.0;
    A[0][17] = -1.0;
    A[11][17] = 1.0;
    A[0][18] = 1.0;
    A[1][18] = p->centre_pinion_ratio * p->centre_ratio;
    A[2][18] = -p->centre_ratio;
    A[0][19] = 1.0;
    A[1][19] = -p->centre_pinion_ratio * p->centre_ratio;
    A[4][19] = -p->centre_ratio;
    A[2][20] = 1.0;
    A[3][20] = p->front_pinion_ratio * p->front_ratio;
    A[12][20] = -p->front_ratio;
    A[7][21] = 1.0;
    A[12][21] = -1.0;
    A[2][22] = 1.0;
    A[3][22] = -p->front_pinion_ratio * p->front_ratio;
    A[13][22] = -p->front_ratio;
    A[8][23] = 1.0;
    A[13][23] = -1.0;
    A[4][24] = 1.0;
    A[5][24] = p->rear_pinion_ratio * p->rear_ratio;
    A[14][24] = -p->rear_ratio;
    A[9][25] = 1.0;
    A[14][25] = -1.0;
    A[4][26] = 1.0;
    A[5][26] = -p->rear_pinion_ratio * p->rear_ratio;
    A[15][26] = -p->rear_ratio;
    A[10][27] = 1.0;
    A[15][27] = -1.0;
    all_wheel_drive_insert(16, 36, 16, 0, 28, 28, 1, &A[0][0], &rates[0][0]);
    /* lag of the torque loop */
    A[28][28] = -1.0 / p->M1_inverter_time_constant;
    A[33][28] = 1.0 / p->M1_inverter_time_constant;
    all_wheel_drive_insert(16, 36, 16, 0, 29, 29, 1, &A[0][0], &rates[0][0]);
    A[29][29] = -1.0 / p->M2_inverter_time_constant;
    A[34][29] = 1.0 / p->M2_inverter_time_constant;
    all_wheel_drive_insert(16, 36, 16, 0, 30, 30, 1, &A[0][0], &rates[0][0]);
    A[30][30] = -1.0 / p->M3_inverter_time_constant;
    A[35][30] = 1.0 / p->M3_inverter_time_constant;
    all_wheel_drive_insert(16, 36, 16, 0, 31, 31, 1, &A[0][0], &rates[0][0]);
    A[31][31] = -1.0 / p->M4_inverter_time_constant;
    A[36][31] = 1.0 / p->M4_inverter_time_constant;
    all_wheel_drive_insert(16, 36, 16, 0, 32, 32, 1, &A[0][0], &rates[0][0]);
    A[32][32] = -1.0 / p->M5_inverter_time_constant;
    A[37][32] = 1.0 / p->M5_inverter_time_constant;
    all_wheel_drive_insert(16, 36, 16, 0, 38, 33, 6, &A[0][0], &rates[0][0]);
    scale[0] = 1.0;
    scale[1] = 1.0;
    scale[2] = 1.0;
    scale[3] = 1.0;
    scale[4] = 1.0;
    scale[5] = 1.0;
    scale[6] = 1.0;
    scale[7] = 1.0;
    scale[8] = 1.0;
    scale[9] = 1.0;
    scale[10] = 1.0;
    scale[11] = 1.0;
    scale[12] = 1.0;
    scale[13] = 1.0;
    scale[14] = 1.0;
    scale[15] = 1.0;
    scale[16] = p->sample_time;
    scale[17] = p->sample_time;
    scale[18] = p->sample_time;
    scale[19] = p->sample_time;
    scale[20] = p->sample_time;
    scale[21] = p->sample_time;
    scale[22] = p->sample_time;
    scale[23] = p->sample_time;
    scale[24] = p->sample_time;
    scale[25] = p->sample_time;
    scale[26] = p->sample_time;
    scale[27] = p->sample_time;
    scale[28] = 1.0;
    scale[29] = 1.0;
    scale[30] = 1.0;
    scale[31] = 1.0;
    scale[32] = 1.0;
    scale[33] = 1.0;
    scale[34] = 1.0;
    scale[35] = 1.0;
    scale[36] = 1.0;
    scale[37] = 1.0;
    scale[38] = 1.0;
    scale[39] = 1.0;
    scale[40] = 1.0;
    scale[41] = 1.0;
    scale[42] = 1.0;
    scale[43] = 1.0;
    /* exact discretisation */
    if (!all_wheel_drive_discretise(33, 44, 6, &A[0][0], scale, p->sample_time, &whole[0][0])) {
        return all_wheel_drive_plant_exponential_range;
    }
    all_wheel_drive_insert(33, 36, 36, 0, 0, 0, 33, &s->transition[0][0], &whole[0][0]);
    /* dead time = (d + f) h */
    s->M1_dead_steps = all_wheel_drive_floor(p->M1_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const all_wheel_drive_real M1_late_time = p->sample_time - all_wheel_drive_max(0.0, -s->M1_dead_steps *
        p->sample_time + p->M1_inverter_dead_time);
    if (!all_wheel_drive_discretise(33, 44, 6, &A[0][0], scale, M1_late_time, &late[0][0])) {
        return all_wheel_drive_plant_exponential_range;
    }
    all_wheel_drive_difference(33, 44, &whole[0][0], &late[0][0], &early[0][0]);
    all_wheel_drive_insert(33, 36, 36, 0, 33, 33, 1, &s->transition[0][0], &late[0][0]);
    all_wheel_drive_insert(33, 36, 36, 0, 38, 33, 1, &s->transition[0][0], &early[0][0]);
    /* dead time = (d + f) h */
    s->M2_dead_steps = all_wheel_drive_floor(p->M2_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const all_wheel_drive_real M2_late_time = p->sample_time - all_wheel_drive_max(0.0, -s->M2_dead_steps *
        p->sample_time + p->M2_inverter_dead_time);
    if (!all_wheel_drive_discretise(33, 44, 6, &A[0][0], scale, M2_late_time, &late[0][0])) {
        return all_wheel_drive_plant_exponential_range;
    }
    all_wheel_drive_difference(33, 44, &whole[0][0], &late[0][0], &early[0][0]);
    all_wheel_drive_insert(33, 36, 36, 0, 34, 34, 1, &s->transition[0][0], &late[0][0]);
    all_wheel_drive_insert(33, 36, 36, 0, 39, 34, 1, &s->transition[0][0], &early[0][0]);
    /* dead time = (d + f) h */
    s->M3_dead_steps = all_wheel_drive_floor(p->M3_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const all_wheel_drive_real M3_late_time = p->sample_time - all_wheel_drive_max(0.0, -s->M3_dead_steps *
        p->sample_time + p->M3_inverter_dead_time);
    if (!all_wheel_drive_discretise(33, 44, 6, &A[0][0], scale, M3_late_time, &late[0][0])) {
        return all_wheel_drive_plant_exponential_range;
    }
    all_wheel_drive_difference(33, 44, &whole[0][0], &late[0][0], &early[0][0]);
    all_wheel_drive_insert(33, 36, 36, 0, 35, 35, 1, &s->transition[0][0], &late[0][0]);
    all_wheel_drive_insert(33, 36, 36, 0, 40, 35, 1, &s->transition[0][0], &early[0][0]);
    /* dead time = (d + f) h */
    s->M4_dead_steps = all_wheel_drive_floor(p->M4_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const all_wheel_drive_real M4_late_time = p->sample_time - all_wheel_drive_max(0.0, -s->M4_dead_steps *
        p->sample_time + p->M4_inverter_dead_time);
    if (!all_wheel_drive_discretise(33, 44, 6, &A[0][0], scale, M4_late_time, &late[0][0])) {
        return all_wheel_drive_plant_exponential_range;
    }
    all_wheel_drive_difference(33, 44, &whole[0][0], &late[0][0], &early[0][0]);
    all_wheel_drive_insert(33, 36, 36, 0, 36, 36, 1, &s->transition[0][0], &late[0][0]);
    all_wheel_drive_insert(33, 36, 36, 0, 41, 36, 1, &s->transition[0][0], &early[0][0]);
    /* dead time = (d + f) h */
    s->M5_dead_steps = all_wheel_drive_floor(p->M5_inverter_dead_time / p->sample_time + 1e-06);
    /* the late command acts for (1 - f) h */
    const all_wheel_drive_real M5_late_time = p->sample_time - all_wheel_drive_max(0.0, -s->M5_dead_steps *
        p->sample_time + p->M5_inverter_dead_time);
    if (!all_wheel_drive_discretise(33, 44, 6, &A[0][0], scale, M5_late_time, &late[0][0])) {
        return all_wheel_drive_plant_exponential_range;
    }
    all_wheel_drive_difference(33, 44, &whole[0][0], &late[0][0], &early[0][0]);
    all_wheel_drive_insert(33, 36, 36, 0, 37, 37, 1, &s->transition[0][0], &late[0][0]);
    all_wheel_drive_insert(33, 36, 36, 0, 42, 37, 1, &s->transition[0][0], &early[0][0]);
    all_wheel_drive_insert(33, 36, 36, 0, 0, 38, 6, &s->gamma[0][0], &whole[0][0]);
    /* K = -G Gamma_f */
    s->K[0][0] = -whole[38][0];
    s->K[1][0] = -whole[39][0];
    s->K[2][0] = -whole[40][0];
    s->K[3][0] = -whole[41][0];
    s->K[4][0] = -whole[42][0];
    s->K[5][0] = -whole[43][0];
    s->K[0][1] = -whole[38][1];
    s->K[1][1] = -whole[39][1];
    s->K[2][1] = -whole[40][1];
    s->K[3][1] = -whole[41][1];
    s->K[4][1] = -whole[42][1];
    s->K[5][1] = -whole[43][1];
    s->K[0][2] = -whole[38][2];
    s->K[1][2] = -whole[39][2];
    s->K[2][2] = -whole[40][2];
    s->K[3][2] = -whole[41][2];
    s->K[4][2] = -whole[42][2];
    s->K[5][2] = -whole[43][2];
    s->K[0][3] = -whole[38][3];
    s->K[1][3] = -whole[39][3];
    s->K[2][3] = -whole[40][3];
    s->K[3][3] = -whole[41][3];
    s->K[4][3] = -whole[42][3];
    s->K[5][3] = -whole[43][3];
    s->K[0][4] = -whole[38][4];
    s->K[1][4] = -whole[39][4];
    s->K[2][4] = -whole[40][4];
    s->K[3][4] = -whole[41][4];
    s->K[4][4] = -whole[42][4];
    s->K[5][4] = -whole[43][4];
    s->K[0][5] = -whole[38][5];
    s->K[1][5] = -whole[39][5];
    s->K[2][5] = -whole[40][5];
    s->K[3][5] = -whole[41][5];
    s->K[4][5] = -whole[42][5];
    s->K[5][5] = -whole[43][5];
    /* friction can be solved */
    if (!all_wheel_drive_require_definite(6, 0, &s->K[0][0])) {
        return all_wheel_drive_plant_friction_matrix;
    }
    return all_wheel_drive_plant_ok;
}

void all_wheel_drive_plant_measure(const all_wheel_drive_plant_state *s, const all_wheel_drive_plant_params *p, all_wheel_drive_plant_outputs *out)
{
    out->M1_speed = s->x[6];
    out->flange1_torque = -p->flange1_damping * s->x[11] + p->flange1_damping * s->x[6] + p->flange1_stiffness *
        s->x[16];
    out->flange2_torque = p->flange2_damping * s->x[12] - p->flange2_damping * s->x[7] - p->flange2_stiffness *
        s->x[21];
    out->M2_speed = s->x[7];
    out->flange3_torque = p->flange3_damping * s->x[13] - p->flange3_damping * s->x[8] - p->flange3_stiffness *
        s->x[23];
    out->M3_speed = s->x[8];
    out->flange4_torque = p->flange4_damping * s->x[14] - p->flange4_damping * s->x[9] - p->flange4_stiffness *
        s->x[25];
    out->M4_speed = s->x[9];
    out->flange5_torque = -p->flange5_damping * s->x[10] + p->flange5_damping * s->x[15] - p->flange5_stiffness *
        s->x[27];
    out->M5_speed = s->x[10];
    out->centre_input_torque = -p->cardan1_damping * s->x[0] + p->cardan1_damping * s->x[11] + p->cardan1_stiffness
        * s->x[17];
    out->front_input_torque = p->centre_pinion_ratio * p->front_cardan_damping * s->x[1] - p->front_cardan_damping *
        s->x[2] + p->front_cardan_damping * s->x[0] / p->centre_ratio + p->front_cardan_stiffness * s->x[18] /
        p->centre_ratio;
    out->rear_input_torque = -p->centre_pinion_ratio * p->rear_cardan_damping * s->x[1] - p->rear_cardan_damping *
        s->x[4] + p->rear_cardan_damping * s->x[0] / p->centre_ratio + p->rear_cardan_stiffness * s->x[19] /
        p->centre_ratio;
    out->M1_torque = s->x[28];
    out->M2_torque = s->x[29];
    out->M3_torque = s->x[30];
    out->M4_torque = s->x[31];
    out->M5_torque = s->x[32];
    out->centre_loss_speed = s->x[0];
    out->centre_loss_torque = out->centre_loss_speed * p->centre_loss_viscous + s->friction_torque[0];
    out->centre_limited_slip_speed = s->x[1];
    out->centre_limited_slip_torque = out->centre_limited_slip_speed * p->centre_limited_slip_viscous +
        s->friction_torque[1];
    out->front_loss_speed = s->x[2];
    out->front_loss_torque = s->friction_torque[2] + out->front_loss_speed * p->front_loss_viscous;
    out->front_limited_slip_speed = s->x[3];
    out->front_limited_slip_torque = s->friction_torque[3] + out->front_limited_slip_speed *
        p->front_limited_slip_viscous;
    out->rear_loss_speed = s->x[4];
    out->rear_loss_torque = s->friction_torque[4] + out->rear_loss_speed * p->rear_loss_viscous;
    out->rear_limited_slip_speed = s->x[5];
    out->rear_limited_slip_torque = s->friction_torque[5] + out->rear_limited_slip_speed *
        p->rear_limited_slip_viscous;
}

/* Status of the first input that is not finite or outside its range. */
static int check_inputs(const all_wheel_drive_plant_inputs *in)
{
    if (!all_wheel_drive_is_finite(in->M1_torque_ref)) {
        return (int)all_wheel_drive_plant_bad_input_M1_torque_ref;
    }
    if (!all_wheel_drive_is_finite(in->M2_torque_ref)) {
        return (int)all_wheel_drive_plant_bad_input_M2_torque_ref;
    }
    if (!all_wheel_drive_is_finite(in->M3_torque_ref)) {
        return (int)all_wheel_drive_plant_bad_input_M3_torque_ref;
    }
    if (!all_wheel_drive_is_finite(in->M4_torque_ref)) {
        return (int)all_wheel_drive_plant_bad_input_M4_torque_ref;
    }
    if (!all_wheel_drive_is_finite(in->M5_torque_ref)) {
        return (int)all_wheel_drive_plant_bad_input_M5_torque_ref;
    }
    return 0;
}

all_wheel_drive_plant_status all_wheel_drive_plant_step(all_wheel_drive_plant_state *s, const all_wheel_drive_plant_params *p,
    const all_wheel_drive_plant_inputs *in, all_wheel_drive_plant_outputs *out)
{
    const int bad = check_inputs(in);
    if (bad != 0) {
        all_wheel_drive_plant_measure(s, p, out);
        return (all_wheel_drive_plant_status)bad;
    }
    all_wheel_drive_real x_free[36];
    all_wheel_drive_real mean_torque[8];
    all_wheel_drive_real w_start[8];
    all_wheel_drive_real w_free[8];
    all_wheel_drive_real w_plus[8];
    all_wheel_drive_real slide[8];
    all_wheel_drive_real rest[8];
    all_wheel_drive_real friction_mean[8];
    all_wheel_drive_zero(sizeof x_free, x_free);
    all_wheel_drive_zero(sizeof mean_torque, mean_torque);
    all_wheel_drive_zero(sizeof w_start, w_start);
    all_wheel_drive_zero(sizeof w_free, w_free);
    all_wheel_drive_zero(sizeof w_plus, w_plus);
    all_wheel_drive_zero(sizeof slide, slide);
    all_wheel_drive_zero(sizeof rest, rest);
    all_wheel_drive_zero(sizeof friction_mean, friction_mean);
    
    /* torque-speed envelope, Figure 7.1 */
    const all_wheel_drive_real M1_available = p->M1_speed_rated * p->M1_torque_max /
        all_wheel_drive_max(p->M1_speed_rated, all_wheel_drive_abs(s->x[6]));
    const all_wheel_drive_real M1_limited = all_wheel_drive_max(-M1_available, all_wheel_drive_min(M1_available,
        in->M1_torque_ref));
    /* dead time of the torque loop */
    all_wheel_drive_delay(16, s->M1_delay, M1_limited, s->M1_dead_steps, &s->x[33], &s->x[38]);
    /* torque-speed envelope, Figure 7.1 */
    const all_wheel_drive_real M2_available = p->M2_speed_rated * p->M2_torque_max /
        all_wheel_drive_max(p->M2_speed_rated, all_wheel_drive_abs(s->x[7]));
    const all_wheel_drive_real M2_limited = all_wheel_drive_max(-M2_available, all_wheel_drive_min(M2_available,
        in->M2_torque_ref));
    /* dead time of the torque loop */
    all_wheel_drive_delay(16, s->M2_delay, M2_limited, s->M2_dead_steps, &s->x[34], &s->x[39]);
    /* torque-speed envelope, Figure 7.1 */
    const all_wheel_drive_real M3_available = p->M3_speed_rated * p->M3_torque_max /
        all_wheel_drive_max(p->M3_speed_rated, all_wheel_drive_abs(s->x[8]));
    const all_wheel_drive_real M3_limited = all_wheel_drive_max(-M3_available, all_wheel_drive_min(M3_available,
        in->M3_torque_ref));
    /* dead time of the torque loop */
    all_wheel_drive_delay(16, s->M3_delay, M3_limited, s->M3_dead_steps, &s->x[35], &s->x[40]);
    /* torque-speed envelope, Figure 7.1 */
    const all_wheel_drive_real M4_available = p->M4_speed_rated * p->M4_torque_max /
        all_wheel_drive_max(p->M4_speed_rated, all_wheel_drive_abs(s->x[9]));
    const all_wheel_drive_real M4_limited = all_wheel_drive_max(-M4_available, all_wheel_drive_min(M4_available,
        in->M4_torque_ref));
    /* dead time of the torque loop */
    all_wheel_drive_delay(16, s->M4_delay, M4_limited, s->M4_dead_steps, &s->x[36], &s->x[41]);
    /* torque-speed envelope, Figure 7.1 */
    const all_wheel_drive_real M5_available = p->M5_speed_rated * p->M5_torque_max /
        all_wheel_drive_max(p->M5_speed_rated, all_wheel_drive_abs(s->x[10]));
    const all_wheel_drive_real M5_limited = all_wheel_drive_max(-M5_available, all_wheel_drive_min(M5_available,
        in->M5_torque_ref));
    /* dead time of the torque loop */
    all_wheel_drive_delay(16, s->M5_delay, M5_limited, s->M5_dead_steps, &s->x[37], &s->x[42]);
    const all_wheel_drive_real centre_input_torque_start = -p->cardan1_damping * s->x[0] + p->cardan1_damping *
        s->x[11] + p->cardan1_stiffness * s->x[17];
    const all_wheel_drive_real front_input_torque_start = p->centre_pinion_ratio * p->front_cardan_damping * s->x[1]
        - p->front_cardan_damping * s->x[2] + p->front_cardan_damping * s->x[0] / p->centre_ratio +
        p->front_cardan_stiffness * s->x[18] / p->centre_ratio;
    const all_wheel_drive_real rear_input_torque_start = -p->centre_pinion_ratio * p->rear_cardan_damping * s->x[1]
        - p->rear_cardan_damping * s->x[4] + p->rear_cardan_damping * s->x[0] / p->centre_ratio +
        p->rear_cardan_stiffness * s->x[19] / p->centre_ratio;
    /* x+ = Phi x + Gamma_u u */
    all_wheel_drive_multiply(33, 43, &s->transition[0][0], s->x, x_free);
    /* w = G z */
    w_start[0] = s->x[0];
    w_start[1] = s->x[1];
    w_start[2] = s->x[2];
    w_start[3] = s->x[3];
    w_start[4] = s->x[4];
    w_start[5] = s->x[5];
    /* predicted */
    const all_wheel_drive_real centre_input_torque_end = -p->cardan1_damping * (s->friction_torque[0] *
        s->gamma[0][0] + s->friction_torque[1] * s->gamma[1][0] + s->friction_torque[2] * s->gamma[2][0] +
        s->friction_torque[3] * s->gamma[3][0] + s->friction_torque[4] * s->gamma[4][0] + s->friction_torque[5] *
        s->gamma[5][0] + x_free[0]) + p->cardan1_damping * (s->friction_torque[0] * s->gamma[0][11] +
        s->friction_torque[1] * s->gamma[1][11] + s->friction_torque[2] * s->gamma[2][11] + s->friction_torque[3] *
        s->gamma[3][11] + s->friction_torque[4] * s->gamma[4][11] + s->friction_torque[5] * s->gamma[5][11] +
        x_free[11]) + p->cardan1_stiffness * (s->friction_torque[0] * s->gamma[0][17] + s->friction_torque[1] *
        s->gamma[1][17] + s->friction_torque[2] * s->gamma[2][17] + s->friction_torque[3] * s->gamma[3][17] +
        s->friction_torque[4] * s->gamma[4][17] + s->friction_torque[5] * s->gamma[5][17] + x_free[17]);
    const all_wheel_drive_real front_input_torque_end = p->centre_pinion_ratio * p->front_cardan_damping *
        (s->friction_torque[0] * s->gamma[0][1] + s->friction_torque[1] * s->gamma[1][1] + s->friction_torque[2] *
        s->gamma[2][1] + s->friction_torque[3] * s->gamma[3][1] + s->friction_torque[4] * s->gamma[4][1] +
        s->friction_torque[5] * s->gamma[5][1] + x_free[1]) - p->front_cardan_damping * (s->friction_torque[0] *
        s->gamma[0][2] + s->friction_torque[1] * s->gamma[1][2] + s->friction_torque[2] * s->gamma[2][2] +
        s->friction_torque[3] * s->gamma[3][2] + s->friction_torque[4] * s->gamma[4][2] + s->friction_torque[5] *
        s->gamma[5][2] + x_free[2]) + p->front_cardan_damping * (s->friction_torque[0] * s->gamma[0][0] +
        s->friction_torque[1] * s->gamma[1][0] + s->friction_torque[2] * s->gamma[2][0] + s->friction_torque[3] *
        s->gamma[3][0] + s->friction_torque[4] * s->gamma[4][0] + s->friction_torque[5] * s->gamma[5][0] +
        x_free[0]) / p->centre_ratio + p->front_cardan_stiffness * (s->friction_torque[0] * s->gamma[0][18] +
        s->friction_torque[1] * s->gamma[1][18] + s->friction_torque[2] * s->gamma[2][18] + s->friction_torque[3] *
        s->gamma[3][18] + s->friction_torque[4] * s->gamma[4][18] + s->friction_torque[5] * s->gamma[5][18] +
        x_free[18]) / p->centre_ratio;
    const all_wheel_drive_real rear_input_torque_end = -p->centre_pinion_ratio * p->rear_cardan_damping *
        (s->friction_torque[0] * s->gamma[0][1] + s->friction_torque[1] * s->gamma[1][1] + s->friction_torque[2] *
        s->gamma[2][1] + s->friction_torque[3] * s->gamma[3][1] + s->friction_torque[4] * s->gamma[4][1] +
        s->friction_torque[5] * s->gamma[5][1] + x_free[1]) - p->rear_cardan_damping * (s->friction_torque[0] *
        s->gamma[0][4] + s->friction_torque[1] * s->gamma[1][4] + s->friction_torque[2] * s->gamma[2][4] +
        s->friction_torque[3] * s->gamma[3][4] + s->friction_torque[4] * s->gamma[4][4] + s->friction_torque[5] *
        s->gamma[5][4] + x_free[4]) + p->rear_cardan_damping * (s->friction_torque[0] * s->gamma[0][0] +
        s->friction_torque[1] * s->gamma[1][0] + s->friction_torque[2] * s->gamma[2][0] + s->friction_torque[3] *
        s->gamma[3][0] + s->friction_torque[4] * s->gamma[4][0] + s->friction_torque[5] * s->gamma[5][0] +
        x_free[0]) / p->centre_ratio + p->rear_cardan_stiffness * (s->friction_torque[0] * s->gamma[0][19] +
        s->friction_torque[1] * s->gamma[1][19] + s->friction_torque[2] * s->gamma[2][19] + s->friction_torque[3] *
        s->gamma[3][19] + s->friction_torque[4] * s->gamma[4][19] + s->friction_torque[5] * s->gamma[5][19] +
        x_free[19]) / p->centre_ratio;
    /* capacities at mid-step, (3.12), (3.34), (3.35) */
    slide[0] = p->centre_loss_coulomb + p->centre_loss_load * all_wheel_drive_abs((0.5) * centre_input_torque_end +
        (0.5) * centre_input_torque_start);
    rest[0] = p->centre_loss_coulomb + p->centre_loss_load * all_wheel_drive_abs((0.5) * centre_input_torque_end +
        (0.5) * centre_input_torque_start);
    slide[1] = p->centre_limited_slip_coulomb + p->centre_limited_slip_load * all_wheel_drive_abs((0.5) *
        centre_input_torque_end + (0.5) * centre_input_torque_start);
    rest[1] = p->centre_limited_slip_coulomb + p->centre_limited_slip_load * all_wheel_drive_abs((0.5) *
        centre_input_torque_end + (0.5) * centre_input_torque_start);
    slide[2] = p->front_loss_coulomb + p->front_loss_load * all_wheel_drive_abs((0.5) * front_input_torque_end +
        (0.5) * front_input_torque_start);
    rest[2] = p->front_loss_coulomb + p->front_loss_load * all_wheel_drive_abs((0.5) * front_input_torque_end +
        (0.5) * front_input_torque_start);
    slide[3] = p->front_limited_slip_coulomb + p->front_limited_slip_load * all_wheel_drive_abs((0.5) *
        front_input_torque_end + (0.5) * front_input_torque_start);
    rest[3] = p->front_limited_slip_coulomb + p->front_limited_slip_load * all_wheel_drive_abs((0.5) *
        front_input_torque_end + (0.5) * front_input_torque_start);
    slide[4] = p->rear_loss_coulomb + p->rear_loss_load * all_wheel_drive_abs((0.5) * rear_input_torque_end + (0.5)
        * rear_input_torque_start);
    rest[4] = p->rear_loss_coulomb + p->rear_loss_load * all_wheel_drive_abs((0.5) * rear_input_torque_end + (0.5) *
        rear_input_torque_start);
    slide[5] = p->rear_limited_slip_coulomb + p->rear_limited_slip_load * all_wheel_drive_abs((0.5) *
        rear_input_torque_end + (0.5) * rear_input_torque_start);
    rest[5] = p->rear_limited_slip_coulomb + p->rear_limited_slip_load * all_wheel_drive_abs((0.5) *
        rear_input_torque_end + (0.5) * rear_input_torque_start);
    /* w_free = G z_free */
    w_free[0] = x_free[0];
    w_free[1] = x_free[1];
    w_free[2] = x_free[2];
    w_free[3] = x_free[3];
    w_free[4] = x_free[4];
    w_free[5] = x_free[5];
    /* what sticks, slips and passes zero */
    all_wheel_drive_friction_step(0, 0, &s->K[0][0], w_start, w_free, slide, rest, s->friction_torque,
        s->friction_rest, friction_mean, w_plus, &s->friction_status);
    mean_torque[0] = friction_mean[0];
    mean_torque[1] = friction_mean[1];
    mean_torque[2] = friction_mean[2];
    mean_torque[3] = friction_mean[3];
    mean_torque[4] = friction_mean[4];
    mean_torque[5] = friction_mean[5];
    /* x+ = x_free + Gamma_f T */
    all_wheel_drive_add_product(33, 6, s->x, x_free, &s->gamma[0][0], mean_torque);
    /* exactly zero while it sticks */
    s->x[0] = all_wheel_drive_select(p->standstill_speed > all_wheel_drive_abs(w_plus[0]), 0.0, w_plus[0]);
    s->x[1] = all_wheel_drive_select(p->standstill_speed > all_wheel_drive_abs(w_plus[1]), 0.0, w_plus[1]);
    s->x[2] = all_wheel_drive_select(p->standstill_speed > all_wheel_drive_abs(w_plus[2]), 0.0, w_plus[2]);
    s->x[3] = all_wheel_drive_select(p->standstill_speed > all_wheel_drive_abs(w_plus[3]), 0.0, w_plus[3]);
    s->x[4] = all_wheel_drive_select(p->standstill_speed > all_wheel_drive_abs(w_plus[4]), 0.0, w_plus[4]);
    s->x[5] = all_wheel_drive_select(p->standstill_speed > all_wheel_drive_abs(w_plus[5]), 0.0, w_plus[5]);
    all_wheel_drive_plant_measure(s, p, out);
    if (s->friction_status == ALL_WHEEL_DRIVE_REAL(-1)) {
        return all_wheel_drive_plant_friction_unsolved;
    }
    if (s->friction_status == ALL_WHEEL_DRIVE_REAL(1)) {
        return all_wheel_drive_plant_bad_capacity_centre_loss;
    }
    if (s->friction_status == ALL_WHEEL_DRIVE_REAL(2)) {
        return all_wheel_drive_plant_bad_capacity_centre_limited_slip;
    }
    if (s->friction_status == ALL_WHEEL_DRIVE_REAL(3)) {
        return all_wheel_drive_plant_bad_capacity_front_loss;
    }
    if (s->friction_status == ALL_WHEEL_DRIVE_REAL(4)) {
        return all_wheel_drive_plant_bad_capacity_front_limited_slip;
    }
    if (s->friction_status == ALL_WHEEL_DRIVE_REAL(5)) {
        return all_wheel_drive_plant_bad_capacity_rear_loss;
    }
    if (s->friction_status == ALL_WHEEL_DRIVE_REAL(6)) {
        return all_wheel_drive_plant_bad_capacity_rear_limited_slip;
    }
    return all_wheel_drive_plant_ok;
}
