#pragma once

#include <string>

#include "fulbito/detail/canvas.hpp"
#include "fulbito/picture.hpp"

namespace fulbito {

/// Draws the list of keys in the middle of the picture, for a live match or a recording.
void drawHelp(Canvas& canvas, PictureTheme theme, bool live);

/// Draws a short word on a coloured badge under the score.
void drawBadge(Canvas& canvas, const std::string& word);

/// Draws a small line at the lower right of the score board.
void drawHint(Canvas& canvas, PictureTheme theme, const std::string& hint);

/// Draws a status line at the bottom of the field. An empty note draws nothing.
void drawNote(Canvas& canvas, PictureTheme theme, const std::string& note);

}  // namespace fulbito
