// What the simulator sends to a team's program, as values. Unknown members are skipped, so that later
// versions can add some.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <variant>

#include "fulbito/detail/lines/json_reader.hpp"
#include "fulbito/team.hpp"

namespace fulbito::team::program {

using json::Reader;

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
                 {"curve_widening", &r.curve_widening},
                 {"curve_widening_rise", &r.curve_widening_rise},
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

}  // namespace fulbito::team::program
