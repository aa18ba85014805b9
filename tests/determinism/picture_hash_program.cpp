// Draws small pictures of the golden recording and of a trial's layout, dark and light, with every kind of
// overlay. Prints the size of each and a hash over its pixels.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "fulbito/detail/state_hash.hpp"
#include "fulbito/picture.hpp"

namespace {

using namespace fulbito;

constexpr int kWidth = 480, kSheetWidth = 720;  // [px]
constexpr double kMoment = 3.37;                // [s] a time between two samples

// Returns the value, or ends the program if a file or font cannot be loaded.
template <typename T>
T get(Result<T> result) {
  if (result) return std::move(*result);
  std::fprintf(stderr, "picture_hash_program: %s\n", result.error().message.c_str());
  std::exit(1);
}

void print(const std::string& name, const Canvas& canvas) {
  StateHash hash;
  for (int y = 0; y < canvas.height(); ++y) {
    for (const std::uint32_t pixel : canvas.row(y)) hash.add(std::uint64_t{pixel});
  }
  std::printf("%-22s %4d x %4d %016" PRIx64 "\n", name.c_str(), canvas.width(), canvas.height(),
              hash.value());
}

Canvas frame(const MatchPictureSpec& spec, const ReplayMoment& moment, const MatchOverlays& overlays) {
  const MatchPicture picture = get(MatchPicture::create(spec));
  Canvas canvas = get(picture.canvas());
  picture.drawFrame(canvas, moment, overlays);
  return canvas;
}

/// Debug drawings, one of each kind.
std::vector<RecordedDrawing> drawings() {
  using Kind = RecordedDrawing::Kind;
  return {{0, TeamId::kBlue, Kind::kLine, {-0.3, 0.1}, {0.45, 0.33}, 0.0, ""},
          {0, TeamId::kBlue, Kind::kCircle, {0.45, 0.33}, {}, 0.05, ""},
          {0, TeamId::kYellow, Kind::kText, {0.2, -0.3}, {}, 0.0, "keeper"}};
}

void printMatch(const ReplayTimeline& timeline, PictureTheme theme, const std::string& suffix) {
  MatchPictureSpec spec = get(pictureSpecOf(timeline));
  spec.width = kWidth;
  spec.theme = theme;
  MatchOverlays overlays;
  const ReplayMoment moment = timeline.at(kMoment);
  ReplayDirector(timeline, {}).direct(moment, overlays);
  const std::vector<RecordedDrawing> drawn = drawings();
  overlays.drawings = drawn;
  print("frame" + suffix, frame(spec, moment, overlays));
  MatchOverlays ways;
  ways.trails = pathsBetween(timeline, 0.0, timeline.seconds());
  print("trails" + suffix, frame(spec, moment, ways));
  const auto ball = static_cast<std::size_t>(spec.bodies.size() - 1);
  print("heat map" + suffix, get(drawHeatMap(timeline, spec, {{ball}, "the ball", 0.0, timeline.seconds()})));
  spec.width = kSheetWidth;
  print("contact sheet" + suffix, get(drawContactSheet(timeline, spec, {0.5, 2.0, 4.0, 6.0, 9.9}, {})));
}

void printTrial() {
  FieldPicture picture;
  picture.title = "Past three balls";
  picture.pixels_per_metre = 200;
  picture.layout.start = {{-0.6, -0.4}, 0.7};
  picture.layout.goal = {0.6, 0.4};
  for (const Vec2 place : {Vec2{-0.3, -0.2}, Vec2{0.0, 0.1}, Vec2{0.3, 0.2}}) {
    picture.layout.obstacles.emplace_back().pose.position = place;
  }
  DrawnPath way{"bezier", "2.1 s", {}, {}, false}, lost{"straight", "collided", {}, {}, true};
  for (int i = 0; i <= 30; ++i) {
    const double s = i / 30.0, bulge = 0.6 * s * (1.0 - s);
    way.points.push_back({-0.6 + 1.2 * s, -0.4 + 0.8 * s + bulge});
    if (i < 8) lost.points.push_back({-0.6 + 1.2 * s, -0.4 + 0.8 * s});
  }
  way.footprints = {{way.points[10], 0.8}, {way.points[20], 0.4}};
  picture.paths = {way, lost};
  print("trial", get(drawFieldPicture(picture)));
}

}  // namespace

int main() {
  const RecordingReader recording = get(RecordingReader::open(FULBITO_GOLDEN_RECORDING));
  const ReplayTimeline timeline = get(ReplayTimeline::read(recording));
  printMatch(timeline, PictureTheme::kDark, "");
  printMatch(timeline, PictureTheme::kLight, " light");
  printTrial();
  return 0;
}
