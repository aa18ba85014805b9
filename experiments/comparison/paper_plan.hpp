#pragma once

#include <string>
#include <vector>

#include "fulbito/experiment.hpp"

namespace fulbito {

/// The default suite: the comparison of Jung & Lee (2015).
inline constexpr const char* kPaperSuite = "jung-lee-2015";

/// The opponents of the reproduction runs, as navigator specifications (docs/reproduction.md).
inline constexpr const char* kUntunedField = "univector:goal=bearing,k0=0,d_min=0.09,delta=0.10";
/// A result of the tuner on 40 layouts of another seed. It touches more often than the tuner's usual results
/// but is faster, so it is the hardest opponent in time (docs/reproduction.md).
inline constexpr const char* kTunedField = "tangent-field:offset=0.0784,range=5.56,hysteresis=0.239";
inline constexpr const char* kWideField = "vector-field:offset=0.10,width=0.20,follower=classic";

/// The rings with the least mean T/T* of their own runs (failures as 8) under the classic law at 1.0 m/s.
/// Each has two hundred training layouts: corner to corner, or at close range. Their gap to the Bezier method
/// had no part in the choice. The commands are in scripts/reproduction.sh.
inline constexpr const char* kTunedRing = "vector-field:goal=bearing,offset=0,width=0.25,follower=classic";
inline constexpr const char* kTunedCloseRing =
    "vector-field:goal=bearing,offset=0.02,width=0.30,follower=classic";

inline constexpr const char* kClassicBezier = "bezier:follower=classic";

/// Blocks of the suite: all methods from corner to corner at 0.6, 1.0 and 2.6 m/s with the opponents above,
/// the close-range runs against the wide and the tuned ring, and the cases of Figs 1-8. Errors: kUsage.
Result<std::vector<ComparisonBlock>> paperBlocks(const ComparisonConfig& config);

/// Fills in `comparison.reproduction`: the paper's claims, each with the paper's value and the measured one.
void judgeReproduction(Comparison& comparison);

}  // namespace fulbito
