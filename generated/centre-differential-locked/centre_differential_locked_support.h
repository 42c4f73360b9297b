/*
 * centre_differential_locked_support.h: arithmetic and small dense algebra
 *
 * Emitted by ptgen 0.1.0 from centre-differential-locked.toml (SHA-256 853679bdb0920a51), template support.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef CENTRE_DIFFERENTIAL_LOCKED_SUPPORT_H
#define CENTRE_DIFFERENTIAL_LOCKED_SUPPORT_H

#include <math.h>
#include <stddef.h>

typedef double centre_differential_locked_real;

#define CENTRE_DIFFERENTIAL_LOCKED_REAL(x) ((centre_differential_locked_real)(x))

/* Order up to which centre_differential_locked_discretise works: states, inputs and friction elements together. */
#define CENTRE_DIFFERENTIAL_LOCKED_MAX_ORDER 24

static inline centre_differential_locked_real centre_differential_locked_min(centre_differential_locked_real a, centre_differential_locked_real b) { return a < b ? a : b; }
static inline centre_differential_locked_real centre_differential_locked_max(centre_differential_locked_real a, centre_differential_locked_real b) { return a > b ? a : b; }
static inline centre_differential_locked_real centre_differential_locked_abs(centre_differential_locked_real a) { return fabs(a); }
/* Both are computed before, so that a step takes nearly the same time whichever is chosen. */
static inline centre_differential_locked_real centre_differential_locked_select(int condition, centre_differential_locked_real a, centre_differential_locked_real b)
{
    return condition ? a : b;
}
static inline centre_differential_locked_real centre_differential_locked_sign(centre_differential_locked_real a)
{
    return a > 0.0 ? 1.0 : (a < 0.0 ? -1.0 : 0.0);
}
/* False for NaN and infinity; needs no library function. */
static inline int centre_differential_locked_is_finite(centre_differential_locked_real a) { return a - a == 0.0; }
static inline centre_differential_locked_real centre_differential_locked_clamp(centre_differential_locked_real value, centre_differential_locked_real bound)
{
    return centre_differential_locked_max(-bound, centre_differential_locked_min(bound, value));
}

centre_differential_locked_real centre_differential_locked_floor(centre_differential_locked_real a);
centre_differential_locked_real centre_differential_locked_exp(centre_differential_locked_real a);
centre_differential_locked_real centre_differential_locked_sin(centre_differential_locked_real a);
centre_differential_locked_real centre_differential_locked_sqrt(centre_differential_locked_real a);

/* Number of rows that n rows take in memory. */
static inline int centre_differential_locked_padded(int n) { return (n + 3) / 4 * 4; }

/* Sets an array of `bytes` bytes to zero. */
void centre_differential_locked_zero(size_t bytes, void *array);

/*
 * Matrices are stored by columns; the number of rows in memory is rounded up to a multiple of four.
 * Functions that return an int return 1 on success and 0 on failure.
 */

/* Solves M X = R for symmetric positive definite M (n, n); M is overwritten by its Cholesky factor. */
int centre_differential_locked_cholesky_solve(int n, int columns, centre_differential_locked_real *M, const centre_differential_locked_real *R, centre_differential_locked_real *X);

/* Whether the symmetric matrix K (n, n) is positive definite, or, if asked for, at least semidefinite. */
int centre_differential_locked_require_definite(int n, int semidefinite, const centre_differential_locked_real *K);

/* Share of a sum of a few numbers that may be rounding. */
void centre_differential_locked_rounding_unit(centre_differential_locked_real *share);

/* Copies `count` columns of `source` (rows, .), from column `first` on, to (row, column) of `target`. */
void centre_differential_locked_insert(int rows, int target_stride, int source_stride, int row, int column, int first, int count,
    centre_differential_locked_real *target, const centre_differential_locked_real *source);

/* C = A - B, all (rows, columns). */
void centre_differential_locked_difference(int rows, int columns, const centre_differential_locked_real *A, const centre_differential_locked_real *B, centre_differential_locked_real *C);

/*
 * First n rows of exp(A t), A (n, total) over zero rows, balanced by `scale` (total): Taylor series of degree
 * 18 with `squarings` squarings. Fails if the argument is too large for them.
 */
int centre_differential_locked_discretise(int n, int total, int squarings, const centre_differential_locked_real *A, const centre_differential_locked_real *scale,
    centre_differential_locked_real t, centre_differential_locked_real *E);

/*
 * y = A x for A (n, m); runs over four rows and two columns at a time, the padding included: eight independent sums
 * keep the processor busy where one would wait for each addition.
 */
static inline void centre_differential_locked_multiply(int n, int m, const centre_differential_locked_real *restrict A, const centre_differential_locked_real *restrict x,
    centre_differential_locked_real *restrict y)
{
    const int rows = centre_differential_locked_padded(n);
    for (int i = 0; i < rows; i += 4) {
        const centre_differential_locked_real *a = A + i;
        centre_differential_locked_real s0 = 0.0, s1 = 0.0, s2 = 0.0, s3 = 0.0;
        centre_differential_locked_real t0 = 0.0, t1 = 0.0, t2 = 0.0, t3 = 0.0;
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
static inline void centre_differential_locked_add_product(int n, int m, centre_differential_locked_real *restrict y, const centre_differential_locked_real *restrict x,
    const centre_differential_locked_real *restrict A, const centre_differential_locked_real *restrict T)
{
    const int rows = centre_differential_locked_padded(n);
    int i = 0;
    for (; i + 4 <= n; i += 4) { /* y may be longer than n and has no padding */
        const centre_differential_locked_real *a = A + i;
        centre_differential_locked_real s0 = x[i], s1 = x[i + 1], s2 = x[i + 2], s3 = x[i + 3];
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
        centre_differential_locked_real sum = x[i];
        for (int j = 0; j < m; ++j) {
            sum += A[j * rows + i] * T[j];
        }
        y[i] = sum;
    }
}

/* Pushes `value` into a delay line; `late` is the value of `steps` steps ago, `early` the one of a step before. */
static inline void centre_differential_locked_delay(int capacity, centre_differential_locked_real *line, centre_differential_locked_real value, centre_differential_locked_real steps,
    centre_differential_locked_real *late, centre_differential_locked_real *early)
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
static inline void centre_differential_locked_guard(centre_differential_locked_real value, centre_differential_locked_real bound, centre_differential_locked_real before, centre_differential_locked_real *held,
    centre_differential_locked_real *sound)
{
    const int good = centre_differential_locked_abs(value) <= bound; /* false for NaN */
    *held = centre_differential_locked_select(good, value, before);
    *sound = centre_differential_locked_select(good, 1.0, 0.0);
}

/* For how long a signal was not sound: a sound step takes back a bad one. No more than `allowed` and a step is counted. */
static inline void centre_differential_locked_lasting(centre_differential_locked_real sound, centre_differential_locked_real time, centre_differential_locked_real step, centre_differential_locked_real allowed,
    centre_differential_locked_real *after)
{
    const centre_differential_locked_real counted = centre_differential_locked_min(time, allowed);
    *after = centre_differential_locked_select(sound > 0.5, centre_differential_locked_max(counted, step) - step, counted + step);
}

/* For how long `value` has been the same to the last bit. */
static inline void centre_differential_locked_still(centre_differential_locked_real value, centre_differential_locked_real before, centre_differential_locked_real time, centre_differential_locked_real step,
    centre_differential_locked_real *after)
{
    *after = centre_differential_locked_select(centre_differential_locked_abs(value - before) <= 0.0, time + step, 0.0);
}

/* The side on which `value` last was beyond `limit` (-1, 0, 1), and the count of changes, less `decay`. */
static inline void centre_differential_locked_swings(centre_differential_locked_real value, centre_differential_locked_real limit, centre_differential_locked_real side, centre_differential_locked_real count,
    centre_differential_locked_real decay, centre_differential_locked_real *after, centre_differential_locked_real *swings)
{
    const centre_differential_locked_real above = centre_differential_locked_select(value > limit, 1.0, side);
    const centre_differential_locked_real now = centre_differential_locked_select(value < -limit, -1.0, above);
    *after = now;
    *swings = centre_differential_locked_max(count - decay, 0.0) + centre_differential_locked_min(centre_differential_locked_abs(now - side), 1.0);
}

/* `value` limited to 0 to 1; 0 for NaN. */
static inline void centre_differential_locked_share(centre_differential_locked_real value, centre_differential_locked_real *limited)
{
    *limited = centre_differential_locked_min(centre_differential_locked_max(value, 0.0), 1.0);
}

/*
 * Function that is linear between the n increasing points of `grid` and constant beyond them: from grid[k] on it is
 * level[k] + slope[k] * (value - grid[k]); slope[n - 1] is zero. Bisection without branches: always the same time.
 */
static inline void centre_differential_locked_lookup(int n, centre_differential_locked_real value, const centre_differential_locked_real *grid, const centre_differential_locked_real *slope,
    const centre_differential_locked_real *level, centre_differential_locked_real *result)
{
    const centre_differential_locked_real *at = grid;
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
    *result = level[k] + slope[k] * centre_differential_locked_max(value - grid[k], 0.0);
}

#endif
