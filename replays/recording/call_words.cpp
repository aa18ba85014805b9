#include "replays/recording/call_words.hpp"

#include <string_view>

#include <fmt/format.h>

#include "referee/rules/clauses.hpp"

namespace fulbito {
namespace {

using clause::Clause;
using clause::Gain;
using clause::Measure;

std::string teamName(TeamId team, const std::vector<std::string>& teams) {
  const std::size_t index = indexOf(team);
  return index < teams.size() ? teams[index] : std::string(nameOf(team));
}

std::string_view titleOf(RestartKind kind) {
  switch (kind) {
    case RestartKind::kKickOff:
      return "Kick-off";
    case RestartKind::kFreeBall:
      return "Free ball";
    case RestartKind::kFreeKick:
      return "Free kick";
    case RestartKind::kPenalty:
      return "Penalty";
    case RestartKind::kGoalKick:
      return "Goal kick";
    case RestartKind::kGiven:
      break;
  }
  return "";
}

/// The second part of the words of an event: its details.
std::string detailOf(const RecordedEvent& event, const Clause& clause,
                     const std::vector<std::string>& teams) {
  if (clause.name == "full-time" && !event.team) return "draw";
  if (!event.team) return std::string(clause.detail);
  std::string name = teamName(*event.team, teams);
  if (clause.name == "goal") return name;
  if (clause.name == "false-start") return name + " moved before the signal";
  if (clause.name == "full-time") return name + " wins";
  if (clause.name == "shoot-out") return name + (event.value > 0.0 ? " scores" : " misses");
  return std::string(clause.detail);
}

std::optional<TeamId> favouredBy(const RecordedEvent& event, Gain gain) {
  if (!event.team || gain == Gain::kNobody) return std::nullopt;
  return gain == Gain::kNamed ? *event.team : other(*event.team);
}

}  // namespace

CallWords wordsOf(const RecordedEvent& event, const std::vector<std::string>& teams) {
  const Clause* clause = clause::find(event.clause);
  if (clause == nullptr) return {};
  return {std::string(clause->title), detailOf(event, *clause, teams), favouredBy(event, clause->gain)};
}

CallWords wordsOf(RestartKind kind, TeamId team, const std::vector<std::string>& teams) {
  CallWords words{std::string(titleOf(kind)), "", {}};
  // A free ball favours neither team.
  if (kind == RestartKind::kFreeBall || words.title.empty()) return words;
  words.detail = teamName(team, teams);
  words.favours = team;
  return words;
}

std::string measuredText(const RecordedEvent& event) {
  const Clause* clause = clause::find(event.clause);
  // Events without a clause are counts, such as the first, tenth ... rejected command. In heard matches they
  // are frames, and quadrants of free balls.
  const Measure other{event.clause == "vision.lost"          ? "frames "
                      : event.clause.starts_with("referee.") ? "quadrant "
                                                             : "count ",
                      ""};
  const Measure measure = clause != nullptr ? clause->measure : other;
  const bool nothing = event.value == 0.0 && event.threshold == 0.0;
  if (measure.before.empty() || nothing) return {};
  const auto told = [&measure](double value) {
    return fmt::format("{:.3g}{}{}", measure.scale * value, measure.unit.empty() ? "" : " ", measure.unit);
  };
  std::string text = fmt::format("{}{}", measure.before, told(event.value));
  if (event.threshold != 0.0) text += fmt::format(" (limit {})", told(event.threshold));
  return text;
}

}  // namespace fulbito
