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
CASADI_SYMBOL_EXPORT void differential_gearboxes_controller_casadi_casadi_version(int* major, int* minor, int* patch) {
  *major = 3;
  *minor = 8;
  *patch = 2;
}
CASADI_SYMBOL_EXPORT int differential_gearboxes_controller_casadi_casadi_int_size(void) { return (int) sizeof(casadi_int); }
CASADI_SYMBOL_EXPORT int differential_gearboxes_controller_casadi_casadi_real_size(void) { return (int) sizeof(casadi_real); }

static const casadi_int casadi_s0[3] = {42, 1, 1};
static const casadi_int casadi_s1[3] = {0, 1, 1};
static const casadi_int casadi_s2[3] = {18, 1, 1};
static const casadi_int casadi_s3[3] = {8, 1, 1};
static const casadi_int casadi_s4[3] = {3, 1, 1};

/* controller_step:(parameters[42],derived[0],states[18],inputs[8])->(next_states[18],outputs[3]) */
static int casadi_f0(const casadi_real** arg, casadi_real** res, casadi_int* iw, casadi_real* w, int mem) {
  casadi_real a00, a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11;
  casadi_real a12, a13, a14, a15, a16, a17, a18, a19, a20, a21, a22, a23;
  casadi_real a24, a25;
  a00=arg[3]? arg[3][7] : 0;
  a01=casadi_fabs(a00);
  a02=arg[0]? arg[0][9] : 0;
  a01=(a01<=a02);
  a02=1.;
  a03=(a01?a02:0);
  a04=5.0000000000000000e-01;
  a03=(a03<a04);
  a05=arg[3]? arg[3][5] : 0;
  a06=casadi_fabs(a05);
  a07=arg[0]? arg[0][7] : 0;
  a06=(a06<=a07);
  a07=(a06?a02:0);
  a07=(a07<a04);
  a08=arg[3]? arg[3][3] : 0;
  a09=casadi_fabs(a08);
  a10=arg[0]? arg[0][5] : 0;
  a09=(a09<=a10);
  a10=(a09?a02:0);
  a10=(a10<a04);
  a11=arg[3]? arg[3][2] : 0;
  a12=casadi_fabs(a11);
  a13=arg[0]? arg[0][4] : 0;
  a12=(a12<=a13);
  a13=(a12?a02:0);
  a13=(a13<a04);
  a14=arg[3]? arg[3][1] : 0;
  a15=casadi_fabs(a14);
  a16=arg[0]? arg[0][3] : 0;
  a15=(a15<=a16);
  a16=(a15?a02:0);
  a16=(a16<a04);
  a17=arg[3]? arg[3][0] : 0;
  a18=casadi_fabs(a17);
  a19=arg[0]? arg[0][2] : 0;
  a18=(a18<=a19);
  a19=(a18?a02:0);
  a19=(a19<a04);
  a20=arg[2]? arg[2][0] : 0;
  a21=(a20<a04);
  a19=(a19&&a21);
  a21=(a19?a02:0);
  a19=(!a19);
  a19=(a19?a20:0);
  a21=(a21+a19);
  a19=(a21<a04);
  a16=(a16&&a19);
  a19=2.;
  a19=(a16?a19:0);
  a16=(!a16);
  a16=(a16?a21:0);
  a19=(a19+a16);
  a16=(a19<a04);
  a13=(a13&&a16);
  a16=3.;
  a16=(a13?a16:0);
  a13=(!a13);
  a13=(a13?a19:0);
  a16=(a16+a13);
  a13=(a16<a04);
  a10=(a10&&a13);
  a13=4.;
  a13=(a10?a13:0);
  a10=(!a10);
  a10=(a10?a16:0);
  a13=(a13+a10);
  a10=(a13<a04);
  a16=arg[3]? arg[3][4] : 0;
  a19=casadi_fabs(a16);
  a21=arg[0]? arg[0][6] : 0;
  a19=(a19<=a21);
  a21=(a19?a02:0);
  a21=(a21<a04);
  a10=(a10&&a21);
  a21=5.;
  a21=(a10?a21:0);
  a10=(!a10);
  a10=(a10?a13:0);
  a21=(a21+a10);
  a10=(a21<a04);
  a07=(a07&&a10);
  a10=6.;
  a10=(a07?a10:0);
  a07=(!a07);
  a07=(a07?a21:0);
  a10=(a10+a07);
  a07=(a10<a04);
  a21=arg[3]? arg[3][6] : 0;
  a13=casadi_fabs(a21);
  a20=arg[0]? arg[0][8] : 0;
  a13=(a13<=a20);
  a20=(a13?a02:0);
  a20=(a20<a04);
  a07=(a07&&a20);
  a20=7.;
  a20=(a07?a20:0);
  a07=(!a07);
  a07=(a07?a10:0);
  a20=(a20+a07);
  a07=(a20<a04);
  a03=(a03&&a07);
  a07=8.;
  a07=(a03?a07:0);
  a03=(!a03);
  a03=(a03?a20:0);
  a07=(a07+a03);
  if (res[0]!=0) res[0][0]=a07;
  a17=(a18?a17:0);
  a18=(!a18);
  a03=arg[2]? arg[2][1] : 0;
  a18=(a18?a03:0);
  a17=(a17+a18);
  if (res[0]!=0) res[0][1]=a17;
  a14=(a15?a14:0);
  a15=(!a15);
  a18=arg[2]? arg[2][2] : 0;
  a15=(a15?a18:0);
  a14=(a14+a15);
  if (res[0]!=0) res[0][2]=a14;
  a11=(a12?a11:0);
  a12=(!a12);
  a15=arg[2]? arg[2][3] : 0;
  a12=(a12?a15:0);
  a11=(a11+a12);
  if (res[0]!=0) res[0][3]=a11;
  a08=(a09?a08:0);
  a09=(!a09);
  a12=arg[2]? arg[2][4] : 0;
  a09=(a09?a12:0);
  a08=(a08+a09);
  if (res[0]!=0) res[0][4]=a08;
  a16=(a19?a16:0);
  a19=(!a19);
  a09=arg[2]? arg[2][5] : 0;
  a19=(a19?a09:0);
  a16=(a16+a19);
  if (res[0]!=0) res[0][5]=a16;
  a05=(a06?a05:0);
  a06=(!a06);
  a19=arg[2]? arg[2][6] : 0;
  a06=(a06?a19:0);
  a05=(a05+a06);
  if (res[0]!=0) res[0][6]=a05;
  a21=(a13?a21:0);
  a13=(!a13);
  a06=arg[2]? arg[2][7] : 0;
  a13=(a13?a06:0);
  a21=(a21+a13);
  if (res[0]!=0) res[0][7]=a21;
  a00=(a01?a00:0);
  a01=(!a01);
  a13=arg[2]? arg[2][8] : 0;
  a01=(a01?a13:0);
  a00=(a00+a01);
  if (res[0]!=0) res[0][8]=a00;
  a01=arg[2]? arg[2][9] : 0;
  a13=arg[0]? arg[0][19] : 0;
  a06=arg[0]? arg[0][0] : 0;
  a13=(a13*a06);
  a14=(a14-a05);
  a19=arg[0]? arg[0][14] : 0;
  a09=arg[0]? arg[0][15] : 0;
  a09=(a19*a09);
  a12=casadi_fabs(a05);
  a19=casadi_fmax(a19,a12);
  a09=(a09/a19);
  a19=(-a09);
  a12=arg[0]? arg[0][18] : 0;
  a15=(a14*a12);
  a15=(a01+a15);
  a18=arg[0]? arg[0][10] : 0;
  a03=(a16*a18);
  a20=(a15-a03);
  a09=casadi_fmin(a09,a20);
  a19=casadi_fmax(a19,a09);
  a03=(a19+a03);
  a15=(a03-a15);
  a15=(a15/a12);
  a14=(a14+a15);
  a13=(a13*a14);
  a01=(a01+a13);
  if (res[0]!=0) res[0][9]=a01;
  a01=arg[2]? arg[2][10] : 0;
  a13=arg[0]? arg[0][21] : 0;
  a13=(a13*a06);
  a11=(a11-a00);
  a14=arg[0]? arg[0][16] : 0;
  a15=arg[0]? arg[0][17] : 0;
  a15=(a14*a15);
  a12=casadi_fabs(a00);
  a14=casadi_fmax(a14,a12);
  a15=(a15/a14);
  a14=(-a15);
  a12=arg[0]? arg[0][20] : 0;
  a09=(a11*a12);
  a09=(a01+a09);
  a20=(a21*a18);
  a10=(a09-a20);
  a15=casadi_fmin(a15,a10);
  a14=casadi_fmax(a14,a15);
  a20=(a14+a20);
  a09=(a20-a09);
  a09=(a09/a12);
  a11=(a11+a09);
  a13=(a13*a11);
  a01=(a01+a13);
  if (res[0]!=0) res[0][10]=a01;
  a01=0.;
  a13=arg[2]? arg[2][12] : 0;
  a11=arg[2]? arg[2][13] : 0;
  a09=arg[0]? arg[0][39] : 0;
  a12=(a17-a13);
  a09=(a09*a12);
  a12=arg[0]? arg[0][40] : 0;
  a12=(a12*a11);
  a09=(a09-a12);
  a09=(a06*a09);
  a12=arg[0]? arg[0][33] : 0;
  a09=(a09/a12);
  a11=(a11+a09);
  a09=(a11*a06);
  a13=(a13+a09);
  a09=arg[0]? arg[0][41] : 0;
  a15=(a13*a09);
  a10=arg[0]? arg[0][22] : 0;
  a16=(a16*a10);
  a22=arg[0]? arg[0][23] : 0;
  a21=(a21*a22);
  a16=(a16+a21);
  a21=arg[0]? arg[0][28] : 0;
  a21=(a21*a03);
  a23=arg[0]? arg[0][24] : 0;
  a21=(a21/a23);
  a24=arg[0]? arg[0][29] : 0;
  a24=(a24*a20);
  a25=arg[0]? arg[0][26] : 0;
  a24=(a24/a25);
  a21=(a21+a24);
  a24=arg[0]? arg[0][25] : 0;
  a24=(a03*a24);
  a24=(a24*a10);
  a24=(a24/a23);
  a21=(a21+a24);
  a24=arg[0]? arg[0][27] : 0;
  a24=(a20*a24);
  a24=(a24*a22);
  a24=(a24/a25);
  a21=(a21+a24);
  a18=(a18*a21);
  a16=(a16+a18);
  a15=(a15-a16);
  a09=(a02-a09);
  a09=(a17*a09);
  a15=(a15+a09);
  a09=arg[0]? arg[0][11] : 0;
  a03=(a12*a03);
  a16=arg[0]? arg[0][30] : 0;
  a03=(a03*a16);
  a18=arg[0]? arg[0][31] : 0;
  a03=(a03*a18);
  a23=(2.*a23);
  a23=(a23*a10);
  a03=(a03/a23);
  a12=(a12*a20);
  a12=(a12*a16);
  a12=(a12*a18);
  a25=(2.*a25);
  a25=(a25*a22);
  a12=(a12/a25);
  a03=(a03+a12);
  a09=(a09*a03);
  a03=arg[2]? arg[2][11] : 0;
  a12=arg[0]? arg[0][34] : 0;
  a12=(a12*a17);
  a12=(a03+a12);
  a17=arg[0]? arg[0][35] : 0;
  a17=(a15*a17);
  a12=(a12+a17);
  a17=(a16*a18);
  a12=(a12/a17);
  a09=(a09+a12);
  a12=arg[0]? arg[0][12] : 0;
  a17=arg[0]? arg[0][13] : 0;
  a17=(a12*a17);
  a25=casadi_fabs(a08);
  a12=casadi_fmax(a12,a25);
  a17=(a17/a12);
  a12=arg[0]? arg[0][37] : 0;
  a25=(a02-a12);
  a25=(a17*a25);
  a25=(-a25);
  a02=(a02-a12);
  a02=(a17*a02);
  a02=casadi_fmin(a09,a02);
  a25=casadi_fmax(a25,a02);
  a09=(a09-a25);
  a09=(a15*a09);
  a02=(a16*a18);
  a09=(a09/a02);
  a09=(a01<a09);
  a02=(a09?a03:0);
  a09=(!a09);
  a12=arg[0]? arg[0][38] : 0;
  a20=(-a12);
  a23=arg[0]? arg[0][36] : 0;
  a15=(a15*a23);
  a15=(a15*a06);
  a03=(a03+a15);
  a12=casadi_fmin(a12,a03);
  a20=casadi_fmax(a20,a12);
  a09=(a09?a20:0);
  a02=(a02+a09);
  if (res[0]!=0) res[0][11]=a02;
  if (res[0]!=0) res[0][12]=a13;
  if (res[0]!=0) res[0][13]=a11;
  a11=(a04<a07);
  a13=arg[2]? arg[2][14] : 0;
  a02=arg[0]? arg[0][1] : 0;
  a06=(a06/a02);
  a06=(a13-a06);
  a01=casadi_fmax(a01,a06);
  a01=(a11?a01:0);
  a11=(!a11);
  a11=(a11?a13:0);
  a01=(a01+a11);
  if (res[0]!=0) res[0][14]=a01;
  a11=(a04<a07);
  a13=arg[2]? arg[2][15] : 0;
  a13=(a11?a13:0);
  a11=(!a11);
  a06=(-a17);
  a02=arg[0]? arg[0][32] : 0;
  a05=(a02*a05);
  a05=(a05*a16);
  a05=(a05*a18);
  a10=(2.*a10);
  a05=(a05/a10);
  a08=(a02*a08);
  a05=(a05-a08);
  a02=(a02*a00);
  a02=(a02*a16);
  a02=(a02*a18);
  a22=(2.*a22);
  a02=(a02/a22);
  a05=(a05+a02);
  a05=(a05+a25);
  a17=casadi_fmin(a17,a05);
  a06=casadi_fmax(a06,a17);
  a11=(a11?a06:0);
  a13=(a13+a11);
  if (res[0]!=0) res[0][15]=a13;
  a11=(a04<a07);
  a06=arg[2]? arg[2][16] : 0;
  a06=(a11?a06:0);
  a11=(!a11);
  a11=(a11?a19:0);
  a06=(a06+a11);
  if (res[0]!=0) res[0][16]=a06;
  a04=(a04<a07);
  a07=arg[2]? arg[2][17] : 0;
  a07=(a04?a07:0);
  a04=(!a04);
  a04=(a04?a14:0);
  a07=(a07+a04);
  if (res[0]!=0) res[0][17]=a07;
  a13=(a13*a01);
  if (res[1]!=0) res[1][0]=a13;
  a06=(a06*a01);
  if (res[1]!=0) res[1][1]=a06;
  a07=(a07*a01);
  if (res[1]!=0) res[1][2]=a07;
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


