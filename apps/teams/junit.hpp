#pragma once

#include <string>

#include "match/check/team_check.hpp"

namespace fulbito::app {

/// The report as JUnit XML, which most build servers read: one test case per check; warnings pass.
std::string junitOf(const TeamReport& report);

}  // namespace fulbito::app
