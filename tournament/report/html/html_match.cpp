#include <algorithm>

#include <fmt/format.h>

#include "engine/core/base/xml_text.hpp"
#include "tournament/report/html/html_parts.hpp"
#include "tournament/report/match_report.hpp"

namespace fulbito {
namespace {

/// The bar of a sequential test: from the lower bound (fail) to the upper bound (pass).
std::string testBar(const Sprt& sprt) {
  const double low = sprt.bounds().lower(), high = sprt.bounds().upper();
  const auto place = [&](double ratio) {
    return 1000.0 * (std::clamp(ratio, low, high) - low) / (high - low);
  };
  const double zero = place(0.0), now = place(sprt.ratio());
  std::string html = fmt::format(
      "<svg viewBox=\"0 0 1000 24\" preserveAspectRatio=\"none\" role=\"img\" aria-label=\"log-likelihood "
      "ratio "
      "{:.2f}, between {:.2f} (fail) and {:.2f} (pass)\">",
      sprt.ratio(), low, high);
  html += fmt::format(
      "<rect class=\"room\" width=\"1000\" height=\"24\"/><rect class=\"{}\" x=\"{:.1f}\" width=\"{:.1f}\" "
      "height=\"24\"/><rect class=\"mark\" x=\"{:.1f}\" width=\"3\" height=\"24\"/></svg>\n",
      now >= zero ? "up" : "down", std::min(zero, now), std::abs(now - zero), zero);
  html += fmt::format(
      "<p class=\"axis note\"><span>fail at {:.2f}</span><span>now {:.2f}</span><span>pass at "
      "{:.2f}</span></p>\n",
      low, sprt.ratio(), high);
  return html;
}

std::string verdictOf(const Sprt& sprt) {
  return fmt::format("<p class=\"verdict {0}\">{0}</p>\n", nameOf(sprt.verdict()));
}

}  // namespace

std::string htmlMatch(const TournamentState& state) {
  if (state.plan.format != TournamentFormat::kMatch) return {};
  const MatchFigures figures = matchFigures(state);
  std::string html = state.sprt ? verdictOf(*state.sprt) + testBar(*state.sprt) : "";
  html += "<dl>\n";
  for (const auto& [label, value] : matchLines(state, figures)) {
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escapedXml(label), escapedXml(value));
  }
  return htmlSection("wide test", matchTitle(state, figures), html + "</dl>\n");
}

}  // namespace fulbito
