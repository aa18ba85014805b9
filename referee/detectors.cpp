#include "referee/detectors.hpp"

#include "referee/detect_goal.hpp"
#include "referee/detect_stuck_ball.hpp"
#include "referee/detector_support.hpp"

namespace fulbito {
namespace {

void noteTouches(const MatchView& view, TouchMemory& touches) {
  for (const ContactEvent& contact : view.contacts) {
    if (contact.a.kind != BodyKind::kRobot || contact.b.kind != BodyKind::kBall) continue;
    if (contact.a.index < kMostRobots) touches.ball[contact.a.index] = view.tick;
  }
}

}  // namespace

std::optional<Finding> detect(const DetectorInput& input, DetectorMemory& memory, std::vector<GameEvent>&) {
  noteTouches(input.view, memory.touches);
  memory.areas = input.areas;
  if (auto goal = detectGoal(input, memory.touches)) return goal;
  return detectStuckBall(input, memory.stuck);
}

std::optional<Finding> detect(const MatchView& view, const RefereeSetup& setup, const RefereeState& state,
                              DetectorMemory& memory, std::vector<GameEvent>& events) {
  const AreaReport areas =
      reportAreas(view, setup.field, setup.robot, setup.rules.areas, state.blue_side, memory.areas);
  return detect(DetectorInput{view, setup, state, areas}, memory, events);
}

}  // namespace fulbito
