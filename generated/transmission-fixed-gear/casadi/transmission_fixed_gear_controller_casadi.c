/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) transmission_fixed_gear_controller_casadi_ ## ID
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
CASADI_SYMBOL_EXPORT void transmission_fixed_gear_controller_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int transmission_fixed_gear_controller_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int transmission_fixed_gear_controller_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {54, 1, 1};
static const casadi_int casadi_s1[3] = {29, 1, 1};
static const casadi_int casadi_s2[3] = {68, 1, 1};
static const casadi_int casadi_s3[3] = {8, 1, 1};
static const casadi_int casadi_s4[3] = {2, 1, 1};

static const casadi_real casadi_zeros[54] = 
  {0.};

/* controller_prepare:(parameters[54])->(derived[29]) */
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
  /* #34: @1 = @0[26] */
  w1 = wr0[26];
  /* #35: @1 = (@1*@2) */
  w1 *= w2;
  /* #36: output[0][8] = @1 */
  if (res[0]) res[0][8] = w1;
  /* #37: @1 = (1./@2) */
  w1 = (1./ w2 );
  /* #38: output[0][9] = @1 */
  if (res[0]) res[0][9] = w1;
  /* #39: @1 = @0[27] */
  w1 = wr0[27];
  /* #40: @1 = (@1*@2) */
  w1 *= w2;
  /* #41: output[0][10] = @1 */
  if (res[0]) res[0][10] = w1;
  /* #42: @1 = @0[28] */
  w1 = wr0[28];
  /* #43: @1 = (@2/@1) */
  w1  = (w2/w1);
  /* #44: output[0][11] = @1 */
  if (res[0]) res[0][11] = w1;
  /* #45: @1 = 0.05 */
  w1 = 5.0000000000000003e-02;
  /* #46: @1 = (@1*@4) */
  w1 *= w4;
  /* #47: output[0][12] = @1 */
  if (res[0]) res[0][12] = w1;
  /* #48: @1 = @0[32] */
  w1 = wr0[32];
  /* #49: @3 = (@2/@1) */
  w3  = (w2/w1);
  /* #50: output[0][13] = @3 */
  if (res[0]) res[0][13] = w3;
  /* #51: @3 = 0.05 */
  w3 = 5.0000000000000003e-02;
  /* #52: @3 = (@3*@5) */
  w3 *= w5;
  /* #53: output[0][14] = @3 */
  if (res[0]) res[0][14] = w3;
  /* #54: @3 = @0[35] */
  w3 = wr0[35];
  /* #55: @6 = (@3*@2) */
  w6  = (w3*w2);
  /* #56: output[0][15] = @6 */
  if (res[0]) res[0][15] = w6;
  /* #57: @6 = 6.2832 */
  w6 = 6.2831999999999999e+00;
  /* #58: @6 = (@6*@3) */
  w6 *= w3;
  /* #59: @6 = (@6*@2) */
  w6 *= w2;
  /* #60: output[0][16] = @6 */
  if (res[0]) res[0][16] = w6;
  /* #61: @6 = @0[40] */
  w6 = wr0[40];
  /* #62: @6 = (@6*@2) */
  w6 *= w2;
  /* #63: output[0][17] = @6 */
  if (res[0]) res[0][17] = w6;
  /* #64: @6 = @0[41] */
  w6 = wr0[41];
  /* #65: @6 = (@6*@2) */
  w6 *= w2;
  /* #66: output[0][18] = @6 */
  if (res[0]) res[0][18] = w6;
  /* #67: @6 = @0[43] */
  w6 = wr0[43];
  /* #68: @3 = (@6*@2) */
  w3  = (w6*w2);
  /* #69: output[0][19] = @3 */
  if (res[0]) res[0][19] = w3;
  /* #70: @6 = (@6*@2) */
  w6 *= w2;
  /* #71: @3 = @0[42] */
  w3 = wr0[42];
  /* #72: @6 = (@6/@3) */
  w6 /= w3;
  /* #73: output[0][20] = @6 */
  if (res[0]) res[0][20] = w6;
  /* #74: @6 = @0[44] */
  w6 = wr0[44];
  /* #75: @6 = (@6/@1) */
  w6 /= w1;
  /* #76: output[0][21] = @6 */
  if (res[0]) res[0][21] = w6;
  /* #77: @6 = @0[48] */
  w6 = wr0[48];
  /* #78: @6 = (@6*@2) */
  w6 *= w2;
  /* #79: @1 = @0[45] */
  w1 = wr0[45];
  /* #80: @6 = (@6/@1) */
  w6 /= w1;
  /* #81: output[0][22] = @6 */
  if (res[0]) res[0][22] = w6;
  /* #82: @6 = @0[49] */
  w6 = wr0[49];
  /* #83: @6 = (@6*@2) */
  w6 *= w2;
  /* #84: @6 = (@6/@1) */
  w6 /= w1;
  /* #85: output[0][23] = @6 */
  if (res[0]) res[0][23] = w6;
  /* #86: @6 = @0[51] */
  w6 = wr0[51];
  /* #87: @6 = (@6*@2) */
  w6 *= w2;
  /* #88: output[0][24] = @6 */
  if (res[0]) res[0][24] = w6;
  /* #89: @6 = 1.01 */
  w6 = 1.0100000000000000e+00;
  /* #90: @1 = 900 */
  w1 = 900.;
  /* #91: @1 = fmin(@1,@4) */
  w1  = casadi_fmin(w1,w4);
  /* #92: @6 = (@6*@1) */
  w6 *= w1;
  /* #93: output[0][25] = @6 */
  if (res[0]) res[0][25] = w6;
  /* #94: @6 = 1.01 */
  w6 = 1.0100000000000000e+00;
  /* #95: @1 = 3300 */
  w1 = 3300.;
  /* #96: @1 = fmin(@1,@5) */
  w1  = casadi_fmin(w1,w5);
  /* #97: @6 = (@6*@1) */
  w6 *= w1;
  /* #98: output[0][26] = @6 */
  if (res[0]) res[0][26] = w6;
  /* #99: @6 = @0[1] */
  w6 = wr0[1];
  /* #100: @6 = (@2/@6) */
  w6  = (w2/w6);
  /* #101: output[0][27] = @6 */
  if (res[0]) res[0][27] = w6;
  /* #102: @6 = 0.02 */
  w6 = 2.0000000000000000e-02;
  /* #103: @6 = (@6+@2) */
  w6 += w2;
  /* #104: @2 = (@2/@6) */
  w2 /= w6;
  /* #105: output[0][28] = @2 */
  if (res[0]) res[0][28] = w2;
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

/* controller_step:(parameters[54],derived[29],states[68],inputs[8])->(next_states[68],outputs[2]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
  casadi_real a84, a85, a86, a87, a88, a89, a90, a91, a92;
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
  a17=arg[3]? arg[3][5] : 0;
  a19=casadi_fabs(a17);
  a20=arg[0]? arg[0][8] : 0;
  a19=(a19<=a20);
  a11=(a11&&a19);
  a19=arg[3]? arg[3][0] : 0;
  a21=casadi_fabs(a19);
  a22=arg[0]? arg[0][3] : 0;
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
  a29=casadi_fabs(a19);
  a29=(a29<=a22);
  a22=(a29?a02:0);
  a22=(a00<a22);
  a30=arg[2]? arg[2][5] : 0;
  a31=arg[0]? arg[0][2] : 0;
  a30=casadi_fmin(a30,a31);
  a32=arg[0]? arg[0][0] : 0;
  a33=casadi_fmax(a30,a32);
  a33=(a33-a32);
  a33=(a22?a33:0);
  a22=(!a22);
  a30=(a30+a32);
  a22=(a22?a30:0);
  a33=(a33+a22);
  a22=arg[1]? arg[1][0] : 0;
  a30=(a33<=a22);
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
  a15=(a36<=a22);
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
  a24=(a38<=a22);
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
  a08=(a39<=a22);
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
  a18=(a41<=a22);
  a40=casadi_fabs(a17);
  a40=(a40<=a20);
  a20=(a40?a02:0);
  a20=(a00<a20);
  a42=arg[2]? arg[2][15] : 0;
  a42=casadi_fmin(a42,a31);
  a43=casadi_fmax(a42,a32);
  a43=(a43-a32);
  a43=(a20?a43:0);
  a20=(!a20);
  a42=(a42+a32);
  a20=(a20?a42:0);
  a43=(a43+a20);
  a20=(a43<=a22);
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
  a09=(a44<=a22);
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
  a42=(a45<=a22);
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
  a12=(a46<=a22);
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
  a12=(a20?a12:0);
  a20=(!a20);
  a09=6.;
  a20=(a20?a09:0);
  a12=(a12+a20);
  a12=(a18?a12:0);
  a18=(!a18);
  a20=5.;
  a18=(a18?a20:0);
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
  a24=arg[2]? arg[2][32] : 0;
  a30=(a30?a24:0);
  a15=(a15+a30);
  a30=arg[1]? arg[1][11] : 0;
  a24=arg[2]? arg[2][64] : 0;
  a08=(a24*a03);
  a13=(a37?a13:0);
  a37=(!a37);
  a18=arg[2]? arg[2][12] : 0;
  a37=(a37?a18:0);
  a13=(a13+a37);
  a37=(a08-a13);
  a30=(a30*a37);
  a30=(a15+a30);
  a37=arg[1]? arg[1][10] : 0;
  a15=(a10-a15);
  a15=(a37*a15);
  a30=(a30+a15);
  a15=(a30-a10);
  a15=casadi_fabs(a15);
  a18=arg[0]? arg[0][30] : 0;
  a20=(a15<=a18);
  a09=arg[2]? arg[2][34] : 0;
  a09=(a10==a09);
  a42=(a12<=a00);
  a42=(!a42);
  a16=arg[2]? arg[2][35] : 0;
  a42=(a42?a16:0);
  a42=(a42+a32);
  a09=(a09?a42:0);
  a42=arg[0]? arg[0][31] : 0;
  a16=(a09<=a42);
  a20=(a20||a16);
  a18=(a15<=a18);
  a16=arg[2]? arg[2][36] : 0;
  a16=(a13==a16);
  a47=(a12<=a00);
  a47=(!a47);
  a48=arg[2]? arg[2][37] : 0;
  a47=(a47?a48:0);
  a47=(a47+a32);
  a16=(a16?a47:0);
  a47=(a16<=a42);
  a18=(a18||a47);
  a47=(a04<a16);
  a48=arg[2]? arg[2][38] : 0;
  a48=(a47?a48:0);
  a47=(!a47);
  a47=(a47?a08:0);
  a48=(a48+a47);
  a47=(a08-a48);
  a47=casadi_fabs(a47);
  a49=arg[1]? arg[1][12] : 0;
  a47=(a47<=a49);
  a18=(a18||a47);
  a47=(a12<=a00);
  a49=(a47?a14:0);
  a47=(!a47);
  a50=arg[2]? arg[2][39] : 0;
  a47=(a47?a50:0);
  a49=(a49+a47);
  a47=arg[1]? arg[1][13] : 0;
  a50=arg[2]? arg[2][65] : 0;
  a51=(a50*a03);
  a17=(a40?a17:0);
  a40=(!a40);
  a52=arg[2]? arg[2][14] : 0;
  a40=(a40?a52:0);
  a17=(a17+a40);
  a40=(a51+a17);
  a47=(a47*a40);
  a47=(a49+a47);
  a49=(a14-a49);
  a37=(a37*a49);
  a47=(a47+a37);
  a37=(a47-a14);
  a37=casadi_fabs(a37);
  a49=arg[0]? arg[0][34] : 0;
  a40=(a37<=a49);
  a52=arg[2]? arg[2][43] : 0;
  a52=(a17==a52);
  a53=(a12<=a00);
  a53=(!a53);
  a54=arg[2]? arg[2][44] : 0;
  a53=(a53?a54:0);
  a53=(a53+a32);
  a52=(a52?a53:0);
  a53=(a52<=a42);
  a40=(a40||a53);
  a53=(a04<a52);
  a54=arg[2]? arg[2][45] : 0;
  a54=(a53?a54:0);
  a53=(!a53);
  a53=(a53?a51:0);
  a54=(a54+a53);
  a53=(a51-a54);
  a53=casadi_fabs(a53);
  a55=arg[1]? arg[1][14] : 0;
  a53=(a53<=a55);
  a40=(a40||a53);
  a49=(a37<=a49);
  a53=arg[2]? arg[2][41] : 0;
  a53=(a14==a53);
  a55=(a12<=a00);
  a55=(!a55);
  a56=arg[2]? arg[2][42] : 0;
  a55=(a55?a56:0);
  a55=(a55+a32);
  a53=(a53?a55:0);
  a42=(a53<=a42);
  a49=(a49||a42);
  a42=arg[0]? arg[0][29] : 0;
  a15=(a15<=a42);
  a15=(a15?a02:0);
  a15=(a00<a15);
  a42=arg[2]? arg[2][33] : 0;
  a42=casadi_fmin(a42,a31);
  a55=casadi_fmax(a42,a32);
  a55=(a55-a32);
  a55=(a15?a55:0);
  a15=(!a15);
  a42=(a42+a32);
  a15=(a15?a42:0);
  a55=(a55+a15);
  a15=(a55<=a22);
  a42=arg[0]? arg[0][33] : 0;
  a37=(a37<=a42);
  a37=(a37?a02:0);
  a37=(a00<a37);
  a42=arg[2]? arg[2][40] : 0;
  a42=casadi_fmin(a42,a31);
  a31=casadi_fmax(a42,a32);
  a31=(a31-a32);
  a31=(a37?a31:0);
  a37=(!a37);
  a42=(a42+a32);
  a37=(a37?a42:0);
  a31=(a31+a37);
  a22=(a31<=a22);
  a37=(a12<=a00);
  a37=(!a37);
  a42=arg[2]? arg[2][48] : 0;
  a37=(a37?a42:0);
  a42=arg[1]? arg[1][15] : 0;
  a37=(a37-a42);
  a37=casadi_fmax(a04,a37);
  a56=arg[0]? arg[0][36] : 0;
  a57=(a12<=a00);
  a58=(a57?a13:0);
  a57=(!a57);
  a59=arg[2]? arg[2][46] : 0;
  a57=(a57?a59:0);
  a58=(a58+a57);
  a57=(a13-a58);
  a59=(a56<a57);
  a60=(a59?a02:0);
  a59=(!a59);
  a56=(-a56);
  a56=(a57<a56);
  a61=(a56?a27:0);
  a56=(!a56);
  a62=arg[2]? arg[2][47] : 0;
  a56=(a56?a62:0);
  a61=(a61+a56);
  a59=(a59?a61:0);
  a60=(a60+a59);
  a62=(a60==a62);
  a62=(!a62);
  a62=(a62?a02:0);
  a37=(a37+a62);
  a62=5.5000000000000000e+00;
  a59=(a37<=a62);
  a61=(a12<=a00);
  a61=(!a61);
  a56=arg[2]? arg[2][51] : 0;
  a61=(a61?a56:0);
  a61=(a61-a42);
  a61=casadi_fmax(a04,a61);
  a56=arg[0]? arg[0][37] : 0;
  a63=(a12<=a00);
  a64=(a63?a17:0);
  a63=(!a63);
  a65=arg[2]? arg[2][49] : 0;
  a63=(a63?a65:0);
  a64=(a64+a63);
  a63=(a17-a64);
  a65=(a56<a63);
  a66=(a65?a02:0);
  a65=(!a65);
  a56=(-a56);
  a56=(a63<a56);
  a67=(a56?a27:0);
  a56=(!a56);
  a68=arg[2]? arg[2][50] : 0;
  a56=(a56?a68:0);
  a67=(a67+a56);
  a65=(a65?a67:0);
  a66=(a66+a65);
  a68=(a66==a68);
  a68=(!a68);
  a68=(a68?a02:0);
  a61=(a61+a68);
  a68=(a61<=a62);
  a65=(a12<=a00);
  a65=(!a65);
  a67=arg[2]? arg[2][54] : 0;
  a65=(a65?a67:0);
  a65=(a65-a42);
  a65=casadi_fmax(a04,a65);
  a67=arg[0]? arg[0][38] : 0;
  a56=(a12<=a00);
  a56=(!a56);
  a69=arg[2]? arg[2][52] : 0;
  a70=(-a69);
  a70=(a56?a70:0);
  a08=(a08+a70);
  a70=(a67<a08);
  a71=(a70?a02:0);
  a70=(!a70);
  a67=(-a67);
  a67=(a08<a67);
  a72=(a67?a27:0);
  a67=(!a67);
  a73=arg[2]? arg[2][53] : 0;
  a67=(a67?a73:0);
  a72=(a72+a67);
  a70=(a70?a72:0);
  a71=(a71+a70);
  a73=(a71==a73);
  a73=(!a73);
  a73=(a73?a02:0);
  a65=(a65+a73);
  a73=(a65<=a62);
  a70=(a12<=a00);
  a70=(!a70);
  a72=arg[2]? arg[2][57] : 0;
  a70=(a70?a72:0);
  a70=(a70-a42);
  a70=casadi_fmax(a04,a70);
  a42=arg[0]? arg[0][39] : 0;
  a72=(a12<=a00);
  a72=(!a72);
  a67=arg[2]? arg[2][55] : 0;
  a74=(-a67);
  a74=(a72?a74:0);
  a51=(a51+a74);
  a74=(a42<a51);
  a75=(a74?a02:0);
  a74=(!a74);
  a42=(-a42);
  a42=(a51<a42);
  a27=(a42?a27:0);
  a42=(!a42);
  a76=arg[2]? arg[2][56] : 0;
  a42=(a42?a76:0);
  a27=(a27+a42);
  a74=(a74?a27:0);
  a75=(a75+a74);
  a76=(a75==a76);
  a76=(!a76);
  a76=(a76?a02:0);
  a70=(a70+a76);
  a62=(a70<=a62);
  a62=(!a62);
  a76=8002.;
  a62=(a62?a76:0);
  a62=(a73?a62:0);
  a73=(!a73);
  a76=8001.;
  a73=(a73?a76:0);
  a62=(a62+a73);
  a62=(a68?a62:0);
  a68=(!a68);
  a73=6006.;
  a68=(a68?a73:0);
  a62=(a62+a68);
  a62=(a59?a62:0);
  a59=(!a59);
  a68=6005.;
  a59=(a59?a68:0);
  a62=(a62+a59);
  a62=(a22?a62:0);
  a22=(!a22);
  a59=5007.;
  a22=(a22?a59:0);
  a62=(a62+a22);
  a62=(a15?a62:0);
  a15=(!a15);
  a22=5004.;
  a15=(a15?a22:0);
  a62=(a62+a15);
  a62=(a49?a62:0);
  a49=(!a49);
  a15=3007.;
  a49=(a49?a15:0);
  a62=(a62+a49);
  a62=(a40?a62:0);
  a40=(!a40);
  a49=3006.;
  a40=(a40?a49:0);
  a62=(a62+a40);
  a62=(a18?a62:0);
  a18=(!a18);
  a40=3005.;
  a18=(a18?a40:0);
  a62=(a62+a18);
  a62=(a20?a62:0);
  a20=(!a20);
  a18=3004.;
  a20=(a20?a18:0);
  a62=(a62+a20);
  a05=(a05?a62:0);
  a26=(a26+a05);
  a05=(a00<a26);
  a26=(a05?a26:0);
  a05=(!a05);
  a62=arg[1]? arg[1][4] : 0;
  a20=arg[0]? arg[0][16] : 0;
  a18=casadi_fabs(a10);
  a20=casadi_fmax(a20,a18);
  a62=(a62/a20);
  a20=arg[1]? arg[1][3] : 0;
  a18=arg[1]? arg[1][2] : 0;
  a40=(a10*a18);
  a40=(a20+a40);
  a40=casadi_fmin(a02,a40);
  a40=casadi_fmax(a04,a40);
  a40=(a62*a40);
  a49=(-a40);
  a18=(a10*a18);
  a20=(a20-a18);
  a20=casadi_fmin(a02,a20);
  a20=casadi_fmax(a04,a20);
  a62=(a62*a20);
  a20=arg[0]? arg[0][15] : 0;
  a18=arg[2]? arg[2][29] : 0;
  a18=(a20!=a18);
  a15=arg[1]? arg[1][1] : 0;
  a22=(a12<=a00);
  a59=(a22?a20:0);
  a22=(!a22);
  a68=arg[2]? arg[2][28] : 0;
  a22=(a22?a68:0);
  a59=(a59+a22);
  a22=(a20-a59);
  a68=casadi_fabs(a22);
  a68=(a15*a68);
  a73=9.9999999999999995e-07;
  a76=casadi_fabs(a20);
  a76=(a73*a76);
  a74=casadi_fabs(a59);
  a74=(a73*a74);
  a76=(a76+a74);
  a68=casadi_fmax(a68,a76);
  a68=(a18?a68:0);
  a18=(!a18);
  a76=arg[2]? arg[2][30] : 0;
  a18=(a18?a76:0);
  a68=(a68+a18);
  a18=casadi_fabs(a22);
  a18=(a68<a18);
  a76=(-a68);
  a74=casadi_fmin(a22,a68);
  a76=casadi_fmax(a76,a74);
  a59=(a59+a76);
  a59=(a18?a59:0);
  a18=(!a18);
  a18=(a18?a20:0);
  a59=(a59+a18);
  a18=(a12<=a00);
  a76=arg[0]? arg[0][24] : 0;
  a21=(a35?a21:0);
  a35=(!a35);
  a74=arg[2]? arg[2][8] : 0;
  a35=(a35?a74:0);
  a21=(a21+a35);
  a35=arg[0]? arg[0][25] : 0;
  a35=casadi_fmin(a21,a35);
  a76=casadi_fmax(a76,a35);
  a35=(a18?a76:0);
  a18=(!a18);
  a74=arg[2]? arg[2][31] : 0;
  a18=(a18?a74:0);
  a35=(a35+a18);
  a18=arg[1]? arg[1][8] : 0;
  a74=(-a18);
  a76=(a76-a35);
  a18=casadi_fmin(a18,a76);
  a74=casadi_fmax(a74,a18);
  a35=(a35+a74);
  a18=(a14*a35);
  a18=(a18-a10);
  a18=(a59*a18);
  a76=arg[0]? arg[0][52] : 0;
  a27=(a02-a76);
  a40=(a40*a27);
  a40=(-a40);
  a27=(a12<=a00);
  a27=(!a27);
  a42=arg[2]? arg[2][63] : 0;
  a27=(a27?a42:0);
  a42=arg[0]? arg[0][46] : 0;
  a77=(a12<=a00);
  a78=(a77?a13:0);
  a77=(!a77);
  a79=arg[2]? arg[2][59] : 0;
  a77=(a77?a79:0);
  a78=(a78+a77);
  a77=arg[1]? arg[1][18] : 0;
  a79=(-a77);
  a19=(a29?a19:0);
  a29=(!a29);
  a80=arg[2]? arg[2][4] : 0;
  a29=(a29?a80:0);
  a19=(a19+a29);
  a29=(a19-a78);
  a77=casadi_fmin(a77,a29);
  a79=casadi_fmax(a79,a77);
  a78=(a78+a79);
  a42=(a42*a78);
  a42=(a27+a42);
  a79=(a12<=a00);
  a77=(a79?a13:0);
  a79=(!a79);
  a29=arg[2]? arg[2][61] : 0;
  a79=(a79?a29:0);
  a77=(a77+a79);
  a79=(a12<=a00);
  a79=(!a79);
  a29=arg[2]? arg[2][62] : 0;
  a80=(a79?a29:0);
  a81=arg[1]? arg[1][22] : 0;
  a82=(a78-a77);
  a81=(a81*a82);
  a80=(a80+a81);
  a81=arg[1]? arg[1][23] : 0;
  a81=(a81*a29);
  a81=(-a81);
  a79=(a79?a81:0);
  a80=(a80+a79);
  a32=(a80*a32);
  a77=(a77+a32);
  a32=arg[0]? arg[0][50] : 0;
  a79=(a77*a32);
  a81=arg[0]? arg[0][44] : 0;
  a81=(a81*a14);
  a29=arg[1]? arg[1][9] : 0;
  a29=(a29*a74);
  a81=(a81*a29);
  a81=(a13+a81);
  a74=arg[1]? arg[1][21] : 0;
  a82=arg[1]? arg[1][7] : 0;
  a83=arg[0]? arg[0][20] : 0;
  a84=casadi_fabs(a14);
  a83=casadi_fmax(a83,a84);
  a82=(a82/a83);
  a83=arg[1]? arg[1][6] : 0;
  a84=arg[1]? arg[1][5] : 0;
  a85=(a14*a84);
  a85=(a83+a85);
  a85=casadi_fmin(a02,a85);
  a85=casadi_fmax(a04,a85);
  a85=(a82*a85);
  a85=(-a85);
  a84=(a14*a84);
  a83=(a83-a84);
  a83=casadi_fmin(a02,a83);
  a83=casadi_fmax(a04,a83);
  a82=(a82*a83);
  a83=(a12<=a00);
  a83=(!a83);
  a84=arg[2]? arg[2][60] : 0;
  a83=(a83?a84:0);
  a84=arg[0]? arg[0][43] : 0;
  a84=(a04<a84);
  a86=(a12<=a00);
  a87=arg[0]? arg[0][12] : 0;
  a88=(a86?a87:0);
  a86=(!a86);
  a89=arg[2]? arg[2][22] : 0;
  a86=(a86?a89:0);
  a88=(a88+a86);
  a86=arg[2]? arg[2][23] : 0;
  a86=(a87!=a86);
  a89=(a87-a88);
  a90=casadi_fabs(a89);
  a90=(a15*a90);
  a91=casadi_fabs(a87);
  a91=(a73*a91);
  a92=casadi_fabs(a88);
  a92=(a73*a92);
  a91=(a91+a92);
  a90=casadi_fmax(a90,a91);
  a90=(a86?a90:0);
  a86=(!a86);
  a91=arg[2]? arg[2][24] : 0;
  a86=(a86?a91:0);
  a90=(a90+a86);
  a86=casadi_fabs(a89);
  a86=(a90<a86);
  a91=(-a90);
  a92=casadi_fmin(a89,a90);
  a91=casadi_fmax(a91,a92);
  a91=(a88+a91);
  a91=(a86?a91:0);
  a86=(!a86);
  a86=(a86?a87:0);
  a91=(a91+a86);
  a88=(a88-a91);
  a88=(a17*a88);
  a88=(-a88);
  a84=(a84?a88:0);
  a83=(a83+a84);
  a84=(a12<=a00);
  a88=(a84?a14:0);
  a84=(!a84);
  a86=arg[2]? arg[2][58] : 0;
  a84=(a84?a86:0);
  a88=(a88+a84);
  a84=arg[1]? arg[1][17] : 0;
  a86=(-a84);
  a07=(a34?a07:0);
  a34=(!a34);
  a92=arg[2]? arg[2][6] : 0;
  a34=(a34?a92:0);
  a07=(a07+a34);
  a34=(a07-a88);
  a84=casadi_fmin(a84,a34);
  a86=casadi_fmax(a86,a84);
  a88=(a88+a86);
  a86=(a88-a14);
  a84=arg[0]? arg[0][42] : 0;
  a84=(a86*a84);
  a84=(a83+a84);
  a34=(a17*a91);
  a84=(a84-a34);
  a82=casadi_fmin(a82,a84);
  a85=casadi_fmax(a85,a82);
  a82=(a85+a17);
  a74=(a74*a82);
  a74=(a74*a35);
  a81=(a81+a74);
  a79=(a79-a81);
  a32=(a02-a32);
  a32=(a78*a32);
  a79=(a79+a32);
  a32=arg[0]? arg[0][47] : 0;
  a32=(a79*a32);
  a42=(a42+a32);
  a32=arg[0]? arg[0][13] : 0;
  a81=arg[2]? arg[2][26] : 0;
  a81=(a32!=a81);
  a12=(a12<=a00);
  a74=(a12?a32:0);
  a12=(!a12);
  a34=arg[2]? arg[2][25] : 0;
  a12=(a12?a34:0);
  a74=(a74+a12);
  a12=(a32-a74);
  a34=casadi_fabs(a12);
  a15=(a15*a34);
  a34=casadi_fabs(a32);
  a34=(a73*a34);
  a92=casadi_fabs(a74);
  a73=(a73*a92);
  a34=(a34+a73);
  a15=casadi_fmax(a15,a34);
  a15=(a81?a15:0);
  a81=(!a81);
  a34=arg[2]? arg[2][27] : 0;
  a81=(a81?a34:0);
  a15=(a15+a81);
  a81=casadi_fabs(a12);
  a81=(a15<a81);
  a34=(-a15);
  a73=casadi_fmin(a12,a15);
  a34=casadi_fmax(a34,a73);
  a74=(a74+a34);
  a74=(a81?a74:0);
  a81=(!a81);
  a81=(a81?a32:0);
  a74=(a74+a81);
  a81=arg[0]? arg[0][45] : 0;
  a34=(a81*a14);
  a34=(a34*a29);
  a81=(a81*a82);
  a81=(a81*a35);
  a82=arg[0]? arg[0][32] : 0;
  a81=(a81/a82);
  a34=(a34+a81);
  a34=(a74*a34);
  a42=(a42+a34);
  a76=(a02-a76);
  a76=(a62*a76);
  a76=casadi_fmin(a42,a76);
  a40=casadi_fmax(a40,a76);
  a18=(a18+a40);
  a62=casadi_fmin(a62,a18);
  a49=casadi_fmax(a49,a62);
  a62=casadi_fabs(a49);
  a18=arg[1]? arg[1][25] : 0;
  a62=(a62<=a18);
  a76=(a62?a02:0);
  a76=(a00<a76);
  a34=casadi_fabs(a85);
  a81=arg[1]? arg[1][26] : 0;
  a34=(a34<=a81);
  a82=(a34?a02:0);
  a82=(a00<a82);
  a82=(!a82);
  a29=7002.;
  a82=(a82?a29:0);
  a82=(a76?a82:0);
  a76=(!a76);
  a29=7001.;
  a76=(a76?a29:0);
  a82=(a82+a76);
  a05=(a05?a82:0);
  a26=(a26+a05);
  if (res[0]!=0) res[0][0]=a26;
  a05=(a00<a26);
  a82=arg[1]? arg[1][27] : 0;
  a76=(-a82);
  a76=(a05?a76:0);
  a05=(!a05);
  a05=(a05?a82:0);
  a76=(a76+a05);
  a03=(a03+a76);
  a03=casadi_fmax(a04,a03);
  a03=casadi_fmin(a02,a03);
  if (res[0]!=0) res[0][1]=a03;
  a76=(a00<a26);
  a76=(!a76);
  a76=(a76?a02:0);
  if (res[0]!=0) res[0][2]=a76;
  if (res[0]!=0) res[0][3]=a23;
  if (res[0]!=0) res[0][4]=a19;
  if (res[0]!=0) res[0][5]=a33;
  if (res[0]!=0) res[0][6]=a07;
  if (res[0]!=0) res[0][7]=a36;
  if (res[0]!=0) res[0][8]=a21;
  if (res[0]!=0) res[0][9]=a38;
  if (res[0]!=0) res[0][10]=a10;
  if (res[0]!=0) res[0][11]=a39;
  if (res[0]!=0) res[0][12]=a13;
  if (res[0]!=0) res[0][13]=a41;
  if (res[0]!=0) res[0][14]=a17;
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
  if (res[0]!=0) res[0][22]=a91;
  if (res[0]!=0) res[0][23]=a87;
  a89=casadi_fabs(a89);
  a89=(a90<a89);
  a89=(a89?a90:0);
  if (res[0]!=0) res[0][24]=a89;
  if (res[0]!=0) res[0][25]=a74;
  if (res[0]!=0) res[0][26]=a32;
  a12=casadi_fabs(a12);
  a12=(a15<a12);
  a12=(a12?a15:0);
  if (res[0]!=0) res[0][27]=a12;
  if (res[0]!=0) res[0][28]=a59;
  if (res[0]!=0) res[0][29]=a20;
  a22=casadi_fabs(a22);
  a22=(a68<a22);
  a22=(a22?a68:0);
  if (res[0]!=0) res[0][30]=a22;
  if (res[0]!=0) res[0][31]=a35;
  if (res[0]!=0) res[0][32]=a30;
  if (res[0]!=0) res[0][33]=a55;
  if (res[0]!=0) res[0][34]=a10;
  if (res[0]!=0) res[0][35]=a09;
  if (res[0]!=0) res[0][36]=a13;
  if (res[0]!=0) res[0][37]=a16;
  if (res[0]!=0) res[0][38]=a48;
  if (res[0]!=0) res[0][39]=a47;
  if (res[0]!=0) res[0][40]=a31;
  if (res[0]!=0) res[0][41]=a14;
  if (res[0]!=0) res[0][42]=a53;
  if (res[0]!=0) res[0][43]=a17;
  if (res[0]!=0) res[0][44]=a52;
  if (res[0]!=0) res[0][45]=a54;
  a54=arg[1]? arg[1][16] : 0;
  a57=(a57*a54);
  a58=(a58+a57);
  if (res[0]!=0) res[0][46]=a58;
  if (res[0]!=0) res[0][47]=a60;
  if (res[0]!=0) res[0][48]=a37;
  a63=(a63*a54);
  a64=(a64+a63);
  if (res[0]!=0) res[0][49]=a64;
  if (res[0]!=0) res[0][50]=a66;
  if (res[0]!=0) res[0][51]=a61;
  a56=(a56?a69:0);
  a08=(a08*a54);
  a56=(a56+a08);
  if (res[0]!=0) res[0][52]=a56;
  if (res[0]!=0) res[0][53]=a71;
  if (res[0]!=0) res[0][54]=a65;
  a72=(a72?a67:0);
  a51=(a51*a54);
  a72=(a72+a51);
  if (res[0]!=0) res[0][55]=a72;
  if (res[0]!=0) res[0][56]=a75;
  if (res[0]!=0) res[0][57]=a70;
  if (res[0]!=0) res[0][58]=a88;
  if (res[0]!=0) res[0][59]=a78;
  a84=(a85-a84);
  a78=arg[1]? arg[1][20] : 0;
  a84=(a84*a78);
  a83=(a83+a84);
  a84=arg[1]? arg[1][19] : 0;
  a86=(a86*a84);
  a83=(a83+a86);
  if (res[0]!=0) res[0][60]=a83;
  if (res[0]!=0) res[0][61]=a77;
  if (res[0]!=0) res[0][62]=a80;
  a42=(a42-a40);
  a42=(a79*a42);
  a04=(a04<a42);
  a42=(a04?a27:0);
  a04=(!a04);
  a40=arg[0]? arg[0][53] : 0;
  a80=(-a40);
  a77=arg[1]? arg[1][24] : 0;
  a79=(a79*a77);
  a27=(a27+a79);
  a40=casadi_fmin(a40,a27);
  a80=casadi_fmax(a80,a40);
  a04=(a04?a80:0);
  a42=(a42+a04);
  if (res[0]!=0) res[0][63]=a42;
  a42=2.9995000000000000e+03;
  a04=(a42<a26);
  a80=arg[2]? arg[2][66] : 0;
  a40=arg[1]? arg[1][28] : 0;
  a27=(a26<=a00);
  a49=(a62?a49:0);
  a62=(!a62);
  a62=(a62?a24:0);
  a49=(a49+a62);
  a49=(a27?a49:0);
  a27=(!a27);
  a27=(a27?a24:0);
  a49=(a49+a27);
  a27=(a49-a80);
  a27=(a40*a27);
  a27=(a80+a27);
  a24=casadi_fabs(a27);
  a24=(a24<=a18);
  a27=(a24?a27:0);
  a24=(!a24);
  a24=(a24?a80:0);
  a27=(a27+a24);
  a24=(a04?a27:0);
  a04=(!a04);
  a04=(a04?a49:0);
  a24=(a24+a04);
  if (res[0]!=0) res[0][64]=a24;
  a42=(a42<a26);
  a04=arg[2]? arg[2][67] : 0;
  a26=(a26<=a00);
  a85=(a34?a85:0);
  a34=(!a34);
  a34=(a34?a50:0);
  a85=(a85+a34);
  a85=(a26?a85:0);
  a26=(!a26);
  a26=(a26?a50:0);
  a85=(a85+a26);
  a26=(a85-a04);
  a40=(a40*a26);
  a40=(a04+a40);
  a26=casadi_fabs(a40);
  a26=(a26<=a81);
  a40=(a26?a40:0);
  a26=(!a26);
  a26=(a26?a04:0);
  a40=(a40+a26);
  a26=(a42?a40:0);
  a42=(!a42);
  a42=(a42?a85:0);
  a26=(a26+a42);
  if (res[0]!=0) res[0][65]=a26;
  if (res[0]!=0) res[0][66]=a27;
  if (res[0]!=0) res[0][67]=a40;
  a40=-900.;
  a27=900.;
  a24=(a24*a03);
  a27=casadi_fmin(a27,a24);
  a40=casadi_fmax(a40,a27);
  if (res[1]!=0) res[1][0]=a40;
  a40=-3300.;
  a27=3300.;
  a26=(a26*a03);
  a27=casadi_fmin(a27,a26);
  a40=casadi_fmax(a40,a27);
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


