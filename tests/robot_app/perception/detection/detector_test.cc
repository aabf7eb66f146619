#include "robot_app/perception/detection/detector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/model/write_file.h"
#include "robot_app/common/compressed_picture.h"
#include "robot_app/simulation/camera/rgbd_camera.h"
#include "robot_app/simulation/floor_scene.h"
#include "robot_app/simulation/shipped_files.h"
#include "tests/robot_app/perception/detection/drawn_sightings.h"
#include "tests/robot_app/perception/detection/tiny_onnx.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::perception {
namespace {

constexpr double kLensHeight = 1.35;
constexpr double kTall = 1.7;

// In a corridor of the institute: people who stand so far before the camera and look at it.
struct Corridor {
  Corridor() : floor(*simulation::FindFloor(simulation::kInstitute)) {
    scene = simulation::Scene(simulation::MakeStillScene(floor));
  }

  Picture With(double distance, std::uint64_t look) const {
    simulation::SeenPerson person;
    person.look = simulation::RandomPersonLook(look);
    person.stance.height = kTall;
    person.stance.position = {10 + distance, 0.5};
    person.stance.heading = simulation::kPi;
    return simulation::RgbdCamera({}, look).Take(scene, {person}, {10, 0.5, 0}, kLensHeight).colour;
  }
  Picture Empty() const {
    return simulation::RgbdCamera({}, 1).Take(scene, {}, {10, 0.5, 0}, kLensHeight).colour;
  }

  simulation::Floor floor;
  simulation::Scene scene;
};

std::unique_ptr<Detector> Make(const std::string& names) {
  DetectorChoice choice;
  choice.built_in = names;
  choice.mask_file = SourceFolder() + "/robot_app/perception/data/faces_and_masks.yaml";
  auto detector = MakeDetector(choice);
  EXPECT_TRUE(detector) << detector.problem();
  return std::move(*detector);
}

TEST(Detector, FindsMostPeopleAtFourToSixMetresWhereTheyAre) {
  const Corridor corridor;
  const auto detector = Make("people");
  int found = 0;
  for (int i = 0; i < 6; ++i) {
    const double distance = 4 + 0.4 * i;
    const simulation::RgbdOptions camera;
    const double tall = camera.lens.fy * kTall / distance;
    const double feet = camera.lens.cy + camera.lens.fy * kLensHeight / distance;
    const Box truth{camera.lens.cx - 0.15 * tall, feet - tall, 0.3 * tall, tall};
    const auto seen = detector->Find(corridor.With(distance, static_cast<std::uint64_t>(i)));
    found += std::any_of(seen.begin(), seen.end(), [&](const Sighting& sighting) {
      return sighting.kind == SightingKind::kPerson && Overlap(sighting.box, truth) > 0.5;
    });
  }
  EXPECT_GE(found, 4);
}

TEST(Detector, FindsMostFacesAtTwoMetres) {
  const Corridor corridor;
  const auto detector = Make("faces");
  int found = 0;
  for (std::uint64_t i = 0; i < 6; ++i) {
    const auto seen = detector->Find(corridor.With(2, i));
    found += std::any_of(seen.begin(), seen.end(), [](const Sighting& sighting) {
      return sighting.kind == SightingKind::kFace &&
             std::abs(sighting.box.x + sighting.box.width / 2 - 326) < 10;
    });
  }
  EXPECT_GE(found, 4);
}

TEST(Detector, FindsNobodyInAnEmptyCorridor) {
  EXPECT_TRUE(Make("people faces")->Find(Corridor().Empty()).empty());
}

// The picture of docs/perception.md: COPPICE_PICTURES=FOLDER writes it.
TEST(Detector, SeesPeopleAndWhoOfThemWearsAMask) {
  const Corridor corridor;
  std::vector<simulation::SeenPerson> people(4);
  const std::array<simulation::Vec2, 4> places = {
      {{12.1, 0.8}, {12.6, -0.8}, {14.3, 0.4}, {16, -0.6}}};
  for (std::size_t i = 0; i < people.size(); ++i) {
    people[i].look = simulation::RandomPersonLook(40 + i);
    people[i].look.wears_mask = i % 2 == 1;
    people[i].stance = {places[i], simulation::kPi + 0.3 * static_cast<double>(i % 3) - 0.3,
                        0.4 * i, i > 1, 1.6 + 0.05 * static_cast<double>(i)};
  }
  simulation::RgbdCamera camera({}, 1);
  const simulation::RgbdPicture taken =
      camera.Take(corridor.scene, people, {10, 0, 0}, kLensHeight);
  const auto seen =
      Make("people masks")->Find({taken.colour, &taken.depth, camera.options().lens.fx});
  const auto count = [&](SightingKind kind) {
    return std::count_if(seen.begin(), seen.end(),
                         [kind](const Sighting& sighting) { return sighting.kind == kind; });
  };
  EXPECT_EQ(count(SightingKind::kFaceWithMask), 2);
  EXPECT_EQ(count(SightingKind::kFaceWithoutMask), 2);
  EXPECT_GE(count(SightingKind::kPerson), 1);
  if (const char* const folder = std::getenv("COPPICE_PICTURES")) {
    const auto jpeg = EncodeJpeg(Drawn(taken.colour, taken.depth, seen), 90);
    std::ofstream(std::string(folder) + "/sightings.jpg", std::ios::binary)
        .write(reinterpret_cast<const char*>(jpeg.data()), static_cast<long>(jpeg.size()));
  }
}

TEST(Detector, TakesPicturesOfAnySizeAndContent) {
  const auto detector = Make("people faces masks");
  std::mt19937 random(1);
  for (const auto& [width, height] : {std::pair{65, 129}, {641, 3}, {25, 25}, {3001, 131}}) {
    Picture picture(width, height);
    for (std::uint8_t& value : picture.rgb) value = static_cast<std::uint8_t>(random());
    for (const Sighting& sighting : detector->Find(picture)) {
      EXPECT_LT(Overlap(sighting.box, {0, 0, double(width), double(height)}), 1.01);
    }
  }
}

TEST(Detector, FindsNothingInPicturesThatAreTooSmall) {
  const auto detector = Make("people faces");
  EXPECT_TRUE(detector->Find(Picture()).empty());
  EXPECT_TRUE(detector->Find(Picture(1, 1)).empty());
  EXPECT_TRUE(detector->Find(Picture(640, 3)).empty());
}

TEST(MakeDetector, NamesTheNearestOfItsDetectors) {
  DetectorChoice choice;
  choice.built_in = "peple";
  const auto detector = MakeDetector(choice);
  ASSERT_FALSE(detector);
  EXPECT_NE(detector.problem().find("did you mean"), std::string::npos) << detector.problem();
  choice.built_in = " ";
  EXPECT_FALSE(MakeDetector(choice));
}

TEST(MakeDetector, SaysWhichPackageHasAMissingCascade) {
  DetectorChoice choice;
  choice.built_in = "faces";
  choice.cascade_file = "/nowhere.xml";
  const auto detector = MakeDetector(choice);
  ASSERT_FALSE(detector);
  EXPECT_NE(detector.problem().find("opencv-data"), std::string::npos) << detector.problem();
}

TEST(MakeDetector, RefusesAFileThatIsNoCascade) {
  DetectorChoice choice;
  choice.built_in = "faces";
  choice.cascade_file = __FILE__;
  EXPECT_FALSE(MakeDetector(choice));
}

TEST(MakeDetector, RefusesACascadeAtWhichOpenCvCrashes) {
  const TemporaryFolder folder;
  std::ifstream stream("/usr/share/opencv4/haarcascades/haarcascade_frontalface_alt2.xml");
  const std::string shipped{std::istreambuf_iterator<char>(stream), {}};
  std::string astray = shipped;  // to nodes and features that there are not
  const std::string nodes = "<internalNodes>";
  for (std::size_t at = 0; (at = astray.find(nodes, at)) != std::string::npos;) {
    at += nodes.size();
    astray.insert(at, "900000 900000 0 0. ");
  }
  std::string nested = "<?xml version=\"1.0\"?>\n<opencv_storage>";
  for (int i = 0; i < 200'000; ++i) nested += "<a>";
  DetectorChoice choice;
  choice.built_in = "faces";
  choice.cascade_file = folder.Path("cascade.xml");
  for (const std::string& cascade : {astray, nested}) {
    Diagnostics diagnostics;
    ASSERT_TRUE(WriteFile(choice.cascade_file, cascade, diagnostics));
    const auto detector = MakeDetector(choice);
    ASSERT_FALSE(detector);
    EXPECT_NE(detector.problem().find("crashed"), std::string::npos) << detector.problem();
  }
}

TEST(MakeDetector, SaysThatMasksNeedAFile) {
  DetectorChoice choice;
  choice.built_in = "masks";
  const auto detector = MakeDetector(choice);
  ASSERT_FALSE(detector);
  EXPECT_NE(detector.problem().find("coppice-train masks"), std::string::npos)
      << detector.problem();
}

// A network that knows people alone.
TEST(MakeDetector, LetsMasksWorkBesideANetworkThatDoesNotKnowThem) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  ASSERT_TRUE(WriteFile(folder.Path("people.onnx"), TinyOnnx(true), diagnostics));
  DetectorChoice choice;
  choice.built_in = "people masks";
  choice.mask_file = SourceFolder() + "/robot_app/perception/data/faces_and_masks.yaml";
  choice.network = {folder.Path("people.onnx"), "", "", kTinySquare};
  const auto both = MakeDetector(choice);
  ASSERT_TRUE(both) << both.problem();
  EXPECT_TRUE((*both)->Finds(SightingKind::kPerson));
  EXPECT_TRUE((*both)->Finds(SightingKind::kFaceWithMask));
}

TEST(MakeDetector, NeedsNoFileForWhatTheNetworkDoes) {
  const TemporaryFolder folder;
  Diagnostics diagnostics;
  ASSERT_TRUE(WriteFile(folder.Path("masks.onnx"), TinyOnnx(true), diagnostics));
  ASSERT_TRUE(WriteFile(folder.Path("names"), "mask\n", diagnostics));
  DetectorChoice choice;
  choice.built_in = "masks";
  choice.network = {folder.Path("masks.onnx"), "", folder.Path("names"), kTinySquare};
  const auto network = MakeDetector(choice);
  EXPECT_TRUE(network) << network.problem();
}

}  // namespace
}  // namespace coppice::robot::perception
