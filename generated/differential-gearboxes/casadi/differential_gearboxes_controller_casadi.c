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
CASADI_SYMBOL_EXPORT void differential_gearboxes_controller_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int differential_gearboxes_controller_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int differential_gearboxes_controller_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {68, 1, 1};
static const casadi_int casadi_s1[3] = {36, 1, 1};
static const casadi_int casadi_s2[3] = {74, 1, 1};
static const casadi_int casadi_s3[3] = {9, 1, 1};
static const casadi_int casadi_s4[3] = {3, 1, 1};

static const casadi_real casadi_zeros[68] = 
  {0.};

/* controller_prepare:(parameters[68])->(derived[36]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real w1, w2, w3, w4, w5, w6, w7, w8, w9;
  const casadi_real *wr0;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = @0[0] */
  w1 = wr0[0];
  /* #2: @2 = @0[16] */
  w2 = wr0[16];
  /* #3: @2 = (@1/@2) */
  w2  = (w1/w2);
  /* #4: output[0][0] = @2 */
  if (res[0]) res[0][0] = w2;
  /* #5: @2 = @0[20] */
  w2 = wr0[20];
  /* #6: @3 = (1./@2) */
  w3 = (1./ w2 );
  /* #7: output[0][1] = @3 */
  if (res[0]) res[0][1] = w3;
  /* #8: @3 = 1 */
  w3 = 1.;
  /* #9: @4 = @0[19] */
  w4 = wr0[19];
  /* #10: @4 = (@4/@2) */
  w4 /= w2;
  /* #11: @3 = (@3+@4) */
  w3 += w4;
  /* #12: output[0][2] = @3 */
  if (res[0]) res[0][2] = w3;
  /* #13: @3 = @0[24] */
  w3 = wr0[24];
  /* #14: @4 = (1./@3) */
  w4 = (1./ w3 );
  /* #15: output[0][3] = @4 */
  if (res[0]) res[0][3] = w4;
  /* #16: @4 = 1 */
  w4 = 1.;
  /* #17: @2 = @0[23] */
  w2 = wr0[23];
  /* #18: @2 = (@2/@3) */
  w2 /= w3;
  /* #19: @4 = (@4+@2) */
  w4 += w2;
  /* #20: output[0][4] = @4 */
  if (res[0]) res[0][4] = w4;
  /* #21: @4 = @0[28] */
  w4 = wr0[28];
  /* #22: @2 = (1./@4) */
  w2 = (1./ w4 );
  /* #23: output[0][5] = @2 */
  if (res[0]) res[0][5] = w2;
  /* #24: @2 = 1 */
  w2 = 1.;
  /* #25: @3 = @0[27] */
  w3 = wr0[27];
  /* #26: @3 = (@3/@4) */
  w3 /= w4;
  /* #27: @2 = (@2+@3) */
  w2 += w3;
  /* #28: output[0][6] = @2 */
  if (res[0]) res[0][6] = w2;
  /* #29: @2 = @0[30] */
  w2 = wr0[30];
  /* #30: @2 = (@2*@1) */
  w2 *= w1;
  /* #31: output[0][7] = @2 */
  if (res[0]) res[0][7] = w2;
  /* #32: @2 = @0[31] */
  w2 = wr0[31];
  /* #33: @3 = (@1/@2) */
  w3  = (w1/w2);
  /* #34: output[0][8] = @3 */
  if (res[0]) res[0][8] = w3;
  /* #35: @3 = @0[35] */
  w3 = wr0[35];
  /* #36: @4 = (@1/@3) */
  w4  = (w1/w3);
  /* #37: output[0][9] = @4 */
  if (res[0]) res[0][9] = w4;
  /* #38: @4 = @0[38] */
  w4 = wr0[38];
  /* #39: @5 = (@4*@1) */
  w5  = (w4*w1);
  /* #40: output[0][10] = @5 */
  if (res[0]) res[0][10] = w5;
  /* #41: @5 = 6.2832 */
  w5 = 6.2831999999999999e+00;
  /* #42: @5 = (@5*@4) */
  w5 *= w4;
  /* #43: @5 = (@5*@1) */
  w5 *= w1;
  /* #44: output[0][11] = @5 */
  if (res[0]) res[0][11] = w5;
  /* #45: @5 = @0[44] */
  w5 = wr0[44];
  /* #46: @5 = (@5*@1) */
  w5 *= w1;
  /* #47: output[0][12] = @5 */
  if (res[0]) res[0][12] = w5;
  /* #48: @5 = @0[45] */
  w5 = wr0[45];
  /* #49: @5 = (@5*@1) */
  w5 *= w1;
  /* #50: output[0][13] = @5 */
  if (res[0]) res[0][13] = w5;
  /* #51: @5 = @0[47] */
  w5 = wr0[47];
  /* #52: @4 = (@5*@1) */
  w4  = (w5*w1);
  /* #53: output[0][14] = @4 */
  if (res[0]) res[0][14] = w4;
  /* #54: @5 = (@5*@1) */
  w5 *= w1;
  /* #55: @4 = @0[46] */
  w4 = wr0[46];
  /* #56: @5 = (@5/@4) */
  w5 /= w4;
  /* #57: output[0][15] = @5 */
  if (res[0]) res[0][15] = w5;
  /* #58: @5 = @0[49] */
  w5 = wr0[49];
  /* #59: @4 = (@5*@1) */
  w4  = (w5*w1);
  /* #60: output[0][16] = @4 */
  if (res[0]) res[0][16] = w4;
  /* #61: @5 = (@5*@1) */
  w5 *= w1;
  /* #62: @4 = @0[48] */
  w4 = wr0[48];
  /* #63: @5 = (@5/@4) */
  w5 /= w4;
  /* #64: output[0][17] = @5 */
  if (res[0]) res[0][17] = w5;
  /* #65: @5 = @0[52] */
  w5 = wr0[52];
  /* #66: @4 = @0[50] */
  w4 = wr0[50];
  /* #67: @5 = (@5*@4) */
  w5 *= w4;
  /* #68: @5 = (@5/@2) */
  w5 /= w2;
  /* #69: output[0][18] = @5 */
  if (res[0]) res[0][18] = w5;
  /* #70: @5 = @0[53] */
  w5 = wr0[53];
  /* #71: @6 = @0[51] */
  w6 = wr0[51];
  /* #72: @5 = (@5*@6) */
  w5 *= w6;
  /* #73: @5 = (@5/@3) */
  w5 /= w3;
  /* #74: output[0][19] = @5 */
  if (res[0]) res[0][19] = w5;
  /* #75: @5 = @0[54] */
  w5 = wr0[54];
  /* #76: @5 = (@5/@2) */
  w5 /= w2;
  /* #77: output[0][20] = @5 */
  if (res[0]) res[0][20] = w5;
  /* #78: @5 = @0[55] */
  w5 = wr0[55];
  /* #79: @5 = (@5/@3) */
  w5 /= w3;
  /* #80: output[0][21] = @5 */
  if (res[0]) res[0][21] = w5;
  /* #81: @5 = @0[59] */
  w5 = wr0[59];
  /* #82: @5 = (@5*@1) */
  w5 *= w1;
  /* #83: output[0][22] = @5 */
  if (res[0]) res[0][22] = w5;
  /* #84: @5 = @0[60] */
  w5 = wr0[60];
  /* #85: @5 = (@5*@1) */
  w5 *= w1;
  /* #86: @7 = @0[56] */
  w7 = wr0[56];
  /* #87: @5 = (@5/@7) */
  w5 /= w7;
  /* #88: output[0][23] = @5 */
  if (res[0]) res[0][23] = w5;
  /* #89: @5 = @0[61] */
  w5 = wr0[61];
  /* #90: @5 = (@5*@1) */
  w5 *= w1;
  /* #91: @5 = (@5/@7) */
  w5 /= w7;
  /* #92: output[0][24] = @5 */
  if (res[0]) res[0][24] = w5;
  /* #93: @5 = @0[63] */
  w5 = wr0[63];
  /* #94: @8 = (@7*@5) */
  w8  = (w7*w5);
  /* #95: @9 = @0[64] */
  w9 = wr0[64];
  /* #96: @8 = (@8*@9) */
  w8 *= w9;
  /* #97: @2 = (2.*@2) */
  w2 = (2.* w2 );
  /* #98: @2 = (@2*@4) */
  w2 *= w4;
  /* #99: @8 = (@8/@2) */
  w8 /= w2;
  /* #100: output[0][25] = @8 */
  if (res[0]) res[0][25] = w8;
  /* #101: @7 = (@7*@5) */
  w7 *= w5;
  /* #102: @7 = (@7*@9) */
  w7 *= w9;
  /* #103: @3 = (2.*@3) */
  w3 = (2.* w3 );
  /* #104: @3 = (@3*@6) */
  w3 *= w6;
  /* #105: @7 = (@7/@3) */
  w7 /= w3;
  /* #106: output[0][26] = @7 */
  if (res[0]) res[0][26] = w7;
  /* #107: @7 = (@5*@9) */
  w7  = (w5*w9);
  /* #108: @7 = (1./@7) */
  w7 = (1./ w7 );
  /* #109: output[0][27] = @7 */
  if (res[0]) res[0][27] = w7;
  /* #110: @7 = (@5*@9) */
  w7  = (w5*w9);
  /* #111: @4 = (2.*@4) */
  w4 = (2.* w4 );
  /* #112: @7 = (@7/@4) */
  w7 /= w4;
  /* #113: output[0][28] = @7 */
  if (res[0]) res[0][28] = w7;
  /* #114: @7 = (@5*@9) */
  w7  = (w5*w9);
  /* #115: @6 = (2.*@6) */
  w6 = (2.* w6 );
  /* #116: @7 = (@7/@6) */
  w7 /= w6;
  /* #117: output[0][29] = @7 */
  if (res[0]) res[0][29] = w7;
  /* #118: @7 = @0[65] */
  w7 = wr0[65];
  /* #119: @7 = (@7*@1) */
  w7 *= w1;
  /* #120: output[0][30] = @7 */
  if (res[0]) res[0][30] = w7;
  /* #121: @5 = (@5*@9) */
  w5 *= w9;
  /* #122: @5 = (1./@5) */
  w5 = (1./ w5 );
  /* #123: output[0][31] = @5 */
  if (res[0]) res[0][31] = w5;
  /* #124: @5 = 1.01 */
  w5 = 1.0100000000000000e+00;
  /* #125: @9 = 3700 */
  w9 = 3700.;
  /* #126: @7 = @0[21] */
  w7 = wr0[21];
  /* #127: @9 = fmin(@9,@7) */
  w9  = casadi_fmin(w9,w7);
  /* #128: @5 = (@5*@9) */
  w5 *= w9;
  /* #129: output[0][32] = @5 */
  if (res[0]) res[0][32] = w5;
  /* #130: @5 = 1.01 */
  w5 = 1.0100000000000000e+00;
  /* #131: @9 = 3700 */
  w9 = 3700.;
  /* #132: @7 = @0[25] */
  w7 = wr0[25];
  /* #133: @9 = fmin(@9,@7) */
  w9  = casadi_fmin(w9,w7);
  /* #134: @5 = (@5*@9) */
  w5 *= w9;
  /* #135: output[0][33] = @5 */
  if (res[0]) res[0][33] = w5;
  /* #136: @5 = 1.01 */
  w5 = 1.0100000000000000e+00;
  /* #137: @9 = 3700 */
  w9 = 3700.;
  /* #138: @7 = @0[29] */
  w7 = wr0[29];
  /* #139: @9 = fmin(@9,@7) */
  w9  = casadi_fmin(w9,w7);
  /* #140: @5 = (@5*@9) */
  w5 *= w9;
  /* #141: output[0][34] = @5 */
  if (res[0]) res[0][34] = w5;
  /* #142: @5 = @0[1] */
  w5 = wr0[1];
  /* #143: @1 = (@1/@5) */
  w1 /= w5;
  /* #144: output[0][35] = @1 */
  if (res[0]) res[0][35] = w1;
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

/* controller_step:(parameters[68],derived[36],states[74],inputs[9])->(next_states[74],outputs[3]) */
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
  casadi_real a108, a109, a110, a111, a112, a113, a114, a115, a116, a117, a118, a119;
  casadi_real a120, a121, a122, a123, a124, a125, a126, a127, a128, a129, a130, a131;
  casadi_real a132, a133, a134;
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
  a007=(a008?a007:0);
  a009=(!a008);
  a010=arg[2]? arg[2][10] : 0;
  a009=(a009?a010:0);
  a007=(a007+a009);
  a009=casadi_fabs(a007);
  a010=arg[0]? arg[0][11] : 0;
  a009=(a009<=a010);
  a009=(a009?a002:0);
  a008=(a008?a002:0);
  a010=casadi_fmin(a009,a008);
  a011=arg[3]? arg[3][5] : 0;
  a012=casadi_fabs(a011);
  a013=arg[0]? arg[0][8] : 0;
  a012=(a012<=a013);
  a011=(a012?a011:0);
  a013=(!a012);
  a014=arg[2]? arg[2][14] : 0;
  a013=(a013?a014:0);
  a011=(a011+a013);
  a013=casadi_fabs(a011);
  a014=arg[0]? arg[0][12] : 0;
  a013=(a013<=a014);
  a013=(a013?a002:0);
  a010=casadi_fmin(a010,a013);
  a014=arg[3]? arg[3][1] : 0;
  a015=casadi_fabs(a014);
  a016=arg[0]? arg[0][4] : 0;
  a015=(a015<=a016);
  a016=(a015?a002:0);
  a010=casadi_fmin(a010,a016);
  a012=(a012?a002:0);
  a010=casadi_fmin(a010,a012);
  a017=arg[3]? arg[3][7] : 0;
  a018=casadi_fabs(a017);
  a019=arg[0]? arg[0][10] : 0;
  a018=(a018<=a019);
  a017=(a018?a017:0);
  a019=(!a018);
  a020=arg[2]? arg[2][18] : 0;
  a019=(a019?a020:0);
  a017=(a017+a019);
  a019=casadi_fabs(a017);
  a020=arg[0]? arg[0][13] : 0;
  a019=(a019<=a020);
  a019=(a019?a002:0);
  a010=casadi_fmin(a010,a019);
  a020=arg[3]? arg[3][2] : 0;
  a021=casadi_fabs(a020);
  a022=arg[0]? arg[0][5] : 0;
  a021=(a021<=a022);
  a022=(a021?a002:0);
  a010=casadi_fmin(a010,a022);
  a018=(a018?a002:0);
  a010=casadi_fmin(a010,a018);
  a023=arg[3]? arg[3][0] : 0;
  a024=casadi_fabs(a023);
  a025=arg[0]? arg[0][3] : 0;
  a024=(a024<=a025);
  a025=(a024?a002:0);
  a010=casadi_fmin(a010,a025);
  a026=arg[3]? arg[3][4] : 0;
  a027=casadi_fabs(a026);
  a028=arg[0]? arg[0][7] : 0;
  a027=(a027<=a028);
  a028=(a027?a002:0);
  a010=casadi_fmin(a010,a028);
  a029=arg[3]? arg[3][6] : 0;
  a030=casadi_fabs(a029);
  a031=arg[0]? arg[0][9] : 0;
  a030=(a030<=a031);
  a031=(a030?a002:0);
  a010=casadi_fmin(a010,a031);
  a032=arg[2]? arg[2][3] : 0;
  a033=(a002-a032);
  a010=(a010*a033);
  a033=arg[2]? arg[2][24] : 0;
  a034=-1.;
  a035=arg[3]? arg[3][8] : 0;
  a035=(a034+a035);
  a035=casadi_fabs(a035);
  a035=(a035<=a000);
  a035=(a035?a002:0);
  a036=arg[2]? arg[2][23] : 0;
  a036=(a035-a036);
  a033=casadi_fmax(a033,a036);
  a010=(a010*a033);
  a033=(-a010);
  a033=(a006?a033:0);
  a005=(a005?a033:0);
  a005=(a002+a005);
  a001=(a001*a005);
  a005=(a000<a001);
  a033=(a005?a001:0);
  a005=(!a005);
  a036=9998.;
  a008=(a000<a008);
  a037=(!a008);
  a038=arg[2]? arg[2][11] : 0;
  a039=arg[0]? arg[0][0] : 0;
  a040=(a038+a039);
  a041=arg[0]? arg[0][2] : 0;
  a042=(a000*a039);
  a042=(a041+a042);
  a042=(a040<=a042);
  a042=(!a042);
  a042=(a042?a002:0);
  a037=(a037?a042:0);
  a037=(a004<a037);
  a042=4.;
  a042=(a037?a042:0);
  a037=(!a037);
  a043=9999.;
  a037=(a037?a043:0);
  a042=(a042+a037);
  a009=(a000<a009);
  a037=(!a009);
  a044=arg[2]? arg[2][20] : 0;
  a045=(a044+a039);
  a046=(a000*a039);
  a046=(a041+a046);
  a046=(a045<=a046);
  a046=(!a046);
  a046=(a046?a002:0);
  a037=(a037?a046:0);
  a037=(a004<a037);
  a046=4004.;
  a046=(a037?a046:0);
  a037=(!a037);
  a037=(a037?a043:0);
  a046=(a046+a037);
  a042=casadi_fmin(a042,a046);
  a012=(a000<a012);
  a046=(!a012);
  a037=arg[2]? arg[2][15] : 0;
  a047=(a037+a039);
  a048=(a000*a039);
  a048=(a041+a048);
  a048=(a047<=a048);
  a048=(!a048);
  a048=(a048?a002:0);
  a046=(a046?a048:0);
  a046=(a004<a046);
  a048=6.;
  a048=(a046?a048:0);
  a046=(!a046);
  a046=(a046?a043:0);
  a048=(a048+a046);
  a042=casadi_fmin(a042,a048);
  a013=(a000<a013);
  a048=(!a013);
  a046=arg[2]? arg[2][21] : 0;
  a049=(a046+a039);
  a050=(a000*a039);
  a050=(a041+a050);
  a050=(a049<=a050);
  a050=(!a050);
  a050=(a050?a002:0);
  a048=(a048?a050:0);
  a048=(a004<a048);
  a050=4006.;
  a050=(a048?a050:0);
  a048=(!a048);
  a048=(a048?a043:0);
  a050=(a050+a048);
  a042=casadi_fmin(a042,a050);
  a016=(a000<a016);
  a050=(!a016);
  a048=arg[2]? arg[2][7] : 0;
  a051=(a048+a039);
  a052=(a000*a039);
  a052=(a041+a052);
  a052=(a051<=a052);
  a052=(!a052);
  a052=(a052?a002:0);
  a050=(a050?a052:0);
  a050=(a004<a050);
  a052=2.;
  a052=(a050?a052:0);
  a050=(!a050);
  a050=(a050?a043:0);
  a052=(a052+a050);
  a042=casadi_fmin(a042,a052);
  a018=(a000<a018);
  a052=(!a018);
  a050=arg[2]? arg[2][19] : 0;
  a053=(a050+a039);
  a054=(a000*a039);
  a054=(a041+a054);
  a054=(a053<=a054);
  a054=(!a054);
  a054=(a054?a002:0);
  a052=(a052?a054:0);
  a052=(a004<a052);
  a054=8.;
  a054=(a052?a054:0);
  a052=(!a052);
  a052=(a052?a043:0);
  a054=(a054+a052);
  a042=casadi_fmin(a042,a054);
  a019=(a000<a019);
  a054=(!a019);
  a052=arg[2]? arg[2][22] : 0;
  a055=(a052+a039);
  a056=(a000*a039);
  a056=(a041+a056);
  a056=(a055<=a056);
  a056=(!a056);
  a056=(a056?a002:0);
  a054=(a054?a056:0);
  a054=(a004<a054);
  a056=4008.;
  a056=(a054?a056:0);
  a054=(!a054);
  a054=(a054?a043:0);
  a056=(a056+a054);
  a042=casadi_fmin(a042,a056);
  a022=(a000<a022);
  a056=(!a022);
  a054=arg[2]? arg[2][9] : 0;
  a057=(a054+a039);
  a058=(a000*a039);
  a058=(a041+a058);
  a058=(a057<=a058);
  a058=(!a058);
  a058=(a058?a002:0);
  a056=(a056?a058:0);
  a056=(a004<a056);
  a058=3.;
  a058=(a056?a058:0);
  a056=(!a056);
  a056=(a056?a043:0);
  a058=(a058+a056);
  a042=casadi_fmin(a042,a058);
  a025=(a000<a025);
  a058=(!a025);
  a056=arg[2]? arg[2][5] : 0;
  a059=(a056+a039);
  a060=(a000*a039);
  a060=(a041+a060);
  a060=(a059<=a060);
  a060=(!a060);
  a060=(a060?a002:0);
  a058=(a058?a060:0);
  a058=(a004<a058);
  a060=(a058?a002:0);
  a058=(!a058);
  a058=(a058?a043:0);
  a060=(a060+a058);
  a042=casadi_fmin(a042,a060);
  a028=(a000<a028);
  a060=(!a028);
  a058=arg[2]? arg[2][13] : 0;
  a061=(a058+a039);
  a062=(a000*a039);
  a062=(a041+a062);
  a062=(a061<=a062);
  a062=(!a062);
  a062=(a062?a002:0);
  a060=(a060?a062:0);
  a060=(a004<a060);
  a062=5.;
  a062=(a060?a062:0);
  a060=(!a060);
  a060=(a060?a043:0);
  a062=(a062+a060);
  a042=casadi_fmin(a042,a062);
  a031=(a000<a031);
  a062=(!a031);
  a060=arg[2]? arg[2][17] : 0;
  a063=(a060+a039);
  a064=(a000*a039);
  a064=(a041+a064);
  a064=(a063<=a064);
  a064=(!a064);
  a064=(a064?a002:0);
  a062=(a062?a064:0);
  a062=(a004<a062);
  a064=7.;
  a064=(a062?a064:0);
  a062=(!a062);
  a062=(a062?a043:0);
  a064=(a064+a062);
  a042=casadi_fmin(a042,a064);
  a064=(a036<a042);
  a064=(!a064);
  a064=(a064?a042:0);
  a005=(a005?a064:0);
  a033=(a033+a005);
  a005=(a000<a033);
  a033=(a005?a033:0);
  a005=(!a005);
  a064=-5.5000000000000000e+00;
  a042=arg[2]? arg[2][2] : 0;
  a062=(a000<a042);
  a065=arg[2]? arg[2][56] : 0;
  a062=(a062?a065:0);
  a065=arg[1]? arg[1][10] : 0;
  a062=(a062-a065);
  a062=casadi_fmax(a004,a062);
  a066=arg[0]? arg[0][41] : 0;
  a067=arg[2]? arg[2][71] : 0;
  a068=(a067*a003);
  a069=(a000<a042);
  a070=arg[2]? arg[2][54] : 0;
  a071=(-a070);
  a071=(a069?a071:0);
  a068=(a068+a071);
  a071=(a066<a068);
  a072=(a071?a002:0);
  a071=(!a071);
  a066=(-a066);
  a066=(a068<a066);
  a073=(a066?a034:0);
  a066=(!a066);
  a074=arg[2]? arg[2][55] : 0;
  a066=(a066?a074:0);
  a073=(a073+a066);
  a071=(a071?a073:0);
  a072=(a072+a071);
  a074=(a072==a074);
  a074=(!a074);
  a074=(a074?a002:0);
  a062=(a062+a074);
  a074=(a064+a062);
  a074=(a004<a074);
  a071=8001.;
  a071=(a074?a071:0);
  a074=(!a074);
  a074=(a074?a043:0);
  a071=(a071+a074);
  a074=(a000<a042);
  a073=arg[2]? arg[2][34] : 0;
  a073=(a074?a073:0);
  a074=(!a074);
  a074=(a074?a011:0);
  a073=(a073+a074);
  a074=arg[1]? arg[1][8] : 0;
  a066=arg[2]? arg[2][72] : 0;
  a075=(a066*a003);
  a026=(a027?a026:0);
  a027=(!a027);
  a076=arg[2]? arg[2][12] : 0;
  a027=(a027?a076:0);
  a026=(a026+a027);
  a027=(a075+a026);
  a074=(a074*a027);
  a074=(a073+a074);
  a027=arg[1]? arg[1][7] : 0;
  a073=(a011-a073);
  a073=(a027*a073);
  a074=(a074+a073);
  a073=(a074-a011);
  a073=casadi_fabs(a073);
  a076=arg[0]? arg[0][32] : 0;
  a076=(a073<=a076);
  a076=(a076?a002:0);
  a076=(a000<a076);
  a077=(!a076);
  a078=arg[2]? arg[2][35] : 0;
  a079=(a078+a039);
  a080=(a000*a039);
  a080=(a041+a080);
  a080=(a079<=a080);
  a080=(!a080);
  a080=(a080?a002:0);
  a077=(a077?a080:0);
  a077=(a004<a077);
  a080=5006.;
  a080=(a077?a080:0);
  a077=(!a077);
  a077=(a077?a043:0);
  a080=(a080+a077);
  a071=casadi_fmin(a071,a080);
  a080=arg[0]? arg[0][33] : 0;
  a077=(a073-a080);
  a081=arg[2]? arg[2][36] : 0;
  a081=(a011==a081);
  a082=(a000<a042);
  a083=arg[2]? arg[2][37] : 0;
  a082=(a082?a083:0);
  a082=(a082+a039);
  a081=(a081?a082:0);
  a082=arg[0]? arg[0][34] : 0;
  a083=(a081-a082);
  a077=casadi_fmin(a077,a083);
  a077=(a004<a077);
  a083=3006.;
  a083=(a077?a083:0);
  a077=(!a077);
  a077=(a077?a043:0);
  a083=(a083+a077);
  a071=casadi_fmin(a071,a083);
  a083=(a000<a042);
  a077=arg[2]? arg[2][59] : 0;
  a083=(a083?a077:0);
  a083=(a083-a065);
  a083=casadi_fmax(a004,a083);
  a077=arg[0]? arg[0][42] : 0;
  a084=(a000<a042);
  a085=arg[2]? arg[2][57] : 0;
  a086=(-a085);
  a086=(a084?a086:0);
  a086=(a075+a086);
  a087=(a077<a086);
  a088=(a087?a002:0);
  a087=(!a087);
  a077=(-a077);
  a077=(a086<a077);
  a089=(a077?a034:0);
  a077=(!a077);
  a090=arg[2]? arg[2][58] : 0;
  a077=(a077?a090:0);
  a089=(a089+a077);
  a087=(a087?a089:0);
  a088=(a088+a087);
  a090=(a088==a090);
  a090=(!a090);
  a090=(a090?a002:0);
  a083=(a083+a090);
  a090=(a064+a083);
  a090=(a004<a090);
  a087=8002.;
  a087=(a090?a087:0);
  a090=(!a090);
  a090=(a090?a043:0);
  a087=(a087+a090);
  a071=casadi_fmin(a071,a087);
  a087=(a000<a042);
  a090=arg[2]? arg[2][41] : 0;
  a090=(a087?a090:0);
  a087=(!a087);
  a087=(a087?a017:0);
  a090=(a090+a087);
  a087=arg[1]? arg[1][9] : 0;
  a089=arg[2]? arg[2][73] : 0;
  a077=(a089*a003);
  a029=(a030?a029:0);
  a030=(!a030);
  a091=arg[2]? arg[2][16] : 0;
  a030=(a030?a091:0);
  a029=(a029+a030);
  a030=(a077+a029);
  a087=(a087*a030);
  a087=(a090+a087);
  a090=(a017-a090);
  a027=(a027*a090);
  a087=(a087+a027);
  a027=(a087-a017);
  a027=casadi_fabs(a027);
  a090=arg[0]? arg[0][36] : 0;
  a090=(a027<=a090);
  a090=(a090?a002:0);
  a090=(a000<a090);
  a030=(!a090);
  a091=arg[2]? arg[2][42] : 0;
  a092=(a091+a039);
  a093=(a000*a039);
  a093=(a041+a093);
  a093=(a092<=a093);
  a093=(!a093);
  a093=(a093?a002:0);
  a030=(a030?a093:0);
  a030=(a004<a030);
  a093=5008.;
  a093=(a030?a093:0);
  a030=(!a030);
  a030=(a030?a043:0);
  a093=(a093+a030);
  a071=casadi_fmin(a071,a093);
  a093=arg[0]? arg[0][37] : 0;
  a030=(a027-a093);
  a094=arg[2]? arg[2][43] : 0;
  a094=(a017==a094);
  a095=(a000<a042);
  a096=arg[2]? arg[2][44] : 0;
  a095=(a095?a096:0);
  a095=(a095+a039);
  a094=(a094?a095:0);
  a095=(a094-a082);
  a030=casadi_fmin(a030,a095);
  a030=(a004<a030);
  a095=3008.;
  a095=(a030?a095:0);
  a030=(!a030);
  a030=(a030?a043:0);
  a095=(a095+a030);
  a071=casadi_fmin(a071,a095);
  a095=(a000<a042);
  a030=arg[2]? arg[2][62] : 0;
  a095=(a095?a030:0);
  a095=(a095-a065);
  a095=casadi_fmax(a004,a095);
  a030=arg[0]? arg[0][43] : 0;
  a096=(a000<a042);
  a097=arg[2]? arg[2][60] : 0;
  a098=(-a097);
  a098=(a096?a098:0);
  a098=(a077+a098);
  a099=(a030<a098);
  a100=(a099?a002:0);
  a099=(!a099);
  a030=(-a030);
  a030=(a098<a030);
  a101=(a030?a034:0);
  a030=(!a030);
  a102=arg[2]? arg[2][61] : 0;
  a030=(a030?a102:0);
  a101=(a101+a030);
  a099=(a099?a101:0);
  a100=(a100+a099);
  a102=(a100==a102);
  a102=(!a102);
  a102=(a102?a002:0);
  a095=(a095+a102);
  a102=(a064+a095);
  a102=(a004<a102);
  a099=8003.;
  a099=(a102?a099:0);
  a102=(!a102);
  a102=(a102?a043:0);
  a099=(a099+a102);
  a071=casadi_fmin(a071,a099);
  a073=(a073-a080);
  a080=arg[2]? arg[2][38] : 0;
  a080=(a026==a080);
  a099=(a000<a042);
  a102=arg[2]? arg[2][39] : 0;
  a099=(a099?a102:0);
  a099=(a099+a039);
  a080=(a080?a099:0);
  a099=(a080-a082);
  a073=casadi_fmin(a073,a099);
  a099=-5.0000000000000003e-02;
  a102=arg[0]? arg[0][25] : 0;
  a101=(a099*a102);
  a030=(a004<a080);
  a103=arg[2]? arg[2][40] : 0;
  a103=(a030?a103:0);
  a030=(!a030);
  a030=(a030?a075:0);
  a103=(a103+a030);
  a075=(a075-a103);
  a075=casadi_fabs(a075);
  a101=(a101+a075);
  a073=casadi_fmin(a073,a101);
  a073=(a004<a073);
  a101=3005.;
  a101=(a073?a101:0);
  a073=(!a073);
  a073=(a073?a043:0);
  a101=(a101+a073);
  a071=casadi_fmin(a071,a101);
  a101=(a000<a042);
  a073=arg[2]? arg[2][50] : 0;
  a101=(a101?a073:0);
  a101=(a101-a065);
  a101=casadi_fmax(a004,a101);
  a073=arg[0]? arg[0][39] : 0;
  a075=(a000<a042);
  a030=arg[2]? arg[2][48] : 0;
  a030=(a075?a030:0);
  a075=(!a075);
  a075=(a075?a026:0);
  a030=(a030+a075);
  a075=(a026-a030);
  a104=(a073<a075);
  a105=(a104?a002:0);
  a104=(!a104);
  a073=(-a073);
  a073=(a075<a073);
  a106=(a073?a034:0);
  a073=(!a073);
  a107=arg[2]? arg[2][49] : 0;
  a073=(a073?a107:0);
  a106=(a106+a073);
  a104=(a104?a106:0);
  a105=(a105+a104);
  a107=(a105==a107);
  a107=(!a107);
  a107=(a107?a002:0);
  a101=(a101+a107);
  a107=(a064+a101);
  a107=(a004<a107);
  a104=6005.;
  a104=(a107?a104:0);
  a107=(!a107);
  a107=(a107?a043:0);
  a104=(a104+a107);
  a071=casadi_fmin(a071,a104);
  a027=(a027-a093);
  a093=arg[2]? arg[2][45] : 0;
  a093=(a029==a093);
  a104=(a000<a042);
  a107=arg[2]? arg[2][46] : 0;
  a104=(a104?a107:0);
  a104=(a104+a039);
  a093=(a093?a104:0);
  a082=(a093-a082);
  a027=casadi_fmin(a027,a082);
  a082=arg[0]? arg[0][29] : 0;
  a099=(a099*a082);
  a104=(a004<a093);
  a107=arg[2]? arg[2][47] : 0;
  a107=(a104?a107:0);
  a104=(!a104);
  a104=(a104?a077:0);
  a107=(a107+a104);
  a077=(a077-a107);
  a077=casadi_fabs(a077);
  a099=(a099+a077);
  a027=casadi_fmin(a027,a099);
  a027=(a004<a027);
  a099=3007.;
  a099=(a027?a099:0);
  a027=(!a027);
  a027=(a027?a043:0);
  a099=(a099+a027);
  a071=casadi_fmin(a071,a099);
  a099=(a000<a042);
  a027=arg[2]? arg[2][53] : 0;
  a099=(a099?a027:0);
  a099=(a099-a065);
  a099=casadi_fmax(a004,a099);
  a065=arg[0]? arg[0][40] : 0;
  a027=(a000<a042);
  a077=arg[2]? arg[2][51] : 0;
  a077=(a027?a077:0);
  a027=(!a027);
  a027=(a027?a029:0);
  a077=(a077+a027);
  a027=(a029-a077);
  a104=(a065<a027);
  a106=(a104?a002:0);
  a104=(!a104);
  a065=(-a065);
  a065=(a027<a065);
  a034=(a065?a034:0);
  a065=(!a065);
  a073=arg[2]? arg[2][52] : 0;
  a065=(a065?a073:0);
  a034=(a034+a065);
  a104=(a104?a034:0);
  a106=(a106+a104);
  a073=(a106==a073);
  a073=(!a073);
  a073=(a073?a002:0);
  a099=(a099+a073);
  a064=(a064+a099);
  a064=(a004<a064);
  a073=6007.;
  a073=(a064?a073:0);
  a064=(!a064);
  a064=(a064?a043:0);
  a073=(a073+a064);
  a071=casadi_fmin(a071,a073);
  a073=(a036<a071);
  a073=(!a073);
  a073=(a073?a071:0);
  a005=(a005?a073:0);
  a033=(a033+a005);
  a005=(a000<a033);
  a033=(a005?a033:0);
  a005=(!a005);
  a073=arg[0]? arg[0][18] : 0;
  a071=arg[0]? arg[0][21] : 0;
  a071=(a073*a071);
  a064=casadi_fabs(a007);
  a073=casadi_fmax(a073,a064);
  a071=(a071/a073);
  a073=arg[1]? arg[1][2] : 0;
  a064=arg[1]? arg[1][1] : 0;
  a104=(a007*a064);
  a104=(a073+a104);
  a104=casadi_fmin(a002,a104);
  a104=casadi_fmax(a004,a104);
  a104=(a071*a104);
  a034=(-a104);
  a064=(a007*a064);
  a073=(a073-a064);
  a073=casadi_fmin(a002,a073);
  a073=casadi_fmax(a004,a073);
  a071=(a071*a073);
  a073=arg[0]? arg[0][17] : 0;
  a064=arg[2]? arg[2][32] : 0;
  a064=(a073!=a064);
  a065=arg[1]? arg[1][0] : 0;
  a108=(a000<a042);
  a109=arg[2]? arg[2][31] : 0;
  a109=(a108?a109:0);
  a108=(!a108);
  a108=(a108?a073:0);
  a109=(a109+a108);
  a108=(a073-a109);
  a110=casadi_fabs(a108);
  a110=(a065*a110);
  a111=9.9999999999999995e-07;
  a112=casadi_fabs(a073);
  a112=(a111*a112);
  a113=casadi_fabs(a109);
  a113=(a111*a113);
  a112=(a112+a113);
  a110=casadi_fmax(a110,a112);
  a110=(a064?a110:0);
  a064=(!a064);
  a112=arg[2]? arg[2][33] : 0;
  a064=(a064?a112:0);
  a110=(a110+a064);
  a064=(a110<a108);
  a112=(a109+a110);
  a112=(a064?a112:0);
  a064=(!a064);
  a113=(-a110);
  a113=(a108<a113);
  a109=(a109-a110);
  a109=(a113?a109:0);
  a113=(!a113);
  a113=(a113?a073:0);
  a109=(a109+a113);
  a064=(a064?a109:0);
  a112=(a112+a064);
  a064=arg[1]? arg[1][28] : 0;
  a064=(a064*a011);
  a064=(a064-a007);
  a109=arg[1]? arg[1][29] : 0;
  a109=(a109*a017);
  a064=(a064+a109);
  a064=(a112*a064);
  a109=arg[0]? arg[0][66] : 0;
  a113=(a002-a109);
  a104=(a104*a113);
  a104=(-a104);
  a113=arg[1]? arg[1][27] : 0;
  a114=(a000<a042);
  a115=arg[2]? arg[2][70] : 0;
  a114=(a114?a115:0);
  a115=arg[0]? arg[0][57] : 0;
  a116=(a000<a042);
  a117=arg[2]? arg[2][67] : 0;
  a117=(a116?a117:0);
  a116=(!a116);
  a118=arg[1]? arg[1][18] : 0;
  a119=arg[0]? arg[0][22] : 0;
  a102=(a119*a102);
  a120=casadi_fabs(a011);
  a119=casadi_fmax(a119,a120);
  a102=(a102/a119);
  a119=arg[1]? arg[1][4] : 0;
  a120=arg[1]? arg[1][3] : 0;
  a121=(a011*a120);
  a121=(a119+a121);
  a121=casadi_fmin(a002,a121);
  a121=casadi_fmax(a004,a121);
  a121=(a102*a121);
  a121=(-a121);
  a120=(a011*a120);
  a119=(a119-a120);
  a119=casadi_fmin(a002,a119);
  a119=casadi_fmax(a004,a119);
  a102=(a102*a119);
  a119=arg[0]? arg[0][47] : 0;
  a119=(a004<a119);
  a120=(a000<a042);
  a122=arg[2]? arg[2][25] : 0;
  a122=(a120?a122:0);
  a120=(!a120);
  a123=arg[0]? arg[0][14] : 0;
  a120=(a120?a123:0);
  a122=(a122+a120);
  a120=arg[2]? arg[2][26] : 0;
  a120=(a123!=a120);
  a124=(a123-a122);
  a125=casadi_fabs(a124);
  a125=(a065*a125);
  a126=casadi_fabs(a123);
  a126=(a111*a126);
  a127=casadi_fabs(a122);
  a127=(a111*a127);
  a126=(a126+a127);
  a125=casadi_fmax(a125,a126);
  a125=(a120?a125:0);
  a120=(!a120);
  a126=arg[2]? arg[2][27] : 0;
  a120=(a120?a126:0);
  a125=(a125+a120);
  a120=(a125<a124);
  a126=(a122+a125);
  a126=(a120?a126:0);
  a120=(!a120);
  a127=(-a125);
  a127=(a124<a127);
  a128=(a122-a125);
  a128=(a127?a128:0);
  a127=(!a127);
  a127=(a127?a123:0);
  a128=(a128+a127);
  a120=(a120?a128:0);
  a126=(a126+a120);
  a120=(a122-a126);
  a120=(a026*a120);
  a120=(-a120);
  a119=(a119?a120:0);
  a120=(a000<a042);
  a128=arg[2]? arg[2][65] : 0;
  a120=(a120?a128:0);
  a119=(a119+a120);
  a120=(a000<a042);
  a128=arg[2]? arg[2][63] : 0;
  a128=(a120?a128:0);
  a120=(!a120);
  a120=(a120?a011:0);
  a128=(a128+a120);
  a120=arg[1]? arg[1][12] : 0;
  a127=(-a120);
  a014=(a015?a014:0);
  a015=(!a015);
  a129=arg[2]? arg[2][6] : 0;
  a015=(a015?a129:0);
  a014=(a014+a015);
  a015=(a014-a128);
  a120=casadi_fmin(a120,a015);
  a127=casadi_fmax(a127,a120);
  a128=(a128+a127);
  a127=(a128-a011);
  a120=arg[0]? arg[0][46] : 0;
  a120=(a127*a120);
  a120=(a119+a120);
  a015=(a026*a126);
  a120=(a120-a015);
  a102=casadi_fmin(a102,a120);
  a121=casadi_fmax(a121,a102);
  a102=(a121+a026);
  a118=(a118*a102);
  a015=arg[1]? arg[1][19] : 0;
  a129=arg[0]? arg[0][26] : 0;
  a082=(a129*a082);
  a130=casadi_fabs(a017);
  a129=casadi_fmax(a129,a130);
  a082=(a082/a129);
  a129=arg[1]? arg[1][6] : 0;
  a130=arg[1]? arg[1][5] : 0;
  a131=(a017*a130);
  a131=(a129+a131);
  a131=casadi_fmin(a002,a131);
  a131=casadi_fmax(a004,a131);
  a131=(a082*a131);
  a131=(-a131);
  a130=(a017*a130);
  a129=(a129-a130);
  a129=casadi_fmin(a002,a129);
  a129=casadi_fmax(a004,a129);
  a082=(a082*a129);
  a129=arg[0]? arg[0][49] : 0;
  a129=(a004<a129);
  a122=(a122-a126);
  a122=(a029*a122);
  a122=(-a122);
  a129=(a129?a122:0);
  a122=(a000<a042);
  a130=arg[2]? arg[2][66] : 0;
  a122=(a122?a130:0);
  a129=(a129+a122);
  a122=(a000<a042);
  a130=arg[2]? arg[2][64] : 0;
  a130=(a122?a130:0);
  a122=(!a122);
  a122=(a122?a017:0);
  a130=(a130+a122);
  a122=arg[1]? arg[1][13] : 0;
  a132=(-a122);
  a020=(a021?a020:0);
  a021=(!a021);
  a133=arg[2]? arg[2][8] : 0;
  a021=(a021?a133:0);
  a020=(a020+a021);
  a021=(a020-a130);
  a122=casadi_fmin(a122,a021);
  a132=casadi_fmax(a132,a122);
  a130=(a130+a132);
  a132=(a130-a017);
  a122=arg[0]? arg[0][48] : 0;
  a122=(a132*a122);
  a122=(a129+a122);
  a021=(a029*a126);
  a122=(a122-a021);
  a082=casadi_fmin(a082,a122);
  a131=casadi_fmax(a131,a082);
  a082=(a131+a029);
  a015=(a015*a082);
  a118=(a118+a015);
  a015=arg[1]? arg[1][20] : 0;
  a015=(a015*a102);
  a118=(a118+a015);
  a015=arg[1]? arg[1][21] : 0;
  a015=(a015*a082);
  a118=(a118+a015);
  a015=arg[0]? arg[0][50] : 0;
  a015=(a026*a015);
  a118=(a118+a015);
  a015=arg[0]? arg[0][51] : 0;
  a015=(a029*a015);
  a118=(a118+a015);
  a116=(a116?a118:0);
  a117=(a117+a116);
  a116=arg[1]? arg[1][22] : 0;
  a015=(-a116);
  a023=(a024?a023:0);
  a024=(!a024);
  a021=arg[2]? arg[2][4] : 0;
  a024=(a024?a021:0);
  a023=(a023+a024);
  a024=(a023-a117);
  a116=casadi_fmin(a116,a024);
  a015=casadi_fmax(a015,a116);
  a117=(a117+a015);
  a115=(a115*a117);
  a115=(a114+a115);
  a015=(a000<a042);
  a116=arg[2]? arg[2][68] : 0;
  a116=(a015?a116:0);
  a015=(!a015);
  a015=(a015?a118:0);
  a116=(a116+a015);
  a015=(a000<a042);
  a024=arg[2]? arg[2][69] : 0;
  a021=(a015?a024:0);
  a133=arg[1]? arg[1][23] : 0;
  a134=(a117-a116);
  a133=(a133*a134);
  a021=(a021+a133);
  a133=arg[1]? arg[1][24] : 0;
  a133=(a133*a024);
  a133=(-a133);
  a015=(a015?a133:0);
  a021=(a021+a015);
  a015=(a021*a039);
  a116=(a116+a015);
  a015=arg[0]? arg[0][62] : 0;
  a133=(a116*a015);
  a133=(a133-a118);
  a015=(a002-a015);
  a015=(a117*a015);
  a133=(a133+a015);
  a015=arg[0]? arg[0][58] : 0;
  a015=(a133*a015);
  a115=(a115+a015);
  a113=(a113*a115);
  a115=arg[0]? arg[0][15] : 0;
  a015=arg[2]? arg[2][29] : 0;
  a015=(a115!=a015);
  a042=(a000<a042);
  a118=arg[2]? arg[2][28] : 0;
  a118=(a042?a118:0);
  a042=(!a042);
  a042=(a042?a115:0);
  a118=(a118+a042);
  a042=(a115-a118);
  a024=casadi_fabs(a042);
  a065=(a065*a024);
  a024=casadi_fabs(a115);
  a024=(a111*a024);
  a134=casadi_fabs(a118);
  a111=(a111*a134);
  a024=(a024+a111);
  a065=casadi_fmax(a065,a024);
  a065=(a015?a065:0);
  a015=(!a015);
  a024=arg[2]? arg[2][30] : 0;
  a015=(a015?a024:0);
  a065=(a065+a015);
  a015=(a065<a042);
  a024=(a118+a065);
  a024=(a015?a024:0);
  a015=(!a015);
  a111=(-a065);
  a111=(a042<a111);
  a118=(a118-a065);
  a118=(a111?a118:0);
  a111=(!a111);
  a111=(a111?a115:0);
  a118=(a118+a111);
  a015=(a015?a118:0);
  a024=(a024+a015);
  a015=arg[1]? arg[1][25] : 0;
  a015=(a015*a102);
  a102=arg[1]? arg[1][26] : 0;
  a102=(a102*a082);
  a015=(a015+a102);
  a015=(a024*a015);
  a113=(a113+a015);
  a109=(a002-a109);
  a109=(a071*a109);
  a109=casadi_fmin(a113,a109);
  a104=casadi_fmax(a104,a109);
  a064=(a064+a104);
  a071=casadi_fmin(a071,a064);
  a034=casadi_fmax(a034,a071);
  a071=casadi_fabs(a034);
  a064=arg[1]? arg[1][32] : 0;
  a071=(a071<=a064);
  a064=(a071?a002:0);
  a064=(a064<a002);
  a109=7001.;
  a109=(a064?a109:0);
  a064=(!a064);
  a064=(a064?a043:0);
  a109=(a109+a064);
  a064=casadi_fabs(a121);
  a015=arg[1]? arg[1][33] : 0;
  a064=(a064<=a015);
  a015=(a064?a002:0);
  a015=(a015<a002);
  a102=7002.;
  a102=(a015?a102:0);
  a015=(!a015);
  a015=(a015?a043:0);
  a102=(a102+a015);
  a109=casadi_fmin(a109,a102);
  a102=casadi_fabs(a131);
  a015=arg[1]? arg[1][34] : 0;
  a102=(a102<=a015);
  a015=(a102?a002:0);
  a015=(a015<a002);
  a082=7003.;
  a082=(a015?a082:0);
  a015=(!a015);
  a015=(a015?a043:0);
  a082=(a082+a015);
  a109=casadi_fmin(a109,a082);
  a036=(a036<a109);
  a036=(!a036);
  a036=(a036?a109:0);
  a005=(a005?a036:0);
  a033=(a033+a005);
  if (res[0]!=0) res[0][0]=a033;
  a005=(a000<a033);
  a036=arg[1]? arg[1][35] : 0;
  a109=(-a036);
  a109=(a005?a109:0);
  a005=(!a005);
  a005=(a005?a036:0);
  a109=(a109+a005);
  a003=(a003+a109);
  a003=casadi_fmax(a004,a003);
  a003=casadi_fmin(a002,a003);
  if (res[0]!=0) res[0][1]=a003;
  a109=(a000<a033);
  a109=(!a109);
  a109=(a109?a002:0);
  if (res[0]!=0) res[0][2]=a109;
  if (res[0]!=0) res[0][3]=a032;
  if (res[0]!=0) res[0][4]=a023;
  a056=casadi_fmin(a056,a041);
  a056=(a056-a039);
  a056=casadi_fmax(a004,a056);
  a056=(a025?a056:0);
  a025=(!a025);
  a025=(a025?a059:0);
  a056=(a056+a025);
  if (res[0]!=0) res[0][5]=a056;
  if (res[0]!=0) res[0][6]=a014;
  a048=casadi_fmin(a048,a041);
  a048=(a048-a039);
  a048=casadi_fmax(a004,a048);
  a048=(a016?a048:0);
  a016=(!a016);
  a016=(a016?a051:0);
  a048=(a048+a016);
  if (res[0]!=0) res[0][7]=a048;
  if (res[0]!=0) res[0][8]=a020;
  a054=casadi_fmin(a054,a041);
  a054=(a054-a039);
  a054=casadi_fmax(a004,a054);
  a054=(a022?a054:0);
  a022=(!a022);
  a022=(a022?a057:0);
  a054=(a054+a022);
  if (res[0]!=0) res[0][9]=a054;
  if (res[0]!=0) res[0][10]=a007;
  a038=casadi_fmin(a038,a041);
  a038=(a038-a039);
  a038=casadi_fmax(a004,a038);
  a038=(a008?a038:0);
  a008=(!a008);
  a008=(a008?a040:0);
  a038=(a038+a008);
  if (res[0]!=0) res[0][11]=a038;
  if (res[0]!=0) res[0][12]=a026;
  a058=casadi_fmin(a058,a041);
  a058=(a058-a039);
  a058=casadi_fmax(a004,a058);
  a058=(a028?a058:0);
  a028=(!a028);
  a028=(a028?a061:0);
  a058=(a058+a028);
  if (res[0]!=0) res[0][13]=a058;
  if (res[0]!=0) res[0][14]=a011;
  a037=casadi_fmin(a037,a041);
  a037=(a037-a039);
  a037=casadi_fmax(a004,a037);
  a037=(a012?a037:0);
  a012=(!a012);
  a012=(a012?a047:0);
  a037=(a037+a012);
  if (res[0]!=0) res[0][15]=a037;
  if (res[0]!=0) res[0][16]=a029;
  a060=casadi_fmin(a060,a041);
  a060=(a060-a039);
  a060=casadi_fmax(a004,a060);
  a060=(a031?a060:0);
  a031=(!a031);
  a031=(a031?a063:0);
  a060=(a060+a031);
  if (res[0]!=0) res[0][17]=a060;
  if (res[0]!=0) res[0][18]=a017;
  a050=casadi_fmin(a050,a041);
  a050=(a050-a039);
  a050=casadi_fmax(a004,a050);
  a050=(a018?a050:0);
  a018=(!a018);
  a018=(a018?a053:0);
  a050=(a050+a018);
  if (res[0]!=0) res[0][19]=a050;
  a044=casadi_fmin(a044,a041);
  a044=(a044-a039);
  a044=casadi_fmax(a004,a044);
  a044=(a009?a044:0);
  a009=(!a009);
  a009=(a009?a045:0);
  a044=(a044+a009);
  if (res[0]!=0) res[0][20]=a044;
  a046=casadi_fmin(a046,a041);
  a046=(a046-a039);
  a046=casadi_fmax(a004,a046);
  a046=(a013?a046:0);
  a013=(!a013);
  a013=(a013?a049:0);
  a046=(a046+a013);
  if (res[0]!=0) res[0][21]=a046;
  a052=casadi_fmin(a052,a041);
  a052=(a052-a039);
  a052=casadi_fmax(a004,a052);
  a052=(a019?a052:0);
  a019=(!a019);
  a019=(a019?a055:0);
  a052=(a052+a019);
  if (res[0]!=0) res[0][22]=a052;
  if (res[0]!=0) res[0][23]=a035;
  a001=(a000<a001);
  a006=(a006?a010:0);
  a001=(a001?a006:0);
  if (res[0]!=0) res[0][24]=a001;
  if (res[0]!=0) res[0][25]=a126;
  if (res[0]!=0) res[0][26]=a123;
  a124=casadi_fabs(a124);
  a124=(a125<a124);
  a124=(a124?a125:0);
  if (res[0]!=0) res[0][27]=a124;
  if (res[0]!=0) res[0][28]=a024;
  if (res[0]!=0) res[0][29]=a115;
  a042=casadi_fabs(a042);
  a042=(a065<a042);
  a042=(a042?a065:0);
  if (res[0]!=0) res[0][30]=a042;
  if (res[0]!=0) res[0][31]=a112;
  if (res[0]!=0) res[0][32]=a073;
  a108=casadi_fabs(a108);
  a108=(a110<a108);
  a108=(a108?a110:0);
  if (res[0]!=0) res[0][33]=a108;
  if (res[0]!=0) res[0][34]=a074;
  a078=casadi_fmin(a078,a041);
  a078=(a078-a039);
  a078=casadi_fmax(a004,a078);
  a078=(a076?a078:0);
  a076=(!a076);
  a076=(a076?a079:0);
  a078=(a078+a076);
  if (res[0]!=0) res[0][35]=a078;
  if (res[0]!=0) res[0][36]=a011;
  if (res[0]!=0) res[0][37]=a081;
  if (res[0]!=0) res[0][38]=a026;
  if (res[0]!=0) res[0][39]=a080;
  if (res[0]!=0) res[0][40]=a103;
  if (res[0]!=0) res[0][41]=a087;
  a091=casadi_fmin(a091,a041);
  a091=(a091-a039);
  a091=casadi_fmax(a004,a091);
  a091=(a090?a091:0);
  a090=(!a090);
  a090=(a090?a092:0);
  a091=(a091+a090);
  if (res[0]!=0) res[0][42]=a091;
  if (res[0]!=0) res[0][43]=a017;
  if (res[0]!=0) res[0][44]=a094;
  if (res[0]!=0) res[0][45]=a029;
  if (res[0]!=0) res[0][46]=a093;
  if (res[0]!=0) res[0][47]=a107;
  a107=arg[1]? arg[1][11] : 0;
  a075=(a075*a107);
  a030=(a030+a075);
  if (res[0]!=0) res[0][48]=a030;
  if (res[0]!=0) res[0][49]=a105;
  if (res[0]!=0) res[0][50]=a101;
  a027=(a027*a107);
  a077=(a077+a027);
  if (res[0]!=0) res[0][51]=a077;
  if (res[0]!=0) res[0][52]=a106;
  if (res[0]!=0) res[0][53]=a099;
  a069=(a069?a070:0);
  a068=(a068*a107);
  a069=(a069+a068);
  if (res[0]!=0) res[0][54]=a069;
  if (res[0]!=0) res[0][55]=a072;
  if (res[0]!=0) res[0][56]=a062;
  a084=(a084?a085:0);
  a086=(a086*a107);
  a084=(a084+a086);
  if (res[0]!=0) res[0][57]=a084;
  if (res[0]!=0) res[0][58]=a088;
  if (res[0]!=0) res[0][59]=a083;
  a096=(a096?a097:0);
  a098=(a098*a107);
  a096=(a096+a098);
  if (res[0]!=0) res[0][60]=a096;
  if (res[0]!=0) res[0][61]=a100;
  if (res[0]!=0) res[0][62]=a095;
  if (res[0]!=0) res[0][63]=a128;
  if (res[0]!=0) res[0][64]=a130;
  a120=(a121-a120);
  a130=arg[1]? arg[1][15] : 0;
  a120=(a120*a130);
  a119=(a119+a120);
  a120=arg[1]? arg[1][14] : 0;
  a127=(a127*a120);
  a119=(a119+a127);
  if (res[0]!=0) res[0][65]=a119;
  a122=(a131-a122);
  a119=arg[1]? arg[1][17] : 0;
  a122=(a122*a119);
  a129=(a129+a122);
  a122=arg[1]? arg[1][16] : 0;
  a132=(a132*a122);
  a129=(a129+a132);
  if (res[0]!=0) res[0][66]=a129;
  if (res[0]!=0) res[0][67]=a117;
  if (res[0]!=0) res[0][68]=a116;
  if (res[0]!=0) res[0][69]=a021;
  a021=arg[1]? arg[1][31] : 0;
  a021=(a021*a133);
  a113=(a113-a104);
  a021=(a021*a113);
  a004=(a004<a021);
  a021=(a004?a114:0);
  a004=(!a004);
  a113=arg[0]? arg[0][67] : 0;
  a104=(-a113);
  a116=arg[1]? arg[1][30] : 0;
  a133=(a133*a116);
  a114=(a114+a133);
  a113=casadi_fmin(a113,a114);
  a104=casadi_fmax(a104,a113);
  a004=(a004?a104:0);
  a021=(a021+a004);
  if (res[0]!=0) res[0][70]=a021;
  a021=(a000<a033);
  a004=(a021?a067:0);
  a021=(!a021);
  a034=(a071?a034:0);
  a071=(!a071);
  a071=(a071?a067:0);
  a034=(a034+a071);
  a021=(a021?a034:0);
  a004=(a004+a021);
  if (res[0]!=0) res[0][71]=a004;
  a021=(a000<a033);
  a034=(a021?a066:0);
  a021=(!a021);
  a121=(a064?a121:0);
  a064=(!a064);
  a064=(a064?a066:0);
  a121=(a121+a064);
  a021=(a021?a121:0);
  a034=(a034+a021);
  if (res[0]!=0) res[0][72]=a034;
  a000=(a000<a033);
  a033=(a000?a089:0);
  a000=(!a000);
  a131=(a102?a131:0);
  a102=(!a102);
  a102=(a102?a089:0);
  a131=(a131+a102);
  a000=(a000?a131:0);
  a033=(a033+a000);
  if (res[0]!=0) res[0][73]=a033;
  a000=-3700.;
  a131=3700.;
  a004=(a004*a003);
  a004=casadi_fmin(a131,a004);
  a004=casadi_fmax(a000,a004);
  if (res[1]!=0) res[1][0]=a004;
  a034=(a034*a003);
  a034=casadi_fmin(a131,a034);
  a034=casadi_fmax(a000,a034);
  if (res[1]!=0) res[1][1]=a034;
  a033=(a033*a003);
  a131=casadi_fmin(a131,a033);
  a000=casadi_fmax(a000,a131);
  if (res[1]!=0) res[1][2]=a000;
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


