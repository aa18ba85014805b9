#pragma once

#include "fulbito/report.hpp"

namespace fulbito {

/// Draws scenes of experiments: the field, reference paths, trails, bodies, drawings and a legend.
class ScenePicture {
 public:
  /// @param width  [px] width of the field with its walls
  ScenePicture(const ReportScene& scene, double width) : scene_(&scene), width_(width) {}

  /// Draws all bodies at `row` of the scene with their trails up to it, and the drawings shown at that time.
  /// Errors: as Canvas::create.
  Result<Canvas> draw(std::size_t row) const;
  /// Draws the whole scene: complete trails, with outlines of the bodies along them.
  Result<Canvas> drawWhole() const;

 private:
  Result<Canvas> draw(std::size_t row, bool whole) const;

  const ReportScene* scene_;
  double width_;
};

}  // namespace fulbito
