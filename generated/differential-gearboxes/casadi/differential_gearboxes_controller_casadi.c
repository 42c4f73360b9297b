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
  casadi_real a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35;
  casadi_real a36, a37, a38, a39, a40, a41, a42, a43, a44, a45, a46, a47;
  casadi_real a48, a49, a50, a51, a52, a53, a54, a55, a56, a57, a58;
  a00=arg[0]? arg[0][16] : 0;
  a01=arg[0]? arg[0][17] : 0;
  a02=(a00*a01);
  a03=arg[3]? arg[3][7] : 0;
  a04=casadi_fabs(a03);
  a05=arg[0]? arg[0][9] : 0;
  a04=(a04<=a05);
  a03=(a04?a03:0);
  a05=(!a04);
  a06=arg[2]? arg[2][8] : 0;
  a05=(a05?a06:0);
  a03=(a03+a05);
  a05=casadi_fabs(a03);
  a00=casadi_fmax(a00,a05);
  a02=(a02/a00);
  a00=(-a02);
  a05=arg[2]? arg[2][10] : 0;
  a06=arg[3]? arg[3][2] : 0;
  a07=casadi_fabs(a06);
  a08=arg[0]? arg[0][4] : 0;
  a07=(a07<=a08);
  a06=(a07?a06:0);
  a08=(!a07);
  a09=arg[2]? arg[2][3] : 0;
  a08=(a08?a09:0);
  a06=(a06+a08);
  a08=(a06-a03);
  a09=arg[0]? arg[0][20] : 0;
  a10=(a08*a09);
  a10=(a05+a10);
  a11=arg[3]? arg[3][6] : 0;
  a12=casadi_fabs(a11);
  a13=arg[0]? arg[0][8] : 0;
  a12=(a12<=a13);
  a11=(a12?a11:0);
  a13=(!a12);
  a14=arg[2]? arg[2][7] : 0;
  a13=(a13?a14:0);
  a11=(a11+a13);
  a13=arg[0]? arg[0][10] : 0;
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
  a18=arg[0]? arg[0][14] : 0;
  a19=arg[0]? arg[0][15] : 0;
  a20=(a18*a19);
  a21=arg[3]? arg[3][5] : 0;
  a22=casadi_fabs(a21);
  a23=arg[0]? arg[0][7] : 0;
  a22=(a22<=a23);
  a21=(a22?a21:0);
  a23=(!a22);
  a24=arg[2]? arg[2][6] : 0;
  a23=(a23?a24:0);
  a21=(a21+a23);
  a23=casadi_fabs(a21);
  a18=casadi_fmax(a18,a23);
  a20=(a20/a18);
  a18=(-a20);
  a23=arg[2]? arg[2][9] : 0;
  a24=arg[3]? arg[3][1] : 0;
  a25=casadi_fabs(a24);
  a26=arg[0]? arg[0][3] : 0;
  a25=(a25<=a26);
  a24=(a25?a24:0);
  a26=(!a25);
  a27=arg[2]? arg[2][2] : 0;
  a26=(a26?a27:0);
  a24=(a24+a26);
  a26=(a24-a21);
  a27=arg[0]? arg[0][18] : 0;
  a28=(a26*a27);
  a28=(a23+a28);
  a29=arg[3]? arg[3][4] : 0;
  a30=casadi_fabs(a29);
  a31=arg[0]? arg[0][6] : 0;
  a30=(a30<=a31);
  a29=(a30?a29:0);
  a31=(!a30);
  a32=arg[2]? arg[2][5] : 0;
  a31=(a31?a32:0);
  a29=(a29+a31);
  a31=(a29*a13);
  a32=(a28-a31);
  a20=casadi_fmin(a20,a32);
  a18=casadi_fmax(a18,a20);
  a20=casadi_fabs(a18);
  a19=(a15*a19);
  a20=(a20<=a19);
  a19=(a20?a01:0);
  a19=(a19<a17);
  a32=arg[0]? arg[0][12] : 0;
  a33=arg[0]? arg[0][13] : 0;
  a34=(a32*a33);
  a35=arg[3]? arg[3][3] : 0;
  a36=casadi_fabs(a35);
  a37=arg[0]? arg[0][5] : 0;
  a36=(a36<=a37);
  a35=(a36?a35:0);
  a37=(!a36);
  a38=arg[2]? arg[2][4] : 0;
  a37=(a37?a38:0);
  a35=(a35+a37);
  a37=casadi_fabs(a35);
  a32=casadi_fmax(a32,a37);
  a34=(a34/a32);
  a32=(-a34);
  a37=arg[0]? arg[0][32] : 0;
  a38=(a37*a21);
  a39=arg[0]? arg[0][30] : 0;
  a38=(a38*a39);
  a40=arg[0]? arg[0][31] : 0;
  a38=(a38*a40);
  a41=arg[0]? arg[0][22] : 0;
  a42=(2.*a41);
  a38=(a38/a42);
  a42=(a37*a35);
  a38=(a38-a42);
  a37=(a37*a03);
  a37=(a37*a39);
  a37=(a37*a40);
  a42=arg[0]? arg[0][23] : 0;
  a43=(2.*a42);
  a37=(a37/a43);
  a38=(a38+a37);
  a37=arg[0]? arg[0][37] : 0;
  a43=(a01-a37);
  a43=(a34*a43);
  a43=(-a43);
  a44=arg[0]? arg[0][11] : 0;
  a45=arg[0]? arg[0][33] : 0;
  a31=(a18+a31);
  a46=(a45*a31);
  a46=(a46*a39);
  a46=(a46*a40);
  a47=arg[0]? arg[0][24] : 0;
  a48=(2.*a47);
  a48=(a48*a41);
  a46=(a46/a48);
  a14=(a00+a14);
  a48=(a45*a14);
  a48=(a48*a39);
  a48=(a48*a40);
  a49=arg[0]? arg[0][26] : 0;
  a50=(2.*a49);
  a50=(a50*a42);
  a48=(a48/a50);
  a46=(a46+a48);
  a44=(a44*a46);
  a46=arg[2]? arg[2][11] : 0;
  a48=arg[0]? arg[0][34] : 0;
  a50=arg[3]? arg[3][0] : 0;
  a51=casadi_fabs(a50);
  a52=arg[0]? arg[0][2] : 0;
  a51=(a51<=a52);
  a50=(a51?a50:0);
  a52=(!a51);
  a53=arg[2]? arg[2][1] : 0;
  a52=(a52?a53:0);
  a50=(a50+a52);
  a48=(a48*a50);
  a48=(a46+a48);
  a52=arg[2]? arg[2][12] : 0;
  a53=arg[2]? arg[2][13] : 0;
  a54=arg[0]? arg[0][0] : 0;
  a55=arg[0]? arg[0][39] : 0;
  a56=(a50-a52);
  a55=(a55*a56);
  a56=arg[0]? arg[0][40] : 0;
  a56=(a56*a53);
  a55=(a55-a56);
  a55=(a54*a55);
  a55=(a55/a45);
  a53=(a53+a55);
  a55=(a53*a54);
  a52=(a52+a55);
  a55=arg[0]? arg[0][41] : 0;
  a45=(a52*a55);
  a56=(a29*a41);
  a57=(a11*a42);
  a56=(a56+a57);
  a57=arg[0]? arg[0][28] : 0;
  a57=(a57*a31);
  a57=(a57/a47);
  a58=arg[0]? arg[0][29] : 0;
  a58=(a58*a14);
  a58=(a58/a49);
  a57=(a57+a58);
  a58=arg[0]? arg[0][25] : 0;
  a58=(a31*a58);
  a58=(a58*a41);
  a58=(a58/a47);
  a57=(a57+a58);
  a58=arg[0]? arg[0][27] : 0;
  a58=(a14*a58);
  a58=(a58*a42);
  a58=(a58/a49);
  a57=(a57+a58);
  a13=(a13*a57);
  a56=(a56+a13);
  a45=(a45-a56);
  a55=(a01-a55);
  a55=(a50*a55);
  a45=(a45+a55);
  a55=arg[0]? arg[0][35] : 0;
  a55=(a45*a55);
  a48=(a48+a55);
  a55=(a39*a40);
  a48=(a48/a55);
  a44=(a44+a48);
  a37=(a01-a37);
  a37=(a34*a37);
  a37=casadi_fmin(a44,a37);
  a43=casadi_fmax(a43,a37);
  a38=(a38+a43);
  a34=casadi_fmin(a34,a38);
  a32=casadi_fmax(a32,a34);
  a34=casadi_fabs(a32);
  a15=(a15*a33);
  a34=(a34<=a15);
  a15=(a34?a01:0);
  a15=(a15<a17);
  a04=(a04?a01:0);
  a04=(a04<a17);
  a22=(a22?a01:0);
  a22=(a22<a17);
  a36=(a36?a01:0);
  a36=(a36<a17);
  a07=(a07?a01:0);
  a07=(a07<a17);
  a25=(a25?a01:0);
  a25=(a25<a17);
  a51=(a51?a01:0);
  a51=(a51<a17);
  a33=arg[2]? arg[2][0] : 0;
  a38=(a33<a17);
  a51=(a51&&a38);
  a38=(a51?a01:0);
  a51=(!a51);
  a51=(a51?a33:0);
  a38=(a38+a51);
  a51=(a38<a17);
  a25=(a25&&a51);
  a51=2.;
  a51=(a25?a51:0);
  a25=(!a25);
  a25=(a25?a38:0);
  a51=(a51+a25);
  a25=(a51<a17);
  a07=(a07&&a25);
  a25=3.;
  a25=(a07?a25:0);
  a07=(!a07);
  a07=(a07?a51:0);
  a25=(a25+a07);
  a07=(a25<a17);
  a36=(a36&&a07);
  a07=4.;
  a07=(a36?a07:0);
  a36=(!a36);
  a36=(a36?a25:0);
  a07=(a07+a36);
  a36=(a07<a17);
  a30=(a30?a01:0);
  a30=(a30<a17);
  a36=(a36&&a30);
  a30=5.;
  a30=(a36?a30:0);
  a36=(!a36);
  a36=(a36?a07:0);
  a30=(a30+a36);
  a36=(a30<a17);
  a22=(a22&&a36);
  a36=6.;
  a36=(a22?a36:0);
  a22=(!a22);
  a22=(a22?a30:0);
  a36=(a36+a22);
  a22=(a36<a17);
  a12=(a12?a01:0);
  a12=(a12<a17);
  a22=(a22&&a12);
  a12=7.;
  a12=(a22?a12:0);
  a22=(!a22);
  a22=(a22?a36:0);
  a12=(a12+a22);
  a22=(a12<a17);
  a04=(a04&&a22);
  a22=8.;
  a22=(a04?a22:0);
  a04=(!a04);
  a04=(a04?a12:0);
  a22=(a22+a04);
  a04=(a22<a17);
  a15=(a15&&a04);
  a04=9.;
  a04=(a15?a04:0);
  a15=(!a15);
  a15=(a15?a22:0);
  a04=(a04+a15);
  a15=(a04<a17);
  a19=(a19&&a15);
  a15=10.;
  a15=(a19?a15:0);
  a19=(!a19);
  a19=(a19?a04:0);
  a15=(a15+a19);
  a19=(a15<a17);
  a16=(a16&&a19);
  a19=11.;
  a19=(a16?a19:0);
  a16=(!a16);
  a16=(a16?a15:0);
  a19=(a19+a16);
  if (res[0]!=0) res[0][0]=a19;
  if (res[0]!=0) res[0][1]=a50;
  if (res[0]!=0) res[0][2]=a24;
  if (res[0]!=0) res[0][3]=a06;
  if (res[0]!=0) res[0][4]=a35;
  if (res[0]!=0) res[0][5]=a29;
  if (res[0]!=0) res[0][6]=a21;
  if (res[0]!=0) res[0][7]=a11;
  if (res[0]!=0) res[0][8]=a03;
  a03=arg[0]? arg[0][19] : 0;
  a03=(a03*a54);
  a31=(a31-a28);
  a31=(a31/a27);
  a26=(a26+a31);
  a03=(a03*a26);
  a23=(a23+a03);
  if (res[0]!=0) res[0][9]=a23;
  a23=arg[0]? arg[0][21] : 0;
  a23=(a23*a54);
  a14=(a14-a10);
  a14=(a14/a09);
  a08=(a08+a14);
  a23=(a23*a08);
  a05=(a05+a23);
  if (res[0]!=0) res[0][10]=a05;
  a05=0.;
  a44=(a44-a43);
  a44=(a45*a44);
  a39=(a39*a40);
  a44=(a44/a39);
  a44=(a05<a44);
  a39=(a44?a46:0);
  a44=(!a44);
  a40=arg[0]? arg[0][38] : 0;
  a43=(-a40);
  a23=arg[0]? arg[0][36] : 0;
  a45=(a45*a23);
  a45=(a45*a54);
  a46=(a46+a45);
  a40=casadi_fmin(a40,a46);
  a43=casadi_fmax(a43,a40);
  a44=(a44?a43:0);
  a39=(a39+a44);
  if (res[0]!=0) res[0][11]=a39;
  if (res[0]!=0) res[0][12]=a52;
  if (res[0]!=0) res[0][13]=a53;
  a53=(a17<a19);
  a52=arg[2]? arg[2][14] : 0;
  a39=(a53?a52:0);
  a53=(!a53);
  a32=(a34?a32:0);
  a34=(!a34);
  a34=(a34?a52:0);
  a32=(a32+a34);
  a53=(a53?a32:0);
  a39=(a39+a53);
  if (res[0]!=0) res[0][14]=a39;
  a53=(a17<a19);
  a32=arg[2]? arg[2][15] : 0;
  a34=(a53?a32:0);
  a53=(!a53);
  a18=(a20?a18:0);
  a20=(!a20);
  a20=(a20?a32:0);
  a18=(a18+a20);
  a53=(a53?a18:0);
  a34=(a34+a53);
  if (res[0]!=0) res[0][15]=a34;
  a53=(a17<a19);
  a18=arg[2]? arg[2][16] : 0;
  a20=(a53?a18:0);
  a53=(!a53);
  a00=(a02?a00:0);
  a02=(!a02);
  a02=(a02?a18:0);
  a00=(a00+a02);
  a53=(a53?a00:0);
  a20=(a20+a53);
  if (res[0]!=0) res[0][16]=a20;
  a17=(a17<a19);
  a19=arg[2]? arg[2][17] : 0;
  a53=arg[0]? arg[0][1] : 0;
  a54=(a54/a53);
  a54=(a19-a54);
  a05=casadi_fmax(a05,a54);
  a05=(a17?a05:0);
  a17=(!a17);
  a17=(a17?a19:0);
  a05=(a05+a17);
  if (res[0]!=0) res[0][17]=a05;
  a39=(a39*a05);
  if (res[1]!=0) res[1][0]=a39;
  a34=(a34*a05);
  if (res[1]!=0) res[1][1]=a34;
  a20=(a20*a05);
  if (res[1]!=0) res[1][2]=a20;
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


