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
static const casadi_int casadi_s1[3] = {19, 1, 1};
static const casadi_int casadi_s2[3] = {55, 1, 1};
static const casadi_int casadi_s3[3] = {7, 1, 1};
static const casadi_int casadi_s4[3] = {2, 1, 1};

static const casadi_real casadi_zeros[41] = 
  {0.};

/* controller_prepare:(parameters[41])->(derived[19]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real w1, w2, w3, w4;
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
  /* #5: @2 = @0[16] */
  w2 = wr0[16];
  /* #6: @3 = (1./@2) */
  w3 = (1./ w2 );
  /* #7: output[0][1] = @3 */
  if (res[0]) res[0][1] = w3;
  /* #8: @3 = 1 */
  w3 = 1.;
  /* #9: @4 = @0[15] */
  w4 = wr0[15];
  /* #10: @4 = (@4/@2) */
  w4 /= w2;
  /* #11: @3 = (@3+@4) */
  w3 += w4;
  /* #12: output[0][2] = @3 */
  if (res[0]) res[0][2] = w3;
  /* #13: @3 = @0[20] */
  w3 = wr0[20];
  /* #14: @4 = (1./@3) */
  w4 = (1./ w3 );
  /* #15: output[0][3] = @4 */
  if (res[0]) res[0][3] = w4;
  /* #16: @4 = 1 */
  w4 = 1.;
  /* #17: @2 = @0[19] */
  w2 = wr0[19];
  /* #18: @2 = (@2/@3) */
  w2 /= w3;
  /* #19: @4 = (@4+@2) */
  w4 += w2;
  /* #20: output[0][4] = @4 */
  if (res[0]) res[0][4] = w4;
  /* #21: @4 = @0[22] */
  w4 = wr0[22];
  /* #22: @4 = (@4*@1) */
  w4 *= w1;
  /* #23: output[0][5] = @4 */
  if (res[0]) res[0][5] = w4;
  /* #24: @4 = @0[23] */
  w4 = wr0[23];
  /* #25: @4 = (@1/@4) */
  w4  = (w1/w4);
  /* #26: output[0][6] = @4 */
  if (res[0]) res[0][6] = w4;
  /* #27: @4 = @0[27] */
  w4 = wr0[27];
  /* #28: @4 = (@1/@4) */
  w4  = (w1/w4);
  /* #29: output[0][7] = @4 */
  if (res[0]) res[0][7] = w4;
  /* #30: @4 = @0[30] */
  w4 = wr0[30];
  /* #31: @2 = (@4*@1) */
  w2  = (w4*w1);
  /* #32: output[0][8] = @2 */
  if (res[0]) res[0][8] = w2;
  /* #33: @2 = 6.2832 */
  w2 = 6.2831999999999999e+00;
  /* #34: @2 = (@2*@4) */
  w2 *= w4;
  /* #35: @2 = (@2*@1) */
  w2 *= w1;
  /* #36: output[0][9] = @2 */
  if (res[0]) res[0][9] = w2;
  /* #37: @2 = @0[35] */
  w2 = wr0[35];
  /* #38: @2 = (@2*@1) */
  w2 *= w1;
  /* #39: output[0][10] = @2 */
  if (res[0]) res[0][10] = w2;
  /* #40: @2 = @0[36] */
  w2 = wr0[36];
  /* #41: @2 = (@2*@1) */
  w2 *= w1;
  /* #42: output[0][11] = @2 */
  if (res[0]) res[0][11] = w2;
  /* #43: @2 = @0[38] */
  w2 = wr0[38];
  /* #44: @4 = (@2*@1) */
  w4  = (w2*w1);
  /* #45: output[0][12] = @4 */
  if (res[0]) res[0][12] = w4;
  /* #46: @2 = (@2*@1) */
  w2 *= w1;
  /* #47: @4 = @0[37] */
  w4 = wr0[37];
  /* #48: @2 = (@2/@4) */
  w2 /= w4;
  /* #49: output[0][13] = @2 */
  if (res[0]) res[0][13] = w2;
  /* #50: @2 = @0[40] */
  w2 = wr0[40];
  /* #51: @4 = (@2*@1) */
  w4  = (w2*w1);
  /* #52: output[0][14] = @4 */
  if (res[0]) res[0][14] = w4;
  /* #53: @2 = (@2*@1) */
  w2 *= w1;
  /* #54: @4 = @0[39] */
  w4 = wr0[39];
  /* #55: @2 = (@2/@4) */
  w2 /= w4;
  /* #56: output[0][15] = @2 */
  if (res[0]) res[0][15] = w2;
  /* #57: @2 = 1.01 */
  w2 = 1.0100000000000000e+00;
  /* #58: @4 = 480 */
  w4 = 480.;
  /* #59: @3 = @0[17] */
  w3 = wr0[17];
  /* #60: @4 = fmin(@4,@3) */
  w4  = casadi_fmin(w4,w3);
  /* #61: @2 = (@2*@4) */
  w2 *= w4;
  /* #62: output[0][16] = @2 */
  if (res[0]) res[0][16] = w2;
  /* #63: @2 = 1.01 */
  w2 = 1.0100000000000000e+00;
  /* #64: @4 = 480 */
  w4 = 480.;
  /* #65: @3 = @0[21] */
  w3 = wr0[21];
  /* #66: @4 = fmin(@4,@3) */
  w4  = casadi_fmin(w4,w3);
  /* #67: @2 = (@2*@4) */
  w2 *= w4;
  /* #68: output[0][17] = @2 */
  if (res[0]) res[0][17] = w2;
  /* #69: @2 = @0[1] */
  w2 = wr0[1];
  /* #70: @1 = (@1/@2) */
  w1 /= w2;
  /* #71: output[0][18] = @1 */
  if (res[0]) res[0][18] = w1;
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

/* controller_step:(parameters[41],derived[19],states[55],inputs[7])->(next_states[55],outputs[2]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
  casadi_real a84, a85, a86, a87, a88, a89, a90, a91, a92, a93, a94, a95;
  casadi_real a96, a97;
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
  a07=(a08?a07:0);
  a09=(!a08);
  a10=arg[2]? arg[2][8] : 0;
  a09=(a09?a10:0);
  a07=(a07+a09);
  a09=casadi_fabs(a07);
  a10=arg[0]? arg[0][9] : 0;
  a09=(a09<=a10);
  a09=(a09?a02:0);
  a10=arg[3]? arg[3][0] : 0;
  a11=casadi_fabs(a10);
  a12=arg[0]? arg[0][3] : 0;
  a11=(a11<=a12);
  a12=(a11?a02:0);
  a13=casadi_fmin(a09,a12);
  a08=(a08?a02:0);
  a13=casadi_fmin(a13,a08);
  a14=arg[3]? arg[3][5] : 0;
  a15=casadi_fabs(a14);
  a16=arg[0]? arg[0][8] : 0;
  a15=(a15<=a16);
  a14=(a15?a14:0);
  a16=(!a15);
  a17=arg[2]? arg[2][14] : 0;
  a16=(a16?a17:0);
  a14=(a14+a16);
  a16=casadi_fabs(a14);
  a17=arg[0]? arg[0][10] : 0;
  a16=(a16<=a17);
  a16=(a16?a02:0);
  a13=casadi_fmin(a13,a16);
  a17=arg[3]? arg[3][1] : 0;
  a18=casadi_fabs(a17);
  a19=arg[0]? arg[0][4] : 0;
  a18=(a18<=a19);
  a19=(a18?a02:0);
  a13=casadi_fmin(a13,a19);
  a15=(a15?a02:0);
  a13=casadi_fmin(a13,a15);
  a20=arg[3]? arg[3][3] : 0;
  a21=casadi_fabs(a20);
  a22=arg[0]? arg[0][6] : 0;
  a21=(a21<=a22);
  a22=(a21?a02:0);
  a13=casadi_fmin(a13,a22);
  a23=arg[3]? arg[3][4] : 0;
  a24=casadi_fabs(a23);
  a25=arg[0]? arg[0][7] : 0;
  a24=(a24<=a25);
  a25=(a24?a02:0);
  a13=casadi_fmin(a13,a25);
  a26=arg[2]? arg[2][3] : 0;
  a27=(a02-a26);
  a13=(a13*a27);
  a27=arg[2]? arg[2][19] : 0;
  a28=-1.;
  a29=arg[3]? arg[3][6] : 0;
  a29=(a28+a29);
  a29=casadi_fabs(a29);
  a29=(a29<=a00);
  a29=(a29?a02:0);
  a30=arg[2]? arg[2][18] : 0;
  a30=(a29-a30);
  a27=casadi_fmax(a27,a30);
  a13=(a13*a27);
  a27=(-a13);
  a27=(a06?a27:0);
  a05=(a05?a27:0);
  a05=(a02+a05);
  a01=(a01*a05);
  a05=(a00<a01);
  a27=(a05?a01:0);
  a05=(!a05);
  a30=9998.;
  a08=(a00<a08);
  a31=(!a08);
  a32=arg[2]? arg[2][9] : 0;
  a33=arg[0]? arg[0][0] : 0;
  a34=(a32+a33);
  a35=arg[0]? arg[0][2] : 0;
  a36=(a00*a33);
  a36=(a35+a36);
  a36=(a34<=a36);
  a36=(!a36);
  a36=(a36?a02:0);
  a31=(a31?a36:0);
  a31=(a04<a31);
  a36=3.;
  a36=(a31?a36:0);
  a31=(!a31);
  a37=9999.;
  a31=(a31?a37:0);
  a36=(a36+a31);
  a09=(a00<a09);
  a31=(!a09);
  a38=arg[2]? arg[2][16] : 0;
  a39=(a38+a33);
  a40=(a00*a33);
  a40=(a35+a40);
  a40=(a39<=a40);
  a40=(!a40);
  a40=(a40?a02:0);
  a31=(a31?a40:0);
  a31=(a04<a31);
  a40=4003.;
  a40=(a31?a40:0);
  a31=(!a31);
  a31=(a31?a37:0);
  a40=(a40+a31);
  a36=casadi_fmin(a36,a40);
  a12=(a00<a12);
  a40=(!a12);
  a31=arg[2]? arg[2][5] : 0;
  a41=(a31+a33);
  a42=(a00*a33);
  a42=(a35+a42);
  a42=(a41<=a42);
  a42=(!a42);
  a42=(a42?a02:0);
  a40=(a40?a42:0);
  a40=(a04<a40);
  a42=(a40?a02:0);
  a40=(!a40);
  a40=(a40?a37:0);
  a42=(a42+a40);
  a36=casadi_fmin(a36,a42);
  a15=(a00<a15);
  a42=(!a15);
  a40=arg[2]? arg[2][15] : 0;
  a43=(a40+a33);
  a44=(a00*a33);
  a44=(a35+a44);
  a44=(a43<=a44);
  a44=(!a44);
  a44=(a44?a02:0);
  a42=(a42?a44:0);
  a42=(a04<a42);
  a44=6.;
  a44=(a42?a44:0);
  a42=(!a42);
  a42=(a42?a37:0);
  a44=(a44+a42);
  a36=casadi_fmin(a36,a44);
  a16=(a00<a16);
  a44=(!a16);
  a42=arg[2]? arg[2][17] : 0;
  a45=(a42+a33);
  a46=(a00*a33);
  a46=(a35+a46);
  a46=(a45<=a46);
  a46=(!a46);
  a46=(a46?a02:0);
  a44=(a44?a46:0);
  a44=(a04<a44);
  a46=4006.;
  a46=(a44?a46:0);
  a44=(!a44);
  a44=(a44?a37:0);
  a46=(a46+a44);
  a36=casadi_fmin(a36,a46);
  a19=(a00<a19);
  a46=(!a19);
  a44=arg[2]? arg[2][7] : 0;
  a47=(a44+a33);
  a48=(a00*a33);
  a48=(a35+a48);
  a48=(a47<=a48);
  a48=(!a48);
  a48=(a48?a02:0);
  a46=(a46?a48:0);
  a46=(a04<a46);
  a48=2.;
  a48=(a46?a48:0);
  a46=(!a46);
  a46=(a46?a37:0);
  a48=(a48+a46);
  a36=casadi_fmin(a36,a48);
  a22=(a00<a22);
  a48=(!a22);
  a46=arg[2]? arg[2][11] : 0;
  a49=(a46+a33);
  a50=(a00*a33);
  a50=(a35+a50);
  a50=(a49<=a50);
  a50=(!a50);
  a50=(a50?a02:0);
  a48=(a48?a50:0);
  a48=(a04<a48);
  a50=4.;
  a50=(a48?a50:0);
  a48=(!a48);
  a48=(a48?a37:0);
  a50=(a50+a48);
  a36=casadi_fmin(a36,a50);
  a25=(a00<a25);
  a50=(!a25);
  a48=arg[2]? arg[2][13] : 0;
  a51=(a48+a33);
  a52=(a00*a33);
  a52=(a35+a52);
  a52=(a51<=a52);
  a52=(!a52);
  a52=(a52?a02:0);
  a50=(a50?a52:0);
  a50=(a04<a50);
  a52=5.;
  a52=(a50?a52:0);
  a50=(!a50);
  a50=(a50?a37:0);
  a52=(a52+a50);
  a36=casadi_fmin(a36,a52);
  a52=(a30<a36);
  a52=(!a52);
  a52=(a52?a36:0);
  a05=(a05?a52:0);
  a27=(a27+a05);
  a05=(a00<a27);
  a27=(a05?a27:0);
  a05=(!a05);
  a52=arg[2]? arg[2][2] : 0;
  a36=(a00<a52);
  a50=arg[2]? arg[2][23] : 0;
  a50=(a36?a50:0);
  a36=(!a36);
  a36=(a36?a07:0);
  a50=(a50+a36);
  a36=arg[1]? arg[1][6] : 0;
  a53=arg[2]? arg[2][53] : 0;
  a54=(a53*a03);
  a20=(a21?a20:0);
  a21=(!a21);
  a55=arg[2]? arg[2][10] : 0;
  a21=(a21?a55:0);
  a20=(a20+a21);
  a21=(a54-a20);
  a36=(a36*a21);
  a36=(a50+a36);
  a21=arg[1]? arg[1][5] : 0;
  a50=(a07-a50);
  a50=(a21*a50);
  a36=(a36+a50);
  a50=(a36-a07);
  a50=casadi_fabs(a50);
  a55=arg[0]? arg[0][24] : 0;
  a55=(a50<=a55);
  a55=(a55?a02:0);
  a55=(a00<a55);
  a56=(!a55);
  a57=arg[2]? arg[2][24] : 0;
  a58=(a57+a33);
  a59=(a00*a33);
  a59=(a35+a59);
  a59=(a58<=a59);
  a59=(!a59);
  a59=(a59?a02:0);
  a56=(a56?a59:0);
  a56=(a04<a56);
  a59=5003.;
  a59=(a56?a59:0);
  a56=(!a56);
  a56=(a56?a37:0);
  a59=(a59+a56);
  a56=arg[0]? arg[0][25] : 0;
  a60=(a50-a56);
  a61=arg[2]? arg[2][25] : 0;
  a61=(a07==a61);
  a62=(a00<a52);
  a63=arg[2]? arg[2][26] : 0;
  a62=(a62?a63:0);
  a62=(a62+a33);
  a61=(a61?a62:0);
  a62=arg[0]? arg[0][26] : 0;
  a63=(a61-a62);
  a60=casadi_fmin(a60,a63);
  a60=(a04<a60);
  a63=3003.;
  a63=(a60?a63:0);
  a60=(!a60);
  a60=(a60?a37:0);
  a63=(a63+a60);
  a59=casadi_fmin(a59,a63);
  a63=-5.5000000000000000e+00;
  a60=(a00<a52);
  a64=arg[2]? arg[2][45] : 0;
  a60=(a60?a64:0);
  a64=arg[1]? arg[1][8] : 0;
  a60=(a60-a64);
  a60=casadi_fmax(a04,a60);
  a65=arg[0]? arg[0][33] : 0;
  a66=(a00<a52);
  a67=arg[2]? arg[2][43] : 0;
  a68=(-a67);
  a68=(a66?a68:0);
  a68=(a54+a68);
  a69=(a65<a68);
  a70=(a69?a02:0);
  a69=(!a69);
  a65=(-a65);
  a65=(a68<a65);
  a71=(a65?a28:0);
  a65=(!a65);
  a72=arg[2]? arg[2][44] : 0;
  a65=(a65?a72:0);
  a71=(a71+a65);
  a69=(a69?a71:0);
  a70=(a70+a69);
  a72=(a70==a72);
  a72=(!a72);
  a72=(a72?a02:0);
  a60=(a60+a72);
  a72=(a63+a60);
  a72=(a04<a72);
  a69=8001.;
  a69=(a72?a69:0);
  a72=(!a72);
  a72=(a72?a37:0);
  a69=(a69+a72);
  a59=casadi_fmin(a59,a69);
  a69=(a00<a52);
  a72=arg[2]? arg[2][30] : 0;
  a72=(a69?a72:0);
  a69=(!a69);
  a69=(a69?a14:0);
  a72=(a72+a69);
  a69=arg[1]? arg[1][7] : 0;
  a71=arg[2]? arg[2][54] : 0;
  a65=(a71*a03);
  a23=(a24?a23:0);
  a24=(!a24);
  a73=arg[2]? arg[2][12] : 0;
  a24=(a24?a73:0);
  a23=(a23+a24);
  a24=(a65+a23);
  a69=(a69*a24);
  a69=(a72+a69);
  a72=(a14-a72);
  a21=(a21*a72);
  a69=(a69+a21);
  a21=(a69-a14);
  a21=casadi_fabs(a21);
  a72=arg[0]? arg[0][28] : 0;
  a72=(a21<=a72);
  a72=(a72?a02:0);
  a72=(a00<a72);
  a24=(!a72);
  a73=arg[2]? arg[2][31] : 0;
  a74=(a73+a33);
  a75=(a00*a33);
  a75=(a35+a75);
  a75=(a74<=a75);
  a75=(!a75);
  a75=(a75?a02:0);
  a24=(a24?a75:0);
  a24=(a04<a24);
  a75=5006.;
  a75=(a24?a75:0);
  a24=(!a24);
  a24=(a24?a37:0);
  a75=(a75+a24);
  a59=casadi_fmin(a59,a75);
  a75=arg[0]? arg[0][29] : 0;
  a24=(a21-a75);
  a76=arg[2]? arg[2][32] : 0;
  a76=(a14==a76);
  a77=(a00<a52);
  a78=arg[2]? arg[2][33] : 0;
  a77=(a77?a78:0);
  a77=(a77+a33);
  a76=(a76?a77:0);
  a77=(a76-a62);
  a24=casadi_fmin(a24,a77);
  a24=(a04<a24);
  a77=3006.;
  a77=(a24?a77:0);
  a24=(!a24);
  a24=(a24?a37:0);
  a77=(a77+a24);
  a59=casadi_fmin(a59,a77);
  a77=(a00<a52);
  a24=arg[2]? arg[2][48] : 0;
  a77=(a77?a24:0);
  a77=(a77-a64);
  a77=casadi_fmax(a04,a77);
  a24=arg[0]? arg[0][34] : 0;
  a78=(a00<a52);
  a79=arg[2]? arg[2][46] : 0;
  a80=(-a79);
  a80=(a78?a80:0);
  a80=(a65+a80);
  a81=(a24<a80);
  a82=(a81?a02:0);
  a81=(!a81);
  a24=(-a24);
  a24=(a80<a24);
  a83=(a24?a28:0);
  a24=(!a24);
  a84=arg[2]? arg[2][47] : 0;
  a24=(a24?a84:0);
  a83=(a83+a24);
  a81=(a81?a83:0);
  a82=(a82+a81);
  a84=(a82==a84);
  a84=(!a84);
  a84=(a84?a02:0);
  a77=(a77+a84);
  a84=(a63+a77);
  a84=(a04<a84);
  a81=8002.;
  a81=(a84?a81:0);
  a84=(!a84);
  a84=(a84?a37:0);
  a81=(a81+a84);
  a59=casadi_fmin(a59,a81);
  a50=(a50-a56);
  a56=arg[2]? arg[2][27] : 0;
  a56=(a20==a56);
  a81=(a00<a52);
  a84=arg[2]? arg[2][28] : 0;
  a81=(a81?a84:0);
  a81=(a81+a33);
  a56=(a56?a81:0);
  a81=(a56-a62);
  a50=casadi_fmin(a50,a81);
  a81=-5.0000000000000003e-02;
  a84=arg[0]? arg[0][17] : 0;
  a83=(a81*a84);
  a24=(a04<a56);
  a85=arg[2]? arg[2][29] : 0;
  a85=(a24?a85:0);
  a24=(!a24);
  a24=(a24?a54:0);
  a85=(a85+a24);
  a54=(a54-a85);
  a54=casadi_fabs(a54);
  a83=(a83+a54);
  a50=casadi_fmin(a50,a83);
  a50=(a04<a50);
  a83=3004.;
  a83=(a50?a83:0);
  a50=(!a50);
  a50=(a50?a37:0);
  a83=(a83+a50);
  a59=casadi_fmin(a59,a83);
  a83=(a00<a52);
  a50=arg[2]? arg[2][39] : 0;
  a83=(a83?a50:0);
  a83=(a83-a64);
  a83=casadi_fmax(a04,a83);
  a50=arg[0]? arg[0][31] : 0;
  a54=(a00<a52);
  a24=arg[2]? arg[2][37] : 0;
  a24=(a54?a24:0);
  a54=(!a54);
  a54=(a54?a20:0);
  a24=(a24+a54);
  a54=(a20-a24);
  a86=(a50<a54);
  a87=(a86?a02:0);
  a86=(!a86);
  a50=(-a50);
  a50=(a54<a50);
  a88=(a50?a28:0);
  a50=(!a50);
  a89=arg[2]? arg[2][38] : 0;
  a50=(a50?a89:0);
  a88=(a88+a50);
  a86=(a86?a88:0);
  a87=(a87+a86);
  a89=(a87==a89);
  a89=(!a89);
  a89=(a89?a02:0);
  a83=(a83+a89);
  a89=(a63+a83);
  a89=(a04<a89);
  a86=6004.;
  a86=(a89?a86:0);
  a89=(!a89);
  a89=(a89?a37:0);
  a86=(a86+a89);
  a59=casadi_fmin(a59,a86);
  a21=(a21-a75);
  a75=arg[2]? arg[2][34] : 0;
  a75=(a23==a75);
  a86=(a00<a52);
  a89=arg[2]? arg[2][35] : 0;
  a86=(a86?a89:0);
  a86=(a86+a33);
  a75=(a75?a86:0);
  a62=(a75-a62);
  a21=casadi_fmin(a21,a62);
  a62=arg[0]? arg[0][21] : 0;
  a81=(a81*a62);
  a86=(a04<a75);
  a89=arg[2]? arg[2][36] : 0;
  a89=(a86?a89:0);
  a86=(!a86);
  a86=(a86?a65:0);
  a89=(a89+a86);
  a65=(a65-a89);
  a65=casadi_fabs(a65);
  a81=(a81+a65);
  a21=casadi_fmin(a21,a81);
  a21=(a04<a21);
  a81=3005.;
  a81=(a21?a81:0);
  a21=(!a21);
  a21=(a21?a37:0);
  a81=(a81+a21);
  a59=casadi_fmin(a59,a81);
  a81=(a00<a52);
  a21=arg[2]? arg[2][42] : 0;
  a81=(a81?a21:0);
  a81=(a81-a64);
  a81=casadi_fmax(a04,a81);
  a64=arg[0]? arg[0][32] : 0;
  a21=(a00<a52);
  a65=arg[2]? arg[2][40] : 0;
  a65=(a21?a65:0);
  a21=(!a21);
  a21=(a21?a23:0);
  a65=(a65+a21);
  a21=(a23-a65);
  a86=(a64<a21);
  a88=(a86?a02:0);
  a86=(!a86);
  a64=(-a64);
  a64=(a21<a64);
  a28=(a64?a28:0);
  a64=(!a64);
  a50=arg[2]? arg[2][41] : 0;
  a64=(a64?a50:0);
  a28=(a28+a64);
  a86=(a86?a28:0);
  a88=(a88+a86);
  a50=(a88==a50);
  a50=(!a50);
  a50=(a50?a02:0);
  a81=(a81+a50);
  a63=(a63+a81);
  a63=(a04<a63);
  a50=6005.;
  a50=(a63?a50:0);
  a63=(!a63);
  a63=(a63?a37:0);
  a50=(a50+a63);
  a59=casadi_fmin(a59,a50);
  a50=(a30<a59);
  a50=(!a50);
  a50=(a50?a59:0);
  a05=(a05?a50:0);
  a27=(a27+a05);
  a05=(a00<a27);
  a27=(a05?a27:0);
  a05=(!a05);
  a50=arg[0]? arg[0][14] : 0;
  a84=(a50*a84);
  a59=casadi_fabs(a07);
  a50=casadi_fmax(a50,a59);
  a84=(a84/a50);
  a50=arg[1]? arg[1][2] : 0;
  a59=arg[1]? arg[1][1] : 0;
  a63=(a07*a59);
  a63=(a50+a63);
  a63=casadi_fmin(a02,a63);
  a63=casadi_fmax(a04,a63);
  a63=(a84*a63);
  a63=(-a63);
  a59=(a07*a59);
  a50=(a50-a59);
  a50=casadi_fmin(a02,a50);
  a50=casadi_fmax(a04,a50);
  a84=(a84*a50);
  a50=arg[0]? arg[0][38] : 0;
  a50=(a04<a50);
  a59=(a00<a52);
  a86=arg[2]? arg[2][20] : 0;
  a86=(a59?a86:0);
  a59=(!a59);
  a28=arg[0]? arg[0][11] : 0;
  a59=(a59?a28:0);
  a86=(a86+a59);
  a59=arg[2]? arg[2][21] : 0;
  a59=(a28!=a59);
  a64=arg[1]? arg[1][0] : 0;
  a90=(a28-a86);
  a91=casadi_fabs(a90);
  a64=(a64*a91);
  a91=9.9999999999999995e-07;
  a92=casadi_fabs(a28);
  a92=(a91*a92);
  a93=casadi_fabs(a86);
  a91=(a91*a93);
  a92=(a92+a91);
  a64=casadi_fmax(a64,a92);
  a64=(a59?a64:0);
  a59=(!a59);
  a92=arg[2]? arg[2][22] : 0;
  a59=(a59?a92:0);
  a64=(a64+a59);
  a59=(a64<a90);
  a92=(a86+a64);
  a92=(a59?a92:0);
  a59=(!a59);
  a91=(-a64);
  a91=(a90<a91);
  a93=(a86-a64);
  a93=(a91?a93:0);
  a91=(!a91);
  a91=(a91?a28:0);
  a93=(a93+a91);
  a59=(a59?a93:0);
  a92=(a92+a59);
  a59=(a86-a92);
  a59=(a20*a59);
  a50=(a50?a59:0);
  a59=(a00<a52);
  a93=arg[2]? arg[2][51] : 0;
  a59=(a59?a93:0);
  a50=(a50+a59);
  a59=(a00<a52);
  a93=arg[2]? arg[2][49] : 0;
  a93=(a59?a93:0);
  a59=(!a59);
  a59=(a59?a07:0);
  a93=(a93+a59);
  a59=arg[1]? arg[1][10] : 0;
  a91=(-a59);
  a10=(a11?a10:0);
  a11=(!a11);
  a94=arg[2]? arg[2][4] : 0;
  a11=(a11?a94:0);
  a10=(a10+a11);
  a11=(a10-a93);
  a59=casadi_fmin(a59,a11);
  a91=casadi_fmax(a91,a59);
  a93=(a93+a91);
  a91=(a93-a07);
  a59=arg[0]? arg[0][37] : 0;
  a59=(a91*a59);
  a59=(a50+a59);
  a11=(a20*a92);
  a59=(a59+a11);
  a84=casadi_fmin(a84,a59);
  a63=casadi_fmax(a63,a84);
  a84=casadi_fabs(a63);
  a11=arg[1]? arg[1][16] : 0;
  a84=(a84<=a11);
  a11=(a84?a02:0);
  a11=(a11<a02);
  a94=7001.;
  a94=(a11?a94:0);
  a11=(!a11);
  a11=(a11?a37:0);
  a94=(a94+a11);
  a11=arg[0]? arg[0][18] : 0;
  a62=(a11*a62);
  a95=casadi_fabs(a14);
  a11=casadi_fmax(a11,a95);
  a62=(a62/a11);
  a11=arg[1]? arg[1][4] : 0;
  a95=arg[1]? arg[1][3] : 0;
  a96=(a14*a95);
  a96=(a11+a96);
  a96=casadi_fmin(a02,a96);
  a96=casadi_fmax(a04,a96);
  a96=(a62*a96);
  a96=(-a96);
  a95=(a14*a95);
  a11=(a11-a95);
  a11=casadi_fmin(a02,a11);
  a11=casadi_fmax(a04,a11);
  a62=(a62*a11);
  a11=arg[0]? arg[0][40] : 0;
  a11=(a04<a11);
  a86=(a86-a92);
  a86=(a23*a86);
  a86=(-a86);
  a11=(a11?a86:0);
  a86=(a00<a52);
  a95=arg[2]? arg[2][52] : 0;
  a86=(a86?a95:0);
  a11=(a11+a86);
  a52=(a00<a52);
  a86=arg[2]? arg[2][50] : 0;
  a86=(a52?a86:0);
  a52=(!a52);
  a52=(a52?a14:0);
  a86=(a86+a52);
  a52=arg[1]? arg[1][11] : 0;
  a95=(-a52);
  a17=(a18?a17:0);
  a18=(!a18);
  a97=arg[2]? arg[2][6] : 0;
  a18=(a18?a97:0);
  a17=(a17+a18);
  a18=(a17-a86);
  a52=casadi_fmin(a52,a18);
  a95=casadi_fmax(a95,a52);
  a86=(a86+a95);
  a95=(a86-a14);
  a52=arg[0]? arg[0][39] : 0;
  a52=(a95*a52);
  a52=(a11+a52);
  a18=(a23*a92);
  a52=(a52-a18);
  a62=casadi_fmin(a62,a52);
  a96=casadi_fmax(a96,a62);
  a62=casadi_fabs(a96);
  a18=arg[1]? arg[1][17] : 0;
  a62=(a62<=a18);
  a18=(a62?a02:0);
  a18=(a18<a02);
  a97=7002.;
  a97=(a18?a97:0);
  a18=(!a18);
  a18=(a18?a37:0);
  a97=(a97+a18);
  a94=casadi_fmin(a94,a97);
  a30=(a30<a94);
  a30=(!a30);
  a30=(a30?a94:0);
  a05=(a05?a30:0);
  a27=(a27+a05);
  if (res[0]!=0) res[0][0]=a27;
  a05=(a00<a27);
  a30=arg[1]? arg[1][18] : 0;
  a94=(-a30);
  a94=(a05?a94:0);
  a05=(!a05);
  a05=(a05?a30:0);
  a94=(a94+a05);
  a03=(a03+a94);
  a03=casadi_fmax(a04,a03);
  a03=casadi_fmin(a02,a03);
  if (res[0]!=0) res[0][1]=a03;
  a94=(a00<a27);
  a94=(!a94);
  a94=(a94?a02:0);
  if (res[0]!=0) res[0][2]=a94;
  if (res[0]!=0) res[0][3]=a26;
  if (res[0]!=0) res[0][4]=a10;
  a31=casadi_fmin(a31,a35);
  a31=(a31-a33);
  a31=casadi_fmax(a04,a31);
  a31=(a12?a31:0);
  a12=(!a12);
  a12=(a12?a41:0);
  a31=(a31+a12);
  if (res[0]!=0) res[0][5]=a31;
  if (res[0]!=0) res[0][6]=a17;
  a44=casadi_fmin(a44,a35);
  a44=(a44-a33);
  a44=casadi_fmax(a04,a44);
  a44=(a19?a44:0);
  a19=(!a19);
  a19=(a19?a47:0);
  a44=(a44+a19);
  if (res[0]!=0) res[0][7]=a44;
  if (res[0]!=0) res[0][8]=a07;
  a32=casadi_fmin(a32,a35);
  a32=(a32-a33);
  a32=casadi_fmax(a04,a32);
  a32=(a08?a32:0);
  a08=(!a08);
  a08=(a08?a34:0);
  a32=(a32+a08);
  if (res[0]!=0) res[0][9]=a32;
  if (res[0]!=0) res[0][10]=a20;
  a46=casadi_fmin(a46,a35);
  a46=(a46-a33);
  a46=casadi_fmax(a04,a46);
  a46=(a22?a46:0);
  a22=(!a22);
  a22=(a22?a49:0);
  a46=(a46+a22);
  if (res[0]!=0) res[0][11]=a46;
  if (res[0]!=0) res[0][12]=a23;
  a48=casadi_fmin(a48,a35);
  a48=(a48-a33);
  a48=casadi_fmax(a04,a48);
  a48=(a25?a48:0);
  a25=(!a25);
  a25=(a25?a51:0);
  a48=(a48+a25);
  if (res[0]!=0) res[0][13]=a48;
  if (res[0]!=0) res[0][14]=a14;
  a40=casadi_fmin(a40,a35);
  a40=(a40-a33);
  a40=casadi_fmax(a04,a40);
  a40=(a15?a40:0);
  a15=(!a15);
  a15=(a15?a43:0);
  a40=(a40+a15);
  if (res[0]!=0) res[0][15]=a40;
  a38=casadi_fmin(a38,a35);
  a38=(a38-a33);
  a38=casadi_fmax(a04,a38);
  a38=(a09?a38:0);
  a09=(!a09);
  a09=(a09?a39:0);
  a38=(a38+a09);
  if (res[0]!=0) res[0][16]=a38;
  a42=casadi_fmin(a42,a35);
  a42=(a42-a33);
  a42=casadi_fmax(a04,a42);
  a42=(a16?a42:0);
  a16=(!a16);
  a16=(a16?a45:0);
  a42=(a42+a16);
  if (res[0]!=0) res[0][17]=a42;
  if (res[0]!=0) res[0][18]=a29;
  a01=(a00<a01);
  a06=(a06?a13:0);
  a01=(a01?a06:0);
  if (res[0]!=0) res[0][19]=a01;
  if (res[0]!=0) res[0][20]=a92;
  if (res[0]!=0) res[0][21]=a28;
  a90=casadi_fabs(a90);
  a90=(a64<a90);
  a90=(a90?a64:0);
  if (res[0]!=0) res[0][22]=a90;
  if (res[0]!=0) res[0][23]=a36;
  a57=casadi_fmin(a57,a35);
  a57=(a57-a33);
  a57=casadi_fmax(a04,a57);
  a57=(a55?a57:0);
  a55=(!a55);
  a55=(a55?a58:0);
  a57=(a57+a55);
  if (res[0]!=0) res[0][24]=a57;
  if (res[0]!=0) res[0][25]=a07;
  if (res[0]!=0) res[0][26]=a61;
  if (res[0]!=0) res[0][27]=a20;
  if (res[0]!=0) res[0][28]=a56;
  if (res[0]!=0) res[0][29]=a85;
  if (res[0]!=0) res[0][30]=a69;
  a73=casadi_fmin(a73,a35);
  a73=(a73-a33);
  a04=casadi_fmax(a04,a73);
  a04=(a72?a04:0);
  a72=(!a72);
  a72=(a72?a74:0);
  a04=(a04+a72);
  if (res[0]!=0) res[0][31]=a04;
  if (res[0]!=0) res[0][32]=a14;
  if (res[0]!=0) res[0][33]=a76;
  if (res[0]!=0) res[0][34]=a23;
  if (res[0]!=0) res[0][35]=a75;
  if (res[0]!=0) res[0][36]=a89;
  a89=arg[1]? arg[1][9] : 0;
  a54=(a54*a89);
  a24=(a24+a54);
  if (res[0]!=0) res[0][37]=a24;
  if (res[0]!=0) res[0][38]=a87;
  if (res[0]!=0) res[0][39]=a83;
  a21=(a21*a89);
  a65=(a65+a21);
  if (res[0]!=0) res[0][40]=a65;
  if (res[0]!=0) res[0][41]=a88;
  if (res[0]!=0) res[0][42]=a81;
  a66=(a66?a67:0);
  a68=(a68*a89);
  a66=(a66+a68);
  if (res[0]!=0) res[0][43]=a66;
  if (res[0]!=0) res[0][44]=a70;
  if (res[0]!=0) res[0][45]=a60;
  a78=(a78?a79:0);
  a80=(a80*a89);
  a78=(a78+a80);
  if (res[0]!=0) res[0][46]=a78;
  if (res[0]!=0) res[0][47]=a82;
  if (res[0]!=0) res[0][48]=a77;
  if (res[0]!=0) res[0][49]=a93;
  if (res[0]!=0) res[0][50]=a86;
  a59=(a63-a59);
  a86=arg[1]? arg[1][13] : 0;
  a59=(a59*a86);
  a50=(a50+a59);
  a59=arg[1]? arg[1][12] : 0;
  a91=(a91*a59);
  a50=(a50+a91);
  if (res[0]!=0) res[0][51]=a50;
  a52=(a96-a52);
  a50=arg[1]? arg[1][15] : 0;
  a52=(a52*a50);
  a11=(a11+a52);
  a52=arg[1]? arg[1][14] : 0;
  a95=(a95*a52);
  a11=(a11+a95);
  if (res[0]!=0) res[0][52]=a11;
  a11=(a00<a27);
  a95=(a11?a53:0);
  a11=(!a11);
  a63=(a84?a63:0);
  a84=(!a84);
  a84=(a84?a53:0);
  a63=(a63+a84);
  a11=(a11?a63:0);
  a95=(a95+a11);
  if (res[0]!=0) res[0][53]=a95;
  a00=(a00<a27);
  a27=(a00?a71:0);
  a00=(!a00);
  a96=(a62?a96:0);
  a62=(!a62);
  a62=(a62?a71:0);
  a96=(a96+a62);
  a00=(a00?a96:0);
  a27=(a27+a00);
  if (res[0]!=0) res[0][54]=a27;
  a00=-480.;
  a96=480.;
  a95=(a95*a03);
  a95=casadi_fmin(a96,a95);
  a95=casadi_fmax(a00,a95);
  if (res[1]!=0) res[1][0]=a95;
  a27=(a27*a03);
  a96=casadi_fmin(a96,a27);
  a00=casadi_fmax(a00,a96);
  if (res[1]!=0) res[1][1]=a00;
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


