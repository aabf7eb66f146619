#include "robot_app/perception/detection/mask_classifier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "robot_app/perception/detection/face_window.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::perception {
namespace {

std::vector<FaceExample> Examples() {
  std::vector<FaceExample> examples;
  for (int i = 0; i < 20; ++i) {
    const float along = 0.1F * static_cast<float>(i % 10);
    examples.push_back({{along, i < 10 ? 2.0F : -1.0F, 7}, i < 10});
  }
  return examples;
}

MaskClassifier Classifier() {
  return {Plane(kFaceShapes + 1, 0.25F), Plane(kFaceFeatures + 1, -0.5F)};
}

std::string ProblemOf(const std::string& file) {
  const auto classifier = LoadMaskClassifier(file);
  return classifier ? "" : classifier.problem();
}

TEST(LearnPlane, PutsEachKindOnItsSide) {
  const auto plane = LearnPlane(Examples(), 2);
  ASSERT_TRUE(plane) << plane.problem();
  ASSERT_EQ(plane->size(), 3U);
  for (const FaceExample& example : Examples()) {
    EXPECT_EQ(Margin(*plane, {example.features[0], example.features[1]}) > 0, example.is_first);
  }
}

TEST(LearnPlane, KnowsTheSidesWhicheverKindComesFirst) {
  auto examples = Examples();
  std::reverse(examples.begin(), examples.end());
  const auto plane = LearnPlane(examples, 2);
  ASSERT_TRUE(plane) << plane.problem();
  EXPECT_GT(Margin(*plane, {0.5F, 2.0F}), 0);
}

TEST(LearnPlane, NeedsBothKinds) {
  auto examples = Examples();
  examples.resize(5);
  EXPECT_FALSE(LearnPlane(examples, 2));
  EXPECT_FALSE(LearnPlane({}, 2));
}

TEST(MaskClassifier, IsReadAsItWasWritten) {
  const TemporaryFolder folder;
  ASSERT_TRUE(Save(Classifier(), folder.Path("masks.yaml")));
  const auto read = LoadMaskClassifier(folder.Path("masks.yaml"));
  ASSERT_TRUE(read) << read.problem();
  EXPECT_EQ(read->face, Classifier().face);
  EXPECT_EQ(read->mask, Classifier().mask);
}

TEST(MaskClassifier, OfAMissingOrOtherFileIsAProblemThatNamesIt) {
  EXPECT_NE(ProblemOf("/nowhere.yaml").find("/nowhere.yaml"), std::string::npos);
  EXPECT_NE(ProblemOf(SourceFolder() + "/README.md").find("coppice-train masks"),
            std::string::npos);
}

TEST(MaskClassifier, OfAnotherNumberOfWeightsOrNoNumbersIsAProblem) {
  const TemporaryFolder folder;
  MaskClassifier classifier = Classifier();
  classifier.mask.pop_back();
  ASSERT_TRUE(Save(classifier, folder.Path("short.yaml")));
  EXPECT_NE(ProblemOf(folder.Path("short.yaml")), "");
  classifier = Classifier();
  classifier.face[3] = std::numeric_limits<float>::infinity();
  ASSERT_TRUE(Save(classifier, folder.Path("infinite.yaml")));
  EXPECT_NE(ProblemOf(folder.Path("infinite.yaml")), "");
}

}  // namespace
}  // namespace coppice::robot::perception
