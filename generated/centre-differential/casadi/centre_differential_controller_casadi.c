/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) centre_differential_controller_casadi_ ## ID
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
CASADI_SYMBOL_EXPORT void centre_differential_controller_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int centre_differential_controller_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int centre_differential_controller_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {79, 1, 1};
static const casadi_int casadi_s1[3] = {34, 1, 1};
static const casadi_int casadi_s2[3] = {91, 1, 1};
static const casadi_int casadi_s3[3] = {10, 1, 1};
static const casadi_int casadi_s4[3] = {3, 1, 1};

static const casadi_real casadi_zeros[79] = 
  {0.};

/* controller_prepare:(parameters[79])->(derived[34]) */
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
  /* #5: @2 = @0[22] */
  w2 = wr0[22];
  /* #6: @3 = (1./@2) */
  w3 = (1./ w2 );
  /* #7: output[0][1] = @3 */
  if (res[0]) res[0][1] = w3;
  /* #8: @3 = 1 */
  w3 = 1.;
  /* #9: @4 = @0[21] */
  w4 = wr0[21];
  /* #10: @4 = (@4/@2) */
  w4 /= w2;
  /* #11: @3 = (@3+@4) */
  w3 += w4;
  /* #12: output[0][2] = @3 */
  if (res[0]) res[0][2] = w3;
  /* #13: @3 = @0[26] */
  w3 = wr0[26];
  /* #14: @4 = (1./@3) */
  w4 = (1./ w3 );
  /* #15: output[0][3] = @4 */
  if (res[0]) res[0][3] = w4;
  /* #16: @4 = 1 */
  w4 = 1.;
  /* #17: @2 = @0[25] */
  w2 = wr0[25];
  /* #18: @2 = (@2/@3) */
  w2 /= w3;
  /* #19: @4 = (@4+@2) */
  w4 += w2;
  /* #20: output[0][4] = @4 */
  if (res[0]) res[0][4] = w4;
  /* #21: @4 = @0[30] */
  w4 = wr0[30];
  /* #22: @2 = (1./@4) */
  w2 = (1./ w4 );
  /* #23: output[0][5] = @2 */
  if (res[0]) res[0][5] = w2;
  /* #24: @2 = 1 */
  w2 = 1.;
  /* #25: @3 = @0[29] */
  w3 = wr0[29];
  /* #26: @3 = (@3/@4) */
  w3 /= w4;
  /* #27: @2 = (@2+@3) */
  w2 += w3;
  /* #28: output[0][6] = @2 */
  if (res[0]) res[0][6] = w2;
  /* #29: @2 = @0[32] */
  w2 = wr0[32];
  /* #30: @2 = (@2*@1) */
  w2 *= w1;
  /* #31: output[0][7] = @2 */
  if (res[0]) res[0][7] = w2;
  /* #32: @2 = @0[33] */
  w2 = wr0[33];
  /* #33: @3 = (@1/@2) */
  w3  = (w1/w2);
  /* #34: output[0][8] = @3 */
  if (res[0]) res[0][8] = w3;
  /* #35: @3 = @0[37] */
  w3 = wr0[37];
  /* #36: @3 = (@1/@3) */
  w3  = (w1/w3);
  /* #37: output[0][9] = @3 */
  if (res[0]) res[0][9] = w3;
  /* #38: @3 = @0[40] */
  w3 = wr0[40];
  /* #39: @3 = (@1/@3) */
  w3  = (w1/w3);
  /* #40: output[0][10] = @3 */
  if (res[0]) res[0][10] = w3;
  /* #41: @3 = @0[43] */
  w3 = wr0[43];
  /* #42: @4 = (@3*@1) */
  w4  = (w3*w1);
  /* #43: output[0][11] = @4 */
  if (res[0]) res[0][11] = w4;
  /* #44: @4 = 6.2832 */
  w4 = 6.2831999999999999e+00;
  /* #45: @4 = (@4*@3) */
  w4 *= w3;
  /* #46: @4 = (@4*@1) */
  w4 *= w1;
  /* #47: output[0][12] = @4 */
  if (res[0]) res[0][12] = w4;
  /* #48: @4 = @0[50] */
  w4 = wr0[50];
  /* #49: @4 = (@4*@1) */
  w4 *= w1;
  /* #50: output[0][13] = @4 */
  if (res[0]) res[0][13] = w4;
  /* #51: @4 = @0[52] */
  w4 = wr0[52];
  /* #52: @3 = (@4*@1) */
  w3  = (w4*w1);
  /* #53: output[0][14] = @3 */
  if (res[0]) res[0][14] = w3;
  /* #54: @4 = (@4*@1) */
  w4 *= w1;
  /* #55: @3 = @0[51] */
  w3 = wr0[51];
  /* #56: @4 = (@4/@3) */
  w4 /= w3;
  /* #57: output[0][15] = @4 */
  if (res[0]) res[0][15] = w4;
  /* #58: @4 = @0[53] */
  w4 = wr0[53];
  /* #59: @4 = (@4/@2) */
  w4 /= w2;
  /* #60: output[0][16] = @4 */
  if (res[0]) res[0][16] = w4;
  /* #61: @4 = @0[57] */
  w4 = wr0[57];
  /* #62: @4 = (@4*@1) */
  w4 *= w1;
  /* #63: output[0][17] = @4 */
  if (res[0]) res[0][17] = w4;
  /* #64: @4 = @0[58] */
  w4 = wr0[58];
  /* #65: @4 = (@4*@1) */
  w4 *= w1;
  /* #66: @3 = @0[54] */
  w3 = wr0[54];
  /* #67: @4 = (@4/@3) */
  w4 /= w3;
  /* #68: output[0][18] = @4 */
  if (res[0]) res[0][18] = w4;
  /* #69: @4 = @0[59] */
  w4 = wr0[59];
  /* #70: @4 = (@4*@1) */
  w4 *= w1;
  /* #71: @4 = (@4/@3) */
  w4 /= w3;
  /* #72: output[0][19] = @4 */
  if (res[0]) res[0][19] = w4;
  /* #73: @4 = @0[61] */
  w4 = wr0[61];
  /* #74: @4 = (@4/@2) */
  w4 /= w2;
  /* #75: output[0][20] = @4 */
  if (res[0]) res[0][20] = w4;
  /* #76: @4 = @0[65] */
  w4 = wr0[65];
  /* #77: @4 = (@4*@1) */
  w4 *= w1;
  /* #78: output[0][21] = @4 */
  if (res[0]) res[0][21] = w4;
  /* #79: @4 = @0[66] */
  w4 = wr0[66];
  /* #80: @4 = (@4*@1) */
  w4 *= w1;
  /* #81: @2 = @0[62] */
  w2 = wr0[62];
  /* #82: @4 = (@4/@2) */
  w4 /= w2;
  /* #83: output[0][22] = @4 */
  if (res[0]) res[0][22] = w4;
  /* #84: @4 = @0[67] */
  w4 = wr0[67];
  /* #85: @4 = (@4*@1) */
  w4 *= w1;
  /* #86: @4 = (@4/@2) */
  w4 /= w2;
  /* #87: output[0][23] = @4 */
  if (res[0]) res[0][23] = w4;
  /* #88: @4 = @0[69] */
  w4 = wr0[69];
  /* #89: @2 = @0[70] */
  w2 = wr0[70];
  /* #90: @3 = (@4+@2) */
  w3  = (w4+w2);
  /* #91: @5 = @0[71] */
  w5 = wr0[71];
  /* #92: @6 = (@2*@5) */
  w6  = (w2*w5);
  /* #93: @3 = (@3/@6) */
  w3 /= w6;
  /* #94: output[0][24] = @3 */
  if (res[0]) res[0][24] = w3;
  /* #95: @2 = (@4/@2) */
  w2  = (w4/w2);
  /* #96: @2 = (-@2) */
  w2 = (- w2 );
  /* #97: output[0][25] = @2 */
  if (res[0]) res[0][25] = w2;
  /* #98: @2 = @0[72] */
  w2 = wr0[72];
  /* #99: @2 = (@2*@1) */
  w2 *= w1;
  /* #100: output[0][26] = @2 */
  if (res[0]) res[0][26] = w2;
  /* #101: @2 = @0[75] */
  w2 = wr0[75];
  /* #102: @3 = (@4+@2) */
  w3  = (w4+w2);
  /* #103: @5 = (@2*@5) */
  w5  = (w2*w5);
  /* #104: @3 = (@3/@5) */
  w3 /= w5;
  /* #105: output[0][27] = @3 */
  if (res[0]) res[0][27] = w3;
  /* #106: @4 = (@4/@2) */
  w4 /= w2;
  /* #107: @4 = (-@4) */
  w4 = (- w4 );
  /* #108: output[0][28] = @4 */
  if (res[0]) res[0][28] = w4;
  /* #109: @4 = @0[76] */
  w4 = wr0[76];
  /* #110: @4 = (@4*@1) */
  w4 *= w1;
  /* #111: output[0][29] = @4 */
  if (res[0]) res[0][29] = w4;
  /* #112: @4 = 1.01 */
  w4 = 1.0100000000000000e+00;
  /* #113: @2 = 930 */
  w2 = 930.;
  /* #114: @3 = @0[23] */
  w3 = wr0[23];
  /* #115: @2 = fmin(@2,@3) */
  w2  = casadi_fmin(w2,w3);
  /* #116: @4 = (@4*@2) */
  w4 *= w2;
  /* #117: output[0][30] = @4 */
  if (res[0]) res[0][30] = w4;
  /* #118: @4 = 1.01 */
  w4 = 1.0100000000000000e+00;
  /* #119: @2 = 1200 */
  w2 = 1200.;
  /* #120: @3 = @0[27] */
  w3 = wr0[27];
  /* #121: @2 = fmin(@2,@3) */
  w2  = casadi_fmin(w2,w3);
  /* #122: @4 = (@4*@2) */
  w4 *= w2;
  /* #123: output[0][31] = @4 */
  if (res[0]) res[0][31] = w4;
  /* #124: @4 = 1.01 */
  w4 = 1.0100000000000000e+00;
  /* #125: @2 = 1200 */
  w2 = 1200.;
  /* #126: @3 = @0[31] */
  w3 = wr0[31];
  /* #127: @2 = fmin(@2,@3) */
  w2  = casadi_fmin(w2,w3);
  /* #128: @4 = (@4*@2) */
  w4 *= w2;
  /* #129: output[0][32] = @4 */
  if (res[0]) res[0][32] = w4;
  /* #130: @4 = @0[1] */
  w4 = wr0[1];
  /* #131: @1 = (@1/@4) */
  w1 /= w4;
  /* #132: output[0][33] = @1 */
  if (res[0]) res[0][33] = w1;
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

/* controller_step:(parameters[79],derived[34],states[91],inputs[10])->(next_states[91],outputs[3]) */
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
  casadi_real a144, a145, a146, a147, a148, a149, a150, a151, a152, a153, a154, a155;
  casadi_real a156;
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
  a010=arg[3]? arg[3][2] : 0;
  a011=casadi_fabs(a010);
  a012=arg[0]? arg[0][5] : 0;
  a011=(a011<=a012);
  a012=(a011?a002:0);
  a013=casadi_fmin(a009,a012);
  a008=(a008?a002:0);
  a013=casadi_fmin(a013,a008);
  a014=arg[3]? arg[3][6] : 0;
  a015=casadi_fabs(a014);
  a016=arg[0]? arg[0][9] : 0;
  a015=(a015<=a016);
  a014=(a015?a014:0);
  a016=(!a015);
  a017=arg[2]? arg[2][16] : 0;
  a016=(a016?a017:0);
  a014=(a014+a016);
  a016=casadi_fabs(a014);
  a017=arg[0]? arg[0][13] : 0;
  a016=(a016<=a017);
  a016=(a016?a002:0);
  a013=casadi_fmin(a013,a016);
  a015=(a015?a002:0);
  a013=casadi_fmin(a013,a015);
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
  a013=casadi_fmin(a013,a019);
  a018=(a018?a002:0);
  a013=casadi_fmin(a013,a018);
  a020=arg[3]? arg[3][4] : 0;
  a021=casadi_fabs(a020);
  a022=arg[0]? arg[0][7] : 0;
  a021=(a021<=a022);
  a022=(a021?a002:0);
  a013=casadi_fmin(a013,a022);
  a023=arg[3]? arg[3][0] : 0;
  a024=casadi_fabs(a023);
  a025=arg[0]? arg[0][3] : 0;
  a024=(a024<=a025);
  a025=(a024?a002:0);
  a013=casadi_fmin(a013,a025);
  a026=arg[3]? arg[3][5] : 0;
  a027=casadi_fabs(a026);
  a028=arg[0]? arg[0][8] : 0;
  a027=(a027<=a028);
  a028=(a027?a002:0);
  a013=casadi_fmin(a013,a028);
  a029=arg[3]? arg[3][1] : 0;
  a030=casadi_fabs(a029);
  a031=arg[0]? arg[0][4] : 0;
  a030=(a030<=a031);
  a031=(a030?a002:0);
  a013=casadi_fmin(a013,a031);
  a032=arg[3]? arg[3][7] : 0;
  a033=casadi_fabs(a032);
  a034=arg[0]? arg[0][10] : 0;
  a033=(a033<=a034);
  a034=(a033?a002:0);
  a013=casadi_fmin(a013,a034);
  a035=arg[2]? arg[2][3] : 0;
  a036=(a002-a035);
  a013=(a013*a036);
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
  a013=(a013*a036);
  a036=(-a013);
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
  a040=arg[2]? arg[2][9] : 0;
  a050=(a040+a042);
  a051=(a000*a042);
  a051=(a044+a051);
  a051=(a050<=a051);
  a051=(!a051);
  a051=(a051?a002:0);
  a049=(a049?a051:0);
  a049=(a004<a049);
  a051=3.;
  a051=(a049?a051:0);
  a049=(!a049);
  a049=(a049?a046:0);
  a051=(a051+a049);
  a045=casadi_fmin(a045,a051);
  a015=(a000<a015);
  a051=(!a015);
  a049=arg[2]? arg[2][17] : 0;
  a052=(a049+a042);
  a053=(a000*a042);
  a053=(a044+a053);
  a053=(a052<=a053);
  a053=(!a053);
  a053=(a053?a002:0);
  a051=(a051?a053:0);
  a051=(a004<a051);
  a053=7.;
  a053=(a051?a053:0);
  a051=(!a051);
  a051=(a051?a046:0);
  a053=(a053+a051);
  a045=casadi_fmin(a045,a053);
  a016=(a000<a016);
  a053=(!a016);
  a051=arg[2]? arg[2][23] : 0;
  a054=(a051+a042);
  a055=(a000*a042);
  a055=(a044+a055);
  a055=(a054<=a055);
  a055=(!a055);
  a055=(a055?a002:0);
  a053=(a053?a055:0);
  a053=(a004<a053);
  a055=4007.;
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
  a057=arg[2]? arg[2][13] : 0;
  a060=(a057+a042);
  a061=(a000*a042);
  a061=(a044+a061);
  a061=(a060<=a061);
  a061=(!a061);
  a061=(a061?a002:0);
  a059=(a059?a061:0);
  a059=(a004<a059);
  a061=5.;
  a061=(a059?a061:0);
  a059=(!a059);
  a059=(a059?a046:0);
  a061=(a061+a059);
  a045=casadi_fmin(a045,a061);
  a028=(a000<a028);
  a061=(!a028);
  a059=arg[2]? arg[2][15] : 0;
  a062=(a059+a042);
  a063=(a000*a042);
  a063=(a044+a063);
  a063=(a062<=a063);
  a063=(!a063);
  a063=(a063?a002:0);
  a061=(a061?a063:0);
  a061=(a004<a061);
  a063=6.;
  a063=(a061?a063:0);
  a061=(!a061);
  a061=(a061?a046:0);
  a063=(a063+a061);
  a045=casadi_fmin(a045,a063);
  a025=(a000<a025);
  a063=(!a025);
  a061=arg[2]? arg[2][5] : 0;
  a064=(a061+a042);
  a065=(a000*a042);
  a065=(a044+a065);
  a065=(a064<=a065);
  a065=(!a065);
  a065=(a065?a002:0);
  a063=(a063?a065:0);
  a063=(a004<a063);
  a065=(a063?a002:0);
  a063=(!a063);
  a063=(a063?a046:0);
  a065=(a065+a063);
  a045=casadi_fmin(a045,a065);
  a034=(a000<a034);
  a065=(!a034);
  a063=arg[2]? arg[2][19] : 0;
  a066=(a063+a042);
  a067=(a000*a042);
  a067=(a044+a067);
  a067=(a066<=a067);
  a067=(!a067);
  a067=(a067?a002:0);
  a065=(a065?a067:0);
  a065=(a004<a065);
  a067=8.;
  a067=(a065?a067:0);
  a065=(!a065);
  a065=(a065?a046:0);
  a067=(a067+a065);
  a045=casadi_fmin(a045,a067);
  a031=(a000<a031);
  a067=(!a031);
  a065=arg[2]? arg[2][7] : 0;
  a068=(a065+a042);
  a069=(a000*a042);
  a069=(a044+a069);
  a069=(a068<=a069);
  a069=(!a069);
  a069=(a069?a002:0);
  a067=(a067?a069:0);
  a067=(a004<a067);
  a069=2.;
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
  a067=arg[2]? arg[2][39] : 0;
  a067=(a045?a067:0);
  a045=(!a045);
  a045=(a045?a007:0);
  a067=(a067+a045);
  a045=arg[1]? arg[1][8] : 0;
  a070=arg[2]? arg[2][88] : 0;
  a071=(a070*a003);
  a020=(a021?a020:0);
  a021=(!a021);
  a072=arg[2]? arg[2][12] : 0;
  a021=(a021?a072:0);
  a020=(a020+a021);
  a021=(a071-a020);
  a045=(a045*a021);
  a045=(a067+a045);
  a021=arg[1]? arg[1][7] : 0;
  a067=(a007-a067);
  a067=(a021*a067);
  a045=(a045+a067);
  a067=(a045-a007);
  a067=casadi_fabs(a067);
  a072=arg[0]? arg[0][34] : 0;
  a072=(a067<=a072);
  a072=(a072?a002:0);
  a072=(a000<a072);
  a073=(!a072);
  a074=arg[2]? arg[2][40] : 0;
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
  a073=arg[0]? arg[0][35] : 0;
  a077=(a067-a073);
  a078=arg[2]? arg[2][41] : 0;
  a078=(a007==a078);
  a079=(a000<a069);
  a080=arg[2]? arg[2][42] : 0;
  a079=(a079?a080:0);
  a079=(a079+a042);
  a078=(a078?a079:0);
  a079=arg[0]? arg[0][36] : 0;
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
  a081=arg[2]? arg[2][71] : 0;
  a077=(a077?a081:0);
  a081=arg[1]? arg[1][11] : 0;
  a077=(a077-a081);
  a077=casadi_fmax(a004,a077);
  a082=arg[0]? arg[0][47] : 0;
  a083=(a000<a069);
  a084=arg[2]? arg[2][69] : 0;
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
  a089=arg[2]? arg[2][70] : 0;
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
  a089=arg[2]? arg[2][46] : 0;
  a089=(a086?a089:0);
  a086=(!a086);
  a086=(a086?a014:0);
  a089=(a089+a086);
  a086=arg[1]? arg[1][9] : 0;
  a088=arg[2]? arg[2][89] : 0;
  a082=(a088*a003);
  a026=(a027?a026:0);
  a027=(!a027);
  a090=arg[2]? arg[2][14] : 0;
  a027=(a027?a090:0);
  a026=(a026+a027);
  a027=(a082+a026);
  a086=(a086*a027);
  a086=(a089+a086);
  a089=(a014-a089);
  a089=(a021*a089);
  a086=(a086+a089);
  a089=(a086-a014);
  a089=casadi_fabs(a089);
  a027=arg[0]? arg[0][38] : 0;
  a027=(a089<=a027);
  a027=(a027?a002:0);
  a027=(a000<a027);
  a090=(!a027);
  a091=arg[2]? arg[2][47] : 0;
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
  a093=arg[0]? arg[0][39] : 0;
  a090=(a089-a093);
  a094=arg[2]? arg[2][48] : 0;
  a094=(a014==a094);
  a095=(a000<a069);
  a096=arg[2]? arg[2][49] : 0;
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
  a090=arg[2]? arg[2][74] : 0;
  a095=(a095?a090:0);
  a095=(a095-a081);
  a095=casadi_fmax(a004,a095);
  a090=arg[0]? arg[0][48] : 0;
  a096=(a000<a069);
  a097=arg[2]? arg[2][72] : 0;
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
  a102=arg[2]? arg[2][73] : 0;
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
  a102=arg[2]? arg[2][53] : 0;
  a102=(a099?a102:0);
  a099=(!a099);
  a099=(a099?a017:0);
  a102=(a102+a099);
  a099=arg[1]? arg[1][10] : 0;
  a101=arg[2]? arg[2][90] : 0;
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
  a021=(a021*a102);
  a099=(a099+a021);
  a021=(a099-a017);
  a021=casadi_fabs(a021);
  a102=arg[0]? arg[0][41] : 0;
  a102=(a021<=a102);
  a102=(a102?a002:0);
  a102=(a000<a102);
  a033=(!a102);
  a103=arg[2]? arg[2][54] : 0;
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
  a105=arg[0]? arg[0][42] : 0;
  a033=(a021-a105);
  a106=arg[2]? arg[2][55] : 0;
  a106=(a017==a106);
  a107=(a000<a069);
  a108=arg[2]? arg[2][56] : 0;
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
  a033=arg[2]? arg[2][77] : 0;
  a107=(a107?a033:0);
  a107=(a107-a081);
  a107=casadi_fmax(a004,a107);
  a033=arg[0]? arg[0][49] : 0;
  a108=(a000<a069);
  a109=arg[2]? arg[2][75] : 0;
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
  a114=arg[2]? arg[2][76] : 0;
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
  a073=arg[2]? arg[2][43] : 0;
  a073=(a020==a073);
  a111=(a000<a069);
  a114=arg[2]? arg[2][44] : 0;
  a111=(a111?a114:0);
  a111=(a111+a042);
  a073=(a073?a111:0);
  a111=(a073-a079);
  a067=casadi_fmin(a067,a111);
  a111=-5.0000000000000003e-02;
  a114=arg[0]? arg[0][23] : 0;
  a113=(a111*a114);
  a033=(a004<a073);
  a115=arg[2]? arg[2][45] : 0;
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
  a067=arg[2]? arg[2][62] : 0;
  a113=(a113?a067:0);
  a113=(a113-a081);
  a113=casadi_fmax(a004,a113);
  a067=arg[0]? arg[0][44] : 0;
  a071=(a000<a069);
  a033=arg[2]? arg[2][60] : 0;
  a033=(a071?a033:0);
  a071=(!a071);
  a071=(a071?a020:0);
  a033=(a033+a071);
  a071=(a020-a033);
  a116=(a067<a071);
  a117=(a116?a002:0);
  a116=(!a116);
  a067=(-a067);
  a067=(a071<a067);
  a118=(a067?a037:0);
  a067=(!a067);
  a119=arg[2]? arg[2][61] : 0;
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
  a093=arg[2]? arg[2][50] : 0;
  a093=(a026==a093);
  a116=(a000<a069);
  a119=arg[2]? arg[2][51] : 0;
  a116=(a116?a119:0);
  a116=(a116+a042);
  a093=(a093?a116:0);
  a116=(a093-a079);
  a089=casadi_fmin(a089,a116);
  a116=arg[0]? arg[0][27] : 0;
  a119=(a111*a116);
  a118=(a004<a093);
  a067=arg[2]? arg[2][52] : 0;
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
  a089=arg[2]? arg[2][65] : 0;
  a119=(a119?a089:0);
  a119=(a119-a081);
  a119=casadi_fmax(a004,a119);
  a089=arg[0]? arg[0][45] : 0;
  a082=(a000<a069);
  a118=arg[2]? arg[2][63] : 0;
  a118=(a082?a118:0);
  a082=(!a082);
  a082=(a082?a026:0);
  a118=(a118+a082);
  a082=(a026-a118);
  a120=(a089<a082);
  a121=(a120?a002:0);
  a120=(!a120);
  a089=(-a089);
  a089=(a082<a089);
  a122=(a089?a037:0);
  a089=(!a089);
  a123=arg[2]? arg[2][64] : 0;
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
  a021=(a021-a105);
  a105=arg[2]? arg[2][57] : 0;
  a105=(a032==a105);
  a120=(a000<a069);
  a123=arg[2]? arg[2][58] : 0;
  a120=(a120?a123:0);
  a120=(a120+a042);
  a105=(a105?a120:0);
  a079=(a105-a079);
  a021=casadi_fmin(a021,a079);
  a079=arg[0]? arg[0][31] : 0;
  a111=(a111*a079);
  a120=(a004<a105);
  a123=arg[2]? arg[2][59] : 0;
  a123=(a120?a123:0);
  a120=(!a120);
  a120=(a120?a090:0);
  a123=(a123+a120);
  a090=(a090-a123);
  a090=casadi_fabs(a090);
  a111=(a111+a090);
  a021=casadi_fmin(a021,a111);
  a021=(a004<a021);
  a111=3008.;
  a111=(a021?a111:0);
  a021=(!a021);
  a021=(a021?a046:0);
  a111=(a111+a021);
  a076=casadi_fmin(a076,a111);
  a111=(a000<a069);
  a021=arg[2]? arg[2][68] : 0;
  a111=(a111?a021:0);
  a111=(a111-a081);
  a111=casadi_fmax(a004,a111);
  a081=arg[0]? arg[0][46] : 0;
  a021=(a000<a069);
  a090=arg[2]? arg[2][66] : 0;
  a090=(a021?a090:0);
  a021=(!a021);
  a021=(a021?a032:0);
  a090=(a090+a021);
  a021=(a032-a090);
  a120=(a081<a021);
  a122=(a120?a002:0);
  a120=(!a120);
  a081=(-a081);
  a081=(a021<a081);
  a037=(a081?a037:0);
  a081=(!a081);
  a089=arg[2]? arg[2][67] : 0;
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
  a089=arg[0]? arg[0][20] : 0;
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
  a080=(-a080);
  a076=(a007*a076);
  a089=(a089-a076);
  a089=casadi_fmin(a002,a089);
  a089=casadi_fmax(a004,a089);
  a114=(a114*a089);
  a089=arg[0]? arg[0][52] : 0;
  a089=(a004<a089);
  a076=(a000<a069);
  a120=arg[2]? arg[2][27] : 0;
  a120=(a076?a120:0);
  a076=(!a076);
  a037=arg[0]? arg[0][15] : 0;
  a076=(a076?a037:0);
  a120=(a120+a076);
  a076=arg[2]? arg[2][28] : 0;
  a076=(a037!=a076);
  a081=arg[1]? arg[1][0] : 0;
  a124=(a037-a120);
  a125=casadi_fabs(a124);
  a125=(a081*a125);
  a126=9.9999999999999995e-07;
  a127=casadi_fabs(a037);
  a127=(a126*a127);
  a128=casadi_fabs(a120);
  a128=(a126*a128);
  a127=(a127+a128);
  a125=casadi_fmax(a125,a127);
  a125=(a076?a125:0);
  a076=(!a076);
  a127=arg[2]? arg[2][29] : 0;
  a076=(a076?a127:0);
  a125=(a125+a076);
  a076=(a125<a124);
  a127=(a120+a125);
  a127=(a076?a127:0);
  a076=(!a076);
  a128=(-a125);
  a128=(a124<a128);
  a129=(a120-a125);
  a129=(a128?a129:0);
  a128=(!a128);
  a128=(a128?a037:0);
  a129=(a129+a128);
  a076=(a076?a129:0);
  a127=(a127+a076);
  a120=(a120-a127);
  a120=(a020*a120);
  a089=(a089?a120:0);
  a120=(a000<a069);
  a076=arg[2]? arg[2][79] : 0;
  a120=(a120?a076:0);
  a089=(a089+a120);
  a120=(a000<a069);
  a076=arg[2]? arg[2][78] : 0;
  a076=(a120?a076:0);
  a120=(!a120);
  a120=(a120?a007:0);
  a076=(a076+a120);
  a120=arg[1]? arg[1][13] : 0;
  a129=(-a120);
  a010=(a011?a010:0);
  a011=(!a011);
  a128=arg[2]? arg[2][8] : 0;
  a011=(a011?a128:0);
  a010=(a010+a011);
  a011=(a010-a076);
  a120=casadi_fmin(a120,a011);
  a129=casadi_fmax(a129,a120);
  a076=(a076+a129);
  a129=(a076-a007);
  a120=arg[0]? arg[0][51] : 0;
  a120=(a129*a120);
  a120=(a089+a120);
  a011=(a020*a127);
  a120=(a120+a011);
  a114=casadi_fmin(a114,a120);
  a080=casadi_fmax(a080,a114);
  a114=casadi_fabs(a080);
  a011=arg[1]? arg[1][30] : 0;
  a114=(a114<=a011);
  a011=(a114?a002:0);
  a011=(a011<a002);
  a128=7001.;
  a128=(a011?a128:0);
  a011=(!a011);
  a011=(a011?a046:0);
  a128=(a128+a011);
  a011=arg[0]? arg[0][24] : 0;
  a116=(a011*a116);
  a130=casadi_fabs(a014);
  a011=casadi_fmax(a011,a130);
  a116=(a116/a011);
  a011=arg[1]? arg[1][4] : 0;
  a130=arg[1]? arg[1][3] : 0;
  a131=(a014*a130);
  a131=(a011+a131);
  a131=casadi_fmin(a002,a131);
  a131=casadi_fmax(a004,a131);
  a131=(a116*a131);
  a132=(-a131);
  a130=(a014*a130);
  a011=(a011-a130);
  a011=casadi_fmin(a002,a011);
  a011=casadi_fmax(a004,a011);
  a116=(a116*a011);
  a011=arg[0]? arg[0][18] : 0;
  a130=arg[2]? arg[2][34] : 0;
  a130=(a011!=a130);
  a133=(a000<a069);
  a134=arg[2]? arg[2][33] : 0;
  a134=(a133?a134:0);
  a133=(!a133);
  a133=(a133?a011:0);
  a134=(a134+a133);
  a133=(a011-a134);
  a135=casadi_fabs(a133);
  a135=(a081*a135);
  a136=casadi_fabs(a011);
  a136=(a126*a136);
  a137=casadi_fabs(a134);
  a137=(a126*a137);
  a136=(a136+a137);
  a135=casadi_fmax(a135,a136);
  a135=(a130?a135:0);
  a130=(!a130);
  a136=arg[2]? arg[2][35] : 0;
  a130=(a130?a136:0);
  a135=(a135+a130);
  a130=(a135<a133);
  a136=(a134+a135);
  a136=(a130?a136:0);
  a130=(!a130);
  a137=(-a135);
  a137=(a133<a137);
  a134=(a134-a135);
  a134=(a137?a134:0);
  a137=(!a137);
  a137=(a137?a011:0);
  a134=(a134+a137);
  a130=(a130?a134:0);
  a136=(a136+a130);
  a130=arg[1]? arg[1][24] : 0;
  a130=(a007*a130);
  a130=(a130-a014);
  a134=arg[1]? arg[1][25] : 0;
  a134=(a134*a017);
  a130=(a130+a134);
  a130=(a136*a130);
  a134=arg[0]? arg[0][73] : 0;
  a137=(a002-a134);
  a131=(a131*a137);
  a131=(-a131);
  a137=(a000<a069);
  a138=arg[2]? arg[2][83] : 0;
  a137=(a137?a138:0);
  a138=arg[0]? arg[0][55] : 0;
  a139=(a000<a069);
  a140=arg[2]? arg[2][80] : 0;
  a140=(a139?a140:0);
  a139=(!a139);
  a141=(a080-a020);
  a142=arg[1]? arg[1][16] : 0;
  a142=(a141*a142);
  a142=(a026+a142);
  a139=(a139?a142:0);
  a140=(a140+a139);
  a139=arg[1]? arg[1][17] : 0;
  a143=(-a139);
  a023=(a024?a023:0);
  a024=(!a024);
  a144=arg[2]? arg[2][4] : 0;
  a024=(a024?a144:0);
  a023=(a023+a024);
  a024=(a023-a140);
  a139=casadi_fmin(a139,a024);
  a143=casadi_fmax(a143,a139);
  a140=(a140+a143);
  a138=(a138*a140);
  a138=(a137+a138);
  a143=(a000<a069);
  a139=arg[2]? arg[2][81] : 0;
  a139=(a143?a139:0);
  a143=(!a143);
  a143=(a143?a142:0);
  a139=(a139+a143);
  a143=(a000<a069);
  a024=arg[2]? arg[2][82] : 0;
  a144=(a143?a024:0);
  a145=arg[1]? arg[1][18] : 0;
  a146=(a140-a139);
  a145=(a145*a146);
  a144=(a144+a145);
  a145=arg[1]? arg[1][19] : 0;
  a145=(a145*a024);
  a145=(-a145);
  a143=(a143?a145:0);
  a144=(a144+a143);
  a143=(a144*a042);
  a139=(a139+a143);
  a143=arg[0]? arg[0][60] : 0;
  a145=(a139*a143);
  a145=(a145-a142);
  a143=(a002-a143);
  a143=(a140*a143);
  a145=(a145+a143);
  a143=arg[0]? arg[0][56] : 0;
  a143=(a145*a143);
  a138=(a138+a143);
  a143=(-a138);
  a134=(a002-a134);
  a134=(a116*a134);
  a143=casadi_fmin(a143,a134);
  a131=casadi_fmax(a131,a143);
  a130=(a130+a131);
  a116=casadi_fmin(a116,a130);
  a132=casadi_fmax(a132,a116);
  a116=casadi_fabs(a132);
  a130=arg[1]? arg[1][31] : 0;
  a116=(a116<=a130);
  a130=(a116?a002:0);
  a130=(a130<a002);
  a143=7002.;
  a143=(a130?a143:0);
  a130=(!a130);
  a130=(a130?a046:0);
  a143=(a143+a130);
  a128=casadi_fmin(a128,a143);
  a143=arg[0]? arg[0][28] : 0;
  a079=(a143*a079);
  a130=casadi_fabs(a017);
  a143=casadi_fmax(a143,a130);
  a079=(a079/a143);
  a143=arg[1]? arg[1][6] : 0;
  a130=arg[1]? arg[1][5] : 0;
  a134=(a017*a130);
  a134=(a143+a134);
  a134=casadi_fmin(a002,a134);
  a134=casadi_fmax(a004,a134);
  a134=(a079*a134);
  a142=(-a134);
  a130=(a017*a130);
  a143=(a143-a130);
  a143=casadi_fmin(a002,a143);
  a143=casadi_fmax(a004,a143);
  a079=(a079*a143);
  a143=arg[0]? arg[0][19] : 0;
  a130=arg[2]? arg[2][37] : 0;
  a130=(a143!=a130);
  a024=(a000<a069);
  a146=arg[2]? arg[2][36] : 0;
  a146=(a024?a146:0);
  a024=(!a024);
  a024=(a024?a143:0);
  a146=(a146+a024);
  a024=(a143-a146);
  a147=casadi_fabs(a024);
  a147=(a081*a147);
  a148=casadi_fabs(a143);
  a148=(a126*a148);
  a149=casadi_fabs(a146);
  a149=(a126*a149);
  a148=(a148+a149);
  a147=casadi_fmax(a147,a148);
  a147=(a130?a147:0);
  a130=(!a130);
  a148=arg[2]? arg[2][38] : 0;
  a130=(a130?a148:0);
  a147=(a147+a130);
  a130=(a147<a024);
  a148=(a146+a147);
  a148=(a130?a148:0);
  a130=(!a130);
  a149=(-a147);
  a149=(a024<a149);
  a146=(a146-a147);
  a146=(a149?a146:0);
  a149=(!a149);
  a149=(a149?a143:0);
  a146=(a146+a149);
  a130=(a130?a146:0);
  a148=(a148+a130);
  a130=arg[1]? arg[1][27] : 0;
  a130=(a007*a130);
  a130=(a130-a017);
  a146=arg[1]? arg[1][28] : 0;
  a146=(a014*a146);
  a130=(a130+a146);
  a130=(a148*a130);
  a146=arg[0]? arg[0][77] : 0;
  a149=(a002-a146);
  a134=(a134*a149);
  a134=(-a134);
  a149=(a000<a069);
  a150=arg[2]? arg[2][87] : 0;
  a149=(a149?a150:0);
  a150=arg[0]? arg[0][63] : 0;
  a151=(a000<a069);
  a152=arg[2]? arg[2][84] : 0;
  a152=(a151?a152:0);
  a151=(!a151);
  a153=arg[1]? arg[1][20] : 0;
  a141=(a141*a153);
  a141=(a032+a141);
  a151=(a151?a141:0);
  a152=(a152+a151);
  a151=arg[1]? arg[1][21] : 0;
  a153=(-a151);
  a029=(a030?a029:0);
  a030=(!a030);
  a154=arg[2]? arg[2][6] : 0;
  a030=(a030?a154:0);
  a029=(a029+a030);
  a030=(a029-a152);
  a151=casadi_fmin(a151,a030);
  a153=casadi_fmax(a153,a151);
  a152=(a152+a153);
  a150=(a150*a152);
  a150=(a149+a150);
  a153=(a000<a069);
  a151=arg[2]? arg[2][85] : 0;
  a151=(a153?a151:0);
  a153=(!a153);
  a153=(a153?a141:0);
  a151=(a151+a153);
  a153=(a000<a069);
  a030=arg[2]? arg[2][86] : 0;
  a154=(a153?a030:0);
  a155=arg[1]? arg[1][22] : 0;
  a156=(a152-a151);
  a155=(a155*a156);
  a154=(a154+a155);
  a155=arg[1]? arg[1][23] : 0;
  a155=(a155*a030);
  a155=(-a155);
  a153=(a153?a155:0);
  a154=(a154+a153);
  a153=(a154*a042);
  a151=(a151+a153);
  a153=arg[0]? arg[0][68] : 0;
  a155=(a151*a153);
  a155=(a155-a141);
  a153=(a002-a153);
  a153=(a152*a153);
  a155=(a155+a153);
  a153=arg[0]? arg[0][64] : 0;
  a153=(a155*a153);
  a150=(a150+a153);
  a153=(-a150);
  a146=(a002-a146);
  a146=(a079*a146);
  a153=casadi_fmin(a153,a146);
  a134=casadi_fmax(a134,a153);
  a130=(a130+a134);
  a079=casadi_fmin(a079,a130);
  a142=casadi_fmax(a142,a079);
  a079=casadi_fabs(a142);
  a130=arg[1]? arg[1][32] : 0;
  a079=(a079<=a130);
  a130=(a079?a002:0);
  a130=(a130<a002);
  a153=7003.;
  a153=(a130?a153:0);
  a130=(!a130);
  a130=(a130?a046:0);
  a153=(a153+a130);
  a128=casadi_fmin(a128,a153);
  a039=(a039<a128);
  a039=(!a039);
  a039=(a039?a128:0);
  a005=(a005?a039:0);
  a036=(a036+a005);
  if (res[0]!=0) res[0][0]=a036;
  a005=(a000<a036);
  a039=arg[1]? arg[1][33] : 0;
  a128=(-a039);
  a128=(a005?a128:0);
  a005=(!a005);
  a005=(a005?a039:0);
  a128=(a128+a005);
  a003=(a003+a128);
  a003=casadi_fmax(a004,a003);
  a003=casadi_fmin(a002,a003);
  if (res[0]!=0) res[0][1]=a003;
  a128=(a000<a036);
  a128=(!a128);
  a128=(a128?a002:0);
  if (res[0]!=0) res[0][2]=a128;
  if (res[0]!=0) res[0][3]=a035;
  if (res[0]!=0) res[0][4]=a023;
  a061=casadi_fmin(a061,a044);
  a061=(a061-a042);
  a061=casadi_fmax(a004,a061);
  a061=(a025?a061:0);
  a025=(!a025);
  a025=(a025?a064:0);
  a061=(a061+a025);
  if (res[0]!=0) res[0][5]=a061;
  if (res[0]!=0) res[0][6]=a029;
  a065=casadi_fmin(a065,a044);
  a065=(a065-a042);
  a065=casadi_fmax(a004,a065);
  a065=(a031?a065:0);
  a031=(!a031);
  a031=(a031?a068:0);
  a065=(a065+a031);
  if (res[0]!=0) res[0][7]=a065;
  if (res[0]!=0) res[0][8]=a010;
  a040=casadi_fmin(a040,a044);
  a040=(a040-a042);
  a040=casadi_fmax(a004,a040);
  a040=(a012?a040:0);
  a012=(!a012);
  a012=(a012?a050:0);
  a040=(a040+a012);
  if (res[0]!=0) res[0][9]=a040;
  if (res[0]!=0) res[0][10]=a007;
  a041=casadi_fmin(a041,a044);
  a041=(a041-a042);
  a041=casadi_fmax(a004,a041);
  a041=(a008?a041:0);
  a008=(!a008);
  a008=(a008?a043:0);
  a041=(a041+a008);
  if (res[0]!=0) res[0][11]=a041;
  if (res[0]!=0) res[0][12]=a020;
  a057=casadi_fmin(a057,a044);
  a057=(a057-a042);
  a057=casadi_fmax(a004,a057);
  a057=(a022?a057:0);
  a022=(!a022);
  a022=(a022?a060:0);
  a057=(a057+a022);
  if (res[0]!=0) res[0][13]=a057;
  if (res[0]!=0) res[0][14]=a026;
  a059=casadi_fmin(a059,a044);
  a059=(a059-a042);
  a059=casadi_fmax(a004,a059);
  a059=(a028?a059:0);
  a028=(!a028);
  a028=(a028?a062:0);
  a059=(a059+a028);
  if (res[0]!=0) res[0][15]=a059;
  if (res[0]!=0) res[0][16]=a014;
  a049=casadi_fmin(a049,a044);
  a049=(a049-a042);
  a049=casadi_fmax(a004,a049);
  a049=(a015?a049:0);
  a015=(!a015);
  a015=(a015?a052:0);
  a049=(a049+a015);
  if (res[0]!=0) res[0][17]=a049;
  if (res[0]!=0) res[0][18]=a032;
  a063=casadi_fmin(a063,a044);
  a063=(a063-a042);
  a063=casadi_fmax(a004,a063);
  a063=(a034?a063:0);
  a034=(!a034);
  a034=(a034?a066:0);
  a063=(a063+a034);
  if (res[0]!=0) res[0][19]=a063;
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
  a051=casadi_fmin(a051,a044);
  a051=(a051-a042);
  a051=casadi_fmax(a004,a051);
  a051=(a016?a051:0);
  a016=(!a016);
  a016=(a016?a054:0);
  a051=(a051+a016);
  if (res[0]!=0) res[0][23]=a051;
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
  a006=(a006?a013:0);
  a001=(a001?a006:0);
  if (res[0]!=0) res[0][26]=a001;
  if (res[0]!=0) res[0][27]=a127;
  if (res[0]!=0) res[0][28]=a037;
  a124=casadi_fabs(a124);
  a124=(a125<a124);
  a124=(a124?a125:0);
  if (res[0]!=0) res[0][29]=a124;
  a124=arg[0]? arg[0][16] : 0;
  a125=arg[2]? arg[2][31] : 0;
  a125=(a124!=a125);
  a069=(a000<a069);
  a037=arg[2]? arg[2][30] : 0;
  a037=(a069?a037:0);
  a069=(!a069);
  a069=(a069?a124:0);
  a037=(a037+a069);
  a069=(a124-a037);
  a127=casadi_fabs(a069);
  a081=(a081*a127);
  a127=casadi_fabs(a124);
  a127=(a126*a127);
  a001=casadi_fabs(a037);
  a126=(a126*a001);
  a127=(a127+a126);
  a081=casadi_fmax(a081,a127);
  a081=(a125?a081:0);
  a125=(!a125);
  a127=arg[2]? arg[2][32] : 0;
  a125=(a125?a127:0);
  a081=(a081+a125);
  a125=(a081<a069);
  a127=(a037+a081);
  a127=(a125?a127:0);
  a125=(!a125);
  a126=(-a081);
  a126=(a069<a126);
  a037=(a037-a081);
  a037=(a126?a037:0);
  a126=(!a126);
  a126=(a126?a124:0);
  a037=(a037+a126);
  a125=(a125?a037:0);
  a127=(a127+a125);
  if (res[0]!=0) res[0][30]=a127;
  if (res[0]!=0) res[0][31]=a124;
  a069=casadi_fabs(a069);
  a069=(a081<a069);
  a069=(a069?a081:0);
  if (res[0]!=0) res[0][32]=a069;
  if (res[0]!=0) res[0][33]=a136;
  if (res[0]!=0) res[0][34]=a011;
  a133=casadi_fabs(a133);
  a133=(a135<a133);
  a133=(a133?a135:0);
  if (res[0]!=0) res[0][35]=a133;
  if (res[0]!=0) res[0][36]=a148;
  if (res[0]!=0) res[0][37]=a143;
  a024=casadi_fabs(a024);
  a024=(a147<a024);
  a024=(a024?a147:0);
  if (res[0]!=0) res[0][38]=a024;
  if (res[0]!=0) res[0][39]=a045;
  a074=casadi_fmin(a074,a044);
  a074=(a074-a042);
  a074=casadi_fmax(a004,a074);
  a074=(a072?a074:0);
  a072=(!a072);
  a072=(a072?a075:0);
  a074=(a074+a072);
  if (res[0]!=0) res[0][40]=a074;
  if (res[0]!=0) res[0][41]=a007;
  if (res[0]!=0) res[0][42]=a078;
  if (res[0]!=0) res[0][43]=a020;
  if (res[0]!=0) res[0][44]=a073;
  if (res[0]!=0) res[0][45]=a115;
  if (res[0]!=0) res[0][46]=a086;
  a091=casadi_fmin(a091,a044);
  a091=(a091-a042);
  a091=casadi_fmax(a004,a091);
  a091=(a027?a091:0);
  a027=(!a027);
  a027=(a027?a092:0);
  a091=(a091+a027);
  if (res[0]!=0) res[0][47]=a091;
  if (res[0]!=0) res[0][48]=a014;
  if (res[0]!=0) res[0][49]=a094;
  if (res[0]!=0) res[0][50]=a026;
  if (res[0]!=0) res[0][51]=a093;
  if (res[0]!=0) res[0][52]=a067;
  if (res[0]!=0) res[0][53]=a099;
  a103=casadi_fmin(a103,a044);
  a103=(a103-a042);
  a103=casadi_fmax(a004,a103);
  a103=(a102?a103:0);
  a102=(!a102);
  a102=(a102?a104:0);
  a103=(a103+a102);
  if (res[0]!=0) res[0][54]=a103;
  if (res[0]!=0) res[0][55]=a017;
  if (res[0]!=0) res[0][56]=a106;
  if (res[0]!=0) res[0][57]=a032;
  if (res[0]!=0) res[0][58]=a105;
  if (res[0]!=0) res[0][59]=a123;
  a123=arg[1]? arg[1][12] : 0;
  a071=(a071*a123);
  a033=(a033+a071);
  if (res[0]!=0) res[0][60]=a033;
  if (res[0]!=0) res[0][61]=a117;
  if (res[0]!=0) res[0][62]=a113;
  a082=(a082*a123);
  a118=(a118+a082);
  if (res[0]!=0) res[0][63]=a118;
  if (res[0]!=0) res[0][64]=a121;
  if (res[0]!=0) res[0][65]=a119;
  a021=(a021*a123);
  a090=(a090+a021);
  if (res[0]!=0) res[0][66]=a090;
  if (res[0]!=0) res[0][67]=a122;
  if (res[0]!=0) res[0][68]=a111;
  a083=(a083?a084:0);
  a085=(a085*a123);
  a083=(a083+a085);
  if (res[0]!=0) res[0][69]=a083;
  if (res[0]!=0) res[0][70]=a087;
  if (res[0]!=0) res[0][71]=a077;
  a096=(a096?a097:0);
  a098=(a098*a123);
  a096=(a096+a098);
  if (res[0]!=0) res[0][72]=a096;
  if (res[0]!=0) res[0][73]=a100;
  if (res[0]!=0) res[0][74]=a095;
  a108=(a108?a109:0);
  a110=(a110*a123);
  a108=(a108+a110);
  if (res[0]!=0) res[0][75]=a108;
  if (res[0]!=0) res[0][76]=a112;
  if (res[0]!=0) res[0][77]=a107;
  if (res[0]!=0) res[0][78]=a076;
  a120=(a080-a120);
  a076=arg[1]? arg[1][15] : 0;
  a120=(a120*a076);
  a089=(a089+a120);
  a120=arg[1]? arg[1][14] : 0;
  a129=(a129*a120);
  a089=(a089+a129);
  if (res[0]!=0) res[0][79]=a089;
  if (res[0]!=0) res[0][80]=a140;
  if (res[0]!=0) res[0][81]=a139;
  if (res[0]!=0) res[0][82]=a144;
  a138=(a138+a131);
  a138=(a145*a138);
  a138=(-a138);
  a138=(a138<a004);
  a131=(a138?a137:0);
  a138=(!a138);
  a144=arg[0]? arg[0][74] : 0;
  a139=(-a144);
  a140=arg[1]? arg[1][26] : 0;
  a145=(a145*a140);
  a137=(a137+a145);
  a144=casadi_fmin(a144,a137);
  a139=casadi_fmax(a139,a144);
  a138=(a138?a139:0);
  a131=(a131+a138);
  if (res[0]!=0) res[0][83]=a131;
  if (res[0]!=0) res[0][84]=a152;
  if (res[0]!=0) res[0][85]=a151;
  if (res[0]!=0) res[0][86]=a154;
  a150=(a150+a134);
  a150=(a155*a150);
  a150=(-a150);
  a150=(a150<a004);
  a004=(a150?a149:0);
  a150=(!a150);
  a134=arg[0]? arg[0][78] : 0;
  a154=(-a134);
  a151=arg[1]? arg[1][29] : 0;
  a155=(a155*a151);
  a149=(a149+a155);
  a134=casadi_fmin(a134,a149);
  a154=casadi_fmax(a154,a134);
  a150=(a150?a154:0);
  a004=(a004+a150);
  if (res[0]!=0) res[0][87]=a004;
  a004=(a000<a036);
  a150=(a004?a070:0);
  a004=(!a004);
  a080=(a114?a080:0);
  a114=(!a114);
  a114=(a114?a070:0);
  a080=(a080+a114);
  a004=(a004?a080:0);
  a150=(a150+a004);
  if (res[0]!=0) res[0][88]=a150;
  a004=(a000<a036);
  a080=(a004?a088:0);
  a004=(!a004);
  a132=(a116?a132:0);
  a116=(!a116);
  a116=(a116?a088:0);
  a132=(a132+a116);
  a004=(a004?a132:0);
  a080=(a080+a004);
  if (res[0]!=0) res[0][89]=a080;
  a000=(a000<a036);
  a036=(a000?a101:0);
  a000=(!a000);
  a142=(a079?a142:0);
  a079=(!a079);
  a079=(a079?a101:0);
  a142=(a142+a079);
  a000=(a000?a142:0);
  a036=(a036+a000);
  if (res[0]!=0) res[0][90]=a036;
  a000=-930.;
  a142=930.;
  a150=(a150*a003);
  a142=casadi_fmin(a142,a150);
  a000=casadi_fmax(a000,a142);
  if (res[1]!=0) res[1][0]=a000;
  a000=-1200.;
  a142=1200.;
  a080=(a080*a003);
  a080=casadi_fmin(a142,a080);
  a080=casadi_fmax(a000,a080);
  if (res[1]!=0) res[1][1]=a080;
  a036=(a036*a003);
  a142=casadi_fmin(a142,a036);
  a000=casadi_fmax(a000,a142);
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


