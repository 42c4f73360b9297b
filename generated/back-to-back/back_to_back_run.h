/*
 * back_to_back_run.h: controller and plant in closed loop
 *
 * Emitted by ptgen 0.1.0 from back-to-back.toml (SHA-256 376363ff9555c6b9), template run.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef BACK_TO_BACK_RUN_H
#define BACK_TO_BACK_RUN_H

#include "back_to_back_controller.h"
#include "back_to_back_plant.h"

enum { back_to_back_profile_count = 2 };
enum { back_to_back_signal_count = 11 };

/* Names of the references, and of the recorded signals, in their order. */
extern const char *const back_to_back_profile_names[back_to_back_profile_count];
extern const char *const back_to_back_signal_names[back_to_back_signal_count];

/* A reference over time: straight lines between points, or steps; constant before and after. SI units. */
typedef struct {
    long count;
    int steps;
    const double *time;
    const double *value;
} back_to_back_profile;

/* Everything that a closed loop consists of. */
typedef struct {
    back_to_back_controller_params controller_params;
    back_to_back_plant_params plant_params;
    back_to_back_controller_state controller;
    back_to_back_plant_state plant;
    back_to_back_controller_inputs inputs;
    back_to_back_controller_outputs commands;
    back_to_back_plant_inputs driven;
    back_to_back_plant_outputs measured;
    long cursor[back_to_back_profile_count];
    long step;
    int status; /* first status of controller or plant that was not ok; plant statuses are negative */
} back_to_back_run;

/* Called every `report_every` steps; a value other than 0 stops the run. */
typedef int (*back_to_back_report)(long step, void *user);

size_t back_to_back_run_size(void);

/* Initialises controller and plant from the parameters in `run`; returns its status. */
int back_to_back_run_init(back_to_back_run *run);

/*
 * Runs `steps` steps. Every `record_every` steps one row of back_to_back_signal_count numbers goes to `recording`, which
 * has room for `rows`. Returns the number of steps done.
 */
long back_to_back_run_steps(back_to_back_run *run, const back_to_back_profile *profiles, long steps, long record_every, double *recording,
    long rows, long report_every, back_to_back_report report, void *user);

#endif
