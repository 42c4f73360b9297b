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
static const casadi_int casadi_s1[3] = {33, 1, 1};
static const casadi_int casadi_s2[3] = {86, 1, 1};
static const casadi_int casadi_s3[3] = {10, 1, 1};
static const casadi_int casadi_s4[3] = {3, 1, 1};

static const casadi_real casadi_zeros[68] = 
  {0.};

/* controller_prepare:(parameters[68])->(derived[33]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real w1, w2, w3, w4, w5, w6;
  const casadi_real *wr0;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = @0[0] */
  w1 = wr0[0];
  /* #2: @2 = @0[17] */
  w2 = wr0[17];
  /* #3: @2 = (@1/@2) */
  w2  = (w1/w2);
  /* #4: output[0][0] = @2 */
  if (res[0]) res[0][0] = w2;
  /* #5: @2 = @0[21] */
  w2 = wr0[21];
  /* #6: @3 = (1./@2) */
  w3 = (1./ w2 );
  /* #7: output[0][1] = @3 */
  if (res[0]) res[0][1] = w3;
  /* #8: @3 = 1 */
  w3 = 1.;
  /* #9: @4 = @0[20] */
  w4 = wr0[20];
  /* #10: @4 = (@4/@2) */
  w4 /= w2;
  /* #11: @3 = (@3+@4) */
  w3 += w4;
  /* #12: output[0][2] = @3 */
  if (res[0]) res[0][2] = w3;
  /* #13: @3 = @0[25] */
  w3 = wr0[25];
  /* #14: @4 = (1./@3) */
  w4 = (1./ w3 );
  /* #15: output[0][3] = @4 */
  if (res[0]) res[0][3] = w4;
  /* #16: @4 = 1 */
  w4 = 1.;
  /* #17: @2 = @0[24] */
  w2 = wr0[24];
  /* #18: @2 = (@2/@3) */
  w2 /= w3;
  /* #19: @4 = (@4+@2) */
  w4 += w2;
  /* #20: output[0][4] = @4 */
  if (res[0]) res[0][4] = w4;
  /* #21: @4 = @0[29] */
  w4 = wr0[29];
  /* #22: @2 = (1./@4) */
  w2 = (1./ w4 );
  /* #23: output[0][5] = @2 */
  if (res[0]) res[0][5] = w2;
  /* #24: @2 = 1 */
  w2 = 1.;
  /* #25: @3 = @0[28] */
  w3 = wr0[28];
  /* #26: @3 = (@3/@4) */
  w3 /= w4;
  /* #27: @2 = (@2+@3) */
  w2 += w3;
  /* #28: output[0][6] = @2 */
  if (res[0]) res[0][6] = w2;
  /* #29: @2 = @0[31] */
  w2 = wr0[31];
  /* #30: @2 = (@2*@1) */
  w2 *= w1;
  /* #31: output[0][7] = @2 */
  if (res[0]) res[0][7] = w2;
  /* #32: @2 = @0[32] */
  w2 = wr0[32];
  /* #33: @2 = (@1/@2) */
  w2  = (w1/w2);
  /* #34: output[0][8] = @2 */
  if (res[0]) res[0][8] = w2;
  /* #35: @2 = @0[36] */
  w2 = wr0[36];
  /* #36: @3 = (@1/@2) */
  w3  = (w1/w2);
  /* #37: output[0][9] = @3 */
  if (res[0]) res[0][9] = w3;
  /* #38: @3 = @0[39] */
  w3 = wr0[39];
  /* #39: @4 = (@1/@3) */
  w4  = (w1/w3);
  /* #40: output[0][10] = @4 */
  if (res[0]) res[0][10] = w4;
  /* #41: @4 = @0[42] */
  w4 = wr0[42];
  /* #42: @5 = (@4*@1) */
  w5  = (w4*w1);
  /* #43: output[0][11] = @5 */
  if (res[0]) res[0][11] = w5;
  /* #44: @5 = 6.2832 */
  w5 = 6.2831999999999999e+00;
  /* #45: @5 = (@5*@4) */
  w5 *= w4;
  /* #46: @5 = (@5*@1) */
  w5 *= w1;
  /* #47: output[0][12] = @5 */
  if (res[0]) res[0][12] = w5;
  /* #48: @5 = @0[49] */
  w5 = wr0[49];
  /* #49: @5 = (@5*@1) */
  w5 *= w1;
  /* #50: output[0][13] = @5 */
  if (res[0]) res[0][13] = w5;
  /* #51: @5 = @0[50] */
  w5 = wr0[50];
  /* #52: @5 = (@5*@1) */
  w5 *= w1;
  /* #53: output[0][14] = @5 */
  if (res[0]) res[0][14] = w5;
  /* #54: @5 = @0[52] */
  w5 = wr0[52];
  /* #55: @4 = (@5*@1) */
  w4  = (w5*w1);
  /* #56: output[0][15] = @4 */
  if (res[0]) res[0][15] = w4;
  /* #57: @5 = (@5*@1) */
  w5 *= w1;
  /* #58: @4 = @0[51] */
  w4 = wr0[51];
  /* #59: @5 = (@5/@4) */
  w5 /= w4;
  /* #60: output[0][16] = @5 */
  if (res[0]) res[0][16] = w5;
  /* #61: @5 = @0[54] */
  w5 = wr0[54];
  /* #62: @4 = (@5*@1) */
  w4  = (w5*w1);
  /* #63: output[0][17] = @4 */
  if (res[0]) res[0][17] = w4;
  /* #64: @5 = (@5*@1) */
  w5 *= w1;
  /* #65: @4 = @0[53] */
  w4 = wr0[53];
  /* #66: @5 = (@5/@4) */
  w5 /= w4;
  /* #67: output[0][18] = @5 */
  if (res[0]) res[0][18] = w5;
  /* #68: @5 = @0[55] */
  w5 = wr0[55];
  /* #69: @5 = (@5/@2) */
  w5 /= w2;
  /* #70: output[0][19] = @5 */
  if (res[0]) res[0][19] = w5;
  /* #71: @5 = @0[56] */
  w5 = wr0[56];
  /* #72: @5 = (@5/@3) */
  w5 /= w3;
  /* #73: output[0][20] = @5 */
  if (res[0]) res[0][20] = w5;
  /* #74: @5 = @0[60] */
  w5 = wr0[60];
  /* #75: @5 = (@5*@1) */
  w5 *= w1;
  /* #76: output[0][21] = @5 */
  if (res[0]) res[0][21] = w5;
  /* #77: @5 = @0[61] */
  w5 = wr0[61];
  /* #78: @5 = (@5*@1) */
  w5 *= w1;
  /* #79: @4 = @0[57] */
  w4 = wr0[57];
  /* #80: @5 = (@5/@4) */
  w5 /= w4;
  /* #81: output[0][22] = @5 */
  if (res[0]) res[0][22] = w5;
  /* #82: @5 = @0[62] */
  w5 = wr0[62];
  /* #83: @5 = (@5*@1) */
  w5 *= w1;
  /* #84: @5 = (@5/@4) */
  w5 /= w4;
  /* #85: output[0][23] = @5 */
  if (res[0]) res[0][23] = w5;
  /* #86: @5 = @0[64] */
  w5 = wr0[64];
  /* #87: @6 = (@4*@5) */
  w6  = (w4*w5);
  /* #88: @2 = (2.*@2) */
  w2 = (2.* w2 );
  /* #89: @6 = (@6/@2) */
  w6 /= w2;
  /* #90: output[0][24] = @6 */
  if (res[0]) res[0][24] = w6;
  /* #91: @4 = (@4*@5) */
  w4 *= w5;
  /* #92: @3 = (2.*@3) */
  w3 = (2.* w3 );
  /* #93: @4 = (@4/@3) */
  w4 /= w3;
  /* #94: output[0][25] = @4 */
  if (res[0]) res[0][25] = w4;
  /* #95: @4 = 2 */
  w4 = 2.;
  /* #96: @4 = (@5/@4) */
  w4  = (w5/w4);
  /* #97: output[0][26] = @4 */
  if (res[0]) res[0][26] = w4;
  /* #98: @4 = 2 */
  w4 = 2.;
  /* #99: @5 = (@5/@4) */
  w5 /= w4;
  /* #100: output[0][27] = @5 */
  if (res[0]) res[0][27] = w5;
  /* #101: @5 = @0[65] */
  w5 = wr0[65];
  /* #102: @5 = (@5*@1) */
  w5 *= w1;
  /* #103: output[0][28] = @5 */
  if (res[0]) res[0][28] = w5;
  /* #104: @5 = 1.01 */
  w5 = 1.0100000000000000e+00;
  /* #105: @4 = 930 */
  w4 = 930.;
  /* #106: @3 = @0[22] */
  w3 = wr0[22];
  /* #107: @4 = fmin(@4,@3) */
  w4  = casadi_fmin(w4,w3);
  /* #108: @5 = (@5*@4) */
  w5 *= w4;
  /* #109: output[0][29] = @5 */
  if (res[0]) res[0][29] = w5;
  /* #110: @5 = 1.01 */
  w5 = 1.0100000000000000e+00;
  /* #111: @4 = 3700 */
  w4 = 3700.;
  /* #112: @3 = @0[26] */
  w3 = wr0[26];
  /* #113: @4 = fmin(@4,@3) */
  w4  = casadi_fmin(w4,w3);
  /* #114: @5 = (@5*@4) */
  w5 *= w4;
  /* #115: output[0][30] = @5 */
  if (res[0]) res[0][30] = w5;
  /* #116: @5 = 1.01 */
  w5 = 1.0100000000000000e+00;
  /* #117: @4 = 3700 */
  w4 = 3700.;
  /* #118: @3 = @0[30] */
  w3 = wr0[30];
  /* #119: @4 = fmin(@4,@3) */
  w4  = casadi_fmin(w4,w3);
  /* #120: @5 = (@5*@4) */
  w5 *= w4;
  /* #121: output[0][31] = @5 */
  if (res[0]) res[0][31] = w5;
  /* #122: @5 = @0[1] */
  w5 = wr0[1];
  /* #123: @1 = (@1/@5) */
  w1 /= w5;
  /* #124: output[0][32] = @1 */
  if (res[0]) res[0][32] = w1;
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

/* controller_step:(parameters[68],derived[33],states[86],inputs[10])->(next_states[86],outputs[3]) */
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
  casadi_real a132, a133, a134, a135, a136, a137, a138, a139, a140, a141, a142, a143;
  casadi_real a144, a145, a146, a147, a148, a149;
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
  a010=arg[0]? arg[0][12] : 0;
  a009=(a009<=a010);
  a009=(a009?a002:0);
  a008=(a008?a002:0);
  a010=casadi_fmin(a009,a008);
  a011=arg[3]? arg[3][6] : 0;
  a012=casadi_fabs(a011);
  a013=arg[0]? arg[0][9] : 0;
  a012=(a012<=a013);
  a011=(a012?a011:0);
  a013=(!a012);
  a014=arg[2]? arg[2][16] : 0;
  a013=(a013?a014:0);
  a011=(a011+a013);
  a013=casadi_fabs(a011);
  a014=arg[0]? arg[0][13] : 0;
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
  a017=arg[3]? arg[3][8] : 0;
  a018=casadi_fabs(a017);
  a019=arg[0]? arg[0][11] : 0;
  a018=(a018<=a019);
  a017=(a018?a017:0);
  a019=(!a018);
  a020=arg[2]? arg[2][20] : 0;
  a019=(a019?a020:0);
  a017=(a017+a019);
  a019=casadi_fabs(a017);
  a020=arg[0]? arg[0][14] : 0;
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
  a029=arg[3]? arg[3][5] : 0;
  a030=casadi_fabs(a029);
  a031=arg[0]? arg[0][8] : 0;
  a030=(a030<=a031);
  a031=(a030?a002:0);
  a010=casadi_fmin(a010,a031);
  a032=arg[3]? arg[3][7] : 0;
  a033=casadi_fabs(a032);
  a034=arg[0]? arg[0][10] : 0;
  a033=(a033<=a034);
  a034=(a033?a002:0);
  a010=casadi_fmin(a010,a034);
  a035=arg[2]? arg[2][3] : 0;
  a036=(a002-a035);
  a010=(a010*a036);
  a036=arg[2]? arg[2][26] : 0;
  a037=-1.;
  a038=arg[3]? arg[3][9] : 0;
  a038=(a037+a038);
  a038=casadi_fabs(a038);
  a038=(a038<=a000);
  a038=(a038?a002:0);
  a039=arg[2]? arg[2][25] : 0;
  a039=(a038-a039);
  a036=casadi_fmax(a036,a039);
  a010=(a010*a036);
  a036=(-a010);
  a036=(a006?a036:0);
  a005=(a005?a036:0);
  a005=(a002+a005);
  a001=(a001*a005);
  a005=(a000<a001);
  a036=(a005?a001:0);
  a005=(!a005);
  a039=9998.;
  a008=(a000<a008);
  a040=(!a008);
  a041=arg[2]? arg[2][11] : 0;
  a042=arg[0]? arg[0][0] : 0;
  a043=(a041+a042);
  a044=arg[0]? arg[0][2] : 0;
  a045=(a000*a042);
  a045=(a044+a045);
  a045=(a043<=a045);
  a045=(!a045);
  a045=(a045?a002:0);
  a040=(a040?a045:0);
  a040=(a004<a040);
  a045=4.;
  a045=(a040?a045:0);
  a040=(!a040);
  a046=9999.;
  a040=(a040?a046:0);
  a045=(a045+a040);
  a009=(a000<a009);
  a040=(!a009);
  a047=arg[2]? arg[2][22] : 0;
  a048=(a047+a042);
  a049=(a000*a042);
  a049=(a044+a049);
  a049=(a048<=a049);
  a049=(!a049);
  a049=(a049?a002:0);
  a040=(a040?a049:0);
  a040=(a004<a040);
  a049=4004.;
  a049=(a040?a049:0);
  a040=(!a040);
  a040=(a040?a046:0);
  a049=(a049+a040);
  a045=casadi_fmin(a045,a049);
  a012=(a000<a012);
  a049=(!a012);
  a040=arg[2]? arg[2][17] : 0;
  a050=(a040+a042);
  a051=(a000*a042);
  a051=(a044+a051);
  a051=(a050<=a051);
  a051=(!a051);
  a051=(a051?a002:0);
  a049=(a049?a051:0);
  a049=(a004<a049);
  a051=7.;
  a051=(a049?a051:0);
  a049=(!a049);
  a049=(a049?a046:0);
  a051=(a051+a049);
  a045=casadi_fmin(a045,a051);
  a013=(a000<a013);
  a051=(!a013);
  a049=arg[2]? arg[2][23] : 0;
  a052=(a049+a042);
  a053=(a000*a042);
  a053=(a044+a053);
  a053=(a052<=a053);
  a053=(!a053);
  a053=(a053?a002:0);
  a051=(a051?a053:0);
  a051=(a004<a051);
  a053=4007.;
  a053=(a051?a053:0);
  a051=(!a051);
  a051=(a051?a046:0);
  a053=(a053+a051);
  a045=casadi_fmin(a045,a053);
  a016=(a000<a016);
  a053=(!a016);
  a051=arg[2]? arg[2][7] : 0;
  a054=(a051+a042);
  a055=(a000*a042);
  a055=(a044+a055);
  a055=(a054<=a055);
  a055=(!a055);
  a055=(a055?a002:0);
  a053=(a053?a055:0);
  a053=(a004<a053);
  a055=2.;
  a055=(a053?a055:0);
  a053=(!a053);
  a053=(a053?a046:0);
  a055=(a055+a053);
  a045=casadi_fmin(a045,a055);
  a018=(a000<a018);
  a055=(!a018);
  a053=arg[2]? arg[2][21] : 0;
  a056=(a053+a042);
  a057=(a000*a042);
  a057=(a044+a057);
  a057=(a056<=a057);
  a057=(!a057);
  a057=(a057?a002:0);
  a055=(a055?a057:0);
  a055=(a004<a055);
  a057=9.;
  a057=(a055?a057:0);
  a055=(!a055);
  a055=(a055?a046:0);
  a057=(a057+a055);
  a045=casadi_fmin(a045,a057);
  a019=(a000<a019);
  a057=(!a019);
  a055=arg[2]? arg[2][24] : 0;
  a058=(a055+a042);
  a059=(a000*a042);
  a059=(a044+a059);
  a059=(a058<=a059);
  a059=(!a059);
  a059=(a059?a002:0);
  a057=(a057?a059:0);
  a057=(a004<a057);
  a059=4009.;
  a059=(a057?a059:0);
  a057=(!a057);
  a057=(a057?a046:0);
  a059=(a059+a057);
  a045=casadi_fmin(a045,a059);
  a022=(a000<a022);
  a059=(!a022);
  a057=arg[2]? arg[2][9] : 0;
  a060=(a057+a042);
  a061=(a000*a042);
  a061=(a044+a061);
  a061=(a060<=a061);
  a061=(!a061);
  a061=(a061?a002:0);
  a059=(a059?a061:0);
  a059=(a004<a059);
  a061=3.;
  a061=(a059?a061:0);
  a059=(!a059);
  a059=(a059?a046:0);
  a061=(a061+a059);
  a045=casadi_fmin(a045,a061);
  a025=(a000<a025);
  a061=(!a025);
  a059=arg[2]? arg[2][5] : 0;
  a062=(a059+a042);
  a063=(a000*a042);
  a063=(a044+a063);
  a063=(a062<=a063);
  a063=(!a063);
  a063=(a063?a002:0);
  a061=(a061?a063:0);
  a061=(a004<a061);
  a063=(a061?a002:0);
  a061=(!a061);
  a061=(a061?a046:0);
  a063=(a063+a061);
  a045=casadi_fmin(a045,a063);
  a028=(a000<a028);
  a063=(!a028);
  a061=arg[2]? arg[2][13] : 0;
  a064=(a061+a042);
  a065=(a000*a042);
  a065=(a044+a065);
  a065=(a064<=a065);
  a065=(!a065);
  a065=(a065?a002:0);
  a063=(a063?a065:0);
  a063=(a004<a063);
  a065=5.;
  a065=(a063?a065:0);
  a063=(!a063);
  a063=(a063?a046:0);
  a065=(a065+a063);
  a045=casadi_fmin(a045,a065);
  a031=(a000<a031);
  a065=(!a031);
  a063=arg[2]? arg[2][15] : 0;
  a066=(a063+a042);
  a067=(a000*a042);
  a067=(a044+a067);
  a067=(a066<=a067);
  a067=(!a067);
  a067=(a067?a002:0);
  a065=(a065?a067:0);
  a065=(a004<a065);
  a067=6.;
  a067=(a065?a067:0);
  a065=(!a065);
  a065=(a065?a046:0);
  a067=(a067+a065);
  a045=casadi_fmin(a045,a067);
  a034=(a000<a034);
  a067=(!a034);
  a065=arg[2]? arg[2][19] : 0;
  a068=(a065+a042);
  a069=(a000*a042);
  a069=(a044+a069);
  a069=(a068<=a069);
  a069=(!a069);
  a069=(a069?a002:0);
  a067=(a067?a069:0);
  a067=(a004<a067);
  a069=8.;
  a069=(a067?a069:0);
  a067=(!a067);
  a067=(a067?a046:0);
  a069=(a069+a067);
  a045=casadi_fmin(a045,a069);
  a069=(a039<a045);
  a069=(!a069);
  a069=(a069?a045:0);
  a005=(a005?a069:0);
  a036=(a036+a005);
  a005=(a000<a036);
  a036=(a005?a036:0);
  a005=(!a005);
  a069=arg[2]? arg[2][2] : 0;
  a045=(a000<a069);
  a067=arg[2]? arg[2][36] : 0;
  a067=(a045?a067:0);
  a045=(!a045);
  a045=(a045?a007:0);
  a067=(a067+a045);
  a045=arg[1]? arg[1][8] : 0;
  a070=arg[2]? arg[2][83] : 0;
  a071=(a070*a003);
  a026=(a027?a026:0);
  a027=(!a027);
  a072=arg[2]? arg[2][12] : 0;
  a027=(a027?a072:0);
  a026=(a026+a027);
  a027=(a071-a026);
  a045=(a045*a027);
  a045=(a067+a045);
  a027=arg[1]? arg[1][7] : 0;
  a067=(a007-a067);
  a067=(a027*a067);
  a045=(a045+a067);
  a067=(a045-a007);
  a067=casadi_fabs(a067);
  a072=arg[0]? arg[0][33] : 0;
  a072=(a067<=a072);
  a072=(a072?a002:0);
  a072=(a000<a072);
  a073=(!a072);
  a074=arg[2]? arg[2][37] : 0;
  a075=(a074+a042);
  a076=(a000*a042);
  a076=(a044+a076);
  a076=(a075<=a076);
  a076=(!a076);
  a076=(a076?a002:0);
  a073=(a073?a076:0);
  a073=(a004<a073);
  a076=5004.;
  a076=(a073?a076:0);
  a073=(!a073);
  a073=(a073?a046:0);
  a076=(a076+a073);
  a073=arg[0]? arg[0][34] : 0;
  a077=(a067-a073);
  a078=arg[2]? arg[2][38] : 0;
  a078=(a007==a078);
  a079=(a000<a069);
  a080=arg[2]? arg[2][39] : 0;
  a079=(a079?a080:0);
  a079=(a079+a042);
  a078=(a078?a079:0);
  a079=arg[0]? arg[0][35] : 0;
  a080=(a078-a079);
  a077=casadi_fmin(a077,a080);
  a077=(a004<a077);
  a080=3004.;
  a080=(a077?a080:0);
  a077=(!a077);
  a077=(a077?a046:0);
  a080=(a080+a077);
  a076=casadi_fmin(a076,a080);
  a080=-5.5000000000000000e+00;
  a077=(a000<a069);
  a081=arg[2]? arg[2][68] : 0;
  a077=(a077?a081:0);
  a081=arg[1]? arg[1][11] : 0;
  a077=(a077-a081);
  a077=casadi_fmax(a004,a077);
  a082=arg[0]? arg[0][46] : 0;
  a083=(a000<a069);
  a084=arg[2]? arg[2][66] : 0;
  a085=(-a084);
  a085=(a083?a085:0);
  a085=(a071+a085);
  a086=(a082<a085);
  a087=(a086?a002:0);
  a086=(!a086);
  a082=(-a082);
  a082=(a085<a082);
  a088=(a082?a037:0);
  a082=(!a082);
  a089=arg[2]? arg[2][67] : 0;
  a082=(a082?a089:0);
  a088=(a088+a082);
  a086=(a086?a088:0);
  a087=(a087+a086);
  a089=(a087==a089);
  a089=(!a089);
  a089=(a089?a002:0);
  a077=(a077+a089);
  a089=(a080+a077);
  a089=(a004<a089);
  a086=8001.;
  a086=(a089?a086:0);
  a089=(!a089);
  a089=(a089?a046:0);
  a086=(a086+a089);
  a076=casadi_fmin(a076,a086);
  a086=(a000<a069);
  a089=arg[2]? arg[2][43] : 0;
  a089=(a086?a089:0);
  a086=(!a086);
  a086=(a086?a011:0);
  a089=(a089+a086);
  a086=arg[1]? arg[1][9] : 0;
  a088=arg[2]? arg[2][84] : 0;
  a082=(a088*a003);
  a029=(a030?a029:0);
  a030=(!a030);
  a090=arg[2]? arg[2][14] : 0;
  a030=(a030?a090:0);
  a029=(a029+a030);
  a030=(a082+a029);
  a086=(a086*a030);
  a086=(a089+a086);
  a089=(a011-a089);
  a089=(a027*a089);
  a086=(a086+a089);
  a089=(a086-a011);
  a089=casadi_fabs(a089);
  a030=arg[0]? arg[0][37] : 0;
  a030=(a089<=a030);
  a030=(a030?a002:0);
  a030=(a000<a030);
  a090=(!a030);
  a091=arg[2]? arg[2][44] : 0;
  a092=(a091+a042);
  a093=(a000*a042);
  a093=(a044+a093);
  a093=(a092<=a093);
  a093=(!a093);
  a093=(a093?a002:0);
  a090=(a090?a093:0);
  a090=(a004<a090);
  a093=5007.;
  a093=(a090?a093:0);
  a090=(!a090);
  a090=(a090?a046:0);
  a093=(a093+a090);
  a076=casadi_fmin(a076,a093);
  a093=arg[0]? arg[0][38] : 0;
  a090=(a089-a093);
  a094=arg[2]? arg[2][45] : 0;
  a094=(a011==a094);
  a095=(a000<a069);
  a096=arg[2]? arg[2][46] : 0;
  a095=(a095?a096:0);
  a095=(a095+a042);
  a094=(a094?a095:0);
  a095=(a094-a079);
  a090=casadi_fmin(a090,a095);
  a090=(a004<a090);
  a095=3007.;
  a095=(a090?a095:0);
  a090=(!a090);
  a090=(a090?a046:0);
  a095=(a095+a090);
  a076=casadi_fmin(a076,a095);
  a095=(a000<a069);
  a090=arg[2]? arg[2][71] : 0;
  a095=(a095?a090:0);
  a095=(a095-a081);
  a095=casadi_fmax(a004,a095);
  a090=arg[0]? arg[0][47] : 0;
  a096=(a000<a069);
  a097=arg[2]? arg[2][69] : 0;
  a098=(-a097);
  a098=(a096?a098:0);
  a098=(a082+a098);
  a099=(a090<a098);
  a100=(a099?a002:0);
  a099=(!a099);
  a090=(-a090);
  a090=(a098<a090);
  a101=(a090?a037:0);
  a090=(!a090);
  a102=arg[2]? arg[2][70] : 0;
  a090=(a090?a102:0);
  a101=(a101+a090);
  a099=(a099?a101:0);
  a100=(a100+a099);
  a102=(a100==a102);
  a102=(!a102);
  a102=(a102?a002:0);
  a095=(a095+a102);
  a102=(a080+a095);
  a102=(a004<a102);
  a099=8002.;
  a099=(a102?a099:0);
  a102=(!a102);
  a102=(a102?a046:0);
  a099=(a099+a102);
  a076=casadi_fmin(a076,a099);
  a099=(a000<a069);
  a102=arg[2]? arg[2][50] : 0;
  a102=(a099?a102:0);
  a099=(!a099);
  a099=(a099?a017:0);
  a102=(a102+a099);
  a099=arg[1]? arg[1][10] : 0;
  a101=arg[2]? arg[2][85] : 0;
  a090=(a101*a003);
  a032=(a033?a032:0);
  a033=(!a033);
  a103=arg[2]? arg[2][18] : 0;
  a033=(a033?a103:0);
  a032=(a032+a033);
  a033=(a090+a032);
  a099=(a099*a033);
  a099=(a102+a099);
  a102=(a017-a102);
  a027=(a027*a102);
  a099=(a099+a027);
  a027=(a099-a017);
  a027=casadi_fabs(a027);
  a102=arg[0]? arg[0][40] : 0;
  a102=(a027<=a102);
  a102=(a102?a002:0);
  a102=(a000<a102);
  a033=(!a102);
  a103=arg[2]? arg[2][51] : 0;
  a104=(a103+a042);
  a105=(a000*a042);
  a105=(a044+a105);
  a105=(a104<=a105);
  a105=(!a105);
  a105=(a105?a002:0);
  a033=(a033?a105:0);
  a033=(a004<a033);
  a105=5009.;
  a105=(a033?a105:0);
  a033=(!a033);
  a033=(a033?a046:0);
  a105=(a105+a033);
  a076=casadi_fmin(a076,a105);
  a105=arg[0]? arg[0][41] : 0;
  a033=(a027-a105);
  a106=arg[2]? arg[2][52] : 0;
  a106=(a017==a106);
  a107=(a000<a069);
  a108=arg[2]? arg[2][53] : 0;
  a107=(a107?a108:0);
  a107=(a107+a042);
  a106=(a106?a107:0);
  a107=(a106-a079);
  a033=casadi_fmin(a033,a107);
  a033=(a004<a033);
  a107=3009.;
  a107=(a033?a107:0);
  a033=(!a033);
  a033=(a033?a046:0);
  a107=(a107+a033);
  a076=casadi_fmin(a076,a107);
  a107=(a000<a069);
  a033=arg[2]? arg[2][74] : 0;
  a107=(a107?a033:0);
  a107=(a107-a081);
  a107=casadi_fmax(a004,a107);
  a033=arg[0]? arg[0][48] : 0;
  a108=(a000<a069);
  a109=arg[2]? arg[2][72] : 0;
  a110=(-a109);
  a110=(a108?a110:0);
  a110=(a090+a110);
  a111=(a033<a110);
  a112=(a111?a002:0);
  a111=(!a111);
  a033=(-a033);
  a033=(a110<a033);
  a113=(a033?a037:0);
  a033=(!a033);
  a114=arg[2]? arg[2][73] : 0;
  a033=(a033?a114:0);
  a113=(a113+a033);
  a111=(a111?a113:0);
  a112=(a112+a111);
  a114=(a112==a114);
  a114=(!a114);
  a114=(a114?a002:0);
  a107=(a107+a114);
  a114=(a080+a107);
  a114=(a004<a114);
  a111=8003.;
  a111=(a114?a111:0);
  a114=(!a114);
  a114=(a114?a046:0);
  a111=(a111+a114);
  a076=casadi_fmin(a076,a111);
  a067=(a067-a073);
  a073=arg[2]? arg[2][40] : 0;
  a073=(a026==a073);
  a111=(a000<a069);
  a114=arg[2]? arg[2][41] : 0;
  a111=(a111?a114:0);
  a111=(a111+a042);
  a073=(a073?a111:0);
  a111=(a073-a079);
  a067=casadi_fmin(a067,a111);
  a111=-5.0000000000000003e-02;
  a114=arg[0]? arg[0][22] : 0;
  a113=(a111*a114);
  a033=(a004<a073);
  a115=arg[2]? arg[2][42] : 0;
  a115=(a033?a115:0);
  a033=(!a033);
  a033=(a033?a071:0);
  a115=(a115+a033);
  a071=(a071-a115);
  a071=casadi_fabs(a071);
  a113=(a113+a071);
  a067=casadi_fmin(a067,a113);
  a067=(a004<a067);
  a113=3005.;
  a113=(a067?a113:0);
  a067=(!a067);
  a067=(a067?a046:0);
  a113=(a113+a067);
  a076=casadi_fmin(a076,a113);
  a113=(a000<a069);
  a067=arg[2]? arg[2][59] : 0;
  a113=(a113?a067:0);
  a113=(a113-a081);
  a113=casadi_fmax(a004,a113);
  a067=arg[0]? arg[0][43] : 0;
  a071=(a000<a069);
  a033=arg[2]? arg[2][57] : 0;
  a033=(a071?a033:0);
  a071=(!a071);
  a071=(a071?a026:0);
  a033=(a033+a071);
  a071=(a026-a033);
  a116=(a067<a071);
  a117=(a116?a002:0);
  a116=(!a116);
  a067=(-a067);
  a067=(a071<a067);
  a118=(a067?a037:0);
  a067=(!a067);
  a119=arg[2]? arg[2][58] : 0;
  a067=(a067?a119:0);
  a118=(a118+a067);
  a116=(a116?a118:0);
  a117=(a117+a116);
  a119=(a117==a119);
  a119=(!a119);
  a119=(a119?a002:0);
  a113=(a113+a119);
  a119=(a080+a113);
  a119=(a004<a119);
  a116=6005.;
  a116=(a119?a116:0);
  a119=(!a119);
  a119=(a119?a046:0);
  a116=(a116+a119);
  a076=casadi_fmin(a076,a116);
  a089=(a089-a093);
  a093=arg[2]? arg[2][47] : 0;
  a093=(a029==a093);
  a116=(a000<a069);
  a119=arg[2]? arg[2][48] : 0;
  a116=(a116?a119:0);
  a116=(a116+a042);
  a093=(a093?a116:0);
  a116=(a093-a079);
  a089=casadi_fmin(a089,a116);
  a116=arg[0]? arg[0][26] : 0;
  a119=(a111*a116);
  a118=(a004<a093);
  a067=arg[2]? arg[2][49] : 0;
  a067=(a118?a067:0);
  a118=(!a118);
  a118=(a118?a082:0);
  a067=(a067+a118);
  a082=(a082-a067);
  a082=casadi_fabs(a082);
  a119=(a119+a082);
  a089=casadi_fmin(a089,a119);
  a089=(a004<a089);
  a119=3006.;
  a119=(a089?a119:0);
  a089=(!a089);
  a089=(a089?a046:0);
  a119=(a119+a089);
  a076=casadi_fmin(a076,a119);
  a119=(a000<a069);
  a089=arg[2]? arg[2][62] : 0;
  a119=(a119?a089:0);
  a119=(a119-a081);
  a119=casadi_fmax(a004,a119);
  a089=arg[0]? arg[0][44] : 0;
  a082=(a000<a069);
  a118=arg[2]? arg[2][60] : 0;
  a118=(a082?a118:0);
  a082=(!a082);
  a082=(a082?a029:0);
  a118=(a118+a082);
  a082=(a029-a118);
  a120=(a089<a082);
  a121=(a120?a002:0);
  a120=(!a120);
  a089=(-a089);
  a089=(a082<a089);
  a122=(a089?a037:0);
  a089=(!a089);
  a123=arg[2]? arg[2][61] : 0;
  a089=(a089?a123:0);
  a122=(a122+a089);
  a120=(a120?a122:0);
  a121=(a121+a120);
  a123=(a121==a123);
  a123=(!a123);
  a123=(a123?a002:0);
  a119=(a119+a123);
  a123=(a080+a119);
  a123=(a004<a123);
  a120=6006.;
  a120=(a123?a120:0);
  a123=(!a123);
  a123=(a123?a046:0);
  a120=(a120+a123);
  a076=casadi_fmin(a076,a120);
  a027=(a027-a105);
  a105=arg[2]? arg[2][54] : 0;
  a105=(a032==a105);
  a120=(a000<a069);
  a123=arg[2]? arg[2][55] : 0;
  a120=(a120?a123:0);
  a120=(a120+a042);
  a105=(a105?a120:0);
  a079=(a105-a079);
  a027=casadi_fmin(a027,a079);
  a079=arg[0]? arg[0][30] : 0;
  a111=(a111*a079);
  a120=(a004<a105);
  a123=arg[2]? arg[2][56] : 0;
  a123=(a120?a123:0);
  a120=(!a120);
  a120=(a120?a090:0);
  a123=(a123+a120);
  a090=(a090-a123);
  a090=casadi_fabs(a090);
  a111=(a111+a090);
  a027=casadi_fmin(a027,a111);
  a027=(a004<a027);
  a111=3008.;
  a111=(a027?a111:0);
  a027=(!a027);
  a027=(a027?a046:0);
  a111=(a111+a027);
  a076=casadi_fmin(a076,a111);
  a111=(a000<a069);
  a027=arg[2]? arg[2][65] : 0;
  a111=(a111?a027:0);
  a111=(a111-a081);
  a111=casadi_fmax(a004,a111);
  a081=arg[0]? arg[0][45] : 0;
  a027=(a000<a069);
  a090=arg[2]? arg[2][63] : 0;
  a090=(a027?a090:0);
  a027=(!a027);
  a027=(a027?a032:0);
  a090=(a090+a027);
  a027=(a032-a090);
  a120=(a081<a027);
  a122=(a120?a002:0);
  a120=(!a120);
  a081=(-a081);
  a081=(a027<a081);
  a037=(a081?a037:0);
  a081=(!a081);
  a089=arg[2]? arg[2][64] : 0;
  a081=(a081?a089:0);
  a037=(a037+a081);
  a120=(a120?a037:0);
  a122=(a122+a120);
  a089=(a122==a089);
  a089=(!a089);
  a089=(a089?a002:0);
  a111=(a111+a089);
  a080=(a080+a111);
  a080=(a004<a080);
  a089=6008.;
  a089=(a080?a089:0);
  a080=(!a080);
  a080=(a080?a046:0);
  a089=(a089+a080);
  a076=casadi_fmin(a076,a089);
  a089=(a039<a076);
  a089=(!a089);
  a089=(a089?a076:0);
  a005=(a005?a089:0);
  a036=(a036+a005);
  a005=(a000<a036);
  a036=(a005?a036:0);
  a005=(!a005);
  a089=arg[0]? arg[0][19] : 0;
  a114=(a089*a114);
  a076=casadi_fabs(a007);
  a089=casadi_fmax(a089,a076);
  a114=(a114/a089);
  a089=arg[1]? arg[1][2] : 0;
  a076=arg[1]? arg[1][1] : 0;
  a080=(a007*a076);
  a080=(a089+a080);
  a080=casadi_fmin(a002,a080);
  a080=casadi_fmax(a004,a080);
  a080=(a114*a080);
  a120=(-a080);
  a076=(a007*a076);
  a089=(a089-a076);
  a089=casadi_fmin(a002,a089);
  a089=casadi_fmax(a004,a089);
  a114=(a114*a089);
  a089=arg[0]? arg[0][18] : 0;
  a076=arg[2]? arg[2][34] : 0;
  a076=(a089!=a076);
  a037=arg[1]? arg[1][0] : 0;
  a081=(a000<a069);
  a124=arg[2]? arg[2][33] : 0;
  a124=(a081?a124:0);
  a081=(!a081);
  a081=(a081?a089:0);
  a124=(a124+a081);
  a081=(a089-a124);
  a125=casadi_fabs(a081);
  a125=(a037*a125);
  a126=9.9999999999999995e-07;
  a127=casadi_fabs(a089);
  a127=(a126*a127);
  a128=casadi_fabs(a124);
  a128=(a126*a128);
  a127=(a127+a128);
  a125=casadi_fmax(a125,a127);
  a125=(a076?a125:0);
  a076=(!a076);
  a127=arg[2]? arg[2][35] : 0;
  a076=(a076?a127:0);
  a125=(a125+a076);
  a076=(a125<a081);
  a127=(a124+a125);
  a127=(a076?a127:0);
  a076=(!a076);
  a128=(-a125);
  a128=(a081<a128);
  a124=(a124-a125);
  a124=(a128?a124:0);
  a128=(!a128);
  a128=(a128?a089:0);
  a124=(a124+a128);
  a076=(a076?a124:0);
  a127=(a127+a076);
  a076=arg[1]? arg[1][26] : 0;
  a076=(a076*a011);
  a076=(a076-a007);
  a124=arg[1]? arg[1][27] : 0;
  a124=(a124*a017);
  a076=(a076+a124);
  a076=(a127*a076);
  a124=arg[0]? arg[0][66] : 0;
  a128=(a002-a124);
  a080=(a080*a128);
  a080=(-a080);
  a128=(a000<a069);
  a129=arg[2]? arg[2][82] : 0;
  a128=(a128?a129:0);
  a129=arg[0]? arg[0][58] : 0;
  a130=(a000<a069);
  a131=arg[2]? arg[2][79] : 0;
  a131=(a130?a131:0);
  a130=(!a130);
  a132=arg[1]? arg[1][19] : 0;
  a133=arg[0]? arg[0][23] : 0;
  a116=(a133*a116);
  a134=casadi_fabs(a011);
  a133=casadi_fmax(a133,a134);
  a116=(a116/a133);
  a133=arg[1]? arg[1][4] : 0;
  a134=arg[1]? arg[1][3] : 0;
  a135=(a011*a134);
  a135=(a133+a135);
  a135=casadi_fmin(a002,a135);
  a135=casadi_fmax(a004,a135);
  a135=(a116*a135);
  a135=(-a135);
  a134=(a011*a134);
  a133=(a133-a134);
  a133=casadi_fmin(a002,a133);
  a133=casadi_fmax(a004,a133);
  a116=(a116*a133);
  a133=arg[0]? arg[0][52] : 0;
  a133=(a004<a133);
  a134=(a000<a069);
  a136=arg[2]? arg[2][27] : 0;
  a136=(a134?a136:0);
  a134=(!a134);
  a137=arg[0]? arg[0][15] : 0;
  a134=(a134?a137:0);
  a136=(a136+a134);
  a134=arg[2]? arg[2][28] : 0;
  a134=(a137!=a134);
  a138=(a137-a136);
  a139=casadi_fabs(a138);
  a139=(a037*a139);
  a140=casadi_fabs(a137);
  a140=(a126*a140);
  a141=casadi_fabs(a136);
  a141=(a126*a141);
  a140=(a140+a141);
  a139=casadi_fmax(a139,a140);
  a139=(a134?a139:0);
  a134=(!a134);
  a140=arg[2]? arg[2][29] : 0;
  a134=(a134?a140:0);
  a139=(a139+a134);
  a134=(a139<a138);
  a140=(a136+a139);
  a140=(a134?a140:0);
  a134=(!a134);
  a141=(-a139);
  a141=(a138<a141);
  a142=(a136-a139);
  a142=(a141?a142:0);
  a141=(!a141);
  a141=(a141?a137:0);
  a142=(a142+a141);
  a134=(a134?a142:0);
  a140=(a140+a134);
  a134=(a136-a140);
  a134=(a029*a134);
  a134=(-a134);
  a133=(a133?a134:0);
  a134=(a000<a069);
  a142=arg[2]? arg[2][77] : 0;
  a134=(a134?a142:0);
  a133=(a133+a134);
  a134=(a000<a069);
  a142=arg[2]? arg[2][75] : 0;
  a142=(a134?a142:0);
  a134=(!a134);
  a134=(a134?a011:0);
  a142=(a142+a134);
  a134=arg[1]? arg[1][13] : 0;
  a141=(-a134);
  a014=(a015?a014:0);
  a015=(!a015);
  a143=arg[2]? arg[2][6] : 0;
  a015=(a015?a143:0);
  a014=(a014+a015);
  a015=(a014-a142);
  a134=casadi_fmin(a134,a015);
  a141=casadi_fmax(a141,a134);
  a142=(a142+a141);
  a141=(a142-a011);
  a134=arg[0]? arg[0][51] : 0;
  a134=(a141*a134);
  a134=(a133+a134);
  a015=(a029*a140);
  a134=(a134-a015);
  a116=casadi_fmin(a116,a134);
  a135=casadi_fmax(a135,a116);
  a116=(a135+a029);
  a132=(a132*a116);
  a132=(a026+a132);
  a015=arg[1]? arg[1][20] : 0;
  a143=arg[0]? arg[0][27] : 0;
  a079=(a143*a079);
  a144=casadi_fabs(a017);
  a143=casadi_fmax(a143,a144);
  a079=(a079/a143);
  a143=arg[1]? arg[1][6] : 0;
  a144=arg[1]? arg[1][5] : 0;
  a145=(a017*a144);
  a145=(a143+a145);
  a145=casadi_fmin(a002,a145);
  a145=casadi_fmax(a004,a145);
  a145=(a079*a145);
  a145=(-a145);
  a144=(a017*a144);
  a143=(a143-a144);
  a143=casadi_fmin(a002,a143);
  a143=casadi_fmax(a004,a143);
  a079=(a079*a143);
  a143=arg[0]? arg[0][54] : 0;
  a143=(a004<a143);
  a136=(a136-a140);
  a136=(a032*a136);
  a136=(-a136);
  a143=(a143?a136:0);
  a136=(a000<a069);
  a144=arg[2]? arg[2][78] : 0;
  a136=(a136?a144:0);
  a143=(a143+a136);
  a136=(a000<a069);
  a144=arg[2]? arg[2][76] : 0;
  a144=(a136?a144:0);
  a136=(!a136);
  a136=(a136?a017:0);
  a144=(a144+a136);
  a136=arg[1]? arg[1][14] : 0;
  a146=(-a136);
  a020=(a021?a020:0);
  a021=(!a021);
  a147=arg[2]? arg[2][8] : 0;
  a021=(a021?a147:0);
  a020=(a020+a021);
  a021=(a020-a144);
  a136=casadi_fmin(a136,a021);
  a146=casadi_fmax(a146,a136);
  a144=(a144+a146);
  a146=(a144-a017);
  a136=arg[0]? arg[0][53] : 0;
  a136=(a146*a136);
  a136=(a143+a136);
  a021=(a032*a140);
  a136=(a136-a021);
  a079=casadi_fmin(a079,a136);
  a145=casadi_fmax(a145,a079);
  a079=(a145+a032);
  a015=(a015*a079);
  a132=(a132+a015);
  a130=(a130?a132:0);
  a131=(a131+a130);
  a130=arg[1]? arg[1][21] : 0;
  a015=(-a130);
  a023=(a024?a023:0);
  a024=(!a024);
  a021=arg[2]? arg[2][4] : 0;
  a024=(a024?a021:0);
  a023=(a023+a024);
  a024=(a023-a131);
  a130=casadi_fmin(a130,a024);
  a015=casadi_fmax(a015,a130);
  a131=(a131+a015);
  a129=(a129*a131);
  a129=(a128+a129);
  a015=(a000<a069);
  a130=arg[2]? arg[2][80] : 0;
  a130=(a015?a130:0);
  a015=(!a015);
  a015=(a015?a132:0);
  a130=(a130+a015);
  a015=(a000<a069);
  a024=arg[2]? arg[2][81] : 0;
  a021=(a015?a024:0);
  a147=arg[1]? arg[1][22] : 0;
  a148=(a131-a130);
  a147=(a147*a148);
  a021=(a021+a147);
  a147=arg[1]? arg[1][23] : 0;
  a147=(a147*a024);
  a147=(-a147);
  a015=(a015?a147:0);
  a021=(a021+a015);
  a015=(a021*a042);
  a130=(a130+a015);
  a015=arg[0]? arg[0][63] : 0;
  a147=(a130*a015);
  a147=(a147-a132);
  a015=(a002-a015);
  a015=(a131*a015);
  a147=(a147+a015);
  a015=arg[0]? arg[0][59] : 0;
  a015=(a147*a015);
  a129=(a129+a015);
  a015=arg[0]? arg[0][16] : 0;
  a132=arg[2]? arg[2][31] : 0;
  a132=(a015!=a132);
  a069=(a000<a069);
  a024=arg[2]? arg[2][30] : 0;
  a024=(a069?a024:0);
  a069=(!a069);
  a069=(a069?a015:0);
  a024=(a024+a069);
  a069=(a015-a024);
  a148=casadi_fabs(a069);
  a037=(a037*a148);
  a148=casadi_fabs(a015);
  a148=(a126*a148);
  a149=casadi_fabs(a024);
  a126=(a126*a149);
  a148=(a148+a126);
  a037=casadi_fmax(a037,a148);
  a037=(a132?a037:0);
  a132=(!a132);
  a148=arg[2]? arg[2][32] : 0;
  a132=(a132?a148:0);
  a037=(a037+a132);
  a132=(a037<a069);
  a148=(a024+a037);
  a148=(a132?a148:0);
  a132=(!a132);
  a126=(-a037);
  a126=(a069<a126);
  a024=(a024-a037);
  a024=(a126?a024:0);
  a126=(!a126);
  a126=(a126?a015:0);
  a024=(a024+a126);
  a132=(a132?a024:0);
  a148=(a148+a132);
  a132=arg[1]? arg[1][24] : 0;
  a132=(a132*a116);
  a116=arg[1]? arg[1][25] : 0;
  a116=(a116*a079);
  a132=(a132+a116);
  a132=(a148*a132);
  a129=(a129+a132);
  a124=(a002-a124);
  a124=(a114*a124);
  a124=casadi_fmin(a129,a124);
  a080=casadi_fmax(a080,a124);
  a076=(a076+a080);
  a114=casadi_fmin(a114,a076);
  a120=casadi_fmax(a120,a114);
  a114=casadi_fabs(a120);
  a076=arg[1]? arg[1][29] : 0;
  a114=(a114<=a076);
  a076=(a114?a002:0);
  a076=(a076<a002);
  a124=7001.;
  a124=(a076?a124:0);
  a076=(!a076);
  a076=(a076?a046:0);
  a124=(a124+a076);
  a076=casadi_fabs(a135);
  a132=arg[1]? arg[1][30] : 0;
  a076=(a076<=a132);
  a132=(a076?a002:0);
  a132=(a132<a002);
  a116=7002.;
  a116=(a132?a116:0);
  a132=(!a132);
  a132=(a132?a046:0);
  a116=(a116+a132);
  a124=casadi_fmin(a124,a116);
  a116=casadi_fabs(a145);
  a132=arg[1]? arg[1][31] : 0;
  a116=(a116<=a132);
  a132=(a116?a002:0);
  a132=(a132<a002);
  a079=7003.;
  a079=(a132?a079:0);
  a132=(!a132);
  a132=(a132?a046:0);
  a079=(a079+a132);
  a124=casadi_fmin(a124,a079);
  a039=(a039<a124);
  a039=(!a039);
  a039=(a039?a124:0);
  a005=(a005?a039:0);
  a036=(a036+a005);
  if (res[0]!=0) res[0][0]=a036;
  a005=(a000<a036);
  a039=arg[1]? arg[1][32] : 0;
  a124=(-a039);
  a124=(a005?a124:0);
  a005=(!a005);
  a005=(a005?a039:0);
  a124=(a124+a005);
  a003=(a003+a124);
  a003=casadi_fmax(a004,a003);
  a003=casadi_fmin(a002,a003);
  if (res[0]!=0) res[0][1]=a003;
  a124=(a000<a036);
  a124=(!a124);
  a124=(a124?a002:0);
  if (res[0]!=0) res[0][2]=a124;
  if (res[0]!=0) res[0][3]=a035;
  if (res[0]!=0) res[0][4]=a023;
  a059=casadi_fmin(a059,a044);
  a059=(a059-a042);
  a059=casadi_fmax(a004,a059);
  a059=(a025?a059:0);
  a025=(!a025);
  a025=(a025?a062:0);
  a059=(a059+a025);
  if (res[0]!=0) res[0][5]=a059;
  if (res[0]!=0) res[0][6]=a014;
  a051=casadi_fmin(a051,a044);
  a051=(a051-a042);
  a051=casadi_fmax(a004,a051);
  a051=(a016?a051:0);
  a016=(!a016);
  a016=(a016?a054:0);
  a051=(a051+a016);
  if (res[0]!=0) res[0][7]=a051;
  if (res[0]!=0) res[0][8]=a020;
  a057=casadi_fmin(a057,a044);
  a057=(a057-a042);
  a057=casadi_fmax(a004,a057);
  a057=(a022?a057:0);
  a022=(!a022);
  a022=(a022?a060:0);
  a057=(a057+a022);
  if (res[0]!=0) res[0][9]=a057;
  if (res[0]!=0) res[0][10]=a007;
  a041=casadi_fmin(a041,a044);
  a041=(a041-a042);
  a041=casadi_fmax(a004,a041);
  a041=(a008?a041:0);
  a008=(!a008);
  a008=(a008?a043:0);
  a041=(a041+a008);
  if (res[0]!=0) res[0][11]=a041;
  if (res[0]!=0) res[0][12]=a026;
  a061=casadi_fmin(a061,a044);
  a061=(a061-a042);
  a061=casadi_fmax(a004,a061);
  a061=(a028?a061:0);
  a028=(!a028);
  a028=(a028?a064:0);
  a061=(a061+a028);
  if (res[0]!=0) res[0][13]=a061;
  if (res[0]!=0) res[0][14]=a029;
  a063=casadi_fmin(a063,a044);
  a063=(a063-a042);
  a063=casadi_fmax(a004,a063);
  a063=(a031?a063:0);
  a031=(!a031);
  a031=(a031?a066:0);
  a063=(a063+a031);
  if (res[0]!=0) res[0][15]=a063;
  if (res[0]!=0) res[0][16]=a011;
  a040=casadi_fmin(a040,a044);
  a040=(a040-a042);
  a040=casadi_fmax(a004,a040);
  a040=(a012?a040:0);
  a012=(!a012);
  a012=(a012?a050:0);
  a040=(a040+a012);
  if (res[0]!=0) res[0][17]=a040;
  if (res[0]!=0) res[0][18]=a032;
  a065=casadi_fmin(a065,a044);
  a065=(a065-a042);
  a065=casadi_fmax(a004,a065);
  a065=(a034?a065:0);
  a034=(!a034);
  a034=(a034?a068:0);
  a065=(a065+a034);
  if (res[0]!=0) res[0][19]=a065;
  if (res[0]!=0) res[0][20]=a017;
  a053=casadi_fmin(a053,a044);
  a053=(a053-a042);
  a053=casadi_fmax(a004,a053);
  a053=(a018?a053:0);
  a018=(!a018);
  a018=(a018?a056:0);
  a053=(a053+a018);
  if (res[0]!=0) res[0][21]=a053;
  a047=casadi_fmin(a047,a044);
  a047=(a047-a042);
  a047=casadi_fmax(a004,a047);
  a047=(a009?a047:0);
  a009=(!a009);
  a009=(a009?a048:0);
  a047=(a047+a009);
  if (res[0]!=0) res[0][22]=a047;
  a049=casadi_fmin(a049,a044);
  a049=(a049-a042);
  a049=casadi_fmax(a004,a049);
  a049=(a013?a049:0);
  a013=(!a013);
  a013=(a013?a052:0);
  a049=(a049+a013);
  if (res[0]!=0) res[0][23]=a049;
  a055=casadi_fmin(a055,a044);
  a055=(a055-a042);
  a055=casadi_fmax(a004,a055);
  a055=(a019?a055:0);
  a019=(!a019);
  a019=(a019?a058:0);
  a055=(a055+a019);
  if (res[0]!=0) res[0][24]=a055;
  if (res[0]!=0) res[0][25]=a038;
  a001=(a000<a001);
  a006=(a006?a010:0);
  a001=(a001?a006:0);
  if (res[0]!=0) res[0][26]=a001;
  if (res[0]!=0) res[0][27]=a140;
  if (res[0]!=0) res[0][28]=a137;
  a138=casadi_fabs(a138);
  a138=(a139<a138);
  a138=(a138?a139:0);
  if (res[0]!=0) res[0][29]=a138;
  if (res[0]!=0) res[0][30]=a148;
  if (res[0]!=0) res[0][31]=a015;
  a069=casadi_fabs(a069);
  a069=(a037<a069);
  a069=(a069?a037:0);
  if (res[0]!=0) res[0][32]=a069;
  if (res[0]!=0) res[0][33]=a127;
  if (res[0]!=0) res[0][34]=a089;
  a081=casadi_fabs(a081);
  a081=(a125<a081);
  a081=(a081?a125:0);
  if (res[0]!=0) res[0][35]=a081;
  if (res[0]!=0) res[0][36]=a045;
  a074=casadi_fmin(a074,a044);
  a074=(a074-a042);
  a074=casadi_fmax(a004,a074);
  a074=(a072?a074:0);
  a072=(!a072);
  a072=(a072?a075:0);
  a074=(a074+a072);
  if (res[0]!=0) res[0][37]=a074;
  if (res[0]!=0) res[0][38]=a007;
  if (res[0]!=0) res[0][39]=a078;
  if (res[0]!=0) res[0][40]=a026;
  if (res[0]!=0) res[0][41]=a073;
  if (res[0]!=0) res[0][42]=a115;
  if (res[0]!=0) res[0][43]=a086;
  a091=casadi_fmin(a091,a044);
  a091=(a091-a042);
  a091=casadi_fmax(a004,a091);
  a091=(a030?a091:0);
  a030=(!a030);
  a030=(a030?a092:0);
  a091=(a091+a030);
  if (res[0]!=0) res[0][44]=a091;
  if (res[0]!=0) res[0][45]=a011;
  if (res[0]!=0) res[0][46]=a094;
  if (res[0]!=0) res[0][47]=a029;
  if (res[0]!=0) res[0][48]=a093;
  if (res[0]!=0) res[0][49]=a067;
  if (res[0]!=0) res[0][50]=a099;
  a103=casadi_fmin(a103,a044);
  a103=(a103-a042);
  a103=casadi_fmax(a004,a103);
  a103=(a102?a103:0);
  a102=(!a102);
  a102=(a102?a104:0);
  a103=(a103+a102);
  if (res[0]!=0) res[0][51]=a103;
  if (res[0]!=0) res[0][52]=a017;
  if (res[0]!=0) res[0][53]=a106;
  if (res[0]!=0) res[0][54]=a032;
  if (res[0]!=0) res[0][55]=a105;
  if (res[0]!=0) res[0][56]=a123;
  a123=arg[1]? arg[1][12] : 0;
  a071=(a071*a123);
  a033=(a033+a071);
  if (res[0]!=0) res[0][57]=a033;
  if (res[0]!=0) res[0][58]=a117;
  if (res[0]!=0) res[0][59]=a113;
  a082=(a082*a123);
  a118=(a118+a082);
  if (res[0]!=0) res[0][60]=a118;
  if (res[0]!=0) res[0][61]=a121;
  if (res[0]!=0) res[0][62]=a119;
  a027=(a027*a123);
  a090=(a090+a027);
  if (res[0]!=0) res[0][63]=a090;
  if (res[0]!=0) res[0][64]=a122;
  if (res[0]!=0) res[0][65]=a111;
  a083=(a083?a084:0);
  a085=(a085*a123);
  a083=(a083+a085);
  if (res[0]!=0) res[0][66]=a083;
  if (res[0]!=0) res[0][67]=a087;
  if (res[0]!=0) res[0][68]=a077;
  a096=(a096?a097:0);
  a098=(a098*a123);
  a096=(a096+a098);
  if (res[0]!=0) res[0][69]=a096;
  if (res[0]!=0) res[0][70]=a100;
  if (res[0]!=0) res[0][71]=a095;
  a108=(a108?a109:0);
  a110=(a110*a123);
  a108=(a108+a110);
  if (res[0]!=0) res[0][72]=a108;
  if (res[0]!=0) res[0][73]=a112;
  if (res[0]!=0) res[0][74]=a107;
  if (res[0]!=0) res[0][75]=a142;
  if (res[0]!=0) res[0][76]=a144;
  a134=(a135-a134);
  a144=arg[1]? arg[1][16] : 0;
  a134=(a134*a144);
  a133=(a133+a134);
  a134=arg[1]? arg[1][15] : 0;
  a141=(a141*a134);
  a133=(a133+a141);
  if (res[0]!=0) res[0][77]=a133;
  a136=(a145-a136);
  a133=arg[1]? arg[1][18] : 0;
  a136=(a136*a133);
  a143=(a143+a136);
  a136=arg[1]? arg[1][17] : 0;
  a146=(a146*a136);
  a143=(a143+a146);
  if (res[0]!=0) res[0][78]=a143;
  if (res[0]!=0) res[0][79]=a131;
  if (res[0]!=0) res[0][80]=a130;
  if (res[0]!=0) res[0][81]=a021;
  a129=(a129-a080);
  a129=(a147*a129);
  a004=(a004<a129);
  a129=(a004?a128:0);
  a004=(!a004);
  a080=arg[0]? arg[0][67] : 0;
  a021=(-a080);
  a130=arg[1]? arg[1][28] : 0;
  a147=(a147*a130);
  a128=(a128+a147);
  a080=casadi_fmin(a080,a128);
  a021=casadi_fmax(a021,a080);
  a004=(a004?a021:0);
  a129=(a129+a004);
  if (res[0]!=0) res[0][82]=a129;
  a129=(a000<a036);
  a004=(a129?a070:0);
  a129=(!a129);
  a120=(a114?a120:0);
  a114=(!a114);
  a114=(a114?a070:0);
  a120=(a120+a114);
  a129=(a129?a120:0);
  a004=(a004+a129);
  if (res[0]!=0) res[0][83]=a004;
  a129=(a000<a036);
  a120=(a129?a088:0);
  a129=(!a129);
  a135=(a076?a135:0);
  a076=(!a076);
  a076=(a076?a088:0);
  a135=(a135+a076);
  a129=(a129?a135:0);
  a120=(a120+a129);
  if (res[0]!=0) res[0][84]=a120;
  a000=(a000<a036);
  a036=(a000?a101:0);
  a000=(!a000);
  a145=(a116?a145:0);
  a116=(!a116);
  a116=(a116?a101:0);
  a145=(a145+a116);
  a000=(a000?a145:0);
  a036=(a036+a000);
  if (res[0]!=0) res[0][85]=a036;
  a000=-930.;
  a145=930.;
  a004=(a004*a003);
  a145=casadi_fmin(a145,a004);
  a000=casadi_fmax(a000,a145);
  if (res[1]!=0) res[1][0]=a000;
  a000=-3700.;
  a145=3700.;
  a120=(a120*a003);
  a120=casadi_fmin(a145,a120);
  a120=casadi_fmax(a000,a120);
  if (res[1]!=0) res[1][1]=a120;
  a036=(a036*a003);
  a145=casadi_fmin(a145,a036);
  a000=casadi_fmax(a000,a145);
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


