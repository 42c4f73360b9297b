/*
 * transmission_nine_speed_support.h: arithmetic and small dense algebra
 *
 * Emitted by ptgen 0.1.0 from transmission-nine-speed.toml (SHA-256 65236af78ec41a0c), template support.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef TRANSMISSION_NINE_SPEED_SUPPORT_H
#define TRANSMISSION_NINE_SPEED_SUPPORT_H

#include <math.h>
#include <stddef.h>

typedef double transmission_nine_speed_real;

#define TRANSMISSION_NINE_SPEED_REAL(x) ((transmission_nine_speed_real)(x))

/* Order up to which transmission_nine_speed_discretise works: states, inputs and friction elements together. */
#define TRANSMISSION_NINE_SPEED_MAX_ORDER 28

static inline transmission_nine_speed_real transmission_nine_speed_min(transmission_nine_speed_real a, transmission_nine_speed_real b) { return a < b ? a : b; }
static inline transmission_nine_speed_real transmission_nine_speed_max(transmission_nine_speed_real a, transmission_nine_speed_real b) { return a > b ? a : b; }
static inline transmission_nine_speed_real transmission_nine_speed_abs(transmission_nine_speed_real a) { return fabs(a); }
/* Both are computed before, so that a step takes nearly the same time whichever is chosen. */
static inline transmission_nine_speed_real transmission_nine_speed_select(int condition, transmission_nine_speed_real a, transmission_nine_speed_real b)
{
    return condition ? a : b;
}
static inline transmission_nine_speed_real transmission_nine_speed_sign(transmission_nine_speed_real a)
{
    return a > 0.0 ? 1.0 : (a < 0.0 ? -1.0 : 0.0);
}
/* False for NaN and infinity; needs no library function. */
static inline int transmission_nine_speed_is_finite(transmission_nine_speed_real a) { return a - a == 0.0; }
static inline transmission_nine_speed_real transmission_nine_speed_clamp(transmission_nine_speed_real value, transmission_nine_speed_real bound)
{
    return transmission_nine_speed_max(-bound, transmission_nine_speed_min(bound, value));
}

transmission_nine_speed_real transmission_nine_speed_floor(transmission_nine_speed_real a);
transmission_nine_speed_real transmission_nine_speed_exp(transmission_nine_speed_real a);
transmission_nine_speed_real transmission_nine_speed_sin(transmission_nine_speed_real a);
transmission_nine_speed_real transmission_nine_speed_sqrt(transmission_nine_speed_real a);

/* Number of rows that n rows take in memory. */
static inline int transmission_nine_speed_padded(int n) { return (n + 3) / 4 * 4; }

/* Sets an array of `bytes` bytes to zero. */
void transmission_nine_speed_zero(size_t bytes, void *array);

/*
 * Matrices are stored by columns; the number of rows in memory is rounded up to a multiple of four.
 * Functions that return an int return 1 on success and 0 on failure.
 */

/* Solves M X = R for symmetric positive definite M (n, n); M is overwritten by its Cholesky factor. */
int transmission_nine_speed_cholesky_solve(int n, int columns, transmission_nine_speed_real *M, const transmission_nine_speed_real *R, transmission_nine_speed_real *X);

/* Whether the symmetric matrix K (n, n) is positive definite, or, if asked for, at least semidefinite. */
int transmission_nine_speed_require_definite(int n, int semidefinite, const transmission_nine_speed_real *K);

/* Share of a sum of a few numbers that may be rounding. */
void transmission_nine_speed_rounding_unit(transmission_nine_speed_real *share);

/* Copies `count` columns of `source` (rows, .), from column `first` on, to (row, column) of `target`. */
void transmission_nine_speed_insert(int rows, int target_stride, int source_stride, int row, int column, int first, int count,
    transmission_nine_speed_real *target, const transmission_nine_speed_real *source);

/* C = A - B, all (rows, columns). */
void transmission_nine_speed_difference(int rows, int columns, const transmission_nine_speed_real *A, const transmission_nine_speed_real *B, transmission_nine_speed_real *C);

/*
 * First n rows of exp(A t), A (n, total) over zero rows, balanced by `scale` (total): Taylor series of degree
 * 18 with `squarings` squarings. Fails if the argument is too large for them.
 */
int transmission_nine_speed_discretise(int n, int total, int squarings, const transmission_nine_speed_real *A, const transmission_nine_speed_real *scale,
    transmission_nine_speed_real t, transmission_nine_speed_real *E);

/*
 * y = A x for A (n, m); runs over four rows and two columns at a time, the padding included: eight independent sums
 * keep the processor busy where one would wait for each addition.
 */
static inline void transmission_nine_speed_multiply(int n, int m, const transmission_nine_speed_real *restrict A, const transmission_nine_speed_real *restrict x,
    transmission_nine_speed_real *restrict y)
{
    const int rows = transmission_nine_speed_padded(n);
    for (int i = 0; i < rows; i += 4) {
        const transmission_nine_speed_real *a = A + i;
        transmission_nine_speed_real s0 = 0.0, s1 = 0.0, s2 = 0.0, s3 = 0.0;
        transmission_nine_speed_real t0 = 0.0, t1 = 0.0, t2 = 0.0, t3 = 0.0;
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
static inline void transmission_nine_speed_add_product(int n, int m, transmission_nine_speed_real *restrict y, const transmission_nine_speed_real *restrict x,
    const transmission_nine_speed_real *restrict A, const transmission_nine_speed_real *restrict T)
{
    const int rows = transmission_nine_speed_padded(n);
    int i = 0;
    for (; i + 4 <= n; i += 4) { /* y may be longer than n and has no padding */
        const transmission_nine_speed_real *a = A + i;
        transmission_nine_speed_real s0 = x[i], s1 = x[i + 1], s2 = x[i + 2], s3 = x[i + 3];
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
        transmission_nine_speed_real sum = x[i];
        for (int j = 0; j < m; ++j) {
            sum += A[j * rows + i] * T[j];
        }
        y[i] = sum;
    }
}

/* Pushes `value` into a delay line; `late` is the value of `steps` steps ago, `early` the one of a step before. */
static inline void transmission_nine_speed_delay(int capacity, transmission_nine_speed_real *line, transmission_nine_speed_real value, transmission_nine_speed_real steps,
    transmission_nine_speed_real *late, transmission_nine_speed_real *early)
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
static inline void transmission_nine_speed_guard(transmission_nine_speed_real value, transmission_nine_speed_real bound, transmission_nine_speed_real before, transmission_nine_speed_real *held,
    transmission_nine_speed_real *sound)
{
    const int good = transmission_nine_speed_abs(value) <= bound; /* false for NaN */
    *held = transmission_nine_speed_select(good, value, before);
    *sound = transmission_nine_speed_select(good, 1.0, 0.0);
}

/* For how long a signal was not sound: a sound step takes back a bad one. No more than `allowed` and a step is counted. */
static inline void transmission_nine_speed_lasting(transmission_nine_speed_real sound, transmission_nine_speed_real time, transmission_nine_speed_real step, transmission_nine_speed_real allowed,
    transmission_nine_speed_real *after)
{
    const transmission_nine_speed_real counted = transmission_nine_speed_min(time, allowed);
    *after = transmission_nine_speed_select(sound > 0.5, transmission_nine_speed_max(counted, step) - step, counted + step);
}

/* For how long `value` has been the same to the last bit. */
static inline void transmission_nine_speed_still(transmission_nine_speed_real value, transmission_nine_speed_real before, transmission_nine_speed_real time, transmission_nine_speed_real step,
    transmission_nine_speed_real *after)
{
    *after = transmission_nine_speed_select(transmission_nine_speed_abs(value - before) <= 0.0, time + step, 0.0);
}

/* The side on which `value` last was beyond `limit` (-1, 0, 1), and the count of changes, less `decay`. */
static inline void transmission_nine_speed_swings(transmission_nine_speed_real value, transmission_nine_speed_real limit, transmission_nine_speed_real side, transmission_nine_speed_real count,
    transmission_nine_speed_real decay, transmission_nine_speed_real *after, transmission_nine_speed_real *swings)
{
    const transmission_nine_speed_real above = transmission_nine_speed_select(value > limit, 1.0, side);
    const transmission_nine_speed_real now = transmission_nine_speed_select(value < -limit, -1.0, above);
    *after = now;
    *swings = transmission_nine_speed_max(count - decay, 0.0) + transmission_nine_speed_min(transmission_nine_speed_abs(now - side), 1.0);
}

/* `value` limited to 0 to 1; 0 for NaN. */
static inline void transmission_nine_speed_share(transmission_nine_speed_real value, transmission_nine_speed_real *limited)
{
    *limited = transmission_nine_speed_min(transmission_nine_speed_max(value, 0.0), 1.0);
}

/*
 * Function that is linear between the n increasing points of `grid` and constant beyond them: from grid[k] on it is
 * level[k] + slope[k] * (value - grid[k]); slope[n - 1] is zero. Bisection without branches: always the same time.
 */
static inline void transmission_nine_speed_lookup(int n, transmission_nine_speed_real value, const transmission_nine_speed_real *grid, const transmission_nine_speed_real *slope,
    const transmission_nine_speed_real *level, transmission_nine_speed_real *result)
{
    const transmission_nine_speed_real *at = grid;
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
    *result = level[k] + slope[k] * transmission_nine_speed_max(value - grid[k], 0.0);
}

#endif
