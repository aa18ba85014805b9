#include "apps/teams/junit.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "engine/core/base/xml_text.hpp"

namespace fulbito::app {
namespace {

std::string caseOf(const TeamCheck& check) {
  const std::string name = escapedXml(check.name), finding = escapedXml(check.finding);
  const std::string inside =
      check.verdict == CheckVerdict::kFailed
          ? fmt::format("<failure message=\"{}\"/>", finding)
          : fmt::format("<system-out>{}: {}</system-out>", nameOf(check.verdict), finding);
  return fmt::format("  <testcase classname=\"check-team\" name=\"{}\">{}</testcase>\n", name, inside);
}

}  // namespace

std::string junitOf(const TeamReport& report) {
  const auto failures = std::count_if(report.checks.begin(), report.checks.end(), [](const TeamCheck& check) {
    return check.verdict == CheckVerdict::kFailed;
  });
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  xml += fmt::format("<testsuite name=\"check-team {}\" tests=\"{}\" failures=\"{}\">\n",
                     escapedXml(report.team), report.checks.size(), failures);
  for (const TeamCheck& check : report.checks) xml += caseOf(check);
  return xml + "</testsuite>\n";
}

}  // namespace fulbito::app
