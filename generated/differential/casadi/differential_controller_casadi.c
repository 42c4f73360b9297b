/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) differential_controller_casadi_ ## ID
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
CASADI_SYMBOL_EXPORT void differential_controller_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int differential_controller_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int differential_controller_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {48, 1, 1};
static const casadi_int casadi_s1[3] = {23, 1, 1};
static const casadi_int casadi_s2[3] = {32, 1, 1};
static const casadi_int casadi_s3[3] = {9, 1, 1};
static const casadi_int casadi_s4[3] = {3, 1, 1};

static const casadi_real casadi_zeros[48] = 
  {0.};

/* controller_prepare:(parameters[48])->(derived[23]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real w1, w2, w3, w4, w5, w6;
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
  /* #5: @2 = @0[17] */
  w2 = wr0[17];
  /* #6: @3 = (1./@2) */
  w3 = (1./ w2 );
  /* #7: output[0][1] = @3 */
  if (res[0]) res[0][1] = w3;
  /* #8: @3 = 1 */
  w3 = 1.;
  /* #9: @4 = @0[16] */
  w4 = wr0[16];
  /* #10: @4 = (@4/@2) */
  w4 /= w2;
  /* #11: @3 = (@3+@4) */
  w3 += w4;
  /* #12: output[0][2] = @3 */
  if (res[0]) res[0][2] = w3;
  /* #13: @3 = @0[21] */
  w3 = wr0[21];
  /* #14: @4 = (1./@3) */
  w4 = (1./ w3 );
  /* #15: output[0][3] = @4 */
  if (res[0]) res[0][3] = w4;
  /* #16: @4 = 1 */
  w4 = 1.;
  /* #17: @2 = @0[20] */
  w2 = wr0[20];
  /* #18: @2 = (@2/@3) */
  w2 /= w3;
  /* #19: @4 = (@4+@2) */
  w4 += w2;
  /* #20: output[0][4] = @4 */
  if (res[0]) res[0][4] = w4;
  /* #21: @4 = @0[25] */
  w4 = wr0[25];
  /* #22: @2 = (1./@4) */
  w2 = (1./ w4 );
  /* #23: output[0][5] = @2 */
  if (res[0]) res[0][5] = w2;
  /* #24: @2 = 1 */
  w2 = 1.;
  /* #25: @3 = @0[24] */
  w3 = wr0[24];
  /* #26: @3 = (@3/@4) */
  w3 /= w4;
  /* #27: @2 = (@2+@3) */
  w2 += w3;
  /* #28: output[0][6] = @2 */
  if (res[0]) res[0][6] = w2;
  /* #29: @2 = @0[27] */
  w2 = wr0[27];
  /* #30: @2 = (@2*@1) */
  w2 *= w1;
  /* #31: output[0][7] = @2 */
  if (res[0]) res[0][7] = w2;
  /* #32: @2 = @0[28] */
  w2 = wr0[28];
  /* #33: @2 = (@2*@1) */
  w2 *= w1;
  /* #34: output[0][8] = @2 */
  if (res[0]) res[0][8] = w2;
  /* #35: @2 = @0[30] */
  w2 = wr0[30];
  /* #36: @3 = (@2*@1) */
  w3  = (w2*w1);
  /* #37: output[0][9] = @3 */
  if (res[0]) res[0][9] = w3;
  /* #38: @2 = (@2*@1) */
  w2 *= w1;
  /* #39: @3 = @0[29] */
  w3 = wr0[29];
  /* #40: @2 = (@2/@3) */
  w2 /= w3;
  /* #41: output[0][10] = @2 */
  if (res[0]) res[0][10] = w2;
  /* #42: @2 = @0[32] */
  w2 = wr0[32];
  /* #43: @3 = (@2*@1) */
  w3  = (w2*w1);
  /* #44: output[0][11] = @3 */
  if (res[0]) res[0][11] = w3;
  /* #45: @2 = (@2*@1) */
  w2 *= w1;
  /* #46: @3 = @0[31] */
  w3 = wr0[31];
  /* #47: @2 = (@2/@3) */
  w2 /= w3;
  /* #48: output[0][12] = @2 */
  if (res[0]) res[0][12] = w2;
  /* #49: @2 = @0[33] */
  w2 = wr0[33];
  /* #50: @3 = @0[34] */
  w3 = wr0[34];
  /* #51: @2 = (@2/@3) */
  w2 /= w3;
  /* #52: output[0][13] = @2 */
  if (res[0]) res[0][13] = w2;
  /* #53: @2 = @0[35] */
  w2 = wr0[35];
  /* #54: @4 = @0[36] */
  w4 = wr0[36];
  /* #55: @2 = (@2/@4) */
  w2 /= w4;
  /* #56: output[0][14] = @2 */
  if (res[0]) res[0][14] = w2;
  /* #57: @2 = @0[40] */
  w2 = wr0[40];
  /* #58: @2 = (@2*@1) */
  w2 *= w1;
  /* #59: output[0][15] = @2 */
  if (res[0]) res[0][15] = w2;
  /* #60: @2 = @0[41] */
  w2 = wr0[41];
  /* #61: @2 = (@2*@1) */
  w2 *= w1;
  /* #62: @5 = @0[37] */
  w5 = wr0[37];
  /* #63: @2 = (@2/@5) */
  w2 /= w5;
  /* #64: output[0][16] = @2 */
  if (res[0]) res[0][16] = w2;
  /* #65: @2 = @0[42] */
  w2 = wr0[42];
  /* #66: @2 = (@2*@1) */
  w2 *= w1;
  /* #67: @2 = (@2/@5) */
  w2 /= w5;
  /* #68: output[0][17] = @2 */
  if (res[0]) res[0][17] = w2;
  /* #69: @2 = @0[44] */
  w2 = wr0[44];
  /* #70: @6 = (@5*@2) */
  w6  = (w5*w2);
  /* #71: @3 = (2.*@3) */
  w3 = (2.* w3 );
  /* #72: @6 = (@6/@3) */
  w6 /= w3;
  /* #73: output[0][18] = @6 */
  if (res[0]) res[0][18] = w6;
  /* #74: @5 = (@5*@2) */
  w5 *= w2;
  /* #75: @4 = (2.*@4) */
  w4 = (2.* w4 );
  /* #76: @5 = (@5/@4) */
  w5 /= w4;
  /* #77: output[0][19] = @5 */
  if (res[0]) res[0][19] = w5;
  /* #78: @5 = 2 */
  w5 = 2.;
  /* #79: @5 = (@2/@5) */
  w5  = (w2/w5);
  /* #80: output[0][20] = @5 */
  if (res[0]) res[0][20] = w5;
  /* #81: @5 = 2 */
  w5 = 2.;
  /* #82: @2 = (@2/@5) */
  w2 /= w5;
  /* #83: output[0][21] = @2 */
  if (res[0]) res[0][21] = w2;
  /* #84: @2 = @0[45] */
  w2 = wr0[45];
  /* #85: @2 = (@2*@1) */
  w2 *= w1;
  /* #86: output[0][22] = @2 */
  if (res[0]) res[0][22] = w2;
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

/* controller_step:(parameters[48],derived[23],states[32],inputs[9])->(next_states[32],outputs[3]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67;
  a00=arg[0]? arg[0][23] : 0;
  a01=arg[0]? arg[0][26] : 0;
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
  a08=(-a08);
  a07=(a03*a07);
  a06=(a06-a07);
  a06=casadi_fmin(a05,a06);
  a06=casadi_fmax(a00,a06);
  a02=(a02*a06);
  a06=arg[0]? arg[0][32] : 0;
  a06=(a00<a06);
  a07=arg[3]? arg[3][7] : 0;
  a09=casadi_fabs(a07);
  a10=arg[0]? arg[0][9] : 0;
  a09=(a09<=a10);
  a07=(a09?a07:0);
  a10=(!a09);
  a11=arg[2]? arg[2][8] : 0;
  a10=(a10?a11:0);
  a07=(a07+a10);
  a10=5.0000000000000000e-01;
  a11=arg[2]? arg[2][13] : 0;
  a12=(a10<a11);
  a13=arg[2]? arg[2][10] : 0;
  a13=(a12?a13:0);
  a12=(!a12);
  a14=arg[0]? arg[0][11] : 0;
  a12=(a12?a14:0);
  a13=(a13+a12);
  a12=(a14-a13);
  a15=casadi_fabs(a12);
  a16=arg[2]? arg[2][11] : 0;
  a16=(a14!=a16);
  a17=arg[1]? arg[1][0] : 0;
  a18=casadi_fabs(a12);
  a18=(a17*a18);
  a19=9.9999999999999995e-07;
  a20=casadi_fabs(a14);
  a20=(a19*a20);
  a21=casadi_fabs(a13);
  a21=(a19*a21);
  a20=(a20+a21);
  a18=casadi_fmax(a18,a20);
  a18=(a16?a18:0);
  a16=(!a16);
  a20=arg[2]? arg[2][12] : 0;
  a16=(a16?a20:0);
  a18=(a18+a16);
  a15=(a15<=a18);
  a16=(a15?a14:0);
  a15=(!a15);
  a20=(a00<a12);
  a21=(a13+a18);
  a21=(a20?a21:0);
  a20=(!a20);
  a22=(a13-a18);
  a20=(a20?a22:0);
  a21=(a21+a20);
  a15=(a15?a21:0);
  a16=(a16+a15);
  a15=(a13-a16);
  a15=(a07*a15);
  a15=(-a15);
  a06=(a06?a15:0);
  a15=(a10<a11);
  a21=arg[2]? arg[2][23] : 0;
  a15=(a15?a21:0);
  a06=(a06+a15);
  a15=(a10<a11);
  a21=arg[2]? arg[2][21] : 0;
  a21=(a15?a21:0);
  a15=(!a15);
  a15=(a15?a03:0);
  a21=(a21+a15);
  a15=arg[1]? arg[1][8] : 0;
  a20=(-a15);
  a22=arg[3]? arg[3][2] : 0;
  a23=casadi_fabs(a22);
  a24=arg[0]? arg[0][4] : 0;
  a23=(a23<=a24);
  a22=(a23?a22:0);
  a24=(!a23);
  a25=arg[2]? arg[2][3] : 0;
  a24=(a24?a25:0);
  a22=(a22+a24);
  a24=(a22-a21);
  a15=casadi_fmin(a15,a24);
  a20=casadi_fmax(a20,a15);
  a21=(a21+a20);
  a20=(a21-a03);
  a15=arg[0]? arg[0][31] : 0;
  a15=(a20*a15);
  a15=(a06+a15);
  a24=(a07*a16);
  a15=(a15-a24);
  a02=casadi_fmin(a02,a15);
  a08=casadi_fmax(a08,a02);
  a02=casadi_fabs(a08);
  a24=1.0100000000000000e+00;
  a01=(a24*a01);
  a02=(a02<=a01);
  a01=(a02?a05:0);
  a01=(a01<a10);
  a25=arg[0]? arg[0][19] : 0;
  a26=arg[0]? arg[0][22] : 0;
  a27=(a25*a26);
  a28=arg[3]? arg[3][6] : 0;
  a29=casadi_fabs(a28);
  a30=arg[0]? arg[0][8] : 0;
  a29=(a29<=a30);
  a28=(a29?a28:0);
  a30=(!a29);
  a31=arg[2]? arg[2][7] : 0;
  a30=(a30?a31:0);
  a28=(a28+a30);
  a30=casadi_fabs(a28);
  a25=casadi_fmax(a25,a30);
  a27=(a27/a25);
  a25=arg[1]? arg[1][4] : 0;
  a30=arg[1]? arg[1][3] : 0;
  a31=(a28*a30);
  a31=(a25+a31);
  a31=casadi_fmin(a05,a31);
  a31=casadi_fmax(a00,a31);
  a31=(a27*a31);
  a31=(-a31);
  a30=(a28*a30);
  a25=(a25-a30);
  a25=casadi_fmin(a05,a25);
  a25=casadi_fmax(a00,a25);
  a27=(a27*a25);
  a25=arg[0]? arg[0][30] : 0;
  a25=(a00<a25);
  a30=arg[3]? arg[3][5] : 0;
  a32=casadi_fabs(a30);
  a33=arg[0]? arg[0][7] : 0;
  a32=(a32<=a33);
  a30=(a32?a30:0);
  a33=(!a32);
  a34=arg[2]? arg[2][6] : 0;
  a33=(a33?a34:0);
  a30=(a30+a33);
  a13=(a13-a16);
  a13=(a30*a13);
  a13=(-a13);
  a25=(a25?a13:0);
  a13=(a10<a11);
  a33=arg[2]? arg[2][22] : 0;
  a13=(a13?a33:0);
  a25=(a25+a13);
  a13=(a10<a11);
  a33=arg[2]? arg[2][20] : 0;
  a33=(a13?a33:0);
  a13=(!a13);
  a13=(a13?a28:0);
  a33=(a33+a13);
  a13=arg[1]? arg[1][7] : 0;
  a34=(-a13);
  a35=arg[3]? arg[3][1] : 0;
  a36=casadi_fabs(a35);
  a37=arg[0]? arg[0][3] : 0;
  a36=(a36<=a37);
  a35=(a36?a35:0);
  a37=(!a36);
  a38=arg[2]? arg[2][2] : 0;
  a37=(a37?a38:0);
  a35=(a35+a37);
  a37=(a35-a33);
  a13=casadi_fmin(a13,a37);
  a34=casadi_fmax(a34,a13);
  a33=(a33+a34);
  a34=(a33-a28);
  a13=arg[0]? arg[0][29] : 0;
  a13=(a34*a13);
  a13=(a25+a13);
  a37=(a30*a16);
  a13=(a13-a37);
  a27=casadi_fmin(a27,a13);
  a31=casadi_fmax(a31,a27);
  a27=casadi_fabs(a31);
  a26=(a24*a26);
  a27=(a27<=a26);
  a26=(a27?a05:0);
  a26=(a26<a10);
  a37=arg[0]? arg[0][15] : 0;
  a38=arg[0]? arg[0][18] : 0;
  a39=(a37*a38);
  a40=arg[3]? arg[3][3] : 0;
  a41=casadi_fabs(a40);
  a42=arg[0]? arg[0][5] : 0;
  a41=(a41<=a42);
  a40=(a41?a40:0);
  a42=(!a41);
  a43=arg[2]? arg[2][4] : 0;
  a42=(a42?a43:0);
  a40=(a40+a42);
  a42=casadi_fabs(a40);
  a37=casadi_fmax(a37,a42);
  a39=(a39/a37);
  a37=arg[1]? arg[1][2] : 0;
  a42=arg[1]? arg[1][1] : 0;
  a43=(a40*a42);
  a43=(a37+a43);
  a43=casadi_fmin(a05,a43);
  a43=casadi_fmax(a00,a43);
  a43=(a39*a43);
  a44=(-a43);
  a42=(a40*a42);
  a37=(a37-a42);
  a37=casadi_fmin(a05,a37);
  a37=casadi_fmax(a00,a37);
  a39=(a39*a37);
  a37=arg[0]? arg[0][14] : 0;
  a42=(a10<a11);
  a45=arg[2]? arg[2][17] : 0;
  a45=(a42?a45:0);
  a42=(!a42);
  a42=(a42?a37:0);
  a45=(a45+a42);
  a42=(a37-a45);
  a46=casadi_fabs(a42);
  a47=arg[2]? arg[2][18] : 0;
  a47=(a37!=a47);
  a48=casadi_fabs(a42);
  a48=(a17*a48);
  a49=casadi_fabs(a37);
  a49=(a19*a49);
  a50=casadi_fabs(a45);
  a50=(a19*a50);
  a49=(a49+a50);
  a48=casadi_fmax(a48,a49);
  a48=(a47?a48:0);
  a47=(!a47);
  a49=arg[2]? arg[2][19] : 0;
  a47=(a47?a49:0);
  a48=(a48+a47);
  a46=(a46<=a48);
  a47=(a46?a37:0);
  a46=(!a46);
  a49=(a00<a42);
  a50=(a45+a48);
  a50=(a49?a50:0);
  a49=(!a49);
  a45=(a45-a48);
  a49=(a49?a45:0);
  a50=(a50+a49);
  a46=(a46?a50:0);
  a47=(a47+a46);
  a46=arg[1]? arg[1][20] : 0;
  a46=(a46*a28);
  a46=(a46-a40);
  a50=arg[1]? arg[1][21] : 0;
  a50=(a50*a03);
  a46=(a46+a50);
  a46=(a47*a46);
  a50=arg[0]? arg[0][46] : 0;
  a49=(a05-a50);
  a43=(a43*a49);
  a43=(-a43);
  a49=(a10<a11);
  a45=arg[2]? arg[2][27] : 0;
  a49=(a49?a45:0);
  a45=arg[0]? arg[0][38] : 0;
  a51=(a10<a11);
  a52=arg[2]? arg[2][24] : 0;
  a52=(a51?a52:0);
  a51=(!a51);
  a53=arg[3]? arg[3][4] : 0;
  a54=casadi_fabs(a53);
  a55=arg[0]? arg[0][6] : 0;
  a54=(a54<=a55);
  a53=(a54?a53:0);
  a55=(!a54);
  a56=arg[2]? arg[2][5] : 0;
  a55=(a55?a56:0);
  a53=(a53+a55);
  a55=arg[1]? arg[1][13] : 0;
  a56=(a31+a30);
  a55=(a55*a56);
  a55=(a53+a55);
  a57=arg[1]? arg[1][14] : 0;
  a58=(a08+a07);
  a57=(a57*a58);
  a55=(a55+a57);
  a51=(a51?a55:0);
  a52=(a52+a51);
  a51=arg[1]? arg[1][15] : 0;
  a57=(-a51);
  a59=arg[3]? arg[3][0] : 0;
  a60=casadi_fabs(a59);
  a61=arg[0]? arg[0][2] : 0;
  a60=(a60<=a61);
  a59=(a60?a59:0);
  a61=(!a60);
  a62=arg[2]? arg[2][1] : 0;
  a61=(a61?a62:0);
  a59=(a59+a61);
  a61=(a59-a52);
  a51=casadi_fmin(a51,a61);
  a57=casadi_fmax(a57,a51);
  a52=(a52+a57);
  a45=(a45*a52);
  a45=(a49+a45);
  a57=(a10<a11);
  a51=arg[2]? arg[2][25] : 0;
  a51=(a57?a51:0);
  a57=(!a57);
  a57=(a57?a55:0);
  a51=(a51+a57);
  a57=(a10<a11);
  a61=arg[2]? arg[2][26] : 0;
  a62=(a57?a61:0);
  a63=arg[1]? arg[1][16] : 0;
  a64=(a52-a51);
  a63=(a63*a64);
  a62=(a62+a63);
  a63=arg[1]? arg[1][17] : 0;
  a63=(a63*a61);
  a63=(-a63);
  a57=(a57?a63:0);
  a62=(a62+a57);
  a57=arg[0]? arg[0][0] : 0;
  a63=(a62*a57);
  a51=(a51+a63);
  a63=arg[0]? arg[0][43] : 0;
  a61=(a51*a63);
  a61=(a61-a55);
  a63=(a05-a63);
  a63=(a52*a63);
  a61=(a61+a63);
  a63=arg[0]? arg[0][39] : 0;
  a63=(a61*a63);
  a45=(a45+a63);
  a63=arg[0]? arg[0][12] : 0;
  a11=(a10<a11);
  a55=arg[2]? arg[2][14] : 0;
  a55=(a11?a55:0);
  a11=(!a11);
  a11=(a11?a63:0);
  a55=(a55+a11);
  a11=(a63-a55);
  a64=casadi_fabs(a11);
  a65=arg[2]? arg[2][15] : 0;
  a65=(a63!=a65);
  a66=casadi_fabs(a11);
  a17=(a17*a66);
  a66=casadi_fabs(a63);
  a66=(a19*a66);
  a67=casadi_fabs(a55);
  a19=(a19*a67);
  a66=(a66+a19);
  a17=casadi_fmax(a17,a66);
  a17=(a65?a17:0);
  a65=(!a65);
  a66=arg[2]? arg[2][16] : 0;
  a65=(a65?a66:0);
  a17=(a17+a65);
  a64=(a64<=a17);
  a65=(a64?a63:0);
  a64=(!a64);
  a66=(a00<a11);
  a19=(a55+a17);
  a19=(a66?a19:0);
  a66=(!a66);
  a55=(a55-a17);
  a66=(a66?a55:0);
  a19=(a19+a66);
  a64=(a64?a19:0);
  a65=(a65+a64);
  a64=arg[1]? arg[1][18] : 0;
  a64=(a64*a56);
  a56=arg[1]? arg[1][19] : 0;
  a56=(a56*a58);
  a64=(a64+a56);
  a64=(a65*a64);
  a45=(a45+a64);
  a50=(a05-a50);
  a50=(a39*a50);
  a50=casadi_fmin(a45,a50);
  a43=casadi_fmax(a43,a50);
  a46=(a46+a43);
  a39=casadi_fmin(a39,a46);
  a44=casadi_fmax(a44,a39);
  a39=casadi_fabs(a44);
  a24=(a24*a38);
  a39=(a39<=a24);
  a24=(a39?a05:0);
  a24=(a24<a10);
  a04=(a04?a05:0);
  a04=(a04<a10);
  a29=(a29?a05:0);
  a29=(a29<a10);
  a41=(a41?a05:0);
  a41=(a41<a10);
  a23=(a23?a05:0);
  a23=(a23<a10);
  a36=(a36?a05:0);
  a36=(a36<a10);
  a60=(a60?a05:0);
  a60=(a60<a10);
  a38=arg[2]? arg[2][0] : 0;
  a46=(a38<a10);
  a60=(a60&&a46);
  a46=(a60?a05:0);
  a60=(!a60);
  a60=(a60?a38:0);
  a46=(a46+a60);
  a60=(a46<a10);
  a36=(a36&&a60);
  a60=2.;
  a60=(a36?a60:0);
  a36=(!a36);
  a36=(a36?a46:0);
  a60=(a60+a36);
  a36=(a60<a10);
  a23=(a23&&a36);
  a36=3.;
  a36=(a23?a36:0);
  a23=(!a23);
  a23=(a23?a60:0);
  a36=(a36+a23);
  a23=(a36<a10);
  a41=(a41&&a23);
  a23=4.;
  a23=(a41?a23:0);
  a41=(!a41);
  a41=(a41?a36:0);
  a23=(a23+a41);
  a41=(a23<a10);
  a54=(a54?a05:0);
  a54=(a54<a10);
  a41=(a41&&a54);
  a54=5.;
  a54=(a41?a54:0);
  a41=(!a41);
  a41=(a41?a23:0);
  a54=(a54+a41);
  a41=(a54<a10);
  a32=(a32?a05:0);
  a32=(a32<a10);
  a41=(a41&&a32);
  a32=6.;
  a32=(a41?a32:0);
  a41=(!a41);
  a41=(a41?a54:0);
  a32=(a32+a41);
  a41=(a32<a10);
  a29=(a29&&a41);
  a41=7.;
  a41=(a29?a41:0);
  a29=(!a29);
  a29=(a29?a32:0);
  a41=(a41+a29);
  a29=(a41<a10);
  a09=(a09?a05:0);
  a09=(a09<a10);
  a29=(a29&&a09);
  a09=8.;
  a09=(a29?a09:0);
  a29=(!a29);
  a29=(a29?a41:0);
  a09=(a09+a29);
  a29=(a09<a10);
  a04=(a04&&a29);
  a29=9.;
  a29=(a04?a29:0);
  a04=(!a04);
  a04=(a04?a09:0);
  a29=(a29+a04);
  a04=(a29<a10);
  a24=(a24&&a04);
  a04=10.;
  a04=(a24?a04:0);
  a24=(!a24);
  a24=(a24?a29:0);
  a04=(a04+a24);
  a24=(a04<a10);
  a26=(a26&&a24);
  a24=11.;
  a24=(a26?a24:0);
  a26=(!a26);
  a26=(a26?a04:0);
  a24=(a24+a26);
  a26=(a24<a10);
  a01=(a01&&a26);
  a26=12.;
  a26=(a01?a26:0);
  a01=(!a01);
  a01=(a01?a24:0);
  a26=(a26+a01);
  if (res[0]!=0) res[0][0]=a26;
  if (res[0]!=0) res[0][1]=a59;
  if (res[0]!=0) res[0][2]=a35;
  if (res[0]!=0) res[0][3]=a22;
  if (res[0]!=0) res[0][4]=a40;
  if (res[0]!=0) res[0][5]=a53;
  if (res[0]!=0) res[0][6]=a30;
  if (res[0]!=0) res[0][7]=a28;
  if (res[0]!=0) res[0][8]=a07;
  if (res[0]!=0) res[0][9]=a03;
  if (res[0]!=0) res[0][10]=a16;
  if (res[0]!=0) res[0][11]=a14;
  a12=casadi_fabs(a12);
  a12=(a12<=a18);
  a12=(!a12);
  a12=(a12?a18:0);
  if (res[0]!=0) res[0][12]=a12;
  a12=(a26<a10);
  a12=(a12?a05:0);
  if (res[0]!=0) res[0][13]=a12;
  if (res[0]!=0) res[0][14]=a65;
  if (res[0]!=0) res[0][15]=a63;
  a11=casadi_fabs(a11);
  a11=(a11<=a17);
  a11=(!a11);
  a11=(a11?a17:0);
  if (res[0]!=0) res[0][16]=a11;
  if (res[0]!=0) res[0][17]=a47;
  if (res[0]!=0) res[0][18]=a37;
  a42=casadi_fabs(a42);
  a42=(a42<=a48);
  a42=(!a42);
  a42=(a42?a48:0);
  if (res[0]!=0) res[0][19]=a42;
  if (res[0]!=0) res[0][20]=a33;
  if (res[0]!=0) res[0][21]=a21;
  a13=(a31-a13);
  a21=arg[1]? arg[1][10] : 0;
  a13=(a13*a21);
  a25=(a25+a13);
  a13=arg[1]? arg[1][9] : 0;
  a34=(a34*a13);
  a25=(a25+a34);
  if (res[0]!=0) res[0][22]=a25;
  a15=(a08-a15);
  a25=arg[1]? arg[1][12] : 0;
  a15=(a15*a25);
  a06=(a06+a15);
  a15=arg[1]? arg[1][11] : 0;
  a20=(a20*a15);
  a06=(a06+a20);
  if (res[0]!=0) res[0][23]=a06;
  if (res[0]!=0) res[0][24]=a52;
  if (res[0]!=0) res[0][25]=a51;
  if (res[0]!=0) res[0][26]=a62;
  a45=(a45-a43);
  a45=(a61*a45);
  a45=(a00<a45);
  a43=(a45?a49:0);
  a45=(!a45);
  a62=arg[0]? arg[0][47] : 0;
  a51=(-a62);
  a52=arg[1]? arg[1][22] : 0;
  a61=(a61*a52);
  a49=(a49+a61);
  a62=casadi_fmin(a62,a49);
  a51=casadi_fmax(a51,a62);
  a45=(a45?a51:0);
  a43=(a43+a45);
  if (res[0]!=0) res[0][27]=a43;
  a43=(a10<a26);
  a45=arg[2]? arg[2][28] : 0;
  a51=(a43?a45:0);
  a43=(!a43);
  a44=(a39?a44:0);
  a39=(!a39);
  a39=(a39?a45:0);
  a44=(a44+a39);
  a43=(a43?a44:0);
  a51=(a51+a43);
  if (res[0]!=0) res[0][28]=a51;
  a43=(a10<a26);
  a44=arg[2]? arg[2][29] : 0;
  a39=(a43?a44:0);
  a43=(!a43);
  a31=(a27?a31:0);
  a27=(!a27);
  a27=(a27?a44:0);
  a31=(a31+a27);
  a43=(a43?a31:0);
  a39=(a39+a43);
  if (res[0]!=0) res[0][29]=a39;
  a43=(a10<a26);
  a31=arg[2]? arg[2][30] : 0;
  a27=(a43?a31:0);
  a43=(!a43);
  a08=(a02?a08:0);
  a02=(!a02);
  a02=(a02?a31:0);
  a08=(a08+a02);
  a43=(a43?a08:0);
  a27=(a27+a43);
  if (res[0]!=0) res[0][30]=a27;
  a10=(a10<a26);
  a26=arg[2]? arg[2][31] : 0;
  a43=arg[0]? arg[0][1] : 0;
  a57=(a57/a43);
  a57=(a26-a57);
  a00=casadi_fmax(a00,a57);
  a00=(a10?a00:0);
  a10=(!a10);
  a10=(a10?a26:0);
  a00=(a00+a10);
  if (res[0]!=0) res[0][31]=a00;
  a51=(a51*a00);
  if (res[1]!=0) res[1][0]=a51;
  a39=(a39*a00);
  if (res[1]!=0) res[1][1]=a39;
  a27=(a27*a00);
  if (res[1]!=0) res[1][2]=a27;
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


