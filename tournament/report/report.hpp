#pragma once

#include <map>
#include <string>

#include "tournament/report/table.hpp"

namespace fulbito {

/// Pages or files of recordings by the text of a `MatchId`: relative names.
using RecordingLinks = std::map<std::string, std::string>;

/// @{ Reports of a tournament so far. Equal states give equal bytes. None tells times, folders or machines.
/// A table for terminals, at most 100 columns wide.
std::string tournamentText(const TournamentState& state, const TournamentTable& table);
/// One JSON object (docs/results-format.md), with a line end; of format match: `matchReportJson`.
std::string tournamentJson(const TournamentState& state, const TournamentTable& table);
/// A line per match that was played, with a heading.
std::string tournamentCsv(const TournamentState& state);
/// For the summary of a CI job: below 1 MiB. Long tables end with a note.
std::string tournamentMarkdown(const TournamentState& state, const TournamentTable& table);
/// JUnit XML: a suite per pairing, a test case per match. A crash or walk-over is an error, a failed test of
/// format match a failure.
std::string tournamentJunit(const TournamentState& state, const TournamentTable& table,
                            const RecordingLinks& recordings = {});
/// Annotations of GitHub Actions, worst first: at most 10 lines. The last one tells how many more there are.
std::string tournamentAnnotations(const TournamentState& state, const TournamentTable& table);
/// One HTML page that needs no network and no scripts. It links notable matches to their recordings.
std::string tournamentHtml(const TournamentState& state, const TournamentTable& table,
                           const RecordingLinks& recordings = {});
/// @}

}  // namespace fulbito
