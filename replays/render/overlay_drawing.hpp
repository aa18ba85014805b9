// Private header of replays/render: not installed.
#pragma once

#include "replays/render/field_view.hpp"
#include "replays/render/match_plan.hpp"
#include "replays/render/match_style.hpp"

namespace fulbito {

/// Trails of balls lie over those of robots.
void drawTrails(const FieldView& view, const MatchPictureSpec& spec, const std::vector<BodyTrail>& trails,
                const MatchStyle& style);
/// What the teams drew, in their colours.
void drawDrawings(const FieldView& view, const MatchPlan& plan, std::span<const RecordedDrawing> drawings,
                  const MatchStyle& style);
/// A plate over the upper part of the field.
void drawBanner(Canvas& canvas, const MatchPlan& plan, const MatchBanner& banner, const MatchStyle& style);

}  // namespace fulbito
