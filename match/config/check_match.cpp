#include "match/config/check_match.hpp"

#include <limits>

#include <fmt/format.h>

#include "referee/rules/check_field.hpp"

namespace fulbito {
namespace {

constexpr double kMaxPlacementError = 0.01;  // [m]
constexpr double kMaxHeadingError = 0.2;     // [rad]
constexpr double kMaxDecision = 60.0;        // [s]
constexpr double kMaxStart = 600.0;          // [s]
constexpr int kMaxFailures = 1000;
constexpr double kMaxBank = 3600.0;  // [s]
constexpr int kMaxHeld = 3600;
constexpr int kMaxScore = 1000;
constexpr int kLastPeriod = 3;  // a match cannot start in the middle of a shoot-out

Result<void> range(const char* name, double value, double low, double high, const char* unit) {
  if (value >= low && value <= high) return {};
  return fail(ErrorCode::kUsage, fmt::format("{}: {} is outside {} ... {}{}", name, value, low, high, unit));
}

Result<void> checkTime(const std::optional<DecisionTime>& time) {
  if (!time) return {};
  const bool unlimited = time->decision == std::numeric_limits<double>::infinity();
  if (auto r = range("time per decision", unlimited ? 0.0 : time->decision, 0.0, kMaxDecision, " s"); !r)
    return r;
  if (auto r = range("bank of time", time->bank, 0.0, kMaxBank, " s"); !r) return r;
  if (auto r = range("time of a start", time->start, 0.0, kMaxStart, " s"); !r) return r;
  if (auto r = range("failures", time->failures, 1, kMaxFailures, ""); !r) return r;
  return range("late decisions in a row", time->held, 0, kMaxHeld, "");
}

Result<void> checkStart(const MatchConfig& config) {
  if (!config.start) return {};
  bool anyone = false;
  for (const TeamId team : kTeams) {
    const auto& robots = config.start->robots[indexOf(team)];
    for (std::size_t i = 0; i < robots.size(); ++i) {
      if (!robots[i]) continue;
      anyone = true;
      if (i >= static_cast<std::size_t>(config.rules.team_size)) {
        return fail(
            ErrorCode::kUsage,
            fmt::format(
                "start state: {} has a robot {}, but the rules '{}' have {} robots per team, counted from 0",
                nameOf(team), i, config.rules.name, config.rules.team_size));
      }
    }
  }
  if (!anyone) return fail(ErrorCode::kUsage, "start state: there is no robot");
  return {};
}

Result<void> checkScoreboard(const MatchConfig& config) {
  const Scoreboard& board = config.scoreboard;
  for (const TeamId team : kTeams) {
    if (auto r = range("score at the start", board.score[indexOf(team)], 0, kMaxScore, ""); !r) return r;
  }
  if (auto r = range("period at the start", board.period, 1, kLastPeriod, ""); !r) return r;
  return range("elapsed play time at the start", board.play_seconds, 0.0, config.rules.half_seconds, " s");
}

}  // namespace

Result<void> checkMatch(const MatchConfig& config) {
  for (const TeamId team : kTeams) {
    if (config.teams[indexOf(team)].info == nullptr) {
      return fail(ErrorCode::kUsage, fmt::format("the {} team is not chosen", nameOf(team)));
    }
  }
  if (auto r = range("team size of the rules", config.rules.team_size, 1, kMaxTeamSize, ""); !r) return r;
  for (const auto& checked : {validate(config.rules), validate(config.field), validate(config.robot.robot),
                              validate(config.robot.ball), validate(config.physics)}) {
    if (!checked) return checked;
  }
  if (auto r = checkField(config.rules, config.field, config.robot.ball); !r) return r;
  if (auto r = checkTime(config.decision_time); !r) return r;
  const PlacementError& error = config.placement_error;
  if (auto r = range("placement error", error.position, 0.0, kMaxPlacementError, " m"); !r) return r;
  if (auto r = range("placement error", error.heading, 0.0, kMaxHeadingError, " rad"); !r) return r;
  for (const VisionModel& vision : config.vision) {
    if (auto r = validate(vision); !r) return r;
  }
  if (auto r = checkScoreboard(config); !r) return r;
  return checkStart(config);
}

}  // namespace fulbito
