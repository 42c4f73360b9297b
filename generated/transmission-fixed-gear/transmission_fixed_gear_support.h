/*
 * transmission_fixed_gear_support.h: arithmetic and small dense algebra
 *
 * Emitted by ptgen 0.1.0 from transmission-fixed-gear.toml (SHA-256 ccd2b8cca096cd29), template support.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef TRANSMISSION_FIXED_GEAR_SUPPORT_H
#define TRANSMISSION_FIXED_GEAR_SUPPORT_H

#include <math.h>
#include <stddef.h>

typedef double transmission_fixed_gear_real;

#define TRANSMISSION_FIXED_GEAR_REAL(x) ((transmission_fixed_gear_real)(x))

/* Order up to which transmission_fixed_gear_discretise works: states, inputs and friction elements together. */
#define TRANSMISSION_FIXED_GEAR_MAX_ORDER 13

static inline transmission_fixed_gear_real transmission_fixed_gear_min(transmission_fixed_gear_real a, transmission_fixed_gear_real b) { return a < b ? a : b; }
static inline transmission_fixed_gear_real transmission_fixed_gear_max(transmission_fixed_gear_real a, transmission_fixed_gear_real b) { return a > b ? a : b; }
static inline transmission_fixed_gear_real transmission_fixed_gear_abs(transmission_fixed_gear_real a) { return fabs(a); }
/* Both are computed before, so that a step takes nearly the same time whichever is chosen. */
static inline transmission_fixed_gear_real transmission_fixed_gear_select(int condition, transmission_fixed_gear_real a, transmission_fixed_gear_real b)
{
    return condition ? a : b;
}
static inline transmission_fixed_gear_real transmission_fixed_gear_sign(transmission_fixed_gear_real a)
{
    return a > 0.0 ? 1.0 : (a < 0.0 ? -1.0 : 0.0);
}
/* False for NaN and infinity; needs no library function. */
static inline int transmission_fixed_gear_is_finite(transmission_fixed_gear_real a) { return a - a == 0.0; }
static inline transmission_fixed_gear_real transmission_fixed_gear_clamp(transmission_fixed_gear_real value, transmission_fixed_gear_real bound)
{
    return transmission_fixed_gear_max(-bound, transmission_fixed_gear_min(bound, value));
}

transmission_fixed_gear_real transmission_fixed_gear_floor(transmission_fixed_gear_real a);
transmission_fixed_gear_real transmission_fixed_gear_exp(transmission_fixed_gear_real a);
transmission_fixed_gear_real transmission_fixed_gear_sin(transmission_fixed_gear_real a);
transmission_fixed_gear_real transmission_fixed_gear_sqrt(transmission_fixed_gear_real a);

/* Number of rows that n rows take in memory. */
static inline int transmission_fixed_gear_padded(int n) { return (n + 3) / 4 * 4; }

/* Sets an array of `bytes` bytes to zero. */
void transmission_fixed_gear_zero(size_t bytes, void *array);

/*
 * Matrices are stored by columns; the number of rows in memory is rounded up to a multiple of four.
 * Functions that return an int return 1 on success and 0 on failure.
 */

/* Solves M X = R for symmetric positive definite M (n, n); M is overwritten by its Cholesky factor. */
int transmission_fixed_gear_cholesky_solve(int n, int columns, transmission_fixed_gear_real *M, const transmission_fixed_gear_real *R, transmission_fixed_gear_real *X);

/* Whether the symmetric matrix K (n, n) is positive definite, or, if asked for, at least semidefinite. */
int transmission_fixed_gear_require_definite(int n, int semidefinite, const transmission_fixed_gear_real *K);

/* Share of a sum of a few numbers that may be rounding. */
void transmission_fixed_gear_rounding_unit(transmission_fixed_gear_real *share);

/* Copies `count` columns of `source` (rows, .), from column `first` on, to (row, column) of `target`. */
void transmission_fixed_gear_insert(int rows, int target_stride, int source_stride, int row, int column, int first, int count,
    transmission_fixed_gear_real *target, const transmission_fixed_gear_real *source);

/* C = A - B, all (rows, columns). */
void transmission_fixed_gear_difference(int rows, int columns, const transmission_fixed_gear_real *A, const transmission_fixed_gear_real *B, transmission_fixed_gear_real *C);

/*
 * First n rows of exp(A t), A (n, total) over zero rows, balanced by `scale` (total): Taylor series of degree
 * 18 with `squarings` squarings. Fails if the argument is too large for them.
 */
int transmission_fixed_gear_discretise(int n, int total, int squarings, const transmission_fixed_gear_real *A, const transmission_fixed_gear_real *scale,
    transmission_fixed_gear_real t, transmission_fixed_gear_real *E);

/*
 * y = A x for A (n, m); runs over four rows and two columns at a time, the padding included: eight independent sums
 * keep the processor busy where one would wait for each addition.
 */
static inline void transmission_fixed_gear_multiply(int n, int m, const transmission_fixed_gear_real *restrict A, const transmission_fixed_gear_real *restrict x,
    transmission_fixed_gear_real *restrict y)
{
    const int rows = transmission_fixed_gear_padded(n);
    for (int i = 0; i < rows; i += 4) {
        const transmission_fixed_gear_real *a = A + i;
        transmission_fixed_gear_real s0 = 0.0, s1 = 0.0, s2 = 0.0, s3 = 0.0;
        transmission_fixed_gear_real t0 = 0.0, t1 = 0.0, t2 = 0.0, t3 = 0.0;
        for (int j = 0; j + 1 < m; j += 2) {
            s0 += a[0] * x[j];
            s1 += a[1] * x[j];
            s2 += a[2] * x[j];
            s3 += a[3] * x[j];
            a += rows;
            t0 += a[0] * x[j + 1];
            t1 += a[1] * x[j + 1];
            t2 += a[2] * x[j + 1];
            t3 += a[3] * x[j + 1];
            a += rows;
        }
        if (m % 2) {
            s0 += a[0] * x[m - 1];
            s1 += a[1] * x[m - 1];
            s2 += a[2] * x[m - 1];
            s3 += a[3] * x[m - 1];
        }
        y[i] = s0 + t0;
        y[i + 1] = s1 + t1;
        y[i + 2] = s2 + t2;
        y[i + 3] = s3 + t3;
    }
}

/* y = x + A T for A (n, m). */
static inline void transmission_fixed_gear_add_product(int n, int m, transmission_fixed_gear_real *restrict y, const transmission_fixed_gear_real *restrict x,
    const transmission_fixed_gear_real *restrict A, const transmission_fixed_gear_real *restrict T)
{
    const int rows = transmission_fixed_gear_padded(n);
    int i = 0;
    for (; i + 4 <= n; i += 4) { /* y may be longer than n and has no padding */
        const transmission_fixed_gear_real *a = A + i;
        transmission_fixed_gear_real s0 = x[i], s1 = x[i + 1], s2 = x[i + 2], s3 = x[i + 3];
        for (int j = 0; j < m; ++j) {
            s0 += a[0] * T[j];
            s1 += a[1] * T[j];
            s2 += a[2] * T[j];
            s3 += a[3] * T[j];
            a += rows;
        }
        y[i] = s0;
        y[i + 1] = s1;
        y[i + 2] = s2;
        y[i + 3] = s3;
    }
    for (; i < n; ++i) {
        transmission_fixed_gear_real sum = x[i];
        for (int j = 0; j < m; ++j) {
            sum += A[j * rows + i] * T[j];
        }
        y[i] = sum;
    }
}

/* Pushes `value` into a delay line; `late` is the value of `steps` steps ago, `early` the one of a step before. */
static inline void transmission_fixed_gear_delay(int capacity, transmission_fixed_gear_real *line, transmission_fixed_gear_real value, transmission_fixed_gear_real steps,
    transmission_fixed_gear_real *late, transmission_fixed_gear_real *early)
{
    const int depth = (int)steps;
    *late = depth == 0 ? value : line[depth - 1];
    *early = line[depth];
    for (int k = capacity - 1; k > 0; --k) {
        line[k] = line[k - 1];
    }
    line[0] = value;
}

/* Takes `value` if it is finite and at most `bound` in size, else leaves what was held; `sound` is 1 or 0. */
static inline void transmission_fixed_gear_guard(transmission_fixed_gear_real value, transmission_fixed_gear_real bound, transmission_fixed_gear_real before, transmission_fixed_gear_real *held,
    transmission_fixed_gear_real *sound)
{
    const int good = transmission_fixed_gear_abs(value) <= bound; /* false for NaN */
    *held = transmission_fixed_gear_select(good, value, before);
    *sound = transmission_fixed_gear_select(good, 1.0, 0.0);
}

/* For how long a signal was not sound: a sound step takes back a bad one. No more than `allowed` and a step is counted. */
static inline void transmission_fixed_gear_lasting(transmission_fixed_gear_real sound, transmission_fixed_gear_real time, transmission_fixed_gear_real step, transmission_fixed_gear_real allowed,
    transmission_fixed_gear_real *after)
{
    const transmission_fixed_gear_real counted = transmission_fixed_gear_min(time, allowed);
    *after = transmission_fixed_gear_select(sound > 0.5, transmission_fixed_gear_max(counted, step) - step, counted + step);
}

/* For how long `value` has been the same to the last bit. */
static inline void transmission_fixed_gear_still(transmission_fixed_gear_real value, transmission_fixed_gear_real before, transmission_fixed_gear_real time, transmission_fixed_gear_real step,
    transmission_fixed_gear_real *after)
{
    *after = transmission_fixed_gear_select(transmission_fixed_gear_abs(value - before) <= 0.0, time + step, 0.0);
}

/* The side on which `value` last was beyond `limit` (-1, 0, 1), and the count of changes, less `decay`. */
static inline void transmission_fixed_gear_swings(transmission_fixed_gear_real value, transmission_fixed_gear_real limit, transmission_fixed_gear_real side, transmission_fixed_gear_real count,
    transmission_fixed_gear_real decay, transmission_fixed_gear_real *after, transmission_fixed_gear_real *swings)
{
    const transmission_fixed_gear_real above = transmission_fixed_gear_select(value > limit, 1.0, side);
    const transmission_fixed_gear_real now = transmission_fixed_gear_select(value < -limit, -1.0, above);
    *after = now;
    *swings = transmission_fixed_gear_max(count - decay, 0.0) + transmission_fixed_gear_min(transmission_fixed_gear_abs(now - side), 1.0);
}

/* `value` limited to 0 to 1; 0 for NaN. */
static inline void transmission_fixed_gear_share(transmission_fixed_gear_real value, transmission_fixed_gear_real *limited)
{
    *limited = transmission_fixed_gear_min(transmission_fixed_gear_max(value, 0.0), 1.0);
}

/*
 * Function that is linear between the n increasing points of `grid` and constant beyond them: from grid[k] on it is
 * level[k] + slope[k] * (value - grid[k]); slope[n - 1] is zero. Bisection without branches: always the same time.
 */
static inline void transmission_fixed_gear_lookup(int n, transmission_fixed_gear_real value, const transmission_fixed_gear_real *grid, const transmission_fixed_gear_real *slope,
    const transmission_fixed_gear_real *level, transmission_fixed_gear_real *result)
{
    const transmission_fixed_gear_real *at = grid;
    int count = n; /* a constant where this is called, so most of what follows is computed by the compiler */
    at += (value >= at[count / 2]) * (count / 2), count -= count / 2;
    at += (value >= at[count / 2]) * (count / 2), count -= count / 2;
    at += (value >= at[count / 2]) * (count / 2), count -= count / 2;
    at += (value >= at[count / 2]) * (count / 2), count -= count / 2;
    at += (value >= at[count / 2]) * (count / 2), count -= count / 2;
    at += (value >= at[count / 2]) * (count / 2), count -= count / 2;
    while (count > 1) {
        at += (value >= at[count / 2]) * (count / 2), count -= count / 2;
    }
    const ptrdiff_t k = at - grid;
    *result = level[k] + slope[k] * transmission_fixed_gear_max(value - grid[k], 0.0);
}

#endif
