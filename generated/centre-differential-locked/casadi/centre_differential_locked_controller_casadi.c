/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) centre_differential_locked_controller_casadi_ ## ID
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
#define casadi_sq CASADI_PREFIX(sq)
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

casadi_real casadi_sq(casadi_real x) { return x*x;}

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
CASADI_SYMBOL_EXPORT void centre_differential_locked_controller_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int centre_differential_locked_controller_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int centre_differential_locked_controller_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {58, 1, 1};
static const casadi_int casadi_s1[3] = {38, 1, 1};
static const casadi_int casadi_s2[3] = {37, 1, 1};
static const casadi_int casadi_s3[3] = {9, 1, 1};
static const casadi_int casadi_s4[3] = {3, 1, 1};

static const casadi_real casadi_zeros[58] = 
  {0.};

/* controller_prepare:(parameters[58])->(derived[38]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real w01, w02, w03, w04, w05, w06, w07, w08, w09, w10, w11, w12;
  const casadi_real *wr00;
  /* #0: @0 = input[0][0] */
  wr00 = arg[0] ? arg[0] : casadi_zeros;
  /* #1: @1 = @0[0] */
  w01 = wr00[0];
  /* #2: @2 = @0[13] */
  w02 = wr00[13];
  /* #3: @2 = (@1/@2) */
  w02  = (w01/w02);
  /* #4: output[0][0] = @2 */
  if (res[0]) res[0][0] = w02;
  /* #5: @2 = @0[18] */
  w02 = wr00[18];
  /* #6: @3 = (1./@2) */
  w03 = (1./ w02 );
  /* #7: output[0][1] = @3 */
  if (res[0]) res[0][1] = w03;
  /* #8: @3 = 1 */
  w03 = 1.;
  /* #9: @4 = @0[17] */
  w04 = wr00[17];
  /* #10: @4 = (@4/@2) */
  w04 /= w02;
  /* #11: @3 = (@3+@4) */
  w03 += w04;
  /* #12: output[0][2] = @3 */
  if (res[0]) res[0][2] = w03;
  /* #13: @3 = @0[22] */
  w03 = wr00[22];
  /* #14: @4 = (1./@3) */
  w04 = (1./ w03 );
  /* #15: output[0][3] = @4 */
  if (res[0]) res[0][3] = w04;
  /* #16: @4 = 1 */
  w04 = 1.;
  /* #17: @2 = @0[21] */
  w02 = wr00[21];
  /* #18: @2 = (@2/@3) */
  w02 /= w03;
  /* #19: @4 = (@4+@2) */
  w04 += w02;
  /* #20: output[0][4] = @4 */
  if (res[0]) res[0][4] = w04;
  /* #21: @4 = @0[26] */
  w04 = wr00[26];
  /* #22: @2 = (1./@4) */
  w02 = (1./ w04 );
  /* #23: output[0][5] = @2 */
  if (res[0]) res[0][5] = w02;
  /* #24: @2 = 1 */
  w02 = 1.;
  /* #25: @3 = @0[25] */
  w03 = wr00[25];
  /* #26: @3 = (@3/@4) */
  w03 /= w04;
  /* #27: @2 = (@2+@3) */
  w02 += w03;
  /* #28: output[0][6] = @2 */
  if (res[0]) res[0][6] = w02;
  /* #29: @2 = @0[28] */
  w02 = wr00[28];
  /* #30: @2 = (@2*@1) */
  w02 *= w01;
  /* #31: output[0][7] = @2 */
  if (res[0]) res[0][7] = w02;
  /* #32: @2 = @0[30] */
  w02 = wr00[30];
  /* #33: @3 = (@2*@1) */
  w03  = (w02*w01);
  /* #34: output[0][8] = @3 */
  if (res[0]) res[0][8] = w03;
  /* #35: @2 = (@2*@1) */
  w02 *= w01;
  /* #36: @3 = @0[29] */
  w03 = wr00[29];
  /* #37: @2 = (@2/@3) */
  w02 /= w03;
  /* #38: output[0][9] = @2 */
  if (res[0]) res[0][9] = w02;
  /* #39: @2 = @0[31] */
  w02 = wr00[31];
  /* #40: @3 = @0[32] */
  w03 = wr00[32];
  /* #41: @2 = (@2/@3) */
  w02 /= w03;
  /* #42: output[0][10] = @2 */
  if (res[0]) res[0][10] = w02;
  /* #43: @2 = @0[36] */
  w02 = wr00[36];
  /* #44: @2 = (@2*@1) */
  w02 *= w01;
  /* #45: output[0][11] = @2 */
  if (res[0]) res[0][11] = w02;
  /* #46: @2 = @0[37] */
  w02 = wr00[37];
  /* #47: @2 = (@2*@1) */
  w02 *= w01;
  /* #48: @4 = @0[33] */
  w04 = wr00[33];
  /* #49: @2 = (@2/@4) */
  w02 /= w04;
  /* #50: output[0][12] = @2 */
  if (res[0]) res[0][12] = w02;
  /* #51: @2 = @0[38] */
  w02 = wr00[38];
  /* #52: @2 = (@2*@1) */
  w02 *= w01;
  /* #53: @2 = (@2/@4) */
  w02 /= w04;
  /* #54: output[0][13] = @2 */
  if (res[0]) res[0][13] = w02;
  /* #55: @2 = @0[40] */
  w02 = wr00[40];
  /* #56: @2 = (@2/@3) */
  w02 /= w03;
  /* #57: output[0][14] = @2 */
  if (res[0]) res[0][14] = w02;
  /* #58: @2 = @0[44] */
  w02 = wr00[44];
  /* #59: @2 = (@2*@1) */
  w02 *= w01;
  /* #60: output[0][15] = @2 */
  if (res[0]) res[0][15] = w02;
  /* #61: @2 = @0[45] */
  w02 = wr00[45];
  /* #62: @2 = (@2*@1) */
  w02 *= w01;
  /* #63: @5 = @0[41] */
  w05 = wr00[41];
  /* #64: @2 = (@2/@5) */
  w02 /= w05;
  /* #65: output[0][16] = @2 */
  if (res[0]) res[0][16] = w02;
  /* #66: @2 = @0[46] */
  w02 = wr00[46];
  /* #67: @2 = (@2*@1) */
  w02 *= w01;
  /* #68: @2 = (@2/@5) */
  w02 /= w05;
  /* #69: output[0][17] = @2 */
  if (res[0]) res[0][17] = w02;
  /* #70: @2 = @0[48] */
  w02 = wr00[48];
  /* #71: @6 = (@3*@2) */
  w06  = (w03*w02);
  /* #72: @6 = (@4/@6) */
  w06  = (w04/w06);
  /* #73: output[0][18] = @6 */
  if (res[0]) res[0][18] = w06;
  /* #74: @6 = @0[49] */
  w06 = wr00[49];
  /* #75: @7 = @0[51] */
  w07 = wr00[51];
  /* #76: @8 = sq(@2) */
  w08 = casadi_sq( w02 );
  /* #77: @8 = (@7*@8) */
  w08  = (w07*w08);
  /* #78: @8 = (@6+@8) */
  w08  = (w06+w08);
  /* #79: @9 = (2.*@2) */
  w09 = (2.* w02 );
  /* #80: @10 = @0[50] */
  w10 = wr00[50];
  /* #81: @9 = (@9*@10) */
  w09 *= w10;
  /* #82: @8 = (@8+@9) */
  w08 += w09;
  /* #83: @8 = (@6*@8) */
  w08  = (w06*w08);
  /* #84: @9 = sq(@2) */
  w09 = casadi_sq( w02 );
  /* #85: @11 = (@6*@7) */
  w11  = (w06*w07);
  /* #86: @12 = sq(@10) */
  w12 = casadi_sq( w10 );
  /* #87: @11 = (@11-@12) */
  w11 -= w12;
  /* #88: @9 = (@9*@11) */
  w09 *= w11;
  /* #89: @8 = (@8/@9) */
  w08 /= w09;
  /* #90: @8 = (-@8) */
  w08 = (- w08 );
  /* #91: output[0][19] = @8 */
  if (res[0]) res[0][19] = w08;
  /* #92: @8 = (@2*@10) */
  w08  = (w02*w10);
  /* #93: @8 = (@6+@8) */
  w08  = (w06+w08);
  /* #94: @8 = (@4*@8) */
  w08  = (w04*w08);
  /* #95: @9 = sq(@2) */
  w09 = casadi_sq( w02 );
  /* #96: @9 = (@7*@9) */
  w09  = (w07*w09);
  /* #97: @9 = (@6+@9) */
  w09  = (w06+w09);
  /* #98: @11 = (2.*@2) */
  w11 = (2.* w02 );
  /* #99: @11 = (@11*@10) */
  w11 *= w10;
  /* #100: @9 = (@9+@11) */
  w09 += w11;
  /* #101: @8 = (@8*@9) */
  w08 *= w09;
  /* #102: @9 = sq(@2) */
  w09 = casadi_sq( w02 );
  /* #103: @9 = (@5*@9) */
  w09  = (w05*w09);
  /* #104: @11 = (@6*@7) */
  w11  = (w06*w07);
  /* #105: @12 = sq(@10) */
  w12 = casadi_sq( w10 );
  /* #106: @11 = (@11-@12) */
  w11 -= w12;
  /* #107: @9 = (@9*@11) */
  w09 *= w11;
  /* #108: @8 = (@8/@9) */
  w08 /= w09;
  /* #109: @8 = (-@8) */
  w08 = (- w08 );
  /* #110: output[0][20] = @8 */
  if (res[0]) res[0][20] = w08;
  /* #111: @8 = (@2*@10) */
  w08  = (w02*w10);
  /* #112: @8 = (@6+@8) */
  w08  = (w06+w08);
  /* #113: @8 = (@4*@8) */
  w08  = (w04*w08);
  /* #114: @9 = sq(@2) */
  w09 = casadi_sq( w02 );
  /* #115: @9 = (@7*@9) */
  w09  = (w07*w09);
  /* #116: @9 = (@6+@9) */
  w09  = (w06+w09);
  /* #117: @11 = (2.*@2) */
  w11 = (2.* w02 );
  /* #118: @11 = (@11*@10) */
  w11 *= w10;
  /* #119: @9 = (@9+@11) */
  w09 += w11;
  /* #120: @8 = (@8*@9) */
  w08 *= w09;
  /* #121: @9 = (@5*@2) */
  w09  = (w05*w02);
  /* #122: @11 = (@6*@7) */
  w11  = (w06*w07);
  /* #123: @12 = sq(@10) */
  w12 = casadi_sq( w10 );
  /* #124: @11 = (@11-@12) */
  w11 -= w12;
  /* #125: @9 = (@9*@11) */
  w09 *= w11;
  /* #126: @8 = (@8/@9) */
  w08 /= w09;
  /* #127: output[0][21] = @8 */
  if (res[0]) res[0][21] = w08;
  /* #128: @8 = (@2*@10) */
  w08  = (w02*w10);
  /* #129: @8 = (@6+@8) */
  w08  = (w06+w08);
  /* #130: @9 = (@4*@6) */
  w09  = (w04*w06);
  /* #131: @11 = (@5*@6) */
  w11  = (w05*w06);
  /* #132: @9 = (@9-@11) */
  w09 -= w11;
  /* #133: @11 = (@4*@7) */
  w11  = (w04*w07);
  /* #134: @12 = sq(@2) */
  w12 = casadi_sq( w02 );
  /* #135: @11 = (@11*@12) */
  w11 *= w12;
  /* #136: @9 = (@9+@11) */
  w09 += w11;
  /* #137: @11 = (@5*@2) */
  w11  = (w05*w02);
  /* #138: @11 = (@11*@10) */
  w11 *= w10;
  /* #139: @9 = (@9-@11) */
  w09 -= w11;
  /* #140: @11 = (2.*@4) */
  w11 = (2.* w04 );
  /* #141: @11 = (@11*@2) */
  w11 *= w02;
  /* #142: @11 = (@11*@10) */
  w11 *= w10;
  /* #143: @9 = (@9+@11) */
  w09 += w11;
  /* #144: @8 = (@8*@9) */
  w08 *= w09;
  /* #145: @9 = sq(@2) */
  w09 = casadi_sq( w02 );
  /* #146: @9 = (@5*@9) */
  w09  = (w05*w09);
  /* #147: @11 = (@6*@7) */
  w11  = (w06*w07);
  /* #148: @12 = sq(@10) */
  w12 = casadi_sq( w10 );
  /* #149: @11 = (@11-@12) */
  w11 -= w12;
  /* #150: @9 = (@9*@11) */
  w09 *= w11;
  /* #151: @8 = (@8/@9) */
  w08 /= w09;
  /* #152: @8 = (-@8) */
  w08 = (- w08 );
  /* #153: output[0][22] = @8 */
  if (res[0]) res[0][22] = w08;
  /* #154: @8 = sq(@2) */
  w08 = casadi_sq( w02 );
  /* #155: @8 = (@7*@8) */
  w08  = (w07*w08);
  /* #156: @8 = (@6+@8) */
  w08  = (w06+w08);
  /* #157: @9 = (2.*@2) */
  w09 = (2.* w02 );
  /* #158: @9 = (@9*@10) */
  w09 *= w10;
  /* #159: @8 = (@8+@9) */
  w08 += w09;
  /* #160: @8 = (@10*@8) */
  w08  = (w10*w08);
  /* #161: @9 = sq(@2) */
  w09 = casadi_sq( w02 );
  /* #162: @11 = (@6*@7) */
  w11  = (w06*w07);
  /* #163: @12 = sq(@10) */
  w12 = casadi_sq( w10 );
  /* #164: @11 = (@11-@12) */
  w11 -= w12;
  /* #165: @9 = (@9*@11) */
  w09 *= w11;
  /* #166: @8 = (@8/@9) */
  w08 /= w09;
  /* #167: @8 = (-@8) */
  w08 = (- w08 );
  /* #168: output[0][23] = @8 */
  if (res[0]) res[0][23] = w08;
  /* #169: @8 = sq(@2) */
  w08 = casadi_sq( w02 );
  /* #170: @8 = (@7*@8) */
  w08  = (w07*w08);
  /* #171: @8 = (@6+@8) */
  w08  = (w06+w08);
  /* #172: @9 = (2.*@2) */
  w09 = (2.* w02 );
  /* #173: @9 = (@9*@10) */
  w09 *= w10;
  /* #174: @8 = (@8+@9) */
  w08 += w09;
  /* #175: @8 = (@6*@8) */
  w08  = (w06*w08);
  /* #176: @9 = sq(@2) */
  w09 = casadi_sq( w02 );
  /* #177: @11 = (@6*@7) */
  w11  = (w06*w07);
  /* #178: @12 = sq(@10) */
  w12 = casadi_sq( w10 );
  /* #179: @11 = (@11-@12) */
  w11 -= w12;
  /* #180: @9 = (@9*@11) */
  w09 *= w11;
  /* #181: @8 = (@8/@9) */
  w08 /= w09;
  /* #182: @8 = (-@8) */
  w08 = (- w08 );
  /* #183: output[0][24] = @8 */
  if (res[0]) res[0][24] = w08;
  /* #184: @8 = (@2*@10) */
  w08  = (w02*w10);
  /* #185: @8 = (@6+@8) */
  w08  = (w06+w08);
  /* #186: @9 = sq(@2) */
  w09 = casadi_sq( w02 );
  /* #187: @9 = (@7*@9) */
  w09  = (w07*w09);
  /* #188: @9 = (@6+@9) */
  w09  = (w06+w09);
  /* #189: @11 = (2.*@2) */
  w11 = (2.* w02 );
  /* #190: @11 = (@11*@10) */
  w11 *= w10;
  /* #191: @9 = (@9+@11) */
  w09 += w11;
  /* #192: @8 = (@8*@9) */
  w08 *= w09;
  /* #193: @9 = sq(@2) */
  w09 = casadi_sq( w02 );
  /* #194: @11 = (@6*@7) */
  w11  = (w06*w07);
  /* #195: @12 = sq(@10) */
  w12 = casadi_sq( w10 );
  /* #196: @11 = (@11-@12) */
  w11 -= w12;
  /* #197: @9 = (@9*@11) */
  w09 *= w11;
  /* #198: @8 = (@8/@9) */
  w08 /= w09;
  /* #199: output[0][25] = @8 */
  if (res[0]) res[0][25] = w08;
  /* #200: @8 = @0[52] */
  w08 = wr00[52];
  /* #201: @8 = (@8*@1) */
  w08 *= w01;
  /* #202: output[0][26] = @8 */
  if (res[0]) res[0][26] = w08;
  /* #203: @8 = sq(@2) */
  w08 = casadi_sq( w02 );
  /* #204: @8 = (@7*@8) */
  w08  = (w07*w08);
  /* #205: @8 = (@6+@8) */
  w08  = (w06+w08);
  /* #206: @9 = (2.*@2) */
  w09 = (2.* w02 );
  /* #207: @9 = (@9*@10) */
  w09 *= w10;
  /* #208: @8 = (@8+@9) */
  w08 += w09;
  /* #209: @8 = (@6*@8) */
  w08  = (w06*w08);
  /* #210: @9 = sq(@2) */
  w09 = casadi_sq( w02 );
  /* #211: @11 = (@6*@7) */
  w11  = (w06*w07);
  /* #212: @12 = sq(@10) */
  w12 = casadi_sq( w10 );
  /* #213: @11 = (@11-@12) */
  w11 -= w12;
  /* #214: @9 = (@9*@11) */
  w09 *= w11;
  /* #215: @8 = (@8/@9) */
  w08 /= w09;
  /* #216: @8 = (-@8) */
  w08 = (- w08 );
  /* #217: output[0][27] = @8 */
  if (res[0]) res[0][27] = w08;
  /* #218: @3 = (@3*@2) */
  w03 *= w02;
  /* #219: @3 = (@5/@3) */
  w03  = (w05/w03);
  /* #220: output[0][28] = @3 */
  if (res[0]) res[0][28] = w03;
  /* #221: @3 = (@5*@6) */
  w03  = (w05*w06);
  /* #222: @8 = (@2*@10) */
  w08  = (w02*w10);
  /* #223: @8 = (@6+@8) */
  w08  = (w06+w08);
  /* #224: @3 = (@3*@8) */
  w03 *= w08;
  /* #225: @8 = sq(@2) */
  w08 = casadi_sq( w02 );
  /* #226: @8 = (@4*@8) */
  w08  = (w04*w08);
  /* #227: @9 = (@6*@7) */
  w09  = (w06*w07);
  /* #228: @11 = sq(@10) */
  w11 = casadi_sq( w10 );
  /* #229: @9 = (@9-@11) */
  w09 -= w11;
  /* #230: @8 = (@8*@9) */
  w08 *= w09;
  /* #231: @3 = (@3/@8) */
  w03 /= w08;
  /* #232: @3 = (-@3) */
  w03 = (- w03 );
  /* #233: output[0][29] = @3 */
  if (res[0]) res[0][29] = w03;
  /* #234: @3 = sq(@2) */
  w03 = casadi_sq( w02 );
  /* #235: @3 = (@7*@3) */
  w03  = (w07*w03);
  /* #236: @3 = (@6+@3) */
  w03  = (w06+w03);
  /* #237: @8 = (2.*@2) */
  w08 = (2.* w02 );
  /* #238: @8 = (@8*@10) */
  w08 *= w10;
  /* #239: @3 = (@3+@8) */
  w03 += w08;
  /* #240: @3 = (@6*@3) */
  w03  = (w06*w03);
  /* #241: @8 = sq(@2) */
  w08 = casadi_sq( w02 );
  /* #242: @9 = (@6*@7) */
  w09  = (w06*w07);
  /* #243: @11 = sq(@10) */
  w11 = casadi_sq( w10 );
  /* #244: @9 = (@9-@11) */
  w09 -= w11;
  /* #245: @8 = (@8*@9) */
  w08 *= w09;
  /* #246: @3 = (@3/@8) */
  w03 /= w08;
  /* #247: @3 = (-@3) */
  w03 = (- w03 );
  /* #248: output[0][30] = @3 */
  if (res[0]) res[0][30] = w03;
  /* #249: @3 = (@5*@6) */
  w03  = (w05*w06);
  /* #250: @8 = (@2*@10) */
  w08  = (w02*w10);
  /* #251: @8 = (@6+@8) */
  w08  = (w06+w08);
  /* #252: @3 = (@3*@8) */
  w03 *= w08;
  /* #253: @8 = (@4*@2) */
  w08  = (w04*w02);
  /* #254: @9 = (@6*@7) */
  w09  = (w06*w07);
  /* #255: @11 = sq(@10) */
  w11 = casadi_sq( w10 );
  /* #256: @9 = (@9-@11) */
  w09 -= w11;
  /* #257: @8 = (@8*@9) */
  w08 *= w09;
  /* #258: @3 = (@3/@8) */
  w03 /= w08;
  /* #259: output[0][31] = @3 */
  if (res[0]) res[0][31] = w03;
  /* #260: @3 = (@2*@10) */
  w03  = (w02*w10);
  /* #261: @3 = (@6+@3) */
  w03  = (w06+w03);
  /* #262: @8 = (@4*@6) */
  w08  = (w04*w06);
  /* #263: @9 = (@5*@6) */
  w09  = (w05*w06);
  /* #264: @8 = (@8-@9) */
  w08 -= w09;
  /* #265: @9 = (@4*@2) */
  w09  = (w04*w02);
  /* #266: @9 = (@9*@10) */
  w09 *= w10;
  /* #267: @8 = (@8+@9) */
  w08 += w09;
  /* #268: @3 = (@3*@8) */
  w03 *= w08;
  /* #269: @8 = sq(@2) */
  w08 = casadi_sq( w02 );
  /* #270: @8 = (@4*@8) */
  w08  = (w04*w08);
  /* #271: @9 = (@6*@7) */
  w09  = (w06*w07);
  /* #272: @11 = sq(@10) */
  w11 = casadi_sq( w10 );
  /* #273: @9 = (@9-@11) */
  w09 -= w11;
  /* #274: @8 = (@8*@9) */
  w08 *= w09;
  /* #275: @3 = (@3/@8) */
  w03 /= w08;
  /* #276: output[0][32] = @3 */
  if (res[0]) res[0][32] = w03;
  /* #277: @3 = (@5*@10) */
  w03  = (w05*w10);
  /* #278: @8 = (@2*@10) */
  w08  = (w02*w10);
  /* #279: @8 = (@6+@8) */
  w08  = (w06+w08);
  /* #280: @3 = (@3*@8) */
  w03 *= w08;
  /* #281: @8 = sq(@2) */
  w08 = casadi_sq( w02 );
  /* #282: @8 = (@4*@8) */
  w08  = (w04*w08);
  /* #283: @9 = (@6*@7) */
  w09  = (w06*w07);
  /* #284: @11 = sq(@10) */
  w11 = casadi_sq( w10 );
  /* #285: @9 = (@9-@11) */
  w09 -= w11;
  /* #286: @8 = (@8*@9) */
  w08 *= w09;
  /* #287: @3 = (@3/@8) */
  w03 /= w08;
  /* #288: @3 = (-@3) */
  w03 = (- w03 );
  /* #289: output[0][33] = @3 */
  if (res[0]) res[0][33] = w03;
  /* #290: @3 = (@5*@6) */
  w03  = (w05*w06);
  /* #291: @8 = (@2*@10) */
  w08  = (w02*w10);
  /* #292: @8 = (@6+@8) */
  w08  = (w06+w08);
  /* #293: @3 = (@3*@8) */
  w03 *= w08;
  /* #294: @8 = sq(@2) */
  w08 = casadi_sq( w02 );
  /* #295: @8 = (@4*@8) */
  w08  = (w04*w08);
  /* #296: @9 = (@6*@7) */
  w09  = (w06*w07);
  /* #297: @11 = sq(@10) */
  w11 = casadi_sq( w10 );
  /* #298: @9 = (@9-@11) */
  w09 -= w11;
  /* #299: @8 = (@8*@9) */
  w08 *= w09;
  /* #300: @3 = (@3/@8) */
  w03 /= w08;
  /* #301: @3 = (-@3) */
  w03 = (- w03 );
  /* #302: output[0][34] = @3 */
  if (res[0]) res[0][34] = w03;
  /* #303: @3 = (@2*@10) */
  w03  = (w02*w10);
  /* #304: @3 = (@6+@3) */
  w03  = (w06+w03);
  /* #305: @3 = sq(@3) */
  w03 = casadi_sq( w03 );
  /* #306: @5 = (@5*@3) */
  w05 *= w03;
  /* #307: @3 = sq(@2) */
  w03 = casadi_sq( w02 );
  /* #308: @4 = (@4*@3) */
  w04 *= w03;
  /* #309: @3 = (@6*@7) */
  w03  = (w06*w07);
  /* #310: @8 = sq(@10) */
  w08 = casadi_sq( w10 );
  /* #311: @3 = (@3-@8) */
  w03 -= w08;
  /* #312: @4 = (@4*@3) */
  w04 *= w03;
  /* #313: @5 = (@5/@4) */
  w05 /= w04;
  /* #314: output[0][35] = @5 */
  if (res[0]) res[0][35] = w05;
  /* #315: @5 = @0[55] */
  w05 = wr00[55];
  /* #316: @5 = (@5*@1) */
  w05 *= w01;
  /* #317: output[0][36] = @5 */
  if (res[0]) res[0][36] = w05;
  /* #318: @5 = sq(@2) */
  w05 = casadi_sq( w02 );
  /* #319: @5 = (@7*@5) */
  w05  = (w07*w05);
  /* #320: @5 = (@6+@5) */
  w05  = (w06+w05);
  /* #321: @1 = (2.*@2) */
  w01 = (2.* w02 );
  /* #322: @1 = (@1*@10) */
  w01 *= w10;
  /* #323: @5 = (@5+@1) */
  w05 += w01;
  /* #324: @5 = (@6*@5) */
  w05  = (w06*w05);
  /* #325: @2 = sq(@2) */
  w02 = casadi_sq( w02 );
  /* #326: @6 = (@6*@7) */
  w06 *= w07;
  /* #327: @10 = sq(@10) */
  w10 = casadi_sq( w10 );
  /* #328: @6 = (@6-@10) */
  w06 -= w10;
  /* #329: @2 = (@2*@6) */
  w02 *= w06;
  /* #330: @5 = (@5/@2) */
  w05 /= w02;
  /* #331: @5 = (-@5) */
  w05 = (- w05 );
  /* #332: output[0][37] = @5 */
  if (res[0]) res[0][37] = w05;
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

/* controller_step:(parameters[58],derived[38],states[37],inputs[9])->(next_states[37],outputs[3]) */
static int casadi_f1(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58, a59;
  casadi_real a60, a61, a62, a63, a64, a65, a66, a67, a68, a69, a70, a71;
  a00=arg[0]? arg[0][24] : 0;
  a01=arg[0]? arg[0][27] : 0;
  a02=(a00*a01);
  a03=arg[3]? arg[3][8] : 0;
  a04=casadi_fabs(a03);
  a05=arg[0]? arg[0][10] : 0;
  a04=(a04<=a05);
  a03=(a04?a03:0);
  a05=(!a04);
  a06=arg[2]? arg[2][9] : 0;
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
  a09=(-a08);
  a07=(a03*a07);
  a06=(a06-a07);
  a06=casadi_fmin(a05,a06);
  a06=casadi_fmax(a00,a06);
  a02=(a02*a06);
  a06=arg[0]? arg[0][14] : 0;
  a07=5.0000000000000000e-01;
  a10=arg[2]? arg[2][13] : 0;
  a11=(a07<a10);
  a12=arg[2]? arg[2][17] : 0;
  a12=(a11?a12:0);
  a11=(!a11);
  a11=(a11?a06:0);
  a12=(a12+a11);
  a11=(a06-a12);
  a13=casadi_fabs(a11);
  a14=arg[2]? arg[2][18] : 0;
  a14=(a06!=a14);
  a15=arg[1]? arg[1][0] : 0;
  a16=casadi_fabs(a11);
  a16=(a15*a16);
  a17=9.9999999999999995e-07;
  a18=casadi_fabs(a06);
  a18=(a17*a18);
  a19=casadi_fabs(a12);
  a19=(a17*a19);
  a18=(a18+a19);
  a16=casadi_fmax(a16,a18);
  a16=(a14?a16:0);
  a14=(!a14);
  a18=arg[2]? arg[2][19] : 0;
  a14=(a14?a18:0);
  a16=(a16+a14);
  a13=(a13<=a16);
  a14=(a13?a06:0);
  a13=(!a13);
  a18=(a00<a11);
  a19=(a12+a16);
  a19=(a18?a19:0);
  a18=(!a18);
  a12=(a12-a16);
  a18=(a18?a12:0);
  a19=(a19+a18);
  a13=(a13?a19:0);
  a14=(a14+a13);
  a13=arg[3]? arg[3][3] : 0;
  a19=casadi_fabs(a13);
  a18=arg[0]? arg[0][5] : 0;
  a19=(a19<=a18);
  a13=(a19?a13:0);
  a18=(!a19);
  a12=arg[2]? arg[2][4] : 0;
  a18=(a18?a12:0);
  a13=(a13+a18);
  a18=arg[1]? arg[1][33] : 0;
  a12=(a13*a18);
  a20=arg[3]? arg[3][6] : 0;
  a21=casadi_fabs(a20);
  a22=arg[0]? arg[0][8] : 0;
  a21=(a21<=a22);
  a20=(a21?a20:0);
  a22=(!a21);
  a23=arg[2]? arg[2][7] : 0;
  a22=(a22?a23:0);
  a20=(a20+a22);
  a22=arg[1]? arg[1][34] : 0;
  a23=(a20*a22);
  a12=(a12+a23);
  a23=arg[1]? arg[1][35] : 0;
  a24=(a03*a23);
  a12=(a12+a24);
  a12=(a14*a12);
  a24=arg[0]? arg[0][15] : 0;
  a25=(a07<a10);
  a26=arg[2]? arg[2][20] : 0;
  a26=(a25?a26:0);
  a25=(!a25);
  a25=(a25?a24:0);
  a26=(a26+a25);
  a25=(a24-a26);
  a27=casadi_fabs(a25);
  a28=arg[2]? arg[2][21] : 0;
  a28=(a24!=a28);
  a29=casadi_fabs(a25);
  a29=(a15*a29);
  a30=casadi_fabs(a24);
  a30=(a17*a30);
  a31=casadi_fabs(a26);
  a31=(a17*a31);
  a30=(a30+a31);
  a29=casadi_fmax(a29,a30);
  a29=(a28?a29:0);
  a28=(!a28);
  a30=arg[2]? arg[2][22] : 0;
  a28=(a28?a30:0);
  a29=(a29+a28);
  a27=(a27<=a29);
  a28=(a27?a24:0);
  a27=(!a27);
  a30=(a00<a25);
  a31=(a26+a29);
  a31=(a30?a31:0);
  a30=(!a30);
  a26=(a26-a29);
  a30=(a30?a26:0);
  a31=(a31+a30);
  a27=(a27?a31:0);
  a28=(a28+a27);
  a18=(a13*a18);
  a22=(a20*a22);
  a18=(a18+a22);
  a23=(a03*a23);
  a18=(a18+a23);
  a18=(a28*a18);
  a12=(a12+a18);
  a18=arg[1]? arg[1][31] : 0;
  a23=arg[3]? arg[3][4] : 0;
  a22=casadi_fabs(a23);
  a27=arg[0]? arg[0][6] : 0;
  a22=(a22<=a27);
  a23=(a22?a23:0);
  a27=(!a22);
  a31=arg[2]? arg[2][5] : 0;
  a27=(a27?a31:0);
  a23=(a23+a27);
  a18=(a18*a23);
  a12=(a12+a18);
  a18=arg[1]? arg[1][32] : 0;
  a27=arg[3]? arg[3][7] : 0;
  a31=casadi_fabs(a27);
  a30=arg[0]? arg[0][9] : 0;
  a31=(a31<=a30);
  a27=(a31?a27:0);
  a30=(!a31);
  a26=arg[2]? arg[2][8] : 0;
  a30=(a30?a26:0);
  a27=(a27+a30);
  a18=(a18*a27);
  a12=(a12+a18);
  a18=arg[0]? arg[0][56] : 0;
  a30=(a05-a18);
  a08=(a08*a30);
  a08=(-a08);
  a30=(a07<a10);
  a26=arg[2]? arg[2][28] : 0;
  a30=(a30?a26:0);
  a26=arg[0]? arg[0][34] : 0;
  a32=(a07<a10);
  a33=arg[2]? arg[2][25] : 0;
  a33=(a32?a33:0);
  a32=(!a32);
  a34=arg[3]? arg[3][5] : 0;
  a35=casadi_fabs(a34);
  a36=arg[0]? arg[0][7] : 0;
  a35=(a35<=a36);
  a34=(a35?a34:0);
  a36=(!a35);
  a37=arg[2]? arg[2][6] : 0;
  a36=(a36?a37:0);
  a34=(a34+a36);
  a36=arg[0]? arg[0][16] : 0;
  a37=arg[0]? arg[0][19] : 0;
  a38=(a36*a37);
  a39=casadi_fabs(a13);
  a36=casadi_fmax(a36,a39);
  a38=(a38/a36);
  a36=arg[1]? arg[1][2] : 0;
  a39=arg[1]? arg[1][1] : 0;
  a40=(a13*a39);
  a40=(a36+a40);
  a40=casadi_fmin(a05,a40);
  a40=casadi_fmax(a00,a40);
  a40=(a38*a40);
  a40=(-a40);
  a39=(a13*a39);
  a36=(a36-a39);
  a36=casadi_fmin(a05,a36);
  a36=casadi_fmax(a00,a36);
  a38=(a38*a36);
  a36=arg[0]? arg[0][30] : 0;
  a36=(a00<a36);
  a39=(a07<a10);
  a41=arg[2]? arg[2][10] : 0;
  a41=(a39?a41:0);
  a39=(!a39);
  a42=arg[0]? arg[0][11] : 0;
  a39=(a39?a42:0);
  a41=(a41+a39);
  a39=(a42-a41);
  a43=casadi_fabs(a39);
  a44=arg[2]? arg[2][11] : 0;
  a44=(a42!=a44);
  a45=casadi_fabs(a39);
  a45=(a15*a45);
  a46=casadi_fabs(a42);
  a46=(a17*a46);
  a47=casadi_fabs(a41);
  a47=(a17*a47);
  a46=(a46+a47);
  a45=casadi_fmax(a45,a46);
  a45=(a44?a45:0);
  a44=(!a44);
  a46=arg[2]? arg[2][12] : 0;
  a44=(a44?a46:0);
  a45=(a45+a44);
  a43=(a43<=a45);
  a44=(a43?a42:0);
  a43=(!a43);
  a46=(a00<a39);
  a47=(a41+a45);
  a47=(a46?a47:0);
  a46=(!a46);
  a48=(a41-a45);
  a46=(a46?a48:0);
  a47=(a47+a46);
  a43=(a43?a47:0);
  a44=(a44+a43);
  a41=(a41-a44);
  a41=(a23*a41);
  a36=(a36?a41:0);
  a41=(a07<a10);
  a43=arg[2]? arg[2][24] : 0;
  a41=(a41?a43:0);
  a36=(a36+a41);
  a41=(a07<a10);
  a43=arg[2]? arg[2][23] : 0;
  a43=(a41?a43:0);
  a41=(!a41);
  a41=(a41?a13:0);
  a43=(a43+a41);
  a41=arg[1]? arg[1][7] : 0;
  a47=(-a41);
  a46=arg[3]? arg[3][2] : 0;
  a48=casadi_fabs(a46);
  a49=arg[0]? arg[0][4] : 0;
  a48=(a48<=a49);
  a46=(a48?a46:0);
  a49=(!a48);
  a50=arg[2]? arg[2][3] : 0;
  a49=(a49?a50:0);
  a46=(a46+a49);
  a49=(a46-a43);
  a41=casadi_fmin(a41,a49);
  a47=casadi_fmax(a47,a41);
  a43=(a43+a47);
  a47=(a43-a13);
  a41=arg[0]? arg[0][29] : 0;
  a41=(a47*a41);
  a41=(a36+a41);
  a49=(a23*a44);
  a41=(a41+a49);
  a38=casadi_fmin(a38,a41);
  a40=casadi_fmax(a40,a38);
  a38=(a40-a23);
  a49=arg[1]? arg[1][10] : 0;
  a49=(a38*a49);
  a49=(a34+a49);
  a32=(a32?a49:0);
  a33=(a33+a32);
  a32=arg[1]? arg[1][11] : 0;
  a50=(-a32);
  a51=arg[3]? arg[3][0] : 0;
  a52=casadi_fabs(a51);
  a53=arg[0]? arg[0][2] : 0;
  a52=(a52<=a53);
  a51=(a52?a51:0);
  a53=(!a52);
  a54=arg[2]? arg[2][1] : 0;
  a53=(a53?a54:0);
  a51=(a51+a53);
  a53=(a51-a33);
  a32=casadi_fmin(a32,a53);
  a50=casadi_fmax(a50,a32);
  a33=(a33+a50);
  a26=(a26*a33);
  a26=(a30+a26);
  a50=(a07<a10);
  a32=arg[2]? arg[2][26] : 0;
  a32=(a50?a32:0);
  a50=(!a50);
  a50=(a50?a49:0);
  a32=(a32+a50);
  a50=(a07<a10);
  a53=arg[2]? arg[2][27] : 0;
  a54=(a50?a53:0);
  a55=arg[1]? arg[1][12] : 0;
  a56=(a33-a32);
  a55=(a55*a56);
  a54=(a54+a55);
  a55=arg[1]? arg[1][13] : 0;
  a55=(a55*a53);
  a55=(-a55);
  a50=(a50?a55:0);
  a54=(a54+a50);
  a50=arg[0]? arg[0][0] : 0;
  a55=(a54*a50);
  a32=(a32+a55);
  a55=arg[0]? arg[0][39] : 0;
  a53=(a32*a55);
  a53=(a53-a49);
  a55=(a05-a55);
  a55=(a33*a55);
  a53=(a53+a55);
  a55=arg[0]? arg[0][35] : 0;
  a55=(a53*a55);
  a26=(a26+a55);
  a55=arg[1]? arg[1][29] : 0;
  a55=(a26*a55);
  a49=arg[1]? arg[1][30] : 0;
  a56=(a07<a10);
  a57=arg[2]? arg[2][32] : 0;
  a56=(a56?a57:0);
  a57=arg[0]? arg[0][42] : 0;
  a58=(a07<a10);
  a59=arg[2]? arg[2][29] : 0;
  a59=(a58?a59:0);
  a58=(!a58);
  a60=arg[1]? arg[1][14] : 0;
  a60=(a38*a60);
  a60=(a27+a60);
  a58=(a58?a60:0);
  a59=(a59+a58);
  a58=arg[1]? arg[1][15] : 0;
  a61=(-a58);
  a62=arg[3]? arg[3][1] : 0;
  a63=casadi_fabs(a62);
  a64=arg[0]? arg[0][3] : 0;
  a63=(a63<=a64);
  a62=(a63?a62:0);
  a64=(!a63);
  a65=arg[2]? arg[2][2] : 0;
  a64=(a64?a65:0);
  a62=(a62+a64);
  a64=(a62-a59);
  a58=casadi_fmin(a58,a64);
  a61=casadi_fmax(a61,a58);
  a59=(a59+a61);
  a57=(a57*a59);
  a57=(a56+a57);
  a61=(a07<a10);
  a58=arg[2]? arg[2][30] : 0;
  a58=(a61?a58:0);
  a61=(!a61);
  a61=(a61?a60:0);
  a58=(a58+a61);
  a61=(a07<a10);
  a64=arg[2]? arg[2][31] : 0;
  a65=(a61?a64:0);
  a66=arg[1]? arg[1][16] : 0;
  a67=(a59-a58);
  a66=(a66*a67);
  a65=(a65+a66);
  a66=arg[1]? arg[1][17] : 0;
  a66=(a66*a64);
  a66=(-a66);
  a61=(a61?a66:0);
  a65=(a65+a61);
  a61=(a65*a50);
  a58=(a58+a61);
  a61=arg[0]? arg[0][47] : 0;
  a66=(a58*a61);
  a66=(a66-a60);
  a61=(a05-a61);
  a61=(a59*a61);
  a66=(a66+a61);
  a61=arg[0]? arg[0][43] : 0;
  a61=(a66*a61);
  a57=(a57+a61);
  a49=(a49*a57);
  a55=(a55+a49);
  a49=arg[1]? arg[1][28] : 0;
  a49=(a38*a49);
  a61=arg[0]? arg[0][12] : 0;
  a10=(a07<a10);
  a60=arg[2]? arg[2][14] : 0;
  a60=(a10?a60:0);
  a10=(!a10);
  a10=(a10?a61:0);
  a60=(a60+a10);
  a10=(a61-a60);
  a64=casadi_fabs(a10);
  a67=arg[2]? arg[2][15] : 0;
  a67=(a61!=a67);
  a68=casadi_fabs(a10);
  a15=(a15*a68);
  a68=casadi_fabs(a61);
  a68=(a17*a68);
  a69=casadi_fabs(a60);
  a17=(a17*a69);
  a68=(a68+a17);
  a15=casadi_fmax(a15,a68);
  a15=(a67?a15:0);
  a67=(!a67);
  a68=arg[2]? arg[2][16] : 0;
  a67=(a67?a68:0);
  a15=(a15+a67);
  a64=(a64<=a15);
  a67=(a64?a61:0);
  a64=(!a64);
  a68=(a00<a10);
  a17=(a60+a15);
  a17=(a68?a17:0);
  a68=(!a68);
  a60=(a60-a15);
  a68=(a68?a60:0);
  a17=(a17+a68);
  a64=(a64?a17:0);
  a67=(a67+a64);
  a49=(a49*a67);
  a55=(a55+a49);
  a18=(a05-a18);
  a18=(a02*a18);
  a18=casadi_fmin(a55,a18);
  a08=casadi_fmax(a08,a18);
  a12=(a12+a08);
  a02=casadi_fmin(a02,a12);
  a09=casadi_fmax(a09,a02);
  a02=casadi_fabs(a09);
  a12=1.0100000000000000e+00;
  a01=(a12*a01);
  a02=(a02<=a01);
  a01=(a02?a05:0);
  a01=(a01<a07);
  a18=arg[0]? arg[0][20] : 0;
  a49=arg[0]? arg[0][23] : 0;
  a64=(a18*a49);
  a17=casadi_fabs(a20);
  a18=casadi_fmax(a18,a17);
  a64=(a64/a18);
  a18=arg[1]? arg[1][4] : 0;
  a17=arg[1]? arg[1][3] : 0;
  a68=(a20*a17);
  a68=(a18+a68);
  a68=casadi_fmin(a05,a68);
  a68=casadi_fmax(a00,a68);
  a68=(a64*a68);
  a60=(-a68);
  a17=(a20*a17);
  a18=(a18-a17);
  a18=casadi_fmin(a05,a18);
  a18=casadi_fmax(a00,a18);
  a64=(a64*a18);
  a18=arg[1]? arg[1][23] : 0;
  a17=(a13*a18);
  a69=arg[1]? arg[1][24] : 0;
  a70=(a20*a69);
  a17=(a17+a70);
  a70=arg[1]? arg[1][25] : 0;
  a71=(a70*a03);
  a17=(a17+a71);
  a17=(a14*a17);
  a71=arg[1]? arg[1][21] : 0;
  a71=(a71*a23);
  a17=(a17+a71);
  a71=arg[1]? arg[1][22] : 0;
  a71=(a71*a34);
  a17=(a17+a71);
  a18=(a13*a18);
  a69=(a20*a69);
  a18=(a18+a69);
  a70=(a70*a03);
  a18=(a18+a70);
  a18=(a18*a28);
  a17=(a17+a18);
  a18=arg[0]? arg[0][53] : 0;
  a70=(a05-a18);
  a68=(a68*a70);
  a68=(-a68);
  a70=arg[1]? arg[1][19] : 0;
  a70=(a70*a26);
  a26=arg[1]? arg[1][20] : 0;
  a26=(a26*a57);
  a70=(a70+a26);
  a26=arg[1]? arg[1][18] : 0;
  a38=(a38*a26);
  a38=(a38*a67);
  a70=(a70+a38);
  a18=(a05-a18);
  a18=(a64*a18);
  a18=casadi_fmin(a70,a18);
  a68=casadi_fmax(a68,a18);
  a17=(a17+a68);
  a64=casadi_fmin(a64,a17);
  a60=casadi_fmax(a60,a64);
  a64=casadi_fabs(a60);
  a49=(a12*a49);
  a64=(a64<=a49);
  a49=(a64?a05:0);
  a49=(a49<a07);
  a17=casadi_fabs(a40);
  a12=(a12*a37);
  a17=(a17<=a12);
  a12=(a17?a05:0);
  a12=(a12<a07);
  a04=(a04?a05:0);
  a04=(a04<a07);
  a21=(a21?a05:0);
  a21=(a21<a07);
  a19=(a19?a05:0);
  a19=(a19<a07);
  a48=(a48?a05:0);
  a48=(a48<a07);
  a37=arg[2]? arg[2][0] : 0;
  a18=(a37<a07);
  a52=(a52?a05:0);
  a52=(a52<a07);
  a18=(a18&&a52);
  a52=(a18?a05:0);
  a18=(!a18);
  a18=(a18?a37:0);
  a52=(a52+a18);
  a18=(a52<a07);
  a63=(a63?a05:0);
  a63=(a63<a07);
  a18=(a18&&a63);
  a63=2.;
  a63=(a18?a63:0);
  a18=(!a18);
  a18=(a18?a52:0);
  a63=(a63+a18);
  a18=(a63<a07);
  a48=(a48&&a18);
  a18=3.;
  a18=(a48?a18:0);
  a48=(!a48);
  a48=(a48?a63:0);
  a18=(a18+a48);
  a48=(a18<a07);
  a19=(a19&&a48);
  a48=4.;
  a48=(a19?a48:0);
  a19=(!a19);
  a19=(a19?a18:0);
  a48=(a48+a19);
  a19=(a48<a07);
  a22=(a22?a05:0);
  a22=(a22<a07);
  a19=(a19&&a22);
  a22=5.;
  a22=(a19?a22:0);
  a19=(!a19);
  a19=(a19?a48:0);
  a22=(a22+a19);
  a19=(a22<a07);
  a35=(a35?a05:0);
  a35=(a35<a07);
  a19=(a19&&a35);
  a35=6.;
  a35=(a19?a35:0);
  a19=(!a19);
  a19=(a19?a22:0);
  a35=(a35+a19);
  a19=(a35<a07);
  a21=(a21&&a19);
  a19=7.;
  a19=(a21?a19:0);
  a21=(!a21);
  a21=(a21?a35:0);
  a19=(a19+a21);
  a21=(a19<a07);
  a31=(a31?a05:0);
  a31=(a31<a07);
  a21=(a21&&a31);
  a31=8.;
  a31=(a21?a31:0);
  a21=(!a21);
  a21=(a21?a19:0);
  a31=(a31+a21);
  a21=(a31<a07);
  a04=(a04&&a21);
  a21=9.;
  a21=(a04?a21:0);
  a04=(!a04);
  a04=(a04?a31:0);
  a21=(a21+a04);
  a04=(a21<a07);
  a12=(a12&&a04);
  a04=10.;
  a04=(a12?a04:0);
  a12=(!a12);
  a12=(a12?a21:0);
  a04=(a04+a12);
  a12=(a04<a07);
  a49=(a49&&a12);
  a12=11.;
  a12=(a49?a12:0);
  a49=(!a49);
  a49=(a49?a04:0);
  a12=(a12+a49);
  a49=(a12<a07);
  a01=(a01&&a49);
  a49=12.;
  a49=(a01?a49:0);
  a01=(!a01);
  a01=(a01?a12:0);
  a49=(a49+a01);
  if (res[0]!=0) res[0][0]=a49;
  if (res[0]!=0) res[0][1]=a51;
  if (res[0]!=0) res[0][2]=a62;
  if (res[0]!=0) res[0][3]=a46;
  if (res[0]!=0) res[0][4]=a13;
  if (res[0]!=0) res[0][5]=a23;
  if (res[0]!=0) res[0][6]=a34;
  if (res[0]!=0) res[0][7]=a20;
  if (res[0]!=0) res[0][8]=a27;
  if (res[0]!=0) res[0][9]=a03;
  if (res[0]!=0) res[0][10]=a44;
  if (res[0]!=0) res[0][11]=a42;
  a39=casadi_fabs(a39);
  a39=(a39<=a45);
  a39=(!a39);
  a39=(a39?a45:0);
  if (res[0]!=0) res[0][12]=a39;
  a39=(a49<a07);
  a39=(a39?a05:0);
  if (res[0]!=0) res[0][13]=a39;
  if (res[0]!=0) res[0][14]=a67;
  if (res[0]!=0) res[0][15]=a61;
  a10=casadi_fabs(a10);
  a10=(a10<=a15);
  a10=(!a10);
  a10=(a10?a15:0);
  if (res[0]!=0) res[0][16]=a10;
  if (res[0]!=0) res[0][17]=a14;
  if (res[0]!=0) res[0][18]=a06;
  a11=casadi_fabs(a11);
  a11=(a11<=a16);
  a11=(!a11);
  a11=(a11?a16:0);
  if (res[0]!=0) res[0][19]=a11;
  if (res[0]!=0) res[0][20]=a28;
  if (res[0]!=0) res[0][21]=a24;
  a25=casadi_fabs(a25);
  a25=(a25<=a29);
  a25=(!a25);
  a25=(a25?a29:0);
  if (res[0]!=0) res[0][22]=a25;
  if (res[0]!=0) res[0][23]=a43;
  a41=(a40-a41);
  a43=arg[1]? arg[1][9] : 0;
  a41=(a41*a43);
  a36=(a36+a41);
  a41=arg[1]? arg[1][8] : 0;
  a47=(a47*a41);
  a36=(a36+a47);
  if (res[0]!=0) res[0][24]=a36;
  if (res[0]!=0) res[0][25]=a33;
  if (res[0]!=0) res[0][26]=a32;
  if (res[0]!=0) res[0][27]=a54;
  a54=arg[1]? arg[1][27] : 0;
  a54=(a54*a53);
  a70=(a70-a68);
  a54=(a54*a70);
  a54=(a00<a54);
  a70=(a54?a30:0);
  a54=(!a54);
  a68=arg[0]? arg[0][54] : 0;
  a32=(-a68);
  a33=arg[1]? arg[1][26] : 0;
  a53=(a53*a33);
  a30=(a30+a53);
  a68=casadi_fmin(a68,a30);
  a32=casadi_fmax(a32,a68);
  a54=(a54?a32:0);
  a70=(a70+a54);
  if (res[0]!=0) res[0][28]=a70;
  if (res[0]!=0) res[0][29]=a59;
  if (res[0]!=0) res[0][30]=a58;
  if (res[0]!=0) res[0][31]=a65;
  a65=arg[1]? arg[1][37] : 0;
  a65=(a65*a66);
  a55=(a55-a08);
  a65=(a65*a55);
  a65=(a00<a65);
  a55=(a65?a56:0);
  a65=(!a65);
  a08=arg[0]? arg[0][57] : 0;
  a58=(-a08);
  a59=arg[1]? arg[1][36] : 0;
  a66=(a66*a59);
  a56=(a56+a66);
  a08=casadi_fmin(a08,a56);
  a58=casadi_fmax(a58,a08);
  a65=(a65?a58:0);
  a55=(a55+a65);
  if (res[0]!=0) res[0][32]=a55;
  a55=(a07<a49);
  a65=arg[2]? arg[2][33] : 0;
  a58=(a55?a65:0);
  a55=(!a55);
  a40=(a17?a40:0);
  a17=(!a17);
  a17=(a17?a65:0);
  a40=(a40+a17);
  a55=(a55?a40:0);
  a58=(a58+a55);
  if (res[0]!=0) res[0][33]=a58;
  a55=(a07<a49);
  a40=arg[2]? arg[2][34] : 0;
  a17=(a55?a40:0);
  a55=(!a55);
  a60=(a64?a60:0);
  a64=(!a64);
  a64=(a64?a40:0);
  a60=(a60+a64);
  a55=(a55?a60:0);
  a17=(a17+a55);
  if (res[0]!=0) res[0][34]=a17;
  a55=(a07<a49);
  a60=arg[2]? arg[2][35] : 0;
  a64=(a55?a60:0);
  a55=(!a55);
  a09=(a02?a09:0);
  a02=(!a02);
  a02=(a02?a60:0);
  a09=(a09+a02);
  a55=(a55?a09:0);
  a64=(a64+a55);
  if (res[0]!=0) res[0][35]=a64;
  a07=(a07<a49);
  a49=arg[2]? arg[2][36] : 0;
  a55=arg[0]? arg[0][1] : 0;
  a50=(a50/a55);
  a50=(a49-a50);
  a00=casadi_fmax(a00,a50);
  a00=(a07?a00:0);
  a07=(!a07);
  a07=(a07?a49:0);
  a00=(a00+a07);
  if (res[0]!=0) res[0][36]=a00;
  a58=(a58*a00);
  if (res[1]!=0) res[1][0]=a58;
  a17=(a17*a00);
  if (res[1]!=0) res[1][1]=a17;
  a64=(a64*a00);
  if (res[1]!=0) res[1][2]=a64;
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


