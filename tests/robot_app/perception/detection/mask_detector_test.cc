#include "robot_app/perception/detection/mask_detector.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>

#include "robot_app/training/labelled_picture.h"
#include "tests/support/folders.h"

namespace coppice::robot::perception {
namespace {

using training::LabelledPicture;

std::unique_ptr<Detector> Shipped() {
  auto classifier =
      LoadMaskClassifier(SourceFolder() + "/robot_app/perception/data/faces_and_masks.yaml");
  EXPECT_TRUE(classifier) << classifier.problem();
  return MakeMaskDetector(std::move(*classifier));
}

// With somebody in it whom the detector finds.
LabelledPicture PictureWithAFace() {
  std::mt19937_64 random(4);
  for (;;) {
    LabelledPicture picture = training::MakeLabelledPicture(random);
    if (picture.faces.size() == 1 && picture.faces[0].confidence > 0 &&
        !Shipped()->Find(picture.colour).empty()) {
      return picture;
    }
  }
}

TEST(MaskDetector, FindsAFaceWhereItIsAndKnowsWhetherItHasAMask) {
  const LabelledPicture picture = PictureWithAFace();
  const auto seen = Shipped()->Find({picture.colour, &picture.depth, picture.focal});
  ASSERT_FALSE(seen.empty());
  EXPECT_EQ(seen[0].kind, picture.faces[0].kind);
  EXPECT_GT(Overlap(seen[0].box, picture.faces[0].box), 0.5);
  EXPECT_GT(seen[0].confidence, 0.5);
}

TEST(MaskDetector, SeesNoHeadWhereTheDepthSaysItWouldBeAGiants) {
  LabelledPicture picture = PictureWithAFace();
  for (std::uint16_t& depth : picture.depth.millimetres) depth = depth > 0 ? 30000 : 0;
  EXPECT_TRUE(Shipped()->Find({picture.colour, &picture.depth, picture.focal}).empty());
}

TEST(MaskDetector, LooksAtTheColourAloneIfTheDepthIsOfAnotherPicture) {
  const LabelledPicture picture = PictureWithAFace();
  const DepthPicture other(20, 10);
  EXPECT_EQ(Shipped()->Find({picture.colour, &other, picture.focal}).size(),
            Shipped()->Find(picture.colour).size());
}

TEST(MaskDetector, TakesPicturesOfAnySize) {
  const auto detector = Shipped();
  std::mt19937 random(3);
  for (const auto& [width, height] :
       {std::pair{0, 0}, {1, 1}, {40, 48}, {41, 49}, {39, 500}, {3, 640}, {4001, 53}, {61, 3000}}) {
    Picture picture(width, height);
    for (std::uint8_t& value : picture.rgb) value = static_cast<std::uint8_t>(random());
    DepthPicture depth(width, height);
    for (std::uint16_t& value : depth.millimetres) value = static_cast<std::uint16_t>(random());
    for (const Sighting& sighting : detector->Find(picture)) {
      EXPECT_GE(sighting.box.right(), 0) << width << " x " << height;
    }
    detector->Find({picture, &depth, 600});
    detector->Find({picture, &depth, 1e-300});
  }
}

}  // namespace
}  // namespace coppice::robot::perception
