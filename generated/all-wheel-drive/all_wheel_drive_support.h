/*
 * all_wheel_drive_support.h: arithmetic and small dense algebra
 *
 * Emitted by ptgen 0.1.0 from all-wheel-drive.toml (SHA-256 4a4f0cf573c3f3c3), template support.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef ALL_WHEEL_DRIVE_SUPPORT_H
#define ALL_WHEEL_DRIVE_SUPPORT_H

#include <math.h>
#include <stddef.h>

typedef double all_wheel_drive_real;

#define ALL_WHEEL_DRIVE_REAL(x) ((all_wheel_drive_real)(x))

/* Order up to which all_wheel_drive_discretise works: states, inputs and friction elements together. */
#define ALL_WHEEL_DRIVE_MAX_ORDER 44

static inline all_wheel_drive_real all_wheel_drive_min(all_wheel_drive_real a, all_wheel_drive_real b) { return a < b ? a : b; }
static inline all_wheel_drive_real all_wheel_drive_max(all_wheel_drive_real a, all_wheel_drive_real b) { return a > b ? a : b; }
static inline all_wheel_drive_real all_wheel_drive_abs(all_wheel_drive_real a) { return fabs(a); }
/* Both are computed before, so that a step takes nearly the same time whichever is chosen. */
static inline all_wheel_drive_real all_wheel_drive_select(int condition, all_wheel_drive_real a, all_wheel_drive_real b)
{
    return condition ? a : b;
}
static inline all_wheel_drive_real all_wheel_drive_sign(all_wheel_drive_real a)
{
    return a > 0.0 ? 1.0 : (a < 0.0 ? -1.0 : 0.0);
}
/* False for NaN and infinity; needs no library function. */
static inline int all_wheel_drive_is_finite(all_wheel_drive_real a) { return a - a == 0.0; }
static inline all_wheel_drive_real all_wheel_drive_clamp(all_wheel_drive_real value, all_wheel_drive_real bound)
{
    return all_wheel_drive_max(-bound, all_wheel_drive_min(bound, value));
}

all_wheel_drive_real all_wheel_drive_floor(all_wheel_drive_real a);
all_wheel_drive_real all_wheel_drive_exp(all_wheel_drive_real a);
all_wheel_drive_real all_wheel_drive_sin(all_wheel_drive_real a);
all_wheel_drive_real all_wheel_drive_sqrt(all_wheel_drive_real a);

/* Number of rows that n rows take in memory. */
static inline int all_wheel_drive_padded(int n) { return (n + 3) / 4 * 4; }

/* Sets an array of `bytes` bytes to zero. */
void all_wheel_drive_zero(size_t bytes, void *array);

/*
 * Matrices are stored by columns; the number of rows in memory is rounded up to a multiple of four.
 * Functions that return an int return 1 on success and 0 on failure.
 */

/* Solves M X = R for symmetric positive definite M (n, n); M is overwritten by its Cholesky factor. */
int all_wheel_drive_cholesky_solve(int n, int columns, all_wheel_drive_real *M, const all_wheel_drive_real *R, all_wheel_drive_real *X);

/* Whether the symmetric matrix K (n, n) is positive definite, or, if asked for, at least semidefinite. */
int all_wheel_drive_require_definite(int n, int semidefinite, const all_wheel_drive_real *K);

/* Share of a sum of a few numbers that may be rounding. */
void all_wheel_drive_rounding_unit(all_wheel_drive_real *share);

/* Copies `count` columns of `source` (rows, .), from column `first` on, to (row, column) of `target`. */
void all_wheel_drive_insert(int rows, int target_stride, int source_stride, int row, int column, int first, int count,
    all_wheel_drive_real *target, const all_wheel_drive_real *source);

/* C = A - B, all (rows, columns). */
void all_wheel_drive_difference(int rows, int columns, const all_wheel_drive_real *A, const all_wheel_drive_real *B, all_wheel_drive_real *C);

/*
 * First n rows of exp(A t), A (n, total) over zero rows, balanced by `scale` (total): Taylor series of degree
 * 18 with `squarings` squarings. Fails if the argument is too large for them.
 */
int all_wheel_drive_discretise(int n, int total, int squarings, const all_wheel_drive_real *A, const all_wheel_drive_real *scale,
    all_wheel_drive_real t, all_wheel_drive_real *E);

/*
 * y = A x for A (n, m); runs over four rows and two columns at a time, the padding included: eight independent sums
 * keep the processor busy where one would wait for each addition.
 */
static inline void all_wheel_drive_multiply(int n, int m, const all_wheel_drive_real *restrict A, const all_wheel_drive_real *restrict x,
    all_wheel_drive_real *restrict y)
{
    const int rows = all_wheel_drive_padded(n);
    for (int i = 0; i < rows; i += 4) {
        const all_wheel_drive_real *a = A + i;
        all_wheel_drive_real s0 = 0.0, s1 = 0.0, s2 = 0.0, s3 = 0.0;
        all_wheel_drive_real t0 = 0.0, t1 = 0.0, t2 = 0.0, t3 = 0.0;
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
static inline void all_wheel_drive_add_product(int n, int m, all_wheel_drive_real *restrict y, const all_wheel_drive_real *restrict x,
    const all_wheel_drive_real *restrict A, const all_wheel_drive_real *restrict T)
{
    const int rows = all_wheel_drive_padded(n);
    int i = 0;
    for (; i + 4 <= n; i += 4) { /* y may be longer than n and has no padding */
        const all_wheel_drive_real *a = A + i;
        all_wheel_drive_real s0 = x[i], s1 = x[i + 1], s2 = x[i + 2], s3 = x[i + 3];
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
        all_wheel_drive_real sum = x[i];
        for (int j = 0; j < m; ++j) {
            sum += A[j * rows + i] * T[j];
        }
        y[i] = sum;
    }
}

/* Pushes `value` into a delay line; `late` is the value of `steps` steps ago, `early` the one of a step before. */
static inline void all_wheel_drive_delay(int capacity, all_wheel_drive_real *line, all_wheel_drive_real value, all_wheel_drive_real steps,
    all_wheel_drive_real *late, all_wheel_drive_real *early)
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
static inline void all_wheel_drive_guard(all_wheel_drive_real value, all_wheel_drive_real bound, all_wheel_drive_real before, all_wheel_drive_real *held,
    all_wheel_drive_real *sound)
{
    const int good = all_wheel_drive_abs(value) <= bound; /* false for NaN */
    *held = all_wheel_drive_select(good, value, before);
    *sound = all_wheel_drive_select(good, 1.0, 0.0);
}

/* For how long a signal was not sound: a sound step takes back a bad one. No more than `allowed` and a step is counted. */
static inline void all_wheel_drive_lasting(all_wheel_drive_real sound, all_wheel_drive_real time, all_wheel_drive_real step, all_wheel_drive_real allowed,
    all_wheel_drive_real *after)
{
    const all_wheel_drive_real counted = all_wheel_drive_min(time, allowed);
    *after = all_wheel_drive_select(sound > 0.5, all_wheel_drive_max(counted, step) - step, counted + step);
}

/* For how long `value` has been the same to the last bit. */
static inline void all_wheel_drive_still(all_wheel_drive_real value, all_wheel_drive_real before, all_wheel_drive_real time, all_wheel_drive_real step,
    all_wheel_drive_real *after)
{
    *after = all_wheel_drive_select(all_wheel_drive_abs(value - before) <= 0.0, time + step, 0.0);
}

/* The side on which `value` last was beyond `limit` (-1, 0, 1), and the count of changes, less `decay`. */
static inline void all_wheel_drive_swings(all_wheel_drive_real value, all_wheel_drive_real limit, all_wheel_drive_real side, all_wheel_drive_real count,
    all_wheel_drive_real decay, all_wheel_drive_real *after, all_wheel_drive_real *swings)
{
    const all_wheel_drive_real above = all_wheel_drive_select(value > limit, 1.0, side);
    const all_wheel_drive_real now = all_wheel_drive_select(value < -limit, -1.0, above);
    *after = now;
    *swings = all_wheel_drive_max(count - decay, 0.0) + all_wheel_drive_min(all_wheel_drive_abs(now - side), 1.0);
}

/* `value` limited to 0 to 1; 0 for NaN. */
static inline void all_wheel_drive_share(all_wheel_drive_real value, all_wheel_drive_real *limited)
{
    *limited = all_wheel_drive_min(all_wheel_drive_max(value, 0.0), 1.0);
}

/*
 * Function that is linear between the n increasing points of `grid` and constant beyond them: from grid[k] on it is
 * level[k] + slope[k] * (value - grid[k]); slope[n - 1] is zero. Bisection without branches: always the same time.
 */
static inline void all_wheel_drive_lookup(int n, all_wheel_drive_real value, const all_wheel_drive_real *grid, const all_wheel_drive_real *slope,
    const all_wheel_drive_real *level, all_wheel_drive_real *result)
{
    const all_wheel_drive_real *at = grid;
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
    *result = level[k] + slope[k] * all_wheel_drive_max(value - grid[k], 0.0);
}

#endif
