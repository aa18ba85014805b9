#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tournament/identity/identity.hpp"
#include "tournament/store/match_log.hpp"
#include "tournament/tune/tune_plan.hpp"

namespace fulbito {

/// The folder of a tuning: `tune.json` and `matches.jsonl`.
struct TuneFolder {
  std::unique_ptr<MatchLog> log;     ///< open for writing
  std::vector<std::string> changed;  ///< teams or engine that are not those of the last run

  /// Creates the folder, or continues it. Errors: kUsage naming the settings that differ, if it belongs to
  /// another tuning; kUsage if it holds a tournament; kIo; kBadInput; as `MatchLog::open`.
  /// @param identity  of `plan.base`
  static Result<TuneFolder> open(const std::string& path, const TunePlan& plan,
                                 const MatchIdentity& identity);
};

}  // namespace fulbito
