/*
 * shift_rig_support.h: arithmetic and small dense algebra
 *
 * Emitted by ptgen 0.1.0 from shift-rig.toml (SHA-256 627f699c509849a3), template support.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef SHIFT_RIG_SUPPORT_H
#define SHIFT_RIG_SUPPORT_H

#include <math.h>
#include <stddef.h>

typedef double shift_rig_real;

#define SHIFT_RIG_REAL(x) ((shift_rig_real)(x))

/* Order up to which shift_rig_discretise works: states, inputs and friction elements together. */
#define SHIFT_RIG_MAX_ORDER 22

static inline shift_rig_real shift_rig_min(shift_rig_real a, shift_rig_real b) { return a < b ? a : b; }
static inline shift_rig_real shift_rig_max(shift_rig_real a, shift_rig_real b) { return a > b ? a : b; }
static inline shift_rig_real shift_rig_abs(shift_rig_real a) { return fabs(a); }
/* Both are computed before, so that a step takes nearly the same time whichever is chosen. */
static inline shift_rig_real shift_rig_select(int condition, shift_rig_real a, shift_rig_real b)
{
    return condition ? a : b;
}
static inline shift_rig_real shift_rig_sign(shift_rig_real a)
{
    return a > 0.0 ? 1.0 : (a < 0.0 ? -1.0 : 0.0);
}
/* False for NaN and infinity; needs no library function. */
static inline int shift_rig_is_finite(shift_rig_real a) { return a - a == 0.0; }
static inline shift_rig_real shift_rig_clamp(shift_rig_real value, shift_rig_real bound)
{
    return shift_rig_max(-bound, shift_rig_min(bound, value));
}

shift_rig_real shift_rig_floor(shift_rig_real a);
shift_rig_real shift_rig_exp(shift_rig_real a);
shift_rig_real shift_rig_sin(shift_rig_real a);
shift_rig_real shift_rig_sqrt(shift_rig_real a);

/* Number of rows that n rows take in memory. */
static inline int shift_rig_padded(int n) { return (n + 3) / 4 * 4; }

/* Sets an array of `bytes` bytes to zero. */
void shift_rig_zero(size_t bytes, void *array);

/*
 * Matrices are stored by columns; the number of rows in memory is rounded up to a multiple of four.
 * Functions that return an int return 1 on success and 0 on failure.
 */

/* Solves M X = R for symmetric positive definite M (n, n); M is overwritten by its Cholesky factor. */
int shift_rig_cholesky_solve(int n, int columns, shift_rig_real *M, const shift_rig_real *R, shift_rig_real *X);

/* Whether the symmetric matrix K (n, n) is positive definite, or, if asked for, at least semidefinite. */
int shift_rig_require_definite(int n, int semidefinite, const shift_rig_real *K);

/* Share of a sum of a few numbers that may be rounding. */
void shift_rig_rounding_unit(shift_rig_real *share);

/* Copies `count` columns of `source` (rows, .), from column `first` on, to (row, column) of `target`. */
void shift_rig_insert(int rows, int target_stride, int source_stride, int row, int column, int first, int count,
    shift_rig_real *target, const shift_rig_real *source);

/* C = A - B, all (rows, columns). */
void shift_rig_difference(int rows, int columns, const shift_rig_real *A, const shift_rig_real *B, shift_rig_real *C);

/*
 * First n rows of exp(A t), A (n, total) over zero rows, balanced by `scale` (total): Taylor series of degree
 * 18 with `squarings` squarings. Fails if the argument is too large for them.
 */
int shift_rig_discretise(int n, int total, int squarings, const shift_rig_real *A, const shift_rig_real *scale,
    shift_rig_real t, shift_rig_real *E);

/*
 * y = A x for A (n, m); runs over four rows and two columns at a time, the padding included: eight independent sums
 * keep the processor busy where one would wait for each addition.
 */
static inline void shift_rig_multiply(int n, int m, const shift_rig_real *restrict A, const shift_rig_real *restrict x,
    shift_rig_real *restrict y)
{
    const int rows = shift_rig_padded(n);
    for (int i = 0; i < rows; i += 4) {
        const shift_rig_real *a = A + i;
        shift_rig_real s0 = 0.0, s1 = 0.0, s2 = 0.0, s3 = 0.0;
        shift_rig_real t0 = 0.0, t1 = 0.0, t2 = 0.0, t3 = 0.0;
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
static inline void shift_rig_add_product(int n, int m, shift_rig_real *restrict y, const shift_rig_real *restrict x,
    const shift_rig_real *restrict A, const shift_rig_real *restrict T)
{
    const int rows = shift_rig_padded(n);
    int i = 0;
    for (; i + 4 <= n; i += 4) { /* y may be longer than n and has no padding */
        const shift_rig_real *a = A + i;
        shift_rig_real s0 = x[i], s1 = x[i + 1], s2 = x[i + 2], s3 = x[i + 3];
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
        shift_rig_real sum = x[i];
        for (int j = 0; j < m; ++j) {
            sum += A[j * rows + i] * T[j];
        }
        y[i] = sum;
    }
}

/* Pushes `value` into a delay line; `late` is the value of `steps` steps ago, `early` the one of a step before. */
static inline void shift_rig_delay(int capacity, shift_rig_real *line, shift_rig_real value, shift_rig_real steps,
    shift_rig_real *late, shift_rig_real *early)
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
static inline void shift_rig_guard(shift_rig_real value, shift_rig_real bound, shift_rig_real before, shift_rig_real *held,
    shift_rig_real *sound)
{
    const int good = shift_rig_abs(value) <= bound; /* false for NaN */
    *held = shift_rig_select(good, value, before);
    *sound = shift_rig_select(good, 1.0, 0.0);
}

/* For how long a signal was not sound: a sound step takes back a bad one. No more than `allowed` and a step is counted. */
static inline void shift_rig_lasting(shift_rig_real sound, shift_rig_real time, shift_rig_real step, shift_rig_real allowed,
    shift_rig_real *after)
{
    const shift_rig_real counted = shift_rig_min(time, allowed);
    *after = shift_rig_select(sound > 0.5, shift_rig_max(counted, step) - step, counted + step);
}

/* For how long `value` has been the same to the last bit. */
static inline void shift_rig_still(shift_rig_real value, shift_rig_real before, shift_rig_real time, shift_rig_real step,
    shift_rig_real *after)
{
    *after = shift_rig_select(shift_rig_abs(value - before) <= 0.0, time + step, 0.0);
}

/* The side on which `value` last was beyond `limit` (-1, 0, 1), and the count of changes, less `decay`. */
static inline void shift_rig_swings(shift_rig_real value, shift_rig_real limit, shift_rig_real side, shift_rig_real count,
    shift_rig_real decay, shift_rig_real *after, shift_rig_real *swings)
{
    const shift_rig_real above = shift_rig_select(value > limit, 1.0, side);
    const shift_rig_real now = shift_rig_select(value < -limit, -1.0, above);
    *after = now;
    *swings = shift_rig_max(count - decay, 0.0) + shift_rig_min(shift_rig_abs(now - side), 1.0);
}

/* `value` limited to 0 to 1; 0 for NaN. */
static inline void shift_rig_share(shift_rig_real value, shift_rig_real *limited)
{
    *limited = shift_rig_min(shift_rig_max(value, 0.0), 1.0);
}

/*
 * Function that is linear between the n increasing points of `grid` and constant beyond them: from grid[k] on it is
 * level[k] + slope[k] * (value - grid[k]); slope[n - 1] is zero. Bisection without branches: always the same time.
 */
static inline void shift_rig_lookup(int n, shift_rig_real value, const shift_rig_real *grid, const shift_rig_real *slope,
    const shift_rig_real *level, shift_rig_real *result)
{
    const shift_rig_real *at = grid;
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
    *result = level[k] + slope[k] * shift_rig_max(value - grid[k], 0.0);
}

#endif
