// Private header of referee: not installed.
#pragma once

#include "referee/calls/detectors.hpp"

namespace fulbito {

/// Robots of one team in one area, with what the rules allow.
struct AreaCrowd {
  Side side = Side::kLeft;
  bool big = false;
  RobotSet inside = 0;
  RobotSet taking_part = 0;     ///< touched the ball or hindered an opponent of late
  bool must_take_part = false;  ///< a foul only if one beyond those allowed takes part
  int allowed = 0;
};

/// The foul of a crowd, if it is one; excused robots do not count. "One beyond those allowed" is a robot
/// before which, or in the same tick as which, at least that many others came in.
std::optional<AreaFoul> foulOf(const AreaCrowd& crowd, const DetectorInput& input,
                               const PresenceMemory& presence);

/// The robots of `among` whose touch, by `touched`, is recent enough to take part.
RobotSet touchedOfLate(const DetectorInput& input, RobotSet among, const RobotTicks& touched);

}  // namespace fulbito
