#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fulbito/recording.hpp"

/// Parts of a recipe in words for people, used in pictures, the HTML page and tables.
namespace fulbito {

/// The value of an additional setting of a recipe; empty if it has none with this name.
std::string_view moreOf(const RecordingRecipe& recipe, std::string_view name);

/// Names of blue and yellow: for a team outside the program the name it gives itself, else its specification.
/// Empty for a trial.
std::vector<std::string> teamNames(const RecordingRecipe& recipe);

/// Descriptions of the vision, as pairs of name and text: "Vision" if it is the same for all, else "Blue's
/// vision" and "Yellow's vision". Empty if everybody saw the true state.
std::vector<std::pair<std::string, std::string>> visionWords(const RecordingRecipe& recipe);

}  // namespace fulbito
