#include "replays/recording/call_words.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

namespace fulbito {
namespace {

/// How a call's measured value is shown.
struct Measure {
  std::string_view before;
  std::string_view unit;
  double scale = 1.0;  ///< factor from the value to `unit`
};

constexpr Measure kStood{"for ", "s"};
constexpr Measure kInside{"robots inside: ", ""};
constexpr Measure kPressed{"pressed with ", "N s"};
constexpr Measure kMoved{"moved by ", "mm", 1e3};
constexpr Measure kLead{"lead of ", "goals"};

/// The team that a call favours, relative to the team of its event.
enum class Gain : std::uint8_t { kNobody, kNamed, kOther };

/// The words for a clause. The title is empty if the call needs no banner.
struct Clause {
  std::string_view name, title, detail;
  Gain gain = Gain::kNobody;
  Measure measure = {};
};

constexpr std::array kClauses{
    Clause{"goal", "Goal!", "", Gain::kNamed, {"ball past the line by ", "mm", 1e3}},
    Clause{"kick-off", "", "", Gain::kNamed},
    Clause{"free-ball", "Free ball", "stuck ball", Gain::kNobody, kStood},
    Clause{"goal-kick.attackers", "Goal kick", "too many attackers in the area", Gain::kOther, kInside},
    Clause{"goal-kick.keeper-charged", "Goal kick", "keeper charged", Gain::kOther, kPressed},
    Clause{"goal-kick.stuck", "Goal kick", "ball stuck in the area", Gain::kOther, kStood},
    Clause{"penalty.defenders", "Penalty", "too many defenders in the area", Gain::kOther, kInside},
    Clause{"penalty.keeper-holds", "Penalty", "keeper held the ball", Gain::kOther, kStood},
    Clause{"penalty.holding", "Penalty", "ball held", Gain::kOther, kStood},
    Clause{"penalty.stuck", "Penalty", "ball stuck in the area", Gain::kOther, kStood},
    Clause{"free-kick.push", "Free kick", "pushing", Gain::kOther, kPressed},
    Clause{"free-kick.holding", "Free kick", "ball held", Gain::kOther, kStood},
    Clause{"half", "Half-time", ""},
    Clause{"full-time", "Full time", "", Gain::kNamed, kLead},
    Clause{"overtime", "Overtime", "", Gain::kNobody, {"part ", ""}},
    Clause{"shoot-out", "Shoot-out", "", Gain::kNamed},
    Clause{"false-start", "False start", "", Gain::kNobody, kMoved},
    Clause{"mercy", "Full time", "the lead is too large", Gain::kNamed, kLead},
    Clause{"walk-over", "Walk-over", "a team is absent", Gain::kOther},
    Clause{"match.abandoned", "Match abandoned", ""},
    Clause{"placement", "", "", Gain::kNobody, kMoved},
};

const Clause* clauseOf(const std::string& name) {
  const auto* const found = std::find_if(kClauses.begin(), kClauses.end(),
                                         [&](const Clause& clause) { return clause.name == name; });
  return found == kClauses.end() ? nullptr : found;
}

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

/// Details that depend on the event.
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
  const Clause* clause = clauseOf(event.clause);
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
  const Clause* clause = clauseOf(event.clause);
  // Other events are counts: a command was rejected for the first, tenth ... time.
  const Measure measure = clause != nullptr ? clause->measure : Measure{"count ", ""};
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
