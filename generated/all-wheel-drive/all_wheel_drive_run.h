/*
 * all_wheel_drive_run.h: controller and plant in closed loop
 *
 * Emitted by ptgen 0.1.0 from all-wheel-drive.toml (SHA-256 4a4f0cf573c3f3c3), template run.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef ALL_WHEEL_DRIVE_RUN_H
#define ALL_WHEEL_DRIVE_RUN_H

#include "all_wheel_drive_controller.h"
#include "all_wheel_drive_plant.h"

enum { all_wheel_drive_profile_count = 5 };
enum { all_wheel_drive_signal_count = 41 };

/* Names of the references, and of the recorded signals, in their order. */
extern const char *const all_wheel_drive_profile_names[all_wheel_drive_profile_count];
extern const char *const all_wheel_drive_signal_names[all_wheel_drive_signal_count];

/* A reference over time: straight lines between points, or steps; constant before and after. SI units. */
typedef struct {
    long count;
    int steps;
    const double *time;
    const double *value;
} all_wheel_drive_profile;

/* Everything that a closed loop consists of. */
typedef struct {
    all_wheel_drive_controller_params controller_params;
    all_wheel_drive_plant_params plant_params;
    all_wheel_drive_controller_state controller;
    all_wheel_drive_plant_state plant;
    all_wheel_drive_controller_inputs inputs;
    all_wheel_drive_controller_outputs commands;
    all_wheel_drive_plant_inputs driven;
    all_wheel_drive_plant_outputs measured;
    long cursor[all_wheel_drive_profile_count];
    long step;
    int status; /* first status of controller or plant that was not ok; plant statuses are negative */
} all_wheel_drive_run;

/* Called every `report_every` steps; a value other than 0 stops the run. */
typedef int (*all_wheel_drive_report)(long step, void *user);

size_t all_wheel_drive_run_size(void);

/* Initialises controller and plant from the parameters in `run`; returns its status. */
int all_wheel_drive_run_init(all_wheel_drive_run *run);

/*
 * Runs `steps` steps. Every `record_every` steps one row of all_wheel_drive_signal_count numbers goes to `recording`, which
 * has room for `rows`. Returns the number of steps done.
 */
long all_wheel_drive_run_steps(all_wheel_drive_run *run, const all_wheel_drive_profile *profiles, long steps, long record_every, double *recording,
    long rows, long report_every, all_wheel_drive_report report, void *user);

#endif
