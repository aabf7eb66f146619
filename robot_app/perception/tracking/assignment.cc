#include "robot_app/perception/tracking/assignment.h"

#include <algorithm>
#include <limits>

namespace coppice::robot::perception {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A square problem: row i gets column result[i]. Columns and rows count from 1; 0 is "none yet".
std::vector<int> AssignAll(const Eigen::MatrixXd& costs) {
  const int n = static_cast<int>(costs.rows());
  std::vector<double> of_row(n + 1, 0), of_column(n + 1, 0);  // the dual variables
  std::vector<int> row_at(n + 1, 0), before(n + 1, 0);
  for (int row = 1; row <= n; ++row) {
    std::vector<double> least(n + 1, kInfinity);
    std::vector<bool> is_done(n + 1, false);
    int column = 0;
    row_at[0] = row;
    while (row_at[column] != 0) {
      is_done[column] = true;
      const int here = row_at[column];
      double step = kInfinity;
      int nearest = 0;
      for (int next = 1; next <= n; ++next) {
        if (is_done[next]) continue;
        const double reduced = costs(here - 1, next - 1) - of_row[here] - of_column[next];
        if (reduced < least[next]) {
          least[next] = reduced;
          before[next] = column;
        }
        if (least[next] < step) {
          step = least[next];
          nearest = next;
        }
      }
      for (int done = 0; done <= n; ++done) {
        if (is_done[done]) {
          of_row[row_at[done]] += step;
          of_column[done] -= step;
        } else {
          least[done] -= step;
        }
      }
      column = nearest;
    }
    for (; column != 0; column = before[column]) row_at[column] = row_at[before[column]];
  }
  std::vector<int> result(n, -1);
  for (int column = 1; column <= n; ++column) result[row_at[column] - 1] = column - 1;
  return result;
}

}  // namespace

std::vector<int> Assign(const Eigen::MatrixXd& costs, double too_much) {
  const int rows = static_cast<int>(costs.rows());
  const int columns = static_cast<int>(costs.cols());
  const int n = std::max(rows, columns);
  if (n == 0 || columns == 0) return std::vector<int>(rows, -1);
  // A pair that must not be costs more than all others together, so it is made only where there is
  // no other; so does the place of who gets nobody.
  const double forbidden = (std::abs(too_much) + 1) * (n + 1);
  Eigen::MatrixXd square = Eigen::MatrixXd::Constant(n, n, forbidden);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      if (costs(row, column) < too_much) square(row, column) = costs(row, column);
    }
  }
  std::vector<int> result = AssignAll(square);
  result.resize(rows);
  for (int row = 0; row < rows; ++row) {
    if (result[row] >= columns || !(costs(row, result[row]) < too_much)) result[row] = -1;
  }
  return result;
}

}  // namespace coppice::robot::perception
