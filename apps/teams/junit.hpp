#pragma once

#include <string>

#include "match/check/team_check.hpp"

namespace fulbito::app {

/// The report as JUnit XML, which most build servers can read. Each check is a test case; warnings pass.
std::string junitOf(const TeamReport& report);

}  // namespace fulbito::app
