/*
 * differential_governed_run.c: controller and plant in closed loop
 *
 * Emitted by ptgen 0.1.0 from differential-governed.toml (SHA-256 acf552a043b195e0), template run.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "differential_governed_run.h"

#include <string.h>

typedef differential_governed_real real;

const char *const differential_governed_profile_names[differential_governed_profile_count] = {
    "diff_input_torque_ref",
    "M2_speed_ref",
    "M3_speed_ref",
};

const char *const differential_governed_signal_names[differential_governed_signal_count] = {
    "diff_input_torque_ref",
    "M2_speed_ref",
    "M3_speed_ref",
    "M1_speed",
    "flange1_torque",
    "flange2_torque",
    "M2_speed",
    "flange3_torque",
    "M3_speed",
    "diff_input_torque",
    "M1_torque",
    "M2_torque",
    "M3_torque",
    "diff_loss_torque",
    "diff_loss_speed",
    "diff_limited_slip_torque",
    "diff_limited_slip_speed",
    "M1_torque_ref",
    "M2_torque_ref",
    "M3_torque_ref",
    "diff_input_torque_ref_shaped",
    "M2_speed_ref_shaped",
    "M3_speed_ref_shaped",
    "governor_iterations",
    "governor_slack_M1",
    "governor_demand_M1",
    "governor_slack_M2",
    "governor_demand_M2",
    "governor_slack_M3",
    "governor_demand_M3",
    "governor_status",
    "fault",
};

size_t differential_governed_run_size(void) { return sizeof(differential_governed_run); }

int differential_governed_run_init(differential_governed_run *run)
{
    run->step = 0;
    memset(&run->driven, 0, sizeof run->driven);
    memset(&run->inputs, 0, sizeof run->inputs);
    for (int k = 0; k < differential_governed_profile_count; ++k) {
        run->cursor[k] = 0;
    }
    run->status = (int)differential_governed_controller_init(&run->controller, &run->controller_params);
    if (run->status == 0) {
        run->status = -(int)differential_governed_plant_init(&run->plant, &run->plant_params);
    }
    if (run->status == 0) {
        differential_governed_plant_measure(&run->plant, &run->plant_params, &run->measured);
    }
    return run->status;
}

/* Value of a profile; time never goes back, so the search starts where the last one ended. */
static double value_at(const differential_governed_profile *profile, long *cursor, double time)
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

static void record(const differential_governed_run *run, double *row)
{
    row[0] = (double)run->inputs.diff_input_torque_ref;
    row[1] = (double)run->inputs.M2_speed_ref;
    row[2] = (double)run->inputs.M3_speed_ref;
    row[3] = (double)run->measured.M1_speed;
    row[4] = (double)run->measured.flange1_torque;
    row[5] = (double)run->measured.flange2_torque;
    row[6] = (double)run->measured.M2_speed;
    row[7] = (double)run->measured.flange3_torque;
    row[8] = (double)run->measured.M3_speed;
    row[9] = (double)run->measured.diff_input_torque;
    row[10] = (double)run->measured.M1_torque;
    row[11] = (double)run->measured.M2_torque;
    row[12] = (double)run->measured.M3_torque;
    row[13] = (double)run->measured.diff_loss_torque;
    row[14] = (double)run->measured.diff_loss_speed;
    row[15] = (double)run->measured.diff_limited_slip_torque;
    row[16] = (double)run->measured.diff_limited_slip_speed;
    row[17] = (double)run->commands.M1_torque_ref;
    row[18] = (double)run->commands.M2_torque_ref;
    row[19] = (double)run->commands.M3_torque_ref;
    row[20] = (double)run->controller.diff_input_torque_ref_shaped;
    row[21] = (double)run->controller.M2_speed_ref_shaped;
    row[22] = (double)run->controller.M3_speed_ref_shaped;
    row[23] = (double)run->controller.governor_iterations;
    row[24] = (double)run->controller.governor_slack_M1;
    row[25] = (double)run->controller.governor_demand_M1;
    row[26] = (double)run->controller.governor_slack_M2;
    row[27] = (double)run->controller.governor_demand_M2;
    row[28] = (double)run->controller.governor_slack_M3;
    row[29] = (double)run->controller.governor_demand_M3;
    row[30] = (double)run->controller.governor_status;
    row[31] = (double)run->controller.fault;
}

long differential_governed_run_steps(differential_governed_run *run, const differential_governed_profile *profiles, long steps, long record_every, double *recording,
    long rows, long report_every, differential_governed_report report, void *user)
{
    long row = 0;
    long until_record = run->step % record_every == 0 ? 0 : record_every - run->step % record_every;
    long until_report = report_every;
    for (long done = 0; done < steps; ++done) {
        const double time = (double)run->step * (double)run->plant_params.sample_time;
        run->inputs.diff_input_torque_ref = (real)value_at(&profiles[0], &run->cursor[0], time);
        run->inputs.M2_speed_ref = (real)value_at(&profiles[1], &run->cursor[1], time);
        run->inputs.M3_speed_ref = (real)value_at(&profiles[2], &run->cursor[2], time);
        run->inputs.M1_speed = run->measured.M1_speed;
        run->inputs.flange1_torque = run->measured.flange1_torque;
        run->inputs.flange2_torque = run->measured.flange2_torque;
        run->inputs.M2_speed = run->measured.M2_speed;
        run->inputs.flange3_torque = run->measured.flange3_torque;
        run->inputs.M3_speed = run->measured.M3_speed;
        const int controller = (int)differential_governed_controller_step(&run->controller, &run->controller_params, &run->inputs, &run->commands);
        if (until_record == 0) {
            if (row < rows) {
                record(run, recording + row * differential_governed_signal_count);
                ++row;
            }
            until_record = record_every;
        }
        --until_record;
        run->driven.M1_torque_ref = run->commands.M1_torque_ref;
        run->driven.M2_torque_ref = run->commands.M2_torque_ref;
        run->driven.M3_torque_ref = run->commands.M3_torque_ref;
        const int plant = (int)differential_governed_plant_step(&run->plant, &run->plant_params, &run->driven, &run->measured);
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
