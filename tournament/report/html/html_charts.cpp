#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "engine/core/base/xml_text.hpp"
#include "tournament/report/html/html_parts.hpp"
#include "tournament/report/sections.hpp"
#include "tournament/report/shown_text.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kMostBars = 100;
constexpr std::size_t kMostLines = 10;

/// The range of the rating axis: the largest rating on either side of 0, rounded up to a step of the axis
/// [Elo], at most `kMostShownElo`.
class Reach {
 public:
  void take(double elo) {
    if (std::isfinite(elo)) most_ = std::max(most_, std::abs(elo));
  }
  double elo() const { return std::clamp(kStep * std::ceil(most_ / kStep), kStep, kMostShownElo); }

 private:
  static constexpr double kStep = 100.0;
  double most_ = 0.0;
};

std::vector<std::size_t> bestRated(const TournamentTable& table, std::size_t most) {
  std::vector<std::size_t> order = ranking(table);
  std::erase_if(order, [&](std::size_t entrant) { return table.totals[entrant].pairs == 0; });
  std::stable_sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) {
    return table.ratings.elo[x].value > table.ratings.elo[y].value;
  });
  order.resize(std::min(order.size(), most));
  return order;
}

std::string barOf(const Interval& elo, double reach) {
  const auto place = [reach](double value) { return 500.0 + 500.0 * std::clamp(value / reach, -1.0, 1.0); };
  const double low = place(elo.low), high = place(elo.high);
  return fmt::format(
      "<svg viewBox=\"0 0 1000 20\" preserveAspectRatio=\"none\" aria-hidden=\"true\"><rect class=\"zero\" "
      "x=\"499\" width=\"2\" height=\"20\"/><rect class=\"span\" x=\"{:.1f}\" y=\"5\" width=\"{:.1f}\" "
      "height=\"10\"/><rect class=\"mark\" x=\"{:.1f}\" width=\"6\" height=\"20\"/></svg>",
      low, high - low, place(elo.value) - 3.0);
}

/// A line of the chart of ratings over time.
struct CourseLine {
  std::string points;
  double end = 0.0;    // y of the line's last point
  double label = 0.0;  // y of the label
  std::string name;    // name of the team, escaped
};

/// Layout of the chart of ratings over time [px].
struct CourseFrame {
  static constexpr double kLeft = 48, kRight = 640, kTop = 12, kBottom = 300, kLabelHeight = 17;
  double reach = 100.0;
  std::size_t steps = 1;

  double x(std::size_t step) const {
    return steps < 2 ? kRight
                     : kLeft + (kRight - kLeft) * static_cast<double>(step) / static_cast<double>(steps - 1);
  }
  double y(double elo) const {
    return (kTop + kBottom) / 2 - (kBottom - kTop) / 2 * std::clamp(elo / reach, -1.0, 1.0);
  }
};

CourseLine lineOf(const CourseFrame& frame, const std::vector<double>& course, const std::string& name) {
  CourseLine line;
  line.name = escapedXml(name);
  for (std::size_t step = 0; step < course.size(); ++step) {
    if (!std::isfinite(course[step])) continue;
    line.end = line.label = frame.y(course[step]);
    line.points += fmt::format("{}{:.1f},{:.1f}", line.points.empty() ? "" : " ", frame.x(step), line.end);
  }
  return line;
}

/// Moves labels apart, in the order of their lines' ends, and back into the frame.
void spreadLabels(std::vector<CourseLine>& lines) {
  std::vector<CourseLine*> order;
  order.reserve(lines.size());
  for (CourseLine& line : lines) order.push_back(&line);
  std::stable_sort(order.begin(), order.end(), [](auto* a, auto* b) { return a->end < b->end; });
  double next = CourseFrame::kTop;
  for (CourseLine* line : order) {
    line->label = std::max(line->label, next);
    next = line->label + CourseFrame::kLabelHeight;
  }
  double room = CourseFrame::kBottom;
  for (auto at = order.rbegin(); at != order.rend(); ++at) {
    (*at)->label = std::min((*at)->label, room);
    room = (*at)->label - CourseFrame::kLabelHeight;
  }
}

std::string axisOf(const CourseFrame& frame) {
  std::string html;
  for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    const double elo = share * frame.reach, y = frame.y(elo);
    html += fmt::format(
        "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/><text x=\"{3}\" y=\"{4:.1f}\" "
        "text-anchor=\"end\">{5}</text>",
        CourseFrame::kLeft, CourseFrame::kRight, y, CourseFrame::kLeft - 6, y + 4,
        elo == 0.0 ? "0" : fmt::format("{:+.0f}", elo));
  }
  return html + fmt::format(
                    "<text x=\"{}\" y=\"322\">first matches</text><text x=\"{}\" y=\"322\" "
                    "text-anchor=\"end\">last</text>\n",
                    CourseFrame::kLeft, CourseFrame::kRight);
}

std::string drawn(const CourseLine& line, std::size_t colour) {
  // An edge makes thin light lines visible on a light page; dashes tell lines apart without colours.
  const char* dash = colour % 2 == 1 ? " stroke-dasharray=\"9 4\"" : "";
  return fmt::format(
      "<polyline class=\"halo\" points=\"{0}\"/><polyline class=\"c{1}\"{2} points=\"{0}\"/>"
      "<line x1=\"{3}\" y1=\"{4:.1f}\" x2=\"{5}\" y2=\"{6:.1f}\"/><rect class=\"c{1}\" x=\"{5}\" "
      "y=\"{7:.1f}\" "
      "width=\"9\" height=\"9\"/><text class=\"name\" direction=\"ltr\" x=\"{8}\" "
      "y=\"{9:.1f}\">{10}</text>\n",
      line.points, colour, dash, CourseFrame::kRight, line.end, CourseFrame::kRight + 16, line.label,
      line.label - 4.5, CourseFrame::kRight + 31, line.label + 4.5, line.name);
}

std::vector<CourseLine> linesOf(const TournamentState& state, const TournamentTable& table,
                                const std::vector<std::size_t>& best) {
  constexpr int kLabelColumns = 16;
  Reach reach;
  CourseFrame frame;
  for (const std::size_t entrant : best) {
    for (const double elo : table.course[entrant]) reach.take(elo);
    frame.steps = std::max(frame.steps, table.course[entrant].size());
  }
  frame.reach = reach.elo();
  std::vector<CourseLine> lines;
  lines.reserve(best.size());
  for (const std::size_t entrant : best) {
    lines.push_back(
        lineOf(frame, table.course[entrant], shownText(state.plan.entrants[entrant].name, kLabelColumns)));
  }
  spreadLabels(lines);
  lines.push_back({axisOf(frame), 0.0, 0.0, {}});
  return lines;
}

std::string tieSide(const TournamentState& state, const KnockOutTie& tie,
                    const std::optional<std::size_t>& entrant, double points) {
  const std::string name = entrant ? shownName(state, *entrant) : tie.decided_by == "bye" ? "bye" : "open";
  const bool won = entrant && tie.winner == entrant;
  const bool played = tie.points_a + tie.points_b > 0.0;
  return fmt::format("<p{}><bdi>{}</bdi><span>{}</span></p>", won ? " class=\"won\"" : "", escapedXml(name),
                     played ? fmt::format("{:g}", points) : "");
}

std::string tieOf(const TournamentState& state, const KnockOutTie& tie) {
  std::string html = "<li class=\"tie\">" + tieSide(state, tie, tie.a, tie.points_a) +
                     tieSide(state, tie, tie.b, tie.points_b);
  std::string note = tie.third_place ? "third place" : "";
  if (!tie.decided_by.empty() && tie.decided_by != "bye") {
    note += fmt::format("{}goals {}:{}, by {}", note.empty() ? "" : ", ", tie.goals_a, tie.goals_b,
                        escapedXml(tie.decided_by));
  }
  if (!note.empty()) html += "<small>" + note + "</small>";
  return html + "</li>\n";
}

}  // namespace

std::string htmlRatings(const TournamentState& state, const TournamentTable& table) {
  const std::vector<std::size_t> best = bestRated(table, kMostBars);
  if (best.empty()) return {};
  Reach reach;
  for (const std::size_t entrant : best) {
    for (const double elo : {table.ratings.elo[entrant].low, table.ratings.elo[entrant].high})
      reach.take(elo);
  }
  std::string html = fmt::format(
      "<table class=\"bars\"><thead><tr><th scope=\"col\">team</th><th scope=\"col\" class=\"bar\"><span "
      "class=\"axis\"><span>{:+.0f}</span><span>0</span><span>{:+.0f}</span></span></th><th scope=\"col\" "
      "class=\"n\">Elo (95 %)</th></tr></thead>\n<tbody>\n",
      -reach.elo(), reach.elo());
  for (const std::size_t entrant : best) {
    const Interval& elo = table.ratings.elo[entrant];
    html += fmt::format(
        "<tr><th scope=\"row\"><bdi>{}</bdi></th><td class=\"bar\">{}</td><td class=\"n\">{}</td></tr>\n",
        escapedXml(shownName(state, entrant)), barOf(elo, reach.elo()), escapedXml(eloText(elo)));
  }
  return htmlSection("", "Ratings", htmlScroll("Ratings", html + "</tbody></table>\n"));
}

std::string htmlCourse(const TournamentState& state, const TournamentTable& table) {
  const std::vector<std::size_t> best = bestRated(table, kMostLines);
  if (best.empty() || table.course[best[0]].size() < 2) return {};
  const std::vector<CourseLine> lines = linesOf(state, table, best);
  std::string html =
      "<svg viewBox=\"0 0 800 330\" role=\"img\" aria-label=\"Elo after each part of the tournament\">\n" +
      lines.back().points;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) html += drawn(lines[i], i);
  const std::string note = best.size() < table.standings.size()
                               ? fmt::format("<p class=\"note\">The {} best-rated teams.</p>\n", best.size())
                               : "";
  return htmlSection("course", "Rating over time [Elo]",
                     htmlScroll("Rating over time", html + "</svg>\n") + note);
}

std::string htmlBracket(const TournamentState& state, const TournamentTable& table) {
  if (table.bracket.empty()) return {};
  std::string html = "<div class=\"bracket\">\n";
  std::optional<int> round;
  for (const KnockOutTie& tie : table.bracket) {
    if (round != tie.round) {
      if (round) html += "</ol></div>\n";
      html += fmt::format("<div class=\"round\"><h3>{}</h3><ol>\n",
                          nameOfRound(tie.round, state.plan.entrants.size()));
    }
    round = tie.round;
    html += tieOf(state, tie);
  }
  return htmlSection("wide", "Bracket", htmlScroll("Bracket", html + "</ol></div>\n</div>\n"));
}

}  // namespace fulbito
