// Private header of apps/view: not installed.
#pragma once

#include <string>

#include "replays/render/canvas/canvas.hpp"
#include "replays/render/match/match_picture.hpp"

namespace fulbito {

/// The keys on a plate in the middle of the picture: those of a live match or of a recording.
void drawHelp(Canvas& canvas, PictureTheme theme, bool live);

/// A word on a plate under the score, for what must not be overlooked.
void drawBadge(Canvas& canvas, const std::string& word);

/// A small line at the right end of the score board's foot.
void drawHint(Canvas& canvas, PictureTheme theme, const std::string& hint);

/// A line on a plate at the foot of the field: how play stands, or what was done. Nothing for an empty one.
void drawNote(Canvas& canvas, PictureTheme theme, const std::string& note);

}  // namespace fulbito
