#pragma once

#include <string>
#include <vector>

#include "fulbito/picture.hpp"
#include "replays/render/field/field_view.hpp"

namespace fulbito {

/// The panel next to the field: a row per path, and a key of the marks in the picture.
class Legend {
 public:
  /// `unit` as in FieldView; `measure` is any canvas. Refers to `picture`.
  Legend(const Canvas& measure, const FieldPicture& picture, double unit);

  double width() const;   ///< [px]
  double height() const;  ///< [px] that the rows need
  /// Draws it with its upper left corner at `corner`, over `height` pixels.
  void draw(const FieldView& view, Vec2 corner, double height) const;

 private:
  /// The texts of one path: its label, in lines, and its remark after the last line or below.
  struct PathRow {
    std::vector<std::string> label;
    std::string remark;
    bool remark_below = false;
    double height = 0.0;  ///< [px]
  };
  PathRow pathRow(const Canvas& measure, const DrawnPath& path) const;
  void drawPathRow(const FieldView& view, Vec2 corner, std::size_t index) const;

  const FieldPicture& picture_;
  double unit_;
  std::vector<PathRow> rows_;
};

}  // namespace fulbito
