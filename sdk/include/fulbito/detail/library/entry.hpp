// A team or navigators as the table of a shared library. `fulbito/team.hpp` includes this after its classes.
#include "fulbito/team.hpp"

// A guard, as `fulbito/team.hpp` includes this before an `#include` of this alone comes here.
#ifndef FULBITO_LIBRARY_ENTRY_HPP
#define FULBITO_LIBRARY_ENTRY_HPP

#include <array>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fulbito/detail/library/c_values.hpp"
#include "fulbito/team.h"

namespace fulbito::team {
// Hidden: otherwise two libraries with a class of the same name would share the static variables below.
#pragma GCC visibility push(hidden)
namespace detail {

/// Description of a team or navigator as structures of the C interface; it keeps the texts alive.
struct Description {
  explicit Description(const Described& described)
      : name(described.name()), summary(described.summary()), parameters(described.parameters()) {
    for (const Parameter& parameter : parameters) {
      choices.emplace_back();
      for (const std::string& choice : parameter.choices) choices.back().push_back(choice.c_str());
    }
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const Parameter& p = parameters[i];
      table.push_back({p.name.c_str(), p.unit.c_str(), p.doc.c_str(), choices[i].data(),
                       static_cast<std::uint32_t>(choices[i].size()), static_cast<std::uint32_t>(p.type),
                       p.default_value, p.minimum, p.maximum});
    }
  }
  explicit Description(const Team& team) : Description(static_cast<const Described&>(team)) {
    version = team.version(), navigator = team.defaultNavigator();
  }
  explicit Description(const Navigator& method) : Description(static_cast<const Described&>(method)) {
    source = method.source(), plans_speed = method.plansSpeed() ? 1 : 0;
  }
  std::string name, version, summary, navigator, source;
  std::uint32_t plans_speed = 0;
  std::vector<Parameter> parameters;
  std::vector<std::vector<const char*>> choices;
  std::vector<fulbito_parameter> table;
};

/// A team behind the C interface.
struct Instance {
  const fulbito_host* host;
  std::unique_ptr<Team> team;
  Observation seen;                     ///< observation of the present tick
  std::vector<std::string> navigators;  ///< names from the last `begin` on
};

inline void logTo(const fulbito_host* host, std::string_view line) {
  host->log(host, std::string(line).c_str());
}

/// Runs `call`; an exception becomes a line of the log and a failure.
template <typename Self = Instance, typename Call>
std::int32_t guarded(void* self, const Call& call) {
  Self& instance = *static_cast<Self*>(self);
  try {
    return call(instance);
  } catch (const std::exception& error) {
    logTo(instance.host, std::string("exception: ") + error.what());
  } catch (...) {
    logTo(instance.host, "an exception of an unknown type");
  }
  return 1;
}

/// An object of the class `T` with its parameters set.
template <typename T>
std::unique_ptr<T> made(const fulbito_host* host, const double* values) {
  auto object = std::make_unique<T>();
  object->logTo([host](std::string_view line) { logTo(host, line); });
  for (std::size_t i = 0; i < object->parameters().size(); ++i) object->parameters()[i].set(values[i]);
  return object;
}

template <typename T>
std::unique_ptr<Instance> makeInstance(const fulbito_host* host, const double* values,
                                       const char* navigator) {
  auto instance = std::make_unique<Instance>();
  instance->host = host;
  instance->team = made<T>(host, values);
  Team& team = *instance->team;
  if (navigator != nullptr) team.set("navigator", navigator);
  return instance;
}

/// Passes the object that `make` creates to the caller; null after an exception, which becomes a line of the
/// log.
template <typename Make>
void* released(const fulbito_host* host, const Make& make) {
  try {
    return make().release();
  } catch (const std::exception& error) {
    logTo(host, error.what());
  } catch (...) {
    logTo(host, "an exception of an unknown type");
  }
  return nullptr;
}

template <typename T>
void* create(const fulbito_host* host, const double* values, const char* navigator) {
  return released(host, [&] { return makeInstance<T>(host, values, navigator); });
}

inline void destroy(void* self) { delete static_cast<Instance*>(self); }

inline std::int32_t begin(void* self, const fulbito_match_info* info) {
  return guarded(self, [&](Instance& instance) {
    Info known = from<Info>(*info);
    const void* text = instance.host->get_extension(instance.host, FULBITO_EXT_RULES_TEXT);
    if (text != nullptr) known.rules.text = static_cast<const char*>(text);
    takeCurveWidening(*instance.host, known.robot);
    instance.seen = {};
    instance.team->start(known);
    instance.navigators = instance.team->navigators();
    return 0;
  });
}

inline std::int32_t decide(void* self, const fulbito_observation* seen, fulbito_team_command* command) {
  return guarded(self, [&](Instance& instance) {
    put(*seen, instance.seen);
    give(instance.team->decide(instance.seen), seen->team_size, *command);
    return 0;
  });
}

inline const char* navigatorName(void* self, std::uint32_t index) {
  const Instance& instance = *static_cast<Instance*>(self);
  return index < instance.navigators.size() ? instance.navigators[index].c_str() : nullptr;
}

inline std::int32_t place(void* self, const fulbito_placement_request* request, fulbito_placement* out) {
  return guarded(self, [&](Instance& instance) {
    if (const auto placement = instance.team->place(from<PlacementRequest>(*request))) give(*placement, *out);
    return 0;
  });
}

inline std::int32_t stopped(void* self, const fulbito_stop* stop) {
  return guarded(self, [&](Instance& instance) {
    instance.team->stopped({from<Call>(stop->cause), from<Observation>(stop->now)});
    return 0;
  });
}

inline std::int32_t ready(void* self, const fulbito_observation* seen) {
  return guarded(self, [&](Instance& instance) {
    instance.team->ready(from<Observation>(*seen));
    return 0;
  });
}

inline std::int32_t ended(void* self, const fulbito_end* end) {
  return guarded(self, [&](Instance& instance) {
    instance.team->ended(from<End>(*end));
    return 0;
  });
}

inline std::int32_t exercise(void* self, const fulbito_observation* seen, const fulbito_exercise* task,
                             fulbito_team_command* command, fulbito_vec2* answer) {
  return guarded(self, [&](Instance& instance) -> std::int32_t {
    put(*seen, instance.seen);
    const auto reply = instance.team->exercise(instance.seen, from<Exercise>(*task));
    if (!reply) return FULBITO_NO_SKILL;
    give(reply->commands, seen->team_size, *command);
    *answer = to(reply->answer);
    return 0;
  });
}

inline const void* extension(const char* name) {
  static constexpr fulbito_navigator_names kNames{navigatorName};
  static constexpr fulbito_restarts kRestarts{place, stopped, ready, ended};
  static constexpr fulbito_exercises kExercises{exercise};
  const std::string_view wanted = name;
  if (wanted == FULBITO_EXT_NAVIGATOR_NAMES) return &kNames;
  if (wanted == FULBITO_EXT_RESTARTS) return &kRestarts;
  if (wanted == FULBITO_EXT_EXERCISES) return &kExercises;
  return nullptr;
}

/// The table of a library with the team `T`; null if its constructor throws.
template <typename T>
const fulbito_library* libraryOf() try {
  static const Description description{T{}};
  static const fulbito_library library{
      FULBITO_ABI,
      sizeof(fulbito_library),
      description.name.c_str(),
      description.version.c_str(),
      description.summary.c_str(),
      description.table.data(),
      static_cast<std::uint32_t>(description.table.size()),
      0,
      description.navigator.empty() ? nullptr : description.navigator.c_str(),
      create<T>,
      destroy,
      begin,
      decide,
      extension};
  return &library;
} catch (...) {
  return nullptr;
}

/// A navigator behind the C interface.
struct Guide {
  const fulbito_host* host;
  std::unique_ptr<Navigator> method;
  NavigationScene scene;           ///< scene of the present tick
  Guidance guidance;               ///< guidance of the present tick
  std::vector<fulbito_vec2> path;  ///< points of the guidance's path
};

inline void take(const fulbito_scene& from_scene, const fulbito_host& host, NavigationScene& to) {
  const fulbito_scene& s = from_scene;
  to.tick = s.tick;
  to.dt = s.dt;
  put(s.self, to.self);
  put(s.goal, to.goal);
  to.goal_heading = s.has_heading != 0 ? std::optional(s.goal_heading) : std::nullopt;
  to.tolerance = s.tolerance;
  to.heading_tolerance = s.heading_tolerance;
  to.stop = s.stop != 0;
  to.obstacles.clear();
  for (std::uint64_t i = 0; i < s.obstacle_count; ++i)
    to.obstacles.push_back(
        {from<Vec2>(s.obstacles[i].position), from<Vec2>(s.obstacles[i].velocity), s.obstacles[i].radius});
  put(*s.field, to.field);
  put(*s.robot, to.robot);
  takeCurveWidening(host, to.robot);
}

inline void give(Guide& guide, fulbito_guidance& out) {
  const Guidance& guidance = guide.guidance;
  if (guidance.kind == Guidance::Kind::kTimedPath && guidance.speeds.size() < guidance.path.size())
    throw std::length_error("a path has more points than speeds");
  guide.path.clear();
  for (const Vec2 point : guidance.path) guide.path.push_back(to(point));
  out.kind = static_cast<std::uint32_t>(guidance.kind);
  out.point_count = static_cast<std::uint32_t>(guide.path.size());
  out.path = guide.path.data();
  out.speeds = guidance.speeds.data();
  out.revision = guidance.revision;
  out.wheels = {guidance.wheels.left, guidance.wheels.right};
  out.speed_cap = guidance.speed_cap;
}

template <typename N>
void* createGuide(const fulbito_host* host, const double* values) {
  return released(host, [&] {
    auto guide = std::make_unique<Guide>();
    guide->host = host;
    guide->method = made<N>(host, values);
    return guide;
  });
}

inline void destroyGuide(void* self) { delete static_cast<Guide*>(self); }

inline void resetGuide(void* self) {
  guarded<Guide>(self, [](Guide& guide) {
    guide.method->reset();
    return 0;
  });
}

inline std::int32_t planGuide(void* self, const fulbito_scene* scene, fulbito_guidance* guidance) {
  return guarded<Guide>(self, [&](Guide& guide) {
    take(*scene, *guide.host, guide.scene);
    guide.guidance.speed_cap = guidance->speed_cap;
    guide.method->plan(guide.scene, guide.guidance);
    give(guide, *guidance);
    return 0;
  });
}

inline double headingOfGuide(void* self, fulbito_vec2 point) {
  double heading = std::numeric_limits<double>::quiet_NaN();
  guarded<Guide>(self, [&](Guide& guide) {
    heading = guide.method->heading(from<Vec2>(point));
    return 0;
  });
  return heading;
}

template <typename N>
const Description& descriptionOf() {
  static const Description description{N{}};
  return description;
}

template <typename N>
fulbito_navigator navigatorOf() {
  const Description& d = descriptionOf<N>();
  return {d.name.c_str(),
          d.summary.c_str(),
          d.source.c_str(),
          d.table.data(),
          static_cast<std::uint32_t>(d.table.size()),
          d.plans_speed,
          createGuide<N>,
          destroyGuide,
          resetGuide,
          planGuide,
          headingOfGuide};
}

/// The extension that lists the navigators `N`.
template <typename... N>
const void* navigatorsOf(const char* name) {
  static const std::array<fulbito_navigator, sizeof...(N)> table{navigatorOf<N>()...};
  static const fulbito_navigators navigators{table.data(), static_cast<std::uint32_t>(table.size()), 0};
  return std::string_view(name) == FULBITO_EXT_NAVIGATORS ? &navigators : nullptr;
}

/// The table of a library with the navigators `First` and `N`, without a team; null if a constructor throws.
template <typename First, typename... N>
const fulbito_library* navigatorLibraryOf() try {
  const Description& first = descriptionOf<First>();
  navigatorsOf<First, N...>("");
  static const fulbito_library library{FULBITO_ABI,
                                       sizeof(fulbito_library),
                                       first.name.c_str(),
                                       nullptr,
                                       first.summary.c_str(),
                                       nullptr,
                                       0,
                                       0,
                                       nullptr,
                                       nullptr,
                                       nullptr,
                                       nullptr,
                                       nullptr,
                                       navigatorsOf<First, N...>};
  return &library;
} catch (...) {
  return nullptr;
}

}  // namespace detail
#pragma GCC visibility pop
}  // namespace fulbito::team

#endif  // FULBITO_LIBRARY_ENTRY_HPP
