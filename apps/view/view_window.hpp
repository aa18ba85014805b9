#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "apps/view/viewer.hpp"

namespace fulbito {

/// How a window is opened and used.
struct WindowOptions {
  int width = 0;            ///< [px] 0: 900, or what fits on the display
  int height = 0;           ///< [px] 0: the field's height at that width
  std::int64_t frames = 0;  ///< exit after this many frames, or when nothing moves; 0: when the user quits
  std::string screenshot;   ///< PNG of the last frame; empty: none
  std::function<std::int64_t()> now;  ///< monotonic time [ns]
  std::function<bool()> interrupted;  ///< whether to exit; called about ten times per second
};

/// The largest side of a window [px].
inline constexpr int kLargestWindow = 8192;

/// A desktop window (SDL2).
class ViewWindow {
 public:
  /// Whether this build has a window.
  static bool available();
  /// Opens the window. Errors: kIo naming what is missing, such as a display.
  static Result<ViewWindow> create(const WindowOptions& options);
  ViewWindow(ViewWindow&&) noexcept;
  ViewWindow& operator=(ViewWindow&&) noexcept;
  ~ViewWindow();

  /// Shows the viewer until the user quits, the frames are drawn or `interrupted` returns true. Draws only
  /// when the picture changes, at most 60 times per second. Errors: kIo; as MatchPicture::create.
  Result<void> run(Viewer& viewer);
  /// Frames drawn so far.
  std::int64_t frames() const;

 private:
  struct Impl;
  explicit ViewWindow(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
