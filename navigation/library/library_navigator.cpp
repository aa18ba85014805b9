#include "navigation/library/library_navigator.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

#include <fmt/format.h>

#include "engine/core/config/suggest.hpp"
#include "navigation/library/plugin_host.hpp"
#include "navigation/library/plugin_parameters.hpp"
#include "navigation/library/plugin_values.hpp"

namespace fulbito {
namespace {

constexpr std::uint32_t kMostNavigators = 256;

/// The field of a library's navigator.
class LibraryField final : public HeadingField {
 public:
  LibraryField(const PluginLibrary& library, const fulbito_navigator& table, void* self)
      : library_(library), table_(table), self_(self) {}
  double heading(Vec2 p) const override {
    const double angle =
        callForeign(library_, 0.0, [&] { return table_.heading(self_, abiOf<fulbito_vec2>(p)); });
    return std::isfinite(angle) ? angle : 0.0;
  }

 private:
  const PluginLibrary& library_;
  const fulbito_navigator& table_;
  void* self_;
};

/// A navigator of a shared library. Invalid guidance stops the robot, and the first time is logged.
class LibraryNavigator final : public Navigator {
 public:
  LibraryNavigator(std::shared_ptr<const PluginLibrary> library, const fulbito_navigator& table,
                   std::unique_ptr<PluginHost> host, void* self)
      : library_(std::move(library)),
        host_(std::move(host)),
        table_(table),
        self_(self),
        field_(*library_, table, self) {}
  LibraryNavigator(const LibraryNavigator&) = delete;
  LibraryNavigator& operator=(const LibraryNavigator&) = delete;
  ~LibraryNavigator() override {
    callForeign(*library_, 0, [&] { return table_.destroy(self_), 0; });
  }

  void reset() override {
    callForeign(*library_, 0, [&] { return table_.reset(self_), 0; });
  }

  Guidance plan(const NavigationScene& scene) override {
    const fulbito_scene seen = sceneOf(scene);
    host_->know(wideningToAbi(*scene.robot));
    fulbito_guidance given{};
    given.speed_cap = std::numeric_limits<double>::infinity();
    const int32_t failed = callForeign(*library_, -1, [&] { return table_.plan(self_, &seen, &given); });
    Guidance guidance;
    if (failed != 0) return stopped("'plan' fails");
    if (const char* flaw = take(given, guidance); *flaw != '\0') return stopped(flaw);
    return guidance;
  }

 private:
  fulbito_scene sceneOf(const NavigationScene& scene) {
    obstacles_.clear();
    for (const DiscObstacle& disc : scene.obstacles) {
      obstacles_.push_back(
          {abiOf<fulbito_vec2>(disc.position), abiOf<fulbito_vec2>(disc.velocity), disc.radius});
    }
    toAbi(*scene.field, field_model_);
    toAbi(*scene.robot, robot_model_);
    const NavigationGoal& goal = scene.goal;
    return {scene.tick,
            scene.dt,
            abiOf<fulbito_robot>(scene.self),
            abiOf<fulbito_vec2>(goal.position),
            goal.heading.value_or(0.0),
            goal.tolerance,
            goal.heading_tolerance,
            goal.heading.has_value(),
            goal.stop,
            obstacles_.data(),
            obstacles_.size(),
            &field_model_,
            &robot_model_};
  }

  /// @return what is wrong with the guidance; empty: nothing
  const char* take(const fulbito_guidance& given, Guidance& guidance) {
    if (std::isnan(given.speed_cap)) return "the speed limit is no number";
    guidance.speed_cap = given.speed_cap;
    guidance.revision = given.revision;
    switch (given.kind) {
      case FULBITO_GUIDE_FIELD:
        guidance.kind = GuidanceKind::kField;
        guidance.field = &field_;
        return table_.heading == nullptr ? "it guides by a field but has no function 'heading'" : "";
      case FULBITO_GUIDE_PATH:
        guidance.kind = GuidanceKind::kPath;
        return takePath(given, guidance);
      case FULBITO_GUIDE_TIMED_PATH:
        guidance.kind = GuidanceKind::kTimedPath;
        if (const char* flaw = takePath(given, guidance); *flaw != '\0') return flaw;
        return takeSpeeds(given, guidance);
      case FULBITO_GUIDE_WHEELS:
        guidance.kind = GuidanceKind::kWheels;
        guidance.wheels = fromAbi(given.wheels);
        return std::isfinite(given.wheels.left + given.wheels.right) ? "" : "a wheel speed is not finite";
      default:
        return "the kind of guidance is unknown";
    }
  }

  const char* takePath(const fulbito_guidance& given, Guidance& guidance) {
    if (given.path == nullptr || given.point_count < 2) return "the path has less than two points";
    path_.clear();
    for (std::uint32_t i = 0; i < given.point_count; ++i) {
      path_.push_back(fromAbi(given.path[i]));
      if (!isFinite(path_.back())) return "a point of the path is not finite";
    }
    guidance.path = path_;
    return "";
  }

  const char* takeSpeeds(const fulbito_guidance& given, Guidance& guidance) {
    if (given.speeds == nullptr) return "the path has no speeds";
    speeds_.assign(given.speeds, given.speeds + given.point_count);
    for (double speed : speeds_) {
      if (!std::isfinite(speed)) return "a speed of the path is not finite";
    }
    guidance.speeds = speeds_;
    return "";
  }

  Guidance stopped(const char* why) {
    if (!complained_) host_->log(fmt::format("the robot stops: {}", why));
    complained_ = true;
    Guidance guidance;
    guidance.kind = GuidanceKind::kWheels;
    return guidance;
  }

  std::shared_ptr<const PluginLibrary> library_;
  std::unique_ptr<PluginHost> host_;
  const fulbito_navigator& table_;
  void* self_;
  LibraryField field_;
  fulbito_field field_model_{};
  fulbito_robot_model robot_model_{};
  std::vector<fulbito_disc> obstacles_;
  std::vector<Vec2> path_;
  std::vector<double> speeds_;
  bool complained_ = false;
};

std::string textOf(const char* text) { return text == nullptr ? "" : text; }

Result<std::unique_ptr<Navigator>> make(const std::shared_ptr<const PluginLibrary>& library,
                                        const fulbito_navigator& table,
                                        const std::vector<ParameterSpec>& parameters,
                                        const std::vector<Setting>& settings) {
  const std::string name = library->path() + ":" + table.name;
  const auto values = pluginValues(parameters, settings, name);
  if (!values) return tl::unexpected<Error>(values.error());
  auto host = std::make_unique<PluginHost>(name, PluginLog{});
  void* self =
      callForeign<void*>(*library, nullptr, [&] { return table.create(host->table(), values->data()); });
  if (self == nullptr) {
    return fail(ErrorCode::kUsage, fmt::format("the navigator '{}' refuses to be made{}{}", name,
                                               host->lastLine().empty() ? "" : ": ", host->lastLine()));
  }
  return std::unique_ptr<Navigator>(
      std::make_unique<LibraryNavigator>(library, table, std::move(host), self));
}

Result<std::shared_ptr<const NavigatorInfo>> describe(const std::shared_ptr<const PluginLibrary>& library,
                                                      const fulbito_navigator& table) {
  const std::string where = fmt::format("the library '{}': navigator '{}'", library->path(), table.name);
  if (table.create == nullptr || table.destroy == nullptr || table.reset == nullptr ||
      table.plan == nullptr) {
    return fail(ErrorCode::kBadInput, where + " lacks a function");
  }
  auto parameters = pluginParameters(table.parameters, table.parameter_count, where);
  if (!parameters) return tl::unexpected<Error>(parameters.error());
  NavigatorInfo info{
      table.name, textOf(table.summary), textOf(table.source), table.plans_speed != 0, *parameters, {}};
  info.make = [library, &table, parameters = std::move(*parameters)](const std::vector<Setting>& settings) {
    return make(library, table, parameters, settings);
  };
  return std::make_shared<const NavigatorInfo>(std::move(info));
}

}  // namespace

bool namesLibrary(const std::string& specification) {
  const std::string name = specification.substr(0, specification.find(':'));
  return name.find('/') != std::string::npos || name.ends_with(".so");
}

Result<std::shared_ptr<const NavigatorInfo>> libraryNavigator(
    const std::shared_ptr<const PluginLibrary>& library, const std::string& name) {
  const auto* all = library->extension<fulbito_navigators>(FULBITO_EXT_NAVIGATORS);
  if (all == nullptr || all->count == 0) {
    return fail(ErrorCode::kUsage, fmt::format("the library '{}' has no navigators", library->path()));
  }
  if (all->navigators == nullptr || all->count > kMostNavigators) {
    return fail(ErrorCode::kBadInput,
                fmt::format("the library '{}' has a wrong list of navigators", library->path()));
  }
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i < all->count; ++i) {
    const fulbito_navigator& table = all->navigators[i];
    if (textOf(table.name).empty()) {
      return fail(ErrorCode::kBadInput,
                  fmt::format("the library '{}' has a navigator without a name", library->path()));
    }
    if (table.name == name || (name.empty() && all->count == 1)) return describe(library, table);
    names.emplace_back(table.name);
  }
  return fail(ErrorCode::kUsage,
              fmt::format("the library '{}' has no navigator '{}'; it has {}.{}", library->path(), name,
                          fmt::join(names, ", "), suggestion(name, names)));
}

}  // namespace fulbito
