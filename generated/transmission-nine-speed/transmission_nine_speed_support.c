/*
 * transmission_nine_speed_support.c: arithmetic and small dense algebra
 *
 * Emitted by ptgen 0.1.0 from transmission-nine-speed.toml (SHA-256 65236af78ec41a0c), template support.c.jinja.
 * Do not edit: change the test bed file and emit again. This code belongs to whoever emitted it.
 */
#include "transmission_nine_speed_support.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define REAL TRANSMISSION_NINE_SPEED_REAL
#define MAX_ORDER TRANSMISSION_NINE_SPEED_MAX_ORDER

typedef transmission_nine_speed_real real;

real transmission_nine_speed_floor(real a) { return floor(a); }
real transmission_nine_speed_exp(real a) { return exp(a); }
real transmission_nine_speed_sin(real a) { return sin(a); }
real transmission_nine_speed_sqrt(real a) { return sqrt(a); }

void transmission_nine_speed_zero(size_t bytes, void *array) { memset(array, 0, bytes); }

/* Cholesky factor of the leading (n, n) part, lower triangle, in place. */
static int factorise(int n, real *M)
{
    const int stride = transmission_nine_speed_padded(n);
    for (int j = 0; j < n; ++j) {
        real pivot = M[j * stride + j];
        for (int k = 0; k < j; ++k) {
            pivot -= M[k * stride + j] * M[k * stride + j];
        }
        if (!(pivot > 0.0)) {
            return 0;
        }
        const real root = sqrt(pivot);
        M[j * stride + j] = root;
        for (int i = j + 1; i < n; ++i) {
            real sum = M[j * stride + i];
            for (int k = 0; k < j; ++k) {
                sum -= M[k * stride + i] * M[k * stride + j];
            }
            M[j * stride + i] = sum / root;
        }
    }
    return 1;
}

int transmission_nine_speed_cholesky_solve(int n, int columns, real *M, const real *R, real *X)
{
    const int stride = transmission_nine_speed_padded(n);
    if (!factorise(n, M)) {
        return 0;
    }
    for (int c = 0; c < columns; ++c) {
        const real *right = R + c * stride;
        real *solution = X + c * stride;
        for (int i = 0; i < n; ++i) {
            real sum = right[i];
            for (int k = 0; k < i; ++k) {
                sum -= M[k * stride + i] * solution[k];
            }
            solution[i] = sum / M[i * stride + i];
        }
        for (int i = n - 1; i >= 0; --i) {
            real sum = solution[i];
            for (int k = i + 1; k < n; ++k) {
                sum -= M[i * stride + k] * solution[k];
            }
            solution[i] = sum / M[i * stride + i];
        }
    }
    return 1;
}

int transmission_nine_speed_require_definite(int n, int semidefinite, const real *K)
{
    real S[MAX_ORDER * MAX_ORDER];
    real scale[MAX_ORDER];
    const int stride = transmission_nine_speed_padded(n);
    const real tolerance = REAL(1024.0) * DBL_EPSILON;
    for (int i = 0; i < n; ++i) {
        if (!(K[i * stride + i] > 0.0)) {
            return 0;
        }
        scale[i] = 1.0 / sqrt(K[i * stride + i]);
    }
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            S[j * n + i] = K[j * stride + i] * scale[i] * scale[j];
        }
    }
    for (int j = 0; j < n; ++j) {
        int pivot = j;
        real least = S[j * n + j];
        for (int i = j + 1; i < n; ++i) {
            pivot = S[i * n + i] > S[pivot * n + pivot] ? i : pivot;
            least = transmission_nine_speed_min(least, S[i * n + i]);
        }
        if (!(S[pivot * n + pivot] > tolerance)) {
            return semidefinite && least >= -tolerance;
        }
        for (int k = 0; k < n; ++k) {
            const real entry = S[k * n + j];
            S[k * n + j] = S[k * n + pivot];
            S[k * n + pivot] = entry;
        }
        for (int k = 0; k < n; ++k) {
            const real entry = S[j * n + k];
            S[j * n + k] = S[pivot * n + k];
            S[pivot * n + k] = entry;
        }
        for (int k = j + 1; k < n; ++k) {
            for (int i = j + 1; i < n; ++i) {
                S[k * n + i] -= S[j * n + i] * S[k * n + j] / S[j * n + j];
            }
        }
    }
    return 1;
}

void transmission_nine_speed_rounding_unit(real *share) { *share = REAL(64.0) * DBL_EPSILON; }

void transmission_nine_speed_insert(int rows, int target_stride, int source_stride, int row, int column, int first, int count,
    real *target, const real *source)
{
    for (int c = 0; c < count; ++c) {
        for (int i = 0; i < rows; ++i) {
            target[(column + c) * target_stride + row + i] = source[(first + c) * source_stride + i];
        }
    }
}

void transmission_nine_speed_difference(int rows, int columns, const real *A, const real *B, real *C)
{
    const int count = transmission_nine_speed_padded(rows) * columns;
    for (int k = 0; k < count; ++k) {
        C[k] = A[k] - B[k];
    }
}

/* P = X Y, all (size, size), by columns without padding. */
static void product(int size, const real *X, const real *Y, real *P)
{
    for (int j = 0; j < size; ++j) {
        real *column = P + j * size;
        for (int i = 0; i < size; ++i) {
            column[i] = 0.0;
        }
        for (int k = 0; k < size; ++k) {
            const real y = Y[j * size + k];
            for (int i = 0; i < size; ++i) {
                column[i] += X[k * size + i] * y;
            }
        }
    }
}

int transmission_nine_speed_discretise(int n, int total, int squarings, const real *A, const real *scale, real t, real *E)
{
    real X[MAX_ORDER * MAX_ORDER];
    real S[MAX_ORDER * MAX_ORDER];
    real P[MAX_ORDER * MAX_ORDER];
    const int stride = transmission_nine_speed_padded(n);
    real factor = t;
    for (int k = 0; k < squarings; ++k) {
        factor *= REAL(0.5);
    }
    for (int j = 0; j < total; ++j) {
        real norm = 0.0;
        for (int i = 0; i < total; ++i) {
            const real entry = i < n ? A[j * stride + i] * scale[j] / scale[i] * factor : 0.0;
            X[j * total + i] = entry;
            norm += transmission_nine_speed_abs(entry);
        }
        if (!(norm <= 1.0)) {
            return 0;
        }
    }
    for (int k = 0; k < total * total; ++k) {
        S[k] = X[k] / REAL(18) + (k % (total + 1) == 0 ? 1.0 : 0.0);
    }
    for (int degree = 17; degree > 0; --degree) {
        product(total, X, S, P);
        for (int k = 0; k < total * total; ++k) {
            S[k] = P[k] / (real)degree + (k % (total + 1) == 0 ? 1.0 : 0.0);
        }
    }
    for (int k = 0; k < squarings; ++k) {
        product(total, S, S, P);
        memcpy(S, P, sizeof(real) * (size_t)(total * total));
    }
    for (int j = 0; j < total; ++j) {
        for (int i = 0; i < n; ++i) {
            E[j * stride + i] = S[j * total + i] * scale[i] / scale[j];
        }
    }
    return 1;
}
