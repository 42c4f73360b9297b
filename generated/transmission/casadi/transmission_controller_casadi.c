/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) transmission_controller_casadi_ ## ID
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
CASADI_SYMBOL_EXPORT void transmission_controller_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int transmission_controller_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int transmission_controller_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

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
  casadi_real a000, a001, a002, a003, a004, a005, a006, a007, a008, a009, a010, a011;
  casadi_real a012, a013, a014, a015, a016, a017, a018, a019, a020, a021, a022, a023;
  casadi_real a024, a025, a026, a027, a028, a029, a030, a031, a032, a033, a034, a035;
  casadi_real a036, a037, a038, a039, a040, a041, a042, a043, a044, a045, a046, a047;
  casadi_real a048, a049, a050, a051, a052, a053, a054, a055, a056, a057, a058, a059;
  casadi_real a060, a061, a062, a063, a064, a065, a066, a067, a068, a069, a070, a071;
  casadi_real a072, a073, a074, a075, a076, a077, a078, a079, a080, a081, a082, a083;
  casadi_real a084, a085, a086, a087, a088, a089, a090, a091, a092, a093, a094, a095;
  casadi_real a096, a097, a098, a099, a100;
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
  a012=arg[0]? arg[0][10] : 0;
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
  a016=arg[0]? arg[0][11] : 0;
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
  a013=arg[3]? arg[3][4] : 0;
  a017=casadi_fabs(a013);
  a018=arg[0]? arg[0][7] : 0;
  a017=(a017<=a018);
  a011=(a011&&a017);
  a017=arg[3]? arg[3][5] : 0;
  a019=casadi_fabs(a017);
  a020=arg[0]? arg[0][8] : 0;
  a019=(a019<=a020);
  a011=(a011&&a019);
  a019=arg[3]? arg[3][0] : 0;
  a021=casadi_fabs(a019);
  a022=arg[0]? arg[0][3] : 0;
  a021=(a021<=a022);
  a011=(a011&&a021);
  a021=arg[3]? arg[3][2] : 0;
  a023=casadi_fabs(a021);
  a024=arg[0]? arg[0][5] : 0;
  a023=(a023<=a024);
  a011=(a011&&a023);
  a023=arg[2]? arg[2][3] : 0;
  a025=(a002-a023);
  a026=arg[2]? arg[2][21] : 0;
  a027=-1.;
  a028=arg[3]? arg[3][7] : 0;
  a028=(a027+a028);
  a028=casadi_fabs(a028);
  a028=(a028<=a000);
  a028=(a028?a002:0);
  a029=arg[2]? arg[2][20] : 0;
  a029=(a028-a029);
  a026=casadi_fmax(a026,a029);
  a025=(a025*a026);
  a026=(-a025);
  a026=(a011?a026:0);
  a026=(a006?a026:0);
  a005=(a005?a026:0);
  a005=(a002+a005);
  a001=(a001*a005);
  a005=(a000<a001);
  a026=(a005?a001:0);
  a005=(!a005);
  a029=casadi_fabs(a019);
  a029=(a029<=a022);
  a022=(a029?a002:0);
  a022=(a000<a022);
  a030=arg[2]? arg[2][5] : 0;
  a031=arg[0]? arg[0][2] : 0;
  a030=casadi_fmin(a030,a031);
  a032=arg[0]? arg[0][0] : 0;
  a033=casadi_fmax(a030,a032);
  a033=(a033-a032);
  a033=(a022?a033:0);
  a022=(!a022);
  a030=(a030+a032);
  a022=(a022?a030:0);
  a033=(a033+a022);
  a022=arg[1]? arg[1][0] : 0;
  a030=(a033<=a022);
  a034=casadi_fabs(a007);
  a034=(a034<=a015);
  a015=(a034?a002:0);
  a015=(a000<a015);
  a035=arg[2]? arg[2][7] : 0;
  a035=casadi_fmin(a035,a031);
  a036=casadi_fmax(a035,a032);
  a036=(a036-a032);
  a036=(a015?a036:0);
  a015=(!a015);
  a035=(a035+a032);
  a015=(a015?a035:0);
  a036=(a036+a015);
  a015=(a036<=a022);
  a035=casadi_fabs(a021);
  a035=(a035<=a024);
  a024=(a035?a002:0);
  a024=(a000<a024);
  a037=arg[2]? arg[2][9] : 0;
  a037=casadi_fmin(a037,a031);
  a038=casadi_fmax(a037,a032);
  a038=(a038-a032);
  a038=(a024?a038:0);
  a024=(!a024);
  a037=(a037+a032);
  a024=(a024?a037:0);
  a038=(a038+a024);
  a024=(a038<=a022);
  a008=(a008?a002:0);
  a008=(a000<a008);
  a037=arg[2]? arg[2][11] : 0;
  a037=casadi_fmin(a037,a031);
  a039=casadi_fmax(a037,a032);
  a039=(a039-a032);
  a039=(a008?a039:0);
  a008=(!a008);
  a037=(a037+a032);
  a008=(a008?a037:0);
  a039=(a039+a008);
  a008=(a039<=a022);
  a037=casadi_fabs(a013);
  a037=(a037<=a018);
  a018=(a037?a002:0);
  a018=(a000<a018);
  a040=arg[2]? arg[2][13] : 0;
  a040=casadi_fmin(a040,a031);
  a041=casadi_fmax(a040,a032);
  a041=(a041-a032);
  a041=(a018?a041:0);
  a018=(!a018);
  a040=(a040+a032);
  a018=(a018?a040:0);
  a041=(a041+a018);
  a018=(a041<=a022);
  a040=casadi_fabs(a017);
  a040=(a040<=a020);
  a020=(a040?a002:0);
  a020=(a000<a020);
  a042=arg[2]? arg[2][15] : 0;
  a042=casadi_fmin(a042,a031);
  a043=casadi_fmax(a042,a032);
  a043=(a043-a032);
  a043=(a020?a043:0);
  a020=(!a020);
  a042=(a042+a032);
  a020=(a020?a042:0);
  a043=(a043+a020);
  a020=(a043<=a022);
  a009=(a009?a002:0);
  a009=(a000<a009);
  a042=arg[2]? arg[2][17] : 0;
  a042=casadi_fmin(a042,a031);
  a044=casadi_fmax(a042,a032);
  a044=(a044-a032);
  a044=(a009?a044:0);
  a009=(!a009);
  a042=(a042+a032);
  a009=(a009?a042:0);
  a044=(a044+a009);
  a009=(a044<=a022);
  a042=casadi_fabs(a010);
  a042=(a042<=a012);
  a042=(a042?a002:0);
  a042=(a000<a042);
  a012=arg[2]? arg[2][18] : 0;
  a012=casadi_fmin(a012,a031);
  a045=casadi_fmax(a012,a032);
  a045=(a045-a032);
  a045=(a042?a045:0);
  a042=(!a042);
  a012=(a012+a032);
  a042=(a042?a012:0);
  a045=(a045+a042);
  a042=(a045<=a022);
  a012=casadi_fabs(a014);
  a012=(a012<=a016);
  a012=(a012?a002:0);
  a012=(a000<a012);
  a016=arg[2]? arg[2][19] : 0;
  a016=casadi_fmin(a016,a031);
  a046=casadi_fmax(a016,a032);
  a046=(a046-a032);
  a046=(a012?a046:0);
  a012=(!a012);
  a016=(a016+a032);
  a012=(a012?a016:0);
  a046=(a046+a012);
  a012=(a046<=a022);
  a012=(!a012);
  a016=4007.;
  a012=(a012?a016:0);
  a012=(a042?a012:0);
  a042=(!a042);
  a016=4004.;
  a042=(a042?a016:0);
  a012=(a012+a042);
  a012=(a009?a012:0);
  a009=(!a009);
  a042=7.;
  a009=(a009?a042:0);
  a012=(a012+a009);
  a012=(a020?a012:0);
  a020=(!a020);
  a009=6.;
  a020=(a020?a009:0);
  a012=(a012+a020);
  a012=(a018?a012:0);
  a018=(!a018);
  a020=5.;
  a018=(a018?a020:0);
  a012=(a012+a018);
  a012=(a008?a012:0);
  a008=(!a008);
  a018=4.;
  a008=(a008?a018:0);
  a012=(a012+a008);
  a012=(a024?a012:0);
  a024=(!a024);
  a008=3.;
  a024=(a024?a008:0);
  a012=(a012+a024);
  a012=(a015?a012:0);
  a015=(!a015);
  a024=2.;
  a015=(a015?a024:0);
  a012=(a012+a015);
  a012=(a030?a012:0);
  a030=(!a030);
  a030=(a030?a002:0);
  a012=(a012+a030);
  a005=(a005?a012:0);
  a026=(a026+a005);
  a005=(a000<a026);
  a026=(a005?a026:0);
  a005=(!a005);
  a012=arg[2]? arg[2][2] : 0;
  a030=(a012<=a000);
  a015=(a030?a010:0);
  a030=(!a030);
  a024=arg[2]? arg[2][38] : 0;
  a030=(a030?a024:0);
  a015=(a015+a030);
  a030=arg[1]? arg[1][12] : 0;
  a024=arg[2]? arg[2][70] : 0;
  a018=(a024*a003);
  a013=(a037?a013:0);
  a037=(!a037);
  a020=arg[2]? arg[2][12] : 0;
  a037=(a037?a020:0);
  a013=(a013+a037);
  a037=(a018-a013);
  a030=(a030*a037);
  a030=(a015+a030);
  a037=arg[1]? arg[1][11] : 0;
  a015=(a010-a015);
  a015=(a037*a015);
  a030=(a030+a015);
  a015=(a030-a010);
  a015=casadi_fabs(a015);
  a020=arg[0]? arg[0][35] : 0;
  a009=(a015<=a020);
  a042=arg[2]? arg[2][40] : 0;
  a042=(a010==a042);
  a016=(a012<=a000);
  a016=(!a016);
  a047=arg[2]? arg[2][41] : 0;
  a016=(a016?a047:0);
  a016=(a016+a032);
  a042=(a042?a016:0);
  a016=arg[0]? arg[0][36] : 0;
  a047=(a042<=a016);
  a009=(a009||a047);
  a020=(a015<=a020);
  a047=arg[2]? arg[2][42] : 0;
  a047=(a013==a047);
  a048=(a012<=a000);
  a048=(!a048);
  a049=arg[2]? arg[2][43] : 0;
  a048=(a048?a049:0);
  a048=(a048+a032);
  a047=(a047?a048:0);
  a048=(a047<=a016);
  a020=(a020||a048);
  a048=(a004<a047);
  a049=arg[2]? arg[2][44] : 0;
  a049=(a048?a049:0);
  a048=(!a048);
  a048=(a048?a018:0);
  a049=(a049+a048);
  a048=(a018-a049);
  a048=casadi_fabs(a048);
  a050=arg[1]? arg[1][13] : 0;
  a048=(a048<=a050);
  a020=(a020||a048);
  a048=(a012<=a000);
  a050=(a048?a014:0);
  a048=(!a048);
  a051=arg[2]? arg[2][45] : 0;
  a048=(a048?a051:0);
  a050=(a050+a048);
  a048=arg[1]? arg[1][14] : 0;
  a051=arg[2]? arg[2][71] : 0;
  a052=(a051*a003);
  a017=(a040?a017:0);
  a040=(!a040);
  a053=arg[2]? arg[2][14] : 0;
  a040=(a040?a053:0);
  a017=(a017+a040);
  a040=(a052+a017);
  a048=(a048*a040);
  a048=(a050+a048);
  a050=(a014-a050);
  a037=(a037*a050);
  a048=(a048+a037);
  a037=(a048-a014);
  a037=casadi_fabs(a037);
  a050=arg[0]? arg[0][39] : 0;
  a040=(a037<=a050);
  a053=arg[2]? arg[2][49] : 0;
  a053=(a017==a053);
  a054=(a012<=a000);
  a054=(!a054);
  a055=arg[2]? arg[2][50] : 0;
  a054=(a054?a055:0);
  a054=(a054+a032);
  a053=(a053?a054:0);
  a054=(a053<=a016);
  a040=(a040||a054);
  a054=(a004<a053);
  a055=arg[2]? arg[2][51] : 0;
  a055=(a054?a055:0);
  a054=(!a054);
  a054=(a054?a052:0);
  a055=(a055+a054);
  a054=(a052-a055);
  a054=casadi_fabs(a054);
  a056=arg[1]? arg[1][15] : 0;
  a054=(a054<=a056);
  a040=(a040||a054);
  a050=(a037<=a050);
  a054=arg[2]? arg[2][47] : 0;
  a054=(a014==a054);
  a056=(a012<=a000);
  a056=(!a056);
  a057=arg[2]? arg[2][48] : 0;
  a056=(a056?a057:0);
  a056=(a056+a032);
  a054=(a054?a056:0);
  a016=(a054<=a016);
  a050=(a050||a016);
  a016=arg[0]? arg[0][34] : 0;
  a015=(a015<=a016);
  a015=(a015?a002:0);
  a015=(a000<a015);
  a016=arg[2]? arg[2][39] : 0;
  a016=casadi_fmin(a016,a031);
  a056=casadi_fmax(a016,a032);
  a056=(a056-a032);
  a056=(a015?a056:0);
  a015=(!a015);
  a016=(a016+a032);
  a015=(a015?a016:0);
  a056=(a056+a015);
  a015=(a056<=a022);
  a016=arg[0]? arg[0][38] : 0;
  a037=(a037<=a016);
  a037=(a037?a002:0);
  a037=(a000<a037);
  a016=arg[2]? arg[2][46] : 0;
  a016=casadi_fmin(a016,a031);
  a031=casadi_fmax(a016,a032);
  a031=(a031-a032);
  a031=(a037?a031:0);
  a037=(!a037);
  a016=(a016+a032);
  a037=(a037?a016:0);
  a031=(a031+a037);
  a022=(a031<=a022);
  a037=(a012<=a000);
  a037=(!a037);
  a016=arg[2]? arg[2][54] : 0;
  a037=(a037?a016:0);
  a016=arg[1]? arg[1][16] : 0;
  a037=(a037-a016);
  a037=casadi_fmax(a004,a037);
  a057=arg[0]? arg[0][41] : 0;
  a058=(a012<=a000);
  a059=(a058?a013:0);
  a058=(!a058);
  a060=arg[2]? arg[2][52] : 0;
  a058=(a058?a060:0);
  a059=(a059+a058);
  a058=(a013-a059);
  a060=(a057<a058);
  a061=(a060?a002:0);
  a060=(!a060);
  a057=(-a057);
  a057=(a058<a057);
  a062=(a057?a027:0);
  a057=(!a057);
  a063=arg[2]? arg[2][53] : 0;
  a057=(a057?a063:0);
  a062=(a062+a057);
  a060=(a060?a062:0);
  a061=(a061+a060);
  a063=(a061==a063);
  a063=(!a063);
  a063=(a063?a002:0);
  a037=(a037+a063);
  a063=5.5000000000000000e+00;
  a060=(a037<=a063);
  a062=(a012<=a000);
  a062=(!a062);
  a057=arg[2]? arg[2][57] : 0;
  a062=(a062?a057:0);
  a062=(a062-a016);
  a062=casadi_fmax(a004,a062);
  a057=arg[0]? arg[0][42] : 0;
  a064=(a012<=a000);
  a065=(a064?a017:0);
  a064=(!a064);
  a066=arg[2]? arg[2][55] : 0;
  a064=(a064?a066:0);
  a065=(a065+a064);
  a064=(a017-a065);
  a066=(a057<a064);
  a067=(a066?a002:0);
  a066=(!a066);
  a057=(-a057);
  a057=(a064<a057);
  a068=(a057?a027:0);
  a057=(!a057);
  a069=arg[2]? arg[2][56] : 0;
  a057=(a057?a069:0);
  a068=(a068+a057);
  a066=(a066?a068:0);
  a067=(a067+a066);
  a069=(a067==a069);
  a069=(!a069);
  a069=(a069?a002:0);
  a062=(a062+a069);
  a069=(a062<=a063);
  a066=(a012<=a000);
  a066=(!a066);
  a068=arg[2]? arg[2][60] : 0;
  a066=(a066?a068:0);
  a066=(a066-a016);
  a066=casadi_fmax(a004,a066);
  a068=arg[0]? arg[0][43] : 0;
  a057=(a012<=a000);
  a057=(!a057);
  a070=arg[2]? arg[2][58] : 0;
  a071=(-a070);
  a071=(a057?a071:0);
  a018=(a018+a071);
  a071=(a068<a018);
  a072=(a071?a002:0);
  a071=(!a071);
  a068=(-a068);
  a068=(a018<a068);
  a073=(a068?a027:0);
  a068=(!a068);
  a074=arg[2]? arg[2][59] : 0;
  a068=(a068?a074:0);
  a073=(a073+a068);
  a071=(a071?a073:0);
  a072=(a072+a071);
  a074=(a072==a074);
  a074=(!a074);
  a074=(a074?a002:0);
  a066=(a066+a074);
  a074=(a066<=a063);
  a071=(a012<=a000);
  a071=(!a071);
  a073=arg[2]? arg[2][63] : 0;
  a071=(a071?a073:0);
  a071=(a071-a016);
  a071=casadi_fmax(a004,a071);
  a016=arg[0]? arg[0][44] : 0;
  a073=(a012<=a000);
  a073=(!a073);
  a068=arg[2]? arg[2][61] : 0;
  a075=(-a068);
  a075=(a073?a075:0);
  a052=(a052+a075);
  a075=(a016<a052);
  a076=(a075?a002:0);
  a075=(!a075);
  a016=(-a016);
  a016=(a052<a016);
  a077=(a016?a027:0);
  a016=(!a016);
  a078=arg[2]? arg[2][62] : 0;
  a016=(a016?a078:0);
  a077=(a077+a016);
  a075=(a075?a077:0);
  a076=(a076+a075);
  a078=(a076==a078);
  a078=(!a078);
  a078=(a078?a002:0);
  a071=(a071+a078);
  a063=(a071<=a063);
  a063=(!a063);
  a078=8002.;
  a063=(a063?a078:0);
  a063=(a074?a063:0);
  a074=(!a074);
  a078=8001.;
  a074=(a074?a078:0);
  a063=(a063+a074);
  a063=(a069?a063:0);
  a069=(!a069);
  a074=6006.;
  a069=(a069?a074:0);
  a063=(a063+a069);
  a063=(a060?a063:0);
  a060=(!a060);
  a069=6005.;
  a060=(a060?a069:0);
  a063=(a063+a060);
  a063=(a022?a063:0);
  a022=(!a022);
  a060=5007.;
  a022=(a022?a060:0);
  a063=(a063+a022);
  a063=(a015?a063:0);
  a015=(!a015);
  a022=5004.;
  a015=(a015?a022:0);
  a063=(a063+a015);
  a063=(a050?a063:0);
  a050=(!a050);
  a015=3007.;
  a050=(a050?a015:0);
  a063=(a063+a050);
  a063=(a040?a063:0);
  a040=(!a040);
  a050=3006.;
  a040=(a040?a050:0);
  a063=(a063+a040);
  a063=(a020?a063:0);
  a020=(!a020);
  a040=3005.;
  a020=(a020?a040:0);
  a063=(a063+a020);
  a063=(a009?a063:0);
  a009=(!a009);
  a020=3004.;
  a009=(a009?a020:0);
  a063=(a063+a009);
  a005=(a005?a063:0);
  a026=(a026+a005);
  a005=(a000<a026);
  a026=(a005?a026:0);
  a005=(!a005);
  a063=arg[1]? arg[1][4] : 0;
  a009=arg[0]? arg[0][16] : 0;
  a020=casadi_fabs(a010);
  a009=casadi_fmax(a009,a020);
  a063=(a063/a009);
  a009=arg[1]? arg[1][3] : 0;
  a020=arg[1]? arg[1][2] : 0;
  a040=(a010*a020);
  a040=(a009+a040);
  a040=casadi_fmin(a002,a040);
  a040=casadi_fmax(a004,a040);
  a040=(a063*a040);
  a050=(-a040);
  a020=(a010*a020);
  a009=(a009-a020);
  a009=casadi_fmin(a002,a009);
  a009=casadi_fmax(a004,a009);
  a063=(a063*a009);
  a009=arg[0]? arg[0][15] : 0;
  a020=arg[2]? arg[2][29] : 0;
  a020=(a009!=a020);
  a015=arg[1]? arg[1][1] : 0;
  a022=(a012<=a000);
  a060=(a022?a009:0);
  a022=(!a022);
  a069=arg[2]? arg[2][28] : 0;
  a022=(a022?a069:0);
  a060=(a060+a022);
  a022=(a009-a060);
  a069=casadi_fabs(a022);
  a069=(a015*a069);
  a074=9.9999999999999995e-07;
  a078=casadi_fabs(a009);
  a078=(a074*a078);
  a075=casadi_fabs(a060);
  a075=(a074*a075);
  a078=(a078+a075);
  a069=casadi_fmax(a069,a078);
  a069=(a020?a069:0);
  a020=(!a020);
  a078=arg[2]? arg[2][30] : 0;
  a020=(a020?a078:0);
  a069=(a069+a020);
  a020=casadi_fabs(a022);
  a020=(a069<a020);
  a078=(-a069);
  a075=casadi_fmin(a022,a069);
  a078=casadi_fmax(a078,a075);
  a060=(a060+a078);
  a060=(a020?a060:0);
  a020=(!a020);
  a020=(a020?a009:0);
  a060=(a060+a020);
  a020=(a012<=a000);
  a078=arg[0]? arg[0][24] : 0;
  a021=(a035?a021:0);
  a035=(!a035);
  a075=arg[2]? arg[2][8] : 0;
  a035=(a035?a075:0);
  a021=(a021+a035);
  a035=arg[0]? arg[0][25] : 0;
  a075=casadi_fmin(a021,a035);
  a075=casadi_fmax(a078,a075);
  a077=arg[0]? arg[0][26] : 0;
  a016=arg[2]? arg[2][32] : 0;
  a016=(a077!=a016);
  a079=(a012<=a000);
  a080=(a079?a077:0);
  a079=(!a079);
  a081=arg[2]? arg[2][31] : 0;
  a079=(a079?a081:0);
  a080=(a080+a079);
  a079=(a077-a080);
  a081=casadi_fabs(a079);
  a081=(a015*a081);
  a082=casadi_fabs(a077);
  a082=(a074*a082);
  a083=casadi_fabs(a080);
  a083=(a074*a083);
  a082=(a082+a083);
  a081=casadi_fmax(a081,a082);
  a081=(a016?a081:0);
  a016=(!a016);
  a082=arg[2]? arg[2][33] : 0;
  a016=(a016?a082:0);
  a081=(a081+a016);
  a016=casadi_fabs(a079);
  a016=(a081<a016);
  a082=(-a081);
  a083=casadi_fmin(a079,a081);
  a082=casadi_fmax(a082,a083);
  a080=(a080+a082);
  a080=(a016?a080:0);
  a016=(!a016);
  a016=(a016?a077:0);
  a080=(a080+a016);
  a016=(a002-a080);
  a016=(a075*a016);
  a082=arg[0]? arg[0][30] : 0;
  a083=(a012<=a000);
  a084=arg[0]? arg[0][27] : 0;
  a085=casadi_fabs(a014);
  a085=(a084<=a085);
  a086=casadi_fabs(a014);
  a086=(a084<=a086);
  a087=(a086?a014:0);
  a086=(!a086);
  a086=(a086?a002:0);
  a087=(a087+a086);
  a087=(a010/a087);
  a035=casadi_fmin(a035,a087);
  a078=casadi_fmax(a078,a035);
  a035=(a085?a078:0);
  a085=(!a085);
  a085=(a085?a075:0);
  a035=(a035+a085);
  a035=(a083?a035:0);
  a083=(!a083);
  a085=arg[2]? arg[2][34] : 0;
  a083=(a083?a085:0);
  a035=(a035+a083);
  a083=casadi_fabs(a014);
  a083=(a084<=a083);
  a085=arg[1]? arg[1][8] : 0;
  a078=(a078-a035);
  a085=(a085*a078);
  a083=(a083?a085:0);
  a035=(a035+a083);
  a083=-2.1655000000000002e+00;
  a083=(a035<=a083);
  a085=-4.9320000000000004e+00;
  a085=(a083?a085:0);
  a083=(!a083);
  a078=6.5900000000000003e-01;
  a078=(a035<=a078);
  a075=6.0099999999999998e-01;
  a075=(a078?a075:0);
  a078=(!a078);
  a087=7.9099999999999993e-01;
  a087=(a035<=a087);
  a086=7.1699999999999997e-01;
  a086=(a087?a086:0);
  a087=(!a087);
  a088=9.3250000000000000e-01;
  a088=(a035<=a088);
  a089=8.6499999999999999e-01;
  a089=(a088?a089:0);
  a088=(!a088);
  a090=1.1055000000000001e+00;
  a090=(a035<=a090);
  a091=(a090?a002:0);
  a090=(!a090);
  a092=1.4359999999999999e+00;
  a092=(a035<=a092);
  a093=1.2110000000000001e+00;
  a093=(a092?a093:0);
  a092=(!a092);
  a094=1.9880000000000000e+00;
  a094=(a035<=a094);
  a095=1.6610000000000000e+00;
  a095=(a094?a095:0);
  a094=(!a094);
  a096=2.8239999999999998e+00;
  a096=(a035<=a096);
  a097=2.3149999999999999e+00;
  a097=(a096?a097:0);
  a096=(!a096);
  a098=4.4180000000000001e+00;
  a098=(a035<=a098);
  a099=3.3330000000000002e+00;
  a099=(a098?a099:0);
  a098=(!a098);
  a100=5.5030000000000001e+00;
  a098=(a098?a100:0);
  a099=(a099+a098);
  a096=(a096?a099:0);
  a097=(a097+a096);
  a094=(a094?a097:0);
  a095=(a095+a094);
  a092=(a092?a095:0);
  a093=(a093+a092);
  a090=(a090?a093:0);
  a091=(a091+a090);
  a088=(a088?a091:0);
  a089=(a089+a088);
  a087=(a087?a089:0);
  a086=(a086+a087);
  a078=(a078?a086:0);
  a075=(a075+a078);
  a083=(a083?a075:0);
  a085=(a085+a083);
  a083=(a035-a085);
  a083=casadi_fabs(a083);
  a075=arg[0]? arg[0][29] : 0;
  a078=casadi_fabs(a085);
  a078=(a075*a078);
  a083=(a083<=a078);
  a078=(a012<=a000);
  a078=(!a078);
  a086=arg[2]? arg[2][35] : 0;
  a078=(a078?a086:0);
  a078=(a078+a032);
  a086=(a082+a032);
  a078=casadi_fmin(a078,a086);
  a083=(a083?a078:0);
  a082=(a082<a083);
  a085=(a082?a085:0);
  a082=(!a082);
  a078=(a012<=a000);
  a078=(!a078);
  a086=arg[2]? arg[2][36] : 0;
  a087=(a078?a086:0);
  a089=casadi_fabs(a087);
  a075=(a075*a089);
  a086=(-a086);
  a078=(a078?a086:0);
  a078=(a035+a078);
  a078=casadi_fabs(a078);
  a078=(2.*a078);
  a078=(a078/a008);
  a075=(a075<a078);
  a075=(!a075);
  a075=(a075?a087:0);
  a082=(a082?a075:0);
  a085=(a085+a082);
  a082=casadi_fabs(a085);
  a082=(a004<a082);
  a075=(a082?a085:0);
  a082=(!a082);
  a082=(a082?a035:0);
  a075=(a075+a082);
  a075=(a075*a080);
  a016=(a016+a075);
  a075=(a020?a016:0);
  a020=(!a020);
  a082=arg[2]? arg[2][37] : 0;
  a020=(a020?a082:0);
  a075=(a075+a020);
  a020=arg[1]? arg[1][9] : 0;
  a082=(-a020);
  a016=(a016-a075);
  a020=casadi_fmin(a020,a016);
  a082=casadi_fmax(a082,a020);
  a075=(a075+a082);
  a020=(a014*a075);
  a020=(a020-a010);
  a020=(a060*a020);
  a016=casadi_fabs(a014);
  a016=(a016/a084);
  a027=(a027+a016);
  a027=casadi_fmin(a002,a027);
  a027=casadi_fmax(a004,a027);
  a027=(a002-a027);
  a027=(a080*a027);
  a027=(a002-a027);
  a020=(a020*a027);
  a027=arg[0]? arg[0][57] : 0;
  a016=(a002-a027);
  a040=(a040*a016);
  a040=(-a040);
  a016=(a012<=a000);
  a016=(!a016);
  a084=arg[2]? arg[2][69] : 0;
  a016=(a016?a084:0);
  a084=arg[0]? arg[0][51] : 0;
  a087=(a012<=a000);
  a078=(a087?a013:0);
  a087=(!a087);
  a008=arg[2]? arg[2][65] : 0;
  a087=(a087?a008:0);
  a078=(a078+a087);
  a087=arg[1]? arg[1][19] : 0;
  a008=(-a087);
  a019=(a029?a019:0);
  a029=(!a029);
  a086=arg[2]? arg[2][4] : 0;
  a029=(a029?a086:0);
  a019=(a019+a029);
  a029=(a019-a078);
  a087=casadi_fmin(a087,a029);
  a008=casadi_fmax(a008,a087);
  a078=(a078+a008);
  a084=(a084*a078);
  a084=(a016+a084);
  a008=(a012<=a000);
  a087=(a008?a013:0);
  a008=(!a008);
  a029=arg[2]? arg[2][67] : 0;
  a008=(a008?a029:0);
  a087=(a087+a008);
  a008=(a012<=a000);
  a008=(!a008);
  a029=arg[2]? arg[2][68] : 0;
  a086=(a008?a029:0);
  a089=arg[1]? arg[1][23] : 0;
  a088=(a078-a087);
  a089=(a089*a088);
  a086=(a086+a089);
  a089=arg[1]? arg[1][24] : 0;
  a089=(a089*a029);
  a089=(-a089);
  a008=(a008?a089:0);
  a086=(a086+a008);
  a032=(a086*a032);
  a087=(a087+a032);
  a032=arg[0]? arg[0][55] : 0;
  a008=(a087*a032);
  a089=arg[0]? arg[0][49] : 0;
  a089=(a089*a014);
  a029=arg[1]? arg[1][10] : 0;
  a088=(a002-a080);
  a029=(a029*a088);
  a029=(a029*a082);
  a089=(a089*a029);
  a089=(a013+a089);
  a082=arg[1]? arg[1][22] : 0;
  a088=arg[1]? arg[1][7] : 0;
  a091=arg[0]? arg[0][20] : 0;
  a090=casadi_fabs(a014);
  a091=casadi_fmax(a091,a090);
  a088=(a088/a091);
  a091=arg[1]? arg[1][6] : 0;
  a090=arg[1]? arg[1][5] : 0;
  a093=(a014*a090);
  a093=(a091+a093);
  a093=casadi_fmin(a002,a093);
  a093=casadi_fmax(a004,a093);
  a093=(a088*a093);
  a093=(-a093);
  a090=(a014*a090);
  a091=(a091-a090);
  a091=casadi_fmin(a002,a091);
  a091=casadi_fmax(a004,a091);
  a088=(a088*a091);
  a091=(a012<=a000);
  a091=(!a091);
  a090=arg[2]? arg[2][66] : 0;
  a091=(a091?a090:0);
  a090=arg[0]? arg[0][48] : 0;
  a090=(a004<a090);
  a092=(a012<=a000);
  a095=arg[0]? arg[0][12] : 0;
  a094=(a092?a095:0);
  a092=(!a092);
  a097=arg[2]? arg[2][22] : 0;
  a092=(a092?a097:0);
  a094=(a094+a092);
  a092=arg[2]? arg[2][23] : 0;
  a092=(a095!=a092);
  a097=(a095-a094);
  a096=casadi_fabs(a097);
  a096=(a015*a096);
  a099=casadi_fabs(a095);
  a099=(a074*a099);
  a098=casadi_fabs(a094);
  a098=(a074*a098);
  a099=(a099+a098);
  a096=casadi_fmax(a096,a099);
  a096=(a092?a096:0);
  a092=(!a092);
  a099=arg[2]? arg[2][24] : 0;
  a092=(a092?a099:0);
  a096=(a096+a092);
  a092=casadi_fabs(a097);
  a092=(a096<a092);
  a099=(-a096);
  a098=casadi_fmin(a097,a096);
  a099=casadi_fmax(a099,a098);
  a099=(a094+a099);
  a099=(a092?a099:0);
  a092=(!a092);
  a092=(a092?a095:0);
  a099=(a099+a092);
  a094=(a094-a099);
  a094=(a017*a094);
  a094=(-a094);
  a090=(a090?a094:0);
  a091=(a091+a090);
  a090=(a012<=a000);
  a094=(a090?a014:0);
  a090=(!a090);
  a092=arg[2]? arg[2][64] : 0;
  a090=(a090?a092:0);
  a094=(a094+a090);
  a090=arg[1]? arg[1][18] : 0;
  a092=(-a090);
  a007=(a034?a007:0);
  a034=(!a034);
  a098=arg[2]? arg[2][6] : 0;
  a034=(a034?a098:0);
  a007=(a007+a034);
  a034=(a007-a094);
  a090=casadi_fmin(a090,a034);
  a092=casadi_fmax(a092,a090);
  a094=(a094+a092);
  a092=(a094-a014);
  a090=arg[0]? arg[0][47] : 0;
  a090=(a092*a090);
  a090=(a091+a090);
  a034=(a017*a099);
  a090=(a090-a034);
  a088=casadi_fmin(a088,a090);
  a093=casadi_fmax(a093,a088);
  a088=(a093+a017);
  a082=(a082*a088);
  a082=(a082*a075);
  a089=(a089+a082);
  a008=(a008-a089);
  a032=(a002-a032);
  a032=(a078*a032);
  a008=(a008+a032);
  a032=arg[0]? arg[0][52] : 0;
  a032=(a008*a032);
  a084=(a084+a032);
  a032=arg[0]? arg[0][13] : 0;
  a089=arg[2]? arg[2][26] : 0;
  a089=(a032!=a089);
  a012=(a012<=a000);
  a082=(a012?a032:0);
  a012=(!a012);
  a034=arg[2]? arg[2][25] : 0;
  a012=(a012?a034:0);
  a082=(a082+a012);
  a012=(a032-a082);
  a034=casadi_fabs(a012);
  a015=(a015*a034);
  a034=casadi_fabs(a032);
  a034=(a074*a034);
  a098=casadi_fabs(a082);
  a074=(a074*a098);
  a034=(a034+a074);
  a015=casadi_fmax(a015,a034);
  a015=(a089?a015:0);
  a089=(!a089);
  a034=arg[2]? arg[2][27] : 0;
  a089=(a089?a034:0);
  a015=(a015+a089);
  a089=casadi_fabs(a012);
  a089=(a015<a089);
  a034=(-a015);
  a074=casadi_fmin(a012,a015);
  a034=casadi_fmax(a034,a074);
  a082=(a082+a034);
  a082=(a089?a082:0);
  a089=(!a089);
  a089=(a089?a032:0);
  a082=(a082+a089);
  a089=arg[0]? arg[0][50] : 0;
  a034=(a089*a014);
  a034=(a034*a029);
  a089=(a089*a088);
  a089=(a089*a075);
  a088=arg[0]? arg[0][37] : 0;
  a089=(a089/a088);
  a034=(a034+a089);
  a034=(a082*a034);
  a084=(a084+a034);
  a027=(a002-a027);
  a027=(a063*a027);
  a027=casadi_fmin(a084,a027);
  a040=casadi_fmax(a040,a027);
  a020=(a020+a040);
  a063=casadi_fmin(a063,a020);
  a050=casadi_fmax(a050,a063);
  a063=casadi_fabs(a050);
  a020=arg[1]? arg[1][26] : 0;
  a063=(a063<=a020);
  a027=(a063?a002:0);
  a027=(a000<a027);
  a034=casadi_fabs(a093);
  a089=arg[1]? arg[1][27] : 0;
  a034=(a034<=a089);
  a088=(a034?a002:0);
  a088=(a000<a088);
  a088=(!a088);
  a029=7002.;
  a088=(a088?a029:0);
  a088=(a027?a088:0);
  a027=(!a027);
  a029=7001.;
  a027=(a027?a029:0);
  a088=(a088+a027);
  a005=(a005?a088:0);
  a026=(a026+a005);
  if (res[0]!=0) res[0][0]=a026;
  a005=(a000<a026);
  a088=arg[1]? arg[1][28] : 0;
  a027=(-a088);
  a027=(a005?a027:0);
  a005=(!a005);
  a005=(a005?a088:0);
  a027=(a027+a005);
  a003=(a003+a027);
  a003=casadi_fmax(a004,a003);
  a003=casadi_fmin(a002,a003);
  if (res[0]!=0) res[0][1]=a003;
  a027=(a000<a026);
  a027=(!a027);
  a027=(a027?a002:0);
  if (res[0]!=0) res[0][2]=a027;
  if (res[0]!=0) res[0][3]=a023;
  if (res[0]!=0) res[0][4]=a019;
  if (res[0]!=0) res[0][5]=a033;
  if (res[0]!=0) res[0][6]=a007;
  if (res[0]!=0) res[0][7]=a036;
  if (res[0]!=0) res[0][8]=a021;
  if (res[0]!=0) res[0][9]=a038;
  if (res[0]!=0) res[0][10]=a010;
  if (res[0]!=0) res[0][11]=a039;
  if (res[0]!=0) res[0][12]=a013;
  if (res[0]!=0) res[0][13]=a041;
  if (res[0]!=0) res[0][14]=a017;
  if (res[0]!=0) res[0][15]=a043;
  if (res[0]!=0) res[0][16]=a014;
  if (res[0]!=0) res[0][17]=a044;
  if (res[0]!=0) res[0][18]=a045;
  if (res[0]!=0) res[0][19]=a046;
  if (res[0]!=0) res[0][20]=a028;
  a001=(a000<a001);
  a011=(a011?a025:0);
  a006=(a006?a011:0);
  a001=(a001?a006:0);
  if (res[0]!=0) res[0][21]=a001;
  if (res[0]!=0) res[0][22]=a099;
  if (res[0]!=0) res[0][23]=a095;
  a097=casadi_fabs(a097);
  a097=(a096<a097);
  a097=(a097?a096:0);
  if (res[0]!=0) res[0][24]=a097;
  if (res[0]!=0) res[0][25]=a082;
  if (res[0]!=0) res[0][26]=a032;
  a012=casadi_fabs(a012);
  a012=(a015<a012);
  a012=(a012?a015:0);
  if (res[0]!=0) res[0][27]=a012;
  if (res[0]!=0) res[0][28]=a060;
  if (res[0]!=0) res[0][29]=a009;
  a022=casadi_fabs(a022);
  a022=(a069<a022);
  a022=(a022?a069:0);
  if (res[0]!=0) res[0][30]=a022;
  if (res[0]!=0) res[0][31]=a080;
  if (res[0]!=0) res[0][32]=a077;
  a079=casadi_fabs(a079);
  a079=(a081<a079);
  a079=(a079?a081:0);
  if (res[0]!=0) res[0][33]=a079;
  if (res[0]!=0) res[0][34]=a035;
  if (res[0]!=0) res[0][35]=a083;
  if (res[0]!=0) res[0][36]=a085;
  if (res[0]!=0) res[0][37]=a075;
  if (res[0]!=0) res[0][38]=a030;
  if (res[0]!=0) res[0][39]=a056;
  if (res[0]!=0) res[0][40]=a010;
  if (res[0]!=0) res[0][41]=a042;
  if (res[0]!=0) res[0][42]=a013;
  if (res[0]!=0) res[0][43]=a047;
  if (res[0]!=0) res[0][44]=a049;
  if (res[0]!=0) res[0][45]=a048;
  if (res[0]!=0) res[0][46]=a031;
  if (res[0]!=0) res[0][47]=a014;
  if (res[0]!=0) res[0][48]=a054;
  if (res[0]!=0) res[0][49]=a017;
  if (res[0]!=0) res[0][50]=a053;
  if (res[0]!=0) res[0][51]=a055;
  a055=arg[1]? arg[1][17] : 0;
  a058=(a058*a055);
  a059=(a059+a058);
  if (res[0]!=0) res[0][52]=a059;
  if (res[0]!=0) res[0][53]=a061;
  if (res[0]!=0) res[0][54]=a037;
  a064=(a064*a055);
  a065=(a065+a064);
  if (res[0]!=0) res[0][55]=a065;
  if (res[0]!=0) res[0][56]=a067;
  if (res[0]!=0) res[0][57]=a062;
  a057=(a057?a070:0);
  a018=(a018*a055);
  a057=(a057+a018);
  if (res[0]!=0) res[0][58]=a057;
  if (res[0]!=0) res[0][59]=a072;
  if (res[0]!=0) res[0][60]=a066;
  a073=(a073?a068:0);
  a052=(a052*a055);
  a073=(a073+a052);
  if (res[0]!=0) res[0][61]=a073;
  if (res[0]!=0) res[0][62]=a076;
  if (res[0]!=0) res[0][63]=a071;
  if (res[0]!=0) res[0][64]=a094;
  if (res[0]!=0) res[0][65]=a078;
  a090=(a093-a090);
  a078=arg[1]? arg[1][21] : 0;
  a090=(a090*a078);
  a091=(a091+a090);
  a090=arg[1]? arg[1][20] : 0;
  a092=(a092*a090);
  a091=(a091+a092);
  if (res[0]!=0) res[0][66]=a091;
  if (res[0]!=0) res[0][67]=a087;
  if (res[0]!=0) res[0][68]=a086;
  a084=(a084-a040);
  a084=(a008*a084);
  a004=(a004<a084);
  a084=(a004?a016:0);
  a004=(!a004);
  a040=arg[0]? arg[0][58] : 0;
  a086=(-a040);
  a087=arg[1]? arg[1][25] : 0;
  a008=(a008*a087);
  a016=(a016+a008);
  a040=casadi_fmin(a040,a016);
  a086=casadi_fmax(a086,a040);
  a004=(a004?a086:0);
  a084=(a084+a004);
  if (res[0]!=0) res[0][69]=a084;
  a084=2.9995000000000000e+03;
  a004=(a084<a026);
  a086=arg[2]? arg[2][72] : 0;
  a040=arg[1]? arg[1][29] : 0;
  a016=(a026<=a000);
  a050=(a063?a050:0);
  a063=(!a063);
  a063=(a063?a024:0);
  a050=(a050+a063);
  a050=(a016?a050:0);
  a016=(!a016);
  a016=(a016?a024:0);
  a050=(a050+a016);
  a016=(a050-a086);
  a016=(a040*a016);
  a016=(a086+a016);
  a024=casadi_fabs(a016);
  a024=(a024<=a020);
  a016=(a024?a016:0);
  a024=(!a024);
  a024=(a024?a086:0);
  a016=(a016+a024);
  a024=(a004?a016:0);
  a004=(!a004);
  a004=(a004?a050:0);
  a024=(a024+a004);
  if (res[0]!=0) res[0][70]=a024;
  a084=(a084<a026);
  a004=arg[2]? arg[2][73] : 0;
  a026=(a026<=a000);
  a093=(a034?a093:0);
  a034=(!a034);
  a034=(a034?a051:0);
  a093=(a093+a034);
  a093=(a026?a093:0);
  a026=(!a026);
  a026=(a026?a051:0);
  a093=(a093+a026);
  a026=(a093-a004);
  a040=(a040*a026);
  a040=(a004+a040);
  a026=casadi_fabs(a040);
  a026=(a026<=a089);
  a040=(a026?a040:0);
  a026=(!a026);
  a026=(a026?a004:0);
  a040=(a040+a026);
  a026=(a084?a040:0);
  a084=(!a084);
  a084=(a084?a093:0);
  a026=(a026+a084);
  if (res[0]!=0) res[0][71]=a026;
  if (res[0]!=0) res[0][72]=a016;
  if (res[0]!=0) res[0][73]=a040;
  a040=-900.;
  a016=900.;
  a024=(a024*a003);
  a016=casadi_fmin(a016,a024);
  a040=casadi_fmax(a040,a016);
  if (res[1]!=0) res[1][0]=a040;
  a040=-3300.;
  a016=3300.;
  a026=(a026*a003);
  a016=casadi_fmin(a016,a026);
  a040=casadi_fmax(a040,a016);
  if (res[1]!=0) res[1][1]=a040;
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


