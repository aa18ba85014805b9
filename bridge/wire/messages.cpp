#include "bridge/wire/messages.hpp"

#include <fmt/format.h>

#include "bridge/wire/referee.pb.h"
#include "bridge/wire/simulator.pb.h"
#include "fulbito/detail/math.hpp"

namespace fulbito::wire {
namespace {

namespace sim = fulbito_wire::simulator;
namespace ref = fulbito_wire::referee;

constexpr double kDegrees = 180.0 / math::kPi;  // per radian

bool isYellow(TeamId team) { return team == TeamId::kYellow; }

TeamId teamOf(bool yellow) { return yellow ? TeamId::kYellow : TeamId::kBlue; }

void fill(const FieldGeometry& field, sim::Field& out) {
  out.set_width(field.width);
  out.set_length(field.length);
  out.set_goal_width(field.goal_width);
  out.set_goal_depth(field.goal_depth);
  out.set_center_radius(field.centre_circle_radius);
  out.set_penalty_width(field.goal_area_width);
  out.set_penalty_depth(field.goal_area_depth);
  out.set_penalty_point(field.penalty_mark);
}

FieldGeometry fieldOf(const sim::Field& from) {
  FieldGeometry field;
  field.width = from.width();
  field.length = from.length();
  field.goal_width = from.goal_width();
  field.goal_depth = from.goal_depth();
  field.centre_circle_radius = from.center_radius();
  field.goal_area_width = from.penalty_width();
  field.goal_area_depth = from.penalty_depth();
  field.penalty_mark = from.penalty_point();
  return field;
}

void fill(const SeenRobot& robot, sim::Robot& out) {
  out.set_robot_id(robot.number);
  out.set_x(robot.state.pose.position.x);
  out.set_y(robot.state.pose.position.y);
  // Headings are in [-pi, pi) here and in (-pi, pi] on the wire.
  const double heading = robot.state.pose.heading;
  out.set_orientation(heading == -math::kPi ? math::kPi : heading);
  out.set_vx(robot.state.velocity.x);
  out.set_vy(robot.state.velocity.y);
  out.set_vorientation(robot.state.angular_velocity);
}

SeenRobot robotOf(const sim::Robot& from) {
  SeenRobot robot;
  robot.number = from.robot_id();
  robot.state.pose = {{from.x(), from.y()}, math::wrapAngle(from.orientation())};
  robot.state.velocity = {from.vx(), from.vy()};
  robot.state.angular_velocity = from.vorientation();
  return robot;
}

template <typename Robots>
std::vector<SeenRobot> robotsOf(const Robots& from) {
  std::vector<SeenRobot> robots;
  robots.reserve(static_cast<std::size_t>(from.size()));
  for (const sim::Robot& robot : from) robots.push_back(robotOf(robot));
  return robots;
}

template <typename Message>
Result<Message> parsed(std::string_view datagram, const char* what) {
  if (datagram.size() > kLongestMessage) {
    return fail(ErrorCode::kBadInput, fmt::format("{} bytes are too many for {}: at most {}", datagram.size(),
                                                  what, kLongestMessage));
  }
  Message message;
  if (!message.ParseFromArray(datagram.data(), static_cast<int>(datagram.size()))) {
    return fail(ErrorCode::kBadInput, fmt::format("{} bytes are no {}", datagram.size(), what));
  }
  return message;
}

template <typename Message>
std::string bytesOf(const Message& message) {
  return message.SerializeAsString();
}

}  // namespace

std::string datagramOf(const Vision& vision) {
  sim::Environment message;
  message.set_step(vision.step);
  sim::Frame& frame = *message.mutable_frame();
  sim::Ball& ball = *frame.mutable_ball();
  ball.set_x(vision.ball.position.x);
  ball.set_y(vision.ball.position.y);
  ball.set_z(vision.ball_height);
  ball.set_vx(vision.ball.velocity.x);
  ball.set_vy(vision.ball.velocity.y);
  for (const SeenRobot& robot : vision.robots[indexOf(TeamId::kYellow)]) {
    fill(robot, *frame.add_robots_yellow());
  }
  for (const SeenRobot& robot : vision.robots[indexOf(TeamId::kBlue)]) {
    fill(robot, *frame.add_robots_blue());
  }
  fill(vision.field, *message.mutable_field());
  message.set_goals_blue(vision.goals[indexOf(TeamId::kBlue)]);
  message.set_goals_yellow(vision.goals[indexOf(TeamId::kYellow)]);
  return bytesOf(message);
}

Result<Vision> readVision(std::string_view datagram) {
  const auto message = parsed<sim::Environment>(datagram, "frame of vision");
  if (!message) return tl::unexpected<Error>(message.error());
  Vision vision;
  vision.step = message->step();
  const sim::Ball& ball = message->frame().ball();
  vision.ball.position = {ball.x(), ball.y()};
  vision.ball.velocity = {ball.vx(), ball.vy()};
  vision.ball_height = ball.z();
  vision.robots = {robotsOf(message->frame().robots_blue()), robotsOf(message->frame().robots_yellow())};
  vision.field = fieldOf(message->field());
  vision.goals = {message->goals_blue(), message->goals_yellow()};
  return vision;
}

std::string datagramOf(const Packet& packet) {
  sim::Packet message;
  for (const WheelCommand& command : packet.commands) {
    sim::Command& out = *message.mutable_cmd()->add_robot_commands();
    out.set_id(command.number);
    out.set_yellowteam(isYellow(command.team));
    out.set_wheel_left(command.wheels.left);
    out.set_wheel_right(command.wheels.right);
  }
  if (packet.ball) {
    sim::BallReplacement& out = *message.mutable_replace()->mutable_ball();
    out.set_x(packet.ball->position.x);
    out.set_y(packet.ball->position.y);
    out.set_vx(packet.ball->velocity.x);
    out.set_vy(packet.ball->velocity.y);
  }
  for (const RobotReplacement& robot : packet.robots) {
    sim::RobotReplacement& out = *message.mutable_replace()->add_robots();
    sim::Robot& position = *out.mutable_position();
    position.set_robot_id(robot.number);
    position.set_x(robot.pose.position.x);
    position.set_y(robot.pose.position.y);
    position.set_orientation(robot.pose.heading * kDegrees);
    out.set_yellowteam(isYellow(robot.team));
    out.set_turnon(robot.on);
  }
  return bytesOf(message);
}

Result<Packet> readPacket(std::string_view datagram) {
  const auto message = parsed<sim::Packet>(datagram, "packet");
  if (!message) return tl::unexpected<Error>(message.error());
  Packet packet;
  for (const sim::Command& command : message->cmd().robot_commands()) {
    packet.commands.push_back(
        {command.id(), teamOf(command.yellowteam()), {command.wheel_left(), command.wheel_right()}});
  }
  if (message->replace().has_ball()) {
    const sim::BallReplacement& ball = message->replace().ball();
    packet.ball = BallReplacement{{ball.x(), ball.y()}, {ball.vx(), ball.vy()}};
  }
  for (const sim::RobotReplacement& robot : message->replace().robots()) {
    const sim::Robot& position = robot.position();
    packet.robots.push_back({position.robot_id(),
                             teamOf(robot.yellowteam()),
                             {{position.x(), position.y()}, position.orientation() / kDegrees},
                             robot.turnon()});
  }
  return packet;
}

std::string datagramOf(const RefereeCommand& command) {
  ref::VSSRef_Command message;
  message.set_foul(static_cast<ref::Foul>(command.foul));
  message.set_teamcolor(!command.team ? ref::NONE : isYellow(*command.team) ? ref::YELLOW : ref::BLUE);
  message.set_foulquadrant(static_cast<ref::Quadrant>(command.quadrant));
  message.set_timestamp(command.seconds);
  message.set_gamehalf(static_cast<ref::Half>(command.half));
  return bytesOf(message);
}

Result<RefereeCommand> readRefereeCommand(std::string_view datagram) {
  const auto message = parsed<ref::VSSRef_Command>(datagram, "referee's command");
  if (!message) return tl::unexpected<Error>(message.error());
  if (!ref::Foul_IsValid(message->foul()) || !ref::Color_IsValid(message->teamcolor()) ||
      !ref::Quadrant_IsValid(message->foulquadrant()) || !ref::Half_IsValid(message->gamehalf())) {
    return fail(ErrorCode::kBadInput, "the referee's command has an unknown foul, team, quadrant or half");
  }
  RefereeCommand command;
  command.foul = static_cast<Foul>(message->foul());
  if (message->teamcolor() != ref::NONE) command.team = teamOf(message->teamcolor() == ref::YELLOW);
  command.quadrant = static_cast<int>(message->foulquadrant());
  command.seconds = message->timestamp();
  command.half = static_cast<Half>(message->gamehalf());
  return command;
}

std::string datagramOf(const TeamPlaces& places) {
  ref::VSSRef_Placement message;
  ref::Frame& frame = *message.mutable_world();
  frame.set_teamcolor(isYellow(places.team) ? ref::YELLOW : ref::BLUE);
  for (const PlacedRobot& robot : places.robots) {
    ref::Robot& out = *frame.add_robots();
    out.set_robot_id(robot.number);
    out.set_x(robot.pose.position.x);
    out.set_y(robot.pose.position.y);
    out.set_orientation(robot.pose.heading * kDegrees);
  }
  return bytesOf(message);
}

Result<TeamPlaces> readTeamPlaces(std::string_view datagram) {
  const auto message = parsed<ref::VSSRef_Placement>(datagram, "placement");
  if (!message) return tl::unexpected<Error>(message.error());
  const ref::Frame& frame = message->world();
  if (frame.teamcolor() != ref::BLUE && frame.teamcolor() != ref::YELLOW) {
    return fail(ErrorCode::kBadInput, "the placement is neither blue's nor yellow's");
  }
  TeamPlaces places;
  places.team = teamOf(frame.teamcolor() == ref::YELLOW);
  for (const ref::Robot& robot : frame.robots()) {
    places.robots.push_back({robot.robot_id(), {{robot.x(), robot.y()}, robot.orientation() / kDegrees}});
  }
  return places;
}

}  // namespace fulbito::wire
