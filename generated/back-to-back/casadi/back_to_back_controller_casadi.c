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
CASADI_SYMBOL_EXPORT void back_to_back_controller_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int back_to_back_controller_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int back_to_back_controller_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {35, 1, 1};
static const casadi_int casadi_s1[3] = {14, 1, 1};
static const casadi_int casadi_s2[3] = {26, 1, 1};
static const casadi_int casadi_s3[3] = {6, 1, 1};
static const casadi_int casadi_s4[3] = {2, 1, 1};

static const casadi_real casadi_zeros[35] = 
  {0.};

/* controller_prepare:(parameters[35])->(derived[14]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real w1, w2, w3, w4;
  const casadi_real *wr0;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = @0[0] */
  w1 = wr0[0];
  /* #2: @2 = @0[10] */
  w2 = wr0[10];
  /* #3: @2 = (@1/@2) */
  w2  = (w1/w2);
  /* #4: output[0][0] = @2 */
  if (res[0]) res[0][0] = w2;
  /* #5: @2 = @0[14] */
  w2 = wr0[14];
  /* #6: @3 = (1./@2) */
  w3 = (1./ w2 );
  /* #7: output[0][1] = @3 */
  if (res[0]) res[0][1] = w3;
  /* #8: @3 = 1 */
  w3 = 1.;
  /* #9: @4 = @0[13] */
  w4 = wr0[13];
  /* #10: @4 = (@4/@2) */
  w4 /= w2;
  /* #11: @3 = (@3+@4) */
  w3 += w4;
  /* #12: output[0][2] = @3 */
  if (res[0]) res[0][2] = w3;
  /* #13: @3 = @0[18] */
  w3 = wr0[18];
  /* #14: @4 = (1./@3) */
  w4 = (1./ w3 );
  /* #15: output[0][3] = @4 */
  if (res[0]) res[0][3] = w4;
  /* #16: @4 = 1 */
  w4 = 1.;
  /* #17: @2 = @0[17] */
  w2 = wr0[17];
  /* #18: @2 = (@2/@3) */
  w2 /= w3;
  /* #19: @4 = (@4+@2) */
  w4 += w2;
  /* #20: output[0][4] = @4 */
  if (res[0]) res[0][4] = w4;
  /* #21: @4 = @0[20] */
  w4 = wr0[20];
  /* #22: @4 = (@4*@1) */
  w4 *= w1;
  /* #23: output[0][5] = @4 */
  if (res[0]) res[0][5] = w4;
  /* #24: @4 = @0[22] */
  w4 = wr0[22];
  /* #25: @2 = (@4*@1) */
  w2  = (w4*w1);
  /* #26: output[0][6] = @2 */
  if (res[0]) res[0][6] = w2;
  /* #27: @4 = (@4*@1) */
  w4 *= w1;
  /* #28: @2 = @0[21] */
  w2 = wr0[21];
  /* #29: @4 = (@4/@2) */
  w4 /= w2;
  /* #30: output[0][7] = @4 */
  if (res[0]) res[0][7] = w4;
  /* #31: @4 = @0[23] */
  w4 = wr0[23];
  /* #32: @2 = @0[24] */
  w2 = wr0[24];
  /* #33: @4 = (@4/@2) */
  w4 /= w2;
  /* #34: output[0][8] = @4 */
  if (res[0]) res[0][8] = w4;
  /* #35: @4 = @0[28] */
  w4 = wr0[28];
  /* #36: @4 = (@4*@1) */
  w4 *= w1;
  /* #37: output[0][9] = @4 */
  if (res[0]) res[0][9] = w4;
  /* #38: @4 = @0[29] */
  w4 = wr0[29];
  /* #39: @4 = (@4*@1) */
  w4 *= w1;
  /* #40: @3 = @0[25] */
  w3 = wr0[25];
  /* #41: @4 = (@4/@3) */
  w4 /= w3;
  /* #42: output[0][10] = @4 */
  if (res[0]) res[0][10] = w4;
  /* #43: @4 = @0[30] */
  w4 = wr0[30];
  /* #44: @4 = (@4*@1) */
  w4 *= w1;
  /* #45: @4 = (@4/@3) */
  w4 /= w3;
  /* #46: output[0][11] = @4 */
  if (res[0]) res[0][11] = w4;
  /* #47: @3 = (@3/@2) */
  w3 /= w2;
  /* #48: output[0][12] = @3 */
  if (res[0]) res[0][12] = w3;
  /* #49: @3 = @0[32] */
  w3 = wr0[32];
  /* #50: @3 = (@3*@1) */
  w3 *= w1;
  /* #51: output[0][13] = @3 */
  if (res[0]) res[0][13] = w3;
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

/* controller_step:(parameters[35],derived[14],states[26],inputs[6])->(next_states[26],outputs[2]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53;
  a00=arg[0]? arg[0][16] : 0;
  a01=arg[0]? arg[0][19] : 0;
  a02=(a00*a01);
  a03=arg[3]? arg[3][5] : 0;
  a04=casadi_fabs(a03);
  a05=arg[0]? arg[0][7] : 0;
  a04=(a04<=a05);
  a03=(a04?a03:0);
  a05=(!a04);
  a06=arg[2]? arg[2][6] : 0;
  a05=(a05?a06:0);
  a03=(a03+a05);
  a05=casadi_fabs(a03);
  a00=casadi_fmax(a00,a05);
  a02=(a02/a00);
  a00=0.;
  a05=1.;
  a06=arg[1]? arg[1][4] : 0;
  a07=arg[1]? arg[1][3] : 0;
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
  a06=arg[0]? arg[0][22] : 0;
  a06=(a00<a06);
  a07=arg[3]? arg[3][4] : 0;
  a09=casadi_fabs(a07);
  a10=arg[0]? arg[0][6] : 0;
  a09=(a09<=a10);
  a07=(a09?a07:0);
  a10=(!a09);
  a11=arg[2]? arg[2][5] : 0;
  a10=(a10?a11:0);
  a07=(a07+a10);
  a10=5.0000000000000000e-01;
  a11=arg[2]? arg[2][10] : 0;
  a12=(a10<a11);
  a13=arg[2]? arg[2][7] : 0;
  a13=(a12?a13:0);
  a12=(!a12);
  a14=arg[0]? arg[0][8] : 0;
  a12=(a12?a14:0);
  a13=(a13+a12);
  a12=(a14-a13);
  a15=casadi_fabs(a12);
  a16=arg[2]? arg[2][8] : 0;
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
  a20=arg[2]? arg[2][9] : 0;
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
  a13=(a13-a16);
  a13=(a07*a13);
  a13=(-a13);
  a06=(a06?a13:0);
  a13=(a10<a11);
  a15=arg[2]? arg[2][18] : 0;
  a13=(a13?a15:0);
  a06=(a06+a13);
  a13=(a10<a11);
  a15=arg[2]? arg[2][17] : 0;
  a15=(a13?a15:0);
  a13=(!a13);
  a13=(a13?a03:0);
  a15=(a15+a13);
  a13=arg[1]? arg[1][5] : 0;
  a21=(-a13);
  a20=arg[3]? arg[3][1] : 0;
  a22=casadi_fabs(a20);
  a23=arg[0]? arg[0][3] : 0;
  a22=(a22<=a23);
  a20=(a22?a20:0);
  a23=(!a22);
  a24=arg[2]? arg[2][2] : 0;
  a23=(a23?a24:0);
  a20=(a20+a23);
  a23=(a20-a15);
  a13=casadi_fmin(a13,a23);
  a21=casadi_fmax(a21,a13);
  a15=(a15+a21);
  a21=(a15-a03);
  a13=arg[0]? arg[0][21] : 0;
  a13=(a21*a13);
  a13=(a06+a13);
  a23=(a07*a16);
  a13=(a13-a23);
  a02=casadi_fmin(a02,a13);
  a08=casadi_fmax(a08,a02);
  a02=casadi_fabs(a08);
  a23=1.0100000000000000e+00;
  a01=(a23*a01);
  a02=(a02<=a01);
  a01=(a02?a05:0);
  a01=(a01<a10);
  a24=arg[0]? arg[0][12] : 0;
  a25=arg[0]? arg[0][15] : 0;
  a26=(a24*a25);
  a27=arg[3]? arg[3][2] : 0;
  a28=casadi_fabs(a27);
  a29=arg[0]? arg[0][4] : 0;
  a28=(a28<=a29);
  a27=(a28?a27:0);
  a29=(!a28);
  a30=arg[2]? arg[2][3] : 0;
  a29=(a29?a30:0);
  a27=(a27+a29);
  a29=casadi_fabs(a27);
  a24=casadi_fmax(a24,a29);
  a26=(a26/a24);
  a24=arg[1]? arg[1][2] : 0;
  a29=arg[1]? arg[1][1] : 0;
  a30=(a27*a29);
  a30=(a24+a30);
  a30=casadi_fmin(a05,a30);
  a30=casadi_fmax(a00,a30);
  a30=(a26*a30);
  a31=(-a30);
  a29=(a27*a29);
  a24=(a24-a29);
  a24=casadi_fmin(a05,a24);
  a24=casadi_fmax(a00,a24);
  a26=(a26*a24);
  a24=arg[0]? arg[0][11] : 0;
  a29=(a10<a11);
  a32=arg[2]? arg[2][14] : 0;
  a32=(a29?a32:0);
  a29=(!a29);
  a29=(a29?a24:0);
  a32=(a32+a29);
  a29=(a24-a32);
  a33=casadi_fabs(a29);
  a34=arg[2]? arg[2][15] : 0;
  a34=(a24!=a34);
  a35=casadi_fabs(a29);
  a35=(a17*a35);
  a36=casadi_fabs(a24);
  a36=(a19*a36);
  a37=casadi_fabs(a32);
  a37=(a19*a37);
  a36=(a36+a37);
  a35=casadi_fmax(a35,a36);
  a35=(a34?a35:0);
  a34=(!a34);
  a36=arg[2]? arg[2][16] : 0;
  a34=(a34?a36:0);
  a35=(a35+a34);
  a33=(a33<=a35);
  a34=(a33?a24:0);
  a33=(!a33);
  a36=(a00<a29);
  a37=(a32+a35);
  a37=(a36?a37:0);
  a36=(!a36);
  a32=(a32-a35);
  a36=(a36?a32:0);
  a37=(a37+a36);
  a33=(a33?a37:0);
  a34=(a34+a33);
  a33=(a03-a27);
  a33=(a34*a33);
  a37=arg[0]? arg[0][33] : 0;
  a36=(a05-a37);
  a30=(a30*a36);
  a30=(-a30);
  a36=(a10<a11);
  a32=arg[2]? arg[2][22] : 0;
  a36=(a36?a32:0);
  a32=arg[0]? arg[0][26] : 0;
  a38=(a10<a11);
  a39=arg[2]? arg[2][19] : 0;
  a39=(a38?a39:0);
  a38=(!a38);
  a40=arg[3]? arg[3][3] : 0;
  a41=casadi_fabs(a40);
  a42=arg[0]? arg[0][5] : 0;
  a41=(a41<=a42);
  a40=(a41?a40:0);
  a42=(!a41);
  a43=arg[2]? arg[2][4] : 0;
  a42=(a42?a43:0);
  a40=(a40+a42);
  a42=arg[1]? arg[1][8] : 0;
  a43=(a08+a07);
  a42=(a42*a43);
  a42=(a40+a42);
  a38=(a38?a42:0);
  a39=(a39+a38);
  a38=arg[1]? arg[1][9] : 0;
  a44=(-a38);
  a45=arg[3]? arg[3][0] : 0;
  a46=casadi_fabs(a45);
  a47=arg[0]? arg[0][2] : 0;
  a46=(a46<=a47);
  a45=(a46?a45:0);
  a47=(!a46);
  a48=arg[2]? arg[2][1] : 0;
  a47=(a47?a48:0);
  a45=(a45+a47);
  a47=(a45-a39);
  a38=casadi_fmin(a38,a47);
  a44=casadi_fmax(a44,a38);
  a39=(a39+a44);
  a32=(a32*a39);
  a32=(a36+a32);
  a44=(a10<a11);
  a38=arg[2]? arg[2][20] : 0;
  a38=(a44?a38:0);
  a44=(!a44);
  a44=(a44?a42:0);
  a38=(a38+a44);
  a44=(a10<a11);
  a47=arg[2]? arg[2][21] : 0;
  a48=(a44?a47:0);
  a49=arg[1]? arg[1][10] : 0;
  a50=(a39-a38);
  a49=(a49*a50);
  a48=(a48+a49);
  a49=arg[1]? arg[1][11] : 0;
  a49=(a49*a47);
  a49=(-a49);
  a44=(a44?a49:0);
  a48=(a48+a44);
  a44=arg[0]? arg[0][0] : 0;
  a49=(a48*a44);
  a38=(a38+a49);
  a49=arg[0]? arg[0][31] : 0;
  a47=(a38*a49);
  a47=(a47-a42);
  a49=(a05-a49);
  a49=(a39*a49);
  a47=(a47+a49);
  a49=arg[0]? arg[0][27] : 0;
  a49=(a47*a49);
  a32=(a32+a49);
  a49=arg[1]? arg[1][12] : 0;
  a49=(a49*a43);
  a43=arg[0]? arg[0][9] : 0;
  a11=(a10<a11);
  a42=arg[2]? arg[2][11] : 0;
  a42=(a11?a42:0);
  a11=(!a11);
  a11=(a11?a43:0);
  a42=(a42+a11);
  a11=(a43-a42);
  a50=casadi_fabs(a11);
  a51=arg[2]? arg[2][12] : 0;
  a51=(a43!=a51);
  a52=casadi_fabs(a11);
  a17=(a17*a52);
  a52=casadi_fabs(a43);
  a52=(a19*a52);
  a53=casadi_fabs(a42);
  a19=(a19*a53);
  a52=(a52+a19);
  a17=casadi_fmax(a17,a52);
  a17=(a51?a17:0);
  a51=(!a51);
  a52=arg[2]? arg[2][13] : 0;
  a51=(a51?a52:0);
  a17=(a17+a51);
  a50=(a50<=a17);
  a51=(a50?a43:0);
  a50=(!a50);
  a52=(a00<a11);
  a19=(a42+a17);
  a19=(a52?a19:0);
  a52=(!a52);
  a42=(a42-a17);
  a52=(a52?a42:0);
  a19=(a19+a52);
  a50=(a50?a19:0);
  a51=(a51+a50);
  a49=(a49*a51);
  a32=(a32+a49);
  a37=(a05-a37);
  a37=(a26*a37);
  a37=casadi_fmin(a32,a37);
  a30=casadi_fmax(a30,a37);
  a33=(a33+a30);
  a26=casadi_fmin(a26,a33);
  a31=casadi_fmax(a31,a26);
  a26=casadi_fabs(a31);
  a23=(a23*a25);
  a26=(a26<=a23);
  a23=(a26?a05:0);
  a23=(a23<a10);
  a04=(a04?a05:0);
  a04=(a04<a10);
  a28=(a28?a05:0);
  a28=(a28<a10);
  a22=(a22?a05:0);
  a22=(a22<a10);
  a25=arg[2]? arg[2][0] : 0;
  a33=(a25<a10);
  a46=(a46?a05:0);
  a46=(a46<a10);
  a33=(a33&&a46);
  a46=(a33?a05:0);
  a33=(!a33);
  a33=(a33?a25:0);
  a46=(a46+a33);
  a33=(a46<a10);
  a22=(a22&&a33);
  a33=2.;
  a33=(a22?a33:0);
  a22=(!a22);
  a22=(a22?a46:0);
  a33=(a33+a22);
  a22=(a33<a10);
  a28=(a28&&a22);
  a22=3.;
  a22=(a28?a22:0);
  a28=(!a28);
  a28=(a28?a33:0);
  a22=(a22+a28);
  a28=(a22<a10);
  a41=(a41?a05:0);
  a41=(a41<a10);
  a28=(a28&&a41);
  a41=4.;
  a41=(a28?a41:0);
  a28=(!a28);
  a28=(a28?a22:0);
  a41=(a41+a28);
  a28=(a41<a10);
  a09=(a09?a05:0);
  a09=(a09<a10);
  a28=(a28&&a09);
  a09=5.;
  a09=(a28?a09:0);
  a28=(!a28);
  a28=(a28?a41:0);
  a09=(a09+a28);
  a28=(a09<a10);
  a04=(a04&&a28);
  a28=6.;
  a28=(a04?a28:0);
  a04=(!a04);
  a04=(a04?a09:0);
  a28=(a28+a04);
  a04=(a28<a10);
  a23=(a23&&a04);
  a04=7.;
  a04=(a23?a04:0);
  a23=(!a23);
  a23=(a23?a28:0);
  a04=(a04+a23);
  a23=(a04<a10);
  a01=(a01&&a23);
  a23=8.;
  a23=(a01?a23:0);
  a01=(!a01);
  a01=(a01?a04:0);
  a23=(a23+a01);
  if (res[0]!=0) res[0][0]=a23;
  if (res[0]!=0) res[0][1]=a45;
  if (res[0]!=0) res[0][2]=a20;
  if (res[0]!=0) res[0][3]=a27;
  if (res[0]!=0) res[0][4]=a40;
  if (res[0]!=0) res[0][5]=a07;
  if (res[0]!=0) res[0][6]=a03;
  if (res[0]!=0) res[0][7]=a16;
  if (res[0]!=0) res[0][8]=a14;
  a12=casadi_fabs(a12);
  a12=(a12<=a18);
  a12=(!a12);
  a12=(a12?a18:0);
  if (res[0]!=0) res[0][9]=a12;
  a12=(a23<a10);
  a12=(a12?a05:0);
  if (res[0]!=0) res[0][10]=a12;
  if (res[0]!=0) res[0][11]=a51;
  if (res[0]!=0) res[0][12]=a43;
  a11=casadi_fabs(a11);
  a11=(a11<=a17);
  a11=(!a11);
  a11=(a11?a17:0);
  if (res[0]!=0) res[0][13]=a11;
  if (res[0]!=0) res[0][14]=a34;
  if (res[0]!=0) res[0][15]=a24;
  a29=casadi_fabs(a29);
  a29=(a29<=a35);
  a29=(!a29);
  a29=(a29?a35:0);
  if (res[0]!=0) res[0][16]=a29;
  if (res[0]!=0) res[0][17]=a15;
  a13=(a08-a13);
  a15=arg[1]? arg[1][7] : 0;
  a13=(a13*a15);
  a06=(a06+a13);
  a13=arg[1]? arg[1][6] : 0;
  a21=(a21*a13);
  a06=(a06+a21);
  if (res[0]!=0) res[0][18]=a06;
  if (res[0]!=0) res[0][19]=a39;
  if (res[0]!=0) res[0][20]=a38;
  if (res[0]!=0) res[0][21]=a48;
  a32=(a32-a30);
  a32=(a47*a32);
  a32=(a00<a32);
  a30=(a32?a36:0);
  a32=(!a32);
  a48=arg[0]? arg[0][34] : 0;
  a38=(-a48);
  a39=arg[1]? arg[1][13] : 0;
  a47=(a47*a39);
  a36=(a36+a47);
  a48=casadi_fmin(a48,a36);
  a38=casadi_fmax(a38,a48);
  a32=(a32?a38:0);
  a30=(a30+a32);
  if (res[0]!=0) res[0][22]=a30;
  a30=(a10<a23);
  a32=arg[2]? arg[2][23] : 0;
  a38=(a30?a32:0);
  a30=(!a30);
  a31=(a26?a31:0);
  a26=(!a26);
  a26=(a26?a32:0);
  a31=(a31+a26);
  a30=(a30?a31:0);
  a38=(a38+a30);
  if (res[0]!=0) res[0][23]=a38;
  a30=(a10<a23);
  a31=arg[2]? arg[2][24] : 0;
  a26=(a30?a31:0);
  a30=(!a30);
  a08=(a02?a08:0);
  a02=(!a02);
  a02=(a02?a31:0);
  a08=(a08+a02);
  a30=(a30?a08:0);
  a26=(a26+a30);
  if (res[0]!=0) res[0][24]=a26;
  a10=(a10<a23);
  a23=arg[2]? arg[2][25] : 0;
  a30=arg[0]? arg[0][1] : 0;
  a44=(a44/a30);
  a44=(a23-a44);
  a00=casadi_fmax(a00,a44);
  a00=(a10?a00:0);
  a10=(!a10);
  a10=(a10?a23:0);
  a00=(a00+a10);
  if (res[0]!=0) res[0][25]=a00;
  a38=(a38*a00);
  if (res[1]!=0) res[1][0]=a38;
  a26=(a26*a00);
  if (res[1]!=0) res[1][1]=a26;
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


