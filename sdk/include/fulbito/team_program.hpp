// Runs a team of `fulbito/team.hpp` as a program over the line protocol (docs/team-protocol.md): the macro
// `FULBITO_TEAM_PROGRAM(MyTeam)` is the whole `main`. Needs the standard library and POSIX only.
//
// What the team prints goes to standard error, since standard output belongs to the protocol.
#pragma once

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <functional>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unistd.h>
#include <utility>
#include <variant>

#include "fulbito/detail/json_reader.hpp"
#include "fulbito/detail/json_text.hpp"
#include "fulbito/team.hpp"

namespace fulbito::team {

/// The parts of the runner; a team's author needs none of them.
namespace program {

using json::Reader;

/// Version of the protocol, as in the handshake.
inline constexpr std::string_view kProtocol = "fulbito-team/1";

/// @{ What the simulator sends, as values. Unknown members are skipped, so that later versions can add some.

/// One member of a table, bound to a variable.
struct Key {
  std::string_view name;                                         ///< name of the member
  std::variant<double*, int*, bool*, std::string*, Vec2*> into;  ///< the variable
};

/// A point as [x, y].
inline void readPair(Reader& in, Vec2& into) {
  double* const parts[] = {&into.x, &into.y};
  std::size_t count = 0;
  if (!in.enterArray()) return;
  for (; in.nextItem(); ++count) count < 2 ? in.number(*parts[count]) : in.error("more than two numbers");
}

/// A whole number of an `int`.
inline void readInt(Reader& in, int& into) {
  std::int64_t value = 0;
  if (in.integer(value, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()))
    into = static_cast<int>(value);
}

/// The value of a key.
inline void readKey(Reader& in, const Key& key) {
  if (double* const* number = std::get_if<double*>(&key.into)) in.number(**number);
  if (int* const* whole = std::get_if<int*>(&key.into)) readInt(in, **whole);
  if (bool* const* flag = std::get_if<bool*>(&key.into)) in.boolean(**flag);
  if (std::string* const* text = std::get_if<std::string*>(&key.into)) in.string(**text);
  if (Vec2* const* point = std::get_if<Vec2*>(&key.into)) readPair(in, **point);
}

/// An object of which some members are wanted.
inline void readTable(Reader& in, std::initializer_list<Key> keys) {
  if (!in.enterObject()) return;
  for (std::string_view name; in.nextMember(name);) {
    const Key* const key =
        std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return k.name == name; });
    key == keys.end() ? in.skip() : readKey(in, *key);
  }
}

/// One of some words. @return its number
inline int readWord(Reader& in, std::initializer_list<std::string_view> words) {
  std::string text;
  if (!in.string(text)) return 0;
  const auto* const found = std::find(words.begin(), words.end(), text);
  if (found != words.end()) return static_cast<int>(found - words.begin());
  in.error("an unknown word");
  return 0;
}

/// "blue" or "yellow".
inline Colour readColour(Reader& in) {
  return readWord(in, {"blue", "yellow"}) == 0 ? Colour::kBlue : Colour::kYellow;
}
/// A kind of restart.
inline Restart readRestart(Reader& in) {
  return static_cast<Restart>(
      readWord(in, {"kick-off", "free-ball", "free-kick", "penalty", "goal-kick", "given"}));
}

/// Flags of the rules that switch the limits of `Rules` on.
struct RuleSwitches {
  bool attackers = true;  ///< too many attackers in an area is a foul
  bool defenders = true;  ///< the same of defenders
  bool holding = true;    ///< the keeper's hold is limited
};

/// One table of the rules.
inline void readRulesTable(Reader& in, std::string_view name, Rules& r, RuleSwitches& on) {
  if (name == "restart") {
    return readTable(in, {{"delay", &r.restart_delay},
                          {"goal_delay", &r.goal_delay},
                          {"hold_robots", &r.hold_robots},
                          {"false_start_distance", &r.false_start_distance}});
  }
  if (name == "stuck") {
    return readTable(in, {{"seconds", &r.stuck_seconds},
                          {"area_seconds", &r.stuck_area_seconds},
                          {"radius", &r.stuck_radius}});
  }
  if (name == "areas") {
    return readTable(in, {{"arc", &r.areas_have_arc},
                          {"attackers", &on.attackers},
                          {"attackers_max", &r.attackers_max},
                          {"big_attackers_max", &r.big_attackers_max},
                          {"defenders", &on.defenders},
                          {"defenders_max", &r.defenders_max},
                          {"big_defenders_max", &r.big_defenders_max}});
  }
  if (name == "keeper") {
    return readTable(in, {{"holding", &on.holding},
                          {"hold_seconds", &r.keeper_hold_seconds},
                          {"charged", &r.keeper_charging}});
  }
  if (name == "fouls") {
    return readTable(in,
                     {{"push", &r.pushing}, {"holding", &r.pinning}, {"pinned_seconds", &r.pinned_seconds}});
  }
  if (name == "shoot_out") return readTable(in, {{"kick_seconds", &r.kick_seconds}});
  if (name == "free_ball") return readTable(in, {{"distance", &r.free_ball_distance}});
  if (name == "goal_kick") return readTable(in, {{"ball_free", &r.goal_kick_ball_free}});
  in.skip();
}

/// The periods and the tie-break.
inline void readPeriods(Reader& in, Rules& r) {
  if (!in.enterObject()) return;
  for (std::string_view name; in.nextMember(name);) {
    if (name == "half_seconds") {
      in.number(r.half_seconds);
    } else if (name == "swap_sides") {
      in.boolean(r.swap_sides);
    } else if (name == "mercy_goals") {
      readInt(in, r.mercy_goals);
    } else if (name == "tie_break") {
      r.tie_break =
          static_cast<TieBreak>(readWord(in, {"none", "overtime", "shoot-out", "overtime+shoot-out"}));
    } else if (name == "overtime_parts") {
      readInt(in, r.overtime_parts);
    } else if (name == "overtime_seconds") {
      in.number(r.overtime_seconds);
    } else if (name == "golden_goal") {
      in.boolean(r.golden_goal);
    } else {
      in.skip();
    }
  }
}

/// The rules.
inline void readRules(Reader& in, Rules& r) {
  RuleSwitches on;
  if (!in.enterObject()) return;
  for (std::string_view name; in.nextMember(name);) {
    if (name == "name") {
      in.string(r.name);
    } else if (name == "text") {
      in.string(r.text);
    } else if (name == "team_size") {
      readInt(in, r.team_size);
    } else if (name == "periods") {
      readPeriods(in, r);
    } else {
      readRulesTable(in, name, r, on);
    }
  }
  if (!on.attackers) r.attackers_max = r.big_attackers_max = -1;
  if (!on.defenders) r.defenders_max = r.big_defenders_max = -1;
  if (!on.holding) r.keeper_hold_seconds = 0.0;
}

/// The field.
inline void readField(Reader& in, Field& f) {
  readTable(in, {{"name", &f.name},
                 {"length", &f.length},
                 {"width", &f.width},
                 {"goal_width", &f.goal_width},
                 {"goal_depth", &f.goal_depth},
                 {"corner", &f.corner},
                 {"wall_thickness", &f.wall_thickness},
                 {"goal_area_width", &f.goal_area_width},
                 {"goal_area_depth", &f.goal_area_depth},
                 {"goal_area_arc_width", &f.goal_area_arc_width},
                 {"goal_area_arc_depth", &f.goal_area_arc_depth},
                 {"big_area_width", &f.big_area_width},
                 {"big_area_depth", &f.big_area_depth},
                 {"centre_circle_radius", &f.centre_circle_radius},
                 {"penalty_mark", &f.penalty_mark},
                 {"free_ball_mark", &f.free_ball_mark}});
}

/// The robots.
inline void readRobotModel(Reader& in, RobotModel& r) {
  readTable(in, {{"name", &r.name},
                 {"length", &r.length},
                 {"width", &r.width},
                 {"mass", &r.mass},
                 {"wheel_radius", &r.wheel_radius},
                 {"axle_track", &r.axle_track},
                 {"max_wheel_speed", &r.max_wheel_speed},
                 {"wheel_acceleration", &r.wheel_acceleration},
                 {"wheel_braking", &r.wheel_braking},
                 {"yaw_acceleration", &r.yaw_acceleration},
                 {"rolling_drag", &r.rolling_drag},
                 {"longitudinal_grip", &r.longitudinal_grip},
                 {"lateral_grip", &r.lateral_grip},
                 {"spin_slow_speed", &r.spin_slow_speed},
                 {"spin_slow_ratio", &r.spin_slow_ratio},
                 {"spin_fast_speed", &r.spin_fast_speed},
                 {"spin_fast_ratio", &r.spin_fast_ratio},
                 {"friction", &r.friction},
                 {"restitution", &r.restitution}});
}

/// The ball.
inline void readBallModel(Reader& in, BallModel& b) {
  readTable(in, {{"radius", &b.radius},
                 {"mass", &b.mass},
                 {"roll_keep", &b.roll_keep},
                 {"slide_deceleration", &b.slide_deceleration},
                 {"roll_deceleration", &b.roll_deceleration},
                 {"stop_speed", &b.stop_speed},
                 {"wall_restitution", &b.wall_restitution},
                 {"wall_spin_keep", &b.wall_spin_keep},
                 {"robot_restitution", &b.robot_restitution},
                 {"friction", &b.friction}});
}

/// The time steps.
inline void readPhysics(Reader& in, Physics& p) {
  readTable(in, {{"name", &p.name},
                 {"control_rate", &p.control_rate},
                 {"substeps", &p.substeps},
                 {"velocity_iterations", &p.velocity_iterations},
                 {"position_iterations", &p.position_iterations},
                 {"bullet_ball", &p.bullet_ball},
                 {"contact_depth", &p.contact_depth},
                 {"max_ball_speed", &p.max_ball_speed},
                 {"restitution_threshold", &p.restitution_threshold},
                 {"wheel_command_step", &p.wheel_command_step}});
}

/// Limits of the decision time; null: none.
inline void readDecisionTime(Reader& in, std::optional<DecisionTime>& time) {
  if (in.takeNull()) return;
  DecisionTime& t = time.emplace();
  readTable(in, {{"decision", &t.decision}, {"bank", &t.bank}, {"held", &t.held}});
}

/// A seed: its digits as a string, as it has 64 bits.
inline void readSeed(Reader& in, std::uint64_t& seed) {
  std::string digits;
  if (!in.string(digits)) return;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), seed);
  if (read.ec != std::errc() || read.ptr != digits.data() + digits.size()) in.error("not a whole number");
}

/// One member of the message `begin`.
inline void readInfoMember(Reader& in, std::string_view name, Info& info) {
  if (name == "team") {
    info.colour = readColour(in);
  } else if (name == "side") {
    info.left = readWord(in, {"left", "right"}) == 0;
  } else if (name == "dt") {
    in.number(info.dt);
  } else if (name == "seed") {
    readSeed(in, info.seed);
  } else if (name == "field") {
    readField(in, info.field);
  } else if (name == "robot") {
    readRobotModel(in, info.robot);
  } else if (name == "ball") {
    readBallModel(in, info.ball);
  } else if (name == "rules") {
    readRules(in, info.rules);
  } else if (name == "decision_time") {
    readDecisionTime(in, info.decision_time);
  } else if (name == "physics") {
    readPhysics(in, info.physics);
  } else if (name == "vision") {
    readTable(in, {{"age", &info.observation_age},
                   {"position_noise", &info.position_noise},
                   {"heading_noise", &info.heading_noise},
                   {"dropout", &info.dropout}});
  } else {
    in.skip();
  }
}

/// One robot, own ones with the wheel speeds sent to it; null: not on the field.
inline void readRobot(Reader& in, Robot& robot, Wheels& sent) {
  robot = Robot{};
  sent = Wheels{};
  if (in.takeNull() || !in.enterObject()) return;
  robot.present = true;
  for (std::string_view name; in.nextMember(name);) {
    if (name == "x") {
      in.number(robot.position.x);
    } else if (name == "y") {
      in.number(robot.position.y);
    } else if (name == "heading") {
      in.number(robot.heading);
    } else if (name == "vx") {
      in.number(robot.velocity.x);
    } else if (name == "vy") {
      in.number(robot.velocity.y);
    } else if (name == "omega") {
      in.number(robot.angular_velocity);
    } else if (name == "left") {
      in.number(robot.wheels.left);
    } else if (name == "right") {
      in.number(robot.wheels.right);
    } else if (name == "sent_left") {
      in.number(sent.left);
    } else if (name == "sent_right") {
      in.number(sent.right);
    } else {
      in.skip();
    }
  }
}

/// Calls `item(i)` for each item of an array of at most `kMaxTeamSize`. @return their number
template <typename Item>
int readTeam(Reader& in, Item item) {
  std::size_t count = 0;
  if (!in.enterArray()) return 0;
  for (; in.nextItem(); ++count) {
    count < kMaxTeamSize ? item(count) : static_cast<void>(in.error("too many robots"));
  }
  return static_cast<int>(count);
}

/// The ball of an observation.
inline void readBall(Reader& in, Ball& ball) {
  readTable(
      in,
      {{"x", &ball.position.x}, {"y", &ball.position.y}, {"vx", &ball.velocity.x}, {"vy", &ball.velocity.y}});
}

/// One member of an observation. `spare` takes what the opponents' robots lack.
inline void readObservationMember(Reader& in, std::string_view name, Observation& seen) {
  Wheels spare;
  if (name == "own") {
    seen.team_size = readTeam(in, [&](std::size_t i) { readRobot(in, seen.own[i], seen.sent[i]); });
  } else if (name == "opponents") {
    readTeam(in, [&](std::size_t i) { readRobot(in, seen.opponents[i], spare); });
  } else if (name == "ball") {
    readBall(in, seen.ball);
  } else if (name == "tick") {
    in.integer(seen.tick, std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max());
  } else if (name == "period") {
    readInt(in, seen.period);
  } else if (name == "remaining") {
    in.number(seen.remaining);
  } else if (name == "playing") {
    in.boolean(seen.playing);
  } else if (name == "restart") {
    seen.restart = readRestart(in);
  } else if (name == "restart_is_ours") {
    in.boolean(seen.restart_is_ours);
  } else if (name == "since_restart") {
    in.number(seen.since_restart);
  } else if (name == "own_score") {
    readInt(in, seen.own_score);
  } else if (name == "opponent_score") {
    readInt(in, seen.opponent_score);
  } else if (name == "wants_drawings") {
    in.boolean(seen.wants_drawings);
  } else {
    in.skip();
  }
}

/// An observation, without its `dt`.
inline void readObservation(Reader& in, Observation& seen) {
  if (!in.enterObject()) return;
  for (std::string_view name; in.nextMember(name);) readObservationMember(in, name, seen);
}

/// A call of the referee; null: none.
inline void readCall(Reader& in, Call& call) {
  call = Call{};
  if (in.takeNull() || !in.enterObject()) return;
  for (std::string_view name; in.nextMember(name);) {
    if (name == "clause") {
      in.string(call.clause);
    } else if (name == "law") {
      in.string(call.law);
    } else if (name == "team") {
      if (!in.takeNull()) call.team = readColour(in);
    } else if (name == "robot") {
      if (!in.takeNull()) readInt(in, call.robot.emplace());
    } else if (name == "x") {
      in.number(call.place.x);
    } else if (name == "y") {
      in.number(call.place.y);
    } else if (name == "tick") {
      in.integer(call.tick, 0, std::numeric_limits<std::int64_t>::max());
    } else if (name == "period") {
      readInt(in, call.period);
    } else if (name == "play_time") {
      in.number(call.play_time);
    } else if (name == "value") {
      in.number(call.value);
    } else if (name == "threshold") {
      in.number(call.threshold);
    } else if (name == "margin") {
      in.number(call.margin);
    } else {
      in.skip();
    }
  }
}

/// Poses by robot number.
inline void readPoses(Reader& in, Poses& poses) {
  readTeam(in, [&](std::size_t i) {
    if (in.takeNull()) return;
    Pose& pose = poses[i].emplace();
    readTable(in, {{"x", &pose.position.x}, {"y", &pose.position.y}, {"heading", &pose.heading}});
  });
}

/// A task of a drill.
inline void readExercise(Reader& in, Exercise& task) {
  if (!in.enterObject()) return;
  for (std::string_view name; in.nextMember(name);) {
    if (name == "kind") {
      task.kind = static_cast<Exercise::Kind>(
          readWord(in, {"reach-pose", "turn", "reach-ball", "push", "predict-ball"}));
    } else if (name == "x") {
      in.number(task.target.x);
    } else if (name == "y") {
      in.number(task.target.y);
    } else if (name == "heading") {
      in.number(task.heading);
    } else if (name == "speed") {
      in.number(task.speed);
    } else if (name == "horizon") {
      in.number(task.horizon);
    } else {
      in.skip();
    }
  }
}

/// The settings of the handshake, for the team. @return what is wrong with one; empty: all are taken
inline std::string readSettings(Reader& in, Team& team) {
  std::string problem, value;
  if (!in.enterObject()) return problem;
  for (std::string_view name; in.nextMember(name);) {
    const std::string kept(name);
    if (in.string(value) && problem.empty()) problem = team.set(kept, value);
  }
  return problem;
}
/// @}

/// @{ What the team answers, as text.

/// One member with its name, which brings the comma or brace before it.
template <typename T>
void add(std::string& out, std::string_view name, const T& value) {
  out += name;
  json::append(out, value);
}

/// A place to drive to.
inline void append(std::string& out, const GoTo& go_to) {
  // Null would mean "any heading" and "no limit": a target that is no number says so by its place.
  const bool broken = std::isnan(go_to.speed_limit) || (go_to.heading && !std::isfinite(*go_to.heading));
  add(out, R"({"go_to":{"x":)", broken ? std::numeric_limits<double>::quiet_NaN() : go_to.position.x);
  add(out, R"(,"y":)", go_to.position.y);
  if (go_to.heading) add(out, R"(,"heading":)", *go_to.heading);
  if (std::isfinite(go_to.speed_limit)) add(out, R"(,"speed_limit":)", go_to.speed_limit);
  add(out, R"(,"tolerance":)", go_to.tolerance);
  const GoTo usual;
  if (go_to.stop != usual.stop) add(out, R"(,"stop":)", go_to.stop);
  if (go_to.avoid_ball != usual.avoid_ball) add(out, R"(,"avoid_ball":)", go_to.avoid_ball);
  if (go_to.avoid_mates != usual.avoid_mates) add(out, R"(,"avoid_mates":)", go_to.avoid_mates);
  if (go_to.avoid_opponents != usual.avoid_opponents)
    add(out, R"(,"avoid_opponents":)", go_to.avoid_opponents);
  if (go_to.either_front != usual.either_front) add(out, R"(,"either_front":)", go_to.either_front);
  if (go_to.navigator != usual.navigator) add(out, R"(,"navigator":)", go_to.navigator);
  out += "}}";
}

/// A robot's command.
inline void append(std::string& out, const Command& command) {
  if (command.kind == Command::Kind::kGoTo) return append(out, command.go_to);
  const bool twist = command.kind == Command::Kind::kTwist;
  add(out, twist ? R"({"linear":)" : R"({"left":)", twist ? command.twist.linear : command.wheels.left);
  add(out, twist ? R"(,"angular":)" : R"(,"right":)", twist ? command.twist.angular : command.wheels.right);
  out += '}';
}

/// Whether all numbers of a drawing are finite; others are left out.
inline bool drawable(const Drawing& d) {
  return std::isfinite(d.from.x) && std::isfinite(d.from.y) && std::isfinite(d.to.x) &&
         std::isfinite(d.to.y) && std::isfinite(d.radius);
}

/// A drawing.
inline void append(std::string& out, const Drawing& d) {
  constexpr std::string_view kShapes[] = {R"({"line":[)", R"({"circle":[)", R"({"text":[)"};
  add(out, kShapes[static_cast<std::size_t>(d.kind)], d.from.x);
  add(out, ",", d.from.y);
  if (d.kind == Drawing::Kind::kLine) {
    add(out, ",", d.to.x);
    add(out, ",", d.to.y);
  } else if (d.kind == Drawing::Kind::kCircle) {
    add(out, ",", d.radius);
  } else {
    add(out, ",", std::string_view(d.text));
  }
  out += "]}";
}

/// Numbers of the roles, if the team tells any.
inline void appendRoles(std::string& out, const Commands& commands, std::size_t team_size) {
  const auto& roles = commands.roles;
  if (std::all_of(roles.begin(), roles.end(), [](std::uint8_t role) { return role == 0; })) return;
  for (std::size_t i = 0; i < team_size; ++i) add(out, i == 0 ? R"(,"roles":[)" : ",", roles[i]);
  out += ']';
}

/// Commands of all robots, roles and drawings, with a comma before each.
inline void append(std::string& out, const Commands& commands, std::size_t team_size) {
  out += R"(,"robots":[)";
  for (std::size_t i = 0; i < team_size; ++i) {
    if (i > 0) out += ',';
    append(out, commands.robots[i]);
  }
  out += ']';
  appendRoles(out, commands, team_size);
  if (commands.drawings.empty()) return;
  out += R"(,"drawings":[)";
  bool first = true;
  for (const Drawing& drawing : commands.drawings) {
    if (!drawable(drawing)) continue;
    if (!first) out += ',';
    first = false;
    append(out, drawing);
  }
  out += ']';
}

/// Poses of all robots.
inline void append(std::string& out, const Poses& poses, std::size_t team_size) {
  out += R"(,"poses":[)";
  for (std::size_t i = 0; i < team_size; ++i) {
    if (i > 0) out += ',';
    if (!poses[i]) {
      out += "null";
      continue;
    }
    add(out, R"({"x":)", poses[i]->position.x);
    add(out, R"(,"y":)", poses[i]->position.y);
    add(out, R"(,"heading":)", poses[i]->heading);
    out += '}';
  }
  out += ']';
}

/// A point as a member.
inline void append(std::string& out, std::string_view name, Vec2 point) {
  out += name;
  add(out, R"({"x":)", point.x);
  add(out, R"(,"y":)", point.y);
  out += '}';
}
/// @}

/// A message of the simulator that asks or tells something of the game.
struct Message {
  std::string type;             ///< kind of message
  std::int64_t id = 0;          ///< of a request
  Observation now;              ///< the game
  PlacementRequest placement;   ///< of `place`; its cause is also that of `stopped` and `ended`
  Exercise exercise;            ///< of `exercise`
  End end;                      ///< of `ended`
  Info info;                    ///< of `begin`
  std::string protocol;         ///< of `hello`
  std::string setting_problem;  ///< of `hello`
};

/// One team's side of the conversation: a line in, a line out or nothing.
class Conversation {
 public:
  /// `make` creates the team, which needs the first line's settings.
  explicit Conversation(std::unique_ptr<Team> team) : team_(std::move(team)) {}

  /// Takes a line of the simulator and appends the answer with its line end, if it gets one.
  /// Throws std::runtime_error if the line is not a message, and whatever the team throws.
  void take(std::string_view line, std::string& out) {
    Reader in(line);
    read(in);
    in.end();
    if (!in.ok()) throw std::runtime_error("the simulator's message is not understood: " + in.message());
    answer(out);
  }

 private:
  void read(Reader& in) {
    // `type` is first in all messages, as the protocol says: members mean different things by it.
    message_.type.clear();
    if (!in.enterObject()) return;
    for (std::string_view name; in.nextMember(name);) {
      if (name == "type") {
        in.string(message_.type);
        if (message_.type == "begin") message_.info = Info{};
        if (message_.type == "place") message_.placement = PlacementRequest{};
      } else if (name == "id") {
        in.integer(message_.id, 0, std::numeric_limits<std::int64_t>::max());
      } else if (name == "now") {
        readObservation(in, message_.now);
      } else if (message_.type == "begin") {
        readInfoMember(in, name, message_.info);
      } else if (message_.type == "place") {
        readPlacement(in, name);
      } else {
        readOther(in, name);
      }
    }
  }
  void readPlacement(Reader& in, std::string_view name) {
    PlacementRequest& request = message_.placement;
    if (name == "kind") {
      request.kind = readRestart(in);
    } else if (name == "ours") {
      in.boolean(request.ours);
    } else if (name == "delay") {
      in.number(request.delay);
    } else if (name == "ball") {
      readTable(in, {{"x", &request.ball.x}, {"y", &request.ball.y}});
    } else if (name == "defaults") {
      readPoses(in, request.defaults);
    } else if (name == "opponents") {
      if (!in.takeNull()) readPoses(in, request.opponents.emplace());
    } else {
      readOther(in, name);
    }
  }
  void readOther(Reader& in, std::string_view name) {
    if (name == "cause") {
      readCall(in, message_.placement.cause);
    } else if (name == "exercise") {
      readExercise(in, message_.exercise);
    } else if (name == "protocol") {
      in.string(message_.protocol);
    } else if (name == "settings") {
      message_.setting_problem = readSettings(in, *team_);
    } else if (message_.type == "ended") {
      readEnd(in, name);
    } else {
      in.skip();
    }
  }
  void readEnd(Reader& in, std::string_view name) {
    End& end = message_.end;
    if (name == "reason") {
      end.reason = static_cast<End::Reason>(readWord(in, {"played", "abandoned", "interrupted"}));
    } else if (name == "tick") {
      in.integer(end.tick, 0, std::numeric_limits<std::int64_t>::max());
    } else if (name == "own_score") {
      readInt(in, end.own_score);
    } else if (name == "opponent_score") {
      readInt(in, end.opponent_score);
    } else if (name == "winner") {
      end.winner.reset();
      if (!in.takeNull()) end.winner = readColour(in);
    } else {
      in.skip();
    }
  }

  void answer(std::string& out) {
    const std::string& type = message_.type;
    message_.now.dt = message_.info.dt;
    if (type == "decide") return decide(out);
    if (type == "hello") return hello(out);
    if (type == "begin") return begin(out);
    if (type == "place") return place(out);
    if (type == "exercise") return exercise(out);
    if (type == "stopped") return team_->stopped({message_.placement.cause, message_.now});
    if (type == "ready") return team_->ready(message_.now);
    if (type == "ended") return ended();
    // A notice of a later version.
  }
  void open(std::string& out) const {
    add(out, R"({"type":)", std::string_view(message_.type));
    add(out, R"(,"id":)", message_.id);
  }
  void decide(std::string& out) {
    const Commands commands = team_->decide(message_.now);
    open(out);
    append(out, commands, teamSize());
    out += "}\n";
  }
  void hello(std::string& out) {
    open(out);
    if (message_.protocol != kProtocol) {
      message_.setting_problem = "this team speaks " + std::string(kProtocol);
    }
    if (!message_.setting_problem.empty()) {
      add(out, R"(,"error":)", std::string_view(message_.setting_problem));
    } else {
      add(out, R"(,"protocol":)", kProtocol);
      add(out, R"(,"name":)", std::string_view(team_->name()));
      add(out, R"(,"version":)", std::string_view(team_->version()));
    }
    out += "}\n";
  }
  void begin(std::string& out) {
    team_->start(message_.info);
    open(out);
    out += R"(,"navigators":[)";
    bool first = true;
    for (const std::string& navigator : team_->navigators()) {
      add(out, first ? "" : ",", std::string_view(navigator));
      first = false;
    }
    out += "]}\n";
  }
  void place(std::string& out) {
    message_.placement.now = message_.now;
    const std::optional<Placement> wishes = team_->place(message_.placement);
    open(out);
    if (wishes) {
      append(out, wishes->robots, teamSize());
      if (wishes->ball) append(out, R"(,"ball":)", *wishes->ball);
    }
    out += "}\n";
  }
  void exercise(std::string& out) {
    const std::optional<ExerciseReply> reply = team_->exercise(message_.now, message_.exercise);
    open(out);
    if (reply) {
      append(out, reply->commands, teamSize());
      append(out, R"(,"answer":)", reply->answer);
    }
    out += "}\n";
  }
  void ended() {
    message_.end.cause = message_.placement.cause;
    team_->ended(message_.end);
  }
  std::size_t teamSize() const { return static_cast<std::size_t>(message_.now.team_size); }

  std::unique_ptr<Team> team_;
  Message message_;
};

/// Lines from one descriptor, answers to another.
class Pipes {
 public:
  Pipes(int in, int out) : in_(in), out_(out) {}
  /// The next line without its end. @return false at the end of the input
  bool next(std::string_view& line) {
    received_.erase(0, taken_);
    taken_ = 0;
    for (std::size_t looked_at = 0;;) {
      const std::size_t end = received_.find('\n', looked_at);
      if (end != std::string::npos) {
        line = std::string_view(received_).substr(0, end);
        taken_ = end + 1;
        return true;
      }
      looked_at = received_.size();
      if (!receive()) return false;
    }
  }
  /// Writes all of it. @return false if nobody reads
  bool send(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t count = ::write(out_, text.data(), text.size());
      if (count > 0) text.remove_prefix(static_cast<std::size_t>(count));
      if (count < 0 && errno != EINTR) return false;
    }
    return true;
  }

 private:
  bool receive() {
    ssize_t count = 0;
    do count = ::read(in_, piece_.data(), piece_.size());
    while (count < 0 && errno == EINTR);
    if (count > 0) received_.append(piece_.data(), static_cast<std::size_t>(count));
    return count > 0;
  }

  int in_, out_;
  std::array<char, 65536> piece_;
  std::string received_;
  std::size_t taken_ = 0;  ///< of `received_`, by the last line
};

/// Keeps standard output for the protocol: from here on, what the team prints there goes to standard error.
/// @return the descriptor of the protocol; -1: there is none
inline int takeOutput() {
  const int out = ::dup(STDOUT_FILENO);
  // What is printed before a crash must not stay in a buffer.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  return ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0 ? -1 : out;
}

/// Plays until the input ends. @return the program's exit code
template <typename TeamClass>
int run() {
  const int out = takeOutput();
  if (out < 0) return 1;
  try {
    Pipes pipes(STDIN_FILENO, out);
    Conversation conversation(std::make_unique<TeamClass>());
    std::string answer;
    for (std::string_view line; pipes.next(line);) {
      answer.clear();
      conversation.take(line, answer);
      if (!pipes.send(answer)) return 1;
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "the team has thrown an exception: %s\n", error.what());
    return 1;
  }
  return 0;
}

}  // namespace program
}  // namespace fulbito::team

/// Defines `main` as the program of a team class, which needs a constructor without arguments.
#define FULBITO_TEAM_PROGRAM(TeamClass) \
  int main() { return ::fulbito::team::program::run<TeamClass>(); }
