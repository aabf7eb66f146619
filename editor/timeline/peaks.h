// The largest of the numbers in any range of a long row, at once: for a line of durations.
#ifndef COPPICE_EDITOR_TIMELINE_PEAKS_H_
#define COPPICE_EDITOR_TIMELINE_PEAKS_H_

#include <cstddef>
#include <vector>

namespace coppice::editor {

class Peaks {
 public:
  void Add(float number);
  /// Replaces the number that was added last by a larger one.
  void RaiseLast(float number);

  /// The largest of the numbers from `first` up to and without `end`, of those that there are; 0 if
  /// there is none.
  float Largest(std::size_t first, std::size_t end) const;

  std::size_t size() const { return levels_.empty() ? 0 : levels_[0].size(); }

 private:
  static constexpr std::size_t kFan = 16;

  std::vector<std::vector<float>> levels_;  // [k][i]: of the numbers i * 16^k and on
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_TIMELINE_PEAKS_H_
