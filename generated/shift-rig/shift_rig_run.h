/*
 * shift_rig_run.h: controller and plant in closed loop
 *
 * Emitted by ptgen 0.1.0 from shift-rig.toml (SHA-256 627f699c509849a3), template run.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef SHIFT_RIG_RUN_H
#define SHIFT_RIG_RUN_H

#include "shift_rig_controller.h"
#include "shift_rig_plant.h"

enum { shift_rig_profile_count = 9 };
enum { shift_rig_signal_count = 31 };

/* Names of the references, then the actuations, then the ratios that change, and of the recorded signals, in their order. */
extern const char *const shift_rig_profile_names[shift_rig_profile_count];
extern const char *const shift_rig_signal_names[shift_rig_signal_count];

/*
 * A reference, an actuation or a ratio over time: straight lines between points, or steps; constant before and after.
 * SI units. The controller takes them at the start of a step, the plant, where they act over the whole step, in its middle.
 */
typedef struct {
    long count;
    int steps;
    const double *time;
    const double *value;
} shift_rig_profile;

/* Everything that a closed loop consists of. */
typedef struct {
    shift_rig_controller_params controller_params;
    shift_rig_plant_params plant_params;
    shift_rig_controller_state controller;
    shift_rig_plant_state plant;
    shift_rig_controller_inputs inputs;
    shift_rig_controller_outputs commands;
    shift_rig_plant_inputs driven;
    shift_rig_plant_outputs measured;
    long cursor[shift_rig_profile_count];
    long step;
    int status; /* first status of controller or plant that was not ok; plant statuses are negative */
} shift_rig_run;

/* Called every `report_every` steps; a value other than 0 stops the run. */
typedef int (*shift_rig_report)(long step, void *user);

size_t shift_rig_run_size(void);

/* Initialises controller and plant from the parameters in `run`; returns its status. */
int shift_rig_run_init(shift_rig_run *run);

/*
 * Runs `steps` steps. Every `record_every` steps one row of shift_rig_signal_count numbers goes to `recording`, which
 * has room for `rows`. Returns the number of steps done.
 */
long shift_rig_run_steps(shift_rig_run *run, const shift_rig_profile *profiles, long steps, long record_every, double *recording,
    long rows, long report_every, shift_rig_report report, void *user);

#endif
