#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tournament/report/report.hpp"
#include "tournament/runner/runner.hpp"

namespace fulbito::app {

/// The recordings that a tournament makes.
enum class KeptRecordings : std::uint8_t {
  kNone,
  kUpsets,  ///< notable matches of its reports: upsets, worst losses, failed teams
  kAll
};

/// The value with this name. Errors: kUsage.
Result<KeptRecordings> keptOf(const std::string& name);

/// Records a match of a tournament to `folder`/ID.fbr. The file appears when the match has ended. Errors:
/// kIo.
Result<MatchWatch> recordingWatch(const std::string& folder, const MatchConfig& match, const MatchId& id);

/// Plays notable matches of a tournament again and records those without a recording in `folder`. A match
/// with another result than before is left out, with a note. Errors: of a match; kIo.
Result<void> recordNotable(const TournamentState& state, const std::vector<NotableMatch>& notable,
                           const std::string& folder);

/// Whether `folder` has recordings of all notable matches.
bool areRecorded(const std::vector<NotableMatch>& notable, const std::string& folder);

/// Writes pages with the viewer for notable matches that have recordings, into a folder beside the report.
/// @return names of the pages relative to the report, by match id as text. Errors: kIo.
Result<std::map<std::string, std::string>> writePages(const std::vector<NotableMatch>& notable,
                                                      const std::string& recordings,
                                                      const std::string& report);

}  // namespace fulbito::app
