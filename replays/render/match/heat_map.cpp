#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fulbito/detail/math.hpp"
#include "fulbito/picture.hpp"
#include "replays/render/canvas/axis.hpp"
#include "replays/render/canvas/text_fit.hpp"
#include "replays/render/colours/heat_colours.hpp"
#include "replays/render/colours/match_style.hpp"
#include "replays/render/field/field_drawing.hpp"
#include "replays/render/match/match_plan.hpp"
#include "replays/render/match/score_board.hpp"

namespace fulbito {
namespace {

constexpr double kCell = 0.01;    // [m]
constexpr double kSmooth = 2.5;   // [cells] standard deviation
constexpr double kFullAt = 0.97;  // share of the used cells that are darker than the brightest colour

/// Time spent at each place of the field [s/dm^2].
class HeatGrid {
 public:
  explicit HeatGrid(const FieldGeometry& field)
      : half_{field.length / 2 + (field.hasGoals() ? field.goal_depth : 0.0), field.width / 2},
        columns_(static_cast<int>(std::ceil(2 * half_.x / kCell))),
        rows_(static_cast<int>(std::ceil(2 * half_.y / kCell))),
        cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

  void add(Vec2 place, double seconds) {
    const int x = static_cast<int>(std::floor((place.x + half_.x) / kCell));
    const int y = static_cast<int>(std::floor((place.y + half_.y) / kCell));
    if (x >= 0 && y >= 0 && x < columns_ && y < rows_) at(x, y) += seconds / (kCell * kCell * 100.0);
  }

  void smooth() {
    blur(columns_, rows_, 1, columns_);
    blur(rows_, columns_, columns_, 1);
  }

  /// The density at a place, interpolated between cells.
  double density(Vec2 place) const {
    const double x = (place.x + half_.x) / kCell - 0.5, y = (place.y + half_.y) / kCell - 0.5;
    const double x0 = std::floor(x), y0 = std::floor(y), fx = x - x0, fy = y - y0;
    const int i = static_cast<int>(x0), j = static_cast<int>(y0);
    return (value(i, j) * (1 - fx) + value(i + 1, j) * fx) * (1 - fy) +
           (value(i, j + 1) * (1 - fx) + value(i + 1, j + 1) * fx) * fy;
  }

  /// A high quantile of the cells that are not empty, for the brightest colour; 0 if all are empty.
  double top() const {
    std::vector<double> used;
    std::copy_if(cells_.begin(), cells_.end(), std::back_inserter(used), [](double d) { return d > 1e-3; });
    if (used.empty()) return 0.0;
    const auto index = static_cast<std::ptrdiff_t>(kFullAt * static_cast<double>(used.size() - 1));
    std::nth_element(used.begin(), used.begin() + index, used.end());
    return used[static_cast<std::size_t>(index)];
  }

 private:
  double& at(int x, int y) {
    return cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(x)];
  }
  double value(int x, int y) const {
    x = std::clamp(x, 0, columns_ - 1), y = std::clamp(y, 0, rows_ - 1);
    return cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(x)];
  }

  /// Blurs `lines` lines of `length` cells. The cells of a line are `step` apart, the lines `stride` apart.
  /// Amounts that would spread beyond the walls stay inside.
  void blur(int length, int lines, int step, int stride) {
    const int reach = static_cast<int>(3 * kSmooth);
    std::vector<double> weights, line(static_cast<std::size_t>(length));
    for (int k = 0; k <= reach; ++k) weights.push_back(math::exp(-0.5 * k * k / (kSmooth * kSmooth)));
    double sum = -weights[0];
    for (const double w : weights) sum += 2 * w;
    for (int i = 0; i < lines; ++i) {
      double* first = cells_.data() + static_cast<std::ptrdiff_t>(i) * stride;
      for (int k = 0; k < length; ++k) line[static_cast<std::size_t>(k)] = first[std::ptrdiff_t{k} * step];
      for (int k = 0; k < length; ++k) {
        double total = 0.0;
        for (int d = -reach; d <= reach; ++d) {
          int from = k + d;
          if (from < 0) from = -from - 1;
          if (from >= length) from = 2 * length - 1 - from;
          total += weights[static_cast<std::size_t>(std::abs(d))] *
                   line[static_cast<std::size_t>(std::clamp(from, 0, length - 1))];
        }
        first[std::ptrdiff_t{k} * step] = total / sum;
      }
    }
  }

  Vec2 half_;
  int columns_, rows_;
  std::vector<double> cells_;
};

HeatGrid gridOf(const ReplayTimeline& timeline, const MatchPictureSpec& spec, const HeatMapChoice& choice) {
  HeatGrid grid(spec.field);
  const RecordingHeader& header = timeline.header();
  const double each = static_cast<double>(header.sample_every) / header.control_rate;
  ReplayMoment moment;
  for (const RecordedSample& sample : timeline.samples()) {
    const double seconds = timeline.secondsAt(sample.tick);
    if (seconds < choice.from || seconds > choice.to) continue;
    timeline.at(seconds, moment);
    if (!moment.playing) continue;
    const double turn = moment.blue_side == Side::kLeft ? 1.0 : -1.0;
    for (const std::size_t body : choice.bodies) {
      if (moment.bodies[body]) grid.add(moment.bodies[body]->position * turn, each);
    }
  }
  grid.smooth();
  return grid;
}

void paint(const FieldView& view, const FieldGeometry& field, const HeatGrid& grid, double top,
           const std::array<Colour, 256>& colours) {
  for (int y = 0; y < view.canvas.height(); ++y) {
    for (int x = 0; x < view.canvas.width(); ++x) {
      const Vec2 place{(x + 0.5 - view.centre.x) / view.pixels_per_metre,
                       (view.centre.y - y - 0.5) / view.pixels_per_metre};
      if (!insideField(field, place)) continue;
      const double share = std::clamp(grid.density(place) / top, 0.0, 1.0);
      view.canvas.fillPixel(x, y, colours[static_cast<std::size_t>(share * 255.0)]);
    }
  }
}

void drawHeatLegend(Canvas& canvas, const MatchPlan& plan, const Axis& axis, const std::string& text,
                    const std::array<Colour, 256>& colours, const MatchStyle& style) {
  const double u = plan.unit, size = plan.text(13), width = 0.3 * plan.width, height = std::max(8.0, 11 * u);
  const double y = std::round(plan.height - plan.foot / 2 - height / 2),
               baseline = std::round(y + height / 2 + 0.36 * size);
  const std::string most = fmt::format("{}+ s/dm\u00b2", axis.text(axis.high));
  const TextStyle plain{size, style.dim_text, TextAlign::kLeft, false};
  const double right = plan.width - plan.margin - canvas.labelWidth(most, plain),
               left = std::round(right - 8 * u - width);
  for (int x = 0; x < static_cast<int>(width); ++x) {
    const auto index = static_cast<std::size_t>(255.0 * x / width);
    canvas.fillRectangle({left + x, y}, 1.0, height, colours[index]);
  }
  canvas.label({right, baseline}, most, plain);
  const std::string none = "0";
  const double none_width = canvas.labelWidth(none, plain);
  canvas.label({left - 8 * u - none_width, baseline}, none, plain);
  const double room = left - 24 * u - none_width - plan.margin;
  canvas.label({std::round(plan.margin), baseline}, fitted(canvas, text, size, room),
               {size, style.text, TextAlign::kLeft, false});
}

std::string legendText(const HeatMapChoice& choice) {
  const auto clock = [](double seconds) {
    return fmt::format("{}:{:02}", static_cast<int>(seconds) / 60, static_cast<int>(seconds) % 60);
  };
  return fmt::format("positions of {}, {}\u2013{}; blue attacks to the right", choice.label,
                     clock(choice.from), clock(choice.to));
}

}  // namespace

Result<Canvas> drawHeatMap(const ReplayTimeline& timeline, const MatchPictureSpec& wanted,
                           const HeatMapChoice& choice) {
  MatchPictureSpec spec = wanted;
  spec.seconds = std::max(spec.seconds, 1.0);  // the legend takes the place of the time bar
  auto picture = MatchPicture::create(spec);
  if (!picture) return tl::unexpected<Error>(picture.error());
  spec = picture->spec();
  const MatchPlan plan = planOf(spec);
  const MatchStyle& style = styleOf(spec.theme);
  auto canvas = Canvas::create(spec.width, spec.height, style.page);
  if (!canvas) return canvas;
  FieldColours colours = style.field;
  const std::array<Colour, 256> heat = heatColours(spec.theme);
  colours.left_goal = colours.right_goal = colours.floor = heat[0];
  const HeatGrid grid = gridOf(timeline, spec, choice);
  const Axis axis = niceAxis(0.0, std::max(grid.top(), 1e-3));
  const FieldView view = plan.view(*canvas);
  drawFloorAndWalls(view, spec.field, colours);
  paint(view, spec.field, grid, axis.high, heat);
  if (isPitch(spec.field)) drawFieldLines(view, spec.field, colours);
  drawBoard(*canvas, plan, spec, style);
  drawBoardNumbers(*canvas, plan, spec, timeline.at(choice.to), style);
  drawHeatLegend(*canvas, plan, axis, legendText(choice), heat, style);
  return canvas;
}

}  // namespace fulbito
