#pragma once

#include <optional>
#include <string>

#include "fulbito/experiment.hpp"

namespace fulbito {

/// Loads robot and physics and checks ranges; the blocks stay empty. Errors: kUsage, kIo, kBadInput.
Result<Comparison> prepareComparison(const ComparisonConfig& config);

/// Index of the navigator with which the others are compared in pairs: `bezier` if present, else the first.
std::size_t referenceOf(const ComparisonBlock& block);

/// Where the runs of a method are in a comparison.
struct MethodPlace {
  std::size_t block;
  std::size_t navigator;
};
/// Finds the runs of the navigator specification `text` on a suite at a top speed [m/s].
std::optional<MethodPlace> findMethod(const Comparison& comparison, const std::string& suite, double speed,
                                      const std::string& text);

/// The robot of a block: the comparison's with its top speed set to the block's.
RobotPreset robotAt(const RobotPreset& robot, double speed);

/// The config of one trial of the comparison. Errors: those of the layout's field.
Result<TrialConfig> trialConfig(const Comparison& comparison, const ComparisonBlock& block,
                                std::size_t navigator, std::uint64_t index);

}  // namespace fulbito
