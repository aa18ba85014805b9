#include "bridge/abi/team_values.hpp"

#include <algorithm>
#include <cstring>

namespace fulbito {
namespace {

/// A kind that the C interface lacks becomes one that the simulator lacks, so that its policy counts a fault.
RobotCommand fromAbi(const fulbito_robot_command& from) {
  constexpr std::uint32_t kUnknown = 255;
  RobotCommand to;
  to.kind = static_cast<RobotCommand::Kind>(from.kind <= FULBITO_BY_GO_TO ? from.kind : kUnknown);
  to.wheels = fulbito::fromAbi(from.wheels);
  to.twist = fulbito::fromAbi(from.twist);
  fulbito::fromAbi(from.go_to, to.go_to);
  if (from.go_to.has_heading != 0) to.go_to.heading = from.go_to.heading;
  return to;
}

void fromAbi(const fulbito_drawing& from, DebugDrawing& to) {
  to.kind = static_cast<DebugDrawing::Kind>(from.kind);
  to.from = fulbito::fromAbi(from.from);
  to.to = fulbito::fromAbi(from.to);
  to.radius = from.radius;
  to.text.assign(from.text, strnlen(from.text, sizeof from.text));
}

}  // namespace

void toAbi(const PlayStop& v, fulbito_stop& to) {
  toAbi(v.cause, to.cause);
  toAbi(v.now, to.now);
}

CommandRoom::CommandRoom() : drawings_(kMostDrawings) {
  for (fulbito_robot_command& robot : still_.robots) toAbi(GoTo{}, robot.go_to);
}

fulbito_team_command CommandRoom::open(bool drawings_wanted) {
  still_.drawings = drawings_wanted ? drawings_.data() : nullptr;
  still_.drawing_capacity = drawings_wanted ? kMostDrawings : 0;
  return still_;
}

void CommandRoom::close(fulbito_team_command& command) {
  command.drawings = still_.drawings;
  command.drawing_capacity = still_.drawing_capacity;
  command.drawing_count = std::min(command.drawing_count, command.drawing_capacity);
}

void fromAbi(const fulbito_team_command& command, int team_size, TeamCommand& to) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(team_size); ++i) {
    to.robots[i] = fromAbi(command.robots[i]);
    to.roles[i] = static_cast<std::uint8_t>(std::min<std::uint32_t>(command.robots[i].role, 255));
  }
  const std::uint32_t count = std::min(command.drawing_count, command.drawing_capacity);
  to.drawings.resize(count);
  std::size_t used = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (command.drawings[i].kind > FULBITO_TEXT) continue;
    fromAbi(command.drawings[i], to.drawings[used++]);
  }
  to.drawings.resize(used);
}

TeamProposal fromAbi(const fulbito_placement& placement) {
  TeamProposal to;
  for (std::size_t i = 0; i < to.robots.size(); ++i) {
    if (placement.robots.present[i] != 0) to.robots[i] = fromAbi(placement.robots.pose[i]);
  }
  if (placement.has_ball != 0) to.ball = fromAbi(placement.ball);
  return to;
}

}  // namespace fulbito
