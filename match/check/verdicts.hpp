#pragma once

#include <vector>

#include "match/check/plays.hpp"
#include "match/check/repeats.hpp"
#include "match/check/team_check.hpp"
#include "match/drills/drill.hpp"

/// Turns findings into verdicts, one function per check.
namespace fulbito {

TeamCheck startVerdict(const PlayFindings& plays);
TeamCheck protocolVerdict(const PlayFindings& plays);
TeamCheck valuesVerdict(const PlayFindings& plays);
TeamCheck motorsVerdict(const PlayFindings& plays);
TeamCheck timeVerdict(const PlayFindings& plays);
TeamCheck determinismVerdict(const AllRepeats& repeats);
TeamCheck seatVerdict(const AllRepeats& repeats);
TeamCheck mirrorVerdict(const AllRepeats& repeats);
TeamCheck placementVerdict(const PlayFindings& plays);
TeamCheck drawingsVerdict(const PlayFindings& plays);
TeamCheck rolesVerdict(const PlayFindings& plays);
/// @param outside  the team runs in another process
TeamCheck containmentVerdict(const PlayFindings& plays, bool outside);
TeamCheck drillsVerdict(const std::vector<DrillReport>& reports);

}  // namespace fulbito
