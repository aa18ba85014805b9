#pragma once

#include <map>
#include <string>

#include "tournament/report/table.hpp"

namespace fulbito {

/// Relative names of the pages or files with recordings, by `MatchId` as text.
using RecordingLinks = std::map<std::string, std::string>;

/// @{ Reports of a tournament so far. Equal states give equal bytes. No report contains times, folders or
/// machine names.
/// Tables for terminals, at most 100 columns wide.
std::string tournamentText(const TournamentState& state, const TournamentTable& table);
/// One JSON object (docs/results-format.md), with a line end. For format match: `matchReportJson`.
std::string tournamentJson(const TournamentState& state, const TournamentTable& table);
/// CSV: a heading, then one line per played match.
std::string tournamentCsv(const TournamentState& state);
/// Markdown for the summary of a CI job, below 1 MiB. A note counts what does not fit.
std::string tournamentMarkdown(const TournamentState& state, const TournamentTable& table);
/// JUnit XML: a suite per pairing, a test case per match. A crash or walk-over is an error; a failed
/// sequential test is a failure.
std::string tournamentJunit(const TournamentState& state, const TournamentTable& table,
                            const RecordingLinks& recordings = {});
/// Annotations of GitHub Actions, worst first, at most 10 lines. The last line counts the rest.
std::string tournamentAnnotations(const TournamentState& state, const TournamentTable& table);
/// One HTML page that needs no network and no scripts. It links notable matches to their recordings.
std::string tournamentHtml(const TournamentState& state, const TournamentTable& table,
                           const RecordingLinks& recordings = {});
/// @}

}  // namespace fulbito
