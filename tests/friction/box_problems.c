/*
 * Random box problems for the emitted solver, and checks of its answers that share nothing with it.
 *
 * The friction code is included, so that its parts can be looked into; `n` and `stride` are its numbers. Matrices are
 * stored by columns with `stride` rows.
 */
#include "box_friction.c"

#include <stdint.h>
#include <string.h>

/* In this order in box_problems.py. */
enum kind {
    regular,     /* bodies between rough and smooth elements, inertias over six decades */
    conditioned, /* eigenvalues, scaled, from 1 up */
    lopsided,    /* inertias over twelve decades */
    near,        /* one direction that next to nothing resists, down to rounding */
    gears,       /* fewer degrees of freedom than elements */
    degenerate,  /* small whole numbers: solutions on borders of sectors, ties */
    unflagged,   /* gears, but not announced as dependent */
    flagged,     /* regular, but announced as dependent */
    kinds
};

typedef struct {
    double K[n * stride], w[n], lo[n], hi[n], guess[n];
    double null[n * n]; /* basis of the null space of K, by columns of n */
    int32_t nullity;
    int32_t deficient; /* what the solver is told */
    int32_t dependent; /* as far as numbers can tell, or the solver is told so */
} problem;

typedef struct {
    int64_t problems;
    int64_t failures;
    int64_t first_failure; /* number of the problem, or -1 */
    int64_t first_check;   /* what it failed, see `check` */
    int64_t fallbacks;     /* proximal iterations that K was not announced to need */
    int64_t worst_work;    /* factorisations of one solution */
    double work;           /* factorisations of all */
    double worst_residual; /* against the bounds, relative to what the residual is the sum of */
    double worst_velocity; /* difference to the enumeration over what the residuals of both allow */
    double worst_torque;   /* difference to the enumeration, relative; well-conditioned problems only */
    double worst_norm;     /* share of the squared norm that a move along the null space saves */
} report;

static uint64_t random_state;

static uint64_t random_bits(void)
{
    random_state ^= random_state >> 12;
    random_state ^= random_state << 25;
    random_state ^= random_state >> 27;
    return random_state * UINT64_C(2685821657736338717);
}

static double uniform(double from, double to) { return from + (to - from) * ((double)(random_bits() >> 11) * 0x1p-53); }
static int choice(int count) { return (int)((random_bits() >> 33) % (uint64_t)count); }
static double decades(double from, double to) { return pow(10.0, uniform(from, to)); }

static void seed(int kind, int64_t number)
{
    random_state = (uint64_t)number * UINT64_C(0x9E3779B97F4A7C15) + (uint64_t)(kind + 1) * UINT64_C(0xD1B54A32D192ED03);
    random_state ^= random_state >> 31;
    random_state += random_state == 0;
    for (int k = 0; k < 4; ++k) {
        (void)random_bits();
    }
}

enum { bodies = n + 1 };

/* Velocities of bodies and what the elements see of them. */
typedef struct {
    double G[n][bodies];
    double inertia[bodies], v[bodies];
    int columns;
} mechanism;

/* w = G v */
static void give_velocities(problem *p, const mechanism *m)
{
    for (int i = 0; i < n; ++i) {
        p->w[i] = 0.0;
        for (int k = 0; k < m->columns; ++k) {
            p->w[i] += m->G[i][k] * m->v[k];
        }
    }
}

/* K = G diag(1 / inertia) G' */
static void give_matrix(problem *p, const mechanism *m)
{
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            double sum = 0.0;
            for (int k = 0; k < m->columns; ++k) {
                sum += m->G[i][k] * m->G[j][k] / m->inertia[k];
            }
            p->K[j * stride + i] = sum;
        }
    }
}

/* Each element holds a new body, against an earlier one or the ground: a tree, so K is regular. */
static void tree(mechanism *m, double spread)
{
    const double unit = decades(-2.0, 2.0);
    m->columns = bodies;
    for (int k = 0; k < bodies; ++k) {
        m->inertia[k] = unit * decades(-spread, spread);
        m->v[k] = uniform(-1.0, 1.0) * decades(-2.0, 2.0);
    }
    for (int i = 0; i < n; ++i) {
        const int other = choice(4) == 0 ? choice(i + 1) : i;
        m->G[i][i + 1] = choice(3) == 0 ? uniform(0.2, 5.0) : 1.0;
        if (choice(4) != 0) {
            m->G[i][other] = choice(3) == 0 ? -uniform(0.2, 5.0) : -1.0;
        }
    }
}

/* One body for each element, of inertia 1 and seen by all, and their own ones: (I + A A') scaled. */
static void well_conditioned(problem *p)
{
    double A[n][n], scale[n];
    for (int i = 0; i < n; ++i) {
        scale[i] = decades(-2.0, 2.0);
        for (int j = 0; j < n; ++j) {
            A[i][j] = uniform(-1.0, 1.0);
        }
    }
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            double sum = i == j ? 1.0 : 0.0;
            for (int k = 0; k < n; ++k) {
                sum += A[i][k] * A[j][k];
            }
            p->K[j * stride + i] = sum * scale[i] * scale[j];
        }
    }
    for (int i = 0; i < n; ++i) {
        p->w[i] = uniform(-3.0, 3.0) * scale[i];
    }
}

static void nearly_singular(mechanism *m)
{
    m->columns = n;
    for (int k = 0; k < n; ++k) {
        m->inertia[k] = 1.0;
        m->v[k] = uniform(-1.0, 1.0);
        for (int i = 0; i < n; ++i) {
            m->G[i][k] = uniform(-1.0, 1.0);
        }
    }
    m->inertia[n - 1] = decades(3.0, 18.0);
}

/* Several elements on fewer bodies, coupled by gears and planetary sets. */
static void gear_set(mechanism *m)
{
    static const double ratios[] = { 1.0, -1.0, 2.0, -2.0, 3.0, 0.5, -0.5, 1.5, 2.6, -1.6 };
    const int whole = choice(3) == 0; /* powers of two: K is singular to the last bit */
    m->columns = n == 1 ? 1 : 1 + choice(n - 1);
    for (int k = 0; k < m->columns; ++k) {
        m->inertia[k] = whole ? (double)(1 << choice(6)) : decades(-1.5, 1.5);
        m->v[k] = whole ? (double)(choice(33) - 16) : uniform(-1.0, 1.0) * decades(-1.0, 1.0);
    }
    for (int i = 0; i < n; ++i) {
        m->G[i][choice(m->columns)] = 1.0;
        for (int more = choice(3); more > 0; --more) {
            m->G[i][choice(m->columns)] = ratios[choice(whole ? 7 : 10)];
        }
    }
}

static void small_numbers(mechanism *m)
{
    m->columns = bodies;
    for (int k = 0; k < bodies; ++k) {
        m->inertia[k] = (double)(1 << choice(3));
        m->v[k] = (double)(choice(5) - 2);
    }
    for (int i = 0; i < n; ++i) {
        m->G[i][choice(i + 1)] = (double)(choice(4) - 2);
        m->G[i][i + 1] = 1.0;
    }
}

/* Null space of K, which is that of G': elimination with the largest pivot. */
static void find_null_space(problem *p, const mechanism *m)
{
    double R[bodies][n];
    int order[n], rank = 0;
    for (int k = 0; k < m->columns; ++k) {
        for (int i = 0; i < n; ++i) {
            R[k][i] = m->G[i][k];
        }
    }
    for (int i = 0; i < n; ++i) {
        order[i] = i;
    }
    while (rank < m->columns) {
        int row = rank, column = rank;
        for (int k = rank; k < m->columns; ++k) {
            for (int i = rank; i < n; ++i) {
                if (fabs(R[k][order[i]]) > fabs(R[row][order[column]])) {
                    row = k;
                    column = i;
                }
            }
        }
        const int i = order[column];
        if (fabs(R[row][i]) < 1e-9) {
            break;
        }
        order[column] = order[rank];
        order[rank] = i;
        for (int j = 0; j < n; ++j) {
            const double entry = R[row][j];
            R[row][j] = R[rank][j];
            R[rank][j] = entry;
        }
        for (int k = 0; k < m->columns; ++k) {
            const double factor = k == rank ? 0.0 : R[k][i] / R[rank][i];
            for (int j = 0; j < n; ++j) {
                R[k][j] -= factor * R[rank][j];
            }
        }
        ++rank;
    }
    p->nullity = n - rank;
    for (int c = 0; c < n - rank; ++c) {
        double *z = p->null + c * n;
        z[order[rank + c]] = 1.0;
        for (int k = 0; k < rank; ++k) {
            z[order[k]] = -R[k][order[rank + c]] / R[k][order[k]];
        }
    }
}

static double finite(double bound) { return fabs(bound) < INFINITY ? bound : 0.0; }

/* Bounds of every sort, of the size of the torques that would hold everything alone. */
static void give_bounds(problem *p, int whole)
{
    double size = 0.0;
    for (int i = 0; i < n; ++i) {
        const double alone = fabs(p->w[i]) / p->K[i * stride + i];
        size = alone > size ? alone : size;
    }
    size = size > 0.0 ? size * decades(-2.0, 1.0) : 1.0;
    const int sort = choice(8);
    for (int i = 0; i < n; ++i) {
        double c = whole ? (double)choice(4) : size * (sort == 0 ? 1.0 : decades(-1.0, 0.5));
        double d = whole ? (double)choice(4) : size * decades(-1.0, 0.5);
        c = sort == 1 ? 0.0 : c;
        d = sort <= 2 ? c : d;
        p->lo[i] = -c;
        p->hi[i] = sort <= 4 ? c : d;
        if (sort >= 5) {
            switch (choice(7)) {
            case 0:
                p->hi[i] = INFINITY;
                break;
            case 1:
                p->lo[i] = -INFINITY;
                break;
            case 2:
                p->hi[i] = 0.0;
                break;
            case 3:
                p->lo[i] = 0.0;
                break;
            case 4:
                p->lo[i] = p->hi[i] = choice(2) ? c : -c;
                break;
            default:
                break;
            }
        }
    }
}

/* Velocities that torques about the bounds make up for: all sectors are met, and their borders. */
static void give_matching_velocities(problem *p, mechanism *m, int whole)
{
    double T[n];
    for (int i = 0; i < n; ++i) {
        const double lo = finite(p->lo[i]), hi = finite(p->hi[i]);
        const int where = choice(4);
        T[i] = where == 0 ? lo : (where == 1 ? hi : uniform(1.5 * lo, 1.5 * hi));
        T[i] = whole ? floor(T[i]) : T[i];
    }
    for (int k = 0; k < m->columns; ++k) {
        m->v[k] = 0.0;
        for (int i = 0; i < n; ++i) {
            m->v[k] += m->G[i][k] * T[i] / m->inertia[k];
        }
    }
    if (m->columns > 0) {
        give_velocities(p, m);
        return;
    }
    for (int i = 0; i < n; ++i) {
        p->w[i] = 0.0;
        for (int j = 0; j < n; ++j) {
            p->w[i] += p->K[j * stride + i] * T[j];
        }
    }
}

void make(int kind, int64_t number, problem *p)
{
    mechanism m = { .columns = 0 };
    memset(p, 0, sizeof *p);
    seed(kind, number);
    switch (kind) {
    case lopsided:
        tree(&m, 6.0);
        break;
    case conditioned:
        well_conditioned(p);
        break;
    case near:
        nearly_singular(&m);
        break;
    case gears:
    case unflagged:
        gear_set(&m);
        find_null_space(p, &m);
        break;
    case degenerate:
        small_numbers(&m);
        break;
    default:
        tree(&m, 3.0);
    }
    if (m.columns > 0) {
        give_matrix(p, &m);
        give_velocities(p, &m);
    }
    give_bounds(p, kind == degenerate || choice(8) == 0);
    if (choice(3) == 0) {
        give_matching_velocities(p, &m, kind == degenerate);
    }
    p->dependent = kind == flagged || !box_require_definite(n, 0, p->K);
    p->deficient = p->dependent && kind != unflagged;
    const int start = choice(3);
    for (int i = 0; i < n; ++i) {
        const double lo = finite(p->lo[i]), hi = finite(p->hi[i]);
        p->guess[i] = start == 0 ? 0.0 : (start == 1 ? uniform(lo, hi) : (choice(2) ? lo : hi));
    }
}

/* What the residual of row i is the sum of. */
static double row_size(const problem *p, const double *T, int i)
{
    double size = fabs(p->w[i]);
    for (int j = 0; j < n; ++j) {
        size += fabs(p->K[j * stride + i] * T[j]);
    }
    return size;
}

static double row_residual(const problem *p, const double *T, int i)
{
    double sum = p->w[i];
    for (int j = 0; j < n; ++j) {
        sum -= p->K[j * stride + i] * T[j];
    }
    return sum;
}

/* By how much the residual of row i misses the sign that the bounds ask for. */
static double row_violation(const problem *p, const double *T, int i)
{
    const double r = row_residual(p, T, i);
    if (fabs(r) <= DBL_MIN) { /* such numbers have no digits to be right in */
        return 0.0;
    }
    if (r > 0.0) {
        return T[i] < p->hi[i] ? r : 0.0;
    }
    return T[i] > p->lo[i] ? -r : 0.0;
}

/* Largest size of a row, in the unit of all. */
static double level_of(const problem *p, const double *T)
{
    double largest = 0.0;
    for (int i = 0; i < n; ++i) {
        largest = fmax(largest, row_size(p, T, i) / sqrt(p->K[i * stride + i]));
    }
    return largest;
}

/* What a residual is compared with: dependent rows agree to the rounding of the largest of them only. */
static double known_size(const problem *p, const double *T, int i)
{
    return p->dependent ? level_of(p, T) * sqrt(p->K[i * stride + i]) : row_size(p, T, i);
}

/* Largest violation relative to the size of its row; gives up above `limit`. */
static double violation(const problem *p, const double *T, double limit)
{
    double worst = 0.0;
    for (int i = 0; i < n && worst < limit; ++i) {
        const double v = row_violation(p, T, i);
        if (v > 0.0) {
            worst = fmax(worst, v / known_size(p, T, i));
        }
    }
    return worst;
}

/*
 * The solution by trying which elements are held and at which bounds the others are. Sectors whose held elements hold
 * the same motion are skipped: some sector without is a solution too, as the set of solutions has a corner.
 * Returns its violation; the least is the solution, and one at rounding ends the search.
 */
static double enumerate(const problem *p, double *T)
{
    double best = INFINITY;
    for (int set = 0; set < 1 << n; ++set) { /* bit i: element i is held */
        int held[n], others[n], at[n], count = 0, rest = 0, possible = 1;
        double L[n][n];
        for (int i = 0; i < n; ++i) {
            if (set >> i & 1) {
                held[count++] = i;
                possible = possible && p->lo[i] < p->hi[i];
            } else {
                others[rest] = i;
                at[rest++] = fabs(p->lo[i]) < INFINITY ? 0 : 1;
            }
        }
        for (int j = 0; j < count && possible; ++j) {
            for (int i = j; i < count; ++i) {
                double sum = p->K[held[j] * stride + held[i]];
                for (int k = 0; k < j; ++k) {
                    sum -= L[i][k] * L[j][k];
                }
                if (i == j) {
                    possible = sum > 4e-16 * p->K[held[j] * stride + held[j]];
                    L[j][j] = sqrt(sum);
                } else {
                    L[i][j] = sum / L[j][j];
                }
            }
        }
        while (possible) {
            double S[n], y[n];
            int inside = 1;
            for (int k = 0; k < rest; ++k) {
                S[others[k]] = at[k] ? p->hi[others[k]] : p->lo[others[k]];
            }
            for (int i = 0; i < count; ++i) {
                double sum = p->w[held[i]];
                for (int k = 0; k < rest; ++k) {
                    sum -= p->K[others[k] * stride + held[i]] * S[others[k]];
                }
                for (int k = 0; k < i; ++k) {
                    sum -= L[i][k] * y[k];
                }
                y[i] = sum / L[i][i];
            }
            for (int i = count - 1; i >= 0 && inside; --i) {
                double sum = y[i];
                for (int k = i + 1; k < count; ++k) {
                    sum -= L[k][i] * y[k];
                }
                y[i] = sum / L[i][i];
                const double lo = p->lo[held[i]], hi = p->hi[held[i]];
                const double slack = 1e-3 * (fabs(y[i]) + finite(fabs(lo)) + finite(hi));
                inside = y[i] >= lo - slack && y[i] <= hi + slack;
                S[held[i]] = y[i] < lo ? lo : (y[i] > hi ? hi : y[i]);
            }
            if (inside) {
                const double worst = violation(p, S, best);
                if (worst < best) {
                    best = worst;
                    memcpy(T, S, sizeof S);
                    if (best <= 4e-16) {
                        return best;
                    }
                }
            }
            int k = 0;
            for (; k < rest; ++k) { /* the next combination of bounds */
                const int i = others[k];
                if (at[k] == 0 && p->hi[i] < INFINITY && p->lo[i] < p->hi[i]) {
                    at[k] = 1;
                    break;
                }
                at[k] = fabs(p->lo[i]) < INFINITY ? 0 : 1;
            }
            possible = k < rest;
        }
    }
    return best;
}

/* Which share of sum K_ii T_i^2 can be saved along the null space, in its basis and in random directions. */
static double saved(const problem *p, const double *T)
{
    double norm = 0.0, best = 0.0;
    for (int i = 0; i < n; ++i) {
        norm += p->K[i * stride + i] * T[i] * T[i];
    }
    for (int trial = 0; trial < (p->nullity > 1 ? p->nullity + 12 : p->nullity); ++trial) {
        double z[n] = { 0.0 };
        for (int c = 0; c < p->nullity; ++c) {
            const double share = trial < p->nullity ? (double)(c == trial) : uniform(-1.0, 1.0);
            for (int i = 0; i < n; ++i) {
                z[i] += share * p->null[c * n + i];
            }
        }
        double from = -INFINITY, to = INFINITY, slope = 0.0, curvature = 0.0;
        for (int i = 0; i < n; ++i) {
            slope += p->K[i * stride + i] * T[i] * z[i];
            curvature += p->K[i * stride + i] * z[i] * z[i];
            if (fabs(z[i]) > 1e-12) {
                const double up = (p->hi[i] - T[i]) / z[i], down = (p->lo[i] - T[i]) / z[i];
                from = fmax(from, fmin(up, down));
                to = fmin(to, fmax(up, down));
            }
        }
        const double t = fmax(from, fmin(to, -slope / curvature));
        best = fmax(best, -t * (2.0 * slope + t * curvature));
    }
    return norm > 0.0 ? best / norm : 0.0;
}

/* Residuals of both points below this are rounding. */
static double rounding_of(const problem *p, const double *T, const double *S, int i)
{
    return 0x1p-45 * (known_size(p, T, i) + known_size(p, S, i));
}

/* The checks, by the number that `first_check` holds. */
enum check { passed, not_solved, outside, not_balanced, not_exact, other_velocity, other_torque, not_least };

/*
 * Two points of the box whose residuals miss the conditions by v and v' leave velocities that differ by D = K (T - T'),
 * and (T - T')' D <= sum (v + v') |T - T'|; so D_i^2 <= K_ii sum (v + v') |T - T'|.
 */
static enum check examine(const problem *p, int enumerated, int kind, report *out)
{
    double T[n], w_plus[n], S[n];
    memcpy(T, p->guess, sizeof T);
    const int work = box_solve_box(p->deficient, p->K, p->w, p->lo, p->hi, T, w_plus);
    if (work < 0) {
        return not_solved;
    }
    out->worst_work = work > out->worst_work ? work : out->worst_work;
    out->work += work;
    for (int i = 0; i < n; ++i) {
        if (!(T[i] >= p->lo[i] && T[i] <= p->hi[i])) {
            return outside;
        }
    }
    const double violated = violation(p, T, INFINITY);
    out->worst_residual = fmax(out->worst_residual, violated);
    if (!(violated <= 1e-12)) {
        return not_balanced;
    }
    for (int i = 0; i < n; ++i) {
        const int held = T[i] > p->lo[i] && T[i] < p->hi[i];
        const int sign = (w_plus[i] > 0.0 && T[i] < p->hi[i]) || (w_plus[i] < 0.0 && T[i] > p->lo[i]);
        if ((held && w_plus[i] != 0.0) || sign ||
            !(held || fabs(w_plus[i] - row_residual(p, T, i)) <= 1e-12 * known_size(p, T, i))) {
            return not_exact;
        }
    }
    if (enumerated) {
        (void)enumerate(p, S);
        double allowed = 0.0;
        for (int i = 0; i < n; ++i) {
            allowed += (row_violation(p, T, i) + row_violation(p, S, i) + rounding_of(p, T, S, i)) * fabs(T[i] - S[i]);
        }
        for (int i = 0; i < n; ++i) {
            const double difference = fabs(w_plus[i] - row_residual(p, S, i));
            const double bound = sqrt(p->K[i * stride + i] * allowed) + rounding_of(p, T, S, i);
            out->worst_velocity = bound > 0.0 ? fmax(out->worst_velocity, difference / bound) : out->worst_velocity;
            if (!(difference <= bound)) {
                return other_velocity;
            }
        }
        if (kind == conditioned) {
            double size = 0.0, difference = 0.0;
            for (int i = 0; i < n; ++i) {
                size = fmax(size, row_size(p, S, i) / sqrt(p->K[i * stride + i]));
                difference = fmax(difference, fabs(T[i] - S[i]) * sqrt(p->K[i * stride + i]));
            }
            out->worst_torque = size > 0.0 ? fmax(out->worst_torque, difference / size) : out->worst_torque;
            if (!(difference <= 1e-12 * size)) {
                return other_torque;
            }
        }
    }
    if (p->deficient && kind == gears) {
        const double share = saved(p, T);
        out->worst_norm = fmax(out->worst_norm, share);
        if (!(share <= 1e-6)) {
            return not_least;
        }
    }
    return passed;
}

/* Whether the descent over the faces does not reach the solution by itself. */
static int falls_back(const problem *p)
{
#if BOX_GENERAL
    double T[n], r[n], size[n];
    box b = { .H = p->K, .c = p->w, .lo = p->lo, .hi = p->hi, .work = 0 };
    for (int i = 0; i < n; ++i) {
        T[i] = clip(p->guess[i], p->lo[i], p->hi[i]);
    }
    return !descend(&b, T, r, size);
#else
    (void)p;
    return 0;
#endif
}

void run(int kind, int64_t first, int64_t count, int enumerated, report *out)
{
    problem p;
    memset(out, 0, sizeof *out);
    out->first_failure = -1;
    for (int64_t number = first; number < first + count; ++number) {
        make(kind, number, &p);
        const enum check failed = examine(&p, enumerated, kind, out);
        ++out->problems;
        out->fallbacks += !p.deficient && falls_back(&p);
        if (failed != passed && out->failures++ == 0) {
            out->first_failure = number;
            out->first_check = (int64_t)failed;
        }
    }
}
