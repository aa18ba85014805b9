#include "apps/tournament/tune_chart.hpp"

#include <fmt/format.h>

#include "fulbito/detail/line_chart.hpp"

namespace fulbito::app {

Result<void> writeTuneChart(const TunePlan& plan, const TuneOutcome& outcome, const std::string& file) {
  const std::vector<TunePoint> path = pathOf(plan.spsa, outcome.results);
  LineChart chart;
  chart.title = "Tuning of " + plan.team.stem;
  chart.caption = fmt::format(
      "SPSA, {} pairs of matches per iteration, seed {}; 0 is a parameter's least value, 1 its "
      "largest one.",
      plan.base.pairs, plan.base.seed);
  chart.x_axis = "iteration";
  chart.y_axis = "value, as share of its range";
  for (std::size_t i = 0; i < plan.spsa.parameters.size(); ++i) {
    ChartLine line{plan.spsa.parameters[i].name, {}};
    for (std::size_t k = 0; k < path.size(); ++k) line.points.push_back({static_cast<double>(k), path[k][i]});
    chart.lines.push_back(std::move(line));
  }
  const auto canvas = drawLineChart(chart);
  if (!canvas) return tl::unexpected<Error>(canvas.error());
  return canvas->writePng(file);
}

}  // namespace fulbito::app
