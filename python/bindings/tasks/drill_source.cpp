#include <array>

#include "python/bindings/bind.hpp"
#include "python/bindings/python_team.hpp"
#include "python/bindings/tasks/task_arguments.hpp"
#include "python/environments/drills/drill_environment.hpp"
#include "python/environments/sight.hpp"

namespace fulbito::python {
namespace {

namespace nb = nanobind;

constexpr std::array kActions{"wheels", "twist", "go-to"};
constexpr std::array kSplits{"train", "test"};

Drill drillOf(const Arguments& from) {
  const auto file = from.get<std::string>("file", "", "text");
  return file.empty() ? valueOf(builtInDrill(from.get<int>("drill", 3, "whole number")))
                      : valueOf(drillOfFile(file));
}

Source drillSource(const nb::kwargs& values) {
  const Arguments from{nb::borrow<nb::dict>(values)};
  DrillSettings settings;
  settings.drill = drillOf(from);
  settings.actions = static_cast<ActionForm>(from.choice("action", kActions));
  settings.split = static_cast<DrillSplit>(from.choice("split", kSplits));
  settings.robot = from.get<int>("robot", -1, "whole number");
  settings.ticks = from.get<int>("frame_skip", 1, "whole number");
  settings.catalogue = catalogueOf({});
  SharedFailure failure = newFailure();
  const nb::object classic = nb::str("classic");
  settings.mates = teamFrom(from.get<nb::object>("mates", classic, "team"), settings.catalogue, failure);
  settings.itself = teamFrom(from.get<nb::object>("itself", classic, "team"), settings.catalogue, failure);
  settings.robot_model = from.get<std::string>("robot_model", "vsss", "text");
  settings.physics = from.get<std::string>("physics", "standard", "text");
  settings.navigator = from.get<std::string>("navigator", kDefaultNavigator, "text");
  settings.sight = readSensors(from);
  settings.ranges = readRanges(from);
  readWeights(from, kDrillTerms, settings.weights);
  return {valueOf(DrillEnvironment::create(settings)), std::move(failure)};
}

nb::list drillTable() {
  nb::list all;
  for (const Drill& drill : builtInDrills()) {
    nb::dict row;
    row["number"] = drill.number;
    row["name"] = drill.name;
    row["what"] = drill.what;
    row["trials"] = drill.trials;
    row["playable"] = checkHasTrials(drill).has_value();
    nb::list starts;
    for (const DrillStart& start : drill.starts) starts.append(start.name);
    row["starts"] = starts;
    all.append(row);
  }
  return all;
}

nb::list drillStarts(const nb::kwargs& values) {
  nb::list names;
  for (const DrillStart& start : drillOf(Arguments{nb::borrow<nb::dict>(values)}).starts)
    names.append(start.name);
  return names;
}

}  // namespace

void bindDrillSource(nb::module_& m) {
  m.def("drill_source", &drillSource, nb::sig("def drill_source(**settings: typing.Any) -> Source"),
        "A source of episodes that are trials of a drill; the arguments are those of "
        "fulbito.envs.DrillSettings.");
  m.def("drill_table", &drillTable, nb::sig("def drill_table() -> list[dict[str, typing.Any]]"),
        "The built-in drills: a dict each of number, name, what, trials, starts, playable.");
  m.def("drill_starts", &drillStarts, nb::sig("def drill_starts(**settings: typing.Any) -> list[str]"),
        "Names of a drill's starts, by `drill` or `file`.");
  m.def(
      "drill_sight", [] { return tableOf(RobotSight(3).entries()); },
      nb::sig("def drill_sight() -> list[tuple[str, str, str]]"),
      "The numbers of an observation in order: name, unit, meaning.");
}

}  // namespace fulbito::python
