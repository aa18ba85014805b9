#pragma once

#include <string>
#include <vector>

#include "experiments/comparison.hpp"

namespace fulbito {

/// The default suite: the comparison of Jung & Lee (2015).
inline constexpr const char* kPaperSuite = "jung-lee-2015";

/// The opponents of the reproduction runs, as navigator specifications (docs/reproduction.md).
inline constexpr const char* kUntunedField = "univector:goal=bearing,k0=0,d_min=0.09,delta=0.10";
/// `fulbito compare --suite corner --tune tangent-field --speeds 1.0` (and 2.6: the same set wins) found this
/// one.
inline constexpr const char* kTunedField = "tangent-field:offset=0.0784,range=5.56,hysteresis=0.239";
inline constexpr const char* kWideField = "vector-field:offset=0.10,width=0.20,follower=classic";

/// The safest rings under the classic law at 1.0 m/s by their own runs, of two hundred training layouts each:
/// `fulbito compare --map --suite corner --laws classic --speeds 1.0 --headings goal --seed 1002018 ...`,
/// whole in scripts/reproduction.sh; the second of close-range.
inline constexpr const char* kSafestRing = "vector-field:goal=bearing,offset=0,width=0.25,follower=classic";
inline constexpr const char* kSafestCloseRing =
    "vector-field:goal=bearing,offset=0,width=0.40,follower=classic";

inline constexpr const char* kClassicBezier = "bezier:follower=classic";

/// Blocks of the suite: all methods from corner to corner at 0.6, 1.0 and 2.6 m/s with the opponents of R4-a
/// to R4-e, the close-range runs of R4-c and R4-f, and the named cases of Figs 1-8. Errors: kUsage.
Result<std::vector<Block>> paperBlocks(const ComparisonConfig& config);

/// Fills in `comparison.reproduction`: R4-a to R4-f beside the paper's figures.
void judgeReproduction(Comparison& comparison);

}  // namespace fulbito
