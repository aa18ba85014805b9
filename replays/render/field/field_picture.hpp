#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/core/models/field_geometry.hpp"
#include "engine/core/models/layout.hpp"
#include "engine/core/models/robot_model.hpp"
#include "replays/render/canvas/canvas.hpp"

namespace fulbito {

/// One robot's way across the field, for a picture.
struct DrawnPath {
  std::string label;               ///< legend, e.g. "bezier"
  std::string remark;              ///< legend, e.g. "1.94 s, 1.68 m" or "collided"
  std::vector<Vec2> points;        ///< [m] real positions, tick by tick
  std::vector<Pose2> footprints;   ///< poses at which the body is outlined, may be empty
  bool failed = false;             ///< drawn dashed, with a cross at its end unless it `arrived`
  bool arrived = false;            ///< a failed one that came to the goal all the same: no cross there
  std::vector<Vec2> touches = {};  ///< [m] where it touched something; each gets a mark
  std::optional<std::size_t> colour = std::nullopt;  ///< of seriesColour; its own place unless given
  bool hollow = false;  ///< drawn with a dark core: of two paths of one colour the other variant
};

/// Arrows of a heading field.
struct FieldArrows {
  std::string label;          ///< legend
  double length = 0.02;       ///< [m] of each
  std::vector<Pose2> places;  ///< their middles
};

/// A part of the field.
struct FieldWindow {
  Vec2 low, high;  ///< [m] its lower left and upper right corner
};

/// Field, obstacles (moving ones with their path), start, goal, paths and a legend.
struct FieldPicture {
  std::string title;
  std::string caption;  ///< below the title, in as many lines as it needs; may be empty
  FieldGeometry field;
  RobotModel robot;
  Layout layout;
  std::vector<DrawnPath> paths;
  FieldArrows arrows;
  std::optional<FieldWindow> window;  ///< only this part is shown; else the whole field
  int pixels_per_metre = 600;
};

/// Draws it, larger than what it shows of the field: with a header, a scale bar and a legend that is as tall
/// as it needs. Paths that leave the field are cut at its outer edge. Errors: kIo as Canvas; kBadInput for an
/// inconsistent field; kUsage when `pixels_per_metre` is below 1 or makes the picture too large, or for an
/// empty window.
Result<Canvas> drawFieldPicture(const FieldPicture& picture);

}  // namespace fulbito
