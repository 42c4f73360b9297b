/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) shift_rig_one_clutch_controller_casadi_ ## ID
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
CASADI_SYMBOL_EXPORT void shift_rig_one_clutch_controller_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int shift_rig_one_clutch_controller_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int shift_rig_one_clutch_controller_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {59, 1, 1};
static const casadi_int casadi_s1[3] = {30, 1, 1};
static const casadi_int casadi_s2[3] = {74, 1, 1};
static const casadi_int casadi_s3[3] = {8, 1, 1};
static const casadi_int casadi_s4[3] = {2, 1, 1};

static const casadi_real casadi_zeros[59] = 
  {0.};

/* controller_prepare:(parameters[59])->(derived[30]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real w1, w2, w3, w4, w5, w6;
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
  /* #7: @1 = @0[14] */
  w1 = wr0[14];
  /* #8: @1 = (@2/@1) */
  w1  = (w2/w1);
  /* #9: output[0][1] = @1 */
  if (res[0]) res[0][1] = w1;
  /* #10: @1 = @0[18] */
  w1 = wr0[18];
  /* #11: @3 = (1./@1) */
  w3 = (1./ w1 );
  /* #12: output[0][2] = @3 */
  if (res[0]) res[0][2] = w3;
  /* #13: @3 = 1 */
  w3 = 1.;
  /* #14: @4 = @0[17] */
  w4 = wr0[17];
  /* #15: @4 = (@4/@1) */
  w4 /= w1;
  /* #16: @3 = (@3+@4) */
  w3 += w4;
  /* #17: output[0][3] = @3 */
  if (res[0]) res[0][3] = w3;
  /* #18: @3 = @0[16] */
  w3 = wr0[16];
  /* #19: @4 = @0[19] */
  w4 = wr0[19];
  /* #20: @3 = (@3*@4) */
  w3 *= w4;
  /* #21: output[0][4] = @3 */
  if (res[0]) res[0][4] = w3;
  /* #22: @3 = @0[22] */
  w3 = wr0[22];
  /* #23: @1 = (1./@3) */
  w1 = (1./ w3 );
  /* #24: output[0][5] = @1 */
  if (res[0]) res[0][5] = w1;
  /* #25: @1 = 1 */
  w1 = 1.;
  /* #26: @5 = @0[21] */
  w5 = wr0[21];
  /* #27: @5 = (@5/@3) */
  w5 /= w3;
  /* #28: @1 = (@1+@5) */
  w1 += w5;
  /* #29: output[0][6] = @1 */
  if (res[0]) res[0][6] = w1;
  /* #30: @1 = @0[20] */
  w1 = wr0[20];
  /* #31: @5 = @0[23] */
  w5 = wr0[23];
  /* #32: @1 = (@1*@5) */
  w1 *= w5;
  /* #33: output[0][7] = @1 */
  if (res[0]) res[0][7] = w1;
  /* #34: @1 = @0[28] */
  w1 = wr0[28];
  /* #35: @1 = (@1+@2) */
  w1 += w2;
  /* #36: @1 = (@2/@1) */
  w1  = (w2/w1);
  /* #37: output[0][8] = @1 */
  if (res[0]) res[0][8] = w1;
  /* #38: @1 = @0[31] */
  w1 = wr0[31];
  /* #39: @1 = (@1*@2) */
  w1 *= w2;
  /* #40: output[0][9] = @1 */
  if (res[0]) res[0][9] = w1;
  /* #41: @1 = (1./@2) */
  w1 = (1./ w2 );
  /* #42: output[0][10] = @1 */
  if (res[0]) res[0][10] = w1;
  /* #43: @1 = @0[32] */
  w1 = wr0[32];
  /* #44: @1 = (@1*@2) */
  w1 *= w2;
  /* #45: output[0][11] = @1 */
  if (res[0]) res[0][11] = w1;
  /* #46: @1 = @0[33] */
  w1 = wr0[33];
  /* #47: @1 = (@2/@1) */
  w1  = (w2/w1);
  /* #48: output[0][12] = @1 */
  if (res[0]) res[0][12] = w1;
  /* #49: @1 = 0.05 */
  w1 = 5.0000000000000003e-02;
  /* #50: @1 = (@1*@4) */
  w1 *= w4;
  /* #51: output[0][13] = @1 */
  if (res[0]) res[0][13] = w1;
  /* #52: @1 = @0[37] */
  w1 = wr0[37];
  /* #53: @3 = (@2/@1) */
  w3  = (w2/w1);
  /* #54: output[0][14] = @3 */
  if (res[0]) res[0][14] = w3;
  /* #55: @3 = 0.05 */
  w3 = 5.0000000000000003e-02;
  /* #56: @3 = (@3*@5) */
  w3 *= w5;
  /* #57: output[0][15] = @3 */
  if (res[0]) res[0][15] = w3;
  /* #58: @3 = @0[40] */
  w3 = wr0[40];
  /* #59: @6 = (@3*@2) */
  w6  = (w3*w2);
  /* #60: output[0][16] = @6 */
  if (res[0]) res[0][16] = w6;
  /* #61: @6 = 6.2832 */
  w6 = 6.2831999999999999e+00;
  /* #62: @6 = (@6*@3) */
  w6 *= w3;
  /* #63: @6 = (@6*@2) */
  w6 *= w2;
  /* #64: output[0][17] = @6 */
  if (res[0]) res[0][17] = w6;
  /* #65: @6 = @0[45] */
  w6 = wr0[45];
  /* #66: @6 = (@6*@2) */
  w6 *= w2;
  /* #67: output[0][18] = @6 */
  if (res[0]) res[0][18] = w6;
  /* #68: @6 = @0[46] */
  w6 = wr0[46];
  /* #69: @6 = (@6*@2) */
  w6 *= w2;
  /* #70: output[0][19] = @6 */
  if (res[0]) res[0][19] = w6;
  /* #71: @6 = @0[48] */
  w6 = wr0[48];
  /* #72: @3 = (@6*@2) */
  w3  = (w6*w2);
  /* #73: output[0][20] = @3 */
  if (res[0]) res[0][20] = w3;
  /* #74: @6 = (@6*@2) */
  w6 *= w2;
  /* #75: @3 = @0[47] */
  w3 = wr0[47];
  /* #76: @6 = (@6/@3) */
  w6 /= w3;
  /* #77: output[0][21] = @6 */
  if (res[0]) res[0][21] = w6;
  /* #78: @6 = @0[49] */
  w6 = wr0[49];
  /* #79: @6 = (@6/@1) */
  w6 /= w1;
  /* #80: output[0][22] = @6 */
  if (res[0]) res[0][22] = w6;
  /* #81: @6 = @0[53] */
  w6 = wr0[53];
  /* #82: @6 = (@6*@2) */
  w6 *= w2;
  /* #83: @1 = @0[50] */
  w1 = wr0[50];
  /* #84: @6 = (@6/@1) */
  w6 /= w1;
  /* #85: output[0][23] = @6 */
  if (res[0]) res[0][23] = w6;
  /* #86: @6 = @0[54] */
  w6 = wr0[54];
  /* #87: @6 = (@6*@2) */
  w6 *= w2;
  /* #88: @6 = (@6/@1) */
  w6 /= w1;
  /* #89: output[0][24] = @6 */
  if (res[0]) res[0][24] = w6;
  /* #90: @6 = @0[56] */
  w6 = wr0[56];
  /* #91: @6 = (@6*@2) */
  w6 *= w2;
  /* #92: output[0][25] = @6 */
  if (res[0]) res[0][25] = w6;
  /* #93: @6 = 1.01 */
  w6 = 1.0100000000000000e+00;
  /* #94: @1 = 900 */
  w1 = 900.;
  /* #95: @1 = fmin(@1,@4) */
  w1  = casadi_fmin(w1,w4);
  /* #96: @6 = (@6*@1) */
  w6 *= w1;
  /* #97: output[0][26] = @6 */
  if (res[0]) res[0][26] = w6;
  /* #98: @6 = 1.01 */
  w6 = 1.0100000000000000e+00;
  /* #99: @1 = 3300 */
  w1 = 3300.;
  /* #100: @1 = fmin(@1,@5) */
  w1  = casadi_fmin(w1,w5);
  /* #101: @6 = (@6*@1) */
  w6 *= w1;
  /* #102: output[0][27] = @6 */
  if (res[0]) res[0][27] = w6;
  /* #103: @6 = @0[1] */
  w6 = wr0[1];
  /* #104: @6 = (@2/@6) */
  w6  = (w2/w6);
  /* #105: output[0][28] = @6 */
  if (res[0]) res[0][28] = w6;
  /* #106: @6 = 0.02 */
  w6 = 2.0000000000000000e-02;
  /* #107: @6 = (@6+@2) */
  w6 += w2;
  /* #108: @2 = (@2/@6) */
  w2 /= w6;
  /* #109: output[0][29] = @2 */
  if (res[0]) res[0][29] = w2;
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

/* controller_step:(parameters[59],derived[30],states[74],inputs[8])->(next_states[74],outputs[2]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
  casadi_real a84, a85, a86, a87, a88, a89, a90, a91, a92, a93, a94, a95;
  casadi_real a96, a97, a98, a99;
  a00=5.0000000000000000e-01;
  a01=arg[2]? arg[2][0] : 0;
  a02=1.;
  a03=arg[2]? arg[2][1] : 0;
  a04=0.;
  a05=(a03<=a04);
  a06=(a00<a01);
  a07=arg[3]? arg[3][3] : 0;
  a08=casadi_fabs(a07);
  a09=arg[0]? arg[0][6] : 0;
  a08=(a08<=a09);
  a10=(a08?a07:0);
  a11=(!a08);
  a12=arg[2]? arg[2][10] : 0;
  a11=(a11?a12:0);
  a10=(a10+a11);
  a11=casadi_fabs(a10);
  a12=arg[0]? arg[0][10] : 0;
  a11=(a11<=a12);
  a07=casadi_fabs(a07);
  a07=(a07<=a09);
  a11=(a11&&a07);
  a07=arg[3]? arg[3][6] : 0;
  a09=casadi_fabs(a07);
  a13=arg[0]? arg[0][9] : 0;
  a09=(a09<=a13);
  a14=(a09?a07:0);
  a15=(!a09);
  a16=arg[2]? arg[2][16] : 0;
  a15=(a15?a16:0);
  a14=(a14+a15);
  a15=casadi_fabs(a14);
  a16=arg[0]? arg[0][11] : 0;
  a15=(a15<=a16);
  a11=(a11&&a15);
  a07=casadi_fabs(a07);
  a07=(a07<=a13);
  a11=(a11&&a07);
  a07=arg[3]? arg[3][1] : 0;
  a13=casadi_fabs(a07);
  a15=arg[0]? arg[0][4] : 0;
  a13=(a13<=a15);
  a11=(a11&&a13);
  a13=arg[3]? arg[3][4] : 0;
  a17=casadi_fabs(a13);
  a18=arg[0]? arg[0][7] : 0;
  a17=(a17<=a18);
  a11=(a11&&a17);
  a17=arg[3]? arg[3][0] : 0;
  a19=casadi_fabs(a17);
  a20=arg[0]? arg[0][3] : 0;
  a19=(a19<=a20);
  a11=(a11&&a19);
  a19=arg[3]? arg[3][5] : 0;
  a21=casadi_fabs(a19);
  a22=arg[0]? arg[0][8] : 0;
  a21=(a21<=a22);
  a11=(a11&&a21);
  a21=arg[3]? arg[3][2] : 0;
  a23=casadi_fabs(a21);
  a24=arg[0]? arg[0][5] : 0;
  a23=(a23<=a24);
  a11=(a11&&a23);
  a23=arg[2]? arg[2][3] : 0;
  a25=(a02-a23);
  a26=arg[2]? arg[2][21] : 0;
  a27=-1.;
  a28=arg[3]? arg[3][7] : 0;
  a28=(a27+a28);
  a28=casadi_fabs(a28);
  a28=(a28<=a00);
  a28=(a28?a02:0);
  a29=arg[2]? arg[2][20] : 0;
  a29=(a28-a29);
  a26=casadi_fmax(a26,a29);
  a25=(a25*a26);
  a26=(-a25);
  a26=(a11?a26:0);
  a26=(a06?a26:0);
  a05=(a05?a26:0);
  a05=(a02+a05);
  a01=(a01*a05);
  a05=(a00<a01);
  a26=(a05?a01:0);
  a05=(!a05);
  a29=casadi_fabs(a17);
  a29=(a29<=a20);
  a20=(a29?a02:0);
  a20=(a00<a20);
  a30=arg[2]? arg[2][5] : 0;
  a31=arg[0]? arg[0][2] : 0;
  a30=casadi_fmin(a30,a31);
  a32=arg[0]? arg[0][0] : 0;
  a33=casadi_fmax(a30,a32);
  a33=(a33-a32);
  a33=(a20?a33:0);
  a20=(!a20);
  a30=(a30+a32);
  a20=(a20?a30:0);
  a33=(a33+a20);
  a20=arg[1]? arg[1][0] : 0;
  a30=(a33<=a20);
  a34=casadi_fabs(a07);
  a34=(a34<=a15);
  a15=(a34?a02:0);
  a15=(a00<a15);
  a35=arg[2]? arg[2][7] : 0;
  a35=casadi_fmin(a35,a31);
  a36=casadi_fmax(a35,a32);
  a36=(a36-a32);
  a36=(a15?a36:0);
  a15=(!a15);
  a35=(a35+a32);
  a15=(a15?a35:0);
  a36=(a36+a15);
  a15=(a36<=a20);
  a35=casadi_fabs(a21);
  a35=(a35<=a24);
  a24=(a35?a02:0);
  a24=(a00<a24);
  a37=arg[2]? arg[2][9] : 0;
  a37=casadi_fmin(a37,a31);
  a38=casadi_fmax(a37,a32);
  a38=(a38-a32);
  a38=(a24?a38:0);
  a24=(!a24);
  a37=(a37+a32);
  a24=(a24?a37:0);
  a38=(a38+a24);
  a24=(a38<=a20);
  a08=(a08?a02:0);
  a08=(a00<a08);
  a37=arg[2]? arg[2][11] : 0;
  a37=casadi_fmin(a37,a31);
  a39=casadi_fmax(a37,a32);
  a39=(a39-a32);
  a39=(a08?a39:0);
  a08=(!a08);
  a37=(a37+a32);
  a08=(a08?a37:0);
  a39=(a39+a08);
  a08=(a39<=a20);
  a37=casadi_fabs(a13);
  a37=(a37<=a18);
  a18=(a37?a02:0);
  a18=(a00<a18);
  a40=arg[2]? arg[2][13] : 0;
  a40=casadi_fmin(a40,a31);
  a41=casadi_fmax(a40,a32);
  a41=(a41-a32);
  a41=(a18?a41:0);
  a18=(!a18);
  a40=(a40+a32);
  a18=(a18?a40:0);
  a41=(a41+a18);
  a18=(a41<=a20);
  a40=casadi_fabs(a19);
  a40=(a40<=a22);
  a22=(a40?a02:0);
  a22=(a00<a22);
  a42=arg[2]? arg[2][15] : 0;
  a42=casadi_fmin(a42,a31);
  a43=casadi_fmax(a42,a32);
  a43=(a43-a32);
  a43=(a22?a43:0);
  a22=(!a22);
  a42=(a42+a32);
  a22=(a22?a42:0);
  a43=(a43+a22);
  a22=(a43<=a20);
  a09=(a09?a02:0);
  a09=(a00<a09);
  a42=arg[2]? arg[2][17] : 0;
  a42=casadi_fmin(a42,a31);
  a44=casadi_fmax(a42,a32);
  a44=(a44-a32);
  a44=(a09?a44:0);
  a09=(!a09);
  a42=(a42+a32);
  a09=(a09?a42:0);
  a44=(a44+a09);
  a09=(a44<=a20);
  a42=casadi_fabs(a10);
  a42=(a42<=a12);
  a42=(a42?a02:0);
  a42=(a00<a42);
  a12=arg[2]? arg[2][18] : 0;
  a12=casadi_fmin(a12,a31);
  a45=casadi_fmax(a12,a32);
  a45=(a45-a32);
  a45=(a42?a45:0);
  a42=(!a42);
  a12=(a12+a32);
  a42=(a42?a12:0);
  a45=(a45+a42);
  a42=(a45<=a20);
  a12=casadi_fabs(a14);
  a12=(a12<=a16);
  a12=(a12?a02:0);
  a12=(a00<a12);
  a16=arg[2]? arg[2][19] : 0;
  a16=casadi_fmin(a16,a31);
  a46=casadi_fmax(a16,a32);
  a46=(a46-a32);
  a46=(a12?a46:0);
  a12=(!a12);
  a16=(a16+a32);
  a12=(a12?a16:0);
  a46=(a46+a12);
  a12=(a46<=a20);
  a12=(!a12);
  a16=4007.;
  a12=(a12?a16:0);
  a12=(a42?a12:0);
  a42=(!a42);
  a16=4004.;
  a42=(a42?a16:0);
  a12=(a12+a42);
  a12=(a09?a12:0);
  a09=(!a09);
  a42=7.;
  a09=(a09?a42:0);
  a12=(a12+a09);
  a12=(a22?a12:0);
  a22=(!a22);
  a09=6.;
  a22=(a22?a09:0);
  a12=(a12+a22);
  a12=(a18?a12:0);
  a18=(!a18);
  a22=5.;
  a18=(a18?a22:0);
  a12=(a12+a18);
  a12=(a08?a12:0);
  a08=(!a08);
  a18=4.;
  a08=(a08?a18:0);
  a12=(a12+a08);
  a12=(a24?a12:0);
  a24=(!a24);
  a08=3.;
  a24=(a24?a08:0);
  a12=(a12+a24);
  a12=(a15?a12:0);
  a15=(!a15);
  a24=2.;
  a15=(a15?a24:0);
  a12=(a12+a15);
  a12=(a30?a12:0);
  a30=(!a30);
  a30=(a30?a02:0);
  a12=(a12+a30);
  a05=(a05?a12:0);
  a26=(a26+a05);
  a05=(a00<a26);
  a26=(a05?a26:0);
  a05=(!a05);
  a12=arg[2]? arg[2][2] : 0;
  a30=(a12<=a00);
  a15=(a30?a10:0);
  a30=(!a30);
  a24=arg[2]? arg[2][38] : 0;
  a30=(a30?a24:0);
  a15=(a15+a30);
  a30=arg[1]? arg[1][12] : 0;
  a24=arg[2]? arg[2][70] : 0;
  a18=(a24*a03);
  a13=(a37?a13:0);
  a37=(!a37);
  a22=arg[2]? arg[2][12] : 0;
  a37=(a37?a22:0);
  a13=(a13+a37);
  a37=(a18-a13);
  a30=(a30*a37);
  a30=(a15+a30);
  a37=arg[1]? arg[1][11] : 0;
  a15=(a10-a15);
  a15=(a37*a15);
  a30=(a30+a15);
  a15=(a30-a10);
  a15=casadi_fabs(a15);
  a22=arg[0]? arg[0][35] : 0;
  a09=(a15<=a22);
  a42=arg[2]? arg[2][40] : 0;
  a42=(a10==a42);
  a16=(a12<=a00);
  a16=(!a16);
  a47=arg[2]? arg[2][41] : 0;
  a16=(a16?a47:0);
  a16=(a16+a32);
  a42=(a42?a16:0);
  a16=arg[0]? arg[0][36] : 0;
  a47=(a42<=a16);
  a09=(a09||a47);
  a22=(a15<=a22);
  a47=arg[2]? arg[2][42] : 0;
  a47=(a13==a47);
  a48=(a12<=a00);
  a48=(!a48);
  a49=arg[2]? arg[2][43] : 0;
  a48=(a48?a49:0);
  a48=(a48+a32);
  a47=(a47?a48:0);
  a48=(a47<=a16);
  a22=(a22||a48);
  a48=(a04<a47);
  a49=arg[2]? arg[2][44] : 0;
  a49=(a48?a49:0);
  a48=(!a48);
  a48=(a48?a18:0);
  a49=(a49+a48);
  a48=(a18-a49);
  a48=casadi_fabs(a48);
  a50=arg[1]? arg[1][13] : 0;
  a48=(a48<=a50);
  a22=(a22||a48);
  a48=(a12<=a00);
  a50=(a48?a14:0);
  a48=(!a48);
  a51=arg[2]? arg[2][45] : 0;
  a48=(a48?a51:0);
  a50=(a50+a48);
  a48=arg[1]? arg[1][14] : 0;
  a51=arg[2]? arg[2][71] : 0;
  a52=(a51*a03);
  a19=(a40?a19:0);
  a40=(!a40);
  a53=arg[2]? arg[2][14] : 0;
  a40=(a40?a53:0);
  a19=(a19+a40);
  a40=(a52+a19);
  a48=(a48*a40);
  a48=(a50+a48);
  a50=(a14-a50);
  a37=(a37*a50);
  a48=(a48+a37);
  a37=(a48-a14);
  a37=casadi_fabs(a37);
  a50=arg[0]? arg[0][39] : 0;
  a40=(a37<=a50);
  a53=arg[2]? arg[2][49] : 0;
  a53=(a19==a53);
  a54=(a12<=a00);
  a54=(!a54);
  a55=arg[2]? arg[2][50] : 0;
  a54=(a54?a55:0);
  a54=(a54+a32);
  a53=(a53?a54:0);
  a54=(a53<=a16);
  a40=(a40||a54);
  a54=(a04<a53);
  a55=arg[2]? arg[2][51] : 0;
  a55=(a54?a55:0);
  a54=(!a54);
  a54=(a54?a52:0);
  a55=(a55+a54);
  a54=(a52-a55);
  a54=casadi_fabs(a54);
  a56=arg[1]? arg[1][15] : 0;
  a54=(a54<=a56);
  a40=(a40||a54);
  a50=(a37<=a50);
  a54=arg[2]? arg[2][47] : 0;
  a54=(a14==a54);
  a56=(a12<=a00);
  a56=(!a56);
  a57=arg[2]? arg[2][48] : 0;
  a56=(a56?a57:0);
  a56=(a56+a32);
  a54=(a54?a56:0);
  a16=(a54<=a16);
  a50=(a50||a16);
  a16=arg[0]? arg[0][34] : 0;
  a15=(a15<=a16);
  a15=(a15?a02:0);
  a15=(a00<a15);
  a16=arg[2]? arg[2][39] : 0;
  a16=casadi_fmin(a16,a31);
  a56=casadi_fmax(a16,a32);
  a56=(a56-a32);
  a56=(a15?a56:0);
  a15=(!a15);
  a16=(a16+a32);
  a15=(a15?a16:0);
  a56=(a56+a15);
  a15=(a56<=a20);
  a16=arg[0]? arg[0][38] : 0;
  a37=(a37<=a16);
  a37=(a37?a02:0);
  a37=(a00<a37);
  a16=arg[2]? arg[2][46] : 0;
  a16=casadi_fmin(a16,a31);
  a31=casadi_fmax(a16,a32);
  a31=(a31-a32);
  a31=(a37?a31:0);
  a37=(!a37);
  a16=(a16+a32);
  a37=(a37?a16:0);
  a31=(a31+a37);
  a20=(a31<=a20);
  a37=(a12<=a00);
  a37=(!a37);
  a16=arg[2]? arg[2][54] : 0;
  a37=(a37?a16:0);
  a16=arg[1]? arg[1][16] : 0;
  a37=(a37-a16);
  a37=casadi_fmax(a04,a37);
  a57=arg[0]? arg[0][41] : 0;
  a58=(a12<=a00);
  a59=(a58?a13:0);
  a58=(!a58);
  a60=arg[2]? arg[2][52] : 0;
  a58=(a58?a60:0);
  a59=(a59+a58);
  a58=(a13-a59);
  a60=(a57<a58);
  a61=(a60?a02:0);
  a60=(!a60);
  a57=(-a57);
  a57=(a58<a57);
  a62=(a57?a27:0);
  a57=(!a57);
  a63=arg[2]? arg[2][53] : 0;
  a57=(a57?a63:0);
  a62=(a62+a57);
  a60=(a60?a62:0);
  a61=(a61+a60);
  a63=(a61==a63);
  a63=(!a63);
  a63=(a63?a02:0);
  a37=(a37+a63);
  a63=5.5000000000000000e+00;
  a60=(a37<=a63);
  a62=(a12<=a00);
  a62=(!a62);
  a57=arg[2]? arg[2][57] : 0;
  a62=(a62?a57:0);
  a62=(a62-a16);
  a62=casadi_fmax(a04,a62);
  a57=arg[0]? arg[0][42] : 0;
  a64=(a12<=a00);
  a65=(a64?a19:0);
  a64=(!a64);
  a66=arg[2]? arg[2][55] : 0;
  a64=(a64?a66:0);
  a65=(a65+a64);
  a64=(a19-a65);
  a66=(a57<a64);
  a67=(a66?a02:0);
  a66=(!a66);
  a57=(-a57);
  a57=(a64<a57);
  a68=(a57?a27:0);
  a57=(!a57);
  a69=arg[2]? arg[2][56] : 0;
  a57=(a57?a69:0);
  a68=(a68+a57);
  a66=(a66?a68:0);
  a67=(a67+a66);
  a69=(a67==a69);
  a69=(!a69);
  a69=(a69?a02:0);
  a62=(a62+a69);
  a69=(a62<=a63);
  a66=(a12<=a00);
  a66=(!a66);
  a68=arg[2]? arg[2][60] : 0;
  a66=(a66?a68:0);
  a66=(a66-a16);
  a66=casadi_fmax(a04,a66);
  a68=arg[0]? arg[0][43] : 0;
  a57=(a12<=a00);
  a57=(!a57);
  a70=arg[2]? arg[2][58] : 0;
  a71=(-a70);
  a71=(a57?a71:0);
  a18=(a18+a71);
  a71=(a68<a18);
  a72=(a71?a02:0);
  a71=(!a71);
  a68=(-a68);
  a68=(a18<a68);
  a73=(a68?a27:0);
  a68=(!a68);
  a74=arg[2]? arg[2][59] : 0;
  a68=(a68?a74:0);
  a73=(a73+a68);
  a71=(a71?a73:0);
  a72=(a72+a71);
  a74=(a72==a74);
  a74=(!a74);
  a74=(a74?a02:0);
  a66=(a66+a74);
  a74=(a66<=a63);
  a71=(a12<=a00);
  a71=(!a71);
  a73=arg[2]? arg[2][63] : 0;
  a71=(a71?a73:0);
  a71=(a71-a16);
  a71=casadi_fmax(a04,a71);
  a16=arg[0]? arg[0][44] : 0;
  a73=(a12<=a00);
  a73=(!a73);
  a68=arg[2]? arg[2][61] : 0;
  a75=(-a68);
  a75=(a73?a75:0);
  a52=(a52+a75);
  a75=(a16<a52);
  a76=(a75?a02:0);
  a75=(!a75);
  a16=(-a16);
  a16=(a52<a16);
  a77=(a16?a27:0);
  a16=(!a16);
  a78=arg[2]? arg[2][62] : 0;
  a16=(a16?a78:0);
  a77=(a77+a16);
  a75=(a75?a77:0);
  a76=(a76+a75);
  a78=(a76==a78);
  a78=(!a78);
  a78=(a78?a02:0);
  a71=(a71+a78);
  a63=(a71<=a63);
  a63=(!a63);
  a78=8002.;
  a63=(a63?a78:0);
  a63=(a74?a63:0);
  a74=(!a74);
  a78=8001.;
  a74=(a74?a78:0);
  a63=(a63+a74);
  a63=(a69?a63:0);
  a69=(!a69);
  a74=6006.;
  a69=(a69?a74:0);
  a63=(a63+a69);
  a63=(a60?a63:0);
  a60=(!a60);
  a69=6005.;
  a60=(a60?a69:0);
  a63=(a63+a60);
  a63=(a20?a63:0);
  a20=(!a20);
  a60=5007.;
  a20=(a20?a60:0);
  a63=(a63+a20);
  a63=(a15?a63:0);
  a15=(!a15);
  a20=5004.;
  a15=(a15?a20:0);
  a63=(a63+a15);
  a63=(a50?a63:0);
  a50=(!a50);
  a15=3007.;
  a50=(a50?a15:0);
  a63=(a63+a50);
  a63=(a40?a63:0);
  a40=(!a40);
  a50=3006.;
  a40=(a40?a50:0);
  a63=(a63+a40);
  a63=(a22?a63:0);
  a22=(!a22);
  a40=3005.;
  a22=(a22?a40:0);
  a63=(a63+a22);
  a63=(a09?a63:0);
  a09=(!a09);
  a22=3004.;
  a09=(a09?a22:0);
  a63=(a63+a09);
  a05=(a05?a63:0);
  a26=(a26+a05);
  a05=(a00<a26);
  a26=(a05?a26:0);
  a05=(!a05);
  a63=arg[1]? arg[1][4] : 0;
  a09=arg[0]? arg[0][16] : 0;
  a22=casadi_fabs(a10);
  a09=casadi_fmax(a09,a22);
  a63=(a63/a09);
  a09=arg[1]? arg[1][3] : 0;
  a22=arg[1]? arg[1][2] : 0;
  a40=(a10*a22);
  a40=(a09+a40);
  a40=casadi_fmin(a02,a40);
  a40=casadi_fmax(a04,a40);
  a40=(a63*a40);
  a50=(-a40);
  a22=(a10*a22);
  a09=(a09-a22);
  a09=casadi_fmin(a02,a09);
  a09=casadi_fmax(a04,a09);
  a63=(a63*a09);
  a09=arg[0]? arg[0][15] : 0;
  a22=arg[2]? arg[2][29] : 0;
  a22=(a09!=a22);
  a15=arg[1]? arg[1][1] : 0;
  a20=(a12<=a00);
  a60=(a20?a09:0);
  a20=(!a20);
  a69=arg[2]? arg[2][28] : 0;
  a20=(a20?a69:0);
  a60=(a60+a20);
  a20=(a09-a60);
  a69=casadi_fabs(a20);
  a69=(a15*a69);
  a74=9.9999999999999995e-07;
  a78=casadi_fabs(a09);
  a78=(a74*a78);
  a75=casadi_fabs(a60);
  a75=(a74*a75);
  a78=(a78+a75);
  a69=casadi_fmax(a69,a78);
  a69=(a22?a69:0);
  a22=(!a22);
  a78=arg[2]? arg[2][30] : 0;
  a22=(a22?a78:0);
  a69=(a69+a22);
  a22=casadi_fabs(a20);
  a22=(a69<a22);
  a78=(-a69);
  a75=casadi_fmin(a20,a69);
  a78=casadi_fmax(a78,a75);
  a60=(a60+a78);
  a60=(a22?a60:0);
  a22=(!a22);
  a22=(a22?a09:0);
  a60=(a60+a22);
  a22=(a12<=a00);
  a78=arg[0]? arg[0][24] : 0;
  a21=(a35?a21:0);
  a35=(!a35);
  a75=arg[2]? arg[2][8] : 0;
  a35=(a35?a75:0);
  a21=(a21+a35);
  a35=arg[0]? arg[0][25] : 0;
  a75=casadi_fmin(a21,a35);
  a75=casadi_fmax(a78,a75);
  a77=arg[0]? arg[0][26] : 0;
  a16=arg[2]? arg[2][32] : 0;
  a16=(a77!=a16);
  a79=(a12<=a00);
  a80=(a79?a77:0);
  a79=(!a79);
  a81=arg[2]? arg[2][31] : 0;
  a79=(a79?a81:0);
  a80=(a80+a79);
  a79=(a77-a80);
  a81=casadi_fabs(a79);
  a81=(a15*a81);
  a82=casadi_fabs(a77);
  a82=(a74*a82);
  a83=casadi_fabs(a80);
  a83=(a74*a83);
  a82=(a82+a83);
  a81=casadi_fmax(a81,a82);
  a81=(a16?a81:0);
  a16=(!a16);
  a82=arg[2]? arg[2][33] : 0;
  a16=(a16?a82:0);
  a81=(a81+a16);
  a16=casadi_fabs(a79);
  a16=(a81<a16);
  a82=(-a81);
  a83=casadi_fmin(a79,a81);
  a82=casadi_fmax(a82,a83);
  a80=(a80+a82);
  a80=(a16?a80:0);
  a16=(!a16);
  a16=(a16?a77:0);
  a80=(a80+a16);
  a16=(a02-a80);
  a16=(a75*a16);
  a82=arg[0]? arg[0][30] : 0;
  a83=(a12<=a00);
  a84=arg[0]? arg[0][27] : 0;
  a85=casadi_fabs(a14);
  a85=(a84<=a85);
  a86=casadi_fabs(a14);
  a86=(a84<=a86);
  a87=(a86?a14:0);
  a86=(!a86);
  a86=(a86?a02:0);
  a87=(a87+a86);
  a87=(a10/a87);
  a35=casadi_fmin(a35,a87);
  a78=casadi_fmax(a78,a35);
  a35=(a85?a78:0);
  a85=(!a85);
  a85=(a85?a75:0);
  a35=(a35+a85);
  a35=(a83?a35:0);
  a83=(!a83);
  a85=arg[2]? arg[2][34] : 0;
  a83=(a83?a85:0);
  a35=(a35+a83);
  a83=casadi_fabs(a14);
  a83=(a84<=a83);
  a85=arg[1]? arg[1][8] : 0;
  a78=(a78-a35);
  a85=(a85*a78);
  a83=(a83?a85:0);
  a35=(a35+a83);
  a83=4.4182769726247990e+00;
  a83=(a35<=a83);
  a85=3.3333333333333335e+00;
  a85=(a83?a85:0);
  a83=(!a83);
  a78=5.5032206119162641e+00;
  a83=(a83?a78:0);
  a85=(a85+a83);
  a83=(a35-a85);
  a83=casadi_fabs(a83);
  a78=arg[0]? arg[0][29] : 0;
  a75=casadi_fabs(a85);
  a75=(a78*a75);
  a83=(a83<=a75);
  a75=(a12<=a00);
  a75=(!a75);
  a87=arg[2]? arg[2][35] : 0;
  a75=(a75?a87:0);
  a75=(a75+a32);
  a87=(a82+a32);
  a75=casadi_fmin(a75,a87);
  a83=(a83?a75:0);
  a82=(a82<a83);
  a85=(a82?a85:0);
  a82=(!a82);
  a75=(a12<=a00);
  a75=(!a75);
  a87=arg[2]? arg[2][36] : 0;
  a86=(a75?a87:0);
  a88=casadi_fabs(a86);
  a78=(a78*a88);
  a87=(-a87);
  a75=(a75?a87:0);
  a75=(a35+a75);
  a75=casadi_fabs(a75);
  a75=(2.*a75);
  a75=(a75/a08);
  a78=(a78<a75);
  a78=(!a78);
  a78=(a78?a86:0);
  a82=(a82?a78:0);
  a85=(a85+a82);
  a82=casadi_fabs(a85);
  a82=(a04<a82);
  a78=(a82?a85:0);
  a82=(!a82);
  a82=(a82?a35:0);
  a78=(a78+a82);
  a78=(a78*a80);
  a16=(a16+a78);
  a78=(a22?a16:0);
  a22=(!a22);
  a82=arg[2]? arg[2][37] : 0;
  a22=(a22?a82:0);
  a78=(a78+a22);
  a22=arg[1]? arg[1][9] : 0;
  a82=(-a22);
  a16=(a16-a78);
  a22=casadi_fmin(a22,a16);
  a82=casadi_fmax(a82,a22);
  a78=(a78+a82);
  a22=(a14*a78);
  a22=(a22-a10);
  a22=(a60*a22);
  a16=casadi_fabs(a14);
  a16=(a16/a84);
  a27=(a27+a16);
  a27=casadi_fmin(a02,a27);
  a27=casadi_fmax(a04,a27);
  a27=(a02-a27);
  a27=(a80*a27);
  a27=(a02-a27);
  a22=(a22*a27);
  a27=arg[0]? arg[0][57] : 0;
  a16=(a02-a27);
  a40=(a40*a16);
  a40=(-a40);
  a16=(a12<=a00);
  a16=(!a16);
  a84=arg[2]? arg[2][69] : 0;
  a16=(a16?a84:0);
  a84=arg[0]? arg[0][51] : 0;
  a86=(a12<=a00);
  a75=(a86?a13:0);
  a86=(!a86);
  a08=arg[2]? arg[2][65] : 0;
  a86=(a86?a08:0);
  a75=(a75+a86);
  a86=arg[1]? arg[1][19] : 0;
  a08=(-a86);
  a17=(a29?a17:0);
  a29=(!a29);
  a87=arg[2]? arg[2][4] : 0;
  a29=(a29?a87:0);
  a17=(a17+a29);
  a29=(a17-a75);
  a86=casadi_fmin(a86,a29);
  a08=casadi_fmax(a08,a86);
  a75=(a75+a08);
  a84=(a84*a75);
  a84=(a16+a84);
  a08=(a12<=a00);
  a86=(a08?a13:0);
  a08=(!a08);
  a29=arg[2]? arg[2][67] : 0;
  a08=(a08?a29:0);
  a86=(a86+a08);
  a08=(a12<=a00);
  a08=(!a08);
  a29=arg[2]? arg[2][68] : 0;
  a87=(a08?a29:0);
  a88=arg[1]? arg[1][23] : 0;
  a89=(a75-a86);
  a88=(a88*a89);
  a87=(a87+a88);
  a88=arg[1]? arg[1][24] : 0;
  a88=(a88*a29);
  a88=(-a88);
  a08=(a08?a88:0);
  a87=(a87+a08);
  a32=(a87*a32);
  a86=(a86+a32);
  a32=arg[0]? arg[0][55] : 0;
  a08=(a86*a32);
  a88=arg[1]? arg[1][22] : 0;
  a29=arg[1]? arg[1][7] : 0;
  a89=arg[0]? arg[0][20] : 0;
  a90=casadi_fabs(a14);
  a89=casadi_fmax(a89,a90);
  a29=(a29/a89);
  a89=arg[1]? arg[1][6] : 0;
  a90=arg[1]? arg[1][5] : 0;
  a91=(a14*a90);
  a91=(a89+a91);
  a91=casadi_fmin(a02,a91);
  a91=casadi_fmax(a04,a91);
  a91=(a29*a91);
  a91=(-a91);
  a90=(a14*a90);
  a89=(a89-a90);
  a89=casadi_fmin(a02,a89);
  a89=casadi_fmax(a04,a89);
  a29=(a29*a89);
  a89=(a12<=a00);
  a89=(!a89);
  a90=arg[2]? arg[2][66] : 0;
  a89=(a89?a90:0);
  a90=arg[0]? arg[0][48] : 0;
  a90=(a04<a90);
  a92=(a12<=a00);
  a93=arg[0]? arg[0][12] : 0;
  a94=(a92?a93:0);
  a92=(!a92);
  a95=arg[2]? arg[2][22] : 0;
  a92=(a92?a95:0);
  a94=(a94+a92);
  a92=arg[2]? arg[2][23] : 0;
  a92=(a93!=a92);
  a95=(a93-a94);
  a96=casadi_fabs(a95);
  a96=(a15*a96);
  a97=casadi_fabs(a93);
  a97=(a74*a97);
  a98=casadi_fabs(a94);
  a98=(a74*a98);
  a97=(a97+a98);
  a96=casadi_fmax(a96,a97);
  a96=(a92?a96:0);
  a92=(!a92);
  a97=arg[2]? arg[2][24] : 0;
  a92=(a92?a97:0);
  a96=(a96+a92);
  a92=casadi_fabs(a95);
  a92=(a96<a92);
  a97=(-a96);
  a98=casadi_fmin(a95,a96);
  a97=casadi_fmax(a97,a98);
  a97=(a94+a97);
  a97=(a92?a97:0);
  a92=(!a92);
  a92=(a92?a93:0);
  a97=(a97+a92);
  a94=(a94-a97);
  a94=(a19*a94);
  a94=(-a94);
  a90=(a90?a94:0);
  a89=(a89+a90);
  a90=(a12<=a00);
  a94=(a90?a14:0);
  a90=(!a90);
  a92=arg[2]? arg[2][64] : 0;
  a90=(a90?a92:0);
  a94=(a94+a90);
  a90=arg[1]? arg[1][18] : 0;
  a92=(-a90);
  a07=(a34?a07:0);
  a34=(!a34);
  a98=arg[2]? arg[2][6] : 0;
  a34=(a34?a98:0);
  a07=(a07+a34);
  a34=(a07-a94);
  a90=casadi_fmin(a90,a34);
  a92=casadi_fmax(a92,a90);
  a94=(a94+a92);
  a92=(a94-a14);
  a90=arg[0]? arg[0][47] : 0;
  a90=(a92*a90);
  a90=(a89+a90);
  a34=(a19*a97);
  a90=(a90-a34);
  a29=casadi_fmin(a29,a90);
  a91=casadi_fmax(a91,a29);
  a29=(a91+a19);
  a88=(a88*a29);
  a88=(a13+a88);
  a08=(a08-a88);
  a32=(a02-a32);
  a32=(a75*a32);
  a08=(a08+a32);
  a32=arg[0]? arg[0][52] : 0;
  a32=(a08*a32);
  a84=(a84+a32);
  a32=arg[0]? arg[0][13] : 0;
  a88=arg[2]? arg[2][26] : 0;
  a88=(a32!=a88);
  a12=(a12<=a00);
  a34=(a12?a32:0);
  a12=(!a12);
  a98=arg[2]? arg[2][25] : 0;
  a12=(a12?a98:0);
  a34=(a34+a12);
  a12=(a32-a34);
  a98=casadi_fabs(a12);
  a15=(a15*a98);
  a98=casadi_fabs(a32);
  a98=(a74*a98);
  a99=casadi_fabs(a34);
  a74=(a74*a99);
  a98=(a98+a74);
  a15=casadi_fmax(a15,a98);
  a15=(a88?a15:0);
  a88=(!a88);
  a98=arg[2]? arg[2][27] : 0;
  a88=(a88?a98:0);
  a15=(a15+a88);
  a88=casadi_fabs(a12);
  a88=(a15<a88);
  a98=(-a15);
  a74=casadi_fmin(a12,a15);
  a98=casadi_fmax(a98,a74);
  a34=(a34+a98);
  a34=(a88?a34:0);
  a88=(!a88);
  a88=(a88?a32:0);
  a34=(a34+a88);
  a88=arg[0]? arg[0][50] : 0;
  a98=(a88*a14);
  a74=arg[1]? arg[1][10] : 0;
  a99=(a02-a80);
  a74=(a74*a99);
  a74=(a74*a82);
  a98=(a98*a74);
  a88=(a88*a29);
  a88=(a88*a78);
  a29=arg[0]? arg[0][37] : 0;
  a88=(a88/a29);
  a98=(a98+a88);
  a98=(a34*a98);
  a84=(a84+a98);
  a27=(a02-a27);
  a27=(a63*a27);
  a27=casadi_fmin(a84,a27);
  a40=casadi_fmax(a40,a27);
  a22=(a22+a40);
  a63=casadi_fmin(a63,a22);
  a50=casadi_fmax(a50,a63);
  a63=casadi_fabs(a50);
  a22=arg[1]? arg[1][26] : 0;
  a63=(a63<=a22);
  a27=(a63?a02:0);
  a27=(a00<a27);
  a98=casadi_fabs(a91);
  a88=arg[1]? arg[1][27] : 0;
  a98=(a98<=a88);
  a29=(a98?a02:0);
  a29=(a00<a29);
  a29=(!a29);
  a74=7002.;
  a29=(a29?a74:0);
  a29=(a27?a29:0);
  a27=(!a27);
  a74=7001.;
  a27=(a27?a74:0);
  a29=(a29+a27);
  a05=(a05?a29:0);
  a26=(a26+a05);
  if (res[0]!=0) res[0][0]=a26;
  a05=(a00<a26);
  a29=arg[1]? arg[1][28] : 0;
  a27=(-a29);
  a27=(a05?a27:0);
  a05=(!a05);
  a05=(a05?a29:0);
  a27=(a27+a05);
  a03=(a03+a27);
  a03=casadi_fmax(a04,a03);
  a03=casadi_fmin(a02,a03);
  if (res[0]!=0) res[0][1]=a03;
  a27=(a00<a26);
  a27=(!a27);
  a27=(a27?a02:0);
  if (res[0]!=0) res[0][2]=a27;
  if (res[0]!=0) res[0][3]=a23;
  if (res[0]!=0) res[0][4]=a17;
  if (res[0]!=0) res[0][5]=a33;
  if (res[0]!=0) res[0][6]=a07;
  if (res[0]!=0) res[0][7]=a36;
  if (res[0]!=0) res[0][8]=a21;
  if (res[0]!=0) res[0][9]=a38;
  if (res[0]!=0) res[0][10]=a10;
  if (res[0]!=0) res[0][11]=a39;
  if (res[0]!=0) res[0][12]=a13;
  if (res[0]!=0) res[0][13]=a41;
  if (res[0]!=0) res[0][14]=a19;
  if (res[0]!=0) res[0][15]=a43;
  if (res[0]!=0) res[0][16]=a14;
  if (res[0]!=0) res[0][17]=a44;
  if (res[0]!=0) res[0][18]=a45;
  if (res[0]!=0) res[0][19]=a46;
  if (res[0]!=0) res[0][20]=a28;
  a01=(a00<a01);
  a11=(a11?a25:0);
  a06=(a06?a11:0);
  a01=(a01?a06:0);
  if (res[0]!=0) res[0][21]=a01;
  if (res[0]!=0) res[0][22]=a97;
  if (res[0]!=0) res[0][23]=a93;
  a95=casadi_fabs(a95);
  a95=(a96<a95);
  a95=(a95?a96:0);
  if (res[0]!=0) res[0][24]=a95;
  if (res[0]!=0) res[0][25]=a34;
  if (res[0]!=0) res[0][26]=a32;
  a12=casadi_fabs(a12);
  a12=(a15<a12);
  a12=(a12?a15:0);
  if (res[0]!=0) res[0][27]=a12;
  if (res[0]!=0) res[0][28]=a60;
  if (res[0]!=0) res[0][29]=a09;
  a20=casadi_fabs(a20);
  a20=(a69<a20);
  a20=(a20?a69:0);
  if (res[0]!=0) res[0][30]=a20;
  if (res[0]!=0) res[0][31]=a80;
  if (res[0]!=0) res[0][32]=a77;
  a79=casadi_fabs(a79);
  a79=(a81<a79);
  a79=(a79?a81:0);
  if (res[0]!=0) res[0][33]=a79;
  if (res[0]!=0) res[0][34]=a35;
  if (res[0]!=0) res[0][35]=a83;
  if (res[0]!=0) res[0][36]=a85;
  if (res[0]!=0) res[0][37]=a78;
  if (res[0]!=0) res[0][38]=a30;
  if (res[0]!=0) res[0][39]=a56;
  if (res[0]!=0) res[0][40]=a10;
  if (res[0]!=0) res[0][41]=a42;
  if (res[0]!=0) res[0][42]=a13;
  if (res[0]!=0) res[0][43]=a47;
  if (res[0]!=0) res[0][44]=a49;
  if (res[0]!=0) res[0][45]=a48;
  if (res[0]!=0) res[0][46]=a31;
  if (res[0]!=0) res[0][47]=a14;
  if (res[0]!=0) res[0][48]=a54;
  if (res[0]!=0) res[0][49]=a19;
  if (res[0]!=0) res[0][50]=a53;
  if (res[0]!=0) res[0][51]=a55;
  a55=arg[1]? arg[1][17] : 0;
  a58=(a58*a55);
  a59=(a59+a58);
  if (res[0]!=0) res[0][52]=a59;
  if (res[0]!=0) res[0][53]=a61;
  if (res[0]!=0) res[0][54]=a37;
  a64=(a64*a55);
  a65=(a65+a64);
  if (res[0]!=0) res[0][55]=a65;
  if (res[0]!=0) res[0][56]=a67;
  if (res[0]!=0) res[0][57]=a62;
  a57=(a57?a70:0);
  a18=(a18*a55);
  a57=(a57+a18);
  if (res[0]!=0) res[0][58]=a57;
  if (res[0]!=0) res[0][59]=a72;
  if (res[0]!=0) res[0][60]=a66;
  a73=(a73?a68:0);
  a52=(a52*a55);
  a73=(a73+a52);
  if (res[0]!=0) res[0][61]=a73;
  if (res[0]!=0) res[0][62]=a76;
  if (res[0]!=0) res[0][63]=a71;
  if (res[0]!=0) res[0][64]=a94;
  if (res[0]!=0) res[0][65]=a75;
  a90=(a91-a90);
  a75=arg[1]? arg[1][21] : 0;
  a90=(a90*a75);
  a89=(a89+a90);
  a90=arg[1]? arg[1][20] : 0;
  a92=(a92*a90);
  a89=(a89+a92);
  if (res[0]!=0) res[0][66]=a89;
  if (res[0]!=0) res[0][67]=a86;
  if (res[0]!=0) res[0][68]=a87;
  a84=(a84-a40);
  a84=(a08*a84);
  a04=(a04<a84);
  a84=(a04?a16:0);
  a04=(!a04);
  a40=arg[0]? arg[0][58] : 0;
  a87=(-a40);
  a86=arg[1]? arg[1][25] : 0;
  a08=(a08*a86);
  a16=(a16+a08);
  a40=casadi_fmin(a40,a16);
  a87=casadi_fmax(a87,a40);
  a04=(a04?a87:0);
  a84=(a84+a04);
  if (res[0]!=0) res[0][69]=a84;
  a84=2.9995000000000000e+03;
  a04=(a84<a26);
  a87=arg[2]? arg[2][72] : 0;
  a40=arg[1]? arg[1][29] : 0;
  a16=(a26<=a00);
  a50=(a63?a50:0);
  a63=(!a63);
  a63=(a63?a24:0);
  a50=(a50+a63);
  a50=(a16?a50:0);
  a16=(!a16);
  a16=(a16?a24:0);
  a50=(a50+a16);
  a16=(a50-a87);
  a16=(a40*a16);
  a16=(a87+a16);
  a24=casadi_fabs(a16);
  a24=(a24<=a22);
  a16=(a24?a16:0);
  a24=(!a24);
  a24=(a24?a87:0);
  a16=(a16+a24);
  a24=(a04?a16:0);
  a04=(!a04);
  a04=(a04?a50:0);
  a24=(a24+a04);
  if (res[0]!=0) res[0][70]=a24;
  a84=(a84<a26);
  a04=arg[2]? arg[2][73] : 0;
  a26=(a26<=a00);
  a91=(a98?a91:0);
  a98=(!a98);
  a98=(a98?a51:0);
  a91=(a91+a98);
  a91=(a26?a91:0);
  a26=(!a26);
  a26=(a26?a51:0);
  a91=(a91+a26);
  a26=(a91-a04);
  a40=(a40*a26);
  a40=(a04+a40);
  a26=casadi_fabs(a40);
  a26=(a26<=a88);
  a40=(a26?a40:0);
  a26=(!a26);
  a26=(a26?a04:0);
  a40=(a40+a26);
  a26=(a84?a40:0);
  a84=(!a84);
  a84=(a84?a91:0);
  a26=(a26+a84);
  if (res[0]!=0) res[0][71]=a26;
  if (res[0]!=0) res[0][72]=a16;
  if (res[0]!=0) res[0][73]=a40;
  a40=-900.;
  a16=900.;
  a24=(a24*a03);
  a16=casadi_fmin(a16,a24);
  a40=casadi_fmax(a40,a16);
  if (res[1]!=0) res[1][0]=a40;
  a40=-3300.;
  a16=3300.;
  a26=(a26*a03);
  a16=casadi_fmin(a16,a26);
  a40=casadi_fmax(a40,a16);
  if (res[1]!=0) res[1][1]=a40;
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


