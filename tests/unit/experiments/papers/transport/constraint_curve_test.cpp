#include "experiments/papers/transport/constraint_curve.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "experiments/papers/transport/contour_walk.hpp"
#include "experiments/papers/transport/path_file.hpp"
#include "experiments/papers/transport/random_path.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

TransportTask taskOf(const std::string& text) { return parseTransport(text, "test").value(); }

/// A line of 2 m, a U of the given radius, and a line back.
TransportTask turnBack(double radius_cm) {
  const std::string top = std::to_string(2 * radius_cm);
  return taskOf("rod 80\nline 0 0 0\narc 200 " + std::to_string(radius_cm) + " 180\nline 200 " + top +
                " 180\nend 0 " + top);
}

double rodAt(const TransportTask& task, const CurvePoint& point) {
  return norm(viewRod(task.path, point.lead, point.follower).rod);
}

}  // namespace

TEST_CASE("the curve of the S path arrives; every point is a rod's length", "[unit]") {
  const TransportTask task = builtInTransport("s-path");
  const ConstraintCurve curve = traceCurve(task);
  CHECK(curve.arrives());
  CHECK(refusal(task, curve).empty());
  double worst = 0.0;
  for (const CurvePoint& point : curve.points) worst = std::max(worst, std::abs(rodAt(task, point) - 0.8));
  CHECK(worst < 1e-9);
  CHECK(curve.points.back().lead.q == Approx(task.path.length()));
  // Each robot drives 24.16 m, forward and backward.
  double lead = 0.0;
  for (std::size_t i = 1; i < curve.points.size(); ++i)
    lead += std::abs(curve.points[i].lead.q - curve.points[i - 1].lead.q);
  CHECK(lead == Approx(24.16).margin(0.02));
}

TEST_CASE("finer steps find the same end", "[unit]") {
  for (std::uint64_t i = 0; i < 10; ++i) {
    const TransportTask task = randomTransport(500, i);
    const ConstraintCurve coarse = traceCurve(task, 0.004), fine = traceCurve(task, 0.0005);
    CHECK(coarse.end == fine.end);
    CHECK(coarse.points.back().lead.q == Approx(fine.points.back().lead.q).margin(1e-4));
    CHECK(coarse.points.back().along == Approx(fine.points.back().along).epsilon(1e-3));
  }
}

TEST_CASE("what the robots cannot pass is refused with reason and place", "[unit]") {
  // The leading robot rounds a bend and comes back beside the other robot, which must then drive backward.
  const TransportTask task = taskOf("rod 80\nline 0 0 0\narc 100 25 180\nline 100 50 180\nend -300 50");
  const ConstraintCurve curve = traceCurve(task);
  REQUIRE_FALSE(curve.arrives());
  CHECK(curve.end == CurveEnd::kFollowerAtStart);
  CHECK_THAT(
      refusal(task, curve),
      Catch::Contains(
          "the follower would have to back over the path's beginning: lead on part 3 at (62.4, 50.0) cm"));
}

TEST_CASE("a rod across both ways is a branch", "[unit]") {
  // Two parallel lines at a rod's length. When the robots are opposite each other, both may move either way.
  TransportTask task = turnBack(40.0);
  const ConstraintCurve curve = traceCurve(task);
  CHECK(curve.end == CurveEnd::kBranch);
  CHECK(curve.nearest_branch < 0.02);
  CHECK(traceCurve(turnBack(39.0)).end != CurveEnd::kBranch);
}

TEST_CASE("the direction of travel never changes its sign, over joints and corners", "[unit]") {
  const TransportTask task = builtInTransport("maze");
  const double sign = travelSign(task);
  const ConstraintCurve curve = traceCurve(task);
  REQUIRE(curve.arrives());
  int wrong = 0;
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    const CurvePoint &a = curve.points[i - 1], &b = curve.points[i];
    const RodView view = viewRod(task.path, a.lead, a.follower);
    const double along =
        sign * (view.follower * (b.lead.q - a.lead.q) + view.lead * (b.follower.q - a.follower.q));
    wrong += along > 0.0 || a.lead.part != b.lead.part || a.follower.part != b.follower.part ? 0 : 1;
  }
  CHECK(wrong == 0);
}

TEST_CASE("the contour walk, which knows no tangents, ends where the curve ends", "[unit]") {
  int refused = 0;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const TransportTask task = randomTransport(501, i);
    const ConstraintCurve curve = traceCurve(task);
    const ContourEnd contour = walkContour(task, 0.004);
    CHECK(curve.end == contour.end);
    CHECK(curve.points.back().lead.q == Approx(contour.lead).margin(0.01));
    CHECK(curve.points.back().follower.q == Approx(contour.follower).margin(0.01));
    refused += curve.arrives() ? 0 : 1;
  }
  CHECK(refused > 0);
  CHECK(refused < 40);
}

}  // namespace fulbito
