#include "bt_core/live/pictures/picture_set.h"

#include <utility>

namespace coppice {
namespace {

// In the type of the sum, of which no part can be too large for it.
std::uint64_t PixelsOf(const LivePicture& picture) {
  return std::uint64_t{picture.width} * picture.height;
}

Outcome Check(const LivePicture& picture) {
  if (picture.name.empty() || picture.name.size() > PictureSet::kLongestName) {
    return Problem{"the name of a picture has 1 to " + std::to_string(PictureSet::kLongestName) +
                   " bytes, this one " + std::to_string(picture.name.size())};
  }
  const std::string which = "picture \"" + picture.name + "\": ";
  if (picture.text.size() > PictureSet::kLongestText) {
    return Problem{which + "its text has " + std::to_string(picture.text.size()) +
                   " bytes, the most is " + std::to_string(PictureSet::kLongestText)};
  }
  const std::uint64_t pixels = PixelsOf(picture);
  if (pixels == 0 || pixels > PictureSet::kMostPixels) {
    return Problem{which + "expected 1 to " + std::to_string(PictureSet::kMostPixels) +
                   " pixels, it has " + std::to_string(picture.width) + " x " +
                   std::to_string(picture.height)};
  }
  if (picture.rgb.size() != 3 * pixels) {
    return Problem{which + "expected " + std::to_string(3 * pixels) + " bytes of colour for " +
                   std::to_string(picture.width) + " x " + std::to_string(picture.height) +
                   " pixels, it has " + std::to_string(picture.rgb.size())};
  }
  return {};
}

}  // namespace

bool LivePicture::operator==(const LivePicture& other) const {
  return name == other.name && text == other.text && width == other.width &&
         height == other.height && rgb == other.rgb;
}

Outcome PictureSet::Put(LivePicture picture) {
  if (Outcome outcome = Check(picture); !outcome) return outcome;
  std::uint64_t pixels = PixelsOf(picture);
  std::size_t count = 1;
  for (const auto& [name, other] : pictures_) {
    if (name == picture.name) continue;
    pixels += PixelsOf(other);
    ++count;
  }
  if (count > kMostPictures || pixels > kMostPixels) {
    return Problem{"picture \"" + picture.name + "\": with it there would be " +
                   std::to_string(count) + " pictures of " + std::to_string(pixels) +
                   " pixels, at most are " + std::to_string(kMostPictures) + " of " +
                   std::to_string(kMostPixels)};
  }
  std::string name = picture.name;
  pictures_.insert_or_assign(std::move(name), std::move(picture));
  return {};
}

}  // namespace coppice
