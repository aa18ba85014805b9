#include <array>
#include <chrono>
#include <limits>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <optional>

#include "fulbito/match.hpp"
#include "fulbito/recorder.hpp"
#include "fulbito/statistics.hpp"
#include "python/bindings/bind.hpp"
#include "python/bindings/errors.hpp"
#include "python/bindings/python_calls.hpp"
#include "python/bindings/python_team.hpp"

namespace fulbito::python {
namespace {

namespace nb = nanobind;

constexpr Tick kTicksBetweenChecks = 64;  // a few milliseconds between looks for Ctrl-C

/// What `fulbito.play` asks for, besides the teams.
struct MatchOptions {
  std::string rules, robot, physics, start;
  std::uint64_t seed = kDefaultMatchSeed;
  std::optional<double> half_seconds;
  std::array<int, 2> latency{};   ///< [ticks]
  std::array<double, 2> noise{};  ///< [m]
  std::array<double, 2> dropout{};
  std::optional<double> time_ms;  ///< infinite: unlimited
  std::string record;             ///< file; empty: none
  bool keep = false;              ///< record in memory
  bool recipe = false;
  bool drawings = false;
};

std::int64_t now() { return std::chrono::steady_clock::now().time_since_epoch().count(); }

MatchConfig configOf(const MatchOptions& options) {
  MatchConfig config;
  config.rules = valueOf(loadRules(options.rules));
  if (options.half_seconds) {
    config.rules.half_seconds = *options.half_seconds;
    valueOf(validate(config.rules));
  }
  config.field = valueOf(loadField(config.rules.field));
  config.robot = valueOf(loadRobot(options.robot));
  config.physics = valueOf(loadPhysics(options.physics));
  for (std::size_t i = 0; i < 2; ++i) {
    config.vision[i] = {options.latency[i], options.noise[i],
                        headingNoise(options.noise[i], config.robot.robot.length), options.dropout[i]};
  }
  if (options.time_ms) {
    config.decision_time = config.rules.decision_time;
    config.decision_time->decision = *options.time_ms * 1e-3;
  }
  config.seed = options.seed;
  return config;
}

/// One match that the caller's thread plays without the GIL.
class Play {
 public:
  Play(const MatchOptions& options, nb::object progress)
      : options_(options), progress_(std::move(progress)) {}

  /// The JSON of the match, and its recording if that is kept in memory.
  std::pair<std::string, std::string> run(nb::handle blue, nb::handle yellow,
                                          const Containment& containment) {
    const TeamCatalogue catalogue = catalogueOf(containment);
    MatchConfig config = configOf(options_);
    config.teams = {teamFrom(blue, catalogue, failure_), teamFrom(yellow, catalogue, failure_)};
    if (!options_.start.empty()) {
      setStart(config, valueOf(loadStartState(options_.start, config)));
    }
    std::optional<Result<std::string>> json;
    {
      const nb::gil_scoped_release for_the_match;
      json = played(config);
    }
    failure_->raise();
    return {valueOf(std::move(*json)), std::move(bytes_)};
  }

 private:
  Result<std::string> played(const MatchConfig& config) {
    auto match = Match::create(config, now);
    if (!match) return tl::unexpected<Error>(match.error());
    StatisticsObserver statistics;
    EventLog events;
    match->watch(statistics);
    match->watch(events);
    auto recorder = recorderOf(match->config());
    if (!recorder) return tl::unexpected<Error>(recorder.error());
    if (*recorder) match->watch(**recorder);
    const std::int64_t began = now();
    while (match->step()) {
      if (match->tick() % kTicksBetweenChecks == 0 && !goesOn(*match)) break;
    }
    match->finish();
    MatchReport report = reportOf(*match, statistics, events);
    report.wall = static_cast<double>(now() - began) * 1e-9;
    if (*recorder && !(*recorder)->written()) return tl::unexpected<Error>((*recorder)->written().error());
    if (report.faults.abandoned) {
      return fail(report.faults.abandoned->code,
                  "the match was abandoned: " + report.faults.abandoned->message);
    }
    return matchJson(report);
  }

  Result<std::optional<MatchRecorder>> recorderOf(const MatchConfig& config) {
    if (options_.record.empty() && !options_.keep) return std::nullopt;
    const auto level = options_.recipe ? RecordingLevel::kRecipe : RecordingLevel::kFull;
    const RecordingWriter::Sink keep = [this](std::string_view bytes) -> Result<void> {
      bytes_ += bytes;
      return {};
    };
    auto made = options_.keep ? MatchRecorder::create(keep, config, level)
                              : MatchRecorder::create(options_.record, config, level);
    if (!made) return tl::unexpected<Error>(made.error());
    if (options_.drawings) made->keepDrawings();
    return std::optional(std::move(*made));
  }

  /// Lets Python see signals, and tells it how far the match is. False: something was raised.
  bool goesOn(const Match& match) {
    const nb::gil_scoped_acquire gil;
    try {
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
      if (!progress_.is_none()) {
        const RefereeState& referee = match.referee();
        progress_(referee.match_ticks, referee.score[0], referee.score[1]);
      }
    } catch (nb::python_error& error) {
      failure_->keep(std::move(error), "progress");
    }
    return !failure_->any();
  }

  MatchOptions options_;
  nb::object progress_;
  SharedFailure failure_ = newFailure();
  std::string bytes_;
};

nb::tuple play(nb::handle blue, nb::handle yellow, const MatchOptions& options,
               const Containment& containment, nb::object progress) {
  const auto [json, recording] = Play(options, std::move(progress)).run(blue, yellow, containment);
  return nb::make_tuple(json, nb::bytes(recording.data(), recording.size()));
}

}  // namespace

void bindPlay(nb::module_& m) {
  nb::class_<Containment>(m, "Containment", "How teams that are files or programs are contained.")
      .def(nb::init<>())
      .def_rw("isolate", &Containment::isolate, "Of shared libraries: process or none.")
      .def_rw("sandbox", &Containment::sandbox, "best or require.")
      .def_rw("memory_mb", &Containment::memory_mb, "[MiB] of each team.")
      .def_rw("processes", &Containment::processes, "Processes and threads of each team.")
      .def_rw("network", &Containment::network, "Teams may use the network.");
  nb::class_<MatchOptions>(m, "MatchOptions", "What fulbito.play asks for, besides the teams.")
      .def(nb::init<>())
      .def_rw("rules", &MatchOptions::rules, "Profile or file.")
      .def_rw("robot", &MatchOptions::robot, "Preset or file.")
      .def_rw("physics", &MatchOptions::physics, "Profile or file.")
      .def_rw("start", &MatchOptions::start, "File with a start state; empty: a kick-off.")
      .def_rw("seed", &MatchOptions::seed, "Of all random numbers.")
      .def_rw("half_seconds", &MatchOptions::half_seconds, "[s] of a half.", nb::arg().none())
      .def_rw("latency", &MatchOptions::latency, "[ticks] of blue and yellow.")
      .def_rw("noise", &MatchOptions::noise, "[m] of blue and yellow.")
      .def_rw("dropout", &MatchOptions::dropout, "Of blue and yellow.")
      .def_rw("time_ms", &MatchOptions::time_ms, "[ms] per decision.", nb::arg().none())
      .def_rw("record", &MatchOptions::record, "File of the recording; empty: none.")
      .def_rw("keep", &MatchOptions::keep, "Record in memory.")
      .def_rw("recipe", &MatchOptions::recipe, "Record without states.")
      .def_rw("drawings", &MatchOptions::drawings, "Record the teams' drawings.");
  m.def("play", &play, nb::arg("blue").none(), nb::arg("yellow").none(), nb::arg("options"),
        nb::arg("containment"), nb::arg("progress").none(),
        nb::sig("def play(blue: object, yellow: object, options: MatchOptions, containment: "
                "Containment, progress: object | None) -> tuple[str, bytes]"),
        "Plays a match. Returns its JSON, and its recording if that is kept in memory.");
}

}  // namespace fulbito::python
