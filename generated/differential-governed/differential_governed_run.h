/*
 * differential_governed_run.h: controller and plant in closed loop
 *
 * Emitted by ptgen 0.1.0 from differential-governed.toml (SHA-256 acf552a043b195e0), template run.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef DIFFERENTIAL_GOVERNED_RUN_H
#define DIFFERENTIAL_GOVERNED_RUN_H

#include "differential_governed_controller.h"
#include "differential_governed_plant.h"

enum { differential_governed_profile_count = 3 };
enum { differential_governed_signal_count = 32 };

/* Names of the references, and of the recorded signals, in their order. */
extern const char *const differential_governed_profile_names[differential_governed_profile_count];
extern const char *const differential_governed_signal_names[differential_governed_signal_count];

/* A reference over time: straight lines between points, or steps; constant before and after. SI units. */
typedef struct {
    long count;
    int steps;
    const double *time;
    const double *value;
} differential_governed_profile;

/* Everything that a closed loop consists of. */
typedef struct {
    differential_governed_controller_params controller_params;
    differential_governed_plant_params plant_params;
    differential_governed_controller_state controller;
    differential_governed_plant_state plant;
    differential_governed_controller_inputs inputs;
    differential_governed_controller_outputs commands;
    differential_governed_plant_inputs driven;
    differential_governed_plant_outputs measured;
    long cursor[differential_governed_profile_count];
    long step;
    int status; /* first status of controller or plant that was not ok; plant statuses are negative */
} differential_governed_run;

/* Called every `report_every` steps; a value other than 0 stops the run. */
typedef int (*differential_governed_report)(long step, void *user);

size_t differential_governed_run_size(void);

/* Initialises controller and plant from the parameters in `run`; returns its status. */
int differential_governed_run_init(differential_governed_run *run);

/*
 * Runs `steps` steps. Every `record_every` steps one row of differential_governed_signal_count numbers goes to `recording`, which
 * has room for `rows`. Returns the number of steps done.
 */
long differential_governed_run_steps(differential_governed_run *run, const differential_governed_profile *profiles, long steps, long record_every, double *recording,
    long rows, long report_every, differential_governed_report report, void *user);

#endif
