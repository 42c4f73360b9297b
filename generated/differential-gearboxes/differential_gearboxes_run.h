/*
 * differential_gearboxes_run.h: controller and plant in closed loop
 *
 * Emitted by ptgen 0.1.0 from differential-gearboxes.toml (SHA-256 08abf4d695c2194f), template run.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef DIFFERENTIAL_GEARBOXES_RUN_H
#define DIFFERENTIAL_GEARBOXES_RUN_H

#include "differential_gearboxes_controller.h"
#include "differential_gearboxes_plant.h"

enum { differential_gearboxes_profile_count = 3 };
enum { differential_gearboxes_signal_count = 22 };

/* Names of the references, and of the recorded signals, in their order. */
extern const char *const differential_gearboxes_profile_names[differential_gearboxes_profile_count];
extern const char *const differential_gearboxes_signal_names[differential_gearboxes_signal_count];

/* A reference over time: straight lines between points, or steps; constant before and after. SI units. */
typedef struct {
    long count;
    int steps;
    const double *time;
    const double *value;
} differential_gearboxes_profile;

/* Everything that a closed loop consists of. */
typedef struct {
    differential_gearboxes_controller_params controller_params;
    differential_gearboxes_plant_params plant_params;
    differential_gearboxes_controller_state controller;
    differential_gearboxes_plant_state plant;
    differential_gearboxes_controller_inputs inputs;
    differential_gearboxes_controller_outputs commands;
    differential_gearboxes_plant_inputs driven;
    differential_gearboxes_plant_outputs measured;
    long cursor[differential_gearboxes_profile_count];
    long step;
    int status; /* first status of controller or plant that was not ok; plant statuses are negative */
} differential_gearboxes_run;

/* Called every `report_every` steps; a value other than 0 stops the run. */
typedef int (*differential_gearboxes_report)(long step, void *user);

size_t differential_gearboxes_run_size(void);

/* Initialises controller and plant from the parameters in `run`; returns its status. */
int differential_gearboxes_run_init(differential_gearboxes_run *run);

/*
 * Runs `steps` steps. Every `record_every` steps one row of differential_gearboxes_signal_count numbers goes to `recording`, which
 * has room for `rows`. Returns the number of steps done.
 */
long differential_gearboxes_run_steps(differential_gearboxes_run *run, const differential_gearboxes_profile *profiles, long steps, long record_every, double *recording,
    long rows, long report_every, differential_gearboxes_report report, void *user);

#endif
