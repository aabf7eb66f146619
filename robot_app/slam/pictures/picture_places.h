// All pictures that were kept, and the question where a new one was taken: words find candidates,
// geometry decides.
//
//   PicturePlaces places(vocabulary);
//   const auto seen = FindFeatures(colour, depth, camera);
//   if (const auto found = places.Find(seen, camera, is_old)) ...   // found->key_frame
//   places.Add(key_frame, std::make_shared<PictureFeatures>(seen));
#ifndef COPPICE_ROBOT_APP_SLAM_PICTURES_PICTURE_PLACES_H_
#define COPPICE_ROBOT_APP_SLAM_PICTURES_PICTURE_PLACES_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "robot_app/slam/pictures/picture_match.h"
#include "robot_app/slam/pictures/place_index.h"

namespace coppice::robot::slam {

struct PicturePlace {
  std::uint32_t key_frame = 0;
  PictureMatch match;
};

struct PicturePlacesSettings {
  std::size_t candidates = 6;  ///< that geometry looks at
  MatchSettings match;
};

/// Not thread-safe. The vocabulary must outlive it. The caller owns the pictures, too.
class PicturePlaces {
 public:
  explicit PicturePlaces(const Vocabulary& vocabulary, PicturePlacesSettings settings = {})
      : vocabulary_(vocabulary), settings_(settings), index_(vocabulary.size()) {}

  /// A key frame may have several pictures. Only those that are added are asked for.
  void Add(std::uint32_t key_frame, std::shared_ptr<const PictureFeatures> picture);

  /// Takes all pictures of a key frame out again.
  void Remove(std::uint32_t key_frame);

  /// The key frame that fits the picture best, sure or not (IsSure), of those that `is_asked` holds
  /// for; no others are looked at once one is clear (IsClear). Nothing: none fits at all. At most
  /// some 30 ms.
  std::optional<PicturePlace> Find(const PictureFeatures& picture, const CameraMount& camera,
                                   const std::function<bool(std::uint32_t)>& is_asked);

  const PicturePlacesSettings& settings() const { return settings_; }

 private:
  const Vocabulary& vocabulary_;
  PicturePlacesSettings settings_;
  PlaceIndex index_;
  // Of each picture; null: taken out, its place is free.
  std::vector<std::shared_ptr<const PictureFeatures>> pictures_;
  std::vector<std::uint32_t> key_frames_;
  std::vector<std::uint32_t> free_;
};

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_PICTURES_PICTURE_PLACES_H_
