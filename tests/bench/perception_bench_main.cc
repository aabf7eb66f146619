// How well and how fast people and faces are seen: `./dev bench perception`.
//
//   people in a film that nobody here made   precision, recall, average precision of each detector
//   faces with and without mask              the same, in generated pictures, beside the paper's
//   the time of each detector                for a picture of the robot's camera
//   people in clouds, and following them     what `coppice-train people --measure` prints
//   people by their legs in planar scans     the same of `coppice-train legs --measure`
#include <chrono>
#include <cstdio>
#include <exception>
#include <opencv2/imgproc.hpp>
#include <random>
#include <string>
#include <utility>

#include "bt_core/base/command_line.h"
#include "robot_app/perception/detection/mask_detector.h"
#include "robot_app/perception/detection/picture_view.h"
#include "robot_app/simulation/shipped_files.h"
#include "robot_app/training/detection_figures.h"
#include "robot_app/training/labelled_picture.h"
#include "robot_app/training/leg_training.h"
#include "robot_app/training/mask_training.h"
#include "robot_app/training/people_training.h"
#include "robot_app/training/tracking_figures.h"
#include "tests/robot_app/perception/detection/labelled_film.h"
#include "tests/support/folders.h"

namespace coppice::robot::training {
namespace {

using perception::Detector;
using perception::DetectorChoice;
using perception::LabelledFrame;
using perception::Sighting;
using perception::SightingKind;

constexpr std::uint64_t kSeed = 1000001;  // nothing was learnt from it
constexpr double kLeast = 0.5;            // confidence

const Command kBench{
    "coppice_perception_bench",
    "how well and how fast people and faces are seen",
    {"", 0, 0},
    "The film is that of Debian's package opencv-doc.",
    {CommandOption::Text("--network", "FILE", "measure it too: .weights of Darknet or .onnx"),
     CommandOption::Text("--network-config", "FILE", "the .cfg of Darknet's .weights"),
     CommandOption::Text("--network-classes", "FILE", "a name a line; else COCO's"),
     CommandOption::Whole("--network-size", "N", 32, 4096, "of its square of pixels"),
     CommandOption::Whole("--pictures", "N", 1, 100000, "generated ones; else 100"),
     CommandOption::Whole("--scans", "N", 1, 100000,
                          "of the 3-D lidar and of the laser; else 300")}};

using Clock = std::chrono::steady_clock;

double Since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::string DataFile(const char* name) {
  return SourceFolder() + "/robot_app/perception/data/" + name;
}

template <typename T>
T OrThrow(Expected<T> made) {
  if (!made) throw std::runtime_error(made.problem());
  return std::move(*made);
}

std::unique_ptr<Detector> BuiltIn(const char* name) {
  DetectorChoice choice;
  choice.built_in = name;
  choice.mask_file = DataFile("faces_and_masks.yaml");
  choice.least_confidence = 0;  // for the whole curve of precision and recall
  return OrThrow(MakeDetector(choice));
}

std::unique_ptr<Detector> Network(const Options& options) {
  DetectorChoice choice;
  choice.built_in = "";
  choice.network = {options.Get("--network"), options.Get("--network-config"),
                    options.Get("--network-classes"),
                    static_cast<int>(options.Whole("--network-size", 0))};
  choice.least_confidence = 0.05;
  return OrThrow(MakeDetector(choice));
}

// --- people in the film ---

Picture Larger(const Picture& picture, int zoom) {
  Picture larger(zoom * picture.width, zoom * picture.height);
  cv::Mat pixels(larger.height, larger.width, CV_8UC3, larger.rgb.data());
  cv::resize(perception::View(picture), pixels, pixels.size(), 0, 0, cv::INTER_CUBIC);
  return larger;
}

std::vector<Sighting> PeopleIn(Detector& detector, const Picture& picture, int zoom) {
  std::vector<Sighting> people;
  for (Sighting sighting : detector.Find(zoom > 1 ? Larger(picture, zoom) : picture)) {
    if (sighting.kind != SightingKind::kPerson) continue;
    sighting.box = {sighting.box.x / zoom, sighting.box.y / zoom, sighting.box.width / zoom,
                    sighting.box.height / zoom};
    people.push_back(sighting);
  }
  return people;
}

bool MeasureInFilm(const char* name, Detector& detector, int zoom) {
  DetectionFigures figures;
  int frames = 0;
  double seconds = 0;
  const bool is_there = perception::ShowFilm(1, [&](const LabelledFrame& frame) {
    const auto begin = Clock::now();
    const auto people = PeopleIn(detector, frame.picture, zoom);
    seconds += Since(begin);
    figures.Add(frame.people, people);
    ++frames;
  });
  if (!is_there) return false;
  std::printf("| %s | %.1f %% | %.1f %% of %d | %.1f %% | %.0f ms |\n", name,
              100 * figures.precision(kLeast), 100 * figures.recall(kLeast), figures.there(),
              100 * figures.average_precision(), 1e3 * seconds / frames);
  std::fflush(stdout);
  return true;
}

void MeasureFilm(Detector* network) {
  std::printf(
      "People in 60 frames of vtest.avi, boxes with half in common\n\n"
      "| detector | precision | recall | average precision | a picture |\n"
      "|---|---|---|---|---|\n");
  const auto people = BuiltIn("people");
  const bool is_there = MeasureInFilm("people", *people, 1) &&
                        MeasureInFilm("people, twice as large", *people, 2) &&
                        (network == nullptr || MeasureInFilm("network", *network, 1));
  if (!is_there) std::printf("\n%s is missing: Debian's package opencv-doc\n", perception::kFilm);
}

// --- faces ---

void MeasureFaces(const char* name, Detector& detector, int pictures, bool with_depth) {
  const MaskFigures figures = MeasureMasks(detector, pictures, kSeed, with_depth);
  std::printf("\nFaces in generated pictures: %s\n\n%s", name, Table(figures).c_str());
  std::fflush(stdout);
}

void MeasureTime(const char* name, Detector& detector, bool with_depth) {
  constexpr int kPictures = 20;
  std::mt19937_64 random(kSeed);
  double seconds = 0;
  for (int i = 0; i < kPictures; ++i) {
    const LabelledPicture picture = MakeLabelledPicture(random);
    const auto begin = Clock::now();
    detector.Find({picture.colour, with_depth ? &picture.depth : nullptr, picture.focal});
    seconds += Since(begin);
  }
  std::printf("| %s | %.0f ms |\n", name, 1e3 * seconds / kPictures);
  std::fflush(stdout);
}

void MeasureTimes(Detector* network) {
  std::printf("\nA picture of 640 x 480 pixels\n\n| detector | time |\n|---|---|\n");
  MeasureTime("people", *BuiltIn("people"), false);
  MeasureTime("faces", *BuiltIn("faces"), false);
  MeasureTime("masks", *BuiltIn("masks"), false);
  MeasureTime("masks, with depth", *BuiltIn("masks"), true);
  if (network != nullptr) MeasureTime("network", *network, false);
}

// --- people in clouds ---

void MeasureClouds(int scans) {
  perception::PeopleFinder finder(
      {}, OrThrow(perception::PersonClassifier::Load(DataFile("people_in_clouds.yaml"))));
  const auto floor = OrThrow(simulation::FindFloor(simulation::kInstitute));
  std::printf("\nPeople in clouds\n\n%s",
              Table(MeasurePeople(finder, SiteOf(floor), scans, kSeed)).c_str());
  std::fflush(stdout);
  TrackingScenario scenario;
  scenario.seed = kSeed;
  std::printf("\nTen people for a minute: %s",
              Summary(MeasureTracking({&finder, nullptr, nullptr}, scenario)).c_str());
}

// --- legs in scans ---

void MeasureScans(int scans) {
  perception::LegFinder finder(
      {}, OrThrow(perception::LegClassifier::Load(DataFile("legs_in_scans.yaml"))));
  const auto floor = OrThrow(simulation::FindFloor(simulation::kInstitute));
  std::printf("\nPeople by their legs in scans of the planar laser\n\n%s",
              Table(MeasureLegs(finder, SiteOf(floor), scans, 0, kSeed)).c_str());
  TrackingScenario scenario;
  scenario.seed = kSeed;
  std::printf("\nTen people for a minute, lidar and cameras dead: %s",
              Summary(MeasureTracking({nullptr, nullptr, &finder}, scenario)).c_str());
}

void Run(const Options& options) {
  std::unique_ptr<Detector> network;
  if (options.Has("--network")) network = Network(options);
  const auto pictures = static_cast<int>(options.Whole("--pictures", 100));
  MeasureFilm(network.get());
  MeasureFaces("masks, with depth", *BuiltIn("masks"), pictures, true);
  MeasureFaces("masks, colour alone", *BuiltIn("masks"), pictures, false);
  if (network != nullptr && network->Finds(SightingKind::kFaceWithMask)) {
    MeasureFaces("network", *network, pictures, false);
  }
  MeasureTimes(network.get());
  MeasureClouds(static_cast<int>(options.Whole("--scans", 300)));
  MeasureScans(static_cast<int>(options.Whole("--scans", 300)));
}

int Main(const std::vector<std::string>& arguments) {
  const Options options = ParseOptions(kBench, arguments);
  if (options.exit) return *options.exit;
  try {
    Run(options);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "coppice_perception_bench: %s\n", error.what());
    return 1;
  }
}

}  // namespace
}  // namespace coppice::robot::training

int main(int argc, char** argv) { return coppice::robot::training::Main({argv + 1, argv + argc}); }
