#pragma once

#include <optional>
#include <string>

#include "apps/view/viewer.hpp"
#include "fulbito/picture.hpp"

namespace fulbito {

/// The pictures of a viewer at one size, in memory.
class ViewScreen {
 public:
  /// Draws the viewer's picture. Lays it out again if size, theme or stage have changed.
  /// Errors: as MatchPicture::create.
  Result<void> draw(Viewer& viewer, int width, int height);
  /// The last picture; null before the first.
  const Canvas* canvas() const { return canvas_ ? &*canvas_ : nullptr; }
  /// Writes the last picture as PNG, without help and notes. Errors: kIo.
  Result<void> save(const Viewer& viewer, const std::string& file) const;
  /// Sets what a pointer event points at in the last picture.
  void aim(PointerEvent& event, Vec2 pixel) const;

 private:
  Result<void> plan(const MatchPictureSpec& look, int width, int height, PictureTheme theme);

  std::optional<MatchPicture> picture_;
  std::optional<Canvas> canvas_;
  std::size_t stage_ = 0;
  ReplayMoment moment_;
  MatchOverlays overlays_;
};

}  // namespace fulbito
