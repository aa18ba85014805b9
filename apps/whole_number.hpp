#pragma once

#include <string>

namespace fulbito::app {

/// What is wrong with an option's text that is to be a whole number from 0 on; empty: nothing.
std::string wholeNumberFlaw(const std::string& text);

}  // namespace fulbito::app
