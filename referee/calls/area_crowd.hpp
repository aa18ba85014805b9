#pragma once

#include "referee/calls/detectors.hpp"

namespace fulbito {

/// Robots of one team in one area, and the rules' limit.
struct AreaCrowd {
  Side side = Side::kLeft;
  bool big = false;
  RobotSet inside = 0;
  RobotSet taking_part = 0;     ///< touched the ball or an opponent recently
  bool must_take_part = false;  ///< a foul only if a robot beyond the allowed number takes part
  int allowed = 0;
};

/// The foul that the crowd commits, if any. Excused robots do not count. A robot is beyond the allowed number
/// if at least that many others entered before it or in the same tick.
std::optional<AreaFoul> foulOf(const AreaCrowd& crowd, const DetectorInput& input,
                               const PresenceMemory& presence);

/// The robots of `among` whose last touch in `touched` is recent enough to take part.
RobotSet touchedRecently(const DetectorInput& input, RobotSet among, const RobotTicks& touched);

}  // namespace fulbito
