#pragma once

#include <string>
#include <vector>

#include "experiments/papers/transport/rod_constraint.hpp"
#include "experiments/papers/transport/transport_task.hpp"

namespace fulbito {

/// Where and why a curve ends.
enum class CurveEnd {
  kArrived,          ///< the lead is at the path's end
  kLeadAtStart,      ///< the lead would have to back over the path's beginning
  kFollowerAtStart,  ///< the same for the follower
  kFollowerAtEnd,    ///< the follower would pass the path's end before the lead is there
  kBranch,           ///< the rod is across both ways: the motion is not determined
  kLoop              ///< it comes back to where it has been
};

/// A point of a curve.
struct CurvePoint {
  PartPlace lead;
  PartPlace follower;
  double along = 0.0;  ///< [m] arc length in the plane of both coordinates
};

/// The pairs of coordinates (q_lead, q_follower) with a rod's length between them, from the start on.
struct ConstraintCurve {
  std::vector<CurvePoint> points;
  CurveEnd end = CurveEnd::kArrived;
  double nearest_branch = 0.0;  ///< smallest |(D t_lead, D t_follower)| over the rod's length; 0: a branch

  bool arrives() const { return end == CurveEnd::kArrived; }
};

/// +1 or -1: the sign s with (q_lead, q_follower)' = s (D t_follower, D t_lead) in the direction in which the
/// task begins. That field follows the whole curve, corners too: a joint that one robot passes changes only
/// the other's speed. So s never changes, and no robot has to remember a direction.
double travelSign(const TransportTask& task);

/// Traces the curve by arc-length continuation with steps of at most `step` [m], shorter where it bends.
ConstraintCurve traceCurve(const TransportTask& task, double step = 0.002);

/// Why a curve does not arrive, and where, as a sentence; empty if it arrives.
std::string refusal(const TransportTask& task, const ConstraintCurve& curve);

}  // namespace fulbito
