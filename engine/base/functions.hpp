#pragma once

/// Elementary functions with the same bits on every processor: SLEEF's variants without contraction, 1.0 ulp. (libm
/// picks other code on other processors.)
namespace pantin::functions {

double sin(double x);
double cos(double x);
double tan(double x);
double asin(double x);
double acos(double x);
double atan(double x);
double atan2(double y, double x);
double sinh(double x);
double cosh(double x);
double tanh(double x);
double exp(double x);
double log(double x);
double log2(double x);
double log10(double x);
double pow(double x, double y);

}  // namespace pantin::functions
