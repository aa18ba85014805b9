#pragma once

#include <string>

#include "replays/render/colours/match_style.hpp"
#include "replays/render/match/match_plan.hpp"

namespace fulbito {

/// Draws the parts of the score board that never change: panel, names and marks.
void drawBoard(Canvas& canvas, const MatchPlan& plan, const MatchPictureSpec& spec, const MatchStyle& style);
/// Draws score, clock and period.
void drawBoardNumbers(Canvas& canvas, const MatchPlan& plan, const MatchPictureSpec& spec,
                      const ReplayMoment& moment, const MatchStyle& style);

/// @{ Draws the time bar at the bottom: its goals, and the progress of the recording.
void drawTimeBar(Canvas& canvas, const MatchPlan& plan, const MatchPictureSpec& spec,
                 const MatchStyle& style);
void drawTimeBarNow(Canvas& canvas, const MatchPlan& plan, const MatchPictureSpec& spec, double seconds,
                    const MatchStyle& style);
/// The time at column `x` [px] of the bar [s].
double secondsOnBar(const MatchPlan& plan, const MatchPictureSpec& spec, double x);
/// @}

}  // namespace fulbito
