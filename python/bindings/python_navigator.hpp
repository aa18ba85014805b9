#pragma once

#include <nanobind/nanobind.h>

#include "fulbito/navigation.hpp"
#include "python/bindings/python_calls.hpp"

namespace fulbito::python {

/// A navigator of this process: a class or function that makes one per robot, with `reset` and `plan` like
/// fulbito.navigation.Navigator. After its first exception, which `failure` keeps, robots stand still. Needs
/// the GIL.
NavigatorChoice navigatorFrom(nanobind::handle factory, const std::string& name, bool plans_speed,
                              const SharedFailure& failure);

}  // namespace fulbito::python
