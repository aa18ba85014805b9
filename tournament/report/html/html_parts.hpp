#pragma once

#include <string>

#include "tournament/report/grid.hpp"
#include "tournament/report/report.hpp"

/// Parts of the HTML report. Each is a section, or an empty string if there is nothing to show.
namespace fulbito {

/// A section of the page. `classes` may be empty.
std::string htmlSection(const std::string& classes, const std::string& title, const std::string& content);

/// Content of a section that scrolls sideways; `label` names it for screen readers.
std::string htmlScroll(const std::string& label, const std::string& content);

/// A table. A share colours its cell; a cell about a recorded match links to the recording. A note counts the
/// rows beyond `kMostHtmlRows`.
std::string htmlTable(const Grid& grid, const std::string& classes, const RecordingLinks& recordings);
inline constexpr std::size_t kMostHtmlRows = 500;

/// A relative name as URL: escaped so that no part of it leads to another host or scheme.
std::string relativeAddress(const std::string& name);

/// Verdict, bar of the log-likelihood ratio and figures of a tournament of format match.
std::string htmlMatch(const TournamentState& state);
/// Chart of the ratings with their intervals.
std::string htmlRatings(const TournamentState& state, const TournamentTable& table);
/// Chart of the ratings of the best teams over time.
std::string htmlCourse(const TournamentState& state, const TournamentTable& table);
/// The ties of a knock-out, one column per round.
std::string htmlBracket(const TournamentState& state, const TournamentTable& table);

}  // namespace fulbito
