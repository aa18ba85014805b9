#include "apps/view/view_screen.hpp"

#include "apps/view/help_drawing.hpp"

namespace fulbito {
namespace {

constexpr const char* kEdited = "edited";

}  // namespace

Result<void> ViewScreen::plan(const MatchPictureSpec& look, int width, int height, PictureTheme theme) {
  MatchPictureSpec spec = look;
  spec.width = width;
  spec.height = height;
  spec.theme = theme;
  auto picture = MatchPicture::create(spec);
  if (!picture) return tl::unexpected<Error>(picture.error());
  auto canvas = picture->canvas();
  if (!canvas) return tl::unexpected<Error>(canvas.error());
  picture_.emplace(std::move(*picture));
  canvas_.emplace(std::move(*canvas));
  return {};
}

Result<void> ViewScreen::draw(Viewer& viewer, int width, int height) {
  const ViewSettings& settings = viewer.settings();
  const bool same = picture_ && stage_ == viewer.current() && picture_->spec().width == width &&
                    picture_->spec().height == height && picture_->spec().theme == settings.theme;
  if (!same) {
    if (auto planned = plan(viewer.stage().look(), width, height, settings.theme); !planned) return planned;
    stage_ = viewer.current();
  }
  viewer.show(moment_, overlays_);
  picture_->drawFrame(*canvas_, moment_, overlays_);
  drawHint(*canvas_, settings.theme, viewer.hint());
  drawNote(*canvas_, settings.theme, viewer.note());
  if (viewer.stage().edited()) drawBadge(*canvas_, kEdited);
  if (settings.help) drawHelp(*canvas_, settings.theme, viewer.stage().live());
  return {};
}

Result<void> ViewScreen::save(const Viewer& viewer, const std::string& file) const {
  if (!picture_) return fail(ErrorCode::kIo, "there is no picture to save yet");
  auto canvas = picture_->canvas();
  if (!canvas) return tl::unexpected<Error>(canvas.error());
  picture_->drawFrame(*canvas, moment_, overlays_);
  if (viewer.stage().edited()) drawBadge(*canvas, kEdited);
  return canvas->writePng(file);
}

void ViewScreen::aim(PointerEvent& event, Vec2 pixel) const {
  if (!picture_) return;
  event.place = picture_->toField(pixel);
  event.on_bar = picture_->onTimeBar(pixel);
  event.bar_seconds = picture_->toSeconds(pixel.x);
}

}  // namespace fulbito
