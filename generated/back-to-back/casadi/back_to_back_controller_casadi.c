/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) back_to_back_controller_casadi_ ## ID
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
CASADI_SYMBOL_EXPORT void back_to_back_controller_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int back_to_back_controller_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int back_to_back_controller_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {50, 1, 1};
static const casadi_int casadi_s1[3] = {28, 1, 1};
static const casadi_int casadi_s2[3] = {65, 1, 1};
static const casadi_int casadi_s3[3] = {7, 1, 1};
static const casadi_int casadi_s4[3] = {2, 1, 1};

static const casadi_real casadi_zeros[50] = 
  {0.};

/* controller_prepare:(parameters[50])->(derived[28]) */
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
  /* #7: @1 = @0[13] */
  w1 = wr0[13];
  /* #8: @1 = (@2/@1) */
  w1  = (w2/w1);
  /* #9: output[0][1] = @1 */
  if (res[0]) res[0][1] = w1;
  /* #10: @1 = @0[17] */
  w1 = wr0[17];
  /* #11: @3 = (1./@1) */
  w3 = (1./ w1 );
  /* #12: output[0][2] = @3 */
  if (res[0]) res[0][2] = w3;
  /* #13: @3 = 1 */
  w3 = 1.;
  /* #14: @4 = @0[16] */
  w4 = wr0[16];
  /* #15: @4 = (@4/@1) */
  w4 /= w1;
  /* #16: @3 = (@3+@4) */
  w3 += w4;
  /* #17: output[0][3] = @3 */
  if (res[0]) res[0][3] = w3;
  /* #18: @3 = @0[15] */
  w3 = wr0[15];
  /* #19: @4 = @0[18] */
  w4 = wr0[18];
  /* #20: @3 = (@3*@4) */
  w3 *= w4;
  /* #21: output[0][4] = @3 */
  if (res[0]) res[0][4] = w3;
  /* #22: @3 = @0[21] */
  w3 = wr0[21];
  /* #23: @1 = (1./@3) */
  w1 = (1./ w3 );
  /* #24: output[0][5] = @1 */
  if (res[0]) res[0][5] = w1;
  /* #25: @1 = 1 */
  w1 = 1.;
  /* #26: @5 = @0[20] */
  w5 = wr0[20];
  /* #27: @5 = (@5/@3) */
  w5 /= w3;
  /* #28: @1 = (@1+@5) */
  w1 += w5;
  /* #29: output[0][6] = @1 */
  if (res[0]) res[0][6] = w1;
  /* #30: @1 = @0[19] */
  w1 = wr0[19];
  /* #31: @5 = @0[22] */
  w5 = wr0[22];
  /* #32: @1 = (@1*@5) */
  w1 *= w5;
  /* #33: output[0][7] = @1 */
  if (res[0]) res[0][7] = w1;
  /* #34: @1 = @0[23] */
  w1 = wr0[23];
  /* #35: @1 = (@1*@2) */
  w1 *= w2;
  /* #36: output[0][8] = @1 */
  if (res[0]) res[0][8] = w1;
  /* #37: @1 = @0[24] */
  w1 = wr0[24];
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
  /* #43: @1 = @0[28] */
  w1 = wr0[28];
  /* #44: @3 = (@2/@1) */
  w3  = (w2/w1);
  /* #45: output[0][11] = @3 */
  if (res[0]) res[0][11] = w3;
  /* #46: @3 = 0.05 */
  w3 = 5.0000000000000003e-02;
  /* #47: @3 = (@3*@5) */
  w3 *= w5;
  /* #48: output[0][12] = @3 */
  if (res[0]) res[0][12] = w3;
  /* #49: @3 = @0[31] */
  w3 = wr0[31];
  /* #50: @6 = (@3*@2) */
  w6  = (w3*w2);
  /* #51: output[0][13] = @6 */
  if (res[0]) res[0][13] = w6;
  /* #52: @6 = 6.2832 */
  w6 = 6.2831999999999999e+00;
  /* #53: @6 = (@6*@3) */
  w6 *= w3;
  /* #54: @6 = (@6*@2) */
  w6 *= w2;
  /* #55: output[0][14] = @6 */
  if (res[0]) res[0][14] = w6;
  /* #56: @6 = @0[36] */
  w6 = wr0[36];
  /* #57: @6 = (@6*@2) */
  w6 *= w2;
  /* #58: output[0][15] = @6 */
  if (res[0]) res[0][15] = w6;
  /* #59: @6 = @0[37] */
  w6 = wr0[37];
  /* #60: @6 = (@6*@2) */
  w6 *= w2;
  /* #61: output[0][16] = @6 */
  if (res[0]) res[0][16] = w6;
  /* #62: @6 = @0[39] */
  w6 = wr0[39];
  /* #63: @3 = (@6*@2) */
  w3  = (w6*w2);
  /* #64: output[0][17] = @3 */
  if (res[0]) res[0][17] = w3;
  /* #65: @6 = (@6*@2) */
  w6 *= w2;
  /* #66: @3 = @0[38] */
  w3 = wr0[38];
  /* #67: @6 = (@6/@3) */
  w6 /= w3;
  /* #68: output[0][18] = @6 */
  if (res[0]) res[0][18] = w6;
  /* #69: @6 = @0[40] */
  w6 = wr0[40];
  /* #70: @6 = (@6/@1) */
  w6 /= w1;
  /* #71: output[0][19] = @6 */
  if (res[0]) res[0][19] = w6;
  /* #72: @6 = @0[44] */
  w6 = wr0[44];
  /* #73: @6 = (@6*@2) */
  w6 *= w2;
  /* #74: @3 = @0[41] */
  w3 = wr0[41];
  /* #75: @6 = (@6/@3) */
  w6 /= w3;
  /* #76: output[0][20] = @6 */
  if (res[0]) res[0][20] = w6;
  /* #77: @6 = @0[45] */
  w6 = wr0[45];
  /* #78: @6 = (@6*@2) */
  w6 *= w2;
  /* #79: @6 = (@6/@3) */
  w6 /= w3;
  /* #80: output[0][21] = @6 */
  if (res[0]) res[0][21] = w6;
  /* #81: @3 = (@3/@1) */
  w3 /= w1;
  /* #82: output[0][22] = @3 */
  if (res[0]) res[0][22] = w3;
  /* #83: @3 = @0[47] */
  w3 = wr0[47];
  /* #84: @3 = (@3*@2) */
  w3 *= w2;
  /* #85: output[0][23] = @3 */
  if (res[0]) res[0][23] = w3;
  /* #86: @3 = 1.01 */
  w3 = 1.0100000000000000e+00;
  /* #87: @1 = 3050 */
  w1 = 3050.;
  /* #88: @1 = fmin(@1,@4) */
  w1  = casadi_fmin(w1,w4);
  /* #89: @3 = (@3*@1) */
  w3 *= w1;
  /* #90: output[0][24] = @3 */
  if (res[0]) res[0][24] = w3;
  /* #91: @3 = 1.01 */
  w3 = 1.0100000000000000e+00;
  /* #92: @1 = 3050 */
  w1 = 3050.;
  /* #93: @1 = fmin(@1,@5) */
  w1  = casadi_fmin(w1,w5);
  /* #94: @3 = (@3*@1) */
  w3 *= w1;
  /* #95: output[0][25] = @3 */
  if (res[0]) res[0][25] = w3;
  /* #96: @3 = @0[1] */
  w3 = wr0[1];
  /* #97: @3 = (@2/@3) */
  w3  = (w2/w3);
  /* #98: output[0][26] = @3 */
  if (res[0]) res[0][26] = w3;
  /* #99: @3 = 0.02 */
  w3 = 2.0000000000000000e-02;
  /* #100: @3 = (@3+@2) */
  w3 += w2;
  /* #101: @2 = (@2/@3) */
  w2 /= w3;
  /* #102: output[0][27] = @2 */
  if (res[0]) res[0][27] = w2;
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

/* controller_step:(parameters[50],derived[28],states[65],inputs[7])->(next_states[65],outputs[2]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
  casadi_real a84, a85, a86, a87, a88;
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
  a07=arg[3]? arg[3][5] : 0;
  a09=casadi_fabs(a07);
  a13=arg[0]? arg[0][8] : 0;
  a09=(a09<=a13);
  a14=(a09?a07:0);
  a15=(!a09);
  a16=arg[2]? arg[2][14] : 0;
  a15=(a15?a16:0);
  a14=(a14+a15);
  a15=casadi_fabs(a14);
  a16=arg[0]? arg[0][10] : 0;
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
  a13=arg[3]? arg[3][3] : 0;
  a17=casadi_fabs(a13);
  a18=arg[0]? arg[0][6] : 0;
  a17=(a17<=a18);
  a11=(a11&&a17);
  a17=arg[3]? arg[3][0] : 0;
  a19=casadi_fabs(a17);
  a20=arg[0]? arg[0][3] : 0;
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
  a27=casadi_fabs(a17);
  a27=(a27<=a20);
  a20=(a27?a02:0);
  a20=(a00<a20);
  a28=arg[2]? arg[2][5] : 0;
  a29=arg[0]? arg[0][2] : 0;
  a28=casadi_fmin(a28,a29);
  a30=arg[0]? arg[0][0] : 0;
  a31=casadi_fmax(a28,a30);
  a31=(a31-a30);
  a31=(a20?a31:0);
  a20=(!a20);
  a28=(a28+a30);
  a20=(a20?a28:0);
  a31=(a31+a20);
  a20=arg[1]? arg[1][0] : 0;
  a28=(a31<=a20);
  a32=casadi_fabs(a07);
  a32=(a32<=a15);
  a15=(a32?a02:0);
  a15=(a00<a15);
  a33=arg[2]? arg[2][7] : 0;
  a33=casadi_fmin(a33,a29);
  a34=casadi_fmax(a33,a30);
  a34=(a34-a30);
  a34=(a15?a34:0);
  a15=(!a15);
  a33=(a33+a30);
  a15=(a15?a33:0);
  a34=(a34+a15);
  a15=(a34<=a20);
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
  a08=(a35<=a20);
  a33=casadi_fabs(a13);
  a33=(a33<=a18);
  a18=(a33?a02:0);
  a18=(a00<a18);
  a36=arg[2]? arg[2][11] : 0;
  a36=casadi_fmin(a36,a29);
  a37=casadi_fmax(a36,a30);
  a37=(a37-a30);
  a37=(a18?a37:0);
  a18=(!a18);
  a36=(a36+a30);
  a18=(a18?a36:0);
  a37=(a37+a18);
  a18=(a37<=a20);
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
  a22=(a39<=a20);
  a09=(a09?a02:0);
  a09=(a00<a09);
  a38=arg[2]? arg[2][15] : 0;
  a38=casadi_fmin(a38,a29);
  a40=casadi_fmax(a38,a30);
  a40=(a40-a30);
  a40=(a09?a40:0);
  a09=(!a09);
  a38=(a38+a30);
  a09=(a09?a38:0);
  a40=(a40+a09);
  a09=(a40<=a20);
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
  a38=(a41<=a20);
  a12=casadi_fabs(a14);
  a12=(a12<=a16);
  a12=(a12?a02:0);
  a12=(a00<a12);
  a16=arg[2]? arg[2][17] : 0;
  a16=casadi_fmin(a16,a29);
  a42=casadi_fmax(a16,a30);
  a42=(a42-a30);
  a42=(a12?a42:0);
  a12=(!a12);
  a16=(a16+a30);
  a12=(a12?a16:0);
  a42=(a42+a12);
  a12=(a42<=a20);
  a12=(!a12);
  a16=4006.;
  a12=(a12?a16:0);
  a12=(a38?a12:0);
  a38=(!a38);
  a16=4003.;
  a38=(a38?a16:0);
  a12=(a12+a38);
  a12=(a09?a12:0);
  a09=(!a09);
  a38=6.;
  a09=(a09?a38:0);
  a12=(a12+a09);
  a12=(a22?a12:0);
  a22=(!a22);
  a09=5.;
  a22=(a22?a09:0);
  a12=(a12+a22);
  a12=(a18?a12:0);
  a18=(!a18);
  a22=4.;
  a18=(a18?a22:0);
  a12=(a12+a18);
  a12=(a08?a12:0);
  a08=(!a08);
  a18=3.;
  a08=(a08?a18:0);
  a12=(a12+a08);
  a12=(a15?a12:0);
  a15=(!a15);
  a08=2.;
  a15=(a15?a08:0);
  a12=(a12+a15);
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
  a15=(a28?a10:0);
  a28=(!a28);
  a08=arg[2]? arg[2][29] : 0;
  a28=(a28?a08:0);
  a15=(a15+a28);
  a28=arg[1]? arg[1][9] : 0;
  a08=arg[2]? arg[2][61] : 0;
  a18=(a08*a03);
  a13=(a33?a13:0);
  a33=(!a33);
  a22=arg[2]? arg[2][10] : 0;
  a33=(a33?a22:0);
  a13=(a13+a33);
  a33=(a18-a13);
  a28=(a28*a33);
  a28=(a15+a28);
  a33=arg[1]? arg[1][8] : 0;
  a15=(a10-a15);
  a15=(a33*a15);
  a28=(a28+a15);
  a15=(a28-a10);
  a15=casadi_fabs(a15);
  a22=arg[0]? arg[0][26] : 0;
  a09=(a15<=a22);
  a38=arg[2]? arg[2][31] : 0;
  a38=(a10==a38);
  a16=(a12<=a00);
  a16=(!a16);
  a43=arg[2]? arg[2][32] : 0;
  a16=(a16?a43:0);
  a16=(a16+a30);
  a38=(a38?a16:0);
  a16=arg[0]? arg[0][27] : 0;
  a43=(a38<=a16);
  a09=(a09||a43);
  a22=(a15<=a22);
  a43=arg[2]? arg[2][33] : 0;
  a43=(a13==a43);
  a44=(a12<=a00);
  a44=(!a44);
  a45=arg[2]? arg[2][34] : 0;
  a44=(a44?a45:0);
  a44=(a44+a30);
  a43=(a43?a44:0);
  a44=(a43<=a16);
  a22=(a22||a44);
  a44=(a04<a43);
  a45=arg[2]? arg[2][35] : 0;
  a45=(a44?a45:0);
  a44=(!a44);
  a44=(a44?a18:0);
  a45=(a45+a44);
  a44=(a18-a45);
  a44=casadi_fabs(a44);
  a46=arg[1]? arg[1][10] : 0;
  a44=(a44<=a46);
  a22=(a22||a44);
  a44=(a12<=a00);
  a46=(a44?a14:0);
  a44=(!a44);
  a47=arg[2]? arg[2][36] : 0;
  a44=(a44?a47:0);
  a46=(a46+a44);
  a44=arg[1]? arg[1][11] : 0;
  a47=arg[2]? arg[2][62] : 0;
  a48=(a47*a03);
  a19=(a36?a19:0);
  a36=(!a36);
  a49=arg[2]? arg[2][12] : 0;
  a36=(a36?a49:0);
  a19=(a19+a36);
  a36=(a48+a19);
  a44=(a44*a36);
  a44=(a46+a44);
  a46=(a14-a46);
  a33=(a33*a46);
  a44=(a44+a33);
  a33=(a44-a14);
  a33=casadi_fabs(a33);
  a46=arg[0]? arg[0][30] : 0;
  a36=(a33<=a46);
  a49=arg[2]? arg[2][40] : 0;
  a49=(a19==a49);
  a50=(a12<=a00);
  a50=(!a50);
  a51=arg[2]? arg[2][41] : 0;
  a50=(a50?a51:0);
  a50=(a50+a30);
  a49=(a49?a50:0);
  a50=(a49<=a16);
  a36=(a36||a50);
  a50=(a04<a49);
  a51=arg[2]? arg[2][42] : 0;
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
  a50=arg[2]? arg[2][38] : 0;
  a50=(a14==a50);
  a52=(a12<=a00);
  a52=(!a52);
  a53=arg[2]? arg[2][39] : 0;
  a52=(a52?a53:0);
  a52=(a52+a30);
  a50=(a50?a52:0);
  a16=(a50<=a16);
  a46=(a46||a16);
  a16=arg[0]? arg[0][25] : 0;
  a15=(a15<=a16);
  a15=(a15?a02:0);
  a15=(a00<a15);
  a16=arg[2]? arg[2][30] : 0;
  a16=casadi_fmin(a16,a29);
  a52=casadi_fmax(a16,a30);
  a52=(a52-a30);
  a52=(a15?a52:0);
  a15=(!a15);
  a16=(a16+a30);
  a15=(a15?a16:0);
  a52=(a52+a15);
  a15=(a52<=a20);
  a16=arg[0]? arg[0][29] : 0;
  a33=(a33<=a16);
  a33=(a33?a02:0);
  a33=(a00<a33);
  a16=arg[2]? arg[2][37] : 0;
  a16=casadi_fmin(a16,a29);
  a29=casadi_fmax(a16,a30);
  a29=(a29-a30);
  a29=(a33?a29:0);
  a33=(!a33);
  a16=(a16+a30);
  a33=(a33?a16:0);
  a29=(a29+a33);
  a20=(a29<=a20);
  a33=(a12<=a00);
  a33=(!a33);
  a16=arg[2]? arg[2][45] : 0;
  a33=(a33?a16:0);
  a16=arg[1]? arg[1][13] : 0;
  a33=(a33-a16);
  a33=casadi_fmax(a04,a33);
  a53=arg[0]? arg[0][32] : 0;
  a54=(a12<=a00);
  a55=(a54?a13:0);
  a54=(!a54);
  a56=arg[2]? arg[2][43] : 0;
  a54=(a54?a56:0);
  a55=(a55+a54);
  a54=(a13-a55);
  a56=(a53<a54);
  a57=(a56?a02:0);
  a56=(!a56);
  a53=(-a53);
  a53=(a54<a53);
  a58=(a53?a25:0);
  a53=(!a53);
  a59=arg[2]? arg[2][44] : 0;
  a53=(a53?a59:0);
  a58=(a58+a53);
  a56=(a56?a58:0);
  a57=(a57+a56);
  a59=(a57==a59);
  a59=(!a59);
  a59=(a59?a02:0);
  a33=(a33+a59);
  a59=5.5000000000000000e+00;
  a56=(a33<=a59);
  a58=(a12<=a00);
  a58=(!a58);
  a53=arg[2]? arg[2][48] : 0;
  a58=(a58?a53:0);
  a58=(a58-a16);
  a58=casadi_fmax(a04,a58);
  a53=arg[0]? arg[0][33] : 0;
  a60=(a12<=a00);
  a61=(a60?a19:0);
  a60=(!a60);
  a62=arg[2]? arg[2][46] : 0;
  a60=(a60?a62:0);
  a61=(a61+a60);
  a60=(a19-a61);
  a62=(a53<a60);
  a63=(a62?a02:0);
  a62=(!a62);
  a53=(-a53);
  a53=(a60<a53);
  a64=(a53?a25:0);
  a53=(!a53);
  a65=arg[2]? arg[2][47] : 0;
  a53=(a53?a65:0);
  a64=(a64+a53);
  a62=(a62?a64:0);
  a63=(a63+a62);
  a65=(a63==a65);
  a65=(!a65);
  a65=(a65?a02:0);
  a58=(a58+a65);
  a65=(a58<=a59);
  a62=(a12<=a00);
  a62=(!a62);
  a64=arg[2]? arg[2][51] : 0;
  a62=(a62?a64:0);
  a62=(a62-a16);
  a62=casadi_fmax(a04,a62);
  a64=arg[0]? arg[0][34] : 0;
  a53=(a12<=a00);
  a53=(!a53);
  a66=arg[2]? arg[2][49] : 0;
  a67=(-a66);
  a67=(a53?a67:0);
  a18=(a18+a67);
  a67=(a64<a18);
  a68=(a67?a02:0);
  a67=(!a67);
  a64=(-a64);
  a64=(a18<a64);
  a69=(a64?a25:0);
  a64=(!a64);
  a70=arg[2]? arg[2][50] : 0;
  a64=(a64?a70:0);
  a69=(a69+a64);
  a67=(a67?a69:0);
  a68=(a68+a67);
  a70=(a68==a70);
  a70=(!a70);
  a70=(a70?a02:0);
  a62=(a62+a70);
  a70=(a62<=a59);
  a67=(a12<=a00);
  a67=(!a67);
  a69=arg[2]? arg[2][54] : 0;
  a67=(a67?a69:0);
  a67=(a67-a16);
  a67=casadi_fmax(a04,a67);
  a16=arg[0]? arg[0][35] : 0;
  a69=(a12<=a00);
  a69=(!a69);
  a64=arg[2]? arg[2][52] : 0;
  a71=(-a64);
  a71=(a69?a71:0);
  a48=(a48+a71);
  a71=(a16<a48);
  a72=(a71?a02:0);
  a71=(!a71);
  a16=(-a16);
  a16=(a48<a16);
  a25=(a16?a25:0);
  a16=(!a16);
  a73=arg[2]? arg[2][53] : 0;
  a16=(a16?a73:0);
  a25=(a25+a16);
  a71=(a71?a25:0);
  a72=(a72+a71);
  a73=(a72==a73);
  a73=(!a73);
  a73=(a73?a02:0);
  a67=(a67+a73);
  a59=(a67<=a59);
  a59=(!a59);
  a73=8002.;
  a59=(a59?a73:0);
  a59=(a70?a59:0);
  a70=(!a70);
  a73=8001.;
  a70=(a70?a73:0);
  a59=(a59+a70);
  a59=(a65?a59:0);
  a65=(!a65);
  a70=6005.;
  a65=(a65?a70:0);
  a59=(a59+a65);
  a59=(a56?a59:0);
  a56=(!a56);
  a65=6004.;
  a56=(a56?a65:0);
  a59=(a59+a56);
  a59=(a20?a59:0);
  a20=(!a20);
  a56=5006.;
  a20=(a20?a56:0);
  a59=(a59+a20);
  a59=(a15?a59:0);
  a15=(!a15);
  a20=5003.;
  a15=(a15?a20:0);
  a59=(a59+a15);
  a59=(a46?a59:0);
  a46=(!a46);
  a15=3006.;
  a46=(a46?a15:0);
  a59=(a59+a46);
  a59=(a36?a59:0);
  a36=(!a36);
  a46=3005.;
  a36=(a36?a46:0);
  a59=(a59+a36);
  a59=(a22?a59:0);
  a22=(!a22);
  a36=3004.;
  a22=(a22?a36:0);
  a59=(a59+a22);
  a59=(a09?a59:0);
  a09=(!a09);
  a22=3003.;
  a09=(a09?a22:0);
  a59=(a59+a09);
  a05=(a05?a59:0);
  a24=(a24+a05);
  a05=(a00<a24);
  a24=(a05?a24:0);
  a05=(!a05);
  a59=arg[1]? arg[1][4] : 0;
  a09=arg[0]? arg[0][15] : 0;
  a22=casadi_fabs(a10);
  a09=casadi_fmax(a09,a22);
  a59=(a59/a09);
  a09=arg[1]? arg[1][3] : 0;
  a22=arg[1]? arg[1][2] : 0;
  a36=(a10*a22);
  a36=(a09+a36);
  a36=casadi_fmin(a02,a36);
  a36=casadi_fmax(a04,a36);
  a36=(a59*a36);
  a46=(-a36);
  a22=(a10*a22);
  a09=(a09-a22);
  a09=casadi_fmin(a02,a09);
  a09=casadi_fmax(a04,a09);
  a59=(a59*a09);
  a09=arg[0]? arg[0][14] : 0;
  a22=arg[2]? arg[2][27] : 0;
  a22=(a09!=a22);
  a15=arg[1]? arg[1][1] : 0;
  a20=(a12<=a00);
  a56=(a20?a09:0);
  a20=(!a20);
  a65=arg[2]? arg[2][26] : 0;
  a20=(a20?a65:0);
  a56=(a56+a20);
  a20=(a09-a56);
  a65=casadi_fabs(a20);
  a65=(a15*a65);
  a70=9.9999999999999995e-07;
  a73=casadi_fabs(a09);
  a73=(a70*a73);
  a71=casadi_fabs(a56);
  a71=(a70*a71);
  a73=(a73+a71);
  a65=casadi_fmax(a65,a73);
  a65=(a22?a65:0);
  a22=(!a22);
  a73=arg[2]? arg[2][28] : 0;
  a22=(a22?a73:0);
  a65=(a65+a22);
  a22=casadi_fabs(a20);
  a22=(a65<a22);
  a73=(-a65);
  a71=casadi_fmin(a20,a65);
  a73=casadi_fmax(a73,a71);
  a56=(a56+a73);
  a56=(a22?a56:0);
  a22=(!a22);
  a22=(a22?a09:0);
  a56=(a56+a22);
  a22=(a14-a10);
  a22=(a56*a22);
  a73=arg[0]? arg[0][48] : 0;
  a71=(a02-a73);
  a36=(a36*a71);
  a36=(-a36);
  a71=(a12<=a00);
  a71=(!a71);
  a25=arg[2]? arg[2][60] : 0;
  a71=(a71?a25:0);
  a25=arg[0]? arg[0][42] : 0;
  a16=(a12<=a00);
  a74=(a16?a13:0);
  a16=(!a16);
  a75=arg[2]? arg[2][56] : 0;
  a16=(a16?a75:0);
  a74=(a74+a16);
  a16=arg[1]? arg[1][16] : 0;
  a75=(-a16);
  a17=(a27?a17:0);
  a27=(!a27);
  a76=arg[2]? arg[2][4] : 0;
  a27=(a27?a76:0);
  a17=(a17+a27);
  a27=(a17-a74);
  a16=casadi_fmin(a16,a27);
  a75=casadi_fmax(a75,a16);
  a74=(a74+a75);
  a25=(a25*a74);
  a25=(a71+a25);
  a75=(a12<=a00);
  a16=(a75?a13:0);
  a75=(!a75);
  a27=arg[2]? arg[2][58] : 0;
  a75=(a75?a27:0);
  a16=(a16+a75);
  a75=(a12<=a00);
  a75=(!a75);
  a27=arg[2]? arg[2][59] : 0;
  a76=(a75?a27:0);
  a77=arg[1]? arg[1][20] : 0;
  a78=(a74-a16);
  a77=(a77*a78);
  a76=(a76+a77);
  a77=arg[1]? arg[1][21] : 0;
  a77=(a77*a27);
  a77=(-a77);
  a75=(a75?a77:0);
  a76=(a76+a75);
  a30=(a76*a30);
  a16=(a16+a30);
  a30=arg[0]? arg[0][46] : 0;
  a75=(a16*a30);
  a77=arg[1]? arg[1][19] : 0;
  a27=arg[1]? arg[1][7] : 0;
  a78=arg[0]? arg[0][19] : 0;
  a79=casadi_fabs(a14);
  a78=casadi_fmax(a78,a79);
  a27=(a27/a78);
  a78=arg[1]? arg[1][6] : 0;
  a79=arg[1]? arg[1][5] : 0;
  a80=(a14*a79);
  a80=(a78+a80);
  a80=casadi_fmin(a02,a80);
  a80=casadi_fmax(a04,a80);
  a80=(a27*a80);
  a80=(-a80);
  a79=(a14*a79);
  a78=(a78-a79);
  a78=casadi_fmin(a02,a78);
  a78=casadi_fmax(a04,a78);
  a27=(a27*a78);
  a78=(a12<=a00);
  a78=(!a78);
  a79=arg[2]? arg[2][57] : 0;
  a78=(a78?a79:0);
  a79=arg[0]? arg[0][39] : 0;
  a79=(a04<a79);
  a81=(a12<=a00);
  a82=arg[0]? arg[0][11] : 0;
  a83=(a81?a82:0);
  a81=(!a81);
  a84=arg[2]? arg[2][20] : 0;
  a81=(a81?a84:0);
  a83=(a83+a81);
  a81=arg[2]? arg[2][21] : 0;
  a81=(a82!=a81);
  a84=(a82-a83);
  a85=casadi_fabs(a84);
  a85=(a15*a85);
  a86=casadi_fabs(a82);
  a86=(a70*a86);
  a87=casadi_fabs(a83);
  a87=(a70*a87);
  a86=(a86+a87);
  a85=casadi_fmax(a85,a86);
  a85=(a81?a85:0);
  a81=(!a81);
  a86=arg[2]? arg[2][22] : 0;
  a81=(a81?a86:0);
  a85=(a85+a81);
  a81=casadi_fabs(a84);
  a81=(a85<a81);
  a86=(-a85);
  a87=casadi_fmin(a84,a85);
  a86=casadi_fmax(a86,a87);
  a86=(a83+a86);
  a86=(a81?a86:0);
  a81=(!a81);
  a81=(a81?a82:0);
  a86=(a86+a81);
  a83=(a83-a86);
  a83=(a19*a83);
  a83=(-a83);
  a79=(a79?a83:0);
  a78=(a78+a79);
  a79=(a12<=a00);
  a83=(a79?a14:0);
  a79=(!a79);
  a81=arg[2]? arg[2][55] : 0;
  a79=(a79?a81:0);
  a83=(a83+a79);
  a79=arg[1]? arg[1][15] : 0;
  a81=(-a79);
  a07=(a32?a07:0);
  a32=(!a32);
  a87=arg[2]? arg[2][6] : 0;
  a32=(a32?a87:0);
  a07=(a07+a32);
  a32=(a07-a83);
  a79=casadi_fmin(a79,a32);
  a81=casadi_fmax(a81,a79);
  a83=(a83+a81);
  a81=(a83-a14);
  a79=arg[0]? arg[0][38] : 0;
  a79=(a81*a79);
  a79=(a78+a79);
  a32=(a19*a86);
  a79=(a79-a32);
  a27=casadi_fmin(a27,a79);
  a80=casadi_fmax(a80,a27);
  a27=(a80+a19);
  a77=(a77*a27);
  a77=(a13+a77);
  a75=(a75-a77);
  a30=(a02-a30);
  a30=(a74*a30);
  a75=(a75+a30);
  a30=arg[0]? arg[0][43] : 0;
  a30=(a75*a30);
  a25=(a25+a30);
  a30=arg[1]? arg[1][22] : 0;
  a30=(a30*a27);
  a27=arg[0]? arg[0][12] : 0;
  a77=arg[2]? arg[2][24] : 0;
  a77=(a27!=a77);
  a12=(a12<=a00);
  a32=(a12?a27:0);
  a12=(!a12);
  a87=arg[2]? arg[2][23] : 0;
  a12=(a12?a87:0);
  a32=(a32+a12);
  a12=(a27-a32);
  a87=casadi_fabs(a12);
  a15=(a15*a87);
  a87=casadi_fabs(a27);
  a87=(a70*a87);
  a88=casadi_fabs(a32);
  a70=(a70*a88);
  a87=(a87+a70);
  a15=casadi_fmax(a15,a87);
  a15=(a77?a15:0);
  a77=(!a77);
  a87=arg[2]? arg[2][25] : 0;
  a77=(a77?a87:0);
  a15=(a15+a77);
  a77=casadi_fabs(a12);
  a77=(a15<a77);
  a87=(-a15);
  a70=casadi_fmin(a12,a15);
  a87=casadi_fmax(a87,a70);
  a32=(a32+a87);
  a32=(a77?a32:0);
  a77=(!a77);
  a77=(a77?a27:0);
  a32=(a32+a77);
  a30=(a30*a32);
  a25=(a25+a30);
  a73=(a02-a73);
  a73=(a59*a73);
  a73=casadi_fmin(a25,a73);
  a36=casadi_fmax(a36,a73);
  a22=(a22+a36);
  a59=casadi_fmin(a59,a22);
  a46=casadi_fmax(a46,a59);
  a59=casadi_fabs(a46);
  a22=arg[1]? arg[1][24] : 0;
  a59=(a59<=a22);
  a73=(a59?a02:0);
  a73=(a00<a73);
  a30=casadi_fabs(a80);
  a77=arg[1]? arg[1][25] : 0;
  a30=(a30<=a77);
  a87=(a30?a02:0);
  a87=(a00<a87);
  a87=(!a87);
  a70=7002.;
  a87=(a87?a70:0);
  a87=(a73?a87:0);
  a73=(!a73);
  a70=7001.;
  a73=(a73?a70:0);
  a87=(a87+a73);
  a05=(a05?a87:0);
  a24=(a24+a05);
  if (res[0]!=0) res[0][0]=a24;
  a05=(a00<a24);
  a87=arg[1]? arg[1][26] : 0;
  a73=(-a87);
  a73=(a05?a73:0);
  a05=(!a05);
  a05=(a05?a87:0);
  a73=(a73+a05);
  a03=(a03+a73);
  a03=casadi_fmax(a04,a03);
  a03=casadi_fmin(a02,a03);
  if (res[0]!=0) res[0][1]=a03;
  a73=(a00<a24);
  a73=(!a73);
  a73=(a73?a02:0);
  if (res[0]!=0) res[0][2]=a73;
  if (res[0]!=0) res[0][3]=a21;
  if (res[0]!=0) res[0][4]=a17;
  if (res[0]!=0) res[0][5]=a31;
  if (res[0]!=0) res[0][6]=a07;
  if (res[0]!=0) res[0][7]=a34;
  if (res[0]!=0) res[0][8]=a10;
  if (res[0]!=0) res[0][9]=a35;
  if (res[0]!=0) res[0][10]=a13;
  if (res[0]!=0) res[0][11]=a37;
  if (res[0]!=0) res[0][12]=a19;
  if (res[0]!=0) res[0][13]=a39;
  if (res[0]!=0) res[0][14]=a14;
  if (res[0]!=0) res[0][15]=a40;
  if (res[0]!=0) res[0][16]=a41;
  if (res[0]!=0) res[0][17]=a42;
  if (res[0]!=0) res[0][18]=a26;
  a01=(a00<a01);
  a11=(a11?a23:0);
  a06=(a06?a11:0);
  a01=(a01?a06:0);
  if (res[0]!=0) res[0][19]=a01;
  if (res[0]!=0) res[0][20]=a86;
  if (res[0]!=0) res[0][21]=a82;
  a84=casadi_fabs(a84);
  a84=(a85<a84);
  a84=(a84?a85:0);
  if (res[0]!=0) res[0][22]=a84;
  if (res[0]!=0) res[0][23]=a32;
  if (res[0]!=0) res[0][24]=a27;
  a12=casadi_fabs(a12);
  a12=(a15<a12);
  a12=(a12?a15:0);
  if (res[0]!=0) res[0][25]=a12;
  if (res[0]!=0) res[0][26]=a56;
  if (res[0]!=0) res[0][27]=a09;
  a20=casadi_fabs(a20);
  a20=(a65<a20);
  a20=(a20?a65:0);
  if (res[0]!=0) res[0][28]=a20;
  if (res[0]!=0) res[0][29]=a28;
  if (res[0]!=0) res[0][30]=a52;
  if (res[0]!=0) res[0][31]=a10;
  if (res[0]!=0) res[0][32]=a38;
  if (res[0]!=0) res[0][33]=a13;
  if (res[0]!=0) res[0][34]=a43;
  if (res[0]!=0) res[0][35]=a45;
  if (res[0]!=0) res[0][36]=a44;
  if (res[0]!=0) res[0][37]=a29;
  if (res[0]!=0) res[0][38]=a14;
  if (res[0]!=0) res[0][39]=a50;
  if (res[0]!=0) res[0][40]=a19;
  if (res[0]!=0) res[0][41]=a49;
  if (res[0]!=0) res[0][42]=a51;
  a51=arg[1]? arg[1][14] : 0;
  a54=(a54*a51);
  a55=(a55+a54);
  if (res[0]!=0) res[0][43]=a55;
  if (res[0]!=0) res[0][44]=a57;
  if (res[0]!=0) res[0][45]=a33;
  a60=(a60*a51);
  a61=(a61+a60);
  if (res[0]!=0) res[0][46]=a61;
  if (res[0]!=0) res[0][47]=a63;
  if (res[0]!=0) res[0][48]=a58;
  a53=(a53?a66:0);
  a18=(a18*a51);
  a53=(a53+a18);
  if (res[0]!=0) res[0][49]=a53;
  if (res[0]!=0) res[0][50]=a68;
  if (res[0]!=0) res[0][51]=a62;
  a69=(a69?a64:0);
  a48=(a48*a51);
  a69=(a69+a48);
  if (res[0]!=0) res[0][52]=a69;
  if (res[0]!=0) res[0][53]=a72;
  if (res[0]!=0) res[0][54]=a67;
  if (res[0]!=0) res[0][55]=a83;
  if (res[0]!=0) res[0][56]=a74;
  a79=(a80-a79);
  a74=arg[1]? arg[1][18] : 0;
  a79=(a79*a74);
  a78=(a78+a79);
  a79=arg[1]? arg[1][17] : 0;
  a81=(a81*a79);
  a78=(a78+a81);
  if (res[0]!=0) res[0][57]=a78;
  if (res[0]!=0) res[0][58]=a16;
  if (res[0]!=0) res[0][59]=a76;
  a25=(a25-a36);
  a25=(a75*a25);
  a04=(a04<a25);
  a25=(a04?a71:0);
  a04=(!a04);
  a36=arg[0]? arg[0][49] : 0;
  a76=(-a36);
  a16=arg[1]? arg[1][23] : 0;
  a75=(a75*a16);
  a71=(a71+a75);
  a36=casadi_fmin(a36,a71);
  a76=casadi_fmax(a76,a36);
  a04=(a04?a76:0);
  a25=(a25+a04);
  if (res[0]!=0) res[0][60]=a25;
  a25=2.9995000000000000e+03;
  a04=(a25<a24);
  a76=arg[2]? arg[2][63] : 0;
  a36=arg[1]? arg[1][27] : 0;
  a71=(a24<=a00);
  a46=(a59?a46:0);
  a59=(!a59);
  a59=(a59?a08:0);
  a46=(a46+a59);
  a46=(a71?a46:0);
  a71=(!a71);
  a71=(a71?a08:0);
  a46=(a46+a71);
  a71=(a46-a76);
  a71=(a36*a71);
  a71=(a76+a71);
  a08=casadi_fabs(a71);
  a08=(a08<=a22);
  a71=(a08?a71:0);
  a08=(!a08);
  a08=(a08?a76:0);
  a71=(a71+a08);
  a08=(a04?a71:0);
  a04=(!a04);
  a04=(a04?a46:0);
  a08=(a08+a04);
  if (res[0]!=0) res[0][61]=a08;
  a25=(a25<a24);
  a04=arg[2]? arg[2][64] : 0;
  a24=(a24<=a00);
  a80=(a30?a80:0);
  a30=(!a30);
  a30=(a30?a47:0);
  a80=(a80+a30);
  a80=(a24?a80:0);
  a24=(!a24);
  a24=(a24?a47:0);
  a80=(a80+a24);
  a24=(a80-a04);
  a36=(a36*a24);
  a36=(a04+a36);
  a24=casadi_fabs(a36);
  a24=(a24<=a77);
  a36=(a24?a36:0);
  a24=(!a24);
  a24=(a24?a04:0);
  a36=(a36+a24);
  a24=(a25?a36:0);
  a25=(!a25);
  a25=(a25?a80:0);
  a24=(a24+a25);
  if (res[0]!=0) res[0][62]=a24;
  if (res[0]!=0) res[0][63]=a71;
  if (res[0]!=0) res[0][64]=a36;
  a36=-3050.;
  a71=3050.;
  a08=(a08*a03);
  a08=casadi_fmin(a71,a08);
  a08=casadi_fmax(a36,a08);
  if (res[1]!=0) res[1][0]=a08;
  a24=(a24*a03);
  a71=casadi_fmin(a71,a24);
  a36=casadi_fmax(a36,a71);
  if (res[1]!=0) res[1][1]=a36;
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


