#pragma once

#include <string>

#include "tournament/folder/log_folder.hpp"
#include "tournament/identity/identity.hpp"
#include "tournament/tune/tune_plan.hpp"

namespace fulbito {

/// Creates the folder of a tuning, or opens it to continue. Errors: kUsage naming the settings that differ if
/// the folder belongs to another tuning, or if it holds a tournament; kIo; kBadInput; as `MatchLog::open`.
/// @param identity  identity of the matches of `plan.base`
Result<LogFolder> openTuneFolder(const std::string& folder, const TunePlan& plan,
                                 const MatchIdentity& identity);

}  // namespace fulbito
