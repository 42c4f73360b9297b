/*
 * centre_differential_run.h: controller and plant in closed loop
 *
 * Emitted by ptgen 0.1.0 from centre-differential.toml (SHA-256 11edcc3b908b78c3), template run.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef CENTRE_DIFFERENTIAL_RUN_H
#define CENTRE_DIFFERENTIAL_RUN_H

#include "centre_differential_controller.h"
#include "centre_differential_plant.h"

enum { centre_differential_profile_count = 3 };
enum { centre_differential_signal_count = 21 };

/* Names of the references, and of the recorded signals, in their order. */
extern const char *const centre_differential_profile_names[centre_differential_profile_count];
extern const char *const centre_differential_signal_names[centre_differential_signal_count];

/* A reference over time: straight lines between points, or steps; constant before and after. SI units. */
typedef struct {
    long count;
    int steps;
    const double *time;
    const double *value;
} centre_differential_profile;

/* Everything that a closed loop consists of. */
typedef struct {
    centre_differential_controller_params controller_params;
    centre_differential_plant_params plant_params;
    centre_differential_controller_state controller;
    centre_differential_plant_state plant;
    centre_differential_controller_inputs inputs;
    centre_differential_controller_outputs commands;
    centre_differential_plant_inputs driven;
    centre_differential_plant_outputs measured;
    long cursor[centre_differential_profile_count];
    long step;
    int status; /* first status of controller or plant that was not ok; plant statuses are negative */
} centre_differential_run;

/* Called every `report_every` steps; a value other than 0 stops the run. */
typedef int (*centre_differential_report)(long step, void *user);

size_t centre_differential_run_size(void);

/* Initialises controller and plant from the parameters in `run`; returns its status. */
int centre_differential_run_init(centre_differential_run *run);

/*
 * Runs `steps` steps. Every `record_every` steps one row of centre_differential_signal_count numbers goes to `recording`, which
 * has room for `rows`. Returns the number of steps done.
 */
long centre_differential_run_steps(centre_differential_run *run, const centre_differential_profile *profiles, long steps, long record_every, double *recording,
    long rows, long report_every, centre_differential_report report, void *user);

#endif
