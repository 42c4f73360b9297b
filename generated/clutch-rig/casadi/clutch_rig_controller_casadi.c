/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) clutch_rig_controller_casadi_ ## ID
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

casadi_real casadi_fmin(casadi_real x, casadi_real y) {
/* Pre-c99 compatibility */
#if __STDC_VERSION__ < 199901L
  return x<y ? x : y;
#else
  return fmin(x, y);
#endif
}

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

/* Configuration this file was compiled with */
CASADI_SYMBOL_EXPORT void clutch_rig_controller_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int clutch_rig_controller_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int clutch_rig_controller_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {41, 1, 1};
static const casadi_int casadi_s1[3] = {25, 1, 1};
static const casadi_int casadi_s2[3] = {57, 1, 1};
static const casadi_int casadi_s3[3] = {7, 1, 1};
static const casadi_int casadi_s4[3] = {2, 1, 1};

static const casadi_real casadi_zeros[41] = 
  {0.};

/* controller_prepare:(parameters[41])->(derived[25]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real w1, w2, w3, w4, w5;
  const casadi_real *wr0;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = @0[2] */
  w1 = wr0[2];
  /* #2: @2 = @0[0] */
  w2 = wr0[0];
  /* #3: @3 = 2 */
  w3 = 2.;
  /* #4: @3 = (@2/@3) */
  w3  = (w2/w3);
  /* #5: @1 = (@1+@3) */
  w1 += w3;
  /* #6: output[0][0] = @1 */
  if (res[0]) res[0][0] = w1;
  /* #7: @1 = @0[13] */
  w1 = wr0[13];
  /* #8: @1 = (@2/@1) */
  w1  = (w2/w1);
  /* #9: output[0][1] = @1 */
  if (res[0]) res[0][1] = w1;
  /* #10: @1 = @0[16] */
  w1 = wr0[16];
  /* #11: @3 = (1./@1) */
  w3 = (1./ w1 );
  /* #12: output[0][2] = @3 */
  if (res[0]) res[0][2] = w3;
  /* #13: @3 = 1 */
  w3 = 1.;
  /* #14: @4 = @0[15] */
  w4 = wr0[15];
  /* #15: @4 = (@4/@1) */
  w4 /= w1;
  /* #16: @3 = (@3+@4) */
  w3 += w4;
  /* #17: output[0][3] = @3 */
  if (res[0]) res[0][3] = w3;
  /* #18: @3 = @0[14] */
  w3 = wr0[14];
  /* #19: @4 = @0[17] */
  w4 = wr0[17];
  /* #20: @3 = (@3*@4) */
  w3 *= w4;
  /* #21: output[0][4] = @3 */
  if (res[0]) res[0][4] = w3;
  /* #22: @3 = @0[20] */
  w3 = wr0[20];
  /* #23: @1 = (1./@3) */
  w1 = (1./ w3 );
  /* #24: output[0][5] = @1 */
  if (res[0]) res[0][5] = w1;
  /* #25: @1 = 1 */
  w1 = 1.;
  /* #26: @5 = @0[19] */
  w5 = wr0[19];
  /* #27: @5 = (@5/@3) */
  w5 /= w3;
  /* #28: @1 = (@1+@5) */
  w1 += w5;
  /* #29: output[0][6] = @1 */
  if (res[0]) res[0][6] = w1;
  /* #30: @1 = @0[18] */
  w1 = wr0[18];
  /* #31: @5 = @0[21] */
  w5 = wr0[21];
  /* #32: @1 = (@1*@5) */
  w1 *= w5;
  /* #33: output[0][7] = @1 */
  if (res[0]) res[0][7] = w1;
  /* #34: @1 = @0[22] */
  w1 = wr0[22];
  /* #35: @1 = (@1*@2) */
  w1 *= w2;
  /* #36: output[0][8] = @1 */
  if (res[0]) res[0][8] = w1;
  /* #37: @1 = @0[23] */
  w1 = wr0[23];
  /* #38: @1 = (@2/@1) */
  w1  = (w2/w1);
  /* #39: output[0][9] = @1 */
  if (res[0]) res[0][9] = w1;
  /* #40: @1 = 0.05 */
  w1 = 5.0000000000000003e-02;
  /* #41: @1 = (@1*@4) */
  w1 *= w4;
  /* #42: output[0][10] = @1 */
  if (res[0]) res[0][10] = w1;
  /* #43: @1 = @0[27] */
  w1 = wr0[27];
  /* #44: @1 = (@2/@1) */
  w1  = (w2/w1);
  /* #45: output[0][11] = @1 */
  if (res[0]) res[0][11] = w1;
  /* #46: @1 = 0.05 */
  w1 = 5.0000000000000003e-02;
  /* #47: @1 = (@1*@5) */
  w1 *= w5;
  /* #48: output[0][12] = @1 */
  if (res[0]) res[0][12] = w1;
  /* #49: @1 = @0[30] */
  w1 = wr0[30];
  /* #50: @3 = (@1*@2) */
  w3  = (w1*w2);
  /* #51: output[0][13] = @3 */
  if (res[0]) res[0][13] = w3;
  /* #52: @3 = 6.2832 */
  w3 = 6.2831999999999999e+00;
  /* #53: @3 = (@3*@1) */
  w3 *= w1;
  /* #54: @3 = (@3*@2) */
  w3 *= w2;
  /* #55: output[0][14] = @3 */
  if (res[0]) res[0][14] = w3;
  /* #56: @3 = @0[35] */
  w3 = wr0[35];
  /* #57: @3 = (@3*@2) */
  w3 *= w2;
  /* #58: output[0][15] = @3 */
  if (res[0]) res[0][15] = w3;
  /* #59: @3 = @0[36] */
  w3 = wr0[36];
  /* #60: @3 = (@3*@2) */
  w3 *= w2;
  /* #61: output[0][16] = @3 */
  if (res[0]) res[0][16] = w3;
  /* #62: @3 = @0[38] */
  w3 = wr0[38];
  /* #63: @1 = (@3*@2) */
  w1  = (w3*w2);
  /* #64: output[0][17] = @1 */
  if (res[0]) res[0][17] = w1;
  /* #65: @3 = (@3*@2) */
  w3 *= w2;
  /* #66: @1 = @0[37] */
  w1 = wr0[37];
  /* #67: @3 = (@3/@1) */
  w3 /= w1;
  /* #68: output[0][18] = @3 */
  if (res[0]) res[0][18] = w3;
  /* #69: @3 = @0[40] */
  w3 = wr0[40];
  /* #70: @1 = (@3*@2) */
  w1  = (w3*w2);
  /* #71: output[0][19] = @1 */
  if (res[0]) res[0][19] = w1;
  /* #72: @3 = (@3*@2) */
  w3 *= w2;
  /* #73: @1 = @0[39] */
  w1 = wr0[39];
  /* #74: @3 = (@3/@1) */
  w3 /= w1;
  /* #75: output[0][20] = @3 */
  if (res[0]) res[0][20] = w3;
  /* #76: @3 = 1.01 */
  w3 = 1.0100000000000000e+00;
  /* #77: @1 = 480 */
  w1 = 480.;
  /* #78: @1 = fmin(@1,@4) */
  w1  = casadi_fmin(w1,w4);
  /* #79: @3 = (@3*@1) */
  w3 *= w1;
  /* #80: output[0][21] = @3 */
  if (res[0]) res[0][21] = w3;
  /* #81: @3 = 1.01 */
  w3 = 1.0100000000000000e+00;
  /* #82: @1 = 480 */
  w1 = 480.;
  /* #83: @1 = fmin(@1,@5) */
  w1  = casadi_fmin(w1,w5);
  /* #84: @3 = (@3*@1) */
  w3 *= w1;
  /* #85: output[0][22] = @3 */
  if (res[0]) res[0][22] = w3;
  /* #86: @3 = @0[1] */
  w3 = wr0[1];
  /* #87: @3 = (@2/@3) */
  w3  = (w2/w3);
  /* #88: output[0][23] = @3 */
  if (res[0]) res[0][23] = w3;
  /* #89: @3 = 0.02 */
  w3 = 2.0000000000000000e-02;
  /* #90: @3 = (@3+@2) */
  w3 += w2;
  /* #91: @2 = (@2/@3) */
  w2 /= w3;
  /* #92: output[0][24] = @2 */
  if (res[0]) res[0][24] = w2;
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

/* controller_step:(parameters[41],derived[25],states[57],inputs[7])->(next_states[57],outputs[2]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76;
  a00=5.0000000000000000e-01;
  a01=arg[2]? arg[2][0] : 0;
  a02=1.;
  a03=arg[2]? arg[2][1] : 0;
  a04=0.;
  a05=(a03<=a04);
  a06=(a00<a01);
  a07=arg[3]? arg[3][2] : 0;
  a08=casadi_fabs(a07);
  a09=arg[0]? arg[0][5] : 0;
  a08=(a08<=a09);
  a10=(a08?a07:0);
  a11=(!a08);
  a12=arg[2]? arg[2][8] : 0;
  a11=(a11?a12:0);
  a10=(a10+a11);
  a11=casadi_fabs(a10);
  a12=arg[0]? arg[0][9] : 0;
  a11=(a11<=a12);
  a07=casadi_fabs(a07);
  a07=(a07<=a09);
  a11=(a11&&a07);
  a07=arg[3]? arg[3][0] : 0;
  a09=casadi_fabs(a07);
  a13=arg[0]? arg[0][3] : 0;
  a09=(a09<=a13);
  a11=(a11&&a09);
  a09=arg[3]? arg[3][5] : 0;
  a14=casadi_fabs(a09);
  a15=arg[0]? arg[0][8] : 0;
  a14=(a14<=a15);
  a16=(a14?a09:0);
  a17=(!a14);
  a18=arg[2]? arg[2][14] : 0;
  a17=(a17?a18:0);
  a16=(a16+a17);
  a17=casadi_fabs(a16);
  a18=arg[0]? arg[0][10] : 0;
  a17=(a17<=a18);
  a11=(a11&&a17);
  a09=casadi_fabs(a09);
  a09=(a09<=a15);
  a11=(a11&&a09);
  a09=arg[3]? arg[3][1] : 0;
  a15=casadi_fabs(a09);
  a17=arg[0]? arg[0][4] : 0;
  a15=(a15<=a17);
  a11=(a11&&a15);
  a15=arg[3]? arg[3][3] : 0;
  a19=casadi_fabs(a15);
  a20=arg[0]? arg[0][6] : 0;
  a19=(a19<=a20);
  a11=(a11&&a19);
  a19=arg[3]? arg[3][4] : 0;
  a21=casadi_fabs(a19);
  a22=arg[0]? arg[0][7] : 0;
  a21=(a21<=a22);
  a11=(a11&&a21);
  a21=arg[2]? arg[2][3] : 0;
  a23=(a02-a21);
  a24=arg[2]? arg[2][19] : 0;
  a25=-1.;
  a26=arg[3]? arg[3][6] : 0;
  a26=(a25+a26);
  a26=casadi_fabs(a26);
  a26=(a26<=a00);
  a26=(a26?a02:0);
  a27=arg[2]? arg[2][18] : 0;
  a27=(a26-a27);
  a24=casadi_fmax(a24,a27);
  a23=(a23*a24);
  a24=(-a23);
  a24=(a11?a24:0);
  a24=(a06?a24:0);
  a05=(a05?a24:0);
  a05=(a02+a05);
  a01=(a01*a05);
  a05=(a00<a01);
  a24=(a05?a01:0);
  a05=(!a05);
  a27=casadi_fabs(a07);
  a27=(a27<=a13);
  a13=(a27?a02:0);
  a13=(a00<a13);
  a28=arg[2]? arg[2][5] : 0;
  a29=arg[0]? arg[0][2] : 0;
  a28=casadi_fmin(a28,a29);
  a30=arg[0]? arg[0][0] : 0;
  a31=casadi_fmax(a28,a30);
  a31=(a31-a30);
  a31=(a13?a31:0);
  a13=(!a13);
  a28=(a28+a30);
  a13=(a13?a28:0);
  a31=(a31+a13);
  a13=arg[1]? arg[1][0] : 0;
  a28=(a31<=a13);
  a32=casadi_fabs(a09);
  a32=(a32<=a17);
  a17=(a32?a02:0);
  a17=(a00<a17);
  a33=arg[2]? arg[2][7] : 0;
  a33=casadi_fmin(a33,a29);
  a34=casadi_fmax(a33,a30);
  a34=(a34-a30);
  a34=(a17?a34:0);
  a17=(!a17);
  a33=(a33+a30);
  a17=(a17?a33:0);
  a34=(a34+a17);
  a17=(a34<=a13);
  a08=(a08?a02:0);
  a08=(a00<a08);
  a33=arg[2]? arg[2][9] : 0;
  a33=casadi_fmin(a33,a29);
  a35=casadi_fmax(a33,a30);
  a35=(a35-a30);
  a35=(a08?a35:0);
  a08=(!a08);
  a33=(a33+a30);
  a08=(a08?a33:0);
  a35=(a35+a08);
  a08=(a35<=a13);
  a33=casadi_fabs(a15);
  a33=(a33<=a20);
  a20=(a33?a02:0);
  a20=(a00<a20);
  a36=arg[2]? arg[2][11] : 0;
  a36=casadi_fmin(a36,a29);
  a37=casadi_fmax(a36,a30);
  a37=(a37-a30);
  a37=(a20?a37:0);
  a20=(!a20);
  a36=(a36+a30);
  a20=(a20?a36:0);
  a37=(a37+a20);
  a20=(a37<=a13);
  a36=casadi_fabs(a19);
  a36=(a36<=a22);
  a22=(a36?a02:0);
  a22=(a00<a22);
  a38=arg[2]? arg[2][13] : 0;
  a38=casadi_fmin(a38,a29);
  a39=casadi_fmax(a38,a30);
  a39=(a39-a30);
  a39=(a22?a39:0);
  a22=(!a22);
  a38=(a38+a30);
  a22=(a22?a38:0);
  a39=(a39+a22);
  a22=(a39<=a13);
  a14=(a14?a02:0);
  a14=(a00<a14);
  a38=arg[2]? arg[2][15] : 0;
  a38=casadi_fmin(a38,a29);
  a40=casadi_fmax(a38,a30);
  a40=(a40-a30);
  a40=(a14?a40:0);
  a14=(!a14);
  a38=(a38+a30);
  a14=(a14?a38:0);
  a40=(a40+a14);
  a14=(a40<=a13);
  a38=casadi_fabs(a10);
  a38=(a38<=a12);
  a38=(a38?a02:0);
  a38=(a00<a38);
  a12=arg[2]? arg[2][16] : 0;
  a12=casadi_fmin(a12,a29);
  a41=casadi_fmax(a12,a30);
  a41=(a41-a30);
  a41=(a38?a41:0);
  a38=(!a38);
  a12=(a12+a30);
  a38=(a38?a12:0);
  a41=(a41+a38);
  a38=(a41<=a13);
  a12=casadi_fabs(a16);
  a12=(a12<=a18);
  a12=(a12?a02:0);
  a12=(a00<a12);
  a18=arg[2]? arg[2][17] : 0;
  a18=casadi_fmin(a18,a29);
  a42=casadi_fmax(a18,a30);
  a42=(a42-a30);
  a42=(a12?a42:0);
  a12=(!a12);
  a18=(a18+a30);
  a12=(a12?a18:0);
  a42=(a42+a12);
  a12=(a42<=a13);
  a12=(!a12);
  a18=4006.;
  a12=(a12?a18:0);
  a12=(a38?a12:0);
  a38=(!a38);
  a18=4003.;
  a38=(a38?a18:0);
  a12=(a12+a38);
  a12=(a14?a12:0);
  a14=(!a14);
  a38=6.;
  a14=(a14?a38:0);
  a12=(a12+a14);
  a12=(a22?a12:0);
  a22=(!a22);
  a14=5.;
  a22=(a22?a14:0);
  a12=(a12+a22);
  a12=(a20?a12:0);
  a20=(!a20);
  a22=4.;
  a20=(a20?a22:0);
  a12=(a12+a20);
  a12=(a08?a12:0);
  a08=(!a08);
  a20=3.;
  a08=(a08?a20:0);
  a12=(a12+a08);
  a12=(a17?a12:0);
  a17=(!a17);
  a08=2.;
  a17=(a17?a08:0);
  a12=(a12+a17);
  a12=(a28?a12:0);
  a28=(!a28);
  a28=(a28?a02:0);
  a12=(a12+a28);
  a05=(a05?a12:0);
  a24=(a24+a05);
  a05=(a00<a24);
  a24=(a05?a24:0);
  a05=(!a05);
  a12=arg[2]? arg[2][2] : 0;
  a28=(a12<=a00);
  a17=(a28?a10:0);
  a28=(!a28);
  a08=arg[2]? arg[2][23] : 0;
  a28=(a28?a08:0);
  a17=(a17+a28);
  a28=arg[1]? arg[1][9] : 0;
  a08=arg[2]? arg[2][53] : 0;
  a20=(a08*a03);
  a15=(a33?a15:0);
  a33=(!a33);
  a22=arg[2]? arg[2][10] : 0;
  a33=(a33?a22:0);
  a15=(a15+a33);
  a33=(a20-a15);
  a28=(a28*a33);
  a28=(a17+a28);
  a33=arg[1]? arg[1][8] : 0;
  a17=(a10-a17);
  a17=(a33*a17);
  a28=(a28+a17);
  a17=(a28-a10);
  a17=casadi_fabs(a17);
  a22=arg[0]? arg[0][25] : 0;
  a14=(a17<=a22);
  a38=arg[2]? arg[2][25] : 0;
  a38=(a10==a38);
  a18=(a12<=a00);
  a18=(!a18);
  a43=arg[2]? arg[2][26] : 0;
  a18=(a18?a43:0);
  a18=(a18+a30);
  a38=(a38?a18:0);
  a18=arg[0]? arg[0][26] : 0;
  a43=(a38<=a18);
  a14=(a14||a43);
  a22=(a17<=a22);
  a43=arg[2]? arg[2][27] : 0;
  a43=(a15==a43);
  a44=(a12<=a00);
  a44=(!a44);
  a45=arg[2]? arg[2][28] : 0;
  a44=(a44?a45:0);
  a44=(a44+a30);
  a43=(a43?a44:0);
  a44=(a43<=a18);
  a22=(a22||a44);
  a44=(a04<a43);
  a45=arg[2]? arg[2][29] : 0;
  a45=(a44?a45:0);
  a44=(!a44);
  a44=(a44?a20:0);
  a45=(a45+a44);
  a44=(a20-a45);
  a44=casadi_fabs(a44);
  a46=arg[1]? arg[1][10] : 0;
  a44=(a44<=a46);
  a22=(a22||a44);
  a44=(a12<=a00);
  a46=(a44?a16:0);
  a44=(!a44);
  a47=arg[2]? arg[2][30] : 0;
  a44=(a44?a47:0);
  a46=(a46+a44);
  a44=arg[1]? arg[1][11] : 0;
  a47=arg[2]? arg[2][54] : 0;
  a48=(a47*a03);
  a19=(a36?a19:0);
  a36=(!a36);
  a49=arg[2]? arg[2][12] : 0;
  a36=(a36?a49:0);
  a19=(a19+a36);
  a36=(a48+a19);
  a44=(a44*a36);
  a44=(a46+a44);
  a46=(a16-a46);
  a33=(a33*a46);
  a44=(a44+a33);
  a33=(a44-a16);
  a33=casadi_fabs(a33);
  a46=arg[0]? arg[0][29] : 0;
  a36=(a33<=a46);
  a49=arg[2]? arg[2][34] : 0;
  a49=(a19==a49);
  a50=(a12<=a00);
  a50=(!a50);
  a51=arg[2]? arg[2][35] : 0;
  a50=(a50?a51:0);
  a50=(a50+a30);
  a49=(a49?a50:0);
  a50=(a49<=a18);
  a36=(a36||a50);
  a50=(a04<a49);
  a51=arg[2]? arg[2][36] : 0;
  a51=(a50?a51:0);
  a50=(!a50);
  a50=(a50?a48:0);
  a51=(a51+a50);
  a50=(a48-a51);
  a50=casadi_fabs(a50);
  a52=arg[1]? arg[1][12] : 0;
  a50=(a50<=a52);
  a36=(a36||a50);
  a46=(a33<=a46);
  a50=arg[2]? arg[2][32] : 0;
  a50=(a16==a50);
  a52=(a12<=a00);
  a52=(!a52);
  a53=arg[2]? arg[2][33] : 0;
  a52=(a52?a53:0);
  a52=(a52+a30);
  a50=(a50?a52:0);
  a18=(a50<=a18);
  a46=(a46||a18);
  a18=arg[0]? arg[0][24] : 0;
  a17=(a17<=a18);
  a17=(a17?a02:0);
  a17=(a00<a17);
  a18=arg[2]? arg[2][24] : 0;
  a18=casadi_fmin(a18,a29);
  a52=casadi_fmax(a18,a30);
  a52=(a52-a30);
  a52=(a17?a52:0);
  a17=(!a17);
  a18=(a18+a30);
  a17=(a17?a18:0);
  a52=(a52+a17);
  a17=(a52<=a13);
  a18=arg[0]? arg[0][28] : 0;
  a33=(a33<=a18);
  a33=(a33?a02:0);
  a33=(a00<a33);
  a18=arg[2]? arg[2][31] : 0;
  a18=casadi_fmin(a18,a29);
  a29=casadi_fmax(a18,a30);
  a29=(a29-a30);
  a29=(a33?a29:0);
  a33=(!a33);
  a18=(a18+a30);
  a33=(a33?a18:0);
  a29=(a29+a33);
  a13=(a29<=a13);
  a33=(a12<=a00);
  a33=(!a33);
  a18=arg[2]? arg[2][39] : 0;
  a33=(a33?a18:0);
  a18=arg[1]? arg[1][13] : 0;
  a33=(a33-a18);
  a33=casadi_fmax(a04,a33);
  a30=arg[0]? arg[0][31] : 0;
  a53=(a12<=a00);
  a54=(a53?a15:0);
  a53=(!a53);
  a55=arg[2]? arg[2][37] : 0;
  a53=(a53?a55:0);
  a54=(a54+a53);
  a53=(a15-a54);
  a55=(a30<a53);
  a56=(a55?a02:0);
  a55=(!a55);
  a30=(-a30);
  a30=(a53<a30);
  a57=(a30?a25:0);
  a30=(!a30);
  a58=arg[2]? arg[2][38] : 0;
  a30=(a30?a58:0);
  a57=(a57+a30);
  a55=(a55?a57:0);
  a56=(a56+a55);
  a58=(a56==a58);
  a58=(!a58);
  a58=(a58?a02:0);
  a33=(a33+a58);
  a58=5.5000000000000000e+00;
  a55=(a33<=a58);
  a57=(a12<=a00);
  a57=(!a57);
  a30=arg[2]? arg[2][42] : 0;
  a57=(a57?a30:0);
  a57=(a57-a18);
  a57=casadi_fmax(a04,a57);
  a30=arg[0]? arg[0][32] : 0;
  a59=(a12<=a00);
  a60=(a59?a19:0);
  a59=(!a59);
  a61=arg[2]? arg[2][40] : 0;
  a59=(a59?a61:0);
  a60=(a60+a59);
  a59=(a19-a60);
  a61=(a30<a59);
  a62=(a61?a02:0);
  a61=(!a61);
  a30=(-a30);
  a30=(a59<a30);
  a63=(a30?a25:0);
  a30=(!a30);
  a64=arg[2]? arg[2][41] : 0;
  a30=(a30?a64:0);
  a63=(a63+a30);
  a61=(a61?a63:0);
  a62=(a62+a61);
  a64=(a62==a64);
  a64=(!a64);
  a64=(a64?a02:0);
  a57=(a57+a64);
  a64=(a57<=a58);
  a61=(a12<=a00);
  a61=(!a61);
  a63=arg[2]? arg[2][45] : 0;
  a61=(a61?a63:0);
  a61=(a61-a18);
  a61=casadi_fmax(a04,a61);
  a63=arg[0]? arg[0][33] : 0;
  a30=(a12<=a00);
  a30=(!a30);
  a65=arg[2]? arg[2][43] : 0;
  a66=(-a65);
  a66=(a30?a66:0);
  a20=(a20+a66);
  a66=(a63<a20);
  a67=(a66?a02:0);
  a66=(!a66);
  a63=(-a63);
  a63=(a20<a63);
  a68=(a63?a25:0);
  a63=(!a63);
  a69=arg[2]? arg[2][44] : 0;
  a63=(a63?a69:0);
  a68=(a68+a63);
  a66=(a66?a68:0);
  a67=(a67+a66);
  a69=(a67==a69);
  a69=(!a69);
  a69=(a69?a02:0);
  a61=(a61+a69);
  a69=(a61<=a58);
  a66=(a12<=a00);
  a66=(!a66);
  a68=arg[2]? arg[2][48] : 0;
  a66=(a66?a68:0);
  a66=(a66-a18);
  a66=casadi_fmax(a04,a66);
  a18=arg[0]? arg[0][34] : 0;
  a68=(a12<=a00);
  a68=(!a68);
  a63=arg[2]? arg[2][46] : 0;
  a70=(-a63);
  a70=(a68?a70:0);
  a48=(a48+a70);
  a70=(a18<a48);
  a71=(a70?a02:0);
  a70=(!a70);
  a18=(-a18);
  a18=(a48<a18);
  a25=(a18?a25:0);
  a18=(!a18);
  a72=arg[2]? arg[2][47] : 0;
  a18=(a18?a72:0);
  a25=(a25+a18);
  a70=(a70?a25:0);
  a71=(a71+a70);
  a72=(a71==a72);
  a72=(!a72);
  a72=(a72?a02:0);
  a66=(a66+a72);
  a58=(a66<=a58);
  a58=(!a58);
  a72=8002.;
  a58=(a58?a72:0);
  a58=(a69?a58:0);
  a69=(!a69);
  a72=8001.;
  a69=(a69?a72:0);
  a58=(a58+a69);
  a58=(a64?a58:0);
  a64=(!a64);
  a69=6005.;
  a64=(a64?a69:0);
  a58=(a58+a64);
  a58=(a55?a58:0);
  a55=(!a55);
  a64=6004.;
  a55=(a55?a64:0);
  a58=(a58+a55);
  a58=(a13?a58:0);
  a13=(!a13);
  a55=5006.;
  a13=(a13?a55:0);
  a58=(a58+a13);
  a58=(a17?a58:0);
  a17=(!a17);
  a13=5003.;
  a17=(a17?a13:0);
  a58=(a58+a17);
  a58=(a46?a58:0);
  a46=(!a46);
  a17=3006.;
  a46=(a46?a17:0);
  a58=(a58+a46);
  a58=(a36?a58:0);
  a36=(!a36);
  a46=3005.;
  a36=(a36?a46:0);
  a58=(a58+a36);
  a58=(a22?a58:0);
  a22=(!a22);
  a36=3004.;
  a22=(a22?a36:0);
  a58=(a58+a22);
  a58=(a14?a58:0);
  a14=(!a14);
  a22=3003.;
  a14=(a14?a22:0);
  a58=(a58+a14);
  a05=(a05?a58:0);
  a24=(a24+a05);
  a05=(a00<a24);
  a24=(a05?a24:0);
  a05=(!a05);
  a58=arg[1]? arg[1][4] : 0;
  a14=arg[0]? arg[0][14] : 0;
  a22=casadi_fabs(a10);
  a14=casadi_fmax(a14,a22);
  a58=(a58/a14);
  a14=arg[1]? arg[1][3] : 0;
  a22=arg[1]? arg[1][2] : 0;
  a36=(a10*a22);
  a36=(a14+a36);
  a36=casadi_fmin(a02,a36);
  a36=casadi_fmax(a04,a36);
  a36=(a58*a36);
  a36=(-a36);
  a22=(a10*a22);
  a14=(a14-a22);
  a14=casadi_fmin(a02,a14);
  a14=casadi_fmax(a04,a14);
  a58=(a58*a14);
  a14=(a12<=a00);
  a14=(!a14);
  a22=arg[2]? arg[2][51] : 0;
  a14=(a14?a22:0);
  a22=arg[0]? arg[0][38] : 0;
  a22=(a04<a22);
  a46=(a12<=a00);
  a17=arg[0]? arg[0][11] : 0;
  a13=(a46?a17:0);
  a46=(!a46);
  a55=arg[2]? arg[2][20] : 0;
  a46=(a46?a55:0);
  a13=(a13+a46);
  a46=arg[2]? arg[2][21] : 0;
  a46=(a17!=a46);
  a55=arg[1]? arg[1][1] : 0;
  a64=(a17-a13);
  a69=casadi_fabs(a64);
  a55=(a55*a69);
  a69=9.9999999999999995e-07;
  a72=casadi_fabs(a17);
  a72=(a69*a72);
  a70=casadi_fabs(a13);
  a69=(a69*a70);
  a72=(a72+a69);
  a55=casadi_fmax(a55,a72);
  a55=(a46?a55:0);
  a46=(!a46);
  a72=arg[2]? arg[2][22] : 0;
  a46=(a46?a72:0);
  a55=(a55+a46);
  a46=casadi_fabs(a64);
  a46=(a55<a46);
  a72=(-a55);
  a69=casadi_fmin(a64,a55);
  a72=casadi_fmax(a72,a69);
  a72=(a13+a72);
  a72=(a46?a72:0);
  a46=(!a46);
  a46=(a46?a17:0);
  a72=(a72+a46);
  a46=(a13-a72);
  a46=(a15*a46);
  a22=(a22?a46:0);
  a14=(a14+a22);
  a22=(a12<=a00);
  a46=(a22?a10:0);
  a22=(!a22);
  a69=arg[2]? arg[2][49] : 0;
  a22=(a22?a69:0);
  a46=(a46+a22);
  a22=arg[1]? arg[1][15] : 0;
  a69=(-a22);
  a07=(a27?a07:0);
  a27=(!a27);
  a70=arg[2]? arg[2][4] : 0;
  a27=(a27?a70:0);
  a07=(a07+a27);
  a27=(a07-a46);
  a22=casadi_fmin(a22,a27);
  a69=casadi_fmax(a69,a22);
  a46=(a46+a69);
  a69=(a46-a10);
  a22=arg[0]? arg[0][37] : 0;
  a22=(a69*a22);
  a22=(a14+a22);
  a27=(a15*a72);
  a22=(a22+a27);
  a58=casadi_fmin(a58,a22);
  a36=casadi_fmax(a36,a58);
  a58=casadi_fabs(a36);
  a27=arg[1]? arg[1][21] : 0;
  a58=(a58<=a27);
  a70=(a58?a02:0);
  a70=(a00<a70);
  a25=arg[1]? arg[1][7] : 0;
  a18=arg[0]? arg[0][18] : 0;
  a73=casadi_fabs(a16);
  a18=casadi_fmax(a18,a73);
  a25=(a25/a18);
  a18=arg[1]? arg[1][6] : 0;
  a73=arg[1]? arg[1][5] : 0;
  a74=(a16*a73);
  a74=(a18+a74);
  a74=casadi_fmin(a02,a74);
  a74=casadi_fmax(a04,a74);
  a74=(a25*a74);
  a74=(-a74);
  a73=(a16*a73);
  a18=(a18-a73);
  a18=casadi_fmin(a02,a18);
  a18=casadi_fmax(a04,a18);
  a25=(a25*a18);
  a18=(a12<=a00);
  a18=(!a18);
  a73=arg[2]? arg[2][52] : 0;
  a18=(a18?a73:0);
  a73=arg[0]? arg[0][40] : 0;
  a73=(a04<a73);
  a13=(a13-a72);
  a13=(a19*a13);
  a13=(-a13);
  a73=(a73?a13:0);
  a18=(a18+a73);
  a12=(a12<=a00);
  a73=(a12?a16:0);
  a12=(!a12);
  a13=arg[2]? arg[2][50] : 0;
  a12=(a12?a13:0);
  a73=(a73+a12);
  a12=arg[1]? arg[1][16] : 0;
  a13=(-a12);
  a09=(a32?a09:0);
  a32=(!a32);
  a75=arg[2]? arg[2][6] : 0;
  a32=(a32?a75:0);
  a09=(a09+a32);
  a32=(a09-a73);
  a12=casadi_fmin(a12,a32);
  a13=casadi_fmax(a13,a12);
  a73=(a73+a13);
  a13=(a73-a16);
  a12=arg[0]? arg[0][39] : 0;
  a12=(a13*a12);
  a12=(a18+a12);
  a32=(a19*a72);
  a12=(a12-a32);
  a25=casadi_fmin(a25,a12);
  a74=casadi_fmax(a74,a25);
  a25=casadi_fabs(a74);
  a32=arg[1]? arg[1][22] : 0;
  a25=(a25<=a32);
  a75=(a25?a02:0);
  a75=(a00<a75);
  a75=(!a75);
  a76=7002.;
  a75=(a75?a76:0);
  a75=(a70?a75:0);
  a70=(!a70);
  a76=7001.;
  a70=(a70?a76:0);
  a75=(a75+a70);
  a05=(a05?a75:0);
  a24=(a24+a05);
  if (res[0]!=0) res[0][0]=a24;
  a05=(a00<a24);
  a75=arg[1]? arg[1][23] : 0;
  a70=(-a75);
  a70=(a05?a70:0);
  a05=(!a05);
  a05=(a05?a75:0);
  a70=(a70+a05);
  a03=(a03+a70);
  a04=casadi_fmax(a04,a03);
  a04=casadi_fmin(a02,a04);
  if (res[0]!=0) res[0][1]=a04;
  a03=(a00<a24);
  a03=(!a03);
  a03=(a03?a02:0);
  if (res[0]!=0) res[0][2]=a03;
  if (res[0]!=0) res[0][3]=a21;
  if (res[0]!=0) res[0][4]=a07;
  if (res[0]!=0) res[0][5]=a31;
  if (res[0]!=0) res[0][6]=a09;
  if (res[0]!=0) res[0][7]=a34;
  if (res[0]!=0) res[0][8]=a10;
  if (res[0]!=0) res[0][9]=a35;
  if (res[0]!=0) res[0][10]=a15;
  if (res[0]!=0) res[0][11]=a37;
  if (res[0]!=0) res[0][12]=a19;
  if (res[0]!=0) res[0][13]=a39;
  if (res[0]!=0) res[0][14]=a16;
  if (res[0]!=0) res[0][15]=a40;
  if (res[0]!=0) res[0][16]=a41;
  if (res[0]!=0) res[0][17]=a42;
  if (res[0]!=0) res[0][18]=a26;
  a01=(a00<a01);
  a11=(a11?a23:0);
  a06=(a06?a11:0);
  a01=(a01?a06:0);
  if (res[0]!=0) res[0][19]=a01;
  if (res[0]!=0) res[0][20]=a72;
  if (res[0]!=0) res[0][21]=a17;
  a64=casadi_fabs(a64);
  a64=(a55<a64);
  a64=(a64?a55:0);
  if (res[0]!=0) res[0][22]=a64;
  if (res[0]!=0) res[0][23]=a28;
  if (res[0]!=0) res[0][24]=a52;
  if (res[0]!=0) res[0][25]=a10;
  if (res[0]!=0) res[0][26]=a38;
  if (res[0]!=0) res[0][27]=a15;
  if (res[0]!=0) res[0][28]=a43;
  if (res[0]!=0) res[0][29]=a45;
  if (res[0]!=0) res[0][30]=a44;
  if (res[0]!=0) res[0][31]=a29;
  if (res[0]!=0) res[0][32]=a16;
  if (res[0]!=0) res[0][33]=a50;
  if (res[0]!=0) res[0][34]=a19;
  if (res[0]!=0) res[0][35]=a49;
  if (res[0]!=0) res[0][36]=a51;
  a51=arg[1]? arg[1][14] : 0;
  a53=(a53*a51);
  a54=(a54+a53);
  if (res[0]!=0) res[0][37]=a54;
  if (res[0]!=0) res[0][38]=a56;
  if (res[0]!=0) res[0][39]=a33;
  a59=(a59*a51);
  a60=(a60+a59);
  if (res[0]!=0) res[0][40]=a60;
  if (res[0]!=0) res[0][41]=a62;
  if (res[0]!=0) res[0][42]=a57;
  a30=(a30?a65:0);
  a20=(a20*a51);
  a30=(a30+a20);
  if (res[0]!=0) res[0][43]=a30;
  if (res[0]!=0) res[0][44]=a67;
  if (res[0]!=0) res[0][45]=a61;
  a68=(a68?a63:0);
  a48=(a48*a51);
  a68=(a68+a48);
  if (res[0]!=0) res[0][46]=a68;
  if (res[0]!=0) res[0][47]=a71;
  if (res[0]!=0) res[0][48]=a66;
  if (res[0]!=0) res[0][49]=a46;
  if (res[0]!=0) res[0][50]=a73;
  a22=(a36-a22);
  a73=arg[1]? arg[1][18] : 0;
  a22=(a22*a73);
  a14=(a14+a22);
  a22=arg[1]? arg[1][17] : 0;
  a69=(a69*a22);
  a14=(a14+a69);
  if (res[0]!=0) res[0][51]=a14;
  a12=(a74-a12);
  a14=arg[1]? arg[1][20] : 0;
  a12=(a12*a14);
  a18=(a18+a12);
  a12=arg[1]? arg[1][19] : 0;
  a13=(a13*a12);
  a18=(a18+a13);
  if (res[0]!=0) res[0][52]=a18;
  a18=2.9995000000000000e+03;
  a13=(a18<a24);
  a12=arg[2]? arg[2][55] : 0;
  a14=arg[1]? arg[1][24] : 0;
  a69=(a24<=a00);
  a36=(a58?a36:0);
  a58=(!a58);
  a58=(a58?a08:0);
  a36=(a36+a58);
  a36=(a69?a36:0);
  a69=(!a69);
  a69=(a69?a08:0);
  a36=(a36+a69);
  a69=(a36-a12);
  a69=(a14*a69);
  a69=(a12+a69);
  a08=casadi_fabs(a69);
  a08=(a08<=a27);
  a69=(a08?a69:0);
  a08=(!a08);
  a08=(a08?a12:0);
  a69=(a69+a08);
  a08=(a13?a69:0);
  a13=(!a13);
  a13=(a13?a36:0);
  a08=(a08+a13);
  if (res[0]!=0) res[0][53]=a08;
  a18=(a18<a24);
  a13=arg[2]? arg[2][56] : 0;
  a24=(a24<=a00);
  a74=(a25?a74:0);
  a25=(!a25);
  a25=(a25?a47:0);
  a74=(a74+a25);
  a74=(a24?a74:0);
  a24=(!a24);
  a24=(a24?a47:0);
  a74=(a74+a24);
  a24=(a74-a13);
  a14=(a14*a24);
  a14=(a13+a14);
  a24=casadi_fabs(a14);
  a24=(a24<=a32);
  a14=(a24?a14:0);
  a24=(!a24);
  a24=(a24?a13:0);
  a14=(a14+a24);
  a24=(a18?a14:0);
  a18=(!a18);
  a18=(a18?a74:0);
  a24=(a24+a18);
  if (res[0]!=0) res[0][54]=a24;
  if (res[0]!=0) res[0][55]=a69;
  if (res[0]!=0) res[0][56]=a14;
  a14=-480.;
  a69=480.;
  a08=(a08*a04);
  a08=casadi_fmin(a69,a08);
  a08=casadi_fmax(a14,a08);
  if (res[1]!=0) res[1][0]=a08;
  a24=(a24*a04);
  a69=casadi_fmin(a69,a24);
  a14=casadi_fmax(a14,a69);
  if (res[1]!=0) res[1][1]=a14;
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


