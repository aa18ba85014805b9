#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "match/drills/drill.hpp"
#include "python/environments/match/task.hpp"

namespace fulbito {

/// Which trials an environment draws. Those of `kTrain` have seeds from 2^63 on; `kTest` and the program,
/// with its default seed and any other below 2^63, never play them.
enum class DrillSplit : std::uint8_t { kTrain, kTest };

/// @{ The terms of the reward, in the order of the weights; docs/environments.md describes them.
inline constexpr std::array<std::string_view, 8> kDrillTerms{"success",  "failure", "time",   "ball",
                                                             "approach", "align",   "answer", "effort"};
enum class DrillTerm : std::uint8_t { kSuccess, kFailure, kTime, kBall, kApproach, kAlign, kAnswer, kEffort };
using DrillWeights = std::array<double, kDrillTerms.size()>;
inline constexpr DrillWeights kDrillWeights{10.0, 5.0, 0.5, 10.0, 4.0, 2.0, 1.0, 0.0};
/// @}

/// What an environment of a drill is made with.
struct DrillSettings {
  Drill drill;  ///< one that consists of trials
  /// kWheels, kTwist or kGoTo. Tasks that ask for a prediction have an action of their own instead: the
  /// predicted place of the ball, as shares of half the field's length and width.
  ActionForm actions = ActionForm::kWheels;
  DrillSplit split = DrillSplit::kTrain;
  int robot = -1;     ///< number of the agent's robot; -1: the drill's
  int ticks = 1;      ///< control ticks per step, 1 ... 60
  TeamChoice mates;   ///< plays the other own robots
  TeamChoice itself;  ///< plays where the drill asks for the tested team itself
  TeamCatalogue catalogue = TeamCatalogue::builtIn();  ///< teams that the drill may name as opponents
  std::string robot_model = "vsss";                    ///< preset or file
  std::string physics = "standard";                    ///< preset or file
  std::string navigator = kDefaultNavigator;           ///< plans the ways of `kGoTo`
  std::optional<VisionModel> sight;                    ///< instead of the drill's
  std::vector<ModelRange> ranges;                      ///< models of robots and ball that each episode draws
  DrillWeights weights = kDrillWeights;
};

/// The drill of that number among the built-in ones. Errors: kUsage with the numbers that there are.
Result<Drill> builtInDrill(int number);
/// The drill of that file. Errors: kIo, kBadInput as `parseDrill`.
Result<Drill> drillOfFile(const std::string& file);
/// Errors: kUsage if the drill has no trials (whole matches, repeats of other drills) or mixes predictions
/// with other tasks.
Result<void> checkHasTrials(const Drill& drill);

}  // namespace fulbito
