#include <chrono>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>
#include <optional>

#include "fulbito/experiment.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/bind.hpp"
#include "python/bindings/errors.hpp"
#include "python/bindings/python_navigator.hpp"

namespace fulbito::python {
namespace {

namespace nb = nanobind;

constexpr std::size_t kTraceColumns = 11;

std::int64_t now() { return std::chrono::steady_clock::now().time_since_epoch().count(); }

/// A finished comparison.
class FinishedComparison {
 public:
  FinishedComparison(Comparison comparison, double wall) : comparison_(std::move(comparison)), wall_(wall) {}

  std::string json() const { return resultsJson(comparison_, wall_); }
  std::string markdown() const { return markdownReport(comparison_); }
  std::string csv() const { return trialsCsv(comparison_); }

  /// The traces that were kept: suite, speed, navigator, index, and rows of `kTraceColumns`.
  nb::list traces() const {
    nb::list list;
    for (const TrialRecord& record : comparison_.records) {
      if (record.trace.empty()) continue;
      const ComparisonBlock& block = comparison_.blocks[record.block];
      std::vector<double> rows;
      for (const TraceRow& row : record.trace) {
        const RobotState& r = row.robot;
        rows.insert(rows.end(), {row.time, r.pose.position.x, r.pose.position.y, r.pose.heading, r.velocity.x,
                                 r.velocity.y, r.angular_velocity, r.wheels.left, r.wheels.right,
                                 row.command.left, row.command.right});
      }
      list.append(nb::make_tuple(block.suite->name, block.speed, block.navigators[record.navigator].text,
                                 record.index,
                                 arrayOf(std::move(rows), {record.trace.size(), kTraceColumns})));
    }
    return list;
  }

 private:
  Comparison comparison_;
  double wall_;
};

/// Adds navigators of this process behind the named ones. Alone, they replace the usual ones of a plain
/// suite.
void addOwn(Comparison& comparison, const std::vector<NavigatorChoice>& own, bool alone) {
  const bool replace =
      alone && comparison.blocks.size() > 0 && comparison.config.suite == comparison.blocks[0].suite->name;
  for (ComparisonBlock& block : comparison.blocks) {
    if (replace) block.navigators.clear();
    block.navigators.insert(block.navigators.end(), own.begin(), own.end());
  }
  for (const NavigatorChoice& choice : own) comparison.config.navigators.push_back(choice.text);
}

/// Lets go of the Python classes, which would otherwise live in a cycle with the results.
void forgetMakers(Comparison& comparison) {
  for (ComparisonBlock& block : comparison.blocks) {
    for (NavigatorChoice& choice : block.navigators) {
      auto info = std::make_shared<NavigatorInfo>(*choice.info);
      info->make = {};
      choice.info = std::move(info);
    }
  }
}

FinishedComparison compare(const ComparisonConfig& config, nb::list own, nb::object progress) {
  const SharedFailure failure = newFailure();
  std::vector<NavigatorChoice> navigators;
  for (nb::handle entry : own) {
    navigators.push_back(
        navigatorFrom(entry[0], nb::cast<std::string>(entry[1]), nb::cast<bool>(entry[2]), failure));
  }
  Comparison comparison = valueOf(planComparison(config));
  if (!navigators.empty()) addOwn(comparison, navigators, config.navigators.empty());
  const auto goes_on = [&](std::size_t done, std::size_t total) {
    const nb::gil_scoped_acquire gil;
    try {
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
      if (!progress.is_none()) progress(done, total);
    } catch (nb::python_error& error) {
      failure->keep(std::move(error), "progress");
    }
    return !failure->any();
  };
  const std::int64_t began = now();
  Result<void> done;
  {
    const nb::gil_scoped_release for_the_trials;
    done = runComparison(comparison, now, goes_on);
  }
  failure->raise();
  valueOf(done);
  forgetMakers(comparison);
  return {std::move(comparison), static_cast<double>(now() - began) * 1e-9};
}

nb::list listOfNavigators() {
  nb::list list;
  for (const NavigatorInfo& info : navigators()) {
    nb::list parameters;
    for (const ParameterSpec& p : info.parameters) {
      const char* kTypes[] = {"number", "integer", "flag", "choice"};
      parameters.append(nb::make_tuple(p.name, kTypes[static_cast<std::size_t>(p.type)], p.default_value,
                                       p.minimum, p.maximum, p.unit, p.doc, nb::cast(p.choices)));
    }
    list.append(nb::make_tuple(info.name, info.summary, info.source, info.plans_speed, parameters));
  }
  return list;
}

nb::list listOfSuites() {
  nb::list list;
  for (const Suite& suite : suites()) {
    list.append(nb::make_tuple(suite.name, suite.summary, suite.default_trials, nb::cast(suite.speeds)));
  }
  return list;
}

nb::dict obstacleOf(const ObstacleSpec& o) {
  nb::dict dict;
  dict["shape"] = o.shape == ObstacleShape::kDisc ? "disc" : "box";
  dict["motion"] = o.motion == ObstacleMotion::kFixed  ? "fixed"
                   : o.motion == ObstacleMotion::kPath ? "path"
                                                       : "pushable";
  dict["pose"] = nb::make_tuple(o.pose.position.x, o.pose.position.y, o.pose.heading);
  dict["radius"] = o.radius;
  dict["length"] = o.length;
  dict["width"] = o.width;
  nb::list path;
  for (const Vec2 point : o.path) path.append(nb::make_tuple(point.x, point.y));
  dict["path"] = path;
  dict["speed"] = o.speed;
  return dict;
}

nb::tuple layoutOf(const std::string& suite, std::uint64_t seed, std::uint64_t index) {
  const Suite* found = valueOf(findSuite(suite));
  const Layout layout = found->layout(seed, index);
  nb::list obstacles;
  for (const ObstacleSpec& obstacle : layout.obstacles) obstacles.append(obstacleOf(obstacle));
  nb::object heading = nb::none();
  if (layout.goal_heading) heading = nb::float_(*layout.goal_heading);
  return nb::make_tuple(
      layout.name, layout.field,
      nb::make_tuple(layout.start.position.x, layout.start.position.y, layout.start.heading),
      nb::make_tuple(layout.goal.x, layout.goal.y), heading, layout.goal_tolerance, obstacles);
}

void bindComparisonConfig(nb::module_& m) {
  nb::class_<ComparisonConfig>(m, "ComparisonConfig", "What fulbito.compare asks for.")
      .def(nb::init<>())
      .def_rw("suite", &ComparisonConfig::suite, "Name of the suite.")
      .def_rw("navigators", &ComparisonConfig::navigators, "Specifications; empty: the suite's.")
      .def_rw("speeds", &ComparisonConfig::speeds, "[m/s] top speeds; empty: the suite's.")
      .def_rw("trials", &ComparisonConfig::trials, "Layouts per block; 0: the suite's.")
      .def_rw("seed", &ComparisonConfig::seed, "Of the layouts.")
      .def_rw("jobs", &ComparisonConfig::jobs, "Worker threads; 0: all cores.")
      .def_rw("robot", &ComparisonConfig::robot, "Preset or file.")
      .def_rw("physics", &ComparisonConfig::physics, "Preset or file.")
      .def_rw("only", &ComparisonConfig::only, "Only this layout of each block.", nb::arg().none())
      .def_rw("traces", &ComparisonConfig::pictures, "Layouts per block whose traces are kept.")
      .def_prop_rw(
          "sensors",
          [](const ComparisonConfig& c) {
            return nb::make_tuple(c.sensors.latency_ticks, c.sensors.position_noise, c.sensors.dropout);
          },
          [](ComparisonConfig& c, const nb::tuple& values) {
            c.sensors.latency_ticks = nb::cast<int>(values[0]);
            c.sensors.position_noise = nb::cast<double>(values[1]);
            c.sensors.dropout = nb::cast<double>(values[2]);
          },
          nb::for_getter(nb::sig("def sensors(self) -> tuple[int, float, float]")),
          nb::for_setter(nb::sig("def sensors(self, values: tuple[int, float, float], /) -> None")),
          "Latency [ticks], noise [m], dropout.");
}

}  // namespace

void bindCompare(nb::module_& m) {
  bindComparisonConfig(m);
  nb::class_<FinishedComparison>(m, "FinishedComparison", "See fulbito.Comparison.")
      .def("json", &FinishedComparison::json, "All results.")
      .def("markdown", &FinishedComparison::markdown, "Tables for people.")
      .def("csv", &FinishedComparison::csv, "One line per trial.")
      .def("traces", &FinishedComparison::traces,
           nb::sig(
               "def traces(self) -> list[tuple[str, float, str, int, numpy.typing.NDArray[numpy.float64]]]"),
           "The traces that were kept.");
  m.def("compare", &compare, nb::arg("config"), nb::arg("own"), nb::arg("progress").none(),
        nb::sig("def compare(config: ComparisonConfig, own: list[tuple[object, str, bool]], progress: object "
                "| None) -> "
                "FinishedComparison"),
        "Runs all trials.");
  m.def("navigators", &listOfNavigators,
        nb::sig("def navigators() -> list[tuple[str, str, str, bool, list[tuple[str, str, float, float, "
                "float, str, str, list[str]]]]]"),
        "All navigation methods.");
  m.def("suites", &listOfSuites, nb::sig("def suites() -> list[tuple[str, str, int, list[float]]]"),
        "All suites of layouts.");
  m.def(
      "layout", &layoutOf, nb::arg("suite"), nb::arg("seed"), nb::arg("index"),
      nb::sig("def layout(suite: str, seed: int, index: int) -> tuple[str, str, tuple[float, float, float], "
              "tuple[float, float], float | None, float, list[dict[str, typing.Any]]]"),
      "One layout of a suite.");
}

}  // namespace fulbito::python
