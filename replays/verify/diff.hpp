#pragma once

#include <optional>
#include <string>
#include <vector>

#include "replays/recording_reader.hpp"

namespace fulbito {

/// One thing of the recipes that is not the same.
struct RecipeDifference {
  std::string name;  ///< e.g. seed, teams.blue, physics: substeps
  std::string a, b;
};

/// One number of one body that is not the same in both.
struct BodyDifference {
  std::size_t body = 0;  ///< of the header
  std::string body_name;
  std::string field;  ///< command left, command right, x, y, heading, velocity x ...
  double a = 0.0, b = 0.0;
};

/// Where two recordings part.
struct RecordingDifference {
  std::vector<RecipeDifference> recipe;
  bool comparable = true;  ///< false: other bodies or another tick, so that ticks cannot be compared
  Tick ticks_a = 0, ticks_b = 0;
  /// The first tick that differs; empty: one is the beginning of the other, or they are the same.
  std::optional<Tick> tick;
  std::int64_t play = 0;               ///< from 0
  bool start = false;                  ///< it is a play's start that differs, not a step
  std::vector<BodyDifference> bodies;  ///< at that tick, commands first, then states after the step

  bool same() const { return recipe.empty() && comparable && !tick && ticks_a == ticks_b; }
};

/// Compares two recordings tick by tick, then plays both again up to where they part, to the last bit.
/// Errors: kBadInput.
Result<RecordingDifference> diff(const RecordingReader& a, const RecordingReader& b);

}  // namespace fulbito
