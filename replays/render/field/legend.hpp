#pragma once

#include <string>
#include <vector>

#include "fulbito/picture.hpp"
#include "replays/render/field/field_view.hpp"

namespace fulbito {

/// The panel next to the field, with a row per path and a key to the marks in the picture.
class Legend {
 public:
  /// @param measure  any canvas, for measuring text
  /// @param picture  must outlive the legend
  /// @param unit  as in `FieldView`
  Legend(const Canvas& measure, const FieldPicture& picture, double unit);

  double width() const;   ///< [px]
  double height() const;  ///< height of all rows [px]
  /// Draws the panel with its upper left corner at `corner`, `height` pixels high.
  void draw(const FieldView& view, Vec2 corner, double height) const;

 private:
  /// The texts of one path: its label in lines, and its remark after the last line or below it.
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
