/*
 * differential_governed_governor.c: references that keep the machines inside their torque limits
 *
 * Emitted by ptgen 0.1.0 from differential-governed.toml (SHA-256 acf552a043b195e0), template governor.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "differential_governed_governor.h"

#define REAL DIFFERENTIAL_GOVERNED_REAL

typedef differential_governed_real real;

enum { m = differential_governed_governor_machines };
enum { stride = (m + 3) / 4 * 4 };

static real lesser(real a, real b) { return a < b ? a : b; }
static real larger(real a, real b) { return a > b ? a : b; }
static real clip(real value, real lo, real hi) { return value < lo ? lo : (value > hi ? hi : value); }

/* Zero if all numbers are finite, else NaN. */
static real trace(int count, const real *numbers)
{
    real sum = 0.0;
    for (int i = 0; i < count; ++i) {
        sum += numbers[i] * 0.0;
    }
    return sum;
}

static real trace_of_gain(const real *gain)
{
    real sum = 0.0;
    for (int q = 0; q < m; ++q) {
        sum += trace(m, gain + q * stride);
    }
    return sum;
}

/* The first reference that each one is tied to; itself if it is free. */
static void find_leaders(const real *wanted, const real *before, real tie, const real *group, int *leader)
{
    for (int i = 0; i < m; ++i) {
        leader[i] = i;
        for (int j = i - 1; j >= 0; --j) {
            const int same = group[i] > 0.0 && group[i] <= group[j] && group[i] >= group[j];
            const real apart = larger(fabs(wanted[i] - wanted[j]), fabs(before[i] - before[j]));
            leader[i] = same && apart < tie ? leader[j] : leader[i];
        }
    }
}

/* A row that got worse by more than this share of its limits did so. */
static const real worse = 1e-09;
static const real unlimited = 1e+30;

enum { steps = 3 };

/* Which row and which reference each step treats. */
static const int row_of_step[steps] = { 1, 2, 0 };
static const int reference_of_step[steps] = { 1, 2, 0 };

/* Reference i is at change_i + t_i unit_i; t moves from back_i to forth_i. The first `count` steps are done. */
typedef struct {
    const real *free;
    const real *gain;
    const real *least;
    const real *most;
    real change[m], unit[m], back[m], forth[m];
    int leader[m], row[m];
    int modified;
    int count;
} sequence;

static real position(const sequence *g, int i, const real *t) { return g->change[i] + t[i] * g->unit[i]; }

/* The part of a command that the references make that are done. */
static real moving(const sequence *g, int row, const real *t)
{
    real sum = 0.0;
    for (int k = 0; k < g->count; ++k) {
        const int i = reference_of_step[k];
        sum += g->gain[i * stride + row] * position(g, i, t);
    }
    return sum;
}

static real command(const sequence *g, int row, const real *t) { return g->free[row] + moving(g, row, t); }

/* Sum over the references that are done and led by `first`. */
static real led(const sequence *g, int row, int first, int squared)
{
    real sum = 0.0;
    for (int k = 0; k < g->count; ++k) {
        const int i = reference_of_step[k];
        const real share = g->gain[i * stride + (squared ? g->row[i] : row)] * g->unit[i];
        sum += g->leader[i] == first ? (squared ? share * share : share) : 0.0;
    }
    return sum;
}

/*
 * How far the references led by `first` may move: in their boxes and, if they may go back, while they keep their rows;
 * without `back` no further than standing still.
 */
static real room_of(const sequence *g, int first, real direction, const real *t, int back)
{
    real room = unlimited;
    for (int k = 0; k < g->count; ++k) {
        const int i = reference_of_step[k];
        if (g->leader[i] != first) {
            continue;
        }
        room = lesser(room, direction < 0.0 ? t[i] - g->back[i] : g->forth[i] - t[i]);
        room = back ? room : lesser(room, larger(-direction * position(g, i, t), 0.0));
        if (g->modified) {
            const int row = g->row[i];
            const real rate = direction * led(g, row, first, 0), value = command(g, row, t);
            const real gap = rate > 0.0 ? g->most[row] - value : value - g->least[row];
            room = fabs(rate) > 0.0 ? lesser(room, gap / fabs(rate)) : room;
        }
    }
    return larger(room, 0.0);
}

/*
 * Takes `lacking` off a row, as far as may be, with the least effort: the sum of squares of what each reference asks of
 * its own machine. The minimum moves along -lambda slope up to the bounds; the larger lambda, the more are at theirs.
 */
static void give_way(const sequence *g, int row, real lacking, const real *t, int back, real *moved)
{
    real slope[m], effort[m], room[m], factor = 0.0;
    int full[m];
    for (int f = 0; f < m; ++f) {
        const real rate = led(g, row, f, 0), square = led(g, row, f, 1);
        effort[f] = square > 0.0 ? sqrt(square) : 1.0;
        slope[f] = rate / effort[f];
        const real direction = rate * lacking > 0.0 ? -1.0 : 1.0;
        room[f] = fabs(rate) > 0.0 ? room_of(g, f, direction, t, back) : 0.0;
        full[f] = 0;
    }
    for (int round = 0; round <= m; ++round) {
        real left = fabs(lacking), stiffness = 0.0;
        for (int f = 0; f < m; ++f) {
            left -= full[f] ? fabs(slope[f]) * room[f] * effort[f] : 0.0;
            stiffness += full[f] ? 0.0 : slope[f] * slope[f];
        }
        factor = stiffness > 0.0 ? left / stiffness : 0.0;
        for (int f = 0; f < m && round < m; ++f) {
            full[f] = full[f] || factor * fabs(slope[f]) >= room[f] * effort[f];
        }
    }
    for (int i = 0; i < m; ++i) {
        moved[i] = t[i];
    }
    for (int k = 0; k < g->count; ++k) {
        const int i = reference_of_step[k], f = g->leader[i];
        const real step = full[f] ? room[f] : factor * fabs(slope[f]) / effort[f];
        moved[i] -= differential_governed_sign(slope[f] * lacking) * step;
    }
}

/* Holds all references that are done back by the same share. */
static void hold_back(const sequence *g, int row, real lacking, const real *t, real *moved)
{
    const real sum = moving(g, row, t);
    const real share = sum * lacking > 0.0 ? clip(1.0 - lacking / sum, 0.0, 1.0) : 1.0;
    for (int k = 0; k < g->count; ++k) {
        const int i = reference_of_step[k];
        const real target = share * position(g, i, t) - g->change[i];
        moved[i] = fabs(g->unit[i]) > 0.0 ? target / g->unit[i] : t[i];
    }
}

static real excess(const sequence *g, int row, const real *t)
{
    const real value = command(g, row, t);
    return larger(larger(value - g->most[row], g->least[row] - value), 0.0);
}

/* Lets the references that are done give way if they leave too little for the reference `own`. */
static void make_room(const sequence *g, int row, int own, real reserve, real rate_step, real *t)
{
    real lower = g->least[row] + reserve, upper = g->most[row] - reserve;
    if (lower > upper) {
        lower = upper = 0.5 * (lower + upper);
    }
    const real small = differential_governed_sign(g->change[own]) * lesser(fabs(g->change[own]), rate_step);
    const real still = command(g, row, t), value = still + g->gain[own * stride + row] * small;
    int coupled = 0; /* earlier rows may keep `own` from moving, so it cannot be counted on */
    for (int k = 0; k < g->count; ++k) {
        coupled = coupled || fabs(g->gain[own * stride + row_of_step[k]]) > 0.0;
    }
    const real above = (coupled ? larger(still, value) : value) - upper;
    const real below = (coupled ? lesser(still, value) : value) - lower;
    const real lacking = above > 0.0 ? above : (below < 0.0 ? below : 0.0);
    if (g->count == 0 || !(fabs(lacking) > 0.0)) {
        return;
    }
    real moved[m];
    if (g->modified) { /* back only as far as standing still is not enough */
        real still_moved[m];
        give_way(g, row, lacking, t, 0, still_moved);
        const real left = lacking + command(g, row, still_moved) - command(g, row, t);
        give_way(g, row, left * lacking > 0.0 ? left : 0.0, still_moved, 1, moved);
    } else {
        give_way(g, row, lacking, t, 1, moved);
    }
    int any_worse = 0;
    for (int k = 0; k < g->count; ++k) {
        const int other = row_of_step[k];
        const real allowed = worse * fabs(g->most[other] - g->least[other]) + excess(g, other, t);
        any_worse = any_worse || excess(g, other, moved) > allowed;
    }
    if (any_worse) {
        hold_back(g, row, lacking, t, moved);
    }
    for (int i = 0; i < m; ++i) {
        t[i] = moved[i];
    }
}

/* The coordinate nearest to t for which a row is no worse than if the reference `own` is not changed. */
static real not_worse(const sequence *g, int row, int own, real t_own, const real *t)
{
    const real gain = g->gain[own * stride + row], rate = gain * g->unit[own];
    const real still = command(g, row, t);
    const real lower = lesser(still, g->least[row]), upper = larger(still, g->most[row]);
    const real value = still + gain * (g->change[own] + t_own * g->unit[own]);
    const real bound = value > upper ? upper : (value < lower ? lower : value);
    const real target = fabs(rate) > 0.0 ? t_own + (bound - value) / rate : t_own;
    return g->modified ? target : clip(target, -1.0, 0.0);
}

/* Moves the reference `own` back as far as its row needs, and so that no earlier row gets worse. */
static real place(const sequence *g, int row, int own, const real *t)
{
    const real gain = g->gain[own * stride + row], rate = gain * g->unit[own];
    const real value = command(g, row, t) + gain * g->change[own];
    const real bound = value > g->most[row] ? g->most[row] : (value < g->least[row] ? g->least[row] : value);
    const real needed = fabs(rate) > 0.0 ? (bound - value) / rate : 0.0;
    real result = clip(needed, g->back[own], g->forth[own]);
    for (int k = 0; k < g->count; ++k) {
        result = not_worse(g, row_of_step[k], own, result, t);
    }
    return result;
}

void differential_governed_sequential_governor(const real *wanted, const real *before, const real *free, const real *gain,
    const real *least, const real *most, const real *reserve, const real *rate_step, real tie, real modified,
    const real *group, real *shaped)
{
    const real sum = trace(m, wanted) + trace(m, before) + trace(m, free) + trace_of_gain(gain) + trace(m, least)
                     + trace(m, most) + trace(m, reserve) + trace(m, rate_step) + trace(1, &tie) + trace(1, &modified)
                     + trace(m, group);
    if (!differential_governed_is_finite(sum)) {
        for (int i = 0; i < m; ++i) {
            shaped[i] = before[i];
        }
        return;
    }
    sequence g = { .free = free, .gain = gain, .least = least, .most = most };
    real t[m];
    g.modified = modified > 0.5;
    find_leaders(wanted, before, tie, group, g.leader);
    for (int i = 0; i < m; ++i) {
        const real change = wanted[i] - before[i];
        g.change[i] = change;
        g.unit[i] = g.modified ? 1.0 : change;
        g.back[i] = g.modified ? (change < 0.0 ? 0.0 : -unlimited) : -1.0;
        g.forth[i] = g.modified && !(change > 0.0) ? unlimited : 0.0;
        t[i] = 0.0;
    }
    for (int k = 0; k < steps; ++k) {
        const int row = row_of_step[k], own = reference_of_step[k];
        make_room(&g, row, own, reserve[row], rate_step[own], t);
        t[own] = place(&g, row, own, t);
        g.row[own] = row;
        g.count = k + 1;
        real furthest = t[own];
        for (int n = 0; n <= k; ++n) {
            const int i = reference_of_step[n];
            furthest = g.leader[i] == g.leader[own] && fabs(t[i]) > fabs(furthest) ? t[i] : furthest;
        }
        for (int n = 0; n <= k; ++n) {
            const int i = reference_of_step[n];
            t[i] = g.leader[i] == g.leader[own] ? furthest : t[i];
        }
    }
    for (int i = 0; i < m; ++i) {
        const real moved = fabs(t[i]) > 0.0 ? wanted[i] + t[i] * g.unit[i] : wanted[i];
        const real kept = t[i] > -1.0 ? clip(moved, lesser(wanted[i], before[i]), larger(wanted[i], before[i])) : before[i];
        shaped[i] = g.modified ? moved : kept;
    }
    if (!differential_governed_is_finite(trace(m, shaped))) {
        for (int i = 0; i < m; ++i) {
            shaped[i] = before[i];
        }
    }
}

enum { n = differential_governed_governor_states };
enum { rows = differential_governed_governor_rows };
enum { padded_rows = (rows + 3) / 4 * 4 };
enum { table_stride = 436 };

/* Rows of machine i: from first_row[i] to before first_row[i + 1]. */
static const int first_row[m + 1] = { 0, 182, 307, 433 };

/* Violations below this share of the limits, and rates of prices below this, are rounding. */
static const real feasible = 1e-12;
static const real least_pivot = 1e-10;
/* By which share of the limits more than what lacks they are widened. */
static const real margin = 1e-09;
/* Larger deviations cannot be meant: from here on predictions might overflow. */
static const real largest = 1e+30;

/* Minimise weight's so that command + predicted lies between lower and upper, and s, the share held back, from 0 to 1. */
typedef struct {
    const real *gain;
    const real *rows_r;
    real change[m], command[m], lower[m], upper[m], per_scale[m], weight[m];
    int leader[m];
    real predicted[padded_rows + 4];
} program;

/* A constraint normal's >= side; `bound` is the unknown that it bounds, or -1. */
typedef struct {
    real normal[m];
    real side;
    int bound;
} constraint;

enum outcome { solved, infeasible, unsolved };

/* What the rows add if nothing is held back: rows_x x. Runs down columns, so that compilers take several rows at a time. */
static void predict(const real *restrict A, const real *restrict x, real *restrict y)
{
    for (int i = 0; i < padded_rows; ++i) {
        y[i] = A[0 * table_stride + i] * x[0] + A[1 * table_stride + i] * x[1] + A[2 * table_stride + i] * x[2] + A[3 * table_stride + i] * x[3] + A[4 * table_stride + i] * x[4] + A[5 * table_stride + i] * x[5] + A[6 * table_stride + i] * x[6] + A[7 * table_stride + i] * x[7] + A[8 * table_stride + i] * x[8];
    }
}

/* What the rows add if the references are held back by `held` (rad/s or N m): predicted - rows_r held. */
static void predict_held(const real *restrict predicted, const real *restrict A, const real *restrict held, real *restrict y)
{
    for (int i = 0; i < padded_rows; ++i) {
        y[i] = predicted[i] - A[0 * table_stride + i] * held[0] - A[1 * table_stride + i] * held[1] - A[2 * table_stride + i] * held[2];
    }
}

/* Largest and least of what the rows of each machine add; the present step adds nothing. Four at a time. */
static void extremes(const real *restrict y, real *restrict most, real *restrict least)
{
    for (int i = 0; i < m; ++i) {
        real a0 = 0.0, a1 = 0.0, a2 = 0.0, a3 = 0.0;
        real b0 = 0.0, b1 = 0.0, b2 = 0.0, b3 = 0.0;
        int j = first_row[i];
        for (; j + 3 < first_row[i + 1]; j += 4) {
            a0 = larger(a0, y[j]);
            a1 = larger(a1, y[j + 1]);
            a2 = larger(a2, y[j + 2]);
            a3 = larger(a3, y[j + 3]);
            b0 = lesser(b0, y[j]);
            b1 = lesser(b1, y[j + 1]);
            b2 = lesser(b2, y[j + 2]);
            b3 = lesser(b3, y[j + 3]);
        }
        for (; j < first_row[i + 1]; ++j) {
            a0 = larger(a0, y[j]);
            b0 = lesser(b0, y[j]);
        }
        most[i] = larger(larger(a0, a1), larger(a2, a3));
        least[i] = lesser(lesser(b0, b1), lesser(b2, b3));
    }
}

/* The row of a machine that adds `value`; -1 for the present step. */
static int row_with(const real *y, int machine, real value)
{
    if (!(fabs(value) > 0.0)) {
        return -1;
    }
    for (int j = first_row[machine]; j < first_row[machine + 1]; ++j) {
        if (y[j] <= value && y[j] >= value) {
            return j;
        }
    }
    return -1;
}

static void take_bound(int unknown, real sign, constraint *taken)
{
    for (int q = 0; q < m; ++q) {
        taken->normal[q] = 0.0;
    }
    taken->normal[unknown] = sign;
    taken->side = lesser(sign, 0.0);
    taken->bound = unknown;
}

/* Normalises the row, so that pivots have no unit. */
static void take_row(const program *g, int machine, int row, real sign, constraint *taken)
{
    real size = 0.0;
    for (int q = 0; q < m; ++q) {
        taken->normal[q] = 0.0;
    }
    for (int q = 0; q < m; ++q) {
        const real added = row < 0 ? 0.0 : g->rows_r[q * table_stride + row];
        taken->normal[g->leader[q]] += sign * (g->gain[q * stride + machine] + added) * g->change[q];
    }
    for (int q = 0; q < m; ++q) {
        size = larger(size, fabs(taken->normal[q]));
    }
    const real value = g->command[machine] + (row < 0 ? 0.0 : g->predicted[row]);
    const real side = sign > 0.0 ? value - g->upper[machine] : g->lower[machine] - value;
    for (int q = 0; q < m; ++q) {
        taken->normal[q] = size > 0.0 ? taken->normal[q] / size : 0.0;
    }
    taken->side = size > 0.0 ? side / size : 1.0;
    taken->bound = -1;
}

/* Finds the most violated constraint; returns 0 if all hold. `y` is what the rows add at s. */
static int most_violated(const program *g, const real *s, const real *command, const real *y, constraint *taken)
{
    real most[m], least[m], worst = feasible;
    int where = 0; /* unknowns below 0 and above 1, machines above and below their limits: m places each */
    extremes(y, most, least);
    for (int q = 0; q < m; ++q) {
        where = -s[q] > worst ? q + 1 : where;
        worst = larger(-s[q], worst);
    }
    for (int q = 0; q < m; ++q) {
        where = s[q] - 1.0 > worst ? m + q + 1 : where;
        worst = larger(s[q] - 1.0, worst);
    }
    for (int i = 0; i < m; ++i) {
        const real above = (command[i] + most[i] - g->upper[i]) * g->per_scale[i];
        where = above > worst ? 2 * m + i + 1 : where;
        worst = larger(above, worst);
    }
    for (int i = 0; i < m; ++i) {
        const real below = (g->lower[i] - command[i] - least[i]) * g->per_scale[i];
        where = below > worst ? 3 * m + i + 1 : where;
        worst = larger(below, worst);
    }
    if (where == 0) {
        return 0;
    }
    const int kind = (where - 1) / m, index = (where - 1) % m;
    if (kind < 2) {
        take_bound(index, kind == 0 ? 1.0 : -1.0, taken);
    } else {
        const real extreme = kind == 2 ? most[index] : least[index];
        take_row(g, index, row_with(y, index, extreme), kind == 2 ? 1.0 : -1.0, taken);
    }
    return 1;
}

/* Swaps the active constraint whose price vanishes first for `taken`; returns 0 if none does: the program is infeasible. */
static int exchange(const constraint *taken, constraint *active, real *price, real *inverse, real *s)
{
    real rates[m], least = 0.0;
    int leaving = -1;
    for (int k = 0; k < m; ++k) {
        rates[k] = 0.0;
        for (int q = 0; q < m; ++q) {
            rates[k] += inverse[k * m + q] * taken->normal[q];
        }
        if (rates[k] > least_pivot && (leaving < 0 || price[k] / rates[k] < least)) {
            least = price[k] / rates[k];
            leaving = k;
        }
    }
    if (leaving < 0) {
        return 0;
    }
    real missing = taken->side, column[m];
    for (int q = 0; q < m; ++q) {
        missing -= taken->normal[q] * s[q];
        column[q] = inverse[leaving * m + q] / rates[leaving];
    }
    for (int k = 0; k < m; ++k) {
        price[k] = k == leaving ? least : larger(price[k] - least * rates[k], 0.0);
        s[k] += missing * column[k];
        for (int q = 0; q < m; ++q) {
            inverse[k * m + q] = k == leaving ? column[q] : inverse[k * m + q] - column[q] * rates[k];
        }
    }
    active[leaving] = *taken;
    return 1;
}

/* The point where the active constraints meet, by elimination with pivots; unknowns at a bound are exact. */
static void vertex(const constraint *active, real *s)
{
    real M[m][m + 1], at[m];
    int free[m], count = 0, equations = 0;
    for (int q = 0; q < m; ++q) {
        free[q] = 1;
        at[q] = 0.0;
    }
    for (int k = 0; k < m; ++k) {
        if (active[k].bound >= 0) {
            free[active[k].bound] = 0;
            at[active[k].bound] = active[k].side < 0.0 ? 1.0 : 0.0;
        }
    }
    int unknown[m];
    for (int q = 0; q < m; ++q) {
        if (free[q]) {
            unknown[count++] = q;
        }
    }
    for (int k = 0; k < m; ++k) {
        if (active[k].bound < 0 && equations < count) {
            real side = active[k].side;
            for (int q = 0; q < m; ++q) {
                side -= active[k].normal[q] * at[q];
            }
            for (int c = 0; c < count; ++c) {
                M[equations][c] = active[k].normal[unknown[c]];
            }
            M[equations++][count] = side;
        }
    }
    for (int c = 0; c < equations; ++c) {
        int pivot = c;
        for (int r = c + 1; r < equations; ++r) {
            pivot = fabs(M[r][c]) > fabs(M[pivot][c]) ? r : pivot;
        }
        for (int k = c; k <= count; ++k) {
            const real swapped = M[c][k];
            M[c][k] = M[pivot][k];
            M[pivot][k] = swapped;
        }
        for (int r = c + 1; r < equations; ++r) {
            const real factor = M[r][c] / M[c][c];
            for (int k = c; k <= count; ++k) {
                M[r][k] -= factor * M[c][k];
            }
        }
    }
    for (int c = equations - 1; c >= 0; --c) {
        real value = M[c][count];
        for (int k = c + 1; k < equations; ++k) {
            value -= M[c][k] * at[unknown[k]];
        }
        at[unknown[c]] = value / M[c][c];
    }
    for (int q = 0; q < m; ++q) {
        s[q] = at[q];
    }
}

/* Dual simplex from s = 0, where all prices are right; `iterations` counts on. */
static enum outcome solve(const program *g, real *s, int *iterations)
{
    constraint active[m], taken;
    real price[m], inverse[m * m], y[padded_rows + 4];
    for (int k = 0; k < m; ++k) {
        take_bound(k, 1.0, &active[k]);
        price[k] = g->weight[k];
        s[k] = 0.0;
        for (int q = 0; q < m; ++q) {
            inverse[k * m + q] = k == q ? 1.0 : 0.0;
        }
    }
    if (!most_violated(g, s, g->command, g->predicted, &taken)) {
        return solved;
    }
    while (*iterations < differential_governed_governor_iterations) {
        *iterations += 1;
        if (!exchange(&taken, active, price, inverse, s)) {
            return infeasible;
        }
        real held[m], command[m];
        for (int q = 0; q < m; ++q) {
            held[q] = g->change[q] * s[g->leader[q]];
            command[q] = g->command[q];
        }
        for (int q = 0; q < m; ++q) {
            for (int i = 0; i < m; ++i) {
                command[i] -= g->gain[q * stride + i] * held[q];
            }
        }
        predict_held(g->predicted, g->rows_r, held, y);
        if (!most_violated(g, s, command, y, &taken)) {
            vertex(active, s);
            return solved;
        }
    }
    return unsolved;
}

/* Widens the limits by what the machines lack if nothing is changed. */
static void widen(program *g, const real *free, real *slack)
{
    real y[padded_rows + 4], most[m], least[m];
    predict_held(g->predicted, g->rows_r, g->change, y);
    extremes(y, most, least);
    for (int i = 0; i < m; ++i) {
        const real above = free[i] + most[i] - g->upper[i], below = g->lower[i] - free[i] - least[i];
        slack[i] = larger(larger(above, below), 0.0);
        const real span = 1.0 / g->per_scale[i] + slack[i], wider = slack[i] + margin * span;
        g->lower[i] -= wider;
        g->upper[i] += wider;
        g->per_scale[i] = 1.0 / span;
    }
}

void differential_governed_optimal_governor(real chosen, const real *wanted, const real *before, const real *free, const real *gain,
    const real *least, const real *most, const real *deviation, const real *rows_x, const real *rows_r, const real *weight,
    real tie, const real *group, const real *fallback, real *shaped, real *slack, real *iterations, real *status)
{
    for (int i = 0; i < m; ++i) {
        slack[i] = 0.0;
        shaped[i] = fallback[i];
    }
    *iterations = 0.0;
    *status = 0.0;
    if (!(chosen > 0.5)) {
        return;
    }
    for (int i = 0; i < m; ++i) {
        shaped[i] = differential_governed_is_finite(fallback[i]) ? fallback[i] : before[i];
    }
    *status = 3.0;
    const real sum = trace(m, wanted) + trace(m, before) + trace(m, free) + trace_of_gain(gain) + trace(m, least)
                     + trace(m, most) + trace(n, deviation) + trace(m, weight) + trace(1, &tie) + trace(m, group);
    real size = 0.0;
    for (int j = 0; j < n; ++j) {
        size = larger(size, fabs(deviation[j]));
    }
    if (!differential_governed_is_finite(sum) || size > largest) {
        return;
    }
    program g;
    g.gain = gain;
    g.rows_r = rows_r;
    find_leaders(wanted, before, tie, group, g.leader);
    for (int i = 0; i < m; ++i) {
        const real span = 0.5 * (most[i] - least[i]);
        g.change[i] = wanted[i] - before[i];
        g.command[i] = free[i];
        g.lower[i] = least[i];
        g.upper[i] = most[i];
        g.per_scale[i] = 1.0 / (span > 0.0 ? span : 1.0);
        g.weight[i] = 0.0;
    }
    for (int q = 0; q < m; ++q) {
        g.weight[g.leader[q]] += weight[q];
        for (int i = 0; i < m; ++i) {
            g.command[i] += gain[q * stride + i] * g.change[q];
        }
    }
    if (!differential_governed_is_finite(trace(m, g.command))) {
        return;
    }
    predict(rows_x, deviation, g.predicted);
    real s[m];
    int count = 0;
    enum outcome outcome = solve(&g, s, &count);
    int widened = 0;
    if (outcome == infeasible) {
        widen(&g, free, slack);
        for (int i = 0; i < m; ++i) {
            widened = widened || slack[i] > 0.0;
        }
        outcome = solve(&g, s, &count);
    }
    *iterations = (real)count;
    for (int q = 0; q < m; ++q) {
        if (outcome != solved || !differential_governed_is_finite(s[q])) {
            return;
        }
    }
    *status = widened ? 2.0 : (count > 0 ? 1.0 : 0.0);
    for (int q = 0; q < m; ++q) {
        const real held = s[g.leader[q]], moved = wanted[q] - held * g.change[q];
        const real between = clip(moved, lesser(wanted[q], before[q]), larger(wanted[q], before[q]));
        shaped[q] = held >= 1.0 ? before[q] : (held > 0.0 ? between : wanted[q]);
    }
}
