#pragma once

#include <string>
#include <vector>

#include "tournament/formats/standings.hpp"
#include "tournament/runner/runner.hpp"
#include "tournament/statistics/elo.hpp"
#include "tournament/statistics/ratings.hpp"

namespace fulbito {

/// One team's results against one other, or from one kind of start.
struct MeetingSummary {
  int pairs = 0;
  int won = 0, drawn = 0, lost = 0;  ///< matches
  int goals_for = 0, goals_against = 0;
  Interval points_share;  ///< `shareInterval` over pairs
  EloEstimate elo;
};

/// How often each team had each outcome at its own fault, and the latest reason.
struct FaultSummary {
  std::array<int, 6> outcomes{};  ///< matches by MatchOutcome in which this team was at fault (or mercy lost)
  std::string last_failure;
};

/// A match that deserves a look.
struct NotableMatch {
  std::size_t fixture = 0, leg = 0;
  MatchId id;
  std::string why;  ///< "upset: classic (-210) beat libero (+210)", "lost 0:4 from free-ball:3"
};

/// Everything that reports show: computed once, the same for any order of play.
struct TournamentTable {
  std::vector<Standing> standings;
  std::vector<KnockOutTie> bracket;
  Ratings ratings;
  std::vector<std::vector<MeetingSummary>> cross;   ///< [row entrant][column entrant]
  std::vector<std::vector<MeetingSummary>> starts;  ///< [entrant][StartKind]
  std::vector<FaultSummary> faults;                 ///< by entrant
  std::vector<NotableMatch> notable;                ///< worst first, at most 20
  std::vector<std::vector<double>> course;  ///< [entrant][step]: Elo after each twentieth of the fixtures
};

/// Errors: of the plan.
Result<TournamentTable> tableOf(const TournamentState& state);

/// @{ Reports. Equal states give equal bytes; none tells times or paths.
std::string tournamentText(const TournamentState& state, const TournamentTable& table);
std::string tournamentJson(const TournamentState& state, const TournamentTable& table);
std::string tournamentCsv(const TournamentState& state);  ///< a line per match
std::string tournamentMarkdown(const TournamentState& state, const TournamentTable& table);  ///< < 1 MiB
std::string tournamentJunit(const TournamentState& state, const TournamentTable& table);
/// GitHub annotations, at most 10, worst first, and how many more there are.
std::string tournamentAnnotations(const TournamentState& state, const TournamentTable& table);
/// One offline HTML page. `recordings` links matches to recordings' pages, by MatchId text; relative names.
std::string tournamentHtml(const TournamentState& state, const TournamentTable& table,
                           const std::map<std::string, std::string>& recordings);
/// @}

}  // namespace fulbito
