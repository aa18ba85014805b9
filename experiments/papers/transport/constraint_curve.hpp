#pragma once

#include <string>
#include <vector>

#include "experiments/papers/transport/rod_constraint.hpp"
#include "experiments/papers/transport/transport_task.hpp"

namespace fulbito {

/// Where a curve ends, and why.
enum class CurveEnd {
  kArrived,          ///< the lead is at the path's end
  kLeadAtStart,      ///< the lead would have to leave the path at its beginning
  kFollowerAtStart,  ///< the follower would have to leave the path at its beginning
  kFollowerAtEnd,    ///< the follower would leave the path at its end before the lead arrives
  kBranch,           ///< the rod is perpendicular to both directions of travel: the motion is not determined
  kLoop              ///< the curve returns to an earlier point
};

/// A point of a curve.
struct CurvePoint {
  PartPlace lead;
  PartPlace follower;
  double along = 0.0;  ///< [m] arc length in the plane of both coordinates
};

/// The pairs of coordinates (q_lead, q_follower) with a rod's length between them, from the start of the task
/// on.
struct ConstraintCurve {
  std::vector<CurvePoint> points;
  CurveEnd end = CurveEnd::kArrived;
  double nearest_branch = 0.0;  ///< smallest |(D t_lead, D t_follower)| over the rod's length; 0 at a branch

  bool arrives() const { return end == CurveEnd::kArrived; }
};

/// +1 or -1: the sign s for which (q_lead, q_follower)' = s (D t_follower, D t_lead) has the direction in
/// which the task begins. This field follows the whole curve, including corners, where a joint that one robot
/// passes changes only the other's speed. So s never changes, and no robot must remember a direction.
double travelSign(const TransportTask& task);

/// Traces the curve by arc-length continuation with steps of at most `step` [m], which are shorter in bends.
ConstraintCurve traceCurve(const TransportTask& task, double step = 0.002);

/// A sentence on why and where a curve does not arrive; empty if it arrives.
std::string refusal(const TransportTask& task, const ConstraintCurve& curve);

}  // namespace fulbito
