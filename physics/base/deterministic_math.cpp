// Elementary functions from additions, multiplications, divisions and square roots only, which IEEE 754
// rounds the same way everywhere. Accuracy: about 1e-12 relative (1e-15 for sine and cosine of small angles).
// Source: Cody and Waite, "Software Manual for the Elementary Functions", 1980.
#include <cmath>
#include <cstdint>
#include <limits>

#include <cairn/physics/math.h>

namespace cairn::physics::deterministic {
namespace {

constexpr double kHalfPi = 1.57079632679489661923;
constexpr double kPiDouble = 3.14159265358979323846;
constexpr double kLn2 = 0.69314718055994530942;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// pi/2 in three parts of 33 bits each: products with a quadrant number below 2^20 are exact.
constexpr double kHalfPi1 = 1.57079632673412561417;
constexpr double kHalfPi2 = 6.07710050630396597660e-11;
constexpr double kHalfPi3 = 2.02226624871116645580e-21;

// Beyond this the quadrant number loses its exactness, so whole turns are taken off first (fmod is exact).
constexpr double kLargeAngle = 1e6;

struct Reduced {
    double r;      // in [-pi/4, pi/4]
    int quadrant;  // 0..3
};

Reduced reduce(double angle) {
    if (std::fabs(angle) > kLargeAngle) angle = std::fmod(angle, 4 * kHalfPi);
    const double n = std::floor(angle / kHalfPi + 0.5);
    const double r = ((angle - n * kHalfPi1) - n * kHalfPi2) - n * kHalfPi3;
    return {r, static_cast<int>(static_cast<std::int64_t>(n) & 3)};
}

// Taylor series; on [-pi/4, pi/4] the first term left out is below 1e-16.
double sin_polynomial(double r) {
    const double z = r * r;
    const double tail =
        z * (-1.0 / 6 +
             z * (1.0 / 120 + z * (-1.0 / 5040 +
                                   z * (1.0 / 362880 + z * (-1.0 / 39916800 + z * (1.0 / 6227020800.0 -
                                                                                   z / 1307674368000.0))))));
    return r + r * tail;
}

double cos_polynomial(double r) {
    const double z = r * r;
    return 1 + z * (-0.5 + z * (1.0 / 24 +
                                z * (-1.0 / 720 +
                                     z * (1.0 / 40320 + z * (-1.0 / 3628800 +
                                                             z * (1.0 / 479001600.0 - z / 87178291200.0))))));
}

// atan on [0, tan(pi/16)] by its series; the argument is brought there by two half-angle steps.
double atan_small(double t) {
    const double z = t * t;
    double sum = 0;
    for (int k = 17; k >= 1; k -= 2) sum = 1.0 / k - z * sum;
    return t * sum;
}

// atan of t >= 0, t <= 1. tan(x/2) = t / (1 + sqrt(1 + t^2)).
double atan_unit(double t) {
    const double half = t / (1 + std::sqrt(1 + t * t));
    const double quarter = half / (1 + std::sqrt(1 + half * half));
    return 4 * atan_small(quarter);
}

}  // namespace

double sin(double angle_rad) {
    if (!std::isfinite(angle_rad)) return kNaN;
    const Reduced x = reduce(angle_rad);
    switch (x.quadrant) {
        case 0:
            return sin_polynomial(x.r);
        case 1:
            return cos_polynomial(x.r);
        case 2:
            return -sin_polynomial(x.r);
        default:
            return -cos_polynomial(x.r);
    }
}

double cos(double angle_rad) {
    if (!std::isfinite(angle_rad)) return kNaN;
    const Reduced x = reduce(angle_rad);
    switch (x.quadrant) {
        case 0:
            return cos_polynomial(x.r);
        case 1:
            return -sin_polynomial(x.r);
        case 2:
            return -cos_polynomial(x.r);
        default:
            return sin_polynomial(x.r);
    }
}

double tan(double angle_rad) {
    return sin(angle_rad) / cos(angle_rad);
}

double atan2(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) return kNaN;
    if (std::isinf(x) || std::isinf(y)) {  // only the quadrant, or the diagonal, is left
        x = std::isinf(x) ? std::copysign(1.0, x) : std::copysign(0.0, x);
        y = std::isinf(y) ? std::copysign(1.0, y) : std::copysign(0.0, y);
    }
    const double ax = std::fabs(x);
    const double ay = std::fabs(y);
    double angle = 0;
    if (ax == 0 && ay == 0) {
        angle = 0;
    } else if (ay <= ax) {
        angle = atan_unit(ay / ax);
    } else {
        angle = kHalfPi - atan_unit(ax / ay);
    }
    if (std::signbit(x)) angle = kPiDouble - angle;
    return std::copysign(angle, y);
}

double asin(double x) {
    return std::fabs(x) <= 1 ? atan2(x, std::sqrt((1 - x) * (1 + x))) : kNaN;
}

double acos(double x) {
    return std::fabs(x) <= 1 ? atan2(std::sqrt((1 - x) * (1 + x)), x) : kNaN;
}

double exp(double x) {
    if (std::isnan(x)) return x;
    if (x > 709.78) return kInfinity;
    if (x < -745.2) return 0;
    // x = n ln 2 + r, |r| <= ln(2)/2; ln 2 in two parts so that n ln 2 is nearly exact.
    const double n = std::floor(x / kLn2 + 0.5);
    const double r = (x - n * 6.93147180369123816490e-01) - n * 1.90821492927058770002e-10;
    double sum = 1;
    for (int k = 14; k >= 1; --k) sum = 1 + r * sum / k;
    return std::ldexp(sum, static_cast<int>(n));
}

double log(double x) {
    if (std::isnan(x) || x < 0) return kNaN;
    if (x == 0) return -kInfinity;
    if (std::isinf(x)) return x;
    int exponent = 0;
    double m = std::frexp(x, &exponent);  // in [0.5, 1)
    if (m < 0.70710678118654752440) {
        m *= 2;
        --exponent;
    }
    // log m = 2 atanh(s), s = (m - 1)/(m + 1), |s| <= 0.1716
    const double s = (m - 1) / (m + 1);
    const double z = s * s;
    double sum = 0;
    for (int k = 19; k >= 1; k -= 2) sum = 1.0 / k + z * sum;
    return exponent * 6.93147180369123816490e-01 + (2 * s * sum + exponent * 1.90821492927058770002e-10);
}

double pow(double base, double exponent) {
    if (exponent == 0 || base == 1) return 1;
    if (std::isnan(base) || std::isnan(exponent)) return kNaN;
    // Whole exponents by squaring: exact where the result is, and right for negative bases.
    if (std::floor(exponent) == exponent && std::fabs(exponent) <= 64) {
        double power = base;
        double result = 1;
        for (int n = static_cast<int>(std::fabs(exponent)); n > 0; n >>= 1, power *= power) {
            if (n & 1) result *= power;
        }
        return exponent < 0 ? 1 / result : result;
    }
    const double magnitude = std::fabs(base);
    double result = 0;
    if (std::isinf(exponent)) {
        if (magnitude == 1) return 1;
        return (magnitude > 1) == (exponent > 0) ? kInfinity : 0;
    }
    if (magnitude == 0) {
        result = exponent > 0 ? 0 : kInfinity;
    } else {
        result = exp(exponent * log(magnitude));
    }
    if (!std::signbit(base)) return result;
    if (std::floor(exponent) != exponent) return magnitude == 0 || std::isinf(magnitude) ? result : kNaN;
    return std::fmod(exponent, 2) != 0 ? -result : result;
}

}  // namespace cairn::physics::deterministic
