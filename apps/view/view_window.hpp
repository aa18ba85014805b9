// Private header of apps/view: not installed.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "apps/view/viewer.hpp"

namespace fulbito {

/// How a window is opened and used.
struct WindowOptions {
  int width = 0;            ///< [px] 0: 900, or what the display has room for
  int height = 0;           ///< [px] 0: as high as the field needs at that width
  std::int64_t frames = 0;  ///< ends after so many pictures, or when nothing moves; 0: when the user quits
  std::string screenshot;   ///< PNG of the last picture; empty: none
  std::function<std::int64_t()> now;  ///< monotonic time [ns]
  std::function<bool()> interrupted;  ///< whether to end; asked about ten times a second
};

/// The largest side of a window [px].
inline constexpr int kLargestWindow = 8192;

/// A window of the desktop, by way of SDL2.
class ViewWindow {
 public:
  /// Whether this program was built with it.
  static bool available();
  /// Proves that there is a display, before anything else is begun. Errors: kIo naming what is missing.
  static Result<ViewWindow> create(const WindowOptions& options);
  ViewWindow(ViewWindow&&) noexcept;
  ViewWindow& operator=(ViewWindow&&) noexcept;
  ~ViewWindow();

  /// Shows the viewer until the user quits, the frames are drawn or `interrupted` says so. A picture is drawn
  /// only when it changes, at most 60 times a second. Errors: kIo; as MatchPicture::create.
  Result<void> run(Viewer& viewer);
  /// Pictures drawn so far.
  std::int64_t frames() const;

 private:
  struct Impl;
  explicit ViewWindow(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
