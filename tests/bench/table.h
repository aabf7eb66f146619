// The table that `coppice_bench --counts` prints: what was measured, what it may be, what the peer
// needs.
#ifndef COPPICE_TESTS_BENCH_TABLE_H_
#define COPPICE_TESTS_BENCH_TABLE_H_

#include <optional>
#include <string>

namespace coppice::bench {

struct Row {
  std::string name;
  double measured;
  std::string unit;
  std::optional<double> limit;  ///< nothing: for information
  std::optional<double> peer;   ///< BehaviorTree.CPP 4.10, where it was measured
};

class Table {
 public:
  Table();  // prints the head

  /// Prints the row at once, so that a long table grows before the eyes.
  void Add(const Row& row);

  int rows_above_limit() const { return above_limit_; }

 private:
  int above_limit_ = 0;
};

}  // namespace coppice::bench

#endif  // COPPICE_TESTS_BENCH_TABLE_H_
