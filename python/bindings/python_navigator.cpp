#include "python/bindings/python_navigator.hpp"

#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>
#include <optional>

#include "python/bindings/arrays.hpp"

namespace fulbito::python {
namespace {

namespace nb = nanobind;

using Points = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
using Speeds = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

nb::object sceneOf(const NavigationScene& scene) {
  std::vector<double> obstacles;
  for (const DiscObstacle& o : scene.obstacles) {
    obstacles.insert(obstacles.end(), {o.position.x, o.position.y, o.radius, o.velocity.x, o.velocity.y});
  }
  const std::size_t count = scene.obstacles.size();
  const RobotState& self = scene.self;
  const NavigationGoal& goal = scene.goal;
  const RobotModel& robot = *scene.robot;
  nb::object heading = nb::none();
  if (goal.heading) heading = nb::float_(*goal.heading);
  return nb::module_::import_("fulbito.navigation")
      .attr("Scene")(
          scene.tick, scene.dt, nb::make_tuple(self.pose.position.x, self.pose.position.y, self.pose.heading),
          nb::make_tuple(self.velocity.x, self.velocity.y, self.angular_velocity),
          nb::make_tuple(self.wheels.left, self.wheels.right),
          nb::make_tuple(goal.position.x, goal.position.y), heading, goal.tolerance, goal.stop,
          arrayOf(std::move(obstacles), {count, 5}), nb::make_tuple(scene.field->length, scene.field->width),
          nb::make_tuple(robot.max_wheel_speed, robot.wheel_radius, robot.axle_track, robot.length,
                         robot.width));
}

class PythonNavigator final : public Navigator, private HeadingField {
 public:
  PythonNavigator(nb::object navigator, std::string name, SharedFailure failure)
      : navigator_(std::move(navigator)), name_(std::move(name)), failure_(std::move(failure)) {}

  ~PythonNavigator() override {
    const nb::gil_scoped_acquire gil;
    answer_.reset();
    function_.reset();
  }

  void reset() override {
    guarded([&] { navigator_.get().attr("reset")(); });
  }

  Guidance plan(const NavigationScene& scene) override {
    Guidance guidance;
    guidance.kind = GuidanceKind::kWheels;
    guarded([&] { take(navigator_.get().attr("plan")(sceneOf(scene)), guidance); });
    return failed_ ? standing() : guidance;
  }

 private:
  static Guidance standing() {
    Guidance guidance;
    guidance.kind = GuidanceKind::kWheels;
    return guidance;
  }

  /// Reads an answer of `plan`, which `fulbito.navigation.checked` turns into a tuple.
  void take(nb::object answer, Guidance& guidance) {
    const bool same = answer_.is_valid() && answer.is(answer_);
    answer_ = std::move(answer);
    const auto parts =
        nb::cast<nb::tuple>(nb::module_::import_("fulbito.navigation").attr("checked")(answer_));
    const auto kind = nb::cast<std::string>(parts[0]);
    if (kind == "wheels") {
      guidance.wheels = {nb::cast<double>(parts[1]), nb::cast<double>(parts[2])};
      return;
    }
    guidance.speed_cap = nb::cast<double>(parts[3]);
    if (kind == "field") {
      function_ = parts[1];
      guidance.kind = GuidanceKind::kField;
      guidance.field = this;
      return;
    }
    if (!same) keepPath(nb::cast<Points>(parts[1]), parts[2]);
    guidance.kind = speeds_.empty() ? GuidanceKind::kPath : GuidanceKind::kTimedPath;
    guidance.path = path_;
    guidance.speeds = speeds_;
    guidance.revision = revision_;
  }

  void keepPath(const Points& points, nb::handle speeds) {
    ++revision_;
    path_.clear();
    for (std::size_t i = 0; i < points.shape(0); ++i) path_.push_back({points(i, 0), points(i, 1)});
    speeds_.clear();
    if (speeds.is_none()) return;
    const auto values = nb::cast<Speeds>(speeds);
    for (std::size_t i = 0; i < values.shape(0); ++i) speeds_.push_back(values(i));
  }

  double heading(Vec2 p) const override {
    double angle = 0.0;
    const_cast<PythonNavigator*>(this)->guarded([&] {
      angle = nb::cast<double>(nb::module_::import_("fulbito.navigation").attr("angle")(function_(p.x, p.y)));
    });
    return angle;
  }

  template <typename Call>
  void guarded(const Call& call) {
    if (failed_) return;
    const nb::gil_scoped_acquire gil;
    try {
      call();
    } catch (nb::python_error& error) {
      failed_ = true;
      failure_->keep(std::move(error), "navigator '" + name_ + "'");
    } catch (const nb::cast_error&) {
      failed_ = true;
      failure_->keep("navigator '" + name_ + "'", "an answer that is no guidance");
    }
  }

  HeldObject navigator_;
  std::string name_;
  SharedFailure failure_;
  nb::object answer_, function_;
  std::vector<Vec2> path_;
  std::vector<double> speeds_;
  std::uint64_t revision_ = 0;
  bool failed_ = false;
};

}  // namespace

NavigatorChoice navigatorFrom(nb::handle factory, const std::string& name, bool plans_speed,
                              const SharedFailure& failure) {
  const auto held = std::make_shared<HeldObject>(nb::borrow(factory));
  NavigatorInfo info;
  info.name = name;
  info.summary = "a navigator of this process";
  info.plans_speed = plans_speed;
  info.make = [held, name, failure](const std::vector<Setting>&) -> Result<std::unique_ptr<Navigator>> {
    const nb::gil_scoped_acquire gil;
    try {
      return std::make_unique<PythonNavigator>(held->get()(), name, failure);
    } catch (nb::python_error& error) {
      failure->keep(std::move(error), "navigator '" + name + "'");
      return fail(ErrorCode::kUsage, "the navigator cannot be made");
    }
  };
  NavigatorChoice choice;
  choice.info = std::make_shared<const NavigatorInfo>(std::move(info));
  choice.text = name;
  return choice;
}

}  // namespace fulbito::python
