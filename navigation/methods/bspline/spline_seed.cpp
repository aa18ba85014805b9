#include "navigation/methods/bspline/spline_seed.hpp"

#include <algorithm>
#include <cmath>

#include "navigation/geometry/polyline.hpp"

namespace fulbito {
namespace {

constexpr double kSpan = 0.19;  // [m] wanted length of a span
constexpr std::size_t kLeastSpans = 5;
constexpr double kWaySpacing = 0.04;  // [m] between points of the shortest way
constexpr double kLead = 0.08;        // [m] greatest length for which an end keeps a given direction
constexpr double kNarrow = 0.002;     // [m] gap beside a robot that enters a narrow gap straight
constexpr double kForeseen = 2.0;     // [s] horizon of predictions
constexpr double kFlipPenalty = 2.0;  // [m] penalty for the side that is not wanted

}  // namespace

SplineSeeder::SplineSeeder() {
  circles_.reserve(64);
  passes_.reserve(64);
  way_.reserve(256);
}

bool SplineSeeder::search(const SeedRequest& request, const RobotModel& robot, const FieldGeometry& field,
                          std::span<const ForecastDisc> discs, Room room) {
  request_ = request;
  field_ = &field;
  const double lead = std::min(kLead, 0.3 * distance(request.start, request.goal));
  from_ = request.start_direction ? request.start + *request.start_direction * lead : request.start;
  to_ = request.end_direction ? request.goal - *request.end_direction * lead : request.goal;
  wall_margin_ = room == Room::kTurning ? robot.circumradius() + request.margin : robot.width / 2 + kNarrow;
  placeCircles(wall_margin_, discs);
  const bool found = route({});
  passes_.clear();
  if (found) {
    passes_.insert(passes_.end(), graph_.passes().begin(), graph_.passes().end());
  } else {
    way_.clear();
    way_.push_back(from_);
    way_.push_back(to_);
  }
  length_ = polylineLength(way_);
  makeSpline(shortest_);
  return found;
}

bool SplineSeeder::otherSide(std::size_t bend, double excess, CubicSpline& out) {
  if (bend >= passes_.size()) return false;
  CirclePass flipped = passes_[bend];
  flipped.side = -flipped.side;
  if (!route({std::span<const CirclePass>(&flipped, 1), kFlipPenalty})) return false;
  if (polylineLength(way_) > excess * length_) return false;
  makeSpline(out);
  return true;
}

void SplineSeeder::placeCircles(double inflation, std::span<const ForecastDisc> discs) {
  circles_.clear();
  const Vec2 velocity = unitOr(to_ - from_, {}) * request_.speed;
  for (const ForecastDisc& disc : discs) {
    Vec2 centre = disc.position;
    if (disc.moves) {
      // The disc where a robot on the straight way comes nearest to it; if that is far away, the disc is
      // ignored. (`predictObstacles` instead uses the place where a robot that drives at the disc would meet
      // it. This keeps every disc in the scene, which is safer for a path without times.)
      const Vec2 apart = disc.position - from_, closing = velocity - disc.velocity;
      const double square = squaredNorm(closing);
      const double time = square > 1e-9 ? std::clamp(dot(apart, closing) / square, 0.0, kForeseen) : 0.0;
      centre = disc.at(time);
      const double near = 2.0 * (disc.radius + inflation);
      if (distance(centre, from_ + velocity * time) > near) continue;
    }
    circles_.push_back({centre, disc.radius + inflation});
  }
}

bool SplineSeeder::route(SidePreference preference) {
  if (!graph_.search(from_, to_, circles_, field_, wall_margin_, preference)) return false;
  graph_.sample(kWaySpacing, way_);
  return way_.size() >= 2;
}

void SplineSeeder::makeSpline(CubicSpline& out) const {
  const double length = polylineLength(way_);
  const auto wanted = static_cast<std::size_t>(std::min(length / kSpan, 1e3)) + 1;
  const std::size_t ends = (request_.start_direction ? 1 : 0) + (request_.end_direction ? 1 : 0);
  const std::size_t spans = std::clamp(wanted, kLeastSpans - ends, CubicSpline::kMaxControls - 1 - ends);
  out.clear();
  if (request_.start_direction) out.add(request_.start);
  PathPlace place{};
  out.add(way_.front());
  for (std::size_t i = 1; i < spans; ++i) {
    place = advance(way_, place, length / static_cast<double>(spans));
    out.add(pointAt(way_, place));
  }
  out.add(way_.back());
  if (request_.end_direction) out.add(request_.goal);
}

}  // namespace fulbito
