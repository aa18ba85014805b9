#include "replays/html/scene_columns.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "replays/coding/columns.hpp"

namespace fulbito {
namespace {

constexpr double kMostSteps = 1e9;

/// `value / step` as a whole number; NaN counts as 0.
std::int64_t stepsOf(double value, double step) {
  if (std::isnan(value)) return 0;
  return static_cast<std::int64_t>(std::floor(std::clamp(value / step, -kMostSteps, kMostSteps) + 0.5));
}

/// Writes one column.
class Column {
 public:
  explicit Column(ByteWriter& out) : out_(out) {}
  /// @param jump  the value does not continue the ones before it, so no trend is used
  void add(std::int64_t value, bool jump = true) {
    const Trend trend = jump ? Trend::kStays : Trend::kGoesOn;
    out_.signedVarint(value - predictor_.predicted(trend));
    predictor_.learn(value, trend);
  }

 private:
  ByteWriter& out_;
  ColumnPredictor predictor_;
};

/// The rows of a scene, each with its play.
class Rows {
 public:
  explicit Rows(const PageScene& scene) : scene_(scene) {}

  /// Calls `each(row, play, is first row of its play)` in order.
  template <typename Each>
  void visit(const Each& each) const {
    std::size_t play = 0;
    for (std::size_t r = 0; r < scene_.rows.size(); ++r) {
      while (play + 1 < scene_.plays.size() && scene_.plays[play + 1].row <= r) ++play;
      each(scene_.rows[r], scene_.plays[play], scene_.plays[play].row == r);
    }
  }

 private:
  const PageScene& scene_;
};

void packTicks(const Rows& rows, ByteWriter& out) {
  Column column(out);
  rows.visit([&](const PageRow& row, const PagePlay&, bool first) { column.add(row.tick, first); });
}

void packPlace(const Rows& rows, std::size_t body, double Vec2::* part, ByteWriter& out) {
  Column column(out);
  std::int64_t last = 0;
  rows.visit([&](const PageRow& row, const PagePlay& play, bool first) {
    if (play.present[body] != 0) last = stepsOf(row.poses[body].position.*part, kPagePlaceStep);
    column.add(last, first);
  });
}

/// Headings are unwrapped beyond a full turn, so that they have no jumps within a play.
void packHeading(const Rows& rows, std::size_t body, ByteWriter& out) {
  Column column(out);
  double heading = 0.0;
  rows.visit([&](const PageRow& row, const PagePlay& play, bool first) {
    if (play.present[body] != 0) {
      const double now = row.poses[body].heading;
      heading = first ? math::wrapAngle(now) : heading + math::wrapAngle(now - heading);
    }
    column.add(stepsOf(heading, kPageHeadingStep), first);
  });
}

void packCommands(const PageScene& scene, ByteWriter& out) {
  const auto robots = static_cast<std::size_t>(
      std::count_if(scene.bodies.begin(), scene.bodies.end(),
                    [](const PageBody& body) { return body.kind == BodyKind::kRobot; }));
  if (scene.commands.values.empty()) return;
  for (std::size_t robot = 0; robot < robots; ++robot) {
    for (double WheelSpeeds::* wheel : {&WheelSpeeds::left, &WheelSpeeds::right}) {
      Column column(out);
      for (std::size_t i = robot; i < scene.commands.values.size(); i += robots) {
        column.add(stepsOf(scene.commands.values[i].*wheel, kPageCommandStep));
      }
    }
  }
}

/// Packs all values of the drawings except the texts, which are in the page's JSON.
void packDrawings(const std::vector<RecordedDrawing>& drawings, ByteWriter& out) {
  const auto column = [&](const auto& value) {
    Column written(out);
    for (const RecordedDrawing& drawing : drawings) written.add(value(drawing));
  };
  using D = RecordedDrawing;
  column([](const D& d) { return d.tick; });
  column([](const D& d) { return 2 * static_cast<int>(d.kind) + static_cast<int>(indexOf(d.team)); });
  column([](const D& d) { return stepsOf(d.from.x, kDrawingStep); });
  column([](const D& d) { return stepsOf(d.from.y, kDrawingStep); });
  column([](const D& d) { return stepsOf(d.to.x, kDrawingStep); });
  column([](const D& d) { return stepsOf(d.to.y, kDrawingStep); });
  column([](const D& d) { return stepsOf(d.radius, kDrawingStep); });
}

}  // namespace

bool hasHeading(const PageBody& body) { return body.kind == BodyKind::kRobot || body.box; }

std::string packedColumns(const PageScene& scene) {
  std::string bytes;
  ByteWriter out(bytes);
  const Rows rows(scene);
  packTicks(rows, out);
  for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
    packPlace(rows, body, &Vec2::x, out);
    packPlace(rows, body, &Vec2::y, out);
    if (hasHeading(scene.bodies[body])) packHeading(rows, body, out);
  }
  packCommands(scene, out);
  packDrawings(scene.drawings, out);
  return bytes;
}

}  // namespace fulbito
