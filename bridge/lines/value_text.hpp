#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "bridge/lines/match_info_text.hpp"
#include "fulbito/detail/lines/json_reader.hpp"
#include "fulbito/detail/lines/json_text.hpp"
#include "fulbito/strategy.hpp"

/// Writes values of the conversation as JSON to the end of a buffer, and reads values of a team's answer from
/// JSON. Functions that name members are generated from sdk/values/values.toml.
namespace fulbito::lines {

/// @{ The members of a value, with commas between them.
void appendVision(std::string& out, const MatchInfo& v);
void appendDecisionTime(std::string& out, const DecisionTime& v);
void appendInfo(std::string& out, const MatchInfo& v);
void appendRobot(std::string& out, const RobotState& v);
void appendOwnRobot(std::string& out, const RobotState& v, const WheelSpeeds& sent);
void appendBall(std::string& out, const BallState& v);
void appendObservation(std::string& out, const Observation& v);
void appendCall(std::string& out, const GameEvent& v);
void appendPlacementRequest(std::string& out, const PlacementRequest& v);
void appendEnd(std::string& out, const MatchEnd& v);
void appendExercise(std::string& out, const Exercise& v);
/// @}

/// Reads one member of a place to drive to, except `x` and `y`. @return false if `v` has no member `name`
bool readMember(json::Reader& in, std::string_view name, GoTo& v);

/// @{ Values with a special form in the protocol.
struct Seed {
  /// written as text: a double cannot hold it, and some languages read every number as a double
  std::uint64_t seed;
};
struct VisionOf {
  const MatchInfo& info;
};
struct OwnRobots {
  const Observation& seen;
};
struct OtherRobots {
  const Observation& seen;
};
/// The poses of the first `team_size` robots, null for a robot without one. Null if there are no poses.
struct PosesOf {
  PosesOf(const TeamPlacement& list, int size) : poses(&list), team_size(size) {}
  PosesOf(const std::optional<TeamPlacement>& list, int size)
      : poses(list ? &*list : nullptr), team_size(size) {}
  const TeamPlacement* poses;
  int team_size;
};
/// @}

/// @{ Appends a value as JSON.
using json::append;
inline void append(std::string& out, TeamId team) { json::append(out, nameOf(team)); }
inline void append(std::string& out, Side side) { json::append(out, side == Side::kLeft ? "left" : "right"); }
inline void append(std::string& out, RestartKind kind) { json::append(out, nameOf(kind)); }
void append(std::string& out, MatchEnd::Reason reason);
void append(std::string& out, Exercise::Kind kind);
void append(std::string& out, Seed value);
void append(std::string& out, Vec2 point);  ///< {"x":...,"y":...}
void append(std::string& out, const BallState& ball);
void append(std::string& out, OwnRobots robots);
void append(std::string& out, OtherRobots robots);
void append(std::string& out, PosesOf poses);
void append(std::string& out, VisionOf vision);
void append(std::string& out, const DecisionTime& time);
void append(std::string& out, const Observation& seen);
void append(std::string& out, const Exercise& exercise);
void append(std::string& out, const GameEvent& call);  ///< null if it has no clause
/// Null stands for an absent value.
template <typename T>
void append(std::string& out, const std::optional<T>& value) {
  value ? append(out, *value) : json::append(out, nullptr);
}
/// @}

/// Appends a member; `name` brings its comma, quotes and colon.
template <typename T>
void add(std::string& out, std::string_view name, const T& value) {
  out += name;
  append(out, value);
}

/// @{ Reads a value of an answer.
/// A number; null stands for NaN and infinities, which JSON lacks.
void read(json::Reader& in, double& into);
inline void read(json::Reader& in, bool& into) { in.boolean(into); }
void read(json::Reader& in, std::uint8_t& into);
/// Null stands for none.
void read(json::Reader& in, std::optional<double>& into);
/// A null leaves `into` as it is: no limit.
inline void readLimit(json::Reader& in, double& into) {
  if (!in.takeNull()) in.number(into);
}
/// @}

}  // namespace fulbito::lines
