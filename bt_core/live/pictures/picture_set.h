// What a robot shows to people, as its watchers see it: a few small pictures with words, each known
// by its name. Its face, a lamp, a display.
//
// All of them together have limits, since whoever sends them may be no friend.
#ifndef COPPICE_BT_CORE_LIVE_PICTURES_PICTURE_SET_H_
#define COPPICE_BT_CORE_LIVE_PICTURES_PICTURE_SET_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"

namespace coppice {

struct LivePicture {
  std::string name;               ///< "face"
  std::string text;               ///< what stands below it: "LISTENING"
  std::uint32_t width = 0;        ///< pixels
  std::uint32_t height = 0;       ///< pixels
  std::vector<std::uint8_t> rgb;  ///< row by row from the top, three bytes for each pixel

  bool operator==(const LivePicture& other) const;
};

/// One thread at a time.
class PictureSet {
 public:
  static constexpr std::size_t kMostPictures = 8;
  static constexpr std::size_t kMostPixels = 4096;  ///< of all together
  static constexpr std::size_t kLongestName = 64;   ///< bytes
  static constexpr std::size_t kLongestText = 256;  ///< bytes

  /// In the place of the one of that name. What is no picture, or too much beside the others, is
  /// refused and changes nothing.
  Outcome Put(LivePicture picture);

  /// By name.
  const std::map<std::string, LivePicture>& all() const { return pictures_; }
  bool empty() const { return pictures_.empty(); }
  void Clear() { pictures_.clear(); }

 private:
  std::map<std::string, LivePicture> pictures_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_PICTURES_PICTURE_SET_H_
