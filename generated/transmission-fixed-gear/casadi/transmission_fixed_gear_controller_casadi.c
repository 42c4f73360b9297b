/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) transmission_fixed_gear_controller_casadi_ ## ID
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
CASADI_SYMBOL_EXPORT void transmission_fixed_gear_controller_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int transmission_fixed_gear_controller_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int transmission_fixed_gear_controller_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {54, 1, 1};
static const casadi_int casadi_s1[3] = {23, 1, 1};
static const casadi_int casadi_s2[3] = {66, 1, 1};
static const casadi_int casadi_s3[3] = {8, 1, 1};
static const casadi_int casadi_s4[3] = {2, 1, 1};

static const casadi_real casadi_zeros[54] = 
  {0.};

/* controller_prepare:(parameters[54])->(derived[23]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real w1, w2, w3, w4;
  const casadi_real *wr0;
  /* #0: @0 = input[0][0] */
  wr0 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = @0[0] */
  w1 = wr0[0];
  /* #2: @2 = @0[14] */
  w2 = wr0[14];
  /* #3: @2 = (@1/@2) */
  w2  = (w1/w2);
  /* #4: output[0][0] = @2 */
  if (res[0]) res[0][0] = w2;
  /* #5: @2 = @0[18] */
  w2 = wr0[18];
  /* #6: @3 = (1./@2) */
  w3 = (1./ w2 );
  /* #7: output[0][1] = @3 */
  if (res[0]) res[0][1] = w3;
  /* #8: @3 = 1 */
  w3 = 1.;
  /* #9: @4 = @0[17] */
  w4 = wr0[17];
  /* #10: @4 = (@4/@2) */
  w4 /= w2;
  /* #11: @3 = (@3+@4) */
  w3 += w4;
  /* #12: output[0][2] = @3 */
  if (res[0]) res[0][2] = w3;
  /* #13: @3 = @0[22] */
  w3 = wr0[22];
  /* #14: @4 = (1./@3) */
  w4 = (1./ w3 );
  /* #15: output[0][3] = @4 */
  if (res[0]) res[0][3] = w4;
  /* #16: @4 = 1 */
  w4 = 1.;
  /* #17: @2 = @0[21] */
  w2 = wr0[21];
  /* #18: @2 = (@2/@3) */
  w2 /= w3;
  /* #19: @4 = (@4+@2) */
  w4 += w2;
  /* #20: output[0][4] = @4 */
  if (res[0]) res[0][4] = w4;
  /* #21: @4 = @0[26] */
  w4 = wr0[26];
  /* #22: @4 = (@4*@1) */
  w4 *= w1;
  /* #23: output[0][5] = @4 */
  if (res[0]) res[0][5] = w4;
  /* #24: @4 = (1./@1) */
  w4 = (1./ w1 );
  /* #25: output[0][6] = @4 */
  if (res[0]) res[0][6] = w4;
  /* #26: @4 = @0[27] */
  w4 = wr0[27];
  /* #27: @4 = (@4*@1) */
  w4 *= w1;
  /* #28: output[0][7] = @4 */
  if (res[0]) res[0][7] = w4;
  /* #29: @4 = @0[28] */
  w4 = wr0[28];
  /* #30: @4 = (@1/@4) */
  w4  = (w1/w4);
  /* #31: output[0][8] = @4 */
  if (res[0]) res[0][8] = w4;
  /* #32: @4 = @0[32] */
  w4 = wr0[32];
  /* #33: @2 = (@1/@4) */
  w2  = (w1/w4);
  /* #34: output[0][9] = @2 */
  if (res[0]) res[0][9] = w2;
  /* #35: @2 = @0[35] */
  w2 = wr0[35];
  /* #36: @3 = (@2*@1) */
  w3  = (w2*w1);
  /* #37: output[0][10] = @3 */
  if (res[0]) res[0][10] = w3;
  /* #38: @3 = 6.2832 */
  w3 = 6.2831999999999999e+00;
  /* #39: @3 = (@3*@2) */
  w3 *= w2;
  /* #40: @3 = (@3*@1) */
  w3 *= w1;
  /* #41: output[0][11] = @3 */
  if (res[0]) res[0][11] = w3;
  /* #42: @3 = @0[40] */
  w3 = wr0[40];
  /* #43: @3 = (@3*@1) */
  w3 *= w1;
  /* #44: output[0][12] = @3 */
  if (res[0]) res[0][12] = w3;
  /* #45: @3 = @0[42] */
  w3 = wr0[42];
  /* #46: @2 = (@3*@1) */
  w2  = (w3*w1);
  /* #47: output[0][13] = @2 */
  if (res[0]) res[0][13] = w2;
  /* #48: @3 = (@3*@1) */
  w3 *= w1;
  /* #49: @2 = @0[41] */
  w2 = wr0[41];
  /* #50: @3 = (@3/@2) */
  w3 /= w2;
  /* #51: output[0][14] = @3 */
  if (res[0]) res[0][14] = w3;
  /* #52: @3 = @0[43] */
  w3 = wr0[43];
  /* #53: @3 = (@3/@4) */
  w3 /= w4;
  /* #54: output[0][15] = @3 */
  if (res[0]) res[0][15] = w3;
  /* #55: @3 = @0[47] */
  w3 = wr0[47];
  /* #56: @3 = (@3*@1) */
  w3 *= w1;
  /* #57: output[0][16] = @3 */
  if (res[0]) res[0][16] = w3;
  /* #58: @3 = @0[48] */
  w3 = wr0[48];
  /* #59: @3 = (@3*@1) */
  w3 *= w1;
  /* #60: @4 = @0[44] */
  w4 = wr0[44];
  /* #61: @3 = (@3/@4) */
  w3 /= w4;
  /* #62: output[0][17] = @3 */
  if (res[0]) res[0][17] = w3;
  /* #63: @3 = @0[49] */
  w3 = wr0[49];
  /* #64: @3 = (@3*@1) */
  w3 *= w1;
  /* #65: @3 = (@3/@4) */
  w3 /= w4;
  /* #66: output[0][18] = @3 */
  if (res[0]) res[0][18] = w3;
  /* #67: @3 = @0[51] */
  w3 = wr0[51];
  /* #68: @3 = (@3*@1) */
  w3 *= w1;
  /* #69: output[0][19] = @3 */
  if (res[0]) res[0][19] = w3;
  /* #70: @3 = 1.01 */
  w3 = 1.0100000000000000e+00;
  /* #71: @4 = 900 */
  w4 = 900.;
  /* #72: @2 = @0[19] */
  w2 = wr0[19];
  /* #73: @4 = fmin(@4,@2) */
  w4  = casadi_fmin(w4,w2);
  /* #74: @3 = (@3*@4) */
  w3 *= w4;
  /* #75: output[0][20] = @3 */
  if (res[0]) res[0][20] = w3;
  /* #76: @3 = 1.01 */
  w3 = 1.0100000000000000e+00;
  /* #77: @4 = 3300 */
  w4 = 3300.;
  /* #78: @2 = @0[23] */
  w2 = wr0[23];
  /* #79: @4 = fmin(@4,@2) */
  w4  = casadi_fmin(w4,w2);
  /* #80: @3 = (@3*@4) */
  w3 *= w4;
  /* #81: output[0][21] = @3 */
  if (res[0]) res[0][21] = w3;
  /* #82: @3 = @0[1] */
  w3 = wr0[1];
  /* #83: @1 = (@1/@3) */
  w1 /= w3;
  /* #84: output[0][22] = @1 */
  if (res[0]) res[0][22] = w1;
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

/* controller_step:(parameters[54],derived[23],states[66],inputs[8])->(next_states[66],outputs[2]) */
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
  a007=(a008?a007:0);
  a009=(!a008);
  a010=arg[2]? arg[2][10] : 0;
  a009=(a009?a010:0);
  a007=(a007+a009);
  a009=casadi_fabs(a007);
  a010=arg[0]? arg[0][10] : 0;
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
  a014=arg[0]? arg[0][11] : 0;
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
  a017=arg[3]? arg[3][4] : 0;
  a018=casadi_fabs(a017);
  a019=arg[0]? arg[0][7] : 0;
  a018=(a018<=a019);
  a019=(a018?a002:0);
  a010=casadi_fmin(a010,a019);
  a020=arg[3]? arg[3][5] : 0;
  a021=casadi_fabs(a020);
  a022=arg[0]? arg[0][8] : 0;
  a021=(a021<=a022);
  a022=(a021?a002:0);
  a010=casadi_fmin(a010,a022);
  a023=arg[3]? arg[3][0] : 0;
  a024=casadi_fabs(a023);
  a025=arg[0]? arg[0][3] : 0;
  a024=(a024<=a025);
  a025=(a024?a002:0);
  a010=casadi_fmin(a010,a025);
  a026=arg[3]? arg[3][2] : 0;
  a027=casadi_fabs(a026);
  a028=arg[0]? arg[0][5] : 0;
  a027=(a027<=a028);
  a028=(a027?a002:0);
  a010=casadi_fmin(a010,a028);
  a029=arg[2]? arg[2][3] : 0;
  a030=(a002-a029);
  a010=(a010*a030);
  a030=arg[2]? arg[2][21] : 0;
  a031=-1.;
  a032=arg[3]? arg[3][7] : 0;
  a032=(a031+a032);
  a032=casadi_fabs(a032);
  a032=(a032<=a000);
  a032=(a032?a002:0);
  a033=arg[2]? arg[2][20] : 0;
  a033=(a032-a033);
  a030=casadi_fmax(a030,a033);
  a010=(a010*a030);
  a030=(-a010);
  a030=(a006?a030:0);
  a005=(a005?a030:0);
  a005=(a002+a005);
  a001=(a001*a005);
  a005=(a000<a001);
  a030=(a005?a001:0);
  a005=(!a005);
  a033=9998.;
  a008=(a000<a008);
  a034=(!a008);
  a035=arg[2]? arg[2][11] : 0;
  a036=arg[0]? arg[0][0] : 0;
  a037=(a035+a036);
  a038=arg[0]? arg[0][2] : 0;
  a039=(a000*a036);
  a039=(a038+a039);
  a039=(a037<=a039);
  a039=(!a039);
  a039=(a039?a002:0);
  a034=(a034?a039:0);
  a034=(a004<a034);
  a039=4.;
  a039=(a034?a039:0);
  a034=(!a034);
  a040=9999.;
  a034=(a034?a040:0);
  a039=(a039+a034);
  a009=(a000<a009);
  a034=(!a009);
  a041=arg[2]? arg[2][18] : 0;
  a042=(a041+a036);
  a043=(a000*a036);
  a043=(a038+a043);
  a043=(a042<=a043);
  a043=(!a043);
  a043=(a043?a002:0);
  a034=(a034?a043:0);
  a034=(a004<a034);
  a043=4004.;
  a043=(a034?a043:0);
  a034=(!a034);
  a034=(a034?a040:0);
  a043=(a043+a034);
  a039=casadi_fmin(a039,a043);
  a012=(a000<a012);
  a043=(!a012);
  a034=arg[2]? arg[2][17] : 0;
  a044=(a034+a036);
  a045=(a000*a036);
  a045=(a038+a045);
  a045=(a044<=a045);
  a045=(!a045);
  a045=(a045?a002:0);
  a043=(a043?a045:0);
  a043=(a004<a043);
  a045=7.;
  a045=(a043?a045:0);
  a043=(!a043);
  a043=(a043?a040:0);
  a045=(a045+a043);
  a039=casadi_fmin(a039,a045);
  a013=(a000<a013);
  a045=(!a013);
  a043=arg[2]? arg[2][19] : 0;
  a046=(a043+a036);
  a047=(a000*a036);
  a047=(a038+a047);
  a047=(a046<=a047);
  a047=(!a047);
  a047=(a047?a002:0);
  a045=(a045?a047:0);
  a045=(a004<a045);
  a047=4007.;
  a047=(a045?a047:0);
  a045=(!a045);
  a045=(a045?a040:0);
  a047=(a047+a045);
  a039=casadi_fmin(a039,a047);
  a016=(a000<a016);
  a047=(!a016);
  a045=arg[2]? arg[2][7] : 0;
  a048=(a045+a036);
  a049=(a000*a036);
  a049=(a038+a049);
  a049=(a048<=a049);
  a049=(!a049);
  a049=(a049?a002:0);
  a047=(a047?a049:0);
  a047=(a004<a047);
  a049=2.;
  a049=(a047?a049:0);
  a047=(!a047);
  a047=(a047?a040:0);
  a049=(a049+a047);
  a039=casadi_fmin(a039,a049);
  a019=(a000<a019);
  a049=(!a019);
  a047=arg[2]? arg[2][13] : 0;
  a050=(a047+a036);
  a051=(a000*a036);
  a051=(a038+a051);
  a051=(a050<=a051);
  a051=(!a051);
  a051=(a051?a002:0);
  a049=(a049?a051:0);
  a049=(a004<a049);
  a051=5.;
  a051=(a049?a051:0);
  a049=(!a049);
  a049=(a049?a040:0);
  a051=(a051+a049);
  a039=casadi_fmin(a039,a051);
  a022=(a000<a022);
  a051=(!a022);
  a049=arg[2]? arg[2][15] : 0;
  a052=(a049+a036);
  a053=(a000*a036);
  a053=(a038+a053);
  a053=(a052<=a053);
  a053=(!a053);
  a053=(a053?a002:0);
  a051=(a051?a053:0);
  a051=(a004<a051);
  a053=6.;
  a053=(a051?a053:0);
  a051=(!a051);
  a051=(a051?a040:0);
  a053=(a053+a051);
  a039=casadi_fmin(a039,a053);
  a025=(a000<a025);
  a053=(!a025);
  a051=arg[2]? arg[2][5] : 0;
  a054=(a051+a036);
  a055=(a000*a036);
  a055=(a038+a055);
  a055=(a054<=a055);
  a055=(!a055);
  a055=(a055?a002:0);
  a053=(a053?a055:0);
  a053=(a004<a053);
  a055=(a053?a002:0);
  a053=(!a053);
  a053=(a053?a040:0);
  a055=(a055+a053);
  a039=casadi_fmin(a039,a055);
  a028=(a000<a028);
  a055=(!a028);
  a053=arg[2]? arg[2][9] : 0;
  a056=(a053+a036);
  a057=(a000*a036);
  a057=(a038+a057);
  a057=(a056<=a057);
  a057=(!a057);
  a057=(a057?a002:0);
  a055=(a055?a057:0);
  a055=(a004<a055);
  a057=3.;
  a057=(a055?a057:0);
  a055=(!a055);
  a055=(a055?a040:0);
  a057=(a057+a055);
  a039=casadi_fmin(a039,a057);
  a057=(a033<a039);
  a057=(!a057);
  a057=(a057?a039:0);
  a005=(a005?a057:0);
  a030=(a030+a005);
  a005=(a000<a030);
  a030=(a005?a030:0);
  a005=(!a005);
  a057=arg[2]? arg[2][2] : 0;
  a039=(a000<a057);
  a055=arg[2]? arg[2][32] : 0;
  a055=(a039?a055:0);
  a039=(!a039);
  a039=(a039?a007:0);
  a055=(a055+a039);
  a039=arg[1]? arg[1][8] : 0;
  a058=arg[2]? arg[2][64] : 0;
  a059=(a058*a003);
  a017=(a018?a017:0);
  a018=(!a018);
  a060=arg[2]? arg[2][12] : 0;
  a018=(a018?a060:0);
  a017=(a017+a018);
  a018=(a059-a017);
  a039=(a039*a018);
  a039=(a055+a039);
  a018=arg[1]? arg[1][7] : 0;
  a055=(a007-a055);
  a055=(a018*a055);
  a039=(a039+a055);
  a055=(a039-a007);
  a055=casadi_fabs(a055);
  a060=arg[0]? arg[0][29] : 0;
  a060=(a055<=a060);
  a060=(a060?a002:0);
  a060=(a000<a060);
  a061=(!a060);
  a062=arg[2]? arg[2][33] : 0;
  a063=(a062+a036);
  a064=(a000*a036);
  a064=(a038+a064);
  a064=(a063<=a064);
  a064=(!a064);
  a064=(a064?a002:0);
  a061=(a061?a064:0);
  a061=(a004<a061);
  a064=5004.;
  a064=(a061?a064:0);
  a061=(!a061);
  a061=(a061?a040:0);
  a064=(a064+a061);
  a061=arg[0]? arg[0][30] : 0;
  a065=(a055-a061);
  a066=arg[2]? arg[2][34] : 0;
  a066=(a007==a066);
  a067=(a000<a057);
  a068=arg[2]? arg[2][35] : 0;
  a067=(a067?a068:0);
  a067=(a067+a036);
  a066=(a066?a067:0);
  a067=arg[0]? arg[0][31] : 0;
  a068=(a066-a067);
  a065=casadi_fmin(a065,a068);
  a065=(a004<a065);
  a068=3004.;
  a068=(a065?a068:0);
  a065=(!a065);
  a065=(a065?a040:0);
  a068=(a068+a065);
  a064=casadi_fmin(a064,a068);
  a068=-5.5000000000000000e+00;
  a065=(a000<a057);
  a069=arg[2]? arg[2][54] : 0;
  a065=(a065?a069:0);
  a069=arg[1]? arg[1][10] : 0;
  a065=(a065-a069);
  a065=casadi_fmax(a004,a065);
  a070=arg[0]? arg[0][38] : 0;
  a071=(a000<a057);
  a072=arg[2]? arg[2][52] : 0;
  a073=(-a072);
  a073=(a071?a073:0);
  a073=(a059+a073);
  a074=(a070<a073);
  a075=(a074?a002:0);
  a074=(!a074);
  a070=(-a070);
  a070=(a073<a070);
  a076=(a070?a031:0);
  a070=(!a070);
  a077=arg[2]? arg[2][53] : 0;
  a070=(a070?a077:0);
  a076=(a076+a070);
  a074=(a074?a076:0);
  a075=(a075+a074);
  a077=(a075==a077);
  a077=(!a077);
  a077=(a077?a002:0);
  a065=(a065+a077);
  a077=(a068+a065);
  a077=(a004<a077);
  a074=8001.;
  a074=(a077?a074:0);
  a077=(!a077);
  a077=(a077?a040:0);
  a074=(a074+a077);
  a064=casadi_fmin(a064,a074);
  a074=(a000<a057);
  a077=arg[2]? arg[2][39] : 0;
  a077=(a074?a077:0);
  a074=(!a074);
  a074=(a074?a011:0);
  a077=(a077+a074);
  a074=arg[1]? arg[1][9] : 0;
  a076=arg[2]? arg[2][65] : 0;
  a070=(a076*a003);
  a020=(a021?a020:0);
  a021=(!a021);
  a078=arg[2]? arg[2][14] : 0;
  a021=(a021?a078:0);
  a020=(a020+a021);
  a021=(a070+a020);
  a074=(a074*a021);
  a074=(a077+a074);
  a077=(a011-a077);
  a018=(a018*a077);
  a074=(a074+a018);
  a018=(a074-a011);
  a018=casadi_fabs(a018);
  a077=arg[0]? arg[0][33] : 0;
  a077=(a018<=a077);
  a077=(a077?a002:0);
  a077=(a000<a077);
  a021=(!a077);
  a078=arg[2]? arg[2][40] : 0;
  a079=(a078+a036);
  a080=(a000*a036);
  a080=(a038+a080);
  a080=(a079<=a080);
  a080=(!a080);
  a080=(a080?a002:0);
  a021=(a021?a080:0);
  a021=(a004<a021);
  a080=5007.;
  a080=(a021?a080:0);
  a021=(!a021);
  a021=(a021?a040:0);
  a080=(a080+a021);
  a064=casadi_fmin(a064,a080);
  a080=arg[0]? arg[0][34] : 0;
  a021=(a018-a080);
  a081=arg[2]? arg[2][41] : 0;
  a081=(a011==a081);
  a082=(a000<a057);
  a083=arg[2]? arg[2][42] : 0;
  a082=(a082?a083:0);
  a082=(a082+a036);
  a081=(a081?a082:0);
  a082=(a081-a067);
  a021=casadi_fmin(a021,a082);
  a021=(a004<a021);
  a082=3007.;
  a082=(a021?a082:0);
  a021=(!a021);
  a021=(a021?a040:0);
  a082=(a082+a021);
  a064=casadi_fmin(a064,a082);
  a082=(a000<a057);
  a021=arg[2]? arg[2][57] : 0;
  a082=(a082?a021:0);
  a082=(a082-a069);
  a082=casadi_fmax(a004,a082);
  a021=arg[0]? arg[0][39] : 0;
  a083=(a000<a057);
  a084=arg[2]? arg[2][55] : 0;
  a085=(-a084);
  a085=(a083?a085:0);
  a085=(a070+a085);
  a086=(a021<a085);
  a087=(a086?a002:0);
  a086=(!a086);
  a021=(-a021);
  a021=(a085<a021);
  a088=(a021?a031:0);
  a021=(!a021);
  a089=arg[2]? arg[2][56] : 0;
  a021=(a021?a089:0);
  a088=(a088+a021);
  a086=(a086?a088:0);
  a087=(a087+a086);
  a089=(a087==a089);
  a089=(!a089);
  a089=(a089?a002:0);
  a082=(a082+a089);
  a089=(a068+a082);
  a089=(a004<a089);
  a086=8002.;
  a086=(a089?a086:0);
  a089=(!a089);
  a089=(a089?a040:0);
  a086=(a086+a089);
  a064=casadi_fmin(a064,a086);
  a055=(a055-a061);
  a061=arg[2]? arg[2][36] : 0;
  a061=(a017==a061);
  a086=(a000<a057);
  a089=arg[2]? arg[2][37] : 0;
  a086=(a086?a089:0);
  a086=(a086+a036);
  a061=(a061?a086:0);
  a086=(a061-a067);
  a055=casadi_fmin(a055,a086);
  a086=-5.0000000000000003e-02;
  a089=arg[0]? arg[0][19] : 0;
  a088=(a086*a089);
  a021=(a004<a061);
  a090=arg[2]? arg[2][38] : 0;
  a090=(a021?a090:0);
  a021=(!a021);
  a021=(a021?a059:0);
  a090=(a090+a021);
  a059=(a059-a090);
  a059=casadi_fabs(a059);
  a088=(a088+a059);
  a055=casadi_fmin(a055,a088);
  a055=(a004<a055);
  a088=3005.;
  a088=(a055?a088:0);
  a055=(!a055);
  a055=(a055?a040:0);
  a088=(a088+a055);
  a064=casadi_fmin(a064,a088);
  a088=(a000<a057);
  a055=arg[2]? arg[2][48] : 0;
  a088=(a088?a055:0);
  a088=(a088-a069);
  a088=casadi_fmax(a004,a088);
  a055=arg[0]? arg[0][36] : 0;
  a059=(a000<a057);
  a021=arg[2]? arg[2][46] : 0;
  a021=(a059?a021:0);
  a059=(!a059);
  a059=(a059?a017:0);
  a021=(a021+a059);
  a059=(a017-a021);
  a091=(a055<a059);
  a092=(a091?a002:0);
  a091=(!a091);
  a055=(-a055);
  a055=(a059<a055);
  a093=(a055?a031:0);
  a055=(!a055);
  a094=arg[2]? arg[2][47] : 0;
  a055=(a055?a094:0);
  a093=(a093+a055);
  a091=(a091?a093:0);
  a092=(a092+a091);
  a094=(a092==a094);
  a094=(!a094);
  a094=(a094?a002:0);
  a088=(a088+a094);
  a094=(a068+a088);
  a094=(a004<a094);
  a091=6005.;
  a091=(a094?a091:0);
  a094=(!a094);
  a094=(a094?a040:0);
  a091=(a091+a094);
  a064=casadi_fmin(a064,a091);
  a018=(a018-a080);
  a080=arg[2]? arg[2][43] : 0;
  a080=(a020==a080);
  a091=(a000<a057);
  a094=arg[2]? arg[2][44] : 0;
  a091=(a091?a094:0);
  a091=(a091+a036);
  a080=(a080?a091:0);
  a067=(a080-a067);
  a018=casadi_fmin(a018,a067);
  a067=arg[0]? arg[0][23] : 0;
  a086=(a086*a067);
  a091=(a004<a080);
  a094=arg[2]? arg[2][45] : 0;
  a094=(a091?a094:0);
  a091=(!a091);
  a091=(a091?a070:0);
  a094=(a094+a091);
  a070=(a070-a094);
  a070=casadi_fabs(a070);
  a086=(a086+a070);
  a018=casadi_fmin(a018,a086);
  a018=(a004<a018);
  a086=3006.;
  a086=(a018?a086:0);
  a018=(!a018);
  a018=(a018?a040:0);
  a086=(a086+a018);
  a064=casadi_fmin(a064,a086);
  a086=(a000<a057);
  a018=arg[2]? arg[2][51] : 0;
  a086=(a086?a018:0);
  a086=(a086-a069);
  a086=casadi_fmax(a004,a086);
  a069=arg[0]? arg[0][37] : 0;
  a018=(a000<a057);
  a070=arg[2]? arg[2][49] : 0;
  a070=(a018?a070:0);
  a018=(!a018);
  a018=(a018?a020:0);
  a070=(a070+a018);
  a018=(a020-a070);
  a091=(a069<a018);
  a093=(a091?a002:0);
  a091=(!a091);
  a069=(-a069);
  a069=(a018<a069);
  a031=(a069?a031:0);
  a069=(!a069);
  a055=arg[2]? arg[2][50] : 0;
  a069=(a069?a055:0);
  a031=(a031+a069);
  a091=(a091?a031:0);
  a093=(a093+a091);
  a055=(a093==a055);
  a055=(!a055);
  a055=(a055?a002:0);
  a086=(a086+a055);
  a068=(a068+a086);
  a068=(a004<a068);
  a055=6006.;
  a055=(a068?a055:0);
  a068=(!a068);
  a068=(a068?a040:0);
  a055=(a055+a068);
  a064=casadi_fmin(a064,a055);
  a055=(a033<a064);
  a055=(!a055);
  a055=(a055?a064:0);
  a005=(a005?a055:0);
  a030=(a030+a005);
  a005=(a000<a030);
  a030=(a005?a030:0);
  a005=(!a005);
  a055=arg[0]? arg[0][16] : 0;
  a089=(a055*a089);
  a064=casadi_fabs(a007);
  a055=casadi_fmax(a055,a064);
  a089=(a089/a055);
  a055=arg[1]? arg[1][2] : 0;
  a064=arg[1]? arg[1][1] : 0;
  a068=(a007*a064);
  a068=(a055+a068);
  a068=casadi_fmin(a002,a068);
  a068=casadi_fmax(a004,a068);
  a068=(a089*a068);
  a091=(-a068);
  a064=(a007*a064);
  a055=(a055-a064);
  a055=casadi_fmin(a002,a055);
  a055=casadi_fmax(a004,a055);
  a089=(a089*a055);
  a055=arg[0]? arg[0][15] : 0;
  a064=arg[2]? arg[2][29] : 0;
  a064=(a055!=a064);
  a031=arg[1]? arg[1][0] : 0;
  a069=(a000<a057);
  a095=arg[2]? arg[2][28] : 0;
  a095=(a069?a095:0);
  a069=(!a069);
  a069=(a069?a055:0);
  a095=(a095+a069);
  a069=(a055-a095);
  a096=casadi_fabs(a069);
  a096=(a031*a096);
  a097=9.9999999999999995e-07;
  a098=casadi_fabs(a055);
  a098=(a097*a098);
  a099=casadi_fabs(a095);
  a099=(a097*a099);
  a098=(a098+a099);
  a096=casadi_fmax(a096,a098);
  a096=(a064?a096:0);
  a064=(!a064);
  a098=arg[2]? arg[2][30] : 0;
  a064=(a064?a098:0);
  a096=(a096+a064);
  a064=(a096<a069);
  a098=(a095+a096);
  a098=(a064?a098:0);
  a064=(!a064);
  a099=(-a096);
  a099=(a069<a099);
  a095=(a095-a096);
  a095=(a099?a095:0);
  a099=(!a099);
  a099=(a099?a055:0);
  a095=(a095+a099);
  a064=(a064?a095:0);
  a098=(a098+a064);
  a064=(a000<a057);
  a095=arg[2]? arg[2][31] : 0;
  a095=(a064?a095:0);
  a064=(!a064);
  a099=arg[0]? arg[0][24] : 0;
  a026=(a027?a026:0);
  a027=(!a027);
  a100=arg[2]? arg[2][8] : 0;
  a027=(a027?a100:0);
  a026=(a026+a027);
  a027=arg[0]? arg[0][25] : 0;
  a027=casadi_fmin(a026,a027);
  a099=casadi_fmax(a099,a027);
  a064=(a064?a099:0);
  a095=(a095+a064);
  a064=arg[1]? arg[1][5] : 0;
  a027=(-a064);
  a099=(a099-a095);
  a064=casadi_fmin(a064,a099);
  a027=casadi_fmax(a027,a064);
  a095=(a095+a027);
  a064=(a011*a095);
  a064=(a064-a007);
  a064=(a098*a064);
  a099=arg[0]? arg[0][52] : 0;
  a100=(a002-a099);
  a068=(a068*a100);
  a068=(-a068);
  a100=(a000<a057);
  a101=arg[2]? arg[2][63] : 0;
  a100=(a100?a101:0);
  a101=arg[0]? arg[0][45] : 0;
  a102=(a000<a057);
  a103=arg[2]? arg[2][60] : 0;
  a103=(a102?a103:0);
  a102=(!a102);
  a104=arg[1]? arg[1][15] : 0;
  a105=arg[0]? arg[0][20] : 0;
  a067=(a105*a067);
  a106=casadi_fabs(a011);
  a105=casadi_fmax(a105,a106);
  a067=(a067/a105);
  a105=arg[1]? arg[1][4] : 0;
  a106=arg[1]? arg[1][3] : 0;
  a107=(a011*a106);
  a107=(a105+a107);
  a107=casadi_fmin(a002,a107);
  a107=casadi_fmax(a004,a107);
  a107=(a067*a107);
  a107=(-a107);
  a106=(a011*a106);
  a105=(a105-a106);
  a105=casadi_fmin(a002,a105);
  a105=casadi_fmax(a004,a105);
  a067=(a067*a105);
  a105=arg[0]? arg[0][42] : 0;
  a105=(a004<a105);
  a106=(a000<a057);
  a108=arg[2]? arg[2][22] : 0;
  a108=(a106?a108:0);
  a106=(!a106);
  a109=arg[0]? arg[0][12] : 0;
  a106=(a106?a109:0);
  a108=(a108+a106);
  a106=arg[2]? arg[2][23] : 0;
  a106=(a109!=a106);
  a110=(a109-a108);
  a111=casadi_fabs(a110);
  a111=(a031*a111);
  a112=casadi_fabs(a109);
  a112=(a097*a112);
  a113=casadi_fabs(a108);
  a113=(a097*a113);
  a112=(a112+a113);
  a111=casadi_fmax(a111,a112);
  a111=(a106?a111:0);
  a106=(!a106);
  a112=arg[2]? arg[2][24] : 0;
  a106=(a106?a112:0);
  a111=(a111+a106);
  a106=(a111<a110);
  a112=(a108+a111);
  a112=(a106?a112:0);
  a106=(!a106);
  a113=(-a111);
  a113=(a110<a113);
  a114=(a108-a111);
  a114=(a113?a114:0);
  a113=(!a113);
  a113=(a113?a109:0);
  a114=(a114+a113);
  a106=(a106?a114:0);
  a112=(a112+a106);
  a108=(a108-a112);
  a108=(a020*a108);
  a108=(-a108);
  a105=(a105?a108:0);
  a108=(a000<a057);
  a106=arg[2]? arg[2][59] : 0;
  a108=(a108?a106:0);
  a105=(a105+a108);
  a108=(a000<a057);
  a106=arg[2]? arg[2][58] : 0;
  a106=(a108?a106:0);
  a108=(!a108);
  a108=(a108?a011:0);
  a106=(a106+a108);
  a108=arg[1]? arg[1][12] : 0;
  a114=(-a108);
  a014=(a015?a014:0);
  a015=(!a015);
  a113=arg[2]? arg[2][6] : 0;
  a015=(a015?a113:0);
  a014=(a014+a015);
  a015=(a014-a106);
  a108=casadi_fmin(a108,a015);
  a114=casadi_fmax(a114,a108);
  a106=(a106+a114);
  a114=(a106-a011);
  a108=arg[0]? arg[0][41] : 0;
  a108=(a114*a108);
  a108=(a105+a108);
  a015=(a020*a112);
  a108=(a108-a015);
  a067=casadi_fmin(a067,a108);
  a107=casadi_fmax(a107,a067);
  a067=(a107+a020);
  a104=(a104*a067);
  a104=(a017+a104);
  a102=(a102?a104:0);
  a103=(a103+a102);
  a102=arg[1]? arg[1][16] : 0;
  a015=(-a102);
  a023=(a024?a023:0);
  a024=(!a024);
  a113=arg[2]? arg[2][4] : 0;
  a024=(a024?a113:0);
  a023=(a023+a024);
  a024=(a023-a103);
  a102=casadi_fmin(a102,a024);
  a015=casadi_fmax(a015,a102);
  a103=(a103+a015);
  a101=(a101*a103);
  a101=(a100+a101);
  a015=(a000<a057);
  a102=arg[2]? arg[2][61] : 0;
  a102=(a015?a102:0);
  a015=(!a015);
  a015=(a015?a104:0);
  a102=(a102+a015);
  a015=(a000<a057);
  a024=arg[2]? arg[2][62] : 0;
  a113=(a015?a024:0);
  a115=arg[1]? arg[1][17] : 0;
  a116=(a103-a102);
  a115=(a115*a116);
  a113=(a113+a115);
  a115=arg[1]? arg[1][18] : 0;
  a115=(a115*a024);
  a115=(-a115);
  a015=(a015?a115:0);
  a113=(a113+a015);
  a015=(a113*a036);
  a102=(a102+a015);
  a015=arg[0]? arg[0][50] : 0;
  a115=(a102*a015);
  a115=(a115-a104);
  a015=(a002-a015);
  a015=(a103*a015);
  a115=(a115+a015);
  a015=arg[0]? arg[0][46] : 0;
  a015=(a115*a015);
  a101=(a101+a015);
  a015=arg[0]? arg[0][13] : 0;
  a104=arg[2]? arg[2][26] : 0;
  a104=(a015!=a104);
  a057=(a000<a057);
  a024=arg[2]? arg[2][25] : 0;
  a024=(a057?a024:0);
  a057=(!a057);
  a057=(a057?a015:0);
  a024=(a024+a057);
  a057=(a015-a024);
  a116=casadi_fabs(a057);
  a031=(a031*a116);
  a116=casadi_fabs(a015);
  a116=(a097*a116);
  a117=casadi_fabs(a024);
  a097=(a097*a117);
  a116=(a116+a097);
  a031=casadi_fmax(a031,a116);
  a031=(a104?a031:0);
  a104=(!a104);
  a116=arg[2]? arg[2][27] : 0;
  a104=(a104?a116:0);
  a031=(a031+a104);
  a104=(a031<a057);
  a116=(a024+a031);
  a116=(a104?a116:0);
  a104=(!a104);
  a097=(-a031);
  a097=(a057<a097);
  a024=(a024-a031);
  a024=(a097?a024:0);
  a097=(!a097);
  a097=(a097?a015:0);
  a024=(a024+a097);
  a104=(a104?a024:0);
  a116=(a116+a104);
  a104=arg[0]? arg[0][44] : 0;
  a024=(a104*a011);
  a097=arg[1]? arg[1][6] : 0;
  a097=(a097*a027);
  a024=(a024*a097);
  a104=(a104*a067);
  a104=(a104*a095);
  a067=arg[0]? arg[0][32] : 0;
  a104=(a104/a067);
  a024=(a024+a104);
  a024=(a116*a024);
  a101=(a101+a024);
  a099=(a002-a099);
  a099=(a089*a099);
  a099=casadi_fmin(a101,a099);
  a068=casadi_fmax(a068,a099);
  a064=(a064+a068);
  a089=casadi_fmin(a089,a064);
  a091=casadi_fmax(a091,a089);
  a089=casadi_fabs(a091);
  a064=arg[1]? arg[1][20] : 0;
  a089=(a089<=a064);
  a064=(a089?a002:0);
  a064=(a064<a002);
  a099=7001.;
  a099=(a064?a099:0);
  a064=(!a064);
  a064=(a064?a040:0);
  a099=(a099+a064);
  a064=casadi_fabs(a107);
  a024=arg[1]? arg[1][21] : 0;
  a064=(a064<=a024);
  a024=(a064?a002:0);
  a024=(a024<a002);
  a104=7002.;
  a104=(a024?a104:0);
  a024=(!a024);
  a024=(a024?a040:0);
  a104=(a104+a024);
  a099=casadi_fmin(a099,a104);
  a033=(a033<a099);
  a033=(!a033);
  a033=(a033?a099:0);
  a005=(a005?a033:0);
  a030=(a030+a005);
  if (res[0]!=0) res[0][0]=a030;
  a005=(a000<a030);
  a033=arg[1]? arg[1][22] : 0;
  a099=(-a033);
  a099=(a005?a099:0);
  a005=(!a005);
  a005=(a005?a033:0);
  a099=(a099+a005);
  a003=(a003+a099);
  a003=casadi_fmax(a004,a003);
  a003=casadi_fmin(a002,a003);
  if (res[0]!=0) res[0][1]=a003;
  a099=(a000<a030);
  a099=(!a099);
  a099=(a099?a002:0);
  if (res[0]!=0) res[0][2]=a099;
  if (res[0]!=0) res[0][3]=a029;
  if (res[0]!=0) res[0][4]=a023;
  a051=casadi_fmin(a051,a038);
  a051=(a051-a036);
  a051=casadi_fmax(a004,a051);
  a051=(a025?a051:0);
  a025=(!a025);
  a025=(a025?a054:0);
  a051=(a051+a025);
  if (res[0]!=0) res[0][5]=a051;
  if (res[0]!=0) res[0][6]=a014;
  a045=casadi_fmin(a045,a038);
  a045=(a045-a036);
  a045=casadi_fmax(a004,a045);
  a045=(a016?a045:0);
  a016=(!a016);
  a016=(a016?a048:0);
  a045=(a045+a016);
  if (res[0]!=0) res[0][7]=a045;
  if (res[0]!=0) res[0][8]=a026;
  a053=casadi_fmin(a053,a038);
  a053=(a053-a036);
  a053=casadi_fmax(a004,a053);
  a053=(a028?a053:0);
  a028=(!a028);
  a028=(a028?a056:0);
  a053=(a053+a028);
  if (res[0]!=0) res[0][9]=a053;
  if (res[0]!=0) res[0][10]=a007;
  a035=casadi_fmin(a035,a038);
  a035=(a035-a036);
  a035=casadi_fmax(a004,a035);
  a035=(a008?a035:0);
  a008=(!a008);
  a008=(a008?a037:0);
  a035=(a035+a008);
  if (res[0]!=0) res[0][11]=a035;
  if (res[0]!=0) res[0][12]=a017;
  a047=casadi_fmin(a047,a038);
  a047=(a047-a036);
  a047=casadi_fmax(a004,a047);
  a047=(a019?a047:0);
  a019=(!a019);
  a019=(a019?a050:0);
  a047=(a047+a019);
  if (res[0]!=0) res[0][13]=a047;
  if (res[0]!=0) res[0][14]=a020;
  a049=casadi_fmin(a049,a038);
  a049=(a049-a036);
  a049=casadi_fmax(a004,a049);
  a049=(a022?a049:0);
  a022=(!a022);
  a022=(a022?a052:0);
  a049=(a049+a022);
  if (res[0]!=0) res[0][15]=a049;
  if (res[0]!=0) res[0][16]=a011;
  a034=casadi_fmin(a034,a038);
  a034=(a034-a036);
  a034=casadi_fmax(a004,a034);
  a034=(a012?a034:0);
  a012=(!a012);
  a012=(a012?a044:0);
  a034=(a034+a012);
  if (res[0]!=0) res[0][17]=a034;
  a041=casadi_fmin(a041,a038);
  a041=(a041-a036);
  a041=casadi_fmax(a004,a041);
  a041=(a009?a041:0);
  a009=(!a009);
  a009=(a009?a042:0);
  a041=(a041+a009);
  if (res[0]!=0) res[0][18]=a041;
  a043=casadi_fmin(a043,a038);
  a043=(a043-a036);
  a043=casadi_fmax(a004,a043);
  a043=(a013?a043:0);
  a013=(!a013);
  a013=(a013?a046:0);
  a043=(a043+a013);
  if (res[0]!=0) res[0][19]=a043;
  if (res[0]!=0) res[0][20]=a032;
  a001=(a000<a001);
  a006=(a006?a010:0);
  a001=(a001?a006:0);
  if (res[0]!=0) res[0][21]=a001;
  if (res[0]!=0) res[0][22]=a112;
  if (res[0]!=0) res[0][23]=a109;
  a110=casadi_fabs(a110);
  a110=(a111<a110);
  a110=(a110?a111:0);
  if (res[0]!=0) res[0][24]=a110;
  if (res[0]!=0) res[0][25]=a116;
  if (res[0]!=0) res[0][26]=a015;
  a057=casadi_fabs(a057);
  a057=(a031<a057);
  a057=(a057?a031:0);
  if (res[0]!=0) res[0][27]=a057;
  if (res[0]!=0) res[0][28]=a098;
  if (res[0]!=0) res[0][29]=a055;
  a069=casadi_fabs(a069);
  a069=(a096<a069);
  a069=(a069?a096:0);
  if (res[0]!=0) res[0][30]=a069;
  if (res[0]!=0) res[0][31]=a095;
  if (res[0]!=0) res[0][32]=a039;
  a062=casadi_fmin(a062,a038);
  a062=(a062-a036);
  a062=casadi_fmax(a004,a062);
  a062=(a060?a062:0);
  a060=(!a060);
  a060=(a060?a063:0);
  a062=(a062+a060);
  if (res[0]!=0) res[0][33]=a062;
  if (res[0]!=0) res[0][34]=a007;
  if (res[0]!=0) res[0][35]=a066;
  if (res[0]!=0) res[0][36]=a017;
  if (res[0]!=0) res[0][37]=a061;
  if (res[0]!=0) res[0][38]=a090;
  if (res[0]!=0) res[0][39]=a074;
  a078=casadi_fmin(a078,a038);
  a078=(a078-a036);
  a078=casadi_fmax(a004,a078);
  a078=(a077?a078:0);
  a077=(!a077);
  a077=(a077?a079:0);
  a078=(a078+a077);
  if (res[0]!=0) res[0][40]=a078;
  if (res[0]!=0) res[0][41]=a011;
  if (res[0]!=0) res[0][42]=a081;
  if (res[0]!=0) res[0][43]=a020;
  if (res[0]!=0) res[0][44]=a080;
  if (res[0]!=0) res[0][45]=a094;
  a094=arg[1]? arg[1][11] : 0;
  a059=(a059*a094);
  a021=(a021+a059);
  if (res[0]!=0) res[0][46]=a021;
  if (res[0]!=0) res[0][47]=a092;
  if (res[0]!=0) res[0][48]=a088;
  a018=(a018*a094);
  a070=(a070+a018);
  if (res[0]!=0) res[0][49]=a070;
  if (res[0]!=0) res[0][50]=a093;
  if (res[0]!=0) res[0][51]=a086;
  a071=(a071?a072:0);
  a073=(a073*a094);
  a071=(a071+a073);
  if (res[0]!=0) res[0][52]=a071;
  if (res[0]!=0) res[0][53]=a075;
  if (res[0]!=0) res[0][54]=a065;
  a083=(a083?a084:0);
  a085=(a085*a094);
  a083=(a083+a085);
  if (res[0]!=0) res[0][55]=a083;
  if (res[0]!=0) res[0][56]=a087;
  if (res[0]!=0) res[0][57]=a082;
  if (res[0]!=0) res[0][58]=a106;
  a108=(a107-a108);
  a106=arg[1]? arg[1][14] : 0;
  a108=(a108*a106);
  a105=(a105+a108);
  a108=arg[1]? arg[1][13] : 0;
  a114=(a114*a108);
  a105=(a105+a114);
  if (res[0]!=0) res[0][59]=a105;
  if (res[0]!=0) res[0][60]=a103;
  if (res[0]!=0) res[0][61]=a102;
  if (res[0]!=0) res[0][62]=a113;
  a101=(a101-a068);
  a101=(a115*a101);
  a004=(a004<a101);
  a101=(a004?a100:0);
  a004=(!a004);
  a068=arg[0]? arg[0][53] : 0;
  a113=(-a068);
  a102=arg[1]? arg[1][19] : 0;
  a115=(a115*a102);
  a100=(a100+a115);
  a068=casadi_fmin(a068,a100);
  a113=casadi_fmax(a113,a068);
  a004=(a004?a113:0);
  a101=(a101+a004);
  if (res[0]!=0) res[0][63]=a101;
  a101=(a000<a030);
  a004=(a101?a058:0);
  a101=(!a101);
  a091=(a089?a091:0);
  a089=(!a089);
  a089=(a089?a058:0);
  a091=(a091+a089);
  a101=(a101?a091:0);
  a004=(a004+a101);
  if (res[0]!=0) res[0][64]=a004;
  a000=(a000<a030);
  a030=(a000?a076:0);
  a000=(!a000);
  a107=(a064?a107:0);
  a064=(!a064);
  a064=(a064?a076:0);
  a107=(a107+a064);
  a000=(a000?a107:0);
  a030=(a030+a000);
  if (res[0]!=0) res[0][65]=a030;
  a000=-900.;
  a107=900.;
  a004=(a004*a003);
  a107=casadi_fmin(a107,a004);
  a000=casadi_fmax(a000,a107);
  if (res[1]!=0) res[1][0]=a000;
  a000=-3300.;
  a107=3300.;
  a030=(a030*a003);
  a107=casadi_fmin(a107,a030);
  a000=casadi_fmax(a000,a107);
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


