/* How to prefix internal symbols */
#ifdef CASADI_CODEGEN_PREFIX
  #define CASADI_NAMESPACE_CONCAT(NS, ID) _CASADI_NAMESPACE_CONCAT(NS, ID)
  #define _CASADI_NAMESPACE_CONCAT(NS, ID) NS ## ID
  #define CASADI_PREFIX(ID) CASADI_NAMESPACE_CONCAT(CODEGEN_PREFIX, ID)
#else
  #define CASADI_PREFIX(ID) clutch_rig_controller_casadi_ ## ID
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
#define casadi_fabs CASADI_PREFIX(fabs)
#define casadi_fmax CASADI_PREFIX(fmax)
#define casadi_fmin CASADI_PREFIX(fmin)
#define casadi_s0 CASADI_PREFIX(s0)
#define casadi_s1 CASADI_PREFIX(s1)
#define casadi_s2 CASADI_PREFIX(s2)
#define casadi_s3 CASADI_PREFIX(s3)
#define casadi_s4 CASADI_PREFIX(s4)

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
CASADI_SYMBOL_EXPORT void clutch_rig_controller_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int clutch_rig_controller_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int clutch_rig_controller_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {18, 1, 1};
static const casadi_int casadi_s1[3] = {0, 1, 1};
static const casadi_int casadi_s2[3] = {12, 1, 1};
static const casadi_int casadi_s3[3] = {6, 1, 1};
static const casadi_int casadi_s4[3] = {2, 1, 1};

/* controller_step:(parameters[18],derived[0],states[12],inputs[6])->(next_states[12],outputs[2]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32;
  a00=arg[0]? arg[0][12] : 0;
  a01=arg[0]? arg[0][13] : 0;
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
  a00=(-a02);
  a05=arg[2]? arg[2][8] : 0;
  a06=arg[3]? arg[3][1] : 0;
  a07=casadi_fabs(a06);
  a08=arg[0]? arg[0][3] : 0;
  a07=(a07<=a08);
  a06=(a07?a06:0);
  a08=(!a07);
  a09=arg[2]? arg[2][2] : 0;
  a08=(a08?a09:0);
  a06=(a06+a08);
  a08=(a06-a03);
  a09=arg[0]? arg[0][16] : 0;
  a10=(a08*a09);
  a10=(a05+a10);
  a11=arg[3]? arg[3][4] : 0;
  a12=casadi_fabs(a11);
  a13=arg[0]? arg[0][6] : 0;
  a12=(a12<=a13);
  a11=(a12?a11:0);
  a13=(!a12);
  a14=arg[2]? arg[2][5] : 0;
  a13=(a13?a14:0);
  a11=(a11+a13);
  a13=arg[0]? arg[0][8] : 0;
  a14=(a11*a13);
  a15=(a10-a14);
  a02=casadi_fmin(a02,a15);
  a00=casadi_fmax(a00,a02);
  a02=casadi_fabs(a00);
  a15=1.0100000000000000e+00;
  a01=(a15*a01);
  a02=(a02<=a01);
  a01=1.;
  a16=(a02?a01:0);
  a17=5.0000000000000000e-01;
  a16=(a16<a17);
  a18=arg[0]? arg[0][10] : 0;
  a19=arg[0]? arg[0][11] : 0;
  a20=(a18*a19);
  a21=arg[3]? arg[3][2] : 0;
  a22=casadi_fabs(a21);
  a23=arg[0]? arg[0][4] : 0;
  a22=(a22<=a23);
  a21=(a22?a21:0);
  a23=(!a22);
  a24=arg[2]? arg[2][3] : 0;
  a23=(a23?a24:0);
  a21=(a21+a23);
  a23=casadi_fabs(a21);
  a18=casadi_fmax(a18,a23);
  a20=(a20/a18);
  a18=(-a20);
  a23=arg[2]? arg[2][7] : 0;
  a24=arg[3]? arg[3][0] : 0;
  a25=casadi_fabs(a24);
  a26=arg[0]? arg[0][2] : 0;
  a25=(a25<=a26);
  a24=(a25?a24:0);
  a26=(!a25);
  a27=arg[2]? arg[2][1] : 0;
  a26=(a26?a27:0);
  a24=(a24+a26);
  a26=(a24-a21);
  a27=arg[0]? arg[0][14] : 0;
  a28=(a26*a27);
  a28=(a23+a28);
  a29=arg[3]? arg[3][3] : 0;
  a30=casadi_fabs(a29);
  a31=arg[0]? arg[0][5] : 0;
  a30=(a30<=a31);
  a29=(a30?a29:0);
  a31=(!a30);
  a32=arg[2]? arg[2][4] : 0;
  a31=(a31?a32:0);
  a29=(a29+a31);
  a13=(a29*a13);
  a31=(a28+a13);
  a20=casadi_fmin(a20,a31);
  a18=casadi_fmax(a18,a20);
  a20=casadi_fabs(a18);
  a15=(a15*a19);
  a20=(a20<=a15);
  a15=(a20?a01:0);
  a15=(a15<a17);
  a04=(a04?a01:0);
  a04=(a04<a17);
  a22=(a22?a01:0);
  a22=(a22<a17);
  a07=(a07?a01:0);
  a07=(a07<a17);
  a25=(a25?a01:0);
  a25=(a25<a17);
  a19=arg[2]? arg[2][0] : 0;
  a31=(a19<a17);
  a25=(a25&&a31);
  a31=(a25?a01:0);
  a25=(!a25);
  a25=(a25?a19:0);
  a31=(a31+a25);
  a25=(a31<a17);
  a07=(a07&&a25);
  a25=2.;
  a25=(a07?a25:0);
  a07=(!a07);
  a07=(a07?a31:0);
  a25=(a25+a07);
  a07=(a25<a17);
  a22=(a22&&a07);
  a07=3.;
  a07=(a22?a07:0);
  a22=(!a22);
  a22=(a22?a25:0);
  a07=(a07+a22);
  a22=(a07<a17);
  a30=(a30?a01:0);
  a30=(a30<a17);
  a22=(a22&&a30);
  a30=4.;
  a30=(a22?a30:0);
  a22=(!a22);
  a22=(a22?a07:0);
  a30=(a30+a22);
  a22=(a30<a17);
  a12=(a12?a01:0);
  a12=(a12<a17);
  a22=(a22&&a12);
  a12=5.;
  a12=(a22?a12:0);
  a22=(!a22);
  a22=(a22?a30:0);
  a12=(a12+a22);
  a22=(a12<a17);
  a04=(a04&&a22);
  a22=6.;
  a22=(a04?a22:0);
  a04=(!a04);
  a04=(a04?a12:0);
  a22=(a22+a04);
  a04=(a22<a17);
  a15=(a15&&a04);
  a04=7.;
  a04=(a15?a04:0);
  a15=(!a15);
  a15=(a15?a22:0);
  a04=(a04+a15);
  a15=(a04<a17);
  a16=(a16&&a15);
  a15=8.;
  a15=(a16?a15:0);
  a16=(!a16);
  a16=(a16?a04:0);
  a15=(a15+a16);
  if (res[0]!=0) res[0][0]=a15;
  if (res[0]!=0) res[0][1]=a24;
  if (res[0]!=0) res[0][2]=a06;
  if (res[0]!=0) res[0][3]=a21;
  if (res[0]!=0) res[0][4]=a29;
  if (res[0]!=0) res[0][5]=a11;
  if (res[0]!=0) res[0][6]=a03;
  a03=arg[0]? arg[0][15] : 0;
  a11=arg[0]? arg[0][0] : 0;
  a03=(a03*a11);
  a13=(a18-a13);
  a13=(a13-a28);
  a13=(a13/a27);
  a26=(a26+a13);
  a03=(a03*a26);
  a23=(a23+a03);
  if (res[0]!=0) res[0][7]=a23;
  a23=arg[0]? arg[0][17] : 0;
  a23=(a23*a11);
  a14=(a00+a14);
  a14=(a14-a10);
  a14=(a14/a09);
  a08=(a08+a14);
  a23=(a23*a08);
  a05=(a05+a23);
  if (res[0]!=0) res[0][8]=a05;
  a05=(a17<a15);
  a23=arg[2]? arg[2][9] : 0;
  a08=(a05?a23:0);
  a05=(!a05);
  a18=(a20?a18:0);
  a20=(!a20);
  a20=(a20?a23:0);
  a18=(a18+a20);
  a05=(a05?a18:0);
  a08=(a08+a05);
  if (res[0]!=0) res[0][9]=a08;
  a05=(a17<a15);
  a18=arg[2]? arg[2][10] : 0;
  a20=(a05?a18:0);
  a05=(!a05);
  a00=(a02?a00:0);
  a02=(!a02);
  a02=(a02?a18:0);
  a00=(a00+a02);
  a05=(a05?a00:0);
  a20=(a20+a05);
  if (res[0]!=0) res[0][10]=a20;
  a17=(a17<a15);
  a15=0.;
  a05=arg[2]? arg[2][11] : 0;
  a00=arg[0]? arg[0][1] : 0;
  a11=(a11/a00);
  a11=(a05-a11);
  a15=casadi_fmax(a15,a11);
  a15=(a17?a15:0);
  a17=(!a17);
  a17=(a17?a05:0);
  a15=(a15+a17);
  if (res[0]!=0) res[0][11]=a15;
  a08=(a08*a15);
  if (res[1]!=0) res[1][0]=a08;
  a20=(a20*a15);
  if (res[1]!=0) res[1][1]=a20;
  return 0;
}

CASADI_SYMBOL_EXPORT int controller_step(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem){
  return casadi_f0(arg, res, iw, w, mem);
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


