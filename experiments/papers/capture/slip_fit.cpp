#include "experiments/papers/capture/slip_fit.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <Eigen/Dense>

#include "experiments/papers/capture/paper_tables.hpp"

namespace fulbito::capture {
namespace {

using Terms = std::function<Eigen::Vector2d(const DrivenRadius&)>;

/// Least squares of driven - commanded over two terms; a term that is always 0 gets the coefficient 0.
SlipFit fit(std::span<const DrivenRadius> radii, const Terms& terms) {
  Eigen::MatrixXd model(static_cast<Eigen::Index>(radii.size()), 2);
  Eigen::VectorXd gains(static_cast<Eigen::Index>(radii.size()));
  for (std::size_t i = 0; i < radii.size(); ++i) {
    model.row(static_cast<Eigen::Index>(i)) = terms(radii[i]);
    gains(static_cast<Eigen::Index>(i)) = radii[i].driven - radii[i].commanded;
  }
  const Eigen::Vector2d found = model.completeOrthogonalDecomposition().solve(gains);
  const Eigen::VectorXd rest = gains - model * found;
  return {found(0), found(1), std::sqrt(rest.squaredNorm() / static_cast<double>(radii.size())),
          rest.cwiseAbs().maxCoeff()};
}

}  // namespace

SlipFit fitWidening(std::span<const DrivenRadius> radii) {
  return fit(radii, [](const DrivenRadius& r) { return Eigen::Vector2d(r.speed, r.speed * r.speed); });
}

SlipFit fitLinearWidening(std::span<const DrivenRadius> radii) {
  return fit(radii, [](const DrivenRadius& r) { return Eigen::Vector2d(r.speed, 0.0); });
}

SlipFit fitUndersteer(std::span<const DrivenRadius> radii) {
  return fit(radii,
             [](const DrivenRadius& r) { return Eigen::Vector2d(0.0, r.commanded * r.speed * r.speed); });
}

std::vector<DrivenRadius> radiiOfTable5() {
  std::vector<DrivenRadius> radii;
  radii.reserve(PaperTables::kSpeeds.size());
  for (std::size_t i = 0; i < PaperTables::kSpeeds.size(); ++i)
    radii.push_back({PaperTables::kSpeeds[i], PaperTables::kSingleRadius, PaperTables::kSingle[i].radius});
  return radii;
}

std::vector<DrivenRadius> radiiOfTable6() {
  std::vector<DrivenRadius> radii;
  for (std::size_t i = 0; i < PaperTables::kSpeeds.size(); ++i) {
    radii.push_back({PaperTables::kSpeeds[i], PaperTables::kDoubleRadius, PaperTables::kDouble[i].radius1});
    radii.push_back({PaperTables::kSpeeds[i], PaperTables::kDoubleRadius, PaperTables::kDouble[i].radius2});
  }
  return radii;
}

std::vector<DrivenRadius> publishedRadii() {
  std::vector<DrivenRadius> radii = radiiOfTable5();
  for (const DrivenRadius& radius : radiiOfTable6()) radii.push_back(radius);
  return radii;
}

SlipFit judgedOn(const SlipFit& law, std::span<const DrivenRadius> radii) {
  SlipFit judged{law.tau0, law.tau1, 0.0, 0.0};
  for (const DrivenRadius& radius : radii) {
    const double v = radius.speed;
    const double off = radius.driven - radius.commanded - law.tau0 * v - law.tau1 * v * v;
    judged.rms += off * off / static_cast<double>(radii.size());
    judged.worst = std::max(judged.worst, std::abs(off));
  }
  judged.rms = std::sqrt(judged.rms);
  return judged;
}

}  // namespace fulbito::capture
