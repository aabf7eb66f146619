#include "robot_app/training/labelled_picture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coppice::robot::training {
namespace {

using perception::Sighting;
using perception::SightingKind;

TEST(LabelledPicture, TheSameSeedGivesTheSamePicture) {
  std::mt19937_64 first(3), second(3);
  const LabelledPicture a = MakeLabelledPicture(first);
  const LabelledPicture b = MakeLabelledPicture(second);
  EXPECT_EQ(a.colour.rgb, b.colour.rgb);
  EXPECT_EQ(a.depth.millimetres, b.depth.millimetres);
  EXPECT_EQ(a.faces.size(), b.faces.size());
}

TEST(LabelledPicture, AFaceIsAsLargeAsItsDepthSays) {
  std::mt19937_64 random(1);
  int faces = 0;
  while (faces < 20) {
    const LabelledPicture picture = MakeLabelledPicture(random);
    for (const Sighting& face : picture.faces) {
      if (face.confidence == 0) continue;
      const int column = static_cast<int>(face.box.x + face.box.width / 2);
      const int row = static_cast<int>(face.box.y + face.box.height / 2);
      const double depth = picture.depth.at(column, std::max(row, 0)) / 1000.0;
      if (depth == 0) continue;  // at an edge of somebody before
      EXPECT_NEAR(face.box.height * depth / picture.focal, 0.23, 0.07);
      ++faces;
    }
  }
}

TEST(LabelledPicture, AboutHalfOfTheFacesHaveAMask) {
  std::mt19937_64 random(2);
  int with = 0, faces = 0;
  for (int i = 0; i < 40; ++i) {
    for (const Sighting& face : MakeLabelledPicture(random).faces) {
      with += face.kind == SightingKind::kFaceWithMask ? 1 : 0;
      ++faces;
    }
  }
  EXPECT_GT(faces, 40);
  EXPECT_NEAR(static_cast<double>(with) / faces, 0.5, 0.2);
}

}  // namespace
}  // namespace coppice::robot::training
