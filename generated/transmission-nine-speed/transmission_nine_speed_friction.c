/*
 * transmission_nine_speed_friction.c: friction that sticks and slips, and shafts with backlash
 *
 * Emitted by ptgen 0.1.0 from transmission-nine-speed.toml (SHA-256 65236af78ec41a0c), template friction.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "transmission_nine_speed_friction.h"

#include <float.h>
#include <math.h>

#define REAL TRANSMISSION_NINE_SPEED_REAL

typedef transmission_nine_speed_real real;

enum { n = transmission_nine_speed_friction_elements };
enum { stride = (n + 3) / 4 * 4 };
enum { rows = stride };

/* Residuals below `rounding`, relative to what they are sums of, are rounding. */
static const real rounding = REAL(64.0) * DBL_EPSILON;
static const real smallest = DBL_MIN; /* nothing below has that many digits */
/* Pivots below this, relative to the diagonal, are rounding. */
static const real no_pivot = REAL(8.0) * DBL_EPSILON;

static real clip(real value, real lo, real hi) { return value < lo ? lo : (value > hi ? hi : value); }

/* r = w - K T, and how much of it may be rounding. Runs over the padding as well, four rows at a time. */
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

/* Makes the sizes those of the largest row, in the unit of each: dependent rows know each other's rounding only. */
static void level(const real *K, real factor, real *size)
{
    real largest = 0.0;
    for (int i = 0; i < n; ++i) {
        largest = transmission_nine_speed_max(largest, size[i] / sqrt(K[i * stride + i]));
    }
    for (int i = 0; i < n; ++i) {
        size[i] = factor * largest * sqrt(K[i * stride + i]);
    }
}

/* Whether residuals are left of no element, of elements inside their bounds only, or of some at a bound. */
enum verdict { solved, inside, at_bound };

static enum verdict what_is_left(const real *lo, const real *hi, const real *T, const real *r, const real *size)
{
    enum verdict verdict = solved;
    for (int i = 0; i < n; ++i) {
        if (lo[i] < hi[i] && ((T[i] < hi[i] && r[i] > size[i]) || (T[i] > lo[i] && r[i] < -size[i]))) {
            verdict = T[i] > lo[i] && T[i] < hi[i] && verdict != at_bound ? inside : at_bound;
        }
    }
    return verdict;
}

/* A problem, and the work done on it. */
typedef struct {
    const real *H;
    const real *c;
    const real *lo;
    const real *hi;
    real pivot; /* smaller ones, relative to the diagonal, are none */
    int work;
} box;

/* Rounding of matrices of dependent elements, as a multiple of that of residuals. */
static const real dependence = REAL(1024.0) / REAL(64.0);

enum { factorisations = 12 + 4 * n };
/* After this many, minima are solved for as changes: what hung between rounding of two faces does so no more. */
enum { patience = 6 };

/* T + change, and zero where that is rounding. */
static real sum_of(real T, real change)
{
    const real sum = T + change;
    return fabs(sum) <= REAL(4.0) * DBL_EPSILON * fabs(T) ? 0.0 : sum;
}

/* Minimises over one torque after the other, and updates the residual. */
static void sweep(const box *b, real *T, real *r)
{
    for (int i = 0; i < n; ++i) {
        const real target = clip(sum_of(T[i], r[i] / b->H[i * stride + i]), b->lo[i], b->hi[i]);
        const real change = target - T[i];
        T[i] = target;
        for (int k = 0; k < n; ++k) {
            r[k] -= b->H[i * stride + k] * change;
        }
    }
}

/* r = c - H T */
static void unbalanced(const box *b, const real *T, real *r)
{
    real sum[stride];
    for (int i = 0; i < stride; ++i) {
        sum[i] = i < n ? b->c[i] : 0.0;
    }
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < stride; ++i) {
            sum[i] -= b->H[j * stride + i] * T[j];
        }
    }
    for (int i = 0; i < n; ++i) {
        r[i] = sum[i];
    }
}

/* Solves H d = r on the `count` elements listed in `free`; fails if H is singular there, to `rounding` of the diagonal. */
static int solve_free(const real *H, int count, const int *free, real rounding, const real *r, real *d)
{
    real A[n * n], y[n], inverse[n];
    for (int j = 0; j < count; ++j) {
        const real *column = H + free[j] * stride;
        for (int i = j; i < count; ++i) {
            A[j * n + i] = column[free[i]];
        }
        y[j] = r[free[j]];
        inverse[j] = rounding * column[free[j]]; /* what the pivot has to exceed */
    }
    for (int j = 0; j < count; ++j) {
        const real *column = A + j * n;
        if (!(column[j] > inverse[j])) {
            return 0;
        }
        inverse[j] = 1.0 / column[j];
        for (int i = j + 1; i < count; ++i) {
            const real factor = column[i] * inverse[j];
            y[i] -= factor * y[j];
            for (int k = i; k < count; ++k) {
                A[i * n + k] -= factor * column[k];
            }
        }
    }
    for (int i = 0; i < n; ++i) {
        d[i] = 0.0;
    }
    for (int j = count - 1; j >= 0; --j) {
        for (int i = j + 1; i < count; ++i) {
            y[j] -= A[j * n + i] * y[i];
        }
        y[j] *= inverse[j];
        d[free[j]] = y[j];
    }
    return 1;
}

/*
 * Whether the elements that may hold something hold independent motions; the others have their torques already. Those
 * strictly inside their bounds are known to be independent, as T was solved for.
 */
static int is_unique(const box *b, const real *T)
{
    int free[n];
    real none[n], d[n];
    int count = 0;
    int inside = 1;
    for (int i = 0; i < n; ++i) {
        none[i] = 0.0;
        if (b->lo[i] < b->hi[i]) {
            free[count++] = i;
            inside = inside && b->lo[i] < T[i] && T[i] < b->hi[i];
        }
    }
    return inside || solve_free(b->H, count, free, b->pivot, none, d);
}

/* By how much the function falls from T to `end`. */
static real lowered(const box *b, const real *T, const real *end, const real *r)
{
    real change[n];
    real bend[stride] = { 0.0 };
    real fall = 0.0;
    for (int j = 0; j < n; ++j) {
        change[j] = end[j] - T[j];
        for (int i = 0; i < stride; ++i) {
            bend[i] += b->H[j * stride + i] * change[j];
        }
    }
    for (int i = 0; i < n; ++i) {
        fall += change[i] * (r[i] - REAL(0.5) * bend[i]);
    }
    return fall;
}

/*
 * Goes to the minimum on the face of the free elements, or to where the face ends. Returns 1 at the minimum, -1 on failure.
 * The minimum is solved for as a whole, or, to take rounding off, as the change from T.
 */
static int face_step(const box *b, int change_only, real *T, int *count, int *free)
{
    real r[n], d[n], from[n], whole[n], part[n];
    int first = -1;
    real least = 0.0;
    for (int i = 0; i < n; ++i) {
        from[i] = T[i];
        whole[i] = T[i];
    }
    for (int k = 0; k < *count && !change_only; ++k) {
        from[free[k]] = 0.0;
    }
    unbalanced(b, from, r);
    if (!solve_free(b->H, *count, free, b->pivot, r, d)) {
        return -1;
    }
    for (int k = 0; k < *count; ++k) {
        const int i = free[k];
        const real target = change_only ? sum_of(T[i], d[i]) : d[i];
        d[i] = target - T[i];
        whole[i] = clip(target, b->lo[i], b->hi[i]);
        if (target < b->lo[i] || target > b->hi[i]) {
            const real room = (whole[i] - T[i]) / d[i];
            if (first < 0 || room < least) {
                first = i;
                least = room;
            }
        }
    }
    const real *next = whole;
    if (first >= 0) {
        for (int i = 0; i < n; ++i) {
            part[i] = i == first ? whole[i] : clip(T[i] + least * d[i], b->lo[i], b->hi[i]);
        }
        unbalanced(b, T, r);
        next = lowered(b, T, whole, r) > lowered(b, T, part, r) ? whole : part;
    }
    for (int i = 0; i < n; ++i) {
        T[i] = next[i];
    }
    if (first < 0) {
        return 1;
    }
    int left = 0;
    for (int k = 0; k < *count; ++k) {
        const int i = free[k];
        if (T[i] > b->lo[i] && T[i] < b->hi[i]) {
            free[left++] = i;
        }
    }
    *count = left;
    return 0;
}

/* The minimum over the box; returns whether it was reached within the allowed work. */
static int descend(box *b, real *T, real *r, real *size)
{
    const int start = b->work;
    int refining = 0;
    for (;;) {
        int free[n];
        int count = 0;
        for (int i = 0; i < n; ++i) {
            if (T[i] > b->lo[i] && T[i] < b->hi[i]) {
                free[count++] = i;
            }
        }
        const int corner = count == 0;
        while (count > 0) {
            ++b->work;
            const int reached = face_step(b, refining || b->work - start > patience, T, &count, free);
            if (reached < 0) {
                return 0;
            }
            if (reached) {
                break;
            }
        }
        residual(b->H, b->c, T, r, size);
        const enum verdict verdict = what_is_left(b->lo, b->hi, T, r, size);
        if (verdict == solved) {
            return 1;
        }
        b->work += corner; /* a sweep that ends in a corner counts as well */
        if (b->work - start >= factorisations) {
            return 0;
        }
        refining = verdict == inside && !refining;
        if (!refining) {
            sweep(b, T, r);
        }
    }
}

/* The torques of least norm by the method of multipliers: the velocities that are left are added to w, and again. */
static int least_norm(box *b, int deficient, const real *K, const real *w, real *T, real *r, real *size)
{
    const real large = sqrt(DBL_EPSILON);
    const real least = REAL(16.0) * DBL_EPSILON;
    const real middle = sqrt(large * least);
    const real shifts[] = { large, large, large, large, middle, middle, least, least, least, least };
    const int passes = (int)(sizeof shifts / sizeof shifts[0]);
    real H[n * stride], c[n], added[n];
    int found = 0;
    for (int k = 0; k < n * stride; ++k) {
        H[k] = K[k];
    }
    for (int i = 0; i < n; ++i) {
        added[i] = 0.0;
    }
    b->H = H;
    b->c = c;
    for (int pass = 0; pass < passes && !found; ++pass) {
        const real relative = shifts[pass] / shifts[pass > 0 ? pass - 1 : 0];
        for (int i = 0; i < n; ++i) {
            H[i * stride + i] = K[i * stride + i] + shifts[pass] * K[i * stride + i];
            added[i] *= relative; /* it is of the size of the shift of K times T */
            c[i] = w[i] + added[i];
        }
        (void)descend(b, T, r, size);
        residual(K, w, T, r, size);
        found = what_is_left(b->lo, b->hi, T, r, size) == solved;
        if (!found && deficient && pass >= 3) {
            level(K, pass < passes - 1 ? 1.0 : dependence, size);
            found = what_is_left(b->lo, b->hi, T, r, size) == solved;
        }
        for (int i = 0; i < n; ++i) {
            added[i] += r[i];
        }
    }
    return found;
}

/* As transmission_nine_speed_solve_box; tells too how much of the velocities may be rounding. */
static int solve(int deficient, const real *K, const real *w, const real *lo, const real *hi, real *T, real *w_plus, real *size)
{
    real r[n];
    int work = 0;
    box b = { .H = K, .c = w, .lo = lo, .hi = hi, .pivot = no_pivot, .work = 0 };
    int decided = 1;
    for (int i = 0; i < n; ++i) {
        T[i] = clip(T[i], lo[i], hi[i]);
        decided = decided && lo[i] == hi[i];
    }
    if (decided) {
        residual(K, w, T, r, size);
    } else {
        b.pivot = deficient ? sqrt(DBL_EPSILON) : no_pivot;
        int found = descend(&b, T, r, size) && (!deficient || is_unique(&b, T));
        b.pivot = no_pivot;
        found = found || least_norm(&b, deficient, K, w, T, r, size);
        if (!found) { /* from where that ended */
            b.H = K;
            b.c = w;
            found = descend(&b, T, r, size);
        }
        if (!found) { /* a residual that other rows cannot tell from rounding */
            residual(K, w, T, r, size);
            level(K, dependence, size);
            found = what_is_left(lo, hi, T, r, size) == solved;
        }
        work = found ? b.work : -1;
    }
    rates(lo, hi, T, r, size, w_plus);
    return work;
}

int transmission_nine_speed_solve_box(int deficient, const real *K, const real *w, const real *lo, const real *hi, real *T, real *w_plus)
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
        sign[i] = lo[i] < hi[i] && lo[i] != -slide[i] ? transmission_nine_speed_sign(rate[i]) : 0.0;
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
            start = transmission_nine_speed_min(start, REAL(0.5) - over / (over + under));
            known = 1;
        }
    }
    for (int i = 0; i < n; ++i) {
        /* what was held until then stays where it is */
        known = known && !(v[i] * (v[i] + start * moving[i]) < 0.0) && !(v[i] == 0.0 && moving[i] != 0.0);
    }
    return known ? start : 0.0;
}

void transmission_nine_speed_friction_step(int deficient, int one_way, const real *K, const real *w, const real *w_free, const real *slide,
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
        const int sound = slide[i] >= 0.0 && rest[i] >= 0.0 && transmission_nine_speed_is_finite(slide[i]) &&
            transmission_nine_speed_is_finite(rest[i]);
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
            duration = transmission_nine_speed_min(duration, arrival[i]);
        }
        if (deficient) {
            real r[n];
            residual(K, slope, torque, r, size);
            level(K, 1.0, size);
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

enum { contacts = transmission_nine_speed_contacts };
enum { contact_stride = (contacts + 3) / 4 * 4 };
enum { sweeps = contacts > 1 ? 12 : 1 };

/* e_plus + kappa T - e_free for an end of the gap; it grows with e_plus. */
static real left_at(real end, real e, real e_free, real kappa, real p, real c, real d)
{
    const real change = end - e;
    const real mean = change == 0.0 ? 0.0 : -REAL(0.5) * c * p * p / change;
    return end + kappa * (mean - d * p) - e_free;
}

/* One shaft: on each side of the gap, and inside, the equation is quadratic. */
static real contact_torque(real kappa, real e, real e_free, real b, real c, real d)
{
    const real p = e - transmission_nine_speed_clamp(e, b);
    const int side = left_at(b, e, e_free, kappa, p, c, d) < 0.0 ? 1 : (left_at(-b, e, e_free, kappa, p, c, d) > 0.0 ? -1 : 0);
    const int same = side != 0 && p * (real)side > 0.0;
    const real outside = side != 0 ? 1.0 : 0.0;
    const real alpha = side != 0 ? e - (real)side * b : 0.0; /* beyond the gap at the end: alpha + outside * change */
    const real a2 = 1.0 + outside * kappa * (d + REAL(0.5) * c);
    const real a1 = e - e_free + kappa * (d * (alpha - p) + c * alpha * outside);
    const real a0 = REAL(0.5) * kappa * c * (alpha * alpha - p * p);
    real change;
    if (same) {
        change = -a1 / a2;
    } else if (side == 0 && p == 0.0) {
        change = e_free - e;
    } else {
        /* of the two roots the one on the side of the motion; the other one belongs to another piece of p */
        const real root = sqrt(transmission_nine_speed_max(a1 * a1 - REAL(4.0) * a2 * a0, 0.0));
        const int upward = side == 0 ? p < 0.0 : side > 0;
        change = (upward ? -a1 + root : -a1 - root) / (REAL(2.0) * a2);
    }
    const real beyond = alpha + outside * change;
    const real secant = same ? 1.0 : (change == 0.0 ? 0.0 : (beyond - p) / change);
    return REAL(0.5) * c * (beyond + p) * secant + d * (beyond - p);
}

void transmission_nine_speed_backlash_step(const real *kappa, const real *e, const real *e_free, const real *half_gap, const real *stiffness,
    const real *damping, real *T)
{
    for (int i = 0; i < contacts; ++i) {
        T[i] = 0.0;
    }
    int moves = 1;
    for (int k = 0; k < sweeps && moves; ++k) { /* a sweep that changes nothing is the last that could */
        moves = 0;
        for (int i = 0; i < contacts; ++i) {
            const real before = T[i];
            real alone = e_free[i];
            for (int j = 0; j < contacts; ++j) {
                alone -= j == i ? 0.0 : kappa[j * contact_stride + i] * T[j];
            }
            T[i] = contact_torque(kappa[i * contact_stride + i], e[i], alone, half_gap[i], stiffness[i], damping[i]);
            moves |= transmission_nine_speed_abs(T[i] - before) > 0.0;
        }
    }
}
