/*
 * transmission_nine_speed_main.c: closed-loop runner
 *
 * Emitted by ptgen 0.1.0 from transmission-nine-speed.toml (SHA-256 65236af78ec41a0c), template main.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "transmission_nine_speed_run.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define POINTS 4096

static double times[POINTS];
static double values[transmission_nine_speed_profile_count][POINTS];

/*
 * Reads references and actuations and ratios from a CSV file: a head line with `time` and names of them, then rows in SI units.
 * Those that are not named stay zero, ratios as in the bed file. Returns the number of rows, or -1.
 */
static long read_profiles(const char *path)
{
    char line[4096];
    int columns[transmission_nine_speed_profile_count + 1];
    int count = 0;
    long rows = 0;
    for (int k = 0; k < POINTS; ++k) {
        values[9][k] = 3.3333333333333335;
    }
    FILE *file = fopen(path, "r");
    if (!file) {
        return -1;
    }
    if (!fgets(line, (int)sizeof line, file)) {
        (void)fclose(file);
        return -1;
    }
    for (char *word = strtok(line, ",\r\n"); word && count <= transmission_nine_speed_profile_count; word = strtok(NULL, ",\r\n")) {
        columns[count] = strcmp(word, "time") == 0 ? -1 : -2;
        for (int k = 0; k < transmission_nine_speed_profile_count; ++k) {
            if (strcmp(word, transmission_nine_speed_profile_names[k]) == 0) {
                columns[count] = k;
            }
        }
        if (columns[count] == -2) {
            fprintf(stderr, "%s: unknown column \"%s\"\n", path, word);
            (void)fclose(file);
            return -1;
        }
        ++count;
    }
    while (rows < POINTS && fgets(line, (int)sizeof line, file)) {
        int column = 0;
        for (char *word = strtok(line, ",\r\n"); word && column < count; word = strtok(NULL, ",\r\n")) {
            const double value = strtod(word, NULL);
            if (columns[column] < 0) {
                times[rows] = value;
            } else {
                values[columns[column]][rows] = value;
            }
            ++column;
        }
        if (column == count) {
            ++rows;
        }
    }
    (void)fclose(file);
    return rows;
}

static int print_row(long step, void *user)
{
    const transmission_nine_speed_run *run = user;
    printf("%.17g", (double)step * (double)run->plant_params.sample_time);
    printf(",%.9g", (double)run->inputs.gears_input_torque_ref);
    printf(",%.9g", (double)run->inputs.M2_speed_ref);
    printf(",%.9g", (double)run->driven.converter_lockup_actuation);
    printf(",%.9g", (double)run->driven.gears_A_actuation);
    printf(",%.9g", (double)run->driven.gears_B_actuation);
    printf(",%.9g", (double)run->driven.gears_C_actuation);
    printf(",%.9g", (double)run->driven.gears_D_actuation);
    printf(",%.9g", (double)run->driven.gears_E_actuation);
    printf(",%.9g", (double)run->driven.gears_F_actuation);
    printf(",%.9g", (double)run->inputs.gears_ratio);
    printf(",%.9g", (double)run->measured.M1_speed);
    printf(",%.9g", (double)run->measured.flange1_torque);
    printf(",%.9g", (double)run->measured.flange2_torque);
    printf(",%.9g", (double)run->measured.M2_speed);
    printf(",%.9g", (double)run->measured.gears_input_torque);
    printf(",%.9g", (double)run->measured.M1_torque);
    printf(",%.9g", (double)run->measured.M2_torque);
    printf(",%.9g", (double)run->measured.converter_lockup_torque);
    printf(",%.9g", (double)run->measured.converter_lockup_speed);
    printf(",%.9g", (double)run->measured.gears_A_torque);
    printf(",%.9g", (double)run->measured.gears_A_speed);
    printf(",%.9g", (double)run->measured.gears_B_torque);
    printf(",%.9g", (double)run->measured.gears_B_speed);
    printf(",%.9g", (double)run->measured.gears_C_torque);
    printf(",%.9g", (double)run->measured.gears_C_speed);
    printf(",%.9g", (double)run->measured.gears_D_torque);
    printf(",%.9g", (double)run->measured.gears_D_speed);
    printf(",%.9g", (double)run->measured.gears_E_torque);
    printf(",%.9g", (double)run->measured.gears_E_speed);
    printf(",%.9g", (double)run->measured.gears_F_torque);
    printf(",%.9g", (double)run->measured.gears_F_speed);
    printf(",%.9g", (double)run->measured.converter_fluid_pump_torque);
    printf(",%.9g", (double)run->measured.converter_fluid_turbine_torque);
    printf(",%.9g", (double)run->commands.M1_torque_ref);
    printf(",%.9g", (double)run->commands.M2_torque_ref);
    printf(",%.9g", (double)run->controller.gears_ratio_limited);
    printf(",%.9g", (double)run->controller.fault);
    printf("\n");
    return 0;
}

int main(int argc, char **argv)
{
    static transmission_nine_speed_run run;
    if (argc < 3) {
        fprintf(stderr, "usage: %s PROFILES.csv DURATION_S [STEPS_PER_ROW]\nreferences and actuations and ratios:", argv[0]);
        for (int k = 0; k < transmission_nine_speed_profile_count; ++k) {
            fprintf(stderr, " %s", transmission_nine_speed_profile_names[k]);
        }
        fprintf(stderr, "\n");
        return 2;
    }
    const long rows = read_profiles(argv[1]);
    const double duration = strtod(argv[2], NULL);
    const long every = argc > 3 ? strtol(argv[3], NULL, 10) : 10;
    if (rows < 1 || !(duration > 0.0) || every < 1) {
        fprintf(stderr, "cannot read references and actuations and ratios from %s, or the duration is not positive\n", argv[1]);
        return 2;
    }
    transmission_nine_speed_profile profiles[transmission_nine_speed_profile_count];
    for (int k = 0; k < transmission_nine_speed_profile_count; ++k) {
        profiles[k] = (transmission_nine_speed_profile){ .count = rows, .steps = 0, .time = times, .value = values[k] };
    }
    run.controller_params = transmission_nine_speed_controller_defaults;
    run.plant_params = transmission_nine_speed_plant_defaults;
    if (transmission_nine_speed_run_init(&run) == 0) {
        printf("time");
        for (int k = 0; k < transmission_nine_speed_signal_count; ++k) {
            printf(",%s", transmission_nine_speed_signal_names[k]);
        }
        printf("\n");
        const long steps = (long)(duration / (double)run.plant_params.sample_time + 0.5);
        (void)transmission_nine_speed_run_steps(&run, profiles, steps, steps, NULL, 0, every, print_row, &run);
    }
    if (run.status != 0) {
        const char *text = run.status > 0 ? transmission_nine_speed_controller_status_text((transmission_nine_speed_controller_status)run.status)
                                          : transmission_nine_speed_plant_status_text((transmission_nine_speed_plant_status)(-run.status));
        fprintf(stderr, "%s\n", text);
        return 1;
    }
    return 0;
}
