#pragma once

#include "fulbito/report.hpp"

namespace fulbito {

/// Draws the scenes of experiments: the field, reference paths, trails, bodies, drawings, a legend.
class ScenePicture {
 public:
  /// @param width  [px] of the field with its walls
  ScenePicture(const ReportScene& scene, double width) : scene_(&scene), width_(width) {}

  /// All bodies at `row` of the scene with their trails until then, and the drawings shown then. Errors: as
  /// Canvas::create.
  Result<Canvas> draw(std::size_t row) const;
  /// The whole scene: trails to their ends, with outlines of the bodies on the way.
  Result<Canvas> drawWhole() const;

 private:
  Result<Canvas> draw(std::size_t row, bool whole) const;

  const ReportScene* scene_;
  double width_;
};

}  // namespace fulbito
