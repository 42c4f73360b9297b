/*
 * transmission_nine_speed_run.c: controller and plant in closed loop
 *
 * Emitted by ptgen 0.1.0 from transmission-nine-speed.toml (SHA-256 65236af78ec41a0c), template run.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "transmission_nine_speed_run.h"

#include <string.h>

typedef transmission_nine_speed_real real;

const char *const transmission_nine_speed_profile_names[transmission_nine_speed_profile_count] = {
    "gears_input_torque_ref",
    "M2_speed_ref",
    "converter_lockup_actuation",
    "gears_A_actuation",
    "gears_B_actuation",
    "gears_C_actuation",
    "gears_D_actuation",
    "gears_E_actuation",
    "gears_F_actuation",
    "gears_ratio",
};

const char *const transmission_nine_speed_signal_names[transmission_nine_speed_signal_count] = {
    "gears_input_torque_ref",
    "M2_speed_ref",
    "converter_lockup_actuation",
    "gears_A_actuation",
    "gears_B_actuation",
    "gears_C_actuation",
    "gears_D_actuation",
    "gears_E_actuation",
    "gears_F_actuation",
    "gears_ratio",
    "M1_speed",
    "flange1_torque",
    "flange2_torque",
    "M2_speed",
    "gears_input_torque",
    "M1_torque",
    "M2_torque",
    "converter_lockup_torque",
    "converter_lockup_speed",
    "gears_A_torque",
    "gears_A_speed",
    "gears_B_torque",
    "gears_B_speed",
    "gears_C_torque",
    "gears_C_speed",
    "gears_D_torque",
    "gears_D_speed",
    "gears_E_torque",
    "gears_E_speed",
    "gears_F_torque",
    "gears_F_speed",
    "converter_fluid_pump_torque",
    "converter_fluid_turbine_torque",
    "M1_torque_ref",
    "M2_torque_ref",
    "gears_ratio_limited",
    "fault",
};

size_t transmission_nine_speed_run_size(void) { return sizeof(transmission_nine_speed_run); }

int transmission_nine_speed_run_init(transmission_nine_speed_run *run)
{
    run->step = 0;
    memset(&run->driven, 0, sizeof run->driven);
    memset(&run->inputs, 0, sizeof run->inputs);
    for (int k = 0; k < transmission_nine_speed_profile_count; ++k) {
        run->cursor[k] = 0;
    }
    run->status = (int)transmission_nine_speed_controller_init(&run->controller, &run->controller_params);
    if (run->status == 0) {
        run->status = -(int)transmission_nine_speed_plant_init(&run->plant, &run->plant_params);
    }
    if (run->status == 0) {
        transmission_nine_speed_plant_measure(&run->plant, &run->plant_params, &run->measured);
    }
    return run->status;
}

/* Value of a profile; time never goes back, so the search starts where the last one ended. */
static double value_at(const transmission_nine_speed_profile *profile, long *cursor, double time)
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

static void record(const transmission_nine_speed_run *run, double *row)
{
    row[0] = (double)run->inputs.gears_input_torque_ref;
    row[1] = (double)run->inputs.M2_speed_ref;
    row[2] = (double)run->driven.converter_lockup_actuation;
    row[3] = (double)run->driven.gears_A_actuation;
    row[4] = (double)run->driven.gears_B_actuation;
    row[5] = (double)run->driven.gears_C_actuation;
    row[6] = (double)run->driven.gears_D_actuation;
    row[7] = (double)run->driven.gears_E_actuation;
    row[8] = (double)run->driven.gears_F_actuation;
    row[9] = (double)run->inputs.gears_ratio;
    row[10] = (double)run->measured.M1_speed;
    row[11] = (double)run->measured.flange1_torque;
    row[12] = (double)run->measured.flange2_torque;
    row[13] = (double)run->measured.M2_speed;
    row[14] = (double)run->measured.gears_input_torque;
    row[15] = (double)run->measured.M1_torque;
    row[16] = (double)run->measured.M2_torque;
    row[17] = (double)run->measured.converter_lockup_torque;
    row[18] = (double)run->measured.converter_lockup_speed;
    row[19] = (double)run->measured.gears_A_torque;
    row[20] = (double)run->measured.gears_A_speed;
    row[21] = (double)run->measured.gears_B_torque;
    row[22] = (double)run->measured.gears_B_speed;
    row[23] = (double)run->measured.gears_C_torque;
    row[24] = (double)run->measured.gears_C_speed;
    row[25] = (double)run->measured.gears_D_torque;
    row[26] = (double)run->measured.gears_D_speed;
    row[27] = (double)run->measured.gears_E_torque;
    row[28] = (double)run->measured.gears_E_speed;
    row[29] = (double)run->measured.gears_F_torque;
    row[30] = (double)run->measured.gears_F_speed;
    row[31] = (double)run->measured.converter_fluid_pump_torque;
    row[32] = (double)run->measured.converter_fluid_turbine_torque;
    row[33] = (double)run->commands.M1_torque_ref;
    row[34] = (double)run->commands.M2_torque_ref;
    row[35] = (double)run->controller.gears_ratio_limited;
    row[36] = (double)run->controller.fault;
}

long transmission_nine_speed_run_steps(transmission_nine_speed_run *run, const transmission_nine_speed_profile *profiles, long steps, long record_every, double *recording,
    long rows, long report_every, transmission_nine_speed_report report, void *user)
{
    long row = 0;
    long until_record = run->step % record_every == 0 ? 0 : record_every - run->step % record_every;
    long until_report = report_every;
    for (long done = 0; done < steps; ++done) {
        const double time = (double)run->step * (double)run->plant_params.sample_time;
        run->inputs.gears_input_torque_ref = (real)value_at(&profiles[0], &run->cursor[0], time);
        run->inputs.M2_speed_ref = (real)value_at(&profiles[1], &run->cursor[1], time);
        run->inputs.gears_ratio = (real)value_at(&profiles[9], &run->cursor[9], time);
        const double middle = time + 0.5 * (double)run->plant_params.sample_time;
        run->driven.converter_lockup_actuation = (real)value_at(&profiles[2], &run->cursor[2], middle);
        run->driven.gears_A_actuation = (real)value_at(&profiles[3], &run->cursor[3], middle);
        run->driven.gears_B_actuation = (real)value_at(&profiles[4], &run->cursor[4], middle);
        run->driven.gears_C_actuation = (real)value_at(&profiles[5], &run->cursor[5], middle);
        run->driven.gears_D_actuation = (real)value_at(&profiles[6], &run->cursor[6], middle);
        run->driven.gears_E_actuation = (real)value_at(&profiles[7], &run->cursor[7], middle);
        run->driven.gears_F_actuation = (real)value_at(&profiles[8], &run->cursor[8], middle);
        run->inputs.M1_speed = run->measured.M1_speed;
        run->inputs.flange1_torque = run->measured.flange1_torque;
        run->inputs.flange2_torque = run->measured.flange2_torque;
        run->inputs.M2_speed = run->measured.M2_speed;
        const int controller = (int)transmission_nine_speed_controller_step(&run->controller, &run->controller_params, &run->inputs, &run->commands);
        if (until_record == 0) {
            if (row < rows) {
                record(run, recording + row * transmission_nine_speed_signal_count);
                ++row;
            }
            until_record = record_every;
        }
        --until_record;
        run->driven.M1_torque_ref = run->commands.M1_torque_ref;
        run->driven.M2_torque_ref = run->commands.M2_torque_ref;
        const int plant = (int)transmission_nine_speed_plant_step(&run->plant, &run->plant_params, &run->driven, &run->measured);
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
