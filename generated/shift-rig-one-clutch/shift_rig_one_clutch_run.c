/*
 * shift_rig_one_clutch_run.c: controller and plant in closed loop
 *
 * Emitted by ptgen 0.1.0 from shift-rig-one-clutch.toml (SHA-256 78ebad094db7f87a), template run.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "shift_rig_one_clutch_run.h"

#include <string.h>

typedef shift_rig_one_clutch_real real;

const char *const shift_rig_one_clutch_profile_names[shift_rig_one_clutch_profile_count] = {
    "flange1_torque_ref",
    "M2_speed_ref",
    "gears_clutch_actuation",
    "gears_ratio",
};

const char *const shift_rig_one_clutch_signal_names[shift_rig_one_clutch_signal_count] = {
    "flange1_torque_ref",
    "M2_speed_ref",
    "gears_clutch_actuation",
    "gears_ratio",
    "M1_speed",
    "flange1_torque",
    "flange2_torque",
    "M2_speed",
    "M1_torque",
    "M2_torque",
    "gears_clutch_torque",
    "gears_clutch_speed",
    "M1_torque_ref",
    "M2_torque_ref",
    "gears_ratio_limited",
    "fault",
};

size_t shift_rig_one_clutch_run_size(void) { return sizeof(shift_rig_one_clutch_run); }

int shift_rig_one_clutch_run_init(shift_rig_one_clutch_run *run)
{
    run->step = 0;
    memset(&run->driven, 0, sizeof run->driven);
    memset(&run->inputs, 0, sizeof run->inputs);
    for (int k = 0; k < shift_rig_one_clutch_profile_count; ++k) {
        run->cursor[k] = 0;
    }
    run->status = (int)shift_rig_one_clutch_controller_init(&run->controller, &run->controller_params);
    if (run->status == 0) {
        run->status = -(int)shift_rig_one_clutch_plant_init(&run->plant, &run->plant_params);
    }
    if (run->status == 0) {
        shift_rig_one_clutch_plant_measure(&run->plant, &run->plant_params, &run->measured);
    }
    return run->status;
}

/* Value of a profile; time never goes back, so the search starts where the last one ended. */
static double value_at(const shift_rig_one_clutch_profile *profile, long *cursor, double time)
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

static void record(const shift_rig_one_clutch_run *run, double *row)
{
    row[0] = (double)run->inputs.flange1_torque_ref;
    row[1] = (double)run->inputs.M2_speed_ref;
    row[2] = (double)run->driven.gears_clutch_actuation;
    row[3] = (double)run->driven.gears_ratio;
    row[4] = (double)run->measured.M1_speed;
    row[5] = (double)run->measured.flange1_torque;
    row[6] = (double)run->measured.flange2_torque;
    row[7] = (double)run->measured.M2_speed;
    row[8] = (double)run->measured.M1_torque;
    row[9] = (double)run->measured.M2_torque;
    row[10] = (double)run->measured.gears_clutch_torque;
    row[11] = (double)run->measured.gears_clutch_speed;
    row[12] = (double)run->commands.M1_torque_ref;
    row[13] = (double)run->commands.M2_torque_ref;
    row[14] = (double)run->controller.gears_ratio_limited;
    row[15] = (double)run->controller.fault;
}

long shift_rig_one_clutch_run_steps(shift_rig_one_clutch_run *run, const shift_rig_one_clutch_profile *profiles, long steps, long record_every, double *recording,
    long rows, long report_every, shift_rig_one_clutch_report report, void *user)
{
    long row = 0;
    long until_record = run->step % record_every == 0 ? 0 : record_every - run->step % record_every;
    long until_report = report_every;
    for (long done = 0; done < steps; ++done) {
        const double time = (double)run->step * (double)run->plant_params.sample_time;
        run->inputs.flange1_torque_ref = (real)value_at(&profiles[0], &run->cursor[0], time);
        run->inputs.M2_speed_ref = (real)value_at(&profiles[1], &run->cursor[1], time);
        run->inputs.gears_ratio = (real)value_at(&profiles[3], &run->cursor[3], time);
        const double middle = time + 0.5 * (double)run->plant_params.sample_time;
        run->driven.gears_clutch_actuation = (real)value_at(&profiles[2], &run->cursor[2], middle);
        run->driven.gears_ratio = (real)value_at(&profiles[3], &run->cursor[3], middle);
        run->inputs.M1_speed = run->measured.M1_speed;
        run->inputs.flange1_torque = run->measured.flange1_torque;
        run->inputs.flange2_torque = run->measured.flange2_torque;
        run->inputs.M2_speed = run->measured.M2_speed;
        const int controller = (int)shift_rig_one_clutch_controller_step(&run->controller, &run->controller_params, &run->inputs, &run->commands);
        if (until_record == 0) {
            if (row < rows) {
                record(run, recording + row * shift_rig_one_clutch_signal_count);
                ++row;
            }
            until_record = record_every;
        }
        --until_record;
        run->driven.M1_torque_ref = run->commands.M1_torque_ref;
        run->driven.M2_torque_ref = run->commands.M2_torque_ref;
        const int plant = (int)shift_rig_one_clutch_plant_step(&run->plant, &run->plant_params, &run->driven, &run->measured);
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
