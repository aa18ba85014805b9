#pragma once

#include <string>

#include "tournament/folder/log_folder.hpp"
#include "tournament/identity/identity.hpp"
#include "tournament/tune/tune_plan.hpp"

namespace fulbito {

/// Creates the folder of a tuning, or continues it. Errors: kUsage naming the settings that differ, if it
/// belongs to another tuning, or if it holds a tournament; kIo; kBadInput; as `MatchLog::open`.
/// @param identity  of `plan.base`
Result<LogFolder> openTuneFolder(const std::string& folder, const TunePlan& plan,
                                 const MatchIdentity& identity);

}  // namespace fulbito
