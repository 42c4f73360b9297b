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
CASADI_SYMBOL_EXPORT void differential_controller_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int differential_controller_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int differential_controller_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {68, 1, 1};
static const casadi_int casadi_s1[3] = {41, 1, 1};
static const casadi_int casadi_s2[3] = {89, 1, 1};
static const casadi_int casadi_s3[3] = {10, 1, 1};
static const casadi_int casadi_s4[3] = {3, 1, 1};

static const casadi_real casadi_zeros[68] = 
  {0.};

/* controller_prepare:(parameters[68])->(derived[41]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real w1, w2, w3, w4, w5, w6, w7, w8, w9;
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
  /* #7: @1 = @0[17] */
  w1 = wr0[17];
  /* #8: @1 = (@2/@1) */
  w1  = (w2/w1);
  /* #9: output[0][1] = @1 */
  if (res[0]) res[0][1] = w1;
  /* #10: @1 = @0[21] */
  w1 = wr0[21];
  /* #11: @3 = (1./@1) */
  w3 = (1./ w1 );
  /* #12: output[0][2] = @3 */
  if (res[0]) res[0][2] = w3;
  /* #13: @3 = 1 */
  w3 = 1.;
  /* #14: @4 = @0[20] */
  w4 = wr0[20];
  /* #15: @4 = (@4/@1) */
  w4 /= w1;
  /* #16: @3 = (@3+@4) */
  w3 += w4;
  /* #17: output[0][3] = @3 */
  if (res[0]) res[0][3] = w3;
  /* #18: @3 = @0[19] */
  w3 = wr0[19];
  /* #19: @4 = @0[22] */
  w4 = wr0[22];
  /* #20: @3 = (@3*@4) */
  w3 *= w4;
  /* #21: output[0][4] = @3 */
  if (res[0]) res[0][4] = w3;
  /* #22: @3 = @0[25] */
  w3 = wr0[25];
  /* #23: @1 = (1./@3) */
  w1 = (1./ w3 );
  /* #24: output[0][5] = @1 */
  if (res[0]) res[0][5] = w1;
  /* #25: @1 = 1 */
  w1 = 1.;
  /* #26: @5 = @0[24] */
  w5 = wr0[24];
  /* #27: @5 = (@5/@3) */
  w5 /= w3;
  /* #28: @1 = (@1+@5) */
  w1 += w5;
  /* #29: output[0][6] = @1 */
  if (res[0]) res[0][6] = w1;
  /* #30: @1 = @0[23] */
  w1 = wr0[23];
  /* #31: @5 = @0[26] */
  w5 = wr0[26];
  /* #32: @1 = (@1*@5) */
  w1 *= w5;
  /* #33: output[0][7] = @1 */
  if (res[0]) res[0][7] = w1;
  /* #34: @1 = @0[29] */
  w1 = wr0[29];
  /* #35: @3 = (1./@1) */
  w3 = (1./ w1 );
  /* #36: output[0][8] = @3 */
  if (res[0]) res[0][8] = w3;
  /* #37: @3 = 1 */
  w3 = 1.;
  /* #38: @6 = @0[28] */
  w6 = wr0[28];
  /* #39: @6 = (@6/@1) */
  w6 /= w1;
  /* #40: @3 = (@3+@6) */
  w3 += w6;
  /* #41: output[0][9] = @3 */
  if (res[0]) res[0][9] = w3;
  /* #42: @3 = @0[27] */
  w3 = wr0[27];
  /* #43: @6 = @0[30] */
  w6 = wr0[30];
  /* #44: @3 = (@3*@6) */
  w3 *= w6;
  /* #45: output[0][10] = @3 */
  if (res[0]) res[0][10] = w3;
  /* #46: @3 = @0[31] */
  w3 = wr0[31];
  /* #47: @3 = (@3*@2) */
  w3 *= w2;
  /* #48: output[0][11] = @3 */
  if (res[0]) res[0][11] = w3;
  /* #49: @3 = @0[32] */
  w3 = wr0[32];
  /* #50: @3 = (@2/@3) */
  w3  = (w2/w3);
  /* #51: output[0][12] = @3 */
  if (res[0]) res[0][12] = w3;
  /* #52: @3 = 0.05 */
  w3 = 5.0000000000000003e-02;
  /* #53: @3 = (@3*@4) */
  w3 *= w4;
  /* #54: output[0][13] = @3 */
  if (res[0]) res[0][13] = w3;
  /* #55: @3 = @0[36] */
  w3 = wr0[36];
  /* #56: @1 = (@2/@3) */
  w1  = (w2/w3);
  /* #57: output[0][14] = @1 */
  if (res[0]) res[0][14] = w1;
  /* #58: @1 = 0.05 */
  w1 = 5.0000000000000003e-02;
  /* #59: @1 = (@1*@5) */
  w1 *= w5;
  /* #60: output[0][15] = @1 */
  if (res[0]) res[0][15] = w1;
  /* #61: @1 = @0[39] */
  w1 = wr0[39];
  /* #62: @7 = (@2/@1) */
  w7  = (w2/w1);
  /* #63: output[0][16] = @7 */
  if (res[0]) res[0][16] = w7;
  /* #64: @7 = 0.05 */
  w7 = 5.0000000000000003e-02;
  /* #65: @7 = (@7*@6) */
  w7 *= w6;
  /* #66: output[0][17] = @7 */
  if (res[0]) res[0][17] = w7;
  /* #67: @7 = @0[42] */
  w7 = wr0[42];
  /* #68: @8 = (@7*@2) */
  w8  = (w7*w2);
  /* #69: output[0][18] = @8 */
  if (res[0]) res[0][18] = w8;
  /* #70: @8 = 6.2832 */
  w8 = 6.2831999999999999e+00;
  /* #71: @8 = (@8*@7) */
  w8 *= w7;
  /* #72: @8 = (@8*@2) */
  w8 *= w2;
  /* #73: output[0][19] = @8 */
  if (res[0]) res[0][19] = w8;
  /* #74: @8 = @0[49] */
  w8 = wr0[49];
  /* #75: @8 = (@8*@2) */
  w8 *= w2;
  /* #76: output[0][20] = @8 */
  if (res[0]) res[0][20] = w8;
  /* #77: @8 = @0[50] */
  w8 = wr0[50];
  /* #78: @8 = (@8*@2) */
  w8 *= w2;
  /* #79: output[0][21] = @8 */
  if (res[0]) res[0][21] = w8;
  /* #80: @8 = @0[51] */
  w8 = wr0[51];
  /* #81: @8 = (@8*@2) */
  w8 *= w2;
  /* #82: output[0][22] = @8 */
  if (res[0]) res[0][22] = w8;
  /* #83: @8 = @0[53] */
  w8 = wr0[53];
  /* #84: @7 = (@8*@2) */
  w7  = (w8*w2);
  /* #85: output[0][23] = @7 */
  if (res[0]) res[0][23] = w7;
  /* #86: @8 = (@8*@2) */
  w8 *= w2;
  /* #87: @7 = @0[52] */
  w7 = wr0[52];
  /* #88: @8 = (@8/@7) */
  w8 /= w7;
  /* #89: output[0][24] = @8 */
  if (res[0]) res[0][24] = w8;
  /* #90: @8 = @0[55] */
  w8 = wr0[55];
  /* #91: @7 = (@8*@2) */
  w7  = (w8*w2);
  /* #92: output[0][25] = @7 */
  if (res[0]) res[0][25] = w7;
  /* #93: @8 = (@8*@2) */
  w8 *= w2;
  /* #94: @7 = @0[54] */
  w7 = wr0[54];
  /* #95: @8 = (@8/@7) */
  w8 /= w7;
  /* #96: output[0][26] = @8 */
  if (res[0]) res[0][26] = w8;
  /* #97: @8 = @0[56] */
  w8 = wr0[56];
  /* #98: @8 = (@8/@3) */
  w8 /= w3;
  /* #99: output[0][27] = @8 */
  if (res[0]) res[0][27] = w8;
  /* #100: @8 = @0[57] */
  w8 = wr0[57];
  /* #101: @8 = (@8/@1) */
  w8 /= w1;
  /* #102: output[0][28] = @8 */
  if (res[0]) res[0][28] = w8;
  /* #103: @8 = @0[61] */
  w8 = wr0[61];
  /* #104: @8 = (@8*@2) */
  w8 *= w2;
  /* #105: @7 = @0[58] */
  w7 = wr0[58];
  /* #106: @8 = (@8/@7) */
  w8 /= w7;
  /* #107: output[0][29] = @8 */
  if (res[0]) res[0][29] = w8;
  /* #108: @8 = @0[62] */
  w8 = wr0[62];
  /* #109: @8 = (@8*@2) */
  w8 *= w2;
  /* #110: @8 = (@8/@7) */
  w8 /= w7;
  /* #111: output[0][30] = @8 */
  if (res[0]) res[0][30] = w8;
  /* #112: @8 = @0[64] */
  w8 = wr0[64];
  /* #113: @9 = (@7*@8) */
  w9  = (w7*w8);
  /* #114: @3 = (2.*@3) */
  w3 = (2.* w3 );
  /* #115: @9 = (@9/@3) */
  w9 /= w3;
  /* #116: output[0][31] = @9 */
  if (res[0]) res[0][31] = w9;
  /* #117: @7 = (@7*@8) */
  w7 *= w8;
  /* #118: @1 = (2.*@1) */
  w1 = (2.* w1 );
  /* #119: @7 = (@7/@1) */
  w7 /= w1;
  /* #120: output[0][32] = @7 */
  if (res[0]) res[0][32] = w7;
  /* #121: @7 = 2 */
  w7 = 2.;
  /* #122: @7 = (@8/@7) */
  w7  = (w8/w7);
  /* #123: output[0][33] = @7 */
  if (res[0]) res[0][33] = w7;
  /* #124: @7 = 2 */
  w7 = 2.;
  /* #125: @8 = (@8/@7) */
  w8 /= w7;
  /* #126: output[0][34] = @8 */
  if (res[0]) res[0][34] = w8;
  /* #127: @8 = @0[65] */
  w8 = wr0[65];
  /* #128: @8 = (@8*@2) */
  w8 *= w2;
  /* #129: output[0][35] = @8 */
  if (res[0]) res[0][35] = w8;
  /* #130: @8 = 1.01 */
  w8 = 1.0100000000000000e+00;
  /* #131: @7 = 930 */
  w7 = 930.;
  /* #132: @7 = fmin(@7,@4) */
  w7  = casadi_fmin(w7,w4);
  /* #133: @8 = (@8*@7) */
  w8 *= w7;
  /* #134: output[0][36] = @8 */
  if (res[0]) res[0][36] = w8;
  /* #135: @8 = 1.01 */
  w8 = 1.0100000000000000e+00;
  /* #136: @7 = 3700 */
  w7 = 3700.;
  /* #137: @7 = fmin(@7,@5) */
  w7  = casadi_fmin(w7,w5);
  /* #138: @8 = (@8*@7) */
  w8 *= w7;
  /* #139: output[0][37] = @8 */
  if (res[0]) res[0][37] = w8;
  /* #140: @8 = 1.01 */
  w8 = 1.0100000000000000e+00;
  /* #141: @7 = 3700 */
  w7 = 3700.;
  /* #142: @7 = fmin(@7,@6) */
  w7  = casadi_fmin(w7,w6);
  /* #143: @8 = (@8*@7) */
  w8 *= w7;
  /* #144: output[0][38] = @8 */
  if (res[0]) res[0][38] = w8;
  /* #145: @8 = @0[1] */
  w8 = wr0[1];
  /* #146: @8 = (@2/@8) */
  w8  = (w2/w8);
  /* #147: output[0][39] = @8 */
  if (res[0]) res[0][39] = w8;
  /* #148: @8 = 0.02 */
  w8 = 2.0000000000000000e-02;
  /* #149: @8 = (@8+@2) */
  w8 += w2;
  /* #150: @2 = (@2/@8) */
  w2 /= w8;
  /* #151: output[0][40] = @2 */
  if (res[0]) res[0][40] = w2;
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

/* controller_step:(parameters[68],derived[41],states[89],inputs[10])->(next_states[89],outputs[3]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a000, a001, a002, a003, a004, a005, a006, a007, a008, a009, a010, a011;
  casadi_real a012, a013, a014, a015, a016, a017, a018, a019, a020, a021, a022, a023;
  casadi_real a024, a025, a026, a027, a028, a029, a030, a031, a032, a033, a034, a035;
  casadi_real a036, a037, a038, a039, a040, a041, a042, a043, a044, a045, a046, a047;
  casadi_real a048, a049, a050, a051, a052, a053, a054, a055, a056, a057, a058, a059;
  casadi_real a060, a061, a062, a063, a064, a065, a066, a067, a068, a069, a070, a071;
  casadi_real a072, a073, a074, a075, a076, a077, a078, a079, a080, a081, a082, a083;
  casadi_real a084, a085, a086, a087, a088, a089, a090, a091, a092, a093, a094, a095;
  casadi_real a096, a097, a098, a099, a100, a101, a102, a103, a104, a105, a106, a107;
  casadi_real a108, a109, a110, a111, a112, a113, a114, a115, a116, a117;
  a000=5.0000000000000000e-01;
  a001=arg[2]? arg[2][0] : 0;
  a002=1.;
  a003=arg[2]? arg[2][1] : 0;
  a004=0.;
  a005=(a003<=a004);
  a006=(a000<a001);
  a007=arg[3]? arg[3][3] : 0;
  a008=casadi_fabs(a007);
  a009=arg[0]? arg[0][6] : 0;
  a008=(a008<=a009);
  a010=(a008?a007:0);
  a011=(!a008);
  a012=arg[2]? arg[2][10] : 0;
  a011=(a011?a012:0);
  a010=(a010+a011);
  a011=casadi_fabs(a010);
  a012=arg[0]? arg[0][12] : 0;
  a011=(a011<=a012);
  a007=casadi_fabs(a007);
  a007=(a007<=a009);
  a011=(a011&&a007);
  a007=arg[3]? arg[3][6] : 0;
  a009=casadi_fabs(a007);
  a013=arg[0]? arg[0][9] : 0;
  a009=(a009<=a013);
  a014=(a009?a007:0);
  a015=(!a009);
  a016=arg[2]? arg[2][16] : 0;
  a015=(a015?a016:0);
  a014=(a014+a015);
  a015=casadi_fabs(a014);
  a016=arg[0]? arg[0][13] : 0;
  a015=(a015<=a016);
  a011=(a011&&a015);
  a007=casadi_fabs(a007);
  a007=(a007<=a013);
  a011=(a011&&a007);
  a007=arg[3]? arg[3][1] : 0;
  a013=casadi_fabs(a007);
  a015=arg[0]? arg[0][4] : 0;
  a013=(a013<=a015);
  a011=(a011&&a013);
  a013=arg[3]? arg[3][8] : 0;
  a017=casadi_fabs(a013);
  a018=arg[0]? arg[0][11] : 0;
  a017=(a017<=a018);
  a019=(a017?a013:0);
  a020=(!a017);
  a021=arg[2]? arg[2][20] : 0;
  a020=(a020?a021:0);
  a019=(a019+a020);
  a020=casadi_fabs(a019);
  a021=arg[0]? arg[0][14] : 0;
  a020=(a020<=a021);
  a011=(a011&&a020);
  a013=casadi_fabs(a013);
  a013=(a013<=a018);
  a011=(a011&&a013);
  a013=arg[3]? arg[3][2] : 0;
  a018=casadi_fabs(a013);
  a020=arg[0]? arg[0][5] : 0;
  a018=(a018<=a020);
  a011=(a011&&a018);
  a018=arg[3]? arg[3][0] : 0;
  a022=casadi_fabs(a018);
  a023=arg[0]? arg[0][3] : 0;
  a022=(a022<=a023);
  a011=(a011&&a022);
  a022=arg[3]? arg[3][4] : 0;
  a024=casadi_fabs(a022);
  a025=arg[0]? arg[0][7] : 0;
  a024=(a024<=a025);
  a011=(a011&&a024);
  a024=arg[3]? arg[3][5] : 0;
  a026=casadi_fabs(a024);
  a027=arg[0]? arg[0][8] : 0;
  a026=(a026<=a027);
  a011=(a011&&a026);
  a026=arg[3]? arg[3][7] : 0;
  a028=casadi_fabs(a026);
  a029=arg[0]? arg[0][10] : 0;
  a028=(a028<=a029);
  a011=(a011&&a028);
  a028=arg[2]? arg[2][3] : 0;
  a030=(a002-a028);
  a031=arg[2]? arg[2][26] : 0;
  a032=-1.;
  a033=arg[3]? arg[3][9] : 0;
  a033=(a032+a033);
  a033=casadi_fabs(a033);
  a033=(a033<=a000);
  a033=(a033?a002:0);
  a034=arg[2]? arg[2][25] : 0;
  a034=(a033-a034);
  a031=casadi_fmax(a031,a034);
  a030=(a030*a031);
  a031=(-a030);
  a031=(a011?a031:0);
  a031=(a006?a031:0);
  a005=(a005?a031:0);
  a005=(a002+a005);
  a001=(a001*a005);
  a005=(a000<a001);
  a031=(a005?a001:0);
  a005=(!a005);
  a034=casadi_fabs(a018);
  a034=(a034<=a023);
  a023=(a034?a002:0);
  a023=(a000<a023);
  a035=arg[2]? arg[2][5] : 0;
  a036=arg[0]? arg[0][2] : 0;
  a035=casadi_fmin(a035,a036);
  a037=arg[0]? arg[0][0] : 0;
  a038=casadi_fmax(a035,a037);
  a038=(a038-a037);
  a038=(a023?a038:0);
  a023=(!a023);
  a035=(a035+a037);
  a023=(a023?a035:0);
  a038=(a038+a023);
  a023=arg[1]? arg[1][0] : 0;
  a035=(a038<=a023);
  a039=casadi_fabs(a007);
  a039=(a039<=a015);
  a015=(a039?a002:0);
  a015=(a000<a015);
  a040=arg[2]? arg[2][7] : 0;
  a040=casadi_fmin(a040,a036);
  a041=casadi_fmax(a040,a037);
  a041=(a041-a037);
  a041=(a015?a041:0);
  a015=(!a015);
  a040=(a040+a037);
  a015=(a015?a040:0);
  a041=(a041+a015);
  a015=(a041<=a023);
  a040=casadi_fabs(a013);
  a040=(a040<=a020);
  a020=(a040?a002:0);
  a020=(a000<a020);
  a042=arg[2]? arg[2][9] : 0;
  a042=casadi_fmin(a042,a036);
  a043=casadi_fmax(a042,a037);
  a043=(a043-a037);
  a043=(a020?a043:0);
  a020=(!a020);
  a042=(a042+a037);
  a020=(a020?a042:0);
  a043=(a043+a020);
  a020=(a043<=a023);
  a008=(a008?a002:0);
  a008=(a000<a008);
  a042=arg[2]? arg[2][11] : 0;
  a042=casadi_fmin(a042,a036);
  a044=casadi_fmax(a042,a037);
  a044=(a044-a037);
  a044=(a008?a044:0);
  a008=(!a008);
  a042=(a042+a037);
  a008=(a008?a042:0);
  a044=(a044+a008);
  a008=(a044<=a023);
  a042=casadi_fabs(a022);
  a042=(a042<=a025);
  a025=(a042?a002:0);
  a025=(a000<a025);
  a045=arg[2]? arg[2][13] : 0;
  a045=casadi_fmin(a045,a036);
  a046=casadi_fmax(a045,a037);
  a046=(a046-a037);
  a046=(a025?a046:0);
  a025=(!a025);
  a045=(a045+a037);
  a025=(a025?a045:0);
  a046=(a046+a025);
  a025=(a046<=a023);
  a045=casadi_fabs(a024);
  a045=(a045<=a027);
  a027=(a045?a002:0);
  a027=(a000<a027);
  a047=arg[2]? arg[2][15] : 0;
  a047=casadi_fmin(a047,a036);
  a048=casadi_fmax(a047,a037);
  a048=(a048-a037);
  a048=(a027?a048:0);
  a027=(!a027);
  a047=(a047+a037);
  a027=(a027?a047:0);
  a048=(a048+a027);
  a027=(a048<=a023);
  a009=(a009?a002:0);
  a009=(a000<a009);
  a047=arg[2]? arg[2][17] : 0;
  a047=casadi_fmin(a047,a036);
  a049=casadi_fmax(a047,a037);
  a049=(a049-a037);
  a049=(a009?a049:0);
  a009=(!a009);
  a047=(a047+a037);
  a009=(a009?a047:0);
  a049=(a049+a009);
  a009=(a049<=a023);
  a047=casadi_fabs(a026);
  a047=(a047<=a029);
  a029=(a047?a002:0);
  a029=(a000<a029);
  a050=arg[2]? arg[2][19] : 0;
  a050=casadi_fmin(a050,a036);
  a051=casadi_fmax(a050,a037);
  a051=(a051-a037);
  a051=(a029?a051:0);
  a029=(!a029);
  a050=(a050+a037);
  a029=(a029?a050:0);
  a051=(a051+a029);
  a029=(a051<=a023);
  a017=(a017?a002:0);
  a017=(a000<a017);
  a050=arg[2]? arg[2][21] : 0;
  a050=casadi_fmin(a050,a036);
  a052=casadi_fmax(a050,a037);
  a052=(a052-a037);
  a052=(a017?a052:0);
  a017=(!a017);
  a050=(a050+a037);
  a017=(a017?a050:0);
  a052=(a052+a017);
  a017=(a052<=a023);
  a050=casadi_fabs(a010);
  a050=(a050<=a012);
  a050=(a050?a002:0);
  a050=(a000<a050);
  a012=arg[2]? arg[2][22] : 0;
  a012=casadi_fmin(a012,a036);
  a053=casadi_fmax(a012,a037);
  a053=(a053-a037);
  a053=(a050?a053:0);
  a050=(!a050);
  a012=(a012+a037);
  a050=(a050?a012:0);
  a053=(a053+a050);
  a050=(a053<=a023);
  a012=casadi_fabs(a014);
  a012=(a012<=a016);
  a012=(a012?a002:0);
  a012=(a000<a012);
  a016=arg[2]? arg[2][23] : 0;
  a016=casadi_fmin(a016,a036);
  a054=casadi_fmax(a016,a037);
  a054=(a054-a037);
  a054=(a012?a054:0);
  a012=(!a012);
  a016=(a016+a037);
  a012=(a012?a016:0);
  a054=(a054+a012);
  a012=(a054<=a023);
  a016=casadi_fabs(a019);
  a016=(a016<=a021);
  a016=(a016?a002:0);
  a016=(a000<a016);
  a021=arg[2]? arg[2][24] : 0;
  a021=casadi_fmin(a021,a036);
  a055=casadi_fmax(a021,a037);
  a055=(a055-a037);
  a055=(a016?a055:0);
  a016=(!a016);
  a021=(a021+a037);
  a016=(a016?a021:0);
  a055=(a055+a016);
  a016=(a055<=a023);
  a016=(!a016);
  a021=4009.;
  a016=(a016?a021:0);
  a016=(a012?a016:0);
  a012=(!a012);
  a021=4007.;
  a012=(a012?a021:0);
  a016=(a016+a012);
  a016=(a050?a016:0);
  a050=(!a050);
  a012=4004.;
  a050=(a050?a012:0);
  a016=(a016+a050);
  a016=(a017?a016:0);
  a017=(!a017);
  a050=9.;
  a017=(a017?a050:0);
  a016=(a016+a017);
  a016=(a029?a016:0);
  a029=(!a029);
  a017=8.;
  a029=(a029?a017:0);
  a016=(a016+a029);
  a016=(a009?a016:0);
  a009=(!a009);
  a029=7.;
  a009=(a009?a029:0);
  a016=(a016+a009);
  a016=(a027?a016:0);
  a027=(!a027);
  a009=6.;
  a027=(a027?a009:0);
  a016=(a016+a027);
  a016=(a025?a016:0);
  a025=(!a025);
  a027=5.;
  a025=(a025?a027:0);
  a016=(a016+a025);
  a016=(a008?a016:0);
  a008=(!a008);
  a025=4.;
  a008=(a008?a025:0);
  a016=(a016+a008);
  a016=(a020?a016:0);
  a020=(!a020);
  a008=3.;
  a020=(a020?a008:0);
  a016=(a016+a020);
  a016=(a015?a016:0);
  a015=(!a015);
  a020=2.;
  a015=(a015?a020:0);
  a016=(a016+a015);
  a016=(a035?a016:0);
  a035=(!a035);
  a035=(a035?a002:0);
  a016=(a016+a035);
  a005=(a005?a016:0);
  a031=(a031+a005);
  a005=(a000<a031);
  a031=(a005?a031:0);
  a005=(!a005);
  a016=arg[2]? arg[2][2] : 0;
  a035=(a016<=a000);
  a015=(a035?a010:0);
  a035=(!a035);
  a020=arg[2]? arg[2][36] : 0;
  a035=(a035?a020:0);
  a015=(a015+a035);
  a035=arg[1]? arg[1][12] : 0;
  a020=arg[2]? arg[2][83] : 0;
  a008=(a020*a003);
  a022=(a042?a022:0);
  a042=(!a042);
  a025=arg[2]? arg[2][12] : 0;
  a042=(a042?a025:0);
  a022=(a022+a042);
  a042=(a008-a022);
  a035=(a035*a042);
  a035=(a015+a035);
  a042=arg[1]? arg[1][11] : 0;
  a015=(a010-a015);
  a015=(a042*a015);
  a035=(a035+a015);
  a015=(a035-a010);
  a015=casadi_fabs(a015);
  a025=arg[0]? arg[0][34] : 0;
  a027=(a015<=a025);
  a009=arg[2]? arg[2][38] : 0;
  a009=(a010==a009);
  a029=(a016<=a000);
  a029=(!a029);
  a017=arg[2]? arg[2][39] : 0;
  a029=(a029?a017:0);
  a029=(a029+a037);
  a009=(a009?a029:0);
  a029=arg[0]? arg[0][35] : 0;
  a017=(a009<=a029);
  a027=(a027||a017);
  a025=(a015<=a025);
  a017=arg[2]? arg[2][40] : 0;
  a017=(a022==a017);
  a050=(a016<=a000);
  a050=(!a050);
  a012=arg[2]? arg[2][41] : 0;
  a050=(a050?a012:0);
  a050=(a050+a037);
  a017=(a017?a050:0);
  a050=(a017<=a029);
  a025=(a025||a050);
  a050=(a004<a017);
  a012=arg[2]? arg[2][42] : 0;
  a012=(a050?a012:0);
  a050=(!a050);
  a050=(a050?a008:0);
  a012=(a012+a050);
  a050=(a008-a012);
  a050=casadi_fabs(a050);
  a021=arg[1]? arg[1][13] : 0;
  a050=(a050<=a021);
  a025=(a025||a050);
  a050=(a016<=a000);
  a021=(a050?a014:0);
  a050=(!a050);
  a056=arg[2]? arg[2][43] : 0;
  a050=(a050?a056:0);
  a021=(a021+a050);
  a050=arg[1]? arg[1][14] : 0;
  a056=arg[2]? arg[2][84] : 0;
  a057=(a056*a003);
  a024=(a045?a024:0);
  a045=(!a045);
  a058=arg[2]? arg[2][14] : 0;
  a045=(a045?a058:0);
  a024=(a024+a045);
  a045=(a057+a024);
  a050=(a050*a045);
  a050=(a021+a050);
  a021=(a014-a021);
  a021=(a042*a021);
  a050=(a050+a021);
  a021=(a050-a014);
  a021=casadi_fabs(a021);
  a045=arg[0]? arg[0][38] : 0;
  a058=(a021<=a045);
  a059=arg[2]? arg[2][47] : 0;
  a059=(a024==a059);
  a060=(a016<=a000);
  a060=(!a060);
  a061=arg[2]? arg[2][48] : 0;
  a060=(a060?a061:0);
  a060=(a060+a037);
  a059=(a059?a060:0);
  a060=(a059<=a029);
  a058=(a058||a060);
  a060=(a004<a059);
  a061=arg[2]? arg[2][49] : 0;
  a061=(a060?a061:0);
  a060=(!a060);
  a060=(a060?a057:0);
  a061=(a061+a060);
  a060=(a057-a061);
  a060=casadi_fabs(a060);
  a062=arg[1]? arg[1][15] : 0;
  a060=(a060<=a062);
  a058=(a058||a060);
  a045=(a021<=a045);
  a060=arg[2]? arg[2][45] : 0;
  a060=(a014==a060);
  a062=(a016<=a000);
  a062=(!a062);
  a063=arg[2]? arg[2][46] : 0;
  a062=(a062?a063:0);
  a062=(a062+a037);
  a060=(a060?a062:0);
  a062=(a060<=a029);
  a045=(a045||a062);
  a062=(a016<=a000);
  a063=(a062?a019:0);
  a062=(!a062);
  a064=arg[2]? arg[2][50] : 0;
  a062=(a062?a064:0);
  a063=(a063+a062);
  a062=arg[1]? arg[1][16] : 0;
  a064=arg[2]? arg[2][85] : 0;
  a065=(a064*a003);
  a026=(a047?a026:0);
  a047=(!a047);
  a066=arg[2]? arg[2][18] : 0;
  a047=(a047?a066:0);
  a026=(a026+a047);
  a047=(a065+a026);
  a062=(a062*a047);
  a062=(a063+a062);
  a063=(a019-a063);
  a042=(a042*a063);
  a062=(a062+a042);
  a042=(a062-a019);
  a042=casadi_fabs(a042);
  a063=arg[0]? arg[0][41] : 0;
  a047=(a042<=a063);
  a066=arg[2]? arg[2][54] : 0;
  a066=(a026==a066);
  a067=(a016<=a000);
  a067=(!a067);
  a068=arg[2]? arg[2][55] : 0;
  a067=(a067?a068:0);
  a067=(a067+a037);
  a066=(a066?a067:0);
  a067=(a066<=a029);
  a047=(a047||a067);
  a067=(a004<a066);
  a068=arg[2]? arg[2][56] : 0;
  a068=(a067?a068:0);
  a067=(!a067);
  a067=(a067?a065:0);
  a068=(a068+a067);
  a067=(a065-a068);
  a067=casadi_fabs(a067);
  a069=arg[1]? arg[1][17] : 0;
  a067=(a067<=a069);
  a047=(a047||a067);
  a063=(a042<=a063);
  a067=arg[2]? arg[2][52] : 0;
  a067=(a019==a067);
  a069=(a016<=a000);
  a069=(!a069);
  a070=arg[2]? arg[2][53] : 0;
  a069=(a069?a070:0);
  a069=(a069+a037);
  a067=(a067?a069:0);
  a029=(a067<=a029);
  a063=(a063||a029);
  a029=arg[0]? arg[0][33] : 0;
  a015=(a015<=a029);
  a015=(a015?a002:0);
  a015=(a000<a015);
  a029=arg[2]? arg[2][37] : 0;
  a029=casadi_fmin(a029,a036);
  a069=casadi_fmax(a029,a037);
  a069=(a069-a037);
  a069=(a015?a069:0);
  a015=(!a015);
  a029=(a029+a037);
  a015=(a015?a029:0);
  a069=(a069+a015);
  a015=(a069<=a023);
  a029=arg[0]? arg[0][37] : 0;
  a021=(a021<=a029);
  a021=(a021?a002:0);
  a021=(a000<a021);
  a029=arg[2]? arg[2][44] : 0;
  a029=casadi_fmin(a029,a036);
  a070=casadi_fmax(a029,a037);
  a070=(a070-a037);
  a070=(a021?a070:0);
  a021=(!a021);
  a029=(a029+a037);
  a021=(a021?a029:0);
  a070=(a070+a021);
  a021=(a070<=a023);
  a029=arg[0]? arg[0][40] : 0;
  a042=(a042<=a029);
  a042=(a042?a002:0);
  a042=(a000<a042);
  a029=arg[2]? arg[2][51] : 0;
  a029=casadi_fmin(a029,a036);
  a036=casadi_fmax(a029,a037);
  a036=(a036-a037);
  a036=(a042?a036:0);
  a042=(!a042);
  a029=(a029+a037);
  a042=(a042?a029:0);
  a036=(a036+a042);
  a023=(a036<=a023);
  a042=(a016<=a000);
  a042=(!a042);
  a029=arg[2]? arg[2][59] : 0;
  a042=(a042?a029:0);
  a029=arg[1]? arg[1][18] : 0;
  a042=(a042-a029);
  a042=casadi_fmax(a004,a042);
  a071=arg[0]? arg[0][43] : 0;
  a072=(a016<=a000);
  a073=(a072?a022:0);
  a072=(!a072);
  a074=arg[2]? arg[2][57] : 0;
  a072=(a072?a074:0);
  a073=(a073+a072);
  a072=(a022-a073);
  a074=(a071<a072);
  a075=(a074?a002:0);
  a074=(!a074);
  a071=(-a071);
  a071=(a072<a071);
  a076=(a071?a032:0);
  a071=(!a071);
  a077=arg[2]? arg[2][58] : 0;
  a071=(a071?a077:0);
  a076=(a076+a071);
  a074=(a074?a076:0);
  a075=(a075+a074);
  a077=(a075==a077);
  a077=(!a077);
  a077=(a077?a002:0);
  a042=(a042+a077);
  a077=5.5000000000000000e+00;
  a074=(a042<=a077);
  a076=(a016<=a000);
  a076=(!a076);
  a071=arg[2]? arg[2][62] : 0;
  a076=(a076?a071:0);
  a076=(a076-a029);
  a076=casadi_fmax(a004,a076);
  a071=arg[0]? arg[0][44] : 0;
  a078=(a016<=a000);
  a079=(a078?a024:0);
  a078=(!a078);
  a080=arg[2]? arg[2][60] : 0;
  a078=(a078?a080:0);
  a079=(a079+a078);
  a078=(a024-a079);
  a080=(a071<a078);
  a081=(a080?a002:0);
  a080=(!a080);
  a071=(-a071);
  a071=(a078<a071);
  a082=(a071?a032:0);
  a071=(!a071);
  a083=arg[2]? arg[2][61] : 0;
  a071=(a071?a083:0);
  a082=(a082+a071);
  a080=(a080?a082:0);
  a081=(a081+a080);
  a083=(a081==a083);
  a083=(!a083);
  a083=(a083?a002:0);
  a076=(a076+a083);
  a083=(a076<=a077);
  a080=(a016<=a000);
  a080=(!a080);
  a082=arg[2]? arg[2][65] : 0;
  a080=(a080?a082:0);
  a080=(a080-a029);
  a080=casadi_fmax(a004,a080);
  a082=arg[0]? arg[0][45] : 0;
  a071=(a016<=a000);
  a084=(a071?a026:0);
  a071=(!a071);
  a085=arg[2]? arg[2][63] : 0;
  a071=(a071?a085:0);
  a084=(a084+a071);
  a071=(a026-a084);
  a085=(a082<a071);
  a086=(a085?a002:0);
  a085=(!a085);
  a082=(-a082);
  a082=(a071<a082);
  a087=(a082?a032:0);
  a082=(!a082);
  a088=arg[2]? arg[2][64] : 0;
  a082=(a082?a088:0);
  a087=(a087+a082);
  a085=(a085?a087:0);
  a086=(a086+a085);
  a088=(a086==a088);
  a088=(!a088);
  a088=(a088?a002:0);
  a080=(a080+a088);
  a088=(a080<=a077);
  a085=(a016<=a000);
  a085=(!a085);
  a087=arg[2]? arg[2][68] : 0;
  a085=(a085?a087:0);
  a085=(a085-a029);
  a085=casadi_fmax(a004,a085);
  a087=arg[0]? arg[0][46] : 0;
  a082=(a016<=a000);
  a082=(!a082);
  a089=arg[2]? arg[2][66] : 0;
  a090=(-a089);
  a090=(a082?a090:0);
  a008=(a008+a090);
  a090=(a087<a008);
  a091=(a090?a002:0);
  a090=(!a090);
  a087=(-a087);
  a087=(a008<a087);
  a092=(a087?a032:0);
  a087=(!a087);
  a093=arg[2]? arg[2][67] : 0;
  a087=(a087?a093:0);
  a092=(a092+a087);
  a090=(a090?a092:0);
  a091=(a091+a090);
  a093=(a091==a093);
  a093=(!a093);
  a093=(a093?a002:0);
  a085=(a085+a093);
  a093=(a085<=a077);
  a090=(a016<=a000);
  a090=(!a090);
  a092=arg[2]? arg[2][71] : 0;
  a090=(a090?a092:0);
  a090=(a090-a029);
  a090=casadi_fmax(a004,a090);
  a092=arg[0]? arg[0][47] : 0;
  a087=(a016<=a000);
  a087=(!a087);
  a094=arg[2]? arg[2][69] : 0;
  a095=(-a094);
  a095=(a087?a095:0);
  a057=(a057+a095);
  a095=(a092<a057);
  a096=(a095?a002:0);
  a095=(!a095);
  a092=(-a092);
  a092=(a057<a092);
  a097=(a092?a032:0);
  a092=(!a092);
  a098=arg[2]? arg[2][70] : 0;
  a092=(a092?a098:0);
  a097=(a097+a092);
  a095=(a095?a097:0);
  a096=(a096+a095);
  a098=(a096==a098);
  a098=(!a098);
  a098=(a098?a002:0);
  a090=(a090+a098);
  a098=(a090<=a077);
  a095=(a016<=a000);
  a095=(!a095);
  a097=arg[2]? arg[2][74] : 0;
  a095=(a095?a097:0);
  a095=(a095-a029);
  a095=casadi_fmax(a004,a095);
  a029=arg[0]? arg[0][48] : 0;
  a097=(a016<=a000);
  a097=(!a097);
  a092=arg[2]? arg[2][72] : 0;
  a099=(-a092);
  a099=(a097?a099:0);
  a065=(a065+a099);
  a099=(a029<a065);
  a100=(a099?a002:0);
  a099=(!a099);
  a029=(-a029);
  a029=(a065<a029);
  a032=(a029?a032:0);
  a029=(!a029);
  a101=arg[2]? arg[2][73] : 0;
  a029=(a029?a101:0);
  a032=(a032+a029);
  a099=(a099?a032:0);
  a100=(a100+a099);
  a101=(a100==a101);
  a101=(!a101);
  a101=(a101?a002:0);
  a095=(a095+a101);
  a077=(a095<=a077);
  a077=(!a077);
  a101=8003.;
  a077=(a077?a101:0);
  a077=(a098?a077:0);
  a098=(!a098);
  a101=8002.;
  a098=(a098?a101:0);
  a077=(a077+a098);
  a077=(a093?a077:0);
  a093=(!a093);
  a098=8001.;
  a093=(a093?a098:0);
  a077=(a077+a093);
  a077=(a088?a077:0);
  a088=(!a088);
  a093=6008.;
  a088=(a088?a093:0);
  a077=(a077+a088);
  a077=(a083?a077:0);
  a083=(!a083);
  a088=6006.;
  a083=(a083?a088:0);
  a077=(a077+a083);
  a077=(a074?a077:0);
  a074=(!a074);
  a083=6005.;
  a074=(a074?a083:0);
  a077=(a077+a074);
  a077=(a023?a077:0);
  a023=(!a023);
  a074=5009.;
  a023=(a023?a074:0);
  a077=(a077+a023);
  a077=(a021?a077:0);
  a021=(!a021);
  a023=5007.;
  a021=(a021?a023:0);
  a077=(a077+a021);
  a077=(a015?a077:0);
  a015=(!a015);
  a021=5004.;
  a015=(a015?a021:0);
  a077=(a077+a015);
  a077=(a063?a077:0);
  a063=(!a063);
  a015=3009.;
  a063=(a063?a015:0);
  a077=(a077+a063);
  a077=(a047?a077:0);
  a047=(!a047);
  a063=3008.;
  a047=(a047?a063:0);
  a077=(a077+a047);
  a077=(a045?a077:0);
  a045=(!a045);
  a047=3007.;
  a045=(a045?a047:0);
  a077=(a077+a045);
  a077=(a058?a077:0);
  a058=(!a058);
  a045=3006.;
  a058=(a058?a045:0);
  a077=(a077+a058);
  a077=(a025?a077:0);
  a025=(!a025);
  a058=3005.;
  a025=(a025?a058:0);
  a077=(a077+a025);
  a077=(a027?a077:0);
  a027=(!a027);
  a025=3004.;
  a027=(a027?a025:0);
  a077=(a077+a027);
  a005=(a005?a077:0);
  a031=(a031+a005);
  a005=(a000<a031);
  a031=(a005?a031:0);
  a005=(!a005);
  a077=arg[1]? arg[1][4] : 0;
  a027=arg[0]? arg[0][19] : 0;
  a025=casadi_fabs(a010);
  a027=casadi_fmax(a027,a025);
  a077=(a077/a027);
  a027=arg[1]? arg[1][3] : 0;
  a025=arg[1]? arg[1][2] : 0;
  a058=(a010*a025);
  a058=(a027+a058);
  a058=casadi_fmin(a002,a058);
  a058=casadi_fmax(a004,a058);
  a058=(a077*a058);
  a045=(-a058);
  a025=(a010*a025);
  a027=(a027-a025);
  a027=casadi_fmin(a002,a027);
  a027=casadi_fmax(a004,a027);
  a077=(a077*a027);
  a027=arg[0]? arg[0][18] : 0;
  a025=arg[2]? arg[2][34] : 0;
  a025=(a027!=a025);
  a047=arg[1]? arg[1][1] : 0;
  a063=(a016<=a000);
  a015=(a063?a027:0);
  a063=(!a063);
  a021=arg[2]? arg[2][33] : 0;
  a063=(a063?a021:0);
  a015=(a015+a063);
  a063=(a027-a015);
  a021=casadi_fabs(a063);
  a021=(a047*a021);
  a023=9.9999999999999995e-07;
  a074=casadi_fabs(a027);
  a074=(a023*a074);
  a083=casadi_fabs(a015);
  a083=(a023*a083);
  a074=(a074+a083);
  a021=casadi_fmax(a021,a074);
  a021=(a025?a021:0);
  a025=(!a025);
  a074=arg[2]? arg[2][35] : 0;
  a025=(a025?a074:0);
  a021=(a021+a025);
  a025=casadi_fabs(a063);
  a025=(a021<a025);
  a074=(-a021);
  a083=casadi_fmin(a063,a021);
  a074=casadi_fmax(a074,a083);
  a015=(a015+a074);
  a015=(a025?a015:0);
  a025=(!a025);
  a025=(a025?a027:0);
  a015=(a015+a025);
  a025=arg[1]? arg[1][33] : 0;
  a025=(a025*a014);
  a025=(a025-a010);
  a074=arg[1]? arg[1][34] : 0;
  a074=(a074*a019);
  a025=(a025+a074);
  a025=(a015*a025);
  a074=arg[0]? arg[0][66] : 0;
  a083=(a002-a074);
  a058=(a058*a083);
  a058=(-a058);
  a083=(a016<=a000);
  a083=(!a083);
  a088=arg[2]? arg[2][82] : 0;
  a083=(a083?a088:0);
  a088=arg[0]? arg[0][59] : 0;
  a093=(a016<=a000);
  a098=(a093?a022:0);
  a093=(!a093);
  a101=arg[2]? arg[2][77] : 0;
  a093=(a093?a101:0);
  a098=(a098+a093);
  a093=arg[1]? arg[1][22] : 0;
  a101=(-a093);
  a018=(a034?a018:0);
  a034=(!a034);
  a099=arg[2]? arg[2][4] : 0;
  a034=(a034?a099:0);
  a018=(a018+a034);
  a034=(a018-a098);
  a093=casadi_fmin(a093,a034);
  a101=casadi_fmax(a101,a093);
  a098=(a098+a101);
  a088=(a088*a098);
  a088=(a083+a088);
  a101=(a016<=a000);
  a093=(a101?a022:0);
  a101=(!a101);
  a034=arg[2]? arg[2][80] : 0;
  a101=(a101?a034:0);
  a093=(a093+a101);
  a101=(a016<=a000);
  a101=(!a101);
  a034=arg[2]? arg[2][81] : 0;
  a099=(a101?a034:0);
  a032=arg[1]? arg[1][29] : 0;
  a029=(a098-a093);
  a032=(a032*a029);
  a099=(a099+a032);
  a032=arg[1]? arg[1][30] : 0;
  a032=(a032*a034);
  a032=(-a032);
  a101=(a101?a032:0);
  a099=(a099+a101);
  a037=(a099*a037);
  a093=(a093+a037);
  a037=arg[0]? arg[0][63] : 0;
  a101=(a093*a037);
  a032=arg[1]? arg[1][27] : 0;
  a034=arg[1]? arg[1][7] : 0;
  a029=arg[0]? arg[0][23] : 0;
  a102=casadi_fabs(a014);
  a029=casadi_fmax(a029,a102);
  a034=(a034/a029);
  a029=arg[1]? arg[1][6] : 0;
  a102=arg[1]? arg[1][5] : 0;
  a103=(a014*a102);
  a103=(a029+a103);
  a103=casadi_fmin(a002,a103);
  a103=casadi_fmax(a004,a103);
  a103=(a034*a103);
  a103=(-a103);
  a102=(a014*a102);
  a029=(a029-a102);
  a029=casadi_fmin(a002,a029);
  a029=casadi_fmax(a004,a029);
  a034=(a034*a029);
  a029=(a016<=a000);
  a029=(!a029);
  a102=arg[2]? arg[2][78] : 0;
  a029=(a029?a102:0);
  a102=arg[0]? arg[0][53] : 0;
  a102=(a004<a102);
  a104=(a016<=a000);
  a105=arg[0]? arg[0][15] : 0;
  a106=(a104?a105:0);
  a104=(!a104);
  a107=arg[2]? arg[2][27] : 0;
  a104=(a104?a107:0);
  a106=(a106+a104);
  a104=arg[2]? arg[2][28] : 0;
  a104=(a105!=a104);
  a107=(a105-a106);
  a108=casadi_fabs(a107);
  a108=(a047*a108);
  a109=casadi_fabs(a105);
  a109=(a023*a109);
  a110=casadi_fabs(a106);
  a110=(a023*a110);
  a109=(a109+a110);
  a108=casadi_fmax(a108,a109);
  a108=(a104?a108:0);
  a104=(!a104);
  a109=arg[2]? arg[2][29] : 0;
  a104=(a104?a109:0);
  a108=(a108+a104);
  a104=casadi_fabs(a107);
  a104=(a108<a104);
  a109=(-a108);
  a110=casadi_fmin(a107,a108);
  a109=casadi_fmax(a109,a110);
  a109=(a106+a109);
  a109=(a104?a109:0);
  a104=(!a104);
  a104=(a104?a105:0);
  a109=(a109+a104);
  a104=(a106-a109);
  a104=(a024*a104);
  a104=(-a104);
  a102=(a102?a104:0);
  a029=(a029+a102);
  a102=(a016<=a000);
  a104=(a102?a014:0);
  a102=(!a102);
  a110=arg[2]? arg[2][75] : 0;
  a102=(a102?a110:0);
  a104=(a104+a102);
  a102=arg[1]? arg[1][20] : 0;
  a110=(-a102);
  a007=(a039?a007:0);
  a039=(!a039);
  a111=arg[2]? arg[2][6] : 0;
  a039=(a039?a111:0);
  a007=(a007+a039);
  a039=(a007-a104);
  a102=casadi_fmin(a102,a039);
  a110=casadi_fmax(a110,a102);
  a104=(a104+a110);
  a110=(a104-a014);
  a102=arg[0]? arg[0][52] : 0;
  a102=(a110*a102);
  a102=(a029+a102);
  a039=(a024*a109);
  a102=(a102-a039);
  a034=casadi_fmin(a034,a102);
  a103=casadi_fmax(a103,a034);
  a034=(a103+a024);
  a032=(a032*a034);
  a032=(a022+a032);
  a039=arg[1]? arg[1][28] : 0;
  a111=arg[1]? arg[1][10] : 0;
  a112=arg[0]? arg[0][27] : 0;
  a113=casadi_fabs(a019);
  a112=casadi_fmax(a112,a113);
  a111=(a111/a112);
  a112=arg[1]? arg[1][9] : 0;
  a113=arg[1]? arg[1][8] : 0;
  a114=(a019*a113);
  a114=(a112+a114);
  a114=casadi_fmin(a002,a114);
  a114=casadi_fmax(a004,a114);
  a114=(a111*a114);
  a114=(-a114);
  a113=(a019*a113);
  a112=(a112-a113);
  a112=casadi_fmin(a002,a112);
  a112=casadi_fmax(a004,a112);
  a111=(a111*a112);
  a112=(a016<=a000);
  a112=(!a112);
  a113=arg[2]? arg[2][79] : 0;
  a112=(a112?a113:0);
  a113=arg[0]? arg[0][55] : 0;
  a113=(a004<a113);
  a106=(a106-a109);
  a106=(a026*a106);
  a106=(-a106);
  a113=(a113?a106:0);
  a112=(a112+a113);
  a113=(a016<=a000);
  a106=(a113?a019:0);
  a113=(!a113);
  a115=arg[2]? arg[2][76] : 0;
  a113=(a113?a115:0);
  a106=(a106+a113);
  a113=arg[1]? arg[1][21] : 0;
  a115=(-a113);
  a013=(a040?a013:0);
  a040=(!a040);
  a116=arg[2]? arg[2][8] : 0;
  a040=(a040?a116:0);
  a013=(a013+a040);
  a040=(a013-a106);
  a113=casadi_fmin(a113,a040);
  a115=casadi_fmax(a115,a113);
  a106=(a106+a115);
  a115=(a106-a019);
  a113=arg[0]? arg[0][54] : 0;
  a113=(a115*a113);
  a113=(a112+a113);
  a040=(a026*a109);
  a113=(a113-a040);
  a111=casadi_fmin(a111,a113);
  a114=casadi_fmax(a114,a111);
  a111=(a114+a026);
  a039=(a039*a111);
  a032=(a032+a039);
  a101=(a101-a032);
  a037=(a002-a037);
  a037=(a098*a037);
  a101=(a101+a037);
  a037=arg[0]? arg[0][60] : 0;
  a037=(a101*a037);
  a088=(a088+a037);
  a037=arg[0]? arg[0][16] : 0;
  a032=arg[2]? arg[2][31] : 0;
  a032=(a037!=a032);
  a016=(a016<=a000);
  a039=(a016?a037:0);
  a016=(!a016);
  a040=arg[2]? arg[2][30] : 0;
  a016=(a016?a040:0);
  a039=(a039+a016);
  a016=(a037-a039);
  a040=casadi_fabs(a016);
  a047=(a047*a040);
  a040=casadi_fabs(a037);
  a040=(a023*a040);
  a116=casadi_fabs(a039);
  a023=(a023*a116);
  a040=(a040+a023);
  a047=casadi_fmax(a047,a040);
  a047=(a032?a047:0);
  a032=(!a032);
  a040=arg[2]? arg[2][32] : 0;
  a032=(a032?a040:0);
  a047=(a047+a032);
  a032=casadi_fabs(a016);
  a032=(a047<a032);
  a040=(-a047);
  a023=casadi_fmin(a016,a047);
  a040=casadi_fmax(a040,a023);
  a039=(a039+a040);
  a039=(a032?a039:0);
  a032=(!a032);
  a032=(a032?a037:0);
  a039=(a039+a032);
  a032=arg[1]? arg[1][31] : 0;
  a032=(a032*a034);
  a034=arg[1]? arg[1][32] : 0;
  a034=(a034*a111);
  a032=(a032+a034);
  a032=(a039*a032);
  a088=(a088+a032);
  a074=(a002-a074);
  a074=(a077*a074);
  a074=casadi_fmin(a088,a074);
  a058=casadi_fmax(a058,a074);
  a025=(a025+a058);
  a077=casadi_fmin(a077,a025);
  a045=casadi_fmax(a045,a077);
  a077=casadi_fabs(a045);
  a025=arg[1]? arg[1][36] : 0;
  a077=(a077<=a025);
  a074=(a077?a002:0);
  a074=(a000<a074);
  a032=casadi_fabs(a103);
  a034=arg[1]? arg[1][37] : 0;
  a032=(a032<=a034);
  a111=(a032?a002:0);
  a111=(a000<a111);
  a040=casadi_fabs(a114);
  a023=arg[1]? arg[1][38] : 0;
  a040=(a040<=a023);
  a116=(a040?a002:0);
  a116=(a000<a116);
  a116=(!a116);
  a117=7003.;
  a116=(a116?a117:0);
  a116=(a111?a116:0);
  a111=(!a111);
  a117=7002.;
  a111=(a111?a117:0);
  a116=(a116+a111);
  a116=(a074?a116:0);
  a074=(!a074);
  a111=7001.;
  a074=(a074?a111:0);
  a116=(a116+a074);
  a005=(a005?a116:0);
  a031=(a031+a005);
  if (res[0]!=0) res[0][0]=a031;
  a005=(a000<a031);
  a116=arg[1]? arg[1][39] : 0;
  a074=(-a116);
  a074=(a005?a074:0);
  a005=(!a005);
  a005=(a005?a116:0);
  a074=(a074+a005);
  a003=(a003+a074);
  a003=casadi_fmax(a004,a003);
  a003=casadi_fmin(a002,a003);
  if (res[0]!=0) res[0][1]=a003;
  a074=(a000<a031);
  a074=(!a074);
  a074=(a074?a002:0);
  if (res[0]!=0) res[0][2]=a074;
  if (res[0]!=0) res[0][3]=a028;
  if (res[0]!=0) res[0][4]=a018;
  if (res[0]!=0) res[0][5]=a038;
  if (res[0]!=0) res[0][6]=a007;
  if (res[0]!=0) res[0][7]=a041;
  if (res[0]!=0) res[0][8]=a013;
  if (res[0]!=0) res[0][9]=a043;
  if (res[0]!=0) res[0][10]=a010;
  if (res[0]!=0) res[0][11]=a044;
  if (res[0]!=0) res[0][12]=a022;
  if (res[0]!=0) res[0][13]=a046;
  if (res[0]!=0) res[0][14]=a024;
  if (res[0]!=0) res[0][15]=a048;
  if (res[0]!=0) res[0][16]=a014;
  if (res[0]!=0) res[0][17]=a049;
  if (res[0]!=0) res[0][18]=a026;
  if (res[0]!=0) res[0][19]=a051;
  if (res[0]!=0) res[0][20]=a019;
  if (res[0]!=0) res[0][21]=a052;
  if (res[0]!=0) res[0][22]=a053;
  if (res[0]!=0) res[0][23]=a054;
  if (res[0]!=0) res[0][24]=a055;
  if (res[0]!=0) res[0][25]=a033;
  a001=(a000<a001);
  a011=(a011?a030:0);
  a006=(a006?a011:0);
  a001=(a001?a006:0);
  if (res[0]!=0) res[0][26]=a001;
  if (res[0]!=0) res[0][27]=a109;
  if (res[0]!=0) res[0][28]=a105;
  a107=casadi_fabs(a107);
  a107=(a108<a107);
  a107=(a107?a108:0);
  if (res[0]!=0) res[0][29]=a107;
  if (res[0]!=0) res[0][30]=a039;
  if (res[0]!=0) res[0][31]=a037;
  a016=casadi_fabs(a016);
  a016=(a047<a016);
  a016=(a016?a047:0);
  if (res[0]!=0) res[0][32]=a016;
  if (res[0]!=0) res[0][33]=a015;
  if (res[0]!=0) res[0][34]=a027;
  a063=casadi_fabs(a063);
  a063=(a021<a063);
  a063=(a063?a021:0);
  if (res[0]!=0) res[0][35]=a063;
  if (res[0]!=0) res[0][36]=a035;
  if (res[0]!=0) res[0][37]=a069;
  if (res[0]!=0) res[0][38]=a010;
  if (res[0]!=0) res[0][39]=a009;
  if (res[0]!=0) res[0][40]=a022;
  if (res[0]!=0) res[0][41]=a017;
  if (res[0]!=0) res[0][42]=a012;
  if (res[0]!=0) res[0][43]=a050;
  if (res[0]!=0) res[0][44]=a070;
  if (res[0]!=0) res[0][45]=a014;
  if (res[0]!=0) res[0][46]=a060;
  if (res[0]!=0) res[0][47]=a024;
  if (res[0]!=0) res[0][48]=a059;
  if (res[0]!=0) res[0][49]=a061;
  if (res[0]!=0) res[0][50]=a062;
  if (res[0]!=0) res[0][51]=a036;
  if (res[0]!=0) res[0][52]=a019;
  if (res[0]!=0) res[0][53]=a067;
  if (res[0]!=0) res[0][54]=a026;
  if (res[0]!=0) res[0][55]=a066;
  if (res[0]!=0) res[0][56]=a068;
  a068=arg[1]? arg[1][19] : 0;
  a072=(a072*a068);
  a073=(a073+a072);
  if (res[0]!=0) res[0][57]=a073;
  if (res[0]!=0) res[0][58]=a075;
  if (res[0]!=0) res[0][59]=a042;
  a078=(a078*a068);
  a079=(a079+a078);
  if (res[0]!=0) res[0][60]=a079;
  if (res[0]!=0) res[0][61]=a081;
  if (res[0]!=0) res[0][62]=a076;
  a071=(a071*a068);
  a084=(a084+a071);
  if (res[0]!=0) res[0][63]=a084;
  if (res[0]!=0) res[0][64]=a086;
  if (res[0]!=0) res[0][65]=a080;
  a082=(a082?a089:0);
  a008=(a008*a068);
  a082=(a082+a008);
  if (res[0]!=0) res[0][66]=a082;
  if (res[0]!=0) res[0][67]=a091;
  if (res[0]!=0) res[0][68]=a085;
  a087=(a087?a094:0);
  a057=(a057*a068);
  a087=(a087+a057);
  if (res[0]!=0) res[0][69]=a087;
  if (res[0]!=0) res[0][70]=a096;
  if (res[0]!=0) res[0][71]=a090;
  a097=(a097?a092:0);
  a065=(a065*a068);
  a097=(a097+a065);
  if (res[0]!=0) res[0][72]=a097;
  if (res[0]!=0) res[0][73]=a100;
  if (res[0]!=0) res[0][74]=a095;
  if (res[0]!=0) res[0][75]=a104;
  if (res[0]!=0) res[0][76]=a106;
  if (res[0]!=0) res[0][77]=a098;
  a102=(a103-a102);
  a098=arg[1]? arg[1][24] : 0;
  a102=(a102*a098);
  a029=(a029+a102);
  a102=arg[1]? arg[1][23] : 0;
  a110=(a110*a102);
  a029=(a029+a110);
  if (res[0]!=0) res[0][78]=a029;
  a113=(a114-a113);
  a029=arg[1]? arg[1][26] : 0;
  a113=(a113*a029);
  a112=(a112+a113);
  a113=arg[1]? arg[1][25] : 0;
  a115=(a115*a113);
  a112=(a112+a115);
  if (res[0]!=0) res[0][79]=a112;
  if (res[0]!=0) res[0][80]=a093;
  if (res[0]!=0) res[0][81]=a099;
  a088=(a088-a058);
  a088=(a101*a088);
  a004=(a004<a088);
  a088=(a004?a083:0);
  a004=(!a004);
  a058=arg[0]? arg[0][67] : 0;
  a099=(-a058);
  a093=arg[1]? arg[1][35] : 0;
  a101=(a101*a093);
  a083=(a083+a101);
  a058=casadi_fmin(a058,a083);
  a099=casadi_fmax(a099,a058);
  a004=(a004?a099:0);
  a088=(a088+a004);
  if (res[0]!=0) res[0][82]=a088;
  a088=2.9995000000000000e+03;
  a004=(a088<a031);
  a099=arg[2]? arg[2][86] : 0;
  a058=arg[1]? arg[1][40] : 0;
  a083=(a031<=a000);
  a045=(a077?a045:0);
  a077=(!a077);
  a077=(a077?a020:0);
  a045=(a045+a077);
  a045=(a083?a045:0);
  a083=(!a083);
  a083=(a083?a020:0);
  a045=(a045+a083);
  a083=(a045-a099);
  a083=(a058*a083);
  a083=(a099+a083);
  a020=casadi_fabs(a083);
  a020=(a020<=a025);
  a083=(a020?a083:0);
  a020=(!a020);
  a020=(a020?a099:0);
  a083=(a083+a020);
  a020=(a004?a083:0);
  a004=(!a004);
  a004=(a004?a045:0);
  a020=(a020+a004);
  if (res[0]!=0) res[0][83]=a020;
  a004=(a088<a031);
  a045=arg[2]? arg[2][87] : 0;
  a099=(a031<=a000);
  a103=(a032?a103:0);
  a032=(!a032);
  a032=(a032?a056:0);
  a103=(a103+a032);
  a103=(a099?a103:0);
  a099=(!a099);
  a099=(a099?a056:0);
  a103=(a103+a099);
  a099=(a103-a045);
  a099=(a058*a099);
  a099=(a045+a099);
  a056=casadi_fabs(a099);
  a056=(a056<=a034);
  a099=(a056?a099:0);
  a056=(!a056);
  a056=(a056?a045:0);
  a099=(a099+a056);
  a056=(a004?a099:0);
  a004=(!a004);
  a004=(a004?a103:0);
  a056=(a056+a004);
  if (res[0]!=0) res[0][84]=a056;
  a088=(a088<a031);
  a004=arg[2]? arg[2][88] : 0;
  a031=(a031<=a000);
  a114=(a040?a114:0);
  a040=(!a040);
  a040=(a040?a064:0);
  a114=(a114+a040);
  a114=(a031?a114:0);
  a031=(!a031);
  a031=(a031?a064:0);
  a114=(a114+a031);
  a031=(a114-a004);
  a058=(a058*a031);
  a058=(a004+a058);
  a031=casadi_fabs(a058);
  a031=(a031<=a023);
  a058=(a031?a058:0);
  a031=(!a031);
  a031=(a031?a004:0);
  a058=(a058+a031);
  a031=(a088?a058:0);
  a088=(!a088);
  a088=(a088?a114:0);
  a031=(a031+a088);
  if (res[0]!=0) res[0][85]=a031;
  if (res[0]!=0) res[0][86]=a083;
  if (res[0]!=0) res[0][87]=a099;
  if (res[0]!=0) res[0][88]=a058;
  a058=-930.;
  a099=930.;
  a020=(a020*a003);
  a099=casadi_fmin(a099,a020);
  a058=casadi_fmax(a058,a099);
  if (res[1]!=0) res[1][0]=a058;
  a058=-3700.;
  a099=3700.;
  a056=(a056*a003);
  a056=casadi_fmin(a099,a056);
  a056=casadi_fmax(a058,a056);
  if (res[1]!=0) res[1][1]=a056;
  a031=(a031*a003);
  a099=casadi_fmin(a099,a031);
  a058=casadi_fmax(a058,a099);
  if (res[1]!=0) res[1][2]=a058;
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


