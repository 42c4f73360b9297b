/*
 * shift_rig_two_clutches_run.h: controller and plant in closed loop
 *
 * Emitted by ptgen 0.1.0 from shift-rig-two-clutches.toml (SHA-256 dd9752ce0776f1aa), template run.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef SHIFT_RIG_TWO_CLUTCHES_RUN_H
#define SHIFT_RIG_TWO_CLUTCHES_RUN_H

#include "shift_rig_two_clutches_controller.h"
#include "shift_rig_two_clutches_plant.h"

enum { shift_rig_two_clutches_profile_count = 7 };
enum { shift_rig_two_clutches_signal_count = 21 };

/* Names of the references, then the actuations, then the ratios that change, and of the recorded signals, in their order. */
extern const char *const shift_rig_two_clutches_profile_names[shift_rig_two_clutches_profile_count];
extern const char *const shift_rig_two_clutches_signal_names[shift_rig_two_clutches_signal_count];

/*
 * A reference, an actuation or a ratio over time: straight lines between points, or steps; constant before and after.
 * SI units. The controller takes them at the start of a step, the plant, where they act over the whole step, in its middle.
 */
typedef struct {
    long count;
    int steps;
    const double *time;
    const double *value;
} shift_rig_two_clutches_profile;

/* Everything that a closed loop consists of. */
typedef struct {
    shift_rig_two_clutches_controller_params controller_params;
    shift_rig_two_clutches_plant_params plant_params;
    shift_rig_two_clutches_controller_state controller;
    shift_rig_two_clutches_plant_state plant;
    shift_rig_two_clutches_controller_inputs inputs;
    shift_rig_two_clutches_controller_outputs commands;
    shift_rig_two_clutches_plant_inputs driven;
    shift_rig_two_clutches_plant_outputs measured;
    long cursor[shift_rig_two_clutches_profile_count];
    long step;
    int status; /* first status of controller or plant that was not ok; plant statuses are negative */
} shift_rig_two_clutches_run;

/* Called every `report_every` steps; a value other than 0 stops the run. */
typedef int (*shift_rig_two_clutches_report)(long step, void *user);

size_t shift_rig_two_clutches_run_size(void);

/* Initialises controller and plant from the parameters in `run`; returns its status. */
int shift_rig_two_clutches_run_init(shift_rig_two_clutches_run *run);

/*
 * Runs `steps` steps. Every `record_every` steps one row of shift_rig_two_clutches_signal_count numbers goes to `recording`, which
 * has room for `rows`. Returns the number of steps done.
 */
long shift_rig_two_clutches_run_steps(shift_rig_two_clutches_run *run, const shift_rig_two_clutches_profile *profiles, long steps, long record_every, double *recording,
    long rows, long report_every, shift_rig_two_clutches_report report, void *user);

#endif
