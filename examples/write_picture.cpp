// Draws one moment of a recording: write_picture FILE SECONDS PICTURE.png
#include <cstdio>
#include <cstdlib>
#include <fulbito/picture.hpp>

namespace {
int complain(const fulbito::Error& error) { return std::fprintf(stderr, "%s\n", error.message.c_str()), 3; }
}  // namespace

int main(int count, char** arguments) {
  if (count != 4) return std::fprintf(stderr, "Usage: write_picture FILE SECONDS PICTURE.png\n"), 2;
  const auto recording = fulbito::RecordingReader::open(arguments[1]);
  if (!recording) return complain(recording.error());
  const auto timeline = fulbito::ReplayTimeline::read(*recording);
  if (!timeline) return complain(timeline.error());
  const auto spec = fulbito::pictureSpecOf(*timeline);
  if (!spec) return complain(spec.error());
  const auto picture = fulbito::MatchPicture::create(*spec);
  if (!picture) return complain(picture.error());
  auto canvas = picture->canvas();
  if (!canvas) return complain(canvas.error());

  const fulbito::ReplayMoment moment = timeline->at(std::atof(arguments[2]));
  fulbito::MatchOverlays overlays;
  fulbito::ReplayDirector director(*timeline, fulbito::OverlayChoice{});
  director.direct(moment, overlays);
  picture->drawFrame(*canvas, moment, overlays);
  if (const auto written = canvas->writePng(arguments[3]); !written) return complain(written.error());
  std::printf("%s: %d x %d pixels\n", arguments[3], canvas->width(), canvas->height());
}
