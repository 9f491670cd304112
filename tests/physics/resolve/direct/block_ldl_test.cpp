// The sparse factorization against Gaussian elimination with pivots.
#include "resolve/direct/block_ldl.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <vector>

#include <cairn/physics/simd.h>

#include "physics/support/random.h"

namespace cairn::physics {
namespace {

using Dense = std::vector<std::vector<double>>;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

std::vector<double> solve_dense(Dense a, std::vector<double> b) {
    const std::size_t n = b.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t best = k;
        for (std::size_t i = k + 1; i < n; ++i) {
            if (std::fabs(a[i][k]) > std::fabs(a[best][k])) best = i;
        }
        std::swap(a[k], a[best]);
        std::swap(b[k], b[best]);
        for (std::size_t i = k + 1; i < n; ++i) {
            const double factor = a[i][k] / a[k][k];
            for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
            b[i] -= factor * b[k];
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
        b[k] /= a[k][k];
    }
    return b;
}

// A quasi-definite system: bodies of size 3, then joints of the given sizes on two bodies each.
struct Problem {
    std::vector<BlockLdl::Node> nodes;
    std::vector<BlockLdl::Edge> edges;
    double give = 1e-6;
    BlockLdl system;
    Dense dense;

    void body() { nodes.push_back({3, false}); }
    void joint(int size, int a, int b) {
        const int node = static_cast<int>(nodes.size());
        nodes.push_back({size, true});
        edges.push_back({a, node});
        if (b >= 0) edges.push_back({b, node});
    }
    void fill(test::Random& random) {
        system.analyze(nodes, edges);
        dense.assign(at(system.size()), std::vector<double>(at(system.size()), 0));
        // Places that no unknown has stay as they are.
        for (std::size_t i = 0; i < dense.size(); ++i) dense[i][i] = 1;
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            for (int i = 0; i < nodes[n].size; ++i) {
                const double value = nodes[n].late ? -give : random.real(0.1, 10);
                const int place = system.offset(static_cast<int>(n)) + i;
                system.diagonal(static_cast<int>(n)).set(i, i, value);
                dense[at(place)][at(place)] = value;
            }
        }
        for (std::size_t e = 0; e < edges.size(); ++e) {
            const auto [a, b] = edges[e];
            for (int i = 0; i < nodes[at(b)].size; ++i) {
                for (int j = 0; j < 3; ++j) {
                    const double value = random.real(-1, 1);
                    system.edge(static_cast<int>(e)).set(i, j, value);
                    dense[at(system.offset(b) + i)][at(system.offset(a) + j)] = value;
                    dense[at(system.offset(a) + j)][at(system.offset(b) + i)] = value;
                }
            }
        }
        system.factor();
    }
    void require_solved(test::Random& random) {
        std::vector<double> b(at(system.size()));
        for (double& x : b) x = random.real(-1, 1);
        const std::vector<double> expected = solve_dense(dense, b);
        system.solve(b);
        for (std::size_t i = 0; i < b.size(); ++i)
            REQUIRE(b[i] == Approx(expected[i]).epsilon(1e-6).margin(1e-6));
    }
};

}  // namespace

TEST_CASE("random structures with loops are solved as by dense elimination") {
    test::Random random(5);
    for (int round = 0; round < 200; ++round) {
        Problem problem;
        const int bodies = 2 + random.below(10);
        for (int i = 0; i < bodies; ++i) problem.body();
        const int joints = 1 + random.below(bodies);
        for (int i = 0; i < joints; ++i) {
            const int a = random.below(bodies);
            const int b = random.below(bodies);
            problem.joint(1 + random.below(2), a, b == a ? -1 : b);
        }
        problem.fill(random);
        problem.require_solved(random);
    }
}

TEST_CASE("nodes of all sizes are solved, to the same bits by every level of SIMD") {
    const std::vector<SimdLevel> levels = available_simd_levels();
    test::Random random(7);
    for (int round = 0; round < 50; ++round) {
        Problem problem;
        problem.give = 0.1;
        const int bodies = 2 + random.below(6);
        for (int i = 0; i < bodies; ++i) problem.body();
        for (int i = 0; i < 2 * bodies; ++i) {
            const int a = random.below(bodies);
            const int b = random.below(bodies);
            problem.joint(1 + random.below(kMaxBlock), a, b == a ? -1 : b);
        }
        problem.fill(random);
        problem.require_solved(random);
        std::vector<std::vector<double>> solutions;
        for (const SimdLevel level : levels) {
            force_simd_level(level).value();
            BlockLdl system = problem.system;
            for (int node = 0; node < bodies; ++node) system.diagonal(node).set(0, 0, 11);
            system.factor();
            std::vector<double> x(at(system.size()));
            for (std::size_t i = 0; i < x.size(); ++i) x[i] = 1 / (1 + static_cast<double>(i));
            system.solve(x);
            solutions.push_back(x);
        }
        force_simd_level(levels.back()).value();
        // By bits: -0 is not 0.
        for (const std::vector<double>& x : solutions)
            REQUIRE(std::memcmp(x.data(), solutions.front().data(), x.size() * sizeof(double)) == 0);
    }
}

TEST_CASE("what is kept when a few values change is what a system has that never had others, to the bit") {
    struct Value {
        bool of_edge;
        int what, row, column;
        double value;
    };
    const auto set = [](BlockLdl& system, const Value& v) {
        (v.of_edge ? system.edge(v.what) : system.diagonal(v.what)).set(v.row, v.column, v.value);
    };
    test::Random random(6);
    for (int round = 0; round < 100; ++round) {
        Problem problem;
        const int bodies = 3 + random.below(10);
        for (int i = 0; i < bodies; ++i) problem.body();
        for (int i = 0; i < bodies; ++i) problem.joint(1 + random.below(3), i, i > 0 ? random.below(i) : -1);
        BlockLdl kept;
        kept.analyze(problem.nodes, problem.edges);
        std::vector<Value> values;  // all that were ever set
        const auto fill = [&](int node) {
            const int size = problem.nodes[at(node)].size;
            const auto put = [&](const Value& v) {
                values.push_back(v);
                set(kept, v);
            };
            for (int i = 0; i < size; ++i)
                put({false, node, i, i, node < bodies ? random.real(0.1, 10) : -1e-6});
            for (int e = 0; e < static_cast<int>(problem.edges.size()); ++e) {
                if (problem.edges[at(e)].b != node) continue;
                for (int i = 0; i < 3 * size; ++i) put({true, e, i / 3, i % 3, random.real(-1, 1)});
            }
        };
        for (int node = 0; node < static_cast<int>(problem.nodes.size()); ++node) fill(node);
        for (int change = 0; change < 5; ++change) {
            kept.factor();
            BlockLdl fresh;
            fresh.analyze(problem.nodes, problem.edges);
            for (const Value& value : values) set(fresh, value);
            fresh.factor();
            std::vector<double> x(at(kept.size()));
            for (double& number : x) number = random.real(-1, 1);
            std::vector<double> expected = x;
            kept.solve(x);
            fresh.solve(expected);
            REQUIRE(x == expected);
            fill(bodies + random.below(bodies));
        }
    }
}

TEST_CASE("a chain and a star take work in proportion to their joints") {
    for (const int size : {10, 100, 1000}) {
        for (const bool star : {false, true}) {
            Problem problem;
            for (int i = 0; i <= size; ++i) problem.body();
            for (int i = 0; i < size; ++i) problem.joint(2, star ? 0 : i, i + 1);
            problem.system.analyze(problem.nodes, problem.edges);
            INFO((star ? "star of " : "chain of ") << size);
            CHECK(problem.system.products() <= 4 * size + 4);
        }
    }
}

}  // namespace cairn::physics
