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
static const casadi_int casadi_s1[3] = {22, 1, 1};
static const casadi_int casadi_s2[3] = {63, 1, 1};
static const casadi_int casadi_s3[3] = {7, 1, 1};
static const casadi_int casadi_s4[3] = {2, 1, 1};

static const casadi_real casadi_zeros[50] = 
  {0.};

/* controller_prepare:(parameters[50])->(derived[22]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real w1, w2, w3, w4;
  const casadi_real *wr0;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = @0[0] */
  w1 = wr0[0];
  /* #2: @2 = @0[13] */
  w2 = wr0[13];
  /* #3: @2 = (@1/@2) */
  w2  = (w1/w2);
  /* #4: output[0][0] = @2 */
  if (res[0]) res[0][0] = w2;
  /* #5: @2 = @0[17] */
  w2 = wr0[17];
  /* #6: @3 = (1./@2) */
  w3 = (1./ w2 );
  /* #7: output[0][1] = @3 */
  if (res[0]) res[0][1] = w3;
  /* #8: @3 = 1 */
  w3 = 1.;
  /* #9: @4 = @0[16] */
  w4 = wr0[16];
  /* #10: @4 = (@4/@2) */
  w4 /= w2;
  /* #11: @3 = (@3+@4) */
  w3 += w4;
  /* #12: output[0][2] = @3 */
  if (res[0]) res[0][2] = w3;
  /* #13: @3 = @0[21] */
  w3 = wr0[21];
  /* #14: @4 = (1./@3) */
  w4 = (1./ w3 );
  /* #15: output[0][3] = @4 */
  if (res[0]) res[0][3] = w4;
  /* #16: @4 = 1 */
  w4 = 1.;
  /* #17: @2 = @0[20] */
  w2 = wr0[20];
  /* #18: @2 = (@2/@3) */
  w2 /= w3;
  /* #19: @4 = (@4+@2) */
  w4 += w2;
  /* #20: output[0][4] = @4 */
  if (res[0]) res[0][4] = w4;
  /* #21: @4 = @0[23] */
  w4 = wr0[23];
  /* #22: @4 = (@4*@1) */
  w4 *= w1;
  /* #23: output[0][5] = @4 */
  if (res[0]) res[0][5] = w4;
  /* #24: @4 = @0[24] */
  w4 = wr0[24];
  /* #25: @4 = (@1/@4) */
  w4  = (w1/w4);
  /* #26: output[0][6] = @4 */
  if (res[0]) res[0][6] = w4;
  /* #27: @4 = @0[28] */
  w4 = wr0[28];
  /* #28: @2 = (@1/@4) */
  w2  = (w1/w4);
  /* #29: output[0][7] = @2 */
  if (res[0]) res[0][7] = w2;
  /* #30: @2 = @0[31] */
  w2 = wr0[31];
  /* #31: @3 = (@2*@1) */
  w3  = (w2*w1);
  /* #32: output[0][8] = @3 */
  if (res[0]) res[0][8] = w3;
  /* #33: @3 = 6.2832 */
  w3 = 6.2831999999999999e+00;
  /* #34: @3 = (@3*@2) */
  w3 *= w2;
  /* #35: @3 = (@3*@1) */
  w3 *= w1;
  /* #36: output[0][9] = @3 */
  if (res[0]) res[0][9] = w3;
  /* #37: @3 = @0[36] */
  w3 = wr0[36];
  /* #38: @3 = (@3*@1) */
  w3 *= w1;
  /* #39: output[0][10] = @3 */
  if (res[0]) res[0][10] = w3;
  /* #40: @3 = @0[38] */
  w3 = wr0[38];
  /* #41: @2 = (@3*@1) */
  w2  = (w3*w1);
  /* #42: output[0][11] = @2 */
  if (res[0]) res[0][11] = w2;
  /* #43: @3 = (@3*@1) */
  w3 *= w1;
  /* #44: @2 = @0[37] */
  w2 = wr0[37];
  /* #45: @3 = (@3/@2) */
  w3 /= w2;
  /* #46: output[0][12] = @3 */
  if (res[0]) res[0][12] = w3;
  /* #47: @3 = @0[39] */
  w3 = wr0[39];
  /* #48: @3 = (@3/@4) */
  w3 /= w4;
  /* #49: output[0][13] = @3 */
  if (res[0]) res[0][13] = w3;
  /* #50: @3 = @0[43] */
  w3 = wr0[43];
  /* #51: @3 = (@3*@1) */
  w3 *= w1;
  /* #52: output[0][14] = @3 */
  if (res[0]) res[0][14] = w3;
  /* #53: @3 = @0[44] */
  w3 = wr0[44];
  /* #54: @3 = (@3*@1) */
  w3 *= w1;
  /* #55: @2 = @0[40] */
  w2 = wr0[40];
  /* #56: @3 = (@3/@2) */
  w3 /= w2;
  /* #57: output[0][15] = @3 */
  if (res[0]) res[0][15] = w3;
  /* #58: @3 = @0[45] */
  w3 = wr0[45];
  /* #59: @3 = (@3*@1) */
  w3 *= w1;
  /* #60: @3 = (@3/@2) */
  w3 /= w2;
  /* #61: output[0][16] = @3 */
  if (res[0]) res[0][16] = w3;
  /* #62: @2 = (@2/@4) */
  w2 /= w4;
  /* #63: output[0][17] = @2 */
  if (res[0]) res[0][17] = w2;
  /* #64: @2 = @0[47] */
  w2 = wr0[47];
  /* #65: @2 = (@2*@1) */
  w2 *= w1;
  /* #66: output[0][18] = @2 */
  if (res[0]) res[0][18] = w2;
  /* #67: @2 = 1.01 */
  w2 = 1.0100000000000000e+00;
  /* #68: @4 = 3050 */
  w4 = 3050.;
  /* #69: @3 = @0[18] */
  w3 = wr0[18];
  /* #70: @4 = fmin(@4,@3) */
  w4  = casadi_fmin(w4,w3);
  /* #71: @2 = (@2*@4) */
  w2 *= w4;
  /* #72: output[0][19] = @2 */
  if (res[0]) res[0][19] = w2;
  /* #73: @2 = 1.01 */
  w2 = 1.0100000000000000e+00;
  /* #74: @4 = 3050 */
  w4 = 3050.;
  /* #75: @3 = @0[22] */
  w3 = wr0[22];
  /* #76: @4 = fmin(@4,@3) */
  w4  = casadi_fmin(w4,w3);
  /* #77: @2 = (@2*@4) */
  w2 *= w4;
  /* #78: output[0][20] = @2 */
  if (res[0]) res[0][20] = w2;
  /* #79: @2 = @0[1] */
  w2 = wr0[1];
  /* #80: @1 = (@1/@2) */
  w1 /= w2;
  /* #81: output[0][21] = @1 */
  if (res[0]) res[0][21] = w1;
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

/* controller_step:(parameters[50],derived[22],states[63],inputs[7])->(next_states[63],outputs[2]) */
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
  casadi_real a108, a109, a110, a111;
  a000=5.0000000000000000e-01;
  a001=arg[2]? arg[2][0] : 0;
  a002=1.;
  a003=arg[2]? arg[2][1] : 0;
  a004=0.;
  a005=(a003<=a004);
  a006=(a000<a001);
  a007=arg[3]? arg[3][2] : 0;
  a008=casadi_fabs(a007);
  a009=arg[0]? arg[0][5] : 0;
  a008=(a008<=a009);
  a007=(a008?a007:0);
  a009=(!a008);
  a010=arg[2]? arg[2][8] : 0;
  a009=(a009?a010:0);
  a007=(a007+a009);
  a009=casadi_fabs(a007);
  a010=arg[0]? arg[0][9] : 0;
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
  a014=arg[0]? arg[0][10] : 0;
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
  a017=arg[3]? arg[3][0] : 0;
  a018=casadi_fabs(a017);
  a019=arg[0]? arg[0][3] : 0;
  a018=(a018<=a019);
  a019=(a018?a002:0);
  a010=casadi_fmin(a010,a019);
  a020=arg[3]? arg[3][3] : 0;
  a021=casadi_fabs(a020);
  a022=arg[0]? arg[0][6] : 0;
  a021=(a021<=a022);
  a022=(a021?a002:0);
  a010=casadi_fmin(a010,a022);
  a023=arg[3]? arg[3][4] : 0;
  a024=casadi_fabs(a023);
  a025=arg[0]? arg[0][7] : 0;
  a024=(a024<=a025);
  a025=(a024?a002:0);
  a010=casadi_fmin(a010,a025);
  a026=arg[2]? arg[2][3] : 0;
  a027=(a002-a026);
  a010=(a010*a027);
  a027=arg[2]? arg[2][19] : 0;
  a028=-1.;
  a029=arg[3]? arg[3][6] : 0;
  a029=(a028+a029);
  a029=casadi_fabs(a029);
  a029=(a029<=a000);
  a029=(a029?a002:0);
  a030=arg[2]? arg[2][18] : 0;
  a030=(a029-a030);
  a027=casadi_fmax(a027,a030);
  a010=(a010*a027);
  a027=(-a010);
  a027=(a006?a027:0);
  a005=(a005?a027:0);
  a005=(a002+a005);
  a001=(a001*a005);
  a005=(a000<a001);
  a027=(a005?a001:0);
  a005=(!a005);
  a030=9998.;
  a008=(a000<a008);
  a031=(!a008);
  a032=arg[2]? arg[2][9] : 0;
  a033=arg[0]? arg[0][0] : 0;
  a034=(a032+a033);
  a035=arg[0]? arg[0][2] : 0;
  a036=(a000*a033);
  a036=(a035+a036);
  a036=(a034<=a036);
  a036=(!a036);
  a036=(a036?a002:0);
  a031=(a031?a036:0);
  a031=(a004<a031);
  a036=3.;
  a036=(a031?a036:0);
  a031=(!a031);
  a037=9999.;
  a031=(a031?a037:0);
  a036=(a036+a031);
  a009=(a000<a009);
  a031=(!a009);
  a038=arg[2]? arg[2][16] : 0;
  a039=(a038+a033);
  a040=(a000*a033);
  a040=(a035+a040);
  a040=(a039<=a040);
  a040=(!a040);
  a040=(a040?a002:0);
  a031=(a031?a040:0);
  a031=(a004<a031);
  a040=4003.;
  a040=(a031?a040:0);
  a031=(!a031);
  a031=(a031?a037:0);
  a040=(a040+a031);
  a036=casadi_fmin(a036,a040);
  a012=(a000<a012);
  a040=(!a012);
  a031=arg[2]? arg[2][15] : 0;
  a041=(a031+a033);
  a042=(a000*a033);
  a042=(a035+a042);
  a042=(a041<=a042);
  a042=(!a042);
  a042=(a042?a002:0);
  a040=(a040?a042:0);
  a040=(a004<a040);
  a042=6.;
  a042=(a040?a042:0);
  a040=(!a040);
  a040=(a040?a037:0);
  a042=(a042+a040);
  a036=casadi_fmin(a036,a042);
  a013=(a000<a013);
  a042=(!a013);
  a040=arg[2]? arg[2][17] : 0;
  a043=(a040+a033);
  a044=(a000*a033);
  a044=(a035+a044);
  a044=(a043<=a044);
  a044=(!a044);
  a044=(a044?a002:0);
  a042=(a042?a044:0);
  a042=(a004<a042);
  a044=4006.;
  a044=(a042?a044:0);
  a042=(!a042);
  a042=(a042?a037:0);
  a044=(a044+a042);
  a036=casadi_fmin(a036,a044);
  a016=(a000<a016);
  a044=(!a016);
  a042=arg[2]? arg[2][7] : 0;
  a045=(a042+a033);
  a046=(a000*a033);
  a046=(a035+a046);
  a046=(a045<=a046);
  a046=(!a046);
  a046=(a046?a002:0);
  a044=(a044?a046:0);
  a044=(a004<a044);
  a046=2.;
  a046=(a044?a046:0);
  a044=(!a044);
  a044=(a044?a037:0);
  a046=(a046+a044);
  a036=casadi_fmin(a036,a046);
  a022=(a000<a022);
  a046=(!a022);
  a044=arg[2]? arg[2][11] : 0;
  a047=(a044+a033);
  a048=(a000*a033);
  a048=(a035+a048);
  a048=(a047<=a048);
  a048=(!a048);
  a048=(a048?a002:0);
  a046=(a046?a048:0);
  a046=(a004<a046);
  a048=4.;
  a048=(a046?a048:0);
  a046=(!a046);
  a046=(a046?a037:0);
  a048=(a048+a046);
  a036=casadi_fmin(a036,a048);
  a019=(a000<a019);
  a048=(!a019);
  a046=arg[2]? arg[2][5] : 0;
  a049=(a046+a033);
  a050=(a000*a033);
  a050=(a035+a050);
  a050=(a049<=a050);
  a050=(!a050);
  a050=(a050?a002:0);
  a048=(a048?a050:0);
  a048=(a004<a048);
  a050=(a048?a002:0);
  a048=(!a048);
  a048=(a048?a037:0);
  a050=(a050+a048);
  a036=casadi_fmin(a036,a050);
  a025=(a000<a025);
  a050=(!a025);
  a048=arg[2]? arg[2][13] : 0;
  a051=(a048+a033);
  a052=(a000*a033);
  a052=(a035+a052);
  a052=(a051<=a052);
  a052=(!a052);
  a052=(a052?a002:0);
  a050=(a050?a052:0);
  a050=(a004<a050);
  a052=5.;
  a052=(a050?a052:0);
  a050=(!a050);
  a050=(a050?a037:0);
  a052=(a052+a050);
  a036=casadi_fmin(a036,a052);
  a052=(a030<a036);
  a052=(!a052);
  a052=(a052?a036:0);
  a005=(a005?a052:0);
  a027=(a027+a005);
  a005=(a000<a027);
  a027=(a005?a027:0);
  a005=(!a005);
  a052=arg[2]? arg[2][2] : 0;
  a036=(a000<a052);
  a050=arg[2]? arg[2][29] : 0;
  a050=(a036?a050:0);
  a036=(!a036);
  a036=(a036?a007:0);
  a050=(a050+a036);
  a036=arg[1]? arg[1][6] : 0;
  a053=arg[2]? arg[2][61] : 0;
  a054=(a053*a003);
  a020=(a021?a020:0);
  a021=(!a021);
  a055=arg[2]? arg[2][10] : 0;
  a021=(a021?a055:0);
  a020=(a020+a021);
  a021=(a054-a020);
  a036=(a036*a021);
  a036=(a050+a036);
  a021=arg[1]? arg[1][5] : 0;
  a050=(a007-a050);
  a050=(a021*a050);
  a036=(a036+a050);
  a050=(a036-a007);
  a050=casadi_fabs(a050);
  a055=arg[0]? arg[0][25] : 0;
  a055=(a050<=a055);
  a055=(a055?a002:0);
  a055=(a000<a055);
  a056=(!a055);
  a057=arg[2]? arg[2][30] : 0;
  a058=(a057+a033);
  a059=(a000*a033);
  a059=(a035+a059);
  a059=(a058<=a059);
  a059=(!a059);
  a059=(a059?a002:0);
  a056=(a056?a059:0);
  a056=(a004<a056);
  a059=5003.;
  a059=(a056?a059:0);
  a056=(!a056);
  a056=(a056?a037:0);
  a059=(a059+a056);
  a056=arg[0]? arg[0][26] : 0;
  a060=(a050-a056);
  a061=arg[2]? arg[2][31] : 0;
  a061=(a007==a061);
  a062=(a000<a052);
  a063=arg[2]? arg[2][32] : 0;
  a062=(a062?a063:0);
  a062=(a062+a033);
  a061=(a061?a062:0);
  a062=arg[0]? arg[0][27] : 0;
  a063=(a061-a062);
  a060=casadi_fmin(a060,a063);
  a060=(a004<a060);
  a063=3003.;
  a063=(a060?a063:0);
  a060=(!a060);
  a060=(a060?a037:0);
  a063=(a063+a060);
  a059=casadi_fmin(a059,a063);
  a063=-5.5000000000000000e+00;
  a060=(a000<a052);
  a064=arg[2]? arg[2][51] : 0;
  a060=(a060?a064:0);
  a064=arg[1]? arg[1][8] : 0;
  a060=(a060-a064);
  a060=casadi_fmax(a004,a060);
  a065=arg[0]? arg[0][34] : 0;
  a066=(a000<a052);
  a067=arg[2]? arg[2][49] : 0;
  a068=(-a067);
  a068=(a066?a068:0);
  a068=(a054+a068);
  a069=(a065<a068);
  a070=(a069?a002:0);
  a069=(!a069);
  a065=(-a065);
  a065=(a068<a065);
  a071=(a065?a028:0);
  a065=(!a065);
  a072=arg[2]? arg[2][50] : 0;
  a065=(a065?a072:0);
  a071=(a071+a065);
  a069=(a069?a071:0);
  a070=(a070+a069);
  a072=(a070==a072);
  a072=(!a072);
  a072=(a072?a002:0);
  a060=(a060+a072);
  a072=(a063+a060);
  a072=(a004<a072);
  a069=8001.;
  a069=(a072?a069:0);
  a072=(!a072);
  a072=(a072?a037:0);
  a069=(a069+a072);
  a059=casadi_fmin(a059,a069);
  a069=(a000<a052);
  a072=arg[2]? arg[2][36] : 0;
  a072=(a069?a072:0);
  a069=(!a069);
  a069=(a069?a011:0);
  a072=(a072+a069);
  a069=arg[1]? arg[1][7] : 0;
  a071=arg[2]? arg[2][62] : 0;
  a065=(a071*a003);
  a023=(a024?a023:0);
  a024=(!a024);
  a073=arg[2]? arg[2][12] : 0;
  a024=(a024?a073:0);
  a023=(a023+a024);
  a024=(a065+a023);
  a069=(a069*a024);
  a069=(a072+a069);
  a072=(a011-a072);
  a021=(a021*a072);
  a069=(a069+a021);
  a021=(a069-a011);
  a021=casadi_fabs(a021);
  a072=arg[0]? arg[0][29] : 0;
  a072=(a021<=a072);
  a072=(a072?a002:0);
  a072=(a000<a072);
  a024=(!a072);
  a073=arg[2]? arg[2][37] : 0;
  a074=(a073+a033);
  a075=(a000*a033);
  a075=(a035+a075);
  a075=(a074<=a075);
  a075=(!a075);
  a075=(a075?a002:0);
  a024=(a024?a075:0);
  a024=(a004<a024);
  a075=5006.;
  a075=(a024?a075:0);
  a024=(!a024);
  a024=(a024?a037:0);
  a075=(a075+a024);
  a059=casadi_fmin(a059,a075);
  a075=arg[0]? arg[0][30] : 0;
  a024=(a021-a075);
  a076=arg[2]? arg[2][38] : 0;
  a076=(a011==a076);
  a077=(a000<a052);
  a078=arg[2]? arg[2][39] : 0;
  a077=(a077?a078:0);
  a077=(a077+a033);
  a076=(a076?a077:0);
  a077=(a076-a062);
  a024=casadi_fmin(a024,a077);
  a024=(a004<a024);
  a077=3006.;
  a077=(a024?a077:0);
  a024=(!a024);
  a024=(a024?a037:0);
  a077=(a077+a024);
  a059=casadi_fmin(a059,a077);
  a077=(a000<a052);
  a024=arg[2]? arg[2][54] : 0;
  a077=(a077?a024:0);
  a077=(a077-a064);
  a077=casadi_fmax(a004,a077);
  a024=arg[0]? arg[0][35] : 0;
  a078=(a000<a052);
  a079=arg[2]? arg[2][52] : 0;
  a080=(-a079);
  a080=(a078?a080:0);
  a080=(a065+a080);
  a081=(a024<a080);
  a082=(a081?a002:0);
  a081=(!a081);
  a024=(-a024);
  a024=(a080<a024);
  a083=(a024?a028:0);
  a024=(!a024);
  a084=arg[2]? arg[2][53] : 0;
  a024=(a024?a084:0);
  a083=(a083+a024);
  a081=(a081?a083:0);
  a082=(a082+a081);
  a084=(a082==a084);
  a084=(!a084);
  a084=(a084?a002:0);
  a077=(a077+a084);
  a084=(a063+a077);
  a084=(a004<a084);
  a081=8002.;
  a081=(a084?a081:0);
  a084=(!a084);
  a084=(a084?a037:0);
  a081=(a081+a084);
  a059=casadi_fmin(a059,a081);
  a050=(a050-a056);
  a056=arg[2]? arg[2][33] : 0;
  a056=(a020==a056);
  a081=(a000<a052);
  a084=arg[2]? arg[2][34] : 0;
  a081=(a081?a084:0);
  a081=(a081+a033);
  a056=(a056?a081:0);
  a081=(a056-a062);
  a050=casadi_fmin(a050,a081);
  a081=-5.0000000000000003e-02;
  a084=arg[0]? arg[0][18] : 0;
  a083=(a081*a084);
  a024=(a004<a056);
  a085=arg[2]? arg[2][35] : 0;
  a085=(a024?a085:0);
  a024=(!a024);
  a024=(a024?a054:0);
  a085=(a085+a024);
  a054=(a054-a085);
  a054=casadi_fabs(a054);
  a083=(a083+a054);
  a050=casadi_fmin(a050,a083);
  a050=(a004<a050);
  a083=3004.;
  a083=(a050?a083:0);
  a050=(!a050);
  a050=(a050?a037:0);
  a083=(a083+a050);
  a059=casadi_fmin(a059,a083);
  a083=(a000<a052);
  a050=arg[2]? arg[2][45] : 0;
  a083=(a083?a050:0);
  a083=(a083-a064);
  a083=casadi_fmax(a004,a083);
  a050=arg[0]? arg[0][32] : 0;
  a054=(a000<a052);
  a024=arg[2]? arg[2][43] : 0;
  a024=(a054?a024:0);
  a054=(!a054);
  a054=(a054?a020:0);
  a024=(a024+a054);
  a054=(a020-a024);
  a086=(a050<a054);
  a087=(a086?a002:0);
  a086=(!a086);
  a050=(-a050);
  a050=(a054<a050);
  a088=(a050?a028:0);
  a050=(!a050);
  a089=arg[2]? arg[2][44] : 0;
  a050=(a050?a089:0);
  a088=(a088+a050);
  a086=(a086?a088:0);
  a087=(a087+a086);
  a089=(a087==a089);
  a089=(!a089);
  a089=(a089?a002:0);
  a083=(a083+a089);
  a089=(a063+a083);
  a089=(a004<a089);
  a086=6004.;
  a086=(a089?a086:0);
  a089=(!a089);
  a089=(a089?a037:0);
  a086=(a086+a089);
  a059=casadi_fmin(a059,a086);
  a021=(a021-a075);
  a075=arg[2]? arg[2][40] : 0;
  a075=(a023==a075);
  a086=(a000<a052);
  a089=arg[2]? arg[2][41] : 0;
  a086=(a086?a089:0);
  a086=(a086+a033);
  a075=(a075?a086:0);
  a062=(a075-a062);
  a021=casadi_fmin(a021,a062);
  a062=arg[0]? arg[0][22] : 0;
  a081=(a081*a062);
  a086=(a004<a075);
  a089=arg[2]? arg[2][42] : 0;
  a089=(a086?a089:0);
  a086=(!a086);
  a086=(a086?a065:0);
  a089=(a089+a086);
  a065=(a065-a089);
  a065=casadi_fabs(a065);
  a081=(a081+a065);
  a021=casadi_fmin(a021,a081);
  a021=(a004<a021);
  a081=3005.;
  a081=(a021?a081:0);
  a021=(!a021);
  a021=(a021?a037:0);
  a081=(a081+a021);
  a059=casadi_fmin(a059,a081);
  a081=(a000<a052);
  a021=arg[2]? arg[2][48] : 0;
  a081=(a081?a021:0);
  a081=(a081-a064);
  a081=casadi_fmax(a004,a081);
  a064=arg[0]? arg[0][33] : 0;
  a021=(a000<a052);
  a065=arg[2]? arg[2][46] : 0;
  a065=(a021?a065:0);
  a021=(!a021);
  a021=(a021?a023:0);
  a065=(a065+a021);
  a021=(a023-a065);
  a086=(a064<a021);
  a088=(a086?a002:0);
  a086=(!a086);
  a064=(-a064);
  a064=(a021<a064);
  a028=(a064?a028:0);
  a064=(!a064);
  a050=arg[2]? arg[2][47] : 0;
  a064=(a064?a050:0);
  a028=(a028+a064);
  a086=(a086?a028:0);
  a088=(a088+a086);
  a050=(a088==a050);
  a050=(!a050);
  a050=(a050?a002:0);
  a081=(a081+a050);
  a063=(a063+a081);
  a063=(a004<a063);
  a050=6005.;
  a050=(a063?a050:0);
  a063=(!a063);
  a063=(a063?a037:0);
  a050=(a050+a063);
  a059=casadi_fmin(a059,a050);
  a050=(a030<a059);
  a050=(!a050);
  a050=(a050?a059:0);
  a005=(a005?a050:0);
  a027=(a027+a005);
  a005=(a000<a027);
  a027=(a005?a027:0);
  a005=(!a005);
  a050=arg[0]? arg[0][15] : 0;
  a084=(a050*a084);
  a059=casadi_fabs(a007);
  a050=casadi_fmax(a050,a059);
  a084=(a084/a050);
  a050=arg[1]? arg[1][2] : 0;
  a059=arg[1]? arg[1][1] : 0;
  a063=(a007*a059);
  a063=(a050+a063);
  a063=casadi_fmin(a002,a063);
  a063=casadi_fmax(a004,a063);
  a063=(a084*a063);
  a086=(-a063);
  a059=(a007*a059);
  a050=(a050-a059);
  a050=casadi_fmin(a002,a050);
  a050=casadi_fmax(a004,a050);
  a084=(a084*a050);
  a050=arg[0]? arg[0][14] : 0;
  a059=arg[2]? arg[2][27] : 0;
  a059=(a050!=a059);
  a028=arg[1]? arg[1][0] : 0;
  a064=(a000<a052);
  a090=arg[2]? arg[2][26] : 0;
  a090=(a064?a090:0);
  a064=(!a064);
  a064=(a064?a050:0);
  a090=(a090+a064);
  a064=(a050-a090);
  a091=casadi_fabs(a064);
  a091=(a028*a091);
  a092=9.9999999999999995e-07;
  a093=casadi_fabs(a050);
  a093=(a092*a093);
  a094=casadi_fabs(a090);
  a094=(a092*a094);
  a093=(a093+a094);
  a091=casadi_fmax(a091,a093);
  a091=(a059?a091:0);
  a059=(!a059);
  a093=arg[2]? arg[2][28] : 0;
  a059=(a059?a093:0);
  a091=(a091+a059);
  a059=(a091<a064);
  a093=(a090+a091);
  a093=(a059?a093:0);
  a059=(!a059);
  a094=(-a091);
  a094=(a064<a094);
  a090=(a090-a091);
  a090=(a094?a090:0);
  a094=(!a094);
  a094=(a094?a050:0);
  a090=(a090+a094);
  a059=(a059?a090:0);
  a093=(a093+a059);
  a059=(a011-a007);
  a059=(a093*a059);
  a090=arg[0]? arg[0][48] : 0;
  a094=(a002-a090);
  a063=(a063*a094);
  a063=(-a063);
  a094=(a000<a052);
  a095=arg[2]? arg[2][60] : 0;
  a094=(a094?a095:0);
  a095=arg[0]? arg[0][41] : 0;
  a096=(a000<a052);
  a097=arg[2]? arg[2][57] : 0;
  a097=(a096?a097:0);
  a096=(!a096);
  a098=arg[1]? arg[1][13] : 0;
  a099=arg[0]? arg[0][19] : 0;
  a062=(a099*a062);
  a100=casadi_fabs(a011);
  a099=casadi_fmax(a099,a100);
  a062=(a062/a099);
  a099=arg[1]? arg[1][4] : 0;
  a100=arg[1]? arg[1][3] : 0;
  a101=(a011*a100);
  a101=(a099+a101);
  a101=casadi_fmin(a002,a101);
  a101=casadi_fmax(a004,a101);
  a101=(a062*a101);
  a101=(-a101);
  a100=(a011*a100);
  a099=(a099-a100);
  a099=casadi_fmin(a002,a099);
  a099=casadi_fmax(a004,a099);
  a062=(a062*a099);
  a099=arg[0]? arg[0][38] : 0;
  a099=(a004<a099);
  a100=(a000<a052);
  a102=arg[2]? arg[2][20] : 0;
  a102=(a100?a102:0);
  a100=(!a100);
  a103=arg[0]? arg[0][11] : 0;
  a100=(a100?a103:0);
  a102=(a102+a100);
  a100=arg[2]? arg[2][21] : 0;
  a100=(a103!=a100);
  a104=(a103-a102);
  a105=casadi_fabs(a104);
  a105=(a028*a105);
  a106=casadi_fabs(a103);
  a106=(a092*a106);
  a107=casadi_fabs(a102);
  a107=(a092*a107);
  a106=(a106+a107);
  a105=casadi_fmax(a105,a106);
  a105=(a100?a105:0);
  a100=(!a100);
  a106=arg[2]? arg[2][22] : 0;
  a100=(a100?a106:0);
  a105=(a105+a100);
  a100=(a105<a104);
  a106=(a102+a105);
  a106=(a100?a106:0);
  a100=(!a100);
  a107=(-a105);
  a107=(a104<a107);
  a108=(a102-a105);
  a108=(a107?a108:0);
  a107=(!a107);
  a107=(a107?a103:0);
  a108=(a108+a107);
  a100=(a100?a108:0);
  a106=(a106+a100);
  a102=(a102-a106);
  a102=(a023*a102);
  a102=(-a102);
  a099=(a099?a102:0);
  a102=(a000<a052);
  a100=arg[2]? arg[2][56] : 0;
  a102=(a102?a100:0);
  a099=(a099+a102);
  a102=(a000<a052);
  a100=arg[2]? arg[2][55] : 0;
  a100=(a102?a100:0);
  a102=(!a102);
  a102=(a102?a011:0);
  a100=(a100+a102);
  a102=arg[1]? arg[1][10] : 0;
  a108=(-a102);
  a014=(a015?a014:0);
  a015=(!a015);
  a107=arg[2]? arg[2][6] : 0;
  a015=(a015?a107:0);
  a014=(a014+a015);
  a015=(a014-a100);
  a102=casadi_fmin(a102,a015);
  a108=casadi_fmax(a108,a102);
  a100=(a100+a108);
  a108=(a100-a011);
  a102=arg[0]? arg[0][37] : 0;
  a102=(a108*a102);
  a102=(a099+a102);
  a015=(a023*a106);
  a102=(a102-a015);
  a062=casadi_fmin(a062,a102);
  a101=casadi_fmax(a101,a062);
  a062=(a101+a023);
  a098=(a098*a062);
  a098=(a020+a098);
  a096=(a096?a098:0);
  a097=(a097+a096);
  a096=arg[1]? arg[1][14] : 0;
  a015=(-a096);
  a017=(a018?a017:0);
  a018=(!a018);
  a107=arg[2]? arg[2][4] : 0;
  a018=(a018?a107:0);
  a017=(a017+a018);
  a018=(a017-a097);
  a096=casadi_fmin(a096,a018);
  a015=casadi_fmax(a015,a096);
  a097=(a097+a015);
  a095=(a095*a097);
  a095=(a094+a095);
  a015=(a000<a052);
  a096=arg[2]? arg[2][58] : 0;
  a096=(a015?a096:0);
  a015=(!a015);
  a015=(a015?a098:0);
  a096=(a096+a015);
  a015=(a000<a052);
  a018=arg[2]? arg[2][59] : 0;
  a107=(a015?a018:0);
  a109=arg[1]? arg[1][15] : 0;
  a110=(a097-a096);
  a109=(a109*a110);
  a107=(a107+a109);
  a109=arg[1]? arg[1][16] : 0;
  a109=(a109*a018);
  a109=(-a109);
  a015=(a015?a109:0);
  a107=(a107+a015);
  a015=(a107*a033);
  a096=(a096+a015);
  a015=arg[0]? arg[0][46] : 0;
  a109=(a096*a015);
  a109=(a109-a098);
  a015=(a002-a015);
  a015=(a097*a015);
  a109=(a109+a015);
  a015=arg[0]? arg[0][42] : 0;
  a015=(a109*a015);
  a095=(a095+a015);
  a015=arg[1]? arg[1][17] : 0;
  a015=(a015*a062);
  a062=arg[0]? arg[0][12] : 0;
  a098=arg[2]? arg[2][24] : 0;
  a098=(a062!=a098);
  a052=(a000<a052);
  a018=arg[2]? arg[2][23] : 0;
  a018=(a052?a018:0);
  a052=(!a052);
  a052=(a052?a062:0);
  a018=(a018+a052);
  a052=(a062-a018);
  a110=casadi_fabs(a052);
  a028=(a028*a110);
  a110=casadi_fabs(a062);
  a110=(a092*a110);
  a111=casadi_fabs(a018);
  a092=(a092*a111);
  a110=(a110+a092);
  a028=casadi_fmax(a028,a110);
  a028=(a098?a028:0);
  a098=(!a098);
  a110=arg[2]? arg[2][25] : 0;
  a098=(a098?a110:0);
  a028=(a028+a098);
  a098=(a028<a052);
  a110=(a018+a028);
  a110=(a098?a110:0);
  a098=(!a098);
  a092=(-a028);
  a092=(a052<a092);
  a018=(a018-a028);
  a018=(a092?a018:0);
  a092=(!a092);
  a092=(a092?a062:0);
  a018=(a018+a092);
  a098=(a098?a018:0);
  a110=(a110+a098);
  a015=(a015*a110);
  a095=(a095+a015);
  a090=(a002-a090);
  a090=(a084*a090);
  a090=casadi_fmin(a095,a090);
  a063=casadi_fmax(a063,a090);
  a059=(a059+a063);
  a084=casadi_fmin(a084,a059);
  a086=casadi_fmax(a086,a084);
  a084=casadi_fabs(a086);
  a059=arg[1]? arg[1][19] : 0;
  a084=(a084<=a059);
  a059=(a084?a002:0);
  a059=(a059<a002);
  a090=7001.;
  a090=(a059?a090:0);
  a059=(!a059);
  a059=(a059?a037:0);
  a090=(a090+a059);
  a059=casadi_fabs(a101);
  a015=arg[1]? arg[1][20] : 0;
  a059=(a059<=a015);
  a015=(a059?a002:0);
  a015=(a015<a002);
  a098=7002.;
  a098=(a015?a098:0);
  a015=(!a015);
  a015=(a015?a037:0);
  a098=(a098+a015);
  a090=casadi_fmin(a090,a098);
  a030=(a030<a090);
  a030=(!a030);
  a030=(a030?a090:0);
  a005=(a005?a030:0);
  a027=(a027+a005);
  if (res[0]!=0) res[0][0]=a027;
  a005=(a000<a027);
  a030=arg[1]? arg[1][21] : 0;
  a090=(-a030);
  a090=(a005?a090:0);
  a005=(!a005);
  a005=(a005?a030:0);
  a090=(a090+a005);
  a003=(a003+a090);
  a003=casadi_fmax(a004,a003);
  a003=casadi_fmin(a002,a003);
  if (res[0]!=0) res[0][1]=a003;
  a090=(a000<a027);
  a090=(!a090);
  a090=(a090?a002:0);
  if (res[0]!=0) res[0][2]=a090;
  if (res[0]!=0) res[0][3]=a026;
  if (res[0]!=0) res[0][4]=a017;
  a046=casadi_fmin(a046,a035);
  a046=(a046-a033);
  a046=casadi_fmax(a004,a046);
  a046=(a019?a046:0);
  a019=(!a019);
  a019=(a019?a049:0);
  a046=(a046+a019);
  if (res[0]!=0) res[0][5]=a046;
  if (res[0]!=0) res[0][6]=a014;
  a042=casadi_fmin(a042,a035);
  a042=(a042-a033);
  a042=casadi_fmax(a004,a042);
  a042=(a016?a042:0);
  a016=(!a016);
  a016=(a016?a045:0);
  a042=(a042+a016);
  if (res[0]!=0) res[0][7]=a042;
  if (res[0]!=0) res[0][8]=a007;
  a032=casadi_fmin(a032,a035);
  a032=(a032-a033);
  a032=casadi_fmax(a004,a032);
  a032=(a008?a032:0);
  a008=(!a008);
  a008=(a008?a034:0);
  a032=(a032+a008);
  if (res[0]!=0) res[0][9]=a032;
  if (res[0]!=0) res[0][10]=a020;
  a044=casadi_fmin(a044,a035);
  a044=(a044-a033);
  a044=casadi_fmax(a004,a044);
  a044=(a022?a044:0);
  a022=(!a022);
  a022=(a022?a047:0);
  a044=(a044+a022);
  if (res[0]!=0) res[0][11]=a044;
  if (res[0]!=0) res[0][12]=a023;
  a048=casadi_fmin(a048,a035);
  a048=(a048-a033);
  a048=casadi_fmax(a004,a048);
  a048=(a025?a048:0);
  a025=(!a025);
  a025=(a025?a051:0);
  a048=(a048+a025);
  if (res[0]!=0) res[0][13]=a048;
  if (res[0]!=0) res[0][14]=a011;
  a031=casadi_fmin(a031,a035);
  a031=(a031-a033);
  a031=casadi_fmax(a004,a031);
  a031=(a012?a031:0);
  a012=(!a012);
  a012=(a012?a041:0);
  a031=(a031+a012);
  if (res[0]!=0) res[0][15]=a031;
  a038=casadi_fmin(a038,a035);
  a038=(a038-a033);
  a038=casadi_fmax(a004,a038);
  a038=(a009?a038:0);
  a009=(!a009);
  a009=(a009?a039:0);
  a038=(a038+a009);
  if (res[0]!=0) res[0][16]=a038;
  a040=casadi_fmin(a040,a035);
  a040=(a040-a033);
  a040=casadi_fmax(a004,a040);
  a040=(a013?a040:0);
  a013=(!a013);
  a013=(a013?a043:0);
  a040=(a040+a013);
  if (res[0]!=0) res[0][17]=a040;
  if (res[0]!=0) res[0][18]=a029;
  a001=(a000<a001);
  a006=(a006?a010:0);
  a001=(a001?a006:0);
  if (res[0]!=0) res[0][19]=a001;
  if (res[0]!=0) res[0][20]=a106;
  if (res[0]!=0) res[0][21]=a103;
  a104=casadi_fabs(a104);
  a104=(a105<a104);
  a104=(a104?a105:0);
  if (res[0]!=0) res[0][22]=a104;
  if (res[0]!=0) res[0][23]=a110;
  if (res[0]!=0) res[0][24]=a062;
  a052=casadi_fabs(a052);
  a052=(a028<a052);
  a052=(a052?a028:0);
  if (res[0]!=0) res[0][25]=a052;
  if (res[0]!=0) res[0][26]=a093;
  if (res[0]!=0) res[0][27]=a050;
  a064=casadi_fabs(a064);
  a064=(a091<a064);
  a064=(a064?a091:0);
  if (res[0]!=0) res[0][28]=a064;
  if (res[0]!=0) res[0][29]=a036;
  a057=casadi_fmin(a057,a035);
  a057=(a057-a033);
  a057=casadi_fmax(a004,a057);
  a057=(a055?a057:0);
  a055=(!a055);
  a055=(a055?a058:0);
  a057=(a057+a055);
  if (res[0]!=0) res[0][30]=a057;
  if (res[0]!=0) res[0][31]=a007;
  if (res[0]!=0) res[0][32]=a061;
  if (res[0]!=0) res[0][33]=a020;
  if (res[0]!=0) res[0][34]=a056;
  if (res[0]!=0) res[0][35]=a085;
  if (res[0]!=0) res[0][36]=a069;
  a073=casadi_fmin(a073,a035);
  a073=(a073-a033);
  a073=casadi_fmax(a004,a073);
  a073=(a072?a073:0);
  a072=(!a072);
  a072=(a072?a074:0);
  a073=(a073+a072);
  if (res[0]!=0) res[0][37]=a073;
  if (res[0]!=0) res[0][38]=a011;
  if (res[0]!=0) res[0][39]=a076;
  if (res[0]!=0) res[0][40]=a023;
  if (res[0]!=0) res[0][41]=a075;
  if (res[0]!=0) res[0][42]=a089;
  a089=arg[1]? arg[1][9] : 0;
  a054=(a054*a089);
  a024=(a024+a054);
  if (res[0]!=0) res[0][43]=a024;
  if (res[0]!=0) res[0][44]=a087;
  if (res[0]!=0) res[0][45]=a083;
  a021=(a021*a089);
  a065=(a065+a021);
  if (res[0]!=0) res[0][46]=a065;
  if (res[0]!=0) res[0][47]=a088;
  if (res[0]!=0) res[0][48]=a081;
  a066=(a066?a067:0);
  a068=(a068*a089);
  a066=(a066+a068);
  if (res[0]!=0) res[0][49]=a066;
  if (res[0]!=0) res[0][50]=a070;
  if (res[0]!=0) res[0][51]=a060;
  a078=(a078?a079:0);
  a080=(a080*a089);
  a078=(a078+a080);
  if (res[0]!=0) res[0][52]=a078;
  if (res[0]!=0) res[0][53]=a082;
  if (res[0]!=0) res[0][54]=a077;
  if (res[0]!=0) res[0][55]=a100;
  a102=(a101-a102);
  a100=arg[1]? arg[1][12] : 0;
  a102=(a102*a100);
  a099=(a099+a102);
  a102=arg[1]? arg[1][11] : 0;
  a108=(a108*a102);
  a099=(a099+a108);
  if (res[0]!=0) res[0][56]=a099;
  if (res[0]!=0) res[0][57]=a097;
  if (res[0]!=0) res[0][58]=a096;
  if (res[0]!=0) res[0][59]=a107;
  a095=(a095-a063);
  a095=(a109*a095);
  a004=(a004<a095);
  a095=(a004?a094:0);
  a004=(!a004);
  a063=arg[0]? arg[0][49] : 0;
  a107=(-a063);
  a096=arg[1]? arg[1][18] : 0;
  a109=(a109*a096);
  a094=(a094+a109);
  a063=casadi_fmin(a063,a094);
  a107=casadi_fmax(a107,a063);
  a004=(a004?a107:0);
  a095=(a095+a004);
  if (res[0]!=0) res[0][60]=a095;
  a095=(a000<a027);
  a004=(a095?a053:0);
  a095=(!a095);
  a086=(a084?a086:0);
  a084=(!a084);
  a084=(a084?a053:0);
  a086=(a086+a084);
  a095=(a095?a086:0);
  a004=(a004+a095);
  if (res[0]!=0) res[0][61]=a004;
  a000=(a000<a027);
  a027=(a000?a071:0);
  a000=(!a000);
  a101=(a059?a101:0);
  a059=(!a059);
  a059=(a059?a071:0);
  a101=(a101+a059);
  a000=(a000?a101:0);
  a027=(a027+a000);
  if (res[0]!=0) res[0][62]=a027;
  a000=-3050.;
  a101=3050.;
  a004=(a004*a003);
  a004=casadi_fmin(a101,a004);
  a004=casadi_fmax(a000,a004);
  if (res[1]!=0) res[1][0]=a004;
  a027=(a027*a003);
  a101=casadi_fmin(a101,a027);
  a000=casadi_fmax(a000,a101);
  if (res[1]!=0) res[1][1]=a000;
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


