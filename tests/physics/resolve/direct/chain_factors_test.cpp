// The block-tridiagonal factorization, by what its solutions leave of the equations.
#include "resolve/direct/chain_factors.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "physics/support/random.h"

namespace cairn::physics {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

// As of a chain: A = J M^-1 J^T of random masses and arms, which is positive definite.
void fill(ChainFactors& a, int blocks, test::Random& random) {
    a.resize(blocks);
    std::vector<double> by_mass(at(blocks) + 1), by_inertia(at(blocks) + 1);
    for (double& x : by_mass) x = std::pow(10.0, random.real(-4, 1));
    for (double& x : by_inertia) x = std::pow(10.0, random.real(-3, 2));
    std::vector<double> bx(at(blocks)), by(at(blocks)), ax(at(blocks)), ay(at(blocks));
    for (std::vector<double>* arms : {&bx, &by, &ax, &ay}) {
        for (double& x : *arms) x = random.real(-1, 1);
    }
    for (std::size_t j = 0; j < at(blocks); ++j) {
        const double linear = by_mass[j] + by_mass[j + 1];
        const double before = by_inertia[j];
        const double after = by_inertia[j + 1];
        a.xx[j] = linear + before * by[j] * by[j] + after * ay[j] * ay[j];
        a.xy[j] = -before * bx[j] * by[j] - after * ax[j] * ay[j];
        a.yy[j] = linear + before * bx[j] * bx[j] + after * ax[j] * ax[j];
        if (j + 1 == at(blocks)) continue;
        a.a[j] = -by_mass[j + 1] - after * ay[j] * by[j + 1];
        a.b[j] = after * ay[j] * bx[j + 1];
        a.c[j] = after * ax[j] * by[j + 1];
        a.d[j] = -by_mass[j + 1] - after * ax[j] * bx[j + 1];
    }
}

}  // namespace

TEST_CASE("a row of any length is solved to rounding, from both of its ends") {
    test::Random random(5);
    for (const int blocks : {1, 2, 3, 4, 5, 8, 9, 100, 1001}) {
        INFO(blocks << " blocks");
        ChainFactors a;
        fill(a, blocks, random);
        std::vector<double> x(at(blocks)), y(at(blocks));
        for (double& value : x) value = random.real(-1, 1);
        for (double& value : y) value = random.real(-1, 1);
        const std::vector<double> wanted_x = x;
        const std::vector<double> wanted_y = y;
        a.factor();
        a.solve(x.data(), y.data());
        double left = 0;
        double terms = 0;  // that each of them is a sum of
        for (std::size_t i = 0; i < at(blocks); ++i) {
            double sum_x = a.xx[i] * x[i] + a.xy[i] * y[i];
            double sum_y = a.xy[i] * x[i] + a.yy[i] * y[i];
            terms = std::max(terms, (a.xx[i] + a.yy[i]) * (std::fabs(x[i]) + std::fabs(y[i])));
            if (i > 0) {
                sum_x += a.a[i - 1] * x[i - 1] + a.c[i - 1] * y[i - 1];
                sum_y += a.b[i - 1] * x[i - 1] + a.d[i - 1] * y[i - 1];
            }
            if (i + 1 < at(blocks)) {
                sum_x += a.a[i] * x[i + 1] + a.b[i] * y[i + 1];
                sum_y += a.c[i] * x[i + 1] + a.d[i] * y[i + 1];
            }
            left = std::max({left, std::fabs(sum_x - wanted_x[i]), std::fabs(sum_y - wanted_y[i])});
        }
        CHECK(left < 1e-13 * terms);
    }
}

}  // namespace cairn::physics
