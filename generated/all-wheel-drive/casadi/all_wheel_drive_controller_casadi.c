/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) all_wheel_drive_controller_casadi_ ## ID
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
CASADI_SYMBOL_EXPORT void all_wheel_drive_controller_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int all_wheel_drive_controller_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int all_wheel_drive_controller_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {74, 1, 1};
static const casadi_int casadi_s1[3] = {39, 1, 1};
static const casadi_int casadi_s2[3] = {44, 1, 1};
static const casadi_int casadi_s3[3] = {15, 1, 1};
static const casadi_int casadi_s4[3] = {5, 1, 1};

static const casadi_real casadi_zeros[74] = 
  {0.};

/* controller_prepare:(parameters[74])->(derived[39]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real w01, w02, w03, w04, w05, w06, w07, w08, w09, w10;
  const casadi_real *wr00;
  /* #0: @0 = input[0][0] */
  wr00 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = @0[0] */
  w01 = wr00[0];
  /* #2: @2 = @0[19] */
  w02 = wr00[19];
  /* #3: @2 = (@1/@2) */
  w02  = (w01/w02);
  /* #4: output[0][0] = @2 */
  if (res[0]) res[0][0] = w02;
  /* #5: @2 = @0[23] */
  w02 = wr00[23];
  /* #6: @3 = (1./@2) */
  w03 = (1./ w02 );
  /* #7: output[0][1] = @3 */
  if (res[0]) res[0][1] = w03;
  /* #8: @3 = 1 */
  w03 = 1.;
  /* #9: @4 = @0[22] */
  w04 = wr00[22];
  /* #10: @4 = (@4/@2) */
  w04 /= w02;
  /* #11: @3 = (@3+@4) */
  w03 += w04;
  /* #12: output[0][2] = @3 */
  if (res[0]) res[0][2] = w03;
  /* #13: @3 = @0[27] */
  w03 = wr00[27];
  /* #14: @4 = (1./@3) */
  w04 = (1./ w03 );
  /* #15: output[0][3] = @4 */
  if (res[0]) res[0][3] = w04;
  /* #16: @4 = 1 */
  w04 = 1.;
  /* #17: @2 = @0[26] */
  w02 = wr00[26];
  /* #18: @2 = (@2/@3) */
  w02 /= w03;
  /* #19: @4 = (@4+@2) */
  w04 += w02;
  /* #20: output[0][4] = @4 */
  if (res[0]) res[0][4] = w04;
  /* #21: @4 = @0[31] */
  w04 = wr00[31];
  /* #22: @2 = (1./@4) */
  w02 = (1./ w04 );
  /* #23: output[0][5] = @2 */
  if (res[0]) res[0][5] = w02;
  /* #24: @2 = 1 */
  w02 = 1.;
  /* #25: @3 = @0[30] */
  w03 = wr00[30];
  /* #26: @3 = (@3/@4) */
  w03 /= w04;
  /* #27: @2 = (@2+@3) */
  w02 += w03;
  /* #28: output[0][6] = @2 */
  if (res[0]) res[0][6] = w02;
  /* #29: @2 = @0[35] */
  w02 = wr00[35];
  /* #30: @3 = (1./@2) */
  w03 = (1./ w02 );
  /* #31: output[0][7] = @3 */
  if (res[0]) res[0][7] = w03;
  /* #32: @3 = 1 */
  w03 = 1.;
  /* #33: @4 = @0[34] */
  w04 = wr00[34];
  /* #34: @4 = (@4/@2) */
  w04 /= w02;
  /* #35: @3 = (@3+@4) */
  w03 += w04;
  /* #36: output[0][8] = @3 */
  if (res[0]) res[0][8] = w03;
  /* #37: @3 = @0[39] */
  w03 = wr00[39];
  /* #38: @4 = (1./@3) */
  w04 = (1./ w03 );
  /* #39: output[0][9] = @4 */
  if (res[0]) res[0][9] = w04;
  /* #40: @4 = 1 */
  w04 = 1.;
  /* #41: @2 = @0[38] */
  w02 = wr00[38];
  /* #42: @2 = (@2/@3) */
  w02 /= w03;
  /* #43: @4 = (@4+@2) */
  w04 += w02;
  /* #44: output[0][10] = @4 */
  if (res[0]) res[0][10] = w04;
  /* #45: @4 = @0[41] */
  w04 = wr00[41];
  /* #46: @4 = (@4*@1) */
  w04 *= w01;
  /* #47: output[0][11] = @4 */
  if (res[0]) res[0][11] = w04;
  /* #48: @4 = @0[42] */
  w04 = wr00[42];
  /* #49: @4 = (@4*@1) */
  w04 *= w01;
  /* #50: output[0][12] = @4 */
  if (res[0]) res[0][12] = w04;
  /* #51: @4 = @0[43] */
  w04 = wr00[43];
  /* #52: @4 = (@4*@1) */
  w04 *= w01;
  /* #53: output[0][13] = @4 */
  if (res[0]) res[0][13] = w04;
  /* #54: @4 = @0[44] */
  w04 = wr00[44];
  /* #55: @4 = (@4*@1) */
  w04 *= w01;
  /* #56: output[0][14] = @4 */
  if (res[0]) res[0][14] = w04;
  /* #57: @4 = @0[46] */
  w04 = wr00[46];
  /* #58: @2 = (@4*@1) */
  w02  = (w04*w01);
  /* #59: output[0][15] = @2 */
  if (res[0]) res[0][15] = w02;
  /* #60: @4 = (@4*@1) */
  w04 *= w01;
  /* #61: @2 = @0[45] */
  w02 = wr00[45];
  /* #62: @4 = (@4/@2) */
  w04 /= w02;
  /* #63: output[0][16] = @4 */
  if (res[0]) res[0][16] = w04;
  /* #64: @4 = @0[48] */
  w04 = wr00[48];
  /* #65: @2 = (@4*@1) */
  w02  = (w04*w01);
  /* #66: output[0][17] = @2 */
  if (res[0]) res[0][17] = w02;
  /* #67: @4 = (@4*@1) */
  w04 *= w01;
  /* #68: @2 = @0[47] */
  w02 = wr00[47];
  /* #69: @4 = (@4/@2) */
  w04 /= w02;
  /* #70: output[0][18] = @4 */
  if (res[0]) res[0][18] = w04;
  /* #71: @4 = @0[50] */
  w04 = wr00[50];
  /* #72: @2 = (@4*@1) */
  w02  = (w04*w01);
  /* #73: output[0][19] = @2 */
  if (res[0]) res[0][19] = w02;
  /* #74: @4 = (@4*@1) */
  w04 *= w01;
  /* #75: @2 = @0[49] */
  w02 = wr00[49];
  /* #76: @4 = (@4/@2) */
  w04 /= w02;
  /* #77: output[0][20] = @4 */
  if (res[0]) res[0][20] = w04;
  /* #78: @4 = @0[52] */
  w04 = wr00[52];
  /* #79: @2 = (@4*@1) */
  w02  = (w04*w01);
  /* #80: output[0][21] = @2 */
  if (res[0]) res[0][21] = w02;
  /* #81: @4 = (@4*@1) */
  w04 *= w01;
  /* #82: @2 = @0[51] */
  w02 = wr00[51];
  /* #83: @4 = (@4/@2) */
  w04 /= w02;
  /* #84: output[0][22] = @4 */
  if (res[0]) res[0][22] = w04;
  /* #85: @4 = @0[53] */
  w04 = wr00[53];
  /* #86: @2 = @0[54] */
  w02 = wr00[54];
  /* #87: @4 = (@4/@2) */
  w04 /= w02;
  /* #88: output[0][23] = @4 */
  if (res[0]) res[0][23] = w04;
  /* #89: @4 = @0[55] */
  w04 = wr00[55];
  /* #90: @3 = @0[56] */
  w03 = wr00[56];
  /* #91: @4 = (@4/@3) */
  w04 /= w03;
  /* #92: output[0][24] = @4 */
  if (res[0]) res[0][24] = w04;
  /* #93: @4 = @0[57] */
  w04 = wr00[57];
  /* #94: @5 = @0[58] */
  w05 = wr00[58];
  /* #95: @4 = (@4/@5) */
  w04 /= w05;
  /* #96: output[0][25] = @4 */
  if (res[0]) res[0][25] = w04;
  /* #97: @4 = @0[59] */
  w04 = wr00[59];
  /* #98: @6 = @0[60] */
  w06 = wr00[60];
  /* #99: @4 = (@4/@6) */
  w04 /= w06;
  /* #100: output[0][26] = @4 */
  if (res[0]) res[0][26] = w04;
  /* #101: @4 = @0[64] */
  w04 = wr00[64];
  /* #102: @4 = (@4*@1) */
  w04 *= w01;
  /* #103: output[0][27] = @4 */
  if (res[0]) res[0][27] = w04;
  /* #104: @4 = @0[65] */
  w04 = wr00[65];
  /* #105: @4 = (@4*@1) */
  w04 *= w01;
  /* #106: @7 = @0[61] */
  w07 = wr00[61];
  /* #107: @4 = (@4/@7) */
  w04 /= w07;
  /* #108: output[0][28] = @4 */
  if (res[0]) res[0][28] = w04;
  /* #109: @4 = @0[66] */
  w04 = wr00[66];
  /* #110: @4 = (@4*@1) */
  w04 *= w01;
  /* #111: @4 = (@4/@7) */
  w04 /= w07;
  /* #112: output[0][29] = @4 */
  if (res[0]) res[0][29] = w04;
  /* #113: @4 = @0[68] */
  w04 = wr00[68];
  /* #114: @8 = (@7*@4) */
  w08  = (w07*w04);
  /* #115: @9 = @0[69] */
  w09 = wr00[69];
  /* #116: @8 = (@8*@9) */
  w08 *= w09;
  /* #117: @10 = 4 */
  w10 = 4.;
  /* #118: @10 = (@10*@2) */
  w10 *= w02;
  /* #119: @8 = (@8/@10) */
  w08 /= w10;
  /* #120: output[0][30] = @8 */
  if (res[0]) res[0][30] = w08;
  /* #121: @8 = (@7*@4) */
  w08  = (w07*w04);
  /* #122: @8 = (@8*@9) */
  w08 *= w09;
  /* #123: @10 = 4 */
  w10 = 4.;
  /* #124: @10 = (@10*@3) */
  w10 *= w03;
  /* #125: @8 = (@8/@10) */
  w08 /= w10;
  /* #126: output[0][31] = @8 */
  if (res[0]) res[0][31] = w08;
  /* #127: @8 = (@7*@4) */
  w08  = (w07*w04);
  /* #128: @10 = @0[70] */
  w10 = wr00[70];
  /* #129: @8 = (@8*@10) */
  w08 *= w10;
  /* #130: @3 = 4 */
  w03 = 4.;
  /* #131: @3 = (@3*@5) */
  w03 *= w05;
  /* #132: @8 = (@8/@3) */
  w08 /= w03;
  /* #133: output[0][32] = @8 */
  if (res[0]) res[0][32] = w08;
  /* #134: @7 = (@7*@4) */
  w07 *= w04;
  /* #135: @7 = (@7*@10) */
  w07 *= w10;
  /* #136: @8 = 4 */
  w08 = 4.;
  /* #137: @8 = (@8*@6) */
  w08 *= w06;
  /* #138: @7 = (@7/@8) */
  w07 /= w08;
  /* #139: output[0][33] = @7 */
  if (res[0]) res[0][33] = w07;
  /* #140: @7 = (@4*@9) */
  w07  = (w04*w09);
  /* #141: @8 = 4 */
  w08 = 4.;
  /* #142: @7 = (@7/@8) */
  w07 /= w08;
  /* #143: output[0][34] = @7 */
  if (res[0]) res[0][34] = w07;
  /* #144: @9 = (@4*@9) */
  w09  = (w04*w09);
  /* #145: @7 = 4 */
  w07 = 4.;
  /* #146: @9 = (@9/@7) */
  w09 /= w07;
  /* #147: output[0][35] = @9 */
  if (res[0]) res[0][35] = w09;
  /* #148: @9 = (@4*@10) */
  w09  = (w04*w10);
  /* #149: @7 = 4 */
  w07 = 4.;
  /* #150: @9 = (@9/@7) */
  w09 /= w07;
  /* #151: output[0][36] = @9 */
  if (res[0]) res[0][36] = w09;
  /* #152: @4 = (@4*@10) */
  w04 *= w10;
  /* #153: @10 = 4 */
  w10 = 4.;
  /* #154: @4 = (@4/@10) */
  w04 /= w10;
  /* #155: output[0][37] = @4 */
  if (res[0]) res[0][37] = w04;
  /* #156: @4 = @0[71] */
  w04 = wr00[71];
  /* #157: @4 = (@4*@1) */
  w04 *= w01;
  /* #158: output[0][38] = @4 */
  if (res[0]) res[0][38] = w04;
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

/* controller_step:(parameters[74],derived[39],states[44],inputs[15])->(next_states[44],outputs[5]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  casadi_real a72, a73, a74, a75, a76, a77, a78, a79, a80, a81, a82, a83;
  casadi_real a84, a85, a86, a87, a88, a89, a90, a91, a92, a93, a94, a95;
  a00=arg[0]? arg[0][37] : 0;
  a01=arg[0]? arg[0][40] : 0;
  a02=(a00*a01);
  a03=arg[3]? arg[3][14] : 0;
  a04=casadi_fabs(a03);
  a05=arg[0]? arg[0][16] : 0;
  a04=(a04<=a05);
  a03=(a04?a03:0);
  a05=(!a04);
  a06=arg[2]? arg[2][15] : 0;
  a05=(a05?a06:0);
  a03=(a03+a05);
  a05=casadi_fabs(a03);
  a00=casadi_fmax(a00,a05);
  a02=(a02/a00);
  a00=0.;
  a05=1.;
  a06=arg[1]? arg[1][10] : 0;
  a07=arg[1]? arg[1][9] : 0;
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
  a06=arg[0]? arg[0][52] : 0;
  a06=(a00<a06);
  a07=arg[3]? arg[3][13] : 0;
  a09=casadi_fabs(a07);
  a10=arg[0]? arg[0][15] : 0;
  a09=(a09<=a10);
  a07=(a09?a07:0);
  a10=(!a09);
  a11=arg[2]? arg[2][14] : 0;
  a10=(a10?a11:0);
  a07=(a07+a10);
  a10=5.0000000000000000e-01;
  a11=arg[2]? arg[2][19] : 0;
  a12=(a10<a11);
  a13=arg[2]? arg[2][16] : 0;
  a13=(a12?a13:0);
  a12=(!a12);
  a14=arg[0]? arg[0][17] : 0;
  a12=(a12?a14:0);
  a13=(a13+a12);
  a12=(a14-a13);
  a15=casadi_fabs(a12);
  a16=arg[2]? arg[2][17] : 0;
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
  a20=arg[2]? arg[2][18] : 0;
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
  a21=arg[2]? arg[2][33] : 0;
  a15=(a15?a21:0);
  a06=(a06+a15);
  a15=(a10<a11);
  a21=arg[2]? arg[2][29] : 0;
  a21=(a15?a21:0);
  a15=(!a15);
  a15=(a15?a03:0);
  a21=(a21+a15);
  a15=arg[1]? arg[1][14] : 0;
  a20=(-a15);
  a22=arg[3]? arg[3][4] : 0;
  a23=casadi_fabs(a22);
  a24=arg[0]? arg[0][6] : 0;
  a23=(a23<=a24);
  a22=(a23?a22:0);
  a24=(!a23);
  a25=arg[2]? arg[2][5] : 0;
  a24=(a24?a25:0);
  a22=(a22+a24);
  a24=(a22-a21);
  a15=casadi_fmin(a15,a24);
  a20=casadi_fmax(a20,a15);
  a21=(a21+a20);
  a20=(a21-a03);
  a15=arg[0]? arg[0][51] : 0;
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
  a25=arg[0]? arg[0][33] : 0;
  a26=arg[0]? arg[0][36] : 0;
  a27=(a25*a26);
  a28=arg[3]? arg[3][12] : 0;
  a29=casadi_fabs(a28);
  a30=arg[0]? arg[0][14] : 0;
  a29=(a29<=a30);
  a28=(a29?a28:0);
  a30=(!a29);
  a31=arg[2]? arg[2][13] : 0;
  a30=(a30?a31:0);
  a28=(a28+a30);
  a30=casadi_fabs(a28);
  a25=casadi_fmax(a25,a30);
  a27=(a27/a25);
  a25=arg[1]? arg[1][8] : 0;
  a30=arg[1]? arg[1][7] : 0;
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
  a25=arg[0]? arg[0][50] : 0;
  a25=(a00<a25);
  a30=arg[3]? arg[3][11] : 0;
  a32=casadi_fabs(a30);
  a33=arg[0]? arg[0][13] : 0;
  a32=(a32<=a33);
  a30=(a32?a30:0);
  a33=(!a32);
  a34=arg[2]? arg[2][12] : 0;
  a33=(a33?a34:0);
  a30=(a30+a33);
  a33=(a13-a16);
  a33=(a30*a33);
  a33=(-a33);
  a25=(a25?a33:0);
  a33=(a10<a11);
  a34=arg[2]? arg[2][32] : 0;
  a33=(a33?a34:0);
  a25=(a25+a33);
  a33=(a10<a11);
  a34=arg[2]? arg[2][28] : 0;
  a34=(a33?a34:0);
  a33=(!a33);
  a33=(a33?a28:0);
  a34=(a34+a33);
  a33=arg[1]? arg[1][13] : 0;
  a35=(-a33);
  a36=arg[3]? arg[3][3] : 0;
  a37=casadi_fabs(a36);
  a38=arg[0]? arg[0][5] : 0;
  a37=(a37<=a38);
  a36=(a37?a36:0);
  a38=(!a37);
  a39=arg[2]? arg[2][4] : 0;
  a38=(a38?a39:0);
  a36=(a36+a38);
  a38=(a36-a34);
  a33=casadi_fmin(a33,a38);
  a35=casadi_fmax(a35,a33);
  a34=(a34+a35);
  a35=(a34-a28);
  a33=arg[0]? arg[0][49] : 0;
  a33=(a35*a33);
  a33=(a25+a33);
  a38=(a30*a16);
  a33=(a33-a38);
  a27=casadi_fmin(a27,a33);
  a31=casadi_fmax(a31,a27);
  a27=casadi_fabs(a31);
  a26=(a24*a26);
  a27=(a27<=a26);
  a26=(a27?a05:0);
  a26=(a26<a10);
  a38=arg[0]? arg[0][29] : 0;
  a39=arg[0]? arg[0][32] : 0;
  a40=(a38*a39);
  a41=arg[3]? arg[3][10] : 0;
  a42=casadi_fabs(a41);
  a43=arg[0]? arg[0][12] : 0;
  a42=(a42<=a43);
  a41=(a42?a41:0);
  a43=(!a42);
  a44=arg[2]? arg[2][11] : 0;
  a43=(a43?a44:0);
  a41=(a41+a43);
  a43=casadi_fabs(a41);
  a38=casadi_fmax(a38,a43);
  a40=(a40/a38);
  a38=arg[1]? arg[1][6] : 0;
  a43=arg[1]? arg[1][5] : 0;
  a44=(a41*a43);
  a44=(a38+a44);
  a44=casadi_fmin(a05,a44);
  a44=casadi_fmax(a00,a44);
  a44=(a40*a44);
  a44=(-a44);
  a43=(a41*a43);
  a38=(a38-a43);
  a38=casadi_fmin(a05,a38);
  a38=casadi_fmax(a00,a38);
  a40=(a40*a38);
  a38=arg[0]? arg[0][48] : 0;
  a38=(a00<a38);
  a43=arg[3]? arg[3][9] : 0;
  a45=casadi_fabs(a43);
  a46=arg[0]? arg[0][11] : 0;
  a45=(a45<=a46);
  a43=(a45?a43:0);
  a46=(!a45);
  a47=arg[2]? arg[2][10] : 0;
  a46=(a46?a47:0);
  a43=(a43+a46);
  a46=(a13-a16);
  a46=(a43*a46);
  a46=(-a46);
  a38=(a38?a46:0);
  a46=(a10<a11);
  a47=arg[2]? arg[2][31] : 0;
  a46=(a46?a47:0);
  a38=(a38+a46);
  a46=(a10<a11);
  a47=arg[2]? arg[2][27] : 0;
  a47=(a46?a47:0);
  a46=(!a46);
  a46=(a46?a41:0);
  a47=(a47+a46);
  a46=arg[1]? arg[1][12] : 0;
  a48=(-a46);
  a49=arg[3]? arg[3][2] : 0;
  a50=casadi_fabs(a49);
  a51=arg[0]? arg[0][4] : 0;
  a50=(a50<=a51);
  a49=(a50?a49:0);
  a51=(!a50);
  a52=arg[2]? arg[2][3] : 0;
  a51=(a51?a52:0);
  a49=(a49+a51);
  a51=(a49-a47);
  a46=casadi_fmin(a46,a51);
  a48=casadi_fmax(a48,a46);
  a47=(a47+a48);
  a48=(a47-a41);
  a46=arg[0]? arg[0][47] : 0;
  a46=(a48*a46);
  a46=(a38+a46);
  a51=(a43*a16);
  a46=(a46-a51);
  a40=casadi_fmin(a40,a46);
  a44=casadi_fmax(a44,a40);
  a40=casadi_fabs(a44);
  a39=(a24*a39);
  a40=(a40<=a39);
  a39=(a40?a05:0);
  a39=(a39<a10);
  a51=arg[0]? arg[0][25] : 0;
  a52=arg[0]? arg[0][28] : 0;
  a53=(a51*a52);
  a54=arg[3]? arg[3][8] : 0;
  a55=casadi_fabs(a54);
  a56=arg[0]? arg[0][10] : 0;
  a55=(a55<=a56);
  a54=(a55?a54:0);
  a56=(!a55);
  a57=arg[2]? arg[2][9] : 0;
  a56=(a56?a57:0);
  a54=(a54+a56);
  a56=casadi_fabs(a54);
  a51=casadi_fmax(a51,a56);
  a53=(a53/a51);
  a51=arg[1]? arg[1][4] : 0;
  a56=arg[1]? arg[1][3] : 0;
  a57=(a54*a56);
  a57=(a51+a57);
  a57=casadi_fmin(a05,a57);
  a57=casadi_fmax(a00,a57);
  a57=(a53*a57);
  a57=(-a57);
  a56=(a54*a56);
  a51=(a51-a56);
  a51=casadi_fmin(a05,a51);
  a51=casadi_fmax(a00,a51);
  a53=(a53*a51);
  a51=arg[0]? arg[0][46] : 0;
  a51=(a00<a51);
  a56=arg[3]? arg[3][7] : 0;
  a58=casadi_fabs(a56);
  a59=arg[0]? arg[0][9] : 0;
  a58=(a58<=a59);
  a56=(a58?a56:0);
  a59=(!a58);
  a60=arg[2]? arg[2][8] : 0;
  a59=(a59?a60:0);
  a56=(a56+a59);
  a13=(a13-a16);
  a13=(a56*a13);
  a13=(-a13);
  a51=(a51?a13:0);
  a13=(a10<a11);
  a59=arg[2]? arg[2][30] : 0;
  a13=(a13?a59:0);
  a51=(a51+a13);
  a13=(a10<a11);
  a59=arg[2]? arg[2][26] : 0;
  a59=(a13?a59:0);
  a13=(!a13);
  a13=(a13?a54:0);
  a59=(a59+a13);
  a13=arg[1]? arg[1][11] : 0;
  a60=(-a13);
  a61=arg[3]? arg[3][1] : 0;
  a62=casadi_fabs(a61);
  a63=arg[0]? arg[0][3] : 0;
  a62=(a62<=a63);
  a61=(a62?a61:0);
  a63=(!a62);
  a64=arg[2]? arg[2][2] : 0;
  a63=(a63?a64:0);
  a61=(a61+a63);
  a63=(a61-a59);
  a13=casadi_fmin(a13,a63);
  a60=casadi_fmax(a60,a13);
  a59=(a59+a60);
  a60=(a59-a54);
  a13=arg[0]? arg[0][45] : 0;
  a13=(a60*a13);
  a13=(a51+a13);
  a63=(a56*a16);
  a13=(a13-a63);
  a53=casadi_fmin(a53,a13);
  a57=casadi_fmax(a57,a53);
  a53=casadi_fabs(a57);
  a52=(a24*a52);
  a53=(a53<=a52);
  a52=(a53?a05:0);
  a52=(a52<a10);
  a63=arg[0]? arg[0][21] : 0;
  a64=arg[0]? arg[0][24] : 0;
  a65=(a63*a64);
  a66=arg[3]? arg[3][5] : 0;
  a67=casadi_fabs(a66);
  a68=arg[0]? arg[0][7] : 0;
  a67=(a67<=a68);
  a66=(a67?a66:0);
  a68=(!a67);
  a69=arg[2]? arg[2][6] : 0;
  a68=(a68?a69:0);
  a66=(a66+a68);
  a68=casadi_fabs(a66);
  a63=casadi_fmax(a63,a68);
  a65=(a65/a63);
  a63=arg[1]? arg[1][2] : 0;
  a68=arg[1]? arg[1][1] : 0;
  a69=(a66*a68);
  a69=(a63+a69);
  a69=casadi_fmin(a05,a69);
  a69=casadi_fmax(a00,a69);
  a69=(a65*a69);
  a70=(-a69);
  a68=(a66*a68);
  a63=(a63-a68);
  a63=casadi_fmin(a05,a63);
  a63=casadi_fmax(a00,a63);
  a65=(a65*a63);
  a63=arg[0]? arg[0][20] : 0;
  a68=(a10<a11);
  a71=arg[2]? arg[2][23] : 0;
  a71=(a68?a71:0);
  a68=(!a68);
  a68=(a68?a63:0);
  a71=(a71+a68);
  a68=(a63-a71);
  a72=casadi_fabs(a68);
  a73=arg[2]? arg[2][24] : 0;
  a73=(a63!=a73);
  a74=casadi_fabs(a68);
  a74=(a17*a74);
  a75=casadi_fabs(a63);
  a75=(a19*a75);
  a76=casadi_fabs(a71);
  a76=(a19*a76);
  a75=(a75+a76);
  a74=casadi_fmax(a74,a75);
  a74=(a73?a74:0);
  a73=(!a73);
  a75=arg[2]? arg[2][25] : 0;
  a73=(a73?a75:0);
  a74=(a74+a73);
  a72=(a72<=a74);
  a73=(a72?a63:0);
  a72=(!a72);
  a75=(a00<a68);
  a76=(a71+a74);
  a76=(a75?a76:0);
  a75=(!a75);
  a71=(a71-a74);
  a75=(a75?a71:0);
  a76=(a76+a75);
  a72=(a72?a76:0);
  a73=(a73+a72);
  a72=arg[1]? arg[1][34] : 0;
  a72=(a72*a54);
  a72=(a72-a66);
  a76=arg[1]? arg[1][35] : 0;
  a76=(a76*a41);
  a72=(a72+a76);
  a76=arg[1]? arg[1][36] : 0;
  a76=(a76*a28);
  a72=(a72+a76);
  a76=arg[1]? arg[1][37] : 0;
  a76=(a76*a03);
  a72=(a72+a76);
  a72=(a73*a72);
  a76=arg[0]? arg[0][72] : 0;
  a75=(a05-a76);
  a69=(a69*a75);
  a69=(-a69);
  a75=(a10<a11);
  a71=arg[2]? arg[2][37] : 0;
  a75=(a75?a71:0);
  a71=arg[0]? arg[0][62] : 0;
  a77=(a10<a11);
  a78=arg[2]? arg[2][34] : 0;
  a78=(a77?a78:0);
  a77=(!a77);
  a79=arg[3]? arg[3][6] : 0;
  a80=casadi_fabs(a79);
  a81=arg[0]? arg[0][8] : 0;
  a80=(a80<=a81);
  a79=(a80?a79:0);
  a81=(!a80);
  a82=arg[2]? arg[2][7] : 0;
  a81=(a81?a82:0);
  a79=(a79+a81);
  a81=arg[1]? arg[1][23] : 0;
  a82=(a57+a56);
  a81=(a81*a82);
  a81=(a79+a81);
  a83=arg[1]? arg[1][24] : 0;
  a84=(a44+a43);
  a83=(a83*a84);
  a81=(a81+a83);
  a83=arg[1]? arg[1][25] : 0;
  a85=(a31+a30);
  a83=(a83*a85);
  a81=(a81+a83);
  a83=arg[1]? arg[1][26] : 0;
  a86=(a08+a07);
  a83=(a83*a86);
  a81=(a81+a83);
  a77=(a77?a81:0);
  a78=(a78+a77);
  a77=arg[1]? arg[1][27] : 0;
  a83=(-a77);
  a87=arg[3]? arg[3][0] : 0;
  a88=casadi_fabs(a87);
  a89=arg[0]? arg[0][2] : 0;
  a88=(a88<=a89);
  a87=(a88?a87:0);
  a89=(!a88);
  a90=arg[2]? arg[2][1] : 0;
  a89=(a89?a90:0);
  a87=(a87+a89);
  a89=(a87-a78);
  a77=casadi_fmin(a77,a89);
  a83=casadi_fmax(a83,a77);
  a78=(a78+a83);
  a71=(a71*a78);
  a71=(a75+a71);
  a83=(a10<a11);
  a77=arg[2]? arg[2][35] : 0;
  a77=(a83?a77:0);
  a83=(!a83);
  a83=(a83?a81:0);
  a77=(a77+a83);
  a83=(a10<a11);
  a89=arg[2]? arg[2][36] : 0;
  a90=(a83?a89:0);
  a91=arg[1]? arg[1][28] : 0;
  a92=(a78-a77);
  a91=(a91*a92);
  a90=(a90+a91);
  a91=arg[1]? arg[1][29] : 0;
  a91=(a91*a89);
  a91=(-a91);
  a83=(a83?a91:0);
  a90=(a90+a83);
  a83=arg[0]? arg[0][0] : 0;
  a91=(a90*a83);
  a77=(a77+a91);
  a91=arg[0]? arg[0][67] : 0;
  a89=(a77*a91);
  a89=(a89-a81);
  a91=(a05-a91);
  a91=(a78*a91);
  a89=(a89+a91);
  a91=arg[0]? arg[0][63] : 0;
  a91=(a89*a91);
  a71=(a71+a91);
  a91=arg[0]? arg[0][18] : 0;
  a11=(a10<a11);
  a81=arg[2]? arg[2][20] : 0;
  a81=(a11?a81:0);
  a11=(!a11);
  a11=(a11?a91:0);
  a81=(a81+a11);
  a11=(a91-a81);
  a92=casadi_fabs(a11);
  a93=arg[2]? arg[2][21] : 0;
  a93=(a91!=a93);
  a94=casadi_fabs(a11);
  a17=(a17*a94);
  a94=casadi_fabs(a91);
  a94=(a19*a94);
  a95=casadi_fabs(a81);
  a19=(a19*a95);
  a94=(a94+a19);
  a17=casadi_fmax(a17,a94);
  a17=(a93?a17:0);
  a93=(!a93);
  a94=arg[2]? arg[2][22] : 0;
  a93=(a93?a94:0);
  a17=(a17+a93);
  a92=(a92<=a17);
  a93=(a92?a91:0);
  a92=(!a92);
  a94=(a00<a11);
  a19=(a81+a17);
  a19=(a94?a19:0);
  a94=(!a94);
  a81=(a81-a17);
  a94=(a94?a81:0);
  a19=(a19+a94);
  a92=(a92?a19:0);
  a93=(a93+a92);
  a92=arg[1]? arg[1][30] : 0;
  a92=(a92*a82);
  a82=arg[1]? arg[1][31] : 0;
  a82=(a82*a84);
  a92=(a92+a82);
  a82=arg[1]? arg[1][32] : 0;
  a82=(a82*a85);
  a92=(a92+a82);
  a82=arg[1]? arg[1][33] : 0;
  a82=(a82*a86);
  a92=(a92+a82);
  a92=(a93*a92);
  a71=(a71+a92);
  a76=(a05-a76);
  a76=(a65*a76);
  a76=casadi_fmin(a71,a76);
  a69=casadi_fmax(a69,a76);
  a72=(a72+a69);
  a65=casadi_fmin(a65,a72);
  a70=casadi_fmax(a70,a65);
  a65=casadi_fabs(a70);
  a24=(a24*a64);
  a65=(a65<=a24);
  a24=(a65?a05:0);
  a24=(a24<a10);
  a04=(a04?a05:0);
  a04=(a04<a10);
  a29=(a29?a05:0);
  a29=(a29<a10);
  a42=(a42?a05:0);
  a42=(a42<a10);
  a55=(a55?a05:0);
  a55=(a55<a10);
  a67=(a67?a05:0);
  a67=(a67<a10);
  a23=(a23?a05:0);
  a23=(a23<a10);
  a37=(a37?a05:0);
  a37=(a37<a10);
  a50=(a50?a05:0);
  a50=(a50<a10);
  a62=(a62?a05:0);
  a62=(a62<a10);
  a88=(a88?a05:0);
  a88=(a88<a10);
  a64=arg[2]? arg[2][0] : 0;
  a72=(a64<a10);
  a88=(a88&&a72);
  a72=(a88?a05:0);
  a88=(!a88);
  a88=(a88?a64:0);
  a72=(a72+a88);
  a88=(a72<a10);
  a62=(a62&&a88);
  a88=2.;
  a88=(a62?a88:0);
  a62=(!a62);
  a62=(a62?a72:0);
  a88=(a88+a62);
  a62=(a88<a10);
  a50=(a50&&a62);
  a62=3.;
  a62=(a50?a62:0);
  a50=(!a50);
  a50=(a50?a88:0);
  a62=(a62+a50);
  a50=(a62<a10);
  a37=(a37&&a50);
  a50=4.;
  a50=(a37?a50:0);
  a37=(!a37);
  a37=(a37?a62:0);
  a50=(a50+a37);
  a37=(a50<a10);
  a23=(a23&&a37);
  a37=5.;
  a37=(a23?a37:0);
  a23=(!a23);
  a23=(a23?a50:0);
  a37=(a37+a23);
  a23=(a37<a10);
  a67=(a67&&a23);
  a23=6.;
  a23=(a67?a23:0);
  a67=(!a67);
  a67=(a67?a37:0);
  a23=(a23+a67);
  a67=(a23<a10);
  a80=(a80?a05:0);
  a80=(a80<a10);
  a67=(a67&&a80);
  a80=7.;
  a80=(a67?a80:0);
  a67=(!a67);
  a67=(a67?a23:0);
  a80=(a80+a67);
  a67=(a80<a10);
  a58=(a58?a05:0);
  a58=(a58<a10);
  a67=(a67&&a58);
  a58=8.;
  a58=(a67?a58:0);
  a67=(!a67);
  a67=(a67?a80:0);
  a58=(a58+a67);
  a67=(a58<a10);
  a55=(a55&&a67);
  a67=9.;
  a67=(a55?a67:0);
  a55=(!a55);
  a55=(a55?a58:0);
  a67=(a67+a55);
  a55=(a67<a10);
  a45=(a45?a05:0);
  a45=(a45<a10);
  a55=(a55&&a45);
  a45=10.;
  a45=(a55?a45:0);
  a55=(!a55);
  a55=(a55?a67:0);
  a45=(a45+a55);
  a55=(a45<a10);
  a42=(a42&&a55);
  a55=11.;
  a55=(a42?a55:0);
  a42=(!a42);
  a42=(a42?a45:0);
  a55=(a55+a42);
  a42=(a55<a10);
  a32=(a32?a05:0);
  a32=(a32<a10);
  a42=(a42&&a32);
  a32=12.;
  a32=(a42?a32:0);
  a42=(!a42);
  a42=(a42?a55:0);
  a32=(a32+a42);
  a42=(a32<a10);
  a29=(a29&&a42);
  a42=13.;
  a42=(a29?a42:0);
  a29=(!a29);
  a29=(a29?a32:0);
  a42=(a42+a29);
  a29=(a42<a10);
  a09=(a09?a05:0);
  a09=(a09<a10);
  a29=(a29&&a09);
  a09=14.;
  a09=(a29?a09:0);
  a29=(!a29);
  a29=(a29?a42:0);
  a09=(a09+a29);
  a29=(a09<a10);
  a04=(a04&&a29);
  a29=15.;
  a29=(a04?a29:0);
  a04=(!a04);
  a04=(a04?a09:0);
  a29=(a29+a04);
  a04=(a29<a10);
  a24=(a24&&a04);
  a04=16.;
  a04=(a24?a04:0);
  a24=(!a24);
  a24=(a24?a29:0);
  a04=(a04+a24);
  a24=(a04<a10);
  a52=(a52&&a24);
  a24=17.;
  a24=(a52?a24:0);
  a52=(!a52);
  a52=(a52?a04:0);
  a24=(a24+a52);
  a52=(a24<a10);
  a39=(a39&&a52);
  a52=18.;
  a52=(a39?a52:0);
  a39=(!a39);
  a39=(a39?a24:0);
  a52=(a52+a39);
  a39=(a52<a10);
  a26=(a26&&a39);
  a39=19.;
  a39=(a26?a39:0);
  a26=(!a26);
  a26=(a26?a52:0);
  a39=(a39+a26);
  a26=(a39<a10);
  a01=(a01&&a26);
  a26=20.;
  a26=(a01?a26:0);
  a01=(!a01);
  a01=(a01?a39:0);
  a26=(a26+a01);
  if (res[0]!=0) res[0][0]=a26;
  if (res[0]!=0) res[0][1]=a87;
  if (res[0]!=0) res[0][2]=a61;
  if (res[0]!=0) res[0][3]=a49;
  if (res[0]!=0) res[0][4]=a36;
  if (res[0]!=0) res[0][5]=a22;
  if (res[0]!=0) res[0][6]=a66;
  if (res[0]!=0) res[0][7]=a79;
  if (res[0]!=0) res[0][8]=a56;
  if (res[0]!=0) res[0][9]=a54;
  if (res[0]!=0) res[0][10]=a43;
  if (res[0]!=0) res[0][11]=a41;
  if (res[0]!=0) res[0][12]=a30;
  if (res[0]!=0) res[0][13]=a28;
  if (res[0]!=0) res[0][14]=a07;
  if (res[0]!=0) res[0][15]=a03;
  if (res[0]!=0) res[0][16]=a16;
  if (res[0]!=0) res[0][17]=a14;
  a12=casadi_fabs(a12);
  a12=(a12<=a18);
  a12=(!a12);
  a12=(a12?a18:0);
  if (res[0]!=0) res[0][18]=a12;
  a12=(a26<a10);
  a12=(a12?a05:0);
  if (res[0]!=0) res[0][19]=a12;
  if (res[0]!=0) res[0][20]=a93;
  if (res[0]!=0) res[0][21]=a91;
  a11=casadi_fabs(a11);
  a11=(a11<=a17);
  a11=(!a11);
  a11=(a11?a17:0);
  if (res[0]!=0) res[0][22]=a11;
  if (res[0]!=0) res[0][23]=a73;
  if (res[0]!=0) res[0][24]=a63;
  a68=casadi_fabs(a68);
  a68=(a68<=a74);
  a68=(!a68);
  a68=(a68?a74:0);
  if (res[0]!=0) res[0][25]=a68;
  if (res[0]!=0) res[0][26]=a59;
  if (res[0]!=0) res[0][27]=a47;
  if (res[0]!=0) res[0][28]=a34;
  if (res[0]!=0) res[0][29]=a21;
  a13=(a57-a13);
  a21=arg[1]? arg[1][16] : 0;
  a13=(a13*a21);
  a51=(a51+a13);
  a13=arg[1]? arg[1][15] : 0;
  a60=(a60*a13);
  a51=(a51+a60);
  if (res[0]!=0) res[0][30]=a51;
  a46=(a44-a46);
  a51=arg[1]? arg[1][18] : 0;
  a46=(a46*a51);
  a38=(a38+a46);
  a46=arg[1]? arg[1][17] : 0;
  a48=(a48*a46);
  a38=(a38+a48);
  if (res[0]!=0) res[0][31]=a38;
  a33=(a31-a33);
  a38=arg[1]? arg[1][20] : 0;
  a33=(a33*a38);
  a25=(a25+a33);
  a33=arg[1]? arg[1][19] : 0;
  a35=(a35*a33);
  a25=(a25+a35);
  if (res[0]!=0) res[0][32]=a25;
  a15=(a08-a15);
  a25=arg[1]? arg[1][22] : 0;
  a15=(a15*a25);
  a06=(a06+a15);
  a15=arg[1]? arg[1][21] : 0;
  a20=(a20*a15);
  a06=(a06+a20);
  if (res[0]!=0) res[0][33]=a06;
  if (res[0]!=0) res[0][34]=a78;
  if (res[0]!=0) res[0][35]=a77;
  if (res[0]!=0) res[0][36]=a90;
  a71=(a71-a69);
  a71=(a89*a71);
  a71=(a00<a71);
  a69=(a71?a75:0);
  a71=(!a71);
  a90=arg[0]? arg[0][73] : 0;
  a77=(-a90);
  a78=arg[1]? arg[1][38] : 0;
  a89=(a89*a78);
  a75=(a75+a89);
  a90=casadi_fmin(a90,a75);
  a77=casadi_fmax(a77,a90);
  a71=(a71?a77:0);
  a69=(a69+a71);
  if (res[0]!=0) res[0][37]=a69;
  a69=(a10<a26);
  a71=arg[2]? arg[2][38] : 0;
  a77=(a69?a71:0);
  a69=(!a69);
  a70=(a65?a70:0);
  a65=(!a65);
  a65=(a65?a71:0);
  a70=(a70+a65);
  a69=(a69?a70:0);
  a77=(a77+a69);
  if (res[0]!=0) res[0][38]=a77;
  a69=(a10<a26);
  a70=arg[2]? arg[2][39] : 0;
  a65=(a69?a70:0);
  a69=(!a69);
  a57=(a53?a57:0);
  a53=(!a53);
  a53=(a53?a70:0);
  a57=(a57+a53);
  a69=(a69?a57:0);
  a65=(a65+a69);
  if (res[0]!=0) res[0][39]=a65;
  a69=(a10<a26);
  a57=arg[2]? arg[2][40] : 0;
  a53=(a69?a57:0);
  a69=(!a69);
  a44=(a40?a44:0);
  a40=(!a40);
  a40=(a40?a57:0);
  a44=(a44+a40);
  a69=(a69?a44:0);
  a53=(a53+a69);
  if (res[0]!=0) res[0][40]=a53;
  a69=(a10<a26);
  a44=arg[2]? arg[2][41] : 0;
  a40=(a69?a44:0);
  a69=(!a69);
  a31=(a27?a31:0);
  a27=(!a27);
  a27=(a27?a44:0);
  a31=(a31+a27);
  a69=(a69?a31:0);
  a40=(a40+a69);
  if (res[0]!=0) res[0][41]=a40;
  a69=(a10<a26);
  a31=arg[2]? arg[2][42] : 0;
  a27=(a69?a31:0);
  a69=(!a69);
  a08=(a02?a08:0);
  a02=(!a02);
  a02=(a02?a31:0);
  a08=(a08+a02);
  a69=(a69?a08:0);
  a27=(a27+a69);
  if (res[0]!=0) res[0][42]=a27;
  a10=(a10<a26);
  a26=arg[2]? arg[2][43] : 0;
  a69=arg[0]? arg[0][1] : 0;
  a83=(a83/a69);
  a83=(a26-a83);
  a00=casadi_fmax(a00,a83);
  a00=(a10?a00:0);
  a10=(!a10);
  a10=(a10?a26:0);
  a00=(a00+a10);
  if (res[0]!=0) res[0][43]=a00;
  a77=(a77*a00);
  if (res[1]!=0) res[1][0]=a77;
  a65=(a65*a00);
  if (res[1]!=0) res[1][1]=a65;
  a53=(a53*a00);
  if (res[1]!=0) res[1][2]=a53;
  a40=(a40*a00);
  if (res[1]!=0) res[1][3]=a40;
  a27=(a27*a00);
  if (res[1]!=0) res[1][4]=a27;
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


