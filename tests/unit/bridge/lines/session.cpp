#include "tests/unit/bridge/lines/session.hpp"

#include <array>

#include "bridge/lines/line_codec.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito::test {
namespace {

MatchInfo matchInfo() {
  MatchInfo info;
  info.team = TeamId::kYellow;
  info.side = Side::kRight;
  info.field = *loadField("vsss-3v3");
  const RobotPreset preset = *loadRobot("vsss");
  info.robot = preset.robot;
  info.ball = preset.ball;
  info.physics = *loadPhysics("standard");
  info.rules = *loadRules("vsss-3v3");
  info.observation_age = 2 * info.dt();
  info.position_noise = 0.001;
  info.heading_noise = 0.01;
  info.dropout = 0.005;
  info.decision_time = DecisionTime{};
  info.seed = 18446744073709551615u;
  return info;
}

Observation kickOff() {
  Observation seen;
  seen.dt = matchInfo().dt();
  seen.remaining = 300.0;
  seen.playing = false;
  seen.since_restart = -0.5;
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = std::array{-0.65, -0.4, -0.15}[i];
    seen.own[i] = {true, {{{x, 0.0}, 0.0}, {}, 0.0, {}}};
    seen.opponents[i] = {true, {{{-x, 0.0}, -math::kPi}, {}, 0.0, {}}};
  }
  return seen;
}

/// `seconds` later: all robots drive, and one opponent has been sent off.
Observation inPlay(double seconds, double ball_x, bool drawings) {
  Observation seen = kickOff();
  seen.tick = static_cast<Tick>(seconds * 60.0);
  seen.playing = true;
  seen.since_restart = seconds - 0.5;
  seen.remaining = 300.0 - seen.since_restart;
  seen.ball = {{ball_x, 0.1}, {0.625, -0.0}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    RobotState& robot = seen.own[i].state;
    robot.pose.position.y = std::array{0.0, -0.2, 0.25}[i];
    robot.pose.heading = 0.3;
    robot.velocity = {0.1, 1e-7};
    robot.angular_velocity = -1.0 / 3.0;
    robot.wheels = {3.5, 4.25};
    seen.sent[i] = {3.51, 4.26};
  }
  seen.opponents[2] = {};
  seen.wants_drawings = drawings;
  return seen;
}

GameEvent goal() {
  GameEvent event;
  event.tick = 1234;
  event.play_time = 20.05;
  event.clause = "goal";
  event.law = "7.1";
  event.team = TeamId::kYellow;
  event.robot = std::uint8_t{1};
  event.place = {0.77, 0.03};
  event.value = 0.0215;
  event.threshold = 0.02;
  event.margin = 0.0015;
  return event;
}

PlacementRequest placement(RestartKind kind, bool ours, Vec2 ball) {
  PlacementRequest request;
  request.kind = kind;
  request.ours = ours;
  request.ball = ball;
  request.delay = 0.5;
  for (std::size_t i = 0; i < 3; ++i)
    request.defaults[i] = Pose2{{std::array{-0.675, -0.2, -0.4}[i], std::array{0.0, 0.0, 0.3}[i]}, 0.0};
  request.now = kickOff();
  request.now.restart = kind;
  request.now.restart_is_ours = ours;
  return request;
}

Observation afterGoal() {
  Observation seen = inPlay(20.55, 0.77, false);
  seen.playing = false;
  seen.restart = RestartKind::kKickOff;
  seen.since_restart = -0.5;
  seen.own_score = 1;
  return seen;
}

PlacementRequest conceding() {
  PlacementRequest request = placement(RestartKind::kKickOff, false, {});
  request.opponents = request.defaults;
  for (auto& pose : *request.opponents)
    if (pose) pose = Pose2{-pose->position, -math::kPi};
  request.cause = goal();
  request.now = afterGoal();
  return request;
}

MatchEnd matchEnd() {
  MatchEnd end;
  end.tick = 36000;
  end.own_score = 1;
  end.winner = TeamId::kYellow;
  end.cause = goal();
  end.cause.clause = "full-time";
  end.cause.law = "5";
  end.cause.tick = 36000;
  end.cause.play_time = 300.0;
  end.cause.robot.reset();
  return end;
}

SessionMessage asks(std::function<void(TeamCodec&, std::uint64_t, std::string&)> write) {
  return {true, std::move(write)};
}

SessionMessage tells(std::function<void(TeamCodec&, std::string&)> write) {
  return {false, [write = std::move(write)](TeamCodec& codec, std::uint64_t, std::string& out) {
            write(codec, out);
          }};
}

SessionMessage decides(const Observation& seen) {
  return asks([seen](TeamCodec& c, std::uint64_t id, std::string& out) { c.decide(id, seen, out); });
}

SessionMessage places(const PlacementRequest& request) {
  return asks([request](TeamCodec& c, std::uint64_t id, std::string& out) { c.place(id, request, out); });
}

SessionMessage exercises(const Exercise& task) {
  return asks([task](TeamCodec& c, std::uint64_t id, std::string& out) {
    c.exercise(id, inPlay(1.0, 0.2, false), task, out);
  });
}

}  // namespace

std::vector<SessionMessage> sessionMessages() {
  const TeamHello hello{"fulbito 0.1.0", {{"depth", "0.125"}, {"navigator", "bezier:clearance=0.03"}}};
  const MatchInfo info = matchInfo();
  const PlayStop stop{goal(), afterGoal()};
  const MatchEnd end = matchEnd();
  return {
      asks([hello](TeamCodec& c, std::uint64_t id, std::string& out) { c.hello(id, hello, out); }),
      asks([info](TeamCodec& c, std::uint64_t id, std::string& out) { c.begin(id, info, out); }),
      places(placement(RestartKind::kKickOff, true, {})),
      tells([](TeamCodec& c, std::string& out) { c.ready(kickOff(), out); }),
      decides(kickOff()),
      decides(inPlay(1.0, 0.3, false)),
      decides(inPlay(1.5, -0.5, true)),
      tells([stop](TeamCodec& c, std::string& out) { c.stopped(stop, out); }),
      places(conceding()),
      places(placement(RestartKind::kGoalKick, true, {-0.6, 0.35})),
      exercises({Exercise::Kind::kReachPose, {0.25, -0.125}, 1.5, 0.0, 0.0}),
      exercises({Exercise::Kind::kPredictBall, {}, 0.0, 0.0, 0.5}),
      exercises({Exercise::Kind::kTurn, {}, -1.0, 0.0, 0.0}),
      tells([end](TeamCodec& c, std::string& out) { c.ended(end, out); }),
  };
}

std::vector<std::string> sessionLines() {
  LineCodec codec;
  std::vector<std::string> lines;
  std::uint64_t id = 0;
  for (const SessionMessage& message : sessionMessages()) {
    std::string line;
    message.write(codec, message.request ? ++id : 0, line);
    lines.push_back(line);
  }
  return lines;
}

std::string answerOf(const PipedProgram& program, const std::string& line) {
  program.send(line);
  std::string received;
  while (received.empty() || received.back() != '\n') {
    if (!program.receive(received)) return "(the program has ended)";
  }
  received.pop_back();
  return received;
}

}  // namespace fulbito::test
