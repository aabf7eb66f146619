#include "robot_app/perception/tracking/assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace coppice::robot::perception {
namespace {

constexpr double kTooMuch = 10;

// The best by trying all ways: as many pairs as possible, then the cheapest.
std::pair<int, double> Best(const Eigen::MatrixXd& costs) {
  const int n = static_cast<int>(std::max(costs.rows(), costs.cols()));
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::pair<int, double> best{0, 0};
  do {
    int pairs = 0;
    double sum = 0;
    for (int row = 0; row < costs.rows(); ++row) {
      if (order[row] >= costs.cols() || costs(row, order[row]) >= kTooMuch) continue;
      ++pairs;
      sum += costs(row, order[row]);
    }
    if (pairs > best.first || (pairs == best.first && sum < best.second)) best = {pairs, sum};
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

TEST(Assign, IsAsGoodAsTryingAllWays) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> cost(0, 15);
  for (int round = 0; round < 400; ++round) {
    Eigen::MatrixXd costs(1 + random() % 5, 1 + random() % 5);
    for (int i = 0; i < costs.size(); ++i) costs.data()[i] = cost(random);
    const std::vector<int> columns = Assign(costs, kTooMuch);
    int pairs = 0;
    double sum = 0;
    for (int row = 0; row < costs.rows(); ++row) {
      if (columns[row] < 0) continue;
      ++pairs;
      sum += costs(row, columns[row]);
    }
    const auto [most, least] = Best(costs);
    EXPECT_EQ(pairs, most);
    EXPECT_NEAR(sum, least, 1e-9);
  }
}

TEST(Assign, GivesNoColumnTwice) {
  const std::vector<int> columns = Assign(Eigen::MatrixXd::Zero(4, 2), kTooMuch);
  EXPECT_EQ(std::count(columns.begin(), columns.end(), -1), 2);
  EXPECT_EQ(std::count(columns.begin(), columns.end(), 0), 1);
  EXPECT_EQ(std::count(columns.begin(), columns.end(), 1), 1);
}

TEST(Assign, NegativeCostsGoFirst) {
  Eigen::MatrixXd costs(2, 2);
  costs << 1, -5, 1, 2;
  EXPECT_EQ(Assign(costs, kTooMuch), (std::vector<int>{1, 0}));
}

TEST(Assign, NothingIsAssignedToNothing) {
  EXPECT_TRUE(Assign(Eigen::MatrixXd(0, 3), kTooMuch).empty());
  EXPECT_EQ(Assign(Eigen::MatrixXd(2, 0), kTooMuch), (std::vector<int>{-1, -1}));
}

}  // namespace
}  // namespace coppice::robot::perception
