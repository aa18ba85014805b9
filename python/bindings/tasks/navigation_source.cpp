#include <array>

#include "python/bindings/bind.hpp"
#include "python/bindings/tasks/task_arguments.hpp"
#include "python/environments/navigation/navigation_environment.hpp"

namespace fulbito::python {
namespace {

namespace nb = nanobind;

constexpr std::array kActions{"wheels", "twist", "heading"};
constexpr std::array kSplits{"train", "test"};
constexpr std::array kHeadings{"layout", "random", "away"};

Source navigationSource(const nb::kwargs& values) {
  const Arguments from{nb::borrow<nb::dict>(values)};
  NavigationSettings settings;
  settings.suite = from.get<std::string>("suite", "corner", "text");
  if (const auto file = from.get<std::string>("layout", "", "text"); !file.empty()) {
    settings.layout = valueOf(loadLayout(file));
  }
  settings.speed = from.get<double>("speed", 1.0, "number");
  settings.control = static_cast<NavigationControl>(from.choice("action", kActions));
  settings.train = from.choice("split", kSplits) == 0;
  settings.heading = static_cast<StartHeading>(from.choice("heading", kHeadings));
  settings.ticks = from.get<int>("frame_skip", 1, "whole number");
  settings.ends_at_contact = from.get<bool>("ends_at_contact", false, "bool");
  settings.robot = from.get<std::string>("robot_model", "jung-lee-2015", "text");
  settings.physics = from.get<std::string>("physics", "standard", "text");
  settings.sensors = readSensors(from).value_or(SensorModel{});
  readWeights(from, kNavigationTerms, settings.weights);
  return {valueOf(NavigationEnvironment::create(settings))};
}

}  // namespace

void bindNavigationSource(nb::module_& m) {
  m.def("navigation_source", &navigationSource,
        nb::sig("def navigation_source(**settings: typing.Any) -> Source"),
        "A source of episodes that are trials of compare; the arguments are those of "
        "fulbito.envs.NavigateSettings.");
  m.def(
      "navigation_sight", [] { return tableOf(navigationSight()); },
      nb::sig("def navigation_sight() -> list[tuple[str, str, str]]"),
      "The numbers of an observation in order: name, unit, meaning.");
  m.def(
      "trial_outcomes",
      [] {
        nb::list names;
        for (int i = 0; i <= static_cast<int>(TrialOutcome::kLeftField); ++i) {
          const std::string_view name = nameOf(static_cast<TrialOutcome>(i));
          names.append(nb::str(name.data(), name.size()));
        }
        return names;
      },
      nb::sig("def trial_outcomes() -> list[str]"), "Names of a trial's outcomes, by number.");
}

}  // namespace fulbito::python
