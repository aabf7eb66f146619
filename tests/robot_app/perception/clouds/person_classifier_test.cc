#include "robot_app/perception/clouds/person_classifier.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::perception {
namespace {

// People are what has a large third number; the others say nothing.
std::vector<PersonClassifier::Example> Examples() {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> any(0, 1);
  std::vector<PersonClassifier::Example> examples(400);
  for (auto& example : examples) {
    for (float& value : example.features) value = any(random);
    example.is_one = example.features[2] > 0.6F;
  }
  return examples;
}

Features With(float third) {
  Features features{};
  features.fill(0.5F);
  features[2] = third;
  return features;
}

Expected<PersonClassifier> LoadText(const std::string& text) {
  const TemporaryFolder folder;
  const std::string file = folder.Path("classifier.yaml");
  std::ofstream(file) << text;
  return PersonClassifier::Load(file);
}

TEST(PersonClassifier, LearnsWhatMakesAPerson) {
  const auto classifier = PersonClassifier::Train(Examples(), {20, 2});
  ASSERT_TRUE(classifier) << classifier.problem();
  EXPECT_GT(classifier->Probability(With(0.9F)), 0.9F);
  EXPECT_LT(classifier->Probability(With(0.1F)), 0.1F);
}

TEST(PersonClassifier, SaysTheSameAfterItWasSavedAndLoaded) {
  const TemporaryFolder folder;
  const auto classifier = PersonClassifier::Train(Examples(), {20, 2});
  ASSERT_TRUE(classifier->Save(folder.Path("a.yaml")));
  const auto loaded = PersonClassifier::Load(folder.Path("a.yaml"));
  ASSERT_TRUE(loaded) << loaded.problem();
  for (const float third : {0.1F, 0.55F, 0.62F, 0.9F}) {
    EXPECT_FLOAT_EQ(loaded->Probability(With(third)), classifier->Probability(With(third)));
  }
}

TEST(PersonClassifier, ExamplesOfOneKindTeachNothing) {
  auto examples = Examples();
  for (auto& example : examples) example.is_one = false;
  const auto classifier = PersonClassifier::Train(examples, {20, 2});
  EXPECT_THAT(classifier.problem(), testing::HasSubstr("0 people among 400"));
}

TEST(PersonClassifier, AFileThatIsMissingIsNamed) {
  EXPECT_EQ(PersonClassifier::Load("/nowhere/people.yaml").problem(),
            "/nowhere/people.yaml: cannot be read");
}

TEST(PersonClassifier, AFileThatIsSomethingElseIsAProblem) {
  for (const char* text :
       {"", "what", "%YAML:1.0\n---\nperson_classifier: {features: 3}\n",
        "%YAML:1.0\n---\nperson_classifier: 7\n", "{\"a\": [1, 2}",
        "%YAML:1.0\n---\nperson_classifier:\n   features: 48\n   :\n      - 1\n"}) {
    EXPECT_THAT(LoadText(text).problem(), testing::HasSubstr("coppice-train people")) << text;
  }
}

TEST(PersonClassifier, AFileCutOffAnywhereIsAProblemOrWhole) {
  const std::string whole =
      coppice::ReadFile(SourceFolder() + "/robot_app/perception/data/people_in_clouds.yaml");
  ASSERT_GT(whole.size(), 10000U);
  for (std::size_t part = 0; part < 10; ++part) {
    EXPECT_FALSE(LoadText(whole.substr(0, whole.size() * part / 10))) << part;
  }
}

}  // namespace
}  // namespace coppice::robot::perception
