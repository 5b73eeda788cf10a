#pragma once

/// The elementary functions, our own: a system's libm rounds differently with and without fused multiply-add,
/// and the same request must give the same bytes everywhere. Only additions, multiplications, divisions and
/// square roots are used, all of which IEEE 754 rounds exactly. Largest errors found by
/// tests/core/elementary_test.cpp against long double libm are stated per function, in units in the last place (ulp).
namespace tuftwave::elementary {

struct SinCos {
    double sin, cos;
};

/// Sine and cosine of `x` radians, |x| <= 1e6. At most 0.85 ulp off.
SinCos sincos(double x);
double sin(double x);
double cos(double x);

/// The angle of the point (x, y), radians in [-pi, pi], for finite x and y; atan2(0, 0) is 0. At most 0.55 ulp off.
double atan2(double y, double x);

/// The angle whose cosine is `x`, radians in [0, pi]; `x` is clamped to [-1, 1]. At most 1.6 ulp off.
double acos(double x);

/// e to the power of `x`; 0 below -745.2, infinity above 709.8.
/// At most 0.65 ulp off, 0.85 where the result is subnormal.
double exp(double x);

/// Natural logarithm of a positive, finite `x`. At most 0.51 ulp off.
double log(double x);

/// `x` to the power of `y`, both finite, x >= 0; 0 to a positive power is 0, anything to the power 0 is 1 and to the
/// power 1 itself. At most 0.65 ulp off, 0.85 where the result is subnormal.
double pow(double x, double y);

}  // namespace tuftwave::elementary
