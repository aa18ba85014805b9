#include "fulbito/recording.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "fulbito/picture.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/bind.hpp"
#include "python/bindings/errors.hpp"
#include "python/bindings/python_calls.hpp"
#include "replays/html/html_page.hpp"
#include "replays/html/recorded_scene.hpp"
#include "replays/verify/expand.hpp"
#include "replays/verify/resimulate.hpp"
#include "replays/verify/verify.hpp"

namespace fulbito::python {
namespace {

namespace nb = nanobind;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr Tick kTicksBetweenChecks = 256;

/// A recording, unpacked when it is first looked at.
class RecordingFile {
 public:
  explicit RecordingFile(RecordingReader reader)
      : reader_(std::make_shared<RecordingReader>(std::move(reader))) {}

  struct Unpacked {
    RecordingReader recording;
    ReplayTimeline timeline;
  };

  const RecordingReader& reader() const { return *reader_; }

  /// All its moments; those of a recipe are simulated again. Needs the GIL, and gives it up meanwhile.
  std::shared_ptr<const Unpacked> unpacked() {
    if (!unpacked_) {
      std::shared_ptr<const Unpacked> made;
      {
        const nb::gil_scoped_release for_the_work;
        auto whole = valueOf(expanded(*reader_));
        auto timeline = valueOf(ReplayTimeline::read(whole));
        made = std::make_shared<const Unpacked>(Unpacked{std::move(whole), std::move(timeline)});
      }
      unpacked_ = made;
    }
    return unpacked_;
  }

 private:
  std::shared_ptr<RecordingReader> reader_;
  std::shared_ptr<const Unpacked> unpacked_;
};

nb::dict headerOf(const RecordingFile& file) {
  const RecordingReader& reader = file.reader();
  const RecordingHeader& header = reader.header();
  nb::dict dict;
  dict["kind"] = header.kind == RecordingKind::kMatch ? "match" : "trial";
  dict["level"] = header.level == RecordingLevel::kFull ? "full" : "recipe";
  dict["heard"] = header.heard;
  dict["control_rate"] = header.control_rate;
  dict["sample_every"] = header.sample_every;
  nb::list bodies;
  for (std::size_t i = 0; i < header.bodies.size(); ++i) bodies.append(bodyName(header, i));
  dict["bodies"] = bodies;
  dict["robots"] = countOf(header, BodyKind::kRobot);
  dict["balls"] = countOf(header, BodyKind::kBall);
  dict["teams"] = header.recipe.teams;
  dict["seed"] = header.recipe.seed;
  dict["version"] = header.build.version;
  dict["ticks"] = reader.ticks();
  dict["finished"] = reader.finished();
  dict["origin"] = reader.origin();
  dict["bytes"] = reader.sizeInBytes();
  if (const auto& result = reader.result()) {
    dict["complete"] = result->complete;
    dict["score"] = nb::make_tuple(result->score[0], result->score[1]);
    dict["outcome"] = result->outcome;
    dict["final_hash"] = result->final_hash;
  }
  return dict;
}

nb::list eventsOf(RecordingFile& file) {
  const auto unpacked = file.unpacked();
  nb::list events;
  for (const RecordedEvent& event : unpacked->timeline.events()) {
    nb::dict dict;
    dict["tick"] = event.tick;
    dict["time_s"] = unpacked->timeline.secondsAt(event.tick);
    dict["period"] = static_cast<int>(event.period);
    dict["play_s"] = event.play_time;
    dict["event"] = event.clause;
    dict["law"] = event.law;
    if (event.team) dict["team"] = nameOf(*event.team);
    if (event.robot) dict["robot"] = static_cast<int>(*event.robot);
    dict["x"] = event.place.x;
    dict["y"] = event.place.y;
    dict["value"] = event.value;
    dict["threshold"] = event.threshold;
    dict["margin"] = event.margin;
    events.append(dict);
  }
  return events;
}

/// Poses at each sampled tick.
nb::dict samplesOf(RecordingFile& file) {
  const auto unpacked = file.unpacked();
  const ReplayTimeline& timeline = unpacked->timeline;
  const std::size_t rows = timeline.samples().size(), bodies = timeline.header().bodies.size();
  std::vector<std::int64_t> ticks(rows);
  std::vector<double> poses(rows * bodies * 3, kNan);
  std::vector<std::int32_t> score(rows * 2);
  std::vector<std::uint8_t> playing(rows);
  {
    const nb::gil_scoped_release for_the_work;
    ReplayMoment moment;
    for (std::size_t row = 0; row < rows; ++row) {
      ticks[row] = timeline.samples()[row].tick;
      timeline.at(timeline.secondsAt(ticks[row]), moment);
      playing[row] = moment.playing;
      for (std::size_t team = 0; team < 2; ++team) score[2 * row + team] = moment.score[team];
      for (std::size_t body = 0; body < bodies; ++body) {
        if (!moment.bodies[body]) continue;
        double* to = &poses[(row * bodies + body) * 3];
        const Pose2& pose = *moment.bodies[body];
        to[0] = pose.position.x, to[1] = pose.position.y, to[2] = pose.heading;
      }
    }
  }
  nb::dict dict;
  dict["ticks"] = arrayOf(std::move(ticks), {rows});
  dict["poses"] = arrayOf(std::move(poses), {rows, bodies, 3});
  dict["score"] = arrayOf(std::move(score), {rows, 2});
  dict["playing"] = arrayOf(std::move(playing), {rows});
  return dict;
}

/// Keeps the states of each tick of a resimulation.
class StateTable final : public ReplayVisitor {
 public:
  StateTable(std::size_t rows, std::size_t bodies, std::size_t robots)
      : bodies_(bodies),
        robots_(robots),
        ticks_(rows),
        pose_(rows * bodies * 3, kNan),
        velocity_(rows * bodies * 3, kNan),
        wheels_(rows * robots * 2, kNan),
        commands_(wheels_) {}

  bool ticked(const ReplayedTick& tick) override {
    if (row_ == ticks_.size()) return false;
    ticks_[row_] = tick.tick;
    std::size_t next = 0;
    for (std::size_t i = 0; i < tick.state->robots.size(); ++i, ++next) {
      const RobotState& robot = tick.state->robots[i];
      const std::size_t body = tick.bodies[next];
      keep(body, robot.pose, robot.velocity, robot.angular_velocity);
      put(wheels_, body, robot.wheels);
      if (i < tick.commands.size()) put(commands_, body, tick.commands[i]);
    }
    for (const BallState& ball : tick.state->balls)
      keep(tick.bodies[next++], {ball.position, kNan}, ball.velocity, kNan);
    for (const ObstacleState& obstacle : tick.state->obstacles)
      keep(tick.bodies[next++], obstacle.pose, obstacle.velocity, kNan);
    ++row_;
    if (row_ % kTicksBetweenChecks == 0) checkSignals();
    return true;
  }

  nb::dict arrays() {
    const std::size_t rows = ticks_.size();
    nb::dict dict;
    dict["ticks"] = arrayOf(std::move(ticks_), {rows});
    dict["pose"] = arrayOf(std::move(pose_), {rows, bodies_, 3});
    dict["velocity"] = arrayOf(std::move(velocity_), {rows, bodies_, 3});
    dict["wheels"] = arrayOf(std::move(wheels_), {rows, robots_, 2});
    dict["commands"] = arrayOf(std::move(commands_), {rows, robots_, 2});
    return dict;
  }

 private:
  void keep(std::size_t body, const Pose2& pose, Vec2 velocity, double turning) {
    const std::size_t at = (row_ * bodies_ + body) * 3;
    pose_[at] = pose.position.x, pose_[at + 1] = pose.position.y, pose_[at + 2] = pose.heading;
    velocity_[at] = velocity.x, velocity_[at + 1] = velocity.y, velocity_[at + 2] = turning;
  }
  void put(std::vector<double>& to, std::size_t body, WheelSpeeds speeds) {
    const std::size_t at = (row_ * robots_ + body) * 2;
    to[at] = speeds.left, to[at + 1] = speeds.right;
  }

  std::size_t bodies_, robots_, row_ = 0;
  std::vector<std::int64_t> ticks_;
  std::vector<double> pose_, velocity_, wheels_, commands_;
};

nb::dict statesOf(const RecordingFile& file) {
  const RecordingReader& reader = file.reader();
  const RecordingHeader& header = reader.header();
  StateTable table(static_cast<std::size_t>(reader.ticks()), header.bodies.size(),
                   static_cast<std::size_t>(countOf(header, BodyKind::kRobot)));
  {
    const nb::gil_scoped_release for_the_work;
    valueOf(resimulate(reader, table));
  }
  return table.arrays();
}

std::string htmlOf(RecordingFile& file) {
  const auto unpacked = file.unpacked();
  const nb::gil_scoped_release for_the_work;
  Page page;
  page.scenes.push_back(valueOf(recordedScene(unpacked->recording, unpacked->timeline)));
  const PageScene& scene = page.scenes.front();
  page.title = scene.teams.size() == 2 ? scene.teams[0] + " – " + scene.teams[1]
                                       : (scene.title.empty() ? "Trial" : scene.title);
  return valueOf(htmlPage(page));
}

nb::dict verifiedOf(const RecordingFile& file) {
  auto verified = [&] {
    const nb::gil_scoped_release for_the_work;
    return valueOf(verify(file.reader()));
  }();
  nb::dict dict;
  dict["ticks"] = verified.ticks;
  dict["plays"] = verified.plays;
  dict["seconds"] = verified.seconds;
  dict["heard"] = verified.heard;
  dict["finished"] = verified.finished;
  dict["same_build"] = verified.same_build;
  dict["final_hash"] = verified.final_hash;
  dict["difference"] = verified.divergence ? verified.divergence->text : "";
  return dict;
}

/// Draws moments of one recording. One thread at a time, which the GIL ensures.
class Film {
 public:
  Film(RecordingFile& file, int width, bool light, double trail_seconds, bool banner, bool drawings)
      : unpacked_(file.unpacked()),
        picture_(pictureOf(width, light)),
        canvas_(valueOf(picture_.canvas())),
        director_(unpacked_->timeline, {banner, drawings, trail_seconds}) {}

  nb::ndarray<nb::numpy, std::uint8_t> pixels(double seconds) {
    draw(seconds);
    const auto width = static_cast<std::size_t>(canvas_.width()),
               height = static_cast<std::size_t>(canvas_.height());
    std::vector<std::uint8_t> bytes(width * height * 3);
    std::uint8_t* to = bytes.data();
    for (int y = 0; y < canvas_.height(); ++y) {
      for (const std::uint32_t argb : canvas_.row(y)) {
        *to++ = static_cast<std::uint8_t>(argb >> 16);
        *to++ = static_cast<std::uint8_t>(argb >> 8);
        *to++ = static_cast<std::uint8_t>(argb);
      }
    }
    return arrayOf(std::move(bytes), {height, width, 3});
  }

  nb::bytes png(double seconds) {
    draw(seconds);
    const std::string bytes = canvas_.png(PngEffort::kSmall);
    return nb::bytes(bytes.data(), bytes.size());
  }

 private:
  MatchPicture pictureOf(int width, bool light) const {
    MatchPictureSpec spec = valueOf(pictureSpecOf(unpacked_->timeline));
    spec.width = width;
    spec.theme = light ? PictureTheme::kLight : PictureTheme::kDark;
    return valueOf(MatchPicture::create(spec));
  }
  void draw(double seconds) {
    if (!std::isfinite(seconds)) raise(ErrorCode::kUsage, "seconds is not a finite number");
    unpacked_->timeline.at(seconds, moment_);
    director_.direct(moment_, overlays_);
    picture_.drawFrame(canvas_, moment_, overlays_);
  }

  std::shared_ptr<const RecordingFile::Unpacked> unpacked_;
  MatchPicture picture_;
  Canvas canvas_;
  ReplayDirector director_;
  ReplayMoment moment_;
  MatchOverlays overlays_;
};

void bindFilm(nb::module_& m) {
  nb::class_<Film>(m, "Film", "Draws moments of a recording.")
      .def(nb::init<RecordingFile&, int, bool, double, bool, bool>(), nb::arg("file"), nb::arg("width"),
           nb::arg("light"), nb::arg("trail_seconds"), nb::arg("banner"), nb::arg("drawings"))
      .def("pixels", &Film::pixels, nb::arg("seconds"),
           nb::sig("def pixels(self, seconds: float) -> numpy.typing.NDArray[numpy.uint8]"),
           "RGB of a moment [s], (height, width, 3).")
      .def("png", &Film::png, nb::arg("seconds"), "A PNG file of a moment [s].");
}

}  // namespace

void bindRecording(nb::module_& m) {
  nb::class_<RecordingFile>(m, "RecordingFile", "A recording: see fulbito.Recording.")
      .def_static(
          "open",
          [](const std::string& file, bool salvage) {
            return RecordingFile(valueOf(RecordingReader::open(file, {salvage})));
          },
          nb::arg("file"), nb::arg("salvage"), "Opens a file.")
      .def_static(
          "parse",
          [](const nb::bytes& bytes, const std::string& origin, bool salvage) {
            return RecordingFile(
                valueOf(RecordingReader::parse({bytes.c_str(), bytes.size()}, origin, {salvage})));
          },
          nb::arg("bytes"), nb::arg("origin"), nb::arg("salvage"),
          "Opens bytes; `origin` is their name in errors.")
      .def(
          "bytes",
          [](const RecordingFile& file) {
            return nb::bytes(file.reader().bytes().data(), file.reader().bytes().size());
          },
          "The whole file.")
      .def("header", &headerOf, nb::sig("def header(self) -> dict[str, typing.Any]"),
           "What its header and end say.")
      .def("events", &eventsOf, nb::sig("def events(self) -> list[dict[str, typing.Any]]"), "All calls.")
      .def("samples", &samplesOf, nb::sig("def samples(self) -> dict[str, typing.Any]"),
           "Poses of sampled ticks.")
      .def("states", &statesOf, nb::sig("def states(self) -> dict[str, typing.Any]"),
           "Exact states of all ticks.")
      .def("html", &htmlOf, "The HTML viewer with the recording, as one page.")
      .def("verify", &verifiedOf, nb::sig("def verify(self) -> dict[str, typing.Any]"),
           "Simulates it again.");
  bindFilm(m);
}

}  // namespace fulbito::python
