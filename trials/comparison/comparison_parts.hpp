#pragma once

#include <optional>
#include <string>

#include "fulbito/experiment.hpp"

namespace fulbito {

/// Loads robot and physics and checks ranges, without blocks. Errors: kUsage, kIo, kBadInput.
Result<Comparison> prepareComparison(const ComparisonConfig& config);

/// Index of the navigator with which the others are paired: `bezier` if present, else the first.
std::size_t referenceOf(const ComparisonBlock& block);

/// Where a method's runs are.
struct MethodPlace {
  std::size_t block;
  std::size_t navigator;
};
/// The runs of the specification `text` on a suite at a top speed [m/s].
std::optional<MethodPlace> findMethod(const Comparison& comparison, const std::string& suite, double speed,
                                      const std::string& text);

/// The robot of a block: the comparison's with its top speed set to the block's.
RobotPreset robotAt(const RobotPreset& robot, double speed);

/// The trial config of one trial of the comparison. Errors: of the layout's field.
Result<TrialConfig> trialConfig(const Comparison& comparison, const ComparisonBlock& block,
                                std::size_t navigator, std::uint64_t index);

}  // namespace fulbito
