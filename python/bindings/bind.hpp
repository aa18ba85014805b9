#pragma once

#include <nanobind/nanobind.h>

namespace fulbito::python {

/// @{ Each adds the functions and classes of one subject to the module fulbito._core.
void bindInfo(nanobind::module_& m);
void bindAgent(nanobind::module_& m);
void bindWindow(nanobind::module_& m);
void bindEnvironments(nanobind::module_& m);
void bindMatchSource(nanobind::module_& m);
void bindVector(nanobind::module_& m);
void bindPlay(nanobind::module_& m);
void bindRecording(nanobind::module_& m);
void bindWorld(nanobind::module_& m);
void bindCompare(nanobind::module_& m);
void bindDrillSource(nanobind::module_& m);
void bindNavigationSource(nanobind::module_& m);
/// @}

}  // namespace fulbito::python
