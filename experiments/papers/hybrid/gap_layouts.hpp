#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "fulbito/models.hpp"

namespace fulbito::hybrid {

/// What a gap is made of.
enum class GapKind {
  kDiscs,    ///< radii of 15 to 100 mm, each drawn
  kBoxes,    ///< squares of 30 to 150 mm, turned by any angle
  kDoorway,  ///< two walls of 10 to 80 mm
  kMixed,    ///< any of these on each side
};
inline constexpr std::array kGapKinds{GapKind::kDiscs, GapKind::kBoxes, GapKind::kDoorway, GapKind::kMixed};
/// Name as in results: discs, boxes, doorway, mixed.
std::string_view nameOf(GapKind kind);

/// A barrier across the field with one gap of `widths` robot widths: the least distance between the two
/// bodies beside it. Drawn are the bodies, how far they stand out of line, the barrier's angle up to 20
/// degrees, its place, the start 30 to 55 cm before it with a heading within 29 degrees of the goal, and the
/// goal. Slits between other bodies have 0.4 widths. A pure function of its arguments.
Layout gapOfKind(GapKind kind, std::uint64_t seed, std::uint64_t index, double widths);

}  // namespace fulbito::hybrid
