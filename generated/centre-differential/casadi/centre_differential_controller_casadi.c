/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) centre_differential_controller_casadi_ ## ID
#endif

#include <math.h>

#ifndef casadi_real
#define casadi_real double
#endif

#ifndef casadi_int
#define casadi_int long long int
#endif

/* Add prefix to internal symbols */
#define casadi_f0 CASADI_PREFIX(f0)
#define casadi_f1 CASADI_PREFIX(f1)
#define casadi_fabs CASADI_PREFIX(fabs)
#define casadi_fmax CASADI_PREFIX(fmax)
#define casadi_fmin CASADI_PREFIX(fmin)
#define casadi_s0 CASADI_PREFIX(s0)
#define casadi_s1 CASADI_PREFIX(s1)
#define casadi_s2 CASADI_PREFIX(s2)
#define casadi_s3 CASADI_PREFIX(s3)
#define casadi_s4 CASADI_PREFIX(s4)
#define casadi_sq CASADI_PREFIX(sq)
#define casadi_zeros CASADI_PREFIX(zeros)

/* Symbol visibility in DLLs */
#ifndef CASADI_SYMBOL_EXPORT
  #if defined(_WIN32) || defined(__WIN32__) || defined(__CYGWIN__)
    #if defined(STATIC_LINKED)
      #define CASADI_SYMBOL_EXPORT
    #else
      #define CASADI_SYMBOL_EXPORT __declspec(dllexport)
    #endif
  #elif defined(__GNUC__) && defined(GCC_HASCLASSVISIBILITY)
    #define CASADI_SYMBOL_EXPORT __attribute__ ((visibility ("default")))
  #else
    #define CASADI_SYMBOL_EXPORT
  #endif
#endif

casadi_real casadi_sq(casadi_real x) { return x*x;}

casadi_real casadi_fabs(casadi_real x) {
/* Pre-c99 compatibility */
#if __STDC_VERSION__ < 199901L
  return x>0 ? x : -x;
#else
  return fabs(x);
#endif
}

casadi_real casadi_fmax(casadi_real x, casadi_real y) {
/* Pre-c99 compatibility */
#if __STDC_VERSION__ < 199901L
  return x>y ? x : y;
#else
  return fmax(x, y);
#endif
}

casadi_real casadi_fmin(casadi_real x, casadi_real y) {
/* Pre-c99 compatibility */
#if __STDC_VERSION__ < 199901L
  return x<y ? x : y;
#else
  return fmin(x, y);
#endif
}

/* Configuration this file was compiled with */
CASADI_SYMBOL_EXPORT void centre_differential_controller_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int centre_differential_controller_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int centre_differential_controller_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {58, 1, 1};
static const casadi_int casadi_s1[3] = {24, 1, 1};
static const casadi_int casadi_s2[3] = {37, 1, 1};
static const casadi_int casadi_s3[3] = {9, 1, 1};
static const casadi_int casadi_s4[3] = {3, 1, 1};

static const casadi_real casadi_zeros[58] = 
  {0.};

/* controller_prepare:(parameters[58])->(derived[24]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real w1, w2, w3, w4, w5, w6, w7, w8;
  const casadi_real *wr0;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = @0[0] */
  w1 = wr0[0];
  /* #2: @2 = @0[13] */
  w2 = wr0[13];
  /* #3: @2 = (@1/@2) */
  w2  = (w1/w2);
  /* #4: output[0][0] = @2 */
  if (res[0]) res[0][0] = w2;
  /* #5: @2 = @0[18] */
  w2 = wr0[18];
  /* #6: @3 = (1./@2) */
  w3 = (1./ w2 );
  /* #7: output[0][1] = @3 */
  if (res[0]) res[0][1] = w3;
  /* #8: @3 = 1 */
  w3 = 1.;
  /* #9: @4 = @0[17] */
  w4 = wr0[17];
  /* #10: @4 = (@4/@2) */
  w4 /= w2;
  /* #11: @3 = (@3+@4) */
  w3 += w4;
  /* #12: output[0][2] = @3 */
  if (res[0]) res[0][2] = w3;
  /* #13: @3 = @0[22] */
  w3 = wr0[22];
  /* #14: @4 = (1./@3) */
  w4 = (1./ w3 );
  /* #15: output[0][3] = @4 */
  if (res[0]) res[0][3] = w4;
  /* #16: @4 = 1 */
  w4 = 1.;
  /* #17: @2 = @0[21] */
  w2 = wr0[21];
  /* #18: @2 = (@2/@3) */
  w2 /= w3;
  /* #19: @4 = (@4+@2) */
  w4 += w2;
  /* #20: output[0][4] = @4 */
  if (res[0]) res[0][4] = w4;
  /* #21: @4 = @0[26] */
  w4 = wr0[26];
  /* #22: @2 = (1./@4) */
  w2 = (1./ w4 );
  /* #23: output[0][5] = @2 */
  if (res[0]) res[0][5] = w2;
  /* #24: @2 = 1 */
  w2 = 1.;
  /* #25: @3 = @0[25] */
  w3 = wr0[25];
  /* #26: @3 = (@3/@4) */
  w3 /= w4;
  /* #27: @2 = (@2+@3) */
  w2 += w3;
  /* #28: output[0][6] = @2 */
  if (res[0]) res[0][6] = w2;
  /* #29: @2 = @0[28] */
  w2 = wr0[28];
  /* #30: @2 = (@2*@1) */
  w2 *= w1;
  /* #31: output[0][7] = @2 */
  if (res[0]) res[0][7] = w2;
  /* #32: @2 = @0[30] */
  w2 = wr0[30];
  /* #33: @3 = (@2*@1) */
  w3  = (w2*w1);
  /* #34: output[0][8] = @3 */
  if (res[0]) res[0][8] = w3;
  /* #35: @2 = (@2*@1) */
  w2 *= w1;
  /* #36: @3 = @0[29] */
  w3 = wr0[29];
  /* #37: @2 = (@2/@3) */
  w2 /= w3;
  /* #38: output[0][9] = @2 */
  if (res[0]) res[0][9] = w2;
  /* #39: @2 = @0[31] */
  w2 = wr0[31];
  /* #40: @3 = @0[32] */
  w3 = wr0[32];
  /* #41: @2 = (@2/@3) */
  w2 /= w3;
  /* #42: output[0][10] = @2 */
  if (res[0]) res[0][10] = w2;
  /* #43: @2 = @0[36] */
  w2 = wr0[36];
  /* #44: @2 = (@2*@1) */
  w2 *= w1;
  /* #45: output[0][11] = @2 */
  if (res[0]) res[0][11] = w2;
  /* #46: @2 = @0[37] */
  w2 = wr0[37];
  /* #47: @2 = (@2*@1) */
  w2 *= w1;
  /* #48: @4 = @0[33] */
  w4 = wr0[33];
  /* #49: @2 = (@2/@4) */
  w2 /= w4;
  /* #50: output[0][12] = @2 */
  if (res[0]) res[0][12] = w2;
  /* #51: @2 = @0[38] */
  w2 = wr0[38];
  /* #52: @2 = (@2*@1) */
  w2 *= w1;
  /* #53: @2 = (@2/@4) */
  w2 /= w4;
  /* #54: output[0][13] = @2 */
  if (res[0]) res[0][13] = w2;
  /* #55: @2 = @0[40] */
  w2 = wr0[40];
  /* #56: @2 = (@2/@3) */
  w2 /= w3;
  /* #57: output[0][14] = @2 */
  if (res[0]) res[0][14] = w2;
  /* #58: @2 = @0[44] */
  w2 = wr0[44];
  /* #59: @2 = (@2*@1) */
  w2 *= w1;
  /* #60: output[0][15] = @2 */
  if (res[0]) res[0][15] = w2;
  /* #61: @2 = @0[45] */
  w2 = wr0[45];
  /* #62: @2 = (@2*@1) */
  w2 *= w1;
  /* #63: @3 = @0[41] */
  w3 = wr0[41];
  /* #64: @2 = (@2/@3) */
  w2 /= w3;
  /* #65: output[0][16] = @2 */
  if (res[0]) res[0][16] = w2;
  /* #66: @2 = @0[46] */
  w2 = wr0[46];
  /* #67: @2 = (@2*@1) */
  w2 *= w1;
  /* #68: @2 = (@2/@3) */
  w2 /= w3;
  /* #69: output[0][17] = @2 */
  if (res[0]) res[0][17] = w2;
  /* #70: @2 = @0[49] */
  w2 = wr0[49];
  /* #71: @3 = @0[48] */
  w3 = wr0[48];
  /* #72: @4 = (@2/@3) */
  w4  = (w2/w3);
  /* #73: @4 = (-@4) */
  w4 = (- w4 );
  /* #74: output[0][18] = @4 */
  if (res[0]) res[0][18] = w4;
  /* #75: @4 = @0[50] */
  w4 = wr0[50];
  /* #76: @5 = (@4*@2) */
  w5  = (w4*w2);
  /* #77: @5 = (@3+@5) */
  w5  = (w3+w5);
  /* #78: @5 = (@5/@3) */
  w5 /= w3;
  /* #79: output[0][19] = @5 */
  if (res[0]) res[0][19] = w5;
  /* #80: @5 = @0[51] */
  w5 = wr0[51];
  /* #81: @5 = (@5*@1) */
  w5 *= w1;
  /* #82: output[0][20] = @5 */
  if (res[0]) res[0][20] = w5;
  /* #83: @5 = @0[54] */
  w5 = wr0[54];
  /* #84: @6 = (@4*@5) */
  w6  = (w4*w5);
  /* #85: @6 = (@2+@6) */
  w6  = (w2+w6);
  /* #86: @7 = sq(@4) */
  w7 = casadi_sq( w4 );
  /* #87: @7 = (@5*@7) */
  w7  = (w5*w7);
  /* #88: @7 = (@3+@7) */
  w7  = (w3+w7);
  /* #89: @8 = (2.*@4) */
  w8 = (2.* w4 );
  /* #90: @8 = (@8*@2) */
  w8 *= w2;
  /* #91: @7 = (@7+@8) */
  w7 += w8;
  /* #92: @6 = (@6/@7) */
  w6 /= w7;
  /* #93: output[0][21] = @6 */
  if (res[0]) res[0][21] = w6;
  /* #94: @6 = (@4*@2) */
  w6  = (w4*w2);
  /* #95: @6 = (@3+@6) */
  w6  = (w3+w6);
  /* #96: @7 = sq(@4) */
  w7 = casadi_sq( w4 );
  /* #97: @5 = (@5*@7) */
  w5 *= w7;
  /* #98: @3 = (@3+@5) */
  w3 += w5;
  /* #99: @4 = (2.*@4) */
  w4 = (2.* w4 );
  /* #100: @4 = (@4*@2) */
  w4 *= w2;
  /* #101: @3 = (@3+@4) */
  w3 += w4;
  /* #102: @6 = (@6/@3) */
  w6 /= w3;
  /* #103: output[0][22] = @6 */
  if (res[0]) res[0][22] = w6;
  /* #104: @6 = @0[55] */
  w6 = wr0[55];
  /* #105: @6 = (@6*@1) */
  w6 *= w1;
  /* #106: output[0][23] = @6 */
  if (res[0]) res[0][23] = w6;
  return 0;
}

CASADI_SYMBOL_EXPORT int controller_prepare(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int controller_prepare_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void controller_prepare_release(int mem) {
}

CASADI_SYMBOL_EXPORT void controller_prepare_incref(void) {
}

CASADI_SYMBOL_EXPORT void controller_prepare_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int controller_prepare_n_in(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_int controller_prepare_n_out(void) { return 1;}

CASADI_SYMBOL_EXPORT casadi_real controller_prepare_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* controller_prepare_name_in(casadi_int i) {
  switch (i) {
    case 0: return "parameters";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* controller_prepare_name_out(casadi_int i) {
  switch (i) {
    case 0: return "derived";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* controller_prepare_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* controller_prepare_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s1;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int controller_prepare_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 2;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int controller_prepare_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 2*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}

/* controller_step:(parameters[58],derived[24],states[37],inputs[9])->(next_states[37],outputs[3]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69;
  a00=arg[0]? arg[0][24] : 0;
  a01=arg[0]? arg[0][27] : 0;
  a02=(a00*a01);
  a03=arg[3]? arg[3][8] : 0;
  a04=casadi_fabs(a03);
  a05=arg[0]? arg[0][10] : 0;
  a04=(a04<=a05);
  a03=(a04?a03:0);
  a05=(!a04);
  a06=arg[2]? arg[2][9] : 0;
  a05=(a05?a06:0);
  a03=(a03+a05);
  a05=casadi_fabs(a03);
  a00=casadi_fmax(a00,a05);
  a02=(a02/a00);
  a00=0.;
  a05=1.;
  a06=arg[1]? arg[1][6] : 0;
  a07=arg[1]? arg[1][5] : 0;
  a08=(a03*a07);
  a08=(a06+a08);
  a08=casadi_fmin(a05,a08);
  a08=casadi_fmax(a00,a08);
  a08=(a02*a08);
  a09=(-a08);
  a07=(a03*a07);
  a06=(a06-a07);
  a06=casadi_fmin(a05,a06);
  a06=casadi_fmax(a00,a06);
  a02=(a02*a06);
  a06=arg[0]? arg[0][15] : 0;
  a07=5.0000000000000000e-01;
  a10=arg[2]? arg[2][13] : 0;
  a11=(a07<a10);
  a12=arg[2]? arg[2][20] : 0;
  a12=(a11?a12:0);
  a11=(!a11);
  a11=(a11?a06:0);
  a12=(a12+a11);
  a11=(a06-a12);
  a13=casadi_fabs(a11);
  a14=arg[2]? arg[2][21] : 0;
  a14=(a06!=a14);
  a15=arg[1]? arg[1][0] : 0;
  a16=casadi_fabs(a11);
  a16=(a15*a16);
  a17=9.9999999999999995e-07;
  a18=casadi_fabs(a06);
  a18=(a17*a18);
  a19=casadi_fabs(a12);
  a19=(a17*a19);
  a18=(a18+a19);
  a16=casadi_fmax(a16,a18);
  a16=(a14?a16:0);
  a14=(!a14);
  a18=arg[2]? arg[2][22] : 0;
  a14=(a14?a18:0);
  a16=(a16+a14);
  a13=(a13<=a16);
  a14=(a13?a06:0);
  a13=(!a13);
  a18=(a00<a11);
  a19=(a12+a16);
  a19=(a18?a19:0);
  a18=(!a18);
  a12=(a12-a16);
  a18=(a18?a12:0);
  a19=(a19+a18);
  a13=(a13?a19:0);
  a14=(a14+a13);
  a13=arg[3]? arg[3][3] : 0;
  a19=casadi_fabs(a13);
  a18=arg[0]? arg[0][5] : 0;
  a19=(a19<=a18);
  a13=(a19?a13:0);
  a18=(!a19);
  a12=arg[2]? arg[2][4] : 0;
  a18=(a18?a12:0);
  a13=(a13+a18);
  a18=arg[1]? arg[1][21] : 0;
  a18=(a13*a18);
  a18=(a18-a03);
  a12=arg[3]? arg[3][6] : 0;
  a20=casadi_fabs(a12);
  a21=arg[0]? arg[0][8] : 0;
  a20=(a20<=a21);
  a12=(a20?a12:0);
  a21=(!a20);
  a22=arg[2]? arg[2][7] : 0;
  a21=(a21?a22:0);
  a12=(a12+a21);
  a21=arg[1]? arg[1][22] : 0;
  a21=(a12*a21);
  a18=(a18+a21);
  a18=(a14*a18);
  a21=arg[0]? arg[0][56] : 0;
  a22=(a05-a21);
  a08=(a08*a22);
  a08=(-a08);
  a22=(a07<a10);
  a23=arg[2]? arg[2][32] : 0;
  a22=(a22?a23:0);
  a23=arg[0]? arg[0][42] : 0;
  a24=(a07<a10);
  a25=arg[2]? arg[2][29] : 0;
  a25=(a24?a25:0);
  a24=(!a24);
  a26=arg[3]? arg[3][7] : 0;
  a27=casadi_fabs(a26);
  a28=arg[0]? arg[0][9] : 0;
  a27=(a27<=a28);
  a26=(a27?a26:0);
  a28=(!a27);
  a29=arg[2]? arg[2][8] : 0;
  a28=(a28?a29:0);
  a26=(a26+a28);
  a28=arg[0]? arg[0][16] : 0;
  a29=arg[0]? arg[0][19] : 0;
  a30=(a28*a29);
  a31=casadi_fabs(a13);
  a28=casadi_fmax(a28,a31);
  a30=(a30/a28);
  a28=arg[1]? arg[1][2] : 0;
  a31=arg[1]? arg[1][1] : 0;
  a32=(a13*a31);
  a32=(a28+a32);
  a32=casadi_fmin(a05,a32);
  a32=casadi_fmax(a00,a32);
  a32=(a30*a32);
  a32=(-a32);
  a31=(a13*a31);
  a28=(a28-a31);
  a28=casadi_fmin(a05,a28);
  a28=casadi_fmax(a00,a28);
  a30=(a30*a28);
  a28=arg[0]? arg[0][30] : 0;
  a28=(a00<a28);
  a31=arg[3]? arg[3][4] : 0;
  a33=casadi_fabs(a31);
  a34=arg[0]? arg[0][6] : 0;
  a33=(a33<=a34);
  a31=(a33?a31:0);
  a34=(!a33);
  a35=arg[2]? arg[2][5] : 0;
  a34=(a34?a35:0);
  a31=(a31+a34);
  a34=(a07<a10);
  a35=arg[2]? arg[2][10] : 0;
  a35=(a34?a35:0);
  a34=(!a34);
  a36=arg[0]? arg[0][11] : 0;
  a34=(a34?a36:0);
  a35=(a35+a34);
  a34=(a36-a35);
  a37=casadi_fabs(a34);
  a38=arg[2]? arg[2][11] : 0;
  a38=(a36!=a38);
  a39=casadi_fabs(a34);
  a39=(a15*a39);
  a40=casadi_fabs(a36);
  a40=(a17*a40);
  a41=casadi_fabs(a35);
  a41=(a17*a41);
  a40=(a40+a41);
  a39=casadi_fmax(a39,a40);
  a39=(a38?a39:0);
  a38=(!a38);
  a40=arg[2]? arg[2][12] : 0;
  a38=(a38?a40:0);
  a39=(a39+a38);
  a37=(a37<=a39);
  a38=(a37?a36:0);
  a37=(!a37);
  a40=(a00<a34);
  a41=(a35+a39);
  a41=(a40?a41:0);
  a40=(!a40);
  a42=(a35-a39);
  a40=(a40?a42:0);
  a41=(a41+a40);
  a37=(a37?a41:0);
  a38=(a38+a37);
  a35=(a35-a38);
  a35=(a31*a35);
  a28=(a28?a35:0);
  a35=(a07<a10);
  a37=arg[2]? arg[2][24] : 0;
  a35=(a35?a37:0);
  a28=(a28+a35);
  a35=(a07<a10);
  a37=arg[2]? arg[2][23] : 0;
  a37=(a35?a37:0);
  a35=(!a35);
  a35=(a35?a13:0);
  a37=(a37+a35);
  a35=arg[1]? arg[1][7] : 0;
  a41=(-a35);
  a40=arg[3]? arg[3][2] : 0;
  a42=casadi_fabs(a40);
  a43=arg[0]? arg[0][4] : 0;
  a42=(a42<=a43);
  a40=(a42?a40:0);
  a43=(!a42);
  a44=arg[2]? arg[2][3] : 0;
  a43=(a43?a44:0);
  a40=(a40+a43);
  a43=(a40-a37);
  a35=casadi_fmin(a35,a43);
  a41=casadi_fmax(a41,a35);
  a37=(a37+a41);
  a41=(a37-a13);
  a35=arg[0]? arg[0][29] : 0;
  a35=(a41*a35);
  a35=(a28+a35);
  a43=(a31*a38);
  a35=(a35+a43);
  a30=casadi_fmin(a30,a35);
  a32=casadi_fmax(a32,a30);
  a30=(a32-a31);
  a43=arg[1]? arg[1][14] : 0;
  a43=(a30*a43);
  a43=(a26+a43);
  a24=(a24?a43:0);
  a25=(a25+a24);
  a24=arg[1]? arg[1][15] : 0;
  a44=(-a24);
  a45=arg[3]? arg[3][1] : 0;
  a46=casadi_fabs(a45);
  a47=arg[0]? arg[0][3] : 0;
  a46=(a46<=a47);
  a45=(a46?a45:0);
  a47=(!a46);
  a48=arg[2]? arg[2][2] : 0;
  a47=(a47?a48:0);
  a45=(a45+a47);
  a47=(a45-a25);
  a24=casadi_fmin(a24,a47);
  a44=casadi_fmax(a44,a24);
  a25=(a25+a44);
  a23=(a23*a25);
  a23=(a22+a23);
  a44=(a07<a10);
  a24=arg[2]? arg[2][30] : 0;
  a24=(a44?a24:0);
  a44=(!a44);
  a44=(a44?a43:0);
  a24=(a24+a44);
  a44=(a07<a10);
  a47=arg[2]? arg[2][31] : 0;
  a48=(a44?a47:0);
  a49=arg[1]? arg[1][16] : 0;
  a50=(a25-a24);
  a49=(a49*a50);
  a48=(a48+a49);
  a49=arg[1]? arg[1][17] : 0;
  a49=(a49*a47);
  a49=(-a49);
  a44=(a44?a49:0);
  a48=(a48+a44);
  a44=arg[0]? arg[0][0] : 0;
  a49=(a48*a44);
  a24=(a24+a49);
  a49=arg[0]? arg[0][47] : 0;
  a47=(a24*a49);
  a47=(a47-a43);
  a49=(a05-a49);
  a49=(a25*a49);
  a47=(a47+a49);
  a49=arg[0]? arg[0][43] : 0;
  a49=(a47*a49);
  a23=(a23+a49);
  a49=(-a23);
  a21=(a05-a21);
  a21=(a02*a21);
  a49=casadi_fmin(a49,a21);
  a08=casadi_fmax(a08,a49);
  a18=(a18+a08);
  a02=casadi_fmin(a02,a18);
  a09=casadi_fmax(a09,a02);
  a02=casadi_fabs(a09);
  a18=1.0100000000000000e+00;
  a01=(a18*a01);
  a02=(a02<=a01);
  a01=(a02?a05:0);
  a01=(a01<a07);
  a49=arg[0]? arg[0][20] : 0;
  a21=arg[0]? arg[0][23] : 0;
  a43=(a49*a21);
  a50=casadi_fabs(a12);
  a49=casadi_fmax(a49,a50);
  a43=(a43/a49);
  a49=arg[1]? arg[1][4] : 0;
  a50=arg[1]? arg[1][3] : 0;
  a51=(a12*a50);
  a51=(a49+a51);
  a51=casadi_fmin(a05,a51);
  a51=casadi_fmax(a00,a51);
  a51=(a43*a51);
  a52=(-a51);
  a50=(a12*a50);
  a49=(a49-a50);
  a49=casadi_fmin(a05,a49);
  a49=casadi_fmax(a00,a49);
  a43=(a43*a49);
  a49=arg[0]? arg[0][14] : 0;
  a50=(a07<a10);
  a53=arg[2]? arg[2][17] : 0;
  a53=(a50?a53:0);
  a50=(!a50);
  a50=(a50?a49:0);
  a53=(a53+a50);
  a50=(a49-a53);
  a54=casadi_fabs(a50);
  a55=arg[2]? arg[2][18] : 0;
  a55=(a49!=a55);
  a56=casadi_fabs(a50);
  a56=(a15*a56);
  a57=casadi_fabs(a49);
  a57=(a17*a57);
  a58=casadi_fabs(a53);
  a58=(a17*a58);
  a57=(a57+a58);
  a56=casadi_fmax(a56,a57);
  a56=(a55?a56:0);
  a55=(!a55);
  a57=arg[2]? arg[2][19] : 0;
  a55=(a55?a57:0);
  a56=(a56+a55);
  a54=(a54<=a56);
  a55=(a54?a49:0);
  a54=(!a54);
  a57=(a00<a50);
  a58=(a53+a56);
  a58=(a57?a58:0);
  a57=(!a57);
  a53=(a53-a56);
  a57=(a57?a53:0);
  a58=(a58+a57);
  a54=(a54?a58:0);
  a55=(a55+a54);
  a54=arg[1]? arg[1][18] : 0;
  a54=(a13*a54);
  a54=(a54-a12);
  a58=arg[1]? arg[1][19] : 0;
  a58=(a58*a03);
  a54=(a54+a58);
  a54=(a55*a54);
  a58=arg[0]? arg[0][52] : 0;
  a57=(a05-a58);
  a51=(a51*a57);
  a51=(-a51);
  a57=(a07<a10);
  a53=arg[2]? arg[2][28] : 0;
  a57=(a57?a53:0);
  a53=arg[0]? arg[0][34] : 0;
  a59=(a07<a10);
  a60=arg[2]? arg[2][25] : 0;
  a60=(a59?a60:0);
  a59=(!a59);
  a61=arg[3]? arg[3][5] : 0;
  a62=casadi_fabs(a61);
  a63=arg[0]? arg[0][7] : 0;
  a62=(a62<=a63);
  a61=(a62?a61:0);
  a63=(!a62);
  a64=arg[2]? arg[2][6] : 0;
  a63=(a63?a64:0);
  a61=(a61+a63);
  a63=arg[1]? arg[1][10] : 0;
  a30=(a30*a63);
  a30=(a61+a30);
  a59=(a59?a30:0);
  a60=(a60+a59);
  a59=arg[1]? arg[1][11] : 0;
  a63=(-a59);
  a64=arg[3]? arg[3][0] : 0;
  a65=casadi_fabs(a64);
  a66=arg[0]? arg[0][2] : 0;
  a65=(a65<=a66);
  a64=(a65?a64:0);
  a66=(!a65);
  a67=arg[2]? arg[2][1] : 0;
  a66=(a66?a67:0);
  a64=(a64+a66);
  a66=(a64-a60);
  a59=casadi_fmin(a59,a66);
  a63=casadi_fmax(a63,a59);
  a60=(a60+a63);
  a53=(a53*a60);
  a53=(a57+a53);
  a63=(a07<a10);
  a59=arg[2]? arg[2][26] : 0;
  a59=(a63?a59:0);
  a63=(!a63);
  a63=(a63?a30:0);
  a59=(a59+a63);
  a63=(a07<a10);
  a66=arg[2]? arg[2][27] : 0;
  a67=(a63?a66:0);
  a68=arg[1]? arg[1][12] : 0;
  a69=(a60-a59);
  a68=(a68*a69);
  a67=(a67+a68);
  a68=arg[1]? arg[1][13] : 0;
  a68=(a68*a66);
  a68=(-a68);
  a63=(a63?a68:0);
  a67=(a67+a63);
  a63=(a67*a44);
  a59=(a59+a63);
  a63=arg[0]? arg[0][39] : 0;
  a68=(a59*a63);
  a68=(a68-a30);
  a63=(a05-a63);
  a63=(a60*a63);
  a68=(a68+a63);
  a63=arg[0]? arg[0][35] : 0;
  a63=(a68*a63);
  a53=(a53+a63);
  a63=(-a53);
  a58=(a05-a58);
  a58=(a43*a58);
  a63=casadi_fmin(a63,a58);
  a51=casadi_fmax(a51,a63);
  a54=(a54+a51);
  a43=casadi_fmin(a43,a54);
  a52=casadi_fmax(a52,a43);
  a43=casadi_fabs(a52);
  a21=(a18*a21);
  a43=(a43<=a21);
  a21=(a43?a05:0);
  a21=(a21<a07);
  a54=casadi_fabs(a32);
  a18=(a18*a29);
  a54=(a54<=a18);
  a18=(a54?a05:0);
  a18=(a18<a07);
  a04=(a04?a05:0);
  a04=(a04<a07);
  a20=(a20?a05:0);
  a20=(a20<a07);
  a19=(a19?a05:0);
  a19=(a19<a07);
  a42=(a42?a05:0);
  a42=(a42<a07);
  a29=arg[2]? arg[2][0] : 0;
  a63=(a29<a07);
  a65=(a65?a05:0);
  a65=(a65<a07);
  a63=(a63&&a65);
  a65=(a63?a05:0);
  a63=(!a63);
  a63=(a63?a29:0);
  a65=(a65+a63);
  a63=(a65<a07);
  a46=(a46?a05:0);
  a46=(a46<a07);
  a63=(a63&&a46);
  a46=2.;
  a46=(a63?a46:0);
  a63=(!a63);
  a63=(a63?a65:0);
  a46=(a46+a63);
  a63=(a46<a07);
  a42=(a42&&a63);
  a63=3.;
  a63=(a42?a63:0);
  a42=(!a42);
  a42=(a42?a46:0);
  a63=(a63+a42);
  a42=(a63<a07);
  a19=(a19&&a42);
  a42=4.;
  a42=(a19?a42:0);
  a19=(!a19);
  a19=(a19?a63:0);
  a42=(a42+a19);
  a19=(a42<a07);
  a33=(a33?a05:0);
  a33=(a33<a07);
  a19=(a19&&a33);
  a33=5.;
  a33=(a19?a33:0);
  a19=(!a19);
  a19=(a19?a42:0);
  a33=(a33+a19);
  a19=(a33<a07);
  a62=(a62?a05:0);
  a62=(a62<a07);
  a19=(a19&&a62);
  a62=6.;
  a62=(a19?a62:0);
  a19=(!a19);
  a19=(a19?a33:0);
  a62=(a62+a19);
  a19=(a62<a07);
  a20=(a20&&a19);
  a19=7.;
  a19=(a20?a19:0);
  a20=(!a20);
  a20=(a20?a62:0);
  a19=(a19+a20);
  a20=(a19<a07);
  a27=(a27?a05:0);
  a27=(a27<a07);
  a20=(a20&&a27);
  a27=8.;
  a27=(a20?a27:0);
  a20=(!a20);
  a20=(a20?a19:0);
  a27=(a27+a20);
  a20=(a27<a07);
  a04=(a04&&a20);
  a20=9.;
  a20=(a04?a20:0);
  a04=(!a04);
  a04=(a04?a27:0);
  a20=(a20+a04);
  a04=(a20<a07);
  a18=(a18&&a04);
  a04=10.;
  a04=(a18?a04:0);
  a18=(!a18);
  a18=(a18?a20:0);
  a04=(a04+a18);
  a18=(a04<a07);
  a21=(a21&&a18);
  a18=11.;
  a18=(a21?a18:0);
  a21=(!a21);
  a21=(a21?a04:0);
  a18=(a18+a21);
  a21=(a18<a07);
  a01=(a01&&a21);
  a21=12.;
  a21=(a01?a21:0);
  a01=(!a01);
  a01=(a01?a18:0);
  a21=(a21+a01);
  if (res[0]!=0) res[0][0]=a21;
  if (res[0]!=0) res[0][1]=a64;
  if (res[0]!=0) res[0][2]=a45;
  if (res[0]!=0) res[0][3]=a40;
  if (res[0]!=0) res[0][4]=a13;
  if (res[0]!=0) res[0][5]=a31;
  if (res[0]!=0) res[0][6]=a61;
  if (res[0]!=0) res[0][7]=a12;
  if (res[0]!=0) res[0][8]=a26;
  if (res[0]!=0) res[0][9]=a03;
  if (res[0]!=0) res[0][10]=a38;
  if (res[0]!=0) res[0][11]=a36;
  a34=casadi_fabs(a34);
  a34=(a34<=a39);
  a34=(!a34);
  a34=(a34?a39:0);
  if (res[0]!=0) res[0][12]=a34;
  a34=(a21<a07);
  a34=(a34?a05:0);
  if (res[0]!=0) res[0][13]=a34;
  a34=arg[0]? arg[0][12] : 0;
  a10=(a07<a10);
  a05=arg[2]? arg[2][14] : 0;
  a05=(a10?a05:0);
  a10=(!a10);
  a10=(a10?a34:0);
  a05=(a05+a10);
  a10=(a34-a05);
  a39=casadi_fabs(a10);
  a36=arg[2]? arg[2][15] : 0;
  a36=(a34!=a36);
  a38=casadi_fabs(a10);
  a15=(a15*a38);
  a38=casadi_fabs(a34);
  a38=(a17*a38);
  a03=casadi_fabs(a05);
  a17=(a17*a03);
  a38=(a38+a17);
  a15=casadi_fmax(a15,a38);
  a15=(a36?a15:0);
  a36=(!a36);
  a38=arg[2]? arg[2][16] : 0;
  a36=(a36?a38:0);
  a15=(a15+a36);
  a39=(a39<=a15);
  a36=(a39?a34:0);
  a39=(!a39);
  a38=(a00<a10);
  a17=(a05+a15);
  a17=(a38?a17:0);
  a38=(!a38);
  a05=(a05-a15);
  a38=(a38?a05:0);
  a17=(a17+a38);
  a39=(a39?a17:0);
  a36=(a36+a39);
  if (res[0]!=0) res[0][14]=a36;
  if (res[0]!=0) res[0][15]=a34;
  a10=casadi_fabs(a10);
  a10=(a10<=a15);
  a10=(!a10);
  a10=(a10?a15:0);
  if (res[0]!=0) res[0][16]=a10;
  if (res[0]!=0) res[0][17]=a55;
  if (res[0]!=0) res[0][18]=a49;
  a50=casadi_fabs(a50);
  a50=(a50<=a56);
  a50=(!a50);
  a50=(a50?a56:0);
  if (res[0]!=0) res[0][19]=a50;
  if (res[0]!=0) res[0][20]=a14;
  if (res[0]!=0) res[0][21]=a06;
  a11=casadi_fabs(a11);
  a11=(a11<=a16);
  a11=(!a11);
  a11=(a11?a16:0);
  if (res[0]!=0) res[0][22]=a11;
  if (res[0]!=0) res[0][23]=a37;
  a35=(a32-a35);
  a37=arg[1]? arg[1][9] : 0;
  a35=(a35*a37);
  a28=(a28+a35);
  a35=arg[1]? arg[1][8] : 0;
  a41=(a41*a35);
  a28=(a28+a41);
  if (res[0]!=0) res[0][24]=a28;
  if (res[0]!=0) res[0][25]=a60;
  if (res[0]!=0) res[0][26]=a59;
  if (res[0]!=0) res[0][27]=a67;
  a53=(a53+a51);
  a53=(a68*a53);
  a53=(-a53);
  a53=(a53<a00);
  a51=(a53?a57:0);
  a53=(!a53);
  a67=arg[0]? arg[0][53] : 0;
  a59=(-a67);
  a60=arg[1]? arg[1][20] : 0;
  a68=(a68*a60);
  a57=(a57+a68);
  a67=casadi_fmin(a67,a57);
  a59=casadi_fmax(a59,a67);
  a53=(a53?a59:0);
  a51=(a51+a53);
  if (res[0]!=0) res[0][28]=a51;
  if (res[0]!=0) res[0][29]=a25;
  if (res[0]!=0) res[0][30]=a24;
  if (res[0]!=0) res[0][31]=a48;
  a23=(a23+a08);
  a23=(a47*a23);
  a23=(-a23);
  a23=(a23<a00);
  a08=(a23?a22:0);
  a23=(!a23);
  a48=arg[0]? arg[0][57] : 0;
  a24=(-a48);
  a25=arg[1]? arg[1][23] : 0;
  a47=(a47*a25);
  a22=(a22+a47);
  a48=casadi_fmin(a48,a22);
  a24=casadi_fmax(a24,a48);
  a23=(a23?a24:0);
  a08=(a08+a23);
  if (res[0]!=0) res[0][32]=a08;
  a08=(a07<a21);
  a23=arg[2]? arg[2][33] : 0;
  a24=(a08?a23:0);
  a08=(!a08);
  a32=(a54?a32:0);
  a54=(!a54);
  a54=(a54?a23:0);
  a32=(a32+a54);
  a08=(a08?a32:0);
  a24=(a24+a08);
  if (res[0]!=0) res[0][33]=a24;
  a08=(a07<a21);
  a32=arg[2]? arg[2][34] : 0;
  a54=(a08?a32:0);
  a08=(!a08);
  a52=(a43?a52:0);
  a43=(!a43);
  a43=(a43?a32:0);
  a52=(a52+a43);
  a08=(a08?a52:0);
  a54=(a54+a08);
  if (res[0]!=0) res[0][34]=a54;
  a08=(a07<a21);
  a52=arg[2]? arg[2][35] : 0;
  a43=(a08?a52:0);
  a08=(!a08);
  a09=(a02?a09:0);
  a02=(!a02);
  a02=(a02?a52:0);
  a09=(a09+a02);
  a08=(a08?a09:0);
  a43=(a43+a08);
  if (res[0]!=0) res[0][35]=a43;
  a07=(a07<a21);
  a21=arg[2]? arg[2][36] : 0;
  a08=arg[0]? arg[0][1] : 0;
  a44=(a44/a08);
  a44=(a21-a44);
  a00=casadi_fmax(a00,a44);
  a00=(a07?a00:0);
  a07=(!a07);
  a07=(a07?a21:0);
  a00=(a00+a07);
  if (res[0]!=0) res[0][36]=a00;
  a24=(a24*a00);
  if (res[1]!=0) res[1][0]=a24;
  a54=(a54*a00);
  if (res[1]!=0) res[1][1]=a54;
  a43=(a43*a00);
  if (res[1]!=0) res[1][2]=a43;
  return 0;
}

CASADI_SYMBOL_EXPORT int controller_step(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f1(arg, res, iw, w, mem);
}

CASADI_SYMBOL_EXPORT int controller_step_checkout(void) {
  return 0;
}

CASADI_SYMBOL_EXPORT void controller_step_release(int mem) {
}

CASADI_SYMBOL_EXPORT void controller_step_incref(void) {
}

CASADI_SYMBOL_EXPORT void controller_step_decref(void) {
}

CASADI_SYMBOL_EXPORT casadi_int controller_step_n_in(void) { return 4;}

CASADI_SYMBOL_EXPORT casadi_int controller_step_n_out(void) { return 2;}

CASADI_SYMBOL_EXPORT casadi_real controller_step_default_in(casadi_int i) {
  switch (i) {
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* controller_step_name_in(casadi_int i) {
  switch (i) {
    case 0: return "parameters";
    case 1: return "derived";
    case 2: return "states";
    case 3: return "inputs";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const char* controller_step_name_out(casadi_int i) {
  switch (i) {
    case 0: return "next_states";
    case 1: return "outputs";
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* controller_step_sparsity_in(casadi_int i) {
  switch (i) {
    case 0: return casadi_s0;
    case 1: return casadi_s1;
    case 2: return casadi_s2;
    case 3: return casadi_s3;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT const casadi_int* controller_step_sparsity_out(casadi_int i) {
  switch (i) {
    case 0: return casadi_s2;
    case 1: return casadi_s4;
    default: return 0;
  }
}

CASADI_SYMBOL_EXPORT int controller_step_work(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4;
  if (sz_res) *sz_res = 2;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

CASADI_SYMBOL_EXPORT int controller_step_work_bytes(casadi_int *sz_arg, casadi_int* sz_res, casadi_int *sz_iw, casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 4*sizeof(const casadi_real*);
  if (sz_res) *sz_res = 2*sizeof(casadi_real*);
  if (sz_iw) *sz_iw = 0*sizeof(casadi_int);
  if (sz_w) *sz_w = 0*sizeof(casadi_real);
  return 0;
}


