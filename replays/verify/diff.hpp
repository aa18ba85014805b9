#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fulbito/recording.hpp"

namespace fulbito {

/// One difference between two recipes.
struct RecipeDifference {
  std::string name;  ///< e.g. seed, teams.blue, physics: substeps
  std::string a, b;
};

/// One differing value of a body.
struct BodyDifference {
  std::size_t body = 0;  ///< index in the header
  std::string body_name;
  std::string field;  ///< command left, command right, x, y, heading, velocity x ...
  double a = 0.0, b = 0.0;
};

/// The first difference between two recordings.
struct RecordingDifference {
  std::vector<RecipeDifference> recipe;
  bool comparable = true;  ///< false: different bodies or control rates, so the ticks cannot be compared
  Tick ticks_a = 0, ticks_b = 0;
  /// The first differing tick; empty: both are identical, or one is a prefix of the other.
  std::optional<Tick> tick;
  std::int64_t play = 0;               ///< number of the play, from 0
  bool start = false;                  ///< true: the start of the play differs; false: a step differs
  std::vector<BodyDifference> bodies;  ///< at that tick: commands first, then states after the step

  bool same() const { return recipe.empty() && comparable && !tick && ticks_a == ticks_b; }
};

/// Compares two recordings tick by tick, then simulates both up to the first difference to compare all bits.
/// Errors: kBadInput.
Result<RecordingDifference> diff(const RecordingReader& a, const RecordingReader& b);

}  // namespace fulbito
