#include "tournament/statistics/davidson.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr int kMostSteps = 200;

/// Slope and curvature of the log-likelihood of weighted matches, by half the lead d = (log p_a - log p_b) /
/// 2 and by log nu. The model is an exponential family, so these are means and covariances of "win minus
/// loss" and "draw".
struct Slopes {
  double lead, draw;                       ///< first derivatives
  double lead_lead, lead_draw, draw_draw;  ///< negative second derivatives
};

Slopes slopesOf(const WeightedMeeting& m, double lead, double nu) {
  const MatchChances p = davidsonChances(lead, nu);
  const double n = m.wins + m.draws + m.losses, balance = p.win - p.loss;
  return {m.wins - m.losses - n * balance, m.draws - n * p.draw, n * (p.win + p.loss - balance * balance),
          -n * balance * p.draw, n * p.draw * (1.0 - p.draw)};
}

/// The share of a Newton step that never overshoots. Along the step, the third derivative is at most `range`
/// times the second. This holds for any mean of exponentials whose exponents differ by at most `range` (T.
/// Sun and Q. Tran-Dinh, "Generalized self-concordant functions", 2019).
double dampingOf(double range) { return range > 1e-8 ? math::log(1.0 + range) / range : 1.0; }

}  // namespace

MatchChances davidsonChances(double lead, double nu) {
  // All terms are divided by e^|d|, so that nothing overflows.
  const double t = math::exp(-std::abs(lead) / 2.0);
  const double sum = 1.0 + t * t + nu * t;
  const double strong = 1.0 / sum, weak = t * t / sum;
  return {lead >= 0.0 ? strong : weak, nu * t / sum, lead >= 0.0 ? weak : strong};
}

struct DavidsonFitter::Impl {
  explicit Impl(std::vector<int> groups) : component(std::move(groups)), n(component.size()) {}

  void derive(std::span<const WeightedMeeting> meetings, std::span<const double> prior,
              const DavidsonModel& model, bool with_draws);
  void addMeeting(const WeightedMeeting& meeting, const Slopes& s);
  void addPrior(std::size_t entrant, const Slopes& s);
  void holdMeans(std::span<const double> prior, const DavidsonModel& model);
  double step(DavidsonModel& model, bool with_draws);

  std::vector<int> component;
  std::size_t n;              ///< number of entrants; parameter n is log nu
  Eigen::VectorXd gradient;   ///< gradient of the log-likelihood
  Eigen::MatrixXd curvature;  ///< negative Hessian of the log-likelihood, lower triangle
  Eigen::LLT<Eigen::MatrixXd> factors;
};

void DavidsonFitter::Impl::addMeeting(const WeightedMeeting& meeting, const Slopes& s) {
  const auto a = static_cast<Eigen::Index>(meeting.a), b = static_cast<Eigen::Index>(meeting.b);
  const auto draw = static_cast<Eigen::Index>(n);
  gradient[a] += s.lead / 2;
  gradient[b] -= s.lead / 2;
  curvature(a, a) += s.lead_lead / 4;
  curvature(b, b) += s.lead_lead / 4;
  curvature(std::max(a, b), std::min(a, b)) -= s.lead_lead / 4;
  curvature(draw, a) += s.lead_draw / 2;
  curvature(draw, b) -= s.lead_draw / 2;
  curvature(draw, draw) += s.draw_draw;
  gradient[draw] += s.draw;
}

void DavidsonFitter::Impl::addPrior(std::size_t entrant, const Slopes& s) {
  const auto i = static_cast<Eigen::Index>(entrant), draw = static_cast<Eigen::Index>(n);
  gradient[i] += s.lead / 2;
  curvature(i, i) += s.lead_lead / 4;
  curvature(draw, i) += s.lead_draw / 2;
  curvature(draw, draw) += s.draw_draw;
  gradient[draw] += s.draw;
}

/// Adds a penalty on the mean of each component without a prior. The likelihood does not depend on this mean,
/// so the penalty makes the maximum unique without moving it.
void DavidsonFitter::Impl::holdMeans(std::span<const double> prior, const DavidsonModel& model) {
  for (std::size_t i = 0; i < n; ++i) {
    if (prior[i] > 0.0) continue;
    for (std::size_t j = 0; j < n; ++j) {
      if (component[i] != component[j]) continue;
      gradient[static_cast<Eigen::Index>(i)] -= model.strength[j];
      if (j <= i) curvature(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) += 1.0;
    }
  }
}

void DavidsonFitter::Impl::derive(std::span<const WeightedMeeting> meetings, std::span<const double> prior,
                                  const DavidsonModel& model, bool with_draws) {
  const auto size = static_cast<Eigen::Index>(n + 1);
  gradient.setZero(size);
  curvature.setZero(size, size);
  const double nu = with_draws ? math::exp(model.log_draw) : 0.0;
  for (const WeightedMeeting& m : meetings) {
    addMeeting(m, slopesOf(m, model.strength[m.a] - model.strength[m.b], nu));
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (prior[i] > 0.0) addPrior(i, slopesOf({i, i, prior[i], 0.0, prior[i]}, model.strength[i], nu));
  }
  holdMeans(prior, model);
  if (!with_draws) curvature(size - 1, size - 1) = 1.0;
}

/// Does one damped Newton step. Returns the largest change that an undamped step would make to a log ratio of
/// chances.
double DavidsonFitter::Impl::step(DavidsonModel& model, bool with_draws) {
  factors.compute(curvature);
  gradient = factors.solve(gradient);
  const double leads = gradient.head(static_cast<Eigen::Index>(n)).cwiseAbs().maxCoeff();
  const double draws = with_draws ? std::abs(gradient[static_cast<Eigen::Index>(n)]) : 0.0;
  const double range = leads + std::max(leads, draws), share = dampingOf(range);
  for (std::size_t i = 0; i < n; ++i) model.strength[i] += share * gradient[static_cast<Eigen::Index>(i)];
  if (with_draws) model.log_draw += share * gradient[static_cast<Eigen::Index>(n)];
  return range;
}

DavidsonFitter::DavidsonFitter(std::vector<int> component)
    : impl_(std::make_unique<Impl>(std::move(component))) {}
DavidsonFitter::~DavidsonFitter() = default;

void DavidsonFitter::fit(std::span<const WeightedMeeting> meetings, std::span<const double> prior,
                         double accuracy, DavidsonModel& model) {
  if (impl_->n == 0) return;
  const bool with_draws =
      std::any_of(meetings.begin(), meetings.end(), [](const WeightedMeeting& m) { return m.draws > 0.0; });
  // Newton's method converges quadratically: near the maximum, the error after a step is about the step
  // squared.
  const double last = std::sqrt(accuracy);
  for (int i = 0; i < kMostSteps; ++i) {
    impl_->derive(meetings, prior, model, with_draws);
    if (impl_->step(model, with_draws) < last) return;
  }
}

}  // namespace fulbito
