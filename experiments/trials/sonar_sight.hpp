#pragma once

#include <vector>

#include "engine/sim/sonar.hpp"
#include "fulbito/experiment.hpp"
#include "navigation/obstacles/echo_map.hpp"

namespace fulbito {

/// The sonars of the suites `sonar`: the eight front sonars with 5 % of drop-outs, echoes from smooth faces
/// up to 30 degrees, no cross-talk.
/// @param noise  [m] standard deviation of a range; 5 mm in the suites
SonarModel suiteSonars(const RobotModel& robot, double noise);

/// What a robot knows that has sonars only: their readings, and for navigators that do not use these, discs
/// where a short memory of echoes is occupied (`EchoMap`). It knows of no walls: its field is a wide plain.
class SonarSight {
 public:
  explicit SonarSight(const TrialConfig& config);
  /// Fires the sonars and replaces what `scene` knows of obstacles and walls. Valid until the next call.
  void look(const World& world, NavigationScene& scene);

 private:
  SonarArray sonars_;
  FieldGeometry plain_;
  bool wants_discs_;
  EchoMap map_;
  std::vector<RangeReading> readings_;
  std::vector<DiscObstacle> discs_;
};

}  // namespace fulbito
