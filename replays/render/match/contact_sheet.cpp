#include "fulbito/picture.hpp"
#include "replays/render/colours/match_style.hpp"

namespace fulbito {
namespace {

constexpr int kColumns = 4;
constexpr double kGap = 0.006;  // gap between pictures, as share of the sheet's width

}  // namespace

Result<Canvas> drawContactSheet(const ReplayTimeline& timeline, const MatchPictureSpec& spec,
                                const std::vector<double>& times, OverlayChoice overlays) {
  const int count = static_cast<int>(times.size()), columns = std::max(1, std::min(kColumns, count));
  const int gap = std::max(2, static_cast<int>(kGap * spec.width));
  MatchPictureSpec small = spec;
  small.width = (spec.width - gap * (columns + 1)) / columns;
  small.height = 0;
  auto picture = MatchPicture::create(small);
  if (!picture) return tl::unexpected<Error>(picture.error());
  auto cell = picture->canvas();
  if (!cell) return cell;
  const int rows = (count + columns - 1) / columns;
  auto sheet = Canvas::create(spec.width, rows * (cell->height() + gap) + gap, styleOf(spec.theme).rule);
  if (!sheet) return sheet;
  ReplayDirector director(timeline, overlays);
  ReplayMoment moment;
  MatchOverlays over;
  for (int i = 0; i < count; ++i) {
    timeline.at(times[static_cast<std::size_t>(i)], moment);
    director.direct(moment, over);
    picture->drawFrame(*cell, moment, over);
    sheet->place(*cell, gap + i % columns * (cell->width() + gap),
                 gap + i / columns * (cell->height() + gap));
  }
  return sheet;
}

}  // namespace fulbito
