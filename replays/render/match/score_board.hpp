#pragma once

#include <string>

#include "replays/render/colours/match_style.hpp"
#include "replays/render/match/match_plan.hpp"

namespace fulbito {

/// What of the score board never changes: its panel, names and marks.
void drawBoard(Canvas& canvas, const MatchPlan& plan, const MatchPictureSpec& spec, const MatchStyle& style);
/// Score, clock and period.
void drawBoardNumbers(Canvas& canvas, const MatchPlan& plan, const MatchPictureSpec& spec,
                      const ReplayMoment& moment, const MatchStyle& style);

/// @{ The bar of time at the foot: its goals, and how far it has come.
void drawTimeBar(Canvas& canvas, const MatchPlan& plan, const MatchPictureSpec& spec,
                 const MatchStyle& style);
void drawTimeBarNow(Canvas& canvas, const MatchPlan& plan, const MatchPictureSpec& spec, double seconds,
                    const MatchStyle& style);
/// The time [s] that stands at column `x` [px] of the bar.
double secondsOnBar(const MatchPlan& plan, const MatchPictureSpec& spec, double x);
/// @}

}  // namespace fulbito
