/*
 * shift_rig_one_clutch_friction.c: friction that sticks and slips, and shafts with backlash
 *
 * Emitted by ptgen 0.1.0 from shift-rig-one-clutch.toml (SHA-256 78ebad094db7f87a), template friction.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "shift_rig_one_clutch_friction.h"

#include <float.h>
#include <math.h>

#define REAL SHIFT_RIG_ONE_CLUTCH_REAL

typedef shift_rig_one_clutch_real real;

enum { n = shift_rig_one_clutch_friction_elements };
enum { stride = (n + 3) / 4 * 4 };
enum { rows = n };

/* Residuals below `rounding`, relative to what they are sums of, are rounding. */
static const real rounding = REAL(64.0) * DBL_EPSILON;
static const real smallest = DBL_MIN; /* nothing below has that many digits */

static real clip(real value, real lo, real hi) { return value < lo ? lo : (value > hi ? hi : value); }

/* r = w - K T, and how much of it may be rounding. */
static void residual(const real *K, const real *w, const real *T, real *r, real *size)
{
    real sum[rows], sizes[rows];
    for (int i = 0; i < rows; ++i) {
        sum[i] = i < n ? w[i] : 0.0;
        sizes[i] = fabs(sum[i]);
    }
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < rows; ++i) {
            const real share = K[j * stride + i] * T[j];
            sum[i] -= share;
            sizes[i] += fabs(share);
        }
    }
    for (int i = 0; i < n; ++i) {
        r[i] = sum[i];
        size[i] = rounding * sizes[i] + smallest;
    }
}

/* The velocities that are left: of the sign that the bounds allow, rounding taken off. */
static void rates(const real *lo, const real *hi, const real *T, const real *r, const real *size, real *w_plus)
{
    for (int i = 0; i < n; ++i) {
        const int held = fabs(r[i]) <= size[i] || (r[i] > 0.0 && T[i] < hi[i]) || (r[i] < 0.0 && T[i] > lo[i]);
        w_plus[i] = held ? 0.0 : r[i];
    }
}

/* As shift_rig_one_clutch_solve_box; tells too how much of the velocities may be rounding. */
static int solve(int deficient, const real *K, const real *w, const real *lo, const real *hi, real *T, real *w_plus, real *size)
{
    real r[n];
    int work = 0;
    (void)deficient;
    T[0] = clip(w[0] / K[0], lo[0], hi[0]);
    residual(K, w, T, r, size);
    rates(lo, hi, T, r, size, w_plus);
    return work;
}

int shift_rig_one_clutch_solve_box(int deficient, const real *K, const real *w, const real *lo, const real *hi, real *T, real *w_plus)
{
    real size[n];
    return solve(deficient, K, w, lo, hi, T, w_plus, size);
}

/* The torques that elements may have: one value in motion, an interval at rest. */
static void bounds(int one_way, const real *w, const real *slide, const real *rest, real *lo, real *hi)
{
    for (int i = 0; i < n; ++i) {
        if (w[i] != 0.0) {
            lo[i] = w[i] > 0.0 ? slide[i] : -slide[i];
            hi[i] = lo[i];
        } else {
            lo[i] = -rest[i];
            hi[i] = one_way >> i & 1 ? REAL(INFINITY) : rest[i];
        }
    }
}

/* Gives the elements that break away their capacity in motion; returns whether there are any. */
static int release(int one_way, const real *rate, const real *slide, real *lo, real *hi)
{
    int any = 0;
    for (int i = 0; i < n; ++i) {
        if (lo[i] < hi[i] && rate[i] != 0.0 && lo[i] != -slide[i]) {
            lo[i] = -slide[i];
            hi[i] = one_way >> i & 1 ? hi[i] : slide[i];
            any = 1;
        }
    }
    return any;
}

/*
 * When the first element broke away, in steps from the start of this one; not before the middle of the last one. The
 * torque that holds it was below its capacity there, and is above it in the middle of this step. `held` and `moving` are
 * torques and rates until then.
 */
static real broken_away(int deficient, const real *K, const real *slope, const real *v, const real *slide, const real *rest,
    const real *before, const real *rest_before, const real *rate, real *lo, real *hi, real *held, real *moving, real *size)
{
    real sign[n];
    int any = 0;
    for (int i = 0; i < n; ++i) {
        sign[i] = lo[i] < hi[i] && lo[i] != -slide[i] ? shift_rig_one_clutch_sign(rate[i]) : 0.0;
        if (sign[i] != 0.0) {
            any = 1;
            lo[i] = -REAL(INFINITY);
            hi[i] = REAL(INFINITY);
        }
    }
    if (!any) {
        return 0.0;
    }
    (void)solve(deficient, K, slope, lo, hi, held, moving, size);
    real start = REAL(0.5);
    int known = 0;
    for (int i = 0; i < n; ++i) {
        const real over = sign[i] * held[i] - rest[i];
        const real under = rest_before[i] - sign[i] * before[i];
        if (sign[i] != 0.0 && rest_before[i] > 0.0 && over > 0.0 && under >= 0.0) {
            start = shift_rig_one_clutch_min(start, REAL(0.5) - over / (over + under));
            known = 1;
        }
    }
    for (int i = 0; i < n; ++i) {
        /* what was held until then stays where it is */
        known = known && !(v[i] * (v[i] + start * moving[i]) < 0.0) && !(v[i] == 0.0 && moving[i] != 0.0);
    }
    return known ? start : 0.0;
}

void shift_rig_one_clutch_friction_step(int deficient, int one_way, const real *K, const real *w, const real *w_free, const real *slide,
    const real *rest, real *torque, real *rest_before, real *mean, real *w_plus, real *status)
{
    real moving[n], standing[n], before[n], slope[n], rate[n], size[n], v[n], lo[n], hi[n];
    real left = 1.0;
    int found = 1;
    int stopped = 0;
    *status = 0.0;
    if (!(K[0] > 0.0)) { /* never prepared */
        for (int i = 0; i < n; ++i) {
            torque[i] = 0.0;
            mean[i] = 0.0;
            rest_before[i] = rest[i];
            w_plus[i] = w_free[i];
        }
        *status = REAL(-1.0);
        return;
    }
    for (int i = n - 1; i >= 0; --i) {
        /* false for NaN and infinity */
        const int sound = slide[i] >= 0.0 && rest[i] >= 0.0 && shift_rig_one_clutch_is_finite(slide[i]) &&
            shift_rig_one_clutch_is_finite(rest[i]);
        moving[i] = sound ? slide[i] : 0.0;
        standing[i] = sound ? rest[i] : 0.0;
        if (!sound) {
            *status = REAL(i + 1);
        }
        slope[i] = w_free[i] - w[i];
        v[i] = w[i];
        before[i] = torque[i];
        mean[i] = 0.0;
        /* only a change of the state from outside can leave a one-way element with a positive velocity */
        stopped = stopped || ((one_way >> i & 1) && w[i] > 0.0);
    }
    for (int piece = 0; piece < 2 * n && !stopped; ++piece) {
        bounds(one_way, v, moving, standing, lo, hi);
        found = solve(deficient, K, slope, lo, hi, torque, rate, size) >= 0 && found;
        if (piece == 0) {
            real lowest[n], highest[n], held[n], going[n];
            for (int i = 0; i < n; ++i) {
                lowest[i] = lo[i];
                highest[i] = hi[i];
                held[i] = torque[i];
            }
            const real start = broken_away(deficient, K, slope, v, moving, standing, before, rest_before, rate, lowest, highest,
                held, going, size);
            if (start != 0.0) {
                for (int i = 0; i < n; ++i) {
                    mean[i] = start * held[i];
                    v[i] += start * going[i];
                }
                left -= start;
            }
        }
        while (release(one_way, rate, moving, lo, hi)) {
            found = solve(deficient, K, slope, lo, hi, torque, rate, size) >= 0 && found;
        }
        real arrival[n];
        real duration = left;
        for (int i = 0; i < n; ++i) {
            arrival[i] = v[i] * rate[i] < 0.0 ? -v[i] / rate[i] : REAL(INFINITY);
            duration = shift_rig_one_clutch_min(duration, arrival[i]);
        }
        for (int i = 0; i < n; ++i) {
            const real end = v[i] + duration * rate[i];
            /* what is zero but for rounding gets there together, as elements do that hold the same motion */
            const int reached = arrival[i] <= duration || fabs(end) <= rounding * fabs(v[i]) + duration * size[i];
            mean[i] += duration * torque[i];
            v[i] = reached ? 0.0 : end;
        }
        left -= duration;
        if (!(left > 0.0)) {
            break;
        }
    }
    if (left > 0.0) { /* the rest of the step at once */
        for (int i = 0; i < n; ++i) {
            lo[i] = v[i] == 0.0 ? -standing[i] : -moving[i];
            hi[i] = one_way >> i & 1 ? REAL(INFINITY) : -lo[i];
            slope[i] += v[i] / left;
        }
        found = solve(deficient, K, slope, lo, hi, torque, rate, size) >= 0 && found;
        for (int i = 0; i < n; ++i) {
            mean[i] += left * torque[i];
            v[i] = left * rate[i];
        }
    }
    for (int i = 0; i < n; ++i) {
        w_plus[i] = v[i];
        rest_before[i] = rest[i];
    }
    if (!found) {
        *status = REAL(-1.0);
    }
}
