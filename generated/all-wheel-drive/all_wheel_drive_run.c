/*
 * all_wheel_drive_run.c: controller and plant in closed loop
 *
 * Emitted by ptgen 0.1.0 from all-wheel-drive.toml (SHA-256 4a4f0cf573c3f3c3), template run.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "all_wheel_drive_run.h"

#include <string.h>

typedef all_wheel_drive_real real;

const char *const all_wheel_drive_profile_names[all_wheel_drive_profile_count] = {
    "centre_input_torque_ref",
    "M2_speed_ref",
    "M3_speed_ref",
    "M4_speed_ref",
    "M5_speed_ref",
};

const char *const all_wheel_drive_signal_names[all_wheel_drive_signal_count] = {
    "centre_input_torque_ref",
    "M2_speed_ref",
    "M3_speed_ref",
    "M4_speed_ref",
    "M5_speed_ref",
    "M1_speed",
    "flange1_torque",
    "flange2_torque",
    "M2_speed",
    "flange3_torque",
    "M3_speed",
    "flange4_torque",
    "M4_speed",
    "flange5_torque",
    "M5_speed",
    "centre_input_torque",
    "front_input_torque",
    "rear_input_torque",
    "M1_torque",
    "M2_torque",
    "M3_torque",
    "M4_torque",
    "M5_torque",
    "centre_loss_torque",
    "centre_loss_speed",
    "centre_limited_slip_torque",
    "centre_limited_slip_speed",
    "front_loss_torque",
    "front_loss_speed",
    "front_limited_slip_torque",
    "front_limited_slip_speed",
    "rear_loss_torque",
    "rear_loss_speed",
    "rear_limited_slip_torque",
    "rear_limited_slip_speed",
    "M1_torque_ref",
    "M2_torque_ref",
    "M3_torque_ref",
    "M4_torque_ref",
    "M5_torque_ref",
    "fault",
};

size_t all_wheel_drive_run_size(void) { return sizeof(all_wheel_drive_run); }

int all_wheel_drive_run_init(all_wheel_drive_run *run)
{
    run->step = 0;
    memset(&run->driven, 0, sizeof run->driven);
    memset(&run->inputs, 0, sizeof run->inputs);
    for (int k = 0; k < all_wheel_drive_profile_count; ++k) {
        run->cursor[k] = 0;
    }
    run->status = (int)all_wheel_drive_controller_init(&run->controller, &run->controller_params);
    if (run->status == 0) {
        run->status = -(int)all_wheel_drive_plant_init(&run->plant, &run->plant_params);
    }
    if (run->status == 0) {
        all_wheel_drive_plant_measure(&run->plant, &run->plant_params, &run->measured);
    }
    return run->status;
}

/* Value of a profile; time never goes back, so the search starts where the last one ended. */
static double value_at(const all_wheel_drive_profile *profile, long *cursor, double time)
{
    long k = *cursor;
    while (k + 1 < profile->count && profile->time[k + 1] <= time) {
        ++k;
    }
    *cursor = k;
    if (profile->steps || k + 1 >= profile->count || time <= profile->time[k]) {
        return profile->value[k];
    }
    const double share = (time - profile->time[k]) / (profile->time[k + 1] - profile->time[k]);
    return profile->value[k] + share * (profile->value[k + 1] - profile->value[k]);
}

static void record(const all_wheel_drive_run *run, double *row)
{
    row[0] = (double)run->inputs.centre_input_torque_ref;
    row[1] = (double)run->inputs.M2_speed_ref;
    row[2] = (double)run->inputs.M3_speed_ref;
    row[3] = (double)run->inputs.M4_speed_ref;
    row[4] = (double)run->inputs.M5_speed_ref;
    row[5] = (double)run->measured.M1_speed;
    row[6] = (double)run->measured.flange1_torque;
    row[7] = (double)run->measured.flange2_torque;
    row[8] = (double)run->measured.M2_speed;
    row[9] = (double)run->measured.flange3_torque;
    row[10] = (double)run->measured.M3_speed;
    row[11] = (double)run->measured.flange4_torque;
    row[12] = (double)run->measured.M4_speed;
    row[13] = (double)run->measured.flange5_torque;
    row[14] = (double)run->measured.M5_speed;
    row[15] = (double)run->measured.centre_input_torque;
    row[16] = (double)run->measured.front_input_torque;
    row[17] = (double)run->measured.rear_input_torque;
    row[18] = (double)run->measured.M1_torque;
    row[19] = (double)run->measured.M2_torque;
    row[20] = (double)run->measured.M3_torque;
    row[21] = (double)run->measured.M4_torque;
    row[22] = (double)run->measured.M5_torque;
    row[23] = (double)run->measured.centre_loss_torque;
    row[24] = (double)run->measured.centre_loss_speed;
    row[25] = (double)run->measured.centre_limited_slip_torque;
    row[26] = (double)run->measured.centre_limited_slip_speed;
    row[27] = (double)run->measured.front_loss_torque;
    row[28] = (double)run->measured.front_loss_speed;
    row[29] = (double)run->measured.front_limited_slip_torque;
    row[30] = (double)run->measured.front_limited_slip_speed;
    row[31] = (double)run->measured.rear_loss_torque;
    row[32] = (double)run->measured.rear_loss_speed;
    row[33] = (double)run->measured.rear_limited_slip_torque;
    row[34] = (double)run->measured.rear_limited_slip_speed;
    row[35] = (double)run->commands.M1_torque_ref;
    row[36] = (double)run->commands.M2_torque_ref;
    row[37] = (double)run->commands.M3_torque_ref;
    row[38] = (double)run->commands.M4_torque_ref;
    row[39] = (double)run->commands.M5_torque_ref;
    row[40] = (double)run->controller.fault;
}

long all_wheel_drive_run_steps(all_wheel_drive_run *run, const all_wheel_drive_profile *profiles, long steps, long record_every, double *recording,
    long rows, long report_every, all_wheel_drive_report report, void *user)
{
    long row = 0;
    long until_record = run->step % record_every == 0 ? 0 : record_every - run->step % record_every;
    long until_report = report_every;
    for (long done = 0; done < steps; ++done) {
        const double time = (double)run->step * (double)run->plant_params.sample_time;
        run->inputs.centre_input_torque_ref = (real)value_at(&profiles[0], &run->cursor[0], time);
        run->inputs.M2_speed_ref = (real)value_at(&profiles[1], &run->cursor[1], time);
        run->inputs.M3_speed_ref = (real)value_at(&profiles[2], &run->cursor[2], time);
        run->inputs.M4_speed_ref = (real)value_at(&profiles[3], &run->cursor[3], time);
        run->inputs.M5_speed_ref = (real)value_at(&profiles[4], &run->cursor[4], time);
        run->inputs.M1_speed = run->measured.M1_speed;
        run->inputs.flange1_torque = run->measured.flange1_torque;
        run->inputs.flange2_torque = run->measured.flange2_torque;
        run->inputs.M2_speed = run->measured.M2_speed;
        run->inputs.flange3_torque = run->measured.flange3_torque;
        run->inputs.M3_speed = run->measured.M3_speed;
        run->inputs.flange4_torque = run->measured.flange4_torque;
        run->inputs.M4_speed = run->measured.M4_speed;
        run->inputs.flange5_torque = run->measured.flange5_torque;
        run->inputs.M5_speed = run->measured.M5_speed;
        const int controller = (int)all_wheel_drive_controller_step(&run->controller, &run->controller_params, &run->inputs, &run->commands);
        if (until_record == 0) {
            if (row < rows) {
                record(run, recording + row * all_wheel_drive_signal_count);
                ++row;
            }
            until_record = record_every;
        }
        --until_record;
        run->driven.M1_torque_ref = run->commands.M1_torque_ref;
        run->driven.M2_torque_ref = run->commands.M2_torque_ref;
        run->driven.M3_torque_ref = run->commands.M3_torque_ref;
        run->driven.M4_torque_ref = run->commands.M4_torque_ref;
        run->driven.M5_torque_ref = run->commands.M5_torque_ref;
        const int plant = (int)all_wheel_drive_plant_step(&run->plant, &run->plant_params, &run->driven, &run->measured);
        if (run->status == 0) {
            run->status = controller != 0 ? controller : -plant;
        }
        ++run->step;
        if (--until_report == 0) {
            until_report = report_every;
            if (report && report(run->step, user)) {
                return done + 1;
            }
        }
    }
    return steps;
}
