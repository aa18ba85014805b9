#include <array>
#include <map>
#include <nanobind/stl/map.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "python/bindings/bind.hpp"
#include "python/bindings/python_team.hpp"
#include "python/bindings/tasks/task_arguments.hpp"
#include "python/environments/match/environment.hpp"
#include "referee/rules/detector_schema.hpp"

namespace fulbito::python {
namespace {

namespace nb = nanobind;

constexpr std::array kActions{"wheels", "twist", "go-to", "skill", "compat"};
constexpr std::array kObservations{"absolute", "egocentric", "compat"};
constexpr std::array kRewards{"shaped", "compat"};
constexpr std::array kStarts{"kick-off", "random"};
constexpr std::array kEnds{"goal", "match"};

void readAgents(const Arguments& from, const char* name, std::array<bool, kMaxTeamSize>& agents) {
  for (const int number : from.get<std::vector<int>>(name, {}, "list of robot numbers")) {
    if (number < 0 || number >= kMaxTeamSize) {
      raise(ErrorCode::kUsage, std::string(name) + ": there is no robot " + std::to_string(number));
    }
    agents[static_cast<std::size_t>(number)] = true;
  }
}

void readWeights(const Arguments& from, RewardWeights& weights) {
  const std::map<std::string, double*> known{{"goal", &weights.goal},
                                             {"ball", &weights.ball},
                                             {"move", &weights.move},
                                             {"energy", &weights.energy},
                                             {"foul", &weights.foul}};
  for (const auto& [name, value] :
       from.get<std::map<std::string, double>>("rewards", {}, "dict of numbers")) {
    const auto found = known.find(name);
    if (found == known.end()) {
      raise(ErrorCode::kUsage, "rewards: '" + name + "' is none of goal, ball, move, energy, foul");
    }
    *found->second = value;
  }
}

void readModels(const Arguments& from, MatchTask& task) {
  task.match.physics = valueOf(loadPhysics(from.get<std::string>("physics", "standard", "text")));
  PhysicsProfile& physics = task.match.physics;
  physics.control_rate = from.get<int>("control_rate", physics.control_rate, "whole number");
  physics.substeps = from.get<int>("substeps", physics.substeps, "whole number");
  task.match.robot = valueOf(loadRobot(from.get<std::string>("robot_model", "vsss", "text")));
  task.ranges = readRanges(from);
}

void readVision(const Arguments& from, MatchTask& task) {
  const VisionModel vision = readSensors(from).value_or(VisionModel{});
  for (const RobotId agent : agentsOf(task)) task.match.vision[indexOf(agent.team)] = vision;
}

void readForms(const Arguments& from, MatchTask& task) {
  task.actions = static_cast<ActionForm>(from.choice("action", kActions));
  task.navigator = valueOf(parseNavigator(from.get<std::string>("navigator", "straight", "text")));
  task.frame_skip = from.get<int>("frame_skip", 1, "whole number");
  task.observations = static_cast<ObservationForm>(from.choice("observation", kObservations));
  task.stack = from.get<int>("stack", 1, "whole number");
  task.reward = static_cast<RewardForm>(from.choice("reward", kRewards));
  readWeights(from, task.weights);
  task.start = static_cast<StartForm>(from.choice("start", kStarts));
  task.ends_at_goal = from.choice("end", kEnds) == 0;
  task.seconds = from.get<double>("time_limit", 0.0, "number");
}

/// The configuration of a match without teams.
MatchConfig configOf(const std::string& rules) {
  MatchConfig config;
  config.rules = valueOf(loadRules(rules));
  config.field = valueOf(loadField(config.rules.field));
  return config;
}

Source matchSource(const nb::kwargs& values) {
  const Arguments from{nb::borrow<nb::dict>(values)};
  MatchTask task;
  task.match = configOf(from.get<std::string>("rules", "vsss-3v3", "text"));
  readModels(from, task);
  if (from.get<bool>("only_goals", false, "bool")) callOnlyGoals(task.match.rules);
  readAgents(from, "blue_agents", task.agents[0]);
  readAgents(from, "yellow_agents", task.agents[1]);
  readForms(from, task);
  readVision(from, task);
  SharedFailure failure = newFailure();
  const TeamCatalogue catalogue = catalogueOf({});
  const nb::object idle = nb::str("idle");
  task.match.teams = {teamFrom(from.get<nb::object>("blue", idle, "team"), catalogue, failure),
                      teamFrom(from.get<nb::object>("yellow", idle, "team"), catalogue, failure)};
  return {valueOf(MatchEnvironment::create(std::move(task))), std::move(failure)};
}

}  // namespace

void bindMatchSource(nb::module_& m) {
  m.def("match_source", &matchSource, nb::sig("def match_source(**settings: typing.Any) -> Source"),
        "A source of episodes that are matches; the arguments are those of fulbito.envs.MatchSettings.");
  m.def(
      "team_size", [](const std::string& rules) { return valueOf(loadRules(rules)).team_size; },
      nb::arg("rules"), "Robots per team of the rules.");
}

}  // namespace fulbito::python
