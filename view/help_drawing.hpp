// Private header of view: not installed.
#pragma once

#include "replays/render/canvas.hpp"
#include "replays/render/match_picture.hpp"

namespace fulbito {

/// The keys on a plate in the middle of the picture: those of a live match or of a recording.
void drawHelp(Canvas& canvas, PictureTheme theme, bool live);

/// A word on a plate at the top of the score board, for what must not be overlooked.
void drawBadge(Canvas& canvas, const std::string& word);

}  // namespace fulbito
