#include <algorithm>

#include <fmt/format.h>

#include "tournament/report/match_report.hpp"
#include "tournament/report/report.hpp"
#include "tournament/report/sections.hpp"
#include "tournament/report/shown_text.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kMostAnnotations = 10;
constexpr int kMessageColumns = 300;

/// One annotation. Sorted by severity, then by decreasing number of matches.
struct Annotation {
  bool error = true;
  int severity = 0;  // 0 is the worst
  int matches = 0;
  std::string title, message;
};

/// Text escaped for a workflow command: `%`, line ends and, in the title, separators.
std::string escapedCommand(std::string_view text, bool title) {
  std::string out;
  for (const char c : text) {
    if (c == '%' || c == '\r' || c == '\n' || (title && (c == ':' || c == ','))) {
      out += fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    } else {
      out += c;
    }
  }
  return out;
}

std::string lineOf(const Annotation& a) {
  return fmt::format("::{} title={}::{}\n", a.error ? "error" : "warning", escapedCommand(a.title, true),
                     escapedCommand(a.message, false));
}

void annotateTest(const TournamentState& state, std::vector<Annotation>& list) {
  if (!state.sprt || state.sprt->verdict() == SprtVerdict::kPass) return;
  const bool failed = state.sprt->verdict() == SprtVerdict::kFail;
  if (!failed && !state.finished()) return;
  const MatchFigures figures = matchFigures(state);
  std::string message;
  for (const auto& [label, value] : matchLines(state, figures)) {
    message += fmt::format("{}{}: {}", message.empty() ? "" : "\n", label, value);
  }
  list.push_back({failed, failed ? 0 : 3, 0, matchTitle(state, figures), message});
}

void annotateTeam(const TournamentState& state, const TournamentTable& table, std::size_t entrant,
                  std::vector<Annotation>& list) {
  struct Kind {
    const char* did;
    int severity;
    MatchOutcome outcome;
  };
  constexpr Kind kKinds[] = {{"forfeited", 1, MatchOutcome::kForfeit},
                             {"crashed in", 2, MatchOutcome::kCrash},
                             {"gave illegal commands in", 4, MatchOutcome::kIllegal},
                             {"was late in", 5, MatchOutcome::kSlow}};
  const FaultSummary& faults = table.faults[entrant];
  for (const Kind& kind : kKinds) {
    const int matches = faults.of(kind.outcome);
    if (matches == 0) continue;
    const bool failure = kind.severity <= 2;
    list.push_back({failure, kind.severity, matches,
                    fmt::format("{} {} {} match{}", shownName(state, entrant), kind.did, matches,
                                matches == 1 ? "" : "es"),
                    failure && !faults.last_failure.empty()
                        ? "last: " + shownText(faults.last_failure, kMessageColumns)
                        : fmt::format("of {} matches", 2 * table.totals[entrant].pairs)});
  }
}

}  // namespace

std::string tournamentAnnotations(const TournamentState& state, const TournamentTable& table) {
  std::vector<Annotation> list;
  annotateTest(state, list);
  for (std::size_t i = 0; i < table.faults.size(); ++i) annotateTeam(state, table, i, list);
  std::stable_sort(list.begin(), list.end(), [](const Annotation& x, const Annotation& y) {
    return std::pair(x.severity, -x.matches) < std::pair(y.severity, -y.matches);
  });
  const bool all = list.size() <= kMostAnnotations;
  const std::size_t shown = all ? list.size() : kMostAnnotations - 1;
  std::string text;
  for (std::size_t i = 0; i < shown; ++i) text += lineOf(list[i]);
  if (!all) {
    text += lineOf({list[shown].error, 0, 0, fmt::format("{} more findings", list.size() - shown),
                    "The report of the tournament has them all."});
  }
  return text;
}

}  // namespace fulbito
