#pragma once

#include <string>

#include "tournament/report/grid.hpp"
#include "tournament/report/report.hpp"

/// The parts of the HTML page. Each is a section, or empty where it has nothing to show.
namespace fulbito {

/// A section of the page. `classes` may be empty.
std::string htmlSection(const std::string& classes, const std::string& title, const std::string& content);

/// Content of a section that the reader may move sideways.
std::string htmlScroll(const std::string& label, const std::string& content);

/// A table. A cell with a share gets its colour; one about a match with a recording links to it. Rows beyond
/// `kMostHtmlRows` are counted in a note.
std::string htmlTable(const Grid& grid, const std::string& classes, const RecordingLinks& recordings);
inline constexpr std::size_t kMostHtmlRows = 500;

/// The address of a relative name: nothing in it leads to another host or scheme.
std::string relativeAddress(const std::string& name);

/// Verdict, bar of the log-likelihood ratio and figures of a tournament of format match.
std::string htmlMatch(const TournamentState& state);
/// Ratings with their intervals.
std::string htmlRatings(const TournamentState& state, const TournamentTable& table);
/// Ratings over time of the best teams.
std::string htmlCourse(const TournamentState& state, const TournamentTable& table);
/// A knock-out's ties, a column per round.
std::string htmlBracket(const TournamentState& state, const TournamentTable& table);

}  // namespace fulbito
