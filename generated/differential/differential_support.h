/*
 * differential_support.h: arithmetic and small dense algebra
 *
 * Emitted by ptgen 0.1.0 from differential.toml (SHA-256 5e355ff6d92b28a7), template support.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef DIFFERENTIAL_SUPPORT_H
#define DIFFERENTIAL_SUPPORT_H

#include <math.h>
#include <stddef.h>

typedef double differential_real;

#define DIFFERENTIAL_REAL(x) ((differential_real)(x))

/* Order up to which differential_discretise works: states, inputs and friction elements together. */
#define DIFFERENTIAL_MAX_ORDER 22

static inline differential_real differential_min(differential_real a, differential_real b) { return a < b ? a : b; }
static inline differential_real differential_max(differential_real a, differential_real b) { return a > b ? a : b; }
static inline differential_real differential_abs(differential_real a) { return fabs(a); }
/* Both are computed before, so that a step takes nearly the same time whichever is chosen. */
static inline differential_real differential_select(int condition, differential_real a, differential_real b)
{
    return condition ? a : b;
}
static inline differential_real differential_sign(differential_real a)
{
    return a > 0.0 ? 1.0 : (a < 0.0 ? -1.0 : 0.0);
}
/* False for NaN and infinity; needs no library function. */
static inline int differential_is_finite(differential_real a) { return a - a == 0.0; }
static inline differential_real differential_clamp(differential_real value, differential_real bound)
{
    return differential_max(-bound, differential_min(bound, value));
}

differential_real differential_floor(differential_real a);
differential_real differential_exp(differential_real a);
differential_real differential_sin(differential_real a);
differential_real differential_sqrt(differential_real a);

/* Number of rows that n rows take in memory. */
static inline int differential_padded(int n) { return (n + 3) / 4 * 4; }

/* Sets an array of `bytes` bytes to zero. */
void differential_zero(size_t bytes, void *array);

/*
 * Matrices are stored by columns; the number of rows in memory is rounded up to a multiple of four.
 * Functions that return an int return 1 on success and 0 on failure.
 */

/* Solves M X = R for symmetric positive definite M (n, n); M is overwritten by its Cholesky factor. */
int differential_cholesky_solve(int n, int columns, differential_real *M, const differential_real *R, differential_real *X);

/* Whether the symmetric matrix K (n, n) is positive definite, or, if asked for, at least semidefinite. */
int differential_require_definite(int n, int semidefinite, const differential_real *K);

/* Share of a sum of a few numbers that may be rounding. */
void differential_rounding_unit(differential_real *share);

/* Copies `count` columns of `source` (rows, .), from column `first` on, to (row, column) of `target`. */
void differential_insert(int rows, int target_stride, int source_stride, int row, int column, int first, int count,
    differential_real *target, const differential_real *source);

/* C = A - B, all (rows, columns). */
void differential_difference(int rows, int columns, const differential_real *A, const differential_real *B, differential_real *C);

/*
 * First n rows of exp(A t), A (n, total) over zero rows, balanced by `scale` (total): Taylor series of degree
 * 18 with `squarings` squarings. Fails if the argument is too large for them.
 */
int differential_discretise(int n, int total, int squarings, const differential_real *A, const differential_real *scale,
    differential_real t, differential_real *E);

/*
 * y = A x for A (n, m); runs over four rows and two columns at a time, the padding included: eight independent sums
 * keep the processor busy where one would wait for each addition.
 */
static inline void differential_multiply(int n, int m, const differential_real *restrict A, const differential_real *restrict x,
    differential_real *restrict y)
{
    const int rows = differential_padded(n);
    for (int i = 0; i < rows; i += 4) {
        const differential_real *a = A + i;
        differential_real s0 = 0.0, s1 = 0.0, s2 = 0.0, s3 = 0.0;
        differential_real t0 = 0.0, t1 = 0.0, t2 = 0.0, t3 = 0.0;
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
static inline void differential_add_product(int n, int m, differential_real *restrict y, const differential_real *restrict x,
    const differential_real *restrict A, const differential_real *restrict T)
{
    const int rows = differential_padded(n);
    int i = 0;
    for (; i + 4 <= n; i += 4) { /* y may be longer than n and has no padding */
        const differential_real *a = A + i;
        differential_real s0 = x[i], s1 = x[i + 1], s2 = x[i + 2], s3 = x[i + 3];
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
        differential_real sum = x[i];
        for (int j = 0; j < m; ++j) {
            sum += A[j * rows + i] * T[j];
        }
        y[i] = sum;
    }
}

/* Pushes `value` into a delay line; `late` is the value of `steps` steps ago, `early` the one of a step before. */
static inline void differential_delay(int capacity, differential_real *line, differential_real value, differential_real steps,
    differential_real *late, differential_real *early)
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
static inline void differential_guard(differential_real value, differential_real bound, differential_real before, differential_real *held,
    differential_real *sound)
{
    const int good = differential_abs(value) <= bound; /* false for NaN */
    *held = differential_select(good, value, before);
    *sound = differential_select(good, 1.0, 0.0);
}

/* For how long a signal was not sound: a sound step takes back a bad one. No more than `allowed` and a step is counted. */
static inline void differential_lasting(differential_real sound, differential_real time, differential_real step, differential_real allowed,
    differential_real *after)
{
    const differential_real counted = differential_min(time, allowed);
    *after = differential_select(sound > 0.5, differential_max(counted, step) - step, counted + step);
}

/* For how long `value` has been the same to the last bit. */
static inline void differential_still(differential_real value, differential_real before, differential_real time, differential_real step,
    differential_real *after)
{
    *after = differential_select(differential_abs(value - before) <= 0.0, time + step, 0.0);
}

/* The side on which `value` last was beyond `limit` (-1, 0, 1), and the count of changes, less `decay`. */
static inline void differential_swings(differential_real value, differential_real limit, differential_real side, differential_real count,
    differential_real decay, differential_real *after, differential_real *swings)
{
    const differential_real above = differential_select(value > limit, 1.0, side);
    const differential_real now = differential_select(value < -limit, -1.0, above);
    *after = now;
    *swings = differential_max(count - decay, 0.0) + differential_min(differential_abs(now - side), 1.0);
}

/* `value` limited to 0 to 1; 0 for NaN. */
static inline void differential_share(differential_real value, differential_real *limited)
{
    *limited = differential_min(differential_max(value, 0.0), 1.0);
}

/*
 * Function that is linear between the n increasing points of `grid` and constant beyond them: from grid[k] on it is
 * level[k] + slope[k] * (value - grid[k]); slope[n - 1] is zero. Bisection without branches: always the same time.
 */
static inline void differential_lookup(int n, differential_real value, const differential_real *grid, const differential_real *slope,
    const differential_real *level, differential_real *result)
{
    const differential_real *at = grid;
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
    *result = level[k] + slope[k] * differential_max(value - grid[k], 0.0);
}

#endif
