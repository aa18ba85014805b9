#include <array>
#include <nanobind/stl/string.h>

#include "python/bindings/arrays.hpp"
#include "python/bindings/bind.hpp"
#include "python/bindings/errors.hpp"
#include "python/environments/match/actions.hpp"
#include "python/environments/match/observations.hpp"

namespace fulbito::python {
namespace {

namespace nb = nanobind;

double number(nb::handle object, const char* name) { return nb::cast<double>(object.attr(name)); }

/// A state as the team module has it. It tells no wheels of opponents.
RobotState robotOf(nb::handle robot, bool own) {
  RobotState state;
  state.pose = {{number(robot, "x"), number(robot, "y")}, number(robot, "heading")};
  state.velocity = {number(robot, "vx"), number(robot, "vy")};
  state.angular_velocity = number(robot, "omega");
  if (own) state.wheels = {number(robot, "left"), number(robot, "right")};
  return state;
}

void readRobots(nb::handle robots, bool own, Observation& seen) {
  std::size_t i = 0;
  for (const nb::handle robot : robots) {
    if (i >= kMaxTeamSize) raise(ErrorCode::kUsage, "an observation has too many robots");
    ObservedRobot& at = (own ? seen.own : seen.opponents)[i];
    at.present = !robot.is_none();
    if (at.present) at.state = robotOf(robot, own);
    if (at.present && own) seen.sent[i] = {number(robot, "sent_left"), number(robot, "sent_right")};
    ++i;
  }
}

Observation observationOf(nb::handle now) {
  Observation seen;
  seen.playing = nb::cast<bool>(now.attr("playing"));
  seen.remaining = number(now, "remaining");
  seen.own_score = nb::cast<int>(now.attr("own_score"));
  seen.opponent_score = nb::cast<int>(now.attr("opponent_score"));
  const nb::object ball = now.attr("ball");
  seen.ball.position = {number(ball, "x"), number(ball, "y")};
  seen.ball.velocity = {number(ball, "vx"), number(ball, "vy")};
  readRobots(now.attr("own"), true, seen);
  readRobots(now.attr("opponents"), false, seen);
  return seen;
}

/// What observations and commands depend on, from the team module's MatchInfo.
MatchConfig matchOf(nb::handle info) {
  MatchConfig match;
  const nb::object field = info.attr("field");
  match.field.length = number(field, "length");
  match.field.width = number(field, "width");
  const nb::object robot = info.attr("robot");
  match.robot.robot.wheel_radius = number(robot, "wheel_radius");
  match.robot.robot.axle_track = number(robot, "axle_track");
  match.robot.robot.max_wheel_speed = number(robot, "max_wheel_speed");
  match.rules.team_size = nb::cast<int>(info.attr("team_size"));
  match.rules.half_seconds = nb::cast<double>(info.attr("rules")["periods"]["half_seconds"]);
  return match;
}

/// Turns what a team of the team module knows into an environment's observations, and actions into commands.
class Agent {
 public:
  Agent(nb::handle info, const std::string& observation, const std::string& action)
      : match_(matchOf(info)), actions_(actionOf(action)), writer_(formOf(observation), match_) {}

  nb::ndarray<nb::numpy, float> observe(nb::handle now, int robot) const {
    if (robot < 0 || robot >= match_.rules.team_size) {
      raise(ErrorCode::kUsage, "there is no robot " + std::to_string(robot));
    }
    std::vector<float> numbers(writer_.size());
    const Observation seen = observationOf(now);
    writer_.write(seen, static_cast<std::size_t>(robot), numbers);
    const std::size_t size = numbers.size();
    return arrayOf(std::move(numbers), {size});
  }

  nb::tuple command(
      const nb::ndarray<const float, nb::ndim<1>, nb::c_contig, nb::device::cpu>& action) const {
    if (action.size() != numbersOf(actions_)) {
      raise(ErrorCode::kUsage, "an action of this form has " + std::to_string(numbersOf(actions_)) +
                                   " numbers, not " + std::to_string(action.size()));
    }
    const RobotCommand command = commandOf(actions_, match_, {action.data(), action.size()});
    switch (command.kind) {
      case RobotCommand::Kind::kWheels:
        return nb::make_tuple("wheels", command.wheels.left, command.wheels.right);
      case RobotCommand::Kind::kTwist:
        return nb::make_tuple("twist", command.twist.linear, command.twist.angular);
      case RobotCommand::Kind::kGoTo:
        break;
    }
    const GoTo& place = command.go_to;
    return nb::make_tuple("go-to", place.position.x, place.position.y, place.heading.value_or(0.0));
  }

 private:
  static ObservationForm formOf(const std::string& name) {
    if (name == "egocentric") return ObservationForm::kEgocentric;
    if (name == "absolute") return ObservationForm::kAbsolute;
    if (name == "compat") return ObservationForm::kCompat;
    raise(ErrorCode::kUsage, "observation '" + name + "' is none of egocentric, absolute, compat");
  }
  static ActionForm actionOf(const std::string& name) {
    if (name == "wheels") return ActionForm::kWheels;
    if (name == "twist") return ActionForm::kTwist;
    if (name == "go-to") return ActionForm::kGoTo;
    if (name == "compat") return ActionForm::kCompat;
    raise(ErrorCode::kUsage, "action '" + name + "' is none of wheels, twist, go-to, compat");
  }

  MatchConfig match_;
  ActionForm actions_;
  ObservationWriter writer_;
};

}  // namespace

void bindAgent(nb::module_& m) {
  nb::class_<Agent>(m, "Agent",
                    "Turns what a team knows into an environment's observations, and actions into commands.")
      .def(nb::init<nb::handle, const std::string&, const std::string&>(), nb::arg("info"),
           nb::arg("observation"), nb::arg("action"),
           "`info`: the MatchInfo of fulbito.team; the forms are those of fulbito/VSS-v0. Raises UsageError.")
      .def("observe", &Agent::observe, nb::arg("now"), nb::arg("robot"),
           "What robot number `robot` of the team sees, as the environment tells it: float32, shape (n,).")
      .def(
          "command", &Agent::command, nb::arg("action"),
          nb::sig("def command(self, action: numpy.typing.NDArray[numpy.float32]) -> tuple[typing.Any, ...]"),
          "The command of an action, float32 of shape (2,) or (3,): ('wheels', left, right) [rad/s], "
          "('twist', linear, angular) [m/s, rad/s] or ('go-to', x, y, heading) [m, rad].");
}

}  // namespace fulbito::python
