/*
 * clutch_rig_run.h: controller and plant in closed loop
 *
 * Emitted by ptgen 0.1.0 from clutch-rig.toml (SHA-256 8a8f57b91ebde405), template run.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef CLUTCH_RIG_RUN_H
#define CLUTCH_RIG_RUN_H

#include "clutch_rig_controller.h"
#include "clutch_rig_plant.h"

enum { clutch_rig_profile_count = 4 };
enum { clutch_rig_signal_count = 17 };

/* Names of the references and then the actuations, and of the recorded signals, in their order. */
extern const char *const clutch_rig_profile_names[clutch_rig_profile_count];
extern const char *const clutch_rig_signal_names[clutch_rig_signal_count];

/*
 * A reference or an actuation over time: straight lines between points, or steps; constant before and after. SI units.
 * A reference is taken at the start of a step, an actuation, which acts over the whole step, in its middle.
 */
typedef struct {
    long count;
    int steps;
    const double *time;
    const double *value;
} clutch_rig_profile;

/* Everything that a closed loop consists of. */
typedef struct {
    clutch_rig_controller_params controller_params;
    clutch_rig_plant_params plant_params;
    clutch_rig_controller_state controller;
    clutch_rig_plant_state plant;
    clutch_rig_controller_inputs inputs;
    clutch_rig_controller_outputs commands;
    clutch_rig_plant_inputs driven;
    clutch_rig_plant_outputs measured;
    long cursor[clutch_rig_profile_count];
    long step;
    int status; /* first status of controller or plant that was not ok; plant statuses are negative */
} clutch_rig_run;

/* Called every `report_every` steps; a value other than 0 stops the run. */
typedef int (*clutch_rig_report)(long step, void *user);

size_t clutch_rig_run_size(void);

/* Initialises controller and plant from the parameters in `run`; returns its status. */
int clutch_rig_run_init(clutch_rig_run *run);

/*
 * Runs `steps` steps. Every `record_every` steps one row of clutch_rig_signal_count numbers goes to `recording`, which
 * has room for `rows`. Returns the number of steps done.
 */
long clutch_rig_run_steps(clutch_rig_run *run, const clutch_rig_profile *profiles, long steps, long record_every, double *recording,
    long rows, long report_every, clutch_rig_report report, void *user);

#endif
