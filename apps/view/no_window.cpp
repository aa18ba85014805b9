#include "apps/view/view_window.hpp"

namespace fulbito {

struct ViewWindow::Impl {};

ViewWindow::ViewWindow(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ViewWindow::ViewWindow(ViewWindow&&) noexcept = default;
ViewWindow& ViewWindow::operator=(ViewWindow&&) noexcept = default;
ViewWindow::~ViewWindow() = default;

bool ViewWindow::available() { return false; }

Result<ViewWindow> ViewWindow::create(const WindowOptions&) {
  return fail(ErrorCode::kIo,
              "this build of fulbito has no window (FULBITO_VIEW=OFF); fulbito replay export makes "
              "pictures and films of recordings");
}

Result<void> ViewWindow::run(Viewer&) { return fail(ErrorCode::kIo, "there is no window"); }

std::int64_t ViewWindow::frames() const { return 0; }

}  // namespace fulbito
