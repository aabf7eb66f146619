// What a robot shows to people, kept for those who watch it:
//
//   auto pictures = std::make_shared<LivePictures>();
//   LiveOptions options;
//   options.pictures = pictures;             // of one live view, or of several
//   LivePublisher live(stream, options);
//   pictures->Show({"face", "SAD", 64, 32, rgb});
#ifndef COPPICE_BT_CORE_LIVE_PICTURES_LIVE_PICTURES_H_
#define COPPICE_BT_CORE_LIVE_PICTURES_LIVE_PICTURES_H_

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "bt_core/live/pictures/picture_set.h"

namespace coppice {

/// Any thread.
class LivePictures {
 public:
  /// From now on the robot shows this in the place of what it showed by that name. Watchers see it
  /// within a tenth of a second; what did not last as long they may not see. Refused, with the
  /// reason, if it is no picture or too much beside the others (PictureSet).
  Outcome Show(LivePicture picture);

  /// Of the pictures that became others behind change `seen` the one that did so first, and its
  /// change becomes what is seen; none: nothing is new. With 0 they all are.
  std::optional<LivePicture> Next(std::uint64_t& seen) const;

 private:
  mutable std::mutex mutex_;  // for the rest
  PictureSet pictures_;
  std::uint64_t changes_ = 0;
  std::map<std::uint64_t, std::string> last_changes_;  // of each picture, to its name
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_PICTURES_LIVE_PICTURES_H_
