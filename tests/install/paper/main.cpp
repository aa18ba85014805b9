// Runs the experiment of a paper that is built outside of the project, with few layouts, and prints its JSON.
#include <cstdio>
#include <fulbito/report.hpp>

namespace fulbito::hybrid {
PaperExperiment experiment();
}

int main() {
  fulbito::ExperimentRequest request;
  request.settings = {{"rows", "1"}, {"gaps", "2"}, {"kinds", "1"}};
  const auto report = fulbito::runPaperExperiment(fulbito::hybrid::experiment(), request);
  if (!report) return 1;
  std::fputs(fulbito::experimentJson(*report, request).c_str(), stdout);
  return 0;
}
