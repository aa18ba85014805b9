// Private header of replays/render: not installed.
#pragma once

#include <string>
#include <vector>

#include "replays/render/field_picture.hpp"
#include "replays/render/field_view.hpp"

namespace fulbito {

/// The panel beside the field: a row for each path and a key of the marks that the picture contains.
class Legend {
 public:
  /// `unit` as in FieldView. Refers to `picture`.
  Legend(const FieldPicture& picture, double unit) : picture_(picture), unit_(unit) {}

  double width() const;   ///< [px]
  double height() const;  ///< [px] that the rows need
  /// Draws it with its upper left corner at `corner`, over `height` pixels.
  void draw(const FieldView& view, Vec2 corner, double height) const;

 private:
  void drawPathRow(const FieldView& view, Vec2 corner, std::size_t index) const;

  const FieldPicture& picture_;
  double unit_;
};

}  // namespace fulbito
