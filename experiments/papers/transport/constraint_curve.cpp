#include "experiments/papers/transport/constraint_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace fulbito {
namespace {

constexpr double kAtEnd = 1e-10;         // [m] a coordinate nearer to a joint counts as at it
constexpr double kBranchShare = 1e-4;    // share of the rod's length
constexpr double kShortestStep = 1e-6;   // [m]
constexpr double kSharpestTurn = 0.995;  // cosine of the curve's greatest turn in one step

/// Direction of the curve in the plane (q_lead, q_follower).
struct Heading {
  double lead = 0.0;
  double follower = 0.0;
};

double dotOf(const Heading& a, const Heading& b) { return a.lead * b.lead + a.follower * b.follower; }

class Tracer {
 public:
  Tracer(const TransportTask& task, double step);
  ConstraintCurve run();

 private:
  bool atBranch(const RodView& view);
  Heading headingAt(const CurvePoint& point);
  double roomOf(const PartPlace& place, double rate) const;
  double stepWithin(const CurvePoint& point, const Heading& heading) const;
  void correct(CurvePoint& point) const;
  CurvePoint moved(const CurvePoint& point, const Heading& heading, double step) const;
  bool advance();
  bool cross(PartPlace& place, double rate, CurveEnd at_start, CurveEnd at_end);
  bool crossJoints(const Heading& heading);
  bool loops() const;

  const TransportTask& task_;
  const PartPath& path_;
  double step_;
  double sign_;
  CurvePoint now_;
  ConstraintCurve curve_;
};

Tracer::Tracer(const TransportTask& task, double step)
    : task_(task), path_(task.path), step_(step), sign_(travelSign(task)) {
  now_.lead = {path_.partAt(task.lead), task.lead};
  now_.follower = {path_.partAt(task.follower), task.follower};
  curve_.nearest_branch = std::numeric_limits<double>::infinity();
  curve_.points.push_back(now_);
}

Heading Tracer::headingAt(const CurvePoint& point) {
  const RodView view = viewRod(path_, point.lead, point.follower);
  const double size = std::sqrt(view.lead * view.lead + view.follower * view.follower);
  if (size == 0.0) return {};
  return {sign_ * view.follower / size, sign_ * view.lead / size};
}

bool Tracer::atBranch(const RodView& view) {
  const double share = std::sqrt(view.lead * view.lead + view.follower * view.follower) / task_.rod;
  curve_.nearest_branch = std::min(curve_.nearest_branch, share);
  return share < kBranchShare;
}

// Length of the curve until this robot reaches the end of its part.
double Tracer::roomOf(const PartPlace& place, double rate) const {
  if (rate == 0.0) return std::numeric_limits<double>::infinity();
  const double end = rate > 0.0 ? path_.to(place.part) : path_.from(place.part);
  return std::max((end - place.q) / rate, 0.0);
}

double Tracer::stepWithin(const CurvePoint& point, const Heading& heading) const {
  return std::min({step_, roomOf(point.lead, heading.lead), roomOf(point.follower, heading.follower)});
}

// Newton steps along the gradient (D t_lead, -D t_follower), which is the shortest way back to the curve.
void Tracer::correct(CurvePoint& point) const {
  for (int i = 0; i < 4; ++i) {
    const RodView view = viewRod(path_, point.lead, point.follower);
    const double size = view.lead * view.lead + view.follower * view.follower;
    const double excess = (squaredNorm(view.rod) - task_.rod * task_.rod) / 2;
    if (size == 0.0 || std::abs(excess) < 1e-15) return;
    point.lead.q -= excess * view.lead / size;
    point.follower.q += excess * view.follower / size;
  }
}

CurvePoint Tracer::moved(const CurvePoint& point, const Heading& heading, double step) const {
  CurvePoint next = point;
  next.lead.q += heading.lead * step;
  next.follower.q += heading.follower * step;
  correct(next);
  next.along += step;
  return next;
}

// Moves a robot to the next part at a joint. Returns false if the robot is at an end of the path.
bool Tracer::cross(PartPlace& place, double rate, CurveEnd at_start, CurveEnd at_end) {
  if (rate > 0.0 && place.q >= path_.to(place.part) - kAtEnd) {
    if (place.part + 1 == path_.size()) return curve_.end = at_end, false;
    ++place.part;
  } else if (rate < 0.0 && place.q <= path_.from(place.part) + kAtEnd) {
    if (place.part == 0) return curve_.end = at_start, false;
    --place.part;
  }
  return true;
}

bool Tracer::crossJoints(const Heading& heading) {
  return cross(now_.lead, heading.lead, CurveEnd::kLeadAtStart, CurveEnd::kArrived) &&
         cross(now_.follower, heading.follower, CurveEnd::kFollowerAtStart, CurveEnd::kFollowerAtEnd);
}

bool Tracer::advance() {
  if (atBranch(viewRod(path_, now_.lead, now_.follower))) return curve_.end = CurveEnd::kBranch, false;
  if (!crossJoints(headingAt(now_))) return false;
  const Heading heading = headingAt(now_);
  double step = std::max(stepWithin(now_, heading), kAtEnd);
  CurvePoint next = moved(now_, heading, step);
  while (dotOf(headingAt(next), heading) < kSharpestTurn) {
    step /= 2;
    if (step < kShortestStep) return curve_.end = CurveEnd::kBranch, false;
    next = moved(now_, heading, step);
  }
  now_ = next;
  curve_.points.push_back(now_);
  return true;
}

// A longer curve in the square of both coordinates must have closed.
bool Tracer::loops() const { return now_.along > 100 * (path_.length() + task_.rod); }

ConstraintCurve Tracer::run() {
  while (advance()) {
    if (loops()) return curve_.end = CurveEnd::kLoop, curve_;
  }
  return std::move(curve_);
}

std::string placeText(const TransportTask& task, const PartPlace& place) {
  const Vec2 at = task.path.pose(place.part, place.q).position;
  return fmt::format("part {} at ({:.1f}, {:.1f}) cm", place.part + 1, at.x * 100, at.y * 100);
}

const char* reasonFor(CurveEnd end) {
  switch (end) {
    case CurveEnd::kArrived:
      return "";
    case CurveEnd::kLeadAtStart:
      return "the lead would have to back over the path's beginning";
    case CurveEnd::kFollowerAtStart:
      return "the follower would have to back over the path's beginning";
    case CurveEnd::kFollowerAtEnd:
      return "the follower would pass the path's end before the lead arrives";
    case CurveEnd::kBranch:
      return "the rod is across both robots' ways, so the motion is not determined";
    case CurveEnd::kLoop:
      return "the robots would go round in a loop";
  }
  return "";
}

}  // namespace

double travelSign(const TransportTask& task) {
  const PartPath& path = task.path;
  const RodView view =
      viewRod(path, {path.partAt(task.lead), task.lead}, {path.partAt(task.follower), task.follower});
  // A follower at the path's beginning can only go forward. Elsewhere both robots together should.
  if (task.follower <= kAtEnd && view.lead != 0.0) return view.lead > 0.0 ? 1.0 : -1.0;
  return view.lead + view.follower >= 0.0 ? 1.0 : -1.0;
}

ConstraintCurve traceCurve(const TransportTask& task, double step) { return Tracer(task, step).run(); }

std::string refusal(const TransportTask& task, const ConstraintCurve& curve) {
  if (curve.arrives()) return {};
  const CurvePoint& last = curve.points.back();
  return fmt::format("{}: lead on {}, follower on {}", reasonFor(curve.end), placeText(task, last.lead),
                     placeText(task, last.follower));
}

}  // namespace fulbito
