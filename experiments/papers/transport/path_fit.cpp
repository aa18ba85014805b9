#include "experiments/papers/transport/path_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "fulbito/models.hpp"

namespace fulbito {
namespace {

using Parts = std::vector<Arc>;

/// A point of the polyline with the directions in which the path arrives and leaves.
struct Knot {
  Vec2 at;
  double in = 0.0;   // [rad]
  double out = 0.0;  // [rad] differs at a corner
};

double segmentDistance(Vec2 a, Vec2 b, Vec2 point) {
  const Vec2 along = b - a;
  const double share = std::clamp(dot(point - a, along) / squaredNorm(along), 0.0, 1.0);
  return distance(a + along * share, point);
}

double gapToKnots(std::span<const Knot> run, Vec2 point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < run.size(); ++i)
    least = std::min(least, segmentDistance(run[i].at, run[i + 1].at, point));
  return least;
}

double gapToParts(const Parts& parts, Vec2 point) {
  double least = std::numeric_limits<double>::infinity();
  for (const Arc& part : parts)
    least = std::min(least, distance(poseAt(part, nearestOn(part, point)).position, point));
  return least;
}

// An arc leaves its chord in a smooth bulge. This number of points finds the bulge's height within 2 %, which
// the fit leaves as a reserve.
constexpr int kProbes = 16;
constexpr double kUsedShare = 0.98;  // share of the tolerance

bool partNear(const Arc& part, std::span<const Knot> run, double tolerance) {
  for (int i = 0; i <= kProbes; ++i) {
    if (gapToKnots(run, poseAt(part, part.length * i / kProbes).position) > tolerance) return false;
  }
  return true;
}

bool fits(const Parts& parts, std::span<const Knot> run, double tolerance) {
  for (const Knot& knot : run) {
    if (gapToParts(parts, knot.at) > tolerance) return false;
  }
  const auto near = [&](const Arc& part) { return partNear(part, run, tolerance); };
  return std::all_of(parts.begin(), parts.end(), near);
}

double directionOf(Vec2 from, Vec2 to) { return math::angleOf(to - from); }

// The tangent at the middle one of three points on a circle. It is stable for points that are close together.
double tangentAt(Vec2 before, Vec2 at, Vec2 after) {
  const double first = distance(before, at), second = distance(at, after);
  const double turn = math::wrapAngle(directionOf(at, after) - directionOf(before, at));
  return directionOf(before, at) + turn * first / (first + second);
}

class Fitter {
 public:
  Fitter(std::span<const Vec2> points, const PathFit& fit) : fit_(fit) { setKnots(points); }

  Parts run();

 private:
  void setKnots(std::span<const Vec2> points);
  void setCorners(std::span<const Vec2> points);
  void setTangents(std::span<const Vec2> points);
  double endTangent(Vec2 from, Vec2 to, double other) const;
  bool isCorner(std::size_t i) const { return corner_[i]; }
  Parts between(std::size_t i, std::size_t j) const;
  bool fitsUntil(std::size_t i, std::size_t j) const;
  std::size_t lastOfRun(std::size_t i) const;
  std::size_t farthest(std::size_t i) const;
  void divide(std::size_t i);

  PathFit fit_;
  std::vector<Knot> knots_;
  std::vector<bool> corner_;
};

void Fitter::setKnots(std::span<const Vec2> points) {
  for (const Vec2 point : points) knots_.push_back({point});
  setCorners(points);
  setTangents(points);
}

void Fitter::setCorners(std::span<const Vec2> points) {
  corner_.assign(points.size(), true);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double turn = directionOf(points[i], points[i + 1]) - directionOf(points[i - 1], points[i]);
    corner_[i] = std::abs(math::wrapAngle(turn)) > fit_.corner;
  }
}

void Fitter::setTangents(std::span<const Vec2> points) {
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    if (!corner_[i]) knots_[i].in = knots_[i].out = tangentAt(points[i - 1], points[i], points[i + 1]);
  }
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double chord = directionOf(points[i], points[i + 1]);
    if (corner_[i])
      knots_[i].out = corner_[i + 1] ? chord : endTangent(points[i], points[i + 1], knots_[i + 1].in);
    if (corner_[i + 1])
      knots_[i + 1].in = corner_[i] ? chord : endTangent(points[i], points[i + 1], knots_[i].out);
  }
}

// The direction at an end of a smooth run: that of the arc over the first segment, if the arc is near enough
// to the segment.
double Fitter::endTangent(Vec2 from, Vec2 to, double other) const {
  const double chord = directionOf(from, to), turn = math::wrapAngle(chord - other);
  const double height = distance(from, to) * std::abs(turn) / 4;
  return height <= fit_.tolerance ? chord + turn : chord;
}

Parts Fitter::between(std::size_t i, std::size_t j) const {
  return biarc({knots_[i].at, knots_[i].out}, {knots_[j].at, knots_[j].in});
}

bool Fitter::fitsUntil(std::size_t i, std::size_t j) const {
  return fits(between(i, j), std::span(knots_).subspan(i, j - i + 1), kUsedShare * fit_.tolerance);
}

std::size_t Fitter::lastOfRun(std::size_t i) const {
  std::size_t last = i + 1;
  while (!isCorner(last)) ++last;
  return last;
}

// Doubles the stride while the biarc fits, then bisects. Returns i if not even the next knot fits.
std::size_t Fitter::farthest(std::size_t i) const {
  const std::size_t last = lastOfRun(i);
  std::size_t good = i, stride = 1;
  while (good < last && fitsUntil(i, std::min(i + stride, last)))
    good = std::min(i + stride, last), stride *= 2;
  std::size_t bad = std::min(i + stride, last + 1);
  while (good > i && bad > good + 1) {
    const std::size_t middle = (good + bad) / 2;
    (fitsUntil(i, middle) ? good : bad) = middle;
  }
  return good;
}

void Fitter::divide(std::size_t i) {
  const Vec2 a = knots_[i].at, b = knots_[i + 1].at;
  const double along = directionOf(a, b);
  knots_.insert(knots_.begin() + static_cast<std::ptrdiff_t>(i) + 1, {(a + b) / 2, along, along});
  corner_.insert(corner_.begin() + static_cast<std::ptrdiff_t>(i) + 1, false);
}

Parts Fitter::run() {
  Parts parts;
  for (std::size_t i = 0; i + 1 < knots_.size();) {
    const std::size_t next = farthest(i);
    if (next == i) {
      divide(i);
      continue;
    }
    const Parts more = between(i, next);
    parts.insert(parts.end(), more.begin(), more.end());
    i = next;
  }
  return parts;
}

bool continues(const Arc& line, const Arc& next) {
  constexpr double kSame = 1e-7;  // [rad]
  return line.curvature == 0.0 && next.curvature == 0.0 &&
         std::abs(math::wrapAngle(next.start.heading - line.start.heading)) < kSame;
}

// Joins successive lines that go straight on, which remain from divided segments.
Parts withLinesJoined(const Parts& parts) {
  Parts joined;
  for (const Arc& part : parts) {
    if (!joined.empty() && continues(joined.back(), part)) {
      joined.back().length += part.length;
    } else {
      joined.push_back(part);
    }
  }
  return joined;
}

// Length of both tangent legs: the square of the chord over the sum of both roots, without cancellation.
double legLength(Vec2 chord, Vec2 first, Vec2 second) {
  const double across = 2 * (1 - dot(first, second)), along = dot(chord, first + second);
  const double squared = squaredNorm(chord);
  return squared / (along + std::sqrt(along * along + across * squared));
}

// Whether an arc is within a nanometre of its chord.
bool isFlat(const Arc& arc) { return std::abs(arc.curvature) * arc.length * arc.length < 8e-9; }

void addArc(Parts& parts, const Pose2& from, Vec2 to) {
  Arc arc = arcThrough(from, to);
  if (!(arc.length > 0.0)) return;
  if (isFlat(arc)) arc = {{from.position, directionOf(from.position, to)}, 0.0, distance(from.position, to)};
  parts.push_back(arc);
}

Result<void> checkPoints(std::span<const Vec2> points, const PathFit& fit) {
  if (points.size() < 2) return fail(ErrorCode::kBadInput, "a polyline needs at least 2 points");
  if (!(fit.tolerance > 1e-4)) return fail(ErrorCode::kBadInput, "the tolerance must be above 0.1 mm");
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y))
      return fail(ErrorCode::kBadInput, fmt::format("point {} is not finite", i + 1));
    if (i > 0 && distance(points[i - 1], points[i]) < 1e-9)
      return fail(ErrorCode::kBadInput, fmt::format("point {} repeats the one before", i + 1));
  }
  return {};
}

}  // namespace

Parts biarc(const Pose2& from, const Pose2& to) {
  const Vec2 chord = to.position - from.position;
  const Vec2 first = math::unit(from.heading), second = math::unit(to.heading);
  const double leg = legLength(chord, first, second);
  const Vec2 joint = (from.position + to.position + (first - second) * leg) / 2;
  Parts parts;
  addArc(parts, from, joint);
  addArc(parts, parts.empty() ? from : endOf(parts.back()), to.position);
  if (parts.size() == 2 && isFlat(parts[0]) && isFlat(parts[1])) {
    parts.clear();
    addArc(parts, {from.position, directionOf(from.position, to.position)}, to.position);
  }
  return parts;
}

Result<PartPath> fitPath(std::span<const Vec2> points, const PathFit& fit) {
  if (auto checked = checkPoints(points, fit); !checked) return tl::unexpected<Error>(checked.error());
  return PartPath(withLinesJoined(Fitter(points, fit).run()));
}

double distanceBetween(const PartPath& path, std::span<const Vec2> points) {
  double largest = 0.0;
  for (const Vec2 point : points) largest = std::max(largest, gapToParts(path.parts(), point));
  std::vector<Knot> knots;
  for (const Vec2 point : points) knots.push_back({point});
  constexpr double kStride = 0.001;  // [m]
  const int count = static_cast<int>(path.length() / kStride) + 1;
  for (int i = 0; i <= count; ++i)
    largest = std::max(largest, gapToKnots(knots, path.pose(path.length() * i / count).position));
  return largest;
}

}  // namespace fulbito
