/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) differential_gearboxes_controller_casadi_ ## ID
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
CASADI_SYMBOL_EXPORT void differential_gearboxes_controller_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int differential_gearboxes_controller_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int differential_gearboxes_controller_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {52, 1, 1};
static const casadi_int casadi_s1[3] = {27, 1, 1};
static const casadi_int casadi_s2[3] = {31, 1, 1};
static const casadi_int casadi_s3[3] = {8, 1, 1};
static const casadi_int casadi_s4[3] = {3, 1, 1};

static const casadi_real casadi_zeros[52] = 
  {0.};

/* controller_prepare:(parameters[52])->(derived[27]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real w1, w2, w3, w4, w5, w6, w7, w8, w9;
  const casadi_real *wr0;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = @0[0] */
  w1 = wr0[0];
  /* #2: @2 = @0[12] */
  w2 = wr0[12];
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
  /* #21: @4 = @0[24] */
  w4 = wr0[24];
  /* #22: @2 = (1./@4) */
  w2 = (1./ w4 );
  /* #23: output[0][5] = @2 */
  if (res[0]) res[0][5] = w2;
  /* #24: @2 = 1 */
  w2 = 1.;
  /* #25: @3 = @0[23] */
  w3 = wr0[23];
  /* #26: @3 = (@3/@4) */
  w3 /= w4;
  /* #27: @2 = (@2+@3) */
  w2 += w3;
  /* #28: output[0][6] = @2 */
  if (res[0]) res[0][6] = w2;
  /* #29: @2 = @0[26] */
  w2 = wr0[26];
  /* #30: @2 = (@2*@1) */
  w2 *= w1;
  /* #31: output[0][7] = @2 */
  if (res[0]) res[0][7] = w2;
  /* #32: @2 = @0[27] */
  w2 = wr0[27];
  /* #33: @2 = (@2*@1) */
  w2 *= w1;
  /* #34: output[0][8] = @2 */
  if (res[0]) res[0][8] = w2;
  /* #35: @2 = @0[29] */
  w2 = wr0[29];
  /* #36: @3 = (@2*@1) */
  w3  = (w2*w1);
  /* #37: output[0][9] = @3 */
  if (res[0]) res[0][9] = w3;
  /* #38: @2 = (@2*@1) */
  w2 *= w1;
  /* #39: @3 = @0[28] */
  w3 = wr0[28];
  /* #40: @2 = (@2/@3) */
  w2 /= w3;
  /* #41: output[0][10] = @2 */
  if (res[0]) res[0][10] = w2;
  /* #42: @2 = @0[31] */
  w2 = wr0[31];
  /* #43: @3 = (@2*@1) */
  w3  = (w2*w1);
  /* #44: output[0][11] = @3 */
  if (res[0]) res[0][11] = w3;
  /* #45: @2 = (@2*@1) */
  w2 *= w1;
  /* #46: @3 = @0[30] */
  w3 = wr0[30];
  /* #47: @2 = (@2/@3) */
  w2 /= w3;
  /* #48: output[0][12] = @2 */
  if (res[0]) res[0][12] = w2;
  /* #49: @2 = @0[35] */
  w2 = wr0[35];
  /* #50: @3 = @0[32] */
  w3 = wr0[32];
  /* #51: @2 = (@2*@3) */
  w2 *= w3;
  /* #52: @4 = @0[34] */
  w4 = wr0[34];
  /* #53: @2 = (@2/@4) */
  w2 /= w4;
  /* #54: output[0][13] = @2 */
  if (res[0]) res[0][13] = w2;
  /* #55: @2 = @0[37] */
  w2 = wr0[37];
  /* #56: @5 = @0[33] */
  w5 = wr0[33];
  /* #57: @2 = (@2*@5) */
  w2 *= w5;
  /* #58: @6 = @0[36] */
  w6 = wr0[36];
  /* #59: @2 = (@2/@6) */
  w2 /= w6;
  /* #60: output[0][14] = @2 */
  if (res[0]) res[0][14] = w2;
  /* #61: @2 = @0[38] */
  w2 = wr0[38];
  /* #62: @2 = (@2/@4) */
  w2 /= w4;
  /* #63: output[0][15] = @2 */
  if (res[0]) res[0][15] = w2;
  /* #64: @2 = @0[39] */
  w2 = wr0[39];
  /* #65: @2 = (@2/@6) */
  w2 /= w6;
  /* #66: output[0][16] = @2 */
  if (res[0]) res[0][16] = w2;
  /* #67: @2 = @0[43] */
  w2 = wr0[43];
  /* #68: @2 = (@2*@1) */
  w2 *= w1;
  /* #69: output[0][17] = @2 */
  if (res[0]) res[0][17] = w2;
  /* #70: @2 = @0[44] */
  w2 = wr0[44];
  /* #71: @2 = (@2*@1) */
  w2 *= w1;
  /* #72: @7 = @0[40] */
  w7 = wr0[40];
  /* #73: @2 = (@2/@7) */
  w2 /= w7;
  /* #74: output[0][18] = @2 */
  if (res[0]) res[0][18] = w2;
  /* #75: @2 = @0[45] */
  w2 = wr0[45];
  /* #76: @2 = (@2*@1) */
  w2 *= w1;
  /* #77: @2 = (@2/@7) */
  w2 /= w7;
  /* #78: output[0][19] = @2 */
  if (res[0]) res[0][19] = w2;
  /* #79: @2 = @0[47] */
  w2 = wr0[47];
  /* #80: @8 = (@7*@2) */
  w8  = (w7*w2);
  /* #81: @9 = @0[48] */
  w9 = wr0[48];
  /* #82: @8 = (@8*@9) */
  w8 *= w9;
  /* #83: @4 = (2.*@4) */
  w4 = (2.* w4 );
  /* #84: @4 = (@4*@3) */
  w4 *= w3;
  /* #85: @8 = (@8/@4) */
  w8 /= w4;
  /* #86: output[0][20] = @8 */
  if (res[0]) res[0][20] = w8;
  /* #87: @7 = (@7*@2) */
  w7 *= w2;
  /* #88: @7 = (@7*@9) */
  w7 *= w9;
  /* #89: @6 = (2.*@6) */
  w6 = (2.* w6 );
  /* #90: @6 = (@6*@5) */
  w6 *= w5;
  /* #91: @7 = (@7/@6) */
  w7 /= w6;
  /* #92: output[0][21] = @7 */
  if (res[0]) res[0][21] = w7;
  /* #93: @7 = (@2*@9) */
  w7  = (w2*w9);
  /* #94: @7 = (1./@7) */
  w7 = (1./ w7 );
  /* #95: output[0][22] = @7 */
  if (res[0]) res[0][22] = w7;
  /* #96: @7 = (@2*@9) */
  w7  = (w2*w9);
  /* #97: @3 = (2.*@3) */
  w3 = (2.* w3 );
  /* #98: @7 = (@7/@3) */
  w7 /= w3;
  /* #99: output[0][23] = @7 */
  if (res[0]) res[0][23] = w7;
  /* #100: @7 = (@2*@9) */
  w7  = (w2*w9);
  /* #101: @5 = (2.*@5) */
  w5 = (2.* w5 );
  /* #102: @7 = (@7/@5) */
  w7 /= w5;
  /* #103: output[0][24] = @7 */
  if (res[0]) res[0][24] = w7;
  /* #104: @7 = @0[49] */
  w7 = wr0[49];
  /* #105: @7 = (@7*@1) */
  w7 *= w1;
  /* #106: output[0][25] = @7 */
  if (res[0]) res[0][25] = w7;
  /* #107: @2 = (@2*@9) */
  w2 *= w9;
  /* #108: @2 = (1./@2) */
  w2 = (1./ w2 );
  /* #109: output[0][26] = @2 */
  if (res[0]) res[0][26] = w2;
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

/* controller_step:(parameters[52],derived[27],states[31],inputs[8])->(next_states[31],outputs[3]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65;
  a00=arg[0]? arg[0][22] : 0;
  a01=arg[0]? arg[0][25] : 0;
  a02=(a00*a01);
  a03=arg[3]? arg[3][7] : 0;
  a04=casadi_fabs(a03);
  a05=arg[0]? arg[0][9] : 0;
  a04=(a04<=a05);
  a03=(a04?a03:0);
  a05=(!a04);
  a06=arg[2]? arg[2][8] : 0;
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
  a06=arg[0]? arg[0][31] : 0;
  a06=(a00<a06);
  a07=arg[3]? arg[3][6] : 0;
  a09=casadi_fabs(a07);
  a10=arg[0]? arg[0][8] : 0;
  a09=(a09<=a10);
  a07=(a09?a07:0);
  a10=(!a09);
  a11=arg[2]? arg[2][7] : 0;
  a10=(a10?a11:0);
  a07=(a07+a10);
  a10=5.0000000000000000e-01;
  a11=arg[2]? arg[2][12] : 0;
  a12=(a10<a11);
  a13=arg[2]? arg[2][9] : 0;
  a13=(a12?a13:0);
  a12=(!a12);
  a14=arg[0]? arg[0][10] : 0;
  a12=(a12?a14:0);
  a13=(a13+a12);
  a12=(a14-a13);
  a15=casadi_fabs(a12);
  a16=arg[2]? arg[2][10] : 0;
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
  a20=arg[2]? arg[2][11] : 0;
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
  a21=arg[2]? arg[2][22] : 0;
  a15=(a15?a21:0);
  a06=(a06+a15);
  a15=(a10<a11);
  a21=arg[2]? arg[2][20] : 0;
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
  a15=arg[0]? arg[0][30] : 0;
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
  a25=arg[0]? arg[0][18] : 0;
  a26=arg[0]? arg[0][21] : 0;
  a27=(a25*a26);
  a28=arg[3]? arg[3][5] : 0;
  a29=casadi_fabs(a28);
  a30=arg[0]? arg[0][7] : 0;
  a29=(a29<=a30);
  a28=(a29?a28:0);
  a30=(!a29);
  a31=arg[2]? arg[2][6] : 0;
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
  a25=arg[0]? arg[0][29] : 0;
  a25=(a00<a25);
  a30=arg[3]? arg[3][4] : 0;
  a32=casadi_fabs(a30);
  a33=arg[0]? arg[0][6] : 0;
  a32=(a32<=a33);
  a30=(a32?a30:0);
  a33=(!a32);
  a34=arg[2]? arg[2][5] : 0;
  a33=(a33?a34:0);
  a30=(a30+a33);
  a13=(a13-a16);
  a13=(a30*a13);
  a13=(-a13);
  a25=(a25?a13:0);
  a13=(a10<a11);
  a33=arg[2]? arg[2][21] : 0;
  a13=(a13?a33:0);
  a25=(a25+a13);
  a13=(a10<a11);
  a33=arg[2]? arg[2][19] : 0;
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
  a13=arg[0]? arg[0][28] : 0;
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
  a37=arg[0]? arg[0][14] : 0;
  a38=arg[0]? arg[0][17] : 0;
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
  a37=arg[0]? arg[0][13] : 0;
  a42=(a10<a11);
  a45=arg[2]? arg[2][16] : 0;
  a45=(a42?a45:0);
  a42=(!a42);
  a42=(a42?a37:0);
  a45=(a45+a42);
  a42=(a37-a45);
  a46=casadi_fabs(a42);
  a47=arg[2]? arg[2][17] : 0;
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
  a49=arg[2]? arg[2][18] : 0;
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
  a46=arg[1]? arg[1][23] : 0;
  a46=(a46*a28);
  a46=(a46-a40);
  a50=arg[1]? arg[1][24] : 0;
  a50=(a50*a03);
  a46=(a46+a50);
  a46=(a47*a46);
  a50=arg[0]? arg[0][50] : 0;
  a49=(a05-a50);
  a43=(a43*a49);
  a43=(-a43);
  a49=arg[1]? arg[1][22] : 0;
  a45=(a10<a11);
  a51=arg[2]? arg[2][26] : 0;
  a45=(a45?a51:0);
  a51=arg[0]? arg[0][41] : 0;
  a52=(a10<a11);
  a53=arg[2]? arg[2][23] : 0;
  a53=(a52?a53:0);
  a52=(!a52);
  a54=arg[1]? arg[1][13] : 0;
  a55=(a31+a30);
  a54=(a54*a55);
  a56=arg[1]? arg[1][14] : 0;
  a57=(a08+a07);
  a56=(a56*a57);
  a54=(a54+a56);
  a56=arg[1]? arg[1][15] : 0;
  a56=(a56*a55);
  a54=(a54+a56);
  a56=arg[1]? arg[1][16] : 0;
  a56=(a56*a57);
  a54=(a54+a56);
  a56=arg[0]? arg[0][32] : 0;
  a56=(a30*a56);
  a54=(a54+a56);
  a56=arg[0]? arg[0][33] : 0;
  a56=(a07*a56);
  a54=(a54+a56);
  a52=(a52?a54:0);
  a53=(a53+a52);
  a52=arg[1]? arg[1][17] : 0;
  a56=(-a52);
  a58=arg[3]? arg[3][0] : 0;
  a59=casadi_fabs(a58);
  a60=arg[0]? arg[0][2] : 0;
  a59=(a59<=a60);
  a58=(a59?a58:0);
  a60=(!a59);
  a61=arg[2]? arg[2][1] : 0;
  a60=(a60?a61:0);
  a58=(a58+a60);
  a60=(a58-a53);
  a52=casadi_fmin(a52,a60);
  a56=casadi_fmax(a56,a52);
  a53=(a53+a56);
  a51=(a51*a53);
  a51=(a45+a51);
  a56=(a10<a11);
  a52=arg[2]? arg[2][24] : 0;
  a52=(a56?a52:0);
  a56=(!a56);
  a56=(a56?a54:0);
  a52=(a52+a56);
  a56=(a10<a11);
  a60=arg[2]? arg[2][25] : 0;
  a61=(a56?a60:0);
  a62=arg[1]? arg[1][18] : 0;
  a63=(a53-a52);
  a62=(a62*a63);
  a61=(a61+a62);
  a62=arg[1]? arg[1][19] : 0;
  a62=(a62*a60);
  a62=(-a62);
  a56=(a56?a62:0);
  a61=(a61+a56);
  a56=arg[0]? arg[0][0] : 0;
  a62=(a61*a56);
  a52=(a52+a62);
  a62=arg[0]? arg[0][46] : 0;
  a60=(a52*a62);
  a60=(a60-a54);
  a62=(a05-a62);
  a62=(a53*a62);
  a60=(a60+a62);
  a62=arg[0]? arg[0][42] : 0;
  a62=(a60*a62);
  a51=(a51+a62);
  a49=(a49*a51);
  a51=arg[0]? arg[0][11] : 0;
  a11=(a10<a11);
  a62=arg[2]? arg[2][13] : 0;
  a62=(a11?a62:0);
  a11=(!a11);
  a11=(a11?a51:0);
  a62=(a62+a11);
  a11=(a51-a62);
  a54=casadi_fabs(a11);
  a63=arg[2]? arg[2][14] : 0;
  a63=(a51!=a63);
  a64=casadi_fabs(a11);
  a17=(a17*a64);
  a64=casadi_fabs(a51);
  a64=(a19*a64);
  a65=casadi_fabs(a62);
  a19=(a19*a65);
  a64=(a64+a19);
  a17=casadi_fmax(a17,a64);
  a17=(a63?a17:0);
  a63=(!a63);
  a64=arg[2]? arg[2][15] : 0;
  a63=(a63?a64:0);
  a17=(a17+a63);
  a54=(a54<=a17);
  a63=(a54?a51:0);
  a54=(!a54);
  a64=(a00<a11);
  a19=(a62+a17);
  a19=(a64?a19:0);
  a64=(!a64);
  a62=(a62-a17);
  a64=(a64?a62:0);
  a19=(a19+a64);
  a54=(a54?a19:0);
  a63=(a63+a54);
  a54=arg[1]? arg[1][20] : 0;
  a54=(a54*a55);
  a55=arg[1]? arg[1][21] : 0;
  a55=(a55*a57);
  a54=(a54+a55);
  a54=(a63*a54);
  a49=(a49+a54);
  a50=(a05-a50);
  a50=(a39*a50);
  a50=casadi_fmin(a49,a50);
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
  a59=(a59?a05:0);
  a59=(a59<a10);
  a38=arg[2]? arg[2][0] : 0;
  a46=(a38<a10);
  a59=(a59&&a46);
  a46=(a59?a05:0);
  a59=(!a59);
  a59=(a59?a38:0);
  a46=(a46+a59);
  a59=(a46<a10);
  a36=(a36&&a59);
  a59=2.;
  a59=(a36?a59:0);
  a36=(!a36);
  a36=(a36?a46:0);
  a59=(a59+a36);
  a36=(a59<a10);
  a23=(a23&&a36);
  a36=3.;
  a36=(a23?a36:0);
  a23=(!a23);
  a23=(a23?a59:0);
  a36=(a36+a23);
  a23=(a36<a10);
  a41=(a41&&a23);
  a23=4.;
  a23=(a41?a23:0);
  a41=(!a41);
  a41=(a41?a36:0);
  a23=(a23+a41);
  a41=(a23<a10);
  a32=(a32?a05:0);
  a32=(a32<a10);
  a41=(a41&&a32);
  a32=5.;
  a32=(a41?a32:0);
  a41=(!a41);
  a41=(a41?a23:0);
  a32=(a32+a41);
  a41=(a32<a10);
  a29=(a29&&a41);
  a41=6.;
  a41=(a29?a41:0);
  a29=(!a29);
  a29=(a29?a32:0);
  a41=(a41+a29);
  a29=(a41<a10);
  a09=(a09?a05:0);
  a09=(a09<a10);
  a29=(a29&&a09);
  a09=7.;
  a09=(a29?a09:0);
  a29=(!a29);
  a29=(a29?a41:0);
  a09=(a09+a29);
  a29=(a09<a10);
  a04=(a04&&a29);
  a29=8.;
  a29=(a04?a29:0);
  a04=(!a04);
  a04=(a04?a09:0);
  a29=(a29+a04);
  a04=(a29<a10);
  a24=(a24&&a04);
  a04=9.;
  a04=(a24?a04:0);
  a24=(!a24);
  a24=(a24?a29:0);
  a04=(a04+a24);
  a24=(a04<a10);
  a26=(a26&&a24);
  a24=10.;
  a24=(a26?a24:0);
  a26=(!a26);
  a26=(a26?a04:0);
  a24=(a24+a26);
  a26=(a24<a10);
  a01=(a01&&a26);
  a26=11.;
  a26=(a01?a26:0);
  a01=(!a01);
  a01=(a01?a24:0);
  a26=(a26+a01);
  if (res[0]!=0) res[0][0]=a26;
  if (res[0]!=0) res[0][1]=a58;
  if (res[0]!=0) res[0][2]=a35;
  if (res[0]!=0) res[0][3]=a22;
  if (res[0]!=0) res[0][4]=a40;
  if (res[0]!=0) res[0][5]=a30;
  if (res[0]!=0) res[0][6]=a28;
  if (res[0]!=0) res[0][7]=a07;
  if (res[0]!=0) res[0][8]=a03;
  if (res[0]!=0) res[0][9]=a16;
  if (res[0]!=0) res[0][10]=a14;
  a12=casadi_fabs(a12);
  a12=(a12<=a18);
  a12=(!a12);
  a12=(a12?a18:0);
  if (res[0]!=0) res[0][11]=a12;
  a12=(a26<a10);
  a12=(a12?a05:0);
  if (res[0]!=0) res[0][12]=a12;
  if (res[0]!=0) res[0][13]=a63;
  if (res[0]!=0) res[0][14]=a51;
  a11=casadi_fabs(a11);
  a11=(a11<=a17);
  a11=(!a11);
  a11=(a11?a17:0);
  if (res[0]!=0) res[0][15]=a11;
  if (res[0]!=0) res[0][16]=a47;
  if (res[0]!=0) res[0][17]=a37;
  a42=casadi_fabs(a42);
  a42=(a42<=a48);
  a42=(!a42);
  a42=(a42?a48:0);
  if (res[0]!=0) res[0][18]=a42;
  if (res[0]!=0) res[0][19]=a33;
  if (res[0]!=0) res[0][20]=a21;
  a13=(a31-a13);
  a21=arg[1]? arg[1][10] : 0;
  a13=(a13*a21);
  a25=(a25+a13);
  a13=arg[1]? arg[1][9] : 0;
  a34=(a34*a13);
  a25=(a25+a34);
  if (res[0]!=0) res[0][21]=a25;
  a15=(a08-a15);
  a25=arg[1]? arg[1][12] : 0;
  a15=(a15*a25);
  a06=(a06+a15);
  a15=arg[1]? arg[1][11] : 0;
  a20=(a20*a15);
  a06=(a06+a20);
  if (res[0]!=0) res[0][22]=a06;
  if (res[0]!=0) res[0][23]=a53;
  if (res[0]!=0) res[0][24]=a52;
  if (res[0]!=0) res[0][25]=a61;
  a61=arg[1]? arg[1][26] : 0;
  a61=(a61*a60);
  a49=(a49-a43);
  a61=(a61*a49);
  a61=(a00<a61);
  a49=(a61?a45:0);
  a61=(!a61);
  a43=arg[0]? arg[0][51] : 0;
  a52=(-a43);
  a53=arg[1]? arg[1][25] : 0;
  a60=(a60*a53);
  a45=(a45+a60);
  a43=casadi_fmin(a43,a45);
  a52=casadi_fmax(a52,a43);
  a61=(a61?a52:0);
  a49=(a49+a61);
  if (res[0]!=0) res[0][26]=a49;
  a49=(a10<a26);
  a61=arg[2]? arg[2][27] : 0;
  a52=(a49?a61:0);
  a49=(!a49);
  a44=(a39?a44:0);
  a39=(!a39);
  a39=(a39?a61:0);
  a44=(a44+a39);
  a49=(a49?a44:0);
  a52=(a52+a49);
  if (res[0]!=0) res[0][27]=a52;
  a49=(a10<a26);
  a44=arg[2]? arg[2][28] : 0;
  a39=(a49?a44:0);
  a49=(!a49);
  a31=(a27?a31:0);
  a27=(!a27);
  a27=(a27?a44:0);
  a31=(a31+a27);
  a49=(a49?a31:0);
  a39=(a39+a49);
  if (res[0]!=0) res[0][28]=a39;
  a49=(a10<a26);
  a31=arg[2]? arg[2][29] : 0;
  a27=(a49?a31:0);
  a49=(!a49);
  a08=(a02?a08:0);
  a02=(!a02);
  a02=(a02?a31:0);
  a08=(a08+a02);
  a49=(a49?a08:0);
  a27=(a27+a49);
  if (res[0]!=0) res[0][29]=a27;
  a10=(a10<a26);
  a26=arg[2]? arg[2][30] : 0;
  a49=arg[0]? arg[0][1] : 0;
  a56=(a56/a49);
  a56=(a26-a56);
  a00=casadi_fmax(a00,a56);
  a00=(a10?a00:0);
  a10=(!a10);
  a10=(a10?a26:0);
  a00=(a00+a10);
  if (res[0]!=0) res[0][30]=a00;
  a52=(a52*a00);
  if (res[1]!=0) res[1][0]=a52;
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


