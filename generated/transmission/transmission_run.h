/*
 * transmission_run.h: controller and plant in closed loop
 *
 * Emitted by ptgen 0.1.0 from transmission.toml (SHA-256 e06936acb40aa4a5), template run.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef TRANSMISSION_RUN_H
#define TRANSMISSION_RUN_H

#include "transmission_controller.h"
#include "transmission_plant.h"

enum { transmission_profile_count = 8 };
enum { transmission_signal_count = 27 };

/* Names of the references, then the actuations, then the ratios that change, and of the recorded signals, in their order. */
extern const char *const transmission_profile_names[transmission_profile_count];
extern const char *const transmission_signal_names[transmission_signal_count];

/*
 * A reference, an actuation or a ratio over time: straight lines between points, or steps; constant before and after.
 * SI units. The controller takes them at the start of a step, the plant, where they act over the whole step, in its middle.
 */
typedef struct {
    long count;
    int steps;
    const double *time;
    const double *value;
} transmission_profile;

/* Everything that a closed loop consists of. */
typedef struct {
    transmission_controller_params controller_params;
    transmission_plant_params plant_params;
    transmission_controller_state controller;
    transmission_plant_state plant;
    transmission_controller_inputs inputs;
    transmission_controller_outputs commands;
    transmission_plant_inputs driven;
    transmission_plant_outputs measured;
    long cursor[transmission_profile_count];
    long step;
    int status; /* first status of controller or plant that was not ok; plant statuses are negative */
} transmission_run;

/* Called every `report_every` steps; a value other than 0 stops the run. */
typedef int (*transmission_report)(long step, void *user);

size_t transmission_run_size(void);

/* Initialises controller and plant from the parameters in `run`; returns its status. */
int transmission_run_init(transmission_run *run);

/*
 * Runs `steps` steps. Every `record_every` steps one row of transmission_signal_count numbers goes to `recording`, which
 * has room for `rows`. Returns the number of steps done.
 */
long transmission_run_steps(transmission_run *run, const transmission_profile *profiles, long steps, long record_every, double *recording,
    long rows, long report_every, transmission_report report, void *user);

#endif
