#include "robot_app/slam/pictures/picture_places.h"

#include <utility>

namespace coppice::robot::slam {

void PicturePlaces::Add(std::uint32_t key_frame, std::shared_ptr<const PictureFeatures> picture) {
  auto place = static_cast<std::uint32_t>(pictures_.size());
  if (free_.empty()) {
    pictures_.emplace_back();
    key_frames_.emplace_back();
  } else {
    place = free_.back();
    free_.pop_back();
  }
  index_.Add(place, vocabulary_.BagOf(picture->descriptors));
  pictures_[place] = std::move(picture);
  key_frames_[place] = key_frame;
}

void PicturePlaces::Remove(std::uint32_t key_frame) {
  for (std::uint32_t i = 0; i < pictures_.size(); ++i) {
    if (pictures_[i] == nullptr || key_frames_[i] != key_frame) continue;
    index_.Remove(i, vocabulary_.BagOf(pictures_[i]->descriptors));
    pictures_[i].reset();
    free_.push_back(i);
  }
}

std::optional<PicturePlace> PicturePlaces::Find(
    const PictureFeatures& picture, const CameraMount& camera,
    const std::function<bool(std::uint32_t)>& is_asked) {
  const auto candidates = index_.Find(vocabulary_.BagOf(picture.descriptors), settings_.candidates,
                                      [&](std::uint32_t i) { return is_asked(key_frames_[i]); });
  std::optional<PicturePlace> best;
  for (const PlaceCandidate& candidate : candidates) {
    const auto match =
        MatchPictures(*pictures_[candidate.picture], picture, camera, settings_.match);
    if (!match || (best && match->inliers <= best->match.inliers)) continue;
    best = PicturePlace{key_frames_[candidate.picture], *match};
    if (IsClear(*match, settings_.match)) break;
  }
  return best;
}

}  // namespace coppice::robot::slam
