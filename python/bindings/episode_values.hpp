#pragma once

#include <cstdint>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>
#include <optional>
#include <string>
#include <tuple>

#include "fulbito/detail/canvas.hpp"
#include "python/environments/episode_runner.hpp"

namespace fulbito::python {

/// A state as Python has it: seed and episodes of the environment's stream, seed and text of the start of the
/// present episode, if any, and the actions since as the bytes of their numbers.
using StateTuple =
    std::tuple<std::uint64_t, std::uint64_t, std::optional<std::uint64_t>, std::string, nanobind::bytes>;

StateTuple tupleOf(const EpisodeState& state);
/// Throws UsageError for actions that are no whole numbers of float32.
EpisodeState stateOf(const StateTuple& state);

using ShapeDict = nanobind::typed<nanobind::dict, nanobind::str, nanobind::any>;

/// A shape as a dict of its members.
ShapeDict dictOf(const EpisodeShape& shape);

/// The pixels of a picture: uint8, height x width x 3.
nanobind::ndarray<nanobind::numpy, std::uint8_t> pixelsOf(const Canvas& canvas);

}  // namespace fulbito::python
