/*
 * transmission_fluid.h: torques of a fluid between pump and turbine
 *
 * Emitted by ptgen 0.1.0 from transmission.toml (SHA-256 e06936acb40aa4a5), template fluid.h.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#ifndef TRANSMISSION_FLUID_H
#define TRANSMISSION_FLUID_H

#include "transmission_support.h"

/* Coefficients of the torques of the faster and of the slower wheel, and how far those of two polynomials are apart. */
enum {
    transmission_fluid_faster = 4,
    transmission_fluid_slower = 7,
    transmission_fluid_stride = 12,
};

/*
 * Torque that a fluid takes from the pump, and the one that it exerts on the turbine; speeds by the reference speed. The
 * faster wheel decides on the sector and on the scale, the square of its speed; the torques depend on the share of the
 * other wheel, from -1 to 1. Column s of `knots` (n, 4) holds the shares from which each polynomial of sector s holds, and
 * column s * n + k of `curves` their coefficients in rising powers. No speed is divided by zero, and speeds that are not
 * finite give no torque.
 */
static inline void transmission_fluid_torques(int n, transmission_real pump, transmission_real turbine,
    const transmission_real *knots, const transmission_real *curves, transmission_real *pump_torque,
    transmission_real *turbine_torque)
{
    const int by_turbine = transmission_abs(turbine) > transmission_abs(pump);
    const transmission_real leading = transmission_select(by_turbine, turbine, pump);
    const transmission_real other = transmission_select(by_turbine, pump, turbine);
    const transmission_real square = leading * leading;
    const int turning = square > 0.0 && transmission_is_finite(square + other);
    const transmission_real share = transmission_select(turning, other, 0.0) / transmission_select(turning, leading, 1.0);
    const int sector = by_turbine + 2 * (turning && leading < 0.0);
    const transmission_real *first = knots + sector * transmission_padded(n);
    const transmission_real *at = first;
    int count = n; /* a constant where this is called; bisection without branches, always the same time */
    at += (share >= at[count / 2]) * (count / 2), count -= count / 2;
    at += (share >= at[count / 2]) * (count / 2), count -= count / 2;
    at += (share >= at[count / 2]) * (count / 2), count -= count / 2;
    at += (share >= at[count / 2]) * (count / 2), count -= count / 2;
    while (count > 1) {
        at += (share >= at[count / 2]) * (count / 2), count -= count / 2;
    }
    const transmission_real *c = curves + (sector * n + (int)(at - first)) * transmission_fluid_stride;
    const transmission_real beyond = share - *at;
    transmission_real faster = c[transmission_fluid_faster - 1];
    for (int k = transmission_fluid_faster - 2; k >= 0; --k) {
        faster = faster * beyond + c[k];
    }
    c += transmission_fluid_faster;
    transmission_real slower = c[transmission_fluid_slower - 1];
    for (int k = transmission_fluid_slower - 2; k >= 0; --k) {
        slower = slower * beyond + c[k];
    }
    const transmission_real scale = transmission_select(turning, square, 0.0);
    *pump_torque = scale * transmission_select(by_turbine, slower, faster);
    *turbine_torque = scale * transmission_select(by_turbine, faster, slower);
}

#endif
