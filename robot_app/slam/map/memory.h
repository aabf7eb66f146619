// Which key frames are asked for places: a working memory of bounded size, so that an update takes
// no longer in a large map than in a small one. The rest is in the long-term memory, and comes back
// when the robot is recognized, or believes itself, beside it.
//
// Of the place that most is known of, what was not of use for the longest time is put away. So
// something of each place stays as long as there is room for one key frame of each: a session may
// begin anywhere, and is recognized.
//
// M. Labbe, F. Michaud: Appearance-Based Loop Closure Detection for Online Large-Scale and
// Long-Term Operation, IEEE T-RO 29 (2013).
#ifndef COPPICE_ROBOT_APP_SLAM_MAP_MEMORY_H_
#define COPPICE_ROBOT_APP_SLAM_MAP_MEMORY_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace coppice::robot::slam {

/// What has to be done with the places after a change.
struct MemoryChange {
  std::vector<std::uint32_t> retrieved;
  std::vector<std::uint32_t> forgotten;  ///< for now: they are in the long-term memory
};

/// Not thread-safe.
class Memory {
 public:
  explicit Memory(std::size_t most) : most_(most) {}

  /// The next key frame, which is in use.
  void Add();

  /// These are of use now: the first ones that are in the long-term memory are retrieved, as long
  /// as fewer than `enough` of them are working, at most so many at once; others make room.
  /// `place_of` says at which place a key frame was taken.
  MemoryChange Use(const std::vector<std::uint32_t>& key_frames, std::size_t enough,
                   std::size_t most_retrieved,
                   const std::function<std::uint64_t(std::uint32_t)>& place_of);

  /// A key frame of the long-term memory that could not be read.
  void PutBack(std::uint32_t key_frame);

  bool IsWorking(std::uint32_t key_frame) const { return is_working_[key_frame]; }
  std::size_t working() const { return working_; }
  std::size_t size() const { return used_.size(); }

 private:
  std::uint32_t Spare(const std::function<std::uint64_t(std::uint32_t)>& place_of) const;

  std::size_t most_;
  std::size_t working_ = 0;
  std::uint64_t now_ = 0;
  // Of each key frame.
  std::vector<std::uint64_t> used_;
  std::vector<bool> is_working_;
};

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_MAP_MEMORY_H_
