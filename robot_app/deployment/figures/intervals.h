// Intervals of counts and shares: how far a figure of one deployment may be from that of another by
// chance alone. All exact, two-sided, 95 %.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_FIGURES_INTERVALS_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_FIGURES_INTERVALS_H_

namespace coppice::robot::deployment {

struct Bounds {
  double low = 0;
  double high = 0;
  bool Contains(double value) const { return value >= low && value <= high; }
};

/// Of the mean, when a Poisson variable was `count` (F. Garwood, 1936).
Bounds MeanOfCount(int count);
/// What counts with this mean show in 95 of 100 cases.
Bounds CountsOfMean(double mean);
/// Of a probability, when it happened `count` of `trials` times (C. Clopper, E. Pearson, 1934).
/// 0..1.
Bounds ShareOf(int count, int trials);

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_FIGURES_INTERVALS_H_
