// Table of the planning time of the tangent graph.
#include <algorithm>
#include <chrono>
#include <vector>

#include <fmt/format.h>

#include "engine/core/math/random.hpp"
#include "navigation/methods/paths/tangent_graph_search.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

std::vector<Circle> randomCircles(Rng& rng, std::size_t count, double least, double most) {
  std::vector<Circle> circles;
  circles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    circles.push_back({{rng.uniform(-0.7, 0.7), rng.uniform(-0.6, 0.6)}, rng.uniform(least, most)});
  }
  return circles;
}

}  // namespace

TEST_CASE("survey of the tangent graph's planning time", "[survey]") {
  for (std::size_t count : {4U, 9U, 20U, 50U}) {
    Rng rng(count, test::kTestStream);
    TangentGraph graph(64);
    std::vector<double> times;
    for (int i = 0; i < 4000; ++i) {
      const std::vector<Circle> circles = randomCircles(rng, count, 0.07, 0.10);
      const Vec2 a{-0.63, rng.uniform(-0.5, 0.5)}, b{0.63, rng.uniform(-0.5, 0.5)};
      const FieldGeometry field;
      const auto from = std::chrono::steady_clock::now();
      graph.search(a, b, circles, &field, 0.053);
      times.push_back(
          std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - from).count());
    }
    std::sort(times.begin(), times.end());
    fmt::print("tangent graph, {:2} discs: p50 {:6.1f} p99 {:6.1f} max {:7.1f} us\n", count,
               times[times.size() / 2], times[times.size() * 99 / 100], times.back());
  }
}

}  // namespace fulbito
