#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fulbito/recording.hpp"

/// What a recipe says, in words for people: for pictures, the HTML page and tables.
namespace fulbito {

/// Another setting of a recipe; empty if it has none of that name.
std::string_view moreOf(const RecordingRecipe& recipe, std::string_view name);

/// Names of blue and yellow: the name that a team outside the program gives itself, else its specification.
/// Empty for a trial.
std::vector<std::string> teamNames(const RecordingRecipe& recipe);

/// What the teams or the robot saw instead of the true state, as pairs of name and text: "Vision" if it is
/// the same for all, else "Blue's vision" and "Yellow's vision". Empty if everybody saw the true state.
std::vector<std::pair<std::string, std::string>> visionWords(const RecordingRecipe& recipe);

}  // namespace fulbito
