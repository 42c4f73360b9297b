/*
 * back_to_back_support.h: arithmetic and small dense algebra
 *
 * Emitted by ptgen 0.1.0 from back-to-back.toml (SHA-256 376363ff9555c6b9), template support.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef BACK_TO_BACK_SUPPORT_H
#define BACK_TO_BACK_SUPPORT_H

#include <math.h>
#include <stddef.h>

typedef double back_to_back_real;

#define BACK_TO_BACK_REAL(x) ((back_to_back_real)(x))

/* Order up to which back_to_back_discretise works: states, inputs and friction elements together. */
#define BACK_TO_BACK_MAX_ORDER 11

static inline back_to_back_real back_to_back_min(back_to_back_real a, back_to_back_real b) { return a < b ? a : b; }
static inline back_to_back_real back_to_back_max(back_to_back_real a, back_to_back_real b) { return a > b ? a : b; }
static inline back_to_back_real back_to_back_abs(back_to_back_real a) { return fabs(a); }
/* Both are computed before, so that a step takes nearly the same time whichever is chosen. */
static inline back_to_back_real back_to_back_select(int condition, back_to_back_real a, back_to_back_real b)
{
    return condition ? a : b;
}
static inline back_to_back_real back_to_back_sign(back_to_back_real a)
{
    return a > 0.0 ? 1.0 : (a < 0.0 ? -1.0 : 0.0);
}
/* False for NaN and infinity; needs no library function. */
static inline int back_to_back_is_finite(back_to_back_real a) { return a - a == 0.0; }
static inline back_to_back_real back_to_back_clamp(back_to_back_real value, back_to_back_real bound)
{
    return back_to_back_max(-bound, back_to_back_min(bound, value));
}

back_to_back_real back_to_back_floor(back_to_back_real a);
back_to_back_real back_to_back_exp(back_to_back_real a);
back_to_back_real back_to_back_sin(back_to_back_real a);
back_to_back_real back_to_back_sqrt(back_to_back_real a);

/* Number of rows that n rows take in memory. */
static inline int back_to_back_padded(int n) { return (n + 3) / 4 * 4; }

/* Sets an array of `bytes` bytes to zero. */
void back_to_back_zero(size_t bytes, void *array);

/*
 * Matrices are stored by columns; the number of rows in memory is rounded up to a multiple of four.
 * Functions that return an int return 1 on success and 0 on failure.
 */

/* Solves M X = R for symmetric positive definite M (n, n); M is overwritten by its Cholesky factor. */
int back_to_back_cholesky_solve(int n, int columns, back_to_back_real *M, const back_to_back_real *R, back_to_back_real *X);

/* Whether the symmetric matrix K (n, n) is positive definite, or, if asked for, at least semidefinite. */
int back_to_back_require_definite(int n, int semidefinite, const back_to_back_real *K);

/* Share of a sum of a few numbers that may be rounding. */
void back_to_back_rounding_unit(back_to_back_real *share);

/* Copies `count` columns of `source` (rows, .), from column `first` on, to (row, column) of `target`. */
void back_to_back_insert(int rows, int target_stride, int source_stride, int row, int column, int first, int count,
    back_to_back_real *target, const back_to_back_real *source);

/* C = A - B, all (rows, columns). */
void back_to_back_difference(int rows, int columns, const back_to_back_real *A, const back_to_back_real *B, back_to_back_real *C);

/*
 * First n rows of exp(A t), A (n, total) over zero rows, balanced by `scale` (total): Taylor series of degree
 * 18 with `squarings` squarings. Fails if the argument is too large for them.
 */
int back_to_back_discretise(int n, int total, int squarings, const back_to_back_real *A, const back_to_back_real *scale,
    back_to_back_real t, back_to_back_real *E);

/*
 * y = A x for A (n, m); runs over four rows and two columns at a time, the padding included: eight independent sums
 * keep the processor busy where one would wait for each addition.
 */
static inline void back_to_back_multiply(int n, int m, const back_to_back_real *restrict A, const back_to_back_real *restrict x,
    back_to_back_real *restrict y)
{
    const int rows = back_to_back_padded(n);
    for (int i = 0; i < rows; i += 4) {
        const back_to_back_real *a = A + i;
        back_to_back_real s0 = 0.0, s1 = 0.0, s2 = 0.0, s3 = 0.0;
        back_to_back_real t0 = 0.0, t1 = 0.0, t2 = 0.0, t3 = 0.0;
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
static inline void back_to_back_add_product(int n, int m, back_to_back_real *restrict y, const back_to_back_real *restrict x,
    const back_to_back_real *restrict A, const back_to_back_real *restrict T)
{
    const int rows = back_to_back_padded(n);
    int i = 0;
    for (; i + 4 <= n; i += 4) { /* y may be longer than n and has no padding */
        const back_to_back_real *a = A + i;
        back_to_back_real s0 = x[i], s1 = x[i + 1], s2 = x[i + 2], s3 = x[i + 3];
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
        back_to_back_real sum = x[i];
        for (int j = 0; j < m; ++j) {
            sum += A[j * rows + i] * T[j];
        }
        y[i] = sum;
    }
}

/* Pushes `value` into a delay line; `late` is the value of `steps` steps ago, `early` the one of a step before. */
static inline void back_to_back_delay(int capacity, back_to_back_real *line, back_to_back_real value, back_to_back_real steps,
    back_to_back_real *late, back_to_back_real *early)
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
static inline void back_to_back_guard(back_to_back_real value, back_to_back_real bound, back_to_back_real before, back_to_back_real *held,
    back_to_back_real *sound)
{
    const int good = back_to_back_abs(value) <= bound; /* false for NaN */
    *held = back_to_back_select(good, value, before);
    *sound = back_to_back_select(good, 1.0, 0.0);
}

/* For how long a signal was not sound: a sound step takes back a bad one. No more than `allowed` and a step is counted. */
static inline void back_to_back_lasting(back_to_back_real sound, back_to_back_real time, back_to_back_real step, back_to_back_real allowed,
    back_to_back_real *after)
{
    const back_to_back_real counted = back_to_back_min(time, allowed);
    *after = back_to_back_select(sound > 0.5, back_to_back_max(counted, step) - step, counted + step);
}

/* For how long `value` has been the same to the last bit. */
static inline void back_to_back_still(back_to_back_real value, back_to_back_real before, back_to_back_real time, back_to_back_real step,
    back_to_back_real *after)
{
    *after = back_to_back_select(back_to_back_abs(value - before) <= 0.0, time + step, 0.0);
}

/* The side on which `value` last was beyond `limit` (-1, 0, 1), and the count of changes, less `decay`. */
static inline void back_to_back_swings(back_to_back_real value, back_to_back_real limit, back_to_back_real side, back_to_back_real count,
    back_to_back_real decay, back_to_back_real *after, back_to_back_real *swings)
{
    const back_to_back_real above = back_to_back_select(value > limit, 1.0, side);
    const back_to_back_real now = back_to_back_select(value < -limit, -1.0, above);
    *after = now;
    *swings = back_to_back_max(count - decay, 0.0) + back_to_back_min(back_to_back_abs(now - side), 1.0);
}

/* `value` limited to 0 to 1; 0 for NaN. */
static inline void back_to_back_share(back_to_back_real value, back_to_back_real *limited)
{
    *limited = back_to_back_min(back_to_back_max(value, 0.0), 1.0);
}

/*
 * Function that is linear between the n increasing points of `grid` and constant beyond them: from grid[k] on it is
 * level[k] + slope[k] * (value - grid[k]); slope[n - 1] is zero. Bisection without branches: always the same time.
 */
static inline void back_to_back_lookup(int n, back_to_back_real value, const back_to_back_real *grid, const back_to_back_real *slope,
    const back_to_back_real *level, back_to_back_real *result)
{
    const back_to_back_real *at = grid;
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
    *result = level[k] + slope[k] * back_to_back_max(value - grid[k], 0.0);
}

#endif
