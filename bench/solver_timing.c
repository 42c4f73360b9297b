/* Loops around the emitted friction solver, which is in another file as it is for a plant. */
#include "box_friction.h"

enum { n = box_friction_elements };

static void copy(const double *from, double *to)
{
    for (int i = 0; i < n; ++i) {
        to[i] = from[i];
    }
}

/* Solves `count` problems with velocities w (count, n), `rounds` times, each from zero; returns the most factorisations. */
int cold(int count, int rounds, const double *K, const double *w, const double *lo, const double *hi)
{
    const double zero[n] = { 0.0 };
    double T[n], w_plus[n];
    int most = 0;
    for (int k = 0; k < rounds * count; ++k) {
        copy(zero, T);
        const int work = box_solve_box(0, K, w + k % count * n, lo, hi, T, w_plus);
        most = work < 0 || work > most ? work : most;
    }
    return most;
}

/* The same, each from the torques of the one before. */
int warm(int count, int rounds, const double *K, const double *w, const double *lo, const double *hi)
{
    double T[n] = { 0.0 }, w_plus[n];
    int most = 0;
    for (int k = 0; k < rounds * count; ++k) {
        const int work = box_solve_box(0, K, w + k % count * n, lo, hi, T, w_plus);
        most = work < 0 || work > most ? work : most;
    }
    return most;
}

/*
 * Steps of friction velocities that `gain` (count, n) drives; returns how many of them have an element that begins or
 * ceases to be held.
 */
int steps(int count, int rounds, const double *K, const double *gain, const double *slide, const double *rest)
{
    double T[n] = { 0.0 }, rest_before[n] = { 0.0 }, w[n] = { 0.0 }, w_free[n], mean[n], w_plus[n], status;
    int events = 0;
    for (int k = 0; k < rounds * count; ++k) {
        int changed = 0;
        for (int i = 0; i < n; ++i) {
            w_free[i] = w[i] + gain[k % count * n + i];
        }
        box_friction_step(0, 0, K, w, w_free, slide, rest, T, rest_before, mean, w_plus, &status);
        for (int i = 0; i < n; ++i) {
            changed = changed || (w[i] == 0.0) != (w_plus[i] == 0.0);
            w[i] = w_plus[i];
        }
        events += changed;
    }
    return events;
}
