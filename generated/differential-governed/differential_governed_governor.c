/*
 * differential_governed_governor.c: references that keep the machines inside their torque limits
 *
 * Emitted by ptgen 0.1.0 from differential-governed.toml (SHA-256 d08516f63c075637), template governor.c.jinja.
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

/* How far the references led by `first` may move: in their boxes and, if they may go back, while they keep their rows. */
static real room_of(const sequence *g, int first, real direction, const real *t)
{
    real room = unlimited;
    for (int k = 0; k < g->count; ++k) {
        const int i = reference_of_step[k];
        if (g->leader[i] != first) {
            continue;
        }
        room = lesser(room, direction < 0.0 ? t[i] - g->back[i] : g->forth[i] - t[i]);
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
static void give_way(const sequence *g, int row, real lacking, const real *t, real *moved)
{
    real slope[m], effort[m], room[m], factor = 0.0;
    int full[m];
    for (int f = 0; f < m; ++f) {
        const real rate = led(g, row, f, 0), square = led(g, row, f, 1);
        effort[f] = square > 0.0 ? sqrt(square) : 1.0;
        slope[f] = rate / effort[f];
        room[f] = fabs(rate) > 0.0 ? room_of(g, f, rate * lacking > 0.0 ? -1.0 : 1.0, t) : 0.0;
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
    give_way(g, row, lacking, t, moved);
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
